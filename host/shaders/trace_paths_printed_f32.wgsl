struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_34 {
    member: array<type_32>,
}

struct type_40 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_43 {
    member: type_27,
    member_1: f32,
}

struct type_47 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: array<i32>,
}

struct type_54 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_56 {
    member: array<type_54>,
}

struct type_59 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_61 {
    member: type_59,
    member_1: u32,
}

struct type_66 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_47;
@group(0) @binding(2) 
var<uniform> global_3: type_47;
@group(0) @binding(4) 
var<storage> global_4: type_20;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_50;
@group(0) @binding(7) 
var<storage> global_7: type_34;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_29;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_66;
@group(0) @binding(3) 
var<storage> global_10: type_56;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_273_: u32;
    var phi_317_: i32;
    var phi_341_: type_40;
    var phi_447_: i32;
    var phi_448_: i32;
    var phi_458_: bool;
    var phi_468_: u32;
    var phi_469_: u32;
    var phi_471_: bool;
    var phi_476_: u32;
    var phi_508_: i32;
    var phi_526_: f32;
    var phi_532_: f32;
    var phi_543_: f32;
    var phi_549_: f32;
    var phi_572_: f32;
    var phi_583_: f32;
    var phi_592_: f32;
    var phi_598_: f32;
    var phi_609_: f32;
    var phi_615_: f32;
    var phi_638_: f32;
    var phi_649_: f32;
    var phi_658_: f32;
    var phi_664_: f32;
    var phi_675_: f32;
    var phi_681_: f32;
    var phi_704_: f32;
    var phi_715_: f32;
    var phi_815_: f32;
    var phi_816_: f32;
    var phi_3490_: bool;
    var phi_889_: type_43;
    var phi_892_: type_61;
    var phi_894_: u32;
    var phi_896_: bool;
    var phi_898_: u32;
    var phi_909_: bool;
    var phi_995_: type_61;
    var phi_996_: bool;
    var phi_997_: u32;
    var phi_2367_: type_54;
    var phi_3199_: type_61;
    var phi_3276_: type_61;
    var phi_3277_: type_61;
    var phi_3278_: u32;
    var phi_3280_: type_61;
    var phi_3281_: u32;
    var phi_3282_: bool;
    var phi_3289_: type_61;
    var phi_3294_: type_61;
    var phi_3295_: bool;
    var phi_1015_: type_43;
    var phi_1018_: type_8;
    var phi_1019_: type_8;
    var phi_1041_: type_8;
    var phi_1062_: u32;
    var phi_1151_: array<array<f32, 3>, 3>;
    var phi_1268_: bool;
    var phi_1297_: bool;
    var phi_1698_: f32;
    var phi_1699_: f32;
    var phi_1700_: f32;
    var phi_1701_: f32;
    var phi_1702_: vec3<f32>;
    var phi_1703_: vec3<f32>;
    var phi_1704_: vec3<f32>;
    var phi_1705_: vec3<f32>;
    var phi_1736_: bool;
    var phi_1745_: vec3<f32>;
    var phi_1910_: f32;
    var phi_1912_: f32;
    var phi_1913_: bool;
    var phi_1933_: f32;
    var phi_1934_: f32;
    var phi_1957_: type_27;
    var phi_1959_: type_27;
    var phi_1960_: bool;
    var phi_1964_: type_27;
    var phi_1965_: type_27;
    var phi_1966_: type_27;
    var phi_1967_: bool;
    var phi_1971_: type_27;
    var phi_1972_: bool;
    var phi_1973_: type_27;
    var phi_1974_: bool;
    var phi_1975_: bool;
    var phi_1976_: type_27;
    var phi_1977_: bool;
    var phi_1978_: bool;
    var phi_1986_: type_27;
    var phi_1987_: bool;
    var phi_1991_: type_27;
    var phi_2014_: u32;
    var phi_2028_: i32;
    var phi_2048_: vec3<f32>;
    var phi_2049_: vec3<f32>;
    var phi_2065_: vec3<f32>;
    var phi_2066_: vec3<f32>;
    var phi_2082_: vec3<f32>;
    var phi_2083_: vec3<f32>;
    var phi_2119_: vec3<f32>;
    var phi_2301_: f32;
    var phi_2319_: bool;
    var phi_2320_: bool;
    var phi_2339_: bool;
    var phi_2340_: bool;
    var phi_2346_: type_43;
    var phi_2347_: type_43;
    var phi_2348_: type_43;
    var phi_1016_: type_43;
    var phi_3484_: bool;
    var phi_3654_: bool;
    var phi_3297_: type_43;
    var phi_3298_: type_61;
    var phi_3299_: bool;
    var phi_3300_: u32;
    var phi_3653_: bool;
    var phi_3301_: type_43;
    var phi_3302_: type_61;
    var phi_3303_: u32;
    var phi_3304_: bool;
    var phi_3305_: u32;
    var phi_3652_: bool;
    var phi_3306_: type_43;
    var phi_3307_: type_61;
    var phi_3308_: u32;
    var phi_3309_: bool;
    var phi_3310_: u32;
    var phi_3651_: bool;
    var phi_890_: type_43;
    var phi_893_: type_61;
    var phi_895_: u32;
    var phi_897_: bool;
    var phi_899_: u32;
    var phi_3311_: bool;
    var phi_3650_: bool;
    var local_10: type_43;
    var phi_3363_: type_27;
    var local_11: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e88 = global;
            let _e91 = arrayLength((&global_10.member));
            let _e93 = arrayLength((&global_4.member));
            let _e105 = arrayLength((&global_9.member));
            let _e109 = global_3.member[0u][0u];
            let _e113 = global_3.member[0u][1u];
            let _e117 = global_3.member[0u][2u];
            let _e121 = global_3.member[1u][0u];
            let _e125 = global_3.member[1u][1u];
            let _e129 = global_3.member[1u][2u];
            let _e133 = global_3.member[1u][3u];
            let _e137 = (_e88.x + (_e88.y * 2097152u));
            let _e144 = (_e137 < arrayLength((&global_7.member)));
            if _e144 {
                if _e144 {
                } else {
                    break;
                }
                let _e148 = global_7.member[_e137].member_2;
                phi_273_ = _e148;
            } else {
                phi_273_ = 4294967295u;
            }
            let _e150 = phi_273_;
            let _e153 = global_1.member[0u];
            let _e157 = global_2.member[0u][0u];
            let _e161 = global_2.member[0u][1u];
            let _e165 = global_2.member[0u][2u];
            let _e169 = global_2.member[0u][3u];
            let _e173 = global_2.member[1u][0u];
            let _e177 = global_2.member[1u][1u];
            let _e181 = global_2.member[1u][2u];
            let _e185 = global_2.member[1u][3u];
            let _e186 = bitcast<f32>(_e157);
            let _e187 = bitcast<f32>(_e161);
            let _e188 = bitcast<f32>(_e165);
            let _e190 = bitcast<f32>(_e173);
            let _e191 = array<u32, 3>(_e177, _e181, _e185);
            let _e193 = bitcast<i32>(_e153);
            if (_e193 < -126i) {
                phi_317_ = -126i;
            } else {
                phi_317_ = select(_e193, 127i, (_e193 > 127i));
            }
            let _e198 = phi_317_;
            let _e203 = bitcast<f32>((bitcast<u32>((_e198 + 127i)) << bitcast<u32>(23i)));
            let _e209 = bitcast<f32>((bitcast<u32>(((_e193 - _e198) + 127i)) << bitcast<u32>(23i)));
            if (_e169 == 0u) {
                phi_341_ = type_40(array<f32, 3>(_e186, _e187, _e188), _e169, _e190, _e191);
            } else {
                phi_341_ = type_40(array<f32, 3>(((_e186 * _e203) * _e209), ((_e187 * _e203) * _e209), ((_e188 * _e203) * _e209)), _e169, ((_e190 * _e203) * _e209), _e191);
            }
            let _e222 = phi_341_;
            if _e144 {
                let _e223 = (_e137 < arrayLength((&global_8.member)));
                if _e223 {
                    if _e144 {
                    } else {
                        break;
                    }
                    let _e233 = global_7.member[_e137].member.member_2[0u];
                    let _e235 = (bitcast<u32>(_e233) & 2147483647u);
                    let _e241 = global_7.member[_e137].member.member_2[1u];
                    let _e243 = (bitcast<u32>(_e241) & 2147483647u);
                    let _e249 = global_7.member[_e137].member.member_2[2u];
                    let _e251 = (bitcast<u32>(_e249) & 2147483647u);
                    let _e257 = global_7.member[_e137].member.member[0u];
                    let _e259 = (bitcast<u32>(_e257) & 2147483647u);
                    let _e265 = global_7.member[_e137].member.member[1u];
                    let _e267 = (bitcast<u32>(_e265) & 2147483647u);
                    let _e273 = global_7.member[_e137].member.member[2u];
                    let _e275 = (bitcast<u32>(_e273) & 2147483647u);
                    let _e277 = select(_e243, _e235, (_e243 < _e235));
                    let _e279 = select(_e251, _e277, (_e251 < _e277));
                    let _e281 = select(_e259, _e279, (_e259 < _e279));
                    let _e283 = select(_e267, _e281, (_e267 < _e281));
                    let _e285 = select(_e275, _e283, (_e275 < _e283));
                    let _e290 = global_7.member[_e137].member.member_1;
                    let _e292 = (bitcast<u32>(_e290) & 2147483647u);
                    let _e300 = global_7.member[_e137].member.member_3;
                    let _e306 = (((select(_e292, _e285, (_e292 < _e285)) < 2139095040u) && ((bitcast<u32>(_e300) & 2147483647u) <= 2139095040u)) && (_e279 > 0u));
                    if _e306 {
                        let _e309 = (bitcast<u32>(bitcast<f32>(_e279)) & 2147483647u);
                        if (_e309 >= 8388608u) {
                            phi_447_ = (bitcast<i32>((_e309 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_447_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e309)), 32u, (_e309 == 0u))));
                        }
                        let _e323 = phi_447_;
                        phi_448_ = _e323;
                    } else {
                        phi_448_ = 0i;
                    }
                    let _e325 = phi_448_;
                    let _e326 = (_e235 == _e279);
                    if _e326 {
                        phi_458_ = true;
                    } else {
                        phi_458_ = (_e243 == _e279);
                    }
                    let _e329 = phi_458_;
                    let _e330 = select(1u, 0u, _e326);
                    if _e329 {
                        let _e331 = (_e330 + 1u);
                        phi_468_ = _e331;
                        phi_469_ = _e331;
                        phi_471_ = select(true, false, (_e331 == 2u));
                    } else {
                        phi_468_ = u32();
                        phi_469_ = 0u;
                        phi_471_ = true;
                    }
                    let _e335 = phi_468_;
                    let _e337 = phi_469_;
                    let _e339 = phi_471_;
                    if _e339 {
                        phi_476_ = (_e337 + 1u);
                    } else {
                        phi_476_ = 0u;
                    }
                    let _e343 = phi_476_;
                    let _e344 = select(_e335, _e337, _e339);
                    let _e345 = select(_e330, select(2u, _e330, _e329), _e339);
                    let _e346 = -(_e325);
                    if (_e346 < -126i) {
                        phi_508_ = -126i;
                    } else {
                        phi_508_ = select(_e346, 127i, (_e346 > 127i));
                    }
                    let _e351 = phi_508_;
                    let _e356 = bitcast<f32>((bitcast<u32>((_e351 + 127i)) << bitcast<u32>(23i)));
                    let _e362 = bitcast<f32>((bitcast<u32>(((_e346 - _e351) + 127i)) << bitcast<u32>(23i)));
                    let _e367 = global_7.member[_e137].member.member;
                    let _e368 = (_e344 == 0u);
                    if _e368 {
                        phi_526_ = _e367[0];
                    } else {
                        phi_526_ = _e367[1];
                    }
                    let _e372 = phi_526_;
                    let _e373 = (_e344 == 2u);
                    if _e373 {
                        phi_532_ = _e367[2];
                    } else {
                        phi_532_ = _e372;
                    }
                    let _e376 = phi_532_;
                    let _e377 = global_7.member[_e137].member.member_2;
                    if _e368 {
                        phi_543_ = _e377[0];
                    } else {
                        phi_543_ = _e377[1];
                    }
                    let _e381 = phi_543_;
                    if _e373 {
                        phi_549_ = _e377[2];
                    } else {
                        phi_549_ = _e381;
                    }
                    let _e384 = phi_549_;
                    let _e386 = ((_e384 * _e356) * _e362);
                    let _e390 = (bitcast<f32>((bitcast<u32>(_e386) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e390 {
                        let _e394 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) * 0.00000011920929f);
                        phi_572_ = select(0.00000000000011368684f, _e394, (_e394 > 0.00000000000011368684f));
                    } else {
                        phi_572_ = 0f;
                    }
                    let _e398 = phi_572_;
                    let _e399 = (_e376 + _e398);
                    let _e400 = (_e376 - _e398);
                    let _e401 = select(_e386, 0f, _e390);
                    if _e390 {
                        phi_583_ = 38685626000000000000000000f;
                    } else {
                        phi_583_ = (1f / _e386);
                    }
                    let _e404 = phi_583_;
                    let _e405 = (_e343 == 0u);
                    if _e405 {
                        phi_592_ = _e367[0];
                    } else {
                        phi_592_ = _e367[1];
                    }
                    let _e409 = phi_592_;
                    let _e410 = (_e343 == 2u);
                    if _e410 {
                        phi_598_ = _e367[2];
                    } else {
                        phi_598_ = _e409;
                    }
                    let _e413 = phi_598_;
                    if _e405 {
                        phi_609_ = _e377[0];
                    } else {
                        phi_609_ = _e377[1];
                    }
                    let _e417 = phi_609_;
                    if _e410 {
                        phi_615_ = _e377[2];
                    } else {
                        phi_615_ = _e417;
                    }
                    let _e420 = phi_615_;
                    let _e422 = ((_e420 * _e356) * _e362);
                    let _e426 = (bitcast<f32>((bitcast<u32>(_e422) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e426 {
                        let _e430 = (bitcast<f32>((bitcast<u32>(_e413) & 2147483647u)) * 0.00000011920929f);
                        phi_638_ = select(0.00000000000011368684f, _e430, (_e430 > 0.00000000000011368684f));
                    } else {
                        phi_638_ = 0f;
                    }
                    let _e434 = phi_638_;
                    let _e435 = (_e413 + _e434);
                    let _e436 = (_e413 - _e434);
                    let _e437 = select(_e422, 0f, _e426);
                    if _e426 {
                        phi_649_ = 38685626000000000000000000f;
                    } else {
                        phi_649_ = (1f / _e422);
                    }
                    let _e440 = phi_649_;
                    let _e441 = (_e345 == 0u);
                    if _e441 {
                        phi_658_ = _e367[0];
                    } else {
                        phi_658_ = _e367[1];
                    }
                    let _e445 = phi_658_;
                    let _e446 = (_e345 == 2u);
                    if _e446 {
                        phi_664_ = _e367[2];
                    } else {
                        phi_664_ = _e445;
                    }
                    let _e449 = phi_664_;
                    if _e441 {
                        phi_675_ = _e377[0];
                    } else {
                        phi_675_ = _e377[1];
                    }
                    let _e453 = phi_675_;
                    if _e446 {
                        phi_681_ = _e377[2];
                    } else {
                        phi_681_ = _e453;
                    }
                    let _e456 = phi_681_;
                    let _e458 = ((_e456 * _e356) * _e362);
                    let _e462 = (bitcast<f32>((bitcast<u32>(_e458) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e462 {
                        let _e466 = (bitcast<f32>((bitcast<u32>(_e449) & 2147483647u)) * 0.00000011920929f);
                        phi_704_ = select(0.00000000000011368684f, _e466, (_e466 > 0.00000000000011368684f));
                    } else {
                        phi_704_ = 0f;
                    }
                    let _e470 = phi_704_;
                    let _e471 = (_e449 + _e470);
                    let _e472 = (_e449 - _e470);
                    let _e473 = select(_e458, 0f, _e462);
                    if _e462 {
                        phi_715_ = 38685626000000000000000000f;
                    } else {
                        phi_715_ = (1f / _e458);
                    }
                    let _e476 = phi_715_;
                    let _e479 = bitcast<f32>((bitcast<u32>(_e376) & 2147483647u));
                    let _e482 = bitcast<f32>((bitcast<u32>(_e413) & 2147483647u));
                    let _e484 = select(_e482, _e479, (_e479 > _e482));
                    let _e487 = bitcast<f32>((bitcast<u32>(_e449) & 2147483647u));
                    if (_e306 && (select(_e487, _e484, (_e484 > _e487)) <= 1099511600000f)) {
                        let _e492 = (_e325 / 3i);
                        let _e499 = bitcast<f32>((bitcast<u32>((_e492 + 127i)) << bitcast<u32>(23i)));
                        let _e506 = bitcast<f32>((bitcast<u32>(((_e325 - (2i * _e492)) + 127i)) << bitcast<u32>(23i)));
                        let _e507 = (((_e290 * _e499) * _e499) * _e506);
                        let _e509 = select(340282350000000000000000000000000000000f, _e507, (_e507 < 340282350000000000000000000000000000000f));
                        let _e514 = (((_e300 * _e499) * _e499) * _e506);
                        let _e516 = select(340282350000000000000000000000000000000f, _e514, (_e514 < 340282350000000000000000000000000000000f));
                        phi_815_ = select(-340282350000000000000000000000000000000f, _e516, (_e516 > -340282350000000000000000000000000000000f));
                        phi_816_ = select(-340282350000000000000000000000000000000f, _e509, (_e509 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_815_ = 0f;
                        phi_816_ = 1f;
                    }
                    let _e520 = phi_815_;
                    let _e522 = phi_816_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e109), bitcast<f32>(_e113), bitcast<f32>(_e117));
                    let _e527 = (_e344 % 3u);
                    let _e528 = (_e527 < 3u);
                    if _e528 {
                    } else {
                        break;
                    }
                    let _e530 = local_9[_e527];
                    let _e531 = (_e343 % 3u);
                    let _e532 = (_e531 < 3u);
                    if _e532 {
                    } else {
                        break;
                    }
                    let _e534 = local_9[_e531];
                    let _e535 = (_e345 % 3u);
                    let _e536 = (_e535 < 3u);
                    if _e536 {
                    } else {
                        break;
                    }
                    let _e538 = local_9[_e535];
                    local_8 = array<f32, 3>(bitcast<f32>(_e121), bitcast<f32>(_e125), bitcast<f32>(_e129));
                    if _e528 {
                    } else {
                        break;
                    }
                    let _e542 = local_8[_e527];
                    if _e532 {
                    } else {
                        break;
                    }
                    let _e544 = local_8[_e531];
                    if _e536 {
                    } else {
                        break;
                    }
                    let _e546 = local_8[_e535];
                    phi_3490_ = false;
                    phi_889_ = type_43(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e520);
                    phi_892_ = type_61(type_59(array<f32, 3>(_e530, _e534, _e538), array<f32, 3>(_e542, _e544, _e546)), select(0u, 2147483648u, (_e91 == 0u)));
                    phi_894_ = ((3u * _e91) + 1u);
                    phi_896_ = (_e522 <= _e520);
                    phi_898_ = 0u;
                    loop {
                        let _e554 = phi_3490_;
                        let _e556 = phi_889_;
                        let _e558 = phi_892_;
                        let _e560 = phi_894_;
                        let _e562 = phi_896_;
                        let _e564 = phi_898_;
                        local_10 = _e556;
                        if _e562 {
                            phi_909_ = true;
                        } else {
                            phi_909_ = (_e564 > 0u);
                        }
                        let _e567 = phi_909_;
                        if _e567 {
                            let _e568 = (_e560 > 0u);
                            if _e568 {
                                if _e562 {
                                    phi_995_ = _e558;
                                    phi_996_ = _e562;
                                    phi_997_ = _e564;
                                } else {
                                    let _e569 = (_e564 - 1u);
                                    let _e570 = (_e569 % 128u);
                                    let _e571 = (_e570 < 128u);
                                    if _e571 {
                                    } else {
                                        phi_3650_ = true;
                                        break;
                                    }
                                    let _e573 = local_6[_e570];
                                    if _e571 {
                                    } else {
                                        phi_3650_ = true;
                                        break;
                                    }
                                    let _e575 = local_5[_e570];
                                    if _e571 {
                                    } else {
                                        phi_3650_ = true;
                                        break;
                                    }
                                    let _e577 = local_4[_e570];
                                    if _e571 {
                                    } else {
                                        phi_3650_ = true;
                                        break;
                                    }
                                    let _e579 = local_3[_e570];
                                    if _e571 {
                                    } else {
                                        phi_3650_ = true;
                                        break;
                                    }
                                    let _e582 = local_2[_e570];
                                    if _e571 {
                                    } else {
                                        phi_3650_ = true;
                                        break;
                                    }
                                    let _e584 = local_1[_e570];
                                    if _e571 {
                                    } else {
                                        phi_3650_ = true;
                                        break;
                                    }
                                    let _e586 = local[_e570];
                                    if _e571 {
                                    } else {
                                        phi_3650_ = true;
                                        break;
                                    }
                                    let _e591 = local_7[_e570];
                                    phi_995_ = type_61(type_59(array<f32, 3>(_e575, _e577, _e579), array<f32, 3>(_e582, _e584, _e586)), _e573);
                                    phi_996_ = (_e591 <= _e556.member_1);
                                    phi_997_ = _e569;
                                }
                                let _e595 = phi_995_;
                                let _e597 = phi_996_;
                                let _e599 = phi_997_;
                                if _e597 {
                                    if ((_e595.member_1 & 2147483648u) != 0u) {
                                        phi_1015_ = _e556;
                                        phi_1018_ = type_8(0u, ((_e595.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e951 = phi_1015_;
                                            let _e953 = phi_1018_;
                                            local_11 = _e951;
                                            if (_e953.member < _e953.member_1) {
                                                phi_1019_ = type_8((_e953.member + 1u), _e953.member_1);
                                                phi_1041_ = type_8(1u, _e953.member);
                                            } else {
                                                phi_1019_ = _e953;
                                                phi_1041_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e966 = phi_1019_;
                                            let _e968 = phi_1041_;
                                            let _e972 = (bitcast<i32>(_e968.member) != 0i);
                                            if _e972 {
                                                let _e973 = ((_e595.member_1 & 268435455u) + _e968.member_1);
                                                let _e974 = (_e973 < _e93);
                                                if _e974 {
                                                    if _e974 {
                                                    } else {
                                                        phi_3484_ = true;
                                                        break;
                                                    }
                                                    let _e978 = global_4.member[_e973].member_1;
                                                    phi_1062_ = _e978;
                                                } else {
                                                    phi_1062_ = 4294967295u;
                                                }
                                                let _e980 = phi_1062_;
                                                if (_e973 >= _e93) {
                                                    phi_1151_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e974 {
                                                    } else {
                                                        phi_3484_ = true;
                                                        break;
                                                    }
                                                    if (_e527 < 9u) {
                                                    } else {
                                                        phi_3484_ = true;
                                                        break;
                                                    }
                                                    let _e987 = global_4.member[_e973].member[_e527];
                                                    if (_e531 < 9u) {
                                                    } else {
                                                        phi_3484_ = true;
                                                        break;
                                                    }
                                                    let _e993 = global_4.member[_e973].member[_e531];
                                                    if (_e535 < 9u) {
                                                    } else {
                                                        phi_3484_ = true;
                                                        break;
                                                    }
                                                    let _e999 = global_4.member[_e973].member[_e535];
                                                    let _e1001 = (3u + _e527);
                                                    if (_e1001 < 9u) {
                                                    } else {
                                                        phi_3484_ = true;
                                                        break;
                                                    }
                                                    let _e1007 = global_4.member[_e973].member[_e1001];
                                                    let _e1008 = (3u + _e531);
                                                    if (_e1008 < 9u) {
                                                    } else {
                                                        phi_3484_ = true;
                                                        break;
                                                    }
                                                    let _e1014 = global_4.member[_e973].member[_e1008];
                                                    let _e1015 = (3u + _e535);
                                                    if (_e1015 < 9u) {
                                                    } else {
                                                        phi_3484_ = true;
                                                        break;
                                                    }
                                                    let _e1021 = global_4.member[_e973].member[_e1015];
                                                    let _e1023 = (6u + _e527);
                                                    if (_e1023 < 9u) {
                                                    } else {
                                                        phi_3484_ = true;
                                                        break;
                                                    }
                                                    let _e1029 = global_4.member[_e973].member[_e1023];
                                                    let _e1030 = (6u + _e531);
                                                    if (_e1030 < 9u) {
                                                    } else {
                                                        phi_3484_ = true;
                                                        break;
                                                    }
                                                    let _e1036 = global_4.member[_e973].member[_e1030];
                                                    let _e1037 = (6u + _e535);
                                                    if (_e1037 < 9u) {
                                                    } else {
                                                        phi_3484_ = true;
                                                        break;
                                                    }
                                                    let _e1043 = global_4.member[_e973].member[_e1037];
                                                    phi_1151_ = array<array<f32, 3>, 3>(array<f32, 3>(_e987, _e993, _e999), array<f32, 3>(_e1007, _e1014, _e1021), array<f32, 3>(_e1029, _e1036, _e1043));
                                                }
                                                let _e1047 = phi_1151_;
                                                let _e1055 = (_e1047[0][2] - _e449);
                                                let _e1058 = (((_e1047[0][0] - _e376) * _e473) - (_e1055 * _e401));
                                                let _e1061 = (((_e1047[0][1] - _e413) * _e473) - (_e1055 * _e437));
                                                let _e1068 = (_e1047[1][2] - _e449);
                                                let _e1071 = (((_e1047[1][0] - _e376) * _e473) - (_e1068 * _e401));
                                                let _e1074 = (((_e1047[1][1] - _e413) * _e473) - (_e1068 * _e437));
                                                let _e1081 = (_e1047[2][2] - _e449);
                                                let _e1084 = (((_e1047[2][0] - _e376) * _e473) - (_e1081 * _e401));
                                                let _e1087 = (((_e1047[2][1] - _e413) * _e473) - (_e1081 * _e437));
                                                let _e1088 = (_e1084 * _e1074);
                                                let _e1089 = (_e1087 * _e1071);
                                                let _e1090 = (_e1058 * _e1087);
                                                let _e1091 = (_e1061 * _e1084);
                                                let _e1092 = (_e1071 * _e1061);
                                                let _e1093 = (_e1074 * _e1058);
                                                let _e1098 = (((_e1088 >= _e1089) && (_e1090 >= _e1091)) && (_e1092 >= _e1093));
                                                if (_e1098 || (((_e1088 <= _e1089) && (_e1090 <= _e1091)) && (_e1092 <= _e1093))) {
                                                    let _e1105 = select(-1f, 1f, _e1098);
                                                    let _e1107 = ((_e1088 - _e1089) * _e1105);
                                                    let _e1109 = select(0f, _e1107, (_e1107 > 0f));
                                                    let _e1111 = ((_e1090 - _e1091) * _e1105);
                                                    let _e1113 = select(0f, _e1111, (_e1111 > 0f));
                                                    let _e1115 = ((_e1092 - _e1093) * _e1105);
                                                    let _e1117 = select(0f, _e1115, (_e1115 > 0f));
                                                    let _e1119 = ((_e1109 + _e1113) + _e1117);
                                                    if (_e1119 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1976_ = type_27();
                                                        phi_1977_ = true;
                                                        phi_1978_ = false;
                                                    } else {
                                                        let _e1122 = select(_e1071, _e1058, (_e1058 < _e1071));
                                                        if (select(_e1084, _e1122, (_e1122 < _e1084)) > 0f) {
                                                            phi_1268_ = true;
                                                        } else {
                                                            let _e1127 = select(_e1071, _e1058, (_e1058 > _e1071));
                                                            phi_1268_ = (select(_e1084, _e1127, (_e1127 > _e1084)) < 0f);
                                                        }
                                                        let _e1132 = phi_1268_;
                                                        if _e1132 {
                                                            phi_1973_ = type_27();
                                                            phi_1974_ = true;
                                                            phi_1975_ = false;
                                                        } else {
                                                            let _e1134 = select(_e1074, _e1061, (_e1061 < _e1074));
                                                            if (select(_e1087, _e1134, (_e1134 < _e1087)) > 0f) {
                                                                phi_1297_ = true;
                                                            } else {
                                                                let _e1139 = select(_e1074, _e1061, (_e1061 > _e1074));
                                                                phi_1297_ = (select(_e1087, _e1139, (_e1139 > _e1087)) < 0f);
                                                            }
                                                            let _e1144 = phi_1297_;
                                                            if _e1144 {
                                                                phi_1971_ = type_27();
                                                                phi_1972_ = false;
                                                            } else {
                                                                let _e1146 = select(_e1047[1][0], _e1047[0][0], (_e1047[0][0] < _e1047[1][0]));
                                                                let _e1150 = select(_e1047[1][0], _e1047[0][0], (_e1047[0][0] > _e1047[1][0]));
                                                                let _e1154 = select(_e1047[1][1], _e1047[0][1], (_e1047[0][1] < _e1047[1][1]));
                                                                let _e1158 = select(_e1047[1][1], _e1047[0][1], (_e1047[0][1] > _e1047[1][1]));
                                                                let _e1162 = select(_e1047[1][2], _e1047[0][2], (_e1047[0][2] < _e1047[1][2]));
                                                                let _e1166 = select(_e1047[1][2], _e1047[0][2], (_e1047[0][2] > _e1047[1][2]));
                                                                let _e1171 = ((select(_e1047[2][0], _e1146, (_e1146 < _e1047[2][0])) - _e399) * _e404);
                                                                let _e1172 = ((select(_e1047[2][0], _e1150, (_e1150 > _e1047[2][0])) - _e400) * _e404);
                                                                let _e1175 = ((select(_e1047[2][1], _e1154, (_e1154 < _e1047[2][1])) - _e435) * _e440);
                                                                let _e1176 = ((select(_e1047[2][1], _e1158, (_e1158 > _e1047[2][1])) - _e436) * _e440);
                                                                let _e1179 = ((select(_e1047[2][2], _e1162, (_e1162 < _e1047[2][2])) - _e471) * _e476);
                                                                let _e1180 = ((select(_e1047[2][2], _e1166, (_e1166 > _e1047[2][2])) - _e472) * _e476);
                                                                let _e1182 = select(_e1180, _e1179, (_e1179 < _e1180));
                                                                let _e1184 = select(_e1180, _e1179, (_e1179 > _e1180));
                                                                let _e1186 = select(_e1172, _e1171, (_e1171 < _e1172));
                                                                let _e1188 = select(_e1176, _e1175, (_e1175 < _e1176));
                                                                let _e1190 = select(_e1188, _e1186, (_e1186 > _e1188));
                                                                let _e1192 = select(_e1182, _e1190, (_e1190 > _e1182));
                                                                let _e1194 = select(_e1172, _e1171, (_e1171 > _e1172));
                                                                let _e1196 = select(_e1176, _e1175, (_e1175 > _e1176));
                                                                let _e1198 = select(_e1196, _e1194, (_e1194 < _e1196));
                                                                let _e1200 = select(_e1184, _e1198, (_e1198 < _e1184));
                                                                let _e1201 = -(_e1182);
                                                                let _e1207 = select(_e522, _e1192, (_e1192 > _e522));
                                                                if (_e1207 > (_e1200 + (select(_e1201, _e1184, (_e1184 > _e1201)) * 0.0000019073523f))) {
                                                                    phi_1966_ = type_27();
                                                                    phi_1967_ = true;
                                                                } else {
                                                                    let _e1209 = (_e1207 > _e951.member_1);
                                                                    if _e1209 {
                                                                        phi_1965_ = type_27();
                                                                    } else {
                                                                        let _e1210 = vec3<f32>(_e1047[0][0], _e1047[0][1], _e1047[0][2]);
                                                                        let _e1211 = vec3<f32>(_e1047[1][0], _e1047[1][1], _e1047[1][2]);
                                                                        let _e1212 = vec3<f32>(_e1047[2][0], _e1047[2][1], _e1047[2][2]);
                                                                        let _e1213 = (_e1047[1][0] - _e1047[0][0]);
                                                                        let _e1214 = (_e1047[1][1] - _e1047[0][1]);
                                                                        let _e1215 = (_e1047[1][2] - _e1047[0][2]);
                                                                        let _e1216 = vec3<f32>(_e1213, _e1214, _e1215);
                                                                        let _e1217 = (_e1047[2][0] - _e1047[1][0]);
                                                                        let _e1218 = (_e1047[2][1] - _e1047[1][1]);
                                                                        let _e1219 = (_e1047[2][2] - _e1047[1][2]);
                                                                        let _e1220 = vec3<f32>(_e1217, _e1218, _e1219);
                                                                        let _e1221 = (_e1047[0][0] - _e1047[2][0]);
                                                                        let _e1222 = (_e1047[0][1] - _e1047[2][1]);
                                                                        let _e1223 = (_e1047[0][2] - _e1047[2][2]);
                                                                        let _e1224 = vec3<f32>(_e1221, _e1222, _e1223);
                                                                        let _e1227 = bitcast<f32>((bitcast<u32>(_e1213) & 2147483647u));
                                                                        let _e1230 = bitcast<f32>((bitcast<u32>(_e1214) & 2147483647u));
                                                                        let _e1232 = select(_e1230, _e1227, (_e1227 > _e1230));
                                                                        let _e1235 = bitcast<f32>((bitcast<u32>(_e1215) & 2147483647u));
                                                                        let _e1237 = select(_e1235, _e1232, (_e1232 > _e1235));
                                                                        let _e1240 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                        let _e1243 = bitcast<f32>((bitcast<u32>(_e1218) & 2147483647u));
                                                                        let _e1245 = select(_e1243, _e1240, (_e1240 > _e1243));
                                                                        let _e1248 = bitcast<f32>((bitcast<u32>(_e1219) & 2147483647u));
                                                                        let _e1250 = select(_e1248, _e1245, (_e1245 > _e1248));
                                                                        let _e1253 = bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u));
                                                                        let _e1256 = bitcast<f32>((bitcast<u32>(_e1222) & 2147483647u));
                                                                        let _e1258 = select(_e1256, _e1253, (_e1253 > _e1256));
                                                                        let _e1261 = bitcast<f32>((bitcast<u32>(_e1223) & 2147483647u));
                                                                        let _e1263 = select(_e1261, _e1258, (_e1258 > _e1261));
                                                                        let _e1265 = select(_e1250, _e1237, (_e1237 > _e1250));
                                                                        let _e1267 = select(_e1263, _e1265, (_e1265 > _e1263));
                                                                        if (_e1237 == _e1267) {
                                                                            phi_1698_ = _e1074;
                                                                            phi_1699_ = _e1071;
                                                                            phi_1700_ = _e1061;
                                                                            phi_1701_ = _e1058;
                                                                            phi_1702_ = _e1210;
                                                                            phi_1703_ = _e1224;
                                                                            phi_1704_ = _e1220;
                                                                            phi_1705_ = _e1216;
                                                                        } else {
                                                                            let _e1269 = (_e1250 == _e1267);
                                                                            let _e1274 = vec3(_e1269);
                                                                            phi_1698_ = select(_e1061, _e1087, _e1269);
                                                                            phi_1699_ = select(_e1058, _e1084, _e1269);
                                                                            phi_1700_ = select(_e1087, _e1074, _e1269);
                                                                            phi_1701_ = select(_e1084, _e1071, _e1269);
                                                                            phi_1702_ = select(_e1212, _e1211, _e1274);
                                                                            phi_1703_ = select(_e1220, _e1216, _e1274);
                                                                            phi_1704_ = select(_e1216, _e1224, _e1274);
                                                                            phi_1705_ = select(_e1224, _e1220, _e1274);
                                                                        }
                                                                        let _e1280 = phi_1698_;
                                                                        let _e1282 = phi_1699_;
                                                                        let _e1284 = phi_1700_;
                                                                        let _e1286 = phi_1701_;
                                                                        let _e1288 = phi_1702_;
                                                                        let _e1290 = phi_1703_;
                                                                        let _e1292 = phi_1704_;
                                                                        let _e1294 = phi_1705_;
                                                                        let _e1301 = ((_e1292.y * _e1290.z) - (_e1290.y * _e1292.z));
                                                                        let _e1306 = ((_e1292.z * _e1290.x) - (_e1290.z * _e1292.x));
                                                                        let _e1309 = ((_e1292.x * _e1290.y) - (_e1290.x * _e1292.y));
                                                                        if (_e1109 >= _e1113) {
                                                                            phi_1736_ = select(true, false, (_e1109 >= _e1117));
                                                                        } else {
                                                                            phi_1736_ = true;
                                                                        }
                                                                        let _e1314 = phi_1736_;
                                                                        if _e1314 {
                                                                            phi_1745_ = select(_e1212, _e1211, vec3((_e1113 >= _e1117)));
                                                                        } else {
                                                                            phi_1745_ = _e1210;
                                                                        }
                                                                        let _e1319 = phi_1745_;
                                                                        let _e1330 = (((_e1301 * (_e1319.x - _e376)) + (_e1306 * (_e1319.y - _e413))) + (_e1309 * (_e1319.z - _e449)));
                                                                        let _e1335 = (((_e1301 * _e401) + (_e1306 * _e437)) + (_e1309 * _e473));
                                                                        let _e1336 = (_e1282 - _e1286);
                                                                        let _e1337 = (_e1280 - _e1284);
                                                                        let _e1345 = (-(((_e1286 * _e1336) + (_e1284 * _e1337))) / ((_e1336 * _e1336) + (_e1337 * _e1337)));
                                                                        let _e1347 = select(1f, _e1345, (_e1345 < 1f));
                                                                        let _e1349 = select(0f, _e1347, (_e1347 > 0f));
                                                                        let _e1362 = ((_e1288.x + (_e1294.x * _e1349)) - _e376);
                                                                        let _e1363 = ((_e1288.y + (_e1294.y * _e1349)) - _e413);
                                                                        let _e1364 = ((_e1288.z + (_e1294.z * _e1349)) - _e449);
                                                                        let _e1365 = (_e1364 / _e473);
                                                                        let _e1377 = bitcast<f32>((bitcast<u32>(_e1362) & 2147483647u));
                                                                        let _e1380 = bitcast<f32>((bitcast<u32>(_e1363) & 2147483647u));
                                                                        let _e1382 = select(_e1380, _e1377, (_e1377 > _e1380));
                                                                        let _e1385 = bitcast<f32>((bitcast<u32>(_e1364) & 2147483647u));
                                                                        let _e1387 = select(_e1385, _e1382, (_e1382 > _e1385));
                                                                        let _e1393 = bitcast<f32>((bitcast<u32>(_e1301) & 2147483647u));
                                                                        let _e1396 = bitcast<f32>((bitcast<u32>(_e1306) & 2147483647u));
                                                                        let _e1398 = select(_e1396, _e1393, (_e1393 > _e1396));
                                                                        let _e1401 = bitcast<f32>((bitcast<u32>(_e1309) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1301 * _e1362) + (_e1306 * _e1363)) + (_e1309 * _e1364)) - _e1330)) & 2147483647u)) <= ((0.0000009536743f * select(_e1267, _e1387, (_e1387 > _e1267))) * select(_e1401, _e1398, (_e1398 > _e1401)))) {
                                                                            let _e1411 = bitcast<f32>((bitcast<u32>(_e1292.x) & 2147483647u));
                                                                            let _e1414 = bitcast<f32>((bitcast<u32>(_e1292.y) & 2147483647u));
                                                                            let _e1416 = select(_e1414, _e1411, (_e1411 > _e1414));
                                                                            let _e1419 = bitcast<f32>((bitcast<u32>(_e1292.z) & 2147483647u));
                                                                            let _e1425 = bitcast<f32>((bitcast<u32>(_e1290.x) & 2147483647u));
                                                                            let _e1428 = bitcast<f32>((bitcast<u32>(_e1290.y) & 2147483647u));
                                                                            let _e1430 = select(_e1428, _e1425, (_e1425 > _e1428));
                                                                            let _e1433 = bitcast<f32>((bitcast<u32>(_e1290.z) & 2147483647u));
                                                                            let _e1437 = (bitcast<f32>((bitcast<u32>(_e1335) & 2147483647u)) > ((0.0000038146973f * select(_e1419, _e1416, (_e1416 > _e1419))) * select(_e1433, _e1430, (_e1430 > _e1433))));
                                                                            if _e1437 {
                                                                                phi_1910_ = (_e1330 / _e1335);
                                                                            } else {
                                                                                phi_1910_ = f32();
                                                                            }
                                                                            let _e1440 = phi_1910_;
                                                                            phi_1912_ = _e1440;
                                                                            phi_1913_ = select(true, false, _e1437);
                                                                        } else {
                                                                            phi_1912_ = f32();
                                                                            phi_1913_ = true;
                                                                        }
                                                                        let _e1443 = phi_1912_;
                                                                        let _e1445 = phi_1913_;
                                                                        if _e1445 {
                                                                            let _e1453 = (((_e1301 * (_e1362 - (_e401 * _e1365))) + (_e1306 * (_e1363 - (_e437 * _e1365)))) / _e1335);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1453) & 2147483647u)) <= _e1267) {
                                                                                phi_1933_ = (_e1365 + _e1453);
                                                                            } else {
                                                                                phi_1933_ = _e1365;
                                                                            }
                                                                            let _e1460 = phi_1933_;
                                                                            phi_1934_ = _e1460;
                                                                        } else {
                                                                            phi_1934_ = _e1443;
                                                                        }
                                                                        let _e1462 = phi_1934_;
                                                                        let _e1464 = select(_e1200, _e1462, (_e1462 < _e1200));
                                                                        let _e1466 = select(_e1192, _e1464, (_e1464 > _e1192));
                                                                        if (_e1466 >= _e522) {
                                                                            let _e1468 = (_e1466 <= _e951.member_1);
                                                                            if _e1468 {
                                                                                let _e1469 = (1f / _e1119);
                                                                                phi_1957_ = type_27(_e1466, (_e1113 * _e1469), (_e1117 * _e1469), _e980);
                                                                            } else {
                                                                                phi_1957_ = type_27();
                                                                            }
                                                                            let _e1474 = phi_1957_;
                                                                            phi_1959_ = _e1474;
                                                                            phi_1960_ = select(true, false, _e1468);
                                                                        } else {
                                                                            phi_1959_ = type_27();
                                                                            phi_1960_ = true;
                                                                        }
                                                                        let _e1477 = phi_1959_;
                                                                        let _e1479 = phi_1960_;
                                                                        if _e1479 {
                                                                            phi_1964_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1964_ = _e1477;
                                                                        }
                                                                        let _e1481 = phi_1964_;
                                                                        phi_1965_ = _e1481;
                                                                    }
                                                                    let _e1483 = phi_1965_;
                                                                    phi_1966_ = _e1483;
                                                                    phi_1967_ = _e1209;
                                                                }
                                                                let _e1485 = phi_1966_;
                                                                let _e1487 = phi_1967_;
                                                                phi_1971_ = _e1485;
                                                                phi_1972_ = _e1487;
                                                            }
                                                            let _e1489 = phi_1971_;
                                                            let _e1491 = phi_1972_;
                                                            phi_1973_ = _e1489;
                                                            phi_1974_ = _e1144;
                                                            phi_1975_ = _e1491;
                                                        }
                                                        let _e1493 = phi_1973_;
                                                        let _e1495 = phi_1974_;
                                                        let _e1497 = phi_1975_;
                                                        phi_1976_ = _e1493;
                                                        phi_1977_ = _e1495;
                                                        phi_1978_ = _e1497;
                                                    }
                                                    let _e1499 = phi_1976_;
                                                    let _e1501 = phi_1977_;
                                                    let _e1503 = phi_1978_;
                                                    phi_1986_ = _e1499;
                                                    phi_1987_ = select(_e1503, true, _e1501);
                                                } else {
                                                    phi_1986_ = type_27();
                                                    phi_1987_ = true;
                                                }
                                                let _e1506 = phi_1986_;
                                                let _e1508 = phi_1987_;
                                                if _e1508 {
                                                    phi_1991_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1991_ = _e1506;
                                                }
                                                let _e1510 = phi_1991_;
                                                if (_e1510.member_3 != 4294967295u) {
                                                    if (_e980 == _e150) {
                                                        phi_2320_ = false;
                                                    } else {
                                                        let _e1514 = (_e980 < arrayLength((&global_5.member)));
                                                        if _e1514 {
                                                            if _e1514 {
                                                            } else {
                                                                phi_3484_ = true;
                                                                break;
                                                            }
                                                            let _e1516 = global_5.member[_e980];
                                                            phi_2014_ = _e1516;
                                                        } else {
                                                            phi_2014_ = 4294967295u;
                                                        }
                                                        let _e1518 = phi_2014_;
                                                        let _e1519 = (_e1518 < arrayLength((&global_6.member)));
                                                        if _e1519 {
                                                            if _e1519 {
                                                            } else {
                                                                phi_3484_ = true;
                                                                break;
                                                            }
                                                            let _e1521 = global_6.member[_e1518];
                                                            phi_2028_ = _e1521;
                                                        } else {
                                                            phi_2028_ = 0i;
                                                        }
                                                        let _e1523 = phi_2028_;
                                                        let _e1524 = (_e1523 == 0i);
                                                        if _e1524 {
                                                            phi_2319_ = true;
                                                        } else {
                                                            if _e368 {
                                                                phi_2049_ = vec3<f32>(_e1047[0][0], _e1047[0][1], _e1047[0][2]);
                                                            } else {
                                                                if (_e344 == 1u) {
                                                                    phi_2048_ = vec3<f32>(_e1047[0][2], _e1047[0][0], _e1047[0][1]);
                                                                } else {
                                                                    phi_2048_ = vec3<f32>(_e1047[0][1], _e1047[0][2], _e1047[0][0]);
                                                                }
                                                                let _e1529 = phi_2048_;
                                                                phi_2049_ = _e1529;
                                                            }
                                                            let _e1532 = phi_2049_;
                                                            if _e368 {
                                                                phi_2066_ = vec3<f32>(_e1047[1][0], _e1047[1][1], _e1047[1][2]);
                                                            } else {
                                                                if (_e344 == 1u) {
                                                                    phi_2065_ = vec3<f32>(_e1047[1][2], _e1047[1][0], _e1047[1][1]);
                                                                } else {
                                                                    phi_2065_ = vec3<f32>(_e1047[1][1], _e1047[1][2], _e1047[1][0]);
                                                                }
                                                                let _e1537 = phi_2065_;
                                                                phi_2066_ = _e1537;
                                                            }
                                                            let _e1540 = phi_2066_;
                                                            if _e368 {
                                                                phi_2083_ = vec3<f32>(_e1047[2][0], _e1047[2][1], _e1047[2][2]);
                                                            } else {
                                                                if (_e344 == 1u) {
                                                                    phi_2082_ = vec3<f32>(_e1047[2][2], _e1047[2][0], _e1047[2][1]);
                                                                } else {
                                                                    phi_2082_ = vec3<f32>(_e1047[2][1], _e1047[2][2], _e1047[2][0]);
                                                                }
                                                                let _e1545 = phi_2082_;
                                                                phi_2083_ = _e1545;
                                                            }
                                                            let _e1548 = phi_2083_;
                                                            let _e1551 = (_e1540.x - _e1532.x);
                                                            let _e1554 = (_e1540.y - _e1532.y);
                                                            let _e1557 = (_e1540.z - _e1532.z);
                                                            let _e1559 = (_e1548.x - _e1532.x);
                                                            let _e1561 = (_e1548.y - _e1532.y);
                                                            let _e1563 = (_e1548.z - _e1532.z);
                                                            if (_e222.member_1 == 1u) {
                                                                phi_2119_ = (vec3<f32>(_e222.member[0], _e222.member[1], _e222.member[2]) - _e1532);
                                                            } else {
                                                                phi_2119_ = vec3<f32>(_e222.member[0], _e222.member[1], _e222.member[2]);
                                                            }
                                                            let _e1578 = phi_2119_;
                                                            let _e1584 = bitcast<f32>((bitcast<u32>((_e1551 * _e1561)) ^ _e222.member_3[0]));
                                                            let _e1588 = bitcast<f32>((bitcast<u32>((_e1554 * _e1559)) ^ _e222.member_3[0]));
                                                            let _e1592 = bitcast<f32>((bitcast<u32>((_e1554 * _e1563)) ^ _e222.member_3[0]));
                                                            let _e1596 = bitcast<f32>((bitcast<u32>((_e1557 * _e1561)) ^ _e222.member_3[0]));
                                                            let _e1600 = bitcast<f32>((bitcast<u32>((_e1557 * _e1559)) ^ _e222.member_3[0]));
                                                            let _e1604 = bitcast<f32>((bitcast<u32>((_e1551 * _e1563)) ^ _e222.member_3[0]));
                                                            let _e1605 = (_e1592 - _e1596);
                                                            let _e1606 = (_e1600 - _e1604);
                                                            let _e1607 = (_e1584 - _e1588);
                                                            let _e1631 = (bitcast<f32>((bitcast<u32>(_e1592) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1596) & 2147483647u)));
                                                            let _e1638 = (bitcast<f32>((bitcast<u32>(_e1600) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1604) & 2147483647u)));
                                                            let _e1645 = (bitcast<f32>((bitcast<u32>(_e1584) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1588) & 2147483647u)));
                                                            if (_e222.member_2 == 0f) {
                                                                phi_2301_ = 0f;
                                                            } else {
                                                                let _e1675 = bitcast<f32>((bitcast<u32>(_e1605) & 2147483647u));
                                                                let _e1678 = bitcast<f32>((bitcast<u32>(_e1606) & 2147483647u));
                                                                let _e1681 = bitcast<f32>((bitcast<u32>(_e1607) & 2147483647u));
                                                                let _e1683 = select(_e1681, _e1678, (_e1678 > _e1681));
                                                                let _e1687 = select(_e1681, _e1678, (_e1678 < _e1681));
                                                                let _e1691 = select(_e1678, _e1675, (_e1675 < _e1678));
                                                                let _e1693 = select(_e1678, _e1675, (_e1675 > _e1678));
                                                                let _e1695 = select(_e1681, _e1693, (_e1693 < _e1681));
                                                                phi_2301_ = bitcast<f32>((bitcast<u32>((_e222.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1683, _e1675, (_e1675 > _e1683)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1695, _e1691, (_e1691 > _e1695)))) ^ _e222.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1687, _e1675, (_e1675 < _e1687)))) ^ _e222.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1631 + _e1638) + _e1645))) ^ _e222.member_3[0]))) * 1.0000005f)) ^ _e222.member_3[0])))) ^ _e222.member_3[0]));
                                                            }
                                                            let _e1722 = phi_2301_;
                                                            phi_2319_ = (_e1524 || !(((((bitcast<f32>((bitcast<u32>((_e1578.x * _e1605)) ^ _e222.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1578.y * _e1606)) ^ _e222.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1578.z * _e1607)) ^ _e222.member_3[0]))) * f32(-(_e1523))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1578.x) & 2147483647u)) * _e1631)) ^ _e222.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1578.y) & 2147483647u)) * _e1638)) ^ _e222.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1578.z) & 2147483647u)) * _e1645)) ^ _e222.member_3[0]))))) ^ _e222.member_3[0])) + _e1722) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1736 = phi_2319_;
                                                        phi_2320_ = _e1736;
                                                    }
                                                    let _e1738 = phi_2320_;
                                                    if _e1738 {
                                                        if (_e1510.member < _e951.member.member) {
                                                            phi_2340_ = true;
                                                        } else {
                                                            if (_e1510.member == _e951.member.member) {
                                                                phi_2339_ = (_e1510.member_3 < _e951.member.member_3);
                                                            } else {
                                                                phi_2339_ = false;
                                                            }
                                                            let _e1748 = phi_2339_;
                                                            phi_2340_ = _e1748;
                                                        }
                                                        let _e1750 = phi_2340_;
                                                        if _e1750 {
                                                            phi_2346_ = type_43(_e1510, _e1510.member);
                                                        } else {
                                                            phi_2346_ = _e951;
                                                        }
                                                        let _e1753 = phi_2346_;
                                                        phi_2347_ = _e1753;
                                                    } else {
                                                        phi_2347_ = _e951;
                                                    }
                                                    let _e1755 = phi_2347_;
                                                    phi_2348_ = _e1755;
                                                } else {
                                                    phi_2348_ = _e951;
                                                }
                                                let _e1757 = phi_2348_;
                                                phi_1016_ = _e1757;
                                            } else {
                                                phi_1016_ = type_43();
                                            }
                                            let _e1759 = phi_1016_;
                                            continue;
                                            continuing {
                                                phi_1015_ = _e1759;
                                                phi_1018_ = _e966;
                                                phi_3484_ = _e554;
                                                break if !(_e972);
                                            }
                                        }
                                        let _e1762 = phi_3484_;
                                        phi_3650_ = _e1762;
                                        if _e1762 {
                                            break;
                                        }
                                        phi_3654_ = _e1762;
                                        let _e1989 = local_11;
                                        phi_3297_ = _e1989;
                                        phi_3298_ = _e595;
                                        phi_3299_ = false;
                                        phi_3300_ = _e599;
                                    } else {
                                        let _e608 = (_e595.member_1 < _e91);
                                        if _e608 {
                                            if _e608 {
                                            } else {
                                                phi_3650_ = true;
                                                break;
                                            }
                                            let _e610 = global_10.member[_e595.member_1];
                                            phi_2367_ = _e610;
                                        } else {
                                            phi_2367_ = type_54(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e612 = phi_2367_;
                                        let _e627 = ((10u * _e344) & 31u);
                                        let _e630 = ((_e612.member[0] >> bitcast<u32>(_e627)) & 1023u);
                                        let _e635 = bitcast<f32>((bitcast<u32>(((_e595.member.member_1[0] - _e595.member.member[0]) * 0.0009775171f)) ^ _e133));
                                        let _e641 = (_e595.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e630) * _e635)) ^ _e133)));
                                        let _e645 = select(select(_e595.member.member_1[0], _e641, (_e641 < _e595.member.member_1[0])), _e595.member.member_1[0], (_e630 == 1023u));
                                        let _e647 = ((10u * _e343) & 31u);
                                        let _e650 = ((_e612.member[0] >> bitcast<u32>(_e647)) & 1023u);
                                        let _e655 = bitcast<f32>((bitcast<u32>(((_e595.member.member_1[1] - _e595.member.member[1]) * 0.0009775171f)) ^ _e133));
                                        let _e661 = (_e595.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e650) * _e655)) ^ _e133)));
                                        let _e665 = select(select(_e595.member.member_1[1], _e661, (_e661 < _e595.member.member_1[1])), _e595.member.member_1[1], (_e650 == 1023u));
                                        let _e667 = ((10u * _e345) & 31u);
                                        let _e670 = ((_e612.member[0] >> bitcast<u32>(_e667)) & 1023u);
                                        let _e675 = bitcast<f32>((bitcast<u32>(((_e595.member.member_1[2] - _e595.member.member[2]) * 0.0009775171f)) ^ _e133));
                                        let _e681 = (_e595.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e670) * _e675)) ^ _e133)));
                                        let _e685 = select(select(_e595.member.member_1[2], _e681, (_e681 < _e595.member.member_1[2])), _e595.member.member_1[2], (_e670 == 1023u));
                                        let _e688 = ((_e612.member[1] >> bitcast<u32>(_e627)) & 1023u);
                                        let _e694 = (_e595.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e688) * _e635)) ^ _e133)));
                                        let _e698 = select(select(_e595.member.member_1[0], _e694, (_e694 < _e595.member.member_1[0])), _e595.member.member_1[0], (_e688 == 1023u));
                                        let _e701 = ((_e612.member[1] >> bitcast<u32>(_e647)) & 1023u);
                                        let _e707 = (_e595.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e701) * _e655)) ^ _e133)));
                                        let _e711 = select(select(_e595.member.member_1[1], _e707, (_e707 < _e595.member.member_1[1])), _e595.member.member_1[1], (_e701 == 1023u));
                                        let _e714 = ((_e612.member[1] >> bitcast<u32>(_e667)) & 1023u);
                                        let _e720 = (_e595.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e714) * _e675)) ^ _e133)));
                                        let _e724 = select(select(_e595.member.member_1[2], _e720, (_e720 < _e595.member.member_1[2])), _e595.member.member_1[2], (_e714 == 1023u));
                                        let _e730 = ((_e612.member_1[0] >> bitcast<u32>(_e627)) & 1023u);
                                        let _e736 = (_e595.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e730) * _e635)) ^ _e133)));
                                        let _e740 = select(select(_e595.member.member_1[0], _e736, (_e736 < _e595.member.member_1[0])), _e595.member.member_1[0], (_e730 == 1023u));
                                        let _e743 = ((_e612.member_1[0] >> bitcast<u32>(_e647)) & 1023u);
                                        let _e749 = (_e595.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e743) * _e655)) ^ _e133)));
                                        let _e753 = select(select(_e595.member.member_1[1], _e749, (_e749 < _e595.member.member_1[1])), _e595.member.member_1[1], (_e743 == 1023u));
                                        let _e756 = ((_e612.member_1[0] >> bitcast<u32>(_e667)) & 1023u);
                                        let _e762 = (_e595.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e756) * _e675)) ^ _e133)));
                                        let _e766 = select(select(_e595.member.member_1[2], _e762, (_e762 < _e595.member.member_1[2])), _e595.member.member_1[2], (_e756 == 1023u));
                                        let _e769 = ((_e612.member_1[1] >> bitcast<u32>(_e627)) & 1023u);
                                        let _e775 = (_e595.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e769) * _e635)) ^ _e133)));
                                        let _e779 = select(select(_e595.member.member_1[0], _e775, (_e775 < _e595.member.member_1[0])), _e595.member.member_1[0], (_e769 == 1023u));
                                        let _e782 = ((_e612.member_1[1] >> bitcast<u32>(_e647)) & 1023u);
                                        let _e788 = (_e595.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e782) * _e655)) ^ _e133)));
                                        let _e792 = select(select(_e595.member.member_1[1], _e788, (_e788 < _e595.member.member_1[1])), _e595.member.member_1[1], (_e782 == 1023u));
                                        let _e795 = ((_e612.member_1[1] >> bitcast<u32>(_e667)) & 1023u);
                                        let _e801 = (_e595.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e795) * _e675)) ^ _e133)));
                                        let _e805 = select(select(_e595.member.member_1[2], _e801, (_e801 < _e595.member.member_1[2])), _e595.member.member_1[2], (_e795 == 1023u));
                                        let _e810 = type_61(type_59(array<f32, 3>(_e645, _e665, _e685), array<f32, 3>(_e698, _e711, _e724)), _e612.member_2);
                                        let _e815 = type_61(type_59(array<f32, 3>(_e740, _e753, _e766), array<f32, 3>(_e779, _e792, _e805)), _e612.member_3);
                                        let _e821 = ((_e645 - _e399) * _e404);
                                        let _e822 = ((_e740 - _e399) * _e404);
                                        let _e823 = ((_e698 - _e400) * _e404);
                                        let _e824 = ((_e779 - _e400) * _e404);
                                        let _e829 = ((_e665 - _e435) * _e440);
                                        let _e830 = ((_e753 - _e435) * _e440);
                                        let _e831 = ((_e711 - _e436) * _e440);
                                        let _e832 = ((_e792 - _e436) * _e440);
                                        let _e837 = ((_e685 - _e471) * _e476);
                                        let _e838 = ((_e766 - _e471) * _e476);
                                        let _e839 = ((_e724 - _e472) * _e476);
                                        let _e840 = ((_e805 - _e472) * _e476);
                                        let _e842 = select(_e839, _e837, (_e837 < _e839));
                                        let _e844 = select(_e840, _e838, (_e838 < _e840));
                                        let _e846 = select(_e839, _e837, (_e837 > _e839));
                                        let _e848 = select(_e840, _e838, (_e838 > _e840));
                                        let _e850 = select(_e823, _e821, (_e821 < _e823));
                                        let _e852 = select(_e824, _e822, (_e822 < _e824));
                                        let _e854 = select(_e831, _e829, (_e829 < _e831));
                                        let _e856 = select(_e832, _e830, (_e830 < _e832));
                                        let _e858 = select(_e854, _e850, (_e850 > _e854));
                                        let _e860 = select(_e856, _e852, (_e852 > _e856));
                                        let _e862 = select(_e842, _e858, (_e858 > _e842));
                                        let _e864 = select(_e844, _e860, (_e860 > _e844));
                                        let _e866 = select(_e823, _e821, (_e821 > _e823));
                                        let _e868 = select(_e824, _e822, (_e822 > _e824));
                                        let _e870 = select(_e831, _e829, (_e829 > _e831));
                                        let _e872 = select(_e832, _e830, (_e830 > _e832));
                                        let _e874 = select(_e870, _e866, (_e866 < _e870));
                                        let _e876 = select(_e872, _e868, (_e868 < _e872));
                                        let _e881 = -(_e842);
                                        let _e882 = -(_e844);
                                        let _e889 = (select(_e846, _e874, (_e874 < _e846)) + (select(_e881, _e846, (_e846 > _e881)) * 0.0000019073523f));
                                        let _e890 = (select(_e848, _e876, (_e876 < _e848)) + (select(_e882, _e848, (_e848 > _e882)) * 0.0000019073523f));
                                        let _e892 = select(_e522, _e862, (_e862 > _e522));
                                        let _e894 = select(_e522, _e864, (_e864 > _e522));
                                        let _e899 = (_e892 <= select(_e556.member_1, _e889, (_e889 < _e556.member_1)));
                                        let _e900 = (_e894 <= select(_e556.member_1, _e890, (_e890 < _e556.member_1)));
                                        let _e901 = (_e892 <= _e894);
                                        if _e899 {
                                            if _e900 {
                                                if _e901 {
                                                    phi_3199_ = _e815;
                                                } else {
                                                    phi_3199_ = _e810;
                                                }
                                                let _e903 = phi_3199_;
                                                let _e911 = (_e599 % 128u);
                                                let _e912 = (_e911 < 128u);
                                                if _e912 {
                                                } else {
                                                    phi_3650_ = true;
                                                    break;
                                                }
                                                local_6[_e911] = _e903.member_1;
                                                if _e912 {
                                                } else {
                                                    phi_3650_ = true;
                                                    break;
                                                }
                                                local_5[_e911] = _e903.member.member[0];
                                                if _e912 {
                                                } else {
                                                    phi_3650_ = true;
                                                    break;
                                                }
                                                local_4[_e911] = _e903.member.member[1];
                                                if _e912 {
                                                } else {
                                                    phi_3650_ = true;
                                                    break;
                                                }
                                                local_3[_e911] = _e903.member.member[2];
                                                if _e912 {
                                                } else {
                                                    phi_3650_ = true;
                                                    break;
                                                }
                                                local_2[_e911] = _e903.member.member_1[0];
                                                if _e912 {
                                                } else {
                                                    phi_3650_ = true;
                                                    break;
                                                }
                                                local_1[_e911] = _e903.member.member_1[1];
                                                if _e912 {
                                                } else {
                                                    phi_3650_ = true;
                                                    break;
                                                }
                                                local[_e911] = _e903.member.member_1[2];
                                                if _e912 {
                                                } else {
                                                    phi_3650_ = true;
                                                    break;
                                                }
                                                local_7[_e911] = select(_e894, _e892, (_e892 > _e894));
                                                if _e901 {
                                                    phi_3276_ = _e810;
                                                } else {
                                                    phi_3276_ = _e815;
                                                }
                                                let _e929 = phi_3276_;
                                                phi_3277_ = _e929;
                                                phi_3278_ = (_e599 + 1u);
                                            } else {
                                                phi_3277_ = type_61();
                                                phi_3278_ = u32();
                                            }
                                            let _e931 = phi_3277_;
                                            let _e933 = phi_3278_;
                                            phi_3280_ = _e931;
                                            phi_3281_ = _e933;
                                            phi_3282_ = select(true, false, _e900);
                                        } else {
                                            phi_3280_ = type_61();
                                            phi_3281_ = u32();
                                            phi_3282_ = true;
                                        }
                                        let _e936 = phi_3280_;
                                        let _e938 = phi_3281_;
                                        let _e940 = phi_3282_;
                                        if _e940 {
                                            if _e899 {
                                                phi_3289_ = _e810;
                                            } else {
                                                phi_3289_ = _e815;
                                            }
                                            let _e942 = phi_3289_;
                                            phi_3294_ = _e942;
                                            phi_3295_ = select(_e900, true, _e899);
                                        } else {
                                            phi_3294_ = _e936;
                                            phi_3295_ = _e597;
                                        }
                                        let _e945 = phi_3294_;
                                        let _e947 = phi_3295_;
                                        phi_3654_ = _e554;
                                        phi_3297_ = _e556;
                                        phi_3298_ = _e945;
                                        phi_3299_ = _e947;
                                        phi_3300_ = select(_e938, _e599, _e940);
                                    }
                                    let _e1764 = phi_3654_;
                                    let _e1766 = phi_3297_;
                                    let _e1768 = phi_3298_;
                                    let _e1770 = phi_3299_;
                                    let _e1772 = phi_3300_;
                                    phi_3653_ = _e1764;
                                    phi_3301_ = _e1766;
                                    phi_3302_ = _e1768;
                                    phi_3303_ = (_e560 - 1u);
                                    phi_3304_ = _e1770;
                                    phi_3305_ = _e1772;
                                } else {
                                    phi_3653_ = _e554;
                                    phi_3301_ = _e556;
                                    phi_3302_ = _e595;
                                    phi_3303_ = _e560;
                                    phi_3304_ = _e597;
                                    phi_3305_ = _e599;
                                }
                                let _e1774 = phi_3653_;
                                let _e1776 = phi_3301_;
                                let _e1778 = phi_3302_;
                                let _e1780 = phi_3303_;
                                let _e1782 = phi_3304_;
                                let _e1784 = phi_3305_;
                                phi_3652_ = _e1774;
                                phi_3306_ = _e1776;
                                phi_3307_ = _e1778;
                                phi_3308_ = _e1780;
                                phi_3309_ = _e1782;
                                phi_3310_ = _e1784;
                            } else {
                                phi_3652_ = _e554;
                                phi_3306_ = type_43();
                                phi_3307_ = type_61();
                                phi_3308_ = u32();
                                phi_3309_ = bool();
                                phi_3310_ = u32();
                            }
                            let _e1786 = phi_3652_;
                            let _e1788 = phi_3306_;
                            let _e1790 = phi_3307_;
                            let _e1792 = phi_3308_;
                            let _e1794 = phi_3309_;
                            let _e1796 = phi_3310_;
                            phi_3651_ = _e1786;
                            phi_890_ = _e1788;
                            phi_893_ = _e1790;
                            phi_895_ = _e1792;
                            phi_897_ = _e1794;
                            phi_899_ = _e1796;
                            phi_3311_ = _e568;
                        } else {
                            phi_3651_ = _e554;
                            phi_890_ = type_43();
                            phi_893_ = type_61();
                            phi_895_ = u32();
                            phi_897_ = bool();
                            phi_899_ = u32();
                            phi_3311_ = false;
                        }
                        let _e1798 = phi_3651_;
                        let _e1800 = phi_890_;
                        let _e1802 = phi_893_;
                        let _e1804 = phi_895_;
                        let _e1806 = phi_897_;
                        let _e1808 = phi_899_;
                        let _e1810 = phi_3311_;
                        continue;
                        continuing {
                            phi_3490_ = _e1798;
                            phi_889_ = _e1800;
                            phi_892_ = _e1802;
                            phi_894_ = _e1804;
                            phi_896_ = _e1806;
                            phi_898_ = _e1808;
                            phi_3650_ = _e1798;
                            break if !(_e1810);
                        }
                    }
                    let _e1813 = phi_3650_;
                    if _e1813 {
                        break;
                    }
                    let _e1815 = local_10;
                    if (_e1815.member.member_3 != 4294967295u) {
                        let _e1820 = (_e346 / 3i);
                        let _e1827 = bitcast<f32>((bitcast<u32>((_e1820 + 127i)) << bitcast<u32>(23i)));
                        let _e1835 = (((_e1815.member.member * _e1827) * _e1827) * bitcast<f32>((bitcast<u32>(((_e346 - (2i * _e1820)) + 127i)) << bitcast<u32>(23i))));
                        let _e1837 = select(340282350000000000000000000000000000000f, _e1835, (_e1835 < 340282350000000000000000000000000000000f));
                        phi_3363_ = type_27(select(-340282350000000000000000000000000000000f, _e1837, (_e1837 > -340282350000000000000000000000000000000f)), _e1815.member.member_1, _e1815.member.member_2, _e1815.member.member_3);
                    } else {
                        phi_3363_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1844 = phi_3363_;
                    if _e223 {
                    } else {
                        break;
                    }
                    global_8.member[_e137] = _e1844;
                    if _e144 {
                    } else {
                        break;
                    }
                    let _e1848 = select(0u, 1u, (_e290 <= _e300));
                    if (_e1848 > 0u) {
                        let _e1850 = (1u < _e105);
                        if _e1850 {
                            if (0u < _e105) {
                            } else {
                                break;
                            }
                            let _e1854 = atomicAdd((&global_9.member[0u]), _e1848);
                            if ((_e1854 + _e1848) < _e1854) {
                                if _e1850 {
                                } else {
                                    break;
                                }
                                let _e1859 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1862 = select(0u, 1u, (_e1844.member_3 != 4294967295u));
                    if (_e1862 > 0u) {
                        let _e1864 = (3u < _e105);
                        if _e1864 {
                            if (2u < _e105) {
                            } else {
                                break;
                            }
                            let _e1868 = atomicAdd((&global_9.member[2u]), _e1862);
                            if ((_e1868 + _e1862) < _e1868) {
                                if _e1864 {
                                } else {
                                    break;
                                }
                                let _e1873 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
