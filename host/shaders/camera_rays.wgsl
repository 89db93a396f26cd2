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
    var phi_230_: type_22;
    var phi_268_: u32;
    var phi_271_: type_4;
    var phi_272_: type_4;
    var phi_294_: type_4;
    var phi_307_: u32;
    var phi_269_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_342_: array<f32, 2>;
    var phi_476_: type_4;
    var phi_479_: u32;
    var phi_481_: u32;
    var phi_477_: type_4;
    var phi_504_: type_4;
    var phi_520_: u32;
    var phi_480_: u32;
    var phi_482_: u32;
    var local_6: u32;
    var phi_550_: i32;
    var phi_557_: i32;
    var phi_874_: f32;
    var phi_887_: f32;
    var phi_831_: type_14;
    var phi_832_: type_14;

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
                    let _e75 = (_e74 / 2i);
                    let _e80 = bitcast<f32>((bitcast<u32>((_e75 + 127i)) << bitcast<u32>(23i)));
                    let _e86 = bitcast<f32>((bitcast<u32>(((_e74 - _e75) + 127i)) << bitcast<u32>(23i)));
                    let _e89 = global_4.member[0u];
                    let _e93 = global_4.member[0u].member;
                    let _e116 = type_22(array<f32, 3>(((_e93[0] * _e80) * _e86), ((_e93[1] * _e80) * _e86), ((_e93[2] * _e80) * _e86)), _e89.member_1, _e89.member_2, _e89.member_3, _e89.member_4, _e89.member_5, _e89.member_6, _e89.member_7, _e89.member_8, _e89.member_9, _e89.member_10, _e89.member_11);
                    let _e120 = global_4.member[0u].member_9;
                    let _e135 = type_22(_e116.member, _e116.member_1, _e116.member_2, _e116.member_3, _e116.member_4, _e116.member_5, _e116.member_6, _e116.member_7, _e116.member_8, ((_e120 * _e80) * _e86), _e116.member_10, _e116.member_11);
                    let _e139 = global_4.member[0u].member_1;
                    if (_e139 == 1u) {
                        let _e144 = global_4.member[0u].member_4;
                        let _e167 = type_22(_e135.member, _e135.member_1, _e135.member_2, _e135.member_3, array<f32, 3>(((_e144[0] * _e80) * _e86), ((_e144[1] * _e80) * _e86), ((_e144[2] * _e80) * _e86)), _e135.member_5, _e135.member_6, _e135.member_7, _e135.member_8, _e135.member_9, _e135.member_10, _e135.member_11);
                        let _e171 = global_4.member[0u].member_6;
                        phi_230_ = type_22(_e167.member, _e167.member_1, _e167.member_2, _e167.member_3, _e167.member_4, _e167.member_5, array<f32, 3>(((_e171[0] * _e80) * _e86), ((_e171[1] * _e80) * _e86), ((_e171[2] * _e80) * _e86)), _e167.member_7, _e167.member_8, _e167.member_9, _e167.member_10, _e167.member_11);
                    } else {
                        phi_230_ = _e135;
                    }
                    let _e196 = phi_230_;
                    let _e199 = global_2.member[0u];
                    let _e200 = (_e199 + _e67);
                    let _e203 = select(1u, _e196.member_7, (1u < _e196.member_7));
                    let _e206 = select(1u, _e196.member_3, (1u < _e196.member_3));
                    let _e207 = (_e203 == 0u);
                    if _e207 {
                        break;
                    }
                    let _e208 = (_e200 / _e203);
                    let _e209 = (_e206 == 0u);
                    if _e209 {
                        break;
                    }
                    if _e209 {
                        break;
                    }
                    if _e207 {
                        break;
                    }
                    let _e212 = (_e200 % _e203);
                    phi_268_ = 1u;
                    phi_271_ = type_4(0u, 16u);
                    loop {
                        let _e214 = phi_268_;
                        let _e216 = phi_271_;
                        local = _e214;
                        local_1 = _e214;
                        local_2 = _e214;
                        local_3 = _e214;
                        local_4 = _e214;
                        local_5 = _e214;
                        if (_e216.member < _e216.member_1) {
                            phi_272_ = type_4((_e216.member + 1u), _e216.member_1);
                            phi_294_ = type_4(1u, _e216.member);
                        } else {
                            phi_272_ = _e216;
                            phi_294_ = type_4(0u, type_4().member_1);
                        }
                        let _e229 = phi_272_;
                        let _e231 = phi_294_;
                        let _e234 = (bitcast<i32>(_e231.member) != 0i);
                        if _e234 {
                            if ((_e214 * _e214) < _e203) {
                                phi_307_ = (_e214 + 1u);
                            } else {
                                phi_307_ = _e214;
                            }
                            let _e239 = phi_307_;
                            phi_269_ = _e239;
                        } else {
                            phi_269_ = u32();
                        }
                        let _e241 = phi_269_;
                        continue;
                        continuing {
                            phi_268_ = _e241;
                            phi_271_ = _e229;
                            break if !(_e234);
                        }
                    }
                    let _e244 = local;
                    let _e246 = local_1;
                    if ((_e244 * _e246) == _e203) {
                        let _e261 = local_2;
                        let _e262 = (_e261 == 0u);
                        if _e262 {
                            break;
                        }
                        let _e264 = local_3;
                        let _e269 = local_4;
                        let _e270 = f32(_e269);
                        if _e262 {
                            break;
                        }
                        let _e273 = local_5;
                        phi_342_ = array<f32, 2>(((f32((_e212 % _e264)) + 0.5f) / _e270), ((f32((_e212 / _e273)) + 0.5f) / _e270));
                    } else {
                        phi_342_ = array<f32, 2>(((f32(_e212) + 0.5f) / f32(_e203)), (f32((((_e212 * 2654435769u) + 1327217884u) >> bitcast<u32>(8i))) * 0.000000059604645f));
                    }
                    let _e280 = phi_342_;
                    let _e288 = ((((f32((_e208 % _e206)) + _e280[0]) / f32(_e196.member_3)) * 2f) - 1f);
                    let _e295 = (1f - (((f32((_e208 / _e206)) + _e280[1]) / f32(_e196.member_5)) * 2f));
                    let _e310 = ((_e196.member_4[0] * _e288) + (_e196.member_6[0] * _e295));
                    let _e311 = ((_e196.member_4[1] * _e288) + (_e196.member_6[1] * _e295));
                    let _e312 = ((_e196.member_4[2] * _e288) + (_e196.member_6[2] * _e295));
                    if (_e196.member_1 == 1u) {
                        phi_832_ = type_14(array<f32, 3>((_e196.member[0] + _e310), (_e196.member[1] + _e311), (_e196.member[2] + _e312)), 0f, _e196.member_2, 340282350000000000000000000000000000000f);
                    } else {
                        if (_e196.member_9 > 0f) {
                            if _e207 {
                                break;
                            }
                            if _e207 {
                                break;
                            }
                            let _e333 = ((_e208 ^ (_e208 >> bitcast<u32>(16i))) * 569420461u);
                            let _e337 = ((_e333 ^ (_e333 >> bitcast<u32>(15i))) * 3545902487u);
                            let _e340 = (_e337 ^ (_e337 >> bitcast<u32>(15i)));
                            let _e344 = ((_e340 ^ (_e340 >> bitcast<u32>(16i))) * 569420461u);
                            let _e348 = ((_e344 ^ (_e344 >> bitcast<u32>(15i))) * 3545902487u);
                            let _e351 = (_e348 ^ (_e348 >> bitcast<u32>(15i)));
                            let _e355 = ((_e351 ^ (_e351 >> bitcast<u32>(16i))) * 569420461u);
                            let _e359 = ((_e355 ^ (_e355 >> bitcast<u32>(15i))) * 3545902487u);
                            let _e362 = (_e359 ^ (_e359 >> bitcast<u32>(15i)));
                            let _e364 = (reverseBits(_e212) + _e362);
                            let _e366 = (_e364 ^ (_e364 * 1817228412u));
                            let _e368 = (_e366 ^ (_e366 * 3090095698u));
                            let _e370 = (_e368 ^ (_e368 * 3350193720u));
                            let _e373 = reverseBits((_e370 ^ (_e370 * 2367878886u)));
                            let _e375 = (_e362 ^ 1u);
                            let _e379 = ((_e375 ^ (_e375 >> bitcast<u32>(16i))) * 569420461u);
                            let _e383 = ((_e379 ^ (_e379 >> bitcast<u32>(15i))) * 3545902487u);
                            let _e388 = (reverseBits(reverseBits(_e373)) + (_e383 ^ (_e383 >> bitcast<u32>(15i))));
                            let _e390 = (_e388 ^ (_e388 * 1817228412u));
                            let _e392 = (_e390 ^ (_e390 * 3090095698u));
                            let _e394 = (_e392 ^ (_e392 * 3350193720u));
                            phi_476_ = type_4(0u, 32u);
                            phi_479_ = 2147483648u;
                            phi_481_ = 0u;
                            loop {
                                let _e399 = phi_476_;
                                let _e401 = phi_479_;
                                let _e403 = phi_481_;
                                local_6 = _e403;
                                if (_e399.member < _e399.member_1) {
                                    phi_477_ = type_4((_e399.member + 1u), _e399.member_1);
                                    phi_504_ = type_4(1u, _e399.member);
                                } else {
                                    phi_477_ = _e399;
                                    phi_504_ = type_4(0u, type_4().member_1);
                                }
                                let _e416 = phi_477_;
                                let _e418 = phi_504_;
                                let _e422 = (bitcast<i32>(_e418.member) != 0i);
                                if _e422 {
                                    if (((_e373 >> bitcast<u32>((_e418.member_1 & 31u))) & 1u) == 1u) {
                                        phi_520_ = (_e403 ^ _e401);
                                    } else {
                                        phi_520_ = _e403;
                                    }
                                    let _e430 = phi_520_;
                                    phi_480_ = (_e401 ^ (_e401 >> bitcast<u32>(1i)));
                                    phi_482_ = _e430;
                                } else {
                                    phi_480_ = u32();
                                    phi_482_ = u32();
                                }
                                let _e435 = phi_480_;
                                let _e437 = phi_482_;
                                continue;
                                continuing {
                                    phi_476_ = _e416;
                                    phi_479_ = _e435;
                                    phi_481_ = _e437;
                                    break if !(_e422);
                                }
                            }
                            let _e439 = (_e362 ^ 2u);
                            let _e443 = ((_e439 ^ (_e439 >> bitcast<u32>(16i))) * 569420461u);
                            let _e447 = ((_e443 ^ (_e443 >> bitcast<u32>(15i))) * 3545902487u);
                            let _e452 = local_6;
                            let _e454 = (reverseBits(_e452) + (_e447 ^ (_e447 >> bitcast<u32>(15i))));
                            let _e456 = (_e454 ^ (_e454 * 1817228412u));
                            let _e458 = (_e456 ^ (_e456 * 3090095698u));
                            let _e460 = (_e458 ^ (_e458 * 3350193720u));
                            let _e468 = bitcast<i32>(((2u * (reverseBits((_e394 ^ (_e394 * 2367878886u))) >> bitcast<u32>(16i))) + 1u));
                            let _e469 = (_e468 - 65536i);
                            let _e474 = bitcast<i32>(((2u * (reverseBits((_e460 ^ (_e460 * 2367878886u))) >> bitcast<u32>(16i))) + 1u));
                            let _e475 = (_e474 - 65536i);
                            let _e476 = (_e469 < 0i);
                            if _e476 {
                                phi_550_ = (65536i - _e468);
                            } else {
                                phi_550_ = _e469;
                            }
                            let _e479 = phi_550_;
                            let _e480 = bitcast<u32>(_e479);
                            let _e481 = (_e475 < 0i);
                            if _e481 {
                                phi_557_ = (65536i - _e474);
                            } else {
                                phi_557_ = _e475;
                            }
                            let _e484 = phi_557_;
                            let _e485 = bitcast<u32>(_e484);
                            let _e486 = (_e480 > _e485);
                            let _e487 = select(_e485, _e480, _e486);
                            let _e492 = select(1u, _e487, (1u < _e487));
                            if (_e492 == 0u) {
                                break;
                            }
                            let _e496 = (((select(_e480, _e485, _e486) << bitcast<u32>(16i)) / _e492) << bitcast<u32>(15i));
                            let _e498 = (_e496 >> bitcast<u32>(16i));
                            let _e499 = (_e496 & 65535u);
                            let _e504 = ((_e498 * _e499) + ((_e499 * _e499) >> bitcast<u32>(16i)));
                            let _e516 = ((((_e498 * _e498) + (_e504 >> bitcast<u32>(16i))) + (((_e499 * _e498) + (_e504 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                            let _e518 = (_e516 >> bitcast<u32>(16i));
                            let _e519 = (_e516 & 65535u);
                            let _e524 = ((_e518 * 7711u) + ((_e519 * 7711u) >> bitcast<u32>(16i)));
                            let _e533 = (700062u - (((_e524 >> bitcast<u32>(16i)) + ((_e524 & 65535u) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e535 = (_e533 >> bitcast<u32>(16i));
                            let _e536 = (_e533 & 65535u);
                            let _e541 = ((_e518 * _e536) + ((_e519 * _e536) >> bitcast<u32>(16i)));
                            let _e554 = (34046945u - ((((_e518 * _e535) + (_e541 >> bitcast<u32>(16i))) + (((_e519 * _e535) + (_e541 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e556 = (_e554 >> bitcast<u32>(16i));
                            let _e557 = (_e554 & 65535u);
                            let _e562 = ((_e518 * _e557) + ((_e519 * _e557) >> bitcast<u32>(16i)));
                            let _e575 = (662337939u - ((((_e518 * _e556) + (_e562 >> bitcast<u32>(16i))) + (((_e519 * _e556) + (_e562 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e580 = ((_e518 * 13011u) + ((_e519 * 13011u) >> bitcast<u32>(16i)));
                            let _e591 = (5348082u - (((_e518 + (_e580 >> bitcast<u32>(16i))) + ((_e519 + (_e580 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e593 = (_e591 >> bitcast<u32>(16i));
                            let _e594 = (_e591 & 65535u);
                            let _e599 = ((_e518 * _e594) + ((_e519 * _e594) >> bitcast<u32>(16i)));
                            let _e612 = (173399667u - ((((_e518 * _e593) + (_e599 >> bitcast<u32>(16i))) + (((_e519 * _e593) + (_e599 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e614 = (_e612 >> bitcast<u32>(16i));
                            let _e615 = (_e612 & 65535u);
                            let _e620 = ((_e518 * _e615) + ((_e519 * _e615) >> bitcast<u32>(16i)));
                            let _e633 = (1686629713u - ((((_e518 * _e614) + (_e620 >> bitcast<u32>(16i))) + (((_e519 * _e614) + (_e620 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e635 = (_e575 >> bitcast<u32>(16i));
                            let _e636 = (_e575 & 65535u);
                            let _e641 = ((_e518 * _e636) + ((_e519 * _e636) >> bitcast<u32>(16i)));
                            let _e654 = (2147483648u - ((((_e518 * _e635) + (_e641 >> bitcast<u32>(16i))) + (((_e519 * _e635) + (_e641 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i)));
                            let _e656 = (_e633 >> bitcast<u32>(16i));
                            let _e657 = (_e633 & 65535u);
                            let _e662 = ((_e498 * _e657) + ((_e499 * _e657) >> bitcast<u32>(16i)));
                            let _e674 = ((((_e498 * _e656) + (_e662 >> bitcast<u32>(16i))) + (((_e499 * _e656) + (_e662 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                            let _e676 = (_e487 << bitcast<u32>(15i));
                            let _e678 = (_e676 >> bitcast<u32>(16i));
                            let _e679 = (_e676 & 65535u);
                            let _e681 = (_e654 >> bitcast<u32>(16i));
                            let _e682 = (_e654 & 65535u);
                            let _e687 = ((_e678 * _e682) + ((_e679 * _e682) >> bitcast<u32>(16i)));
                            let _e699 = ((((_e678 * _e681) + (_e687 >> bitcast<u32>(16i))) + (((_e679 * _e681) + (_e687 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                            let _e701 = (_e674 >> bitcast<u32>(16i));
                            let _e702 = (_e674 & 65535u);
                            let _e707 = ((_e678 * _e702) + ((_e679 * _e702) >> bitcast<u32>(16i)));
                            let _e719 = ((((_e678 * _e701) + (_e707 >> bitcast<u32>(16i))) + (((_e679 * _e701) + (_e707 & 65535u)) >> bitcast<u32>(16i))) << bitcast<u32>(1i));
                            let _e724 = f32((select(_e719, _e699, _e486) >> bitcast<u32>(7i)));
                            if _e476 {
                                phi_874_ = (_e724 * -0.000000059604645f);
                            } else {
                                phi_874_ = (_e724 * 0.000000059604645f);
                            }
                            let _e728 = phi_874_;
                            let _e731 = f32((select(_e699, _e719, _e486) >> bitcast<u32>(7i)));
                            if _e481 {
                                phi_887_ = (_e731 * -0.000000059604645f);
                            } else {
                                phi_887_ = (_e731 * 0.000000059604645f);
                            }
                            let _e735 = phi_887_;
                            let _e750 = ((_e196.member_8[0] * _e728) + (_e196.member_10[0] * _e735));
                            let _e751 = ((_e196.member_8[1] * _e728) + (_e196.member_10[1] * _e735));
                            let _e752 = ((_e196.member_8[2] * _e728) + (_e196.member_10[2] * _e735));
                            phi_831_ = type_14(array<f32, 3>((_e196.member[0] + (_e750 * _e196.member_9)), (_e196.member[1] + (_e751 * _e196.member_9)), (_e196.member[2] + (_e752 * _e196.member_9))), 0f, array<f32, 3>(((_e196.member_2[0] + _e310) - (_e750 * _e196.member_11)), ((_e196.member_2[1] + _e311) - (_e751 * _e196.member_11)), ((_e196.member_2[2] + _e312) - (_e752 * _e196.member_11))), 340282350000000000000000000000000000000f);
                        } else {
                            phi_831_ = type_14(_e196.member, 0f, array<f32, 3>((_e196.member_2[0] + _e310), (_e196.member_2[1] + _e311), (_e196.member_2[2] + _e312)), 340282350000000000000000000000000000000f);
                        }
                        let _e773 = phi_831_;
                        phi_832_ = _e773;
                    }
                    let _e780 = phi_832_;
                    if _e68 {
                    } else {
                        break;
                    }
                    global_3.member[_e67] = type_15(_e780, array<f32, 3>(1f, 1f, 1f), 4294967295u, array<f32, 3>(0f, 0f, 0f), _e200);
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
