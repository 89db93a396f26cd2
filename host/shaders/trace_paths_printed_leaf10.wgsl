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

struct type_40 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<i32>,
}

struct type_49 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_51 {
    member: array<type_49>,
}

struct type_54 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_56 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_58 {
    member: array<type_56>,
}

struct type_62 {
    member: type_54,
    member_1: u32,
}

struct type_67 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_42;
@group(0) @binding(2) 
var<uniform> global_3: type_42;
@group(0) @binding(5) 
var<storage> global_4: type_4;
@group(0) @binding(6) 
var<storage> global_5: type_45;
@group(0) @binding(7) 
var<storage> global_6: type_29;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_24;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_67;
@group(0) @binding(3) 
var<storage> global_9: type_51;
@group(0) @binding(4) 
var<storage> global_10: type_58;

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
    var phi_394_: u32;
    var phi_438_: i32;
    var phi_578_: type_35;
    var phi_684_: i32;
    var phi_685_: i32;
    var phi_695_: bool;
    var phi_705_: u32;
    var phi_706_: u32;
    var phi_708_: bool;
    var phi_713_: u32;
    var phi_746_: i32;
    var phi_764_: f32;
    var phi_770_: f32;
    var phi_810_: f32;
    var phi_816_: f32;
    var phi_889_: f32;
    var phi_895_: f32;
    var phi_935_: f32;
    var phi_941_: f32;
    var phi_1014_: f32;
    var phi_1020_: f32;
    var phi_1060_: f32;
    var phi_1066_: f32;
    var phi_1185_: i32;
    var phi_1207_: u32;
    var phi_1208_: u32;
    var phi_1245_: i32;
    var phi_1267_: u32;
    var phi_1268_: u32;
    var phi_1276_: f32;
    var phi_1277_: f32;
    var phi_4376_: bool;
    var phi_1360_: type_38;
    var phi_1363_: bool;
    var phi_1365_: type_62;
    var phi_1367_: u32;
    var phi_1369_: u32;
    var phi_1380_: bool;
    var phi_1466_: bool;
    var phi_1467_: type_62;
    var phi_1468_: u32;
    var phi_2958_: type_49;
    var phi_3844_: type_62;
    var phi_3920_: type_62;
    var phi_3921_: type_62;
    var phi_3922_: u32;
    var phi_3924_: type_62;
    var phi_3925_: u32;
    var phi_3926_: bool;
    var phi_3933_: type_62;
    var phi_3938_: bool;
    var phi_3939_: type_62;
    var phi_1487_: type_38;
    var phi_1490_: type_8;
    var phi_1491_: type_8;
    var phi_1513_: type_8;
    var phi_1538_: u32;
    var phi_1554_: type_56;
    var phi_2349_: f32;
    var phi_2350_: f32;
    var phi_2351_: f32;
    var phi_2352_: f32;
    var phi_2353_: vec3<f32>;
    var phi_2354_: vec3<f32>;
    var phi_2355_: vec3<f32>;
    var phi_2356_: vec3<f32>;
    var phi_2547_: f32;
    var phi_2567_: type_40;
    var phi_2568_: type_40;
    var phi_2571_: type_40;
    var phi_2572_: type_40;
    var phi_2573_: bool;
    var phi_2577_: type_40;
    var phi_2586_: type_22;
    var phi_2609_: u32;
    var phi_2623_: i32;
    var phi_2641_: vec3<f32>;
    var phi_2642_: vec3<f32>;
    var phi_2656_: vec3<f32>;
    var phi_2657_: vec3<f32>;
    var phi_2671_: vec3<f32>;
    var phi_2672_: vec3<f32>;
    var phi_2708_: vec3<f32>;
    var phi_2890_: f32;
    var phi_2908_: bool;
    var phi_2909_: bool;
    var phi_2928_: bool;
    var phi_2929_: bool;
    var phi_2935_: type_38;
    var phi_2936_: type_38;
    var phi_2937_: type_38;
    var phi_1488_: type_38;
    var phi_4370_: bool;
    var local_10: type_38;
    var phi_4577_: bool;
    var phi_3941_: type_38;
    var phi_3942_: bool;
    var phi_3943_: type_62;
    var phi_3944_: u32;
    var phi_4576_: bool;
    var phi_3945_: type_38;
    var phi_3946_: bool;
    var phi_3947_: type_62;
    var phi_3948_: u32;
    var phi_3949_: u32;
    var phi_4575_: bool;
    var phi_3950_: type_38;
    var phi_3951_: bool;
    var phi_3952_: type_62;
    var phi_3953_: u32;
    var phi_3954_: u32;
    var phi_4574_: bool;
    var phi_1361_: type_38;
    var phi_1364_: bool;
    var phi_1366_: type_62;
    var phi_1368_: u32;
    var phi_1370_: u32;
    var phi_3955_: bool;
    var phi_4573_: bool;
    var local_11: type_38;
    var phi_3993_: f32;
    var phi_3995_: f32;
    var phi_3996_: bool;
    var phi_3997_: f32;
    var phi_3998_: bool;
    var phi_4290_: u32;
    var phi_4308_: bool;
    var phi_4311_: bool;
    var phi_4324_: f32;
    var phi_4325_: f32;
    var phi_4330_: f32;
    var phi_4331_: f32;
    var phi_4332_: bool;
    var phi_4340_: f32;
    var phi_4013_: f32;
    var phi_4014_: f32;
    var phi_4026_: f32;
    var phi_4031_: type_22;
    var local_12: type_38;

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
                phi_394_ = _e154;
            } else {
                phi_394_ = 4294967295u;
            }
            let _e156 = phi_394_;
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
                phi_438_ = -126i;
            } else {
                phi_438_ = select(_e199, 127i, (_e199 > 127i));
            }
            let _e204 = phi_438_;
            let _e209 = bitcast<f32>((bitcast<u32>((_e204 + 127i)) << bitcast<u32>(23i)));
            let _e215 = bitcast<f32>((bitcast<u32>(((_e199 - _e204) + 127i)) << bitcast<u32>(23i)));
            if (_e175 == 0u) {
                phi_578_ = type_35(array<f32, 3>(_e192, _e193, _e194), _e175, _e196, _e197);
            } else {
                let _e217 = bitcast<u32>(_e192);
                let _e219 = ((_e217 & 2139095040u) != 0u);
                let _e234 = bitcast<u32>(_e193);
                let _e236 = ((_e234 & 2139095040u) != 0u);
                let _e251 = bitcast<u32>(_e194);
                let _e253 = ((_e251 & 2139095040u) != 0u);
                let _e269 = bitcast<u32>(_e196);
                let _e271 = ((_e269 & 2139095040u) != 0u);
                phi_578_ = type_35(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e217 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e217 & 2147483648u))), _e192, _e219) * _e209) * select(0.00000011920929f, 1f, _e219)) * _e215), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e234 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e234 & 2147483648u))), _e193, _e236) * _e209) * select(0.00000011920929f, 1f, _e236)) * _e215), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e251 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e251 & 2147483648u))), _e194, _e253) * _e209) * select(0.00000011920929f, 1f, _e253)) * _e215)), _e175, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e269 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e269 & 2147483648u))), _e196, _e271) * _e209) * select(0.00000011920929f, 1f, _e271)) * _e215), _e197);
            }
            let _e288 = phi_578_;
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
                            phi_684_ = (bitcast<i32>((_e375 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_684_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e375)), 32u, (_e375 == 0u))));
                        }
                        let _e389 = phi_684_;
                        phi_685_ = _e389;
                    } else {
                        phi_685_ = 0i;
                    }
                    let _e391 = phi_685_;
                    let _e392 = (_e301 == _e345);
                    if _e392 {
                        phi_695_ = true;
                    } else {
                        phi_695_ = (_e309 == _e345);
                    }
                    let _e395 = phi_695_;
                    let _e396 = select(1u, 0u, _e392);
                    if _e395 {
                        let _e397 = (_e396 + 1u);
                        phi_705_ = _e397;
                        phi_706_ = _e397;
                        phi_708_ = select(true, false, (_e397 == 2u));
                    } else {
                        phi_705_ = u32();
                        phi_706_ = 0u;
                        phi_708_ = true;
                    }
                    let _e401 = phi_705_;
                    let _e403 = phi_706_;
                    let _e405 = phi_708_;
                    if _e405 {
                        phi_713_ = (_e403 + 1u);
                    } else {
                        phi_713_ = 0u;
                    }
                    let _e409 = phi_713_;
                    let _e410 = select(_e401, _e403, _e405);
                    let _e411 = select(_e396, select(2u, _e396, _e395), _e405);
                    let _e412 = -(_e391);
                    if (_e412 < -126i) {
                        phi_746_ = -126i;
                    } else {
                        phi_746_ = select(_e412, 127i, (_e412 > 127i));
                    }
                    let _e417 = phi_746_;
                    let _e422 = bitcast<f32>((bitcast<u32>((_e417 + 127i)) << bitcast<u32>(23i)));
                    let _e428 = bitcast<f32>((bitcast<u32>(((_e412 - _e417) + 127i)) << bitcast<u32>(23i)));
                    let _e433 = global_6.member[_e143].member.member;
                    let _e434 = (_e410 == 0u);
                    if _e434 {
                        phi_764_ = _e433[0];
                    } else {
                        phi_764_ = _e433[1];
                    }
                    let _e438 = phi_764_;
                    let _e439 = (_e410 == 2u);
                    if _e439 {
                        phi_770_ = _e433[2];
                    } else {
                        phi_770_ = _e438;
                    }
                    let _e442 = phi_770_;
                    let _e443 = bitcast<u32>(_e442);
                    let _e445 = ((_e443 & 2139095040u) != 0u);
                    let _e457 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e443 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e443 & 2147483648u))), _e442, _e445) * select(0.00000011920929f, 1f, _e445));
                    let _e458 = global_6.member[_e143].member.member_2;
                    if _e434 {
                        phi_810_ = _e458[0];
                    } else {
                        phi_810_ = _e458[1];
                    }
                    let _e462 = phi_810_;
                    if _e439 {
                        phi_816_ = _e458[2];
                    } else {
                        phi_816_ = _e462;
                    }
                    let _e465 = phi_816_;
                    let _e466 = bitcast<u32>(_e465);
                    let _e468 = ((_e466 & 2139095040u) != 0u);
                    let _e482 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e466 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e466 & 2147483648u))), _e465, _e468) * _e422) * select(0.00000011920929f, 1f, _e468)) * _e428);
                    let _e486 = (bitcast<f32>((bitcast<u32>(_e482) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e489 = bitcast<f32>((bitcast<u32>(_e457) & 2147483647u));
                    let _e490 = (_e489 * 0.00000011920929f);
                    let _e493 = select(select(0.00000000000011368684f, _e490, (_e490 > 0.00000000000011368684f)), 0f, _e486);
                    let _e494 = select(0f, _e482, _e486);
                    let _e495 = (_e457 + _e493);
                    let _e496 = (_e457 - _e493);
                    let _e498 = select(38685626000000000000000000f, (1f / _e482), _e486);
                    let _e499 = (_e409 == 0u);
                    if _e499 {
                        phi_889_ = _e433[0];
                    } else {
                        phi_889_ = _e433[1];
                    }
                    let _e503 = phi_889_;
                    let _e504 = (_e409 == 2u);
                    if _e504 {
                        phi_895_ = _e433[2];
                    } else {
                        phi_895_ = _e503;
                    }
                    let _e507 = phi_895_;
                    let _e508 = bitcast<u32>(_e507);
                    let _e510 = ((_e508 & 2139095040u) != 0u);
                    let _e522 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e508 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e508 & 2147483648u))), _e507, _e510) * select(0.00000011920929f, 1f, _e510));
                    if _e499 {
                        phi_935_ = _e458[0];
                    } else {
                        phi_935_ = _e458[1];
                    }
                    let _e526 = phi_935_;
                    if _e504 {
                        phi_941_ = _e458[2];
                    } else {
                        phi_941_ = _e526;
                    }
                    let _e529 = phi_941_;
                    let _e530 = bitcast<u32>(_e529);
                    let _e532 = ((_e530 & 2139095040u) != 0u);
                    let _e546 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e530 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e530 & 2147483648u))), _e529, _e532) * _e422) * select(0.00000011920929f, 1f, _e532)) * _e428);
                    let _e550 = (bitcast<f32>((bitcast<u32>(_e546) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e553 = bitcast<f32>((bitcast<u32>(_e522) & 2147483647u));
                    let _e554 = (_e553 * 0.00000011920929f);
                    let _e557 = select(select(0.00000000000011368684f, _e554, (_e554 > 0.00000000000011368684f)), 0f, _e550);
                    let _e558 = select(0f, _e546, _e550);
                    let _e559 = (_e522 + _e557);
                    let _e560 = (_e522 - _e557);
                    let _e562 = select(38685626000000000000000000f, (1f / _e546), _e550);
                    let _e563 = (_e411 == 0u);
                    if _e563 {
                        phi_1014_ = _e433[0];
                    } else {
                        phi_1014_ = _e433[1];
                    }
                    let _e567 = phi_1014_;
                    let _e568 = (_e411 == 2u);
                    if _e568 {
                        phi_1020_ = _e433[2];
                    } else {
                        phi_1020_ = _e567;
                    }
                    let _e571 = phi_1020_;
                    let _e572 = bitcast<u32>(_e571);
                    let _e574 = ((_e572 & 2139095040u) != 0u);
                    let _e586 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e572 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e572 & 2147483648u))), _e571, _e574) * select(0.00000011920929f, 1f, _e574));
                    if _e563 {
                        phi_1060_ = _e458[0];
                    } else {
                        phi_1060_ = _e458[1];
                    }
                    let _e590 = phi_1060_;
                    if _e568 {
                        phi_1066_ = _e458[2];
                    } else {
                        phi_1066_ = _e590;
                    }
                    let _e593 = phi_1066_;
                    let _e594 = bitcast<u32>(_e593);
                    let _e596 = ((_e594 & 2139095040u) != 0u);
                    let _e610 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e594 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e594 & 2147483648u))), _e593, _e596) * _e422) * select(0.00000011920929f, 1f, _e596)) * _e428);
                    let _e614 = (bitcast<f32>((bitcast<u32>(_e610) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e617 = bitcast<f32>((bitcast<u32>(_e586) & 2147483647u));
                    let _e618 = (_e617 * 0.00000011920929f);
                    let _e621 = select(select(0.00000000000011368684f, _e618, (_e618 > 0.00000000000011368684f)), 0f, _e614);
                    let _e622 = select(0f, _e610, _e614);
                    let _e623 = (_e586 + _e621);
                    let _e624 = (_e586 - _e621);
                    let _e626 = select(38685626000000000000000000f, (1f / _e610), _e614);
                    let _e628 = select(_e553, _e489, (_e489 > _e553));
                    if (_e372 && (select(_e617, _e628, (_e628 > _e617)) <= 1099511600000f)) {
                        let _e640 = ((_e358 & 8388607u) | (select(0u, 1u, ((_e358 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e643 = bitcast<i32>((_e358 >> bitcast<u32>(23i)));
                        let _e647 = (_e640 == 0u);
                        let _e650 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e640)), 32u, _e647)) - 8i);
                        if (_e643 == 255i) {
                            phi_1185_ = 255i;
                        } else {
                            phi_1185_ = (((_e643 + select(0i, 1i, (_e643 == 0i))) - _e650) + _e391);
                        }
                        let _e658 = phi_1185_;
                        let _e668 = (_e658 <= 0i);
                        if _e668 {
                            phi_1208_ = u32();
                        } else {
                            if _e647 {
                                phi_1207_ = u32();
                            } else {
                                phi_1207_ = select(((bitcast<u32>(_e658) << bitcast<u32>(23i)) | ((_e640 << bitcast<u32>(((_e650 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e658 >= 255i));
                            }
                            let _e672 = phi_1207_;
                            phi_1208_ = _e672;
                        }
                        let _e674 = phi_1208_;
                        let _e686 = ((_e368 & 8388607u) | (select(0u, 1u, ((_e368 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e689 = bitcast<i32>((_e368 >> bitcast<u32>(23i)));
                        let _e693 = (_e686 == 0u);
                        let _e696 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e686)), 32u, _e693)) - 8i);
                        if (_e689 == 255i) {
                            phi_1245_ = 255i;
                        } else {
                            phi_1245_ = (((_e689 + select(0i, 1i, (_e689 == 0i))) - _e696) + _e391);
                        }
                        let _e704 = phi_1245_;
                        let _e714 = (_e704 <= 0i);
                        if _e714 {
                            phi_1268_ = u32();
                        } else {
                            if _e693 {
                                phi_1267_ = u32();
                            } else {
                                phi_1267_ = select(((bitcast<u32>(_e704) << bitcast<u32>(23i)) | ((_e686 << bitcast<u32>(((_e696 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e704 >= 255i));
                            }
                            let _e718 = phi_1267_;
                            phi_1268_ = _e718;
                        }
                        let _e720 = phi_1268_;
                        phi_1276_ = bitcast<f32>(((_e367 & 2147483648u) | select(_e720, 0u, select(_e693, true, _e714))));
                        phi_1277_ = bitcast<f32>(((_e357 & 2147483648u) | select(_e674, 0u, select(_e647, true, _e668))));
                    } else {
                        phi_1276_ = 0f;
                        phi_1277_ = 1f;
                    }
                    let _e726 = phi_1276_;
                    let _e728 = phi_1277_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e115), bitcast<f32>(_e119), bitcast<f32>(_e123));
                    let _e735 = (_e410 % 3u);
                    let _e736 = (_e735 < 3u);
                    if _e736 {
                    } else {
                        break;
                    }
                    let _e738 = local_9[_e735];
                    let _e739 = (_e409 % 3u);
                    let _e740 = (_e739 < 3u);
                    if _e740 {
                    } else {
                        break;
                    }
                    let _e742 = local_9[_e739];
                    let _e743 = (_e411 % 3u);
                    let _e744 = (_e743 < 3u);
                    if _e744 {
                    } else {
                        break;
                    }
                    let _e746 = local_9[_e743];
                    local_8 = array<f32, 3>(bitcast<f32>(_e127), bitcast<f32>(_e131), bitcast<f32>(_e135));
                    if _e736 {
                    } else {
                        break;
                    }
                    let _e750 = local_8[_e735];
                    if _e740 {
                    } else {
                        break;
                    }
                    let _e752 = local_8[_e739];
                    if _e744 {
                    } else {
                        break;
                    }
                    let _e754 = local_8[_e743];
                    phi_4376_ = false;
                    phi_1360_ = type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e726);
                    phi_1363_ = (_e728 <= _e726);
                    phi_1365_ = type_62(type_54(array<f32, 3>(_e738, _e742, _e746), array<f32, 3>(_e750, _e752, _e754)), select(0u, 2147483648u, (_e96 == 0u)));
                    phi_1367_ = 0u;
                    phi_1369_ = ((3u * _e96) + 1u);
                    loop {
                        let _e760 = phi_4376_;
                        let _e762 = phi_1360_;
                        let _e764 = phi_1363_;
                        let _e766 = phi_1365_;
                        let _e768 = phi_1367_;
                        let _e770 = phi_1369_;
                        local_11 = _e762;
                        if _e764 {
                            phi_1380_ = true;
                        } else {
                            phi_1380_ = (_e768 > 0u);
                        }
                        let _e773 = phi_1380_;
                        if _e773 {
                            let _e774 = (_e770 > 0u);
                            if _e774 {
                                if _e764 {
                                    phi_1466_ = _e764;
                                    phi_1467_ = _e766;
                                    phi_1468_ = _e768;
                                } else {
                                    let _e775 = (_e768 - 1u);
                                    let _e776 = (_e775 % 128u);
                                    let _e777 = (_e776 < 128u);
                                    if _e777 {
                                    } else {
                                        phi_4573_ = true;
                                        break;
                                    }
                                    let _e779 = local_6[_e776];
                                    if _e777 {
                                    } else {
                                        phi_4573_ = true;
                                        break;
                                    }
                                    let _e781 = local_5[_e776];
                                    if _e777 {
                                    } else {
                                        phi_4573_ = true;
                                        break;
                                    }
                                    let _e783 = local_4[_e776];
                                    if _e777 {
                                    } else {
                                        phi_4573_ = true;
                                        break;
                                    }
                                    let _e785 = local_3[_e776];
                                    if _e777 {
                                    } else {
                                        phi_4573_ = true;
                                        break;
                                    }
                                    let _e788 = local_2[_e776];
                                    if _e777 {
                                    } else {
                                        phi_4573_ = true;
                                        break;
                                    }
                                    let _e790 = local_1[_e776];
                                    if _e777 {
                                    } else {
                                        phi_4573_ = true;
                                        break;
                                    }
                                    let _e792 = local[_e776];
                                    if _e777 {
                                    } else {
                                        phi_4573_ = true;
                                        break;
                                    }
                                    let _e797 = local_7[_e776];
                                    phi_1466_ = (_e797 <= _e762.member_1);
                                    phi_1467_ = type_62(type_54(array<f32, 3>(_e781, _e783, _e785), array<f32, 3>(_e788, _e790, _e792)), _e779);
                                    phi_1468_ = _e775;
                                }
                                let _e801 = phi_1466_;
                                let _e803 = phi_1467_;
                                let _e805 = phi_1468_;
                                if _e801 {
                                    if ((_e803.member_1 & 2147483648u) != 0u) {
                                        phi_1487_ = _e762;
                                        phi_1490_ = type_8(0u, ((_e803.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1181 = phi_1487_;
                                            let _e1183 = phi_1490_;
                                            local_10 = _e1181;
                                            local_12 = _e1181;
                                            if (_e1183.member < _e1183.member_1) {
                                                phi_1491_ = type_8((_e1183.member + 1u), _e1183.member_1);
                                                phi_1513_ = type_8(1u, _e1183.member);
                                            } else {
                                                phi_1491_ = _e1183;
                                                phi_1513_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1196 = phi_1491_;
                                            let _e1198 = phi_1513_;
                                            let _e1202 = (bitcast<i32>(_e1198.member) != 0i);
                                            if _e1202 {
                                                let _e1203 = ((_e803.member_1 & 268435455u) + _e1198.member_1);
                                                let _e1204 = (_e1203 < arrayLength((&global_10.member)));
                                                if _e1204 {
                                                    if _e1204 {
                                                    } else {
                                                        phi_4370_ = true;
                                                        break;
                                                    }
                                                    let _e1207 = global_10.member[_e1203].member_1;
                                                    phi_1538_ = _e1207;
                                                } else {
                                                    phi_1538_ = 4294967295u;
                                                }
                                                let _e1209 = phi_1538_;
                                                if _e1204 {
                                                    if _e1204 {
                                                    } else {
                                                        phi_4370_ = true;
                                                        break;
                                                    }
                                                    let _e1211 = global_10.member[_e1203];
                                                    phi_1554_ = _e1211;
                                                } else {
                                                    phi_1554_ = type_56(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e1213 = phi_1554_;
                                                let _e1225 = ((10u * _e410) & 31u);
                                                let _e1228 = ((_e1213.member[0] >> bitcast<u32>(_e1225)) & 1023u);
                                                let _e1236 = bitcast<f32>((bitcast<u32>(((_e803.member.member_1[0] - _e803.member.member[0]) * 0.0009775171f)) ^ _e139));
                                                let _e1241 = (_e803.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1228)) - 8388608f) * _e1236)) ^ _e139)));
                                                let _e1245 = select(select(_e803.member.member_1[0], _e1241, (_e1241 < _e803.member.member_1[0])), _e803.member.member_1[0], (_e1228 == 1023u));
                                                let _e1247 = ((10u * _e409) & 31u);
                                                let _e1250 = ((_e1213.member[0] >> bitcast<u32>(_e1247)) & 1023u);
                                                let _e1258 = bitcast<f32>((bitcast<u32>(((_e803.member.member_1[1] - _e803.member.member[1]) * 0.0009775171f)) ^ _e139));
                                                let _e1263 = (_e803.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1250)) - 8388608f) * _e1258)) ^ _e139)));
                                                let _e1267 = select(select(_e803.member.member_1[1], _e1263, (_e1263 < _e803.member.member_1[1])), _e803.member.member_1[1], (_e1250 == 1023u));
                                                let _e1269 = ((10u * _e411) & 31u);
                                                let _e1272 = ((_e1213.member[0] >> bitcast<u32>(_e1269)) & 1023u);
                                                let _e1280 = bitcast<f32>((bitcast<u32>(((_e803.member.member_1[2] - _e803.member.member[2]) * 0.0009775171f)) ^ _e139));
                                                let _e1285 = (_e803.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1272)) - 8388608f) * _e1280)) ^ _e139)));
                                                let _e1289 = select(select(_e803.member.member_1[2], _e1285, (_e1285 < _e803.member.member_1[2])), _e803.member.member_1[2], (_e1272 == 1023u));
                                                let _e1293 = ((_e1213.member[1] >> bitcast<u32>(_e1225)) & 1023u);
                                                let _e1301 = (_e803.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1293)) - 8388608f) * _e1236)) ^ _e139)));
                                                let _e1305 = select(select(_e803.member.member_1[0], _e1301, (_e1301 < _e803.member.member_1[0])), _e803.member.member_1[0], (_e1293 == 1023u));
                                                let _e1308 = ((_e1213.member[1] >> bitcast<u32>(_e1247)) & 1023u);
                                                let _e1316 = (_e803.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1308)) - 8388608f) * _e1258)) ^ _e139)));
                                                let _e1320 = select(select(_e803.member.member_1[1], _e1316, (_e1316 < _e803.member.member_1[1])), _e803.member.member_1[1], (_e1308 == 1023u));
                                                let _e1323 = ((_e1213.member[1] >> bitcast<u32>(_e1269)) & 1023u);
                                                let _e1331 = (_e803.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1323)) - 8388608f) * _e1280)) ^ _e139)));
                                                let _e1335 = select(select(_e803.member.member_1[2], _e1331, (_e1331 < _e803.member.member_1[2])), _e803.member.member_1[2], (_e1323 == 1023u));
                                                let _e1339 = ((_e1213.member[2] >> bitcast<u32>(_e1225)) & 1023u);
                                                let _e1347 = (_e803.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1339)) - 8388608f) * _e1236)) ^ _e139)));
                                                let _e1351 = select(select(_e803.member.member_1[0], _e1347, (_e1347 < _e803.member.member_1[0])), _e803.member.member_1[0], (_e1339 == 1023u));
                                                let _e1354 = ((_e1213.member[2] >> bitcast<u32>(_e1247)) & 1023u);
                                                let _e1362 = (_e803.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1354)) - 8388608f) * _e1258)) ^ _e139)));
                                                let _e1366 = select(select(_e803.member.member_1[1], _e1362, (_e1362 < _e803.member.member_1[1])), _e803.member.member_1[1], (_e1354 == 1023u));
                                                let _e1369 = ((_e1213.member[2] >> bitcast<u32>(_e1269)) & 1023u);
                                                let _e1377 = (_e803.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1369)) - 8388608f) * _e1280)) ^ _e139)));
                                                let _e1381 = select(select(_e803.member.member_1[2], _e1377, (_e1377 < _e803.member.member_1[2])), _e803.member.member_1[2], (_e1369 == 1023u));
                                                let _e1385 = (_e1289 - _e586);
                                                let _e1388 = (((_e1245 - _e457) * _e622) - (_e1385 * _e494));
                                                let _e1391 = (((_e1267 - _e522) * _e622) - (_e1385 * _e558));
                                                let _e1394 = (_e1335 - _e586);
                                                let _e1397 = (((_e1305 - _e457) * _e622) - (_e1394 * _e494));
                                                let _e1400 = (((_e1320 - _e522) * _e622) - (_e1394 * _e558));
                                                let _e1403 = (_e1381 - _e586);
                                                let _e1406 = (((_e1351 - _e457) * _e622) - (_e1403 * _e494));
                                                let _e1409 = (((_e1366 - _e522) * _e622) - (_e1403 * _e558));
                                                let _e1410 = (_e1406 * _e1400);
                                                let _e1411 = (_e1409 * _e1397);
                                                let _e1412 = (_e1388 * _e1409);
                                                let _e1413 = (_e1391 * _e1406);
                                                let _e1414 = (_e1397 * _e1391);
                                                let _e1415 = (_e1400 * _e1388);
                                                let _e1420 = (((_e1410 >= _e1411) && (_e1412 >= _e1413)) && (_e1414 >= _e1415));
                                                let _e1426 = (_e1420 || (((_e1410 <= _e1411) && (_e1412 <= _e1413)) && (_e1414 <= _e1415)));
                                                if _e1426 {
                                                    let _e1428 = select(-1f, 1f, _e1420);
                                                    let _e1430 = ((_e1410 - _e1411) * _e1428);
                                                    let _e1432 = select(0f, _e1430, (_e1430 > 0f));
                                                    let _e1434 = ((_e1412 - _e1413) * _e1428);
                                                    let _e1436 = select(0f, _e1434, (_e1434 > 0f));
                                                    let _e1438 = ((_e1414 - _e1415) * _e1428);
                                                    let _e1440 = select(0f, _e1438, (_e1438 > 0f));
                                                    let _e1442 = ((_e1432 + _e1436) + _e1440);
                                                    let _e1444 = select(_e1305, _e1245, (_e1245 < _e1305));
                                                    let _e1448 = select(_e1305, _e1245, (_e1245 > _e1305));
                                                    let _e1452 = select(_e1320, _e1267, (_e1267 < _e1320));
                                                    let _e1456 = select(_e1320, _e1267, (_e1267 > _e1320));
                                                    let _e1460 = select(_e1335, _e1289, (_e1289 < _e1335));
                                                    let _e1464 = select(_e1335, _e1289, (_e1289 > _e1335));
                                                    let _e1469 = ((select(_e1351, _e1444, (_e1444 < _e1351)) - _e495) * _e498);
                                                    let _e1470 = ((select(_e1351, _e1448, (_e1448 > _e1351)) - _e496) * _e498);
                                                    let _e1473 = ((select(_e1366, _e1452, (_e1452 < _e1366)) - _e559) * _e562);
                                                    let _e1474 = ((select(_e1366, _e1456, (_e1456 > _e1366)) - _e560) * _e562);
                                                    let _e1477 = ((select(_e1381, _e1460, (_e1460 < _e1381)) - _e623) * _e626);
                                                    let _e1478 = ((select(_e1381, _e1464, (_e1464 > _e1381)) - _e624) * _e626);
                                                    let _e1480 = select(_e1478, _e1477, (_e1477 < _e1478));
                                                    let _e1482 = select(_e1478, _e1477, (_e1477 > _e1478));
                                                    let _e1484 = select(_e1470, _e1469, (_e1469 < _e1470));
                                                    let _e1486 = select(_e1474, _e1473, (_e1473 < _e1474));
                                                    let _e1488 = select(_e1486, _e1484, (_e1484 > _e1486));
                                                    let _e1490 = select(_e1480, _e1488, (_e1488 > _e1480));
                                                    let _e1492 = select(_e1470, _e1469, (_e1469 > _e1470));
                                                    let _e1494 = select(_e1474, _e1473, (_e1473 > _e1474));
                                                    let _e1496 = select(_e1494, _e1492, (_e1492 < _e1494));
                                                    let _e1498 = select(_e1482, _e1496, (_e1496 < _e1482));
                                                    let _e1499 = -(_e1480);
                                                    let _e1505 = select(_e728, _e1490, (_e1490 > _e728));
                                                    let _e1509 = select(_e1397, _e1388, (_e1388 < _e1397));
                                                    let _e1514 = select(_e1397, _e1388, (_e1388 > _e1397));
                                                    let _e1521 = select(_e1400, _e1391, (_e1391 < _e1400));
                                                    let _e1526 = select(_e1400, _e1391, (_e1391 > _e1400));
                                                    let _e1535 = (((((_e1426 && (_e1442 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1406, _e1509, (_e1509 < _e1406)) <= 0f) && (select(_e1406, _e1514, (_e1514 > _e1406)) >= 0f))) && ((select(_e1409, _e1521, (_e1521 < _e1409)) <= 0f) && (select(_e1409, _e1526, (_e1526 > _e1409)) >= 0f))) && (_e1505 <= (_e1498 + (select(_e1499, _e1482, (_e1482 > _e1499)) * 0.0000019073523f)))) && (_e1505 <= _e1181.member_1));
                                                    if _e1535 {
                                                        let _e1540 = (_e1305 - _e1245);
                                                        let _e1541 = (_e1320 - _e1267);
                                                        let _e1542 = (_e1335 - _e1289);
                                                        let _e1543 = vec3<f32>(_e1540, _e1541, _e1542);
                                                        let _e1544 = (_e1351 - _e1305);
                                                        let _e1545 = (_e1366 - _e1320);
                                                        let _e1546 = (_e1381 - _e1335);
                                                        let _e1547 = vec3<f32>(_e1544, _e1545, _e1546);
                                                        let _e1548 = (_e1245 - _e1351);
                                                        let _e1549 = (_e1267 - _e1366);
                                                        let _e1550 = (_e1289 - _e1381);
                                                        let _e1551 = vec3<f32>(_e1548, _e1549, _e1550);
                                                        let _e1554 = bitcast<f32>((bitcast<u32>(_e1540) & 2147483647u));
                                                        let _e1557 = bitcast<f32>((bitcast<u32>(_e1541) & 2147483647u));
                                                        let _e1559 = select(_e1557, _e1554, (_e1554 > _e1557));
                                                        let _e1562 = bitcast<f32>((bitcast<u32>(_e1542) & 2147483647u));
                                                        let _e1564 = select(_e1562, _e1559, (_e1559 > _e1562));
                                                        let _e1567 = bitcast<f32>((bitcast<u32>(_e1544) & 2147483647u));
                                                        let _e1570 = bitcast<f32>((bitcast<u32>(_e1545) & 2147483647u));
                                                        let _e1572 = select(_e1570, _e1567, (_e1567 > _e1570));
                                                        let _e1575 = bitcast<f32>((bitcast<u32>(_e1546) & 2147483647u));
                                                        let _e1577 = select(_e1575, _e1572, (_e1572 > _e1575));
                                                        let _e1580 = bitcast<f32>((bitcast<u32>(_e1548) & 2147483647u));
                                                        let _e1583 = bitcast<f32>((bitcast<u32>(_e1549) & 2147483647u));
                                                        let _e1585 = select(_e1583, _e1580, (_e1580 > _e1583));
                                                        let _e1588 = bitcast<f32>((bitcast<u32>(_e1550) & 2147483647u));
                                                        let _e1590 = select(_e1588, _e1585, (_e1585 > _e1588));
                                                        let _e1592 = select(_e1577, _e1564, (_e1564 > _e1577));
                                                        let _e1594 = select(_e1590, _e1592, (_e1592 > _e1590));
                                                        if (_e1564 == _e1594) {
                                                            phi_2349_ = _e1400;
                                                            phi_2350_ = _e1397;
                                                            phi_2351_ = _e1391;
                                                            phi_2352_ = _e1388;
                                                            phi_2353_ = vec3<f32>(_e1245, _e1267, _e1289);
                                                            phi_2354_ = _e1551;
                                                            phi_2355_ = _e1547;
                                                            phi_2356_ = _e1543;
                                                        } else {
                                                            let _e1596 = (_e1577 == _e1594);
                                                            let _e1601 = vec3(_e1596);
                                                            phi_2349_ = select(_e1391, _e1409, _e1596);
                                                            phi_2350_ = select(_e1388, _e1406, _e1596);
                                                            phi_2351_ = select(_e1409, _e1400, _e1596);
                                                            phi_2352_ = select(_e1406, _e1397, _e1596);
                                                            phi_2353_ = select(vec3<f32>(_e1351, _e1366, _e1381), vec3<f32>(_e1305, _e1320, _e1335), _e1601);
                                                            phi_2354_ = select(_e1547, _e1543, _e1601);
                                                            phi_2355_ = select(_e1543, _e1551, _e1601);
                                                            phi_2356_ = select(_e1551, _e1547, _e1601);
                                                        }
                                                        let _e1607 = phi_2349_;
                                                        let _e1609 = phi_2350_;
                                                        let _e1611 = phi_2351_;
                                                        let _e1613 = phi_2352_;
                                                        let _e1615 = phi_2353_;
                                                        let _e1617 = phi_2354_;
                                                        let _e1619 = phi_2355_;
                                                        let _e1621 = phi_2356_;
                                                        let _e1628 = ((_e1619.y * _e1617.z) - (_e1617.y * _e1619.z));
                                                        let _e1633 = ((_e1619.z * _e1617.x) - (_e1617.z * _e1619.x));
                                                        let _e1636 = ((_e1619.x * _e1617.y) - (_e1617.x * _e1619.y));
                                                        let _e1639 = ((_e1432 >= _e1436) && (_e1432 >= _e1440));
                                                        let _e1640 = (_e1436 >= _e1440);
                                                        let _e1654 = (((_e1628 * (select(select(_e1351, _e1305, _e1640), _e1245, _e1639) - _e457)) + (_e1633 * (select(select(_e1366, _e1320, _e1640), _e1267, _e1639) - _e522))) + (_e1636 * (select(select(_e1381, _e1335, _e1640), _e1289, _e1639) - _e586)));
                                                        let _e1659 = (((_e1628 * _e494) + (_e1633 * _e558)) + (_e1636 * _e622));
                                                        let _e1660 = (_e1609 - _e1613);
                                                        let _e1661 = (_e1607 - _e1611);
                                                        let _e1664 = ((_e1660 * _e1660) + (_e1661 * _e1661));
                                                        let _e1671 = (-(((_e1613 * _e1660) + (_e1611 * _e1661))) / select(0.000000000000000000000000000000000000011754944f, _e1664, (_e1664 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1673 = select(1f, _e1671, (_e1671 < 1f));
                                                        let _e1675 = select(0f, _e1673, (_e1673 > 0f));
                                                        let _e1684 = ((_e1615.x + (_e1621.x * _e1675)) - _e457);
                                                        let _e1687 = ((_e1615.y + (_e1621.y * _e1675)) - _e522);
                                                        let _e1690 = ((_e1615.z + (_e1621.z * _e1675)) - _e586);
                                                        let _e1693 = bitcast<f32>((bitcast<u32>(_e1684) & 2147483647u));
                                                        let _e1696 = bitcast<f32>((bitcast<u32>(_e1687) & 2147483647u));
                                                        let _e1698 = select(_e1696, _e1693, (_e1693 > _e1696));
                                                        let _e1701 = bitcast<f32>((bitcast<u32>(_e1690) & 2147483647u));
                                                        let _e1703 = select(_e1701, _e1698, (_e1698 > _e1701));
                                                        let _e1709 = bitcast<f32>((bitcast<u32>(_e1628) & 2147483647u));
                                                        let _e1712 = bitcast<f32>((bitcast<u32>(_e1633) & 2147483647u));
                                                        let _e1714 = select(_e1712, _e1709, (_e1709 > _e1712));
                                                        let _e1717 = bitcast<f32>((bitcast<u32>(_e1636) & 2147483647u));
                                                        let _e1736 = bitcast<f32>((bitcast<u32>(_e1619.x) & 2147483647u));
                                                        let _e1739 = bitcast<f32>((bitcast<u32>(_e1619.y) & 2147483647u));
                                                        let _e1741 = select(_e1739, _e1736, (_e1736 > _e1739));
                                                        let _e1744 = bitcast<f32>((bitcast<u32>(_e1619.z) & 2147483647u));
                                                        let _e1750 = bitcast<f32>((bitcast<u32>(_e1617.x) & 2147483647u));
                                                        let _e1753 = bitcast<f32>((bitcast<u32>(_e1617.y) & 2147483647u));
                                                        let _e1755 = select(_e1753, _e1750, (_e1750 > _e1753));
                                                        let _e1758 = bitcast<f32>((bitcast<u32>(_e1617.z) & 2147483647u));
                                                        let _e1764 = ((bitcast<f32>((bitcast<u32>(((((_e1628 * _e1684) + (_e1633 * _e1687)) + (_e1636 * _e1690)) - _e1654)) & 2147483647u)) <= ((0.0000009536743f * select(_e1594, _e1703, (_e1703 > _e1594))) * select(_e1717, _e1714, (_e1714 > _e1717)))) && !((bitcast<f32>((bitcast<u32>(_e1659) & 2147483647u)) <= ((0.0000038146973f * select(_e1744, _e1741, (_e1741 > _e1744))) * select(_e1758, _e1755, (_e1755 > _e1758))))));
                                                        let _e1765 = (_e1654 / _e1659);
                                                        if (_e1535 && !(_e1764)) {
                                                            let _e1768 = (_e1690 / _e622);
                                                            let _e1776 = (((_e1628 * (_e1684 - (_e494 * _e1768))) + (_e1633 * (_e1687 - (_e558 * _e1768)))) / _e1659);
                                                            phi_2547_ = select(select(_e1768, (_e1768 + _e1776), (bitcast<f32>((bitcast<u32>(_e1776) & 2147483647u)) <= _e1594)), _e1765, _e1764);
                                                        } else {
                                                            phi_2547_ = _e1765;
                                                        }
                                                        let _e1785 = phi_2547_;
                                                        let _e1787 = select(_e1498, _e1785, (_e1785 < _e1498));
                                                        let _e1789 = select(_e1490, _e1787, (_e1787 > _e1490));
                                                        let _e1790 = (1f / _e1442);
                                                        phi_2567_ = type_40(_e1789, (_e1436 * _e1790), (_e1440 * _e1790), ((_e1535 && (_e1789 >= _e728)) && (_e1789 <= _e1181.member_1)));
                                                        phi_2568_ = type_40();
                                                    } else {
                                                        phi_2567_ = type_40();
                                                        phi_2568_ = type_40(0f, 0f, 0f, _e1535);
                                                    }
                                                    let _e1799 = phi_2567_;
                                                    let _e1801 = phi_2568_;
                                                    phi_2571_ = _e1799;
                                                    phi_2572_ = _e1801;
                                                    phi_2573_ = select(true, false, _e1535);
                                                } else {
                                                    phi_2571_ = type_40();
                                                    phi_2572_ = type_40(0f, 0f, 0f, _e1426);
                                                    phi_2573_ = true;
                                                }
                                                let _e1804 = phi_2571_;
                                                let _e1806 = phi_2572_;
                                                let _e1808 = phi_2573_;
                                                if _e1808 {
                                                    phi_2577_ = _e1806;
                                                } else {
                                                    phi_2577_ = _e1804;
                                                }
                                                let _e1810 = phi_2577_;
                                                if _e1810.member_3 {
                                                    phi_2586_ = type_22(_e1810.member, _e1810.member_1, _e1810.member_2, _e1209);
                                                } else {
                                                    phi_2586_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1817 = phi_2586_;
                                                if (_e1817.member_3 != 4294967295u) {
                                                    if (_e1209 == _e156) {
                                                        phi_2909_ = false;
                                                    } else {
                                                        let _e1821 = (_e1209 < arrayLength((&global_4.member)));
                                                        if _e1821 {
                                                            if _e1821 {
                                                            } else {
                                                                phi_4370_ = true;
                                                                break;
                                                            }
                                                            let _e1823 = global_4.member[_e1209];
                                                            phi_2609_ = _e1823;
                                                        } else {
                                                            phi_2609_ = 4294967295u;
                                                        }
                                                        let _e1825 = phi_2609_;
                                                        let _e1826 = (_e1825 < arrayLength((&global_5.member)));
                                                        if _e1826 {
                                                            if _e1826 {
                                                            } else {
                                                                phi_4370_ = true;
                                                                break;
                                                            }
                                                            let _e1828 = global_5.member[_e1825];
                                                            phi_2623_ = _e1828;
                                                        } else {
                                                            phi_2623_ = 0i;
                                                        }
                                                        let _e1830 = phi_2623_;
                                                        let _e1831 = (_e1830 == 0i);
                                                        if _e1831 {
                                                            phi_2908_ = true;
                                                        } else {
                                                            if _e434 {
                                                                phi_2642_ = vec3<f32>(_e1245, _e1267, _e1289);
                                                            } else {
                                                                if (_e410 == 1u) {
                                                                    phi_2641_ = vec3<f32>(_e1289, _e1245, _e1267);
                                                                } else {
                                                                    phi_2641_ = vec3<f32>(_e1267, _e1289, _e1245);
                                                                }
                                                                let _e1836 = phi_2641_;
                                                                phi_2642_ = _e1836;
                                                            }
                                                            let _e1839 = phi_2642_;
                                                            if _e434 {
                                                                phi_2657_ = vec3<f32>(_e1305, _e1320, _e1335);
                                                            } else {
                                                                if (_e410 == 1u) {
                                                                    phi_2656_ = vec3<f32>(_e1335, _e1305, _e1320);
                                                                } else {
                                                                    phi_2656_ = vec3<f32>(_e1320, _e1335, _e1305);
                                                                }
                                                                let _e1844 = phi_2656_;
                                                                phi_2657_ = _e1844;
                                                            }
                                                            let _e1847 = phi_2657_;
                                                            if _e434 {
                                                                phi_2672_ = vec3<f32>(_e1351, _e1366, _e1381);
                                                            } else {
                                                                if (_e410 == 1u) {
                                                                    phi_2671_ = vec3<f32>(_e1381, _e1351, _e1366);
                                                                } else {
                                                                    phi_2671_ = vec3<f32>(_e1366, _e1381, _e1351);
                                                                }
                                                                let _e1852 = phi_2671_;
                                                                phi_2672_ = _e1852;
                                                            }
                                                            let _e1855 = phi_2672_;
                                                            let _e1858 = (_e1847.x - _e1839.x);
                                                            let _e1861 = (_e1847.y - _e1839.y);
                                                            let _e1864 = (_e1847.z - _e1839.z);
                                                            let _e1866 = (_e1855.x - _e1839.x);
                                                            let _e1868 = (_e1855.y - _e1839.y);
                                                            let _e1870 = (_e1855.z - _e1839.z);
                                                            if (_e288.member_1 == 1u) {
                                                                phi_2708_ = (vec3<f32>(_e288.member[0], _e288.member[1], _e288.member[2]) - _e1839);
                                                            } else {
                                                                phi_2708_ = vec3<f32>(_e288.member[0], _e288.member[1], _e288.member[2]);
                                                            }
                                                            let _e1885 = phi_2708_;
                                                            let _e1891 = bitcast<f32>((bitcast<u32>((_e1858 * _e1868)) ^ _e288.member_3[0]));
                                                            let _e1895 = bitcast<f32>((bitcast<u32>((_e1861 * _e1866)) ^ _e288.member_3[0]));
                                                            let _e1899 = bitcast<f32>((bitcast<u32>((_e1861 * _e1870)) ^ _e288.member_3[0]));
                                                            let _e1903 = bitcast<f32>((bitcast<u32>((_e1864 * _e1868)) ^ _e288.member_3[0]));
                                                            let _e1907 = bitcast<f32>((bitcast<u32>((_e1864 * _e1866)) ^ _e288.member_3[0]));
                                                            let _e1911 = bitcast<f32>((bitcast<u32>((_e1858 * _e1870)) ^ _e288.member_3[0]));
                                                            let _e1912 = (_e1899 - _e1903);
                                                            let _e1913 = (_e1907 - _e1911);
                                                            let _e1914 = (_e1891 - _e1895);
                                                            let _e1938 = (bitcast<f32>((bitcast<u32>(_e1899) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1903) & 2147483647u)));
                                                            let _e1945 = (bitcast<f32>((bitcast<u32>(_e1907) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1911) & 2147483647u)));
                                                            let _e1952 = (bitcast<f32>((bitcast<u32>(_e1891) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1895) & 2147483647u)));
                                                            if (_e288.member_2 == 0f) {
                                                                phi_2890_ = 0f;
                                                            } else {
                                                                let _e1982 = bitcast<f32>((bitcast<u32>(_e1912) & 2147483647u));
                                                                let _e1985 = bitcast<f32>((bitcast<u32>(_e1913) & 2147483647u));
                                                                let _e1988 = bitcast<f32>((bitcast<u32>(_e1914) & 2147483647u));
                                                                let _e1990 = select(_e1988, _e1985, (_e1985 > _e1988));
                                                                let _e1994 = select(_e1988, _e1985, (_e1985 < _e1988));
                                                                let _e1998 = select(_e1985, _e1982, (_e1982 < _e1985));
                                                                let _e2000 = select(_e1985, _e1982, (_e1982 > _e1985));
                                                                let _e2002 = select(_e1988, _e2000, (_e2000 < _e1988));
                                                                phi_2890_ = bitcast<f32>((bitcast<u32>((_e288.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1990, _e1982, (_e1982 > _e1990)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2002, _e1998, (_e1998 > _e2002)))) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1994, _e1982, (_e1982 < _e1994)))) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1938 + _e1945) + _e1952))) ^ _e288.member_3[0]))) * 1.0000005f)) ^ _e288.member_3[0])))) ^ _e288.member_3[0]));
                                                            }
                                                            let _e2029 = phi_2890_;
                                                            phi_2908_ = (_e1831 || !(((((bitcast<f32>((bitcast<u32>((_e1885.x * _e1912)) ^ _e288.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1885.y * _e1913)) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1885.z * _e1914)) ^ _e288.member_3[0]))) * f32(-(_e1830))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1885.x) & 2147483647u)) * _e1938)) ^ _e288.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1885.y) & 2147483647u)) * _e1945)) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1885.z) & 2147483647u)) * _e1952)) ^ _e288.member_3[0]))))) ^ _e288.member_3[0])) + _e2029) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2043 = phi_2908_;
                                                        phi_2909_ = _e2043;
                                                    }
                                                    let _e2045 = phi_2909_;
                                                    if _e2045 {
                                                        if (_e1817.member < _e1181.member.member) {
                                                            phi_2929_ = true;
                                                        } else {
                                                            if (_e1817.member == _e1181.member.member) {
                                                                phi_2928_ = (_e1817.member_3 < _e1181.member.member_3);
                                                            } else {
                                                                phi_2928_ = false;
                                                            }
                                                            let _e2055 = phi_2928_;
                                                            phi_2929_ = _e2055;
                                                        }
                                                        let _e2057 = phi_2929_;
                                                        if _e2057 {
                                                            phi_2935_ = type_38(_e1817, _e1817.member);
                                                        } else {
                                                            phi_2935_ = _e1181;
                                                        }
                                                        let _e2060 = phi_2935_;
                                                        phi_2936_ = _e2060;
                                                    } else {
                                                        phi_2936_ = _e1181;
                                                    }
                                                    let _e2062 = phi_2936_;
                                                    phi_2937_ = _e2062;
                                                } else {
                                                    phi_2937_ = _e1181;
                                                }
                                                let _e2064 = phi_2937_;
                                                phi_1488_ = _e2064;
                                            } else {
                                                phi_1488_ = type_38();
                                            }
                                            let _e2066 = phi_1488_;
                                            continue;
                                            continuing {
                                                phi_1487_ = _e2066;
                                                phi_1490_ = _e1196;
                                                phi_4370_ = _e760;
                                                break if !(_e1202);
                                            }
                                        }
                                        let _e2069 = phi_4370_;
                                        phi_4573_ = _e2069;
                                        if _e2069 {
                                            break;
                                        }
                                        let _e2071 = local_10;
                                        phi_4577_ = _e2069;
                                        let _e2376 = local_12;
                                        phi_3941_ = _e2376;
                                        phi_3942_ = false;
                                        phi_3943_ = _e803;
                                        phi_3944_ = select(_e805, 0u, (_e728 > _e2071.member_1));
                                    } else {
                                        let _e815 = (_e803.member_1 < _e96);
                                        if _e815 {
                                            if _e815 {
                                            } else {
                                                phi_4573_ = true;
                                                break;
                                            }
                                            let _e817 = global_9.member[_e803.member_1];
                                            phi_2958_ = _e817;
                                        } else {
                                            phi_2958_ = type_49(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e819 = phi_2958_;
                                        let _e834 = ((10u * _e410) & 31u);
                                        let _e837 = ((_e819.member[0] >> bitcast<u32>(_e834)) & 1023u);
                                        let _e845 = bitcast<f32>((bitcast<u32>(((_e803.member.member_1[0] - _e803.member.member[0]) * 0.0009775171f)) ^ _e139));
                                        let _e850 = (_e803.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e837)) - 8388608f) * _e845)) ^ _e139)));
                                        let _e854 = select(select(_e803.member.member_1[0], _e850, (_e850 < _e803.member.member_1[0])), _e803.member.member_1[0], (_e837 == 1023u));
                                        let _e856 = ((10u * _e409) & 31u);
                                        let _e859 = ((_e819.member[0] >> bitcast<u32>(_e856)) & 1023u);
                                        let _e867 = bitcast<f32>((bitcast<u32>(((_e803.member.member_1[1] - _e803.member.member[1]) * 0.0009775171f)) ^ _e139));
                                        let _e872 = (_e803.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e859)) - 8388608f) * _e867)) ^ _e139)));
                                        let _e876 = select(select(_e803.member.member_1[1], _e872, (_e872 < _e803.member.member_1[1])), _e803.member.member_1[1], (_e859 == 1023u));
                                        let _e878 = ((10u * _e411) & 31u);
                                        let _e881 = ((_e819.member[0] >> bitcast<u32>(_e878)) & 1023u);
                                        let _e889 = bitcast<f32>((bitcast<u32>(((_e803.member.member_1[2] - _e803.member.member[2]) * 0.0009775171f)) ^ _e139));
                                        let _e894 = (_e803.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e881)) - 8388608f) * _e889)) ^ _e139)));
                                        let _e898 = select(select(_e803.member.member_1[2], _e894, (_e894 < _e803.member.member_1[2])), _e803.member.member_1[2], (_e881 == 1023u));
                                        let _e901 = ((_e819.member[1] >> bitcast<u32>(_e834)) & 1023u);
                                        let _e909 = (_e803.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e901)) - 8388608f) * _e845)) ^ _e139)));
                                        let _e913 = select(select(_e803.member.member_1[0], _e909, (_e909 < _e803.member.member_1[0])), _e803.member.member_1[0], (_e901 == 1023u));
                                        let _e916 = ((_e819.member[1] >> bitcast<u32>(_e856)) & 1023u);
                                        let _e924 = (_e803.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e916)) - 8388608f) * _e867)) ^ _e139)));
                                        let _e928 = select(select(_e803.member.member_1[1], _e924, (_e924 < _e803.member.member_1[1])), _e803.member.member_1[1], (_e916 == 1023u));
                                        let _e931 = ((_e819.member[1] >> bitcast<u32>(_e878)) & 1023u);
                                        let _e939 = (_e803.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e931)) - 8388608f) * _e889)) ^ _e139)));
                                        let _e943 = select(select(_e803.member.member_1[2], _e939, (_e939 < _e803.member.member_1[2])), _e803.member.member_1[2], (_e931 == 1023u));
                                        let _e949 = ((_e819.member_1[0] >> bitcast<u32>(_e834)) & 1023u);
                                        let _e957 = (_e803.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e949)) - 8388608f) * _e845)) ^ _e139)));
                                        let _e961 = select(select(_e803.member.member_1[0], _e957, (_e957 < _e803.member.member_1[0])), _e803.member.member_1[0], (_e949 == 1023u));
                                        let _e964 = ((_e819.member_1[0] >> bitcast<u32>(_e856)) & 1023u);
                                        let _e972 = (_e803.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e964)) - 8388608f) * _e867)) ^ _e139)));
                                        let _e976 = select(select(_e803.member.member_1[1], _e972, (_e972 < _e803.member.member_1[1])), _e803.member.member_1[1], (_e964 == 1023u));
                                        let _e979 = ((_e819.member_1[0] >> bitcast<u32>(_e878)) & 1023u);
                                        let _e987 = (_e803.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e979)) - 8388608f) * _e889)) ^ _e139)));
                                        let _e991 = select(select(_e803.member.member_1[2], _e987, (_e987 < _e803.member.member_1[2])), _e803.member.member_1[2], (_e979 == 1023u));
                                        let _e994 = ((_e819.member_1[1] >> bitcast<u32>(_e834)) & 1023u);
                                        let _e1002 = (_e803.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e994)) - 8388608f) * _e845)) ^ _e139)));
                                        let _e1006 = select(select(_e803.member.member_1[0], _e1002, (_e1002 < _e803.member.member_1[0])), _e803.member.member_1[0], (_e994 == 1023u));
                                        let _e1009 = ((_e819.member_1[1] >> bitcast<u32>(_e856)) & 1023u);
                                        let _e1017 = (_e803.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1009)) - 8388608f) * _e867)) ^ _e139)));
                                        let _e1021 = select(select(_e803.member.member_1[1], _e1017, (_e1017 < _e803.member.member_1[1])), _e803.member.member_1[1], (_e1009 == 1023u));
                                        let _e1024 = ((_e819.member_1[1] >> bitcast<u32>(_e878)) & 1023u);
                                        let _e1032 = (_e803.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1024)) - 8388608f) * _e889)) ^ _e139)));
                                        let _e1036 = select(select(_e803.member.member_1[2], _e1032, (_e1032 < _e803.member.member_1[2])), _e803.member.member_1[2], (_e1024 == 1023u));
                                        let _e1041 = type_62(type_54(array<f32, 3>(_e854, _e876, _e898), array<f32, 3>(_e913, _e928, _e943)), _e819.member_2);
                                        let _e1046 = type_62(type_54(array<f32, 3>(_e961, _e976, _e991), array<f32, 3>(_e1006, _e1021, _e1036)), _e819.member_3);
                                        let _e1052 = ((_e854 - _e495) * _e498);
                                        let _e1053 = ((_e961 - _e495) * _e498);
                                        let _e1054 = ((_e913 - _e496) * _e498);
                                        let _e1055 = ((_e1006 - _e496) * _e498);
                                        let _e1060 = ((_e876 - _e559) * _e562);
                                        let _e1061 = ((_e976 - _e559) * _e562);
                                        let _e1062 = ((_e928 - _e560) * _e562);
                                        let _e1063 = ((_e1021 - _e560) * _e562);
                                        let _e1068 = ((_e898 - _e623) * _e626);
                                        let _e1069 = ((_e991 - _e623) * _e626);
                                        let _e1070 = ((_e943 - _e624) * _e626);
                                        let _e1071 = ((_e1036 - _e624) * _e626);
                                        let _e1073 = select(_e1070, _e1068, (_e1068 < _e1070));
                                        let _e1075 = select(_e1071, _e1069, (_e1069 < _e1071));
                                        let _e1077 = select(_e1070, _e1068, (_e1068 > _e1070));
                                        let _e1079 = select(_e1071, _e1069, (_e1069 > _e1071));
                                        let _e1081 = select(_e1054, _e1052, (_e1052 < _e1054));
                                        let _e1083 = select(_e1055, _e1053, (_e1053 < _e1055));
                                        let _e1085 = select(_e1062, _e1060, (_e1060 < _e1062));
                                        let _e1087 = select(_e1063, _e1061, (_e1061 < _e1063));
                                        let _e1089 = select(_e1085, _e1081, (_e1081 > _e1085));
                                        let _e1091 = select(_e1087, _e1083, (_e1083 > _e1087));
                                        let _e1093 = select(_e1073, _e1089, (_e1089 > _e1073));
                                        let _e1095 = select(_e1075, _e1091, (_e1091 > _e1075));
                                        let _e1097 = select(_e1054, _e1052, (_e1052 > _e1054));
                                        let _e1099 = select(_e1055, _e1053, (_e1053 > _e1055));
                                        let _e1101 = select(_e1062, _e1060, (_e1060 > _e1062));
                                        let _e1103 = select(_e1063, _e1061, (_e1061 > _e1063));
                                        let _e1105 = select(_e1101, _e1097, (_e1097 < _e1101));
                                        let _e1107 = select(_e1103, _e1099, (_e1099 < _e1103));
                                        let _e1112 = -(_e1073);
                                        let _e1113 = -(_e1075);
                                        let _e1120 = (select(_e1077, _e1105, (_e1105 < _e1077)) + (select(_e1112, _e1077, (_e1077 > _e1112)) * 0.0000019073523f));
                                        let _e1121 = (select(_e1079, _e1107, (_e1107 < _e1079)) + (select(_e1113, _e1079, (_e1079 > _e1113)) * 0.0000019073523f));
                                        let _e1123 = select(_e728, _e1093, (_e1093 > _e728));
                                        let _e1125 = select(_e728, _e1095, (_e1095 > _e728));
                                        let _e1130 = (_e1123 <= select(_e762.member_1, _e1120, (_e1120 < _e762.member_1)));
                                        let _e1131 = (_e1125 <= select(_e762.member_1, _e1121, (_e1121 < _e762.member_1)));
                                        let _e1132 = (_e1123 <= _e1125);
                                        if _e1130 {
                                            if _e1131 {
                                                if _e1132 {
                                                    phi_3844_ = _e1046;
                                                } else {
                                                    phi_3844_ = _e1041;
                                                }
                                                let _e1134 = phi_3844_;
                                                let _e1141 = (_e805 % 128u);
                                                let _e1142 = (_e1141 < 128u);
                                                if _e1142 {
                                                } else {
                                                    phi_4573_ = true;
                                                    break;
                                                }
                                                local_6[_e1141] = _e1134.member_1;
                                                if _e1142 {
                                                } else {
                                                    phi_4573_ = true;
                                                    break;
                                                }
                                                local_5[_e1141] = _e1134.member.member[0];
                                                if _e1142 {
                                                } else {
                                                    phi_4573_ = true;
                                                    break;
                                                }
                                                local_4[_e1141] = _e1134.member.member[1];
                                                if _e1142 {
                                                } else {
                                                    phi_4573_ = true;
                                                    break;
                                                }
                                                local_3[_e1141] = _e1134.member.member[2];
                                                if _e1142 {
                                                } else {
                                                    phi_4573_ = true;
                                                    break;
                                                }
                                                local_2[_e1141] = _e1134.member.member_1[0];
                                                if _e1142 {
                                                } else {
                                                    phi_4573_ = true;
                                                    break;
                                                }
                                                local_1[_e1141] = _e1134.member.member_1[1];
                                                if _e1142 {
                                                } else {
                                                    phi_4573_ = true;
                                                    break;
                                                }
                                                local[_e1141] = _e1134.member.member_1[2];
                                                if _e1142 {
                                                } else {
                                                    phi_4573_ = true;
                                                    break;
                                                }
                                                local_7[_e1141] = select(_e1123, _e1125, _e1132);
                                                if _e1132 {
                                                    phi_3920_ = _e1041;
                                                } else {
                                                    phi_3920_ = _e1046;
                                                }
                                                let _e1159 = phi_3920_;
                                                phi_3921_ = _e1159;
                                                phi_3922_ = (_e805 + 1u);
                                            } else {
                                                phi_3921_ = type_62();
                                                phi_3922_ = u32();
                                            }
                                            let _e1161 = phi_3921_;
                                            let _e1163 = phi_3922_;
                                            phi_3924_ = _e1161;
                                            phi_3925_ = _e1163;
                                            phi_3926_ = select(true, false, _e1131);
                                        } else {
                                            phi_3924_ = type_62();
                                            phi_3925_ = u32();
                                            phi_3926_ = true;
                                        }
                                        let _e1166 = phi_3924_;
                                        let _e1168 = phi_3925_;
                                        let _e1170 = phi_3926_;
                                        if _e1170 {
                                            if _e1130 {
                                                phi_3933_ = _e1041;
                                            } else {
                                                phi_3933_ = _e1046;
                                            }
                                            let _e1172 = phi_3933_;
                                            phi_3938_ = select(_e1131, true, _e1130);
                                            phi_3939_ = _e1172;
                                        } else {
                                            phi_3938_ = _e801;
                                            phi_3939_ = _e1166;
                                        }
                                        let _e1175 = phi_3938_;
                                        let _e1177 = phi_3939_;
                                        phi_4577_ = _e760;
                                        phi_3941_ = _e762;
                                        phi_3942_ = _e1175;
                                        phi_3943_ = _e1177;
                                        phi_3944_ = select(_e1168, _e805, _e1170);
                                    }
                                    let _e2076 = phi_4577_;
                                    let _e2078 = phi_3941_;
                                    let _e2080 = phi_3942_;
                                    let _e2082 = phi_3943_;
                                    let _e2084 = phi_3944_;
                                    phi_4576_ = _e2076;
                                    phi_3945_ = _e2078;
                                    phi_3946_ = _e2080;
                                    phi_3947_ = _e2082;
                                    phi_3948_ = _e2084;
                                    phi_3949_ = (_e770 - 1u);
                                } else {
                                    phi_4576_ = _e760;
                                    phi_3945_ = _e762;
                                    phi_3946_ = _e801;
                                    phi_3947_ = _e803;
                                    phi_3948_ = _e805;
                                    phi_3949_ = _e770;
                                }
                                let _e2086 = phi_4576_;
                                let _e2088 = phi_3945_;
                                let _e2090 = phi_3946_;
                                let _e2092 = phi_3947_;
                                let _e2094 = phi_3948_;
                                let _e2096 = phi_3949_;
                                phi_4575_ = _e2086;
                                phi_3950_ = _e2088;
                                phi_3951_ = _e2090;
                                phi_3952_ = _e2092;
                                phi_3953_ = _e2094;
                                phi_3954_ = _e2096;
                            } else {
                                phi_4575_ = _e760;
                                phi_3950_ = type_38();
                                phi_3951_ = bool();
                                phi_3952_ = type_62();
                                phi_3953_ = u32();
                                phi_3954_ = u32();
                            }
                            let _e2098 = phi_4575_;
                            let _e2100 = phi_3950_;
                            let _e2102 = phi_3951_;
                            let _e2104 = phi_3952_;
                            let _e2106 = phi_3953_;
                            let _e2108 = phi_3954_;
                            phi_4574_ = _e2098;
                            phi_1361_ = _e2100;
                            phi_1364_ = _e2102;
                            phi_1366_ = _e2104;
                            phi_1368_ = _e2106;
                            phi_1370_ = _e2108;
                            phi_3955_ = _e774;
                        } else {
                            phi_4574_ = _e760;
                            phi_1361_ = type_38();
                            phi_1364_ = bool();
                            phi_1366_ = type_62();
                            phi_1368_ = u32();
                            phi_1370_ = u32();
                            phi_3955_ = false;
                        }
                        let _e2110 = phi_4574_;
                        let _e2112 = phi_1361_;
                        let _e2114 = phi_1364_;
                        let _e2116 = phi_1366_;
                        let _e2118 = phi_1368_;
                        let _e2120 = phi_1370_;
                        let _e2122 = phi_3955_;
                        continue;
                        continuing {
                            phi_4376_ = _e2110;
                            phi_1360_ = _e2112;
                            phi_1363_ = _e2114;
                            phi_1365_ = _e2116;
                            phi_1367_ = _e2118;
                            phi_1369_ = _e2120;
                            phi_4573_ = _e2110;
                            break if !(_e2122);
                        }
                    }
                    let _e2125 = phi_4573_;
                    if _e2125 {
                        break;
                    }
                    let _e2127 = local_11;
                    if (_e2127.member.member_3 != 4294967295u) {
                        let _e2132 = bitcast<u32>(_e2127.member.member);
                        let _e2136 = (bitcast<i32>((_e2132 >> bitcast<u32>(23i))) & 255i);
                        let _e2137 = (_e2136 + _e412);
                        if (_e2136 == 255i) {
                            phi_4014_ = _e2127.member.member;
                        } else {
                            if (_e2136 > 0i) {
                                if (_e2137 > 0i) {
                                    let _e2141 = (_e2137 < 255i);
                                    if _e2141 {
                                        phi_3993_ = bitcast<f32>((_e2132 + bitcast<u32>((_e412 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3993_ = f32();
                                    }
                                    let _e2148 = phi_3993_;
                                    phi_3995_ = _e2148;
                                    phi_3996_ = select(true, false, _e2141);
                                } else {
                                    phi_3995_ = f32();
                                    phi_3996_ = true;
                                }
                                let _e2151 = phi_3995_;
                                let _e2153 = phi_3996_;
                                phi_3997_ = _e2151;
                                phi_3998_ = _e2153;
                            } else {
                                phi_3997_ = f32();
                                phi_3998_ = true;
                            }
                            let _e2155 = phi_3997_;
                            let _e2157 = phi_3998_;
                            if _e2157 {
                                let _e2158 = (_e2132 & 2147483648u);
                                let _e2165 = ((_e2132 & 8388607u) | (select(0u, 1u, ((_e2132 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2169 = (_e2165 == 0u);
                                if _e2169 {
                                    phi_4340_ = bitcast<f32>(_e2158);
                                } else {
                                    let _e2174 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2165)), 32u, _e2169) - 8u);
                                    let _e2177 = (_e2165 << bitcast<u32>((_e2174 & 31u)));
                                    let _e2179 = ((_e2137 + select(0i, 1i, (_e2136 == 0i))) - bitcast<i32>(_e2174));
                                    if (_e2179 >= 255i) {
                                        phi_4330_ = bitcast<f32>((_e2158 | 2139095040u));
                                        phi_4331_ = f32();
                                        phi_4332_ = true;
                                    } else {
                                        let _e2181 = (_e2179 > 0i);
                                        if _e2181 {
                                            phi_4324_ = bitcast<f32>(((_e2158 | (bitcast<u32>(_e2179) << bitcast<u32>(23i))) | (_e2177 & 8388607u)));
                                            phi_4325_ = f32();
                                        } else {
                                            if (_e2179 < -24i) {
                                                phi_4290_ = 26u;
                                            } else {
                                                phi_4290_ = bitcast<u32>((1i - _e2179));
                                            }
                                            let _e2186 = phi_4290_;
                                            let _e2187 = (_e2186 & 31u);
                                            let _e2189 = (_e2177 >> bitcast<u32>(_e2187));
                                            let _e2193 = (_e2177 & ((1u << bitcast<u32>(_e2187)) - 1u));
                                            let _e2197 = (1u << bitcast<u32>(((_e2186 - 1u) & 31u)));
                                            if (_e2193 > _e2197) {
                                                phi_4311_ = true;
                                            } else {
                                                if (_e2193 == _e2197) {
                                                    phi_4308_ = ((_e2189 & 1u) == 1u);
                                                } else {
                                                    phi_4308_ = false;
                                                }
                                                let _e2203 = phi_4308_;
                                                phi_4311_ = _e2203;
                                            }
                                            let _e2205 = phi_4311_;
                                            phi_4324_ = f32();
                                            phi_4325_ = bitcast<f32>((_e2158 | (_e2189 + select(0u, 1u, _e2205))));
                                        }
                                        let _e2218 = phi_4324_;
                                        let _e2220 = phi_4325_;
                                        phi_4330_ = _e2218;
                                        phi_4331_ = _e2220;
                                        phi_4332_ = _e2181;
                                    }
                                    let _e2224 = phi_4330_;
                                    let _e2226 = phi_4331_;
                                    let _e2228 = phi_4332_;
                                    phi_4340_ = select(_e2226, _e2224, _e2228);
                                }
                                let _e2232 = phi_4340_;
                                phi_4013_ = _e2232;
                            } else {
                                phi_4013_ = _e2155;
                            }
                            let _e2234 = phi_4013_;
                            phi_4014_ = _e2234;
                        }
                        let _e2236 = phi_4014_;
                        let _e2237 = bitcast<u32>(_e2236);
                        if ((_e2237 & 2147483647u) >= 2139095040u) {
                            phi_4026_ = bitcast<f32>(((_e2237 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4026_ = _e2236;
                        }
                        let _e2244 = phi_4026_;
                        phi_4031_ = type_22(_e2244, _e2127.member.member_1, _e2127.member.member_2, _e2127.member.member_3);
                    } else {
                        phi_4031_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2249 = phi_4031_;
                    if _e289 {
                    } else {
                        break;
                    }
                    global_7.member[_e143] = _e2249;
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e2253 = select(0u, 1u, (_e356 <= _e366));
                    if (_e2253 > 0u) {
                        let _e2255 = (1u < _e111);
                        if _e2255 {
                            if (0u < _e111) {
                            } else {
                                break;
                            }
                            let _e2259 = atomicAdd((&global_8.member[0u]), _e2253);
                            if ((_e2259 + _e2253) < _e2259) {
                                if _e2255 {
                                } else {
                                    break;
                                }
                                let _e2264 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2267 = select(0u, 1u, (_e2249.member_3 != 4294967295u));
                    if (_e2267 > 0u) {
                        let _e2269 = (3u < _e111);
                        if _e2269 {
                            if (2u < _e111) {
                            } else {
                                break;
                            }
                            let _e2273 = atomicAdd((&global_8.member[2u]), _e2267);
                            if ((_e2273 + _e2267) < _e2273) {
                                if _e2269 {
                                } else {
                                    break;
                                }
                                let _e2278 = atomicAdd((&global_8.member[3u]), 1u);
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
