struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: array<array<u32, 4>>,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_37 {
    member: array<type_26>,
}

struct type_41 {
    member: array<array<type_25, 8>>,
}

struct type_47 {
    member: array<vec4<u32>, 2>,
}

struct type_52 {
    member: type_29,
    member_1: u32,
}

struct type_53 {
    member: array<vec4<f32>, 3>,
    member_1: type_52,
    member_2: type_52,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_19;
@group(0) @binding(1) 
var<uniform> global_3: type_47;
@group(0) @binding(2) 
var<storage> global_4: type_9;
@group(0) @binding(4) 
var<storage> global_5: type_37;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_41;

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
    var local_9: array<type_25, 8>;
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
    var phi_2352_: type_25;
    var phi_2354_: type_25;
    var phi_2355_: bool;
    var phi_2359_: type_25;
    var phi_2360_: type_25;
    var phi_2361_: type_25;
    var phi_2362_: bool;
    var phi_2366_: type_25;
    var phi_2367_: bool;
    var phi_2368_: type_25;
    var phi_2369_: bool;
    var phi_2370_: bool;
    var phi_2371_: type_25;
    var phi_2372_: bool;
    var phi_2373_: bool;
    var phi_2381_: type_25;
    var phi_2382_: bool;
    var phi_2386_: type_25;
    var phi_2398_: type_4;
    var phi_2401_: type_25;
    var phi_2399_: type_4;
    var phi_2424_: type_4;
    var phi_2456_: bool;
    var phi_2457_: bool;
    var phi_2478_: type_25;
    var phi_2402_: type_25;
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
    var phi_3858_: type_25;
    var phi_4532_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e95 = global;
            let _e97 = arrayLength((&global_4.member));
            let _e99 = arrayLength((&global_2.member));
            let _e107 = global_3.member[0u][0u];
            let _e111 = global_3.member[0u][1u];
            let _e115 = global_3.member[0u][2u];
            let _e119 = global_3.member[0u][3u];
            let _e123 = global_3.member[1u][0u];
            let _e127 = global_3.member[1u][1u];
            let _e131 = global_3.member[1u][2u];
            let _e134 = global_1.member[0u];
            let _e135 = bitcast<i32>(_e134);
            let _e147 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e119) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e107), bitcast<i32>(_e111), bitcast<i32>(_e115));
            local = array<i32, 3>(bitcast<i32>(_e123), bitcast<i32>(_e127), bitcast<i32>(_e131));
            let _e153 = (_e95.x + (_e95.y * 2097152u));
            let _e154 = (_e153 < arrayLength((&global_5.member)));
            if _e154 {
                let _e155 = (_e153 < arrayLength((&global_6.member)));
                if _e155 {
                    if _e154 {
                    } else {
                        break;
                    }
                    let _e163 = global_5.member[_e153].member_2[0u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_5.member[_e153].member_2[1u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_5.member[_e153].member_2[2u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_5.member[_e153].member[0u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e191 = global_5.member[_e153].member[1u];
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e198 = global_5.member[_e153].member[2u];
                    let _e200 = (bitcast<u32>(_e198) & 2147483647u);
                    let _e202 = select(_e172, _e165, (_e172 < _e165));
                    let _e204 = select(_e179, _e202, (_e179 < _e202));
                    let _e206 = select(_e186, _e204, (_e186 < _e204));
                    let _e208 = select(_e193, _e206, (_e193 < _e206));
                    let _e210 = select(_e200, _e208, (_e200 < _e208));
                    let _e214 = global_5.member[_e153].member_1;
                    let _e215 = bitcast<u32>(_e214);
                    let _e216 = (_e215 & 2147483647u);
                    let _e223 = global_5.member[_e153].member_3;
                    let _e224 = bitcast<u32>(_e223);
                    let _e225 = (_e224 & 2147483647u);
                    let _e229 = (((select(_e216, _e210, (_e216 < _e210)) < 2139095040u) && (_e225 <= 2139095040u)) && (_e204 > 0u));
                    if _e229 {
                        let _e232 = (bitcast<u32>(bitcast<f32>(_e204)) & 2147483647u);
                        if (_e232 >= 8388608u) {
                            phi_480_ = (bitcast<i32>((_e232 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_480_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e232)), 32u, (_e232 == 0u))));
                        }
                        let _e246 = phi_480_;
                        phi_481_ = _e246;
                    } else {
                        phi_481_ = 0i;
                    }
                    let _e248 = phi_481_;
                    let _e249 = (_e165 == _e204);
                    if _e249 {
                        phi_491_ = true;
                    } else {
                        phi_491_ = (_e172 == _e204);
                    }
                    let _e252 = phi_491_;
                    let _e253 = select(1u, 0u, _e249);
                    if _e252 {
                        let _e254 = (_e253 + 1u);
                        phi_501_ = _e254;
                        phi_502_ = _e254;
                        phi_504_ = select(true, false, (_e254 == 2u));
                    } else {
                        phi_501_ = u32();
                        phi_502_ = 0u;
                        phi_504_ = true;
                    }
                    let _e258 = phi_501_;
                    let _e260 = phi_502_;
                    let _e262 = phi_504_;
                    if _e262 {
                        phi_509_ = (_e260 + 1u);
                    } else {
                        phi_509_ = 0u;
                    }
                    let _e266 = phi_509_;
                    let _e267 = select(_e258, _e260, _e262);
                    let _e268 = select(_e253, select(2u, _e253, _e252), _e262);
                    if (_e135 < -126i) {
                        phi_522_ = -126i;
                    } else {
                        phi_522_ = select(_e135, 127i, (_e135 > 127i));
                    }
                    let _e273 = phi_522_;
                    let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                    let _e284 = bitcast<f32>((bitcast<u32>(((_e135 - _e273) + 127i)) << bitcast<u32>(23i)));
                    let _e285 = -(_e248);
                    if (_e285 < -126i) {
                        phi_542_ = -126i;
                    } else {
                        phi_542_ = select(_e285, 127i, (_e285 > 127i));
                    }
                    let _e290 = phi_542_;
                    let _e295 = bitcast<f32>((bitcast<u32>((_e290 + 127i)) << bitcast<u32>(23i)));
                    let _e301 = bitcast<f32>((bitcast<u32>(((_e285 - _e290) + 127i)) << bitcast<u32>(23i)));
                    let _e305 = global_5.member[_e153].member;
                    let _e306 = (_e267 == 0u);
                    if _e306 {
                        phi_560_ = _e305[0];
                    } else {
                        phi_560_ = _e305[1];
                    }
                    let _e310 = phi_560_;
                    let _e311 = (_e267 == 2u);
                    if _e311 {
                        phi_566_ = _e305[2];
                    } else {
                        phi_566_ = _e310;
                    }
                    let _e314 = phi_566_;
                    let _e315 = bitcast<u32>(_e314);
                    let _e317 = ((_e315 & 2139095040u) != 0u);
                    let _e331 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e314, _e317) * _e278) * select(0.00000011920929f, 1f, _e317)) * _e284);
                    let _e332 = global_5.member[_e153].member_2;
                    if _e306 {
                        phi_606_ = _e332[0];
                    } else {
                        phi_606_ = _e332[1];
                    }
                    let _e336 = phi_606_;
                    if _e311 {
                        phi_612_ = _e332[2];
                    } else {
                        phi_612_ = _e336;
                    }
                    let _e339 = phi_612_;
                    let _e340 = bitcast<u32>(_e339);
                    let _e342 = ((_e340 & 2139095040u) != 0u);
                    let _e356 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e340 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e340 & 2147483648u))), _e339, _e342) * _e295) * select(0.00000011920929f, 1f, _e342)) * _e301);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e360 {
                        let _e364 = (bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)) * 0.00000011920929f);
                        phi_664_ = select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f));
                    } else {
                        phi_664_ = 0f;
                    }
                    let _e368 = phi_664_;
                    let _e369 = (_e331 + _e368);
                    let _e370 = (_e331 - _e368);
                    let _e371 = select(_e356, 0f, _e360);
                    if _e360 {
                        phi_676_ = 38685626000000000000000000f;
                    } else {
                        phi_676_ = (1f / _e356);
                    }
                    let _e374 = phi_676_;
                    let _e375 = (_e266 == 0u);
                    if _e375 {
                        phi_685_ = _e305[0];
                    } else {
                        phi_685_ = _e305[1];
                    }
                    let _e379 = phi_685_;
                    let _e380 = (_e266 == 2u);
                    if _e380 {
                        phi_691_ = _e305[2];
                    } else {
                        phi_691_ = _e379;
                    }
                    let _e383 = phi_691_;
                    let _e384 = bitcast<u32>(_e383);
                    let _e386 = ((_e384 & 2139095040u) != 0u);
                    let _e400 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e383, _e386) * _e278) * select(0.00000011920929f, 1f, _e386)) * _e284);
                    if _e375 {
                        phi_731_ = _e332[0];
                    } else {
                        phi_731_ = _e332[1];
                    }
                    let _e404 = phi_731_;
                    if _e380 {
                        phi_737_ = _e332[2];
                    } else {
                        phi_737_ = _e404;
                    }
                    let _e407 = phi_737_;
                    let _e408 = bitcast<u32>(_e407);
                    let _e410 = ((_e408 & 2139095040u) != 0u);
                    let _e424 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e408 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e408 & 2147483648u))), _e407, _e410) * _e295) * select(0.00000011920929f, 1f, _e410)) * _e301);
                    let _e428 = (bitcast<f32>((bitcast<u32>(_e424) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e428 {
                        let _e432 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) * 0.00000011920929f);
                        phi_789_ = select(0.00000000000011368684f, _e432, (_e432 > 0.00000000000011368684f));
                    } else {
                        phi_789_ = 0f;
                    }
                    let _e436 = phi_789_;
                    let _e437 = (_e400 + _e436);
                    let _e438 = (_e400 - _e436);
                    let _e439 = select(_e424, 0f, _e428);
                    if _e428 {
                        phi_801_ = 38685626000000000000000000f;
                    } else {
                        phi_801_ = (1f / _e424);
                    }
                    let _e442 = phi_801_;
                    let _e443 = (_e268 == 0u);
                    if _e443 {
                        phi_810_ = _e305[0];
                    } else {
                        phi_810_ = _e305[1];
                    }
                    let _e447 = phi_810_;
                    let _e448 = (_e268 == 2u);
                    if _e448 {
                        phi_816_ = _e305[2];
                    } else {
                        phi_816_ = _e447;
                    }
                    let _e451 = phi_816_;
                    let _e452 = bitcast<u32>(_e451);
                    let _e454 = ((_e452 & 2139095040u) != 0u);
                    let _e468 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e452 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e452 & 2147483648u))), _e451, _e454) * _e278) * select(0.00000011920929f, 1f, _e454)) * _e284);
                    if _e443 {
                        phi_856_ = _e332[0];
                    } else {
                        phi_856_ = _e332[1];
                    }
                    let _e472 = phi_856_;
                    if _e448 {
                        phi_862_ = _e332[2];
                    } else {
                        phi_862_ = _e472;
                    }
                    let _e475 = phi_862_;
                    let _e476 = bitcast<u32>(_e475);
                    let _e478 = ((_e476 & 2139095040u) != 0u);
                    let _e492 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e476 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e476 & 2147483648u))), _e475, _e478) * _e295) * select(0.00000011920929f, 1f, _e478)) * _e301);
                    let _e496 = (bitcast<f32>((bitcast<u32>(_e492) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e496 {
                        let _e500 = (bitcast<f32>((bitcast<u32>(_e468) & 2147483647u)) * 0.00000011920929f);
                        phi_914_ = select(0.00000000000011368684f, _e500, (_e500 > 0.00000000000011368684f));
                    } else {
                        phi_914_ = 0f;
                    }
                    let _e504 = phi_914_;
                    let _e505 = (_e468 + _e504);
                    let _e506 = (_e468 - _e504);
                    let _e507 = select(_e492, 0f, _e496);
                    if _e496 {
                        phi_926_ = 38685626000000000000000000f;
                    } else {
                        phi_926_ = (1f / _e492);
                    }
                    let _e510 = phi_926_;
                    let _e513 = bitcast<f32>((bitcast<u32>(_e331) & 2147483647u));
                    let _e516 = bitcast<f32>((bitcast<u32>(_e400) & 2147483647u));
                    let _e518 = select(_e516, _e513, (_e513 > _e516));
                    let _e521 = bitcast<f32>((bitcast<u32>(_e468) & 2147483647u));
                    let _e524 = (_e135 + _e248);
                    if (_e229 && (select(_e521, _e518, (_e518 > _e521)) <= 1099511600000f)) {
                        let _e534 = ((_e216 & 8388607u) | (select(0u, 1u, ((_e216 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e537 = bitcast<i32>((_e216 >> bitcast<u32>(23i)));
                        let _e541 = (_e534 == 0u);
                        let _e544 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e534)), 32u, _e541)) - 8i);
                        if (_e537 == 255i) {
                            phi_981_ = 255i;
                        } else {
                            phi_981_ = (((_e537 + select(0i, 1i, (_e537 == 0i))) - _e544) + _e524);
                        }
                        let _e552 = phi_981_;
                        let _e562 = (_e552 <= 0i);
                        if _e562 {
                            phi_1004_ = u32();
                        } else {
                            if _e541 {
                                phi_1003_ = u32();
                            } else {
                                phi_1003_ = select(((bitcast<u32>(_e552) << bitcast<u32>(23i)) | ((_e534 << bitcast<u32>(((_e544 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e552 >= 255i));
                            }
                            let _e566 = phi_1003_;
                            phi_1004_ = _e566;
                        }
                        let _e568 = phi_1004_;
                        let _e580 = ((_e225 & 8388607u) | (select(0u, 1u, ((_e225 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e583 = bitcast<i32>((_e225 >> bitcast<u32>(23i)));
                        let _e587 = (_e580 == 0u);
                        let _e590 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e580)), 32u, _e587)) - 8i);
                        if (_e583 == 255i) {
                            phi_1041_ = 255i;
                        } else {
                            phi_1041_ = (((_e583 + select(0i, 1i, (_e583 == 0i))) - _e590) + _e524);
                        }
                        let _e598 = phi_1041_;
                        let _e608 = (_e598 <= 0i);
                        if _e608 {
                            phi_1064_ = u32();
                        } else {
                            if _e587 {
                                phi_1063_ = u32();
                            } else {
                                phi_1063_ = select(((bitcast<u32>(_e598) << bitcast<u32>(23i)) | ((_e580 << bitcast<u32>(((_e590 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e598 >= 255i));
                            }
                            let _e612 = phi_1063_;
                            phi_1064_ = _e612;
                        }
                        let _e614 = phi_1064_;
                        phi_1072_ = bitcast<f32>(((_e224 & 2147483648u) | select(_e614, 0u, select(_e587, true, _e608))));
                        phi_1073_ = bitcast<f32>(((_e215 & 2147483648u) | select(_e568, 0u, select(_e541, true, _e562))));
                    } else {
                        phi_1072_ = 0f;
                        phi_1073_ = 1f;
                    }
                    let _e620 = phi_1072_;
                    let _e622 = phi_1073_;
                    local_9 = array<type_25, 8>(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e625 = (_e267 % 3u);
                    let _e626 = (_e625 < 3u);
                    if _e626 {
                    } else {
                        break;
                    }
                    let _e628 = local_1[_e625];
                    let _e631 = (_e266 % 3u);
                    let _e632 = (_e631 < 3u);
                    if _e632 {
                    } else {
                        break;
                    }
                    let _e634 = local_1[_e631];
                    let _e637 = (_e268 % 3u);
                    let _e638 = (_e637 < 3u);
                    if _e638 {
                    } else {
                        break;
                    }
                    let _e640 = local_1[_e637];
                    if _e626 {
                    } else {
                        break;
                    }
                    let _e645 = local[_e625];
                    if _e632 {
                    } else {
                        break;
                    }
                    let _e649 = local[_e631];
                    if _e638 {
                    } else {
                        break;
                    }
                    let _e653 = local[_e637];
                    phi_4287_ = false;
                    phi_4216_ = _e620;
                    phi_1224_ = (_e622 <= _e620);
                    phi_1227_ = ((3u * _e97) + 1u);
                    phi_1229_ = 0u;
                    phi_1231_ = type_52(type_29(vec4<f32>((f32(_e628) * _e147), (f32(_e634) * _e147), (f32(_e640) * _e147), 0f), vec4<f32>((f32(_e645) * _e147), (f32(_e649) * _e147), (f32(_e653) * _e147), 0f)), select(0u, 2147483648u, (_e97 == 0u)));
                    loop {
                        let _e663 = phi_4287_;
                        let _e665 = phi_4216_;
                        let _e667 = phi_1224_;
                        let _e669 = phi_1227_;
                        let _e671 = phi_1229_;
                        let _e673 = phi_1231_;
                        if _e667 {
                            phi_1242_ = true;
                        } else {
                            phi_1242_ = (_e671 > 0u);
                        }
                        let _e676 = phi_1242_;
                        if _e676 {
                            let _e677 = (_e669 > 0u);
                            if _e677 {
                                if _e667 {
                                    phi_1329_ = _e667;
                                    phi_1330_ = _e671;
                                    phi_1331_ = _e673;
                                } else {
                                    let _e678 = (_e671 - 1u);
                                    let _e679 = (_e678 % 128u);
                                    let _e680 = (_e679 < 128u);
                                    if _e680 {
                                    } else {
                                        phi_4440_ = true;
                                        break;
                                    }
                                    let _e682 = local_7[_e679];
                                    if _e680 {
                                    } else {
                                        phi_4440_ = true;
                                        break;
                                    }
                                    let _e684 = local_6[_e679];
                                    if _e680 {
                                    } else {
                                        phi_4440_ = true;
                                        break;
                                    }
                                    let _e686 = local_5[_e679];
                                    if _e680 {
                                    } else {
                                        phi_4440_ = true;
                                        break;
                                    }
                                    let _e688 = local_4[_e679];
                                    if _e680 {
                                    } else {
                                        phi_4440_ = true;
                                        break;
                                    }
                                    let _e690 = local_3[_e679];
                                    if _e680 {
                                    } else {
                                        phi_4440_ = true;
                                        break;
                                    }
                                    let _e692 = local_2[_e679];
                                    if _e680 {
                                    } else {
                                        phi_4440_ = true;
                                        break;
                                    }
                                    let _e697 = local_8[_e679];
                                    if _e680 {
                                    } else {
                                        phi_4440_ = true;
                                        break;
                                    }
                                    let _e700 = local_10[_e679];
                                    phi_1329_ = (_e700 <= _e665);
                                    phi_1330_ = _e678;
                                    phi_1331_ = type_52(type_29(vec4<f32>(_e682, _e684, _e686, 0f), vec4<f32>(_e688, _e690, _e692, 0f)), _e697);
                                }
                                let _e703 = phi_1329_;
                                let _e705 = phi_1330_;
                                let _e707 = phi_1331_;
                                if _e703 {
                                    if ((_e707.member_1 & 2147483648u) != 0u) {
                                        phi_4284_ = _e663;
                                        phi_4274_ = _e665;
                                        phi_1349_ = type_4(0u, ((_e707.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1156 = phi_4284_;
                                            let _e1158 = phi_4274_;
                                            let _e1160 = phi_1349_;
                                            if (_e1160.member < _e1160.member_1) {
                                                phi_1350_ = type_4((_e1160.member + 1u), _e1160.member_1);
                                                phi_1373_ = type_4(1u, _e1160.member);
                                            } else {
                                                phi_1350_ = _e1160;
                                                phi_1373_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1173 = phi_1350_;
                                            let _e1175 = phi_1373_;
                                            let _e1179 = (bitcast<i32>(_e1175.member) != 0i);
                                            if _e1179 {
                                                let _e1180 = ((_e707.member_1 & 268435455u) + _e1175.member_1);
                                                let _e1181 = (_e1180 < _e99);
                                                if _e1181 {
                                                    if _e1181 {
                                                    } else {
                                                        phi_4588_ = _e1158;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1185 = global_2.member[_e1180].member_1;
                                                    phi_1394_ = _e1185;
                                                } else {
                                                    phi_1394_ = 4294967295u;
                                                }
                                                let _e1187 = phi_1394_;
                                                if (_e1180 >= _e99) {
                                                    phi_1486_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1181 {
                                                    } else {
                                                        phi_4588_ = _e1158;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    if (_e625 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1158;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1194 = global_2.member[_e1180].member[_e625];
                                                    if (_e631 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1158;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1200 = global_2.member[_e1180].member[_e631];
                                                    if (_e637 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1158;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1206 = global_2.member[_e1180].member[_e637];
                                                    let _e1208 = (3u + _e625);
                                                    if (_e1208 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1158;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1214 = global_2.member[_e1180].member[_e1208];
                                                    let _e1215 = (3u + _e631);
                                                    if (_e1215 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1158;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1221 = global_2.member[_e1180].member[_e1215];
                                                    let _e1222 = (3u + _e637);
                                                    if (_e1222 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1158;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1228 = global_2.member[_e1180].member[_e1222];
                                                    let _e1230 = (6u + _e625);
                                                    if (_e1230 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1158;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1236 = global_2.member[_e1180].member[_e1230];
                                                    let _e1237 = (6u + _e631);
                                                    if (_e1237 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1158;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1243 = global_2.member[_e1180].member[_e1237];
                                                    let _e1244 = (6u + _e637);
                                                    if (_e1244 < 9u) {
                                                    } else {
                                                        phi_4588_ = _e1158;
                                                        phi_4435_ = true;
                                                        break;
                                                    }
                                                    let _e1250 = global_2.member[_e1180].member[_e1244];
                                                    phi_1486_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1194, _e1200, _e1206), array<f32, 3>(_e1214, _e1221, _e1228), array<f32, 3>(_e1236, _e1243, _e1250));
                                                }
                                                let _e1254 = phi_1486_;
                                                let _e1261 = (_e1254[0][2] - _e468);
                                                let _e1264 = (((_e1254[0][0] - _e331) * _e507) - (_e1261 * _e371));
                                                let _e1267 = (((_e1254[0][1] - _e400) * _e507) - (_e1261 * _e439));
                                                let _e1274 = (_e1254[1][2] - _e468);
                                                let _e1277 = (((_e1254[1][0] - _e331) * _e507) - (_e1274 * _e371));
                                                let _e1280 = (((_e1254[1][1] - _e400) * _e507) - (_e1274 * _e439));
                                                let _e1287 = (_e1254[2][2] - _e468);
                                                let _e1290 = (((_e1254[2][0] - _e331) * _e507) - (_e1287 * _e371));
                                                let _e1293 = (((_e1254[2][1] - _e400) * _e507) - (_e1287 * _e439));
                                                let _e1294 = (_e1290 * _e1280);
                                                let _e1295 = (_e1293 * _e1277);
                                                let _e1296 = (_e1264 * _e1293);
                                                let _e1297 = (_e1267 * _e1290);
                                                let _e1298 = (_e1277 * _e1267);
                                                let _e1299 = (_e1280 * _e1264);
                                                let _e1304 = (((_e1294 >= _e1295) && (_e1296 >= _e1297)) && (_e1298 >= _e1299));
                                                if (_e1304 || (((_e1294 <= _e1295) && (_e1296 <= _e1297)) && (_e1298 <= _e1299))) {
                                                    let _e1311 = select(-1f, 1f, _e1304);
                                                    let _e1313 = ((_e1294 - _e1295) * _e1311);
                                                    let _e1315 = select(0f, _e1313, (_e1313 > 0f));
                                                    let _e1317 = ((_e1296 - _e1297) * _e1311);
                                                    let _e1319 = select(0f, _e1317, (_e1317 > 0f));
                                                    let _e1321 = ((_e1298 - _e1299) * _e1311);
                                                    let _e1323 = select(0f, _e1321, (_e1321 > 0f));
                                                    let _e1325 = ((_e1315 + _e1319) + _e1323);
                                                    if (_e1325 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2371_ = type_25();
                                                        phi_2372_ = true;
                                                        phi_2373_ = false;
                                                    } else {
                                                        let _e1328 = select(_e1277, _e1264, (_e1264 < _e1277));
                                                        if (select(_e1290, _e1328, (_e1328 < _e1290)) > 0f) {
                                                            phi_1639_ = true;
                                                        } else {
                                                            let _e1333 = select(_e1277, _e1264, (_e1264 > _e1277));
                                                            phi_1639_ = (select(_e1290, _e1333, (_e1333 > _e1290)) < 0f);
                                                        }
                                                        let _e1338 = phi_1639_;
                                                        if _e1338 {
                                                            phi_2368_ = type_25();
                                                            phi_2369_ = true;
                                                            phi_2370_ = false;
                                                        } else {
                                                            let _e1340 = select(_e1280, _e1267, (_e1267 < _e1280));
                                                            if (select(_e1293, _e1340, (_e1340 < _e1293)) > 0f) {
                                                                phi_1668_ = true;
                                                            } else {
                                                                let _e1345 = select(_e1280, _e1267, (_e1267 > _e1280));
                                                                phi_1668_ = (select(_e1293, _e1345, (_e1345 > _e1293)) < 0f);
                                                            }
                                                            let _e1350 = phi_1668_;
                                                            if _e1350 {
                                                                phi_2366_ = type_25();
                                                                phi_2367_ = false;
                                                            } else {
                                                                let _e1352 = select(_e1254[1][0], _e1254[0][0], (_e1254[0][0] < _e1254[1][0]));
                                                                let _e1356 = select(_e1254[1][0], _e1254[0][0], (_e1254[0][0] > _e1254[1][0]));
                                                                let _e1360 = select(_e1254[1][1], _e1254[0][1], (_e1254[0][1] < _e1254[1][1]));
                                                                let _e1364 = select(_e1254[1][1], _e1254[0][1], (_e1254[0][1] > _e1254[1][1]));
                                                                let _e1368 = select(_e1254[1][2], _e1254[0][2], (_e1254[0][2] < _e1254[1][2]));
                                                                let _e1372 = select(_e1254[1][2], _e1254[0][2], (_e1254[0][2] > _e1254[1][2]));
                                                                let _e1377 = ((select(_e1254[2][0], _e1352, (_e1352 < _e1254[2][0])) - _e369) * _e374);
                                                                let _e1378 = ((select(_e1254[2][0], _e1356, (_e1356 > _e1254[2][0])) - _e370) * _e374);
                                                                let _e1381 = ((select(_e1254[2][1], _e1360, (_e1360 < _e1254[2][1])) - _e437) * _e442);
                                                                let _e1382 = ((select(_e1254[2][1], _e1364, (_e1364 > _e1254[2][1])) - _e438) * _e442);
                                                                let _e1385 = ((select(_e1254[2][2], _e1368, (_e1368 < _e1254[2][2])) - _e505) * _e510);
                                                                let _e1386 = ((select(_e1254[2][2], _e1372, (_e1372 > _e1254[2][2])) - _e506) * _e510);
                                                                let _e1388 = select(_e1386, _e1385, (_e1385 < _e1386));
                                                                let _e1390 = select(_e1386, _e1385, (_e1385 > _e1386));
                                                                let _e1392 = select(_e1378, _e1377, (_e1377 < _e1378));
                                                                let _e1394 = select(_e1382, _e1381, (_e1381 < _e1382));
                                                                let _e1396 = select(_e1394, _e1392, (_e1392 > _e1394));
                                                                let _e1398 = select(_e1388, _e1396, (_e1396 > _e1388));
                                                                let _e1400 = select(_e1378, _e1377, (_e1377 > _e1378));
                                                                let _e1402 = select(_e1382, _e1381, (_e1381 > _e1382));
                                                                let _e1404 = select(_e1402, _e1400, (_e1400 < _e1402));
                                                                let _e1406 = select(_e1390, _e1404, (_e1404 < _e1390));
                                                                let _e1407 = -(_e1388);
                                                                let _e1413 = select(_e622, _e1398, (_e1398 > _e622));
                                                                if (_e1413 > (_e1406 + (select(_e1407, _e1390, (_e1390 > _e1407)) * 0.0000019073523f))) {
                                                                    phi_2361_ = type_25();
                                                                    phi_2362_ = true;
                                                                } else {
                                                                    let _e1415 = (_e1413 > _e1158);
                                                                    if _e1415 {
                                                                        phi_2360_ = type_25();
                                                                    } else {
                                                                        let _e1416 = vec3<f32>(_e1254[0][0], _e1254[0][1], _e1254[0][2]);
                                                                        let _e1417 = vec3<f32>(_e1254[1][0], _e1254[1][1], _e1254[1][2]);
                                                                        let _e1418 = vec3<f32>(_e1254[2][0], _e1254[2][1], _e1254[2][2]);
                                                                        let _e1419 = (_e1254[1][0] - _e1254[0][0]);
                                                                        let _e1420 = (_e1254[1][1] - _e1254[0][1]);
                                                                        let _e1421 = (_e1254[1][2] - _e1254[0][2]);
                                                                        let _e1422 = vec3<f32>(_e1419, _e1420, _e1421);
                                                                        let _e1423 = (_e1254[2][0] - _e1254[1][0]);
                                                                        let _e1424 = (_e1254[2][1] - _e1254[1][1]);
                                                                        let _e1425 = (_e1254[2][2] - _e1254[1][2]);
                                                                        let _e1426 = vec3<f32>(_e1423, _e1424, _e1425);
                                                                        let _e1427 = (_e1254[0][0] - _e1254[2][0]);
                                                                        let _e1428 = (_e1254[0][1] - _e1254[2][1]);
                                                                        let _e1429 = (_e1254[0][2] - _e1254[2][2]);
                                                                        let _e1430 = vec3<f32>(_e1427, _e1428, _e1429);
                                                                        let _e1433 = bitcast<f32>((bitcast<u32>(_e1419) & 2147483647u));
                                                                        let _e1436 = bitcast<f32>((bitcast<u32>(_e1420) & 2147483647u));
                                                                        let _e1438 = select(_e1436, _e1433, (_e1433 > _e1436));
                                                                        let _e1441 = bitcast<f32>((bitcast<u32>(_e1421) & 2147483647u));
                                                                        let _e1443 = select(_e1441, _e1438, (_e1438 > _e1441));
                                                                        let _e1446 = bitcast<f32>((bitcast<u32>(_e1423) & 2147483647u));
                                                                        let _e1449 = bitcast<f32>((bitcast<u32>(_e1424) & 2147483647u));
                                                                        let _e1451 = select(_e1449, _e1446, (_e1446 > _e1449));
                                                                        let _e1454 = bitcast<f32>((bitcast<u32>(_e1425) & 2147483647u));
                                                                        let _e1456 = select(_e1454, _e1451, (_e1451 > _e1454));
                                                                        let _e1459 = bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u));
                                                                        let _e1462 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
                                                                        let _e1464 = select(_e1462, _e1459, (_e1459 > _e1462));
                                                                        let _e1467 = bitcast<f32>((bitcast<u32>(_e1429) & 2147483647u));
                                                                        let _e1469 = select(_e1467, _e1464, (_e1464 > _e1467));
                                                                        let _e1471 = select(_e1456, _e1443, (_e1443 > _e1456));
                                                                        let _e1473 = select(_e1469, _e1471, (_e1471 > _e1469));
                                                                        if (_e1443 == _e1473) {
                                                                            phi_2087_ = _e1280;
                                                                            phi_2088_ = _e1277;
                                                                            phi_2089_ = _e1267;
                                                                            phi_2090_ = _e1264;
                                                                            phi_2091_ = _e1416;
                                                                            phi_2092_ = _e1430;
                                                                            phi_2093_ = _e1426;
                                                                            phi_2094_ = _e1422;
                                                                        } else {
                                                                            let _e1475 = (_e1456 == _e1473);
                                                                            let _e1480 = vec3(_e1475);
                                                                            phi_2087_ = select(_e1267, _e1293, _e1475);
                                                                            phi_2088_ = select(_e1264, _e1290, _e1475);
                                                                            phi_2089_ = select(_e1293, _e1280, _e1475);
                                                                            phi_2090_ = select(_e1290, _e1277, _e1475);
                                                                            phi_2091_ = select(_e1418, _e1417, _e1480);
                                                                            phi_2092_ = select(_e1426, _e1422, _e1480);
                                                                            phi_2093_ = select(_e1422, _e1430, _e1480);
                                                                            phi_2094_ = select(_e1430, _e1426, _e1480);
                                                                        }
                                                                        let _e1486 = phi_2087_;
                                                                        let _e1488 = phi_2088_;
                                                                        let _e1490 = phi_2089_;
                                                                        let _e1492 = phi_2090_;
                                                                        let _e1494 = phi_2091_;
                                                                        let _e1496 = phi_2092_;
                                                                        let _e1498 = phi_2093_;
                                                                        let _e1500 = phi_2094_;
                                                                        let _e1507 = ((_e1498.y * _e1496.z) - (_e1496.y * _e1498.z));
                                                                        let _e1512 = ((_e1498.z * _e1496.x) - (_e1496.z * _e1498.x));
                                                                        let _e1515 = ((_e1498.x * _e1496.y) - (_e1496.x * _e1498.y));
                                                                        if (_e1315 >= _e1319) {
                                                                            phi_2131_ = select(true, false, (_e1315 >= _e1323));
                                                                        } else {
                                                                            phi_2131_ = true;
                                                                        }
                                                                        let _e1520 = phi_2131_;
                                                                        if _e1520 {
                                                                            phi_2140_ = select(_e1418, _e1417, vec3((_e1319 >= _e1323)));
                                                                        } else {
                                                                            phi_2140_ = _e1416;
                                                                        }
                                                                        let _e1525 = phi_2140_;
                                                                        let _e1536 = (((_e1507 * (_e1525.x - _e331)) + (_e1512 * (_e1525.y - _e400))) + (_e1515 * (_e1525.z - _e468)));
                                                                        let _e1541 = (((_e1507 * _e371) + (_e1512 * _e439)) + (_e1515 * _e507));
                                                                        let _e1542 = (_e1488 - _e1492);
                                                                        let _e1543 = (_e1486 - _e1490);
                                                                        let _e1551 = (-(((_e1492 * _e1542) + (_e1490 * _e1543))) / ((_e1542 * _e1542) + (_e1543 * _e1543)));
                                                                        let _e1553 = select(1f, _e1551, (_e1551 < 1f));
                                                                        let _e1555 = select(0f, _e1553, (_e1553 > 0f));
                                                                        let _e1568 = ((_e1494.x + (_e1500.x * _e1555)) - _e331);
                                                                        let _e1569 = ((_e1494.y + (_e1500.y * _e1555)) - _e400);
                                                                        let _e1570 = ((_e1494.z + (_e1500.z * _e1555)) - _e468);
                                                                        let _e1571 = (_e1570 / _e507);
                                                                        let _e1583 = bitcast<f32>((bitcast<u32>(_e1568) & 2147483647u));
                                                                        let _e1586 = bitcast<f32>((bitcast<u32>(_e1569) & 2147483647u));
                                                                        let _e1588 = select(_e1586, _e1583, (_e1583 > _e1586));
                                                                        let _e1591 = bitcast<f32>((bitcast<u32>(_e1570) & 2147483647u));
                                                                        let _e1593 = select(_e1591, _e1588, (_e1588 > _e1591));
                                                                        let _e1599 = bitcast<f32>((bitcast<u32>(_e1507) & 2147483647u));
                                                                        let _e1602 = bitcast<f32>((bitcast<u32>(_e1512) & 2147483647u));
                                                                        let _e1604 = select(_e1602, _e1599, (_e1599 > _e1602));
                                                                        let _e1607 = bitcast<f32>((bitcast<u32>(_e1515) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1507 * _e1568) + (_e1512 * _e1569)) + (_e1515 * _e1570)) - _e1536)) & 2147483647u)) <= ((0.0000009536743f * select(_e1473, _e1593, (_e1593 > _e1473))) * select(_e1607, _e1604, (_e1604 > _e1607)))) {
                                                                            let _e1617 = bitcast<f32>((bitcast<u32>(_e1498.x) & 2147483647u));
                                                                            let _e1620 = bitcast<f32>((bitcast<u32>(_e1498.y) & 2147483647u));
                                                                            let _e1622 = select(_e1620, _e1617, (_e1617 > _e1620));
                                                                            let _e1625 = bitcast<f32>((bitcast<u32>(_e1498.z) & 2147483647u));
                                                                            let _e1631 = bitcast<f32>((bitcast<u32>(_e1496.x) & 2147483647u));
                                                                            let _e1634 = bitcast<f32>((bitcast<u32>(_e1496.y) & 2147483647u));
                                                                            let _e1636 = select(_e1634, _e1631, (_e1631 > _e1634));
                                                                            let _e1639 = bitcast<f32>((bitcast<u32>(_e1496.z) & 2147483647u));
                                                                            let _e1643 = (bitcast<f32>((bitcast<u32>(_e1541) & 2147483647u)) > ((0.0000038146973f * select(_e1625, _e1622, (_e1622 > _e1625))) * select(_e1639, _e1636, (_e1636 > _e1639))));
                                                                            if _e1643 {
                                                                                phi_2305_ = (_e1536 / _e1541);
                                                                            } else {
                                                                                phi_2305_ = f32();
                                                                            }
                                                                            let _e1646 = phi_2305_;
                                                                            phi_2307_ = _e1646;
                                                                            phi_2308_ = select(true, false, _e1643);
                                                                        } else {
                                                                            phi_2307_ = f32();
                                                                            phi_2308_ = true;
                                                                        }
                                                                        let _e1649 = phi_2307_;
                                                                        let _e1651 = phi_2308_;
                                                                        if _e1651 {
                                                                            let _e1659 = (((_e1507 * (_e1568 - (_e371 * _e1571))) + (_e1512 * (_e1569 - (_e439 * _e1571)))) / _e1541);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1659) & 2147483647u)) <= _e1473) {
                                                                                phi_2328_ = (_e1571 + _e1659);
                                                                            } else {
                                                                                phi_2328_ = _e1571;
                                                                            }
                                                                            let _e1666 = phi_2328_;
                                                                            phi_2329_ = _e1666;
                                                                        } else {
                                                                            phi_2329_ = _e1649;
                                                                        }
                                                                        let _e1668 = phi_2329_;
                                                                        let _e1670 = select(_e1406, _e1668, (_e1668 < _e1406));
                                                                        let _e1672 = select(_e1398, _e1670, (_e1670 > _e1398));
                                                                        if (_e1672 >= _e622) {
                                                                            let _e1674 = (_e1672 <= _e1158);
                                                                            if _e1674 {
                                                                                let _e1675 = (1f / _e1325);
                                                                                phi_2352_ = type_25(_e1672, (_e1319 * _e1675), (_e1323 * _e1675), _e1187);
                                                                            } else {
                                                                                phi_2352_ = type_25();
                                                                            }
                                                                            let _e1680 = phi_2352_;
                                                                            phi_2354_ = _e1680;
                                                                            phi_2355_ = select(true, false, _e1674);
                                                                        } else {
                                                                            phi_2354_ = type_25();
                                                                            phi_2355_ = true;
                                                                        }
                                                                        let _e1683 = phi_2354_;
                                                                        let _e1685 = phi_2355_;
                                                                        if _e1685 {
                                                                            phi_2359_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2359_ = _e1683;
                                                                        }
                                                                        let _e1687 = phi_2359_;
                                                                        phi_2360_ = _e1687;
                                                                    }
                                                                    let _e1689 = phi_2360_;
                                                                    phi_2361_ = _e1689;
                                                                    phi_2362_ = _e1415;
                                                                }
                                                                let _e1691 = phi_2361_;
                                                                let _e1693 = phi_2362_;
                                                                phi_2366_ = _e1691;
                                                                phi_2367_ = _e1693;
                                                            }
                                                            let _e1695 = phi_2366_;
                                                            let _e1697 = phi_2367_;
                                                            phi_2368_ = _e1695;
                                                            phi_2369_ = _e1350;
                                                            phi_2370_ = _e1697;
                                                        }
                                                        let _e1699 = phi_2368_;
                                                        let _e1701 = phi_2369_;
                                                        let _e1703 = phi_2370_;
                                                        phi_2371_ = _e1699;
                                                        phi_2372_ = _e1701;
                                                        phi_2373_ = _e1703;
                                                    }
                                                    let _e1705 = phi_2371_;
                                                    let _e1707 = phi_2372_;
                                                    let _e1709 = phi_2373_;
                                                    phi_2381_ = _e1705;
                                                    phi_2382_ = select(_e1709, true, _e1707);
                                                } else {
                                                    phi_2381_ = type_25();
                                                    phi_2382_ = true;
                                                }
                                                let _e1712 = phi_2381_;
                                                let _e1714 = phi_2382_;
                                                if _e1714 {
                                                    phi_2386_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2386_ = _e1712;
                                                }
                                                let _e1716 = phi_2386_;
                                                if (_e1716.member_3 != 4294967295u) {
                                                    if (_e1187 != 4294967295u) {
                                                        phi_2398_ = type_4(0u, 8u);
                                                        phi_2401_ = _e1716;
                                                        loop {
                                                            let _e1721 = phi_2398_;
                                                            let _e1723 = phi_2401_;
                                                            if (_e1721.member < _e1721.member_1) {
                                                                phi_2399_ = type_4((_e1721.member + 1u), _e1721.member_1);
                                                                phi_2424_ = type_4(1u, _e1721.member);
                                                            } else {
                                                                phi_2399_ = _e1721;
                                                                phi_2424_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1736 = phi_2399_;
                                                            let _e1738 = phi_2424_;
                                                            let _e1742 = (bitcast<i32>(_e1738.member) != 0i);
                                                            if _e1742 {
                                                                let _e1743 = (_e1738.member_1 < 8u);
                                                                if _e1743 {
                                                                } else {
                                                                    phi_4275_ = true;
                                                                    break;
                                                                }
                                                                let _e1748 = local_9[_e1738.member_1].member;
                                                                if (_e1723.member < _e1748) {
                                                                    phi_2457_ = true;
                                                                } else {
                                                                    let _e1750 = local_9[_e1738.member_1].member;
                                                                    if (_e1723.member == _e1750) {
                                                                        let _e1755 = local_9[_e1738.member_1].member_3;
                                                                        phi_2456_ = (_e1723.member_3 < _e1755);
                                                                    } else {
                                                                        phi_2456_ = false;
                                                                    }
                                                                    let _e1758 = phi_2456_;
                                                                    phi_2457_ = _e1758;
                                                                }
                                                                let _e1760 = phi_2457_;
                                                                if _e1760 {
                                                                    if _e1743 {
                                                                    } else {
                                                                        phi_4275_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1761 = local_9[_e1738.member_1];
                                                                    local_9[_e1738.member_1] = type_25(_e1723.member, _e1723.member_1, _e1723.member_2, _e1723.member_3);
                                                                    phi_2478_ = type_25(_e1761.member, _e1761.member_1, _e1761.member_2, _e1761.member_3);
                                                                } else {
                                                                    phi_2478_ = _e1723;
                                                                }
                                                                let _e1772 = phi_2478_;
                                                                phi_2402_ = _e1772;
                                                            } else {
                                                                phi_2402_ = type_25();
                                                            }
                                                            let _e1774 = phi_2402_;
                                                            continue;
                                                            continuing {
                                                                phi_2398_ = _e1736;
                                                                phi_2401_ = _e1774;
                                                                phi_4275_ = _e1156;
                                                                break if !(_e1742);
                                                            }
                                                        }
                                                        let _e1777 = phi_4275_;
                                                        phi_4588_ = _e1158;
                                                        phi_4435_ = _e1777;
                                                        if _e1777 {
                                                            break;
                                                        }
                                                        let _e1780 = local_9[7u].member_3;
                                                        if (_e1780 != 4294967295u) {
                                                            let _e1784 = local_9[7u].member;
                                                            phi_4679_ = _e1784;
                                                        } else {
                                                            phi_4679_ = _e1158;
                                                        }
                                                        let _e1786 = phi_4679_;
                                                        phi_4678_ = _e1786;
                                                        phi_4438_ = _e1777;
                                                    } else {
                                                        phi_4678_ = _e1158;
                                                        phi_4438_ = _e1156;
                                                    }
                                                    let _e1788 = phi_4678_;
                                                    let _e1790 = phi_4438_;
                                                    phi_4677_ = _e1788;
                                                    phi_4437_ = _e1790;
                                                } else {
                                                    phi_4677_ = _e1158;
                                                    phi_4437_ = _e1156;
                                                }
                                                let _e1792 = phi_4677_;
                                                let _e1794 = phi_4437_;
                                                phi_4676_ = _e1792;
                                                phi_4436_ = _e1794;
                                            } else {
                                                phi_4676_ = _e1158;
                                                phi_4436_ = _e1156;
                                            }
                                            let _e1796 = phi_4676_;
                                            let _e1798 = phi_4436_;
                                            continue;
                                            continuing {
                                                phi_4284_ = _e1798;
                                                phi_4274_ = _e1796;
                                                phi_1349_ = _e1173;
                                                phi_4588_ = _e1796;
                                                phi_4435_ = _e1798;
                                                break if !(_e1179);
                                            }
                                        }
                                        let _e1801 = phi_4588_;
                                        let _e1803 = phi_4435_;
                                        phi_4440_ = _e1803;
                                        if _e1803 {
                                            break;
                                        }
                                        phi_4553_ = _e1801;
                                        phi_4444_ = _e1803;
                                        phi_3726_ = false;
                                        phi_3727_ = _e705;
                                        phi_3728_ = _e707;
                                    } else {
                                        if (_e707.member_1 >= _e97) {
                                            phi_3260_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e707.member_1 < _e97) {
                                            } else {
                                                phi_4440_ = true;
                                                break;
                                            }
                                            let _e719 = ((1u + _e267) % 4u);
                                            if (_e719 < 4u) {
                                            } else {
                                                phi_4440_ = true;
                                                break;
                                            }
                                            let _e724 = global_4.member[_e707.member_1][_e719];
                                            let _e726 = (_e724 >> bitcast<u32>(11u));
                                            let _e728 = ((1u + _e266) % 4u);
                                            if (_e728 < 4u) {
                                            } else {
                                                phi_4440_ = true;
                                                break;
                                            }
                                            let _e733 = global_4.member[_e707.member_1][_e728];
                                            let _e735 = (_e733 >> bitcast<u32>(11u));
                                            let _e737 = ((1u + _e268) % 4u);
                                            if (_e737 < 4u) {
                                            } else {
                                                phi_4440_ = true;
                                                break;
                                            }
                                            let _e742 = global_4.member[_e707.member_1][_e737];
                                            let _e744 = (_e742 >> bitcast<u32>(11u));
                                            let _e767 = (bitcast<f32>((bitcast<u32>((_e707.member.member_1.x - _e707.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e768 = (bitcast<f32>((bitcast<u32>((_e707.member.member_1.y - _e707.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e769 = (bitcast<f32>((bitcast<u32>((_e707.member.member_1.z - _e707.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e771 = select(_e147, _e767, (_e767 > _e147));
                                            let _e773 = select(_e147, _e768, (_e768 > _e147));
                                            let _e775 = select(_e147, _e769, (_e769 > _e147));
                                            let _e806 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e724 & 1023u))) - 8388608f) * _e771));
                                            let _e811 = (bitcast<i32>((_e724 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e814 = bitcast<f32>((_e806 & bitcast<u32>(_e811)));
                                            let _e815 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e733 & 1023u))) - 8388608f) * _e773));
                                            let _e820 = (bitcast<i32>((_e733 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e823 = bitcast<f32>((_e815 & bitcast<u32>(_e820)));
                                            let _e824 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e742 & 1023u))) - 8388608f) * _e775));
                                            let _e829 = (bitcast<i32>((_e742 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e832 = bitcast<f32>((_e824 & bitcast<u32>(_e829)));
                                            let _e836 = bitcast<f32>((_e806 & bitcast<u32>(~(_e811))));
                                            let _e840 = bitcast<f32>((_e815 & bitcast<u32>(~(_e820))));
                                            let _e844 = bitcast<f32>((_e824 & bitcast<u32>(~(_e829))));
                                            let _e845 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e726 & 1023u))) - 8388608f) * _e771));
                                            let _e850 = (bitcast<i32>((_e726 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e853 = bitcast<f32>((_e845 & bitcast<u32>(_e850)));
                                            let _e854 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e735 & 1023u))) - 8388608f) * _e773));
                                            let _e859 = (bitcast<i32>((_e735 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e862 = bitcast<f32>((_e854 & bitcast<u32>(_e859)));
                                            let _e863 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e744 & 1023u))) - 8388608f) * _e775));
                                            let _e868 = (bitcast<i32>((_e744 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e871 = bitcast<f32>((_e863 & bitcast<u32>(_e868)));
                                            let _e875 = bitcast<f32>((_e845 & bitcast<u32>(~(_e850))));
                                            let _e879 = bitcast<f32>((_e854 & bitcast<u32>(~(_e859))));
                                            let _e883 = bitcast<f32>((_e863 & bitcast<u32>(~(_e868))));
                                            let _e913 = global_4.member[_e707.member_1][0u];
                                            let _e917 = global_4.member[_e707.member_1][1u];
                                            let _e921 = global_4.member[_e707.member_1][2u];
                                            let _e925 = global_4.member[_e707.member_1][3u];
                                            let _e937 = (((_e917 >> bitcast<u32>(22i)) | ((_e921 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e925 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e938 = (_e913 & 268435455u);
                                            let _e939 = (_e937 & 268435455u);
                                            let _e942 = ((_e913 >> bitcast<u32>(28u)) & 7u);
                                            let _e950 = ((_e913 >> bitcast<u32>(31i)) | (((_e937 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e951 = (_e942 != 0u);
                                            if (_e942 == 0u) {
                                                phi_3222_ = _e938;
                                            } else {
                                                if (_e942 == 7u) {
                                                    phi_3221_ = 2147483648u;
                                                } else {
                                                    phi_3221_ = ((2147483648u | (_e942 << bitcast<u32>(28u))) | (_e939 & 268435455u));
                                                }
                                                let _e960 = phi_3221_;
                                                phi_3222_ = _e960;
                                            }
                                            let _e962 = phi_3222_;
                                            if _e951 {
                                                let _e963 = (_e942 != 7u);
                                                if _e963 {
                                                    phi_3232_ = (_e939 + _e942);
                                                } else {
                                                    phi_3232_ = u32();
                                                }
                                                let _e966 = phi_3232_;
                                                phi_3234_ = _e966;
                                                phi_3235_ = select(true, false, _e963);
                                            } else {
                                                phi_3234_ = u32();
                                                phi_3235_ = true;
                                            }
                                            let _e969 = phi_3234_;
                                            let _e971 = phi_3235_;
                                            if (_e950 == 0u) {
                                                phi_3256_ = (_e938 + select(0u, 1u, !(_e951)));
                                            } else {
                                                if (_e950 == 7u) {
                                                    phi_3255_ = 2147483648u;
                                                } else {
                                                    phi_3255_ = ((2147483648u | (_e950 << bitcast<u32>(28u))) | (select(_e969, _e939, _e971) & 268435455u));
                                                }
                                                let _e984 = phi_3255_;
                                                phi_3256_ = _e984;
                                            }
                                            let _e986 = phi_3256_;
                                            phi_3260_ = type_53(array<vec4<f32>, 3>(vec4<f32>((_e707.member.member.x + _e814), (_e707.member.member.x + _e836), (_e707.member.member_1.x - _e853), (_e707.member.member_1.x - _e875)), vec4<f32>((_e707.member.member.y + _e823), (_e707.member.member.y + _e840), (_e707.member.member_1.y - _e862), (_e707.member.member_1.y - _e879)), vec4<f32>((_e707.member.member.z + _e832), (_e707.member.member.z + _e844), (_e707.member.member_1.z - _e871), (_e707.member.member_1.z - _e883))), type_52(type_29((_e707.member.member + vec4<f32>(_e814, _e823, _e832, 0f)), (_e707.member.member_1 - vec4<f32>(_e853, _e862, _e871, 0f))), _e962), type_52(type_29((_e707.member.member + vec4<f32>(_e836, _e840, _e844, 0f)), (_e707.member.member_1 - vec4<f32>(_e875, _e879, _e883, 0f))), _e986));
                                        }
                                        let _e991 = phi_3260_;
                                        let _e1002 = ((_e991.member[0].x - _e369) * _e374);
                                        let _e1003 = ((_e991.member[0].y - _e369) * _e374);
                                        let _e1004 = ((_e991.member[0].z - _e370) * _e374);
                                        let _e1005 = ((_e991.member[0].w - _e370) * _e374);
                                        let _e1015 = ((_e991.member[1].x - _e437) * _e442);
                                        let _e1016 = ((_e991.member[1].y - _e437) * _e442);
                                        let _e1017 = ((_e991.member[1].z - _e438) * _e442);
                                        let _e1018 = ((_e991.member[1].w - _e438) * _e442);
                                        let _e1028 = ((_e991.member[2].x - _e505) * _e510);
                                        let _e1029 = ((_e991.member[2].y - _e505) * _e510);
                                        let _e1030 = ((_e991.member[2].z - _e506) * _e510);
                                        let _e1031 = ((_e991.member[2].w - _e506) * _e510);
                                        let _e1033 = select(_e1030, _e1028, (_e1028 < _e1030));
                                        let _e1035 = select(_e1031, _e1029, (_e1029 < _e1031));
                                        let _e1037 = select(_e1030, _e1028, (_e1028 > _e1030));
                                        let _e1039 = select(_e1031, _e1029, (_e1029 > _e1031));
                                        let _e1041 = select(_e1004, _e1002, (_e1002 < _e1004));
                                        let _e1043 = select(_e1005, _e1003, (_e1003 < _e1005));
                                        let _e1045 = select(_e1017, _e1015, (_e1015 < _e1017));
                                        let _e1047 = select(_e1018, _e1016, (_e1016 < _e1018));
                                        let _e1049 = select(_e1045, _e1041, (_e1041 > _e1045));
                                        let _e1051 = select(_e1047, _e1043, (_e1043 > _e1047));
                                        let _e1053 = select(_e1033, _e1049, (_e1049 > _e1033));
                                        let _e1055 = select(_e1035, _e1051, (_e1051 > _e1035));
                                        let _e1057 = select(_e1004, _e1002, (_e1002 > _e1004));
                                        let _e1059 = select(_e1005, _e1003, (_e1003 > _e1005));
                                        let _e1061 = select(_e1017, _e1015, (_e1015 > _e1017));
                                        let _e1063 = select(_e1018, _e1016, (_e1016 > _e1018));
                                        let _e1065 = select(_e1061, _e1057, (_e1057 < _e1061));
                                        let _e1067 = select(_e1063, _e1059, (_e1059 < _e1063));
                                        let _e1072 = -(_e1033);
                                        let _e1073 = -(_e1035);
                                        let _e1080 = (select(_e1037, _e1065, (_e1065 < _e1037)) + (select(_e1072, _e1037, (_e1037 > _e1072)) * 0.0000019073523f));
                                        let _e1081 = (select(_e1039, _e1067, (_e1067 < _e1039)) + (select(_e1073, _e1039, (_e1039 > _e1073)) * 0.0000019073523f));
                                        let _e1083 = select(_e622, _e1053, (_e1053 > _e622));
                                        let _e1085 = select(_e622, _e1055, (_e1055 > _e622));
                                        let _e1090 = (_e1083 <= select(_e665, _e1080, (_e1080 < _e665)));
                                        let _e1091 = (_e1085 <= select(_e665, _e1081, (_e1081 < _e665)));
                                        let _e1092 = (_e1083 <= _e1085);
                                        if _e1090 {
                                            if _e1091 {
                                                if _e1092 {
                                                    phi_3623_ = _e991.member_2;
                                                } else {
                                                    phi_3623_ = _e991.member_1;
                                                }
                                                let _e1096 = phi_3623_;
                                                let _e1118 = (_e705 % 128u);
                                                let _e1119 = (_e1118 < 128u);
                                                if _e1119 {
                                                } else {
                                                    phi_4440_ = true;
                                                    break;
                                                }
                                                local_8[_e1118] = _e1096.member_1;
                                                if _e1119 {
                                                } else {
                                                    phi_4440_ = true;
                                                    break;
                                                }
                                                local_7[_e1118] = _e1096.member.member.x;
                                                if _e1119 {
                                                } else {
                                                    phi_4440_ = true;
                                                    break;
                                                }
                                                local_6[_e1118] = _e1096.member.member.y;
                                                if _e1119 {
                                                } else {
                                                    phi_4440_ = true;
                                                    break;
                                                }
                                                local_5[_e1118] = _e1096.member.member.z;
                                                if _e1119 {
                                                } else {
                                                    phi_4440_ = true;
                                                    break;
                                                }
                                                local_4[_e1118] = _e1096.member.member_1.x;
                                                if _e1119 {
                                                } else {
                                                    phi_4440_ = true;
                                                    break;
                                                }
                                                local_3[_e1118] = _e1096.member.member_1.y;
                                                if _e1119 {
                                                } else {
                                                    phi_4440_ = true;
                                                    break;
                                                }
                                                local_2[_e1118] = _e1096.member.member_1.z;
                                                if _e1119 {
                                                } else {
                                                    phi_4440_ = true;
                                                    break;
                                                }
                                                local_10[_e1118] = select(_e1085, _e1083, !(_e1092));
                                                if _e1092 {
                                                    phi_3700_ = _e991.member_1;
                                                } else {
                                                    phi_3700_ = _e991.member_2;
                                                }
                                                let _e1132 = phi_3700_;
                                                phi_3701_ = (_e705 + 1u);
                                                phi_3702_ = _e1132;
                                            } else {
                                                phi_3701_ = u32();
                                                phi_3702_ = type_52();
                                            }
                                            let _e1134 = phi_3701_;
                                            let _e1136 = phi_3702_;
                                            phi_3704_ = _e1134;
                                            phi_3705_ = _e1136;
                                            phi_3706_ = select(true, false, _e1091);
                                        } else {
                                            phi_3704_ = u32();
                                            phi_3705_ = type_52();
                                            phi_3706_ = true;
                                        }
                                        let _e1139 = phi_3704_;
                                        let _e1141 = phi_3705_;
                                        let _e1143 = phi_3706_;
                                        if _e1143 {
                                            if _e1090 {
                                                phi_3715_ = _e991.member_1;
                                            } else {
                                                phi_3715_ = _e991.member_2;
                                            }
                                            let _e1147 = phi_3715_;
                                            phi_3720_ = select(_e1091, true, _e1090);
                                            phi_3722_ = _e1147;
                                        } else {
                                            phi_3720_ = _e703;
                                            phi_3722_ = _e1141;
                                        }
                                        let _e1150 = phi_3720_;
                                        let _e1152 = phi_3722_;
                                        phi_4553_ = _e665;
                                        phi_4444_ = _e663;
                                        phi_3726_ = _e1150;
                                        phi_3727_ = select(_e1139, _e705, _e1143);
                                        phi_3728_ = _e1152;
                                    }
                                    let _e1805 = phi_4553_;
                                    let _e1807 = phi_4444_;
                                    let _e1809 = phi_3726_;
                                    let _e1811 = phi_3727_;
                                    let _e1813 = phi_3728_;
                                    phi_4552_ = _e1805;
                                    phi_4443_ = _e1807;
                                    phi_3729_ = _e1809;
                                    phi_3730_ = (_e669 - 1u);
                                    phi_3731_ = _e1811;
                                    phi_3732_ = _e1813;
                                } else {
                                    phi_4552_ = _e665;
                                    phi_4443_ = _e663;
                                    phi_3729_ = _e703;
                                    phi_3730_ = _e669;
                                    phi_3731_ = _e705;
                                    phi_3732_ = _e707;
                                }
                                let _e1815 = phi_4552_;
                                let _e1817 = phi_4443_;
                                let _e1819 = phi_3729_;
                                let _e1821 = phi_3730_;
                                let _e1823 = phi_3731_;
                                let _e1825 = phi_3732_;
                                phi_4551_ = _e1815;
                                phi_4442_ = _e1817;
                                phi_3733_ = _e1819;
                                phi_3734_ = _e1821;
                                phi_3735_ = _e1823;
                                phi_3736_ = _e1825;
                            } else {
                                phi_4551_ = _e665;
                                phi_4442_ = _e663;
                                phi_3733_ = bool();
                                phi_3734_ = u32();
                                phi_3735_ = u32();
                                phi_3736_ = type_52();
                            }
                            let _e1827 = phi_4551_;
                            let _e1829 = phi_4442_;
                            let _e1831 = phi_3733_;
                            let _e1833 = phi_3734_;
                            let _e1835 = phi_3735_;
                            let _e1837 = phi_3736_;
                            phi_4550_ = _e1827;
                            phi_4441_ = _e1829;
                            phi_1225_ = _e1831;
                            phi_1228_ = _e1833;
                            phi_1230_ = _e1835;
                            phi_1232_ = _e1837;
                            phi_3737_ = _e677;
                        } else {
                            phi_4550_ = _e665;
                            phi_4441_ = _e663;
                            phi_1225_ = bool();
                            phi_1228_ = u32();
                            phi_1230_ = u32();
                            phi_1232_ = type_52();
                            phi_3737_ = false;
                        }
                        let _e1839 = phi_4550_;
                        let _e1841 = phi_4441_;
                        let _e1843 = phi_1225_;
                        let _e1845 = phi_1228_;
                        let _e1847 = phi_1230_;
                        let _e1849 = phi_1232_;
                        let _e1851 = phi_3737_;
                        continue;
                        continuing {
                            phi_4287_ = _e1841;
                            phi_4216_ = _e1839;
                            phi_1224_ = _e1843;
                            phi_1227_ = _e1845;
                            phi_1229_ = _e1847;
                            phi_1231_ = _e1849;
                            phi_4440_ = _e1841;
                            break if !(_e1851);
                        }
                    }
                    let _e1854 = phi_4440_;
                    if _e1854 {
                        break;
                    }
                    phi_3744_ = type_4(0u, 8u);
                    loop {
                        let _e1856 = phi_3744_;
                        if (_e1856.member < _e1856.member_1) {
                            phi_3745_ = type_4((_e1856.member + 1u), _e1856.member_1);
                            phi_3768_ = type_4(1u, _e1856.member);
                        } else {
                            phi_3745_ = _e1856;
                            phi_3768_ = type_4(0u, type_4().member_1);
                        }
                        let _e1869 = phi_3745_;
                        let _e1871 = phi_3768_;
                        let _e1875 = (bitcast<i32>(_e1871.member) != 0i);
                        if _e1875 {
                            let _e1876 = (_e1871.member_1 < 8u);
                            if _e1876 {
                            } else {
                                phi_4532_ = true;
                                break;
                            }
                            let _e1878 = local_9[_e1871.member_1];
                            if (_e1878.member_3 != 4294967295u) {
                                let _e1884 = -(_e524);
                                let _e1885 = bitcast<u32>(_e1878.member);
                                let _e1889 = (bitcast<i32>((_e1885 >> bitcast<u32>(23i))) & 255i);
                                let _e1890 = (_e1889 + _e1884);
                                if (_e1889 == 255i) {
                                    phi_3841_ = _e1878.member;
                                } else {
                                    if (_e1889 > 0i) {
                                        if (_e1890 > 0i) {
                                            let _e1894 = (_e1890 < 255i);
                                            if _e1894 {
                                                phi_3820_ = bitcast<f32>((_e1885 + bitcast<u32>((_e1884 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_3820_ = f32();
                                            }
                                            let _e1901 = phi_3820_;
                                            phi_3822_ = _e1901;
                                            phi_3823_ = select(true, false, _e1894);
                                        } else {
                                            phi_3822_ = f32();
                                            phi_3823_ = true;
                                        }
                                        let _e1904 = phi_3822_;
                                        let _e1906 = phi_3823_;
                                        phi_3824_ = _e1904;
                                        phi_3825_ = _e1906;
                                    } else {
                                        phi_3824_ = f32();
                                        phi_3825_ = true;
                                    }
                                    let _e1908 = phi_3824_;
                                    let _e1910 = phi_3825_;
                                    if _e1910 {
                                        let _e1911 = (_e1885 & 2147483648u);
                                        let _e1918 = ((_e1885 & 8388607u) | (select(0u, 1u, ((_e1885 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1922 = (_e1918 == 0u);
                                        if _e1922 {
                                            phi_4162_ = bitcast<f32>(_e1911);
                                        } else {
                                            let _e1927 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1918)), 32u, _e1922) - 8u);
                                            let _e1930 = (_e1918 << bitcast<u32>((_e1927 & 31u)));
                                            let _e1932 = ((_e1890 + select(0i, 1i, (_e1889 == 0i))) - bitcast<i32>(_e1927));
                                            if (_e1932 >= 255i) {
                                                phi_4152_ = bitcast<f32>((_e1911 | 2139095040u));
                                                phi_4153_ = f32();
                                                phi_4154_ = true;
                                            } else {
                                                let _e1934 = (_e1932 > 0i);
                                                if _e1934 {
                                                    phi_4146_ = bitcast<f32>(((_e1911 | (bitcast<u32>(_e1932) << bitcast<u32>(23i))) | (_e1930 & 8388607u)));
                                                    phi_4147_ = f32();
                                                } else {
                                                    if (_e1932 < -24i) {
                                                        phi_4112_ = 26u;
                                                    } else {
                                                        phi_4112_ = bitcast<u32>((1i - _e1932));
                                                    }
                                                    let _e1939 = phi_4112_;
                                                    let _e1940 = (_e1939 & 31u);
                                                    let _e1942 = (_e1930 >> bitcast<u32>(_e1940));
                                                    let _e1946 = (_e1930 & ((1u << bitcast<u32>(_e1940)) - 1u));
                                                    let _e1950 = (1u << bitcast<u32>(((_e1939 - 1u) & 31u)));
                                                    if (_e1946 > _e1950) {
                                                        phi_4133_ = true;
                                                    } else {
                                                        if (_e1946 == _e1950) {
                                                            phi_4130_ = ((_e1942 & 1u) == 1u);
                                                        } else {
                                                            phi_4130_ = false;
                                                        }
                                                        let _e1956 = phi_4130_;
                                                        phi_4133_ = _e1956;
                                                    }
                                                    let _e1958 = phi_4133_;
                                                    phi_4146_ = f32();
                                                    phi_4147_ = bitcast<f32>((_e1911 | (_e1942 + select(0u, 1u, _e1958))));
                                                }
                                                let _e1971 = phi_4146_;
                                                let _e1973 = phi_4147_;
                                                phi_4152_ = _e1971;
                                                phi_4153_ = _e1973;
                                                phi_4154_ = _e1934;
                                            }
                                            let _e1977 = phi_4152_;
                                            let _e1979 = phi_4153_;
                                            let _e1981 = phi_4154_;
                                            phi_4162_ = select(_e1979, _e1977, _e1981);
                                        }
                                        let _e1985 = phi_4162_;
                                        phi_3840_ = _e1985;
                                    } else {
                                        phi_3840_ = _e1908;
                                    }
                                    let _e1987 = phi_3840_;
                                    phi_3841_ = _e1987;
                                }
                                let _e1989 = phi_3841_;
                                let _e1990 = bitcast<u32>(_e1989);
                                if ((_e1990 & 2147483647u) >= 2139095040u) {
                                    phi_3853_ = bitcast<f32>(((_e1990 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_3853_ = _e1989;
                                }
                                let _e1997 = phi_3853_;
                                phi_3858_ = type_25(_e1997, _e1878.member_1, _e1878.member_2, _e1878.member_3);
                            } else {
                                phi_3858_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e2000 = phi_3858_;
                            if _e1876 {
                            } else {
                                phi_4532_ = true;
                                break;
                            }
                            local_9[_e1871.member_1] = type_25(_e2000.member, _e2000.member_1, _e2000.member_2, _e2000.member_3);
                        }
                        continue;
                        continuing {
                            phi_3744_ = _e1869;
                            phi_4532_ = _e1854;
                            break if !(_e1875);
                        }
                    }
                    let _e2008 = phi_4532_;
                    if _e2008 {
                        break;
                    }
                    let _e2009 = local_9;
                    if _e155 {
                    } else {
                        break;
                    }
                    global_6.member[_e153] = array<type_25, 8>(type_25(_e2009[0].member, _e2009[0].member_1, _e2009[0].member_2, _e2009[0].member_3), type_25(_e2009[1].member, _e2009[1].member_1, _e2009[1].member_2, _e2009[1].member_3), type_25(_e2009[2].member, _e2009[2].member_1, _e2009[2].member_2, _e2009[2].member_3), type_25(_e2009[3].member, _e2009[3].member_1, _e2009[3].member_2, _e2009[3].member_3), type_25(_e2009[4].member, _e2009[4].member_1, _e2009[4].member_2, _e2009[4].member_3), type_25(_e2009[5].member, _e2009[5].member_1, _e2009[5].member_2, _e2009[5].member_3), type_25(_e2009[6].member, _e2009[6].member_1, _e2009[6].member_2, _e2009[6].member_3), type_25(_e2009[7].member, _e2009[7].member_1, _e2009[7].member_2, _e2009[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
