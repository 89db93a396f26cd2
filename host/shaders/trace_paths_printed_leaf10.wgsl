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

struct type_35 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_38 {
    member: type_22,
    member_1: f32,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<i32>,
}

struct type_48 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_50 {
    member: array<type_48>,
}

struct type_53 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_55 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_57 {
    member: array<type_55>,
}

struct type_61 {
    member: type_53,
    member_1: u32,
}

struct type_66 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_41;
@group(0) @binding(2) 
var<uniform> global_3: type_41;
@group(0) @binding(5) 
var<storage> global_4: type_4;
@group(0) @binding(6) 
var<storage> global_5: type_44;
@group(0) @binding(7) 
var<storage> global_6: type_29;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_24;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_66;
@group(0) @binding(3) 
var<storage> global_9: type_50;
@group(0) @binding(4) 
var<storage> global_10: type_57;

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
    var phi_367_: u32;
    var phi_411_: i32;
    var phi_551_: type_35;
    var phi_657_: i32;
    var phi_658_: i32;
    var phi_668_: bool;
    var phi_678_: u32;
    var phi_679_: u32;
    var phi_681_: bool;
    var phi_686_: u32;
    var phi_719_: i32;
    var phi_737_: f32;
    var phi_743_: f32;
    var phi_783_: f32;
    var phi_789_: f32;
    var phi_841_: f32;
    var phi_853_: f32;
    var phi_862_: f32;
    var phi_868_: f32;
    var phi_908_: f32;
    var phi_914_: f32;
    var phi_966_: f32;
    var phi_978_: f32;
    var phi_987_: f32;
    var phi_993_: f32;
    var phi_1033_: f32;
    var phi_1039_: f32;
    var phi_1091_: f32;
    var phi_1103_: f32;
    var phi_1158_: i32;
    var phi_1180_: u32;
    var phi_1181_: u32;
    var phi_1218_: i32;
    var phi_1240_: u32;
    var phi_1241_: u32;
    var phi_1249_: f32;
    var phi_1250_: f32;
    var phi_4343_: bool;
    var phi_1333_: type_38;
    var phi_1336_: bool;
    var phi_1338_: u32;
    var phi_1340_: u32;
    var phi_1342_: type_61;
    var phi_1353_: bool;
    var phi_1439_: bool;
    var phi_1440_: u32;
    var phi_1441_: type_61;
    var phi_3065_: type_48;
    var phi_3951_: type_61;
    var phi_4028_: type_61;
    var phi_4029_: u32;
    var phi_4030_: type_61;
    var phi_4032_: u32;
    var phi_4033_: type_61;
    var phi_4034_: bool;
    var phi_4041_: type_61;
    var phi_4046_: bool;
    var phi_4048_: type_61;
    var phi_1460_: type_38;
    var phi_1463_: type_8;
    var phi_1464_: type_8;
    var phi_1486_: type_8;
    var phi_1511_: u32;
    var phi_1527_: type_55;
    var phi_1965_: bool;
    var phi_1994_: bool;
    var phi_2389_: f32;
    var phi_2390_: f32;
    var phi_2391_: f32;
    var phi_2392_: f32;
    var phi_2393_: vec3<f32>;
    var phi_2394_: vec3<f32>;
    var phi_2395_: vec3<f32>;
    var phi_2396_: vec3<f32>;
    var phi_2433_: bool;
    var phi_2442_: vec3<f32>;
    var phi_2607_: f32;
    var phi_2609_: f32;
    var phi_2610_: bool;
    var phi_2630_: f32;
    var phi_2631_: f32;
    var phi_2654_: type_22;
    var phi_2656_: type_22;
    var phi_2657_: bool;
    var phi_2661_: type_22;
    var phi_2662_: type_22;
    var phi_2663_: type_22;
    var phi_2664_: bool;
    var phi_2668_: type_22;
    var phi_2669_: bool;
    var phi_2670_: type_22;
    var phi_2671_: bool;
    var phi_2672_: bool;
    var phi_2673_: type_22;
    var phi_2674_: bool;
    var phi_2675_: bool;
    var phi_2683_: type_22;
    var phi_2684_: bool;
    var phi_2688_: type_22;
    var phi_2711_: u32;
    var phi_2725_: i32;
    var phi_2743_: vec3<f32>;
    var phi_2744_: vec3<f32>;
    var phi_2758_: vec3<f32>;
    var phi_2759_: vec3<f32>;
    var phi_2773_: vec3<f32>;
    var phi_2774_: vec3<f32>;
    var phi_2810_: vec3<f32>;
    var phi_2992_: f32;
    var phi_3010_: bool;
    var phi_3011_: bool;
    var phi_3030_: bool;
    var phi_3031_: bool;
    var phi_3037_: type_38;
    var phi_3038_: type_38;
    var phi_3039_: type_38;
    var phi_1461_: type_38;
    var phi_4337_: bool;
    var phi_4551_: bool;
    var phi_4052_: type_38;
    var phi_4053_: bool;
    var phi_4054_: u32;
    var phi_4055_: type_61;
    var phi_4550_: bool;
    var phi_4056_: type_38;
    var phi_4057_: bool;
    var phi_4058_: u32;
    var phi_4059_: u32;
    var phi_4060_: type_61;
    var phi_4549_: bool;
    var phi_4061_: type_38;
    var phi_4062_: bool;
    var phi_4063_: u32;
    var phi_4064_: u32;
    var phi_4065_: type_61;
    var phi_4548_: bool;
    var phi_1334_: type_38;
    var phi_1337_: bool;
    var phi_1339_: u32;
    var phi_1341_: u32;
    var phi_1343_: type_61;
    var phi_4066_: bool;
    var phi_4547_: bool;
    var local_10: type_38;
    var phi_4104_: f32;
    var phi_4106_: f32;
    var phi_4107_: bool;
    var phi_4108_: f32;
    var phi_4109_: bool;
    var phi_4257_: u32;
    var phi_4275_: bool;
    var phi_4278_: bool;
    var phi_4291_: f32;
    var phi_4292_: f32;
    var phi_4297_: f32;
    var phi_4298_: f32;
    var phi_4299_: bool;
    var phi_4307_: f32;
    var phi_4124_: f32;
    var phi_4125_: f32;
    var phi_4137_: f32;
    var phi_4142_: type_22;
    var local_11: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e93 = global;
            let _e96 = arrayLength((&global_9.member));
            let _e111 = arrayLength((&global_8.member));
            let _e115 = global_3.member[0u][0u];
            let _e119 = global_3.member[0u][1u];
            let _e123 = global_3.member[0u][2u];
            let _e127 = global_3.member[1u][0u];
            let _e131 = global_3.member[1u][1u];
            let _e135 = global_3.member[1u][2u];
            let _e139 = global_3.member[1u][3u];
            let _e143 = (_e93.x + (_e93.y * 2097152u));
            let _e150 = (_e143 < arrayLength((&global_6.member)));
            if _e150 {
                if _e150 {
                } else {
                    break;
                }
                let _e154 = global_6.member[_e143].member_2;
                phi_367_ = _e154;
            } else {
                phi_367_ = 4294967295u;
            }
            let _e156 = phi_367_;
            let _e159 = global_1.member[0u];
            let _e163 = global_2.member[0u][0u];
            let _e167 = global_2.member[0u][1u];
            let _e171 = global_2.member[0u][2u];
            let _e175 = global_2.member[0u][3u];
            let _e179 = global_2.member[1u][0u];
            let _e183 = global_2.member[1u][1u];
            let _e187 = global_2.member[1u][2u];
            let _e191 = global_2.member[1u][3u];
            let _e192 = bitcast<f32>(_e163);
            let _e193 = bitcast<f32>(_e167);
            let _e194 = bitcast<f32>(_e171);
            let _e196 = bitcast<f32>(_e179);
            let _e197 = array<u32, 3>(_e183, _e187, _e191);
            let _e199 = bitcast<i32>(_e159);
            if (_e199 < -126i) {
                phi_411_ = -126i;
            } else {
                phi_411_ = select(_e199, 127i, (_e199 > 127i));
            }
            let _e204 = phi_411_;
            let _e209 = bitcast<f32>((bitcast<u32>((_e204 + 127i)) << bitcast<u32>(23i)));
            let _e215 = bitcast<f32>((bitcast<u32>(((_e199 - _e204) + 127i)) << bitcast<u32>(23i)));
            if (_e175 == 0u) {
                phi_551_ = type_35(array<f32, 3>(_e192, _e193, _e194), _e175, _e196, _e197);
            } else {
                let _e217 = bitcast<u32>(_e192);
                let _e219 = ((_e217 & 2139095040u) != 0u);
                let _e234 = bitcast<u32>(_e193);
                let _e236 = ((_e234 & 2139095040u) != 0u);
                let _e251 = bitcast<u32>(_e194);
                let _e253 = ((_e251 & 2139095040u) != 0u);
                let _e269 = bitcast<u32>(_e196);
                let _e271 = ((_e269 & 2139095040u) != 0u);
                phi_551_ = type_35(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e217 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e217 & 2147483648u))), _e192, _e219) * _e209) * select(0.00000011920929f, 1f, _e219)) * _e215), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e234 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e234 & 2147483648u))), _e193, _e236) * _e209) * select(0.00000011920929f, 1f, _e236)) * _e215), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e251 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e251 & 2147483648u))), _e194, _e253) * _e209) * select(0.00000011920929f, 1f, _e253)) * _e215)), _e175, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e269 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e269 & 2147483648u))), _e196, _e271) * _e209) * select(0.00000011920929f, 1f, _e271)) * _e215), _e197);
            }
            let _e288 = phi_551_;
            if _e150 {
                let _e289 = (_e143 < arrayLength((&global_7.member)));
                if _e289 {
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e299 = global_6.member[_e143].member.member_2[0u];
                    let _e301 = (bitcast<u32>(_e299) & 2147483647u);
                    let _e307 = global_6.member[_e143].member.member_2[1u];
                    let _e309 = (bitcast<u32>(_e307) & 2147483647u);
                    let _e315 = global_6.member[_e143].member.member_2[2u];
                    let _e317 = (bitcast<u32>(_e315) & 2147483647u);
                    let _e323 = global_6.member[_e143].member.member[0u];
                    let _e325 = (bitcast<u32>(_e323) & 2147483647u);
                    let _e331 = global_6.member[_e143].member.member[1u];
                    let _e333 = (bitcast<u32>(_e331) & 2147483647u);
                    let _e339 = global_6.member[_e143].member.member[2u];
                    let _e341 = (bitcast<u32>(_e339) & 2147483647u);
                    let _e343 = select(_e309, _e301, (_e309 < _e301));
                    let _e345 = select(_e317, _e343, (_e317 < _e343));
                    let _e347 = select(_e325, _e345, (_e325 < _e345));
                    let _e349 = select(_e333, _e347, (_e333 < _e347));
                    let _e351 = select(_e341, _e349, (_e341 < _e349));
                    let _e356 = global_6.member[_e143].member.member_1;
                    let _e357 = bitcast<u32>(_e356);
                    let _e358 = (_e357 & 2147483647u);
                    let _e366 = global_6.member[_e143].member.member_3;
                    let _e367 = bitcast<u32>(_e366);
                    let _e368 = (_e367 & 2147483647u);
                    let _e372 = (((select(_e358, _e351, (_e358 < _e351)) < 2139095040u) && (_e368 <= 2139095040u)) && (_e345 > 0u));
                    if _e372 {
                        let _e375 = (bitcast<u32>(bitcast<f32>(_e345)) & 2147483647u);
                        if (_e375 >= 8388608u) {
                            phi_657_ = (bitcast<i32>((_e375 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_657_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e375)), 32u, (_e375 == 0u))));
                        }
                        let _e389 = phi_657_;
                        phi_658_ = _e389;
                    } else {
                        phi_658_ = 0i;
                    }
                    let _e391 = phi_658_;
                    let _e392 = (_e301 == _e345);
                    if _e392 {
                        phi_668_ = true;
                    } else {
                        phi_668_ = (_e309 == _e345);
                    }
                    let _e395 = phi_668_;
                    let _e396 = select(1u, 0u, _e392);
                    if _e395 {
                        let _e397 = (_e396 + 1u);
                        phi_678_ = _e397;
                        phi_679_ = _e397;
                        phi_681_ = select(true, false, (_e397 == 2u));
                    } else {
                        phi_678_ = u32();
                        phi_679_ = 0u;
                        phi_681_ = true;
                    }
                    let _e401 = phi_678_;
                    let _e403 = phi_679_;
                    let _e405 = phi_681_;
                    if _e405 {
                        phi_686_ = (_e403 + 1u);
                    } else {
                        phi_686_ = 0u;
                    }
                    let _e409 = phi_686_;
                    let _e410 = select(_e401, _e403, _e405);
                    let _e411 = select(_e396, select(2u, _e396, _e395), _e405);
                    let _e412 = -(_e391);
                    if (_e412 < -126i) {
                        phi_719_ = -126i;
                    } else {
                        phi_719_ = select(_e412, 127i, (_e412 > 127i));
                    }
                    let _e417 = phi_719_;
                    let _e422 = bitcast<f32>((bitcast<u32>((_e417 + 127i)) << bitcast<u32>(23i)));
                    let _e428 = bitcast<f32>((bitcast<u32>(((_e412 - _e417) + 127i)) << bitcast<u32>(23i)));
                    let _e433 = global_6.member[_e143].member.member;
                    let _e434 = (_e410 == 0u);
                    if _e434 {
                        phi_737_ = _e433[0];
                    } else {
                        phi_737_ = _e433[1];
                    }
                    let _e438 = phi_737_;
                    let _e439 = (_e410 == 2u);
                    if _e439 {
                        phi_743_ = _e433[2];
                    } else {
                        phi_743_ = _e438;
                    }
                    let _e442 = phi_743_;
                    let _e443 = bitcast<u32>(_e442);
                    let _e445 = ((_e443 & 2139095040u) != 0u);
                    let _e457 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e443 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e443 & 2147483648u))), _e442, _e445) * select(0.00000011920929f, 1f, _e445));
                    let _e458 = global_6.member[_e143].member.member_2;
                    if _e434 {
                        phi_783_ = _e458[0];
                    } else {
                        phi_783_ = _e458[1];
                    }
                    let _e462 = phi_783_;
                    if _e439 {
                        phi_789_ = _e458[2];
                    } else {
                        phi_789_ = _e462;
                    }
                    let _e465 = phi_789_;
                    let _e466 = bitcast<u32>(_e465);
                    let _e468 = ((_e466 & 2139095040u) != 0u);
                    let _e482 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e466 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e466 & 2147483648u))), _e465, _e468) * _e422) * select(0.00000011920929f, 1f, _e468)) * _e428);
                    let _e486 = (bitcast<f32>((bitcast<u32>(_e482) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e486 {
                        let _e490 = (bitcast<f32>((bitcast<u32>(_e457) & 2147483647u)) * 0.00000011920929f);
                        phi_841_ = select(0.00000000000011368684f, _e490, (_e490 > 0.00000000000011368684f));
                    } else {
                        phi_841_ = 0f;
                    }
                    let _e494 = phi_841_;
                    let _e495 = (_e457 + _e494);
                    let _e496 = (_e457 - _e494);
                    let _e497 = select(_e482, 0f, _e486);
                    if _e486 {
                        phi_853_ = 38685626000000000000000000f;
                    } else {
                        phi_853_ = (1f / _e482);
                    }
                    let _e500 = phi_853_;
                    let _e501 = (_e409 == 0u);
                    if _e501 {
                        phi_862_ = _e433[0];
                    } else {
                        phi_862_ = _e433[1];
                    }
                    let _e505 = phi_862_;
                    let _e506 = (_e409 == 2u);
                    if _e506 {
                        phi_868_ = _e433[2];
                    } else {
                        phi_868_ = _e505;
                    }
                    let _e509 = phi_868_;
                    let _e510 = bitcast<u32>(_e509);
                    let _e512 = ((_e510 & 2139095040u) != 0u);
                    let _e524 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e510 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e510 & 2147483648u))), _e509, _e512) * select(0.00000011920929f, 1f, _e512));
                    if _e501 {
                        phi_908_ = _e458[0];
                    } else {
                        phi_908_ = _e458[1];
                    }
                    let _e528 = phi_908_;
                    if _e506 {
                        phi_914_ = _e458[2];
                    } else {
                        phi_914_ = _e528;
                    }
                    let _e531 = phi_914_;
                    let _e532 = bitcast<u32>(_e531);
                    let _e534 = ((_e532 & 2139095040u) != 0u);
                    let _e548 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e532 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e532 & 2147483648u))), _e531, _e534) * _e422) * select(0.00000011920929f, 1f, _e534)) * _e428);
                    let _e552 = (bitcast<f32>((bitcast<u32>(_e548) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e552 {
                        let _e556 = (bitcast<f32>((bitcast<u32>(_e524) & 2147483647u)) * 0.00000011920929f);
                        phi_966_ = select(0.00000000000011368684f, _e556, (_e556 > 0.00000000000011368684f));
                    } else {
                        phi_966_ = 0f;
                    }
                    let _e560 = phi_966_;
                    let _e561 = (_e524 + _e560);
                    let _e562 = (_e524 - _e560);
                    let _e563 = select(_e548, 0f, _e552);
                    if _e552 {
                        phi_978_ = 38685626000000000000000000f;
                    } else {
                        phi_978_ = (1f / _e548);
                    }
                    let _e566 = phi_978_;
                    let _e567 = (_e411 == 0u);
                    if _e567 {
                        phi_987_ = _e433[0];
                    } else {
                        phi_987_ = _e433[1];
                    }
                    let _e571 = phi_987_;
                    let _e572 = (_e411 == 2u);
                    if _e572 {
                        phi_993_ = _e433[2];
                    } else {
                        phi_993_ = _e571;
                    }
                    let _e575 = phi_993_;
                    let _e576 = bitcast<u32>(_e575);
                    let _e578 = ((_e576 & 2139095040u) != 0u);
                    let _e590 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e576 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e576 & 2147483648u))), _e575, _e578) * select(0.00000011920929f, 1f, _e578));
                    if _e567 {
                        phi_1033_ = _e458[0];
                    } else {
                        phi_1033_ = _e458[1];
                    }
                    let _e594 = phi_1033_;
                    if _e572 {
                        phi_1039_ = _e458[2];
                    } else {
                        phi_1039_ = _e594;
                    }
                    let _e597 = phi_1039_;
                    let _e598 = bitcast<u32>(_e597);
                    let _e600 = ((_e598 & 2139095040u) != 0u);
                    let _e614 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e598 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e598 & 2147483648u))), _e597, _e600) * _e422) * select(0.00000011920929f, 1f, _e600)) * _e428);
                    let _e618 = (bitcast<f32>((bitcast<u32>(_e614) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e618 {
                        let _e622 = (bitcast<f32>((bitcast<u32>(_e590) & 2147483647u)) * 0.00000011920929f);
                        phi_1091_ = select(0.00000000000011368684f, _e622, (_e622 > 0.00000000000011368684f));
                    } else {
                        phi_1091_ = 0f;
                    }
                    let _e626 = phi_1091_;
                    let _e627 = (_e590 + _e626);
                    let _e628 = (_e590 - _e626);
                    let _e629 = select(_e614, 0f, _e618);
                    if _e618 {
                        phi_1103_ = 38685626000000000000000000f;
                    } else {
                        phi_1103_ = (1f / _e614);
                    }
                    let _e632 = phi_1103_;
                    let _e635 = bitcast<f32>((bitcast<u32>(_e457) & 2147483647u));
                    let _e638 = bitcast<f32>((bitcast<u32>(_e524) & 2147483647u));
                    let _e640 = select(_e638, _e635, (_e635 > _e638));
                    let _e643 = bitcast<f32>((bitcast<u32>(_e590) & 2147483647u));
                    if (_e372 && (select(_e643, _e640, (_e640 > _e643)) <= 1099511600000f)) {
                        let _e655 = ((_e358 & 8388607u) | (select(0u, 1u, ((_e358 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e658 = bitcast<i32>((_e358 >> bitcast<u32>(23i)));
                        let _e662 = (_e655 == 0u);
                        let _e665 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e655)), 32u, _e662)) - 8i);
                        if (_e658 == 255i) {
                            phi_1158_ = 255i;
                        } else {
                            phi_1158_ = (((_e658 + select(0i, 1i, (_e658 == 0i))) - _e665) + _e391);
                        }
                        let _e673 = phi_1158_;
                        let _e683 = (_e673 <= 0i);
                        if _e683 {
                            phi_1181_ = u32();
                        } else {
                            if _e662 {
                                phi_1180_ = u32();
                            } else {
                                phi_1180_ = select(((bitcast<u32>(_e673) << bitcast<u32>(23i)) | ((_e655 << bitcast<u32>(((_e665 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e673 >= 255i));
                            }
                            let _e687 = phi_1180_;
                            phi_1181_ = _e687;
                        }
                        let _e689 = phi_1181_;
                        let _e701 = ((_e368 & 8388607u) | (select(0u, 1u, ((_e368 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e704 = bitcast<i32>((_e368 >> bitcast<u32>(23i)));
                        let _e708 = (_e701 == 0u);
                        let _e711 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e701)), 32u, _e708)) - 8i);
                        if (_e704 == 255i) {
                            phi_1218_ = 255i;
                        } else {
                            phi_1218_ = (((_e704 + select(0i, 1i, (_e704 == 0i))) - _e711) + _e391);
                        }
                        let _e719 = phi_1218_;
                        let _e729 = (_e719 <= 0i);
                        if _e729 {
                            phi_1241_ = u32();
                        } else {
                            if _e708 {
                                phi_1240_ = u32();
                            } else {
                                phi_1240_ = select(((bitcast<u32>(_e719) << bitcast<u32>(23i)) | ((_e701 << bitcast<u32>(((_e711 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e719 >= 255i));
                            }
                            let _e733 = phi_1240_;
                            phi_1241_ = _e733;
                        }
                        let _e735 = phi_1241_;
                        phi_1249_ = bitcast<f32>(((_e367 & 2147483648u) | select(_e735, 0u, select(_e708, true, _e729))));
                        phi_1250_ = bitcast<f32>(((_e357 & 2147483648u) | select(_e689, 0u, select(_e662, true, _e683))));
                    } else {
                        phi_1249_ = 0f;
                        phi_1250_ = 1f;
                    }
                    let _e741 = phi_1249_;
                    let _e743 = phi_1250_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e115), bitcast<f32>(_e119), bitcast<f32>(_e123));
                    let _e748 = (_e410 % 3u);
                    let _e749 = (_e748 < 3u);
                    if _e749 {
                    } else {
                        break;
                    }
                    let _e751 = local_9[_e748];
                    let _e752 = (_e409 % 3u);
                    let _e753 = (_e752 < 3u);
                    if _e753 {
                    } else {
                        break;
                    }
                    let _e755 = local_9[_e752];
                    let _e756 = (_e411 % 3u);
                    let _e757 = (_e756 < 3u);
                    if _e757 {
                    } else {
                        break;
                    }
                    let _e759 = local_9[_e756];
                    local_8 = array<f32, 3>(bitcast<f32>(_e127), bitcast<f32>(_e131), bitcast<f32>(_e135));
                    if _e749 {
                    } else {
                        break;
                    }
                    let _e763 = local_8[_e748];
                    if _e753 {
                    } else {
                        break;
                    }
                    let _e765 = local_8[_e752];
                    if _e757 {
                    } else {
                        break;
                    }
                    let _e767 = local_8[_e756];
                    phi_4343_ = false;
                    phi_1333_ = type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e741);
                    phi_1336_ = (_e743 <= _e741);
                    phi_1338_ = ((3u * _e96) + 1u);
                    phi_1340_ = 0u;
                    phi_1342_ = type_61(type_53(array<f32, 3>(_e751, _e755, _e759), array<f32, 3>(_e763, _e765, _e767)), select(0u, 2147483648u, (_e96 == 0u)));
                    loop {
                        let _e775 = phi_4343_;
                        let _e777 = phi_1333_;
                        let _e779 = phi_1336_;
                        let _e781 = phi_1338_;
                        let _e783 = phi_1340_;
                        let _e785 = phi_1342_;
                        local_10 = _e777;
                        if _e779 {
                            phi_1353_ = true;
                        } else {
                            phi_1353_ = (_e783 > 0u);
                        }
                        let _e788 = phi_1353_;
                        if _e788 {
                            let _e789 = (_e781 > 0u);
                            if _e789 {
                                if _e779 {
                                    phi_1439_ = _e779;
                                    phi_1440_ = _e783;
                                    phi_1441_ = _e785;
                                } else {
                                    let _e790 = (_e783 - 1u);
                                    let _e791 = (_e790 % 128u);
                                    let _e792 = (_e791 < 128u);
                                    if _e792 {
                                    } else {
                                        phi_4547_ = true;
                                        break;
                                    }
                                    let _e794 = local_6[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4547_ = true;
                                        break;
                                    }
                                    let _e796 = local_5[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4547_ = true;
                                        break;
                                    }
                                    let _e798 = local_4[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4547_ = true;
                                        break;
                                    }
                                    let _e800 = local_3[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4547_ = true;
                                        break;
                                    }
                                    let _e803 = local_2[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4547_ = true;
                                        break;
                                    }
                                    let _e805 = local_1[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4547_ = true;
                                        break;
                                    }
                                    let _e807 = local[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4547_ = true;
                                        break;
                                    }
                                    let _e812 = local_7[_e791];
                                    phi_1439_ = (_e812 <= _e777.member_1);
                                    phi_1440_ = _e790;
                                    phi_1441_ = type_61(type_53(array<f32, 3>(_e796, _e798, _e800), array<f32, 3>(_e803, _e805, _e807)), _e794);
                                }
                                let _e816 = phi_1439_;
                                let _e818 = phi_1440_;
                                let _e820 = phi_1441_;
                                if _e816 {
                                    if ((_e820.member_1 & 2147483648u) != 0u) {
                                        phi_1460_ = _e777;
                                        phi_1463_ = type_8(0u, ((_e820.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1197 = phi_1460_;
                                            let _e1199 = phi_1463_;
                                            local_11 = _e1197;
                                            if (_e1199.member < _e1199.member_1) {
                                                phi_1464_ = type_8((_e1199.member + 1u), _e1199.member_1);
                                                phi_1486_ = type_8(1u, _e1199.member);
                                            } else {
                                                phi_1464_ = _e1199;
                                                phi_1486_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1212 = phi_1464_;
                                            let _e1214 = phi_1486_;
                                            let _e1218 = (bitcast<i32>(_e1214.member) != 0i);
                                            if _e1218 {
                                                let _e1219 = ((_e820.member_1 & 268435455u) + _e1214.member_1);
                                                let _e1220 = (_e1219 < arrayLength((&global_10.member)));
                                                if _e1220 {
                                                    if _e1220 {
                                                    } else {
                                                        phi_4337_ = true;
                                                        break;
                                                    }
                                                    let _e1223 = global_10.member[_e1219].member_1;
                                                    phi_1511_ = _e1223;
                                                } else {
                                                    phi_1511_ = 4294967295u;
                                                }
                                                let _e1225 = phi_1511_;
                                                if _e1220 {
                                                    if _e1220 {
                                                    } else {
                                                        phi_4337_ = true;
                                                        break;
                                                    }
                                                    let _e1227 = global_10.member[_e1219];
                                                    phi_1527_ = _e1227;
                                                } else {
                                                    phi_1527_ = type_55(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e1229 = phi_1527_;
                                                let _e1241 = ((10u * _e410) & 31u);
                                                let _e1244 = ((_e1229.member[0] >> bitcast<u32>(_e1241)) & 1023u);
                                                let _e1252 = bitcast<f32>((bitcast<u32>(((_e820.member.member_1[0] - _e820.member.member[0]) * 0.0009775171f)) ^ _e139));
                                                let _e1257 = (_e820.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1244)) - 8388608f) * _e1252)) ^ _e139)));
                                                let _e1261 = select(select(_e820.member.member_1[0], _e1257, (_e1257 < _e820.member.member_1[0])), _e820.member.member_1[0], (_e1244 == 1023u));
                                                let _e1263 = ((10u * _e409) & 31u);
                                                let _e1266 = ((_e1229.member[0] >> bitcast<u32>(_e1263)) & 1023u);
                                                let _e1274 = bitcast<f32>((bitcast<u32>(((_e820.member.member_1[1] - _e820.member.member[1]) * 0.0009775171f)) ^ _e139));
                                                let _e1279 = (_e820.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1266)) - 8388608f) * _e1274)) ^ _e139)));
                                                let _e1283 = select(select(_e820.member.member_1[1], _e1279, (_e1279 < _e820.member.member_1[1])), _e820.member.member_1[1], (_e1266 == 1023u));
                                                let _e1285 = ((10u * _e411) & 31u);
                                                let _e1288 = ((_e1229.member[0] >> bitcast<u32>(_e1285)) & 1023u);
                                                let _e1296 = bitcast<f32>((bitcast<u32>(((_e820.member.member_1[2] - _e820.member.member[2]) * 0.0009775171f)) ^ _e139));
                                                let _e1301 = (_e820.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1288)) - 8388608f) * _e1296)) ^ _e139)));
                                                let _e1305 = select(select(_e820.member.member_1[2], _e1301, (_e1301 < _e820.member.member_1[2])), _e820.member.member_1[2], (_e1288 == 1023u));
                                                let _e1309 = ((_e1229.member[1] >> bitcast<u32>(_e1241)) & 1023u);
                                                let _e1317 = (_e820.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1309)) - 8388608f) * _e1252)) ^ _e139)));
                                                let _e1321 = select(select(_e820.member.member_1[0], _e1317, (_e1317 < _e820.member.member_1[0])), _e820.member.member_1[0], (_e1309 == 1023u));
                                                let _e1324 = ((_e1229.member[1] >> bitcast<u32>(_e1263)) & 1023u);
                                                let _e1332 = (_e820.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1324)) - 8388608f) * _e1274)) ^ _e139)));
                                                let _e1336 = select(select(_e820.member.member_1[1], _e1332, (_e1332 < _e820.member.member_1[1])), _e820.member.member_1[1], (_e1324 == 1023u));
                                                let _e1339 = ((_e1229.member[1] >> bitcast<u32>(_e1285)) & 1023u);
                                                let _e1347 = (_e820.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1339)) - 8388608f) * _e1296)) ^ _e139)));
                                                let _e1351 = select(select(_e820.member.member_1[2], _e1347, (_e1347 < _e820.member.member_1[2])), _e820.member.member_1[2], (_e1339 == 1023u));
                                                let _e1355 = ((_e1229.member[2] >> bitcast<u32>(_e1241)) & 1023u);
                                                let _e1363 = (_e820.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1355)) - 8388608f) * _e1252)) ^ _e139)));
                                                let _e1367 = select(select(_e820.member.member_1[0], _e1363, (_e1363 < _e820.member.member_1[0])), _e820.member.member_1[0], (_e1355 == 1023u));
                                                let _e1370 = ((_e1229.member[2] >> bitcast<u32>(_e1263)) & 1023u);
                                                let _e1378 = (_e820.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1370)) - 8388608f) * _e1274)) ^ _e139)));
                                                let _e1382 = select(select(_e820.member.member_1[1], _e1378, (_e1378 < _e820.member.member_1[1])), _e820.member.member_1[1], (_e1370 == 1023u));
                                                let _e1385 = ((_e1229.member[2] >> bitcast<u32>(_e1285)) & 1023u);
                                                let _e1393 = (_e820.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1385)) - 8388608f) * _e1296)) ^ _e139)));
                                                let _e1397 = select(select(_e820.member.member_1[2], _e1393, (_e1393 < _e820.member.member_1[2])), _e820.member.member_1[2], (_e1385 == 1023u));
                                                let _e1401 = (_e1305 - _e590);
                                                let _e1404 = (((_e1261 - _e457) * _e629) - (_e1401 * _e497));
                                                let _e1407 = (((_e1283 - _e524) * _e629) - (_e1401 * _e563));
                                                let _e1410 = (_e1351 - _e590);
                                                let _e1413 = (((_e1321 - _e457) * _e629) - (_e1410 * _e497));
                                                let _e1416 = (((_e1336 - _e524) * _e629) - (_e1410 * _e563));
                                                let _e1419 = (_e1397 - _e590);
                                                let _e1422 = (((_e1367 - _e457) * _e629) - (_e1419 * _e497));
                                                let _e1425 = (((_e1382 - _e524) * _e629) - (_e1419 * _e563));
                                                let _e1426 = (_e1422 * _e1416);
                                                let _e1427 = (_e1425 * _e1413);
                                                let _e1428 = (_e1404 * _e1425);
                                                let _e1429 = (_e1407 * _e1422);
                                                let _e1430 = (_e1413 * _e1407);
                                                let _e1431 = (_e1416 * _e1404);
                                                let _e1436 = (((_e1426 >= _e1427) && (_e1428 >= _e1429)) && (_e1430 >= _e1431));
                                                if (_e1436 || (((_e1426 <= _e1427) && (_e1428 <= _e1429)) && (_e1430 <= _e1431))) {
                                                    let _e1443 = select(-1f, 1f, _e1436);
                                                    let _e1445 = ((_e1426 - _e1427) * _e1443);
                                                    let _e1447 = select(0f, _e1445, (_e1445 > 0f));
                                                    let _e1449 = ((_e1428 - _e1429) * _e1443);
                                                    let _e1451 = select(0f, _e1449, (_e1449 > 0f));
                                                    let _e1453 = ((_e1430 - _e1431) * _e1443);
                                                    let _e1455 = select(0f, _e1453, (_e1453 > 0f));
                                                    let _e1457 = ((_e1447 + _e1451) + _e1455);
                                                    if (_e1457 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2673_ = type_22();
                                                        phi_2674_ = true;
                                                        phi_2675_ = false;
                                                    } else {
                                                        let _e1460 = select(_e1413, _e1404, (_e1404 < _e1413));
                                                        if (select(_e1422, _e1460, (_e1460 < _e1422)) > 0f) {
                                                            phi_1965_ = true;
                                                        } else {
                                                            let _e1465 = select(_e1413, _e1404, (_e1404 > _e1413));
                                                            phi_1965_ = (select(_e1422, _e1465, (_e1465 > _e1422)) < 0f);
                                                        }
                                                        let _e1470 = phi_1965_;
                                                        if _e1470 {
                                                            phi_2670_ = type_22();
                                                            phi_2671_ = true;
                                                            phi_2672_ = false;
                                                        } else {
                                                            let _e1472 = select(_e1416, _e1407, (_e1407 < _e1416));
                                                            if (select(_e1425, _e1472, (_e1472 < _e1425)) > 0f) {
                                                                phi_1994_ = true;
                                                            } else {
                                                                let _e1477 = select(_e1416, _e1407, (_e1407 > _e1416));
                                                                phi_1994_ = (select(_e1425, _e1477, (_e1477 > _e1425)) < 0f);
                                                            }
                                                            let _e1482 = phi_1994_;
                                                            if _e1482 {
                                                                phi_2668_ = type_22();
                                                                phi_2669_ = false;
                                                            } else {
                                                                let _e1484 = select(_e1321, _e1261, (_e1261 < _e1321));
                                                                let _e1488 = select(_e1321, _e1261, (_e1261 > _e1321));
                                                                let _e1492 = select(_e1336, _e1283, (_e1283 < _e1336));
                                                                let _e1496 = select(_e1336, _e1283, (_e1283 > _e1336));
                                                                let _e1500 = select(_e1351, _e1305, (_e1305 < _e1351));
                                                                let _e1504 = select(_e1351, _e1305, (_e1305 > _e1351));
                                                                let _e1509 = ((select(_e1367, _e1484, (_e1484 < _e1367)) - _e495) * _e500);
                                                                let _e1510 = ((select(_e1367, _e1488, (_e1488 > _e1367)) - _e496) * _e500);
                                                                let _e1513 = ((select(_e1382, _e1492, (_e1492 < _e1382)) - _e561) * _e566);
                                                                let _e1514 = ((select(_e1382, _e1496, (_e1496 > _e1382)) - _e562) * _e566);
                                                                let _e1517 = ((select(_e1397, _e1500, (_e1500 < _e1397)) - _e627) * _e632);
                                                                let _e1518 = ((select(_e1397, _e1504, (_e1504 > _e1397)) - _e628) * _e632);
                                                                let _e1520 = select(_e1518, _e1517, (_e1517 < _e1518));
                                                                let _e1522 = select(_e1518, _e1517, (_e1517 > _e1518));
                                                                let _e1524 = select(_e1510, _e1509, (_e1509 < _e1510));
                                                                let _e1526 = select(_e1514, _e1513, (_e1513 < _e1514));
                                                                let _e1528 = select(_e1526, _e1524, (_e1524 > _e1526));
                                                                let _e1530 = select(_e1520, _e1528, (_e1528 > _e1520));
                                                                let _e1532 = select(_e1510, _e1509, (_e1509 > _e1510));
                                                                let _e1534 = select(_e1514, _e1513, (_e1513 > _e1514));
                                                                let _e1536 = select(_e1534, _e1532, (_e1532 < _e1534));
                                                                let _e1538 = select(_e1522, _e1536, (_e1536 < _e1522));
                                                                let _e1539 = -(_e1520);
                                                                let _e1545 = select(_e743, _e1530, (_e1530 > _e743));
                                                                if (_e1545 > (_e1538 + (select(_e1539, _e1522, (_e1522 > _e1539)) * 0.0000019073523f))) {
                                                                    phi_2663_ = type_22();
                                                                    phi_2664_ = true;
                                                                } else {
                                                                    let _e1547 = (_e1545 > _e1197.member_1);
                                                                    if _e1547 {
                                                                        phi_2662_ = type_22();
                                                                    } else {
                                                                        let _e1548 = vec3<f32>(_e1261, _e1283, _e1305);
                                                                        let _e1549 = vec3<f32>(_e1321, _e1336, _e1351);
                                                                        let _e1550 = vec3<f32>(_e1367, _e1382, _e1397);
                                                                        let _e1551 = (_e1321 - _e1261);
                                                                        let _e1552 = (_e1336 - _e1283);
                                                                        let _e1553 = (_e1351 - _e1305);
                                                                        let _e1554 = vec3<f32>(_e1551, _e1552, _e1553);
                                                                        let _e1555 = (_e1367 - _e1321);
                                                                        let _e1556 = (_e1382 - _e1336);
                                                                        let _e1557 = (_e1397 - _e1351);
                                                                        let _e1558 = vec3<f32>(_e1555, _e1556, _e1557);
                                                                        let _e1559 = (_e1261 - _e1367);
                                                                        let _e1560 = (_e1283 - _e1382);
                                                                        let _e1561 = (_e1305 - _e1397);
                                                                        let _e1562 = vec3<f32>(_e1559, _e1560, _e1561);
                                                                        let _e1565 = bitcast<f32>((bitcast<u32>(_e1551) & 2147483647u));
                                                                        let _e1568 = bitcast<f32>((bitcast<u32>(_e1552) & 2147483647u));
                                                                        let _e1570 = select(_e1568, _e1565, (_e1565 > _e1568));
                                                                        let _e1573 = bitcast<f32>((bitcast<u32>(_e1553) & 2147483647u));
                                                                        let _e1575 = select(_e1573, _e1570, (_e1570 > _e1573));
                                                                        let _e1578 = bitcast<f32>((bitcast<u32>(_e1555) & 2147483647u));
                                                                        let _e1581 = bitcast<f32>((bitcast<u32>(_e1556) & 2147483647u));
                                                                        let _e1583 = select(_e1581, _e1578, (_e1578 > _e1581));
                                                                        let _e1586 = bitcast<f32>((bitcast<u32>(_e1557) & 2147483647u));
                                                                        let _e1588 = select(_e1586, _e1583, (_e1583 > _e1586));
                                                                        let _e1591 = bitcast<f32>((bitcast<u32>(_e1559) & 2147483647u));
                                                                        let _e1594 = bitcast<f32>((bitcast<u32>(_e1560) & 2147483647u));
                                                                        let _e1596 = select(_e1594, _e1591, (_e1591 > _e1594));
                                                                        let _e1599 = bitcast<f32>((bitcast<u32>(_e1561) & 2147483647u));
                                                                        let _e1601 = select(_e1599, _e1596, (_e1596 > _e1599));
                                                                        let _e1603 = select(_e1588, _e1575, (_e1575 > _e1588));
                                                                        let _e1605 = select(_e1601, _e1603, (_e1603 > _e1601));
                                                                        if (_e1575 == _e1605) {
                                                                            phi_2389_ = _e1416;
                                                                            phi_2390_ = _e1413;
                                                                            phi_2391_ = _e1407;
                                                                            phi_2392_ = _e1404;
                                                                            phi_2393_ = _e1548;
                                                                            phi_2394_ = _e1562;
                                                                            phi_2395_ = _e1558;
                                                                            phi_2396_ = _e1554;
                                                                        } else {
                                                                            let _e1607 = (_e1588 == _e1605);
                                                                            let _e1612 = vec3(_e1607);
                                                                            phi_2389_ = select(_e1407, _e1425, _e1607);
                                                                            phi_2390_ = select(_e1404, _e1422, _e1607);
                                                                            phi_2391_ = select(_e1425, _e1416, _e1607);
                                                                            phi_2392_ = select(_e1422, _e1413, _e1607);
                                                                            phi_2393_ = select(_e1550, _e1549, _e1612);
                                                                            phi_2394_ = select(_e1558, _e1554, _e1612);
                                                                            phi_2395_ = select(_e1554, _e1562, _e1612);
                                                                            phi_2396_ = select(_e1562, _e1558, _e1612);
                                                                        }
                                                                        let _e1618 = phi_2389_;
                                                                        let _e1620 = phi_2390_;
                                                                        let _e1622 = phi_2391_;
                                                                        let _e1624 = phi_2392_;
                                                                        let _e1626 = phi_2393_;
                                                                        let _e1628 = phi_2394_;
                                                                        let _e1630 = phi_2395_;
                                                                        let _e1632 = phi_2396_;
                                                                        let _e1639 = ((_e1630.y * _e1628.z) - (_e1628.y * _e1630.z));
                                                                        let _e1644 = ((_e1630.z * _e1628.x) - (_e1628.z * _e1630.x));
                                                                        let _e1647 = ((_e1630.x * _e1628.y) - (_e1628.x * _e1630.y));
                                                                        if (_e1447 >= _e1451) {
                                                                            phi_2433_ = select(true, false, (_e1447 >= _e1455));
                                                                        } else {
                                                                            phi_2433_ = true;
                                                                        }
                                                                        let _e1652 = phi_2433_;
                                                                        if _e1652 {
                                                                            phi_2442_ = select(_e1550, _e1549, vec3((_e1451 >= _e1455)));
                                                                        } else {
                                                                            phi_2442_ = _e1548;
                                                                        }
                                                                        let _e1657 = phi_2442_;
                                                                        let _e1668 = (((_e1639 * (_e1657.x - _e457)) + (_e1644 * (_e1657.y - _e524))) + (_e1647 * (_e1657.z - _e590)));
                                                                        let _e1673 = (((_e1639 * _e497) + (_e1644 * _e563)) + (_e1647 * _e629));
                                                                        let _e1674 = (_e1620 - _e1624);
                                                                        let _e1675 = (_e1618 - _e1622);
                                                                        let _e1683 = (-(((_e1624 * _e1674) + (_e1622 * _e1675))) / ((_e1674 * _e1674) + (_e1675 * _e1675)));
                                                                        let _e1685 = select(1f, _e1683, (_e1683 < 1f));
                                                                        let _e1687 = select(0f, _e1685, (_e1685 > 0f));
                                                                        let _e1700 = ((_e1626.x + (_e1632.x * _e1687)) - _e457);
                                                                        let _e1701 = ((_e1626.y + (_e1632.y * _e1687)) - _e524);
                                                                        let _e1702 = ((_e1626.z + (_e1632.z * _e1687)) - _e590);
                                                                        let _e1703 = (_e1702 / _e629);
                                                                        let _e1715 = bitcast<f32>((bitcast<u32>(_e1700) & 2147483647u));
                                                                        let _e1718 = bitcast<f32>((bitcast<u32>(_e1701) & 2147483647u));
                                                                        let _e1720 = select(_e1718, _e1715, (_e1715 > _e1718));
                                                                        let _e1723 = bitcast<f32>((bitcast<u32>(_e1702) & 2147483647u));
                                                                        let _e1725 = select(_e1723, _e1720, (_e1720 > _e1723));
                                                                        let _e1731 = bitcast<f32>((bitcast<u32>(_e1639) & 2147483647u));
                                                                        let _e1734 = bitcast<f32>((bitcast<u32>(_e1644) & 2147483647u));
                                                                        let _e1736 = select(_e1734, _e1731, (_e1731 > _e1734));
                                                                        let _e1739 = bitcast<f32>((bitcast<u32>(_e1647) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1639 * _e1700) + (_e1644 * _e1701)) + (_e1647 * _e1702)) - _e1668)) & 2147483647u)) <= ((0.0000009536743f * select(_e1605, _e1725, (_e1725 > _e1605))) * select(_e1739, _e1736, (_e1736 > _e1739)))) {
                                                                            let _e1749 = bitcast<f32>((bitcast<u32>(_e1630.x) & 2147483647u));
                                                                            let _e1752 = bitcast<f32>((bitcast<u32>(_e1630.y) & 2147483647u));
                                                                            let _e1754 = select(_e1752, _e1749, (_e1749 > _e1752));
                                                                            let _e1757 = bitcast<f32>((bitcast<u32>(_e1630.z) & 2147483647u));
                                                                            let _e1763 = bitcast<f32>((bitcast<u32>(_e1628.x) & 2147483647u));
                                                                            let _e1766 = bitcast<f32>((bitcast<u32>(_e1628.y) & 2147483647u));
                                                                            let _e1768 = select(_e1766, _e1763, (_e1763 > _e1766));
                                                                            let _e1771 = bitcast<f32>((bitcast<u32>(_e1628.z) & 2147483647u));
                                                                            let _e1775 = (bitcast<f32>((bitcast<u32>(_e1673) & 2147483647u)) > ((0.0000038146973f * select(_e1757, _e1754, (_e1754 > _e1757))) * select(_e1771, _e1768, (_e1768 > _e1771))));
                                                                            if _e1775 {
                                                                                phi_2607_ = (_e1668 / _e1673);
                                                                            } else {
                                                                                phi_2607_ = f32();
                                                                            }
                                                                            let _e1778 = phi_2607_;
                                                                            phi_2609_ = _e1778;
                                                                            phi_2610_ = select(true, false, _e1775);
                                                                        } else {
                                                                            phi_2609_ = f32();
                                                                            phi_2610_ = true;
                                                                        }
                                                                        let _e1781 = phi_2609_;
                                                                        let _e1783 = phi_2610_;
                                                                        if _e1783 {
                                                                            let _e1791 = (((_e1639 * (_e1700 - (_e497 * _e1703))) + (_e1644 * (_e1701 - (_e563 * _e1703)))) / _e1673);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1791) & 2147483647u)) <= _e1605) {
                                                                                phi_2630_ = (_e1703 + _e1791);
                                                                            } else {
                                                                                phi_2630_ = _e1703;
                                                                            }
                                                                            let _e1798 = phi_2630_;
                                                                            phi_2631_ = _e1798;
                                                                        } else {
                                                                            phi_2631_ = _e1781;
                                                                        }
                                                                        let _e1800 = phi_2631_;
                                                                        let _e1802 = select(_e1538, _e1800, (_e1800 < _e1538));
                                                                        let _e1804 = select(_e1530, _e1802, (_e1802 > _e1530));
                                                                        if (_e1804 >= _e743) {
                                                                            let _e1806 = (_e1804 <= _e1197.member_1);
                                                                            if _e1806 {
                                                                                let _e1807 = (1f / _e1457);
                                                                                phi_2654_ = type_22(_e1804, (_e1451 * _e1807), (_e1455 * _e1807), _e1225);
                                                                            } else {
                                                                                phi_2654_ = type_22();
                                                                            }
                                                                            let _e1812 = phi_2654_;
                                                                            phi_2656_ = _e1812;
                                                                            phi_2657_ = select(true, false, _e1806);
                                                                        } else {
                                                                            phi_2656_ = type_22();
                                                                            phi_2657_ = true;
                                                                        }
                                                                        let _e1815 = phi_2656_;
                                                                        let _e1817 = phi_2657_;
                                                                        if _e1817 {
                                                                            phi_2661_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2661_ = _e1815;
                                                                        }
                                                                        let _e1819 = phi_2661_;
                                                                        phi_2662_ = _e1819;
                                                                    }
                                                                    let _e1821 = phi_2662_;
                                                                    phi_2663_ = _e1821;
                                                                    phi_2664_ = _e1547;
                                                                }
                                                                let _e1823 = phi_2663_;
                                                                let _e1825 = phi_2664_;
                                                                phi_2668_ = _e1823;
                                                                phi_2669_ = _e1825;
                                                            }
                                                            let _e1827 = phi_2668_;
                                                            let _e1829 = phi_2669_;
                                                            phi_2670_ = _e1827;
                                                            phi_2671_ = _e1482;
                                                            phi_2672_ = _e1829;
                                                        }
                                                        let _e1831 = phi_2670_;
                                                        let _e1833 = phi_2671_;
                                                        let _e1835 = phi_2672_;
                                                        phi_2673_ = _e1831;
                                                        phi_2674_ = _e1833;
                                                        phi_2675_ = _e1835;
                                                    }
                                                    let _e1837 = phi_2673_;
                                                    let _e1839 = phi_2674_;
                                                    let _e1841 = phi_2675_;
                                                    phi_2683_ = _e1837;
                                                    phi_2684_ = select(_e1841, true, _e1839);
                                                } else {
                                                    phi_2683_ = type_22();
                                                    phi_2684_ = true;
                                                }
                                                let _e1844 = phi_2683_;
                                                let _e1846 = phi_2684_;
                                                if _e1846 {
                                                    phi_2688_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2688_ = _e1844;
                                                }
                                                let _e1848 = phi_2688_;
                                                if (_e1848.member_3 != 4294967295u) {
                                                    if (_e1225 == _e156) {
                                                        phi_3011_ = false;
                                                    } else {
                                                        let _e1852 = (_e1225 < arrayLength((&global_4.member)));
                                                        if _e1852 {
                                                            if _e1852 {
                                                            } else {
                                                                phi_4337_ = true;
                                                                break;
                                                            }
                                                            let _e1854 = global_4.member[_e1225];
                                                            phi_2711_ = _e1854;
                                                        } else {
                                                            phi_2711_ = 4294967295u;
                                                        }
                                                        let _e1856 = phi_2711_;
                                                        let _e1857 = (_e1856 < arrayLength((&global_5.member)));
                                                        if _e1857 {
                                                            if _e1857 {
                                                            } else {
                                                                phi_4337_ = true;
                                                                break;
                                                            }
                                                            let _e1859 = global_5.member[_e1856];
                                                            phi_2725_ = _e1859;
                                                        } else {
                                                            phi_2725_ = 0i;
                                                        }
                                                        let _e1861 = phi_2725_;
                                                        let _e1862 = (_e1861 == 0i);
                                                        if _e1862 {
                                                            phi_3010_ = true;
                                                        } else {
                                                            if _e434 {
                                                                phi_2744_ = vec3<f32>(_e1261, _e1283, _e1305);
                                                            } else {
                                                                if (_e410 == 1u) {
                                                                    phi_2743_ = vec3<f32>(_e1305, _e1261, _e1283);
                                                                } else {
                                                                    phi_2743_ = vec3<f32>(_e1283, _e1305, _e1261);
                                                                }
                                                                let _e1867 = phi_2743_;
                                                                phi_2744_ = _e1867;
                                                            }
                                                            let _e1870 = phi_2744_;
                                                            if _e434 {
                                                                phi_2759_ = vec3<f32>(_e1321, _e1336, _e1351);
                                                            } else {
                                                                if (_e410 == 1u) {
                                                                    phi_2758_ = vec3<f32>(_e1351, _e1321, _e1336);
                                                                } else {
                                                                    phi_2758_ = vec3<f32>(_e1336, _e1351, _e1321);
                                                                }
                                                                let _e1875 = phi_2758_;
                                                                phi_2759_ = _e1875;
                                                            }
                                                            let _e1878 = phi_2759_;
                                                            if _e434 {
                                                                phi_2774_ = vec3<f32>(_e1367, _e1382, _e1397);
                                                            } else {
                                                                if (_e410 == 1u) {
                                                                    phi_2773_ = vec3<f32>(_e1397, _e1367, _e1382);
                                                                } else {
                                                                    phi_2773_ = vec3<f32>(_e1382, _e1397, _e1367);
                                                                }
                                                                let _e1883 = phi_2773_;
                                                                phi_2774_ = _e1883;
                                                            }
                                                            let _e1886 = phi_2774_;
                                                            let _e1889 = (_e1878.x - _e1870.x);
                                                            let _e1892 = (_e1878.y - _e1870.y);
                                                            let _e1895 = (_e1878.z - _e1870.z);
                                                            let _e1897 = (_e1886.x - _e1870.x);
                                                            let _e1899 = (_e1886.y - _e1870.y);
                                                            let _e1901 = (_e1886.z - _e1870.z);
                                                            if (_e288.member_1 == 1u) {
                                                                phi_2810_ = (vec3<f32>(_e288.member[0], _e288.member[1], _e288.member[2]) - _e1870);
                                                            } else {
                                                                phi_2810_ = vec3<f32>(_e288.member[0], _e288.member[1], _e288.member[2]);
                                                            }
                                                            let _e1916 = phi_2810_;
                                                            let _e1922 = bitcast<f32>((bitcast<u32>((_e1889 * _e1899)) ^ _e288.member_3[0]));
                                                            let _e1926 = bitcast<f32>((bitcast<u32>((_e1892 * _e1897)) ^ _e288.member_3[0]));
                                                            let _e1930 = bitcast<f32>((bitcast<u32>((_e1892 * _e1901)) ^ _e288.member_3[0]));
                                                            let _e1934 = bitcast<f32>((bitcast<u32>((_e1895 * _e1899)) ^ _e288.member_3[0]));
                                                            let _e1938 = bitcast<f32>((bitcast<u32>((_e1895 * _e1897)) ^ _e288.member_3[0]));
                                                            let _e1942 = bitcast<f32>((bitcast<u32>((_e1889 * _e1901)) ^ _e288.member_3[0]));
                                                            let _e1943 = (_e1930 - _e1934);
                                                            let _e1944 = (_e1938 - _e1942);
                                                            let _e1945 = (_e1922 - _e1926);
                                                            let _e1969 = (bitcast<f32>((bitcast<u32>(_e1930) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1934) & 2147483647u)));
                                                            let _e1976 = (bitcast<f32>((bitcast<u32>(_e1938) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1942) & 2147483647u)));
                                                            let _e1983 = (bitcast<f32>((bitcast<u32>(_e1922) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1926) & 2147483647u)));
                                                            if (_e288.member_2 == 0f) {
                                                                phi_2992_ = 0f;
                                                            } else {
                                                                let _e2013 = bitcast<f32>((bitcast<u32>(_e1943) & 2147483647u));
                                                                let _e2016 = bitcast<f32>((bitcast<u32>(_e1944) & 2147483647u));
                                                                let _e2019 = bitcast<f32>((bitcast<u32>(_e1945) & 2147483647u));
                                                                let _e2021 = select(_e2019, _e2016, (_e2016 > _e2019));
                                                                let _e2025 = select(_e2019, _e2016, (_e2016 < _e2019));
                                                                let _e2029 = select(_e2016, _e2013, (_e2013 < _e2016));
                                                                let _e2031 = select(_e2016, _e2013, (_e2013 > _e2016));
                                                                let _e2033 = select(_e2019, _e2031, (_e2031 < _e2019));
                                                                phi_2992_ = bitcast<f32>((bitcast<u32>((_e288.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2021, _e2013, (_e2013 > _e2021)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2033, _e2029, (_e2029 > _e2033)))) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2025, _e2013, (_e2013 < _e2025)))) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1969 + _e1976) + _e1983))) ^ _e288.member_3[0]))) * 1.0000005f)) ^ _e288.member_3[0])))) ^ _e288.member_3[0]));
                                                            }
                                                            let _e2060 = phi_2992_;
                                                            phi_3010_ = (_e1862 || !(((((bitcast<f32>((bitcast<u32>((_e1916.x * _e1943)) ^ _e288.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1916.y * _e1944)) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1916.z * _e1945)) ^ _e288.member_3[0]))) * f32(-(_e1861))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1916.x) & 2147483647u)) * _e1969)) ^ _e288.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1916.y) & 2147483647u)) * _e1976)) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1916.z) & 2147483647u)) * _e1983)) ^ _e288.member_3[0]))))) ^ _e288.member_3[0])) + _e2060) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2074 = phi_3010_;
                                                        phi_3011_ = _e2074;
                                                    }
                                                    let _e2076 = phi_3011_;
                                                    if _e2076 {
                                                        if (_e1848.member < _e1197.member.member) {
                                                            phi_3031_ = true;
                                                        } else {
                                                            if (_e1848.member == _e1197.member.member) {
                                                                phi_3030_ = (_e1848.member_3 < _e1197.member.member_3);
                                                            } else {
                                                                phi_3030_ = false;
                                                            }
                                                            let _e2086 = phi_3030_;
                                                            phi_3031_ = _e2086;
                                                        }
                                                        let _e2088 = phi_3031_;
                                                        if _e2088 {
                                                            phi_3037_ = type_38(_e1848, _e1848.member);
                                                        } else {
                                                            phi_3037_ = _e1197;
                                                        }
                                                        let _e2091 = phi_3037_;
                                                        phi_3038_ = _e2091;
                                                    } else {
                                                        phi_3038_ = _e1197;
                                                    }
                                                    let _e2093 = phi_3038_;
                                                    phi_3039_ = _e2093;
                                                } else {
                                                    phi_3039_ = _e1197;
                                                }
                                                let _e2095 = phi_3039_;
                                                phi_1461_ = _e2095;
                                            } else {
                                                phi_1461_ = type_38();
                                            }
                                            let _e2097 = phi_1461_;
                                            continue;
                                            continuing {
                                                phi_1460_ = _e2097;
                                                phi_1463_ = _e1212;
                                                phi_4337_ = _e775;
                                                break if !(_e1218);
                                            }
                                        }
                                        let _e2100 = phi_4337_;
                                        phi_4547_ = _e2100;
                                        if _e2100 {
                                            break;
                                        }
                                        phi_4551_ = _e2100;
                                        let _e2426 = local_11;
                                        phi_4052_ = _e2426;
                                        phi_4053_ = false;
                                        phi_4054_ = _e818;
                                        phi_4055_ = _e820;
                                    } else {
                                        let _e830 = (_e820.member_1 < _e96);
                                        if _e830 {
                                            if _e830 {
                                            } else {
                                                phi_4547_ = true;
                                                break;
                                            }
                                            let _e832 = global_9.member[_e820.member_1];
                                            phi_3065_ = _e832;
                                        } else {
                                            phi_3065_ = type_48(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e834 = phi_3065_;
                                        let _e849 = ((10u * _e410) & 31u);
                                        let _e852 = ((_e834.member[0] >> bitcast<u32>(_e849)) & 1023u);
                                        let _e860 = bitcast<f32>((bitcast<u32>(((_e820.member.member_1[0] - _e820.member.member[0]) * 0.0009775171f)) ^ _e139));
                                        let _e865 = (_e820.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e852)) - 8388608f) * _e860)) ^ _e139)));
                                        let _e869 = select(select(_e820.member.member_1[0], _e865, (_e865 < _e820.member.member_1[0])), _e820.member.member_1[0], (_e852 == 1023u));
                                        let _e871 = ((10u * _e409) & 31u);
                                        let _e874 = ((_e834.member[0] >> bitcast<u32>(_e871)) & 1023u);
                                        let _e882 = bitcast<f32>((bitcast<u32>(((_e820.member.member_1[1] - _e820.member.member[1]) * 0.0009775171f)) ^ _e139));
                                        let _e887 = (_e820.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e874)) - 8388608f) * _e882)) ^ _e139)));
                                        let _e891 = select(select(_e820.member.member_1[1], _e887, (_e887 < _e820.member.member_1[1])), _e820.member.member_1[1], (_e874 == 1023u));
                                        let _e893 = ((10u * _e411) & 31u);
                                        let _e896 = ((_e834.member[0] >> bitcast<u32>(_e893)) & 1023u);
                                        let _e904 = bitcast<f32>((bitcast<u32>(((_e820.member.member_1[2] - _e820.member.member[2]) * 0.0009775171f)) ^ _e139));
                                        let _e909 = (_e820.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e896)) - 8388608f) * _e904)) ^ _e139)));
                                        let _e913 = select(select(_e820.member.member_1[2], _e909, (_e909 < _e820.member.member_1[2])), _e820.member.member_1[2], (_e896 == 1023u));
                                        let _e916 = ((_e834.member[1] >> bitcast<u32>(_e849)) & 1023u);
                                        let _e924 = (_e820.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e916)) - 8388608f) * _e860)) ^ _e139)));
                                        let _e928 = select(select(_e820.member.member_1[0], _e924, (_e924 < _e820.member.member_1[0])), _e820.member.member_1[0], (_e916 == 1023u));
                                        let _e931 = ((_e834.member[1] >> bitcast<u32>(_e871)) & 1023u);
                                        let _e939 = (_e820.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e931)) - 8388608f) * _e882)) ^ _e139)));
                                        let _e943 = select(select(_e820.member.member_1[1], _e939, (_e939 < _e820.member.member_1[1])), _e820.member.member_1[1], (_e931 == 1023u));
                                        let _e946 = ((_e834.member[1] >> bitcast<u32>(_e893)) & 1023u);
                                        let _e954 = (_e820.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e946)) - 8388608f) * _e904)) ^ _e139)));
                                        let _e958 = select(select(_e820.member.member_1[2], _e954, (_e954 < _e820.member.member_1[2])), _e820.member.member_1[2], (_e946 == 1023u));
                                        let _e964 = ((_e834.member_1[0] >> bitcast<u32>(_e849)) & 1023u);
                                        let _e972 = (_e820.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e964)) - 8388608f) * _e860)) ^ _e139)));
                                        let _e976 = select(select(_e820.member.member_1[0], _e972, (_e972 < _e820.member.member_1[0])), _e820.member.member_1[0], (_e964 == 1023u));
                                        let _e979 = ((_e834.member_1[0] >> bitcast<u32>(_e871)) & 1023u);
                                        let _e987 = (_e820.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e979)) - 8388608f) * _e882)) ^ _e139)));
                                        let _e991 = select(select(_e820.member.member_1[1], _e987, (_e987 < _e820.member.member_1[1])), _e820.member.member_1[1], (_e979 == 1023u));
                                        let _e994 = ((_e834.member_1[0] >> bitcast<u32>(_e893)) & 1023u);
                                        let _e1002 = (_e820.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e994)) - 8388608f) * _e904)) ^ _e139)));
                                        let _e1006 = select(select(_e820.member.member_1[2], _e1002, (_e1002 < _e820.member.member_1[2])), _e820.member.member_1[2], (_e994 == 1023u));
                                        let _e1009 = ((_e834.member_1[1] >> bitcast<u32>(_e849)) & 1023u);
                                        let _e1017 = (_e820.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1009)) - 8388608f) * _e860)) ^ _e139)));
                                        let _e1021 = select(select(_e820.member.member_1[0], _e1017, (_e1017 < _e820.member.member_1[0])), _e820.member.member_1[0], (_e1009 == 1023u));
                                        let _e1024 = ((_e834.member_1[1] >> bitcast<u32>(_e871)) & 1023u);
                                        let _e1032 = (_e820.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1024)) - 8388608f) * _e882)) ^ _e139)));
                                        let _e1036 = select(select(_e820.member.member_1[1], _e1032, (_e1032 < _e820.member.member_1[1])), _e820.member.member_1[1], (_e1024 == 1023u));
                                        let _e1039 = ((_e834.member_1[1] >> bitcast<u32>(_e893)) & 1023u);
                                        let _e1047 = (_e820.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1039)) - 8388608f) * _e904)) ^ _e139)));
                                        let _e1051 = select(select(_e820.member.member_1[2], _e1047, (_e1047 < _e820.member.member_1[2])), _e820.member.member_1[2], (_e1039 == 1023u));
                                        let _e1056 = type_61(type_53(array<f32, 3>(_e869, _e891, _e913), array<f32, 3>(_e928, _e943, _e958)), _e834.member_2);
                                        let _e1061 = type_61(type_53(array<f32, 3>(_e976, _e991, _e1006), array<f32, 3>(_e1021, _e1036, _e1051)), _e834.member_3);
                                        let _e1067 = ((_e869 - _e495) * _e500);
                                        let _e1068 = ((_e976 - _e495) * _e500);
                                        let _e1069 = ((_e928 - _e496) * _e500);
                                        let _e1070 = ((_e1021 - _e496) * _e500);
                                        let _e1075 = ((_e891 - _e561) * _e566);
                                        let _e1076 = ((_e991 - _e561) * _e566);
                                        let _e1077 = ((_e943 - _e562) * _e566);
                                        let _e1078 = ((_e1036 - _e562) * _e566);
                                        let _e1083 = ((_e913 - _e627) * _e632);
                                        let _e1084 = ((_e1006 - _e627) * _e632);
                                        let _e1085 = ((_e958 - _e628) * _e632);
                                        let _e1086 = ((_e1051 - _e628) * _e632);
                                        let _e1088 = select(_e1085, _e1083, (_e1083 < _e1085));
                                        let _e1090 = select(_e1086, _e1084, (_e1084 < _e1086));
                                        let _e1092 = select(_e1085, _e1083, (_e1083 > _e1085));
                                        let _e1094 = select(_e1086, _e1084, (_e1084 > _e1086));
                                        let _e1096 = select(_e1069, _e1067, (_e1067 < _e1069));
                                        let _e1098 = select(_e1070, _e1068, (_e1068 < _e1070));
                                        let _e1100 = select(_e1077, _e1075, (_e1075 < _e1077));
                                        let _e1102 = select(_e1078, _e1076, (_e1076 < _e1078));
                                        let _e1104 = select(_e1100, _e1096, (_e1096 > _e1100));
                                        let _e1106 = select(_e1102, _e1098, (_e1098 > _e1102));
                                        let _e1108 = select(_e1088, _e1104, (_e1104 > _e1088));
                                        let _e1110 = select(_e1090, _e1106, (_e1106 > _e1090));
                                        let _e1112 = select(_e1069, _e1067, (_e1067 > _e1069));
                                        let _e1114 = select(_e1070, _e1068, (_e1068 > _e1070));
                                        let _e1116 = select(_e1077, _e1075, (_e1075 > _e1077));
                                        let _e1118 = select(_e1078, _e1076, (_e1076 > _e1078));
                                        let _e1120 = select(_e1116, _e1112, (_e1112 < _e1116));
                                        let _e1122 = select(_e1118, _e1114, (_e1114 < _e1118));
                                        let _e1127 = -(_e1088);
                                        let _e1128 = -(_e1090);
                                        let _e1135 = (select(_e1092, _e1120, (_e1120 < _e1092)) + (select(_e1127, _e1092, (_e1092 > _e1127)) * 0.0000019073523f));
                                        let _e1136 = (select(_e1094, _e1122, (_e1122 < _e1094)) + (select(_e1128, _e1094, (_e1094 > _e1128)) * 0.0000019073523f));
                                        let _e1138 = select(_e743, _e1108, (_e1108 > _e743));
                                        let _e1140 = select(_e743, _e1110, (_e1110 > _e743));
                                        let _e1145 = (_e1138 <= select(_e777.member_1, _e1135, (_e1135 < _e777.member_1)));
                                        let _e1146 = (_e1140 <= select(_e777.member_1, _e1136, (_e1136 < _e777.member_1)));
                                        let _e1147 = (_e1138 <= _e1140);
                                        if _e1145 {
                                            if _e1146 {
                                                if _e1147 {
                                                    phi_3951_ = _e1061;
                                                } else {
                                                    phi_3951_ = _e1056;
                                                }
                                                let _e1149 = phi_3951_;
                                                let _e1157 = (_e818 % 128u);
                                                let _e1158 = (_e1157 < 128u);
                                                if _e1158 {
                                                } else {
                                                    phi_4547_ = true;
                                                    break;
                                                }
                                                local_6[_e1157] = _e1149.member_1;
                                                if _e1158 {
                                                } else {
                                                    phi_4547_ = true;
                                                    break;
                                                }
                                                local_5[_e1157] = _e1149.member.member[0];
                                                if _e1158 {
                                                } else {
                                                    phi_4547_ = true;
                                                    break;
                                                }
                                                local_4[_e1157] = _e1149.member.member[1];
                                                if _e1158 {
                                                } else {
                                                    phi_4547_ = true;
                                                    break;
                                                }
                                                local_3[_e1157] = _e1149.member.member[2];
                                                if _e1158 {
                                                } else {
                                                    phi_4547_ = true;
                                                    break;
                                                }
                                                local_2[_e1157] = _e1149.member.member_1[0];
                                                if _e1158 {
                                                } else {
                                                    phi_4547_ = true;
                                                    break;
                                                }
                                                local_1[_e1157] = _e1149.member.member_1[1];
                                                if _e1158 {
                                                } else {
                                                    phi_4547_ = true;
                                                    break;
                                                }
                                                local[_e1157] = _e1149.member.member_1[2];
                                                if _e1158 {
                                                } else {
                                                    phi_4547_ = true;
                                                    break;
                                                }
                                                local_7[_e1157] = select(_e1140, _e1138, !(_e1147));
                                                if _e1147 {
                                                    phi_4028_ = _e1056;
                                                } else {
                                                    phi_4028_ = _e1061;
                                                }
                                                let _e1175 = phi_4028_;
                                                phi_4029_ = (_e818 + 1u);
                                                phi_4030_ = _e1175;
                                            } else {
                                                phi_4029_ = u32();
                                                phi_4030_ = type_61();
                                            }
                                            let _e1177 = phi_4029_;
                                            let _e1179 = phi_4030_;
                                            phi_4032_ = _e1177;
                                            phi_4033_ = _e1179;
                                            phi_4034_ = select(true, false, _e1146);
                                        } else {
                                            phi_4032_ = u32();
                                            phi_4033_ = type_61();
                                            phi_4034_ = true;
                                        }
                                        let _e1182 = phi_4032_;
                                        let _e1184 = phi_4033_;
                                        let _e1186 = phi_4034_;
                                        if _e1186 {
                                            if _e1145 {
                                                phi_4041_ = _e1056;
                                            } else {
                                                phi_4041_ = _e1061;
                                            }
                                            let _e1188 = phi_4041_;
                                            phi_4046_ = select(_e1146, true, _e1145);
                                            phi_4048_ = _e1188;
                                        } else {
                                            phi_4046_ = _e816;
                                            phi_4048_ = _e1184;
                                        }
                                        let _e1191 = phi_4046_;
                                        let _e1193 = phi_4048_;
                                        phi_4551_ = _e775;
                                        phi_4052_ = _e777;
                                        phi_4053_ = _e1191;
                                        phi_4054_ = select(_e1182, _e818, _e1186);
                                        phi_4055_ = _e1193;
                                    }
                                    let _e2102 = phi_4551_;
                                    let _e2104 = phi_4052_;
                                    let _e2106 = phi_4053_;
                                    let _e2108 = phi_4054_;
                                    let _e2110 = phi_4055_;
                                    phi_4550_ = _e2102;
                                    phi_4056_ = _e2104;
                                    phi_4057_ = _e2106;
                                    phi_4058_ = (_e781 - 1u);
                                    phi_4059_ = _e2108;
                                    phi_4060_ = _e2110;
                                } else {
                                    phi_4550_ = _e775;
                                    phi_4056_ = _e777;
                                    phi_4057_ = _e816;
                                    phi_4058_ = _e781;
                                    phi_4059_ = _e818;
                                    phi_4060_ = _e820;
                                }
                                let _e2112 = phi_4550_;
                                let _e2114 = phi_4056_;
                                let _e2116 = phi_4057_;
                                let _e2118 = phi_4058_;
                                let _e2120 = phi_4059_;
                                let _e2122 = phi_4060_;
                                phi_4549_ = _e2112;
                                phi_4061_ = _e2114;
                                phi_4062_ = _e2116;
                                phi_4063_ = _e2118;
                                phi_4064_ = _e2120;
                                phi_4065_ = _e2122;
                            } else {
                                phi_4549_ = _e775;
                                phi_4061_ = type_38();
                                phi_4062_ = bool();
                                phi_4063_ = u32();
                                phi_4064_ = u32();
                                phi_4065_ = type_61();
                            }
                            let _e2124 = phi_4549_;
                            let _e2126 = phi_4061_;
                            let _e2128 = phi_4062_;
                            let _e2130 = phi_4063_;
                            let _e2132 = phi_4064_;
                            let _e2134 = phi_4065_;
                            phi_4548_ = _e2124;
                            phi_1334_ = _e2126;
                            phi_1337_ = _e2128;
                            phi_1339_ = _e2130;
                            phi_1341_ = _e2132;
                            phi_1343_ = _e2134;
                            phi_4066_ = _e789;
                        } else {
                            phi_4548_ = _e775;
                            phi_1334_ = type_38();
                            phi_1337_ = bool();
                            phi_1339_ = u32();
                            phi_1341_ = u32();
                            phi_1343_ = type_61();
                            phi_4066_ = false;
                        }
                        let _e2136 = phi_4548_;
                        let _e2138 = phi_1334_;
                        let _e2140 = phi_1337_;
                        let _e2142 = phi_1339_;
                        let _e2144 = phi_1341_;
                        let _e2146 = phi_1343_;
                        let _e2148 = phi_4066_;
                        continue;
                        continuing {
                            phi_4343_ = _e2136;
                            phi_1333_ = _e2138;
                            phi_1336_ = _e2140;
                            phi_1338_ = _e2142;
                            phi_1340_ = _e2144;
                            phi_1342_ = _e2146;
                            phi_4547_ = _e2136;
                            break if !(_e2148);
                        }
                    }
                    let _e2151 = phi_4547_;
                    if _e2151 {
                        break;
                    }
                    let _e2153 = local_10;
                    if (_e2153.member.member_3 != 4294967295u) {
                        let _e2158 = bitcast<u32>(_e2153.member.member);
                        let _e2162 = (bitcast<i32>((_e2158 >> bitcast<u32>(23i))) & 255i);
                        let _e2163 = (_e2162 + _e412);
                        if (_e2162 == 255i) {
                            phi_4125_ = _e2153.member.member;
                        } else {
                            if (_e2162 > 0i) {
                                if (_e2163 > 0i) {
                                    let _e2167 = (_e2163 < 255i);
                                    if _e2167 {
                                        phi_4104_ = bitcast<f32>((_e2158 + bitcast<u32>((_e412 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4104_ = f32();
                                    }
                                    let _e2174 = phi_4104_;
                                    phi_4106_ = _e2174;
                                    phi_4107_ = select(true, false, _e2167);
                                } else {
                                    phi_4106_ = f32();
                                    phi_4107_ = true;
                                }
                                let _e2177 = phi_4106_;
                                let _e2179 = phi_4107_;
                                phi_4108_ = _e2177;
                                phi_4109_ = _e2179;
                            } else {
                                phi_4108_ = f32();
                                phi_4109_ = true;
                            }
                            let _e2181 = phi_4108_;
                            let _e2183 = phi_4109_;
                            if _e2183 {
                                let _e2184 = (_e2158 & 2147483648u);
                                let _e2191 = ((_e2158 & 8388607u) | (select(0u, 1u, ((_e2158 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2195 = (_e2191 == 0u);
                                if _e2195 {
                                    phi_4307_ = bitcast<f32>(_e2184);
                                } else {
                                    let _e2200 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2191)), 32u, _e2195) - 8u);
                                    let _e2203 = (_e2191 << bitcast<u32>((_e2200 & 31u)));
                                    let _e2205 = ((_e2163 + select(0i, 1i, (_e2162 == 0i))) - bitcast<i32>(_e2200));
                                    if (_e2205 >= 255i) {
                                        phi_4297_ = bitcast<f32>((_e2184 | 2139095040u));
                                        phi_4298_ = f32();
                                        phi_4299_ = true;
                                    } else {
                                        let _e2207 = (_e2205 > 0i);
                                        if _e2207 {
                                            phi_4291_ = bitcast<f32>(((_e2184 | (bitcast<u32>(_e2205) << bitcast<u32>(23i))) | (_e2203 & 8388607u)));
                                            phi_4292_ = f32();
                                        } else {
                                            if (_e2205 < -24i) {
                                                phi_4257_ = 26u;
                                            } else {
                                                phi_4257_ = bitcast<u32>((1i - _e2205));
                                            }
                                            let _e2212 = phi_4257_;
                                            let _e2213 = (_e2212 & 31u);
                                            let _e2215 = (_e2203 >> bitcast<u32>(_e2213));
                                            let _e2219 = (_e2203 & ((1u << bitcast<u32>(_e2213)) - 1u));
                                            let _e2223 = (1u << bitcast<u32>(((_e2212 - 1u) & 31u)));
                                            if (_e2219 > _e2223) {
                                                phi_4278_ = true;
                                            } else {
                                                if (_e2219 == _e2223) {
                                                    phi_4275_ = ((_e2215 & 1u) == 1u);
                                                } else {
                                                    phi_4275_ = false;
                                                }
                                                let _e2229 = phi_4275_;
                                                phi_4278_ = _e2229;
                                            }
                                            let _e2231 = phi_4278_;
                                            phi_4291_ = f32();
                                            phi_4292_ = bitcast<f32>((_e2184 | (_e2215 + select(0u, 1u, _e2231))));
                                        }
                                        let _e2244 = phi_4291_;
                                        let _e2246 = phi_4292_;
                                        phi_4297_ = _e2244;
                                        phi_4298_ = _e2246;
                                        phi_4299_ = _e2207;
                                    }
                                    let _e2250 = phi_4297_;
                                    let _e2252 = phi_4298_;
                                    let _e2254 = phi_4299_;
                                    phi_4307_ = select(_e2252, _e2250, _e2254);
                                }
                                let _e2258 = phi_4307_;
                                phi_4124_ = _e2258;
                            } else {
                                phi_4124_ = _e2181;
                            }
                            let _e2260 = phi_4124_;
                            phi_4125_ = _e2260;
                        }
                        let _e2262 = phi_4125_;
                        let _e2263 = bitcast<u32>(_e2262);
                        if ((_e2263 & 2147483647u) >= 2139095040u) {
                            phi_4137_ = bitcast<f32>(((_e2263 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4137_ = _e2262;
                        }
                        let _e2270 = phi_4137_;
                        phi_4142_ = type_22(_e2270, _e2153.member.member_1, _e2153.member.member_2, _e2153.member.member_3);
                    } else {
                        phi_4142_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2275 = phi_4142_;
                    if _e289 {
                    } else {
                        break;
                    }
                    global_7.member[_e143] = _e2275;
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e2279 = select(0u, 1u, (_e356 <= _e366));
                    if (_e2279 > 0u) {
                        let _e2281 = (1u < _e111);
                        if _e2281 {
                            if (0u < _e111) {
                            } else {
                                break;
                            }
                            let _e2285 = atomicAdd((&global_8.member[0u]), _e2279);
                            if ((_e2285 + _e2279) < _e2285) {
                                if _e2281 {
                                } else {
                                    break;
                                }
                                let _e2290 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2293 = select(0u, 1u, (_e2275.member_3 != 4294967295u));
                    if (_e2293 > 0u) {
                        let _e2295 = (3u < _e111);
                        if _e2295 {
                            if (2u < _e111) {
                            } else {
                                break;
                            }
                            let _e2299 = atomicAdd((&global_8.member[2u]), _e2293);
                            if ((_e2299 + _e2293) < _e2299) {
                                if _e2295 {
                                } else {
                                    break;
                                }
                                let _e2304 = atomicAdd((&global_8.member[3u]), 1u);
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
fn trace_paths_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
