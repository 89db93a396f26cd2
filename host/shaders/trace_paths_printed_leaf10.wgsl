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

struct type_35 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_38 {
    member: type_22,
    member_1: f32,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<i32>,
}

struct type_48 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_50 {
    member: array<type_48>,
}

struct type_53 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_55 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_57 {
    member: array<type_55>,
}

struct type_61 {
    member: type_53,
    member_1: u32,
}

struct type_66 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_41;
@group(0) @binding(2) 
var<uniform> global_3: type_41;
@group(0) @binding(5) 
var<storage> global_4: type_4;
@group(0) @binding(6) 
var<storage> global_5: type_44;
@group(0) @binding(7) 
var<storage> global_6: type_29;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_24;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_66;
@group(0) @binding(3) 
var<storage> global_9: type_50;
@group(0) @binding(4) 
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
    var phi_276_: u32;
    var phi_320_: i32;
    var phi_344_: type_35;
    var phi_450_: i32;
    var phi_451_: i32;
    var phi_461_: bool;
    var phi_471_: u32;
    var phi_472_: u32;
    var phi_474_: bool;
    var phi_479_: u32;
    var phi_511_: i32;
    var phi_529_: f32;
    var phi_535_: f32;
    var phi_546_: f32;
    var phi_552_: f32;
    var phi_575_: f32;
    var phi_586_: f32;
    var phi_595_: f32;
    var phi_601_: f32;
    var phi_612_: f32;
    var phi_618_: f32;
    var phi_641_: f32;
    var phi_652_: f32;
    var phi_661_: f32;
    var phi_667_: f32;
    var phi_678_: f32;
    var phi_684_: f32;
    var phi_707_: f32;
    var phi_718_: f32;
    var phi_818_: f32;
    var phi_819_: f32;
    var phi_3648_: bool;
    var phi_892_: type_38;
    var phi_895_: type_61;
    var phi_897_: u32;
    var phi_899_: bool;
    var phi_901_: u32;
    var phi_912_: bool;
    var phi_998_: type_61;
    var phi_999_: bool;
    var phi_1000_: u32;
    var phi_2525_: type_48;
    var phi_3357_: type_61;
    var phi_3434_: type_61;
    var phi_3435_: type_61;
    var phi_3436_: u32;
    var phi_3438_: type_61;
    var phi_3439_: u32;
    var phi_3440_: bool;
    var phi_3447_: type_61;
    var phi_3452_: type_61;
    var phi_3453_: bool;
    var phi_1019_: type_38;
    var phi_1022_: type_8;
    var phi_1023_: type_8;
    var phi_1045_: type_8;
    var phi_1070_: u32;
    var phi_1086_: type_55;
    var phi_1462_: bool;
    var phi_1491_: bool;
    var phi_1868_: f32;
    var phi_1869_: f32;
    var phi_1870_: f32;
    var phi_1871_: f32;
    var phi_1872_: vec3<f32>;
    var phi_1873_: vec3<f32>;
    var phi_1874_: vec3<f32>;
    var phi_1875_: vec3<f32>;
    var phi_1906_: bool;
    var phi_1915_: vec3<f32>;
    var phi_2080_: f32;
    var phi_2082_: f32;
    var phi_2083_: bool;
    var phi_2103_: f32;
    var phi_2104_: f32;
    var phi_2127_: type_22;
    var phi_2129_: type_22;
    var phi_2130_: bool;
    var phi_2134_: type_22;
    var phi_2135_: type_22;
    var phi_2136_: type_22;
    var phi_2137_: bool;
    var phi_2141_: type_22;
    var phi_2142_: bool;
    var phi_2143_: type_22;
    var phi_2144_: bool;
    var phi_2145_: bool;
    var phi_2146_: type_22;
    var phi_2147_: bool;
    var phi_2148_: bool;
    var phi_2156_: type_22;
    var phi_2157_: bool;
    var phi_2161_: type_22;
    var phi_2184_: u32;
    var phi_2198_: i32;
    var phi_2214_: vec3<f32>;
    var phi_2215_: vec3<f32>;
    var phi_2227_: vec3<f32>;
    var phi_2228_: vec3<f32>;
    var phi_2240_: vec3<f32>;
    var phi_2241_: vec3<f32>;
    var phi_2277_: vec3<f32>;
    var phi_2459_: f32;
    var phi_2477_: bool;
    var phi_2478_: bool;
    var phi_2497_: bool;
    var phi_2498_: bool;
    var phi_2504_: type_38;
    var phi_2505_: type_38;
    var phi_2506_: type_38;
    var phi_1020_: type_38;
    var phi_3642_: bool;
    var phi_3830_: bool;
    var phi_3455_: type_38;
    var phi_3456_: type_61;
    var phi_3457_: bool;
    var phi_3458_: u32;
    var phi_3829_: bool;
    var phi_3459_: type_38;
    var phi_3460_: type_61;
    var phi_3461_: u32;
    var phi_3462_: bool;
    var phi_3463_: u32;
    var phi_3828_: bool;
    var phi_3464_: type_38;
    var phi_3465_: type_61;
    var phi_3466_: u32;
    var phi_3467_: bool;
    var phi_3468_: u32;
    var phi_3827_: bool;
    var phi_893_: type_38;
    var phi_896_: type_61;
    var phi_898_: u32;
    var phi_900_: bool;
    var phi_902_: u32;
    var phi_3469_: bool;
    var phi_3826_: bool;
    var local_10: type_38;
    var phi_3521_: type_22;
    var local_11: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e86 = global;
            let _e89 = arrayLength((&global_9.member));
            let _e104 = arrayLength((&global_8.member));
            let _e108 = global_3.member[0u][0u];
            let _e112 = global_3.member[0u][1u];
            let _e116 = global_3.member[0u][2u];
            let _e120 = global_3.member[1u][0u];
            let _e124 = global_3.member[1u][1u];
            let _e128 = global_3.member[1u][2u];
            let _e132 = global_3.member[1u][3u];
            let _e136 = (_e86.x + (_e86.y * 2097152u));
            let _e143 = (_e136 < arrayLength((&global_6.member)));
            if _e143 {
                if _e143 {
                } else {
                    break;
                }
                let _e147 = global_6.member[_e136].member_2;
                phi_276_ = _e147;
            } else {
                phi_276_ = 4294967295u;
            }
            let _e149 = phi_276_;
            let _e152 = global_1.member[0u];
            let _e156 = global_2.member[0u][0u];
            let _e160 = global_2.member[0u][1u];
            let _e164 = global_2.member[0u][2u];
            let _e168 = global_2.member[0u][3u];
            let _e172 = global_2.member[1u][0u];
            let _e176 = global_2.member[1u][1u];
            let _e180 = global_2.member[1u][2u];
            let _e184 = global_2.member[1u][3u];
            let _e185 = bitcast<f32>(_e156);
            let _e186 = bitcast<f32>(_e160);
            let _e187 = bitcast<f32>(_e164);
            let _e189 = bitcast<f32>(_e172);
            let _e190 = array<u32, 3>(_e176, _e180, _e184);
            let _e192 = bitcast<i32>(_e152);
            if (_e192 < -126i) {
                phi_320_ = -126i;
            } else {
                phi_320_ = select(_e192, 127i, (_e192 > 127i));
            }
            let _e197 = phi_320_;
            let _e202 = bitcast<f32>((bitcast<u32>((_e197 + 127i)) << bitcast<u32>(23i)));
            let _e208 = bitcast<f32>((bitcast<u32>(((_e192 - _e197) + 127i)) << bitcast<u32>(23i)));
            if (_e168 == 0u) {
                phi_344_ = type_35(array<f32, 3>(_e185, _e186, _e187), _e168, _e189, _e190);
            } else {
                phi_344_ = type_35(array<f32, 3>(((_e185 * _e202) * _e208), ((_e186 * _e202) * _e208), ((_e187 * _e202) * _e208)), _e168, ((_e189 * _e202) * _e208), _e190);
            }
            let _e221 = phi_344_;
            if _e143 {
                let _e222 = (_e136 < arrayLength((&global_7.member)));
                if _e222 {
                    if _e143 {
                    } else {
                        break;
                    }
                    let _e232 = global_6.member[_e136].member.member_2[0u];
                    let _e234 = (bitcast<u32>(_e232) & 2147483647u);
                    let _e240 = global_6.member[_e136].member.member_2[1u];
                    let _e242 = (bitcast<u32>(_e240) & 2147483647u);
                    let _e248 = global_6.member[_e136].member.member_2[2u];
                    let _e250 = (bitcast<u32>(_e248) & 2147483647u);
                    let _e256 = global_6.member[_e136].member.member[0u];
                    let _e258 = (bitcast<u32>(_e256) & 2147483647u);
                    let _e264 = global_6.member[_e136].member.member[1u];
                    let _e266 = (bitcast<u32>(_e264) & 2147483647u);
                    let _e272 = global_6.member[_e136].member.member[2u];
                    let _e274 = (bitcast<u32>(_e272) & 2147483647u);
                    let _e276 = select(_e242, _e234, (_e242 < _e234));
                    let _e278 = select(_e250, _e276, (_e250 < _e276));
                    let _e280 = select(_e258, _e278, (_e258 < _e278));
                    let _e282 = select(_e266, _e280, (_e266 < _e280));
                    let _e284 = select(_e274, _e282, (_e274 < _e282));
                    let _e289 = global_6.member[_e136].member.member_1;
                    let _e291 = (bitcast<u32>(_e289) & 2147483647u);
                    let _e299 = global_6.member[_e136].member.member_3;
                    let _e305 = (((select(_e291, _e284, (_e291 < _e284)) < 2139095040u) && ((bitcast<u32>(_e299) & 2147483647u) <= 2139095040u)) && (_e278 > 0u));
                    if _e305 {
                        let _e308 = (bitcast<u32>(bitcast<f32>(_e278)) & 2147483647u);
                        if (_e308 >= 8388608u) {
                            phi_450_ = (bitcast<i32>((_e308 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_450_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e308)), 32u, (_e308 == 0u))));
                        }
                        let _e322 = phi_450_;
                        phi_451_ = _e322;
                    } else {
                        phi_451_ = 0i;
                    }
                    let _e324 = phi_451_;
                    let _e325 = (_e234 == _e278);
                    if _e325 {
                        phi_461_ = true;
                    } else {
                        phi_461_ = (_e242 == _e278);
                    }
                    let _e328 = phi_461_;
                    let _e329 = select(1u, 0u, _e325);
                    if _e328 {
                        let _e330 = (_e329 + 1u);
                        phi_471_ = _e330;
                        phi_472_ = _e330;
                        phi_474_ = select(true, false, (_e330 == 2u));
                    } else {
                        phi_471_ = u32();
                        phi_472_ = 0u;
                        phi_474_ = true;
                    }
                    let _e334 = phi_471_;
                    let _e336 = phi_472_;
                    let _e338 = phi_474_;
                    if _e338 {
                        phi_479_ = (_e336 + 1u);
                    } else {
                        phi_479_ = 0u;
                    }
                    let _e342 = phi_479_;
                    let _e343 = select(_e334, _e336, _e338);
                    let _e344 = select(_e329, select(2u, _e329, _e328), _e338);
                    let _e345 = -(_e324);
                    if (_e345 < -126i) {
                        phi_511_ = -126i;
                    } else {
                        phi_511_ = select(_e345, 127i, (_e345 > 127i));
                    }
                    let _e350 = phi_511_;
                    let _e355 = bitcast<f32>((bitcast<u32>((_e350 + 127i)) << bitcast<u32>(23i)));
                    let _e361 = bitcast<f32>((bitcast<u32>(((_e345 - _e350) + 127i)) << bitcast<u32>(23i)));
                    let _e366 = global_6.member[_e136].member.member;
                    let _e367 = (_e343 == 0u);
                    if _e367 {
                        phi_529_ = _e366[0];
                    } else {
                        phi_529_ = _e366[1];
                    }
                    let _e371 = phi_529_;
                    let _e372 = (_e343 == 2u);
                    if _e372 {
                        phi_535_ = _e366[2];
                    } else {
                        phi_535_ = _e371;
                    }
                    let _e375 = phi_535_;
                    let _e376 = global_6.member[_e136].member.member_2;
                    if _e367 {
                        phi_546_ = _e376[0];
                    } else {
                        phi_546_ = _e376[1];
                    }
                    let _e380 = phi_546_;
                    if _e372 {
                        phi_552_ = _e376[2];
                    } else {
                        phi_552_ = _e380;
                    }
                    let _e383 = phi_552_;
                    let _e385 = ((_e383 * _e355) * _e361);
                    let _e389 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e389 {
                        let _e393 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) * 0.00000011920929f);
                        phi_575_ = select(0.00000000000011368684f, _e393, (_e393 > 0.00000000000011368684f));
                    } else {
                        phi_575_ = 0f;
                    }
                    let _e397 = phi_575_;
                    let _e398 = (_e375 + _e397);
                    let _e399 = (_e375 - _e397);
                    let _e400 = select(_e385, 0f, _e389);
                    if _e389 {
                        phi_586_ = 38685626000000000000000000f;
                    } else {
                        phi_586_ = (1f / _e385);
                    }
                    let _e403 = phi_586_;
                    let _e404 = (_e342 == 0u);
                    if _e404 {
                        phi_595_ = _e366[0];
                    } else {
                        phi_595_ = _e366[1];
                    }
                    let _e408 = phi_595_;
                    let _e409 = (_e342 == 2u);
                    if _e409 {
                        phi_601_ = _e366[2];
                    } else {
                        phi_601_ = _e408;
                    }
                    let _e412 = phi_601_;
                    if _e404 {
                        phi_612_ = _e376[0];
                    } else {
                        phi_612_ = _e376[1];
                    }
                    let _e416 = phi_612_;
                    if _e409 {
                        phi_618_ = _e376[2];
                    } else {
                        phi_618_ = _e416;
                    }
                    let _e419 = phi_618_;
                    let _e421 = ((_e419 * _e355) * _e361);
                    let _e425 = (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e425 {
                        let _e429 = (bitcast<f32>((bitcast<u32>(_e412) & 2147483647u)) * 0.00000011920929f);
                        phi_641_ = select(0.00000000000011368684f, _e429, (_e429 > 0.00000000000011368684f));
                    } else {
                        phi_641_ = 0f;
                    }
                    let _e433 = phi_641_;
                    let _e434 = (_e412 + _e433);
                    let _e435 = (_e412 - _e433);
                    let _e436 = select(_e421, 0f, _e425);
                    if _e425 {
                        phi_652_ = 38685626000000000000000000f;
                    } else {
                        phi_652_ = (1f / _e421);
                    }
                    let _e439 = phi_652_;
                    let _e440 = (_e344 == 0u);
                    if _e440 {
                        phi_661_ = _e366[0];
                    } else {
                        phi_661_ = _e366[1];
                    }
                    let _e444 = phi_661_;
                    let _e445 = (_e344 == 2u);
                    if _e445 {
                        phi_667_ = _e366[2];
                    } else {
                        phi_667_ = _e444;
                    }
                    let _e448 = phi_667_;
                    if _e440 {
                        phi_678_ = _e376[0];
                    } else {
                        phi_678_ = _e376[1];
                    }
                    let _e452 = phi_678_;
                    if _e445 {
                        phi_684_ = _e376[2];
                    } else {
                        phi_684_ = _e452;
                    }
                    let _e455 = phi_684_;
                    let _e457 = ((_e455 * _e355) * _e361);
                    let _e461 = (bitcast<f32>((bitcast<u32>(_e457) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e461 {
                        let _e465 = (bitcast<f32>((bitcast<u32>(_e448) & 2147483647u)) * 0.00000011920929f);
                        phi_707_ = select(0.00000000000011368684f, _e465, (_e465 > 0.00000000000011368684f));
                    } else {
                        phi_707_ = 0f;
                    }
                    let _e469 = phi_707_;
                    let _e470 = (_e448 + _e469);
                    let _e471 = (_e448 - _e469);
                    let _e472 = select(_e457, 0f, _e461);
                    if _e461 {
                        phi_718_ = 38685626000000000000000000f;
                    } else {
                        phi_718_ = (1f / _e457);
                    }
                    let _e475 = phi_718_;
                    let _e478 = bitcast<f32>((bitcast<u32>(_e375) & 2147483647u));
                    let _e481 = bitcast<f32>((bitcast<u32>(_e412) & 2147483647u));
                    let _e483 = select(_e481, _e478, (_e478 > _e481));
                    let _e486 = bitcast<f32>((bitcast<u32>(_e448) & 2147483647u));
                    if (_e305 && (select(_e486, _e483, (_e483 > _e486)) <= 1099511600000f)) {
                        let _e491 = (_e324 / 3i);
                        let _e498 = bitcast<f32>((bitcast<u32>((_e491 + 127i)) << bitcast<u32>(23i)));
                        let _e505 = bitcast<f32>((bitcast<u32>(((_e324 - (2i * _e491)) + 127i)) << bitcast<u32>(23i)));
                        let _e506 = (((_e289 * _e498) * _e498) * _e505);
                        let _e508 = select(340282350000000000000000000000000000000f, _e506, (_e506 < 340282350000000000000000000000000000000f));
                        let _e513 = (((_e299 * _e498) * _e498) * _e505);
                        let _e515 = select(340282350000000000000000000000000000000f, _e513, (_e513 < 340282350000000000000000000000000000000f));
                        phi_818_ = select(-340282350000000000000000000000000000000f, _e515, (_e515 > -340282350000000000000000000000000000000f));
                        phi_819_ = select(-340282350000000000000000000000000000000f, _e508, (_e508 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_818_ = 0f;
                        phi_819_ = 1f;
                    }
                    let _e519 = phi_818_;
                    let _e521 = phi_819_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e108), bitcast<f32>(_e112), bitcast<f32>(_e116));
                    let _e526 = (_e343 % 3u);
                    let _e527 = (_e526 < 3u);
                    if _e527 {
                    } else {
                        break;
                    }
                    let _e529 = local_9[_e526];
                    let _e530 = (_e342 % 3u);
                    let _e531 = (_e530 < 3u);
                    if _e531 {
                    } else {
                        break;
                    }
                    let _e533 = local_9[_e530];
                    let _e534 = (_e344 % 3u);
                    let _e535 = (_e534 < 3u);
                    if _e535 {
                    } else {
                        break;
                    }
                    let _e537 = local_9[_e534];
                    local_8 = array<f32, 3>(bitcast<f32>(_e120), bitcast<f32>(_e124), bitcast<f32>(_e128));
                    if _e527 {
                    } else {
                        break;
                    }
                    let _e541 = local_8[_e526];
                    if _e531 {
                    } else {
                        break;
                    }
                    let _e543 = local_8[_e530];
                    if _e535 {
                    } else {
                        break;
                    }
                    let _e545 = local_8[_e534];
                    phi_3648_ = false;
                    phi_892_ = type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e519);
                    phi_895_ = type_61(type_53(array<f32, 3>(_e529, _e533, _e537), array<f32, 3>(_e541, _e543, _e545)), select(0u, 2147483648u, (_e89 == 0u)));
                    phi_897_ = ((3u * _e89) + 1u);
                    phi_899_ = (_e521 <= _e519);
                    phi_901_ = 0u;
                    loop {
                        let _e553 = phi_3648_;
                        let _e555 = phi_892_;
                        let _e557 = phi_895_;
                        let _e559 = phi_897_;
                        let _e561 = phi_899_;
                        let _e563 = phi_901_;
                        local_10 = _e555;
                        if _e561 {
                            phi_912_ = true;
                        } else {
                            phi_912_ = (_e563 > 0u);
                        }
                        let _e566 = phi_912_;
                        if _e566 {
                            let _e567 = (_e559 > 0u);
                            if _e567 {
                                if _e561 {
                                    phi_998_ = _e557;
                                    phi_999_ = _e561;
                                    phi_1000_ = _e563;
                                } else {
                                    let _e568 = (_e563 - 1u);
                                    let _e569 = (_e568 % 128u);
                                    let _e570 = (_e569 < 128u);
                                    if _e570 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e572 = local_6[_e569];
                                    if _e570 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e574 = local_5[_e569];
                                    if _e570 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e576 = local_4[_e569];
                                    if _e570 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e578 = local_3[_e569];
                                    if _e570 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e581 = local_2[_e569];
                                    if _e570 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e583 = local_1[_e569];
                                    if _e570 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e585 = local[_e569];
                                    if _e570 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e590 = local_7[_e569];
                                    phi_998_ = type_61(type_53(array<f32, 3>(_e574, _e576, _e578), array<f32, 3>(_e581, _e583, _e585)), _e572);
                                    phi_999_ = (_e590 <= _e555.member_1);
                                    phi_1000_ = _e568;
                                }
                                let _e594 = phi_998_;
                                let _e596 = phi_999_;
                                let _e598 = phi_1000_;
                                if _e596 {
                                    if ((_e594.member_1 & 2147483648u) != 0u) {
                                        phi_1019_ = _e555;
                                        phi_1022_ = type_8(0u, ((_e594.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e951 = phi_1019_;
                                            let _e953 = phi_1022_;
                                            local_11 = _e951;
                                            if (_e953.member < _e953.member_1) {
                                                phi_1023_ = type_8((_e953.member + 1u), _e953.member_1);
                                                phi_1045_ = type_8(1u, _e953.member);
                                            } else {
                                                phi_1023_ = _e953;
                                                phi_1045_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e966 = phi_1023_;
                                            let _e968 = phi_1045_;
                                            let _e972 = (bitcast<i32>(_e968.member) != 0i);
                                            if _e972 {
                                                let _e973 = ((_e594.member_1 & 268435455u) + _e968.member_1);
                                                let _e974 = (_e973 < arrayLength((&global_10.member)));
                                                if _e974 {
                                                    if _e974 {
                                                    } else {
                                                        phi_3642_ = true;
                                                        break;
                                                    }
                                                    let _e977 = global_10.member[_e973].member_1;
                                                    phi_1070_ = _e977;
                                                } else {
                                                    phi_1070_ = 4294967295u;
                                                }
                                                let _e979 = phi_1070_;
                                                if _e974 {
                                                    if _e974 {
                                                    } else {
                                                        phi_3642_ = true;
                                                        break;
                                                    }
                                                    let _e981 = global_10.member[_e973];
                                                    phi_1086_ = _e981;
                                                } else {
                                                    phi_1086_ = type_55(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e983 = phi_1086_;
                                                let _e995 = ((10u * _e343) & 31u);
                                                let _e998 = ((_e983.member[0] >> bitcast<u32>(_e995)) & 1023u);
                                                let _e1003 = bitcast<f32>((bitcast<u32>(((_e594.member.member_1[0] - _e594.member.member[0]) * 0.0009775171f)) ^ _e132));
                                                let _e1009 = (_e594.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e998) * _e1003)) ^ _e132)));
                                                let _e1013 = select(select(_e594.member.member_1[0], _e1009, (_e1009 < _e594.member.member_1[0])), _e594.member.member_1[0], (_e998 == 1023u));
                                                let _e1015 = ((10u * _e342) & 31u);
                                                let _e1018 = ((_e983.member[0] >> bitcast<u32>(_e1015)) & 1023u);
                                                let _e1023 = bitcast<f32>((bitcast<u32>(((_e594.member.member_1[1] - _e594.member.member[1]) * 0.0009775171f)) ^ _e132));
                                                let _e1029 = (_e594.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1018) * _e1023)) ^ _e132)));
                                                let _e1033 = select(select(_e594.member.member_1[1], _e1029, (_e1029 < _e594.member.member_1[1])), _e594.member.member_1[1], (_e1018 == 1023u));
                                                let _e1035 = ((10u * _e344) & 31u);
                                                let _e1038 = ((_e983.member[0] >> bitcast<u32>(_e1035)) & 1023u);
                                                let _e1043 = bitcast<f32>((bitcast<u32>(((_e594.member.member_1[2] - _e594.member.member[2]) * 0.0009775171f)) ^ _e132));
                                                let _e1049 = (_e594.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1038) * _e1043)) ^ _e132)));
                                                let _e1053 = select(select(_e594.member.member_1[2], _e1049, (_e1049 < _e594.member.member_1[2])), _e594.member.member_1[2], (_e1038 == 1023u));
                                                let _e1057 = ((_e983.member[1] >> bitcast<u32>(_e995)) & 1023u);
                                                let _e1063 = (_e594.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1057) * _e1003)) ^ _e132)));
                                                let _e1067 = select(select(_e594.member.member_1[0], _e1063, (_e1063 < _e594.member.member_1[0])), _e594.member.member_1[0], (_e1057 == 1023u));
                                                let _e1070 = ((_e983.member[1] >> bitcast<u32>(_e1015)) & 1023u);
                                                let _e1076 = (_e594.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1070) * _e1023)) ^ _e132)));
                                                let _e1080 = select(select(_e594.member.member_1[1], _e1076, (_e1076 < _e594.member.member_1[1])), _e594.member.member_1[1], (_e1070 == 1023u));
                                                let _e1083 = ((_e983.member[1] >> bitcast<u32>(_e1035)) & 1023u);
                                                let _e1089 = (_e594.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1083) * _e1043)) ^ _e132)));
                                                let _e1093 = select(select(_e594.member.member_1[2], _e1089, (_e1089 < _e594.member.member_1[2])), _e594.member.member_1[2], (_e1083 == 1023u));
                                                let _e1097 = ((_e983.member[2] >> bitcast<u32>(_e995)) & 1023u);
                                                let _e1103 = (_e594.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1097) * _e1003)) ^ _e132)));
                                                let _e1107 = select(select(_e594.member.member_1[0], _e1103, (_e1103 < _e594.member.member_1[0])), _e594.member.member_1[0], (_e1097 == 1023u));
                                                let _e1110 = ((_e983.member[2] >> bitcast<u32>(_e1015)) & 1023u);
                                                let _e1116 = (_e594.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1110) * _e1023)) ^ _e132)));
                                                let _e1120 = select(select(_e594.member.member_1[1], _e1116, (_e1116 < _e594.member.member_1[1])), _e594.member.member_1[1], (_e1110 == 1023u));
                                                let _e1123 = ((_e983.member[2] >> bitcast<u32>(_e1035)) & 1023u);
                                                let _e1129 = (_e594.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1123) * _e1043)) ^ _e132)));
                                                let _e1133 = select(select(_e594.member.member_1[2], _e1129, (_e1129 < _e594.member.member_1[2])), _e594.member.member_1[2], (_e1123 == 1023u));
                                                let _e1137 = (_e1053 - _e448);
                                                let _e1140 = (((_e1013 - _e375) * _e472) - (_e1137 * _e400));
                                                let _e1143 = (((_e1033 - _e412) * _e472) - (_e1137 * _e436));
                                                let _e1146 = (_e1093 - _e448);
                                                let _e1149 = (((_e1067 - _e375) * _e472) - (_e1146 * _e400));
                                                let _e1152 = (((_e1080 - _e412) * _e472) - (_e1146 * _e436));
                                                let _e1155 = (_e1133 - _e448);
                                                let _e1158 = (((_e1107 - _e375) * _e472) - (_e1155 * _e400));
                                                let _e1161 = (((_e1120 - _e412) * _e472) - (_e1155 * _e436));
                                                let _e1162 = (_e1158 * _e1152);
                                                let _e1163 = (_e1161 * _e1149);
                                                let _e1164 = (_e1140 * _e1161);
                                                let _e1165 = (_e1143 * _e1158);
                                                let _e1166 = (_e1149 * _e1143);
                                                let _e1167 = (_e1152 * _e1140);
                                                let _e1172 = (((_e1162 >= _e1163) && (_e1164 >= _e1165)) && (_e1166 >= _e1167));
                                                if (_e1172 || (((_e1162 <= _e1163) && (_e1164 <= _e1165)) && (_e1166 <= _e1167))) {
                                                    let _e1179 = select(-1f, 1f, _e1172);
                                                    let _e1181 = ((_e1162 - _e1163) * _e1179);
                                                    let _e1183 = select(0f, _e1181, (_e1181 > 0f));
                                                    let _e1185 = ((_e1164 - _e1165) * _e1179);
                                                    let _e1187 = select(0f, _e1185, (_e1185 > 0f));
                                                    let _e1189 = ((_e1166 - _e1167) * _e1179);
                                                    let _e1191 = select(0f, _e1189, (_e1189 > 0f));
                                                    let _e1193 = ((_e1183 + _e1187) + _e1191);
                                                    if (_e1193 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2146_ = type_22();
                                                        phi_2147_ = true;
                                                        phi_2148_ = false;
                                                    } else {
                                                        let _e1196 = select(_e1149, _e1140, (_e1140 < _e1149));
                                                        if (select(_e1158, _e1196, (_e1196 < _e1158)) > 0f) {
                                                            phi_1462_ = true;
                                                        } else {
                                                            let _e1201 = select(_e1149, _e1140, (_e1140 > _e1149));
                                                            phi_1462_ = (select(_e1158, _e1201, (_e1201 > _e1158)) < 0f);
                                                        }
                                                        let _e1206 = phi_1462_;
                                                        if _e1206 {
                                                            phi_2143_ = type_22();
                                                            phi_2144_ = true;
                                                            phi_2145_ = false;
                                                        } else {
                                                            let _e1208 = select(_e1152, _e1143, (_e1143 < _e1152));
                                                            if (select(_e1161, _e1208, (_e1208 < _e1161)) > 0f) {
                                                                phi_1491_ = true;
                                                            } else {
                                                                let _e1213 = select(_e1152, _e1143, (_e1143 > _e1152));
                                                                phi_1491_ = (select(_e1161, _e1213, (_e1213 > _e1161)) < 0f);
                                                            }
                                                            let _e1218 = phi_1491_;
                                                            if _e1218 {
                                                                phi_2141_ = type_22();
                                                                phi_2142_ = false;
                                                            } else {
                                                                let _e1220 = select(_e1067, _e1013, (_e1013 < _e1067));
                                                                let _e1224 = select(_e1067, _e1013, (_e1013 > _e1067));
                                                                let _e1228 = select(_e1080, _e1033, (_e1033 < _e1080));
                                                                let _e1232 = select(_e1080, _e1033, (_e1033 > _e1080));
                                                                let _e1236 = select(_e1093, _e1053, (_e1053 < _e1093));
                                                                let _e1240 = select(_e1093, _e1053, (_e1053 > _e1093));
                                                                let _e1245 = ((select(_e1107, _e1220, (_e1220 < _e1107)) - _e398) * _e403);
                                                                let _e1246 = ((select(_e1107, _e1224, (_e1224 > _e1107)) - _e399) * _e403);
                                                                let _e1249 = ((select(_e1120, _e1228, (_e1228 < _e1120)) - _e434) * _e439);
                                                                let _e1250 = ((select(_e1120, _e1232, (_e1232 > _e1120)) - _e435) * _e439);
                                                                let _e1253 = ((select(_e1133, _e1236, (_e1236 < _e1133)) - _e470) * _e475);
                                                                let _e1254 = ((select(_e1133, _e1240, (_e1240 > _e1133)) - _e471) * _e475);
                                                                let _e1256 = select(_e1254, _e1253, (_e1253 < _e1254));
                                                                let _e1258 = select(_e1254, _e1253, (_e1253 > _e1254));
                                                                let _e1260 = select(_e1246, _e1245, (_e1245 < _e1246));
                                                                let _e1262 = select(_e1250, _e1249, (_e1249 < _e1250));
                                                                let _e1264 = select(_e1262, _e1260, (_e1260 > _e1262));
                                                                let _e1266 = select(_e1256, _e1264, (_e1264 > _e1256));
                                                                let _e1268 = select(_e1246, _e1245, (_e1245 > _e1246));
                                                                let _e1270 = select(_e1250, _e1249, (_e1249 > _e1250));
                                                                let _e1272 = select(_e1270, _e1268, (_e1268 < _e1270));
                                                                let _e1274 = select(_e1258, _e1272, (_e1272 < _e1258));
                                                                let _e1275 = -(_e1256);
                                                                let _e1281 = select(_e521, _e1266, (_e1266 > _e521));
                                                                if (_e1281 > (_e1274 + (select(_e1275, _e1258, (_e1258 > _e1275)) * 0.0000019073523f))) {
                                                                    phi_2136_ = type_22();
                                                                    phi_2137_ = true;
                                                                } else {
                                                                    let _e1283 = (_e1281 > _e951.member_1);
                                                                    if _e1283 {
                                                                        phi_2135_ = type_22();
                                                                    } else {
                                                                        let _e1284 = vec3<f32>(_e1013, _e1033, _e1053);
                                                                        let _e1285 = vec3<f32>(_e1067, _e1080, _e1093);
                                                                        let _e1286 = vec3<f32>(_e1107, _e1120, _e1133);
                                                                        let _e1287 = (_e1067 - _e1013);
                                                                        let _e1288 = (_e1080 - _e1033);
                                                                        let _e1289 = (_e1093 - _e1053);
                                                                        let _e1290 = vec3<f32>(_e1287, _e1288, _e1289);
                                                                        let _e1291 = (_e1107 - _e1067);
                                                                        let _e1292 = (_e1120 - _e1080);
                                                                        let _e1293 = (_e1133 - _e1093);
                                                                        let _e1294 = vec3<f32>(_e1291, _e1292, _e1293);
                                                                        let _e1295 = (_e1013 - _e1107);
                                                                        let _e1296 = (_e1033 - _e1120);
                                                                        let _e1297 = (_e1053 - _e1133);
                                                                        let _e1298 = vec3<f32>(_e1295, _e1296, _e1297);
                                                                        let _e1301 = bitcast<f32>((bitcast<u32>(_e1287) & 2147483647u));
                                                                        let _e1304 = bitcast<f32>((bitcast<u32>(_e1288) & 2147483647u));
                                                                        let _e1306 = select(_e1304, _e1301, (_e1301 > _e1304));
                                                                        let _e1309 = bitcast<f32>((bitcast<u32>(_e1289) & 2147483647u));
                                                                        let _e1311 = select(_e1309, _e1306, (_e1306 > _e1309));
                                                                        let _e1314 = bitcast<f32>((bitcast<u32>(_e1291) & 2147483647u));
                                                                        let _e1317 = bitcast<f32>((bitcast<u32>(_e1292) & 2147483647u));
                                                                        let _e1319 = select(_e1317, _e1314, (_e1314 > _e1317));
                                                                        let _e1322 = bitcast<f32>((bitcast<u32>(_e1293) & 2147483647u));
                                                                        let _e1324 = select(_e1322, _e1319, (_e1319 > _e1322));
                                                                        let _e1327 = bitcast<f32>((bitcast<u32>(_e1295) & 2147483647u));
                                                                        let _e1330 = bitcast<f32>((bitcast<u32>(_e1296) & 2147483647u));
                                                                        let _e1332 = select(_e1330, _e1327, (_e1327 > _e1330));
                                                                        let _e1335 = bitcast<f32>((bitcast<u32>(_e1297) & 2147483647u));
                                                                        let _e1337 = select(_e1335, _e1332, (_e1332 > _e1335));
                                                                        let _e1339 = select(_e1324, _e1311, (_e1311 > _e1324));
                                                                        let _e1341 = select(_e1337, _e1339, (_e1339 > _e1337));
                                                                        if (_e1311 == _e1341) {
                                                                            phi_1868_ = _e1152;
                                                                            phi_1869_ = _e1149;
                                                                            phi_1870_ = _e1143;
                                                                            phi_1871_ = _e1140;
                                                                            phi_1872_ = _e1284;
                                                                            phi_1873_ = _e1298;
                                                                            phi_1874_ = _e1294;
                                                                            phi_1875_ = _e1290;
                                                                        } else {
                                                                            let _e1343 = (_e1324 == _e1341);
                                                                            let _e1348 = vec3(_e1343);
                                                                            phi_1868_ = select(_e1143, _e1161, _e1343);
                                                                            phi_1869_ = select(_e1140, _e1158, _e1343);
                                                                            phi_1870_ = select(_e1161, _e1152, _e1343);
                                                                            phi_1871_ = select(_e1158, _e1149, _e1343);
                                                                            phi_1872_ = select(_e1286, _e1285, _e1348);
                                                                            phi_1873_ = select(_e1294, _e1290, _e1348);
                                                                            phi_1874_ = select(_e1290, _e1298, _e1348);
                                                                            phi_1875_ = select(_e1298, _e1294, _e1348);
                                                                        }
                                                                        let _e1354 = phi_1868_;
                                                                        let _e1356 = phi_1869_;
                                                                        let _e1358 = phi_1870_;
                                                                        let _e1360 = phi_1871_;
                                                                        let _e1362 = phi_1872_;
                                                                        let _e1364 = phi_1873_;
                                                                        let _e1366 = phi_1874_;
                                                                        let _e1368 = phi_1875_;
                                                                        let _e1375 = ((_e1366.y * _e1364.z) - (_e1364.y * _e1366.z));
                                                                        let _e1380 = ((_e1366.z * _e1364.x) - (_e1364.z * _e1366.x));
                                                                        let _e1383 = ((_e1366.x * _e1364.y) - (_e1364.x * _e1366.y));
                                                                        if (_e1183 >= _e1187) {
                                                                            phi_1906_ = select(true, false, (_e1183 >= _e1191));
                                                                        } else {
                                                                            phi_1906_ = true;
                                                                        }
                                                                        let _e1388 = phi_1906_;
                                                                        if _e1388 {
                                                                            phi_1915_ = select(_e1286, _e1285, vec3((_e1187 >= _e1191)));
                                                                        } else {
                                                                            phi_1915_ = _e1284;
                                                                        }
                                                                        let _e1393 = phi_1915_;
                                                                        let _e1404 = (((_e1375 * (_e1393.x - _e375)) + (_e1380 * (_e1393.y - _e412))) + (_e1383 * (_e1393.z - _e448)));
                                                                        let _e1409 = (((_e1375 * _e400) + (_e1380 * _e436)) + (_e1383 * _e472));
                                                                        let _e1410 = (_e1356 - _e1360);
                                                                        let _e1411 = (_e1354 - _e1358);
                                                                        let _e1419 = (-(((_e1360 * _e1410) + (_e1358 * _e1411))) / ((_e1410 * _e1410) + (_e1411 * _e1411)));
                                                                        let _e1421 = select(1f, _e1419, (_e1419 < 1f));
                                                                        let _e1423 = select(0f, _e1421, (_e1421 > 0f));
                                                                        let _e1436 = ((_e1362.x + (_e1368.x * _e1423)) - _e375);
                                                                        let _e1437 = ((_e1362.y + (_e1368.y * _e1423)) - _e412);
                                                                        let _e1438 = ((_e1362.z + (_e1368.z * _e1423)) - _e448);
                                                                        let _e1439 = (_e1438 / _e472);
                                                                        let _e1451 = bitcast<f32>((bitcast<u32>(_e1436) & 2147483647u));
                                                                        let _e1454 = bitcast<f32>((bitcast<u32>(_e1437) & 2147483647u));
                                                                        let _e1456 = select(_e1454, _e1451, (_e1451 > _e1454));
                                                                        let _e1459 = bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u));
                                                                        let _e1461 = select(_e1459, _e1456, (_e1456 > _e1459));
                                                                        let _e1467 = bitcast<f32>((bitcast<u32>(_e1375) & 2147483647u));
                                                                        let _e1470 = bitcast<f32>((bitcast<u32>(_e1380) & 2147483647u));
                                                                        let _e1472 = select(_e1470, _e1467, (_e1467 > _e1470));
                                                                        let _e1475 = bitcast<f32>((bitcast<u32>(_e1383) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1375 * _e1436) + (_e1380 * _e1437)) + (_e1383 * _e1438)) - _e1404)) & 2147483647u)) <= ((0.0000009536743f * select(_e1341, _e1461, (_e1461 > _e1341))) * select(_e1475, _e1472, (_e1472 > _e1475)))) {
                                                                            let _e1485 = bitcast<f32>((bitcast<u32>(_e1366.x) & 2147483647u));
                                                                            let _e1488 = bitcast<f32>((bitcast<u32>(_e1366.y) & 2147483647u));
                                                                            let _e1490 = select(_e1488, _e1485, (_e1485 > _e1488));
                                                                            let _e1493 = bitcast<f32>((bitcast<u32>(_e1366.z) & 2147483647u));
                                                                            let _e1499 = bitcast<f32>((bitcast<u32>(_e1364.x) & 2147483647u));
                                                                            let _e1502 = bitcast<f32>((bitcast<u32>(_e1364.y) & 2147483647u));
                                                                            let _e1504 = select(_e1502, _e1499, (_e1499 > _e1502));
                                                                            let _e1507 = bitcast<f32>((bitcast<u32>(_e1364.z) & 2147483647u));
                                                                            let _e1511 = (bitcast<f32>((bitcast<u32>(_e1409) & 2147483647u)) > ((0.0000038146973f * select(_e1493, _e1490, (_e1490 > _e1493))) * select(_e1507, _e1504, (_e1504 > _e1507))));
                                                                            if _e1511 {
                                                                                phi_2080_ = (_e1404 / _e1409);
                                                                            } else {
                                                                                phi_2080_ = f32();
                                                                            }
                                                                            let _e1514 = phi_2080_;
                                                                            phi_2082_ = _e1514;
                                                                            phi_2083_ = select(true, false, _e1511);
                                                                        } else {
                                                                            phi_2082_ = f32();
                                                                            phi_2083_ = true;
                                                                        }
                                                                        let _e1517 = phi_2082_;
                                                                        let _e1519 = phi_2083_;
                                                                        if _e1519 {
                                                                            let _e1527 = (((_e1375 * (_e1436 - (_e400 * _e1439))) + (_e1380 * (_e1437 - (_e436 * _e1439)))) / _e1409);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1527) & 2147483647u)) <= _e1341) {
                                                                                phi_2103_ = (_e1439 + _e1527);
                                                                            } else {
                                                                                phi_2103_ = _e1439;
                                                                            }
                                                                            let _e1534 = phi_2103_;
                                                                            phi_2104_ = _e1534;
                                                                        } else {
                                                                            phi_2104_ = _e1517;
                                                                        }
                                                                        let _e1536 = phi_2104_;
                                                                        let _e1538 = select(_e1274, _e1536, (_e1536 < _e1274));
                                                                        let _e1540 = select(_e1266, _e1538, (_e1538 > _e1266));
                                                                        if (_e1540 >= _e521) {
                                                                            let _e1542 = (_e1540 <= _e951.member_1);
                                                                            if _e1542 {
                                                                                let _e1543 = (1f / _e1193);
                                                                                phi_2127_ = type_22(_e1540, (_e1187 * _e1543), (_e1191 * _e1543), _e979);
                                                                            } else {
                                                                                phi_2127_ = type_22();
                                                                            }
                                                                            let _e1548 = phi_2127_;
                                                                            phi_2129_ = _e1548;
                                                                            phi_2130_ = select(true, false, _e1542);
                                                                        } else {
                                                                            phi_2129_ = type_22();
                                                                            phi_2130_ = true;
                                                                        }
                                                                        let _e1551 = phi_2129_;
                                                                        let _e1553 = phi_2130_;
                                                                        if _e1553 {
                                                                            phi_2134_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2134_ = _e1551;
                                                                        }
                                                                        let _e1555 = phi_2134_;
                                                                        phi_2135_ = _e1555;
                                                                    }
                                                                    let _e1557 = phi_2135_;
                                                                    phi_2136_ = _e1557;
                                                                    phi_2137_ = _e1283;
                                                                }
                                                                let _e1559 = phi_2136_;
                                                                let _e1561 = phi_2137_;
                                                                phi_2141_ = _e1559;
                                                                phi_2142_ = _e1561;
                                                            }
                                                            let _e1563 = phi_2141_;
                                                            let _e1565 = phi_2142_;
                                                            phi_2143_ = _e1563;
                                                            phi_2144_ = _e1218;
                                                            phi_2145_ = _e1565;
                                                        }
                                                        let _e1567 = phi_2143_;
                                                        let _e1569 = phi_2144_;
                                                        let _e1571 = phi_2145_;
                                                        phi_2146_ = _e1567;
                                                        phi_2147_ = _e1569;
                                                        phi_2148_ = _e1571;
                                                    }
                                                    let _e1573 = phi_2146_;
                                                    let _e1575 = phi_2147_;
                                                    let _e1577 = phi_2148_;
                                                    phi_2156_ = _e1573;
                                                    phi_2157_ = select(_e1577, true, _e1575);
                                                } else {
                                                    phi_2156_ = type_22();
                                                    phi_2157_ = true;
                                                }
                                                let _e1580 = phi_2156_;
                                                let _e1582 = phi_2157_;
                                                if _e1582 {
                                                    phi_2161_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2161_ = _e1580;
                                                }
                                                let _e1584 = phi_2161_;
                                                if (_e1584.member_3 != 4294967295u) {
                                                    if (_e979 == _e149) {
                                                        phi_2478_ = false;
                                                    } else {
                                                        let _e1588 = (_e979 < arrayLength((&global_4.member)));
                                                        if _e1588 {
                                                            if _e1588 {
                                                            } else {
                                                                phi_3642_ = true;
                                                                break;
                                                            }
                                                            let _e1590 = global_4.member[_e979];
                                                            phi_2184_ = _e1590;
                                                        } else {
                                                            phi_2184_ = 4294967295u;
                                                        }
                                                        let _e1592 = phi_2184_;
                                                        let _e1593 = (_e1592 < arrayLength((&global_5.member)));
                                                        if _e1593 {
                                                            if _e1593 {
                                                            } else {
                                                                phi_3642_ = true;
                                                                break;
                                                            }
                                                            let _e1595 = global_5.member[_e1592];
                                                            phi_2198_ = _e1595;
                                                        } else {
                                                            phi_2198_ = 0i;
                                                        }
                                                        let _e1597 = phi_2198_;
                                                        let _e1598 = (_e1597 == 0i);
                                                        if _e1598 {
                                                            phi_2477_ = true;
                                                        } else {
                                                            if _e367 {
                                                                phi_2215_ = vec3<f32>(_e1013, _e1033, _e1053);
                                                            } else {
                                                                if (_e343 == 1u) {
                                                                    phi_2214_ = vec3<f32>(_e1053, _e1013, _e1033);
                                                                } else {
                                                                    phi_2214_ = vec3<f32>(_e1033, _e1053, _e1013);
                                                                }
                                                                let _e1603 = phi_2214_;
                                                                phi_2215_ = _e1603;
                                                            }
                                                            let _e1606 = phi_2215_;
                                                            if _e367 {
                                                                phi_2228_ = vec3<f32>(_e1067, _e1080, _e1093);
                                                            } else {
                                                                if (_e343 == 1u) {
                                                                    phi_2227_ = vec3<f32>(_e1093, _e1067, _e1080);
                                                                } else {
                                                                    phi_2227_ = vec3<f32>(_e1080, _e1093, _e1067);
                                                                }
                                                                let _e1611 = phi_2227_;
                                                                phi_2228_ = _e1611;
                                                            }
                                                            let _e1614 = phi_2228_;
                                                            if _e367 {
                                                                phi_2241_ = vec3<f32>(_e1107, _e1120, _e1133);
                                                            } else {
                                                                if (_e343 == 1u) {
                                                                    phi_2240_ = vec3<f32>(_e1133, _e1107, _e1120);
                                                                } else {
                                                                    phi_2240_ = vec3<f32>(_e1120, _e1133, _e1107);
                                                                }
                                                                let _e1619 = phi_2240_;
                                                                phi_2241_ = _e1619;
                                                            }
                                                            let _e1622 = phi_2241_;
                                                            let _e1625 = (_e1614.x - _e1606.x);
                                                            let _e1628 = (_e1614.y - _e1606.y);
                                                            let _e1631 = (_e1614.z - _e1606.z);
                                                            let _e1633 = (_e1622.x - _e1606.x);
                                                            let _e1635 = (_e1622.y - _e1606.y);
                                                            let _e1637 = (_e1622.z - _e1606.z);
                                                            if (_e221.member_1 == 1u) {
                                                                phi_2277_ = (vec3<f32>(_e221.member[0], _e221.member[1], _e221.member[2]) - _e1606);
                                                            } else {
                                                                phi_2277_ = vec3<f32>(_e221.member[0], _e221.member[1], _e221.member[2]);
                                                            }
                                                            let _e1652 = phi_2277_;
                                                            let _e1658 = bitcast<f32>((bitcast<u32>((_e1625 * _e1635)) ^ _e221.member_3[0]));
                                                            let _e1662 = bitcast<f32>((bitcast<u32>((_e1628 * _e1633)) ^ _e221.member_3[0]));
                                                            let _e1666 = bitcast<f32>((bitcast<u32>((_e1628 * _e1637)) ^ _e221.member_3[0]));
                                                            let _e1670 = bitcast<f32>((bitcast<u32>((_e1631 * _e1635)) ^ _e221.member_3[0]));
                                                            let _e1674 = bitcast<f32>((bitcast<u32>((_e1631 * _e1633)) ^ _e221.member_3[0]));
                                                            let _e1678 = bitcast<f32>((bitcast<u32>((_e1625 * _e1637)) ^ _e221.member_3[0]));
                                                            let _e1679 = (_e1666 - _e1670);
                                                            let _e1680 = (_e1674 - _e1678);
                                                            let _e1681 = (_e1658 - _e1662);
                                                            let _e1705 = (bitcast<f32>((bitcast<u32>(_e1666) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1670) & 2147483647u)));
                                                            let _e1712 = (bitcast<f32>((bitcast<u32>(_e1674) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1678) & 2147483647u)));
                                                            let _e1719 = (bitcast<f32>((bitcast<u32>(_e1658) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1662) & 2147483647u)));
                                                            if (_e221.member_2 == 0f) {
                                                                phi_2459_ = 0f;
                                                            } else {
                                                                let _e1749 = bitcast<f32>((bitcast<u32>(_e1679) & 2147483647u));
                                                                let _e1752 = bitcast<f32>((bitcast<u32>(_e1680) & 2147483647u));
                                                                let _e1755 = bitcast<f32>((bitcast<u32>(_e1681) & 2147483647u));
                                                                let _e1757 = select(_e1755, _e1752, (_e1752 > _e1755));
                                                                let _e1761 = select(_e1755, _e1752, (_e1752 < _e1755));
                                                                let _e1765 = select(_e1752, _e1749, (_e1749 < _e1752));
                                                                let _e1767 = select(_e1752, _e1749, (_e1749 > _e1752));
                                                                let _e1769 = select(_e1755, _e1767, (_e1767 < _e1755));
                                                                phi_2459_ = bitcast<f32>((bitcast<u32>((_e221.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1757, _e1749, (_e1749 > _e1757)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1769, _e1765, (_e1765 > _e1769)))) ^ _e221.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1761, _e1749, (_e1749 < _e1761)))) ^ _e221.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1705 + _e1712) + _e1719))) ^ _e221.member_3[0]))) * 1.0000005f)) ^ _e221.member_3[0])))) ^ _e221.member_3[0]));
                                                            }
                                                            let _e1796 = phi_2459_;
                                                            phi_2477_ = (_e1598 || !(((((bitcast<f32>((bitcast<u32>((_e1652.x * _e1679)) ^ _e221.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1652.y * _e1680)) ^ _e221.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1652.z * _e1681)) ^ _e221.member_3[0]))) * f32(-(_e1597))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1652.x) & 2147483647u)) * _e1705)) ^ _e221.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1652.y) & 2147483647u)) * _e1712)) ^ _e221.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1652.z) & 2147483647u)) * _e1719)) ^ _e221.member_3[0]))))) ^ _e221.member_3[0])) + _e1796) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1810 = phi_2477_;
                                                        phi_2478_ = _e1810;
                                                    }
                                                    let _e1812 = phi_2478_;
                                                    if _e1812 {
                                                        if (_e1584.member < _e951.member.member) {
                                                            phi_2498_ = true;
                                                        } else {
                                                            if (_e1584.member == _e951.member.member) {
                                                                phi_2497_ = (_e1584.member_3 < _e951.member.member_3);
                                                            } else {
                                                                phi_2497_ = false;
                                                            }
                                                            let _e1822 = phi_2497_;
                                                            phi_2498_ = _e1822;
                                                        }
                                                        let _e1824 = phi_2498_;
                                                        if _e1824 {
                                                            phi_2504_ = type_38(_e1584, _e1584.member);
                                                        } else {
                                                            phi_2504_ = _e951;
                                                        }
                                                        let _e1827 = phi_2504_;
                                                        phi_2505_ = _e1827;
                                                    } else {
                                                        phi_2505_ = _e951;
                                                    }
                                                    let _e1829 = phi_2505_;
                                                    phi_2506_ = _e1829;
                                                } else {
                                                    phi_2506_ = _e951;
                                                }
                                                let _e1831 = phi_2506_;
                                                phi_1020_ = _e1831;
                                            } else {
                                                phi_1020_ = type_38();
                                            }
                                            let _e1833 = phi_1020_;
                                            continue;
                                            continuing {
                                                phi_1019_ = _e1833;
                                                phi_1022_ = _e966;
                                                phi_3642_ = _e553;
                                                break if !(_e972);
                                            }
                                        }
                                        let _e1836 = phi_3642_;
                                        phi_3826_ = _e1836;
                                        if _e1836 {
                                            break;
                                        }
                                        phi_3830_ = _e1836;
                                        let _e2063 = local_11;
                                        phi_3455_ = _e2063;
                                        phi_3456_ = _e594;
                                        phi_3457_ = false;
                                        phi_3458_ = _e598;
                                    } else {
                                        let _e608 = (_e594.member_1 < _e89);
                                        if _e608 {
                                            if _e608 {
                                            } else {
                                                phi_3826_ = true;
                                                break;
                                            }
                                            let _e610 = global_9.member[_e594.member_1];
                                            phi_2525_ = _e610;
                                        } else {
                                            phi_2525_ = type_48(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e612 = phi_2525_;
                                        let _e627 = ((10u * _e343) & 31u);
                                        let _e630 = ((_e612.member[0] >> bitcast<u32>(_e627)) & 1023u);
                                        let _e635 = bitcast<f32>((bitcast<u32>(((_e594.member.member_1[0] - _e594.member.member[0]) * 0.0009775171f)) ^ _e132));
                                        let _e641 = (_e594.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e630) * _e635)) ^ _e132)));
                                        let _e645 = select(select(_e594.member.member_1[0], _e641, (_e641 < _e594.member.member_1[0])), _e594.member.member_1[0], (_e630 == 1023u));
                                        let _e647 = ((10u * _e342) & 31u);
                                        let _e650 = ((_e612.member[0] >> bitcast<u32>(_e647)) & 1023u);
                                        let _e655 = bitcast<f32>((bitcast<u32>(((_e594.member.member_1[1] - _e594.member.member[1]) * 0.0009775171f)) ^ _e132));
                                        let _e661 = (_e594.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e650) * _e655)) ^ _e132)));
                                        let _e665 = select(select(_e594.member.member_1[1], _e661, (_e661 < _e594.member.member_1[1])), _e594.member.member_1[1], (_e650 == 1023u));
                                        let _e667 = ((10u * _e344) & 31u);
                                        let _e670 = ((_e612.member[0] >> bitcast<u32>(_e667)) & 1023u);
                                        let _e675 = bitcast<f32>((bitcast<u32>(((_e594.member.member_1[2] - _e594.member.member[2]) * 0.0009775171f)) ^ _e132));
                                        let _e681 = (_e594.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e670) * _e675)) ^ _e132)));
                                        let _e685 = select(select(_e594.member.member_1[2], _e681, (_e681 < _e594.member.member_1[2])), _e594.member.member_1[2], (_e670 == 1023u));
                                        let _e688 = ((_e612.member[1] >> bitcast<u32>(_e627)) & 1023u);
                                        let _e694 = (_e594.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e688) * _e635)) ^ _e132)));
                                        let _e698 = select(select(_e594.member.member_1[0], _e694, (_e694 < _e594.member.member_1[0])), _e594.member.member_1[0], (_e688 == 1023u));
                                        let _e701 = ((_e612.member[1] >> bitcast<u32>(_e647)) & 1023u);
                                        let _e707 = (_e594.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e701) * _e655)) ^ _e132)));
                                        let _e711 = select(select(_e594.member.member_1[1], _e707, (_e707 < _e594.member.member_1[1])), _e594.member.member_1[1], (_e701 == 1023u));
                                        let _e714 = ((_e612.member[1] >> bitcast<u32>(_e667)) & 1023u);
                                        let _e720 = (_e594.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e714) * _e675)) ^ _e132)));
                                        let _e724 = select(select(_e594.member.member_1[2], _e720, (_e720 < _e594.member.member_1[2])), _e594.member.member_1[2], (_e714 == 1023u));
                                        let _e730 = ((_e612.member_1[0] >> bitcast<u32>(_e627)) & 1023u);
                                        let _e736 = (_e594.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e730) * _e635)) ^ _e132)));
                                        let _e740 = select(select(_e594.member.member_1[0], _e736, (_e736 < _e594.member.member_1[0])), _e594.member.member_1[0], (_e730 == 1023u));
                                        let _e743 = ((_e612.member_1[0] >> bitcast<u32>(_e647)) & 1023u);
                                        let _e749 = (_e594.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e743) * _e655)) ^ _e132)));
                                        let _e753 = select(select(_e594.member.member_1[1], _e749, (_e749 < _e594.member.member_1[1])), _e594.member.member_1[1], (_e743 == 1023u));
                                        let _e756 = ((_e612.member_1[0] >> bitcast<u32>(_e667)) & 1023u);
                                        let _e762 = (_e594.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e756) * _e675)) ^ _e132)));
                                        let _e766 = select(select(_e594.member.member_1[2], _e762, (_e762 < _e594.member.member_1[2])), _e594.member.member_1[2], (_e756 == 1023u));
                                        let _e769 = ((_e612.member_1[1] >> bitcast<u32>(_e627)) & 1023u);
                                        let _e775 = (_e594.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e769) * _e635)) ^ _e132)));
                                        let _e779 = select(select(_e594.member.member_1[0], _e775, (_e775 < _e594.member.member_1[0])), _e594.member.member_1[0], (_e769 == 1023u));
                                        let _e782 = ((_e612.member_1[1] >> bitcast<u32>(_e647)) & 1023u);
                                        let _e788 = (_e594.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e782) * _e655)) ^ _e132)));
                                        let _e792 = select(select(_e594.member.member_1[1], _e788, (_e788 < _e594.member.member_1[1])), _e594.member.member_1[1], (_e782 == 1023u));
                                        let _e795 = ((_e612.member_1[1] >> bitcast<u32>(_e667)) & 1023u);
                                        let _e801 = (_e594.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e795) * _e675)) ^ _e132)));
                                        let _e805 = select(select(_e594.member.member_1[2], _e801, (_e801 < _e594.member.member_1[2])), _e594.member.member_1[2], (_e795 == 1023u));
                                        let _e810 = type_61(type_53(array<f32, 3>(_e645, _e665, _e685), array<f32, 3>(_e698, _e711, _e724)), _e612.member_2);
                                        let _e815 = type_61(type_53(array<f32, 3>(_e740, _e753, _e766), array<f32, 3>(_e779, _e792, _e805)), _e612.member_3);
                                        let _e821 = ((_e645 - _e398) * _e403);
                                        let _e822 = ((_e740 - _e398) * _e403);
                                        let _e823 = ((_e698 - _e399) * _e403);
                                        let _e824 = ((_e779 - _e399) * _e403);
                                        let _e829 = ((_e665 - _e434) * _e439);
                                        let _e830 = ((_e753 - _e434) * _e439);
                                        let _e831 = ((_e711 - _e435) * _e439);
                                        let _e832 = ((_e792 - _e435) * _e439);
                                        let _e837 = ((_e685 - _e470) * _e475);
                                        let _e838 = ((_e766 - _e470) * _e475);
                                        let _e839 = ((_e724 - _e471) * _e475);
                                        let _e840 = ((_e805 - _e471) * _e475);
                                        let _e842 = select(_e839, _e837, (_e837 < _e839));
                                        let _e844 = select(_e840, _e838, (_e838 < _e840));
                                        let _e846 = select(_e839, _e837, (_e837 > _e839));
                                        let _e848 = select(_e840, _e838, (_e838 > _e840));
                                        let _e850 = select(_e823, _e821, (_e821 < _e823));
                                        let _e852 = select(_e824, _e822, (_e822 < _e824));
                                        let _e854 = select(_e831, _e829, (_e829 < _e831));
                                        let _e856 = select(_e832, _e830, (_e830 < _e832));
                                        let _e858 = select(_e854, _e850, (_e850 > _e854));
                                        let _e860 = select(_e856, _e852, (_e852 > _e856));
                                        let _e862 = select(_e842, _e858, (_e858 > _e842));
                                        let _e864 = select(_e844, _e860, (_e860 > _e844));
                                        let _e866 = select(_e823, _e821, (_e821 > _e823));
                                        let _e868 = select(_e824, _e822, (_e822 > _e824));
                                        let _e870 = select(_e831, _e829, (_e829 > _e831));
                                        let _e872 = select(_e832, _e830, (_e830 > _e832));
                                        let _e874 = select(_e870, _e866, (_e866 < _e870));
                                        let _e876 = select(_e872, _e868, (_e868 < _e872));
                                        let _e881 = -(_e842);
                                        let _e882 = -(_e844);
                                        let _e889 = (select(_e846, _e874, (_e874 < _e846)) + (select(_e881, _e846, (_e846 > _e881)) * 0.0000019073523f));
                                        let _e890 = (select(_e848, _e876, (_e876 < _e848)) + (select(_e882, _e848, (_e848 > _e882)) * 0.0000019073523f));
                                        let _e892 = select(_e521, _e862, (_e862 > _e521));
                                        let _e894 = select(_e521, _e864, (_e864 > _e521));
                                        let _e899 = (_e892 <= select(_e555.member_1, _e889, (_e889 < _e555.member_1)));
                                        let _e900 = (_e894 <= select(_e555.member_1, _e890, (_e890 < _e555.member_1)));
                                        let _e901 = (_e892 <= _e894);
                                        if _e899 {
                                            if _e900 {
                                                if _e901 {
                                                    phi_3357_ = _e815;
                                                } else {
                                                    phi_3357_ = _e810;
                                                }
                                                let _e903 = phi_3357_;
                                                let _e911 = (_e598 % 128u);
                                                let _e912 = (_e911 < 128u);
                                                if _e912 {
                                                } else {
                                                    phi_3826_ = true;
                                                    break;
                                                }
                                                local_6[_e911] = _e903.member_1;
                                                if _e912 {
                                                } else {
                                                    phi_3826_ = true;
                                                    break;
                                                }
                                                local_5[_e911] = _e903.member.member[0];
                                                if _e912 {
                                                } else {
                                                    phi_3826_ = true;
                                                    break;
                                                }
                                                local_4[_e911] = _e903.member.member[1];
                                                if _e912 {
                                                } else {
                                                    phi_3826_ = true;
                                                    break;
                                                }
                                                local_3[_e911] = _e903.member.member[2];
                                                if _e912 {
                                                } else {
                                                    phi_3826_ = true;
                                                    break;
                                                }
                                                local_2[_e911] = _e903.member.member_1[0];
                                                if _e912 {
                                                } else {
                                                    phi_3826_ = true;
                                                    break;
                                                }
                                                local_1[_e911] = _e903.member.member_1[1];
                                                if _e912 {
                                                } else {
                                                    phi_3826_ = true;
                                                    break;
                                                }
                                                local[_e911] = _e903.member.member_1[2];
                                                if _e912 {
                                                } else {
                                                    phi_3826_ = true;
                                                    break;
                                                }
                                                local_7[_e911] = select(_e894, _e892, (_e892 > _e894));
                                                if _e901 {
                                                    phi_3434_ = _e810;
                                                } else {
                                                    phi_3434_ = _e815;
                                                }
                                                let _e929 = phi_3434_;
                                                phi_3435_ = _e929;
                                                phi_3436_ = (_e598 + 1u);
                                            } else {
                                                phi_3435_ = type_61();
                                                phi_3436_ = u32();
                                            }
                                            let _e931 = phi_3435_;
                                            let _e933 = phi_3436_;
                                            phi_3438_ = _e931;
                                            phi_3439_ = _e933;
                                            phi_3440_ = select(true, false, _e900);
                                        } else {
                                            phi_3438_ = type_61();
                                            phi_3439_ = u32();
                                            phi_3440_ = true;
                                        }
                                        let _e936 = phi_3438_;
                                        let _e938 = phi_3439_;
                                        let _e940 = phi_3440_;
                                        if _e940 {
                                            if _e899 {
                                                phi_3447_ = _e810;
                                            } else {
                                                phi_3447_ = _e815;
                                            }
                                            let _e942 = phi_3447_;
                                            phi_3452_ = _e942;
                                            phi_3453_ = select(_e900, true, _e899);
                                        } else {
                                            phi_3452_ = _e936;
                                            phi_3453_ = _e596;
                                        }
                                        let _e945 = phi_3452_;
                                        let _e947 = phi_3453_;
                                        phi_3830_ = _e553;
                                        phi_3455_ = _e555;
                                        phi_3456_ = _e945;
                                        phi_3457_ = _e947;
                                        phi_3458_ = select(_e938, _e598, _e940);
                                    }
                                    let _e1838 = phi_3830_;
                                    let _e1840 = phi_3455_;
                                    let _e1842 = phi_3456_;
                                    let _e1844 = phi_3457_;
                                    let _e1846 = phi_3458_;
                                    phi_3829_ = _e1838;
                                    phi_3459_ = _e1840;
                                    phi_3460_ = _e1842;
                                    phi_3461_ = (_e559 - 1u);
                                    phi_3462_ = _e1844;
                                    phi_3463_ = _e1846;
                                } else {
                                    phi_3829_ = _e553;
                                    phi_3459_ = _e555;
                                    phi_3460_ = _e594;
                                    phi_3461_ = _e559;
                                    phi_3462_ = _e596;
                                    phi_3463_ = _e598;
                                }
                                let _e1848 = phi_3829_;
                                let _e1850 = phi_3459_;
                                let _e1852 = phi_3460_;
                                let _e1854 = phi_3461_;
                                let _e1856 = phi_3462_;
                                let _e1858 = phi_3463_;
                                phi_3828_ = _e1848;
                                phi_3464_ = _e1850;
                                phi_3465_ = _e1852;
                                phi_3466_ = _e1854;
                                phi_3467_ = _e1856;
                                phi_3468_ = _e1858;
                            } else {
                                phi_3828_ = _e553;
                                phi_3464_ = type_38();
                                phi_3465_ = type_61();
                                phi_3466_ = u32();
                                phi_3467_ = bool();
                                phi_3468_ = u32();
                            }
                            let _e1860 = phi_3828_;
                            let _e1862 = phi_3464_;
                            let _e1864 = phi_3465_;
                            let _e1866 = phi_3466_;
                            let _e1868 = phi_3467_;
                            let _e1870 = phi_3468_;
                            phi_3827_ = _e1860;
                            phi_893_ = _e1862;
                            phi_896_ = _e1864;
                            phi_898_ = _e1866;
                            phi_900_ = _e1868;
                            phi_902_ = _e1870;
                            phi_3469_ = _e567;
                        } else {
                            phi_3827_ = _e553;
                            phi_893_ = type_38();
                            phi_896_ = type_61();
                            phi_898_ = u32();
                            phi_900_ = bool();
                            phi_902_ = u32();
                            phi_3469_ = false;
                        }
                        let _e1872 = phi_3827_;
                        let _e1874 = phi_893_;
                        let _e1876 = phi_896_;
                        let _e1878 = phi_898_;
                        let _e1880 = phi_900_;
                        let _e1882 = phi_902_;
                        let _e1884 = phi_3469_;
                        continue;
                        continuing {
                            phi_3648_ = _e1872;
                            phi_892_ = _e1874;
                            phi_895_ = _e1876;
                            phi_897_ = _e1878;
                            phi_899_ = _e1880;
                            phi_901_ = _e1882;
                            phi_3826_ = _e1872;
                            break if !(_e1884);
                        }
                    }
                    let _e1887 = phi_3826_;
                    if _e1887 {
                        break;
                    }
                    let _e1889 = local_10;
                    if (_e1889.member.member_3 != 4294967295u) {
                        let _e1894 = (_e345 / 3i);
                        let _e1901 = bitcast<f32>((bitcast<u32>((_e1894 + 127i)) << bitcast<u32>(23i)));
                        let _e1909 = (((_e1889.member.member * _e1901) * _e1901) * bitcast<f32>((bitcast<u32>(((_e345 - (2i * _e1894)) + 127i)) << bitcast<u32>(23i))));
                        let _e1911 = select(340282350000000000000000000000000000000f, _e1909, (_e1909 < 340282350000000000000000000000000000000f));
                        phi_3521_ = type_22(select(-340282350000000000000000000000000000000f, _e1911, (_e1911 > -340282350000000000000000000000000000000f)), _e1889.member.member_1, _e1889.member.member_2, _e1889.member.member_3);
                    } else {
                        phi_3521_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1918 = phi_3521_;
                    if _e222 {
                    } else {
                        break;
                    }
                    global_7.member[_e136] = _e1918;
                    if _e143 {
                    } else {
                        break;
                    }
                    let _e1922 = select(0u, 1u, (_e289 <= _e299));
                    if (_e1922 > 0u) {
                        let _e1924 = (1u < _e104);
                        if _e1924 {
                            if (0u < _e104) {
                            } else {
                                break;
                            }
                            let _e1928 = atomicAdd((&global_8.member[0u]), _e1922);
                            if ((_e1928 + _e1922) < _e1928) {
                                if _e1924 {
                                } else {
                                    break;
                                }
                                let _e1933 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1936 = select(0u, 1u, (_e1918.member_3 != 4294967295u));
                    if (_e1936 > 0u) {
                        let _e1938 = (3u < _e104);
                        if _e1938 {
                            if (2u < _e104) {
                            } else {
                                break;
                            }
                            let _e1942 = atomicAdd((&global_8.member[2u]), _e1936);
                            if ((_e1942 + _e1936) < _e1942) {
                                if _e1938 {
                                } else {
                                    break;
                                }
                                let _e1947 = atomicAdd((&global_8.member[3u]), 1u);
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
fn trace_paths_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
