struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
}

struct type_16 {
    member: vec4<u32>,
}

struct type_21 {
    member: array<array<i32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_26 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_28 {
    member: array<type_26>,
}

struct type_32 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

struct type_36 {
    member: array<i32, 3>,
    member_1: u32,
}

struct type_38 {
    member: array<type_36>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_16;
@group(0) @binding(2) 
var<uniform> global_3: type_16;
@group(0) @binding(3) 
var<storage> global_4: type_23;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_13;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_38;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_4;
@group(0) @binding(7) 
var<storage, read_write> global_8: type_28;

fn function_() {
    var phi_164_: i32;
    var phi_165_: i32;
    var phi_207_: type_21;
    var phi_258_: type_8;
    var phi_261_: type_32;
    var phi_263_: u32;
    var phi_259_: type_8;
    var phi_286_: type_8;
    var phi_308_: type_21;
    var phi_317_: bool;
    var phi_361_: i32;
    var phi_376_: i32;
    var phi_413_: i32;
    var phi_428_: i32;
    var phi_465_: i32;
    var phi_480_: i32;
    var phi_489_: type_32;
    var phi_490_: u32;
    var phi_262_: type_32;
    var phi_264_: u32;
    var phi_492_: bool;
    var phi_1444_: bool;
    var local: type_32;
    var local_1: type_32;
    var phi_1145_: u32;
    var phi_1151_: u32;
    var phi_1162_: u32;
    var phi_1165_: type_8;
    var phi_1166_: type_8;
    var phi_1189_: type_8;
    var phi_1477_: bool;
    var phi_1296_: u32;
    var phi_1302_: u32;
    var phi_1313_: u32;
    var phi_1316_: type_8;
    var phi_1317_: type_8;
    var phi_1340_: type_8;
    var phi_1532_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e40 = global;
            let _e42 = arrayLength((&global_4.member));
            let _e47 = arrayLength((&global_6.member));
            let _e50 = arrayLength((&global_7.member));
            let _e53 = arrayLength((&global_8.member));
            let _e56 = global_3.member[1u];
            if (_e56 == 0u) {
                let _e74 = global_3.member[0u];
                phi_165_ = bitcast<i32>(_e74);
            } else {
                let _e60 = global_3.member[0u];
                let _e64 = global_2.member[0u];
                let _e66 = (bitcast<i32>(_e60) + bitcast<i32>(_e64));
                if (_e66 < -126i) {
                    phi_164_ = -126i;
                } else {
                    phi_164_ = select(_e66, 127i, (_e66 > 127i));
                }
                let _e71 = phi_164_;
                phi_165_ = _e71;
            }
            let _e77 = phi_165_;
            let _e81 = (_e40.x + (_e40.y * 2097152u));
            let _e84 = global_1.member[0u];
            if (_e81 < _e84) {
                let _e86 = (_e81 < _e42);
                if _e86 {
                    let _e87 = (_e81 < arrayLength((&global_5.member)));
                    if _e87 {
                        let _e88 = (0u < _e42);
                        if _e88 {
                            if _e88 {
                            } else {
                                break;
                            }
                            let _e91 = global_4.member[0u];
                            phi_207_ = _e91;
                        } else {
                            phi_207_ = type_21(array<array<i32, 4>, 3>(array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e93 = phi_207_;
                        phi_258_ = type_8(0u, 128u);
                        phi_261_ = type_32(array<i32, 3>(select(_e93.member[0][0], _e93.member[0][1], (_e93.member[0][1] < _e93.member[0][0])), select(_e93.member[1][0], _e93.member[1][1], (_e93.member[1][1] < _e93.member[1][0])), select(_e93.member[2][0], _e93.member[2][1], (_e93.member[2][1] < _e93.member[2][0]))), array<i32, 3>(select(_e93.member[0][3], _e93.member[0][2], (_e93.member[0][3] < _e93.member[0][2])), select(_e93.member[1][3], _e93.member[1][2], (_e93.member[1][3] < _e93.member[1][2])), select(_e93.member[2][3], _e93.member[2][2], (_e93.member[2][3] < _e93.member[2][2]))));
                        phi_263_ = 0u;
                        loop {
                            let _e128 = phi_258_;
                            let _e130 = phi_261_;
                            let _e132 = phi_263_;
                            local = _e130;
                            local_1 = _e130;
                            if (_e128.member < _e128.member_1) {
                                phi_259_ = type_8((_e128.member + 1u), _e128.member_1);
                                phi_286_ = type_8(1u, _e128.member);
                            } else {
                                phi_259_ = _e128;
                                phi_286_ = type_8(0u, type_8().member_1);
                            }
                            let _e145 = phi_259_;
                            let _e147 = phi_286_;
                            if (bitcast<i32>(_e147.member) != 0i) {
                                let _e151 = (_e132 == _e81);
                                if _e151 {
                                    phi_489_ = type_32();
                                    phi_490_ = u32();
                                } else {
                                    let _e152 = (_e132 < _e42);
                                    if _e152 {
                                        if _e152 {
                                        } else {
                                            phi_1444_ = true;
                                            break;
                                        }
                                        let _e155 = global_4.member[_e132];
                                        phi_308_ = _e155;
                                    } else {
                                        phi_308_ = type_21(array<array<i32, 4>, 3>(array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i), array<i32, 4>(0i, 0i, 0i, 0i)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e157 = phi_308_;
                                    if ((_e157.member_1 & 2147483648u) != 0u) {
                                        phi_317_ = false;
                                    } else {
                                        phi_317_ = (_e81 <= _e157.member_1);
                                    }
                                    let _e164 = phi_317_;
                                    let _e176 = bitcast<u32>((_e130.member_1[0] - _e130.member[0]));
                                    let _e182 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e176)), 32u, (_e176 == 0u)));
                                    let _e185 = (select(10u, _e182, (_e182 > 10u)) - 10u);
                                    let _e190 = (_e157.member[0][0] - _e130.member[0]);
                                    let _e191 = (_e157.member[0][1] - _e130.member[0]);
                                    let _e192 = (_e130.member_1[0] - _e157.member[0][2]);
                                    let _e193 = (_e130.member_1[0] - _e157.member[0][3]);
                                    let _e194 = (_e190 > _e191);
                                    if (_e194 == _e164) {
                                        let _e197 = (_e185 & 31u);
                                        phi_361_ = ((select(_e191, _e190, _e194) >> bitcast<u32>(_e197)) << bitcast<u32>(_e197));
                                    } else {
                                        phi_361_ = 0i;
                                    }
                                    let _e203 = phi_361_;
                                    let _e205 = (_e192 > _e193);
                                    if (_e205 == _e164) {
                                        let _e208 = (_e185 & 31u);
                                        phi_376_ = ((select(_e193, _e192, _e205) >> bitcast<u32>(_e208)) << bitcast<u32>(_e208));
                                    } else {
                                        phi_376_ = 0i;
                                    }
                                    let _e214 = phi_376_;
                                    let _e219 = bitcast<u32>((_e130.member_1[1] - _e130.member[1]));
                                    let _e225 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e219)), 32u, (_e219 == 0u)));
                                    let _e228 = (select(10u, _e225, (_e225 > 10u)) - 10u);
                                    let _e233 = (_e157.member[1][0] - _e130.member[1]);
                                    let _e234 = (_e157.member[1][1] - _e130.member[1]);
                                    let _e235 = (_e130.member_1[1] - _e157.member[1][2]);
                                    let _e236 = (_e130.member_1[1] - _e157.member[1][3]);
                                    let _e237 = (_e233 > _e234);
                                    if (_e237 == _e164) {
                                        let _e240 = (_e228 & 31u);
                                        phi_413_ = ((select(_e234, _e233, _e237) >> bitcast<u32>(_e240)) << bitcast<u32>(_e240));
                                    } else {
                                        phi_413_ = 0i;
                                    }
                                    let _e246 = phi_413_;
                                    let _e248 = (_e235 > _e236);
                                    if (_e248 == _e164) {
                                        let _e251 = (_e228 & 31u);
                                        phi_428_ = ((select(_e236, _e235, _e248) >> bitcast<u32>(_e251)) << bitcast<u32>(_e251));
                                    } else {
                                        phi_428_ = 0i;
                                    }
                                    let _e257 = phi_428_;
                                    let _e262 = bitcast<u32>((_e130.member_1[2] - _e130.member[2]));
                                    let _e268 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e262)), 32u, (_e262 == 0u)));
                                    let _e271 = (select(10u, _e268, (_e268 > 10u)) - 10u);
                                    let _e276 = (_e157.member[2][0] - _e130.member[2]);
                                    let _e277 = (_e157.member[2][1] - _e130.member[2]);
                                    let _e278 = (_e130.member_1[2] - _e157.member[2][2]);
                                    let _e279 = (_e130.member_1[2] - _e157.member[2][3]);
                                    let _e280 = (_e276 > _e277);
                                    if (_e280 == _e164) {
                                        let _e283 = (_e271 & 31u);
                                        phi_465_ = ((select(_e277, _e276, _e280) >> bitcast<u32>(_e283)) << bitcast<u32>(_e283));
                                    } else {
                                        phi_465_ = 0i;
                                    }
                                    let _e289 = phi_465_;
                                    let _e291 = (_e278 > _e279);
                                    if (_e291 == _e164) {
                                        let _e294 = (_e271 & 31u);
                                        phi_480_ = ((select(_e279, _e278, _e291) >> bitcast<u32>(_e294)) << bitcast<u32>(_e294));
                                    } else {
                                        phi_480_ = 0i;
                                    }
                                    let _e300 = phi_480_;
                                    phi_489_ = type_32(array<i32, 3>((_e130.member[0] + _e203), (_e130.member[1] + _e246), (_e130.member[2] + _e289)), array<i32, 3>((_e130.member_1[0] - _e214), (_e130.member_1[1] - _e257), (_e130.member_1[2] - _e300)));
                                    phi_490_ = select(_e157.member_2, _e157.member_1, _e164);
                                }
                                let _e307 = phi_489_;
                                let _e309 = phi_490_;
                                phi_262_ = _e307;
                                phi_264_ = _e309;
                                phi_492_ = select(true, false, _e151);
                            } else {
                                phi_262_ = type_32();
                                phi_264_ = u32();
                                phi_492_ = false;
                            }
                            let _e312 = phi_262_;
                            let _e314 = phi_264_;
                            let _e316 = phi_492_;
                            continue;
                            continuing {
                                phi_258_ = _e145;
                                phi_261_ = _e312;
                                phi_263_ = _e314;
                                phi_1444_ = false;
                                break if !(_e316);
                            }
                        }
                        let _e319 = phi_1444_;
                        if _e319 {
                            break;
                        }
                        if _e86 {
                        } else {
                            break;
                        }
                        let _e321 = local;
                        let _e324 = local_1;
                        let _e336 = global_4.member[_e81].member[0u];
                        let _e338 = bitcast<u32>((_e324.member_1[0] - _e321.member[0]));
                        let _e344 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e338)), 32u, (_e338 == 0u)));
                        let _e352 = (_e336[0] - _e321.member[0]);
                        let _e353 = (_e336[1] - _e321.member[0]);
                        let _e354 = (_e324.member_1[0] - _e336[2]);
                        let _e355 = (_e324.member_1[0] - _e336[3]);
                        let _e356 = (_e352 > _e353);
                        let _e359 = ((select(10u, _e344, (_e344 > 10u)) - 10u) & 31u);
                        let _e366 = (((bitcast<u32>(select(_e353, _e352, _e356)) >> bitcast<u32>(_e359)) & 1023u) | (select(0u, 1u, _e356) << bitcast<u32>(10u)));
                        let _e367 = (_e354 > _e355);
                        let _e376 = (((bitcast<u32>(select(_e355, _e354, _e367)) >> bitcast<u32>(_e359)) & 1023u) | (select(0u, 1u, _e367) << bitcast<u32>(10u)));
                        let _e381 = global_4.member[_e81].member[1u];
                        let _e383 = bitcast<u32>((_e324.member_1[1] - _e321.member[1]));
                        let _e389 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e383)), 32u, (_e383 == 0u)));
                        let _e397 = (_e381[0] - _e321.member[1]);
                        let _e398 = (_e381[1] - _e321.member[1]);
                        let _e399 = (_e324.member_1[1] - _e381[2]);
                        let _e400 = (_e324.member_1[1] - _e381[3]);
                        let _e401 = (_e397 > _e398);
                        let _e404 = ((select(10u, _e389, (_e389 > 10u)) - 10u) & 31u);
                        let _e411 = (((bitcast<u32>(select(_e398, _e397, _e401)) >> bitcast<u32>(_e404)) & 1023u) | (select(0u, 1u, _e401) << bitcast<u32>(10u)));
                        let _e412 = (_e399 > _e400);
                        let _e421 = (((bitcast<u32>(select(_e400, _e399, _e412)) >> bitcast<u32>(_e404)) & 1023u) | (select(0u, 1u, _e412) << bitcast<u32>(10u)));
                        let _e426 = global_4.member[_e81].member[2u];
                        let _e428 = bitcast<u32>((_e324.member_1[2] - _e321.member[2]));
                        let _e434 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e428)), 32u, (_e428 == 0u)));
                        let _e442 = (_e426[0] - _e321.member[2]);
                        let _e443 = (_e426[1] - _e321.member[2]);
                        let _e444 = (_e324.member_1[2] - _e426[2]);
                        let _e445 = (_e324.member_1[2] - _e426[3]);
                        let _e446 = (_e442 > _e443);
                        let _e449 = ((select(10u, _e434, (_e434 > 10u)) - 10u) & 31u);
                        let _e456 = (((bitcast<u32>(select(_e443, _e442, _e446)) >> bitcast<u32>(_e449)) & 1023u) | (select(0u, 1u, _e446) << bitcast<u32>(10u)));
                        let _e457 = (_e444 > _e445);
                        let _e466 = (((bitcast<u32>(select(_e445, _e444, _e457)) >> bitcast<u32>(_e449)) & 1023u) | (select(0u, 1u, _e457) << bitcast<u32>(10u)));
                        let _e480 = (_e321.member[0] + bitcast<i32>(((_e366 & 1023u) << bitcast<u32>(_e359))));
                        let _e485 = (_e324.member_1[0] - bitcast<i32>(((_e376 & 1023u) << bitcast<u32>(_e359))));
                        let _e489 = (((_e366 >> bitcast<u32>(10u)) & 1u) == 1u);
                        let _e493 = (((_e376 >> bitcast<u32>(10u)) & 1u) == 1u);
                        let _e494 = select(_e321.member[0], _e480, _e489);
                        let _e495 = select(_e480, _e321.member[0], _e489);
                        let _e502 = (_e321.member[1] + bitcast<i32>(((_e411 & 1023u) << bitcast<u32>(_e404))));
                        let _e507 = (_e324.member_1[1] - bitcast<i32>(((_e421 & 1023u) << bitcast<u32>(_e404))));
                        let _e511 = (((_e411 >> bitcast<u32>(10u)) & 1u) == 1u);
                        let _e515 = (((_e421 >> bitcast<u32>(10u)) & 1u) == 1u);
                        let _e516 = select(_e321.member[1], _e502, _e511);
                        let _e517 = select(_e502, _e321.member[1], _e511);
                        let _e524 = (_e321.member[2] + bitcast<i32>(((_e456 & 1023u) << bitcast<u32>(_e449))));
                        let _e529 = (_e324.member_1[2] - bitcast<i32>(((_e466 & 1023u) << bitcast<u32>(_e449))));
                        let _e533 = (((_e456 >> bitcast<u32>(10u)) & 1u) == 1u);
                        let _e537 = (((_e466 >> bitcast<u32>(10u)) & 1u) == 1u);
                        let _e538 = select(_e321.member[2], _e524, _e533);
                        let _e539 = select(_e524, _e321.member[2], _e533);
                        if _e87 {
                        } else {
                            break;
                        }
                        global_5.member[_e81] = array<u32, 4>(0u, (_e366 | (_e376 << bitcast<u32>(11u))), (_e411 | (_e421 << bitcast<u32>(11u))), (_e456 | (_e466 << bitcast<u32>(11u))));
                        if _e86 {
                        } else {
                            break;
                        }
                        let _e548 = global_4.member[_e81].member_1;
                        let _e557 = ((bitcast<u32>((select(_e324.member_1[0], _e485, _e493) - _e494)) | bitcast<u32>((select(_e324.member_1[1], _e507, _e515) - _e516))) | bitcast<u32>((select(_e324.member_1[2], _e529, _e537) - _e538)));
                        if (_e557 < 1024u) {
                            phi_1145_ = 0u;
                        } else {
                            phi_1145_ = select(2u, 1u, (_e557 < 2097152u));
                        }
                        let _e562 = phi_1145_;
                        switch bitcast<i32>(_e562) {
                            case 0: {
                                phi_1151_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_1151_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_1151_ = 3u;
                                break;
                            }
                            default: {
                                phi_1151_ = u32();
                                break;
                            }
                        }
                        let _e565 = phi_1151_;
                        let _e567 = ((3u * _e565) + 1u);
                        if ((_e548 & 2147483648u) != 0u) {
                            phi_1162_ = ((_e548 >> bitcast<u32>(28u)) & 7u);
                        } else {
                            phi_1162_ = 0u;
                        }
                        let _e575 = phi_1162_;
                        phi_1165_ = type_8(0u, _e575);
                        loop {
                            let _e578 = phi_1165_;
                            if (_e578.member < _e578.member_1) {
                                phi_1166_ = type_8((_e578.member + 1u), _e578.member_1);
                                phi_1189_ = type_8(1u, _e578.member);
                            } else {
                                phi_1166_ = _e578;
                                phi_1189_ = type_8(0u, type_8().member_1);
                            }
                            let _e591 = phi_1166_;
                            let _e593 = phi_1189_;
                            let _e597 = (bitcast<i32>(_e593.member) != 0i);
                            if _e597 {
                                let _e599 = ((_e548 & 268435455u) + _e593.member_1);
                                let _e600 = (_e599 < _e47);
                                if _e600 {
                                    let _e601 = (_e599 < _e50);
                                    if _e601 {
                                        if _e600 {
                                        } else {
                                            phi_1477_ = true;
                                            break;
                                        }
                                        global_6.member[_e599] = type_36(array<i32, 3>(_e494, _e516, _e538), _e567);
                                        if _e601 {
                                        } else {
                                            phi_1477_ = true;
                                            break;
                                        }
                                        global_7.member[_e599] = _e567;
                                    }
                                }
                            }
                            continue;
                            continuing {
                                phi_1165_ = _e591;
                                phi_1477_ = _e319;
                                break if !(_e597);
                            }
                        }
                        let _e606 = phi_1477_;
                        if _e606 {
                            break;
                        }
                        if _e86 {
                        } else {
                            break;
                        }
                        let _e610 = global_4.member[_e81].member_2;
                        let _e619 = ((bitcast<u32>((select(_e485, _e324.member_1[0], _e493) - _e495)) | bitcast<u32>((select(_e507, _e324.member_1[1], _e515) - _e517))) | bitcast<u32>((select(_e529, _e324.member_1[2], _e537) - _e539)));
                        if (_e619 < 1024u) {
                            phi_1296_ = 0u;
                        } else {
                            phi_1296_ = select(2u, 1u, (_e619 < 2097152u));
                        }
                        let _e624 = phi_1296_;
                        switch bitcast<i32>(_e624) {
                            case 0: {
                                phi_1302_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_1302_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_1302_ = 3u;
                                break;
                            }
                            default: {
                                phi_1302_ = u32();
                                break;
                            }
                        }
                        let _e627 = phi_1302_;
                        let _e629 = ((3u * _e627) + 1u);
                        if ((_e610 & 2147483648u) != 0u) {
                            phi_1313_ = ((_e610 >> bitcast<u32>(28u)) & 7u);
                        } else {
                            phi_1313_ = 0u;
                        }
                        let _e637 = phi_1313_;
                        phi_1316_ = type_8(0u, _e637);
                        loop {
                            let _e640 = phi_1316_;
                            if (_e640.member < _e640.member_1) {
                                phi_1317_ = type_8((_e640.member + 1u), _e640.member_1);
                                phi_1340_ = type_8(1u, _e640.member);
                            } else {
                                phi_1317_ = _e640;
                                phi_1340_ = type_8(0u, type_8().member_1);
                            }
                            let _e653 = phi_1317_;
                            let _e655 = phi_1340_;
                            let _e659 = (bitcast<i32>(_e655.member) != 0i);
                            if _e659 {
                                let _e661 = ((_e610 & 268435455u) + _e655.member_1);
                                let _e662 = (_e661 < _e47);
                                if _e662 {
                                    let _e663 = (_e661 < _e50);
                                    if _e663 {
                                        if _e662 {
                                        } else {
                                            phi_1532_ = true;
                                            break;
                                        }
                                        global_6.member[_e661] = type_36(array<i32, 3>(_e495, _e517, _e539), _e629);
                                        if _e663 {
                                        } else {
                                            phi_1532_ = true;
                                            break;
                                        }
                                        global_7.member[_e661] = _e629;
                                    }
                                }
                            }
                            continue;
                            continuing {
                                phi_1316_ = _e653;
                                phi_1532_ = _e606;
                                break if !(_e659);
                            }
                        }
                        let _e668 = phi_1532_;
                        if _e668 {
                            break;
                        }
                        if (_e81 == 0u) {
                            if (_e53 == 0u) {
                            } else {
                                if (0u < _e53) {
                                } else {
                                    break;
                                }
                                global_8.member[0u] = type_26(array<u32, 4>(bitcast<u32>(_e321.member[0]), bitcast<u32>(_e321.member[1]), bitcast<u32>(_e321.member[2]), bitcast<u32>(_e77)), array<u32, 4>(bitcast<u32>(_e324.member_1[0]), bitcast<u32>(_e324.member_1[1]), bitcast<u32>(_e324.member_1[2]), 0u));
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
fn encode_q10_sizes(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
