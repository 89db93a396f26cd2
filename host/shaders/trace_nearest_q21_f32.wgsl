struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_25 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_33 {
    member: array<type_22>,
}

struct type_37 {
    member: array<array<type_21, 8>>,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: array<array<u32, 7>>,
}

struct type_52 {
    member: type_25,
    member_1: u32,
}

struct type_53 {
    member: array<vec4<f32>, 3>,
    member_1: type_52,
    member_2: type_52,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_43;
@group(0) @binding(4) 
var<storage> global_4: type_33;
@group(0) @binding(2) 
var<storage> global_5: type_47;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_37;

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
    var local_9: array<type_21, 8>;
    var local_10: array<f32, 128>;
    var phi_389_: i32;
    var phi_390_: i32;
    var phi_400_: bool;
    var phi_410_: u32;
    var phi_411_: u32;
    var phi_413_: bool;
    var phi_418_: u32;
    var phi_430_: i32;
    var phi_450_: i32;
    var phi_468_: f32;
    var phi_474_: f32;
    var phi_485_: f32;
    var phi_491_: f32;
    var phi_514_: f32;
    var phi_525_: f32;
    var phi_534_: f32;
    var phi_540_: f32;
    var phi_551_: f32;
    var phi_557_: f32;
    var phi_580_: f32;
    var phi_591_: f32;
    var phi_600_: f32;
    var phi_606_: f32;
    var phi_617_: f32;
    var phi_623_: f32;
    var phi_646_: f32;
    var phi_657_: f32;
    var phi_757_: f32;
    var phi_758_: f32;
    var phi_3767_: bool;
    var phi_3695_: f32;
    var phi_900_: type_52;
    var phi_903_: u32;
    var phi_905_: bool;
    var phi_907_: u32;
    var phi_918_: bool;
    var phi_1005_: type_52;
    var phi_1006_: bool;
    var phi_1007_: u32;
    var phi_2828_: u32;
    var phi_2829_: u32;
    var phi_2839_: u32;
    var phi_2841_: u32;
    var phi_2842_: bool;
    var phi_2862_: u32;
    var phi_2863_: u32;
    var phi_2867_: type_53;
    var phi_3212_: type_52;
    var phi_3289_: type_52;
    var phi_3290_: type_52;
    var phi_3291_: u32;
    var phi_3293_: type_52;
    var phi_3294_: u32;
    var phi_3295_: bool;
    var phi_3304_: type_52;
    var phi_3309_: type_52;
    var phi_3310_: bool;
    var phi_3764_: bool;
    var phi_3754_: f32;
    var phi_1025_: type_4;
    var phi_1026_: type_4;
    var phi_1049_: type_4;
    var phi_1070_: u32;
    var phi_1159_: array<array<f32, 3>, 3>;
    var phi_1277_: bool;
    var phi_1306_: bool;
    var phi_1707_: f32;
    var phi_1708_: f32;
    var phi_1709_: f32;
    var phi_1710_: f32;
    var phi_1711_: vec3<f32>;
    var phi_1712_: vec3<f32>;
    var phi_1713_: vec3<f32>;
    var phi_1714_: vec3<f32>;
    var phi_1745_: bool;
    var phi_1754_: vec3<f32>;
    var phi_1921_: bool;
    var phi_1945_: f32;
    var phi_1946_: f32;
    var phi_1969_: type_21;
    var phi_1971_: type_21;
    var phi_1972_: bool;
    var phi_1976_: type_21;
    var phi_1977_: type_21;
    var phi_1978_: type_21;
    var phi_1979_: bool;
    var phi_1983_: type_21;
    var phi_1984_: bool;
    var phi_1985_: type_21;
    var phi_1986_: bool;
    var phi_1987_: bool;
    var phi_1988_: type_21;
    var phi_1989_: bool;
    var phi_1990_: bool;
    var phi_1998_: type_21;
    var phi_1999_: bool;
    var phi_2003_: type_21;
    var phi_2015_: type_4;
    var phi_2018_: type_21;
    var phi_2016_: type_4;
    var phi_2041_: type_4;
    var phi_2073_: bool;
    var phi_2074_: bool;
    var phi_2095_: type_21;
    var phi_2019_: type_21;
    var phi_3755_: bool;
    var phi_4130_: f32;
    var phi_4129_: f32;
    var phi_3900_: bool;
    var phi_4128_: f32;
    var phi_3899_: bool;
    var phi_4127_: f32;
    var phi_3898_: bool;
    var phi_4039_: f32;
    var phi_3897_: bool;
    var phi_4004_: f32;
    var phi_3906_: bool;
    var phi_3312_: type_52;
    var phi_3313_: bool;
    var phi_3314_: u32;
    var phi_4003_: f32;
    var phi_3905_: bool;
    var phi_3315_: type_52;
    var phi_3316_: u32;
    var phi_3317_: bool;
    var phi_3318_: u32;
    var phi_4002_: f32;
    var phi_3904_: bool;
    var phi_3319_: type_52;
    var phi_3320_: u32;
    var phi_3321_: bool;
    var phi_3322_: u32;
    var phi_4001_: f32;
    var phi_3903_: bool;
    var phi_901_: type_52;
    var phi_904_: u32;
    var phi_906_: bool;
    var phi_908_: u32;
    var phi_3323_: bool;
    var phi_3902_: bool;
    var phi_3330_: type_4;
    var phi_3331_: type_4;
    var phi_3354_: type_4;
    var phi_3420_: type_21;
    var phi_3994_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e86 = global;
            let _e88 = arrayLength((&global_5.member));
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
            let _e145 = (_e144 < arrayLength((&global_4.member)));
            if _e145 {
                let _e146 = (_e144 < arrayLength((&global_6.member)));
                if _e146 {
                    if _e145 {
                    } else {
                        break;
                    }
                    let _e154 = global_4.member[_e144].member_2[0u];
                    let _e156 = (bitcast<u32>(_e154) & 2147483647u);
                    let _e161 = global_4.member[_e144].member_2[1u];
                    let _e163 = (bitcast<u32>(_e161) & 2147483647u);
                    let _e168 = global_4.member[_e144].member_2[2u];
                    let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                    let _e175 = global_4.member[_e144].member[0u];
                    let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                    let _e182 = global_4.member[_e144].member[1u];
                    let _e184 = (bitcast<u32>(_e182) & 2147483647u);
                    let _e189 = global_4.member[_e144].member[2u];
                    let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                    let _e193 = select(_e163, _e156, (_e163 < _e156));
                    let _e195 = select(_e170, _e193, (_e170 < _e193));
                    let _e197 = select(_e177, _e195, (_e177 < _e195));
                    let _e199 = select(_e184, _e197, (_e184 < _e197));
                    let _e201 = select(_e191, _e199, (_e191 < _e199));
                    let _e205 = global_4.member[_e144].member_1;
                    let _e207 = (bitcast<u32>(_e205) & 2147483647u);
                    let _e214 = global_4.member[_e144].member_3;
                    let _e220 = (((select(_e207, _e201, (_e207 < _e201)) < 2139095040u) && ((bitcast<u32>(_e214) & 2147483647u) <= 2139095040u)) && (_e195 > 0u));
                    if _e220 {
                        let _e223 = (bitcast<u32>(bitcast<f32>(_e195)) & 2147483647u);
                        if (_e223 >= 8388608u) {
                            phi_389_ = (bitcast<i32>((_e223 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_389_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e223)), 32u, (_e223 == 0u))));
                        }
                        let _e237 = phi_389_;
                        phi_390_ = _e237;
                    } else {
                        phi_390_ = 0i;
                    }
                    let _e239 = phi_390_;
                    let _e240 = (_e156 == _e195);
                    if _e240 {
                        phi_400_ = true;
                    } else {
                        phi_400_ = (_e163 == _e195);
                    }
                    let _e243 = phi_400_;
                    let _e244 = select(1u, 0u, _e240);
                    if _e243 {
                        let _e245 = (_e244 + 1u);
                        phi_410_ = _e245;
                        phi_411_ = _e245;
                        phi_413_ = select(true, false, (_e245 == 2u));
                    } else {
                        phi_410_ = u32();
                        phi_411_ = 0u;
                        phi_413_ = true;
                    }
                    let _e249 = phi_410_;
                    let _e251 = phi_411_;
                    let _e253 = phi_413_;
                    if _e253 {
                        phi_418_ = (_e251 + 1u);
                    } else {
                        phi_418_ = 0u;
                    }
                    let _e257 = phi_418_;
                    let _e258 = select(_e249, _e251, _e253);
                    let _e259 = select(_e244, select(2u, _e244, _e243), _e253);
                    if (_e126 < -126i) {
                        phi_430_ = -126i;
                    } else {
                        phi_430_ = select(_e126, 127i, (_e126 > 127i));
                    }
                    let _e264 = phi_430_;
                    let _e269 = bitcast<f32>((bitcast<u32>((_e264 + 127i)) << bitcast<u32>(23i)));
                    let _e275 = bitcast<f32>((bitcast<u32>(((_e126 - _e264) + 127i)) << bitcast<u32>(23i)));
                    let _e276 = -(_e239);
                    if (_e276 < -126i) {
                        phi_450_ = -126i;
                    } else {
                        phi_450_ = select(_e276, 127i, (_e276 > 127i));
                    }
                    let _e281 = phi_450_;
                    let _e286 = bitcast<f32>((bitcast<u32>((_e281 + 127i)) << bitcast<u32>(23i)));
                    let _e292 = bitcast<f32>((bitcast<u32>(((_e276 - _e281) + 127i)) << bitcast<u32>(23i)));
                    let _e296 = global_4.member[_e144].member;
                    let _e297 = (_e258 == 0u);
                    if _e297 {
                        phi_468_ = _e296[0];
                    } else {
                        phi_468_ = _e296[1];
                    }
                    let _e301 = phi_468_;
                    let _e302 = (_e258 == 2u);
                    if _e302 {
                        phi_474_ = _e296[2];
                    } else {
                        phi_474_ = _e301;
                    }
                    let _e305 = phi_474_;
                    let _e307 = ((_e305 * _e269) * _e275);
                    let _e308 = global_4.member[_e144].member_2;
                    if _e297 {
                        phi_485_ = _e308[0];
                    } else {
                        phi_485_ = _e308[1];
                    }
                    let _e312 = phi_485_;
                    if _e302 {
                        phi_491_ = _e308[2];
                    } else {
                        phi_491_ = _e312;
                    }
                    let _e315 = phi_491_;
                    let _e317 = ((_e315 * _e286) * _e292);
                    let _e321 = (bitcast<f32>((bitcast<u32>(_e317) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e321 {
                        let _e325 = (bitcast<f32>((bitcast<u32>(_e307) & 2147483647u)) * 0.00000011920929f);
                        phi_514_ = select(0.00000000000011368684f, _e325, (_e325 > 0.00000000000011368684f));
                    } else {
                        phi_514_ = 0f;
                    }
                    let _e329 = phi_514_;
                    let _e330 = (_e307 + _e329);
                    let _e331 = (_e307 - _e329);
                    let _e332 = select(_e317, 0f, _e321);
                    if _e321 {
                        phi_525_ = 38685626000000000000000000f;
                    } else {
                        phi_525_ = (1f / _e317);
                    }
                    let _e335 = phi_525_;
                    let _e336 = (_e257 == 0u);
                    if _e336 {
                        phi_534_ = _e296[0];
                    } else {
                        phi_534_ = _e296[1];
                    }
                    let _e340 = phi_534_;
                    let _e341 = (_e257 == 2u);
                    if _e341 {
                        phi_540_ = _e296[2];
                    } else {
                        phi_540_ = _e340;
                    }
                    let _e344 = phi_540_;
                    let _e346 = ((_e344 * _e269) * _e275);
                    if _e336 {
                        phi_551_ = _e308[0];
                    } else {
                        phi_551_ = _e308[1];
                    }
                    let _e350 = phi_551_;
                    if _e341 {
                        phi_557_ = _e308[2];
                    } else {
                        phi_557_ = _e350;
                    }
                    let _e353 = phi_557_;
                    let _e355 = ((_e353 * _e286) * _e292);
                    let _e359 = (bitcast<f32>((bitcast<u32>(_e355) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e359 {
                        let _e363 = (bitcast<f32>((bitcast<u32>(_e346) & 2147483647u)) * 0.00000011920929f);
                        phi_580_ = select(0.00000000000011368684f, _e363, (_e363 > 0.00000000000011368684f));
                    } else {
                        phi_580_ = 0f;
                    }
                    let _e367 = phi_580_;
                    let _e368 = (_e346 + _e367);
                    let _e369 = (_e346 - _e367);
                    let _e370 = select(_e355, 0f, _e359);
                    if _e359 {
                        phi_591_ = 38685626000000000000000000f;
                    } else {
                        phi_591_ = (1f / _e355);
                    }
                    let _e373 = phi_591_;
                    let _e374 = (_e259 == 0u);
                    if _e374 {
                        phi_600_ = _e296[0];
                    } else {
                        phi_600_ = _e296[1];
                    }
                    let _e378 = phi_600_;
                    let _e379 = (_e259 == 2u);
                    if _e379 {
                        phi_606_ = _e296[2];
                    } else {
                        phi_606_ = _e378;
                    }
                    let _e382 = phi_606_;
                    let _e384 = ((_e382 * _e269) * _e275);
                    if _e374 {
                        phi_617_ = _e308[0];
                    } else {
                        phi_617_ = _e308[1];
                    }
                    let _e388 = phi_617_;
                    if _e379 {
                        phi_623_ = _e308[2];
                    } else {
                        phi_623_ = _e388;
                    }
                    let _e391 = phi_623_;
                    let _e393 = ((_e391 * _e286) * _e292);
                    let _e397 = (bitcast<f32>((bitcast<u32>(_e393) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e397 {
                        let _e401 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) * 0.00000011920929f);
                        phi_646_ = select(0.00000000000011368684f, _e401, (_e401 > 0.00000000000011368684f));
                    } else {
                        phi_646_ = 0f;
                    }
                    let _e405 = phi_646_;
                    let _e406 = (_e384 + _e405);
                    let _e407 = (_e384 - _e405);
                    let _e408 = select(_e393, 0f, _e397);
                    if _e397 {
                        phi_657_ = 38685626000000000000000000f;
                    } else {
                        phi_657_ = (1f / _e393);
                    }
                    let _e411 = phi_657_;
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
                        phi_757_ = select(-340282350000000000000000000000000000000f, _e452, (_e452 > -340282350000000000000000000000000000000f));
                        phi_758_ = select(-340282350000000000000000000000000000000f, _e445, (_e445 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_757_ = 0f;
                        phi_758_ = 1f;
                    }
                    let _e456 = phi_757_;
                    let _e458 = phi_758_;
                    local_9 = array<type_21, 8>(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
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
                    phi_3767_ = false;
                    phi_3695_ = _e456;
                    phi_900_ = type_52(type_25(vec4<f32>((f32(_e464) * _e138), (f32(_e470) * _e138), (f32(_e476) * _e138), 0f), vec4<f32>((f32(_e481) * _e138), (f32(_e485) * _e138), (f32(_e489) * _e138), 0f)), select(0u, 2147483648u, (_e88 == 0u)));
                    phi_903_ = ((3u * _e88) + 1u);
                    phi_905_ = (_e458 <= _e456);
                    phi_907_ = 0u;
                    loop {
                        let _e499 = phi_3767_;
                        let _e501 = phi_3695_;
                        let _e503 = phi_900_;
                        let _e505 = phi_903_;
                        let _e507 = phi_905_;
                        let _e509 = phi_907_;
                        if _e507 {
                            phi_918_ = true;
                        } else {
                            phi_918_ = (_e509 > 0u);
                        }
                        let _e512 = phi_918_;
                        if _e512 {
                            let _e513 = (_e505 > 0u);
                            if _e513 {
                                if _e507 {
                                    phi_1005_ = _e503;
                                    phi_1006_ = _e507;
                                    phi_1007_ = _e509;
                                } else {
                                    let _e514 = (_e509 - 1u);
                                    let _e515 = (_e514 % 128u);
                                    let _e516 = (_e515 < 128u);
                                    if _e516 {
                                    } else {
                                        phi_3902_ = true;
                                        break;
                                    }
                                    let _e518 = local_7[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3902_ = true;
                                        break;
                                    }
                                    let _e520 = local_6[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3902_ = true;
                                        break;
                                    }
                                    let _e522 = local_5[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3902_ = true;
                                        break;
                                    }
                                    let _e524 = local_4[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3902_ = true;
                                        break;
                                    }
                                    let _e526 = local_3[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3902_ = true;
                                        break;
                                    }
                                    let _e528 = local_2[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3902_ = true;
                                        break;
                                    }
                                    let _e533 = local_8[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3902_ = true;
                                        break;
                                    }
                                    let _e536 = local_10[_e515];
                                    phi_1005_ = type_52(type_25(vec4<f32>(_e518, _e520, _e522, 0f), vec4<f32>(_e524, _e526, _e528, 0f)), _e533);
                                    phi_1006_ = (_e536 <= _e501);
                                    phi_1007_ = _e514;
                                }
                                let _e539 = phi_1005_;
                                let _e541 = phi_1006_;
                                let _e543 = phi_1007_;
                                if _e541 {
                                    if ((_e539.member_1 & 2147483648u) != 0u) {
                                        phi_3764_ = _e499;
                                        phi_3754_ = _e501;
                                        phi_1025_ = type_4(0u, ((_e539.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1004 = phi_3764_;
                                            let _e1006 = phi_3754_;
                                            let _e1008 = phi_1025_;
                                            if (_e1008.member < _e1008.member_1) {
                                                phi_1026_ = type_4((_e1008.member + 1u), _e1008.member_1);
                                                phi_1049_ = type_4(1u, _e1008.member);
                                            } else {
                                                phi_1026_ = _e1008;
                                                phi_1049_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1021 = phi_1026_;
                                            let _e1023 = phi_1049_;
                                            let _e1027 = (bitcast<i32>(_e1023.member) != 0i);
                                            if _e1027 {
                                                let _e1028 = ((_e539.member_1 & 268435455u) + _e1023.member_1);
                                                let _e1029 = (_e1028 < _e90);
                                                if _e1029 {
                                                    if _e1029 {
                                                    } else {
                                                        phi_4039_ = _e1006;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1033 = global_2.member[_e1028].member_1;
                                                    phi_1070_ = _e1033;
                                                } else {
                                                    phi_1070_ = 4294967295u;
                                                }
                                                let _e1035 = phi_1070_;
                                                if (_e1028 >= _e90) {
                                                    phi_1159_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1029 {
                                                    } else {
                                                        phi_4039_ = _e1006;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    if (_e461 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e1006;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1042 = global_2.member[_e1028].member[_e461];
                                                    if (_e467 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e1006;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1048 = global_2.member[_e1028].member[_e467];
                                                    if (_e473 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e1006;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1054 = global_2.member[_e1028].member[_e473];
                                                    let _e1056 = (3u + _e461);
                                                    if (_e1056 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e1006;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1062 = global_2.member[_e1028].member[_e1056];
                                                    let _e1063 = (3u + _e467);
                                                    if (_e1063 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e1006;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1069 = global_2.member[_e1028].member[_e1063];
                                                    let _e1070 = (3u + _e473);
                                                    if (_e1070 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e1006;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1076 = global_2.member[_e1028].member[_e1070];
                                                    let _e1078 = (6u + _e461);
                                                    if (_e1078 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e1006;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1084 = global_2.member[_e1028].member[_e1078];
                                                    let _e1085 = (6u + _e467);
                                                    if (_e1085 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e1006;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1091 = global_2.member[_e1028].member[_e1085];
                                                    let _e1092 = (6u + _e473);
                                                    if (_e1092 < 9u) {
                                                    } else {
                                                        phi_4039_ = _e1006;
                                                        phi_3897_ = true;
                                                        break;
                                                    }
                                                    let _e1098 = global_2.member[_e1028].member[_e1092];
                                                    phi_1159_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1042, _e1048, _e1054), array<f32, 3>(_e1062, _e1069, _e1076), array<f32, 3>(_e1084, _e1091, _e1098));
                                                }
                                                let _e1102 = phi_1159_;
                                                let _e1109 = (_e1102[0][2] - _e384);
                                                let _e1112 = (((_e1102[0][0] - _e307) * _e408) - (_e1109 * _e332));
                                                let _e1115 = (((_e1102[0][1] - _e346) * _e408) - (_e1109 * _e370));
                                                let _e1122 = (_e1102[1][2] - _e384);
                                                let _e1125 = (((_e1102[1][0] - _e307) * _e408) - (_e1122 * _e332));
                                                let _e1128 = (((_e1102[1][1] - _e346) * _e408) - (_e1122 * _e370));
                                                let _e1135 = (_e1102[2][2] - _e384);
                                                let _e1138 = (((_e1102[2][0] - _e307) * _e408) - (_e1135 * _e332));
                                                let _e1141 = (((_e1102[2][1] - _e346) * _e408) - (_e1135 * _e370));
                                                let _e1142 = (_e1138 * _e1128);
                                                let _e1143 = (_e1141 * _e1125);
                                                let _e1144 = (_e1112 * _e1141);
                                                let _e1145 = (_e1115 * _e1138);
                                                let _e1146 = (_e1125 * _e1115);
                                                let _e1147 = (_e1128 * _e1112);
                                                let _e1152 = (((_e1142 >= _e1143) && (_e1144 >= _e1145)) && (_e1146 >= _e1147));
                                                if (_e1152 || (((_e1142 <= _e1143) && (_e1144 <= _e1145)) && (_e1146 <= _e1147))) {
                                                    let _e1159 = select(-1f, 1f, _e1152);
                                                    let _e1161 = ((_e1142 - _e1143) * _e1159);
                                                    let _e1163 = select(0f, _e1161, (_e1161 > 0f));
                                                    let _e1165 = ((_e1144 - _e1145) * _e1159);
                                                    let _e1167 = select(0f, _e1165, (_e1165 > 0f));
                                                    let _e1169 = ((_e1146 - _e1147) * _e1159);
                                                    let _e1171 = select(0f, _e1169, (_e1169 > 0f));
                                                    let _e1173 = ((_e1163 + _e1167) + _e1171);
                                                    if (_e1173 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1988_ = type_21();
                                                        phi_1989_ = true;
                                                        phi_1990_ = false;
                                                    } else {
                                                        let _e1176 = select(_e1125, _e1112, (_e1112 < _e1125));
                                                        if (select(_e1138, _e1176, (_e1176 < _e1138)) > 0f) {
                                                            phi_1277_ = true;
                                                        } else {
                                                            let _e1181 = select(_e1125, _e1112, (_e1112 > _e1125));
                                                            phi_1277_ = (select(_e1138, _e1181, (_e1181 > _e1138)) < 0f);
                                                        }
                                                        let _e1186 = phi_1277_;
                                                        if _e1186 {
                                                            phi_1985_ = type_21();
                                                            phi_1986_ = true;
                                                            phi_1987_ = false;
                                                        } else {
                                                            let _e1188 = select(_e1128, _e1115, (_e1115 < _e1128));
                                                            if (select(_e1141, _e1188, (_e1188 < _e1141)) > 0f) {
                                                                phi_1306_ = true;
                                                            } else {
                                                                let _e1193 = select(_e1128, _e1115, (_e1115 > _e1128));
                                                                phi_1306_ = (select(_e1141, _e1193, (_e1193 > _e1141)) < 0f);
                                                            }
                                                            let _e1198 = phi_1306_;
                                                            if _e1198 {
                                                                phi_1983_ = type_21();
                                                                phi_1984_ = false;
                                                            } else {
                                                                let _e1200 = select(_e1102[1][0], _e1102[0][0], (_e1102[0][0] < _e1102[1][0]));
                                                                let _e1204 = select(_e1102[1][0], _e1102[0][0], (_e1102[0][0] > _e1102[1][0]));
                                                                let _e1208 = select(_e1102[1][1], _e1102[0][1], (_e1102[0][1] < _e1102[1][1]));
                                                                let _e1212 = select(_e1102[1][1], _e1102[0][1], (_e1102[0][1] > _e1102[1][1]));
                                                                let _e1216 = select(_e1102[1][2], _e1102[0][2], (_e1102[0][2] < _e1102[1][2]));
                                                                let _e1220 = select(_e1102[1][2], _e1102[0][2], (_e1102[0][2] > _e1102[1][2]));
                                                                let _e1225 = ((select(_e1102[2][0], _e1200, (_e1200 < _e1102[2][0])) - _e330) * _e335);
                                                                let _e1226 = ((select(_e1102[2][0], _e1204, (_e1204 > _e1102[2][0])) - _e331) * _e335);
                                                                let _e1229 = ((select(_e1102[2][1], _e1208, (_e1208 < _e1102[2][1])) - _e368) * _e373);
                                                                let _e1230 = ((select(_e1102[2][1], _e1212, (_e1212 > _e1102[2][1])) - _e369) * _e373);
                                                                let _e1233 = ((select(_e1102[2][2], _e1216, (_e1216 < _e1102[2][2])) - _e406) * _e411);
                                                                let _e1234 = ((select(_e1102[2][2], _e1220, (_e1220 > _e1102[2][2])) - _e407) * _e411);
                                                                let _e1236 = select(_e1234, _e1233, (_e1233 < _e1234));
                                                                let _e1238 = select(_e1234, _e1233, (_e1233 > _e1234));
                                                                let _e1240 = select(_e1226, _e1225, (_e1225 < _e1226));
                                                                let _e1242 = select(_e1230, _e1229, (_e1229 < _e1230));
                                                                let _e1244 = select(_e1242, _e1240, (_e1240 > _e1242));
                                                                let _e1246 = select(_e1236, _e1244, (_e1244 > _e1236));
                                                                let _e1248 = select(_e1226, _e1225, (_e1225 > _e1226));
                                                                let _e1250 = select(_e1230, _e1229, (_e1229 > _e1230));
                                                                let _e1252 = select(_e1250, _e1248, (_e1248 < _e1250));
                                                                let _e1254 = select(_e1238, _e1252, (_e1252 < _e1238));
                                                                let _e1255 = -(_e1236);
                                                                let _e1261 = select(_e458, _e1246, (_e1246 > _e458));
                                                                if (_e1261 > (_e1254 + (select(_e1255, _e1238, (_e1238 > _e1255)) * 0.0000019073523f))) {
                                                                    phi_1978_ = type_21();
                                                                    phi_1979_ = true;
                                                                } else {
                                                                    let _e1263 = (_e1261 > _e1006);
                                                                    if _e1263 {
                                                                        phi_1977_ = type_21();
                                                                    } else {
                                                                        let _e1264 = vec3<f32>(_e1102[0][0], _e1102[0][1], _e1102[0][2]);
                                                                        let _e1265 = vec3<f32>(_e1102[1][0], _e1102[1][1], _e1102[1][2]);
                                                                        let _e1266 = vec3<f32>(_e1102[2][0], _e1102[2][1], _e1102[2][2]);
                                                                        let _e1267 = (_e1102[1][0] - _e1102[0][0]);
                                                                        let _e1268 = (_e1102[1][1] - _e1102[0][1]);
                                                                        let _e1269 = (_e1102[1][2] - _e1102[0][2]);
                                                                        let _e1270 = vec3<f32>(_e1267, _e1268, _e1269);
                                                                        let _e1271 = (_e1102[2][0] - _e1102[1][0]);
                                                                        let _e1272 = (_e1102[2][1] - _e1102[1][1]);
                                                                        let _e1273 = (_e1102[2][2] - _e1102[1][2]);
                                                                        let _e1274 = vec3<f32>(_e1271, _e1272, _e1273);
                                                                        let _e1275 = (_e1102[0][0] - _e1102[2][0]);
                                                                        let _e1276 = (_e1102[0][1] - _e1102[2][1]);
                                                                        let _e1277 = (_e1102[0][2] - _e1102[2][2]);
                                                                        let _e1278 = vec3<f32>(_e1275, _e1276, _e1277);
                                                                        let _e1281 = bitcast<f32>((bitcast<u32>(_e1267) & 2147483647u));
                                                                        let _e1284 = bitcast<f32>((bitcast<u32>(_e1268) & 2147483647u));
                                                                        let _e1286 = select(_e1284, _e1281, (_e1281 > _e1284));
                                                                        let _e1289 = bitcast<f32>((bitcast<u32>(_e1269) & 2147483647u));
                                                                        let _e1291 = select(_e1289, _e1286, (_e1286 > _e1289));
                                                                        let _e1294 = bitcast<f32>((bitcast<u32>(_e1271) & 2147483647u));
                                                                        let _e1297 = bitcast<f32>((bitcast<u32>(_e1272) & 2147483647u));
                                                                        let _e1299 = select(_e1297, _e1294, (_e1294 > _e1297));
                                                                        let _e1302 = bitcast<f32>((bitcast<u32>(_e1273) & 2147483647u));
                                                                        let _e1304 = select(_e1302, _e1299, (_e1299 > _e1302));
                                                                        let _e1307 = bitcast<f32>((bitcast<u32>(_e1275) & 2147483647u));
                                                                        let _e1310 = bitcast<f32>((bitcast<u32>(_e1276) & 2147483647u));
                                                                        let _e1312 = select(_e1310, _e1307, (_e1307 > _e1310));
                                                                        let _e1315 = bitcast<f32>((bitcast<u32>(_e1277) & 2147483647u));
                                                                        let _e1317 = select(_e1315, _e1312, (_e1312 > _e1315));
                                                                        let _e1319 = select(_e1304, _e1291, (_e1291 > _e1304));
                                                                        let _e1321 = select(_e1317, _e1319, (_e1319 > _e1317));
                                                                        if (_e1291 == _e1321) {
                                                                            phi_1707_ = _e1128;
                                                                            phi_1708_ = _e1125;
                                                                            phi_1709_ = _e1115;
                                                                            phi_1710_ = _e1112;
                                                                            phi_1711_ = _e1264;
                                                                            phi_1712_ = _e1278;
                                                                            phi_1713_ = _e1274;
                                                                            phi_1714_ = _e1270;
                                                                        } else {
                                                                            let _e1323 = (_e1304 == _e1321);
                                                                            let _e1328 = vec3(_e1323);
                                                                            phi_1707_ = select(_e1115, _e1141, _e1323);
                                                                            phi_1708_ = select(_e1112, _e1138, _e1323);
                                                                            phi_1709_ = select(_e1141, _e1128, _e1323);
                                                                            phi_1710_ = select(_e1138, _e1125, _e1323);
                                                                            phi_1711_ = select(_e1266, _e1265, _e1328);
                                                                            phi_1712_ = select(_e1274, _e1270, _e1328);
                                                                            phi_1713_ = select(_e1270, _e1278, _e1328);
                                                                            phi_1714_ = select(_e1278, _e1274, _e1328);
                                                                        }
                                                                        let _e1334 = phi_1707_;
                                                                        let _e1336 = phi_1708_;
                                                                        let _e1338 = phi_1709_;
                                                                        let _e1340 = phi_1710_;
                                                                        let _e1342 = phi_1711_;
                                                                        let _e1344 = phi_1712_;
                                                                        let _e1346 = phi_1713_;
                                                                        let _e1348 = phi_1714_;
                                                                        let _e1355 = ((_e1346.y * _e1344.z) - (_e1344.y * _e1346.z));
                                                                        let _e1360 = ((_e1346.z * _e1344.x) - (_e1344.z * _e1346.x));
                                                                        let _e1363 = ((_e1346.x * _e1344.y) - (_e1344.x * _e1346.y));
                                                                        if (_e1163 >= _e1167) {
                                                                            phi_1745_ = select(true, false, (_e1163 >= _e1171));
                                                                        } else {
                                                                            phi_1745_ = true;
                                                                        }
                                                                        let _e1368 = phi_1745_;
                                                                        if _e1368 {
                                                                            phi_1754_ = select(_e1266, _e1265, vec3((_e1167 >= _e1171)));
                                                                        } else {
                                                                            phi_1754_ = _e1264;
                                                                        }
                                                                        let _e1373 = phi_1754_;
                                                                        let _e1378 = (((_e1355 * _e332) + (_e1360 * _e370)) + (_e1363 * _e408));
                                                                        let _e1389 = (((_e1355 * (_e1373.x - _e307)) + (_e1360 * (_e1373.y - _e346))) + (_e1363 * (_e1373.z - _e384)));
                                                                        let _e1391 = (_e1336 - _e1340);
                                                                        let _e1392 = (_e1334 - _e1338);
                                                                        let _e1400 = (-(((_e1340 * _e1391) + (_e1338 * _e1392))) / ((_e1391 * _e1391) + (_e1392 * _e1392)));
                                                                        let _e1402 = select(1f, _e1400, (_e1400 < 1f));
                                                                        let _e1404 = select(0f, _e1402, (_e1402 > 0f));
                                                                        let _e1417 = ((_e1342.x + (_e1348.x * _e1404)) - _e307);
                                                                        let _e1418 = ((_e1342.y + (_e1348.y * _e1404)) - _e346);
                                                                        let _e1419 = ((_e1342.z + (_e1348.z * _e1404)) - _e384);
                                                                        let _e1420 = (_e1419 / _e408);
                                                                        let _e1432 = bitcast<f32>((bitcast<u32>(_e1417) & 2147483647u));
                                                                        let _e1435 = bitcast<f32>((bitcast<u32>(_e1418) & 2147483647u));
                                                                        let _e1437 = select(_e1435, _e1432, (_e1432 > _e1435));
                                                                        let _e1440 = bitcast<f32>((bitcast<u32>(_e1419) & 2147483647u));
                                                                        let _e1442 = select(_e1440, _e1437, (_e1437 > _e1440));
                                                                        let _e1448 = bitcast<f32>((bitcast<u32>(_e1355) & 2147483647u));
                                                                        let _e1451 = bitcast<f32>((bitcast<u32>(_e1360) & 2147483647u));
                                                                        let _e1453 = select(_e1451, _e1448, (_e1448 > _e1451));
                                                                        let _e1456 = bitcast<f32>((bitcast<u32>(_e1363) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1355 * _e1417) + (_e1360 * _e1418)) + (_e1363 * _e1419)) - _e1389)) & 2147483647u)) <= ((0.0000009536743f * select(_e1321, _e1442, (_e1442 > _e1321))) * select(_e1456, _e1453, (_e1453 > _e1456)))) {
                                                                            let _e1466 = bitcast<f32>((bitcast<u32>(_e1346.x) & 2147483647u));
                                                                            let _e1469 = bitcast<f32>((bitcast<u32>(_e1346.y) & 2147483647u));
                                                                            let _e1471 = select(_e1469, _e1466, (_e1466 > _e1469));
                                                                            let _e1474 = bitcast<f32>((bitcast<u32>(_e1346.z) & 2147483647u));
                                                                            let _e1480 = bitcast<f32>((bitcast<u32>(_e1344.x) & 2147483647u));
                                                                            let _e1483 = bitcast<f32>((bitcast<u32>(_e1344.y) & 2147483647u));
                                                                            let _e1485 = select(_e1483, _e1480, (_e1480 > _e1483));
                                                                            let _e1488 = bitcast<f32>((bitcast<u32>(_e1344.z) & 2147483647u));
                                                                            phi_1921_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1378) & 2147483647u)) > ((0.0000038146973f * select(_e1474, _e1471, (_e1471 > _e1474))) * select(_e1488, _e1485, (_e1485 > _e1488)))));
                                                                        } else {
                                                                            phi_1921_ = true;
                                                                        }
                                                                        let _e1495 = phi_1921_;
                                                                        if _e1495 {
                                                                            let _e1506 = ((((_e1355 * (_e1417 - (_e332 * _e1420))) + (_e1360 * (_e1418 - (_e370 * _e1420)))) + (_e1363 * (_e1419 - _e1419))) / _e1378);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1506) & 2147483647u)) <= _e1321) {
                                                                                phi_1945_ = (_e1420 + _e1506);
                                                                            } else {
                                                                                phi_1945_ = _e1420;
                                                                            }
                                                                            let _e1513 = phi_1945_;
                                                                            phi_1946_ = _e1513;
                                                                        } else {
                                                                            phi_1946_ = (_e1389 / _e1378);
                                                                        }
                                                                        let _e1515 = phi_1946_;
                                                                        let _e1517 = select(_e1254, _e1515, (_e1515 < _e1254));
                                                                        let _e1519 = select(_e1246, _e1517, (_e1517 > _e1246));
                                                                        if (_e1519 >= _e458) {
                                                                            let _e1521 = (_e1519 <= _e1006);
                                                                            if _e1521 {
                                                                                let _e1522 = (1f / _e1173);
                                                                                phi_1969_ = type_21(_e1519, (_e1167 * _e1522), (_e1171 * _e1522), _e1035);
                                                                            } else {
                                                                                phi_1969_ = type_21();
                                                                            }
                                                                            let _e1527 = phi_1969_;
                                                                            phi_1971_ = _e1527;
                                                                            phi_1972_ = select(true, false, _e1521);
                                                                        } else {
                                                                            phi_1971_ = type_21();
                                                                            phi_1972_ = true;
                                                                        }
                                                                        let _e1530 = phi_1971_;
                                                                        let _e1532 = phi_1972_;
                                                                        if _e1532 {
                                                                            phi_1976_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1976_ = _e1530;
                                                                        }
                                                                        let _e1534 = phi_1976_;
                                                                        phi_1977_ = _e1534;
                                                                    }
                                                                    let _e1536 = phi_1977_;
                                                                    phi_1978_ = _e1536;
                                                                    phi_1979_ = _e1263;
                                                                }
                                                                let _e1538 = phi_1978_;
                                                                let _e1540 = phi_1979_;
                                                                phi_1983_ = _e1538;
                                                                phi_1984_ = _e1540;
                                                            }
                                                            let _e1542 = phi_1983_;
                                                            let _e1544 = phi_1984_;
                                                            phi_1985_ = _e1542;
                                                            phi_1986_ = _e1198;
                                                            phi_1987_ = _e1544;
                                                        }
                                                        let _e1546 = phi_1985_;
                                                        let _e1548 = phi_1986_;
                                                        let _e1550 = phi_1987_;
                                                        phi_1988_ = _e1546;
                                                        phi_1989_ = _e1548;
                                                        phi_1990_ = _e1550;
                                                    }
                                                    let _e1552 = phi_1988_;
                                                    let _e1554 = phi_1989_;
                                                    let _e1556 = phi_1990_;
                                                    phi_1998_ = _e1552;
                                                    phi_1999_ = select(_e1556, true, _e1554);
                                                } else {
                                                    phi_1998_ = type_21();
                                                    phi_1999_ = true;
                                                }
                                                let _e1559 = phi_1998_;
                                                let _e1561 = phi_1999_;
                                                if _e1561 {
                                                    phi_2003_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2003_ = _e1559;
                                                }
                                                let _e1563 = phi_2003_;
                                                if (_e1563.member_3 != 4294967295u) {
                                                    if (_e1035 != 4294967295u) {
                                                        phi_2015_ = type_4(0u, 8u);
                                                        phi_2018_ = _e1563;
                                                        loop {
                                                            let _e1568 = phi_2015_;
                                                            let _e1570 = phi_2018_;
                                                            if (_e1568.member < _e1568.member_1) {
                                                                phi_2016_ = type_4((_e1568.member + 1u), _e1568.member_1);
                                                                phi_2041_ = type_4(1u, _e1568.member);
                                                            } else {
                                                                phi_2016_ = _e1568;
                                                                phi_2041_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1583 = phi_2016_;
                                                            let _e1585 = phi_2041_;
                                                            let _e1589 = (bitcast<i32>(_e1585.member) != 0i);
                                                            if _e1589 {
                                                                let _e1590 = (_e1585.member_1 < 8u);
                                                                if _e1590 {
                                                                } else {
                                                                    phi_3755_ = true;
                                                                    break;
                                                                }
                                                                let _e1595 = local_9[_e1585.member_1].member;
                                                                if (_e1570.member < _e1595) {
                                                                    phi_2074_ = true;
                                                                } else {
                                                                    let _e1597 = local_9[_e1585.member_1].member;
                                                                    if (_e1570.member == _e1597) {
                                                                        let _e1602 = local_9[_e1585.member_1].member_3;
                                                                        phi_2073_ = (_e1570.member_3 < _e1602);
                                                                    } else {
                                                                        phi_2073_ = false;
                                                                    }
                                                                    let _e1605 = phi_2073_;
                                                                    phi_2074_ = _e1605;
                                                                }
                                                                let _e1607 = phi_2074_;
                                                                if _e1607 {
                                                                    if _e1590 {
                                                                    } else {
                                                                        phi_3755_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1608 = local_9[_e1585.member_1];
                                                                    local_9[_e1585.member_1] = type_21(_e1570.member, _e1570.member_1, _e1570.member_2, _e1570.member_3);
                                                                    phi_2095_ = type_21(_e1608.member, _e1608.member_1, _e1608.member_2, _e1608.member_3);
                                                                } else {
                                                                    phi_2095_ = _e1570;
                                                                }
                                                                let _e1619 = phi_2095_;
                                                                phi_2019_ = _e1619;
                                                            } else {
                                                                phi_2019_ = type_21();
                                                            }
                                                            let _e1621 = phi_2019_;
                                                            continue;
                                                            continuing {
                                                                phi_2015_ = _e1583;
                                                                phi_2018_ = _e1621;
                                                                phi_3755_ = _e1004;
                                                                break if !(_e1589);
                                                            }
                                                        }
                                                        let _e1624 = phi_3755_;
                                                        phi_4039_ = _e1006;
                                                        phi_3897_ = _e1624;
                                                        if _e1624 {
                                                            break;
                                                        }
                                                        let _e1627 = local_9[7u].member_3;
                                                        if (_e1627 != 4294967295u) {
                                                            let _e1631 = local_9[7u].member;
                                                            phi_4130_ = _e1631;
                                                        } else {
                                                            phi_4130_ = _e1006;
                                                        }
                                                        let _e1633 = phi_4130_;
                                                        phi_4129_ = _e1633;
                                                        phi_3900_ = _e1624;
                                                    } else {
                                                        phi_4129_ = _e1006;
                                                        phi_3900_ = _e1004;
                                                    }
                                                    let _e1635 = phi_4129_;
                                                    let _e1637 = phi_3900_;
                                                    phi_4128_ = _e1635;
                                                    phi_3899_ = _e1637;
                                                } else {
                                                    phi_4128_ = _e1006;
                                                    phi_3899_ = _e1004;
                                                }
                                                let _e1639 = phi_4128_;
                                                let _e1641 = phi_3899_;
                                                phi_4127_ = _e1639;
                                                phi_3898_ = _e1641;
                                            } else {
                                                phi_4127_ = _e1006;
                                                phi_3898_ = _e1004;
                                            }
                                            let _e1643 = phi_4127_;
                                            let _e1645 = phi_3898_;
                                            continue;
                                            continuing {
                                                phi_3764_ = _e1645;
                                                phi_3754_ = _e1643;
                                                phi_1025_ = _e1021;
                                                phi_4039_ = _e1643;
                                                phi_3897_ = _e1645;
                                                break if !(_e1027);
                                            }
                                        }
                                        let _e1648 = phi_4039_;
                                        let _e1650 = phi_3897_;
                                        phi_3902_ = _e1650;
                                        if _e1650 {
                                            break;
                                        }
                                        phi_4004_ = _e1648;
                                        phi_3906_ = _e1650;
                                        phi_3312_ = _e539;
                                        phi_3313_ = false;
                                        phi_3314_ = _e543;
                                    } else {
                                        if (_e539.member_1 >= _e88) {
                                            phi_2867_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e539.member_1 < _e88) {
                                            } else {
                                                phi_3902_ = true;
                                                break;
                                            }
                                            let _e554 = (_e258 * 2u);
                                            let _e556 = ((1u + _e554) % 7u);
                                            if (_e556 < 7u) {
                                            } else {
                                                phi_3902_ = true;
                                                break;
                                            }
                                            let _e561 = global_5.member[_e539.member_1][_e556];
                                            let _e563 = ((_e554 + 2u) % 7u);
                                            if (_e563 < 7u) {
                                            } else {
                                                phi_3902_ = true;
                                                break;
                                            }
                                            let _e568 = global_5.member[_e539.member_1][_e563];
                                            let _e569 = (_e257 * 2u);
                                            let _e571 = ((1u + _e569) % 7u);
                                            if (_e571 < 7u) {
                                            } else {
                                                phi_3902_ = true;
                                                break;
                                            }
                                            let _e576 = global_5.member[_e539.member_1][_e571];
                                            let _e578 = ((_e569 + 2u) % 7u);
                                            if (_e578 < 7u) {
                                            } else {
                                                phi_3902_ = true;
                                                break;
                                            }
                                            let _e583 = global_5.member[_e539.member_1][_e578];
                                            let _e584 = (_e259 * 2u);
                                            let _e586 = ((1u + _e584) % 7u);
                                            if (_e586 < 7u) {
                                            } else {
                                                phi_3902_ = true;
                                                break;
                                            }
                                            let _e591 = global_5.member[_e539.member_1][_e586];
                                            let _e593 = ((_e584 + 2u) % 7u);
                                            if (_e593 < 7u) {
                                            } else {
                                                phi_3902_ = true;
                                                break;
                                            }
                                            let _e598 = global_5.member[_e539.member_1][_e593];
                                            let _e621 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.x - _e539.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e622 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.y - _e539.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e623 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.z - _e539.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e625 = select(_e138, _e621, (_e621 > _e138));
                                            let _e627 = select(_e138, _e622, (_e622 > _e138));
                                            let _e629 = select(_e138, _e623, (_e623 > _e138));
                                            let _e654 = bitcast<u32>((f32(bitcast<i32>((_e561 & 2097151u))) * _e625));
                                            let _e659 = (bitcast<i32>((_e561 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e662 = bitcast<f32>((_e654 & bitcast<u32>(_e659)));
                                            let _e663 = bitcast<u32>((f32(bitcast<i32>((_e576 & 2097151u))) * _e627));
                                            let _e668 = (bitcast<i32>((_e576 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e671 = bitcast<f32>((_e663 & bitcast<u32>(_e668)));
                                            let _e672 = bitcast<u32>((f32(bitcast<i32>((_e591 & 2097151u))) * _e629));
                                            let _e677 = (bitcast<i32>((_e591 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e680 = bitcast<f32>((_e672 & bitcast<u32>(_e677)));
                                            let _e684 = bitcast<f32>((_e654 & bitcast<u32>(~(_e659))));
                                            let _e688 = bitcast<f32>((_e663 & bitcast<u32>(~(_e668))));
                                            let _e692 = bitcast<f32>((_e672 & bitcast<u32>(~(_e677))));
                                            let _e693 = bitcast<u32>((f32(bitcast<i32>((_e568 & 2097151u))) * _e625));
                                            let _e698 = (bitcast<i32>((_e568 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e701 = bitcast<f32>((_e693 & bitcast<u32>(_e698)));
                                            let _e702 = bitcast<u32>((f32(bitcast<i32>((_e583 & 2097151u))) * _e627));
                                            let _e707 = (bitcast<i32>((_e583 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e710 = bitcast<f32>((_e702 & bitcast<u32>(_e707)));
                                            let _e711 = bitcast<u32>((f32(bitcast<i32>((_e598 & 2097151u))) * _e629));
                                            let _e716 = (bitcast<i32>((_e598 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e719 = bitcast<f32>((_e711 & bitcast<u32>(_e716)));
                                            let _e723 = bitcast<f32>((_e693 & bitcast<u32>(~(_e698))));
                                            let _e727 = bitcast<f32>((_e702 & bitcast<u32>(~(_e707))));
                                            let _e731 = bitcast<f32>((_e711 & bitcast<u32>(~(_e716))));
                                            let _e761 = global_5.member[_e539.member_1][0u];
                                            let _e765 = global_5.member[_e539.member_1][2u];
                                            let _e769 = global_5.member[_e539.member_1][4u];
                                            let _e773 = global_5.member[_e539.member_1][6u];
                                            let _e785 = (((_e765 >> bitcast<u32>(22i)) | ((_e769 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e773 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e786 = (_e761 & 268435455u);
                                            let _e787 = (_e785 & 268435455u);
                                            let _e790 = ((_e761 >> bitcast<u32>(28u)) & 7u);
                                            let _e798 = ((_e761 >> bitcast<u32>(31i)) | (((_e785 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e799 = (_e790 != 0u);
                                            if (_e790 == 0u) {
                                                phi_2829_ = _e786;
                                            } else {
                                                if (_e790 == 7u) {
                                                    phi_2828_ = 2147483648u;
                                                } else {
                                                    phi_2828_ = ((2147483648u | (_e790 << bitcast<u32>(28u))) | (_e787 & 268435455u));
                                                }
                                                let _e808 = phi_2828_;
                                                phi_2829_ = _e808;
                                            }
                                            let _e810 = phi_2829_;
                                            if _e799 {
                                                let _e811 = (_e790 != 7u);
                                                if _e811 {
                                                    phi_2839_ = (_e787 + _e790);
                                                } else {
                                                    phi_2839_ = u32();
                                                }
                                                let _e814 = phi_2839_;
                                                phi_2841_ = _e814;
                                                phi_2842_ = select(true, false, _e811);
                                            } else {
                                                phi_2841_ = u32();
                                                phi_2842_ = true;
                                            }
                                            let _e817 = phi_2841_;
                                            let _e819 = phi_2842_;
                                            if (_e798 == 0u) {
                                                phi_2863_ = (_e786 + select(0u, 1u, !(_e799)));
                                            } else {
                                                if (_e798 == 7u) {
                                                    phi_2862_ = 2147483648u;
                                                } else {
                                                    phi_2862_ = ((2147483648u | (_e798 << bitcast<u32>(28u))) | (select(_e817, _e787, _e819) & 268435455u));
                                                }
                                                let _e832 = phi_2862_;
                                                phi_2863_ = _e832;
                                            }
                                            let _e834 = phi_2863_;
                                            phi_2867_ = type_53(array<vec4<f32>, 3>(vec4<f32>((_e539.member.member.x + _e662), (_e539.member.member.x + _e684), (_e539.member.member_1.x - _e701), (_e539.member.member_1.x - _e723)), vec4<f32>((_e539.member.member.y + _e671), (_e539.member.member.y + _e688), (_e539.member.member_1.y - _e710), (_e539.member.member_1.y - _e727)), vec4<f32>((_e539.member.member.z + _e680), (_e539.member.member.z + _e692), (_e539.member.member_1.z - _e719), (_e539.member.member_1.z - _e731))), type_52(type_25((_e539.member.member + vec4<f32>(_e662, _e671, _e680, 0f)), (_e539.member.member_1 - vec4<f32>(_e701, _e710, _e719, 0f))), _e810), type_52(type_25((_e539.member.member + vec4<f32>(_e684, _e688, _e692, 0f)), (_e539.member.member_1 - vec4<f32>(_e723, _e727, _e731, 0f))), _e834));
                                        }
                                        let _e839 = phi_2867_;
                                        let _e850 = ((_e839.member[0].x - _e330) * _e335);
                                        let _e851 = ((_e839.member[0].y - _e330) * _e335);
                                        let _e852 = ((_e839.member[0].z - _e331) * _e335);
                                        let _e853 = ((_e839.member[0].w - _e331) * _e335);
                                        let _e863 = ((_e839.member[1].x - _e368) * _e373);
                                        let _e864 = ((_e839.member[1].y - _e368) * _e373);
                                        let _e865 = ((_e839.member[1].z - _e369) * _e373);
                                        let _e866 = ((_e839.member[1].w - _e369) * _e373);
                                        let _e876 = ((_e839.member[2].x - _e406) * _e411);
                                        let _e877 = ((_e839.member[2].y - _e406) * _e411);
                                        let _e878 = ((_e839.member[2].z - _e407) * _e411);
                                        let _e879 = ((_e839.member[2].w - _e407) * _e411);
                                        let _e881 = select(_e878, _e876, (_e876 < _e878));
                                        let _e883 = select(_e879, _e877, (_e877 < _e879));
                                        let _e885 = select(_e878, _e876, (_e876 > _e878));
                                        let _e887 = select(_e879, _e877, (_e877 > _e879));
                                        let _e889 = select(_e852, _e850, (_e850 < _e852));
                                        let _e891 = select(_e853, _e851, (_e851 < _e853));
                                        let _e893 = select(_e865, _e863, (_e863 < _e865));
                                        let _e895 = select(_e866, _e864, (_e864 < _e866));
                                        let _e897 = select(_e893, _e889, (_e889 > _e893));
                                        let _e899 = select(_e895, _e891, (_e891 > _e895));
                                        let _e901 = select(_e881, _e897, (_e897 > _e881));
                                        let _e903 = select(_e883, _e899, (_e899 > _e883));
                                        let _e905 = select(_e852, _e850, (_e850 > _e852));
                                        let _e907 = select(_e853, _e851, (_e851 > _e853));
                                        let _e909 = select(_e865, _e863, (_e863 > _e865));
                                        let _e911 = select(_e866, _e864, (_e864 > _e866));
                                        let _e913 = select(_e909, _e905, (_e905 < _e909));
                                        let _e915 = select(_e911, _e907, (_e907 < _e911));
                                        let _e920 = -(_e881);
                                        let _e921 = -(_e883);
                                        let _e928 = (select(_e885, _e913, (_e913 < _e885)) + (select(_e920, _e885, (_e885 > _e920)) * 0.0000019073523f));
                                        let _e929 = (select(_e887, _e915, (_e915 < _e887)) + (select(_e921, _e887, (_e887 > _e921)) * 0.0000019073523f));
                                        let _e931 = select(_e458, _e901, (_e901 > _e458));
                                        let _e933 = select(_e458, _e903, (_e903 > _e458));
                                        let _e938 = (_e931 <= select(_e501, _e928, (_e928 < _e501)));
                                        let _e939 = (_e933 <= select(_e501, _e929, (_e929 < _e501)));
                                        let _e940 = (_e931 <= _e933);
                                        if _e938 {
                                            if _e939 {
                                                if _e940 {
                                                    phi_3212_ = _e839.member_2;
                                                } else {
                                                    phi_3212_ = _e839.member_1;
                                                }
                                                let _e944 = phi_3212_;
                                                let _e966 = (_e543 % 128u);
                                                let _e967 = (_e966 < 128u);
                                                if _e967 {
                                                } else {
                                                    phi_3902_ = true;
                                                    break;
                                                }
                                                local_8[_e966] = _e944.member_1;
                                                if _e967 {
                                                } else {
                                                    phi_3902_ = true;
                                                    break;
                                                }
                                                local_7[_e966] = _e944.member.member.x;
                                                if _e967 {
                                                } else {
                                                    phi_3902_ = true;
                                                    break;
                                                }
                                                local_6[_e966] = _e944.member.member.y;
                                                if _e967 {
                                                } else {
                                                    phi_3902_ = true;
                                                    break;
                                                }
                                                local_5[_e966] = _e944.member.member.z;
                                                if _e967 {
                                                } else {
                                                    phi_3902_ = true;
                                                    break;
                                                }
                                                local_4[_e966] = _e944.member.member_1.x;
                                                if _e967 {
                                                } else {
                                                    phi_3902_ = true;
                                                    break;
                                                }
                                                local_3[_e966] = _e944.member.member_1.y;
                                                if _e967 {
                                                } else {
                                                    phi_3902_ = true;
                                                    break;
                                                }
                                                local_2[_e966] = _e944.member.member_1.z;
                                                if _e967 {
                                                } else {
                                                    phi_3902_ = true;
                                                    break;
                                                }
                                                local_10[_e966] = select(_e933, _e931, (_e931 > _e933));
                                                if _e940 {
                                                    phi_3289_ = _e839.member_1;
                                                } else {
                                                    phi_3289_ = _e839.member_2;
                                                }
                                                let _e980 = phi_3289_;
                                                phi_3290_ = _e980;
                                                phi_3291_ = (_e543 + 1u);
                                            } else {
                                                phi_3290_ = type_52();
                                                phi_3291_ = u32();
                                            }
                                            let _e982 = phi_3290_;
                                            let _e984 = phi_3291_;
                                            phi_3293_ = _e982;
                                            phi_3294_ = _e984;
                                            phi_3295_ = select(true, false, _e939);
                                        } else {
                                            phi_3293_ = type_52();
                                            phi_3294_ = u32();
                                            phi_3295_ = true;
                                        }
                                        let _e987 = phi_3293_;
                                        let _e989 = phi_3294_;
                                        let _e991 = phi_3295_;
                                        if _e991 {
                                            if _e938 {
                                                phi_3304_ = _e839.member_1;
                                            } else {
                                                phi_3304_ = _e839.member_2;
                                            }
                                            let _e995 = phi_3304_;
                                            phi_3309_ = _e995;
                                            phi_3310_ = select(_e939, true, _e938);
                                        } else {
                                            phi_3309_ = _e987;
                                            phi_3310_ = _e541;
                                        }
                                        let _e998 = phi_3309_;
                                        let _e1000 = phi_3310_;
                                        phi_4004_ = _e501;
                                        phi_3906_ = _e499;
                                        phi_3312_ = _e998;
                                        phi_3313_ = _e1000;
                                        phi_3314_ = select(_e989, _e543, _e991);
                                    }
                                    let _e1652 = phi_4004_;
                                    let _e1654 = phi_3906_;
                                    let _e1656 = phi_3312_;
                                    let _e1658 = phi_3313_;
                                    let _e1660 = phi_3314_;
                                    phi_4003_ = _e1652;
                                    phi_3905_ = _e1654;
                                    phi_3315_ = _e1656;
                                    phi_3316_ = (_e505 - 1u);
                                    phi_3317_ = _e1658;
                                    phi_3318_ = _e1660;
                                } else {
                                    phi_4003_ = _e501;
                                    phi_3905_ = _e499;
                                    phi_3315_ = _e539;
                                    phi_3316_ = _e505;
                                    phi_3317_ = _e541;
                                    phi_3318_ = _e543;
                                }
                                let _e1662 = phi_4003_;
                                let _e1664 = phi_3905_;
                                let _e1666 = phi_3315_;
                                let _e1668 = phi_3316_;
                                let _e1670 = phi_3317_;
                                let _e1672 = phi_3318_;
                                phi_4002_ = _e1662;
                                phi_3904_ = _e1664;
                                phi_3319_ = _e1666;
                                phi_3320_ = _e1668;
                                phi_3321_ = _e1670;
                                phi_3322_ = _e1672;
                            } else {
                                phi_4002_ = _e501;
                                phi_3904_ = _e499;
                                phi_3319_ = type_52();
                                phi_3320_ = u32();
                                phi_3321_ = bool();
                                phi_3322_ = u32();
                            }
                            let _e1674 = phi_4002_;
                            let _e1676 = phi_3904_;
                            let _e1678 = phi_3319_;
                            let _e1680 = phi_3320_;
                            let _e1682 = phi_3321_;
                            let _e1684 = phi_3322_;
                            phi_4001_ = _e1674;
                            phi_3903_ = _e1676;
                            phi_901_ = _e1678;
                            phi_904_ = _e1680;
                            phi_906_ = _e1682;
                            phi_908_ = _e1684;
                            phi_3323_ = _e513;
                        } else {
                            phi_4001_ = _e501;
                            phi_3903_ = _e499;
                            phi_901_ = type_52();
                            phi_904_ = u32();
                            phi_906_ = bool();
                            phi_908_ = u32();
                            phi_3323_ = false;
                        }
                        let _e1686 = phi_4001_;
                        let _e1688 = phi_3903_;
                        let _e1690 = phi_901_;
                        let _e1692 = phi_904_;
                        let _e1694 = phi_906_;
                        let _e1696 = phi_908_;
                        let _e1698 = phi_3323_;
                        continue;
                        continuing {
                            phi_3767_ = _e1688;
                            phi_3695_ = _e1686;
                            phi_900_ = _e1690;
                            phi_903_ = _e1692;
                            phi_905_ = _e1694;
                            phi_907_ = _e1696;
                            phi_3902_ = _e1688;
                            break if !(_e1698);
                        }
                    }
                    let _e1701 = phi_3902_;
                    if _e1701 {
                        break;
                    }
                    phi_3330_ = type_4(0u, 8u);
                    loop {
                        let _e1703 = phi_3330_;
                        if (_e1703.member < _e1703.member_1) {
                            phi_3331_ = type_4((_e1703.member + 1u), _e1703.member_1);
                            phi_3354_ = type_4(1u, _e1703.member);
                        } else {
                            phi_3331_ = _e1703;
                            phi_3354_ = type_4(0u, type_4().member_1);
                        }
                        let _e1716 = phi_3331_;
                        let _e1718 = phi_3354_;
                        let _e1722 = (bitcast<i32>(_e1718.member) != 0i);
                        if _e1722 {
                            let _e1723 = (_e1718.member_1 < 8u);
                            if _e1723 {
                            } else {
                                phi_3994_ = true;
                                break;
                            }
                            let _e1725 = local_9[_e1718.member_1];
                            if (_e1725.member_3 != 4294967295u) {
                                let _e1731 = -(_e425);
                                let _e1732 = (_e1731 / 3i);
                                let _e1739 = bitcast<f32>((bitcast<u32>((_e1732 + 127i)) << bitcast<u32>(23i)));
                                let _e1747 = (((_e1725.member * _e1739) * _e1739) * bitcast<f32>((bitcast<u32>(((_e1731 - (2i * _e1732)) + 127i)) << bitcast<u32>(23i))));
                                let _e1749 = select(340282350000000000000000000000000000000f, _e1747, (_e1747 < 340282350000000000000000000000000000000f));
                                phi_3420_ = type_21(select(-340282350000000000000000000000000000000f, _e1749, (_e1749 > -340282350000000000000000000000000000000f)), _e1725.member_1, _e1725.member_2, _e1725.member_3);
                            } else {
                                phi_3420_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1754 = phi_3420_;
                            if _e1723 {
                            } else {
                                phi_3994_ = true;
                                break;
                            }
                            local_9[_e1718.member_1] = type_21(_e1754.member, _e1754.member_1, _e1754.member_2, _e1754.member_3);
                        }
                        continue;
                        continuing {
                            phi_3330_ = _e1716;
                            phi_3994_ = _e1701;
                            break if !(_e1722);
                        }
                    }
                    let _e1762 = phi_3994_;
                    if _e1762 {
                        break;
                    }
                    let _e1763 = local_9;
                    if _e146 {
                    } else {
                        break;
                    }
                    global_6.member[_e144] = array<type_21, 8>(type_21(_e1763[0].member, _e1763[0].member_1, _e1763[0].member_2, _e1763[0].member_3), type_21(_e1763[1].member, _e1763[1].member_1, _e1763[1].member_2, _e1763[1].member_3), type_21(_e1763[2].member, _e1763[2].member_1, _e1763[2].member_2, _e1763[2].member_3), type_21(_e1763[3].member, _e1763[3].member_1, _e1763[3].member_2, _e1763[3].member_3), type_21(_e1763[4].member, _e1763[4].member_1, _e1763[4].member_2, _e1763[4].member_3), type_21(_e1763[5].member, _e1763[5].member_1, _e1763[5].member_2, _e1763[5].member_3), type_21(_e1763[6].member, _e1763[6].member_1, _e1763[6].member_2, _e1763[6].member_3), type_21(_e1763[7].member, _e1763[7].member_1, _e1763[7].member_2, _e1763[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
