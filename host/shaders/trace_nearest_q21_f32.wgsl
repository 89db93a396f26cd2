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
    var phi_4287_: bool;
    var phi_4216_: f32;
    var phi_1224_: bool;
    var phi_1227_: u32;
    var phi_1229_: u32;
    var phi_1231_: type_52;
    var phi_1242_: bool;
    var phi_1329_: bool;
    var phi_1330_: u32;
    var phi_1331_: type_52;
    var phi_3221_: u32;
    var phi_3222_: u32;
    var phi_3232_: u32;
    var phi_3234_: u32;
    var phi_3235_: bool;
    var phi_3255_: u32;
    var phi_3256_: u32;
    var phi_3260_: type_53;
    var phi_3623_: type_52;
    var phi_3700_: type_52;
    var phi_3701_: u32;
    var phi_3702_: type_52;
    var phi_3704_: u32;
    var phi_3705_: type_52;
    var phi_3706_: bool;
    var phi_3715_: type_52;
    var phi_3720_: bool;
    var phi_3722_: type_52;
    var phi_4284_: bool;
    var phi_4274_: f32;
    var phi_1349_: type_4;
    var phi_1350_: type_4;
    var phi_1373_: type_4;
    var phi_1394_: u32;
    var phi_1486_: array<array<f32, 3>, 3>;
    var phi_1639_: bool;
    var phi_1668_: bool;
    var phi_2087_: f32;
    var phi_2088_: f32;
    var phi_2089_: f32;
    var phi_2090_: f32;
    var phi_2091_: vec3<f32>;
    var phi_2092_: vec3<f32>;
    var phi_2093_: vec3<f32>;
    var phi_2094_: vec3<f32>;
    var phi_2131_: bool;
    var phi_2140_: vec3<f32>;
    var phi_2305_: f32;
    var phi_2307_: f32;
    var phi_2308_: bool;
    var phi_2328_: f32;
    var phi_2329_: f32;
    var phi_2352_: type_21;
    var phi_2354_: type_21;
    var phi_2355_: bool;
    var phi_2359_: type_21;
    var phi_2360_: type_21;
    var phi_2361_: type_21;
    var phi_2362_: bool;
    var phi_2366_: type_21;
    var phi_2367_: bool;
    var phi_2368_: type_21;
    var phi_2369_: bool;
    var phi_2370_: bool;
    var phi_2371_: type_21;
    var phi_2372_: bool;
    var phi_2373_: bool;
    var phi_2381_: type_21;
    var phi_2382_: bool;
    var phi_2386_: type_21;
    var phi_2398_: type_4;
    var phi_2401_: type_21;
    var phi_2399_: type_4;
    var phi_2424_: type_4;
    var phi_2456_: bool;
    var phi_2457_: bool;
    var phi_2478_: type_21;
    var phi_2402_: type_21;
    var phi_4275_: bool;
    var phi_4679_: f32;
    var phi_4678_: f32;
    var phi_4438_: bool;
    var phi_4677_: f32;
    var phi_4437_: bool;
    var phi_4676_: f32;
    var phi_4436_: bool;
    var phi_4588_: f32;
    var phi_4435_: bool;
    var phi_4553_: f32;
    var phi_4444_: bool;
    var phi_3726_: bool;
    var phi_3727_: u32;
    var phi_3728_: type_52;
    var phi_4552_: f32;
    var phi_4443_: bool;
    var phi_3729_: bool;
    var phi_3730_: u32;
    var phi_3731_: u32;
    var phi_3732_: type_52;
    var phi_4551_: f32;
    var phi_4442_: bool;
    var phi_3733_: bool;
    var phi_3734_: u32;
    var phi_3735_: u32;
    var phi_3736_: type_52;
    var phi_4550_: f32;
    var phi_4441_: bool;
    var phi_1225_: bool;
    var phi_1228_: u32;
    var phi_1230_: u32;
    var phi_1232_: type_52;
    var phi_3737_: bool;
    var phi_4440_: bool;
    var phi_3744_: type_4;
    var phi_3745_: type_4;
    var phi_3768_: type_4;
    var phi_3820_: f32;
    var phi_3822_: f32;
    var phi_3823_: bool;
    var phi_3824_: f32;
    var phi_3825_: bool;
    var phi_4112_: u32;
    var phi_4130_: bool;
    var phi_4133_: bool;
    var phi_4146_: f32;
    var phi_4147_: f32;
    var phi_4152_: f32;
    var phi_4153_: f32;
    var phi_4154_: bool;
    var phi_4162_: f32;
    var phi_3840_: f32;
    var phi_3841_: f32;
    var phi_3853_: f32;
    var phi_3858_: type_21;
    var phi_4532_: bool;

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
                    phi_4287_ = false;
                    phi_4216_ = _e618;
                    phi_1224_ = (_e620 <= _e618);
                    phi_1227_ = ((3u * _e95) + 1u);
                    phi_1229_ = 0u;
                    phi_1231_ = type_52(type_25(vec4<f32>((f32(_e626) * _e145), (f32(_e632) * _e145), (f32(_e638) * _e145), 0f), vec4<f32>((f32(_e643) * _e145), (f32(_e647) * _e145), (f32(_e651) * _e145), 0f)), select(0u, 2147483648u, (_e95 == 0u)));
                    loop {
                        let _e661 = phi_4287_;
                        let _e663 = phi_4216_;
                        let _e665 = phi_1224_;
                        let _e667 = phi_1227_;
                        let _e669 = phi_1229_;
                        let _e671 = phi_1231_;
                        if _e665 {
                            phi_1242_ = true;
                        } else {
                            phi_1242_ = (_e669 > 0u);
                        }
                        let _e674 = phi_1242_;
                        if _e674 {
                            let _e675 = (_e667 > 0u);
                            if _e675 {
                                if _e665 {
                                    phi_1329_ = _e665;
                                    phi_1330_ = _e669;
                                    phi_1331_ = _e671;
                                } else {
                                    let _e676 = (_e669 - 1u);
                                    let _e677 = (_e676 % 128u);
                                    let _e678 = (_e677 < 128u);
                                    if _e678 {
                                    } else {
                                        phi_4440_ = true;
                                        break;
                                    }
                                    let _e680 = local_7[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4440_ = true;
                                        break;
                                    }
                                    let _e682 = local_6[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4440_ = true;
                                        break;
                                    }
                                    let _e684 = local_5[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4440_ = true;
                                        break;
                                    }
                                    let _e686 = local_4[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4440_ = true;
                                        break;
                                    }
                                    let _e688 = local_3[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4440_ = true;
                                        break;
                                    }
                                    let _e690 = local_2[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4440_ = true;
                                        break;
                                    }
                                    let _e695 = local_8[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4440_ = true;
                                        break;
                                    }
                                    let _e698 = local_10[_e677];
                                    phi_1329_ = (_e698 <= _e663);
                                    phi_1330_ = _e676;
                                    phi_1331_ = type_52(type_25(vec4<f32>(_e680, _e682, _e684, 0f), vec4<f32>(_e686, _e688, _e690, 0f)), _e695);
                                }
                                let _e701 = phi_1329_;
                                let _e703 = phi_1330_;
                                let _e705 = phi_1331_;
                                if _e701 {
                                    if ((_e705.member_1 & 2147483648u) != 0u) {
                                        phi_4284_ = _e661;
                                        phi_4274_ = _e663;
                                        phi_1349_ = type_4(0u, ((_e705.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1172 = phi_4284_;
                                            let _e1174 = phi_4274_;
                                            let _e1176 = phi_1349_;
                                            if (_e1176.member < _e1176.member_1) {
                                                phi_1350_ = type_4((_e1176.member + 1u), _e1176.member_1);
                                                phi_1373_ = type_4(1u, _e1176.member);
                                            } else {
                                                phi_1350_ = _e1176;
                                                phi_1373_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1189 = phi_1350_;
                                            let _e1191 = phi_1373_;
                                            let _e1195 = (bitcast<i32>(_e1191.member) != 0i);
                                            if _e1195 {
                                                let _e1196 = ((_e705.member_1 & 268435455u) + _e1191.member_1);
                                                let _e1197 = (_e1196 < _e97);
                                                if _e1197 {
                                                    if _e1197 {
                                                    } else {
                                                        phi_4588_ = _e1174;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1201 = global_2.member[_e1196].member_1;
                                                    phi_1394_ = _e1201;
                                                } else {
                                                    phi_1394_ = 4294967295u;
                                                }
                                                let _e1203 = phi_1394_;
                                                if (_e1196 >= _e97) {
                                                    phi_1486_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1197 {
                                                    } else {
                                                        phi_4588_ = _e1174;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    if (_e623 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1174;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1210 = global_2.member[_e1196].member[_e623];
                                                    if (_e629 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1174;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1216 = global_2.member[_e1196].member[_e629];
                                                    if (_e635 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1174;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1222 = global_2.member[_e1196].member[_e635];
                                                    let _e1224 = (3u + _e623);
                                                    if (_e1224 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1174;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1230 = global_2.member[_e1196].member[_e1224];
                                                    let _e1231 = (3u + _e629);
                                                    if (_e1231 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1174;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1237 = global_2.member[_e1196].member[_e1231];
                                                    let _e1238 = (3u + _e635);
                                                    if (_e1238 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1174;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1244 = global_2.member[_e1196].member[_e1238];
                                                    let _e1246 = (6u + _e623);
                                                    if (_e1246 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1174;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1252 = global_2.member[_e1196].member[_e1246];
                                                    let _e1253 = (6u + _e629);
                                                    if (_e1253 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1174;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1259 = global_2.member[_e1196].member[_e1253];
                                                    let _e1260 = (6u + _e635);
                                                    if (_e1260 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1174;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1266 = global_2.member[_e1196].member[_e1260];
                                                    phi_1486_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1210, _e1216, _e1222), array<f32, 3>(_e1230, _e1237, _e1244), array<f32, 3>(_e1252, _e1259, _e1266));
                                                }
                                                let _e1270 = phi_1486_;
                                                let _e1277 = (_e1270[0][2] - _e466);
                                                let _e1280 = (((_e1270[0][0] - _e329) * _e505) - (_e1277 * _e369));
                                                let _e1283 = (((_e1270[0][1] - _e398) * _e505) - (_e1277 * _e437));
                                                let _e1290 = (_e1270[1][2] - _e466);
                                                let _e1293 = (((_e1270[1][0] - _e329) * _e505) - (_e1290 * _e369));
                                                let _e1296 = (((_e1270[1][1] - _e398) * _e505) - (_e1290 * _e437));
                                                let _e1303 = (_e1270[2][2] - _e466);
                                                let _e1306 = (((_e1270[2][0] - _e329) * _e505) - (_e1303 * _e369));
                                                let _e1309 = (((_e1270[2][1] - _e398) * _e505) - (_e1303 * _e437));
                                                let _e1310 = (_e1306 * _e1296);
                                                let _e1311 = (_e1309 * _e1293);
                                                let _e1312 = (_e1280 * _e1309);
                                                let _e1313 = (_e1283 * _e1306);
                                                let _e1314 = (_e1293 * _e1283);
                                                let _e1315 = (_e1296 * _e1280);
                                                let _e1320 = (((_e1310 >= _e1311) && (_e1312 >= _e1313)) && (_e1314 >= _e1315));
                                                if (_e1320 || (((_e1310 <= _e1311) && (_e1312 <= _e1313)) && (_e1314 <= _e1315))) {
                                                    let _e1327 = select(-1f, 1f, _e1320);
                                                    let _e1329 = ((_e1310 - _e1311) * _e1327);
                                                    let _e1331 = select(0f, _e1329, (_e1329 > 0f));
                                                    let _e1333 = ((_e1312 - _e1313) * _e1327);
                                                    let _e1335 = select(0f, _e1333, (_e1333 > 0f));
                                                    let _e1337 = ((_e1314 - _e1315) * _e1327);
                                                    let _e1339 = select(0f, _e1337, (_e1337 > 0f));
                                                    let _e1341 = ((_e1331 + _e1335) + _e1339);
                                                    if (_e1341 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2371_ = type_21();
                                                        phi_2372_ = true;
                                                        phi_2373_ = false;
                                                    } else {
                                                        let _e1344 = select(_e1293, _e1280, (_e1280 < _e1293));
                                                        if (select(_e1306, _e1344, (_e1344 < _e1306)) > 0f) {
                                                            phi_1639_ = true;
                                                        } else {
                                                            let _e1349 = select(_e1293, _e1280, (_e1280 > _e1293));
                                                            phi_1639_ = (select(_e1306, _e1349, (_e1349 > _e1306)) < 0f);
                                                        }
                                                        let _e1354 = phi_1639_;
                                                        if _e1354 {
                                                            phi_2368_ = type_21();
                                                            phi_2369_ = true;
                                                            phi_2370_ = false;
                                                        } else {
                                                            let _e1356 = select(_e1296, _e1283, (_e1283 < _e1296));
                                                            if (select(_e1309, _e1356, (_e1356 < _e1309)) > 0f) {
                                                                phi_1668_ = true;
                                                            } else {
                                                                let _e1361 = select(_e1296, _e1283, (_e1283 > _e1296));
                                                                phi_1668_ = (select(_e1309, _e1361, (_e1361 > _e1309)) < 0f);
                                                            }
                                                            let _e1366 = phi_1668_;
                                                            if _e1366 {
                                                                phi_2366_ = type_21();
                                                                phi_2367_ = false;
                                                            } else {
                                                                let _e1368 = select(_e1270[1][0], _e1270[0][0], (_e1270[0][0] < _e1270[1][0]));
                                                                let _e1372 = select(_e1270[1][0], _e1270[0][0], (_e1270[0][0] > _e1270[1][0]));
                                                                let _e1376 = select(_e1270[1][1], _e1270[0][1], (_e1270[0][1] < _e1270[1][1]));
                                                                let _e1380 = select(_e1270[1][1], _e1270[0][1], (_e1270[0][1] > _e1270[1][1]));
                                                                let _e1384 = select(_e1270[1][2], _e1270[0][2], (_e1270[0][2] < _e1270[1][2]));
                                                                let _e1388 = select(_e1270[1][2], _e1270[0][2], (_e1270[0][2] > _e1270[1][2]));
                                                                let _e1393 = ((select(_e1270[2][0], _e1368, (_e1368 < _e1270[2][0])) - _e367) * _e372);
                                                                let _e1394 = ((select(_e1270[2][0], _e1372, (_e1372 > _e1270[2][0])) - _e368) * _e372);
                                                                let _e1397 = ((select(_e1270[2][1], _e1376, (_e1376 < _e1270[2][1])) - _e435) * _e440);
                                                                let _e1398 = ((select(_e1270[2][1], _e1380, (_e1380 > _e1270[2][1])) - _e436) * _e440);
                                                                let _e1401 = ((select(_e1270[2][2], _e1384, (_e1384 < _e1270[2][2])) - _e503) * _e508);
                                                                let _e1402 = ((select(_e1270[2][2], _e1388, (_e1388 > _e1270[2][2])) - _e504) * _e508);
                                                                let _e1404 = select(_e1402, _e1401, (_e1401 < _e1402));
                                                                let _e1406 = select(_e1402, _e1401, (_e1401 > _e1402));
                                                                let _e1408 = select(_e1394, _e1393, (_e1393 < _e1394));
                                                                let _e1410 = select(_e1398, _e1397, (_e1397 < _e1398));
                                                                let _e1412 = select(_e1410, _e1408, (_e1408 > _e1410));
                                                                let _e1414 = select(_e1404, _e1412, (_e1412 > _e1404));
                                                                let _e1416 = select(_e1394, _e1393, (_e1393 > _e1394));
                                                                let _e1418 = select(_e1398, _e1397, (_e1397 > _e1398));
                                                                let _e1420 = select(_e1418, _e1416, (_e1416 < _e1418));
                                                                let _e1422 = select(_e1406, _e1420, (_e1420 < _e1406));
                                                                let _e1423 = -(_e1404);
                                                                let _e1429 = select(_e620, _e1414, (_e1414 > _e620));
                                                                if (_e1429 > (_e1422 + (select(_e1423, _e1406, (_e1406 > _e1423)) * 0.0000019073523f))) {
                                                                    phi_2361_ = type_21();
                                                                    phi_2362_ = true;
                                                                } else {
                                                                    let _e1431 = (_e1429 > _e1174);
                                                                    if _e1431 {
                                                                        phi_2360_ = type_21();
                                                                    } else {
                                                                        let _e1432 = vec3<f32>(_e1270[0][0], _e1270[0][1], _e1270[0][2]);
                                                                        let _e1433 = vec3<f32>(_e1270[1][0], _e1270[1][1], _e1270[1][2]);
                                                                        let _e1434 = vec3<f32>(_e1270[2][0], _e1270[2][1], _e1270[2][2]);
                                                                        let _e1435 = (_e1270[1][0] - _e1270[0][0]);
                                                                        let _e1436 = (_e1270[1][1] - _e1270[0][1]);
                                                                        let _e1437 = (_e1270[1][2] - _e1270[0][2]);
                                                                        let _e1438 = vec3<f32>(_e1435, _e1436, _e1437);
                                                                        let _e1439 = (_e1270[2][0] - _e1270[1][0]);
                                                                        let _e1440 = (_e1270[2][1] - _e1270[1][1]);
                                                                        let _e1441 = (_e1270[2][2] - _e1270[1][2]);
                                                                        let _e1442 = vec3<f32>(_e1439, _e1440, _e1441);
                                                                        let _e1443 = (_e1270[0][0] - _e1270[2][0]);
                                                                        let _e1444 = (_e1270[0][1] - _e1270[2][1]);
                                                                        let _e1445 = (_e1270[0][2] - _e1270[2][2]);
                                                                        let _e1446 = vec3<f32>(_e1443, _e1444, _e1445);
                                                                        let _e1449 = bitcast<f32>((bitcast<u32>(_e1435) & 2147483647u));
                                                                        let _e1452 = bitcast<f32>((bitcast<u32>(_e1436) & 2147483647u));
                                                                        let _e1454 = select(_e1452, _e1449, (_e1449 > _e1452));
                                                                        let _e1457 = bitcast<f32>((bitcast<u32>(_e1437) & 2147483647u));
                                                                        let _e1459 = select(_e1457, _e1454, (_e1454 > _e1457));
                                                                        let _e1462 = bitcast<f32>((bitcast<u32>(_e1439) & 2147483647u));
                                                                        let _e1465 = bitcast<f32>((bitcast<u32>(_e1440) & 2147483647u));
                                                                        let _e1467 = select(_e1465, _e1462, (_e1462 > _e1465));
                                                                        let _e1470 = bitcast<f32>((bitcast<u32>(_e1441) & 2147483647u));
                                                                        let _e1472 = select(_e1470, _e1467, (_e1467 > _e1470));
                                                                        let _e1475 = bitcast<f32>((bitcast<u32>(_e1443) & 2147483647u));
                                                                        let _e1478 = bitcast<f32>((bitcast<u32>(_e1444) & 2147483647u));
                                                                        let _e1480 = select(_e1478, _e1475, (_e1475 > _e1478));
                                                                        let _e1483 = bitcast<f32>((bitcast<u32>(_e1445) & 2147483647u));
                                                                        let _e1485 = select(_e1483, _e1480, (_e1480 > _e1483));
                                                                        let _e1487 = select(_e1472, _e1459, (_e1459 > _e1472));
                                                                        let _e1489 = select(_e1485, _e1487, (_e1487 > _e1485));
                                                                        if (_e1459 == _e1489) {
                                                                            phi_2087_ = _e1296;
                                                                            phi_2088_ = _e1293;
                                                                            phi_2089_ = _e1283;
                                                                            phi_2090_ = _e1280;
                                                                            phi_2091_ = _e1432;
                                                                            phi_2092_ = _e1446;
                                                                            phi_2093_ = _e1442;
                                                                            phi_2094_ = _e1438;
                                                                        } else {
                                                                            let _e1491 = (_e1472 == _e1489);
                                                                            let _e1496 = vec3(_e1491);
                                                                            phi_2087_ = select(_e1283, _e1309, _e1491);
                                                                            phi_2088_ = select(_e1280, _e1306, _e1491);
                                                                            phi_2089_ = select(_e1309, _e1296, _e1491);
                                                                            phi_2090_ = select(_e1306, _e1293, _e1491);
                                                                            phi_2091_ = select(_e1434, _e1433, _e1496);
                                                                            phi_2092_ = select(_e1442, _e1438, _e1496);
                                                                            phi_2093_ = select(_e1438, _e1446, _e1496);
                                                                            phi_2094_ = select(_e1446, _e1442, _e1496);
                                                                        }
                                                                        let _e1502 = phi_2087_;
                                                                        let _e1504 = phi_2088_;
                                                                        let _e1506 = phi_2089_;
                                                                        let _e1508 = phi_2090_;
                                                                        let _e1510 = phi_2091_;
                                                                        let _e1512 = phi_2092_;
                                                                        let _e1514 = phi_2093_;
                                                                        let _e1516 = phi_2094_;
                                                                        let _e1523 = ((_e1514.y * _e1512.z) - (_e1512.y * _e1514.z));
                                                                        let _e1528 = ((_e1514.z * _e1512.x) - (_e1512.z * _e1514.x));
                                                                        let _e1531 = ((_e1514.x * _e1512.y) - (_e1512.x * _e1514.y));
                                                                        if (_e1331 >= _e1335) {
                                                                            phi_2131_ = select(true, false, (_e1331 >= _e1339));
                                                                        } else {
                                                                            phi_2131_ = true;
                                                                        }
                                                                        let _e1536 = phi_2131_;
                                                                        if _e1536 {
                                                                            phi_2140_ = select(_e1434, _e1433, vec3((_e1335 >= _e1339)));
                                                                        } else {
                                                                            phi_2140_ = _e1432;
                                                                        }
                                                                        let _e1541 = phi_2140_;
                                                                        let _e1552 = (((_e1523 * (_e1541.x - _e329)) + (_e1528 * (_e1541.y - _e398))) + (_e1531 * (_e1541.z - _e466)));
                                                                        let _e1557 = (((_e1523 * _e369) + (_e1528 * _e437)) + (_e1531 * _e505));
                                                                        let _e1558 = (_e1504 - _e1508);
                                                                        let _e1559 = (_e1502 - _e1506);
                                                                        let _e1567 = (-(((_e1508 * _e1558) + (_e1506 * _e1559))) / ((_e1558 * _e1558) + (_e1559 * _e1559)));
                                                                        let _e1569 = select(1f, _e1567, (_e1567 < 1f));
                                                                        let _e1571 = select(0f, _e1569, (_e1569 > 0f));
                                                                        let _e1584 = ((_e1510.x + (_e1516.x * _e1571)) - _e329);
                                                                        let _e1585 = ((_e1510.y + (_e1516.y * _e1571)) - _e398);
                                                                        let _e1586 = ((_e1510.z + (_e1516.z * _e1571)) - _e466);
                                                                        let _e1587 = (_e1586 / _e505);
                                                                        let _e1599 = bitcast<f32>((bitcast<u32>(_e1584) & 2147483647u));
                                                                        let _e1602 = bitcast<f32>((bitcast<u32>(_e1585) & 2147483647u));
                                                                        let _e1604 = select(_e1602, _e1599, (_e1599 > _e1602));
                                                                        let _e1607 = bitcast<f32>((bitcast<u32>(_e1586) & 2147483647u));
                                                                        let _e1609 = select(_e1607, _e1604, (_e1604 > _e1607));
                                                                        let _e1615 = bitcast<f32>((bitcast<u32>(_e1523) & 2147483647u));
                                                                        let _e1618 = bitcast<f32>((bitcast<u32>(_e1528) & 2147483647u));
                                                                        let _e1620 = select(_e1618, _e1615, (_e1615 > _e1618));
                                                                        let _e1623 = bitcast<f32>((bitcast<u32>(_e1531) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1523 * _e1584) + (_e1528 * _e1585)) + (_e1531 * _e1586)) - _e1552)) & 2147483647u)) <= ((0.0000009536743f * select(_e1489, _e1609, (_e1609 > _e1489))) * select(_e1623, _e1620, (_e1620 > _e1623)))) {
                                                                            let _e1633 = bitcast<f32>((bitcast<u32>(_e1514.x) & 2147483647u));
                                                                            let _e1636 = bitcast<f32>((bitcast<u32>(_e1514.y) & 2147483647u));
                                                                            let _e1638 = select(_e1636, _e1633, (_e1633 > _e1636));
                                                                            let _e1641 = bitcast<f32>((bitcast<u32>(_e1514.z) & 2147483647u));
                                                                            let _e1647 = bitcast<f32>((bitcast<u32>(_e1512.x) & 2147483647u));
                                                                            let _e1650 = bitcast<f32>((bitcast<u32>(_e1512.y) & 2147483647u));
                                                                            let _e1652 = select(_e1650, _e1647, (_e1647 > _e1650));
                                                                            let _e1655 = bitcast<f32>((bitcast<u32>(_e1512.z) & 2147483647u));
                                                                            let _e1659 = (bitcast<f32>((bitcast<u32>(_e1557) & 2147483647u)) > ((0.0000038146973f * select(_e1641, _e1638, (_e1638 > _e1641))) * select(_e1655, _e1652, (_e1652 > _e1655))));
                                                                            if _e1659 {
                                                                                phi_2305_ = (_e1552 / _e1557);
                                                                            } else {
                                                                                phi_2305_ = f32();
                                                                            }
                                                                            let _e1662 = phi_2305_;
                                                                            phi_2307_ = _e1662;
                                                                            phi_2308_ = select(true, false, _e1659);
                                                                        } else {
                                                                            phi_2307_ = f32();
                                                                            phi_2308_ = true;
                                                                        }
                                                                        let _e1665 = phi_2307_;
                                                                        let _e1667 = phi_2308_;
                                                                        if _e1667 {
                                                                            let _e1675 = (((_e1523 * (_e1584 - (_e369 * _e1587))) + (_e1528 * (_e1585 - (_e437 * _e1587)))) / _e1557);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1675) & 2147483647u)) <= _e1489) {
                                                                                phi_2328_ = (_e1587 + _e1675);
                                                                            } else {
                                                                                phi_2328_ = _e1587;
                                                                            }
                                                                            let _e1682 = phi_2328_;
                                                                            phi_2329_ = _e1682;
                                                                        } else {
                                                                            phi_2329_ = _e1665;
                                                                        }
                                                                        let _e1684 = phi_2329_;
                                                                        let _e1686 = select(_e1422, _e1684, (_e1684 < _e1422));
                                                                        let _e1688 = select(_e1414, _e1686, (_e1686 > _e1414));
                                                                        if (_e1688 >= _e620) {
                                                                            let _e1690 = (_e1688 <= _e1174);
                                                                            if _e1690 {
                                                                                let _e1691 = (1f / _e1341);
                                                                                phi_2352_ = type_21(_e1688, (_e1335 * _e1691), (_e1339 * _e1691), _e1203);
                                                                            } else {
                                                                                phi_2352_ = type_21();
                                                                            }
                                                                            let _e1696 = phi_2352_;
                                                                            phi_2354_ = _e1696;
                                                                            phi_2355_ = select(true, false, _e1690);
                                                                        } else {
                                                                            phi_2354_ = type_21();
                                                                            phi_2355_ = true;
                                                                        }
                                                                        let _e1699 = phi_2354_;
                                                                        let _e1701 = phi_2355_;
                                                                        if _e1701 {
                                                                            phi_2359_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2359_ = _e1699;
                                                                        }
                                                                        let _e1703 = phi_2359_;
                                                                        phi_2360_ = _e1703;
                                                                    }
                                                                    let _e1705 = phi_2360_;
                                                                    phi_2361_ = _e1705;
                                                                    phi_2362_ = _e1431;
                                                                }
                                                                let _e1707 = phi_2361_;
                                                                let _e1709 = phi_2362_;
                                                                phi_2366_ = _e1707;
                                                                phi_2367_ = _e1709;
                                                            }
                                                            let _e1711 = phi_2366_;
                                                            let _e1713 = phi_2367_;
                                                            phi_2368_ = _e1711;
                                                            phi_2369_ = _e1366;
                                                            phi_2370_ = _e1713;
                                                        }
                                                        let _e1715 = phi_2368_;
                                                        let _e1717 = phi_2369_;
                                                        let _e1719 = phi_2370_;
                                                        phi_2371_ = _e1715;
                                                        phi_2372_ = _e1717;
                                                        phi_2373_ = _e1719;
                                                    }
                                                    let _e1721 = phi_2371_;
                                                    let _e1723 = phi_2372_;
                                                    let _e1725 = phi_2373_;
                                                    phi_2381_ = _e1721;
                                                    phi_2382_ = select(_e1725, true, _e1723);
                                                } else {
                                                    phi_2381_ = type_21();
                                                    phi_2382_ = true;
                                                }
                                                let _e1728 = phi_2381_;
                                                let _e1730 = phi_2382_;
                                                if _e1730 {
                                                    phi_2386_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2386_ = _e1728;
                                                }
                                                let _e1732 = phi_2386_;
                                                if (_e1732.member_3 != 4294967295u) {
                                                    if (_e1203 != 4294967295u) {
                                                        phi_2398_ = type_4(0u, 8u);
                                                        phi_2401_ = _e1732;
                                                        loop {
                                                            let _e1737 = phi_2398_;
                                                            let _e1739 = phi_2401_;
                                                            if (_e1737.member < _e1737.member_1) {
                                                                phi_2399_ = type_4((_e1737.member + 1u), _e1737.member_1);
                                                                phi_2424_ = type_4(1u, _e1737.member);
                                                            } else {
                                                                phi_2399_ = _e1737;
                                                                phi_2424_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1752 = phi_2399_;
                                                            let _e1754 = phi_2424_;
                                                            let _e1758 = (bitcast<i32>(_e1754.member) != 0i);
                                                            if _e1758 {
                                                                let _e1759 = (_e1754.member_1 < 8u);
                                                                if _e1759 {
                                                                } else {
                                                                    phi_4275_ = true;
                                                                    break;
                                                                }
                                                                let _e1764 = local_9[_e1754.member_1].member;
                                                                if (_e1739.member < _e1764) {
                                                                    phi_2457_ = true;
                                                                } else {
                                                                    let _e1766 = local_9[_e1754.member_1].member;
                                                                    if (_e1739.member == _e1766) {
                                                                        let _e1771 = local_9[_e1754.member_1].member_3;
                                                                        phi_2456_ = (_e1739.member_3 < _e1771);
                                                                    } else {
                                                                        phi_2456_ = false;
                                                                    }
                                                                    let _e1774 = phi_2456_;
                                                                    phi_2457_ = _e1774;
                                                                }
                                                                let _e1776 = phi_2457_;
                                                                if _e1776 {
                                                                    if _e1759 {
                                                                    } else {
                                                                        phi_4275_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1777 = local_9[_e1754.member_1];
                                                                    local_9[_e1754.member_1] = type_21(_e1739.member, _e1739.member_1, _e1739.member_2, _e1739.member_3);
                                                                    phi_2478_ = type_21(_e1777.member, _e1777.member_1, _e1777.member_2, _e1777.member_3);
                                                                } else {
                                                                    phi_2478_ = _e1739;
                                                                }
                                                                let _e1788 = phi_2478_;
                                                                phi_2402_ = _e1788;
                                                            } else {
                                                                phi_2402_ = type_21();
                                                            }
                                                            let _e1790 = phi_2402_;
                                                            continue;
                                                            continuing {
                                                                phi_2398_ = _e1752;
                                                                phi_2401_ = _e1790;
                                                                phi_4275_ = _e1172;
                                                                break if !(_e1758);
                                                            }
                                                        }
                                                        let _e1793 = phi_4275_;
                                                        phi_4588_ = _e1174;
                                                        phi_4435_ = _e1793;
                                                        if _e1793 {
                                                            break;
                                                        }
                                                        let _e1796 = local_9[7u].member_3;
                                                        if (_e1796 != 4294967295u) {
                                                            let _e1800 = local_9[7u].member;
                                                            phi_4679_ = _e1800;
                                                        } else {
                                                            phi_4679_ = _e1174;
                                                        }
                                                        let _e1802 = phi_4679_;
                                                        phi_4678_ = _e1802;
                                                        phi_4438_ = _e1793;
                                                    } else {
                                                        phi_4678_ = _e1174;
                                                        phi_4438_ = _e1172;
                                                    }
                                                    let _e1804 = phi_4678_;
                                                    let _e1806 = phi_4438_;
                                                    phi_4677_ = _e1804;
                                                    phi_4437_ = _e1806;
                                                } else {
                                                    phi_4677_ = _e1174;
                                                    phi_4437_ = _e1172;
                                                }
                                                let _e1808 = phi_4677_;
                                                let _e1810 = phi_4437_;
                                                phi_4676_ = _e1808;
                                                phi_4436_ = _e1810;
                                            } else {
                                                phi_4676_ = _e1174;
                                                phi_4436_ = _e1172;
                                            }
                                            let _e1812 = phi_4676_;
                                            let _e1814 = phi_4436_;
                                            continue;
                                            continuing {
                                                phi_4284_ = _e1814;
                                                phi_4274_ = _e1812;
                                                phi_1349_ = _e1189;
                                                phi_4588_ = _e1812;
                                                phi_4435_ = _e1814;
                                                break if !(_e1195);
                                            }
                                        }
                                        let _e1817 = phi_4588_;
                                        let _e1819 = phi_4435_;
                                        phi_4440_ = _e1819;
                                        if _e1819 {
                                            break;
                                        }
                                        phi_4553_ = _e1817;
                                        phi_4444_ = _e1819;
                                        phi_3726_ = false;
                                        phi_3727_ = _e703;
                                        phi_3728_ = _e705;
                                    } else {
                                        if (_e705.member_1 >= _e95) {
                                            phi_3260_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e705.member_1 < _e95) {
                                            } else {
                                                phi_4440_ = true;
                                                break;
                                            }
                                            let _e716 = (_e265 * 2u);
                                            let _e718 = ((1u + _e716) % 7u);
                                            if (_e718 < 7u) {
                                            } else {
                                                phi_4440_ = true;
                                                break;
                                            }
                                            let _e723 = global_5.member[_e705.member_1][_e718];
                                            let _e725 = ((_e716 + 2u) % 7u);
                                            if (_e725 < 7u) {
                                            } else {
                                                phi_4440_ = true;
                                                break;
                                            }
                                            let _e730 = global_5.member[_e705.member_1][_e725];
                                            let _e731 = (_e264 * 2u);
                                            let _e733 = ((1u + _e731) % 7u);
                                            if (_e733 < 7u) {
                                            } else {
                                                phi_4440_ = true;
                                                break;
                                            }
                                            let _e738 = global_5.member[_e705.member_1][_e733];
                                            let _e740 = ((_e731 + 2u) % 7u);
                                            if (_e740 < 7u) {
                                            } else {
                                                phi_4440_ = true;
                                                break;
                                            }
                                            let _e745 = global_5.member[_e705.member_1][_e740];
                                            let _e746 = (_e266 * 2u);
                                            let _e748 = ((1u + _e746) % 7u);
                                            if (_e748 < 7u) {
                                            } else {
                                                phi_4440_ = true;
                                                break;
                                            }
                                            let _e753 = global_5.member[_e705.member_1][_e748];
                                            let _e755 = ((_e746 + 2u) % 7u);
                                            if (_e755 < 7u) {
                                            } else {
                                                phi_4440_ = true;
                                                break;
                                            }
                                            let _e760 = global_5.member[_e705.member_1][_e755];
                                            let _e783 = (bitcast<f32>((bitcast<u32>((_e705.member.member_1.x - _e705.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e784 = (bitcast<f32>((bitcast<u32>((_e705.member.member_1.y - _e705.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e785 = (bitcast<f32>((bitcast<u32>((_e705.member.member_1.z - _e705.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e787 = select(_e145, _e783, (_e783 > _e145));
                                            let _e789 = select(_e145, _e784, (_e784 > _e145));
                                            let _e791 = select(_e145, _e785, (_e785 > _e145));
                                            let _e822 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e723 & 2097151u))) - 8388608f) * _e787));
                                            let _e827 = (bitcast<i32>((_e723 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e830 = bitcast<f32>((_e822 & bitcast<u32>(_e827)));
                                            let _e831 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e738 & 2097151u))) - 8388608f) * _e789));
                                            let _e836 = (bitcast<i32>((_e738 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e839 = bitcast<f32>((_e831 & bitcast<u32>(_e836)));
                                            let _e840 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e753 & 2097151u))) - 8388608f) * _e791));
                                            let _e845 = (bitcast<i32>((_e753 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e848 = bitcast<f32>((_e840 & bitcast<u32>(_e845)));
                                            let _e852 = bitcast<f32>((_e822 & bitcast<u32>(~(_e827))));
                                            let _e856 = bitcast<f32>((_e831 & bitcast<u32>(~(_e836))));
                                            let _e860 = bitcast<f32>((_e840 & bitcast<u32>(~(_e845))));
                                            let _e861 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e730 & 2097151u))) - 8388608f) * _e787));
                                            let _e866 = (bitcast<i32>((_e730 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e869 = bitcast<f32>((_e861 & bitcast<u32>(_e866)));
                                            let _e870 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e745 & 2097151u))) - 8388608f) * _e789));
                                            let _e875 = (bitcast<i32>((_e745 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e878 = bitcast<f32>((_e870 & bitcast<u32>(_e875)));
                                            let _e879 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e760 & 2097151u))) - 8388608f) * _e791));
                                            let _e884 = (bitcast<i32>((_e760 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e887 = bitcast<f32>((_e879 & bitcast<u32>(_e884)));
                                            let _e891 = bitcast<f32>((_e861 & bitcast<u32>(~(_e866))));
                                            let _e895 = bitcast<f32>((_e870 & bitcast<u32>(~(_e875))));
                                            let _e899 = bitcast<f32>((_e879 & bitcast<u32>(~(_e884))));
                                            let _e929 = global_5.member[_e705.member_1][0u];
                                            let _e933 = global_5.member[_e705.member_1][2u];
                                            let _e937 = global_5.member[_e705.member_1][4u];
                                            let _e941 = global_5.member[_e705.member_1][6u];
                                            let _e953 = (((_e933 >> bitcast<u32>(22i)) | ((_e937 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e941 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e954 = (_e929 & 268435455u);
                                            let _e955 = (_e953 & 268435455u);
                                            let _e958 = ((_e929 >> bitcast<u32>(28u)) & 7u);
                                            let _e966 = ((_e929 >> bitcast<u32>(31i)) | (((_e953 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e967 = (_e958 != 0u);
                                            if (_e958 == 0u) {
                                                phi_3222_ = _e954;
                                            } else {
                                                if (_e958 == 7u) {
                                                    phi_3221_ = 2147483648u;
                                                } else {
                                                    phi_3221_ = ((2147483648u | (_e958 << bitcast<u32>(28u))) | (_e955 & 268435455u));
                                                }
                                                let _e976 = phi_3221_;
                                                phi_3222_ = _e976;
                                            }
                                            let _e978 = phi_3222_;
                                            if _e967 {
                                                let _e979 = (_e958 != 7u);
                                                if _e979 {
                                                    phi_3232_ = (_e955 + _e958);
                                                } else {
                                                    phi_3232_ = u32();
                                                }
                                                let _e982 = phi_3232_;
                                                phi_3234_ = _e982;
                                                phi_3235_ = select(true, false, _e979);
                                            } else {
                                                phi_3234_ = u32();
                                                phi_3235_ = true;
                                            }
                                            let _e985 = phi_3234_;
                                            let _e987 = phi_3235_;
                                            if (_e966 == 0u) {
                                                phi_3256_ = (_e954 + select(0u, 1u, !(_e967)));
                                            } else {
                                                if (_e966 == 7u) {
                                                    phi_3255_ = 2147483648u;
                                                } else {
                                                    phi_3255_ = ((2147483648u | (_e966 << bitcast<u32>(28u))) | (select(_e985, _e955, _e987) & 268435455u));
                                                }
                                                let _e1000 = phi_3255_;
                                                phi_3256_ = _e1000;
                                            }
                                            let _e1002 = phi_3256_;
                                            phi_3260_ = type_53(array<vec4<f32>, 3>(vec4<f32>((_e705.member.member.x + _e830), (_e705.member.member.x + _e852), (_e705.member.member_1.x - _e869), (_e705.member.member_1.x - _e891)), vec4<f32>((_e705.member.member.y + _e839), (_e705.member.member.y + _e856), (_e705.member.member_1.y - _e878), (_e705.member.member_1.y - _e895)), vec4<f32>((_e705.member.member.z + _e848), (_e705.member.member.z + _e860), (_e705.member.member_1.z - _e887), (_e705.member.member_1.z - _e899))), type_52(type_25((_e705.member.member + vec4<f32>(_e830, _e839, _e848, 0f)), (_e705.member.member_1 - vec4<f32>(_e869, _e878, _e887, 0f))), _e978), type_52(type_25((_e705.member.member + vec4<f32>(_e852, _e856, _e860, 0f)), (_e705.member.member_1 - vec4<f32>(_e891, _e895, _e899, 0f))), _e1002));
                                        }
                                        let _e1007 = phi_3260_;
                                        let _e1018 = ((_e1007.member[0].x - _e367) * _e372);
                                        let _e1019 = ((_e1007.member[0].y - _e367) * _e372);
                                        let _e1020 = ((_e1007.member[0].z - _e368) * _e372);
                                        let _e1021 = ((_e1007.member[0].w - _e368) * _e372);
                                        let _e1031 = ((_e1007.member[1].x - _e435) * _e440);
                                        let _e1032 = ((_e1007.member[1].y - _e435) * _e440);
                                        let _e1033 = ((_e1007.member[1].z - _e436) * _e440);
                                        let _e1034 = ((_e1007.member[1].w - _e436) * _e440);
                                        let _e1044 = ((_e1007.member[2].x - _e503) * _e508);
                                        let _e1045 = ((_e1007.member[2].y - _e503) * _e508);
                                        let _e1046 = ((_e1007.member[2].z - _e504) * _e508);
                                        let _e1047 = ((_e1007.member[2].w - _e504) * _e508);
                                        let _e1049 = select(_e1046, _e1044, (_e1044 < _e1046));
                                        let _e1051 = select(_e1047, _e1045, (_e1045 < _e1047));
                                        let _e1053 = select(_e1046, _e1044, (_e1044 > _e1046));
                                        let _e1055 = select(_e1047, _e1045, (_e1045 > _e1047));
                                        let _e1057 = select(_e1020, _e1018, (_e1018 < _e1020));
                                        let _e1059 = select(_e1021, _e1019, (_e1019 < _e1021));
                                        let _e1061 = select(_e1033, _e1031, (_e1031 < _e1033));
                                        let _e1063 = select(_e1034, _e1032, (_e1032 < _e1034));
                                        let _e1065 = select(_e1061, _e1057, (_e1057 > _e1061));
                                        let _e1067 = select(_e1063, _e1059, (_e1059 > _e1063));
                                        let _e1069 = select(_e1049, _e1065, (_e1065 > _e1049));
                                        let _e1071 = select(_e1051, _e1067, (_e1067 > _e1051));
                                        let _e1073 = select(_e1020, _e1018, (_e1018 > _e1020));
                                        let _e1075 = select(_e1021, _e1019, (_e1019 > _e1021));
                                        let _e1077 = select(_e1033, _e1031, (_e1031 > _e1033));
                                        let _e1079 = select(_e1034, _e1032, (_e1032 > _e1034));
                                        let _e1081 = select(_e1077, _e1073, (_e1073 < _e1077));
                                        let _e1083 = select(_e1079, _e1075, (_e1075 < _e1079));
                                        let _e1088 = -(_e1049);
                                        let _e1089 = -(_e1051);
                                        let _e1096 = (select(_e1053, _e1081, (_e1081 < _e1053)) + (select(_e1088, _e1053, (_e1053 > _e1088)) * 0.0000019073523f));
                                        let _e1097 = (select(_e1055, _e1083, (_e1083 < _e1055)) + (select(_e1089, _e1055, (_e1055 > _e1089)) * 0.0000019073523f));
                                        let _e1099 = select(_e620, _e1069, (_e1069 > _e620));
                                        let _e1101 = select(_e620, _e1071, (_e1071 > _e620));
                                        let _e1106 = (_e1099 <= select(_e663, _e1096, (_e1096 < _e663)));
                                        let _e1107 = (_e1101 <= select(_e663, _e1097, (_e1097 < _e663)));
                                        let _e1108 = (_e1099 <= _e1101);
                                        if _e1106 {
                                            if _e1107 {
                                                if _e1108 {
                                                    phi_3623_ = _e1007.member_2;
                                                } else {
                                                    phi_3623_ = _e1007.member_1;
                                                }
                                                let _e1112 = phi_3623_;
                                                let _e1134 = (_e703 % 128u);
                                                let _e1135 = (_e1134 < 128u);
                                                if _e1135 {
                                                } else {
                                                    phi_4440_ = true;
                                                    break;
                                                }
                                                local_8[_e1134] = _e1112.member_1;
                                                if _e1135 {
                                                } else {
                                                    phi_4440_ = true;
                                                    break;
                                                }
                                                local_7[_e1134] = _e1112.member.member.x;
                                                if _e1135 {
                                                } else {
                                                    phi_4440_ = true;
                                                    break;
                                                }
                                                local_6[_e1134] = _e1112.member.member.y;
                                                if _e1135 {
                                                } else {
                                                    phi_4440_ = true;
                                                    break;
                                                }
                                                local_5[_e1134] = _e1112.member.member.z;
                                                if _e1135 {
                                                } else {
                                                    phi_4440_ = true;
                                                    break;
                                                }
                                                local_4[_e1134] = _e1112.member.member_1.x;
                                                if _e1135 {
                                                } else {
                                                    phi_4440_ = true;
                                                    break;
                                                }
                                                local_3[_e1134] = _e1112.member.member_1.y;
                                                if _e1135 {
                                                } else {
                                                    phi_4440_ = true;
                                                    break;
                                                }
                                                local_2[_e1134] = _e1112.member.member_1.z;
                                                if _e1135 {
                                                } else {
                                                    phi_4440_ = true;
                                                    break;
                                                }
                                                local_10[_e1134] = select(_e1101, _e1099, !(_e1108));
                                                if _e1108 {
                                                    phi_3700_ = _e1007.member_1;
                                                } else {
                                                    phi_3700_ = _e1007.member_2;
                                                }
                                                let _e1148 = phi_3700_;
                                                phi_3701_ = (_e703 + 1u);
                                                phi_3702_ = _e1148;
                                            } else {
                                                phi_3701_ = u32();
                                                phi_3702_ = type_52();
                                            }
                                            let _e1150 = phi_3701_;
                                            let _e1152 = phi_3702_;
                                            phi_3704_ = _e1150;
                                            phi_3705_ = _e1152;
                                            phi_3706_ = select(true, false, _e1107);
                                        } else {
                                            phi_3704_ = u32();
                                            phi_3705_ = type_52();
                                            phi_3706_ = true;
                                        }
                                        let _e1155 = phi_3704_;
                                        let _e1157 = phi_3705_;
                                        let _e1159 = phi_3706_;
                                        if _e1159 {
                                            if _e1106 {
                                                phi_3715_ = _e1007.member_1;
                                            } else {
                                                phi_3715_ = _e1007.member_2;
                                            }
                                            let _e1163 = phi_3715_;
                                            phi_3720_ = select(_e1107, true, _e1106);
                                            phi_3722_ = _e1163;
                                        } else {
                                            phi_3720_ = _e701;
                                            phi_3722_ = _e1157;
                                        }
                                        let _e1166 = phi_3720_;
                                        let _e1168 = phi_3722_;
                                        phi_4553_ = _e663;
                                        phi_4444_ = _e661;
                                        phi_3726_ = _e1166;
                                        phi_3727_ = select(_e1155, _e703, _e1159);
                                        phi_3728_ = _e1168;
                                    }
                                    let _e1821 = phi_4553_;
                                    let _e1823 = phi_4444_;
                                    let _e1825 = phi_3726_;
                                    let _e1827 = phi_3727_;
                                    let _e1829 = phi_3728_;
                                    phi_4552_ = _e1821;
                                    phi_4443_ = _e1823;
                                    phi_3729_ = _e1825;
                                    phi_3730_ = (_e667 - 1u);
                                    phi_3731_ = _e1827;
                                    phi_3732_ = _e1829;
                                } else {
                                    phi_4552_ = _e663;
                                    phi_4443_ = _e661;
                                    phi_3729_ = _e701;
                                    phi_3730_ = _e667;
                                    phi_3731_ = _e703;
                                    phi_3732_ = _e705;
                                }
                                let _e1831 = phi_4552_;
                                let _e1833 = phi_4443_;
                                let _e1835 = phi_3729_;
                                let _e1837 = phi_3730_;
                                let _e1839 = phi_3731_;
                                let _e1841 = phi_3732_;
                                phi_4551_ = _e1831;
                                phi_4442_ = _e1833;
                                phi_3733_ = _e1835;
                                phi_3734_ = _e1837;
                                phi_3735_ = _e1839;
                                phi_3736_ = _e1841;
                            } else {
                                phi_4551_ = _e663;
                                phi_4442_ = _e661;
                                phi_3733_ = bool();
                                phi_3734_ = u32();
                                phi_3735_ = u32();
                                phi_3736_ = type_52();
                            }
                            let _e1843 = phi_4551_;
                            let _e1845 = phi_4442_;
                            let _e1847 = phi_3733_;
                            let _e1849 = phi_3734_;
                            let _e1851 = phi_3735_;
                            let _e1853 = phi_3736_;
                            phi_4550_ = _e1843;
                            phi_4441_ = _e1845;
                            phi_1225_ = _e1847;
                            phi_1228_ = _e1849;
                            phi_1230_ = _e1851;
                            phi_1232_ = _e1853;
                            phi_3737_ = _e675;
                        } else {
                            phi_4550_ = _e663;
                            phi_4441_ = _e661;
                            phi_1225_ = bool();
                            phi_1228_ = u32();
                            phi_1230_ = u32();
                            phi_1232_ = type_52();
                            phi_3737_ = false;
                        }
                        let _e1855 = phi_4550_;
                        let _e1857 = phi_4441_;
                        let _e1859 = phi_1225_;
                        let _e1861 = phi_1228_;
                        let _e1863 = phi_1230_;
                        let _e1865 = phi_1232_;
                        let _e1867 = phi_3737_;
                        continue;
                        continuing {
                            phi_4287_ = _e1857;
                            phi_4216_ = _e1855;
                            phi_1224_ = _e1859;
                            phi_1227_ = _e1861;
                            phi_1229_ = _e1863;
                            phi_1231_ = _e1865;
                            phi_4440_ = _e1857;
                            break if !(_e1867);
                        }
                    }
                    let _e1870 = phi_4440_;
                    if _e1870 {
                        break;
                    }
                    phi_3744_ = type_4(0u, 8u);
                    loop {
                        let _e1872 = phi_3744_;
                        if (_e1872.member < _e1872.member_1) {
                            phi_3745_ = type_4((_e1872.member + 1u), _e1872.member_1);
                            phi_3768_ = type_4(1u, _e1872.member);
                        } else {
                            phi_3745_ = _e1872;
                            phi_3768_ = type_4(0u, type_4().member_1);
                        }
                        let _e1885 = phi_3745_;
                        let _e1887 = phi_3768_;
                        let _e1891 = (bitcast<i32>(_e1887.member) != 0i);
                        if _e1891 {
                            let _e1892 = (_e1887.member_1 < 8u);
                            if _e1892 {
                            } else {
                                phi_4532_ = true;
                                break;
                            }
                            let _e1894 = local_9[_e1887.member_1];
                            if (_e1894.member_3 != 4294967295u) {
                                let _e1900 = -(_e522);
                                let _e1901 = bitcast<u32>(_e1894.member);
                                let _e1905 = (bitcast<i32>((_e1901 >> bitcast<u32>(23i))) & 255i);
                                let _e1906 = (_e1905 + _e1900);
                                if (_e1905 == 255i) {
                                    phi_3841_ = _e1894.member;
                                } else {
                                    if (_e1905 > 0i) {
                                        if (_e1906 > 0i) {
                                            let _e1910 = (_e1906 < 255i);
                                            if _e1910 {
                                                phi_3820_ = bitcast<f32>((_e1901 + bitcast<u32>((_e1900 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_3820_ = f32();
                                            }
                                            let _e1917 = phi_3820_;
                                            phi_3822_ = _e1917;
                                            phi_3823_ = select(true, false, _e1910);
                                        } else {
                                            phi_3822_ = f32();
                                            phi_3823_ = true;
                                        }
                                        let _e1920 = phi_3822_;
                                        let _e1922 = phi_3823_;
                                        phi_3824_ = _e1920;
                                        phi_3825_ = _e1922;
                                    } else {
                                        phi_3824_ = f32();
                                        phi_3825_ = true;
                                    }
                                    let _e1924 = phi_3824_;
                                    let _e1926 = phi_3825_;
                                    if _e1926 {
                                        let _e1927 = (_e1901 & 2147483648u);
                                        let _e1934 = ((_e1901 & 8388607u) | (select(0u, 1u, ((_e1901 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1938 = (_e1934 == 0u);
                                        if _e1938 {
                                            phi_4162_ = bitcast<f32>(_e1927);
                                        } else {
                                            let _e1943 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1934)), 32u, _e1938) - 8u);
                                            let _e1946 = (_e1934 << bitcast<u32>((_e1943 & 31u)));
                                            let _e1948 = ((_e1906 + select(0i, 1i, (_e1905 == 0i))) - bitcast<i32>(_e1943));
                                            if (_e1948 >= 255i) {
                                                phi_4152_ = bitcast<f32>((_e1927 | 2139095040u));
                                                phi_4153_ = f32();
                                                phi_4154_ = true;
                                            } else {
                                                let _e1950 = (_e1948 > 0i);
                                                if _e1950 {
                                                    phi_4146_ = bitcast<f32>(((_e1927 | (bitcast<u32>(_e1948) << bitcast<u32>(23i))) | (_e1946 & 8388607u)));
                                                    phi_4147_ = f32();
                                                } else {
                                                    if (_e1948 < -24i) {
                                                        phi_4112_ = 26u;
                                                    } else {
                                                        phi_4112_ = bitcast<u32>((1i - _e1948));
                                                    }
                                                    let _e1955 = phi_4112_;
                                                    let _e1956 = (_e1955 & 31u);
                                                    let _e1958 = (_e1946 >> bitcast<u32>(_e1956));
                                                    let _e1962 = (_e1946 & ((1u << bitcast<u32>(_e1956)) - 1u));
                                                    let _e1966 = (1u << bitcast<u32>(((_e1955 - 1u) & 31u)));
                                                    if (_e1962 > _e1966) {
                                                        phi_4133_ = true;
                                                    } else {
                                                        if (_e1962 == _e1966) {
                                                            phi_4130_ = ((_e1958 & 1u) == 1u);
                                                        } else {
                                                            phi_4130_ = false;
                                                        }
                                                        let _e1972 = phi_4130_;
                                                        phi_4133_ = _e1972;
                                                    }
                                                    let _e1974 = phi_4133_;
                                                    phi_4146_ = f32();
                                                    phi_4147_ = bitcast<f32>((_e1927 | (_e1958 + select(0u, 1u, _e1974))));
                                                }
                                                let _e1987 = phi_4146_;
                                                let _e1989 = phi_4147_;
                                                phi_4152_ = _e1987;
                                                phi_4153_ = _e1989;
                                                phi_4154_ = _e1950;
                                            }
                                            let _e1993 = phi_4152_;
                                            let _e1995 = phi_4153_;
                                            let _e1997 = phi_4154_;
                                            phi_4162_ = select(_e1995, _e1993, _e1997);
                                        }
                                        let _e2001 = phi_4162_;
                                        phi_3840_ = _e2001;
                                    } else {
                                        phi_3840_ = _e1924;
                                    }
                                    let _e2003 = phi_3840_;
                                    phi_3841_ = _e2003;
                                }
                                let _e2005 = phi_3841_;
                                let _e2006 = bitcast<u32>(_e2005);
                                if ((_e2006 & 2147483647u) >= 2139095040u) {
                                    phi_3853_ = bitcast<f32>(((_e2006 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_3853_ = _e2005;
                                }
                                let _e2013 = phi_3853_;
                                phi_3858_ = type_21(_e2013, _e1894.member_1, _e1894.member_2, _e1894.member_3);
                            } else {
                                phi_3858_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e2016 = phi_3858_;
                            if _e1892 {
                            } else {
                                phi_4532_ = true;
                                break;
                            }
                            local_9[_e1887.member_1] = type_21(_e2016.member, _e2016.member_1, _e2016.member_2, _e2016.member_3);
                        }
                        continue;
                        continuing {
                            phi_3744_ = _e1885;
                            phi_4532_ = _e1870;
                            break if !(_e1891);
                        }
                    }
                    let _e2024 = phi_4532_;
                    if _e2024 {
                        break;
                    }
                    let _e2025 = local_9;
                    if _e153 {
                    } else {
                        break;
                    }
                    global_6.member[_e151] = array<type_21, 8>(type_21(_e2025[0].member, _e2025[0].member_1, _e2025[0].member_2, _e2025[0].member_3), type_21(_e2025[1].member, _e2025[1].member_1, _e2025[1].member_2, _e2025[1].member_3), type_21(_e2025[2].member, _e2025[2].member_1, _e2025[2].member_2, _e2025[2].member_3), type_21(_e2025[3].member, _e2025[3].member_1, _e2025[3].member_2, _e2025[3].member_3), type_21(_e2025[4].member, _e2025[4].member_1, _e2025[4].member_2, _e2025[4].member_3), type_21(_e2025[5].member, _e2025[5].member_1, _e2025[5].member_2, _e2025[5].member_3), type_21(_e2025[6].member, _e2025[6].member_1, _e2025[6].member_2, _e2025[6].member_3), type_21(_e2025[7].member, _e2025[7].member_1, _e2025[7].member_2, _e2025[7].member_3));
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
