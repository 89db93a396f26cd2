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

struct type_22 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_29 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_31 {
    member: array<type_29>,
}

struct type_33 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_34 {
    member: type_33,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_36 {
    member: array<type_34>,
}

struct type_41 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_43 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_45 {
    member: type_29,
    member_1: f32,
}

struct type_50 {
    member: array<vec4<u32>, 2>,
}

struct type_53 {
    member: array<i32>,
}

struct type_60 {
    member: type_41,
    member_1: u32,
}

struct type_63 {
    member: array<vec4<f32>, 3>,
    member_1: type_60,
    member_2: type_60,
}

struct type_68 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_50;
@group(0) @binding(2) 
var<uniform> global_3: type_50;
@group(0) @binding(3) 
var<storage> global_4: type_13;
@group(0) @binding(4) 
var<storage> global_5: type_24;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_53;
@group(0) @binding(7) 
var<storage> global_8: type_36;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_31;
@group(0) @binding(9) 
var<storage, read_write> global_10: type_68;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_60, 128>;
    var phi_324_: u32;
    var phi_368_: i32;
    var phi_392_: type_43;
    var phi_498_: i32;
    var phi_499_: i32;
    var phi_509_: bool;
    var phi_519_: u32;
    var phi_520_: u32;
    var phi_522_: bool;
    var phi_527_: u32;
    var phi_560_: i32;
    var phi_578_: f32;
    var phi_584_: f32;
    var phi_595_: f32;
    var phi_601_: f32;
    var phi_624_: f32;
    var phi_635_: f32;
    var phi_644_: f32;
    var phi_650_: f32;
    var phi_661_: f32;
    var phi_667_: f32;
    var phi_690_: f32;
    var phi_701_: f32;
    var phi_710_: f32;
    var phi_716_: f32;
    var phi_727_: f32;
    var phi_733_: f32;
    var phi_756_: f32;
    var phi_767_: f32;
    var phi_867_: f32;
    var phi_868_: f32;
    var phi_4768_: bool;
    var phi_1988_: type_45;
    var phi_1991_: type_60;
    var phi_1993_: u32;
    var phi_1995_: bool;
    var phi_1997_: u32;
    var phi_2008_: bool;
    var phi_2045_: type_60;
    var phi_2046_: bool;
    var phi_2047_: u32;
    var phi_3998_: u32;
    var phi_3999_: u32;
    var phi_4009_: u32;
    var phi_4011_: u32;
    var phi_4012_: bool;
    var phi_4032_: u32;
    var phi_4033_: u32;
    var phi_4037_: type_63;
    var phi_4381_: type_60;
    var phi_4414_: type_60;
    var phi_4415_: type_60;
    var phi_4416_: u32;
    var phi_4418_: type_60;
    var phi_4419_: u32;
    var phi_4420_: bool;
    var phi_4429_: type_60;
    var phi_4434_: type_60;
    var phi_4435_: bool;
    var phi_2065_: type_45;
    var phi_2068_: type_8;
    var phi_2069_: type_8;
    var phi_2091_: type_8;
    var phi_2112_: u32;
    var phi_2201_: array<array<f32, 3>, 3>;
    var phi_2672_: vec3<f32>;
    var phi_2673_: vec3<f32>;
    var phi_2704_: bool;
    var phi_2713_: vec3<f32>;
    var phi_2753_: type_29;
    var phi_2755_: type_29;
    var phi_2756_: bool;
    var phi_2760_: type_29;
    var phi_2761_: type_29;
    var phi_2762_: type_29;
    var phi_2763_: bool;
    var phi_2767_: type_29;
    var phi_2768_: bool;
    var phi_2772_: type_29;
    var phi_2773_: bool;
    var phi_2777_: type_29;
    var phi_2800_: u32;
    var phi_2814_: i32;
    var phi_2834_: vec3<f32>;
    var phi_2835_: vec3<f32>;
    var phi_2851_: vec3<f32>;
    var phi_2852_: vec3<f32>;
    var phi_2868_: vec3<f32>;
    var phi_2869_: vec3<f32>;
    var phi_2905_: vec3<f32>;
    var phi_3087_: f32;
    var phi_3105_: bool;
    var phi_3106_: bool;
    var phi_3125_: bool;
    var phi_3126_: bool;
    var phi_3132_: type_45;
    var phi_3133_: type_45;
    var phi_3134_: type_45;
    var phi_2066_: type_45;
    var phi_4762_: bool;
    var phi_4904_: bool;
    var phi_4437_: type_45;
    var phi_4438_: type_60;
    var phi_4439_: bool;
    var phi_4440_: u32;
    var phi_4903_: bool;
    var phi_4441_: type_45;
    var phi_4442_: type_60;
    var phi_4443_: u32;
    var phi_4444_: bool;
    var phi_4445_: u32;
    var phi_4902_: bool;
    var phi_4446_: type_45;
    var phi_4447_: type_60;
    var phi_4448_: u32;
    var phi_4449_: bool;
    var phi_4450_: u32;
    var phi_4901_: bool;
    var phi_1989_: type_45;
    var phi_1992_: type_60;
    var phi_1994_: u32;
    var phi_1996_: bool;
    var phi_1998_: u32;
    var phi_4451_: bool;
    var phi_4900_: bool;
    var local_4: type_45;
    var phi_4503_: type_29;
    var local_5: type_45;

