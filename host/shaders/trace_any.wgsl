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
    var phi_301_: i32;
    var phi_302_: i32;
    var phi_312_: bool;
    var phi_322_: u32;
    var phi_323_: u32;
    var phi_325_: bool;
    var phi_330_: u32;
    var phi_343_: i32;
    var phi_363_: i32;
    var phi_381_: f32;
    var phi_387_: f32;
    var phi_427_: f32;
    var phi_433_: f32;
    var phi_506_: f32;
    var phi_512_: f32;
    var phi_552_: f32;
    var phi_558_: f32;
    var phi_631_: f32;
    var phi_637_: f32;
    var phi_677_: f32;
    var phi_683_: f32;
    var phi_802_: i32;
    var phi_824_: u32;
    var phi_825_: u32;
    var phi_862_: i32;
    var phi_884_: u32;
    var phi_885_: u32;
    var phi_893_: f32;
    var phi_894_: f32;
    var phi_2643_: bool;
    var phi_909_: type_47;
    var phi_912_: u32;
    var phi_914_: bool;
    var phi_916_: u32;
    var phi_918_: u32;
    var phi_929_: bool;
    var phi_961_: bool;
    var phi_962_: u32;
    var phi_963_: u32;
    var phi_978_: type_47;
    var phi_981_: type_7;
    var phi_982_: type_7;
    var phi_1004_: type_7;
    var phi_1025_: u32;
    var phi_1117_: array<array<f32, 3>, 3>;
    var phi_2463_: bool;
    var phi_2478_: bool;
    var phi_2493_: bool;
    var phi_2508_: bool;
    var phi_2523_: bool;
    var phi_2538_: bool;
    var phi_1659_: f32;
    var phi_1660_: f32;
    var phi_1661_: f32;
    var phi_1662_: f32;
    var phi_1663_: vec3<f32>;
    var phi_1664_: vec3<f32>;
    var phi_1665_: vec3<f32>;
    var phi_1666_: vec3<f32>;
    var phi_2553_: bool;
    var phi_2568_: bool;
    var phi_2583_: bool;
    var phi_2598_: bool;
    var phi_2613_: bool;
    var phi_2628_: bool;
    var phi_1874_: f32;
    var phi_1894_: type_42;
    var phi_1895_: type_42;
    var phi_1898_: type_42;
    var phi_1899_: type_42;
    var phi_1900_: bool;
    var phi_1904_: type_42;
    var phi_1913_: type_26;
    var phi_1924_: type_47;
    var phi_1925_: type_47;
    var phi_979_: type_47;
    var phi_2637_: bool;
    var phi_2834_: bool;
    var phi_1926_: type_47;
    var phi_1991_: type_43;
    var phi_2353_: u32;
    var phi_2380_: u32;
    var phi_2381_: u32;
    var phi_2382_: u32;
    var phi_2384_: u32;
    var phi_2385_: u32;
    var phi_2386_: bool;
    var phi_2395_: u32;
    var phi_2400_: bool;
    var phi_2402_: u32;
    var phi_2406_: bool;
    var phi_2407_: u32;
    var phi_2408_: u32;
    var phi_2418_: u32;
    var phi_2802_: bool;
    var phi_2420_: type_47;
    var phi_2421_: u32;
    var phi_2422_: bool;
    var phi_2423_: u32;
    var phi_2424_: u32;
    var phi_2801_: bool;
    var phi_2425_: type_47;
    var phi_2426_: u32;
    var phi_2427_: bool;
    var phi_2428_: u32;
    var phi_2429_: u32;
    var phi_2800_: bool;
    var phi_910_: type_47;
    var phi_913_: u32;
    var phi_915_: bool;
    var phi_917_: u32;
    var phi_919_: u32;
    var phi_2430_: bool;
    var phi_2799_: bool;
    var local_2: type_47;
    var local_3: type_47;

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
                            phi_301_ = (bitcast<i32>((_e165 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_301_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e165)), 32u, (_e165 == 0u))));
                        }
                        let _e179 = phi_301_;
                        phi_302_ = _e179;
                    } else {
                        phi_302_ = 0i;
                    }
                    let _e181 = phi_302_;
                    let _e182 = (_e98 == _e137);
                    if _e182 {
                        phi_312_ = true;
                    } else {
                        phi_312_ = (_e105 == _e137);
                    }
                    let _e185 = phi_312_;
                    let _e186 = select(1u, 0u, _e182);
                    if _e185 {
                        let _e187 = (_e186 + 1u);
                        phi_322_ = _e187;
                        phi_323_ = _e187;
                        phi_325_ = select(true, false, (_e187 == 2u));
                    } else {
                        phi_322_ = u32();
                        phi_323_ = 0u;
                        phi_325_ = true;
                    }
                    let _e191 = phi_322_;
                    let _e193 = phi_323_;
                    let _e195 = phi_325_;
                    if _e195 {
                        phi_330_ = (_e193 + 1u);
                    } else {
                        phi_330_ = 0u;
                    }
                    let _e199 = phi_330_;
                    let _e200 = select(_e191, _e193, _e195);
                    let _e201 = select(_e186, select(2u, _e186, _e185), _e195);
                    if (_e86 < -126i) {
                        phi_343_ = -126i;
                    } else {
                        phi_343_ = select(_e86, 127i, (_e86 > 127i));
                    }
                    let _e206 = phi_343_;
                    let _e211 = bitcast<f32>((bitcast<u32>((_e206 + 127i)) << bitcast<u32>(23i)));
                    let _e217 = bitcast<f32>((bitcast<u32>(((_e86 - _e206) + 127i)) << bitcast<u32>(23i)));
                    let _e218 = -(_e181);
                    if (_e218 < -126i) {
                        phi_363_ = -126i;
                    } else {
                        phi_363_ = select(_e218, 127i, (_e218 > 127i));
                    }
                    let _e223 = phi_363_;
                    let _e228 = bitcast<f32>((bitcast<u32>((_e223 + 127i)) << bitcast<u32>(23i)));
                    let _e234 = bitcast<f32>((bitcast<u32>(((_e218 - _e223) + 127i)) << bitcast<u32>(23i)));
                    let _e238 = global_4.member[_e82].member;
                    let _e239 = (_e200 == 0u);
                    if _e239 {
                        phi_381_ = _e238[0];
                    } else {
                        phi_381_ = _e238[1];
                    }
                    let _e243 = phi_381_;
                    let _e244 = (_e200 == 2u);
                    if _e244 {
                        phi_387_ = _e238[2];
                    } else {
                        phi_387_ = _e243;
                    }
                    let _e247 = phi_387_;
                    let _e248 = bitcast<u32>(_e247);
                    let _e250 = ((_e248 & 2139095040u) != 0u);
                    let _e264 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e248 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e248 & 2147483648u))), _e247, _e250) * _e211) * select(0.00000011920929f, 1f, _e250)) * _e217);
                    let _e265 = global_4.member[_e82].member_2;
                    if _e239 {
                        phi_427_ = _e265[0];
                    } else {
                        phi_427_ = _e265[1];
                    }
                    let _e269 = phi_427_;
                    if _e244 {
                        phi_433_ = _e265[2];
                    } else {
                        phi_433_ = _e269;
                    }
                    let _e272 = phi_433_;
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
                        phi_506_ = _e238[0];
                    } else {
                        phi_506_ = _e238[1];
                    }
                    let _e310 = phi_506_;
                    let _e311 = (_e199 == 2u);
                    if _e311 {
                        phi_512_ = _e238[2];
                    } else {
                        phi_512_ = _e310;
                    }
                    let _e314 = phi_512_;
                    let _e315 = bitcast<u32>(_e314);
                    let _e317 = ((_e315 & 2139095040u) != 0u);
                    let _e331 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e314, _e317) * _e211) * select(0.00000011920929f, 1f, _e317)) * _e217);
                    if _e306 {
                        phi_552_ = _e265[0];
                    } else {
                        phi_552_ = _e265[1];
                    }
                    let _e335 = phi_552_;
                    if _e311 {
                        phi_558_ = _e265[2];
                    } else {
                        phi_558_ = _e335;
                    }
                    let _e338 = phi_558_;
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
                        phi_631_ = _e238[0];
                    } else {
                        phi_631_ = _e238[1];
                    }
                    let _e376 = phi_631_;
                    let _e377 = (_e201 == 2u);
                    if _e377 {
                        phi_637_ = _e238[2];
                    } else {
                        phi_637_ = _e376;
                    }
                    let _e380 = phi_637_;
                    let _e381 = bitcast<u32>(_e380);
                    let _e383 = ((_e381 & 2139095040u) != 0u);
                    let _e397 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e381 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e381 & 2147483648u))), _e380, _e383) * _e211) * select(0.00000011920929f, 1f, _e383)) * _e217);
                    if _e372 {
                        phi_677_ = _e265[0];
                    } else {
                        phi_677_ = _e265[1];
                    }
                    let _e401 = phi_677_;
                    if _e377 {
                        phi_683_ = _e265[2];
                    } else {
                        phi_683_ = _e401;
                    }
                    let _e404 = phi_683_;
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
                            phi_802_ = 255i;
                        } else {
                            phi_802_ = (((_e455 + select(0i, 1i, (_e455 == 0i))) - _e462) + _e442);
                        }
                        let _e470 = phi_802_;
                        let _e480 = (_e470 <= 0i);
                        if _e480 {
                            phi_825_ = u32();
                        } else {
                            if _e459 {
                                phi_824_ = u32();
                            } else {
                                phi_824_ = select(((bitcast<u32>(_e470) << bitcast<u32>(23i)) | ((_e452 << bitcast<u32>(((_e462 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e470 >= 255i));
                            }
                            let _e484 = phi_824_;
                            phi_825_ = _e484;
                        }
                        let _e486 = phi_825_;
                        let _e498 = ((_e158 & 8388607u) | (select(0u, 1u, ((_e158 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e501 = bitcast<i32>((_e158 >> bitcast<u32>(23i)));
                        let _e505 = (_e498 == 0u);
                        let _e508 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e498)), 32u, _e505)) - 8i);
                        if (_e501 == 255i) {
                            phi_862_ = 255i;
                        } else {
                            phi_862_ = (((_e501 + select(0i, 1i, (_e501 == 0i))) - _e508) + _e442);
                        }
                        let _e516 = phi_862_;
                        let _e526 = (_e516 <= 0i);
                        if _e526 {
                            phi_885_ = u32();
                        } else {
                            if _e505 {
                                phi_884_ = u32();
                            } else {
                                phi_884_ = select(((bitcast<u32>(_e516) << bitcast<u32>(23i)) | ((_e498 << bitcast<u32>(((_e508 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e516 >= 255i));
                            }
                            let _e530 = phi_884_;
                            phi_885_ = _e530;
                        }
                        let _e532 = phi_885_;
                        phi_893_ = bitcast<f32>(((_e157 & 2147483648u) | select(_e532, 0u, select(_e505, true, _e526))));
                        phi_894_ = bitcast<f32>(((_e148 & 2147483648u) | select(_e486, 0u, select(_e459, true, _e480))));
                    } else {
                        phi_893_ = 0f;
                        phi_894_ = 1f;
                    }
                    let _e538 = phi_893_;
                    let _e540 = phi_894_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2643_ = false;
                    phi_909_ = type_47(_e538, false);
                    phi_912_ = ((3u * _e72) + 1u);
                    phi_914_ = (_e540 <= _e538);
                    phi_916_ = 0u;
                    phi_918_ = select(0u, 2147483648u, (_e72 == 0u));
                    loop {
                        let _e548 = phi_2643_;
                        let _e550 = phi_909_;
                        let _e552 = phi_912_;
                        let _e554 = phi_914_;
                        let _e556 = phi_916_;
                        let _e558 = phi_918_;
                        local_2 = _e550;
                        if _e554 {
                            phi_929_ = true;
                        } else {
                            phi_929_ = (_e556 > 0u);
                        }
                        let _e561 = phi_929_;
                        if _e561 {
                            let _e562 = (_e552 > 0u);
                            if _e562 {
                                if _e554 {
                                    phi_961_ = _e554;
                                    phi_962_ = _e556;
                                    phi_963_ = _e558;
                                } else {
                                    let _e563 = (_e556 - 1u);
                                    let _e564 = (_e563 % 128u);
                                    let _e565 = (_e564 < 128u);
                                    if _e565 {
                                    } else {
                                        phi_2799_ = true;
                                        break;
                                    }
                                    let _e567 = local_1[_e564];
                                    if _e565 {
                                    } else {
                                        phi_2799_ = true;
                                        break;
                                    }
                                    let _e569 = local[_e564];
                                    phi_961_ = (_e569 <= _e550.member);
                                    phi_962_ = _e563;
                                    phi_963_ = _e567;
                                }
                                let _e573 = phi_961_;
                                let _e575 = phi_962_;
                                let _e577 = phi_963_;
                                if _e573 {
                                    let _e580 = ((_e577 & 2147483648u) != 0u);
                                    if _e580 {
                                        phi_978_ = _e550;
                                        phi_981_ = type_7(0u, ((_e577 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e587 = phi_978_;
                                            let _e589 = phi_981_;
                                            local_3 = _e587;
                                            if (_e589.member < _e589.member_1) {
                                                phi_982_ = type_7((_e589.member + 1u), _e589.member_1);
                                                phi_1004_ = type_7(1u, _e589.member);
                                            } else {
                                                phi_982_ = _e589;
                                                phi_1004_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e602 = phi_982_;
                                            let _e604 = phi_1004_;
                                            let _e608 = (bitcast<i32>(_e604.member) != 0i);
                                            if _e608 {
                                                let _e609 = ((_e577 & 268435455u) + _e604.member_1);
                                                let _e610 = (_e609 < _e74);
                                                if _e610 {
                                                    if _e610 {
                                                    } else {
                                                        phi_2637_ = true;
                                                        break;
                                                    }
                                                    let _e614 = global_3.member[_e609].member_1;
                                                    phi_1025_ = _e614;
                                                } else {
                                                    phi_1025_ = 4294967295u;
                                                }
                                                let _e616 = phi_1025_;
                                                if (_e609 >= _e74) {
                                                    phi_1117_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e610 {
                                                    } else {
                                                        phi_2637_ = true;
                                                        break;
                                                    }
                                                    let _e618 = (_e200 % 3u);
                                                    let _e619 = (_e199 % 3u);
                                                    let _e620 = (_e201 % 3u);
                                                    if (_e618 < 9u) {
                                                    } else {
                                                        phi_2637_ = true;
                                                        break;
                                                    }
                                                    let _e626 = global_3.member[_e609].member[_e618];
                                                    if (_e619 < 9u) {
                                                    } else {
                                                        phi_2637_ = true;
                                                        break;
                                                    }
                                                    let _e632 = global_3.member[_e609].member[_e619];
                                                    if (_e620 < 9u) {
                                                    } else {
                                                        phi_2637_ = true;
                                                        break;
                                                    }
                                                    let _e638 = global_3.member[_e609].member[_e620];
                                                    let _e640 = (3u + _e618);
                                                    if (_e640 < 9u) {
                                                    } else {
                                                        phi_2637_ = true;
                                                        break;
                                                    }
                                                    let _e646 = global_3.member[_e609].member[_e640];
                                                    let _e647 = (3u + _e619);
                                                    if (_e647 < 9u) {
                                                    } else {
                                                        phi_2637_ = true;
                                                        break;
                                                    }
                                                    let _e653 = global_3.member[_e609].member[_e647];
                                                    let _e654 = (3u + _e620);
                                                    if (_e654 < 9u) {
                                                    } else {
                                                        phi_2637_ = true;
                                                        break;
                                                    }
                                                    let _e660 = global_3.member[_e609].member[_e654];
                                                    let _e662 = (6u + _e618);
                                                    if (_e662 < 9u) {
                                                    } else {
                                                        phi_2637_ = true;
                                                        break;
                                                    }
                                                    let _e668 = global_3.member[_e609].member[_e662];
                                                    let _e669 = (6u + _e619);
                                                    if (_e669 < 9u) {
                                                    } else {
                                                        phi_2637_ = true;
                                                        break;
                                                    }
                                                    let _e675 = global_3.member[_e609].member[_e669];
                                                    let _e676 = (6u + _e620);
                                                    if (_e676 < 9u) {
                                                    } else {
                                                        phi_2637_ = true;
                                                        break;
                                                    }
                                                    let _e682 = global_3.member[_e609].member[_e676];
                                                    phi_1117_ = array<array<f32, 3>, 3>(array<f32, 3>(_e626, _e632, _e638), array<f32, 3>(_e646, _e653, _e660), array<f32, 3>(_e668, _e675, _e682));
                                                }
                                                let _e686 = phi_1117_;
                                                let _e702 = (_e686[0][2] - _e397);
                                                let _e705 = (((_e686[0][0] - _e264) * _e433) - (_e702 * _e301));
                                                let _e708 = (((_e686[0][1] - _e331) * _e433) - (_e702 * _e367));
                                                let _e711 = (_e686[1][2] - _e397);
                                                let _e714 = (((_e686[1][0] - _e264) * _e433) - (_e711 * _e301));
                                                let _e717 = (((_e686[1][1] - _e331) * _e433) - (_e711 * _e367));
                                                let _e720 = (_e686[2][2] - _e397);
                                                let _e723 = (((_e686[2][0] - _e264) * _e433) - (_e720 * _e301));
                                                let _e726 = (((_e686[2][1] - _e331) * _e433) - (_e720 * _e367));
                                                let _e727 = (_e723 * _e717);
                                                let _e728 = (_e726 * _e714);
                                                let _e729 = (_e705 * _e726);
                                                let _e730 = (_e708 * _e723);
                                                let _e731 = (_e714 * _e708);
                                                let _e732 = (_e717 * _e705);
                                                let _e737 = (((_e727 >= _e728) && (_e729 >= _e730)) && (_e731 >= _e732));
                                                let _e743 = (_e737 || (((_e727 <= _e728) && (_e729 <= _e730)) && (_e731 <= _e732)));
                                                if _e743 {
                                                    let _e745 = select(-1f, 1f, _e737);
                                                    let _e747 = ((_e727 - _e728) * _e745);
                                                    let _e749 = select(0f, _e747, (_e747 > 0f));
                                                    let _e751 = ((_e729 - _e730) * _e745);
                                                    let _e753 = select(0f, _e751, (_e751 > 0f));
                                                    let _e755 = ((_e731 - _e732) * _e745);
                                                    let _e757 = select(0f, _e755, (_e755 > 0f));
                                                    let _e759 = ((_e749 + _e753) + _e757);
                                                    let _e761 = select(_e686[1][0], _e686[0][0], (_e686[0][0] < _e686[1][0]));
                                                    let _e765 = select(_e686[1][0], _e686[0][0], (_e686[0][0] > _e686[1][0]));
                                                    let _e769 = select(_e686[1][1], _e686[0][1], (_e686[0][1] < _e686[1][1]));
                                                    let _e773 = select(_e686[1][1], _e686[0][1], (_e686[0][1] > _e686[1][1]));
                                                    let _e777 = select(_e686[1][2], _e686[0][2], (_e686[0][2] < _e686[1][2]));
                                                    let _e781 = select(_e686[1][2], _e686[0][2], (_e686[0][2] > _e686[1][2]));
                                                    let _e786 = ((select(_e686[2][0], _e761, (_e761 < _e686[2][0])) - _e302) * _e305);
                                                    let _e787 = ((select(_e686[2][0], _e765, (_e765 > _e686[2][0])) - _e303) * _e305);
                                                    let _e790 = ((select(_e686[2][1], _e769, (_e769 < _e686[2][1])) - _e368) * _e371);
                                                    let _e791 = ((select(_e686[2][1], _e773, (_e773 > _e686[2][1])) - _e369) * _e371);
                                                    let _e794 = ((select(_e686[2][2], _e777, (_e777 < _e686[2][2])) - _e434) * _e437);
                                                    let _e795 = ((select(_e686[2][2], _e781, (_e781 > _e686[2][2])) - _e435) * _e437);
                                                    let _e797 = select(_e795, _e794, (_e794 < _e795));
                                                    let _e799 = select(_e795, _e794, (_e794 > _e795));
                                                    let _e801 = select(_e787, _e786, (_e786 < _e787));
                                                    let _e803 = select(_e791, _e790, (_e790 < _e791));
                                                    let _e805 = select(_e803, _e801, (_e801 > _e803));
                                                    let _e807 = select(_e797, _e805, (_e805 > _e797));
                                                    let _e809 = select(_e787, _e786, (_e786 > _e787));
                                                    let _e811 = select(_e791, _e790, (_e790 > _e791));
                                                    let _e813 = select(_e811, _e809, (_e809 < _e811));
                                                    let _e815 = select(_e799, _e813, (_e813 < _e799));
                                                    let _e816 = -(_e797);
                                                    let _e822 = select(_e540, _e807, (_e807 > _e540));
                                                    let _e826 = select(_e714, _e705, (_e705 < _e714));
                                                    let _e831 = select(_e714, _e705, (_e705 > _e714));
                                                    let _e838 = select(_e717, _e708, (_e708 < _e717));
                                                    let _e843 = select(_e717, _e708, (_e708 > _e717));
                                                    let _e852 = (((((_e743 && (_e759 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e723, _e826, (_e826 < _e723)) <= 0f) && (select(_e723, _e831, (_e831 > _e723)) >= 0f))) && ((select(_e726, _e838, (_e838 < _e726)) <= 0f) && (select(_e726, _e843, (_e843 > _e726)) >= 0f))) && (_e822 <= (_e815 + (select(_e816, _e799, (_e799 > _e816)) * 0.0000019073523f)))) && (_e822 <= _e587.member));
                                                    if _e852 {
                                                        let _e857 = (_e686[1][0] - _e686[0][0]);
                                                        let _e858 = (_e686[1][1] - _e686[0][1]);
                                                        let _e859 = (_e686[1][2] - _e686[0][2]);
                                                        let _e860 = vec3<f32>(_e857, _e858, _e859);
                                                        let _e861 = (_e686[2][0] - _e686[1][0]);
                                                        let _e862 = (_e686[2][1] - _e686[1][1]);
                                                        let _e863 = (_e686[2][2] - _e686[1][2]);
                                                        let _e864 = vec3<f32>(_e861, _e862, _e863);
                                                        let _e865 = (_e686[0][0] - _e686[2][0]);
                                                        let _e866 = (_e686[0][1] - _e686[2][1]);
                                                        let _e867 = (_e686[0][2] - _e686[2][2]);
                                                        let _e868 = vec3<f32>(_e865, _e866, _e867);
                                                        let _e869 = abs(_e857);
                                                        let _e870 = abs(_e858);
                                                        if (_e869 != _e869) {
                                                            phi_2463_ = true;
                                                        } else {
                                                            phi_2463_ = (_e870 >= _e869);
                                                        }
                                                        let _e874 = phi_2463_;
                                                        let _e875 = select(_e869, _e870, _e874);
                                                        let _e876 = abs(_e859);
                                                        if (_e875 != _e875) {
                                                            phi_2478_ = true;
                                                        } else {
                                                            phi_2478_ = (_e876 >= _e875);
                                                        }
                                                        let _e880 = phi_2478_;
                                                        let _e881 = select(_e875, _e876, _e880);
                                                        let _e882 = abs(_e861);
                                                        let _e883 = abs(_e862);
                                                        if (_e882 != _e882) {
                                                            phi_2493_ = true;
                                                        } else {
                                                            phi_2493_ = (_e883 >= _e882);
                                                        }
                                                        let _e887 = phi_2493_;
                                                        let _e888 = select(_e882, _e883, _e887);
                                                        let _e889 = abs(_e863);
                                                        if (_e888 != _e888) {
                                                            phi_2508_ = true;
                                                        } else {
                                                            phi_2508_ = (_e889 >= _e888);
                                                        }
                                                        let _e893 = phi_2508_;
                                                        let _e894 = select(_e888, _e889, _e893);
                                                        let _e895 = abs(_e865);
                                                        let _e896 = abs(_e866);
                                                        if (_e895 != _e895) {
                                                            phi_2523_ = true;
                                                        } else {
                                                            phi_2523_ = (_e896 >= _e895);
                                                        }
                                                        let _e900 = phi_2523_;
                                                        let _e901 = select(_e895, _e896, _e900);
                                                        let _e902 = abs(_e867);
                                                        if (_e901 != _e901) {
                                                            phi_2538_ = true;
                                                        } else {
                                                            phi_2538_ = (_e902 >= _e901);
                                                        }
                                                        let _e906 = phi_2538_;
                                                        let _e907 = select(_e901, _e902, _e906);
                                                        let _e909 = select(_e894, _e881, (_e881 > _e894));
                                                        let _e911 = select(_e907, _e909, (_e909 > _e907));
                                                        if (_e881 == _e911) {
                                                            phi_1659_ = _e717;
                                                            phi_1660_ = _e714;
                                                            phi_1661_ = _e708;
                                                            phi_1662_ = _e705;
                                                            phi_1663_ = vec3<f32>(_e686[0][0], _e686[0][1], _e686[0][2]);
                                                            phi_1664_ = _e868;
                                                            phi_1665_ = _e864;
                                                            phi_1666_ = _e860;
                                                        } else {
                                                            let _e913 = (_e894 == _e911);
                                                            let _e918 = vec3(_e913);
                                                            phi_1659_ = select(_e708, _e726, _e913);
                                                            phi_1660_ = select(_e705, _e723, _e913);
                                                            phi_1661_ = select(_e726, _e717, _e913);
                                                            phi_1662_ = select(_e723, _e714, _e913);
                                                            phi_1663_ = select(vec3<f32>(_e686[2][0], _e686[2][1], _e686[2][2]), vec3<f32>(_e686[1][0], _e686[1][1], _e686[1][2]), _e918);
                                                            phi_1664_ = select(_e864, _e860, _e918);
                                                            phi_1665_ = select(_e860, _e868, _e918);
                                                            phi_1666_ = select(_e868, _e864, _e918);
                                                        }
                                                        let _e924 = phi_1659_;
                                                        let _e926 = phi_1660_;
                                                        let _e928 = phi_1661_;
                                                        let _e930 = phi_1662_;
                                                        let _e932 = phi_1663_;
                                                        let _e934 = phi_1664_;
                                                        let _e936 = phi_1665_;
                                                        let _e938 = phi_1666_;
                                                        let _e945 = ((_e936.y * _e934.z) - (_e934.y * _e936.z));
                                                        let _e950 = ((_e936.z * _e934.x) - (_e934.z * _e936.x));
                                                        let _e953 = ((_e936.x * _e934.y) - (_e934.x * _e936.y));
                                                        let _e956 = ((_e749 >= _e753) && (_e749 >= _e757));
                                                        let _e957 = (_e753 >= _e757);
                                                        let _e971 = (((_e945 * (select(select(_e686[2][0], _e686[1][0], _e957), _e686[0][0], _e956) - _e264)) + (_e950 * (select(select(_e686[2][1], _e686[1][1], _e957), _e686[0][1], _e956) - _e331))) + (_e953 * (select(select(_e686[2][2], _e686[1][2], _e957), _e686[0][2], _e956) - _e397)));
                                                        let _e976 = (((_e945 * _e301) + (_e950 * _e367)) + (_e953 * _e433));
                                                        let _e977 = (_e926 - _e930);
                                                        let _e978 = (_e924 - _e928);
                                                        let _e981 = ((_e977 * _e977) + (_e978 * _e978));
                                                        let _e988 = (-(((_e930 * _e977) + (_e928 * _e978))) / select(0.000000000000000000000000000000000000011754944f, _e981, (_e981 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e990 = select(1f, _e988, (_e988 < 1f));
                                                        let _e992 = select(0f, _e990, (_e990 > 0f));
                                                        let _e1001 = ((_e932.x + (_e938.x * _e992)) - _e264);
                                                        let _e1004 = ((_e932.y + (_e938.y * _e992)) - _e331);
                                                        let _e1007 = ((_e932.z + (_e938.z * _e992)) - _e397);
                                                        let _e1010 = bitcast<f32>((bitcast<u32>(_e1001) & 2147483647u));
                                                        let _e1013 = bitcast<f32>((bitcast<u32>(_e1004) & 2147483647u));
                                                        let _e1015 = select(_e1013, _e1010, (_e1010 > _e1013));
                                                        let _e1018 = bitcast<f32>((bitcast<u32>(_e1007) & 2147483647u));
                                                        let _e1020 = select(_e1018, _e1015, (_e1015 > _e1018));
                                                        let _e1024 = abs(_e945);
                                                        let _e1025 = abs(_e950);
                                                        if (_e1024 != _e1024) {
                                                            phi_2553_ = true;
                                                        } else {
                                                            phi_2553_ = (_e1025 >= _e1024);
                                                        }
                                                        let _e1029 = phi_2553_;
                                                        let _e1030 = select(_e1024, _e1025, _e1029);
                                                        let _e1031 = abs(_e953);
                                                        if (_e1030 != _e1030) {
                                                            phi_2568_ = true;
                                                        } else {
                                                            phi_2568_ = (_e1031 >= _e1030);
                                                        }
                                                        let _e1035 = phi_2568_;
                                                        let _e1051 = abs(_e936.x);
                                                        let _e1052 = abs(_e936.y);
                                                        if (_e1051 != _e1051) {
                                                            phi_2583_ = true;
                                                        } else {
                                                            phi_2583_ = (_e1052 >= _e1051);
                                                        }
                                                        let _e1056 = phi_2583_;
                                                        let _e1057 = select(_e1051, _e1052, _e1056);
                                                        let _e1058 = abs(_e936.z);
                                                        if (_e1057 != _e1057) {
                                                            phi_2598_ = true;
                                                        } else {
                                                            phi_2598_ = (_e1058 >= _e1057);
                                                        }
                                                        let _e1062 = phi_2598_;
                                                        let _e1065 = abs(_e934.x);
                                                        let _e1066 = abs(_e934.y);
                                                        if (_e1065 != _e1065) {
                                                            phi_2613_ = true;
                                                        } else {
                                                            phi_2613_ = (_e1066 >= _e1065);
                                                        }
                                                        let _e1070 = phi_2613_;
                                                        let _e1071 = select(_e1065, _e1066, _e1070);
                                                        let _e1072 = abs(_e934.z);
                                                        if (_e1071 != _e1071) {
                                                            phi_2628_ = true;
                                                        } else {
                                                            phi_2628_ = (_e1072 >= _e1071);
                                                        }
                                                        let _e1076 = phi_2628_;
                                                        let _e1081 = ((bitcast<f32>((bitcast<u32>(((((_e945 * _e1001) + (_e950 * _e1004)) + (_e953 * _e1007)) - _e971)) & 2147483647u)) <= ((0.0000009536743f * select(_e911, _e1020, (_e1020 > _e911))) * select(_e1030, _e1031, _e1035))) && !((bitcast<f32>((bitcast<u32>(_e976) & 2147483647u)) <= ((0.0000038146973f * select(_e1057, _e1058, _e1062)) * select(_e1071, _e1072, _e1076)))));
                                                        let _e1082 = (_e971 / _e976);
                                                        if (_e852 && !(_e1081)) {
                                                            let _e1085 = (_e1007 / _e433);
                                                            let _e1093 = (((_e945 * (_e1001 - (_e301 * _e1085))) + (_e950 * (_e1004 - (_e367 * _e1085)))) / _e976);
                                                            phi_1874_ = select(select(_e1085, (_e1085 + _e1093), (bitcast<f32>((bitcast<u32>(_e1093) & 2147483647u)) <= _e911)), _e1082, _e1081);
                                                        } else {
                                                            phi_1874_ = _e1082;
                                                        }
                                                        let _e1102 = phi_1874_;
                                                        let _e1104 = select(_e815, _e1102, (_e1102 < _e815));
                                                        let _e1106 = select(_e807, _e1104, (_e1104 > _e807));
                                                        let _e1107 = (1f / _e759);
                                                        phi_1894_ = type_42(_e1106, (_e753 * _e1107), (_e757 * _e1107), ((_e852 && (_e1106 >= _e540)) && (_e1106 <= _e587.member)));
                                                        phi_1895_ = type_42();
                                                    } else {
                                                        phi_1894_ = type_42();
                                                        phi_1895_ = type_42(0f, 0f, 0f, _e852);
                                                    }
                                                    let _e1116 = phi_1894_;
                                                    let _e1118 = phi_1895_;
                                                    phi_1898_ = _e1116;
                                                    phi_1899_ = _e1118;
                                                    phi_1900_ = select(true, false, _e852);
                                                } else {
                                                    phi_1898_ = type_42();
                                                    phi_1899_ = type_42(0f, 0f, 0f, _e743);
                                                    phi_1900_ = true;
                                                }
                                                let _e1121 = phi_1898_;
                                                let _e1123 = phi_1899_;
                                                let _e1125 = phi_1900_;
                                                if _e1125 {
                                                    phi_1904_ = _e1123;
                                                } else {
                                                    phi_1904_ = _e1121;
                                                }
                                                let _e1127 = phi_1904_;
                                                if _e1127.member_3 {
                                                    phi_1913_ = type_26(_e1127.member, _e1127.member_1, _e1127.member_2, _e616);
                                                } else {
                                                    phi_1913_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1134 = phi_1913_;
                                                if (_e1134.member_3 != 4294967295u) {
                                                    if (_e616 != 4294967295u) {
                                                        phi_1924_ = type_47(-340282350000000000000000000000000000000f, true);
                                                    } else {
                                                        phi_1924_ = _e587;
                                                    }
                                                    let _e1139 = phi_1924_;
                                                    phi_1925_ = _e1139;
                                                } else {
                                                    phi_1925_ = _e587;
                                                }
                                                let _e1141 = phi_1925_;
                                                phi_979_ = _e1141;
                                            } else {
                                                phi_979_ = type_47();
                                            }
                                            let _e1143 = phi_979_;
                                            continue;
                                            continuing {
                                                phi_978_ = _e1143;
                                                phi_981_ = _e602;
                                                phi_2637_ = _e548;
                                                break if !(_e608);
                                            }
                                        }
                                        let _e1146 = phi_2637_;
                                        phi_2799_ = _e1146;
                                        if _e1146 {
                                            break;
                                        }
                                        phi_2834_ = _e1146;
                                        let _e1477 = local_3;
                                        phi_1926_ = _e1477;
                                    } else {
                                        phi_2834_ = _e548;
                                        phi_1926_ = _e550;
                                    }
                                    let _e1148 = phi_2834_;
                                    let _e1150 = phi_1926_;
                                    if _e580 {
                                        phi_2406_ = bool();
                                        phi_2407_ = u32();
                                        phi_2408_ = u32();
                                    } else {
                                        if (_e577 >= _e72) {
                                            phi_1991_ = type_43(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e577 < _e72) {
                                            } else {
                                                phi_2799_ = true;
                                                break;
                                            }
                                            let _e1153 = (_e200 % 3u);
                                            if (_e1153 < 3u) {
                                            } else {
                                                phi_2799_ = true;
                                                break;
                                            }
                                            let _e1159 = global_2.member[_e577].member[_e1153];
                                            let _e1165 = (_e199 % 3u);
                                            if (_e1165 < 3u) {
                                            } else {
                                                phi_2799_ = true;
                                                break;
                                            }
                                            let _e1171 = global_2.member[_e577].member[_e1165];
                                            let _e1177 = (_e201 % 3u);
                                            if (_e1177 < 3u) {
                                            } else {
                                                phi_2799_ = true;
                                                break;
                                            }
                                            let _e1183 = global_2.member[_e577].member[_e1177];
                                            let _e1193 = global_2.member[_e577].member_1;
                                            let _e1197 = global_2.member[_e577].member_2;
                                            phi_1991_ = type_43(array<vec4<f32>, 3>(vec4<f32>(_e1159[0], _e1159[1], _e1159[2], _e1159[3]), vec4<f32>(_e1171[0], _e1171[1], _e1171[2], _e1171[3]), vec4<f32>(_e1183[0], _e1183[1], _e1183[2], _e1183[3])), _e1193, _e1197);
                                        }
                                        let _e1200 = phi_1991_;
                                        let _e1212 = ((_e1200.member[0].x - _e302) * _e305);
                                        let _e1213 = ((_e1200.member[0].y - _e302) * _e305);
                                        let _e1214 = ((_e1200.member[0].z - _e303) * _e305);
                                        let _e1215 = ((_e1200.member[0].w - _e303) * _e305);
                                        let _e1225 = ((_e1200.member[1].x - _e368) * _e371);
                                        let _e1226 = ((_e1200.member[1].y - _e368) * _e371);
                                        let _e1227 = ((_e1200.member[1].z - _e369) * _e371);
                                        let _e1228 = ((_e1200.member[1].w - _e369) * _e371);
                                        let _e1238 = ((_e1200.member[2].x - _e434) * _e437);
                                        let _e1239 = ((_e1200.member[2].y - _e434) * _e437);
                                        let _e1240 = ((_e1200.member[2].z - _e435) * _e437);
                                        let _e1241 = ((_e1200.member[2].w - _e435) * _e437);
                                        let _e1243 = select(_e1240, _e1238, (_e1238 < _e1240));
                                        let _e1245 = select(_e1241, _e1239, (_e1239 < _e1241));
                                        let _e1247 = select(_e1240, _e1238, (_e1238 > _e1240));
                                        let _e1249 = select(_e1241, _e1239, (_e1239 > _e1241));
                                        let _e1251 = select(_e1214, _e1212, (_e1212 < _e1214));
                                        let _e1253 = select(_e1215, _e1213, (_e1213 < _e1215));
                                        let _e1255 = select(_e1227, _e1225, (_e1225 < _e1227));
                                        let _e1257 = select(_e1228, _e1226, (_e1226 < _e1228));
                                        let _e1259 = select(_e1255, _e1251, (_e1251 > _e1255));
                                        let _e1261 = select(_e1257, _e1253, (_e1253 > _e1257));
                                        let _e1263 = select(_e1243, _e1259, (_e1259 > _e1243));
                                        let _e1265 = select(_e1245, _e1261, (_e1261 > _e1245));
                                        let _e1267 = select(_e1214, _e1212, (_e1212 > _e1214));
                                        let _e1269 = select(_e1215, _e1213, (_e1213 > _e1215));
                                        let _e1271 = select(_e1227, _e1225, (_e1225 > _e1227));
                                        let _e1273 = select(_e1228, _e1226, (_e1226 > _e1228));
                                        let _e1275 = select(_e1271, _e1267, (_e1267 < _e1271));
                                        let _e1277 = select(_e1273, _e1269, (_e1269 < _e1273));
                                        let _e1282 = -(_e1243);
                                        let _e1283 = -(_e1245);
                                        let _e1290 = (select(_e1247, _e1275, (_e1275 < _e1247)) + (select(_e1282, _e1247, (_e1247 > _e1282)) * 0.0000019073523f));
                                        let _e1291 = (select(_e1249, _e1277, (_e1277 < _e1249)) + (select(_e1283, _e1249, (_e1249 > _e1283)) * 0.0000019073523f));
                                        let _e1293 = select(_e540, _e1263, (_e1263 > _e540));
                                        let _e1295 = select(_e540, _e1265, (_e1265 > _e540));
                                        let _e1300 = (_e1293 <= select(_e1150.member, _e1290, (_e1290 < _e1150.member)));
                                        let _e1301 = (_e1295 <= select(_e1150.member, _e1291, (_e1291 < _e1150.member)));
                                        let _e1302 = (_e1293 <= _e1295);
                                        if _e1300 {
                                            if _e1301 {
                                                if _e1302 {
                                                    phi_2353_ = _e1200.member_2;
                                                } else {
                                                    phi_2353_ = _e1200.member_1;
                                                }
                                                let _e1306 = phi_2353_;
                                                let _e1308 = (_e575 % 128u);
                                                let _e1309 = (_e1308 < 128u);
                                                if _e1309 {
                                                } else {
                                                    phi_2799_ = true;
                                                    break;
                                                }
                                                local_1[_e1308] = _e1306;
                                                if _e1309 {
                                                } else {
                                                    phi_2799_ = true;
                                                    break;
                                                }
                                                local[_e1308] = select(_e1293, _e1295, _e1302);
                                                if _e1302 {
                                                    phi_2380_ = _e1200.member_1;
                                                } else {
                                                    phi_2380_ = _e1200.member_2;
                                                }
                                                let _e1316 = phi_2380_;
                                                phi_2381_ = (_e575 + 1u);
                                                phi_2382_ = _e1316;
                                            } else {
                                                phi_2381_ = u32();
                                                phi_2382_ = u32();
                                            }
                                            let _e1318 = phi_2381_;
                                            let _e1320 = phi_2382_;
                                            phi_2384_ = _e1318;
                                            phi_2385_ = _e1320;
                                            phi_2386_ = select(true, false, _e1301);
                                        } else {
                                            phi_2384_ = u32();
                                            phi_2385_ = u32();
                                            phi_2386_ = true;
                                        }
                                        let _e1323 = phi_2384_;
                                        let _e1325 = phi_2385_;
                                        let _e1327 = phi_2386_;
                                        if _e1327 {
                                            if _e1300 {
                                                phi_2395_ = _e1200.member_1;
                                            } else {
                                                phi_2395_ = _e1200.member_2;
                                            }
                                            let _e1331 = phi_2395_;
                                            phi_2400_ = select(_e1301, true, _e1300);
                                            phi_2402_ = _e1331;
                                        } else {
                                            phi_2400_ = _e573;
                                            phi_2402_ = _e1325;
                                        }
                                        let _e1334 = phi_2400_;
                                        let _e1336 = phi_2402_;
                                        phi_2406_ = _e1334;
                                        phi_2407_ = select(_e1323, _e575, _e1327);
                                        phi_2408_ = _e1336;
                                    }
                                    let _e1339 = phi_2406_;
                                    let _e1341 = phi_2407_;
                                    let _e1343 = phi_2408_;
                                    if _e580 {
                                        phi_2418_ = select(_e575, 0u, _e1150.member_1);
                                    } else {
                                        phi_2418_ = _e1341;
                                    }
                                    let _e1347 = phi_2418_;
                                    phi_2802_ = _e1148;
                                    phi_2420_ = _e1150;
                                    phi_2421_ = (_e552 - 1u);
                                    phi_2422_ = select(_e1339, false, _e580);
                                    phi_2423_ = _e1347;
                                    phi_2424_ = select(_e1343, _e577, _e580);
                                } else {
                                    phi_2802_ = _e548;
                                    phi_2420_ = _e550;
                                    phi_2421_ = _e552;
                                    phi_2422_ = _e573;
                                    phi_2423_ = _e575;
                                    phi_2424_ = _e577;
                                }
                                let _e1351 = phi_2802_;
                                let _e1353 = phi_2420_;
                                let _e1355 = phi_2421_;
                                let _e1357 = phi_2422_;
                                let _e1359 = phi_2423_;
                                let _e1361 = phi_2424_;
                                phi_2801_ = _e1351;
                                phi_2425_ = _e1353;
                                phi_2426_ = _e1355;
                                phi_2427_ = _e1357;
                                phi_2428_ = _e1359;
                                phi_2429_ = _e1361;
                            } else {
                                phi_2801_ = _e548;
                                phi_2425_ = type_47();
                                phi_2426_ = u32();
                                phi_2427_ = bool();
                                phi_2428_ = u32();
                                phi_2429_ = u32();
                            }
                            let _e1363 = phi_2801_;
                            let _e1365 = phi_2425_;
                            let _e1367 = phi_2426_;
                            let _e1369 = phi_2427_;
                            let _e1371 = phi_2428_;
                            let _e1373 = phi_2429_;
                            phi_2800_ = _e1363;
                            phi_910_ = _e1365;
                            phi_913_ = _e1367;
                            phi_915_ = _e1369;
                            phi_917_ = _e1371;
                            phi_919_ = _e1373;
                            phi_2430_ = _e562;
                        } else {
                            phi_2800_ = _e548;
                            phi_910_ = type_47();
                            phi_913_ = u32();
                            phi_915_ = bool();
                            phi_917_ = u32();
                            phi_919_ = u32();
                            phi_2430_ = false;
                        }
                        let _e1375 = phi_2800_;
                        let _e1377 = phi_910_;
                        let _e1379 = phi_913_;
                        let _e1381 = phi_915_;
                        let _e1383 = phi_917_;
                        let _e1385 = phi_919_;
                        let _e1387 = phi_2430_;
                        continue;
                        continuing {
                            phi_2643_ = _e1375;
                            phi_909_ = _e1377;
                            phi_912_ = _e1379;
                            phi_914_ = _e1381;
                            phi_916_ = _e1383;
                            phi_918_ = _e1385;
                            phi_2799_ = _e1375;
                            break if !(_e1387);
                        }
                    }
                    let _e1390 = phi_2799_;
                    if _e1390 {
                        break;
                    }
                    let _e1392 = local_2;
                    if _e88 {
                    } else {
                        break;
                    }
                    global_5.member[_e82] = select(0u, 1u, _e1392.member_1);
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
