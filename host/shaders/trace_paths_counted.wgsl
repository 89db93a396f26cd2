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

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_34 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_36 {
    member: array<type_34>,
}

struct type_42 {
    member: type_22,
    member_1: f32,
}

struct type_47 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_48 {
    member: type_42,
    member_1: u32,
    member_2: u32,
}

struct type_52 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_15;
@group(0) @binding(0) 
var<storage> global_2: type_36;
@group(0) @binding(2) 
var<storage> global_3: type_29;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_24;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_52;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_278_: i32;
    var phi_279_: i32;
    var phi_289_: bool;
    var phi_299_: u32;
    var phi_300_: u32;
    var phi_302_: bool;
    var phi_307_: u32;
    var phi_339_: i32;
    var phi_357_: f32;
    var phi_363_: f32;
    var phi_374_: f32;
    var phi_380_: f32;
    var phi_403_: f32;
    var phi_414_: f32;
    var phi_423_: f32;
    var phi_429_: f32;
    var phi_440_: f32;
    var phi_446_: f32;
    var phi_469_: f32;
    var phi_480_: f32;
    var phi_489_: f32;
    var phi_495_: f32;
    var phi_506_: f32;
    var phi_512_: f32;
    var phi_535_: f32;
    var phi_546_: f32;
    var phi_646_: f32;
    var phi_647_: f32;
    var phi_2150_: bool;
    var phi_667_: type_48;
    var phi_670_: u32;
    var phi_672_: u32;
    var phi_674_: bool;
    var phi_676_: u32;
    var phi_687_: bool;
    var phi_719_: u32;
    var phi_720_: bool;
    var phi_721_: u32;
    var phi_1549_: type_47;
    var phi_1893_: u32;
    var phi_1921_: u32;
    var phi_1922_: u32;
    var phi_1923_: u32;
    var phi_1925_: u32;
    var phi_1926_: u32;
    var phi_1927_: bool;
    var phi_1936_: u32;
    var phi_1941_: u32;
    var phi_1942_: bool;
    var phi_736_: type_48;
    var phi_739_: type_7;
    var phi_740_: type_7;
    var phi_762_: type_7;
    var phi_786_: u32;
    var phi_875_: array<array<f32, 3>, 3>;
    var phi_1346_: vec3<f32>;
    var phi_1347_: vec3<f32>;
    var phi_1378_: bool;
    var phi_1387_: vec3<f32>;
    var phi_1427_: type_22;
    var phi_1429_: type_22;
    var phi_1430_: bool;
    var phi_1434_: type_22;
    var phi_1435_: type_22;
    var phi_1436_: type_22;
    var phi_1437_: bool;
    var phi_1441_: type_22;
    var phi_1442_: bool;
    var phi_1446_: type_22;
    var phi_1447_: bool;
    var phi_1451_: type_22;
    var phi_1476_: bool;
    var phi_1477_: bool;
    var phi_1484_: type_48;
    var phi_1485_: type_48;
    var phi_1486_: type_48;
    var phi_737_: type_48;
    var phi_2144_: bool;
    var phi_2262_: bool;
    var phi_1944_: type_48;
    var phi_1945_: u32;
    var phi_1946_: bool;
    var phi_1947_: u32;
    var phi_2261_: bool;
    var phi_1948_: type_48;
    var phi_1949_: u32;
    var phi_1950_: u32;
    var phi_1951_: bool;
    var phi_1952_: u32;
    var phi_2260_: bool;
    var phi_1953_: type_48;
    var phi_1954_: u32;
    var phi_1955_: u32;
    var phi_1956_: bool;
    var phi_1957_: u32;
    var phi_2259_: bool;
    var phi_668_: type_48;
    var phi_671_: u32;
    var phi_673_: u32;
    var phi_675_: bool;
    var phi_677_: u32;
    var phi_1958_: bool;
    var phi_2258_: bool;
    var local_2: type_48;
    var phi_2010_: type_22;
    var local_3: type_48;
    var local_4: type_48;

    switch bitcast<i32>(0u) {
        default: {
            let _e64 = global;
            let _e66 = arrayLength((&global_2.member));
            let _e68 = arrayLength((&global_1.member));
            let _e76 = arrayLength((&global_6.member));
            let _e80 = (_e64.x + (_e64.y * 2097152u));
            let _e81 = (_e80 < arrayLength((&global_3.member)));
            if _e81 {
                let _e82 = (_e80 < arrayLength((&global_4.member)));
                if _e82 {
                    let _e83 = (_e80 < arrayLength((&global_5.member)));
                    if _e83 {
                        if _e81 {
                        } else {
                            break;
                        }
                        let _e93 = global_3.member[_e80].member.member_2[0u];
                        let _e95 = (bitcast<u32>(_e93) & 2147483647u);
                        let _e101 = global_3.member[_e80].member.member_2[1u];
                        let _e103 = (bitcast<u32>(_e101) & 2147483647u);
                        let _e109 = global_3.member[_e80].member.member_2[2u];
                        let _e111 = (bitcast<u32>(_e109) & 2147483647u);
                        let _e117 = global_3.member[_e80].member.member[0u];
                        let _e119 = (bitcast<u32>(_e117) & 2147483647u);
                        let _e125 = global_3.member[_e80].member.member[1u];
                        let _e127 = (bitcast<u32>(_e125) & 2147483647u);
                        let _e133 = global_3.member[_e80].member.member[2u];
                        let _e135 = (bitcast<u32>(_e133) & 2147483647u);
                        let _e137 = select(_e103, _e95, (_e103 < _e95));
                        let _e139 = select(_e111, _e137, (_e111 < _e137));
                        let _e141 = select(_e119, _e139, (_e119 < _e139));
                        let _e143 = select(_e127, _e141, (_e127 < _e141));
                        let _e145 = select(_e135, _e143, (_e135 < _e143));
                        let _e150 = global_3.member[_e80].member.member_1;
                        let _e152 = (bitcast<u32>(_e150) & 2147483647u);
                        let _e160 = global_3.member[_e80].member.member_3;
                        let _e166 = (((select(_e152, _e145, (_e152 < _e145)) < 2139095040u) && ((bitcast<u32>(_e160) & 2147483647u) <= 2139095040u)) && (_e139 > 0u));
                        if _e166 {
                            let _e169 = (bitcast<u32>(bitcast<f32>(_e139)) & 2147483647u);
                            if (_e169 >= 8388608u) {
                                phi_278_ = (bitcast<i32>((_e169 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_278_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e169)), 32u, (_e169 == 0u))));
                            }
                            let _e183 = phi_278_;
                            phi_279_ = _e183;
                        } else {
                            phi_279_ = 0i;
                        }
                        let _e185 = phi_279_;
                        let _e186 = (_e95 == _e139);
                        if _e186 {
                            phi_289_ = true;
                        } else {
                            phi_289_ = (_e103 == _e139);
                        }
                        let _e189 = phi_289_;
                        let _e190 = select(1u, 0u, _e186);
                        if _e189 {
                            let _e191 = (_e190 + 1u);
                            phi_299_ = _e191;
                            phi_300_ = _e191;
                            phi_302_ = select(true, false, (_e191 == 2u));
                        } else {
                            phi_299_ = u32();
                            phi_300_ = 0u;
                            phi_302_ = true;
                        }
                        let _e195 = phi_299_;
                        let _e197 = phi_300_;
                        let _e199 = phi_302_;
                        if _e199 {
                            phi_307_ = (_e197 + 1u);
                        } else {
                            phi_307_ = 0u;
                        }
                        let _e203 = phi_307_;
                        let _e204 = select(_e195, _e197, _e199);
                        let _e205 = select(_e190, select(2u, _e190, _e189), _e199);
                        let _e206 = -(_e185);
                        if (_e206 < -126i) {
                            phi_339_ = -126i;
                        } else {
                            phi_339_ = select(_e206, 127i, (_e206 > 127i));
                        }
                        let _e211 = phi_339_;
                        let _e216 = bitcast<f32>((bitcast<u32>((_e211 + 127i)) << bitcast<u32>(23i)));
                        let _e222 = bitcast<f32>((bitcast<u32>(((_e206 - _e211) + 127i)) << bitcast<u32>(23i)));
                        let _e227 = global_3.member[_e80].member.member;
                        let _e228 = (_e204 == 0u);
                        if _e228 {
                            phi_357_ = _e227[0];
                        } else {
                            phi_357_ = _e227[1];
                        }
                        let _e232 = phi_357_;
                        let _e233 = (_e204 == 2u);
                        if _e233 {
                            phi_363_ = _e227[2];
                        } else {
                            phi_363_ = _e232;
                        }
                        let _e236 = phi_363_;
                        let _e237 = global_3.member[_e80].member.member_2;
                        if _e228 {
                            phi_374_ = _e237[0];
                        } else {
                            phi_374_ = _e237[1];
                        }
                        let _e241 = phi_374_;
                        if _e233 {
                            phi_380_ = _e237[2];
                        } else {
                            phi_380_ = _e241;
                        }
                        let _e244 = phi_380_;
                        let _e246 = ((_e244 * _e216) * _e222);
                        let _e250 = (bitcast<f32>((bitcast<u32>(_e246) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e250 {
                            let _e254 = (bitcast<f32>((bitcast<u32>(_e236) & 2147483647u)) * 0.00000011920929f);
                            phi_403_ = select(0.00000000000011368684f, _e254, (_e254 > 0.00000000000011368684f));
                        } else {
                            phi_403_ = 0f;
                        }
                        let _e258 = phi_403_;
                        let _e259 = (_e236 + _e258);
                        let _e260 = (_e236 - _e258);
                        let _e261 = select(_e246, 0f, _e250);
                        if _e250 {
                            phi_414_ = 38685626000000000000000000f;
                        } else {
                            phi_414_ = (1f / _e246);
                        }
                        let _e264 = phi_414_;
                        let _e265 = (_e203 == 0u);
                        if _e265 {
                            phi_423_ = _e227[0];
                        } else {
                            phi_423_ = _e227[1];
                        }
                        let _e269 = phi_423_;
                        let _e270 = (_e203 == 2u);
                        if _e270 {
                            phi_429_ = _e227[2];
                        } else {
                            phi_429_ = _e269;
                        }
                        let _e273 = phi_429_;
                        if _e265 {
                            phi_440_ = _e237[0];
                        } else {
                            phi_440_ = _e237[1];
                        }
                        let _e277 = phi_440_;
                        if _e270 {
                            phi_446_ = _e237[2];
                        } else {
                            phi_446_ = _e277;
                        }
                        let _e280 = phi_446_;
                        let _e282 = ((_e280 * _e216) * _e222);
                        let _e286 = (bitcast<f32>((bitcast<u32>(_e282) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e286 {
                            let _e290 = (bitcast<f32>((bitcast<u32>(_e273) & 2147483647u)) * 0.00000011920929f);
                            phi_469_ = select(0.00000000000011368684f, _e290, (_e290 > 0.00000000000011368684f));
                        } else {
                            phi_469_ = 0f;
                        }
                        let _e294 = phi_469_;
                        let _e295 = (_e273 + _e294);
                        let _e296 = (_e273 - _e294);
                        let _e297 = select(_e282, 0f, _e286);
                        if _e286 {
                            phi_480_ = 38685626000000000000000000f;
                        } else {
                            phi_480_ = (1f / _e282);
                        }
                        let _e300 = phi_480_;
                        let _e301 = (_e205 == 0u);
                        if _e301 {
                            phi_489_ = _e227[0];
                        } else {
                            phi_489_ = _e227[1];
                        }
                        let _e305 = phi_489_;
                        let _e306 = (_e205 == 2u);
                        if _e306 {
                            phi_495_ = _e227[2];
                        } else {
                            phi_495_ = _e305;
                        }
                        let _e309 = phi_495_;
                        if _e301 {
                            phi_506_ = _e237[0];
                        } else {
                            phi_506_ = _e237[1];
                        }
                        let _e313 = phi_506_;
                        if _e306 {
                            phi_512_ = _e237[2];
                        } else {
                            phi_512_ = _e313;
                        }
                        let _e316 = phi_512_;
                        let _e318 = ((_e316 * _e216) * _e222);
                        let _e322 = (bitcast<f32>((bitcast<u32>(_e318) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e322 {
                            let _e326 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) * 0.00000011920929f);
                            phi_535_ = select(0.00000000000011368684f, _e326, (_e326 > 0.00000000000011368684f));
                        } else {
                            phi_535_ = 0f;
                        }
                        let _e330 = phi_535_;
                        let _e331 = (_e309 + _e330);
                        let _e332 = (_e309 - _e330);
                        let _e333 = select(_e318, 0f, _e322);
                        if _e322 {
                            phi_546_ = 38685626000000000000000000f;
                        } else {
                            phi_546_ = (1f / _e318);
                        }
                        let _e336 = phi_546_;
                        let _e339 = bitcast<f32>((bitcast<u32>(_e236) & 2147483647u));
                        let _e342 = bitcast<f32>((bitcast<u32>(_e273) & 2147483647u));
                        let _e344 = select(_e342, _e339, (_e339 > _e342));
                        let _e347 = bitcast<f32>((bitcast<u32>(_e309) & 2147483647u));
                        if (_e166 && (select(_e347, _e344, (_e344 > _e347)) <= 1099511600000f)) {
                            let _e352 = (_e185 / 3i);
                            let _e359 = bitcast<f32>((bitcast<u32>((_e352 + 127i)) << bitcast<u32>(23i)));
                            let _e366 = bitcast<f32>((bitcast<u32>(((_e185 - (2i * _e352)) + 127i)) << bitcast<u32>(23i)));
                            let _e367 = (((_e150 * _e359) * _e359) * _e366);
                            let _e369 = select(340282350000000000000000000000000000000f, _e367, (_e367 < 340282350000000000000000000000000000000f));
                            let _e374 = (((_e160 * _e359) * _e359) * _e366);
                            let _e376 = select(340282350000000000000000000000000000000f, _e374, (_e374 < 340282350000000000000000000000000000000f));
                            phi_646_ = select(-340282350000000000000000000000000000000f, _e376, (_e376 > -340282350000000000000000000000000000000f));
                            phi_647_ = select(-340282350000000000000000000000000000000f, _e369, (_e369 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_646_ = 0f;
                            phi_647_ = 1f;
                        }
                        let _e380 = phi_646_;
                        let _e382 = phi_647_;
                        if _e81 {
                        } else {
                            break;
                        }
                        let _e388 = global_3.member[_e80].member_2;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2150_ = false;
                        phi_667_ = type_48(type_42(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e380), 0u, 0u);
                        phi_670_ = select(0u, 2147483648u, (_e66 == 0u));
                        phi_672_ = ((3u * _e66) + 1u);
                        phi_674_ = (_e382 <= _e380);
                        phi_676_ = 0u;
                        loop {
                            let _e395 = phi_2150_;
                            let _e397 = phi_667_;
                            let _e399 = phi_670_;
                            let _e401 = phi_672_;
                            let _e403 = phi_674_;
                            let _e405 = phi_676_;
                            local_2 = _e397;
                            local_3 = _e397;
                            if _e403 {
                                phi_687_ = true;
                            } else {
                                phi_687_ = (_e405 > 0u);
                            }
                            let _e408 = phi_687_;
                            if _e408 {
                                let _e409 = (_e401 > 0u);
                                if _e409 {
                                    if _e403 {
                                        phi_719_ = _e399;
                                        phi_720_ = _e403;
                                        phi_721_ = _e405;
                                    } else {
                                        let _e410 = (_e405 - 1u);
                                        let _e411 = (_e410 % 128u);
                                        let _e412 = (_e411 < 128u);
                                        if _e412 {
                                        } else {
                                            phi_2258_ = true;
                                            break;
                                        }
                                        let _e414 = local_1[_e411];
                                        if _e412 {
                                        } else {
                                            phi_2258_ = true;
                                            break;
                                        }
                                        let _e416 = local[_e411];
                                        phi_719_ = _e414;
                                        phi_720_ = (_e416 <= _e397.member.member_1);
                                        phi_721_ = _e410;
                                    }
                                    let _e421 = phi_719_;
                                    let _e423 = phi_720_;
                                    let _e425 = phi_721_;
                                    if _e423 {
                                        if ((_e421 & 2147483648u) != 0u) {
                                            phi_736_ = _e397;
                                            phi_739_ = type_7(0u, ((_e421 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e630 = phi_736_;
                                                let _e632 = phi_739_;
                                                local_4 = _e630;
                                                if (_e632.member < _e632.member_1) {
                                                    phi_740_ = type_7((_e632.member + 1u), _e632.member_1);
                                                    phi_762_ = type_7(1u, _e632.member);
                                                } else {
                                                    phi_740_ = _e632;
                                                    phi_762_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e645 = phi_740_;
                                                let _e647 = phi_762_;
                                                let _e651 = (bitcast<i32>(_e647.member) != 0i);
                                                if _e651 {
                                                    let _e657 = type_48(_e630.member, _e630.member_1, (_e630.member_2 + 1u));
                                                    let _e658 = ((_e421 & 268435455u) + _e647.member_1);
                                                    let _e659 = (_e658 < _e68);
                                                    if _e659 {
                                                        if _e659 {
                                                        } else {
                                                            phi_2144_ = true;
                                                            break;
                                                        }
                                                        let _e663 = global_1.member[_e658].member_1;
                                                        phi_786_ = _e663;
                                                    } else {
                                                        phi_786_ = 4294967295u;
                                                    }
                                                    let _e665 = phi_786_;
                                                    if (_e658 >= _e68) {
                                                        phi_875_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e659 {
                                                        } else {
                                                            phi_2144_ = true;
                                                            break;
                                                        }
                                                        let _e667 = (_e204 % 3u);
                                                        let _e668 = (_e203 % 3u);
                                                        let _e669 = (_e205 % 3u);
                                                        if (_e667 < 9u) {
                                                        } else {
                                                            phi_2144_ = true;
                                                            break;
                                                        }
                                                        let _e675 = global_1.member[_e658].member[_e667];
                                                        if (_e668 < 9u) {
                                                        } else {
                                                            phi_2144_ = true;
                                                            break;
                                                        }
                                                        let _e681 = global_1.member[_e658].member[_e668];
                                                        if (_e669 < 9u) {
                                                        } else {
                                                            phi_2144_ = true;
                                                            break;
                                                        }
                                                        let _e687 = global_1.member[_e658].member[_e669];
                                                        let _e689 = (3u + _e667);
                                                        if (_e689 < 9u) {
                                                        } else {
                                                            phi_2144_ = true;
                                                            break;
                                                        }
                                                        let _e695 = global_1.member[_e658].member[_e689];
                                                        let _e696 = (3u + _e668);
                                                        if (_e696 < 9u) {
                                                        } else {
                                                            phi_2144_ = true;
                                                            break;
                                                        }
                                                        let _e702 = global_1.member[_e658].member[_e696];
                                                        let _e703 = (3u + _e669);
                                                        if (_e703 < 9u) {
                                                        } else {
                                                            phi_2144_ = true;
                                                            break;
                                                        }
                                                        let _e709 = global_1.member[_e658].member[_e703];
                                                        let _e711 = (6u + _e667);
                                                        if (_e711 < 9u) {
                                                        } else {
                                                            phi_2144_ = true;
                                                            break;
                                                        }
                                                        let _e717 = global_1.member[_e658].member[_e711];
                                                        let _e718 = (6u + _e668);
                                                        if (_e718 < 9u) {
                                                        } else {
                                                            phi_2144_ = true;
                                                            break;
                                                        }
                                                        let _e724 = global_1.member[_e658].member[_e718];
                                                        let _e725 = (6u + _e669);
                                                        if (_e725 < 9u) {
                                                        } else {
                                                            phi_2144_ = true;
                                                            break;
                                                        }
                                                        let _e731 = global_1.member[_e658].member[_e725];
                                                        phi_875_ = array<array<f32, 3>, 3>(array<f32, 3>(_e675, _e681, _e687), array<f32, 3>(_e695, _e702, _e709), array<f32, 3>(_e717, _e724, _e731));
                                                    }
                                                    let _e735 = phi_875_;
                                                    let _e744 = (_e735[0][2] - _e309);
                                                    let _e747 = (((_e735[0][0] - _e236) * _e333) - (_e744 * _e261));
                                                    let _e750 = (((_e735[0][1] - _e273) * _e333) - (_e744 * _e297));
                                                    let _e757 = (_e735[1][2] - _e309);
                                                    let _e760 = (((_e735[1][0] - _e236) * _e333) - (_e757 * _e261));
                                                    let _e763 = (((_e735[1][1] - _e273) * _e333) - (_e757 * _e297));
                                                    let _e770 = (_e735[2][2] - _e309);
                                                    let _e773 = (((_e735[2][0] - _e236) * _e333) - (_e770 * _e261));
                                                    let _e776 = (((_e735[2][1] - _e273) * _e333) - (_e770 * _e297));
                                                    let _e777 = (_e773 * _e763);
                                                    let _e778 = (_e776 * _e760);
                                                    let _e779 = (_e747 * _e776);
                                                    let _e780 = (_e750 * _e773);
                                                    let _e781 = (_e760 * _e750);
                                                    let _e782 = (_e763 * _e747);
                                                    let _e787 = (((_e777 >= _e778) && (_e779 >= _e780)) && (_e781 >= _e782));
                                                    if (_e787 || (((_e777 <= _e778) && (_e779 <= _e780)) && (_e781 <= _e782))) {
                                                        let _e794 = select(-1f, 1f, _e787);
                                                        let _e796 = ((_e777 - _e778) * _e794);
                                                        let _e798 = select(0f, _e796, (_e796 > 0f));
                                                        let _e800 = ((_e779 - _e780) * _e794);
                                                        let _e802 = select(0f, _e800, (_e800 > 0f));
                                                        let _e804 = ((_e781 - _e782) * _e794);
                                                        let _e806 = select(0f, _e804, (_e804 > 0f));
                                                        let _e808 = ((_e798 + _e802) + _e806);
                                                        if (_e808 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1441_ = type_22();
                                                            phi_1442_ = true;
                                                        } else {
                                                            let _e811 = select(_e735[1][0], _e735[0][0], (_e735[0][0] < _e735[1][0]));
                                                            let _e815 = select(_e735[1][0], _e735[0][0], (_e735[0][0] > _e735[1][0]));
                                                            let _e819 = select(_e735[1][1], _e735[0][1], (_e735[0][1] < _e735[1][1]));
                                                            let _e823 = select(_e735[1][1], _e735[0][1], (_e735[0][1] > _e735[1][1]));
                                                            let _e827 = select(_e735[1][2], _e735[0][2], (_e735[0][2] < _e735[1][2]));
                                                            let _e831 = select(_e735[1][2], _e735[0][2], (_e735[0][2] > _e735[1][2]));
                                                            let _e836 = ((select(_e735[2][0], _e811, (_e811 < _e735[2][0])) - _e259) * _e264);
                                                            let _e837 = ((select(_e735[2][0], _e815, (_e815 > _e735[2][0])) - _e260) * _e264);
                                                            let _e840 = ((select(_e735[2][1], _e819, (_e819 < _e735[2][1])) - _e295) * _e300);
                                                            let _e841 = ((select(_e735[2][1], _e823, (_e823 > _e735[2][1])) - _e296) * _e300);
                                                            let _e844 = ((select(_e735[2][2], _e827, (_e827 < _e735[2][2])) - _e331) * _e336);
                                                            let _e845 = ((select(_e735[2][2], _e831, (_e831 > _e735[2][2])) - _e332) * _e336);
                                                            let _e847 = select(_e845, _e844, (_e844 < _e845));
                                                            let _e849 = select(_e845, _e844, (_e844 > _e845));
                                                            let _e851 = select(_e837, _e836, (_e836 < _e837));
                                                            let _e853 = select(_e841, _e840, (_e840 < _e841));
                                                            let _e855 = select(_e853, _e851, (_e851 > _e853));
                                                            let _e857 = select(_e847, _e855, (_e855 > _e847));
                                                            let _e859 = select(_e837, _e836, (_e836 > _e837));
                                                            let _e861 = select(_e841, _e840, (_e840 > _e841));
                                                            let _e863 = select(_e861, _e859, (_e859 < _e861));
                                                            let _e865 = select(_e849, _e863, (_e863 < _e849));
                                                            let _e866 = -(_e847);
                                                            let _e872 = select(_e382, _e857, (_e857 > _e382));
                                                            if (_e872 > (_e865 + (select(_e866, _e849, (_e849 > _e866)) * 0.0000019073523f))) {
                                                                phi_1436_ = type_22();
                                                                phi_1437_ = true;
                                                            } else {
                                                                let _e874 = (_e872 > _e630.member.member_1);
                                                                if _e874 {
                                                                    phi_1435_ = type_22();
                                                                } else {
                                                                    let _e878 = (_e735[1][0] - _e735[0][0]);
                                                                    let _e879 = (_e735[1][1] - _e735[0][1]);
                                                                    let _e880 = (_e735[1][2] - _e735[0][2]);
                                                                    let _e881 = vec3<f32>(_e878, _e879, _e880);
                                                                    let _e882 = (_e735[2][0] - _e735[1][0]);
                                                                    let _e883 = (_e735[2][1] - _e735[1][1]);
                                                                    let _e884 = (_e735[2][2] - _e735[1][2]);
                                                                    let _e885 = vec3<f32>(_e882, _e883, _e884);
                                                                    let _e886 = (_e735[0][0] - _e735[2][0]);
                                                                    let _e887 = (_e735[0][1] - _e735[2][1]);
                                                                    let _e888 = (_e735[0][2] - _e735[2][2]);
                                                                    let _e889 = vec3<f32>(_e886, _e887, _e888);
                                                                    let _e892 = bitcast<f32>((bitcast<u32>(_e878) & 2147483647u));
                                                                    let _e895 = bitcast<f32>((bitcast<u32>(_e879) & 2147483647u));
                                                                    let _e897 = select(_e895, _e892, (_e892 > _e895));
                                                                    let _e900 = bitcast<f32>((bitcast<u32>(_e880) & 2147483647u));
                                                                    let _e902 = select(_e900, _e897, (_e897 > _e900));
                                                                    let _e905 = bitcast<f32>((bitcast<u32>(_e882) & 2147483647u));
                                                                    let _e908 = bitcast<f32>((bitcast<u32>(_e883) & 2147483647u));
                                                                    let _e910 = select(_e908, _e905, (_e905 > _e908));
                                                                    let _e913 = bitcast<f32>((bitcast<u32>(_e884) & 2147483647u));
                                                                    let _e915 = select(_e913, _e910, (_e910 > _e913));
                                                                    let _e918 = bitcast<f32>((bitcast<u32>(_e886) & 2147483647u));
                                                                    let _e921 = bitcast<f32>((bitcast<u32>(_e887) & 2147483647u));
                                                                    let _e923 = select(_e921, _e918, (_e918 > _e921));
                                                                    let _e926 = bitcast<f32>((bitcast<u32>(_e888) & 2147483647u));
                                                                    let _e928 = select(_e926, _e923, (_e923 > _e926));
                                                                    let _e930 = select(_e915, _e902, (_e902 > _e915));
                                                                    let _e932 = select(_e928, _e930, (_e930 > _e928));
                                                                    if (_e902 == _e932) {
                                                                        phi_1346_ = _e885;
                                                                        phi_1347_ = _e889;
                                                                    } else {
                                                                        let _e935 = vec3((_e915 == _e932));
                                                                        phi_1346_ = select(_e881, _e889, _e935);
                                                                        phi_1347_ = select(_e885, _e881, _e935);
                                                                    }
                                                                    let _e939 = phi_1346_;
                                                                    let _e941 = phi_1347_;
                                                                    let _e948 = ((_e939.y * _e941.z) - (_e941.y * _e939.z));
                                                                    let _e953 = ((_e939.z * _e941.x) - (_e941.z * _e939.x));
                                                                    let _e956 = ((_e939.x * _e941.y) - (_e941.x * _e939.y));
                                                                    if (_e798 >= _e802) {
                                                                        phi_1378_ = select(true, false, (_e798 >= _e806));
                                                                    } else {
                                                                        phi_1378_ = true;
                                                                    }
                                                                    let _e961 = phi_1378_;
                                                                    if _e961 {
                                                                        phi_1387_ = select(vec3<f32>(_e735[2][0], _e735[2][1], _e735[2][2]), vec3<f32>(_e735[1][0], _e735[1][1], _e735[1][2]), vec3((_e802 >= _e806)));
                                                                    } else {
                                                                        phi_1387_ = vec3<f32>(_e735[0][0], _e735[0][1], _e735[0][2]);
                                                                    }
                                                                    let _e966 = phi_1387_;
                                                                    let _e983 = ((((_e948 * (_e966.x - _e236)) + (_e953 * (_e966.y - _e273))) + (_e956 * (_e966.z - _e309))) / (((_e948 * _e261) + (_e953 * _e297)) + (_e956 * _e333)));
                                                                    let _e985 = select(_e865, _e983, (_e983 < _e865));
                                                                    let _e987 = select(_e857, _e985, (_e985 > _e857));
                                                                    if (_e987 >= _e382) {
                                                                        let _e989 = (_e987 <= _e630.member.member_1);
                                                                        if _e989 {
                                                                            let _e990 = (1f / _e808);
                                                                            phi_1427_ = type_22(_e987, (_e802 * _e990), (_e806 * _e990), _e665);
                                                                        } else {
                                                                            phi_1427_ = type_22();
                                                                        }
                                                                        let _e995 = phi_1427_;
                                                                        phi_1429_ = _e995;
                                                                        phi_1430_ = select(true, false, _e989);
                                                                    } else {
                                                                        phi_1429_ = type_22();
                                                                        phi_1430_ = true;
                                                                    }
                                                                    let _e998 = phi_1429_;
                                                                    let _e1000 = phi_1430_;
                                                                    if _e1000 {
                                                                        phi_1434_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1434_ = _e998;
                                                                    }
                                                                    let _e1002 = phi_1434_;
                                                                    phi_1435_ = _e1002;
                                                                }
                                                                let _e1004 = phi_1435_;
                                                                phi_1436_ = _e1004;
                                                                phi_1437_ = _e874;
                                                            }
                                                            let _e1006 = phi_1436_;
                                                            let _e1008 = phi_1437_;
                                                            phi_1441_ = _e1006;
                                                            phi_1442_ = _e1008;
                                                        }
                                                        let _e1010 = phi_1441_;
                                                        let _e1012 = phi_1442_;
                                                        phi_1446_ = _e1010;
                                                        phi_1447_ = _e1012;
                                                    } else {
                                                        phi_1446_ = type_22();
                                                        phi_1447_ = true;
                                                    }
                                                    let _e1014 = phi_1446_;
                                                    let _e1016 = phi_1447_;
                                                    if _e1016 {
                                                        phi_1451_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1451_ = _e1014;
                                                    }
                                                    let _e1018 = phi_1451_;
                                                    if (_e1018.member_3 != 4294967295u) {
                                                        if (_e665 != _e388) {
                                                            if (_e1018.member < _e630.member.member.member) {
                                                                phi_1477_ = true;
                                                            } else {
                                                                if (_e1018.member == _e630.member.member.member) {
                                                                    phi_1476_ = (_e1018.member_3 < _e630.member.member.member_3);
                                                                } else {
                                                                    phi_1476_ = false;
                                                                }
                                                                let _e1033 = phi_1476_;
                                                                phi_1477_ = _e1033;
                                                            }
                                                            let _e1035 = phi_1477_;
                                                            if _e1035 {
                                                                phi_1484_ = type_48(type_42(_e1018, _e1018.member), _e657.member_1, _e657.member_2);
                                                            } else {
                                                                phi_1484_ = _e657;
                                                            }
                                                            let _e1042 = phi_1484_;
                                                            phi_1485_ = _e1042;
                                                        } else {
                                                            phi_1485_ = _e657;
                                                        }
                                                        let _e1044 = phi_1485_;
                                                        phi_1486_ = _e1044;
                                                    } else {
                                                        phi_1486_ = _e657;
                                                    }
                                                    let _e1046 = phi_1486_;
                                                    phi_737_ = _e1046;
                                                } else {
                                                    phi_737_ = type_48();
                                                }
                                                let _e1048 = phi_737_;
                                                continue;
                                                continuing {
                                                    phi_736_ = _e1048;
                                                    phi_739_ = _e645;
                                                    phi_2144_ = _e395;
                                                    break if !(_e651);
                                                }
                                            }
                                            let _e1051 = phi_2144_;
                                            phi_2258_ = _e1051;
                                            if _e1051 {
                                                break;
                                            }
                                            phi_2262_ = _e1051;
                                            let _e1261 = local_4;
                                            phi_1944_ = _e1261;
                                            phi_1945_ = _e421;
                                            phi_1946_ = false;
                                            phi_1947_ = _e425;
                                        } else {
                                            if (_e421 >= _e66) {
                                                phi_1549_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e421 < _e66) {
                                                } else {
                                                    phi_2258_ = true;
                                                    break;
                                                }
                                                let _e441 = (_e204 % 3u);
                                                if (_e441 < 3u) {
                                                } else {
                                                    phi_2258_ = true;
                                                    break;
                                                }
                                                let _e447 = global_2.member[_e421].member[_e441];
                                                let _e453 = (_e203 % 3u);
                                                if (_e453 < 3u) {
                                                } else {
                                                    phi_2258_ = true;
                                                    break;
                                                }
                                                let _e459 = global_2.member[_e421].member[_e453];
                                                let _e465 = (_e205 % 3u);
                                                if (_e465 < 3u) {
                                                } else {
                                                    phi_2258_ = true;
                                                    break;
                                                }
                                                let _e471 = global_2.member[_e421].member[_e465];
                                                let _e481 = global_2.member[_e421].member_1;
                                                let _e485 = global_2.member[_e421].member_2;
                                                phi_1549_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e447[0], _e447[1], _e447[2], _e447[3]), vec4<f32>(_e459[0], _e459[1], _e459[2], _e459[3]), vec4<f32>(_e471[0], _e471[1], _e471[2], _e471[3])), _e481, _e485);
                                            }
                                            let _e488 = phi_1549_;
                                            let _e501 = ((_e488.member[0].x - _e259) * _e264);
                                            let _e502 = ((_e488.member[0].y - _e259) * _e264);
                                            let _e503 = ((_e488.member[0].z - _e260) * _e264);
                                            let _e504 = ((_e488.member[0].w - _e260) * _e264);
                                            let _e514 = ((_e488.member[1].x - _e295) * _e300);
                                            let _e515 = ((_e488.member[1].y - _e295) * _e300);
                                            let _e516 = ((_e488.member[1].z - _e296) * _e300);
                                            let _e517 = ((_e488.member[1].w - _e296) * _e300);
                                            let _e527 = ((_e488.member[2].x - _e331) * _e336);
                                            let _e528 = ((_e488.member[2].y - _e331) * _e336);
                                            let _e529 = ((_e488.member[2].z - _e332) * _e336);
                                            let _e530 = ((_e488.member[2].w - _e332) * _e336);
                                            let _e532 = select(_e529, _e527, (_e527 < _e529));
                                            let _e534 = select(_e530, _e528, (_e528 < _e530));
                                            let _e536 = select(_e529, _e527, (_e527 > _e529));
                                            let _e538 = select(_e530, _e528, (_e528 > _e530));
                                            let _e540 = select(_e503, _e501, (_e501 < _e503));
                                            let _e542 = select(_e504, _e502, (_e502 < _e504));
                                            let _e544 = select(_e516, _e514, (_e514 < _e516));
                                            let _e546 = select(_e517, _e515, (_e515 < _e517));
                                            let _e548 = select(_e544, _e540, (_e540 > _e544));
                                            let _e550 = select(_e546, _e542, (_e542 > _e546));
                                            let _e552 = select(_e532, _e548, (_e548 > _e532));
                                            let _e554 = select(_e534, _e550, (_e550 > _e534));
                                            let _e556 = select(_e503, _e501, (_e501 > _e503));
                                            let _e558 = select(_e504, _e502, (_e502 > _e504));
                                            let _e560 = select(_e516, _e514, (_e514 > _e516));
                                            let _e562 = select(_e517, _e515, (_e515 > _e517));
                                            let _e564 = select(_e560, _e556, (_e556 < _e560));
                                            let _e566 = select(_e562, _e558, (_e558 < _e562));
                                            let _e571 = -(_e532);
                                            let _e572 = -(_e534);
                                            let _e579 = (select(_e536, _e564, (_e564 < _e536)) + (select(_e571, _e536, (_e536 > _e571)) * 0.0000019073523f));
                                            let _e580 = (select(_e538, _e566, (_e566 < _e538)) + (select(_e572, _e538, (_e538 > _e572)) * 0.0000019073523f));
                                            let _e582 = select(_e382, _e552, (_e552 > _e382));
                                            let _e584 = select(_e382, _e554, (_e554 > _e382));
                                            let _e589 = (_e582 <= select(_e397.member.member_1, _e579, (_e579 < _e397.member.member_1)));
                                            let _e590 = (_e584 <= select(_e397.member.member_1, _e580, (_e580 < _e397.member.member_1)));
                                            let _e591 = (_e582 <= _e584);
                                            if _e589 {
                                                if _e590 {
                                                    if _e591 {
                                                        phi_1893_ = _e488.member_2;
                                                    } else {
                                                        phi_1893_ = _e488.member_1;
                                                    }
                                                    let _e595 = phi_1893_;
                                                    let _e598 = (_e425 % 128u);
                                                    let _e599 = (_e598 < 128u);
                                                    if _e599 {
                                                    } else {
                                                        phi_2258_ = true;
                                                        break;
                                                    }
                                                    local_1[_e598] = _e595;
                                                    if _e599 {
                                                    } else {
                                                        phi_2258_ = true;
                                                        break;
                                                    }
                                                    local[_e598] = select(_e584, _e582, (_e582 > _e584));
                                                    if _e591 {
                                                        phi_1921_ = _e488.member_1;
                                                    } else {
                                                        phi_1921_ = _e488.member_2;
                                                    }
                                                    let _e606 = phi_1921_;
                                                    phi_1922_ = _e606;
                                                    phi_1923_ = (_e425 + 1u);
                                                } else {
                                                    phi_1922_ = u32();
                                                    phi_1923_ = u32();
                                                }
                                                let _e608 = phi_1922_;
                                                let _e610 = phi_1923_;
                                                phi_1925_ = _e608;
                                                phi_1926_ = _e610;
                                                phi_1927_ = select(true, false, _e590);
                                            } else {
                                                phi_1925_ = u32();
                                                phi_1926_ = u32();
                                                phi_1927_ = true;
                                            }
                                            let _e613 = phi_1925_;
                                            let _e615 = phi_1926_;
                                            let _e617 = phi_1927_;
                                            if _e617 {
                                                if _e589 {
                                                    phi_1936_ = _e488.member_1;
                                                } else {
                                                    phi_1936_ = _e488.member_2;
                                                }
                                                let _e621 = phi_1936_;
                                                phi_1941_ = _e621;
                                                phi_1942_ = select(_e590, true, _e589);
                                            } else {
                                                phi_1941_ = _e613;
                                                phi_1942_ = _e423;
                                            }
                                            let _e624 = phi_1941_;
                                            let _e626 = phi_1942_;
                                            phi_2262_ = _e395;
                                            phi_1944_ = type_48(_e397.member, (_e397.member_1 + 1u), _e397.member_2);
                                            phi_1945_ = _e624;
                                            phi_1946_ = _e626;
                                            phi_1947_ = select(_e615, _e425, _e617);
                                        }
                                        let _e1053 = phi_2262_;
                                        let _e1055 = phi_1944_;
                                        let _e1057 = phi_1945_;
                                        let _e1059 = phi_1946_;
                                        let _e1061 = phi_1947_;
                                        phi_2261_ = _e1053;
                                        phi_1948_ = _e1055;
                                        phi_1949_ = _e1057;
                                        phi_1950_ = (_e401 - 1u);
                                        phi_1951_ = _e1059;
                                        phi_1952_ = _e1061;
                                    } else {
                                        phi_2261_ = _e395;
                                        phi_1948_ = _e397;
                                        phi_1949_ = _e421;
                                        phi_1950_ = _e401;
                                        phi_1951_ = _e423;
                                        phi_1952_ = _e425;
                                    }
                                    let _e1063 = phi_2261_;
                                    let _e1065 = phi_1948_;
                                    let _e1067 = phi_1949_;
                                    let _e1069 = phi_1950_;
                                    let _e1071 = phi_1951_;
                                    let _e1073 = phi_1952_;
                                    phi_2260_ = _e1063;
                                    phi_1953_ = _e1065;
                                    phi_1954_ = _e1067;
                                    phi_1955_ = _e1069;
                                    phi_1956_ = _e1071;
                                    phi_1957_ = _e1073;
                                } else {
                                    phi_2260_ = _e395;
                                    phi_1953_ = type_48();
                                    phi_1954_ = u32();
                                    phi_1955_ = u32();
                                    phi_1956_ = bool();
                                    phi_1957_ = u32();
                                }
                                let _e1075 = phi_2260_;
                                let _e1077 = phi_1953_;
                                let _e1079 = phi_1954_;
                                let _e1081 = phi_1955_;
                                let _e1083 = phi_1956_;
                                let _e1085 = phi_1957_;
                                phi_2259_ = _e1075;
                                phi_668_ = _e1077;
                                phi_671_ = _e1079;
                                phi_673_ = _e1081;
                                phi_675_ = _e1083;
                                phi_677_ = _e1085;
                                phi_1958_ = _e409;
                            } else {
                                phi_2259_ = _e395;
                                phi_668_ = type_48();
                                phi_671_ = u32();
                                phi_673_ = u32();
                                phi_675_ = bool();
                                phi_677_ = u32();
                                phi_1958_ = false;
                            }
                            let _e1087 = phi_2259_;
                            let _e1089 = phi_668_;
                            let _e1091 = phi_671_;
                            let _e1093 = phi_673_;
                            let _e1095 = phi_675_;
                            let _e1097 = phi_677_;
                            let _e1099 = phi_1958_;
                            continue;
                            continuing {
                                phi_2150_ = _e1087;
                                phi_667_ = _e1089;
                                phi_670_ = _e1091;
                                phi_672_ = _e1093;
                                phi_674_ = _e1095;
                                phi_676_ = _e1097;
                                phi_2258_ = _e1087;
                                break if !(_e1099);
                            }
                        }
                        let _e1102 = phi_2258_;
                        if _e1102 {
                            break;
                        }
                        let _e1104 = local_2;
                        if (_e1104.member.member.member_3 != 4294967295u) {
                            let _e1110 = (_e206 / 3i);
                            let _e1117 = bitcast<f32>((bitcast<u32>((_e1110 + 127i)) << bitcast<u32>(23i)));
                            let _e1125 = (((_e1104.member.member.member * _e1117) * _e1117) * bitcast<f32>((bitcast<u32>(((_e206 - (2i * _e1110)) + 127i)) << bitcast<u32>(23i))));
                            let _e1127 = select(340282350000000000000000000000000000000f, _e1125, (_e1125 < 340282350000000000000000000000000000000f));
                            phi_2010_ = type_22(select(-340282350000000000000000000000000000000f, _e1127, (_e1127 > -340282350000000000000000000000000000000f)), _e1104.member.member.member_1, _e1104.member.member.member_2, _e1104.member.member.member_3);
                        } else {
                            phi_2010_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1134 = phi_2010_;
                        if _e82 {
                        } else {
                            break;
                        }
                        global_4.member[_e80] = _e1134;
                        let _e1138 = local_3;
                        if _e83 {
                        } else {
                            break;
                        }
                        global_5.member[_e80] = _e1138.member_1;
                        if _e81 {
                        } else {
                            break;
                        }
                        let _e1143 = select(0u, 1u, (_e150 <= _e160));
                        if (_e1143 > 0u) {
                            let _e1145 = (1u < _e76);
                            if _e1145 {
                                if (0u < _e76) {
                                } else {
                                    break;
                                }
                                let _e1149 = atomicAdd((&global_6.member[0u]), _e1143);
                                if ((_e1149 + _e1143) < _e1149) {
                                    if _e1145 {
                                    } else {
                                        break;
                                    }
                                    let _e1154 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1157 = select(0u, 1u, (_e1134.member_3 != 4294967295u));
                        if (_e1157 > 0u) {
                            let _e1159 = (3u < _e76);
                            if _e1159 {
                                if (2u < _e76) {
                                } else {
                                    break;
                                }
                                let _e1163 = atomicAdd((&global_6.member[2u]), _e1157);
                                if ((_e1163 + _e1157) < _e1163) {
                                    if _e1159 {
                                    } else {
                                        break;
                                    }
                                    let _e1168 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1138.member_1 > 0u) {
                            let _e1170 = (5u < _e76);
                            if _e1170 {
                                if (4u < _e76) {
                                } else {
                                    break;
                                }
                                let _e1174 = atomicAdd((&global_6.member[4u]), _e1138.member_1);
                                if ((_e1174 + _e1138.member_1) < _e1174) {
                                    if _e1170 {
                                    } else {
                                        break;
                                    }
                                    let _e1179 = atomicAdd((&global_6.member[5u]), 1u);
                                }
                            }
                        }
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
