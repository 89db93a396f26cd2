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

struct type_18 {
    member: array<type_16>,
}

struct type_20 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_21 {
    member: type_20,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_23 {
    member: array<type_21>,
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

struct type_40 {
    member: type_16,
    member_1: f32,
}

struct type_43 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_12;
@group(0) @binding(0) 
var<storage> global_2: type_32;
@group(0) @binding(2) 
var<storage> global_3: type_23;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_18;

fn function_() {
    var local: array<u32, 128>;
    var local_1: array<f32, 128>;
    var phi_261_: i32;
    var phi_262_: i32;
    var phi_272_: bool;
    var phi_282_: u32;
    var phi_283_: u32;
    var phi_285_: bool;
    var phi_290_: u32;
    var phi_334_: f32;
    var phi_340_: f32;
    var phi_351_: f32;
    var phi_357_: f32;
    var phi_380_: f32;
    var phi_391_: f32;
    var phi_400_: f32;
    var phi_406_: f32;
    var phi_417_: f32;
    var phi_423_: f32;
    var phi_446_: f32;
    var phi_457_: f32;
    var phi_466_: f32;
    var phi_472_: f32;
    var phi_483_: f32;
    var phi_489_: f32;
    var phi_512_: f32;
    var phi_523_: f32;
    var phi_623_: f32;
    var phi_624_: f32;
    var phi_1989_: bool;
    var phi_635_: type_40;
    var phi_638_: u32;
    var phi_640_: u32;
    var phi_642_: bool;
    var phi_644_: u32;
    var phi_655_: bool;
    var phi_685_: u32;
    var phi_686_: bool;
    var phi_687_: u32;
    var phi_1507_: type_43;
    var phi_1851_: u32;
    var phi_1877_: u32;
    var phi_1878_: u32;
    var phi_1879_: u32;
    var phi_1881_: u32;
    var phi_1882_: u32;
    var phi_1883_: bool;
    var phi_1892_: u32;
    var phi_1897_: u32;
    var phi_1898_: bool;
    var phi_703_: type_40;
    var phi_706_: type_4;
    var phi_707_: type_4;
    var phi_729_: type_4;
    var phi_749_: u32;
    var phi_837_: array<array<f32, 3>, 3>;
    var phi_1308_: vec3<f32>;
    var phi_1309_: vec3<f32>;
    var phi_1340_: bool;
    var phi_1349_: vec3<f32>;
    var phi_1389_: type_16;
    var phi_1391_: type_16;
    var phi_1392_: bool;
    var phi_1396_: type_16;
    var phi_1397_: type_16;
    var phi_1398_: type_16;
    var phi_1399_: bool;
    var phi_1403_: type_16;
    var phi_1404_: bool;
    var phi_1408_: type_16;
    var phi_1409_: bool;
    var phi_1413_: type_16;
    var phi_1438_: bool;
    var phi_1439_: bool;
    var phi_1445_: type_40;
    var phi_1446_: type_40;
    var phi_1447_: type_40;
    var phi_704_: type_40;
    var phi_1983_: bool;
    var phi_2097_: bool;
    var phi_1900_: type_40;
    var phi_1901_: u32;
    var phi_1902_: bool;
    var phi_1903_: u32;
    var phi_2096_: bool;
    var phi_1904_: type_40;
    var phi_1905_: u32;
    var phi_1906_: u32;
    var phi_1907_: bool;
    var phi_1908_: u32;
    var phi_2095_: bool;
    var phi_1909_: type_40;
    var phi_1910_: u32;
    var phi_1911_: u32;
    var phi_1912_: bool;
    var phi_1913_: u32;
    var phi_2094_: bool;
    var phi_636_: type_40;
    var phi_639_: u32;
    var phi_641_: u32;
    var phi_643_: bool;
    var phi_645_: u32;
    var phi_1914_: bool;
    var phi_2093_: bool;
    var local_2: type_40;
    var phi_1966_: type_16;
    var local_3: type_40;

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
                    if _e73 {
                    } else {
                        break;
                    }
                    let _e78 = global_3.member[_e72].member_2;
                    let _e88 = global_3.member[_e72].member.member_2[0u];
                    let _e90 = (bitcast<u32>(_e88) & 2147483647u);
                    let _e96 = global_3.member[_e72].member.member_2[1u];
                    let _e98 = (bitcast<u32>(_e96) & 2147483647u);
                    let _e104 = global_3.member[_e72].member.member_2[2u];
                    let _e106 = (bitcast<u32>(_e104) & 2147483647u);
                    let _e112 = global_3.member[_e72].member.member[0u];
                    let _e114 = (bitcast<u32>(_e112) & 2147483647u);
                    let _e120 = global_3.member[_e72].member.member[1u];
                    let _e122 = (bitcast<u32>(_e120) & 2147483647u);
                    let _e128 = global_3.member[_e72].member.member[2u];
                    let _e130 = (bitcast<u32>(_e128) & 2147483647u);
                    let _e132 = select(_e98, _e90, (_e98 < _e90));
                    let _e134 = select(_e106, _e132, (_e106 < _e132));
                    let _e136 = select(_e114, _e134, (_e114 < _e134));
                    let _e138 = select(_e122, _e136, (_e122 < _e136));
                    let _e140 = select(_e130, _e138, (_e130 < _e138));
                    let _e145 = global_3.member[_e72].member.member_1;
                    let _e147 = (bitcast<u32>(_e145) & 2147483647u);
                    let _e155 = global_3.member[_e72].member.member_3;
                    let _e161 = (((select(_e147, _e140, (_e147 < _e140)) < 2139095040u) && ((bitcast<u32>(_e155) & 2147483647u) <= 2139095040u)) && (_e134 > 0u));
                    if _e161 {
                        let _e164 = (bitcast<u32>(bitcast<f32>(_e134)) & 2147483647u);
                        if (_e164 >= 8388608u) {
                            phi_261_ = (bitcast<i32>((_e164 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_261_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e164)), 32u, (_e164 == 0u))));
                        }
                        let _e178 = phi_261_;
                        phi_262_ = _e178;
                    } else {
                        phi_262_ = 0i;
                    }
                    let _e180 = phi_262_;
                    let _e181 = (_e90 == _e134);
                    if _e181 {
                        phi_272_ = true;
                    } else {
                        phi_272_ = (_e98 == _e134);
                    }
                    let _e184 = phi_272_;
                    let _e185 = select(1u, 0u, _e181);
                    if _e184 {
                        let _e186 = (_e185 + 1u);
                        phi_282_ = _e186;
                        phi_283_ = _e186;
                        phi_285_ = select(true, false, (_e186 == 2u));
                    } else {
                        phi_282_ = u32();
                        phi_283_ = 0u;
                        phi_285_ = true;
                    }
                    let _e190 = phi_282_;
                    let _e192 = phi_283_;
                    let _e194 = phi_285_;
                    if _e194 {
                        phi_290_ = (_e192 + 1u);
                    } else {
                        phi_290_ = 0u;
                    }
                    let _e198 = phi_290_;
                    let _e199 = select(_e190, _e192, _e194);
                    let _e200 = select(_e185, select(2u, _e185, _e184), _e194);
                    let _e201 = -(_e180);
                    let _e202 = (_e201 / 2i);
                    let _e207 = bitcast<f32>((bitcast<u32>((_e202 + 127i)) << bitcast<u32>(23i)));
                    let _e213 = bitcast<f32>((bitcast<u32>(((_e201 - _e202) + 127i)) << bitcast<u32>(23i)));
                    let _e218 = global_3.member[_e72].member.member;
                    let _e219 = (_e199 == 0u);
                    if _e219 {
                        phi_334_ = _e218[0];
                    } else {
                        phi_334_ = _e218[1];
                    }
                    let _e223 = phi_334_;
                    let _e224 = (_e199 == 2u);
                    if _e224 {
                        phi_340_ = _e218[2];
                    } else {
                        phi_340_ = _e223;
                    }
                    let _e227 = phi_340_;
                    let _e228 = global_3.member[_e72].member.member_2;
                    if _e219 {
                        phi_351_ = _e228[0];
                    } else {
                        phi_351_ = _e228[1];
                    }
                    let _e232 = phi_351_;
                    if _e224 {
                        phi_357_ = _e228[2];
                    } else {
                        phi_357_ = _e232;
                    }
                    let _e235 = phi_357_;
                    let _e237 = ((_e235 * _e207) * _e213);
                    let _e241 = (bitcast<f32>((bitcast<u32>(_e237) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e241 {
                        let _e245 = (bitcast<f32>((bitcast<u32>(_e227) & 2147483647u)) * 0.00000011920929f);
                        phi_380_ = select(0.00000000000011368684f, _e245, (_e245 > 0.00000000000011368684f));
                    } else {
                        phi_380_ = 0f;
                    }
                    let _e249 = phi_380_;
                    let _e250 = (_e227 + _e249);
                    let _e251 = (_e227 - _e249);
                    let _e252 = select(_e237, 0f, _e241);
                    if _e241 {
                        phi_391_ = 38685626000000000000000000f;
                    } else {
                        phi_391_ = (1f / _e237);
                    }
                    let _e255 = phi_391_;
                    let _e256 = (_e198 == 0u);
                    if _e256 {
                        phi_400_ = _e218[0];
                    } else {
                        phi_400_ = _e218[1];
                    }
                    let _e260 = phi_400_;
                    let _e261 = (_e198 == 2u);
                    if _e261 {
                        phi_406_ = _e218[2];
                    } else {
                        phi_406_ = _e260;
                    }
                    let _e264 = phi_406_;
                    if _e256 {
                        phi_417_ = _e228[0];
                    } else {
                        phi_417_ = _e228[1];
                    }
                    let _e268 = phi_417_;
                    if _e261 {
                        phi_423_ = _e228[2];
                    } else {
                        phi_423_ = _e268;
                    }
                    let _e271 = phi_423_;
                    let _e273 = ((_e271 * _e207) * _e213);
                    let _e277 = (bitcast<f32>((bitcast<u32>(_e273) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e277 {
                        let _e281 = (bitcast<f32>((bitcast<u32>(_e264) & 2147483647u)) * 0.00000011920929f);
                        phi_446_ = select(0.00000000000011368684f, _e281, (_e281 > 0.00000000000011368684f));
                    } else {
                        phi_446_ = 0f;
                    }
                    let _e285 = phi_446_;
                    let _e286 = (_e264 + _e285);
                    let _e287 = (_e264 - _e285);
                    let _e288 = select(_e273, 0f, _e277);
                    if _e277 {
                        phi_457_ = 38685626000000000000000000f;
                    } else {
                        phi_457_ = (1f / _e273);
                    }
                    let _e291 = phi_457_;
                    let _e292 = (_e200 == 0u);
                    if _e292 {
                        phi_466_ = _e218[0];
                    } else {
                        phi_466_ = _e218[1];
                    }
                    let _e296 = phi_466_;
                    let _e297 = (_e200 == 2u);
                    if _e297 {
                        phi_472_ = _e218[2];
                    } else {
                        phi_472_ = _e296;
                    }
                    let _e300 = phi_472_;
                    if _e292 {
                        phi_483_ = _e228[0];
                    } else {
                        phi_483_ = _e228[1];
                    }
                    let _e304 = phi_483_;
                    if _e297 {
                        phi_489_ = _e228[2];
                    } else {
                        phi_489_ = _e304;
                    }
                    let _e307 = phi_489_;
                    let _e309 = ((_e307 * _e207) * _e213);
                    let _e313 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e313 {
                        let _e317 = (bitcast<f32>((bitcast<u32>(_e300) & 2147483647u)) * 0.00000011920929f);
                        phi_512_ = select(0.00000000000011368684f, _e317, (_e317 > 0.00000000000011368684f));
                    } else {
                        phi_512_ = 0f;
                    }
                    let _e321 = phi_512_;
                    let _e322 = (_e300 + _e321);
                    let _e323 = (_e300 - _e321);
                    let _e324 = select(_e309, 0f, _e313);
                    if _e313 {
                        phi_523_ = 38685626000000000000000000f;
                    } else {
                        phi_523_ = (1f / _e309);
                    }
                    let _e327 = phi_523_;
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
                        phi_623_ = select(-340282350000000000000000000000000000000f, _e367, (_e367 > -340282350000000000000000000000000000000f));
                        phi_624_ = select(-340282350000000000000000000000000000000f, _e360, (_e360 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_623_ = 0f;
                        phi_624_ = 1f;
                    }
                    let _e371 = phi_623_;
                    let _e373 = phi_624_;
                    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_1989_ = false;
                    phi_635_ = type_40(type_16(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e371);
                    phi_638_ = select(0u, 2147483648u, (_e62 == 0u));
                    phi_640_ = ((3u * _e62) + 1u);
                    phi_642_ = (_e373 <= _e371);
                    phi_644_ = 0u;
                    loop {
                        let _e381 = phi_1989_;
                        let _e383 = phi_635_;
                        let _e385 = phi_638_;
                        let _e387 = phi_640_;
                        let _e389 = phi_642_;
                        let _e391 = phi_644_;
                        local_2 = _e383;
                        if _e389 {
                            phi_655_ = true;
                        } else {
                            phi_655_ = (_e391 > 0u);
                        }
                        let _e394 = phi_655_;
                        if _e394 {
                            let _e395 = (_e387 > 0u);
                            if _e395 {
                                if _e389 {
                                    phi_685_ = _e385;
                                    phi_686_ = _e389;
                                    phi_687_ = _e391;
                                } else {
                                    let _e396 = (_e391 - 1u);
                                    let _e397 = (_e396 % 128u);
                                    let _e398 = (_e397 < 128u);
                                    if _e398 {
                                    } else {
                                        phi_2093_ = true;
                                        break;
                                    }
                                    let _e400 = local[_e397];
                                    if _e398 {
                                    } else {
                                        phi_2093_ = true;
                                        break;
                                    }
                                    let _e402 = local_1[_e397];
                                    phi_685_ = _e400;
                                    phi_686_ = (_e402 <= _e383.member_1);
                                    phi_687_ = _e396;
                                }
                                let _e406 = phi_685_;
                                let _e408 = phi_686_;
                                let _e410 = phi_687_;
                                if _e408 {
                                    let _e414 = (_e406 & 268435455u);
                                    if ((_e406 & 2147483648u) != 0u) {
                                        phi_703_ = _e383;
                                        phi_706_ = type_4(_e414, (_e414 + ((_e406 >> bitcast<u32>(28u)) & 7u)));
                                        loop {
                                            let _e609 = phi_703_;
                                            let _e611 = phi_706_;
                                            local_3 = _e609;
                                            if (_e611.member < _e611.member_1) {
                                                phi_707_ = type_4((_e611.member + 1u), _e611.member_1);
                                                phi_729_ = type_4(1u, _e611.member);
                                            } else {
                                                phi_707_ = _e611;
                                                phi_729_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e624 = phi_707_;
                                            let _e626 = phi_729_;
                                            let _e630 = (bitcast<i32>(_e626.member) != 0i);
                                            if _e630 {
                                                let _e631 = (_e626.member_1 < _e64);
                                                if _e631 {
                                                    if _e631 {
                                                    } else {
                                                        phi_1983_ = true;
                                                        break;
                                                    }
                                                    let _e635 = global_1.member[_e626.member_1].member_1;
                                                    phi_749_ = _e635;
                                                } else {
                                                    phi_749_ = 4294967295u;
                                                }
                                                let _e637 = phi_749_;
                                                if (_e626.member_1 >= _e64) {
                                                    phi_837_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e631 {
                                                    } else {
                                                        phi_1983_ = true;
                                                        break;
                                                    }
                                                    let _e639 = (_e199 % 3u);
                                                    let _e640 = (_e198 % 3u);
                                                    let _e641 = (_e200 % 3u);
                                                    if (_e639 < 9u) {
                                                    } else {
                                                        phi_1983_ = true;
                                                        break;
                                                    }
                                                    let _e647 = global_1.member[_e626.member_1].member[_e639];
                                                    if (_e640 < 9u) {
                                                    } else {
                                                        phi_1983_ = true;
                                                        break;
                                                    }
                                                    let _e653 = global_1.member[_e626.member_1].member[_e640];
                                                    if (_e641 < 9u) {
                                                    } else {
                                                        phi_1983_ = true;
                                                        break;
                                                    }
                                                    let _e659 = global_1.member[_e626.member_1].member[_e641];
                                                    let _e661 = (3u + _e639);
                                                    if (_e661 < 9u) {
                                                    } else {
                                                        phi_1983_ = true;
                                                        break;
                                                    }
                                                    let _e667 = global_1.member[_e626.member_1].member[_e661];
                                                    let _e668 = (3u + _e640);
                                                    if (_e668 < 9u) {
                                                    } else {
                                                        phi_1983_ = true;
                                                        break;
                                                    }
                                                    let _e674 = global_1.member[_e626.member_1].member[_e668];
                                                    let _e675 = (3u + _e641);
                                                    if (_e675 < 9u) {
                                                    } else {
                                                        phi_1983_ = true;
                                                        break;
                                                    }
                                                    let _e681 = global_1.member[_e626.member_1].member[_e675];
                                                    let _e683 = (6u + _e639);
                                                    if (_e683 < 9u) {
                                                    } else {
                                                        phi_1983_ = true;
                                                        break;
                                                    }
                                                    let _e689 = global_1.member[_e626.member_1].member[_e683];
                                                    let _e690 = (6u + _e640);
                                                    if (_e690 < 9u) {
                                                    } else {
                                                        phi_1983_ = true;
                                                        break;
                                                    }
                                                    let _e696 = global_1.member[_e626.member_1].member[_e690];
                                                    let _e697 = (6u + _e641);
                                                    if (_e697 < 9u) {
                                                    } else {
                                                        phi_1983_ = true;
                                                        break;
                                                    }
                                                    let _e703 = global_1.member[_e626.member_1].member[_e697];
                                                    phi_837_ = array<array<f32, 3>, 3>(array<f32, 3>(_e647, _e653, _e659), array<f32, 3>(_e667, _e674, _e681), array<f32, 3>(_e689, _e696, _e703));
                                                }
                                                let _e707 = phi_837_;
                                                let _e715 = (_e707[0][2] - _e300);
                                                let _e718 = (((_e707[0][0] - _e227) * _e324) - (_e715 * _e252));
                                                let _e721 = (((_e707[0][1] - _e264) * _e324) - (_e715 * _e288));
                                                let _e728 = (_e707[1][2] - _e300);
                                                let _e731 = (((_e707[1][0] - _e227) * _e324) - (_e728 * _e252));
                                                let _e734 = (((_e707[1][1] - _e264) * _e324) - (_e728 * _e288));
                                                let _e741 = (_e707[2][2] - _e300);
                                                let _e744 = (((_e707[2][0] - _e227) * _e324) - (_e741 * _e252));
                                                let _e747 = (((_e707[2][1] - _e264) * _e324) - (_e741 * _e288));
                                                let _e748 = (_e744 * _e734);
                                                let _e749 = (_e747 * _e731);
                                                let _e750 = (_e718 * _e747);
                                                let _e751 = (_e721 * _e744);
                                                let _e752 = (_e731 * _e721);
                                                let _e753 = (_e734 * _e718);
                                                let _e758 = (((_e748 >= _e749) && (_e750 >= _e751)) && (_e752 >= _e753));
                                                if (_e758 || (((_e748 <= _e749) && (_e750 <= _e751)) && (_e752 <= _e753))) {
                                                    let _e765 = select(-1f, 1f, _e758);
                                                    let _e767 = ((_e748 - _e749) * _e765);
                                                    let _e769 = select(0f, _e767, (_e767 > 0f));
                                                    let _e771 = ((_e750 - _e751) * _e765);
                                                    let _e773 = select(0f, _e771, (_e771 > 0f));
                                                    let _e775 = ((_e752 - _e753) * _e765);
                                                    let _e777 = select(0f, _e775, (_e775 > 0f));
                                                    let _e779 = ((_e769 + _e773) + _e777);
                                                    if (_e779 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1403_ = type_16();
                                                        phi_1404_ = true;
                                                    } else {
                                                        let _e782 = select(_e707[1][0], _e707[0][0], (_e707[0][0] < _e707[1][0]));
                                                        let _e786 = select(_e707[1][0], _e707[0][0], (_e707[0][0] > _e707[1][0]));
                                                        let _e790 = select(_e707[1][1], _e707[0][1], (_e707[0][1] < _e707[1][1]));
                                                        let _e794 = select(_e707[1][1], _e707[0][1], (_e707[0][1] > _e707[1][1]));
                                                        let _e798 = select(_e707[1][2], _e707[0][2], (_e707[0][2] < _e707[1][2]));
                                                        let _e802 = select(_e707[1][2], _e707[0][2], (_e707[0][2] > _e707[1][2]));
                                                        let _e807 = ((select(_e707[2][0], _e782, (_e782 < _e707[2][0])) - _e250) * _e255);
                                                        let _e808 = ((select(_e707[2][0], _e786, (_e786 > _e707[2][0])) - _e251) * _e255);
                                                        let _e811 = ((select(_e707[2][1], _e790, (_e790 < _e707[2][1])) - _e286) * _e291);
                                                        let _e812 = ((select(_e707[2][1], _e794, (_e794 > _e707[2][1])) - _e287) * _e291);
                                                        let _e815 = ((select(_e707[2][2], _e798, (_e798 < _e707[2][2])) - _e322) * _e327);
                                                        let _e816 = ((select(_e707[2][2], _e802, (_e802 > _e707[2][2])) - _e323) * _e327);
                                                        let _e818 = select(_e816, _e815, (_e815 < _e816));
                                                        let _e820 = select(_e816, _e815, (_e815 > _e816));
                                                        let _e822 = select(_e808, _e807, (_e807 < _e808));
                                                        let _e824 = select(_e812, _e811, (_e811 < _e812));
                                                        let _e826 = select(_e824, _e822, (_e822 > _e824));
                                                        let _e828 = select(_e818, _e826, (_e826 > _e818));
                                                        let _e830 = select(_e808, _e807, (_e807 > _e808));
                                                        let _e832 = select(_e812, _e811, (_e811 > _e812));
                                                        let _e834 = select(_e832, _e830, (_e830 < _e832));
                                                        let _e836 = select(_e820, _e834, (_e834 < _e820));
                                                        let _e837 = -(_e818);
                                                        let _e843 = select(_e373, _e828, (_e828 > _e373));
                                                        if (_e843 > (_e836 + (select(_e837, _e820, (_e820 > _e837)) * 0.0000019073523f))) {
                                                            phi_1398_ = type_16();
                                                            phi_1399_ = true;
                                                        } else {
                                                            let _e845 = (_e843 > _e609.member_1);
                                                            if _e845 {
                                                                phi_1397_ = type_16();
                                                            } else {
                                                                let _e849 = (_e707[1][0] - _e707[0][0]);
                                                                let _e850 = (_e707[1][1] - _e707[0][1]);
                                                                let _e851 = (_e707[1][2] - _e707[0][2]);
                                                                let _e852 = vec3<f32>(_e849, _e850, _e851);
                                                                let _e853 = (_e707[2][0] - _e707[1][0]);
                                                                let _e854 = (_e707[2][1] - _e707[1][1]);
                                                                let _e855 = (_e707[2][2] - _e707[1][2]);
                                                                let _e856 = vec3<f32>(_e853, _e854, _e855);
                                                                let _e857 = (_e707[0][0] - _e707[2][0]);
                                                                let _e858 = (_e707[0][1] - _e707[2][1]);
                                                                let _e859 = (_e707[0][2] - _e707[2][2]);
                                                                let _e860 = vec3<f32>(_e857, _e858, _e859);
                                                                let _e863 = bitcast<f32>((bitcast<u32>(_e849) & 2147483647u));
                                                                let _e866 = bitcast<f32>((bitcast<u32>(_e850) & 2147483647u));
                                                                let _e868 = select(_e866, _e863, (_e863 > _e866));
                                                                let _e871 = bitcast<f32>((bitcast<u32>(_e851) & 2147483647u));
                                                                let _e873 = select(_e871, _e868, (_e868 > _e871));
                                                                let _e876 = bitcast<f32>((bitcast<u32>(_e853) & 2147483647u));
                                                                let _e879 = bitcast<f32>((bitcast<u32>(_e854) & 2147483647u));
                                                                let _e881 = select(_e879, _e876, (_e876 > _e879));
                                                                let _e884 = bitcast<f32>((bitcast<u32>(_e855) & 2147483647u));
                                                                let _e886 = select(_e884, _e881, (_e881 > _e884));
                                                                let _e889 = bitcast<f32>((bitcast<u32>(_e857) & 2147483647u));
                                                                let _e892 = bitcast<f32>((bitcast<u32>(_e858) & 2147483647u));
                                                                let _e894 = select(_e892, _e889, (_e889 > _e892));
                                                                let _e897 = bitcast<f32>((bitcast<u32>(_e859) & 2147483647u));
                                                                let _e899 = select(_e897, _e894, (_e894 > _e897));
                                                                let _e901 = select(_e886, _e873, (_e873 > _e886));
                                                                let _e903 = select(_e899, _e901, (_e901 > _e899));
                                                                if (_e873 == _e903) {
                                                                    phi_1308_ = _e856;
                                                                    phi_1309_ = _e860;
                                                                } else {
                                                                    let _e906 = vec3((_e886 == _e903));
                                                                    phi_1308_ = select(_e852, _e860, _e906);
                                                                    phi_1309_ = select(_e856, _e852, _e906);
                                                                }
                                                                let _e910 = phi_1308_;
                                                                let _e912 = phi_1309_;
                                                                let _e919 = ((_e910.y * _e912.z) - (_e912.y * _e910.z));
                                                                let _e924 = ((_e910.z * _e912.x) - (_e912.z * _e910.x));
                                                                let _e927 = ((_e910.x * _e912.y) - (_e912.x * _e910.y));
                                                                if (_e769 >= _e773) {
                                                                    phi_1340_ = select(true, false, (_e769 >= _e777));
                                                                } else {
                                                                    phi_1340_ = true;
                                                                }
                                                                let _e932 = phi_1340_;
                                                                if _e932 {
                                                                    phi_1349_ = select(vec3<f32>(_e707[2][0], _e707[2][1], _e707[2][2]), vec3<f32>(_e707[1][0], _e707[1][1], _e707[1][2]), vec3((_e773 >= _e777)));
                                                                } else {
                                                                    phi_1349_ = vec3<f32>(_e707[0][0], _e707[0][1], _e707[0][2]);
                                                                }
                                                                let _e937 = phi_1349_;
                                                                let _e954 = ((((_e919 * (_e937.x - _e227)) + (_e924 * (_e937.y - _e264))) + (_e927 * (_e937.z - _e300))) / (((_e919 * _e252) + (_e924 * _e288)) + (_e927 * _e324)));
                                                                let _e956 = select(_e836, _e954, (_e954 < _e836));
                                                                let _e958 = select(_e828, _e956, (_e956 > _e828));
                                                                if (_e958 >= _e373) {
                                                                    let _e960 = (_e958 <= _e609.member_1);
                                                                    if _e960 {
                                                                        let _e961 = (1f / _e779);
                                                                        phi_1389_ = type_16(_e958, (_e773 * _e961), (_e777 * _e961), _e637);
                                                                    } else {
                                                                        phi_1389_ = type_16();
                                                                    }
                                                                    let _e966 = phi_1389_;
                                                                    phi_1391_ = _e966;
                                                                    phi_1392_ = select(true, false, _e960);
                                                                } else {
                                                                    phi_1391_ = type_16();
                                                                    phi_1392_ = true;
                                                                }
                                                                let _e969 = phi_1391_;
                                                                let _e971 = phi_1392_;
                                                                if _e971 {
                                                                    phi_1396_ = type_16(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1396_ = _e969;
                                                                }
                                                                let _e973 = phi_1396_;
                                                                phi_1397_ = _e973;
                                                            }
                                                            let _e975 = phi_1397_;
                                                            phi_1398_ = _e975;
                                                            phi_1399_ = _e845;
                                                        }
                                                        let _e977 = phi_1398_;
                                                        let _e979 = phi_1399_;
                                                        phi_1403_ = _e977;
                                                        phi_1404_ = _e979;
                                                    }
                                                    let _e981 = phi_1403_;
                                                    let _e983 = phi_1404_;
                                                    phi_1408_ = _e981;
                                                    phi_1409_ = _e983;
                                                } else {
                                                    phi_1408_ = type_16();
                                                    phi_1409_ = true;
                                                }
                                                let _e985 = phi_1408_;
                                                let _e987 = phi_1409_;
                                                if _e987 {
                                                    phi_1413_ = type_16(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1413_ = _e985;
                                                }
                                                let _e989 = phi_1413_;
                                                if (_e989.member_3 != 4294967295u) {
                                                    if (_e637 != _e78) {
                                                        if (_e989.member < _e609.member.member) {
                                                            phi_1439_ = true;
                                                        } else {
                                                            if (_e989.member == _e609.member.member) {
                                                                phi_1438_ = (_e989.member_3 < _e609.member.member_3);
                                                            } else {
                                                                phi_1438_ = false;
                                                            }
                                                            let _e1002 = phi_1438_;
                                                            phi_1439_ = _e1002;
                                                        }
                                                        let _e1004 = phi_1439_;
                                                        if _e1004 {
                                                            phi_1445_ = type_40(_e989, _e989.member);
                                                        } else {
                                                            phi_1445_ = _e609;
                                                        }
                                                        let _e1007 = phi_1445_;
                                                        phi_1446_ = _e1007;
                                                    } else {
                                                        phi_1446_ = _e609;
                                                    }
                                                    let _e1009 = phi_1446_;
                                                    phi_1447_ = _e1009;
                                                } else {
                                                    phi_1447_ = _e609;
                                                }
                                                let _e1011 = phi_1447_;
                                                phi_704_ = _e1011;
                                            } else {
                                                phi_704_ = type_40();
                                            }
                                            let _e1013 = phi_704_;
                                            continue;
                                            continuing {
                                                phi_703_ = _e1013;
                                                phi_706_ = _e624;
                                                phi_1983_ = _e381;
                                                break if !(_e630);
                                            }
                                        }
                                        let _e1016 = phi_1983_;
                                        phi_2093_ = _e1016;
                                        if _e1016 {
                                            break;
                                        }
                                        phi_2097_ = _e1016;
                                        let _e1181 = local_3;
                                        phi_1900_ = _e1181;
                                        phi_1901_ = _e406;
                                        phi_1902_ = false;
                                        phi_1903_ = _e410;
                                    } else {
                                        if (_e406 >= _e62) {
                                            phi_1507_ = type_43(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e406 < _e62) {
                                            } else {
                                                phi_2093_ = true;
                                                break;
                                            }
                                            let _e420 = (_e199 % 3u);
                                            if (_e420 < 3u) {
                                            } else {
                                                phi_2093_ = true;
                                                break;
                                            }
                                            let _e426 = global_2.member[_e406].member[_e420];
                                            let _e432 = (_e198 % 3u);
                                            if (_e432 < 3u) {
                                            } else {
                                                phi_2093_ = true;
                                                break;
                                            }
                                            let _e438 = global_2.member[_e406].member[_e432];
                                            let _e444 = (_e200 % 3u);
                                            if (_e444 < 3u) {
                                            } else {
                                                phi_2093_ = true;
                                                break;
                                            }
                                            let _e450 = global_2.member[_e406].member[_e444];
                                            let _e460 = global_2.member[_e406].member_1;
                                            let _e464 = global_2.member[_e406].member_2;
                                            phi_1507_ = type_43(array<vec4<f32>, 3>(vec4<f32>(_e426[0], _e426[1], _e426[2], _e426[3]), vec4<f32>(_e438[0], _e438[1], _e438[2], _e438[3]), vec4<f32>(_e450[0], _e450[1], _e450[2], _e450[3])), _e460, _e464);
                                        }
                                        let _e467 = phi_1507_;
                                        let _e479 = ((_e467.member[0].x - _e250) * _e255);
                                        let _e480 = ((_e467.member[0].y - _e250) * _e255);
                                        let _e481 = ((_e467.member[0].z - _e251) * _e255);
                                        let _e482 = ((_e467.member[0].w - _e251) * _e255);
                                        let _e492 = ((_e467.member[1].x - _e286) * _e291);
                                        let _e493 = ((_e467.member[1].y - _e286) * _e291);
                                        let _e494 = ((_e467.member[1].z - _e287) * _e291);
                                        let _e495 = ((_e467.member[1].w - _e287) * _e291);
                                        let _e505 = ((_e467.member[2].x - _e322) * _e327);
                                        let _e506 = ((_e467.member[2].y - _e322) * _e327);
                                        let _e507 = ((_e467.member[2].z - _e323) * _e327);
                                        let _e508 = ((_e467.member[2].w - _e323) * _e327);
                                        let _e510 = select(_e507, _e505, (_e505 < _e507));
                                        let _e512 = select(_e508, _e506, (_e506 < _e508));
                                        let _e514 = select(_e507, _e505, (_e505 > _e507));
                                        let _e516 = select(_e508, _e506, (_e506 > _e508));
                                        let _e518 = select(_e481, _e479, (_e479 < _e481));
                                        let _e520 = select(_e482, _e480, (_e480 < _e482));
                                        let _e522 = select(_e494, _e492, (_e492 < _e494));
                                        let _e524 = select(_e495, _e493, (_e493 < _e495));
                                        let _e526 = select(_e522, _e518, (_e518 > _e522));
                                        let _e528 = select(_e524, _e520, (_e520 > _e524));
                                        let _e530 = select(_e510, _e526, (_e526 > _e510));
                                        let _e532 = select(_e512, _e528, (_e528 > _e512));
                                        let _e534 = select(_e481, _e479, (_e479 > _e481));
                                        let _e536 = select(_e482, _e480, (_e480 > _e482));
                                        let _e538 = select(_e494, _e492, (_e492 > _e494));
                                        let _e540 = select(_e495, _e493, (_e493 > _e495));
                                        let _e542 = select(_e538, _e534, (_e534 < _e538));
                                        let _e544 = select(_e540, _e536, (_e536 < _e540));
                                        let _e549 = -(_e510);
                                        let _e550 = -(_e512);
                                        let _e557 = (select(_e514, _e542, (_e542 < _e514)) + (select(_e549, _e514, (_e514 > _e549)) * 0.0000019073523f));
                                        let _e558 = (select(_e516, _e544, (_e544 < _e516)) + (select(_e550, _e516, (_e516 > _e550)) * 0.0000019073523f));
                                        let _e560 = select(_e373, _e530, (_e530 > _e373));
                                        let _e562 = select(_e373, _e532, (_e532 > _e373));
                                        let _e567 = (_e560 <= select(_e383.member_1, _e557, (_e557 < _e383.member_1)));
                                        let _e568 = (_e562 <= select(_e383.member_1, _e558, (_e558 < _e383.member_1)));
                                        let _e569 = (_e560 <= _e562);
                                        if _e567 {
                                            if _e568 {
                                                if _e569 {
                                                    phi_1851_ = _e467.member_2;
                                                } else {
                                                    phi_1851_ = _e467.member_1;
                                                }
                                                let _e573 = phi_1851_;
                                                let _e574 = (_e410 % 128u);
                                                let _e575 = (_e574 < 128u);
                                                if _e575 {
                                                } else {
                                                    phi_2093_ = true;
                                                    break;
                                                }
                                                local[_e574] = _e573;
                                                if _e575 {
                                                } else {
                                                    phi_2093_ = true;
                                                    break;
                                                }
                                                local_1[_e574] = select(_e562, _e560, (_e560 > _e562));
                                                if _e569 {
                                                    phi_1877_ = _e467.member_1;
                                                } else {
                                                    phi_1877_ = _e467.member_2;
                                                }
                                                let _e584 = phi_1877_;
                                                phi_1878_ = _e584;
                                                phi_1879_ = (_e410 + 1u);
                                            } else {
                                                phi_1878_ = u32();
                                                phi_1879_ = u32();
                                            }
                                            let _e586 = phi_1878_;
                                            let _e588 = phi_1879_;
                                            phi_1881_ = _e586;
                                            phi_1882_ = _e588;
                                            phi_1883_ = select(true, false, _e568);
                                        } else {
                                            phi_1881_ = u32();
                                            phi_1882_ = u32();
                                            phi_1883_ = true;
                                        }
                                        let _e591 = phi_1881_;
                                        let _e593 = phi_1882_;
                                        let _e595 = phi_1883_;
                                        if _e595 {
                                            if _e567 {
                                                phi_1892_ = _e467.member_1;
                                            } else {
                                                phi_1892_ = _e467.member_2;
                                            }
                                            let _e599 = phi_1892_;
                                            phi_1897_ = _e599;
                                            phi_1898_ = select(_e568, true, _e567);
                                        } else {
                                            phi_1897_ = _e591;
                                            phi_1898_ = _e408;
                                        }
                                        let _e602 = phi_1897_;
                                        let _e604 = phi_1898_;
                                        phi_2097_ = _e381;
                                        phi_1900_ = _e383;
                                        phi_1901_ = _e602;
                                        phi_1902_ = _e604;
                                        phi_1903_ = select(_e593, _e410, _e595);
                                    }
                                    let _e1018 = phi_2097_;
                                    let _e1020 = phi_1900_;
                                    let _e1022 = phi_1901_;
                                    let _e1024 = phi_1902_;
                                    let _e1026 = phi_1903_;
                                    phi_2096_ = _e1018;
                                    phi_1904_ = _e1020;
                                    phi_1905_ = _e1022;
                                    phi_1906_ = (_e387 - 1u);
                                    phi_1907_ = _e1024;
                                    phi_1908_ = _e1026;
                                } else {
                                    phi_2096_ = _e381;
                                    phi_1904_ = _e383;
                                    phi_1905_ = _e406;
                                    phi_1906_ = _e387;
                                    phi_1907_ = _e408;
                                    phi_1908_ = _e410;
                                }
                                let _e1028 = phi_2096_;
                                let _e1030 = phi_1904_;
                                let _e1032 = phi_1905_;
                                let _e1034 = phi_1906_;
                                let _e1036 = phi_1907_;
                                let _e1038 = phi_1908_;
                                phi_2095_ = _e1028;
                                phi_1909_ = _e1030;
                                phi_1910_ = _e1032;
                                phi_1911_ = _e1034;
                                phi_1912_ = _e1036;
                                phi_1913_ = _e1038;
                            } else {
                                phi_2095_ = _e381;
                                phi_1909_ = type_40();
                                phi_1910_ = u32();
                                phi_1911_ = u32();
                                phi_1912_ = bool();
                                phi_1913_ = u32();
                            }
                            let _e1040 = phi_2095_;
                            let _e1042 = phi_1909_;
                            let _e1044 = phi_1910_;
                            let _e1046 = phi_1911_;
                            let _e1048 = phi_1912_;
                            let _e1050 = phi_1913_;
                            phi_2094_ = _e1040;
                            phi_636_ = _e1042;
                            phi_639_ = _e1044;
                            phi_641_ = _e1046;
                            phi_643_ = _e1048;
                            phi_645_ = _e1050;
                            phi_1914_ = _e395;
                        } else {
                            phi_2094_ = _e381;
                            phi_636_ = type_40();
                            phi_639_ = u32();
                            phi_641_ = u32();
                            phi_643_ = bool();
                            phi_645_ = u32();
                            phi_1914_ = false;
                        }
                        let _e1052 = phi_2094_;
                        let _e1054 = phi_636_;
                        let _e1056 = phi_639_;
                        let _e1058 = phi_641_;
                        let _e1060 = phi_643_;
                        let _e1062 = phi_645_;
                        let _e1064 = phi_1914_;
                        continue;
                        continuing {
                            phi_1989_ = _e1052;
                            phi_635_ = _e1054;
                            phi_638_ = _e1056;
                            phi_640_ = _e1058;
                            phi_642_ = _e1060;
                            phi_644_ = _e1062;
                            phi_2093_ = _e1052;
                            break if !(_e1064);
                        }
                    }
                    let _e1067 = phi_2093_;
                    if _e1067 {
                        break;
                    }
                    let _e1069 = local_2;
                    if (_e1069.member.member_3 != 4294967295u) {
                        let _e1074 = (_e201 / 3i);
                        let _e1081 = bitcast<f32>((bitcast<u32>((_e1074 + 127i)) << bitcast<u32>(23i)));
                        let _e1089 = (((_e1069.member.member * _e1081) * _e1081) * bitcast<f32>((bitcast<u32>(((_e201 - (2i * _e1074)) + 127i)) << bitcast<u32>(23i))));
                        let _e1091 = select(340282350000000000000000000000000000000f, _e1089, (_e1089 < 340282350000000000000000000000000000000f));
                        phi_1966_ = type_16(select(-340282350000000000000000000000000000000f, _e1091, (_e1091 > -340282350000000000000000000000000000000f)), _e1069.member.member_1, _e1069.member.member_2, _e1069.member.member_3);
                    } else {
                        phi_1966_ = type_16(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1098 = phi_1966_;
                    if _e74 {
                    } else {
                        break;
                    }
                    global_4.member[_e72] = _e1098;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_paths(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
