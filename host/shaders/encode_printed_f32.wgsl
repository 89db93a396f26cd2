struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: vec4<u32>,
}

struct type_19 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_21 {
    member: array<type_19>,
}

struct type_24 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_28 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_30 {
    member: array<type_28>,
}

struct type_33 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_35 {
    member: array<type_33>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_9;
@group(0) @binding(1) 
var<uniform> global_2: type_9;
@group(0) @binding(2) 
var<storage> global_3: type_21;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_35;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_30;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;
    var local_3: array<f32, 3>;
    var local_4: array<f32, 3>;
    var local_5: array<f32, 3>;
    var local_6: array<f32, 3>;
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 3>;
    var local_12: array<u32, 3>;
    var phi_158_: type_19;
    var phi_176_: type_24;
    var phi_194_: type_24;
    var phi_2169_: bool;
    var phi_257_: type_4;
    var phi_260_: u32;
    var phi_258_: type_4;
    var phi_283_: type_4;
    var phi_305_: type_19;
    var phi_314_: bool;
    var phi_332_: type_24;
    var phi_350_: type_24;
    var phi_354_: type_24;
    var phi_377_: type_4;
    var phi_380_: array<u32, 2>;
    var phi_378_: type_4;
    var phi_403_: type_4;
    var phi_442_: f32;
    var phi_493_: u32;
    var phi_495_: u32;
    var phi_496_: bool;
    var phi_534_: u32;
    var phi_535_: u32;
    var phi_587_: f32;
    var phi_638_: u32;
    var phi_640_: u32;
    var phi_641_: bool;
    var phi_679_: u32;
    var phi_680_: u32;
    var phi_741_: u32;
    var phi_743_: u32;
    var phi_744_: bool;
    var phi_381_: array<u32, 2>;
    var phi_2159_: bool;
    var phi_762_: type_4;
    var phi_763_: type_4;
    var phi_786_: type_4;
    var local_13: array<u32, 2>;
    var local_14: array<u32, 2>;
    var phi_2214_: bool;
    var phi_2224_: bool;
    var phi_912_: u32;
    var phi_2223_: bool;
    var phi_261_: u32;
    var phi_914_: bool;
    var phi_2222_: bool;
    var phi_965_: type_24;
    var phi_987_: type_24;
    var phi_1031_: type_4;
    var phi_1034_: array<u32, 2>;
    var phi_1032_: type_4;
    var phi_1057_: type_4;
    var phi_1096_: f32;
    var phi_1147_: u32;
    var phi_1149_: u32;
    var phi_1150_: bool;
    var phi_1188_: u32;
    var phi_1189_: u32;
    var phi_1241_: f32;
    var phi_1292_: u32;
    var phi_1294_: u32;
    var phi_1295_: bool;
    var phi_1333_: u32;
    var phi_1334_: u32;
    var phi_1395_: u32;
    var phi_1397_: u32;
    var phi_1398_: bool;
    var phi_1035_: array<u32, 2>;
    var phi_2226_: bool;
    var phi_1411_: type_4;
    var phi_1414_: array<u32, 2>;
    var phi_1412_: type_4;
    var phi_1437_: type_4;
    var phi_1476_: f32;
    var phi_1527_: u32;
    var phi_1529_: u32;
    var phi_1530_: bool;
    var phi_1568_: u32;
    var phi_1569_: u32;
    var phi_1621_: f32;
    var phi_1672_: u32;
    var phi_1674_: u32;
    var phi_1675_: bool;
    var phi_1713_: u32;
    var phi_1714_: u32;
    var phi_1775_: u32;
    var phi_1777_: u32;
    var phi_1778_: bool;
    var phi_1415_: array<u32, 2>;
    var phi_2267_: bool;
    var local_15: array<u32, 2>;
    var local_16: array<u32, 2>;
    var phi_1801_: type_4;
    var phi_1802_: type_4;
    var phi_1825_: type_4;
    var phi_2306_: bool;
    var phi_1931_: type_4;
    var phi_1932_: type_4;
    var phi_1955_: type_4;
    var phi_2310_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e52 = global;
            let _e54 = arrayLength((&global_3.member));
            let _e58 = arrayLength((&global_5.member));
            let _e62 = (_e52.x + (_e52.y * 2097152u));
            let _e65 = global_1.member[0u];
            if (_e62 < _e65) {
                let _e67 = (_e62 < _e54);
                if _e67 {
                    let _e68 = (_e62 < arrayLength((&global_4.member)));
                    if _e68 {
                        let _e71 = global_2.member[0u];
                        let _e72 = (0u < _e54);
                        if _e72 {
                            if _e72 {
                            } else {
                                break;
                            }
                            let _e75 = global_3.member[0u];
                            phi_158_ = _e75;
                        } else {
                            phi_158_ = type_19(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e77 = phi_158_;
                        if (_e77.member_1 == 2147483648u) {
                            phi_176_ = type_24(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            phi_176_ = type_24(vec3<f32>(_e77.member[0][0], _e77.member[1][0], _e77.member[2][0]), vec3<f32>(_e77.member[0][2], _e77.member[1][2], _e77.member[2][2]));
                        }
                        let _e96 = phi_176_;
                        if (_e77.member_2 == 2147483648u) {
                            phi_194_ = _e96;
                        } else {
                            phi_194_ = type_24(vec3<f32>(_e77.member[0][1], _e77.member[1][1], _e77.member[2][1]), vec3<f32>(_e77.member[0][3], _e77.member[1][3], _e77.member[2][3]));
                        }
                        let _e115 = phi_194_;
                        local_3 = array<f32, 3>(select(_e115.member.x, _e96.member.x, (_e96.member.x < _e115.member.x)), select(_e115.member.y, _e96.member.y, (_e96.member.y < _e115.member.y)), select(_e115.member.z, _e96.member.z, (_e96.member.z < _e115.member.z)));
                        local_2 = array<f32, 3>(select(_e115.member_1.x, _e96.member_1.x, (_e96.member_1.x > _e115.member_1.x)), select(_e115.member_1.y, _e96.member_1.y, (_e96.member_1.y > _e115.member_1.y)), select(_e115.member_1.z, _e96.member_1.z, (_e96.member_1.z > _e115.member_1.z)));
                        phi_2169_ = false;
                        phi_257_ = type_4(0u, 128u);
                        phi_260_ = 0u;
                        loop {
                            let _e147 = phi_2169_;
                            let _e149 = phi_257_;
                            let _e151 = phi_260_;
                            if (_e149.member < _e149.member_1) {
                                phi_258_ = type_4((_e149.member + 1u), _e149.member_1);
                                phi_283_ = type_4(1u, _e149.member);
                            } else {
                                phi_258_ = _e149;
                                phi_283_ = type_4(0u, type_4().member_1);
                            }
                            let _e164 = phi_258_;
                            let _e166 = phi_283_;
                            if (bitcast<i32>(_e166.member) != 0i) {
                                let _e170 = (_e151 == _e62);
                                if _e170 {
                                    phi_2224_ = _e147;
                                    phi_912_ = u32();
                                } else {
                                    let _e171 = (_e151 < _e54);
                                    if _e171 {
                                        if _e171 {
                                        } else {
                                            phi_2222_ = true;
                                            break;
                                        }
                                        let _e174 = global_3.member[_e151];
                                        phi_305_ = _e174;
                                    } else {
                                        phi_305_ = type_19(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e176 = phi_305_;
                                    if ((_e176.member_1 & 2147483648u) != 0u) {
                                        phi_314_ = false;
                                    } else {
                                        phi_314_ = (_e62 <= _e176.member_1);
                                    }
                                    let _e183 = phi_314_;
                                    if (_e176.member_1 == 2147483648u) {
                                        phi_332_ = type_24(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                    } else {
                                        phi_332_ = type_24(vec3<f32>(_e176.member[0][0], _e176.member[1][0], _e176.member[2][0]), vec3<f32>(_e176.member[0][2], _e176.member[1][2], _e176.member[2][2]));
                                    }
                                    let _e201 = phi_332_;
                                    if (_e176.member_2 == 2147483648u) {
                                        phi_350_ = _e201;
                                    } else {
                                        phi_350_ = type_24(vec3<f32>(_e176.member[0][1], _e176.member[1][1], _e176.member[2][1]), vec3<f32>(_e176.member[0][3], _e176.member[1][3], _e176.member[2][3]));
                                    }
                                    let _e219 = phi_350_;
                                    if _e183 {
                                        phi_354_ = _e201;
                                    } else {
                                        phi_354_ = _e219;
                                    }
                                    let _e221 = phi_354_;
                                    local_5 = array<f32, 3>(_e221.member.x, _e221.member.y, _e221.member.z);
                                    local_4 = array<f32, 3>(_e221.member_1.x, _e221.member_1.y, _e221.member_1.z);
                                    phi_377_ = type_4(0u, 3u);
                                    phi_380_ = array<u32, 2>(0u, 0u);
                                    loop {
                                        let _e237 = phi_377_;
                                        let _e239 = phi_380_;
                                        local_13 = _e239;
                                        local_14 = _e239;
                                        if (_e237.member < _e237.member_1) {
                                            phi_378_ = type_4((_e237.member + 1u), _e237.member_1);
                                            phi_403_ = type_4(1u, _e237.member);
                                        } else {
                                            phi_378_ = _e237;
                                            phi_403_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e252 = phi_378_;
                                        let _e254 = phi_403_;
                                        let _e258 = (bitcast<i32>(_e254.member) != 0i);
                                        if _e258 {
                                            let _e259 = (_e254.member_1 < 3u);
                                            if _e259 {
                                            } else {
                                                phi_2159_ = true;
                                                break;
                                            }
                                            let _e261 = local_3[_e254.member_1];
                                            if _e259 {
                                            } else {
                                                phi_2159_ = true;
                                                break;
                                            }
                                            let _e263 = local_2[_e254.member_1];
                                            if _e259 {
                                            } else {
                                                phi_2159_ = true;
                                                break;
                                            }
                                            let _e265 = local_5[_e254.member_1];
                                            let _e266 = (_e263 - _e261);
                                            let _e267 = (_e266 > 0f);
                                            if _e267 {
                                                phi_442_ = (((_e265 - _e261) / _e266) * 1023f);
                                            } else {
                                                phi_442_ = 0f;
                                            }
                                            let _e272 = phi_442_;
                                            let _e274 = select(1023f, _e272, (_e272 < 1023f));
                                            let _e276 = select(0f, _e274, (_e274 > 0f));
                                            let _e281 = select(select(u32(_e276), 0u, (_e276 < 0f)), 4294967295u, (_e276 > 4294967000f));
                                            if (_e281 > 0u) {
                                                let _e292 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e281) * bitcast<f32>((bitcast<u32>((_e266 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                                let _e297 = (select(select(_e263, _e292, (_e292 < _e263)), _e263, (_e281 == 1023u)) > _e265);
                                                if _e297 {
                                                    phi_493_ = (_e281 - 1u);
                                                } else {
                                                    phi_493_ = u32();
                                                }
                                                let _e300 = phi_493_;
                                                phi_495_ = _e300;
                                                phi_496_ = select(true, false, _e297);
                                            } else {
                                                phi_495_ = u32();
                                                phi_496_ = true;
                                            }
                                            let _e303 = phi_495_;
                                            let _e305 = phi_496_;
                                            if _e305 {
                                                if (_e281 < 1023u) {
                                                    let _e307 = (_e281 + 1u);
                                                    let _e317 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e307) * bitcast<f32>((bitcast<u32>((_e266 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                                    phi_534_ = select(_e281, _e307, (select(select(_e263, _e317, (_e317 < _e263)), _e263, (_e307 == 1023u)) <= _e265));
                                                } else {
                                                    phi_534_ = _e281;
                                                }
                                                let _e325 = phi_534_;
                                                phi_535_ = _e325;
                                            } else {
                                                phi_535_ = _e303;
                                            }
                                            let _e327 = phi_535_;
                                            let _e331 = bitcast<f32>((bitcast<u32>((_e266 * 0.0009775171f)) ^ _e71));
                                            let _e337 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e327) * _e331)) ^ _e71)));
                                            let _e345 = ((10u * _e254.member_1) & 31u);
                                            if _e259 {
                                            } else {
                                                phi_2159_ = true;
                                                break;
                                            }
                                            let _e351 = local_4[_e254.member_1];
                                            if _e267 {
                                                phi_587_ = (((_e351 - _e261) / _e266) * 1023f);
                                            } else {
                                                phi_587_ = 0f;
                                            }
                                            let _e356 = phi_587_;
                                            let _e358 = select(1023f, _e356, (_e356 < 1023f));
                                            let _e360 = select(0f, _e358, (_e358 > 0f));
                                            let _e365 = select(select(u32(_e360), 0u, (_e360 < 0f)), 4294967295u, (_e360 > 4294967000f));
                                            if (_e365 > 0u) {
                                                let _e372 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e365) * _e331)) ^ _e71)));
                                                let _e377 = (select(select(_e263, _e372, (_e372 < _e263)), _e263, (_e365 == 1023u)) > _e351);
                                                if _e377 {
                                                    phi_638_ = (_e365 - 1u);
                                                } else {
                                                    phi_638_ = u32();
                                                }
                                                let _e380 = phi_638_;
                                                phi_640_ = _e380;
                                                phi_641_ = select(true, false, _e377);
                                            } else {
                                                phi_640_ = u32();
                                                phi_641_ = true;
                                            }
                                            let _e383 = phi_640_;
                                            let _e385 = phi_641_;
                                            if _e385 {
                                                if (_e365 < 1023u) {
                                                    let _e387 = (_e365 + 1u);
                                                    let _e393 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e387) * _e331)) ^ _e71)));
                                                    phi_679_ = select(_e365, _e387, (select(select(_e263, _e393, (_e393 < _e263)), _e263, (_e387 == 1023u)) <= _e351));
                                                } else {
                                                    phi_679_ = _e365;
                                                }
                                                let _e401 = phi_679_;
                                                phi_680_ = _e401;
                                            } else {
                                                phi_680_ = _e383;
                                            }
                                            let _e403 = phi_680_;
                                            let _e409 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e403) * _e331)) ^ _e71)));
                                            let _e415 = select(_e403, 0u, (select(select(_e263, _e409, (_e409 < _e263)), _e263, (_e403 == 1023u)) > _e351));
                                            if (_e415 < 1023u) {
                                                let _e422 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e415) * _e331)) ^ _e71)));
                                                let _e427 = (select(select(_e263, _e422, (_e422 < _e263)), _e263, (_e415 == 1023u)) < _e351);
                                                if _e427 {
                                                    phi_741_ = (_e415 + 1u);
                                                } else {
                                                    phi_741_ = u32();
                                                }
                                                let _e430 = phi_741_;
                                                phi_743_ = _e430;
                                                phi_744_ = select(true, false, _e427);
                                            } else {
                                                phi_743_ = u32();
                                                phi_744_ = true;
                                            }
                                            let _e433 = phi_743_;
                                            let _e435 = phi_744_;
                                            phi_381_ = array<u32, 2>((_e239[0] | (select(_e327, 0u, (select(select(_e263, _e337, (_e337 < _e263)), _e263, (_e327 == 1023u)) > _e265)) << bitcast<u32>(_e345))), (_e239[1] | (select(_e433, _e415, _e435) << bitcast<u32>(_e345))));
                                        } else {
                                            phi_381_ = array<u32, 2>();
                                        }
                                        let _e443 = phi_381_;
                                        continue;
                                        continuing {
                                            phi_377_ = _e252;
                                            phi_380_ = _e443;
                                            phi_2159_ = _e147;
                                            break if !(_e258);
                                        }
                                    }
                                    let _e446 = phi_2159_;
                                    phi_2222_ = _e446;
                                    if _e446 {
                                        break;
                                    }
                                    local_12 = array<u32, 3>(0u, 1u, 2u);
                                    local_7 = array<f32, 3>(0f, 0f, 0f);
                                    local_6 = array<f32, 3>(0f, 0f, 0f);
                                    phi_762_ = type_4(0u, 3u);
                                    loop {
                                        let _e448 = phi_762_;
                                        if (_e448.member < _e448.member_1) {
                                            phi_763_ = type_4((_e448.member + 1u), _e448.member_1);
                                            phi_786_ = type_4(1u, _e448.member);
                                        } else {
                                            phi_763_ = _e448;
                                            phi_786_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e461 = phi_763_;
                                        let _e463 = phi_786_;
                                        let _e467 = (bitcast<i32>(_e463.member) != 0i);
                                        if _e467 {
                                            let _e468 = (_e463.member_1 < 3u);
                                            if _e468 {
                                            } else {
                                                phi_2214_ = true;
                                                break;
                                            }
                                            let _e470 = local_12[_e463.member_1];
                                            if _e468 {
                                            } else {
                                                phi_2214_ = true;
                                                break;
                                            }
                                            let _e472 = local_3[_e463.member_1];
                                            if _e468 {
                                            } else {
                                                phi_2214_ = true;
                                                break;
                                            }
                                            let _e474 = local_2[_e463.member_1];
                                            let _e476 = local_13;
                                            let _e479 = ((10u * _e470) & 31u);
                                            let _e482 = ((_e476[0] >> bitcast<u32>(_e479)) & 1023u);
                                            let _e487 = bitcast<f32>((bitcast<u32>(((_e474 - _e472) * 0.0009775171f)) ^ _e71));
                                            let _e493 = (_e472 + bitcast<f32>((bitcast<u32>((f32(_e482) * _e487)) ^ _e71)));
                                            if _e468 {
                                            } else {
                                                phi_2214_ = true;
                                                break;
                                            }
                                            local_7[_e463.member_1] = select(select(_e474, _e493, (_e493 < _e474)), _e474, (_e482 == 1023u));
                                            let _e500 = local_14;
                                            let _e504 = ((_e500[1] >> bitcast<u32>(_e479)) & 1023u);
                                            let _e510 = (_e472 + bitcast<f32>((bitcast<u32>((f32(_e504) * _e487)) ^ _e71)));
                                            if _e468 {
                                            } else {
                                                phi_2214_ = true;
                                                break;
                                            }
                                            local_6[_e463.member_1] = select(select(_e474, _e510, (_e510 < _e474)), _e474, (_e504 == 1023u));
                                        }
                                        continue;
                                        continuing {
                                            phi_762_ = _e461;
                                            phi_2214_ = _e446;
                                            break if !(_e467);
                                        }
                                    }
                                    let _e518 = phi_2214_;
                                    phi_2222_ = _e518;
                                    if _e518 {
                                        break;
                                    }
                                    let _e519 = local_6;
                                    let _e520 = local_7;
                                    local_3 = _e520;
                                    local_2 = _e519;
                                    phi_2224_ = _e518;
                                    phi_912_ = select(_e176.member_2, _e176.member_1, _e183);
                                }
                                let _e523 = phi_2224_;
                                let _e525 = phi_912_;
                                phi_2223_ = _e523;
                                phi_261_ = _e525;
                                phi_914_ = select(true, false, _e170);
                            } else {
                                phi_2223_ = _e147;
                                phi_261_ = u32();
                                phi_914_ = false;
                            }
                            let _e528 = phi_2223_;
                            let _e530 = phi_261_;
                            let _e532 = phi_914_;
                            continue;
                            continuing {
                                phi_2169_ = _e528;
                                phi_257_ = _e164;
                                phi_260_ = _e530;
                                phi_2222_ = _e528;
                                break if !(_e532);
                            }
                        }
                        let _e535 = phi_2222_;
                        if _e535 {
                            break;
                        }
                        let _e536 = local_2;
                        let _e537 = local_3;
                        local_1 = _e537;
                        local = _e536;
                        if _e67 {
                        } else {
                            break;
                        }
                        let _e541 = global_3.member[_e62].member_1;
                        if (_e541 == 2147483648u) {
                            phi_965_ = type_24(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            let _e547 = global_3.member[_e62].member[0u];
                            let _e552 = global_3.member[_e62].member[1u];
                            let _e557 = global_3.member[_e62].member[2u];
                            phi_965_ = type_24(vec3<f32>(_e547[0], _e552[0], _e557[0]), vec3<f32>(_e547[2], _e552[2], _e557[2]));
                        }
                        let _e568 = phi_965_;
                        let _e572 = global_3.member[_e62].member_2;
                        if (_e572 == 2147483648u) {
                            phi_987_ = _e568;
                        } else {
                            let _e578 = global_3.member[_e62].member[0u];
                            let _e583 = global_3.member[_e62].member[1u];
                            let _e588 = global_3.member[_e62].member[2u];
                            phi_987_ = type_24(vec3<f32>(_e578[1], _e583[1], _e588[1]), vec3<f32>(_e578[3], _e583[3], _e588[3]));
                        }
                        let _e599 = phi_987_;
                        local_11 = array<f32, 3>(_e568.member.x, _e568.member.y, _e568.member.z);
                        local_10 = array<f32, 3>(_e568.member_1.x, _e568.member_1.y, _e568.member_1.z);
                        local_9 = array<f32, 3>(_e599.member.x, _e599.member.y, _e599.member.z);
                        local_8 = array<f32, 3>(_e599.member_1.x, _e599.member_1.y, _e599.member_1.z);
                        phi_1031_ = type_4(0u, 3u);
                        phi_1034_ = array<u32, 2>(0u, 0u);
                        loop {
                            let _e629 = phi_1031_;
                            let _e631 = phi_1034_;
                            local_15 = _e631;
                            if (_e629.member < _e629.member_1) {
                                phi_1032_ = type_4((_e629.member + 1u), _e629.member_1);
                                phi_1057_ = type_4(1u, _e629.member);
                            } else {
                                phi_1032_ = _e629;
                                phi_1057_ = type_4(0u, type_4().member_1);
                            }
                            let _e644 = phi_1032_;
                            let _e646 = phi_1057_;
                            let _e650 = (bitcast<i32>(_e646.member) != 0i);
                            if _e650 {
                                let _e651 = (_e646.member_1 < 3u);
                                if _e651 {
                                } else {
                                    phi_2226_ = true;
                                    break;
                                }
                                let _e653 = local_1[_e646.member_1];
                                if _e651 {
                                } else {
                                    phi_2226_ = true;
                                    break;
                                }
                                let _e655 = local[_e646.member_1];
                                if _e651 {
                                } else {
                                    phi_2226_ = true;
                                    break;
                                }
                                let _e657 = local_11[_e646.member_1];
                                let _e658 = (_e655 - _e653);
                                let _e659 = (_e658 > 0f);
                                if _e659 {
                                    phi_1096_ = (((_e657 - _e653) / _e658) * 1023f);
                                } else {
                                    phi_1096_ = 0f;
                                }
                                let _e664 = phi_1096_;
                                let _e666 = select(1023f, _e664, (_e664 < 1023f));
                                let _e668 = select(0f, _e666, (_e666 > 0f));
                                let _e673 = select(select(u32(_e668), 0u, (_e668 < 0f)), 4294967295u, (_e668 > 4294967000f));
                                if (_e673 > 0u) {
                                    let _e684 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e673) * bitcast<f32>((bitcast<u32>((_e658 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                    let _e689 = (select(select(_e655, _e684, (_e684 < _e655)), _e655, (_e673 == 1023u)) > _e657);
                                    if _e689 {
                                        phi_1147_ = (_e673 - 1u);
                                    } else {
                                        phi_1147_ = u32();
                                    }
                                    let _e692 = phi_1147_;
                                    phi_1149_ = _e692;
                                    phi_1150_ = select(true, false, _e689);
                                } else {
                                    phi_1149_ = u32();
                                    phi_1150_ = true;
                                }
                                let _e695 = phi_1149_;
                                let _e697 = phi_1150_;
                                if _e697 {
                                    if (_e673 < 1023u) {
                                        let _e699 = (_e673 + 1u);
                                        let _e709 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e699) * bitcast<f32>((bitcast<u32>((_e658 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                        phi_1188_ = select(_e673, _e699, (select(select(_e655, _e709, (_e709 < _e655)), _e655, (_e699 == 1023u)) <= _e657));
                                    } else {
                                        phi_1188_ = _e673;
                                    }
                                    let _e717 = phi_1188_;
                                    phi_1189_ = _e717;
                                } else {
                                    phi_1189_ = _e695;
                                }
                                let _e719 = phi_1189_;
                                let _e723 = bitcast<f32>((bitcast<u32>((_e658 * 0.0009775171f)) ^ _e71));
                                let _e729 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e719) * _e723)) ^ _e71)));
                                let _e737 = ((10u * _e646.member_1) & 31u);
                                if _e651 {
                                } else {
                                    phi_2226_ = true;
                                    break;
                                }
                                let _e743 = local_10[_e646.member_1];
                                if _e659 {
                                    phi_1241_ = (((_e743 - _e653) / _e658) * 1023f);
                                } else {
                                    phi_1241_ = 0f;
                                }
                                let _e748 = phi_1241_;
                                let _e750 = select(1023f, _e748, (_e748 < 1023f));
                                let _e752 = select(0f, _e750, (_e750 > 0f));
                                let _e757 = select(select(u32(_e752), 0u, (_e752 < 0f)), 4294967295u, (_e752 > 4294967000f));
                                if (_e757 > 0u) {
                                    let _e764 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e757) * _e723)) ^ _e71)));
                                    let _e769 = (select(select(_e655, _e764, (_e764 < _e655)), _e655, (_e757 == 1023u)) > _e743);
                                    if _e769 {
                                        phi_1292_ = (_e757 - 1u);
                                    } else {
                                        phi_1292_ = u32();
                                    }
                                    let _e772 = phi_1292_;
                                    phi_1294_ = _e772;
                                    phi_1295_ = select(true, false, _e769);
                                } else {
                                    phi_1294_ = u32();
                                    phi_1295_ = true;
                                }
                                let _e775 = phi_1294_;
                                let _e777 = phi_1295_;
                                if _e777 {
                                    if (_e757 < 1023u) {
                                        let _e779 = (_e757 + 1u);
                                        let _e785 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e779) * _e723)) ^ _e71)));
                                        phi_1333_ = select(_e757, _e779, (select(select(_e655, _e785, (_e785 < _e655)), _e655, (_e779 == 1023u)) <= _e743));
                                    } else {
                                        phi_1333_ = _e757;
                                    }
                                    let _e793 = phi_1333_;
                                    phi_1334_ = _e793;
                                } else {
                                    phi_1334_ = _e775;
                                }
                                let _e795 = phi_1334_;
                                let _e801 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e795) * _e723)) ^ _e71)));
                                let _e807 = select(_e795, 0u, (select(select(_e655, _e801, (_e801 < _e655)), _e655, (_e795 == 1023u)) > _e743));
                                if (_e807 < 1023u) {
                                    let _e814 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e807) * _e723)) ^ _e71)));
                                    let _e819 = (select(select(_e655, _e814, (_e814 < _e655)), _e655, (_e807 == 1023u)) < _e743);
                                    if _e819 {
                                        phi_1395_ = (_e807 + 1u);
                                    } else {
                                        phi_1395_ = u32();
                                    }
                                    let _e822 = phi_1395_;
                                    phi_1397_ = _e822;
                                    phi_1398_ = select(true, false, _e819);
                                } else {
                                    phi_1397_ = u32();
                                    phi_1398_ = true;
                                }
                                let _e825 = phi_1397_;
                                let _e827 = phi_1398_;
                                phi_1035_ = array<u32, 2>((_e631[0] | (select(_e719, 0u, (select(select(_e655, _e729, (_e729 < _e655)), _e655, (_e719 == 1023u)) > _e657)) << bitcast<u32>(_e737))), (_e631[1] | (select(_e825, _e807, _e827) << bitcast<u32>(_e737))));
                            } else {
                                phi_1035_ = array<u32, 2>();
                            }
                            let _e835 = phi_1035_;
                            continue;
                            continuing {
                                phi_1031_ = _e644;
                                phi_1034_ = _e835;
                                phi_2226_ = _e535;
                                break if !(_e650);
                            }
                        }
                        let _e838 = phi_2226_;
                        if _e838 {
                            break;
                        }
                        phi_1411_ = type_4(0u, 3u);
                        phi_1414_ = array<u32, 2>(0u, 0u);
                        loop {
                            let _e840 = phi_1411_;
                            let _e842 = phi_1414_;
                            local_16 = _e842;
                            if (_e840.member < _e840.member_1) {
                                phi_1412_ = type_4((_e840.member + 1u), _e840.member_1);
                                phi_1437_ = type_4(1u, _e840.member);
                            } else {
                                phi_1412_ = _e840;
                                phi_1437_ = type_4(0u, type_4().member_1);
                            }
                            let _e855 = phi_1412_;
                            let _e857 = phi_1437_;
                            let _e861 = (bitcast<i32>(_e857.member) != 0i);
                            if _e861 {
                                let _e862 = (_e857.member_1 < 3u);
                                if _e862 {
                                } else {
                                    phi_2267_ = true;
                                    break;
                                }
                                let _e864 = local_1[_e857.member_1];
                                if _e862 {
                                } else {
                                    phi_2267_ = true;
                                    break;
                                }
                                let _e866 = local[_e857.member_1];
                                if _e862 {
                                } else {
                                    phi_2267_ = true;
                                    break;
                                }
                                let _e868 = local_9[_e857.member_1];
                                let _e869 = (_e866 - _e864);
                                let _e870 = (_e869 > 0f);
                                if _e870 {
                                    phi_1476_ = (((_e868 - _e864) / _e869) * 1023f);
                                } else {
                                    phi_1476_ = 0f;
                                }
                                let _e875 = phi_1476_;
                                let _e877 = select(1023f, _e875, (_e875 < 1023f));
                                let _e879 = select(0f, _e877, (_e877 > 0f));
                                let _e884 = select(select(u32(_e879), 0u, (_e879 < 0f)), 4294967295u, (_e879 > 4294967000f));
                                if (_e884 > 0u) {
                                    let _e895 = (_e864 + bitcast<f32>((bitcast<u32>((f32(_e884) * bitcast<f32>((bitcast<u32>((_e869 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                    let _e900 = (select(select(_e866, _e895, (_e895 < _e866)), _e866, (_e884 == 1023u)) > _e868);
                                    if _e900 {
                                        phi_1527_ = (_e884 - 1u);
                                    } else {
                                        phi_1527_ = u32();
                                    }
                                    let _e903 = phi_1527_;
                                    phi_1529_ = _e903;
                                    phi_1530_ = select(true, false, _e900);
                                } else {
                                    phi_1529_ = u32();
                                    phi_1530_ = true;
                                }
                                let _e906 = phi_1529_;
                                let _e908 = phi_1530_;
                                if _e908 {
                                    if (_e884 < 1023u) {
                                        let _e910 = (_e884 + 1u);
                                        let _e920 = (_e864 + bitcast<f32>((bitcast<u32>((f32(_e910) * bitcast<f32>((bitcast<u32>((_e869 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                        phi_1568_ = select(_e884, _e910, (select(select(_e866, _e920, (_e920 < _e866)), _e866, (_e910 == 1023u)) <= _e868));
                                    } else {
                                        phi_1568_ = _e884;
                                    }
                                    let _e928 = phi_1568_;
                                    phi_1569_ = _e928;
                                } else {
                                    phi_1569_ = _e906;
                                }
                                let _e930 = phi_1569_;
                                let _e934 = bitcast<f32>((bitcast<u32>((_e869 * 0.0009775171f)) ^ _e71));
                                let _e940 = (_e864 + bitcast<f32>((bitcast<u32>((f32(_e930) * _e934)) ^ _e71)));
                                let _e948 = ((10u * _e857.member_1) & 31u);
                                if _e862 {
                                } else {
                                    phi_2267_ = true;
                                    break;
                                }
                                let _e954 = local_8[_e857.member_1];
                                if _e870 {
                                    phi_1621_ = (((_e954 - _e864) / _e869) * 1023f);
                                } else {
                                    phi_1621_ = 0f;
                                }
                                let _e959 = phi_1621_;
                                let _e961 = select(1023f, _e959, (_e959 < 1023f));
                                let _e963 = select(0f, _e961, (_e961 > 0f));
                                let _e968 = select(select(u32(_e963), 0u, (_e963 < 0f)), 4294967295u, (_e963 > 4294967000f));
                                if (_e968 > 0u) {
                                    let _e975 = (_e864 + bitcast<f32>((bitcast<u32>((f32(_e968) * _e934)) ^ _e71)));
                                    let _e980 = (select(select(_e866, _e975, (_e975 < _e866)), _e866, (_e968 == 1023u)) > _e954);
                                    if _e980 {
                                        phi_1672_ = (_e968 - 1u);
                                    } else {
                                        phi_1672_ = u32();
                                    }
                                    let _e983 = phi_1672_;
                                    phi_1674_ = _e983;
                                    phi_1675_ = select(true, false, _e980);
                                } else {
                                    phi_1674_ = u32();
                                    phi_1675_ = true;
                                }
                                let _e986 = phi_1674_;
                                let _e988 = phi_1675_;
                                if _e988 {
                                    if (_e968 < 1023u) {
                                        let _e990 = (_e968 + 1u);
                                        let _e996 = (_e864 + bitcast<f32>((bitcast<u32>((f32(_e990) * _e934)) ^ _e71)));
                                        phi_1713_ = select(_e968, _e990, (select(select(_e866, _e996, (_e996 < _e866)), _e866, (_e990 == 1023u)) <= _e954));
                                    } else {
                                        phi_1713_ = _e968;
                                    }
                                    let _e1004 = phi_1713_;
                                    phi_1714_ = _e1004;
                                } else {
                                    phi_1714_ = _e986;
                                }
                                let _e1006 = phi_1714_;
                                let _e1012 = (_e864 + bitcast<f32>((bitcast<u32>((f32(_e1006) * _e934)) ^ _e71)));
                                let _e1018 = select(_e1006, 0u, (select(select(_e866, _e1012, (_e1012 < _e866)), _e866, (_e1006 == 1023u)) > _e954));
                                if (_e1018 < 1023u) {
                                    let _e1025 = (_e864 + bitcast<f32>((bitcast<u32>((f32(_e1018) * _e934)) ^ _e71)));
                                    let _e1030 = (select(select(_e866, _e1025, (_e1025 < _e866)), _e866, (_e1018 == 1023u)) < _e954);
                                    if _e1030 {
                                        phi_1775_ = (_e1018 + 1u);
                                    } else {
                                        phi_1775_ = u32();
                                    }
                                    let _e1033 = phi_1775_;
                                    phi_1777_ = _e1033;
                                    phi_1778_ = select(true, false, _e1030);
                                } else {
                                    phi_1777_ = u32();
                                    phi_1778_ = true;
                                }
                                let _e1036 = phi_1777_;
                                let _e1038 = phi_1778_;
                                phi_1415_ = array<u32, 2>((_e842[0] | (select(_e930, 0u, (select(select(_e866, _e940, (_e940 < _e866)), _e866, (_e930 == 1023u)) > _e868)) << bitcast<u32>(_e948))), (_e842[1] | (select(_e1036, _e1018, _e1038) << bitcast<u32>(_e948))));
                            } else {
                                phi_1415_ = array<u32, 2>();
                            }
                            let _e1046 = phi_1415_;
                            continue;
                            continuing {
                                phi_1411_ = _e855;
                                phi_1414_ = _e1046;
                                phi_2267_ = _e838;
                                break if !(_e861);
                            }
                        }
                        let _e1049 = phi_2267_;
                        if _e1049 {
                            break;
                        }
                        let _e1051 = local_15;
                        let _e1053 = local_16;
                        phi_1801_ = type_4(0u, 3u);
                        loop {
                            let _e1056 = phi_1801_;
                            if (_e1056.member < _e1056.member_1) {
                                phi_1802_ = type_4((_e1056.member + 1u), _e1056.member_1);
                                phi_1825_ = type_4(1u, _e1056.member);
                            } else {
                                phi_1802_ = _e1056;
                                phi_1825_ = type_4(0u, type_4().member_1);
                            }
                            let _e1069 = phi_1802_;
                            let _e1071 = phi_1825_;
                            let _e1075 = (bitcast<i32>(_e1071.member) != 0i);
                            if _e1075 {
                                let _e1076 = (_e1071.member_1 < 3u);
                                if _e1076 {
                                } else {
                                    phi_2306_ = true;
                                    break;
                                }
                                if _e1076 {
                                } else {
                                    phi_2306_ = true;
                                    break;
                                }
                                if _e1076 {
                                } else {
                                    phi_2306_ = true;
                                    break;
                                }
                                if _e1076 {
                                } else {
                                    phi_2306_ = true;
                                    break;
                                }
                                if _e1076 {
                                } else {
                                    phi_2306_ = true;
                                    break;
                                }
                            }
                            continue;
                            continuing {
                                phi_1801_ = _e1069;
                                phi_2306_ = _e1049;
                                break if !(_e1075);
                            }
                        }
                        let _e1079 = phi_2306_;
                        if _e1079 {
                            break;
                        }
                        phi_1931_ = type_4(0u, 3u);
                        loop {
                            let _e1081 = phi_1931_;
                            if (_e1081.member < _e1081.member_1) {
                                phi_1932_ = type_4((_e1081.member + 1u), _e1081.member_1);
                                phi_1955_ = type_4(1u, _e1081.member);
                            } else {
                                phi_1932_ = _e1081;
                                phi_1955_ = type_4(0u, type_4().member_1);
                            }
                            let _e1094 = phi_1932_;
                            let _e1096 = phi_1955_;
                            let _e1100 = (bitcast<i32>(_e1096.member) != 0i);
                            if _e1100 {
                                let _e1101 = (_e1096.member_1 < 3u);
                                if _e1101 {
                                } else {
                                    phi_2310_ = true;
                                    break;
                                }
                                if _e1101 {
                                } else {
                                    phi_2310_ = true;
                                    break;
                                }
                                if _e1101 {
                                } else {
                                    phi_2310_ = true;
                                    break;
                                }
                                if _e1101 {
                                } else {
                                    phi_2310_ = true;
                                    break;
                                }
                                if _e1101 {
                                } else {
                                    phi_2310_ = true;
                                    break;
                                }
                            }
                            continue;
                            continuing {
                                phi_1931_ = _e1094;
                                phi_2310_ = _e1079;
                                break if !(_e1100);
                            }
                        }
                        let _e1104 = phi_2310_;
                        if _e1104 {
                            break;
                        }
                        if _e68 {
                        } else {
                            break;
                        }
                        global_4.member[_e62] = type_33(_e1051, _e1053, _e541, _e572);
                        if (_e62 == 0u) {
                            if (_e58 == 0u) {
                            } else {
                                if (0u < _e58) {
                                } else {
                                    break;
                                }
                                global_5.member[0u] = type_28(array<u32, 4>(bitcast<u32>(_e537[0]), bitcast<u32>(_e537[1]), bitcast<u32>(_e537[2]), 0u), array<u32, 4>(bitcast<u32>(_e536[0]), bitcast<u32>(_e536[1]), bitcast<u32>(_e536[2]), 0u));
                            }
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
fn encode_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
