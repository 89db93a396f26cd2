struct type_9 {
    member: array<array<f32, 3>>,
}

struct type_13 {
    member: array<array<u32, 3>>,
}

struct type_20 {
    member: i32,
    member_1: i32,
    member_2: u32,
}

struct type_22 {
    member: array<type_20, 3>,
    member_1: u32,
}

struct type_24 {
    member: array<type_22>,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_9;
@group(0) @binding(2) 
var<storage> global_2: type_13;
@group(0) @binding(0) 
var<storage> global_3: type_24;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_13;

fn function_() {
    var phi_123_: array<u32, 3>;
    var phi_138_: array<f32, 3>;
    var phi_156_: array<f32, 3>;
    var phi_174_: array<f32, 3>;
    var phi_278_: i32;
    var phi_288_: i32;
    var phi_329_: i32;
    var phi_339_: i32;
    var phi_424_: i32;
    var phi_434_: i32;
    var phi_475_: i32;
    var phi_485_: i32;
    var phi_570_: i32;
    var phi_580_: i32;
    var phi_621_: i32;
    var phi_631_: i32;

    switch bitcast<i32>(0u) {
        default: {
            let _e35 = global;
            let _e37 = arrayLength((&global_3.member));
            let _e40 = arrayLength((&global_1.member));
            let _e49 = (_e35.x + (_e35.y * 2097152u));
            let _e50 = (_e49 < arrayLength((&global_4.member)));
            if _e50 {
                if (_e37 == 0u) {
                } else {
                    let _e52 = (_e49 < arrayLength((&global_2.member)));
                    if _e52 {
                        if _e52 {
                        } else {
                            break;
                        }
                        let _e54 = global_2.member[_e49];
                        phi_123_ = _e54;
                    } else {
                        phi_123_ = array<u32, 3>(0u, 0u, 0u);
                    }
                    let _e56 = phi_123_;
                    let _e58 = (_e56[0] < _e40);
                    if _e58 {
                        if _e58 {
                        } else {
                            break;
                        }
                        let _e60 = global_1.member[_e56[0]];
                        phi_138_ = _e60;
                    } else {
                        phi_138_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e62 = phi_138_;
                    let _e67 = (_e56[1] < _e40);
                    if _e67 {
                        if _e67 {
                        } else {
                            break;
                        }
                        let _e69 = global_1.member[_e56[1]];
                        phi_156_ = _e69;
                    } else {
                        phi_156_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e71 = phi_156_;
                    let _e76 = (_e56[2] < _e40);
                    if _e76 {
                        if _e76 {
                        } else {
                            break;
                        }
                        let _e78 = global_1.member[_e56[2]];
                        phi_174_ = _e78;
                    } else {
                        phi_174_ = array<f32, 3>(0f, 0f, 0f);
                    }
                    let _e80 = phi_174_;
                    let _e85 = select(_e71[0], _e62[0], (_e62[0] < _e71[0]));
                    let _e87 = select(_e71[1], _e62[1], (_e62[1] < _e71[1]));
                    let _e89 = select(_e71[2], _e62[2], (_e62[2] < _e71[2]));
                    let _e97 = select(_e71[0], _e62[0], (_e62[0] > _e71[0]));
                    let _e99 = select(_e71[1], _e62[1], (_e62[1] > _e71[1]));
                    let _e101 = select(_e71[2], _e62[2], (_e62[2] > _e71[2]));
                    if (0u < _e37) {
                    } else {
                        break;
                    }
                    let _e114 = global_3.member[0u].member[0u].member;
                    let _e120 = global_3.member[0u].member[0u].member_1;
                    let _e126 = global_3.member[0u].member[0u].member_2;
                    let _e127 = bitcast<u32>(select(_e80[0], _e85, (_e85 < _e80[0])));
                    let _e130 = ((_e127 >> bitcast<u32>(23i)) & 255u);
                    let _e132 = select(0u, 1u, (_e130 != 0u));
                    let _e141 = (_e114 - ((bitcast<i32>(_e130) - bitcast<i32>(_e132)) + -149i));
                    let _e142 = (_e141 < 0i);
                    if _e142 {
                        phi_278_ = -(_e141);
                    } else {
                        phi_278_ = 0i;
                    }
                    let _e145 = phi_278_;
                    if _e142 {
                        phi_288_ = 0i;
                    } else {
                        phi_288_ = select(_e141, 31i, (_e141 > 31i));
                    }
                    let _e149 = phi_288_;
                    let _e150 = (_e149 & 31i);
                    let _e164 = (bitcast<i32>(_e127) >> bitcast<u32>(31i));
                    let _e168 = bitcast<u32>(select(_e80[0], _e97, (_e97 > _e80[0])));
                    let _e171 = ((_e168 >> bitcast<u32>(23i)) & 255u);
                    let _e173 = select(0u, 1u, (_e171 != 0u));
                    let _e182 = (_e114 - ((bitcast<i32>(_e171) - bitcast<i32>(_e173)) + -149i));
                    let _e183 = (_e182 < 0i);
                    if _e183 {
                        phi_329_ = -(_e182);
                    } else {
                        phi_329_ = 0i;
                    }
                    let _e186 = phi_329_;
                    if _e183 {
                        phi_339_ = 0i;
                    } else {
                        phi_339_ = select(_e182, 31i, (_e182 > 31i));
                    }
                    let _e190 = phi_339_;
                    let _e191 = (_e190 & 31i);
                    let _e205 = (bitcast<i32>(_e168) >> bitcast<u32>(31i));
                    let _e215 = (bitcast<u32>(((((bitcast<i32>((((((_e127 & 8388607u) | (_e132 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e145) & 31u))) + ((1u << bitcast<u32>(_e150)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e150))) ^ _e164) - _e164) + ((bitcast<i32>((((((_e168 & 8388607u) | (_e173 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e186) & 31u))) + ((1u << bitcast<u32>(_e191)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e191))) ^ _e205) - _e205)) - _e120)) << bitcast<u32>(((_e126 & 31u) & 31u)));
                    let _e219 = global_3.member[0u].member_1;
                    let _e221 = (_e215 >> bitcast<u32>(16i));
                    let _e222 = (_e215 & 65535u);
                    let _e224 = (_e219 >> bitcast<u32>(16i));
                    let _e225 = (_e219 & 65535u);
                    let _e230 = ((_e221 * _e225) + ((_e222 * _e225) >> bitcast<u32>(16i)));
                    let _e246 = ((((_e221 * _e224) + (_e230 >> bitcast<u32>(16i))) + (((_e222 * _e224) + (_e230 & 65535u)) >> bitcast<u32>(16i))) >> bitcast<u32>((((_e126 >> bitcast<u32>(16i)) & 31u) & 31u)));
                    let _e252 = global_3.member[0u].member[1u].member;
                    let _e258 = global_3.member[0u].member[1u].member_1;
                    let _e264 = global_3.member[0u].member[1u].member_2;
                    let _e265 = bitcast<u32>(select(_e80[1], _e87, (_e87 < _e80[1])));
                    let _e268 = ((_e265 >> bitcast<u32>(23i)) & 255u);
                    let _e270 = select(0u, 1u, (_e268 != 0u));
                    let _e279 = (_e252 - ((bitcast<i32>(_e268) - bitcast<i32>(_e270)) + -149i));
                    let _e280 = (_e279 < 0i);
                    if _e280 {
                        phi_424_ = -(_e279);
                    } else {
                        phi_424_ = 0i;
                    }
                    let _e283 = phi_424_;
                    if _e280 {
                        phi_434_ = 0i;
                    } else {
                        phi_434_ = select(_e279, 31i, (_e279 > 31i));
                    }
                    let _e287 = phi_434_;
                    let _e288 = (_e287 & 31i);
                    let _e302 = (bitcast<i32>(_e265) >> bitcast<u32>(31i));
                    let _e306 = bitcast<u32>(select(_e80[1], _e99, (_e99 > _e80[1])));
                    let _e309 = ((_e306 >> bitcast<u32>(23i)) & 255u);
                    let _e311 = select(0u, 1u, (_e309 != 0u));
                    let _e320 = (_e252 - ((bitcast<i32>(_e309) - bitcast<i32>(_e311)) + -149i));
                    let _e321 = (_e320 < 0i);
                    if _e321 {
                        phi_475_ = -(_e320);
                    } else {
                        phi_475_ = 0i;
                    }
                    let _e324 = phi_475_;
                    if _e321 {
                        phi_485_ = 0i;
                    } else {
                        phi_485_ = select(_e320, 31i, (_e320 > 31i));
                    }
                    let _e328 = phi_485_;
                    let _e329 = (_e328 & 31i);
                    let _e343 = (bitcast<i32>(_e306) >> bitcast<u32>(31i));
                    let _e353 = (bitcast<u32>(((((bitcast<i32>((((((_e265 & 8388607u) | (_e270 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e283) & 31u))) + ((1u << bitcast<u32>(_e288)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e288))) ^ _e302) - _e302) + ((bitcast<i32>((((((_e306 & 8388607u) | (_e311 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e324) & 31u))) + ((1u << bitcast<u32>(_e329)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e329))) ^ _e343) - _e343)) - _e258)) << bitcast<u32>(((_e264 & 31u) & 31u)));
                    let _e355 = (_e353 >> bitcast<u32>(16i));
                    let _e356 = (_e353 & 65535u);
                    let _e361 = ((_e355 * _e225) + ((_e356 * _e225) >> bitcast<u32>(16i)));
                    let _e377 = ((((_e355 * _e224) + (_e361 >> bitcast<u32>(16i))) + (((_e356 * _e224) + (_e361 & 65535u)) >> bitcast<u32>(16i))) >> bitcast<u32>((((_e264 >> bitcast<u32>(16i)) & 31u) & 31u)));
                    let _e383 = global_3.member[0u].member[2u].member;
                    let _e389 = global_3.member[0u].member[2u].member_1;
                    let _e395 = global_3.member[0u].member[2u].member_2;
                    let _e396 = bitcast<u32>(select(_e80[2], _e89, (_e89 < _e80[2])));
                    let _e399 = ((_e396 >> bitcast<u32>(23i)) & 255u);
                    let _e401 = select(0u, 1u, (_e399 != 0u));
                    let _e410 = (_e383 - ((bitcast<i32>(_e399) - bitcast<i32>(_e401)) + -149i));
                    let _e411 = (_e410 < 0i);
                    if _e411 {
                        phi_570_ = -(_e410);
                    } else {
                        phi_570_ = 0i;
                    }
                    let _e414 = phi_570_;
                    if _e411 {
                        phi_580_ = 0i;
                    } else {
                        phi_580_ = select(_e410, 31i, (_e410 > 31i));
                    }
                    let _e418 = phi_580_;
                    let _e419 = (_e418 & 31i);
                    let _e433 = (bitcast<i32>(_e396) >> bitcast<u32>(31i));
                    let _e437 = bitcast<u32>(select(_e80[2], _e101, (_e101 > _e80[2])));
                    let _e440 = ((_e437 >> bitcast<u32>(23i)) & 255u);
                    let _e442 = select(0u, 1u, (_e440 != 0u));
                    let _e451 = (_e383 - ((bitcast<i32>(_e440) - bitcast<i32>(_e442)) + -149i));
                    let _e452 = (_e451 < 0i);
                    if _e452 {
                        phi_621_ = -(_e451);
                    } else {
                        phi_621_ = 0i;
                    }
                    let _e455 = phi_621_;
                    if _e452 {
                        phi_631_ = 0i;
                    } else {
                        phi_631_ = select(_e451, 31i, (_e451 > 31i));
                    }
                    let _e459 = phi_631_;
                    let _e460 = (_e459 & 31i);
                    let _e474 = (bitcast<i32>(_e437) >> bitcast<u32>(31i));
                    let _e484 = (bitcast<u32>(((((bitcast<i32>((((((_e396 & 8388607u) | (_e401 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e414) & 31u))) + ((1u << bitcast<u32>(_e419)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e419))) ^ _e433) - _e433) + ((bitcast<i32>((((((_e437 & 8388607u) | (_e442 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e455) & 31u))) + ((1u << bitcast<u32>(_e460)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e460))) ^ _e474) - _e474)) - _e389)) << bitcast<u32>(((_e395 & 31u) & 31u)));
                    let _e486 = (_e484 >> bitcast<u32>(16i));
                    let _e487 = (_e484 & 65535u);
                    let _e492 = ((_e486 * _e225) + ((_e487 * _e225) >> bitcast<u32>(16i)));
                    let _e508 = ((((_e486 * _e224) + (_e492 >> bitcast<u32>(16i))) + (((_e487 * _e224) + (_e492 & 65535u)) >> bitcast<u32>(16i))) >> bitcast<u32>((((_e395 >> bitcast<u32>(16i)) & 31u) & 31u)));
                    let _e515 = ((_e246 >> bitcast<u32>(11i)) & 1023u);
                    let _e519 = ((_e515 | (_e515 << bitcast<u32>(16i))) & 50331903u);
                    let _e523 = ((_e519 | (_e519 << bitcast<u32>(8i))) & 50393103u);
                    let _e527 = ((_e523 | (_e523 << bitcast<u32>(4i))) & 51130563u);
                    let _e534 = ((_e377 >> bitcast<u32>(11i)) & 1023u);
                    let _e538 = ((_e534 | (_e534 << bitcast<u32>(16i))) & 50331903u);
                    let _e542 = ((_e538 | (_e538 << bitcast<u32>(8i))) & 50393103u);
                    let _e546 = ((_e542 | (_e542 << bitcast<u32>(4i))) & 51130563u);
                    let _e554 = ((_e508 >> bitcast<u32>(11i)) & 1023u);
                    let _e558 = ((_e554 | (_e554 << bitcast<u32>(16i))) & 50331903u);
                    let _e562 = ((_e558 | (_e558 << bitcast<u32>(8i))) & 50393103u);
                    let _e566 = ((_e562 | (_e562 << bitcast<u32>(4i))) & 51130563u);
                    let _e572 = (_e246 & 1023u);
                    let _e576 = ((_e572 | (_e572 << bitcast<u32>(16i))) & 50331903u);
                    let _e580 = ((_e576 | (_e576 << bitcast<u32>(8i))) & 50393103u);
                    let _e584 = ((_e580 | (_e580 << bitcast<u32>(4i))) & 51130563u);
                    let _e591 = (_e377 & 1023u);
                    let _e595 = ((_e591 | (_e591 << bitcast<u32>(16i))) & 50331903u);
                    let _e599 = ((_e595 | (_e595 << bitcast<u32>(8i))) & 50393103u);
                    let _e603 = ((_e599 | (_e599 << bitcast<u32>(4i))) & 51130563u);
                    let _e611 = (_e508 & 1023u);
                    let _e615 = ((_e611 | (_e611 << bitcast<u32>(16i))) & 50331903u);
                    let _e619 = ((_e615 | (_e615 << bitcast<u32>(8i))) & 50393103u);
                    let _e623 = ((_e619 | (_e619 << bitcast<u32>(4i))) & 51130563u);
                    if _e50 {
                    } else {
                        break;
                    }
                    global_4.member[_e49][0u] = (((((((_e527 | (_e527 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(2i)) | (((_e546 | (_e546 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(1i))) | ((_e566 | (_e566 << bitcast<u32>(2i))) & 153391689u)) << bitcast<u32>(1i)) | ((_e246 >> bitcast<u32>(10i)) & 1u));
                    global_4.member[_e49][1u] = (((((_e377 >> bitcast<u32>(10i)) & 1u) << bitcast<u32>(31i)) | (((_e508 >> bitcast<u32>(10i)) & 1u) << bitcast<u32>(30i))) | (((((_e584 | (_e584 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(2i)) | (((_e603 | (_e603 << bitcast<u32>(2i))) & 153391689u) << bitcast<u32>(1i))) | ((_e623 | (_e623 << bitcast<u32>(2i))) & 153391689u)));
                    global_4.member[_e49][2u] = _e49;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn morton_63_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
