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
    var phi_2554_: bool;
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
    var phi_462_: type_4;
    var phi_465_: u32;
    var phi_463_: type_4;
    var phi_488_: type_4;
    var phi_527_: u32;
    var phi_528_: u32;
    var phi_466_: u32;
    var phi_531_: type_4;
    var phi_534_: u32;
    var phi_532_: type_4;
    var phi_557_: type_4;
    var phi_598_: u32;
    var phi_535_: u32;
    var local_13: u32;
    var local_14: u32;
    var local_15: u32;
    var phi_650_: f32;
    var phi_671_: type_4;
    var phi_674_: u32;
    var phi_672_: type_4;
    var phi_697_: type_4;
    var phi_736_: u32;
    var phi_737_: u32;
    var phi_675_: u32;
    var phi_740_: type_4;
    var phi_743_: u32;
    var phi_741_: type_4;
    var phi_766_: type_4;
    var phi_807_: u32;
    var phi_744_: u32;
    var local_16: u32;
    var local_17: u32;
    var local_18: u32;
    var phi_868_: u32;
    var phi_870_: u32;
    var phi_871_: bool;
    var phi_380_: array<u32, 2>;
    var phi_2544_: bool;
    var phi_889_: type_4;
    var phi_890_: type_4;
    var phi_913_: type_4;
    var local_19: array<u32, 2>;
    var local_20: array<u32, 2>;
    var phi_2609_: bool;
    var phi_2619_: bool;
    var phi_1041_: u32;
    var phi_2618_: bool;
    var phi_261_: u32;
    var phi_1043_: bool;
    var phi_2617_: bool;
    var phi_1094_: type_27;
    var phi_1116_: type_27;
    var phi_1160_: type_4;
    var phi_1163_: array<u32, 2>;
    var phi_1161_: type_4;
    var phi_1186_: type_4;
    var phi_1225_: f32;
    var phi_1246_: type_4;
    var phi_1249_: u32;
    var phi_1247_: type_4;
    var phi_1272_: type_4;
    var phi_1311_: u32;
    var phi_1312_: u32;
    var phi_1250_: u32;
    var phi_1315_: type_4;
    var phi_1318_: u32;
    var phi_1316_: type_4;
    var phi_1341_: type_4;
    var phi_1382_: u32;
    var phi_1319_: u32;
    var local_21: u32;
    var local_22: u32;
    var local_23: u32;
    var phi_1434_: f32;
    var phi_1455_: type_4;
    var phi_1458_: u32;
    var phi_1456_: type_4;
    var phi_1481_: type_4;
    var phi_1520_: u32;
    var phi_1521_: u32;
    var phi_1459_: u32;
    var phi_1524_: type_4;
    var phi_1527_: u32;
    var phi_1525_: type_4;
    var phi_1550_: type_4;
    var phi_1591_: u32;
    var phi_1528_: u32;
    var local_24: u32;
    var local_25: u32;
    var local_26: u32;
    var phi_1652_: u32;
    var phi_1654_: u32;
    var phi_1655_: bool;
    var phi_1164_: array<u32, 2>;
    var phi_2621_: bool;
    var phi_1668_: type_4;
    var phi_1671_: array<u32, 2>;
    var phi_1669_: type_4;
    var phi_1694_: type_4;
    var phi_1733_: f32;
    var phi_1754_: type_4;
    var phi_1757_: u32;
    var phi_1755_: type_4;
    var phi_1780_: type_4;
    var phi_1819_: u32;
    var phi_1820_: u32;
    var phi_1758_: u32;
    var phi_1823_: type_4;
    var phi_1826_: u32;
    var phi_1824_: type_4;
    var phi_1849_: type_4;
    var phi_1890_: u32;
    var phi_1827_: u32;
    var local_27: u32;
    var local_28: u32;
    var local_29: u32;
    var phi_1942_: f32;
    var phi_1963_: type_4;
    var phi_1966_: u32;
    var phi_1964_: type_4;
    var phi_1989_: type_4;
    var phi_2028_: u32;
    var phi_2029_: u32;
    var phi_1967_: u32;
    var phi_2032_: type_4;
    var phi_2035_: u32;
    var phi_2033_: type_4;
    var phi_2058_: type_4;
    var phi_2099_: u32;
    var phi_2036_: u32;
    var local_30: u32;
    var local_31: u32;
    var local_32: u32;
    var phi_2160_: u32;
    var phi_2162_: u32;
    var phi_2163_: bool;
    var phi_1672_: array<u32, 2>;
    var phi_2672_: bool;
    var local_33: array<u32, 2>;
    var local_34: array<u32, 2>;
    var phi_2186_: type_4;
    var phi_2187_: type_4;
    var phi_2210_: type_4;
    var phi_2721_: bool;
    var phi_2316_: type_4;
    var phi_2317_: type_4;
    var phi_2340_: type_4;
    var phi_2725_: bool;
    var local_35: u32;
    var local_36: u32;
    var local_37: u32;
    var local_38: u32;
    var local_39: u32;
    var local_40: u32;

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
                        phi_2554_ = false;
                        phi_257_ = type_4(0u, 128u);
                        phi_260_ = 0u;
                        loop {
                            let _e147 = phi_2554_;
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
                                    phi_2619_ = _e147;
                                    phi_1041_ = u32();
                                } else {
                                    let _e171 = (_e151 < _e54);
                                    if _e171 {
                                        if _e171 {
                                        } else {
                                            phi_2617_ = true;
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
                                        local_19 = _e239;
                                        local_20 = _e239;
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
                                                phi_2544_ = true;
                                                break;
                                            }
                                            let _e261 = local_3[_e254.member_1];
                                            if _e259 {
                                            } else {
                                                phi_2544_ = true;
                                                break;
                                            }
                                            let _e263 = local_2[_e254.member_1];
                                            if _e259 {
                                            } else {
                                                phi_2544_ = true;
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
                                            phi_462_ = type_4(0u, 3u);
                                            phi_465_ = select(select(u32(_e276), 0u, (_e276 < 0f)), 4294967295u, (_e276 > 4294967000f));
                                            loop {
                                                let _e283 = phi_462_;
                                                let _e285 = phi_465_;
                                                local_35 = _e285;
                                                if (_e283.member < _e283.member_1) {
                                                    phi_463_ = type_4((_e283.member + 1u), _e283.member_1);
                                                    phi_488_ = type_4(1u, _e283.member);
                                                } else {
                                                    phi_463_ = _e283;
                                                    phi_488_ = type_4(0u, type_4().member_1);
                                                }
                                                let _e298 = phi_463_;
                                                let _e300 = phi_488_;
                                                let _e303 = (bitcast<i32>(_e300.member) != 0i);
                                                if _e303 {
                                                    if (_e285 > 0u) {
                                                        let _e314 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e285) * bitcast<f32>((bitcast<u32>((_e266 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                                        if (select(select(_e263, _e314, (_e314 < _e263)), _e263, (_e285 == 1023u)) > _e265) {
                                                            phi_527_ = (_e285 - 1u);
                                                        } else {
                                                            phi_527_ = _e285;
                                                        }
                                                        let _e322 = phi_527_;
                                                        phi_528_ = _e322;
                                                    } else {
                                                        phi_528_ = _e285;
                                                    }
                                                    let _e324 = phi_528_;
                                                    phi_466_ = _e324;
                                                } else {
                                                    phi_466_ = u32();
                                                }
                                                let _e326 = phi_466_;
                                                continue;
                                                continuing {
                                                    phi_462_ = _e298;
                                                    phi_465_ = _e326;
                                                    break if !(_e303);
                                                }
                                            }
                                            phi_531_ = type_4(0u, 3u);
                                            let _e1461 = local_35;
                                            phi_534_ = _e1461;
                                            loop {
                                                let _e329 = phi_531_;
                                                let _e331 = phi_534_;
                                                local_13 = _e331;
                                                local_14 = _e331;
                                                local_15 = _e331;
                                                if (_e329.member < _e329.member_1) {
                                                    phi_532_ = type_4((_e329.member + 1u), _e329.member_1);
                                                    phi_557_ = type_4(1u, _e329.member);
                                                } else {
                                                    phi_532_ = _e329;
                                                    phi_557_ = type_4(0u, type_4().member_1);
                                                }
                                                let _e344 = phi_532_;
                                                let _e346 = phi_557_;
                                                let _e349 = (bitcast<i32>(_e346.member) != 0i);
                                                if _e349 {
                                                    if (_e331 < 1023u) {
                                                        let _e351 = (_e331 + 1u);
                                                        let _e361 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e351) * bitcast<f32>((bitcast<u32>((_e266 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                                        phi_598_ = select(_e331, _e351, (select(select(_e263, _e361, (_e361 < _e263)), _e263, (_e351 == 1023u)) <= _e265));
                                                    } else {
                                                        phi_598_ = _e331;
                                                    }
                                                    let _e369 = phi_598_;
                                                    phi_535_ = _e369;
                                                } else {
                                                    phi_535_ = u32();
                                                }
                                                let _e371 = phi_535_;
                                                continue;
                                                continuing {
                                                    phi_531_ = _e344;
                                                    phi_534_ = _e371;
                                                    break if !(_e349);
                                                }
                                            }
                                            let _e376 = bitcast<f32>((bitcast<u32>((_e266 * 0.0009775171f)) ^ _e71));
                                            let _e378 = local_13;
                                            let _e384 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e378) * _e376)) ^ _e71)));
                                            let _e388 = local_14;
                                            let _e393 = local_15;
                                            let _e396 = ((10u * _e254.member_1) & 31u);
                                            if _e259 {
                                            } else {
                                                phi_2544_ = true;
                                                break;
                                            }
                                            let _e402 = local_4[_e254.member_1];
                                            if _e267 {
                                                phi_650_ = (((_e402 - _e261) / _e266) * 1023f);
                                            } else {
                                                phi_650_ = 0f;
                                            }
                                            let _e407 = phi_650_;
                                            let _e409 = select(1023f, _e407, (_e407 < 1023f));
                                            let _e411 = select(0f, _e409, (_e409 > 0f));
                                            phi_671_ = type_4(0u, 3u);
                                            phi_674_ = select(select(u32(_e411), 0u, (_e411 < 0f)), 4294967295u, (_e411 > 4294967000f));
                                            loop {
                                                let _e418 = phi_671_;
                                                let _e420 = phi_674_;
                                                local_36 = _e420;
                                                if (_e418.member < _e418.member_1) {
                                                    phi_672_ = type_4((_e418.member + 1u), _e418.member_1);
                                                    phi_697_ = type_4(1u, _e418.member);
                                                } else {
                                                    phi_672_ = _e418;
                                                    phi_697_ = type_4(0u, type_4().member_1);
                                                }
                                                let _e433 = phi_672_;
                                                let _e435 = phi_697_;
                                                let _e438 = (bitcast<i32>(_e435.member) != 0i);
                                                if _e438 {
                                                    if (_e420 > 0u) {
                                                        let _e445 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e420) * _e376)) ^ _e71)));
                                                        if (select(select(_e263, _e445, (_e445 < _e263)), _e263, (_e420 == 1023u)) > _e402) {
                                                            phi_736_ = (_e420 - 1u);
                                                        } else {
                                                            phi_736_ = _e420;
                                                        }
                                                        let _e453 = phi_736_;
                                                        phi_737_ = _e453;
                                                    } else {
                                                        phi_737_ = _e420;
                                                    }
                                                    let _e455 = phi_737_;
                                                    phi_675_ = _e455;
                                                } else {
                                                    phi_675_ = u32();
                                                }
                                                let _e457 = phi_675_;
                                                continue;
                                                continuing {
                                                    phi_671_ = _e433;
                                                    phi_674_ = _e457;
                                                    break if !(_e438);
                                                }
                                            }
                                            phi_740_ = type_4(0u, 3u);
                                            let _e1480 = local_36;
                                            phi_743_ = _e1480;
                                            loop {
                                                let _e460 = phi_740_;
                                                let _e462 = phi_743_;
                                                local_16 = _e462;
                                                local_17 = _e462;
                                                local_18 = _e462;
                                                if (_e460.member < _e460.member_1) {
                                                    phi_741_ = type_4((_e460.member + 1u), _e460.member_1);
                                                    phi_766_ = type_4(1u, _e460.member);
                                                } else {
                                                    phi_741_ = _e460;
                                                    phi_766_ = type_4(0u, type_4().member_1);
                                                }
                                                let _e475 = phi_741_;
                                                let _e477 = phi_766_;
                                                let _e480 = (bitcast<i32>(_e477.member) != 0i);
                                                if _e480 {
                                                    if (_e462 < 1023u) {
                                                        let _e482 = (_e462 + 1u);
                                                        let _e488 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e482) * _e376)) ^ _e71)));
                                                        phi_807_ = select(_e462, _e482, (select(select(_e263, _e488, (_e488 < _e263)), _e263, (_e482 == 1023u)) <= _e402));
                                                    } else {
                                                        phi_807_ = _e462;
                                                    }
                                                    let _e496 = phi_807_;
                                                    phi_744_ = _e496;
                                                } else {
                                                    phi_744_ = u32();
                                                }
                                                let _e498 = phi_744_;
                                                continue;
                                                continuing {
                                                    phi_740_ = _e475;
                                                    phi_743_ = _e498;
                                                    break if !(_e480);
                                                }
                                            }
                                            let _e501 = local_16;
                                            let _e507 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e501) * _e376)) ^ _e71)));
                                            let _e511 = local_17;
                                            let _e516 = local_18;
                                            let _e517 = select(_e516, 0u, (select(select(_e263, _e507, (_e507 < _e263)), _e263, (_e511 == 1023u)) > _e402));
                                            if (_e517 < 1023u) {
                                                let _e524 = (_e261 + bitcast<f32>((bitcast<u32>((f32(_e517) * _e376)) ^ _e71)));
                                                let _e529 = (select(select(_e263, _e524, (_e524 < _e263)), _e263, (_e517 == 1023u)) < _e402);
                                                if _e529 {
                                                    phi_868_ = (_e517 + 1u);
                                                } else {
                                                    phi_868_ = u32();
                                                }
                                                let _e532 = phi_868_;
                                                phi_870_ = _e532;
                                                phi_871_ = select(true, false, _e529);
                                            } else {
                                                phi_870_ = u32();
                                                phi_871_ = true;
                                            }
                                            let _e535 = phi_870_;
                                            let _e537 = phi_871_;
                                            phi_380_ = array<u32, 2>((_e239[0] | (select(_e393, 0u, (select(select(_e263, _e384, (_e384 < _e263)), _e263, (_e388 == 1023u)) > _e265)) << bitcast<u32>(_e396))), (_e239[1] | (select(_e535, _e517, _e537) << bitcast<u32>(_e396))));
                                        } else {
                                            phi_380_ = array<u32, 2>();
                                        }
                                        let _e545 = phi_380_;
                                        continue;
                                        continuing {
                                            phi_376_ = _e252;
                                            phi_379_ = _e545;
                                            phi_2544_ = _e147;
                                            break if !(_e258);
                                        }
                                    }
                                    let _e548 = phi_2544_;
                                    phi_2617_ = _e548;
                                    if _e548 {
                                        break;
                                    }
                                    local_12 = array<u32, 3>(0u, 1u, 2u);
                                    local_7 = array<f32, 3>(0f, 0f, 0f);
                                    local_6 = array<f32, 3>(0f, 0f, 0f);
                                    phi_889_ = type_4(0u, 3u);
                                    loop {
                                        let _e550 = phi_889_;
                                        if (_e550.member < _e550.member_1) {
                                            phi_890_ = type_4((_e550.member + 1u), _e550.member_1);
                                            phi_913_ = type_4(1u, _e550.member);
                                        } else {
                                            phi_890_ = _e550;
                                            phi_913_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e563 = phi_890_;
                                        let _e565 = phi_913_;
                                        let _e569 = (bitcast<i32>(_e565.member) != 0i);
                                        if _e569 {
                                            let _e570 = (_e565.member_1 < 3u);
                                            if _e570 {
                                            } else {
                                                phi_2609_ = true;
                                                break;
                                            }
                                            let _e572 = local_12[_e565.member_1];
                                            if _e570 {
                                            } else {
                                                phi_2609_ = true;
                                                break;
                                            }
                                            let _e574 = local_3[_e565.member_1];
                                            if _e570 {
                                            } else {
                                                phi_2609_ = true;
                                                break;
                                            }
                                            let _e576 = local_2[_e565.member_1];
                                            let _e578 = local_19;
                                            let _e581 = ((10u * _e572) & 31u);
                                            let _e584 = ((_e578[0] >> bitcast<u32>(_e581)) & 1023u);
                                            let _e589 = bitcast<f32>((bitcast<u32>(((_e576 - _e574) * 0.0009775171f)) ^ _e71));
                                            let _e595 = (_e574 + bitcast<f32>((bitcast<u32>((f32(_e584) * _e589)) ^ _e71)));
                                            if _e570 {
                                            } else {
                                                phi_2609_ = true;
                                                break;
                                            }
                                            local_7[_e565.member_1] = select(select(_e576, _e595, (_e595 < _e576)), _e576, (_e584 == 1023u));
                                            let _e602 = local_20;
                                            let _e606 = ((_e602[1] >> bitcast<u32>(_e581)) & 1023u);
                                            let _e612 = (_e574 + bitcast<f32>((bitcast<u32>((f32(_e606) * _e589)) ^ _e71)));
                                            if _e570 {
                                            } else {
                                                phi_2609_ = true;
                                                break;
                                            }
                                            local_6[_e565.member_1] = select(select(_e576, _e612, (_e612 < _e576)), _e576, (_e606 == 1023u));
                                        }
                                        continue;
                                        continuing {
                                            phi_889_ = _e563;
                                            phi_2609_ = _e548;
                                            break if !(_e569);
                                        }
                                    }
                                    let _e620 = phi_2609_;
                                    phi_2617_ = _e620;
                                    if _e620 {
                                        break;
                                    }
                                    let _e621 = local_6;
                                    let _e622 = local_7;
                                    local_3 = _e622;
                                    local_2 = _e621;
                                    phi_2619_ = _e620;
                                    phi_1041_ = select(_e176.member_2, _e176.member_1, _e182);
                                }
                                let _e625 = phi_2619_;
                                let _e627 = phi_1041_;
                                phi_2618_ = _e625;
                                phi_261_ = _e627;
                                phi_1043_ = select(true, false, _e170);
                            } else {
                                phi_2618_ = _e147;
                                phi_261_ = u32();
                                phi_1043_ = false;
                            }
                            let _e630 = phi_2618_;
                            let _e632 = phi_261_;
                            let _e634 = phi_1043_;
                            continue;
                            continuing {
                                phi_2554_ = _e630;
                                phi_257_ = _e164;
                                phi_260_ = _e632;
                                phi_2617_ = _e630;
                                break if !(_e634);
                            }
                        }
                        let _e637 = phi_2617_;
                        if _e637 {
                            break;
                        }
                        let _e638 = local_2;
                        let _e639 = local_3;
                        local_1 = _e639;
                        local = _e638;
                        if _e67 {
                        } else {
                            break;
                        }
                        let _e643 = global_3.member[_e62].member_1;
                        if (_e643 == 2147483648u) {
                            phi_1094_ = type_27(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            let _e649 = global_3.member[_e62].member[0u];
                            let _e654 = global_3.member[_e62].member[1u];
                            let _e659 = global_3.member[_e62].member[2u];
                            phi_1094_ = type_27(vec3<f32>(_e649[0], _e654[0], _e659[0]), vec3<f32>(_e649[2], _e654[2], _e659[2]));
                        }
                        let _e670 = phi_1094_;
                        let _e674 = global_3.member[_e62].member_2;
                        if (_e674 == 2147483648u) {
                            phi_1116_ = _e670;
                        } else {
                            let _e680 = global_3.member[_e62].member[0u];
                            let _e685 = global_3.member[_e62].member[1u];
                            let _e690 = global_3.member[_e62].member[2u];
                            phi_1116_ = type_27(vec3<f32>(_e680[1], _e685[1], _e690[1]), vec3<f32>(_e680[3], _e685[3], _e690[3]));
                        }
                        let _e701 = phi_1116_;
                        local_11 = array<f32, 3>(_e670.member.x, _e670.member.y, _e670.member.z);
                        local_10 = array<f32, 3>(_e670.member_1.x, _e670.member_1.y, _e670.member_1.z);
                        local_9 = array<f32, 3>(_e701.member.x, _e701.member.y, _e701.member.z);
                        local_8 = array<f32, 3>(_e701.member_1.x, _e701.member_1.y, _e701.member_1.z);
                        phi_1160_ = type_4(0u, 3u);
                        phi_1163_ = array<u32, 2>(0u, 0u);
                        loop {
                            let _e731 = phi_1160_;
                            let _e733 = phi_1163_;
                            local_33 = _e733;
                            if (_e731.member < _e731.member_1) {
                                phi_1161_ = type_4((_e731.member + 1u), _e731.member_1);
                                phi_1186_ = type_4(1u, _e731.member);
                            } else {
                                phi_1161_ = _e731;
                                phi_1186_ = type_4(0u, type_4().member_1);
                            }
                            let _e746 = phi_1161_;
                            let _e748 = phi_1186_;
                            let _e752 = (bitcast<i32>(_e748.member) != 0i);
                            if _e752 {
                                let _e753 = (_e748.member_1 < 3u);
                                if _e753 {
                                } else {
                                    phi_2621_ = true;
                                    break;
                                }
                                let _e755 = local_1[_e748.member_1];
                                if _e753 {
                                } else {
                                    phi_2621_ = true;
                                    break;
                                }
                                let _e757 = local[_e748.member_1];
                                if _e753 {
                                } else {
                                    phi_2621_ = true;
                                    break;
                                }
                                let _e759 = local_11[_e748.member_1];
                                let _e760 = (_e757 - _e755);
                                let _e761 = (_e760 > 0f);
                                if _e761 {
                                    phi_1225_ = (((_e759 - _e755) / _e760) * 1023f);
                                } else {
                                    phi_1225_ = 0f;
                                }
                                let _e766 = phi_1225_;
                                let _e768 = select(1023f, _e766, (_e766 < 1023f));
                                let _e770 = select(0f, _e768, (_e768 > 0f));
                                phi_1246_ = type_4(0u, 3u);
                                phi_1249_ = select(select(u32(_e770), 0u, (_e770 < 0f)), 4294967295u, (_e770 > 4294967000f));
                                loop {
                                    let _e777 = phi_1246_;
                                    let _e779 = phi_1249_;
                                    local_37 = _e779;
                                    if (_e777.member < _e777.member_1) {
                                        phi_1247_ = type_4((_e777.member + 1u), _e777.member_1);
                                        phi_1272_ = type_4(1u, _e777.member);
                                    } else {
                                        phi_1247_ = _e777;
                                        phi_1272_ = type_4(0u, type_4().member_1);
                                    }
                                    let _e792 = phi_1247_;
                                    let _e794 = phi_1272_;
                                    let _e797 = (bitcast<i32>(_e794.member) != 0i);
                                    if _e797 {
                                        if (_e779 > 0u) {
                                            let _e808 = (_e755 + bitcast<f32>((bitcast<u32>((f32(_e779) * bitcast<f32>((bitcast<u32>((_e760 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                            if (select(select(_e757, _e808, (_e808 < _e757)), _e757, (_e779 == 1023u)) > _e759) {
                                                phi_1311_ = (_e779 - 1u);
                                            } else {
                                                phi_1311_ = _e779;
                                            }
                                            let _e816 = phi_1311_;
                                            phi_1312_ = _e816;
                                        } else {
                                            phi_1312_ = _e779;
                                        }
                                        let _e818 = phi_1312_;
                                        phi_1250_ = _e818;
                                    } else {
                                        phi_1250_ = u32();
                                    }
                                    let _e820 = phi_1250_;
                                    continue;
                                    continuing {
                                        phi_1246_ = _e792;
                                        phi_1249_ = _e820;
                                        break if !(_e797);
                                    }
                                }
                                phi_1315_ = type_4(0u, 3u);
                                let _e1522 = local_37;
                                phi_1318_ = _e1522;
                                loop {
                                    let _e823 = phi_1315_;
                                    let _e825 = phi_1318_;
                                    local_21 = _e825;
                                    local_22 = _e825;
                                    local_23 = _e825;
                                    if (_e823.member < _e823.member_1) {
                                        phi_1316_ = type_4((_e823.member + 1u), _e823.member_1);
                                        phi_1341_ = type_4(1u, _e823.member);
                                    } else {
                                        phi_1316_ = _e823;
                                        phi_1341_ = type_4(0u, type_4().member_1);
                                    }
                                    let _e838 = phi_1316_;
                                    let _e840 = phi_1341_;
                                    let _e843 = (bitcast<i32>(_e840.member) != 0i);
                                    if _e843 {
                                        if (_e825 < 1023u) {
                                            let _e845 = (_e825 + 1u);
                                            let _e855 = (_e755 + bitcast<f32>((bitcast<u32>((f32(_e845) * bitcast<f32>((bitcast<u32>((_e760 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                            phi_1382_ = select(_e825, _e845, (select(select(_e757, _e855, (_e855 < _e757)), _e757, (_e845 == 1023u)) <= _e759));
                                        } else {
                                            phi_1382_ = _e825;
                                        }
                                        let _e863 = phi_1382_;
                                        phi_1319_ = _e863;
                                    } else {
                                        phi_1319_ = u32();
                                    }
                                    let _e865 = phi_1319_;
                                    continue;
                                    continuing {
                                        phi_1315_ = _e838;
                                        phi_1318_ = _e865;
                                        break if !(_e843);
                                    }
                                }
                                let _e870 = bitcast<f32>((bitcast<u32>((_e760 * 0.0009775171f)) ^ _e71));
                                let _e872 = local_21;
                                let _e878 = (_e755 + bitcast<f32>((bitcast<u32>((f32(_e872) * _e870)) ^ _e71)));
                                let _e882 = local_22;
                                let _e887 = local_23;
                                let _e890 = ((10u * _e748.member_1) & 31u);
                                if _e753 {
                                } else {
                                    phi_2621_ = true;
                                    break;
                                }
                                let _e896 = local_10[_e748.member_1];
                                if _e761 {
                                    phi_1434_ = (((_e896 - _e755) / _e760) * 1023f);
                                } else {
                                    phi_1434_ = 0f;
                                }
                                let _e901 = phi_1434_;
                                let _e903 = select(1023f, _e901, (_e901 < 1023f));
                                let _e905 = select(0f, _e903, (_e903 > 0f));
                                phi_1455_ = type_4(0u, 3u);
                                phi_1458_ = select(select(u32(_e905), 0u, (_e905 < 0f)), 4294967295u, (_e905 > 4294967000f));
                                loop {
                                    let _e912 = phi_1455_;
                                    let _e914 = phi_1458_;
                                    local_38 = _e914;
                                    if (_e912.member < _e912.member_1) {
                                        phi_1456_ = type_4((_e912.member + 1u), _e912.member_1);
                                        phi_1481_ = type_4(1u, _e912.member);
                                    } else {
                                        phi_1456_ = _e912;
                                        phi_1481_ = type_4(0u, type_4().member_1);
                                    }
                                    let _e927 = phi_1456_;
                                    let _e929 = phi_1481_;
                                    let _e932 = (bitcast<i32>(_e929.member) != 0i);
                                    if _e932 {
                                        if (_e914 > 0u) {
                                            let _e939 = (_e755 + bitcast<f32>((bitcast<u32>((f32(_e914) * _e870)) ^ _e71)));
                                            if (select(select(_e757, _e939, (_e939 < _e757)), _e757, (_e914 == 1023u)) > _e896) {
                                                phi_1520_ = (_e914 - 1u);
                                            } else {
                                                phi_1520_ = _e914;
                                            }
                                            let _e947 = phi_1520_;
                                            phi_1521_ = _e947;
                                        } else {
                                            phi_1521_ = _e914;
                                        }
                                        let _e949 = phi_1521_;
                                        phi_1459_ = _e949;
                                    } else {
                                        phi_1459_ = u32();
                                    }
                                    let _e951 = phi_1459_;
                                    continue;
                                    continuing {
                                        phi_1455_ = _e927;
                                        phi_1458_ = _e951;
                                        break if !(_e932);
                                    }
                                }
                                phi_1524_ = type_4(0u, 3u);
                                let _e1541 = local_38;
                                phi_1527_ = _e1541;
                                loop {
                                    let _e954 = phi_1524_;
                                    let _e956 = phi_1527_;
                                    local_24 = _e956;
                                    local_25 = _e956;
                                    local_26 = _e956;
                                    if (_e954.member < _e954.member_1) {
                                        phi_1525_ = type_4((_e954.member + 1u), _e954.member_1);
                                        phi_1550_ = type_4(1u, _e954.member);
                                    } else {
                                        phi_1525_ = _e954;
                                        phi_1550_ = type_4(0u, type_4().member_1);
                                    }
                                    let _e969 = phi_1525_;
                                    let _e971 = phi_1550_;
                                    let _e974 = (bitcast<i32>(_e971.member) != 0i);
                                    if _e974 {
                                        if (_e956 < 1023u) {
                                            let _e976 = (_e956 + 1u);
                                            let _e982 = (_e755 + bitcast<f32>((bitcast<u32>((f32(_e976) * _e870)) ^ _e71)));
                                            phi_1591_ = select(_e956, _e976, (select(select(_e757, _e982, (_e982 < _e757)), _e757, (_e976 == 1023u)) <= _e896));
                                        } else {
                                            phi_1591_ = _e956;
                                        }
                                        let _e990 = phi_1591_;
                                        phi_1528_ = _e990;
                                    } else {
                                        phi_1528_ = u32();
                                    }
                                    let _e992 = phi_1528_;
                                    continue;
                                    continuing {
                                        phi_1524_ = _e969;
                                        phi_1527_ = _e992;
                                        break if !(_e974);
                                    }
                                }
                                let _e995 = local_24;
                                let _e1001 = (_e755 + bitcast<f32>((bitcast<u32>((f32(_e995) * _e870)) ^ _e71)));
                                let _e1005 = local_25;
                                let _e1010 = local_26;
                                let _e1011 = select(_e1010, 0u, (select(select(_e757, _e1001, (_e1001 < _e757)), _e757, (_e1005 == 1023u)) > _e896));
                                if (_e1011 < 1023u) {
                                    let _e1018 = (_e755 + bitcast<f32>((bitcast<u32>((f32(_e1011) * _e870)) ^ _e71)));
                                    let _e1023 = (select(select(_e757, _e1018, (_e1018 < _e757)), _e757, (_e1011 == 1023u)) < _e896);
                                    if _e1023 {
                                        phi_1652_ = (_e1011 + 1u);
                                    } else {
                                        phi_1652_ = u32();
                                    }
                                    let _e1026 = phi_1652_;
                                    phi_1654_ = _e1026;
                                    phi_1655_ = select(true, false, _e1023);
                                } else {
                                    phi_1654_ = u32();
                                    phi_1655_ = true;
                                }
                                let _e1029 = phi_1654_;
                                let _e1031 = phi_1655_;
                                phi_1164_ = array<u32, 2>((_e733[0] | (select(_e887, 0u, (select(select(_e757, _e878, (_e878 < _e757)), _e757, (_e882 == 1023u)) > _e759)) << bitcast<u32>(_e890))), (_e733[1] | (select(_e1029, _e1011, _e1031) << bitcast<u32>(_e890))));
                            } else {
                                phi_1164_ = array<u32, 2>();
                            }
                            let _e1039 = phi_1164_;
                            continue;
                            continuing {
                                phi_1160_ = _e746;
                                phi_1163_ = _e1039;
                                phi_2621_ = _e637;
                                break if !(_e752);
                            }
                        }
                        let _e1042 = phi_2621_;
                        if _e1042 {
                            break;
                        }
                        phi_1668_ = type_4(0u, 3u);
                        phi_1671_ = array<u32, 2>(0u, 0u);
                        loop {
                            let _e1044 = phi_1668_;
                            let _e1046 = phi_1671_;
                            local_34 = _e1046;
                            if (_e1044.member < _e1044.member_1) {
                                phi_1669_ = type_4((_e1044.member + 1u), _e1044.member_1);
                                phi_1694_ = type_4(1u, _e1044.member);
                            } else {
                                phi_1669_ = _e1044;
                                phi_1694_ = type_4(0u, type_4().member_1);
                            }
                            let _e1059 = phi_1669_;
                            let _e1061 = phi_1694_;
                            let _e1065 = (bitcast<i32>(_e1061.member) != 0i);
                            if _e1065 {
                                let _e1066 = (_e1061.member_1 < 3u);
                                if _e1066 {
                                } else {
                                    phi_2672_ = true;
                                    break;
                                }
                                let _e1068 = local_1[_e1061.member_1];
                                if _e1066 {
                                } else {
                                    phi_2672_ = true;
                                    break;
                                }
                                let _e1070 = local[_e1061.member_1];
                                if _e1066 {
                                } else {
                                    phi_2672_ = true;
                                    break;
                                }
                                let _e1072 = local_9[_e1061.member_1];
                                let _e1073 = (_e1070 - _e1068);
                                let _e1074 = (_e1073 > 0f);
                                if _e1074 {
                                    phi_1733_ = (((_e1072 - _e1068) / _e1073) * 1023f);
                                } else {
                                    phi_1733_ = 0f;
                                }
                                let _e1079 = phi_1733_;
                                let _e1081 = select(1023f, _e1079, (_e1079 < 1023f));
                                let _e1083 = select(0f, _e1081, (_e1081 > 0f));
                                phi_1754_ = type_4(0u, 3u);
                                phi_1757_ = select(select(u32(_e1083), 0u, (_e1083 < 0f)), 4294967295u, (_e1083 > 4294967000f));
                                loop {
                                    let _e1090 = phi_1754_;
                                    let _e1092 = phi_1757_;
                                    local_39 = _e1092;
                                    if (_e1090.member < _e1090.member_1) {
                                        phi_1755_ = type_4((_e1090.member + 1u), _e1090.member_1);
                                        phi_1780_ = type_4(1u, _e1090.member);
                                    } else {
                                        phi_1755_ = _e1090;
                                        phi_1780_ = type_4(0u, type_4().member_1);
                                    }
                                    let _e1105 = phi_1755_;
                                    let _e1107 = phi_1780_;
                                    let _e1110 = (bitcast<i32>(_e1107.member) != 0i);
                                    if _e1110 {
                                        if (_e1092 > 0u) {
                                            let _e1121 = (_e1068 + bitcast<f32>((bitcast<u32>((f32(_e1092) * bitcast<f32>((bitcast<u32>((_e1073 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                            if (select(select(_e1070, _e1121, (_e1121 < _e1070)), _e1070, (_e1092 == 1023u)) > _e1072) {
                                                phi_1819_ = (_e1092 - 1u);
                                            } else {
                                                phi_1819_ = _e1092;
                                            }
                                            let _e1129 = phi_1819_;
                                            phi_1820_ = _e1129;
                                        } else {
                                            phi_1820_ = _e1092;
                                        }
                                        let _e1131 = phi_1820_;
                                        phi_1758_ = _e1131;
                                    } else {
                                        phi_1758_ = u32();
                                    }
                                    let _e1133 = phi_1758_;
                                    continue;
                                    continuing {
                                        phi_1754_ = _e1105;
                                        phi_1757_ = _e1133;
                                        break if !(_e1110);
                                    }
                                }
                                phi_1823_ = type_4(0u, 3u);
                                let _e1569 = local_39;
                                phi_1826_ = _e1569;
                                loop {
                                    let _e1136 = phi_1823_;
                                    let _e1138 = phi_1826_;
                                    local_27 = _e1138;
                                    local_28 = _e1138;
                                    local_29 = _e1138;
                                    if (_e1136.member < _e1136.member_1) {
                                        phi_1824_ = type_4((_e1136.member + 1u), _e1136.member_1);
                                        phi_1849_ = type_4(1u, _e1136.member);
                                    } else {
                                        phi_1824_ = _e1136;
                                        phi_1849_ = type_4(0u, type_4().member_1);
                                    }
                                    let _e1151 = phi_1824_;
                                    let _e1153 = phi_1849_;
                                    let _e1156 = (bitcast<i32>(_e1153.member) != 0i);
                                    if _e1156 {
                                        if (_e1138 < 1023u) {
                                            let _e1158 = (_e1138 + 1u);
                                            let _e1168 = (_e1068 + bitcast<f32>((bitcast<u32>((f32(_e1158) * bitcast<f32>((bitcast<u32>((_e1073 * 0.0009775171f)) ^ _e71)))) ^ _e71)));
                                            phi_1890_ = select(_e1138, _e1158, (select(select(_e1070, _e1168, (_e1168 < _e1070)), _e1070, (_e1158 == 1023u)) <= _e1072));
                                        } else {
                                            phi_1890_ = _e1138;
                                        }
                                        let _e1176 = phi_1890_;
                                        phi_1827_ = _e1176;
                                    } else {
                                        phi_1827_ = u32();
                                    }
                                    let _e1178 = phi_1827_;
                                    continue;
                                    continuing {
                                        phi_1823_ = _e1151;
                                        phi_1826_ = _e1178;
                                        break if !(_e1156);
                                    }
                                }
                                let _e1183 = bitcast<f32>((bitcast<u32>((_e1073 * 0.0009775171f)) ^ _e71));
                                let _e1185 = local_27;
                                let _e1191 = (_e1068 + bitcast<f32>((bitcast<u32>((f32(_e1185) * _e1183)) ^ _e71)));
                                let _e1195 = local_28;
                                let _e1200 = local_29;
                                let _e1203 = ((10u * _e1061.member_1) & 31u);
                                if _e1066 {
                                } else {
                                    phi_2672_ = true;
                                    break;
                                }
                                let _e1209 = local_8[_e1061.member_1];
                                if _e1074 {
                                    phi_1942_ = (((_e1209 - _e1068) / _e1073) * 1023f);
                                } else {
                                    phi_1942_ = 0f;
                                }
                                let _e1214 = phi_1942_;
                                let _e1216 = select(1023f, _e1214, (_e1214 < 1023f));
                                let _e1218 = select(0f, _e1216, (_e1216 > 0f));
                                phi_1963_ = type_4(0u, 3u);
                                phi_1966_ = select(select(u32(_e1218), 0u, (_e1218 < 0f)), 4294967295u, (_e1218 > 4294967000f));
                                loop {
                                    let _e1225 = phi_1963_;
                                    let _e1227 = phi_1966_;
                                    local_40 = _e1227;
                                    if (_e1225.member < _e1225.member_1) {
                                        phi_1964_ = type_4((_e1225.member + 1u), _e1225.member_1);
                                        phi_1989_ = type_4(1u, _e1225.member);
                                    } else {
                                        phi_1964_ = _e1225;
                                        phi_1989_ = type_4(0u, type_4().member_1);
                                    }
                                    let _e1240 = phi_1964_;
                                    let _e1242 = phi_1989_;
                                    let _e1245 = (bitcast<i32>(_e1242.member) != 0i);
                                    if _e1245 {
                                        if (_e1227 > 0u) {
                                            let _e1252 = (_e1068 + bitcast<f32>((bitcast<u32>((f32(_e1227) * _e1183)) ^ _e71)));
                                            if (select(select(_e1070, _e1252, (_e1252 < _e1070)), _e1070, (_e1227 == 1023u)) > _e1209) {
                                                phi_2028_ = (_e1227 - 1u);
                                            } else {
                                                phi_2028_ = _e1227;
                                            }
                                            let _e1260 = phi_2028_;
                                            phi_2029_ = _e1260;
                                        } else {
                                            phi_2029_ = _e1227;
                                        }
                                        let _e1262 = phi_2029_;
                                        phi_1967_ = _e1262;
                                    } else {
                                        phi_1967_ = u32();
                                    }
                                    let _e1264 = phi_1967_;
                                    continue;
                                    continuing {
                                        phi_1963_ = _e1240;
                                        phi_1966_ = _e1264;
                                        break if !(_e1245);
                                    }
                                }
                                phi_2032_ = type_4(0u, 3u);
                                let _e1588 = local_40;
                                phi_2035_ = _e1588;
                                loop {
                                    let _e1267 = phi_2032_;
                                    let _e1269 = phi_2035_;
                                    local_30 = _e1269;
                                    local_31 = _e1269;
                                    local_32 = _e1269;
                                    if (_e1267.member < _e1267.member_1) {
                                        phi_2033_ = type_4((_e1267.member + 1u), _e1267.member_1);
                                        phi_2058_ = type_4(1u, _e1267.member);
                                    } else {
                                        phi_2033_ = _e1267;
                                        phi_2058_ = type_4(0u, type_4().member_1);
                                    }
                                    let _e1282 = phi_2033_;
                                    let _e1284 = phi_2058_;
                                    let _e1287 = (bitcast<i32>(_e1284.member) != 0i);
                                    if _e1287 {
                                        if (_e1269 < 1023u) {
                                            let _e1289 = (_e1269 + 1u);
                                            let _e1295 = (_e1068 + bitcast<f32>((bitcast<u32>((f32(_e1289) * _e1183)) ^ _e71)));
                                            phi_2099_ = select(_e1269, _e1289, (select(select(_e1070, _e1295, (_e1295 < _e1070)), _e1070, (_e1289 == 1023u)) <= _e1209));
                                        } else {
                                            phi_2099_ = _e1269;
                                        }
                                        let _e1303 = phi_2099_;
                                        phi_2036_ = _e1303;
                                    } else {
                                        phi_2036_ = u32();
                                    }
                                    let _e1305 = phi_2036_;
                                    continue;
                                    continuing {
                                        phi_2032_ = _e1282;
                                        phi_2035_ = _e1305;
                                        break if !(_e1287);
                                    }
                                }
                                let _e1308 = local_30;
                                let _e1314 = (_e1068 + bitcast<f32>((bitcast<u32>((f32(_e1308) * _e1183)) ^ _e71)));
                                let _e1318 = local_31;
                                let _e1323 = local_32;
                                let _e1324 = select(_e1323, 0u, (select(select(_e1070, _e1314, (_e1314 < _e1070)), _e1070, (_e1318 == 1023u)) > _e1209));
                                if (_e1324 < 1023u) {
                                    let _e1331 = (_e1068 + bitcast<f32>((bitcast<u32>((f32(_e1324) * _e1183)) ^ _e71)));
                                    let _e1336 = (select(select(_e1070, _e1331, (_e1331 < _e1070)), _e1070, (_e1324 == 1023u)) < _e1209);
                                    if _e1336 {
                                        phi_2160_ = (_e1324 + 1u);
                                    } else {
                                        phi_2160_ = u32();
                                    }
                                    let _e1339 = phi_2160_;
                                    phi_2162_ = _e1339;
                                    phi_2163_ = select(true, false, _e1336);
                                } else {
                                    phi_2162_ = u32();
                                    phi_2163_ = true;
                                }
                                let _e1342 = phi_2162_;
                                let _e1344 = phi_2163_;
                                phi_1672_ = array<u32, 2>((_e1046[0] | (select(_e1200, 0u, (select(select(_e1070, _e1191, (_e1191 < _e1070)), _e1070, (_e1195 == 1023u)) > _e1072)) << bitcast<u32>(_e1203))), (_e1046[1] | (select(_e1342, _e1324, _e1344) << bitcast<u32>(_e1203))));
                            } else {
                                phi_1672_ = array<u32, 2>();
                            }
                            let _e1352 = phi_1672_;
                            continue;
                            continuing {
                                phi_1668_ = _e1059;
                                phi_1671_ = _e1352;
                                phi_2672_ = _e1042;
                                break if !(_e1065);
                            }
                        }
                        let _e1355 = phi_2672_;
                        if _e1355 {
                            break;
                        }
                        let _e1357 = local_33;
                        let _e1359 = local_34;
                        phi_2186_ = type_4(0u, 3u);
                        loop {
                            let _e1362 = phi_2186_;
                            if (_e1362.member < _e1362.member_1) {
                                phi_2187_ = type_4((_e1362.member + 1u), _e1362.member_1);
                                phi_2210_ = type_4(1u, _e1362.member);
                            } else {
                                phi_2187_ = _e1362;
                                phi_2210_ = type_4(0u, type_4().member_1);
                            }
                            let _e1375 = phi_2187_;
                            let _e1377 = phi_2210_;
                            let _e1381 = (bitcast<i32>(_e1377.member) != 0i);
                            if _e1381 {
                                let _e1382 = (_e1377.member_1 < 3u);
                                if _e1382 {
                                } else {
                                    phi_2721_ = true;
                                    break;
                                }
                                if _e1382 {
                                } else {
                                    phi_2721_ = true;
                                    break;
                                }
                                if _e1382 {
                                } else {
                                    phi_2721_ = true;
                                    break;
                                }
                                if _e1382 {
                                } else {
                                    phi_2721_ = true;
                                    break;
                                }
                                if _e1382 {
                                } else {
                                    phi_2721_ = true;
                                    break;
                                }
                            }
                            continue;
                            continuing {
                                phi_2186_ = _e1375;
                                phi_2721_ = _e1355;
                                break if !(_e1381);
                            }
                        }
                        let _e1385 = phi_2721_;
                        if _e1385 {
                            break;
                        }
                        phi_2316_ = type_4(0u, 3u);
                        loop {
                            let _e1387 = phi_2316_;
                            if (_e1387.member < _e1387.member_1) {
                                phi_2317_ = type_4((_e1387.member + 1u), _e1387.member_1);
                                phi_2340_ = type_4(1u, _e1387.member);
                            } else {
                                phi_2317_ = _e1387;
                                phi_2340_ = type_4(0u, type_4().member_1);
                            }
                            let _e1400 = phi_2317_;
                            let _e1402 = phi_2340_;
                            let _e1406 = (bitcast<i32>(_e1402.member) != 0i);
                            if _e1406 {
                                let _e1407 = (_e1402.member_1 < 3u);
                                if _e1407 {
                                } else {
                                    phi_2725_ = true;
                                    break;
                                }
                                if _e1407 {
                                } else {
                                    phi_2725_ = true;
                                    break;
                                }
                                if _e1407 {
                                } else {
                                    phi_2725_ = true;
                                    break;
                                }
                                if _e1407 {
                                } else {
                                    phi_2725_ = true;
                                    break;
                                }
                                if _e1407 {
                                } else {
                                    phi_2725_ = true;
                                    break;
                                }
                            }
                            continue;
                            continuing {
                                phi_2316_ = _e1400;
                                phi_2725_ = _e1385;
                                break if !(_e1406);
                            }
                        }
                        let _e1410 = phi_2725_;
                        if _e1410 {
                            break;
                        }
                        if _e68 {
                        } else {
                            break;
                        }
                        global_4.member[_e62] = type_33(_e1357, _e1359, _e643, _e674);
                        if (_e62 == 0u) {
                            if (_e58 == 0u) {
                            } else {
                                if (0u < _e58) {
                                } else {
                                    break;
                                }
                                global_5.member[0u] = type_28(array<u32, 4>(bitcast<u32>(_e639[0]), bitcast<u32>(_e639[1]), bitcast<u32>(_e639[2]), 0u), array<u32, 4>(bitcast<u32>(_e638[0]), bitcast<u32>(_e638[1]), bitcast<u32>(_e638[2]), 0u));
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
