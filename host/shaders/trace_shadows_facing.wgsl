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
    var phi_3200_: bool;
    var phi_1174_: type_55;
    var phi_1177_: u32;
    var phi_1179_: bool;
    var phi_1181_: u32;
    var phi_1183_: u32;
    var phi_1194_: bool;
    var phi_1226_: bool;
    var phi_1227_: u32;
    var phi_1228_: u32;
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
    var phi_3194_: bool;
    var phi_3421_: bool;
    var phi_2623_: type_55;
    var phi_2688_: type_54;
    var phi_3050_: u32;
    var phi_3077_: u32;
    var phi_3078_: u32;
    var phi_3079_: u32;
    var phi_3081_: u32;
    var phi_3082_: u32;
    var phi_3083_: bool;
    var phi_3092_: u32;
    var phi_3097_: bool;
    var phi_3099_: u32;
    var phi_3103_: bool;
    var phi_3104_: u32;
    var phi_3105_: u32;
    var phi_3115_: u32;
    var phi_3389_: bool;
    var phi_3117_: type_55;
    var phi_3118_: u32;
    var phi_3119_: bool;
    var phi_3120_: u32;
    var phi_3121_: u32;
    var phi_3388_: bool;
    var phi_3122_: type_55;
    var phi_3123_: u32;
    var phi_3124_: bool;
    var phi_3125_: u32;
    var phi_3126_: u32;
    var phi_3387_: bool;
    var phi_1175_: type_55;
    var phi_1178_: u32;
    var phi_1180_: bool;
    var phi_1182_: u32;
    var phi_1184_: u32;
    var phi_3127_: bool;
    var phi_3386_: bool;
    var local_2: type_55;
    var local_3: type_55;

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
                        phi_3200_ = false;
                        phi_1174_ = type_55(_e703, false);
                        phi_1177_ = ((3u * _e82) + 1u);
                        phi_1179_ = (_e705 <= _e703);
                        phi_1181_ = 0u;
                        phi_1183_ = select(0u, 2147483648u, (_e82 == 0u));
                        loop {
                            let _e713 = phi_3200_;
                            let _e715 = phi_1174_;
                            let _e717 = phi_1177_;
                            let _e719 = phi_1179_;
                            let _e721 = phi_1181_;
                            let _e723 = phi_1183_;
                            local_2 = _e715;
                            if _e719 {
                                phi_1194_ = true;
                            } else {
                                phi_1194_ = (_e721 > 0u);
                            }
                            let _e726 = phi_1194_;
                            if _e726 {
                                let _e727 = (_e717 > 0u);
                                if _e727 {
                                    if _e719 {
                                        phi_1226_ = _e719;
                                        phi_1227_ = _e721;
                                        phi_1228_ = _e723;
                                    } else {
                                        let _e728 = (_e721 - 1u);
                                        let _e729 = (_e728 % 128u);
                                        let _e730 = (_e729 < 128u);
                                        if _e730 {
                                        } else {
                                            phi_3386_ = true;
                                            break;
                                        }
                                        let _e732 = local_1[_e729];
                                        if _e730 {
                                        } else {
                                            phi_3386_ = true;
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
                                        let _e745 = ((_e742 & 2147483648u) != 0u);
                                        if _e745 {
                                            phi_1243_ = _e715;
                                            phi_1246_ = type_8(0u, ((_e742 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e752 = phi_1243_;
                                                let _e754 = phi_1246_;
                                                local_3 = _e752;
                                                if (_e754.member < _e754.member_1) {
                                                    phi_1247_ = type_8((_e754.member + 1u), _e754.member_1);
                                                    phi_1269_ = type_8(1u, _e754.member);
                                                } else {
                                                    phi_1247_ = _e754;
                                                    phi_1269_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e767 = phi_1247_;
                                                let _e769 = phi_1269_;
                                                let _e773 = (bitcast<i32>(_e769.member) != 0i);
                                                if _e773 {
                                                    let _e774 = ((_e742 & 268435455u) + _e769.member_1);
                                                    let _e775 = (_e774 < _e84);
                                                    if _e775 {
                                                        if _e775 {
                                                        } else {
                                                            phi_3194_ = true;
                                                            break;
                                                        }
                                                        let _e779 = global_2.member[_e774].member_1;
                                                        phi_1290_ = _e779;
                                                    } else {
                                                        phi_1290_ = 4294967295u;
                                                    }
                                                    let _e781 = phi_1290_;
                                                    if (_e774 >= _e84) {
                                                        phi_1382_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e775 {
                                                        } else {
                                                            phi_3194_ = true;
                                                            break;
                                                        }
                                                        let _e783 = (_e372 % 3u);
                                                        let _e784 = (_e371 % 3u);
                                                        let _e785 = (_e373 % 3u);
                                                        if (_e783 < 9u) {
                                                        } else {
                                                            phi_3194_ = true;
                                                            break;
                                                        }
                                                        let _e791 = global_2.member[_e774].member[_e783];
                                                        if (_e784 < 9u) {
                                                        } else {
                                                            phi_3194_ = true;
                                                            break;
                                                        }
                                                        let _e797 = global_2.member[_e774].member[_e784];
                                                        if (_e785 < 9u) {
                                                        } else {
                                                            phi_3194_ = true;
                                                            break;
                                                        }
                                                        let _e803 = global_2.member[_e774].member[_e785];
                                                        let _e805 = (3u + _e783);
                                                        if (_e805 < 9u) {
                                                        } else {
                                                            phi_3194_ = true;
                                                            break;
                                                        }
                                                        let _e811 = global_2.member[_e774].member[_e805];
                                                        let _e812 = (3u + _e784);
                                                        if (_e812 < 9u) {
                                                        } else {
                                                            phi_3194_ = true;
                                                            break;
                                                        }
                                                        let _e818 = global_2.member[_e774].member[_e812];
                                                        let _e819 = (3u + _e785);
                                                        if (_e819 < 9u) {
                                                        } else {
                                                            phi_3194_ = true;
                                                            break;
                                                        }
                                                        let _e825 = global_2.member[_e774].member[_e819];
                                                        let _e827 = (6u + _e783);
                                                        if (_e827 < 9u) {
                                                        } else {
                                                            phi_3194_ = true;
                                                            break;
                                                        }
                                                        let _e833 = global_2.member[_e774].member[_e827];
                                                        let _e834 = (6u + _e784);
                                                        if (_e834 < 9u) {
                                                        } else {
                                                            phi_3194_ = true;
                                                            break;
                                                        }
                                                        let _e840 = global_2.member[_e774].member[_e834];
                                                        let _e841 = (6u + _e785);
                                                        if (_e841 < 9u) {
                                                        } else {
                                                            phi_3194_ = true;
                                                            break;
                                                        }
                                                        let _e847 = global_2.member[_e774].member[_e841];
                                                        phi_1382_ = array<array<f32, 3>, 3>(array<f32, 3>(_e791, _e797, _e803), array<f32, 3>(_e811, _e818, _e825), array<f32, 3>(_e833, _e840, _e847));
                                                    }
                                                    let _e851 = phi_1382_;
                                                    let _e859 = (_e851[0][2] - _e552);
                                                    let _e862 = (((_e851[0][0] - _e419) * _e591) - (_e859 * _e459));
                                                    let _e865 = (((_e851[0][1] - _e486) * _e591) - (_e859 * _e525));
                                                    let _e872 = (_e851[1][2] - _e552);
                                                    let _e875 = (((_e851[1][0] - _e419) * _e591) - (_e872 * _e459));
                                                    let _e878 = (((_e851[1][1] - _e486) * _e591) - (_e872 * _e525));
                                                    let _e885 = (_e851[2][2] - _e552);
                                                    let _e888 = (((_e851[2][0] - _e419) * _e591) - (_e885 * _e459));
                                                    let _e891 = (((_e851[2][1] - _e486) * _e591) - (_e885 * _e525));
                                                    let _e892 = (_e888 * _e878);
                                                    let _e893 = (_e891 * _e875);
                                                    let _e894 = (_e862 * _e891);
                                                    let _e895 = (_e865 * _e888);
                                                    let _e896 = (_e875 * _e865);
                                                    let _e897 = (_e878 * _e862);
                                                    let _e902 = (((_e892 >= _e893) && (_e894 >= _e895)) && (_e896 >= _e897));
                                                    if (_e902 || (((_e892 <= _e893) && (_e894 <= _e895)) && (_e896 <= _e897))) {
                                                        let _e909 = select(-1f, 1f, _e902);
                                                        let _e911 = ((_e892 - _e893) * _e909);
                                                        let _e913 = select(0f, _e911, (_e911 > 0f));
                                                        let _e915 = ((_e894 - _e895) * _e909);
                                                        let _e917 = select(0f, _e915, (_e915 > 0f));
                                                        let _e919 = ((_e896 - _e897) * _e909);
                                                        let _e921 = select(0f, _e919, (_e919 > 0f));
                                                        let _e923 = ((_e913 + _e917) + _e921);
                                                        if (_e923 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2266_ = type_28();
                                                            phi_2267_ = true;
                                                            phi_2268_ = false;
                                                        } else {
                                                            let _e926 = select(_e875, _e862, (_e862 < _e875));
                                                            if (select(_e888, _e926, (_e926 < _e888)) > 0f) {
                                                                phi_1534_ = true;
                                                            } else {
                                                                let _e931 = select(_e875, _e862, (_e862 > _e875));
                                                                phi_1534_ = (select(_e888, _e931, (_e931 > _e888)) < 0f);
                                                            }
                                                            let _e936 = phi_1534_;
                                                            if _e936 {
                                                                phi_2263_ = type_28();
                                                                phi_2264_ = true;
                                                                phi_2265_ = false;
                                                            } else {
                                                                let _e938 = select(_e878, _e865, (_e865 < _e878));
                                                                if (select(_e891, _e938, (_e938 < _e891)) > 0f) {
                                                                    phi_1563_ = true;
                                                                } else {
                                                                    let _e943 = select(_e878, _e865, (_e865 > _e878));
                                                                    phi_1563_ = (select(_e891, _e943, (_e943 > _e891)) < 0f);
                                                                }
                                                                let _e948 = phi_1563_;
                                                                if _e948 {
                                                                    phi_2261_ = type_28();
                                                                    phi_2262_ = false;
                                                                } else {
                                                                    let _e950 = select(_e851[1][0], _e851[0][0], (_e851[0][0] < _e851[1][0]));
                                                                    let _e954 = select(_e851[1][0], _e851[0][0], (_e851[0][0] > _e851[1][0]));
                                                                    let _e958 = select(_e851[1][1], _e851[0][1], (_e851[0][1] < _e851[1][1]));
                                                                    let _e962 = select(_e851[1][1], _e851[0][1], (_e851[0][1] > _e851[1][1]));
                                                                    let _e966 = select(_e851[1][2], _e851[0][2], (_e851[0][2] < _e851[1][2]));
                                                                    let _e970 = select(_e851[1][2], _e851[0][2], (_e851[0][2] > _e851[1][2]));
                                                                    let _e975 = ((select(_e851[2][0], _e950, (_e950 < _e851[2][0])) - _e457) * _e462);
                                                                    let _e976 = ((select(_e851[2][0], _e954, (_e954 > _e851[2][0])) - _e458) * _e462);
                                                                    let _e979 = ((select(_e851[2][1], _e958, (_e958 < _e851[2][1])) - _e523) * _e528);
                                                                    let _e980 = ((select(_e851[2][1], _e962, (_e962 > _e851[2][1])) - _e524) * _e528);
                                                                    let _e983 = ((select(_e851[2][2], _e966, (_e966 < _e851[2][2])) - _e589) * _e594);
                                                                    let _e984 = ((select(_e851[2][2], _e970, (_e970 > _e851[2][2])) - _e590) * _e594);
                                                                    let _e986 = select(_e984, _e983, (_e983 < _e984));
                                                                    let _e988 = select(_e984, _e983, (_e983 > _e984));
                                                                    let _e990 = select(_e976, _e975, (_e975 < _e976));
                                                                    let _e992 = select(_e980, _e979, (_e979 < _e980));
                                                                    let _e994 = select(_e992, _e990, (_e990 > _e992));
                                                                    let _e996 = select(_e986, _e994, (_e994 > _e986));
                                                                    let _e998 = select(_e976, _e975, (_e975 > _e976));
                                                                    let _e1000 = select(_e980, _e979, (_e979 > _e980));
                                                                    let _e1002 = select(_e1000, _e998, (_e998 < _e1000));
                                                                    let _e1004 = select(_e988, _e1002, (_e1002 < _e988));
                                                                    let _e1005 = -(_e986);
                                                                    let _e1011 = select(_e705, _e996, (_e996 > _e705));
                                                                    if (_e1011 > (_e1004 + (select(_e1005, _e988, (_e988 > _e1005)) * 0.0000019073523f))) {
                                                                        phi_2256_ = type_28();
                                                                        phi_2257_ = true;
                                                                    } else {
                                                                        let _e1013 = (_e1011 > _e752.member);
                                                                        if _e1013 {
                                                                            phi_2255_ = type_28();
                                                                        } else {
                                                                            let _e1014 = vec3<f32>(_e851[0][0], _e851[0][1], _e851[0][2]);
                                                                            let _e1015 = vec3<f32>(_e851[1][0], _e851[1][1], _e851[1][2]);
                                                                            let _e1016 = vec3<f32>(_e851[2][0], _e851[2][1], _e851[2][2]);
                                                                            let _e1017 = (_e851[1][0] - _e851[0][0]);
                                                                            let _e1018 = (_e851[1][1] - _e851[0][1]);
                                                                            let _e1019 = (_e851[1][2] - _e851[0][2]);
                                                                            let _e1020 = vec3<f32>(_e1017, _e1018, _e1019);
                                                                            let _e1021 = (_e851[2][0] - _e851[1][0]);
                                                                            let _e1022 = (_e851[2][1] - _e851[1][1]);
                                                                            let _e1023 = (_e851[2][2] - _e851[1][2]);
                                                                            let _e1024 = vec3<f32>(_e1021, _e1022, _e1023);
                                                                            let _e1025 = (_e851[0][0] - _e851[2][0]);
                                                                            let _e1026 = (_e851[0][1] - _e851[2][1]);
                                                                            let _e1027 = (_e851[0][2] - _e851[2][2]);
                                                                            let _e1028 = vec3<f32>(_e1025, _e1026, _e1027);
                                                                            let _e1031 = bitcast<f32>((bitcast<u32>(_e1017) & 2147483647u));
                                                                            let _e1034 = bitcast<f32>((bitcast<u32>(_e1018) & 2147483647u));
                                                                            let _e1036 = select(_e1034, _e1031, (_e1031 > _e1034));
                                                                            let _e1039 = bitcast<f32>((bitcast<u32>(_e1019) & 2147483647u));
                                                                            let _e1041 = select(_e1039, _e1036, (_e1036 > _e1039));
                                                                            let _e1044 = bitcast<f32>((bitcast<u32>(_e1021) & 2147483647u));
                                                                            let _e1047 = bitcast<f32>((bitcast<u32>(_e1022) & 2147483647u));
                                                                            let _e1049 = select(_e1047, _e1044, (_e1044 > _e1047));
                                                                            let _e1052 = bitcast<f32>((bitcast<u32>(_e1023) & 2147483647u));
                                                                            let _e1054 = select(_e1052, _e1049, (_e1049 > _e1052));
                                                                            let _e1057 = bitcast<f32>((bitcast<u32>(_e1025) & 2147483647u));
                                                                            let _e1060 = bitcast<f32>((bitcast<u32>(_e1026) & 2147483647u));
                                                                            let _e1062 = select(_e1060, _e1057, (_e1057 > _e1060));
                                                                            let _e1065 = bitcast<f32>((bitcast<u32>(_e1027) & 2147483647u));
                                                                            let _e1067 = select(_e1065, _e1062, (_e1062 > _e1065));
                                                                            let _e1069 = select(_e1054, _e1041, (_e1041 > _e1054));
                                                                            let _e1071 = select(_e1067, _e1069, (_e1069 > _e1067));
                                                                            if (_e1041 == _e1071) {
                                                                                phi_1982_ = _e878;
                                                                                phi_1983_ = _e875;
                                                                                phi_1984_ = _e865;
                                                                                phi_1985_ = _e862;
                                                                                phi_1986_ = _e1014;
                                                                                phi_1987_ = _e1028;
                                                                                phi_1988_ = _e1024;
                                                                                phi_1989_ = _e1020;
                                                                            } else {
                                                                                let _e1073 = (_e1054 == _e1071);
                                                                                let _e1078 = vec3(_e1073);
                                                                                phi_1982_ = select(_e865, _e891, _e1073);
                                                                                phi_1983_ = select(_e862, _e888, _e1073);
                                                                                phi_1984_ = select(_e891, _e878, _e1073);
                                                                                phi_1985_ = select(_e888, _e875, _e1073);
                                                                                phi_1986_ = select(_e1016, _e1015, _e1078);
                                                                                phi_1987_ = select(_e1024, _e1020, _e1078);
                                                                                phi_1988_ = select(_e1020, _e1028, _e1078);
                                                                                phi_1989_ = select(_e1028, _e1024, _e1078);
                                                                            }
                                                                            let _e1084 = phi_1982_;
                                                                            let _e1086 = phi_1983_;
                                                                            let _e1088 = phi_1984_;
                                                                            let _e1090 = phi_1985_;
                                                                            let _e1092 = phi_1986_;
                                                                            let _e1094 = phi_1987_;
                                                                            let _e1096 = phi_1988_;
                                                                            let _e1098 = phi_1989_;
                                                                            let _e1105 = ((_e1096.y * _e1094.z) - (_e1094.y * _e1096.z));
                                                                            let _e1110 = ((_e1096.z * _e1094.x) - (_e1094.z * _e1096.x));
                                                                            let _e1113 = ((_e1096.x * _e1094.y) - (_e1094.x * _e1096.y));
                                                                            if (_e913 >= _e917) {
                                                                                phi_2026_ = select(true, false, (_e913 >= _e921));
                                                                            } else {
                                                                                phi_2026_ = true;
                                                                            }
                                                                            let _e1118 = phi_2026_;
                                                                            if _e1118 {
                                                                                phi_2035_ = select(_e1016, _e1015, vec3((_e917 >= _e921)));
                                                                            } else {
                                                                                phi_2035_ = _e1014;
                                                                            }
                                                                            let _e1123 = phi_2035_;
                                                                            let _e1134 = (((_e1105 * (_e1123.x - _e419)) + (_e1110 * (_e1123.y - _e486))) + (_e1113 * (_e1123.z - _e552)));
                                                                            let _e1139 = (((_e1105 * _e459) + (_e1110 * _e525)) + (_e1113 * _e591));
                                                                            let _e1140 = (_e1086 - _e1090);
                                                                            let _e1141 = (_e1084 - _e1088);
                                                                            let _e1149 = (-(((_e1090 * _e1140) + (_e1088 * _e1141))) / ((_e1140 * _e1140) + (_e1141 * _e1141)));
                                                                            let _e1151 = select(1f, _e1149, (_e1149 < 1f));
                                                                            let _e1153 = select(0f, _e1151, (_e1151 > 0f));
                                                                            let _e1166 = ((_e1092.x + (_e1098.x * _e1153)) - _e419);
                                                                            let _e1167 = ((_e1092.y + (_e1098.y * _e1153)) - _e486);
                                                                            let _e1168 = ((_e1092.z + (_e1098.z * _e1153)) - _e552);
                                                                            let _e1169 = (_e1168 / _e591);
                                                                            let _e1181 = bitcast<f32>((bitcast<u32>(_e1166) & 2147483647u));
                                                                            let _e1184 = bitcast<f32>((bitcast<u32>(_e1167) & 2147483647u));
                                                                            let _e1186 = select(_e1184, _e1181, (_e1181 > _e1184));
                                                                            let _e1189 = bitcast<f32>((bitcast<u32>(_e1168) & 2147483647u));
                                                                            let _e1191 = select(_e1189, _e1186, (_e1186 > _e1189));
                                                                            let _e1197 = bitcast<f32>((bitcast<u32>(_e1105) & 2147483647u));
                                                                            let _e1200 = bitcast<f32>((bitcast<u32>(_e1110) & 2147483647u));
                                                                            let _e1202 = select(_e1200, _e1197, (_e1197 > _e1200));
                                                                            let _e1205 = bitcast<f32>((bitcast<u32>(_e1113) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1105 * _e1166) + (_e1110 * _e1167)) + (_e1113 * _e1168)) - _e1134)) & 2147483647u)) <= ((0.0000009536743f * select(_e1071, _e1191, (_e1191 > _e1071))) * select(_e1205, _e1202, (_e1202 > _e1205)))) {
                                                                                let _e1215 = bitcast<f32>((bitcast<u32>(_e1096.x) & 2147483647u));
                                                                                let _e1218 = bitcast<f32>((bitcast<u32>(_e1096.y) & 2147483647u));
                                                                                let _e1220 = select(_e1218, _e1215, (_e1215 > _e1218));
                                                                                let _e1223 = bitcast<f32>((bitcast<u32>(_e1096.z) & 2147483647u));
                                                                                let _e1229 = bitcast<f32>((bitcast<u32>(_e1094.x) & 2147483647u));
                                                                                let _e1232 = bitcast<f32>((bitcast<u32>(_e1094.y) & 2147483647u));
                                                                                let _e1234 = select(_e1232, _e1229, (_e1229 > _e1232));
                                                                                let _e1237 = bitcast<f32>((bitcast<u32>(_e1094.z) & 2147483647u));
                                                                                let _e1241 = (bitcast<f32>((bitcast<u32>(_e1139) & 2147483647u)) > ((0.0000038146973f * select(_e1223, _e1220, (_e1220 > _e1223))) * select(_e1237, _e1234, (_e1234 > _e1237))));
                                                                                if _e1241 {
                                                                                    phi_2200_ = (_e1134 / _e1139);
                                                                                } else {
                                                                                    phi_2200_ = f32();
                                                                                }
                                                                                let _e1244 = phi_2200_;
                                                                                phi_2202_ = _e1244;
                                                                                phi_2203_ = select(true, false, _e1241);
                                                                            } else {
                                                                                phi_2202_ = f32();
                                                                                phi_2203_ = true;
                                                                            }
                                                                            let _e1247 = phi_2202_;
                                                                            let _e1249 = phi_2203_;
                                                                            if _e1249 {
                                                                                let _e1257 = (((_e1105 * (_e1166 - (_e459 * _e1169))) + (_e1110 * (_e1167 - (_e525 * _e1169)))) / _e1139);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1257) & 2147483647u)) <= _e1071) {
                                                                                    phi_2223_ = (_e1169 + _e1257);
                                                                                } else {
                                                                                    phi_2223_ = _e1169;
                                                                                }
                                                                                let _e1264 = phi_2223_;
                                                                                phi_2224_ = _e1264;
                                                                            } else {
                                                                                phi_2224_ = _e1247;
                                                                            }
                                                                            let _e1266 = phi_2224_;
                                                                            let _e1268 = select(_e1004, _e1266, (_e1266 < _e1004));
                                                                            let _e1270 = select(_e996, _e1268, (_e1268 > _e996));
                                                                            if (_e1270 >= _e705) {
                                                                                let _e1272 = (_e1270 <= _e752.member);
                                                                                if _e1272 {
                                                                                    let _e1273 = (1f / _e923);
                                                                                    phi_2247_ = type_28(_e1270, (_e917 * _e1273), (_e921 * _e1273), _e781);
                                                                                } else {
                                                                                    phi_2247_ = type_28();
                                                                                }
                                                                                let _e1278 = phi_2247_;
                                                                                phi_2249_ = _e1278;
                                                                                phi_2250_ = select(true, false, _e1272);
                                                                            } else {
                                                                                phi_2249_ = type_28();
                                                                                phi_2250_ = true;
                                                                            }
                                                                            let _e1281 = phi_2249_;
                                                                            let _e1283 = phi_2250_;
                                                                            if _e1283 {
                                                                                phi_2254_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2254_ = _e1281;
                                                                            }
                                                                            let _e1285 = phi_2254_;
                                                                            phi_2255_ = _e1285;
                                                                        }
                                                                        let _e1287 = phi_2255_;
                                                                        phi_2256_ = _e1287;
                                                                        phi_2257_ = _e1013;
                                                                    }
                                                                    let _e1289 = phi_2256_;
                                                                    let _e1291 = phi_2257_;
                                                                    phi_2261_ = _e1289;
                                                                    phi_2262_ = _e1291;
                                                                }
                                                                let _e1293 = phi_2261_;
                                                                let _e1295 = phi_2262_;
                                                                phi_2263_ = _e1293;
                                                                phi_2264_ = _e948;
                                                                phi_2265_ = _e1295;
                                                            }
                                                            let _e1297 = phi_2263_;
                                                            let _e1299 = phi_2264_;
                                                            let _e1301 = phi_2265_;
                                                            phi_2266_ = _e1297;
                                                            phi_2267_ = _e1299;
                                                            phi_2268_ = _e1301;
                                                        }
                                                        let _e1303 = phi_2266_;
                                                        let _e1305 = phi_2267_;
                                                        let _e1307 = phi_2268_;
                                                        phi_2276_ = _e1303;
                                                        phi_2277_ = select(_e1307, true, _e1305);
                                                    } else {
                                                        phi_2276_ = type_28();
                                                        phi_2277_ = true;
                                                    }
                                                    let _e1310 = phi_2276_;
                                                    let _e1312 = phi_2277_;
                                                    if _e1312 {
                                                        phi_2281_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2281_ = _e1310;
                                                    }
                                                    let _e1314 = phi_2281_;
                                                    if (_e1314.member_3 != 4294967295u) {
                                                        if (_e781 == _e107) {
                                                            phi_2616_ = false;
                                                        } else {
                                                            let _e1318 = (_e781 < arrayLength((&global_5.member)));
                                                            if _e1318 {
                                                                if _e1318 {
                                                                } else {
                                                                    phi_3194_ = true;
                                                                    break;
                                                                }
                                                                let _e1320 = global_5.member[_e781];
                                                                phi_2304_ = _e1320;
                                                            } else {
                                                                phi_2304_ = 4294967295u;
                                                            }
                                                            let _e1322 = phi_2304_;
                                                            let _e1323 = (_e1322 < arrayLength((&global_6.member)));
                                                            if _e1323 {
                                                                if _e1323 {
                                                                } else {
                                                                    phi_3194_ = true;
                                                                    break;
                                                                }
                                                                let _e1325 = global_6.member[_e1322];
                                                                phi_2318_ = _e1325;
                                                            } else {
                                                                phi_2318_ = 0i;
                                                            }
                                                            let _e1327 = phi_2318_;
                                                            let _e1328 = (_e1327 == 0i);
                                                            if _e1328 {
                                                                phi_2615_ = true;
                                                            } else {
                                                                if _e396 {
                                                                    phi_2341_ = vec3<f32>(_e851[0][0], _e851[0][1], _e851[0][2]);
                                                                } else {
                                                                    if (_e372 == 1u) {
                                                                        phi_2340_ = vec3<f32>(_e851[0][2], _e851[0][0], _e851[0][1]);
                                                                    } else {
                                                                        phi_2340_ = vec3<f32>(_e851[0][1], _e851[0][2], _e851[0][0]);
                                                                    }
                                                                    let _e1333 = phi_2340_;
                                                                    phi_2341_ = _e1333;
                                                                }
                                                                let _e1336 = phi_2341_;
                                                                if _e396 {
                                                                    phi_2360_ = vec3<f32>(_e851[1][0], _e851[1][1], _e851[1][2]);
                                                                } else {
                                                                    if (_e372 == 1u) {
                                                                        phi_2359_ = vec3<f32>(_e851[1][2], _e851[1][0], _e851[1][1]);
                                                                    } else {
                                                                        phi_2359_ = vec3<f32>(_e851[1][1], _e851[1][2], _e851[1][0]);
                                                                    }
                                                                    let _e1341 = phi_2359_;
                                                                    phi_2360_ = _e1341;
                                                                }
                                                                let _e1344 = phi_2360_;
                                                                if _e396 {
                                                                    phi_2379_ = vec3<f32>(_e851[2][0], _e851[2][1], _e851[2][2]);
                                                                } else {
                                                                    if (_e372 == 1u) {
                                                                        phi_2378_ = vec3<f32>(_e851[2][2], _e851[2][0], _e851[2][1]);
                                                                    } else {
                                                                        phi_2378_ = vec3<f32>(_e851[2][1], _e851[2][2], _e851[2][0]);
                                                                    }
                                                                    let _e1349 = phi_2378_;
                                                                    phi_2379_ = _e1349;
                                                                }
                                                                let _e1352 = phi_2379_;
                                                                let _e1355 = (_e1344.x - _e1336.x);
                                                                let _e1358 = (_e1344.y - _e1336.y);
                                                                let _e1361 = (_e1344.z - _e1336.z);
                                                                let _e1363 = (_e1352.x - _e1336.x);
                                                                let _e1365 = (_e1352.y - _e1336.y);
                                                                let _e1367 = (_e1352.z - _e1336.z);
                                                                if (_e239.member_1 == 1u) {
                                                                    phi_2415_ = (vec3<f32>(_e239.member[0], _e239.member[1], _e239.member[2]) - _e1336);
                                                                } else {
                                                                    phi_2415_ = vec3<f32>(_e239.member[0], _e239.member[1], _e239.member[2]);
                                                                }
                                                                let _e1382 = phi_2415_;
                                                                let _e1388 = bitcast<f32>((bitcast<u32>((_e1355 * _e1365)) ^ _e239.member_3[0]));
                                                                let _e1392 = bitcast<f32>((bitcast<u32>((_e1358 * _e1363)) ^ _e239.member_3[0]));
                                                                let _e1396 = bitcast<f32>((bitcast<u32>((_e1358 * _e1367)) ^ _e239.member_3[0]));
                                                                let _e1400 = bitcast<f32>((bitcast<u32>((_e1361 * _e1365)) ^ _e239.member_3[0]));
                                                                let _e1404 = bitcast<f32>((bitcast<u32>((_e1361 * _e1363)) ^ _e239.member_3[0]));
                                                                let _e1408 = bitcast<f32>((bitcast<u32>((_e1355 * _e1367)) ^ _e239.member_3[0]));
                                                                let _e1409 = (_e1396 - _e1400);
                                                                let _e1410 = (_e1404 - _e1408);
                                                                let _e1411 = (_e1388 - _e1392);
                                                                let _e1435 = (bitcast<f32>((bitcast<u32>(_e1396) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1400) & 2147483647u)));
                                                                let _e1442 = (bitcast<f32>((bitcast<u32>(_e1404) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1408) & 2147483647u)));
                                                                let _e1449 = (bitcast<f32>((bitcast<u32>(_e1388) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1392) & 2147483647u)));
                                                                if (_e239.member_2 == 0f) {
                                                                    phi_2597_ = 0f;
                                                                } else {
                                                                    let _e1479 = bitcast<f32>((bitcast<u32>(_e1409) & 2147483647u));
                                                                    let _e1482 = bitcast<f32>((bitcast<u32>(_e1410) & 2147483647u));
                                                                    let _e1485 = bitcast<f32>((bitcast<u32>(_e1411) & 2147483647u));
                                                                    let _e1487 = select(_e1485, _e1482, (_e1482 > _e1485));
                                                                    let _e1491 = select(_e1485, _e1482, (_e1482 < _e1485));
                                                                    let _e1495 = select(_e1482, _e1479, (_e1479 < _e1482));
                                                                    let _e1497 = select(_e1482, _e1479, (_e1479 > _e1482));
                                                                    let _e1499 = select(_e1485, _e1497, (_e1497 < _e1485));
                                                                    phi_2597_ = bitcast<f32>((bitcast<u32>((_e239.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1487, _e1479, (_e1479 > _e1487)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1499, _e1495, (_e1495 > _e1499)))) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1491, _e1479, (_e1479 < _e1491)))) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1435 + _e1442) + _e1449))) ^ _e239.member_3[0]))) * 1.0000005f)) ^ _e239.member_3[0])))) ^ _e239.member_3[0]));
                                                                }
                                                                let _e1526 = phi_2597_;
                                                                phi_2615_ = (_e1328 || !(((((bitcast<f32>((bitcast<u32>((_e1382.x * _e1409)) ^ _e239.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1382.y * _e1410)) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1382.z * _e1411)) ^ _e239.member_3[0]))) * f32(-(_e1327))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1382.x) & 2147483647u)) * _e1435)) ^ _e239.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1382.y) & 2147483647u)) * _e1442)) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1382.z) & 2147483647u)) * _e1449)) ^ _e239.member_3[0]))))) ^ _e239.member_3[0])) + _e1526) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1540 = phi_2615_;
                                                            phi_2616_ = _e1540;
                                                        }
                                                        let _e1542 = phi_2616_;
                                                        if _e1542 {
                                                            phi_2621_ = type_55(_e752.member, true);
                                                        } else {
                                                            phi_2621_ = _e752;
                                                        }
                                                        let _e1547 = phi_2621_;
                                                        phi_2622_ = _e1547;
                                                    } else {
                                                        phi_2622_ = _e752;
                                                    }
                                                    let _e1549 = phi_2622_;
                                                    phi_1244_ = _e1549;
                                                } else {
                                                    phi_1244_ = type_55();
                                                }
                                                let _e1551 = phi_1244_;
                                                continue;
                                                continuing {
                                                    phi_1243_ = _e1551;
                                                    phi_1246_ = _e767;
                                                    phi_3194_ = _e713;
                                                    break if !(_e773);
                                                }
                                            }
                                            let _e1554 = phi_3194_;
                                            phi_3386_ = _e1554;
                                            if _e1554 {
                                                break;
                                            }
                                            phi_3421_ = _e1554;
                                            let _e1938 = local_3;
                                            phi_2623_ = _e1938;
                                        } else {
                                            phi_3421_ = _e713;
                                            phi_2623_ = _e715;
                                        }
                                        let _e1556 = phi_3421_;
                                        let _e1558 = phi_2623_;
                                        if _e745 {
                                            phi_3103_ = bool();
                                            phi_3104_ = u32();
                                            phi_3105_ = u32();
                                        } else {
                                            if (_e742 >= _e82) {
                                                phi_2688_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e742 < _e82) {
                                                } else {
                                                    phi_3386_ = true;
                                                    break;
                                                }
                                                let _e1561 = (_e372 % 3u);
                                                if (_e1561 < 3u) {
                                                } else {
                                                    phi_3386_ = true;
                                                    break;
                                                }
                                                let _e1567 = global_4.member[_e742].member[_e1561];
                                                let _e1573 = (_e371 % 3u);
                                                if (_e1573 < 3u) {
                                                } else {
                                                    phi_3386_ = true;
                                                    break;
                                                }
                                                let _e1579 = global_4.member[_e742].member[_e1573];
                                                let _e1585 = (_e373 % 3u);
                                                if (_e1585 < 3u) {
                                                } else {
                                                    phi_3386_ = true;
                                                    break;
                                                }
                                                let _e1591 = global_4.member[_e742].member[_e1585];
                                                let _e1601 = global_4.member[_e742].member_1;
                                                let _e1605 = global_4.member[_e742].member_2;
                                                phi_2688_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e1567[0], _e1567[1], _e1567[2], _e1567[3]), vec4<f32>(_e1579[0], _e1579[1], _e1579[2], _e1579[3]), vec4<f32>(_e1591[0], _e1591[1], _e1591[2], _e1591[3])), _e1601, _e1605);
                                            }
                                            let _e1608 = phi_2688_;
                                            let _e1620 = ((_e1608.member[0].x - _e457) * _e462);
                                            let _e1621 = ((_e1608.member[0].y - _e457) * _e462);
                                            let _e1622 = ((_e1608.member[0].z - _e458) * _e462);
                                            let _e1623 = ((_e1608.member[0].w - _e458) * _e462);
                                            let _e1633 = ((_e1608.member[1].x - _e523) * _e528);
                                            let _e1634 = ((_e1608.member[1].y - _e523) * _e528);
                                            let _e1635 = ((_e1608.member[1].z - _e524) * _e528);
                                            let _e1636 = ((_e1608.member[1].w - _e524) * _e528);
                                            let _e1646 = ((_e1608.member[2].x - _e589) * _e594);
                                            let _e1647 = ((_e1608.member[2].y - _e589) * _e594);
                                            let _e1648 = ((_e1608.member[2].z - _e590) * _e594);
                                            let _e1649 = ((_e1608.member[2].w - _e590) * _e594);
                                            let _e1651 = select(_e1648, _e1646, (_e1646 < _e1648));
                                            let _e1653 = select(_e1649, _e1647, (_e1647 < _e1649));
                                            let _e1655 = select(_e1648, _e1646, (_e1646 > _e1648));
                                            let _e1657 = select(_e1649, _e1647, (_e1647 > _e1649));
                                            let _e1659 = select(_e1622, _e1620, (_e1620 < _e1622));
                                            let _e1661 = select(_e1623, _e1621, (_e1621 < _e1623));
                                            let _e1663 = select(_e1635, _e1633, (_e1633 < _e1635));
                                            let _e1665 = select(_e1636, _e1634, (_e1634 < _e1636));
                                            let _e1667 = select(_e1663, _e1659, (_e1659 > _e1663));
                                            let _e1669 = select(_e1665, _e1661, (_e1661 > _e1665));
                                            let _e1671 = select(_e1651, _e1667, (_e1667 > _e1651));
                                            let _e1673 = select(_e1653, _e1669, (_e1669 > _e1653));
                                            let _e1675 = select(_e1622, _e1620, (_e1620 > _e1622));
                                            let _e1677 = select(_e1623, _e1621, (_e1621 > _e1623));
                                            let _e1679 = select(_e1635, _e1633, (_e1633 > _e1635));
                                            let _e1681 = select(_e1636, _e1634, (_e1634 > _e1636));
                                            let _e1683 = select(_e1679, _e1675, (_e1675 < _e1679));
                                            let _e1685 = select(_e1681, _e1677, (_e1677 < _e1681));
                                            let _e1690 = -(_e1651);
                                            let _e1691 = -(_e1653);
                                            let _e1698 = (select(_e1655, _e1683, (_e1683 < _e1655)) + (select(_e1690, _e1655, (_e1655 > _e1690)) * 0.0000019073523f));
                                            let _e1699 = (select(_e1657, _e1685, (_e1685 < _e1657)) + (select(_e1691, _e1657, (_e1657 > _e1691)) * 0.0000019073523f));
                                            let _e1701 = select(_e705, _e1671, (_e1671 > _e705));
                                            let _e1703 = select(_e705, _e1673, (_e1673 > _e705));
                                            let _e1708 = (_e1701 <= select(_e1558.member, _e1698, (_e1698 < _e1558.member)));
                                            let _e1709 = (_e1703 <= select(_e1558.member, _e1699, (_e1699 < _e1558.member)));
                                            let _e1710 = (_e1701 <= _e1703);
                                            if _e1708 {
                                                if _e1709 {
                                                    if _e1710 {
                                                        phi_3050_ = _e1608.member_2;
                                                    } else {
                                                        phi_3050_ = _e1608.member_1;
                                                    }
                                                    let _e1714 = phi_3050_;
                                                    let _e1716 = (_e740 % 128u);
                                                    let _e1717 = (_e1716 < 128u);
                                                    if _e1717 {
                                                    } else {
                                                        phi_3386_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1716] = _e1714;
                                                    if _e1717 {
                                                    } else {
                                                        phi_3386_ = true;
                                                        break;
                                                    }
                                                    local[_e1716] = select(_e1701, _e1703, _e1710);
                                                    if _e1710 {
                                                        phi_3077_ = _e1608.member_1;
                                                    } else {
                                                        phi_3077_ = _e1608.member_2;
                                                    }
                                                    let _e1724 = phi_3077_;
                                                    phi_3078_ = (_e740 + 1u);
                                                    phi_3079_ = _e1724;
                                                } else {
                                                    phi_3078_ = u32();
                                                    phi_3079_ = u32();
                                                }
                                                let _e1726 = phi_3078_;
                                                let _e1728 = phi_3079_;
                                                phi_3081_ = _e1726;
                                                phi_3082_ = _e1728;
                                                phi_3083_ = select(true, false, _e1709);
                                            } else {
                                                phi_3081_ = u32();
                                                phi_3082_ = u32();
                                                phi_3083_ = true;
                                            }
                                            let _e1731 = phi_3081_;
                                            let _e1733 = phi_3082_;
                                            let _e1735 = phi_3083_;
                                            if _e1735 {
                                                if _e1708 {
                                                    phi_3092_ = _e1608.member_1;
                                                } else {
                                                    phi_3092_ = _e1608.member_2;
                                                }
                                                let _e1739 = phi_3092_;
                                                phi_3097_ = select(_e1709, true, _e1708);
                                                phi_3099_ = _e1739;
                                            } else {
                                                phi_3097_ = _e738;
                                                phi_3099_ = _e1733;
                                            }
                                            let _e1742 = phi_3097_;
                                            let _e1744 = phi_3099_;
                                            phi_3103_ = _e1742;
                                            phi_3104_ = select(_e1731, _e740, _e1735);
                                            phi_3105_ = _e1744;
                                        }
                                        let _e1747 = phi_3103_;
                                        let _e1749 = phi_3104_;
                                        let _e1751 = phi_3105_;
                                        if _e745 {
                                            phi_3115_ = select(_e740, 0u, _e1558.member_1);
                                        } else {
                                            phi_3115_ = _e1749;
                                        }
                                        let _e1755 = phi_3115_;
                                        phi_3389_ = _e1556;
                                        phi_3117_ = _e1558;
                                        phi_3118_ = (_e717 - 1u);
                                        phi_3119_ = select(_e1747, false, _e745);
                                        phi_3120_ = _e1755;
                                        phi_3121_ = select(_e1751, _e742, _e745);
                                    } else {
                                        phi_3389_ = _e713;
                                        phi_3117_ = _e715;
                                        phi_3118_ = _e717;
                                        phi_3119_ = _e738;
                                        phi_3120_ = _e740;
                                        phi_3121_ = _e742;
                                    }
                                    let _e1759 = phi_3389_;
                                    let _e1761 = phi_3117_;
                                    let _e1763 = phi_3118_;
                                    let _e1765 = phi_3119_;
                                    let _e1767 = phi_3120_;
                                    let _e1769 = phi_3121_;
                                    phi_3388_ = _e1759;
                                    phi_3122_ = _e1761;
                                    phi_3123_ = _e1763;
                                    phi_3124_ = _e1765;
                                    phi_3125_ = _e1767;
                                    phi_3126_ = _e1769;
                                } else {
                                    phi_3388_ = _e713;
                                    phi_3122_ = type_55();
                                    phi_3123_ = u32();
                                    phi_3124_ = bool();
                                    phi_3125_ = u32();
                                    phi_3126_ = u32();
                                }
                                let _e1771 = phi_3388_;
                                let _e1773 = phi_3122_;
                                let _e1775 = phi_3123_;
                                let _e1777 = phi_3124_;
                                let _e1779 = phi_3125_;
                                let _e1781 = phi_3126_;
                                phi_3387_ = _e1771;
                                phi_1175_ = _e1773;
                                phi_1178_ = _e1775;
                                phi_1180_ = _e1777;
                                phi_1182_ = _e1779;
                                phi_1184_ = _e1781;
                                phi_3127_ = _e727;
                            } else {
                                phi_3387_ = _e713;
                                phi_1175_ = type_55();
                                phi_1178_ = u32();
                                phi_1180_ = bool();
                                phi_1182_ = u32();
                                phi_1184_ = u32();
                                phi_3127_ = false;
                            }
                            let _e1783 = phi_3387_;
                            let _e1785 = phi_1175_;
                            let _e1787 = phi_1178_;
                            let _e1789 = phi_1180_;
                            let _e1791 = phi_1182_;
                            let _e1793 = phi_1184_;
                            let _e1795 = phi_3127_;
                            continue;
                            continuing {
                                phi_3200_ = _e1783;
                                phi_1174_ = _e1785;
                                phi_1177_ = _e1787;
                                phi_1179_ = _e1789;
                                phi_1181_ = _e1791;
                                phi_1183_ = _e1793;
                                phi_3386_ = _e1783;
                                break if !(_e1795);
                            }
                        }
                        let _e1798 = phi_3386_;
                        if _e1798 {
                            break;
                        }
                        let _e1800 = local_2;
                        if _e1800.member_1 {
                        } else {
                            if _e240 {
                            } else {
                                break;
                            }
                            let _e1804 = global_9.member[_e100];
                            if _e101 {
                            } else {
                                break;
                            }
                            let _e1808 = global_8.member[_e100].member_1;
                            if _e240 {
                            } else {
                                break;
                            }
                            global_9.member[_e100] = type_30(_e1804.member, _e1804.member_1, _e1804.member_2, array<f32, 3>((_e1804.member_3[0] + (_e1808[0] * _e1804.member_1[0])), (_e1804.member_3[1] + (_e1808[1] * _e1804.member_1[1])), (_e1804.member_3[2] + (_e1808[2] * _e1804.member_1[2]))), _e1804.member_4);
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
