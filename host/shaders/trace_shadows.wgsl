struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_10 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_12 {
    member: array<type_10>,
}

struct type_16 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_17 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_18 {
    member: type_17,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_27 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_32 {
    member: type_17,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_34 {
    member: array<type_32>,
}

struct type_43 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_45 {
    member: f32,
    member_1: bool,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_12;
@group(0) @binding(0) 
var<storage> global_2: type_29;
@group(0) @binding(2) 
var<storage> global_3: type_34;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_20;

fn function_() {
    var local: array<u32, 128>;
    var local_1: array<f32, 128>;
    var phi_278_: i32;
    var phi_279_: i32;
    var phi_289_: bool;
    var phi_299_: u32;
    var phi_300_: u32;
    var phi_302_: bool;
    var phi_307_: u32;
    var phi_351_: f32;
    var phi_357_: f32;
    var phi_368_: f32;
    var phi_374_: f32;
    var phi_397_: f32;
    var phi_408_: f32;
    var phi_417_: f32;
    var phi_423_: f32;
    var phi_434_: f32;
    var phi_440_: f32;
    var phi_463_: f32;
    var phi_474_: f32;
    var phi_483_: f32;
    var phi_489_: f32;
    var phi_500_: f32;
    var phi_506_: f32;
    var phi_529_: f32;
    var phi_540_: f32;
    var phi_640_: f32;
    var phi_641_: f32;
    var phi_1979_: bool;
    var phi_652_: type_45;
    var phi_655_: u32;
    var phi_657_: u32;
    var phi_659_: bool;
    var phi_661_: u32;
    var phi_672_: bool;
    var phi_702_: u32;
    var phi_703_: bool;
    var phi_704_: u32;
    var phi_1503_: type_43;
    var phi_1847_: u32;
    var phi_1873_: u32;
    var phi_1874_: u32;
    var phi_1875_: u32;
    var phi_1877_: u32;
    var phi_1878_: u32;
    var phi_1879_: bool;
    var phi_1888_: u32;
    var phi_1893_: u32;
    var phi_1894_: bool;
    var phi_720_: type_45;
    var phi_723_: type_4;
    var phi_724_: type_4;
    var phi_746_: type_4;
    var phi_766_: u32;
    var phi_854_: array<array<f32, 3>, 3>;
    var phi_1325_: vec3<f32>;
    var phi_1326_: vec3<f32>;
    var phi_1357_: bool;
    var phi_1366_: vec3<f32>;
    var phi_1406_: type_16;
    var phi_1408_: type_16;
    var phi_1409_: bool;
    var phi_1413_: type_16;
    var phi_1414_: type_16;
    var phi_1415_: type_16;
    var phi_1416_: bool;
    var phi_1420_: type_16;
    var phi_1421_: bool;
    var phi_1425_: type_16;
    var phi_1426_: bool;
    var phi_1430_: type_16;
    var phi_1441_: type_45;
    var phi_1442_: type_45;
    var phi_721_: type_45;
    var phi_1973_: bool;
    var local_2: type_45;
    var phi_2084_: bool;
    var phi_1896_: type_45;
    var phi_1897_: u32;
    var phi_1898_: bool;
    var phi_1899_: u32;
    var phi_2083_: bool;
    var phi_1900_: type_45;
    var phi_1901_: u32;
    var phi_1902_: u32;
    var phi_1903_: bool;
    var phi_1904_: u32;
    var phi_2082_: bool;
    var phi_1905_: type_45;
    var phi_1906_: u32;
    var phi_1907_: u32;
    var phi_1908_: bool;
    var phi_1909_: u32;
    var phi_2081_: bool;
    var phi_653_: type_45;
    var phi_656_: u32;
    var phi_658_: u32;
    var phi_660_: bool;
    var phi_662_: u32;
    var phi_1910_: bool;
    var phi_2080_: bool;
    var local_3: type_45;
    var local_4: type_45;

    switch bitcast<i32>(0u) {
        default: {
            let _e60 = global;
            let _e62 = arrayLength((&global_2.member));
            let _e64 = arrayLength((&global_1.member));
            let _e72 = (_e60.x + (_e60.y * 2097152u));
            let _e73 = (_e72 < arrayLength((&global_3.member)));
            if _e73 {
                let _e74 = (_e72 < arrayLength((&global_4.member)));
                if _e74 {
                    if _e73 {
                    } else {
                        break;
                    }
                    let _e79 = global_3.member[_e72].member.member_1;
                    let _e84 = global_3.member[_e72].member.member_3;
                    if (_e79 <= _e84) {
                        if _e73 {
                        } else {
                            break;
                        }
                        if _e73 {
                        } else {
                            break;
                        }
                        let _e89 = global_3.member[_e72].member_2;
                        let _e99 = global_3.member[_e72].member.member_2[0u];
                        let _e101 = (bitcast<u32>(_e99) & 2147483647u);
                        let _e107 = global_3.member[_e72].member.member_2[1u];
                        let _e109 = (bitcast<u32>(_e107) & 2147483647u);
                        let _e115 = global_3.member[_e72].member.member_2[2u];
                        let _e117 = (bitcast<u32>(_e115) & 2147483647u);
                        let _e123 = global_3.member[_e72].member.member[0u];
                        let _e125 = (bitcast<u32>(_e123) & 2147483647u);
                        let _e131 = global_3.member[_e72].member.member[1u];
                        let _e133 = (bitcast<u32>(_e131) & 2147483647u);
                        let _e139 = global_3.member[_e72].member.member[2u];
                        let _e141 = (bitcast<u32>(_e139) & 2147483647u);
                        let _e143 = select(_e109, _e101, (_e109 < _e101));
                        let _e145 = select(_e117, _e143, (_e117 < _e143));
                        let _e147 = select(_e125, _e145, (_e125 < _e145));
                        let _e149 = select(_e133, _e147, (_e133 < _e147));
                        let _e151 = select(_e141, _e149, (_e141 < _e149));
                        let _e153 = (bitcast<u32>(_e79) & 2147483647u);
                        let _e162 = (((select(_e153, _e151, (_e153 < _e151)) < 2139095040u) && ((bitcast<u32>(_e84) & 2147483647u) <= 2139095040u)) && (_e145 > 0u));
                        if _e162 {
                            let _e165 = (bitcast<u32>(bitcast<f32>(_e145)) & 2147483647u);
                            if (_e165 >= 8388608u) {
                                phi_278_ = (bitcast<i32>((_e165 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_278_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e165)), 32u, (_e165 == 0u))));
                            }
                            let _e179 = phi_278_;
                            phi_279_ = _e179;
                        } else {
                            phi_279_ = 0i;
                        }
                        let _e181 = phi_279_;
                        let _e182 = (_e101 == _e145);
                        if _e182 {
                            phi_289_ = true;
                        } else {
                            phi_289_ = (_e109 == _e145);
                        }
                        let _e185 = phi_289_;
                        let _e186 = select(1u, 0u, _e182);
                        if _e185 {
                            let _e187 = (_e186 + 1u);
                            phi_299_ = _e187;
                            phi_300_ = _e187;
                            phi_302_ = select(true, false, (_e187 == 2u));
                        } else {
                            phi_299_ = u32();
                            phi_300_ = 0u;
                            phi_302_ = true;
                        }
                        let _e191 = phi_299_;
                        let _e193 = phi_300_;
                        let _e195 = phi_302_;
                        if _e195 {
                            phi_307_ = (_e193 + 1u);
                        } else {
                            phi_307_ = 0u;
                        }
                        let _e199 = phi_307_;
                        let _e200 = select(_e191, _e193, _e195);
                        let _e201 = select(_e186, select(2u, _e186, _e185), _e195);
                        let _e202 = -(_e181);
                        let _e203 = (_e202 / 2i);
                        let _e208 = bitcast<f32>((bitcast<u32>((_e203 + 127i)) << bitcast<u32>(23i)));
                        let _e214 = bitcast<f32>((bitcast<u32>(((_e202 - _e203) + 127i)) << bitcast<u32>(23i)));
                        let _e219 = global_3.member[_e72].member.member;
                        let _e220 = (_e200 == 0u);
                        if _e220 {
                            phi_351_ = _e219[0];
                        } else {
                            phi_351_ = _e219[1];
                        }
                        let _e224 = phi_351_;
                        let _e225 = (_e200 == 2u);
                        if _e225 {
                            phi_357_ = _e219[2];
                        } else {
                            phi_357_ = _e224;
                        }
                        let _e228 = phi_357_;
                        let _e229 = global_3.member[_e72].member.member_2;
                        if _e220 {
                            phi_368_ = _e229[0];
                        } else {
                            phi_368_ = _e229[1];
                        }
                        let _e233 = phi_368_;
                        if _e225 {
                            phi_374_ = _e229[2];
                        } else {
                            phi_374_ = _e233;
                        }
                        let _e236 = phi_374_;
                        let _e238 = ((_e236 * _e208) * _e214);
                        let _e242 = (bitcast<f32>((bitcast<u32>(_e238) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e242 {
                            let _e246 = (bitcast<f32>((bitcast<u32>(_e228) & 2147483647u)) * 0.00000011920929f);
                            phi_397_ = select(0.00000000000011368684f, _e246, (_e246 > 0.00000000000011368684f));
                        } else {
                            phi_397_ = 0f;
                        }
                        let _e250 = phi_397_;
                        let _e251 = (_e228 + _e250);
                        let _e252 = (_e228 - _e250);
                        let _e253 = select(_e238, 0f, _e242);
                        if _e242 {
                            phi_408_ = 38685626000000000000000000f;
                        } else {
                            phi_408_ = (1f / _e238);
                        }
                        let _e256 = phi_408_;
                        let _e257 = (_e199 == 0u);
                        if _e257 {
                            phi_417_ = _e219[0];
                        } else {
                            phi_417_ = _e219[1];
                        }
                        let _e261 = phi_417_;
                        let _e262 = (_e199 == 2u);
                        if _e262 {
                            phi_423_ = _e219[2];
                        } else {
                            phi_423_ = _e261;
                        }
                        let _e265 = phi_423_;
                        if _e257 {
                            phi_434_ = _e229[0];
                        } else {
                            phi_434_ = _e229[1];
                        }
                        let _e269 = phi_434_;
                        if _e262 {
                            phi_440_ = _e229[2];
                        } else {
                            phi_440_ = _e269;
                        }
                        let _e272 = phi_440_;
                        let _e274 = ((_e272 * _e208) * _e214);
                        let _e278 = (bitcast<f32>((bitcast<u32>(_e274) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e278 {
                            let _e282 = (bitcast<f32>((bitcast<u32>(_e265) & 2147483647u)) * 0.00000011920929f);
                            phi_463_ = select(0.00000000000011368684f, _e282, (_e282 > 0.00000000000011368684f));
                        } else {
                            phi_463_ = 0f;
                        }
                        let _e286 = phi_463_;
                        let _e287 = (_e265 + _e286);
                        let _e288 = (_e265 - _e286);
                        let _e289 = select(_e274, 0f, _e278);
                        if _e278 {
                            phi_474_ = 38685626000000000000000000f;
                        } else {
                            phi_474_ = (1f / _e274);
                        }
                        let _e292 = phi_474_;
                        let _e293 = (_e201 == 0u);
                        if _e293 {
                            phi_483_ = _e219[0];
                        } else {
                            phi_483_ = _e219[1];
                        }
                        let _e297 = phi_483_;
                        let _e298 = (_e201 == 2u);
                        if _e298 {
                            phi_489_ = _e219[2];
                        } else {
                            phi_489_ = _e297;
                        }
                        let _e301 = phi_489_;
                        if _e293 {
                            phi_500_ = _e229[0];
                        } else {
                            phi_500_ = _e229[1];
                        }
                        let _e305 = phi_500_;
                        if _e298 {
                            phi_506_ = _e229[2];
                        } else {
                            phi_506_ = _e305;
                        }
                        let _e308 = phi_506_;
                        let _e310 = ((_e308 * _e208) * _e214);
                        let _e314 = (bitcast<f32>((bitcast<u32>(_e310) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e314 {
                            let _e318 = (bitcast<f32>((bitcast<u32>(_e301) & 2147483647u)) * 0.00000011920929f);
                            phi_529_ = select(0.00000000000011368684f, _e318, (_e318 > 0.00000000000011368684f));
                        } else {
                            phi_529_ = 0f;
                        }
                        let _e322 = phi_529_;
                        let _e323 = (_e301 + _e322);
                        let _e324 = (_e301 - _e322);
                        let _e325 = select(_e310, 0f, _e314);
                        if _e314 {
                            phi_540_ = 38685626000000000000000000f;
                        } else {
                            phi_540_ = (1f / _e310);
                        }
                        let _e328 = phi_540_;
                        let _e331 = bitcast<f32>((bitcast<u32>(_e228) & 2147483647u));
                        let _e334 = bitcast<f32>((bitcast<u32>(_e265) & 2147483647u));
                        let _e336 = select(_e334, _e331, (_e331 > _e334));
                        let _e339 = bitcast<f32>((bitcast<u32>(_e301) & 2147483647u));
                        if (_e162 && (select(_e339, _e336, (_e336 > _e339)) <= 1099511600000f)) {
                            let _e344 = (_e181 / 3i);
                            let _e351 = bitcast<f32>((bitcast<u32>((_e344 + 127i)) << bitcast<u32>(23i)));
                            let _e358 = bitcast<f32>((bitcast<u32>(((_e181 - (2i * _e344)) + 127i)) << bitcast<u32>(23i)));
                            let _e359 = (((_e79 * _e351) * _e351) * _e358);
                            let _e361 = select(340282350000000000000000000000000000000f, _e359, (_e359 < 340282350000000000000000000000000000000f));
                            let _e366 = (((_e84 * _e351) * _e351) * _e358);
                            let _e368 = select(340282350000000000000000000000000000000f, _e366, (_e366 < 340282350000000000000000000000000000000f));
                            phi_640_ = select(-340282350000000000000000000000000000000f, _e368, (_e368 > -340282350000000000000000000000000000000f));
                            phi_641_ = select(-340282350000000000000000000000000000000f, _e361, (_e361 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_640_ = 0f;
                            phi_641_ = 1f;
                        }
                        let _e372 = phi_640_;
                        let _e374 = phi_641_;
                        local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_1979_ = false;
                        phi_652_ = type_45(_e372, false);
                        phi_655_ = select(0u, 2147483648u, (_e62 == 0u));
                        phi_657_ = ((3u * _e62) + 1u);
                        phi_659_ = (_e374 <= _e372);
                        phi_661_ = 0u;
                        loop {
                            let _e382 = phi_1979_;
                            let _e384 = phi_652_;
                            let _e386 = phi_655_;
                            let _e388 = phi_657_;
                            let _e390 = phi_659_;
                            let _e392 = phi_661_;
                            local_3 = _e384;
                            if _e390 {
                                phi_672_ = true;
                            } else {
                                phi_672_ = (_e392 > 0u);
                            }
                            let _e395 = phi_672_;
                            if _e395 {
                                let _e396 = (_e388 > 0u);
                                if _e396 {
                                    if _e390 {
                                        phi_702_ = _e386;
                                        phi_703_ = _e390;
                                        phi_704_ = _e392;
                                    } else {
                                        let _e397 = (_e392 - 1u);
                                        let _e398 = (_e397 % 128u);
                                        let _e399 = (_e398 < 128u);
                                        if _e399 {
                                        } else {
                                            phi_2080_ = true;
                                            break;
                                        }
                                        let _e401 = local[_e398];
                                        if _e399 {
                                        } else {
                                            phi_2080_ = true;
                                            break;
                                        }
                                        let _e403 = local_1[_e398];
                                        phi_702_ = _e401;
                                        phi_703_ = (_e403 <= _e384.member);
                                        phi_704_ = _e397;
                                    }
                                    let _e407 = phi_702_;
                                    let _e409 = phi_703_;
                                    let _e411 = phi_704_;
                                    if _e409 {
                                        let _e415 = (_e407 & 268435455u);
                                        if ((_e407 & 2147483648u) != 0u) {
                                            phi_720_ = _e384;
                                            phi_723_ = type_4(_e415, (_e415 + ((_e407 >> bitcast<u32>(28u)) & 7u)));
                                            loop {
                                                let _e610 = phi_720_;
                                                let _e612 = phi_723_;
                                                local_2 = _e610;
                                                local_4 = _e610;
                                                if (_e612.member < _e612.member_1) {
                                                    phi_724_ = type_4((_e612.member + 1u), _e612.member_1);
                                                    phi_746_ = type_4(1u, _e612.member);
                                                } else {
                                                    phi_724_ = _e612;
                                                    phi_746_ = type_4(0u, type_4().member_1);
                                                }
                                                let _e625 = phi_724_;
                                                let _e627 = phi_746_;
                                                let _e631 = (bitcast<i32>(_e627.member) != 0i);
                                                if _e631 {
                                                    let _e632 = (_e627.member_1 < _e64);
                                                    if _e632 {
                                                        if _e632 {
                                                        } else {
                                                            phi_1973_ = true;
                                                            break;
                                                        }
                                                        let _e636 = global_1.member[_e627.member_1].member_1;
                                                        phi_766_ = _e636;
                                                    } else {
                                                        phi_766_ = 4294967295u;
                                                    }
                                                    let _e638 = phi_766_;
                                                    if (_e627.member_1 >= _e64) {
                                                        phi_854_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e632 {
                                                        } else {
                                                            phi_1973_ = true;
                                                            break;
                                                        }
                                                        let _e640 = (_e200 % 3u);
                                                        let _e641 = (_e199 % 3u);
                                                        let _e642 = (_e201 % 3u);
                                                        if (_e640 < 9u) {
                                                        } else {
                                                            phi_1973_ = true;
                                                            break;
                                                        }
                                                        let _e648 = global_1.member[_e627.member_1].member[_e640];
                                                        if (_e641 < 9u) {
                                                        } else {
                                                            phi_1973_ = true;
                                                            break;
                                                        }
                                                        let _e654 = global_1.member[_e627.member_1].member[_e641];
                                                        if (_e642 < 9u) {
                                                        } else {
                                                            phi_1973_ = true;
                                                            break;
                                                        }
                                                        let _e660 = global_1.member[_e627.member_1].member[_e642];
                                                        let _e662 = (3u + _e640);
                                                        if (_e662 < 9u) {
                                                        } else {
                                                            phi_1973_ = true;
                                                            break;
                                                        }
                                                        let _e668 = global_1.member[_e627.member_1].member[_e662];
                                                        let _e669 = (3u + _e641);
                                                        if (_e669 < 9u) {
                                                        } else {
                                                            phi_1973_ = true;
                                                            break;
                                                        }
                                                        let _e675 = global_1.member[_e627.member_1].member[_e669];
                                                        let _e676 = (3u + _e642);
                                                        if (_e676 < 9u) {
                                                        } else {
                                                            phi_1973_ = true;
                                                            break;
                                                        }
                                                        let _e682 = global_1.member[_e627.member_1].member[_e676];
                                                        let _e684 = (6u + _e640);
                                                        if (_e684 < 9u) {
                                                        } else {
                                                            phi_1973_ = true;
                                                            break;
                                                        }
                                                        let _e690 = global_1.member[_e627.member_1].member[_e684];
                                                        let _e691 = (6u + _e641);
                                                        if (_e691 < 9u) {
                                                        } else {
                                                            phi_1973_ = true;
                                                            break;
                                                        }
                                                        let _e697 = global_1.member[_e627.member_1].member[_e691];
                                                        let _e698 = (6u + _e642);
                                                        if (_e698 < 9u) {
                                                        } else {
                                                            phi_1973_ = true;
                                                            break;
                                                        }
                                                        let _e704 = global_1.member[_e627.member_1].member[_e698];
                                                        phi_854_ = array<array<f32, 3>, 3>(array<f32, 3>(_e648, _e654, _e660), array<f32, 3>(_e668, _e675, _e682), array<f32, 3>(_e690, _e697, _e704));
                                                    }
                                                    let _e708 = phi_854_;
                                                    let _e716 = (_e708[0][2] - _e301);
                                                    let _e719 = (((_e708[0][0] - _e228) * _e325) - (_e716 * _e253));
                                                    let _e722 = (((_e708[0][1] - _e265) * _e325) - (_e716 * _e289));
                                                    let _e729 = (_e708[1][2] - _e301);
                                                    let _e732 = (((_e708[1][0] - _e228) * _e325) - (_e729 * _e253));
                                                    let _e735 = (((_e708[1][1] - _e265) * _e325) - (_e729 * _e289));
                                                    let _e742 = (_e708[2][2] - _e301);
                                                    let _e745 = (((_e708[2][0] - _e228) * _e325) - (_e742 * _e253));
                                                    let _e748 = (((_e708[2][1] - _e265) * _e325) - (_e742 * _e289));
                                                    let _e749 = (_e745 * _e735);
                                                    let _e750 = (_e748 * _e732);
                                                    let _e751 = (_e719 * _e748);
                                                    let _e752 = (_e722 * _e745);
                                                    let _e753 = (_e732 * _e722);
                                                    let _e754 = (_e735 * _e719);
                                                    let _e759 = (((_e749 >= _e750) && (_e751 >= _e752)) && (_e753 >= _e754));
                                                    if (_e759 || (((_e749 <= _e750) && (_e751 <= _e752)) && (_e753 <= _e754))) {
                                                        let _e766 = select(-1f, 1f, _e759);
                                                        let _e768 = ((_e749 - _e750) * _e766);
                                                        let _e770 = select(0f, _e768, (_e768 > 0f));
                                                        let _e772 = ((_e751 - _e752) * _e766);
                                                        let _e774 = select(0f, _e772, (_e772 > 0f));
                                                        let _e776 = ((_e753 - _e754) * _e766);
                                                        let _e778 = select(0f, _e776, (_e776 > 0f));
                                                        let _e780 = ((_e770 + _e774) + _e778);
                                                        if (_e780 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1420_ = type_16();
                                                            phi_1421_ = true;
                                                        } else {
                                                            let _e783 = select(_e708[1][0], _e708[0][0], (_e708[0][0] < _e708[1][0]));
                                                            let _e787 = select(_e708[1][0], _e708[0][0], (_e708[0][0] > _e708[1][0]));
                                                            let _e791 = select(_e708[1][1], _e708[0][1], (_e708[0][1] < _e708[1][1]));
                                                            let _e795 = select(_e708[1][1], _e708[0][1], (_e708[0][1] > _e708[1][1]));
                                                            let _e799 = select(_e708[1][2], _e708[0][2], (_e708[0][2] < _e708[1][2]));
                                                            let _e803 = select(_e708[1][2], _e708[0][2], (_e708[0][2] > _e708[1][2]));
                                                            let _e808 = ((select(_e708[2][0], _e783, (_e783 < _e708[2][0])) - _e251) * _e256);
                                                            let _e809 = ((select(_e708[2][0], _e787, (_e787 > _e708[2][0])) - _e252) * _e256);
                                                            let _e812 = ((select(_e708[2][1], _e791, (_e791 < _e708[2][1])) - _e287) * _e292);
                                                            let _e813 = ((select(_e708[2][1], _e795, (_e795 > _e708[2][1])) - _e288) * _e292);
                                                            let _e816 = ((select(_e708[2][2], _e799, (_e799 < _e708[2][2])) - _e323) * _e328);
                                                            let _e817 = ((select(_e708[2][2], _e803, (_e803 > _e708[2][2])) - _e324) * _e328);
                                                            let _e819 = select(_e817, _e816, (_e816 < _e817));
                                                            let _e821 = select(_e817, _e816, (_e816 > _e817));
                                                            let _e823 = select(_e809, _e808, (_e808 < _e809));
                                                            let _e825 = select(_e813, _e812, (_e812 < _e813));
                                                            let _e827 = select(_e825, _e823, (_e823 > _e825));
                                                            let _e829 = select(_e819, _e827, (_e827 > _e819));
                                                            let _e831 = select(_e809, _e808, (_e808 > _e809));
                                                            let _e833 = select(_e813, _e812, (_e812 > _e813));
                                                            let _e835 = select(_e833, _e831, (_e831 < _e833));
                                                            let _e837 = select(_e821, _e835, (_e835 < _e821));
                                                            let _e838 = -(_e819);
                                                            let _e844 = select(_e374, _e829, (_e829 > _e374));
                                                            if (_e844 > (_e837 + (select(_e838, _e821, (_e821 > _e838)) * 0.0000019073523f))) {
                                                                phi_1415_ = type_16();
                                                                phi_1416_ = true;
                                                            } else {
                                                                let _e846 = (_e844 > _e610.member);
                                                                if _e846 {
                                                                    phi_1414_ = type_16();
                                                                } else {
                                                                    let _e850 = (_e708[1][0] - _e708[0][0]);
                                                                    let _e851 = (_e708[1][1] - _e708[0][1]);
                                                                    let _e852 = (_e708[1][2] - _e708[0][2]);
                                                                    let _e853 = vec3<f32>(_e850, _e851, _e852);
                                                                    let _e854 = (_e708[2][0] - _e708[1][0]);
                                                                    let _e855 = (_e708[2][1] - _e708[1][1]);
                                                                    let _e856 = (_e708[2][2] - _e708[1][2]);
                                                                    let _e857 = vec3<f32>(_e854, _e855, _e856);
                                                                    let _e858 = (_e708[0][0] - _e708[2][0]);
                                                                    let _e859 = (_e708[0][1] - _e708[2][1]);
                                                                    let _e860 = (_e708[0][2] - _e708[2][2]);
                                                                    let _e861 = vec3<f32>(_e858, _e859, _e860);
                                                                    let _e864 = bitcast<f32>((bitcast<u32>(_e850) & 2147483647u));
                                                                    let _e867 = bitcast<f32>((bitcast<u32>(_e851) & 2147483647u));
                                                                    let _e869 = select(_e867, _e864, (_e864 > _e867));
                                                                    let _e872 = bitcast<f32>((bitcast<u32>(_e852) & 2147483647u));
                                                                    let _e874 = select(_e872, _e869, (_e869 > _e872));
                                                                    let _e877 = bitcast<f32>((bitcast<u32>(_e854) & 2147483647u));
                                                                    let _e880 = bitcast<f32>((bitcast<u32>(_e855) & 2147483647u));
                                                                    let _e882 = select(_e880, _e877, (_e877 > _e880));
                                                                    let _e885 = bitcast<f32>((bitcast<u32>(_e856) & 2147483647u));
                                                                    let _e887 = select(_e885, _e882, (_e882 > _e885));
                                                                    let _e890 = bitcast<f32>((bitcast<u32>(_e858) & 2147483647u));
                                                                    let _e893 = bitcast<f32>((bitcast<u32>(_e859) & 2147483647u));
                                                                    let _e895 = select(_e893, _e890, (_e890 > _e893));
                                                                    let _e898 = bitcast<f32>((bitcast<u32>(_e860) & 2147483647u));
                                                                    let _e900 = select(_e898, _e895, (_e895 > _e898));
                                                                    let _e902 = select(_e887, _e874, (_e874 > _e887));
                                                                    let _e904 = select(_e900, _e902, (_e902 > _e900));
                                                                    if (_e874 == _e904) {
                                                                        phi_1325_ = _e857;
                                                                        phi_1326_ = _e861;
                                                                    } else {
                                                                        let _e907 = vec3((_e887 == _e904));
                                                                        phi_1325_ = select(_e853, _e861, _e907);
                                                                        phi_1326_ = select(_e857, _e853, _e907);
                                                                    }
                                                                    let _e911 = phi_1325_;
                                                                    let _e913 = phi_1326_;
                                                                    let _e920 = ((_e911.y * _e913.z) - (_e913.y * _e911.z));
                                                                    let _e925 = ((_e911.z * _e913.x) - (_e913.z * _e911.x));
                                                                    let _e928 = ((_e911.x * _e913.y) - (_e913.x * _e911.y));
                                                                    if (_e770 >= _e774) {
                                                                        phi_1357_ = select(true, false, (_e770 >= _e778));
                                                                    } else {
                                                                        phi_1357_ = true;
                                                                    }
                                                                    let _e933 = phi_1357_;
                                                                    if _e933 {
                                                                        phi_1366_ = select(vec3<f32>(_e708[2][0], _e708[2][1], _e708[2][2]), vec3<f32>(_e708[1][0], _e708[1][1], _e708[1][2]), vec3((_e774 >= _e778)));
                                                                    } else {
                                                                        phi_1366_ = vec3<f32>(_e708[0][0], _e708[0][1], _e708[0][2]);
                                                                    }
                                                                    let _e938 = phi_1366_;
                                                                    let _e955 = ((((_e920 * (_e938.x - _e228)) + (_e925 * (_e938.y - _e265))) + (_e928 * (_e938.z - _e301))) / (((_e920 * _e253) + (_e925 * _e289)) + (_e928 * _e325)));
                                                                    let _e957 = select(_e837, _e955, (_e955 < _e837));
                                                                    let _e959 = select(_e829, _e957, (_e957 > _e829));
                                                                    if (_e959 >= _e374) {
                                                                        let _e961 = (_e959 <= _e610.member);
                                                                        if _e961 {
                                                                            let _e962 = (1f / _e780);
                                                                            phi_1406_ = type_16(_e959, (_e774 * _e962), (_e778 * _e962), _e638);
                                                                        } else {
                                                                            phi_1406_ = type_16();
                                                                        }
                                                                        let _e967 = phi_1406_;
                                                                        phi_1408_ = _e967;
                                                                        phi_1409_ = select(true, false, _e961);
                                                                    } else {
                                                                        phi_1408_ = type_16();
                                                                        phi_1409_ = true;
                                                                    }
                                                                    let _e970 = phi_1408_;
                                                                    let _e972 = phi_1409_;
                                                                    if _e972 {
                                                                        phi_1413_ = type_16(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1413_ = _e970;
                                                                    }
                                                                    let _e974 = phi_1413_;
                                                                    phi_1414_ = _e974;
                                                                }
                                                                let _e976 = phi_1414_;
                                                                phi_1415_ = _e976;
                                                                phi_1416_ = _e846;
                                                            }
                                                            let _e978 = phi_1415_;
                                                            let _e980 = phi_1416_;
                                                            phi_1420_ = _e978;
                                                            phi_1421_ = _e980;
                                                        }
                                                        let _e982 = phi_1420_;
                                                        let _e984 = phi_1421_;
                                                        phi_1425_ = _e982;
                                                        phi_1426_ = _e984;
                                                    } else {
                                                        phi_1425_ = type_16();
                                                        phi_1426_ = true;
                                                    }
                                                    let _e986 = phi_1425_;
                                                    let _e988 = phi_1426_;
                                                    if _e988 {
                                                        phi_1430_ = type_16(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1430_ = _e986;
                                                    }
                                                    let _e990 = phi_1430_;
                                                    if (_e990.member_3 != 4294967295u) {
                                                        if (_e638 != _e89) {
                                                            phi_1441_ = type_45(_e610.member, true);
                                                        } else {
                                                            phi_1441_ = _e610;
                                                        }
                                                        let _e998 = phi_1441_;
                                                        phi_1442_ = _e998;
                                                    } else {
                                                        phi_1442_ = _e610;
                                                    }
                                                    let _e1000 = phi_1442_;
                                                    phi_721_ = _e1000;
                                                } else {
                                                    phi_721_ = type_45();
                                                }
                                                let _e1002 = phi_721_;
                                                continue;
                                                continuing {
                                                    phi_720_ = _e1002;
                                                    phi_723_ = _e625;
                                                    phi_1973_ = _e382;
                                                    break if !(_e631);
                                                }
                                            }
                                            let _e1005 = phi_1973_;
                                            phi_2080_ = _e1005;
                                            if _e1005 {
                                                break;
                                            }
                                            let _e1007 = local_2;
                                            phi_2084_ = _e1005;
                                            let _e1171 = local_4;
                                            phi_1896_ = _e1171;
                                            phi_1897_ = _e407;
                                            phi_1898_ = false;
                                            phi_1899_ = select(_e411, 0u, _e1007.member_1);
                                        } else {
                                            if (_e407 >= _e62) {
                                                phi_1503_ = type_43(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e407 < _e62) {
                                                } else {
                                                    phi_2080_ = true;
                                                    break;
                                                }
                                                let _e421 = (_e200 % 3u);
                                                if (_e421 < 3u) {
                                                } else {
                                                    phi_2080_ = true;
                                                    break;
                                                }
                                                let _e427 = global_2.member[_e407].member[_e421];
                                                let _e433 = (_e199 % 3u);
                                                if (_e433 < 3u) {
                                                } else {
                                                    phi_2080_ = true;
                                                    break;
                                                }
                                                let _e439 = global_2.member[_e407].member[_e433];
                                                let _e445 = (_e201 % 3u);
                                                if (_e445 < 3u) {
                                                } else {
                                                    phi_2080_ = true;
                                                    break;
                                                }
                                                let _e451 = global_2.member[_e407].member[_e445];
                                                let _e461 = global_2.member[_e407].member_1;
                                                let _e465 = global_2.member[_e407].member_2;
                                                phi_1503_ = type_43(array<vec4<f32>, 3>(vec4<f32>(_e427[0], _e427[1], _e427[2], _e427[3]), vec4<f32>(_e439[0], _e439[1], _e439[2], _e439[3]), vec4<f32>(_e451[0], _e451[1], _e451[2], _e451[3])), _e461, _e465);
                                            }
                                            let _e468 = phi_1503_;
                                            let _e480 = ((_e468.member[0].x - _e251) * _e256);
                                            let _e481 = ((_e468.member[0].y - _e251) * _e256);
                                            let _e482 = ((_e468.member[0].z - _e252) * _e256);
                                            let _e483 = ((_e468.member[0].w - _e252) * _e256);
                                            let _e493 = ((_e468.member[1].x - _e287) * _e292);
                                            let _e494 = ((_e468.member[1].y - _e287) * _e292);
                                            let _e495 = ((_e468.member[1].z - _e288) * _e292);
                                            let _e496 = ((_e468.member[1].w - _e288) * _e292);
                                            let _e506 = ((_e468.member[2].x - _e323) * _e328);
                                            let _e507 = ((_e468.member[2].y - _e323) * _e328);
                                            let _e508 = ((_e468.member[2].z - _e324) * _e328);
                                            let _e509 = ((_e468.member[2].w - _e324) * _e328);
                                            let _e511 = select(_e508, _e506, (_e506 < _e508));
                                            let _e513 = select(_e509, _e507, (_e507 < _e509));
                                            let _e515 = select(_e508, _e506, (_e506 > _e508));
                                            let _e517 = select(_e509, _e507, (_e507 > _e509));
                                            let _e519 = select(_e482, _e480, (_e480 < _e482));
                                            let _e521 = select(_e483, _e481, (_e481 < _e483));
                                            let _e523 = select(_e495, _e493, (_e493 < _e495));
                                            let _e525 = select(_e496, _e494, (_e494 < _e496));
                                            let _e527 = select(_e523, _e519, (_e519 > _e523));
                                            let _e529 = select(_e525, _e521, (_e521 > _e525));
                                            let _e531 = select(_e511, _e527, (_e527 > _e511));
                                            let _e533 = select(_e513, _e529, (_e529 > _e513));
                                            let _e535 = select(_e482, _e480, (_e480 > _e482));
                                            let _e537 = select(_e483, _e481, (_e481 > _e483));
                                            let _e539 = select(_e495, _e493, (_e493 > _e495));
                                            let _e541 = select(_e496, _e494, (_e494 > _e496));
                                            let _e543 = select(_e539, _e535, (_e535 < _e539));
                                            let _e545 = select(_e541, _e537, (_e537 < _e541));
                                            let _e550 = -(_e511);
                                            let _e551 = -(_e513);
                                            let _e558 = (select(_e515, _e543, (_e543 < _e515)) + (select(_e550, _e515, (_e515 > _e550)) * 0.0000019073523f));
                                            let _e559 = (select(_e517, _e545, (_e545 < _e517)) + (select(_e551, _e517, (_e517 > _e551)) * 0.0000019073523f));
                                            let _e561 = select(_e374, _e531, (_e531 > _e374));
                                            let _e563 = select(_e374, _e533, (_e533 > _e374));
                                            let _e568 = (_e561 <= select(_e384.member, _e558, (_e558 < _e384.member)));
                                            let _e569 = (_e563 <= select(_e384.member, _e559, (_e559 < _e384.member)));
                                            let _e570 = (_e561 <= _e563);
                                            if _e568 {
                                                if _e569 {
                                                    if _e570 {
                                                        phi_1847_ = _e468.member_2;
                                                    } else {
                                                        phi_1847_ = _e468.member_1;
                                                    }
                                                    let _e574 = phi_1847_;
                                                    let _e575 = (_e411 % 128u);
                                                    let _e576 = (_e575 < 128u);
                                                    if _e576 {
                                                    } else {
                                                        phi_2080_ = true;
                                                        break;
                                                    }
                                                    local[_e575] = _e574;
                                                    if _e576 {
                                                    } else {
                                                        phi_2080_ = true;
                                                        break;
                                                    }
                                                    local_1[_e575] = select(_e563, _e561, (_e561 > _e563));
                                                    if _e570 {
                                                        phi_1873_ = _e468.member_1;
                                                    } else {
                                                        phi_1873_ = _e468.member_2;
                                                    }
                                                    let _e585 = phi_1873_;
                                                    phi_1874_ = _e585;
                                                    phi_1875_ = (_e411 + 1u);
                                                } else {
                                                    phi_1874_ = u32();
                                                    phi_1875_ = u32();
                                                }
                                                let _e587 = phi_1874_;
                                                let _e589 = phi_1875_;
                                                phi_1877_ = _e587;
                                                phi_1878_ = _e589;
                                                phi_1879_ = select(true, false, _e569);
                                            } else {
                                                phi_1877_ = u32();
                                                phi_1878_ = u32();
                                                phi_1879_ = true;
                                            }
                                            let _e592 = phi_1877_;
                                            let _e594 = phi_1878_;
                                            let _e596 = phi_1879_;
                                            if _e596 {
                                                if _e568 {
                                                    phi_1888_ = _e468.member_1;
                                                } else {
                                                    phi_1888_ = _e468.member_2;
                                                }
                                                let _e600 = phi_1888_;
                                                phi_1893_ = _e600;
                                                phi_1894_ = select(_e569, true, _e568);
                                            } else {
                                                phi_1893_ = _e592;
                                                phi_1894_ = _e409;
                                            }
                                            let _e603 = phi_1893_;
                                            let _e605 = phi_1894_;
                                            phi_2084_ = _e382;
                                            phi_1896_ = _e384;
                                            phi_1897_ = _e603;
                                            phi_1898_ = _e605;
                                            phi_1899_ = select(_e594, _e411, _e596);
                                        }
                                        let _e1011 = phi_2084_;
                                        let _e1013 = phi_1896_;
                                        let _e1015 = phi_1897_;
                                        let _e1017 = phi_1898_;
                                        let _e1019 = phi_1899_;
                                        phi_2083_ = _e1011;
                                        phi_1900_ = _e1013;
                                        phi_1901_ = _e1015;
                                        phi_1902_ = (_e388 - 1u);
                                        phi_1903_ = _e1017;
                                        phi_1904_ = _e1019;
                                    } else {
                                        phi_2083_ = _e382;
                                        phi_1900_ = _e384;
                                        phi_1901_ = _e407;
                                        phi_1902_ = _e388;
                                        phi_1903_ = _e409;
                                        phi_1904_ = _e411;
                                    }
                                    let _e1021 = phi_2083_;
                                    let _e1023 = phi_1900_;
                                    let _e1025 = phi_1901_;
                                    let _e1027 = phi_1902_;
                                    let _e1029 = phi_1903_;
                                    let _e1031 = phi_1904_;
                                    phi_2082_ = _e1021;
                                    phi_1905_ = _e1023;
                                    phi_1906_ = _e1025;
                                    phi_1907_ = _e1027;
                                    phi_1908_ = _e1029;
                                    phi_1909_ = _e1031;
                                } else {
                                    phi_2082_ = _e382;
                                    phi_1905_ = type_45();
                                    phi_1906_ = u32();
                                    phi_1907_ = u32();
                                    phi_1908_ = bool();
                                    phi_1909_ = u32();
                                }
                                let _e1033 = phi_2082_;
                                let _e1035 = phi_1905_;
                                let _e1037 = phi_1906_;
                                let _e1039 = phi_1907_;
                                let _e1041 = phi_1908_;
                                let _e1043 = phi_1909_;
                                phi_2081_ = _e1033;
                                phi_653_ = _e1035;
                                phi_656_ = _e1037;
                                phi_658_ = _e1039;
                                phi_660_ = _e1041;
                                phi_662_ = _e1043;
                                phi_1910_ = _e396;
                            } else {
                                phi_2081_ = _e382;
                                phi_653_ = type_45();
                                phi_656_ = u32();
                                phi_658_ = u32();
                                phi_660_ = bool();
                                phi_662_ = u32();
                                phi_1910_ = false;
                            }
                            let _e1045 = phi_2081_;
                            let _e1047 = phi_653_;
                            let _e1049 = phi_656_;
                            let _e1051 = phi_658_;
                            let _e1053 = phi_660_;
                            let _e1055 = phi_662_;
                            let _e1057 = phi_1910_;
                            continue;
                            continuing {
                                phi_1979_ = _e1045;
                                phi_652_ = _e1047;
                                phi_655_ = _e1049;
                                phi_657_ = _e1051;
                                phi_659_ = _e1053;
                                phi_661_ = _e1055;
                                phi_2080_ = _e1045;
                                break if !(_e1057);
                            }
                        }
                        let _e1060 = phi_2080_;
                        if _e1060 {
                            break;
                        }
                        let _e1062 = local_3;
                        if _e1062.member_1 {
                        } else {
                            if _e74 {
                            } else {
                                break;
                            }
                            let _e1066 = global_4.member[_e72];
                            if _e73 {
                            } else {
                                break;
                            }
                            let _e1070 = global_3.member[_e72].member_1;
                            if _e74 {
                            } else {
                                break;
                            }
                            global_4.member[_e72] = type_18(_e1066.member, _e1066.member_1, _e1066.member_2, array<f32, 3>((_e1066.member_3[0] + (_e1070[0] * _e1066.member_1[0])), (_e1066.member_3[1] + (_e1070[1] * _e1066.member_1[1])), (_e1066.member_3[2] + (_e1070[2] * _e1066.member_1[2]))), _e1066.member_4);
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
