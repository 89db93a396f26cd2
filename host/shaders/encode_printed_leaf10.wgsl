struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: vec4<u32>,
}

struct type_14 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_26 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_31 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_35 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_37 {
    member: array<type_35>,
}

struct type_40 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_46 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_48 {
    member: array<type_46>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_9;
@group(0) @binding(3) 
var<storage> global_2: type_16;
@group(0) @binding(1) 
var<uniform> global_3: type_9;
@group(0) @binding(2) 
var<storage> global_4: type_28;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_42;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_48;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_37;

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
    var local_12: array<f32, 3>;
    var local_13: array<f32, 3>;
    var local_14: array<f32, 3>;
    var local_15: array<f32, 3>;
    var local_16: array<f32, 3>;
    var local_17: array<f32, 3>;
    var local_18: array<f32, 3>;
    var local_19: array<f32, 3>;
    var local_20: array<u32, 3>;
    var local_21: array<u32, 3>;
    var local_22: array<u32, 3>;
    var local_23: array<u32, 3>;
    var local_24: array<u32, 3>;
    var phi_193_: type_26;
    var phi_211_: type_31;
    var phi_229_: type_31;
    var phi_3119_: bool;
    var phi_292_: type_4;
    var phi_295_: u32;
    var phi_293_: type_4;
    var phi_318_: type_4;
    var phi_340_: type_26;
    var phi_349_: bool;
    var phi_367_: type_31;
    var phi_385_: type_31;
    var phi_389_: type_31;
    var phi_412_: type_4;
    var phi_415_: array<u32, 2>;
    var phi_413_: type_4;
    var phi_438_: type_4;
    var phi_477_: f32;
    var phi_528_: u32;
    var phi_530_: u32;
    var phi_531_: bool;
    var phi_569_: u32;
    var phi_570_: u32;
    var phi_622_: f32;
    var phi_673_: u32;
    var phi_675_: u32;
    var phi_676_: bool;
    var phi_714_: u32;
    var phi_715_: u32;
    var phi_776_: u32;
    var phi_778_: u32;
    var phi_779_: bool;
    var phi_416_: array<u32, 2>;
    var phi_3109_: bool;
    var phi_797_: type_4;
    var phi_798_: type_4;
    var phi_821_: type_4;
    var local_25: array<u32, 2>;
    var local_26: array<u32, 2>;
    var phi_3164_: bool;
    var phi_3174_: bool;
    var phi_947_: u32;
    var phi_3173_: bool;
    var phi_296_: u32;
    var phi_949_: bool;
    var phi_3172_: bool;
    var phi_1000_: type_31;
    var phi_1022_: type_31;
    var phi_1066_: type_4;
    var phi_1069_: array<u32, 2>;
    var phi_1067_: type_4;
    var phi_1092_: type_4;
    var phi_1131_: f32;
    var phi_1182_: u32;
    var phi_1184_: u32;
    var phi_1185_: bool;
    var phi_1223_: u32;
    var phi_1224_: u32;
    var phi_1276_: f32;
    var phi_1327_: u32;
    var phi_1329_: u32;
    var phi_1330_: bool;
    var phi_1368_: u32;
    var phi_1369_: u32;
    var phi_1430_: u32;
    var phi_1432_: u32;
    var phi_1433_: bool;
    var phi_1070_: array<u32, 2>;
    var phi_3176_: bool;
    var phi_1446_: type_4;
    var phi_1449_: array<u32, 2>;
    var phi_1447_: type_4;
    var phi_1472_: type_4;
    var phi_1511_: f32;
    var phi_1562_: u32;
    var phi_1564_: u32;
    var phi_1565_: bool;
    var phi_1603_: u32;
    var phi_1604_: u32;
    var phi_1656_: f32;
    var phi_1707_: u32;
    var phi_1709_: u32;
    var phi_1710_: bool;
    var phi_1748_: u32;
    var phi_1749_: u32;
    var phi_1810_: u32;
    var phi_1812_: u32;
    var phi_1813_: bool;
    var phi_1450_: array<u32, 2>;
    var phi_3217_: bool;
    var phi_1836_: type_4;
    var phi_1837_: type_4;
    var phi_1860_: type_4;
    var local_27: array<u32, 2>;
    var local_28: array<u32, 2>;
    var phi_3256_: bool;
    var phi_1977_: type_4;
    var phi_1978_: type_4;
    var phi_2001_: type_4;
    var local_29: array<u32, 2>;
    var local_30: array<u32, 2>;
    var phi_3264_: bool;
    var local_31: array<u32, 2>;
    var local_32: array<u32, 2>;
    var phi_3279_: bool;
    var phi_2189_: type_4;
    var phi_2190_: type_4;
    var phi_2213_: type_4;
    var phi_3277_: bool;
    var phi_2239_: type_4;
    var phi_2240_: type_4;
    var phi_2263_: type_4;
    var phi_2273_: type_4;
    var phi_2274_: type_4;
    var phi_2297_: type_4;
    var phi_2339_: f32;
    var phi_2390_: u32;
    var phi_2392_: u32;
    var phi_2393_: bool;
    var phi_2431_: u32;
    var phi_2432_: u32;
    var phi_2466_: u32;
    var phi_3272_: bool;
    var phi_3302_: bool;
    var phi_3301_: bool;
    var phi_3306_: bool;
    var phi_3305_: bool;
    var phi_3304_: bool;
    var phi_3303_: bool;
    var phi_3315_: bool;
    var phi_3314_: bool;
    var phi_2573_: type_4;
    var phi_2574_: type_4;
    var phi_2597_: type_4;
    var phi_3312_: bool;
    var phi_2623_: type_4;
    var phi_2624_: type_4;
    var phi_2647_: type_4;
    var phi_2657_: type_4;
    var phi_2658_: type_4;
    var phi_2681_: type_4;
    var phi_2723_: f32;
    var phi_2774_: u32;
    var phi_2776_: u32;
    var phi_2777_: bool;
    var phi_2815_: u32;
    var phi_2816_: u32;
    var phi_2850_: u32;
    var phi_3307_: bool;
    var phi_3338_: bool;
    var phi_3337_: bool;
    var phi_3342_: bool;
    var phi_3341_: bool;
    var phi_3340_: bool;
    var phi_3339_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e72 = global;
            let _e74 = arrayLength((&global_4.member));
            let _e76 = arrayLength((&global_2.member));
            let _e80 = arrayLength((&global_6.member));
            let _e82 = arrayLength((&global_7.member));
            let _e86 = (_e72.x + (_e72.y * 2097152u));
            let _e89 = global_1.member[0u];
            if (_e86 < _e89) {
                let _e91 = (_e86 < _e74);
                if _e91 {
                    let _e92 = (_e86 < arrayLength((&global_5.member)));
                    if _e92 {
                        let _e95 = global_3.member[0u];
                        let _e96 = (0u < _e74);
                        if _e96 {
                            if _e96 {
                            } else {
                                break;
                            }
                            let _e99 = global_4.member[0u];
                            phi_193_ = _e99;
                        } else {
                            phi_193_ = type_26(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e101 = phi_193_;
                        if (_e101.member_1 == 2147483648u) {
                            phi_211_ = type_31(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            phi_211_ = type_31(vec3<f32>(_e101.member[0][0], _e101.member[1][0], _e101.member[2][0]), vec3<f32>(_e101.member[0][2], _e101.member[1][2], _e101.member[2][2]));
                        }
                        let _e120 = phi_211_;
                        if (_e101.member_2 == 2147483648u) {
                            phi_229_ = _e120;
                        } else {
                            phi_229_ = type_31(vec3<f32>(_e101.member[0][1], _e101.member[1][1], _e101.member[2][1]), vec3<f32>(_e101.member[0][3], _e101.member[1][3], _e101.member[2][3]));
                        }
                        let _e139 = phi_229_;
                        local_7 = array<f32, 3>(select(_e139.member.x, _e120.member.x, (_e120.member.x < _e139.member.x)), select(_e139.member.y, _e120.member.y, (_e120.member.y < _e139.member.y)), select(_e139.member.z, _e120.member.z, (_e120.member.z < _e139.member.z)));
                        local_6 = array<f32, 3>(select(_e139.member_1.x, _e120.member_1.x, (_e120.member_1.x > _e139.member_1.x)), select(_e139.member_1.y, _e120.member_1.y, (_e120.member_1.y > _e139.member_1.y)), select(_e139.member_1.z, _e120.member_1.z, (_e120.member_1.z > _e139.member_1.z)));
                        phi_3119_ = false;
                        phi_292_ = type_4(0u, 128u);
                        phi_295_ = 0u;
                        loop {
                            let _e171 = phi_3119_;
                            let _e173 = phi_292_;
                            let _e175 = phi_295_;
                            if (_e173.member < _e173.member_1) {
                                phi_293_ = type_4((_e173.member + 1u), _e173.member_1);
                                phi_318_ = type_4(1u, _e173.member);
                            } else {
                                phi_293_ = _e173;
                                phi_318_ = type_4(0u, type_4().member_1);
                            }
                            let _e188 = phi_293_;
                            let _e190 = phi_318_;
                            if (bitcast<i32>(_e190.member) != 0i) {
                                let _e194 = (_e175 == _e86);
                                if _e194 {
                                    phi_3174_ = _e171;
                                    phi_947_ = u32();
                                } else {
                                    let _e195 = (_e175 < _e74);
                                    if _e195 {
                                        if _e195 {
                                        } else {
                                            phi_3172_ = true;
                                            break;
                                        }
                                        let _e198 = global_4.member[_e175];
                                        phi_340_ = _e198;
                                    } else {
                                        phi_340_ = type_26(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e200 = phi_340_;
                                    if ((_e200.member_1 & 2147483648u) != 0u) {
                                        phi_349_ = false;
                                    } else {
                                        phi_349_ = (_e86 <= _e200.member_1);
                                    }
                                    let _e207 = phi_349_;
                                    if (_e200.member_1 == 2147483648u) {
                                        phi_367_ = type_31(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                    } else {
                                        phi_367_ = type_31(vec3<f32>(_e200.member[0][0], _e200.member[1][0], _e200.member[2][0]), vec3<f32>(_e200.member[0][2], _e200.member[1][2], _e200.member[2][2]));
                                    }
                                    let _e225 = phi_367_;
                                    if (_e200.member_2 == 2147483648u) {
                                        phi_385_ = _e225;
                                    } else {
                                        phi_385_ = type_31(vec3<f32>(_e200.member[0][1], _e200.member[1][1], _e200.member[2][1]), vec3<f32>(_e200.member[0][3], _e200.member[1][3], _e200.member[2][3]));
                                    }
                                    let _e243 = phi_385_;
                                    if _e207 {
                                        phi_389_ = _e225;
                                    } else {
                                        phi_389_ = _e243;
                                    }
                                    let _e245 = phi_389_;
                                    local_9 = array<f32, 3>(_e245.member.x, _e245.member.y, _e245.member.z);
                                    local_8 = array<f32, 3>(_e245.member_1.x, _e245.member_1.y, _e245.member_1.z);
                                    phi_412_ = type_4(0u, 3u);
                                    phi_415_ = array<u32, 2>(0u, 0u);
                                    loop {
                                        let _e261 = phi_412_;
                                        let _e263 = phi_415_;
                                        local_25 = _e263;
                                        local_26 = _e263;
                                        if (_e261.member < _e261.member_1) {
                                            phi_413_ = type_4((_e261.member + 1u), _e261.member_1);
                                            phi_438_ = type_4(1u, _e261.member);
                                        } else {
                                            phi_413_ = _e261;
                                            phi_438_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e276 = phi_413_;
                                        let _e278 = phi_438_;
                                        let _e282 = (bitcast<i32>(_e278.member) != 0i);
                                        if _e282 {
                                            let _e283 = (_e278.member_1 < 3u);
                                            if _e283 {
                                            } else {
                                                phi_3109_ = true;
                                                break;
                                            }
                                            let _e285 = local_7[_e278.member_1];
                                            if _e283 {
                                            } else {
                                                phi_3109_ = true;
                                                break;
                                            }
                                            let _e287 = local_6[_e278.member_1];
                                            if _e283 {
                                            } else {
                                                phi_3109_ = true;
                                                break;
                                            }
                                            let _e289 = local_9[_e278.member_1];
                                            let _e290 = (_e287 - _e285);
                                            let _e291 = (_e290 > 0f);
                                            if _e291 {
                                                phi_477_ = (((_e289 - _e285) / _e290) * 1023f);
                                            } else {
                                                phi_477_ = 0f;
                                            }
                                            let _e296 = phi_477_;
                                            let _e298 = select(1023f, _e296, (_e296 < 1023f));
                                            let _e300 = select(0f, _e298, (_e298 > 0f));
                                            let _e305 = select(select(u32(_e300), 0u, (_e300 < 0f)), 4294967295u, (_e300 > 4294967000f));
                                            if (_e305 > 0u) {
                                                let _e316 = (_e285 + bitcast<f32>((bitcast<u32>((f32(_e305) * bitcast<f32>((bitcast<u32>((_e290 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                                let _e321 = (select(select(_e287, _e316, (_e316 < _e287)), _e287, (_e305 == 1023u)) > _e289);
                                                if _e321 {
                                                    phi_528_ = (_e305 - 1u);
                                                } else {
                                                    phi_528_ = u32();
                                                }
                                                let _e324 = phi_528_;
                                                phi_530_ = _e324;
                                                phi_531_ = select(true, false, _e321);
                                            } else {
                                                phi_530_ = u32();
                                                phi_531_ = true;
                                            }
                                            let _e327 = phi_530_;
                                            let _e329 = phi_531_;
                                            if _e329 {
                                                if (_e305 < 1023u) {
                                                    let _e331 = (_e305 + 1u);
                                                    let _e341 = (_e285 + bitcast<f32>((bitcast<u32>((f32(_e331) * bitcast<f32>((bitcast<u32>((_e290 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                                    phi_569_ = select(_e305, _e331, (select(select(_e287, _e341, (_e341 < _e287)), _e287, (_e331 == 1023u)) <= _e289));
                                                } else {
                                                    phi_569_ = _e305;
                                                }
                                                let _e349 = phi_569_;
                                                phi_570_ = _e349;
                                            } else {
                                                phi_570_ = _e327;
                                            }
                                            let _e351 = phi_570_;
                                            let _e355 = bitcast<f32>((bitcast<u32>((_e290 * 0.0009775171f)) ^ _e95));
                                            let _e361 = (_e285 + bitcast<f32>((bitcast<u32>((f32(_e351) * _e355)) ^ _e95)));
                                            let _e369 = ((10u * _e278.member_1) & 31u);
                                            if _e283 {
                                            } else {
                                                phi_3109_ = true;
                                                break;
                                            }
                                            let _e375 = local_8[_e278.member_1];
                                            if _e291 {
                                                phi_622_ = (((_e375 - _e285) / _e290) * 1023f);
                                            } else {
                                                phi_622_ = 0f;
                                            }
                                            let _e380 = phi_622_;
                                            let _e382 = select(1023f, _e380, (_e380 < 1023f));
                                            let _e384 = select(0f, _e382, (_e382 > 0f));
                                            let _e389 = select(select(u32(_e384), 0u, (_e384 < 0f)), 4294967295u, (_e384 > 4294967000f));
                                            if (_e389 > 0u) {
                                                let _e396 = (_e285 + bitcast<f32>((bitcast<u32>((f32(_e389) * _e355)) ^ _e95)));
                                                let _e401 = (select(select(_e287, _e396, (_e396 < _e287)), _e287, (_e389 == 1023u)) > _e375);
                                                if _e401 {
                                                    phi_673_ = (_e389 - 1u);
                                                } else {
                                                    phi_673_ = u32();
                                                }
                                                let _e404 = phi_673_;
                                                phi_675_ = _e404;
                                                phi_676_ = select(true, false, _e401);
                                            } else {
                                                phi_675_ = u32();
                                                phi_676_ = true;
                                            }
                                            let _e407 = phi_675_;
                                            let _e409 = phi_676_;
                                            if _e409 {
                                                if (_e389 < 1023u) {
                                                    let _e411 = (_e389 + 1u);
                                                    let _e417 = (_e285 + bitcast<f32>((bitcast<u32>((f32(_e411) * _e355)) ^ _e95)));
                                                    phi_714_ = select(_e389, _e411, (select(select(_e287, _e417, (_e417 < _e287)), _e287, (_e411 == 1023u)) <= _e375));
                                                } else {
                                                    phi_714_ = _e389;
                                                }
                                                let _e425 = phi_714_;
                                                phi_715_ = _e425;
                                            } else {
                                                phi_715_ = _e407;
                                            }
                                            let _e427 = phi_715_;
                                            let _e433 = (_e285 + bitcast<f32>((bitcast<u32>((f32(_e427) * _e355)) ^ _e95)));
                                            let _e439 = select(_e427, 0u, (select(select(_e287, _e433, (_e433 < _e287)), _e287, (_e427 == 1023u)) > _e375));
                                            if (_e439 < 1023u) {
                                                let _e446 = (_e285 + bitcast<f32>((bitcast<u32>((f32(_e439) * _e355)) ^ _e95)));
                                                let _e451 = (select(select(_e287, _e446, (_e446 < _e287)), _e287, (_e439 == 1023u)) < _e375);
                                                if _e451 {
                                                    phi_776_ = (_e439 + 1u);
                                                } else {
                                                    phi_776_ = u32();
                                                }
                                                let _e454 = phi_776_;
                                                phi_778_ = _e454;
                                                phi_779_ = select(true, false, _e451);
                                            } else {
                                                phi_778_ = u32();
                                                phi_779_ = true;
                                            }
                                            let _e457 = phi_778_;
                                            let _e459 = phi_779_;
                                            phi_416_ = array<u32, 2>((_e263[0] | (select(_e351, 0u, (select(select(_e287, _e361, (_e361 < _e287)), _e287, (_e351 == 1023u)) > _e289)) << bitcast<u32>(_e369))), (_e263[1] | (select(_e457, _e439, _e459) << bitcast<u32>(_e369))));
                                        } else {
                                            phi_416_ = array<u32, 2>();
                                        }
                                        let _e467 = phi_416_;
                                        continue;
                                        continuing {
                                            phi_412_ = _e276;
                                            phi_415_ = _e467;
                                            phi_3109_ = _e171;
                                            break if !(_e282);
                                        }
                                    }
                                    let _e470 = phi_3109_;
                                    phi_3172_ = _e470;
                                    if _e470 {
                                        break;
                                    }
                                    local_24 = array<u32, 3>(0u, 1u, 2u);
                                    local_11 = array<f32, 3>(0f, 0f, 0f);
                                    local_10 = array<f32, 3>(0f, 0f, 0f);
                                    phi_797_ = type_4(0u, 3u);
                                    loop {
                                        let _e472 = phi_797_;
                                        if (_e472.member < _e472.member_1) {
                                            phi_798_ = type_4((_e472.member + 1u), _e472.member_1);
                                            phi_821_ = type_4(1u, _e472.member);
                                        } else {
                                            phi_798_ = _e472;
                                            phi_821_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e485 = phi_798_;
                                        let _e487 = phi_821_;
                                        let _e491 = (bitcast<i32>(_e487.member) != 0i);
                                        if _e491 {
                                            let _e492 = (_e487.member_1 < 3u);
                                            if _e492 {
                                            } else {
                                                phi_3164_ = true;
                                                break;
                                            }
                                            let _e494 = local_24[_e487.member_1];
                                            if _e492 {
                                            } else {
                                                phi_3164_ = true;
                                                break;
                                            }
                                            let _e496 = local_7[_e487.member_1];
                                            if _e492 {
                                            } else {
                                                phi_3164_ = true;
                                                break;
                                            }
                                            let _e498 = local_6[_e487.member_1];
                                            let _e500 = local_25;
                                            let _e503 = ((10u * _e494) & 31u);
                                            let _e506 = ((_e500[0] >> bitcast<u32>(_e503)) & 1023u);
                                            let _e511 = bitcast<f32>((bitcast<u32>(((_e498 - _e496) * 0.0009775171f)) ^ _e95));
                                            let _e517 = (_e496 + bitcast<f32>((bitcast<u32>((f32(_e506) * _e511)) ^ _e95)));
                                            if _e492 {
                                            } else {
                                                phi_3164_ = true;
                                                break;
                                            }
                                            local_11[_e487.member_1] = select(select(_e498, _e517, (_e517 < _e498)), _e498, (_e506 == 1023u));
                                            let _e524 = local_26;
                                            let _e528 = ((_e524[1] >> bitcast<u32>(_e503)) & 1023u);
                                            let _e534 = (_e496 + bitcast<f32>((bitcast<u32>((f32(_e528) * _e511)) ^ _e95)));
                                            if _e492 {
                                            } else {
                                                phi_3164_ = true;
                                                break;
                                            }
                                            local_10[_e487.member_1] = select(select(_e498, _e534, (_e534 < _e498)), _e498, (_e528 == 1023u));
                                        }
                                        continue;
                                        continuing {
                                            phi_797_ = _e485;
                                            phi_3164_ = _e470;
                                            break if !(_e491);
                                        }
                                    }
                                    let _e542 = phi_3164_;
                                    phi_3172_ = _e542;
                                    if _e542 {
                                        break;
                                    }
                                    let _e543 = local_10;
                                    let _e544 = local_11;
                                    local_7 = _e544;
                                    local_6 = _e543;
                                    phi_3174_ = _e542;
                                    phi_947_ = select(_e200.member_2, _e200.member_1, _e207);
                                }
                                let _e547 = phi_3174_;
                                let _e549 = phi_947_;
                                phi_3173_ = _e547;
                                phi_296_ = _e549;
                                phi_949_ = select(true, false, _e194);
                            } else {
                                phi_3173_ = _e171;
                                phi_296_ = u32();
                                phi_949_ = false;
                            }
                            let _e552 = phi_3173_;
                            let _e554 = phi_296_;
                            let _e556 = phi_949_;
                            continue;
                            continuing {
                                phi_3119_ = _e552;
                                phi_292_ = _e188;
                                phi_295_ = _e554;
                                phi_3172_ = _e552;
                                break if !(_e556);
                            }
                        }
                        let _e559 = phi_3172_;
                        if _e559 {
                            break;
                        }
                        let _e560 = local_6;
                        let _e561 = local_7;
                        local_5 = _e561;
                        local_4 = _e560;
                        if _e91 {
                        } else {
                            break;
                        }
                        let _e565 = global_4.member[_e86].member_1;
                        if (_e565 == 2147483648u) {
                            phi_1000_ = type_31(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            let _e571 = global_4.member[_e86].member[0u];
                            let _e576 = global_4.member[_e86].member[1u];
                            let _e581 = global_4.member[_e86].member[2u];
                            phi_1000_ = type_31(vec3<f32>(_e571[0], _e576[0], _e581[0]), vec3<f32>(_e571[2], _e576[2], _e581[2]));
                        }
                        let _e592 = phi_1000_;
                        let _e596 = global_4.member[_e86].member_2;
                        if (_e596 == 2147483648u) {
                            phi_1022_ = _e592;
                        } else {
                            let _e602 = global_4.member[_e86].member[0u];
                            let _e607 = global_4.member[_e86].member[1u];
                            let _e612 = global_4.member[_e86].member[2u];
                            phi_1022_ = type_31(vec3<f32>(_e602[1], _e607[1], _e612[1]), vec3<f32>(_e602[3], _e607[3], _e612[3]));
                        }
                        let _e623 = phi_1022_;
                        local_15 = array<f32, 3>(_e592.member.x, _e592.member.y, _e592.member.z);
                        local_14 = array<f32, 3>(_e592.member_1.x, _e592.member_1.y, _e592.member_1.z);
                        local_13 = array<f32, 3>(_e623.member.x, _e623.member.y, _e623.member.z);
                        local_12 = array<f32, 3>(_e623.member_1.x, _e623.member_1.y, _e623.member_1.z);
                        phi_1066_ = type_4(0u, 3u);
                        phi_1069_ = array<u32, 2>(0u, 0u);
                        loop {
                            let _e653 = phi_1066_;
                            let _e655 = phi_1069_;
                            local_27 = _e655;
                            local_28 = _e655;
                            local_31 = _e655;
                            if (_e653.member < _e653.member_1) {
                                phi_1067_ = type_4((_e653.member + 1u), _e653.member_1);
                                phi_1092_ = type_4(1u, _e653.member);
                            } else {
                                phi_1067_ = _e653;
                                phi_1092_ = type_4(0u, type_4().member_1);
                            }
                            let _e668 = phi_1067_;
                            let _e670 = phi_1092_;
                            let _e674 = (bitcast<i32>(_e670.member) != 0i);
                            if _e674 {
                                let _e675 = (_e670.member_1 < 3u);
                                if _e675 {
                                } else {
                                    phi_3176_ = true;
                                    break;
                                }
                                let _e677 = local_5[_e670.member_1];
                                if _e675 {
                                } else {
                                    phi_3176_ = true;
                                    break;
                                }
                                let _e679 = local_4[_e670.member_1];
                                if _e675 {
                                } else {
                                    phi_3176_ = true;
                                    break;
                                }
                                let _e681 = local_15[_e670.member_1];
                                let _e682 = (_e679 - _e677);
                                let _e683 = (_e682 > 0f);
                                if _e683 {
                                    phi_1131_ = (((_e681 - _e677) / _e682) * 1023f);
                                } else {
                                    phi_1131_ = 0f;
                                }
                                let _e688 = phi_1131_;
                                let _e690 = select(1023f, _e688, (_e688 < 1023f));
                                let _e692 = select(0f, _e690, (_e690 > 0f));
                                let _e697 = select(select(u32(_e692), 0u, (_e692 < 0f)), 4294967295u, (_e692 > 4294967000f));
                                if (_e697 > 0u) {
                                    let _e708 = (_e677 + bitcast<f32>((bitcast<u32>((f32(_e697) * bitcast<f32>((bitcast<u32>((_e682 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                    let _e713 = (select(select(_e679, _e708, (_e708 < _e679)), _e679, (_e697 == 1023u)) > _e681);
                                    if _e713 {
                                        phi_1182_ = (_e697 - 1u);
                                    } else {
                                        phi_1182_ = u32();
                                    }
                                    let _e716 = phi_1182_;
                                    phi_1184_ = _e716;
                                    phi_1185_ = select(true, false, _e713);
                                } else {
                                    phi_1184_ = u32();
                                    phi_1185_ = true;
                                }
                                let _e719 = phi_1184_;
                                let _e721 = phi_1185_;
                                if _e721 {
                                    if (_e697 < 1023u) {
                                        let _e723 = (_e697 + 1u);
                                        let _e733 = (_e677 + bitcast<f32>((bitcast<u32>((f32(_e723) * bitcast<f32>((bitcast<u32>((_e682 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                        phi_1223_ = select(_e697, _e723, (select(select(_e679, _e733, (_e733 < _e679)), _e679, (_e723 == 1023u)) <= _e681));
                                    } else {
                                        phi_1223_ = _e697;
                                    }
                                    let _e741 = phi_1223_;
                                    phi_1224_ = _e741;
                                } else {
                                    phi_1224_ = _e719;
                                }
                                let _e743 = phi_1224_;
                                let _e747 = bitcast<f32>((bitcast<u32>((_e682 * 0.0009775171f)) ^ _e95));
                                let _e753 = (_e677 + bitcast<f32>((bitcast<u32>((f32(_e743) * _e747)) ^ _e95)));
                                let _e761 = ((10u * _e670.member_1) & 31u);
                                if _e675 {
                                } else {
                                    phi_3176_ = true;
                                    break;
                                }
                                let _e767 = local_14[_e670.member_1];
                                if _e683 {
                                    phi_1276_ = (((_e767 - _e677) / _e682) * 1023f);
                                } else {
                                    phi_1276_ = 0f;
                                }
                                let _e772 = phi_1276_;
                                let _e774 = select(1023f, _e772, (_e772 < 1023f));
                                let _e776 = select(0f, _e774, (_e774 > 0f));
                                let _e781 = select(select(u32(_e776), 0u, (_e776 < 0f)), 4294967295u, (_e776 > 4294967000f));
                                if (_e781 > 0u) {
                                    let _e788 = (_e677 + bitcast<f32>((bitcast<u32>((f32(_e781) * _e747)) ^ _e95)));
                                    let _e793 = (select(select(_e679, _e788, (_e788 < _e679)), _e679, (_e781 == 1023u)) > _e767);
                                    if _e793 {
                                        phi_1327_ = (_e781 - 1u);
                                    } else {
                                        phi_1327_ = u32();
                                    }
                                    let _e796 = phi_1327_;
                                    phi_1329_ = _e796;
                                    phi_1330_ = select(true, false, _e793);
                                } else {
                                    phi_1329_ = u32();
                                    phi_1330_ = true;
                                }
                                let _e799 = phi_1329_;
                                let _e801 = phi_1330_;
                                if _e801 {
                                    if (_e781 < 1023u) {
                                        let _e803 = (_e781 + 1u);
                                        let _e809 = (_e677 + bitcast<f32>((bitcast<u32>((f32(_e803) * _e747)) ^ _e95)));
                                        phi_1368_ = select(_e781, _e803, (select(select(_e679, _e809, (_e809 < _e679)), _e679, (_e803 == 1023u)) <= _e767));
                                    } else {
                                        phi_1368_ = _e781;
                                    }
                                    let _e817 = phi_1368_;
                                    phi_1369_ = _e817;
                                } else {
                                    phi_1369_ = _e799;
                                }
                                let _e819 = phi_1369_;
                                let _e825 = (_e677 + bitcast<f32>((bitcast<u32>((f32(_e819) * _e747)) ^ _e95)));
                                let _e831 = select(_e819, 0u, (select(select(_e679, _e825, (_e825 < _e679)), _e679, (_e819 == 1023u)) > _e767));
                                if (_e831 < 1023u) {
                                    let _e838 = (_e677 + bitcast<f32>((bitcast<u32>((f32(_e831) * _e747)) ^ _e95)));
                                    let _e843 = (select(select(_e679, _e838, (_e838 < _e679)), _e679, (_e831 == 1023u)) < _e767);
                                    if _e843 {
                                        phi_1430_ = (_e831 + 1u);
                                    } else {
                                        phi_1430_ = u32();
                                    }
                                    let _e846 = phi_1430_;
                                    phi_1432_ = _e846;
                                    phi_1433_ = select(true, false, _e843);
                                } else {
                                    phi_1432_ = u32();
                                    phi_1433_ = true;
                                }
                                let _e849 = phi_1432_;
                                let _e851 = phi_1433_;
                                phi_1070_ = array<u32, 2>((_e655[0] | (select(_e743, 0u, (select(select(_e679, _e753, (_e753 < _e679)), _e679, (_e743 == 1023u)) > _e681)) << bitcast<u32>(_e761))), (_e655[1] | (select(_e849, _e831, _e851) << bitcast<u32>(_e761))));
                            } else {
                                phi_1070_ = array<u32, 2>();
                            }
                            let _e859 = phi_1070_;
                            continue;
                            continuing {
                                phi_1066_ = _e668;
                                phi_1069_ = _e859;
                                phi_3176_ = _e559;
                                break if !(_e674);
                            }
                        }
                        let _e862 = phi_3176_;
                        if _e862 {
                            break;
                        }
                        phi_1446_ = type_4(0u, 3u);
                        phi_1449_ = array<u32, 2>(0u, 0u);
                        loop {
                            let _e864 = phi_1446_;
                            let _e866 = phi_1449_;
                            local_29 = _e866;
                            local_30 = _e866;
                            local_32 = _e866;
                            if (_e864.member < _e864.member_1) {
                                phi_1447_ = type_4((_e864.member + 1u), _e864.member_1);
                                phi_1472_ = type_4(1u, _e864.member);
                            } else {
                                phi_1447_ = _e864;
                                phi_1472_ = type_4(0u, type_4().member_1);
                            }
                            let _e879 = phi_1447_;
                            let _e881 = phi_1472_;
                            let _e885 = (bitcast<i32>(_e881.member) != 0i);
                            if _e885 {
                                let _e886 = (_e881.member_1 < 3u);
                                if _e886 {
                                } else {
                                    phi_3217_ = true;
                                    break;
                                }
                                let _e888 = local_5[_e881.member_1];
                                if _e886 {
                                } else {
                                    phi_3217_ = true;
                                    break;
                                }
                                let _e890 = local_4[_e881.member_1];
                                if _e886 {
                                } else {
                                    phi_3217_ = true;
                                    break;
                                }
                                let _e892 = local_13[_e881.member_1];
                                let _e893 = (_e890 - _e888);
                                let _e894 = (_e893 > 0f);
                                if _e894 {
                                    phi_1511_ = (((_e892 - _e888) / _e893) * 1023f);
                                } else {
                                    phi_1511_ = 0f;
                                }
                                let _e899 = phi_1511_;
                                let _e901 = select(1023f, _e899, (_e899 < 1023f));
                                let _e903 = select(0f, _e901, (_e901 > 0f));
                                let _e908 = select(select(u32(_e903), 0u, (_e903 < 0f)), 4294967295u, (_e903 > 4294967000f));
                                if (_e908 > 0u) {
                                    let _e919 = (_e888 + bitcast<f32>((bitcast<u32>((f32(_e908) * bitcast<f32>((bitcast<u32>((_e893 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                    let _e924 = (select(select(_e890, _e919, (_e919 < _e890)), _e890, (_e908 == 1023u)) > _e892);
                                    if _e924 {
                                        phi_1562_ = (_e908 - 1u);
                                    } else {
                                        phi_1562_ = u32();
                                    }
                                    let _e927 = phi_1562_;
                                    phi_1564_ = _e927;
                                    phi_1565_ = select(true, false, _e924);
                                } else {
                                    phi_1564_ = u32();
                                    phi_1565_ = true;
                                }
                                let _e930 = phi_1564_;
                                let _e932 = phi_1565_;
                                if _e932 {
                                    if (_e908 < 1023u) {
                                        let _e934 = (_e908 + 1u);
                                        let _e944 = (_e888 + bitcast<f32>((bitcast<u32>((f32(_e934) * bitcast<f32>((bitcast<u32>((_e893 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                        phi_1603_ = select(_e908, _e934, (select(select(_e890, _e944, (_e944 < _e890)), _e890, (_e934 == 1023u)) <= _e892));
                                    } else {
                                        phi_1603_ = _e908;
                                    }
                                    let _e952 = phi_1603_;
                                    phi_1604_ = _e952;
                                } else {
                                    phi_1604_ = _e930;
                                }
                                let _e954 = phi_1604_;
                                let _e958 = bitcast<f32>((bitcast<u32>((_e893 * 0.0009775171f)) ^ _e95));
                                let _e964 = (_e888 + bitcast<f32>((bitcast<u32>((f32(_e954) * _e958)) ^ _e95)));
                                let _e972 = ((10u * _e881.member_1) & 31u);
                                if _e886 {
                                } else {
                                    phi_3217_ = true;
                                    break;
                                }
                                let _e978 = local_12[_e881.member_1];
                                if _e894 {
                                    phi_1656_ = (((_e978 - _e888) / _e893) * 1023f);
                                } else {
                                    phi_1656_ = 0f;
                                }
                                let _e983 = phi_1656_;
                                let _e985 = select(1023f, _e983, (_e983 < 1023f));
                                let _e987 = select(0f, _e985, (_e985 > 0f));
                                let _e992 = select(select(u32(_e987), 0u, (_e987 < 0f)), 4294967295u, (_e987 > 4294967000f));
                                if (_e992 > 0u) {
                                    let _e999 = (_e888 + bitcast<f32>((bitcast<u32>((f32(_e992) * _e958)) ^ _e95)));
                                    let _e1004 = (select(select(_e890, _e999, (_e999 < _e890)), _e890, (_e992 == 1023u)) > _e978);
                                    if _e1004 {
                                        phi_1707_ = (_e992 - 1u);
                                    } else {
                                        phi_1707_ = u32();
                                    }
                                    let _e1007 = phi_1707_;
                                    phi_1709_ = _e1007;
                                    phi_1710_ = select(true, false, _e1004);
                                } else {
                                    phi_1709_ = u32();
                                    phi_1710_ = true;
                                }
                                let _e1010 = phi_1709_;
                                let _e1012 = phi_1710_;
                                if _e1012 {
                                    if (_e992 < 1023u) {
                                        let _e1014 = (_e992 + 1u);
                                        let _e1020 = (_e888 + bitcast<f32>((bitcast<u32>((f32(_e1014) * _e958)) ^ _e95)));
                                        phi_1748_ = select(_e992, _e1014, (select(select(_e890, _e1020, (_e1020 < _e890)), _e890, (_e1014 == 1023u)) <= _e978));
                                    } else {
                                        phi_1748_ = _e992;
                                    }
                                    let _e1028 = phi_1748_;
                                    phi_1749_ = _e1028;
                                } else {
                                    phi_1749_ = _e1010;
                                }
                                let _e1030 = phi_1749_;
                                let _e1036 = (_e888 + bitcast<f32>((bitcast<u32>((f32(_e1030) * _e958)) ^ _e95)));
                                let _e1042 = select(_e1030, 0u, (select(select(_e890, _e1036, (_e1036 < _e890)), _e890, (_e1030 == 1023u)) > _e978));
                                if (_e1042 < 1023u) {
                                    let _e1049 = (_e888 + bitcast<f32>((bitcast<u32>((f32(_e1042) * _e958)) ^ _e95)));
                                    let _e1054 = (select(select(_e890, _e1049, (_e1049 < _e890)), _e890, (_e1042 == 1023u)) < _e978);
                                    if _e1054 {
                                        phi_1810_ = (_e1042 + 1u);
                                    } else {
                                        phi_1810_ = u32();
                                    }
                                    let _e1057 = phi_1810_;
                                    phi_1812_ = _e1057;
                                    phi_1813_ = select(true, false, _e1054);
                                } else {
                                    phi_1812_ = u32();
                                    phi_1813_ = true;
                                }
                                let _e1060 = phi_1812_;
                                let _e1062 = phi_1813_;
                                phi_1450_ = array<u32, 2>((_e866[0] | (select(_e954, 0u, (select(select(_e890, _e964, (_e964 < _e890)), _e890, (_e954 == 1023u)) > _e892)) << bitcast<u32>(_e972))), (_e866[1] | (select(_e1060, _e1042, _e1062) << bitcast<u32>(_e972))));
                            } else {
                                phi_1450_ = array<u32, 2>();
                            }
                            let _e1070 = phi_1450_;
                            continue;
                            continuing {
                                phi_1446_ = _e879;
                                phi_1449_ = _e1070;
                                phi_3217_ = _e862;
                                break if !(_e885);
                            }
                        }
                        let _e1073 = phi_3217_;
                        if _e1073 {
                            break;
                        }
                        local_23 = array<u32, 3>(0u, 1u, 2u);
                        local_17 = array<f32, 3>(0f, 0f, 0f);
                        local_16 = array<f32, 3>(0f, 0f, 0f);
                        phi_1836_ = type_4(0u, 3u);
                        loop {
                            let _e1075 = phi_1836_;
                            if (_e1075.member < _e1075.member_1) {
                                phi_1837_ = type_4((_e1075.member + 1u), _e1075.member_1);
                                phi_1860_ = type_4(1u, _e1075.member);
                            } else {
                                phi_1837_ = _e1075;
                                phi_1860_ = type_4(0u, type_4().member_1);
                            }
                            let _e1088 = phi_1837_;
                            let _e1090 = phi_1860_;
                            let _e1094 = (bitcast<i32>(_e1090.member) != 0i);
                            if _e1094 {
                                let _e1095 = (_e1090.member_1 < 3u);
                                if _e1095 {
                                } else {
                                    phi_3256_ = true;
                                    break;
                                }
                                let _e1097 = local_23[_e1090.member_1];
                                if _e1095 {
                                } else {
                                    phi_3256_ = true;
                                    break;
                                }
                                let _e1099 = local_5[_e1090.member_1];
                                if _e1095 {
                                } else {
                                    phi_3256_ = true;
                                    break;
                                }
                                let _e1101 = local_4[_e1090.member_1];
                                let _e1103 = local_27;
                                let _e1106 = ((10u * _e1097) & 31u);
                                let _e1109 = ((_e1103[0] >> bitcast<u32>(_e1106)) & 1023u);
                                let _e1114 = bitcast<f32>((bitcast<u32>(((_e1101 - _e1099) * 0.0009775171f)) ^ _e95));
                                let _e1120 = (_e1099 + bitcast<f32>((bitcast<u32>((f32(_e1109) * _e1114)) ^ _e95)));
                                if _e1095 {
                                } else {
                                    phi_3256_ = true;
                                    break;
                                }
                                local_17[_e1090.member_1] = select(select(_e1101, _e1120, (_e1120 < _e1101)), _e1101, (_e1109 == 1023u));
                                let _e1127 = local_28;
                                let _e1131 = ((_e1127[1] >> bitcast<u32>(_e1106)) & 1023u);
                                let _e1137 = (_e1099 + bitcast<f32>((bitcast<u32>((f32(_e1131) * _e1114)) ^ _e95)));
                                if _e1095 {
                                } else {
                                    phi_3256_ = true;
                                    break;
                                }
                                local_16[_e1090.member_1] = select(select(_e1101, _e1137, (_e1137 < _e1101)), _e1101, (_e1131 == 1023u));
                            }
                            continue;
                            continuing {
                                phi_1836_ = _e1088;
                                phi_3256_ = _e1073;
                                break if !(_e1094);
                            }
                        }
                        let _e1145 = phi_3256_;
                        if _e1145 {
                            break;
                        }
                        let _e1146 = local_16;
                        let _e1147 = local_17;
                        local_22 = array<u32, 3>(0u, 1u, 2u);
                        local_19 = array<f32, 3>(0f, 0f, 0f);
                        local_18 = array<f32, 3>(0f, 0f, 0f);
                        phi_1977_ = type_4(0u, 3u);
                        loop {
                            let _e1149 = phi_1977_;
                            if (_e1149.member < _e1149.member_1) {
                                phi_1978_ = type_4((_e1149.member + 1u), _e1149.member_1);
                                phi_2001_ = type_4(1u, _e1149.member);
                            } else {
                                phi_1978_ = _e1149;
                                phi_2001_ = type_4(0u, type_4().member_1);
                            }
                            let _e1162 = phi_1978_;
                            let _e1164 = phi_2001_;
                            let _e1168 = (bitcast<i32>(_e1164.member) != 0i);
                            if _e1168 {
                                let _e1169 = (_e1164.member_1 < 3u);
                                if _e1169 {
                                } else {
                                    phi_3264_ = true;
                                    break;
                                }
                                let _e1171 = local_22[_e1164.member_1];
                                if _e1169 {
                                } else {
                                    phi_3264_ = true;
                                    break;
                                }
                                let _e1173 = local_5[_e1164.member_1];
                                if _e1169 {
                                } else {
                                    phi_3264_ = true;
                                    break;
                                }
                                let _e1175 = local_4[_e1164.member_1];
                                let _e1177 = local_29;
                                let _e1180 = ((10u * _e1171) & 31u);
                                let _e1183 = ((_e1177[0] >> bitcast<u32>(_e1180)) & 1023u);
                                let _e1188 = bitcast<f32>((bitcast<u32>(((_e1175 - _e1173) * 0.0009775171f)) ^ _e95));
                                let _e1194 = (_e1173 + bitcast<f32>((bitcast<u32>((f32(_e1183) * _e1188)) ^ _e95)));
                                if _e1169 {
                                } else {
                                    phi_3264_ = true;
                                    break;
                                }
                                local_19[_e1164.member_1] = select(select(_e1175, _e1194, (_e1194 < _e1175)), _e1175, (_e1183 == 1023u));
                                let _e1201 = local_30;
                                let _e1205 = ((_e1201[1] >> bitcast<u32>(_e1180)) & 1023u);
                                let _e1211 = (_e1173 + bitcast<f32>((bitcast<u32>((f32(_e1205) * _e1188)) ^ _e95)));
                                if _e1169 {
                                } else {
                                    phi_3264_ = true;
                                    break;
                                }
                                local_18[_e1164.member_1] = select(select(_e1175, _e1211, (_e1211 < _e1175)), _e1175, (_e1205 == 1023u));
                            }
                            continue;
                            continuing {
                                phi_1977_ = _e1162;
                                phi_3264_ = _e1145;
                                break if !(_e1168);
                            }
                        }
                        let _e1219 = phi_3264_;
                        if _e1219 {
                            break;
                        }
                        let _e1220 = local_18;
                        let _e1221 = local_19;
                        local_3 = _e1147;
                        local_2 = _e1146;
                        local_1 = _e1221;
                        local = _e1220;
                        let _e1223 = local_31;
                        let _e1225 = local_32;
                        if _e92 {
                        } else {
                            break;
                        }
                        global_5.member[_e86] = type_40(_e1223, _e1225, _e565, _e596);
                        if _e91 {
                        } else {
                            break;
                        }
                        if ((_e565 & 2147483648u) != 0u) {
                            phi_3279_ = _e1219;
                            phi_2189_ = type_4(0u, ((_e565 >> bitcast<u32>(28u)) & 7u));
                            loop {
                                let _e1236 = phi_3279_;
                                let _e1238 = phi_2189_;
                                if (_e1238.member < _e1238.member_1) {
                                    phi_2190_ = type_4((_e1238.member + 1u), _e1238.member_1);
                                    phi_2213_ = type_4(1u, _e1238.member);
                                } else {
                                    phi_2190_ = _e1238;
                                    phi_2213_ = type_4(0u, type_4().member_1);
                                }
                                let _e1251 = phi_2190_;
                                let _e1253 = phi_2213_;
                                let _e1257 = (bitcast<i32>(_e1253.member) != 0i);
                                if _e1257 {
                                    let _e1259 = ((_e565 & 268435455u) + _e1253.member_1);
                                    let _e1260 = (_e1259 < _e76);
                                    if _e1260 {
                                        let _e1261 = (_e1259 < _e80);
                                        if _e1261 {
                                            if _e1260 {
                                            } else {
                                                phi_3303_ = true;
                                                break;
                                            }
                                            local_21 = array<u32, 3>(0u, 0u, 0u);
                                            phi_3277_ = _e1236;
                                            phi_2239_ = type_4(0u, 3u);
                                            loop {
                                                let _e1263 = phi_3277_;
                                                let _e1265 = phi_2239_;
                                                if (_e1265.member < _e1265.member_1) {
                                                    phi_2240_ = type_4((_e1265.member + 1u), _e1265.member_1);
                                                    phi_2263_ = type_4(1u, _e1265.member);
                                                } else {
                                                    phi_2240_ = _e1265;
                                                    phi_2263_ = type_4(0u, type_4().member_1);
                                                }
                                                let _e1278 = phi_2240_;
                                                let _e1280 = phi_2263_;
                                                let _e1284 = (bitcast<i32>(_e1280.member) != 0i);
                                                if _e1284 {
                                                    phi_2273_ = type_4(0u, 3u);
                                                    loop {
                                                        let _e1286 = phi_2273_;
                                                        if (_e1286.member < _e1286.member_1) {
                                                            phi_2274_ = type_4((_e1286.member + 1u), _e1286.member_1);
                                                            phi_2297_ = type_4(1u, _e1286.member);
                                                        } else {
                                                            phi_2274_ = _e1286;
                                                            phi_2297_ = type_4(0u, type_4().member_1);
                                                        }
                                                        let _e1299 = phi_2274_;
                                                        let _e1301 = phi_2297_;
                                                        let _e1305 = (bitcast<i32>(_e1301.member) != 0i);
                                                        if _e1305 {
                                                            let _e1308 = (((3u * _e1280.member_1) + _e1301.member_1) % 9u);
                                                            if (_e1308 < 9u) {
                                                            } else {
                                                                phi_3272_ = true;
                                                                break;
                                                            }
                                                            let _e1314 = global_2.member[_e1259].member[_e1308];
                                                            let _e1315 = (_e1301.member_1 < 3u);
                                                            if _e1315 {
                                                            } else {
                                                                phi_3272_ = true;
                                                                break;
                                                            }
                                                            let _e1317 = local_3[_e1301.member_1];
                                                            if _e1315 {
                                                            } else {
                                                                phi_3272_ = true;
                                                                break;
                                                            }
                                                            let _e1319 = local_2[_e1301.member_1];
                                                            let _e1320 = (_e1319 - _e1317);
                                                            if (_e1320 > 0f) {
                                                                phi_2339_ = (((_e1314 - _e1317) / _e1320) * 1023f);
                                                            } else {
                                                                phi_2339_ = 0f;
                                                            }
                                                            let _e1326 = phi_2339_;
                                                            let _e1328 = select(1023f, _e1326, (_e1326 < 1023f));
                                                            let _e1330 = select(0f, _e1328, (_e1328 > 0f));
                                                            let _e1335 = select(select(u32(_e1330), 0u, (_e1330 < 0f)), 4294967295u, (_e1330 > 4294967000f));
                                                            if (_e1335 > 0u) {
                                                                let _e1346 = (_e1317 + bitcast<f32>((bitcast<u32>((f32(_e1335) * bitcast<f32>((bitcast<u32>((_e1320 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                                                let _e1351 = (select(select(_e1319, _e1346, (_e1346 < _e1319)), _e1319, (_e1335 == 1023u)) > _e1314);
                                                                if _e1351 {
                                                                    phi_2390_ = (_e1335 - 1u);
                                                                } else {
                                                                    phi_2390_ = u32();
                                                                }
                                                                let _e1354 = phi_2390_;
                                                                phi_2392_ = _e1354;
                                                                phi_2393_ = select(true, false, _e1351);
                                                            } else {
                                                                phi_2392_ = u32();
                                                                phi_2393_ = true;
                                                            }
                                                            let _e1357 = phi_2392_;
                                                            let _e1359 = phi_2393_;
                                                            if _e1359 {
                                                                if (_e1335 < 1023u) {
                                                                    let _e1361 = (_e1335 + 1u);
                                                                    let _e1371 = (_e1317 + bitcast<f32>((bitcast<u32>((f32(_e1361) * bitcast<f32>((bitcast<u32>((_e1320 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                                                    phi_2431_ = select(_e1335, _e1361, (select(select(_e1319, _e1371, (_e1371 < _e1319)), _e1319, (_e1361 == 1023u)) <= _e1314));
                                                                } else {
                                                                    phi_2431_ = _e1335;
                                                                }
                                                                let _e1379 = phi_2431_;
                                                                phi_2432_ = _e1379;
                                                            } else {
                                                                phi_2432_ = _e1357;
                                                            }
                                                            let _e1381 = phi_2432_;
                                                            let _e1385 = bitcast<f32>((bitcast<u32>((_e1320 * 0.0009775171f)) ^ _e95));
                                                            let _e1391 = (_e1317 + bitcast<f32>((bitcast<u32>((f32(_e1381) * _e1385)) ^ _e95)));
                                                            let _e1397 = select(_e1381, 0u, (select(select(_e1319, _e1391, (_e1391 < _e1319)), _e1319, (_e1381 == 1023u)) > _e1314));
                                                            if (_e1397 < 1023u) {
                                                                phi_2466_ = (_e1397 + 1u);
                                                            } else {
                                                                phi_2466_ = _e1397;
                                                            }
                                                            let _e1401 = phi_2466_;
                                                            let _e1407 = (_e1317 + bitcast<f32>((bitcast<u32>((f32(_e1397) * _e1385)) ^ _e95)));
                                                            let _e1421 = (_e1317 + bitcast<f32>((bitcast<u32>((f32(_e1401) * _e1385)) ^ _e95)));
                                                            if (_e1280.member_1 < 3u) {
                                                            } else {
                                                                phi_3272_ = true;
                                                                break;
                                                            }
                                                            let _e1438 = local_21[_e1280.member_1];
                                                            local_21[_e1280.member_1] = (_e1438 | (select(_e1397, _e1401, (bitcast<f32>((bitcast<u32>((select(select(_e1319, _e1421, (_e1421 < _e1319)), _e1319, (_e1401 == 1023u)) - _e1314)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e1314 - select(select(_e1319, _e1407, (_e1407 < _e1319)), _e1319, (_e1397 == 1023u)))) & 2147483647u)))) << bitcast<u32>(((10u * _e1301.member_1) & 31u))));
                                                        }
                                                        continue;
                                                        continuing {
                                                            phi_2273_ = _e1299;
                                                            phi_3272_ = _e1263;
                                                            break if !(_e1305);
                                                        }
                                                    }
                                                    let _e1442 = phi_3272_;
                                                    phi_3301_ = _e1442;
                                                    if _e1442 {
                                                        break;
                                                    }
                                                    phi_3302_ = _e1442;
                                                } else {
                                                    phi_3302_ = _e1263;
                                                }
                                                let _e1444 = phi_3302_;
                                                continue;
                                                continuing {
                                                    phi_3277_ = _e1444;
                                                    phi_2239_ = _e1278;
                                                    phi_3301_ = _e1444;
                                                    break if !(_e1284);
                                                }
                                            }
                                            let _e1447 = phi_3301_;
                                            phi_3303_ = _e1447;
                                            if _e1447 {
                                                break;
                                            }
                                            let _e1451 = global_2.member[_e1259].member_1;
                                            let _e1452 = local_21;
                                            if _e1261 {
                                            } else {
                                                phi_3303_ = true;
                                                break;
                                            }
                                            global_6.member[_e1259] = type_46(array<u32, 3>(_e1452[0], _e1452[1], _e1452[2]), _e1451);
                                            phi_3306_ = _e1447;
                                        } else {
                                            phi_3306_ = _e1236;
                                        }
                                        let _e1461 = phi_3306_;
                                        phi_3305_ = _e1461;
                                    } else {
                                        phi_3305_ = _e1236;
                                    }
                                    let _e1463 = phi_3305_;
                                    phi_3304_ = _e1463;
                                } else {
                                    phi_3304_ = _e1236;
                                }
                                let _e1465 = phi_3304_;
                                continue;
                                continuing {
                                    phi_3279_ = _e1465;
                                    phi_2189_ = _e1251;
                                    phi_3303_ = _e1465;
                                    break if !(_e1257);
                                }
                            }
                            let _e1468 = phi_3303_;
                            if _e1468 {
                                break;
                            }
                            phi_3315_ = _e1468;
                        } else {
                            phi_3315_ = _e1219;
                        }
                        let _e1470 = phi_3315_;
                        if _e91 {
                        } else {
                            break;
                        }
                        if ((_e596 & 2147483648u) != 0u) {
                            phi_3314_ = _e1470;
                            phi_2573_ = type_4(0u, ((_e596 >> bitcast<u32>(28u)) & 7u));
                            loop {
                                let _e1478 = phi_3314_;
                                let _e1480 = phi_2573_;
                                if (_e1480.member < _e1480.member_1) {
                                    phi_2574_ = type_4((_e1480.member + 1u), _e1480.member_1);
                                    phi_2597_ = type_4(1u, _e1480.member);
                                } else {
                                    phi_2574_ = _e1480;
                                    phi_2597_ = type_4(0u, type_4().member_1);
                                }
                                let _e1493 = phi_2574_;
                                let _e1495 = phi_2597_;
                                let _e1499 = (bitcast<i32>(_e1495.member) != 0i);
                                if _e1499 {
                                    let _e1501 = ((_e596 & 268435455u) + _e1495.member_1);
                                    let _e1502 = (_e1501 < _e76);
                                    if _e1502 {
                                        let _e1503 = (_e1501 < _e80);
                                        if _e1503 {
                                            if _e1502 {
                                            } else {
                                                phi_3339_ = true;
                                                break;
                                            }
                                            local_20 = array<u32, 3>(0u, 0u, 0u);
                                            phi_3312_ = _e1478;
                                            phi_2623_ = type_4(0u, 3u);
                                            loop {
                                                let _e1505 = phi_3312_;
                                                let _e1507 = phi_2623_;
                                                if (_e1507.member < _e1507.member_1) {
                                                    phi_2624_ = type_4((_e1507.member + 1u), _e1507.member_1);
                                                    phi_2647_ = type_4(1u, _e1507.member);
                                                } else {
                                                    phi_2624_ = _e1507;
                                                    phi_2647_ = type_4(0u, type_4().member_1);
                                                }
                                                let _e1520 = phi_2624_;
                                                let _e1522 = phi_2647_;
                                                let _e1526 = (bitcast<i32>(_e1522.member) != 0i);
                                                if _e1526 {
                                                    phi_2657_ = type_4(0u, 3u);
                                                    loop {
                                                        let _e1528 = phi_2657_;
                                                        if (_e1528.member < _e1528.member_1) {
                                                            phi_2658_ = type_4((_e1528.member + 1u), _e1528.member_1);
                                                            phi_2681_ = type_4(1u, _e1528.member);
                                                        } else {
                                                            phi_2658_ = _e1528;
                                                            phi_2681_ = type_4(0u, type_4().member_1);
                                                        }
                                                        let _e1541 = phi_2658_;
                                                        let _e1543 = phi_2681_;
                                                        let _e1547 = (bitcast<i32>(_e1543.member) != 0i);
                                                        if _e1547 {
                                                            let _e1550 = (((3u * _e1522.member_1) + _e1543.member_1) % 9u);
                                                            if (_e1550 < 9u) {
                                                            } else {
                                                                phi_3307_ = true;
                                                                break;
                                                            }
                                                            let _e1556 = global_2.member[_e1501].member[_e1550];
                                                            let _e1557 = (_e1543.member_1 < 3u);
                                                            if _e1557 {
                                                            } else {
                                                                phi_3307_ = true;
                                                                break;
                                                            }
                                                            let _e1559 = local_1[_e1543.member_1];
                                                            if _e1557 {
                                                            } else {
                                                                phi_3307_ = true;
                                                                break;
                                                            }
                                                            let _e1561 = local[_e1543.member_1];
                                                            let _e1562 = (_e1561 - _e1559);
                                                            if (_e1562 > 0f) {
                                                                phi_2723_ = (((_e1556 - _e1559) / _e1562) * 1023f);
                                                            } else {
                                                                phi_2723_ = 0f;
                                                            }
                                                            let _e1568 = phi_2723_;
                                                            let _e1570 = select(1023f, _e1568, (_e1568 < 1023f));
                                                            let _e1572 = select(0f, _e1570, (_e1570 > 0f));
                                                            let _e1577 = select(select(u32(_e1572), 0u, (_e1572 < 0f)), 4294967295u, (_e1572 > 4294967000f));
                                                            if (_e1577 > 0u) {
                                                                let _e1588 = (_e1559 + bitcast<f32>((bitcast<u32>((f32(_e1577) * bitcast<f32>((bitcast<u32>((_e1562 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                                                let _e1593 = (select(select(_e1561, _e1588, (_e1588 < _e1561)), _e1561, (_e1577 == 1023u)) > _e1556);
                                                                if _e1593 {
                                                                    phi_2774_ = (_e1577 - 1u);
                                                                } else {
                                                                    phi_2774_ = u32();
                                                                }
                                                                let _e1596 = phi_2774_;
                                                                phi_2776_ = _e1596;
                                                                phi_2777_ = select(true, false, _e1593);
                                                            } else {
                                                                phi_2776_ = u32();
                                                                phi_2777_ = true;
                                                            }
                                                            let _e1599 = phi_2776_;
                                                            let _e1601 = phi_2777_;
                                                            if _e1601 {
                                                                if (_e1577 < 1023u) {
                                                                    let _e1603 = (_e1577 + 1u);
                                                                    let _e1613 = (_e1559 + bitcast<f32>((bitcast<u32>((f32(_e1603) * bitcast<f32>((bitcast<u32>((_e1562 * 0.0009775171f)) ^ _e95)))) ^ _e95)));
                                                                    phi_2815_ = select(_e1577, _e1603, (select(select(_e1561, _e1613, (_e1613 < _e1561)), _e1561, (_e1603 == 1023u)) <= _e1556));
                                                                } else {
                                                                    phi_2815_ = _e1577;
                                                                }
                                                                let _e1621 = phi_2815_;
                                                                phi_2816_ = _e1621;
                                                            } else {
                                                                phi_2816_ = _e1599;
                                                            }
                                                            let _e1623 = phi_2816_;
                                                            let _e1627 = bitcast<f32>((bitcast<u32>((_e1562 * 0.0009775171f)) ^ _e95));
                                                            let _e1633 = (_e1559 + bitcast<f32>((bitcast<u32>((f32(_e1623) * _e1627)) ^ _e95)));
                                                            let _e1639 = select(_e1623, 0u, (select(select(_e1561, _e1633, (_e1633 < _e1561)), _e1561, (_e1623 == 1023u)) > _e1556));
                                                            if (_e1639 < 1023u) {
                                                                phi_2850_ = (_e1639 + 1u);
                                                            } else {
                                                                phi_2850_ = _e1639;
                                                            }
                                                            let _e1643 = phi_2850_;
                                                            let _e1649 = (_e1559 + bitcast<f32>((bitcast<u32>((f32(_e1639) * _e1627)) ^ _e95)));
                                                            let _e1663 = (_e1559 + bitcast<f32>((bitcast<u32>((f32(_e1643) * _e1627)) ^ _e95)));
                                                            if (_e1522.member_1 < 3u) {
                                                            } else {
                                                                phi_3307_ = true;
                                                                break;
                                                            }
                                                            let _e1680 = local_20[_e1522.member_1];
                                                            local_20[_e1522.member_1] = (_e1680 | (select(_e1639, _e1643, (bitcast<f32>((bitcast<u32>((select(select(_e1561, _e1663, (_e1663 < _e1561)), _e1561, (_e1643 == 1023u)) - _e1556)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e1556 - select(select(_e1561, _e1649, (_e1649 < _e1561)), _e1561, (_e1639 == 1023u)))) & 2147483647u)))) << bitcast<u32>(((10u * _e1543.member_1) & 31u))));
                                                        }
                                                        continue;
                                                        continuing {
                                                            phi_2657_ = _e1541;
                                                            phi_3307_ = _e1505;
                                                            break if !(_e1547);
                                                        }
                                                    }
                                                    let _e1684 = phi_3307_;
                                                    phi_3337_ = _e1684;
                                                    if _e1684 {
                                                        break;
                                                    }
                                                    phi_3338_ = _e1684;
                                                } else {
                                                    phi_3338_ = _e1505;
                                                }
                                                let _e1686 = phi_3338_;
                                                continue;
                                                continuing {
                                                    phi_3312_ = _e1686;
                                                    phi_2623_ = _e1520;
                                                    phi_3337_ = _e1686;
                                                    break if !(_e1526);
                                                }
                                            }
                                            let _e1689 = phi_3337_;
                                            phi_3339_ = _e1689;
                                            if _e1689 {
                                                break;
                                            }
                                            let _e1693 = global_2.member[_e1501].member_1;
                                            let _e1694 = local_20;
                                            if _e1503 {
                                            } else {
                                                phi_3339_ = true;
                                                break;
                                            }
                                            global_6.member[_e1501] = type_46(array<u32, 3>(_e1694[0], _e1694[1], _e1694[2]), _e1693);
                                            phi_3342_ = _e1689;
                                        } else {
                                            phi_3342_ = _e1478;
                                        }
                                        let _e1703 = phi_3342_;
                                        phi_3341_ = _e1703;
                                    } else {
                                        phi_3341_ = _e1478;
                                    }
                                    let _e1705 = phi_3341_;
                                    phi_3340_ = _e1705;
                                } else {
                                    phi_3340_ = _e1478;
                                }
                                let _e1707 = phi_3340_;
                                continue;
                                continuing {
                                    phi_3314_ = _e1707;
                                    phi_2573_ = _e1493;
                                    phi_3339_ = _e1707;
                                    break if !(_e1499);
                                }
                            }
                            let _e1710 = phi_3339_;
                            if _e1710 {
                                break;
                            }
                        }
                        if (_e86 == 0u) {
                            if (_e82 == 0u) {
                            } else {
                                if (0u < _e82) {
                                } else {
                                    break;
                                }
                                global_7.member[0u] = type_35(array<u32, 4>(bitcast<u32>(_e561[0]), bitcast<u32>(_e561[1]), bitcast<u32>(_e561[2]), 0u), array<u32, 4>(bitcast<u32>(_e560[0]), bitcast<u32>(_e560[1]), bitcast<u32>(_e560[2]), 0u));
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
fn encode_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
