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

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_32 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_33 {
    member: type_32,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_35 {
    member: array<type_33>,
}

struct type_40 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_46 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_49 {
    member: type_28,
    member_1: f32,
}

struct type_53 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_55 {
    member: array<vec4<u32>, 2>,
}

struct type_58 {
    member: array<i32>,
}

struct type_66 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_55;
@group(0) @binding(2) 
var<storage> global_3: type_42;
@group(0) @binding(3) 
var<storage> global_4: type_20;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage> global_6: type_58;
@group(0) @binding(6) 
var<storage> global_7: type_35;
@group(0) @binding(7) 
var<storage, read_write> global_8: type_30;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_66;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_250_: i32;
    var phi_274_: type_46;
    var phi_384_: i32;
    var phi_385_: i32;
    var phi_395_: bool;
    var phi_405_: u32;
    var phi_406_: u32;
    var phi_408_: bool;
    var phi_413_: u32;
    var phi_445_: i32;
    var phi_463_: f32;
    var phi_469_: f32;
    var phi_480_: f32;
    var phi_486_: f32;
    var phi_509_: f32;
    var phi_520_: f32;
    var phi_529_: f32;
    var phi_535_: f32;
    var phi_546_: f32;
    var phi_552_: f32;
    var phi_575_: f32;
    var phi_586_: f32;
    var phi_595_: f32;
    var phi_601_: f32;
    var phi_612_: f32;
    var phi_618_: f32;
    var phi_641_: f32;
    var phi_652_: f32;
    var phi_752_: f32;
    var phi_753_: f32;
    var phi_2789_: bool;
    var phi_1027_: type_49;
    var phi_1030_: u32;
    var phi_1032_: u32;
    var phi_1034_: bool;
    var phi_1036_: u32;
    var phi_1047_: bool;
    var phi_1078_: u32;
    var phi_1079_: bool;
    var phi_1080_: u32;
    var phi_2224_: type_53;
    var phi_2568_: u32;
    var phi_2595_: u32;
    var phi_2596_: u32;
    var phi_2597_: u32;
    var phi_2599_: u32;
    var phi_2600_: u32;
    var phi_2601_: bool;
    var phi_2610_: u32;
    var phi_2615_: u32;
    var phi_2616_: bool;
    var phi_1095_: type_49;
    var phi_1098_: type_8;
    var phi_1099_: type_8;
    var phi_1121_: type_8;
    var phi_1142_: u32;
    var phi_1231_: array<array<f32, 3>, 3>;
    var phi_1702_: vec3<f32>;
    var phi_1703_: vec3<f32>;
    var phi_1734_: bool;
    var phi_1743_: vec3<f32>;
    var phi_1783_: type_28;
    var phi_1785_: type_28;
    var phi_1786_: bool;
    var phi_1790_: type_28;
    var phi_1791_: type_28;
    var phi_1792_: type_28;
    var phi_1793_: bool;
    var phi_1797_: type_28;
    var phi_1798_: bool;
    var phi_1802_: type_28;
    var phi_1803_: bool;
    var phi_1807_: type_28;
    var phi_1830_: u32;
    var phi_1844_: i32;
    var phi_1864_: vec3<f32>;
    var phi_1865_: vec3<f32>;
    var phi_1881_: vec3<f32>;
    var phi_1882_: vec3<f32>;
    var phi_1898_: vec3<f32>;
    var phi_1899_: vec3<f32>;
    var phi_1935_: vec3<f32>;
    var phi_2117_: f32;
    var phi_2135_: bool;
    var phi_2136_: bool;
    var phi_2155_: bool;
    var phi_2156_: bool;
    var phi_2162_: type_49;
    var phi_2163_: type_49;
    var phi_2164_: type_49;
    var phi_1096_: type_49;
    var phi_2783_: bool;
    var phi_2924_: bool;
    var phi_2618_: type_49;
    var phi_2619_: u32;
    var phi_2620_: bool;
    var phi_2621_: u32;
    var phi_2923_: bool;
    var phi_2622_: type_49;
    var phi_2623_: u32;
    var phi_2624_: u32;
    var phi_2625_: bool;
    var phi_2626_: u32;
    var phi_2922_: bool;
    var phi_2627_: type_49;
    var phi_2628_: u32;
    var phi_2629_: u32;
    var phi_2630_: bool;
    var phi_2631_: u32;
    var phi_2921_: bool;
    var phi_1028_: type_49;
    var phi_1031_: u32;
    var phi_1033_: u32;
    var phi_1035_: bool;
    var phi_1037_: u32;
    var phi_2632_: bool;
    var phi_2920_: bool;
    var local_2: type_49;
    var phi_2684_: type_28;
    var local_3: type_49;

    switch bitcast<i32>(0u) {
        default: {
            let _e73 = global;
            let _e75 = arrayLength((&global_3.member));
            let _e77 = arrayLength((&global_4.member));
            let _e89 = arrayLength((&global_9.member));
            let _e93 = (_e73.x + (_e73.y * 2097152u));
            let _e94 = (_e93 < arrayLength((&global_7.member)));
            if _e94 {
                let _e95 = (_e93 < arrayLength((&global_8.member)));
                if _e95 {
                    let _e98 = global_1.member[0u];
                    let _e102 = global_2.member[0u][0u];
                    let _e106 = global_2.member[0u][1u];
                    let _e110 = global_2.member[0u][2u];
                    let _e114 = global_2.member[0u][3u];
                    let _e118 = global_2.member[1u][0u];
                    let _e122 = global_2.member[1u][1u];
                    let _e126 = global_2.member[1u][2u];
                    let _e130 = global_2.member[1u][3u];
                    let _e131 = bitcast<f32>(_e102);
                    let _e132 = bitcast<f32>(_e106);
                    let _e133 = bitcast<f32>(_e110);
                    let _e135 = bitcast<f32>(_e118);
                    let _e136 = array<u32, 3>(_e122, _e126, _e130);
                    let _e138 = bitcast<i32>(_e98);
                    if (_e138 < -126i) {
                        phi_250_ = -126i;
                    } else {
                        phi_250_ = select(_e138, 127i, (_e138 > 127i));
                    }
                    let _e143 = phi_250_;
                    let _e148 = bitcast<f32>((bitcast<u32>((_e143 + 127i)) << bitcast<u32>(23i)));
                    let _e154 = bitcast<f32>((bitcast<u32>(((_e138 - _e143) + 127i)) << bitcast<u32>(23i)));
                    if (_e114 == 0u) {
                        phi_274_ = type_46(array<f32, 3>(_e131, _e132, _e133), _e114, _e135, _e136);
                    } else {
                        phi_274_ = type_46(array<f32, 3>(((_e131 * _e148) * _e154), ((_e132 * _e148) * _e154), ((_e133 * _e148) * _e154)), _e114, ((_e135 * _e148) * _e154), _e136);
                    }
                    let _e167 = phi_274_;
                    if _e94 {
                    } else {
                        break;
                    }
                    if _e94 {
                    } else {
                        break;
                    }
                    let _e171 = global_7.member[_e93].member_2;
                    let _e181 = global_7.member[_e93].member.member_2[0u];
                    let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                    let _e189 = global_7.member[_e93].member.member_2[1u];
                    let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                    let _e197 = global_7.member[_e93].member.member_2[2u];
                    let _e199 = (bitcast<u32>(_e197) & 2147483647u);
                    let _e205 = global_7.member[_e93].member.member[0u];
                    let _e207 = (bitcast<u32>(_e205) & 2147483647u);
                    let _e213 = global_7.member[_e93].member.member[1u];
                    let _e215 = (bitcast<u32>(_e213) & 2147483647u);
                    let _e221 = global_7.member[_e93].member.member[2u];
                    let _e223 = (bitcast<u32>(_e221) & 2147483647u);
                    let _e225 = select(_e191, _e183, (_e191 < _e183));
                    let _e227 = select(_e199, _e225, (_e199 < _e225));
                    let _e229 = select(_e207, _e227, (_e207 < _e227));
                    let _e231 = select(_e215, _e229, (_e215 < _e229));
                    let _e233 = select(_e223, _e231, (_e223 < _e231));
                    let _e238 = global_7.member[_e93].member.member_1;
                    let _e240 = (bitcast<u32>(_e238) & 2147483647u);
                    let _e248 = global_7.member[_e93].member.member_3;
                    let _e254 = (((select(_e240, _e233, (_e240 < _e233)) < 2139095040u) && ((bitcast<u32>(_e248) & 2147483647u) <= 2139095040u)) && (_e227 > 0u));
                    if _e254 {
                        let _e257 = (bitcast<u32>(bitcast<f32>(_e227)) & 2147483647u);
                        if (_e257 >= 8388608u) {
                            phi_384_ = (bitcast<i32>((_e257 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_384_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e257)), 32u, (_e257 == 0u))));
                        }
                        let _e271 = phi_384_;
                        phi_385_ = _e271;
                    } else {
                        phi_385_ = 0i;
                    }
                    let _e273 = phi_385_;
                    let _e274 = (_e183 == _e227);
                    if _e274 {
                        phi_395_ = true;
                    } else {
                        phi_395_ = (_e191 == _e227);
                    }
                    let _e277 = phi_395_;
                    let _e278 = select(1u, 0u, _e274);
                    if _e277 {
                        let _e279 = (_e278 + 1u);
                        phi_405_ = _e279;
                        phi_406_ = _e279;
                        phi_408_ = select(true, false, (_e279 == 2u));
                    } else {
                        phi_405_ = u32();
                        phi_406_ = 0u;
                        phi_408_ = true;
                    }
                    let _e283 = phi_405_;
                    let _e285 = phi_406_;
                    let _e287 = phi_408_;
                    if _e287 {
                        phi_413_ = (_e285 + 1u);
                    } else {
                        phi_413_ = 0u;
                    }
                    let _e291 = phi_413_;
                    let _e292 = select(_e283, _e285, _e287);
                    let _e293 = select(_e278, select(2u, _e278, _e277), _e287);
                    let _e294 = -(_e273);
                    if (_e294 < -126i) {
                        phi_445_ = -126i;
                    } else {
                        phi_445_ = select(_e294, 127i, (_e294 > 127i));
                    }
                    let _e299 = phi_445_;
                    let _e304 = bitcast<f32>((bitcast<u32>((_e299 + 127i)) << bitcast<u32>(23i)));
                    let _e310 = bitcast<f32>((bitcast<u32>(((_e294 - _e299) + 127i)) << bitcast<u32>(23i)));
                    let _e315 = global_7.member[_e93].member.member;
                    let _e316 = (_e292 == 0u);
                    if _e316 {
                        phi_463_ = _e315[0];
                    } else {
                        phi_463_ = _e315[1];
                    }
                    let _e320 = phi_463_;
                    let _e321 = (_e292 == 2u);
                    if _e321 {
                        phi_469_ = _e315[2];
                    } else {
                        phi_469_ = _e320;
                    }
                    let _e324 = phi_469_;
                    let _e325 = global_7.member[_e93].member.member_2;
                    if _e316 {
                        phi_480_ = _e325[0];
                    } else {
                        phi_480_ = _e325[1];
                    }
                    let _e329 = phi_480_;
                    if _e321 {
                        phi_486_ = _e325[2];
                    } else {
                        phi_486_ = _e329;
                    }
                    let _e332 = phi_486_;
                    let _e334 = ((_e332 * _e304) * _e310);
                    let _e338 = (bitcast<f32>((bitcast<u32>(_e334) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e338 {
                        let _e342 = (bitcast<f32>((bitcast<u32>(_e324) & 2147483647u)) * 0.00000011920929f);
                        phi_509_ = select(0.00000000000011368684f, _e342, (_e342 > 0.00000000000011368684f));
                    } else {
                        phi_509_ = 0f;
                    }
                    let _e346 = phi_509_;
                    let _e347 = (_e324 + _e346);
                    let _e348 = (_e324 - _e346);
                    let _e349 = select(_e334, 0f, _e338);
                    if _e338 {
                        phi_520_ = 38685626000000000000000000f;
                    } else {
                        phi_520_ = (1f / _e334);
                    }
                    let _e352 = phi_520_;
                    let _e353 = (_e291 == 0u);
                    if _e353 {
                        phi_529_ = _e315[0];
                    } else {
                        phi_529_ = _e315[1];
                    }
                    let _e357 = phi_529_;
                    let _e358 = (_e291 == 2u);
                    if _e358 {
                        phi_535_ = _e315[2];
                    } else {
                        phi_535_ = _e357;
                    }
                    let _e361 = phi_535_;
                    if _e353 {
                        phi_546_ = _e325[0];
                    } else {
                        phi_546_ = _e325[1];
                    }
                    let _e365 = phi_546_;
                    if _e358 {
                        phi_552_ = _e325[2];
                    } else {
                        phi_552_ = _e365;
                    }
                    let _e368 = phi_552_;
                    let _e370 = ((_e368 * _e304) * _e310);
                    let _e374 = (bitcast<f32>((bitcast<u32>(_e370) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e374 {
                        let _e378 = (bitcast<f32>((bitcast<u32>(_e361) & 2147483647u)) * 0.00000011920929f);
                        phi_575_ = select(0.00000000000011368684f, _e378, (_e378 > 0.00000000000011368684f));
                    } else {
                        phi_575_ = 0f;
                    }
                    let _e382 = phi_575_;
                    let _e383 = (_e361 + _e382);
                    let _e384 = (_e361 - _e382);
                    let _e385 = select(_e370, 0f, _e374);
                    if _e374 {
                        phi_586_ = 38685626000000000000000000f;
                    } else {
                        phi_586_ = (1f / _e370);
                    }
                    let _e388 = phi_586_;
                    let _e389 = (_e293 == 0u);
                    if _e389 {
                        phi_595_ = _e315[0];
                    } else {
                        phi_595_ = _e315[1];
                    }
                    let _e393 = phi_595_;
                    let _e394 = (_e293 == 2u);
                    if _e394 {
                        phi_601_ = _e315[2];
                    } else {
                        phi_601_ = _e393;
                    }
                    let _e397 = phi_601_;
                    if _e389 {
                        phi_612_ = _e325[0];
                    } else {
                        phi_612_ = _e325[1];
                    }
                    let _e401 = phi_612_;
                    if _e394 {
                        phi_618_ = _e325[2];
                    } else {
                        phi_618_ = _e401;
                    }
                    let _e404 = phi_618_;
                    let _e406 = ((_e404 * _e304) * _e310);
                    let _e410 = (bitcast<f32>((bitcast<u32>(_e406) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e410 {
                        let _e414 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) * 0.00000011920929f);
                        phi_641_ = select(0.00000000000011368684f, _e414, (_e414 > 0.00000000000011368684f));
                    } else {
                        phi_641_ = 0f;
                    }
                    let _e418 = phi_641_;
                    let _e419 = (_e397 + _e418);
                    let _e420 = (_e397 - _e418);
                    let _e421 = select(_e406, 0f, _e410);
                    if _e410 {
                        phi_652_ = 38685626000000000000000000f;
                    } else {
                        phi_652_ = (1f / _e406);
                    }
                    let _e424 = phi_652_;
                    let _e427 = bitcast<f32>((bitcast<u32>(_e324) & 2147483647u));
                    let _e430 = bitcast<f32>((bitcast<u32>(_e361) & 2147483647u));
                    let _e432 = select(_e430, _e427, (_e427 > _e430));
                    let _e435 = bitcast<f32>((bitcast<u32>(_e397) & 2147483647u));
                    if (_e254 && (select(_e435, _e432, (_e432 > _e435)) <= 1099511600000f)) {
                        let _e440 = (_e273 / 3i);
                        let _e447 = bitcast<f32>((bitcast<u32>((_e440 + 127i)) << bitcast<u32>(23i)));
                        let _e454 = bitcast<f32>((bitcast<u32>(((_e273 - (2i * _e440)) + 127i)) << bitcast<u32>(23i)));
                        let _e455 = (((_e238 * _e447) * _e447) * _e454);
                        let _e457 = select(340282350000000000000000000000000000000f, _e455, (_e455 < 340282350000000000000000000000000000000f));
                        let _e462 = (((_e248 * _e447) * _e447) * _e454);
                        let _e464 = select(340282350000000000000000000000000000000f, _e462, (_e462 < 340282350000000000000000000000000000000f));
                        phi_752_ = select(-340282350000000000000000000000000000000f, _e464, (_e464 > -340282350000000000000000000000000000000f));
                        phi_753_ = select(-340282350000000000000000000000000000000f, _e457, (_e457 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_752_ = 0f;
                        phi_753_ = 1f;
                    }
                    let _e468 = phi_752_;
                    let _e470 = phi_753_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2789_ = false;
                    phi_1027_ = type_49(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e468);
                    phi_1030_ = select(0u, 2147483648u, (_e75 == 0u));
                    phi_1032_ = ((3u * _e75) + 1u);
                    phi_1034_ = (_e470 <= _e468);
                    phi_1036_ = 0u;
                    loop {
                        let _e478 = phi_2789_;
                        let _e480 = phi_1027_;
                        let _e482 = phi_1030_;
                        let _e484 = phi_1032_;
                        let _e486 = phi_1034_;
                        let _e488 = phi_1036_;
                        local_2 = _e480;
                        if _e486 {
                            phi_1047_ = true;
                        } else {
                            phi_1047_ = (_e488 > 0u);
                        }
                        let _e491 = phi_1047_;
                        if _e491 {
                            let _e492 = (_e484 > 0u);
                            if _e492 {
                                if _e486 {
                                    phi_1078_ = _e482;
                                    phi_1079_ = _e486;
                                    phi_1080_ = _e488;
                                } else {
                                    let _e493 = (_e488 - 1u);
                                    let _e494 = (_e493 % 128u);
                                    let _e495 = (_e494 < 128u);
                                    if _e495 {
                                    } else {
                                        phi_2920_ = true;
                                        break;
                                    }
                                    let _e497 = local_1[_e494];
                                    if _e495 {
                                    } else {
                                        phi_2920_ = true;
                                        break;
                                    }
                                    let _e499 = local[_e494];
                                    phi_1078_ = _e497;
                                    phi_1079_ = (_e499 <= _e480.member_1);
                                    phi_1080_ = _e493;
                                }
                                let _e503 = phi_1078_;
                                let _e505 = phi_1079_;
                                let _e507 = phi_1080_;
                                if _e505 {
                                    if ((_e503 & 2147483648u) != 0u) {
                                        phi_1095_ = _e480;
                                        phi_1098_ = type_8(0u, ((_e503 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e705 = phi_1095_;
                                            let _e707 = phi_1098_;
                                            local_3 = _e705;
                                            if (_e707.member < _e707.member_1) {
                                                phi_1099_ = type_8((_e707.member + 1u), _e707.member_1);
                                                phi_1121_ = type_8(1u, _e707.member);
                                            } else {
                                                phi_1099_ = _e707;
                                                phi_1121_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e720 = phi_1099_;
                                            let _e722 = phi_1121_;
                                            let _e726 = (bitcast<i32>(_e722.member) != 0i);
                                            if _e726 {
                                                let _e727 = ((_e503 & 268435455u) + _e722.member_1);
                                                let _e728 = (_e727 < _e77);
                                                if _e728 {
                                                    if _e728 {
                                                    } else {
                                                        phi_2783_ = true;
                                                        break;
                                                    }
                                                    let _e732 = global_4.member[_e727].member_1;
                                                    phi_1142_ = _e732;
                                                } else {
                                                    phi_1142_ = 4294967295u;
                                                }
                                                let _e734 = phi_1142_;
                                                if (_e727 >= _e77) {
                                                    phi_1231_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e728 {
                                                    } else {
                                                        phi_2783_ = true;
                                                        break;
                                                    }
                                                    let _e736 = (_e292 % 3u);
                                                    let _e737 = (_e291 % 3u);
                                                    let _e738 = (_e293 % 3u);
                                                    if (_e736 < 9u) {
                                                    } else {
                                                        phi_2783_ = true;
                                                        break;
                                                    }
                                                    let _e744 = global_4.member[_e727].member[_e736];
                                                    if (_e737 < 9u) {
                                                    } else {
                                                        phi_2783_ = true;
                                                        break;
                                                    }
                                                    let _e750 = global_4.member[_e727].member[_e737];
                                                    if (_e738 < 9u) {
                                                    } else {
                                                        phi_2783_ = true;
                                                        break;
                                                    }
                                                    let _e756 = global_4.member[_e727].member[_e738];
                                                    let _e758 = (3u + _e736);
                                                    if (_e758 < 9u) {
                                                    } else {
                                                        phi_2783_ = true;
                                                        break;
                                                    }
                                                    let _e764 = global_4.member[_e727].member[_e758];
                                                    let _e765 = (3u + _e737);
                                                    if (_e765 < 9u) {
                                                    } else {
                                                        phi_2783_ = true;
                                                        break;
                                                    }
                                                    let _e771 = global_4.member[_e727].member[_e765];
                                                    let _e772 = (3u + _e738);
                                                    if (_e772 < 9u) {
                                                    } else {
                                                        phi_2783_ = true;
                                                        break;
                                                    }
                                                    let _e778 = global_4.member[_e727].member[_e772];
                                                    let _e780 = (6u + _e736);
                                                    if (_e780 < 9u) {
                                                    } else {
                                                        phi_2783_ = true;
                                                        break;
                                                    }
                                                    let _e786 = global_4.member[_e727].member[_e780];
                                                    let _e787 = (6u + _e737);
                                                    if (_e787 < 9u) {
                                                    } else {
                                                        phi_2783_ = true;
                                                        break;
                                                    }
                                                    let _e793 = global_4.member[_e727].member[_e787];
                                                    let _e794 = (6u + _e738);
                                                    if (_e794 < 9u) {
                                                    } else {
                                                        phi_2783_ = true;
                                                        break;
                                                    }
                                                    let _e800 = global_4.member[_e727].member[_e794];
                                                    phi_1231_ = array<array<f32, 3>, 3>(array<f32, 3>(_e744, _e750, _e756), array<f32, 3>(_e764, _e771, _e778), array<f32, 3>(_e786, _e793, _e800));
                                                }
                                                let _e804 = phi_1231_;
                                                let _e812 = (_e804[0][2] - _e397);
                                                let _e815 = (((_e804[0][0] - _e324) * _e421) - (_e812 * _e349));
                                                let _e818 = (((_e804[0][1] - _e361) * _e421) - (_e812 * _e385));
                                                let _e825 = (_e804[1][2] - _e397);
                                                let _e828 = (((_e804[1][0] - _e324) * _e421) - (_e825 * _e349));
                                                let _e831 = (((_e804[1][1] - _e361) * _e421) - (_e825 * _e385));
                                                let _e838 = (_e804[2][2] - _e397);
                                                let _e841 = (((_e804[2][0] - _e324) * _e421) - (_e838 * _e349));
                                                let _e844 = (((_e804[2][1] - _e361) * _e421) - (_e838 * _e385));
                                                let _e845 = (_e841 * _e831);
                                                let _e846 = (_e844 * _e828);
                                                let _e847 = (_e815 * _e844);
                                                let _e848 = (_e818 * _e841);
                                                let _e849 = (_e828 * _e818);
                                                let _e850 = (_e831 * _e815);
                                                let _e855 = (((_e845 >= _e846) && (_e847 >= _e848)) && (_e849 >= _e850));
                                                if (_e855 || (((_e845 <= _e846) && (_e847 <= _e848)) && (_e849 <= _e850))) {
                                                    let _e862 = select(-1f, 1f, _e855);
                                                    let _e864 = ((_e845 - _e846) * _e862);
                                                    let _e866 = select(0f, _e864, (_e864 > 0f));
                                                    let _e868 = ((_e847 - _e848) * _e862);
                                                    let _e870 = select(0f, _e868, (_e868 > 0f));
                                                    let _e872 = ((_e849 - _e850) * _e862);
                                                    let _e874 = select(0f, _e872, (_e872 > 0f));
                                                    let _e876 = ((_e866 + _e870) + _e874);
                                                    if (_e876 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1797_ = type_28();
                                                        phi_1798_ = true;
                                                    } else {
                                                        let _e879 = select(_e804[1][0], _e804[0][0], (_e804[0][0] < _e804[1][0]));
                                                        let _e883 = select(_e804[1][0], _e804[0][0], (_e804[0][0] > _e804[1][0]));
                                                        let _e887 = select(_e804[1][1], _e804[0][1], (_e804[0][1] < _e804[1][1]));
                                                        let _e891 = select(_e804[1][1], _e804[0][1], (_e804[0][1] > _e804[1][1]));
                                                        let _e895 = select(_e804[1][2], _e804[0][2], (_e804[0][2] < _e804[1][2]));
                                                        let _e899 = select(_e804[1][2], _e804[0][2], (_e804[0][2] > _e804[1][2]));
                                                        let _e904 = ((select(_e804[2][0], _e879, (_e879 < _e804[2][0])) - _e347) * _e352);
                                                        let _e905 = ((select(_e804[2][0], _e883, (_e883 > _e804[2][0])) - _e348) * _e352);
                                                        let _e908 = ((select(_e804[2][1], _e887, (_e887 < _e804[2][1])) - _e383) * _e388);
                                                        let _e909 = ((select(_e804[2][1], _e891, (_e891 > _e804[2][1])) - _e384) * _e388);
                                                        let _e912 = ((select(_e804[2][2], _e895, (_e895 < _e804[2][2])) - _e419) * _e424);
                                                        let _e913 = ((select(_e804[2][2], _e899, (_e899 > _e804[2][2])) - _e420) * _e424);
                                                        let _e915 = select(_e913, _e912, (_e912 < _e913));
                                                        let _e917 = select(_e913, _e912, (_e912 > _e913));
                                                        let _e919 = select(_e905, _e904, (_e904 < _e905));
                                                        let _e921 = select(_e909, _e908, (_e908 < _e909));
                                                        let _e923 = select(_e921, _e919, (_e919 > _e921));
                                                        let _e925 = select(_e915, _e923, (_e923 > _e915));
                                                        let _e927 = select(_e905, _e904, (_e904 > _e905));
                                                        let _e929 = select(_e909, _e908, (_e908 > _e909));
                                                        let _e931 = select(_e929, _e927, (_e927 < _e929));
                                                        let _e933 = select(_e917, _e931, (_e931 < _e917));
                                                        let _e934 = -(_e915);
                                                        let _e940 = select(_e470, _e925, (_e925 > _e470));
                                                        if (_e940 > (_e933 + (select(_e934, _e917, (_e917 > _e934)) * 0.0000019073523f))) {
                                                            phi_1792_ = type_28();
                                                            phi_1793_ = true;
                                                        } else {
                                                            let _e942 = (_e940 > _e705.member_1);
                                                            if _e942 {
                                                                phi_1791_ = type_28();
                                                            } else {
                                                                let _e946 = (_e804[1][0] - _e804[0][0]);
                                                                let _e947 = (_e804[1][1] - _e804[0][1]);
                                                                let _e948 = (_e804[1][2] - _e804[0][2]);
                                                                let _e949 = vec3<f32>(_e946, _e947, _e948);
                                                                let _e950 = (_e804[2][0] - _e804[1][0]);
                                                                let _e951 = (_e804[2][1] - _e804[1][1]);
                                                                let _e952 = (_e804[2][2] - _e804[1][2]);
                                                                let _e953 = vec3<f32>(_e950, _e951, _e952);
                                                                let _e954 = (_e804[0][0] - _e804[2][0]);
                                                                let _e955 = (_e804[0][1] - _e804[2][1]);
                                                                let _e956 = (_e804[0][2] - _e804[2][2]);
                                                                let _e957 = vec3<f32>(_e954, _e955, _e956);
                                                                let _e960 = bitcast<f32>((bitcast<u32>(_e946) & 2147483647u));
                                                                let _e963 = bitcast<f32>((bitcast<u32>(_e947) & 2147483647u));
                                                                let _e965 = select(_e963, _e960, (_e960 > _e963));
                                                                let _e968 = bitcast<f32>((bitcast<u32>(_e948) & 2147483647u));
                                                                let _e970 = select(_e968, _e965, (_e965 > _e968));
                                                                let _e973 = bitcast<f32>((bitcast<u32>(_e950) & 2147483647u));
                                                                let _e976 = bitcast<f32>((bitcast<u32>(_e951) & 2147483647u));
                                                                let _e978 = select(_e976, _e973, (_e973 > _e976));
                                                                let _e981 = bitcast<f32>((bitcast<u32>(_e952) & 2147483647u));
                                                                let _e983 = select(_e981, _e978, (_e978 > _e981));
                                                                let _e986 = bitcast<f32>((bitcast<u32>(_e954) & 2147483647u));
                                                                let _e989 = bitcast<f32>((bitcast<u32>(_e955) & 2147483647u));
                                                                let _e991 = select(_e989, _e986, (_e986 > _e989));
                                                                let _e994 = bitcast<f32>((bitcast<u32>(_e956) & 2147483647u));
                                                                let _e996 = select(_e994, _e991, (_e991 > _e994));
                                                                let _e998 = select(_e983, _e970, (_e970 > _e983));
                                                                let _e1000 = select(_e996, _e998, (_e998 > _e996));
                                                                if (_e970 == _e1000) {
                                                                    phi_1702_ = _e953;
                                                                    phi_1703_ = _e957;
                                                                } else {
                                                                    let _e1003 = vec3((_e983 == _e1000));
                                                                    phi_1702_ = select(_e949, _e957, _e1003);
                                                                    phi_1703_ = select(_e953, _e949, _e1003);
                                                                }
                                                                let _e1007 = phi_1702_;
                                                                let _e1009 = phi_1703_;
                                                                let _e1016 = ((_e1007.y * _e1009.z) - (_e1009.y * _e1007.z));
                                                                let _e1021 = ((_e1007.z * _e1009.x) - (_e1009.z * _e1007.x));
                                                                let _e1024 = ((_e1007.x * _e1009.y) - (_e1009.x * _e1007.y));
                                                                if (_e866 >= _e870) {
                                                                    phi_1734_ = select(true, false, (_e866 >= _e874));
                                                                } else {
                                                                    phi_1734_ = true;
                                                                }
                                                                let _e1029 = phi_1734_;
                                                                if _e1029 {
                                                                    phi_1743_ = select(vec3<f32>(_e804[2][0], _e804[2][1], _e804[2][2]), vec3<f32>(_e804[1][0], _e804[1][1], _e804[1][2]), vec3((_e870 >= _e874)));
                                                                } else {
                                                                    phi_1743_ = vec3<f32>(_e804[0][0], _e804[0][1], _e804[0][2]);
                                                                }
                                                                let _e1034 = phi_1743_;
                                                                let _e1051 = ((((_e1016 * (_e1034.x - _e324)) + (_e1021 * (_e1034.y - _e361))) + (_e1024 * (_e1034.z - _e397))) / (((_e1016 * _e349) + (_e1021 * _e385)) + (_e1024 * _e421)));
                                                                let _e1053 = select(_e933, _e1051, (_e1051 < _e933));
                                                                let _e1055 = select(_e925, _e1053, (_e1053 > _e925));
                                                                if (_e1055 >= _e470) {
                                                                    let _e1057 = (_e1055 <= _e705.member_1);
                                                                    if _e1057 {
                                                                        let _e1058 = (1f / _e876);
                                                                        phi_1783_ = type_28(_e1055, (_e870 * _e1058), (_e874 * _e1058), _e734);
                                                                    } else {
                                                                        phi_1783_ = type_28();
                                                                    }
                                                                    let _e1063 = phi_1783_;
                                                                    phi_1785_ = _e1063;
                                                                    phi_1786_ = select(true, false, _e1057);
                                                                } else {
                                                                    phi_1785_ = type_28();
                                                                    phi_1786_ = true;
                                                                }
                                                                let _e1066 = phi_1785_;
                                                                let _e1068 = phi_1786_;
                                                                if _e1068 {
                                                                    phi_1790_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1790_ = _e1066;
                                                                }
                                                                let _e1070 = phi_1790_;
                                                                phi_1791_ = _e1070;
                                                            }
                                                            let _e1072 = phi_1791_;
                                                            phi_1792_ = _e1072;
                                                            phi_1793_ = _e942;
                                                        }
                                                        let _e1074 = phi_1792_;
                                                        let _e1076 = phi_1793_;
                                                        phi_1797_ = _e1074;
                                                        phi_1798_ = _e1076;
                                                    }
                                                    let _e1078 = phi_1797_;
                                                    let _e1080 = phi_1798_;
                                                    phi_1802_ = _e1078;
                                                    phi_1803_ = _e1080;
                                                } else {
                                                    phi_1802_ = type_28();
                                                    phi_1803_ = true;
                                                }
                                                let _e1082 = phi_1802_;
                                                let _e1084 = phi_1803_;
                                                if _e1084 {
                                                    phi_1807_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1807_ = _e1082;
                                                }
                                                let _e1086 = phi_1807_;
                                                if (_e1086.member_3 != 4294967295u) {
                                                    if (_e734 == _e171) {
                                                        phi_2136_ = false;
                                                    } else {
                                                        let _e1090 = (_e734 < arrayLength((&global_5.member)));
                                                        if _e1090 {
                                                            if _e1090 {
                                                            } else {
                                                                phi_2783_ = true;
                                                                break;
                                                            }
                                                            let _e1092 = global_5.member[_e734];
                                                            phi_1830_ = _e1092;
                                                        } else {
                                                            phi_1830_ = 4294967295u;
                                                        }
                                                        let _e1094 = phi_1830_;
                                                        let _e1095 = (_e1094 < arrayLength((&global_6.member)));
                                                        if _e1095 {
                                                            if _e1095 {
                                                            } else {
                                                                phi_2783_ = true;
                                                                break;
                                                            }
                                                            let _e1097 = global_6.member[_e1094];
                                                            phi_1844_ = _e1097;
                                                        } else {
                                                            phi_1844_ = 0i;
                                                        }
                                                        let _e1099 = phi_1844_;
                                                        let _e1100 = (_e1099 == 0i);
                                                        if _e1100 {
                                                            phi_2135_ = true;
                                                        } else {
                                                            if _e316 {
                                                                phi_1865_ = vec3<f32>(_e804[0][0], _e804[0][1], _e804[0][2]);
                                                            } else {
                                                                if (_e292 == 1u) {
                                                                    phi_1864_ = vec3<f32>(_e804[0][2], _e804[0][0], _e804[0][1]);
                                                                } else {
                                                                    phi_1864_ = vec3<f32>(_e804[0][1], _e804[0][2], _e804[0][0]);
                                                                }
                                                                let _e1105 = phi_1864_;
                                                                phi_1865_ = _e1105;
                                                            }
                                                            let _e1108 = phi_1865_;
                                                            if _e316 {
                                                                phi_1882_ = vec3<f32>(_e804[1][0], _e804[1][1], _e804[1][2]);
                                                            } else {
                                                                if (_e292 == 1u) {
                                                                    phi_1881_ = vec3<f32>(_e804[1][2], _e804[1][0], _e804[1][1]);
                                                                } else {
                                                                    phi_1881_ = vec3<f32>(_e804[1][1], _e804[1][2], _e804[1][0]);
                                                                }
                                                                let _e1113 = phi_1881_;
                                                                phi_1882_ = _e1113;
                                                            }
                                                            let _e1116 = phi_1882_;
                                                            if _e316 {
                                                                phi_1899_ = vec3<f32>(_e804[2][0], _e804[2][1], _e804[2][2]);
                                                            } else {
                                                                if (_e292 == 1u) {
                                                                    phi_1898_ = vec3<f32>(_e804[2][2], _e804[2][0], _e804[2][1]);
                                                                } else {
                                                                    phi_1898_ = vec3<f32>(_e804[2][1], _e804[2][2], _e804[2][0]);
                                                                }
                                                                let _e1121 = phi_1898_;
                                                                phi_1899_ = _e1121;
                                                            }
                                                            let _e1124 = phi_1899_;
                                                            let _e1127 = (_e1116.x - _e1108.x);
                                                            let _e1130 = (_e1116.y - _e1108.y);
                                                            let _e1133 = (_e1116.z - _e1108.z);
                                                            let _e1135 = (_e1124.x - _e1108.x);
                                                            let _e1137 = (_e1124.y - _e1108.y);
                                                            let _e1139 = (_e1124.z - _e1108.z);
                                                            if (_e167.member_1 == 1u) {
                                                                phi_1935_ = (vec3<f32>(_e167.member[0], _e167.member[1], _e167.member[2]) - _e1108);
                                                            } else {
                                                                phi_1935_ = vec3<f32>(_e167.member[0], _e167.member[1], _e167.member[2]);
                                                            }
                                                            let _e1154 = phi_1935_;
                                                            let _e1160 = bitcast<f32>((bitcast<u32>((_e1127 * _e1137)) ^ _e167.member_3[0]));
                                                            let _e1164 = bitcast<f32>((bitcast<u32>((_e1130 * _e1135)) ^ _e167.member_3[0]));
                                                            let _e1168 = bitcast<f32>((bitcast<u32>((_e1130 * _e1139)) ^ _e167.member_3[0]));
                                                            let _e1172 = bitcast<f32>((bitcast<u32>((_e1133 * _e1137)) ^ _e167.member_3[0]));
                                                            let _e1176 = bitcast<f32>((bitcast<u32>((_e1133 * _e1135)) ^ _e167.member_3[0]));
                                                            let _e1180 = bitcast<f32>((bitcast<u32>((_e1127 * _e1139)) ^ _e167.member_3[0]));
                                                            let _e1181 = (_e1168 - _e1172);
                                                            let _e1182 = (_e1176 - _e1180);
                                                            let _e1183 = (_e1160 - _e1164);
                                                            let _e1207 = (bitcast<f32>((bitcast<u32>(_e1168) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1172) & 2147483647u)));
                                                            let _e1214 = (bitcast<f32>((bitcast<u32>(_e1176) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1180) & 2147483647u)));
                                                            let _e1221 = (bitcast<f32>((bitcast<u32>(_e1160) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1164) & 2147483647u)));
                                                            if (_e167.member_2 == 0f) {
                                                                phi_2117_ = 0f;
                                                            } else {
                                                                let _e1251 = bitcast<f32>((bitcast<u32>(_e1181) & 2147483647u));
                                                                let _e1254 = bitcast<f32>((bitcast<u32>(_e1182) & 2147483647u));
                                                                let _e1257 = bitcast<f32>((bitcast<u32>(_e1183) & 2147483647u));
                                                                let _e1259 = select(_e1257, _e1254, (_e1254 > _e1257));
                                                                let _e1263 = select(_e1257, _e1254, (_e1254 < _e1257));
                                                                let _e1267 = select(_e1254, _e1251, (_e1251 < _e1254));
                                                                let _e1269 = select(_e1254, _e1251, (_e1251 > _e1254));
                                                                let _e1271 = select(_e1257, _e1269, (_e1269 < _e1257));
                                                                phi_2117_ = bitcast<f32>((bitcast<u32>((_e167.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1259, _e1251, (_e1251 > _e1259)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1271, _e1267, (_e1267 > _e1271)))) ^ _e167.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1263, _e1251, (_e1251 < _e1263)))) ^ _e167.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1207 + _e1214) + _e1221))) ^ _e167.member_3[0]))) * 1.0000005f)) ^ _e167.member_3[0])))) ^ _e167.member_3[0]));
                                                            }
                                                            let _e1298 = phi_2117_;
                                                            phi_2135_ = (_e1100 || !(((((bitcast<f32>((bitcast<u32>((_e1154.x * _e1181)) ^ _e167.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1154.y * _e1182)) ^ _e167.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1154.z * _e1183)) ^ _e167.member_3[0]))) * f32(-(_e1099))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1154.x) & 2147483647u)) * _e1207)) ^ _e167.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1154.y) & 2147483647u)) * _e1214)) ^ _e167.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1154.z) & 2147483647u)) * _e1221)) ^ _e167.member_3[0]))))) ^ _e167.member_3[0])) + _e1298) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1312 = phi_2135_;
                                                        phi_2136_ = _e1312;
                                                    }
                                                    let _e1314 = phi_2136_;
                                                    if _e1314 {
                                                        if (_e1086.member < _e705.member.member) {
                                                            phi_2156_ = true;
                                                        } else {
                                                            if (_e1086.member == _e705.member.member) {
                                                                phi_2155_ = (_e1086.member_3 < _e705.member.member_3);
                                                            } else {
                                                                phi_2155_ = false;
                                                            }
                                                            let _e1324 = phi_2155_;
                                                            phi_2156_ = _e1324;
                                                        }
                                                        let _e1326 = phi_2156_;
                                                        if _e1326 {
                                                            phi_2162_ = type_49(_e1086, _e1086.member);
                                                        } else {
                                                            phi_2162_ = _e705;
                                                        }
                                                        let _e1329 = phi_2162_;
                                                        phi_2163_ = _e1329;
                                                    } else {
                                                        phi_2163_ = _e705;
                                                    }
                                                    let _e1331 = phi_2163_;
                                                    phi_2164_ = _e1331;
                                                } else {
                                                    phi_2164_ = _e705;
                                                }
                                                let _e1333 = phi_2164_;
                                                phi_1096_ = _e1333;
                                            } else {
                                                phi_1096_ = type_49();
                                            }
                                            let _e1335 = phi_1096_;
                                            continue;
                                            continuing {
                                                phi_1095_ = _e1335;
                                                phi_1098_ = _e720;
                                                phi_2783_ = _e478;
                                                break if !(_e726);
                                            }
                                        }
                                        let _e1338 = phi_2783_;
                                        phi_2920_ = _e1338;
                                        if _e1338 {
                                            break;
                                        }
                                        phi_2924_ = _e1338;
                                        let _e1545 = local_3;
                                        phi_2618_ = _e1545;
                                        phi_2619_ = _e503;
                                        phi_2620_ = false;
                                        phi_2621_ = _e507;
                                    } else {
                                        if (_e503 >= _e75) {
                                            phi_2224_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e503 < _e75) {
                                            } else {
                                                phi_2920_ = true;
                                                break;
                                            }
                                            let _e517 = (_e292 % 3u);
                                            if (_e517 < 3u) {
                                            } else {
                                                phi_2920_ = true;
                                                break;
                                            }
                                            let _e523 = global_3.member[_e503].member[_e517];
                                            let _e529 = (_e291 % 3u);
                                            if (_e529 < 3u) {
                                            } else {
                                                phi_2920_ = true;
                                                break;
                                            }
                                            let _e535 = global_3.member[_e503].member[_e529];
                                            let _e541 = (_e293 % 3u);
                                            if (_e541 < 3u) {
                                            } else {
                                                phi_2920_ = true;
                                                break;
                                            }
                                            let _e547 = global_3.member[_e503].member[_e541];
                                            let _e557 = global_3.member[_e503].member_1;
                                            let _e561 = global_3.member[_e503].member_2;
                                            phi_2224_ = type_53(array<vec4<f32>, 3>(vec4<f32>(_e523[0], _e523[1], _e523[2], _e523[3]), vec4<f32>(_e535[0], _e535[1], _e535[2], _e535[3]), vec4<f32>(_e547[0], _e547[1], _e547[2], _e547[3])), _e557, _e561);
                                        }
                                        let _e564 = phi_2224_;
                                        let _e576 = ((_e564.member[0].x - _e347) * _e352);
                                        let _e577 = ((_e564.member[0].y - _e347) * _e352);
                                        let _e578 = ((_e564.member[0].z - _e348) * _e352);
                                        let _e579 = ((_e564.member[0].w - _e348) * _e352);
                                        let _e589 = ((_e564.member[1].x - _e383) * _e388);
                                        let _e590 = ((_e564.member[1].y - _e383) * _e388);
                                        let _e591 = ((_e564.member[1].z - _e384) * _e388);
                                        let _e592 = ((_e564.member[1].w - _e384) * _e388);
                                        let _e602 = ((_e564.member[2].x - _e419) * _e424);
                                        let _e603 = ((_e564.member[2].y - _e419) * _e424);
                                        let _e604 = ((_e564.member[2].z - _e420) * _e424);
                                        let _e605 = ((_e564.member[2].w - _e420) * _e424);
                                        let _e607 = select(_e604, _e602, (_e602 < _e604));
                                        let _e609 = select(_e605, _e603, (_e603 < _e605));
                                        let _e611 = select(_e604, _e602, (_e602 > _e604));
                                        let _e613 = select(_e605, _e603, (_e603 > _e605));
                                        let _e615 = select(_e578, _e576, (_e576 < _e578));
                                        let _e617 = select(_e579, _e577, (_e577 < _e579));
                                        let _e619 = select(_e591, _e589, (_e589 < _e591));
                                        let _e621 = select(_e592, _e590, (_e590 < _e592));
                                        let _e623 = select(_e619, _e615, (_e615 > _e619));
                                        let _e625 = select(_e621, _e617, (_e617 > _e621));
                                        let _e627 = select(_e607, _e623, (_e623 > _e607));
                                        let _e629 = select(_e609, _e625, (_e625 > _e609));
                                        let _e631 = select(_e578, _e576, (_e576 > _e578));
                                        let _e633 = select(_e579, _e577, (_e577 > _e579));
                                        let _e635 = select(_e591, _e589, (_e589 > _e591));
                                        let _e637 = select(_e592, _e590, (_e590 > _e592));
                                        let _e639 = select(_e635, _e631, (_e631 < _e635));
                                        let _e641 = select(_e637, _e633, (_e633 < _e637));
                                        let _e646 = -(_e607);
                                        let _e647 = -(_e609);
                                        let _e654 = (select(_e611, _e639, (_e639 < _e611)) + (select(_e646, _e611, (_e611 > _e646)) * 0.0000019073523f));
                                        let _e655 = (select(_e613, _e641, (_e641 < _e613)) + (select(_e647, _e613, (_e613 > _e647)) * 0.0000019073523f));
                                        let _e657 = select(_e470, _e627, (_e627 > _e470));
                                        let _e659 = select(_e470, _e629, (_e629 > _e470));
                                        let _e664 = (_e657 <= select(_e480.member_1, _e654, (_e654 < _e480.member_1)));
                                        let _e665 = (_e659 <= select(_e480.member_1, _e655, (_e655 < _e480.member_1)));
                                        let _e666 = (_e657 <= _e659);
                                        if _e664 {
                                            if _e665 {
                                                if _e666 {
                                                    phi_2568_ = _e564.member_2;
                                                } else {
                                                    phi_2568_ = _e564.member_1;
                                                }
                                                let _e670 = phi_2568_;
                                                let _e671 = (_e507 % 128u);
                                                let _e672 = (_e671 < 128u);
                                                if _e672 {
                                                } else {
                                                    phi_2920_ = true;
                                                    break;
                                                }
                                                local_1[_e671] = _e670;
                                                if _e672 {
                                                } else {
                                                    phi_2920_ = true;
                                                    break;
                                                }
                                                local[_e671] = select(_e659, _e657, (_e657 > _e659));
                                                if _e666 {
                                                    phi_2595_ = _e564.member_1;
                                                } else {
                                                    phi_2595_ = _e564.member_2;
                                                }
                                                let _e681 = phi_2595_;
                                                phi_2596_ = _e681;
                                                phi_2597_ = (_e507 + 1u);
                                            } else {
                                                phi_2596_ = u32();
                                                phi_2597_ = u32();
                                            }
                                            let _e683 = phi_2596_;
                                            let _e685 = phi_2597_;
                                            phi_2599_ = _e683;
                                            phi_2600_ = _e685;
                                            phi_2601_ = select(true, false, _e665);
                                        } else {
                                            phi_2599_ = u32();
                                            phi_2600_ = u32();
                                            phi_2601_ = true;
                                        }
                                        let _e688 = phi_2599_;
                                        let _e690 = phi_2600_;
                                        let _e692 = phi_2601_;
                                        if _e692 {
                                            if _e664 {
                                                phi_2610_ = _e564.member_1;
                                            } else {
                                                phi_2610_ = _e564.member_2;
                                            }
                                            let _e696 = phi_2610_;
                                            phi_2615_ = _e696;
                                            phi_2616_ = select(_e665, true, _e664);
                                        } else {
                                            phi_2615_ = _e688;
                                            phi_2616_ = _e505;
                                        }
                                        let _e699 = phi_2615_;
                                        let _e701 = phi_2616_;
                                        phi_2924_ = _e478;
                                        phi_2618_ = _e480;
                                        phi_2619_ = _e699;
                                        phi_2620_ = _e701;
                                        phi_2621_ = select(_e690, _e507, _e692);
                                    }
                                    let _e1340 = phi_2924_;
                                    let _e1342 = phi_2618_;
                                    let _e1344 = phi_2619_;
                                    let _e1346 = phi_2620_;
                                    let _e1348 = phi_2621_;
                                    phi_2923_ = _e1340;
                                    phi_2622_ = _e1342;
                                    phi_2623_ = _e1344;
                                    phi_2624_ = (_e484 - 1u);
                                    phi_2625_ = _e1346;
                                    phi_2626_ = _e1348;
                                } else {
                                    phi_2923_ = _e478;
                                    phi_2622_ = _e480;
                                    phi_2623_ = _e503;
                                    phi_2624_ = _e484;
                                    phi_2625_ = _e505;
                                    phi_2626_ = _e507;
                                }
                                let _e1350 = phi_2923_;
                                let _e1352 = phi_2622_;
                                let _e1354 = phi_2623_;
                                let _e1356 = phi_2624_;
                                let _e1358 = phi_2625_;
                                let _e1360 = phi_2626_;
                                phi_2922_ = _e1350;
                                phi_2627_ = _e1352;
                                phi_2628_ = _e1354;
                                phi_2629_ = _e1356;
                                phi_2630_ = _e1358;
                                phi_2631_ = _e1360;
                            } else {
                                phi_2922_ = _e478;
                                phi_2627_ = type_49();
                                phi_2628_ = u32();
                                phi_2629_ = u32();
                                phi_2630_ = bool();
                                phi_2631_ = u32();
                            }
                            let _e1362 = phi_2922_;
                            let _e1364 = phi_2627_;
                            let _e1366 = phi_2628_;
                            let _e1368 = phi_2629_;
                            let _e1370 = phi_2630_;
                            let _e1372 = phi_2631_;
                            phi_2921_ = _e1362;
                            phi_1028_ = _e1364;
                            phi_1031_ = _e1366;
                            phi_1033_ = _e1368;
                            phi_1035_ = _e1370;
                            phi_1037_ = _e1372;
                            phi_2632_ = _e492;
                        } else {
                            phi_2921_ = _e478;
                            phi_1028_ = type_49();
                            phi_1031_ = u32();
                            phi_1033_ = u32();
                            phi_1035_ = bool();
                            phi_1037_ = u32();
                            phi_2632_ = false;
                        }
                        let _e1374 = phi_2921_;
                        let _e1376 = phi_1028_;
                        let _e1378 = phi_1031_;
                        let _e1380 = phi_1033_;
                        let _e1382 = phi_1035_;
                        let _e1384 = phi_1037_;
                        let _e1386 = phi_2632_;
                        continue;
                        continuing {
                            phi_2789_ = _e1374;
                            phi_1027_ = _e1376;
                            phi_1030_ = _e1378;
                            phi_1032_ = _e1380;
                            phi_1034_ = _e1382;
                            phi_1036_ = _e1384;
                            phi_2920_ = _e1374;
                            break if !(_e1386);
                        }
                    }
                    let _e1389 = phi_2920_;
                    if _e1389 {
                        break;
                    }
                    let _e1391 = local_2;
                    if (_e1391.member.member_3 != 4294967295u) {
                        let _e1396 = (_e294 / 3i);
                        let _e1403 = bitcast<f32>((bitcast<u32>((_e1396 + 127i)) << bitcast<u32>(23i)));
                        let _e1411 = (((_e1391.member.member * _e1403) * _e1403) * bitcast<f32>((bitcast<u32>(((_e294 - (2i * _e1396)) + 127i)) << bitcast<u32>(23i))));
                        let _e1413 = select(340282350000000000000000000000000000000f, _e1411, (_e1411 < 340282350000000000000000000000000000000f));
                        phi_2684_ = type_28(select(-340282350000000000000000000000000000000f, _e1413, (_e1413 > -340282350000000000000000000000000000000f)), _e1391.member.member_1, _e1391.member.member_2, _e1391.member.member_3);
                    } else {
                        phi_2684_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1420 = phi_2684_;
                    if _e95 {
                    } else {
                        break;
                    }
                    global_8.member[_e93] = _e1420;
                    if _e94 {
                    } else {
                        break;
                    }
                    let _e1424 = select(0u, 1u, (_e238 <= _e248));
                    if (_e1424 > 0u) {
                        let _e1426 = (1u < _e89);
                        if _e1426 {
                            if (0u < _e89) {
                            } else {
                                break;
                            }
                            let _e1430 = atomicAdd((&global_9.member[0u]), _e1424);
                            if ((_e1430 + _e1424) < _e1430) {
                                if _e1426 {
                                } else {
                                    break;
                                }
                                let _e1435 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1438 = select(0u, 1u, (_e1420.member_3 != 4294967295u));
                    if (_e1438 > 0u) {
                        let _e1440 = (3u < _e89);
                        if _e1440 {
                            if (2u < _e89) {
                            } else {
                                break;
                            }
                            let _e1444 = atomicAdd((&global_9.member[2u]), _e1438);
                            if ((_e1444 + _e1438) < _e1444) {
                                if _e1440 {
                                } else {
                                    break;
                                }
                                let _e1449 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_facing(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
