struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: array<array<u32, 4>>,
}

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_26 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: type_30,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_38 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_43 {
    member: type_26,
    member_1: f32,
}

struct type_46 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_47 {
    member: type_43,
    member_1: u32,
    member_2: u32,
}

struct type_49 {
    member: array<vec4<u32>, 2>,
}

struct type_54 {
    member: type_38,
    member_1: u32,
}

struct type_55 {
    member: array<vec4<f32>, 3>,
    member_1: type_54,
    member_2: type_54,
}

struct type_60 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_20;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_28;
@group(0) @binding(0) 
var<uniform> global_3: type_49;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(3) 
var<storage> global_5: type_33;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_60;

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
    var local_9: array<f32, 128>;
    var phi_512_: i32;
    var phi_513_: i32;
    var phi_523_: bool;
    var phi_533_: u32;
    var phi_534_: u32;
    var phi_536_: bool;
    var phi_541_: u32;
    var phi_574_: i32;
    var phi_592_: f32;
    var phi_598_: f32;
    var phi_638_: f32;
    var phi_644_: f32;
    var phi_717_: f32;
    var phi_723_: f32;
    var phi_763_: f32;
    var phi_769_: f32;
    var phi_842_: f32;
    var phi_848_: f32;
    var phi_888_: f32;
    var phi_894_: f32;
    var phi_1013_: i32;
    var phi_1035_: u32;
    var phi_1036_: u32;
    var phi_1073_: i32;
    var phi_1095_: u32;
    var phi_1096_: u32;
    var phi_1104_: f32;
    var phi_1105_: f32;
    var phi_4143_: bool;
    var phi_1210_: type_47;
    var phi_1213_: bool;
    var phi_1215_: type_54;
    var phi_1217_: u32;
    var phi_1219_: u32;
    var phi_1230_: bool;
    var phi_1316_: bool;
    var phi_1317_: type_54;
    var phi_1318_: u32;
    var phi_3007_: u32;
    var phi_3008_: u32;
    var phi_3018_: u32;
    var phi_3020_: u32;
    var phi_3021_: bool;
    var phi_3041_: u32;
    var phi_3042_: u32;
    var phi_3046_: type_55;
    var phi_3411_: type_54;
    var phi_3487_: type_54;
    var phi_3488_: type_54;
    var phi_3489_: u32;
    var phi_3491_: type_54;
    var phi_3492_: u32;
    var phi_3493_: bool;
    var phi_3502_: type_54;
    var phi_3507_: bool;
    var phi_3508_: type_54;
    var phi_1336_: type_47;
    var phi_1339_: type_7;
    var phi_1340_: type_7;
    var phi_1362_: type_7;
    var phi_1386_: u32;
    var phi_1478_: array<array<f32, 3>, 3>;
    var phi_2008_: f32;
    var phi_2009_: f32;
    var phi_2010_: f32;
    var phi_2011_: f32;
    var phi_2012_: vec3<f32>;
    var phi_2013_: vec3<f32>;
    var phi_2014_: vec3<f32>;
    var phi_2015_: vec3<f32>;
    var phi_2206_: f32;
    var phi_2226_: type_46;
    var phi_2227_: type_46;
    var phi_2230_: type_46;
    var phi_2231_: type_46;
    var phi_2232_: bool;
    var phi_2236_: type_46;
    var phi_2245_: type_26;
    var phi_2270_: bool;
    var phi_2271_: bool;
    var phi_2278_: type_47;
    var phi_2279_: type_47;
    var phi_2280_: type_47;
    var phi_1337_: type_47;
    var phi_4137_: bool;
    var local_10: type_47;
    var phi_4294_: bool;
    var phi_3510_: type_47;
    var phi_3511_: bool;
    var phi_3512_: type_54;
    var phi_3513_: u32;
    var phi_4293_: bool;
    var phi_3514_: type_47;
    var phi_3515_: bool;
    var phi_3516_: type_54;
    var phi_3517_: u32;
    var phi_3518_: u32;
    var phi_4292_: bool;
    var phi_3519_: type_47;
    var phi_3520_: bool;
    var phi_3521_: type_54;
    var phi_3522_: u32;
    var phi_3523_: u32;
    var phi_4291_: bool;
    var phi_1211_: type_47;
    var phi_1214_: bool;
    var phi_1216_: type_54;
    var phi_1218_: u32;
    var phi_1220_: u32;
    var phi_3524_: bool;
    var phi_4290_: bool;
    var local_11: type_47;
    var phi_3562_: f32;
    var phi_3564_: f32;
    var phi_3565_: bool;
    var phi_3566_: f32;
    var phi_3567_: bool;
    var phi_4045_: u32;
    var phi_4063_: bool;
    var phi_4066_: bool;
    var phi_4079_: f32;
    var phi_4080_: f32;
    var phi_4085_: f32;
    var phi_4086_: f32;
    var phi_4087_: bool;
    var phi_4095_: f32;
    var phi_3582_: f32;
    var phi_3583_: f32;
    var phi_3595_: f32;
    var phi_3600_: type_26;
    var local_12: type_47;
    var local_13: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e94 = global;
            let _e96 = arrayLength((&global_4.member));
            let _e98 = arrayLength((&global_1.member));
            let _e106 = arrayLength((&global_7.member));
            let _e110 = global_3.member[0u][0u];
            let _e114 = global_3.member[0u][1u];
            let _e118 = global_3.member[0u][2u];
            let _e122 = global_3.member[0u][3u];
            let _e126 = global_3.member[1u][0u];
            let _e130 = global_3.member[1u][1u];
            let _e134 = global_3.member[1u][2u];
            let _e138 = (_e94.x + (_e94.y * 2097152u));
            let _e150 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e122) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e110), bitcast<i32>(_e114), bitcast<i32>(_e118));
            local = array<i32, 3>(bitcast<i32>(_e126), bitcast<i32>(_e130), bitcast<i32>(_e134));
            let _e153 = (_e138 < arrayLength((&global_5.member)));
            if _e153 {
                let _e154 = (_e138 < arrayLength((&global_2.member)));
                if _e154 {
                    let _e155 = (_e138 < arrayLength((&global_6.member)));
                    if _e155 {
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e165 = global_5.member[_e138].member.member_2[0u];
                        let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                        let _e173 = global_5.member[_e138].member.member_2[1u];
                        let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                        let _e181 = global_5.member[_e138].member.member_2[2u];
                        let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                        let _e189 = global_5.member[_e138].member.member[0u];
                        let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                        let _e197 = global_5.member[_e138].member.member[1u];
                        let _e199 = (bitcast<u32>(_e197) & 2147483647u);
                        let _e205 = global_5.member[_e138].member.member[2u];
                        let _e207 = (bitcast<u32>(_e205) & 2147483647u);
                        let _e209 = select(_e175, _e167, (_e175 < _e167));
                        let _e211 = select(_e183, _e209, (_e183 < _e209));
                        let _e213 = select(_e191, _e211, (_e191 < _e211));
                        let _e215 = select(_e199, _e213, (_e199 < _e213));
                        let _e217 = select(_e207, _e215, (_e207 < _e215));
                        let _e222 = global_5.member[_e138].member.member_1;
                        let _e223 = bitcast<u32>(_e222);
                        let _e224 = (_e223 & 2147483647u);
                        let _e232 = global_5.member[_e138].member.member_3;
                        let _e233 = bitcast<u32>(_e232);
                        let _e234 = (_e233 & 2147483647u);
                        let _e238 = (((select(_e224, _e217, (_e224 < _e217)) < 2139095040u) && (_e234 <= 2139095040u)) && (_e211 > 0u));
                        if _e238 {
                            let _e241 = (bitcast<u32>(bitcast<f32>(_e211)) & 2147483647u);
                            if (_e241 >= 8388608u) {
                                phi_512_ = (bitcast<i32>((_e241 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_512_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e241)), 32u, (_e241 == 0u))));
                            }
                            let _e255 = phi_512_;
                            phi_513_ = _e255;
                        } else {
                            phi_513_ = 0i;
                        }
                        let _e257 = phi_513_;
                        let _e258 = (_e167 == _e211);
                        if _e258 {
                            phi_523_ = true;
                        } else {
                            phi_523_ = (_e175 == _e211);
                        }
                        let _e261 = phi_523_;
                        let _e262 = select(1u, 0u, _e258);
                        if _e261 {
                            let _e263 = (_e262 + 1u);
                            phi_533_ = _e263;
                            phi_534_ = _e263;
                            phi_536_ = select(true, false, (_e263 == 2u));
                        } else {
                            phi_533_ = u32();
                            phi_534_ = 0u;
                            phi_536_ = true;
                        }
                        let _e267 = phi_533_;
                        let _e269 = phi_534_;
                        let _e271 = phi_536_;
                        if _e271 {
                            phi_541_ = (_e269 + 1u);
                        } else {
                            phi_541_ = 0u;
                        }
                        let _e275 = phi_541_;
                        let _e276 = select(_e267, _e269, _e271);
                        let _e277 = select(_e262, select(2u, _e262, _e261), _e271);
                        let _e278 = -(_e257);
                        if (_e278 < -126i) {
                            phi_574_ = -126i;
                        } else {
                            phi_574_ = select(_e278, 127i, (_e278 > 127i));
                        }
                        let _e283 = phi_574_;
                        let _e288 = bitcast<f32>((bitcast<u32>((_e283 + 127i)) << bitcast<u32>(23i)));
                        let _e294 = bitcast<f32>((bitcast<u32>(((_e278 - _e283) + 127i)) << bitcast<u32>(23i)));
                        let _e299 = global_5.member[_e138].member.member;
                        let _e300 = (_e276 == 0u);
                        if _e300 {
                            phi_592_ = _e299[0];
                        } else {
                            phi_592_ = _e299[1];
                        }
                        let _e304 = phi_592_;
                        let _e305 = (_e276 == 2u);
                        if _e305 {
                            phi_598_ = _e299[2];
                        } else {
                            phi_598_ = _e304;
                        }
                        let _e308 = phi_598_;
                        let _e309 = bitcast<u32>(_e308);
                        let _e311 = ((_e309 & 2139095040u) != 0u);
                        let _e323 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e309 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e309 & 2147483648u))), _e308, _e311) * select(0.00000011920929f, 1f, _e311));
                        let _e324 = global_5.member[_e138].member.member_2;
                        if _e300 {
                            phi_638_ = _e324[0];
                        } else {
                            phi_638_ = _e324[1];
                        }
                        let _e328 = phi_638_;
                        if _e305 {
                            phi_644_ = _e324[2];
                        } else {
                            phi_644_ = _e328;
                        }
                        let _e331 = phi_644_;
                        let _e332 = bitcast<u32>(_e331);
                        let _e334 = ((_e332 & 2139095040u) != 0u);
                        let _e348 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e332 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e332 & 2147483648u))), _e331, _e334) * _e288) * select(0.00000011920929f, 1f, _e334)) * _e294);
                        let _e352 = (bitcast<f32>((bitcast<u32>(_e348) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e355 = bitcast<f32>((bitcast<u32>(_e323) & 2147483647u));
                        let _e356 = (_e355 * 0.00000011920929f);
                        let _e359 = select(select(0.00000000000011368684f, _e356, (_e356 > 0.00000000000011368684f)), 0f, _e352);
                        let _e360 = select(0f, _e348, _e352);
                        let _e361 = (_e323 + _e359);
                        let _e362 = (_e323 - _e359);
                        let _e364 = select(38685626000000000000000000f, (1f / _e348), _e352);
                        let _e365 = (_e275 == 0u);
                        if _e365 {
                            phi_717_ = _e299[0];
                        } else {
                            phi_717_ = _e299[1];
                        }
                        let _e369 = phi_717_;
                        let _e370 = (_e275 == 2u);
                        if _e370 {
                            phi_723_ = _e299[2];
                        } else {
                            phi_723_ = _e369;
                        }
                        let _e373 = phi_723_;
                        let _e374 = bitcast<u32>(_e373);
                        let _e376 = ((_e374 & 2139095040u) != 0u);
                        let _e388 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e374 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e374 & 2147483648u))), _e373, _e376) * select(0.00000011920929f, 1f, _e376));
                        if _e365 {
                            phi_763_ = _e324[0];
                        } else {
                            phi_763_ = _e324[1];
                        }
                        let _e392 = phi_763_;
                        if _e370 {
                            phi_769_ = _e324[2];
                        } else {
                            phi_769_ = _e392;
                        }
                        let _e395 = phi_769_;
                        let _e396 = bitcast<u32>(_e395);
                        let _e398 = ((_e396 & 2139095040u) != 0u);
                        let _e412 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e396 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e396 & 2147483648u))), _e395, _e398) * _e288) * select(0.00000011920929f, 1f, _e398)) * _e294);
                        let _e416 = (bitcast<f32>((bitcast<u32>(_e412) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e419 = bitcast<f32>((bitcast<u32>(_e388) & 2147483647u));
                        let _e420 = (_e419 * 0.00000011920929f);
                        let _e423 = select(select(0.00000000000011368684f, _e420, (_e420 > 0.00000000000011368684f)), 0f, _e416);
                        let _e424 = select(0f, _e412, _e416);
                        let _e425 = (_e388 + _e423);
                        let _e426 = (_e388 - _e423);
                        let _e428 = select(38685626000000000000000000f, (1f / _e412), _e416);
                        let _e429 = (_e277 == 0u);
                        if _e429 {
                            phi_842_ = _e299[0];
                        } else {
                            phi_842_ = _e299[1];
                        }
                        let _e433 = phi_842_;
                        let _e434 = (_e277 == 2u);
                        if _e434 {
                            phi_848_ = _e299[2];
                        } else {
                            phi_848_ = _e433;
                        }
                        let _e437 = phi_848_;
                        let _e438 = bitcast<u32>(_e437);
                        let _e440 = ((_e438 & 2139095040u) != 0u);
                        let _e452 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e438 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e438 & 2147483648u))), _e437, _e440) * select(0.00000011920929f, 1f, _e440));
                        if _e429 {
                            phi_888_ = _e324[0];
                        } else {
                            phi_888_ = _e324[1];
                        }
                        let _e456 = phi_888_;
                        if _e434 {
                            phi_894_ = _e324[2];
                        } else {
                            phi_894_ = _e456;
                        }
                        let _e459 = phi_894_;
                        let _e460 = bitcast<u32>(_e459);
                        let _e462 = ((_e460 & 2139095040u) != 0u);
                        let _e476 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e460 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e460 & 2147483648u))), _e459, _e462) * _e288) * select(0.00000011920929f, 1f, _e462)) * _e294);
                        let _e480 = (bitcast<f32>((bitcast<u32>(_e476) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e483 = bitcast<f32>((bitcast<u32>(_e452) & 2147483647u));
                        let _e484 = (_e483 * 0.00000011920929f);
                        let _e487 = select(select(0.00000000000011368684f, _e484, (_e484 > 0.00000000000011368684f)), 0f, _e480);
                        let _e488 = select(0f, _e476, _e480);
                        let _e489 = (_e452 + _e487);
                        let _e490 = (_e452 - _e487);
                        let _e492 = select(38685626000000000000000000f, (1f / _e476), _e480);
                        let _e494 = select(_e419, _e355, (_e355 > _e419));
                        if (_e238 && (select(_e483, _e494, (_e494 > _e483)) <= 1099511600000f)) {
                            let _e506 = ((_e224 & 8388607u) | (select(0u, 1u, ((_e224 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e509 = bitcast<i32>((_e224 >> bitcast<u32>(23i)));
                            let _e513 = (_e506 == 0u);
                            let _e516 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e506)), 32u, _e513)) - 8i);
                            if (_e509 == 255i) {
                                phi_1013_ = 255i;
                            } else {
                                phi_1013_ = (((_e509 + select(0i, 1i, (_e509 == 0i))) - _e516) + _e257);
                            }
                            let _e524 = phi_1013_;
                            let _e534 = (_e524 <= 0i);
                            if _e534 {
                                phi_1036_ = u32();
                            } else {
                                if _e513 {
                                    phi_1035_ = u32();
                                } else {
                                    phi_1035_ = select(((bitcast<u32>(_e524) << bitcast<u32>(23i)) | ((_e506 << bitcast<u32>(((_e516 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e524 >= 255i));
                                }
                                let _e538 = phi_1035_;
                                phi_1036_ = _e538;
                            }
                            let _e540 = phi_1036_;
                            let _e552 = ((_e234 & 8388607u) | (select(0u, 1u, ((_e234 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e555 = bitcast<i32>((_e234 >> bitcast<u32>(23i)));
                            let _e559 = (_e552 == 0u);
                            let _e562 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e552)), 32u, _e559)) - 8i);
                            if (_e555 == 255i) {
                                phi_1073_ = 255i;
                            } else {
                                phi_1073_ = (((_e555 + select(0i, 1i, (_e555 == 0i))) - _e562) + _e257);
                            }
                            let _e570 = phi_1073_;
                            let _e580 = (_e570 <= 0i);
                            if _e580 {
                                phi_1096_ = u32();
                            } else {
                                if _e559 {
                                    phi_1095_ = u32();
                                } else {
                                    phi_1095_ = select(((bitcast<u32>(_e570) << bitcast<u32>(23i)) | ((_e552 << bitcast<u32>(((_e562 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e570 >= 255i));
                                }
                                let _e584 = phi_1095_;
                                phi_1096_ = _e584;
                            }
                            let _e586 = phi_1096_;
                            phi_1104_ = bitcast<f32>(((_e233 & 2147483648u) | select(_e586, 0u, select(_e559, true, _e580))));
                            phi_1105_ = bitcast<f32>(((_e223 & 2147483648u) | select(_e540, 0u, select(_e513, true, _e534))));
                        } else {
                            phi_1104_ = 0f;
                            phi_1105_ = 1f;
                        }
                        let _e592 = phi_1104_;
                        let _e594 = phi_1105_;
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e600 = global_5.member[_e138].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e605 = (_e276 % 3u);
                        let _e606 = (_e605 < 3u);
                        if _e606 {
                        } else {
                            break;
                        }
                        let _e608 = local_1[_e605];
                        let _e611 = (_e275 % 3u);
                        let _e612 = (_e611 < 3u);
                        if _e612 {
                        } else {
                            break;
                        }
                        let _e614 = local_1[_e611];
                        let _e617 = (_e277 % 3u);
                        let _e618 = (_e617 < 3u);
                        if _e618 {
                        } else {
                            break;
                        }
                        let _e620 = local_1[_e617];
                        if _e606 {
                        } else {
                            break;
                        }
                        let _e625 = local[_e605];
                        if _e612 {
                        } else {
                            break;
                        }
                        let _e629 = local[_e611];
                        if _e618 {
                        } else {
                            break;
                        }
                        let _e633 = local[_e617];
                        phi_4143_ = false;
                        phi_1210_ = type_47(type_43(type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e592), 0u, 0u);
                        phi_1213_ = (_e594 <= _e592);
                        phi_1215_ = type_54(type_38(vec4<f32>((f32(_e608) * _e150), (f32(_e614) * _e150), (f32(_e620) * _e150), 0f), vec4<f32>((f32(_e625) * _e150), (f32(_e629) * _e150), (f32(_e633) * _e150), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                        phi_1217_ = 0u;
                        phi_1219_ = ((3u * _e96) + 1u);
                        loop {
                            let _e641 = phi_4143_;
                            let _e643 = phi_1210_;
                            let _e645 = phi_1213_;
                            let _e647 = phi_1215_;
                            let _e649 = phi_1217_;
                            let _e651 = phi_1219_;
                            local_11 = _e643;
                            local_12 = _e643;
                            if _e645 {
                                phi_1230_ = true;
                            } else {
                                phi_1230_ = (_e649 > 0u);
                            }
                            let _e654 = phi_1230_;
                            if _e654 {
                                let _e655 = (_e651 > 0u);
                                if _e655 {
                                    if _e645 {
                                        phi_1316_ = _e645;
                                        phi_1317_ = _e647;
                                        phi_1318_ = _e649;
                                    } else {
                                        let _e656 = (_e649 - 1u);
                                        let _e657 = (_e656 % 128u);
                                        let _e658 = (_e657 < 128u);
                                        if _e658 {
                                        } else {
                                            phi_4290_ = true;
                                            break;
                                        }
                                        let _e660 = local_7[_e657];
                                        if _e658 {
                                        } else {
                                            phi_4290_ = true;
                                            break;
                                        }
                                        let _e662 = local_6[_e657];
                                        if _e658 {
                                        } else {
                                            phi_4290_ = true;
                                            break;
                                        }
                                        let _e664 = local_5[_e657];
                                        if _e658 {
                                        } else {
                                            phi_4290_ = true;
                                            break;
                                        }
                                        let _e666 = local_4[_e657];
                                        if _e658 {
                                        } else {
                                            phi_4290_ = true;
                                            break;
                                        }
                                        let _e668 = local_3[_e657];
                                        if _e658 {
                                        } else {
                                            phi_4290_ = true;
                                            break;
                                        }
                                        let _e670 = local_2[_e657];
                                        if _e658 {
                                        } else {
                                            phi_4290_ = true;
                                            break;
                                        }
                                        let _e675 = local_8[_e657];
                                        if _e658 {
                                        } else {
                                            phi_4290_ = true;
                                            break;
                                        }
                                        let _e678 = local_9[_e657];
                                        phi_1316_ = (_e678 <= _e643.member.member_1);
                                        phi_1317_ = type_54(type_38(vec4<f32>(_e660, _e662, _e664, 0f), vec4<f32>(_e666, _e668, _e670, 0f)), _e675);
                                        phi_1318_ = _e656;
                                    }
                                    let _e683 = phi_1316_;
                                    let _e685 = phi_1317_;
                                    let _e687 = phi_1318_;
                                    if _e683 {
                                        if ((_e685.member_1 & 2147483648u) != 0u) {
                                            phi_1336_ = _e643;
                                            phi_1339_ = type_7(0u, ((_e685.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1143 = phi_1336_;
                                                let _e1145 = phi_1339_;
                                                local_10 = _e1143;
                                                local_13 = _e1143;
                                                if (_e1145.member < _e1145.member_1) {
                                                    phi_1340_ = type_7((_e1145.member + 1u), _e1145.member_1);
                                                    phi_1362_ = type_7(1u, _e1145.member);
                                                } else {
                                                    phi_1340_ = _e1145;
                                                    phi_1362_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1158 = phi_1340_;
                                                let _e1160 = phi_1362_;
                                                let _e1164 = (bitcast<i32>(_e1160.member) != 0i);
                                                if _e1164 {
                                                    let _e1170 = type_47(_e1143.member, _e1143.member_1, (_e1143.member_2 + 1u));
                                                    let _e1171 = ((_e685.member_1 & 268435455u) + _e1160.member_1);
                                                    let _e1172 = (_e1171 < _e98);
                                                    if _e1172 {
                                                        if _e1172 {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1176 = global_1.member[_e1171].member_1;
                                                        phi_1386_ = _e1176;
                                                    } else {
                                                        phi_1386_ = 4294967295u;
                                                    }
                                                    let _e1178 = phi_1386_;
                                                    if (_e1171 >= _e98) {
                                                        phi_1478_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1172 {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        if (_e605 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1185 = global_1.member[_e1171].member[_e605];
                                                        if (_e611 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1191 = global_1.member[_e1171].member[_e611];
                                                        if (_e617 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1197 = global_1.member[_e1171].member[_e617];
                                                        let _e1199 = (3u + _e605);
                                                        if (_e1199 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1205 = global_1.member[_e1171].member[_e1199];
                                                        let _e1206 = (3u + _e611);
                                                        if (_e1206 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1212 = global_1.member[_e1171].member[_e1206];
                                                        let _e1213 = (3u + _e617);
                                                        if (_e1213 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1219 = global_1.member[_e1171].member[_e1213];
                                                        let _e1221 = (6u + _e605);
                                                        if (_e1221 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1227 = global_1.member[_e1171].member[_e1221];
                                                        let _e1228 = (6u + _e611);
                                                        if (_e1228 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1234 = global_1.member[_e1171].member[_e1228];
                                                        let _e1235 = (6u + _e617);
                                                        if (_e1235 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1241 = global_1.member[_e1171].member[_e1235];
                                                        phi_1478_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1185, _e1191, _e1197), array<f32, 3>(_e1205, _e1212, _e1219), array<f32, 3>(_e1227, _e1234, _e1241));
                                                    }
                                                    let _e1245 = phi_1478_;
                                                    let _e1262 = (_e1245[0][2] - _e452);
                                                    let _e1265 = (((_e1245[0][0] - _e323) * _e488) - (_e1262 * _e360));
                                                    let _e1268 = (((_e1245[0][1] - _e388) * _e488) - (_e1262 * _e424));
                                                    let _e1271 = (_e1245[1][2] - _e452);
                                                    let _e1274 = (((_e1245[1][0] - _e323) * _e488) - (_e1271 * _e360));
                                                    let _e1277 = (((_e1245[1][1] - _e388) * _e488) - (_e1271 * _e424));
                                                    let _e1280 = (_e1245[2][2] - _e452);
                                                    let _e1283 = (((_e1245[2][0] - _e323) * _e488) - (_e1280 * _e360));
                                                    let _e1286 = (((_e1245[2][1] - _e388) * _e488) - (_e1280 * _e424));
                                                    let _e1287 = (_e1283 * _e1277);
                                                    let _e1288 = (_e1286 * _e1274);
                                                    let _e1289 = (_e1265 * _e1286);
                                                    let _e1290 = (_e1268 * _e1283);
                                                    let _e1291 = (_e1274 * _e1268);
                                                    let _e1292 = (_e1277 * _e1265);
                                                    let _e1297 = (((_e1287 >= _e1288) && (_e1289 >= _e1290)) && (_e1291 >= _e1292));
                                                    let _e1303 = (_e1297 || (((_e1287 <= _e1288) && (_e1289 <= _e1290)) && (_e1291 <= _e1292)));
                                                    if _e1303 {
                                                        let _e1305 = select(-1f, 1f, _e1297);
                                                        let _e1307 = ((_e1287 - _e1288) * _e1305);
                                                        let _e1309 = select(0f, _e1307, (_e1307 > 0f));
                                                        let _e1311 = ((_e1289 - _e1290) * _e1305);
                                                        let _e1313 = select(0f, _e1311, (_e1311 > 0f));
                                                        let _e1315 = ((_e1291 - _e1292) * _e1305);
                                                        let _e1317 = select(0f, _e1315, (_e1315 > 0f));
                                                        let _e1319 = ((_e1309 + _e1313) + _e1317);
                                                        let _e1321 = select(_e1245[1][0], _e1245[0][0], (_e1245[0][0] < _e1245[1][0]));
                                                        let _e1325 = select(_e1245[1][0], _e1245[0][0], (_e1245[0][0] > _e1245[1][0]));
                                                        let _e1329 = select(_e1245[1][1], _e1245[0][1], (_e1245[0][1] < _e1245[1][1]));
                                                        let _e1333 = select(_e1245[1][1], _e1245[0][1], (_e1245[0][1] > _e1245[1][1]));
                                                        let _e1337 = select(_e1245[1][2], _e1245[0][2], (_e1245[0][2] < _e1245[1][2]));
                                                        let _e1341 = select(_e1245[1][2], _e1245[0][2], (_e1245[0][2] > _e1245[1][2]));
                                                        let _e1346 = ((select(_e1245[2][0], _e1321, (_e1321 < _e1245[2][0])) - _e361) * _e364);
                                                        let _e1347 = ((select(_e1245[2][0], _e1325, (_e1325 > _e1245[2][0])) - _e362) * _e364);
                                                        let _e1350 = ((select(_e1245[2][1], _e1329, (_e1329 < _e1245[2][1])) - _e425) * _e428);
                                                        let _e1351 = ((select(_e1245[2][1], _e1333, (_e1333 > _e1245[2][1])) - _e426) * _e428);
                                                        let _e1354 = ((select(_e1245[2][2], _e1337, (_e1337 < _e1245[2][2])) - _e489) * _e492);
                                                        let _e1355 = ((select(_e1245[2][2], _e1341, (_e1341 > _e1245[2][2])) - _e490) * _e492);
                                                        let _e1357 = select(_e1355, _e1354, (_e1354 < _e1355));
                                                        let _e1359 = select(_e1355, _e1354, (_e1354 > _e1355));
                                                        let _e1361 = select(_e1347, _e1346, (_e1346 < _e1347));
                                                        let _e1363 = select(_e1351, _e1350, (_e1350 < _e1351));
                                                        let _e1365 = select(_e1363, _e1361, (_e1361 > _e1363));
                                                        let _e1367 = select(_e1357, _e1365, (_e1365 > _e1357));
                                                        let _e1369 = select(_e1347, _e1346, (_e1346 > _e1347));
                                                        let _e1371 = select(_e1351, _e1350, (_e1350 > _e1351));
                                                        let _e1373 = select(_e1371, _e1369, (_e1369 < _e1371));
                                                        let _e1375 = select(_e1359, _e1373, (_e1373 < _e1359));
                                                        let _e1376 = -(_e1357);
                                                        let _e1382 = select(_e594, _e1367, (_e1367 > _e594));
                                                        let _e1386 = select(_e1274, _e1265, (_e1265 < _e1274));
                                                        let _e1391 = select(_e1274, _e1265, (_e1265 > _e1274));
                                                        let _e1398 = select(_e1277, _e1268, (_e1268 < _e1277));
                                                        let _e1403 = select(_e1277, _e1268, (_e1268 > _e1277));
                                                        let _e1412 = (((((_e1303 && (_e1319 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1283, _e1386, (_e1386 < _e1283)) <= 0f) && (select(_e1283, _e1391, (_e1391 > _e1283)) >= 0f))) && ((select(_e1286, _e1398, (_e1398 < _e1286)) <= 0f) && (select(_e1286, _e1403, (_e1403 > _e1286)) >= 0f))) && (_e1382 <= (_e1375 + (select(_e1376, _e1359, (_e1359 > _e1376)) * 0.0000019073523f)))) && (_e1382 <= _e1143.member.member_1));
                                                        if _e1412 {
                                                            let _e1417 = (_e1245[1][0] - _e1245[0][0]);
                                                            let _e1418 = (_e1245[1][1] - _e1245[0][1]);
                                                            let _e1419 = (_e1245[1][2] - _e1245[0][2]);
                                                            let _e1420 = vec3<f32>(_e1417, _e1418, _e1419);
                                                            let _e1421 = (_e1245[2][0] - _e1245[1][0]);
                                                            let _e1422 = (_e1245[2][1] - _e1245[1][1]);
                                                            let _e1423 = (_e1245[2][2] - _e1245[1][2]);
                                                            let _e1424 = vec3<f32>(_e1421, _e1422, _e1423);
                                                            let _e1425 = (_e1245[0][0] - _e1245[2][0]);
                                                            let _e1426 = (_e1245[0][1] - _e1245[2][1]);
                                                            let _e1427 = (_e1245[0][2] - _e1245[2][2]);
                                                            let _e1428 = vec3<f32>(_e1425, _e1426, _e1427);
                                                            let _e1431 = bitcast<f32>((bitcast<u32>(_e1417) & 2147483647u));
                                                            let _e1434 = bitcast<f32>((bitcast<u32>(_e1418) & 2147483647u));
                                                            let _e1436 = select(_e1434, _e1431, (_e1431 > _e1434));
                                                            let _e1439 = bitcast<f32>((bitcast<u32>(_e1419) & 2147483647u));
                                                            let _e1441 = select(_e1439, _e1436, (_e1436 > _e1439));
                                                            let _e1444 = bitcast<f32>((bitcast<u32>(_e1421) & 2147483647u));
                                                            let _e1447 = bitcast<f32>((bitcast<u32>(_e1422) & 2147483647u));
                                                            let _e1449 = select(_e1447, _e1444, (_e1444 > _e1447));
                                                            let _e1452 = bitcast<f32>((bitcast<u32>(_e1423) & 2147483647u));
                                                            let _e1454 = select(_e1452, _e1449, (_e1449 > _e1452));
                                                            let _e1457 = bitcast<f32>((bitcast<u32>(_e1425) & 2147483647u));
                                                            let _e1460 = bitcast<f32>((bitcast<u32>(_e1426) & 2147483647u));
                                                            let _e1462 = select(_e1460, _e1457, (_e1457 > _e1460));
                                                            let _e1465 = bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u));
                                                            let _e1467 = select(_e1465, _e1462, (_e1462 > _e1465));
                                                            let _e1469 = select(_e1454, _e1441, (_e1441 > _e1454));
                                                            let _e1471 = select(_e1467, _e1469, (_e1469 > _e1467));
                                                            if (_e1441 == _e1471) {
                                                                phi_2008_ = _e1277;
                                                                phi_2009_ = _e1274;
                                                                phi_2010_ = _e1268;
                                                                phi_2011_ = _e1265;
                                                                phi_2012_ = vec3<f32>(_e1245[0][0], _e1245[0][1], _e1245[0][2]);
                                                                phi_2013_ = _e1428;
                                                                phi_2014_ = _e1424;
                                                                phi_2015_ = _e1420;
                                                            } else {
                                                                let _e1473 = (_e1454 == _e1471);
                                                                let _e1478 = vec3(_e1473);
                                                                phi_2008_ = select(_e1268, _e1286, _e1473);
                                                                phi_2009_ = select(_e1265, _e1283, _e1473);
                                                                phi_2010_ = select(_e1286, _e1277, _e1473);
                                                                phi_2011_ = select(_e1283, _e1274, _e1473);
                                                                phi_2012_ = select(vec3<f32>(_e1245[2][0], _e1245[2][1], _e1245[2][2]), vec3<f32>(_e1245[1][0], _e1245[1][1], _e1245[1][2]), _e1478);
                                                                phi_2013_ = select(_e1424, _e1420, _e1478);
                                                                phi_2014_ = select(_e1420, _e1428, _e1478);
                                                                phi_2015_ = select(_e1428, _e1424, _e1478);
                                                            }
                                                            let _e1484 = phi_2008_;
                                                            let _e1486 = phi_2009_;
                                                            let _e1488 = phi_2010_;
                                                            let _e1490 = phi_2011_;
                                                            let _e1492 = phi_2012_;
                                                            let _e1494 = phi_2013_;
                                                            let _e1496 = phi_2014_;
                                                            let _e1498 = phi_2015_;
                                                            let _e1505 = ((_e1496.y * _e1494.z) - (_e1494.y * _e1496.z));
                                                            let _e1510 = ((_e1496.z * _e1494.x) - (_e1494.z * _e1496.x));
                                                            let _e1513 = ((_e1496.x * _e1494.y) - (_e1494.x * _e1496.y));
                                                            let _e1516 = ((_e1309 >= _e1313) && (_e1309 >= _e1317));
                                                            let _e1517 = (_e1313 >= _e1317);
                                                            let _e1531 = (((_e1505 * (select(select(_e1245[2][0], _e1245[1][0], _e1517), _e1245[0][0], _e1516) - _e323)) + (_e1510 * (select(select(_e1245[2][1], _e1245[1][1], _e1517), _e1245[0][1], _e1516) - _e388))) + (_e1513 * (select(select(_e1245[2][2], _e1245[1][2], _e1517), _e1245[0][2], _e1516) - _e452)));
                                                            let _e1536 = (((_e1505 * _e360) + (_e1510 * _e424)) + (_e1513 * _e488));
                                                            let _e1537 = (_e1486 - _e1490);
                                                            let _e1538 = (_e1484 - _e1488);
                                                            let _e1541 = ((_e1537 * _e1537) + (_e1538 * _e1538));
                                                            let _e1548 = (-(((_e1490 * _e1537) + (_e1488 * _e1538))) / select(0.000000000000000000000000000000000000011754944f, _e1541, (_e1541 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1550 = select(1f, _e1548, (_e1548 < 1f));
                                                            let _e1552 = select(0f, _e1550, (_e1550 > 0f));
                                                            let _e1561 = ((_e1492.x + (_e1498.x * _e1552)) - _e323);
                                                            let _e1564 = ((_e1492.y + (_e1498.y * _e1552)) - _e388);
                                                            let _e1567 = ((_e1492.z + (_e1498.z * _e1552)) - _e452);
                                                            let _e1570 = bitcast<f32>((bitcast<u32>(_e1561) & 2147483647u));
                                                            let _e1573 = bitcast<f32>((bitcast<u32>(_e1564) & 2147483647u));
                                                            let _e1575 = select(_e1573, _e1570, (_e1570 > _e1573));
                                                            let _e1578 = bitcast<f32>((bitcast<u32>(_e1567) & 2147483647u));
                                                            let _e1580 = select(_e1578, _e1575, (_e1575 > _e1578));
                                                            let _e1586 = bitcast<f32>((bitcast<u32>(_e1505) & 2147483647u));
                                                            let _e1589 = bitcast<f32>((bitcast<u32>(_e1510) & 2147483647u));
                                                            let _e1591 = select(_e1589, _e1586, (_e1586 > _e1589));
                                                            let _e1594 = bitcast<f32>((bitcast<u32>(_e1513) & 2147483647u));
                                                            let _e1613 = bitcast<f32>((bitcast<u32>(_e1496.x) & 2147483647u));
                                                            let _e1616 = bitcast<f32>((bitcast<u32>(_e1496.y) & 2147483647u));
                                                            let _e1618 = select(_e1616, _e1613, (_e1613 > _e1616));
                                                            let _e1621 = bitcast<f32>((bitcast<u32>(_e1496.z) & 2147483647u));
                                                            let _e1627 = bitcast<f32>((bitcast<u32>(_e1494.x) & 2147483647u));
                                                            let _e1630 = bitcast<f32>((bitcast<u32>(_e1494.y) & 2147483647u));
                                                            let _e1632 = select(_e1630, _e1627, (_e1627 > _e1630));
                                                            let _e1635 = bitcast<f32>((bitcast<u32>(_e1494.z) & 2147483647u));
                                                            let _e1641 = ((bitcast<f32>((bitcast<u32>(((((_e1505 * _e1561) + (_e1510 * _e1564)) + (_e1513 * _e1567)) - _e1531)) & 2147483647u)) <= ((0.0000009536743f * select(_e1471, _e1580, (_e1580 > _e1471))) * select(_e1594, _e1591, (_e1591 > _e1594)))) && !((bitcast<f32>((bitcast<u32>(_e1536) & 2147483647u)) <= ((0.0000038146973f * select(_e1621, _e1618, (_e1618 > _e1621))) * select(_e1635, _e1632, (_e1632 > _e1635))))));
                                                            let _e1642 = (_e1531 / _e1536);
                                                            if (_e1412 && !(_e1641)) {
                                                                let _e1645 = (_e1567 / _e488);
                                                                let _e1653 = (((_e1505 * (_e1561 - (_e360 * _e1645))) + (_e1510 * (_e1564 - (_e424 * _e1645)))) / _e1536);
                                                                phi_2206_ = select(select(_e1645, (_e1645 + _e1653), (bitcast<f32>((bitcast<u32>(_e1653) & 2147483647u)) <= _e1471)), _e1642, _e1641);
                                                            } else {
                                                                phi_2206_ = _e1642;
                                                            }
                                                            let _e1662 = phi_2206_;
                                                            let _e1664 = select(_e1375, _e1662, (_e1662 < _e1375));
                                                            let _e1666 = select(_e1367, _e1664, (_e1664 > _e1367));
                                                            let _e1667 = (1f / _e1319);
                                                            phi_2226_ = type_46(_e1666, (_e1313 * _e1667), (_e1317 * _e1667), ((_e1412 && (_e1666 >= _e594)) && (_e1666 <= _e1143.member.member_1)));
                                                            phi_2227_ = type_46();
                                                        } else {
                                                            phi_2226_ = type_46();
                                                            phi_2227_ = type_46(0f, 0f, 0f, _e1412);
                                                        }
                                                        let _e1676 = phi_2226_;
                                                        let _e1678 = phi_2227_;
                                                        phi_2230_ = _e1676;
                                                        phi_2231_ = _e1678;
                                                        phi_2232_ = select(true, false, _e1412);
                                                    } else {
                                                        phi_2230_ = type_46();
                                                        phi_2231_ = type_46(0f, 0f, 0f, _e1303);
                                                        phi_2232_ = true;
                                                    }
                                                    let _e1681 = phi_2230_;
                                                    let _e1683 = phi_2231_;
                                                    let _e1685 = phi_2232_;
                                                    if _e1685 {
                                                        phi_2236_ = _e1683;
                                                    } else {
                                                        phi_2236_ = _e1681;
                                                    }
                                                    let _e1687 = phi_2236_;
                                                    if _e1687.member_3 {
                                                        phi_2245_ = type_26(_e1687.member, _e1687.member_1, _e1687.member_2, _e1178);
                                                    } else {
                                                        phi_2245_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1694 = phi_2245_;
                                                    if (_e1694.member_3 != 4294967295u) {
                                                        if (_e1178 != _e600) {
                                                            if (_e1694.member < _e1143.member.member.member) {
                                                                phi_2271_ = true;
                                                            } else {
                                                                if (_e1694.member == _e1143.member.member.member) {
                                                                    phi_2270_ = (_e1694.member_3 < _e1143.member.member.member_3);
                                                                } else {
                                                                    phi_2270_ = false;
                                                                }
                                                                let _e1709 = phi_2270_;
                                                                phi_2271_ = _e1709;
                                                            }
                                                            let _e1711 = phi_2271_;
                                                            if _e1711 {
                                                                phi_2278_ = type_47(type_43(_e1694, _e1694.member), _e1170.member_1, _e1170.member_2);
                                                            } else {
                                                                phi_2278_ = _e1170;
                                                            }
                                                            let _e1718 = phi_2278_;
                                                            phi_2279_ = _e1718;
                                                        } else {
                                                            phi_2279_ = _e1170;
                                                        }
                                                        let _e1720 = phi_2279_;
                                                        phi_2280_ = _e1720;
                                                    } else {
                                                        phi_2280_ = _e1170;
                                                    }
                                                    let _e1722 = phi_2280_;
                                                    phi_1337_ = _e1722;
                                                } else {
                                                    phi_1337_ = type_47();
                                                }
                                                let _e1724 = phi_1337_;
                                                continue;
                                                continuing {
                                                    phi_1336_ = _e1724;
                                                    phi_1339_ = _e1158;
                                                    phi_4137_ = _e641;
                                                    break if !(_e1164);
                                                }
                                            }
                                            let _e1727 = phi_4137_;
                                            phi_4290_ = _e1727;
                                            if _e1727 {
                                                break;
                                            }
                                            let _e1729 = local_10;
                                            phi_4294_ = _e1727;
                                            let _e2044 = local_13;
                                            phi_3510_ = _e2044;
                                            phi_3511_ = false;
                                            phi_3512_ = _e685;
                                            phi_3513_ = select(_e687, 0u, (_e594 > _e1729.member.member_1));
                                        } else {
                                            if (_e685.member_1 >= _e96) {
                                                phi_3046_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_54(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_54(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e685.member_1 < _e96) {
                                                } else {
                                                    phi_4290_ = true;
                                                    break;
                                                }
                                                let _e699 = ((1u + _e276) % 4u);
                                                if (_e699 < 4u) {
                                                } else {
                                                    phi_4290_ = true;
                                                    break;
                                                }
                                                let _e704 = global_4.member[_e685.member_1][_e699];
                                                let _e706 = (_e704 >> bitcast<u32>(11u));
                                                let _e708 = ((1u + _e275) % 4u);
                                                if (_e708 < 4u) {
                                                } else {
                                                    phi_4290_ = true;
                                                    break;
                                                }
                                                let _e713 = global_4.member[_e685.member_1][_e708];
                                                let _e715 = (_e713 >> bitcast<u32>(11u));
                                                let _e717 = ((1u + _e277) % 4u);
                                                if (_e717 < 4u) {
                                                } else {
                                                    phi_4290_ = true;
                                                    break;
                                                }
                                                let _e722 = global_4.member[_e685.member_1][_e717];
                                                let _e724 = (_e722 >> bitcast<u32>(11u));
                                                let _e747 = (bitcast<f32>((bitcast<u32>((_e685.member.member_1.x - _e685.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e748 = (bitcast<f32>((bitcast<u32>((_e685.member.member_1.y - _e685.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e749 = (bitcast<f32>((bitcast<u32>((_e685.member.member_1.z - _e685.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e751 = select(_e150, _e747, (_e747 > _e150));
                                                let _e753 = select(_e150, _e748, (_e748 > _e150));
                                                let _e755 = select(_e150, _e749, (_e749 > _e150));
                                                let _e786 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e704 & 1023u))) - 8388608f) * _e751));
                                                let _e791 = (bitcast<i32>((_e704 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e794 = bitcast<f32>((_e786 & bitcast<u32>(_e791)));
                                                let _e795 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e713 & 1023u))) - 8388608f) * _e753));
                                                let _e800 = (bitcast<i32>((_e713 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e803 = bitcast<f32>((_e795 & bitcast<u32>(_e800)));
                                                let _e804 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e722 & 1023u))) - 8388608f) * _e755));
                                                let _e809 = (bitcast<i32>((_e722 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e812 = bitcast<f32>((_e804 & bitcast<u32>(_e809)));
                                                let _e816 = bitcast<f32>((_e786 & bitcast<u32>(~(_e791))));
                                                let _e820 = bitcast<f32>((_e795 & bitcast<u32>(~(_e800))));
                                                let _e824 = bitcast<f32>((_e804 & bitcast<u32>(~(_e809))));
                                                let _e825 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e706 & 1023u))) - 8388608f) * _e751));
                                                let _e830 = (bitcast<i32>((_e706 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e833 = bitcast<f32>((_e825 & bitcast<u32>(_e830)));
                                                let _e834 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e715 & 1023u))) - 8388608f) * _e753));
                                                let _e839 = (bitcast<i32>((_e715 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e842 = bitcast<f32>((_e834 & bitcast<u32>(_e839)));
                                                let _e843 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e724 & 1023u))) - 8388608f) * _e755));
                                                let _e848 = (bitcast<i32>((_e724 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e851 = bitcast<f32>((_e843 & bitcast<u32>(_e848)));
                                                let _e855 = bitcast<f32>((_e825 & bitcast<u32>(~(_e830))));
                                                let _e859 = bitcast<f32>((_e834 & bitcast<u32>(~(_e839))));
                                                let _e863 = bitcast<f32>((_e843 & bitcast<u32>(~(_e848))));
                                                let _e893 = global_4.member[_e685.member_1][0u];
                                                let _e897 = global_4.member[_e685.member_1][1u];
                                                let _e901 = global_4.member[_e685.member_1][2u];
                                                let _e905 = global_4.member[_e685.member_1][3u];
                                                let _e917 = (((_e897 >> bitcast<u32>(22i)) | ((_e901 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e905 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e918 = (_e893 & 268435455u);
                                                let _e919 = (_e917 & 268435455u);
                                                let _e922 = ((_e893 >> bitcast<u32>(28u)) & 7u);
                                                let _e930 = ((_e893 >> bitcast<u32>(31i)) | (((_e917 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e931 = (_e922 != 0u);
                                                if (_e922 == 0u) {
                                                    phi_3008_ = _e918;
                                                } else {
                                                    if (_e922 == 7u) {
                                                        phi_3007_ = 2147483648u;
                                                    } else {
                                                        phi_3007_ = ((2147483648u | (_e922 << bitcast<u32>(28u))) | (_e919 & 268435455u));
                                                    }
                                                    let _e940 = phi_3007_;
                                                    phi_3008_ = _e940;
                                                }
                                                let _e942 = phi_3008_;
                                                if _e931 {
                                                    let _e943 = (_e922 != 7u);
                                                    if _e943 {
                                                        phi_3018_ = (_e919 + _e922);
                                                    } else {
                                                        phi_3018_ = u32();
                                                    }
                                                    let _e946 = phi_3018_;
                                                    phi_3020_ = _e946;
                                                    phi_3021_ = select(true, false, _e943);
                                                } else {
                                                    phi_3020_ = u32();
                                                    phi_3021_ = true;
                                                }
                                                let _e949 = phi_3020_;
                                                let _e951 = phi_3021_;
                                                if (_e930 == 0u) {
                                                    phi_3042_ = (_e918 + select(0u, 1u, !(_e931)));
                                                } else {
                                                    if (_e930 == 7u) {
                                                        phi_3041_ = 2147483648u;
                                                    } else {
                                                        phi_3041_ = ((2147483648u | (_e930 << bitcast<u32>(28u))) | (select(_e949, _e919, _e951) & 268435455u));
                                                    }
                                                    let _e964 = phi_3041_;
                                                    phi_3042_ = _e964;
                                                }
                                                let _e966 = phi_3042_;
                                                phi_3046_ = type_55(array<vec4<f32>, 3>(vec4<f32>((_e685.member.member.x + _e794), (_e685.member.member.x + _e816), (_e685.member.member_1.x - _e833), (_e685.member.member_1.x - _e855)), vec4<f32>((_e685.member.member.y + _e803), (_e685.member.member.y + _e820), (_e685.member.member_1.y - _e842), (_e685.member.member_1.y - _e859)), vec4<f32>((_e685.member.member.z + _e812), (_e685.member.member.z + _e824), (_e685.member.member_1.z - _e851), (_e685.member.member_1.z - _e863))), type_54(type_38((_e685.member.member + vec4<f32>(_e794, _e803, _e812, 0f)), (_e685.member.member_1 - vec4<f32>(_e833, _e842, _e851, 0f))), _e942), type_54(type_38((_e685.member.member + vec4<f32>(_e816, _e820, _e824, 0f)), (_e685.member.member_1 - vec4<f32>(_e855, _e859, _e863, 0f))), _e966));
                                            }
                                            let _e971 = phi_3046_;
                                            let _e990 = ((_e971.member[0].x - _e361) * _e364);
                                            let _e991 = ((_e971.member[0].y - _e361) * _e364);
                                            let _e992 = ((_e971.member[0].z - _e362) * _e364);
                                            let _e993 = ((_e971.member[0].w - _e362) * _e364);
                                            let _e1003 = ((_e971.member[1].x - _e425) * _e428);
                                            let _e1004 = ((_e971.member[1].y - _e425) * _e428);
                                            let _e1005 = ((_e971.member[1].z - _e426) * _e428);
                                            let _e1006 = ((_e971.member[1].w - _e426) * _e428);
                                            let _e1016 = ((_e971.member[2].x - _e489) * _e492);
                                            let _e1017 = ((_e971.member[2].y - _e489) * _e492);
                                            let _e1018 = ((_e971.member[2].z - _e490) * _e492);
                                            let _e1019 = ((_e971.member[2].w - _e490) * _e492);
                                            let _e1021 = select(_e1018, _e1016, (_e1016 < _e1018));
                                            let _e1023 = select(_e1019, _e1017, (_e1017 < _e1019));
                                            let _e1025 = select(_e1018, _e1016, (_e1016 > _e1018));
                                            let _e1027 = select(_e1019, _e1017, (_e1017 > _e1019));
                                            let _e1029 = select(_e992, _e990, (_e990 < _e992));
                                            let _e1031 = select(_e993, _e991, (_e991 < _e993));
                                            let _e1033 = select(_e1005, _e1003, (_e1003 < _e1005));
                                            let _e1035 = select(_e1006, _e1004, (_e1004 < _e1006));
                                            let _e1037 = select(_e1033, _e1029, (_e1029 > _e1033));
                                            let _e1039 = select(_e1035, _e1031, (_e1031 > _e1035));
                                            let _e1041 = select(_e1021, _e1037, (_e1037 > _e1021));
                                            let _e1043 = select(_e1023, _e1039, (_e1039 > _e1023));
                                            let _e1045 = select(_e992, _e990, (_e990 > _e992));
                                            let _e1047 = select(_e993, _e991, (_e991 > _e993));
                                            let _e1049 = select(_e1005, _e1003, (_e1003 > _e1005));
                                            let _e1051 = select(_e1006, _e1004, (_e1004 > _e1006));
                                            let _e1053 = select(_e1049, _e1045, (_e1045 < _e1049));
                                            let _e1055 = select(_e1051, _e1047, (_e1047 < _e1051));
                                            let _e1060 = -(_e1021);
                                            let _e1061 = -(_e1023);
                                            let _e1068 = (select(_e1025, _e1053, (_e1053 < _e1025)) + (select(_e1060, _e1025, (_e1025 > _e1060)) * 0.0000019073523f));
                                            let _e1069 = (select(_e1027, _e1055, (_e1055 < _e1027)) + (select(_e1061, _e1027, (_e1027 > _e1061)) * 0.0000019073523f));
                                            let _e1071 = select(_e594, _e1041, (_e1041 > _e594));
                                            let _e1073 = select(_e594, _e1043, (_e1043 > _e594));
                                            let _e1078 = (_e1071 <= select(_e643.member.member_1, _e1068, (_e1068 < _e643.member.member_1)));
                                            let _e1079 = (_e1073 <= select(_e643.member.member_1, _e1069, (_e1069 < _e643.member.member_1)));
                                            let _e1080 = (_e1071 <= _e1073);
                                            if _e1078 {
                                                if _e1079 {
                                                    if _e1080 {
                                                        phi_3411_ = _e971.member_2;
                                                    } else {
                                                        phi_3411_ = _e971.member_1;
                                                    }
                                                    let _e1084 = phi_3411_;
                                                    let _e1105 = (_e687 % 128u);
                                                    let _e1106 = (_e1105 < 128u);
                                                    if _e1106 {
                                                    } else {
                                                        phi_4290_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1105] = _e1084.member_1;
                                                    if _e1106 {
                                                    } else {
                                                        phi_4290_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1105] = _e1084.member.member.x;
                                                    if _e1106 {
                                                    } else {
                                                        phi_4290_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1105] = _e1084.member.member.y;
                                                    if _e1106 {
                                                    } else {
                                                        phi_4290_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1105] = _e1084.member.member.z;
                                                    if _e1106 {
                                                    } else {
                                                        phi_4290_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1105] = _e1084.member.member_1.x;
                                                    if _e1106 {
                                                    } else {
                                                        phi_4290_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1105] = _e1084.member.member_1.y;
                                                    if _e1106 {
                                                    } else {
                                                        phi_4290_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1105] = _e1084.member.member_1.z;
                                                    if _e1106 {
                                                    } else {
                                                        phi_4290_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1105] = select(_e1071, _e1073, _e1080);
                                                    if _e1080 {
                                                        phi_3487_ = _e971.member_1;
                                                    } else {
                                                        phi_3487_ = _e971.member_2;
                                                    }
                                                    let _e1119 = phi_3487_;
                                                    phi_3488_ = _e1119;
                                                    phi_3489_ = (_e687 + 1u);
                                                } else {
                                                    phi_3488_ = type_54();
                                                    phi_3489_ = u32();
                                                }
                                                let _e1121 = phi_3488_;
                                                let _e1123 = phi_3489_;
                                                phi_3491_ = _e1121;
                                                phi_3492_ = _e1123;
                                                phi_3493_ = select(true, false, _e1079);
                                            } else {
                                                phi_3491_ = type_54();
                                                phi_3492_ = u32();
                                                phi_3493_ = true;
                                            }
                                            let _e1126 = phi_3491_;
                                            let _e1128 = phi_3492_;
                                            let _e1130 = phi_3493_;
                                            if _e1130 {
                                                if _e1078 {
                                                    phi_3502_ = _e971.member_1;
                                                } else {
                                                    phi_3502_ = _e971.member_2;
                                                }
                                                let _e1134 = phi_3502_;
                                                phi_3507_ = select(_e1079, true, _e1078);
                                                phi_3508_ = _e1134;
                                            } else {
                                                phi_3507_ = _e683;
                                                phi_3508_ = _e1126;
                                            }
                                            let _e1137 = phi_3507_;
                                            let _e1139 = phi_3508_;
                                            phi_4294_ = _e641;
                                            phi_3510_ = type_47(_e643.member, (_e643.member_1 + 1u), _e643.member_2);
                                            phi_3511_ = _e1137;
                                            phi_3512_ = _e1139;
                                            phi_3513_ = select(_e1128, _e687, _e1130);
                                        }
                                        let _e1735 = phi_4294_;
                                        let _e1737 = phi_3510_;
                                        let _e1739 = phi_3511_;
                                        let _e1741 = phi_3512_;
                                        let _e1743 = phi_3513_;
                                        phi_4293_ = _e1735;
                                        phi_3514_ = _e1737;
                                        phi_3515_ = _e1739;
                                        phi_3516_ = _e1741;
                                        phi_3517_ = _e1743;
                                        phi_3518_ = (_e651 - 1u);
                                    } else {
                                        phi_4293_ = _e641;
                                        phi_3514_ = _e643;
                                        phi_3515_ = _e683;
                                        phi_3516_ = _e685;
                                        phi_3517_ = _e687;
                                        phi_3518_ = _e651;
                                    }
                                    let _e1745 = phi_4293_;
                                    let _e1747 = phi_3514_;
                                    let _e1749 = phi_3515_;
                                    let _e1751 = phi_3516_;
                                    let _e1753 = phi_3517_;
                                    let _e1755 = phi_3518_;
                                    phi_4292_ = _e1745;
                                    phi_3519_ = _e1747;
                                    phi_3520_ = _e1749;
                                    phi_3521_ = _e1751;
                                    phi_3522_ = _e1753;
                                    phi_3523_ = _e1755;
                                } else {
                                    phi_4292_ = _e641;
                                    phi_3519_ = type_47();
                                    phi_3520_ = bool();
                                    phi_3521_ = type_54();
                                    phi_3522_ = u32();
                                    phi_3523_ = u32();
                                }
                                let _e1757 = phi_4292_;
                                let _e1759 = phi_3519_;
                                let _e1761 = phi_3520_;
                                let _e1763 = phi_3521_;
                                let _e1765 = phi_3522_;
                                let _e1767 = phi_3523_;
                                phi_4291_ = _e1757;
                                phi_1211_ = _e1759;
                                phi_1214_ = _e1761;
                                phi_1216_ = _e1763;
                                phi_1218_ = _e1765;
                                phi_1220_ = _e1767;
                                phi_3524_ = _e655;
                            } else {
                                phi_4291_ = _e641;
                                phi_1211_ = type_47();
                                phi_1214_ = bool();
                                phi_1216_ = type_54();
                                phi_1218_ = u32();
                                phi_1220_ = u32();
                                phi_3524_ = false;
                            }
                            let _e1769 = phi_4291_;
                            let _e1771 = phi_1211_;
                            let _e1773 = phi_1214_;
                            let _e1775 = phi_1216_;
                            let _e1777 = phi_1218_;
                            let _e1779 = phi_1220_;
                            let _e1781 = phi_3524_;
                            continue;
                            continuing {
                                phi_4143_ = _e1769;
                                phi_1210_ = _e1771;
                                phi_1213_ = _e1773;
                                phi_1215_ = _e1775;
                                phi_1217_ = _e1777;
                                phi_1219_ = _e1779;
                                phi_4290_ = _e1769;
                                break if !(_e1781);
                            }
                        }
                        let _e1784 = phi_4290_;
                        if _e1784 {
                            break;
                        }
                        let _e1786 = local_11;
                        if (_e1786.member.member.member_3 != 4294967295u) {
                            let _e1792 = bitcast<u32>(_e1786.member.member.member);
                            let _e1796 = (bitcast<i32>((_e1792 >> bitcast<u32>(23i))) & 255i);
                            let _e1797 = (_e1796 + _e278);
                            if (_e1796 == 255i) {
                                phi_3583_ = _e1786.member.member.member;
                            } else {
                                if (_e1796 > 0i) {
                                    if (_e1797 > 0i) {
                                        let _e1801 = (_e1797 < 255i);
                                        if _e1801 {
                                            phi_3562_ = bitcast<f32>((_e1792 + bitcast<u32>((_e278 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3562_ = f32();
                                        }
                                        let _e1808 = phi_3562_;
                                        phi_3564_ = _e1808;
                                        phi_3565_ = select(true, false, _e1801);
                                    } else {
                                        phi_3564_ = f32();
                                        phi_3565_ = true;
                                    }
                                    let _e1811 = phi_3564_;
                                    let _e1813 = phi_3565_;
                                    phi_3566_ = _e1811;
                                    phi_3567_ = _e1813;
                                } else {
                                    phi_3566_ = f32();
                                    phi_3567_ = true;
                                }
                                let _e1815 = phi_3566_;
                                let _e1817 = phi_3567_;
                                if _e1817 {
                                    let _e1818 = (_e1792 & 2147483648u);
                                    let _e1825 = ((_e1792 & 8388607u) | (select(0u, 1u, ((_e1792 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1829 = (_e1825 == 0u);
                                    if _e1829 {
                                        phi_4095_ = bitcast<f32>(_e1818);
                                    } else {
                                        let _e1834 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1825)), 32u, _e1829) - 8u);
                                        let _e1837 = (_e1825 << bitcast<u32>((_e1834 & 31u)));
                                        let _e1839 = ((_e1797 + select(0i, 1i, (_e1796 == 0i))) - bitcast<i32>(_e1834));
                                        if (_e1839 >= 255i) {
                                            phi_4085_ = bitcast<f32>((_e1818 | 2139095040u));
                                            phi_4086_ = f32();
                                            phi_4087_ = true;
                                        } else {
                                            let _e1841 = (_e1839 > 0i);
                                            if _e1841 {
                                                phi_4079_ = bitcast<f32>(((_e1818 | (bitcast<u32>(_e1839) << bitcast<u32>(23i))) | (_e1837 & 8388607u)));
                                                phi_4080_ = f32();
                                            } else {
                                                if (_e1839 < -24i) {
                                                    phi_4045_ = 26u;
                                                } else {
                                                    phi_4045_ = bitcast<u32>((1i - _e1839));
                                                }
                                                let _e1846 = phi_4045_;
                                                let _e1847 = (_e1846 & 31u);
                                                let _e1849 = (_e1837 >> bitcast<u32>(_e1847));
                                                let _e1853 = (_e1837 & ((1u << bitcast<u32>(_e1847)) - 1u));
                                                let _e1857 = (1u << bitcast<u32>(((_e1846 - 1u) & 31u)));
                                                if (_e1853 > _e1857) {
                                                    phi_4066_ = true;
                                                } else {
                                                    if (_e1853 == _e1857) {
                                                        phi_4063_ = ((_e1849 & 1u) == 1u);
                                                    } else {
                                                        phi_4063_ = false;
                                                    }
                                                    let _e1863 = phi_4063_;
                                                    phi_4066_ = _e1863;
                                                }
                                                let _e1865 = phi_4066_;
                                                phi_4079_ = f32();
                                                phi_4080_ = bitcast<f32>((_e1818 | (_e1849 + select(0u, 1u, _e1865))));
                                            }
                                            let _e1878 = phi_4079_;
                                            let _e1880 = phi_4080_;
                                            phi_4085_ = _e1878;
                                            phi_4086_ = _e1880;
                                            phi_4087_ = _e1841;
                                        }
                                        let _e1884 = phi_4085_;
                                        let _e1886 = phi_4086_;
                                        let _e1888 = phi_4087_;
                                        phi_4095_ = select(_e1886, _e1884, _e1888);
                                    }
                                    let _e1892 = phi_4095_;
                                    phi_3582_ = _e1892;
                                } else {
                                    phi_3582_ = _e1815;
                                }
                                let _e1894 = phi_3582_;
                                phi_3583_ = _e1894;
                            }
                            let _e1896 = phi_3583_;
                            let _e1897 = bitcast<u32>(_e1896);
                            if ((_e1897 & 2147483647u) >= 2139095040u) {
                                phi_3595_ = bitcast<f32>(((_e1897 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3595_ = _e1896;
                            }
                            let _e1904 = phi_3595_;
                            phi_3600_ = type_26(_e1904, _e1786.member.member.member_1, _e1786.member.member.member_2, _e1786.member.member.member_3);
                        } else {
                            phi_3600_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1909 = phi_3600_;
                        if _e154 {
                        } else {
                            break;
                        }
                        global_2.member[_e138] = _e1909;
                        let _e1913 = local_12;
                        if _e155 {
                        } else {
                            break;
                        }
                        global_6.member[_e138] = _e1913.member_1;
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e1918 = select(0u, 1u, (_e222 <= _e232));
                        if (_e1918 > 0u) {
                            let _e1920 = (1u < _e106);
                            if _e1920 {
                                if (0u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1924 = atomicAdd((&global_7.member[0u]), _e1918);
                                if ((_e1924 + _e1918) < _e1924) {
                                    if _e1920 {
                                    } else {
                                        break;
                                    }
                                    let _e1929 = atomicAdd((&global_7.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1932 = select(0u, 1u, (_e1909.member_3 != 4294967295u));
                        if (_e1932 > 0u) {
                            let _e1934 = (3u < _e106);
                            if _e1934 {
                                if (2u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1938 = atomicAdd((&global_7.member[2u]), _e1932);
                                if ((_e1938 + _e1932) < _e1938) {
                                    if _e1934 {
                                    } else {
                                        break;
                                    }
                                    let _e1943 = atomicAdd((&global_7.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1913.member_1 > 0u) {
                            let _e1945 = (5u < _e106);
                            if _e1945 {
                                if (4u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1949 = atomicAdd((&global_7.member[4u]), _e1913.member_1);
                                if ((_e1949 + _e1913.member_1) < _e1949) {
                                    if _e1945 {
                                    } else {
                                        break;
                                    }
                                    let _e1954 = atomicAdd((&global_7.member[5u]), 1u);
                                }
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
fn trace_paths_counted_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
