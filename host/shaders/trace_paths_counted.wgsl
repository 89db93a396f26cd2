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

struct type_46 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_47 {
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
    var phi_277_: i32;
    var phi_278_: i32;
    var phi_288_: bool;
    var phi_298_: u32;
    var phi_299_: u32;
    var phi_301_: bool;
    var phi_306_: u32;
    var phi_338_: i32;
    var phi_356_: f32;
    var phi_362_: f32;
    var phi_373_: f32;
    var phi_379_: f32;
    var phi_402_: f32;
    var phi_413_: f32;
    var phi_422_: f32;
    var phi_428_: f32;
    var phi_439_: f32;
    var phi_445_: f32;
    var phi_468_: f32;
    var phi_479_: f32;
    var phi_488_: f32;
    var phi_494_: f32;
    var phi_505_: f32;
    var phi_511_: f32;
    var phi_534_: f32;
    var phi_545_: f32;
    var phi_645_: f32;
    var phi_646_: f32;
    var phi_2413_: bool;
    var phi_929_: type_47;
    var phi_932_: u32;
    var phi_934_: u32;
    var phi_936_: bool;
    var phi_938_: u32;
    var phi_949_: bool;
    var phi_980_: u32;
    var phi_981_: bool;
    var phi_982_: u32;
    var phi_1810_: type_46;
    var phi_2154_: u32;
    var phi_2181_: u32;
    var phi_2182_: u32;
    var phi_2183_: u32;
    var phi_2185_: u32;
    var phi_2186_: u32;
    var phi_2187_: bool;
    var phi_2196_: u32;
    var phi_2201_: u32;
    var phi_2202_: bool;
    var phi_997_: type_47;
    var phi_1000_: type_7;
    var phi_1001_: type_7;
    var phi_1023_: type_7;
    var phi_1047_: u32;
    var phi_1136_: array<array<f32, 3>, 3>;
    var phi_1607_: vec3<f32>;
    var phi_1608_: vec3<f32>;
    var phi_1639_: bool;
    var phi_1648_: vec3<f32>;
    var phi_1688_: type_22;
    var phi_1690_: type_22;
    var phi_1691_: bool;
    var phi_1695_: type_22;
    var phi_1696_: type_22;
    var phi_1697_: type_22;
    var phi_1698_: bool;
    var phi_1702_: type_22;
    var phi_1703_: bool;
    var phi_1707_: type_22;
    var phi_1708_: bool;
    var phi_1712_: type_22;
    var phi_1737_: bool;
    var phi_1738_: bool;
    var phi_1745_: type_47;
    var phi_1746_: type_47;
    var phi_1747_: type_47;
    var phi_998_: type_47;
    var phi_2407_: bool;
    var phi_2525_: bool;
    var phi_2204_: type_47;
    var phi_2205_: u32;
    var phi_2206_: bool;
    var phi_2207_: u32;
    var phi_2524_: bool;
    var phi_2208_: type_47;
    var phi_2209_: u32;
    var phi_2210_: u32;
    var phi_2211_: bool;
    var phi_2212_: u32;
    var phi_2523_: bool;
    var phi_2213_: type_47;
    var phi_2214_: u32;
    var phi_2215_: u32;
    var phi_2216_: bool;
    var phi_2217_: u32;
    var phi_2522_: bool;
    var phi_930_: type_47;
    var phi_933_: u32;
    var phi_935_: u32;
    var phi_937_: bool;
    var phi_939_: u32;
    var phi_2218_: bool;
    var phi_2521_: bool;
    var local_2: type_47;
    var phi_2270_: type_22;
    var local_3: type_47;
    var local_4: type_47;

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
                                phi_277_ = (bitcast<i32>((_e169 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_277_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e169)), 32u, (_e169 == 0u))));
                            }
                            let _e183 = phi_277_;
                            phi_278_ = _e183;
                        } else {
                            phi_278_ = 0i;
                        }
                        let _e185 = phi_278_;
                        let _e186 = (_e95 == _e139);
                        if _e186 {
                            phi_288_ = true;
                        } else {
                            phi_288_ = (_e103 == _e139);
                        }
                        let _e189 = phi_288_;
                        let _e190 = select(1u, 0u, _e186);
                        if _e189 {
                            let _e191 = (_e190 + 1u);
                            phi_298_ = _e191;
                            phi_299_ = _e191;
                            phi_301_ = select(true, false, (_e191 == 2u));
                        } else {
                            phi_298_ = u32();
                            phi_299_ = 0u;
                            phi_301_ = true;
                        }
                        let _e195 = phi_298_;
                        let _e197 = phi_299_;
                        let _e199 = phi_301_;
                        if _e199 {
                            phi_306_ = (_e197 + 1u);
                        } else {
                            phi_306_ = 0u;
                        }
                        let _e203 = phi_306_;
                        let _e204 = select(_e195, _e197, _e199);
                        let _e205 = select(_e190, select(2u, _e190, _e189), _e199);
                        let _e206 = -(_e185);
                        if (_e206 < -126i) {
                            phi_338_ = -126i;
                        } else {
                            phi_338_ = select(_e206, 127i, (_e206 > 127i));
                        }
                        let _e211 = phi_338_;
                        let _e216 = bitcast<f32>((bitcast<u32>((_e211 + 127i)) << bitcast<u32>(23i)));
                        let _e222 = bitcast<f32>((bitcast<u32>(((_e206 - _e211) + 127i)) << bitcast<u32>(23i)));
                        let _e227 = global_3.member[_e80].member.member;
                        let _e228 = (_e204 == 0u);
                        if _e228 {
                            phi_356_ = _e227[0];
                        } else {
                            phi_356_ = _e227[1];
                        }
                        let _e232 = phi_356_;
                        let _e233 = (_e204 == 2u);
                        if _e233 {
                            phi_362_ = _e227[2];
                        } else {
                            phi_362_ = _e232;
                        }
                        let _e236 = phi_362_;
                        let _e237 = global_3.member[_e80].member.member_2;
                        if _e228 {
                            phi_373_ = _e237[0];
                        } else {
                            phi_373_ = _e237[1];
                        }
                        let _e241 = phi_373_;
                        if _e233 {
                            phi_379_ = _e237[2];
                        } else {
                            phi_379_ = _e241;
                        }
                        let _e244 = phi_379_;
                        let _e246 = ((_e244 * _e216) * _e222);
                        let _e250 = (bitcast<f32>((bitcast<u32>(_e246) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e250 {
                            let _e254 = (bitcast<f32>((bitcast<u32>(_e236) & 2147483647u)) * 0.00000011920929f);
                            phi_402_ = select(0.00000000000011368684f, _e254, (_e254 > 0.00000000000011368684f));
                        } else {
                            phi_402_ = 0f;
                        }
                        let _e258 = phi_402_;
                        let _e259 = (_e236 + _e258);
                        let _e260 = (_e236 - _e258);
                        let _e261 = select(_e246, 0f, _e250);
                        if _e250 {
                            phi_413_ = 38685626000000000000000000f;
                        } else {
                            phi_413_ = (1f / _e246);
                        }
                        let _e264 = phi_413_;
                        let _e265 = (_e203 == 0u);
                        if _e265 {
                            phi_422_ = _e227[0];
                        } else {
                            phi_422_ = _e227[1];
                        }
                        let _e269 = phi_422_;
                        let _e270 = (_e203 == 2u);
                        if _e270 {
                            phi_428_ = _e227[2];
                        } else {
                            phi_428_ = _e269;
                        }
                        let _e273 = phi_428_;
                        if _e265 {
                            phi_439_ = _e237[0];
                        } else {
                            phi_439_ = _e237[1];
                        }
                        let _e277 = phi_439_;
                        if _e270 {
                            phi_445_ = _e237[2];
                        } else {
                            phi_445_ = _e277;
                        }
                        let _e280 = phi_445_;
                        let _e282 = ((_e280 * _e216) * _e222);
                        let _e286 = (bitcast<f32>((bitcast<u32>(_e282) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e286 {
                            let _e290 = (bitcast<f32>((bitcast<u32>(_e273) & 2147483647u)) * 0.00000011920929f);
                            phi_468_ = select(0.00000000000011368684f, _e290, (_e290 > 0.00000000000011368684f));
                        } else {
                            phi_468_ = 0f;
                        }
                        let _e294 = phi_468_;
                        let _e295 = (_e273 + _e294);
                        let _e296 = (_e273 - _e294);
                        let _e297 = select(_e282, 0f, _e286);
                        if _e286 {
                            phi_479_ = 38685626000000000000000000f;
                        } else {
                            phi_479_ = (1f / _e282);
                        }
                        let _e300 = phi_479_;
                        let _e301 = (_e205 == 0u);
                        if _e301 {
                            phi_488_ = _e227[0];
                        } else {
                            phi_488_ = _e227[1];
                        }
                        let _e305 = phi_488_;
                        let _e306 = (_e205 == 2u);
                        if _e306 {
                            phi_494_ = _e227[2];
                        } else {
                            phi_494_ = _e305;
                        }
                        let _e309 = phi_494_;
                        if _e301 {
                            phi_505_ = _e237[0];
                        } else {
                            phi_505_ = _e237[1];
                        }
                        let _e313 = phi_505_;
                        if _e306 {
                            phi_511_ = _e237[2];
                        } else {
                            phi_511_ = _e313;
                        }
                        let _e316 = phi_511_;
                        let _e318 = ((_e316 * _e216) * _e222);
                        let _e322 = (bitcast<f32>((bitcast<u32>(_e318) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e322 {
                            let _e326 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) * 0.00000011920929f);
                            phi_534_ = select(0.00000000000011368684f, _e326, (_e326 > 0.00000000000011368684f));
                        } else {
                            phi_534_ = 0f;
                        }
                        let _e330 = phi_534_;
                        let _e331 = (_e309 + _e330);
                        let _e332 = (_e309 - _e330);
                        let _e333 = select(_e318, 0f, _e322);
                        if _e322 {
                            phi_545_ = 38685626000000000000000000f;
                        } else {
                            phi_545_ = (1f / _e318);
                        }
                        let _e336 = phi_545_;
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
                            phi_645_ = select(-340282350000000000000000000000000000000f, _e376, (_e376 > -340282350000000000000000000000000000000f));
                            phi_646_ = select(-340282350000000000000000000000000000000f, _e369, (_e369 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_645_ = 0f;
                            phi_646_ = 1f;
                        }
                        let _e380 = phi_645_;
                        let _e382 = phi_646_;
                        if _e81 {
                        } else {
                            break;
                        }
                        let _e388 = global_3.member[_e80].member_2;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2413_ = false;
                        phi_929_ = type_47(type_42(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e380), 0u, 0u);
                        phi_932_ = select(0u, 2147483648u, (_e66 == 0u));
                        phi_934_ = ((3u * _e66) + 1u);
                        phi_936_ = (_e382 <= _e380);
                        phi_938_ = 0u;
                        loop {
                            let _e395 = phi_2413_;
                            let _e397 = phi_929_;
                            let _e399 = phi_932_;
                            let _e401 = phi_934_;
                            let _e403 = phi_936_;
                            let _e405 = phi_938_;
                            local_2 = _e397;
                            local_3 = _e397;
                            if _e403 {
                                phi_949_ = true;
                            } else {
                                phi_949_ = (_e405 > 0u);
                            }
                            let _e408 = phi_949_;
                            if _e408 {
                                let _e409 = (_e401 > 0u);
                                if _e409 {
                                    if _e403 {
                                        phi_980_ = _e399;
                                        phi_981_ = _e403;
                                        phi_982_ = _e405;
                                    } else {
                                        let _e410 = (_e405 - 1u);
                                        let _e411 = (_e410 % 128u);
                                        let _e412 = (_e411 < 128u);
                                        if _e412 {
                                        } else {
                                            phi_2521_ = true;
                                            break;
                                        }
                                        let _e414 = local_1[_e411];
                                        if _e412 {
                                        } else {
                                            phi_2521_ = true;
                                            break;
                                        }
                                        let _e416 = local[_e411];
                                        phi_980_ = _e414;
                                        phi_981_ = (_e416 <= _e397.member.member_1);
                                        phi_982_ = _e410;
                                    }
                                    let _e421 = phi_980_;
                                    let _e423 = phi_981_;
                                    let _e425 = phi_982_;
                                    if _e423 {
                                        if ((_e421 & 2147483648u) != 0u) {
                                            phi_997_ = _e397;
                                            phi_1000_ = type_7(0u, ((_e421 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e630 = phi_997_;
                                                let _e632 = phi_1000_;
                                                local_4 = _e630;
                                                if (_e632.member < _e632.member_1) {
                                                    phi_1001_ = type_7((_e632.member + 1u), _e632.member_1);
                                                    phi_1023_ = type_7(1u, _e632.member);
                                                } else {
                                                    phi_1001_ = _e632;
                                                    phi_1023_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e645 = phi_1001_;
                                                let _e647 = phi_1023_;
                                                let _e651 = (bitcast<i32>(_e647.member) != 0i);
                                                if _e651 {
                                                    let _e657 = type_47(_e630.member, _e630.member_1, (_e630.member_2 + 1u));
                                                    let _e658 = ((_e421 & 268435455u) + _e647.member_1);
                                                    let _e659 = (_e658 < _e68);
                                                    if _e659 {
                                                        if _e659 {
                                                        } else {
                                                            phi_2407_ = true;
                                                            break;
                                                        }
                                                        let _e663 = global_1.member[_e658].member_1;
                                                        phi_1047_ = _e663;
                                                    } else {
                                                        phi_1047_ = 4294967295u;
                                                    }
                                                    let _e665 = phi_1047_;
                                                    if (_e658 >= _e68) {
                                                        phi_1136_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e659 {
                                                        } else {
                                                            phi_2407_ = true;
                                                            break;
                                                        }
                                                        let _e667 = (_e204 % 3u);
                                                        let _e668 = (_e203 % 3u);
                                                        let _e669 = (_e205 % 3u);
                                                        if (_e667 < 9u) {
                                                        } else {
                                                            phi_2407_ = true;
                                                            break;
                                                        }
                                                        let _e675 = global_1.member[_e658].member[_e667];
                                                        if (_e668 < 9u) {
                                                        } else {
                                                            phi_2407_ = true;
                                                            break;
                                                        }
                                                        let _e681 = global_1.member[_e658].member[_e668];
                                                        if (_e669 < 9u) {
                                                        } else {
                                                            phi_2407_ = true;
                                                            break;
                                                        }
                                                        let _e687 = global_1.member[_e658].member[_e669];
                                                        let _e689 = (3u + _e667);
                                                        if (_e689 < 9u) {
                                                        } else {
                                                            phi_2407_ = true;
                                                            break;
                                                        }
                                                        let _e695 = global_1.member[_e658].member[_e689];
                                                        let _e696 = (3u + _e668);
                                                        if (_e696 < 9u) {
                                                        } else {
                                                            phi_2407_ = true;
                                                            break;
                                                        }
                                                        let _e702 = global_1.member[_e658].member[_e696];
                                                        let _e703 = (3u + _e669);
                                                        if (_e703 < 9u) {
                                                        } else {
                                                            phi_2407_ = true;
                                                            break;
                                                        }
                                                        let _e709 = global_1.member[_e658].member[_e703];
                                                        let _e711 = (6u + _e667);
                                                        if (_e711 < 9u) {
                                                        } else {
                                                            phi_2407_ = true;
                                                            break;
                                                        }
                                                        let _e717 = global_1.member[_e658].member[_e711];
                                                        let _e718 = (6u + _e668);
                                                        if (_e718 < 9u) {
                                                        } else {
                                                            phi_2407_ = true;
                                                            break;
                                                        }
                                                        let _e724 = global_1.member[_e658].member[_e718];
                                                        let _e725 = (6u + _e669);
                                                        if (_e725 < 9u) {
                                                        } else {
                                                            phi_2407_ = true;
                                                            break;
                                                        }
                                                        let _e731 = global_1.member[_e658].member[_e725];
                                                        phi_1136_ = array<array<f32, 3>, 3>(array<f32, 3>(_e675, _e681, _e687), array<f32, 3>(_e695, _e702, _e709), array<f32, 3>(_e717, _e724, _e731));
                                                    }
                                                    let _e735 = phi_1136_;
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
                                                            phi_1702_ = type_22();
                                                            phi_1703_ = true;
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
                                                                phi_1697_ = type_22();
                                                                phi_1698_ = true;
                                                            } else {
                                                                let _e874 = (_e872 > _e630.member.member_1);
                                                                if _e874 {
                                                                    phi_1696_ = type_22();
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
                                                                        phi_1607_ = _e885;
                                                                        phi_1608_ = _e889;
                                                                    } else {
                                                                        let _e935 = vec3((_e915 == _e932));
                                                                        phi_1607_ = select(_e881, _e889, _e935);
                                                                        phi_1608_ = select(_e885, _e881, _e935);
                                                                    }
                                                                    let _e939 = phi_1607_;
                                                                    let _e941 = phi_1608_;
                                                                    let _e948 = ((_e939.y * _e941.z) - (_e941.y * _e939.z));
                                                                    let _e953 = ((_e939.z * _e941.x) - (_e941.z * _e939.x));
                                                                    let _e956 = ((_e939.x * _e941.y) - (_e941.x * _e939.y));
                                                                    if (_e798 >= _e802) {
                                                                        phi_1639_ = select(true, false, (_e798 >= _e806));
                                                                    } else {
                                                                        phi_1639_ = true;
                                                                    }
                                                                    let _e961 = phi_1639_;
                                                                    if _e961 {
                                                                        phi_1648_ = select(vec3<f32>(_e735[2][0], _e735[2][1], _e735[2][2]), vec3<f32>(_e735[1][0], _e735[1][1], _e735[1][2]), vec3((_e802 >= _e806)));
                                                                    } else {
                                                                        phi_1648_ = vec3<f32>(_e735[0][0], _e735[0][1], _e735[0][2]);
                                                                    }
                                                                    let _e966 = phi_1648_;
                                                                    let _e983 = ((((_e948 * (_e966.x - _e236)) + (_e953 * (_e966.y - _e273))) + (_e956 * (_e966.z - _e309))) / (((_e948 * _e261) + (_e953 * _e297)) + (_e956 * _e333)));
                                                                    let _e985 = select(_e865, _e983, (_e983 < _e865));
                                                                    let _e987 = select(_e857, _e985, (_e985 > _e857));
                                                                    if (_e987 >= _e382) {
                                                                        let _e989 = (_e987 <= _e630.member.member_1);
                                                                        if _e989 {
                                                                            let _e990 = (1f / _e808);
                                                                            phi_1688_ = type_22(_e987, (_e802 * _e990), (_e806 * _e990), _e665);
                                                                        } else {
                                                                            phi_1688_ = type_22();
                                                                        }
                                                                        let _e995 = phi_1688_;
                                                                        phi_1690_ = _e995;
                                                                        phi_1691_ = select(true, false, _e989);
                                                                    } else {
                                                                        phi_1690_ = type_22();
                                                                        phi_1691_ = true;
                                                                    }
                                                                    let _e998 = phi_1690_;
                                                                    let _e1000 = phi_1691_;
                                                                    if _e1000 {
                                                                        phi_1695_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1695_ = _e998;
                                                                    }
                                                                    let _e1002 = phi_1695_;
                                                                    phi_1696_ = _e1002;
                                                                }
                                                                let _e1004 = phi_1696_;
                                                                phi_1697_ = _e1004;
                                                                phi_1698_ = _e874;
                                                            }
                                                            let _e1006 = phi_1697_;
                                                            let _e1008 = phi_1698_;
                                                            phi_1702_ = _e1006;
                                                            phi_1703_ = _e1008;
                                                        }
                                                        let _e1010 = phi_1702_;
                                                        let _e1012 = phi_1703_;
                                                        phi_1707_ = _e1010;
                                                        phi_1708_ = _e1012;
                                                    } else {
                                                        phi_1707_ = type_22();
                                                        phi_1708_ = true;
                                                    }
                                                    let _e1014 = phi_1707_;
                                                    let _e1016 = phi_1708_;
                                                    if _e1016 {
                                                        phi_1712_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1712_ = _e1014;
                                                    }
                                                    let _e1018 = phi_1712_;
                                                    if (_e1018.member_3 != 4294967295u) {
                                                        if (_e665 != _e388) {
                                                            if (_e1018.member < _e630.member.member.member) {
                                                                phi_1738_ = true;
                                                            } else {
                                                                if (_e1018.member == _e630.member.member.member) {
                                                                    phi_1737_ = (_e1018.member_3 < _e630.member.member.member_3);
                                                                } else {
                                                                    phi_1737_ = false;
                                                                }
                                                                let _e1033 = phi_1737_;
                                                                phi_1738_ = _e1033;
                                                            }
                                                            let _e1035 = phi_1738_;
                                                            if _e1035 {
                                                                phi_1745_ = type_47(type_42(_e1018, _e1018.member), _e657.member_1, _e657.member_2);
                                                            } else {
                                                                phi_1745_ = _e657;
                                                            }
                                                            let _e1042 = phi_1745_;
                                                            phi_1746_ = _e1042;
                                                        } else {
                                                            phi_1746_ = _e657;
                                                        }
                                                        let _e1044 = phi_1746_;
                                                        phi_1747_ = _e1044;
                                                    } else {
                                                        phi_1747_ = _e657;
                                                    }
                                                    let _e1046 = phi_1747_;
                                                    phi_998_ = _e1046;
                                                } else {
                                                    phi_998_ = type_47();
                                                }
                                                let _e1048 = phi_998_;
                                                continue;
                                                continuing {
                                                    phi_997_ = _e1048;
                                                    phi_1000_ = _e645;
                                                    phi_2407_ = _e395;
                                                    break if !(_e651);
                                                }
                                            }
                                            let _e1051 = phi_2407_;
                                            phi_2521_ = _e1051;
                                            if _e1051 {
                                                break;
                                            }
                                            phi_2525_ = _e1051;
                                            let _e1261 = local_4;
                                            phi_2204_ = _e1261;
                                            phi_2205_ = _e421;
                                            phi_2206_ = false;
                                            phi_2207_ = _e425;
                                        } else {
                                            if (_e421 >= _e66) {
                                                phi_1810_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e421 < _e66) {
                                                } else {
                                                    phi_2521_ = true;
                                                    break;
                                                }
                                                let _e441 = (_e204 % 3u);
                                                if (_e441 < 3u) {
                                                } else {
                                                    phi_2521_ = true;
                                                    break;
                                                }
                                                let _e447 = global_2.member[_e421].member[_e441];
                                                let _e453 = (_e203 % 3u);
                                                if (_e453 < 3u) {
                                                } else {
                                                    phi_2521_ = true;
                                                    break;
                                                }
                                                let _e459 = global_2.member[_e421].member[_e453];
                                                let _e465 = (_e205 % 3u);
                                                if (_e465 < 3u) {
                                                } else {
                                                    phi_2521_ = true;
                                                    break;
                                                }
                                                let _e471 = global_2.member[_e421].member[_e465];
                                                let _e481 = global_2.member[_e421].member_1;
                                                let _e485 = global_2.member[_e421].member_2;
                                                phi_1810_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e447[0], _e447[1], _e447[2], _e447[3]), vec4<f32>(_e459[0], _e459[1], _e459[2], _e459[3]), vec4<f32>(_e471[0], _e471[1], _e471[2], _e471[3])), _e481, _e485);
                                            }
                                            let _e488 = phi_1810_;
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
                                                        phi_2154_ = _e488.member_2;
                                                    } else {
                                                        phi_2154_ = _e488.member_1;
                                                    }
                                                    let _e595 = phi_2154_;
                                                    let _e596 = (_e425 % 128u);
                                                    let _e597 = (_e596 < 128u);
                                                    if _e597 {
                                                    } else {
                                                        phi_2521_ = true;
                                                        break;
                                                    }
                                                    local_1[_e596] = _e595;
                                                    if _e597 {
                                                    } else {
                                                        phi_2521_ = true;
                                                        break;
                                                    }
                                                    local[_e596] = select(_e584, _e582, (_e582 > _e584));
                                                    if _e591 {
                                                        phi_2181_ = _e488.member_1;
                                                    } else {
                                                        phi_2181_ = _e488.member_2;
                                                    }
                                                    let _e606 = phi_2181_;
                                                    phi_2182_ = _e606;
                                                    phi_2183_ = (_e425 + 1u);
                                                } else {
                                                    phi_2182_ = u32();
                                                    phi_2183_ = u32();
                                                }
                                                let _e608 = phi_2182_;
                                                let _e610 = phi_2183_;
                                                phi_2185_ = _e608;
                                                phi_2186_ = _e610;
                                                phi_2187_ = select(true, false, _e590);
                                            } else {
                                                phi_2185_ = u32();
                                                phi_2186_ = u32();
                                                phi_2187_ = true;
                                            }
                                            let _e613 = phi_2185_;
                                            let _e615 = phi_2186_;
                                            let _e617 = phi_2187_;
                                            if _e617 {
                                                if _e589 {
                                                    phi_2196_ = _e488.member_1;
                                                } else {
                                                    phi_2196_ = _e488.member_2;
                                                }
                                                let _e621 = phi_2196_;
                                                phi_2201_ = _e621;
                                                phi_2202_ = select(_e590, true, _e589);
                                            } else {
                                                phi_2201_ = _e613;
                                                phi_2202_ = _e423;
                                            }
                                            let _e624 = phi_2201_;
                                            let _e626 = phi_2202_;
                                            phi_2525_ = _e395;
                                            phi_2204_ = type_47(_e397.member, (_e397.member_1 + 1u), _e397.member_2);
                                            phi_2205_ = _e624;
                                            phi_2206_ = _e626;
                                            phi_2207_ = select(_e615, _e425, _e617);
                                        }
                                        let _e1053 = phi_2525_;
                                        let _e1055 = phi_2204_;
                                        let _e1057 = phi_2205_;
                                        let _e1059 = phi_2206_;
                                        let _e1061 = phi_2207_;
                                        phi_2524_ = _e1053;
                                        phi_2208_ = _e1055;
                                        phi_2209_ = _e1057;
                                        phi_2210_ = (_e401 - 1u);
                                        phi_2211_ = _e1059;
                                        phi_2212_ = _e1061;
                                    } else {
                                        phi_2524_ = _e395;
                                        phi_2208_ = _e397;
                                        phi_2209_ = _e421;
                                        phi_2210_ = _e401;
                                        phi_2211_ = _e423;
                                        phi_2212_ = _e425;
                                    }
                                    let _e1063 = phi_2524_;
                                    let _e1065 = phi_2208_;
                                    let _e1067 = phi_2209_;
                                    let _e1069 = phi_2210_;
                                    let _e1071 = phi_2211_;
                                    let _e1073 = phi_2212_;
                                    phi_2523_ = _e1063;
                                    phi_2213_ = _e1065;
                                    phi_2214_ = _e1067;
                                    phi_2215_ = _e1069;
                                    phi_2216_ = _e1071;
                                    phi_2217_ = _e1073;
                                } else {
                                    phi_2523_ = _e395;
                                    phi_2213_ = type_47();
                                    phi_2214_ = u32();
                                    phi_2215_ = u32();
                                    phi_2216_ = bool();
                                    phi_2217_ = u32();
                                }
                                let _e1075 = phi_2523_;
                                let _e1077 = phi_2213_;
                                let _e1079 = phi_2214_;
                                let _e1081 = phi_2215_;
                                let _e1083 = phi_2216_;
                                let _e1085 = phi_2217_;
                                phi_2522_ = _e1075;
                                phi_930_ = _e1077;
                                phi_933_ = _e1079;
                                phi_935_ = _e1081;
                                phi_937_ = _e1083;
                                phi_939_ = _e1085;
                                phi_2218_ = _e409;
                            } else {
                                phi_2522_ = _e395;
                                phi_930_ = type_47();
                                phi_933_ = u32();
                                phi_935_ = u32();
                                phi_937_ = bool();
                                phi_939_ = u32();
                                phi_2218_ = false;
                            }
                            let _e1087 = phi_2522_;
                            let _e1089 = phi_930_;
                            let _e1091 = phi_933_;
                            let _e1093 = phi_935_;
                            let _e1095 = phi_937_;
                            let _e1097 = phi_939_;
                            let _e1099 = phi_2218_;
                            continue;
                            continuing {
                                phi_2413_ = _e1087;
                                phi_929_ = _e1089;
                                phi_932_ = _e1091;
                                phi_934_ = _e1093;
                                phi_936_ = _e1095;
                                phi_938_ = _e1097;
                                phi_2521_ = _e1087;
                                break if !(_e1099);
                            }
                        }
                        let _e1102 = phi_2521_;
                        if _e1102 {
                            break;
                        }
                        let _e1104 = local_2;
                        if (_e1104.member.member.member_3 != 4294967295u) {
                            let _e1110 = (_e206 / 3i);
                            let _e1117 = bitcast<f32>((bitcast<u32>((_e1110 + 127i)) << bitcast<u32>(23i)));
                            let _e1125 = (((_e1104.member.member.member * _e1117) * _e1117) * bitcast<f32>((bitcast<u32>(((_e206 - (2i * _e1110)) + 127i)) << bitcast<u32>(23i))));
                            let _e1127 = select(340282350000000000000000000000000000000f, _e1125, (_e1125 < 340282350000000000000000000000000000000f));
                            phi_2270_ = type_22(select(-340282350000000000000000000000000000000f, _e1127, (_e1127 > -340282350000000000000000000000000000000f)), _e1104.member.member.member_1, _e1104.member.member.member_2, _e1104.member.member.member_3);
                        } else {
                            phi_2270_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1134 = phi_2270_;
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
