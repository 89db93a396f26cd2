struct type_14 {
    member: array<vec4<u32>, 2>,
}

struct type_16 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
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
var<uniform> global_2: type_14;
@group(0) @binding(2) 
var<storage> global_3: type_27;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_18;

fn function_() {
    var phi_350_: i32;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_237_: bool;
    var phi_249_: bool;
    var phi_261_: bool;
    var phi_262_: bool;
    var phi_263_: bool;
    var phi_264_: bool;
    var phi_413_: bool;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_417_: bool;
    var phi_418_: bool;
    var phi_419_: bool;
    var phi_420_: bool;
    var phi_421_: bool;
    var phi_422_: bool;
    var phi_431_: bool;
    var phi_432_: bool;
    var phi_433_: bool;
    var phi_434_: bool;
    var phi_435_: bool;
    var phi_437_: bool;
    var phi_438_: bool;
    var phi_439_: bool;
    var phi_440_: bool;
    var phi_441_: bool;
    var phi_442_: bool;
    var phi_443_: bool;
    var phi_444_: bool;
    var phi_445_: bool;
    var phi_484_: i32;
    var phi_485_: i32;
    var phi_486_: i32;

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
                                        phi_431_ = true;
                                        phi_432_ = bool();
                                        phi_433_ = true;
                                    } else {
                                        let _e107 = bitcast<u32>(_e85);
                                        if ((_e107 & 2139095040u) != 2139095040u) {
                                            let _e110 = (_e85 < 0f);
                                            if _e110 {
                                                phi_416_ = bool();
                                                phi_417_ = bool();
                                                phi_418_ = false;
                                            } else {
                                                if (_e85 == 0f) {
                                                    if (_e81 < _e92[0]) {
                                                        phi_237_ = true;
                                                    } else {
                                                        phi_237_ = (_e81 > _e96[0]);
                                                    }
                                                    let _e217 = phi_237_;
                                                    if _e217 {
                                                        phi_263_ = bool();
                                                        phi_264_ = true;
                                                    } else {
                                                        if (_e82 < _e92[1]) {
                                                            phi_249_ = true;
                                                        } else {
                                                            phi_249_ = (_e82 > _e96[1]);
                                                        }
                                                        let _e223 = phi_249_;
                                                        if _e223 {
                                                            phi_262_ = bool();
                                                        } else {
                                                            if (_e83 < _e92[2]) {
                                                                phi_261_ = true;
                                                            } else {
                                                                phi_261_ = (_e83 > _e96[2]);
                                                            }
                                                            let _e229 = phi_261_;
                                                            phi_262_ = _e229;
                                                        }
                                                        let _e231 = phi_262_;
                                                        phi_263_ = _e231;
                                                        phi_264_ = _e223;
                                                    }
                                                    let _e233 = phi_263_;
                                                    let _e235 = phi_264_;
                                                    phi_413_ = select(_e233, true, _e235);
                                                    phi_414_ = bool();
                                                    phi_415_ = true;
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
                                                        phi_408_ = bool();
                                                        phi_409_ = true;
                                                    } else {
                                                        if (_e127 > _e139) {
                                                            phi_406_ = bool();
                                                            phi_407_ = true;
                                                        } else {
                                                            let _e142 = (_e135 > _e139);
                                                            if _e142 {
                                                                phi_405_ = bool();
                                                            } else {
                                                                let _e143 = (_e107 & 2147483647u);
                                                                if (_e143 >= 8388608u) {
                                                                    phi_350_ = (bitcast<i32>((_e143 >> bitcast<u32>(23i))) - 127i);
                                                                } else {
                                                                    phi_350_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e143)), 32u, (_e143 == 0u))));
                                                                }
                                                                let _e157 = phi_350_;
                                                                let _e158 = (-1i - _e157);
                                                                let _e159 = (_e158 / 2i);
                                                                let _e164 = bitcast<f32>((bitcast<u32>((_e159 + 127i)) << bitcast<u32>(23i)));
                                                                let _e170 = bitcast<f32>((bitcast<u32>(((_e158 - _e159) + 127i)) << bitcast<u32>(23i)));
                                                                let _e172 = ((_e119 * _e164) * _e170);
                                                                let _e174 = ((_e127 * _e164) * _e170);
                                                                let _e176 = ((_e135 * _e164) * _e170);
                                                                let _e178 = ((_e85 * _e164) * _e170);
                                                                phi_405_ = (((bitcast<f32>((bitcast<u32>((_e172 * _e172)) ^ _e72)) + bitcast<f32>((bitcast<u32>((_e174 * _e174)) ^ _e72))) + bitcast<f32>((bitcast<u32>((_e176 * _e176)) ^ _e72))) > bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>((_e178 * _e178)) ^ _e72)) * 1.000001f)) ^ _e72)));
                                                            }
                                                            let _e203 = phi_405_;
                                                            phi_406_ = _e203;
                                                            phi_407_ = _e142;
                                                        }
                                                        let _e205 = phi_406_;
                                                        let _e207 = phi_407_;
                                                        phi_408_ = _e205;
                                                        phi_409_ = _e207;
                                                    }
                                                    let _e209 = phi_408_;
                                                    let _e211 = phi_409_;
                                                    phi_413_ = true;
                                                    phi_414_ = _e209;
                                                    phi_415_ = _e211;
                                                }
                                                let _e238 = phi_413_;
                                                let _e240 = phi_414_;
                                                let _e242 = phi_415_;
                                                phi_416_ = _e238;
                                                phi_417_ = _e240;
                                                phi_418_ = _e242;
                                            }
                                            let _e244 = phi_416_;
                                            let _e246 = phi_417_;
                                            let _e248 = phi_418_;
                                            phi_419_ = _e244;
                                            phi_420_ = _e246;
                                            phi_421_ = _e110;
                                            phi_422_ = _e248;
                                        } else {
                                            phi_419_ = bool();
                                            phi_420_ = bool();
                                            phi_421_ = true;
                                            phi_422_ = false;
                                        }
                                        let _e250 = phi_419_;
                                        let _e252 = phi_420_;
                                        let _e254 = phi_421_;
                                        let _e256 = phi_422_;
                                        phi_431_ = select(_e250, false, _e254);
                                        phi_432_ = _e252;
                                        phi_433_ = select(_e256, true, _e254);
                                    }
                                    let _e260 = phi_431_;
                                    let _e262 = phi_432_;
                                    let _e264 = phi_433_;
                                    phi_434_ = _e260;
                                    phi_435_ = _e262;
                                    phi_437_ = _e264;
                                } else {
                                    phi_434_ = bool();
                                    phi_435_ = bool();
                                    phi_437_ = false;
                                }
                                let _e266 = phi_434_;
                                let _e268 = phi_435_;
                                let _e270 = phi_437_;
                                phi_438_ = _e266;
                                phi_439_ = _e268;
                                phi_440_ = select(true, false, _e105);
                                phi_441_ = _e270;
                            } else {
                                phi_438_ = bool();
                                phi_439_ = bool();
                                phi_440_ = true;
                                phi_441_ = false;
                            }
                            let _e273 = phi_438_;
                            let _e275 = phi_439_;
                            let _e277 = phi_440_;
                            let _e279 = phi_441_;
                            phi_442_ = _e273;
                            phi_443_ = _e275;
                            phi_444_ = _e277;
                            phi_445_ = _e279;
                        } else {
                            phi_442_ = bool();
                            phi_443_ = bool();
                            phi_444_ = true;
                            phi_445_ = false;
                        }
                        let _e281 = phi_442_;
                        let _e283 = phi_443_;
                        let _e285 = phi_444_;
                        let _e287 = phi_445_;
                        if select(_e283, select(_e281, false, _e285), select(_e287, true, _e285)) {
                            let _e294 = global_3.member[_e41].member_4;
                            if (_e294 == 0u) {
                                let _e299 = global_3.member[_e41].member_2;
                                let _e303 = global_3.member[_e41].member_3;
                                let _e304 = (2f * _e303);
                                if (_e299 > _e304) {
                                    phi_484_ = 1i;
                                } else {
                                    phi_484_ = select(0i, -1i, (-(_e299) > _e304));
                                }
                                let _e310 = phi_484_;
                                phi_485_ = _e310;
                            } else {
                                phi_485_ = 0i;
                            }
                            let _e312 = phi_485_;
                            phi_486_ = _e312;
                        } else {
                            phi_486_ = 0i;
                        }
                        let _e314 = phi_486_;
                        if _e48 {
                        } else {
                            break;
                        }
                        global_4.member[_e47] = _e314;
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
