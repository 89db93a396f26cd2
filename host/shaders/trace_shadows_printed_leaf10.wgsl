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

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
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

struct type_30 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_36 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_40 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_41 {
    member: f32,
    member_1: bool,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<i32>,
}

struct type_50 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_52 {
    member: array<type_50>,
}

struct type_55 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_57 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_59 {
    member: array<type_57>,
}

struct type_63 {
    member: type_55,
    member_1: u32,
}

struct type_68 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_26;
@group(0) @binding(1) 
var<uniform> global_3: type_43;
@group(0) @binding(2) 
var<uniform> global_4: type_43;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_46;
@group(0) @binding(9) 
var<storage, read_write> global_7: type_68;
@group(0) @binding(7) 
var<storage> global_8: type_32;
@group(0) @binding(3) 
var<storage> global_9: type_52;
@group(0) @binding(4) 
var<storage> global_10: type_59;

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
    var phi_315_: u32;
    var phi_359_: i32;
    var phi_499_: type_36;
    var phi_649_: i32;
    var phi_650_: i32;
    var phi_660_: bool;
    var phi_670_: u32;
    var phi_671_: u32;
    var phi_673_: bool;
    var phi_678_: u32;
    var phi_711_: i32;
    var phi_729_: f32;
    var phi_735_: f32;
    var phi_775_: f32;
    var phi_781_: f32;
    var phi_854_: f32;
    var phi_860_: f32;
    var phi_900_: f32;
    var phi_906_: f32;
    var phi_979_: f32;
    var phi_985_: f32;
    var phi_1025_: f32;
    var phi_1031_: f32;
    var phi_1150_: i32;
    var phi_1172_: u32;
    var phi_1173_: u32;
    var phi_1210_: i32;
    var phi_1232_: u32;
    var phi_1233_: u32;
    var phi_1241_: f32;
    var phi_1242_: f32;
    var phi_4140_: bool;
    var phi_1325_: type_41;
    var phi_1328_: bool;
    var phi_1330_: type_63;
    var phi_1332_: u32;
    var phi_1334_: u32;
    var phi_1345_: bool;
    var phi_1431_: bool;
    var phi_1432_: type_63;
    var phi_1433_: u32;
    var phi_2901_: type_50;
    var phi_3787_: type_63;
    var phi_3863_: type_63;
    var phi_3864_: type_63;
    var phi_3865_: u32;
    var phi_3867_: type_63;
    var phi_3868_: u32;
    var phi_3869_: bool;
    var phi_3876_: type_63;
    var phi_3881_: bool;
    var phi_3882_: type_63;
    var phi_1452_: type_41;
    var phi_1455_: type_8;
    var phi_1456_: type_8;
    var phi_1478_: type_8;
    var phi_1503_: u32;
    var phi_1519_: type_57;
    var phi_2314_: f32;
    var phi_2315_: f32;
    var phi_2316_: f32;
    var phi_2317_: f32;
    var phi_2318_: vec3<f32>;
    var phi_2319_: vec3<f32>;
    var phi_2320_: vec3<f32>;
    var phi_2321_: vec3<f32>;
    var phi_2512_: f32;
    var phi_2532_: type_40;
    var phi_2533_: type_40;
    var phi_2536_: type_40;
    var phi_2537_: type_40;
    var phi_2538_: bool;
    var phi_2542_: type_40;
    var phi_2551_: type_22;
    var phi_2574_: u32;
    var phi_2588_: i32;
    var phi_2606_: vec3<f32>;
    var phi_2607_: vec3<f32>;
    var phi_2621_: vec3<f32>;
    var phi_2622_: vec3<f32>;
    var phi_2636_: vec3<f32>;
    var phi_2637_: vec3<f32>;
    var phi_2673_: vec3<f32>;
    var phi_2855_: f32;
    var phi_2873_: bool;
    var phi_2874_: bool;
    var phi_2879_: type_41;
    var phi_2880_: type_41;
    var phi_1453_: type_41;
    var phi_4134_: bool;
    var local_10: type_41;
    var phi_4341_: bool;
    var phi_3884_: type_41;
    var phi_3885_: bool;
    var phi_3886_: type_63;
    var phi_3887_: u32;
    var phi_4340_: bool;
    var phi_3888_: type_41;
    var phi_3889_: bool;
    var phi_3890_: type_63;
    var phi_3891_: u32;
    var phi_3892_: u32;
    var phi_4339_: bool;
    var phi_3893_: type_41;
    var phi_3894_: bool;
    var phi_3895_: type_63;
    var phi_3896_: u32;
    var phi_3897_: u32;
    var phi_4338_: bool;
    var phi_1326_: type_41;
    var phi_1329_: bool;
    var phi_1331_: type_63;
    var phi_1333_: u32;
    var phi_1335_: u32;
    var phi_3898_: bool;
    var phi_4337_: bool;
    var local_11: type_41;
    var local_12: type_41;

    switch bitcast<i32>(0u) {
        default: {
            let _e91 = global;
            let _e94 = arrayLength((&global_9.member));
            let _e109 = arrayLength((&global_7.member));
            let _e113 = global_4.member[0u][0u];
            let _e117 = global_4.member[0u][1u];
            let _e121 = global_4.member[0u][2u];
            let _e125 = global_4.member[1u][0u];
            let _e129 = global_4.member[1u][1u];
            let _e133 = global_4.member[1u][2u];
            let _e137 = global_4.member[1u][3u];
            let _e141 = (_e91.x + (_e91.y * 2097152u));
            let _e148 = (_e141 < arrayLength((&global_8.member)));
            if _e148 {
                if _e148 {
                } else {
                    break;
                }
                let _e152 = global_8.member[_e141].member_2;
                phi_315_ = _e152;
            } else {
                phi_315_ = 4294967295u;
            }
            let _e154 = phi_315_;
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
                phi_359_ = -126i;
            } else {
                phi_359_ = select(_e197, 127i, (_e197 > 127i));
            }
            let _e202 = phi_359_;
            let _e207 = bitcast<f32>((bitcast<u32>((_e202 + 127i)) << bitcast<u32>(23i)));
            let _e213 = bitcast<f32>((bitcast<u32>(((_e197 - _e202) + 127i)) << bitcast<u32>(23i)));
            if (_e173 == 0u) {
                phi_499_ = type_36(array<f32, 3>(_e190, _e191, _e192), _e173, _e194, _e195);
            } else {
                let _e215 = bitcast<u32>(_e190);
                let _e217 = ((_e215 & 2139095040u) != 0u);
                let _e232 = bitcast<u32>(_e191);
                let _e234 = ((_e232 & 2139095040u) != 0u);
                let _e249 = bitcast<u32>(_e192);
                let _e251 = ((_e249 & 2139095040u) != 0u);
                let _e267 = bitcast<u32>(_e194);
                let _e269 = ((_e267 & 2139095040u) != 0u);
                phi_499_ = type_36(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e215 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e215 & 2147483648u))), _e190, _e217) * _e207) * select(0.00000011920929f, 1f, _e217)) * _e213), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e232 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e232 & 2147483648u))), _e191, _e234) * _e207) * select(0.00000011920929f, 1f, _e234)) * _e213), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e249 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e249 & 2147483648u))), _e192, _e251) * _e207) * select(0.00000011920929f, 1f, _e251)) * _e213)), _e173, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e267 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e267 & 2147483648u))), _e194, _e269) * _e207) * select(0.00000011920929f, 1f, _e269)) * _e213), _e195);
            }
            let _e286 = phi_499_;
            if _e148 {
                let _e287 = (_e141 < arrayLength((&global_2.member)));
                if _e287 {
                    if _e148 {
                    } else {
                        break;
                    }
                    let _e292 = global_8.member[_e141].member.member_1;
                    let _e297 = global_8.member[_e141].member.member_3;
                    if (_e292 <= _e297) {
                        let _e299 = (1u < _e109);
                        if _e299 {
                            if (0u < _e109) {
                            } else {
                                break;
                            }
                            let _e303 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e303 + 1u) < _e303) {
                                if _e299 {
                                } else {
                                    break;
                                }
                                let _e308 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e148 {
                        } else {
                            break;
                        }
                        let _e318 = global_8.member[_e141].member.member_2[0u];
                        let _e320 = (bitcast<u32>(_e318) & 2147483647u);
                        let _e326 = global_8.member[_e141].member.member_2[1u];
                        let _e328 = (bitcast<u32>(_e326) & 2147483647u);
                        let _e334 = global_8.member[_e141].member.member_2[2u];
                        let _e336 = (bitcast<u32>(_e334) & 2147483647u);
                        let _e342 = global_8.member[_e141].member.member[0u];
                        let _e344 = (bitcast<u32>(_e342) & 2147483647u);
                        let _e350 = global_8.member[_e141].member.member[1u];
                        let _e352 = (bitcast<u32>(_e350) & 2147483647u);
                        let _e358 = global_8.member[_e141].member.member[2u];
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
                                phi_649_ = (bitcast<i32>((_e384 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_649_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e384)), 32u, (_e384 == 0u))));
                            }
                            let _e398 = phi_649_;
                            phi_650_ = _e398;
                        } else {
                            phi_650_ = 0i;
                        }
                        let _e400 = phi_650_;
                        let _e401 = (_e320 == _e364);
                        if _e401 {
                            phi_660_ = true;
                        } else {
                            phi_660_ = (_e328 == _e364);
                        }
                        let _e404 = phi_660_;
                        let _e405 = select(1u, 0u, _e401);
                        if _e404 {
                            let _e406 = (_e405 + 1u);
                            phi_670_ = _e406;
                            phi_671_ = _e406;
                            phi_673_ = select(true, false, (_e406 == 2u));
                        } else {
                            phi_670_ = u32();
                            phi_671_ = 0u;
                            phi_673_ = true;
                        }
                        let _e410 = phi_670_;
                        let _e412 = phi_671_;
                        let _e414 = phi_673_;
                        if _e414 {
                            phi_678_ = (_e412 + 1u);
                        } else {
                            phi_678_ = 0u;
                        }
                        let _e418 = phi_678_;
                        let _e419 = select(_e410, _e412, _e414);
                        let _e420 = select(_e405, select(2u, _e405, _e404), _e414);
                        let _e421 = -(_e400);
                        if (_e421 < -126i) {
                            phi_711_ = -126i;
                        } else {
                            phi_711_ = select(_e421, 127i, (_e421 > 127i));
                        }
                        let _e426 = phi_711_;
                        let _e431 = bitcast<f32>((bitcast<u32>((_e426 + 127i)) << bitcast<u32>(23i)));
                        let _e437 = bitcast<f32>((bitcast<u32>(((_e421 - _e426) + 127i)) << bitcast<u32>(23i)));
                        let _e442 = global_8.member[_e141].member.member;
                        let _e443 = (_e419 == 0u);
                        if _e443 {
                            phi_729_ = _e442[0];
                        } else {
                            phi_729_ = _e442[1];
                        }
                        let _e447 = phi_729_;
                        let _e448 = (_e419 == 2u);
                        if _e448 {
                            phi_735_ = _e442[2];
                        } else {
                            phi_735_ = _e447;
                        }
                        let _e451 = phi_735_;
                        let _e452 = bitcast<u32>(_e451);
                        let _e454 = ((_e452 & 2139095040u) != 0u);
                        let _e466 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e452 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e452 & 2147483648u))), _e451, _e454) * select(0.00000011920929f, 1f, _e454));
                        let _e467 = global_8.member[_e141].member.member_2;
                        if _e443 {
                            phi_775_ = _e467[0];
                        } else {
                            phi_775_ = _e467[1];
                        }
                        let _e471 = phi_775_;
                        if _e448 {
                            phi_781_ = _e467[2];
                        } else {
                            phi_781_ = _e471;
                        }
                        let _e474 = phi_781_;
                        let _e475 = bitcast<u32>(_e474);
                        let _e477 = ((_e475 & 2139095040u) != 0u);
                        let _e491 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e475 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e475 & 2147483648u))), _e474, _e477) * _e431) * select(0.00000011920929f, 1f, _e477)) * _e437);
                        let _e495 = (bitcast<f32>((bitcast<u32>(_e491) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e498 = bitcast<f32>((bitcast<u32>(_e466) & 2147483647u));
                        let _e499 = (_e498 * 0.00000011920929f);
                        let _e502 = select(select(0.00000000000011368684f, _e499, (_e499 > 0.00000000000011368684f)), 0f, _e495);
                        let _e503 = select(0f, _e491, _e495);
                        let _e504 = (_e466 + _e502);
                        let _e505 = (_e466 - _e502);
                        let _e507 = select(38685626000000000000000000f, (1f / _e491), _e495);
                        let _e508 = (_e418 == 0u);
                        if _e508 {
                            phi_854_ = _e442[0];
                        } else {
                            phi_854_ = _e442[1];
                        }
                        let _e512 = phi_854_;
                        let _e513 = (_e418 == 2u);
                        if _e513 {
                            phi_860_ = _e442[2];
                        } else {
                            phi_860_ = _e512;
                        }
                        let _e516 = phi_860_;
                        let _e517 = bitcast<u32>(_e516);
                        let _e519 = ((_e517 & 2139095040u) != 0u);
                        let _e531 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e517 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e517 & 2147483648u))), _e516, _e519) * select(0.00000011920929f, 1f, _e519));
                        if _e508 {
                            phi_900_ = _e467[0];
                        } else {
                            phi_900_ = _e467[1];
                        }
                        let _e535 = phi_900_;
                        if _e513 {
                            phi_906_ = _e467[2];
                        } else {
                            phi_906_ = _e535;
                        }
                        let _e538 = phi_906_;
                        let _e539 = bitcast<u32>(_e538);
                        let _e541 = ((_e539 & 2139095040u) != 0u);
                        let _e555 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e539 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e539 & 2147483648u))), _e538, _e541) * _e431) * select(0.00000011920929f, 1f, _e541)) * _e437);
                        let _e559 = (bitcast<f32>((bitcast<u32>(_e555) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e562 = bitcast<f32>((bitcast<u32>(_e531) & 2147483647u));
                        let _e563 = (_e562 * 0.00000011920929f);
                        let _e566 = select(select(0.00000000000011368684f, _e563, (_e563 > 0.00000000000011368684f)), 0f, _e559);
                        let _e567 = select(0f, _e555, _e559);
                        let _e568 = (_e531 + _e566);
                        let _e569 = (_e531 - _e566);
                        let _e571 = select(38685626000000000000000000f, (1f / _e555), _e559);
                        let _e572 = (_e420 == 0u);
                        if _e572 {
                            phi_979_ = _e442[0];
                        } else {
                            phi_979_ = _e442[1];
                        }
                        let _e576 = phi_979_;
                        let _e577 = (_e420 == 2u);
                        if _e577 {
                            phi_985_ = _e442[2];
                        } else {
                            phi_985_ = _e576;
                        }
                        let _e580 = phi_985_;
                        let _e581 = bitcast<u32>(_e580);
                        let _e583 = ((_e581 & 2139095040u) != 0u);
                        let _e595 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e581 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e581 & 2147483648u))), _e580, _e583) * select(0.00000011920929f, 1f, _e583));
                        if _e572 {
                            phi_1025_ = _e467[0];
                        } else {
                            phi_1025_ = _e467[1];
                        }
                        let _e599 = phi_1025_;
                        if _e577 {
                            phi_1031_ = _e467[2];
                        } else {
                            phi_1031_ = _e599;
                        }
                        let _e602 = phi_1031_;
                        let _e603 = bitcast<u32>(_e602);
                        let _e605 = ((_e603 & 2139095040u) != 0u);
                        let _e619 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e603 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e603 & 2147483648u))), _e602, _e605) * _e431) * select(0.00000011920929f, 1f, _e605)) * _e437);
                        let _e623 = (bitcast<f32>((bitcast<u32>(_e619) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e626 = bitcast<f32>((bitcast<u32>(_e595) & 2147483647u));
                        let _e627 = (_e626 * 0.00000011920929f);
                        let _e630 = select(select(0.00000000000011368684f, _e627, (_e627 > 0.00000000000011368684f)), 0f, _e623);
                        let _e631 = select(0f, _e619, _e623);
                        let _e632 = (_e595 + _e630);
                        let _e633 = (_e595 - _e630);
                        let _e635 = select(38685626000000000000000000f, (1f / _e619), _e623);
                        let _e637 = select(_e562, _e498, (_e498 > _e562));
                        if (_e381 && (select(_e626, _e637, (_e637 > _e626)) <= 1099511600000f)) {
                            let _e649 = ((_e372 & 8388607u) | (select(0u, 1u, ((_e372 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e652 = bitcast<i32>((_e372 >> bitcast<u32>(23i)));
                            let _e656 = (_e649 == 0u);
                            let _e659 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e649)), 32u, _e656)) - 8i);
                            if (_e652 == 255i) {
                                phi_1150_ = 255i;
                            } else {
                                phi_1150_ = (((_e652 + select(0i, 1i, (_e652 == 0i))) - _e659) + _e400);
                            }
                            let _e667 = phi_1150_;
                            let _e677 = (_e667 <= 0i);
                            if _e677 {
                                phi_1173_ = u32();
                            } else {
                                if _e656 {
                                    phi_1172_ = u32();
                                } else {
                                    phi_1172_ = select(((bitcast<u32>(_e667) << bitcast<u32>(23i)) | ((_e649 << bitcast<u32>(((_e659 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e667 >= 255i));
                                }
                                let _e681 = phi_1172_;
                                phi_1173_ = _e681;
                            }
                            let _e683 = phi_1173_;
                            let _e695 = ((_e377 & 8388607u) | (select(0u, 1u, ((_e377 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e698 = bitcast<i32>((_e377 >> bitcast<u32>(23i)));
                            let _e702 = (_e695 == 0u);
                            let _e705 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e695)), 32u, _e702)) - 8i);
                            if (_e698 == 255i) {
                                phi_1210_ = 255i;
                            } else {
                                phi_1210_ = (((_e698 + select(0i, 1i, (_e698 == 0i))) - _e705) + _e400);
                            }
                            let _e713 = phi_1210_;
                            let _e723 = (_e713 <= 0i);
                            if _e723 {
                                phi_1233_ = u32();
                            } else {
                                if _e702 {
                                    phi_1232_ = u32();
                                } else {
                                    phi_1232_ = select(((bitcast<u32>(_e713) << bitcast<u32>(23i)) | ((_e695 << bitcast<u32>(((_e705 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e713 >= 255i));
                                }
                                let _e727 = phi_1232_;
                                phi_1233_ = _e727;
                            }
                            let _e729 = phi_1233_;
                            phi_1241_ = bitcast<f32>(((_e376 & 2147483648u) | select(_e729, 0u, select(_e702, true, _e723))));
                            phi_1242_ = bitcast<f32>(((_e371 & 2147483648u) | select(_e683, 0u, select(_e656, true, _e677))));
                        } else {
                            phi_1241_ = 0f;
                            phi_1242_ = 1f;
                        }
                        let _e735 = phi_1241_;
                        let _e737 = phi_1242_;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e113), bitcast<f32>(_e117), bitcast<f32>(_e121));
                        let _e744 = (_e419 % 3u);
                        let _e745 = (_e744 < 3u);
                        if _e745 {
                        } else {
                            break;
                        }
                        let _e747 = local_9[_e744];
                        let _e748 = (_e418 % 3u);
                        let _e749 = (_e748 < 3u);
                        if _e749 {
                        } else {
                            break;
                        }
                        let _e751 = local_9[_e748];
                        let _e752 = (_e420 % 3u);
                        let _e753 = (_e752 < 3u);
                        if _e753 {
                        } else {
                            break;
                        }
                        let _e755 = local_9[_e752];
                        local_8 = array<f32, 3>(bitcast<f32>(_e125), bitcast<f32>(_e129), bitcast<f32>(_e133));
                        if _e745 {
                        } else {
                            break;
                        }
                        let _e759 = local_8[_e744];
                        if _e749 {
                        } else {
                            break;
                        }
                        let _e761 = local_8[_e748];
                        if _e753 {
                        } else {
                            break;
                        }
                        let _e763 = local_8[_e752];
                        phi_4140_ = false;
                        phi_1325_ = type_41(_e735, false);
                        phi_1328_ = (_e737 <= _e735);
                        phi_1330_ = type_63(type_55(array<f32, 3>(_e747, _e751, _e755), array<f32, 3>(_e759, _e761, _e763)), select(0u, 2147483648u, (_e94 == 0u)));
                        phi_1332_ = 0u;
                        phi_1334_ = ((3u * _e94) + 1u);
                        loop {
                            let _e769 = phi_4140_;
                            let _e771 = phi_1325_;
                            let _e773 = phi_1328_;
                            let _e775 = phi_1330_;
                            let _e777 = phi_1332_;
                            let _e779 = phi_1334_;
                            local_11 = _e771;
                            if _e773 {
                                phi_1345_ = true;
                            } else {
                                phi_1345_ = (_e777 > 0u);
                            }
                            let _e782 = phi_1345_;
                            if _e782 {
                                let _e783 = (_e779 > 0u);
                                if _e783 {
                                    if _e773 {
                                        phi_1431_ = _e773;
                                        phi_1432_ = _e775;
                                        phi_1433_ = _e777;
                                    } else {
                                        let _e784 = (_e777 - 1u);
                                        let _e785 = (_e784 % 128u);
                                        let _e786 = (_e785 < 128u);
                                        if _e786 {
                                        } else {
                                            phi_4337_ = true;
                                            break;
                                        }
                                        let _e788 = local_6[_e785];
                                        if _e786 {
                                        } else {
                                            phi_4337_ = true;
                                            break;
                                        }
                                        let _e790 = local_5[_e785];
                                        if _e786 {
                                        } else {
                                            phi_4337_ = true;
                                            break;
                                        }
                                        let _e792 = local_4[_e785];
                                        if _e786 {
                                        } else {
                                            phi_4337_ = true;
                                            break;
                                        }
                                        let _e794 = local_3[_e785];
                                        if _e786 {
                                        } else {
                                            phi_4337_ = true;
                                            break;
                                        }
                                        let _e797 = local_2[_e785];
                                        if _e786 {
                                        } else {
                                            phi_4337_ = true;
                                            break;
                                        }
                                        let _e799 = local_1[_e785];
                                        if _e786 {
                                        } else {
                                            phi_4337_ = true;
                                            break;
                                        }
                                        let _e801 = local[_e785];
                                        if _e786 {
                                        } else {
                                            phi_4337_ = true;
                                            break;
                                        }
                                        let _e806 = local_7[_e785];
                                        phi_1431_ = (_e806 <= _e771.member);
                                        phi_1432_ = type_63(type_55(array<f32, 3>(_e790, _e792, _e794), array<f32, 3>(_e797, _e799, _e801)), _e788);
                                        phi_1433_ = _e784;
                                    }
                                    let _e810 = phi_1431_;
                                    let _e812 = phi_1432_;
                                    let _e814 = phi_1433_;
                                    if _e810 {
                                        if ((_e812.member_1 & 2147483648u) != 0u) {
                                            phi_1452_ = _e771;
                                            phi_1455_ = type_8(0u, ((_e812.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1190 = phi_1452_;
                                                let _e1192 = phi_1455_;
                                                local_10 = _e1190;
                                                local_12 = _e1190;
                                                if (_e1192.member < _e1192.member_1) {
                                                    phi_1456_ = type_8((_e1192.member + 1u), _e1192.member_1);
                                                    phi_1478_ = type_8(1u, _e1192.member);
                                                } else {
                                                    phi_1456_ = _e1192;
                                                    phi_1478_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1205 = phi_1456_;
                                                let _e1207 = phi_1478_;
                                                let _e1211 = (bitcast<i32>(_e1207.member) != 0i);
                                                if _e1211 {
                                                    let _e1212 = ((_e812.member_1 & 268435455u) + _e1207.member_1);
                                                    let _e1213 = (_e1212 < arrayLength((&global_10.member)));
                                                    if _e1213 {
                                                        if _e1213 {
                                                        } else {
                                                            phi_4134_ = true;
                                                            break;
                                                        }
                                                        let _e1216 = global_10.member[_e1212].member_1;
                                                        phi_1503_ = _e1216;
                                                    } else {
                                                        phi_1503_ = 4294967295u;
                                                    }
                                                    let _e1218 = phi_1503_;
                                                    if _e1213 {
                                                        if _e1213 {
                                                        } else {
                                                            phi_4134_ = true;
                                                            break;
                                                        }
                                                        let _e1220 = global_10.member[_e1212];
                                                        phi_1519_ = _e1220;
                                                    } else {
                                                        phi_1519_ = type_57(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e1222 = phi_1519_;
                                                    let _e1234 = ((10u * _e419) & 31u);
                                                    let _e1237 = ((_e1222.member[0] >> bitcast<u32>(_e1234)) & 1023u);
                                                    let _e1245 = bitcast<f32>((bitcast<u32>(((_e812.member.member_1[0] - _e812.member.member[0]) * 0.0009775171f)) ^ _e137));
                                                    let _e1250 = (_e812.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1237)) - 8388608f) * _e1245)) ^ _e137)));
                                                    let _e1254 = select(select(_e812.member.member_1[0], _e1250, (_e1250 < _e812.member.member_1[0])), _e812.member.member_1[0], (_e1237 == 1023u));
                                                    let _e1256 = ((10u * _e418) & 31u);
                                                    let _e1259 = ((_e1222.member[0] >> bitcast<u32>(_e1256)) & 1023u);
                                                    let _e1267 = bitcast<f32>((bitcast<u32>(((_e812.member.member_1[1] - _e812.member.member[1]) * 0.0009775171f)) ^ _e137));
                                                    let _e1272 = (_e812.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1259)) - 8388608f) * _e1267)) ^ _e137)));
                                                    let _e1276 = select(select(_e812.member.member_1[1], _e1272, (_e1272 < _e812.member.member_1[1])), _e812.member.member_1[1], (_e1259 == 1023u));
                                                    let _e1278 = ((10u * _e420) & 31u);
                                                    let _e1281 = ((_e1222.member[0] >> bitcast<u32>(_e1278)) & 1023u);
                                                    let _e1289 = bitcast<f32>((bitcast<u32>(((_e812.member.member_1[2] - _e812.member.member[2]) * 0.0009775171f)) ^ _e137));
                                                    let _e1294 = (_e812.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1281)) - 8388608f) * _e1289)) ^ _e137)));
                                                    let _e1298 = select(select(_e812.member.member_1[2], _e1294, (_e1294 < _e812.member.member_1[2])), _e812.member.member_1[2], (_e1281 == 1023u));
                                                    let _e1302 = ((_e1222.member[1] >> bitcast<u32>(_e1234)) & 1023u);
                                                    let _e1310 = (_e812.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1302)) - 8388608f) * _e1245)) ^ _e137)));
                                                    let _e1314 = select(select(_e812.member.member_1[0], _e1310, (_e1310 < _e812.member.member_1[0])), _e812.member.member_1[0], (_e1302 == 1023u));
                                                    let _e1317 = ((_e1222.member[1] >> bitcast<u32>(_e1256)) & 1023u);
                                                    let _e1325 = (_e812.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1317)) - 8388608f) * _e1267)) ^ _e137)));
                                                    let _e1329 = select(select(_e812.member.member_1[1], _e1325, (_e1325 < _e812.member.member_1[1])), _e812.member.member_1[1], (_e1317 == 1023u));
                                                    let _e1332 = ((_e1222.member[1] >> bitcast<u32>(_e1278)) & 1023u);
                                                    let _e1340 = (_e812.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1332)) - 8388608f) * _e1289)) ^ _e137)));
                                                    let _e1344 = select(select(_e812.member.member_1[2], _e1340, (_e1340 < _e812.member.member_1[2])), _e812.member.member_1[2], (_e1332 == 1023u));
                                                    let _e1348 = ((_e1222.member[2] >> bitcast<u32>(_e1234)) & 1023u);
                                                    let _e1356 = (_e812.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1348)) - 8388608f) * _e1245)) ^ _e137)));
                                                    let _e1360 = select(select(_e812.member.member_1[0], _e1356, (_e1356 < _e812.member.member_1[0])), _e812.member.member_1[0], (_e1348 == 1023u));
                                                    let _e1363 = ((_e1222.member[2] >> bitcast<u32>(_e1256)) & 1023u);
                                                    let _e1371 = (_e812.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1363)) - 8388608f) * _e1267)) ^ _e137)));
                                                    let _e1375 = select(select(_e812.member.member_1[1], _e1371, (_e1371 < _e812.member.member_1[1])), _e812.member.member_1[1], (_e1363 == 1023u));
                                                    let _e1378 = ((_e1222.member[2] >> bitcast<u32>(_e1278)) & 1023u);
                                                    let _e1386 = (_e812.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1378)) - 8388608f) * _e1289)) ^ _e137)));
                                                    let _e1390 = select(select(_e812.member.member_1[2], _e1386, (_e1386 < _e812.member.member_1[2])), _e812.member.member_1[2], (_e1378 == 1023u));
                                                    let _e1394 = (_e1298 - _e595);
                                                    let _e1397 = (((_e1254 - _e466) * _e631) - (_e1394 * _e503));
                                                    let _e1400 = (((_e1276 - _e531) * _e631) - (_e1394 * _e567));
                                                    let _e1403 = (_e1344 - _e595);
                                                    let _e1406 = (((_e1314 - _e466) * _e631) - (_e1403 * _e503));
                                                    let _e1409 = (((_e1329 - _e531) * _e631) - (_e1403 * _e567));
                                                    let _e1412 = (_e1390 - _e595);
                                                    let _e1415 = (((_e1360 - _e466) * _e631) - (_e1412 * _e503));
                                                    let _e1418 = (((_e1375 - _e531) * _e631) - (_e1412 * _e567));
                                                    let _e1419 = (_e1415 * _e1409);
                                                    let _e1420 = (_e1418 * _e1406);
                                                    let _e1421 = (_e1397 * _e1418);
                                                    let _e1422 = (_e1400 * _e1415);
                                                    let _e1423 = (_e1406 * _e1400);
                                                    let _e1424 = (_e1409 * _e1397);
                                                    let _e1429 = (((_e1419 >= _e1420) && (_e1421 >= _e1422)) && (_e1423 >= _e1424));
                                                    let _e1435 = (_e1429 || (((_e1419 <= _e1420) && (_e1421 <= _e1422)) && (_e1423 <= _e1424)));
                                                    if _e1435 {
                                                        let _e1437 = select(-1f, 1f, _e1429);
                                                        let _e1439 = ((_e1419 - _e1420) * _e1437);
                                                        let _e1441 = select(0f, _e1439, (_e1439 > 0f));
                                                        let _e1443 = ((_e1421 - _e1422) * _e1437);
                                                        let _e1445 = select(0f, _e1443, (_e1443 > 0f));
                                                        let _e1447 = ((_e1423 - _e1424) * _e1437);
                                                        let _e1449 = select(0f, _e1447, (_e1447 > 0f));
                                                        let _e1451 = ((_e1441 + _e1445) + _e1449);
                                                        let _e1453 = select(_e1314, _e1254, (_e1254 < _e1314));
                                                        let _e1457 = select(_e1314, _e1254, (_e1254 > _e1314));
                                                        let _e1461 = select(_e1329, _e1276, (_e1276 < _e1329));
                                                        let _e1465 = select(_e1329, _e1276, (_e1276 > _e1329));
                                                        let _e1469 = select(_e1344, _e1298, (_e1298 < _e1344));
                                                        let _e1473 = select(_e1344, _e1298, (_e1298 > _e1344));
                                                        let _e1478 = ((select(_e1360, _e1453, (_e1453 < _e1360)) - _e504) * _e507);
                                                        let _e1479 = ((select(_e1360, _e1457, (_e1457 > _e1360)) - _e505) * _e507);
                                                        let _e1482 = ((select(_e1375, _e1461, (_e1461 < _e1375)) - _e568) * _e571);
                                                        let _e1483 = ((select(_e1375, _e1465, (_e1465 > _e1375)) - _e569) * _e571);
                                                        let _e1486 = ((select(_e1390, _e1469, (_e1469 < _e1390)) - _e632) * _e635);
                                                        let _e1487 = ((select(_e1390, _e1473, (_e1473 > _e1390)) - _e633) * _e635);
                                                        let _e1489 = select(_e1487, _e1486, (_e1486 < _e1487));
                                                        let _e1491 = select(_e1487, _e1486, (_e1486 > _e1487));
                                                        let _e1493 = select(_e1479, _e1478, (_e1478 < _e1479));
                                                        let _e1495 = select(_e1483, _e1482, (_e1482 < _e1483));
                                                        let _e1497 = select(_e1495, _e1493, (_e1493 > _e1495));
                                                        let _e1499 = select(_e1489, _e1497, (_e1497 > _e1489));
                                                        let _e1501 = select(_e1479, _e1478, (_e1478 > _e1479));
                                                        let _e1503 = select(_e1483, _e1482, (_e1482 > _e1483));
                                                        let _e1505 = select(_e1503, _e1501, (_e1501 < _e1503));
                                                        let _e1507 = select(_e1491, _e1505, (_e1505 < _e1491));
                                                        let _e1508 = -(_e1489);
                                                        let _e1514 = select(_e737, _e1499, (_e1499 > _e737));
                                                        let _e1518 = select(_e1406, _e1397, (_e1397 < _e1406));
                                                        let _e1523 = select(_e1406, _e1397, (_e1397 > _e1406));
                                                        let _e1530 = select(_e1409, _e1400, (_e1400 < _e1409));
                                                        let _e1535 = select(_e1409, _e1400, (_e1400 > _e1409));
                                                        let _e1544 = (((((_e1435 && (_e1451 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1415, _e1518, (_e1518 < _e1415)) <= 0f) && (select(_e1415, _e1523, (_e1523 > _e1415)) >= 0f))) && ((select(_e1418, _e1530, (_e1530 < _e1418)) <= 0f) && (select(_e1418, _e1535, (_e1535 > _e1418)) >= 0f))) && (_e1514 <= (_e1507 + (select(_e1508, _e1491, (_e1491 > _e1508)) * 0.0000019073523f)))) && (_e1514 <= _e1190.member));
                                                        if _e1544 {
                                                            let _e1549 = (_e1314 - _e1254);
                                                            let _e1550 = (_e1329 - _e1276);
                                                            let _e1551 = (_e1344 - _e1298);
                                                            let _e1552 = vec3<f32>(_e1549, _e1550, _e1551);
                                                            let _e1553 = (_e1360 - _e1314);
                                                            let _e1554 = (_e1375 - _e1329);
                                                            let _e1555 = (_e1390 - _e1344);
                                                            let _e1556 = vec3<f32>(_e1553, _e1554, _e1555);
                                                            let _e1557 = (_e1254 - _e1360);
                                                            let _e1558 = (_e1276 - _e1375);
                                                            let _e1559 = (_e1298 - _e1390);
                                                            let _e1560 = vec3<f32>(_e1557, _e1558, _e1559);
                                                            let _e1563 = bitcast<f32>((bitcast<u32>(_e1549) & 2147483647u));
                                                            let _e1566 = bitcast<f32>((bitcast<u32>(_e1550) & 2147483647u));
                                                            let _e1568 = select(_e1566, _e1563, (_e1563 > _e1566));
                                                            let _e1571 = bitcast<f32>((bitcast<u32>(_e1551) & 2147483647u));
                                                            let _e1573 = select(_e1571, _e1568, (_e1568 > _e1571));
                                                            let _e1576 = bitcast<f32>((bitcast<u32>(_e1553) & 2147483647u));
                                                            let _e1579 = bitcast<f32>((bitcast<u32>(_e1554) & 2147483647u));
                                                            let _e1581 = select(_e1579, _e1576, (_e1576 > _e1579));
                                                            let _e1584 = bitcast<f32>((bitcast<u32>(_e1555) & 2147483647u));
                                                            let _e1586 = select(_e1584, _e1581, (_e1581 > _e1584));
                                                            let _e1589 = bitcast<f32>((bitcast<u32>(_e1557) & 2147483647u));
                                                            let _e1592 = bitcast<f32>((bitcast<u32>(_e1558) & 2147483647u));
                                                            let _e1594 = select(_e1592, _e1589, (_e1589 > _e1592));
                                                            let _e1597 = bitcast<f32>((bitcast<u32>(_e1559) & 2147483647u));
                                                            let _e1599 = select(_e1597, _e1594, (_e1594 > _e1597));
                                                            let _e1601 = select(_e1586, _e1573, (_e1573 > _e1586));
                                                            let _e1603 = select(_e1599, _e1601, (_e1601 > _e1599));
                                                            if (_e1573 == _e1603) {
                                                                phi_2314_ = _e1409;
                                                                phi_2315_ = _e1406;
                                                                phi_2316_ = _e1400;
                                                                phi_2317_ = _e1397;
                                                                phi_2318_ = vec3<f32>(_e1254, _e1276, _e1298);
                                                                phi_2319_ = _e1560;
                                                                phi_2320_ = _e1556;
                                                                phi_2321_ = _e1552;
                                                            } else {
                                                                let _e1605 = (_e1586 == _e1603);
                                                                let _e1610 = vec3(_e1605);
                                                                phi_2314_ = select(_e1400, _e1418, _e1605);
                                                                phi_2315_ = select(_e1397, _e1415, _e1605);
                                                                phi_2316_ = select(_e1418, _e1409, _e1605);
                                                                phi_2317_ = select(_e1415, _e1406, _e1605);
                                                                phi_2318_ = select(vec3<f32>(_e1360, _e1375, _e1390), vec3<f32>(_e1314, _e1329, _e1344), _e1610);
                                                                phi_2319_ = select(_e1556, _e1552, _e1610);
                                                                phi_2320_ = select(_e1552, _e1560, _e1610);
                                                                phi_2321_ = select(_e1560, _e1556, _e1610);
                                                            }
                                                            let _e1616 = phi_2314_;
                                                            let _e1618 = phi_2315_;
                                                            let _e1620 = phi_2316_;
                                                            let _e1622 = phi_2317_;
                                                            let _e1624 = phi_2318_;
                                                            let _e1626 = phi_2319_;
                                                            let _e1628 = phi_2320_;
                                                            let _e1630 = phi_2321_;
                                                            let _e1637 = ((_e1628.y * _e1626.z) - (_e1626.y * _e1628.z));
                                                            let _e1642 = ((_e1628.z * _e1626.x) - (_e1626.z * _e1628.x));
                                                            let _e1645 = ((_e1628.x * _e1626.y) - (_e1626.x * _e1628.y));
                                                            let _e1648 = ((_e1441 >= _e1445) && (_e1441 >= _e1449));
                                                            let _e1649 = (_e1445 >= _e1449);
                                                            let _e1663 = (((_e1637 * (select(select(_e1360, _e1314, _e1649), _e1254, _e1648) - _e466)) + (_e1642 * (select(select(_e1375, _e1329, _e1649), _e1276, _e1648) - _e531))) + (_e1645 * (select(select(_e1390, _e1344, _e1649), _e1298, _e1648) - _e595)));
                                                            let _e1668 = (((_e1637 * _e503) + (_e1642 * _e567)) + (_e1645 * _e631));
                                                            let _e1669 = (_e1618 - _e1622);
                                                            let _e1670 = (_e1616 - _e1620);
                                                            let _e1673 = ((_e1669 * _e1669) + (_e1670 * _e1670));
                                                            let _e1680 = (-(((_e1622 * _e1669) + (_e1620 * _e1670))) / select(0.000000000000000000000000000000000000011754944f, _e1673, (_e1673 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1682 = select(1f, _e1680, (_e1680 < 1f));
                                                            let _e1684 = select(0f, _e1682, (_e1682 > 0f));
                                                            let _e1693 = ((_e1624.x + (_e1630.x * _e1684)) - _e466);
                                                            let _e1696 = ((_e1624.y + (_e1630.y * _e1684)) - _e531);
                                                            let _e1699 = ((_e1624.z + (_e1630.z * _e1684)) - _e595);
                                                            let _e1702 = bitcast<f32>((bitcast<u32>(_e1693) & 2147483647u));
                                                            let _e1705 = bitcast<f32>((bitcast<u32>(_e1696) & 2147483647u));
                                                            let _e1707 = select(_e1705, _e1702, (_e1702 > _e1705));
                                                            let _e1710 = bitcast<f32>((bitcast<u32>(_e1699) & 2147483647u));
                                                            let _e1712 = select(_e1710, _e1707, (_e1707 > _e1710));
                                                            let _e1718 = bitcast<f32>((bitcast<u32>(_e1637) & 2147483647u));
                                                            let _e1721 = bitcast<f32>((bitcast<u32>(_e1642) & 2147483647u));
                                                            let _e1723 = select(_e1721, _e1718, (_e1718 > _e1721));
                                                            let _e1726 = bitcast<f32>((bitcast<u32>(_e1645) & 2147483647u));
                                                            let _e1745 = bitcast<f32>((bitcast<u32>(_e1628.x) & 2147483647u));
                                                            let _e1748 = bitcast<f32>((bitcast<u32>(_e1628.y) & 2147483647u));
                                                            let _e1750 = select(_e1748, _e1745, (_e1745 > _e1748));
                                                            let _e1753 = bitcast<f32>((bitcast<u32>(_e1628.z) & 2147483647u));
                                                            let _e1759 = bitcast<f32>((bitcast<u32>(_e1626.x) & 2147483647u));
                                                            let _e1762 = bitcast<f32>((bitcast<u32>(_e1626.y) & 2147483647u));
                                                            let _e1764 = select(_e1762, _e1759, (_e1759 > _e1762));
                                                            let _e1767 = bitcast<f32>((bitcast<u32>(_e1626.z) & 2147483647u));
                                                            let _e1773 = ((bitcast<f32>((bitcast<u32>(((((_e1637 * _e1693) + (_e1642 * _e1696)) + (_e1645 * _e1699)) - _e1663)) & 2147483647u)) <= ((0.0000009536743f * select(_e1603, _e1712, (_e1712 > _e1603))) * select(_e1726, _e1723, (_e1723 > _e1726)))) && !((bitcast<f32>((bitcast<u32>(_e1668) & 2147483647u)) <= ((0.0000038146973f * select(_e1753, _e1750, (_e1750 > _e1753))) * select(_e1767, _e1764, (_e1764 > _e1767))))));
                                                            let _e1774 = (_e1663 / _e1668);
                                                            if (_e1544 && !(_e1773)) {
                                                                let _e1777 = (_e1699 / _e631);
                                                                let _e1785 = (((_e1637 * (_e1693 - (_e503 * _e1777))) + (_e1642 * (_e1696 - (_e567 * _e1777)))) / _e1668);
                                                                phi_2512_ = select(select(_e1777, (_e1777 + _e1785), (bitcast<f32>((bitcast<u32>(_e1785) & 2147483647u)) <= _e1603)), _e1774, _e1773);
                                                            } else {
                                                                phi_2512_ = _e1774;
                                                            }
                                                            let _e1794 = phi_2512_;
                                                            let _e1796 = select(_e1507, _e1794, (_e1794 < _e1507));
                                                            let _e1798 = select(_e1499, _e1796, (_e1796 > _e1499));
                                                            let _e1799 = (1f / _e1451);
                                                            phi_2532_ = type_40(_e1798, (_e1445 * _e1799), (_e1449 * _e1799), ((_e1544 && (_e1798 >= _e737)) && (_e1798 <= _e1190.member)));
                                                            phi_2533_ = type_40();
                                                        } else {
                                                            phi_2532_ = type_40();
                                                            phi_2533_ = type_40(0f, 0f, 0f, _e1544);
                                                        }
                                                        let _e1808 = phi_2532_;
                                                        let _e1810 = phi_2533_;
                                                        phi_2536_ = _e1808;
                                                        phi_2537_ = _e1810;
                                                        phi_2538_ = select(true, false, _e1544);
                                                    } else {
                                                        phi_2536_ = type_40();
                                                        phi_2537_ = type_40(0f, 0f, 0f, _e1435);
                                                        phi_2538_ = true;
                                                    }
                                                    let _e1813 = phi_2536_;
                                                    let _e1815 = phi_2537_;
                                                    let _e1817 = phi_2538_;
                                                    if _e1817 {
                                                        phi_2542_ = _e1815;
                                                    } else {
                                                        phi_2542_ = _e1813;
                                                    }
                                                    let _e1819 = phi_2542_;
                                                    if _e1819.member_3 {
                                                        phi_2551_ = type_22(_e1819.member, _e1819.member_1, _e1819.member_2, _e1218);
                                                    } else {
                                                        phi_2551_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1826 = phi_2551_;
                                                    if (_e1826.member_3 != 4294967295u) {
                                                        if (_e1218 == _e154) {
                                                            phi_2874_ = false;
                                                        } else {
                                                            let _e1830 = (_e1218 < arrayLength((&global_5.member)));
                                                            if _e1830 {
                                                                if _e1830 {
                                                                } else {
                                                                    phi_4134_ = true;
                                                                    break;
                                                                }
                                                                let _e1832 = global_5.member[_e1218];
                                                                phi_2574_ = _e1832;
                                                            } else {
                                                                phi_2574_ = 4294967295u;
                                                            }
                                                            let _e1834 = phi_2574_;
                                                            let _e1835 = (_e1834 < arrayLength((&global_6.member)));
                                                            if _e1835 {
                                                                if _e1835 {
                                                                } else {
                                                                    phi_4134_ = true;
                                                                    break;
                                                                }
                                                                let _e1837 = global_6.member[_e1834];
                                                                phi_2588_ = _e1837;
                                                            } else {
                                                                phi_2588_ = 0i;
                                                            }
                                                            let _e1839 = phi_2588_;
                                                            let _e1840 = (_e1839 == 0i);
                                                            if _e1840 {
                                                                phi_2873_ = true;
                                                            } else {
                                                                if _e443 {
                                                                    phi_2607_ = vec3<f32>(_e1254, _e1276, _e1298);
                                                                } else {
                                                                    if (_e419 == 1u) {
                                                                        phi_2606_ = vec3<f32>(_e1298, _e1254, _e1276);
                                                                    } else {
                                                                        phi_2606_ = vec3<f32>(_e1276, _e1298, _e1254);
                                                                    }
                                                                    let _e1845 = phi_2606_;
                                                                    phi_2607_ = _e1845;
                                                                }
                                                                let _e1848 = phi_2607_;
                                                                if _e443 {
                                                                    phi_2622_ = vec3<f32>(_e1314, _e1329, _e1344);
                                                                } else {
                                                                    if (_e419 == 1u) {
                                                                        phi_2621_ = vec3<f32>(_e1344, _e1314, _e1329);
                                                                    } else {
                                                                        phi_2621_ = vec3<f32>(_e1329, _e1344, _e1314);
                                                                    }
                                                                    let _e1853 = phi_2621_;
                                                                    phi_2622_ = _e1853;
                                                                }
                                                                let _e1856 = phi_2622_;
                                                                if _e443 {
                                                                    phi_2637_ = vec3<f32>(_e1360, _e1375, _e1390);
                                                                } else {
                                                                    if (_e419 == 1u) {
                                                                        phi_2636_ = vec3<f32>(_e1390, _e1360, _e1375);
                                                                    } else {
                                                                        phi_2636_ = vec3<f32>(_e1375, _e1390, _e1360);
                                                                    }
                                                                    let _e1861 = phi_2636_;
                                                                    phi_2637_ = _e1861;
                                                                }
                                                                let _e1864 = phi_2637_;
                                                                let _e1867 = (_e1856.x - _e1848.x);
                                                                let _e1870 = (_e1856.y - _e1848.y);
                                                                let _e1873 = (_e1856.z - _e1848.z);
                                                                let _e1875 = (_e1864.x - _e1848.x);
                                                                let _e1877 = (_e1864.y - _e1848.y);
                                                                let _e1879 = (_e1864.z - _e1848.z);
                                                                if (_e286.member_1 == 1u) {
                                                                    phi_2673_ = (vec3<f32>(_e286.member[0], _e286.member[1], _e286.member[2]) - _e1848);
                                                                } else {
                                                                    phi_2673_ = vec3<f32>(_e286.member[0], _e286.member[1], _e286.member[2]);
                                                                }
                                                                let _e1894 = phi_2673_;
                                                                let _e1900 = bitcast<f32>((bitcast<u32>((_e1867 * _e1877)) ^ _e286.member_3[0]));
                                                                let _e1904 = bitcast<f32>((bitcast<u32>((_e1870 * _e1875)) ^ _e286.member_3[0]));
                                                                let _e1908 = bitcast<f32>((bitcast<u32>((_e1870 * _e1879)) ^ _e286.member_3[0]));
                                                                let _e1912 = bitcast<f32>((bitcast<u32>((_e1873 * _e1877)) ^ _e286.member_3[0]));
                                                                let _e1916 = bitcast<f32>((bitcast<u32>((_e1873 * _e1875)) ^ _e286.member_3[0]));
                                                                let _e1920 = bitcast<f32>((bitcast<u32>((_e1867 * _e1879)) ^ _e286.member_3[0]));
                                                                let _e1921 = (_e1908 - _e1912);
                                                                let _e1922 = (_e1916 - _e1920);
                                                                let _e1923 = (_e1900 - _e1904);
                                                                let _e1947 = (bitcast<f32>((bitcast<u32>(_e1908) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1912) & 2147483647u)));
                                                                let _e1954 = (bitcast<f32>((bitcast<u32>(_e1916) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1920) & 2147483647u)));
                                                                let _e1961 = (bitcast<f32>((bitcast<u32>(_e1900) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1904) & 2147483647u)));
                                                                if (_e286.member_2 == 0f) {
                                                                    phi_2855_ = 0f;
                                                                } else {
                                                                    let _e1991 = bitcast<f32>((bitcast<u32>(_e1921) & 2147483647u));
                                                                    let _e1994 = bitcast<f32>((bitcast<u32>(_e1922) & 2147483647u));
                                                                    let _e1997 = bitcast<f32>((bitcast<u32>(_e1923) & 2147483647u));
                                                                    let _e1999 = select(_e1997, _e1994, (_e1994 > _e1997));
                                                                    let _e2003 = select(_e1997, _e1994, (_e1994 < _e1997));
                                                                    let _e2007 = select(_e1994, _e1991, (_e1991 < _e1994));
                                                                    let _e2009 = select(_e1994, _e1991, (_e1991 > _e1994));
                                                                    let _e2011 = select(_e1997, _e2009, (_e2009 < _e1997));
                                                                    phi_2855_ = bitcast<f32>((bitcast<u32>((_e286.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1999, _e1991, (_e1991 > _e1999)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2011, _e2007, (_e2007 > _e2011)))) ^ _e286.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2003, _e1991, (_e1991 < _e2003)))) ^ _e286.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1947 + _e1954) + _e1961))) ^ _e286.member_3[0]))) * 1.0000005f)) ^ _e286.member_3[0])))) ^ _e286.member_3[0]));
                                                                }
                                                                let _e2038 = phi_2855_;
                                                                phi_2873_ = (_e1840 || !(((((bitcast<f32>((bitcast<u32>((_e1894.x * _e1921)) ^ _e286.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1894.y * _e1922)) ^ _e286.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1894.z * _e1923)) ^ _e286.member_3[0]))) * f32(-(_e1839))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1894.x) & 2147483647u)) * _e1947)) ^ _e286.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1894.y) & 2147483647u)) * _e1954)) ^ _e286.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1894.z) & 2147483647u)) * _e1961)) ^ _e286.member_3[0]))))) ^ _e286.member_3[0])) + _e2038) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2052 = phi_2873_;
                                                            phi_2874_ = _e2052;
                                                        }
                                                        let _e2054 = phi_2874_;
                                                        if _e2054 {
                                                            phi_2879_ = type_41(-340282350000000000000000000000000000000f, true);
                                                        } else {
                                                            phi_2879_ = _e1190;
                                                        }
                                                        let _e2056 = phi_2879_;
                                                        phi_2880_ = _e2056;
                                                    } else {
                                                        phi_2880_ = _e1190;
                                                    }
                                                    let _e2058 = phi_2880_;
                                                    phi_1453_ = _e2058;
                                                } else {
                                                    phi_1453_ = type_41();
                                                }
                                                let _e2060 = phi_1453_;
                                                continue;
                                                continuing {
                                                    phi_1452_ = _e2060;
                                                    phi_1455_ = _e1205;
                                                    phi_4134_ = _e769;
                                                    break if !(_e1211);
                                                }
                                            }
                                            let _e2063 = phi_4134_;
                                            phi_4337_ = _e2063;
                                            if _e2063 {
                                                break;
                                            }
                                            let _e2065 = local_10;
                                            phi_4341_ = _e2063;
                                            let _e2246 = local_12;
                                            phi_3884_ = _e2246;
                                            phi_3885_ = false;
                                            phi_3886_ = _e812;
                                            phi_3887_ = select(_e814, 0u, (_e737 > _e2065.member));
                                        } else {
                                            let _e824 = (_e812.member_1 < _e94);
                                            if _e824 {
                                                if _e824 {
                                                } else {
                                                    phi_4337_ = true;
                                                    break;
                                                }
                                                let _e826 = global_9.member[_e812.member_1];
                                                phi_2901_ = _e826;
                                            } else {
                                                phi_2901_ = type_50(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e828 = phi_2901_;
                                            let _e843 = ((10u * _e419) & 31u);
                                            let _e846 = ((_e828.member[0] >> bitcast<u32>(_e843)) & 1023u);
                                            let _e854 = bitcast<f32>((bitcast<u32>(((_e812.member.member_1[0] - _e812.member.member[0]) * 0.0009775171f)) ^ _e137));
                                            let _e859 = (_e812.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e846)) - 8388608f) * _e854)) ^ _e137)));
                                            let _e863 = select(select(_e812.member.member_1[0], _e859, (_e859 < _e812.member.member_1[0])), _e812.member.member_1[0], (_e846 == 1023u));
                                            let _e865 = ((10u * _e418) & 31u);
                                            let _e868 = ((_e828.member[0] >> bitcast<u32>(_e865)) & 1023u);
                                            let _e876 = bitcast<f32>((bitcast<u32>(((_e812.member.member_1[1] - _e812.member.member[1]) * 0.0009775171f)) ^ _e137));
                                            let _e881 = (_e812.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e868)) - 8388608f) * _e876)) ^ _e137)));
                                            let _e885 = select(select(_e812.member.member_1[1], _e881, (_e881 < _e812.member.member_1[1])), _e812.member.member_1[1], (_e868 == 1023u));
                                            let _e887 = ((10u * _e420) & 31u);
                                            let _e890 = ((_e828.member[0] >> bitcast<u32>(_e887)) & 1023u);
                                            let _e898 = bitcast<f32>((bitcast<u32>(((_e812.member.member_1[2] - _e812.member.member[2]) * 0.0009775171f)) ^ _e137));
                                            let _e903 = (_e812.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e890)) - 8388608f) * _e898)) ^ _e137)));
                                            let _e907 = select(select(_e812.member.member_1[2], _e903, (_e903 < _e812.member.member_1[2])), _e812.member.member_1[2], (_e890 == 1023u));
                                            let _e910 = ((_e828.member[1] >> bitcast<u32>(_e843)) & 1023u);
                                            let _e918 = (_e812.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e910)) - 8388608f) * _e854)) ^ _e137)));
                                            let _e922 = select(select(_e812.member.member_1[0], _e918, (_e918 < _e812.member.member_1[0])), _e812.member.member_1[0], (_e910 == 1023u));
                                            let _e925 = ((_e828.member[1] >> bitcast<u32>(_e865)) & 1023u);
                                            let _e933 = (_e812.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e925)) - 8388608f) * _e876)) ^ _e137)));
                                            let _e937 = select(select(_e812.member.member_1[1], _e933, (_e933 < _e812.member.member_1[1])), _e812.member.member_1[1], (_e925 == 1023u));
                                            let _e940 = ((_e828.member[1] >> bitcast<u32>(_e887)) & 1023u);
                                            let _e948 = (_e812.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e940)) - 8388608f) * _e898)) ^ _e137)));
                                            let _e952 = select(select(_e812.member.member_1[2], _e948, (_e948 < _e812.member.member_1[2])), _e812.member.member_1[2], (_e940 == 1023u));
                                            let _e958 = ((_e828.member_1[0] >> bitcast<u32>(_e843)) & 1023u);
                                            let _e966 = (_e812.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e958)) - 8388608f) * _e854)) ^ _e137)));
                                            let _e970 = select(select(_e812.member.member_1[0], _e966, (_e966 < _e812.member.member_1[0])), _e812.member.member_1[0], (_e958 == 1023u));
                                            let _e973 = ((_e828.member_1[0] >> bitcast<u32>(_e865)) & 1023u);
                                            let _e981 = (_e812.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e973)) - 8388608f) * _e876)) ^ _e137)));
                                            let _e985 = select(select(_e812.member.member_1[1], _e981, (_e981 < _e812.member.member_1[1])), _e812.member.member_1[1], (_e973 == 1023u));
                                            let _e988 = ((_e828.member_1[0] >> bitcast<u32>(_e887)) & 1023u);
                                            let _e996 = (_e812.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e988)) - 8388608f) * _e898)) ^ _e137)));
                                            let _e1000 = select(select(_e812.member.member_1[2], _e996, (_e996 < _e812.member.member_1[2])), _e812.member.member_1[2], (_e988 == 1023u));
                                            let _e1003 = ((_e828.member_1[1] >> bitcast<u32>(_e843)) & 1023u);
                                            let _e1011 = (_e812.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1003)) - 8388608f) * _e854)) ^ _e137)));
                                            let _e1015 = select(select(_e812.member.member_1[0], _e1011, (_e1011 < _e812.member.member_1[0])), _e812.member.member_1[0], (_e1003 == 1023u));
                                            let _e1018 = ((_e828.member_1[1] >> bitcast<u32>(_e865)) & 1023u);
                                            let _e1026 = (_e812.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1018)) - 8388608f) * _e876)) ^ _e137)));
                                            let _e1030 = select(select(_e812.member.member_1[1], _e1026, (_e1026 < _e812.member.member_1[1])), _e812.member.member_1[1], (_e1018 == 1023u));
                                            let _e1033 = ((_e828.member_1[1] >> bitcast<u32>(_e887)) & 1023u);
                                            let _e1041 = (_e812.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1033)) - 8388608f) * _e898)) ^ _e137)));
                                            let _e1045 = select(select(_e812.member.member_1[2], _e1041, (_e1041 < _e812.member.member_1[2])), _e812.member.member_1[2], (_e1033 == 1023u));
                                            let _e1050 = type_63(type_55(array<f32, 3>(_e863, _e885, _e907), array<f32, 3>(_e922, _e937, _e952)), _e828.member_2);
                                            let _e1055 = type_63(type_55(array<f32, 3>(_e970, _e985, _e1000), array<f32, 3>(_e1015, _e1030, _e1045)), _e828.member_3);
                                            let _e1061 = ((_e863 - _e504) * _e507);
                                            let _e1062 = ((_e970 - _e504) * _e507);
                                            let _e1063 = ((_e922 - _e505) * _e507);
                                            let _e1064 = ((_e1015 - _e505) * _e507);
                                            let _e1069 = ((_e885 - _e568) * _e571);
                                            let _e1070 = ((_e985 - _e568) * _e571);
                                            let _e1071 = ((_e937 - _e569) * _e571);
                                            let _e1072 = ((_e1030 - _e569) * _e571);
                                            let _e1077 = ((_e907 - _e632) * _e635);
                                            let _e1078 = ((_e1000 - _e632) * _e635);
                                            let _e1079 = ((_e952 - _e633) * _e635);
                                            let _e1080 = ((_e1045 - _e633) * _e635);
                                            let _e1082 = select(_e1079, _e1077, (_e1077 < _e1079));
                                            let _e1084 = select(_e1080, _e1078, (_e1078 < _e1080));
                                            let _e1086 = select(_e1079, _e1077, (_e1077 > _e1079));
                                            let _e1088 = select(_e1080, _e1078, (_e1078 > _e1080));
                                            let _e1090 = select(_e1063, _e1061, (_e1061 < _e1063));
                                            let _e1092 = select(_e1064, _e1062, (_e1062 < _e1064));
                                            let _e1094 = select(_e1071, _e1069, (_e1069 < _e1071));
                                            let _e1096 = select(_e1072, _e1070, (_e1070 < _e1072));
                                            let _e1098 = select(_e1094, _e1090, (_e1090 > _e1094));
                                            let _e1100 = select(_e1096, _e1092, (_e1092 > _e1096));
                                            let _e1102 = select(_e1082, _e1098, (_e1098 > _e1082));
                                            let _e1104 = select(_e1084, _e1100, (_e1100 > _e1084));
                                            let _e1106 = select(_e1063, _e1061, (_e1061 > _e1063));
                                            let _e1108 = select(_e1064, _e1062, (_e1062 > _e1064));
                                            let _e1110 = select(_e1071, _e1069, (_e1069 > _e1071));
                                            let _e1112 = select(_e1072, _e1070, (_e1070 > _e1072));
                                            let _e1114 = select(_e1110, _e1106, (_e1106 < _e1110));
                                            let _e1116 = select(_e1112, _e1108, (_e1108 < _e1112));
                                            let _e1121 = -(_e1082);
                                            let _e1122 = -(_e1084);
                                            let _e1129 = (select(_e1086, _e1114, (_e1114 < _e1086)) + (select(_e1121, _e1086, (_e1086 > _e1121)) * 0.0000019073523f));
                                            let _e1130 = (select(_e1088, _e1116, (_e1116 < _e1088)) + (select(_e1122, _e1088, (_e1088 > _e1122)) * 0.0000019073523f));
                                            let _e1132 = select(_e737, _e1102, (_e1102 > _e737));
                                            let _e1134 = select(_e737, _e1104, (_e1104 > _e737));
                                            let _e1139 = (_e1132 <= select(_e771.member, _e1129, (_e1129 < _e771.member)));
                                            let _e1140 = (_e1134 <= select(_e771.member, _e1130, (_e1130 < _e771.member)));
                                            let _e1141 = (_e1132 <= _e1134);
                                            if _e1139 {
                                                if _e1140 {
                                                    if _e1141 {
                                                        phi_3787_ = _e1055;
                                                    } else {
                                                        phi_3787_ = _e1050;
                                                    }
                                                    let _e1143 = phi_3787_;
                                                    let _e1150 = (_e814 % 128u);
                                                    let _e1151 = (_e1150 < 128u);
                                                    if _e1151 {
                                                    } else {
                                                        phi_4337_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1150] = _e1143.member_1;
                                                    if _e1151 {
                                                    } else {
                                                        phi_4337_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1150] = _e1143.member.member[0];
                                                    if _e1151 {
                                                    } else {
                                                        phi_4337_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1150] = _e1143.member.member[1];
                                                    if _e1151 {
                                                    } else {
                                                        phi_4337_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1150] = _e1143.member.member[2];
                                                    if _e1151 {
                                                    } else {
                                                        phi_4337_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1150] = _e1143.member.member_1[0];
                                                    if _e1151 {
                                                    } else {
                                                        phi_4337_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1150] = _e1143.member.member_1[1];
                                                    if _e1151 {
                                                    } else {
                                                        phi_4337_ = true;
                                                        break;
                                                    }
                                                    local[_e1150] = _e1143.member.member_1[2];
                                                    if _e1151 {
                                                    } else {
                                                        phi_4337_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1150] = select(_e1132, _e1134, _e1141);
                                                    if _e1141 {
                                                        phi_3863_ = _e1050;
                                                    } else {
                                                        phi_3863_ = _e1055;
                                                    }
                                                    let _e1168 = phi_3863_;
                                                    phi_3864_ = _e1168;
                                                    phi_3865_ = (_e814 + 1u);
                                                } else {
                                                    phi_3864_ = type_63();
                                                    phi_3865_ = u32();
                                                }
                                                let _e1170 = phi_3864_;
                                                let _e1172 = phi_3865_;
                                                phi_3867_ = _e1170;
                                                phi_3868_ = _e1172;
                                                phi_3869_ = select(true, false, _e1140);
                                            } else {
                                                phi_3867_ = type_63();
                                                phi_3868_ = u32();
                                                phi_3869_ = true;
                                            }
                                            let _e1175 = phi_3867_;
                                            let _e1177 = phi_3868_;
                                            let _e1179 = phi_3869_;
                                            if _e1179 {
                                                if _e1139 {
                                                    phi_3876_ = _e1050;
                                                } else {
                                                    phi_3876_ = _e1055;
                                                }
                                                let _e1181 = phi_3876_;
                                                phi_3881_ = select(_e1140, true, _e1139);
                                                phi_3882_ = _e1181;
                                            } else {
                                                phi_3881_ = _e810;
                                                phi_3882_ = _e1175;
                                            }
                                            let _e1184 = phi_3881_;
                                            let _e1186 = phi_3882_;
                                            phi_4341_ = _e769;
                                            phi_3884_ = _e771;
                                            phi_3885_ = _e1184;
                                            phi_3886_ = _e1186;
                                            phi_3887_ = select(_e1177, _e814, _e1179);
                                        }
                                        let _e2070 = phi_4341_;
                                        let _e2072 = phi_3884_;
                                        let _e2074 = phi_3885_;
                                        let _e2076 = phi_3886_;
                                        let _e2078 = phi_3887_;
                                        phi_4340_ = _e2070;
                                        phi_3888_ = _e2072;
                                        phi_3889_ = _e2074;
                                        phi_3890_ = _e2076;
                                        phi_3891_ = _e2078;
                                        phi_3892_ = (_e779 - 1u);
                                    } else {
                                        phi_4340_ = _e769;
                                        phi_3888_ = _e771;
                                        phi_3889_ = _e810;
                                        phi_3890_ = _e812;
                                        phi_3891_ = _e814;
                                        phi_3892_ = _e779;
                                    }
                                    let _e2080 = phi_4340_;
                                    let _e2082 = phi_3888_;
                                    let _e2084 = phi_3889_;
                                    let _e2086 = phi_3890_;
                                    let _e2088 = phi_3891_;
                                    let _e2090 = phi_3892_;
                                    phi_4339_ = _e2080;
                                    phi_3893_ = _e2082;
                                    phi_3894_ = _e2084;
                                    phi_3895_ = _e2086;
                                    phi_3896_ = _e2088;
                                    phi_3897_ = _e2090;
                                } else {
                                    phi_4339_ = _e769;
                                    phi_3893_ = type_41();
                                    phi_3894_ = bool();
                                    phi_3895_ = type_63();
                                    phi_3896_ = u32();
                                    phi_3897_ = u32();
                                }
                                let _e2092 = phi_4339_;
                                let _e2094 = phi_3893_;
                                let _e2096 = phi_3894_;
                                let _e2098 = phi_3895_;
                                let _e2100 = phi_3896_;
                                let _e2102 = phi_3897_;
                                phi_4338_ = _e2092;
                                phi_1326_ = _e2094;
                                phi_1329_ = _e2096;
                                phi_1331_ = _e2098;
                                phi_1333_ = _e2100;
                                phi_1335_ = _e2102;
                                phi_3898_ = _e783;
                            } else {
                                phi_4338_ = _e769;
                                phi_1326_ = type_41();
                                phi_1329_ = bool();
                                phi_1331_ = type_63();
                                phi_1333_ = u32();
                                phi_1335_ = u32();
                                phi_3898_ = false;
                            }
                            let _e2104 = phi_4338_;
                            let _e2106 = phi_1326_;
                            let _e2108 = phi_1329_;
                            let _e2110 = phi_1331_;
                            let _e2112 = phi_1333_;
                            let _e2114 = phi_1335_;
                            let _e2116 = phi_3898_;
                            continue;
                            continuing {
                                phi_4140_ = _e2104;
                                phi_1325_ = _e2106;
                                phi_1328_ = _e2108;
                                phi_1330_ = _e2110;
                                phi_1332_ = _e2112;
                                phi_1334_ = _e2114;
                                phi_4337_ = _e2104;
                                break if !(_e2116);
                            }
                        }
                        let _e2119 = phi_4337_;
                        if _e2119 {
                            break;
                        }
                        let _e2121 = local_11;
                        if _e2121.member_1 {
                        } else {
                            if _e287 {
                            } else {
                                break;
                            }
                            let _e2125 = global_2.member[_e141];
                            if _e148 {
                            } else {
                                break;
                            }
                            let _e2129 = global_8.member[_e141].member_1;
                            if _e287 {
                            } else {
                                break;
                            }
                            global_2.member[_e141] = type_24(_e2125.member, _e2125.member_1, _e2125.member_2, array<f32, 3>((_e2125.member_3[0] + (_e2129[0] * _e2125.member_1[0])), (_e2125.member_3[1] + (_e2129[1] * _e2125.member_1[1])), (_e2125.member_3[2] + (_e2129[2] * _e2125.member_1[2]))), _e2125.member_4);
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
fn trace_shadows_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
