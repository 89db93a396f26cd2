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

struct type_35 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_40 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_46 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_47 {
    member: f32,
    member_1: bool,
}

struct type_49 {
    member: array<vec4<u32>, 2>,
}

struct type_52 {
    member: array<i32>,
}

struct type_59 {
    member: type_34,
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
var<uniform> global_1: type_16;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_29;
@group(0) @binding(1) 
var<uniform> global_3: type_49;
@group(0) @binding(2) 
var<uniform> global_4: type_49;
@group(0) @binding(3) 
var<storage> global_5: type_13;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_52;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_65;
@group(0) @binding(7) 
var<storage> global_9: type_37;
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
    var phi_547_: type_40;
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
    var phi_1386_: type_47;
    var phi_1389_: u32;
    var phi_1391_: bool;
    var phi_1393_: u32;
    var phi_1395_: type_59;
    var phi_1406_: bool;
    var phi_1492_: bool;
    var phi_1493_: u32;
    var phi_1494_: type_59;
    var phi_1513_: type_47;
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
    var phi_3054_: type_46;
    var phi_3055_: type_46;
    var phi_3058_: type_46;
    var phi_3059_: type_46;
    var phi_3060_: bool;
    var phi_3064_: type_46;
    var phi_3073_: type_25;
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
    var phi_3413_: type_47;
    var phi_3414_: type_47;
    var phi_1514_: type_47;
    var phi_5136_: bool;
    var phi_5471_: bool;
    var phi_3415_: type_47;
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
    var phi_4694_: type_47;
    var phi_4695_: u32;
    var phi_4696_: bool;
    var phi_4697_: u32;
    var phi_4698_: type_59;
    var phi_5382_: bool;
    var phi_4699_: type_47;
    var phi_4700_: u32;
    var phi_4701_: bool;
    var phi_4702_: u32;
    var phi_4703_: type_59;
    var phi_5381_: bool;
    var phi_1387_: type_47;
    var phi_1390_: u32;
    var phi_1392_: bool;
    var phi_1394_: u32;
    var phi_1396_: type_59;
    var phi_4704_: bool;
    var phi_5380_: bool;
    var local_10: type_47;
    var local_11: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e105 = global;
            let _e107 = arrayLength((&global_5.member));
            let _e110 = arrayLength((&global_10.member));
            let _e122 = arrayLength((&global_8.member));
            let _e126 = global_4.member[0u][0u];
            let _e130 = global_4.member[0u][1u];
            let _e134 = global_4.member[0u][2u];
            let _e138 = global_4.member[0u][3u];
            let _e142 = global_4.member[1u][0u];
            let _e146 = global_4.member[1u][1u];
            let _e150 = global_4.member[1u][2u];
            let _e154 = (_e105.x + (_e105.y * 2097152u));
            let _e166 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e138) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e126), bitcast<i32>(_e130), bitcast<i32>(_e134));
            local = array<i32, 3>(bitcast<i32>(_e142), bitcast<i32>(_e146), bitcast<i32>(_e150));
            let _e169 = (_e154 < arrayLength((&global_9.member)));
            if _e169 {
                if _e169 {
                } else {
                    break;
                }
                let _e173 = global_9.member[_e154].member_2;
                phi_363_ = _e173;
            } else {
                phi_363_ = 4294967295u;
            }
            let _e175 = phi_363_;
            let _e178 = global_1.member[0u];
            let _e182 = global_3.member[0u][0u];
            let _e186 = global_3.member[0u][1u];
            let _e190 = global_3.member[0u][2u];
            let _e194 = global_3.member[0u][3u];
            let _e198 = global_3.member[1u][0u];
            let _e202 = global_3.member[1u][1u];
            let _e206 = global_3.member[1u][2u];
            let _e210 = global_3.member[1u][3u];
            let _e211 = bitcast<f32>(_e182);
            let _e212 = bitcast<f32>(_e186);
            let _e213 = bitcast<f32>(_e190);
            let _e215 = bitcast<f32>(_e198);
            let _e216 = array<u32, 3>(_e202, _e206, _e210);
            let _e218 = bitcast<i32>(_e178);
            if (_e218 < -126i) {
                phi_407_ = -126i;
            } else {
                phi_407_ = select(_e218, 127i, (_e218 > 127i));
            }
            let _e223 = phi_407_;
            let _e228 = bitcast<f32>((bitcast<u32>((_e223 + 127i)) << bitcast<u32>(23i)));
            let _e234 = bitcast<f32>((bitcast<u32>(((_e218 - _e223) + 127i)) << bitcast<u32>(23i)));
            if (_e194 == 0u) {
                phi_547_ = type_40(array<f32, 3>(_e211, _e212, _e213), _e194, _e215, _e216);
            } else {
                let _e236 = bitcast<u32>(_e211);
                let _e238 = ((_e236 & 2139095040u) != 0u);
                let _e253 = bitcast<u32>(_e212);
                let _e255 = ((_e253 & 2139095040u) != 0u);
                let _e270 = bitcast<u32>(_e213);
                let _e272 = ((_e270 & 2139095040u) != 0u);
                let _e288 = bitcast<u32>(_e215);
                let _e290 = ((_e288 & 2139095040u) != 0u);
                phi_547_ = type_40(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e236 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e236 & 2147483648u))), _e211, _e238) * _e228) * select(0.00000011920929f, 1f, _e238)) * _e234), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e253 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e253 & 2147483648u))), _e212, _e255) * _e228) * select(0.00000011920929f, 1f, _e255)) * _e234), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e270 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e270 & 2147483648u))), _e213, _e272) * _e228) * select(0.00000011920929f, 1f, _e272)) * _e234)), _e194, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e288 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e288 & 2147483648u))), _e215, _e290) * _e228) * select(0.00000011920929f, 1f, _e290)) * _e234), _e216);
            }
            let _e307 = phi_547_;
            if _e169 {
                let _e308 = (_e154 < arrayLength((&global_2.member)));
                if _e308 {
                    if _e169 {
                    } else {
                        break;
                    }
                    let _e313 = global_9.member[_e154].member.member_1;
                    let _e318 = global_9.member[_e154].member.member_3;
                    if (_e313 <= _e318) {
                        let _e320 = (1u < _e122);
                        if _e320 {
                            if (0u < _e122) {
                            } else {
                                break;
                            }
                            let _e324 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e324 + 1u) < _e324) {
                                if _e320 {
                                } else {
                                    break;
                                }
                                let _e329 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e169 {
                        } else {
                            break;
                        }
                        let _e339 = global_9.member[_e154].member.member_2[0u];
                        let _e341 = (bitcast<u32>(_e339) & 2147483647u);
                        let _e347 = global_9.member[_e154].member.member_2[1u];
                        let _e349 = (bitcast<u32>(_e347) & 2147483647u);
                        let _e355 = global_9.member[_e154].member.member_2[2u];
                        let _e357 = (bitcast<u32>(_e355) & 2147483647u);
                        let _e363 = global_9.member[_e154].member.member[0u];
                        let _e365 = (bitcast<u32>(_e363) & 2147483647u);
                        let _e371 = global_9.member[_e154].member.member[1u];
                        let _e373 = (bitcast<u32>(_e371) & 2147483647u);
                        let _e379 = global_9.member[_e154].member.member[2u];
                        let _e381 = (bitcast<u32>(_e379) & 2147483647u);
                        let _e383 = select(_e349, _e341, (_e349 < _e341));
                        let _e385 = select(_e357, _e383, (_e357 < _e383));
                        let _e387 = select(_e365, _e385, (_e365 < _e385));
                        let _e389 = select(_e373, _e387, (_e373 < _e387));
                        let _e391 = select(_e381, _e389, (_e381 < _e389));
                        let _e392 = bitcast<u32>(_e313);
                        let _e393 = (_e392 & 2147483647u);
                        let _e397 = bitcast<u32>(_e318);
                        let _e398 = (_e397 & 2147483647u);
                        let _e402 = (((select(_e393, _e391, (_e393 < _e391)) < 2139095040u) && (_e398 <= 2139095040u)) && (_e385 > 0u));
                        if _e402 {
                            let _e405 = (bitcast<u32>(bitcast<f32>(_e385)) & 2147483647u);
                            if (_e405 >= 8388608u) {
                                phi_697_ = (bitcast<i32>((_e405 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_697_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e405)), 32u, (_e405 == 0u))));
                            }
                            let _e419 = phi_697_;
                            phi_698_ = _e419;
                        } else {
                            phi_698_ = 0i;
                        }
                        let _e421 = phi_698_;
                        let _e422 = (_e341 == _e385);
                        if _e422 {
                            phi_708_ = true;
                        } else {
                            phi_708_ = (_e349 == _e385);
                        }
                        let _e425 = phi_708_;
                        let _e426 = select(1u, 0u, _e422);
                        if _e425 {
                            let _e427 = (_e426 + 1u);
                            phi_718_ = _e427;
                            phi_719_ = _e427;
                            phi_721_ = select(true, false, (_e427 == 2u));
                        } else {
                            phi_718_ = u32();
                            phi_719_ = 0u;
                            phi_721_ = true;
                        }
                        let _e431 = phi_718_;
                        let _e433 = phi_719_;
                        let _e435 = phi_721_;
                        if _e435 {
                            phi_726_ = (_e433 + 1u);
                        } else {
                            phi_726_ = 0u;
                        }
                        let _e439 = phi_726_;
                        let _e440 = select(_e431, _e433, _e435);
                        let _e441 = select(_e426, select(2u, _e426, _e425), _e435);
                        let _e442 = -(_e421);
                        if (_e442 < -126i) {
                            phi_759_ = -126i;
                        } else {
                            phi_759_ = select(_e442, 127i, (_e442 > 127i));
                        }
                        let _e447 = phi_759_;
                        let _e452 = bitcast<f32>((bitcast<u32>((_e447 + 127i)) << bitcast<u32>(23i)));
                        let _e458 = bitcast<f32>((bitcast<u32>(((_e442 - _e447) + 127i)) << bitcast<u32>(23i)));
                        let _e463 = global_9.member[_e154].member.member;
                        let _e464 = (_e440 == 0u);
                        if _e464 {
                            phi_777_ = _e463[0];
                        } else {
                            phi_777_ = _e463[1];
                        }
                        let _e468 = phi_777_;
                        let _e469 = (_e440 == 2u);
                        if _e469 {
                            phi_783_ = _e463[2];
                        } else {
                            phi_783_ = _e468;
                        }
                        let _e472 = phi_783_;
                        let _e473 = bitcast<u32>(_e472);
                        let _e475 = ((_e473 & 2139095040u) != 0u);
                        let _e487 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e473 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e473 & 2147483648u))), _e472, _e475) * select(0.00000011920929f, 1f, _e475));
                        let _e488 = global_9.member[_e154].member.member_2;
                        if _e464 {
                            phi_823_ = _e488[0];
                        } else {
                            phi_823_ = _e488[1];
                        }
                        let _e492 = phi_823_;
                        if _e469 {
                            phi_829_ = _e488[2];
                        } else {
                            phi_829_ = _e492;
                        }
                        let _e495 = phi_829_;
                        let _e496 = bitcast<u32>(_e495);
                        let _e498 = ((_e496 & 2139095040u) != 0u);
                        let _e512 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e496 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e496 & 2147483648u))), _e495, _e498) * _e452) * select(0.00000011920929f, 1f, _e498)) * _e458);
                        let _e516 = (bitcast<f32>((bitcast<u32>(_e512) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e519 = bitcast<f32>((bitcast<u32>(_e487) & 2147483647u));
                        let _e520 = (_e519 * 0.00000011920929f);
                        let _e523 = select(select(0.00000000000011368684f, _e520, (_e520 > 0.00000000000011368684f)), 0f, _e516);
                        let _e524 = select(0f, _e512, _e516);
                        let _e525 = (_e487 + _e523);
                        let _e526 = (_e487 - _e523);
                        let _e528 = select(38685626000000000000000000f, (1f / _e512), _e516);
                        let _e529 = (_e439 == 0u);
                        if _e529 {
                            phi_902_ = _e463[0];
                        } else {
                            phi_902_ = _e463[1];
                        }
                        let _e533 = phi_902_;
                        let _e534 = (_e439 == 2u);
                        if _e534 {
                            phi_908_ = _e463[2];
                        } else {
                            phi_908_ = _e533;
                        }
                        let _e537 = phi_908_;
                        let _e538 = bitcast<u32>(_e537);
                        let _e540 = ((_e538 & 2139095040u) != 0u);
                        let _e552 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e538 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e538 & 2147483648u))), _e537, _e540) * select(0.00000011920929f, 1f, _e540));
                        if _e529 {
                            phi_948_ = _e488[0];
                        } else {
                            phi_948_ = _e488[1];
                        }
                        let _e556 = phi_948_;
                        if _e534 {
                            phi_954_ = _e488[2];
                        } else {
                            phi_954_ = _e556;
                        }
                        let _e559 = phi_954_;
                        let _e560 = bitcast<u32>(_e559);
                        let _e562 = ((_e560 & 2139095040u) != 0u);
                        let _e576 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e560 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e560 & 2147483648u))), _e559, _e562) * _e452) * select(0.00000011920929f, 1f, _e562)) * _e458);
                        let _e580 = (bitcast<f32>((bitcast<u32>(_e576) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e583 = bitcast<f32>((bitcast<u32>(_e552) & 2147483647u));
                        let _e584 = (_e583 * 0.00000011920929f);
                        let _e587 = select(select(0.00000000000011368684f, _e584, (_e584 > 0.00000000000011368684f)), 0f, _e580);
                        let _e588 = select(0f, _e576, _e580);
                        let _e589 = (_e552 + _e587);
                        let _e590 = (_e552 - _e587);
                        let _e592 = select(38685626000000000000000000f, (1f / _e576), _e580);
                        let _e593 = (_e441 == 0u);
                        if _e593 {
                            phi_1027_ = _e463[0];
                        } else {
                            phi_1027_ = _e463[1];
                        }
                        let _e597 = phi_1027_;
                        let _e598 = (_e441 == 2u);
                        if _e598 {
                            phi_1033_ = _e463[2];
                        } else {
                            phi_1033_ = _e597;
                        }
                        let _e601 = phi_1033_;
                        let _e602 = bitcast<u32>(_e601);
                        let _e604 = ((_e602 & 2139095040u) != 0u);
                        let _e616 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e602 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e602 & 2147483648u))), _e601, _e604) * select(0.00000011920929f, 1f, _e604));
                        if _e593 {
                            phi_1073_ = _e488[0];
                        } else {
                            phi_1073_ = _e488[1];
                        }
                        let _e620 = phi_1073_;
                        if _e598 {
                            phi_1079_ = _e488[2];
                        } else {
                            phi_1079_ = _e620;
                        }
                        let _e623 = phi_1079_;
                        let _e624 = bitcast<u32>(_e623);
                        let _e626 = ((_e624 & 2139095040u) != 0u);
                        let _e640 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e624 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e624 & 2147483648u))), _e623, _e626) * _e452) * select(0.00000011920929f, 1f, _e626)) * _e458);
                        let _e644 = (bitcast<f32>((bitcast<u32>(_e640) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e647 = bitcast<f32>((bitcast<u32>(_e616) & 2147483647u));
                        let _e648 = (_e647 * 0.00000011920929f);
                        let _e651 = select(select(0.00000000000011368684f, _e648, (_e648 > 0.00000000000011368684f)), 0f, _e644);
                        let _e652 = select(0f, _e640, _e644);
                        let _e653 = (_e616 + _e651);
                        let _e654 = (_e616 - _e651);
                        let _e656 = select(38685626000000000000000000f, (1f / _e640), _e644);
                        let _e658 = select(_e583, _e519, (_e519 > _e583));
                        if (_e402 && (select(_e647, _e658, (_e658 > _e647)) <= 1099511600000f)) {
                            let _e670 = ((_e393 & 8388607u) | (select(0u, 1u, ((_e393 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e673 = bitcast<i32>((_e393 >> bitcast<u32>(23i)));
                            let _e677 = (_e670 == 0u);
                            let _e680 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e670)), 32u, _e677)) - 8i);
                            if (_e673 == 255i) {
                                phi_1198_ = 255i;
                            } else {
                                phi_1198_ = (((_e673 + select(0i, 1i, (_e673 == 0i))) - _e680) + _e421);
                            }
                            let _e688 = phi_1198_;
                            let _e698 = (_e688 <= 0i);
                            if _e698 {
                                phi_1221_ = u32();
                            } else {
                                if _e677 {
                                    phi_1220_ = u32();
                                } else {
                                    phi_1220_ = select(((bitcast<u32>(_e688) << bitcast<u32>(23i)) | ((_e670 << bitcast<u32>(((_e680 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e688 >= 255i));
                                }
                                let _e702 = phi_1220_;
                                phi_1221_ = _e702;
                            }
                            let _e704 = phi_1221_;
                            let _e716 = ((_e398 & 8388607u) | (select(0u, 1u, ((_e398 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e719 = bitcast<i32>((_e398 >> bitcast<u32>(23i)));
                            let _e723 = (_e716 == 0u);
                            let _e726 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e716)), 32u, _e723)) - 8i);
                            if (_e719 == 255i) {
                                phi_1258_ = 255i;
                            } else {
                                phi_1258_ = (((_e719 + select(0i, 1i, (_e719 == 0i))) - _e726) + _e421);
                            }
                            let _e734 = phi_1258_;
                            let _e744 = (_e734 <= 0i);
                            if _e744 {
                                phi_1281_ = u32();
                            } else {
                                if _e723 {
                                    phi_1280_ = u32();
                                } else {
                                    phi_1280_ = select(((bitcast<u32>(_e734) << bitcast<u32>(23i)) | ((_e716 << bitcast<u32>(((_e726 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e734 >= 255i));
                                }
                                let _e748 = phi_1280_;
                                phi_1281_ = _e748;
                            }
                            let _e750 = phi_1281_;
                            phi_1289_ = bitcast<f32>(((_e397 & 2147483648u) | select(_e750, 0u, select(_e723, true, _e744))));
                            phi_1290_ = bitcast<f32>(((_e392 & 2147483648u) | select(_e704, 0u, select(_e677, true, _e698))));
                        } else {
                            phi_1289_ = 0f;
                            phi_1290_ = 1f;
                        }
                        let _e756 = phi_1289_;
                        let _e758 = phi_1290_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e762 = (_e440 % 3u);
                        let _e763 = (_e762 < 3u);
                        if _e763 {
                        } else {
                            break;
                        }
                        let _e765 = local_1[_e762];
                        let _e768 = (_e439 % 3u);
                        let _e769 = (_e768 < 3u);
                        if _e769 {
                        } else {
                            break;
                        }
                        let _e771 = local_1[_e768];
                        let _e774 = (_e441 % 3u);
                        let _e775 = (_e774 < 3u);
                        if _e775 {
                        } else {
                            break;
                        }
                        let _e777 = local_1[_e774];
                        if _e763 {
                        } else {
                            break;
                        }
                        let _e782 = local[_e762];
                        if _e769 {
                        } else {
                            break;
                        }
                        let _e786 = local[_e768];
                        if _e775 {
                        } else {
                            break;
                        }
                        let _e790 = local[_e774];
                        phi_5142_ = false;
                        phi_1386_ = type_47(_e756, false);
                        phi_1389_ = ((3u * _e107) + 1u);
                        phi_1391_ = (_e758 <= _e756);
                        phi_1393_ = 0u;
                        phi_1395_ = type_59(type_34(vec4<f32>((f32(_e765) * _e166), (f32(_e771) * _e166), (f32(_e777) * _e166), 0f), vec4<f32>((f32(_e782) * _e166), (f32(_e786) * _e166), (f32(_e790) * _e166), 0f)), select(0u, 2147483648u, (_e107 == 0u)));
                        loop {
                            let _e800 = phi_5142_;
                            let _e802 = phi_1386_;
                            let _e804 = phi_1389_;
                            let _e806 = phi_1391_;
                            let _e808 = phi_1393_;
                            let _e810 = phi_1395_;
                            local_10 = _e802;
                            if _e806 {
                                phi_1406_ = true;
                            } else {
                                phi_1406_ = (_e808 > 0u);
                            }
                            let _e813 = phi_1406_;
                            if _e813 {
                                let _e814 = (_e804 > 0u);
                                if _e814 {
                                    if _e806 {
                                        phi_1492_ = _e806;
                                        phi_1493_ = _e808;
                                        phi_1494_ = _e810;
                                    } else {
                                        let _e815 = (_e808 - 1u);
                                        let _e816 = (_e815 % 128u);
                                        let _e817 = (_e816 < 128u);
                                        if _e817 {
                                        } else {
                                            phi_5380_ = true;
                                            break;
                                        }
                                        let _e819 = local_7[_e816];
                                        if _e817 {
                                        } else {
                                            phi_5380_ = true;
                                            break;
                                        }
                                        let _e821 = local_6[_e816];
                                        if _e817 {
                                        } else {
                                            phi_5380_ = true;
                                            break;
                                        }
                                        let _e823 = local_5[_e816];
                                        if _e817 {
                                        } else {
                                            phi_5380_ = true;
                                            break;
                                        }
                                        let _e825 = local_4[_e816];
                                        if _e817 {
                                        } else {
                                            phi_5380_ = true;
                                            break;
                                        }
                                        let _e827 = local_3[_e816];
                                        if _e817 {
                                        } else {
                                            phi_5380_ = true;
                                            break;
                                        }
                                        let _e829 = local_2[_e816];
                                        if _e817 {
                                        } else {
                                            phi_5380_ = true;
                                            break;
                                        }
                                        let _e834 = local_8[_e816];
                                        if _e817 {
                                        } else {
                                            phi_5380_ = true;
                                            break;
                                        }
                                        let _e837 = local_9[_e816];
                                        phi_1492_ = (_e837 <= _e802.member);
                                        phi_1493_ = _e815;
                                        phi_1494_ = type_59(type_34(vec4<f32>(_e819, _e821, _e823, 0f), vec4<f32>(_e825, _e827, _e829, 0f)), _e834);
                                    }
                                    let _e841 = phi_1492_;
                                    let _e843 = phi_1493_;
                                    let _e845 = phi_1494_;
                                    if _e841 {
                                        let _e849 = ((_e845.member_1 & 2147483648u) != 0u);
                                        let _e850 = (_e845.member_1 & 268435455u);
                                        if _e849 {
                                            phi_1513_ = _e802;
                                            phi_1516_ = type_8(0u, ((_e845.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e857 = phi_1513_;
                                                let _e859 = phi_1516_;
                                                local_11 = _e857;
                                                if (_e859.member < _e859.member_1) {
                                                    phi_1517_ = type_8((_e859.member + 1u), _e859.member_1);
                                                    phi_1539_ = type_8(1u, _e859.member);
                                                } else {
                                                    phi_1517_ = _e859;
                                                    phi_1539_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e872 = phi_1517_;
                                                let _e874 = phi_1539_;
                                                let _e878 = (bitcast<i32>(_e874.member) != 0i);
                                                if _e878 {
                                                    let _e883 = (_e845.member.member_1.x - _e845.member.member.x);
                                                    let _e886 = (_e845.member.member_1.y - _e845.member.member.y);
                                                    let _e889 = (_e845.member.member_1.z - _e845.member.member.z);
                                                    let _e891 = select(_e886, _e883, (_e883 > _e886));
                                                    let _e893 = select(_e889, _e891, (_e891 > _e889));
                                                    let _e895 = (_e893 < (1024f * _e166));
                                                    if _e895 {
                                                        phi_1580_ = 0u;
                                                    } else {
                                                        phi_1580_ = select(2u, 1u, (_e893 < (2097152f * _e166)));
                                                    }
                                                    let _e900 = phi_1580_;
                                                    switch bitcast<i32>(_e900) {
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
                                                    let _e903 = phi_1586_;
                                                    switch bitcast<i32>(_e900) {
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
                                                    let _e910 = phi_1596_;
                                                    let _e912 = ((_e850 + (_e874.member_1 * ((3u * _e903) + 1u))) + (3u * _e910));
                                                    let _e913 = (_e912 < _e110);
                                                    if _e913 {
                                                        if _e913 {
                                                        } else {
                                                            phi_5136_ = true;
                                                            break;
                                                        }
                                                        let _e915 = global_10.member[_e912];
                                                        phi_1612_ = _e915;
                                                    } else {
                                                        phi_1612_ = 4294967295u;
                                                    }
                                                    let _e917 = phi_1612_;
                                                    if _e895 {
                                                        phi_1645_ = 0u;
                                                    } else {
                                                        phi_1645_ = select(2u, 1u, (_e893 < (2097152f * _e166)));
                                                    }
                                                    let _e922 = phi_1645_;
                                                    switch bitcast<i32>(_e922) {
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
                                                    let _e925 = phi_1651_;
                                                    let _e929 = (_e850 + (_e874.member_1 * ((3u * _e925) + 1u)));
                                                    switch bitcast<i32>(_e922) {
                                                        case 0: {
                                                            let _e1204 = (_e929 < _e110);
                                                            if _e1204 {
                                                                if _e1204 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1206 = global_10.member[_e929];
                                                                phi_1678_ = _e1206;
                                                            } else {
                                                                phi_1678_ = 0u;
                                                            }
                                                            let _e1208 = phi_1678_;
                                                            let _e1210 = ((10u * _e440) & 31u);
                                                            let _e1220 = ((10u * _e439) & 31u);
                                                            let _e1230 = ((10u * _e441) & 31u);
                                                            let _e1240 = (_e929 + 1u);
                                                            let _e1241 = (_e1240 < _e110);
                                                            if _e1241 {
                                                                if _e1241 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1243 = global_10.member[_e1240];
                                                                phi_1727_ = _e1243;
                                                            } else {
                                                                phi_1727_ = 0u;
                                                            }
                                                            let _e1245 = phi_1727_;
                                                            let _e1271 = (_e929 + 2u);
                                                            let _e1272 = (_e1271 < _e110);
                                                            if _e1272 {
                                                                if _e1272 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1274 = global_10.member[_e1271];
                                                                phi_1776_ = _e1274;
                                                            } else {
                                                                phi_1776_ = 0u;
                                                            }
                                                            let _e1276 = phi_1776_;
                                                            phi_2277_ = array<array<f32, 3>, 3>(array<f32, 3>((_e845.member.member.x + ((bitcast<f32>((1258291200u | ((_e1208 >> bitcast<u32>(_e1210)) & 1023u))) - 8388608f) * _e166)), (_e845.member.member.y + ((bitcast<f32>((1258291200u | ((_e1208 >> bitcast<u32>(_e1220)) & 1023u))) - 8388608f) * _e166)), (_e845.member.member.z + ((bitcast<f32>((1258291200u | ((_e1208 >> bitcast<u32>(_e1230)) & 1023u))) - 8388608f) * _e166))), array<f32, 3>((_e845.member.member.x + ((bitcast<f32>((1258291200u | ((_e1245 >> bitcast<u32>(_e1210)) & 1023u))) - 8388608f) * _e166)), (_e845.member.member.y + ((bitcast<f32>((1258291200u | ((_e1245 >> bitcast<u32>(_e1220)) & 1023u))) - 8388608f) * _e166)), (_e845.member.member.z + ((bitcast<f32>((1258291200u | ((_e1245 >> bitcast<u32>(_e1230)) & 1023u))) - 8388608f) * _e166))), array<f32, 3>((_e845.member.member.x + ((bitcast<f32>((1258291200u | ((_e1276 >> bitcast<u32>(_e1210)) & 1023u))) - 8388608f) * _e166)), (_e845.member.member.y + ((bitcast<f32>((1258291200u | ((_e1276 >> bitcast<u32>(_e1220)) & 1023u))) - 8388608f) * _e166)), (_e845.member.member.z + ((bitcast<f32>((1258291200u | ((_e1276 >> bitcast<u32>(_e1230)) & 1023u))) - 8388608f) * _e166))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1018 = (_e929 < _e110);
                                                            if _e1018 {
                                                                if _e1018 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1020 = global_10.member[_e929];
                                                                phi_1825_ = _e1020;
                                                            } else {
                                                                phi_1825_ = 0u;
                                                            }
                                                            let _e1022 = phi_1825_;
                                                            let _e1023 = (_e929 + 1u);
                                                            let _e1024 = (_e1023 < _e110);
                                                            if _e1024 {
                                                                if _e1024 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1026 = global_10.member[_e1023];
                                                                phi_1840_ = _e1026;
                                                            } else {
                                                                phi_1840_ = 0u;
                                                            }
                                                            let _e1028 = phi_1840_;
                                                            let _e1029 = (_e440 == 1u);
                                                            if _e1029 {
                                                                phi_1850_ = ((_e1022 >> bitcast<u32>(21i)) | (_e1028 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1850_ = (_e1028 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1038 = phi_1850_;
                                                            let _e1046 = (_e439 == 1u);
                                                            if _e1046 {
                                                                phi_1871_ = ((_e1022 >> bitcast<u32>(21i)) | (_e1028 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1871_ = (_e1028 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1055 = phi_1871_;
                                                            let _e1063 = (_e441 == 1u);
                                                            if _e1063 {
                                                                phi_1892_ = ((_e1022 >> bitcast<u32>(21i)) | (_e1028 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1892_ = (_e1028 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1072 = phi_1892_;
                                                            let _e1081 = (_e929 + 2u);
                                                            let _e1082 = (_e1081 < _e110);
                                                            if _e1082 {
                                                                if _e1082 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1084 = global_10.member[_e1081];
                                                                phi_1922_ = _e1084;
                                                            } else {
                                                                phi_1922_ = 0u;
                                                            }
                                                            let _e1086 = phi_1922_;
                                                            let _e1087 = (_e929 + 3u);
                                                            let _e1088 = (_e1087 < _e110);
                                                            if _e1088 {
                                                                if _e1088 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1090 = global_10.member[_e1087];
                                                                phi_1937_ = _e1090;
                                                            } else {
                                                                phi_1937_ = 0u;
                                                            }
                                                            let _e1092 = phi_1937_;
                                                            if _e1029 {
                                                                phi_1947_ = ((_e1086 >> bitcast<u32>(21i)) | (_e1092 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1947_ = (_e1092 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1101 = phi_1947_;
                                                            if _e1046 {
                                                                phi_1968_ = ((_e1086 >> bitcast<u32>(21i)) | (_e1092 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1968_ = (_e1092 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1117 = phi_1968_;
                                                            if _e1063 {
                                                                phi_1989_ = ((_e1086 >> bitcast<u32>(21i)) | (_e1092 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1989_ = (_e1092 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1133 = phi_1989_;
                                                            let _e1142 = (_e929 + 4u);
                                                            let _e1143 = (_e1142 < _e110);
                                                            if _e1143 {
                                                                if _e1143 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1145 = global_10.member[_e1142];
                                                                phi_2019_ = _e1145;
                                                            } else {
                                                                phi_2019_ = 0u;
                                                            }
                                                            let _e1147 = phi_2019_;
                                                            let _e1148 = (_e929 + 5u);
                                                            let _e1149 = (_e1148 < _e110);
                                                            if _e1149 {
                                                                if _e1149 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1151 = global_10.member[_e1148];
                                                                phi_2034_ = _e1151;
                                                            } else {
                                                                phi_2034_ = 0u;
                                                            }
                                                            let _e1153 = phi_2034_;
                                                            if _e1029 {
                                                                phi_2044_ = ((_e1147 >> bitcast<u32>(21i)) | (_e1153 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2044_ = (_e1153 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1162 = phi_2044_;
                                                            if _e1046 {
                                                                phi_2065_ = ((_e1147 >> bitcast<u32>(21i)) | (_e1153 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2065_ = (_e1153 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1178 = phi_2065_;
                                                            if _e1063 {
                                                                phi_2086_ = ((_e1147 >> bitcast<u32>(21i)) | (_e1153 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_2086_ = (_e1153 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1194 = phi_2086_;
                                                            phi_2277_ = array<array<f32, 3>, 3>(array<f32, 3>((_e845.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1038, _e1022, _e464) & 2097151u))) - 8388608f) * _e166)), (_e845.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1055, _e1022, _e529) & 2097151u))) - 8388608f) * _e166)), (_e845.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1072, _e1022, _e593) & 2097151u))) - 8388608f) * _e166))), array<f32, 3>((_e845.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1101, _e1086, _e464) & 2097151u))) - 8388608f) * _e166)), (_e845.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1117, _e1086, _e529) & 2097151u))) - 8388608f) * _e166)), (_e845.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1133, _e1086, _e593) & 2097151u))) - 8388608f) * _e166))), array<f32, 3>((_e845.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1162, _e1147, _e464) & 2097151u))) - 8388608f) * _e166)), (_e845.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1178, _e1147, _e529) & 2097151u))) - 8388608f) * _e166)), (_e845.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1194, _e1147, _e593) & 2097151u))) - 8388608f) * _e166))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e931 = (_e929 + _e440);
                                                            let _e932 = (_e931 < _e110);
                                                            if _e932 {
                                                                if _e932 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e934 = global_10.member[_e931];
                                                                phi_2117_ = _e934;
                                                            } else {
                                                                phi_2117_ = 0u;
                                                            }
                                                            let _e936 = phi_2117_;
                                                            let _e940 = (_e929 + _e439);
                                                            let _e941 = (_e940 < _e110);
                                                            if _e941 {
                                                                if _e941 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e943 = global_10.member[_e940];
                                                                phi_2135_ = _e943;
                                                            } else {
                                                                phi_2135_ = 0u;
                                                            }
                                                            let _e945 = phi_2135_;
                                                            let _e949 = (_e929 + _e441);
                                                            let _e950 = (_e949 < _e110);
                                                            if _e950 {
                                                                if _e950 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e952 = global_10.member[_e949];
                                                                phi_2153_ = _e952;
                                                            } else {
                                                                phi_2153_ = 0u;
                                                            }
                                                            let _e954 = phi_2153_;
                                                            let _e959 = (_e929 + 3u);
                                                            let _e960 = (_e959 + _e440);
                                                            let _e961 = (_e960 < _e110);
                                                            if _e961 {
                                                                if _e961 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e963 = global_10.member[_e960];
                                                                phi_2176_ = _e963;
                                                            } else {
                                                                phi_2176_ = 0u;
                                                            }
                                                            let _e965 = phi_2176_;
                                                            let _e969 = (_e959 + _e439);
                                                            let _e970 = (_e969 < _e110);
                                                            if _e970 {
                                                                if _e970 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e972 = global_10.member[_e969];
                                                                phi_2194_ = _e972;
                                                            } else {
                                                                phi_2194_ = 0u;
                                                            }
                                                            let _e974 = phi_2194_;
                                                            let _e978 = (_e959 + _e441);
                                                            let _e979 = (_e978 < _e110);
                                                            if _e979 {
                                                                if _e979 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e981 = global_10.member[_e978];
                                                                phi_2212_ = _e981;
                                                            } else {
                                                                phi_2212_ = 0u;
                                                            }
                                                            let _e983 = phi_2212_;
                                                            let _e988 = (_e929 + 6u);
                                                            let _e989 = (_e988 + _e440);
                                                            let _e990 = (_e989 < _e110);
                                                            if _e990 {
                                                                if _e990 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e992 = global_10.member[_e989];
                                                                phi_2235_ = _e992;
                                                            } else {
                                                                phi_2235_ = 0u;
                                                            }
                                                            let _e994 = phi_2235_;
                                                            let _e998 = (_e988 + _e439);
                                                            let _e999 = (_e998 < _e110);
                                                            if _e999 {
                                                                if _e999 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1001 = global_10.member[_e998];
                                                                phi_2253_ = _e1001;
                                                            } else {
                                                                phi_2253_ = 0u;
                                                            }
                                                            let _e1003 = phi_2253_;
                                                            let _e1007 = (_e988 + _e441);
                                                            let _e1008 = (_e1007 < _e110);
                                                            if _e1008 {
                                                                if _e1008 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1010 = global_10.member[_e1007];
                                                                phi_2271_ = _e1010;
                                                            } else {
                                                                phi_2271_ = 0u;
                                                            }
                                                            let _e1012 = phi_2271_;
                                                            phi_2277_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e936)) * _e166), (f32(bitcast<i32>(_e945)) * _e166), (f32(bitcast<i32>(_e954)) * _e166)), array<f32, 3>((f32(bitcast<i32>(_e965)) * _e166), (f32(bitcast<i32>(_e974)) * _e166), (f32(bitcast<i32>(_e983)) * _e166)), array<f32, 3>((f32(bitcast<i32>(_e994)) * _e166), (f32(bitcast<i32>(_e1003)) * _e166), (f32(bitcast<i32>(_e1012)) * _e166)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2277_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1304 = phi_2277_;
                                                    let _e1320 = (_e1304[0][2] - _e616);
                                                    let _e1323 = (((_e1304[0][0] - _e487) * _e652) - (_e1320 * _e524));
                                                    let _e1326 = (((_e1304[0][1] - _e552) * _e652) - (_e1320 * _e588));
                                                    let _e1329 = (_e1304[1][2] - _e616);
                                                    let _e1332 = (((_e1304[1][0] - _e487) * _e652) - (_e1329 * _e524));
                                                    let _e1335 = (((_e1304[1][1] - _e552) * _e652) - (_e1329 * _e588));
                                                    let _e1338 = (_e1304[2][2] - _e616);
                                                    let _e1341 = (((_e1304[2][0] - _e487) * _e652) - (_e1338 * _e524));
                                                    let _e1344 = (((_e1304[2][1] - _e552) * _e652) - (_e1338 * _e588));
                                                    let _e1345 = (_e1341 * _e1335);
                                                    let _e1346 = (_e1344 * _e1332);
                                                    let _e1347 = (_e1323 * _e1344);
                                                    let _e1348 = (_e1326 * _e1341);
                                                    let _e1349 = (_e1332 * _e1326);
                                                    let _e1350 = (_e1335 * _e1323);
                                                    let _e1355 = (((_e1345 >= _e1346) && (_e1347 >= _e1348)) && (_e1349 >= _e1350));
                                                    let _e1361 = (_e1355 || (((_e1345 <= _e1346) && (_e1347 <= _e1348)) && (_e1349 <= _e1350)));
                                                    if _e1361 {
                                                        let _e1363 = select(-1f, 1f, _e1355);
                                                        let _e1365 = ((_e1345 - _e1346) * _e1363);
                                                        let _e1367 = select(0f, _e1365, (_e1365 > 0f));
                                                        let _e1369 = ((_e1347 - _e1348) * _e1363);
                                                        let _e1371 = select(0f, _e1369, (_e1369 > 0f));
                                                        let _e1373 = ((_e1349 - _e1350) * _e1363);
                                                        let _e1375 = select(0f, _e1373, (_e1373 > 0f));
                                                        let _e1377 = ((_e1367 + _e1371) + _e1375);
                                                        let _e1379 = select(_e1304[1][0], _e1304[0][0], (_e1304[0][0] < _e1304[1][0]));
                                                        let _e1383 = select(_e1304[1][0], _e1304[0][0], (_e1304[0][0] > _e1304[1][0]));
                                                        let _e1387 = select(_e1304[1][1], _e1304[0][1], (_e1304[0][1] < _e1304[1][1]));
                                                        let _e1391 = select(_e1304[1][1], _e1304[0][1], (_e1304[0][1] > _e1304[1][1]));
                                                        let _e1395 = select(_e1304[1][2], _e1304[0][2], (_e1304[0][2] < _e1304[1][2]));
                                                        let _e1399 = select(_e1304[1][2], _e1304[0][2], (_e1304[0][2] > _e1304[1][2]));
                                                        let _e1404 = ((select(_e1304[2][0], _e1379, (_e1379 < _e1304[2][0])) - _e525) * _e528);
                                                        let _e1405 = ((select(_e1304[2][0], _e1383, (_e1383 > _e1304[2][0])) - _e526) * _e528);
                                                        let _e1408 = ((select(_e1304[2][1], _e1387, (_e1387 < _e1304[2][1])) - _e589) * _e592);
                                                        let _e1409 = ((select(_e1304[2][1], _e1391, (_e1391 > _e1304[2][1])) - _e590) * _e592);
                                                        let _e1412 = ((select(_e1304[2][2], _e1395, (_e1395 < _e1304[2][2])) - _e653) * _e656);
                                                        let _e1413 = ((select(_e1304[2][2], _e1399, (_e1399 > _e1304[2][2])) - _e654) * _e656);
                                                        let _e1415 = select(_e1413, _e1412, (_e1412 < _e1413));
                                                        let _e1417 = select(_e1413, _e1412, (_e1412 > _e1413));
                                                        let _e1419 = select(_e1405, _e1404, (_e1404 < _e1405));
                                                        let _e1421 = select(_e1409, _e1408, (_e1408 < _e1409));
                                                        let _e1423 = select(_e1421, _e1419, (_e1419 > _e1421));
                                                        let _e1425 = select(_e1415, _e1423, (_e1423 > _e1415));
                                                        let _e1427 = select(_e1405, _e1404, (_e1404 > _e1405));
                                                        let _e1429 = select(_e1409, _e1408, (_e1408 > _e1409));
                                                        let _e1431 = select(_e1429, _e1427, (_e1427 < _e1429));
                                                        let _e1433 = select(_e1417, _e1431, (_e1431 < _e1417));
                                                        let _e1434 = -(_e1415);
                                                        let _e1440 = select(_e758, _e1425, (_e1425 > _e758));
                                                        let _e1444 = select(_e1332, _e1323, (_e1323 < _e1332));
                                                        let _e1449 = select(_e1332, _e1323, (_e1323 > _e1332));
                                                        let _e1456 = select(_e1335, _e1326, (_e1326 < _e1335));
                                                        let _e1461 = select(_e1335, _e1326, (_e1326 > _e1335));
                                                        let _e1470 = (((((_e1361 && (_e1377 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1341, _e1444, (_e1444 < _e1341)) <= 0f) && (select(_e1341, _e1449, (_e1449 > _e1341)) >= 0f))) && ((select(_e1344, _e1456, (_e1456 < _e1344)) <= 0f) && (select(_e1344, _e1461, (_e1461 > _e1344)) >= 0f))) && (_e1440 <= (_e1433 + (select(_e1434, _e1417, (_e1417 > _e1434)) * 0.0000019073523f)))) && (_e1440 <= _e857.member));
                                                        if _e1470 {
                                                            let _e1475 = (_e1304[1][0] - _e1304[0][0]);
                                                            let _e1476 = (_e1304[1][1] - _e1304[0][1]);
                                                            let _e1477 = (_e1304[1][2] - _e1304[0][2]);
                                                            let _e1478 = vec3<f32>(_e1475, _e1476, _e1477);
                                                            let _e1479 = (_e1304[2][0] - _e1304[1][0]);
                                                            let _e1480 = (_e1304[2][1] - _e1304[1][1]);
                                                            let _e1481 = (_e1304[2][2] - _e1304[1][2]);
                                                            let _e1482 = vec3<f32>(_e1479, _e1480, _e1481);
                                                            let _e1483 = (_e1304[0][0] - _e1304[2][0]);
                                                            let _e1484 = (_e1304[0][1] - _e1304[2][1]);
                                                            let _e1485 = (_e1304[0][2] - _e1304[2][2]);
                                                            let _e1486 = vec3<f32>(_e1483, _e1484, _e1485);
                                                            let _e1487 = abs(_e1475);
                                                            let _e1488 = abs(_e1476);
                                                            if (_e1487 != _e1487) {
                                                                phi_4777_ = true;
                                                            } else {
                                                                phi_4777_ = (_e1488 >= _e1487);
                                                            }
                                                            let _e1492 = phi_4777_;
                                                            let _e1493 = select(_e1487, _e1488, _e1492);
                                                            let _e1494 = abs(_e1477);
                                                            if (_e1493 != _e1493) {
                                                                phi_4792_ = true;
                                                            } else {
                                                                phi_4792_ = (_e1494 >= _e1493);
                                                            }
                                                            let _e1498 = phi_4792_;
                                                            let _e1499 = select(_e1493, _e1494, _e1498);
                                                            let _e1500 = abs(_e1479);
                                                            let _e1501 = abs(_e1480);
                                                            if (_e1500 != _e1500) {
                                                                phi_4807_ = true;
                                                            } else {
                                                                phi_4807_ = (_e1501 >= _e1500);
                                                            }
                                                            let _e1505 = phi_4807_;
                                                            let _e1506 = select(_e1500, _e1501, _e1505);
                                                            let _e1507 = abs(_e1481);
                                                            if (_e1506 != _e1506) {
                                                                phi_4822_ = true;
                                                            } else {
                                                                phi_4822_ = (_e1507 >= _e1506);
                                                            }
                                                            let _e1511 = phi_4822_;
                                                            let _e1512 = select(_e1506, _e1507, _e1511);
                                                            let _e1513 = abs(_e1483);
                                                            let _e1514 = abs(_e1484);
                                                            if (_e1513 != _e1513) {
                                                                phi_4837_ = true;
                                                            } else {
                                                                phi_4837_ = (_e1514 >= _e1513);
                                                            }
                                                            let _e1518 = phi_4837_;
                                                            let _e1519 = select(_e1513, _e1514, _e1518);
                                                            let _e1520 = abs(_e1485);
                                                            if (_e1519 != _e1519) {
                                                                phi_4852_ = true;
                                                            } else {
                                                                phi_4852_ = (_e1520 >= _e1519);
                                                            }
                                                            let _e1524 = phi_4852_;
                                                            let _e1525 = select(_e1519, _e1520, _e1524);
                                                            let _e1527 = select(_e1512, _e1499, (_e1499 > _e1512));
                                                            let _e1529 = select(_e1525, _e1527, (_e1527 > _e1525));
                                                            if (_e1499 == _e1529) {
                                                                phi_2819_ = _e1335;
                                                                phi_2820_ = _e1332;
                                                                phi_2821_ = _e1326;
                                                                phi_2822_ = _e1323;
                                                                phi_2823_ = vec3<f32>(_e1304[0][0], _e1304[0][1], _e1304[0][2]);
                                                                phi_2824_ = _e1486;
                                                                phi_2825_ = _e1482;
                                                                phi_2826_ = _e1478;
                                                            } else {
                                                                let _e1531 = (_e1512 == _e1529);
                                                                let _e1536 = vec3(_e1531);
                                                                phi_2819_ = select(_e1326, _e1344, _e1531);
                                                                phi_2820_ = select(_e1323, _e1341, _e1531);
                                                                phi_2821_ = select(_e1344, _e1335, _e1531);
                                                                phi_2822_ = select(_e1341, _e1332, _e1531);
                                                                phi_2823_ = select(vec3<f32>(_e1304[2][0], _e1304[2][1], _e1304[2][2]), vec3<f32>(_e1304[1][0], _e1304[1][1], _e1304[1][2]), _e1536);
                                                                phi_2824_ = select(_e1482, _e1478, _e1536);
                                                                phi_2825_ = select(_e1478, _e1486, _e1536);
                                                                phi_2826_ = select(_e1486, _e1482, _e1536);
                                                            }
                                                            let _e1542 = phi_2819_;
                                                            let _e1544 = phi_2820_;
                                                            let _e1546 = phi_2821_;
                                                            let _e1548 = phi_2822_;
                                                            let _e1550 = phi_2823_;
                                                            let _e1552 = phi_2824_;
                                                            let _e1554 = phi_2825_;
                                                            let _e1556 = phi_2826_;
                                                            let _e1563 = ((_e1554.y * _e1552.z) - (_e1552.y * _e1554.z));
                                                            let _e1568 = ((_e1554.z * _e1552.x) - (_e1552.z * _e1554.x));
                                                            let _e1571 = ((_e1554.x * _e1552.y) - (_e1552.x * _e1554.y));
                                                            let _e1574 = ((_e1367 >= _e1371) && (_e1367 >= _e1375));
                                                            let _e1575 = (_e1371 >= _e1375);
                                                            let _e1589 = (((_e1563 * (select(select(_e1304[2][0], _e1304[1][0], _e1575), _e1304[0][0], _e1574) - _e487)) + (_e1568 * (select(select(_e1304[2][1], _e1304[1][1], _e1575), _e1304[0][1], _e1574) - _e552))) + (_e1571 * (select(select(_e1304[2][2], _e1304[1][2], _e1575), _e1304[0][2], _e1574) - _e616)));
                                                            let _e1594 = (((_e1563 * _e524) + (_e1568 * _e588)) + (_e1571 * _e652));
                                                            let _e1595 = (_e1544 - _e1548);
                                                            let _e1596 = (_e1542 - _e1546);
                                                            let _e1599 = ((_e1595 * _e1595) + (_e1596 * _e1596));
                                                            let _e1606 = (-(((_e1548 * _e1595) + (_e1546 * _e1596))) / select(0.000000000000000000000000000000000000011754944f, _e1599, (_e1599 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1608 = select(1f, _e1606, (_e1606 < 1f));
                                                            let _e1610 = select(0f, _e1608, (_e1608 > 0f));
                                                            let _e1619 = ((_e1550.x + (_e1556.x * _e1610)) - _e487);
                                                            let _e1622 = ((_e1550.y + (_e1556.y * _e1610)) - _e552);
                                                            let _e1625 = ((_e1550.z + (_e1556.z * _e1610)) - _e616);
                                                            let _e1628 = bitcast<f32>((bitcast<u32>(_e1619) & 2147483647u));
                                                            let _e1631 = bitcast<f32>((bitcast<u32>(_e1622) & 2147483647u));
                                                            let _e1633 = select(_e1631, _e1628, (_e1628 > _e1631));
                                                            let _e1636 = bitcast<f32>((bitcast<u32>(_e1625) & 2147483647u));
                                                            let _e1638 = select(_e1636, _e1633, (_e1633 > _e1636));
                                                            let _e1642 = abs(_e1563);
                                                            let _e1643 = abs(_e1568);
                                                            if (_e1642 != _e1642) {
                                                                phi_4867_ = true;
                                                            } else {
                                                                phi_4867_ = (_e1643 >= _e1642);
                                                            }
                                                            let _e1647 = phi_4867_;
                                                            let _e1648 = select(_e1642, _e1643, _e1647);
                                                            let _e1649 = abs(_e1571);
                                                            if (_e1648 != _e1648) {
                                                                phi_4882_ = true;
                                                            } else {
                                                                phi_4882_ = (_e1649 >= _e1648);
                                                            }
                                                            let _e1653 = phi_4882_;
                                                            let _e1669 = abs(_e1554.x);
                                                            let _e1670 = abs(_e1554.y);
                                                            if (_e1669 != _e1669) {
                                                                phi_4897_ = true;
                                                            } else {
                                                                phi_4897_ = (_e1670 >= _e1669);
                                                            }
                                                            let _e1674 = phi_4897_;
                                                            let _e1675 = select(_e1669, _e1670, _e1674);
                                                            let _e1676 = abs(_e1554.z);
                                                            if (_e1675 != _e1675) {
                                                                phi_4912_ = true;
                                                            } else {
                                                                phi_4912_ = (_e1676 >= _e1675);
                                                            }
                                                            let _e1680 = phi_4912_;
                                                            let _e1683 = abs(_e1552.x);
                                                            let _e1684 = abs(_e1552.y);
                                                            if (_e1683 != _e1683) {
                                                                phi_4927_ = true;
                                                            } else {
                                                                phi_4927_ = (_e1684 >= _e1683);
                                                            }
                                                            let _e1688 = phi_4927_;
                                                            let _e1689 = select(_e1683, _e1684, _e1688);
                                                            let _e1690 = abs(_e1552.z);
                                                            if (_e1689 != _e1689) {
                                                                phi_4942_ = true;
                                                            } else {
                                                                phi_4942_ = (_e1690 >= _e1689);
                                                            }
                                                            let _e1694 = phi_4942_;
                                                            let _e1699 = ((bitcast<f32>((bitcast<u32>(((((_e1563 * _e1619) + (_e1568 * _e1622)) + (_e1571 * _e1625)) - _e1589)) & 2147483647u)) <= ((0.0000009536743f * select(_e1529, _e1638, (_e1638 > _e1529))) * select(_e1648, _e1649, _e1653))) && !((bitcast<f32>((bitcast<u32>(_e1594) & 2147483647u)) <= ((0.0000038146973f * select(_e1675, _e1676, _e1680)) * select(_e1689, _e1690, _e1694)))));
                                                            let _e1700 = (_e1589 / _e1594);
                                                            if (_e1470 && !(_e1699)) {
                                                                let _e1703 = (_e1625 / _e652);
                                                                let _e1711 = (((_e1563 * (_e1619 - (_e524 * _e1703))) + (_e1568 * (_e1622 - (_e588 * _e1703)))) / _e1594);
                                                                phi_3034_ = select(select(_e1703, (_e1703 + _e1711), (bitcast<f32>((bitcast<u32>(_e1711) & 2147483647u)) <= _e1529)), _e1700, _e1699);
                                                            } else {
                                                                phi_3034_ = _e1700;
                                                            }
                                                            let _e1720 = phi_3034_;
                                                            let _e1722 = select(_e1433, _e1720, (_e1720 < _e1433));
                                                            let _e1724 = select(_e1425, _e1722, (_e1722 > _e1425));
                                                            let _e1725 = (1f / _e1377);
                                                            phi_3054_ = type_46(_e1724, (_e1371 * _e1725), (_e1375 * _e1725), ((_e1470 && (_e1724 >= _e758)) && (_e1724 <= _e857.member)));
                                                            phi_3055_ = type_46();
                                                        } else {
                                                            phi_3054_ = type_46();
                                                            phi_3055_ = type_46(0f, 0f, 0f, _e1470);
                                                        }
                                                        let _e1734 = phi_3054_;
                                                        let _e1736 = phi_3055_;
                                                        phi_3058_ = _e1734;
                                                        phi_3059_ = _e1736;
                                                        phi_3060_ = select(true, false, _e1470);
                                                    } else {
                                                        phi_3058_ = type_46();
                                                        phi_3059_ = type_46(0f, 0f, 0f, _e1361);
                                                        phi_3060_ = true;
                                                    }
                                                    let _e1739 = phi_3058_;
                                                    let _e1741 = phi_3059_;
                                                    let _e1743 = phi_3060_;
                                                    if _e1743 {
                                                        phi_3064_ = _e1741;
                                                    } else {
                                                        phi_3064_ = _e1739;
                                                    }
                                                    let _e1745 = phi_3064_;
                                                    if _e1745.member_3 {
                                                        phi_3073_ = type_25(_e1745.member, _e1745.member_1, _e1745.member_2, _e917);
                                                    } else {
                                                        phi_3073_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1752 = phi_3073_;
                                                    if (_e1752.member_3 != 4294967295u) {
                                                        if (_e917 == _e175) {
                                                            phi_3408_ = false;
                                                        } else {
                                                            let _e1756 = (_e917 < arrayLength((&global_6.member)));
                                                            if _e1756 {
                                                                if _e1756 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1758 = global_6.member[_e917];
                                                                phi_3096_ = _e1758;
                                                            } else {
                                                                phi_3096_ = 4294967295u;
                                                            }
                                                            let _e1760 = phi_3096_;
                                                            let _e1761 = (_e1760 < arrayLength((&global_7.member)));
                                                            if _e1761 {
                                                                if _e1761 {
                                                                } else {
                                                                    phi_5136_ = true;
                                                                    break;
                                                                }
                                                                let _e1763 = global_7.member[_e1760];
                                                                phi_3110_ = _e1763;
                                                            } else {
                                                                phi_3110_ = 0i;
                                                            }
                                                            let _e1765 = phi_3110_;
                                                            let _e1766 = (_e1765 == 0i);
                                                            if _e1766 {
                                                                phi_3407_ = true;
                                                            } else {
                                                                if _e464 {
                                                                    phi_3133_ = vec3<f32>(_e1304[0][0], _e1304[0][1], _e1304[0][2]);
                                                                } else {
                                                                    if (_e440 == 1u) {
                                                                        phi_3132_ = vec3<f32>(_e1304[0][2], _e1304[0][0], _e1304[0][1]);
                                                                    } else {
                                                                        phi_3132_ = vec3<f32>(_e1304[0][1], _e1304[0][2], _e1304[0][0]);
                                                                    }
                                                                    let _e1771 = phi_3132_;
                                                                    phi_3133_ = _e1771;
                                                                }
                                                                let _e1774 = phi_3133_;
                                                                if _e464 {
                                                                    phi_3152_ = vec3<f32>(_e1304[1][0], _e1304[1][1], _e1304[1][2]);
                                                                } else {
                                                                    if (_e440 == 1u) {
                                                                        phi_3151_ = vec3<f32>(_e1304[1][2], _e1304[1][0], _e1304[1][1]);
                                                                    } else {
                                                                        phi_3151_ = vec3<f32>(_e1304[1][1], _e1304[1][2], _e1304[1][0]);
                                                                    }
                                                                    let _e1779 = phi_3151_;
                                                                    phi_3152_ = _e1779;
                                                                }
                                                                let _e1782 = phi_3152_;
                                                                if _e464 {
                                                                    phi_3171_ = vec3<f32>(_e1304[2][0], _e1304[2][1], _e1304[2][2]);
                                                                } else {
                                                                    if (_e440 == 1u) {
                                                                        phi_3170_ = vec3<f32>(_e1304[2][2], _e1304[2][0], _e1304[2][1]);
                                                                    } else {
                                                                        phi_3170_ = vec3<f32>(_e1304[2][1], _e1304[2][2], _e1304[2][0]);
                                                                    }
                                                                    let _e1787 = phi_3170_;
                                                                    phi_3171_ = _e1787;
                                                                }
                                                                let _e1790 = phi_3171_;
                                                                let _e1793 = (_e1782.x - _e1774.x);
                                                                let _e1796 = (_e1782.y - _e1774.y);
                                                                let _e1799 = (_e1782.z - _e1774.z);
                                                                let _e1801 = (_e1790.x - _e1774.x);
                                                                let _e1803 = (_e1790.y - _e1774.y);
                                                                let _e1805 = (_e1790.z - _e1774.z);
                                                                if (_e307.member_1 == 1u) {
                                                                    phi_3207_ = (vec3<f32>(_e307.member[0], _e307.member[1], _e307.member[2]) - _e1774);
                                                                } else {
                                                                    phi_3207_ = vec3<f32>(_e307.member[0], _e307.member[1], _e307.member[2]);
                                                                }
                                                                let _e1820 = phi_3207_;
                                                                let _e1826 = bitcast<f32>((bitcast<u32>((_e1793 * _e1803)) ^ _e307.member_3[0]));
                                                                let _e1830 = bitcast<f32>((bitcast<u32>((_e1796 * _e1801)) ^ _e307.member_3[0]));
                                                                let _e1834 = bitcast<f32>((bitcast<u32>((_e1796 * _e1805)) ^ _e307.member_3[0]));
                                                                let _e1838 = bitcast<f32>((bitcast<u32>((_e1799 * _e1803)) ^ _e307.member_3[0]));
                                                                let _e1842 = bitcast<f32>((bitcast<u32>((_e1799 * _e1801)) ^ _e307.member_3[0]));
                                                                let _e1846 = bitcast<f32>((bitcast<u32>((_e1793 * _e1805)) ^ _e307.member_3[0]));
                                                                let _e1847 = (_e1834 - _e1838);
                                                                let _e1848 = (_e1842 - _e1846);
                                                                let _e1849 = (_e1826 - _e1830);
                                                                let _e1873 = (bitcast<f32>((bitcast<u32>(_e1834) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1838) & 2147483647u)));
                                                                let _e1880 = (bitcast<f32>((bitcast<u32>(_e1842) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1846) & 2147483647u)));
                                                                let _e1887 = (bitcast<f32>((bitcast<u32>(_e1826) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1830) & 2147483647u)));
                                                                if (_e307.member_2 == 0f) {
                                                                    phi_3389_ = 0f;
                                                                } else {
                                                                    let _e1917 = bitcast<f32>((bitcast<u32>(_e1847) & 2147483647u));
                                                                    let _e1920 = bitcast<f32>((bitcast<u32>(_e1848) & 2147483647u));
                                                                    let _e1923 = bitcast<f32>((bitcast<u32>(_e1849) & 2147483647u));
                                                                    let _e1925 = select(_e1923, _e1920, (_e1920 > _e1923));
                                                                    let _e1929 = select(_e1923, _e1920, (_e1920 < _e1923));
                                                                    let _e1933 = select(_e1920, _e1917, (_e1917 < _e1920));
                                                                    let _e1935 = select(_e1920, _e1917, (_e1917 > _e1920));
                                                                    let _e1937 = select(_e1923, _e1935, (_e1935 < _e1923));
                                                                    phi_3389_ = bitcast<f32>((bitcast<u32>((_e307.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1925, _e1917, (_e1917 > _e1925)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1937, _e1933, (_e1933 > _e1937)))) ^ _e307.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1929, _e1917, (_e1917 < _e1929)))) ^ _e307.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1873 + _e1880) + _e1887))) ^ _e307.member_3[0]))) * 1.0000005f)) ^ _e307.member_3[0])))) ^ _e307.member_3[0]));
                                                                }
                                                                let _e1964 = phi_3389_;
                                                                phi_3407_ = (_e1766 || !(((((bitcast<f32>((bitcast<u32>((_e1820.x * _e1847)) ^ _e307.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1820.y * _e1848)) ^ _e307.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1820.z * _e1849)) ^ _e307.member_3[0]))) * f32(-(_e1765))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1820.x) & 2147483647u)) * _e1873)) ^ _e307.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1820.y) & 2147483647u)) * _e1880)) ^ _e307.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1820.z) & 2147483647u)) * _e1887)) ^ _e307.member_3[0]))))) ^ _e307.member_3[0])) + _e1964) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1978 = phi_3407_;
                                                            phi_3408_ = _e1978;
                                                        }
                                                        let _e1980 = phi_3408_;
                                                        if _e1980 {
                                                            phi_3413_ = type_47(-340282350000000000000000000000000000000f, true);
                                                        } else {
                                                            phi_3413_ = _e857;
                                                        }
                                                        let _e1982 = phi_3413_;
                                                        phi_3414_ = _e1982;
                                                    } else {
                                                        phi_3414_ = _e857;
                                                    }
                                                    let _e1984 = phi_3414_;
                                                    phi_1514_ = _e1984;
                                                } else {
                                                    phi_1514_ = type_47();
                                                }
                                                let _e1986 = phi_1514_;
                                                continue;
                                                continuing {
                                                    phi_1513_ = _e1986;
                                                    phi_1516_ = _e872;
                                                    phi_5136_ = _e800;
                                                    break if !(_e878);
                                                }
                                            }
                                            let _e1989 = phi_5136_;
                                            phi_5380_ = _e1989;
                                            if _e1989 {
                                                break;
                                            }
                                            phi_5471_ = _e1989;
                                            let _e2664 = local_11;
                                            phi_3415_ = _e2664;
                                        } else {
                                            phi_5471_ = _e800;
                                            phi_3415_ = _e802;
                                        }
                                        let _e1991 = phi_5471_;
                                        let _e1993 = phi_3415_;
                                        if _e849 {
                                            phi_4680_ = bool();
                                            phi_4681_ = u32();
                                            phi_4682_ = type_59();
                                        } else {
                                            if (_e845.member_1 >= _e107) {
                                                phi_4216_ = type_60(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_59(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_59(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e845.member_1 < _e107) {
                                                } else {
                                                    phi_5380_ = true;
                                                    break;
                                                }
                                                let _e1997 = ((1u + _e440) % 4u);
                                                if (_e1997 < 4u) {
                                                } else {
                                                    phi_5380_ = true;
                                                    break;
                                                }
                                                let _e2002 = global_5.member[_e845.member_1][_e1997];
                                                let _e2004 = (_e2002 >> bitcast<u32>(11u));
                                                let _e2006 = ((1u + _e439) % 4u);
                                                if (_e2006 < 4u) {
                                                } else {
                                                    phi_5380_ = true;
                                                    break;
                                                }
                                                let _e2011 = global_5.member[_e845.member_1][_e2006];
                                                let _e2013 = (_e2011 >> bitcast<u32>(11u));
                                                let _e2015 = ((1u + _e441) % 4u);
                                                if (_e2015 < 4u) {
                                                } else {
                                                    phi_5380_ = true;
                                                    break;
                                                }
                                                let _e2020 = global_5.member[_e845.member_1][_e2015];
                                                let _e2022 = (_e2020 >> bitcast<u32>(11u));
                                                let _e2045 = (bitcast<f32>((bitcast<u32>((_e845.member.member_1.x - _e845.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e2046 = (bitcast<f32>((bitcast<u32>((_e845.member.member_1.y - _e845.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e2047 = (bitcast<f32>((bitcast<u32>((_e845.member.member_1.z - _e845.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e2049 = select(_e166, _e2045, (_e2045 > _e166));
                                                let _e2051 = select(_e166, _e2046, (_e2046 > _e166));
                                                let _e2053 = select(_e166, _e2047, (_e2047 > _e166));
                                                let _e2084 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2002 & 1023u))) - 8388608f) * _e2049));
                                                let _e2089 = (bitcast<i32>((_e2002 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e2092 = bitcast<f32>((_e2084 & bitcast<u32>(_e2089)));
                                                let _e2093 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2011 & 1023u))) - 8388608f) * _e2051));
                                                let _e2098 = (bitcast<i32>((_e2011 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e2101 = bitcast<f32>((_e2093 & bitcast<u32>(_e2098)));
                                                let _e2102 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2020 & 1023u))) - 8388608f) * _e2053));
                                                let _e2107 = (bitcast<i32>((_e2020 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e2110 = bitcast<f32>((_e2102 & bitcast<u32>(_e2107)));
                                                let _e2114 = bitcast<f32>((_e2084 & bitcast<u32>(~(_e2089))));
                                                let _e2118 = bitcast<f32>((_e2093 & bitcast<u32>(~(_e2098))));
                                                let _e2122 = bitcast<f32>((_e2102 & bitcast<u32>(~(_e2107))));
                                                let _e2123 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2004 & 1023u))) - 8388608f) * _e2049));
                                                let _e2128 = (bitcast<i32>((_e2004 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e2131 = bitcast<f32>((_e2123 & bitcast<u32>(_e2128)));
                                                let _e2132 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2013 & 1023u))) - 8388608f) * _e2051));
                                                let _e2137 = (bitcast<i32>((_e2013 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e2140 = bitcast<f32>((_e2132 & bitcast<u32>(_e2137)));
                                                let _e2141 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2022 & 1023u))) - 8388608f) * _e2053));
                                                let _e2146 = (bitcast<i32>((_e2022 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e2149 = bitcast<f32>((_e2141 & bitcast<u32>(_e2146)));
                                                let _e2153 = bitcast<f32>((_e2123 & bitcast<u32>(~(_e2128))));
                                                let _e2157 = bitcast<f32>((_e2132 & bitcast<u32>(~(_e2137))));
                                                let _e2161 = bitcast<f32>((_e2141 & bitcast<u32>(~(_e2146))));
                                                let _e2162 = (_e845.member.member.x + _e2092);
                                                let _e2163 = (_e845.member.member.y + _e2101);
                                                let _e2164 = (_e845.member.member.z + _e2110);
                                                let _e2167 = (_e845.member.member_1.x - _e2131);
                                                let _e2168 = (_e845.member.member_1.y - _e2140);
                                                let _e2169 = (_e845.member.member_1.z - _e2149);
                                                let _e2188 = (_e2167 - _e2162);
                                                let _e2189 = (_e2168 - _e2163);
                                                let _e2190 = (_e2169 - _e2164);
                                                let _e2192 = select(_e2189, _e2188, (_e2188 > _e2189));
                                                let _e2194 = select(_e2190, _e2192, (_e2192 > _e2190));
                                                if (_e2194 < (1024f * _e166)) {
                                                    phi_3917_ = 0u;
                                                } else {
                                                    phi_3917_ = select(2u, 1u, (_e2194 < (2097152f * _e166)));
                                                }
                                                let _e2201 = phi_3917_;
                                                switch bitcast<i32>(_e2201) {
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
                                                let _e2204 = phi_3923_;
                                                let _e2210 = global_5.member[_e845.member_1][0u];
                                                let _e2214 = global_5.member[_e845.member_1][1u];
                                                let _e2218 = global_5.member[_e845.member_1][2u];
                                                let _e2222 = global_5.member[_e845.member_1][3u];
                                                let _e2234 = (((_e2214 >> bitcast<u32>(22i)) | ((_e2218 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e2222 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e2235 = (_e2210 & 268435455u);
                                                let _e2236 = (_e2234 & 268435455u);
                                                let _e2239 = ((_e2210 >> bitcast<u32>(28u)) & 7u);
                                                let _e2247 = ((_e2210 >> bitcast<u32>(31i)) | (((_e2234 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e2248 = (_e2239 != 0u);
                                                if (_e2239 == 0u) {
                                                    phi_4178_ = _e2235;
                                                } else {
                                                    if (_e2239 == 7u) {
                                                        phi_4177_ = 2147483648u;
                                                    } else {
                                                        phi_4177_ = ((2147483648u | (_e2239 << bitcast<u32>(28u))) | (_e2236 & 268435455u));
                                                    }
                                                    let _e2257 = phi_4177_;
                                                    phi_4178_ = _e2257;
                                                }
                                                let _e2259 = phi_4178_;
                                                if _e2248 {
                                                    let _e2260 = (_e2239 != 7u);
                                                    if _e2260 {
                                                        phi_4188_ = (_e2236 + (_e2239 * ((3u * _e2204) + 1u)));
                                                    } else {
                                                        phi_4188_ = u32();
                                                    }
                                                    let _e2264 = phi_4188_;
                                                    phi_4190_ = _e2264;
                                                    phi_4191_ = select(true, false, _e2260);
                                                } else {
                                                    phi_4190_ = u32();
                                                    phi_4191_ = true;
                                                }
                                                let _e2267 = phi_4190_;
                                                let _e2269 = phi_4191_;
                                                if (_e2247 == 0u) {
                                                    phi_4212_ = (_e2235 + select(0u, 1u, !(_e2248)));
                                                } else {
                                                    if (_e2247 == 7u) {
                                                        phi_4211_ = 2147483648u;
                                                    } else {
                                                        phi_4211_ = ((2147483648u | (_e2247 << bitcast<u32>(28u))) | (select(_e2267, _e2236, _e2269) & 268435455u));
                                                    }
                                                    let _e2282 = phi_4211_;
                                                    phi_4212_ = _e2282;
                                                }
                                                let _e2284 = phi_4212_;
                                                phi_4216_ = type_60(array<vec4<f32>, 3>(vec4<f32>(_e2162, (_e845.member.member.x + _e2114), _e2167, (_e845.member.member_1.x - _e2153)), vec4<f32>(_e2163, (_e845.member.member.y + _e2118), _e2168, (_e845.member.member_1.y - _e2157)), vec4<f32>(_e2164, (_e845.member.member.z + _e2122), _e2169, (_e845.member.member_1.z - _e2161))), type_59(type_34((_e845.member.member + vec4<f32>(_e2092, _e2101, _e2110, 0f)), (_e845.member.member_1 - vec4<f32>(_e2131, _e2140, _e2149, 0f))), _e2259), type_59(type_34((_e845.member.member + vec4<f32>(_e2114, _e2118, _e2122, 0f)), (_e845.member.member_1 - vec4<f32>(_e2153, _e2157, _e2161, 0f))), _e2284));
                                            }
                                            let _e2289 = phi_4216_;
                                            let _e2301 = ((_e2289.member[0].x - _e525) * _e528);
                                            let _e2302 = ((_e2289.member[0].y - _e525) * _e528);
                                            let _e2303 = ((_e2289.member[0].z - _e526) * _e528);
                                            let _e2304 = ((_e2289.member[0].w - _e526) * _e528);
                                            let _e2314 = ((_e2289.member[1].x - _e589) * _e592);
                                            let _e2315 = ((_e2289.member[1].y - _e589) * _e592);
                                            let _e2316 = ((_e2289.member[1].z - _e590) * _e592);
                                            let _e2317 = ((_e2289.member[1].w - _e590) * _e592);
                                            let _e2327 = ((_e2289.member[2].x - _e653) * _e656);
                                            let _e2328 = ((_e2289.member[2].y - _e653) * _e656);
                                            let _e2329 = ((_e2289.member[2].z - _e654) * _e656);
                                            let _e2330 = ((_e2289.member[2].w - _e654) * _e656);
                                            let _e2332 = select(_e2329, _e2327, (_e2327 < _e2329));
                                            let _e2334 = select(_e2330, _e2328, (_e2328 < _e2330));
                                            let _e2336 = select(_e2329, _e2327, (_e2327 > _e2329));
                                            let _e2338 = select(_e2330, _e2328, (_e2328 > _e2330));
                                            let _e2340 = select(_e2303, _e2301, (_e2301 < _e2303));
                                            let _e2342 = select(_e2304, _e2302, (_e2302 < _e2304));
                                            let _e2344 = select(_e2316, _e2314, (_e2314 < _e2316));
                                            let _e2346 = select(_e2317, _e2315, (_e2315 < _e2317));
                                            let _e2348 = select(_e2344, _e2340, (_e2340 > _e2344));
                                            let _e2350 = select(_e2346, _e2342, (_e2342 > _e2346));
                                            let _e2352 = select(_e2332, _e2348, (_e2348 > _e2332));
                                            let _e2354 = select(_e2334, _e2350, (_e2350 > _e2334));
                                            let _e2356 = select(_e2303, _e2301, (_e2301 > _e2303));
                                            let _e2358 = select(_e2304, _e2302, (_e2302 > _e2304));
                                            let _e2360 = select(_e2316, _e2314, (_e2314 > _e2316));
                                            let _e2362 = select(_e2317, _e2315, (_e2315 > _e2317));
                                            let _e2364 = select(_e2360, _e2356, (_e2356 < _e2360));
                                            let _e2366 = select(_e2362, _e2358, (_e2358 < _e2362));
                                            let _e2371 = -(_e2332);
                                            let _e2372 = -(_e2334);
                                            let _e2379 = (select(_e2336, _e2364, (_e2364 < _e2336)) + (select(_e2371, _e2336, (_e2336 > _e2371)) * 0.0000019073523f));
                                            let _e2380 = (select(_e2338, _e2366, (_e2366 < _e2338)) + (select(_e2372, _e2338, (_e2338 > _e2372)) * 0.0000019073523f));
                                            let _e2382 = select(_e758, _e2352, (_e2352 > _e758));
                                            let _e2384 = select(_e758, _e2354, (_e2354 > _e758));
                                            let _e2389 = (_e2382 <= select(_e1993.member, _e2379, (_e2379 < _e1993.member)));
                                            let _e2390 = (_e2384 <= select(_e1993.member, _e2380, (_e2380 < _e1993.member)));
                                            let _e2391 = (_e2382 <= _e2384);
                                            if _e2389 {
                                                if _e2390 {
                                                    if _e2391 {
                                                        phi_4578_ = _e2289.member_2;
                                                    } else {
                                                        phi_4578_ = _e2289.member_1;
                                                    }
                                                    let _e2395 = phi_4578_;
                                                    let _e2416 = (_e843 % 128u);
                                                    let _e2417 = (_e2416 < 128u);
                                                    if _e2417 {
                                                    } else {
                                                        phi_5380_ = true;
                                                        break;
                                                    }
                                                    local_8[_e2416] = _e2395.member_1;
                                                    if _e2417 {
                                                    } else {
                                                        phi_5380_ = true;
                                                        break;
                                                    }
                                                    local_7[_e2416] = _e2395.member.member.x;
                                                    if _e2417 {
                                                    } else {
                                                        phi_5380_ = true;
                                                        break;
                                                    }
                                                    local_6[_e2416] = _e2395.member.member.y;
                                                    if _e2417 {
                                                    } else {
                                                        phi_5380_ = true;
                                                        break;
                                                    }
                                                    local_5[_e2416] = _e2395.member.member.z;
                                                    if _e2417 {
                                                    } else {
                                                        phi_5380_ = true;
                                                        break;
                                                    }
                                                    local_4[_e2416] = _e2395.member.member_1.x;
                                                    if _e2417 {
                                                    } else {
                                                        phi_5380_ = true;
                                                        break;
                                                    }
                                                    local_3[_e2416] = _e2395.member.member_1.y;
                                                    if _e2417 {
                                                    } else {
                                                        phi_5380_ = true;
                                                        break;
                                                    }
                                                    local_2[_e2416] = _e2395.member.member_1.z;
                                                    if _e2417 {
                                                    } else {
                                                        phi_5380_ = true;
                                                        break;
                                                    }
                                                    local_9[_e2416] = select(_e2382, _e2384, _e2391);
                                                    if _e2391 {
                                                        phi_4654_ = _e2289.member_1;
                                                    } else {
                                                        phi_4654_ = _e2289.member_2;
                                                    }
                                                    let _e2430 = phi_4654_;
                                                    phi_4655_ = (_e843 + 1u);
                                                    phi_4656_ = _e2430;
                                                } else {
                                                    phi_4655_ = u32();
                                                    phi_4656_ = type_59();
                                                }
                                                let _e2432 = phi_4655_;
                                                let _e2434 = phi_4656_;
                                                phi_4658_ = _e2432;
                                                phi_4659_ = _e2434;
                                                phi_4660_ = select(true, false, _e2390);
                                            } else {
                                                phi_4658_ = u32();
                                                phi_4659_ = type_59();
                                                phi_4660_ = true;
                                            }
                                            let _e2437 = phi_4658_;
                                            let _e2439 = phi_4659_;
                                            let _e2441 = phi_4660_;
                                            if _e2441 {
                                                if _e2389 {
                                                    phi_4669_ = _e2289.member_1;
                                                } else {
                                                    phi_4669_ = _e2289.member_2;
                                                }
                                                let _e2445 = phi_4669_;
                                                phi_4674_ = select(_e2390, true, _e2389);
                                                phi_4676_ = _e2445;
                                            } else {
                                                phi_4674_ = _e841;
                                                phi_4676_ = _e2439;
                                            }
                                            let _e2448 = phi_4674_;
                                            let _e2450 = phi_4676_;
                                            phi_4680_ = _e2448;
                                            phi_4681_ = select(_e2437, _e843, _e2441);
                                            phi_4682_ = _e2450;
                                        }
                                        let _e2453 = phi_4680_;
                                        let _e2455 = phi_4681_;
                                        let _e2457 = phi_4682_;
                                        if _e849 {
                                            phi_4692_ = select(_e843, 0u, _e1993.member_1);
                                            phi_4693_ = _e845;
                                        } else {
                                            phi_4692_ = _e2455;
                                            phi_4693_ = _e2457;
                                        }
                                        let _e2461 = phi_4692_;
                                        let _e2463 = phi_4693_;
                                        phi_5383_ = _e1991;
                                        phi_4694_ = _e1993;
                                        phi_4695_ = (_e804 - 1u);
                                        phi_4696_ = select(_e2453, false, _e849);
                                        phi_4697_ = _e2461;
                                        phi_4698_ = _e2463;
                                    } else {
                                        phi_5383_ = _e800;
                                        phi_4694_ = _e802;
                                        phi_4695_ = _e804;
                                        phi_4696_ = _e841;
                                        phi_4697_ = _e843;
                                        phi_4698_ = _e845;
                                    }
                                    let _e2466 = phi_5383_;
                                    let _e2468 = phi_4694_;
                                    let _e2470 = phi_4695_;
                                    let _e2472 = phi_4696_;
                                    let _e2474 = phi_4697_;
                                    let _e2476 = phi_4698_;
                                    phi_5382_ = _e2466;
                                    phi_4699_ = _e2468;
                                    phi_4700_ = _e2470;
                                    phi_4701_ = _e2472;
                                    phi_4702_ = _e2474;
                                    phi_4703_ = _e2476;
                                } else {
                                    phi_5382_ = _e800;
                                    phi_4699_ = type_47();
                                    phi_4700_ = u32();
                                    phi_4701_ = bool();
                                    phi_4702_ = u32();
                                    phi_4703_ = type_59();
                                }
                                let _e2478 = phi_5382_;
                                let _e2480 = phi_4699_;
                                let _e2482 = phi_4700_;
                                let _e2484 = phi_4701_;
                                let _e2486 = phi_4702_;
                                let _e2488 = phi_4703_;
                                phi_5381_ = _e2478;
                                phi_1387_ = _e2480;
                                phi_1390_ = _e2482;
                                phi_1392_ = _e2484;
                                phi_1394_ = _e2486;
                                phi_1396_ = _e2488;
                                phi_4704_ = _e814;
                            } else {
                                phi_5381_ = _e800;
                                phi_1387_ = type_47();
                                phi_1390_ = u32();
                                phi_1392_ = bool();
                                phi_1394_ = u32();
                                phi_1396_ = type_59();
                                phi_4704_ = false;
                            }
                            let _e2490 = phi_5381_;
                            let _e2492 = phi_1387_;
                            let _e2494 = phi_1390_;
                            let _e2496 = phi_1392_;
                            let _e2498 = phi_1394_;
                            let _e2500 = phi_1396_;
                            let _e2502 = phi_4704_;
                            continue;
                            continuing {
                                phi_5142_ = _e2490;
                                phi_1386_ = _e2492;
                                phi_1389_ = _e2494;
                                phi_1391_ = _e2496;
                                phi_1393_ = _e2498;
                                phi_1395_ = _e2500;
                                phi_5380_ = _e2490;
                                break if !(_e2502);
                            }
                        }
                        let _e2505 = phi_5380_;
                        if _e2505 {
                            break;
                        }
                        let _e2507 = local_10;
                        if _e2507.member_1 {
                        } else {
                            if _e308 {
                            } else {
                                break;
                            }
                            let _e2511 = global_2.member[_e154];
                            if _e169 {
                            } else {
                                break;
                            }
                            let _e2515 = global_9.member[_e154].member_1;
                            if _e308 {
                            } else {
                                break;
                            }
                            global_2.member[_e154] = type_27(_e2511.member, _e2511.member_1, _e2511.member_2, array<f32, 3>((_e2511.member_3[0] + (_e2515[0] * _e2511.member_1[0])), (_e2511.member_3[1] + (_e2515[1] * _e2511.member_1[1])), (_e2511.member_3[2] + (_e2515[2] * _e2511.member_1[2]))), _e2511.member_4);
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
fn trace_shadows_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
