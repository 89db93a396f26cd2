struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
}

struct type_16 {
    member: vec4<u32>,
}

struct type_22 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_29 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: type_30,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_38 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_39 {
    member: type_30,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_41 {
    member: array<type_39>,
}

struct type_44 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_49 {
    member: f32,
    member_1: bool,
}

struct type_51 {
    member: array<vec4<u32>, 2>,
}

struct type_54 {
    member: array<i32>,
}

struct type_61 {
    member: type_38,
    member_1: u32,
}

struct type_64 {
    member: array<vec4<f32>, 3>,
    member_1: type_61,
    member_2: type_61,
}

struct type_69 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_33;
@group(0) @binding(1) 
var<uniform> global_3: type_51;
@group(0) @binding(2) 
var<uniform> global_4: type_51;
@group(0) @binding(3) 
var<storage> global_5: type_13;
@group(0) @binding(4) 
var<storage> global_6: type_24;
@group(0) @binding(5) 
var<storage> global_7: type_4;
@group(0) @binding(6) 
var<storage> global_8: type_54;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_69;
@group(0) @binding(7) 
var<storage> global_10: type_41;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_61, 128>;
    var phi_324_: u32;
    var phi_389_: type_44;
    var phi_539_: i32;
    var phi_540_: i32;
    var phi_550_: bool;
    var phi_560_: u32;
    var phi_561_: u32;
    var phi_563_: bool;
    var phi_568_: u32;
    var phi_613_: f32;
    var phi_619_: f32;
    var phi_630_: f32;
    var phi_636_: f32;
    var phi_659_: f32;
    var phi_670_: f32;
    var phi_679_: f32;
    var phi_685_: f32;
    var phi_696_: f32;
    var phi_702_: f32;
    var phi_725_: f32;
    var phi_736_: f32;
    var phi_745_: f32;
    var phi_751_: f32;
    var phi_762_: f32;
    var phi_768_: f32;
    var phi_791_: f32;
    var phi_802_: f32;
    var phi_902_: f32;
    var phi_903_: f32;
    var phi_4701_: bool;
    var phi_2023_: type_49;
    var phi_2026_: type_61;
    var phi_2028_: u32;
    var phi_2030_: bool;
    var phi_2032_: u32;
    var phi_2043_: bool;
    var phi_2080_: type_61;
    var phi_2081_: bool;
    var phi_2082_: u32;
    var phi_4012_: u32;
    var phi_4013_: u32;
    var phi_4023_: u32;
    var phi_4025_: u32;
    var phi_4026_: bool;
    var phi_4046_: u32;
    var phi_4047_: u32;
    var phi_4051_: type_64;
    var phi_4395_: type_61;
    var phi_4428_: type_61;
    var phi_4429_: type_61;
    var phi_4430_: u32;
    var phi_4432_: type_61;
    var phi_4433_: u32;
    var phi_4434_: bool;
    var phi_4443_: type_61;
    var phi_4448_: type_61;
    var phi_4449_: bool;
    var phi_2100_: type_49;
    var phi_2103_: type_8;
    var phi_2104_: type_8;
    var phi_2126_: type_8;
    var phi_2147_: u32;
    var phi_2236_: array<array<f32, 3>, 3>;
    var phi_2707_: vec3<f32>;
    var phi_2708_: vec3<f32>;
    var phi_2739_: bool;
    var phi_2748_: vec3<f32>;
    var phi_2788_: type_29;
    var phi_2790_: type_29;
    var phi_2791_: bool;
    var phi_2795_: type_29;
    var phi_2796_: type_29;
    var phi_2797_: type_29;
    var phi_2798_: bool;
    var phi_2802_: type_29;
    var phi_2803_: bool;
    var phi_2807_: type_29;
    var phi_2808_: bool;
    var phi_2812_: type_29;
    var phi_2835_: u32;
    var phi_2849_: i32;
    var phi_2869_: vec3<f32>;
    var phi_2870_: vec3<f32>;
    var phi_2886_: vec3<f32>;
    var phi_2887_: vec3<f32>;
    var phi_2903_: vec3<f32>;
    var phi_2904_: vec3<f32>;
    var phi_2940_: vec3<f32>;
    var phi_3122_: f32;
    var phi_3140_: bool;
    var phi_3141_: bool;
    var phi_3146_: type_49;
    var phi_3147_: type_49;
    var phi_2101_: type_49;
    var phi_4695_: bool;
    var local_4: type_49;
    var phi_4831_: bool;
    var phi_4451_: type_49;
    var phi_4452_: type_61;
    var phi_4453_: bool;
    var phi_4454_: u32;
    var phi_4830_: bool;
    var phi_4455_: type_49;
    var phi_4456_: type_61;
    var phi_4457_: u32;
    var phi_4458_: bool;
    var phi_4459_: u32;
    var phi_4829_: bool;
    var phi_4460_: type_49;
    var phi_4461_: type_61;
    var phi_4462_: u32;
    var phi_4463_: bool;
    var phi_4464_: u32;
    var phi_4828_: bool;
    var phi_2024_: type_49;
    var phi_2027_: type_61;
    var phi_2029_: u32;
    var phi_2031_: bool;
    var phi_2033_: u32;
    var phi_4465_: bool;
    var phi_4827_: bool;
    var local_5: type_49;
    var local_6: type_49;

