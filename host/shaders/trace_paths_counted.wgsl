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

struct type_19 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<type_19>,
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

struct type_33 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_35 {
    member: array<type_33>,
}

struct type_43 {
    member: type_19,
    member_1: f32,
}

struct type_46 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_48 {
    member: type_43,
    member_1: u32,
    member_2: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_15;
@group(0) @binding(0) 
var<storage> global_2: type_35;
@group(0) @binding(2) 
var<storage> global_3: type_26;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_21;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_4;

fn function_() {
    var local: array<u32, 128>;
    var local_1: array<f32, 128>;
    var phi_265_: i32;
    var phi_266_: i32;
    var phi_276_: bool;
    var phi_286_: u32;
    var phi_287_: u32;
    var phi_289_: bool;
    var phi_294_: u32;
    var phi_338_: f32;
    var phi_344_: f32;
    var phi_355_: f32;
    var phi_361_: f32;
    var phi_384_: f32;
    var phi_395_: f32;
    var phi_404_: f32;
    var phi_410_: f32;
    var phi_421_: f32;
    var phi_427_: f32;
    var phi_450_: f32;
    var phi_461_: f32;
    var phi_470_: f32;
    var phi_476_: f32;
    var phi_487_: f32;
    var phi_493_: f32;
    var phi_516_: f32;
    var phi_527_: f32;
    var phi_627_: f32;
    var phi_628_: f32;
    var phi_2016_: bool;
    var phi_648_: type_48;
    var phi_651_: u32;
    var phi_653_: u32;
    var phi_655_: bool;
    var phi_657_: u32;
    var phi_668_: bool;
    var phi_698_: u32;
    var phi_699_: bool;
    var phi_700_: u32;
    var phi_1527_: type_46;
    var phi_1871_: u32;
    var phi_1897_: u32;
    var phi_1898_: u32;
    var phi_1899_: u32;
    var phi_1901_: u32;
    var phi_1902_: u32;
    var phi_1903_: bool;
    var phi_1912_: u32;
    var phi_1917_: u32;
    var phi_1918_: bool;
    var phi_716_: type_48;
    var phi_719_: type_7;
    var phi_720_: type_7;
    var phi_742_: type_7;
    var phi_765_: u32;
    var phi_853_: array<array<f32, 3>, 3>;
    var phi_1324_: vec3<f32>;
    var phi_1325_: vec3<f32>;
    var phi_1356_: bool;
    var phi_1365_: vec3<f32>;
    var phi_1405_: type_19;
    var phi_1407_: type_19;
    var phi_1408_: bool;
    var phi_1412_: type_19;
    var phi_1413_: type_19;
    var phi_1414_: type_19;
    var phi_1415_: bool;
    var phi_1419_: type_19;
    var phi_1420_: bool;
    var phi_1424_: type_19;
    var phi_1425_: bool;
    var phi_1429_: type_19;
    var phi_1454_: bool;
    var phi_1455_: bool;
    var phi_1462_: type_48;
    var phi_1463_: type_48;
    var phi_1464_: type_48;
    var phi_717_: type_48;
    var phi_2010_: bool;
    var phi_2124_: bool;
    var phi_1920_: type_48;
    var phi_1921_: u32;
    var phi_1922_: bool;
    var phi_1923_: u32;
    var phi_2123_: bool;
    var phi_1924_: type_48;
    var phi_1925_: u32;
    var phi_1926_: u32;
    var phi_1927_: bool;
    var phi_1928_: u32;
    var phi_2122_: bool;
    var phi_1929_: type_48;
    var phi_1930_: u32;
    var phi_1931_: u32;
    var phi_1932_: bool;
    var phi_1933_: u32;
    var phi_2121_: bool;
    var phi_649_: type_48;
    var phi_652_: u32;
    var phi_654_: u32;
    var phi_656_: bool;
    var phi_658_: u32;
    var phi_1934_: bool;
    var phi_2120_: bool;
    var local_2: type_48;
    var phi_1986_: type_19;
    var local_3: type_48;
    var local_4: type_48;

    switch bitcast<i32>(0u) {
        default: {
            let _e61 = global;
            let _e63 = arrayLength((&global_2.member));
            let _e65 = arrayLength((&global_1.member));
            let _e75 = (_e61.x + (_e61.y * 2097152u));
            let _e76 = (_e75 < arrayLength((&global_3.member)));
            if _e76 {
                let _e77 = (_e75 < arrayLength((&global_4.member)));
                if _e77 {
                    let _e78 = (_e75 < arrayLength((&global_5.member)));
                    if _e78 {
                        if _e76 {
                        } else {
                            break;
                        }
                        let _e88 = global_3.member[_e75].member.member_2[0u];
                        let _e90 = (bitcast<u32>(_e88) & 2147483647u);
                        let _e96 = global_3.member[_e75].member.member_2[1u];
                        let _e98 = (bitcast<u32>(_e96) & 2147483647u);
                        let _e104 = global_3.member[_e75].member.member_2[2u];
                        let _e106 = (bitcast<u32>(_e104) & 2147483647u);
                        let _e112 = global_3.member[_e75].member.member[0u];
                        let _e114 = (bitcast<u32>(_e112) & 2147483647u);
                        let _e120 = global_3.member[_e75].member.member[1u];
                        let _e122 = (bitcast<u32>(_e120) & 2147483647u);
                        let _e128 = global_3.member[_e75].member.member[2u];
                        let _e130 = (bitcast<u32>(_e128) & 2147483647u);
                        let _e132 = select(_e98, _e90, (_e98 < _e90));
                        let _e134 = select(_e106, _e132, (_e106 < _e132));
                        let _e136 = select(_e114, _e134, (_e114 < _e134));
                        let _e138 = select(_e122, _e136, (_e122 < _e136));
                        let _e140 = select(_e130, _e138, (_e130 < _e138));
                        let _e145 = global_3.member[_e75].member.member_1;
                        let _e147 = (bitcast<u32>(_e145) & 2147483647u);
                        let _e155 = global_3.member[_e75].member.member_3;
                        let _e161 = (((select(_e147, _e140, (_e147 < _e140)) < 2139095040u) && ((bitcast<u32>(_e155) & 2147483647u) <= 2139095040u)) && (_e134 > 0u));
                        if _e161 {
                            let _e164 = (bitcast<u32>(bitcast<f32>(_e134)) & 2147483647u);
                            if (_e164 >= 8388608u) {
                                phi_265_ = (bitcast<i32>((_e164 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_265_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e164)), 32u, (_e164 == 0u))));
                            }
                            let _e178 = phi_265_;
                            phi_266_ = _e178;
                        } else {
                            phi_266_ = 0i;
                        }
                        let _e180 = phi_266_;
                        let _e181 = (_e90 == _e134);
                        if _e181 {
                            phi_276_ = true;
                        } else {
                            phi_276_ = (_e98 == _e134);
                        }
                        let _e184 = phi_276_;
                        let _e185 = select(1u, 0u, _e181);
                        if _e184 {
                            let _e186 = (_e185 + 1u);
                            phi_286_ = _e186;
                            phi_287_ = _e186;
                            phi_289_ = select(true, false, (_e186 == 2u));
                        } else {
                            phi_286_ = u32();
                            phi_287_ = 0u;
                            phi_289_ = true;
                        }
                        let _e190 = phi_286_;
                        let _e192 = phi_287_;
                        let _e194 = phi_289_;
                        if _e194 {
                            phi_294_ = (_e192 + 1u);
                        } else {
                            phi_294_ = 0u;
                        }
                        let _e198 = phi_294_;
                        let _e199 = select(_e190, _e192, _e194);
                        let _e200 = select(_e185, select(2u, _e185, _e184), _e194);
                        let _e201 = -(_e180);
                        let _e202 = (_e201 / 2i);
                        let _e207 = bitcast<f32>((bitcast<u32>((_e202 + 127i)) << bitcast<u32>(23i)));
                        let _e213 = bitcast<f32>((bitcast<u32>(((_e201 - _e202) + 127i)) << bitcast<u32>(23i)));
                        let _e218 = global_3.member[_e75].member.member;
                        let _e219 = (_e199 == 0u);
                        if _e219 {
                            phi_338_ = _e218[0];
                        } else {
                            phi_338_ = _e218[1];
                        }
                        let _e223 = phi_338_;
                        let _e224 = (_e199 == 2u);
                        if _e224 {
                            phi_344_ = _e218[2];
                        } else {
                            phi_344_ = _e223;
                        }
                        let _e227 = phi_344_;
                        let _e228 = global_3.member[_e75].member.member_2;
                        if _e219 {
                            phi_355_ = _e228[0];
                        } else {
                            phi_355_ = _e228[1];
                        }
                        let _e232 = phi_355_;
                        if _e224 {
                            phi_361_ = _e228[2];
                        } else {
                            phi_361_ = _e232;
                        }
                        let _e235 = phi_361_;
                        let _e237 = ((_e235 * _e207) * _e213);
                        let _e241 = (bitcast<f32>((bitcast<u32>(_e237) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e241 {
                            let _e245 = (bitcast<f32>((bitcast<u32>(_e227) & 2147483647u)) * 0.00000011920929f);
                            phi_384_ = select(0.00000000000011368684f, _e245, (_e245 > 0.00000000000011368684f));
                        } else {
                            phi_384_ = 0f;
                        }
                        let _e249 = phi_384_;
                        let _e250 = (_e227 + _e249);
                        let _e251 = (_e227 - _e249);
                        let _e252 = select(_e237, 0f, _e241);
                        if _e241 {
                            phi_395_ = 38685626000000000000000000f;
                        } else {
                            phi_395_ = (1f / _e237);
                        }
                        let _e255 = phi_395_;
                        let _e256 = (_e198 == 0u);
                        if _e256 {
                            phi_404_ = _e218[0];
                        } else {
                            phi_404_ = _e218[1];
                        }
                        let _e260 = phi_404_;
                        let _e261 = (_e198 == 2u);
                        if _e261 {
                            phi_410_ = _e218[2];
                        } else {
                            phi_410_ = _e260;
                        }
                        let _e264 = phi_410_;
                        if _e256 {
                            phi_421_ = _e228[0];
                        } else {
                            phi_421_ = _e228[1];
                        }
                        let _e268 = phi_421_;
                        if _e261 {
                            phi_427_ = _e228[2];
                        } else {
                            phi_427_ = _e268;
                        }
                        let _e271 = phi_427_;
                        let _e273 = ((_e271 * _e207) * _e213);
                        let _e277 = (bitcast<f32>((bitcast<u32>(_e273) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e277 {
                            let _e281 = (bitcast<f32>((bitcast<u32>(_e264) & 2147483647u)) * 0.00000011920929f);
                            phi_450_ = select(0.00000000000011368684f, _e281, (_e281 > 0.00000000000011368684f));
                        } else {
                            phi_450_ = 0f;
                        }
                        let _e285 = phi_450_;
                        let _e286 = (_e264 + _e285);
                        let _e287 = (_e264 - _e285);
                        let _e288 = select(_e273, 0f, _e277);
                        if _e277 {
                            phi_461_ = 38685626000000000000000000f;
                        } else {
                            phi_461_ = (1f / _e273);
                        }
                        let _e291 = phi_461_;
                        let _e292 = (_e200 == 0u);
                        if _e292 {
                            phi_470_ = _e218[0];
                        } else {
                            phi_470_ = _e218[1];
                        }
                        let _e296 = phi_470_;
                        let _e297 = (_e200 == 2u);
                        if _e297 {
                            phi_476_ = _e218[2];
                        } else {
                            phi_476_ = _e296;
                        }
                        let _e300 = phi_476_;
                        if _e292 {
                            phi_487_ = _e228[0];
                        } else {
                            phi_487_ = _e228[1];
                        }
                        let _e304 = phi_487_;
                        if _e297 {
                            phi_493_ = _e228[2];
                        } else {
                            phi_493_ = _e304;
                        }
                        let _e307 = phi_493_;
                        let _e309 = ((_e307 * _e207) * _e213);
                        let _e313 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e313 {
                            let _e317 = (bitcast<f32>((bitcast<u32>(_e300) & 2147483647u)) * 0.00000011920929f);
                            phi_516_ = select(0.00000000000011368684f, _e317, (_e317 > 0.00000000000011368684f));
                        } else {
                            phi_516_ = 0f;
                        }
                        let _e321 = phi_516_;
                        let _e322 = (_e300 + _e321);
                        let _e323 = (_e300 - _e321);
                        let _e324 = select(_e309, 0f, _e313);
                        if _e313 {
                            phi_527_ = 38685626000000000000000000f;
                        } else {
                            phi_527_ = (1f / _e309);
                        }
                        let _e327 = phi_527_;
                        let _e330 = bitcast<f32>((bitcast<u32>(_e227) & 2147483647u));
                        let _e333 = bitcast<f32>((bitcast<u32>(_e264) & 2147483647u));
                        let _e335 = select(_e333, _e330, (_e330 > _e333));
                        let _e338 = bitcast<f32>((bitcast<u32>(_e300) & 2147483647u));
                        if (_e161 && (select(_e338, _e335, (_e335 > _e338)) <= 1099511600000f)) {
                            let _e343 = (_e180 / 3i);
                            let _e350 = bitcast<f32>((bitcast<u32>((_e343 + 127i)) << bitcast<u32>(23i)));
                            let _e357 = bitcast<f32>((bitcast<u32>(((_e180 - (2i * _e343)) + 127i)) << bitcast<u32>(23i)));
                            let _e358 = (((_e145 * _e350) * _e350) * _e357);
                            let _e360 = select(340282350000000000000000000000000000000f, _e358, (_e358 < 340282350000000000000000000000000000000f));
                            let _e365 = (((_e155 * _e350) * _e350) * _e357);
                            let _e367 = select(340282350000000000000000000000000000000f, _e365, (_e365 < 340282350000000000000000000000000000000f));
                            phi_627_ = select(-340282350000000000000000000000000000000f, _e367, (_e367 > -340282350000000000000000000000000000000f));
                            phi_628_ = select(-340282350000000000000000000000000000000f, _e360, (_e360 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_627_ = 0f;
                            phi_628_ = 1f;
                        }
                        let _e371 = phi_627_;
                        let _e373 = phi_628_;
                        if _e76 {
                        } else {
                            break;
                        }
                        let _e379 = global_3.member[_e75].member_2;
                        local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2016_ = false;
                        phi_648_ = type_48(type_43(type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e371), 0u, 0u);
                        phi_651_ = select(0u, 2147483648u, (_e63 == 0u));
                        phi_653_ = ((3u * _e63) + 1u);
                        phi_655_ = (_e373 <= _e371);
                        phi_657_ = 0u;
                        loop {
                            let _e386 = phi_2016_;
                            let _e388 = phi_648_;
                            let _e390 = phi_651_;
                            let _e392 = phi_653_;
                            let _e394 = phi_655_;
                            let _e396 = phi_657_;
                            local_2 = _e388;
                            local_3 = _e388;
                            if _e394 {
                                phi_668_ = true;
                            } else {
                                phi_668_ = (_e396 > 0u);
                            }
                            let _e399 = phi_668_;
                            if _e399 {
                                let _e400 = (_e392 > 0u);
                                if _e400 {
                                    if _e394 {
                                        phi_698_ = _e390;
                                        phi_699_ = _e394;
                                        phi_700_ = _e396;
                                    } else {
                                        let _e401 = (_e396 - 1u);
                                        let _e402 = (_e401 % 128u);
                                        let _e403 = (_e402 < 128u);
                                        if _e403 {
                                        } else {
                                            phi_2120_ = true;
                                            break;
                                        }
                                        let _e405 = local[_e402];
                                        if _e403 {
                                        } else {
                                            phi_2120_ = true;
                                            break;
                                        }
                                        let _e407 = local_1[_e402];
                                        phi_698_ = _e405;
                                        phi_699_ = (_e407 <= _e388.member.member_1);
                                        phi_700_ = _e401;
                                    }
                                    let _e412 = phi_698_;
                                    let _e414 = phi_699_;
                                    let _e416 = phi_700_;
                                    if _e414 {
                                        let _e420 = (_e412 & 268435455u);
                                        if ((_e412 & 2147483648u) != 0u) {
                                            phi_716_ = _e388;
                                            phi_719_ = type_7(_e420, (_e420 + ((_e412 >> bitcast<u32>(28u)) & 7u)));
                                            loop {
                                                let _e622 = phi_716_;
                                                let _e624 = phi_719_;
                                                local_4 = _e622;
                                                if (_e624.member < _e624.member_1) {
                                                    phi_720_ = type_7((_e624.member + 1u), _e624.member_1);
                                                    phi_742_ = type_7(1u, _e624.member);
                                                } else {
                                                    phi_720_ = _e624;
                                                    phi_742_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e637 = phi_720_;
                                                let _e639 = phi_742_;
                                                let _e643 = (bitcast<i32>(_e639.member) != 0i);
                                                if _e643 {
                                                    let _e649 = type_48(_e622.member, _e622.member_1, (_e622.member_2 + 1u));
                                                    let _e650 = (_e639.member_1 < _e65);
                                                    if _e650 {
                                                        if _e650 {
                                                        } else {
                                                            phi_2010_ = true;
                                                            break;
                                                        }
                                                        let _e654 = global_1.member[_e639.member_1].member_1;
                                                        phi_765_ = _e654;
                                                    } else {
                                                        phi_765_ = 4294967295u;
                                                    }
                                                    let _e656 = phi_765_;
                                                    if (_e639.member_1 >= _e65) {
                                                        phi_853_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e650 {
                                                        } else {
                                                            phi_2010_ = true;
                                                            break;
                                                        }
                                                        let _e658 = (_e199 % 3u);
                                                        let _e659 = (_e198 % 3u);
                                                        let _e660 = (_e200 % 3u);
                                                        if (_e658 < 9u) {
                                                        } else {
                                                            phi_2010_ = true;
                                                            break;
                                                        }
                                                        let _e666 = global_1.member[_e639.member_1].member[_e658];
                                                        if (_e659 < 9u) {
                                                        } else {
                                                            phi_2010_ = true;
                                                            break;
                                                        }
                                                        let _e672 = global_1.member[_e639.member_1].member[_e659];
                                                        if (_e660 < 9u) {
                                                        } else {
                                                            phi_2010_ = true;
                                                            break;
                                                        }
                                                        let _e678 = global_1.member[_e639.member_1].member[_e660];
                                                        let _e680 = (3u + _e658);
                                                        if (_e680 < 9u) {
                                                        } else {
                                                            phi_2010_ = true;
                                                            break;
                                                        }
                                                        let _e686 = global_1.member[_e639.member_1].member[_e680];
                                                        let _e687 = (3u + _e659);
                                                        if (_e687 < 9u) {
                                                        } else {
                                                            phi_2010_ = true;
                                                            break;
                                                        }
                                                        let _e693 = global_1.member[_e639.member_1].member[_e687];
                                                        let _e694 = (3u + _e660);
                                                        if (_e694 < 9u) {
                                                        } else {
                                                            phi_2010_ = true;
                                                            break;
                                                        }
                                                        let _e700 = global_1.member[_e639.member_1].member[_e694];
                                                        let _e702 = (6u + _e658);
                                                        if (_e702 < 9u) {
                                                        } else {
                                                            phi_2010_ = true;
                                                            break;
                                                        }
                                                        let _e708 = global_1.member[_e639.member_1].member[_e702];
                                                        let _e709 = (6u + _e659);
                                                        if (_e709 < 9u) {
                                                        } else {
                                                            phi_2010_ = true;
                                                            break;
                                                        }
                                                        let _e715 = global_1.member[_e639.member_1].member[_e709];
                                                        let _e716 = (6u + _e660);
                                                        if (_e716 < 9u) {
                                                        } else {
                                                            phi_2010_ = true;
                                                            break;
                                                        }
                                                        let _e722 = global_1.member[_e639.member_1].member[_e716];
                                                        phi_853_ = array<array<f32, 3>, 3>(array<f32, 3>(_e666, _e672, _e678), array<f32, 3>(_e686, _e693, _e700), array<f32, 3>(_e708, _e715, _e722));
                                                    }
                                                    let _e726 = phi_853_;
                                                    let _e735 = (_e726[0][2] - _e300);
                                                    let _e738 = (((_e726[0][0] - _e227) * _e324) - (_e735 * _e252));
                                                    let _e741 = (((_e726[0][1] - _e264) * _e324) - (_e735 * _e288));
                                                    let _e748 = (_e726[1][2] - _e300);
                                                    let _e751 = (((_e726[1][0] - _e227) * _e324) - (_e748 * _e252));
                                                    let _e754 = (((_e726[1][1] - _e264) * _e324) - (_e748 * _e288));
                                                    let _e761 = (_e726[2][2] - _e300);
                                                    let _e764 = (((_e726[2][0] - _e227) * _e324) - (_e761 * _e252));
                                                    let _e767 = (((_e726[2][1] - _e264) * _e324) - (_e761 * _e288));
                                                    let _e768 = (_e764 * _e754);
                                                    let _e769 = (_e767 * _e751);
                                                    let _e770 = (_e738 * _e767);
                                                    let _e771 = (_e741 * _e764);
                                                    let _e772 = (_e751 * _e741);
                                                    let _e773 = (_e754 * _e738);
                                                    let _e778 = (((_e768 >= _e769) && (_e770 >= _e771)) && (_e772 >= _e773));
                                                    if (_e778 || (((_e768 <= _e769) && (_e770 <= _e771)) && (_e772 <= _e773))) {
                                                        let _e785 = select(-1f, 1f, _e778);
                                                        let _e787 = ((_e768 - _e769) * _e785);
                                                        let _e789 = select(0f, _e787, (_e787 > 0f));
                                                        let _e791 = ((_e770 - _e771) * _e785);
                                                        let _e793 = select(0f, _e791, (_e791 > 0f));
                                                        let _e795 = ((_e772 - _e773) * _e785);
                                                        let _e797 = select(0f, _e795, (_e795 > 0f));
                                                        let _e799 = ((_e789 + _e793) + _e797);
                                                        if (_e799 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1419_ = type_19();
                                                            phi_1420_ = true;
                                                        } else {
                                                            let _e802 = select(_e726[1][0], _e726[0][0], (_e726[0][0] < _e726[1][0]));
                                                            let _e806 = select(_e726[1][0], _e726[0][0], (_e726[0][0] > _e726[1][0]));
                                                            let _e810 = select(_e726[1][1], _e726[0][1], (_e726[0][1] < _e726[1][1]));
                                                            let _e814 = select(_e726[1][1], _e726[0][1], (_e726[0][1] > _e726[1][1]));
                                                            let _e818 = select(_e726[1][2], _e726[0][2], (_e726[0][2] < _e726[1][2]));
                                                            let _e822 = select(_e726[1][2], _e726[0][2], (_e726[0][2] > _e726[1][2]));
                                                            let _e827 = ((select(_e726[2][0], _e802, (_e802 < _e726[2][0])) - _e250) * _e255);
                                                            let _e828 = ((select(_e726[2][0], _e806, (_e806 > _e726[2][0])) - _e251) * _e255);
                                                            let _e831 = ((select(_e726[2][1], _e810, (_e810 < _e726[2][1])) - _e286) * _e291);
                                                            let _e832 = ((select(_e726[2][1], _e814, (_e814 > _e726[2][1])) - _e287) * _e291);
                                                            let _e835 = ((select(_e726[2][2], _e818, (_e818 < _e726[2][2])) - _e322) * _e327);
                                                            let _e836 = ((select(_e726[2][2], _e822, (_e822 > _e726[2][2])) - _e323) * _e327);
                                                            let _e838 = select(_e836, _e835, (_e835 < _e836));
                                                            let _e840 = select(_e836, _e835, (_e835 > _e836));
                                                            let _e842 = select(_e828, _e827, (_e827 < _e828));
                                                            let _e844 = select(_e832, _e831, (_e831 < _e832));
                                                            let _e846 = select(_e844, _e842, (_e842 > _e844));
                                                            let _e848 = select(_e838, _e846, (_e846 > _e838));
                                                            let _e850 = select(_e828, _e827, (_e827 > _e828));
                                                            let _e852 = select(_e832, _e831, (_e831 > _e832));
                                                            let _e854 = select(_e852, _e850, (_e850 < _e852));
                                                            let _e856 = select(_e840, _e854, (_e854 < _e840));
                                                            let _e857 = -(_e838);
                                                            let _e863 = select(_e373, _e848, (_e848 > _e373));
                                                            if (_e863 > (_e856 + (select(_e857, _e840, (_e840 > _e857)) * 0.0000019073523f))) {
                                                                phi_1414_ = type_19();
                                                                phi_1415_ = true;
                                                            } else {
                                                                let _e865 = (_e863 > _e622.member.member_1);
                                                                if _e865 {
                                                                    phi_1413_ = type_19();
                                                                } else {
                                                                    let _e869 = (_e726[1][0] - _e726[0][0]);
                                                                    let _e870 = (_e726[1][1] - _e726[0][1]);
                                                                    let _e871 = (_e726[1][2] - _e726[0][2]);
                                                                    let _e872 = vec3<f32>(_e869, _e870, _e871);
                                                                    let _e873 = (_e726[2][0] - _e726[1][0]);
                                                                    let _e874 = (_e726[2][1] - _e726[1][1]);
                                                                    let _e875 = (_e726[2][2] - _e726[1][2]);
                                                                    let _e876 = vec3<f32>(_e873, _e874, _e875);
                                                                    let _e877 = (_e726[0][0] - _e726[2][0]);
                                                                    let _e878 = (_e726[0][1] - _e726[2][1]);
                                                                    let _e879 = (_e726[0][2] - _e726[2][2]);
                                                                    let _e880 = vec3<f32>(_e877, _e878, _e879);
                                                                    let _e883 = bitcast<f32>((bitcast<u32>(_e869) & 2147483647u));
                                                                    let _e886 = bitcast<f32>((bitcast<u32>(_e870) & 2147483647u));
                                                                    let _e888 = select(_e886, _e883, (_e883 > _e886));
                                                                    let _e891 = bitcast<f32>((bitcast<u32>(_e871) & 2147483647u));
                                                                    let _e893 = select(_e891, _e888, (_e888 > _e891));
                                                                    let _e896 = bitcast<f32>((bitcast<u32>(_e873) & 2147483647u));
                                                                    let _e899 = bitcast<f32>((bitcast<u32>(_e874) & 2147483647u));
                                                                    let _e901 = select(_e899, _e896, (_e896 > _e899));
                                                                    let _e904 = bitcast<f32>((bitcast<u32>(_e875) & 2147483647u));
                                                                    let _e906 = select(_e904, _e901, (_e901 > _e904));
                                                                    let _e909 = bitcast<f32>((bitcast<u32>(_e877) & 2147483647u));
                                                                    let _e912 = bitcast<f32>((bitcast<u32>(_e878) & 2147483647u));
                                                                    let _e914 = select(_e912, _e909, (_e909 > _e912));
                                                                    let _e917 = bitcast<f32>((bitcast<u32>(_e879) & 2147483647u));
                                                                    let _e919 = select(_e917, _e914, (_e914 > _e917));
                                                                    let _e921 = select(_e906, _e893, (_e893 > _e906));
                                                                    let _e923 = select(_e919, _e921, (_e921 > _e919));
                                                                    if (_e893 == _e923) {
                                                                        phi_1324_ = _e876;
                                                                        phi_1325_ = _e880;
                                                                    } else {
                                                                        let _e926 = vec3((_e906 == _e923));
                                                                        phi_1324_ = select(_e872, _e880, _e926);
                                                                        phi_1325_ = select(_e876, _e872, _e926);
                                                                    }
                                                                    let _e930 = phi_1324_;
                                                                    let _e932 = phi_1325_;
                                                                    let _e939 = ((_e930.y * _e932.z) - (_e932.y * _e930.z));
                                                                    let _e944 = ((_e930.z * _e932.x) - (_e932.z * _e930.x));
                                                                    let _e947 = ((_e930.x * _e932.y) - (_e932.x * _e930.y));
                                                                    if (_e789 >= _e793) {
                                                                        phi_1356_ = select(true, false, (_e789 >= _e797));
                                                                    } else {
                                                                        phi_1356_ = true;
                                                                    }
                                                                    let _e952 = phi_1356_;
                                                                    if _e952 {
                                                                        phi_1365_ = select(vec3<f32>(_e726[2][0], _e726[2][1], _e726[2][2]), vec3<f32>(_e726[1][0], _e726[1][1], _e726[1][2]), vec3((_e793 >= _e797)));
                                                                    } else {
                                                                        phi_1365_ = vec3<f32>(_e726[0][0], _e726[0][1], _e726[0][2]);
                                                                    }
                                                                    let _e957 = phi_1365_;
                                                                    let _e974 = ((((_e939 * (_e957.x - _e227)) + (_e944 * (_e957.y - _e264))) + (_e947 * (_e957.z - _e300))) / (((_e939 * _e252) + (_e944 * _e288)) + (_e947 * _e324)));
                                                                    let _e976 = select(_e856, _e974, (_e974 < _e856));
                                                                    let _e978 = select(_e848, _e976, (_e976 > _e848));
                                                                    if (_e978 >= _e373) {
                                                                        let _e980 = (_e978 <= _e622.member.member_1);
                                                                        if _e980 {
                                                                            let _e981 = (1f / _e799);
                                                                            phi_1405_ = type_19(_e978, (_e793 * _e981), (_e797 * _e981), _e656);
                                                                        } else {
                                                                            phi_1405_ = type_19();
                                                                        }
                                                                        let _e986 = phi_1405_;
                                                                        phi_1407_ = _e986;
                                                                        phi_1408_ = select(true, false, _e980);
                                                                    } else {
                                                                        phi_1407_ = type_19();
                                                                        phi_1408_ = true;
                                                                    }
                                                                    let _e989 = phi_1407_;
                                                                    let _e991 = phi_1408_;
                                                                    if _e991 {
                                                                        phi_1412_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1412_ = _e989;
                                                                    }
                                                                    let _e993 = phi_1412_;
                                                                    phi_1413_ = _e993;
                                                                }
                                                                let _e995 = phi_1413_;
                                                                phi_1414_ = _e995;
                                                                phi_1415_ = _e865;
                                                            }
                                                            let _e997 = phi_1414_;
                                                            let _e999 = phi_1415_;
                                                            phi_1419_ = _e997;
                                                            phi_1420_ = _e999;
                                                        }
                                                        let _e1001 = phi_1419_;
                                                        let _e1003 = phi_1420_;
                                                        phi_1424_ = _e1001;
                                                        phi_1425_ = _e1003;
                                                    } else {
                                                        phi_1424_ = type_19();
                                                        phi_1425_ = true;
                                                    }
                                                    let _e1005 = phi_1424_;
                                                    let _e1007 = phi_1425_;
                                                    if _e1007 {
                                                        phi_1429_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1429_ = _e1005;
                                                    }
                                                    let _e1009 = phi_1429_;
                                                    if (_e1009.member_3 != 4294967295u) {
                                                        if (_e656 != _e379) {
                                                            if (_e1009.member < _e622.member.member.member) {
                                                                phi_1455_ = true;
                                                            } else {
                                                                if (_e1009.member == _e622.member.member.member) {
                                                                    phi_1454_ = (_e1009.member_3 < _e622.member.member.member_3);
                                                                } else {
                                                                    phi_1454_ = false;
                                                                }
                                                                let _e1024 = phi_1454_;
                                                                phi_1455_ = _e1024;
                                                            }
                                                            let _e1026 = phi_1455_;
                                                            if _e1026 {
                                                                phi_1462_ = type_48(type_43(_e1009, _e1009.member), _e649.member_1, _e649.member_2);
                                                            } else {
                                                                phi_1462_ = _e649;
                                                            }
                                                            let _e1033 = phi_1462_;
                                                            phi_1463_ = _e1033;
                                                        } else {
                                                            phi_1463_ = _e649;
                                                        }
                                                        let _e1035 = phi_1463_;
                                                        phi_1464_ = _e1035;
                                                    } else {
                                                        phi_1464_ = _e649;
                                                    }
                                                    let _e1037 = phi_1464_;
                                                    phi_717_ = _e1037;
                                                } else {
                                                    phi_717_ = type_48();
                                                }
                                                let _e1039 = phi_717_;
                                                continue;
                                                continuing {
                                                    phi_716_ = _e1039;
                                                    phi_719_ = _e637;
                                                    phi_2010_ = _e386;
                                                    break if !(_e643);
                                                }
                                            }
                                            let _e1042 = phi_2010_;
                                            phi_2120_ = _e1042;
                                            if _e1042 {
                                                break;
                                            }
                                            phi_2124_ = _e1042;
                                            let _e1213 = local_4;
                                            phi_1920_ = _e1213;
                                            phi_1921_ = _e412;
                                            phi_1922_ = false;
                                            phi_1923_ = _e416;
                                        } else {
                                            if (_e412 >= _e63) {
                                                phi_1527_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e412 < _e63) {
                                                } else {
                                                    phi_2120_ = true;
                                                    break;
                                                }
                                                let _e432 = (_e199 % 3u);
                                                if (_e432 < 3u) {
                                                } else {
                                                    phi_2120_ = true;
                                                    break;
                                                }
                                                let _e438 = global_2.member[_e412].member[_e432];
                                                let _e444 = (_e198 % 3u);
                                                if (_e444 < 3u) {
                                                } else {
                                                    phi_2120_ = true;
                                                    break;
                                                }
                                                let _e450 = global_2.member[_e412].member[_e444];
                                                let _e456 = (_e200 % 3u);
                                                if (_e456 < 3u) {
                                                } else {
                                                    phi_2120_ = true;
                                                    break;
                                                }
                                                let _e462 = global_2.member[_e412].member[_e456];
                                                let _e472 = global_2.member[_e412].member_1;
                                                let _e476 = global_2.member[_e412].member_2;
                                                phi_1527_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e438[0], _e438[1], _e438[2], _e438[3]), vec4<f32>(_e450[0], _e450[1], _e450[2], _e450[3]), vec4<f32>(_e462[0], _e462[1], _e462[2], _e462[3])), _e472, _e476);
                                            }
                                            let _e479 = phi_1527_;
                                            let _e492 = ((_e479.member[0].x - _e250) * _e255);
                                            let _e493 = ((_e479.member[0].y - _e250) * _e255);
                                            let _e494 = ((_e479.member[0].z - _e251) * _e255);
                                            let _e495 = ((_e479.member[0].w - _e251) * _e255);
                                            let _e505 = ((_e479.member[1].x - _e286) * _e291);
                                            let _e506 = ((_e479.member[1].y - _e286) * _e291);
                                            let _e507 = ((_e479.member[1].z - _e287) * _e291);
                                            let _e508 = ((_e479.member[1].w - _e287) * _e291);
                                            let _e518 = ((_e479.member[2].x - _e322) * _e327);
                                            let _e519 = ((_e479.member[2].y - _e322) * _e327);
                                            let _e520 = ((_e479.member[2].z - _e323) * _e327);
                                            let _e521 = ((_e479.member[2].w - _e323) * _e327);
                                            let _e523 = select(_e520, _e518, (_e518 < _e520));
                                            let _e525 = select(_e521, _e519, (_e519 < _e521));
                                            let _e527 = select(_e520, _e518, (_e518 > _e520));
                                            let _e529 = select(_e521, _e519, (_e519 > _e521));
                                            let _e531 = select(_e494, _e492, (_e492 < _e494));
                                            let _e533 = select(_e495, _e493, (_e493 < _e495));
                                            let _e535 = select(_e507, _e505, (_e505 < _e507));
                                            let _e537 = select(_e508, _e506, (_e506 < _e508));
                                            let _e539 = select(_e535, _e531, (_e531 > _e535));
                                            let _e541 = select(_e537, _e533, (_e533 > _e537));
                                            let _e543 = select(_e523, _e539, (_e539 > _e523));
                                            let _e545 = select(_e525, _e541, (_e541 > _e525));
                                            let _e547 = select(_e494, _e492, (_e492 > _e494));
                                            let _e549 = select(_e495, _e493, (_e493 > _e495));
                                            let _e551 = select(_e507, _e505, (_e505 > _e507));
                                            let _e553 = select(_e508, _e506, (_e506 > _e508));
                                            let _e555 = select(_e551, _e547, (_e547 < _e551));
                                            let _e557 = select(_e553, _e549, (_e549 < _e553));
                                            let _e562 = -(_e523);
                                            let _e563 = -(_e525);
                                            let _e570 = (select(_e527, _e555, (_e555 < _e527)) + (select(_e562, _e527, (_e527 > _e562)) * 0.0000019073523f));
                                            let _e571 = (select(_e529, _e557, (_e557 < _e529)) + (select(_e563, _e529, (_e529 > _e563)) * 0.0000019073523f));
                                            let _e573 = select(_e373, _e543, (_e543 > _e373));
                                            let _e575 = select(_e373, _e545, (_e545 > _e373));
                                            let _e580 = (_e573 <= select(_e388.member.member_1, _e570, (_e570 < _e388.member.member_1)));
                                            let _e581 = (_e575 <= select(_e388.member.member_1, _e571, (_e571 < _e388.member.member_1)));
                                            let _e582 = (_e573 <= _e575);
                                            if _e580 {
                                                if _e581 {
                                                    if _e582 {
                                                        phi_1871_ = _e479.member_2;
                                                    } else {
                                                        phi_1871_ = _e479.member_1;
                                                    }
                                                    let _e586 = phi_1871_;
                                                    let _e587 = (_e416 % 128u);
                                                    let _e588 = (_e587 < 128u);
                                                    if _e588 {
                                                    } else {
                                                        phi_2120_ = true;
                                                        break;
                                                    }
                                                    local[_e587] = _e586;
                                                    if _e588 {
                                                    } else {
                                                        phi_2120_ = true;
                                                        break;
                                                    }
                                                    local_1[_e587] = select(_e575, _e573, (_e573 > _e575));
                                                    if _e582 {
                                                        phi_1897_ = _e479.member_1;
                                                    } else {
                                                        phi_1897_ = _e479.member_2;
                                                    }
                                                    let _e597 = phi_1897_;
                                                    phi_1898_ = _e597;
                                                    phi_1899_ = (_e416 + 1u);
                                                } else {
                                                    phi_1898_ = u32();
                                                    phi_1899_ = u32();
                                                }
                                                let _e599 = phi_1898_;
                                                let _e601 = phi_1899_;
                                                phi_1901_ = _e599;
                                                phi_1902_ = _e601;
                                                phi_1903_ = select(true, false, _e581);
                                            } else {
                                                phi_1901_ = u32();
                                                phi_1902_ = u32();
                                                phi_1903_ = true;
                                            }
                                            let _e604 = phi_1901_;
                                            let _e606 = phi_1902_;
                                            let _e608 = phi_1903_;
                                            if _e608 {
                                                if _e580 {
                                                    phi_1912_ = _e479.member_1;
                                                } else {
                                                    phi_1912_ = _e479.member_2;
                                                }
                                                let _e612 = phi_1912_;
                                                phi_1917_ = _e612;
                                                phi_1918_ = select(_e581, true, _e580);
                                            } else {
                                                phi_1917_ = _e604;
                                                phi_1918_ = _e414;
                                            }
                                            let _e615 = phi_1917_;
                                            let _e617 = phi_1918_;
                                            phi_2124_ = _e386;
                                            phi_1920_ = type_48(_e388.member, (_e388.member_1 + 1u), _e388.member_2);
                                            phi_1921_ = _e615;
                                            phi_1922_ = _e617;
                                            phi_1923_ = select(_e606, _e416, _e608);
                                        }
                                        let _e1044 = phi_2124_;
                                        let _e1046 = phi_1920_;
                                        let _e1048 = phi_1921_;
                                        let _e1050 = phi_1922_;
                                        let _e1052 = phi_1923_;
                                        phi_2123_ = _e1044;
                                        phi_1924_ = _e1046;
                                        phi_1925_ = _e1048;
                                        phi_1926_ = (_e392 - 1u);
                                        phi_1927_ = _e1050;
                                        phi_1928_ = _e1052;
                                    } else {
                                        phi_2123_ = _e386;
                                        phi_1924_ = _e388;
                                        phi_1925_ = _e412;
                                        phi_1926_ = _e392;
                                        phi_1927_ = _e414;
                                        phi_1928_ = _e416;
                                    }
                                    let _e1054 = phi_2123_;
                                    let _e1056 = phi_1924_;
                                    let _e1058 = phi_1925_;
                                    let _e1060 = phi_1926_;
                                    let _e1062 = phi_1927_;
                                    let _e1064 = phi_1928_;
                                    phi_2122_ = _e1054;
                                    phi_1929_ = _e1056;
                                    phi_1930_ = _e1058;
                                    phi_1931_ = _e1060;
                                    phi_1932_ = _e1062;
                                    phi_1933_ = _e1064;
                                } else {
                                    phi_2122_ = _e386;
                                    phi_1929_ = type_48();
                                    phi_1930_ = u32();
                                    phi_1931_ = u32();
                                    phi_1932_ = bool();
                                    phi_1933_ = u32();
                                }
                                let _e1066 = phi_2122_;
                                let _e1068 = phi_1929_;
                                let _e1070 = phi_1930_;
                                let _e1072 = phi_1931_;
                                let _e1074 = phi_1932_;
                                let _e1076 = phi_1933_;
                                phi_2121_ = _e1066;
                                phi_649_ = _e1068;
                                phi_652_ = _e1070;
                                phi_654_ = _e1072;
                                phi_656_ = _e1074;
                                phi_658_ = _e1076;
                                phi_1934_ = _e400;
                            } else {
                                phi_2121_ = _e386;
                                phi_649_ = type_48();
                                phi_652_ = u32();
                                phi_654_ = u32();
                                phi_656_ = bool();
                                phi_658_ = u32();
                                phi_1934_ = false;
                            }
                            let _e1078 = phi_2121_;
                            let _e1080 = phi_649_;
                            let _e1082 = phi_652_;
                            let _e1084 = phi_654_;
                            let _e1086 = phi_656_;
                            let _e1088 = phi_658_;
                            let _e1090 = phi_1934_;
                            continue;
                            continuing {
                                phi_2016_ = _e1078;
                                phi_648_ = _e1080;
                                phi_651_ = _e1082;
                                phi_653_ = _e1084;
                                phi_655_ = _e1086;
                                phi_657_ = _e1088;
                                phi_2120_ = _e1078;
                                break if !(_e1090);
                            }
                        }
                        let _e1093 = phi_2120_;
                        if _e1093 {
                            break;
                        }
                        let _e1095 = local_2;
                        if (_e1095.member.member.member_3 != 4294967295u) {
                            let _e1101 = (_e201 / 3i);
                            let _e1108 = bitcast<f32>((bitcast<u32>((_e1101 + 127i)) << bitcast<u32>(23i)));
                            let _e1116 = (((_e1095.member.member.member * _e1108) * _e1108) * bitcast<f32>((bitcast<u32>(((_e201 - (2i * _e1101)) + 127i)) << bitcast<u32>(23i))));
                            let _e1118 = select(340282350000000000000000000000000000000f, _e1116, (_e1116 < 340282350000000000000000000000000000000f));
                            phi_1986_ = type_19(select(-340282350000000000000000000000000000000f, _e1118, (_e1118 > -340282350000000000000000000000000000000f)), _e1095.member.member.member_1, _e1095.member.member.member_2, _e1095.member.member.member_3);
                        } else {
                            phi_1986_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1125 = phi_1986_;
                        if _e77 {
                        } else {
                            break;
                        }
                        global_4.member[_e75] = _e1125;
                        let _e1129 = local_3;
                        if _e78 {
                        } else {
                            break;
                        }
                        global_5.member[_e75] = _e1129.member_1;
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_paths_counted(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
