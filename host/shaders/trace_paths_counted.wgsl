struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_19 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<type_19>,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_33 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_35 {
    member: array<type_33>,
}

struct type_43 {
    member: type_19,
    member_1: f32,
}

struct type_46 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_48 {
    member: type_43,
    member_1: u32,
    member_2: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_15;
@group(0) @binding(0) 
var<storage> global_2: type_35;
@group(0) @binding(2) 
var<storage> global_3: type_26;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_21;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_4;

fn function_() {
    var local: array<u32, 128>;
    var local_1: array<f32, 128>;
    var phi_264_: i32;
    var phi_265_: i32;
    var phi_275_: bool;
    var phi_285_: u32;
    var phi_286_: u32;
    var phi_288_: bool;
    var phi_293_: u32;
    var phi_337_: f32;
    var phi_343_: f32;
    var phi_354_: f32;
    var phi_360_: f32;
    var phi_383_: f32;
    var phi_398_: f32;
    var phi_407_: f32;
    var phi_413_: f32;
    var phi_424_: f32;
    var phi_430_: f32;
    var phi_453_: f32;
    var phi_468_: f32;
    var phi_477_: f32;
    var phi_483_: f32;
    var phi_494_: f32;
    var phi_500_: f32;
    var phi_523_: f32;
    var phi_538_: f32;
    var phi_638_: f32;
    var phi_639_: f32;
    var phi_2027_: bool;
    var phi_659_: type_48;
    var phi_662_: u32;
    var phi_664_: u32;
    var phi_666_: bool;
    var phi_668_: u32;
    var phi_679_: bool;
    var phi_709_: u32;
    var phi_710_: bool;
    var phi_711_: u32;
    var phi_1538_: type_46;
    var phi_1882_: u32;
    var phi_1908_: u32;
    var phi_1909_: u32;
    var phi_1910_: u32;
    var phi_1912_: u32;
    var phi_1913_: u32;
    var phi_1914_: bool;
    var phi_1923_: u32;
    var phi_1928_: u32;
    var phi_1929_: bool;
    var phi_727_: type_48;
    var phi_730_: type_7;
    var phi_731_: type_7;
    var phi_753_: type_7;
    var phi_776_: u32;
    var phi_864_: array<array<f32, 3>, 3>;
    var phi_1335_: vec3<f32>;
    var phi_1336_: vec3<f32>;
    var phi_1367_: bool;
    var phi_1376_: vec3<f32>;
    var phi_1416_: type_19;
    var phi_1418_: type_19;
    var phi_1419_: bool;
    var phi_1423_: type_19;
    var phi_1424_: type_19;
    var phi_1425_: type_19;
    var phi_1426_: bool;
    var phi_1430_: type_19;
    var phi_1431_: bool;
    var phi_1435_: type_19;
    var phi_1436_: bool;
    var phi_1440_: type_19;
    var phi_1465_: bool;
    var phi_1466_: bool;
    var phi_1473_: type_48;
    var phi_1474_: type_48;
    var phi_1475_: type_48;
    var phi_728_: type_48;
    var phi_2021_: bool;
    var phi_2135_: bool;
    var phi_1931_: type_48;
    var phi_1932_: u32;
    var phi_1933_: bool;
    var phi_1934_: u32;
    var phi_2134_: bool;
    var phi_1935_: type_48;
    var phi_1936_: u32;
    var phi_1937_: u32;
    var phi_1938_: bool;
    var phi_1939_: u32;
    var phi_2133_: bool;
    var phi_1940_: type_48;
    var phi_1941_: u32;
    var phi_1942_: u32;
    var phi_1943_: bool;
    var phi_1944_: u32;
    var phi_2132_: bool;
    var phi_660_: type_48;
    var phi_663_: u32;
    var phi_665_: u32;
    var phi_667_: bool;
    var phi_669_: u32;
    var phi_1945_: bool;
    var phi_2131_: bool;
    var local_2: type_48;
    var phi_1997_: type_19;
    var local_3: type_48;
    var local_4: type_48;

    switch bitcast<i32>(0u) {
        default: {
            let _e60 = global;
            let _e62 = arrayLength((&global_2.member));
            let _e64 = arrayLength((&global_1.member));
            let _e74 = (_e60.x + (_e60.y * 2097152u));
            let _e75 = (_e74 < arrayLength((&global_3.member)));
            if _e75 {
                let _e76 = (_e74 < arrayLength((&global_4.member)));
                if _e76 {
                    let _e77 = (_e74 < arrayLength((&global_5.member)));
                    if _e77 {
                        if _e75 {
                        } else {
                            break;
                        }
                        let _e87 = global_3.member[_e74].member.member_2[0u];
                        let _e89 = (bitcast<u32>(_e87) & 2147483647u);
                        let _e95 = global_3.member[_e74].member.member_2[1u];
                        let _e97 = (bitcast<u32>(_e95) & 2147483647u);
                        let _e103 = global_3.member[_e74].member.member_2[2u];
                        let _e105 = (bitcast<u32>(_e103) & 2147483647u);
                        let _e111 = global_3.member[_e74].member.member[0u];
                        let _e113 = (bitcast<u32>(_e111) & 2147483647u);
                        let _e119 = global_3.member[_e74].member.member[1u];
                        let _e121 = (bitcast<u32>(_e119) & 2147483647u);
                        let _e127 = global_3.member[_e74].member.member[2u];
                        let _e129 = (bitcast<u32>(_e127) & 2147483647u);
                        let _e131 = select(_e97, _e89, (_e97 < _e89));
                        let _e133 = select(_e105, _e131, (_e105 < _e131));
                        let _e135 = select(_e113, _e133, (_e113 < _e133));
                        let _e137 = select(_e121, _e135, (_e121 < _e135));
                        let _e139 = select(_e129, _e137, (_e129 < _e137));
                        let _e144 = global_3.member[_e74].member.member_1;
                        let _e146 = (bitcast<u32>(_e144) & 2147483647u);
                        let _e154 = global_3.member[_e74].member.member_3;
                        let _e160 = (((select(_e146, _e139, (_e146 < _e139)) < 2139095040u) && ((bitcast<u32>(_e154) & 2147483647u) <= 2139095040u)) && (_e133 > 0u));
                        if _e160 {
                            let _e163 = (bitcast<u32>(bitcast<f32>(_e133)) & 2147483647u);
                            if (_e163 >= 8388608u) {
                                phi_264_ = (bitcast<i32>((_e163 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_264_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e163)), 32u, (_e163 == 0u))));
                            }
                            let _e177 = phi_264_;
                            phi_265_ = _e177;
                        } else {
                            phi_265_ = 0i;
                        }
                        let _e179 = phi_265_;
                        let _e180 = (_e89 == _e133);
                        if _e180 {
                            phi_275_ = true;
                        } else {
                            phi_275_ = (_e97 == _e133);
                        }
                        let _e183 = phi_275_;
                        let _e184 = select(1u, 0u, _e180);
                        if _e183 {
                            let _e185 = (_e184 + 1u);
                            phi_285_ = _e185;
                            phi_286_ = _e185;
                            phi_288_ = select(true, false, (_e185 == 2u));
                        } else {
                            phi_285_ = u32();
                            phi_286_ = 0u;
                            phi_288_ = true;
                        }
                        let _e189 = phi_285_;
                        let _e191 = phi_286_;
                        let _e193 = phi_288_;
                        if _e193 {
                            phi_293_ = (_e191 + 1u);
                        } else {
                            phi_293_ = 0u;
                        }
                        let _e197 = phi_293_;
                        let _e198 = select(_e189, _e191, _e193);
                        let _e199 = select(_e184, select(2u, _e184, _e183), _e193);
                        let _e200 = -(_e179);
                        let _e201 = (_e200 / 2i);
                        let _e206 = bitcast<f32>((bitcast<u32>((_e201 + 127i)) << bitcast<u32>(23i)));
                        let _e212 = bitcast<f32>((bitcast<u32>(((_e200 - _e201) + 127i)) << bitcast<u32>(23i)));
                        let _e217 = global_3.member[_e74].member.member;
                        let _e218 = (_e198 == 0u);
                        if _e218 {
                            phi_337_ = _e217[0];
                        } else {
                            phi_337_ = _e217[1];
                        }
                        let _e222 = phi_337_;
                        let _e223 = (_e198 == 2u);
                        if _e223 {
                            phi_343_ = _e217[2];
                        } else {
                            phi_343_ = _e222;
                        }
                        let _e226 = phi_343_;
                        let _e227 = global_3.member[_e74].member.member_2;
                        if _e218 {
                            phi_354_ = _e227[0];
                        } else {
                            phi_354_ = _e227[1];
                        }
                        let _e231 = phi_354_;
                        if _e223 {
                            phi_360_ = _e227[2];
                        } else {
                            phi_360_ = _e231;
                        }
                        let _e234 = phi_360_;
                        let _e236 = ((_e234 * _e206) * _e212);
                        let _e240 = (bitcast<f32>((bitcast<u32>(_e236) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e240 {
                            let _e244 = (bitcast<f32>((bitcast<u32>(_e226) & 2147483647u)) * 0.00000011920929f);
                            phi_383_ = select(0.00000000000000000086736174f, _e244, (_e244 > 0.00000000000000000086736174f));
                        } else {
                            phi_383_ = 0f;
                        }
                        let _e248 = phi_383_;
                        let _e249 = (_e226 + _e248);
                        let _e250 = (_e226 - _e248);
                        let _e251 = select(_e236, 0f, _e240);
                        if _e240 {
                            phi_398_ = 1267650600000000000000000000000f;
                        } else {
                            phi_398_ = (1f / _e236);
                        }
                        let _e254 = phi_398_;
                        let _e255 = (_e197 == 0u);
                        if _e255 {
                            phi_407_ = _e217[0];
                        } else {
                            phi_407_ = _e217[1];
                        }
                        let _e259 = phi_407_;
                        let _e260 = (_e197 == 2u);
                        if _e260 {
                            phi_413_ = _e217[2];
                        } else {
                            phi_413_ = _e259;
                        }
                        let _e263 = phi_413_;
                        if _e255 {
                            phi_424_ = _e227[0];
                        } else {
                            phi_424_ = _e227[1];
                        }
                        let _e267 = phi_424_;
                        if _e260 {
                            phi_430_ = _e227[2];
                        } else {
                            phi_430_ = _e267;
                        }
                        let _e270 = phi_430_;
                        let _e272 = ((_e270 * _e206) * _e212);
                        let _e276 = (bitcast<f32>((bitcast<u32>(_e272) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e276 {
                            let _e280 = (bitcast<f32>((bitcast<u32>(_e263) & 2147483647u)) * 0.00000011920929f);
                            phi_453_ = select(0.00000000000000000086736174f, _e280, (_e280 > 0.00000000000000000086736174f));
                        } else {
                            phi_453_ = 0f;
                        }
                        let _e284 = phi_453_;
                        let _e285 = (_e263 + _e284);
                        let _e286 = (_e263 - _e284);
                        let _e287 = select(_e272, 0f, _e276);
                        if _e276 {
                            phi_468_ = 1267650600000000000000000000000f;
                        } else {
                            phi_468_ = (1f / _e272);
                        }
                        let _e290 = phi_468_;
                        let _e291 = (_e199 == 0u);
                        if _e291 {
                            phi_477_ = _e217[0];
                        } else {
                            phi_477_ = _e217[1];
                        }
                        let _e295 = phi_477_;
                        let _e296 = (_e199 == 2u);
                        if _e296 {
                            phi_483_ = _e217[2];
                        } else {
                            phi_483_ = _e295;
                        }
                        let _e299 = phi_483_;
                        if _e291 {
                            phi_494_ = _e227[0];
                        } else {
                            phi_494_ = _e227[1];
                        }
                        let _e303 = phi_494_;
                        if _e296 {
                            phi_500_ = _e227[2];
                        } else {
                            phi_500_ = _e303;
                        }
                        let _e306 = phi_500_;
                        let _e308 = ((_e306 * _e206) * _e212);
                        let _e312 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e312 {
                            let _e316 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) * 0.00000011920929f);
                            phi_523_ = select(0.00000000000000000086736174f, _e316, (_e316 > 0.00000000000000000086736174f));
                        } else {
                            phi_523_ = 0f;
                        }
                        let _e320 = phi_523_;
                        let _e321 = (_e299 + _e320);
                        let _e322 = (_e299 - _e320);
                        let _e323 = select(_e308, 0f, _e312);
                        if _e312 {
                            phi_538_ = 1267650600000000000000000000000f;
                        } else {
                            phi_538_ = (1f / _e308);
                        }
                        let _e326 = phi_538_;
                        let _e329 = bitcast<f32>((bitcast<u32>(_e226) & 2147483647u));
                        let _e332 = bitcast<f32>((bitcast<u32>(_e263) & 2147483647u));
                        let _e334 = select(_e332, _e329, (_e329 > _e332));
                        let _e337 = bitcast<f32>((bitcast<u32>(_e299) & 2147483647u));
                        if (_e160 && (select(_e337, _e334, (_e334 > _e337)) <= 1099511600000f)) {
                            let _e342 = (_e179 / 3i);
                            let _e349 = bitcast<f32>((bitcast<u32>((_e342 + 127i)) << bitcast<u32>(23i)));
                            let _e356 = bitcast<f32>((bitcast<u32>(((_e179 - (2i * _e342)) + 127i)) << bitcast<u32>(23i)));
                            let _e357 = (((_e144 * _e349) * _e349) * _e356);
                            let _e359 = select(340282350000000000000000000000000000000f, _e357, (_e357 < 340282350000000000000000000000000000000f));
                            let _e364 = (((_e154 * _e349) * _e349) * _e356);
                            let _e366 = select(340282350000000000000000000000000000000f, _e364, (_e364 < 340282350000000000000000000000000000000f));
                            phi_638_ = select(-340282350000000000000000000000000000000f, _e366, (_e366 > -340282350000000000000000000000000000000f));
                            phi_639_ = select(-340282350000000000000000000000000000000f, _e359, (_e359 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_638_ = 0f;
                            phi_639_ = 1f;
                        }
                        let _e370 = phi_638_;
                        let _e372 = phi_639_;
                        if _e75 {
                        } else {
                            break;
                        }
                        let _e378 = global_3.member[_e74].member_2;
                        local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2027_ = false;
                        phi_659_ = type_48(type_43(type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e370), 0u, 0u);
                        phi_662_ = select(0u, 2147483648u, (_e62 == 0u));
                        phi_664_ = ((3u * _e62) + 1u);
                        phi_666_ = (_e372 <= _e370);
                        phi_668_ = 0u;
                        loop {
                            let _e385 = phi_2027_;
                            let _e387 = phi_659_;
                            let _e389 = phi_662_;
                            let _e391 = phi_664_;
                            let _e393 = phi_666_;
                            let _e395 = phi_668_;
                            local_2 = _e387;
                            local_3 = _e387;
                            if _e393 {
                                phi_679_ = true;
                            } else {
                                phi_679_ = (_e395 > 0u);
                            }
                            let _e398 = phi_679_;
                            if _e398 {
                                let _e399 = (_e391 > 0u);
                                if _e399 {
                                    if _e393 {
                                        phi_709_ = _e389;
                                        phi_710_ = _e393;
                                        phi_711_ = _e395;
                                    } else {
                                        let _e400 = (_e395 - 1u);
                                        let _e401 = (_e400 % 128u);
                                        let _e402 = (_e401 < 128u);
                                        if _e402 {
                                        } else {
                                            phi_2131_ = true;
                                            break;
                                        }
                                        let _e404 = local[_e401];
                                        if _e402 {
                                        } else {
                                            phi_2131_ = true;
                                            break;
                                        }
                                        let _e406 = local_1[_e401];
                                        phi_709_ = _e404;
                                        phi_710_ = (_e406 <= _e387.member.member_1);
                                        phi_711_ = _e400;
                                    }
                                    let _e411 = phi_709_;
                                    let _e413 = phi_710_;
                                    let _e415 = phi_711_;
                                    if _e413 {
                                        let _e419 = (_e411 & 268435455u);
                                        if ((_e411 & 2147483648u) != 0u) {
                                            phi_727_ = _e387;
                                            phi_730_ = type_7(_e419, (_e419 + ((_e411 >> bitcast<u32>(28u)) & 7u)));
                                            loop {
                                                let _e621 = phi_727_;
                                                let _e623 = phi_730_;
                                                local_4 = _e621;
                                                if (_e623.member < _e623.member_1) {
                                                    phi_731_ = type_7((_e623.member + 1u), _e623.member_1);
                                                    phi_753_ = type_7(1u, _e623.member);
                                                } else {
                                                    phi_731_ = _e623;
                                                    phi_753_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e636 = phi_731_;
                                                let _e638 = phi_753_;
                                                let _e642 = (bitcast<i32>(_e638.member) != 0i);
                                                if _e642 {
                                                    let _e648 = type_48(_e621.member, _e621.member_1, (_e621.member_2 + 1u));
                                                    let _e649 = (_e638.member_1 < _e64);
                                                    if _e649 {
                                                        if _e649 {
                                                        } else {
                                                            phi_2021_ = true;
                                                            break;
                                                        }
                                                        let _e653 = global_1.member[_e638.member_1].member_1;
                                                        phi_776_ = _e653;
                                                    } else {
                                                        phi_776_ = 4294967295u;
                                                    }
                                                    let _e655 = phi_776_;
                                                    if (_e638.member_1 >= _e64) {
                                                        phi_864_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e649 {
                                                        } else {
                                                            phi_2021_ = true;
                                                            break;
                                                        }
                                                        let _e657 = (_e198 % 3u);
                                                        let _e658 = (_e197 % 3u);
                                                        let _e659 = (_e199 % 3u);
                                                        if (_e657 < 9u) {
                                                        } else {
                                                            phi_2021_ = true;
                                                            break;
                                                        }
                                                        let _e665 = global_1.member[_e638.member_1].member[_e657];
                                                        if (_e658 < 9u) {
                                                        } else {
                                                            phi_2021_ = true;
                                                            break;
                                                        }
                                                        let _e671 = global_1.member[_e638.member_1].member[_e658];
                                                        if (_e659 < 9u) {
                                                        } else {
                                                            phi_2021_ = true;
                                                            break;
                                                        }
                                                        let _e677 = global_1.member[_e638.member_1].member[_e659];
                                                        let _e679 = (3u + _e657);
                                                        if (_e679 < 9u) {
                                                        } else {
                                                            phi_2021_ = true;
                                                            break;
                                                        }
                                                        let _e685 = global_1.member[_e638.member_1].member[_e679];
                                                        let _e686 = (3u + _e658);
                                                        if (_e686 < 9u) {
                                                        } else {
                                                            phi_2021_ = true;
                                                            break;
                                                        }
                                                        let _e692 = global_1.member[_e638.member_1].member[_e686];
                                                        let _e693 = (3u + _e659);
                                                        if (_e693 < 9u) {
                                                        } else {
                                                            phi_2021_ = true;
                                                            break;
                                                        }
                                                        let _e699 = global_1.member[_e638.member_1].member[_e693];
                                                        let _e701 = (6u + _e657);
                                                        if (_e701 < 9u) {
                                                        } else {
                                                            phi_2021_ = true;
                                                            break;
                                                        }
                                                        let _e707 = global_1.member[_e638.member_1].member[_e701];
                                                        let _e708 = (6u + _e658);
                                                        if (_e708 < 9u) {
                                                        } else {
                                                            phi_2021_ = true;
                                                            break;
                                                        }
                                                        let _e714 = global_1.member[_e638.member_1].member[_e708];
                                                        let _e715 = (6u + _e659);
                                                        if (_e715 < 9u) {
                                                        } else {
                                                            phi_2021_ = true;
                                                            break;
                                                        }
                                                        let _e721 = global_1.member[_e638.member_1].member[_e715];
                                                        phi_864_ = array<array<f32, 3>, 3>(array<f32, 3>(_e665, _e671, _e677), array<f32, 3>(_e685, _e692, _e699), array<f32, 3>(_e707, _e714, _e721));
                                                    }
                                                    let _e725 = phi_864_;
                                                    let _e734 = (_e725[0][2] - _e299);
                                                    let _e737 = (((_e725[0][0] - _e226) * _e323) - (_e734 * _e251));
                                                    let _e740 = (((_e725[0][1] - _e263) * _e323) - (_e734 * _e287));
                                                    let _e747 = (_e725[1][2] - _e299);
                                                    let _e750 = (((_e725[1][0] - _e226) * _e323) - (_e747 * _e251));
                                                    let _e753 = (((_e725[1][1] - _e263) * _e323) - (_e747 * _e287));
                                                    let _e760 = (_e725[2][2] - _e299);
                                                    let _e763 = (((_e725[2][0] - _e226) * _e323) - (_e760 * _e251));
                                                    let _e766 = (((_e725[2][1] - _e263) * _e323) - (_e760 * _e287));
                                                    let _e767 = (_e763 * _e753);
                                                    let _e768 = (_e766 * _e750);
                                                    let _e769 = (_e737 * _e766);
                                                    let _e770 = (_e740 * _e763);
                                                    let _e771 = (_e750 * _e740);
                                                    let _e772 = (_e753 * _e737);
                                                    let _e777 = (((_e767 >= _e768) && (_e769 >= _e770)) && (_e771 >= _e772));
                                                    if (_e777 || (((_e767 <= _e768) && (_e769 <= _e770)) && (_e771 <= _e772))) {
                                                        let _e784 = select(-1f, 1f, _e777);
                                                        let _e786 = ((_e767 - _e768) * _e784);
                                                        let _e788 = select(0f, _e786, (_e786 > 0f));
                                                        let _e790 = ((_e769 - _e770) * _e784);
                                                        let _e792 = select(0f, _e790, (_e790 > 0f));
                                                        let _e794 = ((_e771 - _e772) * _e784);
                                                        let _e796 = select(0f, _e794, (_e794 > 0f));
                                                        let _e798 = ((_e788 + _e792) + _e796);
                                                        if (_e798 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1430_ = type_19();
                                                            phi_1431_ = true;
                                                        } else {
                                                            let _e801 = select(_e725[1][0], _e725[0][0], (_e725[0][0] < _e725[1][0]));
                                                            let _e805 = select(_e725[1][0], _e725[0][0], (_e725[0][0] > _e725[1][0]));
                                                            let _e809 = select(_e725[1][1], _e725[0][1], (_e725[0][1] < _e725[1][1]));
                                                            let _e813 = select(_e725[1][1], _e725[0][1], (_e725[0][1] > _e725[1][1]));
                                                            let _e817 = select(_e725[1][2], _e725[0][2], (_e725[0][2] < _e725[1][2]));
                                                            let _e821 = select(_e725[1][2], _e725[0][2], (_e725[0][2] > _e725[1][2]));
                                                            let _e826 = ((select(_e725[2][0], _e801, (_e801 < _e725[2][0])) - _e249) * _e254);
                                                            let _e827 = ((select(_e725[2][0], _e805, (_e805 > _e725[2][0])) - _e250) * _e254);
                                                            let _e830 = ((select(_e725[2][1], _e809, (_e809 < _e725[2][1])) - _e285) * _e290);
                                                            let _e831 = ((select(_e725[2][1], _e813, (_e813 > _e725[2][1])) - _e286) * _e290);
                                                            let _e834 = ((select(_e725[2][2], _e817, (_e817 < _e725[2][2])) - _e321) * _e326);
                                                            let _e835 = ((select(_e725[2][2], _e821, (_e821 > _e725[2][2])) - _e322) * _e326);
                                                            let _e837 = select(_e835, _e834, (_e834 < _e835));
                                                            let _e839 = select(_e835, _e834, (_e834 > _e835));
                                                            let _e841 = select(_e827, _e826, (_e826 < _e827));
                                                            let _e843 = select(_e831, _e830, (_e830 < _e831));
                                                            let _e845 = select(_e843, _e841, (_e841 > _e843));
                                                            let _e847 = select(_e837, _e845, (_e845 > _e837));
                                                            let _e849 = select(_e827, _e826, (_e826 > _e827));
                                                            let _e851 = select(_e831, _e830, (_e830 > _e831));
                                                            let _e853 = select(_e851, _e849, (_e849 < _e851));
                                                            let _e855 = select(_e839, _e853, (_e853 < _e839));
                                                            let _e856 = -(_e837);
                                                            let _e862 = select(_e372, _e847, (_e847 > _e372));
                                                            if (_e862 > (_e855 + (select(_e856, _e839, (_e839 > _e856)) * 0.0000019073523f))) {
                                                                phi_1425_ = type_19();
                                                                phi_1426_ = true;
                                                            } else {
                                                                let _e864 = (_e862 > _e621.member.member_1);
                                                                if _e864 {
                                                                    phi_1424_ = type_19();
                                                                } else {
                                                                    let _e868 = (_e725[1][0] - _e725[0][0]);
                                                                    let _e869 = (_e725[1][1] - _e725[0][1]);
                                                                    let _e870 = (_e725[1][2] - _e725[0][2]);
                                                                    let _e871 = vec3<f32>(_e868, _e869, _e870);
                                                                    let _e872 = (_e725[2][0] - _e725[1][0]);
                                                                    let _e873 = (_e725[2][1] - _e725[1][1]);
                                                                    let _e874 = (_e725[2][2] - _e725[1][2]);
                                                                    let _e875 = vec3<f32>(_e872, _e873, _e874);
                                                                    let _e876 = (_e725[0][0] - _e725[2][0]);
                                                                    let _e877 = (_e725[0][1] - _e725[2][1]);
                                                                    let _e878 = (_e725[0][2] - _e725[2][2]);
                                                                    let _e879 = vec3<f32>(_e876, _e877, _e878);
                                                                    let _e882 = bitcast<f32>((bitcast<u32>(_e868) & 2147483647u));
                                                                    let _e885 = bitcast<f32>((bitcast<u32>(_e869) & 2147483647u));
                                                                    let _e887 = select(_e885, _e882, (_e882 > _e885));
                                                                    let _e890 = bitcast<f32>((bitcast<u32>(_e870) & 2147483647u));
                                                                    let _e892 = select(_e890, _e887, (_e887 > _e890));
                                                                    let _e895 = bitcast<f32>((bitcast<u32>(_e872) & 2147483647u));
                                                                    let _e898 = bitcast<f32>((bitcast<u32>(_e873) & 2147483647u));
                                                                    let _e900 = select(_e898, _e895, (_e895 > _e898));
                                                                    let _e903 = bitcast<f32>((bitcast<u32>(_e874) & 2147483647u));
                                                                    let _e905 = select(_e903, _e900, (_e900 > _e903));
                                                                    let _e908 = bitcast<f32>((bitcast<u32>(_e876) & 2147483647u));
                                                                    let _e911 = bitcast<f32>((bitcast<u32>(_e877) & 2147483647u));
                                                                    let _e913 = select(_e911, _e908, (_e908 > _e911));
                                                                    let _e916 = bitcast<f32>((bitcast<u32>(_e878) & 2147483647u));
                                                                    let _e918 = select(_e916, _e913, (_e913 > _e916));
                                                                    let _e920 = select(_e905, _e892, (_e892 > _e905));
                                                                    let _e922 = select(_e918, _e920, (_e920 > _e918));
                                                                    if (_e892 == _e922) {
                                                                        phi_1335_ = _e875;
                                                                        phi_1336_ = _e879;
                                                                    } else {
                                                                        let _e925 = vec3((_e905 == _e922));
                                                                        phi_1335_ = select(_e871, _e879, _e925);
                                                                        phi_1336_ = select(_e875, _e871, _e925);
                                                                    }
                                                                    let _e929 = phi_1335_;
                                                                    let _e931 = phi_1336_;
                                                                    let _e938 = ((_e929.y * _e931.z) - (_e931.y * _e929.z));
                                                                    let _e943 = ((_e929.z * _e931.x) - (_e931.z * _e929.x));
                                                                    let _e946 = ((_e929.x * _e931.y) - (_e931.x * _e929.y));
                                                                    if (_e788 >= _e792) {
                                                                        phi_1367_ = select(true, false, (_e788 >= _e796));
                                                                    } else {
                                                                        phi_1367_ = true;
                                                                    }
                                                                    let _e951 = phi_1367_;
                                                                    if _e951 {
                                                                        phi_1376_ = select(vec3<f32>(_e725[2][0], _e725[2][1], _e725[2][2]), vec3<f32>(_e725[1][0], _e725[1][1], _e725[1][2]), vec3((_e792 >= _e796)));
                                                                    } else {
                                                                        phi_1376_ = vec3<f32>(_e725[0][0], _e725[0][1], _e725[0][2]);
                                                                    }
                                                                    let _e956 = phi_1376_;
                                                                    let _e973 = ((((_e938 * (_e956.x - _e226)) + (_e943 * (_e956.y - _e263))) + (_e946 * (_e956.z - _e299))) / (((_e938 * _e251) + (_e943 * _e287)) + (_e946 * _e323)));
                                                                    let _e975 = select(_e855, _e973, (_e973 < _e855));
                                                                    let _e977 = select(_e847, _e975, (_e975 > _e847));
                                                                    if (_e977 >= _e372) {
                                                                        let _e979 = (_e977 <= _e621.member.member_1);
                                                                        if _e979 {
                                                                            let _e980 = (1f / _e798);
                                                                            phi_1416_ = type_19(_e977, (_e792 * _e980), (_e796 * _e980), _e655);
                                                                        } else {
                                                                            phi_1416_ = type_19();
                                                                        }
                                                                        let _e985 = phi_1416_;
                                                                        phi_1418_ = _e985;
                                                                        phi_1419_ = select(true, false, _e979);
                                                                    } else {
                                                                        phi_1418_ = type_19();
                                                                        phi_1419_ = true;
                                                                    }
                                                                    let _e988 = phi_1418_;
                                                                    let _e990 = phi_1419_;
                                                                    if _e990 {
                                                                        phi_1423_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1423_ = _e988;
                                                                    }
                                                                    let _e992 = phi_1423_;
                                                                    phi_1424_ = _e992;
                                                                }
                                                                let _e994 = phi_1424_;
                                                                phi_1425_ = _e994;
                                                                phi_1426_ = _e864;
                                                            }
                                                            let _e996 = phi_1425_;
                                                            let _e998 = phi_1426_;
                                                            phi_1430_ = _e996;
                                                            phi_1431_ = _e998;
                                                        }
                                                        let _e1000 = phi_1430_;
                                                        let _e1002 = phi_1431_;
                                                        phi_1435_ = _e1000;
                                                        phi_1436_ = _e1002;
                                                    } else {
                                                        phi_1435_ = type_19();
                                                        phi_1436_ = true;
                                                    }
                                                    let _e1004 = phi_1435_;
                                                    let _e1006 = phi_1436_;
                                                    if _e1006 {
                                                        phi_1440_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1440_ = _e1004;
                                                    }
                                                    let _e1008 = phi_1440_;
                                                    if (_e1008.member_3 != 4294967295u) {
                                                        if (_e655 != _e378) {
                                                            if (_e1008.member < _e621.member.member.member) {
                                                                phi_1466_ = true;
                                                            } else {
                                                                if (_e1008.member == _e621.member.member.member) {
                                                                    phi_1465_ = (_e1008.member_3 < _e621.member.member.member_3);
                                                                } else {
                                                                    phi_1465_ = false;
                                                                }
                                                                let _e1023 = phi_1465_;
                                                                phi_1466_ = _e1023;
                                                            }
                                                            let _e1025 = phi_1466_;
                                                            if _e1025 {
                                                                phi_1473_ = type_48(type_43(_e1008, _e1008.member), _e648.member_1, _e648.member_2);
                                                            } else {
                                                                phi_1473_ = _e648;
                                                            }
                                                            let _e1032 = phi_1473_;
                                                            phi_1474_ = _e1032;
                                                        } else {
                                                            phi_1474_ = _e648;
                                                        }
                                                        let _e1034 = phi_1474_;
                                                        phi_1475_ = _e1034;
                                                    } else {
                                                        phi_1475_ = _e648;
                                                    }
                                                    let _e1036 = phi_1475_;
                                                    phi_728_ = _e1036;
                                                } else {
                                                    phi_728_ = type_48();
                                                }
                                                let _e1038 = phi_728_;
                                                continue;
                                                continuing {
                                                    phi_727_ = _e1038;
                                                    phi_730_ = _e636;
                                                    phi_2021_ = _e385;
                                                    break if !(_e642);
                                                }
                                            }
                                            let _e1041 = phi_2021_;
                                            phi_2131_ = _e1041;
                                            if _e1041 {
                                                break;
                                            }
                                            phi_2135_ = _e1041;
                                            let _e1212 = local_4;
                                            phi_1931_ = _e1212;
                                            phi_1932_ = _e411;
                                            phi_1933_ = false;
                                            phi_1934_ = _e415;
                                        } else {
                                            if (_e411 >= _e62) {
                                                phi_1538_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e411 < _e62) {
                                                } else {
                                                    phi_2131_ = true;
                                                    break;
                                                }
                                                let _e431 = (_e198 % 3u);
                                                if (_e431 < 3u) {
                                                } else {
                                                    phi_2131_ = true;
                                                    break;
                                                }
                                                let _e437 = global_2.member[_e411].member[_e431];
                                                let _e443 = (_e197 % 3u);
                                                if (_e443 < 3u) {
                                                } else {
                                                    phi_2131_ = true;
                                                    break;
                                                }
                                                let _e449 = global_2.member[_e411].member[_e443];
                                                let _e455 = (_e199 % 3u);
                                                if (_e455 < 3u) {
                                                } else {
                                                    phi_2131_ = true;
                                                    break;
                                                }
                                                let _e461 = global_2.member[_e411].member[_e455];
                                                let _e471 = global_2.member[_e411].member_1;
                                                let _e475 = global_2.member[_e411].member_2;
                                                phi_1538_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e437[0], _e437[1], _e437[2], _e437[3]), vec4<f32>(_e449[0], _e449[1], _e449[2], _e449[3]), vec4<f32>(_e461[0], _e461[1], _e461[2], _e461[3])), _e471, _e475);
                                            }
                                            let _e478 = phi_1538_;
                                            let _e491 = ((_e478.member[0].x - _e249) * _e254);
                                            let _e492 = ((_e478.member[0].y - _e249) * _e254);
                                            let _e493 = ((_e478.member[0].z - _e250) * _e254);
                                            let _e494 = ((_e478.member[0].w - _e250) * _e254);
                                            let _e504 = ((_e478.member[1].x - _e285) * _e290);
                                            let _e505 = ((_e478.member[1].y - _e285) * _e290);
                                            let _e506 = ((_e478.member[1].z - _e286) * _e290);
                                            let _e507 = ((_e478.member[1].w - _e286) * _e290);
                                            let _e517 = ((_e478.member[2].x - _e321) * _e326);
                                            let _e518 = ((_e478.member[2].y - _e321) * _e326);
                                            let _e519 = ((_e478.member[2].z - _e322) * _e326);
                                            let _e520 = ((_e478.member[2].w - _e322) * _e326);
                                            let _e522 = select(_e519, _e517, (_e517 < _e519));
                                            let _e524 = select(_e520, _e518, (_e518 < _e520));
                                            let _e526 = select(_e519, _e517, (_e517 > _e519));
                                            let _e528 = select(_e520, _e518, (_e518 > _e520));
                                            let _e530 = select(_e493, _e491, (_e491 < _e493));
                                            let _e532 = select(_e494, _e492, (_e492 < _e494));
                                            let _e534 = select(_e506, _e504, (_e504 < _e506));
                                            let _e536 = select(_e507, _e505, (_e505 < _e507));
                                            let _e538 = select(_e534, _e530, (_e530 > _e534));
                                            let _e540 = select(_e536, _e532, (_e532 > _e536));
                                            let _e542 = select(_e522, _e538, (_e538 > _e522));
                                            let _e544 = select(_e524, _e540, (_e540 > _e524));
                                            let _e546 = select(_e493, _e491, (_e491 > _e493));
                                            let _e548 = select(_e494, _e492, (_e492 > _e494));
                                            let _e550 = select(_e506, _e504, (_e504 > _e506));
                                            let _e552 = select(_e507, _e505, (_e505 > _e507));
                                            let _e554 = select(_e550, _e546, (_e546 < _e550));
                                            let _e556 = select(_e552, _e548, (_e548 < _e552));
                                            let _e561 = -(_e522);
                                            let _e562 = -(_e524);
                                            let _e569 = (select(_e526, _e554, (_e554 < _e526)) + (select(_e561, _e526, (_e526 > _e561)) * 0.0000019073523f));
                                            let _e570 = (select(_e528, _e556, (_e556 < _e528)) + (select(_e562, _e528, (_e528 > _e562)) * 0.0000019073523f));
                                            let _e572 = select(_e372, _e542, (_e542 > _e372));
                                            let _e574 = select(_e372, _e544, (_e544 > _e372));
                                            let _e579 = (_e572 <= select(_e387.member.member_1, _e569, (_e569 < _e387.member.member_1)));
                                            let _e580 = (_e574 <= select(_e387.member.member_1, _e570, (_e570 < _e387.member.member_1)));
                                            let _e581 = (_e572 <= _e574);
                                            if _e579 {
                                                if _e580 {
                                                    if _e581 {
                                                        phi_1882_ = _e478.member_2;
                                                    } else {
                                                        phi_1882_ = _e478.member_1;
                                                    }
                                                    let _e585 = phi_1882_;
                                                    let _e586 = (_e415 % 128u);
                                                    let _e587 = (_e586 < 128u);
                                                    if _e587 {
                                                    } else {
                                                        phi_2131_ = true;
                                                        break;
                                                    }
                                                    local[_e586] = _e585;
                                                    if _e587 {
                                                    } else {
                                                        phi_2131_ = true;
                                                        break;
                                                    }
                                                    local_1[_e586] = select(_e574, _e572, (_e572 > _e574));
                                                    if _e581 {
                                                        phi_1908_ = _e478.member_1;
                                                    } else {
                                                        phi_1908_ = _e478.member_2;
                                                    }
                                                    let _e596 = phi_1908_;
                                                    phi_1909_ = _e596;
                                                    phi_1910_ = (_e415 + 1u);
                                                } else {
                                                    phi_1909_ = u32();
                                                    phi_1910_ = u32();
                                                }
                                                let _e598 = phi_1909_;
                                                let _e600 = phi_1910_;
                                                phi_1912_ = _e598;
                                                phi_1913_ = _e600;
                                                phi_1914_ = select(true, false, _e580);
                                            } else {
                                                phi_1912_ = u32();
                                                phi_1913_ = u32();
                                                phi_1914_ = true;
                                            }
                                            let _e603 = phi_1912_;
                                            let _e605 = phi_1913_;
                                            let _e607 = phi_1914_;
                                            if _e607 {
                                                if _e579 {
                                                    phi_1923_ = _e478.member_1;
                                                } else {
                                                    phi_1923_ = _e478.member_2;
                                                }
                                                let _e611 = phi_1923_;
                                                phi_1928_ = _e611;
                                                phi_1929_ = select(_e580, true, _e579);
                                            } else {
                                                phi_1928_ = _e603;
                                                phi_1929_ = _e413;
                                            }
                                            let _e614 = phi_1928_;
                                            let _e616 = phi_1929_;
                                            phi_2135_ = _e385;
                                            phi_1931_ = type_48(_e387.member, (_e387.member_1 + 1u), _e387.member_2);
                                            phi_1932_ = _e614;
                                            phi_1933_ = _e616;
                                            phi_1934_ = select(_e605, _e415, _e607);
                                        }
                                        let _e1043 = phi_2135_;
                                        let _e1045 = phi_1931_;
                                        let _e1047 = phi_1932_;
                                        let _e1049 = phi_1933_;
                                        let _e1051 = phi_1934_;
                                        phi_2134_ = _e1043;
                                        phi_1935_ = _e1045;
                                        phi_1936_ = _e1047;
                                        phi_1937_ = (_e391 - 1u);
                                        phi_1938_ = _e1049;
                                        phi_1939_ = _e1051;
                                    } else {
                                        phi_2134_ = _e385;
                                        phi_1935_ = _e387;
                                        phi_1936_ = _e411;
                                        phi_1937_ = _e391;
                                        phi_1938_ = _e413;
                                        phi_1939_ = _e415;
                                    }
                                    let _e1053 = phi_2134_;
                                    let _e1055 = phi_1935_;
                                    let _e1057 = phi_1936_;
                                    let _e1059 = phi_1937_;
                                    let _e1061 = phi_1938_;
                                    let _e1063 = phi_1939_;
                                    phi_2133_ = _e1053;
                                    phi_1940_ = _e1055;
                                    phi_1941_ = _e1057;
                                    phi_1942_ = _e1059;
                                    phi_1943_ = _e1061;
                                    phi_1944_ = _e1063;
                                } else {
                                    phi_2133_ = _e385;
                                    phi_1940_ = type_48();
                                    phi_1941_ = u32();
                                    phi_1942_ = u32();
                                    phi_1943_ = bool();
                                    phi_1944_ = u32();
                                }
                                let _e1065 = phi_2133_;
                                let _e1067 = phi_1940_;
                                let _e1069 = phi_1941_;
                                let _e1071 = phi_1942_;
                                let _e1073 = phi_1943_;
                                let _e1075 = phi_1944_;
                                phi_2132_ = _e1065;
                                phi_660_ = _e1067;
                                phi_663_ = _e1069;
                                phi_665_ = _e1071;
                                phi_667_ = _e1073;
                                phi_669_ = _e1075;
                                phi_1945_ = _e399;
                            } else {
                                phi_2132_ = _e385;
                                phi_660_ = type_48();
                                phi_663_ = u32();
                                phi_665_ = u32();
                                phi_667_ = bool();
                                phi_669_ = u32();
                                phi_1945_ = false;
                            }
                            let _e1077 = phi_2132_;
                            let _e1079 = phi_660_;
                            let _e1081 = phi_663_;
                            let _e1083 = phi_665_;
                            let _e1085 = phi_667_;
                            let _e1087 = phi_669_;
                            let _e1089 = phi_1945_;
                            continue;
                            continuing {
                                phi_2027_ = _e1077;
                                phi_659_ = _e1079;
                                phi_662_ = _e1081;
                                phi_664_ = _e1083;
                                phi_666_ = _e1085;
                                phi_668_ = _e1087;
                                phi_2131_ = _e1077;
                                break if !(_e1089);
                            }
                        }
                        let _e1092 = phi_2131_;
                        if _e1092 {
                            break;
                        }
                        let _e1094 = local_2;
                        if (_e1094.member.member.member_3 != 4294967295u) {
                            let _e1100 = (_e200 / 3i);
                            let _e1107 = bitcast<f32>((bitcast<u32>((_e1100 + 127i)) << bitcast<u32>(23i)));
                            let _e1115 = (((_e1094.member.member.member * _e1107) * _e1107) * bitcast<f32>((bitcast<u32>(((_e200 - (2i * _e1100)) + 127i)) << bitcast<u32>(23i))));
                            let _e1117 = select(340282350000000000000000000000000000000f, _e1115, (_e1115 < 340282350000000000000000000000000000000f));
                            phi_1997_ = type_19(select(-340282350000000000000000000000000000000f, _e1117, (_e1117 > -340282350000000000000000000000000000000f)), _e1094.member.member.member_1, _e1094.member.member.member_2, _e1094.member.member.member_3);
                        } else {
                            phi_1997_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1124 = phi_1997_;
                        if _e76 {
                        } else {
                            break;
                        }
                        global_4.member[_e74] = _e1124;
                        let _e1128 = local_3;
                        if _e77 {
                        } else {
                            break;
                        }
                        global_5.member[_e74] = _e1128.member_1;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_paths_counted(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
