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

struct type_50 {
    member: type_34,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

struct type_56 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_1: type_24;
@group(0) @binding(0) 
var<uniform> global_2: type_45;
@group(0) @binding(1) 
var<storage> global_3: type_13;
@group(0) @binding(3) 
var<storage> global_4: type_29;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_56;
@group(0) @binding(2) 
var<storage> global_7: type_4;

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
    var phi_513_: i32;
    var phi_514_: i32;
    var phi_524_: bool;
    var phi_534_: u32;
    var phi_535_: u32;
    var phi_537_: bool;
    var phi_542_: u32;
    var phi_575_: i32;
    var phi_593_: f32;
    var phi_599_: f32;
    var phi_639_: f32;
    var phi_645_: f32;
    var phi_718_: f32;
    var phi_724_: f32;
    var phi_764_: f32;
    var phi_770_: f32;
    var phi_843_: f32;
    var phi_849_: f32;
    var phi_889_: f32;
    var phi_895_: f32;
    var phi_1014_: i32;
    var phi_1036_: u32;
    var phi_1037_: u32;
    var phi_1074_: i32;
    var phi_1096_: u32;
    var phi_1097_: u32;
    var phi_1105_: f32;
    var phi_1106_: f32;
    var phi_4886_: bool;
    var phi_1211_: type_43;
    var phi_1214_: u32;
    var phi_1216_: bool;
    var phi_1218_: u32;
    var phi_1220_: type_50;
    var phi_1231_: bool;
    var phi_1317_: bool;
    var phi_1318_: u32;
    var phi_1319_: type_50;
    var phi_1338_: type_43;
    var phi_1341_: type_8;
    var phi_1342_: type_8;
    var phi_1364_: type_8;
    var phi_1408_: u32;
    var phi_1414_: u32;
    var phi_1424_: u32;
    var phi_1440_: u32;
    var phi_1473_: u32;
    var phi_1479_: u32;
    var phi_1945_: u32;
    var phi_1963_: u32;
    var phi_1981_: u32;
    var phi_2004_: u32;
    var phi_2022_: u32;
    var phi_2040_: u32;
    var phi_2063_: u32;
    var phi_2081_: u32;
    var phi_2099_: u32;
    var phi_1653_: u32;
    var phi_1668_: u32;
    var phi_1678_: u32;
    var phi_1699_: u32;
    var phi_1720_: u32;
    var phi_1750_: u32;
    var phi_1765_: u32;
    var phi_1775_: u32;
    var phi_1796_: u32;
    var phi_1817_: u32;
    var phi_1847_: u32;
    var phi_1862_: u32;
    var phi_1872_: u32;
    var phi_1893_: u32;
    var phi_1914_: u32;
    var phi_1506_: u32;
    var phi_1555_: u32;
    var phi_1604_: u32;
    var phi_2105_: array<array<f32, 3>, 3>;
    var phi_4447_: bool;
    var phi_4462_: bool;
    var phi_4477_: bool;
    var phi_4492_: bool;
    var phi_4507_: bool;
    var phi_4522_: bool;
    var phi_2647_: f32;
    var phi_2648_: f32;
    var phi_2649_: f32;
    var phi_2650_: f32;
    var phi_2651_: vec3<f32>;
    var phi_2652_: vec3<f32>;
    var phi_2653_: vec3<f32>;
    var phi_2654_: vec3<f32>;
    var phi_4537_: bool;
    var phi_4552_: bool;
    var phi_4567_: bool;
    var phi_4582_: bool;
    var phi_4597_: bool;
    var phi_4612_: bool;
    var phi_2862_: f32;
    var phi_2882_: type_42;
    var phi_2883_: type_42;
    var phi_2886_: type_42;
    var phi_2887_: type_42;
    var phi_2888_: bool;
    var phi_2892_: type_42;
    var phi_2901_: type_22;
    var phi_2926_: bool;
    var phi_2927_: bool;
    var phi_2934_: type_43;
    var phi_2935_: type_43;
    var phi_2936_: type_43;
    var phi_1339_: type_43;
    var phi_4880_: bool;
    var phi_5183_: bool;
    var phi_2937_: type_43;
    var phi_3439_: u32;
    var phi_3445_: u32;
    var phi_3699_: u32;
    var phi_3700_: u32;
    var phi_3710_: u32;
    var phi_3712_: u32;
    var phi_3713_: bool;
    var phi_3733_: u32;
    var phi_3734_: u32;
    var phi_3738_: type_51;
    var phi_4103_: type_50;
    var phi_4179_: type_50;
    var phi_4180_: u32;
    var phi_4181_: type_50;
    var phi_4183_: u32;
    var phi_4184_: type_50;
    var phi_4185_: bool;
    var phi_4194_: type_50;
    var phi_4199_: bool;
    var phi_4201_: type_50;
    var phi_4206_: type_43;
    var phi_4207_: bool;
    var phi_4208_: u32;
    var phi_4209_: type_50;
    var phi_4217_: type_43;
    var phi_4220_: type_50;
    var phi_5095_: bool;
    var phi_4221_: type_43;
    var phi_4222_: u32;
    var phi_4223_: bool;
    var phi_4224_: u32;
    var phi_4225_: type_50;
    var phi_5094_: bool;
    var phi_4226_: type_43;
    var phi_4227_: u32;
    var phi_4228_: bool;
    var phi_4229_: u32;
    var phi_4230_: type_50;
    var phi_5093_: bool;
    var phi_1212_: type_43;
    var phi_1215_: u32;
    var phi_1217_: bool;
    var phi_1219_: u32;
    var phi_1221_: type_50;
    var phi_4231_: bool;
    var phi_5092_: bool;
    var local_10: type_43;
    var phi_4269_: f32;
    var phi_4271_: f32;
    var phi_4272_: bool;
    var phi_4273_: f32;
    var phi_4274_: bool;
    var phi_4788_: u32;
    var phi_4806_: bool;
    var phi_4809_: bool;
    var phi_4822_: f32;
    var phi_4823_: f32;
    var phi_4828_: f32;
    var phi_4829_: f32;
    var phi_4830_: bool;
    var phi_4838_: f32;
    var phi_4289_: f32;
    var phi_4290_: f32;
    var phi_4302_: f32;
    var phi_4307_: type_22;
    var local_11: type_43;
    var local_12: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e98 = global;
            let _e100 = arrayLength((&global_3.member));
            let _e103 = arrayLength((&global_7.member));
            let _e111 = arrayLength((&global_6.member));
            let _e115 = global_2.member[0u][0u];
            let _e119 = global_2.member[0u][1u];
            let _e123 = global_2.member[0u][2u];
            let _e127 = global_2.member[0u][3u];
            let _e131 = global_2.member[1u][0u];
            let _e135 = global_2.member[1u][1u];
            let _e139 = global_2.member[1u][2u];
            let _e143 = (_e98.x + (_e98.y * 2097152u));
            let _e155 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e127) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e115), bitcast<i32>(_e119), bitcast<i32>(_e123));
            local = array<i32, 3>(bitcast<i32>(_e131), bitcast<i32>(_e135), bitcast<i32>(_e139));
            let _e158 = (_e143 < arrayLength((&global_4.member)));
            if _e158 {
                let _e159 = (_e143 < arrayLength((&global_1.member)));
                if _e159 {
                    let _e160 = (_e143 < arrayLength((&global_5.member)));
                    if _e160 {
                        if _e158 {
                        } else {
                            break;
                        }
                        let _e170 = global_4.member[_e143].member.member_2[0u];
                        let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                        let _e178 = global_4.member[_e143].member.member_2[1u];
                        let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                        let _e186 = global_4.member[_e143].member.member_2[2u];
                        let _e188 = (bitcast<u32>(_e186) & 2147483647u);
                        let _e194 = global_4.member[_e143].member.member[0u];
                        let _e196 = (bitcast<u32>(_e194) & 2147483647u);
                        let _e202 = global_4.member[_e143].member.member[1u];
                        let _e204 = (bitcast<u32>(_e202) & 2147483647u);
                        let _e210 = global_4.member[_e143].member.member[2u];
                        let _e212 = (bitcast<u32>(_e210) & 2147483647u);
                        let _e214 = select(_e180, _e172, (_e180 < _e172));
                        let _e216 = select(_e188, _e214, (_e188 < _e214));
                        let _e218 = select(_e196, _e216, (_e196 < _e216));
                        let _e220 = select(_e204, _e218, (_e204 < _e218));
                        let _e222 = select(_e212, _e220, (_e212 < _e220));
                        let _e227 = global_4.member[_e143].member.member_1;
                        let _e228 = bitcast<u32>(_e227);
                        let _e229 = (_e228 & 2147483647u);
                        let _e237 = global_4.member[_e143].member.member_3;
                        let _e238 = bitcast<u32>(_e237);
                        let _e239 = (_e238 & 2147483647u);
                        let _e243 = (((select(_e229, _e222, (_e229 < _e222)) < 2139095040u) && (_e239 <= 2139095040u)) && (_e216 > 0u));
                        if _e243 {
                            let _e246 = (bitcast<u32>(bitcast<f32>(_e216)) & 2147483647u);
                            if (_e246 >= 8388608u) {
                                phi_513_ = (bitcast<i32>((_e246 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_513_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e246)), 32u, (_e246 == 0u))));
                            }
                            let _e260 = phi_513_;
                            phi_514_ = _e260;
                        } else {
                            phi_514_ = 0i;
                        }
                        let _e262 = phi_514_;
                        let _e263 = (_e172 == _e216);
                        if _e263 {
                            phi_524_ = true;
                        } else {
                            phi_524_ = (_e180 == _e216);
                        }
                        let _e266 = phi_524_;
                        let _e267 = select(1u, 0u, _e263);
                        if _e266 {
                            let _e268 = (_e267 + 1u);
                            phi_534_ = _e268;
                            phi_535_ = _e268;
                            phi_537_ = select(true, false, (_e268 == 2u));
                        } else {
                            phi_534_ = u32();
                            phi_535_ = 0u;
                            phi_537_ = true;
                        }
                        let _e272 = phi_534_;
                        let _e274 = phi_535_;
                        let _e276 = phi_537_;
                        if _e276 {
                            phi_542_ = (_e274 + 1u);
                        } else {
                            phi_542_ = 0u;
                        }
                        let _e280 = phi_542_;
                        let _e281 = select(_e272, _e274, _e276);
                        let _e282 = select(_e267, select(2u, _e267, _e266), _e276);
                        let _e283 = -(_e262);
                        if (_e283 < -126i) {
                            phi_575_ = -126i;
                        } else {
                            phi_575_ = select(_e283, 127i, (_e283 > 127i));
                        }
                        let _e288 = phi_575_;
                        let _e293 = bitcast<f32>((bitcast<u32>((_e288 + 127i)) << bitcast<u32>(23i)));
                        let _e299 = bitcast<f32>((bitcast<u32>(((_e283 - _e288) + 127i)) << bitcast<u32>(23i)));
                        let _e304 = global_4.member[_e143].member.member;
                        let _e305 = (_e281 == 0u);
                        if _e305 {
                            phi_593_ = _e304[0];
                        } else {
                            phi_593_ = _e304[1];
                        }
                        let _e309 = phi_593_;
                        let _e310 = (_e281 == 2u);
                        if _e310 {
                            phi_599_ = _e304[2];
                        } else {
                            phi_599_ = _e309;
                        }
                        let _e313 = phi_599_;
                        let _e314 = bitcast<u32>(_e313);
                        let _e316 = ((_e314 & 2139095040u) != 0u);
                        let _e328 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e314 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e314 & 2147483648u))), _e313, _e316) * select(0.00000011920929f, 1f, _e316));
                        let _e329 = global_4.member[_e143].member.member_2;
                        if _e305 {
                            phi_639_ = _e329[0];
                        } else {
                            phi_639_ = _e329[1];
                        }
                        let _e333 = phi_639_;
                        if _e310 {
                            phi_645_ = _e329[2];
                        } else {
                            phi_645_ = _e333;
                        }
                        let _e336 = phi_645_;
                        let _e337 = bitcast<u32>(_e336);
                        let _e339 = ((_e337 & 2139095040u) != 0u);
                        let _e353 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e336, _e339) * _e293) * select(0.00000011920929f, 1f, _e339)) * _e299);
                        let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e360 = bitcast<f32>((bitcast<u32>(_e328) & 2147483647u));
                        let _e361 = (_e360 * 0.00000011920929f);
                        let _e364 = select(select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f)), 0f, _e357);
                        let _e365 = select(0f, _e353, _e357);
                        let _e366 = (_e328 + _e364);
                        let _e367 = (_e328 - _e364);
                        let _e369 = select(38685626000000000000000000f, (1f / _e353), _e357);
                        let _e370 = (_e280 == 0u);
                        if _e370 {
                            phi_718_ = _e304[0];
                        } else {
                            phi_718_ = _e304[1];
                        }
                        let _e374 = phi_718_;
                        let _e375 = (_e280 == 2u);
                        if _e375 {
                            phi_724_ = _e304[2];
                        } else {
                            phi_724_ = _e374;
                        }
                        let _e378 = phi_724_;
                        let _e379 = bitcast<u32>(_e378);
                        let _e381 = ((_e379 & 2139095040u) != 0u);
                        let _e393 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e379 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e379 & 2147483648u))), _e378, _e381) * select(0.00000011920929f, 1f, _e381));
                        if _e370 {
                            phi_764_ = _e329[0];
                        } else {
                            phi_764_ = _e329[1];
                        }
                        let _e397 = phi_764_;
                        if _e375 {
                            phi_770_ = _e329[2];
                        } else {
                            phi_770_ = _e397;
                        }
                        let _e400 = phi_770_;
                        let _e401 = bitcast<u32>(_e400);
                        let _e403 = ((_e401 & 2139095040u) != 0u);
                        let _e417 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e401 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e401 & 2147483648u))), _e400, _e403) * _e293) * select(0.00000011920929f, 1f, _e403)) * _e299);
                        let _e421 = (bitcast<f32>((bitcast<u32>(_e417) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e424 = bitcast<f32>((bitcast<u32>(_e393) & 2147483647u));
                        let _e425 = (_e424 * 0.00000011920929f);
                        let _e428 = select(select(0.00000000000011368684f, _e425, (_e425 > 0.00000000000011368684f)), 0f, _e421);
                        let _e429 = select(0f, _e417, _e421);
                        let _e430 = (_e393 + _e428);
                        let _e431 = (_e393 - _e428);
                        let _e433 = select(38685626000000000000000000f, (1f / _e417), _e421);
                        let _e434 = (_e282 == 0u);
                        if _e434 {
                            phi_843_ = _e304[0];
                        } else {
                            phi_843_ = _e304[1];
                        }
                        let _e438 = phi_843_;
                        let _e439 = (_e282 == 2u);
                        if _e439 {
                            phi_849_ = _e304[2];
                        } else {
                            phi_849_ = _e438;
                        }
                        let _e442 = phi_849_;
                        let _e443 = bitcast<u32>(_e442);
                        let _e445 = ((_e443 & 2139095040u) != 0u);
                        let _e457 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e443 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e443 & 2147483648u))), _e442, _e445) * select(0.00000011920929f, 1f, _e445));
                        if _e434 {
                            phi_889_ = _e329[0];
                        } else {
                            phi_889_ = _e329[1];
                        }
                        let _e461 = phi_889_;
                        if _e439 {
                            phi_895_ = _e329[2];
                        } else {
                            phi_895_ = _e461;
                        }
                        let _e464 = phi_895_;
                        let _e465 = bitcast<u32>(_e464);
                        let _e467 = ((_e465 & 2139095040u) != 0u);
                        let _e481 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e465 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e465 & 2147483648u))), _e464, _e467) * _e293) * select(0.00000011920929f, 1f, _e467)) * _e299);
                        let _e485 = (bitcast<f32>((bitcast<u32>(_e481) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e488 = bitcast<f32>((bitcast<u32>(_e457) & 2147483647u));
                        let _e489 = (_e488 * 0.00000011920929f);
                        let _e492 = select(select(0.00000000000011368684f, _e489, (_e489 > 0.00000000000011368684f)), 0f, _e485);
                        let _e493 = select(0f, _e481, _e485);
                        let _e494 = (_e457 + _e492);
                        let _e495 = (_e457 - _e492);
                        let _e497 = select(38685626000000000000000000f, (1f / _e481), _e485);
                        let _e499 = select(_e424, _e360, (_e360 > _e424));
                        if (_e243 && (select(_e488, _e499, (_e499 > _e488)) <= 1099511600000f)) {
                            let _e511 = ((_e229 & 8388607u) | (select(0u, 1u, ((_e229 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e514 = bitcast<i32>((_e229 >> bitcast<u32>(23i)));
                            let _e518 = (_e511 == 0u);
                            let _e521 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e511)), 32u, _e518)) - 8i);
                            if (_e514 == 255i) {
                                phi_1014_ = 255i;
                            } else {
                                phi_1014_ = (((_e514 + select(0i, 1i, (_e514 == 0i))) - _e521) + _e262);
                            }
                            let _e529 = phi_1014_;
                            let _e539 = (_e529 <= 0i);
                            if _e539 {
                                phi_1037_ = u32();
                            } else {
                                if _e518 {
                                    phi_1036_ = u32();
                                } else {
                                    phi_1036_ = select(((bitcast<u32>(_e529) << bitcast<u32>(23i)) | ((_e511 << bitcast<u32>(((_e521 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e529 >= 255i));
                                }
                                let _e543 = phi_1036_;
                                phi_1037_ = _e543;
                            }
                            let _e545 = phi_1037_;
                            let _e557 = ((_e239 & 8388607u) | (select(0u, 1u, ((_e239 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e560 = bitcast<i32>((_e239 >> bitcast<u32>(23i)));
                            let _e564 = (_e557 == 0u);
                            let _e567 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e557)), 32u, _e564)) - 8i);
                            if (_e560 == 255i) {
                                phi_1074_ = 255i;
                            } else {
                                phi_1074_ = (((_e560 + select(0i, 1i, (_e560 == 0i))) - _e567) + _e262);
                            }
                            let _e575 = phi_1074_;
                            let _e585 = (_e575 <= 0i);
                            if _e585 {
                                phi_1097_ = u32();
                            } else {
                                if _e564 {
                                    phi_1096_ = u32();
                                } else {
                                    phi_1096_ = select(((bitcast<u32>(_e575) << bitcast<u32>(23i)) | ((_e557 << bitcast<u32>(((_e567 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e575 >= 255i));
                                }
                                let _e589 = phi_1096_;
                                phi_1097_ = _e589;
                            }
                            let _e591 = phi_1097_;
                            phi_1105_ = bitcast<f32>(((_e238 & 2147483648u) | select(_e591, 0u, select(_e564, true, _e585))));
                            phi_1106_ = bitcast<f32>(((_e228 & 2147483648u) | select(_e545, 0u, select(_e518, true, _e539))));
                        } else {
                            phi_1105_ = 0f;
                            phi_1106_ = 1f;
                        }
                        let _e597 = phi_1105_;
                        let _e599 = phi_1106_;
                        if _e158 {
                        } else {
                            break;
                        }
                        let _e605 = global_4.member[_e143].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e608 = (_e281 % 3u);
                        let _e609 = (_e608 < 3u);
                        if _e609 {
                        } else {
                            break;
                        }
                        let _e611 = local_1[_e608];
                        let _e614 = (_e280 % 3u);
                        let _e615 = (_e614 < 3u);
                        if _e615 {
                        } else {
                            break;
                        }
                        let _e617 = local_1[_e614];
                        let _e620 = (_e282 % 3u);
                        let _e621 = (_e620 < 3u);
                        if _e621 {
                        } else {
                            break;
                        }
                        let _e623 = local_1[_e620];
                        if _e609 {
                        } else {
                            break;
                        }
                        let _e628 = local[_e608];
                        if _e615 {
                        } else {
                            break;
                        }
                        let _e632 = local[_e614];
                        if _e621 {
                        } else {
                            break;
                        }
                        let _e636 = local[_e620];
                        phi_4886_ = false;
                        phi_1211_ = type_43(type_39(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e597), 0u, 0u);
                        phi_1214_ = ((3u * _e100) + 1u);
                        phi_1216_ = (_e599 <= _e597);
                        phi_1218_ = 0u;
                        phi_1220_ = type_50(type_34(vec4<f32>((f32(_e611) * _e155), (f32(_e617) * _e155), (f32(_e623) * _e155), 0f), vec4<f32>((f32(_e628) * _e155), (f32(_e632) * _e155), (f32(_e636) * _e155), 0f)), select(0u, 2147483648u, (_e100 == 0u)));
                        loop {
                            let _e646 = phi_4886_;
                            let _e648 = phi_1211_;
                            let _e650 = phi_1214_;
                            let _e652 = phi_1216_;
                            let _e654 = phi_1218_;
                            let _e656 = phi_1220_;
                            local_10 = _e648;
                            local_11 = _e648;
                            if _e652 {
                                phi_1231_ = true;
                            } else {
                                phi_1231_ = (_e654 > 0u);
                            }
                            let _e659 = phi_1231_;
                            if _e659 {
                                let _e660 = (_e650 > 0u);
                                if _e660 {
                                    if _e652 {
                                        phi_1317_ = _e652;
                                        phi_1318_ = _e654;
                                        phi_1319_ = _e656;
                                    } else {
                                        let _e661 = (_e654 - 1u);
                                        let _e662 = (_e661 % 128u);
                                        let _e663 = (_e662 < 128u);
                                        if _e663 {
                                        } else {
                                            phi_5092_ = true;
                                            break;
                                        }
                                        let _e665 = local_7[_e662];
                                        if _e663 {
                                        } else {
                                            phi_5092_ = true;
                                            break;
                                        }
                                        let _e667 = local_6[_e662];
                                        if _e663 {
                                        } else {
                                            phi_5092_ = true;
                                            break;
                                        }
                                        let _e669 = local_5[_e662];
                                        if _e663 {
                                        } else {
                                            phi_5092_ = true;
                                            break;
                                        }
                                        let _e671 = local_4[_e662];
                                        if _e663 {
                                        } else {
                                            phi_5092_ = true;
                                            break;
                                        }
                                        let _e673 = local_3[_e662];
                                        if _e663 {
                                        } else {
                                            phi_5092_ = true;
                                            break;
                                        }
                                        let _e675 = local_2[_e662];
                                        if _e663 {
                                        } else {
                                            phi_5092_ = true;
                                            break;
                                        }
                                        let _e680 = local_8[_e662];
                                        if _e663 {
                                        } else {
                                            phi_5092_ = true;
                                            break;
                                        }
                                        let _e683 = local_9[_e662];
                                        phi_1317_ = (_e683 <= _e648.member.member_1);
                                        phi_1318_ = _e661;
                                        phi_1319_ = type_50(type_34(vec4<f32>(_e665, _e667, _e669, 0f), vec4<f32>(_e671, _e673, _e675, 0f)), _e680);
                                    }
                                    let _e688 = phi_1317_;
                                    let _e690 = phi_1318_;
                                    let _e692 = phi_1319_;
                                    if _e688 {
                                        let _e696 = ((_e692.member_1 & 2147483648u) != 0u);
                                        let _e697 = (_e692.member_1 & 268435455u);
                                        if _e696 {
                                            phi_1338_ = _e648;
                                            phi_1341_ = type_8(0u, ((_e692.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e704 = phi_1338_;
                                                let _e706 = phi_1341_;
                                                local_12 = _e704;
                                                if (_e706.member < _e706.member_1) {
                                                    phi_1342_ = type_8((_e706.member + 1u), _e706.member_1);
                                                    phi_1364_ = type_8(1u, _e706.member);
                                                } else {
                                                    phi_1342_ = _e706;
                                                    phi_1364_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e719 = phi_1342_;
                                                let _e721 = phi_1364_;
                                                let _e725 = (bitcast<i32>(_e721.member) != 0i);
                                                if _e725 {
                                                    let _e731 = type_43(_e704.member, _e704.member_1, (_e704.member_2 + 1u));
                                                    let _e736 = (_e692.member.member_1.x - _e692.member.member.x);
                                                    let _e739 = (_e692.member.member_1.y - _e692.member.member.y);
                                                    let _e742 = (_e692.member.member_1.z - _e692.member.member.z);
                                                    let _e744 = select(_e739, _e736, (_e736 > _e739));
                                                    let _e746 = select(_e742, _e744, (_e744 > _e742));
                                                    let _e748 = (_e746 < (1024f * _e155));
                                                    if _e748 {
                                                        phi_1408_ = 0u;
                                                    } else {
                                                        phi_1408_ = select(2u, 1u, (_e746 < (2097152f * _e155)));
                                                    }
                                                    let _e753 = phi_1408_;
                                                    switch bitcast<i32>(_e753) {
                                                        case 0: {
                                                            phi_1414_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1414_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1414_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1414_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e756 = phi_1414_;
                                                    switch bitcast<i32>(_e753) {
                                                        case 0: {
                                                            phi_1424_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1424_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1424_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1424_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e763 = phi_1424_;
                                                    let _e765 = ((_e697 + (_e721.member_1 * ((3u * _e756) + 1u))) + (3u * _e763));
                                                    let _e766 = (_e765 < _e103);
                                                    if _e766 {
                                                        if _e766 {
                                                        } else {
                                                            phi_4880_ = true;
                                                            break;
                                                        }
                                                        let _e768 = global_7.member[_e765];
                                                        phi_1440_ = _e768;
                                                    } else {
                                                        phi_1440_ = 4294967295u;
                                                    }
                                                    let _e770 = phi_1440_;
                                                    if _e748 {
                                                        phi_1473_ = 0u;
                                                    } else {
                                                        phi_1473_ = select(2u, 1u, (_e746 < (2097152f * _e155)));
                                                    }
                                                    let _e775 = phi_1473_;
                                                    switch bitcast<i32>(_e775) {
                                                        case 0: {
                                                            phi_1479_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1479_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1479_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1479_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e778 = phi_1479_;
                                                    let _e782 = (_e697 + (_e721.member_1 * ((3u * _e778) + 1u)));
                                                    switch bitcast<i32>(_e775) {
                                                        case 0: {
                                                            let _e1057 = (_e782 < _e103);
                                                            if _e1057 {
                                                                if _e1057 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e1059 = global_7.member[_e782];
                                                                phi_1506_ = _e1059;
                                                            } else {
                                                                phi_1506_ = 0u;
                                                            }
                                                            let _e1061 = phi_1506_;
                                                            let _e1063 = ((10u * _e281) & 31u);
                                                            let _e1073 = ((10u * _e280) & 31u);
                                                            let _e1083 = ((10u * _e282) & 31u);
                                                            let _e1093 = (_e782 + 1u);
                                                            let _e1094 = (_e1093 < _e103);
                                                            if _e1094 {
                                                                if _e1094 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e1096 = global_7.member[_e1093];
                                                                phi_1555_ = _e1096;
                                                            } else {
                                                                phi_1555_ = 0u;
                                                            }
                                                            let _e1098 = phi_1555_;
                                                            let _e1124 = (_e782 + 2u);
                                                            let _e1125 = (_e1124 < _e103);
                                                            if _e1125 {
                                                                if _e1125 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e1127 = global_7.member[_e1124];
                                                                phi_1604_ = _e1127;
                                                            } else {
                                                                phi_1604_ = 0u;
                                                            }
                                                            let _e1129 = phi_1604_;
                                                            phi_2105_ = array<array<f32, 3>, 3>(array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | ((_e1061 >> bitcast<u32>(_e1063)) & 1023u))) - 8388608f) * _e155)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | ((_e1061 >> bitcast<u32>(_e1073)) & 1023u))) - 8388608f) * _e155)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | ((_e1061 >> bitcast<u32>(_e1083)) & 1023u))) - 8388608f) * _e155))), array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | ((_e1098 >> bitcast<u32>(_e1063)) & 1023u))) - 8388608f) * _e155)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | ((_e1098 >> bitcast<u32>(_e1073)) & 1023u))) - 8388608f) * _e155)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | ((_e1098 >> bitcast<u32>(_e1083)) & 1023u))) - 8388608f) * _e155))), array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | ((_e1129 >> bitcast<u32>(_e1063)) & 1023u))) - 8388608f) * _e155)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | ((_e1129 >> bitcast<u32>(_e1073)) & 1023u))) - 8388608f) * _e155)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | ((_e1129 >> bitcast<u32>(_e1083)) & 1023u))) - 8388608f) * _e155))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e871 = (_e782 < _e103);
                                                            if _e871 {
                                                                if _e871 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e873 = global_7.member[_e782];
                                                                phi_1653_ = _e873;
                                                            } else {
                                                                phi_1653_ = 0u;
                                                            }
                                                            let _e875 = phi_1653_;
                                                            let _e876 = (_e782 + 1u);
                                                            let _e877 = (_e876 < _e103);
                                                            if _e877 {
                                                                if _e877 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e879 = global_7.member[_e876];
                                                                phi_1668_ = _e879;
                                                            } else {
                                                                phi_1668_ = 0u;
                                                            }
                                                            let _e881 = phi_1668_;
                                                            let _e882 = (_e281 == 1u);
                                                            if _e882 {
                                                                phi_1678_ = ((_e875 >> bitcast<u32>(21i)) | (_e881 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1678_ = (_e881 >> bitcast<u32>(10i));
                                                            }
                                                            let _e891 = phi_1678_;
                                                            let _e899 = (_e280 == 1u);
                                                            if _e899 {
                                                                phi_1699_ = ((_e875 >> bitcast<u32>(21i)) | (_e881 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1699_ = (_e881 >> bitcast<u32>(10i));
                                                            }
                                                            let _e908 = phi_1699_;
                                                            let _e916 = (_e282 == 1u);
                                                            if _e916 {
                                                                phi_1720_ = ((_e875 >> bitcast<u32>(21i)) | (_e881 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1720_ = (_e881 >> bitcast<u32>(10i));
                                                            }
                                                            let _e925 = phi_1720_;
                                                            let _e934 = (_e782 + 2u);
                                                            let _e935 = (_e934 < _e103);
                                                            if _e935 {
                                                                if _e935 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e937 = global_7.member[_e934];
                                                                phi_1750_ = _e937;
                                                            } else {
                                                                phi_1750_ = 0u;
                                                            }
                                                            let _e939 = phi_1750_;
                                                            let _e940 = (_e782 + 3u);
                                                            let _e941 = (_e940 < _e103);
                                                            if _e941 {
                                                                if _e941 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e943 = global_7.member[_e940];
                                                                phi_1765_ = _e943;
                                                            } else {
                                                                phi_1765_ = 0u;
                                                            }
                                                            let _e945 = phi_1765_;
                                                            if _e882 {
                                                                phi_1775_ = ((_e939 >> bitcast<u32>(21i)) | (_e945 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1775_ = (_e945 >> bitcast<u32>(10i));
                                                            }
                                                            let _e954 = phi_1775_;
                                                            if _e899 {
                                                                phi_1796_ = ((_e939 >> bitcast<u32>(21i)) | (_e945 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1796_ = (_e945 >> bitcast<u32>(10i));
                                                            }
                                                            let _e970 = phi_1796_;
                                                            if _e916 {
                                                                phi_1817_ = ((_e939 >> bitcast<u32>(21i)) | (_e945 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1817_ = (_e945 >> bitcast<u32>(10i));
                                                            }
                                                            let _e986 = phi_1817_;
                                                            let _e995 = (_e782 + 4u);
                                                            let _e996 = (_e995 < _e103);
                                                            if _e996 {
                                                                if _e996 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e998 = global_7.member[_e995];
                                                                phi_1847_ = _e998;
                                                            } else {
                                                                phi_1847_ = 0u;
                                                            }
                                                            let _e1000 = phi_1847_;
                                                            let _e1001 = (_e782 + 5u);
                                                            let _e1002 = (_e1001 < _e103);
                                                            if _e1002 {
                                                                if _e1002 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e1004 = global_7.member[_e1001];
                                                                phi_1862_ = _e1004;
                                                            } else {
                                                                phi_1862_ = 0u;
                                                            }
                                                            let _e1006 = phi_1862_;
                                                            if _e882 {
                                                                phi_1872_ = ((_e1000 >> bitcast<u32>(21i)) | (_e1006 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1872_ = (_e1006 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1015 = phi_1872_;
                                                            if _e899 {
                                                                phi_1893_ = ((_e1000 >> bitcast<u32>(21i)) | (_e1006 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1893_ = (_e1006 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1031 = phi_1893_;
                                                            if _e916 {
                                                                phi_1914_ = ((_e1000 >> bitcast<u32>(21i)) | (_e1006 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1914_ = (_e1006 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1047 = phi_1914_;
                                                            phi_2105_ = array<array<f32, 3>, 3>(array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | (select(_e891, _e875, _e305) & 2097151u))) - 8388608f) * _e155)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | (select(_e908, _e875, _e370) & 2097151u))) - 8388608f) * _e155)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | (select(_e925, _e875, _e434) & 2097151u))) - 8388608f) * _e155))), array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | (select(_e954, _e939, _e305) & 2097151u))) - 8388608f) * _e155)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | (select(_e970, _e939, _e370) & 2097151u))) - 8388608f) * _e155)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | (select(_e986, _e939, _e434) & 2097151u))) - 8388608f) * _e155))), array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1015, _e1000, _e305) & 2097151u))) - 8388608f) * _e155)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1031, _e1000, _e370) & 2097151u))) - 8388608f) * _e155)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1047, _e1000, _e434) & 2097151u))) - 8388608f) * _e155))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e784 = (_e782 + _e281);
                                                            let _e785 = (_e784 < _e103);
                                                            if _e785 {
                                                                if _e785 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e787 = global_7.member[_e784];
                                                                phi_1945_ = _e787;
                                                            } else {
                                                                phi_1945_ = 0u;
                                                            }
                                                            let _e789 = phi_1945_;
                                                            let _e793 = (_e782 + _e280);
                                                            let _e794 = (_e793 < _e103);
                                                            if _e794 {
                                                                if _e794 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e796 = global_7.member[_e793];
                                                                phi_1963_ = _e796;
                                                            } else {
                                                                phi_1963_ = 0u;
                                                            }
                                                            let _e798 = phi_1963_;
                                                            let _e802 = (_e782 + _e282);
                                                            let _e803 = (_e802 < _e103);
                                                            if _e803 {
                                                                if _e803 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e805 = global_7.member[_e802];
                                                                phi_1981_ = _e805;
                                                            } else {
                                                                phi_1981_ = 0u;
                                                            }
                                                            let _e807 = phi_1981_;
                                                            let _e812 = (_e782 + 3u);
                                                            let _e813 = (_e812 + _e281);
                                                            let _e814 = (_e813 < _e103);
                                                            if _e814 {
                                                                if _e814 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e816 = global_7.member[_e813];
                                                                phi_2004_ = _e816;
                                                            } else {
                                                                phi_2004_ = 0u;
                                                            }
                                                            let _e818 = phi_2004_;
                                                            let _e822 = (_e812 + _e280);
                                                            let _e823 = (_e822 < _e103);
                                                            if _e823 {
                                                                if _e823 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e825 = global_7.member[_e822];
                                                                phi_2022_ = _e825;
                                                            } else {
                                                                phi_2022_ = 0u;
                                                            }
                                                            let _e827 = phi_2022_;
                                                            let _e831 = (_e812 + _e282);
                                                            let _e832 = (_e831 < _e103);
                                                            if _e832 {
                                                                if _e832 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e834 = global_7.member[_e831];
                                                                phi_2040_ = _e834;
                                                            } else {
                                                                phi_2040_ = 0u;
                                                            }
                                                            let _e836 = phi_2040_;
                                                            let _e841 = (_e782 + 6u);
                                                            let _e842 = (_e841 + _e281);
                                                            let _e843 = (_e842 < _e103);
                                                            if _e843 {
                                                                if _e843 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e845 = global_7.member[_e842];
                                                                phi_2063_ = _e845;
                                                            } else {
                                                                phi_2063_ = 0u;
                                                            }
                                                            let _e847 = phi_2063_;
                                                            let _e851 = (_e841 + _e280);
                                                            let _e852 = (_e851 < _e103);
                                                            if _e852 {
                                                                if _e852 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e854 = global_7.member[_e851];
                                                                phi_2081_ = _e854;
                                                            } else {
                                                                phi_2081_ = 0u;
                                                            }
                                                            let _e856 = phi_2081_;
                                                            let _e860 = (_e841 + _e282);
                                                            let _e861 = (_e860 < _e103);
                                                            if _e861 {
                                                                if _e861 {
                                                                } else {
                                                                    phi_4880_ = true;
                                                                    break;
                                                                }
                                                                let _e863 = global_7.member[_e860];
                                                                phi_2099_ = _e863;
                                                            } else {
                                                                phi_2099_ = 0u;
                                                            }
                                                            let _e865 = phi_2099_;
                                                            phi_2105_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e789)) * _e155), (f32(bitcast<i32>(_e798)) * _e155), (f32(bitcast<i32>(_e807)) * _e155)), array<f32, 3>((f32(bitcast<i32>(_e818)) * _e155), (f32(bitcast<i32>(_e827)) * _e155), (f32(bitcast<i32>(_e836)) * _e155)), array<f32, 3>((f32(bitcast<i32>(_e847)) * _e155), (f32(bitcast<i32>(_e856)) * _e155), (f32(bitcast<i32>(_e865)) * _e155)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2105_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1157 = phi_2105_;
                                                    let _e1174 = (_e1157[0][2] - _e457);
                                                    let _e1177 = (((_e1157[0][0] - _e328) * _e493) - (_e1174 * _e365));
                                                    let _e1180 = (((_e1157[0][1] - _e393) * _e493) - (_e1174 * _e429));
                                                    let _e1183 = (_e1157[1][2] - _e457);
                                                    let _e1186 = (((_e1157[1][0] - _e328) * _e493) - (_e1183 * _e365));
                                                    let _e1189 = (((_e1157[1][1] - _e393) * _e493) - (_e1183 * _e429));
                                                    let _e1192 = (_e1157[2][2] - _e457);
                                                    let _e1195 = (((_e1157[2][0] - _e328) * _e493) - (_e1192 * _e365));
                                                    let _e1198 = (((_e1157[2][1] - _e393) * _e493) - (_e1192 * _e429));
                                                    let _e1199 = (_e1195 * _e1189);
                                                    let _e1200 = (_e1198 * _e1186);
                                                    let _e1201 = (_e1177 * _e1198);
                                                    let _e1202 = (_e1180 * _e1195);
                                                    let _e1203 = (_e1186 * _e1180);
                                                    let _e1204 = (_e1189 * _e1177);
                                                    let _e1209 = (((_e1199 >= _e1200) && (_e1201 >= _e1202)) && (_e1203 >= _e1204));
                                                    let _e1215 = (_e1209 || (((_e1199 <= _e1200) && (_e1201 <= _e1202)) && (_e1203 <= _e1204)));
                                                    if _e1215 {
                                                        let _e1217 = select(-1f, 1f, _e1209);
                                                        let _e1219 = ((_e1199 - _e1200) * _e1217);
                                                        let _e1221 = select(0f, _e1219, (_e1219 > 0f));
                                                        let _e1223 = ((_e1201 - _e1202) * _e1217);
                                                        let _e1225 = select(0f, _e1223, (_e1223 > 0f));
                                                        let _e1227 = ((_e1203 - _e1204) * _e1217);
                                                        let _e1229 = select(0f, _e1227, (_e1227 > 0f));
                                                        let _e1231 = ((_e1221 + _e1225) + _e1229);
                                                        let _e1233 = select(_e1157[1][0], _e1157[0][0], (_e1157[0][0] < _e1157[1][0]));
                                                        let _e1237 = select(_e1157[1][0], _e1157[0][0], (_e1157[0][0] > _e1157[1][0]));
                                                        let _e1241 = select(_e1157[1][1], _e1157[0][1], (_e1157[0][1] < _e1157[1][1]));
                                                        let _e1245 = select(_e1157[1][1], _e1157[0][1], (_e1157[0][1] > _e1157[1][1]));
                                                        let _e1249 = select(_e1157[1][2], _e1157[0][2], (_e1157[0][2] < _e1157[1][2]));
                                                        let _e1253 = select(_e1157[1][2], _e1157[0][2], (_e1157[0][2] > _e1157[1][2]));
                                                        let _e1258 = ((select(_e1157[2][0], _e1233, (_e1233 < _e1157[2][0])) - _e366) * _e369);
                                                        let _e1259 = ((select(_e1157[2][0], _e1237, (_e1237 > _e1157[2][0])) - _e367) * _e369);
                                                        let _e1262 = ((select(_e1157[2][1], _e1241, (_e1241 < _e1157[2][1])) - _e430) * _e433);
                                                        let _e1263 = ((select(_e1157[2][1], _e1245, (_e1245 > _e1157[2][1])) - _e431) * _e433);
                                                        let _e1266 = ((select(_e1157[2][2], _e1249, (_e1249 < _e1157[2][2])) - _e494) * _e497);
                                                        let _e1267 = ((select(_e1157[2][2], _e1253, (_e1253 > _e1157[2][2])) - _e495) * _e497);
                                                        let _e1269 = select(_e1267, _e1266, (_e1266 < _e1267));
                                                        let _e1271 = select(_e1267, _e1266, (_e1266 > _e1267));
                                                        let _e1273 = select(_e1259, _e1258, (_e1258 < _e1259));
                                                        let _e1275 = select(_e1263, _e1262, (_e1262 < _e1263));
                                                        let _e1277 = select(_e1275, _e1273, (_e1273 > _e1275));
                                                        let _e1279 = select(_e1269, _e1277, (_e1277 > _e1269));
                                                        let _e1281 = select(_e1259, _e1258, (_e1258 > _e1259));
                                                        let _e1283 = select(_e1263, _e1262, (_e1262 > _e1263));
                                                        let _e1285 = select(_e1283, _e1281, (_e1281 < _e1283));
                                                        let _e1287 = select(_e1271, _e1285, (_e1285 < _e1271));
                                                        let _e1288 = -(_e1269);
                                                        let _e1294 = select(_e599, _e1279, (_e1279 > _e599));
                                                        let _e1298 = select(_e1186, _e1177, (_e1177 < _e1186));
                                                        let _e1303 = select(_e1186, _e1177, (_e1177 > _e1186));
                                                        let _e1310 = select(_e1189, _e1180, (_e1180 < _e1189));
                                                        let _e1315 = select(_e1189, _e1180, (_e1180 > _e1189));
                                                        let _e1324 = (((((_e1215 && (_e1231 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1195, _e1298, (_e1298 < _e1195)) <= 0f) && (select(_e1195, _e1303, (_e1303 > _e1195)) >= 0f))) && ((select(_e1198, _e1310, (_e1310 < _e1198)) <= 0f) && (select(_e1198, _e1315, (_e1315 > _e1198)) >= 0f))) && (_e1294 <= (_e1287 + (select(_e1288, _e1271, (_e1271 > _e1288)) * 0.0000019073523f)))) && (_e1294 <= _e704.member.member_1));
                                                        if _e1324 {
                                                            let _e1329 = (_e1157[1][0] - _e1157[0][0]);
                                                            let _e1330 = (_e1157[1][1] - _e1157[0][1]);
                                                            let _e1331 = (_e1157[1][2] - _e1157[0][2]);
                                                            let _e1332 = vec3<f32>(_e1329, _e1330, _e1331);
                                                            let _e1333 = (_e1157[2][0] - _e1157[1][0]);
                                                            let _e1334 = (_e1157[2][1] - _e1157[1][1]);
                                                            let _e1335 = (_e1157[2][2] - _e1157[1][2]);
                                                            let _e1336 = vec3<f32>(_e1333, _e1334, _e1335);
                                                            let _e1337 = (_e1157[0][0] - _e1157[2][0]);
                                                            let _e1338 = (_e1157[0][1] - _e1157[2][1]);
                                                            let _e1339 = (_e1157[0][2] - _e1157[2][2]);
                                                            let _e1340 = vec3<f32>(_e1337, _e1338, _e1339);
                                                            let _e1341 = abs(_e1329);
                                                            let _e1342 = abs(_e1330);
                                                            if (_e1341 != _e1341) {
                                                                phi_4447_ = true;
                                                            } else {
                                                                phi_4447_ = (_e1342 >= _e1341);
                                                            }
                                                            let _e1346 = phi_4447_;
                                                            let _e1347 = select(_e1341, _e1342, _e1346);
                                                            let _e1348 = abs(_e1331);
                                                            if (_e1347 != _e1347) {
                                                                phi_4462_ = true;
                                                            } else {
                                                                phi_4462_ = (_e1348 >= _e1347);
                                                            }
                                                            let _e1352 = phi_4462_;
                                                            let _e1353 = select(_e1347, _e1348, _e1352);
                                                            let _e1354 = abs(_e1333);
                                                            let _e1355 = abs(_e1334);
                                                            if (_e1354 != _e1354) {
                                                                phi_4477_ = true;
                                                            } else {
                                                                phi_4477_ = (_e1355 >= _e1354);
                                                            }
                                                            let _e1359 = phi_4477_;
                                                            let _e1360 = select(_e1354, _e1355, _e1359);
                                                            let _e1361 = abs(_e1335);
                                                            if (_e1360 != _e1360) {
                                                                phi_4492_ = true;
                                                            } else {
                                                                phi_4492_ = (_e1361 >= _e1360);
                                                            }
                                                            let _e1365 = phi_4492_;
                                                            let _e1366 = select(_e1360, _e1361, _e1365);
                                                            let _e1367 = abs(_e1337);
                                                            let _e1368 = abs(_e1338);
                                                            if (_e1367 != _e1367) {
                                                                phi_4507_ = true;
                                                            } else {
                                                                phi_4507_ = (_e1368 >= _e1367);
                                                            }
                                                            let _e1372 = phi_4507_;
                                                            let _e1373 = select(_e1367, _e1368, _e1372);
                                                            let _e1374 = abs(_e1339);
                                                            if (_e1373 != _e1373) {
                                                                phi_4522_ = true;
                                                            } else {
                                                                phi_4522_ = (_e1374 >= _e1373);
                                                            }
                                                            let _e1378 = phi_4522_;
                                                            let _e1379 = select(_e1373, _e1374, _e1378);
                                                            let _e1381 = select(_e1366, _e1353, (_e1353 > _e1366));
                                                            let _e1383 = select(_e1379, _e1381, (_e1381 > _e1379));
                                                            if (_e1353 == _e1383) {
                                                                phi_2647_ = _e1189;
                                                                phi_2648_ = _e1186;
                                                                phi_2649_ = _e1180;
                                                                phi_2650_ = _e1177;
                                                                phi_2651_ = vec3<f32>(_e1157[0][0], _e1157[0][1], _e1157[0][2]);
                                                                phi_2652_ = _e1340;
                                                                phi_2653_ = _e1336;
                                                                phi_2654_ = _e1332;
                                                            } else {
                                                                let _e1385 = (_e1366 == _e1383);
                                                                let _e1390 = vec3(_e1385);
                                                                phi_2647_ = select(_e1180, _e1198, _e1385);
                                                                phi_2648_ = select(_e1177, _e1195, _e1385);
                                                                phi_2649_ = select(_e1198, _e1189, _e1385);
                                                                phi_2650_ = select(_e1195, _e1186, _e1385);
                                                                phi_2651_ = select(vec3<f32>(_e1157[2][0], _e1157[2][1], _e1157[2][2]), vec3<f32>(_e1157[1][0], _e1157[1][1], _e1157[1][2]), _e1390);
                                                                phi_2652_ = select(_e1336, _e1332, _e1390);
                                                                phi_2653_ = select(_e1332, _e1340, _e1390);
                                                                phi_2654_ = select(_e1340, _e1336, _e1390);
                                                            }
                                                            let _e1396 = phi_2647_;
                                                            let _e1398 = phi_2648_;
                                                            let _e1400 = phi_2649_;
                                                            let _e1402 = phi_2650_;
                                                            let _e1404 = phi_2651_;
                                                            let _e1406 = phi_2652_;
                                                            let _e1408 = phi_2653_;
                                                            let _e1410 = phi_2654_;
                                                            let _e1417 = ((_e1408.y * _e1406.z) - (_e1406.y * _e1408.z));
                                                            let _e1422 = ((_e1408.z * _e1406.x) - (_e1406.z * _e1408.x));
                                                            let _e1425 = ((_e1408.x * _e1406.y) - (_e1406.x * _e1408.y));
                                                            let _e1428 = ((_e1221 >= _e1225) && (_e1221 >= _e1229));
                                                            let _e1429 = (_e1225 >= _e1229);
                                                            let _e1443 = (((_e1417 * (select(select(_e1157[2][0], _e1157[1][0], _e1429), _e1157[0][0], _e1428) - _e328)) + (_e1422 * (select(select(_e1157[2][1], _e1157[1][1], _e1429), _e1157[0][1], _e1428) - _e393))) + (_e1425 * (select(select(_e1157[2][2], _e1157[1][2], _e1429), _e1157[0][2], _e1428) - _e457)));
                                                            let _e1448 = (((_e1417 * _e365) + (_e1422 * _e429)) + (_e1425 * _e493));
                                                            let _e1449 = (_e1398 - _e1402);
                                                            let _e1450 = (_e1396 - _e1400);
                                                            let _e1453 = ((_e1449 * _e1449) + (_e1450 * _e1450));
                                                            let _e1460 = (-(((_e1402 * _e1449) + (_e1400 * _e1450))) / select(0.000000000000000000000000000000000000011754944f, _e1453, (_e1453 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1462 = select(1f, _e1460, (_e1460 < 1f));
                                                            let _e1464 = select(0f, _e1462, (_e1462 > 0f));
                                                            let _e1473 = ((_e1404.x + (_e1410.x * _e1464)) - _e328);
                                                            let _e1476 = ((_e1404.y + (_e1410.y * _e1464)) - _e393);
                                                            let _e1479 = ((_e1404.z + (_e1410.z * _e1464)) - _e457);
                                                            let _e1482 = bitcast<f32>((bitcast<u32>(_e1473) & 2147483647u));
                                                            let _e1485 = bitcast<f32>((bitcast<u32>(_e1476) & 2147483647u));
                                                            let _e1487 = select(_e1485, _e1482, (_e1482 > _e1485));
                                                            let _e1490 = bitcast<f32>((bitcast<u32>(_e1479) & 2147483647u));
                                                            let _e1492 = select(_e1490, _e1487, (_e1487 > _e1490));
                                                            let _e1496 = abs(_e1417);
                                                            let _e1497 = abs(_e1422);
                                                            if (_e1496 != _e1496) {
                                                                phi_4537_ = true;
                                                            } else {
                                                                phi_4537_ = (_e1497 >= _e1496);
                                                            }
                                                            let _e1501 = phi_4537_;
                                                            let _e1502 = select(_e1496, _e1497, _e1501);
                                                            let _e1503 = abs(_e1425);
                                                            if (_e1502 != _e1502) {
                                                                phi_4552_ = true;
                                                            } else {
                                                                phi_4552_ = (_e1503 >= _e1502);
                                                            }
                                                            let _e1507 = phi_4552_;
                                                            let _e1523 = abs(_e1408.x);
                                                            let _e1524 = abs(_e1408.y);
                                                            if (_e1523 != _e1523) {
                                                                phi_4567_ = true;
                                                            } else {
                                                                phi_4567_ = (_e1524 >= _e1523);
                                                            }
                                                            let _e1528 = phi_4567_;
                                                            let _e1529 = select(_e1523, _e1524, _e1528);
                                                            let _e1530 = abs(_e1408.z);
                                                            if (_e1529 != _e1529) {
                                                                phi_4582_ = true;
                                                            } else {
                                                                phi_4582_ = (_e1530 >= _e1529);
                                                            }
                                                            let _e1534 = phi_4582_;
                                                            let _e1537 = abs(_e1406.x);
                                                            let _e1538 = abs(_e1406.y);
                                                            if (_e1537 != _e1537) {
                                                                phi_4597_ = true;
                                                            } else {
                                                                phi_4597_ = (_e1538 >= _e1537);
                                                            }
                                                            let _e1542 = phi_4597_;
                                                            let _e1543 = select(_e1537, _e1538, _e1542);
                                                            let _e1544 = abs(_e1406.z);
                                                            if (_e1543 != _e1543) {
                                                                phi_4612_ = true;
                                                            } else {
                                                                phi_4612_ = (_e1544 >= _e1543);
                                                            }
                                                            let _e1548 = phi_4612_;
                                                            let _e1553 = ((bitcast<f32>((bitcast<u32>(((((_e1417 * _e1473) + (_e1422 * _e1476)) + (_e1425 * _e1479)) - _e1443)) & 2147483647u)) <= ((0.0000009536743f * select(_e1383, _e1492, (_e1492 > _e1383))) * select(_e1502, _e1503, _e1507))) && !((bitcast<f32>((bitcast<u32>(_e1448) & 2147483647u)) <= ((0.0000038146973f * select(_e1529, _e1530, _e1534)) * select(_e1543, _e1544, _e1548)))));
                                                            let _e1554 = (_e1443 / _e1448);
                                                            if (_e1324 && !(_e1553)) {
                                                                let _e1557 = (_e1479 / _e493);
                                                                let _e1565 = (((_e1417 * (_e1473 - (_e365 * _e1557))) + (_e1422 * (_e1476 - (_e429 * _e1557)))) / _e1448);
                                                                phi_2862_ = select(select(_e1557, (_e1557 + _e1565), (bitcast<f32>((bitcast<u32>(_e1565) & 2147483647u)) <= _e1383)), _e1554, _e1553);
                                                            } else {
                                                                phi_2862_ = _e1554;
                                                            }
                                                            let _e1574 = phi_2862_;
                                                            let _e1576 = select(_e1287, _e1574, (_e1574 < _e1287));
                                                            let _e1578 = select(_e1279, _e1576, (_e1576 > _e1279));
                                                            let _e1579 = (1f / _e1231);
                                                            phi_2882_ = type_42(_e1578, (_e1225 * _e1579), (_e1229 * _e1579), ((_e1324 && (_e1578 >= _e599)) && (_e1578 <= _e704.member.member_1)));
                                                            phi_2883_ = type_42();
                                                        } else {
                                                            phi_2882_ = type_42();
                                                            phi_2883_ = type_42(0f, 0f, 0f, _e1324);
                                                        }
                                                        let _e1588 = phi_2882_;
                                                        let _e1590 = phi_2883_;
                                                        phi_2886_ = _e1588;
                                                        phi_2887_ = _e1590;
                                                        phi_2888_ = select(true, false, _e1324);
                                                    } else {
                                                        phi_2886_ = type_42();
                                                        phi_2887_ = type_42(0f, 0f, 0f, _e1215);
                                                        phi_2888_ = true;
                                                    }
                                                    let _e1593 = phi_2886_;
                                                    let _e1595 = phi_2887_;
                                                    let _e1597 = phi_2888_;
                                                    if _e1597 {
                                                        phi_2892_ = _e1595;
                                                    } else {
                                                        phi_2892_ = _e1593;
                                                    }
                                                    let _e1599 = phi_2892_;
                                                    if _e1599.member_3 {
                                                        phi_2901_ = type_22(_e1599.member, _e1599.member_1, _e1599.member_2, _e770);
                                                    } else {
                                                        phi_2901_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1606 = phi_2901_;
                                                    if (_e1606.member_3 != 4294967295u) {
                                                        if (_e770 != _e605) {
                                                            if (_e1606.member < _e704.member.member.member) {
                                                                phi_2927_ = true;
                                                            } else {
                                                                if (_e1606.member == _e704.member.member.member) {
                                                                    phi_2926_ = (_e1606.member_3 < _e704.member.member.member_3);
                                                                } else {
                                                                    phi_2926_ = false;
                                                                }
                                                                let _e1621 = phi_2926_;
                                                                phi_2927_ = _e1621;
                                                            }
                                                            let _e1623 = phi_2927_;
                                                            if _e1623 {
                                                                phi_2934_ = type_43(type_39(_e1606, _e1606.member), _e731.member_1, _e731.member_2);
                                                            } else {
                                                                phi_2934_ = _e731;
                                                            }
                                                            let _e1630 = phi_2934_;
                                                            phi_2935_ = _e1630;
                                                        } else {
                                                            phi_2935_ = _e731;
                                                        }
                                                        let _e1632 = phi_2935_;
                                                        phi_2936_ = _e1632;
                                                    } else {
                                                        phi_2936_ = _e731;
                                                    }
                                                    let _e1634 = phi_2936_;
                                                    phi_1339_ = _e1634;
                                                } else {
                                                    phi_1339_ = type_43();
                                                }
                                                let _e1636 = phi_1339_;
                                                continue;
                                                continuing {
                                                    phi_1338_ = _e1636;
                                                    phi_1341_ = _e719;
                                                    phi_4880_ = _e646;
                                                    break if !(_e725);
                                                }
                                            }
                                            let _e1639 = phi_4880_;
                                            phi_5092_ = _e1639;
                                            if _e1639 {
                                                break;
                                            }
                                            phi_5183_ = _e1639;
                                            let _e2448 = local_12;
                                            phi_2937_ = _e2448;
                                        } else {
                                            phi_5183_ = _e646;
                                            phi_2937_ = _e648;
                                        }
                                        let _e1641 = phi_5183_;
                                        let _e1643 = phi_2937_;
                                        if _e696 {
                                            phi_4206_ = type_43();
                                            phi_4207_ = bool();
                                            phi_4208_ = u32();
                                            phi_4209_ = type_50();
                                        } else {
                                            if (_e692.member_1 >= _e100) {
                                                phi_3738_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e692.member_1 < _e100) {
                                                } else {
                                                    phi_5092_ = true;
                                                    break;
                                                }
                                                let _e1647 = ((1u + _e281) % 4u);
                                                if (_e1647 < 4u) {
                                                } else {
                                                    phi_5092_ = true;
                                                    break;
                                                }
                                                let _e1652 = global_3.member[_e692.member_1][_e1647];
                                                let _e1654 = (_e1652 >> bitcast<u32>(11u));
                                                let _e1656 = ((1u + _e280) % 4u);
                                                if (_e1656 < 4u) {
                                                } else {
                                                    phi_5092_ = true;
                                                    break;
                                                }
                                                let _e1661 = global_3.member[_e692.member_1][_e1656];
                                                let _e1663 = (_e1661 >> bitcast<u32>(11u));
                                                let _e1665 = ((1u + _e282) % 4u);
                                                if (_e1665 < 4u) {
                                                } else {
                                                    phi_5092_ = true;
                                                    break;
                                                }
                                                let _e1670 = global_3.member[_e692.member_1][_e1665];
                                                let _e1672 = (_e1670 >> bitcast<u32>(11u));
                                                let _e1695 = (bitcast<f32>((bitcast<u32>((_e692.member.member_1.x - _e692.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e1696 = (bitcast<f32>((bitcast<u32>((_e692.member.member_1.y - _e692.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e1697 = (bitcast<f32>((bitcast<u32>((_e692.member.member_1.z - _e692.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e1699 = select(_e155, _e1695, (_e1695 > _e155));
                                                let _e1701 = select(_e155, _e1696, (_e1696 > _e155));
                                                let _e1703 = select(_e155, _e1697, (_e1697 > _e155));
                                                let _e1734 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1652 & 1023u))) - 8388608f) * _e1699));
                                                let _e1739 = (bitcast<i32>((_e1652 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1742 = bitcast<f32>((_e1734 & bitcast<u32>(_e1739)));
                                                let _e1743 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1661 & 1023u))) - 8388608f) * _e1701));
                                                let _e1748 = (bitcast<i32>((_e1661 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1751 = bitcast<f32>((_e1743 & bitcast<u32>(_e1748)));
                                                let _e1752 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1670 & 1023u))) - 8388608f) * _e1703));
                                                let _e1757 = (bitcast<i32>((_e1670 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1760 = bitcast<f32>((_e1752 & bitcast<u32>(_e1757)));
                                                let _e1764 = bitcast<f32>((_e1734 & bitcast<u32>(~(_e1739))));
                                                let _e1768 = bitcast<f32>((_e1743 & bitcast<u32>(~(_e1748))));
                                                let _e1772 = bitcast<f32>((_e1752 & bitcast<u32>(~(_e1757))));
                                                let _e1773 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1654 & 1023u))) - 8388608f) * _e1699));
                                                let _e1778 = (bitcast<i32>((_e1654 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1781 = bitcast<f32>((_e1773 & bitcast<u32>(_e1778)));
                                                let _e1782 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1663 & 1023u))) - 8388608f) * _e1701));
                                                let _e1787 = (bitcast<i32>((_e1663 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1790 = bitcast<f32>((_e1782 & bitcast<u32>(_e1787)));
                                                let _e1791 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1672 & 1023u))) - 8388608f) * _e1703));
                                                let _e1796 = (bitcast<i32>((_e1672 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1799 = bitcast<f32>((_e1791 & bitcast<u32>(_e1796)));
                                                let _e1803 = bitcast<f32>((_e1773 & bitcast<u32>(~(_e1778))));
                                                let _e1807 = bitcast<f32>((_e1782 & bitcast<u32>(~(_e1787))));
                                                let _e1811 = bitcast<f32>((_e1791 & bitcast<u32>(~(_e1796))));
                                                let _e1812 = (_e692.member.member.x + _e1742);
                                                let _e1813 = (_e692.member.member.y + _e1751);
                                                let _e1814 = (_e692.member.member.z + _e1760);
                                                let _e1817 = (_e692.member.member_1.x - _e1781);
                                                let _e1818 = (_e692.member.member_1.y - _e1790);
                                                let _e1819 = (_e692.member.member_1.z - _e1799);
                                                let _e1838 = (_e1817 - _e1812);
                                                let _e1839 = (_e1818 - _e1813);
                                                let _e1840 = (_e1819 - _e1814);
                                                let _e1842 = select(_e1839, _e1838, (_e1838 > _e1839));
                                                let _e1844 = select(_e1840, _e1842, (_e1842 > _e1840));
                                                if (_e1844 < (1024f * _e155)) {
                                                    phi_3439_ = 0u;
                                                } else {
                                                    phi_3439_ = select(2u, 1u, (_e1844 < (2097152f * _e155)));
                                                }
                                                let _e1851 = phi_3439_;
                                                switch bitcast<i32>(_e1851) {
                                                    case 0: {
                                                        phi_3445_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3445_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3445_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3445_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1854 = phi_3445_;
                                                let _e1860 = global_3.member[_e692.member_1][0u];
                                                let _e1864 = global_3.member[_e692.member_1][1u];
                                                let _e1868 = global_3.member[_e692.member_1][2u];
                                                let _e1872 = global_3.member[_e692.member_1][3u];
                                                let _e1884 = (((_e1864 >> bitcast<u32>(22i)) | ((_e1868 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1872 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1885 = (_e1860 & 268435455u);
                                                let _e1886 = (_e1884 & 268435455u);
                                                let _e1889 = ((_e1860 >> bitcast<u32>(28u)) & 7u);
                                                let _e1897 = ((_e1860 >> bitcast<u32>(31i)) | (((_e1884 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1898 = (_e1889 != 0u);
                                                if (_e1889 == 0u) {
                                                    phi_3700_ = _e1885;
                                                } else {
                                                    if (_e1889 == 7u) {
                                                        phi_3699_ = 2147483648u;
                                                    } else {
                                                        phi_3699_ = ((2147483648u | (_e1889 << bitcast<u32>(28u))) | (_e1886 & 268435455u));
                                                    }
                                                    let _e1907 = phi_3699_;
                                                    phi_3700_ = _e1907;
                                                }
                                                let _e1909 = phi_3700_;
                                                if _e1898 {
                                                    let _e1910 = (_e1889 != 7u);
                                                    if _e1910 {
                                                        phi_3710_ = (_e1886 + (_e1889 * ((3u * _e1854) + 1u)));
                                                    } else {
                                                        phi_3710_ = u32();
                                                    }
                                                    let _e1914 = phi_3710_;
                                                    phi_3712_ = _e1914;
                                                    phi_3713_ = select(true, false, _e1910);
                                                } else {
                                                    phi_3712_ = u32();
                                                    phi_3713_ = true;
                                                }
                                                let _e1917 = phi_3712_;
                                                let _e1919 = phi_3713_;
                                                if (_e1897 == 0u) {
                                                    phi_3734_ = (_e1885 + select(0u, 1u, !(_e1898)));
                                                } else {
                                                    if (_e1897 == 7u) {
                                                        phi_3733_ = 2147483648u;
                                                    } else {
                                                        phi_3733_ = ((2147483648u | (_e1897 << bitcast<u32>(28u))) | (select(_e1917, _e1886, _e1919) & 268435455u));
                                                    }
                                                    let _e1932 = phi_3733_;
                                                    phi_3734_ = _e1932;
                                                }
                                                let _e1934 = phi_3734_;
                                                phi_3738_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e1812, (_e692.member.member.x + _e1764), _e1817, (_e692.member.member_1.x - _e1803)), vec4<f32>(_e1813, (_e692.member.member.y + _e1768), _e1818, (_e692.member.member_1.y - _e1807)), vec4<f32>(_e1814, (_e692.member.member.z + _e1772), _e1819, (_e692.member.member_1.z - _e1811))), type_50(type_34((_e692.member.member + vec4<f32>(_e1742, _e1751, _e1760, 0f)), (_e692.member.member_1 - vec4<f32>(_e1781, _e1790, _e1799, 0f))), _e1909), type_50(type_34((_e692.member.member + vec4<f32>(_e1764, _e1768, _e1772, 0f)), (_e692.member.member_1 - vec4<f32>(_e1803, _e1807, _e1811, 0f))), _e1934));
                                            }
                                            let _e1939 = phi_3738_;
                                            let _e1958 = ((_e1939.member[0].x - _e366) * _e369);
                                            let _e1959 = ((_e1939.member[0].y - _e366) * _e369);
                                            let _e1960 = ((_e1939.member[0].z - _e367) * _e369);
                                            let _e1961 = ((_e1939.member[0].w - _e367) * _e369);
                                            let _e1971 = ((_e1939.member[1].x - _e430) * _e433);
                                            let _e1972 = ((_e1939.member[1].y - _e430) * _e433);
                                            let _e1973 = ((_e1939.member[1].z - _e431) * _e433);
                                            let _e1974 = ((_e1939.member[1].w - _e431) * _e433);
                                            let _e1984 = ((_e1939.member[2].x - _e494) * _e497);
                                            let _e1985 = ((_e1939.member[2].y - _e494) * _e497);
                                            let _e1986 = ((_e1939.member[2].z - _e495) * _e497);
                                            let _e1987 = ((_e1939.member[2].w - _e495) * _e497);
                                            let _e1989 = select(_e1986, _e1984, (_e1984 < _e1986));
                                            let _e1991 = select(_e1987, _e1985, (_e1985 < _e1987));
                                            let _e1993 = select(_e1986, _e1984, (_e1984 > _e1986));
                                            let _e1995 = select(_e1987, _e1985, (_e1985 > _e1987));
                                            let _e1997 = select(_e1960, _e1958, (_e1958 < _e1960));
                                            let _e1999 = select(_e1961, _e1959, (_e1959 < _e1961));
                                            let _e2001 = select(_e1973, _e1971, (_e1971 < _e1973));
                                            let _e2003 = select(_e1974, _e1972, (_e1972 < _e1974));
                                            let _e2005 = select(_e2001, _e1997, (_e1997 > _e2001));
                                            let _e2007 = select(_e2003, _e1999, (_e1999 > _e2003));
                                            let _e2009 = select(_e1989, _e2005, (_e2005 > _e1989));
                                            let _e2011 = select(_e1991, _e2007, (_e2007 > _e1991));
                                            let _e2013 = select(_e1960, _e1958, (_e1958 > _e1960));
                                            let _e2015 = select(_e1961, _e1959, (_e1959 > _e1961));
                                            let _e2017 = select(_e1973, _e1971, (_e1971 > _e1973));
                                            let _e2019 = select(_e1974, _e1972, (_e1972 > _e1974));
                                            let _e2021 = select(_e2017, _e2013, (_e2013 < _e2017));
                                            let _e2023 = select(_e2019, _e2015, (_e2015 < _e2019));
                                            let _e2028 = -(_e1989);
                                            let _e2029 = -(_e1991);
                                            let _e2036 = (select(_e1993, _e2021, (_e2021 < _e1993)) + (select(_e2028, _e1993, (_e1993 > _e2028)) * 0.0000019073523f));
                                            let _e2037 = (select(_e1995, _e2023, (_e2023 < _e1995)) + (select(_e2029, _e1995, (_e1995 > _e2029)) * 0.0000019073523f));
                                            let _e2039 = select(_e599, _e2009, (_e2009 > _e599));
                                            let _e2041 = select(_e599, _e2011, (_e2011 > _e599));
                                            let _e2046 = (_e2039 <= select(_e1643.member.member_1, _e2036, (_e2036 < _e1643.member.member_1)));
                                            let _e2047 = (_e2041 <= select(_e1643.member.member_1, _e2037, (_e2037 < _e1643.member.member_1)));
                                            let _e2048 = (_e2039 <= _e2041);
                                            if _e2046 {
                                                if _e2047 {
                                                    if _e2048 {
                                                        phi_4103_ = _e1939.member_2;
                                                    } else {
                                                        phi_4103_ = _e1939.member_1;
                                                    }
                                                    let _e2052 = phi_4103_;
                                                    let _e2073 = (_e690 % 128u);
                                                    let _e2074 = (_e2073 < 128u);
                                                    if _e2074 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_8[_e2073] = _e2052.member_1;
                                                    if _e2074 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_7[_e2073] = _e2052.member.member.x;
                                                    if _e2074 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_6[_e2073] = _e2052.member.member.y;
                                                    if _e2074 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_5[_e2073] = _e2052.member.member.z;
                                                    if _e2074 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_4[_e2073] = _e2052.member.member_1.x;
                                                    if _e2074 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_3[_e2073] = _e2052.member.member_1.y;
                                                    if _e2074 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_2[_e2073] = _e2052.member.member_1.z;
                                                    if _e2074 {
                                                    } else {
                                                        phi_5092_ = true;
                                                        break;
                                                    }
                                                    local_9[_e2073] = select(_e2039, _e2041, _e2048);
                                                    if _e2048 {
                                                        phi_4179_ = _e1939.member_1;
                                                    } else {
                                                        phi_4179_ = _e1939.member_2;
                                                    }
                                                    let _e2087 = phi_4179_;
                                                    phi_4180_ = (_e690 + 1u);
                                                    phi_4181_ = _e2087;
                                                } else {
                                                    phi_4180_ = u32();
                                                    phi_4181_ = type_50();
                                                }
                                                let _e2089 = phi_4180_;
                                                let _e2091 = phi_4181_;
                                                phi_4183_ = _e2089;
                                                phi_4184_ = _e2091;
                                                phi_4185_ = select(true, false, _e2047);
                                            } else {
                                                phi_4183_ = u32();
                                                phi_4184_ = type_50();
                                                phi_4185_ = true;
                                            }
                                            let _e2094 = phi_4183_;
                                            let _e2096 = phi_4184_;
                                            let _e2098 = phi_4185_;
                                            if _e2098 {
                                                if _e2046 {
                                                    phi_4194_ = _e1939.member_1;
                                                } else {
                                                    phi_4194_ = _e1939.member_2;
                                                }
                                                let _e2102 = phi_4194_;
                                                phi_4199_ = select(_e2047, true, _e2046);
                                                phi_4201_ = _e2102;
                                            } else {
                                                phi_4199_ = _e688;
                                                phi_4201_ = _e2096;
                                            }
                                            let _e2105 = phi_4199_;
                                            let _e2107 = phi_4201_;
                                            phi_4206_ = type_43(_e1643.member, (_e1643.member_1 + 1u), _e1643.member_2);
                                            phi_4207_ = _e2105;
                                            phi_4208_ = select(_e2094, _e690, _e2098);
                                            phi_4209_ = _e2107;
                                        }
                                        let _e2110 = phi_4206_;
                                        let _e2112 = phi_4207_;
                                        let _e2114 = phi_4208_;
                                        let _e2116 = phi_4209_;
                                        if _e696 {
                                            phi_4217_ = _e1643;
                                            phi_4220_ = _e692;
                                        } else {
                                            phi_4217_ = _e2110;
                                            phi_4220_ = _e2116;
                                        }
                                        let _e2118 = phi_4217_;
                                        let _e2120 = phi_4220_;
                                        phi_5095_ = _e1641;
                                        phi_4221_ = _e2118;
                                        phi_4222_ = (_e650 - 1u);
                                        phi_4223_ = select(_e2112, false, _e696);
                                        phi_4224_ = select(_e2114, _e690, _e696);
                                        phi_4225_ = _e2120;
                                    } else {
                                        phi_5095_ = _e646;
                                        phi_4221_ = _e648;
                                        phi_4222_ = _e650;
                                        phi_4223_ = _e688;
                                        phi_4224_ = _e690;
                                        phi_4225_ = _e692;
                                    }
                                    let _e2124 = phi_5095_;
                                    let _e2126 = phi_4221_;
                                    let _e2128 = phi_4222_;
                                    let _e2130 = phi_4223_;
                                    let _e2132 = phi_4224_;
                                    let _e2134 = phi_4225_;
                                    phi_5094_ = _e2124;
                                    phi_4226_ = _e2126;
                                    phi_4227_ = _e2128;
                                    phi_4228_ = _e2130;
                                    phi_4229_ = _e2132;
                                    phi_4230_ = _e2134;
                                } else {
                                    phi_5094_ = _e646;
                                    phi_4226_ = type_43();
                                    phi_4227_ = u32();
                                    phi_4228_ = bool();
                                    phi_4229_ = u32();
                                    phi_4230_ = type_50();
                                }
                                let _e2136 = phi_5094_;
                                let _e2138 = phi_4226_;
                                let _e2140 = phi_4227_;
                                let _e2142 = phi_4228_;
                                let _e2144 = phi_4229_;
                                let _e2146 = phi_4230_;
                                phi_5093_ = _e2136;
                                phi_1212_ = _e2138;
                                phi_1215_ = _e2140;
                                phi_1217_ = _e2142;
                                phi_1219_ = _e2144;
                                phi_1221_ = _e2146;
                                phi_4231_ = _e660;
                            } else {
                                phi_5093_ = _e646;
                                phi_1212_ = type_43();
                                phi_1215_ = u32();
                                phi_1217_ = bool();
                                phi_1219_ = u32();
                                phi_1221_ = type_50();
                                phi_4231_ = false;
                            }
                            let _e2148 = phi_5093_;
                            let _e2150 = phi_1212_;
                            let _e2152 = phi_1215_;
                            let _e2154 = phi_1217_;
                            let _e2156 = phi_1219_;
                            let _e2158 = phi_1221_;
                            let _e2160 = phi_4231_;
                            continue;
                            continuing {
                                phi_4886_ = _e2148;
                                phi_1211_ = _e2150;
                                phi_1214_ = _e2152;
                                phi_1216_ = _e2154;
                                phi_1218_ = _e2156;
                                phi_1220_ = _e2158;
                                phi_5092_ = _e2148;
                                break if !(_e2160);
                            }
                        }
                        let _e2163 = phi_5092_;
                        if _e2163 {
                            break;
                        }
                        let _e2165 = local_10;
                        if (_e2165.member.member.member_3 != 4294967295u) {
                            let _e2171 = bitcast<u32>(_e2165.member.member.member);
                            let _e2175 = (bitcast<i32>((_e2171 >> bitcast<u32>(23i))) & 255i);
                            let _e2176 = (_e2175 + _e283);
                            if (_e2175 == 255i) {
                                phi_4290_ = _e2165.member.member.member;
                            } else {
                                if (_e2175 > 0i) {
                                    if (_e2176 > 0i) {
                                        let _e2180 = (_e2176 < 255i);
                                        if _e2180 {
                                            phi_4269_ = bitcast<f32>((_e2171 + bitcast<u32>((_e283 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_4269_ = f32();
                                        }
                                        let _e2187 = phi_4269_;
                                        phi_4271_ = _e2187;
                                        phi_4272_ = select(true, false, _e2180);
                                    } else {
                                        phi_4271_ = f32();
                                        phi_4272_ = true;
                                    }
                                    let _e2190 = phi_4271_;
                                    let _e2192 = phi_4272_;
                                    phi_4273_ = _e2190;
                                    phi_4274_ = _e2192;
                                } else {
                                    phi_4273_ = f32();
                                    phi_4274_ = true;
                                }
                                let _e2194 = phi_4273_;
                                let _e2196 = phi_4274_;
                                if _e2196 {
                                    let _e2197 = (_e2171 & 2147483648u);
                                    let _e2204 = ((_e2171 & 8388607u) | (select(0u, 1u, ((_e2171 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e2208 = (_e2204 == 0u);
                                    if _e2208 {
                                        phi_4838_ = bitcast<f32>(_e2197);
                                    } else {
                                        let _e2213 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2204)), 32u, _e2208) - 8u);
                                        let _e2216 = (_e2204 << bitcast<u32>((_e2213 & 31u)));
                                        let _e2218 = ((_e2176 + select(0i, 1i, (_e2175 == 0i))) - bitcast<i32>(_e2213));
                                        if (_e2218 >= 255i) {
                                            phi_4828_ = bitcast<f32>((_e2197 | 2139095040u));
                                            phi_4829_ = f32();
                                            phi_4830_ = true;
                                        } else {
                                            let _e2220 = (_e2218 > 0i);
                                            if _e2220 {
                                                phi_4822_ = bitcast<f32>(((_e2197 | (bitcast<u32>(_e2218) << bitcast<u32>(23i))) | (_e2216 & 8388607u)));
                                                phi_4823_ = f32();
                                            } else {
                                                if (_e2218 < -24i) {
                                                    phi_4788_ = 26u;
                                                } else {
                                                    phi_4788_ = bitcast<u32>((1i - _e2218));
                                                }
                                                let _e2225 = phi_4788_;
                                                let _e2226 = (_e2225 & 31u);
                                                let _e2228 = (_e2216 >> bitcast<u32>(_e2226));
                                                let _e2232 = (_e2216 & ((1u << bitcast<u32>(_e2226)) - 1u));
                                                let _e2236 = (1u << bitcast<u32>(((_e2225 - 1u) & 31u)));
                                                if (_e2232 > _e2236) {
                                                    phi_4809_ = true;
                                                } else {
                                                    if (_e2232 == _e2236) {
                                                        phi_4806_ = ((_e2228 & 1u) == 1u);
                                                    } else {
                                                        phi_4806_ = false;
                                                    }
                                                    let _e2242 = phi_4806_;
                                                    phi_4809_ = _e2242;
                                                }
                                                let _e2244 = phi_4809_;
                                                phi_4822_ = f32();
                                                phi_4823_ = bitcast<f32>((_e2197 | (_e2228 + select(0u, 1u, _e2244))));
                                            }
                                            let _e2257 = phi_4822_;
                                            let _e2259 = phi_4823_;
                                            phi_4828_ = _e2257;
                                            phi_4829_ = _e2259;
                                            phi_4830_ = _e2220;
                                        }
                                        let _e2263 = phi_4828_;
                                        let _e2265 = phi_4829_;
                                        let _e2267 = phi_4830_;
                                        phi_4838_ = select(_e2265, _e2263, _e2267);
                                    }
                                    let _e2271 = phi_4838_;
                                    phi_4289_ = _e2271;
                                } else {
                                    phi_4289_ = _e2194;
                                }
                                let _e2273 = phi_4289_;
                                phi_4290_ = _e2273;
                            }
                            let _e2275 = phi_4290_;
                            let _e2276 = bitcast<u32>(_e2275);
                            if ((_e2276 & 2147483647u) >= 2139095040u) {
                                phi_4302_ = bitcast<f32>(((_e2276 & 2147483648u) | 2139095039u));
                            } else {
                                phi_4302_ = _e2275;
                            }
                            let _e2283 = phi_4302_;
                            phi_4307_ = type_22(_e2283, _e2165.member.member.member_1, _e2165.member.member.member_2, _e2165.member.member.member_3);
                        } else {
                            phi_4307_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e2288 = phi_4307_;
                        if _e159 {
                        } else {
                            break;
                        }
                        global_1.member[_e143] = _e2288;
                        let _e2292 = local_11;
                        if _e160 {
                        } else {
                            break;
                        }
                        global_5.member[_e143] = _e2292.member_1;
                        if _e158 {
                        } else {
                            break;
                        }
                        let _e2297 = select(0u, 1u, (_e227 <= _e237));
                        if (_e2297 > 0u) {
                            let _e2299 = (1u < _e111);
                            if _e2299 {
                                if (0u < _e111) {
                                } else {
                                    break;
                                }
                                let _e2303 = atomicAdd((&global_6.member[0u]), _e2297);
                                if ((_e2303 + _e2297) < _e2303) {
                                    if _e2299 {
                                    } else {
                                        break;
                                    }
                                    let _e2308 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e2311 = select(0u, 1u, (_e2288.member_3 != 4294967295u));
                        if (_e2311 > 0u) {
                            let _e2313 = (3u < _e111);
                            if _e2313 {
                                if (2u < _e111) {
                                } else {
                                    break;
                                }
                                let _e2317 = atomicAdd((&global_6.member[2u]), _e2311);
                                if ((_e2317 + _e2311) < _e2317) {
                                    if _e2313 {
                                    } else {
                                        break;
                                    }
                                    let _e2322 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e2292.member_1 > 0u) {
                            let _e2324 = (5u < _e111);
                            if _e2324 {
                                if (4u < _e111) {
                                } else {
                                    break;
                                }
                                let _e2328 = atomicAdd((&global_6.member[4u]), _e2292.member_1);
                                if ((_e2328 + _e2292.member_1) < _e2328) {
                                    if _e2324 {
                                    } else {
                                        break;
                                    }
                                    let _e2333 = atomicAdd((&global_6.member[5u]), 1u);
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
fn trace_paths_counted_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
