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
    var phi_304_: type_13;
    var phi_473_: i32;
    var phi_485_: i32;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_360_: bool;
    var phi_372_: bool;
    var phi_384_: bool;
    var phi_385_: bool;
    var phi_386_: bool;
    var phi_387_: bool;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_673_: bool;
    var phi_674_: bool;
    var phi_675_: bool;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_679_: bool;
    var phi_680_: bool;
    var phi_681_: bool;
    var phi_682_: bool;
    var phi_683_: bool;
    var phi_684_: bool;
    var phi_685_: bool;
    var phi_686_: bool;
    var phi_687_: bool;
    var phi_726_: i32;
    var phi_727_: i32;
    var phi_728_: i32;

    switch bitcast<i32>(0u) {
        default: {
            let _e38 = global;
            let _e48 = (_e38.x + (_e38.y * 2097152u));
            let _e49 = (_e48 < arrayLength((&global_1.member)));
            if _e49 {
                let _e50 = (_e48 < arrayLength((&global_3.member)));
                if _e50 {
                    if _e49 {
                    } else {
                        break;
                    }
                    let _e54 = global_1.member[_e48].member;
                    let _e55 = (_e54 < arrayLength((&global_4.member)));
                    if _e55 {
                        if _e50 {
                        } else {
                            break;
                        }
                        let _e59 = global_2.member[0u][0u];
                        let _e63 = global_2.member[0u][1u];
                        let _e67 = global_2.member[0u][2u];
                        let _e71 = global_2.member[0u][3u];
                        let _e75 = global_2.member[1u][0u];
                        let _e79 = global_2.member[1u][1u];
                        let _e83 = global_2.member[1u][2u];
                        let _e87 = global_2.member[1u][3u];
                        let _e88 = bitcast<f32>(_e59);
                        let _e89 = bitcast<f32>(_e63);
                        let _e90 = bitcast<f32>(_e67);
                        let _e92 = bitcast<f32>(_e75);
                        let _e93 = array<u32, 3>(_e79, _e83, _e87);
                        if (_e71 == 0u) {
                            phi_304_ = type_13(array<f32, 3>(_e88, _e89, _e90), _e71, _e92, _e93);
                        } else {
                            let _e96 = bitcast<u32>(_e88);
                            let _e98 = ((_e96 & 2139095040u) != 0u);
                            let _e111 = bitcast<u32>(_e89);
                            let _e113 = ((_e111 & 2139095040u) != 0u);
                            let _e126 = bitcast<u32>(_e90);
                            let _e128 = ((_e126 & 2139095040u) != 0u);
                            let _e142 = bitcast<u32>(_e92);
                            let _e144 = ((_e142 & 2139095040u) != 0u);
                            phi_304_ = type_13(array<f32, 3>((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e96 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e96 & 2147483648u))), _e88, _e98) * select(0.00000011920929f, 1f, _e98)), (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e111 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e111 & 2147483648u))), _e89, _e113) * select(0.00000011920929f, 1f, _e113)), (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e126 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e126 & 2147483648u))), _e90, _e128) * select(0.00000011920929f, 1f, _e128))), _e71, (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e142 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e142 & 2147483648u))), _e92, _e144) * select(0.00000011920929f, 1f, _e144)), _e93);
                        }
                        let _e159 = phi_304_;
                        let _e163 = global_3.member[_e48].member;
                        let _e167 = global_3.member[_e48].member_1;
                        if ((bitcast<u32>(_e159.member[0]) & 2139095040u) != 2139095040u) {
                            if ((bitcast<u32>(_e159.member[1]) & 2139095040u) != 2139095040u) {
                                let _e180 = ((bitcast<u32>(_e159.member[2]) & 2139095040u) != 2139095040u);
                                if _e180 {
                                    if (_e159.member_1 == 0u) {
                                        phi_673_ = true;
                                        phi_674_ = bool();
                                        phi_675_ = true;
                                    } else {
                                        let _e186 = bitcast<u32>(_e159.member_2);
                                        let _e187 = (_e186 & 2139095040u);
                                        if (_e187 != 2139095040u) {
                                            let _e189 = (_e159.member_2 < 0f);
                                            if _e189 {
                                                phi_658_ = bool();
                                                phi_659_ = bool();
                                                phi_660_ = false;
                                            } else {
                                                if (_e159.member_2 == 0f) {
                                                    if (_e159.member[0] < _e163[0]) {
                                                        phi_360_ = true;
                                                    } else {
                                                        phi_360_ = (_e159.member[0] > _e167[0]);
                                                    }
                                                    let _e358 = phi_360_;
                                                    if _e358 {
                                                        phi_386_ = bool();
                                                        phi_387_ = true;
                                                    } else {
                                                        if (_e159.member[1] < _e163[1]) {
                                                            phi_372_ = true;
                                                        } else {
                                                            phi_372_ = (_e159.member[1] > _e167[1]);
                                                        }
                                                        let _e364 = phi_372_;
                                                        if _e364 {
                                                            phi_385_ = bool();
                                                        } else {
                                                            if (_e159.member[2] < _e163[2]) {
                                                                phi_384_ = true;
                                                            } else {
                                                                phi_384_ = (_e159.member[2] > _e167[2]);
                                                            }
                                                            let _e370 = phi_384_;
                                                            phi_385_ = _e370;
                                                        }
                                                        let _e372 = phi_385_;
                                                        phi_386_ = _e372;
                                                        phi_387_ = _e364;
                                                    }
                                                    let _e374 = phi_386_;
                                                    let _e376 = phi_387_;
                                                    phi_655_ = select(_e374, true, _e376);
                                                    phi_656_ = bool();
                                                    phi_657_ = true;
                                                } else {
                                                    let _e193 = (_e163[0] - _e159.member[0]);
                                                    let _e194 = (_e159.member[0] - _e167[0]);
                                                    let _e196 = select(_e194, _e193, (_e193 > _e194));
                                                    let _e198 = select(0f, _e196, (_e196 > 0f));
                                                    let _e201 = (_e163[1] - _e159.member[1]);
                                                    let _e202 = (_e159.member[1] - _e167[1]);
                                                    let _e204 = select(_e202, _e201, (_e201 > _e202));
                                                    let _e206 = select(0f, _e204, (_e204 > 0f));
                                                    let _e209 = (_e163[2] - _e159.member[2]);
                                                    let _e210 = (_e159.member[2] - _e167[2]);
                                                    let _e212 = select(_e210, _e209, (_e209 > _e210));
                                                    let _e214 = select(0f, _e212, (_e212 > 0f));
                                                    let _e218 = bitcast<f32>((bitcast<u32>((_e159.member_2 * 1.0000005f)) ^ _e159.member_3[0]));
                                                    if (_e198 > _e218) {
                                                        phi_650_ = bool();
                                                        phi_651_ = true;
                                                    } else {
                                                        if (_e206 > _e218) {
                                                            phi_648_ = bool();
                                                            phi_649_ = true;
                                                        } else {
                                                            let _e221 = (_e214 > _e218);
                                                            if _e221 {
                                                                phi_647_ = bool();
                                                            } else {
                                                                let _e222 = (_e186 & 2147483647u);
                                                                if (_e222 >= 8388608u) {
                                                                    phi_473_ = (bitcast<i32>((_e222 >> bitcast<u32>(23i))) - 127i);
                                                                } else {
                                                                    phi_473_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e222)), 32u, (_e222 == 0u))));
                                                                }
                                                                let _e236 = phi_473_;
                                                                let _e237 = (-1i - _e236);
                                                                if (_e237 < -126i) {
                                                                    phi_485_ = -126i;
                                                                } else {
                                                                    phi_485_ = select(_e237, 127i, (_e237 > 127i));
                                                                }
                                                                let _e242 = phi_485_;
                                                                let _e247 = bitcast<f32>((bitcast<u32>((_e242 + 127i)) << bitcast<u32>(23i)));
                                                                let _e253 = bitcast<f32>((bitcast<u32>(((_e237 - _e242) + 127i)) << bitcast<u32>(23i)));
                                                                let _e254 = bitcast<u32>(_e198);
                                                                let _e256 = ((_e254 & 2139095040u) != 0u);
                                                                let _e270 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e254 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e254 & 2147483648u))), _e198, _e256) * _e247) * select(0.00000011920929f, 1f, _e256)) * _e253);
                                                                let _e271 = bitcast<u32>(_e206);
                                                                let _e273 = ((_e271 & 2139095040u) != 0u);
                                                                let _e287 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e271 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e271 & 2147483648u))), _e206, _e273) * _e247) * select(0.00000011920929f, 1f, _e273)) * _e253);
                                                                let _e288 = bitcast<u32>(_e214);
                                                                let _e290 = ((_e288 & 2139095040u) != 0u);
                                                                let _e304 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e288 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e288 & 2147483648u))), _e214, _e290) * _e247) * select(0.00000011920929f, 1f, _e290)) * _e253);
                                                                let _e305 = (_e187 != 0u);
                                                                let _e319 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e186 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e186 & 2147483648u))), _e159.member_2, _e305) * _e247) * select(0.00000011920929f, 1f, _e305)) * _e253);
                                                                phi_647_ = (((bitcast<f32>((bitcast<u32>((_e270 * _e270)) ^ _e159.member_3[0])) + bitcast<f32>((bitcast<u32>((_e287 * _e287)) ^ _e159.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e304 * _e304)) ^ _e159.member_3[0]))) > bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>((_e319 * _e319)) ^ _e159.member_3[0])) * 1.000001f)) ^ _e159.member_3[0])));
                                                            }
                                                            let _e344 = phi_647_;
                                                            phi_648_ = _e344;
                                                            phi_649_ = _e221;
                                                        }
                                                        let _e346 = phi_648_;
                                                        let _e348 = phi_649_;
                                                        phi_650_ = _e346;
                                                        phi_651_ = _e348;
                                                    }
                                                    let _e350 = phi_650_;
                                                    let _e352 = phi_651_;
                                                    phi_655_ = true;
                                                    phi_656_ = _e350;
                                                    phi_657_ = _e352;
                                                }
                                                let _e379 = phi_655_;
                                                let _e381 = phi_656_;
                                                let _e383 = phi_657_;
                                                phi_658_ = _e379;
                                                phi_659_ = _e381;
                                                phi_660_ = _e383;
                                            }
                                            let _e385 = phi_658_;
                                            let _e387 = phi_659_;
                                            let _e389 = phi_660_;
                                            phi_661_ = _e385;
                                            phi_662_ = _e387;
                                            phi_663_ = _e189;
                                            phi_664_ = _e389;
                                        } else {
                                            phi_661_ = bool();
                                            phi_662_ = bool();
                                            phi_663_ = true;
                                            phi_664_ = false;
                                        }
                                        let _e391 = phi_661_;
                                        let _e393 = phi_662_;
                                        let _e395 = phi_663_;
                                        let _e397 = phi_664_;
                                        phi_673_ = select(_e391, false, _e395);
                                        phi_674_ = _e393;
                                        phi_675_ = select(_e397, true, _e395);
                                    }
                                    let _e401 = phi_673_;
                                    let _e403 = phi_674_;
                                    let _e405 = phi_675_;
                                    phi_676_ = _e401;
                                    phi_677_ = _e403;
                                    phi_679_ = _e405;
                                } else {
                                    phi_676_ = bool();
                                    phi_677_ = bool();
                                    phi_679_ = false;
                                }
                                let _e407 = phi_676_;
                                let _e409 = phi_677_;
                                let _e411 = phi_679_;
                                phi_680_ = _e407;
                                phi_681_ = _e409;
                                phi_682_ = select(true, false, _e180);
                                phi_683_ = _e411;
                            } else {
                                phi_680_ = bool();
                                phi_681_ = bool();
                                phi_682_ = true;
                                phi_683_ = false;
                            }
                            let _e414 = phi_680_;
                            let _e416 = phi_681_;
                            let _e418 = phi_682_;
                            let _e420 = phi_683_;
                            phi_684_ = _e414;
                            phi_685_ = _e416;
                            phi_686_ = _e418;
                            phi_687_ = _e420;
                        } else {
                            phi_684_ = bool();
                            phi_685_ = bool();
                            phi_686_ = true;
                            phi_687_ = false;
                        }
                        let _e422 = phi_684_;
                        let _e424 = phi_685_;
                        let _e426 = phi_686_;
                        let _e428 = phi_687_;
                        if select(_e424, select(_e422, false, _e426), select(_e428, true, _e426)) {
                            let _e435 = global_3.member[_e48].member_4;
                            if (_e435 == 0u) {
                                let _e440 = global_3.member[_e48].member_2;
                                let _e444 = global_3.member[_e48].member_3;
                                let _e445 = (2f * _e444);
                                if (_e440 > _e445) {
                                    phi_726_ = 1i;
                                } else {
                                    phi_726_ = select(0i, -1i, (-(_e440) > _e445));
                                }
                                let _e451 = phi_726_;
                                phi_727_ = _e451;
                            } else {
                                phi_727_ = 0i;
                            }
                            let _e453 = phi_727_;
                            phi_728_ = _e453;
                        } else {
                            phi_728_ = 0i;
                        }
                        let _e455 = phi_728_;
                        if _e55 {
                        } else {
                            break;
                        }
                        global_4.member[_e54] = _e455;
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
