struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_16 {
    member: array<type_14>,
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
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_39 {
    member: type_22,
    member_1: f32,
}

struct type_42 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_43 {
    member: type_39,
    member_1: u32,
    member_2: u32,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: array<array<u32, 7>>,
}

struct type_54 {
    member: type_34,
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
var<storage> global_1: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_24;
@group(0) @binding(0) 
var<uniform> global_3: type_45;
@group(0) @binding(3) 
var<storage> global_4: type_29;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_60;
@group(0) @binding(1) 
var<storage> global_7: type_49;

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
    var phi_1210_: type_43;
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
    var phi_1336_: type_43;
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
    var phi_2226_: type_42;
    var phi_2227_: type_42;
    var phi_2230_: type_42;
    var phi_2231_: type_42;
    var phi_2232_: bool;
    var phi_2236_: type_42;
    var phi_2245_: type_22;
    var phi_2270_: bool;
    var phi_2271_: bool;
    var phi_2278_: type_43;
    var phi_2279_: type_43;
    var phi_2280_: type_43;
    var phi_1337_: type_43;
    var phi_4137_: bool;
    var local_10: type_43;
    var phi_4294_: bool;
    var phi_3510_: type_43;
    var phi_3511_: bool;
    var phi_3512_: type_54;
    var phi_3513_: u32;
    var phi_4293_: bool;
    var phi_3514_: type_43;
    var phi_3515_: bool;
    var phi_3516_: type_54;
    var phi_3517_: u32;
    var phi_3518_: u32;
    var phi_4292_: bool;
    var phi_3519_: type_43;
    var phi_3520_: bool;
    var phi_3521_: type_54;
    var phi_3522_: u32;
    var phi_3523_: u32;
    var phi_4291_: bool;
    var phi_1211_: type_43;
    var phi_1214_: bool;
    var phi_1216_: type_54;
    var phi_1218_: u32;
    var phi_1220_: u32;
    var phi_3524_: bool;
    var phi_4290_: bool;
    var local_11: type_43;
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
    var phi_3600_: type_22;
    var local_12: type_43;
    var local_13: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e92 = global;
            let _e94 = arrayLength((&global_7.member));
            let _e96 = arrayLength((&global_1.member));
            let _e104 = arrayLength((&global_6.member));
            let _e108 = global_3.member[0u][0u];
            let _e112 = global_3.member[0u][1u];
            let _e116 = global_3.member[0u][2u];
            let _e120 = global_3.member[0u][3u];
            let _e124 = global_3.member[1u][0u];
            let _e128 = global_3.member[1u][1u];
            let _e132 = global_3.member[1u][2u];
            let _e136 = (_e92.x + (_e92.y * 2097152u));
            let _e148 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e120) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e108), bitcast<i32>(_e112), bitcast<i32>(_e116));
            local = array<i32, 3>(bitcast<i32>(_e124), bitcast<i32>(_e128), bitcast<i32>(_e132));
            let _e151 = (_e136 < arrayLength((&global_4.member)));
            if _e151 {
                let _e152 = (_e136 < arrayLength((&global_2.member)));
                if _e152 {
                    let _e153 = (_e136 < arrayLength((&global_5.member)));
                    if _e153 {
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e163 = global_4.member[_e136].member.member_2[0u];
                        let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                        let _e171 = global_4.member[_e136].member.member_2[1u];
                        let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                        let _e179 = global_4.member[_e136].member.member_2[2u];
                        let _e181 = (bitcast<u32>(_e179) & 2147483647u);
                        let _e187 = global_4.member[_e136].member.member[0u];
                        let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                        let _e195 = global_4.member[_e136].member.member[1u];
                        let _e197 = (bitcast<u32>(_e195) & 2147483647u);
                        let _e203 = global_4.member[_e136].member.member[2u];
                        let _e205 = (bitcast<u32>(_e203) & 2147483647u);
                        let _e207 = select(_e173, _e165, (_e173 < _e165));
                        let _e209 = select(_e181, _e207, (_e181 < _e207));
                        let _e211 = select(_e189, _e209, (_e189 < _e209));
                        let _e213 = select(_e197, _e211, (_e197 < _e211));
                        let _e215 = select(_e205, _e213, (_e205 < _e213));
                        let _e220 = global_4.member[_e136].member.member_1;
                        let _e221 = bitcast<u32>(_e220);
                        let _e222 = (_e221 & 2147483647u);
                        let _e230 = global_4.member[_e136].member.member_3;
                        let _e231 = bitcast<u32>(_e230);
                        let _e232 = (_e231 & 2147483647u);
                        let _e236 = (((select(_e222, _e215, (_e222 < _e215)) < 2139095040u) && (_e232 <= 2139095040u)) && (_e209 > 0u));
                        if _e236 {
                            let _e239 = (bitcast<u32>(bitcast<f32>(_e209)) & 2147483647u);
                            if (_e239 >= 8388608u) {
                                phi_512_ = (bitcast<i32>((_e239 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_512_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e239)), 32u, (_e239 == 0u))));
                            }
                            let _e253 = phi_512_;
                            phi_513_ = _e253;
                        } else {
                            phi_513_ = 0i;
                        }
                        let _e255 = phi_513_;
                        let _e256 = (_e165 == _e209);
                        if _e256 {
                            phi_523_ = true;
                        } else {
                            phi_523_ = (_e173 == _e209);
                        }
                        let _e259 = phi_523_;
                        let _e260 = select(1u, 0u, _e256);
                        if _e259 {
                            let _e261 = (_e260 + 1u);
                            phi_533_ = _e261;
                            phi_534_ = _e261;
                            phi_536_ = select(true, false, (_e261 == 2u));
                        } else {
                            phi_533_ = u32();
                            phi_534_ = 0u;
                            phi_536_ = true;
                        }
                        let _e265 = phi_533_;
                        let _e267 = phi_534_;
                        let _e269 = phi_536_;
                        if _e269 {
                            phi_541_ = (_e267 + 1u);
                        } else {
                            phi_541_ = 0u;
                        }
                        let _e273 = phi_541_;
                        let _e274 = select(_e265, _e267, _e269);
                        let _e275 = select(_e260, select(2u, _e260, _e259), _e269);
                        let _e276 = -(_e255);
                        if (_e276 < -126i) {
                            phi_574_ = -126i;
                        } else {
                            phi_574_ = select(_e276, 127i, (_e276 > 127i));
                        }
                        let _e281 = phi_574_;
                        let _e286 = bitcast<f32>((bitcast<u32>((_e281 + 127i)) << bitcast<u32>(23i)));
                        let _e292 = bitcast<f32>((bitcast<u32>(((_e276 - _e281) + 127i)) << bitcast<u32>(23i)));
                        let _e297 = global_4.member[_e136].member.member;
                        let _e298 = (_e274 == 0u);
                        if _e298 {
                            phi_592_ = _e297[0];
                        } else {
                            phi_592_ = _e297[1];
                        }
                        let _e302 = phi_592_;
                        let _e303 = (_e274 == 2u);
                        if _e303 {
                            phi_598_ = _e297[2];
                        } else {
                            phi_598_ = _e302;
                        }
                        let _e306 = phi_598_;
                        let _e307 = bitcast<u32>(_e306);
                        let _e309 = ((_e307 & 2139095040u) != 0u);
                        let _e321 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e307 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e307 & 2147483648u))), _e306, _e309) * select(0.00000011920929f, 1f, _e309));
                        let _e322 = global_4.member[_e136].member.member_2;
                        if _e298 {
                            phi_638_ = _e322[0];
                        } else {
                            phi_638_ = _e322[1];
                        }
                        let _e326 = phi_638_;
                        if _e303 {
                            phi_644_ = _e322[2];
                        } else {
                            phi_644_ = _e326;
                        }
                        let _e329 = phi_644_;
                        let _e330 = bitcast<u32>(_e329);
                        let _e332 = ((_e330 & 2139095040u) != 0u);
                        let _e346 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e330 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e330 & 2147483648u))), _e329, _e332) * _e286) * select(0.00000011920929f, 1f, _e332)) * _e292);
                        let _e350 = (bitcast<f32>((bitcast<u32>(_e346) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e353 = bitcast<f32>((bitcast<u32>(_e321) & 2147483647u));
                        let _e354 = (_e353 * 0.00000011920929f);
                        let _e357 = select(select(0.00000000000011368684f, _e354, (_e354 > 0.00000000000011368684f)), 0f, _e350);
                        let _e358 = select(0f, _e346, _e350);
                        let _e359 = (_e321 + _e357);
                        let _e360 = (_e321 - _e357);
                        let _e362 = select(38685626000000000000000000f, (1f / _e346), _e350);
                        let _e363 = (_e273 == 0u);
                        if _e363 {
                            phi_717_ = _e297[0];
                        } else {
                            phi_717_ = _e297[1];
                        }
                        let _e367 = phi_717_;
                        let _e368 = (_e273 == 2u);
                        if _e368 {
                            phi_723_ = _e297[2];
                        } else {
                            phi_723_ = _e367;
                        }
                        let _e371 = phi_723_;
                        let _e372 = bitcast<u32>(_e371);
                        let _e374 = ((_e372 & 2139095040u) != 0u);
                        let _e386 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e372 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e372 & 2147483648u))), _e371, _e374) * select(0.00000011920929f, 1f, _e374));
                        if _e363 {
                            phi_763_ = _e322[0];
                        } else {
                            phi_763_ = _e322[1];
                        }
                        let _e390 = phi_763_;
                        if _e368 {
                            phi_769_ = _e322[2];
                        } else {
                            phi_769_ = _e390;
                        }
                        let _e393 = phi_769_;
                        let _e394 = bitcast<u32>(_e393);
                        let _e396 = ((_e394 & 2139095040u) != 0u);
                        let _e410 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e394 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e394 & 2147483648u))), _e393, _e396) * _e286) * select(0.00000011920929f, 1f, _e396)) * _e292);
                        let _e414 = (bitcast<f32>((bitcast<u32>(_e410) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e417 = bitcast<f32>((bitcast<u32>(_e386) & 2147483647u));
                        let _e418 = (_e417 * 0.00000011920929f);
                        let _e421 = select(select(0.00000000000011368684f, _e418, (_e418 > 0.00000000000011368684f)), 0f, _e414);
                        let _e422 = select(0f, _e410, _e414);
                        let _e423 = (_e386 + _e421);
                        let _e424 = (_e386 - _e421);
                        let _e426 = select(38685626000000000000000000f, (1f / _e410), _e414);
                        let _e427 = (_e275 == 0u);
                        if _e427 {
                            phi_842_ = _e297[0];
                        } else {
                            phi_842_ = _e297[1];
                        }
                        let _e431 = phi_842_;
                        let _e432 = (_e275 == 2u);
                        if _e432 {
                            phi_848_ = _e297[2];
                        } else {
                            phi_848_ = _e431;
                        }
                        let _e435 = phi_848_;
                        let _e436 = bitcast<u32>(_e435);
                        let _e438 = ((_e436 & 2139095040u) != 0u);
                        let _e450 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e436 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e436 & 2147483648u))), _e435, _e438) * select(0.00000011920929f, 1f, _e438));
                        if _e427 {
                            phi_888_ = _e322[0];
                        } else {
                            phi_888_ = _e322[1];
                        }
                        let _e454 = phi_888_;
                        if _e432 {
                            phi_894_ = _e322[2];
                        } else {
                            phi_894_ = _e454;
                        }
                        let _e457 = phi_894_;
                        let _e458 = bitcast<u32>(_e457);
                        let _e460 = ((_e458 & 2139095040u) != 0u);
                        let _e474 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e458 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e458 & 2147483648u))), _e457, _e460) * _e286) * select(0.00000011920929f, 1f, _e460)) * _e292);
                        let _e478 = (bitcast<f32>((bitcast<u32>(_e474) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e481 = bitcast<f32>((bitcast<u32>(_e450) & 2147483647u));
                        let _e482 = (_e481 * 0.00000011920929f);
                        let _e485 = select(select(0.00000000000011368684f, _e482, (_e482 > 0.00000000000011368684f)), 0f, _e478);
                        let _e486 = select(0f, _e474, _e478);
                        let _e487 = (_e450 + _e485);
                        let _e488 = (_e450 - _e485);
                        let _e490 = select(38685626000000000000000000f, (1f / _e474), _e478);
                        let _e492 = select(_e417, _e353, (_e353 > _e417));
                        if (_e236 && (select(_e481, _e492, (_e492 > _e481)) <= 1099511600000f)) {
                            let _e504 = ((_e222 & 8388607u) | (select(0u, 1u, ((_e222 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e507 = bitcast<i32>((_e222 >> bitcast<u32>(23i)));
                            let _e511 = (_e504 == 0u);
                            let _e514 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e504)), 32u, _e511)) - 8i);
                            if (_e507 == 255i) {
                                phi_1013_ = 255i;
                            } else {
                                phi_1013_ = (((_e507 + select(0i, 1i, (_e507 == 0i))) - _e514) + _e255);
                            }
                            let _e522 = phi_1013_;
                            let _e532 = (_e522 <= 0i);
                            if _e532 {
                                phi_1036_ = u32();
                            } else {
                                if _e511 {
                                    phi_1035_ = u32();
                                } else {
                                    phi_1035_ = select(((bitcast<u32>(_e522) << bitcast<u32>(23i)) | ((_e504 << bitcast<u32>(((_e514 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e522 >= 255i));
                                }
                                let _e536 = phi_1035_;
                                phi_1036_ = _e536;
                            }
                            let _e538 = phi_1036_;
                            let _e550 = ((_e232 & 8388607u) | (select(0u, 1u, ((_e232 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e553 = bitcast<i32>((_e232 >> bitcast<u32>(23i)));
                            let _e557 = (_e550 == 0u);
                            let _e560 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e550)), 32u, _e557)) - 8i);
                            if (_e553 == 255i) {
                                phi_1073_ = 255i;
                            } else {
                                phi_1073_ = (((_e553 + select(0i, 1i, (_e553 == 0i))) - _e560) + _e255);
                            }
                            let _e568 = phi_1073_;
                            let _e578 = (_e568 <= 0i);
                            if _e578 {
                                phi_1096_ = u32();
                            } else {
                                if _e557 {
                                    phi_1095_ = u32();
                                } else {
                                    phi_1095_ = select(((bitcast<u32>(_e568) << bitcast<u32>(23i)) | ((_e550 << bitcast<u32>(((_e560 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e568 >= 255i));
                                }
                                let _e582 = phi_1095_;
                                phi_1096_ = _e582;
                            }
                            let _e584 = phi_1096_;
                            phi_1104_ = bitcast<f32>(((_e231 & 2147483648u) | select(_e584, 0u, select(_e557, true, _e578))));
                            phi_1105_ = bitcast<f32>(((_e221 & 2147483648u) | select(_e538, 0u, select(_e511, true, _e532))));
                        } else {
                            phi_1104_ = 0f;
                            phi_1105_ = 1f;
                        }
                        let _e590 = phi_1104_;
                        let _e592 = phi_1105_;
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e598 = global_4.member[_e136].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e603 = (_e274 % 3u);
                        let _e604 = (_e603 < 3u);
                        if _e604 {
                        } else {
                            break;
                        }
                        let _e606 = local_1[_e603];
                        let _e609 = (_e273 % 3u);
                        let _e610 = (_e609 < 3u);
                        if _e610 {
                        } else {
                            break;
                        }
                        let _e612 = local_1[_e609];
                        let _e615 = (_e275 % 3u);
                        let _e616 = (_e615 < 3u);
                        if _e616 {
                        } else {
                            break;
                        }
                        let _e618 = local_1[_e615];
                        if _e604 {
                        } else {
                            break;
                        }
                        let _e623 = local[_e603];
                        if _e610 {
                        } else {
                            break;
                        }
                        let _e627 = local[_e609];
                        if _e616 {
                        } else {
                            break;
                        }
                        let _e631 = local[_e615];
                        phi_4143_ = false;
                        phi_1210_ = type_43(type_39(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e590), 0u, 0u);
                        phi_1213_ = (_e592 <= _e590);
                        phi_1215_ = type_54(type_34(vec4<f32>((f32(_e606) * _e148), (f32(_e612) * _e148), (f32(_e618) * _e148), 0f), vec4<f32>((f32(_e623) * _e148), (f32(_e627) * _e148), (f32(_e631) * _e148), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                        phi_1217_ = 0u;
                        phi_1219_ = ((3u * _e94) + 1u);
                        loop {
                            let _e639 = phi_4143_;
                            let _e641 = phi_1210_;
                            let _e643 = phi_1213_;
                            let _e645 = phi_1215_;
                            let _e647 = phi_1217_;
                            let _e649 = phi_1219_;
                            local_11 = _e641;
                            local_12 = _e641;
                            if _e643 {
                                phi_1230_ = true;
                            } else {
                                phi_1230_ = (_e647 > 0u);
                            }
                            let _e652 = phi_1230_;
                            if _e652 {
                                let _e653 = (_e649 > 0u);
                                if _e653 {
                                    if _e643 {
                                        phi_1316_ = _e643;
                                        phi_1317_ = _e645;
                                        phi_1318_ = _e647;
                                    } else {
                                        let _e654 = (_e647 - 1u);
                                        let _e655 = (_e654 % 128u);
                                        let _e656 = (_e655 < 128u);
                                        if _e656 {
                                        } else {
                                            phi_4290_ = true;
                                            break;
                                        }
                                        let _e658 = local_7[_e655];
                                        if _e656 {
                                        } else {
                                            phi_4290_ = true;
                                            break;
                                        }
                                        let _e660 = local_6[_e655];
                                        if _e656 {
                                        } else {
                                            phi_4290_ = true;
                                            break;
                                        }
                                        let _e662 = local_5[_e655];
                                        if _e656 {
                                        } else {
                                            phi_4290_ = true;
                                            break;
                                        }
                                        let _e664 = local_4[_e655];
                                        if _e656 {
                                        } else {
                                            phi_4290_ = true;
                                            break;
                                        }
                                        let _e666 = local_3[_e655];
                                        if _e656 {
                                        } else {
                                            phi_4290_ = true;
                                            break;
                                        }
                                        let _e668 = local_2[_e655];
                                        if _e656 {
                                        } else {
                                            phi_4290_ = true;
                                            break;
                                        }
                                        let _e673 = local_8[_e655];
                                        if _e656 {
                                        } else {
                                            phi_4290_ = true;
                                            break;
                                        }
                                        let _e676 = local_9[_e655];
                                        phi_1316_ = (_e676 <= _e641.member.member_1);
                                        phi_1317_ = type_54(type_34(vec4<f32>(_e658, _e660, _e662, 0f), vec4<f32>(_e664, _e666, _e668, 0f)), _e673);
                                        phi_1318_ = _e654;
                                    }
                                    let _e681 = phi_1316_;
                                    let _e683 = phi_1317_;
                                    let _e685 = phi_1318_;
                                    if _e681 {
                                        if ((_e683.member_1 & 2147483648u) != 0u) {
                                            phi_1336_ = _e641;
                                            phi_1339_ = type_7(0u, ((_e683.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1159 = phi_1336_;
                                                let _e1161 = phi_1339_;
                                                local_10 = _e1159;
                                                local_13 = _e1159;
                                                if (_e1161.member < _e1161.member_1) {
                                                    phi_1340_ = type_7((_e1161.member + 1u), _e1161.member_1);
                                                    phi_1362_ = type_7(1u, _e1161.member);
                                                } else {
                                                    phi_1340_ = _e1161;
                                                    phi_1362_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1174 = phi_1340_;
                                                let _e1176 = phi_1362_;
                                                let _e1180 = (bitcast<i32>(_e1176.member) != 0i);
                                                if _e1180 {
                                                    let _e1186 = type_43(_e1159.member, _e1159.member_1, (_e1159.member_2 + 1u));
                                                    let _e1187 = ((_e683.member_1 & 268435455u) + _e1176.member_1);
                                                    let _e1188 = (_e1187 < _e96);
                                                    if _e1188 {
                                                        if _e1188 {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1192 = global_1.member[_e1187].member_1;
                                                        phi_1386_ = _e1192;
                                                    } else {
                                                        phi_1386_ = 4294967295u;
                                                    }
                                                    let _e1194 = phi_1386_;
                                                    if (_e1187 >= _e96) {
                                                        phi_1478_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1188 {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        if (_e603 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1201 = global_1.member[_e1187].member[_e603];
                                                        if (_e609 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1207 = global_1.member[_e1187].member[_e609];
                                                        if (_e615 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1213 = global_1.member[_e1187].member[_e615];
                                                        let _e1215 = (3u + _e603);
                                                        if (_e1215 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1221 = global_1.member[_e1187].member[_e1215];
                                                        let _e1222 = (3u + _e609);
                                                        if (_e1222 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1228 = global_1.member[_e1187].member[_e1222];
                                                        let _e1229 = (3u + _e615);
                                                        if (_e1229 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1235 = global_1.member[_e1187].member[_e1229];
                                                        let _e1237 = (6u + _e603);
                                                        if (_e1237 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1243 = global_1.member[_e1187].member[_e1237];
                                                        let _e1244 = (6u + _e609);
                                                        if (_e1244 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1250 = global_1.member[_e1187].member[_e1244];
                                                        let _e1251 = (6u + _e615);
                                                        if (_e1251 < 9u) {
                                                        } else {
                                                            phi_4137_ = true;
                                                            break;
                                                        }
                                                        let _e1257 = global_1.member[_e1187].member[_e1251];
                                                        phi_1478_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1201, _e1207, _e1213), array<f32, 3>(_e1221, _e1228, _e1235), array<f32, 3>(_e1243, _e1250, _e1257));
                                                    }
                                                    let _e1261 = phi_1478_;
                                                    let _e1278 = (_e1261[0][2] - _e450);
                                                    let _e1281 = (((_e1261[0][0] - _e321) * _e486) - (_e1278 * _e358));
                                                    let _e1284 = (((_e1261[0][1] - _e386) * _e486) - (_e1278 * _e422));
                                                    let _e1287 = (_e1261[1][2] - _e450);
                                                    let _e1290 = (((_e1261[1][0] - _e321) * _e486) - (_e1287 * _e358));
                                                    let _e1293 = (((_e1261[1][1] - _e386) * _e486) - (_e1287 * _e422));
                                                    let _e1296 = (_e1261[2][2] - _e450);
                                                    let _e1299 = (((_e1261[2][0] - _e321) * _e486) - (_e1296 * _e358));
                                                    let _e1302 = (((_e1261[2][1] - _e386) * _e486) - (_e1296 * _e422));
                                                    let _e1303 = (_e1299 * _e1293);
                                                    let _e1304 = (_e1302 * _e1290);
                                                    let _e1305 = (_e1281 * _e1302);
                                                    let _e1306 = (_e1284 * _e1299);
                                                    let _e1307 = (_e1290 * _e1284);
                                                    let _e1308 = (_e1293 * _e1281);
                                                    let _e1313 = (((_e1303 >= _e1304) && (_e1305 >= _e1306)) && (_e1307 >= _e1308));
                                                    let _e1319 = (_e1313 || (((_e1303 <= _e1304) && (_e1305 <= _e1306)) && (_e1307 <= _e1308)));
                                                    if _e1319 {
                                                        let _e1321 = select(-1f, 1f, _e1313);
                                                        let _e1323 = ((_e1303 - _e1304) * _e1321);
                                                        let _e1325 = select(0f, _e1323, (_e1323 > 0f));
                                                        let _e1327 = ((_e1305 - _e1306) * _e1321);
                                                        let _e1329 = select(0f, _e1327, (_e1327 > 0f));
                                                        let _e1331 = ((_e1307 - _e1308) * _e1321);
                                                        let _e1333 = select(0f, _e1331, (_e1331 > 0f));
                                                        let _e1335 = ((_e1325 + _e1329) + _e1333);
                                                        let _e1337 = select(_e1261[1][0], _e1261[0][0], (_e1261[0][0] < _e1261[1][0]));
                                                        let _e1341 = select(_e1261[1][0], _e1261[0][0], (_e1261[0][0] > _e1261[1][0]));
                                                        let _e1345 = select(_e1261[1][1], _e1261[0][1], (_e1261[0][1] < _e1261[1][1]));
                                                        let _e1349 = select(_e1261[1][1], _e1261[0][1], (_e1261[0][1] > _e1261[1][1]));
                                                        let _e1353 = select(_e1261[1][2], _e1261[0][2], (_e1261[0][2] < _e1261[1][2]));
                                                        let _e1357 = select(_e1261[1][2], _e1261[0][2], (_e1261[0][2] > _e1261[1][2]));
                                                        let _e1362 = ((select(_e1261[2][0], _e1337, (_e1337 < _e1261[2][0])) - _e359) * _e362);
                                                        let _e1363 = ((select(_e1261[2][0], _e1341, (_e1341 > _e1261[2][0])) - _e360) * _e362);
                                                        let _e1366 = ((select(_e1261[2][1], _e1345, (_e1345 < _e1261[2][1])) - _e423) * _e426);
                                                        let _e1367 = ((select(_e1261[2][1], _e1349, (_e1349 > _e1261[2][1])) - _e424) * _e426);
                                                        let _e1370 = ((select(_e1261[2][2], _e1353, (_e1353 < _e1261[2][2])) - _e487) * _e490);
                                                        let _e1371 = ((select(_e1261[2][2], _e1357, (_e1357 > _e1261[2][2])) - _e488) * _e490);
                                                        let _e1373 = select(_e1371, _e1370, (_e1370 < _e1371));
                                                        let _e1375 = select(_e1371, _e1370, (_e1370 > _e1371));
                                                        let _e1377 = select(_e1363, _e1362, (_e1362 < _e1363));
                                                        let _e1379 = select(_e1367, _e1366, (_e1366 < _e1367));
                                                        let _e1381 = select(_e1379, _e1377, (_e1377 > _e1379));
                                                        let _e1383 = select(_e1373, _e1381, (_e1381 > _e1373));
                                                        let _e1385 = select(_e1363, _e1362, (_e1362 > _e1363));
                                                        let _e1387 = select(_e1367, _e1366, (_e1366 > _e1367));
                                                        let _e1389 = select(_e1387, _e1385, (_e1385 < _e1387));
                                                        let _e1391 = select(_e1375, _e1389, (_e1389 < _e1375));
                                                        let _e1392 = -(_e1373);
                                                        let _e1398 = select(_e592, _e1383, (_e1383 > _e592));
                                                        let _e1402 = select(_e1290, _e1281, (_e1281 < _e1290));
                                                        let _e1407 = select(_e1290, _e1281, (_e1281 > _e1290));
                                                        let _e1414 = select(_e1293, _e1284, (_e1284 < _e1293));
                                                        let _e1419 = select(_e1293, _e1284, (_e1284 > _e1293));
                                                        let _e1428 = (((((_e1319 && (_e1335 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1299, _e1402, (_e1402 < _e1299)) <= 0f) && (select(_e1299, _e1407, (_e1407 > _e1299)) >= 0f))) && ((select(_e1302, _e1414, (_e1414 < _e1302)) <= 0f) && (select(_e1302, _e1419, (_e1419 > _e1302)) >= 0f))) && (_e1398 <= (_e1391 + (select(_e1392, _e1375, (_e1375 > _e1392)) * 0.0000019073523f)))) && (_e1398 <= _e1159.member.member_1));
                                                        if _e1428 {
                                                            let _e1433 = (_e1261[1][0] - _e1261[0][0]);
                                                            let _e1434 = (_e1261[1][1] - _e1261[0][1]);
                                                            let _e1435 = (_e1261[1][2] - _e1261[0][2]);
                                                            let _e1436 = vec3<f32>(_e1433, _e1434, _e1435);
                                                            let _e1437 = (_e1261[2][0] - _e1261[1][0]);
                                                            let _e1438 = (_e1261[2][1] - _e1261[1][1]);
                                                            let _e1439 = (_e1261[2][2] - _e1261[1][2]);
                                                            let _e1440 = vec3<f32>(_e1437, _e1438, _e1439);
                                                            let _e1441 = (_e1261[0][0] - _e1261[2][0]);
                                                            let _e1442 = (_e1261[0][1] - _e1261[2][1]);
                                                            let _e1443 = (_e1261[0][2] - _e1261[2][2]);
                                                            let _e1444 = vec3<f32>(_e1441, _e1442, _e1443);
                                                            let _e1447 = bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u));
                                                            let _e1450 = bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u));
                                                            let _e1452 = select(_e1450, _e1447, (_e1447 > _e1450));
                                                            let _e1455 = bitcast<f32>((bitcast<u32>(_e1435) & 2147483647u));
                                                            let _e1457 = select(_e1455, _e1452, (_e1452 > _e1455));
                                                            let _e1460 = bitcast<f32>((bitcast<u32>(_e1437) & 2147483647u));
                                                            let _e1463 = bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u));
                                                            let _e1465 = select(_e1463, _e1460, (_e1460 > _e1463));
                                                            let _e1468 = bitcast<f32>((bitcast<u32>(_e1439) & 2147483647u));
                                                            let _e1470 = select(_e1468, _e1465, (_e1465 > _e1468));
                                                            let _e1473 = bitcast<f32>((bitcast<u32>(_e1441) & 2147483647u));
                                                            let _e1476 = bitcast<f32>((bitcast<u32>(_e1442) & 2147483647u));
                                                            let _e1478 = select(_e1476, _e1473, (_e1473 > _e1476));
                                                            let _e1481 = bitcast<f32>((bitcast<u32>(_e1443) & 2147483647u));
                                                            let _e1483 = select(_e1481, _e1478, (_e1478 > _e1481));
                                                            let _e1485 = select(_e1470, _e1457, (_e1457 > _e1470));
                                                            let _e1487 = select(_e1483, _e1485, (_e1485 > _e1483));
                                                            if (_e1457 == _e1487) {
                                                                phi_2008_ = _e1293;
                                                                phi_2009_ = _e1290;
                                                                phi_2010_ = _e1284;
                                                                phi_2011_ = _e1281;
                                                                phi_2012_ = vec3<f32>(_e1261[0][0], _e1261[0][1], _e1261[0][2]);
                                                                phi_2013_ = _e1444;
                                                                phi_2014_ = _e1440;
                                                                phi_2015_ = _e1436;
                                                            } else {
                                                                let _e1489 = (_e1470 == _e1487);
                                                                let _e1494 = vec3(_e1489);
                                                                phi_2008_ = select(_e1284, _e1302, _e1489);
                                                                phi_2009_ = select(_e1281, _e1299, _e1489);
                                                                phi_2010_ = select(_e1302, _e1293, _e1489);
                                                                phi_2011_ = select(_e1299, _e1290, _e1489);
                                                                phi_2012_ = select(vec3<f32>(_e1261[2][0], _e1261[2][1], _e1261[2][2]), vec3<f32>(_e1261[1][0], _e1261[1][1], _e1261[1][2]), _e1494);
                                                                phi_2013_ = select(_e1440, _e1436, _e1494);
                                                                phi_2014_ = select(_e1436, _e1444, _e1494);
                                                                phi_2015_ = select(_e1444, _e1440, _e1494);
                                                            }
                                                            let _e1500 = phi_2008_;
                                                            let _e1502 = phi_2009_;
                                                            let _e1504 = phi_2010_;
                                                            let _e1506 = phi_2011_;
                                                            let _e1508 = phi_2012_;
                                                            let _e1510 = phi_2013_;
                                                            let _e1512 = phi_2014_;
                                                            let _e1514 = phi_2015_;
                                                            let _e1521 = ((_e1512.y * _e1510.z) - (_e1510.y * _e1512.z));
                                                            let _e1526 = ((_e1512.z * _e1510.x) - (_e1510.z * _e1512.x));
                                                            let _e1529 = ((_e1512.x * _e1510.y) - (_e1510.x * _e1512.y));
                                                            let _e1532 = ((_e1325 >= _e1329) && (_e1325 >= _e1333));
                                                            let _e1533 = (_e1329 >= _e1333);
                                                            let _e1547 = (((_e1521 * (select(select(_e1261[2][0], _e1261[1][0], _e1533), _e1261[0][0], _e1532) - _e321)) + (_e1526 * (select(select(_e1261[2][1], _e1261[1][1], _e1533), _e1261[0][1], _e1532) - _e386))) + (_e1529 * (select(select(_e1261[2][2], _e1261[1][2], _e1533), _e1261[0][2], _e1532) - _e450)));
                                                            let _e1552 = (((_e1521 * _e358) + (_e1526 * _e422)) + (_e1529 * _e486));
                                                            let _e1553 = (_e1502 - _e1506);
                                                            let _e1554 = (_e1500 - _e1504);
                                                            let _e1557 = ((_e1553 * _e1553) + (_e1554 * _e1554));
                                                            let _e1564 = (-(((_e1506 * _e1553) + (_e1504 * _e1554))) / select(0.000000000000000000000000000000000000011754944f, _e1557, (_e1557 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1566 = select(1f, _e1564, (_e1564 < 1f));
                                                            let _e1568 = select(0f, _e1566, (_e1566 > 0f));
                                                            let _e1577 = ((_e1508.x + (_e1514.x * _e1568)) - _e321);
                                                            let _e1580 = ((_e1508.y + (_e1514.y * _e1568)) - _e386);
                                                            let _e1583 = ((_e1508.z + (_e1514.z * _e1568)) - _e450);
                                                            let _e1586 = bitcast<f32>((bitcast<u32>(_e1577) & 2147483647u));
                                                            let _e1589 = bitcast<f32>((bitcast<u32>(_e1580) & 2147483647u));
                                                            let _e1591 = select(_e1589, _e1586, (_e1586 > _e1589));
                                                            let _e1594 = bitcast<f32>((bitcast<u32>(_e1583) & 2147483647u));
                                                            let _e1596 = select(_e1594, _e1591, (_e1591 > _e1594));
                                                            let _e1602 = bitcast<f32>((bitcast<u32>(_e1521) & 2147483647u));
                                                            let _e1605 = bitcast<f32>((bitcast<u32>(_e1526) & 2147483647u));
                                                            let _e1607 = select(_e1605, _e1602, (_e1602 > _e1605));
                                                            let _e1610 = bitcast<f32>((bitcast<u32>(_e1529) & 2147483647u));
                                                            let _e1629 = bitcast<f32>((bitcast<u32>(_e1512.x) & 2147483647u));
                                                            let _e1632 = bitcast<f32>((bitcast<u32>(_e1512.y) & 2147483647u));
                                                            let _e1634 = select(_e1632, _e1629, (_e1629 > _e1632));
                                                            let _e1637 = bitcast<f32>((bitcast<u32>(_e1512.z) & 2147483647u));
                                                            let _e1643 = bitcast<f32>((bitcast<u32>(_e1510.x) & 2147483647u));
                                                            let _e1646 = bitcast<f32>((bitcast<u32>(_e1510.y) & 2147483647u));
                                                            let _e1648 = select(_e1646, _e1643, (_e1643 > _e1646));
                                                            let _e1651 = bitcast<f32>((bitcast<u32>(_e1510.z) & 2147483647u));
                                                            let _e1657 = ((bitcast<f32>((bitcast<u32>(((((_e1521 * _e1577) + (_e1526 * _e1580)) + (_e1529 * _e1583)) - _e1547)) & 2147483647u)) <= ((0.0000009536743f * select(_e1487, _e1596, (_e1596 > _e1487))) * select(_e1610, _e1607, (_e1607 > _e1610)))) && !((bitcast<f32>((bitcast<u32>(_e1552) & 2147483647u)) <= ((0.0000038146973f * select(_e1637, _e1634, (_e1634 > _e1637))) * select(_e1651, _e1648, (_e1648 > _e1651))))));
                                                            let _e1658 = (_e1547 / _e1552);
                                                            if (_e1428 && !(_e1657)) {
                                                                let _e1661 = (_e1583 / _e486);
                                                                let _e1669 = (((_e1521 * (_e1577 - (_e358 * _e1661))) + (_e1526 * (_e1580 - (_e422 * _e1661)))) / _e1552);
                                                                phi_2206_ = select(select(_e1661, (_e1661 + _e1669), (bitcast<f32>((bitcast<u32>(_e1669) & 2147483647u)) <= _e1487)), _e1658, _e1657);
                                                            } else {
                                                                phi_2206_ = _e1658;
                                                            }
                                                            let _e1678 = phi_2206_;
                                                            let _e1680 = select(_e1391, _e1678, (_e1678 < _e1391));
                                                            let _e1682 = select(_e1383, _e1680, (_e1680 > _e1383));
                                                            let _e1683 = (1f / _e1335);
                                                            phi_2226_ = type_42(_e1682, (_e1329 * _e1683), (_e1333 * _e1683), ((_e1428 && (_e1682 >= _e592)) && (_e1682 <= _e1159.member.member_1)));
                                                            phi_2227_ = type_42();
                                                        } else {
                                                            phi_2226_ = type_42();
                                                            phi_2227_ = type_42(0f, 0f, 0f, _e1428);
                                                        }
                                                        let _e1692 = phi_2226_;
                                                        let _e1694 = phi_2227_;
                                                        phi_2230_ = _e1692;
                                                        phi_2231_ = _e1694;
                                                        phi_2232_ = select(true, false, _e1428);
                                                    } else {
                                                        phi_2230_ = type_42();
                                                        phi_2231_ = type_42(0f, 0f, 0f, _e1319);
                                                        phi_2232_ = true;
                                                    }
                                                    let _e1697 = phi_2230_;
                                                    let _e1699 = phi_2231_;
                                                    let _e1701 = phi_2232_;
                                                    if _e1701 {
                                                        phi_2236_ = _e1699;
                                                    } else {
                                                        phi_2236_ = _e1697;
                                                    }
                                                    let _e1703 = phi_2236_;
                                                    if _e1703.member_3 {
                                                        phi_2245_ = type_22(_e1703.member, _e1703.member_1, _e1703.member_2, _e1194);
                                                    } else {
                                                        phi_2245_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1710 = phi_2245_;
                                                    if (_e1710.member_3 != 4294967295u) {
                                                        if (_e1194 != _e598) {
                                                            if (_e1710.member < _e1159.member.member.member) {
                                                                phi_2271_ = true;
                                                            } else {
                                                                if (_e1710.member == _e1159.member.member.member) {
                                                                    phi_2270_ = (_e1710.member_3 < _e1159.member.member.member_3);
                                                                } else {
                                                                    phi_2270_ = false;
                                                                }
                                                                let _e1725 = phi_2270_;
                                                                phi_2271_ = _e1725;
                                                            }
                                                            let _e1727 = phi_2271_;
                                                            if _e1727 {
                                                                phi_2278_ = type_43(type_39(_e1710, _e1710.member), _e1186.member_1, _e1186.member_2);
                                                            } else {
                                                                phi_2278_ = _e1186;
                                                            }
                                                            let _e1734 = phi_2278_;
                                                            phi_2279_ = _e1734;
                                                        } else {
                                                            phi_2279_ = _e1186;
                                                        }
                                                        let _e1736 = phi_2279_;
                                                        phi_2280_ = _e1736;
                                                    } else {
                                                        phi_2280_ = _e1186;
                                                    }
                                                    let _e1738 = phi_2280_;
                                                    phi_1337_ = _e1738;
                                                } else {
                                                    phi_1337_ = type_43();
                                                }
                                                let _e1740 = phi_1337_;
                                                continue;
                                                continuing {
                                                    phi_1336_ = _e1740;
                                                    phi_1339_ = _e1174;
                                                    phi_4137_ = _e639;
                                                    break if !(_e1180);
                                                }
                                            }
                                            let _e1743 = phi_4137_;
                                            phi_4290_ = _e1743;
                                            if _e1743 {
                                                break;
                                            }
                                            let _e1745 = local_10;
                                            phi_4294_ = _e1743;
                                            let _e2060 = local_13;
                                            phi_3510_ = _e2060;
                                            phi_3511_ = false;
                                            phi_3512_ = _e683;
                                            phi_3513_ = select(_e685, 0u, (_e592 > _e1745.member.member_1));
                                        } else {
                                            if (_e683.member_1 >= _e94) {
                                                phi_3046_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_54(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_54(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e683.member_1 < _e94) {
                                                } else {
                                                    phi_4290_ = true;
                                                    break;
                                                }
                                                let _e696 = (_e274 * 2u);
                                                let _e698 = ((1u + _e696) % 7u);
                                                if (_e698 < 7u) {
                                                } else {
                                                    phi_4290_ = true;
                                                    break;
                                                }
                                                let _e703 = global_7.member[_e683.member_1][_e698];
                                                let _e705 = ((_e696 + 2u) % 7u);
                                                if (_e705 < 7u) {
                                                } else {
                                                    phi_4290_ = true;
                                                    break;
                                                }
                                                let _e710 = global_7.member[_e683.member_1][_e705];
                                                let _e711 = (_e273 * 2u);
                                                let _e713 = ((1u + _e711) % 7u);
                                                if (_e713 < 7u) {
                                                } else {
                                                    phi_4290_ = true;
                                                    break;
                                                }
                                                let _e718 = global_7.member[_e683.member_1][_e713];
                                                let _e720 = ((_e711 + 2u) % 7u);
                                                if (_e720 < 7u) {
                                                } else {
                                                    phi_4290_ = true;
                                                    break;
                                                }
                                                let _e725 = global_7.member[_e683.member_1][_e720];
                                                let _e726 = (_e275 * 2u);
                                                let _e728 = ((1u + _e726) % 7u);
                                                if (_e728 < 7u) {
                                                } else {
                                                    phi_4290_ = true;
                                                    break;
                                                }
                                                let _e733 = global_7.member[_e683.member_1][_e728];
                                                let _e735 = ((_e726 + 2u) % 7u);
                                                if (_e735 < 7u) {
                                                } else {
                                                    phi_4290_ = true;
                                                    break;
                                                }
                                                let _e740 = global_7.member[_e683.member_1][_e735];
                                                let _e763 = (bitcast<f32>((bitcast<u32>((_e683.member.member_1.x - _e683.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e764 = (bitcast<f32>((bitcast<u32>((_e683.member.member_1.y - _e683.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e765 = (bitcast<f32>((bitcast<u32>((_e683.member.member_1.z - _e683.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e767 = select(_e148, _e763, (_e763 > _e148));
                                                let _e769 = select(_e148, _e764, (_e764 > _e148));
                                                let _e771 = select(_e148, _e765, (_e765 > _e148));
                                                let _e802 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e703 & 2097151u))) - 8388608f) * _e767));
                                                let _e807 = (bitcast<i32>((_e703 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e810 = bitcast<f32>((_e802 & bitcast<u32>(_e807)));
                                                let _e811 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e718 & 2097151u))) - 8388608f) * _e769));
                                                let _e816 = (bitcast<i32>((_e718 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e819 = bitcast<f32>((_e811 & bitcast<u32>(_e816)));
                                                let _e820 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e733 & 2097151u))) - 8388608f) * _e771));
                                                let _e825 = (bitcast<i32>((_e733 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e828 = bitcast<f32>((_e820 & bitcast<u32>(_e825)));
                                                let _e832 = bitcast<f32>((_e802 & bitcast<u32>(~(_e807))));
                                                let _e836 = bitcast<f32>((_e811 & bitcast<u32>(~(_e816))));
                                                let _e840 = bitcast<f32>((_e820 & bitcast<u32>(~(_e825))));
                                                let _e841 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e710 & 2097151u))) - 8388608f) * _e767));
                                                let _e846 = (bitcast<i32>((_e710 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e849 = bitcast<f32>((_e841 & bitcast<u32>(_e846)));
                                                let _e850 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e725 & 2097151u))) - 8388608f) * _e769));
                                                let _e855 = (bitcast<i32>((_e725 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e858 = bitcast<f32>((_e850 & bitcast<u32>(_e855)));
                                                let _e859 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e740 & 2097151u))) - 8388608f) * _e771));
                                                let _e864 = (bitcast<i32>((_e740 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e867 = bitcast<f32>((_e859 & bitcast<u32>(_e864)));
                                                let _e871 = bitcast<f32>((_e841 & bitcast<u32>(~(_e846))));
                                                let _e875 = bitcast<f32>((_e850 & bitcast<u32>(~(_e855))));
                                                let _e879 = bitcast<f32>((_e859 & bitcast<u32>(~(_e864))));
                                                let _e909 = global_7.member[_e683.member_1][0u];
                                                let _e913 = global_7.member[_e683.member_1][2u];
                                                let _e917 = global_7.member[_e683.member_1][4u];
                                                let _e921 = global_7.member[_e683.member_1][6u];
                                                let _e933 = (((_e913 >> bitcast<u32>(22i)) | ((_e917 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e921 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e934 = (_e909 & 268435455u);
                                                let _e935 = (_e933 & 268435455u);
                                                let _e938 = ((_e909 >> bitcast<u32>(28u)) & 7u);
                                                let _e946 = ((_e909 >> bitcast<u32>(31i)) | (((_e933 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e947 = (_e938 != 0u);
                                                if (_e938 == 0u) {
                                                    phi_3008_ = _e934;
                                                } else {
                                                    if (_e938 == 7u) {
                                                        phi_3007_ = 2147483648u;
                                                    } else {
                                                        phi_3007_ = ((2147483648u | (_e938 << bitcast<u32>(28u))) | (_e935 & 268435455u));
                                                    }
                                                    let _e956 = phi_3007_;
                                                    phi_3008_ = _e956;
                                                }
                                                let _e958 = phi_3008_;
                                                if _e947 {
                                                    let _e959 = (_e938 != 7u);
                                                    if _e959 {
                                                        phi_3018_ = (_e935 + _e938);
                                                    } else {
                                                        phi_3018_ = u32();
                                                    }
                                                    let _e962 = phi_3018_;
                                                    phi_3020_ = _e962;
                                                    phi_3021_ = select(true, false, _e959);
                                                } else {
                                                    phi_3020_ = u32();
                                                    phi_3021_ = true;
                                                }
                                                let _e965 = phi_3020_;
                                                let _e967 = phi_3021_;
                                                if (_e946 == 0u) {
                                                    phi_3042_ = (_e934 + select(0u, 1u, !(_e947)));
                                                } else {
                                                    if (_e946 == 7u) {
                                                        phi_3041_ = 2147483648u;
                                                    } else {
                                                        phi_3041_ = ((2147483648u | (_e946 << bitcast<u32>(28u))) | (select(_e965, _e935, _e967) & 268435455u));
                                                    }
                                                    let _e980 = phi_3041_;
                                                    phi_3042_ = _e980;
                                                }
                                                let _e982 = phi_3042_;
                                                phi_3046_ = type_55(array<vec4<f32>, 3>(vec4<f32>((_e683.member.member.x + _e810), (_e683.member.member.x + _e832), (_e683.member.member_1.x - _e849), (_e683.member.member_1.x - _e871)), vec4<f32>((_e683.member.member.y + _e819), (_e683.member.member.y + _e836), (_e683.member.member_1.y - _e858), (_e683.member.member_1.y - _e875)), vec4<f32>((_e683.member.member.z + _e828), (_e683.member.member.z + _e840), (_e683.member.member_1.z - _e867), (_e683.member.member_1.z - _e879))), type_54(type_34((_e683.member.member + vec4<f32>(_e810, _e819, _e828, 0f)), (_e683.member.member_1 - vec4<f32>(_e849, _e858, _e867, 0f))), _e958), type_54(type_34((_e683.member.member + vec4<f32>(_e832, _e836, _e840, 0f)), (_e683.member.member_1 - vec4<f32>(_e871, _e875, _e879, 0f))), _e982));
                                            }
                                            let _e987 = phi_3046_;
                                            let _e1006 = ((_e987.member[0].x - _e359) * _e362);
                                            let _e1007 = ((_e987.member[0].y - _e359) * _e362);
                                            let _e1008 = ((_e987.member[0].z - _e360) * _e362);
                                            let _e1009 = ((_e987.member[0].w - _e360) * _e362);
                                            let _e1019 = ((_e987.member[1].x - _e423) * _e426);
                                            let _e1020 = ((_e987.member[1].y - _e423) * _e426);
                                            let _e1021 = ((_e987.member[1].z - _e424) * _e426);
                                            let _e1022 = ((_e987.member[1].w - _e424) * _e426);
                                            let _e1032 = ((_e987.member[2].x - _e487) * _e490);
                                            let _e1033 = ((_e987.member[2].y - _e487) * _e490);
                                            let _e1034 = ((_e987.member[2].z - _e488) * _e490);
                                            let _e1035 = ((_e987.member[2].w - _e488) * _e490);
                                            let _e1037 = select(_e1034, _e1032, (_e1032 < _e1034));
                                            let _e1039 = select(_e1035, _e1033, (_e1033 < _e1035));
                                            let _e1041 = select(_e1034, _e1032, (_e1032 > _e1034));
                                            let _e1043 = select(_e1035, _e1033, (_e1033 > _e1035));
                                            let _e1045 = select(_e1008, _e1006, (_e1006 < _e1008));
                                            let _e1047 = select(_e1009, _e1007, (_e1007 < _e1009));
                                            let _e1049 = select(_e1021, _e1019, (_e1019 < _e1021));
                                            let _e1051 = select(_e1022, _e1020, (_e1020 < _e1022));
                                            let _e1053 = select(_e1049, _e1045, (_e1045 > _e1049));
                                            let _e1055 = select(_e1051, _e1047, (_e1047 > _e1051));
                                            let _e1057 = select(_e1037, _e1053, (_e1053 > _e1037));
                                            let _e1059 = select(_e1039, _e1055, (_e1055 > _e1039));
                                            let _e1061 = select(_e1008, _e1006, (_e1006 > _e1008));
                                            let _e1063 = select(_e1009, _e1007, (_e1007 > _e1009));
                                            let _e1065 = select(_e1021, _e1019, (_e1019 > _e1021));
                                            let _e1067 = select(_e1022, _e1020, (_e1020 > _e1022));
                                            let _e1069 = select(_e1065, _e1061, (_e1061 < _e1065));
                                            let _e1071 = select(_e1067, _e1063, (_e1063 < _e1067));
                                            let _e1076 = -(_e1037);
                                            let _e1077 = -(_e1039);
                                            let _e1084 = (select(_e1041, _e1069, (_e1069 < _e1041)) + (select(_e1076, _e1041, (_e1041 > _e1076)) * 0.0000019073523f));
                                            let _e1085 = (select(_e1043, _e1071, (_e1071 < _e1043)) + (select(_e1077, _e1043, (_e1043 > _e1077)) * 0.0000019073523f));
                                            let _e1087 = select(_e592, _e1057, (_e1057 > _e592));
                                            let _e1089 = select(_e592, _e1059, (_e1059 > _e592));
                                            let _e1094 = (_e1087 <= select(_e641.member.member_1, _e1084, (_e1084 < _e641.member.member_1)));
                                            let _e1095 = (_e1089 <= select(_e641.member.member_1, _e1085, (_e1085 < _e641.member.member_1)));
                                            let _e1096 = (_e1087 <= _e1089);
                                            if _e1094 {
                                                if _e1095 {
                                                    if _e1096 {
                                                        phi_3411_ = _e987.member_2;
                                                    } else {
                                                        phi_3411_ = _e987.member_1;
                                                    }
                                                    let _e1100 = phi_3411_;
                                                    let _e1121 = (_e685 % 128u);
                                                    let _e1122 = (_e1121 < 128u);
                                                    if _e1122 {
                                                    } else {
                                                        phi_4290_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1121] = _e1100.member_1;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4290_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1121] = _e1100.member.member.x;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4290_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1121] = _e1100.member.member.y;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4290_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1121] = _e1100.member.member.z;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4290_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1121] = _e1100.member.member_1.x;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4290_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1121] = _e1100.member.member_1.y;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4290_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1121] = _e1100.member.member_1.z;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4290_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1121] = select(_e1087, _e1089, _e1096);
                                                    if _e1096 {
                                                        phi_3487_ = _e987.member_1;
                                                    } else {
                                                        phi_3487_ = _e987.member_2;
                                                    }
                                                    let _e1135 = phi_3487_;
                                                    phi_3488_ = _e1135;
                                                    phi_3489_ = (_e685 + 1u);
                                                } else {
                                                    phi_3488_ = type_54();
                                                    phi_3489_ = u32();
                                                }
                                                let _e1137 = phi_3488_;
                                                let _e1139 = phi_3489_;
                                                phi_3491_ = _e1137;
                                                phi_3492_ = _e1139;
                                                phi_3493_ = select(true, false, _e1095);
                                            } else {
                                                phi_3491_ = type_54();
                                                phi_3492_ = u32();
                                                phi_3493_ = true;
                                            }
                                            let _e1142 = phi_3491_;
                                            let _e1144 = phi_3492_;
                                            let _e1146 = phi_3493_;
                                            if _e1146 {
                                                if _e1094 {
                                                    phi_3502_ = _e987.member_1;
                                                } else {
                                                    phi_3502_ = _e987.member_2;
                                                }
                                                let _e1150 = phi_3502_;
                                                phi_3507_ = select(_e1095, true, _e1094);
                                                phi_3508_ = _e1150;
                                            } else {
                                                phi_3507_ = _e681;
                                                phi_3508_ = _e1142;
                                            }
                                            let _e1153 = phi_3507_;
                                            let _e1155 = phi_3508_;
                                            phi_4294_ = _e639;
                                            phi_3510_ = type_43(_e641.member, (_e641.member_1 + 1u), _e641.member_2);
                                            phi_3511_ = _e1153;
                                            phi_3512_ = _e1155;
                                            phi_3513_ = select(_e1144, _e685, _e1146);
                                        }
                                        let _e1751 = phi_4294_;
                                        let _e1753 = phi_3510_;
                                        let _e1755 = phi_3511_;
                                        let _e1757 = phi_3512_;
                                        let _e1759 = phi_3513_;
                                        phi_4293_ = _e1751;
                                        phi_3514_ = _e1753;
                                        phi_3515_ = _e1755;
                                        phi_3516_ = _e1757;
                                        phi_3517_ = _e1759;
                                        phi_3518_ = (_e649 - 1u);
                                    } else {
                                        phi_4293_ = _e639;
                                        phi_3514_ = _e641;
                                        phi_3515_ = _e681;
                                        phi_3516_ = _e683;
                                        phi_3517_ = _e685;
                                        phi_3518_ = _e649;
                                    }
                                    let _e1761 = phi_4293_;
                                    let _e1763 = phi_3514_;
                                    let _e1765 = phi_3515_;
                                    let _e1767 = phi_3516_;
                                    let _e1769 = phi_3517_;
                                    let _e1771 = phi_3518_;
                                    phi_4292_ = _e1761;
                                    phi_3519_ = _e1763;
                                    phi_3520_ = _e1765;
                                    phi_3521_ = _e1767;
                                    phi_3522_ = _e1769;
                                    phi_3523_ = _e1771;
                                } else {
                                    phi_4292_ = _e639;
                                    phi_3519_ = type_43();
                                    phi_3520_ = bool();
                                    phi_3521_ = type_54();
                                    phi_3522_ = u32();
                                    phi_3523_ = u32();
                                }
                                let _e1773 = phi_4292_;
                                let _e1775 = phi_3519_;
                                let _e1777 = phi_3520_;
                                let _e1779 = phi_3521_;
                                let _e1781 = phi_3522_;
                                let _e1783 = phi_3523_;
                                phi_4291_ = _e1773;
                                phi_1211_ = _e1775;
                                phi_1214_ = _e1777;
                                phi_1216_ = _e1779;
                                phi_1218_ = _e1781;
                                phi_1220_ = _e1783;
                                phi_3524_ = _e653;
                            } else {
                                phi_4291_ = _e639;
                                phi_1211_ = type_43();
                                phi_1214_ = bool();
                                phi_1216_ = type_54();
                                phi_1218_ = u32();
                                phi_1220_ = u32();
                                phi_3524_ = false;
                            }
                            let _e1785 = phi_4291_;
                            let _e1787 = phi_1211_;
                            let _e1789 = phi_1214_;
                            let _e1791 = phi_1216_;
                            let _e1793 = phi_1218_;
                            let _e1795 = phi_1220_;
                            let _e1797 = phi_3524_;
                            continue;
                            continuing {
                                phi_4143_ = _e1785;
                                phi_1210_ = _e1787;
                                phi_1213_ = _e1789;
                                phi_1215_ = _e1791;
                                phi_1217_ = _e1793;
                                phi_1219_ = _e1795;
                                phi_4290_ = _e1785;
                                break if !(_e1797);
                            }
                        }
                        let _e1800 = phi_4290_;
                        if _e1800 {
                            break;
                        }
                        let _e1802 = local_11;
                        if (_e1802.member.member.member_3 != 4294967295u) {
                            let _e1808 = bitcast<u32>(_e1802.member.member.member);
                            let _e1812 = (bitcast<i32>((_e1808 >> bitcast<u32>(23i))) & 255i);
                            let _e1813 = (_e1812 + _e276);
                            if (_e1812 == 255i) {
                                phi_3583_ = _e1802.member.member.member;
                            } else {
                                if (_e1812 > 0i) {
                                    if (_e1813 > 0i) {
                                        let _e1817 = (_e1813 < 255i);
                                        if _e1817 {
                                            phi_3562_ = bitcast<f32>((_e1808 + bitcast<u32>((_e276 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3562_ = f32();
                                        }
                                        let _e1824 = phi_3562_;
                                        phi_3564_ = _e1824;
                                        phi_3565_ = select(true, false, _e1817);
                                    } else {
                                        phi_3564_ = f32();
                                        phi_3565_ = true;
                                    }
                                    let _e1827 = phi_3564_;
                                    let _e1829 = phi_3565_;
                                    phi_3566_ = _e1827;
                                    phi_3567_ = _e1829;
                                } else {
                                    phi_3566_ = f32();
                                    phi_3567_ = true;
                                }
                                let _e1831 = phi_3566_;
                                let _e1833 = phi_3567_;
                                if _e1833 {
                                    let _e1834 = (_e1808 & 2147483648u);
                                    let _e1841 = ((_e1808 & 8388607u) | (select(0u, 1u, ((_e1808 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1845 = (_e1841 == 0u);
                                    if _e1845 {
                                        phi_4095_ = bitcast<f32>(_e1834);
                                    } else {
                                        let _e1850 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1841)), 32u, _e1845) - 8u);
                                        let _e1853 = (_e1841 << bitcast<u32>((_e1850 & 31u)));
                                        let _e1855 = ((_e1813 + select(0i, 1i, (_e1812 == 0i))) - bitcast<i32>(_e1850));
                                        if (_e1855 >= 255i) {
                                            phi_4085_ = bitcast<f32>((_e1834 | 2139095040u));
                                            phi_4086_ = f32();
                                            phi_4087_ = true;
                                        } else {
                                            let _e1857 = (_e1855 > 0i);
                                            if _e1857 {
                                                phi_4079_ = bitcast<f32>(((_e1834 | (bitcast<u32>(_e1855) << bitcast<u32>(23i))) | (_e1853 & 8388607u)));
                                                phi_4080_ = f32();
                                            } else {
                                                if (_e1855 < -24i) {
                                                    phi_4045_ = 26u;
                                                } else {
                                                    phi_4045_ = bitcast<u32>((1i - _e1855));
                                                }
                                                let _e1862 = phi_4045_;
                                                let _e1863 = (_e1862 & 31u);
                                                let _e1865 = (_e1853 >> bitcast<u32>(_e1863));
                                                let _e1869 = (_e1853 & ((1u << bitcast<u32>(_e1863)) - 1u));
                                                let _e1873 = (1u << bitcast<u32>(((_e1862 - 1u) & 31u)));
                                                if (_e1869 > _e1873) {
                                                    phi_4066_ = true;
                                                } else {
                                                    if (_e1869 == _e1873) {
                                                        phi_4063_ = ((_e1865 & 1u) == 1u);
                                                    } else {
                                                        phi_4063_ = false;
                                                    }
                                                    let _e1879 = phi_4063_;
                                                    phi_4066_ = _e1879;
                                                }
                                                let _e1881 = phi_4066_;
                                                phi_4079_ = f32();
                                                phi_4080_ = bitcast<f32>((_e1834 | (_e1865 + select(0u, 1u, _e1881))));
                                            }
                                            let _e1894 = phi_4079_;
                                            let _e1896 = phi_4080_;
                                            phi_4085_ = _e1894;
                                            phi_4086_ = _e1896;
                                            phi_4087_ = _e1857;
                                        }
                                        let _e1900 = phi_4085_;
                                        let _e1902 = phi_4086_;
                                        let _e1904 = phi_4087_;
                                        phi_4095_ = select(_e1902, _e1900, _e1904);
                                    }
                                    let _e1908 = phi_4095_;
                                    phi_3582_ = _e1908;
                                } else {
                                    phi_3582_ = _e1831;
                                }
                                let _e1910 = phi_3582_;
                                phi_3583_ = _e1910;
                            }
                            let _e1912 = phi_3583_;
                            let _e1913 = bitcast<u32>(_e1912);
                            if ((_e1913 & 2147483647u) >= 2139095040u) {
                                phi_3595_ = bitcast<f32>(((_e1913 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3595_ = _e1912;
                            }
                            let _e1920 = phi_3595_;
                            phi_3600_ = type_22(_e1920, _e1802.member.member.member_1, _e1802.member.member.member_2, _e1802.member.member.member_3);
                        } else {
                            phi_3600_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1925 = phi_3600_;
                        if _e152 {
                        } else {
                            break;
                        }
                        global_2.member[_e136] = _e1925;
                        let _e1929 = local_12;
                        if _e153 {
                        } else {
                            break;
                        }
                        global_5.member[_e136] = _e1929.member_1;
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e1934 = select(0u, 1u, (_e220 <= _e230));
                        if (_e1934 > 0u) {
                            let _e1936 = (1u < _e104);
                            if _e1936 {
                                if (0u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1940 = atomicAdd((&global_6.member[0u]), _e1934);
                                if ((_e1940 + _e1934) < _e1940) {
                                    if _e1936 {
                                    } else {
                                        break;
                                    }
                                    let _e1945 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1948 = select(0u, 1u, (_e1925.member_3 != 4294967295u));
                        if (_e1948 > 0u) {
                            let _e1950 = (3u < _e104);
                            if _e1950 {
                                if (2u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1954 = atomicAdd((&global_6.member[2u]), _e1948);
                                if ((_e1954 + _e1948) < _e1954) {
                                    if _e1950 {
                                    } else {
                                        break;
                                    }
                                    let _e1959 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1929.member_1 > 0u) {
                            let _e1961 = (5u < _e104);
                            if _e1961 {
                                if (4u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1965 = atomicAdd((&global_6.member[4u]), _e1929.member_1);
                                if ((_e1965 + _e1929.member_1) < _e1965) {
                                    if _e1961 {
                                    } else {
                                        break;
                                    }
                                    let _e1970 = atomicAdd((&global_6.member[5u]), 1u);
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
fn trace_paths_counted_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
