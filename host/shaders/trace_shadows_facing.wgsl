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
    var phi_232_: u32;
    var phi_276_: i32;
    var phi_416_: type_47;
    var phi_566_: i32;
    var phi_567_: i32;
    var phi_577_: bool;
    var phi_587_: u32;
    var phi_588_: u32;
    var phi_590_: bool;
    var phi_595_: u32;
    var phi_628_: i32;
    var phi_646_: f32;
    var phi_652_: f32;
    var phi_692_: f32;
    var phi_698_: f32;
    var phi_750_: f32;
    var phi_762_: f32;
    var phi_771_: f32;
    var phi_777_: f32;
    var phi_817_: f32;
    var phi_823_: f32;
    var phi_875_: f32;
    var phi_887_: f32;
    var phi_896_: f32;
    var phi_902_: f32;
    var phi_942_: f32;
    var phi_948_: f32;
    var phi_1000_: f32;
    var phi_1012_: f32;
    var phi_1067_: i32;
    var phi_1089_: u32;
    var phi_1090_: u32;
    var phi_1127_: i32;
    var phi_1149_: u32;
    var phi_1150_: u32;
    var phi_1158_: f32;
    var phi_1159_: f32;
    var phi_3197_: bool;
    var phi_1174_: type_55;
    var phi_1177_: bool;
    var phi_1179_: u32;
    var phi_1181_: u32;
    var phi_1183_: u32;
    var phi_1194_: bool;
    var phi_1226_: bool;
    var phi_1227_: u32;
    var phi_1228_: u32;
    var phi_2694_: type_54;
    var phi_3056_: u32;
    var phi_3084_: u32;
    var phi_3085_: u32;
    var phi_3086_: u32;
    var phi_3088_: u32;
    var phi_3089_: u32;
    var phi_3090_: bool;
    var phi_3099_: u32;
    var phi_3104_: bool;
    var phi_3106_: u32;
    var phi_1243_: type_55;
    var phi_1246_: type_8;
    var phi_1247_: type_8;
    var phi_1269_: type_8;
    var phi_1290_: u32;
    var phi_1382_: array<array<f32, 3>, 3>;
    var phi_1534_: bool;
    var phi_1563_: bool;
    var phi_1982_: f32;
    var phi_1983_: f32;
    var phi_1984_: f32;
    var phi_1985_: f32;
    var phi_1986_: vec3<f32>;
    var phi_1987_: vec3<f32>;
    var phi_1988_: vec3<f32>;
    var phi_1989_: vec3<f32>;
    var phi_2026_: bool;
    var phi_2035_: vec3<f32>;
    var phi_2200_: f32;
    var phi_2202_: f32;
    var phi_2203_: bool;
    var phi_2223_: f32;
    var phi_2224_: f32;
    var phi_2247_: type_28;
    var phi_2249_: type_28;
    var phi_2250_: bool;
    var phi_2254_: type_28;
    var phi_2255_: type_28;
    var phi_2256_: type_28;
    var phi_2257_: bool;
    var phi_2261_: type_28;
    var phi_2262_: bool;
    var phi_2263_: type_28;
    var phi_2264_: bool;
    var phi_2265_: bool;
    var phi_2266_: type_28;
    var phi_2267_: bool;
    var phi_2268_: bool;
    var phi_2276_: type_28;
    var phi_2277_: bool;
    var phi_2281_: type_28;
    var phi_2304_: u32;
    var phi_2318_: i32;
    var phi_2340_: vec3<f32>;
    var phi_2341_: vec3<f32>;
    var phi_2359_: vec3<f32>;
    var phi_2360_: vec3<f32>;
    var phi_2378_: vec3<f32>;
    var phi_2379_: vec3<f32>;
    var phi_2415_: vec3<f32>;
    var phi_2597_: f32;
    var phi_2615_: bool;
    var phi_2616_: bool;
    var phi_2621_: type_55;
    var phi_2622_: type_55;
    var phi_1244_: type_55;
    var phi_3191_: bool;
    var local_2: type_55;
    var phi_3387_: bool;
    var phi_3110_: type_55;
    var phi_3111_: bool;
    var phi_3112_: u32;
    var phi_3113_: u32;
    var phi_3386_: bool;
    var phi_3114_: type_55;
    var phi_3115_: bool;
    var phi_3116_: u32;
    var phi_3117_: u32;
    var phi_3118_: u32;
    var phi_3385_: bool;
    var phi_3119_: type_55;
    var phi_3120_: bool;
    var phi_3121_: u32;
    var phi_3122_: u32;
    var phi_3123_: u32;
    var phi_3384_: bool;
    var phi_1175_: type_55;
    var phi_1178_: bool;
    var phi_1180_: u32;
    var phi_1182_: u32;
    var phi_1184_: u32;
    var phi_3124_: bool;
    var phi_3383_: bool;
    var local_3: type_55;
    var local_4: type_55;

    switch bitcast<i32>(0u) {
        default: {
            let _e80 = global;
            let _e82 = arrayLength((&global_4.member));
            let _e84 = arrayLength((&global_2.member));
            let _e96 = arrayLength((&global_7.member));
            let _e100 = (_e80.x + (_e80.y * 2097152u));
            let _e101 = (_e100 < arrayLength((&global_8.member)));
            if _e101 {
                if _e101 {
                } else {
                    break;
                }
                let _e105 = global_8.member[_e100].member_2;
                phi_232_ = _e105;
            } else {
                phi_232_ = 4294967295u;
            }
            let _e107 = phi_232_;
            let _e110 = global_1.member[0u];
            let _e114 = global_3.member[0u][0u];
            let _e118 = global_3.member[0u][1u];
            let _e122 = global_3.member[0u][2u];
            let _e126 = global_3.member[0u][3u];
            let _e130 = global_3.member[1u][0u];
            let _e134 = global_3.member[1u][1u];
            let _e138 = global_3.member[1u][2u];
            let _e142 = global_3.member[1u][3u];
            let _e143 = bitcast<f32>(_e114);
            let _e144 = bitcast<f32>(_e118);
            let _e145 = bitcast<f32>(_e122);
            let _e147 = bitcast<f32>(_e130);
            let _e148 = array<u32, 3>(_e134, _e138, _e142);
            let _e150 = bitcast<i32>(_e110);
            if (_e150 < -126i) {
                phi_276_ = -126i;
            } else {
                phi_276_ = select(_e150, 127i, (_e150 > 127i));
            }
            let _e155 = phi_276_;
            let _e160 = bitcast<f32>((bitcast<u32>((_e155 + 127i)) << bitcast<u32>(23i)));
            let _e166 = bitcast<f32>((bitcast<u32>(((_e150 - _e155) + 127i)) << bitcast<u32>(23i)));
            if (_e126 == 0u) {
                phi_416_ = type_47(array<f32, 3>(_e143, _e144, _e145), _e126, _e147, _e148);
            } else {
                let _e168 = bitcast<u32>(_e143);
                let _e170 = ((_e168 & 2139095040u) != 0u);
                let _e185 = bitcast<u32>(_e144);
                let _e187 = ((_e185 & 2139095040u) != 0u);
                let _e202 = bitcast<u32>(_e145);
                let _e204 = ((_e202 & 2139095040u) != 0u);
                let _e220 = bitcast<u32>(_e147);
                let _e222 = ((_e220 & 2139095040u) != 0u);
                phi_416_ = type_47(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e168 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e168 & 2147483648u))), _e143, _e170) * _e160) * select(0.00000011920929f, 1f, _e170)) * _e166), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e185 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e185 & 2147483648u))), _e144, _e187) * _e160) * select(0.00000011920929f, 1f, _e187)) * _e166), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e202 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e202 & 2147483648u))), _e145, _e204) * _e160) * select(0.00000011920929f, 1f, _e204)) * _e166)), _e126, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e220 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e220 & 2147483648u))), _e147, _e222) * _e160) * select(0.00000011920929f, 1f, _e222)) * _e166), _e148);
            }
            let _e239 = phi_416_;
            if _e101 {
                let _e240 = (_e100 < arrayLength((&global_9.member)));
                if _e240 {
                    if _e101 {
                    } else {
                        break;
                    }
                    let _e245 = global_8.member[_e100].member.member_1;
                    let _e250 = global_8.member[_e100].member.member_3;
                    if (_e245 <= _e250) {
                        let _e252 = (1u < _e96);
                        if _e252 {
                            if (0u < _e96) {
                            } else {
                                break;
                            }
                            let _e256 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e256 + 1u) < _e256) {
                                if _e252 {
                                } else {
                                    break;
                                }
                                let _e261 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e101 {
                        } else {
                            break;
                        }
                        let _e271 = global_8.member[_e100].member.member_2[0u];
                        let _e273 = (bitcast<u32>(_e271) & 2147483647u);
                        let _e279 = global_8.member[_e100].member.member_2[1u];
                        let _e281 = (bitcast<u32>(_e279) & 2147483647u);
                        let _e287 = global_8.member[_e100].member.member_2[2u];
                        let _e289 = (bitcast<u32>(_e287) & 2147483647u);
                        let _e295 = global_8.member[_e100].member.member[0u];
                        let _e297 = (bitcast<u32>(_e295) & 2147483647u);
                        let _e303 = global_8.member[_e100].member.member[1u];
                        let _e305 = (bitcast<u32>(_e303) & 2147483647u);
                        let _e311 = global_8.member[_e100].member.member[2u];
                        let _e313 = (bitcast<u32>(_e311) & 2147483647u);
                        let _e315 = select(_e281, _e273, (_e281 < _e273));
                        let _e317 = select(_e289, _e315, (_e289 < _e315));
                        let _e319 = select(_e297, _e317, (_e297 < _e317));
                        let _e321 = select(_e305, _e319, (_e305 < _e319));
                        let _e323 = select(_e313, _e321, (_e313 < _e321));
                        let _e324 = bitcast<u32>(_e245);
                        let _e325 = (_e324 & 2147483647u);
                        let _e329 = bitcast<u32>(_e250);
                        let _e330 = (_e329 & 2147483647u);
                        let _e334 = (((select(_e325, _e323, (_e325 < _e323)) < 2139095040u) && (_e330 <= 2139095040u)) && (_e317 > 0u));
                        if _e334 {
                            let _e337 = (bitcast<u32>(bitcast<f32>(_e317)) & 2147483647u);
                            if (_e337 >= 8388608u) {
                                phi_566_ = (bitcast<i32>((_e337 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_566_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e337)), 32u, (_e337 == 0u))));
                            }
                            let _e351 = phi_566_;
                            phi_567_ = _e351;
                        } else {
                            phi_567_ = 0i;
                        }
                        let _e353 = phi_567_;
                        let _e354 = (_e273 == _e317);
                        if _e354 {
                            phi_577_ = true;
                        } else {
                            phi_577_ = (_e281 == _e317);
                        }
                        let _e357 = phi_577_;
                        let _e358 = select(1u, 0u, _e354);
                        if _e357 {
                            let _e359 = (_e358 + 1u);
                            phi_587_ = _e359;
                            phi_588_ = _e359;
                            phi_590_ = select(true, false, (_e359 == 2u));
                        } else {
                            phi_587_ = u32();
                            phi_588_ = 0u;
                            phi_590_ = true;
                        }
                        let _e363 = phi_587_;
                        let _e365 = phi_588_;
                        let _e367 = phi_590_;
                        if _e367 {
                            phi_595_ = (_e365 + 1u);
                        } else {
                            phi_595_ = 0u;
                        }
                        let _e371 = phi_595_;
                        let _e372 = select(_e363, _e365, _e367);
                        let _e373 = select(_e358, select(2u, _e358, _e357), _e367);
                        let _e374 = -(_e353);
                        if (_e374 < -126i) {
                            phi_628_ = -126i;
                        } else {
                            phi_628_ = select(_e374, 127i, (_e374 > 127i));
                        }
                        let _e379 = phi_628_;
                        let _e384 = bitcast<f32>((bitcast<u32>((_e379 + 127i)) << bitcast<u32>(23i)));
                        let _e390 = bitcast<f32>((bitcast<u32>(((_e374 - _e379) + 127i)) << bitcast<u32>(23i)));
                        let _e395 = global_8.member[_e100].member.member;
                        let _e396 = (_e372 == 0u);
                        if _e396 {
                            phi_646_ = _e395[0];
                        } else {
                            phi_646_ = _e395[1];
                        }
                        let _e400 = phi_646_;
                        let _e401 = (_e372 == 2u);
                        if _e401 {
                            phi_652_ = _e395[2];
                        } else {
                            phi_652_ = _e400;
                        }
                        let _e404 = phi_652_;
                        let _e405 = bitcast<u32>(_e404);
                        let _e407 = ((_e405 & 2139095040u) != 0u);
                        let _e419 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e405 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e405 & 2147483648u))), _e404, _e407) * select(0.00000011920929f, 1f, _e407));
                        let _e420 = global_8.member[_e100].member.member_2;
                        if _e396 {
                            phi_692_ = _e420[0];
                        } else {
                            phi_692_ = _e420[1];
                        }
                        let _e424 = phi_692_;
                        if _e401 {
                            phi_698_ = _e420[2];
                        } else {
                            phi_698_ = _e424;
                        }
                        let _e427 = phi_698_;
                        let _e428 = bitcast<u32>(_e427);
                        let _e430 = ((_e428 & 2139095040u) != 0u);
                        let _e444 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e428 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e428 & 2147483648u))), _e427, _e430) * _e384) * select(0.00000011920929f, 1f, _e430)) * _e390);
                        let _e448 = (bitcast<f32>((bitcast<u32>(_e444) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e448 {
                            let _e452 = (bitcast<f32>((bitcast<u32>(_e419) & 2147483647u)) * 0.00000011920929f);
                            phi_750_ = select(0.00000000000011368684f, _e452, (_e452 > 0.00000000000011368684f));
                        } else {
                            phi_750_ = 0f;
                        }
                        let _e456 = phi_750_;
                        let _e457 = (_e419 + _e456);
                        let _e458 = (_e419 - _e456);
                        let _e459 = select(_e444, 0f, _e448);
                        if _e448 {
                            phi_762_ = 38685626000000000000000000f;
                        } else {
                            phi_762_ = (1f / _e444);
                        }
                        let _e462 = phi_762_;
                        let _e463 = (_e371 == 0u);
                        if _e463 {
                            phi_771_ = _e395[0];
                        } else {
                            phi_771_ = _e395[1];
                        }
                        let _e467 = phi_771_;
                        let _e468 = (_e371 == 2u);
                        if _e468 {
                            phi_777_ = _e395[2];
                        } else {
                            phi_777_ = _e467;
                        }
                        let _e471 = phi_777_;
                        let _e472 = bitcast<u32>(_e471);
                        let _e474 = ((_e472 & 2139095040u) != 0u);
                        let _e486 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e472 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e472 & 2147483648u))), _e471, _e474) * select(0.00000011920929f, 1f, _e474));
                        if _e463 {
                            phi_817_ = _e420[0];
                        } else {
                            phi_817_ = _e420[1];
                        }
                        let _e490 = phi_817_;
                        if _e468 {
                            phi_823_ = _e420[2];
                        } else {
                            phi_823_ = _e490;
                        }
                        let _e493 = phi_823_;
                        let _e494 = bitcast<u32>(_e493);
                        let _e496 = ((_e494 & 2139095040u) != 0u);
                        let _e510 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e494 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e494 & 2147483648u))), _e493, _e496) * _e384) * select(0.00000011920929f, 1f, _e496)) * _e390);
                        let _e514 = (bitcast<f32>((bitcast<u32>(_e510) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e514 {
                            let _e518 = (bitcast<f32>((bitcast<u32>(_e486) & 2147483647u)) * 0.00000011920929f);
                            phi_875_ = select(0.00000000000011368684f, _e518, (_e518 > 0.00000000000011368684f));
                        } else {
                            phi_875_ = 0f;
                        }
                        let _e522 = phi_875_;
                        let _e523 = (_e486 + _e522);
                        let _e524 = (_e486 - _e522);
                        let _e525 = select(_e510, 0f, _e514);
                        if _e514 {
                            phi_887_ = 38685626000000000000000000f;
                        } else {
                            phi_887_ = (1f / _e510);
                        }
                        let _e528 = phi_887_;
                        let _e529 = (_e373 == 0u);
                        if _e529 {
                            phi_896_ = _e395[0];
                        } else {
                            phi_896_ = _e395[1];
                        }
                        let _e533 = phi_896_;
                        let _e534 = (_e373 == 2u);
                        if _e534 {
                            phi_902_ = _e395[2];
                        } else {
                            phi_902_ = _e533;
                        }
                        let _e537 = phi_902_;
                        let _e538 = bitcast<u32>(_e537);
                        let _e540 = ((_e538 & 2139095040u) != 0u);
                        let _e552 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e538 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e538 & 2147483648u))), _e537, _e540) * select(0.00000011920929f, 1f, _e540));
                        if _e529 {
                            phi_942_ = _e420[0];
                        } else {
                            phi_942_ = _e420[1];
                        }
                        let _e556 = phi_942_;
                        if _e534 {
                            phi_948_ = _e420[2];
                        } else {
                            phi_948_ = _e556;
                        }
                        let _e559 = phi_948_;
                        let _e560 = bitcast<u32>(_e559);
                        let _e562 = ((_e560 & 2139095040u) != 0u);
                        let _e576 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e560 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e560 & 2147483648u))), _e559, _e562) * _e384) * select(0.00000011920929f, 1f, _e562)) * _e390);
                        let _e580 = (bitcast<f32>((bitcast<u32>(_e576) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e580 {
                            let _e584 = (bitcast<f32>((bitcast<u32>(_e552) & 2147483647u)) * 0.00000011920929f);
                            phi_1000_ = select(0.00000000000011368684f, _e584, (_e584 > 0.00000000000011368684f));
                        } else {
                            phi_1000_ = 0f;
                        }
                        let _e588 = phi_1000_;
                        let _e589 = (_e552 + _e588);
                        let _e590 = (_e552 - _e588);
                        let _e591 = select(_e576, 0f, _e580);
                        if _e580 {
                            phi_1012_ = 38685626000000000000000000f;
                        } else {
                            phi_1012_ = (1f / _e576);
                        }
                        let _e594 = phi_1012_;
                        let _e597 = bitcast<f32>((bitcast<u32>(_e419) & 2147483647u));
                        let _e600 = bitcast<f32>((bitcast<u32>(_e486) & 2147483647u));
                        let _e602 = select(_e600, _e597, (_e597 > _e600));
                        let _e605 = bitcast<f32>((bitcast<u32>(_e552) & 2147483647u));
                        if (_e334 && (select(_e605, _e602, (_e602 > _e605)) <= 1099511600000f)) {
                            let _e617 = ((_e325 & 8388607u) | (select(0u, 1u, ((_e325 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e620 = bitcast<i32>((_e325 >> bitcast<u32>(23i)));
                            let _e624 = (_e617 == 0u);
                            let _e627 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e617)), 32u, _e624)) - 8i);
                            if (_e620 == 255i) {
                                phi_1067_ = 255i;
                            } else {
                                phi_1067_ = (((_e620 + select(0i, 1i, (_e620 == 0i))) - _e627) + _e353);
                            }
                            let _e635 = phi_1067_;
                            let _e645 = (_e635 <= 0i);
                            if _e645 {
                                phi_1090_ = u32();
                            } else {
                                if _e624 {
                                    phi_1089_ = u32();
                                } else {
                                    phi_1089_ = select(((bitcast<u32>(_e635) << bitcast<u32>(23i)) | ((_e617 << bitcast<u32>(((_e627 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e635 >= 255i));
                                }
                                let _e649 = phi_1089_;
                                phi_1090_ = _e649;
                            }
                            let _e651 = phi_1090_;
                            let _e663 = ((_e330 & 8388607u) | (select(0u, 1u, ((_e330 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e666 = bitcast<i32>((_e330 >> bitcast<u32>(23i)));
                            let _e670 = (_e663 == 0u);
                            let _e673 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e663)), 32u, _e670)) - 8i);
                            if (_e666 == 255i) {
                                phi_1127_ = 255i;
                            } else {
                                phi_1127_ = (((_e666 + select(0i, 1i, (_e666 == 0i))) - _e673) + _e353);
                            }
                            let _e681 = phi_1127_;
                            let _e691 = (_e681 <= 0i);
                            if _e691 {
                                phi_1150_ = u32();
                            } else {
                                if _e670 {
                                    phi_1149_ = u32();
                                } else {
                                    phi_1149_ = select(((bitcast<u32>(_e681) << bitcast<u32>(23i)) | ((_e663 << bitcast<u32>(((_e673 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e681 >= 255i));
                                }
                                let _e695 = phi_1149_;
                                phi_1150_ = _e695;
                            }
                            let _e697 = phi_1150_;
                            phi_1158_ = bitcast<f32>(((_e329 & 2147483648u) | select(_e697, 0u, select(_e670, true, _e691))));
                            phi_1159_ = bitcast<f32>(((_e324 & 2147483648u) | select(_e651, 0u, select(_e624, true, _e645))));
                        } else {
                            phi_1158_ = 0f;
                            phi_1159_ = 1f;
                        }
                        let _e703 = phi_1158_;
                        let _e705 = phi_1159_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_3197_ = false;
                        phi_1174_ = type_55(_e703, false);
                        phi_1177_ = (_e705 <= _e703);
                        phi_1179_ = ((3u * _e82) + 1u);
                        phi_1181_ = 0u;
                        phi_1183_ = select(0u, 2147483648u, (_e82 == 0u));
                        loop {
                            let _e713 = phi_3197_;
                            let _e715 = phi_1174_;
                            let _e717 = phi_1177_;
                            let _e719 = phi_1179_;
                            let _e721 = phi_1181_;
                            let _e723 = phi_1183_;
                            local_3 = _e715;
                            if _e717 {
                                phi_1194_ = true;
                            } else {
                                phi_1194_ = (_e721 > 0u);
                            }
                            let _e726 = phi_1194_;
                            if _e726 {
                                let _e727 = (_e719 > 0u);
                                if _e727 {
                                    if _e717 {
                                        phi_1226_ = _e717;
                                        phi_1227_ = _e721;
                                        phi_1228_ = _e723;
                                    } else {
                                        let _e728 = (_e721 - 1u);
                                        let _e729 = (_e728 % 128u);
                                        let _e730 = (_e729 < 128u);
                                        if _e730 {
                                        } else {
                                            phi_3383_ = true;
                                            break;
                                        }
                                        let _e732 = local_1[_e729];
                                        if _e730 {
                                        } else {
                                            phi_3383_ = true;
                                            break;
                                        }
                                        let _e734 = local[_e729];
                                        phi_1226_ = (_e734 <= _e715.member);
                                        phi_1227_ = _e728;
                                        phi_1228_ = _e732;
                                    }
                                    let _e738 = phi_1226_;
                                    let _e740 = phi_1227_;
                                    let _e742 = phi_1228_;
                                    if _e738 {
                                        if ((_e742 & 2147483648u) != 0u) {
                                            phi_1243_ = _e715;
                                            phi_1246_ = type_8(0u, ((_e742 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e940 = phi_1243_;
                                                let _e942 = phi_1246_;
                                                local_2 = _e940;
                                                local_4 = _e940;
                                                if (_e942.member < _e942.member_1) {
                                                    phi_1247_ = type_8((_e942.member + 1u), _e942.member_1);
                                                    phi_1269_ = type_8(1u, _e942.member);
                                                } else {
                                                    phi_1247_ = _e942;
                                                    phi_1269_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e955 = phi_1247_;
                                                let _e957 = phi_1269_;
                                                let _e961 = (bitcast<i32>(_e957.member) != 0i);
                                                if _e961 {
                                                    let _e962 = ((_e742 & 268435455u) + _e957.member_1);
                                                    let _e963 = (_e962 < _e84);
                                                    if _e963 {
                                                        if _e963 {
                                                        } else {
                                                            phi_3191_ = true;
                                                            break;
                                                        }
                                                        let _e967 = global_2.member[_e962].member_1;
                                                        phi_1290_ = _e967;
                                                    } else {
                                                        phi_1290_ = 4294967295u;
                                                    }
                                                    let _e969 = phi_1290_;
                                                    if (_e962 >= _e84) {
                                                        phi_1382_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e963 {
                                                        } else {
                                                            phi_3191_ = true;
                                                            break;
                                                        }
                                                        let _e971 = (_e372 % 3u);
                                                        let _e972 = (_e371 % 3u);
                                                        let _e973 = (_e373 % 3u);
                                                        if (_e971 < 9u) {
                                                        } else {
                                                            phi_3191_ = true;
                                                            break;
                                                        }
                                                        let _e979 = global_2.member[_e962].member[_e971];
                                                        if (_e972 < 9u) {
                                                        } else {
                                                            phi_3191_ = true;
                                                            break;
                                                        }
                                                        let _e985 = global_2.member[_e962].member[_e972];
                                                        if (_e973 < 9u) {
                                                        } else {
                                                            phi_3191_ = true;
                                                            break;
                                                        }
                                                        let _e991 = global_2.member[_e962].member[_e973];
                                                        let _e993 = (3u + _e971);
                                                        if (_e993 < 9u) {
                                                        } else {
                                                            phi_3191_ = true;
                                                            break;
                                                        }
                                                        let _e999 = global_2.member[_e962].member[_e993];
                                                        let _e1000 = (3u + _e972);
                                                        if (_e1000 < 9u) {
                                                        } else {
                                                            phi_3191_ = true;
                                                            break;
                                                        }
                                                        let _e1006 = global_2.member[_e962].member[_e1000];
                                                        let _e1007 = (3u + _e973);
                                                        if (_e1007 < 9u) {
                                                        } else {
                                                            phi_3191_ = true;
                                                            break;
                                                        }
                                                        let _e1013 = global_2.member[_e962].member[_e1007];
                                                        let _e1015 = (6u + _e971);
                                                        if (_e1015 < 9u) {
                                                        } else {
                                                            phi_3191_ = true;
                                                            break;
                                                        }
                                                        let _e1021 = global_2.member[_e962].member[_e1015];
                                                        let _e1022 = (6u + _e972);
                                                        if (_e1022 < 9u) {
                                                        } else {
                                                            phi_3191_ = true;
                                                            break;
                                                        }
                                                        let _e1028 = global_2.member[_e962].member[_e1022];
                                                        let _e1029 = (6u + _e973);
                                                        if (_e1029 < 9u) {
                                                        } else {
                                                            phi_3191_ = true;
                                                            break;
                                                        }
                                                        let _e1035 = global_2.member[_e962].member[_e1029];
                                                        phi_1382_ = array<array<f32, 3>, 3>(array<f32, 3>(_e979, _e985, _e991), array<f32, 3>(_e999, _e1006, _e1013), array<f32, 3>(_e1021, _e1028, _e1035));
                                                    }
                                                    let _e1039 = phi_1382_;
                                                    let _e1047 = (_e1039[0][2] - _e552);
                                                    let _e1050 = (((_e1039[0][0] - _e419) * _e591) - (_e1047 * _e459));
                                                    let _e1053 = (((_e1039[0][1] - _e486) * _e591) - (_e1047 * _e525));
                                                    let _e1060 = (_e1039[1][2] - _e552);
                                                    let _e1063 = (((_e1039[1][0] - _e419) * _e591) - (_e1060 * _e459));
                                                    let _e1066 = (((_e1039[1][1] - _e486) * _e591) - (_e1060 * _e525));
                                                    let _e1073 = (_e1039[2][2] - _e552);
                                                    let _e1076 = (((_e1039[2][0] - _e419) * _e591) - (_e1073 * _e459));
                                                    let _e1079 = (((_e1039[2][1] - _e486) * _e591) - (_e1073 * _e525));
                                                    let _e1080 = (_e1076 * _e1066);
                                                    let _e1081 = (_e1079 * _e1063);
                                                    let _e1082 = (_e1050 * _e1079);
                                                    let _e1083 = (_e1053 * _e1076);
                                                    let _e1084 = (_e1063 * _e1053);
                                                    let _e1085 = (_e1066 * _e1050);
                                                    let _e1090 = (((_e1080 >= _e1081) && (_e1082 >= _e1083)) && (_e1084 >= _e1085));
                                                    if (_e1090 || (((_e1080 <= _e1081) && (_e1082 <= _e1083)) && (_e1084 <= _e1085))) {
                                                        let _e1097 = select(-1f, 1f, _e1090);
                                                        let _e1099 = ((_e1080 - _e1081) * _e1097);
                                                        let _e1101 = select(0f, _e1099, (_e1099 > 0f));
                                                        let _e1103 = ((_e1082 - _e1083) * _e1097);
                                                        let _e1105 = select(0f, _e1103, (_e1103 > 0f));
                                                        let _e1107 = ((_e1084 - _e1085) * _e1097);
                                                        let _e1109 = select(0f, _e1107, (_e1107 > 0f));
                                                        let _e1111 = ((_e1101 + _e1105) + _e1109);
                                                        if (_e1111 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2266_ = type_28();
                                                            phi_2267_ = true;
                                                            phi_2268_ = false;
                                                        } else {
                                                            let _e1114 = select(_e1063, _e1050, (_e1050 < _e1063));
                                                            if (select(_e1076, _e1114, (_e1114 < _e1076)) > 0f) {
                                                                phi_1534_ = true;
                                                            } else {
                                                                let _e1119 = select(_e1063, _e1050, (_e1050 > _e1063));
                                                                phi_1534_ = (select(_e1076, _e1119, (_e1119 > _e1076)) < 0f);
                                                            }
                                                            let _e1124 = phi_1534_;
                                                            if _e1124 {
                                                                phi_2263_ = type_28();
                                                                phi_2264_ = true;
                                                                phi_2265_ = false;
                                                            } else {
                                                                let _e1126 = select(_e1066, _e1053, (_e1053 < _e1066));
                                                                if (select(_e1079, _e1126, (_e1126 < _e1079)) > 0f) {
                                                                    phi_1563_ = true;
                                                                } else {
                                                                    let _e1131 = select(_e1066, _e1053, (_e1053 > _e1066));
                                                                    phi_1563_ = (select(_e1079, _e1131, (_e1131 > _e1079)) < 0f);
                                                                }
                                                                let _e1136 = phi_1563_;
                                                                if _e1136 {
                                                                    phi_2261_ = type_28();
                                                                    phi_2262_ = false;
                                                                } else {
                                                                    let _e1138 = select(_e1039[1][0], _e1039[0][0], (_e1039[0][0] < _e1039[1][0]));
                                                                    let _e1142 = select(_e1039[1][0], _e1039[0][0], (_e1039[0][0] > _e1039[1][0]));
                                                                    let _e1146 = select(_e1039[1][1], _e1039[0][1], (_e1039[0][1] < _e1039[1][1]));
                                                                    let _e1150 = select(_e1039[1][1], _e1039[0][1], (_e1039[0][1] > _e1039[1][1]));
                                                                    let _e1154 = select(_e1039[1][2], _e1039[0][2], (_e1039[0][2] < _e1039[1][2]));
                                                                    let _e1158 = select(_e1039[1][2], _e1039[0][2], (_e1039[0][2] > _e1039[1][2]));
                                                                    let _e1163 = ((select(_e1039[2][0], _e1138, (_e1138 < _e1039[2][0])) - _e457) * _e462);
                                                                    let _e1164 = ((select(_e1039[2][0], _e1142, (_e1142 > _e1039[2][0])) - _e458) * _e462);
                                                                    let _e1167 = ((select(_e1039[2][1], _e1146, (_e1146 < _e1039[2][1])) - _e523) * _e528);
                                                                    let _e1168 = ((select(_e1039[2][1], _e1150, (_e1150 > _e1039[2][1])) - _e524) * _e528);
                                                                    let _e1171 = ((select(_e1039[2][2], _e1154, (_e1154 < _e1039[2][2])) - _e589) * _e594);
                                                                    let _e1172 = ((select(_e1039[2][2], _e1158, (_e1158 > _e1039[2][2])) - _e590) * _e594);
                                                                    let _e1174 = select(_e1172, _e1171, (_e1171 < _e1172));
                                                                    let _e1176 = select(_e1172, _e1171, (_e1171 > _e1172));
                                                                    let _e1178 = select(_e1164, _e1163, (_e1163 < _e1164));
                                                                    let _e1180 = select(_e1168, _e1167, (_e1167 < _e1168));
                                                                    let _e1182 = select(_e1180, _e1178, (_e1178 > _e1180));
                                                                    let _e1184 = select(_e1174, _e1182, (_e1182 > _e1174));
                                                                    let _e1186 = select(_e1164, _e1163, (_e1163 > _e1164));
                                                                    let _e1188 = select(_e1168, _e1167, (_e1167 > _e1168));
                                                                    let _e1190 = select(_e1188, _e1186, (_e1186 < _e1188));
                                                                    let _e1192 = select(_e1176, _e1190, (_e1190 < _e1176));
                                                                    let _e1193 = -(_e1174);
                                                                    let _e1199 = select(_e705, _e1184, (_e1184 > _e705));
                                                                    if (_e1199 > (_e1192 + (select(_e1193, _e1176, (_e1176 > _e1193)) * 0.0000019073523f))) {
                                                                        phi_2256_ = type_28();
                                                                        phi_2257_ = true;
                                                                    } else {
                                                                        let _e1201 = (_e1199 > _e940.member);
                                                                        if _e1201 {
                                                                            phi_2255_ = type_28();
                                                                        } else {
                                                                            let _e1202 = vec3<f32>(_e1039[0][0], _e1039[0][1], _e1039[0][2]);
                                                                            let _e1203 = vec3<f32>(_e1039[1][0], _e1039[1][1], _e1039[1][2]);
                                                                            let _e1204 = vec3<f32>(_e1039[2][0], _e1039[2][1], _e1039[2][2]);
                                                                            let _e1205 = (_e1039[1][0] - _e1039[0][0]);
                                                                            let _e1206 = (_e1039[1][1] - _e1039[0][1]);
                                                                            let _e1207 = (_e1039[1][2] - _e1039[0][2]);
                                                                            let _e1208 = vec3<f32>(_e1205, _e1206, _e1207);
                                                                            let _e1209 = (_e1039[2][0] - _e1039[1][0]);
                                                                            let _e1210 = (_e1039[2][1] - _e1039[1][1]);
                                                                            let _e1211 = (_e1039[2][2] - _e1039[1][2]);
                                                                            let _e1212 = vec3<f32>(_e1209, _e1210, _e1211);
                                                                            let _e1213 = (_e1039[0][0] - _e1039[2][0]);
                                                                            let _e1214 = (_e1039[0][1] - _e1039[2][1]);
                                                                            let _e1215 = (_e1039[0][2] - _e1039[2][2]);
                                                                            let _e1216 = vec3<f32>(_e1213, _e1214, _e1215);
                                                                            let _e1219 = bitcast<f32>((bitcast<u32>(_e1205) & 2147483647u));
                                                                            let _e1222 = bitcast<f32>((bitcast<u32>(_e1206) & 2147483647u));
                                                                            let _e1224 = select(_e1222, _e1219, (_e1219 > _e1222));
                                                                            let _e1227 = bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u));
                                                                            let _e1229 = select(_e1227, _e1224, (_e1224 > _e1227));
                                                                            let _e1232 = bitcast<f32>((bitcast<u32>(_e1209) & 2147483647u));
                                                                            let _e1235 = bitcast<f32>((bitcast<u32>(_e1210) & 2147483647u));
                                                                            let _e1237 = select(_e1235, _e1232, (_e1232 > _e1235));
                                                                            let _e1240 = bitcast<f32>((bitcast<u32>(_e1211) & 2147483647u));
                                                                            let _e1242 = select(_e1240, _e1237, (_e1237 > _e1240));
                                                                            let _e1245 = bitcast<f32>((bitcast<u32>(_e1213) & 2147483647u));
                                                                            let _e1248 = bitcast<f32>((bitcast<u32>(_e1214) & 2147483647u));
                                                                            let _e1250 = select(_e1248, _e1245, (_e1245 > _e1248));
                                                                            let _e1253 = bitcast<f32>((bitcast<u32>(_e1215) & 2147483647u));
                                                                            let _e1255 = select(_e1253, _e1250, (_e1250 > _e1253));
                                                                            let _e1257 = select(_e1242, _e1229, (_e1229 > _e1242));
                                                                            let _e1259 = select(_e1255, _e1257, (_e1257 > _e1255));
                                                                            if (_e1229 == _e1259) {
                                                                                phi_1982_ = _e1066;
                                                                                phi_1983_ = _e1063;
                                                                                phi_1984_ = _e1053;
                                                                                phi_1985_ = _e1050;
                                                                                phi_1986_ = _e1202;
                                                                                phi_1987_ = _e1216;
                                                                                phi_1988_ = _e1212;
                                                                                phi_1989_ = _e1208;
                                                                            } else {
                                                                                let _e1261 = (_e1242 == _e1259);
                                                                                let _e1266 = vec3(_e1261);
                                                                                phi_1982_ = select(_e1053, _e1079, _e1261);
                                                                                phi_1983_ = select(_e1050, _e1076, _e1261);
                                                                                phi_1984_ = select(_e1079, _e1066, _e1261);
                                                                                phi_1985_ = select(_e1076, _e1063, _e1261);
                                                                                phi_1986_ = select(_e1204, _e1203, _e1266);
                                                                                phi_1987_ = select(_e1212, _e1208, _e1266);
                                                                                phi_1988_ = select(_e1208, _e1216, _e1266);
                                                                                phi_1989_ = select(_e1216, _e1212, _e1266);
                                                                            }
                                                                            let _e1272 = phi_1982_;
                                                                            let _e1274 = phi_1983_;
                                                                            let _e1276 = phi_1984_;
                                                                            let _e1278 = phi_1985_;
                                                                            let _e1280 = phi_1986_;
                                                                            let _e1282 = phi_1987_;
                                                                            let _e1284 = phi_1988_;
                                                                            let _e1286 = phi_1989_;
                                                                            let _e1293 = ((_e1284.y * _e1282.z) - (_e1282.y * _e1284.z));
                                                                            let _e1298 = ((_e1284.z * _e1282.x) - (_e1282.z * _e1284.x));
                                                                            let _e1301 = ((_e1284.x * _e1282.y) - (_e1282.x * _e1284.y));
                                                                            if (_e1101 >= _e1105) {
                                                                                phi_2026_ = select(true, false, (_e1101 >= _e1109));
                                                                            } else {
                                                                                phi_2026_ = true;
                                                                            }
                                                                            let _e1306 = phi_2026_;
                                                                            if _e1306 {
                                                                                phi_2035_ = select(_e1204, _e1203, vec3((_e1105 >= _e1109)));
                                                                            } else {
                                                                                phi_2035_ = _e1202;
                                                                            }
                                                                            let _e1311 = phi_2035_;
                                                                            let _e1322 = (((_e1293 * (_e1311.x - _e419)) + (_e1298 * (_e1311.y - _e486))) + (_e1301 * (_e1311.z - _e552)));
                                                                            let _e1327 = (((_e1293 * _e459) + (_e1298 * _e525)) + (_e1301 * _e591));
                                                                            let _e1328 = (_e1274 - _e1278);
                                                                            let _e1329 = (_e1272 - _e1276);
                                                                            let _e1337 = (-(((_e1278 * _e1328) + (_e1276 * _e1329))) / ((_e1328 * _e1328) + (_e1329 * _e1329)));
                                                                            let _e1339 = select(1f, _e1337, (_e1337 < 1f));
                                                                            let _e1341 = select(0f, _e1339, (_e1339 > 0f));
                                                                            let _e1354 = ((_e1280.x + (_e1286.x * _e1341)) - _e419);
                                                                            let _e1355 = ((_e1280.y + (_e1286.y * _e1341)) - _e486);
                                                                            let _e1356 = ((_e1280.z + (_e1286.z * _e1341)) - _e552);
                                                                            let _e1357 = (_e1356 / _e591);
                                                                            let _e1369 = bitcast<f32>((bitcast<u32>(_e1354) & 2147483647u));
                                                                            let _e1372 = bitcast<f32>((bitcast<u32>(_e1355) & 2147483647u));
                                                                            let _e1374 = select(_e1372, _e1369, (_e1369 > _e1372));
                                                                            let _e1377 = bitcast<f32>((bitcast<u32>(_e1356) & 2147483647u));
                                                                            let _e1379 = select(_e1377, _e1374, (_e1374 > _e1377));
                                                                            let _e1385 = bitcast<f32>((bitcast<u32>(_e1293) & 2147483647u));
                                                                            let _e1388 = bitcast<f32>((bitcast<u32>(_e1298) & 2147483647u));
                                                                            let _e1390 = select(_e1388, _e1385, (_e1385 > _e1388));
                                                                            let _e1393 = bitcast<f32>((bitcast<u32>(_e1301) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1293 * _e1354) + (_e1298 * _e1355)) + (_e1301 * _e1356)) - _e1322)) & 2147483647u)) <= ((0.0000009536743f * select(_e1259, _e1379, (_e1379 > _e1259))) * select(_e1393, _e1390, (_e1390 > _e1393)))) {
                                                                                let _e1403 = bitcast<f32>((bitcast<u32>(_e1284.x) & 2147483647u));
                                                                                let _e1406 = bitcast<f32>((bitcast<u32>(_e1284.y) & 2147483647u));
                                                                                let _e1408 = select(_e1406, _e1403, (_e1403 > _e1406));
                                                                                let _e1411 = bitcast<f32>((bitcast<u32>(_e1284.z) & 2147483647u));
                                                                                let _e1417 = bitcast<f32>((bitcast<u32>(_e1282.x) & 2147483647u));
                                                                                let _e1420 = bitcast<f32>((bitcast<u32>(_e1282.y) & 2147483647u));
                                                                                let _e1422 = select(_e1420, _e1417, (_e1417 > _e1420));
                                                                                let _e1425 = bitcast<f32>((bitcast<u32>(_e1282.z) & 2147483647u));
                                                                                let _e1429 = (bitcast<f32>((bitcast<u32>(_e1327) & 2147483647u)) > ((0.0000038146973f * select(_e1411, _e1408, (_e1408 > _e1411))) * select(_e1425, _e1422, (_e1422 > _e1425))));
                                                                                if _e1429 {
                                                                                    phi_2200_ = (_e1322 / _e1327);
                                                                                } else {
                                                                                    phi_2200_ = f32();
                                                                                }
                                                                                let _e1432 = phi_2200_;
                                                                                phi_2202_ = _e1432;
                                                                                phi_2203_ = select(true, false, _e1429);
                                                                            } else {
                                                                                phi_2202_ = f32();
                                                                                phi_2203_ = true;
                                                                            }
                                                                            let _e1435 = phi_2202_;
                                                                            let _e1437 = phi_2203_;
                                                                            if _e1437 {
                                                                                let _e1445 = (((_e1293 * (_e1354 - (_e459 * _e1357))) + (_e1298 * (_e1355 - (_e525 * _e1357)))) / _e1327);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1445) & 2147483647u)) <= _e1259) {
                                                                                    phi_2223_ = (_e1357 + _e1445);
                                                                                } else {
                                                                                    phi_2223_ = _e1357;
                                                                                }
                                                                                let _e1452 = phi_2223_;
                                                                                phi_2224_ = _e1452;
                                                                            } else {
                                                                                phi_2224_ = _e1435;
                                                                            }
                                                                            let _e1454 = phi_2224_;
                                                                            let _e1456 = select(_e1192, _e1454, (_e1454 < _e1192));
                                                                            let _e1458 = select(_e1184, _e1456, (_e1456 > _e1184));
                                                                            if (_e1458 >= _e705) {
                                                                                let _e1460 = (_e1458 <= _e940.member);
                                                                                if _e1460 {
                                                                                    let _e1461 = (1f / _e1111);
                                                                                    phi_2247_ = type_28(_e1458, (_e1105 * _e1461), (_e1109 * _e1461), _e969);
                                                                                } else {
                                                                                    phi_2247_ = type_28();
                                                                                }
                                                                                let _e1466 = phi_2247_;
                                                                                phi_2249_ = _e1466;
                                                                                phi_2250_ = select(true, false, _e1460);
                                                                            } else {
                                                                                phi_2249_ = type_28();
                                                                                phi_2250_ = true;
                                                                            }
                                                                            let _e1469 = phi_2249_;
                                                                            let _e1471 = phi_2250_;
                                                                            if _e1471 {
                                                                                phi_2254_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2254_ = _e1469;
                                                                            }
                                                                            let _e1473 = phi_2254_;
                                                                            phi_2255_ = _e1473;
                                                                        }
                                                                        let _e1475 = phi_2255_;
                                                                        phi_2256_ = _e1475;
                                                                        phi_2257_ = _e1201;
                                                                    }
                                                                    let _e1477 = phi_2256_;
                                                                    let _e1479 = phi_2257_;
                                                                    phi_2261_ = _e1477;
                                                                    phi_2262_ = _e1479;
                                                                }
                                                                let _e1481 = phi_2261_;
                                                                let _e1483 = phi_2262_;
                                                                phi_2263_ = _e1481;
                                                                phi_2264_ = _e1136;
                                                                phi_2265_ = _e1483;
                                                            }
                                                            let _e1485 = phi_2263_;
                                                            let _e1487 = phi_2264_;
                                                            let _e1489 = phi_2265_;
                                                            phi_2266_ = _e1485;
                                                            phi_2267_ = _e1487;
                                                            phi_2268_ = _e1489;
                                                        }
                                                        let _e1491 = phi_2266_;
                                                        let _e1493 = phi_2267_;
                                                        let _e1495 = phi_2268_;
                                                        phi_2276_ = _e1491;
                                                        phi_2277_ = select(_e1495, true, _e1493);
                                                    } else {
                                                        phi_2276_ = type_28();
                                                        phi_2277_ = true;
                                                    }
                                                    let _e1498 = phi_2276_;
                                                    let _e1500 = phi_2277_;
                                                    if _e1500 {
                                                        phi_2281_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2281_ = _e1498;
                                                    }
                                                    let _e1502 = phi_2281_;
                                                    if (_e1502.member_3 != 4294967295u) {
                                                        if (_e969 == _e107) {
                                                            phi_2616_ = false;
                                                        } else {
                                                            let _e1506 = (_e969 < arrayLength((&global_5.member)));
                                                            if _e1506 {
                                                                if _e1506 {
                                                                } else {
                                                                    phi_3191_ = true;
                                                                    break;
                                                                }
                                                                let _e1508 = global_5.member[_e969];
                                                                phi_2304_ = _e1508;
                                                            } else {
                                                                phi_2304_ = 4294967295u;
                                                            }
                                                            let _e1510 = phi_2304_;
                                                            let _e1511 = (_e1510 < arrayLength((&global_6.member)));
                                                            if _e1511 {
                                                                if _e1511 {
                                                                } else {
                                                                    phi_3191_ = true;
                                                                    break;
                                                                }
                                                                let _e1513 = global_6.member[_e1510];
                                                                phi_2318_ = _e1513;
                                                            } else {
                                                                phi_2318_ = 0i;
                                                            }
                                                            let _e1515 = phi_2318_;
                                                            let _e1516 = (_e1515 == 0i);
                                                            if _e1516 {
                                                                phi_2615_ = true;
                                                            } else {
                                                                if _e396 {
                                                                    phi_2341_ = vec3<f32>(_e1039[0][0], _e1039[0][1], _e1039[0][2]);
                                                                } else {
                                                                    if (_e372 == 1u) {
                                                                        phi_2340_ = vec3<f32>(_e1039[0][2], _e1039[0][0], _e1039[0][1]);
                                                                    } else {
                                                                        phi_2340_ = vec3<f32>(_e1039[0][1], _e1039[0][2], _e1039[0][0]);
                                                                    }
                                                                    let _e1521 = phi_2340_;
                                                                    phi_2341_ = _e1521;
                                                                }
                                                                let _e1524 = phi_2341_;
                                                                if _e396 {
                                                                    phi_2360_ = vec3<f32>(_e1039[1][0], _e1039[1][1], _e1039[1][2]);
                                                                } else {
                                                                    if (_e372 == 1u) {
                                                                        phi_2359_ = vec3<f32>(_e1039[1][2], _e1039[1][0], _e1039[1][1]);
                                                                    } else {
                                                                        phi_2359_ = vec3<f32>(_e1039[1][1], _e1039[1][2], _e1039[1][0]);
                                                                    }
                                                                    let _e1529 = phi_2359_;
                                                                    phi_2360_ = _e1529;
                                                                }
                                                                let _e1532 = phi_2360_;
                                                                if _e396 {
                                                                    phi_2379_ = vec3<f32>(_e1039[2][0], _e1039[2][1], _e1039[2][2]);
                                                                } else {
                                                                    if (_e372 == 1u) {
                                                                        phi_2378_ = vec3<f32>(_e1039[2][2], _e1039[2][0], _e1039[2][1]);
                                                                    } else {
                                                                        phi_2378_ = vec3<f32>(_e1039[2][1], _e1039[2][2], _e1039[2][0]);
                                                                    }
                                                                    let _e1537 = phi_2378_;
                                                                    phi_2379_ = _e1537;
                                                                }
                                                                let _e1540 = phi_2379_;
                                                                let _e1543 = (_e1532.x - _e1524.x);
                                                                let _e1546 = (_e1532.y - _e1524.y);
                                                                let _e1549 = (_e1532.z - _e1524.z);
                                                                let _e1551 = (_e1540.x - _e1524.x);
                                                                let _e1553 = (_e1540.y - _e1524.y);
                                                                let _e1555 = (_e1540.z - _e1524.z);
                                                                if (_e239.member_1 == 1u) {
                                                                    phi_2415_ = (vec3<f32>(_e239.member[0], _e239.member[1], _e239.member[2]) - _e1524);
                                                                } else {
                                                                    phi_2415_ = vec3<f32>(_e239.member[0], _e239.member[1], _e239.member[2]);
                                                                }
                                                                let _e1570 = phi_2415_;
                                                                let _e1576 = bitcast<f32>((bitcast<u32>((_e1543 * _e1553)) ^ _e239.member_3[0]));
                                                                let _e1580 = bitcast<f32>((bitcast<u32>((_e1546 * _e1551)) ^ _e239.member_3[0]));
                                                                let _e1584 = bitcast<f32>((bitcast<u32>((_e1546 * _e1555)) ^ _e239.member_3[0]));
                                                                let _e1588 = bitcast<f32>((bitcast<u32>((_e1549 * _e1553)) ^ _e239.member_3[0]));
                                                                let _e1592 = bitcast<f32>((bitcast<u32>((_e1549 * _e1551)) ^ _e239.member_3[0]));
                                                                let _e1596 = bitcast<f32>((bitcast<u32>((_e1543 * _e1555)) ^ _e239.member_3[0]));
                                                                let _e1597 = (_e1584 - _e1588);
                                                                let _e1598 = (_e1592 - _e1596);
                                                                let _e1599 = (_e1576 - _e1580);
                                                                let _e1623 = (bitcast<f32>((bitcast<u32>(_e1584) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1588) & 2147483647u)));
                                                                let _e1630 = (bitcast<f32>((bitcast<u32>(_e1592) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1596) & 2147483647u)));
                                                                let _e1637 = (bitcast<f32>((bitcast<u32>(_e1576) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1580) & 2147483647u)));
                                                                if (_e239.member_2 == 0f) {
                                                                    phi_2597_ = 0f;
                                                                } else {
                                                                    let _e1667 = bitcast<f32>((bitcast<u32>(_e1597) & 2147483647u));
                                                                    let _e1670 = bitcast<f32>((bitcast<u32>(_e1598) & 2147483647u));
                                                                    let _e1673 = bitcast<f32>((bitcast<u32>(_e1599) & 2147483647u));
                                                                    let _e1675 = select(_e1673, _e1670, (_e1670 > _e1673));
                                                                    let _e1679 = select(_e1673, _e1670, (_e1670 < _e1673));
                                                                    let _e1683 = select(_e1670, _e1667, (_e1667 < _e1670));
                                                                    let _e1685 = select(_e1670, _e1667, (_e1667 > _e1670));
                                                                    let _e1687 = select(_e1673, _e1685, (_e1685 < _e1673));
                                                                    phi_2597_ = bitcast<f32>((bitcast<u32>((_e239.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1675, _e1667, (_e1667 > _e1675)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1687, _e1683, (_e1683 > _e1687)))) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1679, _e1667, (_e1667 < _e1679)))) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1623 + _e1630) + _e1637))) ^ _e239.member_3[0]))) * 1.0000005f)) ^ _e239.member_3[0])))) ^ _e239.member_3[0]));
                                                                }
                                                                let _e1714 = phi_2597_;
                                                                phi_2615_ = (_e1516 || !(((((bitcast<f32>((bitcast<u32>((_e1570.x * _e1597)) ^ _e239.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1570.y * _e1598)) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1570.z * _e1599)) ^ _e239.member_3[0]))) * f32(-(_e1515))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1570.x) & 2147483647u)) * _e1623)) ^ _e239.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1570.y) & 2147483647u)) * _e1630)) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1570.z) & 2147483647u)) * _e1637)) ^ _e239.member_3[0]))))) ^ _e239.member_3[0])) + _e1714) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1728 = phi_2615_;
                                                            phi_2616_ = _e1728;
                                                        }
                                                        let _e1730 = phi_2616_;
                                                        if _e1730 {
                                                            phi_2621_ = type_55(_e940.member, true);
                                                        } else {
                                                            phi_2621_ = _e940;
                                                        }
                                                        let _e1735 = phi_2621_;
                                                        phi_2622_ = _e1735;
                                                    } else {
                                                        phi_2622_ = _e940;
                                                    }
                                                    let _e1737 = phi_2622_;
                                                    phi_1244_ = _e1737;
                                                } else {
                                                    phi_1244_ = type_55();
                                                }
                                                let _e1739 = phi_1244_;
                                                continue;
                                                continuing {
                                                    phi_1243_ = _e1739;
                                                    phi_1246_ = _e955;
                                                    phi_3191_ = _e713;
                                                    break if !(_e961);
                                                }
                                            }
                                            let _e1742 = phi_3191_;
                                            phi_3383_ = _e1742;
                                            if _e1742 {
                                                break;
                                            }
                                            let _e1744 = local_2;
                                            phi_3387_ = _e1742;
                                            let _e1949 = local_4;
                                            phi_3110_ = _e1949;
                                            phi_3111_ = false;
                                            phi_3112_ = select(_e740, 0u, _e1744.member_1);
                                            phi_3113_ = _e742;
                                        } else {
                                            if (_e742 >= _e82) {
                                                phi_2694_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e742 < _e82) {
                                                } else {
                                                    phi_3383_ = true;
                                                    break;
                                                }
                                                let _e752 = (_e372 % 3u);
                                                if (_e752 < 3u) {
                                                } else {
                                                    phi_3383_ = true;
                                                    break;
                                                }
                                                let _e758 = global_4.member[_e742].member[_e752];
                                                let _e764 = (_e371 % 3u);
                                                if (_e764 < 3u) {
                                                } else {
                                                    phi_3383_ = true;
                                                    break;
                                                }
                                                let _e770 = global_4.member[_e742].member[_e764];
                                                let _e776 = (_e373 % 3u);
                                                if (_e776 < 3u) {
                                                } else {
                                                    phi_3383_ = true;
                                                    break;
                                                }
                                                let _e782 = global_4.member[_e742].member[_e776];
                                                let _e792 = global_4.member[_e742].member_1;
                                                let _e796 = global_4.member[_e742].member_2;
                                                phi_2694_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e758[0], _e758[1], _e758[2], _e758[3]), vec4<f32>(_e770[0], _e770[1], _e770[2], _e770[3]), vec4<f32>(_e782[0], _e782[1], _e782[2], _e782[3])), _e792, _e796);
                                            }
                                            let _e799 = phi_2694_;
                                            let _e811 = ((_e799.member[0].x - _e457) * _e462);
                                            let _e812 = ((_e799.member[0].y - _e457) * _e462);
                                            let _e813 = ((_e799.member[0].z - _e458) * _e462);
                                            let _e814 = ((_e799.member[0].w - _e458) * _e462);
                                            let _e824 = ((_e799.member[1].x - _e523) * _e528);
                                            let _e825 = ((_e799.member[1].y - _e523) * _e528);
                                            let _e826 = ((_e799.member[1].z - _e524) * _e528);
                                            let _e827 = ((_e799.member[1].w - _e524) * _e528);
                                            let _e837 = ((_e799.member[2].x - _e589) * _e594);
                                            let _e838 = ((_e799.member[2].y - _e589) * _e594);
                                            let _e839 = ((_e799.member[2].z - _e590) * _e594);
                                            let _e840 = ((_e799.member[2].w - _e590) * _e594);
                                            let _e842 = select(_e839, _e837, (_e837 < _e839));
                                            let _e844 = select(_e840, _e838, (_e838 < _e840));
                                            let _e846 = select(_e839, _e837, (_e837 > _e839));
                                            let _e848 = select(_e840, _e838, (_e838 > _e840));
                                            let _e850 = select(_e813, _e811, (_e811 < _e813));
                                            let _e852 = select(_e814, _e812, (_e812 < _e814));
                                            let _e854 = select(_e826, _e824, (_e824 < _e826));
                                            let _e856 = select(_e827, _e825, (_e825 < _e827));
                                            let _e858 = select(_e854, _e850, (_e850 > _e854));
                                            let _e860 = select(_e856, _e852, (_e852 > _e856));
                                            let _e862 = select(_e842, _e858, (_e858 > _e842));
                                            let _e864 = select(_e844, _e860, (_e860 > _e844));
                                            let _e866 = select(_e813, _e811, (_e811 > _e813));
                                            let _e868 = select(_e814, _e812, (_e812 > _e814));
                                            let _e870 = select(_e826, _e824, (_e824 > _e826));
                                            let _e872 = select(_e827, _e825, (_e825 > _e827));
                                            let _e874 = select(_e870, _e866, (_e866 < _e870));
                                            let _e876 = select(_e872, _e868, (_e868 < _e872));
                                            let _e881 = -(_e842);
                                            let _e882 = -(_e844);
                                            let _e889 = (select(_e846, _e874, (_e874 < _e846)) + (select(_e881, _e846, (_e846 > _e881)) * 0.0000019073523f));
                                            let _e890 = (select(_e848, _e876, (_e876 < _e848)) + (select(_e882, _e848, (_e848 > _e882)) * 0.0000019073523f));
                                            let _e892 = select(_e705, _e862, (_e862 > _e705));
                                            let _e894 = select(_e705, _e864, (_e864 > _e705));
                                            let _e899 = (_e892 <= select(_e715.member, _e889, (_e889 < _e715.member)));
                                            let _e900 = (_e894 <= select(_e715.member, _e890, (_e890 < _e715.member)));
                                            let _e901 = (_e892 <= _e894);
                                            if _e899 {
                                                if _e900 {
                                                    if _e901 {
                                                        phi_3056_ = _e799.member_2;
                                                    } else {
                                                        phi_3056_ = _e799.member_1;
                                                    }
                                                    let _e905 = phi_3056_;
                                                    let _e908 = (_e740 % 128u);
                                                    let _e909 = (_e908 < 128u);
                                                    if _e909 {
                                                    } else {
                                                        phi_3383_ = true;
                                                        break;
                                                    }
                                                    local_1[_e908] = _e905;
                                                    if _e909 {
                                                    } else {
                                                        phi_3383_ = true;
                                                        break;
                                                    }
                                                    local[_e908] = select(_e894, _e892, !(_e901));
                                                    if _e901 {
                                                        phi_3084_ = _e799.member_1;
                                                    } else {
                                                        phi_3084_ = _e799.member_2;
                                                    }
                                                    let _e916 = phi_3084_;
                                                    phi_3085_ = (_e740 + 1u);
                                                    phi_3086_ = _e916;
                                                } else {
                                                    phi_3085_ = u32();
                                                    phi_3086_ = u32();
                                                }
                                                let _e918 = phi_3085_;
                                                let _e920 = phi_3086_;
                                                phi_3088_ = _e918;
                                                phi_3089_ = _e920;
                                                phi_3090_ = select(true, false, _e900);
                                            } else {
                                                phi_3088_ = u32();
                                                phi_3089_ = u32();
                                                phi_3090_ = true;
                                            }
                                            let _e923 = phi_3088_;
                                            let _e925 = phi_3089_;
                                            let _e927 = phi_3090_;
                                            if _e927 {
                                                if _e899 {
                                                    phi_3099_ = _e799.member_1;
                                                } else {
                                                    phi_3099_ = _e799.member_2;
                                                }
                                                let _e931 = phi_3099_;
                                                phi_3104_ = select(_e900, true, _e899);
                                                phi_3106_ = _e931;
                                            } else {
                                                phi_3104_ = _e738;
                                                phi_3106_ = _e925;
                                            }
                                            let _e934 = phi_3104_;
                                            let _e936 = phi_3106_;
                                            phi_3387_ = _e713;
                                            phi_3110_ = _e715;
                                            phi_3111_ = _e934;
                                            phi_3112_ = select(_e923, _e740, _e927);
                                            phi_3113_ = _e936;
                                        }
                                        let _e1748 = phi_3387_;
                                        let _e1750 = phi_3110_;
                                        let _e1752 = phi_3111_;
                                        let _e1754 = phi_3112_;
                                        let _e1756 = phi_3113_;
                                        phi_3386_ = _e1748;
                                        phi_3114_ = _e1750;
                                        phi_3115_ = _e1752;
                                        phi_3116_ = (_e719 - 1u);
                                        phi_3117_ = _e1754;
                                        phi_3118_ = _e1756;
                                    } else {
                                        phi_3386_ = _e713;
                                        phi_3114_ = _e715;
                                        phi_3115_ = _e738;
                                        phi_3116_ = _e719;
                                        phi_3117_ = _e740;
                                        phi_3118_ = _e742;
                                    }
                                    let _e1758 = phi_3386_;
                                    let _e1760 = phi_3114_;
                                    let _e1762 = phi_3115_;
                                    let _e1764 = phi_3116_;
                                    let _e1766 = phi_3117_;
                                    let _e1768 = phi_3118_;
                                    phi_3385_ = _e1758;
                                    phi_3119_ = _e1760;
                                    phi_3120_ = _e1762;
                                    phi_3121_ = _e1764;
                                    phi_3122_ = _e1766;
                                    phi_3123_ = _e1768;
                                } else {
                                    phi_3385_ = _e713;
                                    phi_3119_ = type_55();
                                    phi_3120_ = bool();
                                    phi_3121_ = u32();
                                    phi_3122_ = u32();
                                    phi_3123_ = u32();
                                }
                                let _e1770 = phi_3385_;
                                let _e1772 = phi_3119_;
                                let _e1774 = phi_3120_;
                                let _e1776 = phi_3121_;
                                let _e1778 = phi_3122_;
                                let _e1780 = phi_3123_;
                                phi_3384_ = _e1770;
                                phi_1175_ = _e1772;
                                phi_1178_ = _e1774;
                                phi_1180_ = _e1776;
                                phi_1182_ = _e1778;
                                phi_1184_ = _e1780;
                                phi_3124_ = _e727;
                            } else {
                                phi_3384_ = _e713;
                                phi_1175_ = type_55();
                                phi_1178_ = bool();
                                phi_1180_ = u32();
                                phi_1182_ = u32();
                                phi_1184_ = u32();
                                phi_3124_ = false;
                            }
                            let _e1782 = phi_3384_;
                            let _e1784 = phi_1175_;
                            let _e1786 = phi_1178_;
                            let _e1788 = phi_1180_;
                            let _e1790 = phi_1182_;
                            let _e1792 = phi_1184_;
                            let _e1794 = phi_3124_;
                            continue;
                            continuing {
                                phi_3197_ = _e1782;
                                phi_1174_ = _e1784;
                                phi_1177_ = _e1786;
                                phi_1179_ = _e1788;
                                phi_1181_ = _e1790;
                                phi_1183_ = _e1792;
                                phi_3383_ = _e1782;
                                break if !(_e1794);
                            }
                        }
                        let _e1797 = phi_3383_;
                        if _e1797 {
                            break;
                        }
                        let _e1799 = local_3;
                        if _e1799.member_1 {
                        } else {
                            if _e240 {
                            } else {
                                break;
                            }
                            let _e1803 = global_9.member[_e100];
                            if _e101 {
                            } else {
                                break;
                            }
                            let _e1807 = global_8.member[_e100].member_1;
                            if _e240 {
                            } else {
                                break;
                            }
                            global_9.member[_e100] = type_30(_e1803.member, _e1803.member_1, _e1803.member_2, array<f32, 3>((_e1803.member_3[0] + (_e1807[0] * _e1803.member_1[0])), (_e1803.member_3[1] + (_e1807[1] * _e1803.member_1[1])), (_e1803.member_3[2] + (_e1807[2] * _e1803.member_1[2]))), _e1803.member_4);
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
