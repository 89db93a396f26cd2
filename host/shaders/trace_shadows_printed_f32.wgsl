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

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: type_28,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_31 {
    member: array<type_29>,
}

struct type_35 {
    member: type_28,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_41 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_46 {
    member: f32,
    member_1: bool,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: array<i32>,
}

struct type_55 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_57 {
    member: array<type_55>,
}

struct type_60 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_62 {
    member: type_60,
    member_1: u32,
}

struct type_67 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_31;
@group(0) @binding(1) 
var<uniform> global_3: type_48;
@group(0) @binding(2) 
var<uniform> global_4: type_48;
@group(0) @binding(4) 
var<storage> global_5: type_20;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_51;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_67;
@group(0) @binding(7) 
var<storage> global_9: type_37;
@group(0) @binding(3) 
var<storage> global_10: type_57;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_285_: u32;
    var phi_329_: i32;
    var phi_469_: type_41;
    var phi_619_: i32;
    var phi_620_: i32;
    var phi_630_: bool;
    var phi_640_: u32;
    var phi_641_: u32;
    var phi_643_: bool;
    var phi_648_: u32;
    var phi_681_: i32;
    var phi_699_: f32;
    var phi_705_: f32;
    var phi_745_: f32;
    var phi_751_: f32;
    var phi_803_: f32;
    var phi_815_: f32;
    var phi_824_: f32;
    var phi_830_: f32;
    var phi_870_: f32;
    var phi_876_: f32;
    var phi_928_: f32;
    var phi_940_: f32;
    var phi_949_: f32;
    var phi_955_: f32;
    var phi_995_: f32;
    var phi_1001_: f32;
    var phi_1053_: f32;
    var phi_1065_: f32;
    var phi_1120_: i32;
    var phi_1142_: u32;
    var phi_1143_: u32;
    var phi_1180_: i32;
    var phi_1202_: u32;
    var phi_1203_: u32;
    var phi_1211_: f32;
    var phi_1212_: f32;
    var phi_3927_: bool;
    var phi_1295_: type_46;
    var phi_1298_: bool;
    var phi_1300_: u32;
    var phi_1302_: u32;
    var phi_1304_: type_62;
    var phi_1315_: bool;
    var phi_1401_: bool;
    var phi_1402_: u32;
    var phi_1403_: type_62;
    var phi_2828_: type_55;
    var phi_3714_: type_62;
    var phi_3791_: type_62;
    var phi_3792_: u32;
    var phi_3793_: type_62;
    var phi_3795_: u32;
    var phi_3796_: type_62;
    var phi_3797_: bool;
    var phi_3804_: type_62;
    var phi_3809_: bool;
    var phi_3811_: type_62;
    var phi_1421_: type_46;
    var phi_1424_: type_8;
    var phi_1425_: type_8;
    var phi_1447_: type_8;
    var phi_1468_: u32;
    var phi_1560_: array<array<f32, 3>, 3>;
    var phi_1712_: bool;
    var phi_1741_: bool;
    var phi_2160_: f32;
    var phi_2161_: f32;
    var phi_2162_: f32;
    var phi_2163_: f32;
    var phi_2164_: vec3<f32>;
    var phi_2165_: vec3<f32>;
    var phi_2166_: vec3<f32>;
    var phi_2167_: vec3<f32>;
    var phi_2204_: bool;
    var phi_2213_: vec3<f32>;
    var phi_2378_: f32;
    var phi_2380_: f32;
    var phi_2381_: bool;
    var phi_2401_: f32;
    var phi_2402_: f32;
    var phi_2425_: type_27;
    var phi_2427_: type_27;
    var phi_2428_: bool;
    var phi_2432_: type_27;
    var phi_2433_: type_27;
    var phi_2434_: type_27;
    var phi_2435_: bool;
    var phi_2439_: type_27;
    var phi_2440_: bool;
    var phi_2441_: type_27;
    var phi_2442_: bool;
    var phi_2443_: bool;
    var phi_2444_: type_27;
    var phi_2445_: bool;
    var phi_2446_: bool;
    var phi_2454_: type_27;
    var phi_2455_: bool;
    var phi_2459_: type_27;
    var phi_2482_: u32;
    var phi_2496_: i32;
    var phi_2518_: vec3<f32>;
    var phi_2519_: vec3<f32>;
    var phi_2537_: vec3<f32>;
    var phi_2538_: vec3<f32>;
    var phi_2556_: vec3<f32>;
    var phi_2557_: vec3<f32>;
    var phi_2593_: vec3<f32>;
    var phi_2775_: f32;
    var phi_2793_: bool;
    var phi_2794_: bool;
    var phi_2799_: type_46;
    var phi_2800_: type_46;
    var phi_1422_: type_46;
    var phi_3921_: bool;
    var local_10: type_46;
    var phi_4117_: bool;
    var phi_3815_: type_46;
    var phi_3816_: bool;
    var phi_3817_: u32;
    var phi_3818_: type_62;
    var phi_4116_: bool;
    var phi_3819_: type_46;
    var phi_3820_: bool;
    var phi_3821_: u32;
    var phi_3822_: u32;
    var phi_3823_: type_62;
    var phi_4115_: bool;
    var phi_3824_: type_46;
    var phi_3825_: bool;
    var phi_3826_: u32;
    var phi_3827_: u32;
    var phi_3828_: type_62;
    var phi_4114_: bool;
    var phi_1296_: type_46;
    var phi_1299_: bool;
    var phi_1301_: u32;
    var phi_1303_: u32;
    var phi_1305_: type_62;
    var phi_3829_: bool;
    var phi_4113_: bool;
    var local_11: type_46;
    var local_12: type_46;

