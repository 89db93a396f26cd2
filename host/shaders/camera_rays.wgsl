struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_14 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_15 {
    member: type_14,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
    member_8: array<f32, 3>,
    member_9: f32,
    member_10: array<f32, 3>,
    member_11: f32,
}

struct type_24 {
    member: array<type_22>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_8;
@group(0) @binding(3) 
var<storage, read_write> global_3: type_17;
@group(0) @binding(2) 
var<storage> global_4: type_24;

fn function_() {
    var phi_169_: i32;
    var phi_231_: type_22;
    var phi_269_: u32;
    var phi_272_: type_4;
    var phi_273_: type_4;
    var phi_295_: type_4;
    var phi_308_: u32;
    var phi_270_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_343_: array<f32, 2>;
    var phi_477_: type_4;
    var phi_480_: u32;
    var phi_482_: u32;
    var phi_478_: type_4;
    var phi_505_: type_4;
    var phi_521_: u32;
    var phi_481_: u32;
    var phi_483_: u32;
    var local_6: u32;
    var phi_551_: i32;
    var phi_558_: i32;
    var phi_875_: f32;
    var phi_888_: f32;
    var phi_832_: type_14;
    var phi_833_: type_14;

    switch bitcast<i32>(0u) {
        default: {
            let _e59 = global;
            let _e61 = arrayLength((&global_4.member));
            let _e67 = (_e59.x + (_e59.y * 2097152u));
            let _e68 = (_e67 < arrayLength((&global_3.member)));
            if _e68 {
                if (_e61 == 0u) {
                } else {
                    if (0u < _e61) {
                    } else {
                        break;
                    }
                    let _e73 = global_1.member[0u];
                    let _e74 = bitcast<i32>(_e73);
                    if (_e74 < -126i) {
                        phi_169_ = -126i;
                    } else {
                        phi_169_ = select(_e74, 127i, (_e74 > 127i));
                    }
                    let _e79 = phi_169_;
                    let _e84 = bitcast<f32>((bitcast<u32>((_e79 + 127i)) << bitcast<u32>(23i)));
                    let _e90 = bitcast<f32>((bitcast<u32>(((_e74 - _e79) + 127i)) << bitcast<u32>(23i)));
                    let _e93 = global_4.member[0u];
                    let _e97 = global_4.member[0u].member;
                    let _e120 = type_22(array<f32, 3>(((_e97[0] * _e84) * _e90), ((_e97[1] * _e84) * _e90), ((_e97[2] * _e84) * _e90)), _e93.member_1, _e93.member_2, _e93.member_3, _e93.member_4, _e93.member_5, _e93.member_6, _e93.member_7, _e93.member_8, _e93.member_9, _e93.member_10, _e93.member_11);
                    let _e124 = global_4.member[0u].member_9;
                    let _e139 = type_22(_e120.member, _e120.member_1, _e120.member_2, _e120.member_3, _e120.member_4, _e120.member_5, _e120.member_6, _e120.member_7, _e120.member_8, ((_e124 * _e84) * _e90), _e120.member_10, _e120.member_11);
                    let _e143 = global_4.member[0u].member_1;
                    if (_e143 == 1u) {
                        let _e148 = global_4.member[0u].member_4;
                        let _e171 = type_22(_e139.member, _e139.member_1, _e139.member_2, _e139.member_3, array<f32, 3>(((_e148[0] * _e84) * _e90), ((_e148[1] * _e84) * _e90), ((_e148[2] * _e84) * _e90)), _e139.member_5, _e139.member_6, _e139.member_7, _e139.member_8, _e139.member_9, _e139.member_10, _e139.member_11);
                        let _e175 = global_4.member[0u].member_6;
                        phi_231_ = type_22(_e171.member, _e171.member_1, _e171.member_2, _e171.member_3, _e171.member_4, _e171.member_5, array<f32, 3>(((_e175[0] * _e84) * _e90), ((_e175[1] * _e84) * _e90), ((_e175[2] * _e84) * _e90)), _e171.member_7, _e171.member_8, _e171.member_9, _e171.member_10, _e171.member_11);
                    } else {
                        phi_231_ = _e139;
                    }
                    let _e200 = phi_231_;
                    let _e203 = global_2.member[0u];
                    let _e204 = (_e203 + _e67);
                    let _e207 = select(1u, _e200.member_7, (1u < _e200.member_7));
                    let _e210 = select(1u, _e200.member_3, (1u < _e200.member_3));
                    let _e211 = (_e207 == 0u);
                    if _e211 {
                        break;
                    }
                    let _e212 = (_e204 / _e207);
                    let _e213 = (_e210 == 0u);
                    if _e213 {
                        break;
                    }
                    if _e213 {
                        break;
                    }
                    if _e211 {
                        break;
                    }
                    let _e216 = (_e204 % _e207);
                    phi_269_ = 1u;
                    phi_272_ = type_4(0u, 16u);
                    loop {
                        let _e218 = phi_269_;
                        let _e220 = phi_272_;
                        local = _e218;
                        local_1 = _e218;
                        local_2 = _e218;
                        local_3 = _e218;
                        local_4 = _e218;
                        local_5 = _e218;
                        if (_e220.member < _e220.member_1) {
                            phi_273_ = type_4((_e220.member + 1u), _e220.member_1);
                            phi_295_ = type_4(1u, _e220.member);
                        } else {
                            phi_273_ = _e220;
                            phi_295_ = type_4(0u, type_4().member_1);
                        }
                        let _e233 = phi_273_;
                        let _e235 = phi_295_;
                        let _e238 = (bitcast<i32>(_e235.member) != 0i);
                        if _e238 {
                            if ((_e218 * _e218) < _e207) {
                                phi_308_ = (_e218 + 1u);
                            } else {
                                phi_308_ = _e218;
                            }
                            let _e243 = phi_308_;
                            phi_270_ = _e243;
                        } else {
                            phi_270_ = u32();
                        }
                        let _e245 = phi_270_;
                        continue;
                        continuing {
                            phi_269_ = _e245;
                            phi_272_ = _e233;
                            break if !(_e238);
                        }
                    }
                    let _e248 = local;
                    let _e250 = local_1;
                    if ((_e248 * _e250) == _e207) {
                        let _e265 = local_2;
                        let _e266 = (_e265 == 0u);
                        if _e266 {
                            break;
                        }
                        let _e268 = local_3;
                        let _e273 = local_4;
                        let _e274 = f32(_e273);
                        if _e266 {
                            break;
                        }
                        let _e277 = local_5;
                        phi_343_ = array<f32, 2>(((f32((_e216 % _e268)) + 0.5f) / _e274), ((f32((_e216 / _e277)) + 0.5f) / _e274));
                    } else {
                        phi_343_ = array<f32, 2>(((f32(_e216) + 0.5f) / f32(_e207)), (f32((((_e216 * 2654435769u) + 1327217884u) >> bitcast<u32>(8i))) * 0.000000059604645f));
                    }
                    let _e284 = phi_343_;
                    let _e292 = ((((f32((_e212 % _e210)) + _e284[0]) / f32(_e200.member_3)) * 2f) - 1f);
                    let _e299 = (1f - (((f32((_e212 / _e210)) + _e284[1]) / f32(_e200.member_5)) * 2f));
                    let _e314 = ((_e200.member_4[0] * _e292) + (_e200.member_6[0] * _e299));
                    let _e315 = ((_e200.member_4[1] * _e292) + (_e200.member_6[1] * _e299));
                    let _e316 = ((_e200.member_4[2] * _e292) + (_e200.member_6[2] * _e299));
                    if (_e200.member_1 == 1u) {
                        phi_833_ = type_14(array<f32, 3>((_e200.member[0] + _e314), (_e200.member[1] + _e315), (_e200.member[2] + _e316)), 0f, _e200.member_2, 340282350000000000000000000000000000000f);
                    } else {
                        if (_e200.member_9 > 0f) {
                            if _e211 {
                                break;
                            }
                            if _e211 {
                                break;
                            }
                            let _e337 = ((_e212 ^ (_e212 >> bitcast<u32>(16i))) * 569420461u);
                            let _e341 = ((_e337 ^ (_e337 >> bitcast<u32>(15i))) * 3545902487u);
                            let _e344 = (_e341 ^ (_e341 >> bitcast<u32>(15i)));
                            let _e348 = ((_e344 ^ (_e344 >> bitcast<u32>(16i))) * 569420461u);
                            let _e352 = ((_e348 ^ (_e348 >> bitcast<u32>(15i))) * 3545902487u);
                            let _e355 = (_e352 ^ (_e352 >> bitcast<u32>(15i)));
                            let _e359 = ((_e355 ^ (_e355 >> bitcast<u32>(16i))) * 569420461u);
                            let _e363 = ((_e359 ^ (_e359 >> bitcast<u32>(15i))) * 3545902487u);
                            let _e366 = (_e363 ^ (_e363 >> bitcast<u32>(15i)));
                            let _e368 = (reverseBits(_e216) + _e366);
                            let _e370 = (_e368 ^ (_e368 * 1817228412u));
                            let _e372 = (_e370 ^ (_e370 * 3090095698u));
                            let _e374 = (_e372 ^ (_e372 * 3350193720u));
                            let _e377 = reverseBits((_e374 ^ (_e374 * 2367878886u)));
                            let _e379 = (_e366 ^ 1u);
                            let _e383 = ((_e379 ^ (_e379 >> bitcast<u32>(16i))) * 569420461u);
                            let _e387 = ((_e383 ^ (_e383 >> bitcast<u32>(15i))) * 3545902487u);
                            let _e392 = (reverseBits(reverseBits(_e377)) + (_e387 ^ (_e387 >> bitcast<u32>(15i))));
                            let _e394 = (_e392 ^ (_e392 * 1817228412u));
                            let _e396 = (_e394 ^ (_e394 * 3090095698u));
                            let _e398 = (_e396 ^ (_e396 * 3350193720u));
                            phi_477_ = type_4(0u, 32u);
                            phi_480_ = 2147483648u;
                            phi_482_ = 0u;
                            loop {
                                let _e403 = phi_477_;
                                let _e405 = phi_480_;
                                let _e407 = phi_482_;
                                local_6 = _e407;
                                if (_e403.member < _e403.member_1) {
                                    phi_478_ = type_4((_e403.member + 1u), _e403.member_1);
                                    phi_505_ = type_4(1u, _e403.member);
                                } else {
                                    phi_478_ = _e403;
                                    phi_505_ = type_4(0u, type_4().member_1);
                                }
                                let _e420 = phi_478_;
                                let _e422 = phi_505_;
                                let _e426 = (bitcast<i32>(_e422.member) != 0i);
                                if _e426 {
                                    if (((_e377 >> bitcast<u32>((_e422.member_1 & 31u))) & 1u) == 1u) {
                                        phi_521_ = (_e407 ^ _e405);
                                    } else {
                                        phi_521_ = _e407;
                                    }
                                    let _e434 = phi_521_;
                                    phi_481_ = (_e405 ^ (_e405 >> bitcast<u32>(1i)));
                                    phi_483_ = _e434;
                                } else {
                                    phi_481_ = u32();
                                    phi_483_ = u32();
                                }
                                let _e439 = phi_481_;
                                let _e441 = phi_483_;
                                continue;
                                continuing {
                                    phi_477_ = _e420;
                                    phi_480_ = _e439;
                                    phi_482_ = _e441;
                                    break if !(_e426);
                                }
                            }
                            let _e443 = (_e366 ^ 2u);
                            let _e447 = ((_e443 ^ (_e443 >> bitcast<u32>(16i))) * 569420461u);
                            let _e451 = ((_e447 ^ (_e447 >> bitcast<u32>(15i))) * 3545902487u);
                            let _e456 = local_6;
                            let _e458 = (reverseBits(_e456) + (_e451 ^ (_e451 >> bitcast<u32>(15i))));
                            let _e460 = (_e458 ^ (_e458 * 1817228412u));
                            let _e462 = (_e460 ^ (_e460 * 3090095698u));
                            let _e464 = (_e462 ^ (_e462 * 3350193720u));
                            let _e472 = bitcast<i32>(((2u * (reverseBits((_e398 ^ (_e398 * 2367878886u))) >> bitcast<u32>(16i))) + 1u));
                            let _e473 = (_e472 - 65536i);
                            let _e478 = bitcast<i32>(((2u * (reverseBits((_e464 ^ (_e464 * 2367878886u))) >> bitcast<u32>(16i))) + 1u));
                            let _e479 = (_e478 - 65536i);
                            let _e480 = (_e473 < 0i);
                            if _e480 {
                                phi_551_ = (65536i - _e472);
                            } else {
                                phi_551_ = _e473;
                            }
                            let _e483 = phi_551_;
                            let _e484 = bitcast<u32>(_e483);
                            let _e485 = (_e479 < 0i);
                            if _e485 {
                                phi_558_ = (65536i - _e478);
                            } else {
                                phi_558_ = _e479;
                            }
                            let _e488 = phi_558_;
                            let _e489 = bitcast<u32>(_e488);
                            let _e490 = (_e484 > _e489);
                            let _e491 = select(_e489, _e484, _e490);
                            let _e496 = select(1u, _e491, (1u < _e491));
                            if (_e496 == 0u) {
                                break;
                            }
                            let _e500 = (((select(_e484, _e489, _e490) << bitcast<u32>(16i)) / _e496) << bitcast<u32>(15i));
                            let _e502 = (_e500 >> bitcast<u32>(16i));
                            let _e503 = (_e500 & 65535u);
                            let _e508 = ((_e502 * _e503) + ((_e503 * _e503) >> bitcast<u32>(16i)));
                            let _e520 = ((((_e502 * _e502) + (_e508 >> bitcast<u32>(16i))) + (((_e503 * _e502) + (_e508 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                            let _e522 = (_e520 >> bitcast<u32>(16i));
                            let _e523 = (_e520 & 65535u);
                            let _e528 = ((_e522 * 7711u) + ((_e523 * 7711u) >> bitcast<u32>(16i)));
                            let _e537 = (700062u - (((_e528 >> bitcast<u32>(16i)) + ((_e528 & 65535u) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e539 = (_e537 >> bitcast<u32>(16i));
                            let _e540 = (_e537 & 65535u);
                            let _e545 = ((_e522 * _e540) + ((_e523 * _e540) >> bitcast<u32>(16i)));
                            let _e558 = (34046945u - ((((_e522 * _e539) + (_e545 >> bitcast<u32>(16i))) + (((_e523 * _e539) + (_e545 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e560 = (_e558 >> bitcast<u32>(16i));
                            let _e561 = (_e558 & 65535u);
                            let _e566 = ((_e522 * _e561) + ((_e523 * _e561) >> bitcast<u32>(16i)));
                            let _e579 = (662337939u - ((((_e522 * _e560) + (_e566 >> bitcast<u32>(16i))) + (((_e523 * _e560) + (_e566 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e584 = ((_e522 * 13011u) + ((_e523 * 13011u) >> bitcast<u32>(16i)));
                            let _e595 = (5348082u - (((_e522 + (_e584 >> bitcast<u32>(16i))) + ((_e523 + (_e584 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e597 = (_e595 >> bitcast<u32>(16i));
                            let _e598 = (_e595 & 65535u);
                            let _e603 = ((_e522 * _e598) + ((_e523 * _e598) >> bitcast<u32>(16i)));
                            let _e616 = (173399667u - ((((_e522 * _e597) + (_e603 >> bitcast<u32>(16i))) + (((_e523 * _e597) + (_e603 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e618 = (_e616 >> bitcast<u32>(16i));
                            let _e619 = (_e616 & 65535u);
                            let _e624 = ((_e522 * _e619) + ((_e523 * _e619) >> bitcast<u32>(16i)));
                            let _e637 = (1686629713u - ((((_e522 * _e618) + (_e624 >> bitcast<u32>(16i))) + (((_e523 * _e618) + (_e624 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e639 = (_e579 >> bitcast<u32>(16i));
                            let _e640 = (_e579 & 65535u);
                            let _e645 = ((_e522 * _e640) + ((_e523 * _e640) >> bitcast<u32>(16i)));
                            let _e658 = (2147483648u - ((((_e522 * _e639) + (_e645 >> bitcast<u32>(16i))) + (((_e523 * _e639) + (_e645 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e660 = (_e637 >> bitcast<u32>(16i));
                            let _e661 = (_e637 & 65535u);
                            let _e666 = ((_e502 * _e661) + ((_e503 * _e661) >> bitcast<u32>(16i)));
                            let _e678 = ((((_e502 * _e660) + (_e666 >> bitcast<u32>(16i))) + (((_e503 * _e660) + (_e666 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                            let _e680 = (_e491 << bitcast<u32>(15i));
                            let _e682 = (_e680 >> bitcast<u32>(16i));
                            let _e683 = (_e680 & 65535u);
                            let _e685 = (_e658 >> bitcast<u32>(16i));
                            let _e686 = (_e658 & 65535u);
                            let _e691 = ((_e682 * _e686) + ((_e683 * _e686) >> bitcast<u32>(16i)));
                            let _e703 = ((((_e682 * _e685) + (_e691 >> bitcast<u32>(16i))) + (((_e683 * _e685) + (_e691 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                            let _e705 = (_e678 >> bitcast<u32>(16i));
                            let _e706 = (_e678 & 65535u);
                            let _e711 = ((_e682 * _e706) + ((_e683 * _e706) >> bitcast<u32>(16i)));
                            let _e723 = ((((_e682 * _e705) + (_e711 >> bitcast<u32>(16i))) + (((_e683 * _e705) + (_e711 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                            let _e728 = f32((select(_e723, _e703, _e490) >> bitcast<u32>(7i)));
                            if _e480 {
                                phi_875_ = (_e728 * -0.000000059604645f);
                            } else {
                                phi_875_ = (_e728 * 0.000000059604645f);
                            }
                            let _e732 = phi_875_;
                            let _e735 = f32((select(_e703, _e723, _e490) >> bitcast<u32>(7i)));
                            if _e485 {
                                phi_888_ = (_e735 * -0.000000059604645f);
                            } else {
                                phi_888_ = (_e735 * 0.000000059604645f);
                            }
                            let _e739 = phi_888_;
                            let _e754 = ((_e200.member_8[0] * _e732) + (_e200.member_10[0] * _e739));
                            let _e755 = ((_e200.member_8[1] * _e732) + (_e200.member_10[1] * _e739));
                            let _e756 = ((_e200.member_8[2] * _e732) + (_e200.member_10[2] * _e739));
                            phi_832_ = type_14(array<f32, 3>((_e200.member[0] + (_e754 * _e200.member_9)), (_e200.member[1] + (_e755 * _e200.member_9)), (_e200.member[2] + (_e756 * _e200.member_9))), 0f, array<f32, 3>(((_e200.member_2[0] + _e314) - (_e754 * _e200.member_11)), ((_e200.member_2[1] + _e315) - (_e755 * _e200.member_11)), ((_e200.member_2[2] + _e316) - (_e756 * _e200.member_11))), 340282350000000000000000000000000000000f);
                        } else {
                            phi_832_ = type_14(_e200.member, 0f, array<f32, 3>((_e200.member_2[0] + _e314), (_e200.member_2[1] + _e315), (_e200.member_2[2] + _e316)), 340282350000000000000000000000000000000f);
                        }
                        let _e777 = phi_832_;
                        phi_833_ = _e777;
                    }
                    let _e784 = phi_833_;
                    if _e68 {
                    } else {
                        break;
                    }
                    global_3.member[_e67] = type_15(_e784, array<f32, 3>(1f, 1f, 1f), 4294967295u, array<f32, 3>(0f, 0f, 0f), _e204);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn camera_rays(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
