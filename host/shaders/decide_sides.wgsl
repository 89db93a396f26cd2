struct type_13 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_15 {
    member: array<vec4<u32>, 2>,
}

struct type_18 {
    member: array<i32>,
}

struct type_21 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
    member_2: f32,
    member_3: f32,
    member_4: u32,
}

struct type_27 {
    member: array<type_25>,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_23;
@group(0) @binding(0) 
var<uniform> global_2: type_15;
@group(0) @binding(2) 
var<storage> global_3: type_27;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_18;

fn function_() {
    var phi_352_: i32;
    var phi_364_: i32;
    var phi_410_: bool;
    var phi_411_: bool;
    var phi_412_: bool;
    var phi_413_: bool;
    var phi_414_: bool;
    var phi_239_: bool;
    var phi_251_: bool;
    var phi_263_: bool;
    var phi_264_: bool;
    var phi_265_: bool;
    var phi_266_: bool;
    var phi_418_: bool;
    var phi_419_: bool;
    var phi_420_: bool;
    var phi_421_: bool;
    var phi_422_: bool;
    var phi_423_: bool;
    var phi_424_: bool;
    var phi_425_: bool;
    var phi_426_: bool;
    var phi_427_: bool;
    var phi_436_: bool;
    var phi_437_: bool;
    var phi_438_: bool;
    var phi_439_: bool;
    var phi_440_: bool;
    var phi_442_: bool;
    var phi_443_: bool;
    var phi_444_: bool;
    var phi_445_: bool;
    var phi_446_: bool;
    var phi_447_: bool;
    var phi_448_: bool;
    var phi_449_: bool;
    var phi_450_: bool;
    var phi_489_: i32;
    var phi_490_: i32;
    var phi_491_: i32;

    switch bitcast<i32>(0u) {
        default: {
            let _e31 = global;
            let _e41 = (_e31.x + (_e31.y * 2097152u));
            let _e42 = (_e41 < arrayLength((&global_1.member)));
            if _e42 {
                let _e43 = (_e41 < arrayLength((&global_3.member)));
                if _e43 {
                    if _e42 {
                    } else {
                        break;
                    }
                    let _e47 = global_1.member[_e41].member;
                    let _e48 = (_e47 < arrayLength((&global_4.member)));
                    if _e48 {
                        if _e43 {
                        } else {
                            break;
                        }
                        let _e52 = global_2.member[0u][0u];
                        let _e56 = global_2.member[0u][1u];
                        let _e60 = global_2.member[0u][2u];
                        let _e64 = global_2.member[0u][3u];
                        let _e68 = global_2.member[1u][0u];
                        let _e72 = global_2.member[1u][1u];
                        let _e76 = global_2.member[1u][2u];
                        let _e80 = global_2.member[1u][3u];
                        let _e81 = bitcast<f32>(_e52);
                        let _e82 = bitcast<f32>(_e56);
                        let _e83 = bitcast<f32>(_e60);
                        let _e85 = bitcast<f32>(_e68);
                        if (_e64 == 0u) {
                        }
                        let _e92 = global_3.member[_e41].member;
                        let _e96 = global_3.member[_e41].member_1;
                        if ((bitcast<u32>(_e81) & 2139095040u) != 2139095040u) {
                            if ((bitcast<u32>(_e82) & 2139095040u) != 2139095040u) {
                                let _e105 = ((bitcast<u32>(_e83) & 2139095040u) != 2139095040u);
                                if _e105 {
                                    if (_e64 == 0u) {
                                        phi_436_ = true;
                                        phi_437_ = bool();
                                        phi_438_ = true;
                                    } else {
                                        let _e107 = bitcast<u32>(_e85);
                                        if ((_e107 & 2139095040u) != 2139095040u) {
                                            let _e110 = (_e85 < 0f);
                                            if _e110 {
                                                phi_421_ = bool();
                                                phi_422_ = bool();
                                                phi_423_ = false;
                                            } else {
                                                if (_e85 == 0f) {
                                                    if (_e81 < _e92[0]) {
                                                        phi_239_ = true;
                                                    } else {
                                                        phi_239_ = (_e81 > _e96[0]);
                                                    }
                                                    let _e221 = phi_239_;
                                                    if _e221 {
                                                        phi_265_ = bool();
                                                        phi_266_ = true;
                                                    } else {
                                                        if (_e82 < _e92[1]) {
                                                            phi_251_ = true;
                                                        } else {
                                                            phi_251_ = (_e82 > _e96[1]);
                                                        }
                                                        let _e227 = phi_251_;
                                                        if _e227 {
                                                            phi_264_ = bool();
                                                        } else {
                                                            if (_e83 < _e92[2]) {
                                                                phi_263_ = true;
                                                            } else {
                                                                phi_263_ = (_e83 > _e96[2]);
                                                            }
                                                            let _e233 = phi_263_;
                                                            phi_264_ = _e233;
                                                        }
                                                        let _e235 = phi_264_;
                                                        phi_265_ = _e235;
                                                        phi_266_ = _e227;
                                                    }
                                                    let _e237 = phi_265_;
                                                    let _e239 = phi_266_;
                                                    phi_418_ = select(_e237, true, _e239);
                                                    phi_419_ = bool();
                                                    phi_420_ = true;
                                                } else {
                                                    let _e114 = (_e92[0] - _e81);
                                                    let _e115 = (_e81 - _e96[0]);
                                                    let _e117 = select(_e115, _e114, (_e114 > _e115));
                                                    let _e119 = select(0f, _e117, (_e117 > 0f));
                                                    let _e122 = (_e92[1] - _e82);
                                                    let _e123 = (_e82 - _e96[1]);
                                                    let _e125 = select(_e123, _e122, (_e122 > _e123));
                                                    let _e127 = select(0f, _e125, (_e125 > 0f));
                                                    let _e130 = (_e92[2] - _e83);
                                                    let _e131 = (_e83 - _e96[2]);
                                                    let _e133 = select(_e131, _e130, (_e130 > _e131));
                                                    let _e135 = select(0f, _e133, (_e133 > 0f));
                                                    let _e139 = bitcast<f32>((bitcast<u32>((_e85 * 1.0000005f)) ^ _e72));
                                                    if (_e119 > _e139) {
                                                        phi_413_ = bool();
                                                        phi_414_ = true;
                                                    } else {
                                                        if (_e127 > _e139) {
                                                            phi_411_ = bool();
                                                            phi_412_ = true;
                                                        } else {
                                                            let _e142 = (_e135 > _e139);
                                                            if _e142 {
                                                                phi_410_ = bool();
                                                            } else {
                                                                let _e143 = (_e107 & 2147483647u);
                                                                if (_e143 >= 8388608u) {
                                                                    phi_352_ = (bitcast<i32>((_e143 >> bitcast<u32>(23i))) - 127i);
                                                                } else {
                                                                    phi_352_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e143)), 32u, (_e143 == 0u))));
                                                                }
                                                                let _e157 = phi_352_;
                                                                let _e158 = (-1i - _e157);
                                                                if (_e158 < -126i) {
                                                                    phi_364_ = -126i;
                                                                } else {
                                                                    phi_364_ = select(_e158, 127i, (_e158 > 127i));
                                                                }
                                                                let _e163 = phi_364_;
                                                                let _e168 = bitcast<f32>((bitcast<u32>((_e163 + 127i)) << bitcast<u32>(23i)));
                                                                let _e174 = bitcast<f32>((bitcast<u32>(((_e158 - _e163) + 127i)) << bitcast<u32>(23i)));
                                                                let _e176 = ((_e119 * _e168) * _e174);
                                                                let _e178 = ((_e127 * _e168) * _e174);
                                                                let _e180 = ((_e135 * _e168) * _e174);
                                                                let _e182 = ((_e85 * _e168) * _e174);
                                                                phi_410_ = (((bitcast<f32>((bitcast<u32>((_e176 * _e176)) ^ _e72)) + bitcast<f32>((bitcast<u32>((_e178 * _e178)) ^ _e72))) + bitcast<f32>((bitcast<u32>((_e180 * _e180)) ^ _e72))) > bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>((_e182 * _e182)) ^ _e72)) * 1.000001f)) ^ _e72)));
                                                            }
                                                            let _e207 = phi_410_;
                                                            phi_411_ = _e207;
                                                            phi_412_ = _e142;
                                                        }
                                                        let _e209 = phi_411_;
                                                        let _e211 = phi_412_;
                                                        phi_413_ = _e209;
                                                        phi_414_ = _e211;
                                                    }
                                                    let _e213 = phi_413_;
                                                    let _e215 = phi_414_;
                                                    phi_418_ = true;
                                                    phi_419_ = _e213;
                                                    phi_420_ = _e215;
                                                }
                                                let _e242 = phi_418_;
                                                let _e244 = phi_419_;
                                                let _e246 = phi_420_;
                                                phi_421_ = _e242;
                                                phi_422_ = _e244;
                                                phi_423_ = _e246;
                                            }
                                            let _e248 = phi_421_;
                                            let _e250 = phi_422_;
                                            let _e252 = phi_423_;
                                            phi_424_ = _e248;
                                            phi_425_ = _e250;
                                            phi_426_ = _e110;
                                            phi_427_ = _e252;
                                        } else {
                                            phi_424_ = bool();
                                            phi_425_ = bool();
                                            phi_426_ = true;
                                            phi_427_ = false;
                                        }
                                        let _e254 = phi_424_;
                                        let _e256 = phi_425_;
                                        let _e258 = phi_426_;
                                        let _e260 = phi_427_;
                                        phi_436_ = select(_e254, false, _e258);
                                        phi_437_ = _e256;
                                        phi_438_ = select(_e260, true, _e258);
                                    }
                                    let _e264 = phi_436_;
                                    let _e266 = phi_437_;
                                    let _e268 = phi_438_;
                                    phi_439_ = _e264;
                                    phi_440_ = _e266;
                                    phi_442_ = _e268;
                                } else {
                                    phi_439_ = bool();
                                    phi_440_ = bool();
                                    phi_442_ = false;
                                }
                                let _e270 = phi_439_;
                                let _e272 = phi_440_;
                                let _e274 = phi_442_;
                                phi_443_ = _e270;
                                phi_444_ = _e272;
                                phi_445_ = select(true, false, _e105);
                                phi_446_ = _e274;
                            } else {
                                phi_443_ = bool();
                                phi_444_ = bool();
                                phi_445_ = true;
                                phi_446_ = false;
                            }
                            let _e277 = phi_443_;
                            let _e279 = phi_444_;
                            let _e281 = phi_445_;
                            let _e283 = phi_446_;
                            phi_447_ = _e277;
                            phi_448_ = _e279;
                            phi_449_ = _e281;
                            phi_450_ = _e283;
                        } else {
                            phi_447_ = bool();
                            phi_448_ = bool();
                            phi_449_ = true;
                            phi_450_ = false;
                        }
                        let _e285 = phi_447_;
                        let _e287 = phi_448_;
                        let _e289 = phi_449_;
                        let _e291 = phi_450_;
                        if select(_e287, select(_e285, false, _e289), select(_e291, true, _e289)) {
                            let _e298 = global_3.member[_e41].member_4;
                            if (_e298 == 0u) {
                                let _e303 = global_3.member[_e41].member_2;
                                let _e307 = global_3.member[_e41].member_3;
                                let _e308 = (2f * _e307);
                                if (_e303 > _e308) {
                                    phi_489_ = 1i;
                                } else {
                                    phi_489_ = select(0i, -1i, (-(_e303) > _e308));
                                }
                                let _e314 = phi_489_;
                                phi_490_ = _e314;
                            } else {
                                phi_490_ = 0i;
                            }
                            let _e316 = phi_490_;
                            phi_491_ = _e316;
                        } else {
                            phi_491_ = 0i;
                        }
                        let _e318 = phi_491_;
                        if _e48 {
                        } else {
                            break;
                        }
                        global_4.member[_e47] = _e318;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_sides(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
