struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: vec4<u32>,
}

struct type_16 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_26 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_30 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_42 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_43 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_45 {
    member: array<type_27>,
}

struct type_47 {
    member: f32,
    member_1: bool,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(1) 
var<storage> global_2: type_32;
@group(0) @binding(2) 
var<storage> global_3: type_18;
@group(0) @binding(3) 
var<storage> global_4: type_45;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_4;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_308_: i32;
    var phi_309_: i32;
    var phi_319_: bool;
    var phi_329_: u32;
    var phi_330_: u32;
    var phi_332_: bool;
    var phi_337_: u32;
    var phi_350_: i32;
    var phi_370_: i32;
    var phi_388_: f32;
    var phi_394_: f32;
    var phi_434_: f32;
    var phi_440_: f32;
    var phi_513_: f32;
    var phi_519_: f32;
    var phi_559_: f32;
    var phi_565_: f32;
    var phi_638_: f32;
    var phi_644_: f32;
    var phi_684_: f32;
    var phi_690_: f32;
    var phi_809_: i32;
    var phi_831_: u32;
    var phi_832_: u32;
    var phi_869_: i32;
    var phi_891_: u32;
    var phi_892_: u32;
    var phi_900_: f32;
    var phi_901_: f32;
    var phi_2571_: bool;
    var phi_916_: type_47;
    var phi_919_: bool;
    var phi_921_: u32;
    var phi_923_: u32;
    var phi_925_: u32;
    var phi_936_: bool;
    var phi_968_: bool;
    var phi_969_: u32;
    var phi_970_: u32;
    var phi_1968_: type_43;
    var phi_2330_: u32;
    var phi_2357_: u32;
    var phi_2358_: u32;
    var phi_2359_: u32;
    var phi_2361_: u32;
    var phi_2362_: u32;
    var phi_2363_: bool;
    var phi_2372_: u32;
    var phi_2377_: bool;
    var phi_2378_: u32;
    var phi_985_: type_47;
    var phi_988_: type_7;
    var phi_989_: type_7;
    var phi_1011_: type_7;
    var phi_1032_: u32;
    var phi_1124_: array<array<f32, 3>, 3>;
    var phi_1654_: f32;
    var phi_1655_: f32;
    var phi_1656_: f32;
    var phi_1657_: f32;
    var phi_1658_: vec3<f32>;
    var phi_1659_: vec3<f32>;
    var phi_1660_: vec3<f32>;
    var phi_1661_: vec3<f32>;
    var phi_1852_: f32;
    var phi_1872_: type_42;
    var phi_1873_: type_42;
    var phi_1876_: type_42;
    var phi_1877_: type_42;
    var phi_1878_: bool;
    var phi_1882_: type_42;
    var phi_1891_: type_26;
    var phi_1902_: type_47;
    var phi_1903_: type_47;
    var phi_986_: type_47;
    var phi_2565_: bool;
    var local_2: type_47;
    var phi_2719_: bool;
    var phi_2380_: type_47;
    var phi_2381_: bool;
    var phi_2382_: u32;
    var phi_2383_: u32;
    var phi_2718_: bool;
    var phi_2384_: type_47;
    var phi_2385_: bool;
    var phi_2386_: u32;
    var phi_2387_: u32;
    var phi_2388_: u32;
    var phi_2717_: bool;
    var phi_2389_: type_47;
    var phi_2390_: bool;
    var phi_2391_: u32;
    var phi_2392_: u32;
    var phi_2393_: u32;
    var phi_2716_: bool;
    var phi_917_: type_47;
    var phi_920_: bool;
    var phi_922_: u32;
    var phi_924_: u32;
    var phi_926_: u32;
    var phi_2394_: bool;
    var phi_2715_: bool;
    var local_3: type_47;
    var local_4: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e70 = global;
            let _e72 = arrayLength((&global_2.member));
            let _e74 = arrayLength((&global_3.member));
            let _e82 = (_e70.x + (_e70.y * 2097152u));
            let _e85 = global_1.member[0u];
            let _e86 = bitcast<i32>(_e85);
            let _e87 = (_e82 < arrayLength((&global_4.member)));
            if _e87 {
                let _e88 = (_e82 < arrayLength((&global_5.member)));
                if _e88 {
                    if _e87 {
                    } else {
                        break;
                    }
                    let _e96 = global_4.member[_e82].member_2[0u];
                    let _e98 = (bitcast<u32>(_e96) & 2147483647u);
                    let _e103 = global_4.member[_e82].member_2[1u];
                    let _e105 = (bitcast<u32>(_e103) & 2147483647u);
                    let _e110 = global_4.member[_e82].member_2[2u];
                    let _e112 = (bitcast<u32>(_e110) & 2147483647u);
                    let _e117 = global_4.member[_e82].member[0u];
                    let _e119 = (bitcast<u32>(_e117) & 2147483647u);
                    let _e124 = global_4.member[_e82].member[1u];
                    let _e126 = (bitcast<u32>(_e124) & 2147483647u);
                    let _e131 = global_4.member[_e82].member[2u];
                    let _e133 = (bitcast<u32>(_e131) & 2147483647u);
                    let _e135 = select(_e105, _e98, (_e105 < _e98));
                    let _e137 = select(_e112, _e135, (_e112 < _e135));
                    let _e139 = select(_e119, _e137, (_e119 < _e137));
                    let _e141 = select(_e126, _e139, (_e126 < _e139));
                    let _e143 = select(_e133, _e141, (_e133 < _e141));
                    let _e147 = global_4.member[_e82].member_1;
                    let _e148 = bitcast<u32>(_e147);
                    let _e149 = (_e148 & 2147483647u);
                    let _e156 = global_4.member[_e82].member_3;
                    let _e157 = bitcast<u32>(_e156);
                    let _e158 = (_e157 & 2147483647u);
                    let _e162 = (((select(_e149, _e143, (_e149 < _e143)) < 2139095040u) && (_e158 <= 2139095040u)) && (_e137 > 0u));
                    if _e162 {
                        let _e165 = (bitcast<u32>(bitcast<f32>(_e137)) & 2147483647u);
                        if (_e165 >= 8388608u) {
                            phi_308_ = (bitcast<i32>((_e165 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_308_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e165)), 32u, (_e165 == 0u))));
                        }
                        let _e179 = phi_308_;
                        phi_309_ = _e179;
                    } else {
                        phi_309_ = 0i;
                    }
                    let _e181 = phi_309_;
                    let _e182 = (_e98 == _e137);
                    if _e182 {
                        phi_319_ = true;
                    } else {
                        phi_319_ = (_e105 == _e137);
                    }
                    let _e185 = phi_319_;
                    let _e186 = select(1u, 0u, _e182);
                    if _e185 {
                        let _e187 = (_e186 + 1u);
                        phi_329_ = _e187;
                        phi_330_ = _e187;
                        phi_332_ = select(true, false, (_e187 == 2u));
                    } else {
                        phi_329_ = u32();
                        phi_330_ = 0u;
                        phi_332_ = true;
                    }
                    let _e191 = phi_329_;
                    let _e193 = phi_330_;
                    let _e195 = phi_332_;
                    if _e195 {
                        phi_337_ = (_e193 + 1u);
                    } else {
                        phi_337_ = 0u;
                    }
                    let _e199 = phi_337_;
                    let _e200 = select(_e191, _e193, _e195);
                    let _e201 = select(_e186, select(2u, _e186, _e185), _e195);
                    if (_e86 < -126i) {
                        phi_350_ = -126i;
                    } else {
                        phi_350_ = select(_e86, 127i, (_e86 > 127i));
                    }
                    let _e206 = phi_350_;
                    let _e211 = bitcast<f32>((bitcast<u32>((_e206 + 127i)) << bitcast<u32>(23i)));
                    let _e217 = bitcast<f32>((bitcast<u32>(((_e86 - _e206) + 127i)) << bitcast<u32>(23i)));
                    let _e218 = -(_e181);
                    if (_e218 < -126i) {
                        phi_370_ = -126i;
                    } else {
                        phi_370_ = select(_e218, 127i, (_e218 > 127i));
                    }
                    let _e223 = phi_370_;
                    let _e228 = bitcast<f32>((bitcast<u32>((_e223 + 127i)) << bitcast<u32>(23i)));
                    let _e234 = bitcast<f32>((bitcast<u32>(((_e218 - _e223) + 127i)) << bitcast<u32>(23i)));
                    let _e238 = global_4.member[_e82].member;
                    let _e239 = (_e200 == 0u);
                    if _e239 {
                        phi_388_ = _e238[0];
                    } else {
                        phi_388_ = _e238[1];
                    }
                    let _e243 = phi_388_;
                    let _e244 = (_e200 == 2u);
                    if _e244 {
                        phi_394_ = _e238[2];
                    } else {
                        phi_394_ = _e243;
                    }
                    let _e247 = phi_394_;
                    let _e248 = bitcast<u32>(_e247);
                    let _e250 = ((_e248 & 2139095040u) != 0u);
                    let _e264 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e248 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e248 & 2147483648u))), _e247, _e250) * _e211) * select(0.00000011920929f, 1f, _e250)) * _e217);
                    let _e265 = global_4.member[_e82].member_2;
                    if _e239 {
                        phi_434_ = _e265[0];
                    } else {
                        phi_434_ = _e265[1];
                    }
                    let _e269 = phi_434_;
                    if _e244 {
                        phi_440_ = _e265[2];
                    } else {
                        phi_440_ = _e269;
                    }
                    let _e272 = phi_440_;
                    let _e273 = bitcast<u32>(_e272);
                    let _e275 = ((_e273 & 2139095040u) != 0u);
                    let _e289 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e273 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e273 & 2147483648u))), _e272, _e275) * _e228) * select(0.00000011920929f, 1f, _e275)) * _e234);
                    let _e293 = (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e296 = bitcast<f32>((bitcast<u32>(_e264) & 2147483647u));
                    let _e297 = (_e296 * 0.00000011920929f);
                    let _e300 = select(select(0.00000000000011368684f, _e297, (_e297 > 0.00000000000011368684f)), 0f, _e293);
                    let _e301 = select(0f, _e289, _e293);
                    let _e302 = (_e264 + _e300);
                    let _e303 = (_e264 - _e300);
                    let _e305 = select(38685626000000000000000000f, (1f / _e289), _e293);
                    let _e306 = (_e199 == 0u);
                    if _e306 {
                        phi_513_ = _e238[0];
                    } else {
                        phi_513_ = _e238[1];
                    }
                    let _e310 = phi_513_;
                    let _e311 = (_e199 == 2u);
                    if _e311 {
                        phi_519_ = _e238[2];
                    } else {
                        phi_519_ = _e310;
                    }
                    let _e314 = phi_519_;
                    let _e315 = bitcast<u32>(_e314);
                    let _e317 = ((_e315 & 2139095040u) != 0u);
                    let _e331 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e314, _e317) * _e211) * select(0.00000011920929f, 1f, _e317)) * _e217);
                    if _e306 {
                        phi_559_ = _e265[0];
                    } else {
                        phi_559_ = _e265[1];
                    }
                    let _e335 = phi_559_;
                    if _e311 {
                        phi_565_ = _e265[2];
                    } else {
                        phi_565_ = _e335;
                    }
                    let _e338 = phi_565_;
                    let _e339 = bitcast<u32>(_e338);
                    let _e341 = ((_e339 & 2139095040u) != 0u);
                    let _e355 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e339 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e339 & 2147483648u))), _e338, _e341) * _e228) * select(0.00000011920929f, 1f, _e341)) * _e234);
                    let _e359 = (bitcast<f32>((bitcast<u32>(_e355) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e362 = bitcast<f32>((bitcast<u32>(_e331) & 2147483647u));
                    let _e363 = (_e362 * 0.00000011920929f);
                    let _e366 = select(select(0.00000000000011368684f, _e363, (_e363 > 0.00000000000011368684f)), 0f, _e359);
                    let _e367 = select(0f, _e355, _e359);
                    let _e368 = (_e331 + _e366);
                    let _e369 = (_e331 - _e366);
                    let _e371 = select(38685626000000000000000000f, (1f / _e355), _e359);
                    let _e372 = (_e201 == 0u);
                    if _e372 {
                        phi_638_ = _e238[0];
                    } else {
                        phi_638_ = _e238[1];
                    }
                    let _e376 = phi_638_;
                    let _e377 = (_e201 == 2u);
                    if _e377 {
                        phi_644_ = _e238[2];
                    } else {
                        phi_644_ = _e376;
                    }
                    let _e380 = phi_644_;
                    let _e381 = bitcast<u32>(_e380);
                    let _e383 = ((_e381 & 2139095040u) != 0u);
                    let _e397 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e381 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e381 & 2147483648u))), _e380, _e383) * _e211) * select(0.00000011920929f, 1f, _e383)) * _e217);
                    if _e372 {
                        phi_684_ = _e265[0];
                    } else {
                        phi_684_ = _e265[1];
                    }
                    let _e401 = phi_684_;
                    if _e377 {
                        phi_690_ = _e265[2];
                    } else {
                        phi_690_ = _e401;
                    }
                    let _e404 = phi_690_;
                    let _e405 = bitcast<u32>(_e404);
                    let _e407 = ((_e405 & 2139095040u) != 0u);
                    let _e421 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e405 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e405 & 2147483648u))), _e404, _e407) * _e228) * select(0.00000011920929f, 1f, _e407)) * _e234);
                    let _e425 = (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e428 = bitcast<f32>((bitcast<u32>(_e397) & 2147483647u));
                    let _e429 = (_e428 * 0.00000011920929f);
                    let _e432 = select(select(0.00000000000011368684f, _e429, (_e429 > 0.00000000000011368684f)), 0f, _e425);
                    let _e433 = select(0f, _e421, _e425);
                    let _e434 = (_e397 + _e432);
                    let _e435 = (_e397 - _e432);
                    let _e437 = select(38685626000000000000000000f, (1f / _e421), _e425);
                    let _e439 = select(_e362, _e296, (_e296 > _e362));
                    let _e442 = (_e86 + _e181);
                    if (_e162 && (select(_e428, _e439, (_e439 > _e428)) <= 1099511600000f)) {
                        let _e452 = ((_e149 & 8388607u) | (select(0u, 1u, ((_e149 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e455 = bitcast<i32>((_e149 >> bitcast<u32>(23i)));
                        let _e459 = (_e452 == 0u);
                        let _e462 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e452)), 32u, _e459)) - 8i);
                        if (_e455 == 255i) {
                            phi_809_ = 255i;
                        } else {
                            phi_809_ = (((_e455 + select(0i, 1i, (_e455 == 0i))) - _e462) + _e442);
                        }
                        let _e470 = phi_809_;
                        let _e480 = (_e470 <= 0i);
                        if _e480 {
                            phi_832_ = u32();
                        } else {
                            if _e459 {
                                phi_831_ = u32();
                            } else {
                                phi_831_ = select(((bitcast<u32>(_e470) << bitcast<u32>(23i)) | ((_e452 << bitcast<u32>(((_e462 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e470 >= 255i));
                            }
                            let _e484 = phi_831_;
                            phi_832_ = _e484;
                        }
                        let _e486 = phi_832_;
                        let _e498 = ((_e158 & 8388607u) | (select(0u, 1u, ((_e158 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e501 = bitcast<i32>((_e158 >> bitcast<u32>(23i)));
                        let _e505 = (_e498 == 0u);
                        let _e508 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e498)), 32u, _e505)) - 8i);
                        if (_e501 == 255i) {
                            phi_869_ = 255i;
                        } else {
                            phi_869_ = (((_e501 + select(0i, 1i, (_e501 == 0i))) - _e508) + _e442);
                        }
                        let _e516 = phi_869_;
                        let _e526 = (_e516 <= 0i);
                        if _e526 {
                            phi_892_ = u32();
                        } else {
                            if _e505 {
                                phi_891_ = u32();
                            } else {
                                phi_891_ = select(((bitcast<u32>(_e516) << bitcast<u32>(23i)) | ((_e498 << bitcast<u32>(((_e508 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e516 >= 255i));
                            }
                            let _e530 = phi_891_;
                            phi_892_ = _e530;
                        }
                        let _e532 = phi_892_;
                        phi_900_ = bitcast<f32>(((_e157 & 2147483648u) | select(_e532, 0u, select(_e505, true, _e526))));
                        phi_901_ = bitcast<f32>(((_e148 & 2147483648u) | select(_e486, 0u, select(_e459, true, _e480))));
                    } else {
                        phi_900_ = 0f;
                        phi_901_ = 1f;
                    }
                    let _e538 = phi_900_;
                    let _e540 = phi_901_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2571_ = false;
                    phi_916_ = type_47(_e538, false);
                    phi_919_ = (_e540 <= _e538);
                    phi_921_ = select(0u, 2147483648u, (_e72 == 0u));
                    phi_923_ = 0u;
                    phi_925_ = ((3u * _e72) + 1u);
                    loop {
                        let _e548 = phi_2571_;
                        let _e550 = phi_916_;
                        let _e552 = phi_919_;
                        let _e554 = phi_921_;
                        let _e556 = phi_923_;
                        let _e558 = phi_925_;
                        local_3 = _e550;
                        if _e552 {
                            phi_936_ = true;
                        } else {
                            phi_936_ = (_e556 > 0u);
                        }
                        let _e561 = phi_936_;
                        if _e561 {
                            let _e562 = (_e558 > 0u);
                            if _e562 {
                                if _e552 {
                                    phi_968_ = _e552;
                                    phi_969_ = _e554;
                                    phi_970_ = _e556;
                                } else {
                                    let _e563 = (_e556 - 1u);
                                    let _e564 = (_e563 % 128u);
                                    let _e565 = (_e564 < 128u);
                                    if _e565 {
                                    } else {
                                        phi_2715_ = true;
                                        break;
                                    }
                                    let _e567 = local_1[_e564];
                                    if _e565 {
                                    } else {
                                        phi_2715_ = true;
                                        break;
                                    }
                                    let _e569 = local[_e564];
                                    phi_968_ = (_e569 <= _e550.member);
                                    phi_969_ = _e567;
                                    phi_970_ = _e563;
                                }
                                let _e573 = phi_968_;
                                let _e575 = phi_969_;
                                let _e577 = phi_970_;
                                if _e573 {
                                    if ((_e575 & 2147483648u) != 0u) {
                                        phi_985_ = _e550;
                                        phi_988_ = type_7(0u, ((_e575 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e774 = phi_985_;
                                            let _e776 = phi_988_;
                                            local_2 = _e774;
                                            local_4 = _e774;
                                            if (_e776.member < _e776.member_1) {
                                                phi_989_ = type_7((_e776.member + 1u), _e776.member_1);
                                                phi_1011_ = type_7(1u, _e776.member);
                                            } else {
                                                phi_989_ = _e776;
                                                phi_1011_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e789 = phi_989_;
                                            let _e791 = phi_1011_;
                                            let _e795 = (bitcast<i32>(_e791.member) != 0i);
                                            if _e795 {
                                                let _e796 = ((_e575 & 268435455u) + _e791.member_1);
                                                let _e797 = (_e796 < _e74);
                                                if _e797 {
                                                    if _e797 {
                                                    } else {
                                                        phi_2565_ = true;
                                                        break;
                                                    }
                                                    let _e801 = global_3.member[_e796].member_1;
                                                    phi_1032_ = _e801;
                                                } else {
                                                    phi_1032_ = 4294967295u;
                                                }
                                                let _e803 = phi_1032_;
                                                if (_e796 >= _e74) {
                                                    phi_1124_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e797 {
                                                    } else {
                                                        phi_2565_ = true;
                                                        break;
                                                    }
                                                    let _e805 = (_e200 % 3u);
                                                    let _e806 = (_e199 % 3u);
                                                    let _e807 = (_e201 % 3u);
                                                    if (_e805 < 9u) {
                                                    } else {
                                                        phi_2565_ = true;
                                                        break;
                                                    }
                                                    let _e813 = global_3.member[_e796].member[_e805];
                                                    if (_e806 < 9u) {
                                                    } else {
                                                        phi_2565_ = true;
                                                        break;
                                                    }
                                                    let _e819 = global_3.member[_e796].member[_e806];
                                                    if (_e807 < 9u) {
                                                    } else {
                                                        phi_2565_ = true;
                                                        break;
                                                    }
                                                    let _e825 = global_3.member[_e796].member[_e807];
                                                    let _e827 = (3u + _e805);
                                                    if (_e827 < 9u) {
                                                    } else {
                                                        phi_2565_ = true;
                                                        break;
                                                    }
                                                    let _e833 = global_3.member[_e796].member[_e827];
                                                    let _e834 = (3u + _e806);
                                                    if (_e834 < 9u) {
                                                    } else {
                                                        phi_2565_ = true;
                                                        break;
                                                    }
                                                    let _e840 = global_3.member[_e796].member[_e834];
                                                    let _e841 = (3u + _e807);
                                                    if (_e841 < 9u) {
                                                    } else {
                                                        phi_2565_ = true;
                                                        break;
                                                    }
                                                    let _e847 = global_3.member[_e796].member[_e841];
                                                    let _e849 = (6u + _e805);
                                                    if (_e849 < 9u) {
                                                    } else {
                                                        phi_2565_ = true;
                                                        break;
                                                    }
                                                    let _e855 = global_3.member[_e796].member[_e849];
                                                    let _e856 = (6u + _e806);
                                                    if (_e856 < 9u) {
                                                    } else {
                                                        phi_2565_ = true;
                                                        break;
                                                    }
                                                    let _e862 = global_3.member[_e796].member[_e856];
                                                    let _e863 = (6u + _e807);
                                                    if (_e863 < 9u) {
                                                    } else {
                                                        phi_2565_ = true;
                                                        break;
                                                    }
                                                    let _e869 = global_3.member[_e796].member[_e863];
                                                    phi_1124_ = array<array<f32, 3>, 3>(array<f32, 3>(_e813, _e819, _e825), array<f32, 3>(_e833, _e840, _e847), array<f32, 3>(_e855, _e862, _e869));
                                                }
                                                let _e873 = phi_1124_;
                                                let _e889 = (_e873[0][2] - _e397);
                                                let _e892 = (((_e873[0][0] - _e264) * _e433) - (_e889 * _e301));
                                                let _e895 = (((_e873[0][1] - _e331) * _e433) - (_e889 * _e367));
                                                let _e898 = (_e873[1][2] - _e397);
                                                let _e901 = (((_e873[1][0] - _e264) * _e433) - (_e898 * _e301));
                                                let _e904 = (((_e873[1][1] - _e331) * _e433) - (_e898 * _e367));
                                                let _e907 = (_e873[2][2] - _e397);
                                                let _e910 = (((_e873[2][0] - _e264) * _e433) - (_e907 * _e301));
                                                let _e913 = (((_e873[2][1] - _e331) * _e433) - (_e907 * _e367));
                                                let _e914 = (_e910 * _e904);
                                                let _e915 = (_e913 * _e901);
                                                let _e916 = (_e892 * _e913);
                                                let _e917 = (_e895 * _e910);
                                                let _e918 = (_e901 * _e895);
                                                let _e919 = (_e904 * _e892);
                                                let _e924 = (((_e914 >= _e915) && (_e916 >= _e917)) && (_e918 >= _e919));
                                                let _e930 = (_e924 || (((_e914 <= _e915) && (_e916 <= _e917)) && (_e918 <= _e919)));
                                                if _e930 {
                                                    let _e932 = select(-1f, 1f, _e924);
                                                    let _e934 = ((_e914 - _e915) * _e932);
                                                    let _e936 = select(0f, _e934, (_e934 > 0f));
                                                    let _e938 = ((_e916 - _e917) * _e932);
                                                    let _e940 = select(0f, _e938, (_e938 > 0f));
                                                    let _e942 = ((_e918 - _e919) * _e932);
                                                    let _e944 = select(0f, _e942, (_e942 > 0f));
                                                    let _e946 = ((_e936 + _e940) + _e944);
                                                    let _e948 = select(_e873[1][0], _e873[0][0], (_e873[0][0] < _e873[1][0]));
                                                    let _e952 = select(_e873[1][0], _e873[0][0], (_e873[0][0] > _e873[1][0]));
                                                    let _e956 = select(_e873[1][1], _e873[0][1], (_e873[0][1] < _e873[1][1]));
                                                    let _e960 = select(_e873[1][1], _e873[0][1], (_e873[0][1] > _e873[1][1]));
                                                    let _e964 = select(_e873[1][2], _e873[0][2], (_e873[0][2] < _e873[1][2]));
                                                    let _e968 = select(_e873[1][2], _e873[0][2], (_e873[0][2] > _e873[1][2]));
                                                    let _e973 = ((select(_e873[2][0], _e948, (_e948 < _e873[2][0])) - _e302) * _e305);
                                                    let _e974 = ((select(_e873[2][0], _e952, (_e952 > _e873[2][0])) - _e303) * _e305);
                                                    let _e977 = ((select(_e873[2][1], _e956, (_e956 < _e873[2][1])) - _e368) * _e371);
                                                    let _e978 = ((select(_e873[2][1], _e960, (_e960 > _e873[2][1])) - _e369) * _e371);
                                                    let _e981 = ((select(_e873[2][2], _e964, (_e964 < _e873[2][2])) - _e434) * _e437);
                                                    let _e982 = ((select(_e873[2][2], _e968, (_e968 > _e873[2][2])) - _e435) * _e437);
                                                    let _e984 = select(_e982, _e981, (_e981 < _e982));
                                                    let _e986 = select(_e982, _e981, (_e981 > _e982));
                                                    let _e988 = select(_e974, _e973, (_e973 < _e974));
                                                    let _e990 = select(_e978, _e977, (_e977 < _e978));
                                                    let _e992 = select(_e990, _e988, (_e988 > _e990));
                                                    let _e994 = select(_e984, _e992, (_e992 > _e984));
                                                    let _e996 = select(_e974, _e973, (_e973 > _e974));
                                                    let _e998 = select(_e978, _e977, (_e977 > _e978));
                                                    let _e1000 = select(_e998, _e996, (_e996 < _e998));
                                                    let _e1002 = select(_e986, _e1000, (_e1000 < _e986));
                                                    let _e1003 = -(_e984);
                                                    let _e1009 = select(_e540, _e994, (_e994 > _e540));
                                                    let _e1013 = select(_e901, _e892, (_e892 < _e901));
                                                    let _e1018 = select(_e901, _e892, (_e892 > _e901));
                                                    let _e1025 = select(_e904, _e895, (_e895 < _e904));
                                                    let _e1030 = select(_e904, _e895, (_e895 > _e904));
                                                    let _e1039 = (((((_e930 && (_e946 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e910, _e1013, (_e1013 < _e910)) <= 0f) && (select(_e910, _e1018, (_e1018 > _e910)) >= 0f))) && ((select(_e913, _e1025, (_e1025 < _e913)) <= 0f) && (select(_e913, _e1030, (_e1030 > _e913)) >= 0f))) && (_e1009 <= (_e1002 + (select(_e1003, _e986, (_e986 > _e1003)) * 0.0000019073523f)))) && (_e1009 <= _e774.member));
                                                    if _e1039 {
                                                        let _e1044 = (_e873[1][0] - _e873[0][0]);
                                                        let _e1045 = (_e873[1][1] - _e873[0][1]);
                                                        let _e1046 = (_e873[1][2] - _e873[0][2]);
                                                        let _e1047 = vec3<f32>(_e1044, _e1045, _e1046);
                                                        let _e1048 = (_e873[2][0] - _e873[1][0]);
                                                        let _e1049 = (_e873[2][1] - _e873[1][1]);
                                                        let _e1050 = (_e873[2][2] - _e873[1][2]);
                                                        let _e1051 = vec3<f32>(_e1048, _e1049, _e1050);
                                                        let _e1052 = (_e873[0][0] - _e873[2][0]);
                                                        let _e1053 = (_e873[0][1] - _e873[2][1]);
                                                        let _e1054 = (_e873[0][2] - _e873[2][2]);
                                                        let _e1055 = vec3<f32>(_e1052, _e1053, _e1054);
                                                        let _e1058 = bitcast<f32>((bitcast<u32>(_e1044) & 2147483647u));
                                                        let _e1061 = bitcast<f32>((bitcast<u32>(_e1045) & 2147483647u));
                                                        let _e1063 = select(_e1061, _e1058, (_e1058 > _e1061));
                                                        let _e1066 = bitcast<f32>((bitcast<u32>(_e1046) & 2147483647u));
                                                        let _e1068 = select(_e1066, _e1063, (_e1063 > _e1066));
                                                        let _e1071 = bitcast<f32>((bitcast<u32>(_e1048) & 2147483647u));
                                                        let _e1074 = bitcast<f32>((bitcast<u32>(_e1049) & 2147483647u));
                                                        let _e1076 = select(_e1074, _e1071, (_e1071 > _e1074));
                                                        let _e1079 = bitcast<f32>((bitcast<u32>(_e1050) & 2147483647u));
                                                        let _e1081 = select(_e1079, _e1076, (_e1076 > _e1079));
                                                        let _e1084 = bitcast<f32>((bitcast<u32>(_e1052) & 2147483647u));
                                                        let _e1087 = bitcast<f32>((bitcast<u32>(_e1053) & 2147483647u));
                                                        let _e1089 = select(_e1087, _e1084, (_e1084 > _e1087));
                                                        let _e1092 = bitcast<f32>((bitcast<u32>(_e1054) & 2147483647u));
                                                        let _e1094 = select(_e1092, _e1089, (_e1089 > _e1092));
                                                        let _e1096 = select(_e1081, _e1068, (_e1068 > _e1081));
                                                        let _e1098 = select(_e1094, _e1096, (_e1096 > _e1094));
                                                        if (_e1068 == _e1098) {
                                                            phi_1654_ = _e904;
                                                            phi_1655_ = _e901;
                                                            phi_1656_ = _e895;
                                                            phi_1657_ = _e892;
                                                            phi_1658_ = vec3<f32>(_e873[0][0], _e873[0][1], _e873[0][2]);
                                                            phi_1659_ = _e1055;
                                                            phi_1660_ = _e1051;
                                                            phi_1661_ = _e1047;
                                                        } else {
                                                            let _e1100 = (_e1081 == _e1098);
                                                            let _e1105 = vec3(_e1100);
                                                            phi_1654_ = select(_e895, _e913, _e1100);
                                                            phi_1655_ = select(_e892, _e910, _e1100);
                                                            phi_1656_ = select(_e913, _e904, _e1100);
                                                            phi_1657_ = select(_e910, _e901, _e1100);
                                                            phi_1658_ = select(vec3<f32>(_e873[2][0], _e873[2][1], _e873[2][2]), vec3<f32>(_e873[1][0], _e873[1][1], _e873[1][2]), _e1105);
                                                            phi_1659_ = select(_e1051, _e1047, _e1105);
                                                            phi_1660_ = select(_e1047, _e1055, _e1105);
                                                            phi_1661_ = select(_e1055, _e1051, _e1105);
                                                        }
                                                        let _e1111 = phi_1654_;
                                                        let _e1113 = phi_1655_;
                                                        let _e1115 = phi_1656_;
                                                        let _e1117 = phi_1657_;
                                                        let _e1119 = phi_1658_;
                                                        let _e1121 = phi_1659_;
                                                        let _e1123 = phi_1660_;
                                                        let _e1125 = phi_1661_;
                                                        let _e1132 = ((_e1123.y * _e1121.z) - (_e1121.y * _e1123.z));
                                                        let _e1137 = ((_e1123.z * _e1121.x) - (_e1121.z * _e1123.x));
                                                        let _e1140 = ((_e1123.x * _e1121.y) - (_e1121.x * _e1123.y));
                                                        let _e1143 = ((_e936 >= _e940) && (_e936 >= _e944));
                                                        let _e1144 = (_e940 >= _e944);
                                                        let _e1158 = (((_e1132 * (select(select(_e873[2][0], _e873[1][0], _e1144), _e873[0][0], _e1143) - _e264)) + (_e1137 * (select(select(_e873[2][1], _e873[1][1], _e1144), _e873[0][1], _e1143) - _e331))) + (_e1140 * (select(select(_e873[2][2], _e873[1][2], _e1144), _e873[0][2], _e1143) - _e397)));
                                                        let _e1163 = (((_e1132 * _e301) + (_e1137 * _e367)) + (_e1140 * _e433));
                                                        let _e1164 = (_e1113 - _e1117);
                                                        let _e1165 = (_e1111 - _e1115);
                                                        let _e1168 = ((_e1164 * _e1164) + (_e1165 * _e1165));
                                                        let _e1175 = (-(((_e1117 * _e1164) + (_e1115 * _e1165))) / select(0.000000000000000000000000000000000000011754944f, _e1168, (_e1168 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1177 = select(1f, _e1175, (_e1175 < 1f));
                                                        let _e1179 = select(0f, _e1177, (_e1177 > 0f));
                                                        let _e1188 = ((_e1119.x + (_e1125.x * _e1179)) - _e264);
                                                        let _e1191 = ((_e1119.y + (_e1125.y * _e1179)) - _e331);
                                                        let _e1194 = ((_e1119.z + (_e1125.z * _e1179)) - _e397);
                                                        let _e1197 = bitcast<f32>((bitcast<u32>(_e1188) & 2147483647u));
                                                        let _e1200 = bitcast<f32>((bitcast<u32>(_e1191) & 2147483647u));
                                                        let _e1202 = select(_e1200, _e1197, (_e1197 > _e1200));
                                                        let _e1205 = bitcast<f32>((bitcast<u32>(_e1194) & 2147483647u));
                                                        let _e1207 = select(_e1205, _e1202, (_e1202 > _e1205));
                                                        let _e1213 = bitcast<f32>((bitcast<u32>(_e1132) & 2147483647u));
                                                        let _e1216 = bitcast<f32>((bitcast<u32>(_e1137) & 2147483647u));
                                                        let _e1218 = select(_e1216, _e1213, (_e1213 > _e1216));
                                                        let _e1221 = bitcast<f32>((bitcast<u32>(_e1140) & 2147483647u));
                                                        let _e1240 = bitcast<f32>((bitcast<u32>(_e1123.x) & 2147483647u));
                                                        let _e1243 = bitcast<f32>((bitcast<u32>(_e1123.y) & 2147483647u));
                                                        let _e1245 = select(_e1243, _e1240, (_e1240 > _e1243));
                                                        let _e1248 = bitcast<f32>((bitcast<u32>(_e1123.z) & 2147483647u));
                                                        let _e1254 = bitcast<f32>((bitcast<u32>(_e1121.x) & 2147483647u));
                                                        let _e1257 = bitcast<f32>((bitcast<u32>(_e1121.y) & 2147483647u));
                                                        let _e1259 = select(_e1257, _e1254, (_e1254 > _e1257));
                                                        let _e1262 = bitcast<f32>((bitcast<u32>(_e1121.z) & 2147483647u));
                                                        let _e1268 = ((bitcast<f32>((bitcast<u32>(((((_e1132 * _e1188) + (_e1137 * _e1191)) + (_e1140 * _e1194)) - _e1158)) & 2147483647u)) <= ((0.0000009536743f * select(_e1098, _e1207, (_e1207 > _e1098))) * select(_e1221, _e1218, (_e1218 > _e1221)))) && !((bitcast<f32>((bitcast<u32>(_e1163) & 2147483647u)) <= ((0.0000038146973f * select(_e1248, _e1245, (_e1245 > _e1248))) * select(_e1262, _e1259, (_e1259 > _e1262))))));
                                                        let _e1269 = (_e1158 / _e1163);
                                                        if (_e1039 && !(_e1268)) {
                                                            let _e1272 = (_e1194 / _e433);
                                                            let _e1280 = (((_e1132 * (_e1188 - (_e301 * _e1272))) + (_e1137 * (_e1191 - (_e367 * _e1272)))) / _e1163);
                                                            phi_1852_ = select(select(_e1272, (_e1272 + _e1280), (bitcast<f32>((bitcast<u32>(_e1280) & 2147483647u)) <= _e1098)), _e1269, _e1268);
                                                        } else {
                                                            phi_1852_ = _e1269;
                                                        }
                                                        let _e1289 = phi_1852_;
                                                        let _e1291 = select(_e1002, _e1289, (_e1289 < _e1002));
                                                        let _e1293 = select(_e994, _e1291, (_e1291 > _e994));
                                                        let _e1294 = (1f / _e946);
                                                        phi_1872_ = type_42(_e1293, (_e940 * _e1294), (_e944 * _e1294), ((_e1039 && (_e1293 >= _e540)) && (_e1293 <= _e774.member)));
                                                        phi_1873_ = type_42();
                                                    } else {
                                                        phi_1872_ = type_42();
                                                        phi_1873_ = type_42(0f, 0f, 0f, _e1039);
                                                    }
                                                    let _e1303 = phi_1872_;
                                                    let _e1305 = phi_1873_;
                                                    phi_1876_ = _e1303;
                                                    phi_1877_ = _e1305;
                                                    phi_1878_ = select(true, false, _e1039);
                                                } else {
                                                    phi_1876_ = type_42();
                                                    phi_1877_ = type_42(0f, 0f, 0f, _e930);
                                                    phi_1878_ = true;
                                                }
                                                let _e1308 = phi_1876_;
                                                let _e1310 = phi_1877_;
                                                let _e1312 = phi_1878_;
                                                if _e1312 {
                                                    phi_1882_ = _e1310;
                                                } else {
                                                    phi_1882_ = _e1308;
                                                }
                                                let _e1314 = phi_1882_;
                                                if _e1314.member_3 {
                                                    phi_1891_ = type_26(_e1314.member, _e1314.member_1, _e1314.member_2, _e803);
                                                } else {
                                                    phi_1891_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1321 = phi_1891_;
                                                if (_e1321.member_3 != 4294967295u) {
                                                    if (_e803 != 4294967295u) {
                                                        phi_1902_ = type_47(-340282350000000000000000000000000000000f, true);
                                                    } else {
                                                        phi_1902_ = _e774;
                                                    }
                                                    let _e1326 = phi_1902_;
                                                    phi_1903_ = _e1326;
                                                } else {
                                                    phi_1903_ = _e774;
                                                }
                                                let _e1328 = phi_1903_;
                                                phi_986_ = _e1328;
                                            } else {
                                                phi_986_ = type_47();
                                            }
                                            let _e1330 = phi_986_;
                                            continue;
                                            continuing {
                                                phi_985_ = _e1330;
                                                phi_988_ = _e789;
                                                phi_2565_ = _e548;
                                                break if !(_e795);
                                            }
                                        }
                                        let _e1333 = phi_2565_;
                                        phi_2715_ = _e1333;
                                        if _e1333 {
                                            break;
                                        }
                                        let _e1335 = local_2;
                                        phi_2719_ = _e1333;
                                        let _e1476 = local_4;
                                        phi_2380_ = _e1476;
                                        phi_2381_ = false;
                                        phi_2382_ = _e575;
                                        phi_2383_ = select(_e577, 0u, (_e540 > _e1335.member));
                                    } else {
                                        if (_e575 >= _e72) {
                                            phi_1968_ = type_43(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e575 < _e72) {
                                            } else {
                                                phi_2715_ = true;
                                                break;
                                            }
                                            let _e587 = (_e200 % 3u);
                                            if (_e587 < 3u) {
                                            } else {
                                                phi_2715_ = true;
                                                break;
                                            }
                                            let _e593 = global_2.member[_e575].member[_e587];
                                            let _e599 = (_e199 % 3u);
                                            if (_e599 < 3u) {
                                            } else {
                                                phi_2715_ = true;
                                                break;
                                            }
                                            let _e605 = global_2.member[_e575].member[_e599];
                                            let _e611 = (_e201 % 3u);
                                            if (_e611 < 3u) {
                                            } else {
                                                phi_2715_ = true;
                                                break;
                                            }
                                            let _e617 = global_2.member[_e575].member[_e611];
                                            let _e627 = global_2.member[_e575].member_1;
                                            let _e631 = global_2.member[_e575].member_2;
                                            phi_1968_ = type_43(array<vec4<f32>, 3>(vec4<f32>(_e593[0], _e593[1], _e593[2], _e593[3]), vec4<f32>(_e605[0], _e605[1], _e605[2], _e605[3]), vec4<f32>(_e617[0], _e617[1], _e617[2], _e617[3])), _e627, _e631);
                                        }
                                        let _e634 = phi_1968_;
                                        let _e646 = ((_e634.member[0].x - _e302) * _e305);
                                        let _e647 = ((_e634.member[0].y - _e302) * _e305);
                                        let _e648 = ((_e634.member[0].z - _e303) * _e305);
                                        let _e649 = ((_e634.member[0].w - _e303) * _e305);
                                        let _e659 = ((_e634.member[1].x - _e368) * _e371);
                                        let _e660 = ((_e634.member[1].y - _e368) * _e371);
                                        let _e661 = ((_e634.member[1].z - _e369) * _e371);
                                        let _e662 = ((_e634.member[1].w - _e369) * _e371);
                                        let _e672 = ((_e634.member[2].x - _e434) * _e437);
                                        let _e673 = ((_e634.member[2].y - _e434) * _e437);
                                        let _e674 = ((_e634.member[2].z - _e435) * _e437);
                                        let _e675 = ((_e634.member[2].w - _e435) * _e437);
                                        let _e677 = select(_e674, _e672, (_e672 < _e674));
                                        let _e679 = select(_e675, _e673, (_e673 < _e675));
                                        let _e681 = select(_e674, _e672, (_e672 > _e674));
                                        let _e683 = select(_e675, _e673, (_e673 > _e675));
                                        let _e685 = select(_e648, _e646, (_e646 < _e648));
                                        let _e687 = select(_e649, _e647, (_e647 < _e649));
                                        let _e689 = select(_e661, _e659, (_e659 < _e661));
                                        let _e691 = select(_e662, _e660, (_e660 < _e662));
                                        let _e693 = select(_e689, _e685, (_e685 > _e689));
                                        let _e695 = select(_e691, _e687, (_e687 > _e691));
                                        let _e697 = select(_e677, _e693, (_e693 > _e677));
                                        let _e699 = select(_e679, _e695, (_e695 > _e679));
                                        let _e701 = select(_e648, _e646, (_e646 > _e648));
                                        let _e703 = select(_e649, _e647, (_e647 > _e649));
                                        let _e705 = select(_e661, _e659, (_e659 > _e661));
                                        let _e707 = select(_e662, _e660, (_e660 > _e662));
                                        let _e709 = select(_e705, _e701, (_e701 < _e705));
                                        let _e711 = select(_e707, _e703, (_e703 < _e707));
                                        let _e716 = -(_e677);
                                        let _e717 = -(_e679);
                                        let _e724 = (select(_e681, _e709, (_e709 < _e681)) + (select(_e716, _e681, (_e681 > _e716)) * 0.0000019073523f));
                                        let _e725 = (select(_e683, _e711, (_e711 < _e683)) + (select(_e717, _e683, (_e683 > _e717)) * 0.0000019073523f));
                                        let _e727 = select(_e540, _e697, (_e697 > _e540));
                                        let _e729 = select(_e540, _e699, (_e699 > _e540));
                                        let _e734 = (_e727 <= select(_e550.member, _e724, (_e724 < _e550.member)));
                                        let _e735 = (_e729 <= select(_e550.member, _e725, (_e725 < _e550.member)));
                                        let _e736 = (_e727 <= _e729);
                                        if _e734 {
                                            if _e735 {
                                                if _e736 {
                                                    phi_2330_ = _e634.member_2;
                                                } else {
                                                    phi_2330_ = _e634.member_1;
                                                }
                                                let _e740 = phi_2330_;
                                                let _e742 = (_e577 % 128u);
                                                let _e743 = (_e742 < 128u);
                                                if _e743 {
                                                } else {
                                                    phi_2715_ = true;
                                                    break;
                                                }
                                                local_1[_e742] = _e740;
                                                if _e743 {
                                                } else {
                                                    phi_2715_ = true;
                                                    break;
                                                }
                                                local[_e742] = select(_e727, _e729, _e736);
                                                if _e736 {
                                                    phi_2357_ = _e634.member_1;
                                                } else {
                                                    phi_2357_ = _e634.member_2;
                                                }
                                                let _e750 = phi_2357_;
                                                phi_2358_ = _e750;
                                                phi_2359_ = (_e577 + 1u);
                                            } else {
                                                phi_2358_ = u32();
                                                phi_2359_ = u32();
                                            }
                                            let _e752 = phi_2358_;
                                            let _e754 = phi_2359_;
                                            phi_2361_ = _e752;
                                            phi_2362_ = _e754;
                                            phi_2363_ = select(true, false, _e735);
                                        } else {
                                            phi_2361_ = u32();
                                            phi_2362_ = u32();
                                            phi_2363_ = true;
                                        }
                                        let _e757 = phi_2361_;
                                        let _e759 = phi_2362_;
                                        let _e761 = phi_2363_;
                                        if _e761 {
                                            if _e734 {
                                                phi_2372_ = _e634.member_1;
                                            } else {
                                                phi_2372_ = _e634.member_2;
                                            }
                                            let _e765 = phi_2372_;
                                            phi_2377_ = select(_e735, true, _e734);
                                            phi_2378_ = _e765;
                                        } else {
                                            phi_2377_ = _e573;
                                            phi_2378_ = _e757;
                                        }
                                        let _e768 = phi_2377_;
                                        let _e770 = phi_2378_;
                                        phi_2719_ = _e548;
                                        phi_2380_ = _e550;
                                        phi_2381_ = _e768;
                                        phi_2382_ = _e770;
                                        phi_2383_ = select(_e759, _e577, _e761);
                                    }
                                    let _e1340 = phi_2719_;
                                    let _e1342 = phi_2380_;
                                    let _e1344 = phi_2381_;
                                    let _e1346 = phi_2382_;
                                    let _e1348 = phi_2383_;
                                    phi_2718_ = _e1340;
                                    phi_2384_ = _e1342;
                                    phi_2385_ = _e1344;
                                    phi_2386_ = _e1346;
                                    phi_2387_ = _e1348;
                                    phi_2388_ = (_e558 - 1u);
                                } else {
                                    phi_2718_ = _e548;
                                    phi_2384_ = _e550;
                                    phi_2385_ = _e573;
                                    phi_2386_ = _e575;
                                    phi_2387_ = _e577;
                                    phi_2388_ = _e558;
                                }
                                let _e1350 = phi_2718_;
                                let _e1352 = phi_2384_;
                                let _e1354 = phi_2385_;
                                let _e1356 = phi_2386_;
                                let _e1358 = phi_2387_;
                                let _e1360 = phi_2388_;
                                phi_2717_ = _e1350;
                                phi_2389_ = _e1352;
                                phi_2390_ = _e1354;
                                phi_2391_ = _e1356;
                                phi_2392_ = _e1358;
                                phi_2393_ = _e1360;
                            } else {
                                phi_2717_ = _e548;
                                phi_2389_ = type_47();
                                phi_2390_ = bool();
                                phi_2391_ = u32();
                                phi_2392_ = u32();
                                phi_2393_ = u32();
                            }
                            let _e1362 = phi_2717_;
                            let _e1364 = phi_2389_;
                            let _e1366 = phi_2390_;
                            let _e1368 = phi_2391_;
                            let _e1370 = phi_2392_;
                            let _e1372 = phi_2393_;
                            phi_2716_ = _e1362;
                            phi_917_ = _e1364;
                            phi_920_ = _e1366;
                            phi_922_ = _e1368;
                            phi_924_ = _e1370;
                            phi_926_ = _e1372;
                            phi_2394_ = _e562;
                        } else {
                            phi_2716_ = _e548;
                            phi_917_ = type_47();
                            phi_920_ = bool();
                            phi_922_ = u32();
                            phi_924_ = u32();
                            phi_926_ = u32();
                            phi_2394_ = false;
                        }
                        let _e1374 = phi_2716_;
                        let _e1376 = phi_917_;
                        let _e1378 = phi_920_;
                        let _e1380 = phi_922_;
                        let _e1382 = phi_924_;
                        let _e1384 = phi_926_;
                        let _e1386 = phi_2394_;
                        continue;
                        continuing {
                            phi_2571_ = _e1374;
                            phi_916_ = _e1376;
                            phi_919_ = _e1378;
                            phi_921_ = _e1380;
                            phi_923_ = _e1382;
                            phi_925_ = _e1384;
                            phi_2715_ = _e1374;
                            break if !(_e1386);
                        }
                    }
                    let _e1389 = phi_2715_;
                    if _e1389 {
                        break;
                    }
                    let _e1391 = local_3;
                    if _e88 {
                    } else {
                        break;
                    }
                    global_5.member[_e82] = select(0u, 1u, _e1391.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
