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

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_30 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_37 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_39 {
    member: array<type_37>,
}

struct type_42 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_44 {
    member: array<type_42>,
}

struct type_47 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_53 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_54 {
    member: f32,
    member_1: bool,
}

struct type_56 {
    member: array<vec4<u32>, 2>,
}

struct type_59 {
    member: array<i32>,
}

struct type_67 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_56;
@group(0) @binding(2) 
var<storage> global_3: type_39;
@group(0) @binding(3) 
var<storage> global_4: type_20;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage> global_6: type_59;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_67;
@group(0) @binding(6) 
var<storage> global_8: type_44;
@group(0) @binding(7) 
var<storage, read_write> global_9: type_32;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_315_: type_47;
    var phi_425_: i32;
    var phi_426_: i32;
    var phi_436_: bool;
    var phi_446_: u32;
    var phi_447_: u32;
    var phi_449_: bool;
    var phi_454_: u32;
    var phi_498_: f32;
    var phi_504_: f32;
    var phi_515_: f32;
    var phi_521_: f32;
    var phi_544_: f32;
    var phi_555_: f32;
    var phi_564_: f32;
    var phi_570_: f32;
    var phi_581_: f32;
    var phi_587_: f32;
    var phi_610_: f32;
    var phi_621_: f32;
    var phi_630_: f32;
    var phi_636_: f32;
    var phi_647_: f32;
    var phi_653_: f32;
    var phi_676_: f32;
    var phi_687_: f32;
    var phi_787_: f32;
    var phi_788_: f32;
    var phi_2722_: bool;
    var phi_1062_: type_54;
    var phi_1065_: u32;
    var phi_1067_: u32;
    var phi_1069_: bool;
    var phi_1071_: u32;
    var phi_1082_: bool;
    var phi_1113_: u32;
    var phi_1114_: bool;
    var phi_1115_: u32;
    var phi_2238_: type_53;
    var phi_2582_: u32;
    var phi_2609_: u32;
    var phi_2610_: u32;
    var phi_2611_: u32;
    var phi_2613_: u32;
    var phi_2614_: u32;
    var phi_2615_: bool;
    var phi_2624_: u32;
    var phi_2629_: u32;
    var phi_2630_: bool;
    var phi_1130_: type_54;
    var phi_1133_: type_8;
    var phi_1134_: type_8;
    var phi_1156_: type_8;
    var phi_1177_: u32;
    var phi_1266_: array<array<f32, 3>, 3>;
    var phi_1737_: vec3<f32>;
    var phi_1738_: vec3<f32>;
    var phi_1769_: bool;
    var phi_1778_: vec3<f32>;
    var phi_1818_: type_28;
    var phi_1820_: type_28;
    var phi_1821_: bool;
    var phi_1825_: type_28;
    var phi_1826_: type_28;
    var phi_1827_: type_28;
    var phi_1828_: bool;
    var phi_1832_: type_28;
    var phi_1833_: bool;
    var phi_1837_: type_28;
    var phi_1838_: bool;
    var phi_1842_: type_28;
    var phi_1865_: u32;
    var phi_1879_: i32;
    var phi_1899_: vec3<f32>;
    var phi_1900_: vec3<f32>;
    var phi_1916_: vec3<f32>;
    var phi_1917_: vec3<f32>;
    var phi_1933_: vec3<f32>;
    var phi_1934_: vec3<f32>;
    var phi_1970_: vec3<f32>;
    var phi_2152_: f32;
    var phi_2170_: bool;
    var phi_2171_: bool;
    var phi_2176_: type_54;
    var phi_2177_: type_54;
    var phi_1131_: type_54;
    var phi_2716_: bool;
    var local_2: type_54;
    var phi_2851_: bool;
    var phi_2632_: type_54;
    var phi_2633_: u32;
    var phi_2634_: bool;
    var phi_2635_: u32;
    var phi_2850_: bool;
    var phi_2636_: type_54;
    var phi_2637_: u32;
    var phi_2638_: u32;
    var phi_2639_: bool;
    var phi_2640_: u32;
    var phi_2849_: bool;
    var phi_2641_: type_54;
    var phi_2642_: u32;
    var phi_2643_: u32;
    var phi_2644_: bool;
    var phi_2645_: u32;
    var phi_2848_: bool;
    var phi_1063_: type_54;
    var phi_1066_: u32;
    var phi_1068_: u32;
    var phi_1070_: bool;
    var phi_1072_: u32;
    var phi_2646_: bool;
    var phi_2847_: bool;
    var local_3: type_54;
    var local_4: type_54;

    switch bitcast<i32>(0u) {
        default: {
            let _e72 = global;
            let _e74 = arrayLength((&global_3.member));
            let _e76 = arrayLength((&global_4.member));
            let _e88 = arrayLength((&global_7.member));
            let _e92 = (_e72.x + (_e72.y * 2097152u));
            let _e93 = (_e92 < arrayLength((&global_8.member)));
            if _e93 {
                let _e94 = (_e92 < arrayLength((&global_9.member)));
                if _e94 {
                    if _e93 {
                    } else {
                        break;
                    }
                    let _e99 = global_8.member[_e92].member.member_1;
                    let _e104 = global_8.member[_e92].member.member_3;
                    if (_e99 <= _e104) {
                        let _e106 = (1u < _e88);
                        if _e106 {
                            if (0u < _e88) {
                            } else {
                                break;
                            }
                            let _e110 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e110 + 1u) < _e110) {
                                if _e106 {
                                } else {
                                    break;
                                }
                                let _e115 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        let _e118 = global_1.member[0u];
                        let _e122 = global_2.member[0u][0u];
                        let _e126 = global_2.member[0u][1u];
                        let _e130 = global_2.member[0u][2u];
                        let _e134 = global_2.member[0u][3u];
                        let _e138 = global_2.member[1u][0u];
                        let _e142 = global_2.member[1u][1u];
                        let _e146 = global_2.member[1u][2u];
                        let _e150 = global_2.member[1u][3u];
                        let _e151 = bitcast<f32>(_e122);
                        let _e152 = bitcast<f32>(_e126);
                        let _e153 = bitcast<f32>(_e130);
                        let _e155 = bitcast<f32>(_e138);
                        let _e156 = array<u32, 3>(_e142, _e146, _e150);
                        let _e158 = bitcast<i32>(_e118);
                        let _e159 = (_e158 / 2i);
                        let _e164 = bitcast<f32>((bitcast<u32>((_e159 + 127i)) << bitcast<u32>(23i)));
                        let _e170 = bitcast<f32>((bitcast<u32>(((_e158 - _e159) + 127i)) << bitcast<u32>(23i)));
                        if (_e134 == 0u) {
                            phi_315_ = type_47(array<f32, 3>(_e151, _e152, _e153), _e134, _e155, _e156);
                        } else {
                            phi_315_ = type_47(array<f32, 3>(((_e151 * _e164) * _e170), ((_e152 * _e164) * _e170), ((_e153 * _e164) * _e170)), _e134, ((_e155 * _e164) * _e170), _e156);
                        }
                        let _e183 = phi_315_;
                        if _e93 {
                        } else {
                            break;
                        }
                        if _e93 {
                        } else {
                            break;
                        }
                        let _e187 = global_8.member[_e92].member_2;
                        let _e197 = global_8.member[_e92].member.member_2[0u];
                        let _e199 = (bitcast<u32>(_e197) & 2147483647u);
                        let _e205 = global_8.member[_e92].member.member_2[1u];
                        let _e207 = (bitcast<u32>(_e205) & 2147483647u);
                        let _e213 = global_8.member[_e92].member.member_2[2u];
                        let _e215 = (bitcast<u32>(_e213) & 2147483647u);
                        let _e221 = global_8.member[_e92].member.member[0u];
                        let _e223 = (bitcast<u32>(_e221) & 2147483647u);
                        let _e229 = global_8.member[_e92].member.member[1u];
                        let _e231 = (bitcast<u32>(_e229) & 2147483647u);
                        let _e237 = global_8.member[_e92].member.member[2u];
                        let _e239 = (bitcast<u32>(_e237) & 2147483647u);
                        let _e241 = select(_e207, _e199, (_e207 < _e199));
                        let _e243 = select(_e215, _e241, (_e215 < _e241));
                        let _e245 = select(_e223, _e243, (_e223 < _e243));
                        let _e247 = select(_e231, _e245, (_e231 < _e245));
                        let _e249 = select(_e239, _e247, (_e239 < _e247));
                        let _e251 = (bitcast<u32>(_e99) & 2147483647u);
                        let _e260 = (((select(_e251, _e249, (_e251 < _e249)) < 2139095040u) && ((bitcast<u32>(_e104) & 2147483647u) <= 2139095040u)) && (_e243 > 0u));
                        if _e260 {
                            let _e263 = (bitcast<u32>(bitcast<f32>(_e243)) & 2147483647u);
                            if (_e263 >= 8388608u) {
                                phi_425_ = (bitcast<i32>((_e263 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_425_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e263)), 32u, (_e263 == 0u))));
                            }
                            let _e277 = phi_425_;
                            phi_426_ = _e277;
                        } else {
                            phi_426_ = 0i;
                        }
                        let _e279 = phi_426_;
                        let _e280 = (_e199 == _e243);
                        if _e280 {
                            phi_436_ = true;
                        } else {
                            phi_436_ = (_e207 == _e243);
                        }
                        let _e283 = phi_436_;
                        let _e284 = select(1u, 0u, _e280);
                        if _e283 {
                            let _e285 = (_e284 + 1u);
                            phi_446_ = _e285;
                            phi_447_ = _e285;
                            phi_449_ = select(true, false, (_e285 == 2u));
                        } else {
                            phi_446_ = u32();
                            phi_447_ = 0u;
                            phi_449_ = true;
                        }
                        let _e289 = phi_446_;
                        let _e291 = phi_447_;
                        let _e293 = phi_449_;
                        if _e293 {
                            phi_454_ = (_e291 + 1u);
                        } else {
                            phi_454_ = 0u;
                        }
                        let _e297 = phi_454_;
                        let _e298 = select(_e289, _e291, _e293);
                        let _e299 = select(_e284, select(2u, _e284, _e283), _e293);
                        let _e300 = -(_e279);
                        let _e301 = (_e300 / 2i);
                        let _e306 = bitcast<f32>((bitcast<u32>((_e301 + 127i)) << bitcast<u32>(23i)));
                        let _e312 = bitcast<f32>((bitcast<u32>(((_e300 - _e301) + 127i)) << bitcast<u32>(23i)));
                        let _e317 = global_8.member[_e92].member.member;
                        let _e318 = (_e298 == 0u);
                        if _e318 {
                            phi_498_ = _e317[0];
                        } else {
                            phi_498_ = _e317[1];
                        }
                        let _e322 = phi_498_;
                        let _e323 = (_e298 == 2u);
                        if _e323 {
                            phi_504_ = _e317[2];
                        } else {
                            phi_504_ = _e322;
                        }
                        let _e326 = phi_504_;
                        let _e327 = global_8.member[_e92].member.member_2;
                        if _e318 {
                            phi_515_ = _e327[0];
                        } else {
                            phi_515_ = _e327[1];
                        }
                        let _e331 = phi_515_;
                        if _e323 {
                            phi_521_ = _e327[2];
                        } else {
                            phi_521_ = _e331;
                        }
                        let _e334 = phi_521_;
                        let _e336 = ((_e334 * _e306) * _e312);
                        let _e340 = (bitcast<f32>((bitcast<u32>(_e336) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e340 {
                            let _e344 = (bitcast<f32>((bitcast<u32>(_e326) & 2147483647u)) * 0.00000011920929f);
                            phi_544_ = select(0.00000000000011368684f, _e344, (_e344 > 0.00000000000011368684f));
                        } else {
                            phi_544_ = 0f;
                        }
                        let _e348 = phi_544_;
                        let _e349 = (_e326 + _e348);
                        let _e350 = (_e326 - _e348);
                        let _e351 = select(_e336, 0f, _e340);
                        if _e340 {
                            phi_555_ = 38685626000000000000000000f;
                        } else {
                            phi_555_ = (1f / _e336);
                        }
                        let _e354 = phi_555_;
                        let _e355 = (_e297 == 0u);
                        if _e355 {
                            phi_564_ = _e317[0];
                        } else {
                            phi_564_ = _e317[1];
                        }
                        let _e359 = phi_564_;
                        let _e360 = (_e297 == 2u);
                        if _e360 {
                            phi_570_ = _e317[2];
                        } else {
                            phi_570_ = _e359;
                        }
                        let _e363 = phi_570_;
                        if _e355 {
                            phi_581_ = _e327[0];
                        } else {
                            phi_581_ = _e327[1];
                        }
                        let _e367 = phi_581_;
                        if _e360 {
                            phi_587_ = _e327[2];
                        } else {
                            phi_587_ = _e367;
                        }
                        let _e370 = phi_587_;
                        let _e372 = ((_e370 * _e306) * _e312);
                        let _e376 = (bitcast<f32>((bitcast<u32>(_e372) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e376 {
                            let _e380 = (bitcast<f32>((bitcast<u32>(_e363) & 2147483647u)) * 0.00000011920929f);
                            phi_610_ = select(0.00000000000011368684f, _e380, (_e380 > 0.00000000000011368684f));
                        } else {
                            phi_610_ = 0f;
                        }
                        let _e384 = phi_610_;
                        let _e385 = (_e363 + _e384);
                        let _e386 = (_e363 - _e384);
                        let _e387 = select(_e372, 0f, _e376);
                        if _e376 {
                            phi_621_ = 38685626000000000000000000f;
                        } else {
                            phi_621_ = (1f / _e372);
                        }
                        let _e390 = phi_621_;
                        let _e391 = (_e299 == 0u);
                        if _e391 {
                            phi_630_ = _e317[0];
                        } else {
                            phi_630_ = _e317[1];
                        }
                        let _e395 = phi_630_;
                        let _e396 = (_e299 == 2u);
                        if _e396 {
                            phi_636_ = _e317[2];
                        } else {
                            phi_636_ = _e395;
                        }
                        let _e399 = phi_636_;
                        if _e391 {
                            phi_647_ = _e327[0];
                        } else {
                            phi_647_ = _e327[1];
                        }
                        let _e403 = phi_647_;
                        if _e396 {
                            phi_653_ = _e327[2];
                        } else {
                            phi_653_ = _e403;
                        }
                        let _e406 = phi_653_;
                        let _e408 = ((_e406 * _e306) * _e312);
                        let _e412 = (bitcast<f32>((bitcast<u32>(_e408) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e412 {
                            let _e416 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) * 0.00000011920929f);
                            phi_676_ = select(0.00000000000011368684f, _e416, (_e416 > 0.00000000000011368684f));
                        } else {
                            phi_676_ = 0f;
                        }
                        let _e420 = phi_676_;
                        let _e421 = (_e399 + _e420);
                        let _e422 = (_e399 - _e420);
                        let _e423 = select(_e408, 0f, _e412);
                        if _e412 {
                            phi_687_ = 38685626000000000000000000f;
                        } else {
                            phi_687_ = (1f / _e408);
                        }
                        let _e426 = phi_687_;
                        let _e429 = bitcast<f32>((bitcast<u32>(_e326) & 2147483647u));
                        let _e432 = bitcast<f32>((bitcast<u32>(_e363) & 2147483647u));
                        let _e434 = select(_e432, _e429, (_e429 > _e432));
                        let _e437 = bitcast<f32>((bitcast<u32>(_e399) & 2147483647u));
                        if (_e260 && (select(_e437, _e434, (_e434 > _e437)) <= 1099511600000f)) {
                            let _e442 = (_e279 / 3i);
                            let _e449 = bitcast<f32>((bitcast<u32>((_e442 + 127i)) << bitcast<u32>(23i)));
                            let _e456 = bitcast<f32>((bitcast<u32>(((_e279 - (2i * _e442)) + 127i)) << bitcast<u32>(23i)));
                            let _e457 = (((_e99 * _e449) * _e449) * _e456);
                            let _e459 = select(340282350000000000000000000000000000000f, _e457, (_e457 < 340282350000000000000000000000000000000f));
                            let _e464 = (((_e104 * _e449) * _e449) * _e456);
                            let _e466 = select(340282350000000000000000000000000000000f, _e464, (_e464 < 340282350000000000000000000000000000000f));
                            phi_787_ = select(-340282350000000000000000000000000000000f, _e466, (_e466 > -340282350000000000000000000000000000000f));
                            phi_788_ = select(-340282350000000000000000000000000000000f, _e459, (_e459 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_787_ = 0f;
                            phi_788_ = 1f;
                        }
                        let _e470 = phi_787_;
                        let _e472 = phi_788_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2722_ = false;
                        phi_1062_ = type_54(_e470, false);
                        phi_1065_ = select(0u, 2147483648u, (_e74 == 0u));
                        phi_1067_ = ((3u * _e74) + 1u);
                        phi_1069_ = (_e472 <= _e470);
                        phi_1071_ = 0u;
                        loop {
                            let _e480 = phi_2722_;
                            let _e482 = phi_1062_;
                            let _e484 = phi_1065_;
                            let _e486 = phi_1067_;
                            let _e488 = phi_1069_;
                            let _e490 = phi_1071_;
                            local_3 = _e482;
                            if _e488 {
                                phi_1082_ = true;
                            } else {
                                phi_1082_ = (_e490 > 0u);
                            }
                            let _e493 = phi_1082_;
                            if _e493 {
                                let _e494 = (_e486 > 0u);
                                if _e494 {
                                    if _e488 {
                                        phi_1113_ = _e484;
                                        phi_1114_ = _e488;
                                        phi_1115_ = _e490;
                                    } else {
                                        let _e495 = (_e490 - 1u);
                                        let _e496 = (_e495 % 128u);
                                        let _e497 = (_e496 < 128u);
                                        if _e497 {
                                        } else {
                                            phi_2847_ = true;
                                            break;
                                        }
                                        let _e499 = local_1[_e496];
                                        if _e497 {
                                        } else {
                                            phi_2847_ = true;
                                            break;
                                        }
                                        let _e501 = local[_e496];
                                        phi_1113_ = _e499;
                                        phi_1114_ = (_e501 <= _e482.member);
                                        phi_1115_ = _e495;
                                    }
                                    let _e505 = phi_1113_;
                                    let _e507 = phi_1114_;
                                    let _e509 = phi_1115_;
                                    if _e507 {
                                        if ((_e505 & 2147483648u) != 0u) {
                                            phi_1130_ = _e482;
                                            phi_1133_ = type_8(0u, ((_e505 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e707 = phi_1130_;
                                                let _e709 = phi_1133_;
                                                local_2 = _e707;
                                                local_4 = _e707;
                                                if (_e709.member < _e709.member_1) {
                                                    phi_1134_ = type_8((_e709.member + 1u), _e709.member_1);
                                                    phi_1156_ = type_8(1u, _e709.member);
                                                } else {
                                                    phi_1134_ = _e709;
                                                    phi_1156_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e722 = phi_1134_;
                                                let _e724 = phi_1156_;
                                                let _e728 = (bitcast<i32>(_e724.member) != 0i);
                                                if _e728 {
                                                    let _e729 = ((_e505 & 268435455u) + _e724.member_1);
                                                    let _e730 = (_e729 < _e76);
                                                    if _e730 {
                                                        if _e730 {
                                                        } else {
                                                            phi_2716_ = true;
                                                            break;
                                                        }
                                                        let _e734 = global_4.member[_e729].member_1;
                                                        phi_1177_ = _e734;
                                                    } else {
                                                        phi_1177_ = 4294967295u;
                                                    }
                                                    let _e736 = phi_1177_;
                                                    if (_e729 >= _e76) {
                                                        phi_1266_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e730 {
                                                        } else {
                                                            phi_2716_ = true;
                                                            break;
                                                        }
                                                        let _e738 = (_e298 % 3u);
                                                        let _e739 = (_e297 % 3u);
                                                        let _e740 = (_e299 % 3u);
                                                        if (_e738 < 9u) {
                                                        } else {
                                                            phi_2716_ = true;
                                                            break;
                                                        }
                                                        let _e746 = global_4.member[_e729].member[_e738];
                                                        if (_e739 < 9u) {
                                                        } else {
                                                            phi_2716_ = true;
                                                            break;
                                                        }
                                                        let _e752 = global_4.member[_e729].member[_e739];
                                                        if (_e740 < 9u) {
                                                        } else {
                                                            phi_2716_ = true;
                                                            break;
                                                        }
                                                        let _e758 = global_4.member[_e729].member[_e740];
                                                        let _e760 = (3u + _e738);
                                                        if (_e760 < 9u) {
                                                        } else {
                                                            phi_2716_ = true;
                                                            break;
                                                        }
                                                        let _e766 = global_4.member[_e729].member[_e760];
                                                        let _e767 = (3u + _e739);
                                                        if (_e767 < 9u) {
                                                        } else {
                                                            phi_2716_ = true;
                                                            break;
                                                        }
                                                        let _e773 = global_4.member[_e729].member[_e767];
                                                        let _e774 = (3u + _e740);
                                                        if (_e774 < 9u) {
                                                        } else {
                                                            phi_2716_ = true;
                                                            break;
                                                        }
                                                        let _e780 = global_4.member[_e729].member[_e774];
                                                        let _e782 = (6u + _e738);
                                                        if (_e782 < 9u) {
                                                        } else {
                                                            phi_2716_ = true;
                                                            break;
                                                        }
                                                        let _e788 = global_4.member[_e729].member[_e782];
                                                        let _e789 = (6u + _e739);
                                                        if (_e789 < 9u) {
                                                        } else {
                                                            phi_2716_ = true;
                                                            break;
                                                        }
                                                        let _e795 = global_4.member[_e729].member[_e789];
                                                        let _e796 = (6u + _e740);
                                                        if (_e796 < 9u) {
                                                        } else {
                                                            phi_2716_ = true;
                                                            break;
                                                        }
                                                        let _e802 = global_4.member[_e729].member[_e796];
                                                        phi_1266_ = array<array<f32, 3>, 3>(array<f32, 3>(_e746, _e752, _e758), array<f32, 3>(_e766, _e773, _e780), array<f32, 3>(_e788, _e795, _e802));
                                                    }
                                                    let _e806 = phi_1266_;
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
                                                            phi_1832_ = type_28();
                                                            phi_1833_ = true;
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
                                                                phi_1827_ = type_28();
                                                                phi_1828_ = true;
                                                            } else {
                                                                let _e944 = (_e942 > _e707.member);
                                                                if _e944 {
                                                                    phi_1826_ = type_28();
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
                                                                        phi_1737_ = _e955;
                                                                        phi_1738_ = _e959;
                                                                    } else {
                                                                        let _e1005 = vec3((_e985 == _e1002));
                                                                        phi_1737_ = select(_e951, _e959, _e1005);
                                                                        phi_1738_ = select(_e955, _e951, _e1005);
                                                                    }
                                                                    let _e1009 = phi_1737_;
                                                                    let _e1011 = phi_1738_;
                                                                    let _e1018 = ((_e1009.y * _e1011.z) - (_e1011.y * _e1009.z));
                                                                    let _e1023 = ((_e1009.z * _e1011.x) - (_e1011.z * _e1009.x));
                                                                    let _e1026 = ((_e1009.x * _e1011.y) - (_e1011.x * _e1009.y));
                                                                    if (_e868 >= _e872) {
                                                                        phi_1769_ = select(true, false, (_e868 >= _e876));
                                                                    } else {
                                                                        phi_1769_ = true;
                                                                    }
                                                                    let _e1031 = phi_1769_;
                                                                    if _e1031 {
                                                                        phi_1778_ = select(vec3<f32>(_e806[2][0], _e806[2][1], _e806[2][2]), vec3<f32>(_e806[1][0], _e806[1][1], _e806[1][2]), vec3((_e872 >= _e876)));
                                                                    } else {
                                                                        phi_1778_ = vec3<f32>(_e806[0][0], _e806[0][1], _e806[0][2]);
                                                                    }
                                                                    let _e1036 = phi_1778_;
                                                                    let _e1053 = ((((_e1018 * (_e1036.x - _e326)) + (_e1023 * (_e1036.y - _e363))) + (_e1026 * (_e1036.z - _e399))) / (((_e1018 * _e351) + (_e1023 * _e387)) + (_e1026 * _e423)));
                                                                    let _e1055 = select(_e935, _e1053, (_e1053 < _e935));
                                                                    let _e1057 = select(_e927, _e1055, (_e1055 > _e927));
                                                                    if (_e1057 >= _e472) {
                                                                        let _e1059 = (_e1057 <= _e707.member);
                                                                        if _e1059 {
                                                                            let _e1060 = (1f / _e878);
                                                                            phi_1818_ = type_28(_e1057, (_e872 * _e1060), (_e876 * _e1060), _e736);
                                                                        } else {
                                                                            phi_1818_ = type_28();
                                                                        }
                                                                        let _e1065 = phi_1818_;
                                                                        phi_1820_ = _e1065;
                                                                        phi_1821_ = select(true, false, _e1059);
                                                                    } else {
                                                                        phi_1820_ = type_28();
                                                                        phi_1821_ = true;
                                                                    }
                                                                    let _e1068 = phi_1820_;
                                                                    let _e1070 = phi_1821_;
                                                                    if _e1070 {
                                                                        phi_1825_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1825_ = _e1068;
                                                                    }
                                                                    let _e1072 = phi_1825_;
                                                                    phi_1826_ = _e1072;
                                                                }
                                                                let _e1074 = phi_1826_;
                                                                phi_1827_ = _e1074;
                                                                phi_1828_ = _e944;
                                                            }
                                                            let _e1076 = phi_1827_;
                                                            let _e1078 = phi_1828_;
                                                            phi_1832_ = _e1076;
                                                            phi_1833_ = _e1078;
                                                        }
                                                        let _e1080 = phi_1832_;
                                                        let _e1082 = phi_1833_;
                                                        phi_1837_ = _e1080;
                                                        phi_1838_ = _e1082;
                                                    } else {
                                                        phi_1837_ = type_28();
                                                        phi_1838_ = true;
                                                    }
                                                    let _e1084 = phi_1837_;
                                                    let _e1086 = phi_1838_;
                                                    if _e1086 {
                                                        phi_1842_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1842_ = _e1084;
                                                    }
                                                    let _e1088 = phi_1842_;
                                                    if (_e1088.member_3 != 4294967295u) {
                                                        if (_e736 == _e187) {
                                                            phi_2171_ = false;
                                                        } else {
                                                            let _e1092 = (_e736 < arrayLength((&global_5.member)));
                                                            if _e1092 {
                                                                if _e1092 {
                                                                } else {
                                                                    phi_2716_ = true;
                                                                    break;
                                                                }
                                                                let _e1094 = global_5.member[_e736];
                                                                phi_1865_ = _e1094;
                                                            } else {
                                                                phi_1865_ = 4294967295u;
                                                            }
                                                            let _e1096 = phi_1865_;
                                                            let _e1097 = (_e1096 < arrayLength((&global_6.member)));
                                                            if _e1097 {
                                                                if _e1097 {
                                                                } else {
                                                                    phi_2716_ = true;
                                                                    break;
                                                                }
                                                                let _e1099 = global_6.member[_e1096];
                                                                phi_1879_ = _e1099;
                                                            } else {
                                                                phi_1879_ = 0i;
                                                            }
                                                            let _e1101 = phi_1879_;
                                                            let _e1102 = (_e1101 == 0i);
                                                            if _e1102 {
                                                                phi_2170_ = true;
                                                            } else {
                                                                if _e318 {
                                                                    phi_1900_ = vec3<f32>(_e806[0][0], _e806[0][1], _e806[0][2]);
                                                                } else {
                                                                    if (_e298 == 1u) {
                                                                        phi_1899_ = vec3<f32>(_e806[0][2], _e806[0][0], _e806[0][1]);
                                                                    } else {
                                                                        phi_1899_ = vec3<f32>(_e806[0][1], _e806[0][2], _e806[0][0]);
                                                                    }
                                                                    let _e1107 = phi_1899_;
                                                                    phi_1900_ = _e1107;
                                                                }
                                                                let _e1110 = phi_1900_;
                                                                if _e318 {
                                                                    phi_1917_ = vec3<f32>(_e806[1][0], _e806[1][1], _e806[1][2]);
                                                                } else {
                                                                    if (_e298 == 1u) {
                                                                        phi_1916_ = vec3<f32>(_e806[1][2], _e806[1][0], _e806[1][1]);
                                                                    } else {
                                                                        phi_1916_ = vec3<f32>(_e806[1][1], _e806[1][2], _e806[1][0]);
                                                                    }
                                                                    let _e1115 = phi_1916_;
                                                                    phi_1917_ = _e1115;
                                                                }
                                                                let _e1118 = phi_1917_;
                                                                if _e318 {
                                                                    phi_1934_ = vec3<f32>(_e806[2][0], _e806[2][1], _e806[2][2]);
                                                                } else {
                                                                    if (_e298 == 1u) {
                                                                        phi_1933_ = vec3<f32>(_e806[2][2], _e806[2][0], _e806[2][1]);
                                                                    } else {
                                                                        phi_1933_ = vec3<f32>(_e806[2][1], _e806[2][2], _e806[2][0]);
                                                                    }
                                                                    let _e1123 = phi_1933_;
                                                                    phi_1934_ = _e1123;
                                                                }
                                                                let _e1126 = phi_1934_;
                                                                let _e1129 = (_e1118.x - _e1110.x);
                                                                let _e1132 = (_e1118.y - _e1110.y);
                                                                let _e1135 = (_e1118.z - _e1110.z);
                                                                let _e1137 = (_e1126.x - _e1110.x);
                                                                let _e1139 = (_e1126.y - _e1110.y);
                                                                let _e1141 = (_e1126.z - _e1110.z);
                                                                if (_e183.member_1 == 1u) {
                                                                    phi_1970_ = (vec3<f32>(_e183.member[0], _e183.member[1], _e183.member[2]) - _e1110);
                                                                } else {
                                                                    phi_1970_ = vec3<f32>(_e183.member[0], _e183.member[1], _e183.member[2]);
                                                                }
                                                                let _e1156 = phi_1970_;
                                                                let _e1162 = bitcast<f32>((bitcast<u32>((_e1129 * _e1139)) ^ _e183.member_3[0]));
                                                                let _e1166 = bitcast<f32>((bitcast<u32>((_e1132 * _e1137)) ^ _e183.member_3[0]));
                                                                let _e1170 = bitcast<f32>((bitcast<u32>((_e1132 * _e1141)) ^ _e183.member_3[0]));
                                                                let _e1174 = bitcast<f32>((bitcast<u32>((_e1135 * _e1139)) ^ _e183.member_3[0]));
                                                                let _e1178 = bitcast<f32>((bitcast<u32>((_e1135 * _e1137)) ^ _e183.member_3[0]));
                                                                let _e1182 = bitcast<f32>((bitcast<u32>((_e1129 * _e1141)) ^ _e183.member_3[0]));
                                                                let _e1183 = (_e1170 - _e1174);
                                                                let _e1184 = (_e1178 - _e1182);
                                                                let _e1185 = (_e1162 - _e1166);
                                                                let _e1209 = (bitcast<f32>((bitcast<u32>(_e1170) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1174) & 2147483647u)));
                                                                let _e1216 = (bitcast<f32>((bitcast<u32>(_e1178) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1182) & 2147483647u)));
                                                                let _e1223 = (bitcast<f32>((bitcast<u32>(_e1162) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1166) & 2147483647u)));
                                                                if (_e183.member_2 == 0f) {
                                                                    phi_2152_ = 0f;
                                                                } else {
                                                                    let _e1253 = bitcast<f32>((bitcast<u32>(_e1183) & 2147483647u));
                                                                    let _e1256 = bitcast<f32>((bitcast<u32>(_e1184) & 2147483647u));
                                                                    let _e1259 = bitcast<f32>((bitcast<u32>(_e1185) & 2147483647u));
                                                                    let _e1261 = select(_e1259, _e1256, (_e1256 > _e1259));
                                                                    let _e1265 = select(_e1259, _e1256, (_e1256 < _e1259));
                                                                    let _e1269 = select(_e1256, _e1253, (_e1253 < _e1256));
                                                                    let _e1271 = select(_e1256, _e1253, (_e1253 > _e1256));
                                                                    let _e1273 = select(_e1259, _e1271, (_e1271 < _e1259));
                                                                    phi_2152_ = bitcast<f32>((bitcast<u32>((_e183.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1261, _e1253, (_e1253 > _e1261)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1273, _e1269, (_e1269 > _e1273)))) ^ _e183.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1265, _e1253, (_e1253 < _e1265)))) ^ _e183.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1209 + _e1216) + _e1223))) ^ _e183.member_3[0]))) * 1.0000005f)) ^ _e183.member_3[0])))) ^ _e183.member_3[0]));
                                                                }
                                                                let _e1300 = phi_2152_;
                                                                phi_2170_ = (_e1102 || !(((((bitcast<f32>((bitcast<u32>((_e1156.x * _e1183)) ^ _e183.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1156.y * _e1184)) ^ _e183.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1156.z * _e1185)) ^ _e183.member_3[0]))) * f32(-(_e1101))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1156.x) & 2147483647u)) * _e1209)) ^ _e183.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1156.y) & 2147483647u)) * _e1216)) ^ _e183.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1156.z) & 2147483647u)) * _e1223)) ^ _e183.member_3[0]))))) ^ _e183.member_3[0])) + _e1300) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1314 = phi_2170_;
                                                            phi_2171_ = _e1314;
                                                        }
                                                        let _e1316 = phi_2171_;
                                                        if _e1316 {
                                                            phi_2176_ = type_54(_e707.member, true);
                                                        } else {
                                                            phi_2176_ = _e707;
                                                        }
                                                        let _e1321 = phi_2176_;
                                                        phi_2177_ = _e1321;
                                                    } else {
                                                        phi_2177_ = _e707;
                                                    }
                                                    let _e1323 = phi_2177_;
                                                    phi_1131_ = _e1323;
                                                } else {
                                                    phi_1131_ = type_54();
                                                }
                                                let _e1325 = phi_1131_;
                                                continue;
                                                continuing {
                                                    phi_1130_ = _e1325;
                                                    phi_1133_ = _e722;
                                                    phi_2716_ = _e480;
                                                    break if !(_e728);
                                                }
                                            }
                                            let _e1328 = phi_2716_;
                                            phi_2847_ = _e1328;
                                            if _e1328 {
                                                break;
                                            }
                                            let _e1330 = local_2;
                                            phi_2851_ = _e1328;
                                            let _e1507 = local_4;
                                            phi_2632_ = _e1507;
                                            phi_2633_ = _e505;
                                            phi_2634_ = false;
                                            phi_2635_ = select(_e509, 0u, _e1330.member_1);
                                        } else {
                                            if (_e505 >= _e74) {
                                                phi_2238_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e505 < _e74) {
                                                } else {
                                                    phi_2847_ = true;
                                                    break;
                                                }
                                                let _e519 = (_e298 % 3u);
                                                if (_e519 < 3u) {
                                                } else {
                                                    phi_2847_ = true;
                                                    break;
                                                }
                                                let _e525 = global_3.member[_e505].member[_e519];
                                                let _e531 = (_e297 % 3u);
                                                if (_e531 < 3u) {
                                                } else {
                                                    phi_2847_ = true;
                                                    break;
                                                }
                                                let _e537 = global_3.member[_e505].member[_e531];
                                                let _e543 = (_e299 % 3u);
                                                if (_e543 < 3u) {
                                                } else {
                                                    phi_2847_ = true;
                                                    break;
                                                }
                                                let _e549 = global_3.member[_e505].member[_e543];
                                                let _e559 = global_3.member[_e505].member_1;
                                                let _e563 = global_3.member[_e505].member_2;
                                                phi_2238_ = type_53(array<vec4<f32>, 3>(vec4<f32>(_e525[0], _e525[1], _e525[2], _e525[3]), vec4<f32>(_e537[0], _e537[1], _e537[2], _e537[3]), vec4<f32>(_e549[0], _e549[1], _e549[2], _e549[3])), _e559, _e563);
                                            }
                                            let _e566 = phi_2238_;
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
                                            let _e666 = (_e659 <= select(_e482.member, _e656, (_e656 < _e482.member)));
                                            let _e667 = (_e661 <= select(_e482.member, _e657, (_e657 < _e482.member)));
                                            let _e668 = (_e659 <= _e661);
                                            if _e666 {
                                                if _e667 {
                                                    if _e668 {
                                                        phi_2582_ = _e566.member_2;
                                                    } else {
                                                        phi_2582_ = _e566.member_1;
                                                    }
                                                    let _e672 = phi_2582_;
                                                    let _e673 = (_e509 % 128u);
                                                    let _e674 = (_e673 < 128u);
                                                    if _e674 {
                                                    } else {
                                                        phi_2847_ = true;
                                                        break;
                                                    }
                                                    local_1[_e673] = _e672;
                                                    if _e674 {
                                                    } else {
                                                        phi_2847_ = true;
                                                        break;
                                                    }
                                                    local[_e673] = select(_e661, _e659, (_e659 > _e661));
                                                    if _e668 {
                                                        phi_2609_ = _e566.member_1;
                                                    } else {
                                                        phi_2609_ = _e566.member_2;
                                                    }
                                                    let _e683 = phi_2609_;
                                                    phi_2610_ = _e683;
                                                    phi_2611_ = (_e509 + 1u);
                                                } else {
                                                    phi_2610_ = u32();
                                                    phi_2611_ = u32();
                                                }
                                                let _e685 = phi_2610_;
                                                let _e687 = phi_2611_;
                                                phi_2613_ = _e685;
                                                phi_2614_ = _e687;
                                                phi_2615_ = select(true, false, _e667);
                                            } else {
                                                phi_2613_ = u32();
                                                phi_2614_ = u32();
                                                phi_2615_ = true;
                                            }
                                            let _e690 = phi_2613_;
                                            let _e692 = phi_2614_;
                                            let _e694 = phi_2615_;
                                            if _e694 {
                                                if _e666 {
                                                    phi_2624_ = _e566.member_1;
                                                } else {
                                                    phi_2624_ = _e566.member_2;
                                                }
                                                let _e698 = phi_2624_;
                                                phi_2629_ = _e698;
                                                phi_2630_ = select(_e667, true, _e666);
                                            } else {
                                                phi_2629_ = _e690;
                                                phi_2630_ = _e507;
                                            }
                                            let _e701 = phi_2629_;
                                            let _e703 = phi_2630_;
                                            phi_2851_ = _e480;
                                            phi_2632_ = _e482;
                                            phi_2633_ = _e701;
                                            phi_2634_ = _e703;
                                            phi_2635_ = select(_e692, _e509, _e694);
                                        }
                                        let _e1334 = phi_2851_;
                                        let _e1336 = phi_2632_;
                                        let _e1338 = phi_2633_;
                                        let _e1340 = phi_2634_;
                                        let _e1342 = phi_2635_;
                                        phi_2850_ = _e1334;
                                        phi_2636_ = _e1336;
                                        phi_2637_ = _e1338;
                                        phi_2638_ = (_e486 - 1u);
                                        phi_2639_ = _e1340;
                                        phi_2640_ = _e1342;
                                    } else {
                                        phi_2850_ = _e480;
                                        phi_2636_ = _e482;
                                        phi_2637_ = _e505;
                                        phi_2638_ = _e486;
                                        phi_2639_ = _e507;
                                        phi_2640_ = _e509;
                                    }
                                    let _e1344 = phi_2850_;
                                    let _e1346 = phi_2636_;
                                    let _e1348 = phi_2637_;
                                    let _e1350 = phi_2638_;
                                    let _e1352 = phi_2639_;
                                    let _e1354 = phi_2640_;
                                    phi_2849_ = _e1344;
                                    phi_2641_ = _e1346;
                                    phi_2642_ = _e1348;
                                    phi_2643_ = _e1350;
                                    phi_2644_ = _e1352;
                                    phi_2645_ = _e1354;
                                } else {
                                    phi_2849_ = _e480;
                                    phi_2641_ = type_54();
                                    phi_2642_ = u32();
                                    phi_2643_ = u32();
                                    phi_2644_ = bool();
                                    phi_2645_ = u32();
                                }
                                let _e1356 = phi_2849_;
                                let _e1358 = phi_2641_;
                                let _e1360 = phi_2642_;
                                let _e1362 = phi_2643_;
                                let _e1364 = phi_2644_;
                                let _e1366 = phi_2645_;
                                phi_2848_ = _e1356;
                                phi_1063_ = _e1358;
                                phi_1066_ = _e1360;
                                phi_1068_ = _e1362;
                                phi_1070_ = _e1364;
                                phi_1072_ = _e1366;
                                phi_2646_ = _e494;
                            } else {
                                phi_2848_ = _e480;
                                phi_1063_ = type_54();
                                phi_1066_ = u32();
                                phi_1068_ = u32();
                                phi_1070_ = bool();
                                phi_1072_ = u32();
                                phi_2646_ = false;
                            }
                            let _e1368 = phi_2848_;
                            let _e1370 = phi_1063_;
                            let _e1372 = phi_1066_;
                            let _e1374 = phi_1068_;
                            let _e1376 = phi_1070_;
                            let _e1378 = phi_1072_;
                            let _e1380 = phi_2646_;
                            continue;
                            continuing {
                                phi_2722_ = _e1368;
                                phi_1062_ = _e1370;
                                phi_1065_ = _e1372;
                                phi_1067_ = _e1374;
                                phi_1069_ = _e1376;
                                phi_1071_ = _e1378;
                                phi_2847_ = _e1368;
                                break if !(_e1380);
                            }
                        }
                        let _e1383 = phi_2847_;
                        if _e1383 {
                            break;
                        }
                        let _e1385 = local_3;
                        if _e1385.member_1 {
                        } else {
                            if _e94 {
                            } else {
                                break;
                            }
                            let _e1389 = global_9.member[_e92];
                            if _e93 {
                            } else {
                                break;
                            }
                            let _e1393 = global_8.member[_e92].member_1;
                            if _e94 {
                            } else {
                                break;
                            }
                            global_9.member[_e92] = type_30(_e1389.member, _e1389.member_1, _e1389.member_2, array<f32, 3>((_e1389.member_3[0] + (_e1393[0] * _e1389.member_1[0])), (_e1389.member_3[1] + (_e1393[1] * _e1389.member_1[1])), (_e1389.member_3[2] + (_e1393[2] * _e1389.member_1[2]))), _e1389.member_4);
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
fn trace_shadows_facing(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
