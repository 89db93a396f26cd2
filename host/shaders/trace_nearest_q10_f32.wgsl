struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: array<array<u32, 4>>,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_37 {
    member: array<type_26>,
}

struct type_41 {
    member: array<array<type_25, 8>>,
}

struct type_47 {
    member: array<vec4<u32>, 2>,
}

struct type_52 {
    member: type_29,
    member_1: u32,
}

struct type_53 {
    member: array<vec4<f32>, 3>,
    member_1: type_52,
    member_2: type_52,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_19;
@group(0) @binding(1) 
var<uniform> global_3: type_47;
@group(0) @binding(2) 
var<storage> global_4: type_9;
@group(0) @binding(4) 
var<storage> global_5: type_37;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_41;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<f32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<u32, 128>;
    var local_9: array<type_25, 8>;
    var local_10: array<f32, 128>;
    var phi_383_: i32;
    var phi_384_: i32;
    var phi_394_: bool;
    var phi_404_: u32;
    var phi_405_: u32;
    var phi_407_: bool;
    var phi_412_: u32;
    var phi_424_: i32;
    var phi_444_: i32;
    var phi_462_: f32;
    var phi_468_: f32;
    var phi_479_: f32;
    var phi_485_: f32;
    var phi_508_: f32;
    var phi_519_: f32;
    var phi_528_: f32;
    var phi_534_: f32;
    var phi_545_: f32;
    var phi_551_: f32;
    var phi_574_: f32;
    var phi_585_: f32;
    var phi_594_: f32;
    var phi_600_: f32;
    var phi_611_: f32;
    var phi_617_: f32;
    var phi_640_: f32;
    var phi_651_: f32;
    var phi_751_: f32;
    var phi_752_: f32;
    var phi_3494_: bool;
    var phi_3422_: f32;
    var phi_894_: type_52;
    var phi_897_: u32;
    var phi_899_: bool;
    var phi_901_: u32;
    var phi_912_: bool;
    var phi_999_: type_52;
    var phi_1000_: bool;
    var phi_1001_: u32;
    var phi_2555_: u32;
    var phi_2556_: u32;
    var phi_2566_: u32;
    var phi_2568_: u32;
    var phi_2569_: bool;
    var phi_2589_: u32;
    var phi_2590_: u32;
    var phi_2594_: type_53;
    var phi_2939_: type_52;
    var phi_3016_: type_52;
    var phi_3017_: type_52;
    var phi_3018_: u32;
    var phi_3020_: type_52;
    var phi_3021_: u32;
    var phi_3022_: bool;
    var phi_3031_: type_52;
    var phi_3036_: type_52;
    var phi_3037_: bool;
    var phi_3491_: bool;
    var phi_3481_: f32;
    var phi_1019_: type_4;
    var phi_1020_: type_4;
    var phi_1043_: type_4;
    var phi_1064_: u32;
    var phi_1153_: array<array<f32, 3>, 3>;
    var phi_1625_: vec3<f32>;
    var phi_1626_: vec3<f32>;
    var phi_1657_: bool;
    var phi_1666_: vec3<f32>;
    var phi_1706_: type_25;
    var phi_1708_: type_25;
    var phi_1709_: bool;
    var phi_1713_: type_25;
    var phi_1714_: type_25;
    var phi_1715_: type_25;
    var phi_1716_: bool;
    var phi_1720_: type_25;
    var phi_1721_: bool;
    var phi_1725_: type_25;
    var phi_1726_: bool;
    var phi_1730_: type_25;
    var phi_1742_: type_4;
    var phi_1745_: type_25;
    var phi_1743_: type_4;
    var phi_1768_: type_4;
    var phi_1800_: bool;
    var phi_1801_: bool;
    var phi_1822_: type_25;
    var phi_1746_: type_25;
    var phi_3482_: bool;
    var phi_3801_: f32;
    var phi_3800_: f32;
    var phi_3599_: bool;
    var phi_3799_: f32;
    var phi_3598_: bool;
    var phi_3798_: f32;
    var phi_3597_: bool;
    var phi_3738_: f32;
    var phi_3596_: bool;
    var phi_3703_: f32;
    var phi_3605_: bool;
    var phi_3039_: type_52;
    var phi_3040_: bool;
    var phi_3041_: u32;
    var phi_3702_: f32;
    var phi_3604_: bool;
    var phi_3042_: type_52;
    var phi_3043_: u32;
    var phi_3044_: bool;
    var phi_3045_: u32;
    var phi_3701_: f32;
    var phi_3603_: bool;
    var phi_3046_: type_52;
    var phi_3047_: u32;
    var phi_3048_: bool;
    var phi_3049_: u32;
    var phi_3700_: f32;
    var phi_3602_: bool;
    var phi_895_: type_52;
    var phi_898_: u32;
    var phi_900_: bool;
    var phi_902_: u32;
    var phi_3050_: bool;
    var phi_3601_: bool;
    var phi_3057_: type_4;
    var phi_3058_: type_4;
    var phi_3081_: type_4;
    var phi_3147_: type_25;
    var phi_3693_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e86 = global;
            let _e88 = arrayLength((&global_4.member));
            let _e90 = arrayLength((&global_2.member));
            let _e98 = global_3.member[0u][0u];
            let _e102 = global_3.member[0u][1u];
            let _e106 = global_3.member[0u][2u];
            let _e110 = global_3.member[0u][3u];
            let _e114 = global_3.member[1u][0u];
            let _e118 = global_3.member[1u][1u];
            let _e122 = global_3.member[1u][2u];
            let _e125 = global_1.member[0u];
            let _e126 = bitcast<i32>(_e125);
            let _e138 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e110) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e98), bitcast<i32>(_e102), bitcast<i32>(_e106));
            local = array<i32, 3>(bitcast<i32>(_e114), bitcast<i32>(_e118), bitcast<i32>(_e122));
            let _e144 = (_e86.x + (_e86.y * 2097152u));
            let _e145 = (_e144 < arrayLength((&global_5.member)));
            if _e145 {
                let _e146 = (_e144 < arrayLength((&global_6.member)));
                if _e146 {
                    if _e145 {
                    } else {
                        break;
                    }
                    let _e154 = global_5.member[_e144].member_2[0u];
                    let _e156 = (bitcast<u32>(_e154) & 2147483647u);
                    let _e161 = global_5.member[_e144].member_2[1u];
                    let _e163 = (bitcast<u32>(_e161) & 2147483647u);
                    let _e168 = global_5.member[_e144].member_2[2u];
                    let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                    let _e175 = global_5.member[_e144].member[0u];
                    let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                    let _e182 = global_5.member[_e144].member[1u];
                    let _e184 = (bitcast<u32>(_e182) & 2147483647u);
                    let _e189 = global_5.member[_e144].member[2u];
                    let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                    let _e193 = select(_e163, _e156, (_e163 < _e156));
                    let _e195 = select(_e170, _e193, (_e170 < _e193));
                    let _e197 = select(_e177, _e195, (_e177 < _e195));
                    let _e199 = select(_e184, _e197, (_e184 < _e197));
                    let _e201 = select(_e191, _e199, (_e191 < _e199));
                    let _e205 = global_5.member[_e144].member_1;
                    let _e207 = (bitcast<u32>(_e205) & 2147483647u);
                    let _e214 = global_5.member[_e144].member_3;
                    let _e220 = (((select(_e207, _e201, (_e207 < _e201)) < 2139095040u) && ((bitcast<u32>(_e214) & 2147483647u) <= 2139095040u)) && (_e195 > 0u));
                    if _e220 {
                        let _e223 = (bitcast<u32>(bitcast<f32>(_e195)) & 2147483647u);
                        if (_e223 >= 8388608u) {
                            phi_383_ = (bitcast<i32>((_e223 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_383_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e223)), 32u, (_e223 == 0u))));
                        }
                        let _e237 = phi_383_;
                        phi_384_ = _e237;
                    } else {
                        phi_384_ = 0i;
                    }
                    let _e239 = phi_384_;
                    let _e240 = (_e156 == _e195);
                    if _e240 {
                        phi_394_ = true;
                    } else {
                        phi_394_ = (_e163 == _e195);
                    }
                    let _e243 = phi_394_;
                    let _e244 = select(1u, 0u, _e240);
                    if _e243 {
                        let _e245 = (_e244 + 1u);
                        phi_404_ = _e245;
                        phi_405_ = _e245;
                        phi_407_ = select(true, false, (_e245 == 2u));
                    } else {
                        phi_404_ = u32();
                        phi_405_ = 0u;
                        phi_407_ = true;
                    }
                    let _e249 = phi_404_;
                    let _e251 = phi_405_;
                    let _e253 = phi_407_;
                    if _e253 {
                        phi_412_ = (_e251 + 1u);
                    } else {
                        phi_412_ = 0u;
                    }
                    let _e257 = phi_412_;
                    let _e258 = select(_e249, _e251, _e253);
                    let _e259 = select(_e244, select(2u, _e244, _e243), _e253);
                    if (_e126 < -126i) {
                        phi_424_ = -126i;
                    } else {
                        phi_424_ = select(_e126, 127i, (_e126 > 127i));
                    }
                    let _e264 = phi_424_;
                    let _e269 = bitcast<f32>((bitcast<u32>((_e264 + 127i)) << bitcast<u32>(23i)));
                    let _e275 = bitcast<f32>((bitcast<u32>(((_e126 - _e264) + 127i)) << bitcast<u32>(23i)));
                    let _e276 = -(_e239);
                    if (_e276 < -126i) {
                        phi_444_ = -126i;
                    } else {
                        phi_444_ = select(_e276, 127i, (_e276 > 127i));
                    }
                    let _e281 = phi_444_;
                    let _e286 = bitcast<f32>((bitcast<u32>((_e281 + 127i)) << bitcast<u32>(23i)));
                    let _e292 = bitcast<f32>((bitcast<u32>(((_e276 - _e281) + 127i)) << bitcast<u32>(23i)));
                    let _e296 = global_5.member[_e144].member;
                    let _e297 = (_e258 == 0u);
                    if _e297 {
                        phi_462_ = _e296[0];
                    } else {
                        phi_462_ = _e296[1];
                    }
                    let _e301 = phi_462_;
                    let _e302 = (_e258 == 2u);
                    if _e302 {
                        phi_468_ = _e296[2];
                    } else {
                        phi_468_ = _e301;
                    }
                    let _e305 = phi_468_;
                    let _e307 = ((_e305 * _e269) * _e275);
                    let _e308 = global_5.member[_e144].member_2;
                    if _e297 {
                        phi_479_ = _e308[0];
                    } else {
                        phi_479_ = _e308[1];
                    }
                    let _e312 = phi_479_;
                    if _e302 {
                        phi_485_ = _e308[2];
                    } else {
                        phi_485_ = _e312;
                    }
                    let _e315 = phi_485_;
                    let _e317 = ((_e315 * _e286) * _e292);
                    let _e321 = (bitcast<f32>((bitcast<u32>(_e317) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e321 {
                        let _e325 = (bitcast<f32>((bitcast<u32>(_e307) & 2147483647u)) * 0.00000011920929f);
                        phi_508_ = select(0.00000000000011368684f, _e325, (_e325 > 0.00000000000011368684f));
                    } else {
                        phi_508_ = 0f;
                    }
                    let _e329 = phi_508_;
                    let _e330 = (_e307 + _e329);
                    let _e331 = (_e307 - _e329);
                    let _e332 = select(_e317, 0f, _e321);
                    if _e321 {
                        phi_519_ = 38685626000000000000000000f;
                    } else {
                        phi_519_ = (1f / _e317);
                    }
                    let _e335 = phi_519_;
                    let _e336 = (_e257 == 0u);
                    if _e336 {
                        phi_528_ = _e296[0];
                    } else {
                        phi_528_ = _e296[1];
                    }
                    let _e340 = phi_528_;
                    let _e341 = (_e257 == 2u);
                    if _e341 {
                        phi_534_ = _e296[2];
                    } else {
                        phi_534_ = _e340;
                    }
                    let _e344 = phi_534_;
                    let _e346 = ((_e344 * _e269) * _e275);
                    if _e336 {
                        phi_545_ = _e308[0];
                    } else {
                        phi_545_ = _e308[1];
                    }
                    let _e350 = phi_545_;
                    if _e341 {
                        phi_551_ = _e308[2];
                    } else {
                        phi_551_ = _e350;
                    }
                    let _e353 = phi_551_;
                    let _e355 = ((_e353 * _e286) * _e292);
                    let _e359 = (bitcast<f32>((bitcast<u32>(_e355) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e359 {
                        let _e363 = (bitcast<f32>((bitcast<u32>(_e346) & 2147483647u)) * 0.00000011920929f);
                        phi_574_ = select(0.00000000000011368684f, _e363, (_e363 > 0.00000000000011368684f));
                    } else {
                        phi_574_ = 0f;
                    }
                    let _e367 = phi_574_;
                    let _e368 = (_e346 + _e367);
                    let _e369 = (_e346 - _e367);
                    let _e370 = select(_e355, 0f, _e359);
                    if _e359 {
                        phi_585_ = 38685626000000000000000000f;
                    } else {
                        phi_585_ = (1f / _e355);
                    }
                    let _e373 = phi_585_;
                    let _e374 = (_e259 == 0u);
                    if _e374 {
                        phi_594_ = _e296[0];
                    } else {
                        phi_594_ = _e296[1];
                    }
                    let _e378 = phi_594_;
                    let _e379 = (_e259 == 2u);
                    if _e379 {
                        phi_600_ = _e296[2];
                    } else {
                        phi_600_ = _e378;
                    }
                    let _e382 = phi_600_;
                    let _e384 = ((_e382 * _e269) * _e275);
                    if _e374 {
                        phi_611_ = _e308[0];
                    } else {
                        phi_611_ = _e308[1];
                    }
                    let _e388 = phi_611_;
                    if _e379 {
                        phi_617_ = _e308[2];
                    } else {
                        phi_617_ = _e388;
                    }
                    let _e391 = phi_617_;
                    let _e393 = ((_e391 * _e286) * _e292);
                    let _e397 = (bitcast<f32>((bitcast<u32>(_e393) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e397 {
                        let _e401 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) * 0.00000011920929f);
                        phi_640_ = select(0.00000000000011368684f, _e401, (_e401 > 0.00000000000011368684f));
                    } else {
                        phi_640_ = 0f;
                    }
                    let _e405 = phi_640_;
                    let _e406 = (_e384 + _e405);
                    let _e407 = (_e384 - _e405);
                    let _e408 = select(_e393, 0f, _e397);
                    if _e397 {
                        phi_651_ = 38685626000000000000000000f;
                    } else {
                        phi_651_ = (1f / _e393);
                    }
                    let _e411 = phi_651_;
                    let _e414 = bitcast<f32>((bitcast<u32>(_e307) & 2147483647u));
                    let _e417 = bitcast<f32>((bitcast<u32>(_e346) & 2147483647u));
                    let _e419 = select(_e417, _e414, (_e414 > _e417));
                    let _e422 = bitcast<f32>((bitcast<u32>(_e384) & 2147483647u));
                    let _e425 = (_e126 + _e239);
                    if (_e220 && (select(_e422, _e419, (_e419 > _e422)) <= 1099511600000f)) {
                        let _e428 = (_e425 / 3i);
                        let _e435 = bitcast<f32>((bitcast<u32>((_e428 + 127i)) << bitcast<u32>(23i)));
                        let _e442 = bitcast<f32>((bitcast<u32>(((_e425 - (2i * _e428)) + 127i)) << bitcast<u32>(23i)));
                        let _e443 = (((_e205 * _e435) * _e435) * _e442);
                        let _e445 = select(340282350000000000000000000000000000000f, _e443, (_e443 < 340282350000000000000000000000000000000f));
                        let _e450 = (((_e214 * _e435) * _e435) * _e442);
                        let _e452 = select(340282350000000000000000000000000000000f, _e450, (_e450 < 340282350000000000000000000000000000000f));
                        phi_751_ = select(-340282350000000000000000000000000000000f, _e452, (_e452 > -340282350000000000000000000000000000000f));
                        phi_752_ = select(-340282350000000000000000000000000000000f, _e445, (_e445 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_751_ = 0f;
                        phi_752_ = 1f;
                    }
                    let _e456 = phi_751_;
                    let _e458 = phi_752_;
                    local_9 = array<type_25, 8>(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e461 = (_e258 % 3u);
                    let _e462 = (_e461 < 3u);
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e464 = local_1[_e461];
                    let _e467 = (_e257 % 3u);
                    let _e468 = (_e467 < 3u);
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e470 = local_1[_e467];
                    let _e473 = (_e259 % 3u);
                    let _e474 = (_e473 < 3u);
                    if _e474 {
                    } else {
                        break;
                    }
                    let _e476 = local_1[_e473];
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e481 = local[_e461];
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e485 = local[_e467];
                    if _e474 {
                    } else {
                        break;
                    }
                    let _e489 = local[_e473];
                    phi_3494_ = false;
                    phi_3422_ = _e456;
                    phi_894_ = type_52(type_29(vec4<f32>((f32(_e464) * _e138), (f32(_e470) * _e138), (f32(_e476) * _e138), 0f), vec4<f32>((f32(_e481) * _e138), (f32(_e485) * _e138), (f32(_e489) * _e138), 0f)), select(0u, 2147483648u, (_e88 == 0u)));
                    phi_897_ = ((3u * _e88) + 1u);
                    phi_899_ = (_e458 <= _e456);
                    phi_901_ = 0u;
                    loop {
                        let _e499 = phi_3494_;
                        let _e501 = phi_3422_;
                        let _e503 = phi_894_;
                        let _e505 = phi_897_;
                        let _e507 = phi_899_;
                        let _e509 = phi_901_;
                        if _e507 {
                            phi_912_ = true;
                        } else {
                            phi_912_ = (_e509 > 0u);
                        }
                        let _e512 = phi_912_;
                        if _e512 {
                            let _e513 = (_e505 > 0u);
                            if _e513 {
                                if _e507 {
                                    phi_999_ = _e503;
                                    phi_1000_ = _e507;
                                    phi_1001_ = _e509;
                                } else {
                                    let _e514 = (_e509 - 1u);
                                    let _e515 = (_e514 % 128u);
                                    let _e516 = (_e515 < 128u);
                                    if _e516 {
                                    } else {
                                        phi_3601_ = true;
                                        break;
                                    }
                                    let _e518 = local_7[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3601_ = true;
                                        break;
                                    }
                                    let _e520 = local_6[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3601_ = true;
                                        break;
                                    }
                                    let _e522 = local_5[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3601_ = true;
                                        break;
                                    }
                                    let _e524 = local_4[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3601_ = true;
                                        break;
                                    }
                                    let _e526 = local_3[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3601_ = true;
                                        break;
                                    }
                                    let _e528 = local_2[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3601_ = true;
                                        break;
                                    }
                                    let _e533 = local_8[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3601_ = true;
                                        break;
                                    }
                                    let _e536 = local_10[_e515];
                                    phi_999_ = type_52(type_29(vec4<f32>(_e518, _e520, _e522, 0f), vec4<f32>(_e524, _e526, _e528, 0f)), _e533);
                                    phi_1000_ = (_e536 <= _e501);
                                    phi_1001_ = _e514;
                                }
                                let _e539 = phi_999_;
                                let _e541 = phi_1000_;
                                let _e543 = phi_1001_;
                                if _e541 {
                                    if ((_e539.member_1 & 2147483648u) != 0u) {
                                        phi_3491_ = _e499;
                                        phi_3481_ = _e501;
                                        phi_1019_ = type_4(0u, ((_e539.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e986 = phi_3491_;
                                            let _e988 = phi_3481_;
                                            let _e990 = phi_1019_;
                                            if (_e990.member < _e990.member_1) {
                                                phi_1020_ = type_4((_e990.member + 1u), _e990.member_1);
                                                phi_1043_ = type_4(1u, _e990.member);
                                            } else {
                                                phi_1020_ = _e990;
                                                phi_1043_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1003 = phi_1020_;
                                            let _e1005 = phi_1043_;
                                            let _e1009 = (bitcast<i32>(_e1005.member) != 0i);
                                            if _e1009 {
                                                let _e1010 = ((_e539.member_1 & 268435455u) + _e1005.member_1);
                                                let _e1011 = (_e1010 < _e90);
                                                if _e1011 {
                                                    if _e1011 {
                                                    } else {
                                                        phi_3738_ = _e988;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1015 = global_2.member[_e1010].member_1;
                                                    phi_1064_ = _e1015;
                                                } else {
                                                    phi_1064_ = 4294967295u;
                                                }
                                                let _e1017 = phi_1064_;
                                                if (_e1010 >= _e90) {
                                                    phi_1153_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1011 {
                                                    } else {
                                                        phi_3738_ = _e988;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    if (_e461 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e988;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1024 = global_2.member[_e1010].member[_e461];
                                                    if (_e467 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e988;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1030 = global_2.member[_e1010].member[_e467];
                                                    if (_e473 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e988;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1036 = global_2.member[_e1010].member[_e473];
                                                    let _e1038 = (3u + _e461);
                                                    if (_e1038 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e988;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1044 = global_2.member[_e1010].member[_e1038];
                                                    let _e1045 = (3u + _e467);
                                                    if (_e1045 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e988;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1051 = global_2.member[_e1010].member[_e1045];
                                                    let _e1052 = (3u + _e473);
                                                    if (_e1052 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e988;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1058 = global_2.member[_e1010].member[_e1052];
                                                    let _e1060 = (6u + _e461);
                                                    if (_e1060 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e988;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1066 = global_2.member[_e1010].member[_e1060];
                                                    let _e1067 = (6u + _e467);
                                                    if (_e1067 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e988;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1073 = global_2.member[_e1010].member[_e1067];
                                                    let _e1074 = (6u + _e473);
                                                    if (_e1074 < 9u) {
                                                    } else {
                                                        phi_3738_ = _e988;
                                                        phi_3596_ = true;
                                                        break;
                                                    }
                                                    let _e1080 = global_2.member[_e1010].member[_e1074];
                                                    phi_1153_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1024, _e1030, _e1036), array<f32, 3>(_e1044, _e1051, _e1058), array<f32, 3>(_e1066, _e1073, _e1080));
                                                }
                                                let _e1084 = phi_1153_;
                                                let _e1091 = (_e1084[0][2] - _e384);
                                                let _e1094 = (((_e1084[0][0] - _e307) * _e408) - (_e1091 * _e332));
                                                let _e1097 = (((_e1084[0][1] - _e346) * _e408) - (_e1091 * _e370));
                                                let _e1104 = (_e1084[1][2] - _e384);
                                                let _e1107 = (((_e1084[1][0] - _e307) * _e408) - (_e1104 * _e332));
                                                let _e1110 = (((_e1084[1][1] - _e346) * _e408) - (_e1104 * _e370));
                                                let _e1117 = (_e1084[2][2] - _e384);
                                                let _e1120 = (((_e1084[2][0] - _e307) * _e408) - (_e1117 * _e332));
                                                let _e1123 = (((_e1084[2][1] - _e346) * _e408) - (_e1117 * _e370));
                                                let _e1124 = (_e1120 * _e1110);
                                                let _e1125 = (_e1123 * _e1107);
                                                let _e1126 = (_e1094 * _e1123);
                                                let _e1127 = (_e1097 * _e1120);
                                                let _e1128 = (_e1107 * _e1097);
                                                let _e1129 = (_e1110 * _e1094);
                                                let _e1134 = (((_e1124 >= _e1125) && (_e1126 >= _e1127)) && (_e1128 >= _e1129));
                                                if (_e1134 || (((_e1124 <= _e1125) && (_e1126 <= _e1127)) && (_e1128 <= _e1129))) {
                                                    let _e1141 = select(-1f, 1f, _e1134);
                                                    let _e1143 = ((_e1124 - _e1125) * _e1141);
                                                    let _e1145 = select(0f, _e1143, (_e1143 > 0f));
                                                    let _e1147 = ((_e1126 - _e1127) * _e1141);
                                                    let _e1149 = select(0f, _e1147, (_e1147 > 0f));
                                                    let _e1151 = ((_e1128 - _e1129) * _e1141);
                                                    let _e1153 = select(0f, _e1151, (_e1151 > 0f));
                                                    let _e1155 = ((_e1145 + _e1149) + _e1153);
                                                    if (_e1155 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1720_ = type_25();
                                                        phi_1721_ = true;
                                                    } else {
                                                        let _e1158 = select(_e1084[1][0], _e1084[0][0], (_e1084[0][0] < _e1084[1][0]));
                                                        let _e1162 = select(_e1084[1][0], _e1084[0][0], (_e1084[0][0] > _e1084[1][0]));
                                                        let _e1166 = select(_e1084[1][1], _e1084[0][1], (_e1084[0][1] < _e1084[1][1]));
                                                        let _e1170 = select(_e1084[1][1], _e1084[0][1], (_e1084[0][1] > _e1084[1][1]));
                                                        let _e1174 = select(_e1084[1][2], _e1084[0][2], (_e1084[0][2] < _e1084[1][2]));
                                                        let _e1178 = select(_e1084[1][2], _e1084[0][2], (_e1084[0][2] > _e1084[1][2]));
                                                        let _e1183 = ((select(_e1084[2][0], _e1158, (_e1158 < _e1084[2][0])) - _e330) * _e335);
                                                        let _e1184 = ((select(_e1084[2][0], _e1162, (_e1162 > _e1084[2][0])) - _e331) * _e335);
                                                        let _e1187 = ((select(_e1084[2][1], _e1166, (_e1166 < _e1084[2][1])) - _e368) * _e373);
                                                        let _e1188 = ((select(_e1084[2][1], _e1170, (_e1170 > _e1084[2][1])) - _e369) * _e373);
                                                        let _e1191 = ((select(_e1084[2][2], _e1174, (_e1174 < _e1084[2][2])) - _e406) * _e411);
                                                        let _e1192 = ((select(_e1084[2][2], _e1178, (_e1178 > _e1084[2][2])) - _e407) * _e411);
                                                        let _e1194 = select(_e1192, _e1191, (_e1191 < _e1192));
                                                        let _e1196 = select(_e1192, _e1191, (_e1191 > _e1192));
                                                        let _e1198 = select(_e1184, _e1183, (_e1183 < _e1184));
                                                        let _e1200 = select(_e1188, _e1187, (_e1187 < _e1188));
                                                        let _e1202 = select(_e1200, _e1198, (_e1198 > _e1200));
                                                        let _e1204 = select(_e1194, _e1202, (_e1202 > _e1194));
                                                        let _e1206 = select(_e1184, _e1183, (_e1183 > _e1184));
                                                        let _e1208 = select(_e1188, _e1187, (_e1187 > _e1188));
                                                        let _e1210 = select(_e1208, _e1206, (_e1206 < _e1208));
                                                        let _e1212 = select(_e1196, _e1210, (_e1210 < _e1196));
                                                        let _e1213 = -(_e1194);
                                                        let _e1219 = select(_e458, _e1204, (_e1204 > _e458));
                                                        if (_e1219 > (_e1212 + (select(_e1213, _e1196, (_e1196 > _e1213)) * 0.0000019073523f))) {
                                                            phi_1715_ = type_25();
                                                            phi_1716_ = true;
                                                        } else {
                                                            let _e1221 = (_e1219 > _e988);
                                                            if _e1221 {
                                                                phi_1714_ = type_25();
                                                            } else {
                                                                let _e1225 = (_e1084[1][0] - _e1084[0][0]);
                                                                let _e1226 = (_e1084[1][1] - _e1084[0][1]);
                                                                let _e1227 = (_e1084[1][2] - _e1084[0][2]);
                                                                let _e1228 = vec3<f32>(_e1225, _e1226, _e1227);
                                                                let _e1229 = (_e1084[2][0] - _e1084[1][0]);
                                                                let _e1230 = (_e1084[2][1] - _e1084[1][1]);
                                                                let _e1231 = (_e1084[2][2] - _e1084[1][2]);
                                                                let _e1232 = vec3<f32>(_e1229, _e1230, _e1231);
                                                                let _e1233 = (_e1084[0][0] - _e1084[2][0]);
                                                                let _e1234 = (_e1084[0][1] - _e1084[2][1]);
                                                                let _e1235 = (_e1084[0][2] - _e1084[2][2]);
                                                                let _e1236 = vec3<f32>(_e1233, _e1234, _e1235);
                                                                let _e1239 = bitcast<f32>((bitcast<u32>(_e1225) & 2147483647u));
                                                                let _e1242 = bitcast<f32>((bitcast<u32>(_e1226) & 2147483647u));
                                                                let _e1244 = select(_e1242, _e1239, (_e1239 > _e1242));
                                                                let _e1247 = bitcast<f32>((bitcast<u32>(_e1227) & 2147483647u));
                                                                let _e1249 = select(_e1247, _e1244, (_e1244 > _e1247));
                                                                let _e1252 = bitcast<f32>((bitcast<u32>(_e1229) & 2147483647u));
                                                                let _e1255 = bitcast<f32>((bitcast<u32>(_e1230) & 2147483647u));
                                                                let _e1257 = select(_e1255, _e1252, (_e1252 > _e1255));
                                                                let _e1260 = bitcast<f32>((bitcast<u32>(_e1231) & 2147483647u));
                                                                let _e1262 = select(_e1260, _e1257, (_e1257 > _e1260));
                                                                let _e1265 = bitcast<f32>((bitcast<u32>(_e1233) & 2147483647u));
                                                                let _e1268 = bitcast<f32>((bitcast<u32>(_e1234) & 2147483647u));
                                                                let _e1270 = select(_e1268, _e1265, (_e1265 > _e1268));
                                                                let _e1273 = bitcast<f32>((bitcast<u32>(_e1235) & 2147483647u));
                                                                let _e1275 = select(_e1273, _e1270, (_e1270 > _e1273));
                                                                let _e1277 = select(_e1262, _e1249, (_e1249 > _e1262));
                                                                let _e1279 = select(_e1275, _e1277, (_e1277 > _e1275));
                                                                if (_e1249 == _e1279) {
                                                                    phi_1625_ = _e1232;
                                                                    phi_1626_ = _e1236;
                                                                } else {
                                                                    let _e1282 = vec3((_e1262 == _e1279));
                                                                    phi_1625_ = select(_e1228, _e1236, _e1282);
                                                                    phi_1626_ = select(_e1232, _e1228, _e1282);
                                                                }
                                                                let _e1286 = phi_1625_;
                                                                let _e1288 = phi_1626_;
                                                                let _e1295 = ((_e1286.y * _e1288.z) - (_e1288.y * _e1286.z));
                                                                let _e1300 = ((_e1286.z * _e1288.x) - (_e1288.z * _e1286.x));
                                                                let _e1303 = ((_e1286.x * _e1288.y) - (_e1288.x * _e1286.y));
                                                                if (_e1145 >= _e1149) {
                                                                    phi_1657_ = select(true, false, (_e1145 >= _e1153));
                                                                } else {
                                                                    phi_1657_ = true;
                                                                }
                                                                let _e1308 = phi_1657_;
                                                                if _e1308 {
                                                                    phi_1666_ = select(vec3<f32>(_e1084[2][0], _e1084[2][1], _e1084[2][2]), vec3<f32>(_e1084[1][0], _e1084[1][1], _e1084[1][2]), vec3((_e1149 >= _e1153)));
                                                                } else {
                                                                    phi_1666_ = vec3<f32>(_e1084[0][0], _e1084[0][1], _e1084[0][2]);
                                                                }
                                                                let _e1313 = phi_1666_;
                                                                let _e1330 = ((((_e1295 * (_e1313.x - _e307)) + (_e1300 * (_e1313.y - _e346))) + (_e1303 * (_e1313.z - _e384))) / (((_e1295 * _e332) + (_e1300 * _e370)) + (_e1303 * _e408)));
                                                                let _e1332 = select(_e1212, _e1330, (_e1330 < _e1212));
                                                                let _e1334 = select(_e1204, _e1332, (_e1332 > _e1204));
                                                                if (_e1334 >= _e458) {
                                                                    let _e1336 = (_e1334 <= _e988);
                                                                    if _e1336 {
                                                                        let _e1337 = (1f / _e1155);
                                                                        phi_1706_ = type_25(_e1334, (_e1149 * _e1337), (_e1153 * _e1337), _e1017);
                                                                    } else {
                                                                        phi_1706_ = type_25();
                                                                    }
                                                                    let _e1342 = phi_1706_;
                                                                    phi_1708_ = _e1342;
                                                                    phi_1709_ = select(true, false, _e1336);
                                                                } else {
                                                                    phi_1708_ = type_25();
                                                                    phi_1709_ = true;
                                                                }
                                                                let _e1345 = phi_1708_;
                                                                let _e1347 = phi_1709_;
                                                                if _e1347 {
                                                                    phi_1713_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1713_ = _e1345;
                                                                }
                                                                let _e1349 = phi_1713_;
                                                                phi_1714_ = _e1349;
                                                            }
                                                            let _e1351 = phi_1714_;
                                                            phi_1715_ = _e1351;
                                                            phi_1716_ = _e1221;
                                                        }
                                                        let _e1353 = phi_1715_;
                                                        let _e1355 = phi_1716_;
                                                        phi_1720_ = _e1353;
                                                        phi_1721_ = _e1355;
                                                    }
                                                    let _e1357 = phi_1720_;
                                                    let _e1359 = phi_1721_;
                                                    phi_1725_ = _e1357;
                                                    phi_1726_ = _e1359;
                                                } else {
                                                    phi_1725_ = type_25();
                                                    phi_1726_ = true;
                                                }
                                                let _e1361 = phi_1725_;
                                                let _e1363 = phi_1726_;
                                                if _e1363 {
                                                    phi_1730_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1730_ = _e1361;
                                                }
                                                let _e1365 = phi_1730_;
                                                if (_e1365.member_3 != 4294967295u) {
                                                    if (_e1017 != 4294967295u) {
                                                        phi_1742_ = type_4(0u, 8u);
                                                        phi_1745_ = _e1365;
                                                        loop {
                                                            let _e1370 = phi_1742_;
                                                            let _e1372 = phi_1745_;
                                                            if (_e1370.member < _e1370.member_1) {
                                                                phi_1743_ = type_4((_e1370.member + 1u), _e1370.member_1);
                                                                phi_1768_ = type_4(1u, _e1370.member);
                                                            } else {
                                                                phi_1743_ = _e1370;
                                                                phi_1768_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1385 = phi_1743_;
                                                            let _e1387 = phi_1768_;
                                                            let _e1391 = (bitcast<i32>(_e1387.member) != 0i);
                                                            if _e1391 {
                                                                let _e1392 = (_e1387.member_1 < 8u);
                                                                if _e1392 {
                                                                } else {
                                                                    phi_3482_ = true;
                                                                    break;
                                                                }
                                                                let _e1397 = local_9[_e1387.member_1].member;
                                                                if (_e1372.member < _e1397) {
                                                                    phi_1801_ = true;
                                                                } else {
                                                                    let _e1399 = local_9[_e1387.member_1].member;
                                                                    if (_e1372.member == _e1399) {
                                                                        let _e1404 = local_9[_e1387.member_1].member_3;
                                                                        phi_1800_ = (_e1372.member_3 < _e1404);
                                                                    } else {
                                                                        phi_1800_ = false;
                                                                    }
                                                                    let _e1407 = phi_1800_;
                                                                    phi_1801_ = _e1407;
                                                                }
                                                                let _e1409 = phi_1801_;
                                                                if _e1409 {
                                                                    if _e1392 {
                                                                    } else {
                                                                        phi_3482_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1410 = local_9[_e1387.member_1];
                                                                    local_9[_e1387.member_1] = type_25(_e1372.member, _e1372.member_1, _e1372.member_2, _e1372.member_3);
                                                                    phi_1822_ = type_25(_e1410.member, _e1410.member_1, _e1410.member_2, _e1410.member_3);
                                                                } else {
                                                                    phi_1822_ = _e1372;
                                                                }
                                                                let _e1421 = phi_1822_;
                                                                phi_1746_ = _e1421;
                                                            } else {
                                                                phi_1746_ = type_25();
                                                            }
                                                            let _e1423 = phi_1746_;
                                                            continue;
                                                            continuing {
                                                                phi_1742_ = _e1385;
                                                                phi_1745_ = _e1423;
                                                                phi_3482_ = _e986;
                                                                break if !(_e1391);
                                                            }
                                                        }
                                                        let _e1426 = phi_3482_;
                                                        phi_3738_ = _e988;
                                                        phi_3596_ = _e1426;
                                                        if _e1426 {
                                                            break;
                                                        }
                                                        let _e1429 = local_9[7u].member_3;
                                                        if (_e1429 != 4294967295u) {
                                                            let _e1433 = local_9[7u].member;
                                                            phi_3801_ = _e1433;
                                                        } else {
                                                            phi_3801_ = _e988;
                                                        }
                                                        let _e1435 = phi_3801_;
                                                        phi_3800_ = _e1435;
                                                        phi_3599_ = _e1426;
                                                    } else {
                                                        phi_3800_ = _e988;
                                                        phi_3599_ = _e986;
                                                    }
                                                    let _e1437 = phi_3800_;
                                                    let _e1439 = phi_3599_;
                                                    phi_3799_ = _e1437;
                                                    phi_3598_ = _e1439;
                                                } else {
                                                    phi_3799_ = _e988;
                                                    phi_3598_ = _e986;
                                                }
                                                let _e1441 = phi_3799_;
                                                let _e1443 = phi_3598_;
                                                phi_3798_ = _e1441;
                                                phi_3597_ = _e1443;
                                            } else {
                                                phi_3798_ = _e988;
                                                phi_3597_ = _e986;
                                            }
                                            let _e1445 = phi_3798_;
                                            let _e1447 = phi_3597_;
                                            continue;
                                            continuing {
                                                phi_3491_ = _e1447;
                                                phi_3481_ = _e1445;
                                                phi_1019_ = _e1003;
                                                phi_3738_ = _e1445;
                                                phi_3596_ = _e1447;
                                                break if !(_e1009);
                                            }
                                        }
                                        let _e1450 = phi_3738_;
                                        let _e1452 = phi_3596_;
                                        phi_3601_ = _e1452;
                                        if _e1452 {
                                            break;
                                        }
                                        phi_3703_ = _e1450;
                                        phi_3605_ = _e1452;
                                        phi_3039_ = _e539;
                                        phi_3040_ = false;
                                        phi_3041_ = _e543;
                                    } else {
                                        if (_e539.member_1 >= _e88) {
                                            phi_2594_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e539.member_1 < _e88) {
                                            } else {
                                                phi_3601_ = true;
                                                break;
                                            }
                                            let _e555 = ((1u + _e258) % 4u);
                                            if (_e555 < 4u) {
                                            } else {
                                                phi_3601_ = true;
                                                break;
                                            }
                                            let _e560 = global_4.member[_e539.member_1][_e555];
                                            let _e562 = (_e560 >> bitcast<u32>(11u));
                                            let _e564 = ((1u + _e257) % 4u);
                                            if (_e564 < 4u) {
                                            } else {
                                                phi_3601_ = true;
                                                break;
                                            }
                                            let _e569 = global_4.member[_e539.member_1][_e564];
                                            let _e571 = (_e569 >> bitcast<u32>(11u));
                                            let _e573 = ((1u + _e259) % 4u);
                                            if (_e573 < 4u) {
                                            } else {
                                                phi_3601_ = true;
                                                break;
                                            }
                                            let _e578 = global_4.member[_e539.member_1][_e573];
                                            let _e580 = (_e578 >> bitcast<u32>(11u));
                                            let _e603 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.x - _e539.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e604 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.y - _e539.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e605 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.z - _e539.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e607 = select(_e138, _e603, (_e603 > _e138));
                                            let _e609 = select(_e138, _e604, (_e604 > _e138));
                                            let _e611 = select(_e138, _e605, (_e605 > _e138));
                                            let _e636 = bitcast<u32>((f32(bitcast<i32>((_e560 & 1023u))) * _e607));
                                            let _e641 = (bitcast<i32>((_e560 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e644 = bitcast<f32>((_e636 & bitcast<u32>(_e641)));
                                            let _e645 = bitcast<u32>((f32(bitcast<i32>((_e569 & 1023u))) * _e609));
                                            let _e650 = (bitcast<i32>((_e569 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e653 = bitcast<f32>((_e645 & bitcast<u32>(_e650)));
                                            let _e654 = bitcast<u32>((f32(bitcast<i32>((_e578 & 1023u))) * _e611));
                                            let _e659 = (bitcast<i32>((_e578 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e662 = bitcast<f32>((_e654 & bitcast<u32>(_e659)));
                                            let _e666 = bitcast<f32>((_e636 & bitcast<u32>(~(_e641))));
                                            let _e670 = bitcast<f32>((_e645 & bitcast<u32>(~(_e650))));
                                            let _e674 = bitcast<f32>((_e654 & bitcast<u32>(~(_e659))));
                                            let _e675 = bitcast<u32>((f32(bitcast<i32>((_e562 & 1023u))) * _e607));
                                            let _e680 = (bitcast<i32>((_e562 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e683 = bitcast<f32>((_e675 & bitcast<u32>(_e680)));
                                            let _e684 = bitcast<u32>((f32(bitcast<i32>((_e571 & 1023u))) * _e609));
                                            let _e689 = (bitcast<i32>((_e571 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e692 = bitcast<f32>((_e684 & bitcast<u32>(_e689)));
                                            let _e693 = bitcast<u32>((f32(bitcast<i32>((_e580 & 1023u))) * _e611));
                                            let _e698 = (bitcast<i32>((_e580 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e701 = bitcast<f32>((_e693 & bitcast<u32>(_e698)));
                                            let _e705 = bitcast<f32>((_e675 & bitcast<u32>(~(_e680))));
                                            let _e709 = bitcast<f32>((_e684 & bitcast<u32>(~(_e689))));
                                            let _e713 = bitcast<f32>((_e693 & bitcast<u32>(~(_e698))));
                                            let _e743 = global_4.member[_e539.member_1][0u];
                                            let _e747 = global_4.member[_e539.member_1][1u];
                                            let _e751 = global_4.member[_e539.member_1][2u];
                                            let _e755 = global_4.member[_e539.member_1][3u];
                                            let _e767 = (((_e747 >> bitcast<u32>(22i)) | ((_e751 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e755 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e768 = (_e743 & 268435455u);
                                            let _e769 = (_e767 & 268435455u);
                                            let _e772 = ((_e743 >> bitcast<u32>(28u)) & 7u);
                                            let _e780 = ((_e743 >> bitcast<u32>(31i)) | (((_e767 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e781 = (_e772 != 0u);
                                            if (_e772 == 0u) {
                                                phi_2556_ = _e768;
                                            } else {
                                                if (_e772 == 7u) {
                                                    phi_2555_ = 2147483648u;
                                                } else {
                                                    phi_2555_ = ((2147483648u | (_e772 << bitcast<u32>(28u))) | (_e769 & 268435455u));
                                                }
                                                let _e790 = phi_2555_;
                                                phi_2556_ = _e790;
                                            }
                                            let _e792 = phi_2556_;
                                            if _e781 {
                                                let _e793 = (_e772 != 7u);
                                                if _e793 {
                                                    phi_2566_ = (_e769 + _e772);
                                                } else {
                                                    phi_2566_ = u32();
                                                }
                                                let _e796 = phi_2566_;
                                                phi_2568_ = _e796;
                                                phi_2569_ = select(true, false, _e793);
                                            } else {
                                                phi_2568_ = u32();
                                                phi_2569_ = true;
                                            }
                                            let _e799 = phi_2568_;
                                            let _e801 = phi_2569_;
                                            if (_e780 == 0u) {
                                                phi_2590_ = (_e768 + select(0u, 1u, !(_e781)));
                                            } else {
                                                if (_e780 == 7u) {
                                                    phi_2589_ = 2147483648u;
                                                } else {
                                                    phi_2589_ = ((2147483648u | (_e780 << bitcast<u32>(28u))) | (select(_e799, _e769, _e801) & 268435455u));
                                                }
                                                let _e814 = phi_2589_;
                                                phi_2590_ = _e814;
                                            }
                                            let _e816 = phi_2590_;
                                            phi_2594_ = type_53(array<vec4<f32>, 3>(vec4<f32>((_e539.member.member.x + _e644), (_e539.member.member.x + _e666), (_e539.member.member_1.x - _e683), (_e539.member.member_1.x - _e705)), vec4<f32>((_e539.member.member.y + _e653), (_e539.member.member.y + _e670), (_e539.member.member_1.y - _e692), (_e539.member.member_1.y - _e709)), vec4<f32>((_e539.member.member.z + _e662), (_e539.member.member.z + _e674), (_e539.member.member_1.z - _e701), (_e539.member.member_1.z - _e713))), type_52(type_29((_e539.member.member + vec4<f32>(_e644, _e653, _e662, 0f)), (_e539.member.member_1 - vec4<f32>(_e683, _e692, _e701, 0f))), _e792), type_52(type_29((_e539.member.member + vec4<f32>(_e666, _e670, _e674, 0f)), (_e539.member.member_1 - vec4<f32>(_e705, _e709, _e713, 0f))), _e816));
                                        }
                                        let _e821 = phi_2594_;
                                        let _e832 = ((_e821.member[0].x - _e330) * _e335);
                                        let _e833 = ((_e821.member[0].y - _e330) * _e335);
                                        let _e834 = ((_e821.member[0].z - _e331) * _e335);
                                        let _e835 = ((_e821.member[0].w - _e331) * _e335);
                                        let _e845 = ((_e821.member[1].x - _e368) * _e373);
                                        let _e846 = ((_e821.member[1].y - _e368) * _e373);
                                        let _e847 = ((_e821.member[1].z - _e369) * _e373);
                                        let _e848 = ((_e821.member[1].w - _e369) * _e373);
                                        let _e858 = ((_e821.member[2].x - _e406) * _e411);
                                        let _e859 = ((_e821.member[2].y - _e406) * _e411);
                                        let _e860 = ((_e821.member[2].z - _e407) * _e411);
                                        let _e861 = ((_e821.member[2].w - _e407) * _e411);
                                        let _e863 = select(_e860, _e858, (_e858 < _e860));
                                        let _e865 = select(_e861, _e859, (_e859 < _e861));
                                        let _e867 = select(_e860, _e858, (_e858 > _e860));
                                        let _e869 = select(_e861, _e859, (_e859 > _e861));
                                        let _e871 = select(_e834, _e832, (_e832 < _e834));
                                        let _e873 = select(_e835, _e833, (_e833 < _e835));
                                        let _e875 = select(_e847, _e845, (_e845 < _e847));
                                        let _e877 = select(_e848, _e846, (_e846 < _e848));
                                        let _e879 = select(_e875, _e871, (_e871 > _e875));
                                        let _e881 = select(_e877, _e873, (_e873 > _e877));
                                        let _e883 = select(_e863, _e879, (_e879 > _e863));
                                        let _e885 = select(_e865, _e881, (_e881 > _e865));
                                        let _e887 = select(_e834, _e832, (_e832 > _e834));
                                        let _e889 = select(_e835, _e833, (_e833 > _e835));
                                        let _e891 = select(_e847, _e845, (_e845 > _e847));
                                        let _e893 = select(_e848, _e846, (_e846 > _e848));
                                        let _e895 = select(_e891, _e887, (_e887 < _e891));
                                        let _e897 = select(_e893, _e889, (_e889 < _e893));
                                        let _e902 = -(_e863);
                                        let _e903 = -(_e865);
                                        let _e910 = (select(_e867, _e895, (_e895 < _e867)) + (select(_e902, _e867, (_e867 > _e902)) * 0.0000019073523f));
                                        let _e911 = (select(_e869, _e897, (_e897 < _e869)) + (select(_e903, _e869, (_e869 > _e903)) * 0.0000019073523f));
                                        let _e913 = select(_e458, _e883, (_e883 > _e458));
                                        let _e915 = select(_e458, _e885, (_e885 > _e458));
                                        let _e920 = (_e913 <= select(_e501, _e910, (_e910 < _e501)));
                                        let _e921 = (_e915 <= select(_e501, _e911, (_e911 < _e501)));
                                        let _e922 = (_e913 <= _e915);
                                        if _e920 {
                                            if _e921 {
                                                if _e922 {
                                                    phi_2939_ = _e821.member_2;
                                                } else {
                                                    phi_2939_ = _e821.member_1;
                                                }
                                                let _e926 = phi_2939_;
                                                let _e948 = (_e543 % 128u);
                                                let _e949 = (_e948 < 128u);
                                                if _e949 {
                                                } else {
                                                    phi_3601_ = true;
                                                    break;
                                                }
                                                local_8[_e948] = _e926.member_1;
                                                if _e949 {
                                                } else {
                                                    phi_3601_ = true;
                                                    break;
                                                }
                                                local_7[_e948] = _e926.member.member.x;
                                                if _e949 {
                                                } else {
                                                    phi_3601_ = true;
                                                    break;
                                                }
                                                local_6[_e948] = _e926.member.member.y;
                                                if _e949 {
                                                } else {
                                                    phi_3601_ = true;
                                                    break;
                                                }
                                                local_5[_e948] = _e926.member.member.z;
                                                if _e949 {
                                                } else {
                                                    phi_3601_ = true;
                                                    break;
                                                }
                                                local_4[_e948] = _e926.member.member_1.x;
                                                if _e949 {
                                                } else {
                                                    phi_3601_ = true;
                                                    break;
                                                }
                                                local_3[_e948] = _e926.member.member_1.y;
                                                if _e949 {
                                                } else {
                                                    phi_3601_ = true;
                                                    break;
                                                }
                                                local_2[_e948] = _e926.member.member_1.z;
                                                if _e949 {
                                                } else {
                                                    phi_3601_ = true;
                                                    break;
                                                }
                                                local_10[_e948] = select(_e915, _e913, (_e913 > _e915));
                                                if _e922 {
                                                    phi_3016_ = _e821.member_1;
                                                } else {
                                                    phi_3016_ = _e821.member_2;
                                                }
                                                let _e962 = phi_3016_;
                                                phi_3017_ = _e962;
                                                phi_3018_ = (_e543 + 1u);
                                            } else {
                                                phi_3017_ = type_52();
                                                phi_3018_ = u32();
                                            }
                                            let _e964 = phi_3017_;
                                            let _e966 = phi_3018_;
                                            phi_3020_ = _e964;
                                            phi_3021_ = _e966;
                                            phi_3022_ = select(true, false, _e921);
                                        } else {
                                            phi_3020_ = type_52();
                                            phi_3021_ = u32();
                                            phi_3022_ = true;
                                        }
                                        let _e969 = phi_3020_;
                                        let _e971 = phi_3021_;
                                        let _e973 = phi_3022_;
                                        if _e973 {
                                            if _e920 {
                                                phi_3031_ = _e821.member_1;
                                            } else {
                                                phi_3031_ = _e821.member_2;
                                            }
                                            let _e977 = phi_3031_;
                                            phi_3036_ = _e977;
                                            phi_3037_ = select(_e921, true, _e920);
                                        } else {
                                            phi_3036_ = _e969;
                                            phi_3037_ = _e541;
                                        }
                                        let _e980 = phi_3036_;
                                        let _e982 = phi_3037_;
                                        phi_3703_ = _e501;
                                        phi_3605_ = _e499;
                                        phi_3039_ = _e980;
                                        phi_3040_ = _e982;
                                        phi_3041_ = select(_e971, _e543, _e973);
                                    }
                                    let _e1454 = phi_3703_;
                                    let _e1456 = phi_3605_;
                                    let _e1458 = phi_3039_;
                                    let _e1460 = phi_3040_;
                                    let _e1462 = phi_3041_;
                                    phi_3702_ = _e1454;
                                    phi_3604_ = _e1456;
                                    phi_3042_ = _e1458;
                                    phi_3043_ = (_e505 - 1u);
                                    phi_3044_ = _e1460;
                                    phi_3045_ = _e1462;
                                } else {
                                    phi_3702_ = _e501;
                                    phi_3604_ = _e499;
                                    phi_3042_ = _e539;
                                    phi_3043_ = _e505;
                                    phi_3044_ = _e541;
                                    phi_3045_ = _e543;
                                }
                                let _e1464 = phi_3702_;
                                let _e1466 = phi_3604_;
                                let _e1468 = phi_3042_;
                                let _e1470 = phi_3043_;
                                let _e1472 = phi_3044_;
                                let _e1474 = phi_3045_;
                                phi_3701_ = _e1464;
                                phi_3603_ = _e1466;
                                phi_3046_ = _e1468;
                                phi_3047_ = _e1470;
                                phi_3048_ = _e1472;
                                phi_3049_ = _e1474;
                            } else {
                                phi_3701_ = _e501;
                                phi_3603_ = _e499;
                                phi_3046_ = type_52();
                                phi_3047_ = u32();
                                phi_3048_ = bool();
                                phi_3049_ = u32();
                            }
                            let _e1476 = phi_3701_;
                            let _e1478 = phi_3603_;
                            let _e1480 = phi_3046_;
                            let _e1482 = phi_3047_;
                            let _e1484 = phi_3048_;
                            let _e1486 = phi_3049_;
                            phi_3700_ = _e1476;
                            phi_3602_ = _e1478;
                            phi_895_ = _e1480;
                            phi_898_ = _e1482;
                            phi_900_ = _e1484;
                            phi_902_ = _e1486;
                            phi_3050_ = _e513;
                        } else {
                            phi_3700_ = _e501;
                            phi_3602_ = _e499;
                            phi_895_ = type_52();
                            phi_898_ = u32();
                            phi_900_ = bool();
                            phi_902_ = u32();
                            phi_3050_ = false;
                        }
                        let _e1488 = phi_3700_;
                        let _e1490 = phi_3602_;
                        let _e1492 = phi_895_;
                        let _e1494 = phi_898_;
                        let _e1496 = phi_900_;
                        let _e1498 = phi_902_;
                        let _e1500 = phi_3050_;
                        continue;
                        continuing {
                            phi_3494_ = _e1490;
                            phi_3422_ = _e1488;
                            phi_894_ = _e1492;
                            phi_897_ = _e1494;
                            phi_899_ = _e1496;
                            phi_901_ = _e1498;
                            phi_3601_ = _e1490;
                            break if !(_e1500);
                        }
                    }
                    let _e1503 = phi_3601_;
                    if _e1503 {
                        break;
                    }
                    phi_3057_ = type_4(0u, 8u);
                    loop {
                        let _e1505 = phi_3057_;
                        if (_e1505.member < _e1505.member_1) {
                            phi_3058_ = type_4((_e1505.member + 1u), _e1505.member_1);
                            phi_3081_ = type_4(1u, _e1505.member);
                        } else {
                            phi_3058_ = _e1505;
                            phi_3081_ = type_4(0u, type_4().member_1);
                        }
                        let _e1518 = phi_3058_;
                        let _e1520 = phi_3081_;
                        let _e1524 = (bitcast<i32>(_e1520.member) != 0i);
                        if _e1524 {
                            let _e1525 = (_e1520.member_1 < 8u);
                            if _e1525 {
                            } else {
                                phi_3693_ = true;
                                break;
                            }
                            let _e1527 = local_9[_e1520.member_1];
                            if (_e1527.member_3 != 4294967295u) {
                                let _e1533 = -(_e425);
                                let _e1534 = (_e1533 / 3i);
                                let _e1541 = bitcast<f32>((bitcast<u32>((_e1534 + 127i)) << bitcast<u32>(23i)));
                                let _e1549 = (((_e1527.member * _e1541) * _e1541) * bitcast<f32>((bitcast<u32>(((_e1533 - (2i * _e1534)) + 127i)) << bitcast<u32>(23i))));
                                let _e1551 = select(340282350000000000000000000000000000000f, _e1549, (_e1549 < 340282350000000000000000000000000000000f));
                                phi_3147_ = type_25(select(-340282350000000000000000000000000000000f, _e1551, (_e1551 > -340282350000000000000000000000000000000f)), _e1527.member_1, _e1527.member_2, _e1527.member_3);
                            } else {
                                phi_3147_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1556 = phi_3147_;
                            if _e1525 {
                            } else {
                                phi_3693_ = true;
                                break;
                            }
                            local_9[_e1520.member_1] = type_25(_e1556.member, _e1556.member_1, _e1556.member_2, _e1556.member_3);
                        }
                        continue;
                        continuing {
                            phi_3057_ = _e1518;
                            phi_3693_ = _e1503;
                            break if !(_e1524);
                        }
                    }
                    let _e1564 = phi_3693_;
                    if _e1564 {
                        break;
                    }
                    let _e1565 = local_9;
                    if _e146 {
                    } else {
                        break;
                    }
                    global_6.member[_e144] = array<type_25, 8>(type_25(_e1565[0].member, _e1565[0].member_1, _e1565[0].member_2, _e1565[0].member_3), type_25(_e1565[1].member, _e1565[1].member_1, _e1565[1].member_2, _e1565[1].member_3), type_25(_e1565[2].member, _e1565[2].member_1, _e1565[2].member_2, _e1565[2].member_3), type_25(_e1565[3].member, _e1565[3].member_1, _e1565[3].member_2, _e1565[3].member_3), type_25(_e1565[4].member, _e1565[4].member_1, _e1565[4].member_2, _e1565[4].member_3), type_25(_e1565[5].member, _e1565[5].member_1, _e1565[5].member_2, _e1565[5].member_3), type_25(_e1565[6].member, _e1565[6].member_1, _e1565[6].member_2, _e1565[6].member_3), type_25(_e1565[7].member, _e1565[7].member_1, _e1565[7].member_2, _e1565[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
