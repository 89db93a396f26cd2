struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_23 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_40 {
    member: type_23,
    member_1: f32,
}

struct type_44 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_45 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_47 {
    member: array<type_27>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<storage> global_2: type_33;
@group(0) @binding(2) 
var<storage> global_3: type_15;
@group(0) @binding(3) 
var<storage> global_4: type_47;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_25;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_391_: i32;
    var phi_392_: i32;
    var phi_402_: bool;
    var phi_412_: u32;
    var phi_413_: u32;
    var phi_415_: bool;
    var phi_420_: u32;
    var phi_433_: i32;
    var phi_453_: i32;
    var phi_471_: f32;
    var phi_477_: f32;
    var phi_517_: f32;
    var phi_523_: f32;
    var phi_596_: f32;
    var phi_602_: f32;
    var phi_642_: f32;
    var phi_648_: f32;
    var phi_721_: f32;
    var phi_727_: f32;
    var phi_767_: f32;
    var phi_773_: f32;
    var phi_892_: i32;
    var phi_914_: u32;
    var phi_915_: u32;
    var phi_952_: i32;
    var phi_974_: u32;
    var phi_975_: u32;
    var phi_983_: f32;
    var phi_984_: f32;
    var phi_2820_: bool;
    var phi_999_: type_40;
    var phi_1002_: bool;
    var phi_1004_: u32;
    var phi_1006_: u32;
    var phi_1008_: u32;
    var phi_1019_: bool;
    var phi_1051_: bool;
    var phi_1052_: u32;
    var phi_1053_: u32;
    var phi_2073_: type_45;
    var phi_2435_: u32;
    var phi_2462_: u32;
    var phi_2463_: u32;
    var phi_2464_: u32;
    var phi_2466_: u32;
    var phi_2467_: u32;
    var phi_2468_: bool;
    var phi_2477_: u32;
    var phi_2482_: bool;
    var phi_2483_: u32;
    var phi_1068_: type_40;
    var phi_1071_: type_4;
    var phi_1072_: type_4;
    var phi_1094_: type_4;
    var phi_1115_: u32;
    var phi_1207_: array<array<f32, 3>, 3>;
    var phi_1737_: f32;
    var phi_1738_: f32;
    var phi_1739_: f32;
    var phi_1740_: f32;
    var phi_1741_: vec3<f32>;
    var phi_1742_: vec3<f32>;
    var phi_1743_: vec3<f32>;
    var phi_1744_: vec3<f32>;
    var phi_1935_: f32;
    var phi_1955_: type_44;
    var phi_1956_: type_44;
    var phi_1959_: type_44;
    var phi_1960_: type_44;
    var phi_1961_: bool;
    var phi_1965_: type_44;
    var phi_1974_: type_23;
    var phi_1999_: bool;
    var phi_2000_: bool;
    var phi_2006_: type_40;
    var phi_2007_: type_40;
    var phi_2008_: type_40;
    var phi_1069_: type_40;
    var phi_2814_: bool;
    var local_2: type_40;
    var phi_2971_: bool;
    var phi_2485_: type_40;
    var phi_2486_: bool;
    var phi_2487_: u32;
    var phi_2488_: u32;
    var phi_2970_: bool;
    var phi_2489_: type_40;
    var phi_2490_: bool;
    var phi_2491_: u32;
    var phi_2492_: u32;
    var phi_2493_: u32;
    var phi_2969_: bool;
    var phi_2494_: type_40;
    var phi_2495_: bool;
    var phi_2496_: u32;
    var phi_2497_: u32;
    var phi_2498_: u32;
    var phi_2968_: bool;
    var phi_1000_: type_40;
    var phi_1003_: bool;
    var phi_1005_: u32;
    var phi_1007_: u32;
    var phi_1009_: u32;
    var phi_2499_: bool;
    var phi_2967_: bool;
    var local_3: type_40;
    var phi_2537_: f32;
    var phi_2539_: f32;
    var phi_2540_: bool;
    var phi_2541_: f32;
    var phi_2542_: bool;
    var phi_2759_: u32;
    var phi_2777_: bool;
    var phi_2780_: bool;
    var phi_2793_: f32;
    var phi_2794_: f32;
    var phi_2799_: f32;
    var phi_2800_: f32;
    var phi_2801_: bool;
    var phi_2809_: f32;
    var phi_2557_: f32;
    var phi_2558_: f32;
    var phi_2570_: f32;
    var phi_2575_: type_23;
    var local_4: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e73 = global;
            let _e75 = arrayLength((&global_2.member));
            let _e77 = arrayLength((&global_3.member));
            let _e85 = (_e73.x + (_e73.y * 2097152u));
            let _e88 = global_1.member[0u];
            let _e89 = bitcast<i32>(_e88);
            let _e90 = (_e85 < arrayLength((&global_4.member)));
            if _e90 {
                let _e91 = (_e85 < arrayLength((&global_5.member)));
                if _e91 {
                    if _e90 {
                    } else {
                        break;
                    }
                    let _e99 = global_4.member[_e85].member_2[0u];
                    let _e101 = (bitcast<u32>(_e99) & 2147483647u);
                    let _e106 = global_4.member[_e85].member_2[1u];
                    let _e108 = (bitcast<u32>(_e106) & 2147483647u);
                    let _e113 = global_4.member[_e85].member_2[2u];
                    let _e115 = (bitcast<u32>(_e113) & 2147483647u);
                    let _e120 = global_4.member[_e85].member[0u];
                    let _e122 = (bitcast<u32>(_e120) & 2147483647u);
                    let _e127 = global_4.member[_e85].member[1u];
                    let _e129 = (bitcast<u32>(_e127) & 2147483647u);
                    let _e134 = global_4.member[_e85].member[2u];
                    let _e136 = (bitcast<u32>(_e134) & 2147483647u);
                    let _e138 = select(_e108, _e101, (_e108 < _e101));
                    let _e140 = select(_e115, _e138, (_e115 < _e138));
                    let _e142 = select(_e122, _e140, (_e122 < _e140));
                    let _e144 = select(_e129, _e142, (_e129 < _e142));
                    let _e146 = select(_e136, _e144, (_e136 < _e144));
                    let _e150 = global_4.member[_e85].member_1;
                    let _e151 = bitcast<u32>(_e150);
                    let _e152 = (_e151 & 2147483647u);
                    let _e159 = global_4.member[_e85].member_3;
                    let _e160 = bitcast<u32>(_e159);
                    let _e161 = (_e160 & 2147483647u);
                    let _e165 = (((select(_e152, _e146, (_e152 < _e146)) < 2139095040u) && (_e161 <= 2139095040u)) && (_e140 > 0u));
                    if _e165 {
                        let _e168 = (bitcast<u32>(bitcast<f32>(_e140)) & 2147483647u);
                        if (_e168 >= 8388608u) {
                            phi_391_ = (bitcast<i32>((_e168 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_391_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e168)), 32u, (_e168 == 0u))));
                        }
                        let _e182 = phi_391_;
                        phi_392_ = _e182;
                    } else {
                        phi_392_ = 0i;
                    }
                    let _e184 = phi_392_;
                    let _e185 = (_e101 == _e140);
                    if _e185 {
                        phi_402_ = true;
                    } else {
                        phi_402_ = (_e108 == _e140);
                    }
                    let _e188 = phi_402_;
                    let _e189 = select(1u, 0u, _e185);
                    if _e188 {
                        let _e190 = (_e189 + 1u);
                        phi_412_ = _e190;
                        phi_413_ = _e190;
                        phi_415_ = select(true, false, (_e190 == 2u));
                    } else {
                        phi_412_ = u32();
                        phi_413_ = 0u;
                        phi_415_ = true;
                    }
                    let _e194 = phi_412_;
                    let _e196 = phi_413_;
                    let _e198 = phi_415_;
                    if _e198 {
                        phi_420_ = (_e196 + 1u);
                    } else {
                        phi_420_ = 0u;
                    }
                    let _e202 = phi_420_;
                    let _e203 = select(_e194, _e196, _e198);
                    let _e204 = select(_e189, select(2u, _e189, _e188), _e198);
                    if (_e89 < -126i) {
                        phi_433_ = -126i;
                    } else {
                        phi_433_ = select(_e89, 127i, (_e89 > 127i));
                    }
                    let _e209 = phi_433_;
                    let _e214 = bitcast<f32>((bitcast<u32>((_e209 + 127i)) << bitcast<u32>(23i)));
                    let _e220 = bitcast<f32>((bitcast<u32>(((_e89 - _e209) + 127i)) << bitcast<u32>(23i)));
                    let _e221 = -(_e184);
                    if (_e221 < -126i) {
                        phi_453_ = -126i;
                    } else {
                        phi_453_ = select(_e221, 127i, (_e221 > 127i));
                    }
                    let _e226 = phi_453_;
                    let _e231 = bitcast<f32>((bitcast<u32>((_e226 + 127i)) << bitcast<u32>(23i)));
                    let _e237 = bitcast<f32>((bitcast<u32>(((_e221 - _e226) + 127i)) << bitcast<u32>(23i)));
                    let _e241 = global_4.member[_e85].member;
                    let _e242 = (_e203 == 0u);
                    if _e242 {
                        phi_471_ = _e241[0];
                    } else {
                        phi_471_ = _e241[1];
                    }
                    let _e246 = phi_471_;
                    let _e247 = (_e203 == 2u);
                    if _e247 {
                        phi_477_ = _e241[2];
                    } else {
                        phi_477_ = _e246;
                    }
                    let _e250 = phi_477_;
                    let _e251 = bitcast<u32>(_e250);
                    let _e253 = ((_e251 & 2139095040u) != 0u);
                    let _e267 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e251 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e251 & 2147483648u))), _e250, _e253) * _e214) * select(0.00000011920929f, 1f, _e253)) * _e220);
                    let _e268 = global_4.member[_e85].member_2;
                    if _e242 {
                        phi_517_ = _e268[0];
                    } else {
                        phi_517_ = _e268[1];
                    }
                    let _e272 = phi_517_;
                    if _e247 {
                        phi_523_ = _e268[2];
                    } else {
                        phi_523_ = _e272;
                    }
                    let _e275 = phi_523_;
                    let _e276 = bitcast<u32>(_e275);
                    let _e278 = ((_e276 & 2139095040u) != 0u);
                    let _e292 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e276 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e276 & 2147483648u))), _e275, _e278) * _e231) * select(0.00000011920929f, 1f, _e278)) * _e237);
                    let _e296 = (bitcast<f32>((bitcast<u32>(_e292) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e299 = bitcast<f32>((bitcast<u32>(_e267) & 2147483647u));
                    let _e300 = (_e299 * 0.00000011920929f);
                    let _e303 = select(select(0.00000000000011368684f, _e300, (_e300 > 0.00000000000011368684f)), 0f, _e296);
                    let _e304 = select(0f, _e292, _e296);
                    let _e305 = (_e267 + _e303);
                    let _e306 = (_e267 - _e303);
                    let _e308 = select(38685626000000000000000000f, (1f / _e292), _e296);
                    let _e309 = (_e202 == 0u);
                    if _e309 {
                        phi_596_ = _e241[0];
                    } else {
                        phi_596_ = _e241[1];
                    }
                    let _e313 = phi_596_;
                    let _e314 = (_e202 == 2u);
                    if _e314 {
                        phi_602_ = _e241[2];
                    } else {
                        phi_602_ = _e313;
                    }
                    let _e317 = phi_602_;
                    let _e318 = bitcast<u32>(_e317);
                    let _e320 = ((_e318 & 2139095040u) != 0u);
                    let _e334 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e317, _e320) * _e214) * select(0.00000011920929f, 1f, _e320)) * _e220);
                    if _e309 {
                        phi_642_ = _e268[0];
                    } else {
                        phi_642_ = _e268[1];
                    }
                    let _e338 = phi_642_;
                    if _e314 {
                        phi_648_ = _e268[2];
                    } else {
                        phi_648_ = _e338;
                    }
                    let _e341 = phi_648_;
                    let _e342 = bitcast<u32>(_e341);
                    let _e344 = ((_e342 & 2139095040u) != 0u);
                    let _e358 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e342 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e342 & 2147483648u))), _e341, _e344) * _e231) * select(0.00000011920929f, 1f, _e344)) * _e237);
                    let _e362 = (bitcast<f32>((bitcast<u32>(_e358) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e365 = bitcast<f32>((bitcast<u32>(_e334) & 2147483647u));
                    let _e366 = (_e365 * 0.00000011920929f);
                    let _e369 = select(select(0.00000000000011368684f, _e366, (_e366 > 0.00000000000011368684f)), 0f, _e362);
                    let _e370 = select(0f, _e358, _e362);
                    let _e371 = (_e334 + _e369);
                    let _e372 = (_e334 - _e369);
                    let _e374 = select(38685626000000000000000000f, (1f / _e358), _e362);
                    let _e375 = (_e204 == 0u);
                    if _e375 {
                        phi_721_ = _e241[0];
                    } else {
                        phi_721_ = _e241[1];
                    }
                    let _e379 = phi_721_;
                    let _e380 = (_e204 == 2u);
                    if _e380 {
                        phi_727_ = _e241[2];
                    } else {
                        phi_727_ = _e379;
                    }
                    let _e383 = phi_727_;
                    let _e384 = bitcast<u32>(_e383);
                    let _e386 = ((_e384 & 2139095040u) != 0u);
                    let _e400 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e383, _e386) * _e214) * select(0.00000011920929f, 1f, _e386)) * _e220);
                    if _e375 {
                        phi_767_ = _e268[0];
                    } else {
                        phi_767_ = _e268[1];
                    }
                    let _e404 = phi_767_;
                    if _e380 {
                        phi_773_ = _e268[2];
                    } else {
                        phi_773_ = _e404;
                    }
                    let _e407 = phi_773_;
                    let _e408 = bitcast<u32>(_e407);
                    let _e410 = ((_e408 & 2139095040u) != 0u);
                    let _e424 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e408 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e408 & 2147483648u))), _e407, _e410) * _e231) * select(0.00000011920929f, 1f, _e410)) * _e237);
                    let _e428 = (bitcast<f32>((bitcast<u32>(_e424) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e431 = bitcast<f32>((bitcast<u32>(_e400) & 2147483647u));
                    let _e432 = (_e431 * 0.00000011920929f);
                    let _e435 = select(select(0.00000000000011368684f, _e432, (_e432 > 0.00000000000011368684f)), 0f, _e428);
                    let _e436 = select(0f, _e424, _e428);
                    let _e437 = (_e400 + _e435);
                    let _e438 = (_e400 - _e435);
                    let _e440 = select(38685626000000000000000000f, (1f / _e424), _e428);
                    let _e442 = select(_e365, _e299, (_e299 > _e365));
                    let _e445 = (_e89 + _e184);
                    if (_e165 && (select(_e431, _e442, (_e442 > _e431)) <= 1099511600000f)) {
                        let _e455 = ((_e152 & 8388607u) | (select(0u, 1u, ((_e152 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e458 = bitcast<i32>((_e152 >> bitcast<u32>(23i)));
                        let _e462 = (_e455 == 0u);
                        let _e465 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e455)), 32u, _e462)) - 8i);
                        if (_e458 == 255i) {
                            phi_892_ = 255i;
                        } else {
                            phi_892_ = (((_e458 + select(0i, 1i, (_e458 == 0i))) - _e465) + _e445);
                        }
                        let _e473 = phi_892_;
                        let _e483 = (_e473 <= 0i);
                        if _e483 {
                            phi_915_ = u32();
                        } else {
                            if _e462 {
                                phi_914_ = u32();
                            } else {
                                phi_914_ = select(((bitcast<u32>(_e473) << bitcast<u32>(23i)) | ((_e455 << bitcast<u32>(((_e465 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e473 >= 255i));
                            }
                            let _e487 = phi_914_;
                            phi_915_ = _e487;
                        }
                        let _e489 = phi_915_;
                        let _e501 = ((_e161 & 8388607u) | (select(0u, 1u, ((_e161 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e504 = bitcast<i32>((_e161 >> bitcast<u32>(23i)));
                        let _e508 = (_e501 == 0u);
                        let _e511 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e501)), 32u, _e508)) - 8i);
                        if (_e504 == 255i) {
                            phi_952_ = 255i;
                        } else {
                            phi_952_ = (((_e504 + select(0i, 1i, (_e504 == 0i))) - _e511) + _e445);
                        }
                        let _e519 = phi_952_;
                        let _e529 = (_e519 <= 0i);
                        if _e529 {
                            phi_975_ = u32();
                        } else {
                            if _e508 {
                                phi_974_ = u32();
                            } else {
                                phi_974_ = select(((bitcast<u32>(_e519) << bitcast<u32>(23i)) | ((_e501 << bitcast<u32>(((_e511 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e519 >= 255i));
                            }
                            let _e533 = phi_974_;
                            phi_975_ = _e533;
                        }
                        let _e535 = phi_975_;
                        phi_983_ = bitcast<f32>(((_e160 & 2147483648u) | select(_e535, 0u, select(_e508, true, _e529))));
                        phi_984_ = bitcast<f32>(((_e151 & 2147483648u) | select(_e489, 0u, select(_e462, true, _e483))));
                    } else {
                        phi_983_ = 0f;
                        phi_984_ = 1f;
                    }
                    let _e541 = phi_983_;
                    let _e543 = phi_984_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2820_ = false;
                    phi_999_ = type_40(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e541);
                    phi_1002_ = (_e543 <= _e541);
                    phi_1004_ = select(0u, 2147483648u, (_e75 == 0u));
                    phi_1006_ = 0u;
                    phi_1008_ = ((3u * _e75) + 1u);
                    loop {
                        let _e551 = phi_2820_;
                        let _e553 = phi_999_;
                        let _e555 = phi_1002_;
                        let _e557 = phi_1004_;
                        let _e559 = phi_1006_;
                        let _e561 = phi_1008_;
                        local_3 = _e553;
                        if _e555 {
                            phi_1019_ = true;
                        } else {
                            phi_1019_ = (_e559 > 0u);
                        }
                        let _e564 = phi_1019_;
                        if _e564 {
                            let _e565 = (_e561 > 0u);
                            if _e565 {
                                if _e555 {
                                    phi_1051_ = _e555;
                                    phi_1052_ = _e557;
                                    phi_1053_ = _e559;
                                } else {
                                    let _e566 = (_e559 - 1u);
                                    let _e567 = (_e566 % 128u);
                                    let _e568 = (_e567 < 128u);
                                    if _e568 {
                                    } else {
                                        phi_2967_ = true;
                                        break;
                                    }
                                    let _e570 = local_1[_e567];
                                    if _e568 {
                                    } else {
                                        phi_2967_ = true;
                                        break;
                                    }
                                    let _e572 = local[_e567];
                                    phi_1051_ = (_e572 <= _e553.member_1);
                                    phi_1052_ = _e570;
                                    phi_1053_ = _e566;
                                }
                                let _e576 = phi_1051_;
                                let _e578 = phi_1052_;
                                let _e580 = phi_1053_;
                                if _e576 {
                                    if ((_e578 & 2147483648u) != 0u) {
                                        phi_1068_ = _e553;
                                        phi_1071_ = type_4(0u, ((_e578 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e777 = phi_1068_;
                                            let _e779 = phi_1071_;
                                            local_2 = _e777;
                                            local_4 = _e777;
                                            if (_e779.member < _e779.member_1) {
                                                phi_1072_ = type_4((_e779.member + 1u), _e779.member_1);
                                                phi_1094_ = type_4(1u, _e779.member);
                                            } else {
                                                phi_1072_ = _e779;
                                                phi_1094_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e792 = phi_1072_;
                                            let _e794 = phi_1094_;
                                            let _e798 = (bitcast<i32>(_e794.member) != 0i);
                                            if _e798 {
                                                let _e799 = ((_e578 & 268435455u) + _e794.member_1);
                                                let _e800 = (_e799 < _e77);
                                                if _e800 {
                                                    if _e800 {
                                                    } else {
                                                        phi_2814_ = true;
                                                        break;
                                                    }
                                                    let _e804 = global_3.member[_e799].member_1;
                                                    phi_1115_ = _e804;
                                                } else {
                                                    phi_1115_ = 4294967295u;
                                                }
                                                let _e806 = phi_1115_;
                                                if (_e799 >= _e77) {
                                                    phi_1207_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e800 {
                                                    } else {
                                                        phi_2814_ = true;
                                                        break;
                                                    }
                                                    let _e808 = (_e203 % 3u);
                                                    let _e809 = (_e202 % 3u);
                                                    let _e810 = (_e204 % 3u);
                                                    if (_e808 < 9u) {
                                                    } else {
                                                        phi_2814_ = true;
                                                        break;
                                                    }
                                                    let _e816 = global_3.member[_e799].member[_e808];
                                                    if (_e809 < 9u) {
                                                    } else {
                                                        phi_2814_ = true;
                                                        break;
                                                    }
                                                    let _e822 = global_3.member[_e799].member[_e809];
                                                    if (_e810 < 9u) {
                                                    } else {
                                                        phi_2814_ = true;
                                                        break;
                                                    }
                                                    let _e828 = global_3.member[_e799].member[_e810];
                                                    let _e830 = (3u + _e808);
                                                    if (_e830 < 9u) {
                                                    } else {
                                                        phi_2814_ = true;
                                                        break;
                                                    }
                                                    let _e836 = global_3.member[_e799].member[_e830];
                                                    let _e837 = (3u + _e809);
                                                    if (_e837 < 9u) {
                                                    } else {
                                                        phi_2814_ = true;
                                                        break;
                                                    }
                                                    let _e843 = global_3.member[_e799].member[_e837];
                                                    let _e844 = (3u + _e810);
                                                    if (_e844 < 9u) {
                                                    } else {
                                                        phi_2814_ = true;
                                                        break;
                                                    }
                                                    let _e850 = global_3.member[_e799].member[_e844];
                                                    let _e852 = (6u + _e808);
                                                    if (_e852 < 9u) {
                                                    } else {
                                                        phi_2814_ = true;
                                                        break;
                                                    }
                                                    let _e858 = global_3.member[_e799].member[_e852];
                                                    let _e859 = (6u + _e809);
                                                    if (_e859 < 9u) {
                                                    } else {
                                                        phi_2814_ = true;
                                                        break;
                                                    }
                                                    let _e865 = global_3.member[_e799].member[_e859];
                                                    let _e866 = (6u + _e810);
                                                    if (_e866 < 9u) {
                                                    } else {
                                                        phi_2814_ = true;
                                                        break;
                                                    }
                                                    let _e872 = global_3.member[_e799].member[_e866];
                                                    phi_1207_ = array<array<f32, 3>, 3>(array<f32, 3>(_e816, _e822, _e828), array<f32, 3>(_e836, _e843, _e850), array<f32, 3>(_e858, _e865, _e872));
                                                }
                                                let _e876 = phi_1207_;
                                                let _e892 = (_e876[0][2] - _e400);
                                                let _e895 = (((_e876[0][0] - _e267) * _e436) - (_e892 * _e304));
                                                let _e898 = (((_e876[0][1] - _e334) * _e436) - (_e892 * _e370));
                                                let _e901 = (_e876[1][2] - _e400);
                                                let _e904 = (((_e876[1][0] - _e267) * _e436) - (_e901 * _e304));
                                                let _e907 = (((_e876[1][1] - _e334) * _e436) - (_e901 * _e370));
                                                let _e910 = (_e876[2][2] - _e400);
                                                let _e913 = (((_e876[2][0] - _e267) * _e436) - (_e910 * _e304));
                                                let _e916 = (((_e876[2][1] - _e334) * _e436) - (_e910 * _e370));
                                                let _e917 = (_e913 * _e907);
                                                let _e918 = (_e916 * _e904);
                                                let _e919 = (_e895 * _e916);
                                                let _e920 = (_e898 * _e913);
                                                let _e921 = (_e904 * _e898);
                                                let _e922 = (_e907 * _e895);
                                                let _e927 = (((_e917 >= _e918) && (_e919 >= _e920)) && (_e921 >= _e922));
                                                let _e933 = (_e927 || (((_e917 <= _e918) && (_e919 <= _e920)) && (_e921 <= _e922)));
                                                if _e933 {
                                                    let _e935 = select(-1f, 1f, _e927);
                                                    let _e937 = ((_e917 - _e918) * _e935);
                                                    let _e939 = select(0f, _e937, (_e937 > 0f));
                                                    let _e941 = ((_e919 - _e920) * _e935);
                                                    let _e943 = select(0f, _e941, (_e941 > 0f));
                                                    let _e945 = ((_e921 - _e922) * _e935);
                                                    let _e947 = select(0f, _e945, (_e945 > 0f));
                                                    let _e949 = ((_e939 + _e943) + _e947);
                                                    let _e951 = select(_e876[1][0], _e876[0][0], (_e876[0][0] < _e876[1][0]));
                                                    let _e955 = select(_e876[1][0], _e876[0][0], (_e876[0][0] > _e876[1][0]));
                                                    let _e959 = select(_e876[1][1], _e876[0][1], (_e876[0][1] < _e876[1][1]));
                                                    let _e963 = select(_e876[1][1], _e876[0][1], (_e876[0][1] > _e876[1][1]));
                                                    let _e967 = select(_e876[1][2], _e876[0][2], (_e876[0][2] < _e876[1][2]));
                                                    let _e971 = select(_e876[1][2], _e876[0][2], (_e876[0][2] > _e876[1][2]));
                                                    let _e976 = ((select(_e876[2][0], _e951, (_e951 < _e876[2][0])) - _e305) * _e308);
                                                    let _e977 = ((select(_e876[2][0], _e955, (_e955 > _e876[2][0])) - _e306) * _e308);
                                                    let _e980 = ((select(_e876[2][1], _e959, (_e959 < _e876[2][1])) - _e371) * _e374);
                                                    let _e981 = ((select(_e876[2][1], _e963, (_e963 > _e876[2][1])) - _e372) * _e374);
                                                    let _e984 = ((select(_e876[2][2], _e967, (_e967 < _e876[2][2])) - _e437) * _e440);
                                                    let _e985 = ((select(_e876[2][2], _e971, (_e971 > _e876[2][2])) - _e438) * _e440);
                                                    let _e987 = select(_e985, _e984, (_e984 < _e985));
                                                    let _e989 = select(_e985, _e984, (_e984 > _e985));
                                                    let _e991 = select(_e977, _e976, (_e976 < _e977));
                                                    let _e993 = select(_e981, _e980, (_e980 < _e981));
                                                    let _e995 = select(_e993, _e991, (_e991 > _e993));
                                                    let _e997 = select(_e987, _e995, (_e995 > _e987));
                                                    let _e999 = select(_e977, _e976, (_e976 > _e977));
                                                    let _e1001 = select(_e981, _e980, (_e980 > _e981));
                                                    let _e1003 = select(_e1001, _e999, (_e999 < _e1001));
                                                    let _e1005 = select(_e989, _e1003, (_e1003 < _e989));
                                                    let _e1006 = -(_e987);
                                                    let _e1012 = select(_e543, _e997, (_e997 > _e543));
                                                    let _e1016 = select(_e904, _e895, (_e895 < _e904));
                                                    let _e1021 = select(_e904, _e895, (_e895 > _e904));
                                                    let _e1028 = select(_e907, _e898, (_e898 < _e907));
                                                    let _e1033 = select(_e907, _e898, (_e898 > _e907));
                                                    let _e1042 = (((((_e933 && (_e949 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e913, _e1016, (_e1016 < _e913)) <= 0f) && (select(_e913, _e1021, (_e1021 > _e913)) >= 0f))) && ((select(_e916, _e1028, (_e1028 < _e916)) <= 0f) && (select(_e916, _e1033, (_e1033 > _e916)) >= 0f))) && (_e1012 <= (_e1005 + (select(_e1006, _e989, (_e989 > _e1006)) * 0.0000019073523f)))) && (_e1012 <= _e777.member_1));
                                                    if _e1042 {
                                                        let _e1047 = (_e876[1][0] - _e876[0][0]);
                                                        let _e1048 = (_e876[1][1] - _e876[0][1]);
                                                        let _e1049 = (_e876[1][2] - _e876[0][2]);
                                                        let _e1050 = vec3<f32>(_e1047, _e1048, _e1049);
                                                        let _e1051 = (_e876[2][0] - _e876[1][0]);
                                                        let _e1052 = (_e876[2][1] - _e876[1][1]);
                                                        let _e1053 = (_e876[2][2] - _e876[1][2]);
                                                        let _e1054 = vec3<f32>(_e1051, _e1052, _e1053);
                                                        let _e1055 = (_e876[0][0] - _e876[2][0]);
                                                        let _e1056 = (_e876[0][1] - _e876[2][1]);
                                                        let _e1057 = (_e876[0][2] - _e876[2][2]);
                                                        let _e1058 = vec3<f32>(_e1055, _e1056, _e1057);
                                                        let _e1061 = bitcast<f32>((bitcast<u32>(_e1047) & 2147483647u));
                                                        let _e1064 = bitcast<f32>((bitcast<u32>(_e1048) & 2147483647u));
                                                        let _e1066 = select(_e1064, _e1061, (_e1061 > _e1064));
                                                        let _e1069 = bitcast<f32>((bitcast<u32>(_e1049) & 2147483647u));
                                                        let _e1071 = select(_e1069, _e1066, (_e1066 > _e1069));
                                                        let _e1074 = bitcast<f32>((bitcast<u32>(_e1051) & 2147483647u));
                                                        let _e1077 = bitcast<f32>((bitcast<u32>(_e1052) & 2147483647u));
                                                        let _e1079 = select(_e1077, _e1074, (_e1074 > _e1077));
                                                        let _e1082 = bitcast<f32>((bitcast<u32>(_e1053) & 2147483647u));
                                                        let _e1084 = select(_e1082, _e1079, (_e1079 > _e1082));
                                                        let _e1087 = bitcast<f32>((bitcast<u32>(_e1055) & 2147483647u));
                                                        let _e1090 = bitcast<f32>((bitcast<u32>(_e1056) & 2147483647u));
                                                        let _e1092 = select(_e1090, _e1087, (_e1087 > _e1090));
                                                        let _e1095 = bitcast<f32>((bitcast<u32>(_e1057) & 2147483647u));
                                                        let _e1097 = select(_e1095, _e1092, (_e1092 > _e1095));
                                                        let _e1099 = select(_e1084, _e1071, (_e1071 > _e1084));
                                                        let _e1101 = select(_e1097, _e1099, (_e1099 > _e1097));
                                                        if (_e1071 == _e1101) {
                                                            phi_1737_ = _e907;
                                                            phi_1738_ = _e904;
                                                            phi_1739_ = _e898;
                                                            phi_1740_ = _e895;
                                                            phi_1741_ = vec3<f32>(_e876[0][0], _e876[0][1], _e876[0][2]);
                                                            phi_1742_ = _e1058;
                                                            phi_1743_ = _e1054;
                                                            phi_1744_ = _e1050;
                                                        } else {
                                                            let _e1103 = (_e1084 == _e1101);
                                                            let _e1108 = vec3(_e1103);
                                                            phi_1737_ = select(_e898, _e916, _e1103);
                                                            phi_1738_ = select(_e895, _e913, _e1103);
                                                            phi_1739_ = select(_e916, _e907, _e1103);
                                                            phi_1740_ = select(_e913, _e904, _e1103);
                                                            phi_1741_ = select(vec3<f32>(_e876[2][0], _e876[2][1], _e876[2][2]), vec3<f32>(_e876[1][0], _e876[1][1], _e876[1][2]), _e1108);
                                                            phi_1742_ = select(_e1054, _e1050, _e1108);
                                                            phi_1743_ = select(_e1050, _e1058, _e1108);
                                                            phi_1744_ = select(_e1058, _e1054, _e1108);
                                                        }
                                                        let _e1114 = phi_1737_;
                                                        let _e1116 = phi_1738_;
                                                        let _e1118 = phi_1739_;
                                                        let _e1120 = phi_1740_;
                                                        let _e1122 = phi_1741_;
                                                        let _e1124 = phi_1742_;
                                                        let _e1126 = phi_1743_;
                                                        let _e1128 = phi_1744_;
                                                        let _e1135 = ((_e1126.y * _e1124.z) - (_e1124.y * _e1126.z));
                                                        let _e1140 = ((_e1126.z * _e1124.x) - (_e1124.z * _e1126.x));
                                                        let _e1143 = ((_e1126.x * _e1124.y) - (_e1124.x * _e1126.y));
                                                        let _e1146 = ((_e939 >= _e943) && (_e939 >= _e947));
                                                        let _e1147 = (_e943 >= _e947);
                                                        let _e1161 = (((_e1135 * (select(select(_e876[2][0], _e876[1][0], _e1147), _e876[0][0], _e1146) - _e267)) + (_e1140 * (select(select(_e876[2][1], _e876[1][1], _e1147), _e876[0][1], _e1146) - _e334))) + (_e1143 * (select(select(_e876[2][2], _e876[1][2], _e1147), _e876[0][2], _e1146) - _e400)));
                                                        let _e1166 = (((_e1135 * _e304) + (_e1140 * _e370)) + (_e1143 * _e436));
                                                        let _e1167 = (_e1116 - _e1120);
                                                        let _e1168 = (_e1114 - _e1118);
                                                        let _e1171 = ((_e1167 * _e1167) + (_e1168 * _e1168));
                                                        let _e1178 = (-(((_e1120 * _e1167) + (_e1118 * _e1168))) / select(0.000000000000000000000000000000000000011754944f, _e1171, (_e1171 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1180 = select(1f, _e1178, (_e1178 < 1f));
                                                        let _e1182 = select(0f, _e1180, (_e1180 > 0f));
                                                        let _e1191 = ((_e1122.x + (_e1128.x * _e1182)) - _e267);
                                                        let _e1194 = ((_e1122.y + (_e1128.y * _e1182)) - _e334);
                                                        let _e1197 = ((_e1122.z + (_e1128.z * _e1182)) - _e400);
                                                        let _e1200 = bitcast<f32>((bitcast<u32>(_e1191) & 2147483647u));
                                                        let _e1203 = bitcast<f32>((bitcast<u32>(_e1194) & 2147483647u));
                                                        let _e1205 = select(_e1203, _e1200, (_e1200 > _e1203));
                                                        let _e1208 = bitcast<f32>((bitcast<u32>(_e1197) & 2147483647u));
                                                        let _e1210 = select(_e1208, _e1205, (_e1205 > _e1208));
                                                        let _e1216 = bitcast<f32>((bitcast<u32>(_e1135) & 2147483647u));
                                                        let _e1219 = bitcast<f32>((bitcast<u32>(_e1140) & 2147483647u));
                                                        let _e1221 = select(_e1219, _e1216, (_e1216 > _e1219));
                                                        let _e1224 = bitcast<f32>((bitcast<u32>(_e1143) & 2147483647u));
                                                        let _e1243 = bitcast<f32>((bitcast<u32>(_e1126.x) & 2147483647u));
                                                        let _e1246 = bitcast<f32>((bitcast<u32>(_e1126.y) & 2147483647u));
                                                        let _e1248 = select(_e1246, _e1243, (_e1243 > _e1246));
                                                        let _e1251 = bitcast<f32>((bitcast<u32>(_e1126.z) & 2147483647u));
                                                        let _e1257 = bitcast<f32>((bitcast<u32>(_e1124.x) & 2147483647u));
                                                        let _e1260 = bitcast<f32>((bitcast<u32>(_e1124.y) & 2147483647u));
                                                        let _e1262 = select(_e1260, _e1257, (_e1257 > _e1260));
                                                        let _e1265 = bitcast<f32>((bitcast<u32>(_e1124.z) & 2147483647u));
                                                        let _e1271 = ((bitcast<f32>((bitcast<u32>(((((_e1135 * _e1191) + (_e1140 * _e1194)) + (_e1143 * _e1197)) - _e1161)) & 2147483647u)) <= ((0.0000009536743f * select(_e1101, _e1210, (_e1210 > _e1101))) * select(_e1224, _e1221, (_e1221 > _e1224)))) && !((bitcast<f32>((bitcast<u32>(_e1166) & 2147483647u)) <= ((0.0000038146973f * select(_e1251, _e1248, (_e1248 > _e1251))) * select(_e1265, _e1262, (_e1262 > _e1265))))));
                                                        let _e1272 = (_e1161 / _e1166);
                                                        if (_e1042 && !(_e1271)) {
                                                            let _e1275 = (_e1197 / _e436);
                                                            let _e1283 = (((_e1135 * (_e1191 - (_e304 * _e1275))) + (_e1140 * (_e1194 - (_e370 * _e1275)))) / _e1166);
                                                            phi_1935_ = select(select(_e1275, (_e1275 + _e1283), (bitcast<f32>((bitcast<u32>(_e1283) & 2147483647u)) <= _e1101)), _e1272, _e1271);
                                                        } else {
                                                            phi_1935_ = _e1272;
                                                        }
                                                        let _e1292 = phi_1935_;
                                                        let _e1294 = select(_e1005, _e1292, (_e1292 < _e1005));
                                                        let _e1296 = select(_e997, _e1294, (_e1294 > _e997));
                                                        let _e1297 = (1f / _e949);
                                                        phi_1955_ = type_44(_e1296, (_e943 * _e1297), (_e947 * _e1297), ((_e1042 && (_e1296 >= _e543)) && (_e1296 <= _e777.member_1)));
                                                        phi_1956_ = type_44();
                                                    } else {
                                                        phi_1955_ = type_44();
                                                        phi_1956_ = type_44(0f, 0f, 0f, _e1042);
                                                    }
                                                    let _e1306 = phi_1955_;
                                                    let _e1308 = phi_1956_;
                                                    phi_1959_ = _e1306;
                                                    phi_1960_ = _e1308;
                                                    phi_1961_ = select(true, false, _e1042);
                                                } else {
                                                    phi_1959_ = type_44();
                                                    phi_1960_ = type_44(0f, 0f, 0f, _e933);
                                                    phi_1961_ = true;
                                                }
                                                let _e1311 = phi_1959_;
                                                let _e1313 = phi_1960_;
                                                let _e1315 = phi_1961_;
                                                if _e1315 {
                                                    phi_1965_ = _e1313;
                                                } else {
                                                    phi_1965_ = _e1311;
                                                }
                                                let _e1317 = phi_1965_;
                                                if _e1317.member_3 {
                                                    phi_1974_ = type_23(_e1317.member, _e1317.member_1, _e1317.member_2, _e806);
                                                } else {
                                                    phi_1974_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1324 = phi_1974_;
                                                if (_e1324.member_3 != 4294967295u) {
                                                    if (_e806 != 4294967295u) {
                                                        if (_e1324.member < _e777.member.member) {
                                                            phi_2000_ = true;
                                                        } else {
                                                            if (_e1324.member == _e777.member.member) {
                                                                phi_1999_ = (_e1324.member_3 < _e777.member.member_3);
                                                            } else {
                                                                phi_1999_ = false;
                                                            }
                                                            let _e1337 = phi_1999_;
                                                            phi_2000_ = _e1337;
                                                        }
                                                        let _e1339 = phi_2000_;
                                                        if _e1339 {
                                                            phi_2006_ = type_40(_e1324, _e1324.member);
                                                        } else {
                                                            phi_2006_ = _e777;
                                                        }
                                                        let _e1342 = phi_2006_;
                                                        phi_2007_ = _e1342;
                                                    } else {
                                                        phi_2007_ = _e777;
                                                    }
                                                    let _e1344 = phi_2007_;
                                                    phi_2008_ = _e1344;
                                                } else {
                                                    phi_2008_ = _e777;
                                                }
                                                let _e1346 = phi_2008_;
                                                phi_1069_ = _e1346;
                                            } else {
                                                phi_1069_ = type_40();
                                            }
                                            let _e1348 = phi_1069_;
                                            continue;
                                            continuing {
                                                phi_1068_ = _e1348;
                                                phi_1071_ = _e792;
                                                phi_2814_ = _e551;
                                                break if !(_e798);
                                            }
                                        }
                                        let _e1351 = phi_2814_;
                                        phi_2967_ = _e1351;
                                        if _e1351 {
                                            break;
                                        }
                                        let _e1353 = local_2;
                                        phi_2971_ = _e1351;
                                        let _e1618 = local_4;
                                        phi_2485_ = _e1618;
                                        phi_2486_ = false;
                                        phi_2487_ = _e578;
                                        phi_2488_ = select(_e580, 0u, (_e543 > _e1353.member_1));
                                    } else {
                                        if (_e578 >= _e75) {
                                            phi_2073_ = type_45(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e578 < _e75) {
                                            } else {
                                                phi_2967_ = true;
                                                break;
                                            }
                                            let _e590 = (_e203 % 3u);
                                            if (_e590 < 3u) {
                                            } else {
                                                phi_2967_ = true;
                                                break;
                                            }
                                            let _e596 = global_2.member[_e578].member[_e590];
                                            let _e602 = (_e202 % 3u);
                                            if (_e602 < 3u) {
                                            } else {
                                                phi_2967_ = true;
                                                break;
                                            }
                                            let _e608 = global_2.member[_e578].member[_e602];
                                            let _e614 = (_e204 % 3u);
                                            if (_e614 < 3u) {
                                            } else {
                                                phi_2967_ = true;
                                                break;
                                            }
                                            let _e620 = global_2.member[_e578].member[_e614];
                                            let _e630 = global_2.member[_e578].member_1;
                                            let _e634 = global_2.member[_e578].member_2;
                                            phi_2073_ = type_45(array<vec4<f32>, 3>(vec4<f32>(_e596[0], _e596[1], _e596[2], _e596[3]), vec4<f32>(_e608[0], _e608[1], _e608[2], _e608[3]), vec4<f32>(_e620[0], _e620[1], _e620[2], _e620[3])), _e630, _e634);
                                        }
                                        let _e637 = phi_2073_;
                                        let _e649 = ((_e637.member[0].x - _e305) * _e308);
                                        let _e650 = ((_e637.member[0].y - _e305) * _e308);
                                        let _e651 = ((_e637.member[0].z - _e306) * _e308);
                                        let _e652 = ((_e637.member[0].w - _e306) * _e308);
                                        let _e662 = ((_e637.member[1].x - _e371) * _e374);
                                        let _e663 = ((_e637.member[1].y - _e371) * _e374);
                                        let _e664 = ((_e637.member[1].z - _e372) * _e374);
                                        let _e665 = ((_e637.member[1].w - _e372) * _e374);
                                        let _e675 = ((_e637.member[2].x - _e437) * _e440);
                                        let _e676 = ((_e637.member[2].y - _e437) * _e440);
                                        let _e677 = ((_e637.member[2].z - _e438) * _e440);
                                        let _e678 = ((_e637.member[2].w - _e438) * _e440);
                                        let _e680 = select(_e677, _e675, (_e675 < _e677));
                                        let _e682 = select(_e678, _e676, (_e676 < _e678));
                                        let _e684 = select(_e677, _e675, (_e675 > _e677));
                                        let _e686 = select(_e678, _e676, (_e676 > _e678));
                                        let _e688 = select(_e651, _e649, (_e649 < _e651));
                                        let _e690 = select(_e652, _e650, (_e650 < _e652));
                                        let _e692 = select(_e664, _e662, (_e662 < _e664));
                                        let _e694 = select(_e665, _e663, (_e663 < _e665));
                                        let _e696 = select(_e692, _e688, (_e688 > _e692));
                                        let _e698 = select(_e694, _e690, (_e690 > _e694));
                                        let _e700 = select(_e680, _e696, (_e696 > _e680));
                                        let _e702 = select(_e682, _e698, (_e698 > _e682));
                                        let _e704 = select(_e651, _e649, (_e649 > _e651));
                                        let _e706 = select(_e652, _e650, (_e650 > _e652));
                                        let _e708 = select(_e664, _e662, (_e662 > _e664));
                                        let _e710 = select(_e665, _e663, (_e663 > _e665));
                                        let _e712 = select(_e708, _e704, (_e704 < _e708));
                                        let _e714 = select(_e710, _e706, (_e706 < _e710));
                                        let _e719 = -(_e680);
                                        let _e720 = -(_e682);
                                        let _e727 = (select(_e684, _e712, (_e712 < _e684)) + (select(_e719, _e684, (_e684 > _e719)) * 0.0000019073523f));
                                        let _e728 = (select(_e686, _e714, (_e714 < _e686)) + (select(_e720, _e686, (_e686 > _e720)) * 0.0000019073523f));
                                        let _e730 = select(_e543, _e700, (_e700 > _e543));
                                        let _e732 = select(_e543, _e702, (_e702 > _e543));
                                        let _e737 = (_e730 <= select(_e553.member_1, _e727, (_e727 < _e553.member_1)));
                                        let _e738 = (_e732 <= select(_e553.member_1, _e728, (_e728 < _e553.member_1)));
                                        let _e739 = (_e730 <= _e732);
                                        if _e737 {
                                            if _e738 {
                                                if _e739 {
                                                    phi_2435_ = _e637.member_2;
                                                } else {
                                                    phi_2435_ = _e637.member_1;
                                                }
                                                let _e743 = phi_2435_;
                                                let _e745 = (_e580 % 128u);
                                                let _e746 = (_e745 < 128u);
                                                if _e746 {
                                                } else {
                                                    phi_2967_ = true;
                                                    break;
                                                }
                                                local_1[_e745] = _e743;
                                                if _e746 {
                                                } else {
                                                    phi_2967_ = true;
                                                    break;
                                                }
                                                local[_e745] = select(_e730, _e732, _e739);
                                                if _e739 {
                                                    phi_2462_ = _e637.member_1;
                                                } else {
                                                    phi_2462_ = _e637.member_2;
                                                }
                                                let _e753 = phi_2462_;
                                                phi_2463_ = _e753;
                                                phi_2464_ = (_e580 + 1u);
                                            } else {
                                                phi_2463_ = u32();
                                                phi_2464_ = u32();
                                            }
                                            let _e755 = phi_2463_;
                                            let _e757 = phi_2464_;
                                            phi_2466_ = _e755;
                                            phi_2467_ = _e757;
                                            phi_2468_ = select(true, false, _e738);
                                        } else {
                                            phi_2466_ = u32();
                                            phi_2467_ = u32();
                                            phi_2468_ = true;
                                        }
                                        let _e760 = phi_2466_;
                                        let _e762 = phi_2467_;
                                        let _e764 = phi_2468_;
                                        if _e764 {
                                            if _e737 {
                                                phi_2477_ = _e637.member_1;
                                            } else {
                                                phi_2477_ = _e637.member_2;
                                            }
                                            let _e768 = phi_2477_;
                                            phi_2482_ = select(_e738, true, _e737);
                                            phi_2483_ = _e768;
                                        } else {
                                            phi_2482_ = _e576;
                                            phi_2483_ = _e760;
                                        }
                                        let _e771 = phi_2482_;
                                        let _e773 = phi_2483_;
                                        phi_2971_ = _e551;
                                        phi_2485_ = _e553;
                                        phi_2486_ = _e771;
                                        phi_2487_ = _e773;
                                        phi_2488_ = select(_e762, _e580, _e764);
                                    }
                                    let _e1358 = phi_2971_;
                                    let _e1360 = phi_2485_;
                                    let _e1362 = phi_2486_;
                                    let _e1364 = phi_2487_;
                                    let _e1366 = phi_2488_;
                                    phi_2970_ = _e1358;
                                    phi_2489_ = _e1360;
                                    phi_2490_ = _e1362;
                                    phi_2491_ = _e1364;
                                    phi_2492_ = _e1366;
                                    phi_2493_ = (_e561 - 1u);
                                } else {
                                    phi_2970_ = _e551;
                                    phi_2489_ = _e553;
                                    phi_2490_ = _e576;
                                    phi_2491_ = _e578;
                                    phi_2492_ = _e580;
                                    phi_2493_ = _e561;
                                }
                                let _e1368 = phi_2970_;
                                let _e1370 = phi_2489_;
                                let _e1372 = phi_2490_;
                                let _e1374 = phi_2491_;
                                let _e1376 = phi_2492_;
                                let _e1378 = phi_2493_;
                                phi_2969_ = _e1368;
                                phi_2494_ = _e1370;
                                phi_2495_ = _e1372;
                                phi_2496_ = _e1374;
                                phi_2497_ = _e1376;
                                phi_2498_ = _e1378;
                            } else {
                                phi_2969_ = _e551;
                                phi_2494_ = type_40();
                                phi_2495_ = bool();
                                phi_2496_ = u32();
                                phi_2497_ = u32();
                                phi_2498_ = u32();
                            }
                            let _e1380 = phi_2969_;
                            let _e1382 = phi_2494_;
                            let _e1384 = phi_2495_;
                            let _e1386 = phi_2496_;
                            let _e1388 = phi_2497_;
                            let _e1390 = phi_2498_;
                            phi_2968_ = _e1380;
                            phi_1000_ = _e1382;
                            phi_1003_ = _e1384;
                            phi_1005_ = _e1386;
                            phi_1007_ = _e1388;
                            phi_1009_ = _e1390;
                            phi_2499_ = _e565;
                        } else {
                            phi_2968_ = _e551;
                            phi_1000_ = type_40();
                            phi_1003_ = bool();
                            phi_1005_ = u32();
                            phi_1007_ = u32();
                            phi_1009_ = u32();
                            phi_2499_ = false;
                        }
                        let _e1392 = phi_2968_;
                        let _e1394 = phi_1000_;
                        let _e1396 = phi_1003_;
                        let _e1398 = phi_1005_;
                        let _e1400 = phi_1007_;
                        let _e1402 = phi_1009_;
                        let _e1404 = phi_2499_;
                        continue;
                        continuing {
                            phi_2820_ = _e1392;
                            phi_999_ = _e1394;
                            phi_1002_ = _e1396;
                            phi_1004_ = _e1398;
                            phi_1006_ = _e1400;
                            phi_1008_ = _e1402;
                            phi_2967_ = _e1392;
                            break if !(_e1404);
                        }
                    }
                    let _e1407 = phi_2967_;
                    if _e1407 {
                        break;
                    }
                    let _e1409 = local_3;
                    if (_e1409.member.member_3 != 4294967295u) {
                        let _e1414 = -(_e445);
                        let _e1415 = bitcast<u32>(_e1409.member.member);
                        let _e1419 = (bitcast<i32>((_e1415 >> bitcast<u32>(23i))) & 255i);
                        let _e1420 = (_e1419 + _e1414);
                        if (_e1419 == 255i) {
                            phi_2558_ = _e1409.member.member;
                        } else {
                            if (_e1419 > 0i) {
                                if (_e1420 > 0i) {
                                    let _e1424 = (_e1420 < 255i);
                                    if _e1424 {
                                        phi_2537_ = bitcast<f32>((_e1415 + bitcast<u32>((_e1414 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_2537_ = f32();
                                    }
                                    let _e1431 = phi_2537_;
                                    phi_2539_ = _e1431;
                                    phi_2540_ = select(true, false, _e1424);
                                } else {
                                    phi_2539_ = f32();
                                    phi_2540_ = true;
                                }
                                let _e1434 = phi_2539_;
                                let _e1436 = phi_2540_;
                                phi_2541_ = _e1434;
                                phi_2542_ = _e1436;
                            } else {
                                phi_2541_ = f32();
                                phi_2542_ = true;
                            }
                            let _e1438 = phi_2541_;
                            let _e1440 = phi_2542_;
                            if _e1440 {
                                let _e1441 = (_e1415 & 2147483648u);
                                let _e1448 = ((_e1415 & 8388607u) | (select(0u, 1u, ((_e1415 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1452 = (_e1448 == 0u);
                                if _e1452 {
                                    phi_2809_ = bitcast<f32>(_e1441);
                                } else {
                                    let _e1457 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1448)), 32u, _e1452) - 8u);
                                    let _e1460 = (_e1448 << bitcast<u32>((_e1457 & 31u)));
                                    let _e1462 = ((_e1420 + select(0i, 1i, (_e1419 == 0i))) - bitcast<i32>(_e1457));
                                    if (_e1462 >= 255i) {
                                        phi_2799_ = bitcast<f32>((_e1441 | 2139095040u));
                                        phi_2800_ = f32();
                                        phi_2801_ = true;
                                    } else {
                                        let _e1464 = (_e1462 > 0i);
                                        if _e1464 {
                                            phi_2793_ = bitcast<f32>(((_e1441 | (bitcast<u32>(_e1462) << bitcast<u32>(23i))) | (_e1460 & 8388607u)));
                                            phi_2794_ = f32();
                                        } else {
                                            if (_e1462 < -24i) {
                                                phi_2759_ = 26u;
                                            } else {
                                                phi_2759_ = bitcast<u32>((1i - _e1462));
                                            }
                                            let _e1469 = phi_2759_;
                                            let _e1470 = (_e1469 & 31u);
                                            let _e1472 = (_e1460 >> bitcast<u32>(_e1470));
                                            let _e1476 = (_e1460 & ((1u << bitcast<u32>(_e1470)) - 1u));
                                            let _e1480 = (1u << bitcast<u32>(((_e1469 - 1u) & 31u)));
                                            if (_e1476 > _e1480) {
                                                phi_2780_ = true;
                                            } else {
                                                if (_e1476 == _e1480) {
                                                    phi_2777_ = ((_e1472 & 1u) == 1u);
                                                } else {
                                                    phi_2777_ = false;
                                                }
                                                let _e1486 = phi_2777_;
                                                phi_2780_ = _e1486;
                                            }
                                            let _e1488 = phi_2780_;
                                            phi_2793_ = f32();
                                            phi_2794_ = bitcast<f32>((_e1441 | (_e1472 + select(0u, 1u, _e1488))));
                                        }
                                        let _e1501 = phi_2793_;
                                        let _e1503 = phi_2794_;
                                        phi_2799_ = _e1501;
                                        phi_2800_ = _e1503;
                                        phi_2801_ = _e1464;
                                    }
                                    let _e1507 = phi_2799_;
                                    let _e1509 = phi_2800_;
                                    let _e1511 = phi_2801_;
                                    phi_2809_ = select(_e1509, _e1507, _e1511);
                                }
                                let _e1515 = phi_2809_;
                                phi_2557_ = _e1515;
                            } else {
                                phi_2557_ = _e1438;
                            }
                            let _e1517 = phi_2557_;
                            phi_2558_ = _e1517;
                        }
                        let _e1519 = phi_2558_;
                        let _e1520 = bitcast<u32>(_e1519);
                        if ((_e1520 & 2147483647u) >= 2139095040u) {
                            phi_2570_ = bitcast<f32>(((_e1520 & 2147483648u) | 2139095039u));
                        } else {
                            phi_2570_ = _e1519;
                        }
                        let _e1527 = phi_2570_;
                        phi_2575_ = type_23(_e1527, _e1409.member.member_1, _e1409.member.member_2, _e1409.member.member_3);
                    } else {
                        phi_2575_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1532 = phi_2575_;
                    if _e91 {
                    } else {
                        break;
                    }
                    global_5.member[_e85] = _e1532;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
