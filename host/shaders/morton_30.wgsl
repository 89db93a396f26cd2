struct type_9 {
    member: array<array<f32, 3>>,
}

struct type_13 {
    member: array<array<u32, 3>>,
}

struct type_21 {
    member: array<array<u32, 2>>,
}

struct type_24 {
    member: i32,
    member_1: i32,
    member_2: u32,
}

struct type_26 {
    member: array<type_24, 3>,
    member_1: u32,
}

struct type_28 {
    member: array<type_26>,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_9;
@group(0) @binding(2) 
var<storage> global_2: type_13;
@group(0) @binding(0) 
var<storage> global_3: type_28;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_21;

fn function_() {
    var phi_126_: array<u32, 3>;
    var phi_141_: array<f32, 3>;
    var phi_159_: array<f32, 3>;
    var phi_177_: array<f32, 3>;
    var phi_281_: i32;
    var phi_291_: i32;
    var phi_332_: i32;
    var phi_342_: i32;
    var phi_427_: i32;
    var phi_437_: i32;
    var phi_478_: i32;
    var phi_488_: i32;
    var phi_573_: i32;
    var phi_583_: i32;
    var phi_624_: i32;
    var phi_634_: i32;

    switch bitcast<i32>(0u) {
        default: {
            let _e32 = global;
            let _e34 = arrayLength((&global_3.member));
            let _e37 = arrayLength((&global_1.member));
            let _e46 = (_e32.x + (_e32.y * 2097152u));
            let _e47 = (_e46 < arrayLength((&global_4.member)));
            if _e47 {
                if (_e34 == 0u) {
                } else {
                    let _e49 = (_e46 < arrayLength((&global_2.member)));
                    if _e49 {
                        if _e49 {
                        } else {
                            break;
                        }
                        let _e51 = global_2.member[_e46];
                        phi_126_ = _e51;
                    } else {
                        phi_126_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e53 = phi_126_;
                    let _e55 = (_e53[0] < _e37);
                    if _e55 {
                        if _e55 {
                        } else {
                            break;
                        }
                        let _e57 = global_1.member[_e53[0]];
                        phi_141_ = _e57;
                    } else {
                        phi_141_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e59 = phi_141_;
                    let _e64 = (_e53[1] < _e37);
                    if _e64 {
                        if _e64 {
                        } else {
                            break;
                        }
                        let _e66 = global_1.member[_e53[1]];
                        phi_159_ = _e66;
                    } else {
                        phi_159_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e68 = phi_159_;
                    let _e73 = (_e53[2] < _e37);
                    if _e73 {
                        if _e73 {
                        } else {
                            break;
                        }
                        let _e75 = global_1.member[_e53[2]];
                        phi_177_ = _e75;
                    } else {
                        phi_177_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e77 = phi_177_;
                    let _e82 = select(_e68[0], _e59[0], (_e59[0] < _e68[0]));
                    let _e84 = select(_e68[1], _e59[1], (_e59[1] < _e68[1]));
                    let _e86 = select(_e68[2], _e59[2], (_e59[2] < _e68[2]));
                    let _e94 = select(_e68[0], _e59[0], (_e59[0] > _e68[0]));
                    let _e96 = select(_e68[1], _e59[1], (_e59[1] > _e68[1]));
                    let _e98 = select(_e68[2], _e59[2], (_e59[2] > _e68[2]));
                    if (0u < _e34) {
                    } else {
                        break;
                    }
                    let _e111 = global_3.member[0u].member[0u].member;
                    let _e117 = global_3.member[0u].member[0u].member_1;
                    let _e123 = global_3.member[0u].member[0u].member_2;
                    let _e124 = bitcast<u32>(select(_e77[0], _e82, (_e82 < _e77[0])));
                    let _e127 = ((_e124 >> bitcast<u32>(23i)) & 255u);
                    let _e129 = select(0u, 1u, (_e127 != 0u));
                    let _e138 = (_e111 - ((bitcast<i32>(_e127) - bitcast<i32>(_e129)) + -149i));
                    let _e139 = (_e138 < 0i);
                    if _e139 {
                        phi_281_ = -(_e138);
                    } else {
                        phi_281_ = 0i;
                    }
                    let _e142 = phi_281_;
                    if _e139 {
                        phi_291_ = 0i;
                    } else {
                        phi_291_ = select(_e138, 31i, (_e138 > 31i));
                    }
                    let _e146 = phi_291_;
                    let _e147 = (_e146 & 31i);
                    let _e161 = (bitcast<i32>(_e124) >> bitcast<u32>(31i));
                    let _e165 = bitcast<u32>(select(_e77[0], _e94, (_e94 > _e77[0])));
                    let _e168 = ((_e165 >> bitcast<u32>(23i)) & 255u);
                    let _e170 = select(0u, 1u, (_e168 != 0u));
                    let _e179 = (_e111 - ((bitcast<i32>(_e168) - bitcast<i32>(_e170)) + -149i));
                    let _e180 = (_e179 < 0i);
                    if _e180 {
                        phi_332_ = -(_e179);
                    } else {
                        phi_332_ = 0i;
                    }
                    let _e183 = phi_332_;
                    if _e180 {
                        phi_342_ = 0i;
                    } else {
                        phi_342_ = select(_e179, 31i, (_e179 > 31i));
                    }
                    let _e187 = phi_342_;
                    let _e188 = (_e187 & 31i);
                    let _e202 = (bitcast<i32>(_e165) >> bitcast<u32>(31i));
                    let _e212 = (bitcast<u32>(((((bitcast<i32>((((((_e124 & 8388607u) | (_e129 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e142) & 31u))) + ((1u << bitcast<u32>(_e147)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e147))) ^ _e161) - _e161) + ((bitcast<i32>((((((_e165 & 8388607u) | (_e170 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e183) & 31u))) + ((1u << bitcast<u32>(_e188)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e188))) ^ _e202) - _e202)) - _e117)) << bitcast<u32>(((_e123 & 31u) & 31u)));
                    let _e216 = global_3.member[0u].member_1;
                    let _e218 = (_e212 >> bitcast<u32>(16i));
                    let _e219 = (_e212 & 65535u);
                    let _e221 = (_e216 >> bitcast<u32>(16i));
                    let _e222 = (_e216 & 65535u);
                    let _e227 = ((_e218 * _e222) + ((_e219 * _e222) >> bitcast<u32>(16i)));
                    let _e249 = global_3.member[0u].member[1u].member;
                    let _e255 = global_3.member[0u].member[1u].member_1;
                    let _e261 = global_3.member[0u].member[1u].member_2;
                    let _e262 = bitcast<u32>(select(_e77[1], _e84, (_e84 < _e77[1])));
                    let _e265 = ((_e262 >> bitcast<u32>(23i)) & 255u);
                    let _e267 = select(0u, 1u, (_e265 != 0u));
                    let _e276 = (_e249 - ((bitcast<i32>(_e265) - bitcast<i32>(_e267)) + -149i));
                    let _e277 = (_e276 < 0i);
                    if _e277 {
                        phi_427_ = -(_e276);
                    } else {
                        phi_427_ = 0i;
                    }
                    let _e280 = phi_427_;
                    if _e277 {
                        phi_437_ = 0i;
                    } else {
                        phi_437_ = select(_e276, 31i, (_e276 > 31i));
                    }
                    let _e284 = phi_437_;
                    let _e285 = (_e284 & 31i);
                    let _e299 = (bitcast<i32>(_e262) >> bitcast<u32>(31i));
                    let _e303 = bitcast<u32>(select(_e77[1], _e96, (_e96 > _e77[1])));
                    let _e306 = ((_e303 >> bitcast<u32>(23i)) & 255u);
                    let _e308 = select(0u, 1u, (_e306 != 0u));
                    let _e317 = (_e249 - ((bitcast<i32>(_e306) - bitcast<i32>(_e308)) + -149i));
                    let _e318 = (_e317 < 0i);
                    if _e318 {
                        phi_478_ = -(_e317);
                    } else {
                        phi_478_ = 0i;
                    }
                    let _e321 = phi_478_;
                    if _e318 {
                        phi_488_ = 0i;
                    } else {
                        phi_488_ = select(_e317, 31i, (_e317 > 31i));
                    }
                    let _e325 = phi_488_;
                    let _e326 = (_e325 & 31i);
                    let _e340 = (bitcast<i32>(_e303) >> bitcast<u32>(31i));
                    let _e350 = (bitcast<u32>(((((bitcast<i32>((((((_e262 & 8388607u) | (_e267 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e280) & 31u))) + ((1u << bitcast<u32>(_e285)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e285))) ^ _e299) - _e299) + ((bitcast<i32>((((((_e303 & 8388607u) | (_e308 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e321) & 31u))) + ((1u << bitcast<u32>(_e326)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e326))) ^ _e340) - _e340)) - _e255)) << bitcast<u32>(((_e261 & 31u) & 31u)));
                    let _e352 = (_e350 >> bitcast<u32>(16i));
                    let _e353 = (_e350 & 65535u);
                    let _e358 = ((_e352 * _e222) + ((_e353 * _e222) >> bitcast<u32>(16i)));
                    let _e380 = global_3.member[0u].member[2u].member;
                    let _e386 = global_3.member[0u].member[2u].member_1;
                    let _e392 = global_3.member[0u].member[2u].member_2;
                    let _e393 = bitcast<u32>(select(_e77[2], _e86, (_e86 < _e77[2])));
                    let _e396 = ((_e393 >> bitcast<u32>(23i)) & 255u);
                    let _e398 = select(0u, 1u, (_e396 != 0u));
                    let _e407 = (_e380 - ((bitcast<i32>(_e396) - bitcast<i32>(_e398)) + -149i));
                    let _e408 = (_e407 < 0i);
                    if _e408 {
                        phi_573_ = -(_e407);
                    } else {
                        phi_573_ = 0i;
                    }
                    let _e411 = phi_573_;
                    if _e408 {
                        phi_583_ = 0i;
                    } else {
                        phi_583_ = select(_e407, 31i, (_e407 > 31i));
                    }
                    let _e415 = phi_583_;
                    let _e416 = (_e415 & 31i);
                    let _e430 = (bitcast<i32>(_e393) >> bitcast<u32>(31i));
                    let _e434 = bitcast<u32>(select(_e77[2], _e98, (_e98 > _e77[2])));
                    let _e437 = ((_e434 >> bitcast<u32>(23i)) & 255u);
                    let _e439 = select(0u, 1u, (_e437 != 0u));
                    let _e448 = (_e380 - ((bitcast<i32>(_e437) - bitcast<i32>(_e439)) + -149i));
                    let _e449 = (_e448 < 0i);
                    if _e449 {
                        phi_624_ = -(_e448);
                    } else {
                        phi_624_ = 0i;
                    }
                    let _e452 = phi_624_;
                    if _e449 {
                        phi_634_ = 0i;
                    } else {
                        phi_634_ = select(_e448, 31i, (_e448 > 31i));
                    }
                    let _e456 = phi_634_;
                    let _e457 = (_e456 & 31i);
                    let _e471 = (bitcast<i32>(_e434) >> bitcast<u32>(31i));
                    let _e481 = (bitcast<u32>(((((bitcast<i32>((((((_e393 & 8388607u) | (_e398 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e411) & 31u))) + ((1u << bitcast<u32>(_e416)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e416))) ^ _e430) - _e430) + ((bitcast<i32>((((((_e434 & 8388607u) | (_e439 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e452) & 31u))) + ((1u << bitcast<u32>(_e457)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e457))) ^ _e471) - _e471)) - _e386)) << bitcast<u32>(((_e392 & 31u) & 31u)));
                    let _e483 = (_e481 >> bitcast<u32>(16i));
                    let _e484 = (_e481 & 65535u);
                    let _e489 = ((_e483 * _e222) + ((_e484 * _e222) >> bitcast<u32>(16i)));
                    let _e506 = (((((_e218 * _e221) + (_e227 >> bitcast<u32>(16i))) + (((_e219 * _e221) + (_e227 & 65535u)) >> bitcast<u32>(16i))) >> bitcast<u32>((((_e123 >> bitcast<u32>(16i)) & 31u) & 31u))) & 1023u);
                    let _e510 = ((_e506 | (_e506 << bitcast<u32>(16i))) & 50331903u);
                    let _e514 = ((_e510 | (_e510 << bitcast<u32>(8i))) & 50393103u);
                    let _e518 = ((_e514 | (_e514 << bitcast<u32>(4i))) & 51130563u);
                    let _e525 = (((((_e352 * _e221) + (_e358 >> bitcast<u32>(16i))) + (((_e353 * _e221) + (_e358 & 65535u)) >> bitcast<u32>(16i))) >> bitcast<u32>((((_e261 >> bitcast<u32>(16i)) & 31u) & 31u))) & 1023u);
                    let _e529 = ((_e525 | (_e525 << bitcast<u32>(16i))) & 50331903u);
                    let _e533 = ((_e529 | (_e529 << bitcast<u32>(8i))) & 50393103u);
                    let _e537 = ((_e533 | (_e533 << bitcast<u32>(4i))) & 51130563u);
                    let _e545 = (((((_e483 * _e221) + (_e489 >> bitcast<u32>(16i))) + (((_e484 * _e221) + (_e489 & 65535u)) >> bitcast<u32>(16i))) >> bitcast<u32>((((_e392 >> bitcast<u32>(16i)) & 31u) & 31u))) & 1023u);
                    let _e549 = ((_e545 | (_e545 << bitcast<u32>(16i))) & 50331903u);
                    let _e553 = ((_e549 | (_e549 << bitcast<u32>(8i))) & 50393103u);
                    let _e557 = ((_e553 | (_e553 << bitcast<u32>(4i))) & 51130563u);
                    if _e47 {
                    } else {
                        break;
                    }
                    global_4.member[_e46][0u] = (((((_e518 | (_e518 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(2i)) | (((_e537 | (_e537 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(1i))) | ((_e557 | (_e557 << bitcast<u32>(2i))) & 153391689u));
                    global_4.member[_e46][1u] = _e46;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn morton_30_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
