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
    var phi_4789_: bool;
    var phi_1191_: type_38;
    var phi_1194_: u32;
    var phi_1196_: bool;
    var phi_1198_: u32;
    var phi_1200_: type_49;
    var phi_1211_: bool;
    var phi_1297_: bool;
    var phi_1298_: u32;
    var phi_1299_: type_49;
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
    var phi_4783_: bool;
    var phi_5081_: bool;
    var phi_3020_: type_38;
    var phi_3522_: u32;
    var phi_3528_: u32;
    var phi_3782_: u32;
    var phi_3783_: u32;
    var phi_3793_: u32;
    var phi_3795_: u32;
    var phi_3796_: bool;
    var phi_3816_: u32;
    var phi_3817_: u32;
    var phi_3821_: type_50;
    var phi_4186_: type_49;
    var phi_4262_: type_49;
    var phi_4263_: u32;
    var phi_4264_: type_49;
    var phi_4266_: u32;
    var phi_4267_: type_49;
    var phi_4268_: bool;
    var phi_4277_: type_49;
    var phi_4282_: bool;
    var phi_4284_: type_49;
    var phi_4289_: type_38;
    var phi_4290_: bool;
    var phi_4291_: u32;
    var phi_4292_: type_49;
    var phi_4300_: type_38;
    var phi_4303_: type_49;
    var phi_4993_: bool;
    var phi_4304_: type_38;
    var phi_4305_: u32;
    var phi_4306_: bool;
    var phi_4307_: u32;
    var phi_4308_: type_49;
    var phi_4992_: bool;
    var phi_4309_: type_38;
    var phi_4310_: u32;
    var phi_4311_: bool;
    var phi_4312_: u32;
    var phi_4313_: type_49;
    var phi_4991_: bool;
    var phi_1192_: type_38;
    var phi_1195_: u32;
    var phi_1197_: bool;
    var phi_1199_: u32;
    var phi_1201_: type_49;
    var phi_4314_: bool;
    var phi_4990_: bool;
    var local_10: type_38;
    var phi_4352_: f32;
    var phi_4354_: f32;
    var phi_4355_: bool;
    var phi_4356_: f32;
    var phi_4357_: bool;
    var phi_4691_: u32;
    var phi_4709_: bool;
    var phi_4712_: bool;
    var phi_4725_: f32;
    var phi_4726_: f32;
    var phi_4731_: f32;
    var phi_4732_: f32;
    var phi_4733_: bool;
    var phi_4741_: f32;
    var phi_4372_: f32;
    var phi_4373_: f32;
    var phi_4385_: f32;
    var phi_4390_: type_18;
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
                        phi_4789_ = false;
                        phi_1191_ = type_38(type_35(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e609), 0u, 0u);
                        phi_1194_ = ((3u * _e97) + 1u);
                        phi_1196_ = (_e611 <= _e609);
                        phi_1198_ = 0u;
                        phi_1200_ = type_49(type_30(vec4<f32>((f32(_e623) * _e152), (f32(_e629) * _e152), (f32(_e635) * _e152), 0f), vec4<f32>((f32(_e640) * _e152), (f32(_e644) * _e152), (f32(_e648) * _e152), 0f)), select(0u, 2147483648u, (_e97 == 0u)));
                        loop {
                            let _e658 = phi_4789_;
                            let _e660 = phi_1191_;
                            let _e662 = phi_1194_;
                            let _e664 = phi_1196_;
                            let _e666 = phi_1198_;
                            let _e668 = phi_1200_;
                            local_10 = _e660;
                            local_11 = _e660;
                            if _e664 {
                                phi_1211_ = true;
                            } else {
                                phi_1211_ = (_e666 > 0u);
                            }
                            let _e671 = phi_1211_;
                            if _e671 {
                                let _e672 = (_e662 > 0u);
                                if _e672 {
                                    if _e664 {
                                        phi_1297_ = _e664;
                                        phi_1298_ = _e666;
                                        phi_1299_ = _e668;
                                    } else {
                                        let _e673 = (_e666 - 1u);
                                        let _e674 = (_e673 % 128u);
                                        let _e675 = (_e674 < 128u);
                                        if _e675 {
                                        } else {
                                            phi_4990_ = true;
                                            break;
                                        }
                                        let _e677 = local_7[_e674];
                                        if _e675 {
                                        } else {
                                            phi_4990_ = true;
                                            break;
                                        }
                                        let _e679 = local_6[_e674];
                                        if _e675 {
                                        } else {
                                            phi_4990_ = true;
                                            break;
                                        }
                                        let _e681 = local_5[_e674];
                                        if _e675 {
                                        } else {
                                            phi_4990_ = true;
                                            break;
                                        }
                                        let _e683 = local_4[_e674];
                                        if _e675 {
                                        } else {
                                            phi_4990_ = true;
                                            break;
                                        }
                                        let _e685 = local_3[_e674];
                                        if _e675 {
                                        } else {
                                            phi_4990_ = true;
                                            break;
                                        }
                                        let _e687 = local_2[_e674];
                                        if _e675 {
                                        } else {
                                            phi_4990_ = true;
                                            break;
                                        }
                                        let _e692 = local_8[_e674];
                                        if _e675 {
                                        } else {
                                            phi_4990_ = true;
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
                                        let _e708 = ((_e704.member_1 & 2147483648u) != 0u);
                                        let _e709 = (_e704.member_1 & 268435455u);
                                        if _e708 {
                                            phi_1318_ = _e660;
                                            phi_1321_ = type_8(0u, ((_e704.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e716 = phi_1318_;
                                                let _e718 = phi_1321_;
                                                local_12 = _e716;
                                                if (_e718.member < _e718.member_1) {
                                                    phi_1322_ = type_8((_e718.member + 1u), _e718.member_1);
                                                    phi_1344_ = type_8(1u, _e718.member);
                                                } else {
                                                    phi_1322_ = _e718;
                                                    phi_1344_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e731 = phi_1322_;
                                                let _e733 = phi_1344_;
                                                let _e737 = (bitcast<i32>(_e733.member) != 0i);
                                                if _e737 {
                                                    let _e743 = type_38(_e716.member, _e716.member_1, (_e716.member_2 + 1u));
                                                    let _e748 = (_e704.member.member_1.x - _e704.member.member.x);
                                                    let _e751 = (_e704.member.member_1.y - _e704.member.member.y);
                                                    let _e754 = (_e704.member.member_1.z - _e704.member.member.z);
                                                    let _e756 = select(_e751, _e748, (_e748 > _e751));
                                                    let _e758 = select(_e754, _e756, (_e756 > _e754));
                                                    let _e760 = (_e758 < (1024f * _e152));
                                                    if _e760 {
                                                        phi_1388_ = 0u;
                                                    } else {
                                                        phi_1388_ = select(2u, 1u, (_e758 < (2097152f * _e152)));
                                                    }
                                                    let _e765 = phi_1388_;
                                                    switch bitcast<i32>(_e765) {
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
                                                    let _e768 = phi_1394_;
                                                    switch bitcast<i32>(_e765) {
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
                                                    let _e775 = phi_1404_;
                                                    let _e777 = ((_e709 + (_e733.member_1 * ((3u * _e768) + 1u))) + (3u * _e775));
                                                    let _e778 = (_e777 < _e100);
                                                    if _e778 {
                                                        if _e778 {
                                                        } else {
                                                            phi_4783_ = true;
                                                            break;
                                                        }
                                                        let _e780 = global_7.member[_e777];
                                                        phi_1420_ = _e780;
                                                    } else {
                                                        phi_1420_ = 4294967295u;
                                                    }
                                                    let _e782 = phi_1420_;
                                                    if _e760 {
                                                        phi_1453_ = 0u;
                                                    } else {
                                                        phi_1453_ = select(2u, 1u, (_e758 < (2097152f * _e152)));
                                                    }
                                                    let _e787 = phi_1453_;
                                                    switch bitcast<i32>(_e787) {
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
                                                    let _e790 = phi_1459_;
                                                    let _e794 = (_e709 + (_e733.member_1 * ((3u * _e790) + 1u)));
                                                    switch bitcast<i32>(_e787) {
                                                        case 0: {
                                                            let _e1069 = (_e794 < _e100);
                                                            if _e1069 {
                                                                if _e1069 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e1071 = global_7.member[_e794];
                                                                phi_1486_ = _e1071;
                                                            } else {
                                                                phi_1486_ = 0u;
                                                            }
                                                            let _e1073 = phi_1486_;
                                                            let _e1075 = ((10u * _e278) & 31u);
                                                            let _e1085 = ((10u * _e277) & 31u);
                                                            let _e1095 = ((10u * _e279) & 31u);
                                                            let _e1105 = (_e794 + 1u);
                                                            let _e1106 = (_e1105 < _e100);
                                                            if _e1106 {
                                                                if _e1106 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e1108 = global_7.member[_e1105];
                                                                phi_1535_ = _e1108;
                                                            } else {
                                                                phi_1535_ = 0u;
                                                            }
                                                            let _e1110 = phi_1535_;
                                                            let _e1136 = (_e794 + 2u);
                                                            let _e1137 = (_e1136 < _e100);
                                                            if _e1137 {
                                                                if _e1137 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e1139 = global_7.member[_e1136];
                                                                phi_1584_ = _e1139;
                                                            } else {
                                                                phi_1584_ = 0u;
                                                            }
                                                            let _e1141 = phi_1584_;
                                                            phi_2085_ = array<array<f32, 3>, 3>(array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | ((_e1073 >> bitcast<u32>(_e1075)) & 1023u))) - 8388608f) * _e152)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | ((_e1073 >> bitcast<u32>(_e1085)) & 1023u))) - 8388608f) * _e152)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | ((_e1073 >> bitcast<u32>(_e1095)) & 1023u))) - 8388608f) * _e152))), array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | ((_e1110 >> bitcast<u32>(_e1075)) & 1023u))) - 8388608f) * _e152)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | ((_e1110 >> bitcast<u32>(_e1085)) & 1023u))) - 8388608f) * _e152)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | ((_e1110 >> bitcast<u32>(_e1095)) & 1023u))) - 8388608f) * _e152))), array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | ((_e1141 >> bitcast<u32>(_e1075)) & 1023u))) - 8388608f) * _e152)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | ((_e1141 >> bitcast<u32>(_e1085)) & 1023u))) - 8388608f) * _e152)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | ((_e1141 >> bitcast<u32>(_e1095)) & 1023u))) - 8388608f) * _e152))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e883 = (_e794 < _e100);
                                                            if _e883 {
                                                                if _e883 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e885 = global_7.member[_e794];
                                                                phi_1633_ = _e885;
                                                            } else {
                                                                phi_1633_ = 0u;
                                                            }
                                                            let _e887 = phi_1633_;
                                                            let _e888 = (_e794 + 1u);
                                                            let _e889 = (_e888 < _e100);
                                                            if _e889 {
                                                                if _e889 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e891 = global_7.member[_e888];
                                                                phi_1648_ = _e891;
                                                            } else {
                                                                phi_1648_ = 0u;
                                                            }
                                                            let _e893 = phi_1648_;
                                                            let _e894 = (_e278 == 1u);
                                                            if _e894 {
                                                                phi_1658_ = ((_e887 >> bitcast<u32>(21i)) | (_e893 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1658_ = (_e893 >> bitcast<u32>(10i));
                                                            }
                                                            let _e903 = phi_1658_;
                                                            let _e911 = (_e277 == 1u);
                                                            if _e911 {
                                                                phi_1679_ = ((_e887 >> bitcast<u32>(21i)) | (_e893 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1679_ = (_e893 >> bitcast<u32>(10i));
                                                            }
                                                            let _e920 = phi_1679_;
                                                            let _e928 = (_e279 == 1u);
                                                            if _e928 {
                                                                phi_1700_ = ((_e887 >> bitcast<u32>(21i)) | (_e893 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1700_ = (_e893 >> bitcast<u32>(10i));
                                                            }
                                                            let _e937 = phi_1700_;
                                                            let _e946 = (_e794 + 2u);
                                                            let _e947 = (_e946 < _e100);
                                                            if _e947 {
                                                                if _e947 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e949 = global_7.member[_e946];
                                                                phi_1730_ = _e949;
                                                            } else {
                                                                phi_1730_ = 0u;
                                                            }
                                                            let _e951 = phi_1730_;
                                                            let _e952 = (_e794 + 3u);
                                                            let _e953 = (_e952 < _e100);
                                                            if _e953 {
                                                                if _e953 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e955 = global_7.member[_e952];
                                                                phi_1745_ = _e955;
                                                            } else {
                                                                phi_1745_ = 0u;
                                                            }
                                                            let _e957 = phi_1745_;
                                                            if _e894 {
                                                                phi_1755_ = ((_e951 >> bitcast<u32>(21i)) | (_e957 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1755_ = (_e957 >> bitcast<u32>(10i));
                                                            }
                                                            let _e966 = phi_1755_;
                                                            if _e911 {
                                                                phi_1776_ = ((_e951 >> bitcast<u32>(21i)) | (_e957 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1776_ = (_e957 >> bitcast<u32>(10i));
                                                            }
                                                            let _e982 = phi_1776_;
                                                            if _e928 {
                                                                phi_1797_ = ((_e951 >> bitcast<u32>(21i)) | (_e957 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1797_ = (_e957 >> bitcast<u32>(10i));
                                                            }
                                                            let _e998 = phi_1797_;
                                                            let _e1007 = (_e794 + 4u);
                                                            let _e1008 = (_e1007 < _e100);
                                                            if _e1008 {
                                                                if _e1008 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e1010 = global_7.member[_e1007];
                                                                phi_1827_ = _e1010;
                                                            } else {
                                                                phi_1827_ = 0u;
                                                            }
                                                            let _e1012 = phi_1827_;
                                                            let _e1013 = (_e794 + 5u);
                                                            let _e1014 = (_e1013 < _e100);
                                                            if _e1014 {
                                                                if _e1014 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e1016 = global_7.member[_e1013];
                                                                phi_1842_ = _e1016;
                                                            } else {
                                                                phi_1842_ = 0u;
                                                            }
                                                            let _e1018 = phi_1842_;
                                                            if _e894 {
                                                                phi_1852_ = ((_e1012 >> bitcast<u32>(21i)) | (_e1018 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1852_ = (_e1018 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1027 = phi_1852_;
                                                            if _e911 {
                                                                phi_1873_ = ((_e1012 >> bitcast<u32>(21i)) | (_e1018 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1873_ = (_e1018 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1043 = phi_1873_;
                                                            if _e928 {
                                                                phi_1894_ = ((_e1012 >> bitcast<u32>(21i)) | (_e1018 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1894_ = (_e1018 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1059 = phi_1894_;
                                                            phi_2085_ = array<array<f32, 3>, 3>(array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | (select(_e903, _e887, _e302) & 2097151u))) - 8388608f) * _e152)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | (select(_e920, _e887, _e369) & 2097151u))) - 8388608f) * _e152)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | (select(_e937, _e887, _e435) & 2097151u))) - 8388608f) * _e152))), array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | (select(_e966, _e951, _e302) & 2097151u))) - 8388608f) * _e152)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | (select(_e982, _e951, _e369) & 2097151u))) - 8388608f) * _e152)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | (select(_e998, _e951, _e435) & 2097151u))) - 8388608f) * _e152))), array<f32, 3>((_e704.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1027, _e1012, _e302) & 2097151u))) - 8388608f) * _e152)), (_e704.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1043, _e1012, _e369) & 2097151u))) - 8388608f) * _e152)), (_e704.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1059, _e1012, _e435) & 2097151u))) - 8388608f) * _e152))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e796 = (_e794 + _e278);
                                                            let _e797 = (_e796 < _e100);
                                                            if _e797 {
                                                                if _e797 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e799 = global_7.member[_e796];
                                                                phi_1925_ = _e799;
                                                            } else {
                                                                phi_1925_ = 0u;
                                                            }
                                                            let _e801 = phi_1925_;
                                                            let _e805 = (_e794 + _e277);
                                                            let _e806 = (_e805 < _e100);
                                                            if _e806 {
                                                                if _e806 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e808 = global_7.member[_e805];
                                                                phi_1943_ = _e808;
                                                            } else {
                                                                phi_1943_ = 0u;
                                                            }
                                                            let _e810 = phi_1943_;
                                                            let _e814 = (_e794 + _e279);
                                                            let _e815 = (_e814 < _e100);
                                                            if _e815 {
                                                                if _e815 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e817 = global_7.member[_e814];
                                                                phi_1961_ = _e817;
                                                            } else {
                                                                phi_1961_ = 0u;
                                                            }
                                                            let _e819 = phi_1961_;
                                                            let _e824 = (_e794 + 3u);
                                                            let _e825 = (_e824 + _e278);
                                                            let _e826 = (_e825 < _e100);
                                                            if _e826 {
                                                                if _e826 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e828 = global_7.member[_e825];
                                                                phi_1984_ = _e828;
                                                            } else {
                                                                phi_1984_ = 0u;
                                                            }
                                                            let _e830 = phi_1984_;
                                                            let _e834 = (_e824 + _e277);
                                                            let _e835 = (_e834 < _e100);
                                                            if _e835 {
                                                                if _e835 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e837 = global_7.member[_e834];
                                                                phi_2002_ = _e837;
                                                            } else {
                                                                phi_2002_ = 0u;
                                                            }
                                                            let _e839 = phi_2002_;
                                                            let _e843 = (_e824 + _e279);
                                                            let _e844 = (_e843 < _e100);
                                                            if _e844 {
                                                                if _e844 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e846 = global_7.member[_e843];
                                                                phi_2020_ = _e846;
                                                            } else {
                                                                phi_2020_ = 0u;
                                                            }
                                                            let _e848 = phi_2020_;
                                                            let _e853 = (_e794 + 6u);
                                                            let _e854 = (_e853 + _e278);
                                                            let _e855 = (_e854 < _e100);
                                                            if _e855 {
                                                                if _e855 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e857 = global_7.member[_e854];
                                                                phi_2043_ = _e857;
                                                            } else {
                                                                phi_2043_ = 0u;
                                                            }
                                                            let _e859 = phi_2043_;
                                                            let _e863 = (_e853 + _e277);
                                                            let _e864 = (_e863 < _e100);
                                                            if _e864 {
                                                                if _e864 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e866 = global_7.member[_e863];
                                                                phi_2061_ = _e866;
                                                            } else {
                                                                phi_2061_ = 0u;
                                                            }
                                                            let _e868 = phi_2061_;
                                                            let _e872 = (_e853 + _e279);
                                                            let _e873 = (_e872 < _e100);
                                                            if _e873 {
                                                                if _e873 {
                                                                } else {
                                                                    phi_4783_ = true;
                                                                    break;
                                                                }
                                                                let _e875 = global_7.member[_e872];
                                                                phi_2079_ = _e875;
                                                            } else {
                                                                phi_2079_ = 0u;
                                                            }
                                                            let _e877 = phi_2079_;
                                                            phi_2085_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e801)) * _e152), (f32(bitcast<i32>(_e810)) * _e152), (f32(bitcast<i32>(_e819)) * _e152)), array<f32, 3>((f32(bitcast<i32>(_e830)) * _e152), (f32(bitcast<i32>(_e839)) * _e152), (f32(bitcast<i32>(_e848)) * _e152)), array<f32, 3>((f32(bitcast<i32>(_e859)) * _e152), (f32(bitcast<i32>(_e868)) * _e152), (f32(bitcast<i32>(_e877)) * _e152)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2085_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1169 = phi_2085_;
                                                    let _e1178 = (_e1169[0][2] - _e458);
                                                    let _e1181 = (((_e1169[0][0] - _e325) * _e497) - (_e1178 * _e365));
                                                    let _e1184 = (((_e1169[0][1] - _e392) * _e497) - (_e1178 * _e431));
                                                    let _e1191 = (_e1169[1][2] - _e458);
                                                    let _e1194 = (((_e1169[1][0] - _e325) * _e497) - (_e1191 * _e365));
                                                    let _e1197 = (((_e1169[1][1] - _e392) * _e497) - (_e1191 * _e431));
                                                    let _e1204 = (_e1169[2][2] - _e458);
                                                    let _e1207 = (((_e1169[2][0] - _e325) * _e497) - (_e1204 * _e365));
                                                    let _e1210 = (((_e1169[2][1] - _e392) * _e497) - (_e1204 * _e431));
                                                    let _e1211 = (_e1207 * _e1197);
                                                    let _e1212 = (_e1210 * _e1194);
                                                    let _e1213 = (_e1181 * _e1210);
                                                    let _e1214 = (_e1184 * _e1207);
                                                    let _e1215 = (_e1194 * _e1184);
                                                    let _e1216 = (_e1197 * _e1181);
                                                    let _e1221 = (((_e1211 >= _e1212) && (_e1213 >= _e1214)) && (_e1215 >= _e1216));
                                                    if (_e1221 || (((_e1211 <= _e1212) && (_e1213 <= _e1214)) && (_e1215 <= _e1216))) {
                                                        let _e1228 = select(-1f, 1f, _e1221);
                                                        let _e1230 = ((_e1211 - _e1212) * _e1228);
                                                        let _e1232 = select(0f, _e1230, (_e1230 > 0f));
                                                        let _e1234 = ((_e1213 - _e1214) * _e1228);
                                                        let _e1236 = select(0f, _e1234, (_e1234 > 0f));
                                                        let _e1238 = ((_e1215 - _e1216) * _e1228);
                                                        let _e1240 = select(0f, _e1238, (_e1238 > 0f));
                                                        let _e1242 = ((_e1232 + _e1236) + _e1240);
                                                        if (_e1242 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2969_ = type_18();
                                                            phi_2970_ = true;
                                                            phi_2971_ = false;
                                                        } else {
                                                            let _e1245 = select(_e1194, _e1181, (_e1181 < _e1194));
                                                            if (select(_e1207, _e1245, (_e1245 < _e1207)) > 0f) {
                                                                phi_2237_ = true;
                                                            } else {
                                                                let _e1250 = select(_e1194, _e1181, (_e1181 > _e1194));
                                                                phi_2237_ = (select(_e1207, _e1250, (_e1250 > _e1207)) < 0f);
                                                            }
                                                            let _e1255 = phi_2237_;
                                                            if _e1255 {
                                                                phi_2966_ = type_18();
                                                                phi_2967_ = true;
                                                                phi_2968_ = false;
                                                            } else {
                                                                let _e1257 = select(_e1197, _e1184, (_e1184 < _e1197));
                                                                if (select(_e1210, _e1257, (_e1257 < _e1210)) > 0f) {
                                                                    phi_2266_ = true;
                                                                } else {
                                                                    let _e1262 = select(_e1197, _e1184, (_e1184 > _e1197));
                                                                    phi_2266_ = (select(_e1210, _e1262, (_e1262 > _e1210)) < 0f);
                                                                }
                                                                let _e1267 = phi_2266_;
                                                                if _e1267 {
                                                                    phi_2964_ = type_18();
                                                                    phi_2965_ = false;
                                                                } else {
                                                                    let _e1269 = select(_e1169[1][0], _e1169[0][0], (_e1169[0][0] < _e1169[1][0]));
                                                                    let _e1273 = select(_e1169[1][0], _e1169[0][0], (_e1169[0][0] > _e1169[1][0]));
                                                                    let _e1277 = select(_e1169[1][1], _e1169[0][1], (_e1169[0][1] < _e1169[1][1]));
                                                                    let _e1281 = select(_e1169[1][1], _e1169[0][1], (_e1169[0][1] > _e1169[1][1]));
                                                                    let _e1285 = select(_e1169[1][2], _e1169[0][2], (_e1169[0][2] < _e1169[1][2]));
                                                                    let _e1289 = select(_e1169[1][2], _e1169[0][2], (_e1169[0][2] > _e1169[1][2]));
                                                                    let _e1294 = ((select(_e1169[2][0], _e1269, (_e1269 < _e1169[2][0])) - _e363) * _e368);
                                                                    let _e1295 = ((select(_e1169[2][0], _e1273, (_e1273 > _e1169[2][0])) - _e364) * _e368);
                                                                    let _e1298 = ((select(_e1169[2][1], _e1277, (_e1277 < _e1169[2][1])) - _e429) * _e434);
                                                                    let _e1299 = ((select(_e1169[2][1], _e1281, (_e1281 > _e1169[2][1])) - _e430) * _e434);
                                                                    let _e1302 = ((select(_e1169[2][2], _e1285, (_e1285 < _e1169[2][2])) - _e495) * _e500);
                                                                    let _e1303 = ((select(_e1169[2][2], _e1289, (_e1289 > _e1169[2][2])) - _e496) * _e500);
                                                                    let _e1305 = select(_e1303, _e1302, (_e1302 < _e1303));
                                                                    let _e1307 = select(_e1303, _e1302, (_e1302 > _e1303));
                                                                    let _e1309 = select(_e1295, _e1294, (_e1294 < _e1295));
                                                                    let _e1311 = select(_e1299, _e1298, (_e1298 < _e1299));
                                                                    let _e1313 = select(_e1311, _e1309, (_e1309 > _e1311));
                                                                    let _e1315 = select(_e1305, _e1313, (_e1313 > _e1305));
                                                                    let _e1317 = select(_e1295, _e1294, (_e1294 > _e1295));
                                                                    let _e1319 = select(_e1299, _e1298, (_e1298 > _e1299));
                                                                    let _e1321 = select(_e1319, _e1317, (_e1317 < _e1319));
                                                                    let _e1323 = select(_e1307, _e1321, (_e1321 < _e1307));
                                                                    let _e1324 = -(_e1305);
                                                                    let _e1330 = select(_e611, _e1315, (_e1315 > _e611));
                                                                    if (_e1330 > (_e1323 + (select(_e1324, _e1307, (_e1307 > _e1324)) * 0.0000019073523f))) {
                                                                        phi_2959_ = type_18();
                                                                        phi_2960_ = true;
                                                                    } else {
                                                                        let _e1332 = (_e1330 > _e716.member.member_1);
                                                                        if _e1332 {
                                                                            phi_2958_ = type_18();
                                                                        } else {
                                                                            let _e1333 = vec3<f32>(_e1169[0][0], _e1169[0][1], _e1169[0][2]);
                                                                            let _e1334 = vec3<f32>(_e1169[1][0], _e1169[1][1], _e1169[1][2]);
                                                                            let _e1335 = vec3<f32>(_e1169[2][0], _e1169[2][1], _e1169[2][2]);
                                                                            let _e1336 = (_e1169[1][0] - _e1169[0][0]);
                                                                            let _e1337 = (_e1169[1][1] - _e1169[0][1]);
                                                                            let _e1338 = (_e1169[1][2] - _e1169[0][2]);
                                                                            let _e1339 = vec3<f32>(_e1336, _e1337, _e1338);
                                                                            let _e1340 = (_e1169[2][0] - _e1169[1][0]);
                                                                            let _e1341 = (_e1169[2][1] - _e1169[1][1]);
                                                                            let _e1342 = (_e1169[2][2] - _e1169[1][2]);
                                                                            let _e1343 = vec3<f32>(_e1340, _e1341, _e1342);
                                                                            let _e1344 = (_e1169[0][0] - _e1169[2][0]);
                                                                            let _e1345 = (_e1169[0][1] - _e1169[2][1]);
                                                                            let _e1346 = (_e1169[0][2] - _e1169[2][2]);
                                                                            let _e1347 = vec3<f32>(_e1344, _e1345, _e1346);
                                                                            let _e1350 = bitcast<f32>((bitcast<u32>(_e1336) & 2147483647u));
                                                                            let _e1353 = bitcast<f32>((bitcast<u32>(_e1337) & 2147483647u));
                                                                            let _e1355 = select(_e1353, _e1350, (_e1350 > _e1353));
                                                                            let _e1358 = bitcast<f32>((bitcast<u32>(_e1338) & 2147483647u));
                                                                            let _e1360 = select(_e1358, _e1355, (_e1355 > _e1358));
                                                                            let _e1363 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                            let _e1366 = bitcast<f32>((bitcast<u32>(_e1341) & 2147483647u));
                                                                            let _e1368 = select(_e1366, _e1363, (_e1363 > _e1366));
                                                                            let _e1371 = bitcast<f32>((bitcast<u32>(_e1342) & 2147483647u));
                                                                            let _e1373 = select(_e1371, _e1368, (_e1368 > _e1371));
                                                                            let _e1376 = bitcast<f32>((bitcast<u32>(_e1344) & 2147483647u));
                                                                            let _e1379 = bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u));
                                                                            let _e1381 = select(_e1379, _e1376, (_e1376 > _e1379));
                                                                            let _e1384 = bitcast<f32>((bitcast<u32>(_e1346) & 2147483647u));
                                                                            let _e1386 = select(_e1384, _e1381, (_e1381 > _e1384));
                                                                            let _e1388 = select(_e1373, _e1360, (_e1360 > _e1373));
                                                                            let _e1390 = select(_e1386, _e1388, (_e1388 > _e1386));
                                                                            if (_e1360 == _e1390) {
                                                                                phi_2685_ = _e1197;
                                                                                phi_2686_ = _e1194;
                                                                                phi_2687_ = _e1184;
                                                                                phi_2688_ = _e1181;
                                                                                phi_2689_ = _e1333;
                                                                                phi_2690_ = _e1347;
                                                                                phi_2691_ = _e1343;
                                                                                phi_2692_ = _e1339;
                                                                            } else {
                                                                                let _e1392 = (_e1373 == _e1390);
                                                                                let _e1397 = vec3(_e1392);
                                                                                phi_2685_ = select(_e1184, _e1210, _e1392);
                                                                                phi_2686_ = select(_e1181, _e1207, _e1392);
                                                                                phi_2687_ = select(_e1210, _e1197, _e1392);
                                                                                phi_2688_ = select(_e1207, _e1194, _e1392);
                                                                                phi_2689_ = select(_e1335, _e1334, _e1397);
                                                                                phi_2690_ = select(_e1343, _e1339, _e1397);
                                                                                phi_2691_ = select(_e1339, _e1347, _e1397);
                                                                                phi_2692_ = select(_e1347, _e1343, _e1397);
                                                                            }
                                                                            let _e1403 = phi_2685_;
                                                                            let _e1405 = phi_2686_;
                                                                            let _e1407 = phi_2687_;
                                                                            let _e1409 = phi_2688_;
                                                                            let _e1411 = phi_2689_;
                                                                            let _e1413 = phi_2690_;
                                                                            let _e1415 = phi_2691_;
                                                                            let _e1417 = phi_2692_;
                                                                            let _e1424 = ((_e1415.y * _e1413.z) - (_e1413.y * _e1415.z));
                                                                            let _e1429 = ((_e1415.z * _e1413.x) - (_e1413.z * _e1415.x));
                                                                            let _e1432 = ((_e1415.x * _e1413.y) - (_e1413.x * _e1415.y));
                                                                            if (_e1232 >= _e1236) {
                                                                                phi_2729_ = select(true, false, (_e1232 >= _e1240));
                                                                            } else {
                                                                                phi_2729_ = true;
                                                                            }
                                                                            let _e1437 = phi_2729_;
                                                                            if _e1437 {
                                                                                phi_2738_ = select(_e1335, _e1334, vec3((_e1236 >= _e1240)));
                                                                            } else {
                                                                                phi_2738_ = _e1333;
                                                                            }
                                                                            let _e1442 = phi_2738_;
                                                                            let _e1453 = (((_e1424 * (_e1442.x - _e325)) + (_e1429 * (_e1442.y - _e392))) + (_e1432 * (_e1442.z - _e458)));
                                                                            let _e1458 = (((_e1424 * _e365) + (_e1429 * _e431)) + (_e1432 * _e497));
                                                                            let _e1459 = (_e1405 - _e1409);
                                                                            let _e1460 = (_e1403 - _e1407);
                                                                            let _e1468 = (-(((_e1409 * _e1459) + (_e1407 * _e1460))) / ((_e1459 * _e1459) + (_e1460 * _e1460)));
                                                                            let _e1470 = select(1f, _e1468, (_e1468 < 1f));
                                                                            let _e1472 = select(0f, _e1470, (_e1470 > 0f));
                                                                            let _e1485 = ((_e1411.x + (_e1417.x * _e1472)) - _e325);
                                                                            let _e1486 = ((_e1411.y + (_e1417.y * _e1472)) - _e392);
                                                                            let _e1487 = ((_e1411.z + (_e1417.z * _e1472)) - _e458);
                                                                            let _e1488 = (_e1487 / _e497);
                                                                            let _e1500 = bitcast<f32>((bitcast<u32>(_e1485) & 2147483647u));
                                                                            let _e1503 = bitcast<f32>((bitcast<u32>(_e1486) & 2147483647u));
                                                                            let _e1505 = select(_e1503, _e1500, (_e1500 > _e1503));
                                                                            let _e1508 = bitcast<f32>((bitcast<u32>(_e1487) & 2147483647u));
                                                                            let _e1510 = select(_e1508, _e1505, (_e1505 > _e1508));
                                                                            let _e1516 = bitcast<f32>((bitcast<u32>(_e1424) & 2147483647u));
                                                                            let _e1519 = bitcast<f32>((bitcast<u32>(_e1429) & 2147483647u));
                                                                            let _e1521 = select(_e1519, _e1516, (_e1516 > _e1519));
                                                                            let _e1524 = bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1424 * _e1485) + (_e1429 * _e1486)) + (_e1432 * _e1487)) - _e1453)) & 2147483647u)) <= ((0.0000009536743f * select(_e1390, _e1510, (_e1510 > _e1390))) * select(_e1524, _e1521, (_e1521 > _e1524)))) {
                                                                                let _e1534 = bitcast<f32>((bitcast<u32>(_e1415.x) & 2147483647u));
                                                                                let _e1537 = bitcast<f32>((bitcast<u32>(_e1415.y) & 2147483647u));
                                                                                let _e1539 = select(_e1537, _e1534, (_e1534 > _e1537));
                                                                                let _e1542 = bitcast<f32>((bitcast<u32>(_e1415.z) & 2147483647u));
                                                                                let _e1548 = bitcast<f32>((bitcast<u32>(_e1413.x) & 2147483647u));
                                                                                let _e1551 = bitcast<f32>((bitcast<u32>(_e1413.y) & 2147483647u));
                                                                                let _e1553 = select(_e1551, _e1548, (_e1548 > _e1551));
                                                                                let _e1556 = bitcast<f32>((bitcast<u32>(_e1413.z) & 2147483647u));
                                                                                let _e1560 = (bitcast<f32>((bitcast<u32>(_e1458) & 2147483647u)) > ((0.0000038146973f * select(_e1542, _e1539, (_e1539 > _e1542))) * select(_e1556, _e1553, (_e1553 > _e1556))));
                                                                                if _e1560 {
                                                                                    phi_2903_ = (_e1453 / _e1458);
                                                                                } else {
                                                                                    phi_2903_ = f32();
                                                                                }
                                                                                let _e1563 = phi_2903_;
                                                                                phi_2905_ = _e1563;
                                                                                phi_2906_ = select(true, false, _e1560);
                                                                            } else {
                                                                                phi_2905_ = f32();
                                                                                phi_2906_ = true;
                                                                            }
                                                                            let _e1566 = phi_2905_;
                                                                            let _e1568 = phi_2906_;
                                                                            if _e1568 {
                                                                                let _e1576 = (((_e1424 * (_e1485 - (_e365 * _e1488))) + (_e1429 * (_e1486 - (_e431 * _e1488)))) / _e1458);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1576) & 2147483647u)) <= _e1390) {
                                                                                    phi_2926_ = (_e1488 + _e1576);
                                                                                } else {
                                                                                    phi_2926_ = _e1488;
                                                                                }
                                                                                let _e1583 = phi_2926_;
                                                                                phi_2927_ = _e1583;
                                                                            } else {
                                                                                phi_2927_ = _e1566;
                                                                            }
                                                                            let _e1585 = phi_2927_;
                                                                            let _e1587 = select(_e1323, _e1585, (_e1585 < _e1323));
                                                                            let _e1589 = select(_e1315, _e1587, (_e1587 > _e1315));
                                                                            if (_e1589 >= _e611) {
                                                                                let _e1591 = (_e1589 <= _e716.member.member_1);
                                                                                if _e1591 {
                                                                                    let _e1592 = (1f / _e1242);
                                                                                    phi_2950_ = type_18(_e1589, (_e1236 * _e1592), (_e1240 * _e1592), _e782);
                                                                                } else {
                                                                                    phi_2950_ = type_18();
                                                                                }
                                                                                let _e1597 = phi_2950_;
                                                                                phi_2952_ = _e1597;
                                                                                phi_2953_ = select(true, false, _e1591);
                                                                            } else {
                                                                                phi_2952_ = type_18();
                                                                                phi_2953_ = true;
                                                                            }
                                                                            let _e1600 = phi_2952_;
                                                                            let _e1602 = phi_2953_;
                                                                            if _e1602 {
                                                                                phi_2957_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2957_ = _e1600;
                                                                            }
                                                                            let _e1604 = phi_2957_;
                                                                            phi_2958_ = _e1604;
                                                                        }
                                                                        let _e1606 = phi_2958_;
                                                                        phi_2959_ = _e1606;
                                                                        phi_2960_ = _e1332;
                                                                    }
                                                                    let _e1608 = phi_2959_;
                                                                    let _e1610 = phi_2960_;
                                                                    phi_2964_ = _e1608;
                                                                    phi_2965_ = _e1610;
                                                                }
                                                                let _e1612 = phi_2964_;
                                                                let _e1614 = phi_2965_;
                                                                phi_2966_ = _e1612;
                                                                phi_2967_ = _e1267;
                                                                phi_2968_ = _e1614;
                                                            }
                                                            let _e1616 = phi_2966_;
                                                            let _e1618 = phi_2967_;
                                                            let _e1620 = phi_2968_;
                                                            phi_2969_ = _e1616;
                                                            phi_2970_ = _e1618;
                                                            phi_2971_ = _e1620;
                                                        }
                                                        let _e1622 = phi_2969_;
                                                        let _e1624 = phi_2970_;
                                                        let _e1626 = phi_2971_;
                                                        phi_2979_ = _e1622;
                                                        phi_2980_ = select(_e1626, true, _e1624);
                                                    } else {
                                                        phi_2979_ = type_18();
                                                        phi_2980_ = true;
                                                    }
                                                    let _e1629 = phi_2979_;
                                                    let _e1631 = phi_2980_;
                                                    if _e1631 {
                                                        phi_2984_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2984_ = _e1629;
                                                    }
                                                    let _e1633 = phi_2984_;
                                                    if (_e1633.member_3 != 4294967295u) {
                                                        if (_e782 != _e617) {
                                                            if (_e1633.member < _e716.member.member.member) {
                                                                phi_3010_ = true;
                                                            } else {
                                                                if (_e1633.member == _e716.member.member.member) {
                                                                    phi_3009_ = (_e1633.member_3 < _e716.member.member.member_3);
                                                                } else {
                                                                    phi_3009_ = false;
                                                                }
                                                                let _e1648 = phi_3009_;
                                                                phi_3010_ = _e1648;
                                                            }
                                                            let _e1650 = phi_3010_;
                                                            if _e1650 {
                                                                phi_3017_ = type_38(type_35(_e1633, _e1633.member), _e743.member_1, _e743.member_2);
                                                            } else {
                                                                phi_3017_ = _e743;
                                                            }
                                                            let _e1657 = phi_3017_;
                                                            phi_3018_ = _e1657;
                                                        } else {
                                                            phi_3018_ = _e743;
                                                        }
                                                        let _e1659 = phi_3018_;
                                                        phi_3019_ = _e1659;
                                                    } else {
                                                        phi_3019_ = _e743;
                                                    }
                                                    let _e1661 = phi_3019_;
                                                    phi_1319_ = _e1661;
                                                } else {
                                                    phi_1319_ = type_38();
                                                }
                                                let _e1663 = phi_1319_;
                                                continue;
                                                continuing {
                                                    phi_1318_ = _e1663;
                                                    phi_1321_ = _e731;
                                                    phi_4783_ = _e658;
                                                    break if !(_e737);
                                                }
                                            }
                                            let _e1666 = phi_4783_;
                                            phi_4990_ = _e1666;
                                            if _e1666 {
                                                break;
                                            }
                                            phi_5081_ = _e1666;
                                            let _e2506 = local_12;
                                            phi_3020_ = _e2506;
                                        } else {
                                            phi_5081_ = _e658;
                                            phi_3020_ = _e660;
                                        }
                                        let _e1668 = phi_5081_;
                                        let _e1670 = phi_3020_;
                                        if _e708 {
                                            phi_4289_ = type_38();
                                            phi_4290_ = bool();
                                            phi_4291_ = u32();
                                            phi_4292_ = type_49();
                                        } else {
                                            if (_e704.member_1 >= _e97) {
                                                phi_3821_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e704.member_1 < _e97) {
                                                } else {
                                                    phi_4990_ = true;
                                                    break;
                                                }
                                                let _e1673 = (_e278 * 2u);
                                                let _e1675 = ((1u + _e1673) % 7u);
                                                if (_e1675 < 7u) {
                                                } else {
                                                    phi_4990_ = true;
                                                    break;
                                                }
                                                let _e1680 = global_6.member[_e704.member_1][_e1675];
                                                let _e1682 = ((_e1673 + 2u) % 7u);
                                                if (_e1682 < 7u) {
                                                } else {
                                                    phi_4990_ = true;
                                                    break;
                                                }
                                                let _e1687 = global_6.member[_e704.member_1][_e1682];
                                                let _e1688 = (_e277 * 2u);
                                                let _e1690 = ((1u + _e1688) % 7u);
                                                if (_e1690 < 7u) {
                                                } else {
                                                    phi_4990_ = true;
                                                    break;
                                                }
                                                let _e1695 = global_6.member[_e704.member_1][_e1690];
                                                let _e1697 = ((_e1688 + 2u) % 7u);
                                                if (_e1697 < 7u) {
                                                } else {
                                                    phi_4990_ = true;
                                                    break;
                                                }
                                                let _e1702 = global_6.member[_e704.member_1][_e1697];
                                                let _e1703 = (_e279 * 2u);
                                                let _e1705 = ((1u + _e1703) % 7u);
                                                if (_e1705 < 7u) {
                                                } else {
                                                    phi_4990_ = true;
                                                    break;
                                                }
                                                let _e1710 = global_6.member[_e704.member_1][_e1705];
                                                let _e1712 = ((_e1703 + 2u) % 7u);
                                                if (_e1712 < 7u) {
                                                } else {
                                                    phi_4990_ = true;
                                                    break;
                                                }
                                                let _e1717 = global_6.member[_e704.member_1][_e1712];
                                                let _e1740 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.x - _e704.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1741 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.y - _e704.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1742 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.z - _e704.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1744 = select(_e152, _e1740, (_e1740 > _e152));
                                                let _e1746 = select(_e152, _e1741, (_e1741 > _e152));
                                                let _e1748 = select(_e152, _e1742, (_e1742 > _e152));
                                                let _e1779 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1680 & 2097151u))) - 8388608f) * _e1744));
                                                let _e1784 = (bitcast<i32>((_e1680 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1787 = bitcast<f32>((_e1779 & bitcast<u32>(_e1784)));
                                                let _e1788 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1695 & 2097151u))) - 8388608f) * _e1746));
                                                let _e1793 = (bitcast<i32>((_e1695 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1796 = bitcast<f32>((_e1788 & bitcast<u32>(_e1793)));
                                                let _e1797 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1710 & 2097151u))) - 8388608f) * _e1748));
                                                let _e1802 = (bitcast<i32>((_e1710 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1805 = bitcast<f32>((_e1797 & bitcast<u32>(_e1802)));
                                                let _e1809 = bitcast<f32>((_e1779 & bitcast<u32>(~(_e1784))));
                                                let _e1813 = bitcast<f32>((_e1788 & bitcast<u32>(~(_e1793))));
                                                let _e1817 = bitcast<f32>((_e1797 & bitcast<u32>(~(_e1802))));
                                                let _e1818 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1687 & 2097151u))) - 8388608f) * _e1744));
                                                let _e1823 = (bitcast<i32>((_e1687 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1826 = bitcast<f32>((_e1818 & bitcast<u32>(_e1823)));
                                                let _e1827 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1702 & 2097151u))) - 8388608f) * _e1746));
                                                let _e1832 = (bitcast<i32>((_e1702 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1835 = bitcast<f32>((_e1827 & bitcast<u32>(_e1832)));
                                                let _e1836 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1717 & 2097151u))) - 8388608f) * _e1748));
                                                let _e1841 = (bitcast<i32>((_e1717 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1844 = bitcast<f32>((_e1836 & bitcast<u32>(_e1841)));
                                                let _e1848 = bitcast<f32>((_e1818 & bitcast<u32>(~(_e1823))));
                                                let _e1852 = bitcast<f32>((_e1827 & bitcast<u32>(~(_e1832))));
                                                let _e1856 = bitcast<f32>((_e1836 & bitcast<u32>(~(_e1841))));
                                                let _e1857 = (_e704.member.member.x + _e1787);
                                                let _e1858 = (_e704.member.member.y + _e1796);
                                                let _e1859 = (_e704.member.member.z + _e1805);
                                                let _e1862 = (_e704.member.member_1.x - _e1826);
                                                let _e1863 = (_e704.member.member_1.y - _e1835);
                                                let _e1864 = (_e704.member.member_1.z - _e1844);
                                                let _e1883 = (_e1862 - _e1857);
                                                let _e1884 = (_e1863 - _e1858);
                                                let _e1885 = (_e1864 - _e1859);
                                                let _e1887 = select(_e1884, _e1883, (_e1883 > _e1884));
                                                let _e1889 = select(_e1885, _e1887, (_e1887 > _e1885));
                                                if (_e1889 < (1024f * _e152)) {
                                                    phi_3522_ = 0u;
                                                } else {
                                                    phi_3522_ = select(2u, 1u, (_e1889 < (2097152f * _e152)));
                                                }
                                                let _e1896 = phi_3522_;
                                                switch bitcast<i32>(_e1896) {
                                                    case 0: {
                                                        phi_3528_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_3528_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_3528_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_3528_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1899 = phi_3528_;
                                                let _e1905 = global_6.member[_e704.member_1][0u];
                                                let _e1909 = global_6.member[_e704.member_1][2u];
                                                let _e1913 = global_6.member[_e704.member_1][4u];
                                                let _e1917 = global_6.member[_e704.member_1][6u];
                                                let _e1929 = (((_e1909 >> bitcast<u32>(22i)) | ((_e1913 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1917 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1930 = (_e1905 & 268435455u);
                                                let _e1931 = (_e1929 & 268435455u);
                                                let _e1934 = ((_e1905 >> bitcast<u32>(28u)) & 7u);
                                                let _e1942 = ((_e1905 >> bitcast<u32>(31i)) | (((_e1929 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1943 = (_e1934 != 0u);
                                                if (_e1934 == 0u) {
                                                    phi_3783_ = _e1930;
                                                } else {
                                                    if (_e1934 == 7u) {
                                                        phi_3782_ = 2147483648u;
                                                    } else {
                                                        phi_3782_ = ((2147483648u | (_e1934 << bitcast<u32>(28u))) | (_e1931 & 268435455u));
                                                    }
                                                    let _e1952 = phi_3782_;
                                                    phi_3783_ = _e1952;
                                                }
                                                let _e1954 = phi_3783_;
                                                if _e1943 {
                                                    let _e1955 = (_e1934 != 7u);
                                                    if _e1955 {
                                                        phi_3793_ = (_e1931 + (_e1934 * ((3u * _e1899) + 1u)));
                                                    } else {
                                                        phi_3793_ = u32();
                                                    }
                                                    let _e1959 = phi_3793_;
                                                    phi_3795_ = _e1959;
                                                    phi_3796_ = select(true, false, _e1955);
                                                } else {
                                                    phi_3795_ = u32();
                                                    phi_3796_ = true;
                                                }
                                                let _e1962 = phi_3795_;
                                                let _e1964 = phi_3796_;
                                                if (_e1942 == 0u) {
                                                    phi_3817_ = (_e1930 + select(0u, 1u, !(_e1943)));
                                                } else {
                                                    if (_e1942 == 7u) {
                                                        phi_3816_ = 2147483648u;
                                                    } else {
                                                        phi_3816_ = ((2147483648u | (_e1942 << bitcast<u32>(28u))) | (select(_e1962, _e1931, _e1964) & 268435455u));
                                                    }
                                                    let _e1977 = phi_3816_;
                                                    phi_3817_ = _e1977;
                                                }
                                                let _e1979 = phi_3817_;
                                                phi_3821_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e1857, (_e704.member.member.x + _e1809), _e1862, (_e704.member.member_1.x - _e1848)), vec4<f32>(_e1858, (_e704.member.member.y + _e1813), _e1863, (_e704.member.member_1.y - _e1852)), vec4<f32>(_e1859, (_e704.member.member.z + _e1817), _e1864, (_e704.member.member_1.z - _e1856))), type_49(type_30((_e704.member.member + vec4<f32>(_e1787, _e1796, _e1805, 0f)), (_e704.member.member_1 - vec4<f32>(_e1826, _e1835, _e1844, 0f))), _e1954), type_49(type_30((_e704.member.member + vec4<f32>(_e1809, _e1813, _e1817, 0f)), (_e704.member.member_1 - vec4<f32>(_e1848, _e1852, _e1856, 0f))), _e1979));
                                            }
                                            let _e1984 = phi_3821_;
                                            let _e2003 = ((_e1984.member[0].x - _e363) * _e368);
                                            let _e2004 = ((_e1984.member[0].y - _e363) * _e368);
                                            let _e2005 = ((_e1984.member[0].z - _e364) * _e368);
                                            let _e2006 = ((_e1984.member[0].w - _e364) * _e368);
                                            let _e2016 = ((_e1984.member[1].x - _e429) * _e434);
                                            let _e2017 = ((_e1984.member[1].y - _e429) * _e434);
                                            let _e2018 = ((_e1984.member[1].z - _e430) * _e434);
                                            let _e2019 = ((_e1984.member[1].w - _e430) * _e434);
                                            let _e2029 = ((_e1984.member[2].x - _e495) * _e500);
                                            let _e2030 = ((_e1984.member[2].y - _e495) * _e500);
                                            let _e2031 = ((_e1984.member[2].z - _e496) * _e500);
                                            let _e2032 = ((_e1984.member[2].w - _e496) * _e500);
                                            let _e2034 = select(_e2031, _e2029, (_e2029 < _e2031));
                                            let _e2036 = select(_e2032, _e2030, (_e2030 < _e2032));
                                            let _e2038 = select(_e2031, _e2029, (_e2029 > _e2031));
                                            let _e2040 = select(_e2032, _e2030, (_e2030 > _e2032));
                                            let _e2042 = select(_e2005, _e2003, (_e2003 < _e2005));
                                            let _e2044 = select(_e2006, _e2004, (_e2004 < _e2006));
                                            let _e2046 = select(_e2018, _e2016, (_e2016 < _e2018));
                                            let _e2048 = select(_e2019, _e2017, (_e2017 < _e2019));
                                            let _e2050 = select(_e2046, _e2042, (_e2042 > _e2046));
                                            let _e2052 = select(_e2048, _e2044, (_e2044 > _e2048));
                                            let _e2054 = select(_e2034, _e2050, (_e2050 > _e2034));
                                            let _e2056 = select(_e2036, _e2052, (_e2052 > _e2036));
                                            let _e2058 = select(_e2005, _e2003, (_e2003 > _e2005));
                                            let _e2060 = select(_e2006, _e2004, (_e2004 > _e2006));
                                            let _e2062 = select(_e2018, _e2016, (_e2016 > _e2018));
                                            let _e2064 = select(_e2019, _e2017, (_e2017 > _e2019));
                                            let _e2066 = select(_e2062, _e2058, (_e2058 < _e2062));
                                            let _e2068 = select(_e2064, _e2060, (_e2060 < _e2064));
                                            let _e2073 = -(_e2034);
                                            let _e2074 = -(_e2036);
                                            let _e2081 = (select(_e2038, _e2066, (_e2066 < _e2038)) + (select(_e2073, _e2038, (_e2038 > _e2073)) * 0.0000019073523f));
                                            let _e2082 = (select(_e2040, _e2068, (_e2068 < _e2040)) + (select(_e2074, _e2040, (_e2040 > _e2074)) * 0.0000019073523f));
                                            let _e2084 = select(_e611, _e2054, (_e2054 > _e611));
                                            let _e2086 = select(_e611, _e2056, (_e2056 > _e611));
                                            let _e2091 = (_e2084 <= select(_e1670.member.member_1, _e2081, (_e2081 < _e1670.member.member_1)));
                                            let _e2092 = (_e2086 <= select(_e1670.member.member_1, _e2082, (_e2082 < _e1670.member.member_1)));
                                            let _e2093 = (_e2084 <= _e2086);
                                            if _e2091 {
                                                if _e2092 {
                                                    if _e2093 {
                                                        phi_4186_ = _e1984.member_2;
                                                    } else {
                                                        phi_4186_ = _e1984.member_1;
                                                    }
                                                    let _e2097 = phi_4186_;
                                                    let _e2118 = (_e702 % 128u);
                                                    let _e2119 = (_e2118 < 128u);
                                                    if _e2119 {
                                                    } else {
                                                        phi_4990_ = true;
                                                        break;
                                                    }
                                                    local_8[_e2118] = _e2097.member_1;
                                                    if _e2119 {
                                                    } else {
                                                        phi_4990_ = true;
                                                        break;
                                                    }
                                                    local_7[_e2118] = _e2097.member.member.x;
                                                    if _e2119 {
                                                    } else {
                                                        phi_4990_ = true;
                                                        break;
                                                    }
                                                    local_6[_e2118] = _e2097.member.member.y;
                                                    if _e2119 {
                                                    } else {
                                                        phi_4990_ = true;
                                                        break;
                                                    }
                                                    local_5[_e2118] = _e2097.member.member.z;
                                                    if _e2119 {
                                                    } else {
                                                        phi_4990_ = true;
                                                        break;
                                                    }
                                                    local_4[_e2118] = _e2097.member.member_1.x;
                                                    if _e2119 {
                                                    } else {
                                                        phi_4990_ = true;
                                                        break;
                                                    }
                                                    local_3[_e2118] = _e2097.member.member_1.y;
                                                    if _e2119 {
                                                    } else {
                                                        phi_4990_ = true;
                                                        break;
                                                    }
                                                    local_2[_e2118] = _e2097.member.member_1.z;
                                                    if _e2119 {
                                                    } else {
                                                        phi_4990_ = true;
                                                        break;
                                                    }
                                                    local_9[_e2118] = select(_e2084, _e2086, _e2093);
                                                    if _e2093 {
                                                        phi_4262_ = _e1984.member_1;
                                                    } else {
                                                        phi_4262_ = _e1984.member_2;
                                                    }
                                                    let _e2132 = phi_4262_;
                                                    phi_4263_ = (_e702 + 1u);
                                                    phi_4264_ = _e2132;
                                                } else {
                                                    phi_4263_ = u32();
                                                    phi_4264_ = type_49();
                                                }
                                                let _e2134 = phi_4263_;
                                                let _e2136 = phi_4264_;
                                                phi_4266_ = _e2134;
                                                phi_4267_ = _e2136;
                                                phi_4268_ = select(true, false, _e2092);
                                            } else {
                                                phi_4266_ = u32();
                                                phi_4267_ = type_49();
                                                phi_4268_ = true;
                                            }
                                            let _e2139 = phi_4266_;
                                            let _e2141 = phi_4267_;
                                            let _e2143 = phi_4268_;
                                            if _e2143 {
                                                if _e2091 {
                                                    phi_4277_ = _e1984.member_1;
                                                } else {
                                                    phi_4277_ = _e1984.member_2;
                                                }
                                                let _e2147 = phi_4277_;
                                                phi_4282_ = select(_e2092, true, _e2091);
                                                phi_4284_ = _e2147;
                                            } else {
                                                phi_4282_ = _e700;
                                                phi_4284_ = _e2141;
                                            }
                                            let _e2150 = phi_4282_;
                                            let _e2152 = phi_4284_;
                                            phi_4289_ = type_38(_e1670.member, (_e1670.member_1 + 1u), _e1670.member_2);
                                            phi_4290_ = _e2150;
                                            phi_4291_ = select(_e2139, _e702, _e2143);
                                            phi_4292_ = _e2152;
                                        }
                                        let _e2155 = phi_4289_;
                                        let _e2157 = phi_4290_;
                                        let _e2159 = phi_4291_;
                                        let _e2161 = phi_4292_;
                                        if _e708 {
                                            phi_4300_ = _e1670;
                                            phi_4303_ = _e704;
                                        } else {
                                            phi_4300_ = _e2155;
                                            phi_4303_ = _e2161;
                                        }
                                        let _e2163 = phi_4300_;
                                        let _e2165 = phi_4303_;
                                        phi_4993_ = _e1668;
                                        phi_4304_ = _e2163;
                                        phi_4305_ = (_e662 - 1u);
                                        phi_4306_ = select(_e2157, false, _e708);
                                        phi_4307_ = select(_e2159, _e702, _e708);
                                        phi_4308_ = _e2165;
                                    } else {
                                        phi_4993_ = _e658;
                                        phi_4304_ = _e660;
                                        phi_4305_ = _e662;
                                        phi_4306_ = _e700;
                                        phi_4307_ = _e702;
                                        phi_4308_ = _e704;
                                    }
                                    let _e2169 = phi_4993_;
                                    let _e2171 = phi_4304_;
                                    let _e2173 = phi_4305_;
                                    let _e2175 = phi_4306_;
                                    let _e2177 = phi_4307_;
                                    let _e2179 = phi_4308_;
                                    phi_4992_ = _e2169;
                                    phi_4309_ = _e2171;
                                    phi_4310_ = _e2173;
                                    phi_4311_ = _e2175;
                                    phi_4312_ = _e2177;
                                    phi_4313_ = _e2179;
                                } else {
                                    phi_4992_ = _e658;
                                    phi_4309_ = type_38();
                                    phi_4310_ = u32();
                                    phi_4311_ = bool();
                                    phi_4312_ = u32();
                                    phi_4313_ = type_49();
                                }
                                let _e2181 = phi_4992_;
                                let _e2183 = phi_4309_;
                                let _e2185 = phi_4310_;
                                let _e2187 = phi_4311_;
                                let _e2189 = phi_4312_;
                                let _e2191 = phi_4313_;
                                phi_4991_ = _e2181;
                                phi_1192_ = _e2183;
                                phi_1195_ = _e2185;
                                phi_1197_ = _e2187;
                                phi_1199_ = _e2189;
                                phi_1201_ = _e2191;
                                phi_4314_ = _e672;
                            } else {
                                phi_4991_ = _e658;
                                phi_1192_ = type_38();
                                phi_1195_ = u32();
                                phi_1197_ = bool();
                                phi_1199_ = u32();
                                phi_1201_ = type_49();
                                phi_4314_ = false;
                            }
                            let _e2193 = phi_4991_;
                            let _e2195 = phi_1192_;
                            let _e2197 = phi_1195_;
                            let _e2199 = phi_1197_;
                            let _e2201 = phi_1199_;
                            let _e2203 = phi_1201_;
                            let _e2205 = phi_4314_;
                            continue;
                            continuing {
                                phi_4789_ = _e2193;
                                phi_1191_ = _e2195;
                                phi_1194_ = _e2197;
                                phi_1196_ = _e2199;
                                phi_1198_ = _e2201;
                                phi_1200_ = _e2203;
                                phi_4990_ = _e2193;
                                break if !(_e2205);
                            }
                        }
                        let _e2208 = phi_4990_;
                        if _e2208 {
                            break;
                        }
                        let _e2210 = local_10;
                        if (_e2210.member.member.member_3 != 4294967295u) {
                            let _e2216 = bitcast<u32>(_e2210.member.member.member);
                            let _e2220 = (bitcast<i32>((_e2216 >> bitcast<u32>(23i))) & 255i);
                            let _e2221 = (_e2220 + _e280);
                            if (_e2220 == 255i) {
                                phi_4373_ = _e2210.member.member.member;
                            } else {
                                if (_e2220 > 0i) {
                                    if (_e2221 > 0i) {
                                        let _e2225 = (_e2221 < 255i);
                                        if _e2225 {
                                            phi_4352_ = bitcast<f32>((_e2216 + bitcast<u32>((_e280 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_4352_ = f32();
                                        }
                                        let _e2232 = phi_4352_;
                                        phi_4354_ = _e2232;
                                        phi_4355_ = select(true, false, _e2225);
                                    } else {
                                        phi_4354_ = f32();
                                        phi_4355_ = true;
                                    }
                                    let _e2235 = phi_4354_;
                                    let _e2237 = phi_4355_;
                                    phi_4356_ = _e2235;
                                    phi_4357_ = _e2237;
                                } else {
                                    phi_4356_ = f32();
                                    phi_4357_ = true;
                                }
                                let _e2239 = phi_4356_;
                                let _e2241 = phi_4357_;
                                if _e2241 {
                                    let _e2242 = (_e2216 & 2147483648u);
                                    let _e2249 = ((_e2216 & 8388607u) | (select(0u, 1u, ((_e2216 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e2253 = (_e2249 == 0u);
                                    if _e2253 {
                                        phi_4741_ = bitcast<f32>(_e2242);
                                    } else {
                                        let _e2258 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2249)), 32u, _e2253) - 8u);
                                        let _e2261 = (_e2249 << bitcast<u32>((_e2258 & 31u)));
                                        let _e2263 = ((_e2221 + select(0i, 1i, (_e2220 == 0i))) - bitcast<i32>(_e2258));
                                        if (_e2263 >= 255i) {
                                            phi_4731_ = bitcast<f32>((_e2242 | 2139095040u));
                                            phi_4732_ = f32();
                                            phi_4733_ = true;
                                        } else {
                                            let _e2265 = (_e2263 > 0i);
                                            if _e2265 {
                                                phi_4725_ = bitcast<f32>(((_e2242 | (bitcast<u32>(_e2263) << bitcast<u32>(23i))) | (_e2261 & 8388607u)));
                                                phi_4726_ = f32();
                                            } else {
                                                if (_e2263 < -24i) {
                                                    phi_4691_ = 26u;
                                                } else {
                                                    phi_4691_ = bitcast<u32>((1i - _e2263));
                                                }
                                                let _e2270 = phi_4691_;
                                                let _e2271 = (_e2270 & 31u);
                                                let _e2273 = (_e2261 >> bitcast<u32>(_e2271));
                                                let _e2277 = (_e2261 & ((1u << bitcast<u32>(_e2271)) - 1u));
                                                let _e2281 = (1u << bitcast<u32>(((_e2270 - 1u) & 31u)));
                                                if (_e2277 > _e2281) {
                                                    phi_4712_ = true;
                                                } else {
                                                    if (_e2277 == _e2281) {
                                                        phi_4709_ = ((_e2273 & 1u) == 1u);
                                                    } else {
                                                        phi_4709_ = false;
                                                    }
                                                    let _e2287 = phi_4709_;
                                                    phi_4712_ = _e2287;
                                                }
                                                let _e2289 = phi_4712_;
                                                phi_4725_ = f32();
                                                phi_4726_ = bitcast<f32>((_e2242 | (_e2273 + select(0u, 1u, _e2289))));
                                            }
                                            let _e2302 = phi_4725_;
                                            let _e2304 = phi_4726_;
                                            phi_4731_ = _e2302;
                                            phi_4732_ = _e2304;
                                            phi_4733_ = _e2265;
                                        }
                                        let _e2308 = phi_4731_;
                                        let _e2310 = phi_4732_;
                                        let _e2312 = phi_4733_;
                                        phi_4741_ = select(_e2310, _e2308, _e2312);
                                    }
                                    let _e2316 = phi_4741_;
                                    phi_4372_ = _e2316;
                                } else {
                                    phi_4372_ = _e2239;
                                }
                                let _e2318 = phi_4372_;
                                phi_4373_ = _e2318;
                            }
                            let _e2320 = phi_4373_;
                            let _e2321 = bitcast<u32>(_e2320);
                            if ((_e2321 & 2147483647u) >= 2139095040u) {
                                phi_4385_ = bitcast<f32>(((_e2321 & 2147483648u) | 2139095039u));
                            } else {
                                phi_4385_ = _e2320;
                            }
                            let _e2328 = phi_4385_;
                            phi_4390_ = type_18(_e2328, _e2210.member.member.member_1, _e2210.member.member.member_2, _e2210.member.member.member_3);
                        } else {
                            phi_4390_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e2333 = phi_4390_;
                        if _e156 {
                        } else {
                            break;
                        }
                        global_1.member[_e140] = _e2333;
                        let _e2337 = local_11;
                        if _e157 {
                        } else {
                            break;
                        }
                        global_4.member[_e140] = _e2337.member_1;
                        if _e155 {
                        } else {
                            break;
                        }
                        let _e2342 = select(0u, 1u, (_e224 <= _e234));
                        if (_e2342 > 0u) {
                            let _e2344 = (1u < _e108);
                            if _e2344 {
                                if (0u < _e108) {
                                } else {
                                    break;
                                }
                                let _e2348 = atomicAdd((&global_5.member[0u]), _e2342);
                                if ((_e2348 + _e2342) < _e2348) {
                                    if _e2344 {
                                    } else {
                                        break;
                                    }
                                    let _e2353 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e2356 = select(0u, 1u, (_e2333.member_3 != 4294967295u));
                        if (_e2356 > 0u) {
                            let _e2358 = (3u < _e108);
                            if _e2358 {
                                if (2u < _e108) {
                                } else {
                                    break;
                                }
                                let _e2362 = atomicAdd((&global_5.member[2u]), _e2356);
                                if ((_e2362 + _e2356) < _e2362) {
                                    if _e2358 {
                                    } else {
                                        break;
                                    }
                                    let _e2367 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e2337.member_1 > 0u) {
                            let _e2369 = (5u < _e108);
                            if _e2369 {
                                if (4u < _e108) {
                                } else {
                                    break;
                                }
                                let _e2373 = atomicAdd((&global_5.member[4u]), _e2337.member_1);
                                if ((_e2373 + _e2337.member_1) < _e2373) {
                                    if _e2369 {
                                    } else {
                                        break;
                                    }
                                    let _e2378 = atomicAdd((&global_5.member[5u]), 1u);
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
