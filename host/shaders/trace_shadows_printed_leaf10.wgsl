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
    member_1: bool,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<i32>,
}

struct type_49 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_51 {
    member: array<type_49>,
}

struct type_54 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_56 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_58 {
    member: array<type_56>,
}

struct type_62 {
    member: type_54,
    member_1: u32,
}

struct type_67 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_26;
@group(0) @binding(1) 
var<uniform> global_3: type_42;
@group(0) @binding(2) 
var<uniform> global_4: type_42;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_45;
@group(0) @binding(9) 
var<storage, read_write> global_7: type_67;
@group(0) @binding(7) 
var<storage> global_8: type_32;
@group(0) @binding(3) 
var<storage> global_9: type_51;
@group(0) @binding(4) 
var<storage> global_10: type_58;

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
    var phi_277_: u32;
    var phi_321_: i32;
    var phi_345_: type_36;
    var phi_495_: i32;
    var phi_496_: i32;
    var phi_506_: bool;
    var phi_516_: u32;
    var phi_517_: u32;
    var phi_519_: bool;
    var phi_524_: u32;
    var phi_556_: i32;
    var phi_574_: f32;
    var phi_580_: f32;
    var phi_591_: f32;
    var phi_597_: f32;
    var phi_620_: f32;
    var phi_631_: f32;
    var phi_640_: f32;
    var phi_646_: f32;
    var phi_657_: f32;
    var phi_663_: f32;
    var phi_686_: f32;
    var phi_697_: f32;
    var phi_706_: f32;
    var phi_712_: f32;
    var phi_723_: f32;
    var phi_729_: f32;
    var phi_752_: f32;
    var phi_763_: f32;
    var phi_863_: f32;
    var phi_864_: f32;
    var phi_3591_: bool;
    var phi_937_: type_40;
    var phi_940_: type_62;
    var phi_942_: u32;
    var phi_944_: bool;
    var phi_946_: u32;
    var phi_957_: bool;
    var phi_1043_: type_62;
    var phi_1044_: bool;
    var phi_1045_: u32;
    var phi_2549_: type_49;
    var phi_3381_: type_62;
    var phi_3458_: type_62;
    var phi_3459_: type_62;
    var phi_3460_: u32;
    var phi_3462_: type_62;
    var phi_3463_: u32;
    var phi_3464_: bool;
    var phi_3471_: type_62;
    var phi_3476_: type_62;
    var phi_3477_: bool;
    var phi_1064_: type_40;
    var phi_1067_: type_8;
    var phi_1068_: type_8;
    var phi_1090_: type_8;
    var phi_1115_: u32;
    var phi_1131_: type_56;
    var phi_1507_: bool;
    var phi_1536_: bool;
    var phi_1913_: f32;
    var phi_1914_: f32;
    var phi_1915_: f32;
    var phi_1916_: f32;
    var phi_1917_: vec3<f32>;
    var phi_1918_: vec3<f32>;
    var phi_1919_: vec3<f32>;
    var phi_1920_: vec3<f32>;
    var phi_1951_: bool;
    var phi_1960_: vec3<f32>;
    var phi_2125_: f32;
    var phi_2127_: f32;
    var phi_2128_: bool;
    var phi_2148_: f32;
    var phi_2149_: f32;
    var phi_2172_: type_22;
    var phi_2174_: type_22;
    var phi_2175_: bool;
    var phi_2179_: type_22;
    var phi_2180_: type_22;
    var phi_2181_: type_22;
    var phi_2182_: bool;
    var phi_2186_: type_22;
    var phi_2187_: bool;
    var phi_2188_: type_22;
    var phi_2189_: bool;
    var phi_2190_: bool;
    var phi_2191_: type_22;
    var phi_2192_: bool;
    var phi_2193_: bool;
    var phi_2201_: type_22;
    var phi_2202_: bool;
    var phi_2206_: type_22;
    var phi_2229_: u32;
    var phi_2243_: i32;
    var phi_2259_: vec3<f32>;
    var phi_2260_: vec3<f32>;
    var phi_2272_: vec3<f32>;
    var phi_2273_: vec3<f32>;
    var phi_2285_: vec3<f32>;
    var phi_2286_: vec3<f32>;
    var phi_2322_: vec3<f32>;
    var phi_2504_: f32;
    var phi_2522_: bool;
    var phi_2523_: bool;
    var phi_2528_: type_40;
    var phi_2529_: type_40;
    var phi_1065_: type_40;
    var phi_3585_: bool;
    var local_10: type_40;
    var phi_3773_: bool;
    var phi_3479_: type_40;
    var phi_3480_: type_62;
    var phi_3481_: bool;
    var phi_3482_: u32;
    var phi_3772_: bool;
    var phi_3483_: type_40;
    var phi_3484_: type_62;
    var phi_3485_: u32;
    var phi_3486_: bool;
    var phi_3487_: u32;
    var phi_3771_: bool;
    var phi_3488_: type_40;
    var phi_3489_: type_62;
    var phi_3490_: u32;
    var phi_3491_: bool;
    var phi_3492_: u32;
    var phi_3770_: bool;
    var phi_938_: type_40;
    var phi_941_: type_62;
    var phi_943_: u32;
    var phi_945_: bool;
    var phi_947_: u32;
    var phi_3493_: bool;
    var phi_3769_: bool;
    var local_11: type_40;
    var local_12: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e86 = global;
            let _e89 = arrayLength((&global_9.member));
            let _e104 = arrayLength((&global_7.member));
            let _e108 = global_4.member[0u][0u];
            let _e112 = global_4.member[0u][1u];
            let _e116 = global_4.member[0u][2u];
            let _e120 = global_4.member[1u][0u];
            let _e124 = global_4.member[1u][1u];
            let _e128 = global_4.member[1u][2u];
            let _e132 = global_4.member[1u][3u];
            let _e136 = (_e86.x + (_e86.y * 2097152u));
            let _e143 = (_e136 < arrayLength((&global_8.member)));
            if _e143 {
                if _e143 {
                } else {
                    break;
                }
                let _e147 = global_8.member[_e136].member_2;
                phi_277_ = _e147;
            } else {
                phi_277_ = 4294967295u;
            }
            let _e149 = phi_277_;
            let _e152 = global_1.member[0u];
            let _e156 = global_3.member[0u][0u];
            let _e160 = global_3.member[0u][1u];
            let _e164 = global_3.member[0u][2u];
            let _e168 = global_3.member[0u][3u];
            let _e172 = global_3.member[1u][0u];
            let _e176 = global_3.member[1u][1u];
            let _e180 = global_3.member[1u][2u];
            let _e184 = global_3.member[1u][3u];
            let _e185 = bitcast<f32>(_e156);
            let _e186 = bitcast<f32>(_e160);
            let _e187 = bitcast<f32>(_e164);
            let _e189 = bitcast<f32>(_e172);
            let _e190 = array<u32, 3>(_e176, _e180, _e184);
            let _e192 = bitcast<i32>(_e152);
            if (_e192 < -126i) {
                phi_321_ = -126i;
            } else {
                phi_321_ = select(_e192, 127i, (_e192 > 127i));
            }
            let _e197 = phi_321_;
            let _e202 = bitcast<f32>((bitcast<u32>((_e197 + 127i)) << bitcast<u32>(23i)));
            let _e208 = bitcast<f32>((bitcast<u32>(((_e192 - _e197) + 127i)) << bitcast<u32>(23i)));
            if (_e168 == 0u) {
                phi_345_ = type_36(array<f32, 3>(_e185, _e186, _e187), _e168, _e189, _e190);
            } else {
                phi_345_ = type_36(array<f32, 3>(((_e185 * _e202) * _e208), ((_e186 * _e202) * _e208), ((_e187 * _e202) * _e208)), _e168, ((_e189 * _e202) * _e208), _e190);
            }
            let _e221 = phi_345_;
            if _e143 {
                let _e222 = (_e136 < arrayLength((&global_2.member)));
                if _e222 {
                    if _e143 {
                    } else {
                        break;
                    }
                    let _e227 = global_8.member[_e136].member.member_1;
                    let _e232 = global_8.member[_e136].member.member_3;
                    if (_e227 <= _e232) {
                        let _e234 = (1u < _e104);
                        if _e234 {
                            if (0u < _e104) {
                            } else {
                                break;
                            }
                            let _e238 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e238 + 1u) < _e238) {
                                if _e234 {
                                } else {
                                    break;
                                }
                                let _e243 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e143 {
                        } else {
                            break;
                        }
                        let _e253 = global_8.member[_e136].member.member_2[0u];
                        let _e255 = (bitcast<u32>(_e253) & 2147483647u);
                        let _e261 = global_8.member[_e136].member.member_2[1u];
                        let _e263 = (bitcast<u32>(_e261) & 2147483647u);
                        let _e269 = global_8.member[_e136].member.member_2[2u];
                        let _e271 = (bitcast<u32>(_e269) & 2147483647u);
                        let _e277 = global_8.member[_e136].member.member[0u];
                        let _e279 = (bitcast<u32>(_e277) & 2147483647u);
                        let _e285 = global_8.member[_e136].member.member[1u];
                        let _e287 = (bitcast<u32>(_e285) & 2147483647u);
                        let _e293 = global_8.member[_e136].member.member[2u];
                        let _e295 = (bitcast<u32>(_e293) & 2147483647u);
                        let _e297 = select(_e263, _e255, (_e263 < _e255));
                        let _e299 = select(_e271, _e297, (_e271 < _e297));
                        let _e301 = select(_e279, _e299, (_e279 < _e299));
                        let _e303 = select(_e287, _e301, (_e287 < _e301));
                        let _e305 = select(_e295, _e303, (_e295 < _e303));
                        let _e307 = (bitcast<u32>(_e227) & 2147483647u);
                        let _e316 = (((select(_e307, _e305, (_e307 < _e305)) < 2139095040u) && ((bitcast<u32>(_e232) & 2147483647u) <= 2139095040u)) && (_e299 > 0u));
                        if _e316 {
                            let _e319 = (bitcast<u32>(bitcast<f32>(_e299)) & 2147483647u);
                            if (_e319 >= 8388608u) {
                                phi_495_ = (bitcast<i32>((_e319 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_495_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e319)), 32u, (_e319 == 0u))));
                            }
                            let _e333 = phi_495_;
                            phi_496_ = _e333;
                        } else {
                            phi_496_ = 0i;
                        }
                        let _e335 = phi_496_;
                        let _e336 = (_e255 == _e299);
                        if _e336 {
                            phi_506_ = true;
                        } else {
                            phi_506_ = (_e263 == _e299);
                        }
                        let _e339 = phi_506_;
                        let _e340 = select(1u, 0u, _e336);
                        if _e339 {
                            let _e341 = (_e340 + 1u);
                            phi_516_ = _e341;
                            phi_517_ = _e341;
                            phi_519_ = select(true, false, (_e341 == 2u));
                        } else {
                            phi_516_ = u32();
                            phi_517_ = 0u;
                            phi_519_ = true;
                        }
                        let _e345 = phi_516_;
                        let _e347 = phi_517_;
                        let _e349 = phi_519_;
                        if _e349 {
                            phi_524_ = (_e347 + 1u);
                        } else {
                            phi_524_ = 0u;
                        }
                        let _e353 = phi_524_;
                        let _e354 = select(_e345, _e347, _e349);
                        let _e355 = select(_e340, select(2u, _e340, _e339), _e349);
                        let _e356 = -(_e335);
                        if (_e356 < -126i) {
                            phi_556_ = -126i;
                        } else {
                            phi_556_ = select(_e356, 127i, (_e356 > 127i));
                        }
                        let _e361 = phi_556_;
                        let _e366 = bitcast<f32>((bitcast<u32>((_e361 + 127i)) << bitcast<u32>(23i)));
                        let _e372 = bitcast<f32>((bitcast<u32>(((_e356 - _e361) + 127i)) << bitcast<u32>(23i)));
                        let _e377 = global_8.member[_e136].member.member;
                        let _e378 = (_e354 == 0u);
                        if _e378 {
                            phi_574_ = _e377[0];
                        } else {
                            phi_574_ = _e377[1];
                        }
                        let _e382 = phi_574_;
                        let _e383 = (_e354 == 2u);
                        if _e383 {
                            phi_580_ = _e377[2];
                        } else {
                            phi_580_ = _e382;
                        }
                        let _e386 = phi_580_;
                        let _e387 = global_8.member[_e136].member.member_2;
                        if _e378 {
                            phi_591_ = _e387[0];
                        } else {
                            phi_591_ = _e387[1];
                        }
                        let _e391 = phi_591_;
                        if _e383 {
                            phi_597_ = _e387[2];
                        } else {
                            phi_597_ = _e391;
                        }
                        let _e394 = phi_597_;
                        let _e396 = ((_e394 * _e366) * _e372);
                        let _e400 = (bitcast<f32>((bitcast<u32>(_e396) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e400 {
                            let _e404 = (bitcast<f32>((bitcast<u32>(_e386) & 2147483647u)) * 0.00000011920929f);
                            phi_620_ = select(0.00000000000011368684f, _e404, (_e404 > 0.00000000000011368684f));
                        } else {
                            phi_620_ = 0f;
                        }
                        let _e408 = phi_620_;
                        let _e409 = (_e386 + _e408);
                        let _e410 = (_e386 - _e408);
                        let _e411 = select(_e396, 0f, _e400);
                        if _e400 {
                            phi_631_ = 38685626000000000000000000f;
                        } else {
                            phi_631_ = (1f / _e396);
                        }
                        let _e414 = phi_631_;
                        let _e415 = (_e353 == 0u);
                        if _e415 {
                            phi_640_ = _e377[0];
                        } else {
                            phi_640_ = _e377[1];
                        }
                        let _e419 = phi_640_;
                        let _e420 = (_e353 == 2u);
                        if _e420 {
                            phi_646_ = _e377[2];
                        } else {
                            phi_646_ = _e419;
                        }
                        let _e423 = phi_646_;
                        if _e415 {
                            phi_657_ = _e387[0];
                        } else {
                            phi_657_ = _e387[1];
                        }
                        let _e427 = phi_657_;
                        if _e420 {
                            phi_663_ = _e387[2];
                        } else {
                            phi_663_ = _e427;
                        }
                        let _e430 = phi_663_;
                        let _e432 = ((_e430 * _e366) * _e372);
                        let _e436 = (bitcast<f32>((bitcast<u32>(_e432) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e436 {
                            let _e440 = (bitcast<f32>((bitcast<u32>(_e423) & 2147483647u)) * 0.00000011920929f);
                            phi_686_ = select(0.00000000000011368684f, _e440, (_e440 > 0.00000000000011368684f));
                        } else {
                            phi_686_ = 0f;
                        }
                        let _e444 = phi_686_;
                        let _e445 = (_e423 + _e444);
                        let _e446 = (_e423 - _e444);
                        let _e447 = select(_e432, 0f, _e436);
                        if _e436 {
                            phi_697_ = 38685626000000000000000000f;
                        } else {
                            phi_697_ = (1f / _e432);
                        }
                        let _e450 = phi_697_;
                        let _e451 = (_e355 == 0u);
                        if _e451 {
                            phi_706_ = _e377[0];
                        } else {
                            phi_706_ = _e377[1];
                        }
                        let _e455 = phi_706_;
                        let _e456 = (_e355 == 2u);
                        if _e456 {
                            phi_712_ = _e377[2];
                        } else {
                            phi_712_ = _e455;
                        }
                        let _e459 = phi_712_;
                        if _e451 {
                            phi_723_ = _e387[0];
                        } else {
                            phi_723_ = _e387[1];
                        }
                        let _e463 = phi_723_;
                        if _e456 {
                            phi_729_ = _e387[2];
                        } else {
                            phi_729_ = _e463;
                        }
                        let _e466 = phi_729_;
                        let _e468 = ((_e466 * _e366) * _e372);
                        let _e472 = (bitcast<f32>((bitcast<u32>(_e468) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e472 {
                            let _e476 = (bitcast<f32>((bitcast<u32>(_e459) & 2147483647u)) * 0.00000011920929f);
                            phi_752_ = select(0.00000000000011368684f, _e476, (_e476 > 0.00000000000011368684f));
                        } else {
                            phi_752_ = 0f;
                        }
                        let _e480 = phi_752_;
                        let _e481 = (_e459 + _e480);
                        let _e482 = (_e459 - _e480);
                        let _e483 = select(_e468, 0f, _e472);
                        if _e472 {
                            phi_763_ = 38685626000000000000000000f;
                        } else {
                            phi_763_ = (1f / _e468);
                        }
                        let _e486 = phi_763_;
                        let _e489 = bitcast<f32>((bitcast<u32>(_e386) & 2147483647u));
                        let _e492 = bitcast<f32>((bitcast<u32>(_e423) & 2147483647u));
                        let _e494 = select(_e492, _e489, (_e489 > _e492));
                        let _e497 = bitcast<f32>((bitcast<u32>(_e459) & 2147483647u));
                        if (_e316 && (select(_e497, _e494, (_e494 > _e497)) <= 1099511600000f)) {
                            let _e502 = (_e335 / 3i);
                            let _e509 = bitcast<f32>((bitcast<u32>((_e502 + 127i)) << bitcast<u32>(23i)));
                            let _e516 = bitcast<f32>((bitcast<u32>(((_e335 - (2i * _e502)) + 127i)) << bitcast<u32>(23i)));
                            let _e517 = (((_e227 * _e509) * _e509) * _e516);
                            let _e519 = select(340282350000000000000000000000000000000f, _e517, (_e517 < 340282350000000000000000000000000000000f));
                            let _e524 = (((_e232 * _e509) * _e509) * _e516);
                            let _e526 = select(340282350000000000000000000000000000000f, _e524, (_e524 < 340282350000000000000000000000000000000f));
                            phi_863_ = select(-340282350000000000000000000000000000000f, _e526, (_e526 > -340282350000000000000000000000000000000f));
                            phi_864_ = select(-340282350000000000000000000000000000000f, _e519, (_e519 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_863_ = 0f;
                            phi_864_ = 1f;
                        }
                        let _e530 = phi_863_;
                        let _e532 = phi_864_;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e108), bitcast<f32>(_e112), bitcast<f32>(_e116));
                        let _e537 = (_e354 % 3u);
                        let _e538 = (_e537 < 3u);
                        if _e538 {
                        } else {
                            break;
                        }
                        let _e540 = local_9[_e537];
                        let _e541 = (_e353 % 3u);
                        let _e542 = (_e541 < 3u);
                        if _e542 {
                        } else {
                            break;
                        }
                        let _e544 = local_9[_e541];
                        let _e545 = (_e355 % 3u);
                        let _e546 = (_e545 < 3u);
                        if _e546 {
                        } else {
                            break;
                        }
                        let _e548 = local_9[_e545];
                        local_8 = array<f32, 3>(bitcast<f32>(_e120), bitcast<f32>(_e124), bitcast<f32>(_e128));
                        if _e538 {
                        } else {
                            break;
                        }
                        let _e552 = local_8[_e537];
                        if _e542 {
                        } else {
                            break;
                        }
                        let _e554 = local_8[_e541];
                        if _e546 {
                        } else {
                            break;
                        }
                        let _e556 = local_8[_e545];
                        phi_3591_ = false;
                        phi_937_ = type_40(_e530, false);
                        phi_940_ = type_62(type_54(array<f32, 3>(_e540, _e544, _e548), array<f32, 3>(_e552, _e554, _e556)), select(0u, 2147483648u, (_e89 == 0u)));
                        phi_942_ = ((3u * _e89) + 1u);
                        phi_944_ = (_e532 <= _e530);
                        phi_946_ = 0u;
                        loop {
                            let _e564 = phi_3591_;
                            let _e566 = phi_937_;
                            let _e568 = phi_940_;
                            let _e570 = phi_942_;
                            let _e572 = phi_944_;
                            let _e574 = phi_946_;
                            local_11 = _e566;
                            if _e572 {
                                phi_957_ = true;
                            } else {
                                phi_957_ = (_e574 > 0u);
                            }
                            let _e577 = phi_957_;
                            if _e577 {
                                let _e578 = (_e570 > 0u);
                                if _e578 {
                                    if _e572 {
                                        phi_1043_ = _e568;
                                        phi_1044_ = _e572;
                                        phi_1045_ = _e574;
                                    } else {
                                        let _e579 = (_e574 - 1u);
                                        let _e580 = (_e579 % 128u);
                                        let _e581 = (_e580 < 128u);
                                        if _e581 {
                                        } else {
                                            phi_3769_ = true;
                                            break;
                                        }
                                        let _e583 = local_6[_e580];
                                        if _e581 {
                                        } else {
                                            phi_3769_ = true;
                                            break;
                                        }
                                        let _e585 = local_5[_e580];
                                        if _e581 {
                                        } else {
                                            phi_3769_ = true;
                                            break;
                                        }
                                        let _e587 = local_4[_e580];
                                        if _e581 {
                                        } else {
                                            phi_3769_ = true;
                                            break;
                                        }
                                        let _e589 = local_3[_e580];
                                        if _e581 {
                                        } else {
                                            phi_3769_ = true;
                                            break;
                                        }
                                        let _e592 = local_2[_e580];
                                        if _e581 {
                                        } else {
                                            phi_3769_ = true;
                                            break;
                                        }
                                        let _e594 = local_1[_e580];
                                        if _e581 {
                                        } else {
                                            phi_3769_ = true;
                                            break;
                                        }
                                        let _e596 = local[_e580];
                                        if _e581 {
                                        } else {
                                            phi_3769_ = true;
                                            break;
                                        }
                                        let _e601 = local_7[_e580];
                                        phi_1043_ = type_62(type_54(array<f32, 3>(_e585, _e587, _e589), array<f32, 3>(_e592, _e594, _e596)), _e583);
                                        phi_1044_ = (_e601 <= _e566.member);
                                        phi_1045_ = _e579;
                                    }
                                    let _e605 = phi_1043_;
                                    let _e607 = phi_1044_;
                                    let _e609 = phi_1045_;
                                    if _e607 {
                                        if ((_e605.member_1 & 2147483648u) != 0u) {
                                            phi_1064_ = _e566;
                                            phi_1067_ = type_8(0u, ((_e605.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e962 = phi_1064_;
                                                let _e964 = phi_1067_;
                                                local_10 = _e962;
                                                local_12 = _e962;
                                                if (_e964.member < _e964.member_1) {
                                                    phi_1068_ = type_8((_e964.member + 1u), _e964.member_1);
                                                    phi_1090_ = type_8(1u, _e964.member);
                                                } else {
                                                    phi_1068_ = _e964;
                                                    phi_1090_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e977 = phi_1068_;
                                                let _e979 = phi_1090_;
                                                let _e983 = (bitcast<i32>(_e979.member) != 0i);
                                                if _e983 {
                                                    let _e984 = ((_e605.member_1 & 268435455u) + _e979.member_1);
                                                    let _e985 = (_e984 < arrayLength((&global_10.member)));
                                                    if _e985 {
                                                        if _e985 {
                                                        } else {
                                                            phi_3585_ = true;
                                                            break;
                                                        }
                                                        let _e988 = global_10.member[_e984].member_1;
                                                        phi_1115_ = _e988;
                                                    } else {
                                                        phi_1115_ = 4294967295u;
                                                    }
                                                    let _e990 = phi_1115_;
                                                    if _e985 {
                                                        if _e985 {
                                                        } else {
                                                            phi_3585_ = true;
                                                            break;
                                                        }
                                                        let _e992 = global_10.member[_e984];
                                                        phi_1131_ = _e992;
                                                    } else {
                                                        phi_1131_ = type_56(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e994 = phi_1131_;
                                                    let _e1006 = ((10u * _e354) & 31u);
                                                    let _e1009 = ((_e994.member[0] >> bitcast<u32>(_e1006)) & 1023u);
                                                    let _e1014 = bitcast<f32>((bitcast<u32>(((_e605.member.member_1[0] - _e605.member.member[0]) * 0.0009775171f)) ^ _e132));
                                                    let _e1020 = (_e605.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1009) * _e1014)) ^ _e132)));
                                                    let _e1024 = select(select(_e605.member.member_1[0], _e1020, (_e1020 < _e605.member.member_1[0])), _e605.member.member_1[0], (_e1009 == 1023u));
                                                    let _e1026 = ((10u * _e353) & 31u);
                                                    let _e1029 = ((_e994.member[0] >> bitcast<u32>(_e1026)) & 1023u);
                                                    let _e1034 = bitcast<f32>((bitcast<u32>(((_e605.member.member_1[1] - _e605.member.member[1]) * 0.0009775171f)) ^ _e132));
                                                    let _e1040 = (_e605.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1029) * _e1034)) ^ _e132)));
                                                    let _e1044 = select(select(_e605.member.member_1[1], _e1040, (_e1040 < _e605.member.member_1[1])), _e605.member.member_1[1], (_e1029 == 1023u));
                                                    let _e1046 = ((10u * _e355) & 31u);
                                                    let _e1049 = ((_e994.member[0] >> bitcast<u32>(_e1046)) & 1023u);
                                                    let _e1054 = bitcast<f32>((bitcast<u32>(((_e605.member.member_1[2] - _e605.member.member[2]) * 0.0009775171f)) ^ _e132));
                                                    let _e1060 = (_e605.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1049) * _e1054)) ^ _e132)));
                                                    let _e1064 = select(select(_e605.member.member_1[2], _e1060, (_e1060 < _e605.member.member_1[2])), _e605.member.member_1[2], (_e1049 == 1023u));
                                                    let _e1068 = ((_e994.member[1] >> bitcast<u32>(_e1006)) & 1023u);
                                                    let _e1074 = (_e605.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1068) * _e1014)) ^ _e132)));
                                                    let _e1078 = select(select(_e605.member.member_1[0], _e1074, (_e1074 < _e605.member.member_1[0])), _e605.member.member_1[0], (_e1068 == 1023u));
                                                    let _e1081 = ((_e994.member[1] >> bitcast<u32>(_e1026)) & 1023u);
                                                    let _e1087 = (_e605.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1081) * _e1034)) ^ _e132)));
                                                    let _e1091 = select(select(_e605.member.member_1[1], _e1087, (_e1087 < _e605.member.member_1[1])), _e605.member.member_1[1], (_e1081 == 1023u));
                                                    let _e1094 = ((_e994.member[1] >> bitcast<u32>(_e1046)) & 1023u);
                                                    let _e1100 = (_e605.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1094) * _e1054)) ^ _e132)));
                                                    let _e1104 = select(select(_e605.member.member_1[2], _e1100, (_e1100 < _e605.member.member_1[2])), _e605.member.member_1[2], (_e1094 == 1023u));
                                                    let _e1108 = ((_e994.member[2] >> bitcast<u32>(_e1006)) & 1023u);
                                                    let _e1114 = (_e605.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1108) * _e1014)) ^ _e132)));
                                                    let _e1118 = select(select(_e605.member.member_1[0], _e1114, (_e1114 < _e605.member.member_1[0])), _e605.member.member_1[0], (_e1108 == 1023u));
                                                    let _e1121 = ((_e994.member[2] >> bitcast<u32>(_e1026)) & 1023u);
                                                    let _e1127 = (_e605.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1121) * _e1034)) ^ _e132)));
                                                    let _e1131 = select(select(_e605.member.member_1[1], _e1127, (_e1127 < _e605.member.member_1[1])), _e605.member.member_1[1], (_e1121 == 1023u));
                                                    let _e1134 = ((_e994.member[2] >> bitcast<u32>(_e1046)) & 1023u);
                                                    let _e1140 = (_e605.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1134) * _e1054)) ^ _e132)));
                                                    let _e1144 = select(select(_e605.member.member_1[2], _e1140, (_e1140 < _e605.member.member_1[2])), _e605.member.member_1[2], (_e1134 == 1023u));
                                                    let _e1148 = (_e1064 - _e459);
                                                    let _e1151 = (((_e1024 - _e386) * _e483) - (_e1148 * _e411));
                                                    let _e1154 = (((_e1044 - _e423) * _e483) - (_e1148 * _e447));
                                                    let _e1157 = (_e1104 - _e459);
                                                    let _e1160 = (((_e1078 - _e386) * _e483) - (_e1157 * _e411));
                                                    let _e1163 = (((_e1091 - _e423) * _e483) - (_e1157 * _e447));
                                                    let _e1166 = (_e1144 - _e459);
                                                    let _e1169 = (((_e1118 - _e386) * _e483) - (_e1166 * _e411));
                                                    let _e1172 = (((_e1131 - _e423) * _e483) - (_e1166 * _e447));
                                                    let _e1173 = (_e1169 * _e1163);
                                                    let _e1174 = (_e1172 * _e1160);
                                                    let _e1175 = (_e1151 * _e1172);
                                                    let _e1176 = (_e1154 * _e1169);
                                                    let _e1177 = (_e1160 * _e1154);
                                                    let _e1178 = (_e1163 * _e1151);
                                                    let _e1183 = (((_e1173 >= _e1174) && (_e1175 >= _e1176)) && (_e1177 >= _e1178));
                                                    if (_e1183 || (((_e1173 <= _e1174) && (_e1175 <= _e1176)) && (_e1177 <= _e1178))) {
                                                        let _e1190 = select(-1f, 1f, _e1183);
                                                        let _e1192 = ((_e1173 - _e1174) * _e1190);
                                                        let _e1194 = select(0f, _e1192, (_e1192 > 0f));
                                                        let _e1196 = ((_e1175 - _e1176) * _e1190);
                                                        let _e1198 = select(0f, _e1196, (_e1196 > 0f));
                                                        let _e1200 = ((_e1177 - _e1178) * _e1190);
                                                        let _e1202 = select(0f, _e1200, (_e1200 > 0f));
                                                        let _e1204 = ((_e1194 + _e1198) + _e1202);
                                                        if (_e1204 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2191_ = type_22();
                                                            phi_2192_ = true;
                                                            phi_2193_ = false;
                                                        } else {
                                                            let _e1207 = select(_e1160, _e1151, (_e1151 < _e1160));
                                                            if (select(_e1169, _e1207, (_e1207 < _e1169)) > 0f) {
                                                                phi_1507_ = true;
                                                            } else {
                                                                let _e1212 = select(_e1160, _e1151, (_e1151 > _e1160));
                                                                phi_1507_ = (select(_e1169, _e1212, (_e1212 > _e1169)) < 0f);
                                                            }
                                                            let _e1217 = phi_1507_;
                                                            if _e1217 {
                                                                phi_2188_ = type_22();
                                                                phi_2189_ = true;
                                                                phi_2190_ = false;
                                                            } else {
                                                                let _e1219 = select(_e1163, _e1154, (_e1154 < _e1163));
                                                                if (select(_e1172, _e1219, (_e1219 < _e1172)) > 0f) {
                                                                    phi_1536_ = true;
                                                                } else {
                                                                    let _e1224 = select(_e1163, _e1154, (_e1154 > _e1163));
                                                                    phi_1536_ = (select(_e1172, _e1224, (_e1224 > _e1172)) < 0f);
                                                                }
                                                                let _e1229 = phi_1536_;
                                                                if _e1229 {
                                                                    phi_2186_ = type_22();
                                                                    phi_2187_ = false;
                                                                } else {
                                                                    let _e1231 = select(_e1078, _e1024, (_e1024 < _e1078));
                                                                    let _e1235 = select(_e1078, _e1024, (_e1024 > _e1078));
                                                                    let _e1239 = select(_e1091, _e1044, (_e1044 < _e1091));
                                                                    let _e1243 = select(_e1091, _e1044, (_e1044 > _e1091));
                                                                    let _e1247 = select(_e1104, _e1064, (_e1064 < _e1104));
                                                                    let _e1251 = select(_e1104, _e1064, (_e1064 > _e1104));
                                                                    let _e1256 = ((select(_e1118, _e1231, (_e1231 < _e1118)) - _e409) * _e414);
                                                                    let _e1257 = ((select(_e1118, _e1235, (_e1235 > _e1118)) - _e410) * _e414);
                                                                    let _e1260 = ((select(_e1131, _e1239, (_e1239 < _e1131)) - _e445) * _e450);
                                                                    let _e1261 = ((select(_e1131, _e1243, (_e1243 > _e1131)) - _e446) * _e450);
                                                                    let _e1264 = ((select(_e1144, _e1247, (_e1247 < _e1144)) - _e481) * _e486);
                                                                    let _e1265 = ((select(_e1144, _e1251, (_e1251 > _e1144)) - _e482) * _e486);
                                                                    let _e1267 = select(_e1265, _e1264, (_e1264 < _e1265));
                                                                    let _e1269 = select(_e1265, _e1264, (_e1264 > _e1265));
                                                                    let _e1271 = select(_e1257, _e1256, (_e1256 < _e1257));
                                                                    let _e1273 = select(_e1261, _e1260, (_e1260 < _e1261));
                                                                    let _e1275 = select(_e1273, _e1271, (_e1271 > _e1273));
                                                                    let _e1277 = select(_e1267, _e1275, (_e1275 > _e1267));
                                                                    let _e1279 = select(_e1257, _e1256, (_e1256 > _e1257));
                                                                    let _e1281 = select(_e1261, _e1260, (_e1260 > _e1261));
                                                                    let _e1283 = select(_e1281, _e1279, (_e1279 < _e1281));
                                                                    let _e1285 = select(_e1269, _e1283, (_e1283 < _e1269));
                                                                    let _e1286 = -(_e1267);
                                                                    let _e1292 = select(_e532, _e1277, (_e1277 > _e532));
                                                                    if (_e1292 > (_e1285 + (select(_e1286, _e1269, (_e1269 > _e1286)) * 0.0000019073523f))) {
                                                                        phi_2181_ = type_22();
                                                                        phi_2182_ = true;
                                                                    } else {
                                                                        let _e1294 = (_e1292 > _e962.member);
                                                                        if _e1294 {
                                                                            phi_2180_ = type_22();
                                                                        } else {
                                                                            let _e1295 = vec3<f32>(_e1024, _e1044, _e1064);
                                                                            let _e1296 = vec3<f32>(_e1078, _e1091, _e1104);
                                                                            let _e1297 = vec3<f32>(_e1118, _e1131, _e1144);
                                                                            let _e1298 = (_e1078 - _e1024);
                                                                            let _e1299 = (_e1091 - _e1044);
                                                                            let _e1300 = (_e1104 - _e1064);
                                                                            let _e1301 = vec3<f32>(_e1298, _e1299, _e1300);
                                                                            let _e1302 = (_e1118 - _e1078);
                                                                            let _e1303 = (_e1131 - _e1091);
                                                                            let _e1304 = (_e1144 - _e1104);
                                                                            let _e1305 = vec3<f32>(_e1302, _e1303, _e1304);
                                                                            let _e1306 = (_e1024 - _e1118);
                                                                            let _e1307 = (_e1044 - _e1131);
                                                                            let _e1308 = (_e1064 - _e1144);
                                                                            let _e1309 = vec3<f32>(_e1306, _e1307, _e1308);
                                                                            let _e1312 = bitcast<f32>((bitcast<u32>(_e1298) & 2147483647u));
                                                                            let _e1315 = bitcast<f32>((bitcast<u32>(_e1299) & 2147483647u));
                                                                            let _e1317 = select(_e1315, _e1312, (_e1312 > _e1315));
                                                                            let _e1320 = bitcast<f32>((bitcast<u32>(_e1300) & 2147483647u));
                                                                            let _e1322 = select(_e1320, _e1317, (_e1317 > _e1320));
                                                                            let _e1325 = bitcast<f32>((bitcast<u32>(_e1302) & 2147483647u));
                                                                            let _e1328 = bitcast<f32>((bitcast<u32>(_e1303) & 2147483647u));
                                                                            let _e1330 = select(_e1328, _e1325, (_e1325 > _e1328));
                                                                            let _e1333 = bitcast<f32>((bitcast<u32>(_e1304) & 2147483647u));
                                                                            let _e1335 = select(_e1333, _e1330, (_e1330 > _e1333));
                                                                            let _e1338 = bitcast<f32>((bitcast<u32>(_e1306) & 2147483647u));
                                                                            let _e1341 = bitcast<f32>((bitcast<u32>(_e1307) & 2147483647u));
                                                                            let _e1343 = select(_e1341, _e1338, (_e1338 > _e1341));
                                                                            let _e1346 = bitcast<f32>((bitcast<u32>(_e1308) & 2147483647u));
                                                                            let _e1348 = select(_e1346, _e1343, (_e1343 > _e1346));
                                                                            let _e1350 = select(_e1335, _e1322, (_e1322 > _e1335));
                                                                            let _e1352 = select(_e1348, _e1350, (_e1350 > _e1348));
                                                                            if (_e1322 == _e1352) {
                                                                                phi_1913_ = _e1163;
                                                                                phi_1914_ = _e1160;
                                                                                phi_1915_ = _e1154;
                                                                                phi_1916_ = _e1151;
                                                                                phi_1917_ = _e1295;
                                                                                phi_1918_ = _e1309;
                                                                                phi_1919_ = _e1305;
                                                                                phi_1920_ = _e1301;
                                                                            } else {
                                                                                let _e1354 = (_e1335 == _e1352);
                                                                                let _e1359 = vec3(_e1354);
                                                                                phi_1913_ = select(_e1154, _e1172, _e1354);
                                                                                phi_1914_ = select(_e1151, _e1169, _e1354);
                                                                                phi_1915_ = select(_e1172, _e1163, _e1354);
                                                                                phi_1916_ = select(_e1169, _e1160, _e1354);
                                                                                phi_1917_ = select(_e1297, _e1296, _e1359);
                                                                                phi_1918_ = select(_e1305, _e1301, _e1359);
                                                                                phi_1919_ = select(_e1301, _e1309, _e1359);
                                                                                phi_1920_ = select(_e1309, _e1305, _e1359);
                                                                            }
                                                                            let _e1365 = phi_1913_;
                                                                            let _e1367 = phi_1914_;
                                                                            let _e1369 = phi_1915_;
                                                                            let _e1371 = phi_1916_;
                                                                            let _e1373 = phi_1917_;
                                                                            let _e1375 = phi_1918_;
                                                                            let _e1377 = phi_1919_;
                                                                            let _e1379 = phi_1920_;
                                                                            let _e1386 = ((_e1377.y * _e1375.z) - (_e1375.y * _e1377.z));
                                                                            let _e1391 = ((_e1377.z * _e1375.x) - (_e1375.z * _e1377.x));
                                                                            let _e1394 = ((_e1377.x * _e1375.y) - (_e1375.x * _e1377.y));
                                                                            if (_e1194 >= _e1198) {
                                                                                phi_1951_ = select(true, false, (_e1194 >= _e1202));
                                                                            } else {
                                                                                phi_1951_ = true;
                                                                            }
                                                                            let _e1399 = phi_1951_;
                                                                            if _e1399 {
                                                                                phi_1960_ = select(_e1297, _e1296, vec3((_e1198 >= _e1202)));
                                                                            } else {
                                                                                phi_1960_ = _e1295;
                                                                            }
                                                                            let _e1404 = phi_1960_;
                                                                            let _e1415 = (((_e1386 * (_e1404.x - _e386)) + (_e1391 * (_e1404.y - _e423))) + (_e1394 * (_e1404.z - _e459)));
                                                                            let _e1420 = (((_e1386 * _e411) + (_e1391 * _e447)) + (_e1394 * _e483));
                                                                            let _e1421 = (_e1367 - _e1371);
                                                                            let _e1422 = (_e1365 - _e1369);
                                                                            let _e1430 = (-(((_e1371 * _e1421) + (_e1369 * _e1422))) / ((_e1421 * _e1421) + (_e1422 * _e1422)));
                                                                            let _e1432 = select(1f, _e1430, (_e1430 < 1f));
                                                                            let _e1434 = select(0f, _e1432, (_e1432 > 0f));
                                                                            let _e1447 = ((_e1373.x + (_e1379.x * _e1434)) - _e386);
                                                                            let _e1448 = ((_e1373.y + (_e1379.y * _e1434)) - _e423);
                                                                            let _e1449 = ((_e1373.z + (_e1379.z * _e1434)) - _e459);
                                                                            let _e1450 = (_e1449 / _e483);
                                                                            let _e1462 = bitcast<f32>((bitcast<u32>(_e1447) & 2147483647u));
                                                                            let _e1465 = bitcast<f32>((bitcast<u32>(_e1448) & 2147483647u));
                                                                            let _e1467 = select(_e1465, _e1462, (_e1462 > _e1465));
                                                                            let _e1470 = bitcast<f32>((bitcast<u32>(_e1449) & 2147483647u));
                                                                            let _e1472 = select(_e1470, _e1467, (_e1467 > _e1470));
                                                                            let _e1478 = bitcast<f32>((bitcast<u32>(_e1386) & 2147483647u));
                                                                            let _e1481 = bitcast<f32>((bitcast<u32>(_e1391) & 2147483647u));
                                                                            let _e1483 = select(_e1481, _e1478, (_e1478 > _e1481));
                                                                            let _e1486 = bitcast<f32>((bitcast<u32>(_e1394) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1386 * _e1447) + (_e1391 * _e1448)) + (_e1394 * _e1449)) - _e1415)) & 2147483647u)) <= ((0.0000009536743f * select(_e1352, _e1472, (_e1472 > _e1352))) * select(_e1486, _e1483, (_e1483 > _e1486)))) {
                                                                                let _e1496 = bitcast<f32>((bitcast<u32>(_e1377.x) & 2147483647u));
                                                                                let _e1499 = bitcast<f32>((bitcast<u32>(_e1377.y) & 2147483647u));
                                                                                let _e1501 = select(_e1499, _e1496, (_e1496 > _e1499));
                                                                                let _e1504 = bitcast<f32>((bitcast<u32>(_e1377.z) & 2147483647u));
                                                                                let _e1510 = bitcast<f32>((bitcast<u32>(_e1375.x) & 2147483647u));
                                                                                let _e1513 = bitcast<f32>((bitcast<u32>(_e1375.y) & 2147483647u));
                                                                                let _e1515 = select(_e1513, _e1510, (_e1510 > _e1513));
                                                                                let _e1518 = bitcast<f32>((bitcast<u32>(_e1375.z) & 2147483647u));
                                                                                let _e1522 = (bitcast<f32>((bitcast<u32>(_e1420) & 2147483647u)) > ((0.0000038146973f * select(_e1504, _e1501, (_e1501 > _e1504))) * select(_e1518, _e1515, (_e1515 > _e1518))));
                                                                                if _e1522 {
                                                                                    phi_2125_ = (_e1415 / _e1420);
                                                                                } else {
                                                                                    phi_2125_ = f32();
                                                                                }
                                                                                let _e1525 = phi_2125_;
                                                                                phi_2127_ = _e1525;
                                                                                phi_2128_ = select(true, false, _e1522);
                                                                            } else {
                                                                                phi_2127_ = f32();
                                                                                phi_2128_ = true;
                                                                            }
                                                                            let _e1528 = phi_2127_;
                                                                            let _e1530 = phi_2128_;
                                                                            if _e1530 {
                                                                                let _e1538 = (((_e1386 * (_e1447 - (_e411 * _e1450))) + (_e1391 * (_e1448 - (_e447 * _e1450)))) / _e1420);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1538) & 2147483647u)) <= _e1352) {
                                                                                    phi_2148_ = (_e1450 + _e1538);
                                                                                } else {
                                                                                    phi_2148_ = _e1450;
                                                                                }
                                                                                let _e1545 = phi_2148_;
                                                                                phi_2149_ = _e1545;
                                                                            } else {
                                                                                phi_2149_ = _e1528;
                                                                            }
                                                                            let _e1547 = phi_2149_;
                                                                            let _e1549 = select(_e1285, _e1547, (_e1547 < _e1285));
                                                                            let _e1551 = select(_e1277, _e1549, (_e1549 > _e1277));
                                                                            if (_e1551 >= _e532) {
                                                                                let _e1553 = (_e1551 <= _e962.member);
                                                                                if _e1553 {
                                                                                    let _e1554 = (1f / _e1204);
                                                                                    phi_2172_ = type_22(_e1551, (_e1198 * _e1554), (_e1202 * _e1554), _e990);
                                                                                } else {
                                                                                    phi_2172_ = type_22();
                                                                                }
                                                                                let _e1559 = phi_2172_;
                                                                                phi_2174_ = _e1559;
                                                                                phi_2175_ = select(true, false, _e1553);
                                                                            } else {
                                                                                phi_2174_ = type_22();
                                                                                phi_2175_ = true;
                                                                            }
                                                                            let _e1562 = phi_2174_;
                                                                            let _e1564 = phi_2175_;
                                                                            if _e1564 {
                                                                                phi_2179_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2179_ = _e1562;
                                                                            }
                                                                            let _e1566 = phi_2179_;
                                                                            phi_2180_ = _e1566;
                                                                        }
                                                                        let _e1568 = phi_2180_;
                                                                        phi_2181_ = _e1568;
                                                                        phi_2182_ = _e1294;
                                                                    }
                                                                    let _e1570 = phi_2181_;
                                                                    let _e1572 = phi_2182_;
                                                                    phi_2186_ = _e1570;
                                                                    phi_2187_ = _e1572;
                                                                }
                                                                let _e1574 = phi_2186_;
                                                                let _e1576 = phi_2187_;
                                                                phi_2188_ = _e1574;
                                                                phi_2189_ = _e1229;
                                                                phi_2190_ = _e1576;
                                                            }
                                                            let _e1578 = phi_2188_;
                                                            let _e1580 = phi_2189_;
                                                            let _e1582 = phi_2190_;
                                                            phi_2191_ = _e1578;
                                                            phi_2192_ = _e1580;
                                                            phi_2193_ = _e1582;
                                                        }
                                                        let _e1584 = phi_2191_;
                                                        let _e1586 = phi_2192_;
                                                        let _e1588 = phi_2193_;
                                                        phi_2201_ = _e1584;
                                                        phi_2202_ = select(_e1588, true, _e1586);
                                                    } else {
                                                        phi_2201_ = type_22();
                                                        phi_2202_ = true;
                                                    }
                                                    let _e1591 = phi_2201_;
                                                    let _e1593 = phi_2202_;
                                                    if _e1593 {
                                                        phi_2206_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2206_ = _e1591;
                                                    }
                                                    let _e1595 = phi_2206_;
                                                    if (_e1595.member_3 != 4294967295u) {
                                                        if (_e990 == _e149) {
                                                            phi_2523_ = false;
                                                        } else {
                                                            let _e1599 = (_e990 < arrayLength((&global_5.member)));
                                                            if _e1599 {
                                                                if _e1599 {
                                                                } else {
                                                                    phi_3585_ = true;
                                                                    break;
                                                                }
                                                                let _e1601 = global_5.member[_e990];
                                                                phi_2229_ = _e1601;
                                                            } else {
                                                                phi_2229_ = 4294967295u;
                                                            }
                                                            let _e1603 = phi_2229_;
                                                            let _e1604 = (_e1603 < arrayLength((&global_6.member)));
                                                            if _e1604 {
                                                                if _e1604 {
                                                                } else {
                                                                    phi_3585_ = true;
                                                                    break;
                                                                }
                                                                let _e1606 = global_6.member[_e1603];
                                                                phi_2243_ = _e1606;
                                                            } else {
                                                                phi_2243_ = 0i;
                                                            }
                                                            let _e1608 = phi_2243_;
                                                            let _e1609 = (_e1608 == 0i);
                                                            if _e1609 {
                                                                phi_2522_ = true;
                                                            } else {
                                                                if _e378 {
                                                                    phi_2260_ = vec3<f32>(_e1024, _e1044, _e1064);
                                                                } else {
                                                                    if (_e354 == 1u) {
                                                                        phi_2259_ = vec3<f32>(_e1064, _e1024, _e1044);
                                                                    } else {
                                                                        phi_2259_ = vec3<f32>(_e1044, _e1064, _e1024);
                                                                    }
                                                                    let _e1614 = phi_2259_;
                                                                    phi_2260_ = _e1614;
                                                                }
                                                                let _e1617 = phi_2260_;
                                                                if _e378 {
                                                                    phi_2273_ = vec3<f32>(_e1078, _e1091, _e1104);
                                                                } else {
                                                                    if (_e354 == 1u) {
                                                                        phi_2272_ = vec3<f32>(_e1104, _e1078, _e1091);
                                                                    } else {
                                                                        phi_2272_ = vec3<f32>(_e1091, _e1104, _e1078);
                                                                    }
                                                                    let _e1622 = phi_2272_;
                                                                    phi_2273_ = _e1622;
                                                                }
                                                                let _e1625 = phi_2273_;
                                                                if _e378 {
                                                                    phi_2286_ = vec3<f32>(_e1118, _e1131, _e1144);
                                                                } else {
                                                                    if (_e354 == 1u) {
                                                                        phi_2285_ = vec3<f32>(_e1144, _e1118, _e1131);
                                                                    } else {
                                                                        phi_2285_ = vec3<f32>(_e1131, _e1144, _e1118);
                                                                    }
                                                                    let _e1630 = phi_2285_;
                                                                    phi_2286_ = _e1630;
                                                                }
                                                                let _e1633 = phi_2286_;
                                                                let _e1636 = (_e1625.x - _e1617.x);
                                                                let _e1639 = (_e1625.y - _e1617.y);
                                                                let _e1642 = (_e1625.z - _e1617.z);
                                                                let _e1644 = (_e1633.x - _e1617.x);
                                                                let _e1646 = (_e1633.y - _e1617.y);
                                                                let _e1648 = (_e1633.z - _e1617.z);
                                                                if (_e221.member_1 == 1u) {
                                                                    phi_2322_ = (vec3<f32>(_e221.member[0], _e221.member[1], _e221.member[2]) - _e1617);
                                                                } else {
                                                                    phi_2322_ = vec3<f32>(_e221.member[0], _e221.member[1], _e221.member[2]);
                                                                }
                                                                let _e1663 = phi_2322_;
                                                                let _e1669 = bitcast<f32>((bitcast<u32>((_e1636 * _e1646)) ^ _e221.member_3[0]));
                                                                let _e1673 = bitcast<f32>((bitcast<u32>((_e1639 * _e1644)) ^ _e221.member_3[0]));
                                                                let _e1677 = bitcast<f32>((bitcast<u32>((_e1639 * _e1648)) ^ _e221.member_3[0]));
                                                                let _e1681 = bitcast<f32>((bitcast<u32>((_e1642 * _e1646)) ^ _e221.member_3[0]));
                                                                let _e1685 = bitcast<f32>((bitcast<u32>((_e1642 * _e1644)) ^ _e221.member_3[0]));
                                                                let _e1689 = bitcast<f32>((bitcast<u32>((_e1636 * _e1648)) ^ _e221.member_3[0]));
                                                                let _e1690 = (_e1677 - _e1681);
                                                                let _e1691 = (_e1685 - _e1689);
                                                                let _e1692 = (_e1669 - _e1673);
                                                                let _e1716 = (bitcast<f32>((bitcast<u32>(_e1677) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1681) & 2147483647u)));
                                                                let _e1723 = (bitcast<f32>((bitcast<u32>(_e1685) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1689) & 2147483647u)));
                                                                let _e1730 = (bitcast<f32>((bitcast<u32>(_e1669) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1673) & 2147483647u)));
                                                                if (_e221.member_2 == 0f) {
                                                                    phi_2504_ = 0f;
                                                                } else {
                                                                    let _e1760 = bitcast<f32>((bitcast<u32>(_e1690) & 2147483647u));
                                                                    let _e1763 = bitcast<f32>((bitcast<u32>(_e1691) & 2147483647u));
                                                                    let _e1766 = bitcast<f32>((bitcast<u32>(_e1692) & 2147483647u));
                                                                    let _e1768 = select(_e1766, _e1763, (_e1763 > _e1766));
                                                                    let _e1772 = select(_e1766, _e1763, (_e1763 < _e1766));
                                                                    let _e1776 = select(_e1763, _e1760, (_e1760 < _e1763));
                                                                    let _e1778 = select(_e1763, _e1760, (_e1760 > _e1763));
                                                                    let _e1780 = select(_e1766, _e1778, (_e1778 < _e1766));
                                                                    phi_2504_ = bitcast<f32>((bitcast<u32>((_e221.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1768, _e1760, (_e1760 > _e1768)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1780, _e1776, (_e1776 > _e1780)))) ^ _e221.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1772, _e1760, (_e1760 < _e1772)))) ^ _e221.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1716 + _e1723) + _e1730))) ^ _e221.member_3[0]))) * 1.0000005f)) ^ _e221.member_3[0])))) ^ _e221.member_3[0]));
                                                                }
                                                                let _e1807 = phi_2504_;
                                                                phi_2522_ = (_e1609 || !(((((bitcast<f32>((bitcast<u32>((_e1663.x * _e1690)) ^ _e221.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1663.y * _e1691)) ^ _e221.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1663.z * _e1692)) ^ _e221.member_3[0]))) * f32(-(_e1608))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1663.x) & 2147483647u)) * _e1716)) ^ _e221.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1663.y) & 2147483647u)) * _e1723)) ^ _e221.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1663.z) & 2147483647u)) * _e1730)) ^ _e221.member_3[0]))))) ^ _e221.member_3[0])) + _e1807) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1821 = phi_2522_;
                                                            phi_2523_ = _e1821;
                                                        }
                                                        let _e1823 = phi_2523_;
                                                        if _e1823 {
                                                            phi_2528_ = type_40(_e962.member, true);
                                                        } else {
                                                            phi_2528_ = _e962;
                                                        }
                                                        let _e1828 = phi_2528_;
                                                        phi_2529_ = _e1828;
                                                    } else {
                                                        phi_2529_ = _e962;
                                                    }
                                                    let _e1830 = phi_2529_;
                                                    phi_1065_ = _e1830;
                                                } else {
                                                    phi_1065_ = type_40();
                                                }
                                                let _e1832 = phi_1065_;
                                                continue;
                                                continuing {
                                                    phi_1064_ = _e1832;
                                                    phi_1067_ = _e977;
                                                    phi_3585_ = _e564;
                                                    break if !(_e983);
                                                }
                                            }
                                            let _e1835 = phi_3585_;
                                            phi_3769_ = _e1835;
                                            if _e1835 {
                                                break;
                                            }
                                            let _e1837 = local_10;
                                            phi_3773_ = _e1835;
                                            let _e2036 = local_12;
                                            phi_3479_ = _e2036;
                                            phi_3480_ = _e605;
                                            phi_3481_ = false;
                                            phi_3482_ = select(_e609, 0u, _e1837.member_1);
                                        } else {
                                            let _e619 = (_e605.member_1 < _e89);
                                            if _e619 {
                                                if _e619 {
                                                } else {
                                                    phi_3769_ = true;
                                                    break;
                                                }
                                                let _e621 = global_9.member[_e605.member_1];
                                                phi_2549_ = _e621;
                                            } else {
                                                phi_2549_ = type_49(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e623 = phi_2549_;
                                            let _e638 = ((10u * _e354) & 31u);
                                            let _e641 = ((_e623.member[0] >> bitcast<u32>(_e638)) & 1023u);
                                            let _e646 = bitcast<f32>((bitcast<u32>(((_e605.member.member_1[0] - _e605.member.member[0]) * 0.0009775171f)) ^ _e132));
                                            let _e652 = (_e605.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e641) * _e646)) ^ _e132)));
                                            let _e656 = select(select(_e605.member.member_1[0], _e652, (_e652 < _e605.member.member_1[0])), _e605.member.member_1[0], (_e641 == 1023u));
                                            let _e658 = ((10u * _e353) & 31u);
                                            let _e661 = ((_e623.member[0] >> bitcast<u32>(_e658)) & 1023u);
                                            let _e666 = bitcast<f32>((bitcast<u32>(((_e605.member.member_1[1] - _e605.member.member[1]) * 0.0009775171f)) ^ _e132));
                                            let _e672 = (_e605.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e661) * _e666)) ^ _e132)));
                                            let _e676 = select(select(_e605.member.member_1[1], _e672, (_e672 < _e605.member.member_1[1])), _e605.member.member_1[1], (_e661 == 1023u));
                                            let _e678 = ((10u * _e355) & 31u);
                                            let _e681 = ((_e623.member[0] >> bitcast<u32>(_e678)) & 1023u);
                                            let _e686 = bitcast<f32>((bitcast<u32>(((_e605.member.member_1[2] - _e605.member.member[2]) * 0.0009775171f)) ^ _e132));
                                            let _e692 = (_e605.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e681) * _e686)) ^ _e132)));
                                            let _e696 = select(select(_e605.member.member_1[2], _e692, (_e692 < _e605.member.member_1[2])), _e605.member.member_1[2], (_e681 == 1023u));
                                            let _e699 = ((_e623.member[1] >> bitcast<u32>(_e638)) & 1023u);
                                            let _e705 = (_e605.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e699) * _e646)) ^ _e132)));
                                            let _e709 = select(select(_e605.member.member_1[0], _e705, (_e705 < _e605.member.member_1[0])), _e605.member.member_1[0], (_e699 == 1023u));
                                            let _e712 = ((_e623.member[1] >> bitcast<u32>(_e658)) & 1023u);
                                            let _e718 = (_e605.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e712) * _e666)) ^ _e132)));
                                            let _e722 = select(select(_e605.member.member_1[1], _e718, (_e718 < _e605.member.member_1[1])), _e605.member.member_1[1], (_e712 == 1023u));
                                            let _e725 = ((_e623.member[1] >> bitcast<u32>(_e678)) & 1023u);
                                            let _e731 = (_e605.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e725) * _e686)) ^ _e132)));
                                            let _e735 = select(select(_e605.member.member_1[2], _e731, (_e731 < _e605.member.member_1[2])), _e605.member.member_1[2], (_e725 == 1023u));
                                            let _e741 = ((_e623.member_1[0] >> bitcast<u32>(_e638)) & 1023u);
                                            let _e747 = (_e605.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e741) * _e646)) ^ _e132)));
                                            let _e751 = select(select(_e605.member.member_1[0], _e747, (_e747 < _e605.member.member_1[0])), _e605.member.member_1[0], (_e741 == 1023u));
                                            let _e754 = ((_e623.member_1[0] >> bitcast<u32>(_e658)) & 1023u);
                                            let _e760 = (_e605.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e754) * _e666)) ^ _e132)));
                                            let _e764 = select(select(_e605.member.member_1[1], _e760, (_e760 < _e605.member.member_1[1])), _e605.member.member_1[1], (_e754 == 1023u));
                                            let _e767 = ((_e623.member_1[0] >> bitcast<u32>(_e678)) & 1023u);
                                            let _e773 = (_e605.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e767) * _e686)) ^ _e132)));
                                            let _e777 = select(select(_e605.member.member_1[2], _e773, (_e773 < _e605.member.member_1[2])), _e605.member.member_1[2], (_e767 == 1023u));
                                            let _e780 = ((_e623.member_1[1] >> bitcast<u32>(_e638)) & 1023u);
                                            let _e786 = (_e605.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e780) * _e646)) ^ _e132)));
                                            let _e790 = select(select(_e605.member.member_1[0], _e786, (_e786 < _e605.member.member_1[0])), _e605.member.member_1[0], (_e780 == 1023u));
                                            let _e793 = ((_e623.member_1[1] >> bitcast<u32>(_e658)) & 1023u);
                                            let _e799 = (_e605.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e793) * _e666)) ^ _e132)));
                                            let _e803 = select(select(_e605.member.member_1[1], _e799, (_e799 < _e605.member.member_1[1])), _e605.member.member_1[1], (_e793 == 1023u));
                                            let _e806 = ((_e623.member_1[1] >> bitcast<u32>(_e678)) & 1023u);
                                            let _e812 = (_e605.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e806) * _e686)) ^ _e132)));
                                            let _e816 = select(select(_e605.member.member_1[2], _e812, (_e812 < _e605.member.member_1[2])), _e605.member.member_1[2], (_e806 == 1023u));
                                            let _e821 = type_62(type_54(array<f32, 3>(_e656, _e676, _e696), array<f32, 3>(_e709, _e722, _e735)), _e623.member_2);
                                            let _e826 = type_62(type_54(array<f32, 3>(_e751, _e764, _e777), array<f32, 3>(_e790, _e803, _e816)), _e623.member_3);
                                            let _e832 = ((_e656 - _e409) * _e414);
                                            let _e833 = ((_e751 - _e409) * _e414);
                                            let _e834 = ((_e709 - _e410) * _e414);
                                            let _e835 = ((_e790 - _e410) * _e414);
                                            let _e840 = ((_e676 - _e445) * _e450);
                                            let _e841 = ((_e764 - _e445) * _e450);
                                            let _e842 = ((_e722 - _e446) * _e450);
                                            let _e843 = ((_e803 - _e446) * _e450);
                                            let _e848 = ((_e696 - _e481) * _e486);
                                            let _e849 = ((_e777 - _e481) * _e486);
                                            let _e850 = ((_e735 - _e482) * _e486);
                                            let _e851 = ((_e816 - _e482) * _e486);
                                            let _e853 = select(_e850, _e848, (_e848 < _e850));
                                            let _e855 = select(_e851, _e849, (_e849 < _e851));
                                            let _e857 = select(_e850, _e848, (_e848 > _e850));
                                            let _e859 = select(_e851, _e849, (_e849 > _e851));
                                            let _e861 = select(_e834, _e832, (_e832 < _e834));
                                            let _e863 = select(_e835, _e833, (_e833 < _e835));
                                            let _e865 = select(_e842, _e840, (_e840 < _e842));
                                            let _e867 = select(_e843, _e841, (_e841 < _e843));
                                            let _e869 = select(_e865, _e861, (_e861 > _e865));
                                            let _e871 = select(_e867, _e863, (_e863 > _e867));
                                            let _e873 = select(_e853, _e869, (_e869 > _e853));
                                            let _e875 = select(_e855, _e871, (_e871 > _e855));
                                            let _e877 = select(_e834, _e832, (_e832 > _e834));
                                            let _e879 = select(_e835, _e833, (_e833 > _e835));
                                            let _e881 = select(_e842, _e840, (_e840 > _e842));
                                            let _e883 = select(_e843, _e841, (_e841 > _e843));
                                            let _e885 = select(_e881, _e877, (_e877 < _e881));
                                            let _e887 = select(_e883, _e879, (_e879 < _e883));
                                            let _e892 = -(_e853);
                                            let _e893 = -(_e855);
                                            let _e900 = (select(_e857, _e885, (_e885 < _e857)) + (select(_e892, _e857, (_e857 > _e892)) * 0.0000019073523f));
                                            let _e901 = (select(_e859, _e887, (_e887 < _e859)) + (select(_e893, _e859, (_e859 > _e893)) * 0.0000019073523f));
                                            let _e903 = select(_e532, _e873, (_e873 > _e532));
                                            let _e905 = select(_e532, _e875, (_e875 > _e532));
                                            let _e910 = (_e903 <= select(_e566.member, _e900, (_e900 < _e566.member)));
                                            let _e911 = (_e905 <= select(_e566.member, _e901, (_e901 < _e566.member)));
                                            let _e912 = (_e903 <= _e905);
                                            if _e910 {
                                                if _e911 {
                                                    if _e912 {
                                                        phi_3381_ = _e826;
                                                    } else {
                                                        phi_3381_ = _e821;
                                                    }
                                                    let _e914 = phi_3381_;
                                                    let _e922 = (_e609 % 128u);
                                                    let _e923 = (_e922 < 128u);
                                                    if _e923 {
                                                    } else {
                                                        phi_3769_ = true;
                                                        break;
                                                    }
                                                    local_6[_e922] = _e914.member_1;
                                                    if _e923 {
                                                    } else {
                                                        phi_3769_ = true;
                                                        break;
                                                    }
                                                    local_5[_e922] = _e914.member.member[0];
                                                    if _e923 {
                                                    } else {
                                                        phi_3769_ = true;
                                                        break;
                                                    }
                                                    local_4[_e922] = _e914.member.member[1];
                                                    if _e923 {
                                                    } else {
                                                        phi_3769_ = true;
                                                        break;
                                                    }
                                                    local_3[_e922] = _e914.member.member[2];
                                                    if _e923 {
                                                    } else {
                                                        phi_3769_ = true;
                                                        break;
                                                    }
                                                    local_2[_e922] = _e914.member.member_1[0];
                                                    if _e923 {
                                                    } else {
                                                        phi_3769_ = true;
                                                        break;
                                                    }
                                                    local_1[_e922] = _e914.member.member_1[1];
                                                    if _e923 {
                                                    } else {
                                                        phi_3769_ = true;
                                                        break;
                                                    }
                                                    local[_e922] = _e914.member.member_1[2];
                                                    if _e923 {
                                                    } else {
                                                        phi_3769_ = true;
                                                        break;
                                                    }
                                                    local_7[_e922] = select(_e905, _e903, (_e903 > _e905));
                                                    if _e912 {
                                                        phi_3458_ = _e821;
                                                    } else {
                                                        phi_3458_ = _e826;
                                                    }
                                                    let _e940 = phi_3458_;
                                                    phi_3459_ = _e940;
                                                    phi_3460_ = (_e609 + 1u);
                                                } else {
                                                    phi_3459_ = type_62();
                                                    phi_3460_ = u32();
                                                }
                                                let _e942 = phi_3459_;
                                                let _e944 = phi_3460_;
                                                phi_3462_ = _e942;
                                                phi_3463_ = _e944;
                                                phi_3464_ = select(true, false, _e911);
                                            } else {
                                                phi_3462_ = type_62();
                                                phi_3463_ = u32();
                                                phi_3464_ = true;
                                            }
                                            let _e947 = phi_3462_;
                                            let _e949 = phi_3463_;
                                            let _e951 = phi_3464_;
                                            if _e951 {
                                                if _e910 {
                                                    phi_3471_ = _e821;
                                                } else {
                                                    phi_3471_ = _e826;
                                                }
                                                let _e953 = phi_3471_;
                                                phi_3476_ = _e953;
                                                phi_3477_ = select(_e911, true, _e910);
                                            } else {
                                                phi_3476_ = _e947;
                                                phi_3477_ = _e607;
                                            }
                                            let _e956 = phi_3476_;
                                            let _e958 = phi_3477_;
                                            phi_3773_ = _e564;
                                            phi_3479_ = _e566;
                                            phi_3480_ = _e956;
                                            phi_3481_ = _e958;
                                            phi_3482_ = select(_e949, _e609, _e951);
                                        }
                                        let _e1841 = phi_3773_;
                                        let _e1843 = phi_3479_;
                                        let _e1845 = phi_3480_;
                                        let _e1847 = phi_3481_;
                                        let _e1849 = phi_3482_;
                                        phi_3772_ = _e1841;
                                        phi_3483_ = _e1843;
                                        phi_3484_ = _e1845;
                                        phi_3485_ = (_e570 - 1u);
                                        phi_3486_ = _e1847;
                                        phi_3487_ = _e1849;
                                    } else {
                                        phi_3772_ = _e564;
                                        phi_3483_ = _e566;
                                        phi_3484_ = _e605;
                                        phi_3485_ = _e570;
                                        phi_3486_ = _e607;
                                        phi_3487_ = _e609;
                                    }
                                    let _e1851 = phi_3772_;
                                    let _e1853 = phi_3483_;
                                    let _e1855 = phi_3484_;
                                    let _e1857 = phi_3485_;
                                    let _e1859 = phi_3486_;
                                    let _e1861 = phi_3487_;
                                    phi_3771_ = _e1851;
                                    phi_3488_ = _e1853;
                                    phi_3489_ = _e1855;
                                    phi_3490_ = _e1857;
                                    phi_3491_ = _e1859;
                                    phi_3492_ = _e1861;
                                } else {
                                    phi_3771_ = _e564;
                                    phi_3488_ = type_40();
                                    phi_3489_ = type_62();
                                    phi_3490_ = u32();
                                    phi_3491_ = bool();
                                    phi_3492_ = u32();
                                }
                                let _e1863 = phi_3771_;
                                let _e1865 = phi_3488_;
                                let _e1867 = phi_3489_;
                                let _e1869 = phi_3490_;
                                let _e1871 = phi_3491_;
                                let _e1873 = phi_3492_;
                                phi_3770_ = _e1863;
                                phi_938_ = _e1865;
                                phi_941_ = _e1867;
                                phi_943_ = _e1869;
                                phi_945_ = _e1871;
                                phi_947_ = _e1873;
                                phi_3493_ = _e578;
                            } else {
                                phi_3770_ = _e564;
                                phi_938_ = type_40();
                                phi_941_ = type_62();
                                phi_943_ = u32();
                                phi_945_ = bool();
                                phi_947_ = u32();
                                phi_3493_ = false;
                            }
                            let _e1875 = phi_3770_;
                            let _e1877 = phi_938_;
                            let _e1879 = phi_941_;
                            let _e1881 = phi_943_;
                            let _e1883 = phi_945_;
                            let _e1885 = phi_947_;
                            let _e1887 = phi_3493_;
                            continue;
                            continuing {
                                phi_3591_ = _e1875;
                                phi_937_ = _e1877;
                                phi_940_ = _e1879;
                                phi_942_ = _e1881;
                                phi_944_ = _e1883;
                                phi_946_ = _e1885;
                                phi_3769_ = _e1875;
                                break if !(_e1887);
                            }
                        }
                        let _e1890 = phi_3769_;
                        if _e1890 {
                            break;
                        }
                        let _e1892 = local_11;
                        if _e1892.member_1 {
                        } else {
                            if _e222 {
                            } else {
                                break;
                            }
                            let _e1896 = global_2.member[_e136];
                            if _e143 {
                            } else {
                                break;
                            }
                            let _e1900 = global_8.member[_e136].member_1;
                            if _e222 {
                            } else {
                                break;
                            }
                            global_2.member[_e136] = type_24(_e1896.member, _e1896.member_1, _e1896.member_2, array<f32, 3>((_e1896.member_3[0] + (_e1900[0] * _e1896.member_1[0])), (_e1896.member_3[1] + (_e1900[1] * _e1896.member_1[1])), (_e1896.member_3[2] + (_e1900[2] * _e1896.member_1[2]))), _e1896.member_4);
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
