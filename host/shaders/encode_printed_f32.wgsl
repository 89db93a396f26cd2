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

struct type_27 {
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
    var phi_176_: type_27;
    var phi_194_: type_27;
    var phi_2170_: bool;
    var phi_257_: type_4;
    var phi_260_: u32;
    var phi_258_: type_4;
    var phi_283_: type_4;
    var phi_305_: type_19;
    var phi_313_: bool;
    var phi_331_: type_27;
    var phi_349_: type_27;
    var phi_353_: type_27;
    var phi_376_: type_4;
    var phi_379_: array<u32, 2>;
    var phi_377_: type_4;
    var phi_402_: type_4;
    var phi_441_: f32;
    var phi_492_: u32;
    var phi_494_: u32;
    var phi_495_: bool;
    var phi_533_: u32;
    var phi_534_: u32;
    var phi_586_: f32;
    var phi_637_: u32;
    var phi_639_: u32;
    var phi_640_: bool;
    var phi_678_: u32;
    var phi_679_: u32;
    var phi_740_: u32;
    var phi_742_: u32;
    var phi_743_: bool;
    var phi_380_: array<u32, 2>;
    var phi_2160_: bool;
    var phi_761_: type_4;
    var phi_762_: type_4;
    var phi_785_: type_4;
    var local_13: array<u32, 2>;
    var local_14: array<u32, 2>;
    var phi_2215_: bool;
    var phi_2225_: bool;
    var phi_913_: u32;
    var phi_2224_: bool;
    var phi_261_: u32;
    var phi_915_: bool;
    var phi_2223_: bool;
    var phi_966_: type_27;
    var phi_988_: type_27;
    var phi_1032_: type_4;
    var phi_1035_: array<u32, 2>;
    var phi_1033_: type_4;
    var phi_1058_: type_4;
    var phi_1097_: f32;
    var phi_1148_: u32;
    var phi_1150_: u32;
    var phi_1151_: bool;
    var phi_1189_: u32;
    var phi_1190_: u32;
    var phi_1242_: f32;
    var phi_1293_: u32;
    var phi_1295_: u32;
    var phi_1296_: bool;
    var phi_1334_: u32;
    var phi_1335_: u32;
    var phi_1396_: u32;
    var phi_1398_: u32;
    var phi_1399_: bool;
    var phi_1036_: array<u32, 2>;
    var phi_2227_: bool;
    var phi_1412_: type_4;
    var phi_1415_: array<u32, 2>;
    var phi_1413_: type_4;
    var phi_1438_: type_4;
    var phi_1477_: f32;
    var phi_1528_: u32;
    var phi_1530_: u32;
    var phi_1531_: bool;
    var phi_1569_: u32;
    var phi_1570_: u32;
    var phi_1622_: f32;
    var phi_1673_: u32;
    var phi_1675_: u32;
    var phi_1676_: bool;
    var phi_1714_: u32;
    var phi_1715_: u32;
    var phi_1776_: u32;
    var phi_1778_: u32;
    var phi_1779_: bool;
    var phi_1416_: array<u32, 2>;
    var phi_2268_: bool;
    var local_15: array<u32, 2>;
    var local_16: array<u32, 2>;
    var phi_1802_: type_4;
    var phi_1803_: type_4;
    var phi_1826_: type_4;
    var phi_2307_: bool;
    var phi_1932_: type_4;
    var phi_1933_: type_4;
    var phi_1956_: type_4;
    var phi_2311_: bool;

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
                            phi_176_ = type_27(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            phi_176_ = type_27(vec3<f32>(_e77.member[0][0], _e77.member[1][0], _e77.member[2][0]), vec3<f32>(_e77.member[0][2], _e77.member[1][2], _e77.member[2][2]));
                        }
                        let _e96 = phi_176_;
                        if (_e77.member_2 == 2147483648u) {
                            phi_194_ = _e96;
                        } else {
                            phi_194_ = type_27(vec3<f32>(_e77.member[0][1], _e77.member[1][1], _e77.member[2][1]), vec3<f32>(_e77.member[0][3], _e77.member[1][3], _e77.member[2][3]));
                        }
                        let _e115 = phi_194_;
                        local_3 = array<f32, 3>(select(_e115.member.x, _e96.member.x, (_e96.member.x < _e115.member.x)), select(_e115.member.y, _e96.member.y, (_e96.member.y < _e115.member.y)), select(_e115.member.z, _e96.member.z, (_e96.member.z < _e115.member.z)));
                        local_2 = array<f32, 3>(select(_e115.member_1.x, _e96.member_1.x, (_e96.member_1.x > _e115.member_1.x)), select(_e115.member_1.y, _e96.member_1.y, (_e96.member_1.y > _e115.member_1.y)), select(_e115.member_1.z, _e96.member_1.z, (_e96.member_1.z > _e115.member_1.z)));
                        phi_2170_ = false;
                        phi_257_ = type_4(0u, 128u);
                        phi_260_ = 0u;
                        loop {
                            let _e147 = phi_2170_;
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
                                    phi_2225_ = _e147;
                                    phi_913_ = u32();
                                } else {
                                    let _e171 = (_e151 < _e54);
                                    if _e171 {
                                        if _e171 {
                                        } else {
                                            phi_2223_ = true;
                                            break;
                                        }
                                        let _e174 = global_3.member[_e151];
                                        phi_305_ = _e174;
                                    } else {
                                        phi_305_ = type_19(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e176 = phi_305_;
                                    if ((_e176.member_1 & 2147483648u) != 0u) {
                                        phi_313_ = false;
                                    } else {
                                        phi_313_ = (_e62 <= _e176.member_1);
                                    }
                                    let _e182 = phi_313_;
                                    if (_e176.member_1 == 2147483648u) {
                                        phi_331_ = type_27(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                    } else {
                                        phi_331_ = type_27(vec3<f32>(_e176.member[0][0], _e176.member[1][0], _e176.member[2][0]), vec3<f32>(_e176.member[0][2], _e176.member[1][2], _e176.member[2][2]));
                                    }
                                    let _e200 = phi_331_;
                                    if (_e176.member_2 == 2147483648u) {
                                        phi_349_ = _e200;
                                    } else {
                                        phi_349_ = type_27(vec3<f32>(_e176.member[0][1], _e176.member[1][1], _e176.member[2][1]), vec3<f32>(_e176.member[0][3], _e176.member[1][3], _e176.member[2][3]));
                                    }
                                    let _e219 = phi_349_;
                                    if _e182 {
                                        phi_353_ = _e200;
                                    } else {
                                        phi_353_ = _e219;
                                    }
                                    let _e221 = phi_353_;
                                    local_5 = array<f32, 3>(_e221.member.x, _e221.member.y, _e221.member.z);
                                    local_4 = array<f32, 3>(_e221.member_1.x, _e221.member_1.y, _e221.member_1.z);
                                    phi_376_ = type_4(0u, 3u);
                                    phi_379_ = array<u32, 2>(0u, 0u);
                                    loop {
                                        let _e237 = phi_376_;
                                        let _e239 = phi_379_;
                                        local_13 = _e239;
                                        local_14 = _e239;
                                        if (_e237.member < _e237.member_1) {
                                            phi_377_ = type_4((_e237.member + 1u), _e237.member_1);
                                            phi_402_ = type_4(1u, _e237.member);
                                        } else {
                                            phi_377_ = _e237;
                                            phi_402_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e252 = phi_377_;
                                        let _e254 = phi_402_;
                                        let _e258 = (bitcast<i32>(_e254.member) != 0i);
                                        if _e258 {
                                            let _e259 = (_e254.member_1 < 3u);
                                            if _e259 {
                                            } else {
                                                phi_2160_ = true;
                                                break;
                                            }
                                            let _e261 = local_3[_e254.member_1];
                                            if _e259 {
                                            } else {
                                                phi_2160_ = true;
                                                break;
                                            }
                                            let _e263 = local_2[_e254.member_1];
                                            if _e259 {
                                            } else {
                                                phi_2160_ = true;
                                                break;
                                            }
                                            let _e265 = local_5[_e254.member_1];
                                            let _e266 = (_e263 - _e261);
                                            let _e267 = (_e266 > 0f);
                                            if _e267 {
                                                phi_441_ = (((_e265 - _e261) / _e266) * 1023f);
                                            } else {
                                                phi_441_ = 0f;
                                            }
                                            let _e272 = phi_441_;
                                            let _e274 = select(1023f, _e272, (_e272 < 1023f));
                                            let _e276 = select(0f, _e274, (_e274 > 0f));
                                            let _e281 = select(select(u32(_e276), 0u, (_e276 < 0f)), 4294967295u, (_e276 > 4294967000f));
                                            if (_e281 > 0u) {
                                                let _e292 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e281) * bitcast<f32>((bitcast<u32>((_e266 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                                let _e297 = (select(select(_e263, _e292, (_e292 < _e263)), _e263, (_e281 == 1023u)) > _e265);
                                                if _e297 {
                                                    phi_492_ = (_e281 - 1u);
                                                } else {
                                                    phi_492_ = u32();
                                                }
                                                let _e300 = phi_492_;
                                                phi_494_ = _e300;
                                                phi_495_ = select(true, false, _e297);
                                            } else {
                                                phi_494_ = u32();
                                                phi_495_ = true;
                                            }
                                            let _e303 = phi_494_;
                                            let _e305 = phi_495_;
                                            if _e305 {
                                                if (_e281 < 1023u) {
                                                    let _e307 = (_e281 + 1u);
                                                    let _e317 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e307) * bitcast<f32>((bitcast<u32>((_e266 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                                    phi_533_ = select(_e281, _e307, (select(select(_e263, _e317, (_e317 < _e263)), _e263, (_e307 == 1023u)) <= _e265));
                                                } else {
                                                    phi_533_ = _e281;
                                                }
                                                let _e325 = phi_533_;
                                                phi_534_ = _e325;
                                            } else {
                                                phi_534_ = _e303;
                                            }
                                            let _e327 = phi_534_;
                                            let _e331 = bitcast<f32>((bitcast<u32>((_e266 * 0.0009775171f)) ^ _e71));
                                            let _e337 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e327) * _e331)) ^ _e71)));
                                            let _e345 = ((10u * _e254.member_1) & 31u);
                                            if _e259 {
                                            } else {
                                                phi_2160_ = true;
                                                break;
                                            }
                                            let _e351 = local_4[_e254.member_1];
                                            if _e267 {
                                                phi_586_ = (((_e351 - _e261) / _e266) * 1023f);
                                            } else {
                                                phi_586_ = 0f;
                                            }
                                            let _e356 = phi_586_;
                                            let _e358 = select(1023f, _e356, (_e356 < 1023f));
                                            let _e360 = select(0f, _e358, (_e358 > 0f));
                                            let _e365 = select(select(u32(_e360), 0u, (_e360 < 0f)), 4294967295u, (_e360 > 4294967000f));
                                            if (_e365 > 0u) {
                                                let _e372 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e365) * _e331)) ^ _e71)));
                                                let _e377 = (select(select(_e263, _e372, (_e372 < _e263)), _e263, (_e365 == 1023u)) > _e351);
                                                if _e377 {
                                                    phi_637_ = (_e365 - 1u);
                                                } else {
                                                    phi_637_ = u32();
                                                }
                                                let _e380 = phi_637_;
                                                phi_639_ = _e380;
                                                phi_640_ = select(true, false, _e377);
                                            } else {
                                                phi_639_ = u32();
                                                phi_640_ = true;
                                            }
                                            let _e383 = phi_639_;
                                            let _e385 = phi_640_;
                                            if _e385 {
                                                if (_e365 < 1023u) {
                                                    let _e387 = (_e365 + 1u);
                                                    let _e393 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e387) * _e331)) ^ _e71)));
                                                    phi_678_ = select(_e365, _e387, (select(select(_e263, _e393, (_e393 < _e263)), _e263, (_e387 == 1023u)) <= _e351));
                                                } else {
                                                    phi_678_ = _e365;
                                                }
                                                let _e401 = phi_678_;
                                                phi_679_ = _e401;
                                            } else {
                                                phi_679_ = _e383;
                                            }
                                            let _e403 = phi_679_;
                                            let _e409 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e403) * _e331)) ^ _e71)));
                                            let _e415 = select(_e403, 0u, (select(select(_e263, _e409, (_e409 < _e263)), _e263, (_e403 == 1023u)) > _e351));
                                            if (_e415 < 1023u) {
                                                let _e422 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e415) * _e331)) ^ _e71)));
                                                let _e427 = (select(select(_e263, _e422, (_e422 < _e263)), _e263, (_e415 == 1023u)) < _e351);
                                                if _e427 {
                                                    phi_740_ = (_e415 + 1u);
                                                } else {
                                                    phi_740_ = u32();
                                                }
                                                let _e430 = phi_740_;
                                                phi_742_ = _e430;
                                                phi_743_ = select(true, false, _e427);
                                            } else {
                                                phi_742_ = u32();
                                                phi_743_ = true;
                                            }
                                            let _e433 = phi_742_;
                                            let _e435 = phi_743_;
                                            phi_380_ = array<u32, 2>((_e239[0] | (select(_e327, 0u, (select(select(_e263, _e337, (_e337 < _e263)), _e263, (_e327 == 1023u)) > _e265)) << bitcast<u32>(_e345))), (_e239[1] | (select(_e433, _e415, _e435) << bitcast<u32>(_e345))));
                                        } else {
                                            phi_380_ = array<u32, 2>();
                                        }
                                        let _e443 = phi_380_;
                                        continue;
                                        continuing {
                                            phi_376_ = _e252;
                                            phi_379_ = _e443;
                                            phi_2160_ = _e147;
                                            break if !(_e258);
                                        }
                                    }
                                    let _e446 = phi_2160_;
                                    phi_2223_ = _e446;
                                    if _e446 {
                                        break;
                                    }
                                    local_12 = array<u32, 3>(0u, 1u, 2u);
                                    local_7 = array<f32, 3>(0f, 0f, 0f);
                                    local_6 = array<f32, 3>(0f, 0f, 0f);
                                    phi_761_ = type_4(0u, 3u);
                                    loop {
                                        let _e448 = phi_761_;
                                        if (_e448.member < _e448.member_1) {
                                            phi_762_ = type_4((_e448.member + 1u), _e448.member_1);
                                            phi_785_ = type_4(1u, _e448.member);
                                        } else {
                                            phi_762_ = _e448;
                                            phi_785_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e461 = phi_762_;
                                        let _e463 = phi_785_;
                                        let _e467 = (bitcast<i32>(_e463.member) != 0i);
                                        if _e467 {
                                            let _e468 = (_e463.member_1 < 3u);
                                            if _e468 {
                                            } else {
                                                phi_2215_ = true;
                                                break;
                                            }
                                            let _e470 = local_12[_e463.member_1];
                                            if _e468 {
                                            } else {
                                                phi_2215_ = true;
                                                break;
                                            }
                                            let _e472 = local_3[_e463.member_1];
                                            if _e468 {
                                            } else {
                                                phi_2215_ = true;
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
                                                phi_2215_ = true;
                                                break;
                                            }
                                            local_7[_e463.member_1] = select(select(_e474, _e493, (_e493 < _e474)), _e474, (_e482 == 1023u));
                                            let _e500 = local_14;
                                            let _e504 = ((_e500[1] >> bitcast<u32>(_e479)) & 1023u);
                                            let _e510 = (_e472 + bitcast<f32>((bitcast<u32>((f32(_e504) * _e487)) ^ _e71)));
                                            if _e468 {
                                            } else {
                                                phi_2215_ = true;
                                                break;
                                            }
                                            local_6[_e463.member_1] = select(select(_e474, _e510, (_e510 < _e474)), _e474, (_e504 == 1023u));
                                        }
                                        continue;
                                        continuing {
                                            phi_761_ = _e461;
                                            phi_2215_ = _e446;
                                            break if !(_e467);
                                        }
                                    }
                                    let _e518 = phi_2215_;
                                    phi_2223_ = _e518;
                                    if _e518 {
                                        break;
                                    }
                                    let _e519 = local_6;
                                    let _e520 = local_7;
                                    local_3 = _e520;
                                    local_2 = _e519;
                                    phi_2225_ = _e518;
                                    phi_913_ = select(_e176.member_2, _e176.member_1, _e182);
                                }
                                let _e523 = phi_2225_;
                                let _e525 = phi_913_;
                                phi_2224_ = _e523;
                                phi_261_ = _e525;
                                phi_915_ = select(true, false, _e170);
                            } else {
                                phi_2224_ = _e147;
                                phi_261_ = u32();
                                phi_915_ = false;
                            }
                            let _e528 = phi_2224_;
                            let _e530 = phi_261_;
                            let _e532 = phi_915_;
                            continue;
                            continuing {
                                phi_2170_ = _e528;
                                phi_257_ = _e164;
                                phi_260_ = _e530;
                                phi_2223_ = _e528;
                                break if !(_e532);
                            }
                        }
                        let _e535 = phi_2223_;
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
                            phi_966_ = type_27(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            let _e547 = global_3.member[_e62].member[0u];
                            let _e552 = global_3.member[_e62].member[1u];
                            let _e557 = global_3.member[_e62].member[2u];
                            phi_966_ = type_27(vec3<f32>(_e547[0], _e552[0], _e557[0]), vec3<f32>(_e547[2], _e552[2], _e557[2]));
                        }
                        let _e568 = phi_966_;
                        let _e572 = global_3.member[_e62].member_2;
                        if (_e572 == 2147483648u) {
                            phi_988_ = _e568;
                        } else {
                            let _e578 = global_3.member[_e62].member[0u];
                            let _e583 = global_3.member[_e62].member[1u];
                            let _e588 = global_3.member[_e62].member[2u];
                            phi_988_ = type_27(vec3<f32>(_e578[1], _e583[1], _e588[1]), vec3<f32>(_e578[3], _e583[3], _e588[3]));
                        }
                        let _e599 = phi_988_;
                        local_11 = array<f32, 3>(_e568.member.x, _e568.member.y, _e568.member.z);
                        local_10 = array<f32, 3>(_e568.member_1.x, _e568.member_1.y, _e568.member_1.z);
                        local_9 = array<f32, 3>(_e599.member.x, _e599.member.y, _e599.member.z);
                        local_8 = array<f32, 3>(_e599.member_1.x, _e599.member_1.y, _e599.member_1.z);
                        phi_1032_ = type_4(0u, 3u);
                        phi_1035_ = array<u32, 2>(0u, 0u);
                        loop {
                            let _e629 = phi_1032_;
                            let _e631 = phi_1035_;
                            local_15 = _e631;
                            if (_e629.member < _e629.member_1) {
                                phi_1033_ = type_4((_e629.member + 1u), _e629.member_1);
                                phi_1058_ = type_4(1u, _e629.member);
                            } else {
                                phi_1033_ = _e629;
                                phi_1058_ = type_4(0u, type_4().member_1);
                            }
                            let _e644 = phi_1033_;
                            let _e646 = phi_1058_;
                            let _e650 = (bitcast<i32>(_e646.member) != 0i);
                            if _e650 {
                                let _e651 = (_e646.member_1 < 3u);
                                if _e651 {
                                } else {
                                    phi_2227_ = true;
                                    break;
                                }
                                let _e653 = local_1[_e646.member_1];
                                if _e651 {
                                } else {
                                    phi_2227_ = true;
                                    break;
                                }
                                let _e655 = local[_e646.member_1];
                                if _e651 {
                                } else {
                                    phi_2227_ = true;
                                    break;
                                }
                                let _e657 = local_11[_e646.member_1];
                                let _e658 = (_e655 - _e653);
                                let _e659 = (_e658 > 0f);
                                if _e659 {
                                    phi_1097_ = (((_e657 - _e653) / _e658) * 1023f);
                                } else {
                                    phi_1097_ = 0f;
                                }
                                let _e664 = phi_1097_;
                                let _e666 = select(1023f, _e664, (_e664 < 1023f));
                                let _e668 = select(0f, _e666, (_e666 > 0f));
                                let _e673 = select(select(u32(_e668), 0u, (_e668 < 0f)), 4294967295u, (_e668 > 4294967000f));
                                if (_e673 > 0u) {
                                    let _e684 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e673) * bitcast<f32>((bitcast<u32>((_e658 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                    let _e689 = (select(select(_e655, _e684, (_e684 < _e655)), _e655, (_e673 == 1023u)) > _e657);
                                    if _e689 {
                                        phi_1148_ = (_e673 - 1u);
                                    } else {
                                        phi_1148_ = u32();
                                    }
                                    let _e692 = phi_1148_;
                                    phi_1150_ = _e692;
                                    phi_1151_ = select(true, false, _e689);
                                } else {
                                    phi_1150_ = u32();
                                    phi_1151_ = true;
                                }
                                let _e695 = phi_1150_;
                                let _e697 = phi_1151_;
                                if _e697 {
                                    if (_e673 < 1023u) {
                                        let _e699 = (_e673 + 1u);
                                        let _e709 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e699) * bitcast<f32>((bitcast<u32>((_e658 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                        phi_1189_ = select(_e673, _e699, (select(select(_e655, _e709, (_e709 < _e655)), _e655, (_e699 == 1023u)) <= _e657));
                                    } else {
                                        phi_1189_ = _e673;
                                    }
                                    let _e717 = phi_1189_;
                                    phi_1190_ = _e717;
                                } else {
                                    phi_1190_ = _e695;
                                }
                                let _e719 = phi_1190_;
                                let _e723 = bitcast<f32>((bitcast<u32>((_e658 * 0.0009775171f)) ^ _e71));
                                let _e729 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e719) * _e723)) ^ _e71)));
                                let _e737 = ((10u * _e646.member_1) & 31u);
                                if _e651 {
                                } else {
                                    phi_2227_ = true;
                                    break;
                                }
                                let _e743 = local_10[_e646.member_1];
                                if _e659 {
                                    phi_1242_ = (((_e743 - _e653) / _e658) * 1023f);
                                } else {
                                    phi_1242_ = 0f;
                                }
                                let _e748 = phi_1242_;
                                let _e750 = select(1023f, _e748, (_e748 < 1023f));
                                let _e752 = select(0f, _e750, (_e750 > 0f));
                                let _e757 = select(select(u32(_e752), 0u, (_e752 < 0f)), 4294967295u, (_e752 > 4294967000f));
                                if (_e757 > 0u) {
                                    let _e764 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e757) * _e723)) ^ _e71)));
                                    let _e769 = (select(select(_e655, _e764, (_e764 < _e655)), _e655, (_e757 == 1023u)) > _e743);
                                    if _e769 {
                                        phi_1293_ = (_e757 - 1u);
                                    } else {
                                        phi_1293_ = u32();
                                    }
                                    let _e772 = phi_1293_;
                                    phi_1295_ = _e772;
                                    phi_1296_ = select(true, false, _e769);
                                } else {
                                    phi_1295_ = u32();
                                    phi_1296_ = true;
                                }
                                let _e775 = phi_1295_;
                                let _e777 = phi_1296_;
                                if _e777 {
                                    if (_e757 < 1023u) {
                                        let _e779 = (_e757 + 1u);
                                        let _e785 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e779) * _e723)) ^ _e71)));
                                        phi_1334_ = select(_e757, _e779, (select(select(_e655, _e785, (_e785 < _e655)), _e655, (_e779 == 1023u)) <= _e743));
                                    } else {
                                        phi_1334_ = _e757;
                                    }
                                    let _e793 = phi_1334_;
                                    phi_1335_ = _e793;
                                } else {
                                    phi_1335_ = _e775;
                                }
                                let _e795 = phi_1335_;
                                let _e801 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e795) * _e723)) ^ _e71)));
                                let _e807 = select(_e795, 0u, (select(select(_e655, _e801, (_e801 < _e655)), _e655, (_e795 == 1023u)) > _e743));
                                if (_e807 < 1023u) {
                                    let _e814 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e807) * _e723)) ^ _e71)));
                                    let _e819 = (select(select(_e655, _e814, (_e814 < _e655)), _e655, (_e807 == 1023u)) < _e743);
                                    if _e819 {
                                        phi_1396_ = (_e807 + 1u);
                                    } else {
                                        phi_1396_ = u32();
                                    }
                                    let _e822 = phi_1396_;
                                    phi_1398_ = _e822;
                                    phi_1399_ = select(true, false, _e819);
                                } else {
                                    phi_1398_ = u32();
                                    phi_1399_ = true;
                                }
                                let _e825 = phi_1398_;
                                let _e827 = phi_1399_;
                                phi_1036_ = array<u32, 2>((_e631[0] | (select(_e719, 0u, (select(select(_e655, _e729, (_e729 < _e655)), _e655, (_e719 == 1023u)) > _e657)) << bitcast<u32>(_e737))), (_e631[1] | (select(_e825, _e807, _e827) << bitcast<u32>(_e737))));
                            } else {
                                phi_1036_ = array<u32, 2>();
                            }
                            let _e835 = phi_1036_;
                            continue;
                            continuing {
                                phi_1032_ = _e644;
                                phi_1035_ = _e835;
                                phi_2227_ = _e535;
                                break if !(_e650);
                            }
                        }
                        let _e838 = phi_2227_;
                        if _e838 {
                            break;
                        }
                        phi_1412_ = type_4(0u, 3u);
                        phi_1415_ = array<u32, 2>(0u, 0u);
                        loop {
                            let _e840 = phi_1412_;
                            let _e842 = phi_1415_;
                            local_16 = _e842;
                            if (_e840.member < _e840.member_1) {
                                phi_1413_ = type_4((_e840.member + 1u), _e840.member_1);
                                phi_1438_ = type_4(1u, _e840.member);
                            } else {
                                phi_1413_ = _e840;
                                phi_1438_ = type_4(0u, type_4().member_1);
                            }
                            let _e855 = phi_1413_;
                            let _e857 = phi_1438_;
                            let _e861 = (bitcast<i32>(_e857.member) != 0i);
                            if _e861 {
                                let _e862 = (_e857.member_1 < 3u);
                                if _e862 {
                                } else {
                                    phi_2268_ = true;
                                    break;
                                }
                                let _e864 = local_1[_e857.member_1];
                                if _e862 {
                                } else {
                                    phi_2268_ = true;
                                    break;
                                }
                                let _e866 = local[_e857.member_1];
                                if _e862 {
                                } else {
                                    phi_2268_ = true;
                                    break;
                                }
                                let _e868 = local_9[_e857.member_1];
                                let _e869 = (_e866 - _e864);
                                let _e870 = (_e869 > 0f);
                                if _e870 {
                                    phi_1477_ = (((_e868 - _e864) / _e869) * 1023f);
                                } else {
                                    phi_1477_ = 0f;
                                }
                                let _e875 = phi_1477_;
                                let _e877 = select(1023f, _e875, (_e875 < 1023f));
                                let _e879 = select(0f, _e877, (_e877 > 0f));
                                let _e884 = select(select(u32(_e879), 0u, (_e879 < 0f)), 4294967295u, (_e879 > 4294967000f));
                                if (_e884 > 0u) {
                                    let _e895 = (_e864 + bitcast<f32>((bitcast<u32>((f32(_e884) * bitcast<f32>((bitcast<u32>((_e869 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                    let _e900 = (select(select(_e866, _e895, (_e895 < _e866)), _e866, (_e884 == 1023u)) > _e868);
                                    if _e900 {
                                        phi_1528_ = (_e884 - 1u);
                                    } else {
                                        phi_1528_ = u32();
                                    }
                                    let _e903 = phi_1528_;
                                    phi_1530_ = _e903;
                                    phi_1531_ = select(true, false, _e900);
                                } else {
                                    phi_1530_ = u32();
                                    phi_1531_ = true;
                                }
                                let _e906 = phi_1530_;
                                let _e908 = phi_1531_;
                                if _e908 {
                                    if (_e884 < 1023u) {
                                        let _e910 = (_e884 + 1u);
                                        let _e920 = (_e864 + bitcast<f32>((bitcast<u32>((f32(_e910) * bitcast<f32>((bitcast<u32>((_e869 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                        phi_1569_ = select(_e884, _e910, (select(select(_e866, _e920, (_e920 < _e866)), _e866, (_e910 == 1023u)) <= _e868));
                                    } else {
                                        phi_1569_ = _e884;
                                    }
                                    let _e928 = phi_1569_;
                                    phi_1570_ = _e928;
                                } else {
                                    phi_1570_ = _e906;
                                }
                                let _e930 = phi_1570_;
                                let _e934 = bitcast<f32>((bitcast<u32>((_e869 * 0.0009775171f)) ^ _e71));
                                let _e940 = (_e864 + bitcast<f32>((bitcast<u32>((f32(_e930) * _e934)) ^ _e71)));
                                let _e948 = ((10u * _e857.member_1) & 31u);
                                if _e862 {
                                } else {
                                    phi_2268_ = true;
                                    break;
                                }
                                let _e954 = local_8[_e857.member_1];
                                if _e870 {
                                    phi_1622_ = (((_e954 - _e864) / _e869) * 1023f);
                                } else {
                                    phi_1622_ = 0f;
                                }
                                let _e959 = phi_1622_;
                                let _e961 = select(1023f, _e959, (_e959 < 1023f));
                                let _e963 = select(0f, _e961, (_e961 > 0f));
                                let _e968 = select(select(u32(_e963), 0u, (_e963 < 0f)), 4294967295u, (_e963 > 4294967000f));
                                if (_e968 > 0u) {
                                    let _e975 = (_e864 + bitcast<f32>((bitcast<u32>((f32(_e968) * _e934)) ^ _e71)));
                                    let _e980 = (select(select(_e866, _e975, (_e975 < _e866)), _e866, (_e968 == 1023u)) > _e954);
                                    if _e980 {
                                        phi_1673_ = (_e968 - 1u);
                                    } else {
                                        phi_1673_ = u32();
                                    }
                                    let _e983 = phi_1673_;
                                    phi_1675_ = _e983;
                                    phi_1676_ = select(true, false, _e980);
                                } else {
                                    phi_1675_ = u32();
                                    phi_1676_ = true;
                                }
                                let _e986 = phi_1675_;
                                let _e988 = phi_1676_;
                                if _e988 {
                                    if (_e968 < 1023u) {
                                        let _e990 = (_e968 + 1u);
                                        let _e996 = (_e864 + bitcast<f32>((bitcast<u32>((f32(_e990) * _e934)) ^ _e71)));
                                        phi_1714_ = select(_e968, _e990, (select(select(_e866, _e996, (_e996 < _e866)), _e866, (_e990 == 1023u)) <= _e954));
                                    } else {
                                        phi_1714_ = _e968;
                                    }
                                    let _e1004 = phi_1714_;
                                    phi_1715_ = _e1004;
                                } else {
                                    phi_1715_ = _e986;
                                }
                                let _e1006 = phi_1715_;
                                let _e1012 = (_e864 + bitcast<f32>((bitcast<u32>((f32(_e1006) * _e934)) ^ _e71)));
                                let _e1018 = select(_e1006, 0u, (select(select(_e866, _e1012, (_e1012 < _e866)), _e866, (_e1006 == 1023u)) > _e954));
                                if (_e1018 < 1023u) {
                                    let _e1025 = (_e864 + bitcast<f32>((bitcast<u32>((f32(_e1018) * _e934)) ^ _e71)));
                                    let _e1030 = (select(select(_e866, _e1025, (_e1025 < _e866)), _e866, (_e1018 == 1023u)) < _e954);
                                    if _e1030 {
                                        phi_1776_ = (_e1018 + 1u);
                                    } else {
                                        phi_1776_ = u32();
                                    }
                                    let _e1033 = phi_1776_;
                                    phi_1778_ = _e1033;
                                    phi_1779_ = select(true, false, _e1030);
                                } else {
                                    phi_1778_ = u32();
                                    phi_1779_ = true;
                                }
                                let _e1036 = phi_1778_;
                                let _e1038 = phi_1779_;
                                phi_1416_ = array<u32, 2>((_e842[0] | (select(_e930, 0u, (select(select(_e866, _e940, (_e940 < _e866)), _e866, (_e930 == 1023u)) > _e868)) << bitcast<u32>(_e948))), (_e842[1] | (select(_e1036, _e1018, _e1038) << bitcast<u32>(_e948))));
                            } else {
                                phi_1416_ = array<u32, 2>();
                            }
                            let _e1046 = phi_1416_;
                            continue;
                            continuing {
                                phi_1412_ = _e855;
                                phi_1415_ = _e1046;
                                phi_2268_ = _e838;
                                break if !(_e861);
                            }
                        }
                        let _e1049 = phi_2268_;
                        if _e1049 {
                            break;
                        }
                        let _e1051 = local_15;
                        let _e1053 = local_16;
                        phi_1802_ = type_4(0u, 3u);
                        loop {
                            let _e1056 = phi_1802_;
                            if (_e1056.member < _e1056.member_1) {
                                phi_1803_ = type_4((_e1056.member + 1u), _e1056.member_1);
                                phi_1826_ = type_4(1u, _e1056.member);
                            } else {
                                phi_1803_ = _e1056;
                                phi_1826_ = type_4(0u, type_4().member_1);
                            }
                            let _e1069 = phi_1803_;
                            let _e1071 = phi_1826_;
                            let _e1075 = (bitcast<i32>(_e1071.member) != 0i);
                            if _e1075 {
                                let _e1076 = (_e1071.member_1 < 3u);
                                if _e1076 {
                                } else {
                                    phi_2307_ = true;
                                    break;
                                }
                                if _e1076 {
                                } else {
                                    phi_2307_ = true;
                                    break;
                                }
                                if _e1076 {
                                } else {
                                    phi_2307_ = true;
                                    break;
                                }
                                if _e1076 {
                                } else {
                                    phi_2307_ = true;
                                    break;
                                }
                                if _e1076 {
                                } else {
                                    phi_2307_ = true;
                                    break;
                                }
                            }
                            continue;
                            continuing {
                                phi_1802_ = _e1069;
                                phi_2307_ = _e1049;
                                break if !(_e1075);
                            }
                        }
                        let _e1079 = phi_2307_;
                        if _e1079 {
                            break;
                        }
                        phi_1932_ = type_4(0u, 3u);
                        loop {
                            let _e1081 = phi_1932_;
                            if (_e1081.member < _e1081.member_1) {
                                phi_1933_ = type_4((_e1081.member + 1u), _e1081.member_1);
                                phi_1956_ = type_4(1u, _e1081.member);
                            } else {
                                phi_1933_ = _e1081;
                                phi_1956_ = type_4(0u, type_4().member_1);
                            }
                            let _e1094 = phi_1933_;
                            let _e1096 = phi_1956_;
                            let _e1100 = (bitcast<i32>(_e1096.member) != 0i);
                            if _e1100 {
                                let _e1101 = (_e1096.member_1 < 3u);
                                if _e1101 {
                                } else {
                                    phi_2311_ = true;
                                    break;
                                }
                                if _e1101 {
                                } else {
                                    phi_2311_ = true;
                                    break;
                                }
                                if _e1101 {
                                } else {
                                    phi_2311_ = true;
                                    break;
                                }
                                if _e1101 {
                                } else {
                                    phi_2311_ = true;
                                    break;
                                }
                                if _e1101 {
                                } else {
                                    phi_2311_ = true;
                                    break;
                                }
                            }
                            continue;
                            continuing {
                                phi_1932_ = _e1094;
                                phi_2311_ = _e1079;
                                break if !(_e1100);
                            }
                        }
                        let _e1104 = phi_2311_;
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
