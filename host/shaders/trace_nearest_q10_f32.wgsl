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

struct type_36 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_38 {
    member: array<type_26>,
}

struct type_42 {
    member: array<array<type_25, 8>>,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_53 {
    member: type_29,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_53,
    member_2: type_53,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_19;
@group(0) @binding(1) 
var<uniform> global_3: type_48;
@group(0) @binding(2) 
var<storage> global_4: type_9;
@group(0) @binding(4) 
var<storage> global_5: type_38;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_42;

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
    var phi_501_: i32;
    var phi_502_: i32;
    var phi_512_: bool;
    var phi_522_: u32;
    var phi_523_: u32;
    var phi_525_: bool;
    var phi_530_: u32;
    var phi_543_: i32;
    var phi_563_: i32;
    var phi_581_: f32;
    var phi_587_: f32;
    var phi_627_: f32;
    var phi_633_: f32;
    var phi_706_: f32;
    var phi_712_: f32;
    var phi_752_: f32;
    var phi_758_: f32;
    var phi_831_: f32;
    var phi_837_: f32;
    var phi_877_: f32;
    var phi_883_: f32;
    var phi_1002_: i32;
    var phi_1024_: u32;
    var phi_1025_: u32;
    var phi_1062_: i32;
    var phi_1084_: u32;
    var phi_1085_: u32;
    var phi_1093_: f32;
    var phi_1094_: f32;
    var phi_4335_: bool;
    var phi_4315_: f32;
    var phi_1243_: u32;
    var phi_1246_: bool;
    var phi_1248_: u32;
    var phi_1250_: type_53;
    var phi_1261_: bool;
    var phi_1348_: bool;
    var phi_1349_: u32;
    var phi_1350_: type_53;
    var phi_4332_: bool;
    var phi_4320_: f32;
    var phi_1368_: type_4;
    var phi_1369_: type_4;
    var phi_1392_: type_4;
    var phi_1413_: u32;
    var phi_1505_: array<array<f32, 3>, 3>;
    var phi_3871_: bool;
    var phi_3886_: bool;
    var phi_3901_: bool;
    var phi_3916_: bool;
    var phi_3931_: bool;
    var phi_3946_: bool;
    var phi_2048_: f32;
    var phi_2049_: f32;
    var phi_2050_: f32;
    var phi_2051_: f32;
    var phi_2052_: vec3<f32>;
    var phi_2053_: vec3<f32>;
    var phi_2054_: vec3<f32>;
    var phi_2055_: vec3<f32>;
    var phi_3961_: bool;
    var phi_3976_: bool;
    var phi_3991_: bool;
    var phi_4006_: bool;
    var phi_4021_: bool;
    var phi_4036_: bool;
    var phi_2263_: f32;
    var phi_2283_: type_36;
    var phi_2284_: type_36;
    var phi_2287_: type_36;
    var phi_2288_: type_36;
    var phi_2289_: bool;
    var phi_2293_: type_36;
    var phi_2302_: type_25;
    var phi_2314_: type_4;
    var phi_2317_: type_25;
    var phi_2315_: type_4;
    var phi_2340_: type_4;
    var phi_2372_: bool;
    var phi_2373_: bool;
    var phi_2394_: type_25;
    var phi_2318_: type_25;
    var phi_4322_: bool;
    var phi_4641_: f32;
    var phi_4640_: f32;
    var phi_4490_: bool;
    var phi_4639_: f32;
    var phi_4489_: bool;
    var phi_4638_: f32;
    var phi_4488_: bool;
    var phi_4545_: f32;
    var phi_4487_: bool;
    var phi_4729_: bool;
    var phi_4544_: f32;
    var phi_3132_: u32;
    var phi_3133_: u32;
    var phi_3143_: u32;
    var phi_3145_: u32;
    var phi_3146_: bool;
    var phi_3166_: u32;
    var phi_3167_: u32;
    var phi_3171_: type_54;
    var phi_3534_: type_53;
    var phi_3610_: type_53;
    var phi_3611_: u32;
    var phi_3612_: type_53;
    var phi_3614_: u32;
    var phi_3615_: type_53;
    var phi_3616_: bool;
    var phi_3625_: type_53;
    var phi_3630_: bool;
    var phi_3632_: type_53;
    var phi_3636_: bool;
    var phi_3637_: u32;
    var phi_3638_: type_53;
    var phi_3648_: type_53;
    var phi_4757_: f32;
    var phi_4646_: bool;
    var phi_3649_: u32;
    var phi_3650_: bool;
    var phi_3651_: u32;
    var phi_3652_: type_53;
    var phi_4756_: f32;
    var phi_4645_: bool;
    var phi_3653_: u32;
    var phi_3654_: bool;
    var phi_3655_: u32;
    var phi_3656_: type_53;
    var phi_4755_: f32;
    var phi_4644_: bool;
    var phi_1244_: u32;
    var phi_1247_: bool;
    var phi_1249_: u32;
    var phi_1251_: type_53;
    var phi_3657_: bool;
    var phi_4643_: bool;
    var phi_3664_: type_4;
    var phi_3665_: type_4;
    var phi_3688_: type_4;
    var phi_3740_: f32;
    var phi_3742_: f32;
    var phi_3743_: bool;
    var phi_3744_: f32;
    var phi_3745_: bool;
    var phi_4212_: u32;
    var phi_4230_: bool;
    var phi_4233_: bool;
    var phi_4246_: f32;
    var phi_4247_: f32;
    var phi_4252_: f32;
    var phi_4253_: f32;
    var phi_4254_: bool;
    var phi_4262_: f32;
    var phi_3760_: f32;
    var phi_3761_: f32;
    var phi_3773_: f32;
    var phi_3778_: type_25;
    var phi_4737_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e96 = global;
            let _e98 = arrayLength((&global_4.member));
            let _e100 = arrayLength((&global_2.member));
            let _e108 = global_3.member[0u][0u];
            let _e112 = global_3.member[0u][1u];
            let _e116 = global_3.member[0u][2u];
            let _e120 = global_3.member[0u][3u];
            let _e124 = global_3.member[1u][0u];
            let _e128 = global_3.member[1u][1u];
            let _e132 = global_3.member[1u][2u];
            let _e135 = global_1.member[0u];
            let _e136 = bitcast<i32>(_e135);
            let _e148 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e120) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e108), bitcast<i32>(_e112), bitcast<i32>(_e116));
            local = array<i32, 3>(bitcast<i32>(_e124), bitcast<i32>(_e128), bitcast<i32>(_e132));
            let _e154 = (_e96.x + (_e96.y * 2097152u));
            let _e155 = (_e154 < arrayLength((&global_5.member)));
            if _e155 {
                let _e156 = (_e154 < arrayLength((&global_6.member)));
                if _e156 {
                    if _e155 {
                    } else {
                        break;
                    }
                    let _e164 = global_5.member[_e154].member_2[0u];
                    let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                    let _e171 = global_5.member[_e154].member_2[1u];
                    let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                    let _e178 = global_5.member[_e154].member_2[2u];
                    let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                    let _e185 = global_5.member[_e154].member[0u];
                    let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                    let _e192 = global_5.member[_e154].member[1u];
                    let _e194 = (bitcast<u32>(_e192) & 2147483647u);
                    let _e199 = global_5.member[_e154].member[2u];
                    let _e201 = (bitcast<u32>(_e199) & 2147483647u);
                    let _e203 = select(_e173, _e166, (_e173 < _e166));
                    let _e205 = select(_e180, _e203, (_e180 < _e203));
                    let _e207 = select(_e187, _e205, (_e187 < _e205));
                    let _e209 = select(_e194, _e207, (_e194 < _e207));
                    let _e211 = select(_e201, _e209, (_e201 < _e209));
                    let _e215 = global_5.member[_e154].member_1;
                    let _e216 = bitcast<u32>(_e215);
                    let _e217 = (_e216 & 2147483647u);
                    let _e224 = global_5.member[_e154].member_3;
                    let _e225 = bitcast<u32>(_e224);
                    let _e226 = (_e225 & 2147483647u);
                    let _e230 = (((select(_e217, _e211, (_e217 < _e211)) < 2139095040u) && (_e226 <= 2139095040u)) && (_e205 > 0u));
                    if _e230 {
                        let _e233 = (bitcast<u32>(bitcast<f32>(_e205)) & 2147483647u);
                        if (_e233 >= 8388608u) {
                            phi_501_ = (bitcast<i32>((_e233 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_501_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e233)), 32u, (_e233 == 0u))));
                        }
                        let _e247 = phi_501_;
                        phi_502_ = _e247;
                    } else {
                        phi_502_ = 0i;
                    }
                    let _e249 = phi_502_;
                    let _e250 = (_e166 == _e205);
                    if _e250 {
                        phi_512_ = true;
                    } else {
                        phi_512_ = (_e173 == _e205);
                    }
                    let _e253 = phi_512_;
                    let _e254 = select(1u, 0u, _e250);
                    if _e253 {
                        let _e255 = (_e254 + 1u);
                        phi_522_ = _e255;
                        phi_523_ = _e255;
                        phi_525_ = select(true, false, (_e255 == 2u));
                    } else {
                        phi_522_ = u32();
                        phi_523_ = 0u;
                        phi_525_ = true;
                    }
                    let _e259 = phi_522_;
                    let _e261 = phi_523_;
                    let _e263 = phi_525_;
                    if _e263 {
                        phi_530_ = (_e261 + 1u);
                    } else {
                        phi_530_ = 0u;
                    }
                    let _e267 = phi_530_;
                    let _e268 = select(_e259, _e261, _e263);
                    let _e269 = select(_e254, select(2u, _e254, _e253), _e263);
                    if (_e136 < -126i) {
                        phi_543_ = -126i;
                    } else {
                        phi_543_ = select(_e136, 127i, (_e136 > 127i));
                    }
                    let _e274 = phi_543_;
                    let _e279 = bitcast<f32>((bitcast<u32>((_e274 + 127i)) << bitcast<u32>(23i)));
                    let _e285 = bitcast<f32>((bitcast<u32>(((_e136 - _e274) + 127i)) << bitcast<u32>(23i)));
                    let _e286 = -(_e249);
                    if (_e286 < -126i) {
                        phi_563_ = -126i;
                    } else {
                        phi_563_ = select(_e286, 127i, (_e286 > 127i));
                    }
                    let _e291 = phi_563_;
                    let _e296 = bitcast<f32>((bitcast<u32>((_e291 + 127i)) << bitcast<u32>(23i)));
                    let _e302 = bitcast<f32>((bitcast<u32>(((_e286 - _e291) + 127i)) << bitcast<u32>(23i)));
                    let _e306 = global_5.member[_e154].member;
                    let _e307 = (_e268 == 0u);
                    if _e307 {
                        phi_581_ = _e306[0];
                    } else {
                        phi_581_ = _e306[1];
                    }
                    let _e311 = phi_581_;
                    let _e312 = (_e268 == 2u);
                    if _e312 {
                        phi_587_ = _e306[2];
                    } else {
                        phi_587_ = _e311;
                    }
                    let _e315 = phi_587_;
                    let _e316 = bitcast<u32>(_e315);
                    let _e318 = ((_e316 & 2139095040u) != 0u);
                    let _e332 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e316 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e316 & 2147483648u))), _e315, _e318) * _e279) * select(0.00000011920929f, 1f, _e318)) * _e285);
                    let _e333 = global_5.member[_e154].member_2;
                    if _e307 {
                        phi_627_ = _e333[0];
                    } else {
                        phi_627_ = _e333[1];
                    }
                    let _e337 = phi_627_;
                    if _e312 {
                        phi_633_ = _e333[2];
                    } else {
                        phi_633_ = _e337;
                    }
                    let _e340 = phi_633_;
                    let _e341 = bitcast<u32>(_e340);
                    let _e343 = ((_e341 & 2139095040u) != 0u);
                    let _e357 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e341 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e341 & 2147483648u))), _e340, _e343) * _e296) * select(0.00000011920929f, 1f, _e343)) * _e302);
                    let _e361 = (bitcast<f32>((bitcast<u32>(_e357) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e364 = bitcast<f32>((bitcast<u32>(_e332) & 2147483647u));
                    let _e365 = (_e364 * 0.00000011920929f);
                    let _e368 = select(select(0.00000000000011368684f, _e365, (_e365 > 0.00000000000011368684f)), 0f, _e361);
                    let _e369 = select(0f, _e357, _e361);
                    let _e370 = (_e332 + _e368);
                    let _e371 = (_e332 - _e368);
                    let _e373 = select(38685626000000000000000000f, (1f / _e357), _e361);
                    let _e374 = (_e267 == 0u);
                    if _e374 {
                        phi_706_ = _e306[0];
                    } else {
                        phi_706_ = _e306[1];
                    }
                    let _e378 = phi_706_;
                    let _e379 = (_e267 == 2u);
                    if _e379 {
                        phi_712_ = _e306[2];
                    } else {
                        phi_712_ = _e378;
                    }
                    let _e382 = phi_712_;
                    let _e383 = bitcast<u32>(_e382);
                    let _e385 = ((_e383 & 2139095040u) != 0u);
                    let _e399 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e383 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e383 & 2147483648u))), _e382, _e385) * _e279) * select(0.00000011920929f, 1f, _e385)) * _e285);
                    if _e374 {
                        phi_752_ = _e333[0];
                    } else {
                        phi_752_ = _e333[1];
                    }
                    let _e403 = phi_752_;
                    if _e379 {
                        phi_758_ = _e333[2];
                    } else {
                        phi_758_ = _e403;
                    }
                    let _e406 = phi_758_;
                    let _e407 = bitcast<u32>(_e406);
                    let _e409 = ((_e407 & 2139095040u) != 0u);
                    let _e423 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e407 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e407 & 2147483648u))), _e406, _e409) * _e296) * select(0.00000011920929f, 1f, _e409)) * _e302);
                    let _e427 = (bitcast<f32>((bitcast<u32>(_e423) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e430 = bitcast<f32>((bitcast<u32>(_e399) & 2147483647u));
                    let _e431 = (_e430 * 0.00000011920929f);
                    let _e434 = select(select(0.00000000000011368684f, _e431, (_e431 > 0.00000000000011368684f)), 0f, _e427);
                    let _e435 = select(0f, _e423, _e427);
                    let _e436 = (_e399 + _e434);
                    let _e437 = (_e399 - _e434);
                    let _e439 = select(38685626000000000000000000f, (1f / _e423), _e427);
                    let _e440 = (_e269 == 0u);
                    if _e440 {
                        phi_831_ = _e306[0];
                    } else {
                        phi_831_ = _e306[1];
                    }
                    let _e444 = phi_831_;
                    let _e445 = (_e269 == 2u);
                    if _e445 {
                        phi_837_ = _e306[2];
                    } else {
                        phi_837_ = _e444;
                    }
                    let _e448 = phi_837_;
                    let _e449 = bitcast<u32>(_e448);
                    let _e451 = ((_e449 & 2139095040u) != 0u);
                    let _e465 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e449 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e449 & 2147483648u))), _e448, _e451) * _e279) * select(0.00000011920929f, 1f, _e451)) * _e285);
                    if _e440 {
                        phi_877_ = _e333[0];
                    } else {
                        phi_877_ = _e333[1];
                    }
                    let _e469 = phi_877_;
                    if _e445 {
                        phi_883_ = _e333[2];
                    } else {
                        phi_883_ = _e469;
                    }
                    let _e472 = phi_883_;
                    let _e473 = bitcast<u32>(_e472);
                    let _e475 = ((_e473 & 2139095040u) != 0u);
                    let _e489 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e473 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e473 & 2147483648u))), _e472, _e475) * _e296) * select(0.00000011920929f, 1f, _e475)) * _e302);
                    let _e493 = (bitcast<f32>((bitcast<u32>(_e489) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e496 = bitcast<f32>((bitcast<u32>(_e465) & 2147483647u));
                    let _e497 = (_e496 * 0.00000011920929f);
                    let _e500 = select(select(0.00000000000011368684f, _e497, (_e497 > 0.00000000000011368684f)), 0f, _e493);
                    let _e501 = select(0f, _e489, _e493);
                    let _e502 = (_e465 + _e500);
                    let _e503 = (_e465 - _e500);
                    let _e505 = select(38685626000000000000000000f, (1f / _e489), _e493);
                    let _e507 = select(_e430, _e364, (_e364 > _e430));
                    let _e510 = (_e136 + _e249);
                    if (_e230 && (select(_e496, _e507, (_e507 > _e496)) <= 1099511600000f)) {
                        let _e520 = ((_e217 & 8388607u) | (select(0u, 1u, ((_e217 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e523 = bitcast<i32>((_e217 >> bitcast<u32>(23i)));
                        let _e527 = (_e520 == 0u);
                        let _e530 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e520)), 32u, _e527)) - 8i);
                        if (_e523 == 255i) {
                            phi_1002_ = 255i;
                        } else {
                            phi_1002_ = (((_e523 + select(0i, 1i, (_e523 == 0i))) - _e530) + _e510);
                        }
                        let _e538 = phi_1002_;
                        let _e548 = (_e538 <= 0i);
                        if _e548 {
                            phi_1025_ = u32();
                        } else {
                            if _e527 {
                                phi_1024_ = u32();
                            } else {
                                phi_1024_ = select(((bitcast<u32>(_e538) << bitcast<u32>(23i)) | ((_e520 << bitcast<u32>(((_e530 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e538 >= 255i));
                            }
                            let _e552 = phi_1024_;
                            phi_1025_ = _e552;
                        }
                        let _e554 = phi_1025_;
                        let _e566 = ((_e226 & 8388607u) | (select(0u, 1u, ((_e226 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e569 = bitcast<i32>((_e226 >> bitcast<u32>(23i)));
                        let _e573 = (_e566 == 0u);
                        let _e576 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e566)), 32u, _e573)) - 8i);
                        if (_e569 == 255i) {
                            phi_1062_ = 255i;
                        } else {
                            phi_1062_ = (((_e569 + select(0i, 1i, (_e569 == 0i))) - _e576) + _e510);
                        }
                        let _e584 = phi_1062_;
                        let _e594 = (_e584 <= 0i);
                        if _e594 {
                            phi_1085_ = u32();
                        } else {
                            if _e573 {
                                phi_1084_ = u32();
                            } else {
                                phi_1084_ = select(((bitcast<u32>(_e584) << bitcast<u32>(23i)) | ((_e566 << bitcast<u32>(((_e576 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e584 >= 255i));
                            }
                            let _e598 = phi_1084_;
                            phi_1085_ = _e598;
                        }
                        let _e600 = phi_1085_;
                        phi_1093_ = bitcast<f32>(((_e225 & 2147483648u) | select(_e600, 0u, select(_e573, true, _e594))));
                        phi_1094_ = bitcast<f32>(((_e216 & 2147483648u) | select(_e554, 0u, select(_e527, true, _e548))));
                    } else {
                        phi_1093_ = 0f;
                        phi_1094_ = 1f;
                    }
                    let _e606 = phi_1093_;
                    let _e608 = phi_1094_;
                    local_9 = array<type_25, 8>(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e611 = (_e268 % 3u);
                    let _e612 = (_e611 < 3u);
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e614 = local_1[_e611];
                    let _e617 = (_e267 % 3u);
                    let _e618 = (_e617 < 3u);
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e620 = local_1[_e617];
                    let _e623 = (_e269 % 3u);
                    let _e624 = (_e623 < 3u);
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e626 = local_1[_e623];
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e631 = local[_e611];
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e635 = local[_e617];
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e639 = local[_e623];
                    phi_4335_ = false;
                    phi_4315_ = _e606;
                    phi_1243_ = ((3u * _e98) + 1u);
                    phi_1246_ = (_e608 <= _e606);
                    phi_1248_ = 0u;
                    phi_1250_ = type_53(type_29(vec4<f32>((f32(_e614) * _e148), (f32(_e620) * _e148), (f32(_e626) * _e148), 0f), vec4<f32>((f32(_e631) * _e148), (f32(_e635) * _e148), (f32(_e639) * _e148), 0f)), select(0u, 2147483648u, (_e98 == 0u)));
                    loop {
                        let _e649 = phi_4335_;
                        let _e651 = phi_4315_;
                        let _e653 = phi_1243_;
                        let _e655 = phi_1246_;
                        let _e657 = phi_1248_;
                        let _e659 = phi_1250_;
                        if _e655 {
                            phi_1261_ = true;
                        } else {
                            phi_1261_ = (_e657 > 0u);
                        }
                        let _e662 = phi_1261_;
                        if _e662 {
                            let _e663 = (_e653 > 0u);
                            if _e663 {
                                if _e655 {
                                    phi_1348_ = _e655;
                                    phi_1349_ = _e657;
                                    phi_1350_ = _e659;
                                } else {
                                    let _e664 = (_e657 - 1u);
                                    let _e665 = (_e664 % 128u);
                                    let _e666 = (_e665 < 128u);
                                    if _e666 {
                                    } else {
                                        phi_4643_ = true;
                                        break;
                                    }
                                    let _e668 = local_7[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4643_ = true;
                                        break;
                                    }
                                    let _e670 = local_6[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4643_ = true;
                                        break;
                                    }
                                    let _e672 = local_5[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4643_ = true;
                                        break;
                                    }
                                    let _e674 = local_4[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4643_ = true;
                                        break;
                                    }
                                    let _e676 = local_3[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4643_ = true;
                                        break;
                                    }
                                    let _e678 = local_2[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4643_ = true;
                                        break;
                                    }
                                    let _e683 = local_8[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4643_ = true;
                                        break;
                                    }
                                    let _e686 = local_10[_e665];
                                    phi_1348_ = (_e686 <= _e651);
                                    phi_1349_ = _e664;
                                    phi_1350_ = type_53(type_29(vec4<f32>(_e668, _e670, _e672, 0f), vec4<f32>(_e674, _e676, _e678, 0f)), _e683);
                                }
                                let _e689 = phi_1348_;
                                let _e691 = phi_1349_;
                                let _e693 = phi_1350_;
                                if _e689 {
                                    let _e697 = ((_e693.member_1 & 2147483648u) != 0u);
                                    if _e697 {
                                        phi_4332_ = _e649;
                                        phi_4320_ = _e651;
                                        phi_1368_ = type_4(0u, ((_e693.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e704 = phi_4332_;
                                            let _e706 = phi_4320_;
                                            let _e708 = phi_1368_;
                                            if (_e708.member < _e708.member_1) {
                                                phi_1369_ = type_4((_e708.member + 1u), _e708.member_1);
                                                phi_1392_ = type_4(1u, _e708.member);
                                            } else {
                                                phi_1369_ = _e708;
                                                phi_1392_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e721 = phi_1369_;
                                            let _e723 = phi_1392_;
                                            let _e727 = (bitcast<i32>(_e723.member) != 0i);
                                            if _e727 {
                                                let _e728 = ((_e693.member_1 & 268435455u) + _e723.member_1);
                                                let _e729 = (_e728 < _e100);
                                                if _e729 {
                                                    if _e729 {
                                                    } else {
                                                        phi_4545_ = _e706;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e733 = global_2.member[_e728].member_1;
                                                    phi_1413_ = _e733;
                                                } else {
                                                    phi_1413_ = 4294967295u;
                                                }
                                                let _e735 = phi_1413_;
                                                if (_e728 >= _e100) {
                                                    phi_1505_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e729 {
                                                    } else {
                                                        phi_4545_ = _e706;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    if (_e611 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e706;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e742 = global_2.member[_e728].member[_e611];
                                                    if (_e617 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e706;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e748 = global_2.member[_e728].member[_e617];
                                                    if (_e623 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e706;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e754 = global_2.member[_e728].member[_e623];
                                                    let _e756 = (3u + _e611);
                                                    if (_e756 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e706;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e762 = global_2.member[_e728].member[_e756];
                                                    let _e763 = (3u + _e617);
                                                    if (_e763 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e706;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e769 = global_2.member[_e728].member[_e763];
                                                    let _e770 = (3u + _e623);
                                                    if (_e770 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e706;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e776 = global_2.member[_e728].member[_e770];
                                                    let _e778 = (6u + _e611);
                                                    if (_e778 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e706;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e784 = global_2.member[_e728].member[_e778];
                                                    let _e785 = (6u + _e617);
                                                    if (_e785 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e706;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e791 = global_2.member[_e728].member[_e785];
                                                    let _e792 = (6u + _e623);
                                                    if (_e792 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e706;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e798 = global_2.member[_e728].member[_e792];
                                                    phi_1505_ = array<array<f32, 3>, 3>(array<f32, 3>(_e742, _e748, _e754), array<f32, 3>(_e762, _e769, _e776), array<f32, 3>(_e784, _e791, _e798));
                                                }
                                                let _e802 = phi_1505_;
                                                let _e817 = (_e802[0][2] - _e465);
                                                let _e820 = (((_e802[0][0] - _e332) * _e501) - (_e817 * _e369));
                                                let _e823 = (((_e802[0][1] - _e399) * _e501) - (_e817 * _e435));
                                                let _e826 = (_e802[1][2] - _e465);
                                                let _e829 = (((_e802[1][0] - _e332) * _e501) - (_e826 * _e369));
                                                let _e832 = (((_e802[1][1] - _e399) * _e501) - (_e826 * _e435));
                                                let _e835 = (_e802[2][2] - _e465);
                                                let _e838 = (((_e802[2][0] - _e332) * _e501) - (_e835 * _e369));
                                                let _e841 = (((_e802[2][1] - _e399) * _e501) - (_e835 * _e435));
                                                let _e842 = (_e838 * _e832);
                                                let _e843 = (_e841 * _e829);
                                                let _e844 = (_e820 * _e841);
                                                let _e845 = (_e823 * _e838);
                                                let _e846 = (_e829 * _e823);
                                                let _e847 = (_e832 * _e820);
                                                let _e852 = (((_e842 >= _e843) && (_e844 >= _e845)) && (_e846 >= _e847));
                                                let _e858 = (_e852 || (((_e842 <= _e843) && (_e844 <= _e845)) && (_e846 <= _e847)));
                                                if _e858 {
                                                    let _e860 = select(-1f, 1f, _e852);
                                                    let _e862 = ((_e842 - _e843) * _e860);
                                                    let _e864 = select(0f, _e862, (_e862 > 0f));
                                                    let _e866 = ((_e844 - _e845) * _e860);
                                                    let _e868 = select(0f, _e866, (_e866 > 0f));
                                                    let _e870 = ((_e846 - _e847) * _e860);
                                                    let _e872 = select(0f, _e870, (_e870 > 0f));
                                                    let _e874 = ((_e864 + _e868) + _e872);
                                                    let _e876 = select(_e802[1][0], _e802[0][0], (_e802[0][0] < _e802[1][0]));
                                                    let _e880 = select(_e802[1][0], _e802[0][0], (_e802[0][0] > _e802[1][0]));
                                                    let _e884 = select(_e802[1][1], _e802[0][1], (_e802[0][1] < _e802[1][1]));
                                                    let _e888 = select(_e802[1][1], _e802[0][1], (_e802[0][1] > _e802[1][1]));
                                                    let _e892 = select(_e802[1][2], _e802[0][2], (_e802[0][2] < _e802[1][2]));
                                                    let _e896 = select(_e802[1][2], _e802[0][2], (_e802[0][2] > _e802[1][2]));
                                                    let _e901 = ((select(_e802[2][0], _e876, (_e876 < _e802[2][0])) - _e370) * _e373);
                                                    let _e902 = ((select(_e802[2][0], _e880, (_e880 > _e802[2][0])) - _e371) * _e373);
                                                    let _e905 = ((select(_e802[2][1], _e884, (_e884 < _e802[2][1])) - _e436) * _e439);
                                                    let _e906 = ((select(_e802[2][1], _e888, (_e888 > _e802[2][1])) - _e437) * _e439);
                                                    let _e909 = ((select(_e802[2][2], _e892, (_e892 < _e802[2][2])) - _e502) * _e505);
                                                    let _e910 = ((select(_e802[2][2], _e896, (_e896 > _e802[2][2])) - _e503) * _e505);
                                                    let _e912 = select(_e910, _e909, (_e909 < _e910));
                                                    let _e914 = select(_e910, _e909, (_e909 > _e910));
                                                    let _e916 = select(_e902, _e901, (_e901 < _e902));
                                                    let _e918 = select(_e906, _e905, (_e905 < _e906));
                                                    let _e920 = select(_e918, _e916, (_e916 > _e918));
                                                    let _e922 = select(_e912, _e920, (_e920 > _e912));
                                                    let _e924 = select(_e902, _e901, (_e901 > _e902));
                                                    let _e926 = select(_e906, _e905, (_e905 > _e906));
                                                    let _e928 = select(_e926, _e924, (_e924 < _e926));
                                                    let _e930 = select(_e914, _e928, (_e928 < _e914));
                                                    let _e931 = -(_e912);
                                                    let _e937 = select(_e608, _e922, (_e922 > _e608));
                                                    let _e941 = select(_e829, _e820, (_e820 < _e829));
                                                    let _e946 = select(_e829, _e820, (_e820 > _e829));
                                                    let _e953 = select(_e832, _e823, (_e823 < _e832));
                                                    let _e958 = select(_e832, _e823, (_e823 > _e832));
                                                    let _e967 = (((((_e858 && (_e874 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e838, _e941, (_e941 < _e838)) <= 0f) && (select(_e838, _e946, (_e946 > _e838)) >= 0f))) && ((select(_e841, _e953, (_e953 < _e841)) <= 0f) && (select(_e841, _e958, (_e958 > _e841)) >= 0f))) && (_e937 <= (_e930 + (select(_e931, _e914, (_e914 > _e931)) * 0.0000019073523f)))) && (_e937 <= _e706));
                                                    if _e967 {
                                                        let _e972 = (_e802[1][0] - _e802[0][0]);
                                                        let _e973 = (_e802[1][1] - _e802[0][1]);
                                                        let _e974 = (_e802[1][2] - _e802[0][2]);
                                                        let _e975 = vec3<f32>(_e972, _e973, _e974);
                                                        let _e976 = (_e802[2][0] - _e802[1][0]);
                                                        let _e977 = (_e802[2][1] - _e802[1][1]);
                                                        let _e978 = (_e802[2][2] - _e802[1][2]);
                                                        let _e979 = vec3<f32>(_e976, _e977, _e978);
                                                        let _e980 = (_e802[0][0] - _e802[2][0]);
                                                        let _e981 = (_e802[0][1] - _e802[2][1]);
                                                        let _e982 = (_e802[0][2] - _e802[2][2]);
                                                        let _e983 = vec3<f32>(_e980, _e981, _e982);
                                                        let _e984 = abs(_e972);
                                                        let _e985 = abs(_e973);
                                                        if (_e984 != _e984) {
                                                            phi_3871_ = true;
                                                        } else {
                                                            phi_3871_ = (_e985 >= _e984);
                                                        }
                                                        let _e989 = phi_3871_;
                                                        let _e990 = select(_e984, _e985, _e989);
                                                        let _e991 = abs(_e974);
                                                        if (_e990 != _e990) {
                                                            phi_3886_ = true;
                                                        } else {
                                                            phi_3886_ = (_e991 >= _e990);
                                                        }
                                                        let _e995 = phi_3886_;
                                                        let _e996 = select(_e990, _e991, _e995);
                                                        let _e997 = abs(_e976);
                                                        let _e998 = abs(_e977);
                                                        if (_e997 != _e997) {
                                                            phi_3901_ = true;
                                                        } else {
                                                            phi_3901_ = (_e998 >= _e997);
                                                        }
                                                        let _e1002 = phi_3901_;
                                                        let _e1003 = select(_e997, _e998, _e1002);
                                                        let _e1004 = abs(_e978);
                                                        if (_e1003 != _e1003) {
                                                            phi_3916_ = true;
                                                        } else {
                                                            phi_3916_ = (_e1004 >= _e1003);
                                                        }
                                                        let _e1008 = phi_3916_;
                                                        let _e1009 = select(_e1003, _e1004, _e1008);
                                                        let _e1010 = abs(_e980);
                                                        let _e1011 = abs(_e981);
                                                        if (_e1010 != _e1010) {
                                                            phi_3931_ = true;
                                                        } else {
                                                            phi_3931_ = (_e1011 >= _e1010);
                                                        }
                                                        let _e1015 = phi_3931_;
                                                        let _e1016 = select(_e1010, _e1011, _e1015);
                                                        let _e1017 = abs(_e982);
                                                        if (_e1016 != _e1016) {
                                                            phi_3946_ = true;
                                                        } else {
                                                            phi_3946_ = (_e1017 >= _e1016);
                                                        }
                                                        let _e1021 = phi_3946_;
                                                        let _e1022 = select(_e1016, _e1017, _e1021);
                                                        let _e1024 = select(_e1009, _e996, (_e996 > _e1009));
                                                        let _e1026 = select(_e1022, _e1024, (_e1024 > _e1022));
                                                        if (_e996 == _e1026) {
                                                            phi_2048_ = _e832;
                                                            phi_2049_ = _e829;
                                                            phi_2050_ = _e823;
                                                            phi_2051_ = _e820;
                                                            phi_2052_ = vec3<f32>(_e802[0][0], _e802[0][1], _e802[0][2]);
                                                            phi_2053_ = _e983;
                                                            phi_2054_ = _e979;
                                                            phi_2055_ = _e975;
                                                        } else {
                                                            let _e1028 = (_e1009 == _e1026);
                                                            let _e1033 = vec3(_e1028);
                                                            phi_2048_ = select(_e823, _e841, _e1028);
                                                            phi_2049_ = select(_e820, _e838, _e1028);
                                                            phi_2050_ = select(_e841, _e832, _e1028);
                                                            phi_2051_ = select(_e838, _e829, _e1028);
                                                            phi_2052_ = select(vec3<f32>(_e802[2][0], _e802[2][1], _e802[2][2]), vec3<f32>(_e802[1][0], _e802[1][1], _e802[1][2]), _e1033);
                                                            phi_2053_ = select(_e979, _e975, _e1033);
                                                            phi_2054_ = select(_e975, _e983, _e1033);
                                                            phi_2055_ = select(_e983, _e979, _e1033);
                                                        }
                                                        let _e1039 = phi_2048_;
                                                        let _e1041 = phi_2049_;
                                                        let _e1043 = phi_2050_;
                                                        let _e1045 = phi_2051_;
                                                        let _e1047 = phi_2052_;
                                                        let _e1049 = phi_2053_;
                                                        let _e1051 = phi_2054_;
                                                        let _e1053 = phi_2055_;
                                                        let _e1060 = ((_e1051.y * _e1049.z) - (_e1049.y * _e1051.z));
                                                        let _e1065 = ((_e1051.z * _e1049.x) - (_e1049.z * _e1051.x));
                                                        let _e1068 = ((_e1051.x * _e1049.y) - (_e1049.x * _e1051.y));
                                                        let _e1071 = ((_e864 >= _e868) && (_e864 >= _e872));
                                                        let _e1072 = (_e868 >= _e872);
                                                        let _e1086 = (((_e1060 * (select(select(_e802[2][0], _e802[1][0], _e1072), _e802[0][0], _e1071) - _e332)) + (_e1065 * (select(select(_e802[2][1], _e802[1][1], _e1072), _e802[0][1], _e1071) - _e399))) + (_e1068 * (select(select(_e802[2][2], _e802[1][2], _e1072), _e802[0][2], _e1071) - _e465)));
                                                        let _e1091 = (((_e1060 * _e369) + (_e1065 * _e435)) + (_e1068 * _e501));
                                                        let _e1092 = (_e1041 - _e1045);
                                                        let _e1093 = (_e1039 - _e1043);
                                                        let _e1096 = ((_e1092 * _e1092) + (_e1093 * _e1093));
                                                        let _e1103 = (-(((_e1045 * _e1092) + (_e1043 * _e1093))) / select(0.000000000000000000000000000000000000011754944f, _e1096, (_e1096 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1105 = select(1f, _e1103, (_e1103 < 1f));
                                                        let _e1107 = select(0f, _e1105, (_e1105 > 0f));
                                                        let _e1116 = ((_e1047.x + (_e1053.x * _e1107)) - _e332);
                                                        let _e1119 = ((_e1047.y + (_e1053.y * _e1107)) - _e399);
                                                        let _e1122 = ((_e1047.z + (_e1053.z * _e1107)) - _e465);
                                                        let _e1125 = bitcast<f32>((bitcast<u32>(_e1116) & 2147483647u));
                                                        let _e1128 = bitcast<f32>((bitcast<u32>(_e1119) & 2147483647u));
                                                        let _e1130 = select(_e1128, _e1125, (_e1125 > _e1128));
                                                        let _e1133 = bitcast<f32>((bitcast<u32>(_e1122) & 2147483647u));
                                                        let _e1135 = select(_e1133, _e1130, (_e1130 > _e1133));
                                                        let _e1139 = abs(_e1060);
                                                        let _e1140 = abs(_e1065);
                                                        if (_e1139 != _e1139) {
                                                            phi_3961_ = true;
                                                        } else {
                                                            phi_3961_ = (_e1140 >= _e1139);
                                                        }
                                                        let _e1144 = phi_3961_;
                                                        let _e1145 = select(_e1139, _e1140, _e1144);
                                                        let _e1146 = abs(_e1068);
                                                        if (_e1145 != _e1145) {
                                                            phi_3976_ = true;
                                                        } else {
                                                            phi_3976_ = (_e1146 >= _e1145);
                                                        }
                                                        let _e1150 = phi_3976_;
                                                        let _e1166 = abs(_e1051.x);
                                                        let _e1167 = abs(_e1051.y);
                                                        if (_e1166 != _e1166) {
                                                            phi_3991_ = true;
                                                        } else {
                                                            phi_3991_ = (_e1167 >= _e1166);
                                                        }
                                                        let _e1171 = phi_3991_;
                                                        let _e1172 = select(_e1166, _e1167, _e1171);
                                                        let _e1173 = abs(_e1051.z);
                                                        if (_e1172 != _e1172) {
                                                            phi_4006_ = true;
                                                        } else {
                                                            phi_4006_ = (_e1173 >= _e1172);
                                                        }
                                                        let _e1177 = phi_4006_;
                                                        let _e1180 = abs(_e1049.x);
                                                        let _e1181 = abs(_e1049.y);
                                                        if (_e1180 != _e1180) {
                                                            phi_4021_ = true;
                                                        } else {
                                                            phi_4021_ = (_e1181 >= _e1180);
                                                        }
                                                        let _e1185 = phi_4021_;
                                                        let _e1186 = select(_e1180, _e1181, _e1185);
                                                        let _e1187 = abs(_e1049.z);
                                                        if (_e1186 != _e1186) {
                                                            phi_4036_ = true;
                                                        } else {
                                                            phi_4036_ = (_e1187 >= _e1186);
                                                        }
                                                        let _e1191 = phi_4036_;
                                                        let _e1196 = ((bitcast<f32>((bitcast<u32>(((((_e1060 * _e1116) + (_e1065 * _e1119)) + (_e1068 * _e1122)) - _e1086)) & 2147483647u)) <= ((0.0000009536743f * select(_e1026, _e1135, (_e1135 > _e1026))) * select(_e1145, _e1146, _e1150))) && !((bitcast<f32>((bitcast<u32>(_e1091) & 2147483647u)) <= ((0.0000038146973f * select(_e1172, _e1173, _e1177)) * select(_e1186, _e1187, _e1191)))));
                                                        let _e1197 = (_e1086 / _e1091);
                                                        if (_e967 && !(_e1196)) {
                                                            let _e1200 = (_e1122 / _e501);
                                                            let _e1208 = (((_e1060 * (_e1116 - (_e369 * _e1200))) + (_e1065 * (_e1119 - (_e435 * _e1200)))) / _e1091);
                                                            phi_2263_ = select(select(_e1200, (_e1200 + _e1208), (bitcast<f32>((bitcast<u32>(_e1208) & 2147483647u)) <= _e1026)), _e1197, _e1196);
                                                        } else {
                                                            phi_2263_ = _e1197;
                                                        }
                                                        let _e1217 = phi_2263_;
                                                        let _e1219 = select(_e930, _e1217, (_e1217 < _e930));
                                                        let _e1221 = select(_e922, _e1219, (_e1219 > _e922));
                                                        let _e1222 = (1f / _e874);
                                                        phi_2283_ = type_36(_e1221, (_e868 * _e1222), (_e872 * _e1222), ((_e967 && (_e1221 >= _e608)) && (_e1221 <= _e706)));
                                                        phi_2284_ = type_36();
                                                    } else {
                                                        phi_2283_ = type_36();
                                                        phi_2284_ = type_36(0f, 0f, 0f, _e967);
                                                    }
                                                    let _e1231 = phi_2283_;
                                                    let _e1233 = phi_2284_;
                                                    phi_2287_ = _e1231;
                                                    phi_2288_ = _e1233;
                                                    phi_2289_ = select(true, false, _e967);
                                                } else {
                                                    phi_2287_ = type_36();
                                                    phi_2288_ = type_36(0f, 0f, 0f, _e858);
                                                    phi_2289_ = true;
                                                }
                                                let _e1236 = phi_2287_;
                                                let _e1238 = phi_2288_;
                                                let _e1240 = phi_2289_;
                                                if _e1240 {
                                                    phi_2293_ = _e1238;
                                                } else {
                                                    phi_2293_ = _e1236;
                                                }
                                                let _e1242 = phi_2293_;
                                                if _e1242.member_3 {
                                                    phi_2302_ = type_25(_e1242.member, _e1242.member_1, _e1242.member_2, _e735);
                                                } else {
                                                    phi_2302_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1249 = phi_2302_;
                                                if (_e1249.member_3 != 4294967295u) {
                                                    if (_e735 != 4294967295u) {
                                                        phi_2314_ = type_4(0u, 8u);
                                                        phi_2317_ = _e1249;
                                                        loop {
                                                            let _e1254 = phi_2314_;
                                                            let _e1256 = phi_2317_;
                                                            if (_e1254.member < _e1254.member_1) {
                                                                phi_2315_ = type_4((_e1254.member + 1u), _e1254.member_1);
                                                                phi_2340_ = type_4(1u, _e1254.member);
                                                            } else {
                                                                phi_2315_ = _e1254;
                                                                phi_2340_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1269 = phi_2315_;
                                                            let _e1271 = phi_2340_;
                                                            let _e1275 = (bitcast<i32>(_e1271.member) != 0i);
                                                            if _e1275 {
                                                                let _e1276 = (_e1271.member_1 < 8u);
                                                                if _e1276 {
                                                                } else {
                                                                    phi_4322_ = true;
                                                                    break;
                                                                }
                                                                let _e1281 = local_9[_e1271.member_1].member;
                                                                if (_e1256.member < _e1281) {
                                                                    phi_2373_ = true;
                                                                } else {
                                                                    let _e1283 = local_9[_e1271.member_1].member;
                                                                    if (_e1256.member == _e1283) {
                                                                        let _e1288 = local_9[_e1271.member_1].member_3;
                                                                        phi_2372_ = (_e1256.member_3 < _e1288);
                                                                    } else {
                                                                        phi_2372_ = false;
                                                                    }
                                                                    let _e1291 = phi_2372_;
                                                                    phi_2373_ = _e1291;
                                                                }
                                                                let _e1293 = phi_2373_;
                                                                if _e1293 {
                                                                    if _e1276 {
                                                                    } else {
                                                                        phi_4322_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1294 = local_9[_e1271.member_1];
                                                                    local_9[_e1271.member_1] = type_25(_e1256.member, _e1256.member_1, _e1256.member_2, _e1256.member_3);
                                                                    phi_2394_ = type_25(_e1294.member, _e1294.member_1, _e1294.member_2, _e1294.member_3);
                                                                } else {
                                                                    phi_2394_ = _e1256;
                                                                }
                                                                let _e1305 = phi_2394_;
                                                                phi_2318_ = _e1305;
                                                            } else {
                                                                phi_2318_ = type_25();
                                                            }
                                                            let _e1307 = phi_2318_;
                                                            continue;
                                                            continuing {
                                                                phi_2314_ = _e1269;
                                                                phi_2317_ = _e1307;
                                                                phi_4322_ = _e704;
                                                                break if !(_e1275);
                                                            }
                                                        }
                                                        let _e1310 = phi_4322_;
                                                        phi_4545_ = _e706;
                                                        phi_4487_ = _e1310;
                                                        if _e1310 {
                                                            break;
                                                        }
                                                        let _e1313 = local_9[7u].member_3;
                                                        if (_e1313 != 4294967295u) {
                                                            let _e1317 = local_9[7u].member;
                                                            phi_4641_ = _e1317;
                                                        } else {
                                                            phi_4641_ = _e706;
                                                        }
                                                        let _e1319 = phi_4641_;
                                                        phi_4640_ = _e1319;
                                                        phi_4490_ = _e1310;
                                                    } else {
                                                        phi_4640_ = _e706;
                                                        phi_4490_ = _e704;
                                                    }
                                                    let _e1321 = phi_4640_;
                                                    let _e1323 = phi_4490_;
                                                    phi_4639_ = _e1321;
                                                    phi_4489_ = _e1323;
                                                } else {
                                                    phi_4639_ = _e706;
                                                    phi_4489_ = _e704;
                                                }
                                                let _e1325 = phi_4639_;
                                                let _e1327 = phi_4489_;
                                                phi_4638_ = _e1325;
                                                phi_4488_ = _e1327;
                                            } else {
                                                phi_4638_ = _e706;
                                                phi_4488_ = _e704;
                                            }
                                            let _e1329 = phi_4638_;
                                            let _e1331 = phi_4488_;
                                            continue;
                                            continuing {
                                                phi_4332_ = _e1331;
                                                phi_4320_ = _e1329;
                                                phi_1368_ = _e721;
                                                phi_4545_ = _e1329;
                                                phi_4487_ = _e1331;
                                                break if !(_e727);
                                            }
                                        }
                                        let _e1334 = phi_4545_;
                                        let _e1336 = phi_4487_;
                                        phi_4643_ = _e1336;
                                        if _e1336 {
                                            break;
                                        }
                                        phi_4729_ = _e1336;
                                        phi_4544_ = _e1334;
                                    } else {
                                        phi_4729_ = _e649;
                                        phi_4544_ = _e651;
                                    }
                                    let _e1338 = phi_4729_;
                                    let _e1340 = phi_4544_;
                                    if _e697 {
                                        phi_3636_ = bool();
                                        phi_3637_ = u32();
                                        phi_3638_ = type_53();
                                    } else {
                                        if (_e693.member_1 >= _e98) {
                                            phi_3171_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e693.member_1 < _e98) {
                                            } else {
                                                phi_4643_ = true;
                                                break;
                                            }
                                            let _e1344 = ((1u + _e268) % 4u);
                                            if (_e1344 < 4u) {
                                            } else {
                                                phi_4643_ = true;
                                                break;
                                            }
                                            let _e1349 = global_4.member[_e693.member_1][_e1344];
                                            let _e1351 = (_e1349 >> bitcast<u32>(11u));
                                            let _e1353 = ((1u + _e267) % 4u);
                                            if (_e1353 < 4u) {
                                            } else {
                                                phi_4643_ = true;
                                                break;
                                            }
                                            let _e1358 = global_4.member[_e693.member_1][_e1353];
                                            let _e1360 = (_e1358 >> bitcast<u32>(11u));
                                            let _e1362 = ((1u + _e269) % 4u);
                                            if (_e1362 < 4u) {
                                            } else {
                                                phi_4643_ = true;
                                                break;
                                            }
                                            let _e1367 = global_4.member[_e693.member_1][_e1362];
                                            let _e1369 = (_e1367 >> bitcast<u32>(11u));
                                            let _e1392 = (bitcast<f32>((bitcast<u32>((_e693.member.member_1.x - _e693.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1393 = (bitcast<f32>((bitcast<u32>((_e693.member.member_1.y - _e693.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1394 = (bitcast<f32>((bitcast<u32>((_e693.member.member_1.z - _e693.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1396 = select(_e148, _e1392, (_e1392 > _e148));
                                            let _e1398 = select(_e148, _e1393, (_e1393 > _e148));
                                            let _e1400 = select(_e148, _e1394, (_e1394 > _e148));
                                            let _e1431 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1349 & 1023u))) - 8388608f) * _e1396));
                                            let _e1436 = (bitcast<i32>((_e1349 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1439 = bitcast<f32>((_e1431 & bitcast<u32>(_e1436)));
                                            let _e1440 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1358 & 1023u))) - 8388608f) * _e1398));
                                            let _e1445 = (bitcast<i32>((_e1358 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1448 = bitcast<f32>((_e1440 & bitcast<u32>(_e1445)));
                                            let _e1449 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1367 & 1023u))) - 8388608f) * _e1400));
                                            let _e1454 = (bitcast<i32>((_e1367 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1457 = bitcast<f32>((_e1449 & bitcast<u32>(_e1454)));
                                            let _e1461 = bitcast<f32>((_e1431 & bitcast<u32>(~(_e1436))));
                                            let _e1465 = bitcast<f32>((_e1440 & bitcast<u32>(~(_e1445))));
                                            let _e1469 = bitcast<f32>((_e1449 & bitcast<u32>(~(_e1454))));
                                            let _e1470 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1351 & 1023u))) - 8388608f) * _e1396));
                                            let _e1475 = (bitcast<i32>((_e1351 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1478 = bitcast<f32>((_e1470 & bitcast<u32>(_e1475)));
                                            let _e1479 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1360 & 1023u))) - 8388608f) * _e1398));
                                            let _e1484 = (bitcast<i32>((_e1360 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1487 = bitcast<f32>((_e1479 & bitcast<u32>(_e1484)));
                                            let _e1488 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1369 & 1023u))) - 8388608f) * _e1400));
                                            let _e1493 = (bitcast<i32>((_e1369 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1496 = bitcast<f32>((_e1488 & bitcast<u32>(_e1493)));
                                            let _e1500 = bitcast<f32>((_e1470 & bitcast<u32>(~(_e1475))));
                                            let _e1504 = bitcast<f32>((_e1479 & bitcast<u32>(~(_e1484))));
                                            let _e1508 = bitcast<f32>((_e1488 & bitcast<u32>(~(_e1493))));
                                            let _e1538 = global_4.member[_e693.member_1][0u];
                                            let _e1542 = global_4.member[_e693.member_1][1u];
                                            let _e1546 = global_4.member[_e693.member_1][2u];
                                            let _e1550 = global_4.member[_e693.member_1][3u];
                                            let _e1562 = (((_e1542 >> bitcast<u32>(22i)) | ((_e1546 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1550 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1563 = (_e1538 & 268435455u);
                                            let _e1564 = (_e1562 & 268435455u);
                                            let _e1567 = ((_e1538 >> bitcast<u32>(28u)) & 7u);
                                            let _e1575 = ((_e1538 >> bitcast<u32>(31i)) | (((_e1562 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1576 = (_e1567 != 0u);
                                            if (_e1567 == 0u) {
                                                phi_3133_ = _e1563;
                                            } else {
                                                if (_e1567 == 7u) {
                                                    phi_3132_ = 2147483648u;
                                                } else {
                                                    phi_3132_ = ((2147483648u | (_e1567 << bitcast<u32>(28u))) | (_e1564 & 268435455u));
                                                }
                                                let _e1585 = phi_3132_;
                                                phi_3133_ = _e1585;
                                            }
                                            let _e1587 = phi_3133_;
                                            if _e1576 {
                                                let _e1588 = (_e1567 != 7u);
                                                if _e1588 {
                                                    phi_3143_ = (_e1564 + _e1567);
                                                } else {
                                                    phi_3143_ = u32();
                                                }
                                                let _e1591 = phi_3143_;
                                                phi_3145_ = _e1591;
                                                phi_3146_ = select(true, false, _e1588);
                                            } else {
                                                phi_3145_ = u32();
                                                phi_3146_ = true;
                                            }
                                            let _e1594 = phi_3145_;
                                            let _e1596 = phi_3146_;
                                            if (_e1575 == 0u) {
                                                phi_3167_ = (_e1563 + select(0u, 1u, !(_e1576)));
                                            } else {
                                                if (_e1575 == 7u) {
                                                    phi_3166_ = 2147483648u;
                                                } else {
                                                    phi_3166_ = ((2147483648u | (_e1575 << bitcast<u32>(28u))) | (select(_e1594, _e1564, _e1596) & 268435455u));
                                                }
                                                let _e1609 = phi_3166_;
                                                phi_3167_ = _e1609;
                                            }
                                            let _e1611 = phi_3167_;
                                            phi_3171_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e693.member.member.x + _e1439), (_e693.member.member.x + _e1461), (_e693.member.member_1.x - _e1478), (_e693.member.member_1.x - _e1500)), vec4<f32>((_e693.member.member.y + _e1448), (_e693.member.member.y + _e1465), (_e693.member.member_1.y - _e1487), (_e693.member.member_1.y - _e1504)), vec4<f32>((_e693.member.member.z + _e1457), (_e693.member.member.z + _e1469), (_e693.member.member_1.z - _e1496), (_e693.member.member_1.z - _e1508))), type_53(type_29((_e693.member.member + vec4<f32>(_e1439, _e1448, _e1457, 0f)), (_e693.member.member_1 - vec4<f32>(_e1478, _e1487, _e1496, 0f))), _e1587), type_53(type_29((_e693.member.member + vec4<f32>(_e1461, _e1465, _e1469, 0f)), (_e693.member.member_1 - vec4<f32>(_e1500, _e1504, _e1508, 0f))), _e1611));
                                        }
                                        let _e1616 = phi_3171_;
                                        let _e1627 = ((_e1616.member[0].x - _e370) * _e373);
                                        let _e1628 = ((_e1616.member[0].y - _e370) * _e373);
                                        let _e1629 = ((_e1616.member[0].z - _e371) * _e373);
                                        let _e1630 = ((_e1616.member[0].w - _e371) * _e373);
                                        let _e1640 = ((_e1616.member[1].x - _e436) * _e439);
                                        let _e1641 = ((_e1616.member[1].y - _e436) * _e439);
                                        let _e1642 = ((_e1616.member[1].z - _e437) * _e439);
                                        let _e1643 = ((_e1616.member[1].w - _e437) * _e439);
                                        let _e1653 = ((_e1616.member[2].x - _e502) * _e505);
                                        let _e1654 = ((_e1616.member[2].y - _e502) * _e505);
                                        let _e1655 = ((_e1616.member[2].z - _e503) * _e505);
                                        let _e1656 = ((_e1616.member[2].w - _e503) * _e505);
                                        let _e1658 = select(_e1655, _e1653, (_e1653 < _e1655));
                                        let _e1660 = select(_e1656, _e1654, (_e1654 < _e1656));
                                        let _e1662 = select(_e1655, _e1653, (_e1653 > _e1655));
                                        let _e1664 = select(_e1656, _e1654, (_e1654 > _e1656));
                                        let _e1666 = select(_e1629, _e1627, (_e1627 < _e1629));
                                        let _e1668 = select(_e1630, _e1628, (_e1628 < _e1630));
                                        let _e1670 = select(_e1642, _e1640, (_e1640 < _e1642));
                                        let _e1672 = select(_e1643, _e1641, (_e1641 < _e1643));
                                        let _e1674 = select(_e1670, _e1666, (_e1666 > _e1670));
                                        let _e1676 = select(_e1672, _e1668, (_e1668 > _e1672));
                                        let _e1678 = select(_e1658, _e1674, (_e1674 > _e1658));
                                        let _e1680 = select(_e1660, _e1676, (_e1676 > _e1660));
                                        let _e1682 = select(_e1629, _e1627, (_e1627 > _e1629));
                                        let _e1684 = select(_e1630, _e1628, (_e1628 > _e1630));
                                        let _e1686 = select(_e1642, _e1640, (_e1640 > _e1642));
                                        let _e1688 = select(_e1643, _e1641, (_e1641 > _e1643));
                                        let _e1690 = select(_e1686, _e1682, (_e1682 < _e1686));
                                        let _e1692 = select(_e1688, _e1684, (_e1684 < _e1688));
                                        let _e1697 = -(_e1658);
                                        let _e1698 = -(_e1660);
                                        let _e1705 = (select(_e1662, _e1690, (_e1690 < _e1662)) + (select(_e1697, _e1662, (_e1662 > _e1697)) * 0.0000019073523f));
                                        let _e1706 = (select(_e1664, _e1692, (_e1692 < _e1664)) + (select(_e1698, _e1664, (_e1664 > _e1698)) * 0.0000019073523f));
                                        let _e1708 = select(_e608, _e1678, (_e1678 > _e608));
                                        let _e1710 = select(_e608, _e1680, (_e1680 > _e608));
                                        let _e1715 = (_e1708 <= select(_e1340, _e1705, (_e1705 < _e1340)));
                                        let _e1716 = (_e1710 <= select(_e1340, _e1706, (_e1706 < _e1340)));
                                        let _e1717 = (_e1708 <= _e1710);
                                        if _e1715 {
                                            if _e1716 {
                                                if _e1717 {
                                                    phi_3534_ = _e1616.member_2;
                                                } else {
                                                    phi_3534_ = _e1616.member_1;
                                                }
                                                let _e1721 = phi_3534_;
                                                let _e1742 = (_e691 % 128u);
                                                let _e1743 = (_e1742 < 128u);
                                                if _e1743 {
                                                } else {
                                                    phi_4643_ = true;
                                                    break;
                                                }
                                                local_8[_e1742] = _e1721.member_1;
                                                if _e1743 {
                                                } else {
                                                    phi_4643_ = true;
                                                    break;
                                                }
                                                local_7[_e1742] = _e1721.member.member.x;
                                                if _e1743 {
                                                } else {
                                                    phi_4643_ = true;
                                                    break;
                                                }
                                                local_6[_e1742] = _e1721.member.member.y;
                                                if _e1743 {
                                                } else {
                                                    phi_4643_ = true;
                                                    break;
                                                }
                                                local_5[_e1742] = _e1721.member.member.z;
                                                if _e1743 {
                                                } else {
                                                    phi_4643_ = true;
                                                    break;
                                                }
                                                local_4[_e1742] = _e1721.member.member_1.x;
                                                if _e1743 {
                                                } else {
                                                    phi_4643_ = true;
                                                    break;
                                                }
                                                local_3[_e1742] = _e1721.member.member_1.y;
                                                if _e1743 {
                                                } else {
                                                    phi_4643_ = true;
                                                    break;
                                                }
                                                local_2[_e1742] = _e1721.member.member_1.z;
                                                if _e1743 {
                                                } else {
                                                    phi_4643_ = true;
                                                    break;
                                                }
                                                local_10[_e1742] = select(_e1708, _e1710, _e1717);
                                                if _e1717 {
                                                    phi_3610_ = _e1616.member_1;
                                                } else {
                                                    phi_3610_ = _e1616.member_2;
                                                }
                                                let _e1756 = phi_3610_;
                                                phi_3611_ = (_e691 + 1u);
                                                phi_3612_ = _e1756;
                                            } else {
                                                phi_3611_ = u32();
                                                phi_3612_ = type_53();
                                            }
                                            let _e1758 = phi_3611_;
                                            let _e1760 = phi_3612_;
                                            phi_3614_ = _e1758;
                                            phi_3615_ = _e1760;
                                            phi_3616_ = select(true, false, _e1716);
                                        } else {
                                            phi_3614_ = u32();
                                            phi_3615_ = type_53();
                                            phi_3616_ = true;
                                        }
                                        let _e1763 = phi_3614_;
                                        let _e1765 = phi_3615_;
                                        let _e1767 = phi_3616_;
                                        if _e1767 {
                                            if _e1715 {
                                                phi_3625_ = _e1616.member_1;
                                            } else {
                                                phi_3625_ = _e1616.member_2;
                                            }
                                            let _e1771 = phi_3625_;
                                            phi_3630_ = select(_e1716, true, _e1715);
                                            phi_3632_ = _e1771;
                                        } else {
                                            phi_3630_ = _e689;
                                            phi_3632_ = _e1765;
                                        }
                                        let _e1774 = phi_3630_;
                                        let _e1776 = phi_3632_;
                                        phi_3636_ = _e1774;
                                        phi_3637_ = select(_e1763, _e691, _e1767);
                                        phi_3638_ = _e1776;
                                    }
                                    let _e1779 = phi_3636_;
                                    let _e1781 = phi_3637_;
                                    let _e1783 = phi_3638_;
                                    if _e697 {
                                        phi_3648_ = _e693;
                                    } else {
                                        phi_3648_ = _e1783;
                                    }
                                    let _e1785 = phi_3648_;
                                    phi_4757_ = _e1340;
                                    phi_4646_ = _e1338;
                                    phi_3649_ = (_e653 - 1u);
                                    phi_3650_ = select(_e1779, false, _e697);
                                    phi_3651_ = select(_e1781, _e691, _e697);
                                    phi_3652_ = _e1785;
                                } else {
                                    phi_4757_ = _e651;
                                    phi_4646_ = _e649;
                                    phi_3649_ = _e653;
                                    phi_3650_ = _e689;
                                    phi_3651_ = _e691;
                                    phi_3652_ = _e693;
                                }
                                let _e1789 = phi_4757_;
                                let _e1791 = phi_4646_;
                                let _e1793 = phi_3649_;
                                let _e1795 = phi_3650_;
                                let _e1797 = phi_3651_;
                                let _e1799 = phi_3652_;
                                phi_4756_ = _e1789;
                                phi_4645_ = _e1791;
                                phi_3653_ = _e1793;
                                phi_3654_ = _e1795;
                                phi_3655_ = _e1797;
                                phi_3656_ = _e1799;
                            } else {
                                phi_4756_ = _e651;
                                phi_4645_ = _e649;
                                phi_3653_ = u32();
                                phi_3654_ = bool();
                                phi_3655_ = u32();
                                phi_3656_ = type_53();
                            }
                            let _e1801 = phi_4756_;
                            let _e1803 = phi_4645_;
                            let _e1805 = phi_3653_;
                            let _e1807 = phi_3654_;
                            let _e1809 = phi_3655_;
                            let _e1811 = phi_3656_;
                            phi_4755_ = _e1801;
                            phi_4644_ = _e1803;
                            phi_1244_ = _e1805;
                            phi_1247_ = _e1807;
                            phi_1249_ = _e1809;
                            phi_1251_ = _e1811;
                            phi_3657_ = _e663;
                        } else {
                            phi_4755_ = _e651;
                            phi_4644_ = _e649;
                            phi_1244_ = u32();
                            phi_1247_ = bool();
                            phi_1249_ = u32();
                            phi_1251_ = type_53();
                            phi_3657_ = false;
                        }
                        let _e1813 = phi_4755_;
                        let _e1815 = phi_4644_;
                        let _e1817 = phi_1244_;
                        let _e1819 = phi_1247_;
                        let _e1821 = phi_1249_;
                        let _e1823 = phi_1251_;
                        let _e1825 = phi_3657_;
                        continue;
                        continuing {
                            phi_4335_ = _e1815;
                            phi_4315_ = _e1813;
                            phi_1243_ = _e1817;
                            phi_1246_ = _e1819;
                            phi_1248_ = _e1821;
                            phi_1250_ = _e1823;
                            phi_4643_ = _e1815;
                            break if !(_e1825);
                        }
                    }
                    let _e1828 = phi_4643_;
                    if _e1828 {
                        break;
                    }
                    phi_3664_ = type_4(0u, 8u);
                    loop {
                        let _e1830 = phi_3664_;
                        if (_e1830.member < _e1830.member_1) {
                            phi_3665_ = type_4((_e1830.member + 1u), _e1830.member_1);
                            phi_3688_ = type_4(1u, _e1830.member);
                        } else {
                            phi_3665_ = _e1830;
                            phi_3688_ = type_4(0u, type_4().member_1);
                        }
                        let _e1843 = phi_3665_;
                        let _e1845 = phi_3688_;
                        let _e1849 = (bitcast<i32>(_e1845.member) != 0i);
                        if _e1849 {
                            let _e1850 = (_e1845.member_1 < 8u);
                            if _e1850 {
                            } else {
                                phi_4737_ = true;
                                break;
                            }
                            let _e1852 = local_9[_e1845.member_1];
                            if (_e1852.member_3 != 4294967295u) {
                                let _e1858 = -(_e510);
                                let _e1859 = bitcast<u32>(_e1852.member);
                                let _e1863 = (bitcast<i32>((_e1859 >> bitcast<u32>(23i))) & 255i);
                                let _e1864 = (_e1863 + _e1858);
                                if (_e1863 == 255i) {
                                    phi_3761_ = _e1852.member;
                                } else {
                                    if (_e1863 > 0i) {
                                        if (_e1864 > 0i) {
                                            let _e1868 = (_e1864 < 255i);
                                            if _e1868 {
                                                phi_3740_ = bitcast<f32>((_e1859 + bitcast<u32>((_e1858 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_3740_ = f32();
                                            }
                                            let _e1875 = phi_3740_;
                                            phi_3742_ = _e1875;
                                            phi_3743_ = select(true, false, _e1868);
                                        } else {
                                            phi_3742_ = f32();
                                            phi_3743_ = true;
                                        }
                                        let _e1878 = phi_3742_;
                                        let _e1880 = phi_3743_;
                                        phi_3744_ = _e1878;
                                        phi_3745_ = _e1880;
                                    } else {
                                        phi_3744_ = f32();
                                        phi_3745_ = true;
                                    }
                                    let _e1882 = phi_3744_;
                                    let _e1884 = phi_3745_;
                                    if _e1884 {
                                        let _e1885 = (_e1859 & 2147483648u);
                                        let _e1892 = ((_e1859 & 8388607u) | (select(0u, 1u, ((_e1859 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1896 = (_e1892 == 0u);
                                        if _e1896 {
                                            phi_4262_ = bitcast<f32>(_e1885);
                                        } else {
                                            let _e1901 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1892)), 32u, _e1896) - 8u);
                                            let _e1904 = (_e1892 << bitcast<u32>((_e1901 & 31u)));
                                            let _e1906 = ((_e1864 + select(0i, 1i, (_e1863 == 0i))) - bitcast<i32>(_e1901));
                                            if (_e1906 >= 255i) {
                                                phi_4252_ = bitcast<f32>((_e1885 | 2139095040u));
                                                phi_4253_ = f32();
                                                phi_4254_ = true;
                                            } else {
                                                let _e1908 = (_e1906 > 0i);
                                                if _e1908 {
                                                    phi_4246_ = bitcast<f32>(((_e1885 | (bitcast<u32>(_e1906) << bitcast<u32>(23i))) | (_e1904 & 8388607u)));
                                                    phi_4247_ = f32();
                                                } else {
                                                    if (_e1906 < -24i) {
                                                        phi_4212_ = 26u;
                                                    } else {
                                                        phi_4212_ = bitcast<u32>((1i - _e1906));
                                                    }
                                                    let _e1913 = phi_4212_;
                                                    let _e1914 = (_e1913 & 31u);
                                                    let _e1916 = (_e1904 >> bitcast<u32>(_e1914));
                                                    let _e1920 = (_e1904 & ((1u << bitcast<u32>(_e1914)) - 1u));
                                                    let _e1924 = (1u << bitcast<u32>(((_e1913 - 1u) & 31u)));
                                                    if (_e1920 > _e1924) {
                                                        phi_4233_ = true;
                                                    } else {
                                                        if (_e1920 == _e1924) {
                                                            phi_4230_ = ((_e1916 & 1u) == 1u);
                                                        } else {
                                                            phi_4230_ = false;
                                                        }
                                                        let _e1930 = phi_4230_;
                                                        phi_4233_ = _e1930;
                                                    }
                                                    let _e1932 = phi_4233_;
                                                    phi_4246_ = f32();
                                                    phi_4247_ = bitcast<f32>((_e1885 | (_e1916 + select(0u, 1u, _e1932))));
                                                }
                                                let _e1945 = phi_4246_;
                                                let _e1947 = phi_4247_;
                                                phi_4252_ = _e1945;
                                                phi_4253_ = _e1947;
                                                phi_4254_ = _e1908;
                                            }
                                            let _e1951 = phi_4252_;
                                            let _e1953 = phi_4253_;
                                            let _e1955 = phi_4254_;
                                            phi_4262_ = select(_e1953, _e1951, _e1955);
                                        }
                                        let _e1959 = phi_4262_;
                                        phi_3760_ = _e1959;
                                    } else {
                                        phi_3760_ = _e1882;
                                    }
                                    let _e1961 = phi_3760_;
                                    phi_3761_ = _e1961;
                                }
                                let _e1963 = phi_3761_;
                                let _e1964 = bitcast<u32>(_e1963);
                                if ((_e1964 & 2147483647u) >= 2139095040u) {
                                    phi_3773_ = bitcast<f32>(((_e1964 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_3773_ = _e1963;
                                }
                                let _e1971 = phi_3773_;
                                phi_3778_ = type_25(_e1971, _e1852.member_1, _e1852.member_2, _e1852.member_3);
                            } else {
                                phi_3778_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1974 = phi_3778_;
                            if _e1850 {
                            } else {
                                phi_4737_ = true;
                                break;
                            }
                            local_9[_e1845.member_1] = type_25(_e1974.member, _e1974.member_1, _e1974.member_2, _e1974.member_3);
                        }
                        continue;
                        continuing {
                            phi_3664_ = _e1843;
                            phi_4737_ = _e1828;
                            break if !(_e1849);
                        }
                    }
                    let _e1982 = phi_4737_;
                    if _e1982 {
                        break;
                    }
                    let _e1983 = local_9;
                    if _e156 {
                    } else {
                        break;
                    }
                    global_6.member[_e154] = array<type_25, 8>(type_25(_e1983[0].member, _e1983[0].member_1, _e1983[0].member_2, _e1983[0].member_3), type_25(_e1983[1].member, _e1983[1].member_1, _e1983[1].member_2, _e1983[1].member_3), type_25(_e1983[2].member, _e1983[2].member_1, _e1983[2].member_2, _e1983[2].member_3), type_25(_e1983[3].member, _e1983[3].member_1, _e1983[3].member_2, _e1983[3].member_3), type_25(_e1983[4].member, _e1983[4].member_1, _e1983[4].member_2, _e1983[4].member_3), type_25(_e1983[5].member, _e1983[5].member_1, _e1983[5].member_2, _e1983[5].member_3), type_25(_e1983[6].member, _e1983[6].member_1, _e1983[6].member_2, _e1983[6].member_3), type_25(_e1983[7].member, _e1983[7].member_1, _e1983[7].member_2, _e1983[7].member_3));
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
