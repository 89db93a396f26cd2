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

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_55 {
    member: f32,
    member_1: bool,
}

struct type_57 {
    member: array<vec4<u32>, 2>,
}

struct type_60 {
    member: array<i32>,
}

struct type_67 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_20;
@group(0) @binding(1) 
var<uniform> global_3: type_57;
@group(0) @binding(2) 
var<storage> global_4: type_39;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage> global_6: type_60;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_67;
@group(0) @binding(6) 
var<storage> global_8: type_44;
@group(0) @binding(7) 
var<storage, read_write> global_9: type_32;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_224_: u32;
    var phi_268_: i32;
    var phi_292_: type_47;
    var phi_442_: i32;
    var phi_443_: i32;
    var phi_453_: bool;
    var phi_463_: u32;
    var phi_464_: u32;
    var phi_466_: bool;
    var phi_471_: u32;
    var phi_503_: i32;
    var phi_521_: f32;
    var phi_527_: f32;
    var phi_538_: f32;
    var phi_544_: f32;
    var phi_567_: f32;
    var phi_578_: f32;
    var phi_587_: f32;
    var phi_593_: f32;
    var phi_604_: f32;
    var phi_610_: f32;
    var phi_633_: f32;
    var phi_644_: f32;
    var phi_653_: f32;
    var phi_659_: f32;
    var phi_670_: f32;
    var phi_676_: f32;
    var phi_699_: f32;
    var phi_710_: f32;
    var phi_810_: f32;
    var phi_811_: f32;
    var phi_2745_: bool;
    var phi_822_: type_55;
    var phi_825_: u32;
    var phi_827_: u32;
    var phi_829_: bool;
    var phi_831_: u32;
    var phi_842_: bool;
    var phi_874_: u32;
    var phi_875_: bool;
    var phi_876_: u32;
    var phi_2263_: type_54;
    var phi_2607_: u32;
    var phi_2635_: u32;
    var phi_2636_: u32;
    var phi_2637_: u32;
    var phi_2639_: u32;
    var phi_2640_: u32;
    var phi_2641_: bool;
    var phi_2650_: u32;
    var phi_2655_: u32;
    var phi_2656_: bool;
    var phi_891_: type_55;
    var phi_894_: type_8;
    var phi_895_: type_8;
    var phi_917_: type_8;
    var phi_938_: u32;
    var phi_1027_: array<array<f32, 3>, 3>;
    var phi_1144_: bool;
    var phi_1173_: bool;
    var phi_1574_: f32;
    var phi_1575_: f32;
    var phi_1576_: f32;
    var phi_1577_: f32;
    var phi_1578_: vec3<f32>;
    var phi_1579_: vec3<f32>;
    var phi_1580_: vec3<f32>;
    var phi_1581_: vec3<f32>;
    var phi_1612_: bool;
    var phi_1621_: vec3<f32>;
    var phi_1786_: f32;
    var phi_1788_: f32;
    var phi_1789_: bool;
    var phi_1809_: f32;
    var phi_1810_: f32;
    var phi_1833_: type_28;
    var phi_1835_: type_28;
    var phi_1836_: bool;
    var phi_1840_: type_28;
    var phi_1841_: type_28;
    var phi_1842_: type_28;
    var phi_1843_: bool;
    var phi_1847_: type_28;
    var phi_1848_: bool;
    var phi_1849_: type_28;
    var phi_1850_: bool;
    var phi_1851_: bool;
    var phi_1852_: type_28;
    var phi_1853_: bool;
    var phi_1854_: bool;
    var phi_1862_: type_28;
    var phi_1863_: bool;
    var phi_1867_: type_28;
    var phi_1890_: u32;
    var phi_1904_: i32;
    var phi_1924_: vec3<f32>;
    var phi_1925_: vec3<f32>;
    var phi_1941_: vec3<f32>;
    var phi_1942_: vec3<f32>;
    var phi_1958_: vec3<f32>;
    var phi_1959_: vec3<f32>;
    var phi_1995_: vec3<f32>;
    var phi_2177_: f32;
    var phi_2195_: bool;
    var phi_2196_: bool;
    var phi_2201_: type_55;
    var phi_2202_: type_55;
    var phi_892_: type_55;
    var phi_2739_: bool;
    var local_2: type_55;
    var phi_2909_: bool;
    var phi_2658_: type_55;
    var phi_2659_: u32;
    var phi_2660_: bool;
    var phi_2661_: u32;
    var phi_2908_: bool;
    var phi_2662_: type_55;
    var phi_2663_: u32;
    var phi_2664_: u32;
    var phi_2665_: bool;
    var phi_2666_: u32;
    var phi_2907_: bool;
    var phi_2667_: type_55;
    var phi_2668_: u32;
    var phi_2669_: u32;
    var phi_2670_: bool;
    var phi_2671_: u32;
    var phi_2906_: bool;
    var phi_823_: type_55;
    var phi_826_: u32;
    var phi_828_: u32;
    var phi_830_: bool;
    var phi_832_: u32;
    var phi_2672_: bool;
    var phi_2905_: bool;
    var local_3: type_55;
    var local_4: type_55;

    switch bitcast<i32>(0u) {
        default: {
            let _e76 = global;
            let _e78 = arrayLength((&global_4.member));
            let _e80 = arrayLength((&global_2.member));
            let _e92 = arrayLength((&global_7.member));
            let _e96 = (_e76.x + (_e76.y * 2097152u));
            let _e97 = (_e96 < arrayLength((&global_8.member)));
            if _e97 {
                if _e97 {
                } else {
                    break;
                }
                let _e101 = global_8.member[_e96].member_2;
                phi_224_ = _e101;
            } else {
                phi_224_ = 4294967295u;
            }
            let _e103 = phi_224_;
            let _e106 = global_1.member[0u];
            let _e110 = global_3.member[0u][0u];
            let _e114 = global_3.member[0u][1u];
            let _e118 = global_3.member[0u][2u];
            let _e122 = global_3.member[0u][3u];
            let _e126 = global_3.member[1u][0u];
            let _e130 = global_3.member[1u][1u];
            let _e134 = global_3.member[1u][2u];
            let _e138 = global_3.member[1u][3u];
            let _e139 = bitcast<f32>(_e110);
            let _e140 = bitcast<f32>(_e114);
            let _e141 = bitcast<f32>(_e118);
            let _e143 = bitcast<f32>(_e126);
            let _e144 = array<u32, 3>(_e130, _e134, _e138);
            let _e146 = bitcast<i32>(_e106);
            if (_e146 < -126i) {
                phi_268_ = -126i;
            } else {
                phi_268_ = select(_e146, 127i, (_e146 > 127i));
            }
            let _e151 = phi_268_;
            let _e156 = bitcast<f32>((bitcast<u32>((_e151 + 127i)) << bitcast<u32>(23i)));
            let _e162 = bitcast<f32>((bitcast<u32>(((_e146 - _e151) + 127i)) << bitcast<u32>(23i)));
            if (_e122 == 0u) {
                phi_292_ = type_47(array<f32, 3>(_e139, _e140, _e141), _e122, _e143, _e144);
            } else {
                phi_292_ = type_47(array<f32, 3>(((_e139 * _e156) * _e162), ((_e140 * _e156) * _e162), ((_e141 * _e156) * _e162)), _e122, ((_e143 * _e156) * _e162), _e144);
            }
            let _e175 = phi_292_;
            if _e97 {
                let _e176 = (_e96 < arrayLength((&global_9.member)));
                if _e176 {
                    if _e97 {
                    } else {
                        break;
                    }
                    let _e181 = global_8.member[_e96].member.member_1;
                    let _e186 = global_8.member[_e96].member.member_3;
                    if (_e181 <= _e186) {
                        let _e188 = (1u < _e92);
                        if _e188 {
                            if (0u < _e92) {
                            } else {
                                break;
                            }
                            let _e192 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e192 + 1u) < _e192) {
                                if _e188 {
                                } else {
                                    break;
                                }
                                let _e197 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e97 {
                        } else {
                            break;
                        }
                        let _e207 = global_8.member[_e96].member.member_2[0u];
                        let _e209 = (bitcast<u32>(_e207) & 2147483647u);
                        let _e215 = global_8.member[_e96].member.member_2[1u];
                        let _e217 = (bitcast<u32>(_e215) & 2147483647u);
                        let _e223 = global_8.member[_e96].member.member_2[2u];
                        let _e225 = (bitcast<u32>(_e223) & 2147483647u);
                        let _e231 = global_8.member[_e96].member.member[0u];
                        let _e233 = (bitcast<u32>(_e231) & 2147483647u);
                        let _e239 = global_8.member[_e96].member.member[1u];
                        let _e241 = (bitcast<u32>(_e239) & 2147483647u);
                        let _e247 = global_8.member[_e96].member.member[2u];
                        let _e249 = (bitcast<u32>(_e247) & 2147483647u);
                        let _e251 = select(_e217, _e209, (_e217 < _e209));
                        let _e253 = select(_e225, _e251, (_e225 < _e251));
                        let _e255 = select(_e233, _e253, (_e233 < _e253));
                        let _e257 = select(_e241, _e255, (_e241 < _e255));
                        let _e259 = select(_e249, _e257, (_e249 < _e257));
                        let _e261 = (bitcast<u32>(_e181) & 2147483647u);
                        let _e270 = (((select(_e261, _e259, (_e261 < _e259)) < 2139095040u) && ((bitcast<u32>(_e186) & 2147483647u) <= 2139095040u)) && (_e253 > 0u));
                        if _e270 {
                            let _e273 = (bitcast<u32>(bitcast<f32>(_e253)) & 2147483647u);
                            if (_e273 >= 8388608u) {
                                phi_442_ = (bitcast<i32>((_e273 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_442_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e273)), 32u, (_e273 == 0u))));
                            }
                            let _e287 = phi_442_;
                            phi_443_ = _e287;
                        } else {
                            phi_443_ = 0i;
                        }
                        let _e289 = phi_443_;
                        let _e290 = (_e209 == _e253);
                        if _e290 {
                            phi_453_ = true;
                        } else {
                            phi_453_ = (_e217 == _e253);
                        }
                        let _e293 = phi_453_;
                        let _e294 = select(1u, 0u, _e290);
                        if _e293 {
                            let _e295 = (_e294 + 1u);
                            phi_463_ = _e295;
                            phi_464_ = _e295;
                            phi_466_ = select(true, false, (_e295 == 2u));
                        } else {
                            phi_463_ = u32();
                            phi_464_ = 0u;
                            phi_466_ = true;
                        }
                        let _e299 = phi_463_;
                        let _e301 = phi_464_;
                        let _e303 = phi_466_;
                        if _e303 {
                            phi_471_ = (_e301 + 1u);
                        } else {
                            phi_471_ = 0u;
                        }
                        let _e307 = phi_471_;
                        let _e308 = select(_e299, _e301, _e303);
                        let _e309 = select(_e294, select(2u, _e294, _e293), _e303);
                        let _e310 = -(_e289);
                        if (_e310 < -126i) {
                            phi_503_ = -126i;
                        } else {
                            phi_503_ = select(_e310, 127i, (_e310 > 127i));
                        }
                        let _e315 = phi_503_;
                        let _e320 = bitcast<f32>((bitcast<u32>((_e315 + 127i)) << bitcast<u32>(23i)));
                        let _e326 = bitcast<f32>((bitcast<u32>(((_e310 - _e315) + 127i)) << bitcast<u32>(23i)));
                        let _e331 = global_8.member[_e96].member.member;
                        let _e332 = (_e308 == 0u);
                        if _e332 {
                            phi_521_ = _e331[0];
                        } else {
                            phi_521_ = _e331[1];
                        }
                        let _e336 = phi_521_;
                        let _e337 = (_e308 == 2u);
                        if _e337 {
                            phi_527_ = _e331[2];
                        } else {
                            phi_527_ = _e336;
                        }
                        let _e340 = phi_527_;
                        let _e341 = global_8.member[_e96].member.member_2;
                        if _e332 {
                            phi_538_ = _e341[0];
                        } else {
                            phi_538_ = _e341[1];
                        }
                        let _e345 = phi_538_;
                        if _e337 {
                            phi_544_ = _e341[2];
                        } else {
                            phi_544_ = _e345;
                        }
                        let _e348 = phi_544_;
                        let _e350 = ((_e348 * _e320) * _e326);
                        let _e354 = (bitcast<f32>((bitcast<u32>(_e350) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e354 {
                            let _e358 = (bitcast<f32>((bitcast<u32>(_e340) & 2147483647u)) * 0.00000011920929f);
                            phi_567_ = select(0.00000000000011368684f, _e358, (_e358 > 0.00000000000011368684f));
                        } else {
                            phi_567_ = 0f;
                        }
                        let _e362 = phi_567_;
                        let _e363 = (_e340 + _e362);
                        let _e364 = (_e340 - _e362);
                        let _e365 = select(_e350, 0f, _e354);
                        if _e354 {
                            phi_578_ = 38685626000000000000000000f;
                        } else {
                            phi_578_ = (1f / _e350);
                        }
                        let _e368 = phi_578_;
                        let _e369 = (_e307 == 0u);
                        if _e369 {
                            phi_587_ = _e331[0];
                        } else {
                            phi_587_ = _e331[1];
                        }
                        let _e373 = phi_587_;
                        let _e374 = (_e307 == 2u);
                        if _e374 {
                            phi_593_ = _e331[2];
                        } else {
                            phi_593_ = _e373;
                        }
                        let _e377 = phi_593_;
                        if _e369 {
                            phi_604_ = _e341[0];
                        } else {
                            phi_604_ = _e341[1];
                        }
                        let _e381 = phi_604_;
                        if _e374 {
                            phi_610_ = _e341[2];
                        } else {
                            phi_610_ = _e381;
                        }
                        let _e384 = phi_610_;
                        let _e386 = ((_e384 * _e320) * _e326);
                        let _e390 = (bitcast<f32>((bitcast<u32>(_e386) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e390 {
                            let _e394 = (bitcast<f32>((bitcast<u32>(_e377) & 2147483647u)) * 0.00000011920929f);
                            phi_633_ = select(0.00000000000011368684f, _e394, (_e394 > 0.00000000000011368684f));
                        } else {
                            phi_633_ = 0f;
                        }
                        let _e398 = phi_633_;
                        let _e399 = (_e377 + _e398);
                        let _e400 = (_e377 - _e398);
                        let _e401 = select(_e386, 0f, _e390);
                        if _e390 {
                            phi_644_ = 38685626000000000000000000f;
                        } else {
                            phi_644_ = (1f / _e386);
                        }
                        let _e404 = phi_644_;
                        let _e405 = (_e309 == 0u);
                        if _e405 {
                            phi_653_ = _e331[0];
                        } else {
                            phi_653_ = _e331[1];
                        }
                        let _e409 = phi_653_;
                        let _e410 = (_e309 == 2u);
                        if _e410 {
                            phi_659_ = _e331[2];
                        } else {
                            phi_659_ = _e409;
                        }
                        let _e413 = phi_659_;
                        if _e405 {
                            phi_670_ = _e341[0];
                        } else {
                            phi_670_ = _e341[1];
                        }
                        let _e417 = phi_670_;
                        if _e410 {
                            phi_676_ = _e341[2];
                        } else {
                            phi_676_ = _e417;
                        }
                        let _e420 = phi_676_;
                        let _e422 = ((_e420 * _e320) * _e326);
                        let _e426 = (bitcast<f32>((bitcast<u32>(_e422) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e426 {
                            let _e430 = (bitcast<f32>((bitcast<u32>(_e413) & 2147483647u)) * 0.00000011920929f);
                            phi_699_ = select(0.00000000000011368684f, _e430, (_e430 > 0.00000000000011368684f));
                        } else {
                            phi_699_ = 0f;
                        }
                        let _e434 = phi_699_;
                        let _e435 = (_e413 + _e434);
                        let _e436 = (_e413 - _e434);
                        let _e437 = select(_e422, 0f, _e426);
                        if _e426 {
                            phi_710_ = 38685626000000000000000000f;
                        } else {
                            phi_710_ = (1f / _e422);
                        }
                        let _e440 = phi_710_;
                        let _e443 = bitcast<f32>((bitcast<u32>(_e340) & 2147483647u));
                        let _e446 = bitcast<f32>((bitcast<u32>(_e377) & 2147483647u));
                        let _e448 = select(_e446, _e443, (_e443 > _e446));
                        let _e451 = bitcast<f32>((bitcast<u32>(_e413) & 2147483647u));
                        if (_e270 && (select(_e451, _e448, (_e448 > _e451)) <= 1099511600000f)) {
                            let _e456 = (_e289 / 3i);
                            let _e463 = bitcast<f32>((bitcast<u32>((_e456 + 127i)) << bitcast<u32>(23i)));
                            let _e470 = bitcast<f32>((bitcast<u32>(((_e289 - (2i * _e456)) + 127i)) << bitcast<u32>(23i)));
                            let _e471 = (((_e181 * _e463) * _e463) * _e470);
                            let _e473 = select(340282350000000000000000000000000000000f, _e471, (_e471 < 340282350000000000000000000000000000000f));
                            let _e478 = (((_e186 * _e463) * _e463) * _e470);
                            let _e480 = select(340282350000000000000000000000000000000f, _e478, (_e478 < 340282350000000000000000000000000000000f));
                            phi_810_ = select(-340282350000000000000000000000000000000f, _e480, (_e480 > -340282350000000000000000000000000000000f));
                            phi_811_ = select(-340282350000000000000000000000000000000f, _e473, (_e473 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_810_ = 0f;
                            phi_811_ = 1f;
                        }
                        let _e484 = phi_810_;
                        let _e486 = phi_811_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2745_ = false;
                        phi_822_ = type_55(_e484, false);
                        phi_825_ = select(0u, 2147483648u, (_e78 == 0u));
                        phi_827_ = ((3u * _e78) + 1u);
                        phi_829_ = (_e486 <= _e484);
                        phi_831_ = 0u;
                        loop {
                            let _e494 = phi_2745_;
                            let _e496 = phi_822_;
                            let _e498 = phi_825_;
                            let _e500 = phi_827_;
                            let _e502 = phi_829_;
                            let _e504 = phi_831_;
                            local_3 = _e496;
                            if _e502 {
                                phi_842_ = true;
                            } else {
                                phi_842_ = (_e504 > 0u);
                            }
                            let _e507 = phi_842_;
                            if _e507 {
                                let _e508 = (_e500 > 0u);
                                if _e508 {
                                    if _e502 {
                                        phi_874_ = _e498;
                                        phi_875_ = _e502;
                                        phi_876_ = _e504;
                                    } else {
                                        let _e509 = (_e504 - 1u);
                                        let _e510 = (_e509 % 128u);
                                        let _e511 = (_e510 < 128u);
                                        if _e511 {
                                        } else {
                                            phi_2905_ = true;
                                            break;
                                        }
                                        let _e513 = local_1[_e510];
                                        if _e511 {
                                        } else {
                                            phi_2905_ = true;
                                            break;
                                        }
                                        let _e515 = local[_e510];
                                        phi_874_ = _e513;
                                        phi_875_ = (_e515 <= _e496.member);
                                        phi_876_ = _e509;
                                    }
                                    let _e519 = phi_874_;
                                    let _e521 = phi_875_;
                                    let _e523 = phi_876_;
                                    if _e521 {
                                        if ((_e519 & 2147483648u) != 0u) {
                                            phi_891_ = _e496;
                                            phi_894_ = type_8(0u, ((_e519 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e721 = phi_891_;
                                                let _e723 = phi_894_;
                                                local_2 = _e721;
                                                local_4 = _e721;
                                                if (_e723.member < _e723.member_1) {
                                                    phi_895_ = type_8((_e723.member + 1u), _e723.member_1);
                                                    phi_917_ = type_8(1u, _e723.member);
                                                } else {
                                                    phi_895_ = _e723;
                                                    phi_917_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e736 = phi_895_;
                                                let _e738 = phi_917_;
                                                let _e742 = (bitcast<i32>(_e738.member) != 0i);
                                                if _e742 {
                                                    let _e743 = ((_e519 & 268435455u) + _e738.member_1);
                                                    let _e744 = (_e743 < _e80);
                                                    if _e744 {
                                                        if _e744 {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e748 = global_2.member[_e743].member_1;
                                                        phi_938_ = _e748;
                                                    } else {
                                                        phi_938_ = 4294967295u;
                                                    }
                                                    let _e750 = phi_938_;
                                                    if (_e743 >= _e80) {
                                                        phi_1027_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e744 {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e752 = (_e308 % 3u);
                                                        let _e753 = (_e307 % 3u);
                                                        let _e754 = (_e309 % 3u);
                                                        if (_e752 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e760 = global_2.member[_e743].member[_e752];
                                                        if (_e753 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e766 = global_2.member[_e743].member[_e753];
                                                        if (_e754 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e772 = global_2.member[_e743].member[_e754];
                                                        let _e774 = (3u + _e752);
                                                        if (_e774 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e780 = global_2.member[_e743].member[_e774];
                                                        let _e781 = (3u + _e753);
                                                        if (_e781 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e787 = global_2.member[_e743].member[_e781];
                                                        let _e788 = (3u + _e754);
                                                        if (_e788 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e794 = global_2.member[_e743].member[_e788];
                                                        let _e796 = (6u + _e752);
                                                        if (_e796 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e802 = global_2.member[_e743].member[_e796];
                                                        let _e803 = (6u + _e753);
                                                        if (_e803 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e809 = global_2.member[_e743].member[_e803];
                                                        let _e810 = (6u + _e754);
                                                        if (_e810 < 9u) {
                                                        } else {
                                                            phi_2739_ = true;
                                                            break;
                                                        }
                                                        let _e816 = global_2.member[_e743].member[_e810];
                                                        phi_1027_ = array<array<f32, 3>, 3>(array<f32, 3>(_e760, _e766, _e772), array<f32, 3>(_e780, _e787, _e794), array<f32, 3>(_e802, _e809, _e816));
                                                    }
                                                    let _e820 = phi_1027_;
                                                    let _e828 = (_e820[0][2] - _e413);
                                                    let _e831 = (((_e820[0][0] - _e340) * _e437) - (_e828 * _e365));
                                                    let _e834 = (((_e820[0][1] - _e377) * _e437) - (_e828 * _e401));
                                                    let _e841 = (_e820[1][2] - _e413);
                                                    let _e844 = (((_e820[1][0] - _e340) * _e437) - (_e841 * _e365));
                                                    let _e847 = (((_e820[1][1] - _e377) * _e437) - (_e841 * _e401));
                                                    let _e854 = (_e820[2][2] - _e413);
                                                    let _e857 = (((_e820[2][0] - _e340) * _e437) - (_e854 * _e365));
                                                    let _e860 = (((_e820[2][1] - _e377) * _e437) - (_e854 * _e401));
                                                    let _e861 = (_e857 * _e847);
                                                    let _e862 = (_e860 * _e844);
                                                    let _e863 = (_e831 * _e860);
                                                    let _e864 = (_e834 * _e857);
                                                    let _e865 = (_e844 * _e834);
                                                    let _e866 = (_e847 * _e831);
                                                    let _e871 = (((_e861 >= _e862) && (_e863 >= _e864)) && (_e865 >= _e866));
                                                    if (_e871 || (((_e861 <= _e862) && (_e863 <= _e864)) && (_e865 <= _e866))) {
                                                        let _e878 = select(-1f, 1f, _e871);
                                                        let _e880 = ((_e861 - _e862) * _e878);
                                                        let _e882 = select(0f, _e880, (_e880 > 0f));
                                                        let _e884 = ((_e863 - _e864) * _e878);
                                                        let _e886 = select(0f, _e884, (_e884 > 0f));
                                                        let _e888 = ((_e865 - _e866) * _e878);
                                                        let _e890 = select(0f, _e888, (_e888 > 0f));
                                                        let _e892 = ((_e882 + _e886) + _e890);
                                                        if (_e892 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1852_ = type_28();
                                                            phi_1853_ = true;
                                                            phi_1854_ = false;
                                                        } else {
                                                            let _e895 = select(_e844, _e831, (_e831 < _e844));
                                                            if (select(_e857, _e895, (_e895 < _e857)) > 0f) {
                                                                phi_1144_ = true;
                                                            } else {
                                                                let _e900 = select(_e844, _e831, (_e831 > _e844));
                                                                phi_1144_ = (select(_e857, _e900, (_e900 > _e857)) < 0f);
                                                            }
                                                            let _e905 = phi_1144_;
                                                            if _e905 {
                                                                phi_1849_ = type_28();
                                                                phi_1850_ = true;
                                                                phi_1851_ = false;
                                                            } else {
                                                                let _e907 = select(_e847, _e834, (_e834 < _e847));
                                                                if (select(_e860, _e907, (_e907 < _e860)) > 0f) {
                                                                    phi_1173_ = true;
                                                                } else {
                                                                    let _e912 = select(_e847, _e834, (_e834 > _e847));
                                                                    phi_1173_ = (select(_e860, _e912, (_e912 > _e860)) < 0f);
                                                                }
                                                                let _e917 = phi_1173_;
                                                                if _e917 {
                                                                    phi_1847_ = type_28();
                                                                    phi_1848_ = false;
                                                                } else {
                                                                    let _e919 = select(_e820[1][0], _e820[0][0], (_e820[0][0] < _e820[1][0]));
                                                                    let _e923 = select(_e820[1][0], _e820[0][0], (_e820[0][0] > _e820[1][0]));
                                                                    let _e927 = select(_e820[1][1], _e820[0][1], (_e820[0][1] < _e820[1][1]));
                                                                    let _e931 = select(_e820[1][1], _e820[0][1], (_e820[0][1] > _e820[1][1]));
                                                                    let _e935 = select(_e820[1][2], _e820[0][2], (_e820[0][2] < _e820[1][2]));
                                                                    let _e939 = select(_e820[1][2], _e820[0][2], (_e820[0][2] > _e820[1][2]));
                                                                    let _e944 = ((select(_e820[2][0], _e919, (_e919 < _e820[2][0])) - _e363) * _e368);
                                                                    let _e945 = ((select(_e820[2][0], _e923, (_e923 > _e820[2][0])) - _e364) * _e368);
                                                                    let _e948 = ((select(_e820[2][1], _e927, (_e927 < _e820[2][1])) - _e399) * _e404);
                                                                    let _e949 = ((select(_e820[2][1], _e931, (_e931 > _e820[2][1])) - _e400) * _e404);
                                                                    let _e952 = ((select(_e820[2][2], _e935, (_e935 < _e820[2][2])) - _e435) * _e440);
                                                                    let _e953 = ((select(_e820[2][2], _e939, (_e939 > _e820[2][2])) - _e436) * _e440);
                                                                    let _e955 = select(_e953, _e952, (_e952 < _e953));
                                                                    let _e957 = select(_e953, _e952, (_e952 > _e953));
                                                                    let _e959 = select(_e945, _e944, (_e944 < _e945));
                                                                    let _e961 = select(_e949, _e948, (_e948 < _e949));
                                                                    let _e963 = select(_e961, _e959, (_e959 > _e961));
                                                                    let _e965 = select(_e955, _e963, (_e963 > _e955));
                                                                    let _e967 = select(_e945, _e944, (_e944 > _e945));
                                                                    let _e969 = select(_e949, _e948, (_e948 > _e949));
                                                                    let _e971 = select(_e969, _e967, (_e967 < _e969));
                                                                    let _e973 = select(_e957, _e971, (_e971 < _e957));
                                                                    let _e974 = -(_e955);
                                                                    let _e980 = select(_e486, _e965, (_e965 > _e486));
                                                                    if (_e980 > (_e973 + (select(_e974, _e957, (_e957 > _e974)) * 0.0000019073523f))) {
                                                                        phi_1842_ = type_28();
                                                                        phi_1843_ = true;
                                                                    } else {
                                                                        let _e982 = (_e980 > _e721.member);
                                                                        if _e982 {
                                                                            phi_1841_ = type_28();
                                                                        } else {
                                                                            let _e983 = vec3<f32>(_e820[0][0], _e820[0][1], _e820[0][2]);
                                                                            let _e984 = vec3<f32>(_e820[1][0], _e820[1][1], _e820[1][2]);
                                                                            let _e985 = vec3<f32>(_e820[2][0], _e820[2][1], _e820[2][2]);
                                                                            let _e986 = (_e820[1][0] - _e820[0][0]);
                                                                            let _e987 = (_e820[1][1] - _e820[0][1]);
                                                                            let _e988 = (_e820[1][2] - _e820[0][2]);
                                                                            let _e989 = vec3<f32>(_e986, _e987, _e988);
                                                                            let _e990 = (_e820[2][0] - _e820[1][0]);
                                                                            let _e991 = (_e820[2][1] - _e820[1][1]);
                                                                            let _e992 = (_e820[2][2] - _e820[1][2]);
                                                                            let _e993 = vec3<f32>(_e990, _e991, _e992);
                                                                            let _e994 = (_e820[0][0] - _e820[2][0]);
                                                                            let _e995 = (_e820[0][1] - _e820[2][1]);
                                                                            let _e996 = (_e820[0][2] - _e820[2][2]);
                                                                            let _e997 = vec3<f32>(_e994, _e995, _e996);
                                                                            let _e1000 = bitcast<f32>((bitcast<u32>(_e986) & 2147483647u));
                                                                            let _e1003 = bitcast<f32>((bitcast<u32>(_e987) & 2147483647u));
                                                                            let _e1005 = select(_e1003, _e1000, (_e1000 > _e1003));
                                                                            let _e1008 = bitcast<f32>((bitcast<u32>(_e988) & 2147483647u));
                                                                            let _e1010 = select(_e1008, _e1005, (_e1005 > _e1008));
                                                                            let _e1013 = bitcast<f32>((bitcast<u32>(_e990) & 2147483647u));
                                                                            let _e1016 = bitcast<f32>((bitcast<u32>(_e991) & 2147483647u));
                                                                            let _e1018 = select(_e1016, _e1013, (_e1013 > _e1016));
                                                                            let _e1021 = bitcast<f32>((bitcast<u32>(_e992) & 2147483647u));
                                                                            let _e1023 = select(_e1021, _e1018, (_e1018 > _e1021));
                                                                            let _e1026 = bitcast<f32>((bitcast<u32>(_e994) & 2147483647u));
                                                                            let _e1029 = bitcast<f32>((bitcast<u32>(_e995) & 2147483647u));
                                                                            let _e1031 = select(_e1029, _e1026, (_e1026 > _e1029));
                                                                            let _e1034 = bitcast<f32>((bitcast<u32>(_e996) & 2147483647u));
                                                                            let _e1036 = select(_e1034, _e1031, (_e1031 > _e1034));
                                                                            let _e1038 = select(_e1023, _e1010, (_e1010 > _e1023));
                                                                            let _e1040 = select(_e1036, _e1038, (_e1038 > _e1036));
                                                                            if (_e1010 == _e1040) {
                                                                                phi_1574_ = _e847;
                                                                                phi_1575_ = _e844;
                                                                                phi_1576_ = _e834;
                                                                                phi_1577_ = _e831;
                                                                                phi_1578_ = _e983;
                                                                                phi_1579_ = _e997;
                                                                                phi_1580_ = _e993;
                                                                                phi_1581_ = _e989;
                                                                            } else {
                                                                                let _e1042 = (_e1023 == _e1040);
                                                                                let _e1047 = vec3(_e1042);
                                                                                phi_1574_ = select(_e834, _e860, _e1042);
                                                                                phi_1575_ = select(_e831, _e857, _e1042);
                                                                                phi_1576_ = select(_e860, _e847, _e1042);
                                                                                phi_1577_ = select(_e857, _e844, _e1042);
                                                                                phi_1578_ = select(_e985, _e984, _e1047);
                                                                                phi_1579_ = select(_e993, _e989, _e1047);
                                                                                phi_1580_ = select(_e989, _e997, _e1047);
                                                                                phi_1581_ = select(_e997, _e993, _e1047);
                                                                            }
                                                                            let _e1053 = phi_1574_;
                                                                            let _e1055 = phi_1575_;
                                                                            let _e1057 = phi_1576_;
                                                                            let _e1059 = phi_1577_;
                                                                            let _e1061 = phi_1578_;
                                                                            let _e1063 = phi_1579_;
                                                                            let _e1065 = phi_1580_;
                                                                            let _e1067 = phi_1581_;
                                                                            let _e1074 = ((_e1065.y * _e1063.z) - (_e1063.y * _e1065.z));
                                                                            let _e1079 = ((_e1065.z * _e1063.x) - (_e1063.z * _e1065.x));
                                                                            let _e1082 = ((_e1065.x * _e1063.y) - (_e1063.x * _e1065.y));
                                                                            if (_e882 >= _e886) {
                                                                                phi_1612_ = select(true, false, (_e882 >= _e890));
                                                                            } else {
                                                                                phi_1612_ = true;
                                                                            }
                                                                            let _e1087 = phi_1612_;
                                                                            if _e1087 {
                                                                                phi_1621_ = select(_e985, _e984, vec3((_e886 >= _e890)));
                                                                            } else {
                                                                                phi_1621_ = _e983;
                                                                            }
                                                                            let _e1092 = phi_1621_;
                                                                            let _e1103 = (((_e1074 * (_e1092.x - _e340)) + (_e1079 * (_e1092.y - _e377))) + (_e1082 * (_e1092.z - _e413)));
                                                                            let _e1108 = (((_e1074 * _e365) + (_e1079 * _e401)) + (_e1082 * _e437));
                                                                            let _e1109 = (_e1055 - _e1059);
                                                                            let _e1110 = (_e1053 - _e1057);
                                                                            let _e1118 = (-(((_e1059 * _e1109) + (_e1057 * _e1110))) / ((_e1109 * _e1109) + (_e1110 * _e1110)));
                                                                            let _e1120 = select(1f, _e1118, (_e1118 < 1f));
                                                                            let _e1122 = select(0f, _e1120, (_e1120 > 0f));
                                                                            let _e1135 = ((_e1061.x + (_e1067.x * _e1122)) - _e340);
                                                                            let _e1136 = ((_e1061.y + (_e1067.y * _e1122)) - _e377);
                                                                            let _e1137 = ((_e1061.z + (_e1067.z * _e1122)) - _e413);
                                                                            let _e1138 = (_e1137 / _e437);
                                                                            let _e1150 = bitcast<f32>((bitcast<u32>(_e1135) & 2147483647u));
                                                                            let _e1153 = bitcast<f32>((bitcast<u32>(_e1136) & 2147483647u));
                                                                            let _e1155 = select(_e1153, _e1150, (_e1150 > _e1153));
                                                                            let _e1158 = bitcast<f32>((bitcast<u32>(_e1137) & 2147483647u));
                                                                            let _e1160 = select(_e1158, _e1155, (_e1155 > _e1158));
                                                                            let _e1166 = bitcast<f32>((bitcast<u32>(_e1074) & 2147483647u));
                                                                            let _e1169 = bitcast<f32>((bitcast<u32>(_e1079) & 2147483647u));
                                                                            let _e1171 = select(_e1169, _e1166, (_e1166 > _e1169));
                                                                            let _e1174 = bitcast<f32>((bitcast<u32>(_e1082) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1074 * _e1135) + (_e1079 * _e1136)) + (_e1082 * _e1137)) - _e1103)) & 2147483647u)) <= ((0.0000009536743f * select(_e1040, _e1160, (_e1160 > _e1040))) * select(_e1174, _e1171, (_e1171 > _e1174)))) {
                                                                                let _e1184 = bitcast<f32>((bitcast<u32>(_e1065.x) & 2147483647u));
                                                                                let _e1187 = bitcast<f32>((bitcast<u32>(_e1065.y) & 2147483647u));
                                                                                let _e1189 = select(_e1187, _e1184, (_e1184 > _e1187));
                                                                                let _e1192 = bitcast<f32>((bitcast<u32>(_e1065.z) & 2147483647u));
                                                                                let _e1198 = bitcast<f32>((bitcast<u32>(_e1063.x) & 2147483647u));
                                                                                let _e1201 = bitcast<f32>((bitcast<u32>(_e1063.y) & 2147483647u));
                                                                                let _e1203 = select(_e1201, _e1198, (_e1198 > _e1201));
                                                                                let _e1206 = bitcast<f32>((bitcast<u32>(_e1063.z) & 2147483647u));
                                                                                let _e1210 = (bitcast<f32>((bitcast<u32>(_e1108) & 2147483647u)) > ((0.0000038146973f * select(_e1192, _e1189, (_e1189 > _e1192))) * select(_e1206, _e1203, (_e1203 > _e1206))));
                                                                                if _e1210 {
                                                                                    phi_1786_ = (_e1103 / _e1108);
                                                                                } else {
                                                                                    phi_1786_ = f32();
                                                                                }
                                                                                let _e1213 = phi_1786_;
                                                                                phi_1788_ = _e1213;
                                                                                phi_1789_ = select(true, false, _e1210);
                                                                            } else {
                                                                                phi_1788_ = f32();
                                                                                phi_1789_ = true;
                                                                            }
                                                                            let _e1216 = phi_1788_;
                                                                            let _e1218 = phi_1789_;
                                                                            if _e1218 {
                                                                                let _e1226 = (((_e1074 * (_e1135 - (_e365 * _e1138))) + (_e1079 * (_e1136 - (_e401 * _e1138)))) / _e1108);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1226) & 2147483647u)) <= _e1040) {
                                                                                    phi_1809_ = (_e1138 + _e1226);
                                                                                } else {
                                                                                    phi_1809_ = _e1138;
                                                                                }
                                                                                let _e1233 = phi_1809_;
                                                                                phi_1810_ = _e1233;
                                                                            } else {
                                                                                phi_1810_ = _e1216;
                                                                            }
                                                                            let _e1235 = phi_1810_;
                                                                            let _e1237 = select(_e973, _e1235, (_e1235 < _e973));
                                                                            let _e1239 = select(_e965, _e1237, (_e1237 > _e965));
                                                                            if (_e1239 >= _e486) {
                                                                                let _e1241 = (_e1239 <= _e721.member);
                                                                                if _e1241 {
                                                                                    let _e1242 = (1f / _e892);
                                                                                    phi_1833_ = type_28(_e1239, (_e886 * _e1242), (_e890 * _e1242), _e750);
                                                                                } else {
                                                                                    phi_1833_ = type_28();
                                                                                }
                                                                                let _e1247 = phi_1833_;
                                                                                phi_1835_ = _e1247;
                                                                                phi_1836_ = select(true, false, _e1241);
                                                                            } else {
                                                                                phi_1835_ = type_28();
                                                                                phi_1836_ = true;
                                                                            }
                                                                            let _e1250 = phi_1835_;
                                                                            let _e1252 = phi_1836_;
                                                                            if _e1252 {
                                                                                phi_1840_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_1840_ = _e1250;
                                                                            }
                                                                            let _e1254 = phi_1840_;
                                                                            phi_1841_ = _e1254;
                                                                        }
                                                                        let _e1256 = phi_1841_;
                                                                        phi_1842_ = _e1256;
                                                                        phi_1843_ = _e982;
                                                                    }
                                                                    let _e1258 = phi_1842_;
                                                                    let _e1260 = phi_1843_;
                                                                    phi_1847_ = _e1258;
                                                                    phi_1848_ = _e1260;
                                                                }
                                                                let _e1262 = phi_1847_;
                                                                let _e1264 = phi_1848_;
                                                                phi_1849_ = _e1262;
                                                                phi_1850_ = _e917;
                                                                phi_1851_ = _e1264;
                                                            }
                                                            let _e1266 = phi_1849_;
                                                            let _e1268 = phi_1850_;
                                                            let _e1270 = phi_1851_;
                                                            phi_1852_ = _e1266;
                                                            phi_1853_ = _e1268;
                                                            phi_1854_ = _e1270;
                                                        }
                                                        let _e1272 = phi_1852_;
                                                        let _e1274 = phi_1853_;
                                                        let _e1276 = phi_1854_;
                                                        phi_1862_ = _e1272;
                                                        phi_1863_ = select(_e1276, true, _e1274);
                                                    } else {
                                                        phi_1862_ = type_28();
                                                        phi_1863_ = true;
                                                    }
                                                    let _e1279 = phi_1862_;
                                                    let _e1281 = phi_1863_;
                                                    if _e1281 {
                                                        phi_1867_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1867_ = _e1279;
                                                    }
                                                    let _e1283 = phi_1867_;
                                                    if (_e1283.member_3 != 4294967295u) {
                                                        if (_e750 == _e103) {
                                                            phi_2196_ = false;
                                                        } else {
                                                            let _e1287 = (_e750 < arrayLength((&global_5.member)));
                                                            if _e1287 {
                                                                if _e1287 {
                                                                } else {
                                                                    phi_2739_ = true;
                                                                    break;
                                                                }
                                                                let _e1289 = global_5.member[_e750];
                                                                phi_1890_ = _e1289;
                                                            } else {
                                                                phi_1890_ = 4294967295u;
                                                            }
                                                            let _e1291 = phi_1890_;
                                                            let _e1292 = (_e1291 < arrayLength((&global_6.member)));
                                                            if _e1292 {
                                                                if _e1292 {
                                                                } else {
                                                                    phi_2739_ = true;
                                                                    break;
                                                                }
                                                                let _e1294 = global_6.member[_e1291];
                                                                phi_1904_ = _e1294;
                                                            } else {
                                                                phi_1904_ = 0i;
                                                            }
                                                            let _e1296 = phi_1904_;
                                                            let _e1297 = (_e1296 == 0i);
                                                            if _e1297 {
                                                                phi_2195_ = true;
                                                            } else {
                                                                if _e332 {
                                                                    phi_1925_ = vec3<f32>(_e820[0][0], _e820[0][1], _e820[0][2]);
                                                                } else {
                                                                    if (_e308 == 1u) {
                                                                        phi_1924_ = vec3<f32>(_e820[0][2], _e820[0][0], _e820[0][1]);
                                                                    } else {
                                                                        phi_1924_ = vec3<f32>(_e820[0][1], _e820[0][2], _e820[0][0]);
                                                                    }
                                                                    let _e1302 = phi_1924_;
                                                                    phi_1925_ = _e1302;
                                                                }
                                                                let _e1305 = phi_1925_;
                                                                if _e332 {
                                                                    phi_1942_ = vec3<f32>(_e820[1][0], _e820[1][1], _e820[1][2]);
                                                                } else {
                                                                    if (_e308 == 1u) {
                                                                        phi_1941_ = vec3<f32>(_e820[1][2], _e820[1][0], _e820[1][1]);
                                                                    } else {
                                                                        phi_1941_ = vec3<f32>(_e820[1][1], _e820[1][2], _e820[1][0]);
                                                                    }
                                                                    let _e1310 = phi_1941_;
                                                                    phi_1942_ = _e1310;
                                                                }
                                                                let _e1313 = phi_1942_;
                                                                if _e332 {
                                                                    phi_1959_ = vec3<f32>(_e820[2][0], _e820[2][1], _e820[2][2]);
                                                                } else {
                                                                    if (_e308 == 1u) {
                                                                        phi_1958_ = vec3<f32>(_e820[2][2], _e820[2][0], _e820[2][1]);
                                                                    } else {
                                                                        phi_1958_ = vec3<f32>(_e820[2][1], _e820[2][2], _e820[2][0]);
                                                                    }
                                                                    let _e1318 = phi_1958_;
                                                                    phi_1959_ = _e1318;
                                                                }
                                                                let _e1321 = phi_1959_;
                                                                let _e1324 = (_e1313.x - _e1305.x);
                                                                let _e1327 = (_e1313.y - _e1305.y);
                                                                let _e1330 = (_e1313.z - _e1305.z);
                                                                let _e1332 = (_e1321.x - _e1305.x);
                                                                let _e1334 = (_e1321.y - _e1305.y);
                                                                let _e1336 = (_e1321.z - _e1305.z);
                                                                if (_e175.member_1 == 1u) {
                                                                    phi_1995_ = (vec3<f32>(_e175.member[0], _e175.member[1], _e175.member[2]) - _e1305);
                                                                } else {
                                                                    phi_1995_ = vec3<f32>(_e175.member[0], _e175.member[1], _e175.member[2]);
                                                                }
                                                                let _e1351 = phi_1995_;
                                                                let _e1357 = bitcast<f32>((bitcast<u32>((_e1324 * _e1334)) ^ _e175.member_3[0]));
                                                                let _e1361 = bitcast<f32>((bitcast<u32>((_e1327 * _e1332)) ^ _e175.member_3[0]));
                                                                let _e1365 = bitcast<f32>((bitcast<u32>((_e1327 * _e1336)) ^ _e175.member_3[0]));
                                                                let _e1369 = bitcast<f32>((bitcast<u32>((_e1330 * _e1334)) ^ _e175.member_3[0]));
                                                                let _e1373 = bitcast<f32>((bitcast<u32>((_e1330 * _e1332)) ^ _e175.member_3[0]));
                                                                let _e1377 = bitcast<f32>((bitcast<u32>((_e1324 * _e1336)) ^ _e175.member_3[0]));
                                                                let _e1378 = (_e1365 - _e1369);
                                                                let _e1379 = (_e1373 - _e1377);
                                                                let _e1380 = (_e1357 - _e1361);
                                                                let _e1404 = (bitcast<f32>((bitcast<u32>(_e1365) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1369) & 2147483647u)));
                                                                let _e1411 = (bitcast<f32>((bitcast<u32>(_e1373) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1377) & 2147483647u)));
                                                                let _e1418 = (bitcast<f32>((bitcast<u32>(_e1357) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1361) & 2147483647u)));
                                                                if (_e175.member_2 == 0f) {
                                                                    phi_2177_ = 0f;
                                                                } else {
                                                                    let _e1448 = bitcast<f32>((bitcast<u32>(_e1378) & 2147483647u));
                                                                    let _e1451 = bitcast<f32>((bitcast<u32>(_e1379) & 2147483647u));
                                                                    let _e1454 = bitcast<f32>((bitcast<u32>(_e1380) & 2147483647u));
                                                                    let _e1456 = select(_e1454, _e1451, (_e1451 > _e1454));
                                                                    let _e1460 = select(_e1454, _e1451, (_e1451 < _e1454));
                                                                    let _e1464 = select(_e1451, _e1448, (_e1448 < _e1451));
                                                                    let _e1466 = select(_e1451, _e1448, (_e1448 > _e1451));
                                                                    let _e1468 = select(_e1454, _e1466, (_e1466 < _e1454));
                                                                    phi_2177_ = bitcast<f32>((bitcast<u32>((_e175.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1456, _e1448, (_e1448 > _e1456)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1468, _e1464, (_e1464 > _e1468)))) ^ _e175.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1460, _e1448, (_e1448 < _e1460)))) ^ _e175.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1404 + _e1411) + _e1418))) ^ _e175.member_3[0]))) * 1.0000005f)) ^ _e175.member_3[0])))) ^ _e175.member_3[0]));
                                                                }
                                                                let _e1495 = phi_2177_;
                                                                phi_2195_ = (_e1297 || !(((((bitcast<f32>((bitcast<u32>((_e1351.x * _e1378)) ^ _e175.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1351.y * _e1379)) ^ _e175.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1351.z * _e1380)) ^ _e175.member_3[0]))) * f32(-(_e1296))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1351.x) & 2147483647u)) * _e1404)) ^ _e175.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1351.y) & 2147483647u)) * _e1411)) ^ _e175.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1351.z) & 2147483647u)) * _e1418)) ^ _e175.member_3[0]))))) ^ _e175.member_3[0])) + _e1495) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1509 = phi_2195_;
                                                            phi_2196_ = _e1509;
                                                        }
                                                        let _e1511 = phi_2196_;
                                                        if _e1511 {
                                                            phi_2201_ = type_55(_e721.member, true);
                                                        } else {
                                                            phi_2201_ = _e721;
                                                        }
                                                        let _e1516 = phi_2201_;
                                                        phi_2202_ = _e1516;
                                                    } else {
                                                        phi_2202_ = _e721;
                                                    }
                                                    let _e1518 = phi_2202_;
                                                    phi_892_ = _e1518;
                                                } else {
                                                    phi_892_ = type_55();
                                                }
                                                let _e1520 = phi_892_;
                                                continue;
                                                continuing {
                                                    phi_891_ = _e1520;
                                                    phi_894_ = _e736;
                                                    phi_2739_ = _e494;
                                                    break if !(_e742);
                                                }
                                            }
                                            let _e1523 = phi_2739_;
                                            phi_2905_ = _e1523;
                                            if _e1523 {
                                                break;
                                            }
                                            let _e1525 = local_2;
                                            phi_2909_ = _e1523;
                                            let _e1724 = local_4;
                                            phi_2658_ = _e1724;
                                            phi_2659_ = _e519;
                                            phi_2660_ = false;
                                            phi_2661_ = select(_e523, 0u, _e1525.member_1);
                                        } else {
                                            if (_e519 >= _e78) {
                                                phi_2263_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e519 < _e78) {
                                                } else {
                                                    phi_2905_ = true;
                                                    break;
                                                }
                                                let _e533 = (_e308 % 3u);
                                                if (_e533 < 3u) {
                                                } else {
                                                    phi_2905_ = true;
                                                    break;
                                                }
                                                let _e539 = global_4.member[_e519].member[_e533];
                                                let _e545 = (_e307 % 3u);
                                                if (_e545 < 3u) {
                                                } else {
                                                    phi_2905_ = true;
                                                    break;
                                                }
                                                let _e551 = global_4.member[_e519].member[_e545];
                                                let _e557 = (_e309 % 3u);
                                                if (_e557 < 3u) {
                                                } else {
                                                    phi_2905_ = true;
                                                    break;
                                                }
                                                let _e563 = global_4.member[_e519].member[_e557];
                                                let _e573 = global_4.member[_e519].member_1;
                                                let _e577 = global_4.member[_e519].member_2;
                                                phi_2263_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e539[0], _e539[1], _e539[2], _e539[3]), vec4<f32>(_e551[0], _e551[1], _e551[2], _e551[3]), vec4<f32>(_e563[0], _e563[1], _e563[2], _e563[3])), _e573, _e577);
                                            }
                                            let _e580 = phi_2263_;
                                            let _e592 = ((_e580.member[0].x - _e363) * _e368);
                                            let _e593 = ((_e580.member[0].y - _e363) * _e368);
                                            let _e594 = ((_e580.member[0].z - _e364) * _e368);
                                            let _e595 = ((_e580.member[0].w - _e364) * _e368);
                                            let _e605 = ((_e580.member[1].x - _e399) * _e404);
                                            let _e606 = ((_e580.member[1].y - _e399) * _e404);
                                            let _e607 = ((_e580.member[1].z - _e400) * _e404);
                                            let _e608 = ((_e580.member[1].w - _e400) * _e404);
                                            let _e618 = ((_e580.member[2].x - _e435) * _e440);
                                            let _e619 = ((_e580.member[2].y - _e435) * _e440);
                                            let _e620 = ((_e580.member[2].z - _e436) * _e440);
                                            let _e621 = ((_e580.member[2].w - _e436) * _e440);
                                            let _e623 = select(_e620, _e618, (_e618 < _e620));
                                            let _e625 = select(_e621, _e619, (_e619 < _e621));
                                            let _e627 = select(_e620, _e618, (_e618 > _e620));
                                            let _e629 = select(_e621, _e619, (_e619 > _e621));
                                            let _e631 = select(_e594, _e592, (_e592 < _e594));
                                            let _e633 = select(_e595, _e593, (_e593 < _e595));
                                            let _e635 = select(_e607, _e605, (_e605 < _e607));
                                            let _e637 = select(_e608, _e606, (_e606 < _e608));
                                            let _e639 = select(_e635, _e631, (_e631 > _e635));
                                            let _e641 = select(_e637, _e633, (_e633 > _e637));
                                            let _e643 = select(_e623, _e639, (_e639 > _e623));
                                            let _e645 = select(_e625, _e641, (_e641 > _e625));
                                            let _e647 = select(_e594, _e592, (_e592 > _e594));
                                            let _e649 = select(_e595, _e593, (_e593 > _e595));
                                            let _e651 = select(_e607, _e605, (_e605 > _e607));
                                            let _e653 = select(_e608, _e606, (_e606 > _e608));
                                            let _e655 = select(_e651, _e647, (_e647 < _e651));
                                            let _e657 = select(_e653, _e649, (_e649 < _e653));
                                            let _e662 = -(_e623);
                                            let _e663 = -(_e625);
                                            let _e670 = (select(_e627, _e655, (_e655 < _e627)) + (select(_e662, _e627, (_e627 > _e662)) * 0.0000019073523f));
                                            let _e671 = (select(_e629, _e657, (_e657 < _e629)) + (select(_e663, _e629, (_e629 > _e663)) * 0.0000019073523f));
                                            let _e673 = select(_e486, _e643, (_e643 > _e486));
                                            let _e675 = select(_e486, _e645, (_e645 > _e486));
                                            let _e680 = (_e673 <= select(_e496.member, _e670, (_e670 < _e496.member)));
                                            let _e681 = (_e675 <= select(_e496.member, _e671, (_e671 < _e496.member)));
                                            let _e682 = (_e673 <= _e675);
                                            if _e680 {
                                                if _e681 {
                                                    if _e682 {
                                                        phi_2607_ = _e580.member_2;
                                                    } else {
                                                        phi_2607_ = _e580.member_1;
                                                    }
                                                    let _e686 = phi_2607_;
                                                    let _e689 = (_e523 % 128u);
                                                    let _e690 = (_e689 < 128u);
                                                    if _e690 {
                                                    } else {
                                                        phi_2905_ = true;
                                                        break;
                                                    }
                                                    local_1[_e689] = _e686;
                                                    if _e690 {
                                                    } else {
                                                        phi_2905_ = true;
                                                        break;
                                                    }
                                                    local[_e689] = select(_e675, _e673, (_e673 > _e675));
                                                    if _e682 {
                                                        phi_2635_ = _e580.member_1;
                                                    } else {
                                                        phi_2635_ = _e580.member_2;
                                                    }
                                                    let _e697 = phi_2635_;
                                                    phi_2636_ = _e697;
                                                    phi_2637_ = (_e523 + 1u);
                                                } else {
                                                    phi_2636_ = u32();
                                                    phi_2637_ = u32();
                                                }
                                                let _e699 = phi_2636_;
                                                let _e701 = phi_2637_;
                                                phi_2639_ = _e699;
                                                phi_2640_ = _e701;
                                                phi_2641_ = select(true, false, _e681);
                                            } else {
                                                phi_2639_ = u32();
                                                phi_2640_ = u32();
                                                phi_2641_ = true;
                                            }
                                            let _e704 = phi_2639_;
                                            let _e706 = phi_2640_;
                                            let _e708 = phi_2641_;
                                            if _e708 {
                                                if _e680 {
                                                    phi_2650_ = _e580.member_1;
                                                } else {
                                                    phi_2650_ = _e580.member_2;
                                                }
                                                let _e712 = phi_2650_;
                                                phi_2655_ = _e712;
                                                phi_2656_ = select(_e681, true, _e680);
                                            } else {
                                                phi_2655_ = _e704;
                                                phi_2656_ = _e521;
                                            }
                                            let _e715 = phi_2655_;
                                            let _e717 = phi_2656_;
                                            phi_2909_ = _e494;
                                            phi_2658_ = _e496;
                                            phi_2659_ = _e715;
                                            phi_2660_ = _e717;
                                            phi_2661_ = select(_e706, _e523, _e708);
                                        }
                                        let _e1529 = phi_2909_;
                                        let _e1531 = phi_2658_;
                                        let _e1533 = phi_2659_;
                                        let _e1535 = phi_2660_;
                                        let _e1537 = phi_2661_;
                                        phi_2908_ = _e1529;
                                        phi_2662_ = _e1531;
                                        phi_2663_ = _e1533;
                                        phi_2664_ = (_e500 - 1u);
                                        phi_2665_ = _e1535;
                                        phi_2666_ = _e1537;
                                    } else {
                                        phi_2908_ = _e494;
                                        phi_2662_ = _e496;
                                        phi_2663_ = _e519;
                                        phi_2664_ = _e500;
                                        phi_2665_ = _e521;
                                        phi_2666_ = _e523;
                                    }
                                    let _e1539 = phi_2908_;
                                    let _e1541 = phi_2662_;
                                    let _e1543 = phi_2663_;
                                    let _e1545 = phi_2664_;
                                    let _e1547 = phi_2665_;
                                    let _e1549 = phi_2666_;
                                    phi_2907_ = _e1539;
                                    phi_2667_ = _e1541;
                                    phi_2668_ = _e1543;
                                    phi_2669_ = _e1545;
                                    phi_2670_ = _e1547;
                                    phi_2671_ = _e1549;
                                } else {
                                    phi_2907_ = _e494;
                                    phi_2667_ = type_55();
                                    phi_2668_ = u32();
                                    phi_2669_ = u32();
                                    phi_2670_ = bool();
                                    phi_2671_ = u32();
                                }
                                let _e1551 = phi_2907_;
                                let _e1553 = phi_2667_;
                                let _e1555 = phi_2668_;
                                let _e1557 = phi_2669_;
                                let _e1559 = phi_2670_;
                                let _e1561 = phi_2671_;
                                phi_2906_ = _e1551;
                                phi_823_ = _e1553;
                                phi_826_ = _e1555;
                                phi_828_ = _e1557;
                                phi_830_ = _e1559;
                                phi_832_ = _e1561;
                                phi_2672_ = _e508;
                            } else {
                                phi_2906_ = _e494;
                                phi_823_ = type_55();
                                phi_826_ = u32();
                                phi_828_ = u32();
                                phi_830_ = bool();
                                phi_832_ = u32();
                                phi_2672_ = false;
                            }
                            let _e1563 = phi_2906_;
                            let _e1565 = phi_823_;
                            let _e1567 = phi_826_;
                            let _e1569 = phi_828_;
                            let _e1571 = phi_830_;
                            let _e1573 = phi_832_;
                            let _e1575 = phi_2672_;
                            continue;
                            continuing {
                                phi_2745_ = _e1563;
                                phi_822_ = _e1565;
                                phi_825_ = _e1567;
                                phi_827_ = _e1569;
                                phi_829_ = _e1571;
                                phi_831_ = _e1573;
                                phi_2905_ = _e1563;
                                break if !(_e1575);
                            }
                        }
                        let _e1578 = phi_2905_;
                        if _e1578 {
                            break;
                        }
                        let _e1580 = local_3;
                        if _e1580.member_1 {
                        } else {
                            if _e176 {
                            } else {
                                break;
                            }
                            let _e1584 = global_9.member[_e96];
                            if _e97 {
                            } else {
                                break;
                            }
                            let _e1588 = global_8.member[_e96].member_1;
                            if _e176 {
                            } else {
                                break;
                            }
                            global_9.member[_e96] = type_30(_e1584.member, _e1584.member_1, _e1584.member_2, array<f32, 3>((_e1584.member_3[0] + (_e1588[0] * _e1584.member_1[0])), (_e1584.member_3[1] + (_e1588[1] * _e1584.member_1[1])), (_e1584.member_3[2] + (_e1588[2] * _e1584.member_1[2]))), _e1584.member_4);
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
