struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_32 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_33 {
    member: type_32,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_35 {
    member: array<type_33>,
}

struct type_40 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_46 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_49 {
    member: type_28,
    member_1: f32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_56 {
    member: array<vec4<u32>, 2>,
}

struct type_59 {
    member: array<i32>,
}

struct type_66 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_20;
@group(0) @binding(1) 
var<uniform> global_3: type_56;
@group(0) @binding(2) 
var<storage> global_4: type_42;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage> global_6: type_59;
@group(0) @binding(6) 
var<storage> global_7: type_35;
@group(0) @binding(7) 
var<storage, read_write> global_8: type_30;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_66;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_217_: u32;
    var phi_261_: i32;
    var phi_285_: type_46;
    var phi_391_: i32;
    var phi_392_: i32;
    var phi_402_: bool;
    var phi_412_: u32;
    var phi_413_: u32;
    var phi_415_: bool;
    var phi_420_: u32;
    var phi_452_: i32;
    var phi_470_: f32;
    var phi_476_: f32;
    var phi_487_: f32;
    var phi_493_: f32;
    var phi_516_: f32;
    var phi_527_: f32;
    var phi_536_: f32;
    var phi_542_: f32;
    var phi_553_: f32;
    var phi_559_: f32;
    var phi_582_: f32;
    var phi_593_: f32;
    var phi_602_: f32;
    var phi_608_: f32;
    var phi_619_: f32;
    var phi_625_: f32;
    var phi_648_: f32;
    var phi_659_: f32;
    var phi_759_: f32;
    var phi_760_: f32;
    var phi_2532_: bool;
    var phi_771_: type_49;
    var phi_774_: u32;
    var phi_776_: u32;
    var phi_778_: bool;
    var phi_780_: u32;
    var phi_791_: bool;
    var phi_823_: u32;
    var phi_824_: bool;
    var phi_825_: u32;
    var phi_1969_: type_54;
    var phi_2313_: u32;
    var phi_2341_: u32;
    var phi_2342_: u32;
    var phi_2343_: u32;
    var phi_2345_: u32;
    var phi_2346_: u32;
    var phi_2347_: bool;
    var phi_2356_: u32;
    var phi_2361_: u32;
    var phi_2362_: bool;
    var phi_840_: type_49;
    var phi_843_: type_8;
    var phi_844_: type_8;
    var phi_866_: type_8;
    var phi_887_: u32;
    var phi_976_: array<array<f32, 3>, 3>;
    var phi_1447_: vec3<f32>;
    var phi_1448_: vec3<f32>;
    var phi_1479_: bool;
    var phi_1488_: vec3<f32>;
    var phi_1528_: type_28;
    var phi_1530_: type_28;
    var phi_1531_: bool;
    var phi_1535_: type_28;
    var phi_1536_: type_28;
    var phi_1537_: type_28;
    var phi_1538_: bool;
    var phi_1542_: type_28;
    var phi_1543_: bool;
    var phi_1547_: type_28;
    var phi_1548_: bool;
    var phi_1552_: type_28;
    var phi_1575_: u32;
    var phi_1589_: i32;
    var phi_1609_: vec3<f32>;
    var phi_1610_: vec3<f32>;
    var phi_1626_: vec3<f32>;
    var phi_1627_: vec3<f32>;
    var phi_1643_: vec3<f32>;
    var phi_1644_: vec3<f32>;
    var phi_1680_: vec3<f32>;
    var phi_1862_: f32;
    var phi_1880_: bool;
    var phi_1881_: bool;
    var phi_1900_: bool;
    var phi_1901_: bool;
    var phi_1907_: type_49;
    var phi_1908_: type_49;
    var phi_1909_: type_49;
    var phi_841_: type_49;
    var phi_2526_: bool;
    var phi_2668_: bool;
    var phi_2364_: type_49;
    var phi_2365_: u32;
    var phi_2366_: bool;
    var phi_2367_: u32;
    var phi_2667_: bool;
    var phi_2368_: type_49;
    var phi_2369_: u32;
    var phi_2370_: u32;
    var phi_2371_: bool;
    var phi_2372_: u32;
    var phi_2666_: bool;
    var phi_2373_: type_49;
    var phi_2374_: u32;
    var phi_2375_: u32;
    var phi_2376_: bool;
    var phi_2377_: u32;
    var phi_2665_: bool;
    var phi_772_: type_49;
    var phi_775_: u32;
    var phi_777_: u32;
    var phi_779_: bool;
    var phi_781_: u32;
    var phi_2378_: bool;
    var phi_2664_: bool;
    var local_2: type_49;
    var phi_2430_: type_28;
    var local_3: type_49;

    switch bitcast<i32>(0u) {
        default: {
            let _e73 = global;
            let _e75 = arrayLength((&global_4.member));
            let _e77 = arrayLength((&global_2.member));
            let _e89 = arrayLength((&global_9.member));
            let _e93 = (_e73.x + (_e73.y * 2097152u));
            let _e94 = (_e93 < arrayLength((&global_7.member)));
            if _e94 {
                if _e94 {
                } else {
                    break;
                }
                let _e98 = global_7.member[_e93].member_2;
                phi_217_ = _e98;
            } else {
                phi_217_ = 4294967295u;
            }
            let _e100 = phi_217_;
            let _e103 = global_1.member[0u];
            let _e107 = global_3.member[0u][0u];
            let _e111 = global_3.member[0u][1u];
            let _e115 = global_3.member[0u][2u];
            let _e119 = global_3.member[0u][3u];
            let _e123 = global_3.member[1u][0u];
            let _e127 = global_3.member[1u][1u];
            let _e131 = global_3.member[1u][2u];
            let _e135 = global_3.member[1u][3u];
            let _e136 = bitcast<f32>(_e107);
            let _e137 = bitcast<f32>(_e111);
            let _e138 = bitcast<f32>(_e115);
            let _e140 = bitcast<f32>(_e123);
            let _e141 = array<u32, 3>(_e127, _e131, _e135);
            let _e143 = bitcast<i32>(_e103);
            if (_e143 < -126i) {
                phi_261_ = -126i;
            } else {
                phi_261_ = select(_e143, 127i, (_e143 > 127i));
            }
            let _e148 = phi_261_;
            let _e153 = bitcast<f32>((bitcast<u32>((_e148 + 127i)) << bitcast<u32>(23i)));
            let _e159 = bitcast<f32>((bitcast<u32>(((_e143 - _e148) + 127i)) << bitcast<u32>(23i)));
            if (_e119 == 0u) {
                phi_285_ = type_46(array<f32, 3>(_e136, _e137, _e138), _e119, _e140, _e141);
            } else {
                phi_285_ = type_46(array<f32, 3>(((_e136 * _e153) * _e159), ((_e137 * _e153) * _e159), ((_e138 * _e153) * _e159)), _e119, ((_e140 * _e153) * _e159), _e141);
            }
            let _e172 = phi_285_;
            if _e94 {
                let _e173 = (_e93 < arrayLength((&global_8.member)));
                if _e173 {
                    if _e94 {
                    } else {
                        break;
                    }
                    let _e183 = global_7.member[_e93].member.member_2[0u];
                    let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                    let _e191 = global_7.member[_e93].member.member_2[1u];
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e199 = global_7.member[_e93].member.member_2[2u];
                    let _e201 = (bitcast<u32>(_e199) & 2147483647u);
                    let _e207 = global_7.member[_e93].member.member[0u];
                    let _e209 = (bitcast<u32>(_e207) & 2147483647u);
                    let _e215 = global_7.member[_e93].member.member[1u];
                    let _e217 = (bitcast<u32>(_e215) & 2147483647u);
                    let _e223 = global_7.member[_e93].member.member[2u];
                    let _e225 = (bitcast<u32>(_e223) & 2147483647u);
                    let _e227 = select(_e193, _e185, (_e193 < _e185));
                    let _e229 = select(_e201, _e227, (_e201 < _e227));
                    let _e231 = select(_e209, _e229, (_e209 < _e229));
                    let _e233 = select(_e217, _e231, (_e217 < _e231));
                    let _e235 = select(_e225, _e233, (_e225 < _e233));
                    let _e240 = global_7.member[_e93].member.member_1;
                    let _e242 = (bitcast<u32>(_e240) & 2147483647u);
                    let _e250 = global_7.member[_e93].member.member_3;
                    let _e256 = (((select(_e242, _e235, (_e242 < _e235)) < 2139095040u) && ((bitcast<u32>(_e250) & 2147483647u) <= 2139095040u)) && (_e229 > 0u));
                    if _e256 {
                        let _e259 = (bitcast<u32>(bitcast<f32>(_e229)) & 2147483647u);
                        if (_e259 >= 8388608u) {
                            phi_391_ = (bitcast<i32>((_e259 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_391_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e259)), 32u, (_e259 == 0u))));
                        }
                        let _e273 = phi_391_;
                        phi_392_ = _e273;
                    } else {
                        phi_392_ = 0i;
                    }
                    let _e275 = phi_392_;
                    let _e276 = (_e185 == _e229);
                    if _e276 {
                        phi_402_ = true;
                    } else {
                        phi_402_ = (_e193 == _e229);
                    }
                    let _e279 = phi_402_;
                    let _e280 = select(1u, 0u, _e276);
                    if _e279 {
                        let _e281 = (_e280 + 1u);
                        phi_412_ = _e281;
                        phi_413_ = _e281;
                        phi_415_ = select(true, false, (_e281 == 2u));
                    } else {
                        phi_412_ = u32();
                        phi_413_ = 0u;
                        phi_415_ = true;
                    }
                    let _e285 = phi_412_;
                    let _e287 = phi_413_;
                    let _e289 = phi_415_;
                    if _e289 {
                        phi_420_ = (_e287 + 1u);
                    } else {
                        phi_420_ = 0u;
                    }
                    let _e293 = phi_420_;
                    let _e294 = select(_e285, _e287, _e289);
                    let _e295 = select(_e280, select(2u, _e280, _e279), _e289);
                    let _e296 = -(_e275);
                    if (_e296 < -126i) {
                        phi_452_ = -126i;
                    } else {
                        phi_452_ = select(_e296, 127i, (_e296 > 127i));
                    }
                    let _e301 = phi_452_;
                    let _e306 = bitcast<f32>((bitcast<u32>((_e301 + 127i)) << bitcast<u32>(23i)));
                    let _e312 = bitcast<f32>((bitcast<u32>(((_e296 - _e301) + 127i)) << bitcast<u32>(23i)));
                    let _e317 = global_7.member[_e93].member.member;
                    let _e318 = (_e294 == 0u);
                    if _e318 {
                        phi_470_ = _e317[0];
                    } else {
                        phi_470_ = _e317[1];
                    }
                    let _e322 = phi_470_;
                    let _e323 = (_e294 == 2u);
                    if _e323 {
                        phi_476_ = _e317[2];
                    } else {
                        phi_476_ = _e322;
                    }
                    let _e326 = phi_476_;
                    let _e327 = global_7.member[_e93].member.member_2;
                    if _e318 {
                        phi_487_ = _e327[0];
                    } else {
                        phi_487_ = _e327[1];
                    }
                    let _e331 = phi_487_;
                    if _e323 {
                        phi_493_ = _e327[2];
                    } else {
                        phi_493_ = _e331;
                    }
                    let _e334 = phi_493_;
                    let _e336 = ((_e334 * _e306) * _e312);
                    let _e340 = (bitcast<f32>((bitcast<u32>(_e336) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e340 {
                        let _e344 = (bitcast<f32>((bitcast<u32>(_e326) & 2147483647u)) * 0.00000011920929f);
                        phi_516_ = select(0.00000000000011368684f, _e344, (_e344 > 0.00000000000011368684f));
                    } else {
                        phi_516_ = 0f;
                    }
                    let _e348 = phi_516_;
                    let _e349 = (_e326 + _e348);
                    let _e350 = (_e326 - _e348);
                    let _e351 = select(_e336, 0f, _e340);
                    if _e340 {
                        phi_527_ = 38685626000000000000000000f;
                    } else {
                        phi_527_ = (1f / _e336);
                    }
                    let _e354 = phi_527_;
                    let _e355 = (_e293 == 0u);
                    if _e355 {
                        phi_536_ = _e317[0];
                    } else {
                        phi_536_ = _e317[1];
                    }
                    let _e359 = phi_536_;
                    let _e360 = (_e293 == 2u);
                    if _e360 {
                        phi_542_ = _e317[2];
                    } else {
                        phi_542_ = _e359;
                    }
                    let _e363 = phi_542_;
                    if _e355 {
                        phi_553_ = _e327[0];
                    } else {
                        phi_553_ = _e327[1];
                    }
                    let _e367 = phi_553_;
                    if _e360 {
                        phi_559_ = _e327[2];
                    } else {
                        phi_559_ = _e367;
                    }
                    let _e370 = phi_559_;
                    let _e372 = ((_e370 * _e306) * _e312);
                    let _e376 = (bitcast<f32>((bitcast<u32>(_e372) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e376 {
                        let _e380 = (bitcast<f32>((bitcast<u32>(_e363) & 2147483647u)) * 0.00000011920929f);
                        phi_582_ = select(0.00000000000011368684f, _e380, (_e380 > 0.00000000000011368684f));
                    } else {
                        phi_582_ = 0f;
                    }
                    let _e384 = phi_582_;
                    let _e385 = (_e363 + _e384);
                    let _e386 = (_e363 - _e384);
                    let _e387 = select(_e372, 0f, _e376);
                    if _e376 {
                        phi_593_ = 38685626000000000000000000f;
                    } else {
                        phi_593_ = (1f / _e372);
                    }
                    let _e390 = phi_593_;
                    let _e391 = (_e295 == 0u);
                    if _e391 {
                        phi_602_ = _e317[0];
                    } else {
                        phi_602_ = _e317[1];
                    }
                    let _e395 = phi_602_;
                    let _e396 = (_e295 == 2u);
                    if _e396 {
                        phi_608_ = _e317[2];
                    } else {
                        phi_608_ = _e395;
                    }
                    let _e399 = phi_608_;
                    if _e391 {
                        phi_619_ = _e327[0];
                    } else {
                        phi_619_ = _e327[1];
                    }
                    let _e403 = phi_619_;
                    if _e396 {
                        phi_625_ = _e327[2];
                    } else {
                        phi_625_ = _e403;
                    }
                    let _e406 = phi_625_;
                    let _e408 = ((_e406 * _e306) * _e312);
                    let _e412 = (bitcast<f32>((bitcast<u32>(_e408) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e412 {
                        let _e416 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) * 0.00000011920929f);
                        phi_648_ = select(0.00000000000011368684f, _e416, (_e416 > 0.00000000000011368684f));
                    } else {
                        phi_648_ = 0f;
                    }
                    let _e420 = phi_648_;
                    let _e421 = (_e399 + _e420);
                    let _e422 = (_e399 - _e420);
                    let _e423 = select(_e408, 0f, _e412);
                    if _e412 {
                        phi_659_ = 38685626000000000000000000f;
                    } else {
                        phi_659_ = (1f / _e408);
                    }
                    let _e426 = phi_659_;
                    let _e429 = bitcast<f32>((bitcast<u32>(_e326) & 2147483647u));
                    let _e432 = bitcast<f32>((bitcast<u32>(_e363) & 2147483647u));
                    let _e434 = select(_e432, _e429, (_e429 > _e432));
                    let _e437 = bitcast<f32>((bitcast<u32>(_e399) & 2147483647u));
                    if (_e256 && (select(_e437, _e434, (_e434 > _e437)) <= 1099511600000f)) {
                        let _e442 = (_e275 / 3i);
                        let _e449 = bitcast<f32>((bitcast<u32>((_e442 + 127i)) << bitcast<u32>(23i)));
                        let _e456 = bitcast<f32>((bitcast<u32>(((_e275 - (2i * _e442)) + 127i)) << bitcast<u32>(23i)));
                        let _e457 = (((_e240 * _e449) * _e449) * _e456);
                        let _e459 = select(340282350000000000000000000000000000000f, _e457, (_e457 < 340282350000000000000000000000000000000f));
                        let _e464 = (((_e250 * _e449) * _e449) * _e456);
                        let _e466 = select(340282350000000000000000000000000000000f, _e464, (_e464 < 340282350000000000000000000000000000000f));
                        phi_759_ = select(-340282350000000000000000000000000000000f, _e466, (_e466 > -340282350000000000000000000000000000000f));
                        phi_760_ = select(-340282350000000000000000000000000000000f, _e459, (_e459 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_759_ = 0f;
                        phi_760_ = 1f;
                    }
                    let _e470 = phi_759_;
                    let _e472 = phi_760_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2532_ = false;
                    phi_771_ = type_49(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e470);
                    phi_774_ = select(0u, 2147483648u, (_e75 == 0u));
                    phi_776_ = ((3u * _e75) + 1u);
                    phi_778_ = (_e472 <= _e470);
                    phi_780_ = 0u;
                    loop {
                        let _e480 = phi_2532_;
                        let _e482 = phi_771_;
                        let _e484 = phi_774_;
                        let _e486 = phi_776_;
                        let _e488 = phi_778_;
                        let _e490 = phi_780_;
                        local_2 = _e482;
                        if _e488 {
                            phi_791_ = true;
                        } else {
                            phi_791_ = (_e490 > 0u);
                        }
                        let _e493 = phi_791_;
                        if _e493 {
                            let _e494 = (_e486 > 0u);
                            if _e494 {
                                if _e488 {
                                    phi_823_ = _e484;
                                    phi_824_ = _e488;
                                    phi_825_ = _e490;
                                } else {
                                    let _e495 = (_e490 - 1u);
                                    let _e496 = (_e495 % 128u);
                                    let _e497 = (_e496 < 128u);
                                    if _e497 {
                                    } else {
                                        phi_2664_ = true;
                                        break;
                                    }
                                    let _e499 = local_1[_e496];
                                    if _e497 {
                                    } else {
                                        phi_2664_ = true;
                                        break;
                                    }
                                    let _e501 = local[_e496];
                                    phi_823_ = _e499;
                                    phi_824_ = (_e501 <= _e482.member_1);
                                    phi_825_ = _e495;
                                }
                                let _e505 = phi_823_;
                                let _e507 = phi_824_;
                                let _e509 = phi_825_;
                                if _e507 {
                                    if ((_e505 & 2147483648u) != 0u) {
                                        phi_840_ = _e482;
                                        phi_843_ = type_8(0u, ((_e505 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e707 = phi_840_;
                                            let _e709 = phi_843_;
                                            local_3 = _e707;
                                            if (_e709.member < _e709.member_1) {
                                                phi_844_ = type_8((_e709.member + 1u), _e709.member_1);
                                                phi_866_ = type_8(1u, _e709.member);
                                            } else {
                                                phi_844_ = _e709;
                                                phi_866_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e722 = phi_844_;
                                            let _e724 = phi_866_;
                                            let _e728 = (bitcast<i32>(_e724.member) != 0i);
                                            if _e728 {
                                                let _e729 = ((_e505 & 268435455u) + _e724.member_1);
                                                let _e730 = (_e729 < _e77);
                                                if _e730 {
                                                    if _e730 {
                                                    } else {
                                                        phi_2526_ = true;
                                                        break;
                                                    }
                                                    let _e734 = global_2.member[_e729].member_1;
                                                    phi_887_ = _e734;
                                                } else {
                                                    phi_887_ = 4294967295u;
                                                }
                                                let _e736 = phi_887_;
                                                if (_e729 >= _e77) {
                                                    phi_976_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e730 {
                                                    } else {
                                                        phi_2526_ = true;
                                                        break;
                                                    }
                                                    let _e738 = (_e294 % 3u);
                                                    let _e739 = (_e293 % 3u);
                                                    let _e740 = (_e295 % 3u);
                                                    if (_e738 < 9u) {
                                                    } else {
                                                        phi_2526_ = true;
                                                        break;
                                                    }
                                                    let _e746 = global_2.member[_e729].member[_e738];
                                                    if (_e739 < 9u) {
                                                    } else {
                                                        phi_2526_ = true;
                                                        break;
                                                    }
                                                    let _e752 = global_2.member[_e729].member[_e739];
                                                    if (_e740 < 9u) {
                                                    } else {
                                                        phi_2526_ = true;
                                                        break;
                                                    }
                                                    let _e758 = global_2.member[_e729].member[_e740];
                                                    let _e760 = (3u + _e738);
                                                    if (_e760 < 9u) {
                                                    } else {
                                                        phi_2526_ = true;
                                                        break;
                                                    }
                                                    let _e766 = global_2.member[_e729].member[_e760];
                                                    let _e767 = (3u + _e739);
                                                    if (_e767 < 9u) {
                                                    } else {
                                                        phi_2526_ = true;
                                                        break;
                                                    }
                                                    let _e773 = global_2.member[_e729].member[_e767];
                                                    let _e774 = (3u + _e740);
                                                    if (_e774 < 9u) {
                                                    } else {
                                                        phi_2526_ = true;
                                                        break;
                                                    }
                                                    let _e780 = global_2.member[_e729].member[_e774];
                                                    let _e782 = (6u + _e738);
                                                    if (_e782 < 9u) {
                                                    } else {
                                                        phi_2526_ = true;
                                                        break;
                                                    }
                                                    let _e788 = global_2.member[_e729].member[_e782];
                                                    let _e789 = (6u + _e739);
                                                    if (_e789 < 9u) {
                                                    } else {
                                                        phi_2526_ = true;
                                                        break;
                                                    }
                                                    let _e795 = global_2.member[_e729].member[_e789];
                                                    let _e796 = (6u + _e740);
                                                    if (_e796 < 9u) {
                                                    } else {
                                                        phi_2526_ = true;
                                                        break;
                                                    }
                                                    let _e802 = global_2.member[_e729].member[_e796];
                                                    phi_976_ = array<array<f32, 3>, 3>(array<f32, 3>(_e746, _e752, _e758), array<f32, 3>(_e766, _e773, _e780), array<f32, 3>(_e788, _e795, _e802));
                                                }
                                                let _e806 = phi_976_;
                                                let _e814 = (_e806[0][2] - _e399);
                                                let _e817 = (((_e806[0][0] - _e326) * _e423) - (_e814 * _e351));
                                                let _e820 = (((_e806[0][1] - _e363) * _e423) - (_e814 * _e387));
                                                let _e827 = (_e806[1][2] - _e399);
                                                let _e830 = (((_e806[1][0] - _e326) * _e423) - (_e827 * _e351));
                                                let _e833 = (((_e806[1][1] - _e363) * _e423) - (_e827 * _e387));
                                                let _e840 = (_e806[2][2] - _e399);
                                                let _e843 = (((_e806[2][0] - _e326) * _e423) - (_e840 * _e351));
                                                let _e846 = (((_e806[2][1] - _e363) * _e423) - (_e840 * _e387));
                                                let _e847 = (_e843 * _e833);
                                                let _e848 = (_e846 * _e830);
                                                let _e849 = (_e817 * _e846);
                                                let _e850 = (_e820 * _e843);
                                                let _e851 = (_e830 * _e820);
                                                let _e852 = (_e833 * _e817);
                                                let _e857 = (((_e847 >= _e848) && (_e849 >= _e850)) && (_e851 >= _e852));
                                                if (_e857 || (((_e847 <= _e848) && (_e849 <= _e850)) && (_e851 <= _e852))) {
                                                    let _e864 = select(-1f, 1f, _e857);
                                                    let _e866 = ((_e847 - _e848) * _e864);
                                                    let _e868 = select(0f, _e866, (_e866 > 0f));
                                                    let _e870 = ((_e849 - _e850) * _e864);
                                                    let _e872 = select(0f, _e870, (_e870 > 0f));
                                                    let _e874 = ((_e851 - _e852) * _e864);
                                                    let _e876 = select(0f, _e874, (_e874 > 0f));
                                                    let _e878 = ((_e868 + _e872) + _e876);
                                                    if (_e878 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1542_ = type_28();
                                                        phi_1543_ = true;
                                                    } else {
                                                        let _e881 = select(_e806[1][0], _e806[0][0], (_e806[0][0] < _e806[1][0]));
                                                        let _e885 = select(_e806[1][0], _e806[0][0], (_e806[0][0] > _e806[1][0]));
                                                        let _e889 = select(_e806[1][1], _e806[0][1], (_e806[0][1] < _e806[1][1]));
                                                        let _e893 = select(_e806[1][1], _e806[0][1], (_e806[0][1] > _e806[1][1]));
                                                        let _e897 = select(_e806[1][2], _e806[0][2], (_e806[0][2] < _e806[1][2]));
                                                        let _e901 = select(_e806[1][2], _e806[0][2], (_e806[0][2] > _e806[1][2]));
                                                        let _e906 = ((select(_e806[2][0], _e881, (_e881 < _e806[2][0])) - _e349) * _e354);
                                                        let _e907 = ((select(_e806[2][0], _e885, (_e885 > _e806[2][0])) - _e350) * _e354);
                                                        let _e910 = ((select(_e806[2][1], _e889, (_e889 < _e806[2][1])) - _e385) * _e390);
                                                        let _e911 = ((select(_e806[2][1], _e893, (_e893 > _e806[2][1])) - _e386) * _e390);
                                                        let _e914 = ((select(_e806[2][2], _e897, (_e897 < _e806[2][2])) - _e421) * _e426);
                                                        let _e915 = ((select(_e806[2][2], _e901, (_e901 > _e806[2][2])) - _e422) * _e426);
                                                        let _e917 = select(_e915, _e914, (_e914 < _e915));
                                                        let _e919 = select(_e915, _e914, (_e914 > _e915));
                                                        let _e921 = select(_e907, _e906, (_e906 < _e907));
                                                        let _e923 = select(_e911, _e910, (_e910 < _e911));
                                                        let _e925 = select(_e923, _e921, (_e921 > _e923));
                                                        let _e927 = select(_e917, _e925, (_e925 > _e917));
                                                        let _e929 = select(_e907, _e906, (_e906 > _e907));
                                                        let _e931 = select(_e911, _e910, (_e910 > _e911));
                                                        let _e933 = select(_e931, _e929, (_e929 < _e931));
                                                        let _e935 = select(_e919, _e933, (_e933 < _e919));
                                                        let _e936 = -(_e917);
                                                        let _e942 = select(_e472, _e927, (_e927 > _e472));
                                                        if (_e942 > (_e935 + (select(_e936, _e919, (_e919 > _e936)) * 0.0000019073523f))) {
                                                            phi_1537_ = type_28();
                                                            phi_1538_ = true;
                                                        } else {
                                                            let _e944 = (_e942 > _e707.member_1);
                                                            if _e944 {
                                                                phi_1536_ = type_28();
                                                            } else {
                                                                let _e948 = (_e806[1][0] - _e806[0][0]);
                                                                let _e949 = (_e806[1][1] - _e806[0][1]);
                                                                let _e950 = (_e806[1][2] - _e806[0][2]);
                                                                let _e951 = vec3<f32>(_e948, _e949, _e950);
                                                                let _e952 = (_e806[2][0] - _e806[1][0]);
                                                                let _e953 = (_e806[2][1] - _e806[1][1]);
                                                                let _e954 = (_e806[2][2] - _e806[1][2]);
                                                                let _e955 = vec3<f32>(_e952, _e953, _e954);
                                                                let _e956 = (_e806[0][0] - _e806[2][0]);
                                                                let _e957 = (_e806[0][1] - _e806[2][1]);
                                                                let _e958 = (_e806[0][2] - _e806[2][2]);
                                                                let _e959 = vec3<f32>(_e956, _e957, _e958);
                                                                let _e962 = bitcast<f32>((bitcast<u32>(_e948) & 2147483647u));
                                                                let _e965 = bitcast<f32>((bitcast<u32>(_e949) & 2147483647u));
                                                                let _e967 = select(_e965, _e962, (_e962 > _e965));
                                                                let _e970 = bitcast<f32>((bitcast<u32>(_e950) & 2147483647u));
                                                                let _e972 = select(_e970, _e967, (_e967 > _e970));
                                                                let _e975 = bitcast<f32>((bitcast<u32>(_e952) & 2147483647u));
                                                                let _e978 = bitcast<f32>((bitcast<u32>(_e953) & 2147483647u));
                                                                let _e980 = select(_e978, _e975, (_e975 > _e978));
                                                                let _e983 = bitcast<f32>((bitcast<u32>(_e954) & 2147483647u));
                                                                let _e985 = select(_e983, _e980, (_e980 > _e983));
                                                                let _e988 = bitcast<f32>((bitcast<u32>(_e956) & 2147483647u));
                                                                let _e991 = bitcast<f32>((bitcast<u32>(_e957) & 2147483647u));
                                                                let _e993 = select(_e991, _e988, (_e988 > _e991));
                                                                let _e996 = bitcast<f32>((bitcast<u32>(_e958) & 2147483647u));
                                                                let _e998 = select(_e996, _e993, (_e993 > _e996));
                                                                let _e1000 = select(_e985, _e972, (_e972 > _e985));
                                                                let _e1002 = select(_e998, _e1000, (_e1000 > _e998));
                                                                if (_e972 == _e1002) {
                                                                    phi_1447_ = _e955;
                                                                    phi_1448_ = _e959;
                                                                } else {
                                                                    let _e1005 = vec3((_e985 == _e1002));
                                                                    phi_1447_ = select(_e951, _e959, _e1005);
                                                                    phi_1448_ = select(_e955, _e951, _e1005);
                                                                }
                                                                let _e1009 = phi_1447_;
                                                                let _e1011 = phi_1448_;
                                                                let _e1018 = ((_e1009.y * _e1011.z) - (_e1011.y * _e1009.z));
                                                                let _e1023 = ((_e1009.z * _e1011.x) - (_e1011.z * _e1009.x));
                                                                let _e1026 = ((_e1009.x * _e1011.y) - (_e1011.x * _e1009.y));
                                                                if (_e868 >= _e872) {
                                                                    phi_1479_ = select(true, false, (_e868 >= _e876));
                                                                } else {
                                                                    phi_1479_ = true;
                                                                }
                                                                let _e1031 = phi_1479_;
                                                                if _e1031 {
                                                                    phi_1488_ = select(vec3<f32>(_e806[2][0], _e806[2][1], _e806[2][2]), vec3<f32>(_e806[1][0], _e806[1][1], _e806[1][2]), vec3((_e872 >= _e876)));
                                                                } else {
                                                                    phi_1488_ = vec3<f32>(_e806[0][0], _e806[0][1], _e806[0][2]);
                                                                }
                                                                let _e1036 = phi_1488_;
                                                                let _e1053 = ((((_e1018 * (_e1036.x - _e326)) + (_e1023 * (_e1036.y - _e363))) + (_e1026 * (_e1036.z - _e399))) / (((_e1018 * _e351) + (_e1023 * _e387)) + (_e1026 * _e423)));
                                                                let _e1055 = select(_e935, _e1053, (_e1053 < _e935));
                                                                let _e1057 = select(_e927, _e1055, (_e1055 > _e927));
                                                                if (_e1057 >= _e472) {
                                                                    let _e1059 = (_e1057 <= _e707.member_1);
                                                                    if _e1059 {
                                                                        let _e1060 = (1f / _e878);
                                                                        phi_1528_ = type_28(_e1057, (_e872 * _e1060), (_e876 * _e1060), _e736);
                                                                    } else {
                                                                        phi_1528_ = type_28();
                                                                    }
                                                                    let _e1065 = phi_1528_;
                                                                    phi_1530_ = _e1065;
                                                                    phi_1531_ = select(true, false, _e1059);
                                                                } else {
                                                                    phi_1530_ = type_28();
                                                                    phi_1531_ = true;
                                                                }
                                                                let _e1068 = phi_1530_;
                                                                let _e1070 = phi_1531_;
                                                                if _e1070 {
                                                                    phi_1535_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1535_ = _e1068;
                                                                }
                                                                let _e1072 = phi_1535_;
                                                                phi_1536_ = _e1072;
                                                            }
                                                            let _e1074 = phi_1536_;
                                                            phi_1537_ = _e1074;
                                                            phi_1538_ = _e944;
                                                        }
                                                        let _e1076 = phi_1537_;
                                                        let _e1078 = phi_1538_;
                                                        phi_1542_ = _e1076;
                                                        phi_1543_ = _e1078;
                                                    }
                                                    let _e1080 = phi_1542_;
                                                    let _e1082 = phi_1543_;
                                                    phi_1547_ = _e1080;
                                                    phi_1548_ = _e1082;
                                                } else {
                                                    phi_1547_ = type_28();
                                                    phi_1548_ = true;
                                                }
                                                let _e1084 = phi_1547_;
                                                let _e1086 = phi_1548_;
                                                if _e1086 {
                                                    phi_1552_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1552_ = _e1084;
                                                }
                                                let _e1088 = phi_1552_;
                                                if (_e1088.member_3 != 4294967295u) {
                                                    if (_e736 == _e100) {
                                                        phi_1881_ = false;
                                                    } else {
                                                        let _e1092 = (_e736 < arrayLength((&global_5.member)));
                                                        if _e1092 {
                                                            if _e1092 {
                                                            } else {
                                                                phi_2526_ = true;
                                                                break;
                                                            }
                                                            let _e1094 = global_5.member[_e736];
                                                            phi_1575_ = _e1094;
                                                        } else {
                                                            phi_1575_ = 4294967295u;
                                                        }
                                                        let _e1096 = phi_1575_;
                                                        let _e1097 = (_e1096 < arrayLength((&global_6.member)));
                                                        if _e1097 {
                                                            if _e1097 {
                                                            } else {
                                                                phi_2526_ = true;
                                                                break;
                                                            }
                                                            let _e1099 = global_6.member[_e1096];
                                                            phi_1589_ = _e1099;
                                                        } else {
                                                            phi_1589_ = 0i;
                                                        }
                                                        let _e1101 = phi_1589_;
                                                        let _e1102 = (_e1101 == 0i);
                                                        if _e1102 {
                                                            phi_1880_ = true;
                                                        } else {
                                                            if _e318 {
                                                                phi_1610_ = vec3<f32>(_e806[0][0], _e806[0][1], _e806[0][2]);
                                                            } else {
                                                                if (_e294 == 1u) {
                                                                    phi_1609_ = vec3<f32>(_e806[0][2], _e806[0][0], _e806[0][1]);
                                                                } else {
                                                                    phi_1609_ = vec3<f32>(_e806[0][1], _e806[0][2], _e806[0][0]);
                                                                }
                                                                let _e1107 = phi_1609_;
                                                                phi_1610_ = _e1107;
                                                            }
                                                            let _e1110 = phi_1610_;
                                                            if _e318 {
                                                                phi_1627_ = vec3<f32>(_e806[1][0], _e806[1][1], _e806[1][2]);
                                                            } else {
                                                                if (_e294 == 1u) {
                                                                    phi_1626_ = vec3<f32>(_e806[1][2], _e806[1][0], _e806[1][1]);
                                                                } else {
                                                                    phi_1626_ = vec3<f32>(_e806[1][1], _e806[1][2], _e806[1][0]);
                                                                }
                                                                let _e1115 = phi_1626_;
                                                                phi_1627_ = _e1115;
                                                            }
                                                            let _e1118 = phi_1627_;
                                                            if _e318 {
                                                                phi_1644_ = vec3<f32>(_e806[2][0], _e806[2][1], _e806[2][2]);
                                                            } else {
                                                                if (_e294 == 1u) {
                                                                    phi_1643_ = vec3<f32>(_e806[2][2], _e806[2][0], _e806[2][1]);
                                                                } else {
                                                                    phi_1643_ = vec3<f32>(_e806[2][1], _e806[2][2], _e806[2][0]);
                                                                }
                                                                let _e1123 = phi_1643_;
                                                                phi_1644_ = _e1123;
                                                            }
                                                            let _e1126 = phi_1644_;
                                                            let _e1129 = (_e1118.x - _e1110.x);
                                                            let _e1132 = (_e1118.y - _e1110.y);
                                                            let _e1135 = (_e1118.z - _e1110.z);
                                                            let _e1137 = (_e1126.x - _e1110.x);
                                                            let _e1139 = (_e1126.y - _e1110.y);
                                                            let _e1141 = (_e1126.z - _e1110.z);
                                                            if (_e172.member_1 == 1u) {
                                                                phi_1680_ = (vec3<f32>(_e172.member[0], _e172.member[1], _e172.member[2]) - _e1110);
                                                            } else {
                                                                phi_1680_ = vec3<f32>(_e172.member[0], _e172.member[1], _e172.member[2]);
                                                            }
                                                            let _e1156 = phi_1680_;
                                                            let _e1162 = bitcast<f32>((bitcast<u32>((_e1129 * _e1139)) ^ _e172.member_3[0]));
                                                            let _e1166 = bitcast<f32>((bitcast<u32>((_e1132 * _e1137)) ^ _e172.member_3[0]));
                                                            let _e1170 = bitcast<f32>((bitcast<u32>((_e1132 * _e1141)) ^ _e172.member_3[0]));
                                                            let _e1174 = bitcast<f32>((bitcast<u32>((_e1135 * _e1139)) ^ _e172.member_3[0]));
                                                            let _e1178 = bitcast<f32>((bitcast<u32>((_e1135 * _e1137)) ^ _e172.member_3[0]));
                                                            let _e1182 = bitcast<f32>((bitcast<u32>((_e1129 * _e1141)) ^ _e172.member_3[0]));
                                                            let _e1183 = (_e1170 - _e1174);
                                                            let _e1184 = (_e1178 - _e1182);
                                                            let _e1185 = (_e1162 - _e1166);
                                                            let _e1209 = (bitcast<f32>((bitcast<u32>(_e1170) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1174) & 2147483647u)));
                                                            let _e1216 = (bitcast<f32>((bitcast<u32>(_e1178) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1182) & 2147483647u)));
                                                            let _e1223 = (bitcast<f32>((bitcast<u32>(_e1162) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1166) & 2147483647u)));
                                                            if (_e172.member_2 == 0f) {
                                                                phi_1862_ = 0f;
                                                            } else {
                                                                let _e1253 = bitcast<f32>((bitcast<u32>(_e1183) & 2147483647u));
                                                                let _e1256 = bitcast<f32>((bitcast<u32>(_e1184) & 2147483647u));
                                                                let _e1259 = bitcast<f32>((bitcast<u32>(_e1185) & 2147483647u));
                                                                let _e1261 = select(_e1259, _e1256, (_e1256 > _e1259));
                                                                let _e1265 = select(_e1259, _e1256, (_e1256 < _e1259));
                                                                let _e1269 = select(_e1256, _e1253, (_e1253 < _e1256));
                                                                let _e1271 = select(_e1256, _e1253, (_e1253 > _e1256));
                                                                let _e1273 = select(_e1259, _e1271, (_e1271 < _e1259));
                                                                phi_1862_ = bitcast<f32>((bitcast<u32>((_e172.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1261, _e1253, (_e1253 > _e1261)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1273, _e1269, (_e1269 > _e1273)))) ^ _e172.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1265, _e1253, (_e1253 < _e1265)))) ^ _e172.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1209 + _e1216) + _e1223))) ^ _e172.member_3[0]))) * 1.0000005f)) ^ _e172.member_3[0])))) ^ _e172.member_3[0]));
                                                            }
                                                            let _e1300 = phi_1862_;
                                                            phi_1880_ = (_e1102 || !(((((bitcast<f32>((bitcast<u32>((_e1156.x * _e1183)) ^ _e172.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1156.y * _e1184)) ^ _e172.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1156.z * _e1185)) ^ _e172.member_3[0]))) * f32(-(_e1101))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1156.x) & 2147483647u)) * _e1209)) ^ _e172.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1156.y) & 2147483647u)) * _e1216)) ^ _e172.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1156.z) & 2147483647u)) * _e1223)) ^ _e172.member_3[0]))))) ^ _e172.member_3[0])) + _e1300) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1314 = phi_1880_;
                                                        phi_1881_ = _e1314;
                                                    }
                                                    let _e1316 = phi_1881_;
                                                    if _e1316 {
                                                        if (_e1088.member < _e707.member.member) {
                                                            phi_1901_ = true;
                                                        } else {
                                                            if (_e1088.member == _e707.member.member) {
                                                                phi_1900_ = (_e1088.member_3 < _e707.member.member_3);
                                                            } else {
                                                                phi_1900_ = false;
                                                            }
                                                            let _e1326 = phi_1900_;
                                                            phi_1901_ = _e1326;
                                                        }
                                                        let _e1328 = phi_1901_;
                                                        if _e1328 {
                                                            phi_1907_ = type_49(_e1088, _e1088.member);
                                                        } else {
                                                            phi_1907_ = _e707;
                                                        }
                                                        let _e1331 = phi_1907_;
                                                        phi_1908_ = _e1331;
                                                    } else {
                                                        phi_1908_ = _e707;
                                                    }
                                                    let _e1333 = phi_1908_;
                                                    phi_1909_ = _e1333;
                                                } else {
                                                    phi_1909_ = _e707;
                                                }
                                                let _e1335 = phi_1909_;
                                                phi_841_ = _e1335;
                                            } else {
                                                phi_841_ = type_49();
                                            }
                                            let _e1337 = phi_841_;
                                            continue;
                                            continuing {
                                                phi_840_ = _e1337;
                                                phi_843_ = _e722;
                                                phi_2526_ = _e480;
                                                break if !(_e728);
                                            }
                                        }
                                        let _e1340 = phi_2526_;
                                        phi_2664_ = _e1340;
                                        if _e1340 {
                                            break;
                                        }
                                        phi_2668_ = _e1340;
                                        let _e1548 = local_3;
                                        phi_2364_ = _e1548;
                                        phi_2365_ = _e505;
                                        phi_2366_ = false;
                                        phi_2367_ = _e509;
                                    } else {
                                        if (_e505 >= _e75) {
                                            phi_1969_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e505 < _e75) {
                                            } else {
                                                phi_2664_ = true;
                                                break;
                                            }
                                            let _e519 = (_e294 % 3u);
                                            if (_e519 < 3u) {
                                            } else {
                                                phi_2664_ = true;
                                                break;
                                            }
                                            let _e525 = global_4.member[_e505].member[_e519];
                                            let _e531 = (_e293 % 3u);
                                            if (_e531 < 3u) {
                                            } else {
                                                phi_2664_ = true;
                                                break;
                                            }
                                            let _e537 = global_4.member[_e505].member[_e531];
                                            let _e543 = (_e295 % 3u);
                                            if (_e543 < 3u) {
                                            } else {
                                                phi_2664_ = true;
                                                break;
                                            }
                                            let _e549 = global_4.member[_e505].member[_e543];
                                            let _e559 = global_4.member[_e505].member_1;
                                            let _e563 = global_4.member[_e505].member_2;
                                            phi_1969_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e525[0], _e525[1], _e525[2], _e525[3]), vec4<f32>(_e537[0], _e537[1], _e537[2], _e537[3]), vec4<f32>(_e549[0], _e549[1], _e549[2], _e549[3])), _e559, _e563);
                                        }
                                        let _e566 = phi_1969_;
                                        let _e578 = ((_e566.member[0].x - _e349) * _e354);
                                        let _e579 = ((_e566.member[0].y - _e349) * _e354);
                                        let _e580 = ((_e566.member[0].z - _e350) * _e354);
                                        let _e581 = ((_e566.member[0].w - _e350) * _e354);
                                        let _e591 = ((_e566.member[1].x - _e385) * _e390);
                                        let _e592 = ((_e566.member[1].y - _e385) * _e390);
                                        let _e593 = ((_e566.member[1].z - _e386) * _e390);
                                        let _e594 = ((_e566.member[1].w - _e386) * _e390);
                                        let _e604 = ((_e566.member[2].x - _e421) * _e426);
                                        let _e605 = ((_e566.member[2].y - _e421) * _e426);
                                        let _e606 = ((_e566.member[2].z - _e422) * _e426);
                                        let _e607 = ((_e566.member[2].w - _e422) * _e426);
                                        let _e609 = select(_e606, _e604, (_e604 < _e606));
                                        let _e611 = select(_e607, _e605, (_e605 < _e607));
                                        let _e613 = select(_e606, _e604, (_e604 > _e606));
                                        let _e615 = select(_e607, _e605, (_e605 > _e607));
                                        let _e617 = select(_e580, _e578, (_e578 < _e580));
                                        let _e619 = select(_e581, _e579, (_e579 < _e581));
                                        let _e621 = select(_e593, _e591, (_e591 < _e593));
                                        let _e623 = select(_e594, _e592, (_e592 < _e594));
                                        let _e625 = select(_e621, _e617, (_e617 > _e621));
                                        let _e627 = select(_e623, _e619, (_e619 > _e623));
                                        let _e629 = select(_e609, _e625, (_e625 > _e609));
                                        let _e631 = select(_e611, _e627, (_e627 > _e611));
                                        let _e633 = select(_e580, _e578, (_e578 > _e580));
                                        let _e635 = select(_e581, _e579, (_e579 > _e581));
                                        let _e637 = select(_e593, _e591, (_e591 > _e593));
                                        let _e639 = select(_e594, _e592, (_e592 > _e594));
                                        let _e641 = select(_e637, _e633, (_e633 < _e637));
                                        let _e643 = select(_e639, _e635, (_e635 < _e639));
                                        let _e648 = -(_e609);
                                        let _e649 = -(_e611);
                                        let _e656 = (select(_e613, _e641, (_e641 < _e613)) + (select(_e648, _e613, (_e613 > _e648)) * 0.0000019073523f));
                                        let _e657 = (select(_e615, _e643, (_e643 < _e615)) + (select(_e649, _e615, (_e615 > _e649)) * 0.0000019073523f));
                                        let _e659 = select(_e472, _e629, (_e629 > _e472));
                                        let _e661 = select(_e472, _e631, (_e631 > _e472));
                                        let _e666 = (_e659 <= select(_e482.member_1, _e656, (_e656 < _e482.member_1)));
                                        let _e667 = (_e661 <= select(_e482.member_1, _e657, (_e657 < _e482.member_1)));
                                        let _e668 = (_e659 <= _e661);
                                        if _e666 {
                                            if _e667 {
                                                if _e668 {
                                                    phi_2313_ = _e566.member_2;
                                                } else {
                                                    phi_2313_ = _e566.member_1;
                                                }
                                                let _e672 = phi_2313_;
                                                let _e675 = (_e509 % 128u);
                                                let _e676 = (_e675 < 128u);
                                                if _e676 {
                                                } else {
                                                    phi_2664_ = true;
                                                    break;
                                                }
                                                local_1[_e675] = _e672;
                                                if _e676 {
                                                } else {
                                                    phi_2664_ = true;
                                                    break;
                                                }
                                                local[_e675] = select(_e661, _e659, (_e659 > _e661));
                                                if _e668 {
                                                    phi_2341_ = _e566.member_1;
                                                } else {
                                                    phi_2341_ = _e566.member_2;
                                                }
                                                let _e683 = phi_2341_;
                                                phi_2342_ = _e683;
                                                phi_2343_ = (_e509 + 1u);
                                            } else {
                                                phi_2342_ = u32();
                                                phi_2343_ = u32();
                                            }
                                            let _e685 = phi_2342_;
                                            let _e687 = phi_2343_;
                                            phi_2345_ = _e685;
                                            phi_2346_ = _e687;
                                            phi_2347_ = select(true, false, _e667);
                                        } else {
                                            phi_2345_ = u32();
                                            phi_2346_ = u32();
                                            phi_2347_ = true;
                                        }
                                        let _e690 = phi_2345_;
                                        let _e692 = phi_2346_;
                                        let _e694 = phi_2347_;
                                        if _e694 {
                                            if _e666 {
                                                phi_2356_ = _e566.member_1;
                                            } else {
                                                phi_2356_ = _e566.member_2;
                                            }
                                            let _e698 = phi_2356_;
                                            phi_2361_ = _e698;
                                            phi_2362_ = select(_e667, true, _e666);
                                        } else {
                                            phi_2361_ = _e690;
                                            phi_2362_ = _e507;
                                        }
                                        let _e701 = phi_2361_;
                                        let _e703 = phi_2362_;
                                        phi_2668_ = _e480;
                                        phi_2364_ = _e482;
                                        phi_2365_ = _e701;
                                        phi_2366_ = _e703;
                                        phi_2367_ = select(_e692, _e509, _e694);
                                    }
                                    let _e1342 = phi_2668_;
                                    let _e1344 = phi_2364_;
                                    let _e1346 = phi_2365_;
                                    let _e1348 = phi_2366_;
                                    let _e1350 = phi_2367_;
                                    phi_2667_ = _e1342;
                                    phi_2368_ = _e1344;
                                    phi_2369_ = _e1346;
                                    phi_2370_ = (_e486 - 1u);
                                    phi_2371_ = _e1348;
                                    phi_2372_ = _e1350;
                                } else {
                                    phi_2667_ = _e480;
                                    phi_2368_ = _e482;
                                    phi_2369_ = _e505;
                                    phi_2370_ = _e486;
                                    phi_2371_ = _e507;
                                    phi_2372_ = _e509;
                                }
                                let _e1352 = phi_2667_;
                                let _e1354 = phi_2368_;
                                let _e1356 = phi_2369_;
                                let _e1358 = phi_2370_;
                                let _e1360 = phi_2371_;
                                let _e1362 = phi_2372_;
                                phi_2666_ = _e1352;
                                phi_2373_ = _e1354;
                                phi_2374_ = _e1356;
                                phi_2375_ = _e1358;
                                phi_2376_ = _e1360;
                                phi_2377_ = _e1362;
                            } else {
                                phi_2666_ = _e480;
                                phi_2373_ = type_49();
                                phi_2374_ = u32();
                                phi_2375_ = u32();
                                phi_2376_ = bool();
                                phi_2377_ = u32();
                            }
                            let _e1364 = phi_2666_;
                            let _e1366 = phi_2373_;
                            let _e1368 = phi_2374_;
                            let _e1370 = phi_2375_;
                            let _e1372 = phi_2376_;
                            let _e1374 = phi_2377_;
                            phi_2665_ = _e1364;
                            phi_772_ = _e1366;
                            phi_775_ = _e1368;
                            phi_777_ = _e1370;
                            phi_779_ = _e1372;
                            phi_781_ = _e1374;
                            phi_2378_ = _e494;
                        } else {
                            phi_2665_ = _e480;
                            phi_772_ = type_49();
                            phi_775_ = u32();
                            phi_777_ = u32();
                            phi_779_ = bool();
                            phi_781_ = u32();
                            phi_2378_ = false;
                        }
                        let _e1376 = phi_2665_;
                        let _e1378 = phi_772_;
                        let _e1380 = phi_775_;
                        let _e1382 = phi_777_;
                        let _e1384 = phi_779_;
                        let _e1386 = phi_781_;
                        let _e1388 = phi_2378_;
                        continue;
                        continuing {
                            phi_2532_ = _e1376;
                            phi_771_ = _e1378;
                            phi_774_ = _e1380;
                            phi_776_ = _e1382;
                            phi_778_ = _e1384;
                            phi_780_ = _e1386;
                            phi_2664_ = _e1376;
                            break if !(_e1388);
                        }
                    }
                    let _e1391 = phi_2664_;
                    if _e1391 {
                        break;
                    }
                    let _e1393 = local_2;
                    if (_e1393.member.member_3 != 4294967295u) {
                        let _e1398 = (_e296 / 3i);
                        let _e1405 = bitcast<f32>((bitcast<u32>((_e1398 + 127i)) << bitcast<u32>(23i)));
                        let _e1413 = (((_e1393.member.member * _e1405) * _e1405) * bitcast<f32>((bitcast<u32>(((_e296 - (2i * _e1398)) + 127i)) << bitcast<u32>(23i))));
                        let _e1415 = select(340282350000000000000000000000000000000f, _e1413, (_e1413 < 340282350000000000000000000000000000000f));
                        phi_2430_ = type_28(select(-340282350000000000000000000000000000000f, _e1415, (_e1415 > -340282350000000000000000000000000000000f)), _e1393.member.member_1, _e1393.member.member_2, _e1393.member.member_3);
                    } else {
                        phi_2430_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1422 = phi_2430_;
                    if _e173 {
                    } else {
                        break;
                    }
                    global_8.member[_e93] = _e1422;
                    if _e94 {
                    } else {
                        break;
                    }
                    let _e1426 = select(0u, 1u, (_e240 <= _e250));
                    if (_e1426 > 0u) {
                        let _e1428 = (1u < _e89);
                        if _e1428 {
                            if (0u < _e89) {
                            } else {
                                break;
                            }
                            let _e1432 = atomicAdd((&global_9.member[0u]), _e1426);
                            if ((_e1432 + _e1426) < _e1432) {
                                if _e1428 {
                                } else {
                                    break;
                                }
                                let _e1437 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1440 = select(0u, 1u, (_e1422.member_3 != 4294967295u));
                    if (_e1440 > 0u) {
                        let _e1442 = (3u < _e89);
                        if _e1442 {
                            if (2u < _e89) {
                            } else {
                                break;
                            }
                            let _e1446 = atomicAdd((&global_9.member[2u]), _e1440);
                            if ((_e1446 + _e1440) < _e1446) {
                                if _e1442 {
                                } else {
                                    break;
                                }
                                let _e1451 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_facing(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
