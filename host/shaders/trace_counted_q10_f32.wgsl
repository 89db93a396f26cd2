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
    member: array<array<u32, 2>>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_35 {
    member: type_28,
    member_1: f32,
}

struct type_40 {
    member: array<type_29>,
}

struct type_42 {
    member: type_35,
    member_1: u32,
    member_2: u32,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: type_32,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_19;
@group(0) @binding(1) 
var<uniform> global_3: type_44;
@group(0) @binding(2) 
var<storage> global_4: type_9;
@group(0) @binding(4) 
var<storage> global_5: type_40;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_25;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_49, 128>;
    var phi_378_: i32;
    var phi_379_: i32;
    var phi_389_: bool;
    var phi_399_: u32;
    var phi_400_: u32;
    var phi_402_: bool;
    var phi_407_: u32;
    var phi_452_: f32;
    var phi_458_: f32;
    var phi_469_: f32;
    var phi_475_: f32;
    var phi_498_: f32;
    var phi_509_: f32;
    var phi_518_: f32;
    var phi_524_: f32;
    var phi_535_: f32;
    var phi_541_: f32;
    var phi_564_: f32;
    var phi_575_: f32;
    var phi_584_: f32;
    var phi_590_: f32;
    var phi_601_: f32;
    var phi_607_: f32;
    var phi_630_: f32;
    var phi_641_: f32;
    var phi_741_: f32;
    var phi_742_: f32;
    var phi_4208_: bool;
    var phi_1863_: type_42;
    var phi_1866_: type_49;
    var phi_1868_: u32;
    var phi_1870_: bool;
    var phi_1872_: u32;
    var phi_1883_: bool;
    var phi_1920_: type_49;
    var phi_1921_: bool;
    var phi_1922_: u32;
    var phi_3557_: u32;
    var phi_3558_: u32;
    var phi_3568_: u32;
    var phi_3570_: u32;
    var phi_3571_: bool;
    var phi_3591_: u32;
    var phi_3592_: u32;
    var phi_3596_: type_52;
    var phi_3940_: type_49;
    var phi_3973_: type_49;
    var phi_3974_: type_49;
    var phi_3975_: u32;
    var phi_3977_: type_49;
    var phi_3978_: u32;
    var phi_3979_: bool;
    var phi_3988_: type_49;
    var phi_3993_: type_49;
    var phi_3994_: bool;
    var phi_1940_: type_42;
    var phi_1943_: type_4;
    var phi_1944_: type_4;
    var phi_1966_: type_4;
    var phi_1990_: u32;
    var phi_2079_: array<array<f32, 3>, 3>;
    var phi_2550_: vec3<f32>;
    var phi_2551_: vec3<f32>;
    var phi_2582_: bool;
    var phi_2591_: vec3<f32>;
    var phi_2631_: type_28;
    var phi_2633_: type_28;
    var phi_2634_: bool;
    var phi_2638_: type_28;
    var phi_2639_: type_28;
    var phi_2640_: type_28;
    var phi_2641_: bool;
    var phi_2645_: type_28;
    var phi_2646_: bool;
    var phi_2650_: type_28;
    var phi_2651_: bool;
    var phi_2655_: type_28;
    var phi_2680_: bool;
    var phi_2681_: bool;
    var phi_2688_: type_42;
    var phi_2689_: type_42;
    var phi_2690_: type_42;
    var phi_1941_: type_42;
    var phi_4202_: bool;
    var phi_4316_: bool;
    var phi_3996_: type_42;
    var phi_3997_: type_49;
    var phi_3998_: bool;
    var phi_3999_: u32;
    var phi_4315_: bool;
    var phi_4000_: type_42;
    var phi_4001_: type_49;
    var phi_4002_: u32;
    var phi_4003_: bool;
    var phi_4004_: u32;
    var phi_4314_: bool;
    var phi_4005_: type_42;
    var phi_4006_: type_49;
    var phi_4007_: u32;
    var phi_4008_: bool;
    var phi_4009_: u32;
    var phi_4313_: bool;
    var phi_1864_: type_42;
    var phi_1867_: type_49;
    var phi_1869_: u32;
    var phi_1871_: bool;
    var phi_1873_: u32;
    var phi_4010_: bool;
    var phi_4312_: bool;
    var local_4: type_42;
    var local_5: type_42;
    var local_6: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e77 = global;
            let _e79 = arrayLength((&global_4.member));
            let _e81 = arrayLength((&global_2.member));
            let _e89 = global_3.member[0u][0u];
            let _e93 = global_3.member[0u][1u];
            let _e97 = global_3.member[0u][2u];
            let _e101 = global_3.member[0u][3u];
            let _e105 = global_3.member[1u][0u];
            let _e109 = global_3.member[1u][1u];
            let _e113 = global_3.member[1u][2u];
            let _e116 = global_1.member[0u];
            let _e117 = bitcast<i32>(_e116);
            let _e129 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e101) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e89), bitcast<i32>(_e93), bitcast<i32>(_e97));
            local = array<i32, 3>(bitcast<i32>(_e105), bitcast<i32>(_e109), bitcast<i32>(_e113));
            let _e135 = (_e77.x + (_e77.y * 2097152u));
            let _e136 = (_e135 < arrayLength((&global_5.member)));
            if _e136 {
                let _e137 = (_e135 < arrayLength((&global_6.member)));
                if _e137 {
                    if _e136 {
                    } else {
                        break;
                    }
                    let _e145 = global_5.member[_e135].member_2[0u];
                    let _e147 = (bitcast<u32>(_e145) & 2147483647u);
                    let _e152 = global_5.member[_e135].member_2[1u];
                    let _e154 = (bitcast<u32>(_e152) & 2147483647u);
                    let _e159 = global_5.member[_e135].member_2[2u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_5.member[_e135].member[0u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_5.member[_e135].member[1u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_5.member[_e135].member[2u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e184 = select(_e154, _e147, (_e154 < _e147));
                    let _e186 = select(_e161, _e184, (_e161 < _e184));
                    let _e188 = select(_e168, _e186, (_e168 < _e186));
                    let _e190 = select(_e175, _e188, (_e175 < _e188));
                    let _e192 = select(_e182, _e190, (_e182 < _e190));
                    let _e196 = global_5.member[_e135].member_1;
                    let _e198 = (bitcast<u32>(_e196) & 2147483647u);
                    let _e205 = global_5.member[_e135].member_3;
                    let _e211 = (((select(_e198, _e192, (_e198 < _e192)) < 2139095040u) && ((bitcast<u32>(_e205) & 2147483647u) <= 2139095040u)) && (_e186 > 0u));
                    if _e211 {
                        let _e214 = (bitcast<u32>(bitcast<f32>(_e186)) & 2147483647u);
                        if (_e214 >= 8388608u) {
                            phi_378_ = (bitcast<i32>((_e214 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_378_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e214)), 32u, (_e214 == 0u))));
                        }
                        let _e228 = phi_378_;
                        phi_379_ = _e228;
                    } else {
                        phi_379_ = 0i;
                    }
                    let _e230 = phi_379_;
                    let _e231 = (_e147 == _e186);
                    if _e231 {
                        phi_389_ = true;
                    } else {
                        phi_389_ = (_e154 == _e186);
                    }
                    let _e234 = phi_389_;
                    let _e235 = select(1u, 0u, _e231);
                    if _e234 {
                        let _e236 = (_e235 + 1u);
                        phi_399_ = _e236;
                        phi_400_ = _e236;
                        phi_402_ = select(true, false, (_e236 == 2u));
                    } else {
                        phi_399_ = u32();
                        phi_400_ = 0u;
                        phi_402_ = true;
                    }
                    let _e240 = phi_399_;
                    let _e242 = phi_400_;
                    let _e244 = phi_402_;
                    if _e244 {
                        phi_407_ = (_e242 + 1u);
                    } else {
                        phi_407_ = 0u;
                    }
                    let _e248 = phi_407_;
                    let _e249 = select(_e240, _e242, _e244);
                    let _e250 = select(_e235, select(2u, _e235, _e234), _e244);
                    let _e251 = (_e117 / 2i);
                    let _e256 = bitcast<f32>((bitcast<u32>((_e251 + 127i)) << bitcast<u32>(23i)));
                    let _e262 = bitcast<f32>((bitcast<u32>(((_e117 - _e251) + 127i)) << bitcast<u32>(23i)));
                    let _e263 = -(_e230);
                    let _e264 = (_e263 / 2i);
                    let _e269 = bitcast<f32>((bitcast<u32>((_e264 + 127i)) << bitcast<u32>(23i)));
                    let _e275 = bitcast<f32>((bitcast<u32>(((_e263 - _e264) + 127i)) << bitcast<u32>(23i)));
                    let _e279 = global_5.member[_e135].member;
                    let _e280 = (_e249 == 0u);
                    if _e280 {
                        phi_452_ = _e279[0];
                    } else {
                        phi_452_ = _e279[1];
                    }
                    let _e284 = phi_452_;
                    let _e285 = (_e249 == 2u);
                    if _e285 {
                        phi_458_ = _e279[2];
                    } else {
                        phi_458_ = _e284;
                    }
                    let _e288 = phi_458_;
                    let _e290 = ((_e288 * _e256) * _e262);
                    let _e291 = global_5.member[_e135].member_2;
                    if _e280 {
                        phi_469_ = _e291[0];
                    } else {
                        phi_469_ = _e291[1];
                    }
                    let _e295 = phi_469_;
                    if _e285 {
                        phi_475_ = _e291[2];
                    } else {
                        phi_475_ = _e295;
                    }
                    let _e298 = phi_475_;
                    let _e300 = ((_e298 * _e269) * _e275);
                    let _e304 = (bitcast<f32>((bitcast<u32>(_e300) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e304 {
                        let _e308 = (bitcast<f32>((bitcast<u32>(_e290) & 2147483647u)) * 0.00000011920929f);
                        phi_498_ = select(0.00000000000011368684f, _e308, (_e308 > 0.00000000000011368684f));
                    } else {
                        phi_498_ = 0f;
                    }
                    let _e312 = phi_498_;
                    let _e313 = (_e290 + _e312);
                    let _e314 = (_e290 - _e312);
                    let _e315 = select(_e300, 0f, _e304);
                    if _e304 {
                        phi_509_ = 38685626000000000000000000f;
                    } else {
                        phi_509_ = (1f / _e300);
                    }
                    let _e318 = phi_509_;
                    let _e319 = (_e248 == 0u);
                    if _e319 {
                        phi_518_ = _e279[0];
                    } else {
                        phi_518_ = _e279[1];
                    }
                    let _e323 = phi_518_;
                    let _e324 = (_e248 == 2u);
                    if _e324 {
                        phi_524_ = _e279[2];
                    } else {
                        phi_524_ = _e323;
                    }
                    let _e327 = phi_524_;
                    let _e329 = ((_e327 * _e256) * _e262);
                    if _e319 {
                        phi_535_ = _e291[0];
                    } else {
                        phi_535_ = _e291[1];
                    }
                    let _e333 = phi_535_;
                    if _e324 {
                        phi_541_ = _e291[2];
                    } else {
                        phi_541_ = _e333;
                    }
                    let _e336 = phi_541_;
                    let _e338 = ((_e336 * _e269) * _e275);
                    let _e342 = (bitcast<f32>((bitcast<u32>(_e338) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e342 {
                        let _e346 = (bitcast<f32>((bitcast<u32>(_e329) & 2147483647u)) * 0.00000011920929f);
                        phi_564_ = select(0.00000000000011368684f, _e346, (_e346 > 0.00000000000011368684f));
                    } else {
                        phi_564_ = 0f;
                    }
                    let _e350 = phi_564_;
                    let _e351 = (_e329 + _e350);
                    let _e352 = (_e329 - _e350);
                    let _e353 = select(_e338, 0f, _e342);
                    if _e342 {
                        phi_575_ = 38685626000000000000000000f;
                    } else {
                        phi_575_ = (1f / _e338);
                    }
                    let _e356 = phi_575_;
                    let _e357 = (_e250 == 0u);
                    if _e357 {
                        phi_584_ = _e279[0];
                    } else {
                        phi_584_ = _e279[1];
                    }
                    let _e361 = phi_584_;
                    let _e362 = (_e250 == 2u);
                    if _e362 {
                        phi_590_ = _e279[2];
                    } else {
                        phi_590_ = _e361;
                    }
                    let _e365 = phi_590_;
                    let _e367 = ((_e365 * _e256) * _e262);
                    if _e357 {
                        phi_601_ = _e291[0];
                    } else {
                        phi_601_ = _e291[1];
                    }
                    let _e371 = phi_601_;
                    if _e362 {
                        phi_607_ = _e291[2];
                    } else {
                        phi_607_ = _e371;
                    }
                    let _e374 = phi_607_;
                    let _e376 = ((_e374 * _e269) * _e275);
                    let _e380 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e380 {
                        let _e384 = (bitcast<f32>((bitcast<u32>(_e367) & 2147483647u)) * 0.00000011920929f);
                        phi_630_ = select(0.00000000000011368684f, _e384, (_e384 > 0.00000000000011368684f));
                    } else {
                        phi_630_ = 0f;
                    }
                    let _e388 = phi_630_;
                    let _e389 = (_e367 + _e388);
                    let _e390 = (_e367 - _e388);
                    let _e391 = select(_e376, 0f, _e380);
                    if _e380 {
                        phi_641_ = 38685626000000000000000000f;
                    } else {
                        phi_641_ = (1f / _e376);
                    }
                    let _e394 = phi_641_;
                    let _e397 = bitcast<f32>((bitcast<u32>(_e290) & 2147483647u));
                    let _e400 = bitcast<f32>((bitcast<u32>(_e329) & 2147483647u));
                    let _e402 = select(_e400, _e397, (_e397 > _e400));
                    let _e405 = bitcast<f32>((bitcast<u32>(_e367) & 2147483647u));
                    let _e408 = (_e117 + _e230);
                    if (_e211 && (select(_e405, _e402, (_e402 > _e405)) <= 1099511600000f)) {
                        let _e411 = (_e408 / 3i);
                        let _e418 = bitcast<f32>((bitcast<u32>((_e411 + 127i)) << bitcast<u32>(23i)));
                        let _e425 = bitcast<f32>((bitcast<u32>(((_e408 - (2i * _e411)) + 127i)) << bitcast<u32>(23i)));
                        let _e426 = (((_e196 * _e418) * _e418) * _e425);
                        let _e428 = select(340282350000000000000000000000000000000f, _e426, (_e426 < 340282350000000000000000000000000000000f));
                        let _e433 = (((_e205 * _e418) * _e418) * _e425);
                        let _e435 = select(340282350000000000000000000000000000000f, _e433, (_e433 < 340282350000000000000000000000000000000f));
                        phi_741_ = select(-340282350000000000000000000000000000000f, _e435, (_e435 > -340282350000000000000000000000000000000f));
                        phi_742_ = select(-340282350000000000000000000000000000000f, _e428, (_e428 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_741_ = 0f;
                        phi_742_ = 1f;
                    }
                    let _e439 = phi_741_;
                    let _e441 = phi_742_;
                    local_3 = array<type_49, 128>(type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e446 = (_e249 % 3u);
                    let _e447 = (_e446 < 3u);
                    if _e447 {
                    } else {
                        break;
                    }
                    let _e449 = local_1[_e446];
                    let _e452 = (_e248 % 3u);
                    let _e453 = (_e452 < 3u);
                    if _e453 {
                    } else {
                        break;
                    }
                    let _e455 = local_1[_e452];
                    let _e458 = (_e250 % 3u);
                    let _e459 = (_e458 < 3u);
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e461 = local_1[_e458];
                    if _e447 {
                    } else {
                        break;
                    }
                    let _e466 = local[_e446];
                    if _e453 {
                    } else {
                        break;
                    }
                    let _e470 = local[_e452];
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e474 = local[_e458];
                    phi_4208_ = false;
                    phi_1863_ = type_42(type_35(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e439), 0u, 0u);
                    phi_1866_ = type_49(type_32(vec4<f32>((f32(_e449) * _e129), (f32(_e455) * _e129), (f32(_e461) * _e129), 0f), vec4<f32>((f32(_e466) * _e129), (f32(_e470) * _e129), (f32(_e474) * _e129), 0f)), select(0u, 2147483648u, (_e79 == 0u)));
                    phi_1868_ = ((3u * _e79) + 1u);
                    phi_1870_ = (_e441 <= _e439);
                    phi_1872_ = 0u;
                    loop {
                        let _e484 = phi_4208_;
                        let _e486 = phi_1863_;
                        let _e488 = phi_1866_;
                        let _e490 = phi_1868_;
                        let _e492 = phi_1870_;
                        let _e494 = phi_1872_;
                        local_4 = _e486;
                        local_5 = _e486;
                        if _e492 {
                            phi_1883_ = true;
                        } else {
                            phi_1883_ = (_e494 > 0u);
                        }
                        let _e497 = phi_1883_;
                        if _e497 {
                            let _e498 = (_e490 > 0u);
                            if _e498 {
                                if _e492 {
                                    phi_1920_ = _e488;
                                    phi_1921_ = _e492;
                                    phi_1922_ = _e494;
                                } else {
                                    let _e499 = (_e494 - 1u);
                                    let _e500 = (_e499 % 128u);
                                    let _e501 = (_e500 < 128u);
                                    if _e501 {
                                    } else {
                                        phi_4312_ = true;
                                        break;
                                    }
                                    let _e503 = local_3[_e500];
                                    if _e501 {
                                    } else {
                                        phi_4312_ = true;
                                        break;
                                    }
                                    let _e511 = local_2[_e500];
                                    phi_1920_ = type_49(type_32(_e503.member.member, _e503.member.member_1), _e503.member_1);
                                    phi_1921_ = (_e511 <= _e486.member.member_1);
                                    phi_1922_ = _e499;
                                }
                                let _e516 = phi_1920_;
                                let _e518 = phi_1921_;
                                let _e520 = phi_1922_;
                                if _e518 {
                                    if ((_e516.member_1 & 2147483648u) != 0u) {
                                        phi_1940_ = _e486;
                                        phi_1943_ = type_4(0u, ((_e516.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e973 = phi_1940_;
                                            let _e975 = phi_1943_;
                                            local_6 = _e973;
                                            if (_e975.member < _e975.member_1) {
                                                phi_1944_ = type_4((_e975.member + 1u), _e975.member_1);
                                                phi_1966_ = type_4(1u, _e975.member);
                                            } else {
                                                phi_1944_ = _e975;
                                                phi_1966_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e988 = phi_1944_;
                                            let _e990 = phi_1966_;
                                            let _e994 = (bitcast<i32>(_e990.member) != 0i);
                                            if _e994 {
                                                let _e1000 = type_42(_e973.member, _e973.member_1, (_e973.member_2 + 1u));
                                                let _e1001 = ((_e516.member_1 & 268435455u) + _e990.member_1);
                                                let _e1002 = (_e1001 < _e81);
                                                if _e1002 {
                                                    if _e1002 {
                                                    } else {
                                                        phi_4202_ = true;
                                                        break;
                                                    }
                                                    let _e1006 = global_2.member[_e1001].member_1;
                                                    phi_1990_ = _e1006;
                                                } else {
                                                    phi_1990_ = 4294967295u;
                                                }
                                                let _e1008 = phi_1990_;
                                                if (_e1001 >= _e81) {
                                                    phi_2079_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1002 {
                                                    } else {
                                                        phi_4202_ = true;
                                                        break;
                                                    }
                                                    if (_e446 < 9u) {
                                                    } else {
                                                        phi_4202_ = true;
                                                        break;
                                                    }
                                                    let _e1015 = global_2.member[_e1001].member[_e446];
                                                    if (_e452 < 9u) {
                                                    } else {
                                                        phi_4202_ = true;
                                                        break;
                                                    }
                                                    let _e1021 = global_2.member[_e1001].member[_e452];
                                                    if (_e458 < 9u) {
                                                    } else {
                                                        phi_4202_ = true;
                                                        break;
                                                    }
                                                    let _e1027 = global_2.member[_e1001].member[_e458];
                                                    let _e1029 = (3u + _e446);
                                                    if (_e1029 < 9u) {
                                                    } else {
                                                        phi_4202_ = true;
                                                        break;
                                                    }
                                                    let _e1035 = global_2.member[_e1001].member[_e1029];
                                                    let _e1036 = (3u + _e452);
                                                    if (_e1036 < 9u) {
                                                    } else {
                                                        phi_4202_ = true;
                                                        break;
                                                    }
                                                    let _e1042 = global_2.member[_e1001].member[_e1036];
                                                    let _e1043 = (3u + _e458);
                                                    if (_e1043 < 9u) {
                                                    } else {
                                                        phi_4202_ = true;
                                                        break;
                                                    }
                                                    let _e1049 = global_2.member[_e1001].member[_e1043];
                                                    let _e1051 = (6u + _e446);
                                                    if (_e1051 < 9u) {
                                                    } else {
                                                        phi_4202_ = true;
                                                        break;
                                                    }
                                                    let _e1057 = global_2.member[_e1001].member[_e1051];
                                                    let _e1058 = (6u + _e452);
                                                    if (_e1058 < 9u) {
                                                    } else {
                                                        phi_4202_ = true;
                                                        break;
                                                    }
                                                    let _e1064 = global_2.member[_e1001].member[_e1058];
                                                    let _e1065 = (6u + _e458);
                                                    if (_e1065 < 9u) {
                                                    } else {
                                                        phi_4202_ = true;
                                                        break;
                                                    }
                                                    let _e1071 = global_2.member[_e1001].member[_e1065];
                                                    phi_2079_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1015, _e1021, _e1027), array<f32, 3>(_e1035, _e1042, _e1049), array<f32, 3>(_e1057, _e1064, _e1071));
                                                }
                                                let _e1075 = phi_2079_;
                                                let _e1084 = (_e1075[0][2] - _e367);
                                                let _e1087 = (((_e1075[0][0] - _e290) * _e391) - (_e1084 * _e315));
                                                let _e1090 = (((_e1075[0][1] - _e329) * _e391) - (_e1084 * _e353));
                                                let _e1097 = (_e1075[1][2] - _e367);
                                                let _e1100 = (((_e1075[1][0] - _e290) * _e391) - (_e1097 * _e315));
                                                let _e1103 = (((_e1075[1][1] - _e329) * _e391) - (_e1097 * _e353));
                                                let _e1110 = (_e1075[2][2] - _e367);
                                                let _e1113 = (((_e1075[2][0] - _e290) * _e391) - (_e1110 * _e315));
                                                let _e1116 = (((_e1075[2][1] - _e329) * _e391) - (_e1110 * _e353));
                                                let _e1117 = (_e1113 * _e1103);
                                                let _e1118 = (_e1116 * _e1100);
                                                let _e1119 = (_e1087 * _e1116);
                                                let _e1120 = (_e1090 * _e1113);
                                                let _e1121 = (_e1100 * _e1090);
                                                let _e1122 = (_e1103 * _e1087);
                                                let _e1127 = (((_e1117 >= _e1118) && (_e1119 >= _e1120)) && (_e1121 >= _e1122));
                                                if (_e1127 || (((_e1117 <= _e1118) && (_e1119 <= _e1120)) && (_e1121 <= _e1122))) {
                                                    let _e1134 = select(-1f, 1f, _e1127);
                                                    let _e1136 = ((_e1117 - _e1118) * _e1134);
                                                    let _e1138 = select(0f, _e1136, (_e1136 > 0f));
                                                    let _e1140 = ((_e1119 - _e1120) * _e1134);
                                                    let _e1142 = select(0f, _e1140, (_e1140 > 0f));
                                                    let _e1144 = ((_e1121 - _e1122) * _e1134);
                                                    let _e1146 = select(0f, _e1144, (_e1144 > 0f));
                                                    let _e1148 = ((_e1138 + _e1142) + _e1146);
                                                    if (_e1148 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2645_ = type_28();
                                                        phi_2646_ = true;
                                                    } else {
                                                        let _e1151 = select(_e1075[1][0], _e1075[0][0], (_e1075[0][0] < _e1075[1][0]));
                                                        let _e1155 = select(_e1075[1][0], _e1075[0][0], (_e1075[0][0] > _e1075[1][0]));
                                                        let _e1159 = select(_e1075[1][1], _e1075[0][1], (_e1075[0][1] < _e1075[1][1]));
                                                        let _e1163 = select(_e1075[1][1], _e1075[0][1], (_e1075[0][1] > _e1075[1][1]));
                                                        let _e1167 = select(_e1075[1][2], _e1075[0][2], (_e1075[0][2] < _e1075[1][2]));
                                                        let _e1171 = select(_e1075[1][2], _e1075[0][2], (_e1075[0][2] > _e1075[1][2]));
                                                        let _e1176 = ((select(_e1075[2][0], _e1151, (_e1151 < _e1075[2][0])) - _e313) * _e318);
                                                        let _e1177 = ((select(_e1075[2][0], _e1155, (_e1155 > _e1075[2][0])) - _e314) * _e318);
                                                        let _e1180 = ((select(_e1075[2][1], _e1159, (_e1159 < _e1075[2][1])) - _e351) * _e356);
                                                        let _e1181 = ((select(_e1075[2][1], _e1163, (_e1163 > _e1075[2][1])) - _e352) * _e356);
                                                        let _e1184 = ((select(_e1075[2][2], _e1167, (_e1167 < _e1075[2][2])) - _e389) * _e394);
                                                        let _e1185 = ((select(_e1075[2][2], _e1171, (_e1171 > _e1075[2][2])) - _e390) * _e394);
                                                        let _e1187 = select(_e1185, _e1184, (_e1184 < _e1185));
                                                        let _e1189 = select(_e1185, _e1184, (_e1184 > _e1185));
                                                        let _e1191 = select(_e1177, _e1176, (_e1176 < _e1177));
                                                        let _e1193 = select(_e1181, _e1180, (_e1180 < _e1181));
                                                        let _e1195 = select(_e1193, _e1191, (_e1191 > _e1193));
                                                        let _e1197 = select(_e1187, _e1195, (_e1195 > _e1187));
                                                        let _e1199 = select(_e1177, _e1176, (_e1176 > _e1177));
                                                        let _e1201 = select(_e1181, _e1180, (_e1180 > _e1181));
                                                        let _e1203 = select(_e1201, _e1199, (_e1199 < _e1201));
                                                        let _e1205 = select(_e1189, _e1203, (_e1203 < _e1189));
                                                        let _e1206 = -(_e1187);
                                                        let _e1212 = select(_e441, _e1197, (_e1197 > _e441));
                                                        if (_e1212 > (_e1205 + (select(_e1206, _e1189, (_e1189 > _e1206)) * 0.0000019073523f))) {
                                                            phi_2640_ = type_28();
                                                            phi_2641_ = true;
                                                        } else {
                                                            let _e1214 = (_e1212 > _e973.member.member_1);
                                                            if _e1214 {
                                                                phi_2639_ = type_28();
                                                            } else {
                                                                let _e1218 = (_e1075[1][0] - _e1075[0][0]);
                                                                let _e1219 = (_e1075[1][1] - _e1075[0][1]);
                                                                let _e1220 = (_e1075[1][2] - _e1075[0][2]);
                                                                let _e1221 = vec3<f32>(_e1218, _e1219, _e1220);
                                                                let _e1222 = (_e1075[2][0] - _e1075[1][0]);
                                                                let _e1223 = (_e1075[2][1] - _e1075[1][1]);
                                                                let _e1224 = (_e1075[2][2] - _e1075[1][2]);
                                                                let _e1225 = vec3<f32>(_e1222, _e1223, _e1224);
                                                                let _e1226 = (_e1075[0][0] - _e1075[2][0]);
                                                                let _e1227 = (_e1075[0][1] - _e1075[2][1]);
                                                                let _e1228 = (_e1075[0][2] - _e1075[2][2]);
                                                                let _e1229 = vec3<f32>(_e1226, _e1227, _e1228);
                                                                let _e1232 = bitcast<f32>((bitcast<u32>(_e1218) & 2147483647u));
                                                                let _e1235 = bitcast<f32>((bitcast<u32>(_e1219) & 2147483647u));
                                                                let _e1237 = select(_e1235, _e1232, (_e1232 > _e1235));
                                                                let _e1240 = bitcast<f32>((bitcast<u32>(_e1220) & 2147483647u));
                                                                let _e1242 = select(_e1240, _e1237, (_e1237 > _e1240));
                                                                let _e1245 = bitcast<f32>((bitcast<u32>(_e1222) & 2147483647u));
                                                                let _e1248 = bitcast<f32>((bitcast<u32>(_e1223) & 2147483647u));
                                                                let _e1250 = select(_e1248, _e1245, (_e1245 > _e1248));
                                                                let _e1253 = bitcast<f32>((bitcast<u32>(_e1224) & 2147483647u));
                                                                let _e1255 = select(_e1253, _e1250, (_e1250 > _e1253));
                                                                let _e1258 = bitcast<f32>((bitcast<u32>(_e1226) & 2147483647u));
                                                                let _e1261 = bitcast<f32>((bitcast<u32>(_e1227) & 2147483647u));
                                                                let _e1263 = select(_e1261, _e1258, (_e1258 > _e1261));
                                                                let _e1266 = bitcast<f32>((bitcast<u32>(_e1228) & 2147483647u));
                                                                let _e1268 = select(_e1266, _e1263, (_e1263 > _e1266));
                                                                let _e1270 = select(_e1255, _e1242, (_e1242 > _e1255));
                                                                let _e1272 = select(_e1268, _e1270, (_e1270 > _e1268));
                                                                if (_e1242 == _e1272) {
                                                                    phi_2550_ = _e1225;
                                                                    phi_2551_ = _e1229;
                                                                } else {
                                                                    let _e1275 = vec3((_e1255 == _e1272));
                                                                    phi_2550_ = select(_e1221, _e1229, _e1275);
                                                                    phi_2551_ = select(_e1225, _e1221, _e1275);
                                                                }
                                                                let _e1279 = phi_2550_;
                                                                let _e1281 = phi_2551_;
                                                                let _e1288 = ((_e1279.y * _e1281.z) - (_e1281.y * _e1279.z));
                                                                let _e1293 = ((_e1279.z * _e1281.x) - (_e1281.z * _e1279.x));
                                                                let _e1296 = ((_e1279.x * _e1281.y) - (_e1281.x * _e1279.y));
                                                                if (_e1138 >= _e1142) {
                                                                    phi_2582_ = select(true, false, (_e1138 >= _e1146));
                                                                } else {
                                                                    phi_2582_ = true;
                                                                }
                                                                let _e1301 = phi_2582_;
                                                                if _e1301 {
                                                                    phi_2591_ = select(vec3<f32>(_e1075[2][0], _e1075[2][1], _e1075[2][2]), vec3<f32>(_e1075[1][0], _e1075[1][1], _e1075[1][2]), vec3((_e1142 >= _e1146)));
                                                                } else {
                                                                    phi_2591_ = vec3<f32>(_e1075[0][0], _e1075[0][1], _e1075[0][2]);
                                                                }
                                                                let _e1306 = phi_2591_;
                                                                let _e1323 = ((((_e1288 * (_e1306.x - _e290)) + (_e1293 * (_e1306.y - _e329))) + (_e1296 * (_e1306.z - _e367))) / (((_e1288 * _e315) + (_e1293 * _e353)) + (_e1296 * _e391)));
                                                                let _e1325 = select(_e1205, _e1323, (_e1323 < _e1205));
                                                                let _e1327 = select(_e1197, _e1325, (_e1325 > _e1197));
                                                                if (_e1327 >= _e441) {
                                                                    let _e1329 = (_e1327 <= _e973.member.member_1);
                                                                    if _e1329 {
                                                                        let _e1330 = (1f / _e1148);
                                                                        phi_2631_ = type_28(_e1327, (_e1142 * _e1330), (_e1146 * _e1330), _e1008);
                                                                    } else {
                                                                        phi_2631_ = type_28();
                                                                    }
                                                                    let _e1335 = phi_2631_;
                                                                    phi_2633_ = _e1335;
                                                                    phi_2634_ = select(true, false, _e1329);
                                                                } else {
                                                                    phi_2633_ = type_28();
                                                                    phi_2634_ = true;
                                                                }
                                                                let _e1338 = phi_2633_;
                                                                let _e1340 = phi_2634_;
                                                                if _e1340 {
                                                                    phi_2638_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2638_ = _e1338;
                                                                }
                                                                let _e1342 = phi_2638_;
                                                                phi_2639_ = _e1342;
                                                            }
                                                            let _e1344 = phi_2639_;
                                                            phi_2640_ = _e1344;
                                                            phi_2641_ = _e1214;
                                                        }
                                                        let _e1346 = phi_2640_;
                                                        let _e1348 = phi_2641_;
                                                        phi_2645_ = _e1346;
                                                        phi_2646_ = _e1348;
                                                    }
                                                    let _e1350 = phi_2645_;
                                                    let _e1352 = phi_2646_;
                                                    phi_2650_ = _e1350;
                                                    phi_2651_ = _e1352;
                                                } else {
                                                    phi_2650_ = type_28();
                                                    phi_2651_ = true;
                                                }
                                                let _e1354 = phi_2650_;
                                                let _e1356 = phi_2651_;
                                                if _e1356 {
                                                    phi_2655_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2655_ = _e1354;
                                                }
                                                let _e1358 = phi_2655_;
                                                if (_e1358.member_3 != 4294967295u) {
                                                    if (_e1008 != 4294967295u) {
                                                        if (_e1358.member < _e973.member.member.member) {
                                                            phi_2681_ = true;
                                                        } else {
                                                            if (_e1358.member == _e973.member.member.member) {
                                                                phi_2680_ = (_e1358.member_3 < _e973.member.member.member_3);
                                                            } else {
                                                                phi_2680_ = false;
                                                            }
                                                            let _e1373 = phi_2680_;
                                                            phi_2681_ = _e1373;
                                                        }
                                                        let _e1375 = phi_2681_;
                                                        if _e1375 {
                                                            phi_2688_ = type_42(type_35(_e1358, _e1358.member), _e1000.member_1, _e1000.member_2);
                                                        } else {
                                                            phi_2688_ = _e1000;
                                                        }
                                                        let _e1382 = phi_2688_;
                                                        phi_2689_ = _e1382;
                                                    } else {
                                                        phi_2689_ = _e1000;
                                                    }
                                                    let _e1384 = phi_2689_;
                                                    phi_2690_ = _e1384;
                                                } else {
                                                    phi_2690_ = _e1000;
                                                }
                                                let _e1386 = phi_2690_;
                                                phi_1941_ = _e1386;
                                            } else {
                                                phi_1941_ = type_42();
                                            }
                                            let _e1388 = phi_1941_;
                                            continue;
                                            continuing {
                                                phi_1940_ = _e1388;
                                                phi_1943_ = _e988;
                                                phi_4202_ = _e484;
                                                break if !(_e994);
                                            }
                                        }
                                        let _e1391 = phi_4202_;
                                        phi_4312_ = _e1391;
                                        if _e1391 {
                                            break;
                                        }
                                        phi_4316_ = _e1391;
                                        let _e1542 = local_6;
                                        phi_3996_ = _e1542;
                                        phi_3997_ = _e516;
                                        phi_3998_ = false;
                                        phi_3999_ = _e520;
                                    } else {
                                        if (_e516.member_1 >= _e79) {
                                            phi_3596_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e516.member_1 < _e79) {
                                            } else {
                                                phi_4312_ = true;
                                                break;
                                            }
                                            let _e538 = ((1u + _e249) % 4u);
                                            if (_e538 < 4u) {
                                            } else {
                                                phi_4312_ = true;
                                                break;
                                            }
                                            let _e543 = global_4.member[_e516.member_1][_e538];
                                            let _e545 = ((1u + _e248) % 4u);
                                            if (_e545 < 4u) {
                                            } else {
                                                phi_4312_ = true;
                                                break;
                                            }
                                            let _e550 = global_4.member[_e516.member_1][_e545];
                                            let _e552 = ((1u + _e250) % 4u);
                                            if (_e552 < 4u) {
                                            } else {
                                                phi_4312_ = true;
                                                break;
                                            }
                                            let _e557 = global_4.member[_e516.member_1][_e552];
                                            let _e559 = ((_e249 + 1u) % 4u);
                                            if (_e559 < 4u) {
                                            } else {
                                                phi_4312_ = true;
                                                break;
                                            }
                                            let _e564 = global_4.member[_e516.member_1][_e559];
                                            let _e566 = (_e564 >> bitcast<u32>(11u));
                                            let _e568 = ((_e248 + 1u) % 4u);
                                            if (_e568 < 4u) {
                                            } else {
                                                phi_4312_ = true;
                                                break;
                                            }
                                            let _e573 = global_4.member[_e516.member_1][_e568];
                                            let _e575 = (_e573 >> bitcast<u32>(11u));
                                            let _e577 = ((_e250 + 1u) % 4u);
                                            if (_e577 < 4u) {
                                            } else {
                                                phi_4312_ = true;
                                                break;
                                            }
                                            let _e582 = global_4.member[_e516.member_1][_e577];
                                            let _e584 = (_e582 >> bitcast<u32>(11u));
                                            let _e607 = (bitcast<f32>((bitcast<u32>((_e516.member.member_1.x - _e516.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e608 = (bitcast<f32>((bitcast<u32>((_e516.member.member_1.y - _e516.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e609 = (bitcast<f32>((bitcast<u32>((_e516.member.member_1.z - _e516.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e611 = select(_e129, _e607, (_e607 > _e129));
                                            let _e613 = select(_e129, _e608, (_e608 > _e129));
                                            let _e615 = select(_e129, _e609, (_e609 > _e129));
                                            let _e640 = bitcast<u32>((f32(bitcast<i32>((_e543 & 1023u))) * _e611));
                                            let _e645 = (bitcast<i32>((_e543 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e648 = bitcast<f32>((_e640 & bitcast<u32>(_e645)));
                                            let _e649 = bitcast<u32>((f32(bitcast<i32>((_e550 & 1023u))) * _e613));
                                            let _e654 = (bitcast<i32>((_e550 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e657 = bitcast<f32>((_e649 & bitcast<u32>(_e654)));
                                            let _e658 = bitcast<u32>((f32(bitcast<i32>((_e557 & 1023u))) * _e615));
                                            let _e663 = (bitcast<i32>((_e557 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e666 = bitcast<f32>((_e658 & bitcast<u32>(_e663)));
                                            let _e670 = bitcast<f32>((_e640 & bitcast<u32>(~(_e645))));
                                            let _e674 = bitcast<f32>((_e649 & bitcast<u32>(~(_e654))));
                                            let _e678 = bitcast<f32>((_e658 & bitcast<u32>(~(_e663))));
                                            let _e679 = bitcast<u32>((f32(bitcast<i32>((_e566 & 1023u))) * _e611));
                                            let _e684 = (bitcast<i32>((_e566 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e687 = bitcast<f32>((_e679 & bitcast<u32>(_e684)));
                                            let _e688 = bitcast<u32>((f32(bitcast<i32>((_e575 & 1023u))) * _e613));
                                            let _e693 = (bitcast<i32>((_e575 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e696 = bitcast<f32>((_e688 & bitcast<u32>(_e693)));
                                            let _e697 = bitcast<u32>((f32(bitcast<i32>((_e584 & 1023u))) * _e615));
                                            let _e702 = (bitcast<i32>((_e584 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e705 = bitcast<f32>((_e697 & bitcast<u32>(_e702)));
                                            let _e709 = bitcast<f32>((_e679 & bitcast<u32>(~(_e684))));
                                            let _e713 = bitcast<f32>((_e688 & bitcast<u32>(~(_e693))));
                                            let _e717 = bitcast<f32>((_e697 & bitcast<u32>(~(_e702))));
                                            let _e747 = global_4.member[_e516.member_1][0u];
                                            let _e751 = global_4.member[_e516.member_1][1u];
                                            let _e755 = global_4.member[_e516.member_1][2u];
                                            let _e759 = global_4.member[_e516.member_1][3u];
                                            let _e771 = (((_e751 >> bitcast<u32>(22i)) | ((_e755 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e759 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e772 = (_e747 & 268435455u);
                                            let _e773 = (_e771 & 268435455u);
                                            let _e776 = ((_e747 >> bitcast<u32>(28u)) & 7u);
                                            let _e784 = ((_e747 >> bitcast<u32>(31i)) | (((_e771 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e785 = (_e776 != 0u);
                                            if (_e776 == 0u) {
                                                phi_3558_ = _e772;
                                            } else {
                                                if (_e776 == 7u) {
                                                    phi_3557_ = 2147483648u;
                                                } else {
                                                    phi_3557_ = ((2147483648u | (_e776 << bitcast<u32>(28u))) | (_e773 & 268435455u));
                                                }
                                                let _e794 = phi_3557_;
                                                phi_3558_ = _e794;
                                            }
                                            let _e796 = phi_3558_;
                                            if _e785 {
                                                let _e797 = (_e776 != 7u);
                                                if _e797 {
                                                    phi_3568_ = (_e773 + _e776);
                                                } else {
                                                    phi_3568_ = u32();
                                                }
                                                let _e800 = phi_3568_;
                                                phi_3570_ = _e800;
                                                phi_3571_ = select(true, false, _e797);
                                            } else {
                                                phi_3570_ = u32();
                                                phi_3571_ = true;
                                            }
                                            let _e803 = phi_3570_;
                                            let _e805 = phi_3571_;
                                            if (_e784 == 0u) {
                                                phi_3592_ = (_e772 + select(0u, 1u, !(_e785)));
                                            } else {
                                                if (_e784 == 7u) {
                                                    phi_3591_ = 2147483648u;
                                                } else {
                                                    phi_3591_ = ((2147483648u | (_e784 << bitcast<u32>(28u))) | (select(_e803, _e773, _e805) & 268435455u));
                                                }
                                                let _e818 = phi_3591_;
                                                phi_3592_ = _e818;
                                            }
                                            let _e820 = phi_3592_;
                                            phi_3596_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e516.member.member.x + _e648), (_e516.member.member.x + _e670), (_e516.member.member_1.x - _e687), (_e516.member.member_1.x - _e709)), vec4<f32>((_e516.member.member.y + _e657), (_e516.member.member.y + _e674), (_e516.member.member_1.y - _e696), (_e516.member.member_1.y - _e713)), vec4<f32>((_e516.member.member.z + _e666), (_e516.member.member.z + _e678), (_e516.member.member_1.z - _e705), (_e516.member.member_1.z - _e717))), type_49(type_32((_e516.member.member + vec4<f32>(_e648, _e657, _e666, 0f)), (_e516.member.member_1 - vec4<f32>(_e687, _e696, _e705, 0f))), _e796), type_49(type_32((_e516.member.member + vec4<f32>(_e670, _e674, _e678, 0f)), (_e516.member.member_1 - vec4<f32>(_e709, _e713, _e717, 0f))), _e820));
                                        }
                                        let _e825 = phi_3596_;
                                        let _e838 = ((_e825.member[0].x - _e313) * _e318);
                                        let _e839 = ((_e825.member[0].y - _e313) * _e318);
                                        let _e840 = ((_e825.member[0].z - _e314) * _e318);
                                        let _e841 = ((_e825.member[0].w - _e314) * _e318);
                                        let _e851 = ((_e825.member[1].x - _e351) * _e356);
                                        let _e852 = ((_e825.member[1].y - _e351) * _e356);
                                        let _e853 = ((_e825.member[1].z - _e352) * _e356);
                                        let _e854 = ((_e825.member[1].w - _e352) * _e356);
                                        let _e864 = ((_e825.member[2].x - _e389) * _e394);
                                        let _e865 = ((_e825.member[2].y - _e389) * _e394);
                                        let _e866 = ((_e825.member[2].z - _e390) * _e394);
                                        let _e867 = ((_e825.member[2].w - _e390) * _e394);
                                        let _e869 = select(_e866, _e864, (_e864 < _e866));
                                        let _e871 = select(_e867, _e865, (_e865 < _e867));
                                        let _e873 = select(_e866, _e864, (_e864 > _e866));
                                        let _e875 = select(_e867, _e865, (_e865 > _e867));
                                        let _e877 = select(_e840, _e838, (_e838 < _e840));
                                        let _e879 = select(_e841, _e839, (_e839 < _e841));
                                        let _e881 = select(_e853, _e851, (_e851 < _e853));
                                        let _e883 = select(_e854, _e852, (_e852 < _e854));
                                        let _e885 = select(_e881, _e877, (_e877 > _e881));
                                        let _e887 = select(_e883, _e879, (_e879 > _e883));
                                        let _e889 = select(_e869, _e885, (_e885 > _e869));
                                        let _e891 = select(_e871, _e887, (_e887 > _e871));
                                        let _e893 = select(_e840, _e838, (_e838 > _e840));
                                        let _e895 = select(_e841, _e839, (_e839 > _e841));
                                        let _e897 = select(_e853, _e851, (_e851 > _e853));
                                        let _e899 = select(_e854, _e852, (_e852 > _e854));
                                        let _e901 = select(_e897, _e893, (_e893 < _e897));
                                        let _e903 = select(_e899, _e895, (_e895 < _e899));
                                        let _e908 = -(_e869);
                                        let _e909 = -(_e871);
                                        let _e916 = (select(_e873, _e901, (_e901 < _e873)) + (select(_e908, _e873, (_e873 > _e908)) * 0.0000019073523f));
                                        let _e917 = (select(_e875, _e903, (_e903 < _e875)) + (select(_e909, _e875, (_e875 > _e909)) * 0.0000019073523f));
                                        let _e919 = select(_e441, _e889, (_e889 > _e441));
                                        let _e921 = select(_e441, _e891, (_e891 > _e441));
                                        let _e926 = (_e919 <= select(_e486.member.member_1, _e916, (_e916 < _e486.member.member_1)));
                                        let _e927 = (_e921 <= select(_e486.member.member_1, _e917, (_e917 < _e486.member.member_1)));
                                        let _e928 = (_e919 <= _e921);
                                        if _e926 {
                                            if _e927 {
                                                if _e928 {
                                                    phi_3940_ = _e825.member_2;
                                                } else {
                                                    phi_3940_ = _e825.member_1;
                                                }
                                                let _e932 = phi_3940_;
                                                let _e933 = (_e520 % 128u);
                                                let _e934 = (_e933 < 128u);
                                                if _e934 {
                                                } else {
                                                    phi_4312_ = true;
                                                    break;
                                                }
                                                local_3[_e933] = type_49(type_32(_e932.member.member, _e932.member.member_1), _e932.member_1);
                                                if _e934 {
                                                } else {
                                                    phi_4312_ = true;
                                                    break;
                                                }
                                                local_2[_e933] = select(_e921, _e919, (_e919 > _e921));
                                                if _e928 {
                                                    phi_3973_ = _e825.member_1;
                                                } else {
                                                    phi_3973_ = _e825.member_2;
                                                }
                                                let _e949 = phi_3973_;
                                                phi_3974_ = _e949;
                                                phi_3975_ = (_e520 + 1u);
                                            } else {
                                                phi_3974_ = type_49();
                                                phi_3975_ = u32();
                                            }
                                            let _e951 = phi_3974_;
                                            let _e953 = phi_3975_;
                                            phi_3977_ = _e951;
                                            phi_3978_ = _e953;
                                            phi_3979_ = select(true, false, _e927);
                                        } else {
                                            phi_3977_ = type_49();
                                            phi_3978_ = u32();
                                            phi_3979_ = true;
                                        }
                                        let _e956 = phi_3977_;
                                        let _e958 = phi_3978_;
                                        let _e960 = phi_3979_;
                                        if _e960 {
                                            if _e926 {
                                                phi_3988_ = _e825.member_1;
                                            } else {
                                                phi_3988_ = _e825.member_2;
                                            }
                                            let _e964 = phi_3988_;
                                            phi_3993_ = _e964;
                                            phi_3994_ = select(_e927, true, _e926);
                                        } else {
                                            phi_3993_ = _e956;
                                            phi_3994_ = _e518;
                                        }
                                        let _e967 = phi_3993_;
                                        let _e969 = phi_3994_;
                                        phi_4316_ = _e484;
                                        phi_3996_ = type_42(_e486.member, (_e486.member_1 + 1u), _e486.member_2);
                                        phi_3997_ = _e967;
                                        phi_3998_ = _e969;
                                        phi_3999_ = select(_e958, _e520, _e960);
                                    }
                                    let _e1393 = phi_4316_;
                                    let _e1395 = phi_3996_;
                                    let _e1397 = phi_3997_;
                                    let _e1399 = phi_3998_;
                                    let _e1401 = phi_3999_;
                                    phi_4315_ = _e1393;
                                    phi_4000_ = _e1395;
                                    phi_4001_ = _e1397;
                                    phi_4002_ = (_e490 - 1u);
                                    phi_4003_ = _e1399;
                                    phi_4004_ = _e1401;
                                } else {
                                    phi_4315_ = _e484;
                                    phi_4000_ = _e486;
                                    phi_4001_ = _e516;
                                    phi_4002_ = _e490;
                                    phi_4003_ = _e518;
                                    phi_4004_ = _e520;
                                }
                                let _e1403 = phi_4315_;
                                let _e1405 = phi_4000_;
                                let _e1407 = phi_4001_;
                                let _e1409 = phi_4002_;
                                let _e1411 = phi_4003_;
                                let _e1413 = phi_4004_;
                                phi_4314_ = _e1403;
                                phi_4005_ = _e1405;
                                phi_4006_ = _e1407;
                                phi_4007_ = _e1409;
                                phi_4008_ = _e1411;
                                phi_4009_ = _e1413;
                            } else {
                                phi_4314_ = _e484;
                                phi_4005_ = type_42();
                                phi_4006_ = type_49();
                                phi_4007_ = u32();
                                phi_4008_ = bool();
                                phi_4009_ = u32();
                            }
                            let _e1415 = phi_4314_;
                            let _e1417 = phi_4005_;
                            let _e1419 = phi_4006_;
                            let _e1421 = phi_4007_;
                            let _e1423 = phi_4008_;
                            let _e1425 = phi_4009_;
                            phi_4313_ = _e1415;
                            phi_1864_ = _e1417;
                            phi_1867_ = _e1419;
                            phi_1869_ = _e1421;
                            phi_1871_ = _e1423;
                            phi_1873_ = _e1425;
                            phi_4010_ = _e498;
                        } else {
                            phi_4313_ = _e484;
                            phi_1864_ = type_42();
                            phi_1867_ = type_49();
                            phi_1869_ = u32();
                            phi_1871_ = bool();
                            phi_1873_ = u32();
                            phi_4010_ = false;
                        }
                        let _e1427 = phi_4313_;
                        let _e1429 = phi_1864_;
                        let _e1431 = phi_1867_;
                        let _e1433 = phi_1869_;
                        let _e1435 = phi_1871_;
                        let _e1437 = phi_1873_;
                        let _e1439 = phi_4010_;
                        continue;
                        continuing {
                            phi_4208_ = _e1427;
                            phi_1863_ = _e1429;
                            phi_1866_ = _e1431;
                            phi_1868_ = _e1433;
                            phi_1870_ = _e1435;
                            phi_1872_ = _e1437;
                            phi_4312_ = _e1427;
                            break if !(_e1439);
                        }
                    }
                    let _e1442 = phi_4312_;
                    if _e1442 {
                        break;
                    }
                    let _e1444 = local_4;
                    let _e1447 = local_5;
                    if _e137 {
                    } else {
                        break;
                    }
                    global_6.member[_e135][0u] = _e1444.member_1;
                    global_6.member[_e135][1u] = _e1447.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
