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
    var phi_3930_: bool;
    var phi_1295_: type_46;
    var phi_1298_: u32;
    var phi_1300_: bool;
    var phi_1302_: u32;
    var phi_1304_: type_62;
    var phi_1315_: bool;
    var phi_1401_: bool;
    var phi_1402_: u32;
    var phi_1403_: type_62;
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
    var phi_3924_: bool;
    var phi_4175_: bool;
    var phi_2801_: type_46;
    var phi_2822_: type_55;
    var phi_3708_: type_62;
    var phi_3784_: type_62;
    var phi_3785_: u32;
    var phi_3786_: type_62;
    var phi_3788_: u32;
    var phi_3789_: type_62;
    var phi_3790_: bool;
    var phi_3797_: type_62;
    var phi_3802_: bool;
    var phi_3804_: type_62;
    var phi_3808_: bool;
    var phi_3809_: u32;
    var phi_3810_: type_62;
    var phi_3820_: u32;
    var phi_3821_: type_62;
    var phi_4119_: bool;
    var phi_3822_: type_46;
    var phi_3823_: u32;
    var phi_3824_: bool;
    var phi_3825_: u32;
    var phi_3826_: type_62;
    var phi_4118_: bool;
    var phi_3827_: type_46;
    var phi_3828_: u32;
    var phi_3829_: bool;
    var phi_3830_: u32;
    var phi_3831_: type_62;
    var phi_4117_: bool;
    var phi_1296_: type_46;
    var phi_1299_: u32;
    var phi_1301_: bool;
    var phi_1303_: u32;
    var phi_1305_: type_62;
    var phi_3832_: bool;
    var phi_4116_: bool;
    var local_10: type_46;
    var local_11: type_46;

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
                        phi_3930_ = false;
                        phi_1295_ = type_46(_e750, false);
                        phi_1298_ = ((3u * _e95) + 1u);
                        phi_1300_ = (_e752 <= _e750);
                        phi_1302_ = 0u;
                        phi_1304_ = type_62(type_60(array<f32, 3>(_e760, _e764, _e768), array<f32, 3>(_e772, _e774, _e776)), select(0u, 2147483648u, (_e95 == 0u)));
                        loop {
                            let _e784 = phi_3930_;
                            let _e786 = phi_1295_;
                            let _e788 = phi_1298_;
                            let _e790 = phi_1300_;
                            let _e792 = phi_1302_;
                            let _e794 = phi_1304_;
                            local_10 = _e786;
                            if _e790 {
                                phi_1315_ = true;
                            } else {
                                phi_1315_ = (_e792 > 0u);
                            }
                            let _e797 = phi_1315_;
                            if _e797 {
                                let _e798 = (_e788 > 0u);
                                if _e798 {
                                    if _e790 {
                                        phi_1401_ = _e790;
                                        phi_1402_ = _e792;
                                        phi_1403_ = _e794;
                                    } else {
                                        let _e799 = (_e792 - 1u);
                                        let _e800 = (_e799 % 128u);
                                        let _e801 = (_e800 < 128u);
                                        if _e801 {
                                        } else {
                                            phi_4116_ = true;
                                            break;
                                        }
                                        let _e803 = local_6[_e800];
                                        if _e801 {
                                        } else {
                                            phi_4116_ = true;
                                            break;
                                        }
                                        let _e805 = local_5[_e800];
                                        if _e801 {
                                        } else {
                                            phi_4116_ = true;
                                            break;
                                        }
                                        let _e807 = local_4[_e800];
                                        if _e801 {
                                        } else {
                                            phi_4116_ = true;
                                            break;
                                        }
                                        let _e809 = local_3[_e800];
                                        if _e801 {
                                        } else {
                                            phi_4116_ = true;
                                            break;
                                        }
                                        let _e812 = local_2[_e800];
                                        if _e801 {
                                        } else {
                                            phi_4116_ = true;
                                            break;
                                        }
                                        let _e814 = local_1[_e800];
                                        if _e801 {
                                        } else {
                                            phi_4116_ = true;
                                            break;
                                        }
                                        let _e816 = local[_e800];
                                        if _e801 {
                                        } else {
                                            phi_4116_ = true;
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
                                        let _e833 = ((_e829.member_1 & 2147483648u) != 0u);
                                        if _e833 {
                                            phi_1421_ = _e786;
                                            phi_1424_ = type_8(0u, ((_e829.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e840 = phi_1421_;
                                                let _e842 = phi_1424_;
                                                local_11 = _e840;
                                                if (_e842.member < _e842.member_1) {
                                                    phi_1425_ = type_8((_e842.member + 1u), _e842.member_1);
                                                    phi_1447_ = type_8(1u, _e842.member);
                                                } else {
                                                    phi_1425_ = _e842;
                                                    phi_1447_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e855 = phi_1425_;
                                                let _e857 = phi_1447_;
                                                let _e861 = (bitcast<i32>(_e857.member) != 0i);
                                                if _e861 {
                                                    let _e862 = ((_e829.member_1 & 268435455u) + _e857.member_1);
                                                    let _e863 = (_e862 < _e97);
                                                    if _e863 {
                                                        if _e863 {
                                                        } else {
                                                            phi_3924_ = true;
                                                            break;
                                                        }
                                                        let _e867 = global_5.member[_e862].member_1;
                                                        phi_1468_ = _e867;
                                                    } else {
                                                        phi_1468_ = 4294967295u;
                                                    }
                                                    let _e869 = phi_1468_;
                                                    if (_e862 >= _e97) {
                                                        phi_1560_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e863 {
                                                        } else {
                                                            phi_3924_ = true;
                                                            break;
                                                        }
                                                        if (_e757 < 9u) {
                                                        } else {
                                                            phi_3924_ = true;
                                                            break;
                                                        }
                                                        let _e876 = global_5.member[_e862].member[_e757];
                                                        if (_e761 < 9u) {
                                                        } else {
                                                            phi_3924_ = true;
                                                            break;
                                                        }
                                                        let _e882 = global_5.member[_e862].member[_e761];
                                                        if (_e765 < 9u) {
                                                        } else {
                                                            phi_3924_ = true;
                                                            break;
                                                        }
                                                        let _e888 = global_5.member[_e862].member[_e765];
                                                        let _e890 = (3u + _e757);
                                                        if (_e890 < 9u) {
                                                        } else {
                                                            phi_3924_ = true;
                                                            break;
                                                        }
                                                        let _e896 = global_5.member[_e862].member[_e890];
                                                        let _e897 = (3u + _e761);
                                                        if (_e897 < 9u) {
                                                        } else {
                                                            phi_3924_ = true;
                                                            break;
                                                        }
                                                        let _e903 = global_5.member[_e862].member[_e897];
                                                        let _e904 = (3u + _e765);
                                                        if (_e904 < 9u) {
                                                        } else {
                                                            phi_3924_ = true;
                                                            break;
                                                        }
                                                        let _e910 = global_5.member[_e862].member[_e904];
                                                        let _e912 = (6u + _e757);
                                                        if (_e912 < 9u) {
                                                        } else {
                                                            phi_3924_ = true;
                                                            break;
                                                        }
                                                        let _e918 = global_5.member[_e862].member[_e912];
                                                        let _e919 = (6u + _e761);
                                                        if (_e919 < 9u) {
                                                        } else {
                                                            phi_3924_ = true;
                                                            break;
                                                        }
                                                        let _e925 = global_5.member[_e862].member[_e919];
                                                        let _e926 = (6u + _e765);
                                                        if (_e926 < 9u) {
                                                        } else {
                                                            phi_3924_ = true;
                                                            break;
                                                        }
                                                        let _e932 = global_5.member[_e862].member[_e926];
                                                        phi_1560_ = array<array<f32, 3>, 3>(array<f32, 3>(_e876, _e882, _e888), array<f32, 3>(_e896, _e903, _e910), array<f32, 3>(_e918, _e925, _e932));
                                                    }
                                                    let _e936 = phi_1560_;
                                                    let _e944 = (_e936[0][2] - _e599);
                                                    let _e947 = (((_e936[0][0] - _e466) * _e638) - (_e944 * _e506));
                                                    let _e950 = (((_e936[0][1] - _e533) * _e638) - (_e944 * _e572));
                                                    let _e957 = (_e936[1][2] - _e599);
                                                    let _e960 = (((_e936[1][0] - _e466) * _e638) - (_e957 * _e506));
                                                    let _e963 = (((_e936[1][1] - _e533) * _e638) - (_e957 * _e572));
                                                    let _e970 = (_e936[2][2] - _e599);
                                                    let _e973 = (((_e936[2][0] - _e466) * _e638) - (_e970 * _e506));
                                                    let _e976 = (((_e936[2][1] - _e533) * _e638) - (_e970 * _e572));
                                                    let _e977 = (_e973 * _e963);
                                                    let _e978 = (_e976 * _e960);
                                                    let _e979 = (_e947 * _e976);
                                                    let _e980 = (_e950 * _e973);
                                                    let _e981 = (_e960 * _e950);
                                                    let _e982 = (_e963 * _e947);
                                                    let _e987 = (((_e977 >= _e978) && (_e979 >= _e980)) && (_e981 >= _e982));
                                                    if (_e987 || (((_e977 <= _e978) && (_e979 <= _e980)) && (_e981 <= _e982))) {
                                                        let _e994 = select(-1f, 1f, _e987);
                                                        let _e996 = ((_e977 - _e978) * _e994);
                                                        let _e998 = select(0f, _e996, (_e996 > 0f));
                                                        let _e1000 = ((_e979 - _e980) * _e994);
                                                        let _e1002 = select(0f, _e1000, (_e1000 > 0f));
                                                        let _e1004 = ((_e981 - _e982) * _e994);
                                                        let _e1006 = select(0f, _e1004, (_e1004 > 0f));
                                                        let _e1008 = ((_e998 + _e1002) + _e1006);
                                                        if (_e1008 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2444_ = type_27();
                                                            phi_2445_ = true;
                                                            phi_2446_ = false;
                                                        } else {
                                                            let _e1011 = select(_e960, _e947, (_e947 < _e960));
                                                            if (select(_e973, _e1011, (_e1011 < _e973)) > 0f) {
                                                                phi_1712_ = true;
                                                            } else {
                                                                let _e1016 = select(_e960, _e947, (_e947 > _e960));
                                                                phi_1712_ = (select(_e973, _e1016, (_e1016 > _e973)) < 0f);
                                                            }
                                                            let _e1021 = phi_1712_;
                                                            if _e1021 {
                                                                phi_2441_ = type_27();
                                                                phi_2442_ = true;
                                                                phi_2443_ = false;
                                                            } else {
                                                                let _e1023 = select(_e963, _e950, (_e950 < _e963));
                                                                if (select(_e976, _e1023, (_e1023 < _e976)) > 0f) {
                                                                    phi_1741_ = true;
                                                                } else {
                                                                    let _e1028 = select(_e963, _e950, (_e950 > _e963));
                                                                    phi_1741_ = (select(_e976, _e1028, (_e1028 > _e976)) < 0f);
                                                                }
                                                                let _e1033 = phi_1741_;
                                                                if _e1033 {
                                                                    phi_2439_ = type_27();
                                                                    phi_2440_ = false;
                                                                } else {
                                                                    let _e1035 = select(_e936[1][0], _e936[0][0], (_e936[0][0] < _e936[1][0]));
                                                                    let _e1039 = select(_e936[1][0], _e936[0][0], (_e936[0][0] > _e936[1][0]));
                                                                    let _e1043 = select(_e936[1][1], _e936[0][1], (_e936[0][1] < _e936[1][1]));
                                                                    let _e1047 = select(_e936[1][1], _e936[0][1], (_e936[0][1] > _e936[1][1]));
                                                                    let _e1051 = select(_e936[1][2], _e936[0][2], (_e936[0][2] < _e936[1][2]));
                                                                    let _e1055 = select(_e936[1][2], _e936[0][2], (_e936[0][2] > _e936[1][2]));
                                                                    let _e1060 = ((select(_e936[2][0], _e1035, (_e1035 < _e936[2][0])) - _e504) * _e509);
                                                                    let _e1061 = ((select(_e936[2][0], _e1039, (_e1039 > _e936[2][0])) - _e505) * _e509);
                                                                    let _e1064 = ((select(_e936[2][1], _e1043, (_e1043 < _e936[2][1])) - _e570) * _e575);
                                                                    let _e1065 = ((select(_e936[2][1], _e1047, (_e1047 > _e936[2][1])) - _e571) * _e575);
                                                                    let _e1068 = ((select(_e936[2][2], _e1051, (_e1051 < _e936[2][2])) - _e636) * _e641);
                                                                    let _e1069 = ((select(_e936[2][2], _e1055, (_e1055 > _e936[2][2])) - _e637) * _e641);
                                                                    let _e1071 = select(_e1069, _e1068, (_e1068 < _e1069));
                                                                    let _e1073 = select(_e1069, _e1068, (_e1068 > _e1069));
                                                                    let _e1075 = select(_e1061, _e1060, (_e1060 < _e1061));
                                                                    let _e1077 = select(_e1065, _e1064, (_e1064 < _e1065));
                                                                    let _e1079 = select(_e1077, _e1075, (_e1075 > _e1077));
                                                                    let _e1081 = select(_e1071, _e1079, (_e1079 > _e1071));
                                                                    let _e1083 = select(_e1061, _e1060, (_e1060 > _e1061));
                                                                    let _e1085 = select(_e1065, _e1064, (_e1064 > _e1065));
                                                                    let _e1087 = select(_e1085, _e1083, (_e1083 < _e1085));
                                                                    let _e1089 = select(_e1073, _e1087, (_e1087 < _e1073));
                                                                    let _e1090 = -(_e1071);
                                                                    let _e1096 = select(_e752, _e1081, (_e1081 > _e752));
                                                                    if (_e1096 > (_e1089 + (select(_e1090, _e1073, (_e1073 > _e1090)) * 0.0000019073523f))) {
                                                                        phi_2434_ = type_27();
                                                                        phi_2435_ = true;
                                                                    } else {
                                                                        let _e1098 = (_e1096 > _e840.member);
                                                                        if _e1098 {
                                                                            phi_2433_ = type_27();
                                                                        } else {
                                                                            let _e1099 = vec3<f32>(_e936[0][0], _e936[0][1], _e936[0][2]);
                                                                            let _e1100 = vec3<f32>(_e936[1][0], _e936[1][1], _e936[1][2]);
                                                                            let _e1101 = vec3<f32>(_e936[2][0], _e936[2][1], _e936[2][2]);
                                                                            let _e1102 = (_e936[1][0] - _e936[0][0]);
                                                                            let _e1103 = (_e936[1][1] - _e936[0][1]);
                                                                            let _e1104 = (_e936[1][2] - _e936[0][2]);
                                                                            let _e1105 = vec3<f32>(_e1102, _e1103, _e1104);
                                                                            let _e1106 = (_e936[2][0] - _e936[1][0]);
                                                                            let _e1107 = (_e936[2][1] - _e936[1][1]);
                                                                            let _e1108 = (_e936[2][2] - _e936[1][2]);
                                                                            let _e1109 = vec3<f32>(_e1106, _e1107, _e1108);
                                                                            let _e1110 = (_e936[0][0] - _e936[2][0]);
                                                                            let _e1111 = (_e936[0][1] - _e936[2][1]);
                                                                            let _e1112 = (_e936[0][2] - _e936[2][2]);
                                                                            let _e1113 = vec3<f32>(_e1110, _e1111, _e1112);
                                                                            let _e1116 = bitcast<f32>((bitcast<u32>(_e1102) & 2147483647u));
                                                                            let _e1119 = bitcast<f32>((bitcast<u32>(_e1103) & 2147483647u));
                                                                            let _e1121 = select(_e1119, _e1116, (_e1116 > _e1119));
                                                                            let _e1124 = bitcast<f32>((bitcast<u32>(_e1104) & 2147483647u));
                                                                            let _e1126 = select(_e1124, _e1121, (_e1121 > _e1124));
                                                                            let _e1129 = bitcast<f32>((bitcast<u32>(_e1106) & 2147483647u));
                                                                            let _e1132 = bitcast<f32>((bitcast<u32>(_e1107) & 2147483647u));
                                                                            let _e1134 = select(_e1132, _e1129, (_e1129 > _e1132));
                                                                            let _e1137 = bitcast<f32>((bitcast<u32>(_e1108) & 2147483647u));
                                                                            let _e1139 = select(_e1137, _e1134, (_e1134 > _e1137));
                                                                            let _e1142 = bitcast<f32>((bitcast<u32>(_e1110) & 2147483647u));
                                                                            let _e1145 = bitcast<f32>((bitcast<u32>(_e1111) & 2147483647u));
                                                                            let _e1147 = select(_e1145, _e1142, (_e1142 > _e1145));
                                                                            let _e1150 = bitcast<f32>((bitcast<u32>(_e1112) & 2147483647u));
                                                                            let _e1152 = select(_e1150, _e1147, (_e1147 > _e1150));
                                                                            let _e1154 = select(_e1139, _e1126, (_e1126 > _e1139));
                                                                            let _e1156 = select(_e1152, _e1154, (_e1154 > _e1152));
                                                                            if (_e1126 == _e1156) {
                                                                                phi_2160_ = _e963;
                                                                                phi_2161_ = _e960;
                                                                                phi_2162_ = _e950;
                                                                                phi_2163_ = _e947;
                                                                                phi_2164_ = _e1099;
                                                                                phi_2165_ = _e1113;
                                                                                phi_2166_ = _e1109;
                                                                                phi_2167_ = _e1105;
                                                                            } else {
                                                                                let _e1158 = (_e1139 == _e1156);
                                                                                let _e1163 = vec3(_e1158);
                                                                                phi_2160_ = select(_e950, _e976, _e1158);
                                                                                phi_2161_ = select(_e947, _e973, _e1158);
                                                                                phi_2162_ = select(_e976, _e963, _e1158);
                                                                                phi_2163_ = select(_e973, _e960, _e1158);
                                                                                phi_2164_ = select(_e1101, _e1100, _e1163);
                                                                                phi_2165_ = select(_e1109, _e1105, _e1163);
                                                                                phi_2166_ = select(_e1105, _e1113, _e1163);
                                                                                phi_2167_ = select(_e1113, _e1109, _e1163);
                                                                            }
                                                                            let _e1169 = phi_2160_;
                                                                            let _e1171 = phi_2161_;
                                                                            let _e1173 = phi_2162_;
                                                                            let _e1175 = phi_2163_;
                                                                            let _e1177 = phi_2164_;
                                                                            let _e1179 = phi_2165_;
                                                                            let _e1181 = phi_2166_;
                                                                            let _e1183 = phi_2167_;
                                                                            let _e1190 = ((_e1181.y * _e1179.z) - (_e1179.y * _e1181.z));
                                                                            let _e1195 = ((_e1181.z * _e1179.x) - (_e1179.z * _e1181.x));
                                                                            let _e1198 = ((_e1181.x * _e1179.y) - (_e1179.x * _e1181.y));
                                                                            if (_e998 >= _e1002) {
                                                                                phi_2204_ = select(true, false, (_e998 >= _e1006));
                                                                            } else {
                                                                                phi_2204_ = true;
                                                                            }
                                                                            let _e1203 = phi_2204_;
                                                                            if _e1203 {
                                                                                phi_2213_ = select(_e1101, _e1100, vec3((_e1002 >= _e1006)));
                                                                            } else {
                                                                                phi_2213_ = _e1099;
                                                                            }
                                                                            let _e1208 = phi_2213_;
                                                                            let _e1219 = (((_e1190 * (_e1208.x - _e466)) + (_e1195 * (_e1208.y - _e533))) + (_e1198 * (_e1208.z - _e599)));
                                                                            let _e1224 = (((_e1190 * _e506) + (_e1195 * _e572)) + (_e1198 * _e638));
                                                                            let _e1225 = (_e1171 - _e1175);
                                                                            let _e1226 = (_e1169 - _e1173);
                                                                            let _e1234 = (-(((_e1175 * _e1225) + (_e1173 * _e1226))) / ((_e1225 * _e1225) + (_e1226 * _e1226)));
                                                                            let _e1236 = select(1f, _e1234, (_e1234 < 1f));
                                                                            let _e1238 = select(0f, _e1236, (_e1236 > 0f));
                                                                            let _e1251 = ((_e1177.x + (_e1183.x * _e1238)) - _e466);
                                                                            let _e1252 = ((_e1177.y + (_e1183.y * _e1238)) - _e533);
                                                                            let _e1253 = ((_e1177.z + (_e1183.z * _e1238)) - _e599);
                                                                            let _e1254 = (_e1253 / _e638);
                                                                            let _e1266 = bitcast<f32>((bitcast<u32>(_e1251) & 2147483647u));
                                                                            let _e1269 = bitcast<f32>((bitcast<u32>(_e1252) & 2147483647u));
                                                                            let _e1271 = select(_e1269, _e1266, (_e1266 > _e1269));
                                                                            let _e1274 = bitcast<f32>((bitcast<u32>(_e1253) & 2147483647u));
                                                                            let _e1276 = select(_e1274, _e1271, (_e1271 > _e1274));
                                                                            let _e1282 = bitcast<f32>((bitcast<u32>(_e1190) & 2147483647u));
                                                                            let _e1285 = bitcast<f32>((bitcast<u32>(_e1195) & 2147483647u));
                                                                            let _e1287 = select(_e1285, _e1282, (_e1282 > _e1285));
                                                                            let _e1290 = bitcast<f32>((bitcast<u32>(_e1198) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1190 * _e1251) + (_e1195 * _e1252)) + (_e1198 * _e1253)) - _e1219)) & 2147483647u)) <= ((0.0000009536743f * select(_e1156, _e1276, (_e1276 > _e1156))) * select(_e1290, _e1287, (_e1287 > _e1290)))) {
                                                                                let _e1300 = bitcast<f32>((bitcast<u32>(_e1181.x) & 2147483647u));
                                                                                let _e1303 = bitcast<f32>((bitcast<u32>(_e1181.y) & 2147483647u));
                                                                                let _e1305 = select(_e1303, _e1300, (_e1300 > _e1303));
                                                                                let _e1308 = bitcast<f32>((bitcast<u32>(_e1181.z) & 2147483647u));
                                                                                let _e1314 = bitcast<f32>((bitcast<u32>(_e1179.x) & 2147483647u));
                                                                                let _e1317 = bitcast<f32>((bitcast<u32>(_e1179.y) & 2147483647u));
                                                                                let _e1319 = select(_e1317, _e1314, (_e1314 > _e1317));
                                                                                let _e1322 = bitcast<f32>((bitcast<u32>(_e1179.z) & 2147483647u));
                                                                                let _e1326 = (bitcast<f32>((bitcast<u32>(_e1224) & 2147483647u)) > ((0.0000038146973f * select(_e1308, _e1305, (_e1305 > _e1308))) * select(_e1322, _e1319, (_e1319 > _e1322))));
                                                                                if _e1326 {
                                                                                    phi_2378_ = (_e1219 / _e1224);
                                                                                } else {
                                                                                    phi_2378_ = f32();
                                                                                }
                                                                                let _e1329 = phi_2378_;
                                                                                phi_2380_ = _e1329;
                                                                                phi_2381_ = select(true, false, _e1326);
                                                                            } else {
                                                                                phi_2380_ = f32();
                                                                                phi_2381_ = true;
                                                                            }
                                                                            let _e1332 = phi_2380_;
                                                                            let _e1334 = phi_2381_;
                                                                            if _e1334 {
                                                                                let _e1342 = (((_e1190 * (_e1251 - (_e506 * _e1254))) + (_e1195 * (_e1252 - (_e572 * _e1254)))) / _e1224);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1342) & 2147483647u)) <= _e1156) {
                                                                                    phi_2401_ = (_e1254 + _e1342);
                                                                                } else {
                                                                                    phi_2401_ = _e1254;
                                                                                }
                                                                                let _e1349 = phi_2401_;
                                                                                phi_2402_ = _e1349;
                                                                            } else {
                                                                                phi_2402_ = _e1332;
                                                                            }
                                                                            let _e1351 = phi_2402_;
                                                                            let _e1353 = select(_e1089, _e1351, (_e1351 < _e1089));
                                                                            let _e1355 = select(_e1081, _e1353, (_e1353 > _e1081));
                                                                            if (_e1355 >= _e752) {
                                                                                let _e1357 = (_e1355 <= _e840.member);
                                                                                if _e1357 {
                                                                                    let _e1358 = (1f / _e1008);
                                                                                    phi_2425_ = type_27(_e1355, (_e1002 * _e1358), (_e1006 * _e1358), _e869);
                                                                                } else {
                                                                                    phi_2425_ = type_27();
                                                                                }
                                                                                let _e1363 = phi_2425_;
                                                                                phi_2427_ = _e1363;
                                                                                phi_2428_ = select(true, false, _e1357);
                                                                            } else {
                                                                                phi_2427_ = type_27();
                                                                                phi_2428_ = true;
                                                                            }
                                                                            let _e1366 = phi_2427_;
                                                                            let _e1368 = phi_2428_;
                                                                            if _e1368 {
                                                                                phi_2432_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2432_ = _e1366;
                                                                            }
                                                                            let _e1370 = phi_2432_;
                                                                            phi_2433_ = _e1370;
                                                                        }
                                                                        let _e1372 = phi_2433_;
                                                                        phi_2434_ = _e1372;
                                                                        phi_2435_ = _e1098;
                                                                    }
                                                                    let _e1374 = phi_2434_;
                                                                    let _e1376 = phi_2435_;
                                                                    phi_2439_ = _e1374;
                                                                    phi_2440_ = _e1376;
                                                                }
                                                                let _e1378 = phi_2439_;
                                                                let _e1380 = phi_2440_;
                                                                phi_2441_ = _e1378;
                                                                phi_2442_ = _e1033;
                                                                phi_2443_ = _e1380;
                                                            }
                                                            let _e1382 = phi_2441_;
                                                            let _e1384 = phi_2442_;
                                                            let _e1386 = phi_2443_;
                                                            phi_2444_ = _e1382;
                                                            phi_2445_ = _e1384;
                                                            phi_2446_ = _e1386;
                                                        }
                                                        let _e1388 = phi_2444_;
                                                        let _e1390 = phi_2445_;
                                                        let _e1392 = phi_2446_;
                                                        phi_2454_ = _e1388;
                                                        phi_2455_ = select(_e1392, true, _e1390);
                                                    } else {
                                                        phi_2454_ = type_27();
                                                        phi_2455_ = true;
                                                    }
                                                    let _e1395 = phi_2454_;
                                                    let _e1397 = phi_2455_;
                                                    if _e1397 {
                                                        phi_2459_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2459_ = _e1395;
                                                    }
                                                    let _e1399 = phi_2459_;
                                                    if (_e1399.member_3 != 4294967295u) {
                                                        if (_e869 == _e154) {
                                                            phi_2794_ = false;
                                                        } else {
                                                            let _e1403 = (_e869 < arrayLength((&global_6.member)));
                                                            if _e1403 {
                                                                if _e1403 {
                                                                } else {
                                                                    phi_3924_ = true;
                                                                    break;
                                                                }
                                                                let _e1405 = global_6.member[_e869];
                                                                phi_2482_ = _e1405;
                                                            } else {
                                                                phi_2482_ = 4294967295u;
                                                            }
                                                            let _e1407 = phi_2482_;
                                                            let _e1408 = (_e1407 < arrayLength((&global_7.member)));
                                                            if _e1408 {
                                                                if _e1408 {
                                                                } else {
                                                                    phi_3924_ = true;
                                                                    break;
                                                                }
                                                                let _e1410 = global_7.member[_e1407];
                                                                phi_2496_ = _e1410;
                                                            } else {
                                                                phi_2496_ = 0i;
                                                            }
                                                            let _e1412 = phi_2496_;
                                                            let _e1413 = (_e1412 == 0i);
                                                            if _e1413 {
                                                                phi_2793_ = true;
                                                            } else {
                                                                if _e443 {
                                                                    phi_2519_ = vec3<f32>(_e936[0][0], _e936[0][1], _e936[0][2]);
                                                                } else {
                                                                    if (_e419 == 1u) {
                                                                        phi_2518_ = vec3<f32>(_e936[0][2], _e936[0][0], _e936[0][1]);
                                                                    } else {
                                                                        phi_2518_ = vec3<f32>(_e936[0][1], _e936[0][2], _e936[0][0]);
                                                                    }
                                                                    let _e1418 = phi_2518_;
                                                                    phi_2519_ = _e1418;
                                                                }
                                                                let _e1421 = phi_2519_;
                                                                if _e443 {
                                                                    phi_2538_ = vec3<f32>(_e936[1][0], _e936[1][1], _e936[1][2]);
                                                                } else {
                                                                    if (_e419 == 1u) {
                                                                        phi_2537_ = vec3<f32>(_e936[1][2], _e936[1][0], _e936[1][1]);
                                                                    } else {
                                                                        phi_2537_ = vec3<f32>(_e936[1][1], _e936[1][2], _e936[1][0]);
                                                                    }
                                                                    let _e1426 = phi_2537_;
                                                                    phi_2538_ = _e1426;
                                                                }
                                                                let _e1429 = phi_2538_;
                                                                if _e443 {
                                                                    phi_2557_ = vec3<f32>(_e936[2][0], _e936[2][1], _e936[2][2]);
                                                                } else {
                                                                    if (_e419 == 1u) {
                                                                        phi_2556_ = vec3<f32>(_e936[2][2], _e936[2][0], _e936[2][1]);
                                                                    } else {
                                                                        phi_2556_ = vec3<f32>(_e936[2][1], _e936[2][2], _e936[2][0]);
                                                                    }
                                                                    let _e1434 = phi_2556_;
                                                                    phi_2557_ = _e1434;
                                                                }
                                                                let _e1437 = phi_2557_;
                                                                let _e1440 = (_e1429.x - _e1421.x);
                                                                let _e1443 = (_e1429.y - _e1421.y);
                                                                let _e1446 = (_e1429.z - _e1421.z);
                                                                let _e1448 = (_e1437.x - _e1421.x);
                                                                let _e1450 = (_e1437.y - _e1421.y);
                                                                let _e1452 = (_e1437.z - _e1421.z);
                                                                if (_e286.member_1 == 1u) {
                                                                    phi_2593_ = (vec3<f32>(_e286.member[0], _e286.member[1], _e286.member[2]) - _e1421);
                                                                } else {
                                                                    phi_2593_ = vec3<f32>(_e286.member[0], _e286.member[1], _e286.member[2]);
                                                                }
                                                                let _e1467 = phi_2593_;
                                                                let _e1473 = bitcast<f32>((bitcast<u32>((_e1440 * _e1450)) ^ _e286.member_3[0]));
                                                                let _e1477 = bitcast<f32>((bitcast<u32>((_e1443 * _e1448)) ^ _e286.member_3[0]));
                                                                let _e1481 = bitcast<f32>((bitcast<u32>((_e1443 * _e1452)) ^ _e286.member_3[0]));
                                                                let _e1485 = bitcast<f32>((bitcast<u32>((_e1446 * _e1450)) ^ _e286.member_3[0]));
                                                                let _e1489 = bitcast<f32>((bitcast<u32>((_e1446 * _e1448)) ^ _e286.member_3[0]));
                                                                let _e1493 = bitcast<f32>((bitcast<u32>((_e1440 * _e1452)) ^ _e286.member_3[0]));
                                                                let _e1494 = (_e1481 - _e1485);
                                                                let _e1495 = (_e1489 - _e1493);
                                                                let _e1496 = (_e1473 - _e1477);
                                                                let _e1520 = (bitcast<f32>((bitcast<u32>(_e1481) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1485) & 2147483647u)));
                                                                let _e1527 = (bitcast<f32>((bitcast<u32>(_e1489) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1493) & 2147483647u)));
                                                                let _e1534 = (bitcast<f32>((bitcast<u32>(_e1473) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1477) & 2147483647u)));
                                                                if (_e286.member_2 == 0f) {
                                                                    phi_2775_ = 0f;
                                                                } else {
                                                                    let _e1564 = bitcast<f32>((bitcast<u32>(_e1494) & 2147483647u));
                                                                    let _e1567 = bitcast<f32>((bitcast<u32>(_e1495) & 2147483647u));
                                                                    let _e1570 = bitcast<f32>((bitcast<u32>(_e1496) & 2147483647u));
                                                                    let _e1572 = select(_e1570, _e1567, (_e1567 > _e1570));
                                                                    let _e1576 = select(_e1570, _e1567, (_e1567 < _e1570));
                                                                    let _e1580 = select(_e1567, _e1564, (_e1564 < _e1567));
                                                                    let _e1582 = select(_e1567, _e1564, (_e1564 > _e1567));
                                                                    let _e1584 = select(_e1570, _e1582, (_e1582 < _e1570));
                                                                    phi_2775_ = bitcast<f32>((bitcast<u32>((_e286.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1572, _e1564, (_e1564 > _e1572)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1584, _e1580, (_e1580 > _e1584)))) ^ _e286.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1576, _e1564, (_e1564 < _e1576)))) ^ _e286.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1520 + _e1527) + _e1534))) ^ _e286.member_3[0]))) * 1.0000005f)) ^ _e286.member_3[0])))) ^ _e286.member_3[0]));
                                                                }
                                                                let _e1611 = phi_2775_;
                                                                phi_2793_ = (_e1413 || !(((((bitcast<f32>((bitcast<u32>((_e1467.x * _e1494)) ^ _e286.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1467.y * _e1495)) ^ _e286.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1467.z * _e1496)) ^ _e286.member_3[0]))) * f32(-(_e1412))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1467.x) & 2147483647u)) * _e1520)) ^ _e286.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1467.y) & 2147483647u)) * _e1527)) ^ _e286.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1467.z) & 2147483647u)) * _e1534)) ^ _e286.member_3[0]))))) ^ _e286.member_3[0])) + _e1611) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1625 = phi_2793_;
                                                            phi_2794_ = _e1625;
                                                        }
                                                        let _e1627 = phi_2794_;
                                                        if _e1627 {
                                                            phi_2799_ = type_46(_e840.member, true);
                                                        } else {
                                                            phi_2799_ = _e840;
                                                        }
                                                        let _e1632 = phi_2799_;
                                                        phi_2800_ = _e1632;
                                                    } else {
                                                        phi_2800_ = _e840;
                                                    }
                                                    let _e1634 = phi_2800_;
                                                    phi_1422_ = _e1634;
                                                } else {
                                                    phi_1422_ = type_46();
                                                }
                                                let _e1636 = phi_1422_;
                                                continue;
                                                continuing {
                                                    phi_1421_ = _e1636;
                                                    phi_1424_ = _e855;
                                                    phi_3924_ = _e784;
                                                    break if !(_e861);
                                                }
                                            }
                                            let _e1639 = phi_3924_;
                                            phi_4116_ = _e1639;
                                            if _e1639 {
                                                break;
                                            }
                                            phi_4175_ = _e1639;
                                            let _e2201 = local_11;
                                            phi_2801_ = _e2201;
                                        } else {
                                            phi_4175_ = _e784;
                                            phi_2801_ = _e786;
                                        }
                                        let _e1641 = phi_4175_;
                                        let _e1643 = phi_2801_;
                                        if _e833 {
                                            phi_3808_ = bool();
                                            phi_3809_ = u32();
                                            phi_3810_ = type_62();
                                        } else {
                                            let _e1644 = (_e829.member_1 < _e95);
                                            if _e1644 {
                                                if _e1644 {
                                                } else {
                                                    phi_4116_ = true;
                                                    break;
                                                }
                                                let _e1646 = global_10.member[_e829.member_1];
                                                phi_2822_ = _e1646;
                                            } else {
                                                phi_2822_ = type_55(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e1648 = phi_2822_;
                                            let _e1663 = ((10u * _e419) & 31u);
                                            let _e1666 = ((_e1648.member[0] >> bitcast<u32>(_e1663)) & 1023u);
                                            let _e1674 = bitcast<f32>((bitcast<u32>(((_e829.member.member_1[0] - _e829.member.member[0]) * 0.0009775171f)) ^ _e137));
                                            let _e1679 = (_e829.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1666)) - 8388608f) * _e1674)) ^ _e137)));
                                            let _e1683 = select(select(_e829.member.member_1[0], _e1679, (_e1679 < _e829.member.member_1[0])), _e829.member.member_1[0], (_e1666 == 1023u));
                                            let _e1685 = ((10u * _e418) & 31u);
                                            let _e1688 = ((_e1648.member[0] >> bitcast<u32>(_e1685)) & 1023u);
                                            let _e1696 = bitcast<f32>((bitcast<u32>(((_e829.member.member_1[1] - _e829.member.member[1]) * 0.0009775171f)) ^ _e137));
                                            let _e1701 = (_e829.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1688)) - 8388608f) * _e1696)) ^ _e137)));
                                            let _e1705 = select(select(_e829.member.member_1[1], _e1701, (_e1701 < _e829.member.member_1[1])), _e829.member.member_1[1], (_e1688 == 1023u));
                                            let _e1707 = ((10u * _e420) & 31u);
                                            let _e1710 = ((_e1648.member[0] >> bitcast<u32>(_e1707)) & 1023u);
                                            let _e1718 = bitcast<f32>((bitcast<u32>(((_e829.member.member_1[2] - _e829.member.member[2]) * 0.0009775171f)) ^ _e137));
                                            let _e1723 = (_e829.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1710)) - 8388608f) * _e1718)) ^ _e137)));
                                            let _e1727 = select(select(_e829.member.member_1[2], _e1723, (_e1723 < _e829.member.member_1[2])), _e829.member.member_1[2], (_e1710 == 1023u));
                                            let _e1730 = ((_e1648.member[1] >> bitcast<u32>(_e1663)) & 1023u);
                                            let _e1738 = (_e829.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1730)) - 8388608f) * _e1674)) ^ _e137)));
                                            let _e1742 = select(select(_e829.member.member_1[0], _e1738, (_e1738 < _e829.member.member_1[0])), _e829.member.member_1[0], (_e1730 == 1023u));
                                            let _e1745 = ((_e1648.member[1] >> bitcast<u32>(_e1685)) & 1023u);
                                            let _e1753 = (_e829.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1745)) - 8388608f) * _e1696)) ^ _e137)));
                                            let _e1757 = select(select(_e829.member.member_1[1], _e1753, (_e1753 < _e829.member.member_1[1])), _e829.member.member_1[1], (_e1745 == 1023u));
                                            let _e1760 = ((_e1648.member[1] >> bitcast<u32>(_e1707)) & 1023u);
                                            let _e1768 = (_e829.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1760)) - 8388608f) * _e1718)) ^ _e137)));
                                            let _e1772 = select(select(_e829.member.member_1[2], _e1768, (_e1768 < _e829.member.member_1[2])), _e829.member.member_1[2], (_e1760 == 1023u));
                                            let _e1778 = ((_e1648.member_1[0] >> bitcast<u32>(_e1663)) & 1023u);
                                            let _e1786 = (_e829.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1778)) - 8388608f) * _e1674)) ^ _e137)));
                                            let _e1790 = select(select(_e829.member.member_1[0], _e1786, (_e1786 < _e829.member.member_1[0])), _e829.member.member_1[0], (_e1778 == 1023u));
                                            let _e1793 = ((_e1648.member_1[0] >> bitcast<u32>(_e1685)) & 1023u);
                                            let _e1801 = (_e829.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1793)) - 8388608f) * _e1696)) ^ _e137)));
                                            let _e1805 = select(select(_e829.member.member_1[1], _e1801, (_e1801 < _e829.member.member_1[1])), _e829.member.member_1[1], (_e1793 == 1023u));
                                            let _e1808 = ((_e1648.member_1[0] >> bitcast<u32>(_e1707)) & 1023u);
                                            let _e1816 = (_e829.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1808)) - 8388608f) * _e1718)) ^ _e137)));
                                            let _e1820 = select(select(_e829.member.member_1[2], _e1816, (_e1816 < _e829.member.member_1[2])), _e829.member.member_1[2], (_e1808 == 1023u));
                                            let _e1823 = ((_e1648.member_1[1] >> bitcast<u32>(_e1663)) & 1023u);
                                            let _e1831 = (_e829.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1823)) - 8388608f) * _e1674)) ^ _e137)));
                                            let _e1835 = select(select(_e829.member.member_1[0], _e1831, (_e1831 < _e829.member.member_1[0])), _e829.member.member_1[0], (_e1823 == 1023u));
                                            let _e1838 = ((_e1648.member_1[1] >> bitcast<u32>(_e1685)) & 1023u);
                                            let _e1846 = (_e829.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1838)) - 8388608f) * _e1696)) ^ _e137)));
                                            let _e1850 = select(select(_e829.member.member_1[1], _e1846, (_e1846 < _e829.member.member_1[1])), _e829.member.member_1[1], (_e1838 == 1023u));
                                            let _e1853 = ((_e1648.member_1[1] >> bitcast<u32>(_e1707)) & 1023u);
                                            let _e1861 = (_e829.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1853)) - 8388608f) * _e1718)) ^ _e137)));
                                            let _e1865 = select(select(_e829.member.member_1[2], _e1861, (_e1861 < _e829.member.member_1[2])), _e829.member.member_1[2], (_e1853 == 1023u));
                                            let _e1870 = type_62(type_60(array<f32, 3>(_e1683, _e1705, _e1727), array<f32, 3>(_e1742, _e1757, _e1772)), _e1648.member_2);
                                            let _e1875 = type_62(type_60(array<f32, 3>(_e1790, _e1805, _e1820), array<f32, 3>(_e1835, _e1850, _e1865)), _e1648.member_3);
                                            let _e1881 = ((_e1683 - _e504) * _e509);
                                            let _e1882 = ((_e1790 - _e504) * _e509);
                                            let _e1883 = ((_e1742 - _e505) * _e509);
                                            let _e1884 = ((_e1835 - _e505) * _e509);
                                            let _e1889 = ((_e1705 - _e570) * _e575);
                                            let _e1890 = ((_e1805 - _e570) * _e575);
                                            let _e1891 = ((_e1757 - _e571) * _e575);
                                            let _e1892 = ((_e1850 - _e571) * _e575);
                                            let _e1897 = ((_e1727 - _e636) * _e641);
                                            let _e1898 = ((_e1820 - _e636) * _e641);
                                            let _e1899 = ((_e1772 - _e637) * _e641);
                                            let _e1900 = ((_e1865 - _e637) * _e641);
                                            let _e1902 = select(_e1899, _e1897, (_e1897 < _e1899));
                                            let _e1904 = select(_e1900, _e1898, (_e1898 < _e1900));
                                            let _e1906 = select(_e1899, _e1897, (_e1897 > _e1899));
                                            let _e1908 = select(_e1900, _e1898, (_e1898 > _e1900));
                                            let _e1910 = select(_e1883, _e1881, (_e1881 < _e1883));
                                            let _e1912 = select(_e1884, _e1882, (_e1882 < _e1884));
                                            let _e1914 = select(_e1891, _e1889, (_e1889 < _e1891));
                                            let _e1916 = select(_e1892, _e1890, (_e1890 < _e1892));
                                            let _e1918 = select(_e1914, _e1910, (_e1910 > _e1914));
                                            let _e1920 = select(_e1916, _e1912, (_e1912 > _e1916));
                                            let _e1922 = select(_e1902, _e1918, (_e1918 > _e1902));
                                            let _e1924 = select(_e1904, _e1920, (_e1920 > _e1904));
                                            let _e1926 = select(_e1883, _e1881, (_e1881 > _e1883));
                                            let _e1928 = select(_e1884, _e1882, (_e1882 > _e1884));
                                            let _e1930 = select(_e1891, _e1889, (_e1889 > _e1891));
                                            let _e1932 = select(_e1892, _e1890, (_e1890 > _e1892));
                                            let _e1934 = select(_e1930, _e1926, (_e1926 < _e1930));
                                            let _e1936 = select(_e1932, _e1928, (_e1928 < _e1932));
                                            let _e1941 = -(_e1902);
                                            let _e1942 = -(_e1904);
                                            let _e1949 = (select(_e1906, _e1934, (_e1934 < _e1906)) + (select(_e1941, _e1906, (_e1906 > _e1941)) * 0.0000019073523f));
                                            let _e1950 = (select(_e1908, _e1936, (_e1936 < _e1908)) + (select(_e1942, _e1908, (_e1908 > _e1942)) * 0.0000019073523f));
                                            let _e1952 = select(_e752, _e1922, (_e1922 > _e752));
                                            let _e1954 = select(_e752, _e1924, (_e1924 > _e752));
                                            let _e1959 = (_e1952 <= select(_e1643.member, _e1949, (_e1949 < _e1643.member)));
                                            let _e1960 = (_e1954 <= select(_e1643.member, _e1950, (_e1950 < _e1643.member)));
                                            let _e1961 = (_e1952 <= _e1954);
                                            if _e1959 {
                                                if _e1960 {
                                                    if _e1961 {
                                                        phi_3708_ = _e1875;
                                                    } else {
                                                        phi_3708_ = _e1870;
                                                    }
                                                    let _e1963 = phi_3708_;
                                                    let _e1970 = (_e827 % 128u);
                                                    let _e1971 = (_e1970 < 128u);
                                                    if _e1971 {
                                                    } else {
                                                        phi_4116_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1970] = _e1963.member_1;
                                                    if _e1971 {
                                                    } else {
                                                        phi_4116_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1970] = _e1963.member.member[0];
                                                    if _e1971 {
                                                    } else {
                                                        phi_4116_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1970] = _e1963.member.member[1];
                                                    if _e1971 {
                                                    } else {
                                                        phi_4116_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1970] = _e1963.member.member[2];
                                                    if _e1971 {
                                                    } else {
                                                        phi_4116_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1970] = _e1963.member.member_1[0];
                                                    if _e1971 {
                                                    } else {
                                                        phi_4116_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1970] = _e1963.member.member_1[1];
                                                    if _e1971 {
                                                    } else {
                                                        phi_4116_ = true;
                                                        break;
                                                    }
                                                    local[_e1970] = _e1963.member.member_1[2];
                                                    if _e1971 {
                                                    } else {
                                                        phi_4116_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1970] = select(_e1952, _e1954, _e1961);
                                                    if _e1961 {
                                                        phi_3784_ = _e1870;
                                                    } else {
                                                        phi_3784_ = _e1875;
                                                    }
                                                    let _e1988 = phi_3784_;
                                                    phi_3785_ = (_e827 + 1u);
                                                    phi_3786_ = _e1988;
                                                } else {
                                                    phi_3785_ = u32();
                                                    phi_3786_ = type_62();
                                                }
                                                let _e1990 = phi_3785_;
                                                let _e1992 = phi_3786_;
                                                phi_3788_ = _e1990;
                                                phi_3789_ = _e1992;
                                                phi_3790_ = select(true, false, _e1960);
                                            } else {
                                                phi_3788_ = u32();
                                                phi_3789_ = type_62();
                                                phi_3790_ = true;
                                            }
                                            let _e1995 = phi_3788_;
                                            let _e1997 = phi_3789_;
                                            let _e1999 = phi_3790_;
                                            if _e1999 {
                                                if _e1959 {
                                                    phi_3797_ = _e1870;
                                                } else {
                                                    phi_3797_ = _e1875;
                                                }
                                                let _e2001 = phi_3797_;
                                                phi_3802_ = select(_e1960, true, _e1959);
                                                phi_3804_ = _e2001;
                                            } else {
                                                phi_3802_ = _e825;
                                                phi_3804_ = _e1997;
                                            }
                                            let _e2004 = phi_3802_;
                                            let _e2006 = phi_3804_;
                                            phi_3808_ = _e2004;
                                            phi_3809_ = select(_e1995, _e827, _e1999);
                                            phi_3810_ = _e2006;
                                        }
                                        let _e2009 = phi_3808_;
                                        let _e2011 = phi_3809_;
                                        let _e2013 = phi_3810_;
                                        if _e833 {
                                            phi_3820_ = select(_e827, 0u, _e1643.member_1);
                                            phi_3821_ = _e829;
                                        } else {
                                            phi_3820_ = _e2011;
                                            phi_3821_ = _e2013;
                                        }
                                        let _e2017 = phi_3820_;
                                        let _e2019 = phi_3821_;
                                        phi_4119_ = _e1641;
                                        phi_3822_ = _e1643;
                                        phi_3823_ = (_e788 - 1u);
                                        phi_3824_ = select(_e2009, false, _e833);
                                        phi_3825_ = _e2017;
                                        phi_3826_ = _e2019;
                                    } else {
                                        phi_4119_ = _e784;
                                        phi_3822_ = _e786;
                                        phi_3823_ = _e788;
                                        phi_3824_ = _e825;
                                        phi_3825_ = _e827;
                                        phi_3826_ = _e829;
                                    }
                                    let _e2022 = phi_4119_;
                                    let _e2024 = phi_3822_;
                                    let _e2026 = phi_3823_;
                                    let _e2028 = phi_3824_;
                                    let _e2030 = phi_3825_;
                                    let _e2032 = phi_3826_;
                                    phi_4118_ = _e2022;
                                    phi_3827_ = _e2024;
                                    phi_3828_ = _e2026;
                                    phi_3829_ = _e2028;
                                    phi_3830_ = _e2030;
                                    phi_3831_ = _e2032;
                                } else {
                                    phi_4118_ = _e784;
                                    phi_3827_ = type_46();
                                    phi_3828_ = u32();
                                    phi_3829_ = bool();
                                    phi_3830_ = u32();
                                    phi_3831_ = type_62();
                                }
                                let _e2034 = phi_4118_;
                                let _e2036 = phi_3827_;
                                let _e2038 = phi_3828_;
                                let _e2040 = phi_3829_;
                                let _e2042 = phi_3830_;
                                let _e2044 = phi_3831_;
                                phi_4117_ = _e2034;
                                phi_1296_ = _e2036;
                                phi_1299_ = _e2038;
                                phi_1301_ = _e2040;
                                phi_1303_ = _e2042;
                                phi_1305_ = _e2044;
                                phi_3832_ = _e798;
                            } else {
                                phi_4117_ = _e784;
                                phi_1296_ = type_46();
                                phi_1299_ = u32();
                                phi_1301_ = bool();
                                phi_1303_ = u32();
                                phi_1305_ = type_62();
                                phi_3832_ = false;
                            }
                            let _e2046 = phi_4117_;
                            let _e2048 = phi_1296_;
                            let _e2050 = phi_1299_;
                            let _e2052 = phi_1301_;
                            let _e2054 = phi_1303_;
                            let _e2056 = phi_1305_;
                            let _e2058 = phi_3832_;
                            continue;
                            continuing {
                                phi_3930_ = _e2046;
                                phi_1295_ = _e2048;
                                phi_1298_ = _e2050;
                                phi_1300_ = _e2052;
                                phi_1302_ = _e2054;
                                phi_1304_ = _e2056;
                                phi_4116_ = _e2046;
                                break if !(_e2058);
                            }
                        }
                        let _e2061 = phi_4116_;
                        if _e2061 {
                            break;
                        }
                        let _e2063 = local_10;
                        if _e2063.member_1 {
                        } else {
                            if _e287 {
                            } else {
                                break;
                            }
                            let _e2067 = global_2.member[_e141];
                            if _e148 {
                            } else {
                                break;
                            }
                            let _e2071 = global_9.member[_e141].member_1;
                            if _e287 {
                            } else {
                                break;
                            }
                            global_2.member[_e141] = type_29(_e2067.member, _e2067.member_1, _e2067.member_2, array<f32, 3>((_e2067.member_3[0] + (_e2071[0] * _e2067.member_1[0])), (_e2067.member_3[1] + (_e2071[1] * _e2067.member_1[1])), (_e2067.member_3[2] + (_e2071[2] * _e2067.member_1[2]))), _e2067.member_4);
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
