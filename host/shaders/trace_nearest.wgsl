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

struct type_20 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_26 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_38 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_41 {
    member: array<type_21>,
}

struct type_45 {
    member: array<array<type_20, 8>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<storage> global_2: type_28;
@group(0) @binding(2) 
var<storage> global_3: type_15;
@group(0) @binding(3) 
var<storage> global_4: type_41;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_45;

fn function_() {
    var local: array<type_20, 8>;
    var local_1: array<u32, 128>;
    var local_2: array<f32, 128>;
    var phi_268_: i32;
    var phi_269_: i32;
    var phi_279_: bool;
    var phi_289_: u32;
    var phi_290_: u32;
    var phi_292_: bool;
    var phi_297_: u32;
    var phi_341_: f32;
    var phi_347_: f32;
    var phi_358_: f32;
    var phi_364_: f32;
    var phi_387_: f32;
    var phi_402_: f32;
    var phi_411_: f32;
    var phi_417_: f32;
    var phi_428_: f32;
    var phi_434_: f32;
    var phi_457_: f32;
    var phi_472_: f32;
    var phi_481_: f32;
    var phi_487_: f32;
    var phi_498_: f32;
    var phi_504_: f32;
    var phi_527_: f32;
    var phi_542_: f32;
    var phi_642_: f32;
    var phi_643_: f32;
    var phi_2262_: bool;
    var phi_2242_: f32;
    var phi_707_: u32;
    var phi_710_: u32;
    var phi_712_: bool;
    var phi_714_: u32;
    var phi_725_: bool;
    var phi_756_: u32;
    var phi_757_: bool;
    var phi_758_: u32;
    var phi_1646_: type_38;
    var phi_1991_: u32;
    var phi_2017_: u32;
    var phi_2018_: u32;
    var phi_2019_: u32;
    var phi_2021_: u32;
    var phi_2022_: u32;
    var phi_2023_: bool;
    var phi_2032_: u32;
    var phi_2037_: u32;
    var phi_2038_: bool;
    var phi_2259_: bool;
    var phi_2249_: f32;
    var phi_774_: type_4;
    var phi_775_: type_4;
    var phi_798_: type_4;
    var phi_818_: u32;
    var phi_906_: array<array<f32, 3>, 3>;
    var phi_1378_: vec3<f32>;
    var phi_1379_: vec3<f32>;
    var phi_1410_: bool;
    var phi_1419_: vec3<f32>;
    var phi_1459_: type_20;
    var phi_1461_: type_20;
    var phi_1462_: bool;
    var phi_1466_: type_20;
    var phi_1467_: type_20;
    var phi_1468_: type_20;
    var phi_1469_: bool;
    var phi_1473_: type_20;
    var phi_1474_: bool;
    var phi_1478_: type_20;
    var phi_1479_: bool;
    var phi_1483_: type_20;
    var phi_1495_: type_4;
    var phi_1498_: type_20;
    var phi_1496_: type_4;
    var phi_1521_: type_4;
    var phi_1553_: bool;
    var phi_1554_: bool;
    var phi_1575_: type_20;
    var phi_1499_: type_20;
    var phi_2250_: bool;
    var phi_2513_: f32;
    var phi_2512_: f32;
    var phi_2363_: bool;
    var phi_2511_: f32;
    var phi_2362_: bool;
    var phi_2510_: f32;
    var phi_2361_: bool;
    var phi_2450_: f32;
    var phi_2360_: bool;
    var phi_2415_: f32;
    var phi_2369_: bool;
    var phi_2040_: u32;
    var phi_2041_: bool;
    var phi_2042_: u32;
    var phi_2414_: f32;
    var phi_2368_: bool;
    var phi_2043_: u32;
    var phi_2044_: u32;
    var phi_2045_: bool;
    var phi_2046_: u32;
    var phi_2413_: f32;
    var phi_2367_: bool;
    var phi_2047_: u32;
    var phi_2048_: u32;
    var phi_2049_: bool;
    var phi_2050_: u32;
    var phi_2412_: f32;
    var phi_2366_: bool;
    var phi_708_: u32;
    var phi_711_: u32;
    var phi_713_: bool;
    var phi_715_: u32;
    var phi_2051_: bool;
    var phi_2365_: bool;
    var phi_2058_: type_4;
    var phi_2059_: type_4;
    var phi_2082_: type_4;
    var phi_2148_: type_20;
    var phi_2405_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e64 = global;
            let _e66 = arrayLength((&global_2.member));
            let _e68 = arrayLength((&global_3.member));
            let _e76 = (_e64.x + (_e64.y * 2097152u));
            let _e77 = (_e76 < arrayLength((&global_4.member)));
            if _e77 {
                let _e78 = (_e76 < arrayLength((&global_5.member)));
                if _e78 {
                    if _e77 {
                    } else {
                        break;
                    }
                    let _e81 = global_1.member[0u];
                    let _e82 = bitcast<i32>(_e81);
                    let _e90 = global_4.member[_e76].member_2[0u];
                    let _e92 = (bitcast<u32>(_e90) & 2147483647u);
                    let _e97 = global_4.member[_e76].member_2[1u];
                    let _e99 = (bitcast<u32>(_e97) & 2147483647u);
                    let _e104 = global_4.member[_e76].member_2[2u];
                    let _e106 = (bitcast<u32>(_e104) & 2147483647u);
                    let _e111 = global_4.member[_e76].member[0u];
                    let _e113 = (bitcast<u32>(_e111) & 2147483647u);
                    let _e118 = global_4.member[_e76].member[1u];
                    let _e120 = (bitcast<u32>(_e118) & 2147483647u);
                    let _e125 = global_4.member[_e76].member[2u];
                    let _e127 = (bitcast<u32>(_e125) & 2147483647u);
                    let _e129 = select(_e99, _e92, (_e99 < _e92));
                    let _e131 = select(_e106, _e129, (_e106 < _e129));
                    let _e133 = select(_e113, _e131, (_e113 < _e131));
                    let _e135 = select(_e120, _e133, (_e120 < _e133));
                    let _e137 = select(_e127, _e135, (_e127 < _e135));
                    let _e141 = global_4.member[_e76].member_1;
                    let _e143 = (bitcast<u32>(_e141) & 2147483647u);
                    let _e150 = global_4.member[_e76].member_3;
                    let _e156 = (((select(_e143, _e137, (_e143 < _e137)) < 2139095040u) && ((bitcast<u32>(_e150) & 2147483647u) <= 2139095040u)) && (_e131 > 0u));
                    if _e156 {
                        let _e159 = (bitcast<u32>(bitcast<f32>(_e131)) & 2147483647u);
                        if (_e159 >= 8388608u) {
                            phi_268_ = (bitcast<i32>((_e159 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_268_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e159)), 32u, (_e159 == 0u))));
                        }
                        let _e173 = phi_268_;
                        phi_269_ = _e173;
                    } else {
                        phi_269_ = 0i;
                    }
                    let _e175 = phi_269_;
                    let _e176 = (_e92 == _e131);
                    if _e176 {
                        phi_279_ = true;
                    } else {
                        phi_279_ = (_e99 == _e131);
                    }
                    let _e179 = phi_279_;
                    let _e180 = select(1u, 0u, _e176);
                    if _e179 {
                        let _e181 = (_e180 + 1u);
                        phi_289_ = _e181;
                        phi_290_ = _e181;
                        phi_292_ = select(true, false, (_e181 == 2u));
                    } else {
                        phi_289_ = u32();
                        phi_290_ = 0u;
                        phi_292_ = true;
                    }
                    let _e185 = phi_289_;
                    let _e187 = phi_290_;
                    let _e189 = phi_292_;
                    if _e189 {
                        phi_297_ = (_e187 + 1u);
                    } else {
                        phi_297_ = 0u;
                    }
                    let _e193 = phi_297_;
                    let _e194 = select(_e185, _e187, _e189);
                    let _e195 = select(_e180, select(2u, _e180, _e179), _e189);
                    let _e196 = (_e82 / 2i);
                    let _e201 = bitcast<f32>((bitcast<u32>((_e196 + 127i)) << bitcast<u32>(23i)));
                    let _e207 = bitcast<f32>((bitcast<u32>(((_e82 - _e196) + 127i)) << bitcast<u32>(23i)));
                    let _e208 = -(_e175);
                    let _e209 = (_e208 / 2i);
                    let _e214 = bitcast<f32>((bitcast<u32>((_e209 + 127i)) << bitcast<u32>(23i)));
                    let _e220 = bitcast<f32>((bitcast<u32>(((_e208 - _e209) + 127i)) << bitcast<u32>(23i)));
                    let _e224 = global_4.member[_e76].member;
                    let _e225 = (_e194 == 0u);
                    if _e225 {
                        phi_341_ = _e224[0];
                    } else {
                        phi_341_ = _e224[1];
                    }
                    let _e229 = phi_341_;
                    let _e230 = (_e194 == 2u);
                    if _e230 {
                        phi_347_ = _e224[2];
                    } else {
                        phi_347_ = _e229;
                    }
                    let _e233 = phi_347_;
                    let _e235 = ((_e233 * _e201) * _e207);
                    let _e236 = global_4.member[_e76].member_2;
                    if _e225 {
                        phi_358_ = _e236[0];
                    } else {
                        phi_358_ = _e236[1];
                    }
                    let _e240 = phi_358_;
                    if _e230 {
                        phi_364_ = _e236[2];
                    } else {
                        phi_364_ = _e240;
                    }
                    let _e243 = phi_364_;
                    let _e245 = ((_e243 * _e214) * _e220);
                    let _e249 = (bitcast<f32>((bitcast<u32>(_e245) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e249 {
                        let _e253 = (bitcast<f32>((bitcast<u32>(_e235) & 2147483647u)) * 0.00000011920929f);
                        phi_387_ = select(0.00000000000000000086736174f, _e253, (_e253 > 0.00000000000000000086736174f));
                    } else {
                        phi_387_ = 0f;
                    }
                    let _e257 = phi_387_;
                    let _e258 = (_e235 + _e257);
                    let _e259 = (_e235 - _e257);
                    let _e260 = select(_e245, 0f, _e249);
                    if _e249 {
                        phi_402_ = 1267650600000000000000000000000f;
                    } else {
                        phi_402_ = (1f / _e245);
                    }
                    let _e263 = phi_402_;
                    let _e264 = (_e193 == 0u);
                    if _e264 {
                        phi_411_ = _e224[0];
                    } else {
                        phi_411_ = _e224[1];
                    }
                    let _e268 = phi_411_;
                    let _e269 = (_e193 == 2u);
                    if _e269 {
                        phi_417_ = _e224[2];
                    } else {
                        phi_417_ = _e268;
                    }
                    let _e272 = phi_417_;
                    let _e274 = ((_e272 * _e201) * _e207);
                    if _e264 {
                        phi_428_ = _e236[0];
                    } else {
                        phi_428_ = _e236[1];
                    }
                    let _e278 = phi_428_;
                    if _e269 {
                        phi_434_ = _e236[2];
                    } else {
                        phi_434_ = _e278;
                    }
                    let _e281 = phi_434_;
                    let _e283 = ((_e281 * _e214) * _e220);
                    let _e287 = (bitcast<f32>((bitcast<u32>(_e283) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e287 {
                        let _e291 = (bitcast<f32>((bitcast<u32>(_e274) & 2147483647u)) * 0.00000011920929f);
                        phi_457_ = select(0.00000000000000000086736174f, _e291, (_e291 > 0.00000000000000000086736174f));
                    } else {
                        phi_457_ = 0f;
                    }
                    let _e295 = phi_457_;
                    let _e296 = (_e274 + _e295);
                    let _e297 = (_e274 - _e295);
                    let _e298 = select(_e283, 0f, _e287);
                    if _e287 {
                        phi_472_ = 1267650600000000000000000000000f;
                    } else {
                        phi_472_ = (1f / _e283);
                    }
                    let _e301 = phi_472_;
                    let _e302 = (_e195 == 0u);
                    if _e302 {
                        phi_481_ = _e224[0];
                    } else {
                        phi_481_ = _e224[1];
                    }
                    let _e306 = phi_481_;
                    let _e307 = (_e195 == 2u);
                    if _e307 {
                        phi_487_ = _e224[2];
                    } else {
                        phi_487_ = _e306;
                    }
                    let _e310 = phi_487_;
                    let _e312 = ((_e310 * _e201) * _e207);
                    if _e302 {
                        phi_498_ = _e236[0];
                    } else {
                        phi_498_ = _e236[1];
                    }
                    let _e316 = phi_498_;
                    if _e307 {
                        phi_504_ = _e236[2];
                    } else {
                        phi_504_ = _e316;
                    }
                    let _e319 = phi_504_;
                    let _e321 = ((_e319 * _e214) * _e220);
                    let _e325 = (bitcast<f32>((bitcast<u32>(_e321) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e325 {
                        let _e329 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) * 0.00000011920929f);
                        phi_527_ = select(0.00000000000000000086736174f, _e329, (_e329 > 0.00000000000000000086736174f));
                    } else {
                        phi_527_ = 0f;
                    }
                    let _e333 = phi_527_;
                    let _e334 = (_e312 + _e333);
                    let _e335 = (_e312 - _e333);
                    let _e336 = select(_e321, 0f, _e325);
                    if _e325 {
                        phi_542_ = 1267650600000000000000000000000f;
                    } else {
                        phi_542_ = (1f / _e321);
                    }
                    let _e339 = phi_542_;
                    let _e342 = bitcast<f32>((bitcast<u32>(_e235) & 2147483647u));
                    let _e345 = bitcast<f32>((bitcast<u32>(_e274) & 2147483647u));
                    let _e347 = select(_e345, _e342, (_e342 > _e345));
                    let _e350 = bitcast<f32>((bitcast<u32>(_e312) & 2147483647u));
                    let _e353 = (_e82 + _e175);
                    if (_e156 && (select(_e350, _e347, (_e347 > _e350)) <= 1099511600000f)) {
                        let _e356 = (_e353 / 3i);
                        let _e363 = bitcast<f32>((bitcast<u32>((_e356 + 127i)) << bitcast<u32>(23i)));
                        let _e370 = bitcast<f32>((bitcast<u32>(((_e353 - (2i * _e356)) + 127i)) << bitcast<u32>(23i)));
                        let _e371 = (((_e141 * _e363) * _e363) * _e370);
                        let _e373 = select(340282350000000000000000000000000000000f, _e371, (_e371 < 340282350000000000000000000000000000000f));
                        let _e378 = (((_e150 * _e363) * _e363) * _e370);
                        let _e380 = select(340282350000000000000000000000000000000f, _e378, (_e378 < 340282350000000000000000000000000000000f));
                        phi_642_ = select(-340282350000000000000000000000000000000f, _e380, (_e380 > -340282350000000000000000000000000000000f));
                        phi_643_ = select(-340282350000000000000000000000000000000f, _e373, (_e373 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_642_ = 0f;
                        phi_643_ = 1f;
                    }
                    let _e384 = phi_642_;
                    let _e386 = phi_643_;
                    local = array<type_20, 8>(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2262_ = false;
                    phi_2242_ = _e384;
                    phi_707_ = select(0u, 2147483648u, (_e66 == 0u));
                    phi_710_ = ((3u * _e66) + 1u);
                    phi_712_ = (_e386 <= _e384);
                    phi_714_ = 0u;
                    loop {
                        let _e393 = phi_2262_;
                        let _e395 = phi_2242_;
                        let _e397 = phi_707_;
                        let _e399 = phi_710_;
                        let _e401 = phi_712_;
                        let _e403 = phi_714_;
                        if _e401 {
                            phi_725_ = true;
                        } else {
                            phi_725_ = (_e403 > 0u);
                        }
                        let _e406 = phi_725_;
                        if _e406 {
                            let _e407 = (_e399 > 0u);
                            if _e407 {
                                if _e401 {
                                    phi_756_ = _e397;
                                    phi_757_ = _e401;
                                    phi_758_ = _e403;
                                } else {
                                    let _e408 = (_e403 - 1u);
                                    let _e409 = (_e408 % 128u);
                                    let _e410 = (_e409 < 128u);
                                    if _e410 {
                                    } else {
                                        phi_2365_ = true;
                                        break;
                                    }
                                    let _e412 = local_1[_e409];
                                    if _e410 {
                                    } else {
                                        phi_2365_ = true;
                                        break;
                                    }
                                    let _e414 = local_2[_e409];
                                    phi_756_ = _e412;
                                    phi_757_ = (_e414 <= _e395);
                                    phi_758_ = _e408;
                                }
                                let _e417 = phi_756_;
                                let _e419 = phi_757_;
                                let _e421 = phi_758_;
                                if _e419 {
                                    let _e425 = (_e417 & 268435455u);
                                    if ((_e417 & 2147483648u) != 0u) {
                                        phi_2259_ = _e393;
                                        phi_2249_ = _e395;
                                        phi_774_ = type_4(_e425, (_e425 + ((_e417 >> bitcast<u32>(28u)) & 7u)));
                                        loop {
                                            let _e619 = phi_2259_;
                                            let _e621 = phi_2249_;
                                            let _e623 = phi_774_;
                                            if (_e623.member < _e623.member_1) {
                                                phi_775_ = type_4((_e623.member + 1u), _e623.member_1);
                                                phi_798_ = type_4(1u, _e623.member);
                                            } else {
                                                phi_775_ = _e623;
                                                phi_798_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e636 = phi_775_;
                                            let _e638 = phi_798_;
                                            let _e642 = (bitcast<i32>(_e638.member) != 0i);
                                            if _e642 {
                                                let _e643 = (_e638.member_1 < _e68);
                                                if _e643 {
                                                    if _e643 {
                                                    } else {
                                                        phi_2450_ = _e621;
                                                        phi_2360_ = true;
                                                        break;
                                                    }
                                                    let _e647 = global_3.member[_e638.member_1].member_1;
                                                    phi_818_ = _e647;
                                                } else {
                                                    phi_818_ = 4294967295u;
                                                }
                                                let _e649 = phi_818_;
                                                if (_e638.member_1 >= _e68) {
                                                    phi_906_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e643 {
                                                    } else {
                                                        phi_2450_ = _e621;
                                                        phi_2360_ = true;
                                                        break;
                                                    }
                                                    let _e651 = (_e194 % 3u);
                                                    let _e652 = (_e193 % 3u);
                                                    let _e653 = (_e195 % 3u);
                                                    if (_e651 < 9u) {
                                                    } else {
                                                        phi_2450_ = _e621;
                                                        phi_2360_ = true;
                                                        break;
                                                    }
                                                    let _e659 = global_3.member[_e638.member_1].member[_e651];
                                                    if (_e652 < 9u) {
                                                    } else {
                                                        phi_2450_ = _e621;
                                                        phi_2360_ = true;
                                                        break;
                                                    }
                                                    let _e665 = global_3.member[_e638.member_1].member[_e652];
                                                    if (_e653 < 9u) {
                                                    } else {
                                                        phi_2450_ = _e621;
                                                        phi_2360_ = true;
                                                        break;
                                                    }
                                                    let _e671 = global_3.member[_e638.member_1].member[_e653];
                                                    let _e673 = (3u + _e651);
                                                    if (_e673 < 9u) {
                                                    } else {
                                                        phi_2450_ = _e621;
                                                        phi_2360_ = true;
                                                        break;
                                                    }
                                                    let _e679 = global_3.member[_e638.member_1].member[_e673];
                                                    let _e680 = (3u + _e652);
                                                    if (_e680 < 9u) {
                                                    } else {
                                                        phi_2450_ = _e621;
                                                        phi_2360_ = true;
                                                        break;
                                                    }
                                                    let _e686 = global_3.member[_e638.member_1].member[_e680];
                                                    let _e687 = (3u + _e653);
                                                    if (_e687 < 9u) {
                                                    } else {
                                                        phi_2450_ = _e621;
                                                        phi_2360_ = true;
                                                        break;
                                                    }
                                                    let _e693 = global_3.member[_e638.member_1].member[_e687];
                                                    let _e695 = (6u + _e651);
                                                    if (_e695 < 9u) {
                                                    } else {
                                                        phi_2450_ = _e621;
                                                        phi_2360_ = true;
                                                        break;
                                                    }
                                                    let _e701 = global_3.member[_e638.member_1].member[_e695];
                                                    let _e702 = (6u + _e652);
                                                    if (_e702 < 9u) {
                                                    } else {
                                                        phi_2450_ = _e621;
                                                        phi_2360_ = true;
                                                        break;
                                                    }
                                                    let _e708 = global_3.member[_e638.member_1].member[_e702];
                                                    let _e709 = (6u + _e653);
                                                    if (_e709 < 9u) {
                                                    } else {
                                                        phi_2450_ = _e621;
                                                        phi_2360_ = true;
                                                        break;
                                                    }
                                                    let _e715 = global_3.member[_e638.member_1].member[_e709];
                                                    phi_906_ = array<array<f32, 3>, 3>(array<f32, 3>(_e659, _e665, _e671), array<f32, 3>(_e679, _e686, _e693), array<f32, 3>(_e701, _e708, _e715));
                                                }
                                                let _e719 = phi_906_;
                                                let _e726 = (_e719[0][2] - _e312);
                                                let _e729 = (((_e719[0][0] - _e235) * _e336) - (_e726 * _e260));
                                                let _e732 = (((_e719[0][1] - _e274) * _e336) - (_e726 * _e298));
                                                let _e739 = (_e719[1][2] - _e312);
                                                let _e742 = (((_e719[1][0] - _e235) * _e336) - (_e739 * _e260));
                                                let _e745 = (((_e719[1][1] - _e274) * _e336) - (_e739 * _e298));
                                                let _e752 = (_e719[2][2] - _e312);
                                                let _e755 = (((_e719[2][0] - _e235) * _e336) - (_e752 * _e260));
                                                let _e758 = (((_e719[2][1] - _e274) * _e336) - (_e752 * _e298));
                                                let _e759 = (_e755 * _e745);
                                                let _e760 = (_e758 * _e742);
                                                let _e761 = (_e729 * _e758);
                                                let _e762 = (_e732 * _e755);
                                                let _e763 = (_e742 * _e732);
                                                let _e764 = (_e745 * _e729);
                                                let _e769 = (((_e759 >= _e760) && (_e761 >= _e762)) && (_e763 >= _e764));
                                                if (_e769 || (((_e759 <= _e760) && (_e761 <= _e762)) && (_e763 <= _e764))) {
                                                    let _e776 = select(-1f, 1f, _e769);
                                                    let _e778 = ((_e759 - _e760) * _e776);
                                                    let _e780 = select(0f, _e778, (_e778 > 0f));
                                                    let _e782 = ((_e761 - _e762) * _e776);
                                                    let _e784 = select(0f, _e782, (_e782 > 0f));
                                                    let _e786 = ((_e763 - _e764) * _e776);
                                                    let _e788 = select(0f, _e786, (_e786 > 0f));
                                                    let _e790 = ((_e780 + _e784) + _e788);
                                                    if (_e790 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1473_ = type_20();
                                                        phi_1474_ = true;
                                                    } else {
                                                        let _e793 = select(_e719[1][0], _e719[0][0], (_e719[0][0] < _e719[1][0]));
                                                        let _e797 = select(_e719[1][0], _e719[0][0], (_e719[0][0] > _e719[1][0]));
                                                        let _e801 = select(_e719[1][1], _e719[0][1], (_e719[0][1] < _e719[1][1]));
                                                        let _e805 = select(_e719[1][1], _e719[0][1], (_e719[0][1] > _e719[1][1]));
                                                        let _e809 = select(_e719[1][2], _e719[0][2], (_e719[0][2] < _e719[1][2]));
                                                        let _e813 = select(_e719[1][2], _e719[0][2], (_e719[0][2] > _e719[1][2]));
                                                        let _e818 = ((select(_e719[2][0], _e793, (_e793 < _e719[2][0])) - _e258) * _e263);
                                                        let _e819 = ((select(_e719[2][0], _e797, (_e797 > _e719[2][0])) - _e259) * _e263);
                                                        let _e822 = ((select(_e719[2][1], _e801, (_e801 < _e719[2][1])) - _e296) * _e301);
                                                        let _e823 = ((select(_e719[2][1], _e805, (_e805 > _e719[2][1])) - _e297) * _e301);
                                                        let _e826 = ((select(_e719[2][2], _e809, (_e809 < _e719[2][2])) - _e334) * _e339);
                                                        let _e827 = ((select(_e719[2][2], _e813, (_e813 > _e719[2][2])) - _e335) * _e339);
                                                        let _e829 = select(_e827, _e826, (_e826 < _e827));
                                                        let _e831 = select(_e827, _e826, (_e826 > _e827));
                                                        let _e833 = select(_e819, _e818, (_e818 < _e819));
                                                        let _e835 = select(_e823, _e822, (_e822 < _e823));
                                                        let _e837 = select(_e835, _e833, (_e833 > _e835));
                                                        let _e839 = select(_e829, _e837, (_e837 > _e829));
                                                        let _e841 = select(_e819, _e818, (_e818 > _e819));
                                                        let _e843 = select(_e823, _e822, (_e822 > _e823));
                                                        let _e845 = select(_e843, _e841, (_e841 < _e843));
                                                        let _e847 = select(_e831, _e845, (_e845 < _e831));
                                                        let _e848 = -(_e829);
                                                        let _e854 = select(_e386, _e839, (_e839 > _e386));
                                                        if (_e854 > (_e847 + (select(_e848, _e831, (_e831 > _e848)) * 0.0000019073523f))) {
                                                            phi_1468_ = type_20();
                                                            phi_1469_ = true;
                                                        } else {
                                                            let _e856 = (_e854 > _e621);
                                                            if _e856 {
                                                                phi_1467_ = type_20();
                                                            } else {
                                                                let _e860 = (_e719[1][0] - _e719[0][0]);
                                                                let _e861 = (_e719[1][1] - _e719[0][1]);
                                                                let _e862 = (_e719[1][2] - _e719[0][2]);
                                                                let _e863 = vec3<f32>(_e860, _e861, _e862);
                                                                let _e864 = (_e719[2][0] - _e719[1][0]);
                                                                let _e865 = (_e719[2][1] - _e719[1][1]);
                                                                let _e866 = (_e719[2][2] - _e719[1][2]);
                                                                let _e867 = vec3<f32>(_e864, _e865, _e866);
                                                                let _e868 = (_e719[0][0] - _e719[2][0]);
                                                                let _e869 = (_e719[0][1] - _e719[2][1]);
                                                                let _e870 = (_e719[0][2] - _e719[2][2]);
                                                                let _e871 = vec3<f32>(_e868, _e869, _e870);
                                                                let _e874 = bitcast<f32>((bitcast<u32>(_e860) & 2147483647u));
                                                                let _e877 = bitcast<f32>((bitcast<u32>(_e861) & 2147483647u));
                                                                let _e879 = select(_e877, _e874, (_e874 > _e877));
                                                                let _e882 = bitcast<f32>((bitcast<u32>(_e862) & 2147483647u));
                                                                let _e884 = select(_e882, _e879, (_e879 > _e882));
                                                                let _e887 = bitcast<f32>((bitcast<u32>(_e864) & 2147483647u));
                                                                let _e890 = bitcast<f32>((bitcast<u32>(_e865) & 2147483647u));
                                                                let _e892 = select(_e890, _e887, (_e887 > _e890));
                                                                let _e895 = bitcast<f32>((bitcast<u32>(_e866) & 2147483647u));
                                                                let _e897 = select(_e895, _e892, (_e892 > _e895));
                                                                let _e900 = bitcast<f32>((bitcast<u32>(_e868) & 2147483647u));
                                                                let _e903 = bitcast<f32>((bitcast<u32>(_e869) & 2147483647u));
                                                                let _e905 = select(_e903, _e900, (_e900 > _e903));
                                                                let _e908 = bitcast<f32>((bitcast<u32>(_e870) & 2147483647u));
                                                                let _e910 = select(_e908, _e905, (_e905 > _e908));
                                                                let _e912 = select(_e897, _e884, (_e884 > _e897));
                                                                let _e914 = select(_e910, _e912, (_e912 > _e910));
                                                                if (_e884 == _e914) {
                                                                    phi_1378_ = _e867;
                                                                    phi_1379_ = _e871;
                                                                } else {
                                                                    let _e917 = vec3((_e897 == _e914));
                                                                    phi_1378_ = select(_e863, _e871, _e917);
                                                                    phi_1379_ = select(_e867, _e863, _e917);
                                                                }
                                                                let _e921 = phi_1378_;
                                                                let _e923 = phi_1379_;
                                                                let _e930 = ((_e921.y * _e923.z) - (_e923.y * _e921.z));
                                                                let _e935 = ((_e921.z * _e923.x) - (_e923.z * _e921.x));
                                                                let _e938 = ((_e921.x * _e923.y) - (_e923.x * _e921.y));
                                                                if (_e780 >= _e784) {
                                                                    phi_1410_ = select(true, false, (_e780 >= _e788));
                                                                } else {
                                                                    phi_1410_ = true;
                                                                }
                                                                let _e943 = phi_1410_;
                                                                if _e943 {
                                                                    phi_1419_ = select(vec3<f32>(_e719[2][0], _e719[2][1], _e719[2][2]), vec3<f32>(_e719[1][0], _e719[1][1], _e719[1][2]), vec3((_e784 >= _e788)));
                                                                } else {
                                                                    phi_1419_ = vec3<f32>(_e719[0][0], _e719[0][1], _e719[0][2]);
                                                                }
                                                                let _e948 = phi_1419_;
                                                                let _e965 = ((((_e930 * (_e948.x - _e235)) + (_e935 * (_e948.y - _e274))) + (_e938 * (_e948.z - _e312))) / (((_e930 * _e260) + (_e935 * _e298)) + (_e938 * _e336)));
                                                                let _e967 = select(_e847, _e965, (_e965 < _e847));
                                                                let _e969 = select(_e839, _e967, (_e967 > _e839));
                                                                if (_e969 >= _e386) {
                                                                    let _e971 = (_e969 <= _e621);
                                                                    if _e971 {
                                                                        let _e972 = (1f / _e790);
                                                                        phi_1459_ = type_20(_e969, (_e784 * _e972), (_e788 * _e972), _e649);
                                                                    } else {
                                                                        phi_1459_ = type_20();
                                                                    }
                                                                    let _e977 = phi_1459_;
                                                                    phi_1461_ = _e977;
                                                                    phi_1462_ = select(true, false, _e971);
                                                                } else {
                                                                    phi_1461_ = type_20();
                                                                    phi_1462_ = true;
                                                                }
                                                                let _e980 = phi_1461_;
                                                                let _e982 = phi_1462_;
                                                                if _e982 {
                                                                    phi_1466_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1466_ = _e980;
                                                                }
                                                                let _e984 = phi_1466_;
                                                                phi_1467_ = _e984;
                                                            }
                                                            let _e986 = phi_1467_;
                                                            phi_1468_ = _e986;
                                                            phi_1469_ = _e856;
                                                        }
                                                        let _e988 = phi_1468_;
                                                        let _e990 = phi_1469_;
                                                        phi_1473_ = _e988;
                                                        phi_1474_ = _e990;
                                                    }
                                                    let _e992 = phi_1473_;
                                                    let _e994 = phi_1474_;
                                                    phi_1478_ = _e992;
                                                    phi_1479_ = _e994;
                                                } else {
                                                    phi_1478_ = type_20();
                                                    phi_1479_ = true;
                                                }
                                                let _e996 = phi_1478_;
                                                let _e998 = phi_1479_;
                                                if _e998 {
                                                    phi_1483_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1483_ = _e996;
                                                }
                                                let _e1000 = phi_1483_;
                                                if (_e1000.member_3 != 4294967295u) {
                                                    if (_e649 != 4294967295u) {
                                                        phi_1495_ = type_4(0u, 8u);
                                                        phi_1498_ = _e1000;
                                                        loop {
                                                            let _e1005 = phi_1495_;
                                                            let _e1007 = phi_1498_;
                                                            if (_e1005.member < _e1005.member_1) {
                                                                phi_1496_ = type_4((_e1005.member + 1u), _e1005.member_1);
                                                                phi_1521_ = type_4(1u, _e1005.member);
                                                            } else {
                                                                phi_1496_ = _e1005;
                                                                phi_1521_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1020 = phi_1496_;
                                                            let _e1022 = phi_1521_;
                                                            let _e1026 = (bitcast<i32>(_e1022.member) != 0i);
                                                            if _e1026 {
                                                                let _e1027 = (_e1022.member_1 < 8u);
                                                                if _e1027 {
                                                                } else {
                                                                    phi_2250_ = true;
                                                                    break;
                                                                }
                                                                let _e1032 = local[_e1022.member_1].member;
                                                                if (_e1007.member < _e1032) {
                                                                    phi_1554_ = true;
                                                                } else {
                                                                    let _e1034 = local[_e1022.member_1].member;
                                                                    if (_e1007.member == _e1034) {
                                                                        let _e1039 = local[_e1022.member_1].member_3;
                                                                        phi_1553_ = (_e1007.member_3 < _e1039);
                                                                    } else {
                                                                        phi_1553_ = false;
                                                                    }
                                                                    let _e1042 = phi_1553_;
                                                                    phi_1554_ = _e1042;
                                                                }
                                                                let _e1044 = phi_1554_;
                                                                if _e1044 {
                                                                    if _e1027 {
                                                                    } else {
                                                                        phi_2250_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1045 = local[_e1022.member_1];
                                                                    local[_e1022.member_1] = type_20(_e1007.member, _e1007.member_1, _e1007.member_2, _e1007.member_3);
                                                                    phi_1575_ = type_20(_e1045.member, _e1045.member_1, _e1045.member_2, _e1045.member_3);
                                                                } else {
                                                                    phi_1575_ = _e1007;
                                                                }
                                                                let _e1056 = phi_1575_;
                                                                phi_1499_ = _e1056;
                                                            } else {
                                                                phi_1499_ = type_20();
                                                            }
                                                            let _e1058 = phi_1499_;
                                                            continue;
                                                            continuing {
                                                                phi_1495_ = _e1020;
                                                                phi_1498_ = _e1058;
                                                                phi_2250_ = _e619;
                                                                break if !(_e1026);
                                                            }
                                                        }
                                                        let _e1061 = phi_2250_;
                                                        phi_2450_ = _e621;
                                                        phi_2360_ = _e1061;
                                                        if _e1061 {
                                                            break;
                                                        }
                                                        let _e1064 = local[7u].member_3;
                                                        if (_e1064 != 4294967295u) {
                                                            let _e1068 = local[7u].member;
                                                            phi_2513_ = _e1068;
                                                        } else {
                                                            phi_2513_ = _e621;
                                                        }
                                                        let _e1070 = phi_2513_;
                                                        phi_2512_ = _e1070;
                                                        phi_2363_ = _e1061;
                                                    } else {
                                                        phi_2512_ = _e621;
                                                        phi_2363_ = _e619;
                                                    }
                                                    let _e1072 = phi_2512_;
                                                    let _e1074 = phi_2363_;
                                                    phi_2511_ = _e1072;
                                                    phi_2362_ = _e1074;
                                                } else {
                                                    phi_2511_ = _e621;
                                                    phi_2362_ = _e619;
                                                }
                                                let _e1076 = phi_2511_;
                                                let _e1078 = phi_2362_;
                                                phi_2510_ = _e1076;
                                                phi_2361_ = _e1078;
                                            } else {
                                                phi_2510_ = _e621;
                                                phi_2361_ = _e619;
                                            }
                                            let _e1080 = phi_2510_;
                                            let _e1082 = phi_2361_;
                                            continue;
                                            continuing {
                                                phi_2259_ = _e1082;
                                                phi_2249_ = _e1080;
                                                phi_774_ = _e636;
                                                phi_2450_ = _e1080;
                                                phi_2360_ = _e1082;
                                                break if !(_e642);
                                            }
                                        }
                                        let _e1085 = phi_2450_;
                                        let _e1087 = phi_2360_;
                                        phi_2365_ = _e1087;
                                        if _e1087 {
                                            break;
                                        }
                                        phi_2415_ = _e1085;
                                        phi_2369_ = _e1087;
                                        phi_2040_ = _e417;
                                        phi_2041_ = false;
                                        phi_2042_ = _e421;
                                    } else {
                                        if (_e417 >= _e66) {
                                            phi_1646_ = type_38(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e417 < _e66) {
                                            } else {
                                                phi_2365_ = true;
                                                break;
                                            }
                                            let _e431 = (_e194 % 3u);
                                            if (_e431 < 3u) {
                                            } else {
                                                phi_2365_ = true;
                                                break;
                                            }
                                            let _e437 = global_2.member[_e417].member[_e431];
                                            let _e443 = (_e193 % 3u);
                                            if (_e443 < 3u) {
                                            } else {
                                                phi_2365_ = true;
                                                break;
                                            }
                                            let _e449 = global_2.member[_e417].member[_e443];
                                            let _e455 = (_e195 % 3u);
                                            if (_e455 < 3u) {
                                            } else {
                                                phi_2365_ = true;
                                                break;
                                            }
                                            let _e461 = global_2.member[_e417].member[_e455];
                                            let _e471 = global_2.member[_e417].member_1;
                                            let _e475 = global_2.member[_e417].member_2;
                                            phi_1646_ = type_38(array<vec4<f32>, 3>(vec4<f32>(_e437[0], _e437[1], _e437[2], _e437[3]), vec4<f32>(_e449[0], _e449[1], _e449[2], _e449[3]), vec4<f32>(_e461[0], _e461[1], _e461[2], _e461[3])), _e471, _e475);
                                        }
                                        let _e478 = phi_1646_;
                                        let _e489 = ((_e478.member[0].x - _e258) * _e263);
                                        let _e490 = ((_e478.member[0].y - _e258) * _e263);
                                        let _e491 = ((_e478.member[0].z - _e259) * _e263);
                                        let _e492 = ((_e478.member[0].w - _e259) * _e263);
                                        let _e502 = ((_e478.member[1].x - _e296) * _e301);
                                        let _e503 = ((_e478.member[1].y - _e296) * _e301);
                                        let _e504 = ((_e478.member[1].z - _e297) * _e301);
                                        let _e505 = ((_e478.member[1].w - _e297) * _e301);
                                        let _e515 = ((_e478.member[2].x - _e334) * _e339);
                                        let _e516 = ((_e478.member[2].y - _e334) * _e339);
                                        let _e517 = ((_e478.member[2].z - _e335) * _e339);
                                        let _e518 = ((_e478.member[2].w - _e335) * _e339);
                                        let _e520 = select(_e517, _e515, (_e515 < _e517));
                                        let _e522 = select(_e518, _e516, (_e516 < _e518));
                                        let _e524 = select(_e517, _e515, (_e515 > _e517));
                                        let _e526 = select(_e518, _e516, (_e516 > _e518));
                                        let _e528 = select(_e491, _e489, (_e489 < _e491));
                                        let _e530 = select(_e492, _e490, (_e490 < _e492));
                                        let _e532 = select(_e504, _e502, (_e502 < _e504));
                                        let _e534 = select(_e505, _e503, (_e503 < _e505));
                                        let _e536 = select(_e532, _e528, (_e528 > _e532));
                                        let _e538 = select(_e534, _e530, (_e530 > _e534));
                                        let _e540 = select(_e520, _e536, (_e536 > _e520));
                                        let _e542 = select(_e522, _e538, (_e538 > _e522));
                                        let _e544 = select(_e491, _e489, (_e489 > _e491));
                                        let _e546 = select(_e492, _e490, (_e490 > _e492));
                                        let _e548 = select(_e504, _e502, (_e502 > _e504));
                                        let _e550 = select(_e505, _e503, (_e503 > _e505));
                                        let _e552 = select(_e548, _e544, (_e544 < _e548));
                                        let _e554 = select(_e550, _e546, (_e546 < _e550));
                                        let _e559 = -(_e520);
                                        let _e560 = -(_e522);
                                        let _e567 = (select(_e524, _e552, (_e552 < _e524)) + (select(_e559, _e524, (_e524 > _e559)) * 0.0000019073523f));
                                        let _e568 = (select(_e526, _e554, (_e554 < _e526)) + (select(_e560, _e526, (_e526 > _e560)) * 0.0000019073523f));
                                        let _e570 = select(_e386, _e540, (_e540 > _e386));
                                        let _e572 = select(_e386, _e542, (_e542 > _e386));
                                        let _e577 = (_e570 <= select(_e395, _e567, (_e567 < _e395)));
                                        let _e578 = (_e572 <= select(_e395, _e568, (_e568 < _e395)));
                                        let _e579 = (_e570 <= _e572);
                                        if _e577 {
                                            if _e578 {
                                                if _e579 {
                                                    phi_1991_ = _e478.member_2;
                                                } else {
                                                    phi_1991_ = _e478.member_1;
                                                }
                                                let _e583 = phi_1991_;
                                                let _e584 = (_e421 % 128u);
                                                let _e585 = (_e584 < 128u);
                                                if _e585 {
                                                } else {
                                                    phi_2365_ = true;
                                                    break;
                                                }
                                                local_1[_e584] = _e583;
                                                if _e585 {
                                                } else {
                                                    phi_2365_ = true;
                                                    break;
                                                }
                                                local_2[_e584] = select(_e572, _e570, (_e570 > _e572));
                                                if _e579 {
                                                    phi_2017_ = _e478.member_1;
                                                } else {
                                                    phi_2017_ = _e478.member_2;
                                                }
                                                let _e594 = phi_2017_;
                                                phi_2018_ = _e594;
                                                phi_2019_ = (_e421 + 1u);
                                            } else {
                                                phi_2018_ = u32();
                                                phi_2019_ = u32();
                                            }
                                            let _e596 = phi_2018_;
                                            let _e598 = phi_2019_;
                                            phi_2021_ = _e596;
                                            phi_2022_ = _e598;
                                            phi_2023_ = select(true, false, _e578);
                                        } else {
                                            phi_2021_ = u32();
                                            phi_2022_ = u32();
                                            phi_2023_ = true;
                                        }
                                        let _e601 = phi_2021_;
                                        let _e603 = phi_2022_;
                                        let _e605 = phi_2023_;
                                        if _e605 {
                                            if _e577 {
                                                phi_2032_ = _e478.member_1;
                                            } else {
                                                phi_2032_ = _e478.member_2;
                                            }
                                            let _e609 = phi_2032_;
                                            phi_2037_ = _e609;
                                            phi_2038_ = select(_e578, true, _e577);
                                        } else {
                                            phi_2037_ = _e601;
                                            phi_2038_ = _e419;
                                        }
                                        let _e612 = phi_2037_;
                                        let _e614 = phi_2038_;
                                        phi_2415_ = _e395;
                                        phi_2369_ = _e393;
                                        phi_2040_ = _e612;
                                        phi_2041_ = _e614;
                                        phi_2042_ = select(_e603, _e421, _e605);
                                    }
                                    let _e1089 = phi_2415_;
                                    let _e1091 = phi_2369_;
                                    let _e1093 = phi_2040_;
                                    let _e1095 = phi_2041_;
                                    let _e1097 = phi_2042_;
                                    phi_2414_ = _e1089;
                                    phi_2368_ = _e1091;
                                    phi_2043_ = _e1093;
                                    phi_2044_ = (_e399 - 1u);
                                    phi_2045_ = _e1095;
                                    phi_2046_ = _e1097;
                                } else {
                                    phi_2414_ = _e395;
                                    phi_2368_ = _e393;
                                    phi_2043_ = _e417;
                                    phi_2044_ = _e399;
                                    phi_2045_ = _e419;
                                    phi_2046_ = _e421;
                                }
                                let _e1099 = phi_2414_;
                                let _e1101 = phi_2368_;
                                let _e1103 = phi_2043_;
                                let _e1105 = phi_2044_;
                                let _e1107 = phi_2045_;
                                let _e1109 = phi_2046_;
                                phi_2413_ = _e1099;
                                phi_2367_ = _e1101;
                                phi_2047_ = _e1103;
                                phi_2048_ = _e1105;
                                phi_2049_ = _e1107;
                                phi_2050_ = _e1109;
                            } else {
                                phi_2413_ = _e395;
                                phi_2367_ = _e393;
                                phi_2047_ = u32();
                                phi_2048_ = u32();
                                phi_2049_ = bool();
                                phi_2050_ = u32();
                            }
                            let _e1111 = phi_2413_;
                            let _e1113 = phi_2367_;
                            let _e1115 = phi_2047_;
                            let _e1117 = phi_2048_;
                            let _e1119 = phi_2049_;
                            let _e1121 = phi_2050_;
                            phi_2412_ = _e1111;
                            phi_2366_ = _e1113;
                            phi_708_ = _e1115;
                            phi_711_ = _e1117;
                            phi_713_ = _e1119;
                            phi_715_ = _e1121;
                            phi_2051_ = _e407;
                        } else {
                            phi_2412_ = _e395;
                            phi_2366_ = _e393;
                            phi_708_ = u32();
                            phi_711_ = u32();
                            phi_713_ = bool();
                            phi_715_ = u32();
                            phi_2051_ = false;
                        }
                        let _e1123 = phi_2412_;
                        let _e1125 = phi_2366_;
                        let _e1127 = phi_708_;
                        let _e1129 = phi_711_;
                        let _e1131 = phi_713_;
                        let _e1133 = phi_715_;
                        let _e1135 = phi_2051_;
                        continue;
                        continuing {
                            phi_2262_ = _e1125;
                            phi_2242_ = _e1123;
                            phi_707_ = _e1127;
                            phi_710_ = _e1129;
                            phi_712_ = _e1131;
                            phi_714_ = _e1133;
                            phi_2365_ = _e1125;
                            break if !(_e1135);
                        }
                    }
                    let _e1138 = phi_2365_;
                    if _e1138 {
                        break;
                    }
                    phi_2058_ = type_4(0u, 8u);
                    loop {
                        let _e1140 = phi_2058_;
                        if (_e1140.member < _e1140.member_1) {
                            phi_2059_ = type_4((_e1140.member + 1u), _e1140.member_1);
                            phi_2082_ = type_4(1u, _e1140.member);
                        } else {
                            phi_2059_ = _e1140;
                            phi_2082_ = type_4(0u, type_4().member_1);
                        }
                        let _e1153 = phi_2059_;
                        let _e1155 = phi_2082_;
                        let _e1159 = (bitcast<i32>(_e1155.member) != 0i);
                        if _e1159 {
                            let _e1160 = (_e1155.member_1 < 8u);
                            if _e1160 {
                            } else {
                                phi_2405_ = true;
                                break;
                            }
                            let _e1162 = local[_e1155.member_1];
                            if (_e1162.member_3 != 4294967295u) {
                                let _e1168 = -(_e353);
                                let _e1169 = (_e1168 / 3i);
                                let _e1176 = bitcast<f32>((bitcast<u32>((_e1169 + 127i)) << bitcast<u32>(23i)));
                                let _e1184 = (((_e1162.member * _e1176) * _e1176) * bitcast<f32>((bitcast<u32>(((_e1168 - (2i * _e1169)) + 127i)) << bitcast<u32>(23i))));
                                let _e1186 = select(340282350000000000000000000000000000000f, _e1184, (_e1184 < 340282350000000000000000000000000000000f));
                                phi_2148_ = type_20(select(-340282350000000000000000000000000000000f, _e1186, (_e1186 > -340282350000000000000000000000000000000f)), _e1162.member_1, _e1162.member_2, _e1162.member_3);
                            } else {
                                phi_2148_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1191 = phi_2148_;
                            if _e1160 {
                            } else {
                                phi_2405_ = true;
                                break;
                            }
                            local[_e1155.member_1] = type_20(_e1191.member, _e1191.member_1, _e1191.member_2, _e1191.member_3);
                        }
                        continue;
                        continuing {
                            phi_2058_ = _e1153;
                            phi_2405_ = _e1138;
                            break if !(_e1159);
                        }
                    }
                    let _e1199 = phi_2405_;
                    if _e1199 {
                        break;
                    }
                    let _e1200 = local;
                    if _e78 {
                    } else {
                        break;
                    }
                    global_5.member[_e76] = array<type_20, 8>(type_20(_e1200[0].member, _e1200[0].member_1, _e1200[0].member_2, _e1200[0].member_3), type_20(_e1200[1].member, _e1200[1].member_1, _e1200[1].member_2, _e1200[1].member_3), type_20(_e1200[2].member, _e1200[2].member_1, _e1200[2].member_2, _e1200[2].member_3), type_20(_e1200[3].member, _e1200[3].member_1, _e1200[3].member_2, _e1200[3].member_3), type_20(_e1200[4].member, _e1200[4].member_1, _e1200[4].member_2, _e1200[4].member_3), type_20(_e1200[5].member, _e1200[5].member_1, _e1200[5].member_2, _e1200[5].member_3), type_20(_e1200[6].member, _e1200[6].member_1, _e1200[6].member_2, _e1200[6].member_3), type_20(_e1200[7].member, _e1200[7].member_1, _e1200[7].member_2, _e1200[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
