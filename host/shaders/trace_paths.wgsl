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

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_34 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_36 {
    member: array<type_34>,
}

struct type_42 {
    member: type_22,
    member_1: f32,
}

struct type_47 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_51 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_15;
@group(0) @binding(0) 
var<storage> global_2: type_36;
@group(0) @binding(2) 
var<storage> global_3: type_29;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_24;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_51;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_178_: u32;
    var phi_283_: i32;
    var phi_284_: i32;
    var phi_294_: bool;
    var phi_304_: u32;
    var phi_305_: u32;
    var phi_307_: bool;
    var phi_312_: u32;
    var phi_344_: i32;
    var phi_362_: f32;
    var phi_368_: f32;
    var phi_379_: f32;
    var phi_385_: f32;
    var phi_408_: f32;
    var phi_419_: f32;
    var phi_428_: f32;
    var phi_434_: f32;
    var phi_445_: f32;
    var phi_451_: f32;
    var phi_474_: f32;
    var phi_485_: f32;
    var phi_494_: f32;
    var phi_500_: f32;
    var phi_511_: f32;
    var phi_517_: f32;
    var phi_540_: f32;
    var phi_551_: f32;
    var phi_651_: f32;
    var phi_652_: f32;
    var phi_2101_: bool;
    var phi_663_: type_42;
    var phi_666_: u32;
    var phi_668_: u32;
    var phi_670_: bool;
    var phi_672_: u32;
    var phi_683_: bool;
    var phi_715_: u32;
    var phi_716_: bool;
    var phi_717_: u32;
    var phi_1538_: type_47;
    var phi_1882_: u32;
    var phi_1910_: u32;
    var phi_1911_: u32;
    var phi_1912_: u32;
    var phi_1914_: u32;
    var phi_1915_: u32;
    var phi_1916_: bool;
    var phi_1925_: u32;
    var phi_1930_: u32;
    var phi_1931_: bool;
    var phi_732_: type_42;
    var phi_735_: type_7;
    var phi_736_: type_7;
    var phi_758_: type_7;
    var phi_779_: u32;
    var phi_868_: array<array<f32, 3>, 3>;
    var phi_1339_: vec3<f32>;
    var phi_1340_: vec3<f32>;
    var phi_1371_: bool;
    var phi_1380_: vec3<f32>;
    var phi_1420_: type_22;
    var phi_1422_: type_22;
    var phi_1423_: bool;
    var phi_1427_: type_22;
    var phi_1428_: type_22;
    var phi_1429_: type_22;
    var phi_1430_: bool;
    var phi_1434_: type_22;
    var phi_1435_: bool;
    var phi_1439_: type_22;
    var phi_1440_: bool;
    var phi_1444_: type_22;
    var phi_1469_: bool;
    var phi_1470_: bool;
    var phi_1476_: type_42;
    var phi_1477_: type_42;
    var phi_1478_: type_42;
    var phi_733_: type_42;
    var phi_2095_: bool;
    var phi_2214_: bool;
    var phi_1933_: type_42;
    var phi_1934_: u32;
    var phi_1935_: bool;
    var phi_1936_: u32;
    var phi_2213_: bool;
    var phi_1937_: type_42;
    var phi_1938_: u32;
    var phi_1939_: u32;
    var phi_1940_: bool;
    var phi_1941_: u32;
    var phi_2212_: bool;
    var phi_1942_: type_42;
    var phi_1943_: u32;
    var phi_1944_: u32;
    var phi_1945_: bool;
    var phi_1946_: u32;
    var phi_2211_: bool;
    var phi_664_: type_42;
    var phi_667_: u32;
    var phi_669_: u32;
    var phi_671_: bool;
    var phi_673_: u32;
    var phi_1947_: bool;
    var phi_2210_: bool;
    var local_2: type_42;
    var phi_1999_: type_22;
    var local_3: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e63 = global;
            let _e65 = arrayLength((&global_2.member));
            let _e67 = arrayLength((&global_1.member));
            let _e73 = arrayLength((&global_5.member));
            let _e77 = (_e63.x + (_e63.y * 2097152u));
            let _e78 = (_e77 < arrayLength((&global_3.member)));
            if _e78 {
                if _e78 {
                } else {
                    break;
                }
                let _e82 = global_3.member[_e77].member_2;
                phi_178_ = _e82;
            } else {
                phi_178_ = 4294967295u;
            }
            let _e84 = phi_178_;
            if _e78 {
                let _e85 = (_e77 < arrayLength((&global_4.member)));
                if _e85 {
                    if _e78 {
                    } else {
                        break;
                    }
                    let _e95 = global_3.member[_e77].member.member_2[0u];
                    let _e97 = (bitcast<u32>(_e95) & 2147483647u);
                    let _e103 = global_3.member[_e77].member.member_2[1u];
                    let _e105 = (bitcast<u32>(_e103) & 2147483647u);
                    let _e111 = global_3.member[_e77].member.member_2[2u];
                    let _e113 = (bitcast<u32>(_e111) & 2147483647u);
                    let _e119 = global_3.member[_e77].member.member[0u];
                    let _e121 = (bitcast<u32>(_e119) & 2147483647u);
                    let _e127 = global_3.member[_e77].member.member[1u];
                    let _e129 = (bitcast<u32>(_e127) & 2147483647u);
                    let _e135 = global_3.member[_e77].member.member[2u];
                    let _e137 = (bitcast<u32>(_e135) & 2147483647u);
                    let _e139 = select(_e105, _e97, (_e105 < _e97));
                    let _e141 = select(_e113, _e139, (_e113 < _e139));
                    let _e143 = select(_e121, _e141, (_e121 < _e141));
                    let _e145 = select(_e129, _e143, (_e129 < _e143));
                    let _e147 = select(_e137, _e145, (_e137 < _e145));
                    let _e152 = global_3.member[_e77].member.member_1;
                    let _e154 = (bitcast<u32>(_e152) & 2147483647u);
                    let _e162 = global_3.member[_e77].member.member_3;
                    let _e168 = (((select(_e154, _e147, (_e154 < _e147)) < 2139095040u) && ((bitcast<u32>(_e162) & 2147483647u) <= 2139095040u)) && (_e141 > 0u));
                    if _e168 {
                        let _e171 = (bitcast<u32>(bitcast<f32>(_e141)) & 2147483647u);
                        if (_e171 >= 8388608u) {
                            phi_283_ = (bitcast<i32>((_e171 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_283_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e171)), 32u, (_e171 == 0u))));
                        }
                        let _e185 = phi_283_;
                        phi_284_ = _e185;
                    } else {
                        phi_284_ = 0i;
                    }
                    let _e187 = phi_284_;
                    let _e188 = (_e97 == _e141);
                    if _e188 {
                        phi_294_ = true;
                    } else {
                        phi_294_ = (_e105 == _e141);
                    }
                    let _e191 = phi_294_;
                    let _e192 = select(1u, 0u, _e188);
                    if _e191 {
                        let _e193 = (_e192 + 1u);
                        phi_304_ = _e193;
                        phi_305_ = _e193;
                        phi_307_ = select(true, false, (_e193 == 2u));
                    } else {
                        phi_304_ = u32();
                        phi_305_ = 0u;
                        phi_307_ = true;
                    }
                    let _e197 = phi_304_;
                    let _e199 = phi_305_;
                    let _e201 = phi_307_;
                    if _e201 {
                        phi_312_ = (_e199 + 1u);
                    } else {
                        phi_312_ = 0u;
                    }
                    let _e205 = phi_312_;
                    let _e206 = select(_e197, _e199, _e201);
                    let _e207 = select(_e192, select(2u, _e192, _e191), _e201);
                    let _e208 = -(_e187);
                    if (_e208 < -126i) {
                        phi_344_ = -126i;
                    } else {
                        phi_344_ = select(_e208, 127i, (_e208 > 127i));
                    }
                    let _e213 = phi_344_;
                    let _e218 = bitcast<f32>((bitcast<u32>((_e213 + 127i)) << bitcast<u32>(23i)));
                    let _e224 = bitcast<f32>((bitcast<u32>(((_e208 - _e213) + 127i)) << bitcast<u32>(23i)));
                    let _e229 = global_3.member[_e77].member.member;
                    let _e230 = (_e206 == 0u);
                    if _e230 {
                        phi_362_ = _e229[0];
                    } else {
                        phi_362_ = _e229[1];
                    }
                    let _e234 = phi_362_;
                    let _e235 = (_e206 == 2u);
                    if _e235 {
                        phi_368_ = _e229[2];
                    } else {
                        phi_368_ = _e234;
                    }
                    let _e238 = phi_368_;
                    let _e239 = global_3.member[_e77].member.member_2;
                    if _e230 {
                        phi_379_ = _e239[0];
                    } else {
                        phi_379_ = _e239[1];
                    }
                    let _e243 = phi_379_;
                    if _e235 {
                        phi_385_ = _e239[2];
                    } else {
                        phi_385_ = _e243;
                    }
                    let _e246 = phi_385_;
                    let _e248 = ((_e246 * _e218) * _e224);
                    let _e252 = (bitcast<f32>((bitcast<u32>(_e248) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e252 {
                        let _e256 = (bitcast<f32>((bitcast<u32>(_e238) & 2147483647u)) * 0.00000011920929f);
                        phi_408_ = select(0.00000000000011368684f, _e256, (_e256 > 0.00000000000011368684f));
                    } else {
                        phi_408_ = 0f;
                    }
                    let _e260 = phi_408_;
                    let _e261 = (_e238 + _e260);
                    let _e262 = (_e238 - _e260);
                    let _e263 = select(_e248, 0f, _e252);
                    if _e252 {
                        phi_419_ = 38685626000000000000000000f;
                    } else {
                        phi_419_ = (1f / _e248);
                    }
                    let _e266 = phi_419_;
                    let _e267 = (_e205 == 0u);
                    if _e267 {
                        phi_428_ = _e229[0];
                    } else {
                        phi_428_ = _e229[1];
                    }
                    let _e271 = phi_428_;
                    let _e272 = (_e205 == 2u);
                    if _e272 {
                        phi_434_ = _e229[2];
                    } else {
                        phi_434_ = _e271;
                    }
                    let _e275 = phi_434_;
                    if _e267 {
                        phi_445_ = _e239[0];
                    } else {
                        phi_445_ = _e239[1];
                    }
                    let _e279 = phi_445_;
                    if _e272 {
                        phi_451_ = _e239[2];
                    } else {
                        phi_451_ = _e279;
                    }
                    let _e282 = phi_451_;
                    let _e284 = ((_e282 * _e218) * _e224);
                    let _e288 = (bitcast<f32>((bitcast<u32>(_e284) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e288 {
                        let _e292 = (bitcast<f32>((bitcast<u32>(_e275) & 2147483647u)) * 0.00000011920929f);
                        phi_474_ = select(0.00000000000011368684f, _e292, (_e292 > 0.00000000000011368684f));
                    } else {
                        phi_474_ = 0f;
                    }
                    let _e296 = phi_474_;
                    let _e297 = (_e275 + _e296);
                    let _e298 = (_e275 - _e296);
                    let _e299 = select(_e284, 0f, _e288);
                    if _e288 {
                        phi_485_ = 38685626000000000000000000f;
                    } else {
                        phi_485_ = (1f / _e284);
                    }
                    let _e302 = phi_485_;
                    let _e303 = (_e207 == 0u);
                    if _e303 {
                        phi_494_ = _e229[0];
                    } else {
                        phi_494_ = _e229[1];
                    }
                    let _e307 = phi_494_;
                    let _e308 = (_e207 == 2u);
                    if _e308 {
                        phi_500_ = _e229[2];
                    } else {
                        phi_500_ = _e307;
                    }
                    let _e311 = phi_500_;
                    if _e303 {
                        phi_511_ = _e239[0];
                    } else {
                        phi_511_ = _e239[1];
                    }
                    let _e315 = phi_511_;
                    if _e308 {
                        phi_517_ = _e239[2];
                    } else {
                        phi_517_ = _e315;
                    }
                    let _e318 = phi_517_;
                    let _e320 = ((_e318 * _e218) * _e224);
                    let _e324 = (bitcast<f32>((bitcast<u32>(_e320) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e324 {
                        let _e328 = (bitcast<f32>((bitcast<u32>(_e311) & 2147483647u)) * 0.00000011920929f);
                        phi_540_ = select(0.00000000000011368684f, _e328, (_e328 > 0.00000000000011368684f));
                    } else {
                        phi_540_ = 0f;
                    }
                    let _e332 = phi_540_;
                    let _e333 = (_e311 + _e332);
                    let _e334 = (_e311 - _e332);
                    let _e335 = select(_e320, 0f, _e324);
                    if _e324 {
                        phi_551_ = 38685626000000000000000000f;
                    } else {
                        phi_551_ = (1f / _e320);
                    }
                    let _e338 = phi_551_;
                    let _e341 = bitcast<f32>((bitcast<u32>(_e238) & 2147483647u));
                    let _e344 = bitcast<f32>((bitcast<u32>(_e275) & 2147483647u));
                    let _e346 = select(_e344, _e341, (_e341 > _e344));
                    let _e349 = bitcast<f32>((bitcast<u32>(_e311) & 2147483647u));
                    if (_e168 && (select(_e349, _e346, (_e346 > _e349)) <= 1099511600000f)) {
                        let _e354 = (_e187 / 3i);
                        let _e361 = bitcast<f32>((bitcast<u32>((_e354 + 127i)) << bitcast<u32>(23i)));
                        let _e368 = bitcast<f32>((bitcast<u32>(((_e187 - (2i * _e354)) + 127i)) << bitcast<u32>(23i)));
                        let _e369 = (((_e152 * _e361) * _e361) * _e368);
                        let _e371 = select(340282350000000000000000000000000000000f, _e369, (_e369 < 340282350000000000000000000000000000000f));
                        let _e376 = (((_e162 * _e361) * _e361) * _e368);
                        let _e378 = select(340282350000000000000000000000000000000f, _e376, (_e376 < 340282350000000000000000000000000000000f));
                        phi_651_ = select(-340282350000000000000000000000000000000f, _e378, (_e378 > -340282350000000000000000000000000000000f));
                        phi_652_ = select(-340282350000000000000000000000000000000f, _e371, (_e371 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_651_ = 0f;
                        phi_652_ = 1f;
                    }
                    let _e382 = phi_651_;
                    let _e384 = phi_652_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2101_ = false;
                    phi_663_ = type_42(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e382);
                    phi_666_ = select(0u, 2147483648u, (_e65 == 0u));
                    phi_668_ = ((3u * _e65) + 1u);
                    phi_670_ = (_e384 <= _e382);
                    phi_672_ = 0u;
                    loop {
                        let _e392 = phi_2101_;
                        let _e394 = phi_663_;
                        let _e396 = phi_666_;
                        let _e398 = phi_668_;
                        let _e400 = phi_670_;
                        let _e402 = phi_672_;
                        local_2 = _e394;
                        if _e400 {
                            phi_683_ = true;
                        } else {
                            phi_683_ = (_e402 > 0u);
                        }
                        let _e405 = phi_683_;
                        if _e405 {
                            let _e406 = (_e398 > 0u);
                            if _e406 {
                                if _e400 {
                                    phi_715_ = _e396;
                                    phi_716_ = _e400;
                                    phi_717_ = _e402;
                                } else {
                                    let _e407 = (_e402 - 1u);
                                    let _e408 = (_e407 % 128u);
                                    let _e409 = (_e408 < 128u);
                                    if _e409 {
                                    } else {
                                        phi_2210_ = true;
                                        break;
                                    }
                                    let _e411 = local_1[_e408];
                                    if _e409 {
                                    } else {
                                        phi_2210_ = true;
                                        break;
                                    }
                                    let _e413 = local[_e408];
                                    phi_715_ = _e411;
                                    phi_716_ = (_e413 <= _e394.member_1);
                                    phi_717_ = _e407;
                                }
                                let _e417 = phi_715_;
                                let _e419 = phi_716_;
                                let _e421 = phi_717_;
                                if _e419 {
                                    if ((_e417 & 2147483648u) != 0u) {
                                        phi_732_ = _e394;
                                        phi_735_ = type_7(0u, ((_e417 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e619 = phi_732_;
                                            let _e621 = phi_735_;
                                            local_3 = _e619;
                                            if (_e621.member < _e621.member_1) {
                                                phi_736_ = type_7((_e621.member + 1u), _e621.member_1);
                                                phi_758_ = type_7(1u, _e621.member);
                                            } else {
                                                phi_736_ = _e621;
                                                phi_758_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e634 = phi_736_;
                                            let _e636 = phi_758_;
                                            let _e640 = (bitcast<i32>(_e636.member) != 0i);
                                            if _e640 {
                                                let _e641 = ((_e417 & 268435455u) + _e636.member_1);
                                                let _e642 = (_e641 < _e67);
                                                if _e642 {
                                                    if _e642 {
                                                    } else {
                                                        phi_2095_ = true;
                                                        break;
                                                    }
                                                    let _e646 = global_1.member[_e641].member_1;
                                                    phi_779_ = _e646;
                                                } else {
                                                    phi_779_ = 4294967295u;
                                                }
                                                let _e648 = phi_779_;
                                                if (_e641 >= _e67) {
                                                    phi_868_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e642 {
                                                    } else {
                                                        phi_2095_ = true;
                                                        break;
                                                    }
                                                    let _e650 = (_e206 % 3u);
                                                    let _e651 = (_e205 % 3u);
                                                    let _e652 = (_e207 % 3u);
                                                    if (_e650 < 9u) {
                                                    } else {
                                                        phi_2095_ = true;
                                                        break;
                                                    }
                                                    let _e658 = global_1.member[_e641].member[_e650];
                                                    if (_e651 < 9u) {
                                                    } else {
                                                        phi_2095_ = true;
                                                        break;
                                                    }
                                                    let _e664 = global_1.member[_e641].member[_e651];
                                                    if (_e652 < 9u) {
                                                    } else {
                                                        phi_2095_ = true;
                                                        break;
                                                    }
                                                    let _e670 = global_1.member[_e641].member[_e652];
                                                    let _e672 = (3u + _e650);
                                                    if (_e672 < 9u) {
                                                    } else {
                                                        phi_2095_ = true;
                                                        break;
                                                    }
                                                    let _e678 = global_1.member[_e641].member[_e672];
                                                    let _e679 = (3u + _e651);
                                                    if (_e679 < 9u) {
                                                    } else {
                                                        phi_2095_ = true;
                                                        break;
                                                    }
                                                    let _e685 = global_1.member[_e641].member[_e679];
                                                    let _e686 = (3u + _e652);
                                                    if (_e686 < 9u) {
                                                    } else {
                                                        phi_2095_ = true;
                                                        break;
                                                    }
                                                    let _e692 = global_1.member[_e641].member[_e686];
                                                    let _e694 = (6u + _e650);
                                                    if (_e694 < 9u) {
                                                    } else {
                                                        phi_2095_ = true;
                                                        break;
                                                    }
                                                    let _e700 = global_1.member[_e641].member[_e694];
                                                    let _e701 = (6u + _e651);
                                                    if (_e701 < 9u) {
                                                    } else {
                                                        phi_2095_ = true;
                                                        break;
                                                    }
                                                    let _e707 = global_1.member[_e641].member[_e701];
                                                    let _e708 = (6u + _e652);
                                                    if (_e708 < 9u) {
                                                    } else {
                                                        phi_2095_ = true;
                                                        break;
                                                    }
                                                    let _e714 = global_1.member[_e641].member[_e708];
                                                    phi_868_ = array<array<f32, 3>, 3>(array<f32, 3>(_e658, _e664, _e670), array<f32, 3>(_e678, _e685, _e692), array<f32, 3>(_e700, _e707, _e714));
                                                }
                                                let _e718 = phi_868_;
                                                let _e726 = (_e718[0][2] - _e311);
                                                let _e729 = (((_e718[0][0] - _e238) * _e335) - (_e726 * _e263));
                                                let _e732 = (((_e718[0][1] - _e275) * _e335) - (_e726 * _e299));
                                                let _e739 = (_e718[1][2] - _e311);
                                                let _e742 = (((_e718[1][0] - _e238) * _e335) - (_e739 * _e263));
                                                let _e745 = (((_e718[1][1] - _e275) * _e335) - (_e739 * _e299));
                                                let _e752 = (_e718[2][2] - _e311);
                                                let _e755 = (((_e718[2][0] - _e238) * _e335) - (_e752 * _e263));
                                                let _e758 = (((_e718[2][1] - _e275) * _e335) - (_e752 * _e299));
                                                let _e759 = (_e755 * _e745);
                                                let _e760 = (_e758 * _e742);
                                                let _e761 = (_e729 * _e758);
                                                let _e762 = (_e732 * _e755);
                                                let _e763 = (_e742 * _e732);
                                                let _e764 = (_e745 * _e729);
                                                let _e769 = (((_e759 >= _e760) && (_e761 >= _e762)) && (_e763 >= _e764));
                                                if (_e769 || (((_e759 <= _e760) && (_e761 <= _e762)) && (_e763 <= _e764))) {
                                                    let _e776 = select(-1f, 1f, _e769);
                                                    let _e778 = ((_e759 - _e760) * _e776);
                                                    let _e780 = select(0f, _e778, (_e778 > 0f));
                                                    let _e782 = ((_e761 - _e762) * _e776);
                                                    let _e784 = select(0f, _e782, (_e782 > 0f));
                                                    let _e786 = ((_e763 - _e764) * _e776);
                                                    let _e788 = select(0f, _e786, (_e786 > 0f));
                                                    let _e790 = ((_e780 + _e784) + _e788);
                                                    if (_e790 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1434_ = type_22();
                                                        phi_1435_ = true;
                                                    } else {
                                                        let _e793 = select(_e718[1][0], _e718[0][0], (_e718[0][0] < _e718[1][0]));
                                                        let _e797 = select(_e718[1][0], _e718[0][0], (_e718[0][0] > _e718[1][0]));
                                                        let _e801 = select(_e718[1][1], _e718[0][1], (_e718[0][1] < _e718[1][1]));
                                                        let _e805 = select(_e718[1][1], _e718[0][1], (_e718[0][1] > _e718[1][1]));
                                                        let _e809 = select(_e718[1][2], _e718[0][2], (_e718[0][2] < _e718[1][2]));
                                                        let _e813 = select(_e718[1][2], _e718[0][2], (_e718[0][2] > _e718[1][2]));
                                                        let _e818 = ((select(_e718[2][0], _e793, (_e793 < _e718[2][0])) - _e261) * _e266);
                                                        let _e819 = ((select(_e718[2][0], _e797, (_e797 > _e718[2][0])) - _e262) * _e266);
                                                        let _e822 = ((select(_e718[2][1], _e801, (_e801 < _e718[2][1])) - _e297) * _e302);
                                                        let _e823 = ((select(_e718[2][1], _e805, (_e805 > _e718[2][1])) - _e298) * _e302);
                                                        let _e826 = ((select(_e718[2][2], _e809, (_e809 < _e718[2][2])) - _e333) * _e338);
                                                        let _e827 = ((select(_e718[2][2], _e813, (_e813 > _e718[2][2])) - _e334) * _e338);
                                                        let _e829 = select(_e827, _e826, (_e826 < _e827));
                                                        let _e831 = select(_e827, _e826, (_e826 > _e827));
                                                        let _e833 = select(_e819, _e818, (_e818 < _e819));
                                                        let _e835 = select(_e823, _e822, (_e822 < _e823));
                                                        let _e837 = select(_e835, _e833, (_e833 > _e835));
                                                        let _e839 = select(_e829, _e837, (_e837 > _e829));
                                                        let _e841 = select(_e819, _e818, (_e818 > _e819));
                                                        let _e843 = select(_e823, _e822, (_e822 > _e823));
                                                        let _e845 = select(_e843, _e841, (_e841 < _e843));
                                                        let _e847 = select(_e831, _e845, (_e845 < _e831));
                                                        let _e848 = -(_e829);
                                                        let _e854 = select(_e384, _e839, (_e839 > _e384));
                                                        if (_e854 > (_e847 + (select(_e848, _e831, (_e831 > _e848)) * 0.0000019073523f))) {
                                                            phi_1429_ = type_22();
                                                            phi_1430_ = true;
                                                        } else {
                                                            let _e856 = (_e854 > _e619.member_1);
                                                            if _e856 {
                                                                phi_1428_ = type_22();
                                                            } else {
                                                                let _e860 = (_e718[1][0] - _e718[0][0]);
                                                                let _e861 = (_e718[1][1] - _e718[0][1]);
                                                                let _e862 = (_e718[1][2] - _e718[0][2]);
                                                                let _e863 = vec3<f32>(_e860, _e861, _e862);
                                                                let _e864 = (_e718[2][0] - _e718[1][0]);
                                                                let _e865 = (_e718[2][1] - _e718[1][1]);
                                                                let _e866 = (_e718[2][2] - _e718[1][2]);
                                                                let _e867 = vec3<f32>(_e864, _e865, _e866);
                                                                let _e868 = (_e718[0][0] - _e718[2][0]);
                                                                let _e869 = (_e718[0][1] - _e718[2][1]);
                                                                let _e870 = (_e718[0][2] - _e718[2][2]);
                                                                let _e871 = vec3<f32>(_e868, _e869, _e870);
                                                                let _e874 = bitcast<f32>((bitcast<u32>(_e860) & 2147483647u));
                                                                let _e877 = bitcast<f32>((bitcast<u32>(_e861) & 2147483647u));
                                                                let _e879 = select(_e877, _e874, (_e874 > _e877));
                                                                let _e882 = bitcast<f32>((bitcast<u32>(_e862) & 2147483647u));
                                                                let _e884 = select(_e882, _e879, (_e879 > _e882));
                                                                let _e887 = bitcast<f32>((bitcast<u32>(_e864) & 2147483647u));
                                                                let _e890 = bitcast<f32>((bitcast<u32>(_e865) & 2147483647u));
                                                                let _e892 = select(_e890, _e887, (_e887 > _e890));
                                                                let _e895 = bitcast<f32>((bitcast<u32>(_e866) & 2147483647u));
                                                                let _e897 = select(_e895, _e892, (_e892 > _e895));
                                                                let _e900 = bitcast<f32>((bitcast<u32>(_e868) & 2147483647u));
                                                                let _e903 = bitcast<f32>((bitcast<u32>(_e869) & 2147483647u));
                                                                let _e905 = select(_e903, _e900, (_e900 > _e903));
                                                                let _e908 = bitcast<f32>((bitcast<u32>(_e870) & 2147483647u));
                                                                let _e910 = select(_e908, _e905, (_e905 > _e908));
                                                                let _e912 = select(_e897, _e884, (_e884 > _e897));
                                                                let _e914 = select(_e910, _e912, (_e912 > _e910));
                                                                if (_e884 == _e914) {
                                                                    phi_1339_ = _e867;
                                                                    phi_1340_ = _e871;
                                                                } else {
                                                                    let _e917 = vec3((_e897 == _e914));
                                                                    phi_1339_ = select(_e863, _e871, _e917);
                                                                    phi_1340_ = select(_e867, _e863, _e917);
                                                                }
                                                                let _e921 = phi_1339_;
                                                                let _e923 = phi_1340_;
                                                                let _e930 = ((_e921.y * _e923.z) - (_e923.y * _e921.z));
                                                                let _e935 = ((_e921.z * _e923.x) - (_e923.z * _e921.x));
                                                                let _e938 = ((_e921.x * _e923.y) - (_e923.x * _e921.y));
                                                                if (_e780 >= _e784) {
                                                                    phi_1371_ = select(true, false, (_e780 >= _e788));
                                                                } else {
                                                                    phi_1371_ = true;
                                                                }
                                                                let _e943 = phi_1371_;
                                                                if _e943 {
                                                                    phi_1380_ = select(vec3<f32>(_e718[2][0], _e718[2][1], _e718[2][2]), vec3<f32>(_e718[1][0], _e718[1][1], _e718[1][2]), vec3((_e784 >= _e788)));
                                                                } else {
                                                                    phi_1380_ = vec3<f32>(_e718[0][0], _e718[0][1], _e718[0][2]);
                                                                }
                                                                let _e948 = phi_1380_;
                                                                let _e965 = ((((_e930 * (_e948.x - _e238)) + (_e935 * (_e948.y - _e275))) + (_e938 * (_e948.z - _e311))) / (((_e930 * _e263) + (_e935 * _e299)) + (_e938 * _e335)));
                                                                let _e967 = select(_e847, _e965, (_e965 < _e847));
                                                                let _e969 = select(_e839, _e967, (_e967 > _e839));
                                                                if (_e969 >= _e384) {
                                                                    let _e971 = (_e969 <= _e619.member_1);
                                                                    if _e971 {
                                                                        let _e972 = (1f / _e790);
                                                                        phi_1420_ = type_22(_e969, (_e784 * _e972), (_e788 * _e972), _e648);
                                                                    } else {
                                                                        phi_1420_ = type_22();
                                                                    }
                                                                    let _e977 = phi_1420_;
                                                                    phi_1422_ = _e977;
                                                                    phi_1423_ = select(true, false, _e971);
                                                                } else {
                                                                    phi_1422_ = type_22();
                                                                    phi_1423_ = true;
                                                                }
                                                                let _e980 = phi_1422_;
                                                                let _e982 = phi_1423_;
                                                                if _e982 {
                                                                    phi_1427_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1427_ = _e980;
                                                                }
                                                                let _e984 = phi_1427_;
                                                                phi_1428_ = _e984;
                                                            }
                                                            let _e986 = phi_1428_;
                                                            phi_1429_ = _e986;
                                                            phi_1430_ = _e856;
                                                        }
                                                        let _e988 = phi_1429_;
                                                        let _e990 = phi_1430_;
                                                        phi_1434_ = _e988;
                                                        phi_1435_ = _e990;
                                                    }
                                                    let _e992 = phi_1434_;
                                                    let _e994 = phi_1435_;
                                                    phi_1439_ = _e992;
                                                    phi_1440_ = _e994;
                                                } else {
                                                    phi_1439_ = type_22();
                                                    phi_1440_ = true;
                                                }
                                                let _e996 = phi_1439_;
                                                let _e998 = phi_1440_;
                                                if _e998 {
                                                    phi_1444_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1444_ = _e996;
                                                }
                                                let _e1000 = phi_1444_;
                                                if (_e1000.member_3 != 4294967295u) {
                                                    if (_e648 != _e84) {
                                                        if (_e1000.member < _e619.member.member) {
                                                            phi_1470_ = true;
                                                        } else {
                                                            if (_e1000.member == _e619.member.member) {
                                                                phi_1469_ = (_e1000.member_3 < _e619.member.member_3);
                                                            } else {
                                                                phi_1469_ = false;
                                                            }
                                                            let _e1013 = phi_1469_;
                                                            phi_1470_ = _e1013;
                                                        }
                                                        let _e1015 = phi_1470_;
                                                        if _e1015 {
                                                            phi_1476_ = type_42(_e1000, _e1000.member);
                                                        } else {
                                                            phi_1476_ = _e619;
                                                        }
                                                        let _e1018 = phi_1476_;
                                                        phi_1477_ = _e1018;
                                                    } else {
                                                        phi_1477_ = _e619;
                                                    }
                                                    let _e1020 = phi_1477_;
                                                    phi_1478_ = _e1020;
                                                } else {
                                                    phi_1478_ = _e619;
                                                }
                                                let _e1022 = phi_1478_;
                                                phi_733_ = _e1022;
                                            } else {
                                                phi_733_ = type_42();
                                            }
                                            let _e1024 = phi_733_;
                                            continue;
                                            continuing {
                                                phi_732_ = _e1024;
                                                phi_735_ = _e634;
                                                phi_2095_ = _e392;
                                                break if !(_e640);
                                            }
                                        }
                                        let _e1027 = phi_2095_;
                                        phi_2210_ = _e1027;
                                        if _e1027 {
                                            break;
                                        }
                                        phi_2214_ = _e1027;
                                        let _e1221 = local_3;
                                        phi_1933_ = _e1221;
                                        phi_1934_ = _e417;
                                        phi_1935_ = false;
                                        phi_1936_ = _e421;
                                    } else {
                                        if (_e417 >= _e65) {
                                            phi_1538_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e417 < _e65) {
                                            } else {
                                                phi_2210_ = true;
                                                break;
                                            }
                                            let _e431 = (_e206 % 3u);
                                            if (_e431 < 3u) {
                                            } else {
                                                phi_2210_ = true;
                                                break;
                                            }
                                            let _e437 = global_2.member[_e417].member[_e431];
                                            let _e443 = (_e205 % 3u);
                                            if (_e443 < 3u) {
                                            } else {
                                                phi_2210_ = true;
                                                break;
                                            }
                                            let _e449 = global_2.member[_e417].member[_e443];
                                            let _e455 = (_e207 % 3u);
                                            if (_e455 < 3u) {
                                            } else {
                                                phi_2210_ = true;
                                                break;
                                            }
                                            let _e461 = global_2.member[_e417].member[_e455];
                                            let _e471 = global_2.member[_e417].member_1;
                                            let _e475 = global_2.member[_e417].member_2;
                                            phi_1538_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e437[0], _e437[1], _e437[2], _e437[3]), vec4<f32>(_e449[0], _e449[1], _e449[2], _e449[3]), vec4<f32>(_e461[0], _e461[1], _e461[2], _e461[3])), _e471, _e475);
                                        }
                                        let _e478 = phi_1538_;
                                        let _e490 = ((_e478.member[0].x - _e261) * _e266);
                                        let _e491 = ((_e478.member[0].y - _e261) * _e266);
                                        let _e492 = ((_e478.member[0].z - _e262) * _e266);
                                        let _e493 = ((_e478.member[0].w - _e262) * _e266);
                                        let _e503 = ((_e478.member[1].x - _e297) * _e302);
                                        let _e504 = ((_e478.member[1].y - _e297) * _e302);
                                        let _e505 = ((_e478.member[1].z - _e298) * _e302);
                                        let _e506 = ((_e478.member[1].w - _e298) * _e302);
                                        let _e516 = ((_e478.member[2].x - _e333) * _e338);
                                        let _e517 = ((_e478.member[2].y - _e333) * _e338);
                                        let _e518 = ((_e478.member[2].z - _e334) * _e338);
                                        let _e519 = ((_e478.member[2].w - _e334) * _e338);
                                        let _e521 = select(_e518, _e516, (_e516 < _e518));
                                        let _e523 = select(_e519, _e517, (_e517 < _e519));
                                        let _e525 = select(_e518, _e516, (_e516 > _e518));
                                        let _e527 = select(_e519, _e517, (_e517 > _e519));
                                        let _e529 = select(_e492, _e490, (_e490 < _e492));
                                        let _e531 = select(_e493, _e491, (_e491 < _e493));
                                        let _e533 = select(_e505, _e503, (_e503 < _e505));
                                        let _e535 = select(_e506, _e504, (_e504 < _e506));
                                        let _e537 = select(_e533, _e529, (_e529 > _e533));
                                        let _e539 = select(_e535, _e531, (_e531 > _e535));
                                        let _e541 = select(_e521, _e537, (_e537 > _e521));
                                        let _e543 = select(_e523, _e539, (_e539 > _e523));
                                        let _e545 = select(_e492, _e490, (_e490 > _e492));
                                        let _e547 = select(_e493, _e491, (_e491 > _e493));
                                        let _e549 = select(_e505, _e503, (_e503 > _e505));
                                        let _e551 = select(_e506, _e504, (_e504 > _e506));
                                        let _e553 = select(_e549, _e545, (_e545 < _e549));
                                        let _e555 = select(_e551, _e547, (_e547 < _e551));
                                        let _e560 = -(_e521);
                                        let _e561 = -(_e523);
                                        let _e568 = (select(_e525, _e553, (_e553 < _e525)) + (select(_e560, _e525, (_e525 > _e560)) * 0.0000019073523f));
                                        let _e569 = (select(_e527, _e555, (_e555 < _e527)) + (select(_e561, _e527, (_e527 > _e561)) * 0.0000019073523f));
                                        let _e571 = select(_e384, _e541, (_e541 > _e384));
                                        let _e573 = select(_e384, _e543, (_e543 > _e384));
                                        let _e578 = (_e571 <= select(_e394.member_1, _e568, (_e568 < _e394.member_1)));
                                        let _e579 = (_e573 <= select(_e394.member_1, _e569, (_e569 < _e394.member_1)));
                                        let _e580 = (_e571 <= _e573);
                                        if _e578 {
                                            if _e579 {
                                                if _e580 {
                                                    phi_1882_ = _e478.member_2;
                                                } else {
                                                    phi_1882_ = _e478.member_1;
                                                }
                                                let _e584 = phi_1882_;
                                                let _e587 = (_e421 % 128u);
                                                let _e588 = (_e587 < 128u);
                                                if _e588 {
                                                } else {
                                                    phi_2210_ = true;
                                                    break;
                                                }
                                                local_1[_e587] = _e584;
                                                if _e588 {
                                                } else {
                                                    phi_2210_ = true;
                                                    break;
                                                }
                                                local[_e587] = select(_e573, _e571, (_e571 > _e573));
                                                if _e580 {
                                                    phi_1910_ = _e478.member_1;
                                                } else {
                                                    phi_1910_ = _e478.member_2;
                                                }
                                                let _e595 = phi_1910_;
                                                phi_1911_ = _e595;
                                                phi_1912_ = (_e421 + 1u);
                                            } else {
                                                phi_1911_ = u32();
                                                phi_1912_ = u32();
                                            }
                                            let _e597 = phi_1911_;
                                            let _e599 = phi_1912_;
                                            phi_1914_ = _e597;
                                            phi_1915_ = _e599;
                                            phi_1916_ = select(true, false, _e579);
                                        } else {
                                            phi_1914_ = u32();
                                            phi_1915_ = u32();
                                            phi_1916_ = true;
                                        }
                                        let _e602 = phi_1914_;
                                        let _e604 = phi_1915_;
                                        let _e606 = phi_1916_;
                                        if _e606 {
                                            if _e578 {
                                                phi_1925_ = _e478.member_1;
                                            } else {
                                                phi_1925_ = _e478.member_2;
                                            }
                                            let _e610 = phi_1925_;
                                            phi_1930_ = _e610;
                                            phi_1931_ = select(_e579, true, _e578);
                                        } else {
                                            phi_1930_ = _e602;
                                            phi_1931_ = _e419;
                                        }
                                        let _e613 = phi_1930_;
                                        let _e615 = phi_1931_;
                                        phi_2214_ = _e392;
                                        phi_1933_ = _e394;
                                        phi_1934_ = _e613;
                                        phi_1935_ = _e615;
                                        phi_1936_ = select(_e604, _e421, _e606);
                                    }
                                    let _e1029 = phi_2214_;
                                    let _e1031 = phi_1933_;
                                    let _e1033 = phi_1934_;
                                    let _e1035 = phi_1935_;
                                    let _e1037 = phi_1936_;
                                    phi_2213_ = _e1029;
                                    phi_1937_ = _e1031;
                                    phi_1938_ = _e1033;
                                    phi_1939_ = (_e398 - 1u);
                                    phi_1940_ = _e1035;
                                    phi_1941_ = _e1037;
                                } else {
                                    phi_2213_ = _e392;
                                    phi_1937_ = _e394;
                                    phi_1938_ = _e417;
                                    phi_1939_ = _e398;
                                    phi_1940_ = _e419;
                                    phi_1941_ = _e421;
                                }
                                let _e1039 = phi_2213_;
                                let _e1041 = phi_1937_;
                                let _e1043 = phi_1938_;
                                let _e1045 = phi_1939_;
                                let _e1047 = phi_1940_;
                                let _e1049 = phi_1941_;
                                phi_2212_ = _e1039;
                                phi_1942_ = _e1041;
                                phi_1943_ = _e1043;
                                phi_1944_ = _e1045;
                                phi_1945_ = _e1047;
                                phi_1946_ = _e1049;
                            } else {
                                phi_2212_ = _e392;
                                phi_1942_ = type_42();
                                phi_1943_ = u32();
                                phi_1944_ = u32();
                                phi_1945_ = bool();
                                phi_1946_ = u32();
                            }
                            let _e1051 = phi_2212_;
                            let _e1053 = phi_1942_;
                            let _e1055 = phi_1943_;
                            let _e1057 = phi_1944_;
                            let _e1059 = phi_1945_;
                            let _e1061 = phi_1946_;
                            phi_2211_ = _e1051;
                            phi_664_ = _e1053;
                            phi_667_ = _e1055;
                            phi_669_ = _e1057;
                            phi_671_ = _e1059;
                            phi_673_ = _e1061;
                            phi_1947_ = _e406;
                        } else {
                            phi_2211_ = _e392;
                            phi_664_ = type_42();
                            phi_667_ = u32();
                            phi_669_ = u32();
                            phi_671_ = bool();
                            phi_673_ = u32();
                            phi_1947_ = false;
                        }
                        let _e1063 = phi_2211_;
                        let _e1065 = phi_664_;
                        let _e1067 = phi_667_;
                        let _e1069 = phi_669_;
                        let _e1071 = phi_671_;
                        let _e1073 = phi_673_;
                        let _e1075 = phi_1947_;
                        continue;
                        continuing {
                            phi_2101_ = _e1063;
                            phi_663_ = _e1065;
                            phi_666_ = _e1067;
                            phi_668_ = _e1069;
                            phi_670_ = _e1071;
                            phi_672_ = _e1073;
                            phi_2210_ = _e1063;
                            break if !(_e1075);
                        }
                    }
                    let _e1078 = phi_2210_;
                    if _e1078 {
                        break;
                    }
                    let _e1080 = local_2;
                    if (_e1080.member.member_3 != 4294967295u) {
                        let _e1085 = (_e208 / 3i);
                        let _e1092 = bitcast<f32>((bitcast<u32>((_e1085 + 127i)) << bitcast<u32>(23i)));
                        let _e1100 = (((_e1080.member.member * _e1092) * _e1092) * bitcast<f32>((bitcast<u32>(((_e208 - (2i * _e1085)) + 127i)) << bitcast<u32>(23i))));
                        let _e1102 = select(340282350000000000000000000000000000000f, _e1100, (_e1100 < 340282350000000000000000000000000000000f));
                        phi_1999_ = type_22(select(-340282350000000000000000000000000000000f, _e1102, (_e1102 > -340282350000000000000000000000000000000f)), _e1080.member.member_1, _e1080.member.member_2, _e1080.member.member_3);
                    } else {
                        phi_1999_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1109 = phi_1999_;
                    if _e85 {
                    } else {
                        break;
                    }
                    global_4.member[_e77] = _e1109;
                    if _e78 {
                    } else {
                        break;
                    }
                    let _e1113 = select(0u, 1u, (_e152 <= _e162));
                    if (_e1113 > 0u) {
                        let _e1115 = (1u < _e73);
                        if _e1115 {
                            if (0u < _e73) {
                            } else {
                                break;
                            }
                            let _e1119 = atomicAdd((&global_5.member[0u]), _e1113);
                            if ((_e1119 + _e1113) < _e1119) {
                                if _e1115 {
                                } else {
                                    break;
                                }
                                let _e1124 = atomicAdd((&global_5.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1127 = select(0u, 1u, (_e1109.member_3 != 4294967295u));
                    if (_e1127 > 0u) {
                        let _e1129 = (3u < _e73);
                        if _e1129 {
                            if (2u < _e73) {
                            } else {
                                break;
                            }
                            let _e1133 = atomicAdd((&global_5.member[2u]), _e1127);
                            if ((_e1133 + _e1127) < _e1133) {
                                if _e1129 {
                                } else {
                                    break;
                                }
                                let _e1138 = atomicAdd((&global_5.member[3u]), 1u);
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
fn trace_paths(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
