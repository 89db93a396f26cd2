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
    var phi_2350_: type_25;
    var phi_2352_: type_25;
    var phi_2353_: bool;
    var phi_2357_: type_25;
    var phi_2358_: type_25;
    var phi_2359_: type_25;
    var phi_2360_: bool;
    var phi_2364_: type_25;
    var phi_2365_: bool;
    var phi_2366_: type_25;
    var phi_2367_: bool;
    var phi_2368_: bool;
    var phi_2369_: type_25;
    var phi_2370_: bool;
    var phi_2371_: bool;
    var phi_2379_: type_25;
    var phi_2380_: bool;
    var phi_2384_: type_25;
    var phi_2396_: type_4;
    var phi_2399_: type_25;
    var phi_2397_: type_4;
    var phi_2422_: type_4;
    var phi_2454_: bool;
    var phi_2455_: bool;
    var phi_2476_: type_25;
    var phi_2400_: type_25;
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
    var phi_3860_: type_25;
    var phi_4629_: bool;

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
                    phi_4236_ = false;
                    phi_4217_ = _e620;
                    phi_1222_ = ((3u * _e97) + 1u);
                    phi_1225_ = (_e622 <= _e620);
                    phi_1227_ = 0u;
                    phi_1229_ = type_52(type_29(vec4<f32>((f32(_e628) * _e147), (f32(_e634) * _e147), (f32(_e640) * _e147), 0f), vec4<f32>((f32(_e645) * _e147), (f32(_e649) * _e147), (f32(_e653) * _e147), 0f)), select(0u, 2147483648u, (_e97 == 0u)));
                    loop {
                        let _e663 = phi_4236_;
                        let _e665 = phi_4217_;
                        let _e667 = phi_1222_;
                        let _e669 = phi_1225_;
                        let _e671 = phi_1227_;
                        let _e673 = phi_1229_;
                        if _e669 {
                            phi_1240_ = true;
                        } else {
                            phi_1240_ = (_e671 > 0u);
                        }
                        let _e676 = phi_1240_;
                        if _e676 {
                            let _e677 = (_e667 > 0u);
                            if _e677 {
                                if _e669 {
                                    phi_1327_ = _e669;
                                    phi_1328_ = _e671;
                                    phi_1329_ = _e673;
                                } else {
                                    let _e678 = (_e671 - 1u);
                                    let _e679 = (_e678 % 128u);
                                    let _e680 = (_e679 < 128u);
                                    if _e680 {
                                    } else {
                                        phi_4535_ = true;
                                        break;
                                    }
                                    let _e682 = local_7[_e679];
                                    if _e680 {
                                    } else {
                                        phi_4535_ = true;
                                        break;
                                    }
                                    let _e684 = local_6[_e679];
                                    if _e680 {
                                    } else {
                                        phi_4535_ = true;
                                        break;
                                    }
                                    let _e686 = local_5[_e679];
                                    if _e680 {
                                    } else {
                                        phi_4535_ = true;
                                        break;
                                    }
                                    let _e688 = local_4[_e679];
                                    if _e680 {
                                    } else {
                                        phi_4535_ = true;
                                        break;
                                    }
                                    let _e690 = local_3[_e679];
                                    if _e680 {
                                    } else {
                                        phi_4535_ = true;
                                        break;
                                    }
                                    let _e692 = local_2[_e679];
                                    if _e680 {
                                    } else {
                                        phi_4535_ = true;
                                        break;
                                    }
                                    let _e697 = local_8[_e679];
                                    if _e680 {
                                    } else {
                                        phi_4535_ = true;
                                        break;
                                    }
                                    let _e700 = local_10[_e679];
                                    phi_1327_ = (_e700 <= _e665);
                                    phi_1328_ = _e678;
                                    phi_1329_ = type_52(type_29(vec4<f32>(_e682, _e684, _e686, 0f), vec4<f32>(_e688, _e690, _e692, 0f)), _e697);
                                }
                                let _e703 = phi_1327_;
                                let _e705 = phi_1328_;
                                let _e707 = phi_1329_;
                                if _e703 {
                                    let _e711 = ((_e707.member_1 & 2147483648u) != 0u);
                                    if _e711 {
                                        phi_4233_ = _e663;
                                        phi_4222_ = _e665;
                                        phi_1347_ = type_4(0u, ((_e707.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e718 = phi_4233_;
                                            let _e720 = phi_4222_;
                                            let _e722 = phi_1347_;
                                            if (_e722.member < _e722.member_1) {
                                                phi_1348_ = type_4((_e722.member + 1u), _e722.member_1);
                                                phi_1371_ = type_4(1u, _e722.member);
                                            } else {
                                                phi_1348_ = _e722;
                                                phi_1371_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e735 = phi_1348_;
                                            let _e737 = phi_1371_;
                                            let _e741 = (bitcast<i32>(_e737.member) != 0i);
                                            if _e741 {
                                                let _e742 = ((_e707.member_1 & 268435455u) + _e737.member_1);
                                                let _e743 = (_e742 < _e99);
                                                if _e743 {
                                                    if _e743 {
                                                    } else {
                                                        phi_4442_ = _e720;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e747 = global_2.member[_e742].member_1;
                                                    phi_1392_ = _e747;
                                                } else {
                                                    phi_1392_ = 4294967295u;
                                                }
                                                let _e749 = phi_1392_;
                                                if (_e742 >= _e99) {
                                                    phi_1484_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e743 {
                                                    } else {
                                                        phi_4442_ = _e720;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    if (_e625 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e720;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e756 = global_2.member[_e742].member[_e625];
                                                    if (_e631 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e720;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e762 = global_2.member[_e742].member[_e631];
                                                    if (_e637 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e720;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e768 = global_2.member[_e742].member[_e637];
                                                    let _e770 = (3u + _e625);
                                                    if (_e770 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e720;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e776 = global_2.member[_e742].member[_e770];
                                                    let _e777 = (3u + _e631);
                                                    if (_e777 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e720;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e783 = global_2.member[_e742].member[_e777];
                                                    let _e784 = (3u + _e637);
                                                    if (_e784 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e720;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e790 = global_2.member[_e742].member[_e784];
                                                    let _e792 = (6u + _e625);
                                                    if (_e792 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e720;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e798 = global_2.member[_e742].member[_e792];
                                                    let _e799 = (6u + _e631);
                                                    if (_e799 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e720;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e805 = global_2.member[_e742].member[_e799];
                                                    let _e806 = (6u + _e637);
                                                    if (_e806 < 9u) {
                                                    } else {
                                                        phi_4442_ = _e720;
                                                        phi_4384_ = true;
                                                        break;
                                                    }
                                                    let _e812 = global_2.member[_e742].member[_e806];
                                                    phi_1484_ = array<array<f32, 3>, 3>(array<f32, 3>(_e756, _e762, _e768), array<f32, 3>(_e776, _e783, _e790), array<f32, 3>(_e798, _e805, _e812));
                                                }
                                                let _e816 = phi_1484_;
                                                let _e823 = (_e816[0][2] - _e468);
                                                let _e826 = (((_e816[0][0] - _e331) * _e507) - (_e823 * _e371));
                                                let _e829 = (((_e816[0][1] - _e400) * _e507) - (_e823 * _e439));
                                                let _e836 = (_e816[1][2] - _e468);
                                                let _e839 = (((_e816[1][0] - _e331) * _e507) - (_e836 * _e371));
                                                let _e842 = (((_e816[1][1] - _e400) * _e507) - (_e836 * _e439));
                                                let _e849 = (_e816[2][2] - _e468);
                                                let _e852 = (((_e816[2][0] - _e331) * _e507) - (_e849 * _e371));
                                                let _e855 = (((_e816[2][1] - _e400) * _e507) - (_e849 * _e439));
                                                let _e856 = (_e852 * _e842);
                                                let _e857 = (_e855 * _e839);
                                                let _e858 = (_e826 * _e855);
                                                let _e859 = (_e829 * _e852);
                                                let _e860 = (_e839 * _e829);
                                                let _e861 = (_e842 * _e826);
                                                let _e866 = (((_e856 >= _e857) && (_e858 >= _e859)) && (_e860 >= _e861));
                                                if (_e866 || (((_e856 <= _e857) && (_e858 <= _e859)) && (_e860 <= _e861))) {
                                                    let _e873 = select(-1f, 1f, _e866);
                                                    let _e875 = ((_e856 - _e857) * _e873);
                                                    let _e877 = select(0f, _e875, (_e875 > 0f));
                                                    let _e879 = ((_e858 - _e859) * _e873);
                                                    let _e881 = select(0f, _e879, (_e879 > 0f));
                                                    let _e883 = ((_e860 - _e861) * _e873);
                                                    let _e885 = select(0f, _e883, (_e883 > 0f));
                                                    let _e887 = ((_e877 + _e881) + _e885);
                                                    if (_e887 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2369_ = type_25();
                                                        phi_2370_ = true;
                                                        phi_2371_ = false;
                                                    } else {
                                                        let _e890 = select(_e839, _e826, (_e826 < _e839));
                                                        if (select(_e852, _e890, (_e890 < _e852)) > 0f) {
                                                            phi_1637_ = true;
                                                        } else {
                                                            let _e895 = select(_e839, _e826, (_e826 > _e839));
                                                            phi_1637_ = (select(_e852, _e895, (_e895 > _e852)) < 0f);
                                                        }
                                                        let _e900 = phi_1637_;
                                                        if _e900 {
                                                            phi_2366_ = type_25();
                                                            phi_2367_ = true;
                                                            phi_2368_ = false;
                                                        } else {
                                                            let _e902 = select(_e842, _e829, (_e829 < _e842));
                                                            if (select(_e855, _e902, (_e902 < _e855)) > 0f) {
                                                                phi_1666_ = true;
                                                            } else {
                                                                let _e907 = select(_e842, _e829, (_e829 > _e842));
                                                                phi_1666_ = (select(_e855, _e907, (_e907 > _e855)) < 0f);
                                                            }
                                                            let _e912 = phi_1666_;
                                                            if _e912 {
                                                                phi_2364_ = type_25();
                                                                phi_2365_ = false;
                                                            } else {
                                                                let _e914 = select(_e816[1][0], _e816[0][0], (_e816[0][0] < _e816[1][0]));
                                                                let _e918 = select(_e816[1][0], _e816[0][0], (_e816[0][0] > _e816[1][0]));
                                                                let _e922 = select(_e816[1][1], _e816[0][1], (_e816[0][1] < _e816[1][1]));
                                                                let _e926 = select(_e816[1][1], _e816[0][1], (_e816[0][1] > _e816[1][1]));
                                                                let _e930 = select(_e816[1][2], _e816[0][2], (_e816[0][2] < _e816[1][2]));
                                                                let _e934 = select(_e816[1][2], _e816[0][2], (_e816[0][2] > _e816[1][2]));
                                                                let _e939 = ((select(_e816[2][0], _e914, (_e914 < _e816[2][0])) - _e369) * _e374);
                                                                let _e940 = ((select(_e816[2][0], _e918, (_e918 > _e816[2][0])) - _e370) * _e374);
                                                                let _e943 = ((select(_e816[2][1], _e922, (_e922 < _e816[2][1])) - _e437) * _e442);
                                                                let _e944 = ((select(_e816[2][1], _e926, (_e926 > _e816[2][1])) - _e438) * _e442);
                                                                let _e947 = ((select(_e816[2][2], _e930, (_e930 < _e816[2][2])) - _e505) * _e510);
                                                                let _e948 = ((select(_e816[2][2], _e934, (_e934 > _e816[2][2])) - _e506) * _e510);
                                                                let _e950 = select(_e948, _e947, (_e947 < _e948));
                                                                let _e952 = select(_e948, _e947, (_e947 > _e948));
                                                                let _e954 = select(_e940, _e939, (_e939 < _e940));
                                                                let _e956 = select(_e944, _e943, (_e943 < _e944));
                                                                let _e958 = select(_e956, _e954, (_e954 > _e956));
                                                                let _e960 = select(_e950, _e958, (_e958 > _e950));
                                                                let _e962 = select(_e940, _e939, (_e939 > _e940));
                                                                let _e964 = select(_e944, _e943, (_e943 > _e944));
                                                                let _e966 = select(_e964, _e962, (_e962 < _e964));
                                                                let _e968 = select(_e952, _e966, (_e966 < _e952));
                                                                let _e969 = -(_e950);
                                                                let _e975 = select(_e622, _e960, (_e960 > _e622));
                                                                if (_e975 > (_e968 + (select(_e969, _e952, (_e952 > _e969)) * 0.0000019073523f))) {
                                                                    phi_2359_ = type_25();
                                                                    phi_2360_ = true;
                                                                } else {
                                                                    let _e977 = (_e975 > _e720);
                                                                    if _e977 {
                                                                        phi_2358_ = type_25();
                                                                    } else {
                                                                        let _e978 = vec3<f32>(_e816[0][0], _e816[0][1], _e816[0][2]);
                                                                        let _e979 = vec3<f32>(_e816[1][0], _e816[1][1], _e816[1][2]);
                                                                        let _e980 = vec3<f32>(_e816[2][0], _e816[2][1], _e816[2][2]);
                                                                        let _e981 = (_e816[1][0] - _e816[0][0]);
                                                                        let _e982 = (_e816[1][1] - _e816[0][1]);
                                                                        let _e983 = (_e816[1][2] - _e816[0][2]);
                                                                        let _e984 = vec3<f32>(_e981, _e982, _e983);
                                                                        let _e985 = (_e816[2][0] - _e816[1][0]);
                                                                        let _e986 = (_e816[2][1] - _e816[1][1]);
                                                                        let _e987 = (_e816[2][2] - _e816[1][2]);
                                                                        let _e988 = vec3<f32>(_e985, _e986, _e987);
                                                                        let _e989 = (_e816[0][0] - _e816[2][0]);
                                                                        let _e990 = (_e816[0][1] - _e816[2][1]);
                                                                        let _e991 = (_e816[0][2] - _e816[2][2]);
                                                                        let _e992 = vec3<f32>(_e989, _e990, _e991);
                                                                        let _e995 = bitcast<f32>((bitcast<u32>(_e981) & 2147483647u));
                                                                        let _e998 = bitcast<f32>((bitcast<u32>(_e982) & 2147483647u));
                                                                        let _e1000 = select(_e998, _e995, (_e995 > _e998));
                                                                        let _e1003 = bitcast<f32>((bitcast<u32>(_e983) & 2147483647u));
                                                                        let _e1005 = select(_e1003, _e1000, (_e1000 > _e1003));
                                                                        let _e1008 = bitcast<f32>((bitcast<u32>(_e985) & 2147483647u));
                                                                        let _e1011 = bitcast<f32>((bitcast<u32>(_e986) & 2147483647u));
                                                                        let _e1013 = select(_e1011, _e1008, (_e1008 > _e1011));
                                                                        let _e1016 = bitcast<f32>((bitcast<u32>(_e987) & 2147483647u));
                                                                        let _e1018 = select(_e1016, _e1013, (_e1013 > _e1016));
                                                                        let _e1021 = bitcast<f32>((bitcast<u32>(_e989) & 2147483647u));
                                                                        let _e1024 = bitcast<f32>((bitcast<u32>(_e990) & 2147483647u));
                                                                        let _e1026 = select(_e1024, _e1021, (_e1021 > _e1024));
                                                                        let _e1029 = bitcast<f32>((bitcast<u32>(_e991) & 2147483647u));
                                                                        let _e1031 = select(_e1029, _e1026, (_e1026 > _e1029));
                                                                        let _e1033 = select(_e1018, _e1005, (_e1005 > _e1018));
                                                                        let _e1035 = select(_e1031, _e1033, (_e1033 > _e1031));
                                                                        if (_e1005 == _e1035) {
                                                                            phi_2085_ = _e842;
                                                                            phi_2086_ = _e839;
                                                                            phi_2087_ = _e829;
                                                                            phi_2088_ = _e826;
                                                                            phi_2089_ = _e978;
                                                                            phi_2090_ = _e992;
                                                                            phi_2091_ = _e988;
                                                                            phi_2092_ = _e984;
                                                                        } else {
                                                                            let _e1037 = (_e1018 == _e1035);
                                                                            let _e1042 = vec3(_e1037);
                                                                            phi_2085_ = select(_e829, _e855, _e1037);
                                                                            phi_2086_ = select(_e826, _e852, _e1037);
                                                                            phi_2087_ = select(_e855, _e842, _e1037);
                                                                            phi_2088_ = select(_e852, _e839, _e1037);
                                                                            phi_2089_ = select(_e980, _e979, _e1042);
                                                                            phi_2090_ = select(_e988, _e984, _e1042);
                                                                            phi_2091_ = select(_e984, _e992, _e1042);
                                                                            phi_2092_ = select(_e992, _e988, _e1042);
                                                                        }
                                                                        let _e1048 = phi_2085_;
                                                                        let _e1050 = phi_2086_;
                                                                        let _e1052 = phi_2087_;
                                                                        let _e1054 = phi_2088_;
                                                                        let _e1056 = phi_2089_;
                                                                        let _e1058 = phi_2090_;
                                                                        let _e1060 = phi_2091_;
                                                                        let _e1062 = phi_2092_;
                                                                        let _e1069 = ((_e1060.y * _e1058.z) - (_e1058.y * _e1060.z));
                                                                        let _e1074 = ((_e1060.z * _e1058.x) - (_e1058.z * _e1060.x));
                                                                        let _e1077 = ((_e1060.x * _e1058.y) - (_e1058.x * _e1060.y));
                                                                        if (_e877 >= _e881) {
                                                                            phi_2129_ = select(true, false, (_e877 >= _e885));
                                                                        } else {
                                                                            phi_2129_ = true;
                                                                        }
                                                                        let _e1082 = phi_2129_;
                                                                        if _e1082 {
                                                                            phi_2138_ = select(_e980, _e979, vec3((_e881 >= _e885)));
                                                                        } else {
                                                                            phi_2138_ = _e978;
                                                                        }
                                                                        let _e1087 = phi_2138_;
                                                                        let _e1098 = (((_e1069 * (_e1087.x - _e331)) + (_e1074 * (_e1087.y - _e400))) + (_e1077 * (_e1087.z - _e468)));
                                                                        let _e1103 = (((_e1069 * _e371) + (_e1074 * _e439)) + (_e1077 * _e507));
                                                                        let _e1104 = (_e1050 - _e1054);
                                                                        let _e1105 = (_e1048 - _e1052);
                                                                        let _e1113 = (-(((_e1054 * _e1104) + (_e1052 * _e1105))) / ((_e1104 * _e1104) + (_e1105 * _e1105)));
                                                                        let _e1115 = select(1f, _e1113, (_e1113 < 1f));
                                                                        let _e1117 = select(0f, _e1115, (_e1115 > 0f));
                                                                        let _e1130 = ((_e1056.x + (_e1062.x * _e1117)) - _e331);
                                                                        let _e1131 = ((_e1056.y + (_e1062.y * _e1117)) - _e400);
                                                                        let _e1132 = ((_e1056.z + (_e1062.z * _e1117)) - _e468);
                                                                        let _e1133 = (_e1132 / _e507);
                                                                        let _e1145 = bitcast<f32>((bitcast<u32>(_e1130) & 2147483647u));
                                                                        let _e1148 = bitcast<f32>((bitcast<u32>(_e1131) & 2147483647u));
                                                                        let _e1150 = select(_e1148, _e1145, (_e1145 > _e1148));
                                                                        let _e1153 = bitcast<f32>((bitcast<u32>(_e1132) & 2147483647u));
                                                                        let _e1155 = select(_e1153, _e1150, (_e1150 > _e1153));
                                                                        let _e1161 = bitcast<f32>((bitcast<u32>(_e1069) & 2147483647u));
                                                                        let _e1164 = bitcast<f32>((bitcast<u32>(_e1074) & 2147483647u));
                                                                        let _e1166 = select(_e1164, _e1161, (_e1161 > _e1164));
                                                                        let _e1169 = bitcast<f32>((bitcast<u32>(_e1077) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1069 * _e1130) + (_e1074 * _e1131)) + (_e1077 * _e1132)) - _e1098)) & 2147483647u)) <= ((0.0000009536743f * select(_e1035, _e1155, (_e1155 > _e1035))) * select(_e1169, _e1166, (_e1166 > _e1169)))) {
                                                                            let _e1179 = bitcast<f32>((bitcast<u32>(_e1060.x) & 2147483647u));
                                                                            let _e1182 = bitcast<f32>((bitcast<u32>(_e1060.y) & 2147483647u));
                                                                            let _e1184 = select(_e1182, _e1179, (_e1179 > _e1182));
                                                                            let _e1187 = bitcast<f32>((bitcast<u32>(_e1060.z) & 2147483647u));
                                                                            let _e1193 = bitcast<f32>((bitcast<u32>(_e1058.x) & 2147483647u));
                                                                            let _e1196 = bitcast<f32>((bitcast<u32>(_e1058.y) & 2147483647u));
                                                                            let _e1198 = select(_e1196, _e1193, (_e1193 > _e1196));
                                                                            let _e1201 = bitcast<f32>((bitcast<u32>(_e1058.z) & 2147483647u));
                                                                            let _e1205 = (bitcast<f32>((bitcast<u32>(_e1103) & 2147483647u)) > ((0.0000038146973f * select(_e1187, _e1184, (_e1184 > _e1187))) * select(_e1201, _e1198, (_e1198 > _e1201))));
                                                                            if _e1205 {
                                                                                phi_2303_ = (_e1098 / _e1103);
                                                                            } else {
                                                                                phi_2303_ = f32();
                                                                            }
                                                                            let _e1208 = phi_2303_;
                                                                            phi_2305_ = _e1208;
                                                                            phi_2306_ = select(true, false, _e1205);
                                                                        } else {
                                                                            phi_2305_ = f32();
                                                                            phi_2306_ = true;
                                                                        }
                                                                        let _e1211 = phi_2305_;
                                                                        let _e1213 = phi_2306_;
                                                                        if _e1213 {
                                                                            let _e1221 = (((_e1069 * (_e1130 - (_e371 * _e1133))) + (_e1074 * (_e1131 - (_e439 * _e1133)))) / _e1103);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u)) <= _e1035) {
                                                                                phi_2326_ = (_e1133 + _e1221);
                                                                            } else {
                                                                                phi_2326_ = _e1133;
                                                                            }
                                                                            let _e1228 = phi_2326_;
                                                                            phi_2327_ = _e1228;
                                                                        } else {
                                                                            phi_2327_ = _e1211;
                                                                        }
                                                                        let _e1230 = phi_2327_;
                                                                        let _e1232 = select(_e968, _e1230, (_e1230 < _e968));
                                                                        let _e1234 = select(_e960, _e1232, (_e1232 > _e960));
                                                                        if (_e1234 >= _e622) {
                                                                            let _e1236 = (_e1234 <= _e720);
                                                                            if _e1236 {
                                                                                let _e1237 = (1f / _e887);
                                                                                phi_2350_ = type_25(_e1234, (_e881 * _e1237), (_e885 * _e1237), _e749);
                                                                            } else {
                                                                                phi_2350_ = type_25();
                                                                            }
                                                                            let _e1242 = phi_2350_;
                                                                            phi_2352_ = _e1242;
                                                                            phi_2353_ = select(true, false, _e1236);
                                                                        } else {
                                                                            phi_2352_ = type_25();
                                                                            phi_2353_ = true;
                                                                        }
                                                                        let _e1245 = phi_2352_;
                                                                        let _e1247 = phi_2353_;
                                                                        if _e1247 {
                                                                            phi_2357_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2357_ = _e1245;
                                                                        }
                                                                        let _e1249 = phi_2357_;
                                                                        phi_2358_ = _e1249;
                                                                    }
                                                                    let _e1251 = phi_2358_;
                                                                    phi_2359_ = _e1251;
                                                                    phi_2360_ = _e977;
                                                                }
                                                                let _e1253 = phi_2359_;
                                                                let _e1255 = phi_2360_;
                                                                phi_2364_ = _e1253;
                                                                phi_2365_ = _e1255;
                                                            }
                                                            let _e1257 = phi_2364_;
                                                            let _e1259 = phi_2365_;
                                                            phi_2366_ = _e1257;
                                                            phi_2367_ = _e912;
                                                            phi_2368_ = _e1259;
                                                        }
                                                        let _e1261 = phi_2366_;
                                                        let _e1263 = phi_2367_;
                                                        let _e1265 = phi_2368_;
                                                        phi_2369_ = _e1261;
                                                        phi_2370_ = _e1263;
                                                        phi_2371_ = _e1265;
                                                    }
                                                    let _e1267 = phi_2369_;
                                                    let _e1269 = phi_2370_;
                                                    let _e1271 = phi_2371_;
                                                    phi_2379_ = _e1267;
                                                    phi_2380_ = select(_e1271, true, _e1269);
                                                } else {
                                                    phi_2379_ = type_25();
                                                    phi_2380_ = true;
                                                }
                                                let _e1274 = phi_2379_;
                                                let _e1276 = phi_2380_;
                                                if _e1276 {
                                                    phi_2384_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2384_ = _e1274;
                                                }
                                                let _e1278 = phi_2384_;
                                                if (_e1278.member_3 != 4294967295u) {
                                                    if (_e749 != 4294967295u) {
                                                        phi_2396_ = type_4(0u, 8u);
                                                        phi_2399_ = _e1278;
                                                        loop {
                                                            let _e1283 = phi_2396_;
                                                            let _e1285 = phi_2399_;
                                                            if (_e1283.member < _e1283.member_1) {
                                                                phi_2397_ = type_4((_e1283.member + 1u), _e1283.member_1);
                                                                phi_2422_ = type_4(1u, _e1283.member);
                                                            } else {
                                                                phi_2397_ = _e1283;
                                                                phi_2422_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1298 = phi_2397_;
                                                            let _e1300 = phi_2422_;
                                                            let _e1304 = (bitcast<i32>(_e1300.member) != 0i);
                                                            if _e1304 {
                                                                let _e1305 = (_e1300.member_1 < 8u);
                                                                if _e1305 {
                                                                } else {
                                                                    phi_4224_ = true;
                                                                    break;
                                                                }
                                                                let _e1310 = local_9[_e1300.member_1].member;
                                                                if (_e1285.member < _e1310) {
                                                                    phi_2455_ = true;
                                                                } else {
                                                                    let _e1312 = local_9[_e1300.member_1].member;
                                                                    if (_e1285.member == _e1312) {
                                                                        let _e1317 = local_9[_e1300.member_1].member_3;
                                                                        phi_2454_ = (_e1285.member_3 < _e1317);
                                                                    } else {
                                                                        phi_2454_ = false;
                                                                    }
                                                                    let _e1320 = phi_2454_;
                                                                    phi_2455_ = _e1320;
                                                                }
                                                                let _e1322 = phi_2455_;
                                                                if _e1322 {
                                                                    if _e1305 {
                                                                    } else {
                                                                        phi_4224_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1323 = local_9[_e1300.member_1];
                                                                    local_9[_e1300.member_1] = type_25(_e1285.member, _e1285.member_1, _e1285.member_2, _e1285.member_3);
                                                                    phi_2476_ = type_25(_e1323.member, _e1323.member_1, _e1323.member_2, _e1323.member_3);
                                                                } else {
                                                                    phi_2476_ = _e1285;
                                                                }
                                                                let _e1334 = phi_2476_;
                                                                phi_2400_ = _e1334;
                                                            } else {
                                                                phi_2400_ = type_25();
                                                            }
                                                            let _e1336 = phi_2400_;
                                                            continue;
                                                            continuing {
                                                                phi_2396_ = _e1298;
                                                                phi_2399_ = _e1336;
                                                                phi_4224_ = _e718;
                                                                break if !(_e1304);
                                                            }
                                                        }
                                                        let _e1339 = phi_4224_;
                                                        phi_4442_ = _e720;
                                                        phi_4384_ = _e1339;
                                                        if _e1339 {
                                                            break;
                                                        }
                                                        let _e1342 = local_9[7u].member_3;
                                                        if (_e1342 != 4294967295u) {
                                                            let _e1346 = local_9[7u].member;
                                                            phi_4533_ = _e1346;
                                                        } else {
                                                            phi_4533_ = _e720;
                                                        }
                                                        let _e1348 = phi_4533_;
                                                        phi_4532_ = _e1348;
                                                        phi_4387_ = _e1339;
                                                    } else {
                                                        phi_4532_ = _e720;
                                                        phi_4387_ = _e718;
                                                    }
                                                    let _e1350 = phi_4532_;
                                                    let _e1352 = phi_4387_;
                                                    phi_4531_ = _e1350;
                                                    phi_4386_ = _e1352;
                                                } else {
                                                    phi_4531_ = _e720;
                                                    phi_4386_ = _e718;
                                                }
                                                let _e1354 = phi_4531_;
                                                let _e1356 = phi_4386_;
                                                phi_4530_ = _e1354;
                                                phi_4385_ = _e1356;
                                            } else {
                                                phi_4530_ = _e720;
                                                phi_4385_ = _e718;
                                            }
                                            let _e1358 = phi_4530_;
                                            let _e1360 = phi_4385_;
                                            continue;
                                            continuing {
                                                phi_4233_ = _e1360;
                                                phi_4222_ = _e1358;
                                                phi_1347_ = _e735;
                                                phi_4442_ = _e1358;
                                                phi_4384_ = _e1360;
                                                break if !(_e741);
                                            }
                                        }
                                        let _e1363 = phi_4442_;
                                        let _e1365 = phi_4384_;
                                        phi_4535_ = _e1365;
                                        if _e1365 {
                                            break;
                                        }
                                        phi_4621_ = _e1365;
                                        phi_4441_ = _e1363;
                                    } else {
                                        phi_4621_ = _e663;
                                        phi_4441_ = _e665;
                                    }
                                    let _e1367 = phi_4621_;
                                    let _e1369 = phi_4441_;
                                    if _e711 {
                                        phi_3718_ = bool();
                                        phi_3719_ = u32();
                                        phi_3720_ = type_52();
                                    } else {
                                        if (_e707.member_1 >= _e97) {
                                            phi_3253_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e707.member_1 < _e97) {
                                            } else {
                                                phi_4535_ = true;
                                                break;
                                            }
                                            let _e1373 = ((1u + _e267) % 4u);
                                            if (_e1373 < 4u) {
                                            } else {
                                                phi_4535_ = true;
                                                break;
                                            }
                                            let _e1378 = global_4.member[_e707.member_1][_e1373];
                                            let _e1380 = (_e1378 >> bitcast<u32>(11u));
                                            let _e1382 = ((1u + _e266) % 4u);
                                            if (_e1382 < 4u) {
                                            } else {
                                                phi_4535_ = true;
                                                break;
                                            }
                                            let _e1387 = global_4.member[_e707.member_1][_e1382];
                                            let _e1389 = (_e1387 >> bitcast<u32>(11u));
                                            let _e1391 = ((1u + _e268) % 4u);
                                            if (_e1391 < 4u) {
                                            } else {
                                                phi_4535_ = true;
                                                break;
                                            }
                                            let _e1396 = global_4.member[_e707.member_1][_e1391];
                                            let _e1398 = (_e1396 >> bitcast<u32>(11u));
                                            let _e1421 = (bitcast<f32>((bitcast<u32>((_e707.member.member_1.x - _e707.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1422 = (bitcast<f32>((bitcast<u32>((_e707.member.member_1.y - _e707.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1423 = (bitcast<f32>((bitcast<u32>((_e707.member.member_1.z - _e707.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1425 = select(_e147, _e1421, (_e1421 > _e147));
                                            let _e1427 = select(_e147, _e1422, (_e1422 > _e147));
                                            let _e1429 = select(_e147, _e1423, (_e1423 > _e147));
                                            let _e1460 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1378 & 1023u))) - 8388608f) * _e1425));
                                            let _e1465 = (bitcast<i32>((_e1378 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1468 = bitcast<f32>((_e1460 & bitcast<u32>(_e1465)));
                                            let _e1469 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1387 & 1023u))) - 8388608f) * _e1427));
                                            let _e1474 = (bitcast<i32>((_e1387 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1477 = bitcast<f32>((_e1469 & bitcast<u32>(_e1474)));
                                            let _e1478 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1396 & 1023u))) - 8388608f) * _e1429));
                                            let _e1483 = (bitcast<i32>((_e1396 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1486 = bitcast<f32>((_e1478 & bitcast<u32>(_e1483)));
                                            let _e1490 = bitcast<f32>((_e1460 & bitcast<u32>(~(_e1465))));
                                            let _e1494 = bitcast<f32>((_e1469 & bitcast<u32>(~(_e1474))));
                                            let _e1498 = bitcast<f32>((_e1478 & bitcast<u32>(~(_e1483))));
                                            let _e1499 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1380 & 1023u))) - 8388608f) * _e1425));
                                            let _e1504 = (bitcast<i32>((_e1380 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1507 = bitcast<f32>((_e1499 & bitcast<u32>(_e1504)));
                                            let _e1508 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1389 & 1023u))) - 8388608f) * _e1427));
                                            let _e1513 = (bitcast<i32>((_e1389 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1516 = bitcast<f32>((_e1508 & bitcast<u32>(_e1513)));
                                            let _e1517 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1398 & 1023u))) - 8388608f) * _e1429));
                                            let _e1522 = (bitcast<i32>((_e1398 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1525 = bitcast<f32>((_e1517 & bitcast<u32>(_e1522)));
                                            let _e1529 = bitcast<f32>((_e1499 & bitcast<u32>(~(_e1504))));
                                            let _e1533 = bitcast<f32>((_e1508 & bitcast<u32>(~(_e1513))));
                                            let _e1537 = bitcast<f32>((_e1517 & bitcast<u32>(~(_e1522))));
                                            let _e1567 = global_4.member[_e707.member_1][0u];
                                            let _e1571 = global_4.member[_e707.member_1][1u];
                                            let _e1575 = global_4.member[_e707.member_1][2u];
                                            let _e1579 = global_4.member[_e707.member_1][3u];
                                            let _e1591 = (((_e1571 >> bitcast<u32>(22i)) | ((_e1575 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1579 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1592 = (_e1567 & 268435455u);
                                            let _e1593 = (_e1591 & 268435455u);
                                            let _e1596 = ((_e1567 >> bitcast<u32>(28u)) & 7u);
                                            let _e1604 = ((_e1567 >> bitcast<u32>(31i)) | (((_e1591 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1605 = (_e1596 != 0u);
                                            if (_e1596 == 0u) {
                                                phi_3215_ = _e1592;
                                            } else {
                                                if (_e1596 == 7u) {
                                                    phi_3214_ = 2147483648u;
                                                } else {
                                                    phi_3214_ = ((2147483648u | (_e1596 << bitcast<u32>(28u))) | (_e1593 & 268435455u));
                                                }
                                                let _e1614 = phi_3214_;
                                                phi_3215_ = _e1614;
                                            }
                                            let _e1616 = phi_3215_;
                                            if _e1605 {
                                                let _e1617 = (_e1596 != 7u);
                                                if _e1617 {
                                                    phi_3225_ = (_e1593 + _e1596);
                                                } else {
                                                    phi_3225_ = u32();
                                                }
                                                let _e1620 = phi_3225_;
                                                phi_3227_ = _e1620;
                                                phi_3228_ = select(true, false, _e1617);
                                            } else {
                                                phi_3227_ = u32();
                                                phi_3228_ = true;
                                            }
                                            let _e1623 = phi_3227_;
                                            let _e1625 = phi_3228_;
                                            if (_e1604 == 0u) {
                                                phi_3249_ = (_e1592 + select(0u, 1u, !(_e1605)));
                                            } else {
                                                if (_e1604 == 7u) {
                                                    phi_3248_ = 2147483648u;
                                                } else {
                                                    phi_3248_ = ((2147483648u | (_e1604 << bitcast<u32>(28u))) | (select(_e1623, _e1593, _e1625) & 268435455u));
                                                }
                                                let _e1638 = phi_3248_;
                                                phi_3249_ = _e1638;
                                            }
                                            let _e1640 = phi_3249_;
                                            phi_3253_ = type_53(array<vec4<f32>, 3>(vec4<f32>((_e707.member.member.x + _e1468), (_e707.member.member.x + _e1490), (_e707.member.member_1.x - _e1507), (_e707.member.member_1.x - _e1529)), vec4<f32>((_e707.member.member.y + _e1477), (_e707.member.member.y + _e1494), (_e707.member.member_1.y - _e1516), (_e707.member.member_1.y - _e1533)), vec4<f32>((_e707.member.member.z + _e1486), (_e707.member.member.z + _e1498), (_e707.member.member_1.z - _e1525), (_e707.member.member_1.z - _e1537))), type_52(type_29((_e707.member.member + vec4<f32>(_e1468, _e1477, _e1486, 0f)), (_e707.member.member_1 - vec4<f32>(_e1507, _e1516, _e1525, 0f))), _e1616), type_52(type_29((_e707.member.member + vec4<f32>(_e1490, _e1494, _e1498, 0f)), (_e707.member.member_1 - vec4<f32>(_e1529, _e1533, _e1537, 0f))), _e1640));
                                        }
                                        let _e1645 = phi_3253_;
                                        let _e1656 = ((_e1645.member[0].x - _e369) * _e374);
                                        let _e1657 = ((_e1645.member[0].y - _e369) * _e374);
                                        let _e1658 = ((_e1645.member[0].z - _e370) * _e374);
                                        let _e1659 = ((_e1645.member[0].w - _e370) * _e374);
                                        let _e1669 = ((_e1645.member[1].x - _e437) * _e442);
                                        let _e1670 = ((_e1645.member[1].y - _e437) * _e442);
                                        let _e1671 = ((_e1645.member[1].z - _e438) * _e442);
                                        let _e1672 = ((_e1645.member[1].w - _e438) * _e442);
                                        let _e1682 = ((_e1645.member[2].x - _e505) * _e510);
                                        let _e1683 = ((_e1645.member[2].y - _e505) * _e510);
                                        let _e1684 = ((_e1645.member[2].z - _e506) * _e510);
                                        let _e1685 = ((_e1645.member[2].w - _e506) * _e510);
                                        let _e1687 = select(_e1684, _e1682, (_e1682 < _e1684));
                                        let _e1689 = select(_e1685, _e1683, (_e1683 < _e1685));
                                        let _e1691 = select(_e1684, _e1682, (_e1682 > _e1684));
                                        let _e1693 = select(_e1685, _e1683, (_e1683 > _e1685));
                                        let _e1695 = select(_e1658, _e1656, (_e1656 < _e1658));
                                        let _e1697 = select(_e1659, _e1657, (_e1657 < _e1659));
                                        let _e1699 = select(_e1671, _e1669, (_e1669 < _e1671));
                                        let _e1701 = select(_e1672, _e1670, (_e1670 < _e1672));
                                        let _e1703 = select(_e1699, _e1695, (_e1695 > _e1699));
                                        let _e1705 = select(_e1701, _e1697, (_e1697 > _e1701));
                                        let _e1707 = select(_e1687, _e1703, (_e1703 > _e1687));
                                        let _e1709 = select(_e1689, _e1705, (_e1705 > _e1689));
                                        let _e1711 = select(_e1658, _e1656, (_e1656 > _e1658));
                                        let _e1713 = select(_e1659, _e1657, (_e1657 > _e1659));
                                        let _e1715 = select(_e1671, _e1669, (_e1669 > _e1671));
                                        let _e1717 = select(_e1672, _e1670, (_e1670 > _e1672));
                                        let _e1719 = select(_e1715, _e1711, (_e1711 < _e1715));
                                        let _e1721 = select(_e1717, _e1713, (_e1713 < _e1717));
                                        let _e1726 = -(_e1687);
                                        let _e1727 = -(_e1689);
                                        let _e1734 = (select(_e1691, _e1719, (_e1719 < _e1691)) + (select(_e1726, _e1691, (_e1691 > _e1726)) * 0.0000019073523f));
                                        let _e1735 = (select(_e1693, _e1721, (_e1721 < _e1693)) + (select(_e1727, _e1693, (_e1693 > _e1727)) * 0.0000019073523f));
                                        let _e1737 = select(_e622, _e1707, (_e1707 > _e622));
                                        let _e1739 = select(_e622, _e1709, (_e1709 > _e622));
                                        let _e1744 = (_e1737 <= select(_e1369, _e1734, (_e1734 < _e1369)));
                                        let _e1745 = (_e1739 <= select(_e1369, _e1735, (_e1735 < _e1369)));
                                        let _e1746 = (_e1737 <= _e1739);
                                        if _e1744 {
                                            if _e1745 {
                                                if _e1746 {
                                                    phi_3616_ = _e1645.member_2;
                                                } else {
                                                    phi_3616_ = _e1645.member_1;
                                                }
                                                let _e1750 = phi_3616_;
                                                let _e1771 = (_e705 % 128u);
                                                let _e1772 = (_e1771 < 128u);
                                                if _e1772 {
                                                } else {
                                                    phi_4535_ = true;
                                                    break;
                                                }
                                                local_8[_e1771] = _e1750.member_1;
                                                if _e1772 {
                                                } else {
                                                    phi_4535_ = true;
                                                    break;
                                                }
                                                local_7[_e1771] = _e1750.member.member.x;
                                                if _e1772 {
                                                } else {
                                                    phi_4535_ = true;
                                                    break;
                                                }
                                                local_6[_e1771] = _e1750.member.member.y;
                                                if _e1772 {
                                                } else {
                                                    phi_4535_ = true;
                                                    break;
                                                }
                                                local_5[_e1771] = _e1750.member.member.z;
                                                if _e1772 {
                                                } else {
                                                    phi_4535_ = true;
                                                    break;
                                                }
                                                local_4[_e1771] = _e1750.member.member_1.x;
                                                if _e1772 {
                                                } else {
                                                    phi_4535_ = true;
                                                    break;
                                                }
                                                local_3[_e1771] = _e1750.member.member_1.y;
                                                if _e1772 {
                                                } else {
                                                    phi_4535_ = true;
                                                    break;
                                                }
                                                local_2[_e1771] = _e1750.member.member_1.z;
                                                if _e1772 {
                                                } else {
                                                    phi_4535_ = true;
                                                    break;
                                                }
                                                local_10[_e1771] = select(_e1737, _e1739, _e1746);
                                                if _e1746 {
                                                    phi_3692_ = _e1645.member_1;
                                                } else {
                                                    phi_3692_ = _e1645.member_2;
                                                }
                                                let _e1785 = phi_3692_;
                                                phi_3693_ = (_e705 + 1u);
                                                phi_3694_ = _e1785;
                                            } else {
                                                phi_3693_ = u32();
                                                phi_3694_ = type_52();
                                            }
                                            let _e1787 = phi_3693_;
                                            let _e1789 = phi_3694_;
                                            phi_3696_ = _e1787;
                                            phi_3697_ = _e1789;
                                            phi_3698_ = select(true, false, _e1745);
                                        } else {
                                            phi_3696_ = u32();
                                            phi_3697_ = type_52();
                                            phi_3698_ = true;
                                        }
                                        let _e1792 = phi_3696_;
                                        let _e1794 = phi_3697_;
                                        let _e1796 = phi_3698_;
                                        if _e1796 {
                                            if _e1744 {
                                                phi_3707_ = _e1645.member_1;
                                            } else {
                                                phi_3707_ = _e1645.member_2;
                                            }
                                            let _e1800 = phi_3707_;
                                            phi_3712_ = select(_e1745, true, _e1744);
                                            phi_3714_ = _e1800;
                                        } else {
                                            phi_3712_ = _e703;
                                            phi_3714_ = _e1794;
                                        }
                                        let _e1803 = phi_3712_;
                                        let _e1805 = phi_3714_;
                                        phi_3718_ = _e1803;
                                        phi_3719_ = select(_e1792, _e705, _e1796);
                                        phi_3720_ = _e1805;
                                    }
                                    let _e1808 = phi_3718_;
                                    let _e1810 = phi_3719_;
                                    let _e1812 = phi_3720_;
                                    if _e711 {
                                        phi_3730_ = _e707;
                                    } else {
                                        phi_3730_ = _e1812;
                                    }
                                    let _e1814 = phi_3730_;
                                    phi_4649_ = _e1369;
                                    phi_4538_ = _e1367;
                                    phi_3731_ = (_e667 - 1u);
                                    phi_3732_ = select(_e1808, false, _e711);
                                    phi_3733_ = select(_e1810, _e705, _e711);
                                    phi_3734_ = _e1814;
                                } else {
                                    phi_4649_ = _e665;
                                    phi_4538_ = _e663;
                                    phi_3731_ = _e667;
                                    phi_3732_ = _e703;
                                    phi_3733_ = _e705;
                                    phi_3734_ = _e707;
                                }
                                let _e1818 = phi_4649_;
                                let _e1820 = phi_4538_;
                                let _e1822 = phi_3731_;
                                let _e1824 = phi_3732_;
                                let _e1826 = phi_3733_;
                                let _e1828 = phi_3734_;
                                phi_4648_ = _e1818;
                                phi_4537_ = _e1820;
                                phi_3735_ = _e1822;
                                phi_3736_ = _e1824;
                                phi_3737_ = _e1826;
                                phi_3738_ = _e1828;
                            } else {
                                phi_4648_ = _e665;
                                phi_4537_ = _e663;
                                phi_3735_ = u32();
                                phi_3736_ = bool();
                                phi_3737_ = u32();
                                phi_3738_ = type_52();
                            }
                            let _e1830 = phi_4648_;
                            let _e1832 = phi_4537_;
                            let _e1834 = phi_3735_;
                            let _e1836 = phi_3736_;
                            let _e1838 = phi_3737_;
                            let _e1840 = phi_3738_;
                            phi_4647_ = _e1830;
                            phi_4536_ = _e1832;
                            phi_1223_ = _e1834;
                            phi_1226_ = _e1836;
                            phi_1228_ = _e1838;
                            phi_1230_ = _e1840;
                            phi_3739_ = _e677;
                        } else {
                            phi_4647_ = _e665;
                            phi_4536_ = _e663;
                            phi_1223_ = u32();
                            phi_1226_ = bool();
                            phi_1228_ = u32();
                            phi_1230_ = type_52();
                            phi_3739_ = false;
                        }
                        let _e1842 = phi_4647_;
                        let _e1844 = phi_4536_;
                        let _e1846 = phi_1223_;
                        let _e1848 = phi_1226_;
                        let _e1850 = phi_1228_;
                        let _e1852 = phi_1230_;
                        let _e1854 = phi_3739_;
                        continue;
                        continuing {
                            phi_4236_ = _e1844;
                            phi_4217_ = _e1842;
                            phi_1222_ = _e1846;
                            phi_1225_ = _e1848;
                            phi_1227_ = _e1850;
                            phi_1229_ = _e1852;
                            phi_4535_ = _e1844;
                            break if !(_e1854);
                        }
                    }
                    let _e1857 = phi_4535_;
                    if _e1857 {
                        break;
                    }
                    phi_3746_ = type_4(0u, 8u);
                    loop {
                        let _e1859 = phi_3746_;
                        if (_e1859.member < _e1859.member_1) {
                            phi_3747_ = type_4((_e1859.member + 1u), _e1859.member_1);
                            phi_3770_ = type_4(1u, _e1859.member);
                        } else {
                            phi_3747_ = _e1859;
                            phi_3770_ = type_4(0u, type_4().member_1);
                        }
                        let _e1872 = phi_3747_;
                        let _e1874 = phi_3770_;
                        let _e1878 = (bitcast<i32>(_e1874.member) != 0i);
                        if _e1878 {
                            let _e1879 = (_e1874.member_1 < 8u);
                            if _e1879 {
                            } else {
                                phi_4629_ = true;
                                break;
                            }
                            let _e1881 = local_9[_e1874.member_1];
                            if (_e1881.member_3 != 4294967295u) {
                                let _e1887 = -(_e524);
                                let _e1888 = bitcast<u32>(_e1881.member);
                                let _e1892 = (bitcast<i32>((_e1888 >> bitcast<u32>(23i))) & 255i);
                                let _e1893 = (_e1892 + _e1887);
                                if (_e1892 == 255i) {
                                    phi_3843_ = _e1881.member;
                                } else {
                                    if (_e1892 > 0i) {
                                        if (_e1893 > 0i) {
                                            let _e1897 = (_e1893 < 255i);
                                            if _e1897 {
                                                phi_3822_ = bitcast<f32>((_e1888 + bitcast<u32>((_e1887 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_3822_ = f32();
                                            }
                                            let _e1904 = phi_3822_;
                                            phi_3824_ = _e1904;
                                            phi_3825_ = select(true, false, _e1897);
                                        } else {
                                            phi_3824_ = f32();
                                            phi_3825_ = true;
                                        }
                                        let _e1907 = phi_3824_;
                                        let _e1909 = phi_3825_;
                                        phi_3826_ = _e1907;
                                        phi_3827_ = _e1909;
                                    } else {
                                        phi_3826_ = f32();
                                        phi_3827_ = true;
                                    }
                                    let _e1911 = phi_3826_;
                                    let _e1913 = phi_3827_;
                                    if _e1913 {
                                        let _e1914 = (_e1888 & 2147483648u);
                                        let _e1921 = ((_e1888 & 8388607u) | (select(0u, 1u, ((_e1888 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1925 = (_e1921 == 0u);
                                        if _e1925 {
                                            phi_4164_ = bitcast<f32>(_e1914);
                                        } else {
                                            let _e1930 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1921)), 32u, _e1925) - 8u);
                                            let _e1933 = (_e1921 << bitcast<u32>((_e1930 & 31u)));
                                            let _e1935 = ((_e1893 + select(0i, 1i, (_e1892 == 0i))) - bitcast<i32>(_e1930));
                                            if (_e1935 >= 255i) {
                                                phi_4154_ = bitcast<f32>((_e1914 | 2139095040u));
                                                phi_4155_ = f32();
                                                phi_4156_ = true;
                                            } else {
                                                let _e1937 = (_e1935 > 0i);
                                                if _e1937 {
                                                    phi_4148_ = bitcast<f32>(((_e1914 | (bitcast<u32>(_e1935) << bitcast<u32>(23i))) | (_e1933 & 8388607u)));
                                                    phi_4149_ = f32();
                                                } else {
                                                    if (_e1935 < -24i) {
                                                        phi_4114_ = 26u;
                                                    } else {
                                                        phi_4114_ = bitcast<u32>((1i - _e1935));
                                                    }
                                                    let _e1942 = phi_4114_;
                                                    let _e1943 = (_e1942 & 31u);
                                                    let _e1945 = (_e1933 >> bitcast<u32>(_e1943));
                                                    let _e1949 = (_e1933 & ((1u << bitcast<u32>(_e1943)) - 1u));
                                                    let _e1953 = (1u << bitcast<u32>(((_e1942 - 1u) & 31u)));
                                                    if (_e1949 > _e1953) {
                                                        phi_4135_ = true;
                                                    } else {
                                                        if (_e1949 == _e1953) {
                                                            phi_4132_ = ((_e1945 & 1u) == 1u);
                                                        } else {
                                                            phi_4132_ = false;
                                                        }
                                                        let _e1959 = phi_4132_;
                                                        phi_4135_ = _e1959;
                                                    }
                                                    let _e1961 = phi_4135_;
                                                    phi_4148_ = f32();
                                                    phi_4149_ = bitcast<f32>((_e1914 | (_e1945 + select(0u, 1u, _e1961))));
                                                }
                                                let _e1974 = phi_4148_;
                                                let _e1976 = phi_4149_;
                                                phi_4154_ = _e1974;
                                                phi_4155_ = _e1976;
                                                phi_4156_ = _e1937;
                                            }
                                            let _e1980 = phi_4154_;
                                            let _e1982 = phi_4155_;
                                            let _e1984 = phi_4156_;
                                            phi_4164_ = select(_e1982, _e1980, _e1984);
                                        }
                                        let _e1988 = phi_4164_;
                                        phi_3842_ = _e1988;
                                    } else {
                                        phi_3842_ = _e1911;
                                    }
                                    let _e1990 = phi_3842_;
                                    phi_3843_ = _e1990;
                                }
                                let _e1992 = phi_3843_;
                                let _e1993 = bitcast<u32>(_e1992);
                                if ((_e1993 & 2147483647u) >= 2139095040u) {
                                    phi_3855_ = bitcast<f32>(((_e1993 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_3855_ = _e1992;
                                }
                                let _e2000 = phi_3855_;
                                phi_3860_ = type_25(_e2000, _e1881.member_1, _e1881.member_2, _e1881.member_3);
                            } else {
                                phi_3860_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e2003 = phi_3860_;
                            if _e1879 {
                            } else {
                                phi_4629_ = true;
                                break;
                            }
                            local_9[_e1874.member_1] = type_25(_e2003.member, _e2003.member_1, _e2003.member_2, _e2003.member_3);
                        }
                        continue;
                        continuing {
                            phi_3746_ = _e1872;
                            phi_4629_ = _e1857;
                            break if !(_e1878);
                        }
                    }
                    let _e2011 = phi_4629_;
                    if _e2011 {
                        break;
                    }
                    let _e2012 = local_9;
                    if _e155 {
                    } else {
                        break;
                    }
                    global_6.member[_e153] = array<type_25, 8>(type_25(_e2012[0].member, _e2012[0].member_1, _e2012[0].member_2, _e2012[0].member_3), type_25(_e2012[1].member, _e2012[1].member_1, _e2012[1].member_2, _e2012[1].member_3), type_25(_e2012[2].member, _e2012[2].member_1, _e2012[2].member_2, _e2012[2].member_3), type_25(_e2012[3].member, _e2012[3].member_1, _e2012[3].member_2, _e2012[3].member_3), type_25(_e2012[4].member, _e2012[4].member_1, _e2012[4].member_2, _e2012[4].member_3), type_25(_e2012[5].member, _e2012[5].member_1, _e2012[5].member_2, _e2012[5].member_3), type_25(_e2012[6].member, _e2012[6].member_1, _e2012[6].member_2, _e2012[6].member_3), type_25(_e2012[7].member, _e2012[7].member_1, _e2012[7].member_2, _e2012[7].member_3));
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
