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
    var phi_273_: u32;
    var phi_317_: i32;
    var phi_341_: type_41;
    var phi_491_: i32;
    var phi_492_: i32;
    var phi_502_: bool;
    var phi_512_: u32;
    var phi_513_: u32;
    var phi_515_: bool;
    var phi_520_: u32;
    var phi_552_: i32;
    var phi_570_: f32;
    var phi_576_: f32;
    var phi_587_: f32;
    var phi_593_: f32;
    var phi_616_: f32;
    var phi_627_: f32;
    var phi_636_: f32;
    var phi_642_: f32;
    var phi_653_: f32;
    var phi_659_: f32;
    var phi_682_: f32;
    var phi_693_: f32;
    var phi_702_: f32;
    var phi_708_: f32;
    var phi_719_: f32;
    var phi_725_: f32;
    var phi_748_: f32;
    var phi_759_: f32;
    var phi_859_: f32;
    var phi_860_: f32;
    var phi_3435_: bool;
    var phi_933_: type_46;
    var phi_936_: type_62;
    var phi_938_: u32;
    var phi_940_: bool;
    var phi_942_: u32;
    var phi_953_: bool;
    var phi_1039_: type_62;
    var phi_1040_: bool;
    var phi_1041_: u32;
    var phi_2393_: type_55;
    var phi_3225_: type_62;
    var phi_3302_: type_62;
    var phi_3303_: type_62;
    var phi_3304_: u32;
    var phi_3306_: type_62;
    var phi_3307_: u32;
    var phi_3308_: bool;
    var phi_3315_: type_62;
    var phi_3320_: type_62;
    var phi_3321_: bool;
    var phi_1059_: type_46;
    var phi_1062_: type_8;
    var phi_1063_: type_8;
    var phi_1085_: type_8;
    var phi_1106_: u32;
    var phi_1195_: array<array<f32, 3>, 3>;
    var phi_1312_: bool;
    var phi_1341_: bool;
    var phi_1742_: f32;
    var phi_1743_: f32;
    var phi_1744_: f32;
    var phi_1745_: f32;
    var phi_1746_: vec3<f32>;
    var phi_1747_: vec3<f32>;
    var phi_1748_: vec3<f32>;
    var phi_1749_: vec3<f32>;
    var phi_1780_: bool;
    var phi_1789_: vec3<f32>;
    var phi_1956_: bool;
    var phi_1980_: f32;
    var phi_1981_: f32;
    var phi_2004_: type_27;
    var phi_2006_: type_27;
    var phi_2007_: bool;
    var phi_2011_: type_27;
    var phi_2012_: type_27;
    var phi_2013_: type_27;
    var phi_2014_: bool;
    var phi_2018_: type_27;
    var phi_2019_: bool;
    var phi_2020_: type_27;
    var phi_2021_: bool;
    var phi_2022_: bool;
    var phi_2023_: type_27;
    var phi_2024_: bool;
    var phi_2025_: bool;
    var phi_2033_: type_27;
    var phi_2034_: bool;
    var phi_2038_: type_27;
    var phi_2061_: u32;
    var phi_2075_: i32;
    var phi_2095_: vec3<f32>;
    var phi_2096_: vec3<f32>;
    var phi_2112_: vec3<f32>;
    var phi_2113_: vec3<f32>;
    var phi_2129_: vec3<f32>;
    var phi_2130_: vec3<f32>;
    var phi_2166_: vec3<f32>;
    var phi_2348_: f32;
    var phi_2366_: bool;
    var phi_2367_: bool;
    var phi_2372_: type_46;
    var phi_2373_: type_46;
    var phi_1060_: type_46;
    var phi_3429_: bool;
    var local_10: type_46;
    var phi_3599_: bool;
    var phi_3323_: type_46;
    var phi_3324_: type_62;
    var phi_3325_: bool;
    var phi_3326_: u32;
    var phi_3598_: bool;
    var phi_3327_: type_46;
    var phi_3328_: type_62;
    var phi_3329_: u32;
    var phi_3330_: bool;
    var phi_3331_: u32;
    var phi_3597_: bool;
    var phi_3332_: type_46;
    var phi_3333_: type_62;
    var phi_3334_: u32;
    var phi_3335_: bool;
    var phi_3336_: u32;
    var phi_3596_: bool;
    var phi_934_: type_46;
    var phi_937_: type_62;
    var phi_939_: u32;
    var phi_941_: bool;
    var phi_943_: u32;
    var phi_3337_: bool;
    var phi_3595_: bool;
    var local_11: type_46;
    var local_12: type_46;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e90 = arrayLength((&global_10.member));
            let _e92 = arrayLength((&global_5.member));
            let _e104 = arrayLength((&global_8.member));
            let _e108 = global_4.member[0u][0u];
            let _e112 = global_4.member[0u][1u];
            let _e116 = global_4.member[0u][2u];
            let _e120 = global_4.member[1u][0u];
            let _e124 = global_4.member[1u][1u];
            let _e128 = global_4.member[1u][2u];
            let _e132 = global_4.member[1u][3u];
            let _e136 = (_e87.x + (_e87.y * 2097152u));
            let _e143 = (_e136 < arrayLength((&global_9.member)));
            if _e143 {
                if _e143 {
                } else {
                    break;
                }
                let _e147 = global_9.member[_e136].member_2;
                phi_273_ = _e147;
            } else {
                phi_273_ = 4294967295u;
            }
            let _e149 = phi_273_;
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
                phi_317_ = -126i;
            } else {
                phi_317_ = select(_e192, 127i, (_e192 > 127i));
            }
            let _e197 = phi_317_;
            let _e202 = bitcast<f32>((bitcast<u32>((_e197 + 127i)) << bitcast<u32>(23i)));
            let _e208 = bitcast<f32>((bitcast<u32>(((_e192 - _e197) + 127i)) << bitcast<u32>(23i)));
            if (_e168 == 0u) {
                phi_341_ = type_41(array<f32, 3>(_e185, _e186, _e187), _e168, _e189, _e190);
            } else {
                phi_341_ = type_41(array<f32, 3>(((_e185 * _e202) * _e208), ((_e186 * _e202) * _e208), ((_e187 * _e202) * _e208)), _e168, ((_e189 * _e202) * _e208), _e190);
            }
            let _e221 = phi_341_;
            if _e143 {
                let _e222 = (_e136 < arrayLength((&global_2.member)));
                if _e222 {
                    if _e143 {
                    } else {
                        break;
                    }
                    let _e227 = global_9.member[_e136].member.member_1;
                    let _e232 = global_9.member[_e136].member.member_3;
                    if (_e227 <= _e232) {
                        let _e234 = (1u < _e104);
                        if _e234 {
                            if (0u < _e104) {
                            } else {
                                break;
                            }
                            let _e238 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e238 + 1u) < _e238) {
                                if _e234 {
                                } else {
                                    break;
                                }
                                let _e243 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e143 {
                        } else {
                            break;
                        }
                        let _e253 = global_9.member[_e136].member.member_2[0u];
                        let _e255 = (bitcast<u32>(_e253) & 2147483647u);
                        let _e261 = global_9.member[_e136].member.member_2[1u];
                        let _e263 = (bitcast<u32>(_e261) & 2147483647u);
                        let _e269 = global_9.member[_e136].member.member_2[2u];
                        let _e271 = (bitcast<u32>(_e269) & 2147483647u);
                        let _e277 = global_9.member[_e136].member.member[0u];
                        let _e279 = (bitcast<u32>(_e277) & 2147483647u);
                        let _e285 = global_9.member[_e136].member.member[1u];
                        let _e287 = (bitcast<u32>(_e285) & 2147483647u);
                        let _e293 = global_9.member[_e136].member.member[2u];
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
                                phi_491_ = (bitcast<i32>((_e319 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_491_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e319)), 32u, (_e319 == 0u))));
                            }
                            let _e333 = phi_491_;
                            phi_492_ = _e333;
                        } else {
                            phi_492_ = 0i;
                        }
                        let _e335 = phi_492_;
                        let _e336 = (_e255 == _e299);
                        if _e336 {
                            phi_502_ = true;
                        } else {
                            phi_502_ = (_e263 == _e299);
                        }
                        let _e339 = phi_502_;
                        let _e340 = select(1u, 0u, _e336);
                        if _e339 {
                            let _e341 = (_e340 + 1u);
                            phi_512_ = _e341;
                            phi_513_ = _e341;
                            phi_515_ = select(true, false, (_e341 == 2u));
                        } else {
                            phi_512_ = u32();
                            phi_513_ = 0u;
                            phi_515_ = true;
                        }
                        let _e345 = phi_512_;
                        let _e347 = phi_513_;
                        let _e349 = phi_515_;
                        if _e349 {
                            phi_520_ = (_e347 + 1u);
                        } else {
                            phi_520_ = 0u;
                        }
                        let _e353 = phi_520_;
                        let _e354 = select(_e345, _e347, _e349);
                        let _e355 = select(_e340, select(2u, _e340, _e339), _e349);
                        let _e356 = -(_e335);
                        if (_e356 < -126i) {
                            phi_552_ = -126i;
                        } else {
                            phi_552_ = select(_e356, 127i, (_e356 > 127i));
                        }
                        let _e361 = phi_552_;
                        let _e366 = bitcast<f32>((bitcast<u32>((_e361 + 127i)) << bitcast<u32>(23i)));
                        let _e372 = bitcast<f32>((bitcast<u32>(((_e356 - _e361) + 127i)) << bitcast<u32>(23i)));
                        let _e377 = global_9.member[_e136].member.member;
                        let _e378 = (_e354 == 0u);
                        if _e378 {
                            phi_570_ = _e377[0];
                        } else {
                            phi_570_ = _e377[1];
                        }
                        let _e382 = phi_570_;
                        let _e383 = (_e354 == 2u);
                        if _e383 {
                            phi_576_ = _e377[2];
                        } else {
                            phi_576_ = _e382;
                        }
                        let _e386 = phi_576_;
                        let _e387 = global_9.member[_e136].member.member_2;
                        if _e378 {
                            phi_587_ = _e387[0];
                        } else {
                            phi_587_ = _e387[1];
                        }
                        let _e391 = phi_587_;
                        if _e383 {
                            phi_593_ = _e387[2];
                        } else {
                            phi_593_ = _e391;
                        }
                        let _e394 = phi_593_;
                        let _e396 = ((_e394 * _e366) * _e372);
                        let _e400 = (bitcast<f32>((bitcast<u32>(_e396) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e400 {
                            let _e404 = (bitcast<f32>((bitcast<u32>(_e386) & 2147483647u)) * 0.00000011920929f);
                            phi_616_ = select(0.00000000000011368684f, _e404, (_e404 > 0.00000000000011368684f));
                        } else {
                            phi_616_ = 0f;
                        }
                        let _e408 = phi_616_;
                        let _e409 = (_e386 + _e408);
                        let _e410 = (_e386 - _e408);
                        let _e411 = select(_e396, 0f, _e400);
                        if _e400 {
                            phi_627_ = 38685626000000000000000000f;
                        } else {
                            phi_627_ = (1f / _e396);
                        }
                        let _e414 = phi_627_;
                        let _e415 = (_e353 == 0u);
                        if _e415 {
                            phi_636_ = _e377[0];
                        } else {
                            phi_636_ = _e377[1];
                        }
                        let _e419 = phi_636_;
                        let _e420 = (_e353 == 2u);
                        if _e420 {
                            phi_642_ = _e377[2];
                        } else {
                            phi_642_ = _e419;
                        }
                        let _e423 = phi_642_;
                        if _e415 {
                            phi_653_ = _e387[0];
                        } else {
                            phi_653_ = _e387[1];
                        }
                        let _e427 = phi_653_;
                        if _e420 {
                            phi_659_ = _e387[2];
                        } else {
                            phi_659_ = _e427;
                        }
                        let _e430 = phi_659_;
                        let _e432 = ((_e430 * _e366) * _e372);
                        let _e436 = (bitcast<f32>((bitcast<u32>(_e432) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e436 {
                            let _e440 = (bitcast<f32>((bitcast<u32>(_e423) & 2147483647u)) * 0.00000011920929f);
                            phi_682_ = select(0.00000000000011368684f, _e440, (_e440 > 0.00000000000011368684f));
                        } else {
                            phi_682_ = 0f;
                        }
                        let _e444 = phi_682_;
                        let _e445 = (_e423 + _e444);
                        let _e446 = (_e423 - _e444);
                        let _e447 = select(_e432, 0f, _e436);
                        if _e436 {
                            phi_693_ = 38685626000000000000000000f;
                        } else {
                            phi_693_ = (1f / _e432);
                        }
                        let _e450 = phi_693_;
                        let _e451 = (_e355 == 0u);
                        if _e451 {
                            phi_702_ = _e377[0];
                        } else {
                            phi_702_ = _e377[1];
                        }
                        let _e455 = phi_702_;
                        let _e456 = (_e355 == 2u);
                        if _e456 {
                            phi_708_ = _e377[2];
                        } else {
                            phi_708_ = _e455;
                        }
                        let _e459 = phi_708_;
                        if _e451 {
                            phi_719_ = _e387[0];
                        } else {
                            phi_719_ = _e387[1];
                        }
                        let _e463 = phi_719_;
                        if _e456 {
                            phi_725_ = _e387[2];
                        } else {
                            phi_725_ = _e463;
                        }
                        let _e466 = phi_725_;
                        let _e468 = ((_e466 * _e366) * _e372);
                        let _e472 = (bitcast<f32>((bitcast<u32>(_e468) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e472 {
                            let _e476 = (bitcast<f32>((bitcast<u32>(_e459) & 2147483647u)) * 0.00000011920929f);
                            phi_748_ = select(0.00000000000011368684f, _e476, (_e476 > 0.00000000000011368684f));
                        } else {
                            phi_748_ = 0f;
                        }
                        let _e480 = phi_748_;
                        let _e481 = (_e459 + _e480);
                        let _e482 = (_e459 - _e480);
                        let _e483 = select(_e468, 0f, _e472);
                        if _e472 {
                            phi_759_ = 38685626000000000000000000f;
                        } else {
                            phi_759_ = (1f / _e468);
                        }
                        let _e486 = phi_759_;
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
                            phi_859_ = select(-340282350000000000000000000000000000000f, _e526, (_e526 > -340282350000000000000000000000000000000f));
                            phi_860_ = select(-340282350000000000000000000000000000000f, _e519, (_e519 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_859_ = 0f;
                            phi_860_ = 1f;
                        }
                        let _e530 = phi_859_;
                        let _e532 = phi_860_;
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
                        phi_3435_ = false;
                        phi_933_ = type_46(_e530, false);
                        phi_936_ = type_62(type_60(array<f32, 3>(_e540, _e544, _e548), array<f32, 3>(_e552, _e554, _e556)), select(0u, 2147483648u, (_e90 == 0u)));
                        phi_938_ = ((3u * _e90) + 1u);
                        phi_940_ = (_e532 <= _e530);
                        phi_942_ = 0u;
                        loop {
                            let _e564 = phi_3435_;
                            let _e566 = phi_933_;
                            let _e568 = phi_936_;
                            let _e570 = phi_938_;
                            let _e572 = phi_940_;
                            let _e574 = phi_942_;
                            local_11 = _e566;
                            if _e572 {
                                phi_953_ = true;
                            } else {
                                phi_953_ = (_e574 > 0u);
                            }
                            let _e577 = phi_953_;
                            if _e577 {
                                let _e578 = (_e570 > 0u);
                                if _e578 {
                                    if _e572 {
                                        phi_1039_ = _e568;
                                        phi_1040_ = _e572;
                                        phi_1041_ = _e574;
                                    } else {
                                        let _e579 = (_e574 - 1u);
                                        let _e580 = (_e579 % 128u);
                                        let _e581 = (_e580 < 128u);
                                        if _e581 {
                                        } else {
                                            phi_3595_ = true;
                                            break;
                                        }
                                        let _e583 = local_6[_e580];
                                        if _e581 {
                                        } else {
                                            phi_3595_ = true;
                                            break;
                                        }
                                        let _e585 = local_5[_e580];
                                        if _e581 {
                                        } else {
                                            phi_3595_ = true;
                                            break;
                                        }
                                        let _e587 = local_4[_e580];
                                        if _e581 {
                                        } else {
                                            phi_3595_ = true;
                                            break;
                                        }
                                        let _e589 = local_3[_e580];
                                        if _e581 {
                                        } else {
                                            phi_3595_ = true;
                                            break;
                                        }
                                        let _e592 = local_2[_e580];
                                        if _e581 {
                                        } else {
                                            phi_3595_ = true;
                                            break;
                                        }
                                        let _e594 = local_1[_e580];
                                        if _e581 {
                                        } else {
                                            phi_3595_ = true;
                                            break;
                                        }
                                        let _e596 = local[_e580];
                                        if _e581 {
                                        } else {
                                            phi_3595_ = true;
                                            break;
                                        }
                                        let _e601 = local_7[_e580];
                                        phi_1039_ = type_62(type_60(array<f32, 3>(_e585, _e587, _e589), array<f32, 3>(_e592, _e594, _e596)), _e583);
                                        phi_1040_ = (_e601 <= _e566.member);
                                        phi_1041_ = _e579;
                                    }
                                    let _e605 = phi_1039_;
                                    let _e607 = phi_1040_;
                                    let _e609 = phi_1041_;
                                    if _e607 {
                                        if ((_e605.member_1 & 2147483648u) != 0u) {
                                            phi_1059_ = _e566;
                                            phi_1062_ = type_8(0u, ((_e605.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e961 = phi_1059_;
                                                let _e963 = phi_1062_;
                                                local_10 = _e961;
                                                local_12 = _e961;
                                                if (_e963.member < _e963.member_1) {
                                                    phi_1063_ = type_8((_e963.member + 1u), _e963.member_1);
                                                    phi_1085_ = type_8(1u, _e963.member);
                                                } else {
                                                    phi_1063_ = _e963;
                                                    phi_1085_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e976 = phi_1063_;
                                                let _e978 = phi_1085_;
                                                let _e982 = (bitcast<i32>(_e978.member) != 0i);
                                                if _e982 {
                                                    let _e983 = ((_e605.member_1 & 268435455u) + _e978.member_1);
                                                    let _e984 = (_e983 < _e92);
                                                    if _e984 {
                                                        if _e984 {
                                                        } else {
                                                            phi_3429_ = true;
                                                            break;
                                                        }
                                                        let _e988 = global_5.member[_e983].member_1;
                                                        phi_1106_ = _e988;
                                                    } else {
                                                        phi_1106_ = 4294967295u;
                                                    }
                                                    let _e990 = phi_1106_;
                                                    if (_e983 >= _e92) {
                                                        phi_1195_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e984 {
                                                        } else {
                                                            phi_3429_ = true;
                                                            break;
                                                        }
                                                        if (_e537 < 9u) {
                                                        } else {
                                                            phi_3429_ = true;
                                                            break;
                                                        }
                                                        let _e997 = global_5.member[_e983].member[_e537];
                                                        if (_e541 < 9u) {
                                                        } else {
                                                            phi_3429_ = true;
                                                            break;
                                                        }
                                                        let _e1003 = global_5.member[_e983].member[_e541];
                                                        if (_e545 < 9u) {
                                                        } else {
                                                            phi_3429_ = true;
                                                            break;
                                                        }
                                                        let _e1009 = global_5.member[_e983].member[_e545];
                                                        let _e1011 = (3u + _e537);
                                                        if (_e1011 < 9u) {
                                                        } else {
                                                            phi_3429_ = true;
                                                            break;
                                                        }
                                                        let _e1017 = global_5.member[_e983].member[_e1011];
                                                        let _e1018 = (3u + _e541);
                                                        if (_e1018 < 9u) {
                                                        } else {
                                                            phi_3429_ = true;
                                                            break;
                                                        }
                                                        let _e1024 = global_5.member[_e983].member[_e1018];
                                                        let _e1025 = (3u + _e545);
                                                        if (_e1025 < 9u) {
                                                        } else {
                                                            phi_3429_ = true;
                                                            break;
                                                        }
                                                        let _e1031 = global_5.member[_e983].member[_e1025];
                                                        let _e1033 = (6u + _e537);
                                                        if (_e1033 < 9u) {
                                                        } else {
                                                            phi_3429_ = true;
                                                            break;
                                                        }
                                                        let _e1039 = global_5.member[_e983].member[_e1033];
                                                        let _e1040 = (6u + _e541);
                                                        if (_e1040 < 9u) {
                                                        } else {
                                                            phi_3429_ = true;
                                                            break;
                                                        }
                                                        let _e1046 = global_5.member[_e983].member[_e1040];
                                                        let _e1047 = (6u + _e545);
                                                        if (_e1047 < 9u) {
                                                        } else {
                                                            phi_3429_ = true;
                                                            break;
                                                        }
                                                        let _e1053 = global_5.member[_e983].member[_e1047];
                                                        phi_1195_ = array<array<f32, 3>, 3>(array<f32, 3>(_e997, _e1003, _e1009), array<f32, 3>(_e1017, _e1024, _e1031), array<f32, 3>(_e1039, _e1046, _e1053));
                                                    }
                                                    let _e1057 = phi_1195_;
                                                    let _e1065 = (_e1057[0][2] - _e459);
                                                    let _e1068 = (((_e1057[0][0] - _e386) * _e483) - (_e1065 * _e411));
                                                    let _e1071 = (((_e1057[0][1] - _e423) * _e483) - (_e1065 * _e447));
                                                    let _e1078 = (_e1057[1][2] - _e459);
                                                    let _e1081 = (((_e1057[1][0] - _e386) * _e483) - (_e1078 * _e411));
                                                    let _e1084 = (((_e1057[1][1] - _e423) * _e483) - (_e1078 * _e447));
                                                    let _e1091 = (_e1057[2][2] - _e459);
                                                    let _e1094 = (((_e1057[2][0] - _e386) * _e483) - (_e1091 * _e411));
                                                    let _e1097 = (((_e1057[2][1] - _e423) * _e483) - (_e1091 * _e447));
                                                    let _e1098 = (_e1094 * _e1084);
                                                    let _e1099 = (_e1097 * _e1081);
                                                    let _e1100 = (_e1068 * _e1097);
                                                    let _e1101 = (_e1071 * _e1094);
                                                    let _e1102 = (_e1081 * _e1071);
                                                    let _e1103 = (_e1084 * _e1068);
                                                    let _e1108 = (((_e1098 >= _e1099) && (_e1100 >= _e1101)) && (_e1102 >= _e1103));
                                                    if (_e1108 || (((_e1098 <= _e1099) && (_e1100 <= _e1101)) && (_e1102 <= _e1103))) {
                                                        let _e1115 = select(-1f, 1f, _e1108);
                                                        let _e1117 = ((_e1098 - _e1099) * _e1115);
                                                        let _e1119 = select(0f, _e1117, (_e1117 > 0f));
                                                        let _e1121 = ((_e1100 - _e1101) * _e1115);
                                                        let _e1123 = select(0f, _e1121, (_e1121 > 0f));
                                                        let _e1125 = ((_e1102 - _e1103) * _e1115);
                                                        let _e1127 = select(0f, _e1125, (_e1125 > 0f));
                                                        let _e1129 = ((_e1119 + _e1123) + _e1127);
                                                        if (_e1129 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2023_ = type_27();
                                                            phi_2024_ = true;
                                                            phi_2025_ = false;
                                                        } else {
                                                            let _e1132 = select(_e1081, _e1068, (_e1068 < _e1081));
                                                            if (select(_e1094, _e1132, (_e1132 < _e1094)) > 0f) {
                                                                phi_1312_ = true;
                                                            } else {
                                                                let _e1137 = select(_e1081, _e1068, (_e1068 > _e1081));
                                                                phi_1312_ = (select(_e1094, _e1137, (_e1137 > _e1094)) < 0f);
                                                            }
                                                            let _e1142 = phi_1312_;
                                                            if _e1142 {
                                                                phi_2020_ = type_27();
                                                                phi_2021_ = true;
                                                                phi_2022_ = false;
                                                            } else {
                                                                let _e1144 = select(_e1084, _e1071, (_e1071 < _e1084));
                                                                if (select(_e1097, _e1144, (_e1144 < _e1097)) > 0f) {
                                                                    phi_1341_ = true;
                                                                } else {
                                                                    let _e1149 = select(_e1084, _e1071, (_e1071 > _e1084));
                                                                    phi_1341_ = (select(_e1097, _e1149, (_e1149 > _e1097)) < 0f);
                                                                }
                                                                let _e1154 = phi_1341_;
                                                                if _e1154 {
                                                                    phi_2018_ = type_27();
                                                                    phi_2019_ = false;
                                                                } else {
                                                                    let _e1156 = select(_e1057[1][0], _e1057[0][0], (_e1057[0][0] < _e1057[1][0]));
                                                                    let _e1160 = select(_e1057[1][0], _e1057[0][0], (_e1057[0][0] > _e1057[1][0]));
                                                                    let _e1164 = select(_e1057[1][1], _e1057[0][1], (_e1057[0][1] < _e1057[1][1]));
                                                                    let _e1168 = select(_e1057[1][1], _e1057[0][1], (_e1057[0][1] > _e1057[1][1]));
                                                                    let _e1172 = select(_e1057[1][2], _e1057[0][2], (_e1057[0][2] < _e1057[1][2]));
                                                                    let _e1176 = select(_e1057[1][2], _e1057[0][2], (_e1057[0][2] > _e1057[1][2]));
                                                                    let _e1181 = ((select(_e1057[2][0], _e1156, (_e1156 < _e1057[2][0])) - _e409) * _e414);
                                                                    let _e1182 = ((select(_e1057[2][0], _e1160, (_e1160 > _e1057[2][0])) - _e410) * _e414);
                                                                    let _e1185 = ((select(_e1057[2][1], _e1164, (_e1164 < _e1057[2][1])) - _e445) * _e450);
                                                                    let _e1186 = ((select(_e1057[2][1], _e1168, (_e1168 > _e1057[2][1])) - _e446) * _e450);
                                                                    let _e1189 = ((select(_e1057[2][2], _e1172, (_e1172 < _e1057[2][2])) - _e481) * _e486);
                                                                    let _e1190 = ((select(_e1057[2][2], _e1176, (_e1176 > _e1057[2][2])) - _e482) * _e486);
                                                                    let _e1192 = select(_e1190, _e1189, (_e1189 < _e1190));
                                                                    let _e1194 = select(_e1190, _e1189, (_e1189 > _e1190));
                                                                    let _e1196 = select(_e1182, _e1181, (_e1181 < _e1182));
                                                                    let _e1198 = select(_e1186, _e1185, (_e1185 < _e1186));
                                                                    let _e1200 = select(_e1198, _e1196, (_e1196 > _e1198));
                                                                    let _e1202 = select(_e1192, _e1200, (_e1200 > _e1192));
                                                                    let _e1204 = select(_e1182, _e1181, (_e1181 > _e1182));
                                                                    let _e1206 = select(_e1186, _e1185, (_e1185 > _e1186));
                                                                    let _e1208 = select(_e1206, _e1204, (_e1204 < _e1206));
                                                                    let _e1210 = select(_e1194, _e1208, (_e1208 < _e1194));
                                                                    let _e1211 = -(_e1192);
                                                                    let _e1217 = select(_e532, _e1202, (_e1202 > _e532));
                                                                    if (_e1217 > (_e1210 + (select(_e1211, _e1194, (_e1194 > _e1211)) * 0.0000019073523f))) {
                                                                        phi_2013_ = type_27();
                                                                        phi_2014_ = true;
                                                                    } else {
                                                                        let _e1219 = (_e1217 > _e961.member);
                                                                        if _e1219 {
                                                                            phi_2012_ = type_27();
                                                                        } else {
                                                                            let _e1220 = vec3<f32>(_e1057[0][0], _e1057[0][1], _e1057[0][2]);
                                                                            let _e1221 = vec3<f32>(_e1057[1][0], _e1057[1][1], _e1057[1][2]);
                                                                            let _e1222 = vec3<f32>(_e1057[2][0], _e1057[2][1], _e1057[2][2]);
                                                                            let _e1223 = (_e1057[1][0] - _e1057[0][0]);
                                                                            let _e1224 = (_e1057[1][1] - _e1057[0][1]);
                                                                            let _e1225 = (_e1057[1][2] - _e1057[0][2]);
                                                                            let _e1226 = vec3<f32>(_e1223, _e1224, _e1225);
                                                                            let _e1227 = (_e1057[2][0] - _e1057[1][0]);
                                                                            let _e1228 = (_e1057[2][1] - _e1057[1][1]);
                                                                            let _e1229 = (_e1057[2][2] - _e1057[1][2]);
                                                                            let _e1230 = vec3<f32>(_e1227, _e1228, _e1229);
                                                                            let _e1231 = (_e1057[0][0] - _e1057[2][0]);
                                                                            let _e1232 = (_e1057[0][1] - _e1057[2][1]);
                                                                            let _e1233 = (_e1057[0][2] - _e1057[2][2]);
                                                                            let _e1234 = vec3<f32>(_e1231, _e1232, _e1233);
                                                                            let _e1237 = bitcast<f32>((bitcast<u32>(_e1223) & 2147483647u));
                                                                            let _e1240 = bitcast<f32>((bitcast<u32>(_e1224) & 2147483647u));
                                                                            let _e1242 = select(_e1240, _e1237, (_e1237 > _e1240));
                                                                            let _e1245 = bitcast<f32>((bitcast<u32>(_e1225) & 2147483647u));
                                                                            let _e1247 = select(_e1245, _e1242, (_e1242 > _e1245));
                                                                            let _e1250 = bitcast<f32>((bitcast<u32>(_e1227) & 2147483647u));
                                                                            let _e1253 = bitcast<f32>((bitcast<u32>(_e1228) & 2147483647u));
                                                                            let _e1255 = select(_e1253, _e1250, (_e1250 > _e1253));
                                                                            let _e1258 = bitcast<f32>((bitcast<u32>(_e1229) & 2147483647u));
                                                                            let _e1260 = select(_e1258, _e1255, (_e1255 > _e1258));
                                                                            let _e1263 = bitcast<f32>((bitcast<u32>(_e1231) & 2147483647u));
                                                                            let _e1266 = bitcast<f32>((bitcast<u32>(_e1232) & 2147483647u));
                                                                            let _e1268 = select(_e1266, _e1263, (_e1263 > _e1266));
                                                                            let _e1271 = bitcast<f32>((bitcast<u32>(_e1233) & 2147483647u));
                                                                            let _e1273 = select(_e1271, _e1268, (_e1268 > _e1271));
                                                                            let _e1275 = select(_e1260, _e1247, (_e1247 > _e1260));
                                                                            let _e1277 = select(_e1273, _e1275, (_e1275 > _e1273));
                                                                            if (_e1247 == _e1277) {
                                                                                phi_1742_ = _e1084;
                                                                                phi_1743_ = _e1081;
                                                                                phi_1744_ = _e1071;
                                                                                phi_1745_ = _e1068;
                                                                                phi_1746_ = _e1220;
                                                                                phi_1747_ = _e1234;
                                                                                phi_1748_ = _e1230;
                                                                                phi_1749_ = _e1226;
                                                                            } else {
                                                                                let _e1279 = (_e1260 == _e1277);
                                                                                let _e1284 = vec3(_e1279);
                                                                                phi_1742_ = select(_e1071, _e1097, _e1279);
                                                                                phi_1743_ = select(_e1068, _e1094, _e1279);
                                                                                phi_1744_ = select(_e1097, _e1084, _e1279);
                                                                                phi_1745_ = select(_e1094, _e1081, _e1279);
                                                                                phi_1746_ = select(_e1222, _e1221, _e1284);
                                                                                phi_1747_ = select(_e1230, _e1226, _e1284);
                                                                                phi_1748_ = select(_e1226, _e1234, _e1284);
                                                                                phi_1749_ = select(_e1234, _e1230, _e1284);
                                                                            }
                                                                            let _e1290 = phi_1742_;
                                                                            let _e1292 = phi_1743_;
                                                                            let _e1294 = phi_1744_;
                                                                            let _e1296 = phi_1745_;
                                                                            let _e1298 = phi_1746_;
                                                                            let _e1300 = phi_1747_;
                                                                            let _e1302 = phi_1748_;
                                                                            let _e1304 = phi_1749_;
                                                                            let _e1311 = ((_e1302.y * _e1300.z) - (_e1300.y * _e1302.z));
                                                                            let _e1316 = ((_e1302.z * _e1300.x) - (_e1300.z * _e1302.x));
                                                                            let _e1319 = ((_e1302.x * _e1300.y) - (_e1300.x * _e1302.y));
                                                                            if (_e1119 >= _e1123) {
                                                                                phi_1780_ = select(true, false, (_e1119 >= _e1127));
                                                                            } else {
                                                                                phi_1780_ = true;
                                                                            }
                                                                            let _e1324 = phi_1780_;
                                                                            if _e1324 {
                                                                                phi_1789_ = select(_e1222, _e1221, vec3((_e1123 >= _e1127)));
                                                                            } else {
                                                                                phi_1789_ = _e1220;
                                                                            }
                                                                            let _e1329 = phi_1789_;
                                                                            let _e1334 = (((_e1311 * _e411) + (_e1316 * _e447)) + (_e1319 * _e483));
                                                                            let _e1345 = (((_e1311 * (_e1329.x - _e386)) + (_e1316 * (_e1329.y - _e423))) + (_e1319 * (_e1329.z - _e459)));
                                                                            let _e1347 = (_e1292 - _e1296);
                                                                            let _e1348 = (_e1290 - _e1294);
                                                                            let _e1356 = (-(((_e1296 * _e1347) + (_e1294 * _e1348))) / ((_e1347 * _e1347) + (_e1348 * _e1348)));
                                                                            let _e1358 = select(1f, _e1356, (_e1356 < 1f));
                                                                            let _e1360 = select(0f, _e1358, (_e1358 > 0f));
                                                                            let _e1373 = ((_e1298.x + (_e1304.x * _e1360)) - _e386);
                                                                            let _e1374 = ((_e1298.y + (_e1304.y * _e1360)) - _e423);
                                                                            let _e1375 = ((_e1298.z + (_e1304.z * _e1360)) - _e459);
                                                                            let _e1376 = (_e1375 / _e483);
                                                                            let _e1388 = bitcast<f32>((bitcast<u32>(_e1373) & 2147483647u));
                                                                            let _e1391 = bitcast<f32>((bitcast<u32>(_e1374) & 2147483647u));
                                                                            let _e1393 = select(_e1391, _e1388, (_e1388 > _e1391));
                                                                            let _e1396 = bitcast<f32>((bitcast<u32>(_e1375) & 2147483647u));
                                                                            let _e1398 = select(_e1396, _e1393, (_e1393 > _e1396));
                                                                            let _e1404 = bitcast<f32>((bitcast<u32>(_e1311) & 2147483647u));
                                                                            let _e1407 = bitcast<f32>((bitcast<u32>(_e1316) & 2147483647u));
                                                                            let _e1409 = select(_e1407, _e1404, (_e1404 > _e1407));
                                                                            let _e1412 = bitcast<f32>((bitcast<u32>(_e1319) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1311 * _e1373) + (_e1316 * _e1374)) + (_e1319 * _e1375)) - _e1345)) & 2147483647u)) <= ((0.0000009536743f * select(_e1277, _e1398, (_e1398 > _e1277))) * select(_e1412, _e1409, (_e1409 > _e1412)))) {
                                                                                let _e1422 = bitcast<f32>((bitcast<u32>(_e1302.x) & 2147483647u));
                                                                                let _e1425 = bitcast<f32>((bitcast<u32>(_e1302.y) & 2147483647u));
                                                                                let _e1427 = select(_e1425, _e1422, (_e1422 > _e1425));
                                                                                let _e1430 = bitcast<f32>((bitcast<u32>(_e1302.z) & 2147483647u));
                                                                                let _e1436 = bitcast<f32>((bitcast<u32>(_e1300.x) & 2147483647u));
                                                                                let _e1439 = bitcast<f32>((bitcast<u32>(_e1300.y) & 2147483647u));
                                                                                let _e1441 = select(_e1439, _e1436, (_e1436 > _e1439));
                                                                                let _e1444 = bitcast<f32>((bitcast<u32>(_e1300.z) & 2147483647u));
                                                                                phi_1956_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1334) & 2147483647u)) > ((0.0000038146973f * select(_e1430, _e1427, (_e1427 > _e1430))) * select(_e1444, _e1441, (_e1441 > _e1444)))));
                                                                            } else {
                                                                                phi_1956_ = true;
                                                                            }
                                                                            let _e1451 = phi_1956_;
                                                                            if _e1451 {
                                                                                let _e1462 = ((((_e1311 * (_e1373 - (_e411 * _e1376))) + (_e1316 * (_e1374 - (_e447 * _e1376)))) + (_e1319 * (_e1375 - _e1375))) / _e1334);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1462) & 2147483647u)) <= _e1277) {
                                                                                    phi_1980_ = (_e1376 + _e1462);
                                                                                } else {
                                                                                    phi_1980_ = _e1376;
                                                                                }
                                                                                let _e1469 = phi_1980_;
                                                                                phi_1981_ = _e1469;
                                                                            } else {
                                                                                phi_1981_ = (_e1345 / _e1334);
                                                                            }
                                                                            let _e1471 = phi_1981_;
                                                                            let _e1473 = select(_e1210, _e1471, (_e1471 < _e1210));
                                                                            let _e1475 = select(_e1202, _e1473, (_e1473 > _e1202));
                                                                            if (_e1475 >= _e532) {
                                                                                let _e1477 = (_e1475 <= _e961.member);
                                                                                if _e1477 {
                                                                                    let _e1478 = (1f / _e1129);
                                                                                    phi_2004_ = type_27(_e1475, (_e1123 * _e1478), (_e1127 * _e1478), _e990);
                                                                                } else {
                                                                                    phi_2004_ = type_27();
                                                                                }
                                                                                let _e1483 = phi_2004_;
                                                                                phi_2006_ = _e1483;
                                                                                phi_2007_ = select(true, false, _e1477);
                                                                            } else {
                                                                                phi_2006_ = type_27();
                                                                                phi_2007_ = true;
                                                                            }
                                                                            let _e1486 = phi_2006_;
                                                                            let _e1488 = phi_2007_;
                                                                            if _e1488 {
                                                                                phi_2011_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2011_ = _e1486;
                                                                            }
                                                                            let _e1490 = phi_2011_;
                                                                            phi_2012_ = _e1490;
                                                                        }
                                                                        let _e1492 = phi_2012_;
                                                                        phi_2013_ = _e1492;
                                                                        phi_2014_ = _e1219;
                                                                    }
                                                                    let _e1494 = phi_2013_;
                                                                    let _e1496 = phi_2014_;
                                                                    phi_2018_ = _e1494;
                                                                    phi_2019_ = _e1496;
                                                                }
                                                                let _e1498 = phi_2018_;
                                                                let _e1500 = phi_2019_;
                                                                phi_2020_ = _e1498;
                                                                phi_2021_ = _e1154;
                                                                phi_2022_ = _e1500;
                                                            }
                                                            let _e1502 = phi_2020_;
                                                            let _e1504 = phi_2021_;
                                                            let _e1506 = phi_2022_;
                                                            phi_2023_ = _e1502;
                                                            phi_2024_ = _e1504;
                                                            phi_2025_ = _e1506;
                                                        }
                                                        let _e1508 = phi_2023_;
                                                        let _e1510 = phi_2024_;
                                                        let _e1512 = phi_2025_;
                                                        phi_2033_ = _e1508;
                                                        phi_2034_ = select(_e1512, true, _e1510);
                                                    } else {
                                                        phi_2033_ = type_27();
                                                        phi_2034_ = true;
                                                    }
                                                    let _e1515 = phi_2033_;
                                                    let _e1517 = phi_2034_;
                                                    if _e1517 {
                                                        phi_2038_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2038_ = _e1515;
                                                    }
                                                    let _e1519 = phi_2038_;
                                                    if (_e1519.member_3 != 4294967295u) {
                                                        if (_e990 == _e149) {
                                                            phi_2367_ = false;
                                                        } else {
                                                            let _e1523 = (_e990 < arrayLength((&global_6.member)));
                                                            if _e1523 {
                                                                if _e1523 {
                                                                } else {
                                                                    phi_3429_ = true;
                                                                    break;
                                                                }
                                                                let _e1525 = global_6.member[_e990];
                                                                phi_2061_ = _e1525;
                                                            } else {
                                                                phi_2061_ = 4294967295u;
                                                            }
                                                            let _e1527 = phi_2061_;
                                                            let _e1528 = (_e1527 < arrayLength((&global_7.member)));
                                                            if _e1528 {
                                                                if _e1528 {
                                                                } else {
                                                                    phi_3429_ = true;
                                                                    break;
                                                                }
                                                                let _e1530 = global_7.member[_e1527];
                                                                phi_2075_ = _e1530;
                                                            } else {
                                                                phi_2075_ = 0i;
                                                            }
                                                            let _e1532 = phi_2075_;
                                                            let _e1533 = (_e1532 == 0i);
                                                            if _e1533 {
                                                                phi_2366_ = true;
                                                            } else {
                                                                if _e378 {
                                                                    phi_2096_ = vec3<f32>(_e1057[0][0], _e1057[0][1], _e1057[0][2]);
                                                                } else {
                                                                    if (_e354 == 1u) {
                                                                        phi_2095_ = vec3<f32>(_e1057[0][2], _e1057[0][0], _e1057[0][1]);
                                                                    } else {
                                                                        phi_2095_ = vec3<f32>(_e1057[0][1], _e1057[0][2], _e1057[0][0]);
                                                                    }
                                                                    let _e1538 = phi_2095_;
                                                                    phi_2096_ = _e1538;
                                                                }
                                                                let _e1541 = phi_2096_;
                                                                if _e378 {
                                                                    phi_2113_ = vec3<f32>(_e1057[1][0], _e1057[1][1], _e1057[1][2]);
                                                                } else {
                                                                    if (_e354 == 1u) {
                                                                        phi_2112_ = vec3<f32>(_e1057[1][2], _e1057[1][0], _e1057[1][1]);
                                                                    } else {
                                                                        phi_2112_ = vec3<f32>(_e1057[1][1], _e1057[1][2], _e1057[1][0]);
                                                                    }
                                                                    let _e1546 = phi_2112_;
                                                                    phi_2113_ = _e1546;
                                                                }
                                                                let _e1549 = phi_2113_;
                                                                if _e378 {
                                                                    phi_2130_ = vec3<f32>(_e1057[2][0], _e1057[2][1], _e1057[2][2]);
                                                                } else {
                                                                    if (_e354 == 1u) {
                                                                        phi_2129_ = vec3<f32>(_e1057[2][2], _e1057[2][0], _e1057[2][1]);
                                                                    } else {
                                                                        phi_2129_ = vec3<f32>(_e1057[2][1], _e1057[2][2], _e1057[2][0]);
                                                                    }
                                                                    let _e1554 = phi_2129_;
                                                                    phi_2130_ = _e1554;
                                                                }
                                                                let _e1557 = phi_2130_;
                                                                let _e1560 = (_e1549.x - _e1541.x);
                                                                let _e1563 = (_e1549.y - _e1541.y);
                                                                let _e1566 = (_e1549.z - _e1541.z);
                                                                let _e1568 = (_e1557.x - _e1541.x);
                                                                let _e1570 = (_e1557.y - _e1541.y);
                                                                let _e1572 = (_e1557.z - _e1541.z);
                                                                if (_e221.member_1 == 1u) {
                                                                    phi_2166_ = (vec3<f32>(_e221.member[0], _e221.member[1], _e221.member[2]) - _e1541);
                                                                } else {
                                                                    phi_2166_ = vec3<f32>(_e221.member[0], _e221.member[1], _e221.member[2]);
                                                                }
                                                                let _e1587 = phi_2166_;
                                                                let _e1593 = bitcast<f32>((bitcast<u32>((_e1560 * _e1570)) ^ _e221.member_3[0]));
                                                                let _e1597 = bitcast<f32>((bitcast<u32>((_e1563 * _e1568)) ^ _e221.member_3[0]));
                                                                let _e1601 = bitcast<f32>((bitcast<u32>((_e1563 * _e1572)) ^ _e221.member_3[0]));
                                                                let _e1605 = bitcast<f32>((bitcast<u32>((_e1566 * _e1570)) ^ _e221.member_3[0]));
                                                                let _e1609 = bitcast<f32>((bitcast<u32>((_e1566 * _e1568)) ^ _e221.member_3[0]));
                                                                let _e1613 = bitcast<f32>((bitcast<u32>((_e1560 * _e1572)) ^ _e221.member_3[0]));
                                                                let _e1614 = (_e1601 - _e1605);
                                                                let _e1615 = (_e1609 - _e1613);
                                                                let _e1616 = (_e1593 - _e1597);
                                                                let _e1640 = (bitcast<f32>((bitcast<u32>(_e1601) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1605) & 2147483647u)));
                                                                let _e1647 = (bitcast<f32>((bitcast<u32>(_e1609) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1613) & 2147483647u)));
                                                                let _e1654 = (bitcast<f32>((bitcast<u32>(_e1593) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1597) & 2147483647u)));
                                                                if (_e221.member_2 == 0f) {
                                                                    phi_2348_ = 0f;
                                                                } else {
                                                                    let _e1684 = bitcast<f32>((bitcast<u32>(_e1614) & 2147483647u));
                                                                    let _e1687 = bitcast<f32>((bitcast<u32>(_e1615) & 2147483647u));
                                                                    let _e1690 = bitcast<f32>((bitcast<u32>(_e1616) & 2147483647u));
                                                                    let _e1692 = select(_e1690, _e1687, (_e1687 > _e1690));
                                                                    let _e1696 = select(_e1690, _e1687, (_e1687 < _e1690));
                                                                    let _e1700 = select(_e1687, _e1684, (_e1684 < _e1687));
                                                                    let _e1702 = select(_e1687, _e1684, (_e1684 > _e1687));
                                                                    let _e1704 = select(_e1690, _e1702, (_e1702 < _e1690));
                                                                    phi_2348_ = bitcast<f32>((bitcast<u32>((_e221.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1692, _e1684, (_e1684 > _e1692)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1704, _e1700, (_e1700 > _e1704)))) ^ _e221.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1696, _e1684, (_e1684 < _e1696)))) ^ _e221.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1640 + _e1647) + _e1654))) ^ _e221.member_3[0]))) * 1.0000005f)) ^ _e221.member_3[0])))) ^ _e221.member_3[0]));
                                                                }
                                                                let _e1731 = phi_2348_;
                                                                phi_2366_ = (_e1533 || !(((((bitcast<f32>((bitcast<u32>((_e1587.x * _e1614)) ^ _e221.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1587.y * _e1615)) ^ _e221.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1587.z * _e1616)) ^ _e221.member_3[0]))) * f32(-(_e1532))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1587.x) & 2147483647u)) * _e1640)) ^ _e221.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1587.y) & 2147483647u)) * _e1647)) ^ _e221.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1587.z) & 2147483647u)) * _e1654)) ^ _e221.member_3[0]))))) ^ _e221.member_3[0])) + _e1731) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1745 = phi_2366_;
                                                            phi_2367_ = _e1745;
                                                        }
                                                        let _e1747 = phi_2367_;
                                                        if _e1747 {
                                                            phi_2372_ = type_46(_e961.member, true);
                                                        } else {
                                                            phi_2372_ = _e961;
                                                        }
                                                        let _e1752 = phi_2372_;
                                                        phi_2373_ = _e1752;
                                                    } else {
                                                        phi_2373_ = _e961;
                                                    }
                                                    let _e1754 = phi_2373_;
                                                    phi_1060_ = _e1754;
                                                } else {
                                                    phi_1060_ = type_46();
                                                }
                                                let _e1756 = phi_1060_;
                                                continue;
                                                continuing {
                                                    phi_1059_ = _e1756;
                                                    phi_1062_ = _e976;
                                                    phi_3429_ = _e564;
                                                    break if !(_e982);
                                                }
                                            }
                                            let _e1759 = phi_3429_;
                                            phi_3595_ = _e1759;
                                            if _e1759 {
                                                break;
                                            }
                                            let _e1761 = local_10;
                                            phi_3599_ = _e1759;
                                            let _e1958 = local_12;
                                            phi_3323_ = _e1958;
                                            phi_3324_ = _e605;
                                            phi_3325_ = false;
                                            phi_3326_ = select(_e609, 0u, _e1761.member_1);
                                        } else {
                                            let _e618 = (_e605.member_1 < _e90);
                                            if _e618 {
                                                if _e618 {
                                                } else {
                                                    phi_3595_ = true;
                                                    break;
                                                }
                                                let _e620 = global_10.member[_e605.member_1];
                                                phi_2393_ = _e620;
                                            } else {
                                                phi_2393_ = type_55(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e622 = phi_2393_;
                                            let _e637 = ((10u * _e354) & 31u);
                                            let _e640 = ((_e622.member[0] >> bitcast<u32>(_e637)) & 1023u);
                                            let _e645 = bitcast<f32>((bitcast<u32>(((_e605.member.member_1[0] - _e605.member.member[0]) * 0.0009775171f)) ^ _e132));
                                            let _e651 = (_e605.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e640) * _e645)) ^ _e132)));
                                            let _e655 = select(select(_e605.member.member_1[0], _e651, (_e651 < _e605.member.member_1[0])), _e605.member.member_1[0], (_e640 == 1023u));
                                            let _e657 = ((10u * _e353) & 31u);
                                            let _e660 = ((_e622.member[0] >> bitcast<u32>(_e657)) & 1023u);
                                            let _e665 = bitcast<f32>((bitcast<u32>(((_e605.member.member_1[1] - _e605.member.member[1]) * 0.0009775171f)) ^ _e132));
                                            let _e671 = (_e605.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e660) * _e665)) ^ _e132)));
                                            let _e675 = select(select(_e605.member.member_1[1], _e671, (_e671 < _e605.member.member_1[1])), _e605.member.member_1[1], (_e660 == 1023u));
                                            let _e677 = ((10u * _e355) & 31u);
                                            let _e680 = ((_e622.member[0] >> bitcast<u32>(_e677)) & 1023u);
                                            let _e685 = bitcast<f32>((bitcast<u32>(((_e605.member.member_1[2] - _e605.member.member[2]) * 0.0009775171f)) ^ _e132));
                                            let _e691 = (_e605.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e680) * _e685)) ^ _e132)));
                                            let _e695 = select(select(_e605.member.member_1[2], _e691, (_e691 < _e605.member.member_1[2])), _e605.member.member_1[2], (_e680 == 1023u));
                                            let _e698 = ((_e622.member[1] >> bitcast<u32>(_e637)) & 1023u);
                                            let _e704 = (_e605.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e698) * _e645)) ^ _e132)));
                                            let _e708 = select(select(_e605.member.member_1[0], _e704, (_e704 < _e605.member.member_1[0])), _e605.member.member_1[0], (_e698 == 1023u));
                                            let _e711 = ((_e622.member[1] >> bitcast<u32>(_e657)) & 1023u);
                                            let _e717 = (_e605.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e711) * _e665)) ^ _e132)));
                                            let _e721 = select(select(_e605.member.member_1[1], _e717, (_e717 < _e605.member.member_1[1])), _e605.member.member_1[1], (_e711 == 1023u));
                                            let _e724 = ((_e622.member[1] >> bitcast<u32>(_e677)) & 1023u);
                                            let _e730 = (_e605.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e724) * _e685)) ^ _e132)));
                                            let _e734 = select(select(_e605.member.member_1[2], _e730, (_e730 < _e605.member.member_1[2])), _e605.member.member_1[2], (_e724 == 1023u));
                                            let _e740 = ((_e622.member_1[0] >> bitcast<u32>(_e637)) & 1023u);
                                            let _e746 = (_e605.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e740) * _e645)) ^ _e132)));
                                            let _e750 = select(select(_e605.member.member_1[0], _e746, (_e746 < _e605.member.member_1[0])), _e605.member.member_1[0], (_e740 == 1023u));
                                            let _e753 = ((_e622.member_1[0] >> bitcast<u32>(_e657)) & 1023u);
                                            let _e759 = (_e605.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e753) * _e665)) ^ _e132)));
                                            let _e763 = select(select(_e605.member.member_1[1], _e759, (_e759 < _e605.member.member_1[1])), _e605.member.member_1[1], (_e753 == 1023u));
                                            let _e766 = ((_e622.member_1[0] >> bitcast<u32>(_e677)) & 1023u);
                                            let _e772 = (_e605.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e766) * _e685)) ^ _e132)));
                                            let _e776 = select(select(_e605.member.member_1[2], _e772, (_e772 < _e605.member.member_1[2])), _e605.member.member_1[2], (_e766 == 1023u));
                                            let _e779 = ((_e622.member_1[1] >> bitcast<u32>(_e637)) & 1023u);
                                            let _e785 = (_e605.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e779) * _e645)) ^ _e132)));
                                            let _e789 = select(select(_e605.member.member_1[0], _e785, (_e785 < _e605.member.member_1[0])), _e605.member.member_1[0], (_e779 == 1023u));
                                            let _e792 = ((_e622.member_1[1] >> bitcast<u32>(_e657)) & 1023u);
                                            let _e798 = (_e605.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e792) * _e665)) ^ _e132)));
                                            let _e802 = select(select(_e605.member.member_1[1], _e798, (_e798 < _e605.member.member_1[1])), _e605.member.member_1[1], (_e792 == 1023u));
                                            let _e805 = ((_e622.member_1[1] >> bitcast<u32>(_e677)) & 1023u);
                                            let _e811 = (_e605.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e805) * _e685)) ^ _e132)));
                                            let _e815 = select(select(_e605.member.member_1[2], _e811, (_e811 < _e605.member.member_1[2])), _e605.member.member_1[2], (_e805 == 1023u));
                                            let _e820 = type_62(type_60(array<f32, 3>(_e655, _e675, _e695), array<f32, 3>(_e708, _e721, _e734)), _e622.member_2);
                                            let _e825 = type_62(type_60(array<f32, 3>(_e750, _e763, _e776), array<f32, 3>(_e789, _e802, _e815)), _e622.member_3);
                                            let _e831 = ((_e655 - _e409) * _e414);
                                            let _e832 = ((_e750 - _e409) * _e414);
                                            let _e833 = ((_e708 - _e410) * _e414);
                                            let _e834 = ((_e789 - _e410) * _e414);
                                            let _e839 = ((_e675 - _e445) * _e450);
                                            let _e840 = ((_e763 - _e445) * _e450);
                                            let _e841 = ((_e721 - _e446) * _e450);
                                            let _e842 = ((_e802 - _e446) * _e450);
                                            let _e847 = ((_e695 - _e481) * _e486);
                                            let _e848 = ((_e776 - _e481) * _e486);
                                            let _e849 = ((_e734 - _e482) * _e486);
                                            let _e850 = ((_e815 - _e482) * _e486);
                                            let _e852 = select(_e849, _e847, (_e847 < _e849));
                                            let _e854 = select(_e850, _e848, (_e848 < _e850));
                                            let _e856 = select(_e849, _e847, (_e847 > _e849));
                                            let _e858 = select(_e850, _e848, (_e848 > _e850));
                                            let _e860 = select(_e833, _e831, (_e831 < _e833));
                                            let _e862 = select(_e834, _e832, (_e832 < _e834));
                                            let _e864 = select(_e841, _e839, (_e839 < _e841));
                                            let _e866 = select(_e842, _e840, (_e840 < _e842));
                                            let _e868 = select(_e864, _e860, (_e860 > _e864));
                                            let _e870 = select(_e866, _e862, (_e862 > _e866));
                                            let _e872 = select(_e852, _e868, (_e868 > _e852));
                                            let _e874 = select(_e854, _e870, (_e870 > _e854));
                                            let _e876 = select(_e833, _e831, (_e831 > _e833));
                                            let _e878 = select(_e834, _e832, (_e832 > _e834));
                                            let _e880 = select(_e841, _e839, (_e839 > _e841));
                                            let _e882 = select(_e842, _e840, (_e840 > _e842));
                                            let _e884 = select(_e880, _e876, (_e876 < _e880));
                                            let _e886 = select(_e882, _e878, (_e878 < _e882));
                                            let _e891 = -(_e852);
                                            let _e892 = -(_e854);
                                            let _e899 = (select(_e856, _e884, (_e884 < _e856)) + (select(_e891, _e856, (_e856 > _e891)) * 0.0000019073523f));
                                            let _e900 = (select(_e858, _e886, (_e886 < _e858)) + (select(_e892, _e858, (_e858 > _e892)) * 0.0000019073523f));
                                            let _e902 = select(_e532, _e872, (_e872 > _e532));
                                            let _e904 = select(_e532, _e874, (_e874 > _e532));
                                            let _e909 = (_e902 <= select(_e566.member, _e899, (_e899 < _e566.member)));
                                            let _e910 = (_e904 <= select(_e566.member, _e900, (_e900 < _e566.member)));
                                            let _e911 = (_e902 <= _e904);
                                            if _e909 {
                                                if _e910 {
                                                    if _e911 {
                                                        phi_3225_ = _e825;
                                                    } else {
                                                        phi_3225_ = _e820;
                                                    }
                                                    let _e913 = phi_3225_;
                                                    let _e921 = (_e609 % 128u);
                                                    let _e922 = (_e921 < 128u);
                                                    if _e922 {
                                                    } else {
                                                        phi_3595_ = true;
                                                        break;
                                                    }
                                                    local_6[_e921] = _e913.member_1;
                                                    if _e922 {
                                                    } else {
                                                        phi_3595_ = true;
                                                        break;
                                                    }
                                                    local_5[_e921] = _e913.member.member[0];
                                                    if _e922 {
                                                    } else {
                                                        phi_3595_ = true;
                                                        break;
                                                    }
                                                    local_4[_e921] = _e913.member.member[1];
                                                    if _e922 {
                                                    } else {
                                                        phi_3595_ = true;
                                                        break;
                                                    }
                                                    local_3[_e921] = _e913.member.member[2];
                                                    if _e922 {
                                                    } else {
                                                        phi_3595_ = true;
                                                        break;
                                                    }
                                                    local_2[_e921] = _e913.member.member_1[0];
                                                    if _e922 {
                                                    } else {
                                                        phi_3595_ = true;
                                                        break;
                                                    }
                                                    local_1[_e921] = _e913.member.member_1[1];
                                                    if _e922 {
                                                    } else {
                                                        phi_3595_ = true;
                                                        break;
                                                    }
                                                    local[_e921] = _e913.member.member_1[2];
                                                    if _e922 {
                                                    } else {
                                                        phi_3595_ = true;
                                                        break;
                                                    }
                                                    local_7[_e921] = select(_e904, _e902, (_e902 > _e904));
                                                    if _e911 {
                                                        phi_3302_ = _e820;
                                                    } else {
                                                        phi_3302_ = _e825;
                                                    }
                                                    let _e939 = phi_3302_;
                                                    phi_3303_ = _e939;
                                                    phi_3304_ = (_e609 + 1u);
                                                } else {
                                                    phi_3303_ = type_62();
                                                    phi_3304_ = u32();
                                                }
                                                let _e941 = phi_3303_;
                                                let _e943 = phi_3304_;
                                                phi_3306_ = _e941;
                                                phi_3307_ = _e943;
                                                phi_3308_ = select(true, false, _e910);
                                            } else {
                                                phi_3306_ = type_62();
                                                phi_3307_ = u32();
                                                phi_3308_ = true;
                                            }
                                            let _e946 = phi_3306_;
                                            let _e948 = phi_3307_;
                                            let _e950 = phi_3308_;
                                            if _e950 {
                                                if _e909 {
                                                    phi_3315_ = _e820;
                                                } else {
                                                    phi_3315_ = _e825;
                                                }
                                                let _e952 = phi_3315_;
                                                phi_3320_ = _e952;
                                                phi_3321_ = select(_e910, true, _e909);
                                            } else {
                                                phi_3320_ = _e946;
                                                phi_3321_ = _e607;
                                            }
                                            let _e955 = phi_3320_;
                                            let _e957 = phi_3321_;
                                            phi_3599_ = _e564;
                                            phi_3323_ = _e566;
                                            phi_3324_ = _e955;
                                            phi_3325_ = _e957;
                                            phi_3326_ = select(_e948, _e609, _e950);
                                        }
                                        let _e1765 = phi_3599_;
                                        let _e1767 = phi_3323_;
                                        let _e1769 = phi_3324_;
                                        let _e1771 = phi_3325_;
                                        let _e1773 = phi_3326_;
                                        phi_3598_ = _e1765;
                                        phi_3327_ = _e1767;
                                        phi_3328_ = _e1769;
                                        phi_3329_ = (_e570 - 1u);
                                        phi_3330_ = _e1771;
                                        phi_3331_ = _e1773;
                                    } else {
                                        phi_3598_ = _e564;
                                        phi_3327_ = _e566;
                                        phi_3328_ = _e605;
                                        phi_3329_ = _e570;
                                        phi_3330_ = _e607;
                                        phi_3331_ = _e609;
                                    }
                                    let _e1775 = phi_3598_;
                                    let _e1777 = phi_3327_;
                                    let _e1779 = phi_3328_;
                                    let _e1781 = phi_3329_;
                                    let _e1783 = phi_3330_;
                                    let _e1785 = phi_3331_;
                                    phi_3597_ = _e1775;
                                    phi_3332_ = _e1777;
                                    phi_3333_ = _e1779;
                                    phi_3334_ = _e1781;
                                    phi_3335_ = _e1783;
                                    phi_3336_ = _e1785;
                                } else {
                                    phi_3597_ = _e564;
                                    phi_3332_ = type_46();
                                    phi_3333_ = type_62();
                                    phi_3334_ = u32();
                                    phi_3335_ = bool();
                                    phi_3336_ = u32();
                                }
                                let _e1787 = phi_3597_;
                                let _e1789 = phi_3332_;
                                let _e1791 = phi_3333_;
                                let _e1793 = phi_3334_;
                                let _e1795 = phi_3335_;
                                let _e1797 = phi_3336_;
                                phi_3596_ = _e1787;
                                phi_934_ = _e1789;
                                phi_937_ = _e1791;
                                phi_939_ = _e1793;
                                phi_941_ = _e1795;
                                phi_943_ = _e1797;
                                phi_3337_ = _e578;
                            } else {
                                phi_3596_ = _e564;
                                phi_934_ = type_46();
                                phi_937_ = type_62();
                                phi_939_ = u32();
                                phi_941_ = bool();
                                phi_943_ = u32();
                                phi_3337_ = false;
                            }
                            let _e1799 = phi_3596_;
                            let _e1801 = phi_934_;
                            let _e1803 = phi_937_;
                            let _e1805 = phi_939_;
                            let _e1807 = phi_941_;
                            let _e1809 = phi_943_;
                            let _e1811 = phi_3337_;
                            continue;
                            continuing {
                                phi_3435_ = _e1799;
                                phi_933_ = _e1801;
                                phi_936_ = _e1803;
                                phi_938_ = _e1805;
                                phi_940_ = _e1807;
                                phi_942_ = _e1809;
                                phi_3595_ = _e1799;
                                break if !(_e1811);
                            }
                        }
                        let _e1814 = phi_3595_;
                        if _e1814 {
                            break;
                        }
                        let _e1816 = local_11;
                        if _e1816.member_1 {
                        } else {
                            if _e222 {
                            } else {
                                break;
                            }
                            let _e1820 = global_2.member[_e136];
                            if _e143 {
                            } else {
                                break;
                            }
                            let _e1824 = global_9.member[_e136].member_1;
                            if _e222 {
                            } else {
                                break;
                            }
                            global_2.member[_e136] = type_29(_e1820.member, _e1820.member_1, _e1820.member_2, array<f32, 3>((_e1820.member_3[0] + (_e1824[0] * _e1820.member_1[0])), (_e1820.member_3[1] + (_e1824[1] * _e1820.member_1[1])), (_e1820.member_3[2] + (_e1824[2] * _e1820.member_1[2]))), _e1820.member_4);
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
