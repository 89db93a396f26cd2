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
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_23 {
    member: i32,
    member_1: i32,
}

struct type_24 {
    member: type_18,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_20;
@group(0) @binding(1) 
var<storage> global_3: type_4;
@group(0) @binding(2) 
var<storage> global_4: type_4;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;

fn function_() {
    var phi_115_: u32;
    var phi_136_: u32;
    var phi_153_: u32;
    var phi_201_: u32;
    var phi_215_: u32;
    var phi_223_: u32;
    var phi_230_: i32;
    var phi_250_: u32;
    var phi_264_: u32;
    var phi_272_: u32;
    var phi_279_: i32;
    var phi_286_: type_23;
    var phi_292_: type_8;
    var phi_295_: i32;
    var phi_293_: type_8;
    var phi_318_: type_8;
    var phi_346_: u32;
    var phi_360_: u32;
    var phi_368_: u32;
    var phi_375_: i32;
    var phi_381_: i32;
    var phi_296_: i32;
    var phi_383_: bool;
    var phi_804_: bool;
    var local: i32;
    var phi_393_: type_8;
    var phi_396_: i32;
    var phi_398_: i32;
    var phi_394_: type_8;
    var phi_421_: type_8;
    var phi_453_: u32;
    var phi_467_: u32;
    var phi_475_: u32;
    var phi_482_: i32;
    var phi_496_: i32;
    var phi_497_: i32;
    var phi_397_: i32;
    var phi_399_: i32;
    var phi_499_: bool;
    var phi_825_: bool;
    var local_1: i32;
    var phi_520_: u32;
    var phi_534_: u32;
    var phi_542_: u32;
    var phi_549_: i32;
    var phi_552_: type_8;
    var phi_555_: i32;
    var phi_557_: i32;
    var phi_553_: type_8;
    var phi_580_: type_8;
    var phi_616_: u32;
    var phi_630_: u32;
    var phi_638_: u32;
    var phi_645_: i32;
    var phi_657_: i32;
    var phi_556_: i32;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_835_: bool;
    var phi_803_: bool;
    var phi_801_: i32;
    var local_2: i32;
    var phi_697_: u32;
    var phi_714_: u32;
    var phi_720_: u32;
    var phi_739_: u32;
    var phi_756_: u32;
    var phi_763_: u32;
    var phi_180_: u32;
    var phi_767_: type_24;
    var local_3: i32;
    var local_4: i32;

    switch bitcast<i32>(0u) {
        default: {
            let _e39 = global;
            let _e42 = arrayLength((&global_3.member));
            let _e44 = arrayLength((&global_4.member));
            let _e46 = arrayLength((&global_5.member));
            let _e54 = (_e39.x + (_e39.y * 2097152u));
            let _e57 = global_1.member[0u];
            let _e59 = (_e54 >> bitcast<u32>(5i));
            let _e60 = (_e59 < _e44);
            if _e60 {
                if _e60 {
                } else {
                    break;
                }
                let _e63 = global_4.member[_e59];
                phi_115_ = _e63;
            } else {
                phi_115_ = 0u;
            }
            let _e65 = phi_115_;
            let _e67 = ((_e54 & 31u) & 31u);
            if (((_e65 >> bitcast<u32>(_e67)) & 1u) == 1u) {
                if _e60 {
                    if _e60 {
                    } else {
                        break;
                    }
                    let _e74 = global_4.member[_e59];
                    phi_136_ = _e74;
                } else {
                    phi_136_ = 0u;
                }
                let _e76 = phi_136_;
                let _e81 = (_e59 < _e46);
                if _e81 {
                    if _e81 {
                    } else {
                        break;
                    }
                    let _e84 = global_5.member[_e59];
                    phi_153_ = _e84;
                } else {
                    phi_153_ = 0u;
                }
                let _e86 = phi_153_;
                let _e88 = (_e86 + countOneBits((_e76 & ~((4294967295u << bitcast<u32>(_e67))))));
                if (_e57 <= 4u) {
                    let _e475 = (2147483648u | (_e57 << bitcast<u32>(28u)));
                    if ((_e475 & 2147483648u) != 0u) {
                        phi_180_ = (((_e475 & 268435455u) + ((_e475 >> bitcast<u32>(28u)) & 7u)) - 1u);
                    } else {
                        phi_180_ = 0u;
                    }
                    let _e489 = phi_180_;
                    phi_767_ = type_24(type_18(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), _e475, 2147483648u, 0u, (_e57 - select(0u, 1u, (_e57 > 0u)))), _e489);
                } else {
                    let _e90 = (_e54 + 1u);
                    if (_e90 < _e57) {
                        let _e92 = (_e54 < _e42);
                        if _e92 {
                            if _e92 {
                            } else {
                                break;
                            }
                            let _e94 = global_3.member[_e54];
                            phi_201_ = _e94;
                        } else {
                            phi_201_ = 0u;
                        }
                        let _e96 = phi_201_;
                        let _e97 = (_e90 < _e42);
                        if _e97 {
                            if _e97 {
                            } else {
                                break;
                            }
                            let _e99 = global_3.member[_e90];
                            phi_215_ = _e99;
                        } else {
                            phi_215_ = 0u;
                        }
                        let _e101 = phi_215_;
                        let _e102 = (_e96 ^ _e101);
                        let _e103 = (_e102 == 0u);
                        if _e103 {
                            phi_223_ = (_e54 ^ _e90);
                        } else {
                            phi_223_ = _e102;
                        }
                        let _e106 = phi_223_;
                        phi_230_ = (select(0i, 32i, _e103) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e106)), 32u, (_e106 == 0u))));
                    } else {
                        phi_230_ = -1i;
                    }
                    let _e116 = phi_230_;
                    let _e117 = (_e54 + 4294967295u);
                    if (_e117 < _e57) {
                        let _e119 = (_e54 < _e42);
                        if _e119 {
                            if _e119 {
                            } else {
                                break;
                            }
                            let _e121 = global_3.member[_e54];
                            phi_250_ = _e121;
                        } else {
                            phi_250_ = 0u;
                        }
                        let _e123 = phi_250_;
                        let _e124 = (_e117 < _e42);
                        if _e124 {
                            if _e124 {
                            } else {
                                break;
                            }
                            let _e126 = global_3.member[_e117];
                            phi_264_ = _e126;
                        } else {
                            phi_264_ = 0u;
                        }
                        let _e128 = phi_264_;
                        let _e129 = (_e123 ^ _e128);
                        let _e130 = (_e129 == 0u);
                        if _e130 {
                            phi_272_ = (_e54 ^ _e117);
                        } else {
                            phi_272_ = _e129;
                        }
                        let _e133 = phi_272_;
                        phi_279_ = (select(0i, 32i, _e130) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e133)), 32u, (_e133 == 0u))));
                    } else {
                        phi_279_ = -1i;
                    }
                    let _e143 = phi_279_;
                    if (_e116 > _e143) {
                        phi_286_ = type_23(1i, _e143);
                    } else {
                        phi_286_ = type_23(-1i, _e116);
                    }
                    let _e148 = phi_286_;
                    phi_292_ = type_8(0u, 31u);
                    phi_295_ = 4i;
                    loop {
                        let _e152 = phi_292_;
                        let _e154 = phi_295_;
                        local = _e154;
                        local_3 = _e154;
                        if (_e152.member < _e152.member_1) {
                            phi_293_ = type_8((_e152.member + 1u), _e152.member_1);
                            phi_318_ = type_8(1u, _e152.member);
                        } else {
                            phi_293_ = _e152;
                            phi_318_ = type_8(0u, type_8().member_1);
                        }
                        let _e167 = phi_293_;
                        let _e169 = phi_318_;
                        if (bitcast<i32>(_e169.member) != 0i) {
                            let _e176 = (_e54 + bitcast<u32>(((2i * _e154) * _e148.member)));
                            if (_e176 < _e57) {
                                let _e178 = (_e54 < _e42);
                                if _e178 {
                                    if _e178 {
                                    } else {
                                        phi_804_ = true;
                                        break;
                                    }
                                    let _e180 = global_3.member[_e54];
                                    phi_346_ = _e180;
                                } else {
                                    phi_346_ = 0u;
                                }
                                let _e182 = phi_346_;
                                let _e183 = (_e176 < _e42);
                                if _e183 {
                                    if _e183 {
                                    } else {
                                        phi_804_ = true;
                                        break;
                                    }
                                    let _e185 = global_3.member[_e176];
                                    phi_360_ = _e185;
                                } else {
                                    phi_360_ = 0u;
                                }
                                let _e187 = phi_360_;
                                let _e188 = (_e182 ^ _e187);
                                let _e189 = (_e188 == 0u);
                                if _e189 {
                                    phi_368_ = (_e54 ^ _e176);
                                } else {
                                    phi_368_ = _e188;
                                }
                                let _e192 = phi_368_;
                                phi_375_ = (select(0i, 32i, _e189) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e192)), 32u, (_e192 == 0u))));
                            } else {
                                phi_375_ = -1i;
                            }
                            let _e202 = phi_375_;
                            let _e203 = (_e202 <= _e148.member_1);
                            if _e203 {
                                phi_381_ = i32();
                            } else {
                                phi_381_ = (_e154 * 2i);
                            }
                            let _e206 = phi_381_;
                            phi_296_ = _e206;
                            phi_383_ = select(true, false, _e203);
                        } else {
                            phi_296_ = i32();
                            phi_383_ = false;
                        }
                        let _e209 = phi_296_;
                        let _e211 = phi_383_;
                        continue;
                        continuing {
                            phi_292_ = _e167;
                            phi_295_ = _e209;
                            phi_804_ = false;
                            break if !(_e211);
                        }
                    }
                    let _e214 = phi_804_;
                    if _e214 {
                        break;
                    }
                    let _e216 = local;
                    phi_393_ = type_8(0u, 31u);
                    phi_396_ = (_e216 / 2i);
                    let _e530 = local_3;
                    phi_398_ = _e530;
                    loop {
                        let _e219 = phi_393_;
                        let _e221 = phi_396_;
                        let _e223 = phi_398_;
                        local_1 = _e223;
                        local_4 = _e223;
                        if (_e219.member < _e219.member_1) {
                            phi_394_ = type_8((_e219.member + 1u), _e219.member_1);
                            phi_421_ = type_8(1u, _e219.member);
                        } else {
                            phi_394_ = _e219;
                            phi_421_ = type_8(0u, type_8().member_1);
                        }
                        let _e236 = phi_394_;
                        let _e238 = phi_421_;
                        if (bitcast<i32>(_e238.member) != 0i) {
                            let _e242 = (_e221 == 0i);
                            if _e242 {
                                phi_496_ = i32();
                                phi_497_ = i32();
                            } else {
                                let _e243 = (_e223 + _e221);
                                let _e246 = (_e54 + bitcast<u32>((_e243 * _e148.member)));
                                if (_e246 < _e57) {
                                    let _e248 = (_e54 < _e42);
                                    if _e248 {
                                        if _e248 {
                                        } else {
                                            phi_825_ = true;
                                            break;
                                        }
                                        let _e250 = global_3.member[_e54];
                                        phi_453_ = _e250;
                                    } else {
                                        phi_453_ = 0u;
                                    }
                                    let _e252 = phi_453_;
                                    let _e253 = (_e246 < _e42);
                                    if _e253 {
                                        if _e253 {
                                        } else {
                                            phi_825_ = true;
                                            break;
                                        }
                                        let _e255 = global_3.member[_e246];
                                        phi_467_ = _e255;
                                    } else {
                                        phi_467_ = 0u;
                                    }
                                    let _e257 = phi_467_;
                                    let _e258 = (_e252 ^ _e257);
                                    let _e259 = (_e258 == 0u);
                                    if _e259 {
                                        phi_475_ = (_e54 ^ _e246);
                                    } else {
                                        phi_475_ = _e258;
                                    }
                                    let _e262 = phi_475_;
                                    phi_482_ = (select(0i, 32i, _e259) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e262)), 32u, (_e262 == 0u))));
                                } else {
                                    phi_482_ = -1i;
                                }
                                let _e272 = phi_482_;
                                phi_496_ = (_e221 / 2i);
                                phi_497_ = select(_e223, _e243, (_e272 > _e148.member_1));
                            }
                            let _e277 = phi_496_;
                            let _e279 = phi_497_;
                            phi_397_ = _e277;
                            phi_399_ = _e279;
                            phi_499_ = select(true, false, _e242);
                        } else {
                            phi_397_ = i32();
                            phi_399_ = i32();
                            phi_499_ = false;
                        }
                        let _e282 = phi_397_;
                        let _e284 = phi_399_;
                        let _e286 = phi_499_;
                        continue;
                        continuing {
                            phi_393_ = _e236;
                            phi_396_ = _e282;
                            phi_398_ = _e284;
                            phi_825_ = _e214;
                            break if !(_e286);
                        }
                    }
                    let _e289 = phi_825_;
                    if _e289 {
                        break;
                    }
                    let _e291 = local_1;
                    let _e294 = (_e54 + bitcast<u32>((_e291 * _e148.member)));
                    if (_e294 < _e57) {
                        let _e296 = (_e54 < _e42);
                        if _e296 {
                            if _e296 {
                            } else {
                                break;
                            }
                            let _e298 = global_3.member[_e54];
                            phi_520_ = _e298;
                        } else {
                            phi_520_ = 0u;
                        }
                        let _e300 = phi_520_;
                        let _e301 = (_e294 < _e42);
                        if _e301 {
                            if _e301 {
                            } else {
                                break;
                            }
                            let _e303 = global_3.member[_e294];
                            phi_534_ = _e303;
                        } else {
                            phi_534_ = 0u;
                        }
                        let _e305 = phi_534_;
                        let _e306 = (_e300 ^ _e305);
                        let _e307 = (_e306 == 0u);
                        if _e307 {
                            phi_542_ = (_e54 ^ _e294);
                        } else {
                            phi_542_ = _e306;
                        }
                        let _e310 = phi_542_;
                        phi_549_ = (select(0i, 32i, _e307) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e310)), 32u, (_e310 == 0u))));
                    } else {
                        phi_549_ = -1i;
                    }
                    let _e320 = phi_549_;
                    phi_552_ = type_8(0u, 32u);
                    let _e551 = local_4;
                    phi_555_ = _e551;
                    phi_557_ = 0i;
                    loop {
                        let _e322 = phi_552_;
                        let _e324 = phi_555_;
                        let _e326 = phi_557_;
                        local_2 = _e326;
                        if (_e322.member < _e322.member_1) {
                            phi_553_ = type_8((_e322.member + 1u), _e322.member_1);
                            phi_580_ = type_8(1u, _e322.member);
                        } else {
                            phi_553_ = _e322;
                            phi_580_ = type_8(0u, type_8().member_1);
                        }
                        let _e339 = phi_553_;
                        let _e341 = phi_580_;
                        if (bitcast<i32>(_e341.member) != 0i) {
                            let _e346 = ((_e324 + 1i) / 2i);
                            let _e347 = (_e326 + _e346);
                            let _e350 = (_e54 + bitcast<u32>((_e347 * _e148.member)));
                            if (_e350 < _e57) {
                                let _e352 = (_e54 < _e42);
                                if _e352 {
                                    if _e352 {
                                    } else {
                                        phi_835_ = true;
                                        phi_803_ = bool();
                                        phi_801_ = i32();
                                        break;
                                    }
                                    let _e354 = global_3.member[_e54];
                                    phi_616_ = _e354;
                                } else {
                                    phi_616_ = 0u;
                                }
                                let _e356 = phi_616_;
                                let _e357 = (_e350 < _e42);
                                if _e357 {
                                    if _e357 {
                                    } else {
                                        phi_835_ = true;
                                        phi_803_ = bool();
                                        phi_801_ = i32();
                                        break;
                                    }
                                    let _e359 = global_3.member[_e350];
                                    phi_630_ = _e359;
                                } else {
                                    phi_630_ = 0u;
                                }
                                let _e361 = phi_630_;
                                let _e362 = (_e356 ^ _e361);
                                let _e363 = (_e362 == 0u);
                                if _e363 {
                                    phi_638_ = (_e54 ^ _e350);
                                } else {
                                    phi_638_ = _e362;
                                }
                                let _e366 = phi_638_;
                                phi_645_ = (select(0i, 32i, _e363) + bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e366)), 32u, (_e366 == 0u))));
                            } else {
                                phi_645_ = -1i;
                            }
                            let _e376 = phi_645_;
                            let _e379 = (_e346 <= 1i);
                            phi_657_ = select(_e326, _e347, (_e376 > _e320));
                            phi_556_ = _e346;
                            phi_658_ = select(true, false, _e379);
                            phi_659_ = _e379;
                        } else {
                            phi_657_ = i32();
                            phi_556_ = i32();
                            phi_658_ = false;
                            phi_659_ = false;
                        }
                        let _e382 = phi_657_;
                        let _e384 = phi_556_;
                        let _e386 = phi_658_;
                        let _e388 = phi_659_;
                        continue;
                        continuing {
                            phi_552_ = _e339;
                            phi_555_ = _e384;
                            phi_557_ = _e382;
                            phi_835_ = _e289;
                            phi_803_ = _e388;
                            phi_801_ = _e382;
                            break if !(_e386);
                        }
                    }
                    let _e391 = phi_835_;
                    let _e393 = phi_803_;
                    let _e395 = phi_801_;
                    if _e391 {
                        break;
                    }
                    let _e397 = local_2;
                    let _e399 = (_e148.member > 0i);
                    let _e400 = select(_e294, _e54, _e399);
                    let _e401 = select(_e54, _e294, _e399);
                    let _e407 = ((_e54 + bitcast<u32>((select(_e397, _e395, _e393) * _e148.member))) - select(0u, 1u, (_e148.member < 0i)));
                    let _e409 = ((_e407 - _e400) + 1u);
                    if (_e409 > 4u) {
                        let _e416 = (_e407 >> bitcast<u32>(5i));
                        let _e417 = (_e416 < _e44);
                        if _e417 {
                            if _e417 {
                            } else {
                                break;
                            }
                            let _e420 = global_4.member[_e416];
                            phi_697_ = _e420;
                        } else {
                            phi_697_ = 0u;
                        }
                        let _e422 = phi_697_;
                        let _e429 = (_e416 < _e46);
                        if _e429 {
                            if _e429 {
                            } else {
                                break;
                            }
                            let _e432 = global_5.member[_e416];
                            phi_714_ = _e432;
                        } else {
                            phi_714_ = 0u;
                        }
                        let _e434 = phi_714_;
                        phi_720_ = (_e434 + countOneBits((_e422 & ~((4294967295u << bitcast<u32>(((_e407 & 31u) & 31u)))))));
                    } else {
                        phi_720_ = ((2147483648u | (_e409 << bitcast<u32>(28u))) | _e400);
                    }
                    let _e438 = phi_720_;
                    let _e439 = (_e401 - _e407);
                    if (_e439 > 4u) {
                        let _e446 = (_e407 + 1u);
                        let _e448 = (_e446 >> bitcast<u32>(5i));
                        let _e449 = (_e448 < _e44);
                        if _e449 {
                            if _e449 {
                            } else {
                                break;
                            }
                            let _e452 = global_4.member[_e448];
                            phi_739_ = _e452;
                        } else {
                            phi_739_ = 0u;
                        }
                        let _e454 = phi_739_;
                        let _e461 = (_e448 < _e46);
                        if _e461 {
                            if _e461 {
                            } else {
                                break;
                            }
                            let _e464 = global_5.member[_e448];
                            phi_756_ = _e464;
                        } else {
                            phi_756_ = 0u;
                        }
                        let _e466 = phi_756_;
                        phi_763_ = (_e466 + countOneBits((_e454 & ~((4294967295u << bitcast<u32>(((_e446 & 31u) & 31u)))))));
                    } else {
                        phi_763_ = ((2147483648u | (_e439 << bitcast<u32>(28u))) | (_e407 + 1u));
                    }
                    let _e470 = phi_763_;
                    phi_767_ = type_24(type_18(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), _e438, _e470, _e400, _e401), _e407);
                }
                let _e492 = phi_767_;
                let _e495 = (_e88 < arrayLength((&global_2.member)));
                if _e495 {
                    let _e496 = (_e88 < arrayLength((&global_6.member)));
                    if _e496 {
                        if _e495 {
                        } else {
                            break;
                        }
                        global_2.member[_e88] = _e492.member;
                        if _e496 {
                        } else {
                            break;
                        }
                        global_6.member[_e88] = _e492.member_1;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn topology_nodes_30_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
