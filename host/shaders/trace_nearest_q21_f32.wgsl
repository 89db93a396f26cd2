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
    var phi_390_: i32;
    var phi_391_: i32;
    var phi_401_: bool;
    var phi_411_: u32;
    var phi_412_: u32;
    var phi_414_: bool;
    var phi_419_: u32;
    var phi_431_: i32;
    var phi_451_: i32;
    var phi_469_: f32;
    var phi_475_: f32;
    var phi_486_: f32;
    var phi_492_: f32;
    var phi_515_: f32;
    var phi_526_: f32;
    var phi_535_: f32;
    var phi_541_: f32;
    var phi_552_: f32;
    var phi_558_: f32;
    var phi_581_: f32;
    var phi_592_: f32;
    var phi_601_: f32;
    var phi_607_: f32;
    var phi_618_: f32;
    var phi_624_: f32;
    var phi_647_: f32;
    var phi_658_: f32;
    var phi_758_: f32;
    var phi_759_: f32;
    var phi_3765_: bool;
    var phi_3693_: f32;
    var phi_901_: type_52;
    var phi_904_: u32;
    var phi_906_: bool;
    var phi_908_: u32;
    var phi_919_: bool;
    var phi_1006_: type_52;
    var phi_1007_: bool;
    var phi_1008_: u32;
    var phi_2826_: u32;
    var phi_2827_: u32;
    var phi_2837_: u32;
    var phi_2839_: u32;
    var phi_2840_: bool;
    var phi_2860_: u32;
    var phi_2861_: u32;
    var phi_2865_: type_53;
    var phi_3210_: type_52;
    var phi_3287_: type_52;
    var phi_3288_: type_52;
    var phi_3289_: u32;
    var phi_3291_: type_52;
    var phi_3292_: u32;
    var phi_3293_: bool;
    var phi_3302_: type_52;
    var phi_3307_: type_52;
    var phi_3308_: bool;
    var phi_3762_: bool;
    var phi_3752_: f32;
    var phi_1026_: type_4;
    var phi_1027_: type_4;
    var phi_1050_: type_4;
    var phi_1071_: u32;
    var phi_1160_: array<array<f32, 3>, 3>;
    var phi_1278_: bool;
    var phi_1307_: bool;
    var phi_1708_: f32;
    var phi_1709_: f32;
    var phi_1710_: f32;
    var phi_1711_: f32;
    var phi_1712_: vec3<f32>;
    var phi_1713_: vec3<f32>;
    var phi_1714_: vec3<f32>;
    var phi_1715_: vec3<f32>;
    var phi_1746_: bool;
    var phi_1755_: vec3<f32>;
    var phi_1920_: f32;
    var phi_1922_: f32;
    var phi_1923_: bool;
    var phi_1943_: f32;
    var phi_1944_: f32;
    var phi_1967_: type_21;
    var phi_1969_: type_21;
    var phi_1970_: bool;
    var phi_1974_: type_21;
    var phi_1975_: type_21;
    var phi_1976_: type_21;
    var phi_1977_: bool;
    var phi_1981_: type_21;
    var phi_1982_: bool;
    var phi_1983_: type_21;
    var phi_1984_: bool;
    var phi_1985_: bool;
    var phi_1986_: type_21;
    var phi_1987_: bool;
    var phi_1988_: bool;
    var phi_1996_: type_21;
    var phi_1997_: bool;
    var phi_2001_: type_21;
    var phi_2013_: type_4;
    var phi_2016_: type_21;
    var phi_2014_: type_4;
    var phi_2039_: type_4;
    var phi_2071_: bool;
    var phi_2072_: bool;
    var phi_2093_: type_21;
    var phi_2017_: type_21;
    var phi_3753_: bool;
    var phi_4128_: f32;
    var phi_4127_: f32;
    var phi_3898_: bool;
    var phi_4126_: f32;
    var phi_3897_: bool;
    var phi_4125_: f32;
    var phi_3896_: bool;
    var phi_4037_: f32;
    var phi_3895_: bool;
    var phi_4002_: f32;
    var phi_3904_: bool;
    var phi_3310_: type_52;
    var phi_3311_: bool;
    var phi_3312_: u32;
    var phi_4001_: f32;
    var phi_3903_: bool;
    var phi_3313_: type_52;
    var phi_3314_: u32;
    var phi_3315_: bool;
    var phi_3316_: u32;
    var phi_4000_: f32;
    var phi_3902_: bool;
    var phi_3317_: type_52;
    var phi_3318_: u32;
    var phi_3319_: bool;
    var phi_3320_: u32;
    var phi_3999_: f32;
    var phi_3901_: bool;
    var phi_902_: type_52;
    var phi_905_: u32;
    var phi_907_: bool;
    var phi_909_: u32;
    var phi_3321_: bool;
    var phi_3900_: bool;
    var phi_3328_: type_4;
    var phi_3329_: type_4;
    var phi_3352_: type_4;
    var phi_3418_: type_21;
    var phi_3992_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e89 = arrayLength((&global_5.member));
            let _e91 = arrayLength((&global_2.member));
            let _e99 = global_3.member[0u][0u];
            let _e103 = global_3.member[0u][1u];
            let _e107 = global_3.member[0u][2u];
            let _e111 = global_3.member[0u][3u];
            let _e115 = global_3.member[1u][0u];
            let _e119 = global_3.member[1u][1u];
            let _e123 = global_3.member[1u][2u];
            let _e126 = global_1.member[0u];
            let _e127 = bitcast<i32>(_e126);
            let _e139 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e111) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e99), bitcast<i32>(_e103), bitcast<i32>(_e107));
            local = array<i32, 3>(bitcast<i32>(_e115), bitcast<i32>(_e119), bitcast<i32>(_e123));
            let _e145 = (_e87.x + (_e87.y * 2097152u));
            let _e146 = (_e145 < arrayLength((&global_4.member)));
            if _e146 {
                let _e147 = (_e145 < arrayLength((&global_6.member)));
                if _e147 {
                    if _e146 {
                    } else {
                        break;
                    }
                    let _e155 = global_4.member[_e145].member_2[0u];
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e162 = global_4.member[_e145].member_2[1u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_4.member[_e145].member_2[2u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_4.member[_e145].member[0u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e183 = global_4.member[_e145].member[1u];
                    let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                    let _e190 = global_4.member[_e145].member[2u];
                    let _e192 = (bitcast<u32>(_e190) & 2147483647u);
                    let _e194 = select(_e164, _e157, (_e164 < _e157));
                    let _e196 = select(_e171, _e194, (_e171 < _e194));
                    let _e198 = select(_e178, _e196, (_e178 < _e196));
                    let _e200 = select(_e185, _e198, (_e185 < _e198));
                    let _e202 = select(_e192, _e200, (_e192 < _e200));
                    let _e206 = global_4.member[_e145].member_1;
                    let _e208 = (bitcast<u32>(_e206) & 2147483647u);
                    let _e215 = global_4.member[_e145].member_3;
                    let _e221 = (((select(_e208, _e202, (_e208 < _e202)) < 2139095040u) && ((bitcast<u32>(_e215) & 2147483647u) <= 2139095040u)) && (_e196 > 0u));
                    if _e221 {
                        let _e224 = (bitcast<u32>(bitcast<f32>(_e196)) & 2147483647u);
                        if (_e224 >= 8388608u) {
                            phi_390_ = (bitcast<i32>((_e224 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_390_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e224)), 32u, (_e224 == 0u))));
                        }
                        let _e238 = phi_390_;
                        phi_391_ = _e238;
                    } else {
                        phi_391_ = 0i;
                    }
                    let _e240 = phi_391_;
                    let _e241 = (_e157 == _e196);
                    if _e241 {
                        phi_401_ = true;
                    } else {
                        phi_401_ = (_e164 == _e196);
                    }
                    let _e244 = phi_401_;
                    let _e245 = select(1u, 0u, _e241);
                    if _e244 {
                        let _e246 = (_e245 + 1u);
                        phi_411_ = _e246;
                        phi_412_ = _e246;
                        phi_414_ = select(true, false, (_e246 == 2u));
                    } else {
                        phi_411_ = u32();
                        phi_412_ = 0u;
                        phi_414_ = true;
                    }
                    let _e250 = phi_411_;
                    let _e252 = phi_412_;
                    let _e254 = phi_414_;
                    if _e254 {
                        phi_419_ = (_e252 + 1u);
                    } else {
                        phi_419_ = 0u;
                    }
                    let _e258 = phi_419_;
                    let _e259 = select(_e250, _e252, _e254);
                    let _e260 = select(_e245, select(2u, _e245, _e244), _e254);
                    if (_e127 < -126i) {
                        phi_431_ = -126i;
                    } else {
                        phi_431_ = select(_e127, 127i, (_e127 > 127i));
                    }
                    let _e265 = phi_431_;
                    let _e270 = bitcast<f32>((bitcast<u32>((_e265 + 127i)) << bitcast<u32>(23i)));
                    let _e276 = bitcast<f32>((bitcast<u32>(((_e127 - _e265) + 127i)) << bitcast<u32>(23i)));
                    let _e277 = -(_e240);
                    if (_e277 < -126i) {
                        phi_451_ = -126i;
                    } else {
                        phi_451_ = select(_e277, 127i, (_e277 > 127i));
                    }
                    let _e282 = phi_451_;
                    let _e287 = bitcast<f32>((bitcast<u32>((_e282 + 127i)) << bitcast<u32>(23i)));
                    let _e293 = bitcast<f32>((bitcast<u32>(((_e277 - _e282) + 127i)) << bitcast<u32>(23i)));
                    let _e297 = global_4.member[_e145].member;
                    let _e298 = (_e259 == 0u);
                    if _e298 {
                        phi_469_ = _e297[0];
                    } else {
                        phi_469_ = _e297[1];
                    }
                    let _e302 = phi_469_;
                    let _e303 = (_e259 == 2u);
                    if _e303 {
                        phi_475_ = _e297[2];
                    } else {
                        phi_475_ = _e302;
                    }
                    let _e306 = phi_475_;
                    let _e308 = ((_e306 * _e270) * _e276);
                    let _e309 = global_4.member[_e145].member_2;
                    if _e298 {
                        phi_486_ = _e309[0];
                    } else {
                        phi_486_ = _e309[1];
                    }
                    let _e313 = phi_486_;
                    if _e303 {
                        phi_492_ = _e309[2];
                    } else {
                        phi_492_ = _e313;
                    }
                    let _e316 = phi_492_;
                    let _e318 = ((_e316 * _e287) * _e293);
                    let _e322 = (bitcast<f32>((bitcast<u32>(_e318) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e322 {
                        let _e326 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) * 0.00000011920929f);
                        phi_515_ = select(0.00000000000011368684f, _e326, (_e326 > 0.00000000000011368684f));
                    } else {
                        phi_515_ = 0f;
                    }
                    let _e330 = phi_515_;
                    let _e331 = (_e308 + _e330);
                    let _e332 = (_e308 - _e330);
                    let _e333 = select(_e318, 0f, _e322);
                    if _e322 {
                        phi_526_ = 38685626000000000000000000f;
                    } else {
                        phi_526_ = (1f / _e318);
                    }
                    let _e336 = phi_526_;
                    let _e337 = (_e258 == 0u);
                    if _e337 {
                        phi_535_ = _e297[0];
                    } else {
                        phi_535_ = _e297[1];
                    }
                    let _e341 = phi_535_;
                    let _e342 = (_e258 == 2u);
                    if _e342 {
                        phi_541_ = _e297[2];
                    } else {
                        phi_541_ = _e341;
                    }
                    let _e345 = phi_541_;
                    let _e347 = ((_e345 * _e270) * _e276);
                    if _e337 {
                        phi_552_ = _e309[0];
                    } else {
                        phi_552_ = _e309[1];
                    }
                    let _e351 = phi_552_;
                    if _e342 {
                        phi_558_ = _e309[2];
                    } else {
                        phi_558_ = _e351;
                    }
                    let _e354 = phi_558_;
                    let _e356 = ((_e354 * _e287) * _e293);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e360 {
                        let _e364 = (bitcast<f32>((bitcast<u32>(_e347) & 2147483647u)) * 0.00000011920929f);
                        phi_581_ = select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f));
                    } else {
                        phi_581_ = 0f;
                    }
                    let _e368 = phi_581_;
                    let _e369 = (_e347 + _e368);
                    let _e370 = (_e347 - _e368);
                    let _e371 = select(_e356, 0f, _e360);
                    if _e360 {
                        phi_592_ = 38685626000000000000000000f;
                    } else {
                        phi_592_ = (1f / _e356);
                    }
                    let _e374 = phi_592_;
                    let _e375 = (_e260 == 0u);
                    if _e375 {
                        phi_601_ = _e297[0];
                    } else {
                        phi_601_ = _e297[1];
                    }
                    let _e379 = phi_601_;
                    let _e380 = (_e260 == 2u);
                    if _e380 {
                        phi_607_ = _e297[2];
                    } else {
                        phi_607_ = _e379;
                    }
                    let _e383 = phi_607_;
                    let _e385 = ((_e383 * _e270) * _e276);
                    if _e375 {
                        phi_618_ = _e309[0];
                    } else {
                        phi_618_ = _e309[1];
                    }
                    let _e389 = phi_618_;
                    if _e380 {
                        phi_624_ = _e309[2];
                    } else {
                        phi_624_ = _e389;
                    }
                    let _e392 = phi_624_;
                    let _e394 = ((_e392 * _e287) * _e293);
                    let _e398 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e398 {
                        let _e402 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) * 0.00000011920929f);
                        phi_647_ = select(0.00000000000011368684f, _e402, (_e402 > 0.00000000000011368684f));
                    } else {
                        phi_647_ = 0f;
                    }
                    let _e406 = phi_647_;
                    let _e407 = (_e385 + _e406);
                    let _e408 = (_e385 - _e406);
                    let _e409 = select(_e394, 0f, _e398);
                    if _e398 {
                        phi_658_ = 38685626000000000000000000f;
                    } else {
                        phi_658_ = (1f / _e394);
                    }
                    let _e412 = phi_658_;
                    let _e415 = bitcast<f32>((bitcast<u32>(_e308) & 2147483647u));
                    let _e418 = bitcast<f32>((bitcast<u32>(_e347) & 2147483647u));
                    let _e420 = select(_e418, _e415, (_e415 > _e418));
                    let _e423 = bitcast<f32>((bitcast<u32>(_e385) & 2147483647u));
                    let _e426 = (_e127 + _e240);
                    if (_e221 && (select(_e423, _e420, (_e420 > _e423)) <= 1099511600000f)) {
                        let _e429 = (_e426 / 3i);
                        let _e436 = bitcast<f32>((bitcast<u32>((_e429 + 127i)) << bitcast<u32>(23i)));
                        let _e443 = bitcast<f32>((bitcast<u32>(((_e426 - (2i * _e429)) + 127i)) << bitcast<u32>(23i)));
                        let _e444 = (((_e206 * _e436) * _e436) * _e443);
                        let _e446 = select(340282350000000000000000000000000000000f, _e444, (_e444 < 340282350000000000000000000000000000000f));
                        let _e451 = (((_e215 * _e436) * _e436) * _e443);
                        let _e453 = select(340282350000000000000000000000000000000f, _e451, (_e451 < 340282350000000000000000000000000000000f));
                        phi_758_ = select(-340282350000000000000000000000000000000f, _e453, (_e453 > -340282350000000000000000000000000000000f));
                        phi_759_ = select(-340282350000000000000000000000000000000f, _e446, (_e446 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_758_ = 0f;
                        phi_759_ = 1f;
                    }
                    let _e457 = phi_758_;
                    let _e459 = phi_759_;
                    local_9 = array<type_21, 8>(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e462 = (_e259 % 3u);
                    let _e463 = (_e462 < 3u);
                    if _e463 {
                    } else {
                        break;
                    }
                    let _e465 = local_1[_e462];
                    let _e468 = (_e258 % 3u);
                    let _e469 = (_e468 < 3u);
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e471 = local_1[_e468];
                    let _e474 = (_e260 % 3u);
                    let _e475 = (_e474 < 3u);
                    if _e475 {
                    } else {
                        break;
                    }
                    let _e477 = local_1[_e474];
                    if _e463 {
                    } else {
                        break;
                    }
                    let _e482 = local[_e462];
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e486 = local[_e468];
                    if _e475 {
                    } else {
                        break;
                    }
                    let _e490 = local[_e474];
                    phi_3765_ = false;
                    phi_3693_ = _e457;
                    phi_901_ = type_52(type_25(vec4<f32>((f32(_e465) * _e139), (f32(_e471) * _e139), (f32(_e477) * _e139), 0f), vec4<f32>((f32(_e482) * _e139), (f32(_e486) * _e139), (f32(_e490) * _e139), 0f)), select(0u, 2147483648u, (_e89 == 0u)));
                    phi_904_ = ((3u * _e89) + 1u);
                    phi_906_ = (_e459 <= _e457);
                    phi_908_ = 0u;
                    loop {
                        let _e500 = phi_3765_;
                        let _e502 = phi_3693_;
                        let _e504 = phi_901_;
                        let _e506 = phi_904_;
                        let _e508 = phi_906_;
                        let _e510 = phi_908_;
                        if _e508 {
                            phi_919_ = true;
                        } else {
                            phi_919_ = (_e510 > 0u);
                        }
                        let _e513 = phi_919_;
                        if _e513 {
                            let _e514 = (_e506 > 0u);
                            if _e514 {
                                if _e508 {
                                    phi_1006_ = _e504;
                                    phi_1007_ = _e508;
                                    phi_1008_ = _e510;
                                } else {
                                    let _e515 = (_e510 - 1u);
                                    let _e516 = (_e515 % 128u);
                                    let _e517 = (_e516 < 128u);
                                    if _e517 {
                                    } else {
                                        phi_3900_ = true;
                                        break;
                                    }
                                    let _e519 = local_7[_e516];
                                    if _e517 {
                                    } else {
                                        phi_3900_ = true;
                                        break;
                                    }
                                    let _e521 = local_6[_e516];
                                    if _e517 {
                                    } else {
                                        phi_3900_ = true;
                                        break;
                                    }
                                    let _e523 = local_5[_e516];
                                    if _e517 {
                                    } else {
                                        phi_3900_ = true;
                                        break;
                                    }
                                    let _e525 = local_4[_e516];
                                    if _e517 {
                                    } else {
                                        phi_3900_ = true;
                                        break;
                                    }
                                    let _e527 = local_3[_e516];
                                    if _e517 {
                                    } else {
                                        phi_3900_ = true;
                                        break;
                                    }
                                    let _e529 = local_2[_e516];
                                    if _e517 {
                                    } else {
                                        phi_3900_ = true;
                                        break;
                                    }
                                    let _e534 = local_8[_e516];
                                    if _e517 {
                                    } else {
                                        phi_3900_ = true;
                                        break;
                                    }
                                    let _e537 = local_10[_e516];
                                    phi_1006_ = type_52(type_25(vec4<f32>(_e519, _e521, _e523, 0f), vec4<f32>(_e525, _e527, _e529, 0f)), _e534);
                                    phi_1007_ = (_e537 <= _e502);
                                    phi_1008_ = _e515;
                                }
                                let _e540 = phi_1006_;
                                let _e542 = phi_1007_;
                                let _e544 = phi_1008_;
                                if _e542 {
                                    if ((_e540.member_1 & 2147483648u) != 0u) {
                                        phi_3762_ = _e500;
                                        phi_3752_ = _e502;
                                        phi_1026_ = type_4(0u, ((_e540.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1005 = phi_3762_;
                                            let _e1007 = phi_3752_;
                                            let _e1009 = phi_1026_;
                                            if (_e1009.member < _e1009.member_1) {
                                                phi_1027_ = type_4((_e1009.member + 1u), _e1009.member_1);
                                                phi_1050_ = type_4(1u, _e1009.member);
                                            } else {
                                                phi_1027_ = _e1009;
                                                phi_1050_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1022 = phi_1027_;
                                            let _e1024 = phi_1050_;
                                            let _e1028 = (bitcast<i32>(_e1024.member) != 0i);
                                            if _e1028 {
                                                let _e1029 = ((_e540.member_1 & 268435455u) + _e1024.member_1);
                                                let _e1030 = (_e1029 < _e91);
                                                if _e1030 {
                                                    if _e1030 {
                                                    } else {
                                                        phi_4037_ = _e1007;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1034 = global_2.member[_e1029].member_1;
                                                    phi_1071_ = _e1034;
                                                } else {
                                                    phi_1071_ = 4294967295u;
                                                }
                                                let _e1036 = phi_1071_;
                                                if (_e1029 >= _e91) {
                                                    phi_1160_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1030 {
                                                    } else {
                                                        phi_4037_ = _e1007;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    if (_e462 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e1007;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1043 = global_2.member[_e1029].member[_e462];
                                                    if (_e468 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e1007;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1049 = global_2.member[_e1029].member[_e468];
                                                    if (_e474 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e1007;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1055 = global_2.member[_e1029].member[_e474];
                                                    let _e1057 = (3u + _e462);
                                                    if (_e1057 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e1007;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1063 = global_2.member[_e1029].member[_e1057];
                                                    let _e1064 = (3u + _e468);
                                                    if (_e1064 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e1007;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1070 = global_2.member[_e1029].member[_e1064];
                                                    let _e1071 = (3u + _e474);
                                                    if (_e1071 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e1007;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1077 = global_2.member[_e1029].member[_e1071];
                                                    let _e1079 = (6u + _e462);
                                                    if (_e1079 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e1007;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1085 = global_2.member[_e1029].member[_e1079];
                                                    let _e1086 = (6u + _e468);
                                                    if (_e1086 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e1007;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1092 = global_2.member[_e1029].member[_e1086];
                                                    let _e1093 = (6u + _e474);
                                                    if (_e1093 < 9u) {
                                                    } else {
                                                        phi_4037_ = _e1007;
                                                        phi_3895_ = true;
                                                        break;
                                                    }
                                                    let _e1099 = global_2.member[_e1029].member[_e1093];
                                                    phi_1160_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1043, _e1049, _e1055), array<f32, 3>(_e1063, _e1070, _e1077), array<f32, 3>(_e1085, _e1092, _e1099));
                                                }
                                                let _e1103 = phi_1160_;
                                                let _e1110 = (_e1103[0][2] - _e385);
                                                let _e1113 = (((_e1103[0][0] - _e308) * _e409) - (_e1110 * _e333));
                                                let _e1116 = (((_e1103[0][1] - _e347) * _e409) - (_e1110 * _e371));
                                                let _e1123 = (_e1103[1][2] - _e385);
                                                let _e1126 = (((_e1103[1][0] - _e308) * _e409) - (_e1123 * _e333));
                                                let _e1129 = (((_e1103[1][1] - _e347) * _e409) - (_e1123 * _e371));
                                                let _e1136 = (_e1103[2][2] - _e385);
                                                let _e1139 = (((_e1103[2][0] - _e308) * _e409) - (_e1136 * _e333));
                                                let _e1142 = (((_e1103[2][1] - _e347) * _e409) - (_e1136 * _e371));
                                                let _e1143 = (_e1139 * _e1129);
                                                let _e1144 = (_e1142 * _e1126);
                                                let _e1145 = (_e1113 * _e1142);
                                                let _e1146 = (_e1116 * _e1139);
                                                let _e1147 = (_e1126 * _e1116);
                                                let _e1148 = (_e1129 * _e1113);
                                                let _e1153 = (((_e1143 >= _e1144) && (_e1145 >= _e1146)) && (_e1147 >= _e1148));
                                                if (_e1153 || (((_e1143 <= _e1144) && (_e1145 <= _e1146)) && (_e1147 <= _e1148))) {
                                                    let _e1160 = select(-1f, 1f, _e1153);
                                                    let _e1162 = ((_e1143 - _e1144) * _e1160);
                                                    let _e1164 = select(0f, _e1162, (_e1162 > 0f));
                                                    let _e1166 = ((_e1145 - _e1146) * _e1160);
                                                    let _e1168 = select(0f, _e1166, (_e1166 > 0f));
                                                    let _e1170 = ((_e1147 - _e1148) * _e1160);
                                                    let _e1172 = select(0f, _e1170, (_e1170 > 0f));
                                                    let _e1174 = ((_e1164 + _e1168) + _e1172);
                                                    if (_e1174 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1986_ = type_21();
                                                        phi_1987_ = true;
                                                        phi_1988_ = false;
                                                    } else {
                                                        let _e1177 = select(_e1126, _e1113, (_e1113 < _e1126));
                                                        if (select(_e1139, _e1177, (_e1177 < _e1139)) > 0f) {
                                                            phi_1278_ = true;
                                                        } else {
                                                            let _e1182 = select(_e1126, _e1113, (_e1113 > _e1126));
                                                            phi_1278_ = (select(_e1139, _e1182, (_e1182 > _e1139)) < 0f);
                                                        }
                                                        let _e1187 = phi_1278_;
                                                        if _e1187 {
                                                            phi_1983_ = type_21();
                                                            phi_1984_ = true;
                                                            phi_1985_ = false;
                                                        } else {
                                                            let _e1189 = select(_e1129, _e1116, (_e1116 < _e1129));
                                                            if (select(_e1142, _e1189, (_e1189 < _e1142)) > 0f) {
                                                                phi_1307_ = true;
                                                            } else {
                                                                let _e1194 = select(_e1129, _e1116, (_e1116 > _e1129));
                                                                phi_1307_ = (select(_e1142, _e1194, (_e1194 > _e1142)) < 0f);
                                                            }
                                                            let _e1199 = phi_1307_;
                                                            if _e1199 {
                                                                phi_1981_ = type_21();
                                                                phi_1982_ = false;
                                                            } else {
                                                                let _e1201 = select(_e1103[1][0], _e1103[0][0], (_e1103[0][0] < _e1103[1][0]));
                                                                let _e1205 = select(_e1103[1][0], _e1103[0][0], (_e1103[0][0] > _e1103[1][0]));
                                                                let _e1209 = select(_e1103[1][1], _e1103[0][1], (_e1103[0][1] < _e1103[1][1]));
                                                                let _e1213 = select(_e1103[1][1], _e1103[0][1], (_e1103[0][1] > _e1103[1][1]));
                                                                let _e1217 = select(_e1103[1][2], _e1103[0][2], (_e1103[0][2] < _e1103[1][2]));
                                                                let _e1221 = select(_e1103[1][2], _e1103[0][2], (_e1103[0][2] > _e1103[1][2]));
                                                                let _e1226 = ((select(_e1103[2][0], _e1201, (_e1201 < _e1103[2][0])) - _e331) * _e336);
                                                                let _e1227 = ((select(_e1103[2][0], _e1205, (_e1205 > _e1103[2][0])) - _e332) * _e336);
                                                                let _e1230 = ((select(_e1103[2][1], _e1209, (_e1209 < _e1103[2][1])) - _e369) * _e374);
                                                                let _e1231 = ((select(_e1103[2][1], _e1213, (_e1213 > _e1103[2][1])) - _e370) * _e374);
                                                                let _e1234 = ((select(_e1103[2][2], _e1217, (_e1217 < _e1103[2][2])) - _e407) * _e412);
                                                                let _e1235 = ((select(_e1103[2][2], _e1221, (_e1221 > _e1103[2][2])) - _e408) * _e412);
                                                                let _e1237 = select(_e1235, _e1234, (_e1234 < _e1235));
                                                                let _e1239 = select(_e1235, _e1234, (_e1234 > _e1235));
                                                                let _e1241 = select(_e1227, _e1226, (_e1226 < _e1227));
                                                                let _e1243 = select(_e1231, _e1230, (_e1230 < _e1231));
                                                                let _e1245 = select(_e1243, _e1241, (_e1241 > _e1243));
                                                                let _e1247 = select(_e1237, _e1245, (_e1245 > _e1237));
                                                                let _e1249 = select(_e1227, _e1226, (_e1226 > _e1227));
                                                                let _e1251 = select(_e1231, _e1230, (_e1230 > _e1231));
                                                                let _e1253 = select(_e1251, _e1249, (_e1249 < _e1251));
                                                                let _e1255 = select(_e1239, _e1253, (_e1253 < _e1239));
                                                                let _e1256 = -(_e1237);
                                                                let _e1262 = select(_e459, _e1247, (_e1247 > _e459));
                                                                if (_e1262 > (_e1255 + (select(_e1256, _e1239, (_e1239 > _e1256)) * 0.0000019073523f))) {
                                                                    phi_1976_ = type_21();
                                                                    phi_1977_ = true;
                                                                } else {
                                                                    let _e1264 = (_e1262 > _e1007);
                                                                    if _e1264 {
                                                                        phi_1975_ = type_21();
                                                                    } else {
                                                                        let _e1265 = vec3<f32>(_e1103[0][0], _e1103[0][1], _e1103[0][2]);
                                                                        let _e1266 = vec3<f32>(_e1103[1][0], _e1103[1][1], _e1103[1][2]);
                                                                        let _e1267 = vec3<f32>(_e1103[2][0], _e1103[2][1], _e1103[2][2]);
                                                                        let _e1268 = (_e1103[1][0] - _e1103[0][0]);
                                                                        let _e1269 = (_e1103[1][1] - _e1103[0][1]);
                                                                        let _e1270 = (_e1103[1][2] - _e1103[0][2]);
                                                                        let _e1271 = vec3<f32>(_e1268, _e1269, _e1270);
                                                                        let _e1272 = (_e1103[2][0] - _e1103[1][0]);
                                                                        let _e1273 = (_e1103[2][1] - _e1103[1][1]);
                                                                        let _e1274 = (_e1103[2][2] - _e1103[1][2]);
                                                                        let _e1275 = vec3<f32>(_e1272, _e1273, _e1274);
                                                                        let _e1276 = (_e1103[0][0] - _e1103[2][0]);
                                                                        let _e1277 = (_e1103[0][1] - _e1103[2][1]);
                                                                        let _e1278 = (_e1103[0][2] - _e1103[2][2]);
                                                                        let _e1279 = vec3<f32>(_e1276, _e1277, _e1278);
                                                                        let _e1282 = bitcast<f32>((bitcast<u32>(_e1268) & 2147483647u));
                                                                        let _e1285 = bitcast<f32>((bitcast<u32>(_e1269) & 2147483647u));
                                                                        let _e1287 = select(_e1285, _e1282, (_e1282 > _e1285));
                                                                        let _e1290 = bitcast<f32>((bitcast<u32>(_e1270) & 2147483647u));
                                                                        let _e1292 = select(_e1290, _e1287, (_e1287 > _e1290));
                                                                        let _e1295 = bitcast<f32>((bitcast<u32>(_e1272) & 2147483647u));
                                                                        let _e1298 = bitcast<f32>((bitcast<u32>(_e1273) & 2147483647u));
                                                                        let _e1300 = select(_e1298, _e1295, (_e1295 > _e1298));
                                                                        let _e1303 = bitcast<f32>((bitcast<u32>(_e1274) & 2147483647u));
                                                                        let _e1305 = select(_e1303, _e1300, (_e1300 > _e1303));
                                                                        let _e1308 = bitcast<f32>((bitcast<u32>(_e1276) & 2147483647u));
                                                                        let _e1311 = bitcast<f32>((bitcast<u32>(_e1277) & 2147483647u));
                                                                        let _e1313 = select(_e1311, _e1308, (_e1308 > _e1311));
                                                                        let _e1316 = bitcast<f32>((bitcast<u32>(_e1278) & 2147483647u));
                                                                        let _e1318 = select(_e1316, _e1313, (_e1313 > _e1316));
                                                                        let _e1320 = select(_e1305, _e1292, (_e1292 > _e1305));
                                                                        let _e1322 = select(_e1318, _e1320, (_e1320 > _e1318));
                                                                        if (_e1292 == _e1322) {
                                                                            phi_1708_ = _e1129;
                                                                            phi_1709_ = _e1126;
                                                                            phi_1710_ = _e1116;
                                                                            phi_1711_ = _e1113;
                                                                            phi_1712_ = _e1265;
                                                                            phi_1713_ = _e1279;
                                                                            phi_1714_ = _e1275;
                                                                            phi_1715_ = _e1271;
                                                                        } else {
                                                                            let _e1324 = (_e1305 == _e1322);
                                                                            let _e1329 = vec3(_e1324);
                                                                            phi_1708_ = select(_e1116, _e1142, _e1324);
                                                                            phi_1709_ = select(_e1113, _e1139, _e1324);
                                                                            phi_1710_ = select(_e1142, _e1129, _e1324);
                                                                            phi_1711_ = select(_e1139, _e1126, _e1324);
                                                                            phi_1712_ = select(_e1267, _e1266, _e1329);
                                                                            phi_1713_ = select(_e1275, _e1271, _e1329);
                                                                            phi_1714_ = select(_e1271, _e1279, _e1329);
                                                                            phi_1715_ = select(_e1279, _e1275, _e1329);
                                                                        }
                                                                        let _e1335 = phi_1708_;
                                                                        let _e1337 = phi_1709_;
                                                                        let _e1339 = phi_1710_;
                                                                        let _e1341 = phi_1711_;
                                                                        let _e1343 = phi_1712_;
                                                                        let _e1345 = phi_1713_;
                                                                        let _e1347 = phi_1714_;
                                                                        let _e1349 = phi_1715_;
                                                                        let _e1356 = ((_e1347.y * _e1345.z) - (_e1345.y * _e1347.z));
                                                                        let _e1361 = ((_e1347.z * _e1345.x) - (_e1345.z * _e1347.x));
                                                                        let _e1364 = ((_e1347.x * _e1345.y) - (_e1345.x * _e1347.y));
                                                                        if (_e1164 >= _e1168) {
                                                                            phi_1746_ = select(true, false, (_e1164 >= _e1172));
                                                                        } else {
                                                                            phi_1746_ = true;
                                                                        }
                                                                        let _e1369 = phi_1746_;
                                                                        if _e1369 {
                                                                            phi_1755_ = select(_e1267, _e1266, vec3((_e1168 >= _e1172)));
                                                                        } else {
                                                                            phi_1755_ = _e1265;
                                                                        }
                                                                        let _e1374 = phi_1755_;
                                                                        let _e1385 = (((_e1356 * (_e1374.x - _e308)) + (_e1361 * (_e1374.y - _e347))) + (_e1364 * (_e1374.z - _e385)));
                                                                        let _e1390 = (((_e1356 * _e333) + (_e1361 * _e371)) + (_e1364 * _e409));
                                                                        let _e1391 = (_e1337 - _e1341);
                                                                        let _e1392 = (_e1335 - _e1339);
                                                                        let _e1400 = (-(((_e1341 * _e1391) + (_e1339 * _e1392))) / ((_e1391 * _e1391) + (_e1392 * _e1392)));
                                                                        let _e1402 = select(1f, _e1400, (_e1400 < 1f));
                                                                        let _e1404 = select(0f, _e1402, (_e1402 > 0f));
                                                                        let _e1417 = ((_e1343.x + (_e1349.x * _e1404)) - _e308);
                                                                        let _e1418 = ((_e1343.y + (_e1349.y * _e1404)) - _e347);
                                                                        let _e1419 = ((_e1343.z + (_e1349.z * _e1404)) - _e385);
                                                                        let _e1420 = (_e1419 / _e409);
                                                                        let _e1432 = bitcast<f32>((bitcast<u32>(_e1417) & 2147483647u));
                                                                        let _e1435 = bitcast<f32>((bitcast<u32>(_e1418) & 2147483647u));
                                                                        let _e1437 = select(_e1435, _e1432, (_e1432 > _e1435));
                                                                        let _e1440 = bitcast<f32>((bitcast<u32>(_e1419) & 2147483647u));
                                                                        let _e1442 = select(_e1440, _e1437, (_e1437 > _e1440));
                                                                        let _e1448 = bitcast<f32>((bitcast<u32>(_e1356) & 2147483647u));
                                                                        let _e1451 = bitcast<f32>((bitcast<u32>(_e1361) & 2147483647u));
                                                                        let _e1453 = select(_e1451, _e1448, (_e1448 > _e1451));
                                                                        let _e1456 = bitcast<f32>((bitcast<u32>(_e1364) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1356 * _e1417) + (_e1361 * _e1418)) + (_e1364 * _e1419)) - _e1385)) & 2147483647u)) <= ((0.0000009536743f * select(_e1322, _e1442, (_e1442 > _e1322))) * select(_e1456, _e1453, (_e1453 > _e1456)))) {
                                                                            let _e1466 = bitcast<f32>((bitcast<u32>(_e1347.x) & 2147483647u));
                                                                            let _e1469 = bitcast<f32>((bitcast<u32>(_e1347.y) & 2147483647u));
                                                                            let _e1471 = select(_e1469, _e1466, (_e1466 > _e1469));
                                                                            let _e1474 = bitcast<f32>((bitcast<u32>(_e1347.z) & 2147483647u));
                                                                            let _e1480 = bitcast<f32>((bitcast<u32>(_e1345.x) & 2147483647u));
                                                                            let _e1483 = bitcast<f32>((bitcast<u32>(_e1345.y) & 2147483647u));
                                                                            let _e1485 = select(_e1483, _e1480, (_e1480 > _e1483));
                                                                            let _e1488 = bitcast<f32>((bitcast<u32>(_e1345.z) & 2147483647u));
                                                                            let _e1492 = (bitcast<f32>((bitcast<u32>(_e1390) & 2147483647u)) > ((0.0000038146973f * select(_e1474, _e1471, (_e1471 > _e1474))) * select(_e1488, _e1485, (_e1485 > _e1488))));
                                                                            if _e1492 {
                                                                                phi_1920_ = (_e1385 / _e1390);
                                                                            } else {
                                                                                phi_1920_ = f32();
                                                                            }
                                                                            let _e1495 = phi_1920_;
                                                                            phi_1922_ = _e1495;
                                                                            phi_1923_ = select(true, false, _e1492);
                                                                        } else {
                                                                            phi_1922_ = f32();
                                                                            phi_1923_ = true;
                                                                        }
                                                                        let _e1498 = phi_1922_;
                                                                        let _e1500 = phi_1923_;
                                                                        if _e1500 {
                                                                            let _e1508 = (((_e1356 * (_e1417 - (_e333 * _e1420))) + (_e1361 * (_e1418 - (_e371 * _e1420)))) / _e1390);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1508) & 2147483647u)) <= _e1322) {
                                                                                phi_1943_ = (_e1420 + _e1508);
                                                                            } else {
                                                                                phi_1943_ = _e1420;
                                                                            }
                                                                            let _e1515 = phi_1943_;
                                                                            phi_1944_ = _e1515;
                                                                        } else {
                                                                            phi_1944_ = _e1498;
                                                                        }
                                                                        let _e1517 = phi_1944_;
                                                                        let _e1519 = select(_e1255, _e1517, (_e1517 < _e1255));
                                                                        let _e1521 = select(_e1247, _e1519, (_e1519 > _e1247));
                                                                        if (_e1521 >= _e459) {
                                                                            let _e1523 = (_e1521 <= _e1007);
                                                                            if _e1523 {
                                                                                let _e1524 = (1f / _e1174);
                                                                                phi_1967_ = type_21(_e1521, (_e1168 * _e1524), (_e1172 * _e1524), _e1036);
                                                                            } else {
                                                                                phi_1967_ = type_21();
                                                                            }
                                                                            let _e1529 = phi_1967_;
                                                                            phi_1969_ = _e1529;
                                                                            phi_1970_ = select(true, false, _e1523);
                                                                        } else {
                                                                            phi_1969_ = type_21();
                                                                            phi_1970_ = true;
                                                                        }
                                                                        let _e1532 = phi_1969_;
                                                                        let _e1534 = phi_1970_;
                                                                        if _e1534 {
                                                                            phi_1974_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1974_ = _e1532;
                                                                        }
                                                                        let _e1536 = phi_1974_;
                                                                        phi_1975_ = _e1536;
                                                                    }
                                                                    let _e1538 = phi_1975_;
                                                                    phi_1976_ = _e1538;
                                                                    phi_1977_ = _e1264;
                                                                }
                                                                let _e1540 = phi_1976_;
                                                                let _e1542 = phi_1977_;
                                                                phi_1981_ = _e1540;
                                                                phi_1982_ = _e1542;
                                                            }
                                                            let _e1544 = phi_1981_;
                                                            let _e1546 = phi_1982_;
                                                            phi_1983_ = _e1544;
                                                            phi_1984_ = _e1199;
                                                            phi_1985_ = _e1546;
                                                        }
                                                        let _e1548 = phi_1983_;
                                                        let _e1550 = phi_1984_;
                                                        let _e1552 = phi_1985_;
                                                        phi_1986_ = _e1548;
                                                        phi_1987_ = _e1550;
                                                        phi_1988_ = _e1552;
                                                    }
                                                    let _e1554 = phi_1986_;
                                                    let _e1556 = phi_1987_;
                                                    let _e1558 = phi_1988_;
                                                    phi_1996_ = _e1554;
                                                    phi_1997_ = select(_e1558, true, _e1556);
                                                } else {
                                                    phi_1996_ = type_21();
                                                    phi_1997_ = true;
                                                }
                                                let _e1561 = phi_1996_;
                                                let _e1563 = phi_1997_;
                                                if _e1563 {
                                                    phi_2001_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2001_ = _e1561;
                                                }
                                                let _e1565 = phi_2001_;
                                                if (_e1565.member_3 != 4294967295u) {
                                                    if (_e1036 != 4294967295u) {
                                                        phi_2013_ = type_4(0u, 8u);
                                                        phi_2016_ = _e1565;
                                                        loop {
                                                            let _e1570 = phi_2013_;
                                                            let _e1572 = phi_2016_;
                                                            if (_e1570.member < _e1570.member_1) {
                                                                phi_2014_ = type_4((_e1570.member + 1u), _e1570.member_1);
                                                                phi_2039_ = type_4(1u, _e1570.member);
                                                            } else {
                                                                phi_2014_ = _e1570;
                                                                phi_2039_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1585 = phi_2014_;
                                                            let _e1587 = phi_2039_;
                                                            let _e1591 = (bitcast<i32>(_e1587.member) != 0i);
                                                            if _e1591 {
                                                                let _e1592 = (_e1587.member_1 < 8u);
                                                                if _e1592 {
                                                                } else {
                                                                    phi_3753_ = true;
                                                                    break;
                                                                }
                                                                let _e1597 = local_9[_e1587.member_1].member;
                                                                if (_e1572.member < _e1597) {
                                                                    phi_2072_ = true;
                                                                } else {
                                                                    let _e1599 = local_9[_e1587.member_1].member;
                                                                    if (_e1572.member == _e1599) {
                                                                        let _e1604 = local_9[_e1587.member_1].member_3;
                                                                        phi_2071_ = (_e1572.member_3 < _e1604);
                                                                    } else {
                                                                        phi_2071_ = false;
                                                                    }
                                                                    let _e1607 = phi_2071_;
                                                                    phi_2072_ = _e1607;
                                                                }
                                                                let _e1609 = phi_2072_;
                                                                if _e1609 {
                                                                    if _e1592 {
                                                                    } else {
                                                                        phi_3753_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1610 = local_9[_e1587.member_1];
                                                                    local_9[_e1587.member_1] = type_21(_e1572.member, _e1572.member_1, _e1572.member_2, _e1572.member_3);
                                                                    phi_2093_ = type_21(_e1610.member, _e1610.member_1, _e1610.member_2, _e1610.member_3);
                                                                } else {
                                                                    phi_2093_ = _e1572;
                                                                }
                                                                let _e1621 = phi_2093_;
                                                                phi_2017_ = _e1621;
                                                            } else {
                                                                phi_2017_ = type_21();
                                                            }
                                                            let _e1623 = phi_2017_;
                                                            continue;
                                                            continuing {
                                                                phi_2013_ = _e1585;
                                                                phi_2016_ = _e1623;
                                                                phi_3753_ = _e1005;
                                                                break if !(_e1591);
                                                            }
                                                        }
                                                        let _e1626 = phi_3753_;
                                                        phi_4037_ = _e1007;
                                                        phi_3895_ = _e1626;
                                                        if _e1626 {
                                                            break;
                                                        }
                                                        let _e1629 = local_9[7u].member_3;
                                                        if (_e1629 != 4294967295u) {
                                                            let _e1633 = local_9[7u].member;
                                                            phi_4128_ = _e1633;
                                                        } else {
                                                            phi_4128_ = _e1007;
                                                        }
                                                        let _e1635 = phi_4128_;
                                                        phi_4127_ = _e1635;
                                                        phi_3898_ = _e1626;
                                                    } else {
                                                        phi_4127_ = _e1007;
                                                        phi_3898_ = _e1005;
                                                    }
                                                    let _e1637 = phi_4127_;
                                                    let _e1639 = phi_3898_;
                                                    phi_4126_ = _e1637;
                                                    phi_3897_ = _e1639;
                                                } else {
                                                    phi_4126_ = _e1007;
                                                    phi_3897_ = _e1005;
                                                }
                                                let _e1641 = phi_4126_;
                                                let _e1643 = phi_3897_;
                                                phi_4125_ = _e1641;
                                                phi_3896_ = _e1643;
                                            } else {
                                                phi_4125_ = _e1007;
                                                phi_3896_ = _e1005;
                                            }
                                            let _e1645 = phi_4125_;
                                            let _e1647 = phi_3896_;
                                            continue;
                                            continuing {
                                                phi_3762_ = _e1647;
                                                phi_3752_ = _e1645;
                                                phi_1026_ = _e1022;
                                                phi_4037_ = _e1645;
                                                phi_3895_ = _e1647;
                                                break if !(_e1028);
                                            }
                                        }
                                        let _e1650 = phi_4037_;
                                        let _e1652 = phi_3895_;
                                        phi_3900_ = _e1652;
                                        if _e1652 {
                                            break;
                                        }
                                        phi_4002_ = _e1650;
                                        phi_3904_ = _e1652;
                                        phi_3310_ = _e540;
                                        phi_3311_ = false;
                                        phi_3312_ = _e544;
                                    } else {
                                        if (_e540.member_1 >= _e89) {
                                            phi_2865_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e540.member_1 < _e89) {
                                            } else {
                                                phi_3900_ = true;
                                                break;
                                            }
                                            let _e555 = (_e259 * 2u);
                                            let _e557 = ((1u + _e555) % 7u);
                                            if (_e557 < 7u) {
                                            } else {
                                                phi_3900_ = true;
                                                break;
                                            }
                                            let _e562 = global_5.member[_e540.member_1][_e557];
                                            let _e564 = ((_e555 + 2u) % 7u);
                                            if (_e564 < 7u) {
                                            } else {
                                                phi_3900_ = true;
                                                break;
                                            }
                                            let _e569 = global_5.member[_e540.member_1][_e564];
                                            let _e570 = (_e258 * 2u);
                                            let _e572 = ((1u + _e570) % 7u);
                                            if (_e572 < 7u) {
                                            } else {
                                                phi_3900_ = true;
                                                break;
                                            }
                                            let _e577 = global_5.member[_e540.member_1][_e572];
                                            let _e579 = ((_e570 + 2u) % 7u);
                                            if (_e579 < 7u) {
                                            } else {
                                                phi_3900_ = true;
                                                break;
                                            }
                                            let _e584 = global_5.member[_e540.member_1][_e579];
                                            let _e585 = (_e260 * 2u);
                                            let _e587 = ((1u + _e585) % 7u);
                                            if (_e587 < 7u) {
                                            } else {
                                                phi_3900_ = true;
                                                break;
                                            }
                                            let _e592 = global_5.member[_e540.member_1][_e587];
                                            let _e594 = ((_e585 + 2u) % 7u);
                                            if (_e594 < 7u) {
                                            } else {
                                                phi_3900_ = true;
                                                break;
                                            }
                                            let _e599 = global_5.member[_e540.member_1][_e594];
                                            let _e622 = (bitcast<f32>((bitcast<u32>((_e540.member.member_1.x - _e540.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e623 = (bitcast<f32>((bitcast<u32>((_e540.member.member_1.y - _e540.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e624 = (bitcast<f32>((bitcast<u32>((_e540.member.member_1.z - _e540.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e626 = select(_e139, _e622, (_e622 > _e139));
                                            let _e628 = select(_e139, _e623, (_e623 > _e139));
                                            let _e630 = select(_e139, _e624, (_e624 > _e139));
                                            let _e655 = bitcast<u32>((f32(bitcast<i32>((_e562 & 2097151u))) * _e626));
                                            let _e660 = (bitcast<i32>((_e562 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e663 = bitcast<f32>((_e655 & bitcast<u32>(_e660)));
                                            let _e664 = bitcast<u32>((f32(bitcast<i32>((_e577 & 2097151u))) * _e628));
                                            let _e669 = (bitcast<i32>((_e577 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e672 = bitcast<f32>((_e664 & bitcast<u32>(_e669)));
                                            let _e673 = bitcast<u32>((f32(bitcast<i32>((_e592 & 2097151u))) * _e630));
                                            let _e678 = (bitcast<i32>((_e592 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e681 = bitcast<f32>((_e673 & bitcast<u32>(_e678)));
                                            let _e685 = bitcast<f32>((_e655 & bitcast<u32>(~(_e660))));
                                            let _e689 = bitcast<f32>((_e664 & bitcast<u32>(~(_e669))));
                                            let _e693 = bitcast<f32>((_e673 & bitcast<u32>(~(_e678))));
                                            let _e694 = bitcast<u32>((f32(bitcast<i32>((_e569 & 2097151u))) * _e626));
                                            let _e699 = (bitcast<i32>((_e569 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e702 = bitcast<f32>((_e694 & bitcast<u32>(_e699)));
                                            let _e703 = bitcast<u32>((f32(bitcast<i32>((_e584 & 2097151u))) * _e628));
                                            let _e708 = (bitcast<i32>((_e584 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e711 = bitcast<f32>((_e703 & bitcast<u32>(_e708)));
                                            let _e712 = bitcast<u32>((f32(bitcast<i32>((_e599 & 2097151u))) * _e630));
                                            let _e717 = (bitcast<i32>((_e599 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e720 = bitcast<f32>((_e712 & bitcast<u32>(_e717)));
                                            let _e724 = bitcast<f32>((_e694 & bitcast<u32>(~(_e699))));
                                            let _e728 = bitcast<f32>((_e703 & bitcast<u32>(~(_e708))));
                                            let _e732 = bitcast<f32>((_e712 & bitcast<u32>(~(_e717))));
                                            let _e762 = global_5.member[_e540.member_1][0u];
                                            let _e766 = global_5.member[_e540.member_1][2u];
                                            let _e770 = global_5.member[_e540.member_1][4u];
                                            let _e774 = global_5.member[_e540.member_1][6u];
                                            let _e786 = (((_e766 >> bitcast<u32>(22i)) | ((_e770 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e774 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e787 = (_e762 & 268435455u);
                                            let _e788 = (_e786 & 268435455u);
                                            let _e791 = ((_e762 >> bitcast<u32>(28u)) & 7u);
                                            let _e799 = ((_e762 >> bitcast<u32>(31i)) | (((_e786 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e800 = (_e791 != 0u);
                                            if (_e791 == 0u) {
                                                phi_2827_ = _e787;
                                            } else {
                                                if (_e791 == 7u) {
                                                    phi_2826_ = 2147483648u;
                                                } else {
                                                    phi_2826_ = ((2147483648u | (_e791 << bitcast<u32>(28u))) | (_e788 & 268435455u));
                                                }
                                                let _e809 = phi_2826_;
                                                phi_2827_ = _e809;
                                            }
                                            let _e811 = phi_2827_;
                                            if _e800 {
                                                let _e812 = (_e791 != 7u);
                                                if _e812 {
                                                    phi_2837_ = (_e788 + _e791);
                                                } else {
                                                    phi_2837_ = u32();
                                                }
                                                let _e815 = phi_2837_;
                                                phi_2839_ = _e815;
                                                phi_2840_ = select(true, false, _e812);
                                            } else {
                                                phi_2839_ = u32();
                                                phi_2840_ = true;
                                            }
                                            let _e818 = phi_2839_;
                                            let _e820 = phi_2840_;
                                            if (_e799 == 0u) {
                                                phi_2861_ = (_e787 + select(0u, 1u, !(_e800)));
                                            } else {
                                                if (_e799 == 7u) {
                                                    phi_2860_ = 2147483648u;
                                                } else {
                                                    phi_2860_ = ((2147483648u | (_e799 << bitcast<u32>(28u))) | (select(_e818, _e788, _e820) & 268435455u));
                                                }
                                                let _e833 = phi_2860_;
                                                phi_2861_ = _e833;
                                            }
                                            let _e835 = phi_2861_;
                                            phi_2865_ = type_53(array<vec4<f32>, 3>(vec4<f32>((_e540.member.member.x + _e663), (_e540.member.member.x + _e685), (_e540.member.member_1.x - _e702), (_e540.member.member_1.x - _e724)), vec4<f32>((_e540.member.member.y + _e672), (_e540.member.member.y + _e689), (_e540.member.member_1.y - _e711), (_e540.member.member_1.y - _e728)), vec4<f32>((_e540.member.member.z + _e681), (_e540.member.member.z + _e693), (_e540.member.member_1.z - _e720), (_e540.member.member_1.z - _e732))), type_52(type_25((_e540.member.member + vec4<f32>(_e663, _e672, _e681, 0f)), (_e540.member.member_1 - vec4<f32>(_e702, _e711, _e720, 0f))), _e811), type_52(type_25((_e540.member.member + vec4<f32>(_e685, _e689, _e693, 0f)), (_e540.member.member_1 - vec4<f32>(_e724, _e728, _e732, 0f))), _e835));
                                        }
                                        let _e840 = phi_2865_;
                                        let _e851 = ((_e840.member[0].x - _e331) * _e336);
                                        let _e852 = ((_e840.member[0].y - _e331) * _e336);
                                        let _e853 = ((_e840.member[0].z - _e332) * _e336);
                                        let _e854 = ((_e840.member[0].w - _e332) * _e336);
                                        let _e864 = ((_e840.member[1].x - _e369) * _e374);
                                        let _e865 = ((_e840.member[1].y - _e369) * _e374);
                                        let _e866 = ((_e840.member[1].z - _e370) * _e374);
                                        let _e867 = ((_e840.member[1].w - _e370) * _e374);
                                        let _e877 = ((_e840.member[2].x - _e407) * _e412);
                                        let _e878 = ((_e840.member[2].y - _e407) * _e412);
                                        let _e879 = ((_e840.member[2].z - _e408) * _e412);
                                        let _e880 = ((_e840.member[2].w - _e408) * _e412);
                                        let _e882 = select(_e879, _e877, (_e877 < _e879));
                                        let _e884 = select(_e880, _e878, (_e878 < _e880));
                                        let _e886 = select(_e879, _e877, (_e877 > _e879));
                                        let _e888 = select(_e880, _e878, (_e878 > _e880));
                                        let _e890 = select(_e853, _e851, (_e851 < _e853));
                                        let _e892 = select(_e854, _e852, (_e852 < _e854));
                                        let _e894 = select(_e866, _e864, (_e864 < _e866));
                                        let _e896 = select(_e867, _e865, (_e865 < _e867));
                                        let _e898 = select(_e894, _e890, (_e890 > _e894));
                                        let _e900 = select(_e896, _e892, (_e892 > _e896));
                                        let _e902 = select(_e882, _e898, (_e898 > _e882));
                                        let _e904 = select(_e884, _e900, (_e900 > _e884));
                                        let _e906 = select(_e853, _e851, (_e851 > _e853));
                                        let _e908 = select(_e854, _e852, (_e852 > _e854));
                                        let _e910 = select(_e866, _e864, (_e864 > _e866));
                                        let _e912 = select(_e867, _e865, (_e865 > _e867));
                                        let _e914 = select(_e910, _e906, (_e906 < _e910));
                                        let _e916 = select(_e912, _e908, (_e908 < _e912));
                                        let _e921 = -(_e882);
                                        let _e922 = -(_e884);
                                        let _e929 = (select(_e886, _e914, (_e914 < _e886)) + (select(_e921, _e886, (_e886 > _e921)) * 0.0000019073523f));
                                        let _e930 = (select(_e888, _e916, (_e916 < _e888)) + (select(_e922, _e888, (_e888 > _e922)) * 0.0000019073523f));
                                        let _e932 = select(_e459, _e902, (_e902 > _e459));
                                        let _e934 = select(_e459, _e904, (_e904 > _e459));
                                        let _e939 = (_e932 <= select(_e502, _e929, (_e929 < _e502)));
                                        let _e940 = (_e934 <= select(_e502, _e930, (_e930 < _e502)));
                                        let _e941 = (_e932 <= _e934);
                                        if _e939 {
                                            if _e940 {
                                                if _e941 {
                                                    phi_3210_ = _e840.member_2;
                                                } else {
                                                    phi_3210_ = _e840.member_1;
                                                }
                                                let _e945 = phi_3210_;
                                                let _e967 = (_e544 % 128u);
                                                let _e968 = (_e967 < 128u);
                                                if _e968 {
                                                } else {
                                                    phi_3900_ = true;
                                                    break;
                                                }
                                                local_8[_e967] = _e945.member_1;
                                                if _e968 {
                                                } else {
                                                    phi_3900_ = true;
                                                    break;
                                                }
                                                local_7[_e967] = _e945.member.member.x;
                                                if _e968 {
                                                } else {
                                                    phi_3900_ = true;
                                                    break;
                                                }
                                                local_6[_e967] = _e945.member.member.y;
                                                if _e968 {
                                                } else {
                                                    phi_3900_ = true;
                                                    break;
                                                }
                                                local_5[_e967] = _e945.member.member.z;
                                                if _e968 {
                                                } else {
                                                    phi_3900_ = true;
                                                    break;
                                                }
                                                local_4[_e967] = _e945.member.member_1.x;
                                                if _e968 {
                                                } else {
                                                    phi_3900_ = true;
                                                    break;
                                                }
                                                local_3[_e967] = _e945.member.member_1.y;
                                                if _e968 {
                                                } else {
                                                    phi_3900_ = true;
                                                    break;
                                                }
                                                local_2[_e967] = _e945.member.member_1.z;
                                                if _e968 {
                                                } else {
                                                    phi_3900_ = true;
                                                    break;
                                                }
                                                local_10[_e967] = select(_e934, _e932, (_e932 > _e934));
                                                if _e941 {
                                                    phi_3287_ = _e840.member_1;
                                                } else {
                                                    phi_3287_ = _e840.member_2;
                                                }
                                                let _e981 = phi_3287_;
                                                phi_3288_ = _e981;
                                                phi_3289_ = (_e544 + 1u);
                                            } else {
                                                phi_3288_ = type_52();
                                                phi_3289_ = u32();
                                            }
                                            let _e983 = phi_3288_;
                                            let _e985 = phi_3289_;
                                            phi_3291_ = _e983;
                                            phi_3292_ = _e985;
                                            phi_3293_ = select(true, false, _e940);
                                        } else {
                                            phi_3291_ = type_52();
                                            phi_3292_ = u32();
                                            phi_3293_ = true;
                                        }
                                        let _e988 = phi_3291_;
                                        let _e990 = phi_3292_;
                                        let _e992 = phi_3293_;
                                        if _e992 {
                                            if _e939 {
                                                phi_3302_ = _e840.member_1;
                                            } else {
                                                phi_3302_ = _e840.member_2;
                                            }
                                            let _e996 = phi_3302_;
                                            phi_3307_ = _e996;
                                            phi_3308_ = select(_e940, true, _e939);
                                        } else {
                                            phi_3307_ = _e988;
                                            phi_3308_ = _e542;
                                        }
                                        let _e999 = phi_3307_;
                                        let _e1001 = phi_3308_;
                                        phi_4002_ = _e502;
                                        phi_3904_ = _e500;
                                        phi_3310_ = _e999;
                                        phi_3311_ = _e1001;
                                        phi_3312_ = select(_e990, _e544, _e992);
                                    }
                                    let _e1654 = phi_4002_;
                                    let _e1656 = phi_3904_;
                                    let _e1658 = phi_3310_;
                                    let _e1660 = phi_3311_;
                                    let _e1662 = phi_3312_;
                                    phi_4001_ = _e1654;
                                    phi_3903_ = _e1656;
                                    phi_3313_ = _e1658;
                                    phi_3314_ = (_e506 - 1u);
                                    phi_3315_ = _e1660;
                                    phi_3316_ = _e1662;
                                } else {
                                    phi_4001_ = _e502;
                                    phi_3903_ = _e500;
                                    phi_3313_ = _e540;
                                    phi_3314_ = _e506;
                                    phi_3315_ = _e542;
                                    phi_3316_ = _e544;
                                }
                                let _e1664 = phi_4001_;
                                let _e1666 = phi_3903_;
                                let _e1668 = phi_3313_;
                                let _e1670 = phi_3314_;
                                let _e1672 = phi_3315_;
                                let _e1674 = phi_3316_;
                                phi_4000_ = _e1664;
                                phi_3902_ = _e1666;
                                phi_3317_ = _e1668;
                                phi_3318_ = _e1670;
                                phi_3319_ = _e1672;
                                phi_3320_ = _e1674;
                            } else {
                                phi_4000_ = _e502;
                                phi_3902_ = _e500;
                                phi_3317_ = type_52();
                                phi_3318_ = u32();
                                phi_3319_ = bool();
                                phi_3320_ = u32();
                            }
                            let _e1676 = phi_4000_;
                            let _e1678 = phi_3902_;
                            let _e1680 = phi_3317_;
                            let _e1682 = phi_3318_;
                            let _e1684 = phi_3319_;
                            let _e1686 = phi_3320_;
                            phi_3999_ = _e1676;
                            phi_3901_ = _e1678;
                            phi_902_ = _e1680;
                            phi_905_ = _e1682;
                            phi_907_ = _e1684;
                            phi_909_ = _e1686;
                            phi_3321_ = _e514;
                        } else {
                            phi_3999_ = _e502;
                            phi_3901_ = _e500;
                            phi_902_ = type_52();
                            phi_905_ = u32();
                            phi_907_ = bool();
                            phi_909_ = u32();
                            phi_3321_ = false;
                        }
                        let _e1688 = phi_3999_;
                        let _e1690 = phi_3901_;
                        let _e1692 = phi_902_;
                        let _e1694 = phi_905_;
                        let _e1696 = phi_907_;
                        let _e1698 = phi_909_;
                        let _e1700 = phi_3321_;
                        continue;
                        continuing {
                            phi_3765_ = _e1690;
                            phi_3693_ = _e1688;
                            phi_901_ = _e1692;
                            phi_904_ = _e1694;
                            phi_906_ = _e1696;
                            phi_908_ = _e1698;
                            phi_3900_ = _e1690;
                            break if !(_e1700);
                        }
                    }
                    let _e1703 = phi_3900_;
                    if _e1703 {
                        break;
                    }
                    phi_3328_ = type_4(0u, 8u);
                    loop {
                        let _e1705 = phi_3328_;
                        if (_e1705.member < _e1705.member_1) {
                            phi_3329_ = type_4((_e1705.member + 1u), _e1705.member_1);
                            phi_3352_ = type_4(1u, _e1705.member);
                        } else {
                            phi_3329_ = _e1705;
                            phi_3352_ = type_4(0u, type_4().member_1);
                        }
                        let _e1718 = phi_3329_;
                        let _e1720 = phi_3352_;
                        let _e1724 = (bitcast<i32>(_e1720.member) != 0i);
                        if _e1724 {
                            let _e1725 = (_e1720.member_1 < 8u);
                            if _e1725 {
                            } else {
                                phi_3992_ = true;
                                break;
                            }
                            let _e1727 = local_9[_e1720.member_1];
                            if (_e1727.member_3 != 4294967295u) {
                                let _e1733 = -(_e426);
                                let _e1734 = (_e1733 / 3i);
                                let _e1741 = bitcast<f32>((bitcast<u32>((_e1734 + 127i)) << bitcast<u32>(23i)));
                                let _e1749 = (((_e1727.member * _e1741) * _e1741) * bitcast<f32>((bitcast<u32>(((_e1733 - (2i * _e1734)) + 127i)) << bitcast<u32>(23i))));
                                let _e1751 = select(340282350000000000000000000000000000000f, _e1749, (_e1749 < 340282350000000000000000000000000000000f));
                                phi_3418_ = type_21(select(-340282350000000000000000000000000000000f, _e1751, (_e1751 > -340282350000000000000000000000000000000f)), _e1727.member_1, _e1727.member_2, _e1727.member_3);
                            } else {
                                phi_3418_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1756 = phi_3418_;
                            if _e1725 {
                            } else {
                                phi_3992_ = true;
                                break;
                            }
                            local_9[_e1720.member_1] = type_21(_e1756.member, _e1756.member_1, _e1756.member_2, _e1756.member_3);
                        }
                        continue;
                        continuing {
                            phi_3328_ = _e1718;
                            phi_3992_ = _e1703;
                            break if !(_e1724);
                        }
                    }
                    let _e1764 = phi_3992_;
                    if _e1764 {
                        break;
                    }
                    let _e1765 = local_9;
                    if _e147 {
                    } else {
                        break;
                    }
                    global_6.member[_e145] = array<type_21, 8>(type_21(_e1765[0].member, _e1765[0].member_1, _e1765[0].member_2, _e1765[0].member_3), type_21(_e1765[1].member, _e1765[1].member_1, _e1765[1].member_2, _e1765[1].member_3), type_21(_e1765[2].member, _e1765[2].member_1, _e1765[2].member_2, _e1765[2].member_3), type_21(_e1765[3].member, _e1765[3].member_1, _e1765[3].member_2, _e1765[3].member_3), type_21(_e1765[4].member, _e1765[4].member_1, _e1765[4].member_2, _e1765[4].member_3), type_21(_e1765[5].member, _e1765[5].member_1, _e1765[5].member_2, _e1765[5].member_3), type_21(_e1765[6].member, _e1765[6].member_1, _e1765[6].member_2, _e1765[6].member_3), type_21(_e1765[7].member, _e1765[7].member_1, _e1765[7].member_2, _e1765[7].member_3));
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
