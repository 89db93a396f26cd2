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
    var phi_323_: u32;
    var phi_388_: type_43;
    var phi_494_: i32;
    var phi_495_: i32;
    var phi_505_: bool;
    var phi_515_: u32;
    var phi_516_: u32;
    var phi_518_: bool;
    var phi_523_: u32;
    var phi_568_: f32;
    var phi_574_: f32;
    var phi_585_: f32;
    var phi_591_: f32;
    var phi_614_: f32;
    var phi_625_: f32;
    var phi_634_: f32;
    var phi_640_: f32;
    var phi_651_: f32;
    var phi_657_: f32;
    var phi_680_: f32;
    var phi_691_: f32;
    var phi_700_: f32;
    var phi_706_: f32;
    var phi_717_: f32;
    var phi_723_: f32;
    var phi_746_: f32;
    var phi_757_: f32;
    var phi_857_: f32;
    var phi_858_: f32;
    var phi_4758_: bool;
    var phi_1978_: type_45;
    var phi_1981_: type_60;
    var phi_1983_: u32;
    var phi_1985_: bool;
    var phi_1987_: u32;
    var phi_1998_: bool;
    var phi_2035_: type_60;
    var phi_2036_: bool;
    var phi_2037_: u32;
    var phi_3988_: u32;
    var phi_3989_: u32;
    var phi_3999_: u32;
    var phi_4001_: u32;
    var phi_4002_: bool;
    var phi_4022_: u32;
    var phi_4023_: u32;
    var phi_4027_: type_63;
    var phi_4371_: type_60;
    var phi_4404_: type_60;
    var phi_4405_: type_60;
    var phi_4406_: u32;
    var phi_4408_: type_60;
    var phi_4409_: u32;
    var phi_4410_: bool;
    var phi_4419_: type_60;
    var phi_4424_: type_60;
    var phi_4425_: bool;
    var phi_2055_: type_45;
    var phi_2058_: type_8;
    var phi_2059_: type_8;
    var phi_2081_: type_8;
    var phi_2102_: u32;
    var phi_2191_: array<array<f32, 3>, 3>;
    var phi_2662_: vec3<f32>;
    var phi_2663_: vec3<f32>;
    var phi_2694_: bool;
    var phi_2703_: vec3<f32>;
    var phi_2743_: type_29;
    var phi_2745_: type_29;
    var phi_2746_: bool;
    var phi_2750_: type_29;
    var phi_2751_: type_29;
    var phi_2752_: type_29;
    var phi_2753_: bool;
    var phi_2757_: type_29;
    var phi_2758_: bool;
    var phi_2762_: type_29;
    var phi_2763_: bool;
    var phi_2767_: type_29;
    var phi_2790_: u32;
    var phi_2804_: i32;
    var phi_2824_: vec3<f32>;
    var phi_2825_: vec3<f32>;
    var phi_2841_: vec3<f32>;
    var phi_2842_: vec3<f32>;
    var phi_2858_: vec3<f32>;
    var phi_2859_: vec3<f32>;
    var phi_2895_: vec3<f32>;
    var phi_3077_: f32;
    var phi_3095_: bool;
    var phi_3096_: bool;
    var phi_3115_: bool;
    var phi_3116_: bool;
    var phi_3122_: type_45;
    var phi_3123_: type_45;
    var phi_3124_: type_45;
    var phi_2056_: type_45;
    var phi_4752_: bool;
    var phi_4888_: bool;
    var phi_4427_: type_45;
    var phi_4428_: type_60;
    var phi_4429_: bool;
    var phi_4430_: u32;
    var phi_4887_: bool;
    var phi_4431_: type_45;
    var phi_4432_: type_60;
    var phi_4433_: u32;
    var phi_4434_: bool;
    var phi_4435_: u32;
    var phi_4886_: bool;
    var phi_4436_: type_45;
    var phi_4437_: type_60;
    var phi_4438_: u32;
    var phi_4439_: bool;
    var phi_4440_: u32;
    var phi_4885_: bool;
    var phi_1979_: type_45;
    var phi_1982_: type_60;
    var phi_1984_: u32;
    var phi_1986_: bool;
    var phi_1988_: u32;
    var phi_4441_: bool;
    var phi_4884_: bool;
    var local_4: type_45;
    var phi_4493_: type_29;
    var local_5: type_45;

    switch bitcast<i32>(0u) {
        default: {
            let _e88 = global;
            let _e90 = arrayLength((&global_4.member));
            let _e92 = arrayLength((&global_5.member));
            let _e104 = arrayLength((&global_10.member));
            let _e108 = global_3.member[0u][0u];
            let _e112 = global_3.member[0u][1u];
            let _e116 = global_3.member[0u][2u];
            let _e120 = global_3.member[0u][3u];
            let _e124 = global_3.member[1u][0u];
            let _e128 = global_3.member[1u][1u];
            let _e132 = global_3.member[1u][2u];
            let _e136 = (_e88.x + (_e88.y * 2097152u));
            let _e148 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e120) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e108), bitcast<i32>(_e112), bitcast<i32>(_e116));
            local = array<i32, 3>(bitcast<i32>(_e124), bitcast<i32>(_e128), bitcast<i32>(_e132));
            let _e151 = (_e136 < arrayLength((&global_8.member)));
            if _e151 {
                if _e151 {
                } else {
                    break;
                }
                let _e155 = global_8.member[_e136].member_2;
                phi_323_ = _e155;
            } else {
                phi_323_ = 4294967295u;
            }
            let _e157 = phi_323_;
            let _e160 = global_1.member[0u];
            let _e164 = global_2.member[0u][0u];
            let _e168 = global_2.member[0u][1u];
            let _e172 = global_2.member[0u][2u];
            let _e176 = global_2.member[0u][3u];
            let _e180 = global_2.member[1u][0u];
            let _e184 = global_2.member[1u][1u];
            let _e188 = global_2.member[1u][2u];
            let _e192 = global_2.member[1u][3u];
            let _e193 = bitcast<f32>(_e164);
            let _e194 = bitcast<f32>(_e168);
            let _e195 = bitcast<f32>(_e172);
            let _e197 = bitcast<f32>(_e180);
            let _e198 = array<u32, 3>(_e184, _e188, _e192);
            let _e200 = bitcast<i32>(_e160);
            let _e201 = (_e200 / 2i);
            let _e206 = bitcast<f32>((bitcast<u32>((_e201 + 127i)) << bitcast<u32>(23i)));
            let _e212 = bitcast<f32>((bitcast<u32>(((_e200 - _e201) + 127i)) << bitcast<u32>(23i)));
            if (_e176 == 0u) {
                phi_388_ = type_43(array<f32, 3>(_e193, _e194, _e195), _e176, _e197, _e198);
            } else {
                phi_388_ = type_43(array<f32, 3>(((_e193 * _e206) * _e212), ((_e194 * _e206) * _e212), ((_e195 * _e206) * _e212)), _e176, ((_e197 * _e206) * _e212), _e198);
            }
            let _e225 = phi_388_;
            if _e151 {
                let _e226 = (_e136 < arrayLength((&global_9.member)));
                if _e226 {
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e236 = global_8.member[_e136].member.member_2[0u];
                    let _e238 = (bitcast<u32>(_e236) & 2147483647u);
                    let _e244 = global_8.member[_e136].member.member_2[1u];
                    let _e246 = (bitcast<u32>(_e244) & 2147483647u);
                    let _e252 = global_8.member[_e136].member.member_2[2u];
                    let _e254 = (bitcast<u32>(_e252) & 2147483647u);
                    let _e260 = global_8.member[_e136].member.member[0u];
                    let _e262 = (bitcast<u32>(_e260) & 2147483647u);
                    let _e268 = global_8.member[_e136].member.member[1u];
                    let _e270 = (bitcast<u32>(_e268) & 2147483647u);
                    let _e276 = global_8.member[_e136].member.member[2u];
                    let _e278 = (bitcast<u32>(_e276) & 2147483647u);
                    let _e280 = select(_e246, _e238, (_e246 < _e238));
                    let _e282 = select(_e254, _e280, (_e254 < _e280));
                    let _e284 = select(_e262, _e282, (_e262 < _e282));
                    let _e286 = select(_e270, _e284, (_e270 < _e284));
                    let _e288 = select(_e278, _e286, (_e278 < _e286));
                    let _e293 = global_8.member[_e136].member.member_1;
                    let _e295 = (bitcast<u32>(_e293) & 2147483647u);
                    let _e303 = global_8.member[_e136].member.member_3;
                    let _e309 = (((select(_e295, _e288, (_e295 < _e288)) < 2139095040u) && ((bitcast<u32>(_e303) & 2147483647u) <= 2139095040u)) && (_e282 > 0u));
                    if _e309 {
                        let _e312 = (bitcast<u32>(bitcast<f32>(_e282)) & 2147483647u);
                        if (_e312 >= 8388608u) {
                            phi_494_ = (bitcast<i32>((_e312 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_494_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e312)), 32u, (_e312 == 0u))));
                        }
                        let _e326 = phi_494_;
                        phi_495_ = _e326;
                    } else {
                        phi_495_ = 0i;
                    }
                    let _e328 = phi_495_;
                    let _e329 = (_e238 == _e282);
                    if _e329 {
                        phi_505_ = true;
                    } else {
                        phi_505_ = (_e246 == _e282);
                    }
                    let _e332 = phi_505_;
                    let _e333 = select(1u, 0u, _e329);
                    if _e332 {
                        let _e334 = (_e333 + 1u);
                        phi_515_ = _e334;
                        phi_516_ = _e334;
                        phi_518_ = select(true, false, (_e334 == 2u));
                    } else {
                        phi_515_ = u32();
                        phi_516_ = 0u;
                        phi_518_ = true;
                    }
                    let _e338 = phi_515_;
                    let _e340 = phi_516_;
                    let _e342 = phi_518_;
                    if _e342 {
                        phi_523_ = (_e340 + 1u);
                    } else {
                        phi_523_ = 0u;
                    }
                    let _e346 = phi_523_;
                    let _e347 = select(_e338, _e340, _e342);
                    let _e348 = select(_e333, select(2u, _e333, _e332), _e342);
                    let _e349 = -(_e328);
                    let _e350 = (_e349 / 2i);
                    let _e355 = bitcast<f32>((bitcast<u32>((_e350 + 127i)) << bitcast<u32>(23i)));
                    let _e361 = bitcast<f32>((bitcast<u32>(((_e349 - _e350) + 127i)) << bitcast<u32>(23i)));
                    let _e366 = global_8.member[_e136].member.member;
                    let _e367 = (_e347 == 0u);
                    if _e367 {
                        phi_568_ = _e366[0];
                    } else {
                        phi_568_ = _e366[1];
                    }
                    let _e371 = phi_568_;
                    let _e372 = (_e347 == 2u);
                    if _e372 {
                        phi_574_ = _e366[2];
                    } else {
                        phi_574_ = _e371;
                    }
                    let _e375 = phi_574_;
                    let _e376 = global_8.member[_e136].member.member_2;
                    if _e367 {
                        phi_585_ = _e376[0];
                    } else {
                        phi_585_ = _e376[1];
                    }
                    let _e380 = phi_585_;
                    if _e372 {
                        phi_591_ = _e376[2];
                    } else {
                        phi_591_ = _e380;
                    }
                    let _e383 = phi_591_;
                    let _e385 = ((_e383 * _e355) * _e361);
                    let _e389 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e389 {
                        let _e393 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) * 0.00000011920929f);
                        phi_614_ = select(0.00000000000011368684f, _e393, (_e393 > 0.00000000000011368684f));
                    } else {
                        phi_614_ = 0f;
                    }
                    let _e397 = phi_614_;
                    let _e398 = (_e375 + _e397);
                    let _e399 = (_e375 - _e397);
                    let _e400 = select(_e385, 0f, _e389);
                    if _e389 {
                        phi_625_ = 38685626000000000000000000f;
                    } else {
                        phi_625_ = (1f / _e385);
                    }
                    let _e403 = phi_625_;
                    let _e404 = (_e346 == 0u);
                    if _e404 {
                        phi_634_ = _e366[0];
                    } else {
                        phi_634_ = _e366[1];
                    }
                    let _e408 = phi_634_;
                    let _e409 = (_e346 == 2u);
                    if _e409 {
                        phi_640_ = _e366[2];
                    } else {
                        phi_640_ = _e408;
                    }
                    let _e412 = phi_640_;
                    if _e404 {
                        phi_651_ = _e376[0];
                    } else {
                        phi_651_ = _e376[1];
                    }
                    let _e416 = phi_651_;
                    if _e409 {
                        phi_657_ = _e376[2];
                    } else {
                        phi_657_ = _e416;
                    }
                    let _e419 = phi_657_;
                    let _e421 = ((_e419 * _e355) * _e361);
                    let _e425 = (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e425 {
                        let _e429 = (bitcast<f32>((bitcast<u32>(_e412) & 2147483647u)) * 0.00000011920929f);
                        phi_680_ = select(0.00000000000011368684f, _e429, (_e429 > 0.00000000000011368684f));
                    } else {
                        phi_680_ = 0f;
                    }
                    let _e433 = phi_680_;
                    let _e434 = (_e412 + _e433);
                    let _e435 = (_e412 - _e433);
                    let _e436 = select(_e421, 0f, _e425);
                    if _e425 {
                        phi_691_ = 38685626000000000000000000f;
                    } else {
                        phi_691_ = (1f / _e421);
                    }
                    let _e439 = phi_691_;
                    let _e440 = (_e348 == 0u);
                    if _e440 {
                        phi_700_ = _e366[0];
                    } else {
                        phi_700_ = _e366[1];
                    }
                    let _e444 = phi_700_;
                    let _e445 = (_e348 == 2u);
                    if _e445 {
                        phi_706_ = _e366[2];
                    } else {
                        phi_706_ = _e444;
                    }
                    let _e448 = phi_706_;
                    if _e440 {
                        phi_717_ = _e376[0];
                    } else {
                        phi_717_ = _e376[1];
                    }
                    let _e452 = phi_717_;
                    if _e445 {
                        phi_723_ = _e376[2];
                    } else {
                        phi_723_ = _e452;
                    }
                    let _e455 = phi_723_;
                    let _e457 = ((_e455 * _e355) * _e361);
                    let _e461 = (bitcast<f32>((bitcast<u32>(_e457) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e461 {
                        let _e465 = (bitcast<f32>((bitcast<u32>(_e448) & 2147483647u)) * 0.00000011920929f);
                        phi_746_ = select(0.00000000000011368684f, _e465, (_e465 > 0.00000000000011368684f));
                    } else {
                        phi_746_ = 0f;
                    }
                    let _e469 = phi_746_;
                    let _e470 = (_e448 + _e469);
                    let _e471 = (_e448 - _e469);
                    let _e472 = select(_e457, 0f, _e461);
                    if _e461 {
                        phi_757_ = 38685626000000000000000000f;
                    } else {
                        phi_757_ = (1f / _e457);
                    }
                    let _e475 = phi_757_;
                    let _e478 = bitcast<f32>((bitcast<u32>(_e375) & 2147483647u));
                    let _e481 = bitcast<f32>((bitcast<u32>(_e412) & 2147483647u));
                    let _e483 = select(_e481, _e478, (_e478 > _e481));
                    let _e486 = bitcast<f32>((bitcast<u32>(_e448) & 2147483647u));
                    if (_e309 && (select(_e486, _e483, (_e483 > _e486)) <= 1099511600000f)) {
                        let _e491 = (_e328 / 3i);
                        let _e498 = bitcast<f32>((bitcast<u32>((_e491 + 127i)) << bitcast<u32>(23i)));
                        let _e505 = bitcast<f32>((bitcast<u32>(((_e328 - (2i * _e491)) + 127i)) << bitcast<u32>(23i)));
                        let _e506 = (((_e293 * _e498) * _e498) * _e505);
                        let _e508 = select(340282350000000000000000000000000000000f, _e506, (_e506 < 340282350000000000000000000000000000000f));
                        let _e513 = (((_e303 * _e498) * _e498) * _e505);
                        let _e515 = select(340282350000000000000000000000000000000f, _e513, (_e513 < 340282350000000000000000000000000000000f));
                        phi_857_ = select(-340282350000000000000000000000000000000f, _e515, (_e515 > -340282350000000000000000000000000000000f));
                        phi_858_ = select(-340282350000000000000000000000000000000f, _e508, (_e508 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_857_ = 0f;
                        phi_858_ = 1f;
                    }
                    let _e519 = phi_857_;
                    let _e521 = phi_858_;
                    local_3 = array<type_60, 128>(type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e525 = (_e347 % 3u);
                    let _e526 = (_e525 < 3u);
                    if _e526 {
                    } else {
                        break;
                    }
                    let _e528 = local_1[_e525];
                    let _e531 = (_e346 % 3u);
                    let _e532 = (_e531 < 3u);
                    if _e532 {
                    } else {
                        break;
                    }
                    let _e534 = local_1[_e531];
                    let _e537 = (_e348 % 3u);
                    let _e538 = (_e537 < 3u);
                    if _e538 {
                    } else {
                        break;
                    }
                    let _e540 = local_1[_e537];
                    if _e526 {
                    } else {
                        break;
                    }
                    let _e545 = local[_e525];
                    if _e532 {
                    } else {
                        break;
                    }
                    let _e549 = local[_e531];
                    if _e538 {
                    } else {
                        break;
                    }
                    let _e553 = local[_e537];
                    phi_4758_ = false;
                    phi_1978_ = type_45(type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e519);
                    phi_1981_ = type_60(type_41(vec4<f32>((f32(_e528) * _e148), (f32(_e534) * _e148), (f32(_e540) * _e148), 0f), vec4<f32>((f32(_e545) * _e148), (f32(_e549) * _e148), (f32(_e553) * _e148), 0f)), select(0u, 2147483648u, (_e90 == 0u)));
                    phi_1983_ = ((3u * _e90) + 1u);
                    phi_1985_ = (_e521 <= _e519);
                    phi_1987_ = 0u;
                    loop {
                        let _e563 = phi_4758_;
                        let _e565 = phi_1978_;
                        let _e567 = phi_1981_;
                        let _e569 = phi_1983_;
                        let _e571 = phi_1985_;
                        let _e573 = phi_1987_;
                        local_4 = _e565;
                        if _e571 {
                            phi_1998_ = true;
                        } else {
                            phi_1998_ = (_e573 > 0u);
                        }
                        let _e576 = phi_1998_;
                        if _e576 {
                            let _e577 = (_e569 > 0u);
                            if _e577 {
                                if _e571 {
                                    phi_2035_ = _e567;
                                    phi_2036_ = _e571;
                                    phi_2037_ = _e573;
                                } else {
                                    let _e578 = (_e573 - 1u);
                                    let _e579 = (_e578 % 128u);
                                    let _e580 = (_e579 < 128u);
                                    if _e580 {
                                    } else {
                                        phi_4884_ = true;
                                        break;
                                    }
                                    let _e582 = local_3[_e579];
                                    if _e580 {
                                    } else {
                                        phi_4884_ = true;
                                        break;
                                    }
                                    let _e590 = local_2[_e579];
                                    phi_2035_ = type_60(type_41(_e582.member.member, _e582.member.member_1), _e582.member_1);
                                    phi_2036_ = (_e590 <= _e565.member_1);
                                    phi_2037_ = _e578;
                                }
                                let _e594 = phi_2035_;
                                let _e596 = phi_2036_;
                                let _e598 = phi_2037_;
                                if _e596 {
                                    if ((_e594.member_1 & 2147483648u) != 0u) {
                                        phi_2055_ = _e565;
                                        phi_2058_ = type_8(0u, ((_e594.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1044 = phi_2055_;
                                            let _e1046 = phi_2058_;
                                            local_5 = _e1044;
                                            if (_e1046.member < _e1046.member_1) {
                                                phi_2059_ = type_8((_e1046.member + 1u), _e1046.member_1);
                                                phi_2081_ = type_8(1u, _e1046.member);
                                            } else {
                                                phi_2059_ = _e1046;
                                                phi_2081_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1059 = phi_2059_;
                                            let _e1061 = phi_2081_;
                                            let _e1065 = (bitcast<i32>(_e1061.member) != 0i);
                                            if _e1065 {
                                                let _e1066 = ((_e594.member_1 & 268435455u) + _e1061.member_1);
                                                let _e1067 = (_e1066 < _e92);
                                                if _e1067 {
                                                    if _e1067 {
                                                    } else {
                                                        phi_4752_ = true;
                                                        break;
                                                    }
                                                    let _e1071 = global_5.member[_e1066].member_1;
                                                    phi_2102_ = _e1071;
                                                } else {
                                                    phi_2102_ = 4294967295u;
                                                }
                                                let _e1073 = phi_2102_;
                                                if (_e1066 >= _e92) {
                                                    phi_2191_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1067 {
                                                    } else {
                                                        phi_4752_ = true;
                                                        break;
                                                    }
                                                    if (_e525 < 9u) {
                                                    } else {
                                                        phi_4752_ = true;
                                                        break;
                                                    }
                                                    let _e1080 = global_5.member[_e1066].member[_e525];
                                                    if (_e531 < 9u) {
                                                    } else {
                                                        phi_4752_ = true;
                                                        break;
                                                    }
                                                    let _e1086 = global_5.member[_e1066].member[_e531];
                                                    if (_e537 < 9u) {
                                                    } else {
                                                        phi_4752_ = true;
                                                        break;
                                                    }
                                                    let _e1092 = global_5.member[_e1066].member[_e537];
                                                    let _e1094 = (3u + _e525);
                                                    if (_e1094 < 9u) {
                                                    } else {
                                                        phi_4752_ = true;
                                                        break;
                                                    }
                                                    let _e1100 = global_5.member[_e1066].member[_e1094];
                                                    let _e1101 = (3u + _e531);
                                                    if (_e1101 < 9u) {
                                                    } else {
                                                        phi_4752_ = true;
                                                        break;
                                                    }
                                                    let _e1107 = global_5.member[_e1066].member[_e1101];
                                                    let _e1108 = (3u + _e537);
                                                    if (_e1108 < 9u) {
                                                    } else {
                                                        phi_4752_ = true;
                                                        break;
                                                    }
                                                    let _e1114 = global_5.member[_e1066].member[_e1108];
                                                    let _e1116 = (6u + _e525);
                                                    if (_e1116 < 9u) {
                                                    } else {
                                                        phi_4752_ = true;
                                                        break;
                                                    }
                                                    let _e1122 = global_5.member[_e1066].member[_e1116];
                                                    let _e1123 = (6u + _e531);
                                                    if (_e1123 < 9u) {
                                                    } else {
                                                        phi_4752_ = true;
                                                        break;
                                                    }
                                                    let _e1129 = global_5.member[_e1066].member[_e1123];
                                                    let _e1130 = (6u + _e537);
                                                    if (_e1130 < 9u) {
                                                    } else {
                                                        phi_4752_ = true;
                                                        break;
                                                    }
                                                    let _e1136 = global_5.member[_e1066].member[_e1130];
                                                    phi_2191_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1080, _e1086, _e1092), array<f32, 3>(_e1100, _e1107, _e1114), array<f32, 3>(_e1122, _e1129, _e1136));
                                                }
                                                let _e1140 = phi_2191_;
                                                let _e1148 = (_e1140[0][2] - _e448);
                                                let _e1151 = (((_e1140[0][0] - _e375) * _e472) - (_e1148 * _e400));
                                                let _e1154 = (((_e1140[0][1] - _e412) * _e472) - (_e1148 * _e436));
                                                let _e1161 = (_e1140[1][2] - _e448);
                                                let _e1164 = (((_e1140[1][0] - _e375) * _e472) - (_e1161 * _e400));
                                                let _e1167 = (((_e1140[1][1] - _e412) * _e472) - (_e1161 * _e436));
                                                let _e1174 = (_e1140[2][2] - _e448);
                                                let _e1177 = (((_e1140[2][0] - _e375) * _e472) - (_e1174 * _e400));
                                                let _e1180 = (((_e1140[2][1] - _e412) * _e472) - (_e1174 * _e436));
                                                let _e1181 = (_e1177 * _e1167);
                                                let _e1182 = (_e1180 * _e1164);
                                                let _e1183 = (_e1151 * _e1180);
                                                let _e1184 = (_e1154 * _e1177);
                                                let _e1185 = (_e1164 * _e1154);
                                                let _e1186 = (_e1167 * _e1151);
                                                let _e1191 = (((_e1181 >= _e1182) && (_e1183 >= _e1184)) && (_e1185 >= _e1186));
                                                if (_e1191 || (((_e1181 <= _e1182) && (_e1183 <= _e1184)) && (_e1185 <= _e1186))) {
                                                    let _e1198 = select(-1f, 1f, _e1191);
                                                    let _e1200 = ((_e1181 - _e1182) * _e1198);
                                                    let _e1202 = select(0f, _e1200, (_e1200 > 0f));
                                                    let _e1204 = ((_e1183 - _e1184) * _e1198);
                                                    let _e1206 = select(0f, _e1204, (_e1204 > 0f));
                                                    let _e1208 = ((_e1185 - _e1186) * _e1198);
                                                    let _e1210 = select(0f, _e1208, (_e1208 > 0f));
                                                    let _e1212 = ((_e1202 + _e1206) + _e1210);
                                                    if (_e1212 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2757_ = type_29();
                                                        phi_2758_ = true;
                                                    } else {
                                                        let _e1215 = select(_e1140[1][0], _e1140[0][0], (_e1140[0][0] < _e1140[1][0]));
                                                        let _e1219 = select(_e1140[1][0], _e1140[0][0], (_e1140[0][0] > _e1140[1][0]));
                                                        let _e1223 = select(_e1140[1][1], _e1140[0][1], (_e1140[0][1] < _e1140[1][1]));
                                                        let _e1227 = select(_e1140[1][1], _e1140[0][1], (_e1140[0][1] > _e1140[1][1]));
                                                        let _e1231 = select(_e1140[1][2], _e1140[0][2], (_e1140[0][2] < _e1140[1][2]));
                                                        let _e1235 = select(_e1140[1][2], _e1140[0][2], (_e1140[0][2] > _e1140[1][2]));
                                                        let _e1240 = ((select(_e1140[2][0], _e1215, (_e1215 < _e1140[2][0])) - _e398) * _e403);
                                                        let _e1241 = ((select(_e1140[2][0], _e1219, (_e1219 > _e1140[2][0])) - _e399) * _e403);
                                                        let _e1244 = ((select(_e1140[2][1], _e1223, (_e1223 < _e1140[2][1])) - _e434) * _e439);
                                                        let _e1245 = ((select(_e1140[2][1], _e1227, (_e1227 > _e1140[2][1])) - _e435) * _e439);
                                                        let _e1248 = ((select(_e1140[2][2], _e1231, (_e1231 < _e1140[2][2])) - _e470) * _e475);
                                                        let _e1249 = ((select(_e1140[2][2], _e1235, (_e1235 > _e1140[2][2])) - _e471) * _e475);
                                                        let _e1251 = select(_e1249, _e1248, (_e1248 < _e1249));
                                                        let _e1253 = select(_e1249, _e1248, (_e1248 > _e1249));
                                                        let _e1255 = select(_e1241, _e1240, (_e1240 < _e1241));
                                                        let _e1257 = select(_e1245, _e1244, (_e1244 < _e1245));
                                                        let _e1259 = select(_e1257, _e1255, (_e1255 > _e1257));
                                                        let _e1261 = select(_e1251, _e1259, (_e1259 > _e1251));
                                                        let _e1263 = select(_e1241, _e1240, (_e1240 > _e1241));
                                                        let _e1265 = select(_e1245, _e1244, (_e1244 > _e1245));
                                                        let _e1267 = select(_e1265, _e1263, (_e1263 < _e1265));
                                                        let _e1269 = select(_e1253, _e1267, (_e1267 < _e1253));
                                                        let _e1270 = -(_e1251);
                                                        let _e1276 = select(_e521, _e1261, (_e1261 > _e521));
                                                        if (_e1276 > (_e1269 + (select(_e1270, _e1253, (_e1253 > _e1270)) * 0.0000019073523f))) {
                                                            phi_2752_ = type_29();
                                                            phi_2753_ = true;
                                                        } else {
                                                            let _e1278 = (_e1276 > _e1044.member_1);
                                                            if _e1278 {
                                                                phi_2751_ = type_29();
                                                            } else {
                                                                let _e1282 = (_e1140[1][0] - _e1140[0][0]);
                                                                let _e1283 = (_e1140[1][1] - _e1140[0][1]);
                                                                let _e1284 = (_e1140[1][2] - _e1140[0][2]);
                                                                let _e1285 = vec3<f32>(_e1282, _e1283, _e1284);
                                                                let _e1286 = (_e1140[2][0] - _e1140[1][0]);
                                                                let _e1287 = (_e1140[2][1] - _e1140[1][1]);
                                                                let _e1288 = (_e1140[2][2] - _e1140[1][2]);
                                                                let _e1289 = vec3<f32>(_e1286, _e1287, _e1288);
                                                                let _e1290 = (_e1140[0][0] - _e1140[2][0]);
                                                                let _e1291 = (_e1140[0][1] - _e1140[2][1]);
                                                                let _e1292 = (_e1140[0][2] - _e1140[2][2]);
                                                                let _e1293 = vec3<f32>(_e1290, _e1291, _e1292);
                                                                let _e1296 = bitcast<f32>((bitcast<u32>(_e1282) & 2147483647u));
                                                                let _e1299 = bitcast<f32>((bitcast<u32>(_e1283) & 2147483647u));
                                                                let _e1301 = select(_e1299, _e1296, (_e1296 > _e1299));
                                                                let _e1304 = bitcast<f32>((bitcast<u32>(_e1284) & 2147483647u));
                                                                let _e1306 = select(_e1304, _e1301, (_e1301 > _e1304));
                                                                let _e1309 = bitcast<f32>((bitcast<u32>(_e1286) & 2147483647u));
                                                                let _e1312 = bitcast<f32>((bitcast<u32>(_e1287) & 2147483647u));
                                                                let _e1314 = select(_e1312, _e1309, (_e1309 > _e1312));
                                                                let _e1317 = bitcast<f32>((bitcast<u32>(_e1288) & 2147483647u));
                                                                let _e1319 = select(_e1317, _e1314, (_e1314 > _e1317));
                                                                let _e1322 = bitcast<f32>((bitcast<u32>(_e1290) & 2147483647u));
                                                                let _e1325 = bitcast<f32>((bitcast<u32>(_e1291) & 2147483647u));
                                                                let _e1327 = select(_e1325, _e1322, (_e1322 > _e1325));
                                                                let _e1330 = bitcast<f32>((bitcast<u32>(_e1292) & 2147483647u));
                                                                let _e1332 = select(_e1330, _e1327, (_e1327 > _e1330));
                                                                let _e1334 = select(_e1319, _e1306, (_e1306 > _e1319));
                                                                let _e1336 = select(_e1332, _e1334, (_e1334 > _e1332));
                                                                if (_e1306 == _e1336) {
                                                                    phi_2662_ = _e1289;
                                                                    phi_2663_ = _e1293;
                                                                } else {
                                                                    let _e1339 = vec3((_e1319 == _e1336));
                                                                    phi_2662_ = select(_e1285, _e1293, _e1339);
                                                                    phi_2663_ = select(_e1289, _e1285, _e1339);
                                                                }
                                                                let _e1343 = phi_2662_;
                                                                let _e1345 = phi_2663_;
                                                                let _e1352 = ((_e1343.y * _e1345.z) - (_e1345.y * _e1343.z));
                                                                let _e1357 = ((_e1343.z * _e1345.x) - (_e1345.z * _e1343.x));
                                                                let _e1360 = ((_e1343.x * _e1345.y) - (_e1345.x * _e1343.y));
                                                                if (_e1202 >= _e1206) {
                                                                    phi_2694_ = select(true, false, (_e1202 >= _e1210));
                                                                } else {
                                                                    phi_2694_ = true;
                                                                }
                                                                let _e1365 = phi_2694_;
                                                                if _e1365 {
                                                                    phi_2703_ = select(vec3<f32>(_e1140[2][0], _e1140[2][1], _e1140[2][2]), vec3<f32>(_e1140[1][0], _e1140[1][1], _e1140[1][2]), vec3((_e1206 >= _e1210)));
                                                                } else {
                                                                    phi_2703_ = vec3<f32>(_e1140[0][0], _e1140[0][1], _e1140[0][2]);
                                                                }
                                                                let _e1370 = phi_2703_;
                                                                let _e1387 = ((((_e1352 * (_e1370.x - _e375)) + (_e1357 * (_e1370.y - _e412))) + (_e1360 * (_e1370.z - _e448))) / (((_e1352 * _e400) + (_e1357 * _e436)) + (_e1360 * _e472)));
                                                                let _e1389 = select(_e1269, _e1387, (_e1387 < _e1269));
                                                                let _e1391 = select(_e1261, _e1389, (_e1389 > _e1261));
                                                                if (_e1391 >= _e521) {
                                                                    let _e1393 = (_e1391 <= _e1044.member_1);
                                                                    if _e1393 {
                                                                        let _e1394 = (1f / _e1212);
                                                                        phi_2743_ = type_29(_e1391, (_e1206 * _e1394), (_e1210 * _e1394), _e1073);
                                                                    } else {
                                                                        phi_2743_ = type_29();
                                                                    }
                                                                    let _e1399 = phi_2743_;
                                                                    phi_2745_ = _e1399;
                                                                    phi_2746_ = select(true, false, _e1393);
                                                                } else {
                                                                    phi_2745_ = type_29();
                                                                    phi_2746_ = true;
                                                                }
                                                                let _e1402 = phi_2745_;
                                                                let _e1404 = phi_2746_;
                                                                if _e1404 {
                                                                    phi_2750_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2750_ = _e1402;
                                                                }
                                                                let _e1406 = phi_2750_;
                                                                phi_2751_ = _e1406;
                                                            }
                                                            let _e1408 = phi_2751_;
                                                            phi_2752_ = _e1408;
                                                            phi_2753_ = _e1278;
                                                        }
                                                        let _e1410 = phi_2752_;
                                                        let _e1412 = phi_2753_;
                                                        phi_2757_ = _e1410;
                                                        phi_2758_ = _e1412;
                                                    }
                                                    let _e1414 = phi_2757_;
                                                    let _e1416 = phi_2758_;
                                                    phi_2762_ = _e1414;
                                                    phi_2763_ = _e1416;
                                                } else {
                                                    phi_2762_ = type_29();
                                                    phi_2763_ = true;
                                                }
                                                let _e1418 = phi_2762_;
                                                let _e1420 = phi_2763_;
                                                if _e1420 {
                                                    phi_2767_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2767_ = _e1418;
                                                }
                                                let _e1422 = phi_2767_;
                                                if (_e1422.member_3 != 4294967295u) {
                                                    if (_e1073 == _e157) {
                                                        phi_3096_ = false;
                                                    } else {
                                                        let _e1426 = (_e1073 < arrayLength((&global_6.member)));
                                                        if _e1426 {
                                                            if _e1426 {
                                                            } else {
                                                                phi_4752_ = true;
                                                                break;
                                                            }
                                                            let _e1428 = global_6.member[_e1073];
                                                            phi_2790_ = _e1428;
                                                        } else {
                                                            phi_2790_ = 4294967295u;
                                                        }
                                                        let _e1430 = phi_2790_;
                                                        let _e1431 = (_e1430 < arrayLength((&global_7.member)));
                                                        if _e1431 {
                                                            if _e1431 {
                                                            } else {
                                                                phi_4752_ = true;
                                                                break;
                                                            }
                                                            let _e1433 = global_7.member[_e1430];
                                                            phi_2804_ = _e1433;
                                                        } else {
                                                            phi_2804_ = 0i;
                                                        }
                                                        let _e1435 = phi_2804_;
                                                        let _e1436 = (_e1435 == 0i);
                                                        if _e1436 {
                                                            phi_3095_ = true;
                                                        } else {
                                                            if _e367 {
                                                                phi_2825_ = vec3<f32>(_e1140[0][0], _e1140[0][1], _e1140[0][2]);
                                                            } else {
                                                                if (_e347 == 1u) {
                                                                    phi_2824_ = vec3<f32>(_e1140[0][2], _e1140[0][0], _e1140[0][1]);
                                                                } else {
                                                                    phi_2824_ = vec3<f32>(_e1140[0][1], _e1140[0][2], _e1140[0][0]);
                                                                }
                                                                let _e1441 = phi_2824_;
                                                                phi_2825_ = _e1441;
                                                            }
                                                            let _e1444 = phi_2825_;
                                                            if _e367 {
                                                                phi_2842_ = vec3<f32>(_e1140[1][0], _e1140[1][1], _e1140[1][2]);
                                                            } else {
                                                                if (_e347 == 1u) {
                                                                    phi_2841_ = vec3<f32>(_e1140[1][2], _e1140[1][0], _e1140[1][1]);
                                                                } else {
                                                                    phi_2841_ = vec3<f32>(_e1140[1][1], _e1140[1][2], _e1140[1][0]);
                                                                }
                                                                let _e1449 = phi_2841_;
                                                                phi_2842_ = _e1449;
                                                            }
                                                            let _e1452 = phi_2842_;
                                                            if _e367 {
                                                                phi_2859_ = vec3<f32>(_e1140[2][0], _e1140[2][1], _e1140[2][2]);
                                                            } else {
                                                                if (_e347 == 1u) {
                                                                    phi_2858_ = vec3<f32>(_e1140[2][2], _e1140[2][0], _e1140[2][1]);
                                                                } else {
                                                                    phi_2858_ = vec3<f32>(_e1140[2][1], _e1140[2][2], _e1140[2][0]);
                                                                }
                                                                let _e1457 = phi_2858_;
                                                                phi_2859_ = _e1457;
                                                            }
                                                            let _e1460 = phi_2859_;
                                                            let _e1463 = (_e1452.x - _e1444.x);
                                                            let _e1466 = (_e1452.y - _e1444.y);
                                                            let _e1469 = (_e1452.z - _e1444.z);
                                                            let _e1471 = (_e1460.x - _e1444.x);
                                                            let _e1473 = (_e1460.y - _e1444.y);
                                                            let _e1475 = (_e1460.z - _e1444.z);
                                                            if (_e225.member_1 == 1u) {
                                                                phi_2895_ = (vec3<f32>(_e225.member[0], _e225.member[1], _e225.member[2]) - _e1444);
                                                            } else {
                                                                phi_2895_ = vec3<f32>(_e225.member[0], _e225.member[1], _e225.member[2]);
                                                            }
                                                            let _e1490 = phi_2895_;
                                                            let _e1496 = bitcast<f32>((bitcast<u32>((_e1463 * _e1473)) ^ _e225.member_3[0]));
                                                            let _e1500 = bitcast<f32>((bitcast<u32>((_e1466 * _e1471)) ^ _e225.member_3[0]));
                                                            let _e1504 = bitcast<f32>((bitcast<u32>((_e1466 * _e1475)) ^ _e225.member_3[0]));
                                                            let _e1508 = bitcast<f32>((bitcast<u32>((_e1469 * _e1473)) ^ _e225.member_3[0]));
                                                            let _e1512 = bitcast<f32>((bitcast<u32>((_e1469 * _e1471)) ^ _e225.member_3[0]));
                                                            let _e1516 = bitcast<f32>((bitcast<u32>((_e1463 * _e1475)) ^ _e225.member_3[0]));
                                                            let _e1517 = (_e1504 - _e1508);
                                                            let _e1518 = (_e1512 - _e1516);
                                                            let _e1519 = (_e1496 - _e1500);
                                                            let _e1543 = (bitcast<f32>((bitcast<u32>(_e1504) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1508) & 2147483647u)));
                                                            let _e1550 = (bitcast<f32>((bitcast<u32>(_e1512) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1516) & 2147483647u)));
                                                            let _e1557 = (bitcast<f32>((bitcast<u32>(_e1496) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1500) & 2147483647u)));
                                                            if (_e225.member_2 == 0f) {
                                                                phi_3077_ = 0f;
                                                            } else {
                                                                let _e1587 = bitcast<f32>((bitcast<u32>(_e1517) & 2147483647u));
                                                                let _e1590 = bitcast<f32>((bitcast<u32>(_e1518) & 2147483647u));
                                                                let _e1593 = bitcast<f32>((bitcast<u32>(_e1519) & 2147483647u));
                                                                let _e1595 = select(_e1593, _e1590, (_e1590 > _e1593));
                                                                let _e1599 = select(_e1593, _e1590, (_e1590 < _e1593));
                                                                let _e1603 = select(_e1590, _e1587, (_e1587 < _e1590));
                                                                let _e1605 = select(_e1590, _e1587, (_e1587 > _e1590));
                                                                let _e1607 = select(_e1593, _e1605, (_e1605 < _e1593));
                                                                phi_3077_ = bitcast<f32>((bitcast<u32>((_e225.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1595, _e1587, (_e1587 > _e1595)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1607, _e1603, (_e1603 > _e1607)))) ^ _e225.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1599, _e1587, (_e1587 < _e1599)))) ^ _e225.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1543 + _e1550) + _e1557))) ^ _e225.member_3[0]))) * 1.0000005f)) ^ _e225.member_3[0])))) ^ _e225.member_3[0]));
                                                            }
                                                            let _e1634 = phi_3077_;
                                                            phi_3095_ = (_e1436 || !(((((bitcast<f32>((bitcast<u32>((_e1490.x * _e1517)) ^ _e225.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1490.y * _e1518)) ^ _e225.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1490.z * _e1519)) ^ _e225.member_3[0]))) * f32(-(_e1435))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1490.x) & 2147483647u)) * _e1543)) ^ _e225.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1490.y) & 2147483647u)) * _e1550)) ^ _e225.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1490.z) & 2147483647u)) * _e1557)) ^ _e225.member_3[0]))))) ^ _e225.member_3[0])) + _e1634) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1648 = phi_3095_;
                                                        phi_3096_ = _e1648;
                                                    }
                                                    let _e1650 = phi_3096_;
                                                    if _e1650 {
                                                        if (_e1422.member < _e1044.member.member) {
                                                            phi_3116_ = true;
                                                        } else {
                                                            if (_e1422.member == _e1044.member.member) {
                                                                phi_3115_ = (_e1422.member_3 < _e1044.member.member_3);
                                                            } else {
                                                                phi_3115_ = false;
                                                            }
                                                            let _e1660 = phi_3115_;
                                                            phi_3116_ = _e1660;
                                                        }
                                                        let _e1662 = phi_3116_;
                                                        if _e1662 {
                                                            phi_3122_ = type_45(_e1422, _e1422.member);
                                                        } else {
                                                            phi_3122_ = _e1044;
                                                        }
                                                        let _e1665 = phi_3122_;
                                                        phi_3123_ = _e1665;
                                                    } else {
                                                        phi_3123_ = _e1044;
                                                    }
                                                    let _e1667 = phi_3123_;
                                                    phi_3124_ = _e1667;
                                                } else {
                                                    phi_3124_ = _e1044;
                                                }
                                                let _e1669 = phi_3124_;
                                                phi_2056_ = _e1669;
                                            } else {
                                                phi_2056_ = type_45();
                                            }
                                            let _e1671 = phi_2056_;
                                            continue;
                                            continuing {
                                                phi_2055_ = _e1671;
                                                phi_2058_ = _e1059;
                                                phi_4752_ = _e563;
                                                break if !(_e1065);
                                            }
                                        }
                                        let _e1674 = phi_4752_;
                                        phi_4884_ = _e1674;
                                        if _e1674 {
                                            break;
                                        }
                                        phi_4888_ = _e1674;
                                        let _e1887 = local_5;
                                        phi_4427_ = _e1887;
                                        phi_4428_ = _e594;
                                        phi_4429_ = false;
                                        phi_4430_ = _e598;
                                    } else {
                                        if (_e594.member_1 >= _e90) {
                                            phi_4027_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_60(type_41(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e594.member_1 < _e90) {
                                            } else {
                                                phi_4884_ = true;
                                                break;
                                            }
                                            let _e610 = ((1u + _e347) % 4u);
                                            if (_e610 < 4u) {
                                            } else {
                                                phi_4884_ = true;
                                                break;
                                            }
                                            let _e615 = global_4.member[_e594.member_1][_e610];
                                            let _e617 = ((1u + _e346) % 4u);
                                            if (_e617 < 4u) {
                                            } else {
                                                phi_4884_ = true;
                                                break;
                                            }
                                            let _e622 = global_4.member[_e594.member_1][_e617];
                                            let _e624 = ((1u + _e348) % 4u);
                                            if (_e624 < 4u) {
                                            } else {
                                                phi_4884_ = true;
                                                break;
                                            }
                                            let _e629 = global_4.member[_e594.member_1][_e624];
                                            let _e631 = ((_e347 + 1u) % 4u);
                                            if (_e631 < 4u) {
                                            } else {
                                                phi_4884_ = true;
                                                break;
                                            }
                                            let _e636 = global_4.member[_e594.member_1][_e631];
                                            let _e638 = (_e636 >> bitcast<u32>(11u));
                                            let _e640 = ((_e346 + 1u) % 4u);
                                            if (_e640 < 4u) {
                                            } else {
                                                phi_4884_ = true;
                                                break;
                                            }
                                            let _e645 = global_4.member[_e594.member_1][_e640];
                                            let _e647 = (_e645 >> bitcast<u32>(11u));
                                            let _e649 = ((_e348 + 1u) % 4u);
                                            if (_e649 < 4u) {
                                            } else {
                                                phi_4884_ = true;
                                                break;
                                            }
                                            let _e654 = global_4.member[_e594.member_1][_e649];
                                            let _e656 = (_e654 >> bitcast<u32>(11u));
                                            let _e679 = (bitcast<f32>((bitcast<u32>((_e594.member.member_1.x - _e594.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e680 = (bitcast<f32>((bitcast<u32>((_e594.member.member_1.y - _e594.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e681 = (bitcast<f32>((bitcast<u32>((_e594.member.member_1.z - _e594.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e683 = select(_e148, _e679, (_e679 > _e148));
                                            let _e685 = select(_e148, _e680, (_e680 > _e148));
                                            let _e687 = select(_e148, _e681, (_e681 > _e148));
                                            let _e712 = bitcast<u32>((f32(bitcast<i32>((_e615 & 1023u))) * _e683));
                                            let _e717 = (bitcast<i32>((_e615 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e720 = bitcast<f32>((_e712 & bitcast<u32>(_e717)));
                                            let _e721 = bitcast<u32>((f32(bitcast<i32>((_e622 & 1023u))) * _e685));
                                            let _e726 = (bitcast<i32>((_e622 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e729 = bitcast<f32>((_e721 & bitcast<u32>(_e726)));
                                            let _e730 = bitcast<u32>((f32(bitcast<i32>((_e629 & 1023u))) * _e687));
                                            let _e735 = (bitcast<i32>((_e629 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e738 = bitcast<f32>((_e730 & bitcast<u32>(_e735)));
                                            let _e742 = bitcast<f32>((_e712 & bitcast<u32>(~(_e717))));
                                            let _e746 = bitcast<f32>((_e721 & bitcast<u32>(~(_e726))));
                                            let _e750 = bitcast<f32>((_e730 & bitcast<u32>(~(_e735))));
                                            let _e751 = bitcast<u32>((f32(bitcast<i32>((_e638 & 1023u))) * _e683));
                                            let _e756 = (bitcast<i32>((_e638 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e759 = bitcast<f32>((_e751 & bitcast<u32>(_e756)));
                                            let _e760 = bitcast<u32>((f32(bitcast<i32>((_e647 & 1023u))) * _e685));
                                            let _e765 = (bitcast<i32>((_e647 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e768 = bitcast<f32>((_e760 & bitcast<u32>(_e765)));
                                            let _e769 = bitcast<u32>((f32(bitcast<i32>((_e656 & 1023u))) * _e687));
                                            let _e774 = (bitcast<i32>((_e656 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e777 = bitcast<f32>((_e769 & bitcast<u32>(_e774)));
                                            let _e781 = bitcast<f32>((_e751 & bitcast<u32>(~(_e756))));
                                            let _e785 = bitcast<f32>((_e760 & bitcast<u32>(~(_e765))));
                                            let _e789 = bitcast<f32>((_e769 & bitcast<u32>(~(_e774))));
                                            let _e819 = global_4.member[_e594.member_1][0u];
                                            let _e823 = global_4.member[_e594.member_1][1u];
                                            let _e827 = global_4.member[_e594.member_1][2u];
                                            let _e831 = global_4.member[_e594.member_1][3u];
                                            let _e843 = (((_e823 >> bitcast<u32>(22i)) | ((_e827 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e831 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e844 = (_e819 & 268435455u);
                                            let _e845 = (_e843 & 268435455u);
                                            let _e848 = ((_e819 >> bitcast<u32>(28u)) & 7u);
                                            let _e856 = ((_e819 >> bitcast<u32>(31i)) | (((_e843 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e857 = (_e848 != 0u);
                                            if (_e848 == 0u) {
                                                phi_3989_ = _e844;
                                            } else {
                                                if (_e848 == 7u) {
                                                    phi_3988_ = 2147483648u;
                                                } else {
                                                    phi_3988_ = ((2147483648u | (_e848 << bitcast<u32>(28u))) | (_e845 & 268435455u));
                                                }
                                                let _e866 = phi_3988_;
                                                phi_3989_ = _e866;
                                            }
                                            let _e868 = phi_3989_;
                                            if _e857 {
                                                let _e869 = (_e848 != 7u);
                                                if _e869 {
                                                    phi_3999_ = (_e845 + _e848);
                                                } else {
                                                    phi_3999_ = u32();
                                                }
                                                let _e872 = phi_3999_;
                                                phi_4001_ = _e872;
                                                phi_4002_ = select(true, false, _e869);
                                            } else {
                                                phi_4001_ = u32();
                                                phi_4002_ = true;
                                            }
                                            let _e875 = phi_4001_;
                                            let _e877 = phi_4002_;
                                            if (_e856 == 0u) {
                                                phi_4023_ = (_e844 + select(0u, 1u, !(_e857)));
                                            } else {
                                                if (_e856 == 7u) {
                                                    phi_4022_ = 2147483648u;
                                                } else {
                                                    phi_4022_ = ((2147483648u | (_e856 << bitcast<u32>(28u))) | (select(_e875, _e845, _e877) & 268435455u));
                                                }
                                                let _e890 = phi_4022_;
                                                phi_4023_ = _e890;
                                            }
                                            let _e892 = phi_4023_;
                                            phi_4027_ = type_63(array<vec4<f32>, 3>(vec4<f32>((_e594.member.member.x + _e720), (_e594.member.member.x + _e742), (_e594.member.member_1.x - _e759), (_e594.member.member_1.x - _e781)), vec4<f32>((_e594.member.member.y + _e729), (_e594.member.member.y + _e746), (_e594.member.member_1.y - _e768), (_e594.member.member_1.y - _e785)), vec4<f32>((_e594.member.member.z + _e738), (_e594.member.member.z + _e750), (_e594.member.member_1.z - _e777), (_e594.member.member_1.z - _e789))), type_60(type_41((_e594.member.member + vec4<f32>(_e720, _e729, _e738, 0f)), (_e594.member.member_1 - vec4<f32>(_e759, _e768, _e777, 0f))), _e868), type_60(type_41((_e594.member.member + vec4<f32>(_e742, _e746, _e750, 0f)), (_e594.member.member_1 - vec4<f32>(_e781, _e785, _e789, 0f))), _e892));
                                        }
                                        let _e897 = phi_4027_;
                                        let _e909 = ((_e897.member[0].x - _e398) * _e403);
                                        let _e910 = ((_e897.member[0].y - _e398) * _e403);
                                        let _e911 = ((_e897.member[0].z - _e399) * _e403);
                                        let _e912 = ((_e897.member[0].w - _e399) * _e403);
                                        let _e922 = ((_e897.member[1].x - _e434) * _e439);
                                        let _e923 = ((_e897.member[1].y - _e434) * _e439);
                                        let _e924 = ((_e897.member[1].z - _e435) * _e439);
                                        let _e925 = ((_e897.member[1].w - _e435) * _e439);
                                        let _e935 = ((_e897.member[2].x - _e470) * _e475);
                                        let _e936 = ((_e897.member[2].y - _e470) * _e475);
                                        let _e937 = ((_e897.member[2].z - _e471) * _e475);
                                        let _e938 = ((_e897.member[2].w - _e471) * _e475);
                                        let _e940 = select(_e937, _e935, (_e935 < _e937));
                                        let _e942 = select(_e938, _e936, (_e936 < _e938));
                                        let _e944 = select(_e937, _e935, (_e935 > _e937));
                                        let _e946 = select(_e938, _e936, (_e936 > _e938));
                                        let _e948 = select(_e911, _e909, (_e909 < _e911));
                                        let _e950 = select(_e912, _e910, (_e910 < _e912));
                                        let _e952 = select(_e924, _e922, (_e922 < _e924));
                                        let _e954 = select(_e925, _e923, (_e923 < _e925));
                                        let _e956 = select(_e952, _e948, (_e948 > _e952));
                                        let _e958 = select(_e954, _e950, (_e950 > _e954));
                                        let _e960 = select(_e940, _e956, (_e956 > _e940));
                                        let _e962 = select(_e942, _e958, (_e958 > _e942));
                                        let _e964 = select(_e911, _e909, (_e909 > _e911));
                                        let _e966 = select(_e912, _e910, (_e910 > _e912));
                                        let _e968 = select(_e924, _e922, (_e922 > _e924));
                                        let _e970 = select(_e925, _e923, (_e923 > _e925));
                                        let _e972 = select(_e968, _e964, (_e964 < _e968));
                                        let _e974 = select(_e970, _e966, (_e966 < _e970));
                                        let _e979 = -(_e940);
                                        let _e980 = -(_e942);
                                        let _e987 = (select(_e944, _e972, (_e972 < _e944)) + (select(_e979, _e944, (_e944 > _e979)) * 0.0000019073523f));
                                        let _e988 = (select(_e946, _e974, (_e974 < _e946)) + (select(_e980, _e946, (_e946 > _e980)) * 0.0000019073523f));
                                        let _e990 = select(_e521, _e960, (_e960 > _e521));
                                        let _e992 = select(_e521, _e962, (_e962 > _e521));
                                        let _e997 = (_e990 <= select(_e565.member_1, _e987, (_e987 < _e565.member_1)));
                                        let _e998 = (_e992 <= select(_e565.member_1, _e988, (_e988 < _e565.member_1)));
                                        let _e999 = (_e990 <= _e992);
                                        if _e997 {
                                            if _e998 {
                                                if _e999 {
                                                    phi_4371_ = _e897.member_2;
                                                } else {
                                                    phi_4371_ = _e897.member_1;
                                                }
                                                let _e1003 = phi_4371_;
                                                let _e1004 = (_e598 % 128u);
                                                let _e1005 = (_e1004 < 128u);
                                                if _e1005 {
                                                } else {
                                                    phi_4884_ = true;
                                                    break;
                                                }
                                                local_3[_e1004] = type_60(type_41(_e1003.member.member, _e1003.member.member_1), _e1003.member_1);
                                                if _e1005 {
                                                } else {
                                                    phi_4884_ = true;
                                                    break;
                                                }
                                                local_2[_e1004] = select(_e992, _e990, (_e990 > _e992));
                                                if _e999 {
                                                    phi_4404_ = _e897.member_1;
                                                } else {
                                                    phi_4404_ = _e897.member_2;
                                                }
                                                let _e1020 = phi_4404_;
                                                phi_4405_ = _e1020;
                                                phi_4406_ = (_e598 + 1u);
                                            } else {
                                                phi_4405_ = type_60();
                                                phi_4406_ = u32();
                                            }
                                            let _e1022 = phi_4405_;
                                            let _e1024 = phi_4406_;
                                            phi_4408_ = _e1022;
                                            phi_4409_ = _e1024;
                                            phi_4410_ = select(true, false, _e998);
                                        } else {
                                            phi_4408_ = type_60();
                                            phi_4409_ = u32();
                                            phi_4410_ = true;
                                        }
                                        let _e1027 = phi_4408_;
                                        let _e1029 = phi_4409_;
                                        let _e1031 = phi_4410_;
                                        if _e1031 {
                                            if _e997 {
                                                phi_4419_ = _e897.member_1;
                                            } else {
                                                phi_4419_ = _e897.member_2;
                                            }
                                            let _e1035 = phi_4419_;
                                            phi_4424_ = _e1035;
                                            phi_4425_ = select(_e998, true, _e997);
                                        } else {
                                            phi_4424_ = _e1027;
                                            phi_4425_ = _e596;
                                        }
                                        let _e1038 = phi_4424_;
                                        let _e1040 = phi_4425_;
                                        phi_4888_ = _e563;
                                        phi_4427_ = _e565;
                                        phi_4428_ = _e1038;
                                        phi_4429_ = _e1040;
                                        phi_4430_ = select(_e1029, _e598, _e1031);
                                    }
                                    let _e1676 = phi_4888_;
                                    let _e1678 = phi_4427_;
                                    let _e1680 = phi_4428_;
                                    let _e1682 = phi_4429_;
                                    let _e1684 = phi_4430_;
                                    phi_4887_ = _e1676;
                                    phi_4431_ = _e1678;
                                    phi_4432_ = _e1680;
                                    phi_4433_ = (_e569 - 1u);
                                    phi_4434_ = _e1682;
                                    phi_4435_ = _e1684;
                                } else {
                                    phi_4887_ = _e563;
                                    phi_4431_ = _e565;
                                    phi_4432_ = _e594;
                                    phi_4433_ = _e569;
                                    phi_4434_ = _e596;
                                    phi_4435_ = _e598;
                                }
                                let _e1686 = phi_4887_;
                                let _e1688 = phi_4431_;
                                let _e1690 = phi_4432_;
                                let _e1692 = phi_4433_;
                                let _e1694 = phi_4434_;
                                let _e1696 = phi_4435_;
                                phi_4886_ = _e1686;
                                phi_4436_ = _e1688;
                                phi_4437_ = _e1690;
                                phi_4438_ = _e1692;
                                phi_4439_ = _e1694;
                                phi_4440_ = _e1696;
                            } else {
                                phi_4886_ = _e563;
                                phi_4436_ = type_45();
                                phi_4437_ = type_60();
                                phi_4438_ = u32();
                                phi_4439_ = bool();
                                phi_4440_ = u32();
                            }
                            let _e1698 = phi_4886_;
                            let _e1700 = phi_4436_;
                            let _e1702 = phi_4437_;
                            let _e1704 = phi_4438_;
                            let _e1706 = phi_4439_;
                            let _e1708 = phi_4440_;
                            phi_4885_ = _e1698;
                            phi_1979_ = _e1700;
                            phi_1982_ = _e1702;
                            phi_1984_ = _e1704;
                            phi_1986_ = _e1706;
                            phi_1988_ = _e1708;
                            phi_4441_ = _e577;
                        } else {
                            phi_4885_ = _e563;
                            phi_1979_ = type_45();
                            phi_1982_ = type_60();
                            phi_1984_ = u32();
                            phi_1986_ = bool();
                            phi_1988_ = u32();
                            phi_4441_ = false;
                        }
                        let _e1710 = phi_4885_;
                        let _e1712 = phi_1979_;
                        let _e1714 = phi_1982_;
                        let _e1716 = phi_1984_;
                        let _e1718 = phi_1986_;
                        let _e1720 = phi_1988_;
                        let _e1722 = phi_4441_;
                        continue;
                        continuing {
                            phi_4758_ = _e1710;
                            phi_1978_ = _e1712;
                            phi_1981_ = _e1714;
                            phi_1983_ = _e1716;
                            phi_1985_ = _e1718;
                            phi_1987_ = _e1720;
                            phi_4884_ = _e1710;
                            break if !(_e1722);
                        }
                    }
                    let _e1725 = phi_4884_;
                    if _e1725 {
                        break;
                    }
                    let _e1727 = local_4;
                    if (_e1727.member.member_3 != 4294967295u) {
                        let _e1732 = (_e349 / 3i);
                        let _e1739 = bitcast<f32>((bitcast<u32>((_e1732 + 127i)) << bitcast<u32>(23i)));
                        let _e1747 = (((_e1727.member.member * _e1739) * _e1739) * bitcast<f32>((bitcast<u32>(((_e349 - (2i * _e1732)) + 127i)) << bitcast<u32>(23i))));
                        let _e1749 = select(340282350000000000000000000000000000000f, _e1747, (_e1747 < 340282350000000000000000000000000000000f));
                        phi_4493_ = type_29(select(-340282350000000000000000000000000000000f, _e1749, (_e1749 > -340282350000000000000000000000000000000f)), _e1727.member.member_1, _e1727.member.member_2, _e1727.member.member_3);
                    } else {
                        phi_4493_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1756 = phi_4493_;
                    if _e226 {
                    } else {
                        break;
                    }
                    global_9.member[_e136] = _e1756;
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e1760 = select(0u, 1u, (_e293 <= _e303));
                    if (_e1760 > 0u) {
                        let _e1762 = (1u < _e104);
                        if _e1762 {
                            if (0u < _e104) {
                            } else {
                                break;
                            }
                            let _e1766 = atomicAdd((&global_10.member[0u]), _e1760);
                            if ((_e1766 + _e1760) < _e1766) {
                                if _e1762 {
                                } else {
                                    break;
                                }
                                let _e1771 = atomicAdd((&global_10.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1774 = select(0u, 1u, (_e1756.member_3 != 4294967295u));
                    if (_e1774 > 0u) {
                        let _e1776 = (3u < _e104);
                        if _e1776 {
                            if (2u < _e104) {
                            } else {
                                break;
                            }
                            let _e1780 = atomicAdd((&global_10.member[2u]), _e1774);
                            if ((_e1780 + _e1774) < _e1780) {
                                if _e1776 {
                                } else {
                                    break;
                                }
                                let _e1785 = atomicAdd((&global_10.member[3u]), 1u);
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