    switch bitcast<i32>(0u) {
        default: {
            let _e88 = global;
            let _e90 = arrayLength((&global_5.member));
            let _e92 = arrayLength((&global_6.member));
            let _e104 = arrayLength((&global_9.member));
            let _e108 = global_4.member[0u][0u];
            let _e112 = global_4.member[0u][1u];
            let _e116 = global_4.member[0u][2u];
            let _e120 = global_4.member[0u][3u];
            let _e124 = global_4.member[1u][0u];
            let _e128 = global_4.member[1u][1u];
            let _e132 = global_4.member[1u][2u];
            let _e136 = (_e88.x + (_e88.y * 2097152u));
            let _e148 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e120) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e108), bitcast<i32>(_e112), bitcast<i32>(_e116));
            local = array<i32, 3>(bitcast<i32>(_e124), bitcast<i32>(_e128), bitcast<i32>(_e132));
            let _e151 = (_e136 < arrayLength((&global_10.member)));
            if _e151 {
                if _e151 {
                } else {
                    break;
                }
                let _e155 = global_10.member[_e136].member_2;
                phi_324_ = _e155;
            } else {
                phi_324_ = 4294967295u;
            }
            let _e157 = phi_324_;
            let _e160 = global_1.member[0u];
            let _e164 = global_3.member[0u][0u];
            let _e168 = global_3.member[0u][1u];
            let _e172 = global_3.member[0u][2u];
            let _e176 = global_3.member[0u][3u];
            let _e180 = global_3.member[1u][0u];
            let _e184 = global_3.member[1u][1u];
            let _e188 = global_3.member[1u][2u];
            let _e192 = global_3.member[1u][3u];
            let _e193 = bitcast<f32>(_e164);
            let _e194 = bitcast<f32>(_e168);
            let _e195 = bitcast<f32>(_e172);
            let _e197 = bitcast<f32>(_e180);
            let _e198 = array<u32, 3>(_e184, _e188, _e192);
            let _e200 = bitcast<i32>(_e160);
            let _e201 = (_e200 / 2i);
            let _e206 = bitcast<f32>((bitcast<u32>((_e201 + 127i)) << bitcast<u32>(23i)));
            let _e212 = bitcast<f32>((bitcast<u32>(((_e200 - _e201) + 127i)) << bitcast<u32>(23i)));
            if (_e176 == 0u) {
                phi_389_ = type_44(array<f32, 3>(_e193, _e194, _e195), _e176, _e197, _e198);
            } else {
                phi_389_ = type_44(array<f32, 3>(((_e193 * _e206) * _e212), ((_e194 * _e206) * _e212), ((_e195 * _e206) * _e212)), _e176, ((_e197 * _e206) * _e212), _e198);
            }
            let _e225 = phi_389_;
            if _e151 {
                let _e226 = (_e136 < arrayLength((&global_2.member)));
                if _e226 {
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e231 = global_10.member[_e136].member.member_1;
                    let _e236 = global_10.member[_e136].member.member_3;
                    if (_e231 <= _e236) {
                        let _e238 = (1u < _e104);
                        if _e238 {
                            if (0u < _e104) {
                            } else {
                                break;
                            }
                            let _e242 = atomicAdd((&global_9.member[0u]), 1u);
                            if ((_e242 + 1u) < _e242) {
                                if _e238 {
                                } else {
                                    break;
                                }
                                let _e247 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e257 = global_10.member[_e136].member.member_2[0u];
                        let _e259 = (bitcast<u32>(_e257) & 2147483647u);
                        let _e265 = global_10.member[_e136].member.member_2[1u];
                        let _e267 = (bitcast<u32>(_e265) & 2147483647u);
                        let _e273 = global_10.member[_e136].member.member_2[2u];
                        let _e275 = (bitcast<u32>(_e273) & 2147483647u);
                        let _e281 = global_10.member[_e136].member.member[0u];
                        let _e283 = (bitcast<u32>(_e281) & 2147483647u);
                        let _e289 = global_10.member[_e136].member.member[1u];
                        let _e291 = (bitcast<u32>(_e289) & 2147483647u);
                        let _e297 = global_10.member[_e136].member.member[2u];
                        let _e299 = (bitcast<u32>(_e297) & 2147483647u);
                        let _e301 = select(_e267, _e259, (_e267 < _e259));
                        let _e303 = select(_e275, _e301, (_e275 < _e301));
                        let _e305 = select(_e283, _e303, (_e283 < _e303));
                        let _e307 = select(_e291, _e305, (_e291 < _e305));
                        let _e309 = select(_e299, _e307, (_e299 < _e307));
                        let _e311 = (bitcast<u32>(_e231) & 2147483647u);
                        let _e320 = (((select(_e311, _e309, (_e311 < _e309)) < 2139095040u) && ((bitcast<u32>(_e236) & 2147483647u) <= 2139095040u)) && (_e303 > 0u));
                        if _e320 {
                            let _e323 = (bitcast<u32>(bitcast<f32>(_e303)) & 2147483647u);
                            if (_e323 >= 8388608u) {
                                phi_539_ = (bitcast<i32>((_e323 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_539_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e323)), 32u, (_e323 == 0u))));
                            }
                            let _e337 = phi_539_;
                            phi_540_ = _e337;
                        } else {
                            phi_540_ = 0i;
                        }
                        let _e339 = phi_540_;
                        let _e340 = (_e259 == _e303);
                        if _e340 {
                            phi_550_ = true;
                        } else {
                            phi_550_ = (_e267 == _e303);
                        }
                        let _e343 = phi_550_;
                        let _e344 = select(1u, 0u, _e340);
                        if _e343 {
                            let _e345 = (_e344 + 1u);
                            phi_560_ = _e345;
                            phi_561_ = _e345;
                            phi_563_ = select(true, false, (_e345 == 2u));
                        } else {
                            phi_560_ = u32();
                            phi_561_ = 0u;
                            phi_563_ = true;
                        }
                        let _e349 = phi_560_;
                        let _e351 = phi_561_;
                        let _e353 = phi_563_;
                        if _e353 {
                            phi_568_ = (_e351 + 1u);
                        } else {
                            phi_568_ = 0u;
                        }
                        let _e357 = phi_568_;
                        let _e358 = select(_e349, _e351, _e353);
                        let _e359 = select(_e344, select(2u, _e344, _e343), _e353);
                        let _e360 = -(_e339);
                        let _e361 = (_e360 / 2i);
                        let _e366 = bitcast<f32>((bitcast<u32>((_e361 + 127i)) << bitcast<u32>(23i)));
                        let _e372 = bitcast<f32>((bitcast<u32>(((_e360 - _e361) + 127i)) << bitcast<u32>(23i)));
                        let _e377 = global_10.member[_e136].member.member;
                        let _e378 = (_e358 == 0u);
                        if _e378 {
                            phi_613_ = _e377[0];
                        } else {
                            phi_613_ = _e377[1];
                        }
                        let _e382 = phi_613_;
                        let _e383 = (_e358 == 2u);
                        if _e383 {
                            phi_619_ = _e377[2];
                        } else {
                            phi_619_ = _e382;
                        }
                        let _e386 = phi_619_;
                        let _e387 = global_10.member[_e136].member.member_2;
                        if _e378 {
                            phi_630_ = _e387[0];
                        } else {
                            phi_630_ = _e387[1];
                        }
                        let _e391 = phi_630_;
                        if _e383 {
                            phi_636_ = _e387[2];
                        } else {
                            phi_636_ = _e391;
                        }
                        let _e394 = phi_636_;
                        let _e396 = ((_e394 * _e366) * _e372);
                        let _e400 = (bitcast<f32>((bitcast<u32>(_e396) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e400 {
                            let _e404 = (bitcast<f32>((bitcast<u32>(_e386) & 2147483647u)) * 0.00000011920929f);
                            phi_659_ = select(0.00000000000011368684f, _e404, (_e404 > 0.00000000000011368684f));
                        } else {
                            phi_659_ = 0f;
                        }
                        let _e408 = phi_659_;
                        let _e409 = (_e386 + _e408);
                        let _e410 = (_e386 - _e408);
                        let _e411 = select(_e396, 0f, _e400);
                        if _e400 {
                            phi_670_ = 38685626000000000000000000f;
                        } else {
                            phi_670_ = (1f / _e396);
                        }
                        let _e414 = phi_670_;
                        let _e415 = (_e357 == 0u);
                        if _e415 {
                            phi_679_ = _e377[0];
                        } else {
                            phi_679_ = _e377[1];
                        }
                        let _e419 = phi_679_;
                        let _e420 = (_e357 == 2u);
                        if _e420 {
                            phi_685_ = _e377[2];
                        } else {
                            phi_685_ = _e419;
                        }
                        let _e423 = phi_685_;
                        if _e415 {
                            phi_696_ = _e387[0];
                        } else {
                            phi_696_ = _e387[1];
                        }
                        let _e427 = phi_696_;
                        if _e420 {
                            phi_702_ = _e387[2];
                        } else {
                            phi_702_ = _e427;
                        }
                        let _e430 = phi_702_;
                        let _e432 = ((_e430 * _e366) * _e372);
                        let _e436 = (bitcast<f32>((bitcast<u32>(_e432) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e436 {
                            let _e440 = (bitcast<f32>((bitcast<u32>(_e423) & 2147483647u)) * 0.00000011920929f);
                            phi_725_ = select(0.00000000000011368684f, _e440, (_e440 > 0.00000000000011368684f));
                        } else {
                            phi_725_ = 0f;
                        }
                        let _e444 = phi_725_;
                        let _e445 = (_e423 + _e444);
                        let _e446 = (_e423 - _e444);
                        let _e447 = select(_e432, 0f, _e436);
                        if _e436 {
                            phi_736_ = 38685626000000000000000000f;
                        } else {
                            phi_736_ = (1f / _e432);
                        }
                        let _e450 = phi_736_;
                        let _e451 = (_e359 == 0u);
                        if _e451 {
                            phi_745_ = _e377[0];
                        } else {
                            phi_745_ = _e377[1];
                        }
                        let _e455 = phi_745_;
                        let _e456 = (_e359 == 2u);
                        if _e456 {
                            phi_751_ = _e377[2];
                        } else {
                            phi_751_ = _e455;
                        }
                        let _e459 = phi_751_;
                        if _e451 {
                            phi_762_ = _e387[0];
                        } else {
                            phi_762_ = _e387[1];
                        }
                        let _e463 = phi_762_;
                        if _e456 {
                            phi_768_ = _e387[2];
                        } else {
                            phi_768_ = _e463;
                        }
                        let _e466 = phi_768_;
                        let _e468 = ((_e466 * _e366) * _e372);
                        let _e472 = (bitcast<f32>((bitcast<u32>(_e468) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e472 {
                            let _e476 = (bitcast<f32>((bitcast<u32>(_e459) & 2147483647u)) * 0.00000011920929f);
                            phi_791_ = select(0.00000000000011368684f, _e476, (_e476 > 0.00000000000011368684f));
                        } else {
                            phi_791_ = 0f;
                        }
                        let _e480 = phi_791_;
                        let _e481 = (_e459 + _e480);
                        let _e482 = (_e459 - _e480);
                        let _e483 = select(_e468, 0f, _e472);
                        if _e472 {
                            phi_802_ = 38685626000000000000000000f;
                        } else {
                            phi_802_ = (1f / _e468);
                        }
                        let _e486 = phi_802_;
                        let _e489 = bitcast<f32>((bitcast<u32>(_e386) & 2147483647u));
                        let _e492 = bitcast<f32>((bitcast<u32>(_e423) & 2147483647u));
                        let _e494 = select(_e492, _e489, (_e489 > _e492));
                        let _e497 = bitcast<f32>((bitcast<u32>(_e459) & 2147483647u));
                        if (_e320 && (select(_e497, _e494, (_e494 > _e497)) <= 1099511600000f)) {
                            let _e502 = (_e339 / 3i);
                            let _e509 = bitcast<f32>((bitcast<u32>((_e502 + 127i)) << bitcast<u32>(23i)));
                            let _e516 = bitcast<f32>((bitcast<u32>(((_e339 - (2i * _e502)) + 127i)) << bitcast<u32>(23i)));
                            let _e517 = (((_e231 * _e509) * _e509) * _e516);
                            let _e519 = select(340282350000000000000000000000000000000f, _e517, (_e517 < 340282350000000000000000000000000000000f));
                            let _e524 = (((_e236 * _e509) * _e509) * _e516);
                            let _e526 = select(340282350000000000000000000000000000000f, _e524, (_e524 < 340282350000000000000000000000000000000f));
                            phi_902_ = select(-340282350000000000000000000000000000000f, _e526, (_e526 > -340282350000000000000000000000000000000f));
                            phi_903_ = select(-340282350000000000000000000000000000000f, _e519, (_e519 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_902_ = 0f;
                            phi_903_ = 1f;
                        }
                        let _e530 = phi_902_;
                        let _e532 = phi_903_;
                        local_3 = array<type_61, 128>(type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e536 = (_e358 % 3u);
                        let _e537 = (_e536 < 3u);
                        if _e537 {
                        } else {
                            break;
                        }
                        let _e539 = local_1[_e536];
                        let _e542 = (_e357 % 3u);
                        let _e543 = (_e542 < 3u);
                        if _e543 {
                        } else {
                            break;
                        }
                        let _e545 = local_1[_e542];
                        let _e548 = (_e359 % 3u);
                        let _e549 = (_e548 < 3u);
                        if _e549 {
                        } else {
                            break;
                        }
                        let _e551 = local_1[_e548];
                        if _e537 {
                        } else {
                            break;
                        }
                        let _e556 = local[_e536];
                        if _e543 {
                        } else {
                            break;
                        }
                        let _e560 = local[_e542];
                        if _e549 {
                        } else {
                            break;
                        }
                        let _e564 = local[_e548];
                        phi_4701_ = false;
                        phi_2023_ = type_49(_e530, false);
                        phi_2026_ = type_61(type_38(vec4<f32>((f32(_e539) * _e148), (f32(_e545) * _e148), (f32(_e551) * _e148), 0f), vec4<f32>((f32(_e556) * _e148), (f32(_e560) * _e148), (f32(_e564) * _e148), 0f)), select(0u, 2147483648u, (_e90 == 0u)));
                        phi_2028_ = ((3u * _e90) + 1u);
                        phi_2030_ = (_e532 <= _e530);
                        phi_2032_ = 0u;
                        loop {
                            let _e574 = phi_4701_;
                            let _e576 = phi_2023_;
                            let _e578 = phi_2026_;
                            let _e580 = phi_2028_;
                            let _e582 = phi_2030_;
                            let _e584 = phi_2032_;
                            local_5 = _e576;
                            if _e582 {
                                phi_2043_ = true;
                            } else {
                                phi_2043_ = (_e584 > 0u);
                            }
                            let _e587 = phi_2043_;
                            if _e587 {
                                let _e588 = (_e580 > 0u);
                                if _e588 {
                                    if _e582 {
                                        phi_2080_ = _e578;
                                        phi_2081_ = _e582;
                                        phi_2082_ = _e584;
                                    } else {
                                        let _e589 = (_e584 - 1u);
                                        let _e590 = (_e589 % 128u);
                                        let _e591 = (_e590 < 128u);
                                        if _e591 {
                                        } else {
                                            phi_4827_ = true;
                                            break;
                                        }
                                        let _e593 = local_3[_e590];
                                        if _e591 {
                                        } else {
                                            phi_4827_ = true;
                                            break;
                                        }
                                        let _e601 = local_2[_e590];
                                        phi_2080_ = type_61(type_38(_e593.member.member, _e593.member.member_1), _e593.member_1);
                                        phi_2081_ = (_e601 <= _e576.member);
                                        phi_2082_ = _e589;
                                    }
                                    let _e605 = phi_2080_;
                                    let _e607 = phi_2081_;
                                    let _e609 = phi_2082_;
                                    if _e607 {
                                        if ((_e605.member_1 & 2147483648u) != 0u) {
                                            phi_2100_ = _e576;
                                            phi_2103_ = type_8(0u, ((_e605.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1055 = phi_2100_;
                                                let _e1057 = phi_2103_;
                                                local_4 = _e1055;
                                                local_6 = _e1055;
                                                if (_e1057.member < _e1057.member_1) {
                                                    phi_2104_ = type_8((_e1057.member + 1u), _e1057.member_1);
                                                    phi_2126_ = type_8(1u, _e1057.member);
                                                } else {
                                                    phi_2104_ = _e1057;
                                                    phi_2126_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1070 = phi_2104_;
                                                let _e1072 = phi_2126_;
                                                let _e1076 = (bitcast<i32>(_e1072.member) != 0i);
                                                if _e1076 {
                                                    let _e1077 = ((_e605.member_1 & 268435455u) + _e1072.member_1);
                                                    let _e1078 = (_e1077 < _e92);
                                                    if _e1078 {
                                                        if _e1078 {
                                                        } else {
                                                            phi_4695_ = true;
                                                            break;
                                                        }
                                                        let _e1082 = global_6.member[_e1077].member_1;
                                                        phi_2147_ = _e1082;
                                                    } else {
                                                        phi_2147_ = 4294967295u;
                                                    }
                                                    let _e1084 = phi_2147_;
                                                    if (_e1077 >= _e92) {
                                                        phi_2236_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1078 {
                                                        } else {
                                                            phi_4695_ = true;
                                                            break;
                                                        }
                                                        if (_e536 < 9u) {
                                                        } else {
                                                            phi_4695_ = true;
                                                            break;
                                                        }
                                                        let _e1091 = global_6.member[_e1077].member[_e536];
                                                        if (_e542 < 9u) {
                                                        } else {
                                                            phi_4695_ = true;
                                                            break;
                                                        }
                                                        let _e1097 = global_6.member[_e1077].member[_e542];
                                                        if (_e548 < 9u) {
                                                        } else {
                                                            phi_4695_ = true;
                                                            break;
                                                        }
                                                        let _e1103 = global_6.member[_e1077].member[_e548];
                                                        let _e1105 = (3u + _e536);
                                                        if (_e1105 < 9u) {
                                                        } else {
                                                            phi_4695_ = true;
                                                            break;
                                                        }
                                                        let _e1111 = global_6.member[_e1077].member[_e1105];
                                                        let _e1112 = (3u + _e542);
                                                        if (_e1112 < 9u) {
                                                        } else {
                                                            phi_4695_ = true;
                                                            break;
                                                        }
                                                        let _e1118 = global_6.member[_e1077].member[_e1112];
                                                        let _e1119 = (3u + _e548);
                                                        if (_e1119 < 9u) {
                                                        } else {
                                                            phi_4695_ = true;
                                                            break;
                                                        }
                                                        let _e1125 = global_6.member[_e1077].member[_e1119];
                                                        let _e1127 = (6u + _e536);
                                                        if (_e1127 < 9u) {
                                                        } else {
                                                            phi_4695_ = true;
                                                            break;
                                                        }
                                                        let _e1133 = global_6.member[_e1077].member[_e1127];
                                                        let _e1134 = (6u + _e542);
                                                        if (_e1134 < 9u) {
                                                        } else {
                                                            phi_4695_ = true;
                                                            break;
                                                        }
                                                        let _e1140 = global_6.member[_e1077].member[_e1134];
                                                        let _e1141 = (6u + _e548);
                                                        if (_e1141 < 9u) {
                                                        } else {
                                                            phi_4695_ = true;
                                                            break;
                                                        }
                                                        let _e1147 = global_6.member[_e1077].member[_e1141];
                                                        phi_2236_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1091, _e1097, _e1103), array<f32, 3>(_e1111, _e1118, _e1125), array<f32, 3>(_e1133, _e1140, _e1147));
                                                    }
                                                    let _e1151 = phi_2236_;
                                                    let _e1159 = (_e1151[0][2] - _e459);
                                                    let _e1162 = (((_e1151[0][0] - _e386) * _e483) - (_e1159 * _e411));
                                                    let _e1165 = (((_e1151[0][1] - _e423) * _e483) - (_e1159 * _e447));
                                                    let _e1172 = (_e1151[1][2] - _e459);
                                                    let _e1175 = (((_e1151[1][0] - _e386) * _e483) - (_e1172 * _e411));
                                                    let _e1178 = (((_e1151[1][1] - _e423) * _e483) - (_e1172 * _e447));
                                                    let _e1185 = (_e1151[2][2] - _e459);
                                                    let _e1188 = (((_e1151[2][0] - _e386) * _e483) - (_e1185 * _e411));
                                                    let _e1191 = (((_e1151[2][1] - _e423) * _e483) - (_e1185 * _e447));
                                                    let _e1192 = (_e1188 * _e1178);
                                                    let _e1193 = (_e1191 * _e1175);
                                                    let _e1194 = (_e1162 * _e1191);
                                                    let _e1195 = (_e1165 * _e1188);
                                                    let _e1196 = (_e1175 * _e1165);
                                                    let _e1197 = (_e1178 * _e1162);
                                                    let _e1202 = (((_e1192 >= _e1193) && (_e1194 >= _e1195)) && (_e1196 >= _e1197));
                                                    if (_e1202 || (((_e1192 <= _e1193) && (_e1194 <= _e1195)) && (_e1196 <= _e1197))) {
                                                        let _e1209 = select(-1f, 1f, _e1202);
                                                        let _e1211 = ((_e1192 - _e1193) * _e1209);
                                                        let _e1213 = select(0f, _e1211, (_e1211 > 0f));
                                                        let _e1215 = ((_e1194 - _e1195) * _e1209);
                                                        let _e1217 = select(0f, _e1215, (_e1215 > 0f));
                                                        let _e1219 = ((_e1196 - _e1197) * _e1209);
                                                        let _e1221 = select(0f, _e1219, (_e1219 > 0f));
                                                        let _e1223 = ((_e1213 + _e1217) + _e1221);
                                                        if (_e1223 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2802_ = type_29();
                                                            phi_2803_ = true;
                                                        } else {
                                                            let _e1226 = select(_e1151[1][0], _e1151[0][0], (_e1151[0][0] < _e1151[1][0]));
                                                            let _e1230 = select(_e1151[1][0], _e1151[0][0], (_e1151[0][0] > _e1151[1][0]));
                                                            let _e1234 = select(_e1151[1][1], _e1151[0][1], (_e1151[0][1] < _e1151[1][1]));
                                                            let _e1238 = select(_e1151[1][1], _e1151[0][1], (_e1151[0][1] > _e1151[1][1]));
                                                            let _e1242 = select(_e1151[1][2], _e1151[0][2], (_e1151[0][2] < _e1151[1][2]));
                                                            let _e1246 = select(_e1151[1][2], _e1151[0][2], (_e1151[0][2] > _e1151[1][2]));
                                                            let _e1251 = ((select(_e1151[2][0], _e1226, (_e1226 < _e1151[2][0])) - _e409) * _e414);
                                                            let _e1252 = ((select(_e1151[2][0], _e1230, (_e1230 > _e1151[2][0])) - _e410) * _e414);
                                                            let _e1255 = ((select(_e1151[2][1], _e1234, (_e1234 < _e1151[2][1])) - _e445) * _e450);
                                                            let _e1256 = ((select(_e1151[2][1], _e1238, (_e1238 > _e1151[2][1])) - _e446) * _e450);
                                                            let _e1259 = ((select(_e1151[2][2], _e1242, (_e1242 < _e1151[2][2])) - _e481) * _e486);
                                                            let _e1260 = ((select(_e1151[2][2], _e1246, (_e1246 > _e1151[2][2])) - _e482) * _e486);
                                                            let _e1262 = select(_e1260, _e1259, (_e1259 < _e1260));
                                                            let _e1264 = select(_e1260, _e1259, (_e1259 > _e1260));
                                                            let _e1266 = select(_e1252, _e1251, (_e1251 < _e1252));
                                                            let _e1268 = select(_e1256, _e1255, (_e1255 < _e1256));
                                                            let _e1270 = select(_e1268, _e1266, (_e1266 > _e1268));
                                                            let _e1272 = select(_e1262, _e1270, (_e1270 > _e1262));
                                                            let _e1274 = select(_e1252, _e1251, (_e1251 > _e1252));
                                                            let _e1276 = select(_e1256, _e1255, (_e1255 > _e1256));
                                                            let _e1278 = select(_e1276, _e1274, (_e1274 < _e1276));
                                                            let _e1280 = select(_e1264, _e1278, (_e1278 < _e1264));
                                                            let _e1281 = -(_e1262);
                                                            let _e1287 = select(_e532, _e1272, (_e1272 > _e532));
                                                            if (_e1287 > (_e1280 + (select(_e1281, _e1264, (_e1264 > _e1281)) * 0.0000019073523f))) {
                                                                phi_2797_ = type_29();
                                                                phi_2798_ = true;
                                                            } else {
                                                                let _e1289 = (_e1287 > _e1055.member);
                                                                if _e1289 {
                                                                    phi_2796_ = type_29();
                                                                } else {
                                                                    let _e1293 = (_e1151[1][0] - _e1151[0][0]);
                                                                    let _e1294 = (_e1151[1][1] - _e1151[0][1]);
                                                                    let _e1295 = (_e1151[1][2] - _e1151[0][2]);
                                                                    let _e1296 = vec3<f32>(_e1293, _e1294, _e1295);
                                                                    let _e1297 = (_e1151[2][0] - _e1151[1][0]);
                                                                    let _e1298 = (_e1151[2][1] - _e1151[1][1]);
                                                                    let _e1299 = (_e1151[2][2] - _e1151[1][2]);
                                                                    let _e1300 = vec3<f32>(_e1297, _e1298, _e1299);
                                                                    let _e1301 = (_e1151[0][0] - _e1151[2][0]);
                                                                    let _e1302 = (_e1151[0][1] - _e1151[2][1]);
                                                                    let _e1303 = (_e1151[0][2] - _e1151[2][2]);
                                                                    let _e1304 = vec3<f32>(_e1301, _e1302, _e1303);
                                                                    let _e1307 = bitcast<f32>((bitcast<u32>(_e1293) & 2147483647u));
                                                                    let _e1310 = bitcast<f32>((bitcast<u32>(_e1294) & 2147483647u));
                                                                    let _e1312 = select(_e1310, _e1307, (_e1307 > _e1310));
                                                                    let _e1315 = bitcast<f32>((bitcast<u32>(_e1295) & 2147483647u));
                                                                    let _e1317 = select(_e1315, _e1312, (_e1312 > _e1315));
                                                                    let _e1320 = bitcast<f32>((bitcast<u32>(_e1297) & 2147483647u));
                                                                    let _e1323 = bitcast<f32>((bitcast<u32>(_e1298) & 2147483647u));
                                                                    let _e1325 = select(_e1323, _e1320, (_e1320 > _e1323));
                                                                    let _e1328 = bitcast<f32>((bitcast<u32>(_e1299) & 2147483647u));
                                                                    let _e1330 = select(_e1328, _e1325, (_e1325 > _e1328));
                                                                    let _e1333 = bitcast<f32>((bitcast<u32>(_e1301) & 2147483647u));
                                                                    let _e1336 = bitcast<f32>((bitcast<u32>(_e1302) & 2147483647u));
                                                                    let _e1338 = select(_e1336, _e1333, (_e1333 > _e1336));
                                                                    let _e1341 = bitcast<f32>((bitcast<u32>(_e1303) & 2147483647u));
                                                                    let _e1343 = select(_e1341, _e1338, (_e1338 > _e1341));
                                                                    let _e1345 = select(_e1330, _e1317, (_e1317 > _e1330));
                                                                    let _e1347 = select(_e1343, _e1345, (_e1345 > _e1343));
                                                                    if (_e1317 == _e1347) {
                                                                        phi_2707_ = _e1300;
                                                                        phi_2708_ = _e1304;
                                                                    } else {
                                                                        let _e1350 = vec3((_e1330 == _e1347));
                                                                        phi_2707_ = select(_e1296, _e1304, _e1350);
                                                                        phi_2708_ = select(_e1300, _e1296, _e1350);
                                                                    }
                                                                    let _e1354 = phi_2707_;
                                                                    let _e1356 = phi_2708_;
                                                                    let _e1363 = ((_e1354.y * _e1356.z) - (_e1356.y * _e1354.z));
                                                                    let _e1368 = ((_e1354.z * _e1356.x) - (_e1356.z * _e1354.x));
                                                                    let _e1371 = ((_e1354.x * _e1356.y) - (_e1356.x * _e1354.y));
                                                                    if (_e1213 >= _e1217) {
                                                                        phi_2739_ = select(true, false, (_e1213 >= _e1221));
                                                                    } else {
                                                                        phi_2739_ = true;
                                                                    }
                                                                    let _e1376 = phi_2739_;
                                                                    if _e1376 {
                                                                        phi_2748_ = select(vec3<f32>(_e1151[2][0], _e1151[2][1], _e1151[2][2]), vec3<f32>(_e1151[1][0], _e1151[1][1], _e1151[1][2]), vec3((_e1217 >= _e1221)));
                                                                    } else {
                                                                        phi_2748_ = vec3<f32>(_e1151[0][0], _e1151[0][1], _e1151[0][2]);
                                                                    }
                                                                    let _e1381 = phi_2748_;
                                                                    let _e1398 = ((((_e1363 * (_e1381.x - _e386)) + (_e1368 * (_e1381.y - _e423))) + (_e1371 * (_e1381.z - _e459))) / (((_e1363 * _e411) + (_e1368 * _e447)) + (_e1371 * _e483)));
                                                                    let _e1400 = select(_e1280, _e1398, (_e1398 < _e1280));
                                                                    let _e1402 = select(_e1272, _e1400, (_e1400 > _e1272));
                                                                    if (_e1402 >= _e532) {
                                                                        let _e1404 = (_e1402 <= _e1055.member);
                                                                        if _e1404 {
                                                                            let _e1405 = (1f / _e1223);
                                                                            phi_2788_ = type_29(_e1402, (_e1217 * _e1405), (_e1221 * _e1405), _e1084);
                                                                        } else {
                                                                            phi_2788_ = type_29();
                                                                        }
                                                                        let _e1410 = phi_2788_;
                                                                        phi_2790_ = _e1410;
                                                                        phi_2791_ = select(true, false, _e1404);
                                                                    } else {
                                                                        phi_2790_ = type_29();
                                                                        phi_2791_ = true;
                                                                    }
                                                                    let _e1413 = phi_2790_;
                                                                    let _e1415 = phi_2791_;
                                                                    if _e1415 {
                                                                        phi_2795_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2795_ = _e1413;
                                                                    }
                                                                    let _e1417 = phi_2795_;
                                                                    phi_2796_ = _e1417;
                                                                }
                                                                let _e1419 = phi_2796_;
                                                                phi_2797_ = _e1419;
                                                                phi_2798_ = _e1289;
                                                            }
                                                            let _e1421 = phi_2797_;
                                                            let _e1423 = phi_2798_;
                                                            phi_2802_ = _e1421;
                                                            phi_2803_ = _e1423;
                                                        }
                                                        let _e1425 = phi_2802_;
                                                        let _e1427 = phi_2803_;
                                                        phi_2807_ = _e1425;
                                                        phi_2808_ = _e1427;
                                                    } else {
                                                        phi_2807_ = type_29();
                                                        phi_2808_ = true;
                                                    }
                                                    let _e1429 = phi_2807_;
                                                    let _e1431 = phi_2808_;
                                                    if _e1431 {
                                                        phi_2812_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2812_ = _e1429;
                                                    }
                                                    let _e1433 = phi_2812_;
                                                    if (_e1433.member_3 != 4294967295u) {
                                                        if (_e1084 == _e157) {
                                                            phi_3141_ = false;
                                                        } else {
                                                            let _e1437 = (_e1084 < arrayLength((&global_7.member)));
                                                            if _e1437 {
                                                                if _e1437 {
                                                                } else {
                                                                    phi_4695_ = true;
                                                                    break;
                                                                }
                                                                let _e1439 = global_7.member[_e1084];
                                                                phi_2835_ = _e1439;
                                                            } else {
                                                                phi_2835_ = 4294967295u;
                                                            }
                                                            let _e1441 = phi_2835_;
                                                            let _e1442 = (_e1441 < arrayLength((&global_8.member)));
                                                            if _e1442 {
                                                                if _e1442 {
                                                                } else {
                                                                    phi_4695_ = true;
                                                                    break;
                                                                }
                                                                let _e1444 = global_8.member[_e1441];
                                                                phi_2849_ = _e1444;
                                                            } else {
                                                                phi_2849_ = 0i;
                                                            }
                                                            let _e1446 = phi_2849_;
                                                            let _e1447 = (_e1446 == 0i);
                                                            if _e1447 {
                                                                phi_3140_ = true;
                                                            } else {
                                                                if _e378 {
                                                                    phi_2870_ = vec3<f32>(_e1151[0][0], _e1151[0][1], _e1151[0][2]);
                                                                } else {
                                                                    if (_e358 == 1u) {
                                                                        phi_2869_ = vec3<f32>(_e1151[0][2], _e1151[0][0], _e1151[0][1]);
                                                                    } else {
                                                                        phi_2869_ = vec3<f32>(_e1151[0][1], _e1151[0][2], _e1151[0][0]);
                                                                    }
                                                                    let _e1452 = phi_2869_;
                                                                    phi_2870_ = _e1452;
                                                                }
                                                                let _e1455 = phi_2870_;
                                                                if _e378 {
                                                                    phi_2887_ = vec3<f32>(_e1151[1][0], _e1151[1][1], _e1151[1][2]);
                                                                } else {
                                                                    if (_e358 == 1u) {
                                                                        phi_2886_ = vec3<f32>(_e1151[1][2], _e1151[1][0], _e1151[1][1]);
                                                                    } else {
                                                                        phi_2886_ = vec3<f32>(_e1151[1][1], _e1151[1][2], _e1151[1][0]);
                                                                    }
                                                                    let _e1460 = phi_2886_;
                                                                    phi_2887_ = _e1460;
                                                                }
                                                                let _e1463 = phi_2887_;
                                                                if _e378 {
                                                                    phi_2904_ = vec3<f32>(_e1151[2][0], _e1151[2][1], _e1151[2][2]);
                                                                } else {
                                                                    if (_e358 == 1u) {
                                                                        phi_2903_ = vec3<f32>(_e1151[2][2], _e1151[2][0], _e1151[2][1]);
                                                                    } else {
                                                                        phi_2903_ = vec3<f32>(_e1151[2][1], _e1151[2][2], _e1151[2][0]);
                                                                    }
                                                                    let _e1468 = phi_2903_;
                                                                    phi_2904_ = _e1468;
                                                                }
                                                                let _e1471 = phi_2904_;
                                                                let _e1474 = (_e1463.x - _e1455.x);
                                                                let _e1477 = (_e1463.y - _e1455.y);
                                                                let _e1480 = (_e1463.z - _e1455.z);
                                                                let _e1482 = (_e1471.x - _e1455.x);
                                                                let _e1484 = (_e1471.y - _e1455.y);
                                                                let _e1486 = (_e1471.z - _e1455.z);
                                                                if (_e225.member_1 == 1u) {
                                                                    phi_2940_ = (vec3<f32>(_e225.member[0], _e225.member[1], _e225.member[2]) - _e1455);
                                                                } else {
                                                                    phi_2940_ = vec3<f32>(_e225.member[0], _e225.member[1], _e225.member[2]);
                                                                }
                                                                let _e1501 = phi_2940_;
                                                                let _e1507 = bitcast<f32>((bitcast<u32>((_e1474 * _e1484)) ^ _e225.member_3[0]));
                                                                let _e1511 = bitcast<f32>((bitcast<u32>((_e1477 * _e1482)) ^ _e225.member_3[0]));
                                                                let _e1515 = bitcast<f32>((bitcast<u32>((_e1477 * _e1486)) ^ _e225.member_3[0]));
                                                                let _e1519 = bitcast<f32>((bitcast<u32>((_e1480 * _e1484)) ^ _e225.member_3[0]));
                                                                let _e1523 = bitcast<f32>((bitcast<u32>((_e1480 * _e1482)) ^ _e225.member_3[0]));
                                                                let _e1527 = bitcast<f32>((bitcast<u32>((_e1474 * _e1486)) ^ _e225.member_3[0]));
                                                                let _e1528 = (_e1515 - _e1519);
                                                                let _e1529 = (_e1523 - _e1527);
                                                                let _e1530 = (_e1507 - _e1511);
                                                                let _e1554 = (bitcast<f32>((bitcast<u32>(_e1515) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1519) & 2147483647u)));
                                                                let _e1561 = (bitcast<f32>((bitcast<u32>(_e1523) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1527) & 2147483647u)));
                                                                let _e1568 = (bitcast<f32>((bitcast<u32>(_e1507) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1511) & 2147483647u)));
                                                                if (_e225.member_2 == 0f) {
                                                                    phi_3122_ = 0f;
                                                                } else {
                                                                    let _e1598 = bitcast<f32>((bitcast<u32>(_e1528) & 2147483647u));
                                                                    let _e1601 = bitcast<f32>((bitcast<u32>(_e1529) & 2147483647u));
                                                                    let _e1604 = bitcast<f32>((bitcast<u32>(_e1530) & 2147483647u));
                                                                    let _e1606 = select(_e1604, _e1601, (_e1601 > _e1604));
                                                                    let _e1610 = select(_e1604, _e1601, (_e1601 < _e1604));
                                                                    let _e1614 = select(_e1601, _e1598, (_e1598 < _e1601));
                                                                    let _e1616 = select(_e1601, _e1598, (_e1598 > _e1601));
                                                                    let _e1618 = select(_e1604, _e1616, (_e1616 < _e1604));
                                                                    phi_3122_ = bitcast<f32>((bitcast<u32>((_e225.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1606, _e1598, (_e1598 > _e1606)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1618, _e1614, (_e1614 > _e1618)))) ^ _e225.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1610, _e1598, (_e1598 < _e1610)))) ^ _e225.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1554 + _e1561) + _e1568))) ^ _e225.member_3[0]))) * 1.0000005f)) ^ _e225.member_3[0])))) ^ _e225.member_3[0]));
                                                                }
                                                                let _e1645 = phi_3122_;
                                                                phi_3140_ = (_e1447 || !(((((bitcast<f32>((bitcast<u32>((_e1501.x * _e1528)) ^ _e225.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1501.y * _e1529)) ^ _e225.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1501.z * _e1530)) ^ _e225.member_3[0]))) * f32(-(_e1446))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1501.x) & 2147483647u)) * _e1554)) ^ _e225.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1501.y) & 2147483647u)) * _e1561)) ^ _e225.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1501.z) & 2147483647u)) * _e1568)) ^ _e225.member_3[0]))))) ^ _e225.member_3[0])) + _e1645) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1659 = phi_3140_;
                                                            phi_3141_ = _e1659;
                                                        }
                                                        let _e1661 = phi_3141_;
                                                        if _e1661 {
                                                            phi_3146_ = type_49(_e1055.member, true);
                                                        } else {
                                                            phi_3146_ = _e1055;
                                                        }
                                                        let _e1666 = phi_3146_;
                                                        phi_3147_ = _e1666;
                                                    } else {
                                                        phi_3147_ = _e1055;
                                                    }
                                                    let _e1668 = phi_3147_;
                                                    phi_2101_ = _e1668;
                                                } else {
                                                    phi_2101_ = type_49();
                                                }
                                                let _e1670 = phi_2101_;
                                                continue;
                                                continuing {
                                                    phi_2100_ = _e1670;
                                                    phi_2103_ = _e1070;
                                                    phi_4695_ = _e574;
                                                    break if !(_e1076);
                                                }
                                            }
                                            let _e1673 = phi_4695_;
                                            phi_4827_ = _e1673;
                                            if _e1673 {
                                                break;
                                            }
                                            let _e1675 = local_4;
                                            phi_4831_ = _e1673;
                                            let _e1860 = local_6;
                                            phi_4451_ = _e1860;
                                            phi_4452_ = _e605;
                                            phi_4453_ = false;
                                            phi_4454_ = select(_e609, 0u, _e1675.member_1);
                                        } else {
                                            if (_e605.member_1 >= _e90) {
                                                phi_4051_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_61(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e605.member_1 < _e90) {
                                                } else {
                                                    phi_4827_ = true;
                                                    break;
                                                }
                                                let _e621 = ((1u + _e358) % 4u);
                                                if (_e621 < 4u) {
                                                } else {
                                                    phi_4827_ = true;
                                                    break;
                                                }
                                                let _e626 = global_5.member[_e605.member_1][_e621];
                                                let _e628 = ((1u + _e357) % 4u);
                                                if (_e628 < 4u) {
                                                } else {
                                                    phi_4827_ = true;
                                                    break;
                                                }
                                                let _e633 = global_5.member[_e605.member_1][_e628];
                                                let _e635 = ((1u + _e359) % 4u);
                                                if (_e635 < 4u) {
                                                } else {
                                                    phi_4827_ = true;
                                                    break;
                                                }
                                                let _e640 = global_5.member[_e605.member_1][_e635];
                                                let _e642 = ((_e358 + 1u) % 4u);
                                                if (_e642 < 4u) {
                                                } else {
                                                    phi_4827_ = true;
                                                    break;
                                                }
                                                let _e647 = global_5.member[_e605.member_1][_e642];
                                                let _e649 = (_e647 >> bitcast<u32>(11u));
                                                let _e651 = ((_e357 + 1u) % 4u);
                                                if (_e651 < 4u) {
                                                } else {
                                                    phi_4827_ = true;
                                                    break;
                                                }
                                                let _e656 = global_5.member[_e605.member_1][_e651];
                                                let _e658 = (_e656 >> bitcast<u32>(11u));
                                                let _e660 = ((_e359 + 1u) % 4u);
                                                if (_e660 < 4u) {
                                                } else {
                                                    phi_4827_ = true;
                                                    break;
                                                }
                                                let _e665 = global_5.member[_e605.member_1][_e660];
                                                let _e667 = (_e665 >> bitcast<u32>(11u));
                                                let _e690 = (bitcast<f32>((bitcast<u32>((_e605.member.member_1.x - _e605.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e691 = (bitcast<f32>((bitcast<u32>((_e605.member.member_1.y - _e605.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e692 = (bitcast<f32>((bitcast<u32>((_e605.member.member_1.z - _e605.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e694 = select(_e148, _e690, (_e690 > _e148));
                                                let _e696 = select(_e148, _e691, (_e691 > _e148));
                                                let _e698 = select(_e148, _e692, (_e692 > _e148));
                                                let _e723 = bitcast<u32>((f32(bitcast<i32>((_e626 & 1023u))) * _e694));
                                                let _e728 = (bitcast<i32>((_e626 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e731 = bitcast<f32>((_e723 & bitcast<u32>(_e728)));
                                                let _e732 = bitcast<u32>((f32(bitcast<i32>((_e633 & 1023u))) * _e696));
                                                let _e737 = (bitcast<i32>((_e633 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e740 = bitcast<f32>((_e732 & bitcast<u32>(_e737)));
                                                let _e741 = bitcast<u32>((f32(bitcast<i32>((_e640 & 1023u))) * _e698));
                                                let _e746 = (bitcast<i32>((_e640 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e749 = bitcast<f32>((_e741 & bitcast<u32>(_e746)));
                                                let _e753 = bitcast<f32>((_e723 & bitcast<u32>(~(_e728))));
                                                let _e757 = bitcast<f32>((_e732 & bitcast<u32>(~(_e737))));
                                                let _e761 = bitcast<f32>((_e741 & bitcast<u32>(~(_e746))));
                                                let _e762 = bitcast<u32>((f32(bitcast<i32>((_e649 & 1023u))) * _e694));
                                                let _e767 = (bitcast<i32>((_e649 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e770 = bitcast<f32>((_e762 & bitcast<u32>(_e767)));
                                                let _e771 = bitcast<u32>((f32(bitcast<i32>((_e658 & 1023u))) * _e696));
                                                let _e776 = (bitcast<i32>((_e658 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e779 = bitcast<f32>((_e771 & bitcast<u32>(_e776)));
                                                let _e780 = bitcast<u32>((f32(bitcast<i32>((_e667 & 1023u))) * _e698));
                                                let _e785 = (bitcast<i32>((_e667 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e788 = bitcast<f32>((_e780 & bitcast<u32>(_e785)));
                                                let _e792 = bitcast<f32>((_e762 & bitcast<u32>(~(_e767))));
                                                let _e796 = bitcast<f32>((_e771 & bitcast<u32>(~(_e776))));
                                                let _e800 = bitcast<f32>((_e780 & bitcast<u32>(~(_e785))));
                                                let _e830 = global_5.member[_e605.member_1][0u];
                                                let _e834 = global_5.member[_e605.member_1][1u];
                                                let _e838 = global_5.member[_e605.member_1][2u];
                                                let _e842 = global_5.member[_e605.member_1][3u];
                                                let _e854 = (((_e834 >> bitcast<u32>(22i)) | ((_e838 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e842 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e855 = (_e830 & 268435455u);
                                                let _e856 = (_e854 & 268435455u);
                                                let _e859 = ((_e830 >> bitcast<u32>(28u)) & 7u);
                                                let _e867 = ((_e830 >> bitcast<u32>(31i)) | (((_e854 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e868 = (_e859 != 0u);
                                                if (_e859 == 0u) {
                                                    phi_4013_ = _e855;
                                                } else {
                                                    if (_e859 == 7u) {
                                                        phi_4012_ = 2147483648u;
                                                    } else {
                                                        phi_4012_ = ((2147483648u | (_e859 << bitcast<u32>(28u))) | (_e856 & 268435455u));
                                                    }
                                                    let _e877 = phi_4012_;
                                                    phi_4013_ = _e877;
                                                }
                                                let _e879 = phi_4013_;
                                                if _e868 {
                                                    let _e880 = (_e859 != 7u);
                                                    if _e880 {
                                                        phi_4023_ = (_e856 + _e859);
                                                    } else {
                                                        phi_4023_ = u32();
                                                    }
                                                    let _e883 = phi_4023_;
                                                    phi_4025_ = _e883;
                                                    phi_4026_ = select(true, false, _e880);
                                                } else {
                                                    phi_4025_ = u32();
                                                    phi_4026_ = true;
                                                }
                                                let _e886 = phi_4025_;
                                                let _e888 = phi_4026_;
                                                if (_e867 == 0u) {
                                                    phi_4047_ = (_e855 + select(0u, 1u, !(_e868)));
                                                } else {
                                                    if (_e867 == 7u) {
                                                        phi_4046_ = 2147483648u;
                                                    } else {
                                                        phi_4046_ = ((2147483648u | (_e867 << bitcast<u32>(28u))) | (select(_e886, _e856, _e888) & 268435455u));
                                                    }
                                                    let _e901 = phi_4046_;
                                                    phi_4047_ = _e901;
                                                }
                                                let _e903 = phi_4047_;
                                                phi_4051_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e605.member.member.x + _e731), (_e605.member.member.x + _e753), (_e605.member.member_1.x - _e770), (_e605.member.member_1.x - _e792)), vec4<f32>((_e605.member.member.y + _e740), (_e605.member.member.y + _e757), (_e605.member.member_1.y - _e779), (_e605.member.member_1.y - _e796)), vec4<f32>((_e605.member.member.z + _e749), (_e605.member.member.z + _e761), (_e605.member.member_1.z - _e788), (_e605.member.member_1.z - _e800))), type_61(type_38((_e605.member.member + vec4<f32>(_e731, _e740, _e749, 0f)), (_e605.member.member_1 - vec4<f32>(_e770, _e779, _e788, 0f))), _e879), type_61(type_38((_e605.member.member + vec4<f32>(_e753, _e757, _e761, 0f)), (_e605.member.member_1 - vec4<f32>(_e792, _e796, _e800, 0f))), _e903));
                                            }
                                            let _e908 = phi_4051_;
                                            let _e920 = ((_e908.member[0].x - _e409) * _e414);
                                            let _e921 = ((_e908.member[0].y - _e409) * _e414);
                                            let _e922 = ((_e908.member[0].z - _e410) * _e414);
                                            let _e923 = ((_e908.member[0].w - _e410) * _e414);
                                            let _e933 = ((_e908.member[1].x - _e445) * _e450);
                                            let _e934 = ((_e908.member[1].y - _e445) * _e450);
                                            let _e935 = ((_e908.member[1].z - _e446) * _e450);
                                            let _e936 = ((_e908.member[1].w - _e446) * _e450);
                                            let _e946 = ((_e908.member[2].x - _e481) * _e486);
                                            let _e947 = ((_e908.member[2].y - _e481) * _e486);
                                            let _e948 = ((_e908.member[2].z - _e482) * _e486);
                                            let _e949 = ((_e908.member[2].w - _e482) * _e486);
                                            let _e951 = select(_e948, _e946, (_e946 < _e948));
                                            let _e953 = select(_e949, _e947, (_e947 < _e949));
                                            let _e955 = select(_e948, _e946, (_e946 > _e948));
                                            let _e957 = select(_e949, _e947, (_e947 > _e949));
                                            let _e959 = select(_e922, _e920, (_e920 < _e922));
                                            let _e961 = select(_e923, _e921, (_e921 < _e923));
                                            let _e963 = select(_e935, _e933, (_e933 < _e935));
                                            let _e965 = select(_e936, _e934, (_e934 < _e936));
                                            let _e967 = select(_e963, _e959, (_e959 > _e963));
                                            let _e969 = select(_e965, _e961, (_e961 > _e965));
                                            let _e971 = select(_e951, _e967, (_e967 > _e951));
                                            let _e973 = select(_e953, _e969, (_e969 > _e953));
                                            let _e975 = select(_e922, _e920, (_e920 > _e922));
                                            let _e977 = select(_e923, _e921, (_e921 > _e923));
                                            let _e979 = select(_e935, _e933, (_e933 > _e935));
                                            let _e981 = select(_e936, _e934, (_e934 > _e936));
                                            let _e983 = select(_e979, _e975, (_e975 < _e979));
                                            let _e985 = select(_e981, _e977, (_e977 < _e981));
                                            let _e990 = -(_e951);
                                            let _e991 = -(_e953);
                                            let _e998 = (select(_e955, _e983, (_e983 < _e955)) + (select(_e990, _e955, (_e955 > _e990)) * 0.0000019073523f));
                                            let _e999 = (select(_e957, _e985, (_e985 < _e957)) + (select(_e991, _e957, (_e957 > _e991)) * 0.0000019073523f));
                                            let _e1001 = select(_e532, _e971, (_e971 > _e532));
                                            let _e1003 = select(_e532, _e973, (_e973 > _e532));
                                            let _e1008 = (_e1001 <= select(_e576.member, _e998, (_e998 < _e576.member)));
                                            let _e1009 = (_e1003 <= select(_e576.member, _e999, (_e999 < _e576.member)));
                                            let _e1010 = (_e1001 <= _e1003);
                                            if _e1008 {
                                                if _e1009 {
                                                    if _e1010 {
                                                        phi_4395_ = _e908.member_2;
                                                    } else {
                                                        phi_4395_ = _e908.member_1;
                                                    }
                                                    let _e1014 = phi_4395_;
                                                    let _e1015 = (_e609 % 128u);
                                                    let _e1016 = (_e1015 < 128u);
                                                    if _e1016 {
                                                    } else {
                                                        phi_4827_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1015] = type_61(type_38(_e1014.member.member, _e1014.member.member_1), _e1014.member_1);
                                                    if _e1016 {
                                                    } else {
                                                        phi_4827_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1015] = select(_e1003, _e1001, (_e1001 > _e1003));
                                                    if _e1010 {
                                                        phi_4428_ = _e908.member_1;
                                                    } else {
                                                        phi_4428_ = _e908.member_2;
                                                    }
                                                    let _e1031 = phi_4428_;
                                                    phi_4429_ = _e1031;
                                                    phi_4430_ = (_e609 + 1u);
                                                } else {
                                                    phi_4429_ = type_61();
                                                    phi_4430_ = u32();
                                                }
                                                let _e1033 = phi_4429_;
                                                let _e1035 = phi_4430_;
                                                phi_4432_ = _e1033;
                                                phi_4433_ = _e1035;
                                                phi_4434_ = select(true, false, _e1009);
                                            } else {
                                                phi_4432_ = type_61();
                                                phi_4433_ = u32();
                                                phi_4434_ = true;
                                            }
                                            let _e1038 = phi_4432_;
                                            let _e1040 = phi_4433_;
                                            let _e1042 = phi_4434_;
                                            if _e1042 {
                                                if _e1008 {
                                                    phi_4443_ = _e908.member_1;
                                                } else {
                                                    phi_4443_ = _e908.member_2;
                                                }
                                                let _e1046 = phi_4443_;
                                                phi_4448_ = _e1046;
                                                phi_4449_ = select(_e1009, true, _e1008);
                                            } else {
                                                phi_4448_ = _e1038;
                                                phi_4449_ = _e607;
                                            }
                                            let _e1049 = phi_4448_;
                                            let _e1051 = phi_4449_;
                                            phi_4831_ = _e574;
                                            phi_4451_ = _e576;
                                            phi_4452_ = _e1049;
                                            phi_4453_ = _e1051;
                                            phi_4454_ = select(_e1040, _e609, _e1042);
                                        }
                                        let _e1679 = phi_4831_;
                                        let _e1681 = phi_4451_;
                                        let _e1683 = phi_4452_;
                                        let _e1685 = phi_4453_;
                                        let _e1687 = phi_4454_;
                                        phi_4830_ = _e1679;
                                        phi_4455_ = _e1681;
                                        phi_4456_ = _e1683;
                                        phi_4457_ = (_e580 - 1u);
                                        phi_4458_ = _e1685;
                                        phi_4459_ = _e1687;
                                    } else {
                                        phi_4830_ = _e574;
                                        phi_4455_ = _e576;
                                        phi_4456_ = _e605;
                                        phi_4457_ = _e580;
                                        phi_4458_ = _e607;
                                        phi_4459_ = _e609;
                                    }
                                    let _e1689 = phi_4830_;
                                    let _e1691 = phi_4455_;
                                    let _e1693 = phi_4456_;
                                    let _e1695 = phi_4457_;
                                    let _e1697 = phi_4458_;
                                    let _e1699 = phi_4459_;
                                    phi_4829_ = _e1689;
                                    phi_4460_ = _e1691;
                                    phi_4461_ = _e1693;
                                    phi_4462_ = _e1695;
                                    phi_4463_ = _e1697;
                                    phi_4464_ = _e1699;
                                } else {
                                    phi_4829_ = _e574;
                                    phi_4460_ = type_49();
                                    phi_4461_ = type_61();
                                    phi_4462_ = u32();
                                    phi_4463_ = bool();
                                    phi_4464_ = u32();
                                }
                                let _e1701 = phi_4829_;
                                let _e1703 = phi_4460_;
                                let _e1705 = phi_4461_;
                                let _e1707 = phi_4462_;
                                let _e1709 = phi_4463_;
                                let _e1711 = phi_4464_;
                                phi_4828_ = _e1701;
                                phi_2024_ = _e1703;
                                phi_2027_ = _e1705;
                                phi_2029_ = _e1707;
                                phi_2031_ = _e1709;
                                phi_2033_ = _e1711;
                                phi_4465_ = _e588;
                            } else {
                                phi_4828_ = _e574;
                                phi_2024_ = type_49();
                                phi_2027_ = type_61();
                                phi_2029_ = u32();
                                phi_2031_ = bool();
                                phi_2033_ = u32();
                                phi_4465_ = false;
                            }
                            let _e1713 = phi_4828_;
                            let _e1715 = phi_2024_;
                            let _e1717 = phi_2027_;
                            let _e1719 = phi_2029_;
                            let _e1721 = phi_2031_;
                            let _e1723 = phi_2033_;
                            let _e1725 = phi_4465_;
                            continue;
                            continuing {
                                phi_4701_ = _e1713;
                                phi_2023_ = _e1715;
                                phi_2026_ = _e1717;
                                phi_2028_ = _e1719;
                                phi_2030_ = _e1721;
                                phi_2032_ = _e1723;
                                phi_4827_ = _e1713;
                                break if !(_e1725);
                            }
                        }
                        let _e1728 = phi_4827_;
                        if _e1728 {
                            break;
                        }
                        let _e1730 = local_5;
                        if _e1730.member_1 {
                        } else {
                            if _e226 {
                            } else {
                                break;
                            }
                            let _e1734 = global_2.member[_e136];
                            if _e151 {
                            } else {
                                break;
                            }
                            let _e1738 = global_10.member[_e136].member_1;
                            if _e226 {
                            } else {
                                break;
                            }
                            global_2.member[_e136] = type_31(_e1734.member, _e1734.member_1, _e1734.member_2, array<f32, 3>((_e1734.member_3[0] + (_e1738[0] * _e1734.member_1[0])), (_e1734.member_3[1] + (_e1738[1] * _e1734.member_1[1])), (_e1734.member_3[2] + (_e1738[2] * _e1734.member_1[2]))), _e1734.member_4);
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
fn trace_shadows_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
