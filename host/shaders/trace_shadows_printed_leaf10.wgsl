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
    var phi_308_: u32;
    var phi_352_: i32;
    var phi_492_: type_36;
    var phi_642_: i32;
    var phi_643_: i32;
    var phi_653_: bool;
    var phi_663_: u32;
    var phi_664_: u32;
    var phi_666_: bool;
    var phi_671_: u32;
    var phi_704_: i32;
    var phi_722_: f32;
    var phi_728_: f32;
    var phi_768_: f32;
    var phi_774_: f32;
    var phi_847_: f32;
    var phi_853_: f32;
    var phi_893_: f32;
    var phi_899_: f32;
    var phi_972_: f32;
    var phi_978_: f32;
    var phi_1018_: f32;
    var phi_1024_: f32;
    var phi_1143_: i32;
    var phi_1165_: u32;
    var phi_1166_: u32;
    var phi_1203_: i32;
    var phi_1225_: u32;
    var phi_1226_: u32;
    var phi_1234_: f32;
    var phi_1235_: f32;
    var phi_4212_: bool;
    var phi_1318_: type_41;
    var phi_1321_: u32;
    var phi_1323_: bool;
    var phi_1325_: u32;
    var phi_1327_: type_63;
    var phi_1338_: bool;
    var phi_1424_: bool;
    var phi_1425_: u32;
    var phi_1426_: type_63;
    var phi_1445_: type_41;
    var phi_1448_: type_8;
    var phi_1449_: type_8;
    var phi_1471_: type_8;
    var phi_1496_: u32;
    var phi_1512_: type_57;
    var phi_4007_: bool;
    var phi_4022_: bool;
    var phi_4037_: bool;
    var phi_4052_: bool;
    var phi_4067_: bool;
    var phi_4082_: bool;
    var phi_2319_: f32;
    var phi_2320_: f32;
    var phi_2321_: f32;
    var phi_2322_: f32;
    var phi_2323_: vec3<f32>;
    var phi_2324_: vec3<f32>;
    var phi_2325_: vec3<f32>;
    var phi_2326_: vec3<f32>;
    var phi_4097_: bool;
    var phi_4112_: bool;
    var phi_4127_: bool;
    var phi_4142_: bool;
    var phi_4157_: bool;
    var phi_4172_: bool;
    var phi_2534_: f32;
    var phi_2554_: type_40;
    var phi_2555_: type_40;
    var phi_2558_: type_40;
    var phi_2559_: type_40;
    var phi_2560_: bool;
    var phi_2564_: type_40;
    var phi_2573_: type_22;
    var phi_2596_: u32;
    var phi_2610_: i32;
    var phi_2628_: vec3<f32>;
    var phi_2629_: vec3<f32>;
    var phi_2643_: vec3<f32>;
    var phi_2644_: vec3<f32>;
    var phi_2658_: vec3<f32>;
    var phi_2659_: vec3<f32>;
    var phi_2695_: vec3<f32>;
    var phi_2877_: f32;
    var phi_2895_: bool;
    var phi_2896_: bool;
    var phi_2901_: type_41;
    var phi_2902_: type_41;
    var phi_1446_: type_41;
    var phi_4206_: bool;
    var phi_4480_: bool;
    var phi_2903_: type_41;
    var phi_2924_: type_50;
    var phi_3810_: type_63;
    var phi_3886_: type_63;
    var phi_3887_: u32;
    var phi_3888_: type_63;
    var phi_3890_: u32;
    var phi_3891_: type_63;
    var phi_3892_: bool;
    var phi_3899_: type_63;
    var phi_3904_: bool;
    var phi_3906_: type_63;
    var phi_3910_: bool;
    var phi_3911_: u32;
    var phi_3912_: type_63;
    var phi_3922_: u32;
    var phi_3923_: type_63;
    var phi_4424_: bool;
    var phi_3924_: type_41;
    var phi_3925_: u32;
    var phi_3926_: bool;
    var phi_3927_: u32;
    var phi_3928_: type_63;
    var phi_4423_: bool;
    var phi_3929_: type_41;
    var phi_3930_: u32;
    var phi_3931_: bool;
    var phi_3932_: u32;
    var phi_3933_: type_63;
    var phi_4422_: bool;
    var phi_1319_: type_41;
    var phi_1322_: u32;
    var phi_1324_: bool;
    var phi_1326_: u32;
    var phi_1328_: type_63;
    var phi_3934_: bool;
    var phi_4421_: bool;
    var local_10: type_41;
    var local_11: type_41;

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
                phi_308_ = _e152;
            } else {
                phi_308_ = 4294967295u;
            }
            let _e154 = phi_308_;
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
                phi_352_ = -126i;
            } else {
                phi_352_ = select(_e197, 127i, (_e197 > 127i));
            }
            let _e202 = phi_352_;
            let _e207 = bitcast<f32>((bitcast<u32>((_e202 + 127i)) << bitcast<u32>(23i)));
            let _e213 = bitcast<f32>((bitcast<u32>(((_e197 - _e202) + 127i)) << bitcast<u32>(23i)));
            if (_e173 == 0u) {
                phi_492_ = type_36(array<f32, 3>(_e190, _e191, _e192), _e173, _e194, _e195);
            } else {
                let _e215 = bitcast<u32>(_e190);
                let _e217 = ((_e215 & 2139095040u) != 0u);
                let _e232 = bitcast<u32>(_e191);
                let _e234 = ((_e232 & 2139095040u) != 0u);
                let _e249 = bitcast<u32>(_e192);
                let _e251 = ((_e249 & 2139095040u) != 0u);
                let _e267 = bitcast<u32>(_e194);
                let _e269 = ((_e267 & 2139095040u) != 0u);
                phi_492_ = type_36(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e215 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e215 & 2147483648u))), _e190, _e217) * _e207) * select(0.00000011920929f, 1f, _e217)) * _e213), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e232 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e232 & 2147483648u))), _e191, _e234) * _e207) * select(0.00000011920929f, 1f, _e234)) * _e213), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e249 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e249 & 2147483648u))), _e192, _e251) * _e207) * select(0.00000011920929f, 1f, _e251)) * _e213)), _e173, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e267 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e267 & 2147483648u))), _e194, _e269) * _e207) * select(0.00000011920929f, 1f, _e269)) * _e213), _e195);
            }
            let _e286 = phi_492_;
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
                                phi_642_ = (bitcast<i32>((_e384 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_642_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e384)), 32u, (_e384 == 0u))));
                            }
                            let _e398 = phi_642_;
                            phi_643_ = _e398;
                        } else {
                            phi_643_ = 0i;
                        }
                        let _e400 = phi_643_;
                        let _e401 = (_e320 == _e364);
                        if _e401 {
                            phi_653_ = true;
                        } else {
                            phi_653_ = (_e328 == _e364);
                        }
                        let _e404 = phi_653_;
                        let _e405 = select(1u, 0u, _e401);
                        if _e404 {
                            let _e406 = (_e405 + 1u);
                            phi_663_ = _e406;
                            phi_664_ = _e406;
                            phi_666_ = select(true, false, (_e406 == 2u));
                        } else {
                            phi_663_ = u32();
                            phi_664_ = 0u;
                            phi_666_ = true;
                        }
                        let _e410 = phi_663_;
                        let _e412 = phi_664_;
                        let _e414 = phi_666_;
                        if _e414 {
                            phi_671_ = (_e412 + 1u);
                        } else {
                            phi_671_ = 0u;
                        }
                        let _e418 = phi_671_;
                        let _e419 = select(_e410, _e412, _e414);
                        let _e420 = select(_e405, select(2u, _e405, _e404), _e414);
                        let _e421 = -(_e400);
                        if (_e421 < -126i) {
                            phi_704_ = -126i;
                        } else {
                            phi_704_ = select(_e421, 127i, (_e421 > 127i));
                        }
                        let _e426 = phi_704_;
                        let _e431 = bitcast<f32>((bitcast<u32>((_e426 + 127i)) << bitcast<u32>(23i)));
                        let _e437 = bitcast<f32>((bitcast<u32>(((_e421 - _e426) + 127i)) << bitcast<u32>(23i)));
                        let _e442 = global_8.member[_e141].member.member;
                        let _e443 = (_e419 == 0u);
                        if _e443 {
                            phi_722_ = _e442[0];
                        } else {
                            phi_722_ = _e442[1];
                        }
                        let _e447 = phi_722_;
                        let _e448 = (_e419 == 2u);
                        if _e448 {
                            phi_728_ = _e442[2];
                        } else {
                            phi_728_ = _e447;
                        }
                        let _e451 = phi_728_;
                        let _e452 = bitcast<u32>(_e451);
                        let _e454 = ((_e452 & 2139095040u) != 0u);
                        let _e466 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e452 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e452 & 2147483648u))), _e451, _e454) * select(0.00000011920929f, 1f, _e454));
                        let _e467 = global_8.member[_e141].member.member_2;
                        if _e443 {
                            phi_768_ = _e467[0];
                        } else {
                            phi_768_ = _e467[1];
                        }
                        let _e471 = phi_768_;
                        if _e448 {
                            phi_774_ = _e467[2];
                        } else {
                            phi_774_ = _e471;
                        }
                        let _e474 = phi_774_;
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
                            phi_847_ = _e442[0];
                        } else {
                            phi_847_ = _e442[1];
                        }
                        let _e512 = phi_847_;
                        let _e513 = (_e418 == 2u);
                        if _e513 {
                            phi_853_ = _e442[2];
                        } else {
                            phi_853_ = _e512;
                        }
                        let _e516 = phi_853_;
                        let _e517 = bitcast<u32>(_e516);
                        let _e519 = ((_e517 & 2139095040u) != 0u);
                        let _e531 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e517 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e517 & 2147483648u))), _e516, _e519) * select(0.00000011920929f, 1f, _e519));
                        if _e508 {
                            phi_893_ = _e467[0];
                        } else {
                            phi_893_ = _e467[1];
                        }
                        let _e535 = phi_893_;
                        if _e513 {
                            phi_899_ = _e467[2];
                        } else {
                            phi_899_ = _e535;
                        }
                        let _e538 = phi_899_;
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
                            phi_972_ = _e442[0];
                        } else {
                            phi_972_ = _e442[1];
                        }
                        let _e576 = phi_972_;
                        let _e577 = (_e420 == 2u);
                        if _e577 {
                            phi_978_ = _e442[2];
                        } else {
                            phi_978_ = _e576;
                        }
                        let _e580 = phi_978_;
                        let _e581 = bitcast<u32>(_e580);
                        let _e583 = ((_e581 & 2139095040u) != 0u);
                        let _e595 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e581 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e581 & 2147483648u))), _e580, _e583) * select(0.00000011920929f, 1f, _e583));
                        if _e572 {
                            phi_1018_ = _e467[0];
                        } else {
                            phi_1018_ = _e467[1];
                        }
                        let _e599 = phi_1018_;
                        if _e577 {
                            phi_1024_ = _e467[2];
                        } else {
                            phi_1024_ = _e599;
                        }
                        let _e602 = phi_1024_;
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
                                phi_1143_ = 255i;
                            } else {
                                phi_1143_ = (((_e652 + select(0i, 1i, (_e652 == 0i))) - _e659) + _e400);
                            }
                            let _e667 = phi_1143_;
                            let _e677 = (_e667 <= 0i);
                            if _e677 {
                                phi_1166_ = u32();
                            } else {
                                if _e656 {
                                    phi_1165_ = u32();
                                } else {
                                    phi_1165_ = select(((bitcast<u32>(_e667) << bitcast<u32>(23i)) | ((_e649 << bitcast<u32>(((_e659 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e667 >= 255i));
                                }
                                let _e681 = phi_1165_;
                                phi_1166_ = _e681;
                            }
                            let _e683 = phi_1166_;
                            let _e695 = ((_e377 & 8388607u) | (select(0u, 1u, ((_e377 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e698 = bitcast<i32>((_e377 >> bitcast<u32>(23i)));
                            let _e702 = (_e695 == 0u);
                            let _e705 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e695)), 32u, _e702)) - 8i);
                            if (_e698 == 255i) {
                                phi_1203_ = 255i;
                            } else {
                                phi_1203_ = (((_e698 + select(0i, 1i, (_e698 == 0i))) - _e705) + _e400);
                            }
                            let _e713 = phi_1203_;
                            let _e723 = (_e713 <= 0i);
                            if _e723 {
                                phi_1226_ = u32();
                            } else {
                                if _e702 {
                                    phi_1225_ = u32();
                                } else {
                                    phi_1225_ = select(((bitcast<u32>(_e713) << bitcast<u32>(23i)) | ((_e695 << bitcast<u32>(((_e705 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e713 >= 255i));
                                }
                                let _e727 = phi_1225_;
                                phi_1226_ = _e727;
                            }
                            let _e729 = phi_1226_;
                            phi_1234_ = bitcast<f32>(((_e376 & 2147483648u) | select(_e729, 0u, select(_e702, true, _e723))));
                            phi_1235_ = bitcast<f32>(((_e371 & 2147483648u) | select(_e683, 0u, select(_e656, true, _e677))));
                        } else {
                            phi_1234_ = 0f;
                            phi_1235_ = 1f;
                        }
                        let _e735 = phi_1234_;
                        let _e737 = phi_1235_;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e113), bitcast<f32>(_e117), bitcast<f32>(_e121));
                        let _e742 = (_e419 % 3u);
                        let _e743 = (_e742 < 3u);
                        if _e743 {
                        } else {
                            break;
                        }
                        let _e745 = local_9[_e742];
                        let _e746 = (_e418 % 3u);
                        let _e747 = (_e746 < 3u);
                        if _e747 {
                        } else {
                            break;
                        }
                        let _e749 = local_9[_e746];
                        let _e750 = (_e420 % 3u);
                        let _e751 = (_e750 < 3u);
                        if _e751 {
                        } else {
                            break;
                        }
                        let _e753 = local_9[_e750];
                        local_8 = array<f32, 3>(bitcast<f32>(_e125), bitcast<f32>(_e129), bitcast<f32>(_e133));
                        if _e743 {
                        } else {
                            break;
                        }
                        let _e757 = local_8[_e742];
                        if _e747 {
                        } else {
                            break;
                        }
                        let _e759 = local_8[_e746];
                        if _e751 {
                        } else {
                            break;
                        }
                        let _e761 = local_8[_e750];
                        phi_4212_ = false;
                        phi_1318_ = type_41(_e735, false);
                        phi_1321_ = ((3u * _e94) + 1u);
                        phi_1323_ = (_e737 <= _e735);
                        phi_1325_ = 0u;
                        phi_1327_ = type_63(type_55(array<f32, 3>(_e745, _e749, _e753), array<f32, 3>(_e757, _e759, _e761)), select(0u, 2147483648u, (_e94 == 0u)));
                        loop {
                            let _e769 = phi_4212_;
                            let _e771 = phi_1318_;
                            let _e773 = phi_1321_;
                            let _e775 = phi_1323_;
                            let _e777 = phi_1325_;
                            let _e779 = phi_1327_;
                            local_10 = _e771;
                            if _e775 {
                                phi_1338_ = true;
                            } else {
                                phi_1338_ = (_e777 > 0u);
                            }
                            let _e782 = phi_1338_;
                            if _e782 {
                                let _e783 = (_e773 > 0u);
                                if _e783 {
                                    if _e775 {
                                        phi_1424_ = _e775;
                                        phi_1425_ = _e777;
                                        phi_1426_ = _e779;
                                    } else {
                                        let _e784 = (_e777 - 1u);
                                        let _e785 = (_e784 % 128u);
                                        let _e786 = (_e785 < 128u);
                                        if _e786 {
                                        } else {
                                            phi_4421_ = true;
                                            break;
                                        }
                                        let _e788 = local_6[_e785];
                                        if _e786 {
                                        } else {
                                            phi_4421_ = true;
                                            break;
                                        }
                                        let _e790 = local_5[_e785];
                                        if _e786 {
                                        } else {
                                            phi_4421_ = true;
                                            break;
                                        }
                                        let _e792 = local_4[_e785];
                                        if _e786 {
                                        } else {
                                            phi_4421_ = true;
                                            break;
                                        }
                                        let _e794 = local_3[_e785];
                                        if _e786 {
                                        } else {
                                            phi_4421_ = true;
                                            break;
                                        }
                                        let _e797 = local_2[_e785];
                                        if _e786 {
                                        } else {
                                            phi_4421_ = true;
                                            break;
                                        }
                                        let _e799 = local_1[_e785];
                                        if _e786 {
                                        } else {
                                            phi_4421_ = true;
                                            break;
                                        }
                                        let _e801 = local[_e785];
                                        if _e786 {
                                        } else {
                                            phi_4421_ = true;
                                            break;
                                        }
                                        let _e806 = local_7[_e785];
                                        phi_1424_ = (_e806 <= _e771.member);
                                        phi_1425_ = _e784;
                                        phi_1426_ = type_63(type_55(array<f32, 3>(_e790, _e792, _e794), array<f32, 3>(_e797, _e799, _e801)), _e788);
                                    }
                                    let _e810 = phi_1424_;
                                    let _e812 = phi_1425_;
                                    let _e814 = phi_1426_;
                                    if _e810 {
                                        let _e818 = ((_e814.member_1 & 2147483648u) != 0u);
                                        if _e818 {
                                            phi_1445_ = _e771;
                                            phi_1448_ = type_8(0u, ((_e814.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e826 = phi_1445_;
                                                let _e828 = phi_1448_;
                                                local_11 = _e826;
                                                if (_e828.member < _e828.member_1) {
                                                    phi_1449_ = type_8((_e828.member + 1u), _e828.member_1);
                                                    phi_1471_ = type_8(1u, _e828.member);
                                                } else {
                                                    phi_1449_ = _e828;
                                                    phi_1471_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e841 = phi_1449_;
                                                let _e843 = phi_1471_;
                                                let _e847 = (bitcast<i32>(_e843.member) != 0i);
                                                if _e847 {
                                                    let _e848 = ((_e814.member_1 & 268435455u) + _e843.member_1);
                                                    let _e849 = (_e848 < arrayLength((&global_10.member)));
                                                    if _e849 {
                                                        if _e849 {
                                                        } else {
                                                            phi_4206_ = true;
                                                            break;
                                                        }
                                                        let _e852 = global_10.member[_e848].member_1;
                                                        phi_1496_ = _e852;
                                                    } else {
                                                        phi_1496_ = 4294967295u;
                                                    }
                                                    let _e854 = phi_1496_;
                                                    if _e849 {
                                                        if _e849 {
                                                        } else {
                                                            phi_4206_ = true;
                                                            break;
                                                        }
                                                        let _e856 = global_10.member[_e848];
                                                        phi_1512_ = _e856;
                                                    } else {
                                                        phi_1512_ = type_57(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e858 = phi_1512_;
                                                    let _e870 = ((10u * _e419) & 31u);
                                                    let _e873 = ((_e858.member[0] >> bitcast<u32>(_e870)) & 1023u);
                                                    let _e881 = bitcast<f32>((bitcast<u32>(((_e814.member.member_1[0] - _e814.member.member[0]) * 0.0009775171f)) ^ _e137));
                                                    let _e886 = (_e814.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e873)) - 8388608f) * _e881)) ^ _e137)));
                                                    let _e890 = select(select(_e814.member.member_1[0], _e886, (_e886 < _e814.member.member_1[0])), _e814.member.member_1[0], (_e873 == 1023u));
                                                    let _e892 = ((10u * _e418) & 31u);
                                                    let _e895 = ((_e858.member[0] >> bitcast<u32>(_e892)) & 1023u);
                                                    let _e903 = bitcast<f32>((bitcast<u32>(((_e814.member.member_1[1] - _e814.member.member[1]) * 0.0009775171f)) ^ _e137));
                                                    let _e908 = (_e814.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e895)) - 8388608f) * _e903)) ^ _e137)));
                                                    let _e912 = select(select(_e814.member.member_1[1], _e908, (_e908 < _e814.member.member_1[1])), _e814.member.member_1[1], (_e895 == 1023u));
                                                    let _e914 = ((10u * _e420) & 31u);
                                                    let _e917 = ((_e858.member[0] >> bitcast<u32>(_e914)) & 1023u);
                                                    let _e925 = bitcast<f32>((bitcast<u32>(((_e814.member.member_1[2] - _e814.member.member[2]) * 0.0009775171f)) ^ _e137));
                                                    let _e930 = (_e814.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e917)) - 8388608f) * _e925)) ^ _e137)));
                                                    let _e934 = select(select(_e814.member.member_1[2], _e930, (_e930 < _e814.member.member_1[2])), _e814.member.member_1[2], (_e917 == 1023u));
                                                    let _e938 = ((_e858.member[1] >> bitcast<u32>(_e870)) & 1023u);
                                                    let _e946 = (_e814.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e938)) - 8388608f) * _e881)) ^ _e137)));
                                                    let _e950 = select(select(_e814.member.member_1[0], _e946, (_e946 < _e814.member.member_1[0])), _e814.member.member_1[0], (_e938 == 1023u));
                                                    let _e953 = ((_e858.member[1] >> bitcast<u32>(_e892)) & 1023u);
                                                    let _e961 = (_e814.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e953)) - 8388608f) * _e903)) ^ _e137)));
                                                    let _e965 = select(select(_e814.member.member_1[1], _e961, (_e961 < _e814.member.member_1[1])), _e814.member.member_1[1], (_e953 == 1023u));
                                                    let _e968 = ((_e858.member[1] >> bitcast<u32>(_e914)) & 1023u);
                                                    let _e976 = (_e814.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e968)) - 8388608f) * _e925)) ^ _e137)));
                                                    let _e980 = select(select(_e814.member.member_1[2], _e976, (_e976 < _e814.member.member_1[2])), _e814.member.member_1[2], (_e968 == 1023u));
                                                    let _e984 = ((_e858.member[2] >> bitcast<u32>(_e870)) & 1023u);
                                                    let _e992 = (_e814.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e984)) - 8388608f) * _e881)) ^ _e137)));
                                                    let _e996 = select(select(_e814.member.member_1[0], _e992, (_e992 < _e814.member.member_1[0])), _e814.member.member_1[0], (_e984 == 1023u));
                                                    let _e999 = ((_e858.member[2] >> bitcast<u32>(_e892)) & 1023u);
                                                    let _e1007 = (_e814.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e999)) - 8388608f) * _e903)) ^ _e137)));
                                                    let _e1011 = select(select(_e814.member.member_1[1], _e1007, (_e1007 < _e814.member.member_1[1])), _e814.member.member_1[1], (_e999 == 1023u));
                                                    let _e1014 = ((_e858.member[2] >> bitcast<u32>(_e914)) & 1023u);
                                                    let _e1022 = (_e814.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1014)) - 8388608f) * _e925)) ^ _e137)));
                                                    let _e1026 = select(select(_e814.member.member_1[2], _e1022, (_e1022 < _e814.member.member_1[2])), _e814.member.member_1[2], (_e1014 == 1023u));
                                                    let _e1030 = (_e934 - _e595);
                                                    let _e1033 = (((_e890 - _e466) * _e631) - (_e1030 * _e503));
                                                    let _e1036 = (((_e912 - _e531) * _e631) - (_e1030 * _e567));
                                                    let _e1039 = (_e980 - _e595);
                                                    let _e1042 = (((_e950 - _e466) * _e631) - (_e1039 * _e503));
                                                    let _e1045 = (((_e965 - _e531) * _e631) - (_e1039 * _e567));
                                                    let _e1048 = (_e1026 - _e595);
                                                    let _e1051 = (((_e996 - _e466) * _e631) - (_e1048 * _e503));
                                                    let _e1054 = (((_e1011 - _e531) * _e631) - (_e1048 * _e567));
                                                    let _e1055 = (_e1051 * _e1045);
                                                    let _e1056 = (_e1054 * _e1042);
                                                    let _e1057 = (_e1033 * _e1054);
                                                    let _e1058 = (_e1036 * _e1051);
                                                    let _e1059 = (_e1042 * _e1036);
                                                    let _e1060 = (_e1045 * _e1033);
                                                    let _e1065 = (((_e1055 >= _e1056) && (_e1057 >= _e1058)) && (_e1059 >= _e1060));
                                                    let _e1071 = (_e1065 || (((_e1055 <= _e1056) && (_e1057 <= _e1058)) && (_e1059 <= _e1060)));
                                                    if _e1071 {
                                                        let _e1073 = select(-1f, 1f, _e1065);
                                                        let _e1075 = ((_e1055 - _e1056) * _e1073);
                                                        let _e1077 = select(0f, _e1075, (_e1075 > 0f));
                                                        let _e1079 = ((_e1057 - _e1058) * _e1073);
                                                        let _e1081 = select(0f, _e1079, (_e1079 > 0f));
                                                        let _e1083 = ((_e1059 - _e1060) * _e1073);
                                                        let _e1085 = select(0f, _e1083, (_e1083 > 0f));
                                                        let _e1087 = ((_e1077 + _e1081) + _e1085);
                                                        let _e1089 = select(_e950, _e890, (_e890 < _e950));
                                                        let _e1093 = select(_e950, _e890, (_e890 > _e950));
                                                        let _e1097 = select(_e965, _e912, (_e912 < _e965));
                                                        let _e1101 = select(_e965, _e912, (_e912 > _e965));
                                                        let _e1105 = select(_e980, _e934, (_e934 < _e980));
                                                        let _e1109 = select(_e980, _e934, (_e934 > _e980));
                                                        let _e1114 = ((select(_e996, _e1089, (_e1089 < _e996)) - _e504) * _e507);
                                                        let _e1115 = ((select(_e996, _e1093, (_e1093 > _e996)) - _e505) * _e507);
                                                        let _e1118 = ((select(_e1011, _e1097, (_e1097 < _e1011)) - _e568) * _e571);
                                                        let _e1119 = ((select(_e1011, _e1101, (_e1101 > _e1011)) - _e569) * _e571);
                                                        let _e1122 = ((select(_e1026, _e1105, (_e1105 < _e1026)) - _e632) * _e635);
                                                        let _e1123 = ((select(_e1026, _e1109, (_e1109 > _e1026)) - _e633) * _e635);
                                                        let _e1125 = select(_e1123, _e1122, (_e1122 < _e1123));
                                                        let _e1127 = select(_e1123, _e1122, (_e1122 > _e1123));
                                                        let _e1129 = select(_e1115, _e1114, (_e1114 < _e1115));
                                                        let _e1131 = select(_e1119, _e1118, (_e1118 < _e1119));
                                                        let _e1133 = select(_e1131, _e1129, (_e1129 > _e1131));
                                                        let _e1135 = select(_e1125, _e1133, (_e1133 > _e1125));
                                                        let _e1137 = select(_e1115, _e1114, (_e1114 > _e1115));
                                                        let _e1139 = select(_e1119, _e1118, (_e1118 > _e1119));
                                                        let _e1141 = select(_e1139, _e1137, (_e1137 < _e1139));
                                                        let _e1143 = select(_e1127, _e1141, (_e1141 < _e1127));
                                                        let _e1144 = -(_e1125);
                                                        let _e1150 = select(_e737, _e1135, (_e1135 > _e737));
                                                        let _e1154 = select(_e1042, _e1033, (_e1033 < _e1042));
                                                        let _e1159 = select(_e1042, _e1033, (_e1033 > _e1042));
                                                        let _e1166 = select(_e1045, _e1036, (_e1036 < _e1045));
                                                        let _e1171 = select(_e1045, _e1036, (_e1036 > _e1045));
                                                        let _e1180 = (((((_e1071 && (_e1087 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1051, _e1154, (_e1154 < _e1051)) <= 0f) && (select(_e1051, _e1159, (_e1159 > _e1051)) >= 0f))) && ((select(_e1054, _e1166, (_e1166 < _e1054)) <= 0f) && (select(_e1054, _e1171, (_e1171 > _e1054)) >= 0f))) && (_e1150 <= (_e1143 + (select(_e1144, _e1127, (_e1127 > _e1144)) * 0.0000019073523f)))) && (_e1150 <= _e826.member));
                                                        if _e1180 {
                                                            let _e1185 = (_e950 - _e890);
                                                            let _e1186 = (_e965 - _e912);
                                                            let _e1187 = (_e980 - _e934);
                                                            let _e1188 = vec3<f32>(_e1185, _e1186, _e1187);
                                                            let _e1189 = (_e996 - _e950);
                                                            let _e1190 = (_e1011 - _e965);
                                                            let _e1191 = (_e1026 - _e980);
                                                            let _e1192 = vec3<f32>(_e1189, _e1190, _e1191);
                                                            let _e1193 = (_e890 - _e996);
                                                            let _e1194 = (_e912 - _e1011);
                                                            let _e1195 = (_e934 - _e1026);
                                                            let _e1196 = vec3<f32>(_e1193, _e1194, _e1195);
                                                            let _e1197 = abs(_e1185);
                                                            let _e1198 = abs(_e1186);
                                                            if (_e1197 != _e1197) {
                                                                phi_4007_ = true;
                                                            } else {
                                                                phi_4007_ = (_e1198 >= _e1197);
                                                            }
                                                            let _e1202 = phi_4007_;
                                                            let _e1203 = select(_e1197, _e1198, _e1202);
                                                            let _e1204 = abs(_e1187);
                                                            if (_e1203 != _e1203) {
                                                                phi_4022_ = true;
                                                            } else {
                                                                phi_4022_ = (_e1204 >= _e1203);
                                                            }
                                                            let _e1208 = phi_4022_;
                                                            let _e1209 = select(_e1203, _e1204, _e1208);
                                                            let _e1210 = abs(_e1189);
                                                            let _e1211 = abs(_e1190);
                                                            if (_e1210 != _e1210) {
                                                                phi_4037_ = true;
                                                            } else {
                                                                phi_4037_ = (_e1211 >= _e1210);
                                                            }
                                                            let _e1215 = phi_4037_;
                                                            let _e1216 = select(_e1210, _e1211, _e1215);
                                                            let _e1217 = abs(_e1191);
                                                            if (_e1216 != _e1216) {
                                                                phi_4052_ = true;
                                                            } else {
                                                                phi_4052_ = (_e1217 >= _e1216);
                                                            }
                                                            let _e1221 = phi_4052_;
                                                            let _e1222 = select(_e1216, _e1217, _e1221);
                                                            let _e1223 = abs(_e1193);
                                                            let _e1224 = abs(_e1194);
                                                            if (_e1223 != _e1223) {
                                                                phi_4067_ = true;
                                                            } else {
                                                                phi_4067_ = (_e1224 >= _e1223);
                                                            }
                                                            let _e1228 = phi_4067_;
                                                            let _e1229 = select(_e1223, _e1224, _e1228);
                                                            let _e1230 = abs(_e1195);
                                                            if (_e1229 != _e1229) {
                                                                phi_4082_ = true;
                                                            } else {
                                                                phi_4082_ = (_e1230 >= _e1229);
                                                            }
                                                            let _e1234 = phi_4082_;
                                                            let _e1235 = select(_e1229, _e1230, _e1234);
                                                            let _e1237 = select(_e1222, _e1209, (_e1209 > _e1222));
                                                            let _e1239 = select(_e1235, _e1237, (_e1237 > _e1235));
                                                            if (_e1209 == _e1239) {
                                                                phi_2319_ = _e1045;
                                                                phi_2320_ = _e1042;
                                                                phi_2321_ = _e1036;
                                                                phi_2322_ = _e1033;
                                                                phi_2323_ = vec3<f32>(_e890, _e912, _e934);
                                                                phi_2324_ = _e1196;
                                                                phi_2325_ = _e1192;
                                                                phi_2326_ = _e1188;
                                                            } else {
                                                                let _e1241 = (_e1222 == _e1239);
                                                                let _e1246 = vec3(_e1241);
                                                                phi_2319_ = select(_e1036, _e1054, _e1241);
                                                                phi_2320_ = select(_e1033, _e1051, _e1241);
                                                                phi_2321_ = select(_e1054, _e1045, _e1241);
                                                                phi_2322_ = select(_e1051, _e1042, _e1241);
                                                                phi_2323_ = select(vec3<f32>(_e996, _e1011, _e1026), vec3<f32>(_e950, _e965, _e980), _e1246);
                                                                phi_2324_ = select(_e1192, _e1188, _e1246);
                                                                phi_2325_ = select(_e1188, _e1196, _e1246);
                                                                phi_2326_ = select(_e1196, _e1192, _e1246);
                                                            }
                                                            let _e1252 = phi_2319_;
                                                            let _e1254 = phi_2320_;
                                                            let _e1256 = phi_2321_;
                                                            let _e1258 = phi_2322_;
                                                            let _e1260 = phi_2323_;
                                                            let _e1262 = phi_2324_;
                                                            let _e1264 = phi_2325_;
                                                            let _e1266 = phi_2326_;
                                                            let _e1273 = ((_e1264.y * _e1262.z) - (_e1262.y * _e1264.z));
                                                            let _e1278 = ((_e1264.z * _e1262.x) - (_e1262.z * _e1264.x));
                                                            let _e1281 = ((_e1264.x * _e1262.y) - (_e1262.x * _e1264.y));
                                                            let _e1284 = ((_e1077 >= _e1081) && (_e1077 >= _e1085));
                                                            let _e1285 = (_e1081 >= _e1085);
                                                            let _e1299 = (((_e1273 * (select(select(_e996, _e950, _e1285), _e890, _e1284) - _e466)) + (_e1278 * (select(select(_e1011, _e965, _e1285), _e912, _e1284) - _e531))) + (_e1281 * (select(select(_e1026, _e980, _e1285), _e934, _e1284) - _e595)));
                                                            let _e1304 = (((_e1273 * _e503) + (_e1278 * _e567)) + (_e1281 * _e631));
                                                            let _e1305 = (_e1254 - _e1258);
                                                            let _e1306 = (_e1252 - _e1256);
                                                            let _e1309 = ((_e1305 * _e1305) + (_e1306 * _e1306));
                                                            let _e1316 = (-(((_e1258 * _e1305) + (_e1256 * _e1306))) / select(0.000000000000000000000000000000000000011754944f, _e1309, (_e1309 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1318 = select(1f, _e1316, (_e1316 < 1f));
                                                            let _e1320 = select(0f, _e1318, (_e1318 > 0f));
                                                            let _e1329 = ((_e1260.x + (_e1266.x * _e1320)) - _e466);
                                                            let _e1332 = ((_e1260.y + (_e1266.y * _e1320)) - _e531);
                                                            let _e1335 = ((_e1260.z + (_e1266.z * _e1320)) - _e595);
                                                            let _e1338 = bitcast<f32>((bitcast<u32>(_e1329) & 2147483647u));
                                                            let _e1341 = bitcast<f32>((bitcast<u32>(_e1332) & 2147483647u));
                                                            let _e1343 = select(_e1341, _e1338, (_e1338 > _e1341));
                                                            let _e1346 = bitcast<f32>((bitcast<u32>(_e1335) & 2147483647u));
                                                            let _e1348 = select(_e1346, _e1343, (_e1343 > _e1346));
                                                            let _e1352 = abs(_e1273);
                                                            let _e1353 = abs(_e1278);
                                                            if (_e1352 != _e1352) {
                                                                phi_4097_ = true;
                                                            } else {
                                                                phi_4097_ = (_e1353 >= _e1352);
                                                            }
                                                            let _e1357 = phi_4097_;
                                                            let _e1358 = select(_e1352, _e1353, _e1357);
                                                            let _e1359 = abs(_e1281);
                                                            if (_e1358 != _e1358) {
                                                                phi_4112_ = true;
                                                            } else {
                                                                phi_4112_ = (_e1359 >= _e1358);
                                                            }
                                                            let _e1363 = phi_4112_;
                                                            let _e1379 = abs(_e1264.x);
                                                            let _e1380 = abs(_e1264.y);
                                                            if (_e1379 != _e1379) {
                                                                phi_4127_ = true;
                                                            } else {
                                                                phi_4127_ = (_e1380 >= _e1379);
                                                            }
                                                            let _e1384 = phi_4127_;
                                                            let _e1385 = select(_e1379, _e1380, _e1384);
                                                            let _e1386 = abs(_e1264.z);
                                                            if (_e1385 != _e1385) {
                                                                phi_4142_ = true;
                                                            } else {
                                                                phi_4142_ = (_e1386 >= _e1385);
                                                            }
                                                            let _e1390 = phi_4142_;
                                                            let _e1393 = abs(_e1262.x);
                                                            let _e1394 = abs(_e1262.y);
                                                            if (_e1393 != _e1393) {
                                                                phi_4157_ = true;
                                                            } else {
                                                                phi_4157_ = (_e1394 >= _e1393);
                                                            }
                                                            let _e1398 = phi_4157_;
                                                            let _e1399 = select(_e1393, _e1394, _e1398);
                                                            let _e1400 = abs(_e1262.z);
                                                            if (_e1399 != _e1399) {
                                                                phi_4172_ = true;
                                                            } else {
                                                                phi_4172_ = (_e1400 >= _e1399);
                                                            }
                                                            let _e1404 = phi_4172_;
                                                            let _e1409 = ((bitcast<f32>((bitcast<u32>(((((_e1273 * _e1329) + (_e1278 * _e1332)) + (_e1281 * _e1335)) - _e1299)) & 2147483647u)) <= ((0.0000009536743f * select(_e1239, _e1348, (_e1348 > _e1239))) * select(_e1358, _e1359, _e1363))) && !((bitcast<f32>((bitcast<u32>(_e1304) & 2147483647u)) <= ((0.0000038146973f * select(_e1385, _e1386, _e1390)) * select(_e1399, _e1400, _e1404)))));
                                                            let _e1410 = (_e1299 / _e1304);
                                                            if (_e1180 && !(_e1409)) {
                                                                let _e1413 = (_e1335 / _e631);
                                                                let _e1421 = (((_e1273 * (_e1329 - (_e503 * _e1413))) + (_e1278 * (_e1332 - (_e567 * _e1413)))) / _e1304);
                                                                phi_2534_ = select(select(_e1413, (_e1413 + _e1421), (bitcast<f32>((bitcast<u32>(_e1421) & 2147483647u)) <= _e1239)), _e1410, _e1409);
                                                            } else {
                                                                phi_2534_ = _e1410;
                                                            }
                                                            let _e1430 = phi_2534_;
                                                            let _e1432 = select(_e1143, _e1430, (_e1430 < _e1143));
                                                            let _e1434 = select(_e1135, _e1432, (_e1432 > _e1135));
                                                            let _e1435 = (1f / _e1087);
                                                            phi_2554_ = type_40(_e1434, (_e1081 * _e1435), (_e1085 * _e1435), ((_e1180 && (_e1434 >= _e737)) && (_e1434 <= _e826.member)));
                                                            phi_2555_ = type_40();
                                                        } else {
                                                            phi_2554_ = type_40();
                                                            phi_2555_ = type_40(0f, 0f, 0f, _e1180);
                                                        }
                                                        let _e1444 = phi_2554_;
                                                        let _e1446 = phi_2555_;
                                                        phi_2558_ = _e1444;
                                                        phi_2559_ = _e1446;
                                                        phi_2560_ = select(true, false, _e1180);
                                                    } else {
                                                        phi_2558_ = type_40();
                                                        phi_2559_ = type_40(0f, 0f, 0f, _e1071);
                                                        phi_2560_ = true;
                                                    }
                                                    let _e1449 = phi_2558_;
                                                    let _e1451 = phi_2559_;
                                                    let _e1453 = phi_2560_;
                                                    if _e1453 {
                                                        phi_2564_ = _e1451;
                                                    } else {
                                                        phi_2564_ = _e1449;
                                                    }
                                                    let _e1455 = phi_2564_;
                                                    if _e1455.member_3 {
                                                        phi_2573_ = type_22(_e1455.member, _e1455.member_1, _e1455.member_2, _e854);
                                                    } else {
                                                        phi_2573_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1462 = phi_2573_;
                                                    if (_e1462.member_3 != 4294967295u) {
                                                        if (_e854 == _e154) {
                                                            phi_2896_ = false;
                                                        } else {
                                                            let _e1466 = (_e854 < arrayLength((&global_5.member)));
                                                            if _e1466 {
                                                                if _e1466 {
                                                                } else {
                                                                    phi_4206_ = true;
                                                                    break;
                                                                }
                                                                let _e1468 = global_5.member[_e854];
                                                                phi_2596_ = _e1468;
                                                            } else {
                                                                phi_2596_ = 4294967295u;
                                                            }
                                                            let _e1470 = phi_2596_;
                                                            let _e1471 = (_e1470 < arrayLength((&global_6.member)));
                                                            if _e1471 {
                                                                if _e1471 {
                                                                } else {
                                                                    phi_4206_ = true;
                                                                    break;
                                                                }
                                                                let _e1473 = global_6.member[_e1470];
                                                                phi_2610_ = _e1473;
                                                            } else {
                                                                phi_2610_ = 0i;
                                                            }
                                                            let _e1475 = phi_2610_;
                                                            let _e1476 = (_e1475 == 0i);
                                                            if _e1476 {
                                                                phi_2895_ = true;
                                                            } else {
                                                                if _e443 {
                                                                    phi_2629_ = vec3<f32>(_e890, _e912, _e934);
                                                                } else {
                                                                    if (_e419 == 1u) {
                                                                        phi_2628_ = vec3<f32>(_e934, _e890, _e912);
                                                                    } else {
                                                                        phi_2628_ = vec3<f32>(_e912, _e934, _e890);
                                                                    }
                                                                    let _e1481 = phi_2628_;
                                                                    phi_2629_ = _e1481;
                                                                }
                                                                let _e1484 = phi_2629_;
                                                                if _e443 {
                                                                    phi_2644_ = vec3<f32>(_e950, _e965, _e980);
                                                                } else {
                                                                    if (_e419 == 1u) {
                                                                        phi_2643_ = vec3<f32>(_e980, _e950, _e965);
                                                                    } else {
                                                                        phi_2643_ = vec3<f32>(_e965, _e980, _e950);
                                                                    }
                                                                    let _e1489 = phi_2643_;
                                                                    phi_2644_ = _e1489;
                                                                }
                                                                let _e1492 = phi_2644_;
                                                                if _e443 {
                                                                    phi_2659_ = vec3<f32>(_e996, _e1011, _e1026);
                                                                } else {
                                                                    if (_e419 == 1u) {
                                                                        phi_2658_ = vec3<f32>(_e1026, _e996, _e1011);
                                                                    } else {
                                                                        phi_2658_ = vec3<f32>(_e1011, _e1026, _e996);
                                                                    }
                                                                    let _e1497 = phi_2658_;
                                                                    phi_2659_ = _e1497;
                                                                }
                                                                let _e1500 = phi_2659_;
                                                                let _e1503 = (_e1492.x - _e1484.x);
                                                                let _e1506 = (_e1492.y - _e1484.y);
                                                                let _e1509 = (_e1492.z - _e1484.z);
                                                                let _e1511 = (_e1500.x - _e1484.x);
                                                                let _e1513 = (_e1500.y - _e1484.y);
                                                                let _e1515 = (_e1500.z - _e1484.z);
                                                                if (_e286.member_1 == 1u) {
                                                                    phi_2695_ = (vec3<f32>(_e286.member[0], _e286.member[1], _e286.member[2]) - _e1484);
                                                                } else {
                                                                    phi_2695_ = vec3<f32>(_e286.member[0], _e286.member[1], _e286.member[2]);
                                                                }
                                                                let _e1530 = phi_2695_;
                                                                let _e1536 = bitcast<f32>((bitcast<u32>((_e1503 * _e1513)) ^ _e286.member_3[0]));
                                                                let _e1540 = bitcast<f32>((bitcast<u32>((_e1506 * _e1511)) ^ _e286.member_3[0]));
                                                                let _e1544 = bitcast<f32>((bitcast<u32>((_e1506 * _e1515)) ^ _e286.member_3[0]));
                                                                let _e1548 = bitcast<f32>((bitcast<u32>((_e1509 * _e1513)) ^ _e286.member_3[0]));
                                                                let _e1552 = bitcast<f32>((bitcast<u32>((_e1509 * _e1511)) ^ _e286.member_3[0]));
                                                                let _e1556 = bitcast<f32>((bitcast<u32>((_e1503 * _e1515)) ^ _e286.member_3[0]));
                                                                let _e1557 = (_e1544 - _e1548);
                                                                let _e1558 = (_e1552 - _e1556);
                                                                let _e1559 = (_e1536 - _e1540);
                                                                let _e1583 = (bitcast<f32>((bitcast<u32>(_e1544) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1548) & 2147483647u)));
                                                                let _e1590 = (bitcast<f32>((bitcast<u32>(_e1552) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1556) & 2147483647u)));
                                                                let _e1597 = (bitcast<f32>((bitcast<u32>(_e1536) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1540) & 2147483647u)));
                                                                if (_e286.member_2 == 0f) {
                                                                    phi_2877_ = 0f;
                                                                } else {
                                                                    let _e1627 = bitcast<f32>((bitcast<u32>(_e1557) & 2147483647u));
                                                                    let _e1630 = bitcast<f32>((bitcast<u32>(_e1558) & 2147483647u));
                                                                    let _e1633 = bitcast<f32>((bitcast<u32>(_e1559) & 2147483647u));
                                                                    let _e1635 = select(_e1633, _e1630, (_e1630 > _e1633));
                                                                    let _e1639 = select(_e1633, _e1630, (_e1630 < _e1633));
                                                                    let _e1643 = select(_e1630, _e1627, (_e1627 < _e1630));
                                                                    let _e1645 = select(_e1630, _e1627, (_e1627 > _e1630));
                                                                    let _e1647 = select(_e1633, _e1645, (_e1645 < _e1633));
                                                                    phi_2877_ = bitcast<f32>((bitcast<u32>((_e286.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1635, _e1627, (_e1627 > _e1635)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1647, _e1643, (_e1643 > _e1647)))) ^ _e286.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1639, _e1627, (_e1627 < _e1639)))) ^ _e286.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1583 + _e1590) + _e1597))) ^ _e286.member_3[0]))) * 1.0000005f)) ^ _e286.member_3[0])))) ^ _e286.member_3[0]));
                                                                }
                                                                let _e1674 = phi_2877_;
                                                                phi_2895_ = (_e1476 || !(((((bitcast<f32>((bitcast<u32>((_e1530.x * _e1557)) ^ _e286.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1530.y * _e1558)) ^ _e286.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1530.z * _e1559)) ^ _e286.member_3[0]))) * f32(-(_e1475))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1530.x) & 2147483647u)) * _e1583)) ^ _e286.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1530.y) & 2147483647u)) * _e1590)) ^ _e286.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1530.z) & 2147483647u)) * _e1597)) ^ _e286.member_3[0]))))) ^ _e286.member_3[0])) + _e1674) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1688 = phi_2895_;
                                                            phi_2896_ = _e1688;
                                                        }
                                                        let _e1690 = phi_2896_;
                                                        if _e1690 {
                                                            phi_2901_ = type_41(-340282350000000000000000000000000000000f, true);
                                                        } else {
                                                            phi_2901_ = _e826;
                                                        }
                                                        let _e1692 = phi_2901_;
                                                        phi_2902_ = _e1692;
                                                    } else {
                                                        phi_2902_ = _e826;
                                                    }
                                                    let _e1694 = phi_2902_;
                                                    phi_1446_ = _e1694;
                                                } else {
                                                    phi_1446_ = type_41();
                                                }
                                                let _e1696 = phi_1446_;
                                                continue;
                                                continuing {
                                                    phi_1445_ = _e1696;
                                                    phi_1448_ = _e841;
                                                    phi_4206_ = _e769;
                                                    break if !(_e847);
                                                }
                                            }
                                            let _e1699 = phi_4206_;
                                            phi_4421_ = _e1699;
                                            if _e1699 {
                                                break;
                                            }
                                            phi_4480_ = _e1699;
                                            let _e2248 = local_11;
                                            phi_2903_ = _e2248;
                                        } else {
                                            phi_4480_ = _e769;
                                            phi_2903_ = _e771;
                                        }
                                        let _e1701 = phi_4480_;
                                        let _e1703 = phi_2903_;
                                        if _e818 {
                                            phi_3910_ = bool();
                                            phi_3911_ = u32();
                                            phi_3912_ = type_63();
                                        } else {
                                            let _e1704 = (_e814.member_1 < _e94);
                                            if _e1704 {
                                                if _e1704 {
                                                } else {
                                                    phi_4421_ = true;
                                                    break;
                                                }
                                                let _e1706 = global_9.member[_e814.member_1];
                                                phi_2924_ = _e1706;
                                            } else {
                                                phi_2924_ = type_50(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e1708 = phi_2924_;
                                            let _e1723 = ((10u * _e419) & 31u);
                                            let _e1726 = ((_e1708.member[0] >> bitcast<u32>(_e1723)) & 1023u);
                                            let _e1734 = bitcast<f32>((bitcast<u32>(((_e814.member.member_1[0] - _e814.member.member[0]) * 0.0009775171f)) ^ _e137));
                                            let _e1739 = (_e814.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1726)) - 8388608f) * _e1734)) ^ _e137)));
                                            let _e1743 = select(select(_e814.member.member_1[0], _e1739, (_e1739 < _e814.member.member_1[0])), _e814.member.member_1[0], (_e1726 == 1023u));
                                            let _e1745 = ((10u * _e418) & 31u);
                                            let _e1748 = ((_e1708.member[0] >> bitcast<u32>(_e1745)) & 1023u);
                                            let _e1756 = bitcast<f32>((bitcast<u32>(((_e814.member.member_1[1] - _e814.member.member[1]) * 0.0009775171f)) ^ _e137));
                                            let _e1761 = (_e814.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1748)) - 8388608f) * _e1756)) ^ _e137)));
                                            let _e1765 = select(select(_e814.member.member_1[1], _e1761, (_e1761 < _e814.member.member_1[1])), _e814.member.member_1[1], (_e1748 == 1023u));
                                            let _e1767 = ((10u * _e420) & 31u);
                                            let _e1770 = ((_e1708.member[0] >> bitcast<u32>(_e1767)) & 1023u);
                                            let _e1778 = bitcast<f32>((bitcast<u32>(((_e814.member.member_1[2] - _e814.member.member[2]) * 0.0009775171f)) ^ _e137));
                                            let _e1783 = (_e814.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1770)) - 8388608f) * _e1778)) ^ _e137)));
                                            let _e1787 = select(select(_e814.member.member_1[2], _e1783, (_e1783 < _e814.member.member_1[2])), _e814.member.member_1[2], (_e1770 == 1023u));
                                            let _e1790 = ((_e1708.member[1] >> bitcast<u32>(_e1723)) & 1023u);
                                            let _e1798 = (_e814.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1790)) - 8388608f) * _e1734)) ^ _e137)));
                                            let _e1802 = select(select(_e814.member.member_1[0], _e1798, (_e1798 < _e814.member.member_1[0])), _e814.member.member_1[0], (_e1790 == 1023u));
                                            let _e1805 = ((_e1708.member[1] >> bitcast<u32>(_e1745)) & 1023u);
                                            let _e1813 = (_e814.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1805)) - 8388608f) * _e1756)) ^ _e137)));
                                            let _e1817 = select(select(_e814.member.member_1[1], _e1813, (_e1813 < _e814.member.member_1[1])), _e814.member.member_1[1], (_e1805 == 1023u));
                                            let _e1820 = ((_e1708.member[1] >> bitcast<u32>(_e1767)) & 1023u);
                                            let _e1828 = (_e814.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1820)) - 8388608f) * _e1778)) ^ _e137)));
                                            let _e1832 = select(select(_e814.member.member_1[2], _e1828, (_e1828 < _e814.member.member_1[2])), _e814.member.member_1[2], (_e1820 == 1023u));
                                            let _e1838 = ((_e1708.member_1[0] >> bitcast<u32>(_e1723)) & 1023u);
                                            let _e1846 = (_e814.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1838)) - 8388608f) * _e1734)) ^ _e137)));
                                            let _e1850 = select(select(_e814.member.member_1[0], _e1846, (_e1846 < _e814.member.member_1[0])), _e814.member.member_1[0], (_e1838 == 1023u));
                                            let _e1853 = ((_e1708.member_1[0] >> bitcast<u32>(_e1745)) & 1023u);
                                            let _e1861 = (_e814.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1853)) - 8388608f) * _e1756)) ^ _e137)));
                                            let _e1865 = select(select(_e814.member.member_1[1], _e1861, (_e1861 < _e814.member.member_1[1])), _e814.member.member_1[1], (_e1853 == 1023u));
                                            let _e1868 = ((_e1708.member_1[0] >> bitcast<u32>(_e1767)) & 1023u);
                                            let _e1876 = (_e814.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1868)) - 8388608f) * _e1778)) ^ _e137)));
                                            let _e1880 = select(select(_e814.member.member_1[2], _e1876, (_e1876 < _e814.member.member_1[2])), _e814.member.member_1[2], (_e1868 == 1023u));
                                            let _e1883 = ((_e1708.member_1[1] >> bitcast<u32>(_e1723)) & 1023u);
                                            let _e1891 = (_e814.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1883)) - 8388608f) * _e1734)) ^ _e137)));
                                            let _e1895 = select(select(_e814.member.member_1[0], _e1891, (_e1891 < _e814.member.member_1[0])), _e814.member.member_1[0], (_e1883 == 1023u));
                                            let _e1898 = ((_e1708.member_1[1] >> bitcast<u32>(_e1745)) & 1023u);
                                            let _e1906 = (_e814.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1898)) - 8388608f) * _e1756)) ^ _e137)));
                                            let _e1910 = select(select(_e814.member.member_1[1], _e1906, (_e1906 < _e814.member.member_1[1])), _e814.member.member_1[1], (_e1898 == 1023u));
                                            let _e1913 = ((_e1708.member_1[1] >> bitcast<u32>(_e1767)) & 1023u);
                                            let _e1921 = (_e814.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1913)) - 8388608f) * _e1778)) ^ _e137)));
                                            let _e1925 = select(select(_e814.member.member_1[2], _e1921, (_e1921 < _e814.member.member_1[2])), _e814.member.member_1[2], (_e1913 == 1023u));
                                            let _e1930 = type_63(type_55(array<f32, 3>(_e1743, _e1765, _e1787), array<f32, 3>(_e1802, _e1817, _e1832)), _e1708.member_2);
                                            let _e1935 = type_63(type_55(array<f32, 3>(_e1850, _e1865, _e1880), array<f32, 3>(_e1895, _e1910, _e1925)), _e1708.member_3);
                                            let _e1941 = ((_e1743 - _e504) * _e507);
                                            let _e1942 = ((_e1850 - _e504) * _e507);
                                            let _e1943 = ((_e1802 - _e505) * _e507);
                                            let _e1944 = ((_e1895 - _e505) * _e507);
                                            let _e1949 = ((_e1765 - _e568) * _e571);
                                            let _e1950 = ((_e1865 - _e568) * _e571);
                                            let _e1951 = ((_e1817 - _e569) * _e571);
                                            let _e1952 = ((_e1910 - _e569) * _e571);
                                            let _e1957 = ((_e1787 - _e632) * _e635);
                                            let _e1958 = ((_e1880 - _e632) * _e635);
                                            let _e1959 = ((_e1832 - _e633) * _e635);
                                            let _e1960 = ((_e1925 - _e633) * _e635);
                                            let _e1962 = select(_e1959, _e1957, (_e1957 < _e1959));
                                            let _e1964 = select(_e1960, _e1958, (_e1958 < _e1960));
                                            let _e1966 = select(_e1959, _e1957, (_e1957 > _e1959));
                                            let _e1968 = select(_e1960, _e1958, (_e1958 > _e1960));
                                            let _e1970 = select(_e1943, _e1941, (_e1941 < _e1943));
                                            let _e1972 = select(_e1944, _e1942, (_e1942 < _e1944));
                                            let _e1974 = select(_e1951, _e1949, (_e1949 < _e1951));
                                            let _e1976 = select(_e1952, _e1950, (_e1950 < _e1952));
                                            let _e1978 = select(_e1974, _e1970, (_e1970 > _e1974));
                                            let _e1980 = select(_e1976, _e1972, (_e1972 > _e1976));
                                            let _e1982 = select(_e1962, _e1978, (_e1978 > _e1962));
                                            let _e1984 = select(_e1964, _e1980, (_e1980 > _e1964));
                                            let _e1986 = select(_e1943, _e1941, (_e1941 > _e1943));
                                            let _e1988 = select(_e1944, _e1942, (_e1942 > _e1944));
                                            let _e1990 = select(_e1951, _e1949, (_e1949 > _e1951));
                                            let _e1992 = select(_e1952, _e1950, (_e1950 > _e1952));
                                            let _e1994 = select(_e1990, _e1986, (_e1986 < _e1990));
                                            let _e1996 = select(_e1992, _e1988, (_e1988 < _e1992));
                                            let _e2001 = -(_e1962);
                                            let _e2002 = -(_e1964);
                                            let _e2009 = (select(_e1966, _e1994, (_e1994 < _e1966)) + (select(_e2001, _e1966, (_e1966 > _e2001)) * 0.0000019073523f));
                                            let _e2010 = (select(_e1968, _e1996, (_e1996 < _e1968)) + (select(_e2002, _e1968, (_e1968 > _e2002)) * 0.0000019073523f));
                                            let _e2012 = select(_e737, _e1982, (_e1982 > _e737));
                                            let _e2014 = select(_e737, _e1984, (_e1984 > _e737));
                                            let _e2019 = (_e2012 <= select(_e1703.member, _e2009, (_e2009 < _e1703.member)));
                                            let _e2020 = (_e2014 <= select(_e1703.member, _e2010, (_e2010 < _e1703.member)));
                                            let _e2021 = (_e2012 <= _e2014);
                                            if _e2019 {
                                                if _e2020 {
                                                    if _e2021 {
                                                        phi_3810_ = _e1935;
                                                    } else {
                                                        phi_3810_ = _e1930;
                                                    }
                                                    let _e2023 = phi_3810_;
                                                    let _e2030 = (_e812 % 128u);
                                                    let _e2031 = (_e2030 < 128u);
                                                    if _e2031 {
                                                    } else {
                                                        phi_4421_ = true;
                                                        break;
                                                    }
                                                    local_6[_e2030] = _e2023.member_1;
                                                    if _e2031 {
                                                    } else {
                                                        phi_4421_ = true;
                                                        break;
                                                    }
                                                    local_5[_e2030] = _e2023.member.member[0];
                                                    if _e2031 {
                                                    } else {
                                                        phi_4421_ = true;
                                                        break;
                                                    }
                                                    local_4[_e2030] = _e2023.member.member[1];
                                                    if _e2031 {
                                                    } else {
                                                        phi_4421_ = true;
                                                        break;
                                                    }
                                                    local_3[_e2030] = _e2023.member.member[2];
                                                    if _e2031 {
                                                    } else {
                                                        phi_4421_ = true;
                                                        break;
                                                    }
                                                    local_2[_e2030] = _e2023.member.member_1[0];
                                                    if _e2031 {
                                                    } else {
                                                        phi_4421_ = true;
                                                        break;
                                                    }
                                                    local_1[_e2030] = _e2023.member.member_1[1];
                                                    if _e2031 {
                                                    } else {
                                                        phi_4421_ = true;
                                                        break;
                                                    }
                                                    local[_e2030] = _e2023.member.member_1[2];
                                                    if _e2031 {
                                                    } else {
                                                        phi_4421_ = true;
                                                        break;
                                                    }
                                                    local_7[_e2030] = select(_e2012, _e2014, _e2021);
                                                    if _e2021 {
                                                        phi_3886_ = _e1930;
                                                    } else {
                                                        phi_3886_ = _e1935;
                                                    }
                                                    let _e2048 = phi_3886_;
                                                    phi_3887_ = (_e812 + 1u);
                                                    phi_3888_ = _e2048;
                                                } else {
                                                    phi_3887_ = u32();
                                                    phi_3888_ = type_63();
                                                }
                                                let _e2050 = phi_3887_;
                                                let _e2052 = phi_3888_;
                                                phi_3890_ = _e2050;
                                                phi_3891_ = _e2052;
                                                phi_3892_ = select(true, false, _e2020);
                                            } else {
                                                phi_3890_ = u32();
                                                phi_3891_ = type_63();
                                                phi_3892_ = true;
                                            }
                                            let _e2055 = phi_3890_;
                                            let _e2057 = phi_3891_;
                                            let _e2059 = phi_3892_;
                                            if _e2059 {
                                                if _e2019 {
                                                    phi_3899_ = _e1930;
                                                } else {
                                                    phi_3899_ = _e1935;
                                                }
                                                let _e2061 = phi_3899_;
                                                phi_3904_ = select(_e2020, true, _e2019);
                                                phi_3906_ = _e2061;
                                            } else {
                                                phi_3904_ = _e810;
                                                phi_3906_ = _e2057;
                                            }
                                            let _e2064 = phi_3904_;
                                            let _e2066 = phi_3906_;
                                            phi_3910_ = _e2064;
                                            phi_3911_ = select(_e2055, _e812, _e2059);
                                            phi_3912_ = _e2066;
                                        }
                                        let _e2069 = phi_3910_;
                                        let _e2071 = phi_3911_;
                                        let _e2073 = phi_3912_;
                                        if _e818 {
                                            phi_3922_ = select(_e812, 0u, _e1703.member_1);
                                            phi_3923_ = _e814;
                                        } else {
                                            phi_3922_ = _e2071;
                                            phi_3923_ = _e2073;
                                        }
                                        let _e2077 = phi_3922_;
                                        let _e2079 = phi_3923_;
                                        phi_4424_ = _e1701;
                                        phi_3924_ = _e1703;
                                        phi_3925_ = (_e773 - 1u);
                                        phi_3926_ = select(_e2069, false, _e818);
                                        phi_3927_ = _e2077;
                                        phi_3928_ = _e2079;
                                    } else {
                                        phi_4424_ = _e769;
                                        phi_3924_ = _e771;
                                        phi_3925_ = _e773;
                                        phi_3926_ = _e810;
                                        phi_3927_ = _e812;
                                        phi_3928_ = _e814;
                                    }
                                    let _e2082 = phi_4424_;
                                    let _e2084 = phi_3924_;
                                    let _e2086 = phi_3925_;
                                    let _e2088 = phi_3926_;
                                    let _e2090 = phi_3927_;
                                    let _e2092 = phi_3928_;
                                    phi_4423_ = _e2082;
                                    phi_3929_ = _e2084;
                                    phi_3930_ = _e2086;
                                    phi_3931_ = _e2088;
                                    phi_3932_ = _e2090;
                                    phi_3933_ = _e2092;
                                } else {
                                    phi_4423_ = _e769;
                                    phi_3929_ = type_41();
                                    phi_3930_ = u32();
                                    phi_3931_ = bool();
                                    phi_3932_ = u32();
                                    phi_3933_ = type_63();
                                }
                                let _e2094 = phi_4423_;
                                let _e2096 = phi_3929_;
                                let _e2098 = phi_3930_;
                                let _e2100 = phi_3931_;
                                let _e2102 = phi_3932_;
                                let _e2104 = phi_3933_;
                                phi_4422_ = _e2094;
                                phi_1319_ = _e2096;
                                phi_1322_ = _e2098;
                                phi_1324_ = _e2100;
                                phi_1326_ = _e2102;
                                phi_1328_ = _e2104;
                                phi_3934_ = _e783;
                            } else {
                                phi_4422_ = _e769;
                                phi_1319_ = type_41();
                                phi_1322_ = u32();
                                phi_1324_ = bool();
                                phi_1326_ = u32();
                                phi_1328_ = type_63();
                                phi_3934_ = false;
                            }
                            let _e2106 = phi_4422_;
                            let _e2108 = phi_1319_;
                            let _e2110 = phi_1322_;
                            let _e2112 = phi_1324_;
                            let _e2114 = phi_1326_;
                            let _e2116 = phi_1328_;
                            let _e2118 = phi_3934_;
                            continue;
                            continuing {
                                phi_4212_ = _e2106;
                                phi_1318_ = _e2108;
                                phi_1321_ = _e2110;
                                phi_1323_ = _e2112;
                                phi_1325_ = _e2114;
                                phi_1327_ = _e2116;
                                phi_4421_ = _e2106;
                                break if !(_e2118);
                            }
                        }
                        let _e2121 = phi_4421_;
                        if _e2121 {
                            break;
                        }
                        let _e2123 = local_10;
                        if _e2123.member_1 {
                        } else {
                            if _e287 {
                            } else {
                                break;
                            }
                            let _e2127 = global_2.member[_e141];
                            if _e148 {
                            } else {
                                break;
                            }
                            let _e2131 = global_8.member[_e141].member_1;
                            if _e287 {
                            } else {
                                break;
                            }
                            global_2.member[_e141] = type_24(_e2127.member, _e2127.member_1, _e2127.member_2, array<f32, 3>((_e2127.member_3[0] + (_e2131[0] * _e2127.member_1[0])), (_e2127.member_3[1] + (_e2131[1] * _e2127.member_1[1])), (_e2127.member_3[2] + (_e2131[2] * _e2127.member_1[2]))), _e2127.member_4);
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
