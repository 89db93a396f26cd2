struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_20 {
    member: array<type_18>,
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

struct type_35 {
    member: type_18,
    member_1: f32,
}

struct type_38 {
    member: type_35,
    member_1: u32,
    member_2: u32,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<array<u32, 7>>,
}

struct type_49 {
    member: type_30,
    member_1: u32,
}

struct type_50 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
}

struct type_55 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_1: type_20;
@group(0) @binding(0) 
var<uniform> global_2: type_40;
@group(0) @binding(3) 
var<storage> global_3: type_25;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_5: type_55;
@group(0) @binding(1) 
var<storage> global_6: type_44;
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
    var phi_493_: i32;
    var phi_494_: i32;
    var phi_504_: bool;
    var phi_514_: u32;
    var phi_515_: u32;
    var phi_517_: bool;
    var phi_522_: u32;
    var phi_555_: i32;
    var phi_573_: f32;
    var phi_579_: f32;
    var phi_619_: f32;
    var phi_625_: f32;
    var phi_677_: f32;
    var phi_689_: f32;
    var phi_698_: f32;
    var phi_704_: f32;
    var phi_744_: f32;
    var phi_750_: f32;
    var phi_802_: f32;
    var phi_814_: f32;
    var phi_823_: f32;
    var phi_829_: f32;
    var phi_869_: f32;
    var phi_875_: f32;
    var phi_927_: f32;
    var phi_939_: f32;
    var phi_994_: i32;
    var phi_1016_: u32;
    var phi_1017_: u32;
    var phi_1054_: i32;
    var phi_1076_: u32;
    var phi_1077_: u32;
    var phi_1085_: f32;
    var phi_1086_: f32;
    var phi_4783_: bool;
    var phi_1191_: type_38;
    var phi_1194_: bool;
    var phi_1196_: u32;
    var phi_1198_: u32;
    var phi_1200_: type_49;
    var phi_1211_: bool;
    var phi_1297_: bool;
    var phi_1298_: u32;
    var phi_1299_: type_49;
    var phi_3526_: u32;
    var phi_3532_: u32;
    var phi_3786_: u32;
    var phi_3787_: u32;
    var phi_3797_: u32;
    var phi_3799_: u32;
    var phi_3800_: bool;
    var phi_3820_: u32;
    var phi_3821_: u32;
    var phi_3825_: type_50;
    var phi_4190_: type_49;
    var phi_4267_: type_49;
    var phi_4268_: u32;
    var phi_4269_: type_49;
    var phi_4271_: u32;
    var phi_4272_: type_49;
    var phi_4273_: bool;
    var phi_4282_: type_49;
    var phi_4287_: bool;
    var phi_4289_: type_49;
    var phi_1318_: type_38;
    var phi_1321_: type_8;
    var phi_1322_: type_8;
    var phi_1344_: type_8;
    var phi_1388_: u32;
    var phi_1394_: u32;
    var phi_1404_: u32;
    var phi_1420_: u32;
    var phi_1453_: u32;
    var phi_1459_: u32;
    var phi_1925_: u32;
    var phi_1943_: u32;
    var phi_1961_: u32;
    var phi_1984_: u32;
    var phi_2002_: u32;
    var phi_2020_: u32;
    var phi_2043_: u32;
    var phi_2061_: u32;
    var phi_2079_: u32;
    var phi_1633_: u32;
    var phi_1648_: u32;
    var phi_1658_: u32;
    var phi_1679_: u32;
    var phi_1700_: u32;
    var phi_1730_: u32;
    var phi_1745_: u32;
    var phi_1755_: u32;
    var phi_1776_: u32;
    var phi_1797_: u32;
    var phi_1827_: u32;
    var phi_1842_: u32;
    var phi_1852_: u32;
    var phi_1873_: u32;
    var phi_1894_: u32;
    var phi_1486_: u32;
    var phi_1535_: u32;
    var phi_1584_: u32;
    var phi_2085_: array<array<f32, 3>, 3>;
    var phi_2237_: bool;
    var phi_2266_: bool;
    var phi_2685_: f32;
    var phi_2686_: f32;
    var phi_2687_: f32;
    var phi_2688_: f32;
    var phi_2689_: vec3<f32>;
    var phi_2690_: vec3<f32>;
    var phi_2691_: vec3<f32>;
    var phi_2692_: vec3<f32>;
    var phi_2729_: bool;
    var phi_2738_: vec3<f32>;
    var phi_2903_: f32;
    var phi_2905_: f32;
    var phi_2906_: bool;
    var phi_2926_: f32;
    var phi_2927_: f32;
    var phi_2950_: type_18;
    var phi_2952_: type_18;
    var phi_2953_: bool;
    var phi_2957_: type_18;
    var phi_2958_: type_18;
    var phi_2959_: type_18;
    var phi_2960_: bool;
    var phi_2964_: type_18;
    var phi_2965_: bool;
    var phi_2966_: type_18;
    var phi_2967_: bool;
    var phi_2968_: bool;
    var phi_2969_: type_18;
    var phi_2970_: bool;
    var phi_2971_: bool;
    var phi_2979_: type_18;
    var phi_2980_: bool;
    var phi_2984_: type_18;
    var phi_3009_: bool;
    var phi_3010_: bool;
    var phi_3017_: type_38;
    var phi_3018_: type_38;
    var phi_3019_: type_38;
    var phi_1319_: type_38;
    var phi_4777_: bool;
    var phi_4988_: bool;
    var phi_4294_: type_38;
    var phi_4295_: bool;
    var phi_4296_: u32;
    var phi_4297_: type_49;
    var phi_4987_: bool;
    var phi_4298_: type_38;
    var phi_4299_: bool;
    var phi_4300_: u32;
    var phi_4301_: u32;
    var phi_4302_: type_49;
    var phi_4986_: bool;
    var phi_4303_: type_38;
    var phi_4304_: bool;
    var phi_4305_: u32;
    var phi_4306_: u32;
    var phi_4307_: type_49;
    var phi_4985_: bool;
    var phi_1192_: type_38;
    var phi_1195_: bool;
    var phi_1197_: u32;
    var phi_1199_: u32;
    var phi_1201_: type_49;
    var phi_4308_: bool;
    var phi_4984_: bool;
    var local_10: type_38;
    var phi_4346_: f32;
    var phi_4348_: f32;
    var phi_4349_: bool;
    var phi_4350_: f32;
    var phi_4351_: bool;
    var phi_4685_: u32;
    var phi_4703_: bool;
    var phi_4706_: bool;
    var phi_4719_: f32;
    var phi_4720_: f32;
    var phi_4725_: f32;
    var phi_4726_: f32;
    var phi_4727_: bool;
    var phi_4735_: f32;
    var phi_4366_: f32;
    var phi_4367_: f32;
    var phi_4379_: f32;
    var phi_4384_: type_18;
    var local_11: type_38;
    var local_12: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e95 = global;
            let _e97 = arrayLength((&global_6.member));
            let _e100 = arrayLength((&global_7.member));
            let _e108 = arrayLength((&global_5.member));
            let _e112 = global_2.member[0u][0u];
            let _e116 = global_2.member[0u][1u];
            let _e120 = global_2.member[0u][2u];
            let _e124 = global_2.member[0u][3u];
            let _e128 = global_2.member[1u][0u];
            let _e132 = global_2.member[1u][1u];
            let _e136 = global_2.member[1u][2u];
            let _e140 = (_e95.x + (_e95.y * 2097152u));
            let _e152 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e124) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e112), bitcast<i32>(_e116), bitcast<i32>(_e120));
            local = array<i32, 3>(bitcast<i32>(_e128), bitcast<i32>(_e132), bitcast<i32>(_e136));
            let _e155 = (_e140 < arrayLength((&global_3.member)));
            if _e155 {
                let _e156 = (_e140 < arrayLength((&global_1.member)));
                if _e156 {
                    let _e157 = (_e140 < arrayLength((&global_4.member)));
                    if _e157 {
                        if _e155 {
                        } else {
                            break;
                        }
                        let _e167 = global_3.member[_e140].member.member_2[0u];
                        let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                        let _e175 = global_3.member[_e140].member.member_2[1u];
                        let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                        let _e183 = global_3.member[_e140].member.member_2[2u];
                        let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                        let _e191 = global_3.member[_e140].member.member[0u];
                        let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                        let _e199 = global_3.member[_e140].member.member[1u];
                        let _e201 = (bitcast<u32>(_e199) & 2147483647u);
                        let _e207 = global_3.member[_e140].member.member[2u];
                        let _e209 = (bitcast<u32>(_e207) & 2147483647u);
                        let _e211 = select(_e177, _e169, (_e177 < _e169));
                        let _e213 = select(_e185, _e211, (_e185 < _e211));
                        let _e215 = select(_e193, _e213, (_e193 < _e213));
                        let _e217 = select(_e201, _e215, (_e201 < _e215));
                        let _e219 = select(_e209, _e217, (_e209 < _e217));
                        let _e224 = global_3.member[_e140].member.member_1;
                        let _e225 = bitcast<u32>(_e224);
                        let _e226 = (_e225 & 2147483647u);
                        let _e234 = global_3.member[_e140].member.member_3;
                        let _e235 = bitcast<u32>(_e234);
                        let _e236 = (_e235 & 2147483647u);
                        let _e240 = (((select(_e226, _e219, (_e226 < _e219)) < 2139095040u) && (_e236 <= 2139095040u)) && (_e213 > 0u));
                        if _e240 {
                            let _e243 = (bitcast<u32>(bitcast<f32>(_e213)) & 2147483647u);
                            if (_e243 >= 8388608u) {
                                phi_493_ = (bitcast<i32>((_e243 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_493_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e243)), 32u, (_e243 == 0u))));
                            }
                            let _e257 = phi_493_;
                            phi_494_ = _e257;
                        } else {
                            phi_494_ = 0i;
                        }
                        let _e259 = phi_494_;
                        let _e260 = (_e169 == _e213);
                        if _e260 {
                            phi_504_ = true;
                        } else {
                            phi_504_ = (_e177 == _e213);
                        }
                        let _e263 = phi_504_;
                        let _e264 = select(1u, 0u, _e260);
                        if _e263 {
                            let _e265 = (_e264 + 1u);
                            phi_514_ = _e265;
                            phi_515_ = _e265;
                            phi_517_ = select(true, false, (_e265 == 2u));
                        } else {
                            phi_514_ = u32();
                            phi_515_ = 0u;
                            phi_517_ = true;
                        }
                        let _e269 = phi_514_;
                        let _e271 = phi_515_;
                        let _e273 = phi_517_;
                        if _e273 {
                            phi_522_ = (_e271 + 1u);
                        } else {
                            phi_522_ = 0u;
                        }
                        let _e277 = phi_522_;
                        let _e278 = select(_e269, _e271, _e273);
                        let _e279 = select(_e264, select(2u, _e264, _e263), _e273);
                        let _e280 = -(_e259);
                        if (_e280 < -126i) {
                            phi_555_ = -126i;
                        } else {
                            phi_555_ = select(_e280, 127i, (_e280 > 127i));
                        }
                        let _e285 = phi_555_;
                        let _e290 = bitcast<f32>((bitcast<u32>((_e285 + 127i)) << bitcast<u32>(23i)));
                        let _e296 = bitcast<f32>((bitcast<u32>(((_e280 - _e285) + 127i)) << bitcast<u32>(23i)));
                        let _e301 = global_3.member[_e140].member.member;
                        let _e302 = (_e278 == 0u);
                        if _e302 {
                            phi_573_ = _e301[0];
                        } else {
                            phi_573_ = _e301[1];
                        }
                        let _e306 = phi_573_;
                        let _e307 = (_e278 == 2u);
                        if _e307 {
                            phi_579_ = _e301[2];
                        } else {
                            phi_579_ = _e306;
                        }
                        let _e310 = phi_579_;
                        let _e311 = bitcast<u32>(_e310);
                        let _e313 = ((_e311 & 2139095040u) != 0u);
                        let _e325 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e311 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e311 & 2147483648u))), _e310, _e313) * select(0.00000011920929f, 1f, _e313));
                        let _e326 = global_3.member[_e140].member.member_2;
                        if _e302 {
                            phi_619_ = _e326[0];
                        } else {
                            phi_619_ = _e326[1];
                        }
                        let _e330 = phi_619_;
                        if _e307 {
                            phi_625_ = _e326[2];
                        } else {
                            phi_625_ = _e330;
                        }
                        let _e333 = phi_625_;
                        let _e334 = bitcast<u32>(_e333);
                        let _e336 = ((_e334 & 2139095040u) != 0u);
                        let _e350 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e334 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e334 & 2147483648u))), _e333, _e336) * _e290) * select(0.00000011920929f, 1f, _e336)) * _e296);
                        let _e354 = (bitcast<f32>((bitcast<u32>(_e350) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e354 {
                            let _e358 = (bitcast<f32>((bitcast<u32>(_e325) & 2147483647u)) * 0.00000011920929f);
                            phi_677_ = select(0.00000000000011368684f, _e358, (_e358 > 0.00000000000011368684f));
                        } else {
                            phi_677_ = 0f;
                        }
                        let _e362 = phi_677_;
                        let _e363 = (_e325 + _e362);
                        let _e364 = (_e325 - _e362);
                        let _e365 = select(_e350, 0f, _e354);
                        if _e354 {
                            phi_689_ = 38685626000000000000000000f;
                        } else {
                            phi_689_ = (1f / _e350);
                        }
                        let _e368 = phi_689_;
                        let _e369 = (_e277 == 0u);
                        if _e369 {
                            phi_698_ = _e301[0];
                        } else {
                            phi_698_ = _e301[1];
                        }
                        let _e373 = phi_698_;
                        let _e374 = (_e277 == 2u);
                        if _e374 {
                            phi_704_ = _e301[2];
                        } else {
                            phi_704_ = _e373;
                        }
                        let _e377 = phi_704_;
                        let _e378 = bitcast<u32>(_e377);
                        let _e380 = ((_e378 & 2139095040u) != 0u);
                        let _e392 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e378 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e378 & 2147483648u))), _e377, _e380) * select(0.00000011920929f, 1f, _e380));
                        if _e369 {
                            phi_744_ = _e326[0];
                        } else {
                            phi_744_ = _e326[1];
                        }
                        let _e396 = phi_744_;
                        if _e374 {
                            phi_750_ = _e326[2];
                        } else {
                            phi_750_ = _e396;
                        }
                        let _e399 = phi_750_;
                        let _e400 = bitcast<u32>(_e399);
                        let _e402 = ((_e400 & 2139095040u) != 0u);
                        let _e416 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e400 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e400 & 2147483648u))), _e399, _e402) * _e290) * select(0.00000011920929f, 1f, _e402)) * _e296);
                        let _e420 = (bitcast<f32>((bitcast<u32>(_e416) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e420 {
                            let _e424 = (bitcast<f32>((bitcast<u32>(_e392) & 2147483647u)) * 0.00000011920929f);
                            phi_802_ = select(0.00000000000011368684f, _e424, (_e424 > 0.00000000000011368684f));
                        } else {
                            phi_802_ = 0f;
                        }
                        let _e428 = phi_802_;
                        let _e429 = (_e392 + _e428);
                        let _e430 = (_e392 - _e428);
                        let _e431 = select(_e416, 0f, _e420);
                        if _e420 {
                            phi_814_ = 38685626000000000000000000f;
                        } else {
                            phi_814_ = (1f / _e416);
                        }
                        let _e434 = phi_814_;
                        let _e435 = (_e279 == 0u);
                        if _e435 {
                            phi_823_ = _e301[0];
                        } else {
                            phi_823_ = _e301[1];
                        }
                        let _e439 = phi_823_;
                        let _e440 = (_e279 == 2u);
                        if _e440 {
                            phi_829_ = _e301[2];
                        } else {
                            phi_829_ = _e439;
                        }
                        let _e443 = phi_829_;
                        let _e444 = bitcast<u32>(_e443);
                        let _e446 = ((_e444 & 2139095040u) != 0u);
                        let _e458 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e444 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e444 & 2147483648u))), _e443, _e446) * select(0.00000011920929f, 1f, _e446));
                        if _e435 {
                            phi_869_ = _e326[0];
                        } else {
                            phi_869_ = _e326[1];
                        }
                        let _e462 = phi_869_;
                        if _e440 {
                            phi_875_ = _e326[2];
                        } else {
                            phi_875_ = _e462;
                        }
                        let _e465 = phi_875_;
                        let _e466 = bitcast<u32>(_e465);
                        let _e468 = ((_e466 & 2139095040u) != 0u);
                        let _e482 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e466 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e466 & 2147483648u))), _e465, _e468) * _e290) * select(0.00000011920929f, 1f, _e468)) * _e296);
                        let _e486 = (bitcast<f32>((bitcast<u32>(_e482) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e486 {
                            let _e490 = (bitcast<f32>((bitcast<u32>(_e458) & 2147483647u)) * 0.00000011920929f);
                            phi_927_ = select(0.00000000000011368684f, _e490, (_e490 > 0.00000000000011368684f));
                        } else {
                            phi_927_ = 0f;
                        }
                        let _e494 = phi_927_;
                        let _e495 = (_e458 + _e494);
                        let _e496 = (_e458 - _e494);
                        let _e497 = select(_e482, 0f, _e486);
                        if _e486 {
                            phi_939_ = 38685626000000000000000000f;
                        } else {
                            phi_939_ = (1f / _e482);
                        }
                        let _e500 = phi_939_;
                        let _e503 = bitcast<f32>((bitcast<u32>(_e325) & 2147483647u));
                        let _e506 = bitcast<f32>((bitcast<u32>(_e392) & 2147483647u));
                        let _e508 = select(_e506, _e503, (_e503 > _e506));
                        let _e511 = bitcast<f32>((bitcast<u32>(_e458) & 2147483647u));
                        if (_e240 && (select(_e511, _e508, (_e508 > _e511)) <= 1099511600000f)) {
                            let _e523 = ((_e226 & 8388607u) | (select(0u, 1u, ((_e226 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e526 = bitcast<i32>((_e226 >> bitcast<u32>(23i)));
                            let _e530 = (_e523 == 0u);
                            let _e533 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e523)), 32u, _e530)) - 8i);
                            if (_e526 == 255i) {
                                phi_994_ = 255i;
                            } else {
                                phi_994_ = (((_e526 + select(0i, 1i, (_e526 == 0i))) - _e533) + _e259);
                            }
                            let _e541 = phi_994_;
                            let _e551 = (_e541 <= 0i);
                            if _e551 {
                                phi_1017_ = u32();
                            } else {
                                if _e530 {
                                    phi_1016_ = u32();
                                } else {
                                    phi_1016_ = select(((bitcast<u32>(_e541) << bitcast<u32>(23i)) | ((_e523 << bitcast<u32>(((_e533 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e541 >= 255i));
                                }
                                let _e555 = phi_1016_;
                                phi_1017_ = _e555;
                            }
                            let _e557 = phi_1017_;
                            let _e569 = ((_e236 & 8388607u) | (select(0u, 1u, ((_e236 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e572 = bitcast<i32>((_e236 >> bitcast<u32>(23i)));
                            let _e576 = (_e569 == 0u);
                            let _e579 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e569)), 32u, _e576)) - 8i);
                            if (_e572 == 255i) {
                                phi_1054_ = 255i;
                            } else {
                                phi_1054_ = (((_e572 + select(0i, 1i, (_e572 == 0i))) - _e579) + _e259);
                            }
                            let _e587 = phi_1054_;
                            let _e597 = (_e587 <= 0i);
                            if _e597 {
                                phi_1077_ = u32();
                            } else {
                                if _e576 {
                                    phi_1076_ = u32();
                                } else {
                                    phi_1076_ = select(((bitcast<u32>(_e587) << bitcast<u32>(23i)) | ((_e569 << bitcast<u32>(((_e579 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e587 >= 255i));
                                }
                                let _e601 = phi_1076_;
                                phi_1077_ = _e601;
                            }
                            let _e603 = phi_1077_;
                            phi_1085_ = bitcast<f32>(((_e235 & 2147483648u) | select(_e603, 0u, select(_e576, true, _e597))));
                            phi_1086_ = bitcast<f32>(((_e225 & 2147483648u) | select(_e557, 0u, select(_e530, true, _e551))));
                        } else {
                            phi_1085_ = 0f;
                            phi_1086_ = 1f;
                        }
                        let _e609 = phi_1085_;
                        let _e611 = phi_1086_;
                        if _e155 {
                        } else {
                            break;
                        }
                        let _e617 = global_3.member[_e140].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e620 = (_e278 % 3u);
                        let _e621 = (_e620 < 3u);
                        if _e621 {
                        } else {
                            break;
                        }
                        let _e623 = local_1[_e620];
                        let _e626 = (_e277 % 3u);
                        let _e627 = (_e626 < 3u);
                        if _e627 {
                        } else {
                            break;
                        }
                        let _e629 = local_1[_e626];
                        let _e632 = (_e279 % 3u);
                        let _e633 = (_e632 < 3u);
                        if _e633 {
                        } else {
                            break;
                        }
                        let _e635 = local_1[_e632];
                        if _e621 {
                        } else {
                            break;
                        }
                        let _e640 = local[_e620];
                        if _e627 {
                        } else {
                            break;
                        }
                        let _e644 = local[_e626];
                        if _e633 {
                        } else {
                            break;
                        }
                        let _e648 = local[_e632];
                        phi_4783_ = false;
                        phi_1191_ = type_38(type_35(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e609), 0u, 0u);
                        phi_1194_ = (_e611 <= _e609);
                        phi_1196_ = ((3u * _e97) + 1u);
                        phi_1198_ = 0u;
                        phi_1200_ = type_49(type_30(vec4<f32>((f32(_e623) * _e152), (f32(_e629) * _e152), (f32(_e635) * _e152), 0f), vec4<f32>((f32(_e640) * _e152), (f32(_e644) * _e152), (f32(_e648) * _e152), 0f)), select(0u, 2147483648u, (_e97 == 0u)));
                        loop {
                            let _e658 = phi_4783_;
                            let _e660 = phi_1191_;
                            let _e662 = phi_1194_;
                            let _e664 = phi_1196_;
                            let _e666 = phi_1198_;
                            let _e668 = phi_1200_;
                            local_10 = _e660;
                            local_11 = _e660;
                            if _e662 {
                                phi_1211_ = true;
                            } else {
                                phi_1211_ = (_e666 > 0u);
                            }
                            let _e671 = phi_1211_;
                            if _e671 {
                                let _e672 = (_e664 > 0u);
                                if _e672 {
                                    if _e662 {
                                        phi_1297_ = _e662;
                                        phi_1298_ = _e666;
                                        phi_1299_ = _e668;
                                    } else {
                                        let _e673 = (_e666 - 1u);
                                        let _e674 = (_e673 % 128u);
                                        let _e675 = (_e674 < 128u);
                                        if _e675 {
                                        } else {
                                            phi_4984_ = true;
                                            break;
                                        }
                                        let _e677 = local_7[_e674];
                                        if _e675 {
                                        } else {
                                            phi_4984_ = true;
                                            break;
                                        }
                                        let _e679 = local_6[_e674];
                                        if _e675 {
                                        } else {
                                            phi_4984_ = true;
                                            break;
                                        }
                                        let _e681 = local_5[_e674];
                                        if _e675 {
                                        } else {
                                            phi_4984_ = true;
                                            break;
                                        }
                                        let _e683 = local_4[_e674];
                                        if _e675 {
                                        } else {
                                            phi_4984_ = true;
                                            break;
                                        }
                                        let _e685 = local_3[_e674];
                                        if _e675 {
                                        } else {
                                            phi_4984_ = true;
                                            break;
                                        }
                                        let _e687 = local_2[_e674];
                                        if _e675 {
                                        } else {
                                            phi_4984_ = true;
                                            break;
                                        }
                                        let _e692 = local_8[_e674];
                                        if _e675 {
                                        } else {
                                            phi_4984_ = true;
                                            break;
                                        }
                                        let _e695 = local_9[_e674];
                                        phi_1297_ = (_e695 <= _e660.member.member_1);
                                        phi_1298_ = _e673;
                                        phi_1299_ = type_49(type_30(vec4<f32>(_e677, _e679, _e681, 0f), vec4<f32>(_e683, _e685, _e687, 0f)), _e692);
                                    }
                                    let _e700 = phi_1297_;
                                    let _e702 = phi_1298_;
                                    let _e704 = phi_1299_;
                                    if _e700 {
                                        let _e709 = (_e704.member_1 & 268435455u);
                                        if ((_e704.member_1 & 2147483648u) != 0u) {
                                            phi_1318_ = _e660;
                                            phi_1321_ = type_8(0u, ((_e704.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1200 = phi_1318_;
                                                let _e1202 = phi_1321_;
                                                local_12 = _e1200;
                                                if (_e1202.member < _e1202.member_1) {
                                                    phi_1322_ = type_8((_e1202.member + 1u), _e1202.member_1);
                                                    phi_1344_ = type_8(1u, _e1202.member);
                                                } else {
                                                    phi_1322_ = _e1202;
                                                    phi_1344_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1215 = phi_1322_;
                                                let _e1217 = phi_1344_;
                                                let _e1221 = (bitcast<i32>(_e1217.member) != 0i);
                                                if _e1221 {
                                                    let _e1227 = type_38(_e1200.member, _e1200.member_1, (_e1200.member_2 + 1u));
                                                    let _e1232 = (_e704.member.member_1.x - _e704.member.member.x);
                                                    let _e1235 = (_e704.member.member_1.y - _e704.member.member.y);
                                                    let _e1238 = (_e704.member.member_1.z - _e704.member.member.z);
                                                    let _e1240 = select(_e1235, _e1232, (_e1232 > _e1235));
                                                    let _e1242 = select(_e1238, _e1240, (_e1240 > _e1238));
                                                    let _e1244 = (_e1242 < (1024f * _e152));
                                                    if _e1244 {
                                                        phi_1388_ = 0u;
                                                    } else {
                                                        phi_1388_ = select(2u, 1u, (_e1242 < (2097152f * _e152)));
                                                    }
                                                    let _e1249 = phi_1388_;
                                                    switch bitcast<i32>(_e1249) {
                                                        case 0: {
                                                            phi_1394_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1394_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1394_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1394_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1252 = phi_1394_;
                                                    switch bitcast<i32>(_e1249) {
                                                        case 0: {
                                                            phi_1404_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1404_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1404_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1404_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1259 = phi_1404_;
                                                    let _e1261 = ((_e709 + (_e1217.member_1 * ((3u * _e1252) + 1u))) + (3u * _e1259));
                                                    let _e1262 = (_e1261 < _e100);
                                                    if _e1262 {
                                                        if _e1262 {
                                                        } else {
                                                            phi_4777_ = true;
                                                            break;
                                                        }
                                                        let _e1264 = global_7.member[_e1261];
                                                        phi_1420_ = _e1264;
                                                    } else {
                                                        phi_1420_ = 4294967295u;
                                                    }
                                                    let _e1266 = phi_1420_;
                                                    if _e1244 {
                                                        phi_1453_ = 0u;
                                                    } else {
                                                        phi_1453_ = select(2u, 1u, (_e1242 < (2097152f * _e152)));
                                                    }
                                                    let _e1271 = phi_1453_;
                                                    switch bitcast<i32>(_e1271) {
                                                        case 0: {
                                                            phi_1459_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1459_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1459_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1459_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1274 = phi_1459_;
                                                    let _e1278 = (_e709 + (_e1217.member_1 * ((3u * _e1274) + 1u)));
                                                    switch bitcast<i32>(_e1271) {
                                                        case 0: {
                                                            let _e1553 = (_e1278 < _e100);
                                                            if _e1553 {
                                                                if _e1553 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1555 = global_7.member[_e1278];
                                                                phi_1486_ = _e1555;
                                                            } else {
                                                                phi_1486_ = 0u;
                                                            }
                                                            let _e1557 = phi_1486_;
                                                            let _e1559 = ((10u * _e278) & 31u);
                                                            let _e1569 = ((10u * _e277) & 31u);
                                                            let _e1579 = ((10u * _e279) & 31u);
                                                            let _e1589 = (_e1278 + 1u);
                                                            let _e1590 = (_e1589 < _e100);
                                                            if _e1590 {
                                                                if _e1590 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1592 = global_7.member[_e1589];
                                                                phi_1535_ = _e1592;
                                                            } else {
                                                                phi_1535_ = 0u;
                                                            }
                                                            let _e1594 = phi_1535_;
                                                            let _e1620 = (_e1278 + 2u);
                                                            let _e1621 = (_e1620 < _e100);
                                                            if _e1621 {
                                                                if _e1621 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1623 = global_7.member[_e1620];
                                                                phi_1584_ = _e1623;
                                                            } else {
                                                                phi_1584_ = 0u;
                                                            }
                                                            let _e1625 = phi_1584_;
                                                            phi_2085_ = array<array<f32, 3>, 3>(array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | ((_e1557 >> bitcast<u32>(_e1559)) & 1023u))) - 8388608f) * _e152)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | ((_e1557 >> bitcast<u32>(_e1569)) & 1023u))) - 8388608f) * _e152)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | ((_e1557 >> bitcast<u32>(_e1579)) & 1023u))) - 8388608f) * _e152))), array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | ((_e1594 >> bitcast<u32>(_e1559)) & 1023u))) - 8388608f) * _e152)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | ((_e1594 >> bitcast<u32>(_e1569)) & 1023u))) - 8388608f) * _e152)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | ((_e1594 >> bitcast<u32>(_e1579)) & 1023u))) - 8388608f) * _e152))), array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | ((_e1625 >> bitcast<u32>(_e1559)) & 1023u))) - 8388608f) * _e152)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | ((_e1625 >> bitcast<u32>(_e1569)) & 1023u))) - 8388608f) * _e152)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | ((_e1625 >> bitcast<u32>(_e1579)) & 1023u))) - 8388608f) * _e152))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1367 = (_e1278 < _e100);
                                                            if _e1367 {
                                                                if _e1367 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1369 = global_7.member[_e1278];
                                                                phi_1633_ = _e1369;
                                                            } else {
                                                                phi_1633_ = 0u;
                                                            }
                                                            let _e1371 = phi_1633_;
                                                            let _e1372 = (_e1278 + 1u);
                                                            let _e1373 = (_e1372 < _e100);
                                                            if _e1373 {
                                                                if _e1373 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1375 = global_7.member[_e1372];
                                                                phi_1648_ = _e1375;
                                                            } else {
                                                                phi_1648_ = 0u;
                                                            }
                                                            let _e1377 = phi_1648_;
                                                            let _e1378 = (_e278 == 1u);
                                                            if _e1378 {
                                                                phi_1658_ = ((_e1371 >> bitcast<u32>(21i)) | (_e1377 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1658_ = (_e1377 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1387 = phi_1658_;
                                                            let _e1395 = (_e277 == 1u);
                                                            if _e1395 {
                                                                phi_1679_ = ((_e1371 >> bitcast<u32>(21i)) | (_e1377 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1679_ = (_e1377 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1404 = phi_1679_;
                                                            let _e1412 = (_e279 == 1u);
                                                            if _e1412 {
                                                                phi_1700_ = ((_e1371 >> bitcast<u32>(21i)) | (_e1377 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1700_ = (_e1377 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1421 = phi_1700_;
                                                            let _e1430 = (_e1278 + 2u);
                                                            let _e1431 = (_e1430 < _e100);
                                                            if _e1431 {
                                                                if _e1431 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1433 = global_7.member[_e1430];
                                                                phi_1730_ = _e1433;
                                                            } else {
                                                                phi_1730_ = 0u;
                                                            }
                                                            let _e1435 = phi_1730_;
                                                            let _e1436 = (_e1278 + 3u);
                                                            let _e1437 = (_e1436 < _e100);
                                                            if _e1437 {
                                                                if _e1437 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1439 = global_7.member[_e1436];
                                                                phi_1745_ = _e1439;
                                                            } else {
                                                                phi_1745_ = 0u;
                                                            }
                                                            let _e1441 = phi_1745_;
                                                            if _e1378 {
                                                                phi_1755_ = ((_e1435 >> bitcast<u32>(21i)) | (_e1441 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1755_ = (_e1441 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1450 = phi_1755_;
                                                            if _e1395 {
                                                                phi_1776_ = ((_e1435 >> bitcast<u32>(21i)) | (_e1441 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1776_ = (_e1441 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1466 = phi_1776_;
                                                            if _e1412 {
                                                                phi_1797_ = ((_e1435 >> bitcast<u32>(21i)) | (_e1441 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1797_ = (_e1441 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1482 = phi_1797_;
                                                            let _e1491 = (_e1278 + 4u);
                                                            let _e1492 = (_e1491 < _e100);
                                                            if _e1492 {
                                                                if _e1492 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1494 = global_7.member[_e1491];
                                                                phi_1827_ = _e1494;
                                                            } else {
                                                                phi_1827_ = 0u;
                                                            }
                                                            let _e1496 = phi_1827_;
                                                            let _e1497 = (_e1278 + 5u);
                                                            let _e1498 = (_e1497 < _e100);
                                                            if _e1498 {
                                                                if _e1498 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1500 = global_7.member[_e1497];
                                                                phi_1842_ = _e1500;
                                                            } else {
                                                                phi_1842_ = 0u;
                                                            }
                                                            let _e1502 = phi_1842_;
                                                            if _e1378 {
                                                                phi_1852_ = ((_e1496 >> bitcast<u32>(21i)) | (_e1502 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1852_ = (_e1502 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1511 = phi_1852_;
                                                            if _e1395 {
                                                                phi_1873_ = ((_e1496 >> bitcast<u32>(21i)) | (_e1502 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1873_ = (_e1502 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1527 = phi_1873_;
                                                            if _e1412 {
                                                                phi_1894_ = ((_e1496 >> bitcast<u32>(21i)) | (_e1502 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1894_ = (_e1502 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1543 = phi_1894_;
                                                            phi_2085_ = array<array<f32, 3>, 3>(array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1387, _e1371, _e302) & 2097151u))) - 8388608f) * _e152)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1404, _e1371, _e369) & 2097151u))) - 8388608f) * _e152)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1421, _e1371, _e435) & 2097151u))) - 8388608f) * _e152))), array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1450, _e1435, _e302) & 2097151u))) - 8388608f) * _e152)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1466, _e1435, _e369) & 2097151u))) - 8388608f) * _e152)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1482, _e1435, _e435) & 2097151u))) - 8388608f) * _e152))), array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1511, _e1496, _e302) & 2097151u))) - 8388608f) * _e152)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1527, _e1496, _e369) & 2097151u))) - 8388608f) * _e152)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1543, _e1496, _e435) & 2097151u))) - 8388608f) * _e152))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1280 = (_e1278 + _e278);
                                                            let _e1281 = (_e1280 < _e100);
                                                            if _e1281 {
                                                                if _e1281 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1283 = global_7.member[_e1280];
                                                                phi_1925_ = _e1283;
                                                            } else {
                                                                phi_1925_ = 0u;
                                                            }
                                                            let _e1285 = phi_1925_;
                                                            let _e1289 = (_e1278 + _e277);
                                                            let _e1290 = (_e1289 < _e100);
                                                            if _e1290 {
                                                                if _e1290 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1292 = global_7.member[_e1289];
                                                                phi_1943_ = _e1292;
                                                            } else {
                                                                phi_1943_ = 0u;
                                                            }
                                                            let _e1294 = phi_1943_;
                                                            let _e1298 = (_e1278 + _e279);
                                                            let _e1299 = (_e1298 < _e100);
                                                            if _e1299 {
                                                                if _e1299 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1301 = global_7.member[_e1298];
                                                                phi_1961_ = _e1301;
                                                            } else {
                                                                phi_1961_ = 0u;
                                                            }
                                                            let _e1303 = phi_1961_;
                                                            let _e1308 = (_e1278 + 3u);
                                                            let _e1309 = (_e1308 + _e278);
                                                            let _e1310 = (_e1309 < _e100);
                                                            if _e1310 {
                                                                if _e1310 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1312 = global_7.member[_e1309];
                                                                phi_1984_ = _e1312;
                                                            } else {
                                                                phi_1984_ = 0u;
                                                            }
                                                            let _e1314 = phi_1984_;
                                                            let _e1318 = (_e1308 + _e277);
                                                            let _e1319 = (_e1318 < _e100);
                                                            if _e1319 {
                                                                if _e1319 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1321 = global_7.member[_e1318];
                                                                phi_2002_ = _e1321;
                                                            } else {
                                                                phi_2002_ = 0u;
                                                            }
                                                            let _e1323 = phi_2002_;
                                                            let _e1327 = (_e1308 + _e279);
                                                            let _e1328 = (_e1327 < _e100);
                                                            if _e1328 {
                                                                if _e1328 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1330 = global_7.member[_e1327];
                                                                phi_2020_ = _e1330;
                                                            } else {
                                                                phi_2020_ = 0u;
                                                            }
                                                            let _e1332 = phi_2020_;
                                                            let _e1337 = (_e1278 + 6u);
                                                            let _e1338 = (_e1337 + _e278);
                                                            let _e1339 = (_e1338 < _e100);
                                                            if _e1339 {
                                                                if _e1339 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1341 = global_7.member[_e1338];
                                                                phi_2043_ = _e1341;
                                                            } else {
                                                                phi_2043_ = 0u;
                                                            }
                                                            let _e1343 = phi_2043_;
                                                            let _e1347 = (_e1337 + _e277);
                                                            let _e1348 = (_e1347 < _e100);
                                                            if _e1348 {
                                                                if _e1348 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1350 = global_7.member[_e1347];
                                                                phi_2061_ = _e1350;
                                                            } else {
                                                                phi_2061_ = 0u;
                                                            }
                                                            let _e1352 = phi_2061_;
                                                            let _e1356 = (_e1337 + _e279);
                                                            let _e1357 = (_e1356 < _e100);
                                                            if _e1357 {
                                                                if _e1357 {
                                                                } else {
                                                                    phi_4777_ = true;
                                                                    break;
                                                                }
                                                                let _e1359 = global_7.member[_e1356];
                                                                phi_2079_ = _e1359;
                                                            } else {
                                                                phi_2079_ = 0u;
                                                            }
                                                            let _e1361 = phi_2079_;
                                                            phi_2085_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1285)) * _e152), (f32(bitcast<i32>(_e1294)) * _e152), (f32(bitcast<i32>(_e1303)) * _e152)), array<f32, 3>((f32(bitcast<i32>(_e1314)) * _e152), (f32(bitcast<i32>(_e1323)) * _e152), (f32(bitcast<i32>(_e1332)) * _e152)), array<f32, 3>((f32(bitcast<i32>(_e1343)) * _e152), (f32(bitcast<i32>(_e1352)) * _e152), (f32(bitcast<i32>(_e1361)) * _e152)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2085_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1653 = phi_2085_;
                                                    let _e1662 = (_e1653[0][2] - _e458);
                                                    let _e1665 = (((_e1653[0][0] - _e325) * _e497) - (_e1662 * _e365));
                                                    let _e1668 = (((_e1653[0][1] - _e392) * _e497) - (_e1662 * _e431));
                                                    let _e1675 = (_e1653[1][2] - _e458);
                                                    let _e1678 = (((_e1653[1][0] - _e325) * _e497) - (_e1675 * _e365));
                                                    let _e1681 = (((_e1653[1][1] - _e392) * _e497) - (_e1675 * _e431));
                                                    let _e1688 = (_e1653[2][2] - _e458);
                                                    let _e1691 = (((_e1653[2][0] - _e325) * _e497) - (_e1688 * _e365));
                                                    let _e1694 = (((_e1653[2][1] - _e392) * _e497) - (_e1688 * _e431));
                                                    let _e1695 = (_e1691 * _e1681);
                                                    let _e1696 = (_e1694 * _e1678);
                                                    let _e1697 = (_e1665 * _e1694);
                                                    let _e1698 = (_e1668 * _e1691);
                                                    let _e1699 = (_e1678 * _e1668);
                                                    let _e1700 = (_e1681 * _e1665);
                                                    let _e1705 = (((_e1695 >= _e1696) && (_e1697 >= _e1698)) && (_e1699 >= _e1700));
                                                    if (_e1705 || (((_e1695 <= _e1696) && (_e1697 <= _e1698)) && (_e1699 <= _e1700))) {
                                                        let _e1712 = select(-1f, 1f, _e1705);
                                                        let _e1714 = ((_e1695 - _e1696) * _e1712);
                                                        let _e1716 = select(0f, _e1714, (_e1714 > 0f));
                                                        let _e1718 = ((_e1697 - _e1698) * _e1712);
                                                        let _e1720 = select(0f, _e1718, (_e1718 > 0f));
                                                        let _e1722 = ((_e1699 - _e1700) * _e1712);
                                                        let _e1724 = select(0f, _e1722, (_e1722 > 0f));
                                                        let _e1726 = ((_e1716 + _e1720) + _e1724);
                                                        if (_e1726 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2969_ = type_18();
                                                            phi_2970_ = true;
                                                            phi_2971_ = false;
                                                        } else {
                                                            let _e1729 = select(_e1678, _e1665, (_e1665 < _e1678));
                                                            if (select(_e1691, _e1729, (_e1729 < _e1691)) > 0f) {
                                                                phi_2237_ = true;
                                                            } else {
                                                                let _e1734 = select(_e1678, _e1665, (_e1665 > _e1678));
                                                                phi_2237_ = (select(_e1691, _e1734, (_e1734 > _e1691)) < 0f);
                                                            }
                                                            let _e1739 = phi_2237_;
                                                            if _e1739 {
                                                                phi_2966_ = type_18();
                                                                phi_2967_ = true;
                                                                phi_2968_ = false;
                                                            } else {
                                                                let _e1741 = select(_e1681, _e1668, (_e1668 < _e1681));
                                                                if (select(_e1694, _e1741, (_e1741 < _e1694)) > 0f) {
                                                                    phi_2266_ = true;
                                                                } else {
                                                                    let _e1746 = select(_e1681, _e1668, (_e1668 > _e1681));
                                                                    phi_2266_ = (select(_e1694, _e1746, (_e1746 > _e1694)) < 0f);
                                                                }
                                                                let _e1751 = phi_2266_;
                                                                if _e1751 {
                                                                    phi_2964_ = type_18();
                                                                    phi_2965_ = false;
                                                                } else {
                                                                    let _e1753 = select(_e1653[1][0], _e1653[0][0], (_e1653[0][0] < _e1653[1][0]));
                                                                    let _e1757 = select(_e1653[1][0], _e1653[0][0], (_e1653[0][0] > _e1653[1][0]));
                                                                    let _e1761 = select(_e1653[1][1], _e1653[0][1], (_e1653[0][1] < _e1653[1][1]));
                                                                    let _e1765 = select(_e1653[1][1], _e1653[0][1], (_e1653[0][1] > _e1653[1][1]));
                                                                    let _e1769 = select(_e1653[1][2], _e1653[0][2], (_e1653[0][2] < _e1653[1][2]));
                                                                    let _e1773 = select(_e1653[1][2], _e1653[0][2], (_e1653[0][2] > _e1653[1][2]));
                                                                    let _e1778 = ((select(_e1653[2][0], _e1753, (_e1753 < _e1653[2][0])) - _e363) * _e368);
                                                                    let _e1779 = ((select(_e1653[2][0], _e1757, (_e1757 > _e1653[2][0])) - _e364) * _e368);
                                                                    let _e1782 = ((select(_e1653[2][1], _e1761, (_e1761 < _e1653[2][1])) - _e429) * _e434);
                                                                    let _e1783 = ((select(_e1653[2][1], _e1765, (_e1765 > _e1653[2][1])) - _e430) * _e434);
                                                                    let _e1786 = ((select(_e1653[2][2], _e1769, (_e1769 < _e1653[2][2])) - _e495) * _e500);
                                                                    let _e1787 = ((select(_e1653[2][2], _e1773, (_e1773 > _e1653[2][2])) - _e496) * _e500);
                                                                    let _e1789 = select(_e1787, _e1786, (_e1786 < _e1787));
                                                                    let _e1791 = select(_e1787, _e1786, (_e1786 > _e1787));
                                                                    let _e1793 = select(_e1779, _e1778, (_e1778 < _e1779));
                                                                    let _e1795 = select(_e1783, _e1782, (_e1782 < _e1783));
                                                                    let _e1797 = select(_e1795, _e1793, (_e1793 > _e1795));
                                                                    let _e1799 = select(_e1789, _e1797, (_e1797 > _e1789));
                                                                    let _e1801 = select(_e1779, _e1778, (_e1778 > _e1779));
                                                                    let _e1803 = select(_e1783, _e1782, (_e1782 > _e1783));
                                                                    let _e1805 = select(_e1803, _e1801, (_e1801 < _e1803));
                                                                    let _e1807 = select(_e1791, _e1805, (_e1805 < _e1791));
                                                                    let _e1808 = -(_e1789);
                                                                    let _e1814 = select(_e611, _e1799, (_e1799 > _e611));
                                                                    if (_e1814 > (_e1807 + (select(_e1808, _e1791, (_e1791 > _e1808)) * 0.0000019073523f))) {
                                                                        phi_2959_ = type_18();
                                                                        phi_2960_ = true;
                                                                    } else {
                                                                        let _e1816 = (_e1814 > _e1200.member.member_1);
                                                                        if _e1816 {
                                                                            phi_2958_ = type_18();
                                                                        } else {
                                                                            let _e1817 = vec3<f32>(_e1653[0][0], _e1653[0][1], _e1653[0][2]);
                                                                            let _e1818 = vec3<f32>(_e1653[1][0], _e1653[1][1], _e1653[1][2]);
                                                                            let _e1819 = vec3<f32>(_e1653[2][0], _e1653[2][1], _e1653[2][2]);
                                                                            let _e1820 = (_e1653[1][0] - _e1653[0][0]);
                                                                            let _e1821 = (_e1653[1][1] - _e1653[0][1]);
                                                                            let _e1822 = (_e1653[1][2] - _e1653[0][2]);
                                                                            let _e1823 = vec3<f32>(_e1820, _e1821, _e1822);
                                                                            let _e1824 = (_e1653[2][0] - _e1653[1][0]);
                                                                            let _e1825 = (_e1653[2][1] - _e1653[1][1]);
                                                                            let _e1826 = (_e1653[2][2] - _e1653[1][2]);
                                                                            let _e1827 = vec3<f32>(_e1824, _e1825, _e1826);
                                                                            let _e1828 = (_e1653[0][0] - _e1653[2][0]);
                                                                            let _e1829 = (_e1653[0][1] - _e1653[2][1]);
                                                                            let _e1830 = (_e1653[0][2] - _e1653[2][2]);
                                                                            let _e1831 = vec3<f32>(_e1828, _e1829, _e1830);
                                                                            let _e1834 = bitcast<f32>((bitcast<u32>(_e1820) & 2147483647u));
                                                                            let _e1837 = bitcast<f32>((bitcast<u32>(_e1821) & 2147483647u));
                                                                            let _e1839 = select(_e1837, _e1834, (_e1834 > _e1837));
                                                                            let _e1842 = bitcast<f32>((bitcast<u32>(_e1822) & 2147483647u));
                                                                            let _e1844 = select(_e1842, _e1839, (_e1839 > _e1842));
                                                                            let _e1847 = bitcast<f32>((bitcast<u32>(_e1824) & 2147483647u));
                                                                            let _e1850 = bitcast<f32>((bitcast<u32>(_e1825) & 2147483647u));
                                                                            let _e1852 = select(_e1850, _e1847, (_e1847 > _e1850));
                                                                            let _e1855 = bitcast<f32>((bitcast<u32>(_e1826) & 2147483647u));
                                                                            let _e1857 = select(_e1855, _e1852, (_e1852 > _e1855));
                                                                            let _e1860 = bitcast<f32>((bitcast<u32>(_e1828) & 2147483647u));
                                                                            let _e1863 = bitcast<f32>((bitcast<u32>(_e1829) & 2147483647u));
                                                                            let _e1865 = select(_e1863, _e1860, (_e1860 > _e1863));
                                                                            let _e1868 = bitcast<f32>((bitcast<u32>(_e1830) & 2147483647u));
                                                                            let _e1870 = select(_e1868, _e1865, (_e1865 > _e1868));
                                                                            let _e1872 = select(_e1857, _e1844, (_e1844 > _e1857));
                                                                            let _e1874 = select(_e1870, _e1872, (_e1872 > _e1870));
                                                                            if (_e1844 == _e1874) {
                                                                                phi_2685_ = _e1681;
                                                                                phi_2686_ = _e1678;
                                                                                phi_2687_ = _e1668;
                                                                                phi_2688_ = _e1665;
                                                                                phi_2689_ = _e1817;
                                                                                phi_2690_ = _e1831;
                                                                                phi_2691_ = _e1827;
                                                                                phi_2692_ = _e1823;
                                                                            } else {
                                                                                let _e1876 = (_e1857 == _e1874);
                                                                                let _e1881 = vec3(_e1876);
                                                                                phi_2685_ = select(_e1668, _e1694, _e1876);
                                                                                phi_2686_ = select(_e1665, _e1691, _e1876);
                                                                                phi_2687_ = select(_e1694, _e1681, _e1876);
                                                                                phi_2688_ = select(_e1691, _e1678, _e1876);
                                                                                phi_2689_ = select(_e1819, _e1818, _e1881);
                                                                                phi_2690_ = select(_e1827, _e1823, _e1881);
                                                                                phi_2691_ = select(_e1823, _e1831, _e1881);
                                                                                phi_2692_ = select(_e1831, _e1827, _e1881);
                                                                            }
                                                                            let _e1887 = phi_2685_;
                                                                            let _e1889 = phi_2686_;
                                                                            let _e1891 = phi_2687_;
                                                                            let _e1893 = phi_2688_;
                                                                            let _e1895 = phi_2689_;
                                                                            let _e1897 = phi_2690_;
                                                                            let _e1899 = phi_2691_;
                                                                            let _e1901 = phi_2692_;
                                                                            let _e1908 = ((_e1899.y * _e1897.z) - (_e1897.y * _e1899.z));
                                                                            let _e1913 = ((_e1899.z * _e1897.x) - (_e1897.z * _e1899.x));
                                                                            let _e1916 = ((_e1899.x * _e1897.y) - (_e1897.x * _e1899.y));
                                                                            if (_e1716 >= _e1720) {
                                                                                phi_2729_ = select(true, false, (_e1716 >= _e1724));
                                                                            } else {
                                                                                phi_2729_ = true;
                                                                            }
                                                                            let _e1921 = phi_2729_;
                                                                            if _e1921 {
                                                                                phi_2738_ = select(_e1819, _e1818, vec3((_e1720 >= _e1724)));
                                                                            } else {
                                                                                phi_2738_ = _e1817;
                                                                            }
                                                                            let _e1926 = phi_2738_;
                                                                            let _e1937 = (((_e1908 * (_e1926.x - _e325)) + (_e1913 * (_e1926.y - _e392))) + (_e1916 * (_e1926.z - _e458)));
                                                                            let _e1942 = (((_e1908 * _e365) + (_e1913 * _e431)) + (_e1916 * _e497));
                                                                            let _e1943 = (_e1889 - _e1893);
                                                                            let _e1944 = (_e1887 - _e1891);
                                                                            let _e1952 = (-(((_e1893 * _e1943) + (_e1891 * _e1944))) / ((_e1943 * _e1943) + (_e1944 * _e1944)));
                                                                            let _e1954 = select(1f, _e1952, (_e1952 < 1f));
                                                                            let _e1956 = select(0f, _e1954, (_e1954 > 0f));
                                                                            let _e1969 = ((_e1895.x + (_e1901.x * _e1956)) - _e325);
                                                                            let _e1970 = ((_e1895.y + (_e1901.y * _e1956)) - _e392);
                                                                            let _e1971 = ((_e1895.z + (_e1901.z * _e1956)) - _e458);
                                                                            let _e1972 = (_e1971 / _e497);
                                                                            let _e1984 = bitcast<f32>((bitcast<u32>(_e1969) & 2147483647u));
                                                                            let _e1987 = bitcast<f32>((bitcast<u32>(_e1970) & 2147483647u));
                                                                            let _e1989 = select(_e1987, _e1984, (_e1984 > _e1987));
                                                                            let _e1992 = bitcast<f32>((bitcast<u32>(_e1971) & 2147483647u));
                                                                            let _e1994 = select(_e1992, _e1989, (_e1989 > _e1992));
                                                                            let _e2000 = bitcast<f32>((bitcast<u32>(_e1908) & 2147483647u));
                                                                            let _e2003 = bitcast<f32>((bitcast<u32>(_e1913) & 2147483647u));
                                                                            let _e2005 = select(_e2003, _e2000, (_e2000 > _e2003));
                                                                            let _e2008 = bitcast<f32>((bitcast<u32>(_e1916) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1908 * _e1969) + (_e1913 * _e1970)) + (_e1916 * _e1971)) - _e1937)) & 2147483647u)) <= ((0.0000009536743f * select(_e1874, _e1994, (_e1994 > _e1874))) * select(_e2008, _e2005, (_e2005 > _e2008)))) {
                                                                                let _e2018 = bitcast<f32>((bitcast<u32>(_e1899.x) & 2147483647u));
                                                                                let _e2021 = bitcast<f32>((bitcast<u32>(_e1899.y) & 2147483647u));
                                                                                let _e2023 = select(_e2021, _e2018, (_e2018 > _e2021));
                                                                                let _e2026 = bitcast<f32>((bitcast<u32>(_e1899.z) & 2147483647u));
                                                                                let _e2032 = bitcast<f32>((bitcast<u32>(_e1897.x) & 2147483647u));
                                                                                let _e2035 = bitcast<f32>((bitcast<u32>(_e1897.y) & 2147483647u));
                                                                                let _e2037 = select(_e2035, _e2032, (_e2032 > _e2035));
                                                                                let _e2040 = bitcast<f32>((bitcast<u32>(_e1897.z) & 2147483647u));
                                                                                let _e2044 = (bitcast<f32>((bitcast<u32>(_e1942) & 2147483647u)) > ((0.0000038146973f * select(_e2026, _e2023, (_e2023 > _e2026))) * select(_e2040, _e2037, (_e2037 > _e2040))));
                                                                                if _e2044 {
                                                                                    phi_2903_ = (_e1937 / _e1942);
                                                                                } else {
                                                                                    phi_2903_ = f32();
                                                                                }
                                                                                let _e2047 = phi_2903_;
                                                                                phi_2905_ = _e2047;
                                                                                phi_2906_ = select(true, false, _e2044);
                                                                            } else {
                                                                                phi_2905_ = f32();
                                                                                phi_2906_ = true;
                                                                            }
                                                                            let _e2050 = phi_2905_;
                                                                            let _e2052 = phi_2906_;
                                                                            if _e2052 {
                                                                                let _e2060 = (((_e1908 * (_e1969 - (_e365 * _e1972))) + (_e1913 * (_e1970 - (_e431 * _e1972)))) / _e1942);
                                                                                if (bitcast<f32>((bitcast<u32>(_e2060) & 2147483647u)) <= _e1874) {
                                                                                    phi_2926_ = (_e1972 + _e2060);
                                                                                } else {
                                                                                    phi_2926_ = _e1972;
                                                                                }
                                                                                let _e2067 = phi_2926_;
                                                                                phi_2927_ = _e2067;
                                                                            } else {
                                                                                phi_2927_ = _e2050;
                                                                            }
                                                                            let _e2069 = phi_2927_;
                                                                            let _e2071 = select(_e1807, _e2069, (_e2069 < _e1807));
                                                                            let _e2073 = select(_e1799, _e2071, (_e2071 > _e1799));
                                                                            if (_e2073 >= _e611) {
                                                                                let _e2075 = (_e2073 <= _e1200.member.member_1);
                                                                                if _e2075 {
                                                                                    let _e2076 = (1f / _e1726);
                                                                                    phi_2950_ = type_18(_e2073, (_e1720 * _e2076), (_e1724 * _e2076), _e1266);
                                                                                } else {
                                                                                    phi_2950_ = type_18();
                                                                                }
                                                                                let _e2081 = phi_2950_;
                                                                                phi_2952_ = _e2081;
                                                                                phi_2953_ = select(true, false, _e2075);
                                                                            } else {
                                                                                phi_2952_ = type_18();
                                                                                phi_2953_ = true;
                                                                            }
                                                                            let _e2084 = phi_2952_;
                                                                            let _e2086 = phi_2953_;
                                                                            if _e2086 {
                                                                                phi_2957_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2957_ = _e2084;
                                                                            }
                                                                            let _e2088 = phi_2957_;
                                                                            phi_2958_ = _e2088;
                                                                        }
                                                                        let _e2090 = phi_2958_;
                                                                        phi_2959_ = _e2090;
                                                                        phi_2960_ = _e1816;
                                                                    }
                                                                    let _e2092 = phi_2959_;
                                                                    let _e2094 = phi_2960_;
                                                                    phi_2964_ = _e2092;
                                                                    phi_2965_ = _e2094;
                                                                }
                                                                let _e2096 = phi_2964_;
                                                                let _e2098 = phi_2965_;
                                                                phi_2966_ = _e2096;
                                                                phi_2967_ = _e1751;
                                                                phi_2968_ = _e2098;
                                                            }
                                                            let _e2100 = phi_2966_;
                                                            let _e2102 = phi_2967_;
                                                            let _e2104 = phi_2968_;
                                                            phi_2969_ = _e2100;
                                                            phi_2970_ = _e2102;
                                                            phi_2971_ = _e2104;
                                                        }
                                                        let _e2106 = phi_2969_;
                                                        let _e2108 = phi_2970_;
                                                        let _e2110 = phi_2971_;
                                                        phi_2979_ = _e2106;
                                                        phi_2980_ = select(_e2110, true, _e2108);
                                                    } else {
                                                        phi_2979_ = type_18();
                                                        phi_2980_ = true;
                                                    }
                                                    let _e2113 = phi_2979_;
                                                    let _e2115 = phi_2980_;
                                                    if _e2115 {
                                                        phi_2984_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2984_ = _e2113;
                                                    }
                                                    let _e2117 = phi_2984_;
                                                    if (_e2117.member_3 != 4294967295u) {
                                                        if (_e1266 != _e617) {
                                                            if (_e2117.member < _e1200.member.member.member) {
                                                                phi_3010_ = true;
                                                            } else {
                                                                if (_e2117.member == _e1200.member.member.member) {
                                                                    phi_3009_ = (_e2117.member_3 < _e1200.member.member.member_3);
                                                                } else {
                                                                    phi_3009_ = false;
                                                                }
                                                                let _e2132 = phi_3009_;
                                                                phi_3010_ = _e2132;
                                                            }
                                                            let _e2134 = phi_3010_;
                                                            if _e2134 {
                                                                phi_3017_ = type_38(type_35(_e2117, _e2117.member), _e1227.member_1, _e1227.member_2);
                                                            } else {
                                                                phi_3017_ = _e1227;
                                                            }
                                                            let _e2141 = phi_3017_;
                                                            phi_3018_ = _e2141;
                                                        } else {
                                                            phi_3018_ = _e1227;
                                                        }
                                                        let _e2143 = phi_3018_;
                                                        phi_3019_ = _e2143;
                                                    } else {
                                                        phi_3019_ = _e1227;
                                                    }
                                                    let _e2145 = phi_3019_;
                                                    phi_1319_ = _e2145;
                                                } else {
                                                    phi_1319_ = type_38();
                                                }
                                                let _e2147 = phi_1319_;
                                                continue;
                                                continuing {
                                                    phi_1318_ = _e2147;
                                                    phi_1321_ = _e1215;
                                                    phi_4777_ = _e658;
                                                    break if !(_e1221);
                                                }
                                            }
                                            let _e2150 = phi_4777_;
                                            phi_4984_ = _e2150;
                                            if _e2150 {
                                                break;
                                            }
                                            phi_4988_ = _e2150;
                                            let _e2519 = local_12;
                                            phi_4294_ = _e2519;
                                            phi_4295_ = false;
                                            phi_4296_ = _e702;
                                            phi_4297_ = _e704;
                                        } else {
                                            if (_e704.member_1 >= _e97) {
                                                phi_3825_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e704.member_1 < _e97) {
                                                } else {
                                                    phi_4984_ = true;
                                                    break;
                                                }
                                                let _e716 = (_e278 * 2u);
                                                let _e718 = ((1u + _e716) % 7u);
                                                if (_e718 < 7u) {
                                                } else {
                                                    phi_4984_ = true;
                                                    break;
                                                }
                                                let _e723 = global_6.member[_e704.member_1][_e718];
                                                let _e725 = ((_e716 + 2u) % 7u);
                                                if (_e725 < 7u) {
                                                } else {
                                                    phi_4984_ = true;
                                                    break;
                                                }
                                                let _e730 = global_6.member[_e704.member_1][_e725];
                                                let _e731 = (_e277 * 2u);
                                                let _e733 = ((1u + _e731) % 7u);
                                                if (_e733 < 7u) {
                                                } else {
                                                    phi_4984_ = true;
                                                    break;
                                                }
                                                let _e738 = global_6.member[_e704.member_1][_e733];
                                                let _e740 = ((_e731 + 2u) % 7u);
                                                if (_e740 < 7u) {
                                                } else {
                                                    phi_4984_ = true;
                                                    break;
                                                }
                                                let _e745 = global_6.member[_e704.member_1][_e740];
                                                let _e746 = (_e279 * 2u);
                                                let _e748 = ((1u + _e746) % 7u);
                                                if (_e748 < 7u) {
                                                } else {
                                                    phi_4984_ = true;
                                                    break;
                                                }
                                                let _e753 = global_6.member[_e704.member_1][_e748];
                                                let _e755 = ((_e746 + 2u) % 7u);
                                                if (_e755 < 7u) {
                                                } else {
                                                    phi_4984_ = true;
                                                    break;
                                                }
                                                let _e760 = global_6.member[_e704.member_1][_e755];
                                                let _e783 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.x - _e704.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e784 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.y - _e704.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e785 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.z - _e704.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e787 = select(_e152, _e783, (_e783 > _e152));
                                                let _e789 = select(_e152, _e784, (_e784 > _e152));
                                                let _e791 = select(_e152, _e785, (_e785 > _e152));
                                                let _e822 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e723 & 2097151u))) - 8388608f) * _e787));
                                                let _e827 = (bitcast<i32>((_e723 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e830 = bitcast<f32>((_e822 & bitcast<u32>(_e827)));
                                                let _e831 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e738 & 2097151u))) - 8388608f) * _e789));
                                                let _e836 = (bitcast<i32>((_e738 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e839 = bitcast<f32>((_e831 & bitcast<u32>(_e836)));
                                                let _e840 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e753 & 2097151u))) - 8388608f) * _e791));
                                                let _e845 = (bitcast<i32>((_e753 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e848 = bitcast<f32>((_e840 & bitcast<u32>(_e845)));
                                                let _e852 = bitcast<f32>((_e822 & bitcast<u32>(~(_e827))));
                                                let _e856 = bitcast<f32>((_e831 & bitcast<u32>(~(_e836))));
                                                let _e860 = bitcast<f32>((_e840 & bitcast<u32>(~(_e845))));
                                                let _e861 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e730 & 2097151u))) - 8388608f) * _e787));
                                                let _e866 = (bitcast<i32>((_e730 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e869 = bitcast<f32>((_e861 & bitcast<u32>(_e866)));
                                                let _e870 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e745 & 2097151u))) - 8388608f) * _e789));
                                                let _e875 = (bitcast<i32>((_e745 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e878 = bitcast<f32>((_e870 & bitcast<u32>(_e875)));
                                                let _e879 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e760 & 2097151u))) - 8388608f) * _e791));
                                                let _e884 = (bitcast<i32>((_e760 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e887 = bitcast<f32>((_e879 & bitcast<u32>(_e884)));
                                                let _e891 = bitcast<f32>((_e861 & bitcast<u32>(~(_e866))));
                                                let _e895 = bitcast<f32>((_e870 & bitcast<u32>(~(_e875))));
                                                let _e899 = bitcast<f32>((_e879 & bitcast<u32>(~(_e884))));
                                                let _e900 = (_e704.member.member.x + _e830);
                                                let _e901 = (_e704.member.member.y + _e839);
                                                let _e902 = (_e704.member.member.z + _e848);
                                                let _e905 = (_e704.member.member_1.x - _e869);
                                                let _e906 = (_e704.member.member_1.y - _e878);
                                                let _e907 = (_e704.member.member_1.z - _e887);
                                                let _e926 = (_e905 - _e900);
                                                let _e927 = (_e906 - _e901);
                                                let _e928 = (_e907 - _e902);
                                                let _e930 = select(_e927, _e926, (_e926 > _e927));
                                                let _e932 = select(_e928, _e930, (_e930 > _e928));
                                                if (_e932 < (1024f * _e152)) {
                                                    phi_3526_ = 0u;
                                                } else {
                                                    phi_3526_ = select(2u, 1u, (_e932 < (2097152f * _e152)));
                                                }
                                                let _e939 = phi_3526_;
                                                switch bitcast<i32>(_e939) {
                                                    case 0: {
                                                        phi_3532_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3532_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3532_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3532_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e942 = phi_3532_;
                                                let _e948 = global_6.member[_e704.member_1][0u];
                                                let _e952 = global_6.member[_e704.member_1][2u];
                                                let _e956 = global_6.member[_e704.member_1][4u];
                                                let _e960 = global_6.member[_e704.member_1][6u];
                                                let _e972 = (((_e952 >> bitcast<u32>(22i)) | ((_e956 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e960 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e973 = (_e948 & 268435455u);
                                                let _e974 = (_e972 & 268435455u);
                                                let _e977 = ((_e948 >> bitcast<u32>(28u)) & 7u);
                                                let _e985 = ((_e948 >> bitcast<u32>(31i)) | (((_e972 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e986 = (_e977 != 0u);
                                                if (_e977 == 0u) {
                                                    phi_3787_ = _e973;
                                                } else {
                                                    if (_e977 == 7u) {
                                                        phi_3786_ = 2147483648u;
                                                    } else {
                                                        phi_3786_ = ((2147483648u | (_e977 << bitcast<u32>(28u))) | (_e974 & 268435455u));
                                                    }
                                                    let _e995 = phi_3786_;
                                                    phi_3787_ = _e995;
                                                }
                                                let _e997 = phi_3787_;
                                                if _e986 {
                                                    let _e998 = (_e977 != 7u);
                                                    if _e998 {
                                                        phi_3797_ = (_e974 + (_e977 * ((3u * _e942) + 1u)));
                                                    } else {
                                                        phi_3797_ = u32();
                                                    }
                                                    let _e1002 = phi_3797_;
                                                    phi_3799_ = _e1002;
                                                    phi_3800_ = select(true, false, _e998);
                                                } else {
                                                    phi_3799_ = u32();
                                                    phi_3800_ = true;
                                                }
                                                let _e1005 = phi_3799_;
                                                let _e1007 = phi_3800_;
                                                if (_e985 == 0u) {
                                                    phi_3821_ = (_e973 + select(0u, 1u, !(_e986)));
                                                } else {
                                                    if (_e985 == 7u) {
                                                        phi_3820_ = 2147483648u;
                                                    } else {
                                                        phi_3820_ = ((2147483648u | (_e985 << bitcast<u32>(28u))) | (select(_e1005, _e974, _e1007) & 268435455u));
                                                    }
                                                    let _e1020 = phi_3820_;
                                                    phi_3821_ = _e1020;
                                                }
                                                let _e1022 = phi_3821_;
                                                phi_3825_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e900, (_e704.member.member.x + _e852), _e905, (_e704.member.member_1.x - _e891)), vec4<f32>(_e901, (_e704.member.member.y + _e856), _e906, (_e704.member.member_1.y - _e895)), vec4<f32>(_e902, (_e704.member.member.z + _e860), _e907, (_e704.member.member_1.z - _e899))), type_49(type_30((_e704.member.member + vec4<f32>(_e830, _e839, _e848, 0f)), (_e704.member.member_1 - vec4<f32>(_e869, _e878, _e887, 0f))), _e997), type_49(type_30((_e704.member.member + vec4<f32>(_e852, _e856, _e860, 0f)), (_e704.member.member_1 - vec4<f32>(_e891, _e895, _e899, 0f))), _e1022));
                                            }
                                            let _e1027 = phi_3825_;
                                            let _e1046 = ((_e1027.member[0].x - _e363) * _e368);
                                            let _e1047 = ((_e1027.member[0].y - _e363) * _e368);
                                            let _e1048 = ((_e1027.member[0].z - _e364) * _e368);
                                            let _e1049 = ((_e1027.member[0].w - _e364) * _e368);
                                            let _e1059 = ((_e1027.member[1].x - _e429) * _e434);
                                            let _e1060 = ((_e1027.member[1].y - _e429) * _e434);
                                            let _e1061 = ((_e1027.member[1].z - _e430) * _e434);
                                            let _e1062 = ((_e1027.member[1].w - _e430) * _e434);
                                            let _e1072 = ((_e1027.member[2].x - _e495) * _e500);
                                            let _e1073 = ((_e1027.member[2].y - _e495) * _e500);
                                            let _e1074 = ((_e1027.member[2].z - _e496) * _e500);
                                            let _e1075 = ((_e1027.member[2].w - _e496) * _e500);
                                            let _e1077 = select(_e1074, _e1072, (_e1072 < _e1074));
                                            let _e1079 = select(_e1075, _e1073, (_e1073 < _e1075));
                                            let _e1081 = select(_e1074, _e1072, (_e1072 > _e1074));
                                            let _e1083 = select(_e1075, _e1073, (_e1073 > _e1075));
                                            let _e1085 = select(_e1048, _e1046, (_e1046 < _e1048));
                                            let _e1087 = select(_e1049, _e1047, (_e1047 < _e1049));
                                            let _e1089 = select(_e1061, _e1059, (_e1059 < _e1061));
                                            let _e1091 = select(_e1062, _e1060, (_e1060 < _e1062));
                                            let _e1093 = select(_e1089, _e1085, (_e1085 > _e1089));
                                            let _e1095 = select(_e1091, _e1087, (_e1087 > _e1091));
                                            let _e1097 = select(_e1077, _e1093, (_e1093 > _e1077));
                                            let _e1099 = select(_e1079, _e1095, (_e1095 > _e1079));
                                            let _e1101 = select(_e1048, _e1046, (_e1046 > _e1048));
                                            let _e1103 = select(_e1049, _e1047, (_e1047 > _e1049));
                                            let _e1105 = select(_e1061, _e1059, (_e1059 > _e1061));
                                            let _e1107 = select(_e1062, _e1060, (_e1060 > _e1062));
                                            let _e1109 = select(_e1105, _e1101, (_e1101 < _e1105));
                                            let _e1111 = select(_e1107, _e1103, (_e1103 < _e1107));
                                            let _e1116 = -(_e1077);
                                            let _e1117 = -(_e1079);
                                            let _e1124 = (select(_e1081, _e1109, (_e1109 < _e1081)) + (select(_e1116, _e1081, (_e1081 > _e1116)) * 0.0000019073523f));
                                            let _e1125 = (select(_e1083, _e1111, (_e1111 < _e1083)) + (select(_e1117, _e1083, (_e1083 > _e1117)) * 0.0000019073523f));
                                            let _e1127 = select(_e611, _e1097, (_e1097 > _e611));
                                            let _e1129 = select(_e611, _e1099, (_e1099 > _e611));
                                            let _e1134 = (_e1127 <= select(_e660.member.member_1, _e1124, (_e1124 < _e660.member.member_1)));
                                            let _e1135 = (_e1129 <= select(_e660.member.member_1, _e1125, (_e1125 < _e660.member.member_1)));
                                            let _e1136 = (_e1127 <= _e1129);
                                            if _e1134 {
                                                if _e1135 {
                                                    if _e1136 {
                                                        phi_4190_ = _e1027.member_2;
                                                    } else {
                                                        phi_4190_ = _e1027.member_1;
                                                    }
                                                    let _e1140 = phi_4190_;
                                                    let _e1162 = (_e702 % 128u);
                                                    let _e1163 = (_e1162 < 128u);
                                                    if _e1163 {
                                                    } else {
                                                        phi_4984_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1162] = _e1140.member_1;
                                                    if _e1163 {
                                                    } else {
                                                        phi_4984_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1162] = _e1140.member.member.x;
                                                    if _e1163 {
                                                    } else {
                                                        phi_4984_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1162] = _e1140.member.member.y;
                                                    if _e1163 {
                                                    } else {
                                                        phi_4984_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1162] = _e1140.member.member.z;
                                                    if _e1163 {
                                                    } else {
                                                        phi_4984_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1162] = _e1140.member.member_1.x;
                                                    if _e1163 {
                                                    } else {
                                                        phi_4984_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1162] = _e1140.member.member_1.y;
                                                    if _e1163 {
                                                    } else {
                                                        phi_4984_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1162] = _e1140.member.member_1.z;
                                                    if _e1163 {
                                                    } else {
                                                        phi_4984_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1162] = select(_e1129, _e1127, !(_e1136));
                                                    if _e1136 {
                                                        phi_4267_ = _e1027.member_1;
                                                    } else {
                                                        phi_4267_ = _e1027.member_2;
                                                    }
                                                    let _e1176 = phi_4267_;
                                                    phi_4268_ = (_e702 + 1u);
                                                    phi_4269_ = _e1176;
                                                } else {
                                                    phi_4268_ = u32();
                                                    phi_4269_ = type_49();
                                                }
                                                let _e1178 = phi_4268_;
                                                let _e1180 = phi_4269_;
                                                phi_4271_ = _e1178;
                                                phi_4272_ = _e1180;
                                                phi_4273_ = select(true, false, _e1135);
                                            } else {
                                                phi_4271_ = u32();
                                                phi_4272_ = type_49();
                                                phi_4273_ = true;
                                            }
                                            let _e1183 = phi_4271_;
                                            let _e1185 = phi_4272_;
                                            let _e1187 = phi_4273_;
                                            if _e1187 {
                                                if _e1134 {
                                                    phi_4282_ = _e1027.member_1;
                                                } else {
                                                    phi_4282_ = _e1027.member_2;
                                                }
                                                let _e1191 = phi_4282_;
                                                phi_4287_ = select(_e1135, true, _e1134);
                                                phi_4289_ = _e1191;
                                            } else {
                                                phi_4287_ = _e700;
                                                phi_4289_ = _e1185;
                                            }
                                            let _e1194 = phi_4287_;
                                            let _e1196 = phi_4289_;
                                            phi_4988_ = _e658;
                                            phi_4294_ = type_38(_e660.member, (_e660.member_1 + 1u), _e660.member_2);
                                            phi_4295_ = _e1194;
                                            phi_4296_ = select(_e1183, _e702, _e1187);
                                            phi_4297_ = _e1196;
                                        }
                                        let _e2152 = phi_4988_;
                                        let _e2154 = phi_4294_;
                                        let _e2156 = phi_4295_;
                                        let _e2158 = phi_4296_;
                                        let _e2160 = phi_4297_;
                                        phi_4987_ = _e2152;
                                        phi_4298_ = _e2154;
                                        phi_4299_ = _e2156;
                                        phi_4300_ = (_e664 - 1u);
                                        phi_4301_ = _e2158;
                                        phi_4302_ = _e2160;
                                    } else {
                                        phi_4987_ = _e658;
                                        phi_4298_ = _e660;
                                        phi_4299_ = _e700;
                                        phi_4300_ = _e664;
                                        phi_4301_ = _e702;
                                        phi_4302_ = _e704;
                                    }
                                    let _e2162 = phi_4987_;
                                    let _e2164 = phi_4298_;
                                    let _e2166 = phi_4299_;
                                    let _e2168 = phi_4300_;
                                    let _e2170 = phi_4301_;
                                    let _e2172 = phi_4302_;
                                    phi_4986_ = _e2162;
                                    phi_4303_ = _e2164;
                                    phi_4304_ = _e2166;
                                    phi_4305_ = _e2168;
                                    phi_4306_ = _e2170;
                                    phi_4307_ = _e2172;
                                } else {
                                    phi_4986_ = _e658;
                                    phi_4303_ = type_38();
                                    phi_4304_ = bool();
                                    phi_4305_ = u32();
                                    phi_4306_ = u32();
                                    phi_4307_ = type_49();
                                }
                                let _e2174 = phi_4986_;
                                let _e2176 = phi_4303_;
                                let _e2178 = phi_4304_;
                                let _e2180 = phi_4305_;
                                let _e2182 = phi_4306_;
                                let _e2184 = phi_4307_;
                                phi_4985_ = _e2174;
                                phi_1192_ = _e2176;
                                phi_1195_ = _e2178;
                                phi_1197_ = _e2180;
                                phi_1199_ = _e2182;
                                phi_1201_ = _e2184;
                                phi_4308_ = _e672;
                            } else {
                                phi_4985_ = _e658;
                                phi_1192_ = type_38();
                                phi_1195_ = bool();
                                phi_1197_ = u32();
                                phi_1199_ = u32();
                                phi_1201_ = type_49();
                                phi_4308_ = false;
                            }
                            let _e2186 = phi_4985_;
                            let _e2188 = phi_1192_;
                            let _e2190 = phi_1195_;
                            let _e2192 = phi_1197_;
                            let _e2194 = phi_1199_;
                            let _e2196 = phi_1201_;
                            let _e2198 = phi_4308_;
                            continue;
                            continuing {
                                phi_4783_ = _e2186;
                                phi_1191_ = _e2188;
                                phi_1194_ = _e2190;
                                phi_1196_ = _e2192;
                                phi_1198_ = _e2194;
                                phi_1200_ = _e2196;
                                phi_4984_ = _e2186;
                                break if !(_e2198);
                            }
                        }
                        let _e2201 = phi_4984_;
                        if _e2201 {
                            break;
                        }
                        let _e2203 = local_10;
                        if (_e2203.member.member.member_3 != 4294967295u) {
                            let _e2209 = bitcast<u32>(_e2203.member.member.member);
                            let _e2213 = (bitcast<i32>((_e2209 >> bitcast<u32>(23i))) & 255i);
                            let _e2214 = (_e2213 + _e280);
                            if (_e2213 == 255i) {
                                phi_4367_ = _e2203.member.member.member;
                            } else {
                                if (_e2213 > 0i) {
                                    if (_e2214 > 0i) {
                                        let _e2218 = (_e2214 < 255i);
                                        if _e2218 {
                                            phi_4346_ = bitcast<f32>((_e2209 + bitcast<u32>((_e280 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_4346_ = f32();
                                        }
                                        let _e2225 = phi_4346_;
                                        phi_4348_ = _e2225;
                                        phi_4349_ = select(true, false, _e2218);
                                    } else {
                                        phi_4348_ = f32();
                                        phi_4349_ = true;
                                    }
                                    let _e2228 = phi_4348_;
                                    let _e2230 = phi_4349_;
                                    phi_4350_ = _e2228;
                                    phi_4351_ = _e2230;
                                } else {
                                    phi_4350_ = f32();
                                    phi_4351_ = true;
                                }
                                let _e2232 = phi_4350_;
                                let _e2234 = phi_4351_;
                                if _e2234 {
                                    let _e2235 = (_e2209 & 2147483648u);
                                    let _e2242 = ((_e2209 & 8388607u) | (select(0u, 1u, ((_e2209 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e2246 = (_e2242 == 0u);
                                    if _e2246 {
                                        phi_4735_ = bitcast<f32>(_e2235);
                                    } else {
                                        let _e2251 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2242)), 32u, _e2246) - 8u);
                                        let _e2254 = (_e2242 << bitcast<u32>((_e2251 & 31u)));
                                        let _e2256 = ((_e2214 + select(0i, 1i, (_e2213 == 0i))) - bitcast<i32>(_e2251));
                                        if (_e2256 >= 255i) {
                                            phi_4725_ = bitcast<f32>((_e2235 | 2139095040u));
                                            phi_4726_ = f32();
                                            phi_4727_ = true;
                                        } else {
                                            let _e2258 = (_e2256 > 0i);
                                            if _e2258 {
                                                phi_4719_ = bitcast<f32>(((_e2235 | (bitcast<u32>(_e2256) << bitcast<u32>(23i))) | (_e2254 & 8388607u)));
                                                phi_4720_ = f32();
                                            } else {
                                                if (_e2256 < -24i) {
                                                    phi_4685_ = 26u;
                                                } else {
                                                    phi_4685_ = bitcast<u32>((1i - _e2256));
                                                }
                                                let _e2263 = phi_4685_;
                                                let _e2264 = (_e2263 & 31u);
                                                let _e2266 = (_e2254 >> bitcast<u32>(_e2264));
                                                let _e2270 = (_e2254 & ((1u << bitcast<u32>(_e2264)) - 1u));
                                                let _e2274 = (1u << bitcast<u32>(((_e2263 - 1u) & 31u)));
                                                if (_e2270 > _e2274) {
                                                    phi_4706_ = true;
                                                } else {
                                                    if (_e2270 == _e2274) {
                                                        phi_4703_ = ((_e2266 & 1u) == 1u);
                                                    } else {
                                                        phi_4703_ = false;
                                                    }
                                                    let _e2280 = phi_4703_;
                                                    phi_4706_ = _e2280;
                                                }
                                                let _e2282 = phi_4706_;
                                                phi_4719_ = f32();
                                                phi_4720_ = bitcast<f32>((_e2235 | (_e2266 + select(0u, 1u, _e2282))));
                                            }
                                            let _e2295 = phi_4719_;
                                            let _e2297 = phi_4720_;
                                            phi_4725_ = _e2295;
                                            phi_4726_ = _e2297;
                                            phi_4727_ = _e2258;
                                        }
                                        let _e2301 = phi_4725_;
                                        let _e2303 = phi_4726_;
                                        let _e2305 = phi_4727_;
                                        phi_4735_ = select(_e2303, _e2301, _e2305);
                                    }
                                    let _e2309 = phi_4735_;
                                    phi_4366_ = _e2309;
                                } else {
                                    phi_4366_ = _e2232;
                                }
                                let _e2311 = phi_4366_;
                                phi_4367_ = _e2311;
                            }
                            let _e2313 = phi_4367_;
                            let _e2314 = bitcast<u32>(_e2313);
                            if ((_e2314 & 2147483647u) >= 2139095040u) {
                                phi_4379_ = bitcast<f32>(((_e2314 & 2147483648u) | 2139095039u));
                            } else {
                                phi_4379_ = _e2313;
                            }
                            let _e2321 = phi_4379_;
                            phi_4384_ = type_18(_e2321, _e2203.member.member.member_1, _e2203.member.member.member_2, _e2203.member.member.member_3);
                        } else {
                            phi_4384_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e2326 = phi_4384_;
                        if _e156 {
                        } else {
                            break;
                        }
                        global_1.member[_e140] = _e2326;
                        let _e2330 = local_11;
                        if _e157 {
                        } else {
                            break;
                        }
                        global_4.member[_e140] = _e2330.member_1;
                        if _e155 {
                        } else {
                            break;
                        }
                        let _e2335 = select(0u, 1u, (_e224 <= _e234));
                        if (_e2335 > 0u) {
                            let _e2337 = (1u < _e108);
                            if _e2337 {
                                if (0u < _e108) {
                                } else {
                                    break;
                                }
                                let _e2341 = atomicAdd((&global_5.member[0u]), _e2335);
                                if ((_e2341 + _e2335) < _e2341) {
                                    if _e2337 {
                                    } else {
                                        break;
                                    }
                                    let _e2346 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e2349 = select(0u, 1u, (_e2326.member_3 != 4294967295u));
                        if (_e2349 > 0u) {
                            let _e2351 = (3u < _e108);
                            if _e2351 {
                                if (2u < _e108) {
                                } else {
                                    break;
                                }
                                let _e2355 = atomicAdd((&global_5.member[2u]), _e2349);
                                if ((_e2355 + _e2349) < _e2355) {
                                    if _e2351 {
                                    } else {
                                        break;
                                    }
                                    let _e2360 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e2330.member_1 > 0u) {
                            let _e2362 = (5u < _e108);
                            if _e2362 {
                                if (4u < _e108) {
                                } else {
                                    break;
                                }
                                let _e2366 = atomicAdd((&global_5.member[4u]), _e2330.member_1);
                                if ((_e2366 + _e2330.member_1) < _e2366) {
                                    if _e2362 {
                                    } else {
                                        break;
                                    }
                                    let _e2371 = atomicAdd((&global_5.member[5u]), 1u);
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
fn trace_paths_counted_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
