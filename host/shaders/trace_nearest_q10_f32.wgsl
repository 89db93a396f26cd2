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
    var phi_387_: i32;
    var phi_388_: i32;
    var phi_398_: bool;
    var phi_408_: u32;
    var phi_409_: u32;
    var phi_411_: bool;
    var phi_416_: u32;
    var phi_429_: i32;
    var phi_449_: i32;
    var phi_467_: f32;
    var phi_473_: f32;
    var phi_484_: f32;
    var phi_490_: f32;
    var phi_513_: f32;
    var phi_524_: f32;
    var phi_533_: f32;
    var phi_539_: f32;
    var phi_550_: f32;
    var phi_556_: f32;
    var phi_579_: f32;
    var phi_590_: f32;
    var phi_599_: f32;
    var phi_605_: f32;
    var phi_616_: f32;
    var phi_622_: f32;
    var phi_645_: f32;
    var phi_656_: f32;
    var phi_756_: f32;
    var phi_757_: f32;
    var phi_3656_: bool;
    var phi_3569_: f32;
    var phi_899_: type_52;
    var phi_902_: u32;
    var phi_904_: bool;
    var phi_906_: u32;
    var phi_917_: bool;
    var phi_1004_: type_52;
    var phi_1005_: bool;
    var phi_1006_: u32;
    var phi_2702_: u32;
    var phi_2703_: u32;
    var phi_2713_: u32;
    var phi_2715_: u32;
    var phi_2716_: bool;
    var phi_2736_: u32;
    var phi_2737_: u32;
    var phi_2741_: type_53;
    var phi_3086_: type_52;
    var phi_3163_: type_52;
    var phi_3164_: type_52;
    var phi_3165_: u32;
    var phi_3167_: type_52;
    var phi_3168_: u32;
    var phi_3169_: bool;
    var phi_3178_: type_52;
    var phi_3183_: type_52;
    var phi_3184_: bool;
    var phi_3653_: bool;
    var phi_3643_: f32;
    var phi_1024_: type_4;
    var phi_1025_: type_4;
    var phi_1048_: type_4;
    var phi_1069_: u32;
    var phi_1158_: array<array<f32, 3>, 3>;
    var phi_1630_: vec3<f32>;
    var phi_1631_: vec3<f32>;
    var phi_1662_: bool;
    var phi_1671_: vec3<f32>;
    var phi_1711_: type_25;
    var phi_1713_: type_25;
    var phi_1714_: bool;
    var phi_1718_: type_25;
    var phi_1719_: type_25;
    var phi_1720_: type_25;
    var phi_1721_: bool;
    var phi_1725_: type_25;
    var phi_1726_: bool;
    var phi_1730_: type_25;
    var phi_1731_: bool;
    var phi_1735_: type_25;
    var phi_1747_: type_4;
    var phi_1750_: type_25;
    var phi_1748_: type_4;
    var phi_1773_: type_4;
    var phi_1805_: bool;
    var phi_1806_: bool;
    var phi_1827_: type_25;
    var phi_1751_: type_25;
    var phi_3644_: bool;
    var phi_3978_: f32;
    var phi_3977_: f32;
    var phi_3761_: bool;
    var phi_3976_: f32;
    var phi_3760_: bool;
    var phi_3975_: f32;
    var phi_3759_: bool;
    var phi_3915_: f32;
    var phi_3758_: bool;
    var phi_3880_: f32;
    var phi_3767_: bool;
    var phi_3186_: type_52;
    var phi_3187_: bool;
    var phi_3188_: u32;
    var phi_3879_: f32;
    var phi_3766_: bool;
    var phi_3189_: type_52;
    var phi_3190_: u32;
    var phi_3191_: bool;
    var phi_3192_: u32;
    var phi_3878_: f32;
    var phi_3765_: bool;
    var phi_3193_: type_52;
    var phi_3194_: u32;
    var phi_3195_: bool;
    var phi_3196_: u32;
    var phi_3877_: f32;
    var phi_3764_: bool;
    var phi_900_: type_52;
    var phi_903_: u32;
    var phi_905_: bool;
    var phi_907_: u32;
    var phi_3197_: bool;
    var phi_3763_: bool;
    var phi_3204_: type_4;
    var phi_3205_: type_4;
    var phi_3228_: type_4;
    var phi_3294_: type_25;
    var phi_3870_: bool;

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
                            phi_387_ = (bitcast<i32>((_e223 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_387_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e223)), 32u, (_e223 == 0u))));
                        }
                        let _e237 = phi_387_;
                        phi_388_ = _e237;
                    } else {
                        phi_388_ = 0i;
                    }
                    let _e239 = phi_388_;
                    let _e240 = (_e156 == _e195);
                    if _e240 {
                        phi_398_ = true;
                    } else {
                        phi_398_ = (_e163 == _e195);
                    }
                    let _e243 = phi_398_;
                    let _e244 = select(1u, 0u, _e240);
                    if _e243 {
                        let _e245 = (_e244 + 1u);
                        phi_408_ = _e245;
                        phi_409_ = _e245;
                        phi_411_ = select(true, false, (_e245 == 2u));
                    } else {
                        phi_408_ = u32();
                        phi_409_ = 0u;
                        phi_411_ = true;
                    }
                    let _e249 = phi_408_;
                    let _e251 = phi_409_;
                    let _e253 = phi_411_;
                    if _e253 {
                        phi_416_ = (_e251 + 1u);
                    } else {
                        phi_416_ = 0u;
                    }
                    let _e257 = phi_416_;
                    let _e258 = select(_e249, _e251, _e253);
                    let _e259 = select(_e244, select(2u, _e244, _e243), _e253);
                    if (_e126 < -126i) {
                        phi_429_ = -126i;
                    } else {
                        phi_429_ = select(_e126, 127i, (_e126 > 127i));
                    }
                    let _e264 = phi_429_;
                    let _e269 = bitcast<f32>((bitcast<u32>((_e264 + 127i)) << bitcast<u32>(23i)));
                    let _e275 = bitcast<f32>((bitcast<u32>(((_e126 - _e264) + 127i)) << bitcast<u32>(23i)));
                    let _e276 = -(_e239);
                    if (_e276 < -126i) {
                        phi_449_ = -126i;
                    } else {
                        phi_449_ = select(_e276, 127i, (_e276 > 127i));
                    }
                    let _e281 = phi_449_;
                    let _e286 = bitcast<f32>((bitcast<u32>((_e281 + 127i)) << bitcast<u32>(23i)));
                    let _e292 = bitcast<f32>((bitcast<u32>(((_e276 - _e281) + 127i)) << bitcast<u32>(23i)));
                    let _e296 = global_5.member[_e144].member;
                    let _e297 = (_e258 == 0u);
                    if _e297 {
                        phi_467_ = _e296[0];
                    } else {
                        phi_467_ = _e296[1];
                    }
                    let _e301 = phi_467_;
                    let _e302 = (_e258 == 2u);
                    if _e302 {
                        phi_473_ = _e296[2];
                    } else {
                        phi_473_ = _e301;
                    }
                    let _e305 = phi_473_;
                    let _e307 = ((_e305 * _e269) * _e275);
                    let _e308 = global_5.member[_e144].member_2;
                    if _e297 {
                        phi_484_ = _e308[0];
                    } else {
                        phi_484_ = _e308[1];
                    }
                    let _e312 = phi_484_;
                    if _e302 {
                        phi_490_ = _e308[2];
                    } else {
                        phi_490_ = _e312;
                    }
                    let _e315 = phi_490_;
                    let _e317 = ((_e315 * _e286) * _e292);
                    let _e321 = (bitcast<f32>((bitcast<u32>(_e317) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e321 {
                        let _e325 = (bitcast<f32>((bitcast<u32>(_e307) & 2147483647u)) * 0.00000011920929f);
                        phi_513_ = select(0.00000000000011368684f, _e325, (_e325 > 0.00000000000011368684f));
                    } else {
                        phi_513_ = 0f;
                    }
                    let _e329 = phi_513_;
                    let _e330 = (_e307 + _e329);
                    let _e331 = (_e307 - _e329);
                    let _e332 = select(_e317, 0f, _e321);
                    if _e321 {
                        phi_524_ = 38685626000000000000000000f;
                    } else {
                        phi_524_ = (1f / _e317);
                    }
                    let _e335 = phi_524_;
                    let _e336 = (_e257 == 0u);
                    if _e336 {
                        phi_533_ = _e296[0];
                    } else {
                        phi_533_ = _e296[1];
                    }
                    let _e340 = phi_533_;
                    let _e341 = (_e257 == 2u);
                    if _e341 {
                        phi_539_ = _e296[2];
                    } else {
                        phi_539_ = _e340;
                    }
                    let _e344 = phi_539_;
                    let _e346 = ((_e344 * _e269) * _e275);
                    if _e336 {
                        phi_550_ = _e308[0];
                    } else {
                        phi_550_ = _e308[1];
                    }
                    let _e350 = phi_550_;
                    if _e341 {
                        phi_556_ = _e308[2];
                    } else {
                        phi_556_ = _e350;
                    }
                    let _e353 = phi_556_;
                    let _e355 = ((_e353 * _e286) * _e292);
                    let _e359 = (bitcast<f32>((bitcast<u32>(_e355) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e359 {
                        let _e363 = (bitcast<f32>((bitcast<u32>(_e346) & 2147483647u)) * 0.00000011920929f);
                        phi_579_ = select(0.00000000000011368684f, _e363, (_e363 > 0.00000000000011368684f));
                    } else {
                        phi_579_ = 0f;
                    }
                    let _e367 = phi_579_;
                    let _e368 = (_e346 + _e367);
                    let _e369 = (_e346 - _e367);
                    let _e370 = select(_e355, 0f, _e359);
                    if _e359 {
                        phi_590_ = 38685626000000000000000000f;
                    } else {
                        phi_590_ = (1f / _e355);
                    }
                    let _e373 = phi_590_;
                    let _e374 = (_e259 == 0u);
                    if _e374 {
                        phi_599_ = _e296[0];
                    } else {
                        phi_599_ = _e296[1];
                    }
                    let _e378 = phi_599_;
                    let _e379 = (_e259 == 2u);
                    if _e379 {
                        phi_605_ = _e296[2];
                    } else {
                        phi_605_ = _e378;
                    }
                    let _e382 = phi_605_;
                    let _e384 = ((_e382 * _e269) * _e275);
                    if _e374 {
                        phi_616_ = _e308[0];
                    } else {
                        phi_616_ = _e308[1];
                    }
                    let _e388 = phi_616_;
                    if _e379 {
                        phi_622_ = _e308[2];
                    } else {
                        phi_622_ = _e388;
                    }
                    let _e391 = phi_622_;
                    let _e393 = ((_e391 * _e286) * _e292);
                    let _e397 = (bitcast<f32>((bitcast<u32>(_e393) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e397 {
                        let _e401 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) * 0.00000011920929f);
                        phi_645_ = select(0.00000000000011368684f, _e401, (_e401 > 0.00000000000011368684f));
                    } else {
                        phi_645_ = 0f;
                    }
                    let _e405 = phi_645_;
                    let _e406 = (_e384 + _e405);
                    let _e407 = (_e384 - _e405);
                    let _e408 = select(_e393, 0f, _e397);
                    if _e397 {
                        phi_656_ = 38685626000000000000000000f;
                    } else {
                        phi_656_ = (1f / _e393);
                    }
                    let _e411 = phi_656_;
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
                        phi_756_ = select(-340282350000000000000000000000000000000f, _e452, (_e452 > -340282350000000000000000000000000000000f));
                        phi_757_ = select(-340282350000000000000000000000000000000f, _e445, (_e445 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_756_ = 0f;
                        phi_757_ = 1f;
                    }
                    let _e456 = phi_756_;
                    let _e458 = phi_757_;
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
                    phi_3656_ = false;
                    phi_3569_ = _e456;
                    phi_899_ = type_52(type_29(vec4<f32>((f32(_e464) * _e138), (f32(_e470) * _e138), (f32(_e476) * _e138), 0f), vec4<f32>((f32(_e481) * _e138), (f32(_e485) * _e138), (f32(_e489) * _e138), 0f)), select(0u, 2147483648u, (_e88 == 0u)));
                    phi_902_ = ((3u * _e88) + 1u);
                    phi_904_ = (_e458 <= _e456);
                    phi_906_ = 0u;
                    loop {
                        let _e499 = phi_3656_;
                        let _e501 = phi_3569_;
                        let _e503 = phi_899_;
                        let _e505 = phi_902_;
                        let _e507 = phi_904_;
                        let _e509 = phi_906_;
                        if _e507 {
                            phi_917_ = true;
                        } else {
                            phi_917_ = (_e509 > 0u);
                        }
                        let _e512 = phi_917_;
                        if _e512 {
                            let _e513 = (_e505 > 0u);
                            if _e513 {
                                if _e507 {
                                    phi_1004_ = _e503;
                                    phi_1005_ = _e507;
                                    phi_1006_ = _e509;
                                } else {
                                    let _e514 = (_e509 - 1u);
                                    let _e515 = (_e514 % 128u);
                                    let _e516 = (_e515 < 128u);
                                    if _e516 {
                                    } else {
                                        phi_3763_ = true;
                                        break;
                                    }
                                    let _e518 = local_7[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3763_ = true;
                                        break;
                                    }
                                    let _e520 = local_6[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3763_ = true;
                                        break;
                                    }
                                    let _e522 = local_5[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3763_ = true;
                                        break;
                                    }
                                    let _e524 = local_4[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3763_ = true;
                                        break;
                                    }
                                    let _e526 = local_3[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3763_ = true;
                                        break;
                                    }
                                    let _e528 = local_2[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3763_ = true;
                                        break;
                                    }
                                    let _e533 = local_8[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3763_ = true;
                                        break;
                                    }
                                    let _e536 = local_10[_e515];
                                    phi_1004_ = type_52(type_29(vec4<f32>(_e518, _e520, _e522, 0f), vec4<f32>(_e524, _e526, _e528, 0f)), _e533);
                                    phi_1005_ = (_e536 <= _e501);
                                    phi_1006_ = _e514;
                                }
                                let _e539 = phi_1004_;
                                let _e541 = phi_1005_;
                                let _e543 = phi_1006_;
                                if _e541 {
                                    if ((_e539.member_1 & 2147483648u) != 0u) {
                                        phi_3653_ = _e499;
                                        phi_3643_ = _e501;
                                        phi_1024_ = type_4(0u, ((_e539.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1007 = phi_3653_;
                                            let _e1009 = phi_3643_;
                                            let _e1011 = phi_1024_;
                                            if (_e1011.member < _e1011.member_1) {
                                                phi_1025_ = type_4((_e1011.member + 1u), _e1011.member_1);
                                                phi_1048_ = type_4(1u, _e1011.member);
                                            } else {
                                                phi_1025_ = _e1011;
                                                phi_1048_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1024 = phi_1025_;
                                            let _e1026 = phi_1048_;
                                            let _e1030 = (bitcast<i32>(_e1026.member) != 0i);
                                            if _e1030 {
                                                let _e1031 = ((_e539.member_1 & 268435455u) + _e1026.member_1);
                                                let _e1032 = (_e1031 < _e90);
                                                if _e1032 {
                                                    if _e1032 {
                                                    } else {
                                                        phi_3915_ = _e1009;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1036 = global_2.member[_e1031].member_1;
                                                    phi_1069_ = _e1036;
                                                } else {
                                                    phi_1069_ = 4294967295u;
                                                }
                                                let _e1038 = phi_1069_;
                                                if (_e1031 >= _e90) {
                                                    phi_1158_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1032 {
                                                    } else {
                                                        phi_3915_ = _e1009;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    if (_e461 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1009;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1045 = global_2.member[_e1031].member[_e461];
                                                    if (_e467 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1009;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1051 = global_2.member[_e1031].member[_e467];
                                                    if (_e473 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1009;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1057 = global_2.member[_e1031].member[_e473];
                                                    let _e1059 = (3u + _e461);
                                                    if (_e1059 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1009;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1065 = global_2.member[_e1031].member[_e1059];
                                                    let _e1066 = (3u + _e467);
                                                    if (_e1066 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1009;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1072 = global_2.member[_e1031].member[_e1066];
                                                    let _e1073 = (3u + _e473);
                                                    if (_e1073 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1009;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1079 = global_2.member[_e1031].member[_e1073];
                                                    let _e1081 = (6u + _e461);
                                                    if (_e1081 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1009;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1087 = global_2.member[_e1031].member[_e1081];
                                                    let _e1088 = (6u + _e467);
                                                    if (_e1088 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1009;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1094 = global_2.member[_e1031].member[_e1088];
                                                    let _e1095 = (6u + _e473);
                                                    if (_e1095 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1009;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1101 = global_2.member[_e1031].member[_e1095];
                                                    phi_1158_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1045, _e1051, _e1057), array<f32, 3>(_e1065, _e1072, _e1079), array<f32, 3>(_e1087, _e1094, _e1101));
                                                }
                                                let _e1105 = phi_1158_;
                                                let _e1112 = (_e1105[0][2] - _e384);
                                                let _e1115 = (((_e1105[0][0] - _e307) * _e408) - (_e1112 * _e332));
                                                let _e1118 = (((_e1105[0][1] - _e346) * _e408) - (_e1112 * _e370));
                                                let _e1125 = (_e1105[1][2] - _e384);
                                                let _e1128 = (((_e1105[1][0] - _e307) * _e408) - (_e1125 * _e332));
                                                let _e1131 = (((_e1105[1][1] - _e346) * _e408) - (_e1125 * _e370));
                                                let _e1138 = (_e1105[2][2] - _e384);
                                                let _e1141 = (((_e1105[2][0] - _e307) * _e408) - (_e1138 * _e332));
                                                let _e1144 = (((_e1105[2][1] - _e346) * _e408) - (_e1138 * _e370));
                                                let _e1145 = (_e1141 * _e1131);
                                                let _e1146 = (_e1144 * _e1128);
                                                let _e1147 = (_e1115 * _e1144);
                                                let _e1148 = (_e1118 * _e1141);
                                                let _e1149 = (_e1128 * _e1118);
                                                let _e1150 = (_e1131 * _e1115);
                                                let _e1155 = (((_e1145 >= _e1146) && (_e1147 >= _e1148)) && (_e1149 >= _e1150));
                                                if (_e1155 || (((_e1145 <= _e1146) && (_e1147 <= _e1148)) && (_e1149 <= _e1150))) {
                                                    let _e1162 = select(-1f, 1f, _e1155);
                                                    let _e1164 = ((_e1145 - _e1146) * _e1162);
                                                    let _e1166 = select(0f, _e1164, (_e1164 > 0f));
                                                    let _e1168 = ((_e1147 - _e1148) * _e1162);
                                                    let _e1170 = select(0f, _e1168, (_e1168 > 0f));
                                                    let _e1172 = ((_e1149 - _e1150) * _e1162);
                                                    let _e1174 = select(0f, _e1172, (_e1172 > 0f));
                                                    let _e1176 = ((_e1166 + _e1170) + _e1174);
                                                    if (_e1176 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1725_ = type_25();
                                                        phi_1726_ = true;
                                                    } else {
                                                        let _e1179 = select(_e1105[1][0], _e1105[0][0], (_e1105[0][0] < _e1105[1][0]));
                                                        let _e1183 = select(_e1105[1][0], _e1105[0][0], (_e1105[0][0] > _e1105[1][0]));
                                                        let _e1187 = select(_e1105[1][1], _e1105[0][1], (_e1105[0][1] < _e1105[1][1]));
                                                        let _e1191 = select(_e1105[1][1], _e1105[0][1], (_e1105[0][1] > _e1105[1][1]));
                                                        let _e1195 = select(_e1105[1][2], _e1105[0][2], (_e1105[0][2] < _e1105[1][2]));
                                                        let _e1199 = select(_e1105[1][2], _e1105[0][2], (_e1105[0][2] > _e1105[1][2]));
                                                        let _e1204 = ((select(_e1105[2][0], _e1179, (_e1179 < _e1105[2][0])) - _e330) * _e335);
                                                        let _e1205 = ((select(_e1105[2][0], _e1183, (_e1183 > _e1105[2][0])) - _e331) * _e335);
                                                        let _e1208 = ((select(_e1105[2][1], _e1187, (_e1187 < _e1105[2][1])) - _e368) * _e373);
                                                        let _e1209 = ((select(_e1105[2][1], _e1191, (_e1191 > _e1105[2][1])) - _e369) * _e373);
                                                        let _e1212 = ((select(_e1105[2][2], _e1195, (_e1195 < _e1105[2][2])) - _e406) * _e411);
                                                        let _e1213 = ((select(_e1105[2][2], _e1199, (_e1199 > _e1105[2][2])) - _e407) * _e411);
                                                        let _e1215 = select(_e1213, _e1212, (_e1212 < _e1213));
                                                        let _e1217 = select(_e1213, _e1212, (_e1212 > _e1213));
                                                        let _e1219 = select(_e1205, _e1204, (_e1204 < _e1205));
                                                        let _e1221 = select(_e1209, _e1208, (_e1208 < _e1209));
                                                        let _e1223 = select(_e1221, _e1219, (_e1219 > _e1221));
                                                        let _e1225 = select(_e1215, _e1223, (_e1223 > _e1215));
                                                        let _e1227 = select(_e1205, _e1204, (_e1204 > _e1205));
                                                        let _e1229 = select(_e1209, _e1208, (_e1208 > _e1209));
                                                        let _e1231 = select(_e1229, _e1227, (_e1227 < _e1229));
                                                        let _e1233 = select(_e1217, _e1231, (_e1231 < _e1217));
                                                        let _e1234 = -(_e1215);
                                                        let _e1240 = select(_e458, _e1225, (_e1225 > _e458));
                                                        if (_e1240 > (_e1233 + (select(_e1234, _e1217, (_e1217 > _e1234)) * 0.0000019073523f))) {
                                                            phi_1720_ = type_25();
                                                            phi_1721_ = true;
                                                        } else {
                                                            let _e1242 = (_e1240 > _e1009);
                                                            if _e1242 {
                                                                phi_1719_ = type_25();
                                                            } else {
                                                                let _e1246 = (_e1105[1][0] - _e1105[0][0]);
                                                                let _e1247 = (_e1105[1][1] - _e1105[0][1]);
                                                                let _e1248 = (_e1105[1][2] - _e1105[0][2]);
                                                                let _e1249 = vec3<f32>(_e1246, _e1247, _e1248);
                                                                let _e1250 = (_e1105[2][0] - _e1105[1][0]);
                                                                let _e1251 = (_e1105[2][1] - _e1105[1][1]);
                                                                let _e1252 = (_e1105[2][2] - _e1105[1][2]);
                                                                let _e1253 = vec3<f32>(_e1250, _e1251, _e1252);
                                                                let _e1254 = (_e1105[0][0] - _e1105[2][0]);
                                                                let _e1255 = (_e1105[0][1] - _e1105[2][1]);
                                                                let _e1256 = (_e1105[0][2] - _e1105[2][2]);
                                                                let _e1257 = vec3<f32>(_e1254, _e1255, _e1256);
                                                                let _e1260 = bitcast<f32>((bitcast<u32>(_e1246) & 2147483647u));
                                                                let _e1263 = bitcast<f32>((bitcast<u32>(_e1247) & 2147483647u));
                                                                let _e1265 = select(_e1263, _e1260, (_e1260 > _e1263));
                                                                let _e1268 = bitcast<f32>((bitcast<u32>(_e1248) & 2147483647u));
                                                                let _e1270 = select(_e1268, _e1265, (_e1265 > _e1268));
                                                                let _e1273 = bitcast<f32>((bitcast<u32>(_e1250) & 2147483647u));
                                                                let _e1276 = bitcast<f32>((bitcast<u32>(_e1251) & 2147483647u));
                                                                let _e1278 = select(_e1276, _e1273, (_e1273 > _e1276));
                                                                let _e1281 = bitcast<f32>((bitcast<u32>(_e1252) & 2147483647u));
                                                                let _e1283 = select(_e1281, _e1278, (_e1278 > _e1281));
                                                                let _e1286 = bitcast<f32>((bitcast<u32>(_e1254) & 2147483647u));
                                                                let _e1289 = bitcast<f32>((bitcast<u32>(_e1255) & 2147483647u));
                                                                let _e1291 = select(_e1289, _e1286, (_e1286 > _e1289));
                                                                let _e1294 = bitcast<f32>((bitcast<u32>(_e1256) & 2147483647u));
                                                                let _e1296 = select(_e1294, _e1291, (_e1291 > _e1294));
                                                                let _e1298 = select(_e1283, _e1270, (_e1270 > _e1283));
                                                                let _e1300 = select(_e1296, _e1298, (_e1298 > _e1296));
                                                                if (_e1270 == _e1300) {
                                                                    phi_1630_ = _e1253;
                                                                    phi_1631_ = _e1257;
                                                                } else {
                                                                    let _e1303 = vec3((_e1283 == _e1300));
                                                                    phi_1630_ = select(_e1249, _e1257, _e1303);
                                                                    phi_1631_ = select(_e1253, _e1249, _e1303);
                                                                }
                                                                let _e1307 = phi_1630_;
                                                                let _e1309 = phi_1631_;
                                                                let _e1316 = ((_e1307.y * _e1309.z) - (_e1309.y * _e1307.z));
                                                                let _e1321 = ((_e1307.z * _e1309.x) - (_e1309.z * _e1307.x));
                                                                let _e1324 = ((_e1307.x * _e1309.y) - (_e1309.x * _e1307.y));
                                                                if (_e1166 >= _e1170) {
                                                                    phi_1662_ = select(true, false, (_e1166 >= _e1174));
                                                                } else {
                                                                    phi_1662_ = true;
                                                                }
                                                                let _e1329 = phi_1662_;
                                                                if _e1329 {
                                                                    phi_1671_ = select(vec3<f32>(_e1105[2][0], _e1105[2][1], _e1105[2][2]), vec3<f32>(_e1105[1][0], _e1105[1][1], _e1105[1][2]), vec3((_e1170 >= _e1174)));
                                                                } else {
                                                                    phi_1671_ = vec3<f32>(_e1105[0][0], _e1105[0][1], _e1105[0][2]);
                                                                }
                                                                let _e1334 = phi_1671_;
                                                                let _e1351 = ((((_e1316 * (_e1334.x - _e307)) + (_e1321 * (_e1334.y - _e346))) + (_e1324 * (_e1334.z - _e384))) / (((_e1316 * _e332) + (_e1321 * _e370)) + (_e1324 * _e408)));
                                                                let _e1353 = select(_e1233, _e1351, (_e1351 < _e1233));
                                                                let _e1355 = select(_e1225, _e1353, (_e1353 > _e1225));
                                                                if (_e1355 >= _e458) {
                                                                    let _e1357 = (_e1355 <= _e1009);
                                                                    if _e1357 {
                                                                        let _e1358 = (1f / _e1176);
                                                                        phi_1711_ = type_25(_e1355, (_e1170 * _e1358), (_e1174 * _e1358), _e1038);
                                                                    } else {
                                                                        phi_1711_ = type_25();
                                                                    }
                                                                    let _e1363 = phi_1711_;
                                                                    phi_1713_ = _e1363;
                                                                    phi_1714_ = select(true, false, _e1357);
                                                                } else {
                                                                    phi_1713_ = type_25();
                                                                    phi_1714_ = true;
                                                                }
                                                                let _e1366 = phi_1713_;
                                                                let _e1368 = phi_1714_;
                                                                if _e1368 {
                                                                    phi_1718_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1718_ = _e1366;
                                                                }
                                                                let _e1370 = phi_1718_;
                                                                phi_1719_ = _e1370;
                                                            }
                                                            let _e1372 = phi_1719_;
                                                            phi_1720_ = _e1372;
                                                            phi_1721_ = _e1242;
                                                        }
                                                        let _e1374 = phi_1720_;
                                                        let _e1376 = phi_1721_;
                                                        phi_1725_ = _e1374;
                                                        phi_1726_ = _e1376;
                                                    }
                                                    let _e1378 = phi_1725_;
                                                    let _e1380 = phi_1726_;
                                                    phi_1730_ = _e1378;
                                                    phi_1731_ = _e1380;
                                                } else {
                                                    phi_1730_ = type_25();
                                                    phi_1731_ = true;
                                                }
                                                let _e1382 = phi_1730_;
                                                let _e1384 = phi_1731_;
                                                if _e1384 {
                                                    phi_1735_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1735_ = _e1382;
                                                }
                                                let _e1386 = phi_1735_;
                                                if (_e1386.member_3 != 4294967295u) {
                                                    if (_e1038 != 4294967295u) {
                                                        phi_1747_ = type_4(0u, 8u);
                                                        phi_1750_ = _e1386;
                                                        loop {
                                                            let _e1391 = phi_1747_;
                                                            let _e1393 = phi_1750_;
                                                            if (_e1391.member < _e1391.member_1) {
                                                                phi_1748_ = type_4((_e1391.member + 1u), _e1391.member_1);
                                                                phi_1773_ = type_4(1u, _e1391.member);
                                                            } else {
                                                                phi_1748_ = _e1391;
                                                                phi_1773_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1406 = phi_1748_;
                                                            let _e1408 = phi_1773_;
                                                            let _e1412 = (bitcast<i32>(_e1408.member) != 0i);
                                                            if _e1412 {
                                                                let _e1413 = (_e1408.member_1 < 8u);
                                                                if _e1413 {
                                                                } else {
                                                                    phi_3644_ = true;
                                                                    break;
                                                                }
                                                                let _e1418 = local_9[_e1408.member_1].member;
                                                                if (_e1393.member < _e1418) {
                                                                    phi_1806_ = true;
                                                                } else {
                                                                    let _e1420 = local_9[_e1408.member_1].member;
                                                                    if (_e1393.member == _e1420) {
                                                                        let _e1425 = local_9[_e1408.member_1].member_3;
                                                                        phi_1805_ = (_e1393.member_3 < _e1425);
                                                                    } else {
                                                                        phi_1805_ = false;
                                                                    }
                                                                    let _e1428 = phi_1805_;
                                                                    phi_1806_ = _e1428;
                                                                }
                                                                let _e1430 = phi_1806_;
                                                                if _e1430 {
                                                                    if _e1413 {
                                                                    } else {
                                                                        phi_3644_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1431 = local_9[_e1408.member_1];
                                                                    local_9[_e1408.member_1] = type_25(_e1393.member, _e1393.member_1, _e1393.member_2, _e1393.member_3);
                                                                    phi_1827_ = type_25(_e1431.member, _e1431.member_1, _e1431.member_2, _e1431.member_3);
                                                                } else {
                                                                    phi_1827_ = _e1393;
                                                                }
                                                                let _e1442 = phi_1827_;
                                                                phi_1751_ = _e1442;
                                                            } else {
                                                                phi_1751_ = type_25();
                                                            }
                                                            let _e1444 = phi_1751_;
                                                            continue;
                                                            continuing {
                                                                phi_1747_ = _e1406;
                                                                phi_1750_ = _e1444;
                                                                phi_3644_ = _e1007;
                                                                break if !(_e1412);
                                                            }
                                                        }
                                                        let _e1447 = phi_3644_;
                                                        phi_3915_ = _e1009;
                                                        phi_3758_ = _e1447;
                                                        if _e1447 {
                                                            break;
                                                        }
                                                        let _e1450 = local_9[7u].member_3;
                                                        if (_e1450 != 4294967295u) {
                                                            let _e1454 = local_9[7u].member;
                                                            phi_3978_ = _e1454;
                                                        } else {
                                                            phi_3978_ = _e1009;
                                                        }
                                                        let _e1456 = phi_3978_;
                                                        phi_3977_ = _e1456;
                                                        phi_3761_ = _e1447;
                                                    } else {
                                                        phi_3977_ = _e1009;
                                                        phi_3761_ = _e1007;
                                                    }
                                                    let _e1458 = phi_3977_;
                                                    let _e1460 = phi_3761_;
                                                    phi_3976_ = _e1458;
                                                    phi_3760_ = _e1460;
                                                } else {
                                                    phi_3976_ = _e1009;
                                                    phi_3760_ = _e1007;
                                                }
                                                let _e1462 = phi_3976_;
                                                let _e1464 = phi_3760_;
                                                phi_3975_ = _e1462;
                                                phi_3759_ = _e1464;
                                            } else {
                                                phi_3975_ = _e1009;
                                                phi_3759_ = _e1007;
                                            }
                                            let _e1466 = phi_3975_;
                                            let _e1468 = phi_3759_;
                                            continue;
                                            continuing {
                                                phi_3653_ = _e1468;
                                                phi_3643_ = _e1466;
                                                phi_1024_ = _e1024;
                                                phi_3915_ = _e1466;
                                                phi_3758_ = _e1468;
                                                break if !(_e1030);
                                            }
                                        }
                                        let _e1471 = phi_3915_;
                                        let _e1473 = phi_3758_;
                                        phi_3763_ = _e1473;
                                        if _e1473 {
                                            break;
                                        }
                                        phi_3880_ = _e1471;
                                        phi_3767_ = _e1473;
                                        phi_3186_ = _e539;
                                        phi_3187_ = false;
                                        phi_3188_ = _e543;
                                    } else {
                                        if (_e539.member_1 >= _e88) {
                                            phi_2741_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e539.member_1 < _e88) {
                                            } else {
                                                phi_3763_ = true;
                                                break;
                                            }
                                            let _e555 = ((1u + _e258) % 4u);
                                            if (_e555 < 4u) {
                                            } else {
                                                phi_3763_ = true;
                                                break;
                                            }
                                            let _e560 = global_4.member[_e539.member_1][_e555];
                                            let _e562 = ((1u + _e257) % 4u);
                                            if (_e562 < 4u) {
                                            } else {
                                                phi_3763_ = true;
                                                break;
                                            }
                                            let _e567 = global_4.member[_e539.member_1][_e562];
                                            let _e569 = ((1u + _e259) % 4u);
                                            if (_e569 < 4u) {
                                            } else {
                                                phi_3763_ = true;
                                                break;
                                            }
                                            let _e574 = global_4.member[_e539.member_1][_e569];
                                            let _e576 = ((_e258 + 1u) % 4u);
                                            if (_e576 < 4u) {
                                            } else {
                                                phi_3763_ = true;
                                                break;
                                            }
                                            let _e581 = global_4.member[_e539.member_1][_e576];
                                            let _e583 = (_e581 >> bitcast<u32>(11u));
                                            let _e585 = ((_e257 + 1u) % 4u);
                                            if (_e585 < 4u) {
                                            } else {
                                                phi_3763_ = true;
                                                break;
                                            }
                                            let _e590 = global_4.member[_e539.member_1][_e585];
                                            let _e592 = (_e590 >> bitcast<u32>(11u));
                                            let _e594 = ((_e259 + 1u) % 4u);
                                            if (_e594 < 4u) {
                                            } else {
                                                phi_3763_ = true;
                                                break;
                                            }
                                            let _e599 = global_4.member[_e539.member_1][_e594];
                                            let _e601 = (_e599 >> bitcast<u32>(11u));
                                            let _e624 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.x - _e539.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e625 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.y - _e539.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e626 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.z - _e539.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e628 = select(_e138, _e624, (_e624 > _e138));
                                            let _e630 = select(_e138, _e625, (_e625 > _e138));
                                            let _e632 = select(_e138, _e626, (_e626 > _e138));
                                            let _e657 = bitcast<u32>((f32(bitcast<i32>((_e560 & 1023u))) * _e628));
                                            let _e662 = (bitcast<i32>((_e560 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e665 = bitcast<f32>((_e657 & bitcast<u32>(_e662)));
                                            let _e666 = bitcast<u32>((f32(bitcast<i32>((_e567 & 1023u))) * _e630));
                                            let _e671 = (bitcast<i32>((_e567 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e674 = bitcast<f32>((_e666 & bitcast<u32>(_e671)));
                                            let _e675 = bitcast<u32>((f32(bitcast<i32>((_e574 & 1023u))) * _e632));
                                            let _e680 = (bitcast<i32>((_e574 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e683 = bitcast<f32>((_e675 & bitcast<u32>(_e680)));
                                            let _e687 = bitcast<f32>((_e657 & bitcast<u32>(~(_e662))));
                                            let _e691 = bitcast<f32>((_e666 & bitcast<u32>(~(_e671))));
                                            let _e695 = bitcast<f32>((_e675 & bitcast<u32>(~(_e680))));
                                            let _e696 = bitcast<u32>((f32(bitcast<i32>((_e583 & 1023u))) * _e628));
                                            let _e701 = (bitcast<i32>((_e583 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e704 = bitcast<f32>((_e696 & bitcast<u32>(_e701)));
                                            let _e705 = bitcast<u32>((f32(bitcast<i32>((_e592 & 1023u))) * _e630));
                                            let _e710 = (bitcast<i32>((_e592 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e713 = bitcast<f32>((_e705 & bitcast<u32>(_e710)));
                                            let _e714 = bitcast<u32>((f32(bitcast<i32>((_e601 & 1023u))) * _e632));
                                            let _e719 = (bitcast<i32>((_e601 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e722 = bitcast<f32>((_e714 & bitcast<u32>(_e719)));
                                            let _e726 = bitcast<f32>((_e696 & bitcast<u32>(~(_e701))));
                                            let _e730 = bitcast<f32>((_e705 & bitcast<u32>(~(_e710))));
                                            let _e734 = bitcast<f32>((_e714 & bitcast<u32>(~(_e719))));
                                            let _e764 = global_4.member[_e539.member_1][0u];
                                            let _e768 = global_4.member[_e539.member_1][1u];
                                            let _e772 = global_4.member[_e539.member_1][2u];
                                            let _e776 = global_4.member[_e539.member_1][3u];
                                            let _e788 = (((_e768 >> bitcast<u32>(22i)) | ((_e772 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e776 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e789 = (_e764 & 268435455u);
                                            let _e790 = (_e788 & 268435455u);
                                            let _e793 = ((_e764 >> bitcast<u32>(28u)) & 7u);
                                            let _e801 = ((_e764 >> bitcast<u32>(31i)) | (((_e788 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e802 = (_e793 != 0u);
                                            if (_e793 == 0u) {
                                                phi_2703_ = _e789;
                                            } else {
                                                if (_e793 == 7u) {
                                                    phi_2702_ = 2147483648u;
                                                } else {
                                                    phi_2702_ = ((2147483648u | (_e793 << bitcast<u32>(28u))) | (_e790 & 268435455u));
                                                }
                                                let _e811 = phi_2702_;
                                                phi_2703_ = _e811;
                                            }
                                            let _e813 = phi_2703_;
                                            if _e802 {
                                                let _e814 = (_e793 != 7u);
                                                if _e814 {
                                                    phi_2713_ = (_e790 + _e793);
                                                } else {
                                                    phi_2713_ = u32();
                                                }
                                                let _e817 = phi_2713_;
                                                phi_2715_ = _e817;
                                                phi_2716_ = select(true, false, _e814);
                                            } else {
                                                phi_2715_ = u32();
                                                phi_2716_ = true;
                                            }
                                            let _e820 = phi_2715_;
                                            let _e822 = phi_2716_;
                                            if (_e801 == 0u) {
                                                phi_2737_ = (_e789 + select(0u, 1u, !(_e802)));
                                            } else {
                                                if (_e801 == 7u) {
                                                    phi_2736_ = 2147483648u;
                                                } else {
                                                    phi_2736_ = ((2147483648u | (_e801 << bitcast<u32>(28u))) | (select(_e820, _e790, _e822) & 268435455u));
                                                }
                                                let _e835 = phi_2736_;
                                                phi_2737_ = _e835;
                                            }
                                            let _e837 = phi_2737_;
                                            phi_2741_ = type_53(array<vec4<f32>, 3>(vec4<f32>((_e539.member.member.x + _e665), (_e539.member.member.x + _e687), (_e539.member.member_1.x - _e704), (_e539.member.member_1.x - _e726)), vec4<f32>((_e539.member.member.y + _e674), (_e539.member.member.y + _e691), (_e539.member.member_1.y - _e713), (_e539.member.member_1.y - _e730)), vec4<f32>((_e539.member.member.z + _e683), (_e539.member.member.z + _e695), (_e539.member.member_1.z - _e722), (_e539.member.member_1.z - _e734))), type_52(type_29((_e539.member.member + vec4<f32>(_e665, _e674, _e683, 0f)), (_e539.member.member_1 - vec4<f32>(_e704, _e713, _e722, 0f))), _e813), type_52(type_29((_e539.member.member + vec4<f32>(_e687, _e691, _e695, 0f)), (_e539.member.member_1 - vec4<f32>(_e726, _e730, _e734, 0f))), _e837));
                                        }
                                        let _e842 = phi_2741_;
                                        let _e853 = ((_e842.member[0].x - _e330) * _e335);
                                        let _e854 = ((_e842.member[0].y - _e330) * _e335);
                                        let _e855 = ((_e842.member[0].z - _e331) * _e335);
                                        let _e856 = ((_e842.member[0].w - _e331) * _e335);
                                        let _e866 = ((_e842.member[1].x - _e368) * _e373);
                                        let _e867 = ((_e842.member[1].y - _e368) * _e373);
                                        let _e868 = ((_e842.member[1].z - _e369) * _e373);
                                        let _e869 = ((_e842.member[1].w - _e369) * _e373);
                                        let _e879 = ((_e842.member[2].x - _e406) * _e411);
                                        let _e880 = ((_e842.member[2].y - _e406) * _e411);
                                        let _e881 = ((_e842.member[2].z - _e407) * _e411);
                                        let _e882 = ((_e842.member[2].w - _e407) * _e411);
                                        let _e884 = select(_e881, _e879, (_e879 < _e881));
                                        let _e886 = select(_e882, _e880, (_e880 < _e882));
                                        let _e888 = select(_e881, _e879, (_e879 > _e881));
                                        let _e890 = select(_e882, _e880, (_e880 > _e882));
                                        let _e892 = select(_e855, _e853, (_e853 < _e855));
                                        let _e894 = select(_e856, _e854, (_e854 < _e856));
                                        let _e896 = select(_e868, _e866, (_e866 < _e868));
                                        let _e898 = select(_e869, _e867, (_e867 < _e869));
                                        let _e900 = select(_e896, _e892, (_e892 > _e896));
                                        let _e902 = select(_e898, _e894, (_e894 > _e898));
                                        let _e904 = select(_e884, _e900, (_e900 > _e884));
                                        let _e906 = select(_e886, _e902, (_e902 > _e886));
                                        let _e908 = select(_e855, _e853, (_e853 > _e855));
                                        let _e910 = select(_e856, _e854, (_e854 > _e856));
                                        let _e912 = select(_e868, _e866, (_e866 > _e868));
                                        let _e914 = select(_e869, _e867, (_e867 > _e869));
                                        let _e916 = select(_e912, _e908, (_e908 < _e912));
                                        let _e918 = select(_e914, _e910, (_e910 < _e914));
                                        let _e923 = -(_e884);
                                        let _e924 = -(_e886);
                                        let _e931 = (select(_e888, _e916, (_e916 < _e888)) + (select(_e923, _e888, (_e888 > _e923)) * 0.0000019073523f));
                                        let _e932 = (select(_e890, _e918, (_e918 < _e890)) + (select(_e924, _e890, (_e890 > _e924)) * 0.0000019073523f));
                                        let _e934 = select(_e458, _e904, (_e904 > _e458));
                                        let _e936 = select(_e458, _e906, (_e906 > _e458));
                                        let _e941 = (_e934 <= select(_e501, _e931, (_e931 < _e501)));
                                        let _e942 = (_e936 <= select(_e501, _e932, (_e932 < _e501)));
                                        let _e943 = (_e934 <= _e936);
                                        if _e941 {
                                            if _e942 {
                                                if _e943 {
                                                    phi_3086_ = _e842.member_2;
                                                } else {
                                                    phi_3086_ = _e842.member_1;
                                                }
                                                let _e947 = phi_3086_;
                                                let _e969 = (_e543 % 128u);
                                                let _e970 = (_e969 < 128u);
                                                if _e970 {
                                                } else {
                                                    phi_3763_ = true;
                                                    break;
                                                }
                                                local_8[_e969] = _e947.member_1;
                                                if _e970 {
                                                } else {
                                                    phi_3763_ = true;
                                                    break;
                                                }
                                                local_7[_e969] = _e947.member.member.x;
                                                if _e970 {
                                                } else {
                                                    phi_3763_ = true;
                                                    break;
                                                }
                                                local_6[_e969] = _e947.member.member.y;
                                                if _e970 {
                                                } else {
                                                    phi_3763_ = true;
                                                    break;
                                                }
                                                local_5[_e969] = _e947.member.member.z;
                                                if _e970 {
                                                } else {
                                                    phi_3763_ = true;
                                                    break;
                                                }
                                                local_4[_e969] = _e947.member.member_1.x;
                                                if _e970 {
                                                } else {
                                                    phi_3763_ = true;
                                                    break;
                                                }
                                                local_3[_e969] = _e947.member.member_1.y;
                                                if _e970 {
                                                } else {
                                                    phi_3763_ = true;
                                                    break;
                                                }
                                                local_2[_e969] = _e947.member.member_1.z;
                                                if _e970 {
                                                } else {
                                                    phi_3763_ = true;
                                                    break;
                                                }
                                                local_10[_e969] = select(_e936, _e934, (_e934 > _e936));
                                                if _e943 {
                                                    phi_3163_ = _e842.member_1;
                                                } else {
                                                    phi_3163_ = _e842.member_2;
                                                }
                                                let _e983 = phi_3163_;
                                                phi_3164_ = _e983;
                                                phi_3165_ = (_e543 + 1u);
                                            } else {
                                                phi_3164_ = type_52();
                                                phi_3165_ = u32();
                                            }
                                            let _e985 = phi_3164_;
                                            let _e987 = phi_3165_;
                                            phi_3167_ = _e985;
                                            phi_3168_ = _e987;
                                            phi_3169_ = select(true, false, _e942);
                                        } else {
                                            phi_3167_ = type_52();
                                            phi_3168_ = u32();
                                            phi_3169_ = true;
                                        }
                                        let _e990 = phi_3167_;
                                        let _e992 = phi_3168_;
                                        let _e994 = phi_3169_;
                                        if _e994 {
                                            if _e941 {
                                                phi_3178_ = _e842.member_1;
                                            } else {
                                                phi_3178_ = _e842.member_2;
                                            }
                                            let _e998 = phi_3178_;
                                            phi_3183_ = _e998;
                                            phi_3184_ = select(_e942, true, _e941);
                                        } else {
                                            phi_3183_ = _e990;
                                            phi_3184_ = _e541;
                                        }
                                        let _e1001 = phi_3183_;
                                        let _e1003 = phi_3184_;
                                        phi_3880_ = _e501;
                                        phi_3767_ = _e499;
                                        phi_3186_ = _e1001;
                                        phi_3187_ = _e1003;
                                        phi_3188_ = select(_e992, _e543, _e994);
                                    }
                                    let _e1475 = phi_3880_;
                                    let _e1477 = phi_3767_;
                                    let _e1479 = phi_3186_;
                                    let _e1481 = phi_3187_;
                                    let _e1483 = phi_3188_;
                                    phi_3879_ = _e1475;
                                    phi_3766_ = _e1477;
                                    phi_3189_ = _e1479;
                                    phi_3190_ = (_e505 - 1u);
                                    phi_3191_ = _e1481;
                                    phi_3192_ = _e1483;
                                } else {
                                    phi_3879_ = _e501;
                                    phi_3766_ = _e499;
                                    phi_3189_ = _e539;
                                    phi_3190_ = _e505;
                                    phi_3191_ = _e541;
                                    phi_3192_ = _e543;
                                }
                                let _e1485 = phi_3879_;
                                let _e1487 = phi_3766_;
                                let _e1489 = phi_3189_;
                                let _e1491 = phi_3190_;
                                let _e1493 = phi_3191_;
                                let _e1495 = phi_3192_;
                                phi_3878_ = _e1485;
                                phi_3765_ = _e1487;
                                phi_3193_ = _e1489;
                                phi_3194_ = _e1491;
                                phi_3195_ = _e1493;
                                phi_3196_ = _e1495;
                            } else {
                                phi_3878_ = _e501;
                                phi_3765_ = _e499;
                                phi_3193_ = type_52();
                                phi_3194_ = u32();
                                phi_3195_ = bool();
                                phi_3196_ = u32();
                            }
                            let _e1497 = phi_3878_;
                            let _e1499 = phi_3765_;
                            let _e1501 = phi_3193_;
                            let _e1503 = phi_3194_;
                            let _e1505 = phi_3195_;
                            let _e1507 = phi_3196_;
                            phi_3877_ = _e1497;
                            phi_3764_ = _e1499;
                            phi_900_ = _e1501;
                            phi_903_ = _e1503;
                            phi_905_ = _e1505;
                            phi_907_ = _e1507;
                            phi_3197_ = _e513;
                        } else {
                            phi_3877_ = _e501;
                            phi_3764_ = _e499;
                            phi_900_ = type_52();
                            phi_903_ = u32();
                            phi_905_ = bool();
                            phi_907_ = u32();
                            phi_3197_ = false;
                        }
                        let _e1509 = phi_3877_;
                        let _e1511 = phi_3764_;
                        let _e1513 = phi_900_;
                        let _e1515 = phi_903_;
                        let _e1517 = phi_905_;
                        let _e1519 = phi_907_;
                        let _e1521 = phi_3197_;
                        continue;
                        continuing {
                            phi_3656_ = _e1511;
                            phi_3569_ = _e1509;
                            phi_899_ = _e1513;
                            phi_902_ = _e1515;
                            phi_904_ = _e1517;
                            phi_906_ = _e1519;
                            phi_3763_ = _e1511;
                            break if !(_e1521);
                        }
                    }
                    let _e1524 = phi_3763_;
                    if _e1524 {
                        break;
                    }
                    phi_3204_ = type_4(0u, 8u);
                    loop {
                        let _e1526 = phi_3204_;
                        if (_e1526.member < _e1526.member_1) {
                            phi_3205_ = type_4((_e1526.member + 1u), _e1526.member_1);
                            phi_3228_ = type_4(1u, _e1526.member);
                        } else {
                            phi_3205_ = _e1526;
                            phi_3228_ = type_4(0u, type_4().member_1);
                        }
                        let _e1539 = phi_3205_;
                        let _e1541 = phi_3228_;
                        let _e1545 = (bitcast<i32>(_e1541.member) != 0i);
                        if _e1545 {
                            let _e1546 = (_e1541.member_1 < 8u);
                            if _e1546 {
                            } else {
                                phi_3870_ = true;
                                break;
                            }
                            let _e1548 = local_9[_e1541.member_1];
                            if (_e1548.member_3 != 4294967295u) {
                                let _e1554 = -(_e425);
                                let _e1555 = (_e1554 / 3i);
                                let _e1562 = bitcast<f32>((bitcast<u32>((_e1555 + 127i)) << bitcast<u32>(23i)));
                                let _e1570 = (((_e1548.member * _e1562) * _e1562) * bitcast<f32>((bitcast<u32>(((_e1554 - (2i * _e1555)) + 127i)) << bitcast<u32>(23i))));
                                let _e1572 = select(340282350000000000000000000000000000000f, _e1570, (_e1570 < 340282350000000000000000000000000000000f));
                                phi_3294_ = type_25(select(-340282350000000000000000000000000000000f, _e1572, (_e1572 > -340282350000000000000000000000000000000f)), _e1548.member_1, _e1548.member_2, _e1548.member_3);
                            } else {
                                phi_3294_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1577 = phi_3294_;
                            if _e1546 {
                            } else {
                                phi_3870_ = true;
                                break;
                            }
                            local_9[_e1541.member_1] = type_25(_e1577.member, _e1577.member_1, _e1577.member_2, _e1577.member_3);
                        }
                        continue;
                        continuing {
                            phi_3204_ = _e1539;
                            phi_3870_ = _e1524;
                            break if !(_e1545);
                        }
                    }
                    let _e1585 = phi_3870_;
                    if _e1585 {
                        break;
                    }
                    let _e1586 = local_9;
                    if _e146 {
                    } else {
                        break;
                    }
                    global_6.member[_e144] = array<type_25, 8>(type_25(_e1586[0].member, _e1586[0].member_1, _e1586[0].member_2, _e1586[0].member_3), type_25(_e1586[1].member, _e1586[1].member_1, _e1586[1].member_2, _e1586[1].member_3), type_25(_e1586[2].member, _e1586[2].member_1, _e1586[2].member_2, _e1586[2].member_3), type_25(_e1586[3].member, _e1586[3].member_1, _e1586[3].member_2, _e1586[3].member_3), type_25(_e1586[4].member, _e1586[4].member_1, _e1586[4].member_2, _e1586[4].member_3), type_25(_e1586[5].member, _e1586[5].member_1, _e1586[5].member_2, _e1586[5].member_3), type_25(_e1586[6].member, _e1586[6].member_1, _e1586[6].member_2, _e1586[6].member_3), type_25(_e1586[7].member, _e1586[7].member_1, _e1586[7].member_2, _e1586[7].member_3));
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