    switch bitcast<i32>(0u) {
        default: {
            let _e89 = global;
            let _e91 = arrayLength((&global_4.member));
            let _e93 = arrayLength((&global_5.member));
            let _e105 = arrayLength((&global_10.member));
            let _e109 = global_3.member[0u][0u];
            let _e113 = global_3.member[0u][1u];
            let _e117 = global_3.member[0u][2u];
            let _e121 = global_3.member[0u][3u];
            let _e125 = global_3.member[1u][0u];
            let _e129 = global_3.member[1u][1u];
            let _e133 = global_3.member[1u][2u];
            let _e137 = (_e89.x + (_e89.y * 2097152u));
            let _e149 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e121) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e109), bitcast<i32>(_e113), bitcast<i32>(_e117));
            local = array<i32, 3>(bitcast<i32>(_e125), bitcast<i32>(_e129), bitcast<i32>(_e133));
            let _e152 = (_e137 < arrayLength((&global_8.member)));
            if _e152 {
                if _e152 {
                } else {
                    break;
                }
                let _e156 = global_8.member[_e137].member_2;
                phi_324_ = _e156;
            } else {
                phi_324_ = 4294967295u;
            }
            let _e158 = phi_324_;
            let _e161 = global_1.member[0u];
            let _e165 = global_2.member[0u][0u];
            let _e169 = global_2.member[0u][1u];
            let _e173 = global_2.member[0u][2u];
            let _e177 = global_2.member[0u][3u];
            let _e181 = global_2.member[1u][0u];
            let _e185 = global_2.member[1u][1u];
            let _e189 = global_2.member[1u][2u];
            let _e193 = global_2.member[1u][3u];
            let _e194 = bitcast<f32>(_e165);
            let _e195 = bitcast<f32>(_e169);
            let _e196 = bitcast<f32>(_e173);
            let _e198 = bitcast<f32>(_e181);
            let _e199 = array<u32, 3>(_e185, _e189, _e193);
            let _e201 = bitcast<i32>(_e161);
            if (_e201 < -126i) {
                phi_368_ = -126i;
            } else {
                phi_368_ = select(_e201, 127i, (_e201 > 127i));
            }
            let _e206 = phi_368_;
            let _e211 = bitcast<f32>((bitcast<u32>((_e206 + 127i)) << bitcast<u32>(23i)));
            let _e217 = bitcast<f32>((bitcast<u32>(((_e201 - _e206) + 127i)) << bitcast<u32>(23i)));
            if (_e177 == 0u) {
                phi_392_ = type_43(array<f32, 3>(_e194, _e195, _e196), _e177, _e198, _e199);
            } else {
                phi_392_ = type_43(array<f32, 3>(((_e194 * _e211) * _e217), ((_e195 * _e211) * _e217), ((_e196 * _e211) * _e217)), _e177, ((_e198 * _e211) * _e217), _e199);
            }
            let _e230 = phi_392_;
            if _e152 {
                let _e231 = (_e137 < arrayLength((&global_9.member)));
                if _e231 {
                    if _e152 {
                    } else {
                        break;
                    }
                    let _e241 = global_8.member[_e137].member.member_2[0u];
                    let _e243 = (bitcast<u32>(_e241) & 2147483647u);
                    let _e249 = global_8.member[_e137].member.member_2[1u];
                    let _e251 = (bitcast<u32>(_e249) & 2147483647u);
                    let _e257 = global_8.member[_e137].member.member_2[2u];
                    let _e259 = (bitcast<u32>(_e257) & 2147483647u);
                    let _e265 = global_8.member[_e137].member.member[0u];
                    let _e267 = (bitcast<u32>(_e265) & 2147483647u);
                    let _e273 = global_8.member[_e137].member.member[1u];
                    let _e275 = (bitcast<u32>(_e273) & 2147483647u);
                    let _e281 = global_8.member[_e137].member.member[2u];
                    let _e283 = (bitcast<u32>(_e281) & 2147483647u);
                    let _e285 = select(_e251, _e243, (_e251 < _e243));
                    let _e287 = select(_e259, _e285, (_e259 < _e285));
                    let _e289 = select(_e267, _e287, (_e267 < _e287));
                    let _e291 = select(_e275, _e289, (_e275 < _e289));
                    let _e293 = select(_e283, _e291, (_e283 < _e291));
                    let _e298 = global_8.member[_e137].member.member_1;
                    let _e300 = (bitcast<u32>(_e298) & 2147483647u);
                    let _e308 = global_8.member[_e137].member.member_3;
                    let _e314 = (((select(_e300, _e293, (_e300 < _e293)) < 2139095040u) && ((bitcast<u32>(_e308) & 2147483647u) <= 2139095040u)) && (_e287 > 0u));
                    if _e314 {
                        let _e317 = (bitcast<u32>(bitcast<f32>(_e287)) & 2147483647u);
                        if (_e317 >= 8388608u) {
                            phi_498_ = (bitcast<i32>((_e317 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_498_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e317)), 32u, (_e317 == 0u))));
                        }
                        let _e331 = phi_498_;
                        phi_499_ = _e331;
                    } else {
                        phi_499_ = 0i;
                    }
                    let _e333 = phi_499_;
                    let _e334 = (_e243 == _e287);
                    if _e334 {
                        phi_509_ = true;
                    } else {
                        phi_509_ = (_e251 == _e287);
                    }
                    let _e337 = phi_509_;
                    let _e338 = select(1u, 0u, _e334);
                    if _e337 {
                        let _e339 = (_e338 + 1u);
                        phi_519_ = _e339;
                        phi_520_ = _e339;
                        phi_522_ = select(true, false, (_e339 == 2u));
                    } else {
                        phi_519_ = u32();
                        phi_520_ = 0u;
                        phi_522_ = true;
                    }
                    let _e343 = phi_519_;
                    let _e345 = phi_520_;
                    let _e347 = phi_522_;
                    if _e347 {
                        phi_527_ = (_e345 + 1u);
                    } else {
                        phi_527_ = 0u;
                    }
                    let _e351 = phi_527_;
                    let _e352 = select(_e343, _e345, _e347);
                    let _e353 = select(_e338, select(2u, _e338, _e337), _e347);
                    let _e354 = -(_e333);
                    if (_e354 < -126i) {
                        phi_560_ = -126i;
                    } else {
                        phi_560_ = select(_e354, 127i, (_e354 > 127i));
                    }
                    let _e359 = phi_560_;
                    let _e364 = bitcast<f32>((bitcast<u32>((_e359 + 127i)) << bitcast<u32>(23i)));
                    let _e370 = bitcast<f32>((bitcast<u32>(((_e354 - _e359) + 127i)) << bitcast<u32>(23i)));
                    let _e375 = global_8.member[_e137].member.member;
                    let _e376 = (_e352 == 0u);
                    if _e376 {
                        phi_578_ = _e375[0];
                    } else {
                        phi_578_ = _e375[1];
                    }
                    let _e380 = phi_578_;
                    let _e381 = (_e352 == 2u);
                    if _e381 {
                        phi_584_ = _e375[2];
                    } else {
                        phi_584_ = _e380;
                    }
                    let _e384 = phi_584_;
                    let _e385 = global_8.member[_e137].member.member_2;
                    if _e376 {
                        phi_595_ = _e385[0];
                    } else {
                        phi_595_ = _e385[1];
                    }
                    let _e389 = phi_595_;
                    if _e381 {
                        phi_601_ = _e385[2];
                    } else {
                        phi_601_ = _e389;
                    }
                    let _e392 = phi_601_;
                    let _e394 = ((_e392 * _e364) * _e370);
                    let _e398 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e398 {
                        let _e402 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) * 0.00000011920929f);
                        phi_624_ = select(0.00000000000011368684f, _e402, (_e402 > 0.00000000000011368684f));
                    } else {
                        phi_624_ = 0f;
                    }
                    let _e406 = phi_624_;
                    let _e407 = (_e384 + _e406);
                    let _e408 = (_e384 - _e406);
                    let _e409 = select(_e394, 0f, _e398);
                    if _e398 {
                        phi_635_ = 38685626000000000000000000f;
                    } else {
                        phi_635_ = (1f / _e394);
                    }
                    let _e412 = phi_635_;
                    let _e413 = (_e351 == 0u);
                    if _e413 {
                        phi_644_ = _e375[0];
                    } else {
                        phi_644_ = _e375[1];
                    }
                    let _e417 = phi_644_;
                    let _e418 = (_e351 == 2u);
                    if _e418 {
                        phi_650_ = _e375[2];
                    } else {
                        phi_650_ = _e417;
                    }
                    let _e421 = phi_650_;
                    if _e413 {
                        phi_661_ = _e385[0];
                    } else {
                        phi_661_ = _e385[1];
                    }
                    let _e425 = phi_661_;
                    if _e418 {
                        phi_667_ = _e385[2];
                    } else {
                        phi_667_ = _e425;
                    }
                    let _e428 = phi_667_;
                    let _e430 = ((_e428 * _e364) * _e370);
                    let _e434 = (bitcast<f32>((bitcast<u32>(_e430) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e434 {
                        let _e438 = (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) * 0.00000011920929f);
                        phi_690_ = select(0.00000000000011368684f, _e438, (_e438 > 0.00000000000011368684f));
                    } else {
                        phi_690_ = 0f;
                    }
                    let _e442 = phi_690_;
                    let _e443 = (_e421 + _e442);
                    let _e444 = (_e421 - _e442);
                    let _e445 = select(_e430, 0f, _e434);
                    if _e434 {
                        phi_701_ = 38685626000000000000000000f;
                    } else {
                        phi_701_ = (1f / _e430);
                    }
                    let _e448 = phi_701_;
                    let _e449 = (_e353 == 0u);
                    if _e449 {
                        phi_710_ = _e375[0];
                    } else {
                        phi_710_ = _e375[1];
                    }
                    let _e453 = phi_710_;
                    let _e454 = (_e353 == 2u);
                    if _e454 {
                        phi_716_ = _e375[2];
                    } else {
                        phi_716_ = _e453;
                    }
                    let _e457 = phi_716_;
                    if _e449 {
                        phi_727_ = _e385[0];
                    } else {
                        phi_727_ = _e385[1];
                    }
                    let _e461 = phi_727_;
                    if _e454 {
                        phi_733_ = _e385[2];
                    } else {
                        phi_733_ = _e461;
                    }
                    let _e464 = phi_733_;
                    let _e466 = ((_e464 * _e364) * _e370);
                    let _e470 = (bitcast<f32>((bitcast<u32>(_e466) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e470 {
                        let _e474 = (bitcast<f32>((bitcast<u32>(_e457) & 2147483647u)) * 0.00000011920929f);
                        phi_756_ = select(0.00000000000011368684f, _e474, (_e474 > 0.00000000000011368684f));
                    } else {
                        phi_756_ = 0f;
                    }
                    let _e478 = phi_756_;
                    let _e479 = (_e457 + _e478);
                    let _e480 = (_e457 - _e478);
                    let _e481 = select(_e466, 0f, _e470);
                    if _e470 {
                        phi_767_ = 38685626000000000000000000f;
                    } else {
                        phi_767_ = (1f / _e466);
                    }
                    let _e484 = phi_767_;
                    let _e487 = bitcast<f32>((bitcast<u32>(_e384) & 2147483647u));
                    let _e490 = bitcast<f32>((bitcast<u32>(_e421) & 2147483647u));
                    let _e492 = select(_e490, _e487, (_e487 > _e490));
                    let _e495 = bitcast<f32>((bitcast<u32>(_e457) & 2147483647u));
                    if (_e314 && (select(_e495, _e492, (_e492 > _e495)) <= 1099511600000f)) {
                        let _e500 = (_e333 / 3i);
                        let _e507 = bitcast<f32>((bitcast<u32>((_e500 + 127i)) << bitcast<u32>(23i)));
                        let _e514 = bitcast<f32>((bitcast<u32>(((_e333 - (2i * _e500)) + 127i)) << bitcast<u32>(23i)));
                        let _e515 = (((_e298 * _e507) * _e507) * _e514);
                        let _e517 = select(340282350000000000000000000000000000000f, _e515, (_e515 < 340282350000000000000000000000000000000f));
                        let _e522 = (((_e308 * _e507) * _e507) * _e514);
                        let _e524 = select(340282350000000000000000000000000000000f, _e522, (_e522 < 340282350000000000000000000000000000000f));
                        phi_867_ = select(-340282350000000000000000000000000000000f, _e524, (_e524 > -340282350000000000000000000000000000000f));
                        phi_868_ = select(-340282350000000000000000000000000000000f, _e517, (_e517 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_867_ = 0f;
                        phi_868_ = 1f;
                    }
                    let _e528 = phi_867_;
                    let _e530 = phi_868_;
                    local_3 = array<type_60, 128>(type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e534 = (_e352 % 3u);
                    let _e535 = (_e534 < 3u);
                    if _e535 {
                    } else {
                        break;
                    }
                    let _e537 = local_1[_e534];
                    let _e540 = (_e351 % 3u);
                    let _e541 = (_e540 < 3u);
                    if _e541 {
                    } else {
                        break;
                    }
                    let _e543 = local_1[_e540];
                    let _e546 = (_e353 % 3u);
                    let _e547 = (_e546 < 3u);
                    if _e547 {
                    } else {
                        break;
                    }
                    let _e549 = local_1[_e546];
                    if _e535 {
                    } else {
                        break;
                    }
                    let _e554 = local[_e534];
                    if _e541 {
                    } else {
                        break;
                    }
                    let _e558 = local[_e540];
                    if _e547 {
                    } else {
                        break;
                    }
                    let _e562 = local[_e546];
                    phi_4768_ = false;
                    phi_1988_ = type_45(type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e528);
                    phi_1991_ = type_60(type_41(vec4<f32>((f32(_e537) * _e149), (f32(_e543) * _e149), (f32(_e549) * _e149), 0f), vec4<f32>((f32(_e554) * _e149), (f32(_e558) * _e149), (f32(_e562) * _e149), 0f)), select(0u, 2147483648u, (_e91 == 0u)));
                    phi_1993_ = ((3u * _e91) + 1u);
                    phi_1995_ = (_e530 <= _e528);
                    phi_1997_ = 0u;
                    loop {
                        let _e572 = phi_4768_;
                        let _e574 = phi_1988_;
                        let _e576 = phi_1991_;
                        let _e578 = phi_1993_;
                        let _e580 = phi_1995_;
                        let _e582 = phi_1997_;
                        local_4 = _e574;
                        if _e580 {
                            phi_2008_ = true;
                        } else {
                            phi_2008_ = (_e582 > 0u);
                        }
                        let _e585 = phi_2008_;
                        if _e585 {
                            let _e586 = (_e578 > 0u);
                            if _e586 {
                                if _e580 {
                                    phi_2045_ = _e576;
                                    phi_2046_ = _e580;
                                    phi_2047_ = _e582;
                                } else {
                                    let _e587 = (_e582 - 1u);
                                    let _e588 = (_e587 % 128u);
                                    let _e589 = (_e588 < 128u);
                                    if _e589 {
                                    } else {
                                        phi_4900_ = true;
                                        break;
                                    }
                                    let _e591 = local_3[_e588];
                                    if _e589 {
                                    } else {
                                        phi_4900_ = true;
                                        break;
                                    }
                                    let _e599 = local_2[_e588];
                                    phi_2045_ = type_60(type_41(_e591.member.member, _e591.member.member_1), _e591.member_1);
                                    phi_2046_ = (_e599 <= _e574.member_1);
                                    phi_2047_ = _e587;
                                }
                                let _e603 = phi_2045_;
                                let _e605 = phi_2046_;
                                let _e607 = phi_2047_;
                                if _e605 {
                                    if ((_e603.member_1 & 2147483648u) != 0u) {
                                        phi_2065_ = _e574;
                                        phi_2068_ = type_8(0u, ((_e603.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1053 = phi_2065_;
                                            let _e1055 = phi_2068_;
                                            local_5 = _e1053;
                                            if (_e1055.member < _e1055.member_1) {
                                                phi_2069_ = type_8((_e1055.member + 1u), _e1055.member_1);
                                                phi_2091_ = type_8(1u, _e1055.member);
                                            } else {
                                                phi_2069_ = _e1055;
                                                phi_2091_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1068 = phi_2069_;
                                            let _e1070 = phi_2091_;
                                            let _e1074 = (bitcast<i32>(_e1070.member) != 0i);
                                            if _e1074 {
                                                let _e1075 = ((_e603.member_1 & 268435455u) + _e1070.member_1);
                                                let _e1076 = (_e1075 < _e93);
                                                if _e1076 {
                                                    if _e1076 {
                                                    } else {
                                                        phi_4762_ = true;
                                                        break;
                                                    }
                                                    let _e1080 = global_5.member[_e1075].member_1;
                                                    phi_2112_ = _e1080;
                                                } else {
                                                    phi_2112_ = 4294967295u;
                                                }
                                                let _e1082 = phi_2112_;
                                                if (_e1075 >= _e93) {
                                                    phi_2201_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1076 {
                                                    } else {
                                                        phi_4762_ = true;
                                                        break;
                                                    }
                                                    if (_e534 < 9u) {
                                                    } else {
                                                        phi_4762_ = true;
                                                        break;
                                                    }
                                                    let _e1089 = global_5.member[_e1075].member[_e534];
                                                    if (_e540 < 9u) {
                                                    } else {
                                                        phi_4762_ = true;
                                                        break;
                                                    }
                                                    let _e1095 = global_5.member[_e1075].member[_e540];
                                                    if (_e546 < 9u) {
                                                    } else {
                                                        phi_4762_ = true;
                                                        break;
                                                    }
                                                    let _e1101 = global_5.member[_e1075].member[_e546];
                                                    let _e1103 = (3u + _e534);
                                                    if (_e1103 < 9u) {
                                                    } else {
                                                        phi_4762_ = true;
                                                        break;
                                                    }
                                                    let _e1109 = global_5.member[_e1075].member[_e1103];
                                                    let _e1110 = (3u + _e540);
                                                    if (_e1110 < 9u) {
                                                    } else {
                                                        phi_4762_ = true;
                                                        break;
                                                    }
                                                    let _e1116 = global_5.member[_e1075].member[_e1110];
                                                    let _e1117 = (3u + _e546);
                                                    if (_e1117 < 9u) {
                                                    } else {
                                                        phi_4762_ = true;
                                                        break;
                                                    }
                                                    let _e1123 = global_5.member[_e1075].member[_e1117];
                                                    let _e1125 = (6u + _e534);
                                                    if (_e1125 < 9u) {
                                                    } else {
                                                        phi_4762_ = true;
                                                        break;
                                                    }
                                                    let _e1131 = global_5.member[_e1075].member[_e1125];
                                                    let _e1132 = (6u + _e540);
                                                    if (_e1132 < 9u) {
                                                    } else {
                                                        phi_4762_ = true;
                                                        break;
                                                    }
                                                    let _e1138 = global_5.member[_e1075].member[_e1132];
                                                    let _e1139 = (6u + _e546);
                                                    if (_e1139 < 9u) {
                                                    } else {
                                                        phi_4762_ = true;
                                                        break;
                                                    }
                                                    let _e1145 = global_5.member[_e1075].member[_e1139];
                                                    phi_2201_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1089, _e1095, _e1101), array<f32, 3>(_e1109, _e1116, _e1123), array<f32, 3>(_e1131, _e1138, _e1145));
                                                }
                                                let _e1149 = phi_2201_;
                                                let _e1157 = (_e1149[0][2] - _e457);
                                                let _e1160 = (((_e1149[0][0] - _e384) * _e481) - (_e1157 * _e409));
                                                let _e1163 = (((_e1149[0][1] - _e421) * _e481) - (_e1157 * _e445));
                                                let _e1170 = (_e1149[1][2] - _e457);
                                                let _e1173 = (((_e1149[1][0] - _e384) * _e481) - (_e1170 * _e409));
                                                let _e1176 = (((_e1149[1][1] - _e421) * _e481) - (_e1170 * _e445));
                                                let _e1183 = (_e1149[2][2] - _e457);
                                                let _e1186 = (((_e1149[2][0] - _e384) * _e481) - (_e1183 * _e409));
                                                let _e1189 = (((_e1149[2][1] - _e421) * _e481) - (_e1183 * _e445));
                                                let _e1190 = (_e1186 * _e1176);
                                                let _e1191 = (_e1189 * _e1173);
                                                let _e1192 = (_e1160 * _e1189);
                                                let _e1193 = (_e1163 * _e1186);
                                                let _e1194 = (_e1173 * _e1163);
                                                let _e1195 = (_e1176 * _e1160);
                                                let _e1200 = (((_e1190 >= _e1191) && (_e1192 >= _e1193)) && (_e1194 >= _e1195));
                                                if (_e1200 || (((_e1190 <= _e1191) && (_e1192 <= _e1193)) && (_e1194 <= _e1195))) {
                                                    let _e1207 = select(-1f, 1f, _e1200);
                                                    let _e1209 = ((_e1190 - _e1191) * _e1207);
                                                    let _e1211 = select(0f, _e1209, (_e1209 > 0f));
                                                    let _e1213 = ((_e1192 - _e1193) * _e1207);
                                                    let _e1215 = select(0f, _e1213, (_e1213 > 0f));
                                                    let _e1217 = ((_e1194 - _e1195) * _e1207);
                                                    let _e1219 = select(0f, _e1217, (_e1217 > 0f));
                                                    let _e1221 = ((_e1211 + _e1215) + _e1219);
                                                    if (_e1221 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2767_ = type_29();
                                                        phi_2768_ = true;
                                                    } else {
                                                        let _e1224 = select(_e1149[1][0], _e1149[0][0], (_e1149[0][0] < _e1149[1][0]));
                                                        let _e1228 = select(_e1149[1][0], _e1149[0][0], (_e1149[0][0] > _e1149[1][0]));
                                                        let _e1232 = select(_e1149[1][1], _e1149[0][1], (_e1149[0][1] < _e1149[1][1]));
                                                        let _e1236 = select(_e1149[1][1], _e1149[0][1], (_e1149[0][1] > _e1149[1][1]));
                                                        let _e1240 = select(_e1149[1][2], _e1149[0][2], (_e1149[0][2] < _e1149[1][2]));
                                                        let _e1244 = select(_e1149[1][2], _e1149[0][2], (_e1149[0][2] > _e1149[1][2]));
                                                        let _e1249 = ((select(_e1149[2][0], _e1224, (_e1224 < _e1149[2][0])) - _e407) * _e412);
                                                        let _e1250 = ((select(_e1149[2][0], _e1228, (_e1228 > _e1149[2][0])) - _e408) * _e412);
                                                        let _e1253 = ((select(_e1149[2][1], _e1232, (_e1232 < _e1149[2][1])) - _e443) * _e448);
                                                        let _e1254 = ((select(_e1149[2][1], _e1236, (_e1236 > _e1149[2][1])) - _e444) * _e448);
                                                        let _e1257 = ((select(_e1149[2][2], _e1240, (_e1240 < _e1149[2][2])) - _e479) * _e484);
                                                        let _e1258 = ((select(_e1149[2][2], _e1244, (_e1244 > _e1149[2][2])) - _e480) * _e484);
                                                        let _e1260 = select(_e1258, _e1257, (_e1257 < _e1258));
                                                        let _e1262 = select(_e1258, _e1257, (_e1257 > _e1258));
                                                        let _e1264 = select(_e1250, _e1249, (_e1249 < _e1250));
                                                        let _e1266 = select(_e1254, _e1253, (_e1253 < _e1254));
                                                        let _e1268 = select(_e1266, _e1264, (_e1264 > _e1266));
                                                        let _e1270 = select(_e1260, _e1268, (_e1268 > _e1260));
                                                        let _e1272 = select(_e1250, _e1249, (_e1249 > _e1250));
                                                        let _e1274 = select(_e1254, _e1253, (_e1253 > _e1254));
                                                        let _e1276 = select(_e1274, _e1272, (_e1272 < _e1274));
                                                        let _e1278 = select(_e1262, _e1276, (_e1276 < _e1262));
                                                        let _e1279 = -(_e1260);
                                                        let _e1285 = select(_e530, _e1270, (_e1270 > _e530));
                                                        if (_e1285 > (_e1278 + (select(_e1279, _e1262, (_e1262 > _e1279)) * 0.0000019073523f))) {
                                                            phi_2762_ = type_29();
                                                            phi_2763_ = true;
                                                        } else {
                                                            let _e1287 = (_e1285 > _e1053.member_1);
                                                            if _e1287 {
                                                                phi_2761_ = type_29();
                                                            } else {
                                                                let _e1291 = (_e1149[1][0] - _e1149[0][0]);
                                                                let _e1292 = (_e1149[1][1] - _e1149[0][1]);
                                                                let _e1293 = (_e1149[1][2] - _e1149[0][2]);
                                                                let _e1294 = vec3<f32>(_e1291, _e1292, _e1293);
                                                                let _e1295 = (_e1149[2][0] - _e1149[1][0]);
                                                                let _e1296 = (_e1149[2][1] - _e1149[1][1]);
                                                                let _e1297 = (_e1149[2][2] - _e1149[1][2]);
                                                                let _e1298 = vec3<f32>(_e1295, _e1296, _e1297);
                                                                let _e1299 = (_e1149[0][0] - _e1149[2][0]);
                                                                let _e1300 = (_e1149[0][1] - _e1149[2][1]);
                                                                let _e1301 = (_e1149[0][2] - _e1149[2][2]);
                                                                let _e1302 = vec3<f32>(_e1299, _e1300, _e1301);
                                                                let _e1305 = bitcast<f32>((bitcast<u32>(_e1291) & 2147483647u));
                                                                let _e1308 = bitcast<f32>((bitcast<u32>(_e1292) & 2147483647u));
                                                                let _e1310 = select(_e1308, _e1305, (_e1305 > _e1308));
                                                                let _e1313 = bitcast<f32>((bitcast<u32>(_e1293) & 2147483647u));
                                                                let _e1315 = select(_e1313, _e1310, (_e1310 > _e1313));
                                                                let _e1318 = bitcast<f32>((bitcast<u32>(_e1295) & 2147483647u));
                                                                let _e1321 = bitcast<f32>((bitcast<u32>(_e1296) & 2147483647u));
                                                                let _e1323 = select(_e1321, _e1318, (_e1318 > _e1321));
                                                                let _e1326 = bitcast<f32>((bitcast<u32>(_e1297) & 2147483647u));
                                                                let _e1328 = select(_e1326, _e1323, (_e1323 > _e1326));
                                                                let _e1331 = bitcast<f32>((bitcast<u32>(_e1299) & 2147483647u));
                                                                let _e1334 = bitcast<f32>((bitcast<u32>(_e1300) & 2147483647u));
                                                                let _e1336 = select(_e1334, _e1331, (_e1331 > _e1334));
                                                                let _e1339 = bitcast<f32>((bitcast<u32>(_e1301) & 2147483647u));
                                                                let _e1341 = select(_e1339, _e1336, (_e1336 > _e1339));
                                                                let _e1343 = select(_e1328, _e1315, (_e1315 > _e1328));
                                                                let _e1345 = select(_e1341, _e1343, (_e1343 > _e1341));
                                                                if (_e1315 == _e1345) {
                                                                    phi_2672_ = _e1298;
                                                                    phi_2673_ = _e1302;
                                                                } else {
                                                                    let _e1348 = vec3((_e1328 == _e1345));
                                                                    phi_2672_ = select(_e1294, _e1302, _e1348);
                                                                    phi_2673_ = select(_e1298, _e1294, _e1348);
                                                                }
                                                                let _e1352 = phi_2672_;
                                                                let _e1354 = phi_2673_;
                                                                let _e1361 = ((_e1352.y * _e1354.z) - (_e1354.y * _e1352.z));
                                                                let _e1366 = ((_e1352.z * _e1354.x) - (_e1354.z * _e1352.x));
                                                                let _e1369 = ((_e1352.x * _e1354.y) - (_e1354.x * _e1352.y));
                                                                if (_e1211 >= _e1215) {
                                                                    phi_2704_ = select(true, false, (_e1211 >= _e1219));
                                                                } else {
                                                                    phi_2704_ = true;
                                                                }
                                                                let _e1374 = phi_2704_;
                                                                if _e1374 {
                                                                    phi_2713_ = select(vec3<f32>(_e1149[2][0], _e1149[2][1], _e1149[2][2]), vec3<f32>(_e1149[1][0], _e1149[1][1], _e1149[1][2]), vec3((_e1215 >= _e1219)));
                                                                } else {
                                                                    phi_2713_ = vec3<f32>(_e1149[0][0], _e1149[0][1], _e1149[0][2]);
                                                                }
                                                                let _e1379 = phi_2713_;
                                                                let _e1396 = ((((_e1361 * (_e1379.x - _e384)) + (_e1366 * (_e1379.y - _e421))) + (_e1369 * (_e1379.z - _e457))) / (((_e1361 * _e409) + (_e1366 * _e445)) + (_e1369 * _e481)));
                                                                let _e1398 = select(_e1278, _e1396, (_e1396 < _e1278));
                                                                let _e1400 = select(_e1270, _e1398, (_e1398 > _e1270));
                                                                if (_e1400 >= _e530) {
                                                                    let _e1402 = (_e1400 <= _e1053.member_1);
                                                                    if _e1402 {
                                                                        let _e1403 = (1f / _e1221);
                                                                        phi_2753_ = type_29(_e1400, (_e1215 * _e1403), (_e1219 * _e1403), _e1082);
                                                                    } else {
                                                                        phi_2753_ = type_29();
                                                                    }
                                                                    let _e1408 = phi_2753_;
                                                                    phi_2755_ = _e1408;
                                                                    phi_2756_ = select(true, false, _e1402);
                                                                } else {
                                                                    phi_2755_ = type_29();
                                                                    phi_2756_ = true;
                                                                }
                                                                let _e1411 = phi_2755_;
                                                                let _e1413 = phi_2756_;
                                                                if _e1413 {
                                                                    phi_2760_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2760_ = _e1411;
                                                                }
                                                                let _e1415 = phi_2760_;
                                                                phi_2761_ = _e1415;
                                                            }
                                                            let _e1417 = phi_2761_;
                                                            phi_2762_ = _e1417;
                                                            phi_2763_ = _e1287;
                                                        }
                                                        let _e1419 = phi_2762_;
                                                        let _e1421 = phi_2763_;
                                                        phi_2767_ = _e1419;
                                                        phi_2768_ = _e1421;
                                                    }
                                                    let _e1423 = phi_2767_;
                                                    let _e1425 = phi_2768_;
                                                    phi_2772_ = _e1423;
                                                    phi_2773_ = _e1425;
                                                } else {
                                                    phi_2772_ = type_29();
                                                    phi_2773_ = true;
                                                }
                                                let _e1427 = phi_2772_;
                                                let _e1429 = phi_2773_;
                                                if _e1429 {
                                                    phi_2777_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2777_ = _e1427;
                                                }
                                                let _e1431 = phi_2777_;
                                                if (_e1431.member_3 != 4294967295u) {
                                                    if (_e1082 == _e158) {
                                                        phi_3106_ = false;
                                                    } else {
                                                        let _e1435 = (_e1082 < arrayLength((&global_6.member)));
                                                        if _e1435 {
                                                            if _e1435 {
                                                            } else {
                                                                phi_4762_ = true;
                                                                break;
                                                            }
                                                            let _e1437 = global_6.member[_e1082];
                                                            phi_2800_ = _e1437;
                                                        } else {
                                                            phi_2800_ = 4294967295u;
                                                        }
                                                        let _e1439 = phi_2800_;
                                                        let _e1440 = (_e1439 < arrayLength((&global_7.member)));
                                                        if _e1440 {
                                                            if _e1440 {
                                                            } else {
                                                                phi_4762_ = true;
                                                                break;
                                                            }
                                                            let _e1442 = global_7.member[_e1439];
                                                            phi_2814_ = _e1442;
                                                        } else {
                                                            phi_2814_ = 0i;
                                                        }
                                                        let _e1444 = phi_2814_;
                                                        let _e1445 = (_e1444 == 0i);
                                                        if _e1445 {
                                                            phi_3105_ = true;
                                                        } else {
                                                            if _e376 {
                                                                phi_2835_ = vec3<f32>(_e1149[0][0], _e1149[0][1], _e1149[0][2]);
                                                            } else {
                                                                if (_e352 == 1u) {
                                                                    phi_2834_ = vec3<f32>(_e1149[0][2], _e1149[0][0], _e1149[0][1]);
                                                                } else {
                                                                    phi_2834_ = vec3<f32>(_e1149[0][1], _e1149[0][2], _e1149[0][0]);
                                                                }
                                                                let _e1450 = phi_2834_;
                                                                phi_2835_ = _e1450;
                                                            }
                                                            let _e1453 = phi_2835_;
                                                            if _e376 {
                                                                phi_2852_ = vec3<f32>(_e1149[1][0], _e1149[1][1], _e1149[1][2]);
                                                            } else {
                                                                if (_e352 == 1u) {
                                                                    phi_2851_ = vec3<f32>(_e1149[1][2], _e1149[1][0], _e1149[1][1]);
                                                                } else {
                                                                    phi_2851_ = vec3<f32>(_e1149[1][1], _e1149[1][2], _e1149[1][0]);
                                                                }
                                                                let _e1458 = phi_2851_;
                                                                phi_2852_ = _e1458;
                                                            }
                                                            let _e1461 = phi_2852_;
                                                            if _e376 {
                                                                phi_2869_ = vec3<f32>(_e1149[2][0], _e1149[2][1], _e1149[2][2]);
                                                            } else {
                                                                if (_e352 == 1u) {
                                                                    phi_2868_ = vec3<f32>(_e1149[2][2], _e1149[2][0], _e1149[2][1]);
                                                                } else {
                                                                    phi_2868_ = vec3<f32>(_e1149[2][1], _e1149[2][2], _e1149[2][0]);
                                                                }
                                                                let _e1466 = phi_2868_;
                                                                phi_2869_ = _e1466;
                                                            }
                                                            let _e1469 = phi_2869_;
                                                            let _e1472 = (_e1461.x - _e1453.x);
                                                            let _e1475 = (_e1461.y - _e1453.y);
                                                            let _e1478 = (_e1461.z - _e1453.z);
                                                            let _e1480 = (_e1469.x - _e1453.x);
                                                            let _e1482 = (_e1469.y - _e1453.y);
                                                            let _e1484 = (_e1469.z - _e1453.z);
                                                            if (_e230.member_1 == 1u) {
                                                                phi_2905_ = (vec3<f32>(_e230.member[0], _e230.member[1], _e230.member[2]) - _e1453);
                                                            } else {
                                                                phi_2905_ = vec3<f32>(_e230.member[0], _e230.member[1], _e230.member[2]);
                                                            }
                                                            let _e1499 = phi_2905_;
                                                            let _e1505 = bitcast<f32>((bitcast<u32>((_e1472 * _e1482)) ^ _e230.member_3[0]));
                                                            let _e1509 = bitcast<f32>((bitcast<u32>((_e1475 * _e1480)) ^ _e230.member_3[0]));
                                                            let _e1513 = bitcast<f32>((bitcast<u32>((_e1475 * _e1484)) ^ _e230.member_3[0]));
                                                            let _e1517 = bitcast<f32>((bitcast<u32>((_e1478 * _e1482)) ^ _e230.member_3[0]));
                                                            let _e1521 = bitcast<f32>((bitcast<u32>((_e1478 * _e1480)) ^ _e230.member_3[0]));
                                                            let _e1525 = bitcast<f32>((bitcast<u32>((_e1472 * _e1484)) ^ _e230.member_3[0]));
                                                            let _e1526 = (_e1513 - _e1517);
                                                            let _e1527 = (_e1521 - _e1525);
                                                            let _e1528 = (_e1505 - _e1509);
                                                            let _e1552 = (bitcast<f32>((bitcast<u32>(_e1513) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1517) & 2147483647u)));
                                                            let _e1559 = (bitcast<f32>((bitcast<u32>(_e1521) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1525) & 2147483647u)));
                                                            let _e1566 = (bitcast<f32>((bitcast<u32>(_e1505) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1509) & 2147483647u)));
                                                            if (_e230.member_2 == 0f) {
                                                                phi_3087_ = 0f;
                                                            } else {
                                                                let _e1596 = bitcast<f32>((bitcast<u32>(_e1526) & 2147483647u));
                                                                let _e1599 = bitcast<f32>((bitcast<u32>(_e1527) & 2147483647u));
                                                                let _e1602 = bitcast<f32>((bitcast<u32>(_e1528) & 2147483647u));
                                                                let _e1604 = select(_e1602, _e1599, (_e1599 > _e1602));
                                                                let _e1608 = select(_e1602, _e1599, (_e1599 < _e1602));
                                                                let _e1612 = select(_e1599, _e1596, (_e1596 < _e1599));
                                                                let _e1614 = select(_e1599, _e1596, (_e1596 > _e1599));
                                                                let _e1616 = select(_e1602, _e1614, (_e1614 < _e1602));
                                                                phi_3087_ = bitcast<f32>((bitcast<u32>((_e230.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1604, _e1596, (_e1596 > _e1604)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1616, _e1612, (_e1612 > _e1616)))) ^ _e230.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1608, _e1596, (_e1596 < _e1608)))) ^ _e230.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1552 + _e1559) + _e1566))) ^ _e230.member_3[0]))) * 1.0000005f)) ^ _e230.member_3[0])))) ^ _e230.member_3[0]));
                                                            }
                                                            let _e1643 = phi_3087_;
                                                            phi_3105_ = (_e1445 || !(((((bitcast<f32>((bitcast<u32>((_e1499.x * _e1526)) ^ _e230.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1499.y * _e1527)) ^ _e230.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1499.z * _e1528)) ^ _e230.member_3[0]))) * f32(-(_e1444))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1499.x) & 2147483647u)) * _e1552)) ^ _e230.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1499.y) & 2147483647u)) * _e1559)) ^ _e230.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1499.z) & 2147483647u)) * _e1566)) ^ _e230.member_3[0]))))) ^ _e230.member_3[0])) + _e1643) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1657 = phi_3105_;
                                                        phi_3106_ = _e1657;
                                                    }
                                                    let _e1659 = phi_3106_;
                                                    if _e1659 {
                                                        if (_e1431.member < _e1053.member.member) {
                                                            phi_3126_ = true;
                                                        } else {
                                                            if (_e1431.member == _e1053.member.member) {
                                                                phi_3125_ = (_e1431.member_3 < _e1053.member.member_3);
                                                            } else {
                                                                phi_3125_ = false;
                                                            }
                                                            let _e1669 = phi_3125_;
                                                            phi_3126_ = _e1669;
                                                        }
                                                        let _e1671 = phi_3126_;
                                                        if _e1671 {
                                                            phi_3132_ = type_45(_e1431, _e1431.member);
                                                        } else {
                                                            phi_3132_ = _e1053;
                                                        }
                                                        let _e1674 = phi_3132_;
                                                        phi_3133_ = _e1674;
                                                    } else {
                                                        phi_3133_ = _e1053;
                                                    }
                                                    let _e1676 = phi_3133_;
                                                    phi_3134_ = _e1676;
                                                } else {
                                                    phi_3134_ = _e1053;
                                                }
                                                let _e1678 = phi_3134_;
                                                phi_2066_ = _e1678;
                                            } else {
                                                phi_2066_ = type_45();
                                            }
                                            let _e1680 = phi_2066_;
                                            continue;
                                            continuing {
                                                phi_2065_ = _e1680;
                                                phi_2068_ = _e1068;
                                                phi_4762_ = _e572;
                                                break if !(_e1074);
                                            }
                                        }
                                        let _e1683 = phi_4762_;
                                        phi_4900_ = _e1683;
                                        if _e1683 {
                                            break;
                                        }
                                        phi_4904_ = _e1683;
                                        let _e1898 = local_5;
                                        phi_4437_ = _e1898;
                                        phi_4438_ = _e603;
                                        phi_4439_ = false;
                                        phi_4440_ = _e607;
                                    } else {
                                        if (_e603.member_1 >= _e91) {
                                            phi_4037_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e603.member_1 < _e91) {
                                            } else {
                                                phi_4900_ = true;
                                                break;
                                            }
                                            let _e619 = ((1u + _e352) % 4u);
                                            if (_e619 < 4u) {
                                            } else {
                                                phi_4900_ = true;
                                                break;
                                            }
                                            let _e624 = global_4.member[_e603.member_1][_e619];
                                            let _e626 = ((1u + _e351) % 4u);
                                            if (_e626 < 4u) {
                                            } else {
                                                phi_4900_ = true;
                                                break;
                                            }
                                            let _e631 = global_4.member[_e603.member_1][_e626];
                                            let _e633 = ((1u + _e353) % 4u);
                                            if (_e633 < 4u) {
                                            } else {
                                                phi_4900_ = true;
                                                break;
                                            }
                                            let _e638 = global_4.member[_e603.member_1][_e633];
                                            let _e640 = ((_e352 + 1u) % 4u);
                                            if (_e640 < 4u) {
                                            } else {
                                                phi_4900_ = true;
                                                break;
                                            }
                                            let _e645 = global_4.member[_e603.member_1][_e640];
                                            let _e647 = (_e645 >> bitcast<u32>(11u));
                                            let _e649 = ((_e351 + 1u) % 4u);
                                            if (_e649 < 4u) {
                                            } else {
                                                phi_4900_ = true;
                                                break;
                                            }
                                            let _e654 = global_4.member[_e603.member_1][_e649];
                                            let _e656 = (_e654 >> bitcast<u32>(11u));
                                            let _e658 = ((_e353 + 1u) % 4u);
                                            if (_e658 < 4u) {
                                            } else {
                                                phi_4900_ = true;
                                                break;
                                            }
                                            let _e663 = global_4.member[_e603.member_1][_e658];
                                            let _e665 = (_e663 >> bitcast<u32>(11u));
                                            let _e688 = (bitcast<f32>((bitcast<u32>((_e603.member.member_1.x - _e603.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e689 = (bitcast<f32>((bitcast<u32>((_e603.member.member_1.y - _e603.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e690 = (bitcast<f32>((bitcast<u32>((_e603.member.member_1.z - _e603.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e692 = select(_e149, _e688, (_e688 > _e149));
                                            let _e694 = select(_e149, _e689, (_e689 > _e149));
                                            let _e696 = select(_e149, _e690, (_e690 > _e149));
                                            let _e721 = bitcast<u32>((f32(bitcast<i32>((_e624 & 1023u))) * _e692));
                                            let _e726 = (bitcast<i32>((_e624 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e729 = bitcast<f32>((_e721 & bitcast<u32>(_e726)));
                                            let _e730 = bitcast<u32>((f32(bitcast<i32>((_e631 & 1023u))) * _e694));
                                            let _e735 = (bitcast<i32>((_e631 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e738 = bitcast<f32>((_e730 & bitcast<u32>(_e735)));
                                            let _e739 = bitcast<u32>((f32(bitcast<i32>((_e638 & 1023u))) * _e696));
                                            let _e744 = (bitcast<i32>((_e638 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e747 = bitcast<f32>((_e739 & bitcast<u32>(_e744)));
                                            let _e751 = bitcast<f32>((_e721 & bitcast<u32>(~(_e726))));
                                            let _e755 = bitcast<f32>((_e730 & bitcast<u32>(~(_e735))));
                                            let _e759 = bitcast<f32>((_e739 & bitcast<u32>(~(_e744))));
                                            let _e760 = bitcast<u32>((f32(bitcast<i32>((_e647 & 1023u))) * _e692));
                                            let _e765 = (bitcast<i32>((_e647 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e768 = bitcast<f32>((_e760 & bitcast<u32>(_e765)));
                                            let _e769 = bitcast<u32>((f32(bitcast<i32>((_e656 & 1023u))) * _e694));
                                            let _e774 = (bitcast<i32>((_e656 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e777 = bitcast<f32>((_e769 & bitcast<u32>(_e774)));
                                            let _e778 = bitcast<u32>((f32(bitcast<i32>((_e665 & 1023u))) * _e696));
                                            let _e783 = (bitcast<i32>((_e665 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e786 = bitcast<f32>((_e778 & bitcast<u32>(_e783)));
                                            let _e790 = bitcast<f32>((_e760 & bitcast<u32>(~(_e765))));
                                            let _e794 = bitcast<f32>((_e769 & bitcast<u32>(~(_e774))));
                                            let _e798 = bitcast<f32>((_e778 & bitcast<u32>(~(_e783))));
                                            let _e828 = global_4.member[_e603.member_1][0u];
                                            let _e832 = global_4.member[_e603.member_1][1u];
                                            let _e836 = global_4.member[_e603.member_1][2u];
                                            let _e840 = global_4.member[_e603.member_1][3u];
                                            let _e852 = (((_e832 >> bitcast<u32>(22i)) | ((_e836 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e840 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e853 = (_e828 & 268435455u);
                                            let _e854 = (_e852 & 268435455u);
                                            let _e857 = ((_e828 >> bitcast<u32>(28u)) & 7u);
                                            let _e865 = ((_e828 >> bitcast<u32>(31i)) | (((_e852 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e866 = (_e857 != 0u);
                                            if (_e857 == 0u) {
                                                phi_3999_ = _e853;
                                            } else {
                                                if (_e857 == 7u) {
                                                    phi_3998_ = 2147483648u;
                                                } else {
                                                    phi_3998_ = ((2147483648u | (_e857 << bitcast<u32>(28u))) | (_e854 & 268435455u));
                                                }
                                                let _e875 = phi_3998_;
                                                phi_3999_ = _e875;
                                            }
                                            let _e877 = phi_3999_;
                                            if _e866 {
                                                let _e878 = (_e857 != 7u);
                                                if _e878 {
                                                    phi_4009_ = (_e854 + _e857);
                                                } else {
                                                    phi_4009_ = u32();
                                                }
                                                let _e881 = phi_4009_;
                                                phi_4011_ = _e881;
                                                phi_4012_ = select(true, false, _e878);
                                            } else {
                                                phi_4011_ = u32();
                                                phi_4012_ = true;
                                            }
                                            let _e884 = phi_4011_;
                                            let _e886 = phi_4012_;
                                            if (_e865 == 0u) {
                                                phi_4033_ = (_e853 + select(0u, 1u, !(_e866)));
                                            } else {
                                                if (_e865 == 7u) {
                                                    phi_4032_ = 2147483648u;
                                                } else {
                                                    phi_4032_ = ((2147483648u | (_e865 << bitcast<u32>(28u))) | (select(_e884, _e854, _e886) & 268435455u));
                                                }
                                                let _e899 = phi_4032_;
                                                phi_4033_ = _e899;
                                            }
                                            let _e901 = phi_4033_;
                                            phi_4037_ = type_63(array<vec4<f32>, 3>(vec4<f32>((_e603.member.member.x + _e729), (_e603.member.member.x + _e751), (_e603.member.member_1.x - _e768), (_e603.member.member_1.x - _e790)), vec4<f32>((_e603.member.member.y + _e738), (_e603.member.member.y + _e755), (_e603.member.member_1.y - _e777), (_e603.member.member_1.y - _e794)), vec4<f32>((_e603.member.member.z + _e747), (_e603.member.member.z + _e759), (_e603.member.member_1.z - _e786), (_e603.member.member_1.z - _e798))), type_60(type_41((_e603.member.member + vec4<f32>(_e729, _e738, _e747, 0f)), (_e603.member.member_1 - vec4<f32>(_e768, _e777, _e786, 0f))), _e877), type_60(type_41((_e603.member.member + vec4<f32>(_e751, _e755, _e759, 0f)), (_e603.member.member_1 - vec4<f32>(_e790, _e794, _e798, 0f))), _e901));
                                        }
                                        let _e906 = phi_4037_;
                                        let _e918 = ((_e906.member[0].x - _e407) * _e412);
                                        let _e919 = ((_e906.member[0].y - _e407) * _e412);
                                        let _e920 = ((_e906.member[0].z - _e408) * _e412);
                                        let _e921 = ((_e906.member[0].w - _e408) * _e412);
                                        let _e931 = ((_e906.member[1].x - _e443) * _e448);
                                        let _e932 = ((_e906.member[1].y - _e443) * _e448);
                                        let _e933 = ((_e906.member[1].z - _e444) * _e448);
                                        let _e934 = ((_e906.member[1].w - _e444) * _e448);
                                        let _e944 = ((_e906.member[2].x - _e479) * _e484);
                                        let _e945 = ((_e906.member[2].y - _e479) * _e484);
                                        let _e946 = ((_e906.member[2].z - _e480) * _e484);
                                        let _e947 = ((_e906.member[2].w - _e480) * _e484);
                                        let _e949 = select(_e946, _e944, (_e944 < _e946));
                                        let _e951 = select(_e947, _e945, (_e945 < _e947));
                                        let _e953 = select(_e946, _e944, (_e944 > _e946));
                                        let _e955 = select(_e947, _e945, (_e945 > _e947));
                                        let _e957 = select(_e920, _e918, (_e918 < _e920));
                                        let _e959 = select(_e921, _e919, (_e919 < _e921));
                                        let _e961 = select(_e933, _e931, (_e931 < _e933));
                                        let _e963 = select(_e934, _e932, (_e932 < _e934));
                                        let _e965 = select(_e961, _e957, (_e957 > _e961));
                                        let _e967 = select(_e963, _e959, (_e959 > _e963));
                                        let _e969 = select(_e949, _e965, (_e965 > _e949));
                                        let _e971 = select(_e951, _e967, (_e967 > _e951));
                                        let _e973 = select(_e920, _e918, (_e918 > _e920));
                                        let _e975 = select(_e921, _e919, (_e919 > _e921));
                                        let _e977 = select(_e933, _e931, (_e931 > _e933));
                                        let _e979 = select(_e934, _e932, (_e932 > _e934));
                                        let _e981 = select(_e977, _e973, (_e973 < _e977));
                                        let _e983 = select(_e979, _e975, (_e975 < _e979));
                                        let _e988 = -(_e949);
                                        let _e989 = -(_e951);
                                        let _e996 = (select(_e953, _e981, (_e981 < _e953)) + (select(_e988, _e953, (_e953 > _e988)) * 0.0000019073523f));
                                        let _e997 = (select(_e955, _e983, (_e983 < _e955)) + (select(_e989, _e955, (_e955 > _e989)) * 0.0000019073523f));
                                        let _e999 = select(_e530, _e969, (_e969 > _e530));
                                        let _e1001 = select(_e530, _e971, (_e971 > _e530));
                                        let _e1006 = (_e999 <= select(_e574.member_1, _e996, (_e996 < _e574.member_1)));
                                        let _e1007 = (_e1001 <= select(_e574.member_1, _e997, (_e997 < _e574.member_1)));
                                        let _e1008 = (_e999 <= _e1001);
                                        if _e1006 {
                                            if _e1007 {
                                                if _e1008 {
                                                    phi_4381_ = _e906.member_2;
                                                } else {
                                                    phi_4381_ = _e906.member_1;
                                                }
                                                let _e1012 = phi_4381_;
                                                let _e1013 = (_e607 % 128u);
                                                let _e1014 = (_e1013 < 128u);
                                                if _e1014 {
                                                } else {
                                                    phi_4900_ = true;
                                                    break;
                                                }
                                                local_3[_e1013] = type_60(type_41(_e1012.member.member, _e1012.member.member_1), _e1012.member_1);
                                                if _e1014 {
                                                } else {
                                                    phi_4900_ = true;
                                                    break;
                                                }
                                                local_2[_e1013] = select(_e1001, _e999, (_e999 > _e1001));
                                                if _e1008 {
                                                    phi_4414_ = _e906.member_1;
                                                } else {
                                                    phi_4414_ = _e906.member_2;
                                                }
                                                let _e1029 = phi_4414_;
                                                phi_4415_ = _e1029;
                                                phi_4416_ = (_e607 + 1u);
                                            } else {
                                                phi_4415_ = type_60();
                                                phi_4416_ = u32();
                                            }
                                            let _e1031 = phi_4415_;
                                            let _e1033 = phi_4416_;
                                            phi_4418_ = _e1031;
                                            phi_4419_ = _e1033;
                                            phi_4420_ = select(true, false, _e1007);
                                        } else {
                                            phi_4418_ = type_60();
                                            phi_4419_ = u32();
                                            phi_4420_ = true;
                                        }
                                        let _e1036 = phi_4418_;
                                        let _e1038 = phi_4419_;
                                        let _e1040 = phi_4420_;
                                        if _e1040 {
                                            if _e1006 {
                                                phi_4429_ = _e906.member_1;
                                            } else {
                                                phi_4429_ = _e906.member_2;
                                            }
                                            let _e1044 = phi_4429_;
                                            phi_4434_ = _e1044;
                                            phi_4435_ = select(_e1007, true, _e1006);
                                        } else {
                                            phi_4434_ = _e1036;
                                            phi_4435_ = _e605;
                                        }
                                        let _e1047 = phi_4434_;
                                        let _e1049 = phi_4435_;
                                        phi_4904_ = _e572;
                                        phi_4437_ = _e574;
                                        phi_4438_ = _e1047;
                                        phi_4439_ = _e1049;
                                        phi_4440_ = select(_e1038, _e607, _e1040);
                                    }
                                    let _e1685 = phi_4904_;
                                    let _e1687 = phi_4437_;
                                    let _e1689 = phi_4438_;
                                    let _e1691 = phi_4439_;
                                    let _e1693 = phi_4440_;
                                    phi_4903_ = _e1685;
                                    phi_4441_ = _e1687;
                                    phi_4442_ = _e1689;
                                    phi_4443_ = (_e578 - 1u);
                                    phi_4444_ = _e1691;
                                    phi_4445_ = _e1693;
                                } else {
                                    phi_4903_ = _e572;
                                    phi_4441_ = _e574;
                                    phi_4442_ = _e603;
                                    phi_4443_ = _e578;
                                    phi_4444_ = _e605;
                                    phi_4445_ = _e607;
                                }
                                let _e1695 = phi_4903_;
                                let _e1697 = phi_4441_;
                                let _e1699 = phi_4442_;
                                let _e1701 = phi_4443_;
                                let _e1703 = phi_4444_;
                                let _e1705 = phi_4445_;
                                phi_4902_ = _e1695;
                                phi_4446_ = _e1697;
                                phi_4447_ = _e1699;
                                phi_4448_ = _e1701;
                                phi_4449_ = _e1703;
                                phi_4450_ = _e1705;
                            } else {
                                phi_4902_ = _e572;
                                phi_4446_ = type_45();
                                phi_4447_ = type_60();
                                phi_4448_ = u32();
                                phi_4449_ = bool();
                                phi_4450_ = u32();
                            }
                            let _e1707 = phi_4902_;
                            let _e1709 = phi_4446_;
                            let _e1711 = phi_4447_;
                            let _e1713 = phi_4448_;
                            let _e1715 = phi_4449_;
                            let _e1717 = phi_4450_;
                            phi_4901_ = _e1707;
                            phi_1989_ = _e1709;
                            phi_1992_ = _e1711;
                            phi_1994_ = _e1713;
                            phi_1996_ = _e1715;
                            phi_1998_ = _e1717;
                            phi_4451_ = _e586;
                        } else {
                            phi_4901_ = _e572;
                            phi_1989_ = type_45();
                            phi_1992_ = type_60();
                            phi_1994_ = u32();
                            phi_1996_ = bool();
                            phi_1998_ = u32();
                            phi_4451_ = false;
                        }
                        let _e1719 = phi_4901_;
                        let _e1721 = phi_1989_;
                        let _e1723 = phi_1992_;
                        let _e1725 = phi_1994_;
                        let _e1727 = phi_1996_;
                        let _e1729 = phi_1998_;
                        let _e1731 = phi_4451_;
                        continue;
                        continuing {
                            phi_4768_ = _e1719;
                            phi_1988_ = _e1721;
                            phi_1991_ = _e1723;
                            phi_1993_ = _e1725;
                            phi_1995_ = _e1727;
                            phi_1997_ = _e1729;
                            phi_4900_ = _e1719;
                            break if !(_e1731);
                        }
                    }
                    let _e1734 = phi_4900_;
                    if _e1734 {
                        break;
                    }
                    let _e1736 = local_4;
                    if (_e1736.member.member_3 != 4294967295u) {
                        let _e1741 = (_e354 / 3i);
                        let _e1748 = bitcast<f32>((bitcast<u32>((_e1741 + 127i)) << bitcast<u32>(23i)));
                        let _e1756 = (((_e1736.member.member * _e1748) * _e1748) * bitcast<f32>((bitcast<u32>(((_e354 - (2i * _e1741)) + 127i)) << bitcast<u32>(23i))));
                        let _e1758 = select(340282350000000000000000000000000000000f, _e1756, (_e1756 < 340282350000000000000000000000000000000f));
                        phi_4503_ = type_29(select(-340282350000000000000000000000000000000f, _e1758, (_e1758 > -340282350000000000000000000000000000000f)), _e1736.member.member_1, _e1736.member.member_2, _e1736.member.member_3);
                    } else {
                        phi_4503_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1765 = phi_4503_;
                    if _e231 {
                    } else {
                        break;
                    }
                    global_9.member[_e137] = _e1765;
                    if _e152 {
                    } else {
                        break;
                    }
                    let _e1769 = select(0u, 1u, (_e298 <= _e308));
                    if (_e1769 > 0u) {
                        let _e1771 = (1u < _e105);
                        if _e1771 {
                            if (0u < _e105) {
                            } else {
                                break;
                            }
                            let _e1775 = atomicAdd((&global_10.member[0u]), _e1769);
                            if ((_e1775 + _e1769) < _e1775) {
                                if _e1771 {
                                } else {
                                    break;
                                }
                                let _e1780 = atomicAdd((&global_10.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1783 = select(0u, 1u, (_e1765.member_3 != 4294967295u));
                    if (_e1783 > 0u) {
                        let _e1785 = (3u < _e105);
                        if _e1785 {
                            if (2u < _e105) {
                            } else {
                                break;
                            }
                            let _e1789 = atomicAdd((&global_10.member[2u]), _e1783);
                            if ((_e1789 + _e1783) < _e1789) {
                                if _e1785 {
                                } else {
                                    break;
                                }
                                let _e1794 = atomicAdd((&global_10.member[3u]), 1u);
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
fn trace_paths_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
