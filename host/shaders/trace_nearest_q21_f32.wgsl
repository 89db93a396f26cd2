struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_25 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_33 {
    member: array<type_22>,
}

struct type_37 {
    member: array<array<type_21, 8>>,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: array<array<u32, 7>>,
}

struct type_52 {
    member: type_25,
    member_1: u32,
}

struct type_53 {
    member: array<vec4<f32>, 3>,
    member_1: type_52,
    member_2: type_52,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_43;
@group(0) @binding(4) 
var<storage> global_4: type_33;
@group(0) @binding(2) 
var<storage> global_5: type_47;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_37;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<f32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<u32, 128>;
    var local_9: array<type_21, 8>;
    var local_10: array<f32, 128>;
    var phi_480_: i32;
    var phi_481_: i32;
    var phi_491_: bool;
    var phi_501_: u32;
    var phi_502_: u32;
    var phi_504_: bool;
    var phi_509_: u32;
    var phi_522_: i32;
    var phi_542_: i32;
    var phi_560_: f32;
    var phi_566_: f32;
    var phi_606_: f32;
    var phi_612_: f32;
    var phi_664_: f32;
    var phi_676_: f32;
    var phi_685_: f32;
    var phi_691_: f32;
    var phi_731_: f32;
    var phi_737_: f32;
    var phi_789_: f32;
    var phi_801_: f32;
    var phi_810_: f32;
    var phi_816_: f32;
    var phi_856_: f32;
    var phi_862_: f32;
    var phi_914_: f32;
    var phi_926_: f32;
    var phi_981_: i32;
    var phi_1003_: u32;
    var phi_1004_: u32;
    var phi_1041_: i32;
    var phi_1063_: u32;
    var phi_1064_: u32;
    var phi_1072_: f32;
    var phi_1073_: f32;
    var phi_4236_: bool;
    var phi_4217_: f32;
    var phi_1222_: u32;
    var phi_1225_: bool;
    var phi_1227_: u32;
    var phi_1229_: type_52;
    var phi_1240_: bool;
    var phi_1327_: bool;
    var phi_1328_: u32;
    var phi_1329_: type_52;
    var phi_4233_: bool;
    var phi_4222_: f32;
    var phi_1347_: type_4;
    var phi_1348_: type_4;
    var phi_1371_: type_4;
    var phi_1392_: u32;
    var phi_1484_: array<array<f32, 3>, 3>;
    var phi_1637_: bool;
    var phi_1666_: bool;
    var phi_2085_: f32;
    var phi_2086_: f32;
    var phi_2087_: f32;
    var phi_2088_: f32;
    var phi_2089_: vec3<f32>;
    var phi_2090_: vec3<f32>;
    var phi_2091_: vec3<f32>;
    var phi_2092_: vec3<f32>;
    var phi_2129_: bool;
    var phi_2138_: vec3<f32>;
    var phi_2303_: f32;
    var phi_2305_: f32;
    var phi_2306_: bool;
    var phi_2326_: f32;
    var phi_2327_: f32;
    var phi_2350_: type_21;
    var phi_2352_: type_21;
    var phi_2353_: bool;
    var phi_2357_: type_21;
    var phi_2358_: type_21;
    var phi_2359_: type_21;
    var phi_2360_: bool;
    var phi_2364_: type_21;
    var phi_2365_: bool;
    var phi_2366_: type_21;
    var phi_2367_: bool;
    var phi_2368_: bool;
    var phi_2369_: type_21;
    var phi_2370_: bool;
    var phi_2371_: bool;
    var phi_2379_: type_21;
    var phi_2380_: bool;
    var phi_2384_: type_21;
    var phi_2396_: type_4;
    var phi_2399_: type_21;
    var phi_2397_: type_4;
    var phi_2422_: type_4;
    var phi_2454_: bool;
    var phi_2455_: bool;
    var phi_2476_: type_21;
    var phi_2400_: type_21;
    var phi_4224_: bool;
    var phi_4533_: f32;
    var phi_4532_: f32;
    var phi_4387_: bool;
    var phi_4531_: f32;
    var phi_4386_: bool;
    var phi_4530_: f32;
    var phi_4385_: bool;
    var phi_4442_: f32;
    var phi_4384_: bool;
    var phi_4621_: bool;
    var phi_4441_: f32;
    var phi_3214_: u32;
    var phi_3215_: u32;
    var phi_3225_: u32;
    var phi_3227_: u32;
    var phi_3228_: bool;
    var phi_3248_: u32;
    var phi_3249_: u32;
    var phi_3253_: type_53;
    var phi_3616_: type_52;
    var phi_3692_: type_52;
    var phi_3693_: u32;
    var phi_3694_: type_52;
    var phi_3696_: u32;
    var phi_3697_: type_52;
    var phi_3698_: bool;
    var phi_3707_: type_52;
    var phi_3712_: bool;
    var phi_3714_: type_52;
    var phi_3718_: bool;
    var phi_3719_: u32;
    var phi_3720_: type_52;
    var phi_3730_: type_52;
    var phi_4649_: f32;
    var phi_4538_: bool;
    var phi_3731_: u32;
    var phi_3732_: bool;
    var phi_3733_: u32;
    var phi_3734_: type_52;
    var phi_4648_: f32;
    var phi_4537_: bool;
    var phi_3735_: u32;
    var phi_3736_: bool;
    var phi_3737_: u32;
    var phi_3738_: type_52;
    var phi_4647_: f32;
    var phi_4536_: bool;
    var phi_1223_: u32;
    var phi_1226_: bool;
    var phi_1228_: u32;
    var phi_1230_: type_52;
    var phi_3739_: bool;
    var phi_4535_: bool;
    var phi_3746_: type_4;
    var phi_3747_: type_4;
    var phi_3770_: type_4;
    var phi_3822_: f32;
    var phi_3824_: f32;
    var phi_3825_: bool;
    var phi_3826_: f32;
    var phi_3827_: bool;
    var phi_4114_: u32;
    var phi_4132_: bool;
    var phi_4135_: bool;
    var phi_4148_: f32;
    var phi_4149_: f32;
    var phi_4154_: f32;
    var phi_4155_: f32;
    var phi_4156_: bool;
    var phi_4164_: f32;
    var phi_3842_: f32;
    var phi_3843_: f32;
    var phi_3855_: f32;
    var phi_3860_: type_21;
    var phi_4629_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e93 = global;
            let _e95 = arrayLength((&global_5.member));
            let _e97 = arrayLength((&global_2.member));
            let _e105 = global_3.member[0u][0u];
            let _e109 = global_3.member[0u][1u];
            let _e113 = global_3.member[0u][2u];
            let _e117 = global_3.member[0u][3u];
            let _e121 = global_3.member[1u][0u];
            let _e125 = global_3.member[1u][1u];
            let _e129 = global_3.member[1u][2u];
            let _e132 = global_1.member[0u];
            let _e133 = bitcast<i32>(_e132);
            let _e145 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e117) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e105), bitcast<i32>(_e109), bitcast<i32>(_e113));
            local = array<i32, 3>(bitcast<i32>(_e121), bitcast<i32>(_e125), bitcast<i32>(_e129));
            let _e151 = (_e93.x + (_e93.y * 2097152u));
            let _e152 = (_e151 < arrayLength((&global_4.member)));
            if _e152 {
                let _e153 = (_e151 < arrayLength((&global_6.member)));
                if _e153 {
                    if _e152 {
                    } else {
                        break;
                    }
                    let _e161 = global_4.member[_e151].member_2[0u];
                    let _e163 = (bitcast<u32>(_e161) & 2147483647u);
                    let _e168 = global_4.member[_e151].member_2[1u];
                    let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                    let _e175 = global_4.member[_e151].member_2[2u];
                    let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                    let _e182 = global_4.member[_e151].member[0u];
                    let _e184 = (bitcast<u32>(_e182) & 2147483647u);
                    let _e189 = global_4.member[_e151].member[1u];
                    let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                    let _e196 = global_4.member[_e151].member[2u];
                    let _e198 = (bitcast<u32>(_e196) & 2147483647u);
                    let _e200 = select(_e170, _e163, (_e170 < _e163));
                    let _e202 = select(_e177, _e200, (_e177 < _e200));
                    let _e204 = select(_e184, _e202, (_e184 < _e202));
                    let _e206 = select(_e191, _e204, (_e191 < _e204));
                    let _e208 = select(_e198, _e206, (_e198 < _e206));
                    let _e212 = global_4.member[_e151].member_1;
                    let _e213 = bitcast<u32>(_e212);
                    let _e214 = (_e213 & 2147483647u);
                    let _e221 = global_4.member[_e151].member_3;
                    let _e222 = bitcast<u32>(_e221);
                    let _e223 = (_e222 & 2147483647u);
                    let _e227 = (((select(_e214, _e208, (_e214 < _e208)) < 2139095040u) && (_e223 <= 2139095040u)) && (_e202 > 0u));
                    if _e227 {
                        let _e230 = (bitcast<u32>(bitcast<f32>(_e202)) & 2147483647u);
                        if (_e230 >= 8388608u) {
                            phi_480_ = (bitcast<i32>((_e230 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_480_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e230)), 32u, (_e230 == 0u))));
                        }
                        let _e244 = phi_480_;
                        phi_481_ = _e244;
                    } else {
                        phi_481_ = 0i;
                    }
                    let _e246 = phi_481_;
                    let _e247 = (_e163 == _e202);
                    if _e247 {
                        phi_491_ = true;
                    } else {
                        phi_491_ = (_e170 == _e202);
                    }
                    let _e250 = phi_491_;
                    let _e251 = select(1u, 0u, _e247);
                    if _e250 {
                        let _e252 = (_e251 + 1u);
                        phi_501_ = _e252;
                        phi_502_ = _e252;
                        phi_504_ = select(true, false, (_e252 == 2u));
                    } else {
                        phi_501_ = u32();
                        phi_502_ = 0u;
                        phi_504_ = true;
                    }
                    let _e256 = phi_501_;
                    let _e258 = phi_502_;
                    let _e260 = phi_504_;
                    if _e260 {
                        phi_509_ = (_e258 + 1u);
                    } else {
                        phi_509_ = 0u;
                    }
                    let _e264 = phi_509_;
                    let _e265 = select(_e256, _e258, _e260);
                    let _e266 = select(_e251, select(2u, _e251, _e250), _e260);
                    if (_e133 < -126i) {
                        phi_522_ = -126i;
                    } else {
                        phi_522_ = select(_e133, 127i, (_e133 > 127i));
                    }
                    let _e271 = phi_522_;
                    let _e276 = bitcast<f32>((bitcast<u32>((_e271 + 127i)) << bitcast<u32>(23i)));
                    let _e282 = bitcast<f32>((bitcast<u32>(((_e133 - _e271) + 127i)) << bitcast<u32>(23i)));
                    let _e283 = -(_e246);
                    if (_e283 < -126i) {
                        phi_542_ = -126i;
                    } else {
                        phi_542_ = select(_e283, 127i, (_e283 > 127i));
                    }
                    let _e288 = phi_542_;
                    let _e293 = bitcast<f32>((bitcast<u32>((_e288 + 127i)) << bitcast<u32>(23i)));
                    let _e299 = bitcast<f32>((bitcast<u32>(((_e283 - _e288) + 127i)) << bitcast<u32>(23i)));
                    let _e303 = global_4.member[_e151].member;
                    let _e304 = (_e265 == 0u);
                    if _e304 {
                        phi_560_ = _e303[0];
                    } else {
                        phi_560_ = _e303[1];
                    }
                    let _e308 = phi_560_;
                    let _e309 = (_e265 == 2u);
                    if _e309 {
                        phi_566_ = _e303[2];
                    } else {
                        phi_566_ = _e308;
                    }
                    let _e312 = phi_566_;
                    let _e313 = bitcast<u32>(_e312);
                    let _e315 = ((_e313 & 2139095040u) != 0u);
                    let _e329 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e313 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e313 & 2147483648u))), _e312, _e315) * _e276) * select(0.00000011920929f, 1f, _e315)) * _e282);
                    let _e330 = global_4.member[_e151].member_2;
                    if _e304 {
                        phi_606_ = _e330[0];
                    } else {
                        phi_606_ = _e330[1];
                    }
                    let _e334 = phi_606_;
                    if _e309 {
                        phi_612_ = _e330[2];
                    } else {
                        phi_612_ = _e334;
                    }
                    let _e337 = phi_612_;
                    let _e338 = bitcast<u32>(_e337);
                    let _e340 = ((_e338 & 2139095040u) != 0u);
                    let _e354 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e338 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e338 & 2147483648u))), _e337, _e340) * _e293) * select(0.00000011920929f, 1f, _e340)) * _e299);
                    let _e358 = (bitcast<f32>((bitcast<u32>(_e354) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e358 {
                        let _e362 = (bitcast<f32>((bitcast<u32>(_e329) & 2147483647u)) * 0.00000011920929f);
                        phi_664_ = select(0.00000000000011368684f, _e362, (_e362 > 0.00000000000011368684f));
                    } else {
                        phi_664_ = 0f;
                    }
                    let _e366 = phi_664_;
                    let _e367 = (_e329 + _e366);
                    let _e368 = (_e329 - _e366);
                    let _e369 = select(_e354, 0f, _e358);
                    if _e358 {
                        phi_676_ = 38685626000000000000000000f;
                    } else {
                        phi_676_ = (1f / _e354);
                    }
                    let _e372 = phi_676_;
                    let _e373 = (_e264 == 0u);
                    if _e373 {
                        phi_685_ = _e303[0];
                    } else {
                        phi_685_ = _e303[1];
                    }
                    let _e377 = phi_685_;
                    let _e378 = (_e264 == 2u);
                    if _e378 {
                        phi_691_ = _e303[2];
                    } else {
                        phi_691_ = _e377;
                    }
                    let _e381 = phi_691_;
                    let _e382 = bitcast<u32>(_e381);
                    let _e384 = ((_e382 & 2139095040u) != 0u);
                    let _e398 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e382 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e382 & 2147483648u))), _e381, _e384) * _e276) * select(0.00000011920929f, 1f, _e384)) * _e282);
                    if _e373 {
                        phi_731_ = _e330[0];
                    } else {
                        phi_731_ = _e330[1];
                    }
                    let _e402 = phi_731_;
                    if _e378 {
                        phi_737_ = _e330[2];
                    } else {
                        phi_737_ = _e402;
                    }
                    let _e405 = phi_737_;
                    let _e406 = bitcast<u32>(_e405);
                    let _e408 = ((_e406 & 2139095040u) != 0u);
                    let _e422 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e406 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e406 & 2147483648u))), _e405, _e408) * _e293) * select(0.00000011920929f, 1f, _e408)) * _e299);
                    let _e426 = (bitcast<f32>((bitcast<u32>(_e422) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e426 {
                        let _e430 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) * 0.00000011920929f);
                        phi_789_ = select(0.00000000000011368684f, _e430, (_e430 > 0.00000000000011368684f));
                    } else {
                        phi_789_ = 0f;
                    }
                    let _e434 = phi_789_;
                    let _e435 = (_e398 + _e434);
                    let _e436 = (_e398 - _e434);
                    let _e437 = select(_e422, 0f, _e426);
                    if _e426 {
                        phi_801_ = 38685626000000000000000000f;
                    } else {
                        phi_801_ = (1f / _e422);
                    }
                    let _e440 = phi_801_;
                    let _e441 = (_e266 == 0u);
                    if _e441 {
                        phi_810_ = _e303[0];
                    } else {
                        phi_810_ = _e303[1];
                    }
                    let _e445 = phi_810_;
                    let _e446 = (_e266 == 2u);
                    if _e446 {
                        phi_816_ = _e303[2];
                    } else {
                        phi_816_ = _e445;
                    }
                    let _e449 = phi_816_;
                    let _e450 = bitcast<u32>(_e449);
                    let _e452 = ((_e450 & 2139095040u) != 0u);
                    let _e466 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e450 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e450 & 2147483648u))), _e449, _e452) * _e276) * select(0.00000011920929f, 1f, _e452)) * _e282);
                    if _e441 {
                        phi_856_ = _e330[0];
                    } else {
                        phi_856_ = _e330[1];
                    }
                    let _e470 = phi_856_;
                    if _e446 {
                        phi_862_ = _e330[2];
                    } else {
                        phi_862_ = _e470;
                    }
                    let _e473 = phi_862_;
                    let _e474 = bitcast<u32>(_e473);
                    let _e476 = ((_e474 & 2139095040u) != 0u);
                    let _e490 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e474 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e474 & 2147483648u))), _e473, _e476) * _e293) * select(0.00000011920929f, 1f, _e476)) * _e299);
                    let _e494 = (bitcast<f32>((bitcast<u32>(_e490) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e494 {
                        let _e498 = (bitcast<f32>((bitcast<u32>(_e466) & 2147483647u)) * 0.00000011920929f);
                        phi_914_ = select(0.00000000000011368684f, _e498, (_e498 > 0.00000000000011368684f));
                    } else {
                        phi_914_ = 0f;
                    }
                    let _e502 = phi_914_;
                    let _e503 = (_e466 + _e502);
                    let _e504 = (_e466 - _e502);
                    let _e505 = select(_e490, 0f, _e494);
                    if _e494 {
                        phi_926_ = 38685626000000000000000000f;
                    } else {
                        phi_926_ = (1f / _e490);
                    }
                    let _e508 = phi_926_;
                    let _e511 = bitcast<f32>((bitcast<u32>(_e329) & 2147483647u));
                    let _e514 = bitcast<f32>((bitcast<u32>(_e398) & 2147483647u));
                    let _e516 = select(_e514, _e511, (_e511 > _e514));
                    let _e519 = bitcast<f32>((bitcast<u32>(_e466) & 2147483647u));
                    let _e522 = (_e133 + _e246);
                    if (_e227 && (select(_e519, _e516, (_e516 > _e519)) <= 1099511600000f)) {
                        let _e532 = ((_e214 & 8388607u) | (select(0u, 1u, ((_e214 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e535 = bitcast<i32>((_e214 >> bitcast<u32>(23i)));
                        let _e539 = (_e532 == 0u);
                        let _e542 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e532)), 32u, _e539)) - 8i);
                        if (_e535 == 255i) {
                            phi_981_ = 255i;
                        } else {
                            phi_981_ = (((_e535 + select(0i, 1i, (_e535 == 0i))) - _e542) + _e522);
                        }
                        let _e550 = phi_981_;
                        let _e560 = (_e550 <= 0i);
                        if _e560 {
                            phi_1004_ = u32();
                        } else {
                            if _e539 {
                                phi_1003_ = u32();
                            } else {
                                phi_1003_ = select(((bitcast<u32>(_e550) << bitcast<u32>(23i)) | ((_e532 << bitcast<u32>(((_e542 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e550 >= 255i));
                            }
                            let _e564 = phi_1003_;
                            phi_1004_ = _e564;
                        }
                        let _e566 = phi_1004_;
                        let _e578 = ((_e223 & 8388607u) | (select(0u, 1u, ((_e223 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e581 = bitcast<i32>((_e223 >> bitcast<u32>(23i)));
                        let _e585 = (_e578 == 0u);
                        let _e588 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e578)), 32u, _e585)) - 8i);
                        if (_e581 == 255i) {
                            phi_1041_ = 255i;
                        } else {
                            phi_1041_ = (((_e581 + select(0i, 1i, (_e581 == 0i))) - _e588) + _e522);
                        }
                        let _e596 = phi_1041_;
                        let _e606 = (_e596 <= 0i);
                        if _e606 {
                            phi_1064_ = u32();
                        } else {
                            if _e585 {
                                phi_1063_ = u32();
                            } else {
                                phi_1063_ = select(((bitcast<u32>(_e596) << bitcast<u32>(23i)) | ((_e578 << bitcast<u32>(((_e588 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e596 >= 255i));
                            }
                            let _e610 = phi_1063_;
                            phi_1064_ = _e610;
                        }
                        let _e612 = phi_1064_;
                        phi_1072_ = bitcast<f32>(((_e222 & 2147483648u) | select(_e612, 0u, select(_e585, true, _e606))));
                        phi_1073_ = bitcast<f32>(((_e213 & 2147483648u) | select(_e566, 0u, select(_e539, true, _e560))));
                    } else {
                        phi_1072_ = 0f;
                        phi_1073_ = 1f;
                    }
                    let _e618 = phi_1072_;
                    let _e620 = phi_1073_;
                    local_9 = array<type_21, 8>(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e623 = (_e265 % 3u);
                    let _e624 = (_e623 < 3u);
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e626 = local_1[_e623];
                    let _e629 = (_e264 % 3u);
                    let _e630 = (_e629 < 3u);
                    if _e630 {
                    } else {
                        break;
                    }
                    let _e632 = local_1[_e629];
                    let _e635 = (_e266 % 3u);
                    let _e636 = (_e635 < 3u);
                    if _e636 {
                    } else {
                        break;
                    }
                    let _e638 = local_1[_e635];
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e643 = local[_e623];
                    if _e630 {
                    } else {
                        break;
                    }
                    let _e647 = local[_e629];
                    if _e636 {
                    } else {
                        break;
                    }
                    let _e651 = local[_e635];
                    phi_4236_ = false;
                    phi_4217_ = _e618;
                    phi_1222_ = ((3u * _e95) + 1u);
                    phi_1225_ = (_e620 <= _e618);
                    phi_1227_ = 0u;
                    phi_1229_ = type_52(type_25(vec4<f32>((f32(_e626) * _e145), (f32(_e632) * _e145), (f32(_e638) * _e145), 0f), vec4<f32>((f32(_e643) * _e145), (f32(_e647) * _e145), (f32(_e651) * _e145), 0f)), select(0u, 2147483648u, (_e95 == 0u)));
                    loop {
                        let _e661 = phi_4236_;
                        let _e663 = phi_4217_;
                        let _e665 = phi_1222_;
                        let _e667 = phi_1225_;
                        let _e669 = phi_1227_;
                        let _e671 = phi_1229_;
                        if _e667 {
                            phi_1240_ = true;
                        } else {
                            phi_1240_ = (_e669 > 0u);
                        }
                        let _e674 = phi_1240_;
                        if _e674 {
                            let _e675 = (_e665 > 0u);
                            if _e675 {
                                if _e667 {
                                    phi_1327_ = _e667;
                                    phi_1328_ = _e669;
                                    phi_1329_ = _e671;
                                } else {
                                    let _e676 = (_e669 - 1u);
                                    let _e677 = (_e676 % 128u);
                                    let _e678 = (_e677 < 128u);
                                    if _e678 {
                                    } else {
                                        phi_4535_ = true;
                                        break;
                                    }
                                    let _e680 = local_7[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4535_ = true;
                                        break;
                                    }
                                    let _e682 = local_6[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4535_ = true;
                                        break;
                                    }
                                    let _e684 = local_5[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4535_ = true;
                                        break;
                                    }
                                    let _e686 = local_4[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4535_ = true;
                                        break;
                                    }
                                    let _e688 = local_3[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4535_ = true;
                                        break;
                                    }
                                    let _e690 = local_2[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4535_ = true;
                                        break;
                                    }
                                    let _e695 = local_8[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4535_ = true;
                                        break;
                                    }
                                    let _e698 = local_10[_e677];
                                    phi_1327_ = (_e698 <= _e663);
                                    phi_1328_ = _e676;
                                    phi_1329_ = type_52(type_25(vec4<f32>(_e680, _e682, _e684, 0f), vec4<f32>(_e686, _e688, _e690, 0f)), _e695);
                                }
                                let _e701 = phi_1327_;
                                let _e703 = phi_1328_;
                                let _e705 = phi_1329_;
                                if _e701 {
                                    let _e709 = ((_e705.member_1 & 2147483648u) != 0u);
                                    if _e709 {
                                        phi_4233_ = _e661;
                                        phi_4222_ = _e663;
                                        phi_1347_ = type_4(0u, ((_e705.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e716 = phi_4233_;
                                            let _e718 = phi_4222_;
                                            let _e720 = phi_1347_;
                                            if (_e720.member < _e720.member_1) {
                                                phi_1348_ = type_4((_e720.member + 1u), _e720.member_1);
                                                phi_1371_ = type_4(1u, _e720.member);
                                            } else {
                                                phi_1348_ = _e720;
                                                phi_1371_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e733 = phi_1348_;
                                            let _e735 = phi_1371_;
                                            let _e739 = (bitcast<i32>(_e735.member) != 0i);
                                            if _e739 {
                                                let _e740 = ((_e705.member_1 & 268435455u) + _e735.member_1);
                                                let _e741 = (_e740 < _e97);
                                                if _e741 {
                                                    if _e741 {
                                                    } else {
                                                        phi_4442_ = _e718;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e745 = global_2.member[_e740].member_1;
                                                    phi_1392_ = _e745;
                                                } else {
                                                    phi_1392_ = 4294967295u;
                                                }
                                                let _e747 = phi_1392_;
                                                if (_e740 >= _e97) {
                                                    phi_1484_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e741 {
                                                    } else {
                                                        phi_4442_ = _e718;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    if (_e623 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e718;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e754 = global_2.member[_e740].member[_e623];
                                                    if (_e629 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e718;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e760 = global_2.member[_e740].member[_e629];
                                                    if (_e635 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e718;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e766 = global_2.member[_e740].member[_e635];
                                                    let _e768 = (3u + _e623);
                                                    if (_e768 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e718;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e774 = global_2.member[_e740].member[_e768];
                                                    let _e775 = (3u + _e629);
                                                    if (_e775 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e718;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e781 = global_2.member[_e740].member[_e775];
                                                    let _e782 = (3u + _e635);
                                                    if (_e782 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e718;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e788 = global_2.member[_e740].member[_e782];
                                                    let _e790 = (6u + _e623);
                                                    if (_e790 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e718;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e796 = global_2.member[_e740].member[_e790];
                                                    let _e797 = (6u + _e629);
                                                    if (_e797 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e718;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e803 = global_2.member[_e740].member[_e797];
                                                    let _e804 = (6u + _e635);
                                                    if (_e804 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e718;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e810 = global_2.member[_e740].member[_e804];
                                                    phi_1484_ = array<array<f32, 3>, 3>(array<f32, 3>(_e754, _e760, _e766), array<f32, 3>(_e774, _e781, _e788), array<f32, 3>(_e796, _e803, _e810));
                                                }
                                                let _e814 = phi_1484_;
                                                let _e821 = (_e814[0][2] - _e466);
                                                let _e824 = (((_e814[0][0] - _e329) * _e505) - (_e821 * _e369));
                                                let _e827 = (((_e814[0][1] - _e398) * _e505) - (_e821 * _e437));
                                                let _e834 = (_e814[1][2] - _e466);
                                                let _e837 = (((_e814[1][0] - _e329) * _e505) - (_e834 * _e369));
                                                let _e840 = (((_e814[1][1] - _e398) * _e505) - (_e834 * _e437));
                                                let _e847 = (_e814[2][2] - _e466);
                                                let _e850 = (((_e814[2][0] - _e329) * _e505) - (_e847 * _e369));
                                                let _e853 = (((_e814[2][1] - _e398) * _e505) - (_e847 * _e437));
                                                let _e854 = (_e850 * _e840);
                                                let _e855 = (_e853 * _e837);
                                                let _e856 = (_e824 * _e853);
                                                let _e857 = (_e827 * _e850);
                                                let _e858 = (_e837 * _e827);
                                                let _e859 = (_e840 * _e824);
                                                let _e864 = (((_e854 >= _e855) && (_e856 >= _e857)) && (_e858 >= _e859));
                                                if (_e864 || (((_e854 <= _e855) && (_e856 <= _e857)) && (_e858 <= _e859))) {
                                                    let _e871 = select(-1f, 1f, _e864);
                                                    let _e873 = ((_e854 - _e855) * _e871);
                                                    let _e875 = select(0f, _e873, (_e873 > 0f));
                                                    let _e877 = ((_e856 - _e857) * _e871);
                                                    let _e879 = select(0f, _e877, (_e877 > 0f));
                                                    let _e881 = ((_e858 - _e859) * _e871);
                                                    let _e883 = select(0f, _e881, (_e881 > 0f));
                                                    let _e885 = ((_e875 + _e879) + _e883);
                                                    if (_e885 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2369_ = type_21();
                                                        phi_2370_ = true;
                                                        phi_2371_ = false;
                                                    } else {
                                                        let _e888 = select(_e837, _e824, (_e824 < _e837));
                                                        if (select(_e850, _e888, (_e888 < _e850)) > 0f) {
                                                            phi_1637_ = true;
                                                        } else {
                                                            let _e893 = select(_e837, _e824, (_e824 > _e837));
                                                            phi_1637_ = (select(_e850, _e893, (_e893 > _e850)) < 0f);
                                                        }
                                                        let _e898 = phi_1637_;
                                                        if _e898 {
                                                            phi_2366_ = type_21();
                                                            phi_2367_ = true;
                                                            phi_2368_ = false;
                                                        } else {
                                                            let _e900 = select(_e840, _e827, (_e827 < _e840));
                                                            if (select(_e853, _e900, (_e900 < _e853)) > 0f) {
                                                                phi_1666_ = true;
                                                            } else {
                                                                let _e905 = select(_e840, _e827, (_e827 > _e840));
                                                                phi_1666_ = (select(_e853, _e905, (_e905 > _e853)) < 0f);
                                                            }
                                                            let _e910 = phi_1666_;
                                                            if _e910 {
                                                                phi_2364_ = type_21();
                                                                phi_2365_ = false;
                                                            } else {
                                                                let _e912 = select(_e814[1][0], _e814[0][0], (_e814[0][0] < _e814[1][0]));
                                                                let _e916 = select(_e814[1][0], _e814[0][0], (_e814[0][0] > _e814[1][0]));
                                                                let _e920 = select(_e814[1][1], _e814[0][1], (_e814[0][1] < _e814[1][1]));
                                                                let _e924 = select(_e814[1][1], _e814[0][1], (_e814[0][1] > _e814[1][1]));
                                                                let _e928 = select(_e814[1][2], _e814[0][2], (_e814[0][2] < _e814[1][2]));
                                                                let _e932 = select(_e814[1][2], _e814[0][2], (_e814[0][2] > _e814[1][2]));
                                                                let _e937 = ((select(_e814[2][0], _e912, (_e912 < _e814[2][0])) - _e367) * _e372);
                                                                let _e938 = ((select(_e814[2][0], _e916, (_e916 > _e814[2][0])) - _e368) * _e372);
                                                                let _e941 = ((select(_e814[2][1], _e920, (_e920 < _e814[2][1])) - _e435) * _e440);
                                                                let _e942 = ((select(_e814[2][1], _e924, (_e924 > _e814[2][1])) - _e436) * _e440);
                                                                let _e945 = ((select(_e814[2][2], _e928, (_e928 < _e814[2][2])) - _e503) * _e508);
                                                                let _e946 = ((select(_e814[2][2], _e932, (_e932 > _e814[2][2])) - _e504) * _e508);
                                                                let _e948 = select(_e946, _e945, (_e945 < _e946));
                                                                let _e950 = select(_e946, _e945, (_e945 > _e946));
                                                                let _e952 = select(_e938, _e937, (_e937 < _e938));
                                                                let _e954 = select(_e942, _e941, (_e941 < _e942));
                                                                let _e956 = select(_e954, _e952, (_e952 > _e954));
                                                                let _e958 = select(_e948, _e956, (_e956 > _e948));
                                                                let _e960 = select(_e938, _e937, (_e937 > _e938));
                                                                let _e962 = select(_e942, _e941, (_e941 > _e942));
                                                                let _e964 = select(_e962, _e960, (_e960 < _e962));
                                                                let _e966 = select(_e950, _e964, (_e964 < _e950));
                                                                let _e967 = -(_e948);
                                                                let _e973 = select(_e620, _e958, (_e958 > _e620));
                                                                if (_e973 > (_e966 + (select(_e967, _e950, (_e950 > _e967)) * 0.0000019073523f))) {
                                                                    phi_2359_ = type_21();
                                                                    phi_2360_ = true;
                                                                } else {
                                                                    let _e975 = (_e973 > _e718);
                                                                    if _e975 {
                                                                        phi_2358_ = type_21();
                                                                    } else {
                                                                        let _e976 = vec3<f32>(_e814[0][0], _e814[0][1], _e814[0][2]);
                                                                        let _e977 = vec3<f32>(_e814[1][0], _e814[1][1], _e814[1][2]);
                                                                        let _e978 = vec3<f32>(_e814[2][0], _e814[2][1], _e814[2][2]);
                                                                        let _e979 = (_e814[1][0] - _e814[0][0]);
                                                                        let _e980 = (_e814[1][1] - _e814[0][1]);
                                                                        let _e981 = (_e814[1][2] - _e814[0][2]);
                                                                        let _e982 = vec3<f32>(_e979, _e980, _e981);
                                                                        let _e983 = (_e814[2][0] - _e814[1][0]);
                                                                        let _e984 = (_e814[2][1] - _e814[1][1]);
                                                                        let _e985 = (_e814[2][2] - _e814[1][2]);
                                                                        let _e986 = vec3<f32>(_e983, _e984, _e985);
                                                                        let _e987 = (_e814[0][0] - _e814[2][0]);
                                                                        let _e988 = (_e814[0][1] - _e814[2][1]);
                                                                        let _e989 = (_e814[0][2] - _e814[2][2]);
                                                                        let _e990 = vec3<f32>(_e987, _e988, _e989);
                                                                        let _e993 = bitcast<f32>((bitcast<u32>(_e979) & 2147483647u));
                                                                        let _e996 = bitcast<f32>((bitcast<u32>(_e980) & 2147483647u));
                                                                        let _e998 = select(_e996, _e993, (_e993 > _e996));
                                                                        let _e1001 = bitcast<f32>((bitcast<u32>(_e981) & 2147483647u));
                                                                        let _e1003 = select(_e1001, _e998, (_e998 > _e1001));
                                                                        let _e1006 = bitcast<f32>((bitcast<u32>(_e983) & 2147483647u));
                                                                        let _e1009 = bitcast<f32>((bitcast<u32>(_e984) & 2147483647u));
                                                                        let _e1011 = select(_e1009, _e1006, (_e1006 > _e1009));
                                                                        let _e1014 = bitcast<f32>((bitcast<u32>(_e985) & 2147483647u));
                                                                        let _e1016 = select(_e1014, _e1011, (_e1011 > _e1014));
                                                                        let _e1019 = bitcast<f32>((bitcast<u32>(_e987) & 2147483647u));
                                                                        let _e1022 = bitcast<f32>((bitcast<u32>(_e988) & 2147483647u));
                                                                        let _e1024 = select(_e1022, _e1019, (_e1019 > _e1022));
                                                                        let _e1027 = bitcast<f32>((bitcast<u32>(_e989) & 2147483647u));
                                                                        let _e1029 = select(_e1027, _e1024, (_e1024 > _e1027));
                                                                        let _e1031 = select(_e1016, _e1003, (_e1003 > _e1016));
                                                                        let _e1033 = select(_e1029, _e1031, (_e1031 > _e1029));
                                                                        if (_e1003 == _e1033) {
                                                                            phi_2085_ = _e840;
                                                                            phi_2086_ = _e837;
                                                                            phi_2087_ = _e827;
                                                                            phi_2088_ = _e824;
                                                                            phi_2089_ = _e976;
                                                                            phi_2090_ = _e990;
                                                                            phi_2091_ = _e986;
                                                                            phi_2092_ = _e982;
                                                                        } else {
                                                                            let _e1035 = (_e1016 == _e1033);
                                                                            let _e1040 = vec3(_e1035);
                                                                            phi_2085_ = select(_e827, _e853, _e1035);
                                                                            phi_2086_ = select(_e824, _e850, _e1035);
                                                                            phi_2087_ = select(_e853, _e840, _e1035);
                                                                            phi_2088_ = select(_e850, _e837, _e1035);
                                                                            phi_2089_ = select(_e978, _e977, _e1040);
                                                                            phi_2090_ = select(_e986, _e982, _e1040);
                                                                            phi_2091_ = select(_e982, _e990, _e1040);
                                                                            phi_2092_ = select(_e990, _e986, _e1040);
                                                                        }
                                                                        let _e1046 = phi_2085_;
                                                                        let _e1048 = phi_2086_;
                                                                        let _e1050 = phi_2087_;
                                                                        let _e1052 = phi_2088_;
                                                                        let _e1054 = phi_2089_;
                                                                        let _e1056 = phi_2090_;
                                                                        let _e1058 = phi_2091_;
                                                                        let _e1060 = phi_2092_;
                                                                        let _e1067 = ((_e1058.y * _e1056.z) - (_e1056.y * _e1058.z));
                                                                        let _e1072 = ((_e1058.z * _e1056.x) - (_e1056.z * _e1058.x));
                                                                        let _e1075 = ((_e1058.x * _e1056.y) - (_e1056.x * _e1058.y));
                                                                        if (_e875 >= _e879) {
                                                                            phi_2129_ = select(true, false, (_e875 >= _e883));
                                                                        } else {
                                                                            phi_2129_ = true;
                                                                        }
                                                                        let _e1080 = phi_2129_;
                                                                        if _e1080 {
                                                                            phi_2138_ = select(_e978, _e977, vec3((_e879 >= _e883)));
                                                                        } else {
                                                                            phi_2138_ = _e976;
                                                                        }
                                                                        let _e1085 = phi_2138_;
                                                                        let _e1096 = (((_e1067 * (_e1085.x - _e329)) + (_e1072 * (_e1085.y - _e398))) + (_e1075 * (_e1085.z - _e466)));
                                                                        let _e1101 = (((_e1067 * _e369) + (_e1072 * _e437)) + (_e1075 * _e505));
                                                                        let _e1102 = (_e1048 - _e1052);
                                                                        let _e1103 = (_e1046 - _e1050);
                                                                        let _e1111 = (-(((_e1052 * _e1102) + (_e1050 * _e1103))) / ((_e1102 * _e1102) + (_e1103 * _e1103)));
                                                                        let _e1113 = select(1f, _e1111, (_e1111 < 1f));
                                                                        let _e1115 = select(0f, _e1113, (_e1113 > 0f));
                                                                        let _e1128 = ((_e1054.x + (_e1060.x * _e1115)) - _e329);
                                                                        let _e1129 = ((_e1054.y + (_e1060.y * _e1115)) - _e398);
                                                                        let _e1130 = ((_e1054.z + (_e1060.z * _e1115)) - _e466);
                                                                        let _e1131 = (_e1130 / _e505);
                                                                        let _e1143 = bitcast<f32>((bitcast<u32>(_e1128) & 2147483647u));
                                                                        let _e1146 = bitcast<f32>((bitcast<u32>(_e1129) & 2147483647u));
                                                                        let _e1148 = select(_e1146, _e1143, (_e1143 > _e1146));
                                                                        let _e1151 = bitcast<f32>((bitcast<u32>(_e1130) & 2147483647u));
                                                                        let _e1153 = select(_e1151, _e1148, (_e1148 > _e1151));
                                                                        let _e1159 = bitcast<f32>((bitcast<u32>(_e1067) & 2147483647u));
                                                                        let _e1162 = bitcast<f32>((bitcast<u32>(_e1072) & 2147483647u));
                                                                        let _e1164 = select(_e1162, _e1159, (_e1159 > _e1162));
                                                                        let _e1167 = bitcast<f32>((bitcast<u32>(_e1075) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1067 * _e1128) + (_e1072 * _e1129)) + (_e1075 * _e1130)) - _e1096)) & 2147483647u)) <= ((0.0000009536743f * select(_e1033, _e1153, (_e1153 > _e1033))) * select(_e1167, _e1164, (_e1164 > _e1167)))) {
                                                                            let _e1177 = bitcast<f32>((bitcast<u32>(_e1058.x) & 2147483647u));
                                                                            let _e1180 = bitcast<f32>((bitcast<u32>(_e1058.y) & 2147483647u));
                                                                            let _e1182 = select(_e1180, _e1177, (_e1177 > _e1180));
                                                                            let _e1185 = bitcast<f32>((bitcast<u32>(_e1058.z) & 2147483647u));
                                                                            let _e1191 = bitcast<f32>((bitcast<u32>(_e1056.x) & 2147483647u));
                                                                            let _e1194 = bitcast<f32>((bitcast<u32>(_e1056.y) & 2147483647u));
                                                                            let _e1196 = select(_e1194, _e1191, (_e1191 > _e1194));
                                                                            let _e1199 = bitcast<f32>((bitcast<u32>(_e1056.z) & 2147483647u));
                                                                            let _e1203 = (bitcast<f32>((bitcast<u32>(_e1101) & 2147483647u)) > ((0.0000038146973f * select(_e1185, _e1182, (_e1182 > _e1185))) * select(_e1199, _e1196, (_e1196 > _e1199))));
                                                                            if _e1203 {
                                                                                phi_2303_ = (_e1096 / _e1101);
                                                                            } else {
                                                                                phi_2303_ = f32();
                                                                            }
                                                                            let _e1206 = phi_2303_;
                                                                            phi_2305_ = _e1206;
                                                                            phi_2306_ = select(true, false, _e1203);
                                                                        } else {
                                                                            phi_2305_ = f32();
                                                                            phi_2306_ = true;
                                                                        }
                                                                        let _e1209 = phi_2305_;
                                                                        let _e1211 = phi_2306_;
                                                                        if _e1211 {
                                                                            let _e1219 = (((_e1067 * (_e1128 - (_e369 * _e1131))) + (_e1072 * (_e1129 - (_e437 * _e1131)))) / _e1101);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1219) & 2147483647u)) <= _e1033) {
                                                                                phi_2326_ = (_e1131 + _e1219);
                                                                            } else {
                                                                                phi_2326_ = _e1131;
                                                                            }
                                                                            let _e1226 = phi_2326_;
                                                                            phi_2327_ = _e1226;
                                                                        } else {
                                                                            phi_2327_ = _e1209;
                                                                        }
                                                                        let _e1228 = phi_2327_;
                                                                        let _e1230 = select(_e966, _e1228, (_e1228 < _e966));
                                                                        let _e1232 = select(_e958, _e1230, (_e1230 > _e958));
                                                                        if (_e1232 >= _e620) {
                                                                            let _e1234 = (_e1232 <= _e718);
                                                                            if _e1234 {
                                                                                let _e1235 = (1f / _e885);
                                                                                phi_2350_ = type_21(_e1232, (_e879 * _e1235), (_e883 * _e1235), _e747);
                                                                            } else {
                                                                                phi_2350_ = type_21();
                                                                            }
                                                                            let _e1240 = phi_2350_;
                                                                            phi_2352_ = _e1240;
                                                                            phi_2353_ = select(true, false, _e1234);
                                                                        } else {
                                                                            phi_2352_ = type_21();
                                                                            phi_2353_ = true;
                                                                        }
                                                                        let _e1243 = phi_2352_;
                                                                        let _e1245 = phi_2353_;
                                                                        if _e1245 {
                                                                            phi_2357_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2357_ = _e1243;
                                                                        }
                                                                        let _e1247 = phi_2357_;
                                                                        phi_2358_ = _e1247;
                                                                    }
                                                                    let _e1249 = phi_2358_;
                                                                    phi_2359_ = _e1249;
                                                                    phi_2360_ = _e975;
                                                                }
                                                                let _e1251 = phi_2359_;
                                                                let _e1253 = phi_2360_;
                                                                phi_2364_ = _e1251;
                                                                phi_2365_ = _e1253;
                                                            }
                                                            let _e1255 = phi_2364_;
                                                            let _e1257 = phi_2365_;
                                                            phi_2366_ = _e1255;
                                                            phi_2367_ = _e910;
                                                            phi_2368_ = _e1257;
                                                        }
                                                        let _e1259 = phi_2366_;
                                                        let _e1261 = phi_2367_;
                                                        let _e1263 = phi_2368_;
                                                        phi_2369_ = _e1259;
                                                        phi_2370_ = _e1261;
                                                        phi_2371_ = _e1263;
                                                    }
                                                    let _e1265 = phi_2369_;
                                                    let _e1267 = phi_2370_;
                                                    let _e1269 = phi_2371_;
                                                    phi_2379_ = _e1265;
                                                    phi_2380_ = select(_e1269, true, _e1267);
                                                } else {
                                                    phi_2379_ = type_21();
                                                    phi_2380_ = true;
                                                }
                                                let _e1272 = phi_2379_;
                                                let _e1274 = phi_2380_;
                                                if _e1274 {
                                                    phi_2384_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2384_ = _e1272;
                                                }
                                                let _e1276 = phi_2384_;
                                                if (_e1276.member_3 != 4294967295u) {
                                                    if (_e747 != 4294967295u) {
                                                        phi_2396_ = type_4(0u, 8u);
                                                        phi_2399_ = _e1276;
                                                        loop {
                                                            let _e1281 = phi_2396_;
                                                            let _e1283 = phi_2399_;
                                                            if (_e1281.member < _e1281.member_1) {
                                                                phi_2397_ = type_4((_e1281.member + 1u), _e1281.member_1);
                                                                phi_2422_ = type_4(1u, _e1281.member);
                                                            } else {
                                                                phi_2397_ = _e1281;
                                                                phi_2422_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1296 = phi_2397_;
                                                            let _e1298 = phi_2422_;
                                                            let _e1302 = (bitcast<i32>(_e1298.member) != 0i);
                                                            if _e1302 {
                                                                let _e1303 = (_e1298.member_1 < 8u);
                                                                if _e1303 {
                                                                } else {
                                                                    phi_4224_ = true;
                                                                    break;
                                                                }
                                                                let _e1308 = local_9[_e1298.member_1].member;
                                                                if (_e1283.member < _e1308) {
                                                                    phi_2455_ = true;
                                                                } else {
                                                                    let _e1310 = local_9[_e1298.member_1].member;
                                                                    if (_e1283.member == _e1310) {
                                                                        let _e1315 = local_9[_e1298.member_1].member_3;
                                                                        phi_2454_ = (_e1283.member_3 < _e1315);
                                                                    } else {
                                                                        phi_2454_ = false;
                                                                    }
                                                                    let _e1318 = phi_2454_;
                                                                    phi_2455_ = _e1318;
                                                                }
                                                                let _e1320 = phi_2455_;
                                                                if _e1320 {
                                                                    if _e1303 {
                                                                    } else {
                                                                        phi_4224_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1321 = local_9[_e1298.member_1];
                                                                    local_9[_e1298.member_1] = type_21(_e1283.member, _e1283.member_1, _e1283.member_2, _e1283.member_3);
                                                                    phi_2476_ = type_21(_e1321.member, _e1321.member_1, _e1321.member_2, _e1321.member_3);
                                                                } else {
                                                                    phi_2476_ = _e1283;
                                                                }
                                                                let _e1332 = phi_2476_;
                                                                phi_2400_ = _e1332;
                                                            } else {
                                                                phi_2400_ = type_21();
                                                            }
                                                            let _e1334 = phi_2400_;
                                                            continue;
                                                            continuing {
                                                                phi_2396_ = _e1296;
                                                                phi_2399_ = _e1334;
                                                                phi_4224_ = _e716;
                                                                break if !(_e1302);
                                                            }
                                                        }
                                                        let _e1337 = phi_4224_;
                                                        phi_4442_ = _e718;
                                                        phi_4384_ = _e1337;
                                                        if _e1337 {
                                                            break;
                                                        }
                                                        let _e1340 = local_9[7u].member_3;
                                                        if (_e1340 != 4294967295u) {
                                                            let _e1344 = local_9[7u].member;
                                                            phi_4533_ = _e1344;
                                                        } else {
                                                            phi_4533_ = _e718;
                                                        }
                                                        let _e1346 = phi_4533_;
                                                        phi_4532_ = _e1346;
                                                        phi_4387_ = _e1337;
                                                    } else {
                                                        phi_4532_ = _e718;
                                                        phi_4387_ = _e716;
                                                    }
                                                    let _e1348 = phi_4532_;
                                                    let _e1350 = phi_4387_;
                                                    phi_4531_ = _e1348;
                                                    phi_4386_ = _e1350;
                                                } else {
                                                    phi_4531_ = _e718;
                                                    phi_4386_ = _e716;
                                                }
                                                let _e1352 = phi_4531_;
                                                let _e1354 = phi_4386_;
                                                phi_4530_ = _e1352;
                                                phi_4385_ = _e1354;
                                            } else {
                                                phi_4530_ = _e718;
                                                phi_4385_ = _e716;
                                            }
                                            let _e1356 = phi_4530_;
                                            let _e1358 = phi_4385_;
                                            continue;
                                            continuing {
                                                phi_4233_ = _e1358;
                                                phi_4222_ = _e1356;
                                                phi_1347_ = _e733;
                                                phi_4442_ = _e1356;
                                                phi_4384_ = _e1358;
                                                break if !(_e739);
                                            }
                                        }
                                        let _e1361 = phi_4442_;
                                        let _e1363 = phi_4384_;
                                        phi_4535_ = _e1363;
                                        if _e1363 {
                                            break;
                                        }
                                        phi_4621_ = _e1363;
                                        phi_4441_ = _e1361;
                                    } else {
                                        phi_4621_ = _e661;
                                        phi_4441_ = _e663;
                                    }
                                    let _e1365 = phi_4621_;
                                    let _e1367 = phi_4441_;
                                    if _e709 {
                                        phi_3718_ = bool();
                                        phi_3719_ = u32();
                                        phi_3720_ = type_52();
                                    } else {
                                        if (_e705.member_1 >= _e95) {
                                            phi_3253_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e705.member_1 < _e95) {
                                            } else {
                                                phi_4535_ = true;
                                                break;
                                            }
                                            let _e1370 = (_e265 * 2u);
                                            let _e1372 = ((1u + _e1370) % 7u);
                                            if (_e1372 < 7u) {
                                            } else {
                                                phi_4535_ = true;
                                                break;
                                            }
                                            let _e1377 = global_5.member[_e705.member_1][_e1372];
                                            let _e1379 = ((_e1370 + 2u) % 7u);
                                            if (_e1379 < 7u) {
                                            } else {
                                                phi_4535_ = true;
                                                break;
                                            }
                                            let _e1384 = global_5.member[_e705.member_1][_e1379];
                                            let _e1385 = (_e264 * 2u);
                                            let _e1387 = ((1u + _e1385) % 7u);
                                            if (_e1387 < 7u) {
                                            } else {
                                                phi_4535_ = true;
                                                break;
                                            }
                                            let _e1392 = global_5.member[_e705.member_1][_e1387];
                                            let _e1394 = ((_e1385 + 2u) % 7u);
                                            if (_e1394 < 7u) {
                                            } else {
                                                phi_4535_ = true;
                                                break;
                                            }
                                            let _e1399 = global_5.member[_e705.member_1][_e1394];
                                            let _e1400 = (_e266 * 2u);
                                            let _e1402 = ((1u + _e1400) % 7u);
                                            if (_e1402 < 7u) {
                                            } else {
                                                phi_4535_ = true;
                                                break;
                                            }
                                            let _e1407 = global_5.member[_e705.member_1][_e1402];
                                            let _e1409 = ((_e1400 + 2u) % 7u);
                                            if (_e1409 < 7u) {
                                            } else {
                                                phi_4535_ = true;
                                                break;
                                            }
                                            let _e1414 = global_5.member[_e705.member_1][_e1409];
                                            let _e1437 = (bitcast<f32>((bitcast<u32>((_e705.member.member_1.x - _e705.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1438 = (bitcast<f32>((bitcast<u32>((_e705.member.member_1.y - _e705.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1439 = (bitcast<f32>((bitcast<u32>((_e705.member.member_1.z - _e705.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1441 = select(_e145, _e1437, (_e1437 > _e145));
                                            let _e1443 = select(_e145, _e1438, (_e1438 > _e145));
                                            let _e1445 = select(_e145, _e1439, (_e1439 > _e145));
                                            let _e1476 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1377 & 2097151u))) - 8388608f) * _e1441));
                                            let _e1481 = (bitcast<i32>((_e1377 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1484 = bitcast<f32>((_e1476 & bitcast<u32>(_e1481)));
                                            let _e1485 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1392 & 2097151u))) - 8388608f) * _e1443));
                                            let _e1490 = (bitcast<i32>((_e1392 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1493 = bitcast<f32>((_e1485 & bitcast<u32>(_e1490)));
                                            let _e1494 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1407 & 2097151u))) - 8388608f) * _e1445));
                                            let _e1499 = (bitcast<i32>((_e1407 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1502 = bitcast<f32>((_e1494 & bitcast<u32>(_e1499)));
                                            let _e1506 = bitcast<f32>((_e1476 & bitcast<u32>(~(_e1481))));
                                            let _e1510 = bitcast<f32>((_e1485 & bitcast<u32>(~(_e1490))));
                                            let _e1514 = bitcast<f32>((_e1494 & bitcast<u32>(~(_e1499))));
                                            let _e1515 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1384 & 2097151u))) - 8388608f) * _e1441));
                                            let _e1520 = (bitcast<i32>((_e1384 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1523 = bitcast<f32>((_e1515 & bitcast<u32>(_e1520)));
                                            let _e1524 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1399 & 2097151u))) - 8388608f) * _e1443));
                                            let _e1529 = (bitcast<i32>((_e1399 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1532 = bitcast<f32>((_e1524 & bitcast<u32>(_e1529)));
                                            let _e1533 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1414 & 2097151u))) - 8388608f) * _e1445));
                                            let _e1538 = (bitcast<i32>((_e1414 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1541 = bitcast<f32>((_e1533 & bitcast<u32>(_e1538)));
                                            let _e1545 = bitcast<f32>((_e1515 & bitcast<u32>(~(_e1520))));
                                            let _e1549 = bitcast<f32>((_e1524 & bitcast<u32>(~(_e1529))));
                                            let _e1553 = bitcast<f32>((_e1533 & bitcast<u32>(~(_e1538))));
                                            let _e1583 = global_5.member[_e705.member_1][0u];
                                            let _e1587 = global_5.member[_e705.member_1][2u];
                                            let _e1591 = global_5.member[_e705.member_1][4u];
                                            let _e1595 = global_5.member[_e705.member_1][6u];
                                            let _e1607 = (((_e1587 >> bitcast<u32>(22i)) | ((_e1591 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1595 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1608 = (_e1583 & 268435455u);
                                            let _e1609 = (_e1607 & 268435455u);
                                            let _e1612 = ((_e1583 >> bitcast<u32>(28u)) & 7u);
                                            let _e1620 = ((_e1583 >> bitcast<u32>(31i)) | (((_e1607 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1621 = (_e1612 != 0u);
                                            if (_e1612 == 0u) {
                                                phi_3215_ = _e1608;
                                            } else {
                                                if (_e1612 == 7u) {
                                                    phi_3214_ = 2147483648u;
                                                } else {
                                                    phi_3214_ = ((2147483648u | (_e1612 << bitcast<u32>(28u))) | (_e1609 & 268435455u));
                                                }
                                                let _e1630 = phi_3214_;
                                                phi_3215_ = _e1630;
                                            }
                                            let _e1632 = phi_3215_;
                                            if _e1621 {
                                                let _e1633 = (_e1612 != 7u);
                                                if _e1633 {
                                                    phi_3225_ = (_e1609 + _e1612);
                                                } else {
                                                    phi_3225_ = u32();
                                                }
                                                let _e1636 = phi_3225_;
                                                phi_3227_ = _e1636;
                                                phi_3228_ = select(true, false, _e1633);
                                            } else {
                                                phi_3227_ = u32();
                                                phi_3228_ = true;
                                            }
                                            let _e1639 = phi_3227_;
                                            let _e1641 = phi_3228_;
                                            if (_e1620 == 0u) {
                                                phi_3249_ = (_e1608 + select(0u, 1u, !(_e1621)));
                                            } else {
                                                if (_e1620 == 7u) {
                                                    phi_3248_ = 2147483648u;
                                                } else {
                                                    phi_3248_ = ((2147483648u | (_e1620 << bitcast<u32>(28u))) | (select(_e1639, _e1609, _e1641) & 268435455u));
                                                }
                                                let _e1654 = phi_3248_;
                                                phi_3249_ = _e1654;
                                            }
                                            let _e1656 = phi_3249_;
                                            phi_3253_ = type_53(array<vec4<f32>, 3>(vec4<f32>((_e705.member.member.x + _e1484), (_e705.member.member.x + _e1506), (_e705.member.member_1.x - _e1523), (_e705.member.member_1.x - _e1545)), vec4<f32>((_e705.member.member.y + _e1493), (_e705.member.member.y + _e1510), (_e705.member.member_1.y - _e1532), (_e705.member.member_1.y - _e1549)), vec4<f32>((_e705.member.member.z + _e1502), (_e705.member.member.z + _e1514), (_e705.member.member_1.z - _e1541), (_e705.member.member_1.z - _e1553))), type_52(type_25((_e705.member.member + vec4<f32>(_e1484, _e1493, _e1502, 0f)), (_e705.member.member_1 - vec4<f32>(_e1523, _e1532, _e1541, 0f))), _e1632), type_52(type_25((_e705.member.member + vec4<f32>(_e1506, _e1510, _e1514, 0f)), (_e705.member.member_1 - vec4<f32>(_e1545, _e1549, _e1553, 0f))), _e1656));
                                        }
                                        let _e1661 = phi_3253_;
                                        let _e1672 = ((_e1661.member[0].x - _e367) * _e372);
                                        let _e1673 = ((_e1661.member[0].y - _e367) * _e372);
                                        let _e1674 = ((_e1661.member[0].z - _e368) * _e372);
                                        let _e1675 = ((_e1661.member[0].w - _e368) * _e372);
                                        let _e1685 = ((_e1661.member[1].x - _e435) * _e440);
                                        let _e1686 = ((_e1661.member[1].y - _e435) * _e440);
                                        let _e1687 = ((_e1661.member[1].z - _e436) * _e440);
                                        let _e1688 = ((_e1661.member[1].w - _e436) * _e440);
                                        let _e1698 = ((_e1661.member[2].x - _e503) * _e508);
                                        let _e1699 = ((_e1661.member[2].y - _e503) * _e508);
                                        let _e1700 = ((_e1661.member[2].z - _e504) * _e508);
                                        let _e1701 = ((_e1661.member[2].w - _e504) * _e508);
                                        let _e1703 = select(_e1700, _e1698, (_e1698 < _e1700));
                                        let _e1705 = select(_e1701, _e1699, (_e1699 < _e1701));
                                        let _e1707 = select(_e1700, _e1698, (_e1698 > _e1700));
                                        let _e1709 = select(_e1701, _e1699, (_e1699 > _e1701));
                                        let _e1711 = select(_e1674, _e1672, (_e1672 < _e1674));
                                        let _e1713 = select(_e1675, _e1673, (_e1673 < _e1675));
                                        let _e1715 = select(_e1687, _e1685, (_e1685 < _e1687));
                                        let _e1717 = select(_e1688, _e1686, (_e1686 < _e1688));
                                        let _e1719 = select(_e1715, _e1711, (_e1711 > _e1715));
                                        let _e1721 = select(_e1717, _e1713, (_e1713 > _e1717));
                                        let _e1723 = select(_e1703, _e1719, (_e1719 > _e1703));
                                        let _e1725 = select(_e1705, _e1721, (_e1721 > _e1705));
                                        let _e1727 = select(_e1674, _e1672, (_e1672 > _e1674));
                                        let _e1729 = select(_e1675, _e1673, (_e1673 > _e1675));
                                        let _e1731 = select(_e1687, _e1685, (_e1685 > _e1687));
                                        let _e1733 = select(_e1688, _e1686, (_e1686 > _e1688));
                                        let _e1735 = select(_e1731, _e1727, (_e1727 < _e1731));
                                        let _e1737 = select(_e1733, _e1729, (_e1729 < _e1733));
                                        let _e1742 = -(_e1703);
                                        let _e1743 = -(_e1705);
                                        let _e1750 = (select(_e1707, _e1735, (_e1735 < _e1707)) + (select(_e1742, _e1707, (_e1707 > _e1742)) * 0.0000019073523f));
                                        let _e1751 = (select(_e1709, _e1737, (_e1737 < _e1709)) + (select(_e1743, _e1709, (_e1709 > _e1743)) * 0.0000019073523f));
                                        let _e1753 = select(_e620, _e1723, (_e1723 > _e620));
                                        let _e1755 = select(_e620, _e1725, (_e1725 > _e620));
                                        let _e1760 = (_e1753 <= select(_e1367, _e1750, (_e1750 < _e1367)));
                                        let _e1761 = (_e1755 <= select(_e1367, _e1751, (_e1751 < _e1367)));
                                        let _e1762 = (_e1753 <= _e1755);
                                        if _e1760 {
                                            if _e1761 {
                                                if _e1762 {
                                                    phi_3616_ = _e1661.member_2;
                                                } else {
                                                    phi_3616_ = _e1661.member_1;
                                                }
                                                let _e1766 = phi_3616_;
                                                let _e1787 = (_e703 % 128u);
                                                let _e1788 = (_e1787 < 128u);
                                                if _e1788 {
                                                } else {
                                                    phi_4535_ = true;
                                                    break;
                                                }
                                                local_8[_e1787] = _e1766.member_1;
                                                if _e1788 {
                                                } else {
                                                    phi_4535_ = true;
                                                    break;
                                                }
                                                local_7[_e1787] = _e1766.member.member.x;
                                                if _e1788 {
                                                } else {
                                                    phi_4535_ = true;
                                                    break;
                                                }
                                                local_6[_e1787] = _e1766.member.member.y;
                                                if _e1788 {
                                                } else {
                                                    phi_4535_ = true;
                                                    break;
                                                }
                                                local_5[_e1787] = _e1766.member.member.z;
                                                if _e1788 {
                                                } else {
                                                    phi_4535_ = true;
                                                    break;
                                                }
                                                local_4[_e1787] = _e1766.member.member_1.x;
                                                if _e1788 {
                                                } else {
                                                    phi_4535_ = true;
                                                    break;
                                                }
                                                local_3[_e1787] = _e1766.member.member_1.y;
                                                if _e1788 {
                                                } else {
                                                    phi_4535_ = true;
                                                    break;
                                                }
                                                local_2[_e1787] = _e1766.member.member_1.z;
                                                if _e1788 {
                                                } else {
                                                    phi_4535_ = true;
                                                    break;
                                                }
                                                local_10[_e1787] = select(_e1753, _e1755, _e1762);
                                                if _e1762 {
                                                    phi_3692_ = _e1661.member_1;
                                                } else {
                                                    phi_3692_ = _e1661.member_2;
                                                }
                                                let _e1801 = phi_3692_;
                                                phi_3693_ = (_e703 + 1u);
                                                phi_3694_ = _e1801;
                                            } else {
                                                phi_3693_ = u32();
                                                phi_3694_ = type_52();
                                            }
                                            let _e1803 = phi_3693_;
                                            let _e1805 = phi_3694_;
                                            phi_3696_ = _e1803;
                                            phi_3697_ = _e1805;
                                            phi_3698_ = select(true, false, _e1761);
                                        } else {
                                            phi_3696_ = u32();
                                            phi_3697_ = type_52();
                                            phi_3698_ = true;
                                        }
                                        let _e1808 = phi_3696_;
                                        let _e1810 = phi_3697_;
                                        let _e1812 = phi_3698_;
                                        if _e1812 {
                                            if _e1760 {
                                                phi_3707_ = _e1661.member_1;
                                            } else {
                                                phi_3707_ = _e1661.member_2;
                                            }
                                            let _e1816 = phi_3707_;
                                            phi_3712_ = select(_e1761, true, _e1760);
                                            phi_3714_ = _e1816;
                                        } else {
                                            phi_3712_ = _e701;
                                            phi_3714_ = _e1810;
                                        }
                                        let _e1819 = phi_3712_;
                                        let _e1821 = phi_3714_;
                                        phi_3718_ = _e1819;
                                        phi_3719_ = select(_e1808, _e703, _e1812);
                                        phi_3720_ = _e1821;
                                    }
                                    let _e1824 = phi_3718_;
                                    let _e1826 = phi_3719_;
                                    let _e1828 = phi_3720_;
                                    if _e709 {
                                        phi_3730_ = _e705;
                                    } else {
                                        phi_3730_ = _e1828;
                                    }
                                    let _e1830 = phi_3730_;
                                    phi_4649_ = _e1367;
                                    phi_4538_ = _e1365;
                                    phi_3731_ = (_e665 - 1u);
                                    phi_3732_ = select(_e1824, false, _e709);
                                    phi_3733_ = select(_e1826, _e703, _e709);
                                    phi_3734_ = _e1830;
                                } else {
                                    phi_4649_ = _e663;
                                    phi_4538_ = _e661;
                                    phi_3731_ = _e665;
                                    phi_3732_ = _e701;
                                    phi_3733_ = _e703;
                                    phi_3734_ = _e705;
                                }
                                let _e1834 = phi_4649_;
                                let _e1836 = phi_4538_;
                                let _e1838 = phi_3731_;
                                let _e1840 = phi_3732_;
                                let _e1842 = phi_3733_;
                                let _e1844 = phi_3734_;
                                phi_4648_ = _e1834;
                                phi_4537_ = _e1836;
                                phi_3735_ = _e1838;
                                phi_3736_ = _e1840;
                                phi_3737_ = _e1842;
                                phi_3738_ = _e1844;
                            } else {
                                phi_4648_ = _e663;
                                phi_4537_ = _e661;
                                phi_3735_ = u32();
                                phi_3736_ = bool();
                                phi_3737_ = u32();
                                phi_3738_ = type_52();
                            }
                            let _e1846 = phi_4648_;
                            let _e1848 = phi_4537_;
                            let _e1850 = phi_3735_;
                            let _e1852 = phi_3736_;
                            let _e1854 = phi_3737_;
                            let _e1856 = phi_3738_;
                            phi_4647_ = _e1846;
                            phi_4536_ = _e1848;
                            phi_1223_ = _e1850;
                            phi_1226_ = _e1852;
                            phi_1228_ = _e1854;
                            phi_1230_ = _e1856;
                            phi_3739_ = _e675;
                        } else {
                            phi_4647_ = _e663;
                            phi_4536_ = _e661;
                            phi_1223_ = u32();
                            phi_1226_ = bool();
                            phi_1228_ = u32();
                            phi_1230_ = type_52();
                            phi_3739_ = false;
                        }
                        let _e1858 = phi_4647_;
                        let _e1860 = phi_4536_;
                        let _e1862 = phi_1223_;
                        let _e1864 = phi_1226_;
                        let _e1866 = phi_1228_;
                        let _e1868 = phi_1230_;
                        let _e1870 = phi_3739_;
                        continue;
                        continuing {
                            phi_4236_ = _e1860;
                            phi_4217_ = _e1858;
                            phi_1222_ = _e1862;
                            phi_1225_ = _e1864;
                            phi_1227_ = _e1866;
                            phi_1229_ = _e1868;
                            phi_4535_ = _e1860;
                            break if !(_e1870);
                        }
                    }
                    let _e1873 = phi_4535_;
                    if _e1873 {
                        break;
                    }
                    phi_3746_ = type_4(0u, 8u);
                    loop {
                        let _e1875 = phi_3746_;
                        if (_e1875.member < _e1875.member_1) {
                            phi_3747_ = type_4((_e1875.member + 1u), _e1875.member_1);
                            phi_3770_ = type_4(1u, _e1875.member);
                        } else {
                            phi_3747_ = _e1875;
                            phi_3770_ = type_4(0u, type_4().member_1);
                        }
                        let _e1888 = phi_3747_;
                        let _e1890 = phi_3770_;
                        let _e1894 = (bitcast<i32>(_e1890.member) != 0i);
                        if _e1894 {
                            let _e1895 = (_e1890.member_1 < 8u);
                            if _e1895 {
                            } else {
                                phi_4629_ = true;
                                break;
                            }
                            let _e1897 = local_9[_e1890.member_1];
                            if (_e1897.member_3 != 4294967295u) {
                                let _e1903 = -(_e522);
                                let _e1904 = bitcast<u32>(_e1897.member);
                                let _e1908 = (bitcast<i32>((_e1904 >> bitcast<u32>(23i))) & 255i);
                                let _e1909 = (_e1908 + _e1903);
                                if (_e1908 == 255i) {
                                    phi_3843_ = _e1897.member;
                                } else {
                                    if (_e1908 > 0i) {
                                        if (_e1909 > 0i) {
                                            let _e1913 = (_e1909 < 255i);
                                            if _e1913 {
                                                phi_3822_ = bitcast<f32>((_e1904 + bitcast<u32>((_e1903 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_3822_ = f32();
                                            }
                                            let _e1920 = phi_3822_;
                                            phi_3824_ = _e1920;
                                            phi_3825_ = select(true, false, _e1913);
                                        } else {
                                            phi_3824_ = f32();
                                            phi_3825_ = true;
                                        }
                                        let _e1923 = phi_3824_;
                                        let _e1925 = phi_3825_;
                                        phi_3826_ = _e1923;
                                        phi_3827_ = _e1925;
                                    } else {
                                        phi_3826_ = f32();
                                        phi_3827_ = true;
                                    }
                                    let _e1927 = phi_3826_;
                                    let _e1929 = phi_3827_;
                                    if _e1929 {
                                        let _e1930 = (_e1904 & 2147483648u);
                                        let _e1937 = ((_e1904 & 8388607u) | (select(0u, 1u, ((_e1904 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1941 = (_e1937 == 0u);
                                        if _e1941 {
                                            phi_4164_ = bitcast<f32>(_e1930);
                                        } else {
                                            let _e1946 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1937)), 32u, _e1941) - 8u);
                                            let _e1949 = (_e1937 << bitcast<u32>((_e1946 & 31u)));
                                            let _e1951 = ((_e1909 + select(0i, 1i, (_e1908 == 0i))) - bitcast<i32>(_e1946));
                                            if (_e1951 >= 255i) {
                                                phi_4154_ = bitcast<f32>((_e1930 | 2139095040u));
                                                phi_4155_ = f32();
                                                phi_4156_ = true;
                                            } else {
                                                let _e1953 = (_e1951 > 0i);
                                                if _e1953 {
                                                    phi_4148_ = bitcast<f32>(((_e1930 | (bitcast<u32>(_e1951) << bitcast<u32>(23i))) | (_e1949 & 8388607u)));
                                                    phi_4149_ = f32();
                                                } else {
                                                    if (_e1951 < -24i) {
                                                        phi_4114_ = 26u;
                                                    } else {
                                                        phi_4114_ = bitcast<u32>((1i - _e1951));
                                                    }
                                                    let _e1958 = phi_4114_;
                                                    let _e1959 = (_e1958 & 31u);
                                                    let _e1961 = (_e1949 >> bitcast<u32>(_e1959));
                                                    let _e1965 = (_e1949 & ((1u << bitcast<u32>(_e1959)) - 1u));
                                                    let _e1969 = (1u << bitcast<u32>(((_e1958 - 1u) & 31u)));
                                                    if (_e1965 > _e1969) {
                                                        phi_4135_ = true;
                                                    } else {
                                                        if (_e1965 == _e1969) {
                                                            phi_4132_ = ((_e1961 & 1u) == 1u);
                                                        } else {
                                                            phi_4132_ = false;
                                                        }
                                                        let _e1975 = phi_4132_;
                                                        phi_4135_ = _e1975;
                                                    }
                                                    let _e1977 = phi_4135_;
                                                    phi_4148_ = f32();
                                                    phi_4149_ = bitcast<f32>((_e1930 | (_e1961 + select(0u, 1u, _e1977))));
                                                }
                                                let _e1990 = phi_4148_;
                                                let _e1992 = phi_4149_;
                                                phi_4154_ = _e1990;
                                                phi_4155_ = _e1992;
                                                phi_4156_ = _e1953;
                                            }
                                            let _e1996 = phi_4154_;
                                            let _e1998 = phi_4155_;
                                            let _e2000 = phi_4156_;
                                            phi_4164_ = select(_e1998, _e1996, _e2000);
                                        }
                                        let _e2004 = phi_4164_;
                                        phi_3842_ = _e2004;
                                    } else {
                                        phi_3842_ = _e1927;
                                    }
                                    let _e2006 = phi_3842_;
                                    phi_3843_ = _e2006;
                                }
                                let _e2008 = phi_3843_;
                                let _e2009 = bitcast<u32>(_e2008);
                                if ((_e2009 & 2147483647u) >= 2139095040u) {
                                    phi_3855_ = bitcast<f32>(((_e2009 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_3855_ = _e2008;
                                }
                                let _e2016 = phi_3855_;
                                phi_3860_ = type_21(_e2016, _e1897.member_1, _e1897.member_2, _e1897.member_3);
                            } else {
                                phi_3860_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e2019 = phi_3860_;
                            if _e1895 {
                            } else {
                                phi_4629_ = true;
                                break;
                            }
                            local_9[_e1890.member_1] = type_21(_e2019.member, _e2019.member_1, _e2019.member_2, _e2019.member_3);
                        }
                        continue;
                        continuing {
                            phi_3746_ = _e1888;
                            phi_4629_ = _e1873;
                            break if !(_e1894);
                        }
                    }
                    let _e2027 = phi_4629_;
                    if _e2027 {
                        break;
                    }
                    let _e2028 = local_9;
                    if _e153 {
                    } else {
                        break;
                    }
                    global_6.member[_e151] = array<type_21, 8>(type_21(_e2028[0].member, _e2028[0].member_1, _e2028[0].member_2, _e2028[0].member_3), type_21(_e2028[1].member, _e2028[1].member_1, _e2028[1].member_2, _e2028[1].member_3), type_21(_e2028[2].member, _e2028[2].member_1, _e2028[2].member_2, _e2028[2].member_3), type_21(_e2028[3].member, _e2028[3].member_1, _e2028[3].member_2, _e2028[3].member_3), type_21(_e2028[4].member, _e2028[4].member_1, _e2028[4].member_2, _e2028[4].member_3), type_21(_e2028[5].member, _e2028[5].member_1, _e2028[5].member_2, _e2028[5].member_3), type_21(_e2028[6].member, _e2028[6].member_1, _e2028[6].member_2, _e2028[6].member_3), type_21(_e2028[7].member, _e2028[7].member_1, _e2028[7].member_2, _e2028[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
