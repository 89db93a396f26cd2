struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_31 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_36 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_38 {
    member: array<type_36>,
}

struct type_46 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_47 {
    member: f32,
    member_1: bool,
}

struct type_52 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_15;
@group(0) @binding(0) 
var<storage> global_2: type_33;
@group(0) @binding(4) 
var<storage, read_write> global_3: type_52;
@group(0) @binding(2) 
var<storage> global_4: type_38;
@group(0) @binding(3) 
var<storage, read_write> global_5: type_26;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_177_: u32;
    var phi_326_: i32;
    var phi_327_: i32;
    var phi_337_: bool;
    var phi_347_: u32;
    var phi_348_: u32;
    var phi_350_: bool;
    var phi_355_: u32;
    var phi_399_: f32;
    var phi_405_: f32;
    var phi_416_: f32;
    var phi_422_: f32;
    var phi_445_: f32;
    var phi_456_: f32;
    var phi_465_: f32;
    var phi_471_: f32;
    var phi_482_: f32;
    var phi_488_: f32;
    var phi_511_: f32;
    var phi_522_: f32;
    var phi_531_: f32;
    var phi_537_: f32;
    var phi_548_: f32;
    var phi_554_: f32;
    var phi_577_: f32;
    var phi_588_: f32;
    var phi_688_: f32;
    var phi_689_: f32;
    var phi_2300_: bool;
    var phi_963_: type_47;
    var phi_966_: u32;
    var phi_968_: u32;
    var phi_970_: bool;
    var phi_972_: u32;
    var phi_983_: bool;
    var phi_1014_: u32;
    var phi_1015_: bool;
    var phi_1016_: u32;
    var phi_1816_: type_46;
    var phi_2160_: u32;
    var phi_2187_: u32;
    var phi_2188_: u32;
    var phi_2189_: u32;
    var phi_2191_: u32;
    var phi_2192_: u32;
    var phi_2193_: bool;
    var phi_2202_: u32;
    var phi_2207_: u32;
    var phi_2208_: bool;
    var phi_1031_: type_47;
    var phi_1034_: type_7;
    var phi_1035_: type_7;
    var phi_1057_: type_7;
    var phi_1078_: u32;
    var phi_1167_: array<array<f32, 3>, 3>;
    var phi_1638_: vec3<f32>;
    var phi_1639_: vec3<f32>;
    var phi_1670_: bool;
    var phi_1679_: vec3<f32>;
    var phi_1719_: type_22;
    var phi_1721_: type_22;
    var phi_1722_: bool;
    var phi_1726_: type_22;
    var phi_1727_: type_22;
    var phi_1728_: type_22;
    var phi_1729_: bool;
    var phi_1733_: type_22;
    var phi_1734_: bool;
    var phi_1738_: type_22;
    var phi_1739_: bool;
    var phi_1743_: type_22;
    var phi_1754_: type_47;
    var phi_1755_: type_47;
    var phi_1032_: type_47;
    var phi_2294_: bool;
    var local_2: type_47;
    var phi_2409_: bool;
    var phi_2210_: type_47;
    var phi_2211_: u32;
    var phi_2212_: bool;
    var phi_2213_: u32;
    var phi_2408_: bool;
    var phi_2214_: type_47;
    var phi_2215_: u32;
    var phi_2216_: u32;
    var phi_2217_: bool;
    var phi_2218_: u32;
    var phi_2407_: bool;
    var phi_2219_: type_47;
    var phi_2220_: u32;
    var phi_2221_: u32;
    var phi_2222_: bool;
    var phi_2223_: u32;
    var phi_2406_: bool;
    var phi_964_: type_47;
    var phi_967_: u32;
    var phi_969_: u32;
    var phi_971_: bool;
    var phi_973_: u32;
    var phi_2224_: bool;
    var phi_2405_: bool;
    var local_3: type_47;
    var local_4: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e62 = global;
            let _e64 = arrayLength((&global_2.member));
            let _e66 = arrayLength((&global_1.member));
            let _e72 = arrayLength((&global_3.member));
            let _e76 = (_e62.x + (_e62.y * 2097152u));
            let _e77 = (_e76 < arrayLength((&global_4.member)));
            if _e77 {
                if _e77 {
                } else {
                    break;
                }
                let _e81 = global_4.member[_e76].member_2;
                phi_177_ = _e81;
            } else {
                phi_177_ = 4294967295u;
            }
            let _e83 = phi_177_;
            if _e77 {
                let _e84 = (_e76 < arrayLength((&global_5.member)));
                if _e84 {
                    if _e77 {
                    } else {
                        break;
                    }
                    let _e89 = global_4.member[_e76].member.member_1;
                    let _e94 = global_4.member[_e76].member.member_3;
                    if (_e89 <= _e94) {
                        let _e96 = (1u < _e72);
                        if _e96 {
                            if (0u < _e72) {
                            } else {
                                break;
                            }
                            let _e100 = atomicAdd((&global_3.member[0u]), 1u);
                            if ((_e100 + 1u) < _e100) {
                                if _e96 {
                                } else {
                                    break;
                                }
                                let _e105 = atomicAdd((&global_3.member[1u]), 1u);
                            }
                        }
                        if _e77 {
                        } else {
                            break;
                        }
                        let _e115 = global_4.member[_e76].member.member_2[0u];
                        let _e117 = (bitcast<u32>(_e115) & 2147483647u);
                        let _e123 = global_4.member[_e76].member.member_2[1u];
                        let _e125 = (bitcast<u32>(_e123) & 2147483647u);
                        let _e131 = global_4.member[_e76].member.member_2[2u];
                        let _e133 = (bitcast<u32>(_e131) & 2147483647u);
                        let _e139 = global_4.member[_e76].member.member[0u];
                        let _e141 = (bitcast<u32>(_e139) & 2147483647u);
                        let _e147 = global_4.member[_e76].member.member[1u];
                        let _e149 = (bitcast<u32>(_e147) & 2147483647u);
                        let _e155 = global_4.member[_e76].member.member[2u];
                        let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                        let _e159 = select(_e125, _e117, (_e125 < _e117));
                        let _e161 = select(_e133, _e159, (_e133 < _e159));
                        let _e163 = select(_e141, _e161, (_e141 < _e161));
                        let _e165 = select(_e149, _e163, (_e149 < _e163));
                        let _e167 = select(_e157, _e165, (_e157 < _e165));
                        let _e169 = (bitcast<u32>(_e89) & 2147483647u);
                        let _e178 = (((select(_e169, _e167, (_e169 < _e167)) < 2139095040u) && ((bitcast<u32>(_e94) & 2147483647u) <= 2139095040u)) && (_e161 > 0u));
                        if _e178 {
                            let _e181 = (bitcast<u32>(bitcast<f32>(_e161)) & 2147483647u);
                            if (_e181 >= 8388608u) {
                                phi_326_ = (bitcast<i32>((_e181 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_326_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e181)), 32u, (_e181 == 0u))));
                            }
                            let _e195 = phi_326_;
                            phi_327_ = _e195;
                        } else {
                            phi_327_ = 0i;
                        }
                        let _e197 = phi_327_;
                        let _e198 = (_e117 == _e161);
                        if _e198 {
                            phi_337_ = true;
                        } else {
                            phi_337_ = (_e125 == _e161);
                        }
                        let _e201 = phi_337_;
                        let _e202 = select(1u, 0u, _e198);
                        if _e201 {
                            let _e203 = (_e202 + 1u);
                            phi_347_ = _e203;
                            phi_348_ = _e203;
                            phi_350_ = select(true, false, (_e203 == 2u));
                        } else {
                            phi_347_ = u32();
                            phi_348_ = 0u;
                            phi_350_ = true;
                        }
                        let _e207 = phi_347_;
                        let _e209 = phi_348_;
                        let _e211 = phi_350_;
                        if _e211 {
                            phi_355_ = (_e209 + 1u);
                        } else {
                            phi_355_ = 0u;
                        }
                        let _e215 = phi_355_;
                        let _e216 = select(_e207, _e209, _e211);
                        let _e217 = select(_e202, select(2u, _e202, _e201), _e211);
                        let _e218 = -(_e197);
                        let _e219 = (_e218 / 2i);
                        let _e224 = bitcast<f32>((bitcast<u32>((_e219 + 127i)) << bitcast<u32>(23i)));
                        let _e230 = bitcast<f32>((bitcast<u32>(((_e218 - _e219) + 127i)) << bitcast<u32>(23i)));
                        let _e235 = global_4.member[_e76].member.member;
                        let _e236 = (_e216 == 0u);
                        if _e236 {
                            phi_399_ = _e235[0];
                        } else {
                            phi_399_ = _e235[1];
                        }
                        let _e240 = phi_399_;
                        let _e241 = (_e216 == 2u);
                        if _e241 {
                            phi_405_ = _e235[2];
                        } else {
                            phi_405_ = _e240;
                        }
                        let _e244 = phi_405_;
                        let _e245 = global_4.member[_e76].member.member_2;
                        if _e236 {
                            phi_416_ = _e245[0];
                        } else {
                            phi_416_ = _e245[1];
                        }
                        let _e249 = phi_416_;
                        if _e241 {
                            phi_422_ = _e245[2];
                        } else {
                            phi_422_ = _e249;
                        }
                        let _e252 = phi_422_;
                        let _e254 = ((_e252 * _e224) * _e230);
                        let _e258 = (bitcast<f32>((bitcast<u32>(_e254) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e258 {
                            let _e262 = (bitcast<f32>((bitcast<u32>(_e244) & 2147483647u)) * 0.00000011920929f);
                            phi_445_ = select(0.00000000000011368684f, _e262, (_e262 > 0.00000000000011368684f));
                        } else {
                            phi_445_ = 0f;
                        }
                        let _e266 = phi_445_;
                        let _e267 = (_e244 + _e266);
                        let _e268 = (_e244 - _e266);
                        let _e269 = select(_e254, 0f, _e258);
                        if _e258 {
                            phi_456_ = 38685626000000000000000000f;
                        } else {
                            phi_456_ = (1f / _e254);
                        }
                        let _e272 = phi_456_;
                        let _e273 = (_e215 == 0u);
                        if _e273 {
                            phi_465_ = _e235[0];
                        } else {
                            phi_465_ = _e235[1];
                        }
                        let _e277 = phi_465_;
                        let _e278 = (_e215 == 2u);
                        if _e278 {
                            phi_471_ = _e235[2];
                        } else {
                            phi_471_ = _e277;
                        }
                        let _e281 = phi_471_;
                        if _e273 {
                            phi_482_ = _e245[0];
                        } else {
                            phi_482_ = _e245[1];
                        }
                        let _e285 = phi_482_;
                        if _e278 {
                            phi_488_ = _e245[2];
                        } else {
                            phi_488_ = _e285;
                        }
                        let _e288 = phi_488_;
                        let _e290 = ((_e288 * _e224) * _e230);
                        let _e294 = (bitcast<f32>((bitcast<u32>(_e290) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e294 {
                            let _e298 = (bitcast<f32>((bitcast<u32>(_e281) & 2147483647u)) * 0.00000011920929f);
                            phi_511_ = select(0.00000000000011368684f, _e298, (_e298 > 0.00000000000011368684f));
                        } else {
                            phi_511_ = 0f;
                        }
                        let _e302 = phi_511_;
                        let _e303 = (_e281 + _e302);
                        let _e304 = (_e281 - _e302);
                        let _e305 = select(_e290, 0f, _e294);
                        if _e294 {
                            phi_522_ = 38685626000000000000000000f;
                        } else {
                            phi_522_ = (1f / _e290);
                        }
                        let _e308 = phi_522_;
                        let _e309 = (_e217 == 0u);
                        if _e309 {
                            phi_531_ = _e235[0];
                        } else {
                            phi_531_ = _e235[1];
                        }
                        let _e313 = phi_531_;
                        let _e314 = (_e217 == 2u);
                        if _e314 {
                            phi_537_ = _e235[2];
                        } else {
                            phi_537_ = _e313;
                        }
                        let _e317 = phi_537_;
                        if _e309 {
                            phi_548_ = _e245[0];
                        } else {
                            phi_548_ = _e245[1];
                        }
                        let _e321 = phi_548_;
                        if _e314 {
                            phi_554_ = _e245[2];
                        } else {
                            phi_554_ = _e321;
                        }
                        let _e324 = phi_554_;
                        let _e326 = ((_e324 * _e224) * _e230);
                        let _e330 = (bitcast<f32>((bitcast<u32>(_e326) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e330 {
                            let _e334 = (bitcast<f32>((bitcast<u32>(_e317) & 2147483647u)) * 0.00000011920929f);
                            phi_577_ = select(0.00000000000011368684f, _e334, (_e334 > 0.00000000000011368684f));
                        } else {
                            phi_577_ = 0f;
                        }
                        let _e338 = phi_577_;
                        let _e339 = (_e317 + _e338);
                        let _e340 = (_e317 - _e338);
                        let _e341 = select(_e326, 0f, _e330);
                        if _e330 {
                            phi_588_ = 38685626000000000000000000f;
                        } else {
                            phi_588_ = (1f / _e326);
                        }
                        let _e344 = phi_588_;
                        let _e347 = bitcast<f32>((bitcast<u32>(_e244) & 2147483647u));
                        let _e350 = bitcast<f32>((bitcast<u32>(_e281) & 2147483647u));
                        let _e352 = select(_e350, _e347, (_e347 > _e350));
                        let _e355 = bitcast<f32>((bitcast<u32>(_e317) & 2147483647u));
                        if (_e178 && (select(_e355, _e352, (_e352 > _e355)) <= 1099511600000f)) {
                            let _e360 = (_e197 / 3i);
                            let _e367 = bitcast<f32>((bitcast<u32>((_e360 + 127i)) << bitcast<u32>(23i)));
                            let _e374 = bitcast<f32>((bitcast<u32>(((_e197 - (2i * _e360)) + 127i)) << bitcast<u32>(23i)));
                            let _e375 = (((_e89 * _e367) * _e367) * _e374);
                            let _e377 = select(340282350000000000000000000000000000000f, _e375, (_e375 < 340282350000000000000000000000000000000f));
                            let _e382 = (((_e94 * _e367) * _e367) * _e374);
                            let _e384 = select(340282350000000000000000000000000000000f, _e382, (_e382 < 340282350000000000000000000000000000000f));
                            phi_688_ = select(-340282350000000000000000000000000000000f, _e384, (_e384 > -340282350000000000000000000000000000000f));
                            phi_689_ = select(-340282350000000000000000000000000000000f, _e377, (_e377 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_688_ = 0f;
                            phi_689_ = 1f;
                        }
                        let _e388 = phi_688_;
                        let _e390 = phi_689_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2300_ = false;
                        phi_963_ = type_47(_e388, false);
                        phi_966_ = select(0u, 2147483648u, (_e64 == 0u));
                        phi_968_ = ((3u * _e64) + 1u);
                        phi_970_ = (_e390 <= _e388);
                        phi_972_ = 0u;
                        loop {
                            let _e398 = phi_2300_;
                            let _e400 = phi_963_;
                            let _e402 = phi_966_;
                            let _e404 = phi_968_;
                            let _e406 = phi_970_;
                            let _e408 = phi_972_;
                            local_3 = _e400;
                            if _e406 {
                                phi_983_ = true;
                            } else {
                                phi_983_ = (_e408 > 0u);
                            }
                            let _e411 = phi_983_;
                            if _e411 {
                                let _e412 = (_e404 > 0u);
                                if _e412 {
                                    if _e406 {
                                        phi_1014_ = _e402;
                                        phi_1015_ = _e406;
                                        phi_1016_ = _e408;
                                    } else {
                                        let _e413 = (_e408 - 1u);
                                        let _e414 = (_e413 % 128u);
                                        let _e415 = (_e414 < 128u);
                                        if _e415 {
                                        } else {
                                            phi_2405_ = true;
                                            break;
                                        }
                                        let _e417 = local_1[_e414];
                                        if _e415 {
                                        } else {
                                            phi_2405_ = true;
                                            break;
                                        }
                                        let _e419 = local[_e414];
                                        phi_1014_ = _e417;
                                        phi_1015_ = (_e419 <= _e400.member);
                                        phi_1016_ = _e413;
                                    }
                                    let _e423 = phi_1014_;
                                    let _e425 = phi_1015_;
                                    let _e427 = phi_1016_;
                                    if _e425 {
                                        if ((_e423 & 2147483648u) != 0u) {
                                            phi_1031_ = _e400;
                                            phi_1034_ = type_7(0u, ((_e423 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e625 = phi_1031_;
                                                let _e627 = phi_1034_;
                                                local_2 = _e625;
                                                local_4 = _e625;
                                                if (_e627.member < _e627.member_1) {
                                                    phi_1035_ = type_7((_e627.member + 1u), _e627.member_1);
                                                    phi_1057_ = type_7(1u, _e627.member);
                                                } else {
                                                    phi_1035_ = _e627;
                                                    phi_1057_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e640 = phi_1035_;
                                                let _e642 = phi_1057_;
                                                let _e646 = (bitcast<i32>(_e642.member) != 0i);
                                                if _e646 {
                                                    let _e647 = ((_e423 & 268435455u) + _e642.member_1);
                                                    let _e648 = (_e647 < _e66);
                                                    if _e648 {
                                                        if _e648 {
                                                        } else {
                                                            phi_2294_ = true;
                                                            break;
                                                        }
                                                        let _e652 = global_1.member[_e647].member_1;
                                                        phi_1078_ = _e652;
                                                    } else {
                                                        phi_1078_ = 4294967295u;
                                                    }
                                                    let _e654 = phi_1078_;
                                                    if (_e647 >= _e66) {
                                                        phi_1167_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e648 {
                                                        } else {
                                                            phi_2294_ = true;
                                                            break;
                                                        }
                                                        let _e656 = (_e216 % 3u);
                                                        let _e657 = (_e215 % 3u);
                                                        let _e658 = (_e217 % 3u);
                                                        if (_e656 < 9u) {
                                                        } else {
                                                            phi_2294_ = true;
                                                            break;
                                                        }
                                                        let _e664 = global_1.member[_e647].member[_e656];
                                                        if (_e657 < 9u) {
                                                        } else {
                                                            phi_2294_ = true;
                                                            break;
                                                        }
                                                        let _e670 = global_1.member[_e647].member[_e657];
                                                        if (_e658 < 9u) {
                                                        } else {
                                                            phi_2294_ = true;
                                                            break;
                                                        }
                                                        let _e676 = global_1.member[_e647].member[_e658];
                                                        let _e678 = (3u + _e656);
                                                        if (_e678 < 9u) {
                                                        } else {
                                                            phi_2294_ = true;
                                                            break;
                                                        }
                                                        let _e684 = global_1.member[_e647].member[_e678];
                                                        let _e685 = (3u + _e657);
                                                        if (_e685 < 9u) {
                                                        } else {
                                                            phi_2294_ = true;
                                                            break;
                                                        }
                                                        let _e691 = global_1.member[_e647].member[_e685];
                                                        let _e692 = (3u + _e658);
                                                        if (_e692 < 9u) {
                                                        } else {
                                                            phi_2294_ = true;
                                                            break;
                                                        }
                                                        let _e698 = global_1.member[_e647].member[_e692];
                                                        let _e700 = (6u + _e656);
                                                        if (_e700 < 9u) {
                                                        } else {
                                                            phi_2294_ = true;
                                                            break;
                                                        }
                                                        let _e706 = global_1.member[_e647].member[_e700];
                                                        let _e707 = (6u + _e657);
                                                        if (_e707 < 9u) {
                                                        } else {
                                                            phi_2294_ = true;
                                                            break;
                                                        }
                                                        let _e713 = global_1.member[_e647].member[_e707];
                                                        let _e714 = (6u + _e658);
                                                        if (_e714 < 9u) {
                                                        } else {
                                                            phi_2294_ = true;
                                                            break;
                                                        }
                                                        let _e720 = global_1.member[_e647].member[_e714];
                                                        phi_1167_ = array<array<f32, 3>, 3>(array<f32, 3>(_e664, _e670, _e676), array<f32, 3>(_e684, _e691, _e698), array<f32, 3>(_e706, _e713, _e720));
                                                    }
                                                    let _e724 = phi_1167_;
                                                    let _e732 = (_e724[0][2] - _e317);
                                                    let _e735 = (((_e724[0][0] - _e244) * _e341) - (_e732 * _e269));
                                                    let _e738 = (((_e724[0][1] - _e281) * _e341) - (_e732 * _e305));
                                                    let _e745 = (_e724[1][2] - _e317);
                                                    let _e748 = (((_e724[1][0] - _e244) * _e341) - (_e745 * _e269));
                                                    let _e751 = (((_e724[1][1] - _e281) * _e341) - (_e745 * _e305));
                                                    let _e758 = (_e724[2][2] - _e317);
                                                    let _e761 = (((_e724[2][0] - _e244) * _e341) - (_e758 * _e269));
                                                    let _e764 = (((_e724[2][1] - _e281) * _e341) - (_e758 * _e305));
                                                    let _e765 = (_e761 * _e751);
                                                    let _e766 = (_e764 * _e748);
                                                    let _e767 = (_e735 * _e764);
                                                    let _e768 = (_e738 * _e761);
                                                    let _e769 = (_e748 * _e738);
                                                    let _e770 = (_e751 * _e735);
                                                    let _e775 = (((_e765 >= _e766) && (_e767 >= _e768)) && (_e769 >= _e770));
                                                    if (_e775 || (((_e765 <= _e766) && (_e767 <= _e768)) && (_e769 <= _e770))) {
                                                        let _e782 = select(-1f, 1f, _e775);
                                                        let _e784 = ((_e765 - _e766) * _e782);
                                                        let _e786 = select(0f, _e784, (_e784 > 0f));
                                                        let _e788 = ((_e767 - _e768) * _e782);
                                                        let _e790 = select(0f, _e788, (_e788 > 0f));
                                                        let _e792 = ((_e769 - _e770) * _e782);
                                                        let _e794 = select(0f, _e792, (_e792 > 0f));
                                                        let _e796 = ((_e786 + _e790) + _e794);
                                                        if (_e796 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1733_ = type_22();
                                                            phi_1734_ = true;
                                                        } else {
                                                            let _e799 = select(_e724[1][0], _e724[0][0], (_e724[0][0] < _e724[1][0]));
                                                            let _e803 = select(_e724[1][0], _e724[0][0], (_e724[0][0] > _e724[1][0]));
                                                            let _e807 = select(_e724[1][1], _e724[0][1], (_e724[0][1] < _e724[1][1]));
                                                            let _e811 = select(_e724[1][1], _e724[0][1], (_e724[0][1] > _e724[1][1]));
                                                            let _e815 = select(_e724[1][2], _e724[0][2], (_e724[0][2] < _e724[1][2]));
                                                            let _e819 = select(_e724[1][2], _e724[0][2], (_e724[0][2] > _e724[1][2]));
                                                            let _e824 = ((select(_e724[2][0], _e799, (_e799 < _e724[2][0])) - _e267) * _e272);
                                                            let _e825 = ((select(_e724[2][0], _e803, (_e803 > _e724[2][0])) - _e268) * _e272);
                                                            let _e828 = ((select(_e724[2][1], _e807, (_e807 < _e724[2][1])) - _e303) * _e308);
                                                            let _e829 = ((select(_e724[2][1], _e811, (_e811 > _e724[2][1])) - _e304) * _e308);
                                                            let _e832 = ((select(_e724[2][2], _e815, (_e815 < _e724[2][2])) - _e339) * _e344);
                                                            let _e833 = ((select(_e724[2][2], _e819, (_e819 > _e724[2][2])) - _e340) * _e344);
                                                            let _e835 = select(_e833, _e832, (_e832 < _e833));
                                                            let _e837 = select(_e833, _e832, (_e832 > _e833));
                                                            let _e839 = select(_e825, _e824, (_e824 < _e825));
                                                            let _e841 = select(_e829, _e828, (_e828 < _e829));
                                                            let _e843 = select(_e841, _e839, (_e839 > _e841));
                                                            let _e845 = select(_e835, _e843, (_e843 > _e835));
                                                            let _e847 = select(_e825, _e824, (_e824 > _e825));
                                                            let _e849 = select(_e829, _e828, (_e828 > _e829));
                                                            let _e851 = select(_e849, _e847, (_e847 < _e849));
                                                            let _e853 = select(_e837, _e851, (_e851 < _e837));
                                                            let _e854 = -(_e835);
                                                            let _e860 = select(_e390, _e845, (_e845 > _e390));
                                                            if (_e860 > (_e853 + (select(_e854, _e837, (_e837 > _e854)) * 0.0000019073523f))) {
                                                                phi_1728_ = type_22();
                                                                phi_1729_ = true;
                                                            } else {
                                                                let _e862 = (_e860 > _e625.member);
                                                                if _e862 {
                                                                    phi_1727_ = type_22();
                                                                } else {
                                                                    let _e866 = (_e724[1][0] - _e724[0][0]);
                                                                    let _e867 = (_e724[1][1] - _e724[0][1]);
                                                                    let _e868 = (_e724[1][2] - _e724[0][2]);
                                                                    let _e869 = vec3<f32>(_e866, _e867, _e868);
                                                                    let _e870 = (_e724[2][0] - _e724[1][0]);
                                                                    let _e871 = (_e724[2][1] - _e724[1][1]);
                                                                    let _e872 = (_e724[2][2] - _e724[1][2]);
                                                                    let _e873 = vec3<f32>(_e870, _e871, _e872);
                                                                    let _e874 = (_e724[0][0] - _e724[2][0]);
                                                                    let _e875 = (_e724[0][1] - _e724[2][1]);
                                                                    let _e876 = (_e724[0][2] - _e724[2][2]);
                                                                    let _e877 = vec3<f32>(_e874, _e875, _e876);
                                                                    let _e880 = bitcast<f32>((bitcast<u32>(_e866) & 2147483647u));
                                                                    let _e883 = bitcast<f32>((bitcast<u32>(_e867) & 2147483647u));
                                                                    let _e885 = select(_e883, _e880, (_e880 > _e883));
                                                                    let _e888 = bitcast<f32>((bitcast<u32>(_e868) & 2147483647u));
                                                                    let _e890 = select(_e888, _e885, (_e885 > _e888));
                                                                    let _e893 = bitcast<f32>((bitcast<u32>(_e870) & 2147483647u));
                                                                    let _e896 = bitcast<f32>((bitcast<u32>(_e871) & 2147483647u));
                                                                    let _e898 = select(_e896, _e893, (_e893 > _e896));
                                                                    let _e901 = bitcast<f32>((bitcast<u32>(_e872) & 2147483647u));
                                                                    let _e903 = select(_e901, _e898, (_e898 > _e901));
                                                                    let _e906 = bitcast<f32>((bitcast<u32>(_e874) & 2147483647u));
                                                                    let _e909 = bitcast<f32>((bitcast<u32>(_e875) & 2147483647u));
                                                                    let _e911 = select(_e909, _e906, (_e906 > _e909));
                                                                    let _e914 = bitcast<f32>((bitcast<u32>(_e876) & 2147483647u));
                                                                    let _e916 = select(_e914, _e911, (_e911 > _e914));
                                                                    let _e918 = select(_e903, _e890, (_e890 > _e903));
                                                                    let _e920 = select(_e916, _e918, (_e918 > _e916));
                                                                    if (_e890 == _e920) {
                                                                        phi_1638_ = _e873;
                                                                        phi_1639_ = _e877;
                                                                    } else {
                                                                        let _e923 = vec3((_e903 == _e920));
                                                                        phi_1638_ = select(_e869, _e877, _e923);
                                                                        phi_1639_ = select(_e873, _e869, _e923);
                                                                    }
                                                                    let _e927 = phi_1638_;
                                                                    let _e929 = phi_1639_;
                                                                    let _e936 = ((_e927.y * _e929.z) - (_e929.y * _e927.z));
                                                                    let _e941 = ((_e927.z * _e929.x) - (_e929.z * _e927.x));
                                                                    let _e944 = ((_e927.x * _e929.y) - (_e929.x * _e927.y));
                                                                    if (_e786 >= _e790) {
                                                                        phi_1670_ = select(true, false, (_e786 >= _e794));
                                                                    } else {
                                                                        phi_1670_ = true;
                                                                    }
                                                                    let _e949 = phi_1670_;
                                                                    if _e949 {
                                                                        phi_1679_ = select(vec3<f32>(_e724[2][0], _e724[2][1], _e724[2][2]), vec3<f32>(_e724[1][0], _e724[1][1], _e724[1][2]), vec3((_e790 >= _e794)));
                                                                    } else {
                                                                        phi_1679_ = vec3<f32>(_e724[0][0], _e724[0][1], _e724[0][2]);
                                                                    }
                                                                    let _e954 = phi_1679_;
                                                                    let _e971 = ((((_e936 * (_e954.x - _e244)) + (_e941 * (_e954.y - _e281))) + (_e944 * (_e954.z - _e317))) / (((_e936 * _e269) + (_e941 * _e305)) + (_e944 * _e341)));
                                                                    let _e973 = select(_e853, _e971, (_e971 < _e853));
                                                                    let _e975 = select(_e845, _e973, (_e973 > _e845));
                                                                    if (_e975 >= _e390) {
                                                                        let _e977 = (_e975 <= _e625.member);
                                                                        if _e977 {
                                                                            let _e978 = (1f / _e796);
                                                                            phi_1719_ = type_22(_e975, (_e790 * _e978), (_e794 * _e978), _e654);
                                                                        } else {
                                                                            phi_1719_ = type_22();
                                                                        }
                                                                        let _e983 = phi_1719_;
                                                                        phi_1721_ = _e983;
                                                                        phi_1722_ = select(true, false, _e977);
                                                                    } else {
                                                                        phi_1721_ = type_22();
                                                                        phi_1722_ = true;
                                                                    }
                                                                    let _e986 = phi_1721_;
                                                                    let _e988 = phi_1722_;
                                                                    if _e988 {
                                                                        phi_1726_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1726_ = _e986;
                                                                    }
                                                                    let _e990 = phi_1726_;
                                                                    phi_1727_ = _e990;
                                                                }
                                                                let _e992 = phi_1727_;
                                                                phi_1728_ = _e992;
                                                                phi_1729_ = _e862;
                                                            }
                                                            let _e994 = phi_1728_;
                                                            let _e996 = phi_1729_;
                                                            phi_1733_ = _e994;
                                                            phi_1734_ = _e996;
                                                        }
                                                        let _e998 = phi_1733_;
                                                        let _e1000 = phi_1734_;
                                                        phi_1738_ = _e998;
                                                        phi_1739_ = _e1000;
                                                    } else {
                                                        phi_1738_ = type_22();
                                                        phi_1739_ = true;
                                                    }
                                                    let _e1002 = phi_1738_;
                                                    let _e1004 = phi_1739_;
                                                    if _e1004 {
                                                        phi_1743_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1743_ = _e1002;
                                                    }
                                                    let _e1006 = phi_1743_;
                                                    if (_e1006.member_3 != 4294967295u) {
                                                        if (_e654 != _e83) {
                                                            phi_1754_ = type_47(_e625.member, true);
                                                        } else {
                                                            phi_1754_ = _e625;
                                                        }
                                                        let _e1014 = phi_1754_;
                                                        phi_1755_ = _e1014;
                                                    } else {
                                                        phi_1755_ = _e625;
                                                    }
                                                    let _e1016 = phi_1755_;
                                                    phi_1032_ = _e1016;
                                                } else {
                                                    phi_1032_ = type_47();
                                                }
                                                let _e1018 = phi_1032_;
                                                continue;
                                                continuing {
                                                    phi_1031_ = _e1018;
                                                    phi_1034_ = _e640;
                                                    phi_2294_ = _e398;
                                                    break if !(_e646);
                                                }
                                            }
                                            let _e1021 = phi_2294_;
                                            phi_2405_ = _e1021;
                                            if _e1021 {
                                                break;
                                            }
                                            let _e1023 = local_2;
                                            phi_2409_ = _e1021;
                                            let _e1188 = local_4;
                                            phi_2210_ = _e1188;
                                            phi_2211_ = _e423;
                                            phi_2212_ = false;
                                            phi_2213_ = select(_e427, 0u, _e1023.member_1);
                                        } else {
                                            if (_e423 >= _e64) {
                                                phi_1816_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e423 < _e64) {
                                                } else {
                                                    phi_2405_ = true;
                                                    break;
                                                }
                                                let _e437 = (_e216 % 3u);
                                                if (_e437 < 3u) {
                                                } else {
                                                    phi_2405_ = true;
                                                    break;
                                                }
                                                let _e443 = global_2.member[_e423].member[_e437];
                                                let _e449 = (_e215 % 3u);
                                                if (_e449 < 3u) {
                                                } else {
                                                    phi_2405_ = true;
                                                    break;
                                                }
                                                let _e455 = global_2.member[_e423].member[_e449];
                                                let _e461 = (_e217 % 3u);
                                                if (_e461 < 3u) {
                                                } else {
                                                    phi_2405_ = true;
                                                    break;
                                                }
                                                let _e467 = global_2.member[_e423].member[_e461];
                                                let _e477 = global_2.member[_e423].member_1;
                                                let _e481 = global_2.member[_e423].member_2;
                                                phi_1816_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e443[0], _e443[1], _e443[2], _e443[3]), vec4<f32>(_e455[0], _e455[1], _e455[2], _e455[3]), vec4<f32>(_e467[0], _e467[1], _e467[2], _e467[3])), _e477, _e481);
                                            }
                                            let _e484 = phi_1816_;
                                            let _e496 = ((_e484.member[0].x - _e267) * _e272);
                                            let _e497 = ((_e484.member[0].y - _e267) * _e272);
                                            let _e498 = ((_e484.member[0].z - _e268) * _e272);
                                            let _e499 = ((_e484.member[0].w - _e268) * _e272);
                                            let _e509 = ((_e484.member[1].x - _e303) * _e308);
                                            let _e510 = ((_e484.member[1].y - _e303) * _e308);
                                            let _e511 = ((_e484.member[1].z - _e304) * _e308);
                                            let _e512 = ((_e484.member[1].w - _e304) * _e308);
                                            let _e522 = ((_e484.member[2].x - _e339) * _e344);
                                            let _e523 = ((_e484.member[2].y - _e339) * _e344);
                                            let _e524 = ((_e484.member[2].z - _e340) * _e344);
                                            let _e525 = ((_e484.member[2].w - _e340) * _e344);
                                            let _e527 = select(_e524, _e522, (_e522 < _e524));
                                            let _e529 = select(_e525, _e523, (_e523 < _e525));
                                            let _e531 = select(_e524, _e522, (_e522 > _e524));
                                            let _e533 = select(_e525, _e523, (_e523 > _e525));
                                            let _e535 = select(_e498, _e496, (_e496 < _e498));
                                            let _e537 = select(_e499, _e497, (_e497 < _e499));
                                            let _e539 = select(_e511, _e509, (_e509 < _e511));
                                            let _e541 = select(_e512, _e510, (_e510 < _e512));
                                            let _e543 = select(_e539, _e535, (_e535 > _e539));
                                            let _e545 = select(_e541, _e537, (_e537 > _e541));
                                            let _e547 = select(_e527, _e543, (_e543 > _e527));
                                            let _e549 = select(_e529, _e545, (_e545 > _e529));
                                            let _e551 = select(_e498, _e496, (_e496 > _e498));
                                            let _e553 = select(_e499, _e497, (_e497 > _e499));
                                            let _e555 = select(_e511, _e509, (_e509 > _e511));
                                            let _e557 = select(_e512, _e510, (_e510 > _e512));
                                            let _e559 = select(_e555, _e551, (_e551 < _e555));
                                            let _e561 = select(_e557, _e553, (_e553 < _e557));
                                            let _e566 = -(_e527);
                                            let _e567 = -(_e529);
                                            let _e574 = (select(_e531, _e559, (_e559 < _e531)) + (select(_e566, _e531, (_e531 > _e566)) * 0.0000019073523f));
                                            let _e575 = (select(_e533, _e561, (_e561 < _e533)) + (select(_e567, _e533, (_e533 > _e567)) * 0.0000019073523f));
                                            let _e577 = select(_e390, _e547, (_e547 > _e390));
                                            let _e579 = select(_e390, _e549, (_e549 > _e390));
                                            let _e584 = (_e577 <= select(_e400.member, _e574, (_e574 < _e400.member)));
                                            let _e585 = (_e579 <= select(_e400.member, _e575, (_e575 < _e400.member)));
                                            let _e586 = (_e577 <= _e579);
                                            if _e584 {
                                                if _e585 {
                                                    if _e586 {
                                                        phi_2160_ = _e484.member_2;
                                                    } else {
                                                        phi_2160_ = _e484.member_1;
                                                    }
                                                    let _e590 = phi_2160_;
                                                    let _e591 = (_e427 % 128u);
                                                    let _e592 = (_e591 < 128u);
                                                    if _e592 {
                                                    } else {
                                                        phi_2405_ = true;
                                                        break;
                                                    }
                                                    local_1[_e591] = _e590;
                                                    if _e592 {
                                                    } else {
                                                        phi_2405_ = true;
                                                        break;
                                                    }
                                                    local[_e591] = select(_e579, _e577, (_e577 > _e579));
                                                    if _e586 {
                                                        phi_2187_ = _e484.member_1;
                                                    } else {
                                                        phi_2187_ = _e484.member_2;
                                                    }
                                                    let _e601 = phi_2187_;
                                                    phi_2188_ = _e601;
                                                    phi_2189_ = (_e427 + 1u);
                                                } else {
                                                    phi_2188_ = u32();
                                                    phi_2189_ = u32();
                                                }
                                                let _e603 = phi_2188_;
                                                let _e605 = phi_2189_;
                                                phi_2191_ = _e603;
                                                phi_2192_ = _e605;
                                                phi_2193_ = select(true, false, _e585);
                                            } else {
                                                phi_2191_ = u32();
                                                phi_2192_ = u32();
                                                phi_2193_ = true;
                                            }
                                            let _e608 = phi_2191_;
                                            let _e610 = phi_2192_;
                                            let _e612 = phi_2193_;
                                            if _e612 {
                                                if _e584 {
                                                    phi_2202_ = _e484.member_1;
                                                } else {
                                                    phi_2202_ = _e484.member_2;
                                                }
                                                let _e616 = phi_2202_;
                                                phi_2207_ = _e616;
                                                phi_2208_ = select(_e585, true, _e584);
                                            } else {
                                                phi_2207_ = _e608;
                                                phi_2208_ = _e425;
                                            }
                                            let _e619 = phi_2207_;
                                            let _e621 = phi_2208_;
                                            phi_2409_ = _e398;
                                            phi_2210_ = _e400;
                                            phi_2211_ = _e619;
                                            phi_2212_ = _e621;
                                            phi_2213_ = select(_e610, _e427, _e612);
                                        }
                                        let _e1027 = phi_2409_;
                                        let _e1029 = phi_2210_;
                                        let _e1031 = phi_2211_;
                                        let _e1033 = phi_2212_;
                                        let _e1035 = phi_2213_;
                                        phi_2408_ = _e1027;
                                        phi_2214_ = _e1029;
                                        phi_2215_ = _e1031;
                                        phi_2216_ = (_e404 - 1u);
                                        phi_2217_ = _e1033;
                                        phi_2218_ = _e1035;
                                    } else {
                                        phi_2408_ = _e398;
                                        phi_2214_ = _e400;
                                        phi_2215_ = _e423;
                                        phi_2216_ = _e404;
                                        phi_2217_ = _e425;
                                        phi_2218_ = _e427;
                                    }
                                    let _e1037 = phi_2408_;
                                    let _e1039 = phi_2214_;
                                    let _e1041 = phi_2215_;
                                    let _e1043 = phi_2216_;
                                    let _e1045 = phi_2217_;
                                    let _e1047 = phi_2218_;
                                    phi_2407_ = _e1037;
                                    phi_2219_ = _e1039;
                                    phi_2220_ = _e1041;
                                    phi_2221_ = _e1043;
                                    phi_2222_ = _e1045;
                                    phi_2223_ = _e1047;
                                } else {
                                    phi_2407_ = _e398;
                                    phi_2219_ = type_47();
                                    phi_2220_ = u32();
                                    phi_2221_ = u32();
                                    phi_2222_ = bool();
                                    phi_2223_ = u32();
                                }
                                let _e1049 = phi_2407_;
                                let _e1051 = phi_2219_;
                                let _e1053 = phi_2220_;
                                let _e1055 = phi_2221_;
                                let _e1057 = phi_2222_;
                                let _e1059 = phi_2223_;
                                phi_2406_ = _e1049;
                                phi_964_ = _e1051;
                                phi_967_ = _e1053;
                                phi_969_ = _e1055;
                                phi_971_ = _e1057;
                                phi_973_ = _e1059;
                                phi_2224_ = _e412;
                            } else {
                                phi_2406_ = _e398;
                                phi_964_ = type_47();
                                phi_967_ = u32();
                                phi_969_ = u32();
                                phi_971_ = bool();
                                phi_973_ = u32();
                                phi_2224_ = false;
                            }
                            let _e1061 = phi_2406_;
                            let _e1063 = phi_964_;
                            let _e1065 = phi_967_;
                            let _e1067 = phi_969_;
                            let _e1069 = phi_971_;
                            let _e1071 = phi_973_;
                            let _e1073 = phi_2224_;
                            continue;
                            continuing {
                                phi_2300_ = _e1061;
                                phi_963_ = _e1063;
                                phi_966_ = _e1065;
                                phi_968_ = _e1067;
                                phi_970_ = _e1069;
                                phi_972_ = _e1071;
                                phi_2405_ = _e1061;
                                break if !(_e1073);
                            }
                        }
                        let _e1076 = phi_2405_;
                        if _e1076 {
                            break;
                        }
                        let _e1078 = local_3;
                        if _e1078.member_1 {
                        } else {
                            if _e84 {
                            } else {
                                break;
                            }
                            let _e1082 = global_5.member[_e76];
                            if _e77 {
                            } else {
                                break;
                            }
                            let _e1086 = global_4.member[_e76].member_1;
                            if _e84 {
                            } else {
                                break;
                            }
                            global_5.member[_e76] = type_24(_e1082.member, _e1082.member_1, _e1082.member_2, array<f32, 3>((_e1082.member_3[0] + (_e1086[0] * _e1082.member_1[0])), (_e1082.member_3[1] + (_e1086[1] * _e1082.member_1[1])), (_e1082.member_3[2] + (_e1086[2] * _e1082.member_1[2]))), _e1082.member_4);
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
fn trace_shadows(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
