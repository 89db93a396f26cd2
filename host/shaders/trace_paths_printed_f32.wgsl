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

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_34 {
    member: array<type_32>,
}

struct type_40 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_43 {
    member: type_27,
    member_1: f32,
}

struct type_47 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: array<i32>,
}

struct type_54 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_56 {
    member: array<type_54>,
}

struct type_59 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_61 {
    member: type_59,
    member_1: u32,
}

struct type_66 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_47;
@group(0) @binding(2) 
var<uniform> global_3: type_47;
@group(0) @binding(4) 
var<storage> global_4: type_20;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_50;
@group(0) @binding(7) 
var<storage> global_7: type_34;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_29;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_66;
@group(0) @binding(3) 
var<storage> global_10: type_56;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_267_: u32;
    var phi_311_: i32;
    var phi_335_: type_40;
    var phi_441_: i32;
    var phi_442_: i32;
    var phi_452_: bool;
    var phi_462_: u32;
    var phi_463_: u32;
    var phi_465_: bool;
    var phi_470_: u32;
    var phi_502_: i32;
    var phi_520_: f32;
    var phi_526_: f32;
    var phi_537_: f32;
    var phi_543_: f32;
    var phi_566_: f32;
    var phi_577_: f32;
    var phi_586_: f32;
    var phi_592_: f32;
    var phi_603_: f32;
    var phi_609_: f32;
    var phi_632_: f32;
    var phi_643_: f32;
    var phi_652_: f32;
    var phi_658_: f32;
    var phi_669_: f32;
    var phi_675_: f32;
    var phi_698_: f32;
    var phi_709_: f32;
    var phi_809_: f32;
    var phi_810_: f32;
    var phi_3220_: bool;
    var phi_883_: type_43;
    var phi_886_: type_61;
    var phi_888_: u32;
    var phi_890_: bool;
    var phi_892_: u32;
    var phi_903_: bool;
    var phi_989_: type_61;
    var phi_990_: bool;
    var phi_991_: u32;
    var phi_2097_: type_54;
    var phi_2929_: type_61;
    var phi_3006_: type_61;
    var phi_3007_: type_61;
    var phi_3008_: u32;
    var phi_3010_: type_61;
    var phi_3011_: u32;
    var phi_3012_: bool;
    var phi_3019_: type_61;
    var phi_3024_: type_61;
    var phi_3025_: bool;
    var phi_1009_: type_43;
    var phi_1012_: type_8;
    var phi_1013_: type_8;
    var phi_1035_: type_8;
    var phi_1056_: u32;
    var phi_1145_: array<array<f32, 3>, 3>;
    var phi_1616_: vec3<f32>;
    var phi_1617_: vec3<f32>;
    var phi_1648_: bool;
    var phi_1657_: vec3<f32>;
    var phi_1697_: type_27;
    var phi_1699_: type_27;
    var phi_1700_: bool;
    var phi_1704_: type_27;
    var phi_1705_: type_27;
    var phi_1706_: type_27;
    var phi_1707_: bool;
    var phi_1711_: type_27;
    var phi_1712_: bool;
    var phi_1716_: type_27;
    var phi_1717_: bool;
    var phi_1721_: type_27;
    var phi_1744_: u32;
    var phi_1758_: i32;
    var phi_1778_: vec3<f32>;
    var phi_1779_: vec3<f32>;
    var phi_1795_: vec3<f32>;
    var phi_1796_: vec3<f32>;
    var phi_1812_: vec3<f32>;
    var phi_1813_: vec3<f32>;
    var phi_1849_: vec3<f32>;
    var phi_2031_: f32;
    var phi_2049_: bool;
    var phi_2050_: bool;
    var phi_2069_: bool;
    var phi_2070_: bool;
    var phi_2076_: type_43;
    var phi_2077_: type_43;
    var phi_2078_: type_43;
    var phi_1010_: type_43;
    var phi_3214_: bool;
    var phi_3356_: bool;
    var phi_3027_: type_43;
    var phi_3028_: type_61;
    var phi_3029_: bool;
    var phi_3030_: u32;
    var phi_3355_: bool;
    var phi_3031_: type_43;
    var phi_3032_: type_61;
    var phi_3033_: u32;
    var phi_3034_: bool;
    var phi_3035_: u32;
    var phi_3354_: bool;
    var phi_3036_: type_43;
    var phi_3037_: type_61;
    var phi_3038_: u32;
    var phi_3039_: bool;
    var phi_3040_: u32;
    var phi_3353_: bool;
    var phi_884_: type_43;
    var phi_887_: type_61;
    var phi_889_: u32;
    var phi_891_: bool;
    var phi_893_: u32;
    var phi_3041_: bool;
    var phi_3352_: bool;
    var local_10: type_43;
    var phi_3093_: type_27;
    var local_11: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e85 = global;
            let _e88 = arrayLength((&global_10.member));
            let _e90 = arrayLength((&global_4.member));
            let _e102 = arrayLength((&global_9.member));
            let _e106 = global_3.member[0u][0u];
            let _e110 = global_3.member[0u][1u];
            let _e114 = global_3.member[0u][2u];
            let _e118 = global_3.member[1u][0u];
            let _e122 = global_3.member[1u][1u];
            let _e126 = global_3.member[1u][2u];
            let _e130 = global_3.member[1u][3u];
            let _e134 = (_e85.x + (_e85.y * 2097152u));
            let _e141 = (_e134 < arrayLength((&global_7.member)));
            if _e141 {
                if _e141 {
                } else {
                    break;
                }
                let _e145 = global_7.member[_e134].member_2;
                phi_267_ = _e145;
            } else {
                phi_267_ = 4294967295u;
            }
            let _e147 = phi_267_;
            let _e150 = global_1.member[0u];
            let _e154 = global_2.member[0u][0u];
            let _e158 = global_2.member[0u][1u];
            let _e162 = global_2.member[0u][2u];
            let _e166 = global_2.member[0u][3u];
            let _e170 = global_2.member[1u][0u];
            let _e174 = global_2.member[1u][1u];
            let _e178 = global_2.member[1u][2u];
            let _e182 = global_2.member[1u][3u];
            let _e183 = bitcast<f32>(_e154);
            let _e184 = bitcast<f32>(_e158);
            let _e185 = bitcast<f32>(_e162);
            let _e187 = bitcast<f32>(_e170);
            let _e188 = array<u32, 3>(_e174, _e178, _e182);
            let _e190 = bitcast<i32>(_e150);
            if (_e190 < -126i) {
                phi_311_ = -126i;
            } else {
                phi_311_ = select(_e190, 127i, (_e190 > 127i));
            }
            let _e195 = phi_311_;
            let _e200 = bitcast<f32>((bitcast<u32>((_e195 + 127i)) << bitcast<u32>(23i)));
            let _e206 = bitcast<f32>((bitcast<u32>(((_e190 - _e195) + 127i)) << bitcast<u32>(23i)));
            if (_e166 == 0u) {
                phi_335_ = type_40(array<f32, 3>(_e183, _e184, _e185), _e166, _e187, _e188);
            } else {
                phi_335_ = type_40(array<f32, 3>(((_e183 * _e200) * _e206), ((_e184 * _e200) * _e206), ((_e185 * _e200) * _e206)), _e166, ((_e187 * _e200) * _e206), _e188);
            }
            let _e219 = phi_335_;
            if _e141 {
                let _e220 = (_e134 < arrayLength((&global_8.member)));
                if _e220 {
                    if _e141 {
                    } else {
                        break;
                    }
                    let _e230 = global_7.member[_e134].member.member_2[0u];
                    let _e232 = (bitcast<u32>(_e230) & 2147483647u);
                    let _e238 = global_7.member[_e134].member.member_2[1u];
                    let _e240 = (bitcast<u32>(_e238) & 2147483647u);
                    let _e246 = global_7.member[_e134].member.member_2[2u];
                    let _e248 = (bitcast<u32>(_e246) & 2147483647u);
                    let _e254 = global_7.member[_e134].member.member[0u];
                    let _e256 = (bitcast<u32>(_e254) & 2147483647u);
                    let _e262 = global_7.member[_e134].member.member[1u];
                    let _e264 = (bitcast<u32>(_e262) & 2147483647u);
                    let _e270 = global_7.member[_e134].member.member[2u];
                    let _e272 = (bitcast<u32>(_e270) & 2147483647u);
                    let _e274 = select(_e240, _e232, (_e240 < _e232));
                    let _e276 = select(_e248, _e274, (_e248 < _e274));
                    let _e278 = select(_e256, _e276, (_e256 < _e276));
                    let _e280 = select(_e264, _e278, (_e264 < _e278));
                    let _e282 = select(_e272, _e280, (_e272 < _e280));
                    let _e287 = global_7.member[_e134].member.member_1;
                    let _e289 = (bitcast<u32>(_e287) & 2147483647u);
                    let _e297 = global_7.member[_e134].member.member_3;
                    let _e303 = (((select(_e289, _e282, (_e289 < _e282)) < 2139095040u) && ((bitcast<u32>(_e297) & 2147483647u) <= 2139095040u)) && (_e276 > 0u));
                    if _e303 {
                        let _e306 = (bitcast<u32>(bitcast<f32>(_e276)) & 2147483647u);
                        if (_e306 >= 8388608u) {
                            phi_441_ = (bitcast<i32>((_e306 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_441_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e306)), 32u, (_e306 == 0u))));
                        }
                        let _e320 = phi_441_;
                        phi_442_ = _e320;
                    } else {
                        phi_442_ = 0i;
                    }
                    let _e322 = phi_442_;
                    let _e323 = (_e232 == _e276);
                    if _e323 {
                        phi_452_ = true;
                    } else {
                        phi_452_ = (_e240 == _e276);
                    }
                    let _e326 = phi_452_;
                    let _e327 = select(1u, 0u, _e323);
                    if _e326 {
                        let _e328 = (_e327 + 1u);
                        phi_462_ = _e328;
                        phi_463_ = _e328;
                        phi_465_ = select(true, false, (_e328 == 2u));
                    } else {
                        phi_462_ = u32();
                        phi_463_ = 0u;
                        phi_465_ = true;
                    }
                    let _e332 = phi_462_;
                    let _e334 = phi_463_;
                    let _e336 = phi_465_;
                    if _e336 {
                        phi_470_ = (_e334 + 1u);
                    } else {
                        phi_470_ = 0u;
                    }
                    let _e340 = phi_470_;
                    let _e341 = select(_e332, _e334, _e336);
                    let _e342 = select(_e327, select(2u, _e327, _e326), _e336);
                    let _e343 = -(_e322);
                    if (_e343 < -126i) {
                        phi_502_ = -126i;
                    } else {
                        phi_502_ = select(_e343, 127i, (_e343 > 127i));
                    }
                    let _e348 = phi_502_;
                    let _e353 = bitcast<f32>((bitcast<u32>((_e348 + 127i)) << bitcast<u32>(23i)));
                    let _e359 = bitcast<f32>((bitcast<u32>(((_e343 - _e348) + 127i)) << bitcast<u32>(23i)));
                    let _e364 = global_7.member[_e134].member.member;
                    let _e365 = (_e341 == 0u);
                    if _e365 {
                        phi_520_ = _e364[0];
                    } else {
                        phi_520_ = _e364[1];
                    }
                    let _e369 = phi_520_;
                    let _e370 = (_e341 == 2u);
                    if _e370 {
                        phi_526_ = _e364[2];
                    } else {
                        phi_526_ = _e369;
                    }
                    let _e373 = phi_526_;
                    let _e374 = global_7.member[_e134].member.member_2;
                    if _e365 {
                        phi_537_ = _e374[0];
                    } else {
                        phi_537_ = _e374[1];
                    }
                    let _e378 = phi_537_;
                    if _e370 {
                        phi_543_ = _e374[2];
                    } else {
                        phi_543_ = _e378;
                    }
                    let _e381 = phi_543_;
                    let _e383 = ((_e381 * _e353) * _e359);
                    let _e387 = (bitcast<f32>((bitcast<u32>(_e383) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e387 {
                        let _e391 = (bitcast<f32>((bitcast<u32>(_e373) & 2147483647u)) * 0.00000011920929f);
                        phi_566_ = select(0.00000000000011368684f, _e391, (_e391 > 0.00000000000011368684f));
                    } else {
                        phi_566_ = 0f;
                    }
                    let _e395 = phi_566_;
                    let _e396 = (_e373 + _e395);
                    let _e397 = (_e373 - _e395);
                    let _e398 = select(_e383, 0f, _e387);
                    if _e387 {
                        phi_577_ = 38685626000000000000000000f;
                    } else {
                        phi_577_ = (1f / _e383);
                    }
                    let _e401 = phi_577_;
                    let _e402 = (_e340 == 0u);
                    if _e402 {
                        phi_586_ = _e364[0];
                    } else {
                        phi_586_ = _e364[1];
                    }
                    let _e406 = phi_586_;
                    let _e407 = (_e340 == 2u);
                    if _e407 {
                        phi_592_ = _e364[2];
                    } else {
                        phi_592_ = _e406;
                    }
                    let _e410 = phi_592_;
                    if _e402 {
                        phi_603_ = _e374[0];
                    } else {
                        phi_603_ = _e374[1];
                    }
                    let _e414 = phi_603_;
                    if _e407 {
                        phi_609_ = _e374[2];
                    } else {
                        phi_609_ = _e414;
                    }
                    let _e417 = phi_609_;
                    let _e419 = ((_e417 * _e353) * _e359);
                    let _e423 = (bitcast<f32>((bitcast<u32>(_e419) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e423 {
                        let _e427 = (bitcast<f32>((bitcast<u32>(_e410) & 2147483647u)) * 0.00000011920929f);
                        phi_632_ = select(0.00000000000011368684f, _e427, (_e427 > 0.00000000000011368684f));
                    } else {
                        phi_632_ = 0f;
                    }
                    let _e431 = phi_632_;
                    let _e432 = (_e410 + _e431);
                    let _e433 = (_e410 - _e431);
                    let _e434 = select(_e419, 0f, _e423);
                    if _e423 {
                        phi_643_ = 38685626000000000000000000f;
                    } else {
                        phi_643_ = (1f / _e419);
                    }
                    let _e437 = phi_643_;
                    let _e438 = (_e342 == 0u);
                    if _e438 {
                        phi_652_ = _e364[0];
                    } else {
                        phi_652_ = _e364[1];
                    }
                    let _e442 = phi_652_;
                    let _e443 = (_e342 == 2u);
                    if _e443 {
                        phi_658_ = _e364[2];
                    } else {
                        phi_658_ = _e442;
                    }
                    let _e446 = phi_658_;
                    if _e438 {
                        phi_669_ = _e374[0];
                    } else {
                        phi_669_ = _e374[1];
                    }
                    let _e450 = phi_669_;
                    if _e443 {
                        phi_675_ = _e374[2];
                    } else {
                        phi_675_ = _e450;
                    }
                    let _e453 = phi_675_;
                    let _e455 = ((_e453 * _e353) * _e359);
                    let _e459 = (bitcast<f32>((bitcast<u32>(_e455) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e459 {
                        let _e463 = (bitcast<f32>((bitcast<u32>(_e446) & 2147483647u)) * 0.00000011920929f);
                        phi_698_ = select(0.00000000000011368684f, _e463, (_e463 > 0.00000000000011368684f));
                    } else {
                        phi_698_ = 0f;
                    }
                    let _e467 = phi_698_;
                    let _e468 = (_e446 + _e467);
                    let _e469 = (_e446 - _e467);
                    let _e470 = select(_e455, 0f, _e459);
                    if _e459 {
                        phi_709_ = 38685626000000000000000000f;
                    } else {
                        phi_709_ = (1f / _e455);
                    }
                    let _e473 = phi_709_;
                    let _e476 = bitcast<f32>((bitcast<u32>(_e373) & 2147483647u));
                    let _e479 = bitcast<f32>((bitcast<u32>(_e410) & 2147483647u));
                    let _e481 = select(_e479, _e476, (_e476 > _e479));
                    let _e484 = bitcast<f32>((bitcast<u32>(_e446) & 2147483647u));
                    if (_e303 && (select(_e484, _e481, (_e481 > _e484)) <= 1099511600000f)) {
                        let _e489 = (_e322 / 3i);
                        let _e496 = bitcast<f32>((bitcast<u32>((_e489 + 127i)) << bitcast<u32>(23i)));
                        let _e503 = bitcast<f32>((bitcast<u32>(((_e322 - (2i * _e489)) + 127i)) << bitcast<u32>(23i)));
                        let _e504 = (((_e287 * _e496) * _e496) * _e503);
                        let _e506 = select(340282350000000000000000000000000000000f, _e504, (_e504 < 340282350000000000000000000000000000000f));
                        let _e511 = (((_e297 * _e496) * _e496) * _e503);
                        let _e513 = select(340282350000000000000000000000000000000f, _e511, (_e511 < 340282350000000000000000000000000000000f));
                        phi_809_ = select(-340282350000000000000000000000000000000f, _e513, (_e513 > -340282350000000000000000000000000000000f));
                        phi_810_ = select(-340282350000000000000000000000000000000f, _e506, (_e506 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_809_ = 0f;
                        phi_810_ = 1f;
                    }
                    let _e517 = phi_809_;
                    let _e519 = phi_810_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e106), bitcast<f32>(_e110), bitcast<f32>(_e114));
                    let _e524 = (_e341 % 3u);
                    let _e525 = (_e524 < 3u);
                    if _e525 {
                    } else {
                        break;
                    }
                    let _e527 = local_9[_e524];
                    let _e528 = (_e340 % 3u);
                    let _e529 = (_e528 < 3u);
                    if _e529 {
                    } else {
                        break;
                    }
                    let _e531 = local_9[_e528];
                    let _e532 = (_e342 % 3u);
                    let _e533 = (_e532 < 3u);
                    if _e533 {
                    } else {
                        break;
                    }
                    let _e535 = local_9[_e532];
                    local_8 = array<f32, 3>(bitcast<f32>(_e118), bitcast<f32>(_e122), bitcast<f32>(_e126));
                    if _e525 {
                    } else {
                        break;
                    }
                    let _e539 = local_8[_e524];
                    if _e529 {
                    } else {
                        break;
                    }
                    let _e541 = local_8[_e528];
                    if _e533 {
                    } else {
                        break;
                    }
                    let _e543 = local_8[_e532];
                    phi_3220_ = false;
                    phi_883_ = type_43(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e517);
                    phi_886_ = type_61(type_59(array<f32, 3>(_e527, _e531, _e535), array<f32, 3>(_e539, _e541, _e543)), select(0u, 2147483648u, (_e88 == 0u)));
                    phi_888_ = ((3u * _e88) + 1u);
                    phi_890_ = (_e519 <= _e517);
                    phi_892_ = 0u;
                    loop {
                        let _e551 = phi_3220_;
                        let _e553 = phi_883_;
                        let _e555 = phi_886_;
                        let _e557 = phi_888_;
                        let _e559 = phi_890_;
                        let _e561 = phi_892_;
                        local_10 = _e553;
                        if _e559 {
                            phi_903_ = true;
                        } else {
                            phi_903_ = (_e561 > 0u);
                        }
                        let _e564 = phi_903_;
                        if _e564 {
                            let _e565 = (_e557 > 0u);
                            if _e565 {
                                if _e559 {
                                    phi_989_ = _e555;
                                    phi_990_ = _e559;
                                    phi_991_ = _e561;
                                } else {
                                    let _e566 = (_e561 - 1u);
                                    let _e567 = (_e566 % 128u);
                                    let _e568 = (_e567 < 128u);
                                    if _e568 {
                                    } else {
                                        phi_3352_ = true;
                                        break;
                                    }
                                    let _e570 = local_6[_e567];
                                    if _e568 {
                                    } else {
                                        phi_3352_ = true;
                                        break;
                                    }
                                    let _e572 = local_5[_e567];
                                    if _e568 {
                                    } else {
                                        phi_3352_ = true;
                                        break;
                                    }
                                    let _e574 = local_4[_e567];
                                    if _e568 {
                                    } else {
                                        phi_3352_ = true;
                                        break;
                                    }
                                    let _e576 = local_3[_e567];
                                    if _e568 {
                                    } else {
                                        phi_3352_ = true;
                                        break;
                                    }
                                    let _e579 = local_2[_e567];
                                    if _e568 {
                                    } else {
                                        phi_3352_ = true;
                                        break;
                                    }
                                    let _e581 = local_1[_e567];
                                    if _e568 {
                                    } else {
                                        phi_3352_ = true;
                                        break;
                                    }
                                    let _e583 = local[_e567];
                                    if _e568 {
                                    } else {
                                        phi_3352_ = true;
                                        break;
                                    }
                                    let _e588 = local_7[_e567];
                                    phi_989_ = type_61(type_59(array<f32, 3>(_e572, _e574, _e576), array<f32, 3>(_e579, _e581, _e583)), _e570);
                                    phi_990_ = (_e588 <= _e553.member_1);
                                    phi_991_ = _e566;
                                }
                                let _e592 = phi_989_;
                                let _e594 = phi_990_;
                                let _e596 = phi_991_;
                                if _e594 {
                                    if ((_e592.member_1 & 2147483648u) != 0u) {
                                        phi_1009_ = _e553;
                                        phi_1012_ = type_8(0u, ((_e592.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e948 = phi_1009_;
                                            let _e950 = phi_1012_;
                                            local_11 = _e948;
                                            if (_e950.member < _e950.member_1) {
                                                phi_1013_ = type_8((_e950.member + 1u), _e950.member_1);
                                                phi_1035_ = type_8(1u, _e950.member);
                                            } else {
                                                phi_1013_ = _e950;
                                                phi_1035_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e963 = phi_1013_;
                                            let _e965 = phi_1035_;
                                            let _e969 = (bitcast<i32>(_e965.member) != 0i);
                                            if _e969 {
                                                let _e970 = ((_e592.member_1 & 268435455u) + _e965.member_1);
                                                let _e971 = (_e970 < _e90);
                                                if _e971 {
                                                    if _e971 {
                                                    } else {
                                                        phi_3214_ = true;
                                                        break;
                                                    }
                                                    let _e975 = global_4.member[_e970].member_1;
                                                    phi_1056_ = _e975;
                                                } else {
                                                    phi_1056_ = 4294967295u;
                                                }
                                                let _e977 = phi_1056_;
                                                if (_e970 >= _e90) {
                                                    phi_1145_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e971 {
                                                    } else {
                                                        phi_3214_ = true;
                                                        break;
                                                    }
                                                    if (_e524 < 9u) {
                                                    } else {
                                                        phi_3214_ = true;
                                                        break;
                                                    }
                                                    let _e984 = global_4.member[_e970].member[_e524];
                                                    if (_e528 < 9u) {
                                                    } else {
                                                        phi_3214_ = true;
                                                        break;
                                                    }
                                                    let _e990 = global_4.member[_e970].member[_e528];
                                                    if (_e532 < 9u) {
                                                    } else {
                                                        phi_3214_ = true;
                                                        break;
                                                    }
                                                    let _e996 = global_4.member[_e970].member[_e532];
                                                    let _e998 = (3u + _e524);
                                                    if (_e998 < 9u) {
                                                    } else {
                                                        phi_3214_ = true;
                                                        break;
                                                    }
                                                    let _e1004 = global_4.member[_e970].member[_e998];
                                                    let _e1005 = (3u + _e528);
                                                    if (_e1005 < 9u) {
                                                    } else {
                                                        phi_3214_ = true;
                                                        break;
                                                    }
                                                    let _e1011 = global_4.member[_e970].member[_e1005];
                                                    let _e1012 = (3u + _e532);
                                                    if (_e1012 < 9u) {
                                                    } else {
                                                        phi_3214_ = true;
                                                        break;
                                                    }
                                                    let _e1018 = global_4.member[_e970].member[_e1012];
                                                    let _e1020 = (6u + _e524);
                                                    if (_e1020 < 9u) {
                                                    } else {
                                                        phi_3214_ = true;
                                                        break;
                                                    }
                                                    let _e1026 = global_4.member[_e970].member[_e1020];
                                                    let _e1027 = (6u + _e528);
                                                    if (_e1027 < 9u) {
                                                    } else {
                                                        phi_3214_ = true;
                                                        break;
                                                    }
                                                    let _e1033 = global_4.member[_e970].member[_e1027];
                                                    let _e1034 = (6u + _e532);
                                                    if (_e1034 < 9u) {
                                                    } else {
                                                        phi_3214_ = true;
                                                        break;
                                                    }
                                                    let _e1040 = global_4.member[_e970].member[_e1034];
                                                    phi_1145_ = array<array<f32, 3>, 3>(array<f32, 3>(_e984, _e990, _e996), array<f32, 3>(_e1004, _e1011, _e1018), array<f32, 3>(_e1026, _e1033, _e1040));
                                                }
                                                let _e1044 = phi_1145_;
                                                let _e1052 = (_e1044[0][2] - _e446);
                                                let _e1055 = (((_e1044[0][0] - _e373) * _e470) - (_e1052 * _e398));
                                                let _e1058 = (((_e1044[0][1] - _e410) * _e470) - (_e1052 * _e434));
                                                let _e1065 = (_e1044[1][2] - _e446);
                                                let _e1068 = (((_e1044[1][0] - _e373) * _e470) - (_e1065 * _e398));
                                                let _e1071 = (((_e1044[1][1] - _e410) * _e470) - (_e1065 * _e434));
                                                let _e1078 = (_e1044[2][2] - _e446);
                                                let _e1081 = (((_e1044[2][0] - _e373) * _e470) - (_e1078 * _e398));
                                                let _e1084 = (((_e1044[2][1] - _e410) * _e470) - (_e1078 * _e434));
                                                let _e1085 = (_e1081 * _e1071);
                                                let _e1086 = (_e1084 * _e1068);
                                                let _e1087 = (_e1055 * _e1084);
                                                let _e1088 = (_e1058 * _e1081);
                                                let _e1089 = (_e1068 * _e1058);
                                                let _e1090 = (_e1071 * _e1055);
                                                let _e1095 = (((_e1085 >= _e1086) && (_e1087 >= _e1088)) && (_e1089 >= _e1090));
                                                if (_e1095 || (((_e1085 <= _e1086) && (_e1087 <= _e1088)) && (_e1089 <= _e1090))) {
                                                    let _e1102 = select(-1f, 1f, _e1095);
                                                    let _e1104 = ((_e1085 - _e1086) * _e1102);
                                                    let _e1106 = select(0f, _e1104, (_e1104 > 0f));
                                                    let _e1108 = ((_e1087 - _e1088) * _e1102);
                                                    let _e1110 = select(0f, _e1108, (_e1108 > 0f));
                                                    let _e1112 = ((_e1089 - _e1090) * _e1102);
                                                    let _e1114 = select(0f, _e1112, (_e1112 > 0f));
                                                    let _e1116 = ((_e1106 + _e1110) + _e1114);
                                                    if (_e1116 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1711_ = type_27();
                                                        phi_1712_ = true;
                                                    } else {
                                                        let _e1119 = select(_e1044[1][0], _e1044[0][0], (_e1044[0][0] < _e1044[1][0]));
                                                        let _e1123 = select(_e1044[1][0], _e1044[0][0], (_e1044[0][0] > _e1044[1][0]));
                                                        let _e1127 = select(_e1044[1][1], _e1044[0][1], (_e1044[0][1] < _e1044[1][1]));
                                                        let _e1131 = select(_e1044[1][1], _e1044[0][1], (_e1044[0][1] > _e1044[1][1]));
                                                        let _e1135 = select(_e1044[1][2], _e1044[0][2], (_e1044[0][2] < _e1044[1][2]));
                                                        let _e1139 = select(_e1044[1][2], _e1044[0][2], (_e1044[0][2] > _e1044[1][2]));
                                                        let _e1144 = ((select(_e1044[2][0], _e1119, (_e1119 < _e1044[2][0])) - _e396) * _e401);
                                                        let _e1145 = ((select(_e1044[2][0], _e1123, (_e1123 > _e1044[2][0])) - _e397) * _e401);
                                                        let _e1148 = ((select(_e1044[2][1], _e1127, (_e1127 < _e1044[2][1])) - _e432) * _e437);
                                                        let _e1149 = ((select(_e1044[2][1], _e1131, (_e1131 > _e1044[2][1])) - _e433) * _e437);
                                                        let _e1152 = ((select(_e1044[2][2], _e1135, (_e1135 < _e1044[2][2])) - _e468) * _e473);
                                                        let _e1153 = ((select(_e1044[2][2], _e1139, (_e1139 > _e1044[2][2])) - _e469) * _e473);
                                                        let _e1155 = select(_e1153, _e1152, (_e1152 < _e1153));
                                                        let _e1157 = select(_e1153, _e1152, (_e1152 > _e1153));
                                                        let _e1159 = select(_e1145, _e1144, (_e1144 < _e1145));
                                                        let _e1161 = select(_e1149, _e1148, (_e1148 < _e1149));
                                                        let _e1163 = select(_e1161, _e1159, (_e1159 > _e1161));
                                                        let _e1165 = select(_e1155, _e1163, (_e1163 > _e1155));
                                                        let _e1167 = select(_e1145, _e1144, (_e1144 > _e1145));
                                                        let _e1169 = select(_e1149, _e1148, (_e1148 > _e1149));
                                                        let _e1171 = select(_e1169, _e1167, (_e1167 < _e1169));
                                                        let _e1173 = select(_e1157, _e1171, (_e1171 < _e1157));
                                                        let _e1174 = -(_e1155);
                                                        let _e1180 = select(_e519, _e1165, (_e1165 > _e519));
                                                        if (_e1180 > (_e1173 + (select(_e1174, _e1157, (_e1157 > _e1174)) * 0.0000019073523f))) {
                                                            phi_1706_ = type_27();
                                                            phi_1707_ = true;
                                                        } else {
                                                            let _e1182 = (_e1180 > _e948.member_1);
                                                            if _e1182 {
                                                                phi_1705_ = type_27();
                                                            } else {
                                                                let _e1186 = (_e1044[1][0] - _e1044[0][0]);
                                                                let _e1187 = (_e1044[1][1] - _e1044[0][1]);
                                                                let _e1188 = (_e1044[1][2] - _e1044[0][2]);
                                                                let _e1189 = vec3<f32>(_e1186, _e1187, _e1188);
                                                                let _e1190 = (_e1044[2][0] - _e1044[1][0]);
                                                                let _e1191 = (_e1044[2][1] - _e1044[1][1]);
                                                                let _e1192 = (_e1044[2][2] - _e1044[1][2]);
                                                                let _e1193 = vec3<f32>(_e1190, _e1191, _e1192);
                                                                let _e1194 = (_e1044[0][0] - _e1044[2][0]);
                                                                let _e1195 = (_e1044[0][1] - _e1044[2][1]);
                                                                let _e1196 = (_e1044[0][2] - _e1044[2][2]);
                                                                let _e1197 = vec3<f32>(_e1194, _e1195, _e1196);
                                                                let _e1200 = bitcast<f32>((bitcast<u32>(_e1186) & 2147483647u));
                                                                let _e1203 = bitcast<f32>((bitcast<u32>(_e1187) & 2147483647u));
                                                                let _e1205 = select(_e1203, _e1200, (_e1200 > _e1203));
                                                                let _e1208 = bitcast<f32>((bitcast<u32>(_e1188) & 2147483647u));
                                                                let _e1210 = select(_e1208, _e1205, (_e1205 > _e1208));
                                                                let _e1213 = bitcast<f32>((bitcast<u32>(_e1190) & 2147483647u));
                                                                let _e1216 = bitcast<f32>((bitcast<u32>(_e1191) & 2147483647u));
                                                                let _e1218 = select(_e1216, _e1213, (_e1213 > _e1216));
                                                                let _e1221 = bitcast<f32>((bitcast<u32>(_e1192) & 2147483647u));
                                                                let _e1223 = select(_e1221, _e1218, (_e1218 > _e1221));
                                                                let _e1226 = bitcast<f32>((bitcast<u32>(_e1194) & 2147483647u));
                                                                let _e1229 = bitcast<f32>((bitcast<u32>(_e1195) & 2147483647u));
                                                                let _e1231 = select(_e1229, _e1226, (_e1226 > _e1229));
                                                                let _e1234 = bitcast<f32>((bitcast<u32>(_e1196) & 2147483647u));
                                                                let _e1236 = select(_e1234, _e1231, (_e1231 > _e1234));
                                                                let _e1238 = select(_e1223, _e1210, (_e1210 > _e1223));
                                                                let _e1240 = select(_e1236, _e1238, (_e1238 > _e1236));
                                                                if (_e1210 == _e1240) {
                                                                    phi_1616_ = _e1193;
                                                                    phi_1617_ = _e1197;
                                                                } else {
                                                                    let _e1243 = vec3((_e1223 == _e1240));
                                                                    phi_1616_ = select(_e1189, _e1197, _e1243);
                                                                    phi_1617_ = select(_e1193, _e1189, _e1243);
                                                                }
                                                                let _e1247 = phi_1616_;
                                                                let _e1249 = phi_1617_;
                                                                let _e1256 = ((_e1247.y * _e1249.z) - (_e1249.y * _e1247.z));
                                                                let _e1261 = ((_e1247.z * _e1249.x) - (_e1249.z * _e1247.x));
                                                                let _e1264 = ((_e1247.x * _e1249.y) - (_e1249.x * _e1247.y));
                                                                if (_e1106 >= _e1110) {
                                                                    phi_1648_ = select(true, false, (_e1106 >= _e1114));
                                                                } else {
                                                                    phi_1648_ = true;
                                                                }
                                                                let _e1269 = phi_1648_;
                                                                if _e1269 {
                                                                    phi_1657_ = select(vec3<f32>(_e1044[2][0], _e1044[2][1], _e1044[2][2]), vec3<f32>(_e1044[1][0], _e1044[1][1], _e1044[1][2]), vec3((_e1110 >= _e1114)));
                                                                } else {
                                                                    phi_1657_ = vec3<f32>(_e1044[0][0], _e1044[0][1], _e1044[0][2]);
                                                                }
                                                                let _e1274 = phi_1657_;
                                                                let _e1291 = ((((_e1256 * (_e1274.x - _e373)) + (_e1261 * (_e1274.y - _e410))) + (_e1264 * (_e1274.z - _e446))) / (((_e1256 * _e398) + (_e1261 * _e434)) + (_e1264 * _e470)));
                                                                let _e1293 = select(_e1173, _e1291, (_e1291 < _e1173));
                                                                let _e1295 = select(_e1165, _e1293, (_e1293 > _e1165));
                                                                if (_e1295 >= _e519) {
                                                                    let _e1297 = (_e1295 <= _e948.member_1);
                                                                    if _e1297 {
                                                                        let _e1298 = (1f / _e1116);
                                                                        phi_1697_ = type_27(_e1295, (_e1110 * _e1298), (_e1114 * _e1298), _e977);
                                                                    } else {
                                                                        phi_1697_ = type_27();
                                                                    }
                                                                    let _e1303 = phi_1697_;
                                                                    phi_1699_ = _e1303;
                                                                    phi_1700_ = select(true, false, _e1297);
                                                                } else {
                                                                    phi_1699_ = type_27();
                                                                    phi_1700_ = true;
                                                                }
                                                                let _e1306 = phi_1699_;
                                                                let _e1308 = phi_1700_;
                                                                if _e1308 {
                                                                    phi_1704_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1704_ = _e1306;
                                                                }
                                                                let _e1310 = phi_1704_;
                                                                phi_1705_ = _e1310;
                                                            }
                                                            let _e1312 = phi_1705_;
                                                            phi_1706_ = _e1312;
                                                            phi_1707_ = _e1182;
                                                        }
                                                        let _e1314 = phi_1706_;
                                                        let _e1316 = phi_1707_;
                                                        phi_1711_ = _e1314;
                                                        phi_1712_ = _e1316;
                                                    }
                                                    let _e1318 = phi_1711_;
                                                    let _e1320 = phi_1712_;
                                                    phi_1716_ = _e1318;
                                                    phi_1717_ = _e1320;
                                                } else {
                                                    phi_1716_ = type_27();
                                                    phi_1717_ = true;
                                                }
                                                let _e1322 = phi_1716_;
                                                let _e1324 = phi_1717_;
                                                if _e1324 {
                                                    phi_1721_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1721_ = _e1322;
                                                }
                                                let _e1326 = phi_1721_;
                                                if (_e1326.member_3 != 4294967295u) {
                                                    if (_e977 == _e147) {
                                                        phi_2050_ = false;
                                                    } else {
                                                        let _e1330 = (_e977 < arrayLength((&global_5.member)));
                                                        if _e1330 {
                                                            if _e1330 {
                                                            } else {
                                                                phi_3214_ = true;
                                                                break;
                                                            }
                                                            let _e1332 = global_5.member[_e977];
                                                            phi_1744_ = _e1332;
                                                        } else {
                                                            phi_1744_ = 4294967295u;
                                                        }
                                                        let _e1334 = phi_1744_;
                                                        let _e1335 = (_e1334 < arrayLength((&global_6.member)));
                                                        if _e1335 {
                                                            if _e1335 {
                                                            } else {
                                                                phi_3214_ = true;
                                                                break;
                                                            }
                                                            let _e1337 = global_6.member[_e1334];
                                                            phi_1758_ = _e1337;
                                                        } else {
                                                            phi_1758_ = 0i;
                                                        }
                                                        let _e1339 = phi_1758_;
                                                        let _e1340 = (_e1339 == 0i);
                                                        if _e1340 {
                                                            phi_2049_ = true;
                                                        } else {
                                                            if _e365 {
                                                                phi_1779_ = vec3<f32>(_e1044[0][0], _e1044[0][1], _e1044[0][2]);
                                                            } else {
                                                                if (_e341 == 1u) {
                                                                    phi_1778_ = vec3<f32>(_e1044[0][2], _e1044[0][0], _e1044[0][1]);
                                                                } else {
                                                                    phi_1778_ = vec3<f32>(_e1044[0][1], _e1044[0][2], _e1044[0][0]);
                                                                }
                                                                let _e1345 = phi_1778_;
                                                                phi_1779_ = _e1345;
                                                            }
                                                            let _e1348 = phi_1779_;
                                                            if _e365 {
                                                                phi_1796_ = vec3<f32>(_e1044[1][0], _e1044[1][1], _e1044[1][2]);
                                                            } else {
                                                                if (_e341 == 1u) {
                                                                    phi_1795_ = vec3<f32>(_e1044[1][2], _e1044[1][0], _e1044[1][1]);
                                                                } else {
                                                                    phi_1795_ = vec3<f32>(_e1044[1][1], _e1044[1][2], _e1044[1][0]);
                                                                }
                                                                let _e1353 = phi_1795_;
                                                                phi_1796_ = _e1353;
                                                            }
                                                            let _e1356 = phi_1796_;
                                                            if _e365 {
                                                                phi_1813_ = vec3<f32>(_e1044[2][0], _e1044[2][1], _e1044[2][2]);
                                                            } else {
                                                                if (_e341 == 1u) {
                                                                    phi_1812_ = vec3<f32>(_e1044[2][2], _e1044[2][0], _e1044[2][1]);
                                                                } else {
                                                                    phi_1812_ = vec3<f32>(_e1044[2][1], _e1044[2][2], _e1044[2][0]);
                                                                }
                                                                let _e1361 = phi_1812_;
                                                                phi_1813_ = _e1361;
                                                            }
                                                            let _e1364 = phi_1813_;
                                                            let _e1367 = (_e1356.x - _e1348.x);
                                                            let _e1370 = (_e1356.y - _e1348.y);
                                                            let _e1373 = (_e1356.z - _e1348.z);
                                                            let _e1375 = (_e1364.x - _e1348.x);
                                                            let _e1377 = (_e1364.y - _e1348.y);
                                                            let _e1379 = (_e1364.z - _e1348.z);
                                                            if (_e219.member_1 == 1u) {
                                                                phi_1849_ = (vec3<f32>(_e219.member[0], _e219.member[1], _e219.member[2]) - _e1348);
                                                            } else {
                                                                phi_1849_ = vec3<f32>(_e219.member[0], _e219.member[1], _e219.member[2]);
                                                            }
                                                            let _e1394 = phi_1849_;
                                                            let _e1400 = bitcast<f32>((bitcast<u32>((_e1367 * _e1377)) ^ _e219.member_3[0]));
                                                            let _e1404 = bitcast<f32>((bitcast<u32>((_e1370 * _e1375)) ^ _e219.member_3[0]));
                                                            let _e1408 = bitcast<f32>((bitcast<u32>((_e1370 * _e1379)) ^ _e219.member_3[0]));
                                                            let _e1412 = bitcast<f32>((bitcast<u32>((_e1373 * _e1377)) ^ _e219.member_3[0]));
                                                            let _e1416 = bitcast<f32>((bitcast<u32>((_e1373 * _e1375)) ^ _e219.member_3[0]));
                                                            let _e1420 = bitcast<f32>((bitcast<u32>((_e1367 * _e1379)) ^ _e219.member_3[0]));
                                                            let _e1421 = (_e1408 - _e1412);
                                                            let _e1422 = (_e1416 - _e1420);
                                                            let _e1423 = (_e1400 - _e1404);
                                                            let _e1447 = (bitcast<f32>((bitcast<u32>(_e1408) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1412) & 2147483647u)));
                                                            let _e1454 = (bitcast<f32>((bitcast<u32>(_e1416) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1420) & 2147483647u)));
                                                            let _e1461 = (bitcast<f32>((bitcast<u32>(_e1400) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1404) & 2147483647u)));
                                                            if (_e219.member_2 == 0f) {
                                                                phi_2031_ = 0f;
                                                            } else {
                                                                let _e1491 = bitcast<f32>((bitcast<u32>(_e1421) & 2147483647u));
                                                                let _e1494 = bitcast<f32>((bitcast<u32>(_e1422) & 2147483647u));
                                                                let _e1497 = bitcast<f32>((bitcast<u32>(_e1423) & 2147483647u));
                                                                let _e1499 = select(_e1497, _e1494, (_e1494 > _e1497));
                                                                let _e1503 = select(_e1497, _e1494, (_e1494 < _e1497));
                                                                let _e1507 = select(_e1494, _e1491, (_e1491 < _e1494));
                                                                let _e1509 = select(_e1494, _e1491, (_e1491 > _e1494));
                                                                let _e1511 = select(_e1497, _e1509, (_e1509 < _e1497));
                                                                phi_2031_ = bitcast<f32>((bitcast<u32>((_e219.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1499, _e1491, (_e1491 > _e1499)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1511, _e1507, (_e1507 > _e1511)))) ^ _e219.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1503, _e1491, (_e1491 < _e1503)))) ^ _e219.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1447 + _e1454) + _e1461))) ^ _e219.member_3[0]))) * 1.0000005f)) ^ _e219.member_3[0])))) ^ _e219.member_3[0]));
                                                            }
                                                            let _e1538 = phi_2031_;
                                                            phi_2049_ = (_e1340 || !(((((bitcast<f32>((bitcast<u32>((_e1394.x * _e1421)) ^ _e219.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1394.y * _e1422)) ^ _e219.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1394.z * _e1423)) ^ _e219.member_3[0]))) * f32(-(_e1339))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1394.x) & 2147483647u)) * _e1447)) ^ _e219.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1394.y) & 2147483647u)) * _e1454)) ^ _e219.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1394.z) & 2147483647u)) * _e1461)) ^ _e219.member_3[0]))))) ^ _e219.member_3[0])) + _e1538) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1552 = phi_2049_;
                                                        phi_2050_ = _e1552;
                                                    }
                                                    let _e1554 = phi_2050_;
                                                    if _e1554 {
                                                        if (_e1326.member < _e948.member.member) {
                                                            phi_2070_ = true;
                                                        } else {
                                                            if (_e1326.member == _e948.member.member) {
                                                                phi_2069_ = (_e1326.member_3 < _e948.member.member_3);
                                                            } else {
                                                                phi_2069_ = false;
                                                            }
                                                            let _e1564 = phi_2069_;
                                                            phi_2070_ = _e1564;
                                                        }
                                                        let _e1566 = phi_2070_;
                                                        if _e1566 {
                                                            phi_2076_ = type_43(_e1326, _e1326.member);
                                                        } else {
                                                            phi_2076_ = _e948;
                                                        }
                                                        let _e1569 = phi_2076_;
                                                        phi_2077_ = _e1569;
                                                    } else {
                                                        phi_2077_ = _e948;
                                                    }
                                                    let _e1571 = phi_2077_;
                                                    phi_2078_ = _e1571;
                                                } else {
                                                    phi_2078_ = _e948;
                                                }
                                                let _e1573 = phi_2078_;
                                                phi_1010_ = _e1573;
                                            } else {
                                                phi_1010_ = type_43();
                                            }
                                            let _e1575 = phi_1010_;
                                            continue;
                                            continuing {
                                                phi_1009_ = _e1575;
                                                phi_1012_ = _e963;
                                                phi_3214_ = _e551;
                                                break if !(_e969);
                                            }
                                        }
                                        let _e1578 = phi_3214_;
                                        phi_3352_ = _e1578;
                                        if _e1578 {
                                            break;
                                        }
                                        phi_3356_ = _e1578;
                                        let _e1786 = local_11;
                                        phi_3027_ = _e1786;
                                        phi_3028_ = _e592;
                                        phi_3029_ = false;
                                        phi_3030_ = _e596;
                                    } else {
                                        let _e605 = (_e592.member_1 < _e88);
                                        if _e605 {
                                            if _e605 {
                                            } else {
                                                phi_3352_ = true;
                                                break;
                                            }
                                            let _e607 = global_10.member[_e592.member_1];
                                            phi_2097_ = _e607;
                                        } else {
                                            phi_2097_ = type_54(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e609 = phi_2097_;
                                        let _e624 = ((10u * _e341) & 31u);
                                        let _e627 = ((_e609.member[0] >> bitcast<u32>(_e624)) & 1023u);
                                        let _e632 = bitcast<f32>((bitcast<u32>(((_e592.member.member_1[0] - _e592.member.member[0]) * 0.0009775171f)) ^ _e130));
                                        let _e638 = (_e592.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e627) * _e632)) ^ _e130)));
                                        let _e642 = select(select(_e592.member.member_1[0], _e638, (_e638 < _e592.member.member_1[0])), _e592.member.member_1[0], (_e627 == 1023u));
                                        let _e644 = ((10u * _e340) & 31u);
                                        let _e647 = ((_e609.member[0] >> bitcast<u32>(_e644)) & 1023u);
                                        let _e652 = bitcast<f32>((bitcast<u32>(((_e592.member.member_1[1] - _e592.member.member[1]) * 0.0009775171f)) ^ _e130));
                                        let _e658 = (_e592.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e647) * _e652)) ^ _e130)));
                                        let _e662 = select(select(_e592.member.member_1[1], _e658, (_e658 < _e592.member.member_1[1])), _e592.member.member_1[1], (_e647 == 1023u));
                                        let _e664 = ((10u * _e342) & 31u);
                                        let _e667 = ((_e609.member[0] >> bitcast<u32>(_e664)) & 1023u);
                                        let _e672 = bitcast<f32>((bitcast<u32>(((_e592.member.member_1[2] - _e592.member.member[2]) * 0.0009775171f)) ^ _e130));
                                        let _e678 = (_e592.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e667) * _e672)) ^ _e130)));
                                        let _e682 = select(select(_e592.member.member_1[2], _e678, (_e678 < _e592.member.member_1[2])), _e592.member.member_1[2], (_e667 == 1023u));
                                        let _e685 = ((_e609.member[1] >> bitcast<u32>(_e624)) & 1023u);
                                        let _e691 = (_e592.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e685) * _e632)) ^ _e130)));
                                        let _e695 = select(select(_e592.member.member_1[0], _e691, (_e691 < _e592.member.member_1[0])), _e592.member.member_1[0], (_e685 == 1023u));
                                        let _e698 = ((_e609.member[1] >> bitcast<u32>(_e644)) & 1023u);
                                        let _e704 = (_e592.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e698) * _e652)) ^ _e130)));
                                        let _e708 = select(select(_e592.member.member_1[1], _e704, (_e704 < _e592.member.member_1[1])), _e592.member.member_1[1], (_e698 == 1023u));
                                        let _e711 = ((_e609.member[1] >> bitcast<u32>(_e664)) & 1023u);
                                        let _e717 = (_e592.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e711) * _e672)) ^ _e130)));
                                        let _e721 = select(select(_e592.member.member_1[2], _e717, (_e717 < _e592.member.member_1[2])), _e592.member.member_1[2], (_e711 == 1023u));
                                        let _e727 = ((_e609.member_1[0] >> bitcast<u32>(_e624)) & 1023u);
                                        let _e733 = (_e592.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e727) * _e632)) ^ _e130)));
                                        let _e737 = select(select(_e592.member.member_1[0], _e733, (_e733 < _e592.member.member_1[0])), _e592.member.member_1[0], (_e727 == 1023u));
                                        let _e740 = ((_e609.member_1[0] >> bitcast<u32>(_e644)) & 1023u);
                                        let _e746 = (_e592.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e740) * _e652)) ^ _e130)));
                                        let _e750 = select(select(_e592.member.member_1[1], _e746, (_e746 < _e592.member.member_1[1])), _e592.member.member_1[1], (_e740 == 1023u));
                                        let _e753 = ((_e609.member_1[0] >> bitcast<u32>(_e664)) & 1023u);
                                        let _e759 = (_e592.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e753) * _e672)) ^ _e130)));
                                        let _e763 = select(select(_e592.member.member_1[2], _e759, (_e759 < _e592.member.member_1[2])), _e592.member.member_1[2], (_e753 == 1023u));
                                        let _e766 = ((_e609.member_1[1] >> bitcast<u32>(_e624)) & 1023u);
                                        let _e772 = (_e592.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e766) * _e632)) ^ _e130)));
                                        let _e776 = select(select(_e592.member.member_1[0], _e772, (_e772 < _e592.member.member_1[0])), _e592.member.member_1[0], (_e766 == 1023u));
                                        let _e779 = ((_e609.member_1[1] >> bitcast<u32>(_e644)) & 1023u);
                                        let _e785 = (_e592.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e779) * _e652)) ^ _e130)));
                                        let _e789 = select(select(_e592.member.member_1[1], _e785, (_e785 < _e592.member.member_1[1])), _e592.member.member_1[1], (_e779 == 1023u));
                                        let _e792 = ((_e609.member_1[1] >> bitcast<u32>(_e664)) & 1023u);
                                        let _e798 = (_e592.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e792) * _e672)) ^ _e130)));
                                        let _e802 = select(select(_e592.member.member_1[2], _e798, (_e798 < _e592.member.member_1[2])), _e592.member.member_1[2], (_e792 == 1023u));
                                        let _e807 = type_61(type_59(array<f32, 3>(_e642, _e662, _e682), array<f32, 3>(_e695, _e708, _e721)), _e609.member_2);
                                        let _e812 = type_61(type_59(array<f32, 3>(_e737, _e750, _e763), array<f32, 3>(_e776, _e789, _e802)), _e609.member_3);
                                        let _e818 = ((_e642 - _e396) * _e401);
                                        let _e819 = ((_e737 - _e396) * _e401);
                                        let _e820 = ((_e695 - _e397) * _e401);
                                        let _e821 = ((_e776 - _e397) * _e401);
                                        let _e826 = ((_e662 - _e432) * _e437);
                                        let _e827 = ((_e750 - _e432) * _e437);
                                        let _e828 = ((_e708 - _e433) * _e437);
                                        let _e829 = ((_e789 - _e433) * _e437);
                                        let _e834 = ((_e682 - _e468) * _e473);
                                        let _e835 = ((_e763 - _e468) * _e473);
                                        let _e836 = ((_e721 - _e469) * _e473);
                                        let _e837 = ((_e802 - _e469) * _e473);
                                        let _e839 = select(_e836, _e834, (_e834 < _e836));
                                        let _e841 = select(_e837, _e835, (_e835 < _e837));
                                        let _e843 = select(_e836, _e834, (_e834 > _e836));
                                        let _e845 = select(_e837, _e835, (_e835 > _e837));
                                        let _e847 = select(_e820, _e818, (_e818 < _e820));
                                        let _e849 = select(_e821, _e819, (_e819 < _e821));
                                        let _e851 = select(_e828, _e826, (_e826 < _e828));
                                        let _e853 = select(_e829, _e827, (_e827 < _e829));
                                        let _e855 = select(_e851, _e847, (_e847 > _e851));
                                        let _e857 = select(_e853, _e849, (_e849 > _e853));
                                        let _e859 = select(_e839, _e855, (_e855 > _e839));
                                        let _e861 = select(_e841, _e857, (_e857 > _e841));
                                        let _e863 = select(_e820, _e818, (_e818 > _e820));
                                        let _e865 = select(_e821, _e819, (_e819 > _e821));
                                        let _e867 = select(_e828, _e826, (_e826 > _e828));
                                        let _e869 = select(_e829, _e827, (_e827 > _e829));
                                        let _e871 = select(_e867, _e863, (_e863 < _e867));
                                        let _e873 = select(_e869, _e865, (_e865 < _e869));
                                        let _e878 = -(_e839);
                                        let _e879 = -(_e841);
                                        let _e886 = (select(_e843, _e871, (_e871 < _e843)) + (select(_e878, _e843, (_e843 > _e878)) * 0.0000019073523f));
                                        let _e887 = (select(_e845, _e873, (_e873 < _e845)) + (select(_e879, _e845, (_e845 > _e879)) * 0.0000019073523f));
                                        let _e889 = select(_e519, _e859, (_e859 > _e519));
                                        let _e891 = select(_e519, _e861, (_e861 > _e519));
                                        let _e896 = (_e889 <= select(_e553.member_1, _e886, (_e886 < _e553.member_1)));
                                        let _e897 = (_e891 <= select(_e553.member_1, _e887, (_e887 < _e553.member_1)));
                                        let _e898 = (_e889 <= _e891);
                                        if _e896 {
                                            if _e897 {
                                                if _e898 {
                                                    phi_2929_ = _e812;
                                                } else {
                                                    phi_2929_ = _e807;
                                                }
                                                let _e900 = phi_2929_;
                                                let _e908 = (_e596 % 128u);
                                                let _e909 = (_e908 < 128u);
                                                if _e909 {
                                                } else {
                                                    phi_3352_ = true;
                                                    break;
                                                }
                                                local_6[_e908] = _e900.member_1;
                                                if _e909 {
                                                } else {
                                                    phi_3352_ = true;
                                                    break;
                                                }
                                                local_5[_e908] = _e900.member.member[0];
                                                if _e909 {
                                                } else {
                                                    phi_3352_ = true;
                                                    break;
                                                }
                                                local_4[_e908] = _e900.member.member[1];
                                                if _e909 {
                                                } else {
                                                    phi_3352_ = true;
                                                    break;
                                                }
                                                local_3[_e908] = _e900.member.member[2];
                                                if _e909 {
                                                } else {
                                                    phi_3352_ = true;
                                                    break;
                                                }
                                                local_2[_e908] = _e900.member.member_1[0];
                                                if _e909 {
                                                } else {
                                                    phi_3352_ = true;
                                                    break;
                                                }
                                                local_1[_e908] = _e900.member.member_1[1];
                                                if _e909 {
                                                } else {
                                                    phi_3352_ = true;
                                                    break;
                                                }
                                                local[_e908] = _e900.member.member_1[2];
                                                if _e909 {
                                                } else {
                                                    phi_3352_ = true;
                                                    break;
                                                }
                                                local_7[_e908] = select(_e891, _e889, (_e889 > _e891));
                                                if _e898 {
                                                    phi_3006_ = _e807;
                                                } else {
                                                    phi_3006_ = _e812;
                                                }
                                                let _e926 = phi_3006_;
                                                phi_3007_ = _e926;
                                                phi_3008_ = (_e596 + 1u);
                                            } else {
                                                phi_3007_ = type_61();
                                                phi_3008_ = u32();
                                            }
                                            let _e928 = phi_3007_;
                                            let _e930 = phi_3008_;
                                            phi_3010_ = _e928;
                                            phi_3011_ = _e930;
                                            phi_3012_ = select(true, false, _e897);
                                        } else {
                                            phi_3010_ = type_61();
                                            phi_3011_ = u32();
                                            phi_3012_ = true;
                                        }
                                        let _e933 = phi_3010_;
                                        let _e935 = phi_3011_;
                                        let _e937 = phi_3012_;
                                        if _e937 {
                                            if _e896 {
                                                phi_3019_ = _e807;
                                            } else {
                                                phi_3019_ = _e812;
                                            }
                                            let _e939 = phi_3019_;
                                            phi_3024_ = _e939;
                                            phi_3025_ = select(_e897, true, _e896);
                                        } else {
                                            phi_3024_ = _e933;
                                            phi_3025_ = _e594;
                                        }
                                        let _e942 = phi_3024_;
                                        let _e944 = phi_3025_;
                                        phi_3356_ = _e551;
                                        phi_3027_ = _e553;
                                        phi_3028_ = _e942;
                                        phi_3029_ = _e944;
                                        phi_3030_ = select(_e935, _e596, _e937);
                                    }
                                    let _e1580 = phi_3356_;
                                    let _e1582 = phi_3027_;
                                    let _e1584 = phi_3028_;
                                    let _e1586 = phi_3029_;
                                    let _e1588 = phi_3030_;
                                    phi_3355_ = _e1580;
                                    phi_3031_ = _e1582;
                                    phi_3032_ = _e1584;
                                    phi_3033_ = (_e557 - 1u);
                                    phi_3034_ = _e1586;
                                    phi_3035_ = _e1588;
                                } else {
                                    phi_3355_ = _e551;
                                    phi_3031_ = _e553;
                                    phi_3032_ = _e592;
                                    phi_3033_ = _e557;
                                    phi_3034_ = _e594;
                                    phi_3035_ = _e596;
                                }
                                let _e1590 = phi_3355_;
                                let _e1592 = phi_3031_;
                                let _e1594 = phi_3032_;
                                let _e1596 = phi_3033_;
                                let _e1598 = phi_3034_;
                                let _e1600 = phi_3035_;
                                phi_3354_ = _e1590;
                                phi_3036_ = _e1592;
                                phi_3037_ = _e1594;
                                phi_3038_ = _e1596;
                                phi_3039_ = _e1598;
                                phi_3040_ = _e1600;
                            } else {
                                phi_3354_ = _e551;
                                phi_3036_ = type_43();
                                phi_3037_ = type_61();
                                phi_3038_ = u32();
                                phi_3039_ = bool();
                                phi_3040_ = u32();
                            }
                            let _e1602 = phi_3354_;
                            let _e1604 = phi_3036_;
                            let _e1606 = phi_3037_;
                            let _e1608 = phi_3038_;
                            let _e1610 = phi_3039_;
                            let _e1612 = phi_3040_;
                            phi_3353_ = _e1602;
                            phi_884_ = _e1604;
                            phi_887_ = _e1606;
                            phi_889_ = _e1608;
                            phi_891_ = _e1610;
                            phi_893_ = _e1612;
                            phi_3041_ = _e565;
                        } else {
                            phi_3353_ = _e551;
                            phi_884_ = type_43();
                            phi_887_ = type_61();
                            phi_889_ = u32();
                            phi_891_ = bool();
                            phi_893_ = u32();
                            phi_3041_ = false;
                        }
                        let _e1614 = phi_3353_;
                        let _e1616 = phi_884_;
                        let _e1618 = phi_887_;
                        let _e1620 = phi_889_;
                        let _e1622 = phi_891_;
                        let _e1624 = phi_893_;
                        let _e1626 = phi_3041_;
                        continue;
                        continuing {
                            phi_3220_ = _e1614;
                            phi_883_ = _e1616;
                            phi_886_ = _e1618;
                            phi_888_ = _e1620;
                            phi_890_ = _e1622;
                            phi_892_ = _e1624;
                            phi_3352_ = _e1614;
                            break if !(_e1626);
                        }
                    }
                    let _e1629 = phi_3352_;
                    if _e1629 {
                        break;
                    }
                    let _e1631 = local_10;
                    if (_e1631.member.member_3 != 4294967295u) {
                        let _e1636 = (_e343 / 3i);
                        let _e1643 = bitcast<f32>((bitcast<u32>((_e1636 + 127i)) << bitcast<u32>(23i)));
                        let _e1651 = (((_e1631.member.member * _e1643) * _e1643) * bitcast<f32>((bitcast<u32>(((_e343 - (2i * _e1636)) + 127i)) << bitcast<u32>(23i))));
                        let _e1653 = select(340282350000000000000000000000000000000f, _e1651, (_e1651 < 340282350000000000000000000000000000000f));
                        phi_3093_ = type_27(select(-340282350000000000000000000000000000000f, _e1653, (_e1653 > -340282350000000000000000000000000000000f)), _e1631.member.member_1, _e1631.member.member_2, _e1631.member.member_3);
                    } else {
                        phi_3093_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1660 = phi_3093_;
                    if _e220 {
                    } else {
                        break;
                    }
                    global_8.member[_e134] = _e1660;
                    if _e141 {
                    } else {
                        break;
                    }
                    let _e1664 = select(0u, 1u, (_e287 <= _e297));
                    if (_e1664 > 0u) {
                        let _e1666 = (1u < _e102);
                        if _e1666 {
                            if (0u < _e102) {
                            } else {
                                break;
                            }
                            let _e1670 = atomicAdd((&global_9.member[0u]), _e1664);
                            if ((_e1670 + _e1664) < _e1670) {
                                if _e1666 {
                                } else {
                                    break;
                                }
                                let _e1675 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1678 = select(0u, 1u, (_e1660.member_3 != 4294967295u));
                    if (_e1678 > 0u) {
                        let _e1680 = (3u < _e102);
                        if _e1680 {
                            if (2u < _e102) {
                            } else {
                                break;
                            }
                            let _e1684 = atomicAdd((&global_9.member[2u]), _e1678);
                            if ((_e1684 + _e1678) < _e1684) {
                                if _e1680 {
                                } else {
                                    break;
                                }
                                let _e1689 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