    switch bitcast<i32>(0u) {
        default: {
            let _e92 = global;
            let _e95 = arrayLength((&global_10.member));
            let _e97 = arrayLength((&global_5.member));
            let _e109 = arrayLength((&global_8.member));
            let _e113 = global_4.member[0u][0u];
            let _e117 = global_4.member[0u][1u];
            let _e121 = global_4.member[0u][2u];
            let _e125 = global_4.member[1u][0u];
            let _e129 = global_4.member[1u][1u];
            let _e133 = global_4.member[1u][2u];
            let _e137 = global_4.member[1u][3u];
            let _e141 = (_e92.x + (_e92.y * 2097152u));
            let _e148 = (_e141 < arrayLength((&global_9.member)));
            if _e148 {
                if _e148 {
                } else {
                    break;
                }
                let _e152 = global_9.member[_e141].member_2;
                phi_285_ = _e152;
            } else {
                phi_285_ = 4294967295u;
            }
            let _e154 = phi_285_;
            let _e157 = global_1.member[0u];
            let _e161 = global_3.member[0u][0u];
            let _e165 = global_3.member[0u][1u];
            let _e169 = global_3.member[0u][2u];
            let _e173 = global_3.member[0u][3u];
            let _e177 = global_3.member[1u][0u];
            let _e181 = global_3.member[1u][1u];
            let _e185 = global_3.member[1u][2u];
            let _e189 = global_3.member[1u][3u];
            let _e190 = bitcast<f32>(_e161);
            let _e191 = bitcast<f32>(_e165);
            let _e192 = bitcast<f32>(_e169);
            let _e194 = bitcast<f32>(_e177);
            let _e195 = array<u32, 3>(_e181, _e185, _e189);
            let _e197 = bitcast<i32>(_e157);
            if (_e197 < -126i) {
                phi_329_ = -126i;
            } else {
                phi_329_ = select(_e197, 127i, (_e197 > 127i));
            }
            let _e202 = phi_329_;
            let _e207 = bitcast<f32>((bitcast<u32>((_e202 + 127i)) << bitcast<u32>(23i)));
            let _e213 = bitcast<f32>((bitcast<u32>(((_e197 - _e202) + 127i)) << bitcast<u32>(23i)));
            if (_e173 == 0u) {
                phi_469_ = type_41(array<f32, 3>(_e190, _e191, _e192), _e173, _e194, _e195);
            } else {
                let _e215 = bitcast<u32>(_e190);
                let _e217 = ((_e215 & 2139095040u) != 0u);
                let _e232 = bitcast<u32>(_e191);
                let _e234 = ((_e232 & 2139095040u) != 0u);
                let _e249 = bitcast<u32>(_e192);
                let _e251 = ((_e249 & 2139095040u) != 0u);
                let _e267 = bitcast<u32>(_e194);
                let _e269 = ((_e267 & 2139095040u) != 0u);
                phi_469_ = type_41(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e215 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e215 & 2147483648u))), _e190, _e217) * _e207) * select(0.00000011920929f, 1f, _e217)) * _e213), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e232 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e232 & 2147483648u))), _e191, _e234) * _e207) * select(0.00000011920929f, 1f, _e234)) * _e213), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e249 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e249 & 2147483648u))), _e192, _e251) * _e207) * select(0.00000011920929f, 1f, _e251)) * _e213)), _e173, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e267 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e267 & 2147483648u))), _e194, _e269) * _e207) * select(0.00000011920929f, 1f, _e269)) * _e213), _e195);
            }
            let _e286 = phi_469_;
            if _e148 {
                let _e287 = (_e141 < arrayLength((&global_2.member)));
                if _e287 {
                    if _e148 {
                    } else {
                        break;
                    }
                    let _e292 = global_9.member[_e141].member.member_1;
                    let _e297 = global_9.member[_e141].member.member_3;
                    if (_e292 <= _e297) {
                        let _e299 = (1u < _e109);
                        if _e299 {
                            if (0u < _e109) {
                            } else {
                                break;
                            }
                            let _e303 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e303 + 1u) < _e303) {
                                if _e299 {
                                } else {
                                    break;
                                }
                                let _e308 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e148 {
                        } else {
                            break;
                        }
                        let _e318 = global_9.member[_e141].member.member_2[0u];
                        let _e320 = (bitcast<u32>(_e318) & 2147483647u);
                        let _e326 = global_9.member[_e141].member.member_2[1u];
                        let _e328 = (bitcast<u32>(_e326) & 2147483647u);
                        let _e334 = global_9.member[_e141].member.member_2[2u];
                        let _e336 = (bitcast<u32>(_e334) & 2147483647u);
                        let _e342 = global_9.member[_e141].member.member[0u];
                        let _e344 = (bitcast<u32>(_e342) & 2147483647u);
                        let _e350 = global_9.member[_e141].member.member[1u];
                        let _e352 = (bitcast<u32>(_e350) & 2147483647u);
                        let _e358 = global_9.member[_e141].member.member[2u];
                        let _e360 = (bitcast<u32>(_e358) & 2147483647u);
                        let _e362 = select(_e328, _e320, (_e328 < _e320));
                        let _e364 = select(_e336, _e362, (_e336 < _e362));
                        let _e366 = select(_e344, _e364, (_e344 < _e364));
                        let _e368 = select(_e352, _e366, (_e352 < _e366));
                        let _e370 = select(_e360, _e368, (_e360 < _e368));
                        let _e371 = bitcast<u32>(_e292);
                        let _e372 = (_e371 & 2147483647u);
                        let _e376 = bitcast<u32>(_e297);
                        let _e377 = (_e376 & 2147483647u);
                        let _e381 = (((select(_e372, _e370, (_e372 < _e370)) < 2139095040u) && (_e377 <= 2139095040u)) && (_e364 > 0u));
                        if _e381 {
                            let _e384 = (bitcast<u32>(bitcast<f32>(_e364)) & 2147483647u);
                            if (_e384 >= 8388608u) {
                                phi_619_ = (bitcast<i32>((_e384 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_619_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e384)), 32u, (_e384 == 0u))));
                            }
                            let _e398 = phi_619_;
                            phi_620_ = _e398;
                        } else {
                            phi_620_ = 0i;
                        }
                        let _e400 = phi_620_;
                        let _e401 = (_e320 == _e364);
                        if _e401 {
                            phi_630_ = true;
                        } else {
                            phi_630_ = (_e328 == _e364);
                        }
                        let _e404 = phi_630_;
                        let _e405 = select(1u, 0u, _e401);
                        if _e404 {
                            let _e406 = (_e405 + 1u);
                            phi_640_ = _e406;
                            phi_641_ = _e406;
                            phi_643_ = select(true, false, (_e406 == 2u));
                        } else {
                            phi_640_ = u32();
                            phi_641_ = 0u;
                            phi_643_ = true;
                        }
                        let _e410 = phi_640_;
                        let _e412 = phi_641_;
                        let _e414 = phi_643_;
                        if _e414 {
                            phi_648_ = (_e412 + 1u);
                        } else {
                            phi_648_ = 0u;
                        }
                        let _e418 = phi_648_;
                        let _e419 = select(_e410, _e412, _e414);
                        let _e420 = select(_e405, select(2u, _e405, _e404), _e414);
                        let _e421 = -(_e400);
                        if (_e421 < -126i) {
                            phi_681_ = -126i;
                        } else {
                            phi_681_ = select(_e421, 127i, (_e421 > 127i));
                        }
                        let _e426 = phi_681_;
                        let _e431 = bitcast<f32>((bitcast<u32>((_e426 + 127i)) << bitcast<u32>(23i)));
                        let _e437 = bitcast<f32>((bitcast<u32>(((_e421 - _e426) + 127i)) << bitcast<u32>(23i)));
                        let _e442 = global_9.member[_e141].member.member;
                        let _e443 = (_e419 == 0u);
                        if _e443 {
                            phi_699_ = _e442[0];
                        } else {
                            phi_699_ = _e442[1];
                        }
                        let _e447 = phi_699_;
                        let _e448 = (_e419 == 2u);
                        if _e448 {
                            phi_705_ = _e442[2];
                        } else {
                            phi_705_ = _e447;
                        }
                        let _e451 = phi_705_;
                        let _e452 = bitcast<u32>(_e451);
                        let _e454 = ((_e452 & 2139095040u) != 0u);
                        let _e466 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e452 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e452 & 2147483648u))), _e451, _e454) * select(0.00000011920929f, 1f, _e454));
                        let _e467 = global_9.member[_e141].member.member_2;
                        if _e443 {
                            phi_745_ = _e467[0];
                        } else {
                            phi_745_ = _e467[1];
                        }
                        let _e471 = phi_745_;
                        if _e448 {
                            phi_751_ = _e467[2];
                        } else {
                            phi_751_ = _e471;
                        }
                        let _e474 = phi_751_;
                        let _e475 = bitcast<u32>(_e474);
                        let _e477 = ((_e475 & 2139095040u) != 0u);
                        let _e491 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e475 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e475 & 2147483648u))), _e474, _e477) * _e431) * select(0.00000011920929f, 1f, _e477)) * _e437);
                        let _e495 = (bitcast<f32>((bitcast<u32>(_e491) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e495 {
                            let _e499 = (bitcast<f32>((bitcast<u32>(_e466) & 2147483647u)) * 0.00000011920929f);
                            phi_803_ = select(0.00000000000011368684f, _e499, (_e499 > 0.00000000000011368684f));
                        } else {
                            phi_803_ = 0f;
                        }
                        let _e503 = phi_803_;
                        let _e504 = (_e466 + _e503);
                        let _e505 = (_e466 - _e503);
                        let _e506 = select(_e491, 0f, _e495);
                        if _e495 {
                            phi_815_ = 38685626000000000000000000f;
                        } else {
                            phi_815_ = (1f / _e491);
                        }
                        let _e509 = phi_815_;
                        let _e510 = (_e418 == 0u);
                        if _e510 {
                            phi_824_ = _e442[0];
                        } else {
                            phi_824_ = _e442[1];
                        }
                        let _e514 = phi_824_;
                        let _e515 = (_e418 == 2u);
                        if _e515 {
                            phi_830_ = _e442[2];
                        } else {
                            phi_830_ = _e514;
                        }
                        let _e518 = phi_830_;
                        let _e519 = bitcast<u32>(_e518);
                        let _e521 = ((_e519 & 2139095040u) != 0u);
                        let _e533 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e519 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e519 & 2147483648u))), _e518, _e521) * select(0.00000011920929f, 1f, _e521));
                        if _e510 {
                            phi_870_ = _e467[0];
                        } else {
                            phi_870_ = _e467[1];
                        }
                        let _e537 = phi_870_;
                        if _e515 {
                            phi_876_ = _e467[2];
                        } else {
                            phi_876_ = _e537;
                        }
                        let _e540 = phi_876_;
                        let _e541 = bitcast<u32>(_e540);
                        let _e543 = ((_e541 & 2139095040u) != 0u);
                        let _e557 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e541 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e541 & 2147483648u))), _e540, _e543) * _e431) * select(0.00000011920929f, 1f, _e543)) * _e437);
                        let _e561 = (bitcast<f32>((bitcast<u32>(_e557) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e561 {
                            let _e565 = (bitcast<f32>((bitcast<u32>(_e533) & 2147483647u)) * 0.00000011920929f);
                            phi_928_ = select(0.00000000000011368684f, _e565, (_e565 > 0.00000000000011368684f));
                        } else {
                            phi_928_ = 0f;
                        }
                        let _e569 = phi_928_;
                        let _e570 = (_e533 + _e569);
                        let _e571 = (_e533 - _e569);
                        let _e572 = select(_e557, 0f, _e561);
                        if _e561 {
                            phi_940_ = 38685626000000000000000000f;
                        } else {
                            phi_940_ = (1f / _e557);
                        }
                        let _e575 = phi_940_;
                        let _e576 = (_e420 == 0u);
                        if _e576 {
                            phi_949_ = _e442[0];
                        } else {
                            phi_949_ = _e442[1];
                        }
                        let _e580 = phi_949_;
                        let _e581 = (_e420 == 2u);
                        if _e581 {
                            phi_955_ = _e442[2];
                        } else {
                            phi_955_ = _e580;
                        }
                        let _e584 = phi_955_;
                        let _e585 = bitcast<u32>(_e584);
                        let _e587 = ((_e585 & 2139095040u) != 0u);
                        let _e599 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e585 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e585 & 2147483648u))), _e584, _e587) * select(0.00000011920929f, 1f, _e587));
                        if _e576 {
                            phi_995_ = _e467[0];
                        } else {
                            phi_995_ = _e467[1];
                        }
                        let _e603 = phi_995_;
                        if _e581 {
                            phi_1001_ = _e467[2];
                        } else {
                            phi_1001_ = _e603;
                        }
                        let _e606 = phi_1001_;
                        let _e607 = bitcast<u32>(_e606);
                        let _e609 = ((_e607 & 2139095040u) != 0u);
                        let _e623 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e607 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e607 & 2147483648u))), _e606, _e609) * _e431) * select(0.00000011920929f, 1f, _e609)) * _e437);
                        let _e627 = (bitcast<f32>((bitcast<u32>(_e623) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e627 {
                            let _e631 = (bitcast<f32>((bitcast<u32>(_e599) & 2147483647u)) * 0.00000011920929f);
                            phi_1053_ = select(0.00000000000011368684f, _e631, (_e631 > 0.00000000000011368684f));
                        } else {
                            phi_1053_ = 0f;
                        }
                        let _e635 = phi_1053_;
                        let _e636 = (_e599 + _e635);
                        let _e637 = (_e599 - _e635);
                        let _e638 = select(_e623, 0f, _e627);
                        if _e627 {
                            phi_1065_ = 38685626000000000000000000f;
                        } else {
                            phi_1065_ = (1f / _e623);
                        }
                        let _e641 = phi_1065_;
                        let _e644 = bitcast<f32>((bitcast<u32>(_e466) & 2147483647u));
                        let _e647 = bitcast<f32>((bitcast<u32>(_e533) & 2147483647u));
                        let _e649 = select(_e647, _e644, (_e644 > _e647));
                        let _e652 = bitcast<f32>((bitcast<u32>(_e599) & 2147483647u));
                        if (_e381 && (select(_e652, _e649, (_e649 > _e652)) <= 1099511600000f)) {
                            let _e664 = ((_e372 & 8388607u) | (select(0u, 1u, ((_e372 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e667 = bitcast<i32>((_e372 >> bitcast<u32>(23i)));
                            let _e671 = (_e664 == 0u);
                            let _e674 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e664)), 32u, _e671)) - 8i);
                            if (_e667 == 255i) {
                                phi_1120_ = 255i;
                            } else {
                                phi_1120_ = (((_e667 + select(0i, 1i, (_e667 == 0i))) - _e674) + _e400);
                            }
                            let _e682 = phi_1120_;
                            let _e692 = (_e682 <= 0i);
                            if _e692 {
                                phi_1143_ = u32();
                            } else {
                                if _e671 {
                                    phi_1142_ = u32();
                                } else {
                                    phi_1142_ = select(((bitcast<u32>(_e682) << bitcast<u32>(23i)) | ((_e664 << bitcast<u32>(((_e674 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e682 >= 255i));
                                }
                                let _e696 = phi_1142_;
                                phi_1143_ = _e696;
                            }
                            let _e698 = phi_1143_;
                            let _e710 = ((_e377 & 8388607u) | (select(0u, 1u, ((_e377 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e713 = bitcast<i32>((_e377 >> bitcast<u32>(23i)));
                            let _e717 = (_e710 == 0u);
                            let _e720 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e710)), 32u, _e717)) - 8i);
                            if (_e713 == 255i) {
                                phi_1180_ = 255i;
                            } else {
                                phi_1180_ = (((_e713 + select(0i, 1i, (_e713 == 0i))) - _e720) + _e400);
                            }
                            let _e728 = phi_1180_;
                            let _e738 = (_e728 <= 0i);
                            if _e738 {
                                phi_1203_ = u32();
                            } else {
                                if _e717 {
                                    phi_1202_ = u32();
                                } else {
                                    phi_1202_ = select(((bitcast<u32>(_e728) << bitcast<u32>(23i)) | ((_e710 << bitcast<u32>(((_e720 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e728 >= 255i));
                                }
                                let _e742 = phi_1202_;
                                phi_1203_ = _e742;
                            }
                            let _e744 = phi_1203_;
                            phi_1211_ = bitcast<f32>(((_e376 & 2147483648u) | select(_e744, 0u, select(_e717, true, _e738))));
                            phi_1212_ = bitcast<f32>(((_e371 & 2147483648u) | select(_e698, 0u, select(_e671, true, _e692))));
                        } else {
                            phi_1211_ = 0f;
                            phi_1212_ = 1f;
                        }
                        let _e750 = phi_1211_;
                        let _e752 = phi_1212_;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e113), bitcast<f32>(_e117), bitcast<f32>(_e121));
                        let _e757 = (_e419 % 3u);
                        let _e758 = (_e757 < 3u);
                        if _e758 {
                        } else {
                            break;
                        }
                        let _e760 = local_9[_e757];
                        let _e761 = (_e418 % 3u);
                        let _e762 = (_e761 < 3u);
                        if _e762 {
                        } else {
                            break;
                        }
                        let _e764 = local_9[_e761];
                        let _e765 = (_e420 % 3u);
                        let _e766 = (_e765 < 3u);
                        if _e766 {
                        } else {
                            break;
                        }
                        let _e768 = local_9[_e765];
                        local_8 = array<f32, 3>(bitcast<f32>(_e125), bitcast<f32>(_e129), bitcast<f32>(_e133));
                        if _e758 {
                        } else {
                            break;
                        }
                        let _e772 = local_8[_e757];
                        if _e762 {
                        } else {
                            break;
                        }
                        let _e774 = local_8[_e761];
                        if _e766 {
                        } else {
                            break;
                        }
                        let _e776 = local_8[_e765];
                        phi_3927_ = false;
                        phi_1295_ = type_46(_e750, false);
                        phi_1298_ = (_e752 <= _e750);
                        phi_1300_ = ((3u * _e95) + 1u);
                        phi_1302_ = 0u;
                        phi_1304_ = type_62(type_60(array<f32, 3>(_e760, _e764, _e768), array<f32, 3>(_e772, _e774, _e776)), select(0u, 2147483648u, (_e95 == 0u)));
                        loop {
                            let _e784 = phi_3927_;
                            let _e786 = phi_1295_;
                            let _e788 = phi_1298_;
                            let _e790 = phi_1300_;
                            let _e792 = phi_1302_;
                            let _e794 = phi_1304_;
                            local_11 = _e786;
                            if _e788 {
                                phi_1315_ = true;
                            } else {
                                phi_1315_ = (_e792 > 0u);
                            }
                            let _e797 = phi_1315_;
                            if _e797 {
                                let _e798 = (_e790 > 0u);
                                if _e798 {
                                    if _e788 {
                                        phi_1401_ = _e788;
                                        phi_1402_ = _e792;
                                        phi_1403_ = _e794;
                                    } else {
                                        let _e799 = (_e792 - 1u);
                                        let _e800 = (_e799 % 128u);
                                        let _e801 = (_e800 < 128u);
                                        if _e801 {
                                        } else {
                                            phi_4113_ = true;
                                            break;
                                        }
                                        let _e803 = local_6[_e800];
                                        if _e801 {
                                        } else {
                                            phi_4113_ = true;
                                            break;
                                        }
                                        let _e805 = local_5[_e800];
                                        if _e801 {
                                        } else {
                                            phi_4113_ = true;
                                            break;
                                        }
                                        let _e807 = local_4[_e800];
                                        if _e801 {
                                        } else {
                                            phi_4113_ = true;
                                            break;
                                        }
                                        let _e809 = local_3[_e800];
                                        if _e801 {
                                        } else {
                                            phi_4113_ = true;
                                            break;
                                        }
                                        let _e812 = local_2[_e800];
                                        if _e801 {
                                        } else {
                                            phi_4113_ = true;
                                            break;
                                        }
                                        let _e814 = local_1[_e800];
                                        if _e801 {
                                        } else {
                                            phi_4113_ = true;
                                            break;
                                        }
                                        let _e816 = local[_e800];
                                        if _e801 {
                                        } else {
                                            phi_4113_ = true;
                                            break;
                                        }
                                        let _e821 = local_7[_e800];
                                        phi_1401_ = (_e821 <= _e786.member);
                                        phi_1402_ = _e799;
                                        phi_1403_ = type_62(type_60(array<f32, 3>(_e805, _e807, _e809), array<f32, 3>(_e812, _e814, _e816)), _e803);
                                    }
                                    let _e825 = phi_1401_;
                                    let _e827 = phi_1402_;
                                    let _e829 = phi_1403_;
                                    if _e825 {
                                        if ((_e829.member_1 & 2147483648u) != 0u) {
                                            phi_1421_ = _e786;
                                            phi_1424_ = type_8(0u, ((_e829.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1205 = phi_1421_;
                                                let _e1207 = phi_1424_;
                                                local_10 = _e1205;
                                                local_12 = _e1205;
                                                if (_e1207.member < _e1207.member_1) {
                                                    phi_1425_ = type_8((_e1207.member + 1u), _e1207.member_1);
                                                    phi_1447_ = type_8(1u, _e1207.member);
                                                } else {
                                                    phi_1425_ = _e1207;
                                                    phi_1447_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1220 = phi_1425_;
                                                let _e1222 = phi_1447_;
                                                let _e1226 = (bitcast<i32>(_e1222.member) != 0i);
                                                if _e1226 {
                                                    let _e1227 = ((_e829.member_1 & 268435455u) + _e1222.member_1);
                                                    let _e1228 = (_e1227 < _e97);
                                                    if _e1228 {
                                                        if _e1228 {
                                                        } else {
                                                            phi_3921_ = true;
                                                            break;
                                                        }
                                                        let _e1232 = global_5.member[_e1227].member_1;
                                                        phi_1468_ = _e1232;
                                                    } else {
                                                        phi_1468_ = 4294967295u;
                                                    }
                                                    let _e1234 = phi_1468_;
                                                    if (_e1227 >= _e97) {
                                                        phi_1560_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1228 {
                                                        } else {
                                                            phi_3921_ = true;
                                                            break;
                                                        }
                                                        if (_e757 < 9u) {
                                                        } else {
                                                            phi_3921_ = true;
                                                            break;
                                                        }
                                                        let _e1241 = global_5.member[_e1227].member[_e757];
                                                        if (_e761 < 9u) {
                                                        } else {
                                                            phi_3921_ = true;
                                                            break;
                                                        }
                                                        let _e1247 = global_5.member[_e1227].member[_e761];
                                                        if (_e765 < 9u) {
                                                        } else {
                                                            phi_3921_ = true;
                                                            break;
                                                        }
                                                        let _e1253 = global_5.member[_e1227].member[_e765];
                                                        let _e1255 = (3u + _e757);
                                                        if (_e1255 < 9u) {
                                                        } else {
                                                            phi_3921_ = true;
                                                            break;
                                                        }
                                                        let _e1261 = global_5.member[_e1227].member[_e1255];
                                                        let _e1262 = (3u + _e761);
                                                        if (_e1262 < 9u) {
                                                        } else {
                                                            phi_3921_ = true;
                                                            break;
                                                        }
                                                        let _e1268 = global_5.member[_e1227].member[_e1262];
                                                        let _e1269 = (3u + _e765);
                                                        if (_e1269 < 9u) {
                                                        } else {
                                                            phi_3921_ = true;
                                                            break;
                                                        }
                                                        let _e1275 = global_5.member[_e1227].member[_e1269];
                                                        let _e1277 = (6u + _e757);
                                                        if (_e1277 < 9u) {
                                                        } else {
                                                            phi_3921_ = true;
                                                            break;
                                                        }
                                                        let _e1283 = global_5.member[_e1227].member[_e1277];
                                                        let _e1284 = (6u + _e761);
                                                        if (_e1284 < 9u) {
                                                        } else {
                                                            phi_3921_ = true;
                                                            break;
                                                        }
                                                        let _e1290 = global_5.member[_e1227].member[_e1284];
                                                        let _e1291 = (6u + _e765);
                                                        if (_e1291 < 9u) {
                                                        } else {
                                                            phi_3921_ = true;
                                                            break;
                                                        }
                                                        let _e1297 = global_5.member[_e1227].member[_e1291];
                                                        phi_1560_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1241, _e1247, _e1253), array<f32, 3>(_e1261, _e1268, _e1275), array<f32, 3>(_e1283, _e1290, _e1297));
                                                    }
                                                    let _e1301 = phi_1560_;
                                                    let _e1309 = (_e1301[0][2] - _e599);
                                                    let _e1312 = (((_e1301[0][0] - _e466) * _e638) - (_e1309 * _e506));
                                                    let _e1315 = (((_e1301[0][1] - _e533) * _e638) - (_e1309 * _e572));
                                                    let _e1322 = (_e1301[1][2] - _e599);
                                                    let _e1325 = (((_e1301[1][0] - _e466) * _e638) - (_e1322 * _e506));
                                                    let _e1328 = (((_e1301[1][1] - _e533) * _e638) - (_e1322 * _e572));
                                                    let _e1335 = (_e1301[2][2] - _e599);
                                                    let _e1338 = (((_e1301[2][0] - _e466) * _e638) - (_e1335 * _e506));
                                                    let _e1341 = (((_e1301[2][1] - _e533) * _e638) - (_e1335 * _e572));
                                                    let _e1342 = (_e1338 * _e1328);
                                                    let _e1343 = (_e1341 * _e1325);
                                                    let _e1344 = (_e1312 * _e1341);
                                                    let _e1345 = (_e1315 * _e1338);
                                                    let _e1346 = (_e1325 * _e1315);
                                                    let _e1347 = (_e1328 * _e1312);
                                                    let _e1352 = (((_e1342 >= _e1343) && (_e1344 >= _e1345)) && (_e1346 >= _e1347));
                                                    if (_e1352 || (((_e1342 <= _e1343) && (_e1344 <= _e1345)) && (_e1346 <= _e1347))) {
                                                        let _e1359 = select(-1f, 1f, _e1352);
                                                        let _e1361 = ((_e1342 - _e1343) * _e1359);
                                                        let _e1363 = select(0f, _e1361, (_e1361 > 0f));
                                                        let _e1365 = ((_e1344 - _e1345) * _e1359);
                                                        let _e1367 = select(0f, _e1365, (_e1365 > 0f));
                                                        let _e1369 = ((_e1346 - _e1347) * _e1359);
                                                        let _e1371 = select(0f, _e1369, (_e1369 > 0f));
                                                        let _e1373 = ((_e1363 + _e1367) + _e1371);
                                                        if (_e1373 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2444_ = type_27();
                                                            phi_2445_ = true;
                                                            phi_2446_ = false;
                                                        } else {
                                                            let _e1376 = select(_e1325, _e1312, (_e1312 < _e1325));
                                                            if (select(_e1338, _e1376, (_e1376 < _e1338)) > 0f) {
                                                                phi_1712_ = true;
                                                            } else {
                                                                let _e1381 = select(_e1325, _e1312, (_e1312 > _e1325));
                                                                phi_1712_ = (select(_e1338, _e1381, (_e1381 > _e1338)) < 0f);
                                                            }
                                                            let _e1386 = phi_1712_;
                                                            if _e1386 {
                                                                phi_2441_ = type_27();
                                                                phi_2442_ = true;
                                                                phi_2443_ = false;
                                                            } else {
                                                                let _e1388 = select(_e1328, _e1315, (_e1315 < _e1328));
                                                                if (select(_e1341, _e1388, (_e1388 < _e1341)) > 0f) {
                                                                    phi_1741_ = true;
                                                                } else {
                                                                    let _e1393 = select(_e1328, _e1315, (_e1315 > _e1328));
                                                                    phi_1741_ = (select(_e1341, _e1393, (_e1393 > _e1341)) < 0f);
                                                                }
                                                                let _e1398 = phi_1741_;
                                                                if _e1398 {
                                                                    phi_2439_ = type_27();
                                                                    phi_2440_ = false;
                                                                } else {
                                                                    let _e1400 = select(_e1301[1][0], _e1301[0][0], (_e1301[0][0] < _e1301[1][0]));
                                                                    let _e1404 = select(_e1301[1][0], _e1301[0][0], (_e1301[0][0] > _e1301[1][0]));
                                                                    let _e1408 = select(_e1301[1][1], _e1301[0][1], (_e1301[0][1] < _e1301[1][1]));
                                                                    let _e1412 = select(_e1301[1][1], _e1301[0][1], (_e1301[0][1] > _e1301[1][1]));
                                                                    let _e1416 = select(_e1301[1][2], _e1301[0][2], (_e1301[0][2] < _e1301[1][2]));
                                                                    let _e1420 = select(_e1301[1][2], _e1301[0][2], (_e1301[0][2] > _e1301[1][2]));
                                                                    let _e1425 = ((select(_e1301[2][0], _e1400, (_e1400 < _e1301[2][0])) - _e504) * _e509);
                                                                    let _e1426 = ((select(_e1301[2][0], _e1404, (_e1404 > _e1301[2][0])) - _e505) * _e509);
                                                                    let _e1429 = ((select(_e1301[2][1], _e1408, (_e1408 < _e1301[2][1])) - _e570) * _e575);
                                                                    let _e1430 = ((select(_e1301[2][1], _e1412, (_e1412 > _e1301[2][1])) - _e571) * _e575);
                                                                    let _e1433 = ((select(_e1301[2][2], _e1416, (_e1416 < _e1301[2][2])) - _e636) * _e641);
                                                                    let _e1434 = ((select(_e1301[2][2], _e1420, (_e1420 > _e1301[2][2])) - _e637) * _e641);
                                                                    let _e1436 = select(_e1434, _e1433, (_e1433 < _e1434));
                                                                    let _e1438 = select(_e1434, _e1433, (_e1433 > _e1434));
                                                                    let _e1440 = select(_e1426, _e1425, (_e1425 < _e1426));
                                                                    let _e1442 = select(_e1430, _e1429, (_e1429 < _e1430));
                                                                    let _e1444 = select(_e1442, _e1440, (_e1440 > _e1442));
                                                                    let _e1446 = select(_e1436, _e1444, (_e1444 > _e1436));
                                                                    let _e1448 = select(_e1426, _e1425, (_e1425 > _e1426));
                                                                    let _e1450 = select(_e1430, _e1429, (_e1429 > _e1430));
                                                                    let _e1452 = select(_e1450, _e1448, (_e1448 < _e1450));
                                                                    let _e1454 = select(_e1438, _e1452, (_e1452 < _e1438));
                                                                    let _e1455 = -(_e1436);
                                                                    let _e1461 = select(_e752, _e1446, (_e1446 > _e752));
                                                                    if (_e1461 > (_e1454 + (select(_e1455, _e1438, (_e1438 > _e1455)) * 0.0000019073523f))) {
                                                                        phi_2434_ = type_27();
                                                                        phi_2435_ = true;
                                                                    } else {
                                                                        let _e1463 = (_e1461 > _e1205.member);
                                                                        if _e1463 {
                                                                            phi_2433_ = type_27();
                                                                        } else {
                                                                            let _e1464 = vec3<f32>(_e1301[0][0], _e1301[0][1], _e1301[0][2]);
                                                                            let _e1465 = vec3<f32>(_e1301[1][0], _e1301[1][1], _e1301[1][2]);
                                                                            let _e1466 = vec3<f32>(_e1301[2][0], _e1301[2][1], _e1301[2][2]);
                                                                            let _e1467 = (_e1301[1][0] - _e1301[0][0]);
                                                                            let _e1468 = (_e1301[1][1] - _e1301[0][1]);
                                                                            let _e1469 = (_e1301[1][2] - _e1301[0][2]);
                                                                            let _e1470 = vec3<f32>(_e1467, _e1468, _e1469);
                                                                            let _e1471 = (_e1301[2][0] - _e1301[1][0]);
                                                                            let _e1472 = (_e1301[2][1] - _e1301[1][1]);
                                                                            let _e1473 = (_e1301[2][2] - _e1301[1][2]);
                                                                            let _e1474 = vec3<f32>(_e1471, _e1472, _e1473);
                                                                            let _e1475 = (_e1301[0][0] - _e1301[2][0]);
                                                                            let _e1476 = (_e1301[0][1] - _e1301[2][1]);
                                                                            let _e1477 = (_e1301[0][2] - _e1301[2][2]);
                                                                            let _e1478 = vec3<f32>(_e1475, _e1476, _e1477);
                                                                            let _e1481 = bitcast<f32>((bitcast<u32>(_e1467) & 2147483647u));
                                                                            let _e1484 = bitcast<f32>((bitcast<u32>(_e1468) & 2147483647u));
                                                                            let _e1486 = select(_e1484, _e1481, (_e1481 > _e1484));
                                                                            let _e1489 = bitcast<f32>((bitcast<u32>(_e1469) & 2147483647u));
                                                                            let _e1491 = select(_e1489, _e1486, (_e1486 > _e1489));
                                                                            let _e1494 = bitcast<f32>((bitcast<u32>(_e1471) & 2147483647u));
                                                                            let _e1497 = bitcast<f32>((bitcast<u32>(_e1472) & 2147483647u));
                                                                            let _e1499 = select(_e1497, _e1494, (_e1494 > _e1497));
                                                                            let _e1502 = bitcast<f32>((bitcast<u32>(_e1473) & 2147483647u));
                                                                            let _e1504 = select(_e1502, _e1499, (_e1499 > _e1502));
                                                                            let _e1507 = bitcast<f32>((bitcast<u32>(_e1475) & 2147483647u));
                                                                            let _e1510 = bitcast<f32>((bitcast<u32>(_e1476) & 2147483647u));
                                                                            let _e1512 = select(_e1510, _e1507, (_e1507 > _e1510));
                                                                            let _e1515 = bitcast<f32>((bitcast<u32>(_e1477) & 2147483647u));
                                                                            let _e1517 = select(_e1515, _e1512, (_e1512 > _e1515));
                                                                            let _e1519 = select(_e1504, _e1491, (_e1491 > _e1504));
                                                                            let _e1521 = select(_e1517, _e1519, (_e1519 > _e1517));
                                                                            if (_e1491 == _e1521) {
                                                                                phi_2160_ = _e1328;
                                                                                phi_2161_ = _e1325;
                                                                                phi_2162_ = _e1315;
                                                                                phi_2163_ = _e1312;
                                                                                phi_2164_ = _e1464;
                                                                                phi_2165_ = _e1478;
                                                                                phi_2166_ = _e1474;
                                                                                phi_2167_ = _e1470;
                                                                            } else {
                                                                                let _e1523 = (_e1504 == _e1521);
                                                                                let _e1528 = vec3(_e1523);
                                                                                phi_2160_ = select(_e1315, _e1341, _e1523);
                                                                                phi_2161_ = select(_e1312, _e1338, _e1523);
                                                                                phi_2162_ = select(_e1341, _e1328, _e1523);
                                                                                phi_2163_ = select(_e1338, _e1325, _e1523);
                                                                                phi_2164_ = select(_e1466, _e1465, _e1528);
                                                                                phi_2165_ = select(_e1474, _e1470, _e1528);
                                                                                phi_2166_ = select(_e1470, _e1478, _e1528);
                                                                                phi_2167_ = select(_e1478, _e1474, _e1528);
                                                                            }
                                                                            let _e1534 = phi_2160_;
                                                                            let _e1536 = phi_2161_;
                                                                            let _e1538 = phi_2162_;
                                                                            let _e1540 = phi_2163_;
                                                                            let _e1542 = phi_2164_;
                                                                            let _e1544 = phi_2165_;
                                                                            let _e1546 = phi_2166_;
                                                                            let _e1548 = phi_2167_;
                                                                            let _e1555 = ((_e1546.y * _e1544.z) - (_e1544.y * _e1546.z));
                                                                            let _e1560 = ((_e1546.z * _e1544.x) - (_e1544.z * _e1546.x));
                                                                            let _e1563 = ((_e1546.x * _e1544.y) - (_e1544.x * _e1546.y));
                                                                            if (_e1363 >= _e1367) {
                                                                                phi_2204_ = select(true, false, (_e1363 >= _e1371));
                                                                            } else {
                                                                                phi_2204_ = true;
                                                                            }
                                                                            let _e1568 = phi_2204_;
                                                                            if _e1568 {
                                                                                phi_2213_ = select(_e1466, _e1465, vec3((_e1367 >= _e1371)));
                                                                            } else {
                                                                                phi_2213_ = _e1464;
                                                                            }
                                                                            let _e1573 = phi_2213_;
                                                                            let _e1584 = (((_e1555 * (_e1573.x - _e466)) + (_e1560 * (_e1573.y - _e533))) + (_e1563 * (_e1573.z - _e599)));
                                                                            let _e1589 = (((_e1555 * _e506) + (_e1560 * _e572)) + (_e1563 * _e638));
                                                                            let _e1590 = (_e1536 - _e1540);
                                                                            let _e1591 = (_e1534 - _e1538);
                                                                            let _e1599 = (-(((_e1540 * _e1590) + (_e1538 * _e1591))) / ((_e1590 * _e1590) + (_e1591 * _e1591)));
                                                                            let _e1601 = select(1f, _e1599, (_e1599 < 1f));
                                                                            let _e1603 = select(0f, _e1601, (_e1601 > 0f));
                                                                            let _e1616 = ((_e1542.x + (_e1548.x * _e1603)) - _e466);
                                                                            let _e1617 = ((_e1542.y + (_e1548.y * _e1603)) - _e533);
                                                                            let _e1618 = ((_e1542.z + (_e1548.z * _e1603)) - _e599);
                                                                            let _e1619 = (_e1618 / _e638);
                                                                            let _e1631 = bitcast<f32>((bitcast<u32>(_e1616) & 2147483647u));
                                                                            let _e1634 = bitcast<f32>((bitcast<u32>(_e1617) & 2147483647u));
                                                                            let _e1636 = select(_e1634, _e1631, (_e1631 > _e1634));
                                                                            let _e1639 = bitcast<f32>((bitcast<u32>(_e1618) & 2147483647u));
                                                                            let _e1641 = select(_e1639, _e1636, (_e1636 > _e1639));
                                                                            let _e1647 = bitcast<f32>((bitcast<u32>(_e1555) & 2147483647u));
                                                                            let _e1650 = bitcast<f32>((bitcast<u32>(_e1560) & 2147483647u));
                                                                            let _e1652 = select(_e1650, _e1647, (_e1647 > _e1650));
                                                                            let _e1655 = bitcast<f32>((bitcast<u32>(_e1563) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1555 * _e1616) + (_e1560 * _e1617)) + (_e1563 * _e1618)) - _e1584)) & 2147483647u)) <= ((0.0000009536743f * select(_e1521, _e1641, (_e1641 > _e1521))) * select(_e1655, _e1652, (_e1652 > _e1655)))) {
                                                                                let _e1665 = bitcast<f32>((bitcast<u32>(_e1546.x) & 2147483647u));
                                                                                let _e1668 = bitcast<f32>((bitcast<u32>(_e1546.y) & 2147483647u));
                                                                                let _e1670 = select(_e1668, _e1665, (_e1665 > _e1668));
                                                                                let _e1673 = bitcast<f32>((bitcast<u32>(_e1546.z) & 2147483647u));
                                                                                let _e1679 = bitcast<f32>((bitcast<u32>(_e1544.x) & 2147483647u));
                                                                                let _e1682 = bitcast<f32>((bitcast<u32>(_e1544.y) & 2147483647u));
                                                                                let _e1684 = select(_e1682, _e1679, (_e1679 > _e1682));
                                                                                let _e1687 = bitcast<f32>((bitcast<u32>(_e1544.z) & 2147483647u));
                                                                                let _e1691 = (bitcast<f32>((bitcast<u32>(_e1589) & 2147483647u)) > ((0.0000038146973f * select(_e1673, _e1670, (_e1670 > _e1673))) * select(_e1687, _e1684, (_e1684 > _e1687))));
                                                                                if _e1691 {
                                                                                    phi_2378_ = (_e1584 / _e1589);
                                                                                } else {
                                                                                    phi_2378_ = f32();
                                                                                }
                                                                                let _e1694 = phi_2378_;
                                                                                phi_2380_ = _e1694;
                                                                                phi_2381_ = select(true, false, _e1691);
                                                                            } else {
                                                                                phi_2380_ = f32();
                                                                                phi_2381_ = true;
                                                                            }
                                                                            let _e1697 = phi_2380_;
                                                                            let _e1699 = phi_2381_;
                                                                            if _e1699 {
                                                                                let _e1707 = (((_e1555 * (_e1616 - (_e506 * _e1619))) + (_e1560 * (_e1617 - (_e572 * _e1619)))) / _e1589);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1707) & 2147483647u)) <= _e1521) {
                                                                                    phi_2401_ = (_e1619 + _e1707);
                                                                                } else {
                                                                                    phi_2401_ = _e1619;
                                                                                }
                                                                                let _e1714 = phi_2401_;
                                                                                phi_2402_ = _e1714;
                                                                            } else {
                                                                                phi_2402_ = _e1697;
                                                                            }
                                                                            let _e1716 = phi_2402_;
                                                                            let _e1718 = select(_e1454, _e1716, (_e1716 < _e1454));
                                                                            let _e1720 = select(_e1446, _e1718, (_e1718 > _e1446));
                                                                            if (_e1720 >= _e752) {
                                                                                let _e1722 = (_e1720 <= _e1205.member);
                                                                                if _e1722 {
                                                                                    let _e1723 = (1f / _e1373);
                                                                                    phi_2425_ = type_27(_e1720, (_e1367 * _e1723), (_e1371 * _e1723), _e1234);
                                                                                } else {
                                                                                    phi_2425_ = type_27();
                                                                                }
                                                                                let _e1728 = phi_2425_;
                                                                                phi_2427_ = _e1728;
                                                                                phi_2428_ = select(true, false, _e1722);
                                                                            } else {
                                                                                phi_2427_ = type_27();
                                                                                phi_2428_ = true;
                                                                            }
                                                                            let _e1731 = phi_2427_;
                                                                            let _e1733 = phi_2428_;
                                                                            if _e1733 {
                                                                                phi_2432_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2432_ = _e1731;
                                                                            }
                                                                            let _e1735 = phi_2432_;
                                                                            phi_2433_ = _e1735;
                                                                        }
                                                                        let _e1737 = phi_2433_;
                                                                        phi_2434_ = _e1737;
                                                                        phi_2435_ = _e1463;
                                                                    }
                                                                    let _e1739 = phi_2434_;
                                                                    let _e1741 = phi_2435_;
                                                                    phi_2439_ = _e1739;
                                                                    phi_2440_ = _e1741;
                                                                }
                                                                let _e1743 = phi_2439_;
                                                                let _e1745 = phi_2440_;
                                                                phi_2441_ = _e1743;
                                                                phi_2442_ = _e1398;
                                                                phi_2443_ = _e1745;
                                                            }
                                                            let _e1747 = phi_2441_;
                                                            let _e1749 = phi_2442_;
                                                            let _e1751 = phi_2443_;
                                                            phi_2444_ = _e1747;
                                                            phi_2445_ = _e1749;
                                                            phi_2446_ = _e1751;
                                                        }
                                                        let _e1753 = phi_2444_;
                                                        let _e1755 = phi_2445_;
                                                        let _e1757 = phi_2446_;
                                                        phi_2454_ = _e1753;
                                                        phi_2455_ = select(_e1757, true, _e1755);
                                                    } else {
                                                        phi_2454_ = type_27();
                                                        phi_2455_ = true;
                                                    }
                                                    let _e1760 = phi_2454_;
                                                    let _e1762 = phi_2455_;
                                                    if _e1762 {
                                                        phi_2459_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2459_ = _e1760;
                                                    }
                                                    let _e1764 = phi_2459_;
                                                    if (_e1764.member_3 != 4294967295u) {
                                                        if (_e1234 == _e154) {
                                                            phi_2794_ = false;
                                                        } else {
                                                            let _e1768 = (_e1234 < arrayLength((&global_6.member)));
                                                            if _e1768 {
                                                                if _e1768 {
                                                                } else {
                                                                    phi_3921_ = true;
                                                                    break;
                                                                }
                                                                let _e1770 = global_6.member[_e1234];
                                                                phi_2482_ = _e1770;
                                                            } else {
                                                                phi_2482_ = 4294967295u;
                                                            }
                                                            let _e1772 = phi_2482_;
                                                            let _e1773 = (_e1772 < arrayLength((&global_7.member)));
                                                            if _e1773 {
                                                                if _e1773 {
                                                                } else {
                                                                    phi_3921_ = true;
                                                                    break;
                                                                }
                                                                let _e1775 = global_7.member[_e1772];
                                                                phi_2496_ = _e1775;
                                                            } else {
                                                                phi_2496_ = 0i;
                                                            }
                                                            let _e1777 = phi_2496_;
                                                            let _e1778 = (_e1777 == 0i);
                                                            if _e1778 {
                                                                phi_2793_ = true;
                                                            } else {
                                                                if _e443 {
                                                                    phi_2519_ = vec3<f32>(_e1301[0][0], _e1301[0][1], _e1301[0][2]);
                                                                } else {
                                                                    if (_e419 == 1u) {
                                                                        phi_2518_ = vec3<f32>(_e1301[0][2], _e1301[0][0], _e1301[0][1]);
                                                                    } else {
                                                                        phi_2518_ = vec3<f32>(_e1301[0][1], _e1301[0][2], _e1301[0][0]);
                                                                    }
                                                                    let _e1783 = phi_2518_;
                                                                    phi_2519_ = _e1783;
                                                                }
                                                                let _e1786 = phi_2519_;
                                                                if _e443 {
                                                                    phi_2538_ = vec3<f32>(_e1301[1][0], _e1301[1][1], _e1301[1][2]);
                                                                } else {
                                                                    if (_e419 == 1u) {
                                                                        phi_2537_ = vec3<f32>(_e1301[1][2], _e1301[1][0], _e1301[1][1]);
                                                                    } else {
                                                                        phi_2537_ = vec3<f32>(_e1301[1][1], _e1301[1][2], _e1301[1][0]);
                                                                    }
                                                                    let _e1791 = phi_2537_;
                                                                    phi_2538_ = _e1791;
                                                                }
                                                                let _e1794 = phi_2538_;
                                                                if _e443 {
                                                                    phi_2557_ = vec3<f32>(_e1301[2][0], _e1301[2][1], _e1301[2][2]);
                                                                } else {
                                                                    if (_e419 == 1u) {
                                                                        phi_2556_ = vec3<f32>(_e1301[2][2], _e1301[2][0], _e1301[2][1]);
                                                                    } else {
                                                                        phi_2556_ = vec3<f32>(_e1301[2][1], _e1301[2][2], _e1301[2][0]);
                                                                    }
                                                                    let _e1799 = phi_2556_;
                                                                    phi_2557_ = _e1799;
                                                                }
                                                                let _e1802 = phi_2557_;
                                                                let _e1805 = (_e1794.x - _e1786.x);
                                                                let _e1808 = (_e1794.y - _e1786.y);
                                                                let _e1811 = (_e1794.z - _e1786.z);
                                                                let _e1813 = (_e1802.x - _e1786.x);
                                                                let _e1815 = (_e1802.y - _e1786.y);
                                                                let _e1817 = (_e1802.z - _e1786.z);
                                                                if (_e286.member_1 == 1u) {
                                                                    phi_2593_ = (vec3<f32>(_e286.member[0], _e286.member[1], _e286.member[2]) - _e1786);
                                                                } else {
                                                                    phi_2593_ = vec3<f32>(_e286.member[0], _e286.member[1], _e286.member[2]);
                                                                }
                                                                let _e1832 = phi_2593_;
                                                                let _e1838 = bitcast<f32>((bitcast<u32>((_e1805 * _e1815)) ^ _e286.member_3[0]));
                                                                let _e1842 = bitcast<f32>((bitcast<u32>((_e1808 * _e1813)) ^ _e286.member_3[0]));
                                                                let _e1846 = bitcast<f32>((bitcast<u32>((_e1808 * _e1817)) ^ _e286.member_3[0]));
                                                                let _e1850 = bitcast<f32>((bitcast<u32>((_e1811 * _e1815)) ^ _e286.member_3[0]));
                                                                let _e1854 = bitcast<f32>((bitcast<u32>((_e1811 * _e1813)) ^ _e286.member_3[0]));
                                                                let _e1858 = bitcast<f32>((bitcast<u32>((_e1805 * _e1817)) ^ _e286.member_3[0]));
                                                                let _e1859 = (_e1846 - _e1850);
                                                                let _e1860 = (_e1854 - _e1858);
                                                                let _e1861 = (_e1838 - _e1842);
                                                                let _e1885 = (bitcast<f32>((bitcast<u32>(_e1846) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1850) & 2147483647u)));
                                                                let _e1892 = (bitcast<f32>((bitcast<u32>(_e1854) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1858) & 2147483647u)));
                                                                let _e1899 = (bitcast<f32>((bitcast<u32>(_e1838) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1842) & 2147483647u)));
                                                                if (_e286.member_2 == 0f) {
                                                                    phi_2775_ = 0f;
                                                                } else {
                                                                    let _e1929 = bitcast<f32>((bitcast<u32>(_e1859) & 2147483647u));
                                                                    let _e1932 = bitcast<f32>((bitcast<u32>(_e1860) & 2147483647u));
                                                                    let _e1935 = bitcast<f32>((bitcast<u32>(_e1861) & 2147483647u));
                                                                    let _e1937 = select(_e1935, _e1932, (_e1932 > _e1935));
                                                                    let _e1941 = select(_e1935, _e1932, (_e1932 < _e1935));
                                                                    let _e1945 = select(_e1932, _e1929, (_e1929 < _e1932));
                                                                    let _e1947 = select(_e1932, _e1929, (_e1929 > _e1932));
                                                                    let _e1949 = select(_e1935, _e1947, (_e1947 < _e1935));
                                                                    phi_2775_ = bitcast<f32>((bitcast<u32>((_e286.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1937, _e1929, (_e1929 > _e1937)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1949, _e1945, (_e1945 > _e1949)))) ^ _e286.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1941, _e1929, (_e1929 < _e1941)))) ^ _e286.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1885 + _e1892) + _e1899))) ^ _e286.member_3[0]))) * 1.0000005f)) ^ _e286.member_3[0])))) ^ _e286.member_3[0]));
                                                                }
                                                                let _e1976 = phi_2775_;
                                                                phi_2793_ = (_e1778 || !(((((bitcast<f32>((bitcast<u32>((_e1832.x * _e1859)) ^ _e286.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1832.y * _e1860)) ^ _e286.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1832.z * _e1861)) ^ _e286.member_3[0]))) * f32(-(_e1777))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1832.x) & 2147483647u)) * _e1885)) ^ _e286.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1832.y) & 2147483647u)) * _e1892)) ^ _e286.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1832.z) & 2147483647u)) * _e1899)) ^ _e286.member_3[0]))))) ^ _e286.member_3[0])) + _e1976) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1990 = phi_2793_;
                                                            phi_2794_ = _e1990;
                                                        }
                                                        let _e1992 = phi_2794_;
                                                        if _e1992 {
                                                            phi_2799_ = type_46(_e1205.member, true);
                                                        } else {
                                                            phi_2799_ = _e1205;
                                                        }
                                                        let _e1997 = phi_2799_;
                                                        phi_2800_ = _e1997;
                                                    } else {
                                                        phi_2800_ = _e1205;
                                                    }
                                                    let _e1999 = phi_2800_;
                                                    phi_1422_ = _e1999;
                                                } else {
                                                    phi_1422_ = type_46();
                                                }
                                                let _e2001 = phi_1422_;
                                                continue;
                                                continuing {
                                                    phi_1421_ = _e2001;
                                                    phi_1424_ = _e1220;
                                                    phi_3921_ = _e784;
                                                    break if !(_e1226);
                                                }
                                            }
                                            let _e2004 = phi_3921_;
                                            phi_4113_ = _e2004;
                                            if _e2004 {
                                                break;
                                            }
                                            let _e2006 = local_10;
                                            phi_4117_ = _e2004;
                                            let _e2211 = local_12;
                                            phi_3815_ = _e2211;
                                            phi_3816_ = false;
                                            phi_3817_ = select(_e827, 0u, _e2006.member_1);
                                            phi_3818_ = _e829;
                                        } else {
                                            let _e838 = (_e829.member_1 < _e95);
                                            if _e838 {
                                                if _e838 {
                                                } else {
                                                    phi_4113_ = true;
                                                    break;
                                                }
                                                let _e840 = global_10.member[_e829.member_1];
                                                phi_2828_ = _e840;
                                            } else {
                                                phi_2828_ = type_55(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e842 = phi_2828_;
                                            let _e857 = ((10u * _e419) & 31u);
                                            let _e860 = ((_e842.member[0] >> bitcast<u32>(_e857)) & 1023u);
                                            let _e868 = bitcast<f32>((bitcast<u32>(((_e829.member.member_1[0] - _e829.member.member[0]) * 0.0009775171f)) ^ _e137));
                                            let _e873 = (_e829.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e860)) - 8388608f) * _e868)) ^ _e137)));
                                            let _e877 = select(select(_e829.member.member_1[0], _e873, (_e873 < _e829.member.member_1[0])), _e829.member.member_1[0], (_e860 == 1023u));
                                            let _e879 = ((10u * _e418) & 31u);
                                            let _e882 = ((_e842.member[0] >> bitcast<u32>(_e879)) & 1023u);
                                            let _e890 = bitcast<f32>((bitcast<u32>(((_e829.member.member_1[1] - _e829.member.member[1]) * 0.0009775171f)) ^ _e137));
                                            let _e895 = (_e829.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e882)) - 8388608f) * _e890)) ^ _e137)));
                                            let _e899 = select(select(_e829.member.member_1[1], _e895, (_e895 < _e829.member.member_1[1])), _e829.member.member_1[1], (_e882 == 1023u));
                                            let _e901 = ((10u * _e420) & 31u);
                                            let _e904 = ((_e842.member[0] >> bitcast<u32>(_e901)) & 1023u);
                                            let _e912 = bitcast<f32>((bitcast<u32>(((_e829.member.member_1[2] - _e829.member.member[2]) * 0.0009775171f)) ^ _e137));
                                            let _e917 = (_e829.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e904)) - 8388608f) * _e912)) ^ _e137)));
                                            let _e921 = select(select(_e829.member.member_1[2], _e917, (_e917 < _e829.member.member_1[2])), _e829.member.member_1[2], (_e904 == 1023u));
                                            let _e924 = ((_e842.member[1] >> bitcast<u32>(_e857)) & 1023u);
                                            let _e932 = (_e829.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e924)) - 8388608f) * _e868)) ^ _e137)));
                                            let _e936 = select(select(_e829.member.member_1[0], _e932, (_e932 < _e829.member.member_1[0])), _e829.member.member_1[0], (_e924 == 1023u));
                                            let _e939 = ((_e842.member[1] >> bitcast<u32>(_e879)) & 1023u);
                                            let _e947 = (_e829.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e939)) - 8388608f) * _e890)) ^ _e137)));
                                            let _e951 = select(select(_e829.member.member_1[1], _e947, (_e947 < _e829.member.member_1[1])), _e829.member.member_1[1], (_e939 == 1023u));
                                            let _e954 = ((_e842.member[1] >> bitcast<u32>(_e901)) & 1023u);
                                            let _e962 = (_e829.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e954)) - 8388608f) * _e912)) ^ _e137)));
                                            let _e966 = select(select(_e829.member.member_1[2], _e962, (_e962 < _e829.member.member_1[2])), _e829.member.member_1[2], (_e954 == 1023u));
                                            let _e972 = ((_e842.member_1[0] >> bitcast<u32>(_e857)) & 1023u);
                                            let _e980 = (_e829.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e972)) - 8388608f) * _e868)) ^ _e137)));
                                            let _e984 = select(select(_e829.member.member_1[0], _e980, (_e980 < _e829.member.member_1[0])), _e829.member.member_1[0], (_e972 == 1023u));
                                            let _e987 = ((_e842.member_1[0] >> bitcast<u32>(_e879)) & 1023u);
                                            let _e995 = (_e829.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e987)) - 8388608f) * _e890)) ^ _e137)));
                                            let _e999 = select(select(_e829.member.member_1[1], _e995, (_e995 < _e829.member.member_1[1])), _e829.member.member_1[1], (_e987 == 1023u));
                                            let _e1002 = ((_e842.member_1[0] >> bitcast<u32>(_e901)) & 1023u);
                                            let _e1010 = (_e829.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1002)) - 8388608f) * _e912)) ^ _e137)));
                                            let _e1014 = select(select(_e829.member.member_1[2], _e1010, (_e1010 < _e829.member.member_1[2])), _e829.member.member_1[2], (_e1002 == 1023u));
                                            let _e1017 = ((_e842.member_1[1] >> bitcast<u32>(_e857)) & 1023u);
                                            let _e1025 = (_e829.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1017)) - 8388608f) * _e868)) ^ _e137)));
                                            let _e1029 = select(select(_e829.member.member_1[0], _e1025, (_e1025 < _e829.member.member_1[0])), _e829.member.member_1[0], (_e1017 == 1023u));
                                            let _e1032 = ((_e842.member_1[1] >> bitcast<u32>(_e879)) & 1023u);
                                            let _e1040 = (_e829.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1032)) - 8388608f) * _e890)) ^ _e137)));
                                            let _e1044 = select(select(_e829.member.member_1[1], _e1040, (_e1040 < _e829.member.member_1[1])), _e829.member.member_1[1], (_e1032 == 1023u));
                                            let _e1047 = ((_e842.member_1[1] >> bitcast<u32>(_e901)) & 1023u);
                                            let _e1055 = (_e829.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1047)) - 8388608f) * _e912)) ^ _e137)));
                                            let _e1059 = select(select(_e829.member.member_1[2], _e1055, (_e1055 < _e829.member.member_1[2])), _e829.member.member_1[2], (_e1047 == 1023u));
                                            let _e1064 = type_62(type_60(array<f32, 3>(_e877, _e899, _e921), array<f32, 3>(_e936, _e951, _e966)), _e842.member_2);
                                            let _e1069 = type_62(type_60(array<f32, 3>(_e984, _e999, _e1014), array<f32, 3>(_e1029, _e1044, _e1059)), _e842.member_3);
                                            let _e1075 = ((_e877 - _e504) * _e509);
                                            let _e1076 = ((_e984 - _e504) * _e509);
                                            let _e1077 = ((_e936 - _e505) * _e509);
                                            let _e1078 = ((_e1029 - _e505) * _e509);
                                            let _e1083 = ((_e899 - _e570) * _e575);
                                            let _e1084 = ((_e999 - _e570) * _e575);
                                            let _e1085 = ((_e951 - _e571) * _e575);
                                            let _e1086 = ((_e1044 - _e571) * _e575);
                                            let _e1091 = ((_e921 - _e636) * _e641);
                                            let _e1092 = ((_e1014 - _e636) * _e641);
                                            let _e1093 = ((_e966 - _e637) * _e641);
                                            let _e1094 = ((_e1059 - _e637) * _e641);
                                            let _e1096 = select(_e1093, _e1091, (_e1091 < _e1093));
                                            let _e1098 = select(_e1094, _e1092, (_e1092 < _e1094));
                                            let _e1100 = select(_e1093, _e1091, (_e1091 > _e1093));
                                            let _e1102 = select(_e1094, _e1092, (_e1092 > _e1094));
                                            let _e1104 = select(_e1077, _e1075, (_e1075 < _e1077));
                                            let _e1106 = select(_e1078, _e1076, (_e1076 < _e1078));
                                            let _e1108 = select(_e1085, _e1083, (_e1083 < _e1085));
                                            let _e1110 = select(_e1086, _e1084, (_e1084 < _e1086));
                                            let _e1112 = select(_e1108, _e1104, (_e1104 > _e1108));
                                            let _e1114 = select(_e1110, _e1106, (_e1106 > _e1110));
                                            let _e1116 = select(_e1096, _e1112, (_e1112 > _e1096));
                                            let _e1118 = select(_e1098, _e1114, (_e1114 > _e1098));
                                            let _e1120 = select(_e1077, _e1075, (_e1075 > _e1077));
                                            let _e1122 = select(_e1078, _e1076, (_e1076 > _e1078));
                                            let _e1124 = select(_e1085, _e1083, (_e1083 > _e1085));
                                            let _e1126 = select(_e1086, _e1084, (_e1084 > _e1086));
                                            let _e1128 = select(_e1124, _e1120, (_e1120 < _e1124));
                                            let _e1130 = select(_e1126, _e1122, (_e1122 < _e1126));
                                            let _e1135 = -(_e1096);
                                            let _e1136 = -(_e1098);
                                            let _e1143 = (select(_e1100, _e1128, (_e1128 < _e1100)) + (select(_e1135, _e1100, (_e1100 > _e1135)) * 0.0000019073523f));
                                            let _e1144 = (select(_e1102, _e1130, (_e1130 < _e1102)) + (select(_e1136, _e1102, (_e1102 > _e1136)) * 0.0000019073523f));
                                            let _e1146 = select(_e752, _e1116, (_e1116 > _e752));
                                            let _e1148 = select(_e752, _e1118, (_e1118 > _e752));
                                            let _e1153 = (_e1146 <= select(_e786.member, _e1143, (_e1143 < _e786.member)));
                                            let _e1154 = (_e1148 <= select(_e786.member, _e1144, (_e1144 < _e786.member)));
                                            let _e1155 = (_e1146 <= _e1148);
                                            if _e1153 {
                                                if _e1154 {
                                                    if _e1155 {
                                                        phi_3714_ = _e1069;
                                                    } else {
                                                        phi_3714_ = _e1064;
                                                    }
                                                    let _e1157 = phi_3714_;
                                                    let _e1165 = (_e827 % 128u);
                                                    let _e1166 = (_e1165 < 128u);
                                                    if _e1166 {
                                                    } else {
                                                        phi_4113_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1165] = _e1157.member_1;
                                                    if _e1166 {
                                                    } else {
                                                        phi_4113_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1165] = _e1157.member.member[0];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4113_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1165] = _e1157.member.member[1];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4113_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1165] = _e1157.member.member[2];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4113_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1165] = _e1157.member.member_1[0];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4113_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1165] = _e1157.member.member_1[1];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4113_ = true;
                                                        break;
                                                    }
                                                    local[_e1165] = _e1157.member.member_1[2];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4113_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1165] = select(_e1148, _e1146, !(_e1155));
                                                    if _e1155 {
                                                        phi_3791_ = _e1064;
                                                    } else {
                                                        phi_3791_ = _e1069;
                                                    }
                                                    let _e1183 = phi_3791_;
                                                    phi_3792_ = (_e827 + 1u);
                                                    phi_3793_ = _e1183;
                                                } else {
                                                    phi_3792_ = u32();
                                                    phi_3793_ = type_62();
                                                }
                                                let _e1185 = phi_3792_;
                                                let _e1187 = phi_3793_;
                                                phi_3795_ = _e1185;
                                                phi_3796_ = _e1187;
                                                phi_3797_ = select(true, false, _e1154);
                                            } else {
                                                phi_3795_ = u32();
                                                phi_3796_ = type_62();
                                                phi_3797_ = true;
                                            }
                                            let _e1190 = phi_3795_;
                                            let _e1192 = phi_3796_;
                                            let _e1194 = phi_3797_;
                                            if _e1194 {
                                                if _e1153 {
                                                    phi_3804_ = _e1064;
                                                } else {
                                                    phi_3804_ = _e1069;
                                                }
                                                let _e1196 = phi_3804_;
                                                phi_3809_ = select(_e1154, true, _e1153);
                                                phi_3811_ = _e1196;
                                            } else {
                                                phi_3809_ = _e825;
                                                phi_3811_ = _e1192;
                                            }
                                            let _e1199 = phi_3809_;
                                            let _e1201 = phi_3811_;
                                            phi_4117_ = _e784;
                                            phi_3815_ = _e786;
                                            phi_3816_ = _e1199;
                                            phi_3817_ = select(_e1190, _e827, _e1194);
                                            phi_3818_ = _e1201;
                                        }
                                        let _e2010 = phi_4117_;
                                        let _e2012 = phi_3815_;
                                        let _e2014 = phi_3816_;
                                        let _e2016 = phi_3817_;
                                        let _e2018 = phi_3818_;
                                        phi_4116_ = _e2010;
                                        phi_3819_ = _e2012;
                                        phi_3820_ = _e2014;
                                        phi_3821_ = (_e790 - 1u);
                                        phi_3822_ = _e2016;
                                        phi_3823_ = _e2018;
                                    } else {
                                        phi_4116_ = _e784;
                                        phi_3819_ = _e786;
                                        phi_3820_ = _e825;
                                        phi_3821_ = _e790;
                                        phi_3822_ = _e827;
                                        phi_3823_ = _e829;
                                    }
                                    let _e2020 = phi_4116_;
                                    let _e2022 = phi_3819_;
                                    let _e2024 = phi_3820_;
                                    let _e2026 = phi_3821_;
                                    let _e2028 = phi_3822_;
                                    let _e2030 = phi_3823_;
                                    phi_4115_ = _e2020;
                                    phi_3824_ = _e2022;
                                    phi_3825_ = _e2024;
                                    phi_3826_ = _e2026;
                                    phi_3827_ = _e2028;
                                    phi_3828_ = _e2030;
                                } else {
                                    phi_4115_ = _e784;
                                    phi_3824_ = type_46();
                                    phi_3825_ = bool();
                                    phi_3826_ = u32();
                                    phi_3827_ = u32();
                                    phi_3828_ = type_62();
                                }
                                let _e2032 = phi_4115_;
                                let _e2034 = phi_3824_;
                                let _e2036 = phi_3825_;
                                let _e2038 = phi_3826_;
                                let _e2040 = phi_3827_;
                                let _e2042 = phi_3828_;
                                phi_4114_ = _e2032;
                                phi_1296_ = _e2034;
                                phi_1299_ = _e2036;
                                phi_1301_ = _e2038;
                                phi_1303_ = _e2040;
                                phi_1305_ = _e2042;
                                phi_3829_ = _e798;
                            } else {
                                phi_4114_ = _e784;
                                phi_1296_ = type_46();
                                phi_1299_ = bool();
                                phi_1301_ = u32();
                                phi_1303_ = u32();
                                phi_1305_ = type_62();
                                phi_3829_ = false;
                            }
                            let _e2044 = phi_4114_;
                            let _e2046 = phi_1296_;
                            let _e2048 = phi_1299_;
                            let _e2050 = phi_1301_;
                            let _e2052 = phi_1303_;
                            let _e2054 = phi_1305_;
                            let _e2056 = phi_3829_;
                            continue;
                            continuing {
                                phi_3927_ = _e2044;
                                phi_1295_ = _e2046;
                                phi_1298_ = _e2048;
                                phi_1300_ = _e2050;
                                phi_1302_ = _e2052;
                                phi_1304_ = _e2054;
                                phi_4113_ = _e2044;
                                break if !(_e2056);
                            }
                        }
                        let _e2059 = phi_4113_;
                        if _e2059 {
                            break;
                        }
                        let _e2061 = local_11;
                        if _e2061.member_1 {
                        } else {
                            if _e287 {
                            } else {
                                break;
                            }
                            let _e2065 = global_2.member[_e141];
                            if _e148 {
                            } else {
                                break;
                            }
                            let _e2069 = global_9.member[_e141].member_1;
                            if _e287 {
                            } else {
                                break;
                            }
                            global_2.member[_e141] = type_29(_e2065.member, _e2065.member_1, _e2065.member_2, array<f32, 3>((_e2065.member_3[0] + (_e2069[0] * _e2065.member_1[0])), (_e2065.member_3[1] + (_e2069[1] * _e2065.member_1[1])), (_e2065.member_3[2] + (_e2069[2] * _e2065.member_1[2]))), _e2065.member_4);
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
fn trace_shadows_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
