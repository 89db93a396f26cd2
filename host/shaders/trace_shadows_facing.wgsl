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
    var phi_223_: u32;
    var phi_267_: i32;
    var phi_291_: type_47;
    var phi_441_: i32;
    var phi_442_: i32;
    var phi_452_: bool;
    var phi_462_: u32;
    var phi_463_: u32;
    var phi_465_: bool;
    var phi_470_: u32;
    var phi_502_: i32;
    var phi_520_: f32;
    var phi_526_: f32;
    var phi_537_: f32;
    var phi_543_: f32;
    var phi_566_: f32;
    var phi_577_: f32;
    var phi_586_: f32;
    var phi_592_: f32;
    var phi_603_: f32;
    var phi_609_: f32;
    var phi_632_: f32;
    var phi_643_: f32;
    var phi_652_: f32;
    var phi_658_: f32;
    var phi_669_: f32;
    var phi_675_: f32;
    var phi_698_: f32;
    var phi_709_: f32;
    var phi_809_: f32;
    var phi_810_: f32;
    var phi_2747_: bool;
    var phi_821_: type_55;
    var phi_824_: u32;
    var phi_826_: u32;
    var phi_828_: bool;
    var phi_830_: u32;
    var phi_841_: bool;
    var phi_873_: u32;
    var phi_874_: bool;
    var phi_875_: u32;
    var phi_2265_: type_54;
    var phi_2609_: u32;
    var phi_2637_: u32;
    var phi_2638_: u32;
    var phi_2639_: u32;
    var phi_2641_: u32;
    var phi_2642_: u32;
    var phi_2643_: bool;
    var phi_2652_: u32;
    var phi_2657_: u32;
    var phi_2658_: bool;
    var phi_890_: type_55;
    var phi_893_: type_8;
    var phi_894_: type_8;
    var phi_916_: type_8;
    var phi_937_: u32;
    var phi_1026_: array<array<f32, 3>, 3>;
    var phi_1143_: bool;
    var phi_1172_: bool;
    var phi_1573_: f32;
    var phi_1574_: f32;
    var phi_1575_: f32;
    var phi_1576_: f32;
    var phi_1577_: vec3<f32>;
    var phi_1578_: vec3<f32>;
    var phi_1579_: vec3<f32>;
    var phi_1580_: vec3<f32>;
    var phi_1611_: bool;
    var phi_1620_: vec3<f32>;
    var phi_1787_: bool;
    var phi_1811_: f32;
    var phi_1812_: f32;
    var phi_1835_: type_28;
    var phi_1837_: type_28;
    var phi_1838_: bool;
    var phi_1842_: type_28;
    var phi_1843_: type_28;
    var phi_1844_: type_28;
    var phi_1845_: bool;
    var phi_1849_: type_28;
    var phi_1850_: bool;
    var phi_1851_: type_28;
    var phi_1852_: bool;
    var phi_1853_: bool;
    var phi_1854_: type_28;
    var phi_1855_: bool;
    var phi_1856_: bool;
    var phi_1864_: type_28;
    var phi_1865_: bool;
    var phi_1869_: type_28;
    var phi_1892_: u32;
    var phi_1906_: i32;
    var phi_1926_: vec3<f32>;
    var phi_1927_: vec3<f32>;
    var phi_1943_: vec3<f32>;
    var phi_1944_: vec3<f32>;
    var phi_1960_: vec3<f32>;
    var phi_1961_: vec3<f32>;
    var phi_1997_: vec3<f32>;
    var phi_2179_: f32;
    var phi_2197_: bool;
    var phi_2198_: bool;
    var phi_2203_: type_55;
    var phi_2204_: type_55;
    var phi_891_: type_55;
    var phi_2741_: bool;
    var local_2: type_55;
    var phi_2911_: bool;
    var phi_2660_: type_55;
    var phi_2661_: u32;
    var phi_2662_: bool;
    var phi_2663_: u32;
    var phi_2910_: bool;
    var phi_2664_: type_55;
    var phi_2665_: u32;
    var phi_2666_: u32;
    var phi_2667_: bool;
    var phi_2668_: u32;
    var phi_2909_: bool;
    var phi_2669_: type_55;
    var phi_2670_: u32;
    var phi_2671_: u32;
    var phi_2672_: bool;
    var phi_2673_: u32;
    var phi_2908_: bool;
    var phi_822_: type_55;
    var phi_825_: u32;
    var phi_827_: u32;
    var phi_829_: bool;
    var phi_831_: u32;
    var phi_2674_: bool;
    var phi_2907_: bool;
    var local_3: type_55;
    var local_4: type_55;

    switch bitcast<i32>(0u) {
        default: {
            let _e75 = global;
            let _e77 = arrayLength((&global_4.member));
            let _e79 = arrayLength((&global_2.member));
            let _e91 = arrayLength((&global_7.member));
            let _e95 = (_e75.x + (_e75.y * 2097152u));
            let _e96 = (_e95 < arrayLength((&global_8.member)));
            if _e96 {
                if _e96 {
                } else {
                    break;
                }
                let _e100 = global_8.member[_e95].member_2;
                phi_223_ = _e100;
            } else {
                phi_223_ = 4294967295u;
            }
            let _e102 = phi_223_;
            let _e105 = global_1.member[0u];
            let _e109 = global_3.member[0u][0u];
            let _e113 = global_3.member[0u][1u];
            let _e117 = global_3.member[0u][2u];
            let _e121 = global_3.member[0u][3u];
            let _e125 = global_3.member[1u][0u];
            let _e129 = global_3.member[1u][1u];
            let _e133 = global_3.member[1u][2u];
            let _e137 = global_3.member[1u][3u];
            let _e138 = bitcast<f32>(_e109);
            let _e139 = bitcast<f32>(_e113);
            let _e140 = bitcast<f32>(_e117);
            let _e142 = bitcast<f32>(_e125);
            let _e143 = array<u32, 3>(_e129, _e133, _e137);
            let _e145 = bitcast<i32>(_e105);
            if (_e145 < -126i) {
                phi_267_ = -126i;
            } else {
                phi_267_ = select(_e145, 127i, (_e145 > 127i));
            }
            let _e150 = phi_267_;
            let _e155 = bitcast<f32>((bitcast<u32>((_e150 + 127i)) << bitcast<u32>(23i)));
            let _e161 = bitcast<f32>((bitcast<u32>(((_e145 - _e150) + 127i)) << bitcast<u32>(23i)));
            if (_e121 == 0u) {
                phi_291_ = type_47(array<f32, 3>(_e138, _e139, _e140), _e121, _e142, _e143);
            } else {
                phi_291_ = type_47(array<f32, 3>(((_e138 * _e155) * _e161), ((_e139 * _e155) * _e161), ((_e140 * _e155) * _e161)), _e121, ((_e142 * _e155) * _e161), _e143);
            }
            let _e174 = phi_291_;
            if _e96 {
                let _e175 = (_e95 < arrayLength((&global_9.member)));
                if _e175 {
                    if _e96 {
                    } else {
                        break;
                    }
                    let _e180 = global_8.member[_e95].member.member_1;
                    let _e185 = global_8.member[_e95].member.member_3;
                    if (_e180 <= _e185) {
                        let _e187 = (1u < _e91);
                        if _e187 {
                            if (0u < _e91) {
                            } else {
                                break;
                            }
                            let _e191 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e191 + 1u) < _e191) {
                                if _e187 {
                                } else {
                                    break;
                                }
                                let _e196 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e96 {
                        } else {
                            break;
                        }
                        let _e206 = global_8.member[_e95].member.member_2[0u];
                        let _e208 = (bitcast<u32>(_e206) & 2147483647u);
                        let _e214 = global_8.member[_e95].member.member_2[1u];
                        let _e216 = (bitcast<u32>(_e214) & 2147483647u);
                        let _e222 = global_8.member[_e95].member.member_2[2u];
                        let _e224 = (bitcast<u32>(_e222) & 2147483647u);
                        let _e230 = global_8.member[_e95].member.member[0u];
                        let _e232 = (bitcast<u32>(_e230) & 2147483647u);
                        let _e238 = global_8.member[_e95].member.member[1u];
                        let _e240 = (bitcast<u32>(_e238) & 2147483647u);
                        let _e246 = global_8.member[_e95].member.member[2u];
                        let _e248 = (bitcast<u32>(_e246) & 2147483647u);
                        let _e250 = select(_e216, _e208, (_e216 < _e208));
                        let _e252 = select(_e224, _e250, (_e224 < _e250));
                        let _e254 = select(_e232, _e252, (_e232 < _e252));
                        let _e256 = select(_e240, _e254, (_e240 < _e254));
                        let _e258 = select(_e248, _e256, (_e248 < _e256));
                        let _e260 = (bitcast<u32>(_e180) & 2147483647u);
                        let _e269 = (((select(_e260, _e258, (_e260 < _e258)) < 2139095040u) && ((bitcast<u32>(_e185) & 2147483647u) <= 2139095040u)) && (_e252 > 0u));
                        if _e269 {
                            let _e272 = (bitcast<u32>(bitcast<f32>(_e252)) & 2147483647u);
                            if (_e272 >= 8388608u) {
                                phi_441_ = (bitcast<i32>((_e272 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_441_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e272)), 32u, (_e272 == 0u))));
                            }
                            let _e286 = phi_441_;
                            phi_442_ = _e286;
                        } else {
                            phi_442_ = 0i;
                        }
                        let _e288 = phi_442_;
                        let _e289 = (_e208 == _e252);
                        if _e289 {
                            phi_452_ = true;
                        } else {
                            phi_452_ = (_e216 == _e252);
                        }
                        let _e292 = phi_452_;
                        let _e293 = select(1u, 0u, _e289);
                        if _e292 {
                            let _e294 = (_e293 + 1u);
                            phi_462_ = _e294;
                            phi_463_ = _e294;
                            phi_465_ = select(true, false, (_e294 == 2u));
                        } else {
                            phi_462_ = u32();
                            phi_463_ = 0u;
                            phi_465_ = true;
                        }
                        let _e298 = phi_462_;
                        let _e300 = phi_463_;
                        let _e302 = phi_465_;
                        if _e302 {
                            phi_470_ = (_e300 + 1u);
                        } else {
                            phi_470_ = 0u;
                        }
                        let _e306 = phi_470_;
                        let _e307 = select(_e298, _e300, _e302);
                        let _e308 = select(_e293, select(2u, _e293, _e292), _e302);
                        let _e309 = -(_e288);
                        if (_e309 < -126i) {
                            phi_502_ = -126i;
                        } else {
                            phi_502_ = select(_e309, 127i, (_e309 > 127i));
                        }
                        let _e314 = phi_502_;
                        let _e319 = bitcast<f32>((bitcast<u32>((_e314 + 127i)) << bitcast<u32>(23i)));
                        let _e325 = bitcast<f32>((bitcast<u32>(((_e309 - _e314) + 127i)) << bitcast<u32>(23i)));
                        let _e330 = global_8.member[_e95].member.member;
                        let _e331 = (_e307 == 0u);
                        if _e331 {
                            phi_520_ = _e330[0];
                        } else {
                            phi_520_ = _e330[1];
                        }
                        let _e335 = phi_520_;
                        let _e336 = (_e307 == 2u);
                        if _e336 {
                            phi_526_ = _e330[2];
                        } else {
                            phi_526_ = _e335;
                        }
                        let _e339 = phi_526_;
                        let _e340 = global_8.member[_e95].member.member_2;
                        if _e331 {
                            phi_537_ = _e340[0];
                        } else {
                            phi_537_ = _e340[1];
                        }
                        let _e344 = phi_537_;
                        if _e336 {
                            phi_543_ = _e340[2];
                        } else {
                            phi_543_ = _e344;
                        }
                        let _e347 = phi_543_;
                        let _e349 = ((_e347 * _e319) * _e325);
                        let _e353 = (bitcast<f32>((bitcast<u32>(_e349) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e353 {
                            let _e357 = (bitcast<f32>((bitcast<u32>(_e339) & 2147483647u)) * 0.00000011920929f);
                            phi_566_ = select(0.00000000000011368684f, _e357, (_e357 > 0.00000000000011368684f));
                        } else {
                            phi_566_ = 0f;
                        }
                        let _e361 = phi_566_;
                        let _e362 = (_e339 + _e361);
                        let _e363 = (_e339 - _e361);
                        let _e364 = select(_e349, 0f, _e353);
                        if _e353 {
                            phi_577_ = 38685626000000000000000000f;
                        } else {
                            phi_577_ = (1f / _e349);
                        }
                        let _e367 = phi_577_;
                        let _e368 = (_e306 == 0u);
                        if _e368 {
                            phi_586_ = _e330[0];
                        } else {
                            phi_586_ = _e330[1];
                        }
                        let _e372 = phi_586_;
                        let _e373 = (_e306 == 2u);
                        if _e373 {
                            phi_592_ = _e330[2];
                        } else {
                            phi_592_ = _e372;
                        }
                        let _e376 = phi_592_;
                        if _e368 {
                            phi_603_ = _e340[0];
                        } else {
                            phi_603_ = _e340[1];
                        }
                        let _e380 = phi_603_;
                        if _e373 {
                            phi_609_ = _e340[2];
                        } else {
                            phi_609_ = _e380;
                        }
                        let _e383 = phi_609_;
                        let _e385 = ((_e383 * _e319) * _e325);
                        let _e389 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e389 {
                            let _e393 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) * 0.00000011920929f);
                            phi_632_ = select(0.00000000000011368684f, _e393, (_e393 > 0.00000000000011368684f));
                        } else {
                            phi_632_ = 0f;
                        }
                        let _e397 = phi_632_;
                        let _e398 = (_e376 + _e397);
                        let _e399 = (_e376 - _e397);
                        let _e400 = select(_e385, 0f, _e389);
                        if _e389 {
                            phi_643_ = 38685626000000000000000000f;
                        } else {
                            phi_643_ = (1f / _e385);
                        }
                        let _e403 = phi_643_;
                        let _e404 = (_e308 == 0u);
                        if _e404 {
                            phi_652_ = _e330[0];
                        } else {
                            phi_652_ = _e330[1];
                        }
                        let _e408 = phi_652_;
                        let _e409 = (_e308 == 2u);
                        if _e409 {
                            phi_658_ = _e330[2];
                        } else {
                            phi_658_ = _e408;
                        }
                        let _e412 = phi_658_;
                        if _e404 {
                            phi_669_ = _e340[0];
                        } else {
                            phi_669_ = _e340[1];
                        }
                        let _e416 = phi_669_;
                        if _e409 {
                            phi_675_ = _e340[2];
                        } else {
                            phi_675_ = _e416;
                        }
                        let _e419 = phi_675_;
                        let _e421 = ((_e419 * _e319) * _e325);
                        let _e425 = (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e425 {
                            let _e429 = (bitcast<f32>((bitcast<u32>(_e412) & 2147483647u)) * 0.00000011920929f);
                            phi_698_ = select(0.00000000000011368684f, _e429, (_e429 > 0.00000000000011368684f));
                        } else {
                            phi_698_ = 0f;
                        }
                        let _e433 = phi_698_;
                        let _e434 = (_e412 + _e433);
                        let _e435 = (_e412 - _e433);
                        let _e436 = select(_e421, 0f, _e425);
                        if _e425 {
                            phi_709_ = 38685626000000000000000000f;
                        } else {
                            phi_709_ = (1f / _e421);
                        }
                        let _e439 = phi_709_;
                        let _e442 = bitcast<f32>((bitcast<u32>(_e339) & 2147483647u));
                        let _e445 = bitcast<f32>((bitcast<u32>(_e376) & 2147483647u));
                        let _e447 = select(_e445, _e442, (_e442 > _e445));
                        let _e450 = bitcast<f32>((bitcast<u32>(_e412) & 2147483647u));
                        if (_e269 && (select(_e450, _e447, (_e447 > _e450)) <= 1099511600000f)) {
                            let _e455 = (_e288 / 3i);
                            let _e462 = bitcast<f32>((bitcast<u32>((_e455 + 127i)) << bitcast<u32>(23i)));
                            let _e469 = bitcast<f32>((bitcast<u32>(((_e288 - (2i * _e455)) + 127i)) << bitcast<u32>(23i)));
                            let _e470 = (((_e180 * _e462) * _e462) * _e469);
                            let _e472 = select(340282350000000000000000000000000000000f, _e470, (_e470 < 340282350000000000000000000000000000000f));
                            let _e477 = (((_e185 * _e462) * _e462) * _e469);
                            let _e479 = select(340282350000000000000000000000000000000f, _e477, (_e477 < 340282350000000000000000000000000000000f));
                            phi_809_ = select(-340282350000000000000000000000000000000f, _e479, (_e479 > -340282350000000000000000000000000000000f));
                            phi_810_ = select(-340282350000000000000000000000000000000f, _e472, (_e472 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_809_ = 0f;
                            phi_810_ = 1f;
                        }
                        let _e483 = phi_809_;
                        let _e485 = phi_810_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2747_ = false;
                        phi_821_ = type_55(_e483, false);
                        phi_824_ = select(0u, 2147483648u, (_e77 == 0u));
                        phi_826_ = ((3u * _e77) + 1u);
                        phi_828_ = (_e485 <= _e483);
                        phi_830_ = 0u;
                        loop {
                            let _e493 = phi_2747_;
                            let _e495 = phi_821_;
                            let _e497 = phi_824_;
                            let _e499 = phi_826_;
                            let _e501 = phi_828_;
                            let _e503 = phi_830_;
                            local_3 = _e495;
                            if _e501 {
                                phi_841_ = true;
                            } else {
                                phi_841_ = (_e503 > 0u);
                            }
                            let _e506 = phi_841_;
                            if _e506 {
                                let _e507 = (_e499 > 0u);
                                if _e507 {
                                    if _e501 {
                                        phi_873_ = _e497;
                                        phi_874_ = _e501;
                                        phi_875_ = _e503;
                                    } else {
                                        let _e508 = (_e503 - 1u);
                                        let _e509 = (_e508 % 128u);
                                        let _e510 = (_e509 < 128u);
                                        if _e510 {
                                        } else {
                                            phi_2907_ = true;
                                            break;
                                        }
                                        let _e512 = local_1[_e509];
                                        if _e510 {
                                        } else {
                                            phi_2907_ = true;
                                            break;
                                        }
                                        let _e514 = local[_e509];
                                        phi_873_ = _e512;
                                        phi_874_ = (_e514 <= _e495.member);
                                        phi_875_ = _e508;
                                    }
                                    let _e518 = phi_873_;
                                    let _e520 = phi_874_;
                                    let _e522 = phi_875_;
                                    if _e520 {
                                        if ((_e518 & 2147483648u) != 0u) {
                                            phi_890_ = _e495;
                                            phi_893_ = type_8(0u, ((_e518 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e720 = phi_890_;
                                                let _e722 = phi_893_;
                                                local_2 = _e720;
                                                local_4 = _e720;
                                                if (_e722.member < _e722.member_1) {
                                                    phi_894_ = type_8((_e722.member + 1u), _e722.member_1);
                                                    phi_916_ = type_8(1u, _e722.member);
                                                } else {
                                                    phi_894_ = _e722;
                                                    phi_916_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e735 = phi_894_;
                                                let _e737 = phi_916_;
                                                let _e741 = (bitcast<i32>(_e737.member) != 0i);
                                                if _e741 {
                                                    let _e742 = ((_e518 & 268435455u) + _e737.member_1);
                                                    let _e743 = (_e742 < _e79);
                                                    if _e743 {
                                                        if _e743 {
                                                        } else {
                                                            phi_2741_ = true;
                                                            break;
                                                        }
                                                        let _e747 = global_2.member[_e742].member_1;
                                                        phi_937_ = _e747;
                                                    } else {
                                                        phi_937_ = 4294967295u;
                                                    }
                                                    let _e749 = phi_937_;
                                                    if (_e742 >= _e79) {
                                                        phi_1026_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e743 {
                                                        } else {
                                                            phi_2741_ = true;
                                                            break;
                                                        }
                                                        let _e751 = (_e307 % 3u);
                                                        let _e752 = (_e306 % 3u);
                                                        let _e753 = (_e308 % 3u);
                                                        if (_e751 < 9u) {
                                                        } else {
                                                            phi_2741_ = true;
                                                            break;
                                                        }
                                                        let _e759 = global_2.member[_e742].member[_e751];
                                                        if (_e752 < 9u) {
                                                        } else {
                                                            phi_2741_ = true;
                                                            break;
                                                        }
                                                        let _e765 = global_2.member[_e742].member[_e752];
                                                        if (_e753 < 9u) {
                                                        } else {
                                                            phi_2741_ = true;
                                                            break;
                                                        }
                                                        let _e771 = global_2.member[_e742].member[_e753];
                                                        let _e773 = (3u + _e751);
                                                        if (_e773 < 9u) {
                                                        } else {
                                                            phi_2741_ = true;
                                                            break;
                                                        }
                                                        let _e779 = global_2.member[_e742].member[_e773];
                                                        let _e780 = (3u + _e752);
                                                        if (_e780 < 9u) {
                                                        } else {
                                                            phi_2741_ = true;
                                                            break;
                                                        }
                                                        let _e786 = global_2.member[_e742].member[_e780];
                                                        let _e787 = (3u + _e753);
                                                        if (_e787 < 9u) {
                                                        } else {
                                                            phi_2741_ = true;
                                                            break;
                                                        }
                                                        let _e793 = global_2.member[_e742].member[_e787];
                                                        let _e795 = (6u + _e751);
                                                        if (_e795 < 9u) {
                                                        } else {
                                                            phi_2741_ = true;
                                                            break;
                                                        }
                                                        let _e801 = global_2.member[_e742].member[_e795];
                                                        let _e802 = (6u + _e752);
                                                        if (_e802 < 9u) {
                                                        } else {
                                                            phi_2741_ = true;
                                                            break;
                                                        }
                                                        let _e808 = global_2.member[_e742].member[_e802];
                                                        let _e809 = (6u + _e753);
                                                        if (_e809 < 9u) {
                                                        } else {
                                                            phi_2741_ = true;
                                                            break;
                                                        }
                                                        let _e815 = global_2.member[_e742].member[_e809];
                                                        phi_1026_ = array<array<f32, 3>, 3>(array<f32, 3>(_e759, _e765, _e771), array<f32, 3>(_e779, _e786, _e793), array<f32, 3>(_e801, _e808, _e815));
                                                    }
                                                    let _e819 = phi_1026_;
                                                    let _e827 = (_e819[0][2] - _e412);
                                                    let _e830 = (((_e819[0][0] - _e339) * _e436) - (_e827 * _e364));
                                                    let _e833 = (((_e819[0][1] - _e376) * _e436) - (_e827 * _e400));
                                                    let _e840 = (_e819[1][2] - _e412);
                                                    let _e843 = (((_e819[1][0] - _e339) * _e436) - (_e840 * _e364));
                                                    let _e846 = (((_e819[1][1] - _e376) * _e436) - (_e840 * _e400));
                                                    let _e853 = (_e819[2][2] - _e412);
                                                    let _e856 = (((_e819[2][0] - _e339) * _e436) - (_e853 * _e364));
                                                    let _e859 = (((_e819[2][1] - _e376) * _e436) - (_e853 * _e400));
                                                    let _e860 = (_e856 * _e846);
                                                    let _e861 = (_e859 * _e843);
                                                    let _e862 = (_e830 * _e859);
                                                    let _e863 = (_e833 * _e856);
                                                    let _e864 = (_e843 * _e833);
                                                    let _e865 = (_e846 * _e830);
                                                    let _e870 = (((_e860 >= _e861) && (_e862 >= _e863)) && (_e864 >= _e865));
                                                    if (_e870 || (((_e860 <= _e861) && (_e862 <= _e863)) && (_e864 <= _e865))) {
                                                        let _e877 = select(-1f, 1f, _e870);
                                                        let _e879 = ((_e860 - _e861) * _e877);
                                                        let _e881 = select(0f, _e879, (_e879 > 0f));
                                                        let _e883 = ((_e862 - _e863) * _e877);
                                                        let _e885 = select(0f, _e883, (_e883 > 0f));
                                                        let _e887 = ((_e864 - _e865) * _e877);
                                                        let _e889 = select(0f, _e887, (_e887 > 0f));
                                                        let _e891 = ((_e881 + _e885) + _e889);
                                                        if (_e891 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1854_ = type_28();
                                                            phi_1855_ = true;
                                                            phi_1856_ = false;
                                                        } else {
                                                            let _e894 = select(_e843, _e830, (_e830 < _e843));
                                                            if (select(_e856, _e894, (_e894 < _e856)) > 0f) {
                                                                phi_1143_ = true;
                                                            } else {
                                                                let _e899 = select(_e843, _e830, (_e830 > _e843));
                                                                phi_1143_ = (select(_e856, _e899, (_e899 > _e856)) < 0f);
                                                            }
                                                            let _e904 = phi_1143_;
                                                            if _e904 {
                                                                phi_1851_ = type_28();
                                                                phi_1852_ = true;
                                                                phi_1853_ = false;
                                                            } else {
                                                                let _e906 = select(_e846, _e833, (_e833 < _e846));
                                                                if (select(_e859, _e906, (_e906 < _e859)) > 0f) {
                                                                    phi_1172_ = true;
                                                                } else {
                                                                    let _e911 = select(_e846, _e833, (_e833 > _e846));
                                                                    phi_1172_ = (select(_e859, _e911, (_e911 > _e859)) < 0f);
                                                                }
                                                                let _e916 = phi_1172_;
                                                                if _e916 {
                                                                    phi_1849_ = type_28();
                                                                    phi_1850_ = false;
                                                                } else {
                                                                    let _e918 = select(_e819[1][0], _e819[0][0], (_e819[0][0] < _e819[1][0]));
                                                                    let _e922 = select(_e819[1][0], _e819[0][0], (_e819[0][0] > _e819[1][0]));
                                                                    let _e926 = select(_e819[1][1], _e819[0][1], (_e819[0][1] < _e819[1][1]));
                                                                    let _e930 = select(_e819[1][1], _e819[0][1], (_e819[0][1] > _e819[1][1]));
                                                                    let _e934 = select(_e819[1][2], _e819[0][2], (_e819[0][2] < _e819[1][2]));
                                                                    let _e938 = select(_e819[1][2], _e819[0][2], (_e819[0][2] > _e819[1][2]));
                                                                    let _e943 = ((select(_e819[2][0], _e918, (_e918 < _e819[2][0])) - _e362) * _e367);
                                                                    let _e944 = ((select(_e819[2][0], _e922, (_e922 > _e819[2][0])) - _e363) * _e367);
                                                                    let _e947 = ((select(_e819[2][1], _e926, (_e926 < _e819[2][1])) - _e398) * _e403);
                                                                    let _e948 = ((select(_e819[2][1], _e930, (_e930 > _e819[2][1])) - _e399) * _e403);
                                                                    let _e951 = ((select(_e819[2][2], _e934, (_e934 < _e819[2][2])) - _e434) * _e439);
                                                                    let _e952 = ((select(_e819[2][2], _e938, (_e938 > _e819[2][2])) - _e435) * _e439);
                                                                    let _e954 = select(_e952, _e951, (_e951 < _e952));
                                                                    let _e956 = select(_e952, _e951, (_e951 > _e952));
                                                                    let _e958 = select(_e944, _e943, (_e943 < _e944));
                                                                    let _e960 = select(_e948, _e947, (_e947 < _e948));
                                                                    let _e962 = select(_e960, _e958, (_e958 > _e960));
                                                                    let _e964 = select(_e954, _e962, (_e962 > _e954));
                                                                    let _e966 = select(_e944, _e943, (_e943 > _e944));
                                                                    let _e968 = select(_e948, _e947, (_e947 > _e948));
                                                                    let _e970 = select(_e968, _e966, (_e966 < _e968));
                                                                    let _e972 = select(_e956, _e970, (_e970 < _e956));
                                                                    let _e973 = -(_e954);
                                                                    let _e979 = select(_e485, _e964, (_e964 > _e485));
                                                                    if (_e979 > (_e972 + (select(_e973, _e956, (_e956 > _e973)) * 0.0000019073523f))) {
                                                                        phi_1844_ = type_28();
                                                                        phi_1845_ = true;
                                                                    } else {
                                                                        let _e981 = (_e979 > _e720.member);
                                                                        if _e981 {
                                                                            phi_1843_ = type_28();
                                                                        } else {
                                                                            let _e982 = vec3<f32>(_e819[0][0], _e819[0][1], _e819[0][2]);
                                                                            let _e983 = vec3<f32>(_e819[1][0], _e819[1][1], _e819[1][2]);
                                                                            let _e984 = vec3<f32>(_e819[2][0], _e819[2][1], _e819[2][2]);
                                                                            let _e985 = (_e819[1][0] - _e819[0][0]);
                                                                            let _e986 = (_e819[1][1] - _e819[0][1]);
                                                                            let _e987 = (_e819[1][2] - _e819[0][2]);
                                                                            let _e988 = vec3<f32>(_e985, _e986, _e987);
                                                                            let _e989 = (_e819[2][0] - _e819[1][0]);
                                                                            let _e990 = (_e819[2][1] - _e819[1][1]);
                                                                            let _e991 = (_e819[2][2] - _e819[1][2]);
                                                                            let _e992 = vec3<f32>(_e989, _e990, _e991);
                                                                            let _e993 = (_e819[0][0] - _e819[2][0]);
                                                                            let _e994 = (_e819[0][1] - _e819[2][1]);
                                                                            let _e995 = (_e819[0][2] - _e819[2][2]);
                                                                            let _e996 = vec3<f32>(_e993, _e994, _e995);
                                                                            let _e999 = bitcast<f32>((bitcast<u32>(_e985) & 2147483647u));
                                                                            let _e1002 = bitcast<f32>((bitcast<u32>(_e986) & 2147483647u));
                                                                            let _e1004 = select(_e1002, _e999, (_e999 > _e1002));
                                                                            let _e1007 = bitcast<f32>((bitcast<u32>(_e987) & 2147483647u));
                                                                            let _e1009 = select(_e1007, _e1004, (_e1004 > _e1007));
                                                                            let _e1012 = bitcast<f32>((bitcast<u32>(_e989) & 2147483647u));
                                                                            let _e1015 = bitcast<f32>((bitcast<u32>(_e990) & 2147483647u));
                                                                            let _e1017 = select(_e1015, _e1012, (_e1012 > _e1015));
                                                                            let _e1020 = bitcast<f32>((bitcast<u32>(_e991) & 2147483647u));
                                                                            let _e1022 = select(_e1020, _e1017, (_e1017 > _e1020));
                                                                            let _e1025 = bitcast<f32>((bitcast<u32>(_e993) & 2147483647u));
                                                                            let _e1028 = bitcast<f32>((bitcast<u32>(_e994) & 2147483647u));
                                                                            let _e1030 = select(_e1028, _e1025, (_e1025 > _e1028));
                                                                            let _e1033 = bitcast<f32>((bitcast<u32>(_e995) & 2147483647u));
                                                                            let _e1035 = select(_e1033, _e1030, (_e1030 > _e1033));
                                                                            let _e1037 = select(_e1022, _e1009, (_e1009 > _e1022));
                                                                            let _e1039 = select(_e1035, _e1037, (_e1037 > _e1035));
                                                                            if (_e1009 == _e1039) {
                                                                                phi_1573_ = _e846;
                                                                                phi_1574_ = _e843;
                                                                                phi_1575_ = _e833;
                                                                                phi_1576_ = _e830;
                                                                                phi_1577_ = _e982;
                                                                                phi_1578_ = _e996;
                                                                                phi_1579_ = _e992;
                                                                                phi_1580_ = _e988;
                                                                            } else {
                                                                                let _e1041 = (_e1022 == _e1039);
                                                                                let _e1046 = vec3(_e1041);
                                                                                phi_1573_ = select(_e833, _e859, _e1041);
                                                                                phi_1574_ = select(_e830, _e856, _e1041);
                                                                                phi_1575_ = select(_e859, _e846, _e1041);
                                                                                phi_1576_ = select(_e856, _e843, _e1041);
                                                                                phi_1577_ = select(_e984, _e983, _e1046);
                                                                                phi_1578_ = select(_e992, _e988, _e1046);
                                                                                phi_1579_ = select(_e988, _e996, _e1046);
                                                                                phi_1580_ = select(_e996, _e992, _e1046);
                                                                            }
                                                                            let _e1052 = phi_1573_;
                                                                            let _e1054 = phi_1574_;
                                                                            let _e1056 = phi_1575_;
                                                                            let _e1058 = phi_1576_;
                                                                            let _e1060 = phi_1577_;
                                                                            let _e1062 = phi_1578_;
                                                                            let _e1064 = phi_1579_;
                                                                            let _e1066 = phi_1580_;
                                                                            let _e1073 = ((_e1064.y * _e1062.z) - (_e1062.y * _e1064.z));
                                                                            let _e1078 = ((_e1064.z * _e1062.x) - (_e1062.z * _e1064.x));
                                                                            let _e1081 = ((_e1064.x * _e1062.y) - (_e1062.x * _e1064.y));
                                                                            if (_e881 >= _e885) {
                                                                                phi_1611_ = select(true, false, (_e881 >= _e889));
                                                                            } else {
                                                                                phi_1611_ = true;
                                                                            }
                                                                            let _e1086 = phi_1611_;
                                                                            if _e1086 {
                                                                                phi_1620_ = select(_e984, _e983, vec3((_e885 >= _e889)));
                                                                            } else {
                                                                                phi_1620_ = _e982;
                                                                            }
                                                                            let _e1091 = phi_1620_;
                                                                            let _e1096 = (((_e1073 * _e364) + (_e1078 * _e400)) + (_e1081 * _e436));
                                                                            let _e1107 = (((_e1073 * (_e1091.x - _e339)) + (_e1078 * (_e1091.y - _e376))) + (_e1081 * (_e1091.z - _e412)));
                                                                            let _e1109 = (_e1054 - _e1058);
                                                                            let _e1110 = (_e1052 - _e1056);
                                                                            let _e1118 = (-(((_e1058 * _e1109) + (_e1056 * _e1110))) / ((_e1109 * _e1109) + (_e1110 * _e1110)));
                                                                            let _e1120 = select(1f, _e1118, (_e1118 < 1f));
                                                                            let _e1122 = select(0f, _e1120, (_e1120 > 0f));
                                                                            let _e1135 = ((_e1060.x + (_e1066.x * _e1122)) - _e339);
                                                                            let _e1136 = ((_e1060.y + (_e1066.y * _e1122)) - _e376);
                                                                            let _e1137 = ((_e1060.z + (_e1066.z * _e1122)) - _e412);
                                                                            let _e1138 = (_e1137 / _e436);
                                                                            let _e1150 = bitcast<f32>((bitcast<u32>(_e1135) & 2147483647u));
                                                                            let _e1153 = bitcast<f32>((bitcast<u32>(_e1136) & 2147483647u));
                                                                            let _e1155 = select(_e1153, _e1150, (_e1150 > _e1153));
                                                                            let _e1158 = bitcast<f32>((bitcast<u32>(_e1137) & 2147483647u));
                                                                            let _e1160 = select(_e1158, _e1155, (_e1155 > _e1158));
                                                                            let _e1166 = bitcast<f32>((bitcast<u32>(_e1073) & 2147483647u));
                                                                            let _e1169 = bitcast<f32>((bitcast<u32>(_e1078) & 2147483647u));
                                                                            let _e1171 = select(_e1169, _e1166, (_e1166 > _e1169));
                                                                            let _e1174 = bitcast<f32>((bitcast<u32>(_e1081) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1073 * _e1135) + (_e1078 * _e1136)) + (_e1081 * _e1137)) - _e1107)) & 2147483647u)) <= ((0.0000009536743f * select(_e1039, _e1160, (_e1160 > _e1039))) * select(_e1174, _e1171, (_e1171 > _e1174)))) {
                                                                                let _e1184 = bitcast<f32>((bitcast<u32>(_e1064.x) & 2147483647u));
                                                                                let _e1187 = bitcast<f32>((bitcast<u32>(_e1064.y) & 2147483647u));
                                                                                let _e1189 = select(_e1187, _e1184, (_e1184 > _e1187));
                                                                                let _e1192 = bitcast<f32>((bitcast<u32>(_e1064.z) & 2147483647u));
                                                                                let _e1198 = bitcast<f32>((bitcast<u32>(_e1062.x) & 2147483647u));
                                                                                let _e1201 = bitcast<f32>((bitcast<u32>(_e1062.y) & 2147483647u));
                                                                                let _e1203 = select(_e1201, _e1198, (_e1198 > _e1201));
                                                                                let _e1206 = bitcast<f32>((bitcast<u32>(_e1062.z) & 2147483647u));
                                                                                phi_1787_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1096) & 2147483647u)) > ((0.0000038146973f * select(_e1192, _e1189, (_e1189 > _e1192))) * select(_e1206, _e1203, (_e1203 > _e1206)))));
                                                                            } else {
                                                                                phi_1787_ = true;
                                                                            }
                                                                            let _e1213 = phi_1787_;
                                                                            if _e1213 {
                                                                                let _e1224 = ((((_e1073 * (_e1135 - (_e364 * _e1138))) + (_e1078 * (_e1136 - (_e400 * _e1138)))) + (_e1081 * (_e1137 - _e1137))) / _e1096);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1224) & 2147483647u)) <= _e1039) {
                                                                                    phi_1811_ = (_e1138 + _e1224);
                                                                                } else {
                                                                                    phi_1811_ = _e1138;
                                                                                }
                                                                                let _e1231 = phi_1811_;
                                                                                phi_1812_ = _e1231;
                                                                            } else {
                                                                                phi_1812_ = (_e1107 / _e1096);
                                                                            }
                                                                            let _e1233 = phi_1812_;
                                                                            let _e1235 = select(_e972, _e1233, (_e1233 < _e972));
                                                                            let _e1237 = select(_e964, _e1235, (_e1235 > _e964));
                                                                            if (_e1237 >= _e485) {
                                                                                let _e1239 = (_e1237 <= _e720.member);
                                                                                if _e1239 {
                                                                                    let _e1240 = (1f / _e891);
                                                                                    phi_1835_ = type_28(_e1237, (_e885 * _e1240), (_e889 * _e1240), _e749);
                                                                                } else {
                                                                                    phi_1835_ = type_28();
                                                                                }
                                                                                let _e1245 = phi_1835_;
                                                                                phi_1837_ = _e1245;
                                                                                phi_1838_ = select(true, false, _e1239);
                                                                            } else {
                                                                                phi_1837_ = type_28();
                                                                                phi_1838_ = true;
                                                                            }
                                                                            let _e1248 = phi_1837_;
                                                                            let _e1250 = phi_1838_;
                                                                            if _e1250 {
                                                                                phi_1842_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_1842_ = _e1248;
                                                                            }
                                                                            let _e1252 = phi_1842_;
                                                                            phi_1843_ = _e1252;
                                                                        }
                                                                        let _e1254 = phi_1843_;
                                                                        phi_1844_ = _e1254;
                                                                        phi_1845_ = _e981;
                                                                    }
                                                                    let _e1256 = phi_1844_;
                                                                    let _e1258 = phi_1845_;
                                                                    phi_1849_ = _e1256;
                                                                    phi_1850_ = _e1258;
                                                                }
                                                                let _e1260 = phi_1849_;
                                                                let _e1262 = phi_1850_;
                                                                phi_1851_ = _e1260;
                                                                phi_1852_ = _e916;
                                                                phi_1853_ = _e1262;
                                                            }
                                                            let _e1264 = phi_1851_;
                                                            let _e1266 = phi_1852_;
                                                            let _e1268 = phi_1853_;
                                                            phi_1854_ = _e1264;
                                                            phi_1855_ = _e1266;
                                                            phi_1856_ = _e1268;
                                                        }
                                                        let _e1270 = phi_1854_;
                                                        let _e1272 = phi_1855_;
                                                        let _e1274 = phi_1856_;
                                                        phi_1864_ = _e1270;
                                                        phi_1865_ = select(_e1274, true, _e1272);
                                                    } else {
                                                        phi_1864_ = type_28();
                                                        phi_1865_ = true;
                                                    }
                                                    let _e1277 = phi_1864_;
                                                    let _e1279 = phi_1865_;
                                                    if _e1279 {
                                                        phi_1869_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1869_ = _e1277;
                                                    }
                                                    let _e1281 = phi_1869_;
                                                    if (_e1281.member_3 != 4294967295u) {
                                                        if (_e749 == _e102) {
                                                            phi_2198_ = false;
                                                        } else {
                                                            let _e1285 = (_e749 < arrayLength((&global_5.member)));
                                                            if _e1285 {
                                                                if _e1285 {
                                                                } else {
                                                                    phi_2741_ = true;
                                                                    break;
                                                                }
                                                                let _e1287 = global_5.member[_e749];
                                                                phi_1892_ = _e1287;
                                                            } else {
                                                                phi_1892_ = 4294967295u;
                                                            }
                                                            let _e1289 = phi_1892_;
                                                            let _e1290 = (_e1289 < arrayLength((&global_6.member)));
                                                            if _e1290 {
                                                                if _e1290 {
                                                                } else {
                                                                    phi_2741_ = true;
                                                                    break;
                                                                }
                                                                let _e1292 = global_6.member[_e1289];
                                                                phi_1906_ = _e1292;
                                                            } else {
                                                                phi_1906_ = 0i;
                                                            }
                                                            let _e1294 = phi_1906_;
                                                            let _e1295 = (_e1294 == 0i);
                                                            if _e1295 {
                                                                phi_2197_ = true;
                                                            } else {
                                                                if _e331 {
                                                                    phi_1927_ = vec3<f32>(_e819[0][0], _e819[0][1], _e819[0][2]);
                                                                } else {
                                                                    if (_e307 == 1u) {
                                                                        phi_1926_ = vec3<f32>(_e819[0][2], _e819[0][0], _e819[0][1]);
                                                                    } else {
                                                                        phi_1926_ = vec3<f32>(_e819[0][1], _e819[0][2], _e819[0][0]);
                                                                    }
                                                                    let _e1300 = phi_1926_;
                                                                    phi_1927_ = _e1300;
                                                                }
                                                                let _e1303 = phi_1927_;
                                                                if _e331 {
                                                                    phi_1944_ = vec3<f32>(_e819[1][0], _e819[1][1], _e819[1][2]);
                                                                } else {
                                                                    if (_e307 == 1u) {
                                                                        phi_1943_ = vec3<f32>(_e819[1][2], _e819[1][0], _e819[1][1]);
                                                                    } else {
                                                                        phi_1943_ = vec3<f32>(_e819[1][1], _e819[1][2], _e819[1][0]);
                                                                    }
                                                                    let _e1308 = phi_1943_;
                                                                    phi_1944_ = _e1308;
                                                                }
                                                                let _e1311 = phi_1944_;
                                                                if _e331 {
                                                                    phi_1961_ = vec3<f32>(_e819[2][0], _e819[2][1], _e819[2][2]);
                                                                } else {
                                                                    if (_e307 == 1u) {
                                                                        phi_1960_ = vec3<f32>(_e819[2][2], _e819[2][0], _e819[2][1]);
                                                                    } else {
                                                                        phi_1960_ = vec3<f32>(_e819[2][1], _e819[2][2], _e819[2][0]);
                                                                    }
                                                                    let _e1316 = phi_1960_;
                                                                    phi_1961_ = _e1316;
                                                                }
                                                                let _e1319 = phi_1961_;
                                                                let _e1322 = (_e1311.x - _e1303.x);
                                                                let _e1325 = (_e1311.y - _e1303.y);
                                                                let _e1328 = (_e1311.z - _e1303.z);
                                                                let _e1330 = (_e1319.x - _e1303.x);
                                                                let _e1332 = (_e1319.y - _e1303.y);
                                                                let _e1334 = (_e1319.z - _e1303.z);
                                                                if (_e174.member_1 == 1u) {
                                                                    phi_1997_ = (vec3<f32>(_e174.member[0], _e174.member[1], _e174.member[2]) - _e1303);
                                                                } else {
                                                                    phi_1997_ = vec3<f32>(_e174.member[0], _e174.member[1], _e174.member[2]);
                                                                }
                                                                let _e1349 = phi_1997_;
                                                                let _e1355 = bitcast<f32>((bitcast<u32>((_e1322 * _e1332)) ^ _e174.member_3[0]));
                                                                let _e1359 = bitcast<f32>((bitcast<u32>((_e1325 * _e1330)) ^ _e174.member_3[0]));
                                                                let _e1363 = bitcast<f32>((bitcast<u32>((_e1325 * _e1334)) ^ _e174.member_3[0]));
                                                                let _e1367 = bitcast<f32>((bitcast<u32>((_e1328 * _e1332)) ^ _e174.member_3[0]));
                                                                let _e1371 = bitcast<f32>((bitcast<u32>((_e1328 * _e1330)) ^ _e174.member_3[0]));
                                                                let _e1375 = bitcast<f32>((bitcast<u32>((_e1322 * _e1334)) ^ _e174.member_3[0]));
                                                                let _e1376 = (_e1363 - _e1367);
                                                                let _e1377 = (_e1371 - _e1375);
                                                                let _e1378 = (_e1355 - _e1359);
                                                                let _e1402 = (bitcast<f32>((bitcast<u32>(_e1363) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1367) & 2147483647u)));
                                                                let _e1409 = (bitcast<f32>((bitcast<u32>(_e1371) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1375) & 2147483647u)));
                                                                let _e1416 = (bitcast<f32>((bitcast<u32>(_e1355) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u)));
                                                                if (_e174.member_2 == 0f) {
                                                                    phi_2179_ = 0f;
                                                                } else {
                                                                    let _e1446 = bitcast<f32>((bitcast<u32>(_e1376) & 2147483647u));
                                                                    let _e1449 = bitcast<f32>((bitcast<u32>(_e1377) & 2147483647u));
                                                                    let _e1452 = bitcast<f32>((bitcast<u32>(_e1378) & 2147483647u));
                                                                    let _e1454 = select(_e1452, _e1449, (_e1449 > _e1452));
                                                                    let _e1458 = select(_e1452, _e1449, (_e1449 < _e1452));
                                                                    let _e1462 = select(_e1449, _e1446, (_e1446 < _e1449));
                                                                    let _e1464 = select(_e1449, _e1446, (_e1446 > _e1449));
                                                                    let _e1466 = select(_e1452, _e1464, (_e1464 < _e1452));
                                                                    phi_2179_ = bitcast<f32>((bitcast<u32>((_e174.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1454, _e1446, (_e1446 > _e1454)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1466, _e1462, (_e1462 > _e1466)))) ^ _e174.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1458, _e1446, (_e1446 < _e1458)))) ^ _e174.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1402 + _e1409) + _e1416))) ^ _e174.member_3[0]))) * 1.0000005f)) ^ _e174.member_3[0])))) ^ _e174.member_3[0]));
                                                                }
                                                                let _e1493 = phi_2179_;
                                                                phi_2197_ = (_e1295 || !(((((bitcast<f32>((bitcast<u32>((_e1349.x * _e1376)) ^ _e174.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1349.y * _e1377)) ^ _e174.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1349.z * _e1378)) ^ _e174.member_3[0]))) * f32(-(_e1294))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1349.x) & 2147483647u)) * _e1402)) ^ _e174.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1349.y) & 2147483647u)) * _e1409)) ^ _e174.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1349.z) & 2147483647u)) * _e1416)) ^ _e174.member_3[0]))))) ^ _e174.member_3[0])) + _e1493) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1507 = phi_2197_;
                                                            phi_2198_ = _e1507;
                                                        }
                                                        let _e1509 = phi_2198_;
                                                        if _e1509 {
                                                            phi_2203_ = type_55(_e720.member, true);
                                                        } else {
                                                            phi_2203_ = _e720;
                                                        }
                                                        let _e1514 = phi_2203_;
                                                        phi_2204_ = _e1514;
                                                    } else {
                                                        phi_2204_ = _e720;
                                                    }
                                                    let _e1516 = phi_2204_;
                                                    phi_891_ = _e1516;
                                                } else {
                                                    phi_891_ = type_55();
                                                }
                                                let _e1518 = phi_891_;
                                                continue;
                                                continuing {
                                                    phi_890_ = _e1518;
                                                    phi_893_ = _e735;
                                                    phi_2741_ = _e493;
                                                    break if !(_e741);
                                                }
                                            }
                                            let _e1521 = phi_2741_;
                                            phi_2907_ = _e1521;
                                            if _e1521 {
                                                break;
                                            }
                                            let _e1523 = local_2;
                                            phi_2911_ = _e1521;
                                            let _e1720 = local_4;
                                            phi_2660_ = _e1720;
                                            phi_2661_ = _e518;
                                            phi_2662_ = false;
                                            phi_2663_ = select(_e522, 0u, _e1523.member_1);
                                        } else {
                                            if (_e518 >= _e77) {
                                                phi_2265_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e518 < _e77) {
                                                } else {
                                                    phi_2907_ = true;
                                                    break;
                                                }
                                                let _e532 = (_e307 % 3u);
                                                if (_e532 < 3u) {
                                                } else {
                                                    phi_2907_ = true;
                                                    break;
                                                }
                                                let _e538 = global_4.member[_e518].member[_e532];
                                                let _e544 = (_e306 % 3u);
                                                if (_e544 < 3u) {
                                                } else {
                                                    phi_2907_ = true;
                                                    break;
                                                }
                                                let _e550 = global_4.member[_e518].member[_e544];
                                                let _e556 = (_e308 % 3u);
                                                if (_e556 < 3u) {
                                                } else {
                                                    phi_2907_ = true;
                                                    break;
                                                }
                                                let _e562 = global_4.member[_e518].member[_e556];
                                                let _e572 = global_4.member[_e518].member_1;
                                                let _e576 = global_4.member[_e518].member_2;
                                                phi_2265_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e538[0], _e538[1], _e538[2], _e538[3]), vec4<f32>(_e550[0], _e550[1], _e550[2], _e550[3]), vec4<f32>(_e562[0], _e562[1], _e562[2], _e562[3])), _e572, _e576);
                                            }
                                            let _e579 = phi_2265_;
                                            let _e591 = ((_e579.member[0].x - _e362) * _e367);
                                            let _e592 = ((_e579.member[0].y - _e362) * _e367);
                                            let _e593 = ((_e579.member[0].z - _e363) * _e367);
                                            let _e594 = ((_e579.member[0].w - _e363) * _e367);
                                            let _e604 = ((_e579.member[1].x - _e398) * _e403);
                                            let _e605 = ((_e579.member[1].y - _e398) * _e403);
                                            let _e606 = ((_e579.member[1].z - _e399) * _e403);
                                            let _e607 = ((_e579.member[1].w - _e399) * _e403);
                                            let _e617 = ((_e579.member[2].x - _e434) * _e439);
                                            let _e618 = ((_e579.member[2].y - _e434) * _e439);
                                            let _e619 = ((_e579.member[2].z - _e435) * _e439);
                                            let _e620 = ((_e579.member[2].w - _e435) * _e439);
                                            let _e622 = select(_e619, _e617, (_e617 < _e619));
                                            let _e624 = select(_e620, _e618, (_e618 < _e620));
                                            let _e626 = select(_e619, _e617, (_e617 > _e619));
                                            let _e628 = select(_e620, _e618, (_e618 > _e620));
                                            let _e630 = select(_e593, _e591, (_e591 < _e593));
                                            let _e632 = select(_e594, _e592, (_e592 < _e594));
                                            let _e634 = select(_e606, _e604, (_e604 < _e606));
                                            let _e636 = select(_e607, _e605, (_e605 < _e607));
                                            let _e638 = select(_e634, _e630, (_e630 > _e634));
                                            let _e640 = select(_e636, _e632, (_e632 > _e636));
                                            let _e642 = select(_e622, _e638, (_e638 > _e622));
                                            let _e644 = select(_e624, _e640, (_e640 > _e624));
                                            let _e646 = select(_e593, _e591, (_e591 > _e593));
                                            let _e648 = select(_e594, _e592, (_e592 > _e594));
                                            let _e650 = select(_e606, _e604, (_e604 > _e606));
                                            let _e652 = select(_e607, _e605, (_e605 > _e607));
                                            let _e654 = select(_e650, _e646, (_e646 < _e650));
                                            let _e656 = select(_e652, _e648, (_e648 < _e652));
                                            let _e661 = -(_e622);
                                            let _e662 = -(_e624);
                                            let _e669 = (select(_e626, _e654, (_e654 < _e626)) + (select(_e661, _e626, (_e626 > _e661)) * 0.0000019073523f));
                                            let _e670 = (select(_e628, _e656, (_e656 < _e628)) + (select(_e662, _e628, (_e628 > _e662)) * 0.0000019073523f));
                                            let _e672 = select(_e485, _e642, (_e642 > _e485));
                                            let _e674 = select(_e485, _e644, (_e644 > _e485));
                                            let _e679 = (_e672 <= select(_e495.member, _e669, (_e669 < _e495.member)));
                                            let _e680 = (_e674 <= select(_e495.member, _e670, (_e670 < _e495.member)));
                                            let _e681 = (_e672 <= _e674);
                                            if _e679 {
                                                if _e680 {
                                                    if _e681 {
                                                        phi_2609_ = _e579.member_2;
                                                    } else {
                                                        phi_2609_ = _e579.member_1;
                                                    }
                                                    let _e685 = phi_2609_;
                                                    let _e688 = (_e522 % 128u);
                                                    let _e689 = (_e688 < 128u);
                                                    if _e689 {
                                                    } else {
                                                        phi_2907_ = true;
                                                        break;
                                                    }
                                                    local_1[_e688] = _e685;
                                                    if _e689 {
                                                    } else {
                                                        phi_2907_ = true;
                                                        break;
                                                    }
                                                    local[_e688] = select(_e674, _e672, (_e672 > _e674));
                                                    if _e681 {
                                                        phi_2637_ = _e579.member_1;
                                                    } else {
                                                        phi_2637_ = _e579.member_2;
                                                    }
                                                    let _e696 = phi_2637_;
                                                    phi_2638_ = _e696;
                                                    phi_2639_ = (_e522 + 1u);
                                                } else {
                                                    phi_2638_ = u32();
                                                    phi_2639_ = u32();
                                                }
                                                let _e698 = phi_2638_;
                                                let _e700 = phi_2639_;
                                                phi_2641_ = _e698;
                                                phi_2642_ = _e700;
                                                phi_2643_ = select(true, false, _e680);
                                            } else {
                                                phi_2641_ = u32();
                                                phi_2642_ = u32();
                                                phi_2643_ = true;
                                            }
                                            let _e703 = phi_2641_;
                                            let _e705 = phi_2642_;
                                            let _e707 = phi_2643_;
                                            if _e707 {
                                                if _e679 {
                                                    phi_2652_ = _e579.member_1;
                                                } else {
                                                    phi_2652_ = _e579.member_2;
                                                }
                                                let _e711 = phi_2652_;
                                                phi_2657_ = _e711;
                                                phi_2658_ = select(_e680, true, _e679);
                                            } else {
                                                phi_2657_ = _e703;
                                                phi_2658_ = _e520;
                                            }
                                            let _e714 = phi_2657_;
                                            let _e716 = phi_2658_;
                                            phi_2911_ = _e493;
                                            phi_2660_ = _e495;
                                            phi_2661_ = _e714;
                                            phi_2662_ = _e716;
                                            phi_2663_ = select(_e705, _e522, _e707);
                                        }
                                        let _e1527 = phi_2911_;
                                        let _e1529 = phi_2660_;
                                        let _e1531 = phi_2661_;
                                        let _e1533 = phi_2662_;
                                        let _e1535 = phi_2663_;
                                        phi_2910_ = _e1527;
                                        phi_2664_ = _e1529;
                                        phi_2665_ = _e1531;
                                        phi_2666_ = (_e499 - 1u);
                                        phi_2667_ = _e1533;
                                        phi_2668_ = _e1535;
                                    } else {
                                        phi_2910_ = _e493;
                                        phi_2664_ = _e495;
                                        phi_2665_ = _e518;
                                        phi_2666_ = _e499;
                                        phi_2667_ = _e520;
                                        phi_2668_ = _e522;
                                    }
                                    let _e1537 = phi_2910_;
                                    let _e1539 = phi_2664_;
                                    let _e1541 = phi_2665_;
                                    let _e1543 = phi_2666_;
                                    let _e1545 = phi_2667_;
                                    let _e1547 = phi_2668_;
                                    phi_2909_ = _e1537;
                                    phi_2669_ = _e1539;
                                    phi_2670_ = _e1541;
                                    phi_2671_ = _e1543;
                                    phi_2672_ = _e1545;
                                    phi_2673_ = _e1547;
                                } else {
                                    phi_2909_ = _e493;
                                    phi_2669_ = type_55();
                                    phi_2670_ = u32();
                                    phi_2671_ = u32();
                                    phi_2672_ = bool();
                                    phi_2673_ = u32();
                                }
                                let _e1549 = phi_2909_;
                                let _e1551 = phi_2669_;
                                let _e1553 = phi_2670_;
                                let _e1555 = phi_2671_;
                                let _e1557 = phi_2672_;
                                let _e1559 = phi_2673_;
                                phi_2908_ = _e1549;
                                phi_822_ = _e1551;
                                phi_825_ = _e1553;
                                phi_827_ = _e1555;
                                phi_829_ = _e1557;
                                phi_831_ = _e1559;
                                phi_2674_ = _e507;
                            } else {
                                phi_2908_ = _e493;
                                phi_822_ = type_55();
                                phi_825_ = u32();
                                phi_827_ = u32();
                                phi_829_ = bool();
                                phi_831_ = u32();
                                phi_2674_ = false;
                            }
                            let _e1561 = phi_2908_;
                            let _e1563 = phi_822_;
                            let _e1565 = phi_825_;
                            let _e1567 = phi_827_;
                            let _e1569 = phi_829_;
                            let _e1571 = phi_831_;
                            let _e1573 = phi_2674_;
                            continue;
                            continuing {
                                phi_2747_ = _e1561;
                                phi_821_ = _e1563;
                                phi_824_ = _e1565;
                                phi_826_ = _e1567;
                                phi_828_ = _e1569;
                                phi_830_ = _e1571;
                                phi_2907_ = _e1561;
                                break if !(_e1573);
                            }
                        }
                        let _e1576 = phi_2907_;
                        if _e1576 {
                            break;
                        }
                        let _e1578 = local_3;
                        if _e1578.member_1 {
                        } else {
                            if _e175 {
                            } else {
                                break;
                            }
                            let _e1582 = global_9.member[_e95];
                            if _e96 {
                            } else {
                                break;
                            }
                            let _e1586 = global_8.member[_e95].member_1;
                            if _e175 {
                            } else {
                                break;
                            }
                            global_9.member[_e95] = type_30(_e1582.member, _e1582.member_1, _e1582.member_2, array<f32, 3>((_e1582.member_3[0] + (_e1586[0] * _e1582.member_1[0])), (_e1582.member_3[1] + (_e1586[1] * _e1582.member_1[1])), (_e1582.member_3[2] + (_e1586[2] * _e1582.member_1[2]))), _e1582.member_4);
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
