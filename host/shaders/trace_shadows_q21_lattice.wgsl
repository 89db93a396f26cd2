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

struct type_23 {
    member: type_22,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_30 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_31 {
    member: type_22,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_36 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_42 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_43 {
    member: f32,
    member_1: bool,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_48 {
    member: array<i32>,
}

struct type_54 {
    member: array<array<u32, 7>>,
}

struct type_59 {
    member: type_30,
    member_1: u32,
}

struct type_60 {
    member: array<vec4<f32>, 3>,
    member_1: type_59,
    member_2: type_59,
}

struct type_65 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_25;
@group(0) @binding(1) 
var<uniform> global_3: type_45;
@group(0) @binding(2) 
var<uniform> global_4: type_45;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_48;
@group(0) @binding(9) 
var<storage, read_write> global_7: type_65;
@group(0) @binding(3) 
var<storage> global_8: type_54;
@group(0) @binding(7) 
var<storage> global_9: type_33;
@group(0) @binding(4) 
var<storage> global_10: type_4;

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
    var phi_363_: u32;
    var phi_407_: i32;
    var phi_547_: type_36;
    var phi_697_: i32;
    var phi_698_: i32;
    var phi_708_: bool;
    var phi_718_: u32;
    var phi_719_: u32;
    var phi_721_: bool;
    var phi_726_: u32;
    var phi_759_: i32;
    var phi_777_: f32;
    var phi_783_: f32;
    var phi_823_: f32;
    var phi_829_: f32;
    var phi_902_: f32;
    var phi_908_: f32;
    var phi_948_: f32;
    var phi_954_: f32;
    var phi_1027_: f32;
    var phi_1033_: f32;
    var phi_1073_: f32;
    var phi_1079_: f32;
    var phi_1198_: i32;
    var phi_1220_: u32;
    var phi_1221_: u32;
    var phi_1258_: i32;
    var phi_1280_: u32;
    var phi_1281_: u32;
    var phi_1289_: f32;
    var phi_1290_: f32;
    var phi_5142_: bool;
    var phi_1386_: type_43;
    var phi_1389_: u32;
    var phi_1391_: bool;
    var phi_1393_: u32;
    var phi_1395_: type_59;
    var phi_1406_: bool;
    var phi_1492_: bool;
    var phi_1493_: u32;
    var phi_1494_: type_59;
    var phi_1513_: type_43;
    var phi_1516_: type_8;
    var phi_1517_: type_8;
    var phi_1539_: type_8;
    var phi_1580_: u32;
    var phi_1586_: u32;
    var phi_1596_: u32;
    var phi_1612_: u32;
    var phi_1645_: u32;
    var phi_1651_: u32;
    var phi_2117_: u32;
    var phi_2135_: u32;
    var phi_2153_: u32;
    var phi_2176_: u32;
    var phi_2194_: u32;
    var phi_2212_: u32;
    var phi_2235_: u32;
    var phi_2253_: u32;
    var phi_2271_: u32;
    var phi_1825_: u32;
    var phi_1840_: u32;
    var phi_1850_: u32;
    var phi_1871_: u32;
    var phi_1892_: u32;
    var phi_1922_: u32;
    var phi_1937_: u32;
    var phi_1947_: u32;
    var phi_1968_: u32;
    var phi_1989_: u32;
    var phi_2019_: u32;
    var phi_2034_: u32;
    var phi_2044_: u32;
    var phi_2065_: u32;
    var phi_2086_: u32;
    var phi_1678_: u32;
    var phi_1727_: u32;
    var phi_1776_: u32;
    var phi_2277_: array<array<f32, 3>, 3>;
    var phi_4777_: bool;
    var phi_4792_: bool;
    var phi_4807_: bool;
    var phi_4822_: bool;
    var phi_4837_: bool;
    var phi_4852_: bool;
    var phi_2819_: f32;
    var phi_2820_: f32;
    var phi_2821_: f32;
    var phi_2822_: f32;
    var phi_2823_: vec3<f32>;
    var phi_2824_: vec3<f32>;
    var phi_2825_: vec3<f32>;
    var phi_2826_: vec3<f32>;
    var phi_4867_: bool;
    var phi_4882_: bool;
    var phi_4897_: bool;
    var phi_4912_: bool;
    var phi_4927_: bool;
    var phi_4942_: bool;
    var phi_3034_: f32;
    var phi_3054_: type_42;
    var phi_3055_: type_42;
    var phi_3058_: type_42;
    var phi_3059_: type_42;
    var phi_3060_: bool;
    var phi_3064_: type_42;
    var phi_3073_: type_21;
    var phi_3096_: u32;
    var phi_3110_: i32;
    var phi_3132_: vec3<f32>;
    var phi_3133_: vec3<f32>;
    var phi_3151_: vec3<f32>;
    var phi_3152_: vec3<f32>;
    var phi_3170_: vec3<f32>;
    var phi_3171_: vec3<f32>;
    var phi_3207_: vec3<f32>;
    var phi_3389_: f32;
    var phi_3407_: bool;
    var phi_3408_: bool;
    var phi_3413_: type_43;
    var phi_3414_: type_43;
    var phi_1514_: type_43;
    var phi_5136_: bool;
    var phi_5471_: bool;
    var phi_3415_: type_43;
    var phi_3917_: u32;
    var phi_3923_: u32;
    var phi_4177_: u32;
    var phi_4178_: u32;
    var phi_4188_: u32;
    var phi_4190_: u32;
    var phi_4191_: bool;
    var phi_4211_: u32;
    var phi_4212_: u32;
    var phi_4216_: type_60;
    var phi_4578_: type_59;
    var phi_4654_: type_59;
    var phi_4655_: u32;
    var phi_4656_: type_59;
    var phi_4658_: u32;
    var phi_4659_: type_59;
    var phi_4660_: bool;
    var phi_4669_: type_59;
    var phi_4674_: bool;
    var phi_4676_: type_59;
    var phi_4680_: bool;
    var phi_4681_: u32;
    var phi_4682_: type_59;
    var phi_4692_: u32;
    var phi_4693_: type_59;
    var phi_5383_: bool;
    var phi_4694_: type_43;
    var phi_4695_: u32;
    var phi_4696_: bool;
    var phi_4697_: u32;
    var phi_4698_: type_59;
    var phi_5382_: bool;
    var phi_4699_: type_43;
    var phi_4700_: u32;
    var phi_4701_: bool;
    var phi_4702_: u32;
    var phi_4703_: type_59;
    var phi_5381_: bool;
    var phi_1387_: type_43;
    var phi_1390_: u32;
    var phi_1392_: bool;
    var phi_1394_: u32;
    var phi_1396_: type_59;
    var phi_4704_: bool;
    var phi_5380_: bool;
    var local_10: type_43;
    var local_11: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e102 = global;
            let _e104 = arrayLength((&global_8.member));
            let _e107 = arrayLength((&global_10.member));
            let _e119 = arrayLength((&global_7.member));
            let _e123 = global_4.member[0u][0u];
            let _e127 = global_4.member[0u][1u];
            let _e131 = global_4.member[0u][2u];
            let _e135 = global_4.member[0u][3u];
            let _e139 = global_4.member[1u][0u];
            let _e143 = global_4.member[1u][1u];
            let _e147 = global_4.member[1u][2u];
            let _e151 = (_e102.x + (_e102.y * 2097152u));
            let _e163 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e135) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e123), bitcast<i32>(_e127), bitcast<i32>(_e131));
            local = array<i32, 3>(bitcast<i32>(_e139), bitcast<i32>(_e143), bitcast<i32>(_e147));
            let _e166 = (_e151 < arrayLength((&global_9.member)));
            if _e166 {
                if _e166 {
                } else {
                    break;
                }
                let _e170 = global_9.member[_e151].member_2;
                phi_363_ = _e170;
            } else {
                phi_363_ = 4294967295u;
            }
            let _e172 = phi_363_;
            let _e175 = global_1.member[0u];
            let _e179 = global_3.member[0u][0u];
            let _e183 = global_3.member[0u][1u];
            let _e187 = global_3.member[0u][2u];
            let _e191 = global_3.member[0u][3u];
            let _e195 = global_3.member[1u][0u];
            let _e199 = global_3.member[1u][1u];
            let _e203 = global_3.member[1u][2u];
            let _e207 = global_3.member[1u][3u];
            let _e208 = bitcast<f32>(_e179);
            let _e209 = bitcast<f32>(_e183);
            let _e210 = bitcast<f32>(_e187);
            let _e212 = bitcast<f32>(_e195);
            let _e213 = array<u32, 3>(_e199, _e203, _e207);
            let _e215 = bitcast<i32>(_e175);
            if (_e215 < -126i) {
                phi_407_ = -126i;
            } else {
                phi_407_ = select(_e215, 127i, (_e215 > 127i));
            }
            let _e220 = phi_407_;
            let _e225 = bitcast<f32>((bitcast<u32>((_e220 + 127i)) << bitcast<u32>(23i)));
            let _e231 = bitcast<f32>((bitcast<u32>(((_e215 - _e220) + 127i)) << bitcast<u32>(23i)));
            if (_e191 == 0u) {
                phi_547_ = type_36(array<f32, 3>(_e208, _e209, _e210), _e191, _e212, _e213);
            } else {
                let _e233 = bitcast<u32>(_e208);
                let _e235 = ((_e233 & 2139095040u) != 0u);
                let _e250 = bitcast<u32>(_e209);
                let _e252 = ((_e250 & 2139095040u) != 0u);
                let _e267 = bitcast<u32>(_e210);
                let _e269 = ((_e267 & 2139095040u) != 0u);
                let _e285 = bitcast<u32>(_e212);
                let _e287 = ((_e285 & 2139095040u) != 0u);
                phi_547_ = type_36(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e233 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e233 & 2147483648u))), _e208, _e235) * _e225) * select(0.00000011920929f, 1f, _e235)) * _e231), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e250 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e250 & 2147483648u))), _e209, _e252) * _e225) * select(0.00000011920929f, 1f, _e252)) * _e231), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e267 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e267 & 2147483648u))), _e210, _e269) * _e225) * select(0.00000011920929f, 1f, _e269)) * _e231)), _e191, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e285 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e285 & 2147483648u))), _e212, _e287) * _e225) * select(0.00000011920929f, 1f, _e287)) * _e231), _e213);
            }
            let _e304 = phi_547_;
            if _e166 {
                let _e305 = (_e151 < arrayLength((&global_2.member)));
                if _e305 {
                    if _e166 {
                    } else {
                        break;
                    }
                    let _e310 = global_9.member[_e151].member.member_1;
                    let _e315 = global_9.member[_e151].member.member_3;
                    if (_e310 <= _e315) {
                        let _e317 = (1u < _e119);
                        if _e317 {
                            if (0u < _e119) {
                            } else {
                                break;
                            }
                            let _e321 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e321 + 1u) < _e321) {
                                if _e317 {
                                } else {
                                    break;
                                }
                                let _e326 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e166 {
                        } else {
                            break;
                        }
                        let _e336 = global_9.member[_e151].member.member_2[0u];
                        let _e338 = (bitcast<u32>(_e336) & 2147483647u);
                        let _e344 = global_9.member[_e151].member.member_2[1u];
                        let _e346 = (bitcast<u32>(_e344) & 2147483647u);
                        let _e352 = global_9.member[_e151].member.member_2[2u];
                        let _e354 = (bitcast<u32>(_e352) & 2147483647u);
                        let _e360 = global_9.member[_e151].member.member[0u];
                        let _e362 = (bitcast<u32>(_e360) & 2147483647u);
                        let _e368 = global_9.member[_e151].member.member[1u];
                        let _e370 = (bitcast<u32>(_e368) & 2147483647u);
                        let _e376 = global_9.member[_e151].member.member[2u];
                        let _e378 = (bitcast<u32>(_e376) & 2147483647u);
                        let _e380 = select(_e346, _e338, (_e346 < _e338));
                        let _e382 = select(_e354, _e380, (_e354 < _e380));
                        let _e384 = select(_e362, _e382, (_e362 < _e382));
                        let _e386 = select(_e370, _e384, (_e370 < _e384));
                        let _e388 = select(_e378, _e386, (_e378 < _e386));
                        let _e389 = bitcast<u32>(_e310);
                        let _e390 = (_e389 & 2147483647u);
                        let _e394 = bitcast<u32>(_e315);
                        let _e395 = (_e394 & 2147483647u);
                        let _e399 = (((select(_e390, _e388, (_e390 < _e388)) < 2139095040u) && (_e395 <= 2139095040u)) && (_e382 > 0u));
                        if _e399 {
                            let _e402 = (bitcast<u32>(bitcast<f32>(_e382)) & 2147483647u);
                            if (_e402 >= 8388608u) {
                                phi_697_ = (bitcast<i32>((_e402 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_697_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e402)), 32u, (_e402 == 0u))));
                            }
                            let _e416 = phi_697_;
                            phi_698_ = _e416;
                        } else {
                            phi_698_ = 0i;
                        }
                        let _e418 = phi_698_;
                        let _e419 = (_e338 == _e382);
                        if _e419 {
                            phi_708_ = true;
                        } else {
                            phi_708_ = (_e346 == _e382);
                        }
                        let _e422 = phi_708_;
                        let _e423 = select(1u, 0u, _e419);
                        if _e422 {
                            let _e424 = (_e423 + 1u);
                            phi_718_ = _e424;
                            phi_719_ = _e424;
                            phi_721_ = select(true, false, (_e424 == 2u));
                        } else {
                            phi_718_ = u32();
                            phi_719_ = 0u;
                            phi_721_ = true;
                        }
                        let _e428 = phi_718_;
                        let _e430 = phi_719_;
                        let _e432 = phi_721_;
                        if _e432 {
                            phi_726_ = (_e430 + 1u);
                        } else {
                            phi_726_ = 0u;
                        }
                        let _e436 = phi_726_;
                        let _e437 = select(_e428, _e430, _e432);
                        let _e438 = select(_e423, select(2u, _e423, _e422), _e432);
                        let _e439 = -(_e418);
                        if (_e439 < -126i) {
                            phi_759_ = -126i;
                        } else {
                            phi_759_ = select(_e439, 127i, (_e439 > 127i));
                        }
                        let _e444 = phi_759_;
                        let _e449 = bitcast<f32>((bitcast<u32>((_e444 + 127i)) << bitcast<u32>(23i)));
                        let _e455 = bitcast<f32>((bitcast<u32>(((_e439 - _e444) + 127i)) << bitcast<u32>(23i)));
                        let _e460 = global_9.member[_e151].member.member;
                        let _e461 = (_e437 == 0u);
                        if _e461 {
                            phi_777_ = _e460[0];
                        } else {
                            phi_777_ = _e460[1];
                        }
                        let _e465 = phi_777_;
                        let _e466 = (_e437 == 2u);
                        if _e466 {
                            phi_783_ = _e460[2];
                        } else {
                            phi_783_ = _e465;
                        }
                        let _e469 = phi_783_;
                        let _e470 = bitcast<u32>(_e469);
                        let _e472 = ((_e470 & 2139095040u) != 0u);
                        let _e484 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e470 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e470 & 2147483648u))), _e469, _e472) * select(0.00000011920929f, 1f, _e472));
                        let _e485 = global_9.member[_e151].member.member_2;
                        if _e461 {
                            phi_823_ = _e485[0];
                        } else {
                            phi_823_ = _e485[1];
                        }
                        let _e489 = phi_823_;
                        if _e466 {
                            phi_829_ = _e485[2];
                        } else {
                            phi_829_ = _e489;
                        }
                        let _e492 = phi_829_;
                        let _e493 = bitcast<u32>(_e492);
                        let _e495 = ((_e493 & 2139095040u) != 0u);
                        let _e509 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e493 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e493 & 2147483648u))), _e492, _e495) * _e449) * select(0.00000011920929f, 1f, _e495)) * _e455);
                        let _e513 = (bitcast<f32>((bitcast<u32>(_e509) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e516 = bitcast<f32>((bitcast<u32>(_e484) & 2147483647u));
                        let _e517 = (_e516 * 0.00000011920929f);
                        let _e520 = select(select(0.00000000000011368684f, _e517, (_e517 > 0.00000000000011368684f)), 0f, _e513);
                        let _e521 = select(0f, _e509, _e513);
                        let _e522 = (_e484 + _e520);
                        let _e523 = (_e484 - _e520);
                        let _e525 = select(38685626000000000000000000f, (1f / _e509), _e513);
                        let _e526 = (_e436 == 0u);
                        if _e526 {
                            phi_902_ = _e460[0];
                        } else {
                            phi_902_ = _e460[1];
                        }
                        let _e530 = phi_902_;
                        let _e531 = (_e436 == 2u);
                        if _e531 {
                            phi_908_ = _e460[2];
                        } else {
                            phi_908_ = _e530;
                        }
                        let _e534 = phi_908_;
                        let _e535 = bitcast<u32>(_e534);
                        let _e537 = ((_e535 & 2139095040u) != 0u);
                        let _e549 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e535 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e535 & 2147483648u))), _e534, _e537) * select(0.00000011920929f, 1f, _e537));
                        if _e526 {
                            phi_948_ = _e485[0];
                        } else {
                            phi_948_ = _e485[1];
                        }
                        let _e553 = phi_948_;
                        if _e531 {
                            phi_954_ = _e485[2];
                        } else {
                            phi_954_ = _e553;
                        }
                        let _e556 = phi_954_;
                        let _e557 = bitcast<u32>(_e556);
                        let _e559 = ((_e557 & 2139095040u) != 0u);
                        let _e573 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e557 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e557 & 2147483648u))), _e556, _e559) * _e449) * select(0.00000011920929f, 1f, _e559)) * _e455);
                        let _e577 = (bitcast<f32>((bitcast<u32>(_e573) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e580 = bitcast<f32>((bitcast<u32>(_e549) & 2147483647u));
                        let _e581 = (_e580 * 0.00000011920929f);
                        let _e584 = select(select(0.00000000000011368684f, _e581, (_e581 > 0.00000000000011368684f)), 0f, _e577);
                        let _e585 = select(0f, _e573, _e577);
                        let _e586 = (_e549 + _e584);
                        let _e587 = (_e549 - _e584);
                        let _e589 = select(38685626000000000000000000f, (1f / _e573), _e577);
                        let _e590 = (_e438 == 0u);
                        if _e590 {
                            phi_1027_ = _e460[0];
                        } else {
                            phi_1027_ = _e460[1];
                        }
                        let _e594 = phi_1027_;
                        let _e595 = (_e438 == 2u);
                        if _e595 {
                            phi_1033_ = _e460[2];
                        } else {
                            phi_1033_ = _e594;
                        }
                        let _e598 = phi_1033_;
                        let _e599 = bitcast<u32>(_e598);
                        let _e601 = ((_e599 & 2139095040u) != 0u);
                        let _e613 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e599 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e599 & 2147483648u))), _e598, _e601) * select(0.00000011920929f, 1f, _e601));
                        if _e590 {
                            phi_1073_ = _e485[0];
                        } else {
                            phi_1073_ = _e485[1];
                        }
                        let _e617 = phi_1073_;
                        if _e595 {
                            phi_1079_ = _e485[2];
                        } else {
                            phi_1079_ = _e617;
                        }
                        let _e620 = phi_1079_;
                        let _e621 = bitcast<u32>(_e620);
                        let _e623 = ((_e621 & 2139095040u) != 0u);
                        let _e637 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e621 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e621 & 2147483648u))), _e620, _e623) * _e449) * select(0.00000011920929f, 1f, _e623)) * _e455);
                        let _e641 = (bitcast<f32>((bitcast<u32>(_e637) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e644 = bitcast<f32>((bitcast<u32>(_e613) & 2147483647u));
                        let _e645 = (_e644 * 0.00000011920929f);
                        let _e648 = select(select(0.00000000000011368684f, _e645, (_e645 > 0.00000000000011368684f)), 0f, _e641);
                        let _e649 = select(0f, _e637, _e641);
                        let _e650 = (_e613 + _e648);
                        let _e651 = (_e613 - _e648);
                        let _e653 = select(38685626000000000000000000f, (1f / _e637), _e641);
                        let _e655 = select(_e580, _e516, (_e516 > _e580));
                        if (_e399 && (select(_e644, _e655, (_e655 > _e644)) <= 1099511600000f)) {
                            let _e667 = ((_e390 & 8388607u) | (select(0u, 1u, ((_e390 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e670 = bitcast<i32>((_e390 >> bitcast<u32>(23i)));
                            let _e674 = (_e667 == 0u);
                            let _e677 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e667)), 32u, _e674)) - 8i);
                            if (_e670 == 255i) {
                                phi_1198_ = 255i;
                            } else {
                                phi_1198_ = (((_e670 + select(0i, 1i, (_e670 == 0i))) - _e677) + _e418);
                            }
                            let _e685 = phi_1198_;
                            let _e695 = (_e685 <= 0i);
                            if _e695 {
                                phi_1221_ = u32();
                            } else {
                                if _e674 {
                                    phi_1220_ = u32();
                                } else {
                                    phi_1220_ = select(((bitcast<u32>(_e685) << bitcast<u32>(23i)) | ((_e667 << bitcast<u32>(((_e677 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e685 >= 255i));
                                }
                                let _e699 = phi_1220_;
                                phi_1221_ = _e699;
                            }
                            let _e701 = phi_1221_;
                            let _e713 = ((_e395 & 8388607u) | (select(0u, 1u, ((_e395 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e716 = bitcast<i32>((_e395 >> bitcast<u32>(23i)));
                            let _e720 = (_e713 == 0u);
                            let _e723 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e713)), 32u, _e720)) - 8i);
                            if (_e716 == 255i) {
                                phi_1258_ = 255i;
                            } else {
                                phi_1258_ = (((_e716 + select(0i, 1i, (_e716 == 0i))) - _e723) + _e418);
                            }
                            let _e731 = phi_1258_;
                            let _e741 = (_e731 <= 0i);
                            if _e741 {
                                phi_1281_ = u32();
                            } else {
                                if _e720 {
                                    phi_1280_ = u32();
                                } else {
                                    phi_1280_ = select(((bitcast<u32>(_e731) << bitcast<u32>(23i)) | ((_e713 << bitcast<u32>(((_e723 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e731 >= 255i));
                                }
                                let _e745 = phi_1280_;
                                phi_1281_ = _e745;
                            }
                            let _e747 = phi_1281_;
                            phi_1289_ = bitcast<f32>(((_e394 & 2147483648u) | select(_e747, 0u, select(_e720, true, _e741))));
                            phi_1290_ = bitcast<f32>(((_e389 & 2147483648u) | select(_e701, 0u, select(_e674, true, _e695))));
                        } else {
                            phi_1289_ = 0f;
                            phi_1290_ = 1f;
                        }
                        let _e753 = phi_1289_;
                        let _e755 = phi_1290_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e759 = (_e437 % 3u);
                        let _e760 = (_e759 < 3u);
                        if _e760 {
                        } else {
                            break;
                        }
                        let _e762 = local_1[_e759];
                        let _e765 = (_e436 % 3u);
                        let _e766 = (_e765 < 3u);
                        if _e766 {
                        } else {
                            break;
                        }
                        let _e768 = local_1[_e765];
                        let _e771 = (_e438 % 3u);
                        let _e772 = (_e771 < 3u);
                        if _e772 {
                        } else {
                            break;
                        }
                        let _e774 = local_1[_e771];
                        if _e760 {
                        } else {
                            break;
                        }
                        let _e779 = local[_e759];
                        if _e766 {
                        } else {
                            break;
                        }
                        let _e783 = local[_e765];
                        if _e772 {
                        } else {
                            break;
                        }
                        let _e787 = local[_e771];
                        phi_5142_ = false;
                        phi_1386_ = type_43(_e753, false);
                        phi_1389_ = ((3u * _e104) + 1u);
                        phi_1391_ = (_e755 <= _e753);
                        phi_1393_ = 0u;
                        phi_1395_ = type_59(type_30(vec4<f32>((f32(_e762) * _e163), (f32(_e768) * _e163), (f32(_e774) * _e163), 0f), vec4<f32>((f32(_e779) * _e163), (f32(_e783) * _e163), (f32(_e787) * _e163), 0f)), select(0u, 2147483648u, (_e104 == 0u)));
                        loop {
                            let _e797 = phi_5142_;
                            let _e799 = phi_1386_;
                            let _e801 = phi_1389_;
                            let _e803 = phi_1391_;
                            let _e805 = phi_1393_;
                            let _e807 = phi_1395_;
                            local_10 = _e799;
                            if _e803 {
                                phi_1406_ = true;
                            } else {
                                phi_1406_ = (_e805 > 0u);
                            }
                            let _e810 = phi_1406_;
                            if _e810 {
                                let _e811 = (_e801 > 0u);
                                if _e811 {
                                    if _e803 {
                                        phi_1492_ = _e803;
                                        phi_1493_ = _e805;
                                        phi_1494_ = _e807;
                                    } else {
                                        let _e812 = (_e805 - 1u);
                                        let _e813 = (_e812 % 128u);
                                        let _e814 = (_e813 < 128u);
                                        if _e814 {
                                        } else {
                                            phi_5380_ = true;
                                            break;
                                        }
                                        let _e816 = local_7[_e813];
                                        if _e814 {
                                        } else {
                                            phi_5380_ = true;
                                            break;
                                        }
                                        let _e818 = local_6[_e813];
                                        if _e814 {
                                        } else {
                                            phi_5380_ = true;
                                            break;
                                        }
                                        let _e820 = local_5[_e813];
                                        if _e814 {
                                        } else {
                                            phi_5380_ = true;
                                            break;
                                        }
                                        let _e822 = local_4[_e813];
                                        if _e814 {
                                        } else {
                                            phi_5380_ = true;
                                            break;
                                        }
                                        let _e824 = local_3[_e813];
                                        if _e814 {
                                        } else {
                                            phi_5380_ = true;
                                            break;
                                        }
                                        let _e826 = local_2[_e813];
                                        if _e814 {
                                        } else {
                                            phi_5380_ = true;
                                            break;
                                        }
                                        let _e831 = local_8[_e813];
                                        if _e814 {
                                        } else {
                                            phi_5380_ = true;
                                            break;
                                        }
                                        let _e834 = local_9[_e813];
                                        phi_1492_ = (_e834 <= _e799.member);
                                        phi_1493_ = _e812;
                                        phi_1494_ = type_59(type_30(vec4<f32>(_e816, _e818, _e820, 0f), vec4<f32>(_e822, _e824, _e826, 0f)), _e831);
                                    }
                                    let _e838 = phi_1492_;
                                    let _e840 = phi_1493_;
                                    let _e842 = phi_1494_;
                                    if _e838 {
                                        let _e846 = ((_e842.member_1 & 2147483648u) != 0u);
                                        let _e847 = (_e842.member_1 & 268435455u);
                                        if _e846 {
                                            phi_1513_ = _e799;
                                            phi_1516_ = type_8(0u, ((_e842.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e854 = phi_1513_;
                                                let _e856 = phi_1516_;
                                                local_11 = _e854;
                                                if (_e856.member < _e856.member_1) {
                                                    phi_1517_ = type_8((_e856.member + 1u), _e856.member_1);
                                                    phi_1539_ = type_8(1u, _e856.member);
                                                } else {
                                                    phi_1517_ = _e856;
                                                    phi_1539_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e869 = phi_1517_;
                                                let _e871 = phi_1539_;
                                                let _e875 = (bitcast<i32>(_e871.member) != 0i);
                                                if _e875 {
                                                    let _e880 = (_e842.member.member_1.x - _e842.member.member.x);
                                                    let _e883 = (_e842.member.member_1.y - _e842.member.member.y);
                                                    let _e886 = (_e842.member.member_1.z - _e842.member.member.z);
                                                    let _e888 = select(_e883, _e880, (_e880 > _e883));
                                                    let _e890 = select(_e886, _e888, (_e888 > _e886));
                                                    let _e892 = (_e890 < (1024f * _e163));
                                                    if _e892 {
                                                        phi_1580_ = 0u;
                                                    } else {
                                                        phi_1580_ = select(2u, 1u, (_e890 < (2097152f * _e163)));
                                                    }
                                                    let _e897 = phi_1580_;
                                                    switch bitcast<i32>(_e897) {
                                                        case 0: {
                                                            phi_1586_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1586_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1586_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1586_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e900 = phi_1586_;
                                                    switch bitcast<i32>(_e897) {
                                                        case 0: {
                                                            phi_1596_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1596_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1596_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1596_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e907 = phi_1596_;
                                                    let _e909 = ((_e847 + (_e871.member_1 * ((3u * _e900) + 1u))) + (3u * _e907));
                                                    let _e910 = (_e909 < _e107);
                                                    if _e910 {
                                                        if _e910 {
                                                        } else {
                                                            phi_5136_ = true;
                                                            break;
                                                        }
                                                        let _e912 = global_10.member[_e909];
                                                        phi_1612_ = _e912;
                                                    } else {
                                                        phi_1612_ = 4294967295u;
                                                    }
                                                    let _e914 = phi_1612_;
                                                    if _e892 {
                                                        phi_1645_ = 0u;
                                                    } else {
                                                        phi_1645_ = select(2u, 1u, (_e890 < (2097152f * _e163)));
                                                    }
                                                    let _e919 = phi_1645_;
                                                    switch bitcast<i32>(_e919) {
                                                        case 0: {
                                                            phi_1651_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1651_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1651_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1651_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e922 = phi_1651_;
                                                    let _e926 = (_e847 + (_e871.member_1 * ((3u * _e922) + 1u)));
                                                    switch bitcast<i32>(_e919) {
                                                        case 0: {
                                                            let _e1201 = (_e926 < _e107);
                                                            if _e1201 {
                                                                if _e1201 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1203 = global_10.member[_e926];
                                                                phi_1678_ = _e1203;
                                                            } else {
                                                                phi_1678_ = 0u;
                                                            }
                                                            let _e1205 = phi_1678_;
                                                            let _e1207 = ((10u * _e437) & 31u);
                                                            let _e1217 = ((10u * _e436) & 31u);
                                                            let _e1227 = ((10u * _e438) & 31u);
                                                            let _e1237 = (_e926 + 1u);
                                                            let _e1238 = (_e1237 < _e107);
                                                            if _e1238 {
                                                                if _e1238 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1240 = global_10.member[_e1237];
                                                                phi_1727_ = _e1240;
                                                            } else {
                                                                phi_1727_ = 0u;
                                                            }
                                                            let _e1242 = phi_1727_;
                                                            let _e1268 = (_e926 + 2u);
                                                            let _e1269 = (_e1268 < _e107);
                                                            if _e1269 {
                                                                if _e1269 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1271 = global_10.member[_e1268];
                                                                phi_1776_ = _e1271;
                                                            } else {
                                                                phi_1776_ = 0u;
                                                            }
                                                            let _e1273 = phi_1776_;
                                                            phi_2277_ = array<array<f32, 3>, 3>(array<f32, 3>((_e842.member.member.x + ((bitcast<f32>((1258291200u | ((_e1205 >> bitcast<u32>(_e1207)) & 1023u))) - 8388608f) * _e163)), (_e842.member.member.y + ((bitcast<f32>((1258291200u | ((_e1205 >> bitcast<u32>(_e1217)) & 1023u))) - 8388608f) * _e163)), (_e842.member.member.z + ((bitcast<f32>((1258291200u | ((_e1205 >> bitcast<u32>(_e1227)) & 1023u))) - 8388608f) * _e163))), array<f32, 3>((_e842.member.member.x + ((bitcast<f32>((1258291200u | ((_e1242 >> bitcast<u32>(_e1207)) & 1023u))) - 8388608f) * _e163)), (_e842.member.member.y + ((bitcast<f32>((1258291200u | ((_e1242 >> bitcast<u32>(_e1217)) & 1023u))) - 8388608f) * _e163)), (_e842.member.member.z + ((bitcast<f32>((1258291200u | ((_e1242 >> bitcast<u32>(_e1227)) & 1023u))) - 8388608f) * _e163))), array<f32, 3>((_e842.member.member.x + ((bitcast<f32>((1258291200u | ((_e1273 >> bitcast<u32>(_e1207)) & 1023u))) - 8388608f) * _e163)), (_e842.member.member.y + ((bitcast<f32>((1258291200u | ((_e1273 >> bitcast<u32>(_e1217)) & 1023u))) - 8388608f) * _e163)), (_e842.member.member.z + ((bitcast<f32>((1258291200u | ((_e1273 >> bitcast<u32>(_e1227)) & 1023u))) - 8388608f) * _e163))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1015 = (_e926 < _e107);
                                                            if _e1015 {
                                                                if _e1015 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1017 = global_10.member[_e926];
                                                                phi_1825_ = _e1017;
                                                            } else {
                                                                phi_1825_ = 0u;
                                                            }
                                                            let _e1019 = phi_1825_;
                                                            let _e1020 = (_e926 + 1u);
                                                            let _e1021 = (_e1020 < _e107);
                                                            if _e1021 {
                                                                if _e1021 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1023 = global_10.member[_e1020];
                                                                phi_1840_ = _e1023;
                                                            } else {
                                                                phi_1840_ = 0u;
                                                            }
                                                            let _e1025 = phi_1840_;
                                                            let _e1026 = (_e437 == 1u);
                                                            if _e1026 {
                                                                phi_1850_ = ((_e1019 >> bitcast<u32>(21i)) | (_e1025 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1850_ = (_e1025 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1035 = phi_1850_;
                                                            let _e1043 = (_e436 == 1u);
                                                            if _e1043 {
                                                                phi_1871_ = ((_e1019 >> bitcast<u32>(21i)) | (_e1025 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1871_ = (_e1025 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1052 = phi_1871_;
                                                            let _e1060 = (_e438 == 1u);
                                                            if _e1060 {
                                                                phi_1892_ = ((_e1019 >> bitcast<u32>(21i)) | (_e1025 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1892_ = (_e1025 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1069 = phi_1892_;
                                                            let _e1078 = (_e926 + 2u);
                                                            let _e1079 = (_e1078 < _e107);
                                                            if _e1079 {
                                                                if _e1079 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1081 = global_10.member[_e1078];
                                                                phi_1922_ = _e1081;
                                                            } else {
                                                                phi_1922_ = 0u;
                                                            }
                                                            let _e1083 = phi_1922_;
                                                            let _e1084 = (_e926 + 3u);
                                                            let _e1085 = (_e1084 < _e107);
                                                            if _e1085 {
                                                                if _e1085 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1087 = global_10.member[_e1084];
                                                                phi_1937_ = _e1087;
                                                            } else {
                                                                phi_1937_ = 0u;
                                                            }
                                                            let _e1089 = phi_1937_;
                                                            if _e1026 {
                                                                phi_1947_ = ((_e1083 >> bitcast<u32>(21i)) | (_e1089 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1947_ = (_e1089 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1098 = phi_1947_;
                                                            if _e1043 {
                                                                phi_1968_ = ((_e1083 >> bitcast<u32>(21i)) | (_e1089 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1968_ = (_e1089 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1114 = phi_1968_;
                                                            if _e1060 {
                                                                phi_1989_ = ((_e1083 >> bitcast<u32>(21i)) | (_e1089 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1989_ = (_e1089 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1130 = phi_1989_;
                                                            let _e1139 = (_e926 + 4u);
                                                            let _e1140 = (_e1139 < _e107);
                                                            if _e1140 {
                                                                if _e1140 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1142 = global_10.member[_e1139];
                                                                phi_2019_ = _e1142;
                                                            } else {
                                                                phi_2019_ = 0u;
                                                            }
                                                            let _e1144 = phi_2019_;
                                                            let _e1145 = (_e926 + 5u);
                                                            let _e1146 = (_e1145 < _e107);
                                                            if _e1146 {
                                                                if _e1146 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1148 = global_10.member[_e1145];
                                                                phi_2034_ = _e1148;
                                                            } else {
                                                                phi_2034_ = 0u;
                                                            }
                                                            let _e1150 = phi_2034_;
                                                            if _e1026 {
                                                                phi_2044_ = ((_e1144 >> bitcast<u32>(21i)) | (_e1150 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2044_ = (_e1150 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1159 = phi_2044_;
                                                            if _e1043 {
                                                                phi_2065_ = ((_e1144 >> bitcast<u32>(21i)) | (_e1150 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2065_ = (_e1150 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1175 = phi_2065_;
                                                            if _e1060 {
                                                                phi_2086_ = ((_e1144 >> bitcast<u32>(21i)) | (_e1150 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2086_ = (_e1150 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1191 = phi_2086_;
                                                            phi_2277_ = array<array<f32, 3>, 3>(array<f32, 3>((_e842.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1035, _e1019, _e461) & 2097151u))) - 8388608f) * _e163)), (_e842.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1052, _e1019, _e526) & 2097151u))) - 8388608f) * _e163)), (_e842.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1069, _e1019, _e590) & 2097151u))) - 8388608f) * _e163))), array<f32, 3>((_e842.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1098, _e1083, _e461) & 2097151u))) - 8388608f) * _e163)), (_e842.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1114, _e1083, _e526) & 2097151u))) - 8388608f) * _e163)), (_e842.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1130, _e1083, _e590) & 2097151u))) - 8388608f) * _e163))), array<f32, 3>((_e842.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1159, _e1144, _e461) & 2097151u))) - 8388608f) * _e163)), (_e842.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1175, _e1144, _e526) & 2097151u))) - 8388608f) * _e163)), (_e842.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1191, _e1144, _e590) & 2097151u))) - 8388608f) * _e163))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e928 = (_e926 + _e437);
                                                            let _e929 = (_e928 < _e107);
                                                            if _e929 {
                                                                if _e929 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e931 = global_10.member[_e928];
                                                                phi_2117_ = _e931;
                                                            } else {
                                                                phi_2117_ = 0u;
                                                            }
                                                            let _e933 = phi_2117_;
                                                            let _e937 = (_e926 + _e436);
                                                            let _e938 = (_e937 < _e107);
                                                            if _e938 {
                                                                if _e938 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e940 = global_10.member[_e937];
                                                                phi_2135_ = _e940;
                                                            } else {
                                                                phi_2135_ = 0u;
                                                            }
                                                            let _e942 = phi_2135_;
                                                            let _e946 = (_e926 + _e438);
                                                            let _e947 = (_e946 < _e107);
                                                            if _e947 {
                                                                if _e947 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e949 = global_10.member[_e946];
                                                                phi_2153_ = _e949;
                                                            } else {
                                                                phi_2153_ = 0u;
                                                            }
                                                            let _e951 = phi_2153_;
                                                            let _e956 = (_e926 + 3u);
                                                            let _e957 = (_e956 + _e437);
                                                            let _e958 = (_e957 < _e107);
                                                            if _e958 {
                                                                if _e958 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e960 = global_10.member[_e957];
                                                                phi_2176_ = _e960;
                                                            } else {
                                                                phi_2176_ = 0u;
                                                            }
                                                            let _e962 = phi_2176_;
                                                            let _e966 = (_e956 + _e436);
                                                            let _e967 = (_e966 < _e107);
                                                            if _e967 {
                                                                if _e967 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e969 = global_10.member[_e966];
                                                                phi_2194_ = _e969;
                                                            } else {
                                                                phi_2194_ = 0u;
                                                            }
                                                            let _e971 = phi_2194_;
                                                            let _e975 = (_e956 + _e438);
                                                            let _e976 = (_e975 < _e107);
                                                            if _e976 {
                                                                if _e976 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e978 = global_10.member[_e975];
                                                                phi_2212_ = _e978;
                                                            } else {
                                                                phi_2212_ = 0u;
                                                            }
                                                            let _e980 = phi_2212_;
                                                            let _e985 = (_e926 + 6u);
                                                            let _e986 = (_e985 + _e437);
                                                            let _e987 = (_e986 < _e107);
                                                            if _e987 {
                                                                if _e987 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e989 = global_10.member[_e986];
                                                                phi_2235_ = _e989;
                                                            } else {
                                                                phi_2235_ = 0u;
                                                            }
                                                            let _e991 = phi_2235_;
                                                            let _e995 = (_e985 + _e436);
                                                            let _e996 = (_e995 < _e107);
                                                            if _e996 {
                                                                if _e996 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e998 = global_10.member[_e995];
                                                                phi_2253_ = _e998;
                                                            } else {
                                                                phi_2253_ = 0u;
                                                            }
                                                            let _e1000 = phi_2253_;
                                                            let _e1004 = (_e985 + _e438);
                                                            let _e1005 = (_e1004 < _e107);
                                                            if _e1005 {
                                                                if _e1005 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1007 = global_10.member[_e1004];
                                                                phi_2271_ = _e1007;
                                                            } else {
                                                                phi_2271_ = 0u;
                                                            }
                                                            let _e1009 = phi_2271_;
                                                            phi_2277_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e933)) * _e163), (f32(bitcast<i32>(_e942)) * _e163), (f32(bitcast<i32>(_e951)) * _e163)), array<f32, 3>((f32(bitcast<i32>(_e962)) * _e163), (f32(bitcast<i32>(_e971)) * _e163), (f32(bitcast<i32>(_e980)) * _e163)), array<f32, 3>((f32(bitcast<i32>(_e991)) * _e163), (f32(bitcast<i32>(_e1000)) * _e163), (f32(bitcast<i32>(_e1009)) * _e163)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2277_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1301 = phi_2277_;
                                                    let _e1317 = (_e1301[0][2] - _e613);
                                                    let _e1320 = (((_e1301[0][0] - _e484) * _e649) - (_e1317 * _e521));
                                                    let _e1323 = (((_e1301[0][1] - _e549) * _e649) - (_e1317 * _e585));
                                                    let _e1326 = (_e1301[1][2] - _e613);
                                                    let _e1329 = (((_e1301[1][0] - _e484) * _e649) - (_e1326 * _e521));
                                                    let _e1332 = (((_e1301[1][1] - _e549) * _e649) - (_e1326 * _e585));
                                                    let _e1335 = (_e1301[2][2] - _e613);
                                                    let _e1338 = (((_e1301[2][0] - _e484) * _e649) - (_e1335 * _e521));
                                                    let _e1341 = (((_e1301[2][1] - _e549) * _e649) - (_e1335 * _e585));
                                                    let _e1342 = (_e1338 * _e1332);
                                                    let _e1343 = (_e1341 * _e1329);
                                                    let _e1344 = (_e1320 * _e1341);
                                                    let _e1345 = (_e1323 * _e1338);
                                                    let _e1346 = (_e1329 * _e1323);
                                                    let _e1347 = (_e1332 * _e1320);
                                                    let _e1352 = (((_e1342 >= _e1343) && (_e1344 >= _e1345)) && (_e1346 >= _e1347));
                                                    let _e1358 = (_e1352 || (((_e1342 <= _e1343) && (_e1344 <= _e1345)) && (_e1346 <= _e1347)));
                                                    if _e1358 {
                                                        let _e1360 = select(-1f, 1f, _e1352);
                                                        let _e1362 = ((_e1342 - _e1343) * _e1360);
                                                        let _e1364 = select(0f, _e1362, (_e1362 > 0f));
                                                        let _e1366 = ((_e1344 - _e1345) * _e1360);
                                                        let _e1368 = select(0f, _e1366, (_e1366 > 0f));
                                                        let _e1370 = ((_e1346 - _e1347) * _e1360);
                                                        let _e1372 = select(0f, _e1370, (_e1370 > 0f));
                                                        let _e1374 = ((_e1364 + _e1368) + _e1372);
                                                        let _e1376 = select(_e1301[1][0], _e1301[0][0], (_e1301[0][0] < _e1301[1][0]));
                                                        let _e1380 = select(_e1301[1][0], _e1301[0][0], (_e1301[0][0] > _e1301[1][0]));
                                                        let _e1384 = select(_e1301[1][1], _e1301[0][1], (_e1301[0][1] < _e1301[1][1]));
                                                        let _e1388 = select(_e1301[1][1], _e1301[0][1], (_e1301[0][1] > _e1301[1][1]));
                                                        let _e1392 = select(_e1301[1][2], _e1301[0][2], (_e1301[0][2] < _e1301[1][2]));
                                                        let _e1396 = select(_e1301[1][2], _e1301[0][2], (_e1301[0][2] > _e1301[1][2]));
                                                        let _e1401 = ((select(_e1301[2][0], _e1376, (_e1376 < _e1301[2][0])) - _e522) * _e525);
                                                        let _e1402 = ((select(_e1301[2][0], _e1380, (_e1380 > _e1301[2][0])) - _e523) * _e525);
                                                        let _e1405 = ((select(_e1301[2][1], _e1384, (_e1384 < _e1301[2][1])) - _e586) * _e589);
                                                        let _e1406 = ((select(_e1301[2][1], _e1388, (_e1388 > _e1301[2][1])) - _e587) * _e589);
                                                        let _e1409 = ((select(_e1301[2][2], _e1392, (_e1392 < _e1301[2][2])) - _e650) * _e653);
                                                        let _e1410 = ((select(_e1301[2][2], _e1396, (_e1396 > _e1301[2][2])) - _e651) * _e653);
                                                        let _e1412 = select(_e1410, _e1409, (_e1409 < _e1410));
                                                        let _e1414 = select(_e1410, _e1409, (_e1409 > _e1410));
                                                        let _e1416 = select(_e1402, _e1401, (_e1401 < _e1402));
                                                        let _e1418 = select(_e1406, _e1405, (_e1405 < _e1406));
                                                        let _e1420 = select(_e1418, _e1416, (_e1416 > _e1418));
                                                        let _e1422 = select(_e1412, _e1420, (_e1420 > _e1412));
                                                        let _e1424 = select(_e1402, _e1401, (_e1401 > _e1402));
                                                        let _e1426 = select(_e1406, _e1405, (_e1405 > _e1406));
                                                        let _e1428 = select(_e1426, _e1424, (_e1424 < _e1426));
                                                        let _e1430 = select(_e1414, _e1428, (_e1428 < _e1414));
                                                        let _e1431 = -(_e1412);
                                                        let _e1437 = select(_e755, _e1422, (_e1422 > _e755));
                                                        let _e1441 = select(_e1329, _e1320, (_e1320 < _e1329));
                                                        let _e1446 = select(_e1329, _e1320, (_e1320 > _e1329));
                                                        let _e1453 = select(_e1332, _e1323, (_e1323 < _e1332));
                                                        let _e1458 = select(_e1332, _e1323, (_e1323 > _e1332));
                                                        let _e1467 = (((((_e1358 && (_e1374 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1338, _e1441, (_e1441 < _e1338)) <= 0f) && (select(_e1338, _e1446, (_e1446 > _e1338)) >= 0f))) && ((select(_e1341, _e1453, (_e1453 < _e1341)) <= 0f) && (select(_e1341, _e1458, (_e1458 > _e1341)) >= 0f))) && (_e1437 <= (_e1430 + (select(_e1431, _e1414, (_e1414 > _e1431)) * 0.0000019073523f)))) && (_e1437 <= _e854.member));
                                                        if _e1467 {
                                                            let _e1472 = (_e1301[1][0] - _e1301[0][0]);
                                                            let _e1473 = (_e1301[1][1] - _e1301[0][1]);
                                                            let _e1474 = (_e1301[1][2] - _e1301[0][2]);
                                                            let _e1475 = vec3<f32>(_e1472, _e1473, _e1474);
                                                            let _e1476 = (_e1301[2][0] - _e1301[1][0]);
                                                            let _e1477 = (_e1301[2][1] - _e1301[1][1]);
                                                            let _e1478 = (_e1301[2][2] - _e1301[1][2]);
                                                            let _e1479 = vec3<f32>(_e1476, _e1477, _e1478);
                                                            let _e1480 = (_e1301[0][0] - _e1301[2][0]);
                                                            let _e1481 = (_e1301[0][1] - _e1301[2][1]);
                                                            let _e1482 = (_e1301[0][2] - _e1301[2][2]);
                                                            let _e1483 = vec3<f32>(_e1480, _e1481, _e1482);
                                                            let _e1484 = abs(_e1472);
                                                            let _e1485 = abs(_e1473);
                                                            if (_e1484 != _e1484) {
                                                                phi_4777_ = true;
                                                            } else {
                                                                phi_4777_ = (_e1485 >= _e1484);
                                                            }
                                                            let _e1489 = phi_4777_;
                                                            let _e1490 = select(_e1484, _e1485, _e1489);
                                                            let _e1491 = abs(_e1474);
                                                            if (_e1490 != _e1490) {
                                                                phi_4792_ = true;
                                                            } else {
                                                                phi_4792_ = (_e1491 >= _e1490);
                                                            }
                                                            let _e1495 = phi_4792_;
                                                            let _e1496 = select(_e1490, _e1491, _e1495);
                                                            let _e1497 = abs(_e1476);
                                                            let _e1498 = abs(_e1477);
                                                            if (_e1497 != _e1497) {
                                                                phi_4807_ = true;
                                                            } else {
                                                                phi_4807_ = (_e1498 >= _e1497);
                                                            }
                                                            let _e1502 = phi_4807_;
                                                            let _e1503 = select(_e1497, _e1498, _e1502);
                                                            let _e1504 = abs(_e1478);
                                                            if (_e1503 != _e1503) {
                                                                phi_4822_ = true;
                                                            } else {
                                                                phi_4822_ = (_e1504 >= _e1503);
                                                            }
                                                            let _e1508 = phi_4822_;
                                                            let _e1509 = select(_e1503, _e1504, _e1508);
                                                            let _e1510 = abs(_e1480);
                                                            let _e1511 = abs(_e1481);
                                                            if (_e1510 != _e1510) {
                                                                phi_4837_ = true;
                                                            } else {
                                                                phi_4837_ = (_e1511 >= _e1510);
                                                            }
                                                            let _e1515 = phi_4837_;
                                                            let _e1516 = select(_e1510, _e1511, _e1515);
                                                            let _e1517 = abs(_e1482);
                                                            if (_e1516 != _e1516) {
                                                                phi_4852_ = true;
                                                            } else {
                                                                phi_4852_ = (_e1517 >= _e1516);
                                                            }
                                                            let _e1521 = phi_4852_;
                                                            let _e1522 = select(_e1516, _e1517, _e1521);
                                                            let _e1524 = select(_e1509, _e1496, (_e1496 > _e1509));
                                                            let _e1526 = select(_e1522, _e1524, (_e1524 > _e1522));
                                                            if (_e1496 == _e1526) {
                                                                phi_2819_ = _e1332;
                                                                phi_2820_ = _e1329;
                                                                phi_2821_ = _e1323;
                                                                phi_2822_ = _e1320;
                                                                phi_2823_ = vec3<f32>(_e1301[0][0], _e1301[0][1], _e1301[0][2]);
                                                                phi_2824_ = _e1483;
                                                                phi_2825_ = _e1479;
                                                                phi_2826_ = _e1475;
                                                            } else {
                                                                let _e1528 = (_e1509 == _e1526);
                                                                let _e1533 = vec3(_e1528);
                                                                phi_2819_ = select(_e1323, _e1341, _e1528);
                                                                phi_2820_ = select(_e1320, _e1338, _e1528);
                                                                phi_2821_ = select(_e1341, _e1332, _e1528);
                                                                phi_2822_ = select(_e1338, _e1329, _e1528);
                                                                phi_2823_ = select(vec3<f32>(_e1301[2][0], _e1301[2][1], _e1301[2][2]), vec3<f32>(_e1301[1][0], _e1301[1][1], _e1301[1][2]), _e1533);
                                                                phi_2824_ = select(_e1479, _e1475, _e1533);
                                                                phi_2825_ = select(_e1475, _e1483, _e1533);
                                                                phi_2826_ = select(_e1483, _e1479, _e1533);
                                                            }
                                                            let _e1539 = phi_2819_;
                                                            let _e1541 = phi_2820_;
                                                            let _e1543 = phi_2821_;
                                                            let _e1545 = phi_2822_;
                                                            let _e1547 = phi_2823_;
                                                            let _e1549 = phi_2824_;
                                                            let _e1551 = phi_2825_;
                                                            let _e1553 = phi_2826_;
                                                            let _e1560 = ((_e1551.y * _e1549.z) - (_e1549.y * _e1551.z));
                                                            let _e1565 = ((_e1551.z * _e1549.x) - (_e1549.z * _e1551.x));
                                                            let _e1568 = ((_e1551.x * _e1549.y) - (_e1549.x * _e1551.y));
                                                            let _e1571 = ((_e1364 >= _e1368) && (_e1364 >= _e1372));
                                                            let _e1572 = (_e1368 >= _e1372);
                                                            let _e1586 = (((_e1560 * (select(select(_e1301[2][0], _e1301[1][0], _e1572), _e1301[0][0], _e1571) - _e484)) + (_e1565 * (select(select(_e1301[2][1], _e1301[1][1], _e1572), _e1301[0][1], _e1571) - _e549))) + (_e1568 * (select(select(_e1301[2][2], _e1301[1][2], _e1572), _e1301[0][2], _e1571) - _e613)));
                                                            let _e1591 = (((_e1560 * _e521) + (_e1565 * _e585)) + (_e1568 * _e649));
                                                            let _e1592 = (_e1541 - _e1545);
                                                            let _e1593 = (_e1539 - _e1543);
                                                            let _e1596 = ((_e1592 * _e1592) + (_e1593 * _e1593));
                                                            let _e1603 = (-(((_e1545 * _e1592) + (_e1543 * _e1593))) / select(0.000000000000000000000000000000000000011754944f, _e1596, (_e1596 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1605 = select(1f, _e1603, (_e1603 < 1f));
                                                            let _e1607 = select(0f, _e1605, (_e1605 > 0f));
                                                            let _e1616 = ((_e1547.x + (_e1553.x * _e1607)) - _e484);
                                                            let _e1619 = ((_e1547.y + (_e1553.y * _e1607)) - _e549);
                                                            let _e1622 = ((_e1547.z + (_e1553.z * _e1607)) - _e613);
                                                            let _e1625 = bitcast<f32>((bitcast<u32>(_e1616) & 2147483647u));
                                                            let _e1628 = bitcast<f32>((bitcast<u32>(_e1619) & 2147483647u));
                                                            let _e1630 = select(_e1628, _e1625, (_e1625 > _e1628));
                                                            let _e1633 = bitcast<f32>((bitcast<u32>(_e1622) & 2147483647u));
                                                            let _e1635 = select(_e1633, _e1630, (_e1630 > _e1633));
                                                            let _e1639 = abs(_e1560);
                                                            let _e1640 = abs(_e1565);
                                                            if (_e1639 != _e1639) {
                                                                phi_4867_ = true;
                                                            } else {
                                                                phi_4867_ = (_e1640 >= _e1639);
                                                            }
                                                            let _e1644 = phi_4867_;
                                                            let _e1645 = select(_e1639, _e1640, _e1644);
                                                            let _e1646 = abs(_e1568);
                                                            if (_e1645 != _e1645) {
                                                                phi_4882_ = true;
                                                            } else {
                                                                phi_4882_ = (_e1646 >= _e1645);
                                                            }
                                                            let _e1650 = phi_4882_;
                                                            let _e1666 = abs(_e1551.x);
                                                            let _e1667 = abs(_e1551.y);
                                                            if (_e1666 != _e1666) {
                                                                phi_4897_ = true;
                                                            } else {
                                                                phi_4897_ = (_e1667 >= _e1666);
                                                            }
                                                            let _e1671 = phi_4897_;
                                                            let _e1672 = select(_e1666, _e1667, _e1671);
                                                            let _e1673 = abs(_e1551.z);
                                                            if (_e1672 != _e1672) {
                                                                phi_4912_ = true;
                                                            } else {
                                                                phi_4912_ = (_e1673 >= _e1672);
                                                            }
                                                            let _e1677 = phi_4912_;
                                                            let _e1680 = abs(_e1549.x);
                                                            let _e1681 = abs(_e1549.y);
                                                            if (_e1680 != _e1680) {
                                                                phi_4927_ = true;
                                                            } else {
                                                                phi_4927_ = (_e1681 >= _e1680);
                                                            }
                                                            let _e1685 = phi_4927_;
                                                            let _e1686 = select(_e1680, _e1681, _e1685);
                                                            let _e1687 = abs(_e1549.z);
                                                            if (_e1686 != _e1686) {
                                                                phi_4942_ = true;
                                                            } else {
                                                                phi_4942_ = (_e1687 >= _e1686);
                                                            }
                                                            let _e1691 = phi_4942_;
                                                            let _e1696 = ((bitcast<f32>((bitcast<u32>(((((_e1560 * _e1616) + (_e1565 * _e1619)) + (_e1568 * _e1622)) - _e1586)) & 2147483647u)) <= ((0.0000009536743f * select(_e1526, _e1635, (_e1635 > _e1526))) * select(_e1645, _e1646, _e1650))) && !((bitcast<f32>((bitcast<u32>(_e1591) & 2147483647u)) <= ((0.0000038146973f * select(_e1672, _e1673, _e1677)) * select(_e1686, _e1687, _e1691)))));
                                                            let _e1697 = (_e1586 / _e1591);
                                                            if (_e1467 && !(_e1696)) {
                                                                let _e1700 = (_e1622 / _e649);
                                                                let _e1708 = (((_e1560 * (_e1616 - (_e521 * _e1700))) + (_e1565 * (_e1619 - (_e585 * _e1700)))) / _e1591);
                                                                phi_3034_ = select(select(_e1700, (_e1700 + _e1708), (bitcast<f32>((bitcast<u32>(_e1708) & 2147483647u)) <= _e1526)), _e1697, _e1696);
                                                            } else {
                                                                phi_3034_ = _e1697;
                                                            }
                                                            let _e1717 = phi_3034_;
                                                            let _e1719 = select(_e1430, _e1717, (_e1717 < _e1430));
                                                            let _e1721 = select(_e1422, _e1719, (_e1719 > _e1422));
                                                            let _e1722 = (1f / _e1374);
                                                            phi_3054_ = type_42(_e1721, (_e1368 * _e1722), (_e1372 * _e1722), ((_e1467 && (_e1721 >= _e755)) && (_e1721 <= _e854.member)));
                                                            phi_3055_ = type_42();
                                                        } else {
                                                            phi_3054_ = type_42();
                                                            phi_3055_ = type_42(0f, 0f, 0f, _e1467);
                                                        }
                                                        let _e1731 = phi_3054_;
                                                        let _e1733 = phi_3055_;
                                                        phi_3058_ = _e1731;
                                                        phi_3059_ = _e1733;
                                                        phi_3060_ = select(true, false, _e1467);
                                                    } else {
                                                        phi_3058_ = type_42();
                                                        phi_3059_ = type_42(0f, 0f, 0f, _e1358);
                                                        phi_3060_ = true;
                                                    }
                                                    let _e1736 = phi_3058_;
                                                    let _e1738 = phi_3059_;
                                                    let _e1740 = phi_3060_;
                                                    if _e1740 {
                                                        phi_3064_ = _e1738;
                                                    } else {
                                                        phi_3064_ = _e1736;
                                                    }
                                                    let _e1742 = phi_3064_;
                                                    if _e1742.member_3 {
                                                        phi_3073_ = type_21(_e1742.member, _e1742.member_1, _e1742.member_2, _e914);
                                                    } else {
                                                        phi_3073_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1749 = phi_3073_;
                                                    if (_e1749.member_3 != 4294967295u) {
                                                        if (_e914 == _e172) {
                                                            phi_3408_ = false;
                                                        } else {
                                                            let _e1753 = (_e914 < arrayLength((&global_5.member)));
                                                            if _e1753 {
                                                                if _e1753 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1755 = global_5.member[_e914];
                                                                phi_3096_ = _e1755;
                                                            } else {
                                                                phi_3096_ = 4294967295u;
                                                            }
                                                            let _e1757 = phi_3096_;
                                                            let _e1758 = (_e1757 < arrayLength((&global_6.member)));
                                                            if _e1758 {
                                                                if _e1758 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1760 = global_6.member[_e1757];
                                                                phi_3110_ = _e1760;
                                                            } else {
                                                                phi_3110_ = 0i;
                                                            }
                                                            let _e1762 = phi_3110_;
                                                            let _e1763 = (_e1762 == 0i);
                                                            if _e1763 {
                                                                phi_3407_ = true;
                                                            } else {
                                                                if _e461 {
                                                                    phi_3133_ = vec3<f32>(_e1301[0][0], _e1301[0][1], _e1301[0][2]);
                                                                } else {
                                                                    if (_e437 == 1u) {
                                                                        phi_3132_ = vec3<f32>(_e1301[0][2], _e1301[0][0], _e1301[0][1]);
                                                                    } else {
                                                                        phi_3132_ = vec3<f32>(_e1301[0][1], _e1301[0][2], _e1301[0][0]);
                                                                    }
                                                                    let _e1768 = phi_3132_;
                                                                    phi_3133_ = _e1768;
                                                                }
                                                                let _e1771 = phi_3133_;
                                                                if _e461 {
                                                                    phi_3152_ = vec3<f32>(_e1301[1][0], _e1301[1][1], _e1301[1][2]);
                                                                } else {
                                                                    if (_e437 == 1u) {
                                                                        phi_3151_ = vec3<f32>(_e1301[1][2], _e1301[1][0], _e1301[1][1]);
                                                                    } else {
                                                                        phi_3151_ = vec3<f32>(_e1301[1][1], _e1301[1][2], _e1301[1][0]);
                                                                    }
                                                                    let _e1776 = phi_3151_;
                                                                    phi_3152_ = _e1776;
                                                                }
                                                                let _e1779 = phi_3152_;
                                                                if _e461 {
                                                                    phi_3171_ = vec3<f32>(_e1301[2][0], _e1301[2][1], _e1301[2][2]);
                                                                } else {
                                                                    if (_e437 == 1u) {
                                                                        phi_3170_ = vec3<f32>(_e1301[2][2], _e1301[2][0], _e1301[2][1]);
                                                                    } else {
                                                                        phi_3170_ = vec3<f32>(_e1301[2][1], _e1301[2][2], _e1301[2][0]);
                                                                    }
                                                                    let _e1784 = phi_3170_;
                                                                    phi_3171_ = _e1784;
                                                                }
                                                                let _e1787 = phi_3171_;
                                                                let _e1790 = (_e1779.x - _e1771.x);
                                                                let _e1793 = (_e1779.y - _e1771.y);
                                                                let _e1796 = (_e1779.z - _e1771.z);
                                                                let _e1798 = (_e1787.x - _e1771.x);
                                                                let _e1800 = (_e1787.y - _e1771.y);
                                                                let _e1802 = (_e1787.z - _e1771.z);
                                                                if (_e304.member_1 == 1u) {
                                                                    phi_3207_ = (vec3<f32>(_e304.member[0], _e304.member[1], _e304.member[2]) - _e1771);
                                                                } else {
                                                                    phi_3207_ = vec3<f32>(_e304.member[0], _e304.member[1], _e304.member[2]);
                                                                }
                                                                let _e1817 = phi_3207_;
                                                                let _e1823 = bitcast<f32>((bitcast<u32>((_e1790 * _e1800)) ^ _e304.member_3[0]));
                                                                let _e1827 = bitcast<f32>((bitcast<u32>((_e1793 * _e1798)) ^ _e304.member_3[0]));
                                                                let _e1831 = bitcast<f32>((bitcast<u32>((_e1793 * _e1802)) ^ _e304.member_3[0]));
                                                                let _e1835 = bitcast<f32>((bitcast<u32>((_e1796 * _e1800)) ^ _e304.member_3[0]));
                                                                let _e1839 = bitcast<f32>((bitcast<u32>((_e1796 * _e1798)) ^ _e304.member_3[0]));
                                                                let _e1843 = bitcast<f32>((bitcast<u32>((_e1790 * _e1802)) ^ _e304.member_3[0]));
                                                                let _e1844 = (_e1831 - _e1835);
                                                                let _e1845 = (_e1839 - _e1843);
                                                                let _e1846 = (_e1823 - _e1827);
                                                                let _e1870 = (bitcast<f32>((bitcast<u32>(_e1831) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1835) & 2147483647u)));
                                                                let _e1877 = (bitcast<f32>((bitcast<u32>(_e1839) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1843) & 2147483647u)));
                                                                let _e1884 = (bitcast<f32>((bitcast<u32>(_e1823) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1827) & 2147483647u)));
                                                                if (_e304.member_2 == 0f) {
                                                                    phi_3389_ = 0f;
                                                                } else {
                                                                    let _e1914 = bitcast<f32>((bitcast<u32>(_e1844) & 2147483647u));
                                                                    let _e1917 = bitcast<f32>((bitcast<u32>(_e1845) & 2147483647u));
                                                                    let _e1920 = bitcast<f32>((bitcast<u32>(_e1846) & 2147483647u));
                                                                    let _e1922 = select(_e1920, _e1917, (_e1917 > _e1920));
                                                                    let _e1926 = select(_e1920, _e1917, (_e1917 < _e1920));
                                                                    let _e1930 = select(_e1917, _e1914, (_e1914 < _e1917));
                                                                    let _e1932 = select(_e1917, _e1914, (_e1914 > _e1917));
                                                                    let _e1934 = select(_e1920, _e1932, (_e1932 < _e1920));
                                                                    phi_3389_ = bitcast<f32>((bitcast<u32>((_e304.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1922, _e1914, (_e1914 > _e1922)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1934, _e1930, (_e1930 > _e1934)))) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1926, _e1914, (_e1914 < _e1926)))) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1870 + _e1877) + _e1884))) ^ _e304.member_3[0]))) * 1.0000005f)) ^ _e304.member_3[0])))) ^ _e304.member_3[0]));
                                                                }
                                                                let _e1961 = phi_3389_;
                                                                phi_3407_ = (_e1763 || !(((((bitcast<f32>((bitcast<u32>((_e1817.x * _e1844)) ^ _e304.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1817.y * _e1845)) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1817.z * _e1846)) ^ _e304.member_3[0]))) * f32(-(_e1762))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1817.x) & 2147483647u)) * _e1870)) ^ _e304.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1817.y) & 2147483647u)) * _e1877)) ^ _e304.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1817.z) & 2147483647u)) * _e1884)) ^ _e304.member_3[0]))))) ^ _e304.member_3[0])) + _e1961) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1975 = phi_3407_;
                                                            phi_3408_ = _e1975;
                                                        }
                                                        let _e1977 = phi_3408_;
                                                        if _e1977 {
                                                            phi_3413_ = type_43(-340282350000000000000000000000000000000f, true);
                                                        } else {
                                                            phi_3413_ = _e854;
                                                        }
                                                        let _e1979 = phi_3413_;
                                                        phi_3414_ = _e1979;
                                                    } else {
                                                        phi_3414_ = _e854;
                                                    }
                                                    let _e1981 = phi_3414_;
                                                    phi_1514_ = _e1981;
                                                } else {
                                                    phi_1514_ = type_43();
                                                }
                                                let _e1983 = phi_1514_;
                                                continue;
                                                continuing {
                                                    phi_1513_ = _e1983;
                                                    phi_1516_ = _e869;
                                                    phi_5136_ = _e797;
                                                    break if !(_e875);
                                                }
                                            }
                                            let _e1986 = phi_5136_;
                                            phi_5380_ = _e1986;
                                            if _e1986 {
                                                break;
                                            }
                                            phi_5471_ = _e1986;
                                            let _e2679 = local_11;
                                            phi_3415_ = _e2679;
                                        } else {
                                            phi_5471_ = _e797;
                                            phi_3415_ = _e799;
                                        }
                                        let _e1988 = phi_5471_;
                                        let _e1990 = phi_3415_;
                                        if _e846 {
                                            phi_4680_ = bool();
                                            phi_4681_ = u32();
                                            phi_4682_ = type_59();
                                        } else {
                                            if (_e842.member_1 >= _e104) {
                                                phi_4216_ = type_60(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_59(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_59(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e842.member_1 < _e104) {
                                                } else {
                                                    phi_5380_ = true;
                                                    break;
                                                }
                                                let _e1993 = (_e437 * 2u);
                                                let _e1995 = ((1u + _e1993) % 7u);
                                                if (_e1995 < 7u) {
                                                } else {
                                                    phi_5380_ = true;
                                                    break;
                                                }
                                                let _e2000 = global_8.member[_e842.member_1][_e1995];
                                                let _e2002 = ((_e1993 + 2u) % 7u);
                                                if (_e2002 < 7u) {
                                                } else {
                                                    phi_5380_ = true;
                                                    break;
                                                }
                                                let _e2007 = global_8.member[_e842.member_1][_e2002];
                                                let _e2008 = (_e436 * 2u);
                                                let _e2010 = ((1u + _e2008) % 7u);
                                                if (_e2010 < 7u) {
                                                } else {
                                                    phi_5380_ = true;
                                                    break;
                                                }
                                                let _e2015 = global_8.member[_e842.member_1][_e2010];
                                                let _e2017 = ((_e2008 + 2u) % 7u);
                                                if (_e2017 < 7u) {
                                                } else {
                                                    phi_5380_ = true;
                                                    break;
                                                }
                                                let _e2022 = global_8.member[_e842.member_1][_e2017];
                                                let _e2023 = (_e438 * 2u);
                                                let _e2025 = ((1u + _e2023) % 7u);
                                                if (_e2025 < 7u) {
                                                } else {
                                                    phi_5380_ = true;
                                                    break;
                                                }
                                                let _e2030 = global_8.member[_e842.member_1][_e2025];
                                                let _e2032 = ((_e2023 + 2u) % 7u);
                                                if (_e2032 < 7u) {
                                                } else {
                                                    phi_5380_ = true;
                                                    break;
                                                }
                                                let _e2037 = global_8.member[_e842.member_1][_e2032];
                                                let _e2060 = (bitcast<f32>((bitcast<u32>((_e842.member.member_1.x - _e842.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e2061 = (bitcast<f32>((bitcast<u32>((_e842.member.member_1.y - _e842.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e2062 = (bitcast<f32>((bitcast<u32>((_e842.member.member_1.z - _e842.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e2064 = select(_e163, _e2060, (_e2060 > _e163));
                                                let _e2066 = select(_e163, _e2061, (_e2061 > _e163));
                                                let _e2068 = select(_e163, _e2062, (_e2062 > _e163));
                                                let _e2099 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2000 & 2097151u))) - 8388608f) * _e2064));
                                                let _e2104 = (bitcast<i32>((_e2000 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e2107 = bitcast<f32>((_e2099 & bitcast<u32>(_e2104)));
                                                let _e2108 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2015 & 2097151u))) - 8388608f) * _e2066));
                                                let _e2113 = (bitcast<i32>((_e2015 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e2116 = bitcast<f32>((_e2108 & bitcast<u32>(_e2113)));
                                                let _e2117 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2030 & 2097151u))) - 8388608f) * _e2068));
                                                let _e2122 = (bitcast<i32>((_e2030 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e2125 = bitcast<f32>((_e2117 & bitcast<u32>(_e2122)));
                                                let _e2129 = bitcast<f32>((_e2099 & bitcast<u32>(~(_e2104))));
                                                let _e2133 = bitcast<f32>((_e2108 & bitcast<u32>(~(_e2113))));
                                                let _e2137 = bitcast<f32>((_e2117 & bitcast<u32>(~(_e2122))));
                                                let _e2138 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2007 & 2097151u))) - 8388608f) * _e2064));
                                                let _e2143 = (bitcast<i32>((_e2007 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e2146 = bitcast<f32>((_e2138 & bitcast<u32>(_e2143)));
                                                let _e2147 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2022 & 2097151u))) - 8388608f) * _e2066));
                                                let _e2152 = (bitcast<i32>((_e2022 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e2155 = bitcast<f32>((_e2147 & bitcast<u32>(_e2152)));
                                                let _e2156 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2037 & 2097151u))) - 8388608f) * _e2068));
                                                let _e2161 = (bitcast<i32>((_e2037 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e2164 = bitcast<f32>((_e2156 & bitcast<u32>(_e2161)));
                                                let _e2168 = bitcast<f32>((_e2138 & bitcast<u32>(~(_e2143))));
                                                let _e2172 = bitcast<f32>((_e2147 & bitcast<u32>(~(_e2152))));
                                                let _e2176 = bitcast<f32>((_e2156 & bitcast<u32>(~(_e2161))));
                                                let _e2177 = (_e842.member.member.x + _e2107);
                                                let _e2178 = (_e842.member.member.y + _e2116);
                                                let _e2179 = (_e842.member.member.z + _e2125);
                                                let _e2182 = (_e842.member.member_1.x - _e2146);
                                                let _e2183 = (_e842.member.member_1.y - _e2155);
                                                let _e2184 = (_e842.member.member_1.z - _e2164);
                                                let _e2203 = (_e2182 - _e2177);
                                                let _e2204 = (_e2183 - _e2178);
                                                let _e2205 = (_e2184 - _e2179);
                                                let _e2207 = select(_e2204, _e2203, (_e2203 > _e2204));
                                                let _e2209 = select(_e2205, _e2207, (_e2207 > _e2205));
                                                if (_e2209 < (1024f * _e163)) {
                                                    phi_3917_ = 0u;
                                                } else {
                                                    phi_3917_ = select(2u, 1u, (_e2209 < (2097152f * _e163)));
                                                }
                                                let _e2216 = phi_3917_;
                                                switch bitcast<i32>(_e2216) {
                                                    case 0: {
                                                        phi_3923_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3923_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3923_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3923_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e2219 = phi_3923_;
                                                let _e2225 = global_8.member[_e842.member_1][0u];
                                                let _e2229 = global_8.member[_e842.member_1][2u];
                                                let _e2233 = global_8.member[_e842.member_1][4u];
                                                let _e2237 = global_8.member[_e842.member_1][6u];
                                                let _e2249 = (((_e2229 >> bitcast<u32>(22i)) | ((_e2233 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e2237 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e2250 = (_e2225 & 268435455u);
                                                let _e2251 = (_e2249 & 268435455u);
                                                let _e2254 = ((_e2225 >> bitcast<u32>(28u)) & 7u);
                                                let _e2262 = ((_e2225 >> bitcast<u32>(31i)) | (((_e2249 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e2263 = (_e2254 != 0u);
                                                if (_e2254 == 0u) {
                                                    phi_4178_ = _e2250;
                                                } else {
                                                    if (_e2254 == 7u) {
                                                        phi_4177_ = 2147483648u;
                                                    } else {
                                                        phi_4177_ = ((2147483648u | (_e2254 << bitcast<u32>(28u))) | (_e2251 & 268435455u));
                                                    }
                                                    let _e2272 = phi_4177_;
                                                    phi_4178_ = _e2272;
                                                }
                                                let _e2274 = phi_4178_;
                                                if _e2263 {
                                                    let _e2275 = (_e2254 != 7u);
                                                    if _e2275 {
                                                        phi_4188_ = (_e2251 + (_e2254 * ((3u * _e2219) + 1u)));
                                                    } else {
                                                        phi_4188_ = u32();
                                                    }
                                                    let _e2279 = phi_4188_;
                                                    phi_4190_ = _e2279;
                                                    phi_4191_ = select(true, false, _e2275);
                                                } else {
                                                    phi_4190_ = u32();
                                                    phi_4191_ = true;
                                                }
                                                let _e2282 = phi_4190_;
                                                let _e2284 = phi_4191_;
                                                if (_e2262 == 0u) {
                                                    phi_4212_ = (_e2250 + select(0u, 1u, !(_e2263)));
                                                } else {
                                                    if (_e2262 == 7u) {
                                                        phi_4211_ = 2147483648u;
                                                    } else {
                                                        phi_4211_ = ((2147483648u | (_e2262 << bitcast<u32>(28u))) | (select(_e2282, _e2251, _e2284) & 268435455u));
                                                    }
                                                    let _e2297 = phi_4211_;
                                                    phi_4212_ = _e2297;
                                                }
                                                let _e2299 = phi_4212_;
                                                phi_4216_ = type_60(array<vec4<f32>, 3>(vec4<f32>(_e2177, (_e842.member.member.x + _e2129), _e2182, (_e842.member.member_1.x - _e2168)), vec4<f32>(_e2178, (_e842.member.member.y + _e2133), _e2183, (_e842.member.member_1.y - _e2172)), vec4<f32>(_e2179, (_e842.member.member.z + _e2137), _e2184, (_e842.member.member_1.z - _e2176))), type_59(type_30((_e842.member.member + vec4<f32>(_e2107, _e2116, _e2125, 0f)), (_e842.member.member_1 - vec4<f32>(_e2146, _e2155, _e2164, 0f))), _e2274), type_59(type_30((_e842.member.member + vec4<f32>(_e2129, _e2133, _e2137, 0f)), (_e842.member.member_1 - vec4<f32>(_e2168, _e2172, _e2176, 0f))), _e2299));
                                            }
                                            let _e2304 = phi_4216_;
                                            let _e2316 = ((_e2304.member[0].x - _e522) * _e525);
                                            let _e2317 = ((_e2304.member[0].y - _e522) * _e525);
                                            let _e2318 = ((_e2304.member[0].z - _e523) * _e525);
                                            let _e2319 = ((_e2304.member[0].w - _e523) * _e525);
                                            let _e2329 = ((_e2304.member[1].x - _e586) * _e589);
                                            let _e2330 = ((_e2304.member[1].y - _e586) * _e589);
                                            let _e2331 = ((_e2304.member[1].z - _e587) * _e589);
                                            let _e2332 = ((_e2304.member[1].w - _e587) * _e589);
                                            let _e2342 = ((_e2304.member[2].x - _e650) * _e653);
                                            let _e2343 = ((_e2304.member[2].y - _e650) * _e653);
                                            let _e2344 = ((_e2304.member[2].z - _e651) * _e653);
                                            let _e2345 = ((_e2304.member[2].w - _e651) * _e653);
                                            let _e2347 = select(_e2344, _e2342, (_e2342 < _e2344));
                                            let _e2349 = select(_e2345, _e2343, (_e2343 < _e2345));
                                            let _e2351 = select(_e2344, _e2342, (_e2342 > _e2344));
                                            let _e2353 = select(_e2345, _e2343, (_e2343 > _e2345));
                                            let _e2355 = select(_e2318, _e2316, (_e2316 < _e2318));
                                            let _e2357 = select(_e2319, _e2317, (_e2317 < _e2319));
                                            let _e2359 = select(_e2331, _e2329, (_e2329 < _e2331));
                                            let _e2361 = select(_e2332, _e2330, (_e2330 < _e2332));
                                            let _e2363 = select(_e2359, _e2355, (_e2355 > _e2359));
                                            let _e2365 = select(_e2361, _e2357, (_e2357 > _e2361));
                                            let _e2367 = select(_e2347, _e2363, (_e2363 > _e2347));
                                            let _e2369 = select(_e2349, _e2365, (_e2365 > _e2349));
                                            let _e2371 = select(_e2318, _e2316, (_e2316 > _e2318));
                                            let _e2373 = select(_e2319, _e2317, (_e2317 > _e2319));
                                            let _e2375 = select(_e2331, _e2329, (_e2329 > _e2331));
                                            let _e2377 = select(_e2332, _e2330, (_e2330 > _e2332));
                                            let _e2379 = select(_e2375, _e2371, (_e2371 < _e2375));
                                            let _e2381 = select(_e2377, _e2373, (_e2373 < _e2377));
                                            let _e2386 = -(_e2347);
                                            let _e2387 = -(_e2349);
                                            let _e2394 = (select(_e2351, _e2379, (_e2379 < _e2351)) + (select(_e2386, _e2351, (_e2351 > _e2386)) * 0.0000019073523f));
                                            let _e2395 = (select(_e2353, _e2381, (_e2381 < _e2353)) + (select(_e2387, _e2353, (_e2353 > _e2387)) * 0.0000019073523f));
                                            let _e2397 = select(_e755, _e2367, (_e2367 > _e755));
                                            let _e2399 = select(_e755, _e2369, (_e2369 > _e755));
                                            let _e2404 = (_e2397 <= select(_e1990.member, _e2394, (_e2394 < _e1990.member)));
                                            let _e2405 = (_e2399 <= select(_e1990.member, _e2395, (_e2395 < _e1990.member)));
                                            let _e2406 = (_e2397 <= _e2399);
                                            if _e2404 {
                                                if _e2405 {
                                                    if _e2406 {
                                                        phi_4578_ = _e2304.member_2;
                                                    } else {
                                                        phi_4578_ = _e2304.member_1;
                                                    }
                                                    let _e2410 = phi_4578_;
                                                    let _e2431 = (_e840 % 128u);
                                                    let _e2432 = (_e2431 < 128u);
                                                    if _e2432 {
                                                    } else {
                                                        phi_5380_ = true;
                                                        break;
                                                    }
                                                    local_8[_e2431] = _e2410.member_1;
                                                    if _e2432 {
                                                    } else {
                                                        phi_5380_ = true;
                                                        break;
                                                    }
                                                    local_7[_e2431] = _e2410.member.member.x;
                                                    if _e2432 {
                                                    } else {
                                                        phi_5380_ = true;
                                                        break;
                                                    }
                                                    local_6[_e2431] = _e2410.member.member.y;
                                                    if _e2432 {
                                                    } else {
                                                        phi_5380_ = true;
                                                        break;
                                                    }
                                                    local_5[_e2431] = _e2410.member.member.z;
                                                    if _e2432 {
                                                    } else {
                                                        phi_5380_ = true;
                                                        break;
                                                    }
                                                    local_4[_e2431] = _e2410.member.member_1.x;
                                                    if _e2432 {
                                                    } else {
                                                        phi_5380_ = true;
                                                        break;
                                                    }
                                                    local_3[_e2431] = _e2410.member.member_1.y;
                                                    if _e2432 {
                                                    } else {
                                                        phi_5380_ = true;
                                                        break;
                                                    }
                                                    local_2[_e2431] = _e2410.member.member_1.z;
                                                    if _e2432 {
                                                    } else {
                                                        phi_5380_ = true;
                                                        break;
                                                    }
                                                    local_9[_e2431] = select(_e2397, _e2399, _e2406);
                                                    if _e2406 {
                                                        phi_4654_ = _e2304.member_1;
                                                    } else {
                                                        phi_4654_ = _e2304.member_2;
                                                    }
                                                    let _e2445 = phi_4654_;
                                                    phi_4655_ = (_e840 + 1u);
                                                    phi_4656_ = _e2445;
                                                } else {
                                                    phi_4655_ = u32();
                                                    phi_4656_ = type_59();
                                                }
                                                let _e2447 = phi_4655_;
                                                let _e2449 = phi_4656_;
                                                phi_4658_ = _e2447;
                                                phi_4659_ = _e2449;
                                                phi_4660_ = select(true, false, _e2405);
                                            } else {
                                                phi_4658_ = u32();
                                                phi_4659_ = type_59();
                                                phi_4660_ = true;
                                            }
                                            let _e2452 = phi_4658_;
                                            let _e2454 = phi_4659_;
                                            let _e2456 = phi_4660_;
                                            if _e2456 {
                                                if _e2404 {
                                                    phi_4669_ = _e2304.member_1;
                                                } else {
                                                    phi_4669_ = _e2304.member_2;
                                                }
                                                let _e2460 = phi_4669_;
                                                phi_4674_ = select(_e2405, true, _e2404);
                                                phi_4676_ = _e2460;
                                            } else {
                                                phi_4674_ = _e838;
                                                phi_4676_ = _e2454;
                                            }
                                            let _e2463 = phi_4674_;
                                            let _e2465 = phi_4676_;
                                            phi_4680_ = _e2463;
                                            phi_4681_ = select(_e2452, _e840, _e2456);
                                            phi_4682_ = _e2465;
                                        }
                                        let _e2468 = phi_4680_;
                                        let _e2470 = phi_4681_;
                                        let _e2472 = phi_4682_;
                                        if _e846 {
                                            phi_4692_ = select(_e840, 0u, _e1990.member_1);
                                            phi_4693_ = _e842;
                                        } else {
                                            phi_4692_ = _e2470;
                                            phi_4693_ = _e2472;
                                        }
                                        let _e2476 = phi_4692_;
                                        let _e2478 = phi_4693_;
                                        phi_5383_ = _e1988;
                                        phi_4694_ = _e1990;
                                        phi_4695_ = (_e801 - 1u);
                                        phi_4696_ = select(_e2468, false, _e846);
                                        phi_4697_ = _e2476;
                                        phi_4698_ = _e2478;
                                    } else {
                                        phi_5383_ = _e797;
                                        phi_4694_ = _e799;
                                        phi_4695_ = _e801;
                                        phi_4696_ = _e838;
                                        phi_4697_ = _e840;
                                        phi_4698_ = _e842;
                                    }
                                    let _e2481 = phi_5383_;
                                    let _e2483 = phi_4694_;
                                    let _e2485 = phi_4695_;
                                    let _e2487 = phi_4696_;
                                    let _e2489 = phi_4697_;
                                    let _e2491 = phi_4698_;
                                    phi_5382_ = _e2481;
                                    phi_4699_ = _e2483;
                                    phi_4700_ = _e2485;
                                    phi_4701_ = _e2487;
                                    phi_4702_ = _e2489;
                                    phi_4703_ = _e2491;
                                } else {
                                    phi_5382_ = _e797;
                                    phi_4699_ = type_43();
                                    phi_4700_ = u32();
                                    phi_4701_ = bool();
                                    phi_4702_ = u32();
                                    phi_4703_ = type_59();
                                }
                                let _e2493 = phi_5382_;
                                let _e2495 = phi_4699_;
                                let _e2497 = phi_4700_;
                                let _e2499 = phi_4701_;
                                let _e2501 = phi_4702_;
                                let _e2503 = phi_4703_;
                                phi_5381_ = _e2493;
                                phi_1387_ = _e2495;
                                phi_1390_ = _e2497;
                                phi_1392_ = _e2499;
                                phi_1394_ = _e2501;
                                phi_1396_ = _e2503;
                                phi_4704_ = _e811;
                            } else {
                                phi_5381_ = _e797;
                                phi_1387_ = type_43();
                                phi_1390_ = u32();
                                phi_1392_ = bool();
                                phi_1394_ = u32();
                                phi_1396_ = type_59();
                                phi_4704_ = false;
                            }
                            let _e2505 = phi_5381_;
                            let _e2507 = phi_1387_;
                            let _e2509 = phi_1390_;
                            let _e2511 = phi_1392_;
                            let _e2513 = phi_1394_;
                            let _e2515 = phi_1396_;
                            let _e2517 = phi_4704_;
                            continue;
                            continuing {
                                phi_5142_ = _e2505;
                                phi_1386_ = _e2507;
                                phi_1389_ = _e2509;
                                phi_1391_ = _e2511;
                                phi_1393_ = _e2513;
                                phi_1395_ = _e2515;
                                phi_5380_ = _e2505;
                                break if !(_e2517);
                            }
                        }
                        let _e2520 = phi_5380_;
                        if _e2520 {
                            break;
                        }
                        let _e2522 = local_10;
                        if _e2522.member_1 {
                        } else {
                            if _e305 {
                            } else {
                                break;
                            }
                            let _e2526 = global_2.member[_e151];
                            if _e166 {
                            } else {
                                break;
                            }
                            let _e2530 = global_9.member[_e151].member_1;
                            if _e305 {
                            } else {
                                break;
                            }
                            global_2.member[_e151] = type_23(_e2526.member, _e2526.member_1, _e2526.member_2, array<f32, 3>((_e2526.member_3[0] + (_e2530[0] * _e2526.member_1[0])), (_e2526.member_3[1] + (_e2530[1] * _e2526.member_1[1])), (_e2526.member_3[2] + (_e2530[2] * _e2526.member_1[2]))), _e2526.member_4);
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
fn trace_shadows_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
