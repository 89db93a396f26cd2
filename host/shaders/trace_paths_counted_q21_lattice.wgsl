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

struct type_34 {
    member: type_18,
    member_1: f32,
}

struct type_38 {
    member: type_34,
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
    var phi_396_: i32;
    var phi_397_: i32;
    var phi_407_: bool;
    var phi_417_: u32;
    var phi_418_: u32;
    var phi_420_: bool;
    var phi_425_: u32;
    var phi_457_: i32;
    var phi_475_: f32;
    var phi_481_: f32;
    var phi_492_: f32;
    var phi_498_: f32;
    var phi_521_: f32;
    var phi_532_: f32;
    var phi_541_: f32;
    var phi_547_: f32;
    var phi_558_: f32;
    var phi_564_: f32;
    var phi_587_: f32;
    var phi_598_: f32;
    var phi_607_: f32;
    var phi_613_: f32;
    var phi_624_: f32;
    var phi_630_: f32;
    var phi_653_: f32;
    var phi_664_: f32;
    var phi_764_: f32;
    var phi_765_: f32;
    var phi_3949_: bool;
    var phi_863_: type_38;
    var phi_866_: type_49;
    var phi_868_: u32;
    var phi_870_: bool;
    var phi_872_: u32;
    var phi_883_: bool;
    var phi_969_: type_49;
    var phi_970_: bool;
    var phi_971_: u32;
    var phi_2823_: u32;
    var phi_2829_: u32;
    var phi_3083_: u32;
    var phi_3084_: u32;
    var phi_3094_: u32;
    var phi_3096_: u32;
    var phi_3097_: bool;
    var phi_3117_: u32;
    var phi_3118_: u32;
    var phi_3122_: type_50;
    var phi_3466_: type_49;
    var phi_3543_: type_49;
    var phi_3544_: type_49;
    var phi_3545_: u32;
    var phi_3547_: type_49;
    var phi_3548_: u32;
    var phi_3549_: bool;
    var phi_3558_: type_49;
    var phi_3563_: type_49;
    var phi_3564_: bool;
    var phi_990_: type_38;
    var phi_993_: type_8;
    var phi_994_: type_8;
    var phi_1016_: type_8;
    var phi_1060_: u32;
    var phi_1066_: u32;
    var phi_1076_: u32;
    var phi_1092_: u32;
    var phi_1125_: u32;
    var phi_1131_: u32;
    var phi_1558_: u32;
    var phi_1576_: u32;
    var phi_1594_: u32;
    var phi_1614_: u32;
    var phi_1632_: u32;
    var phi_1650_: u32;
    var phi_1670_: u32;
    var phi_1688_: u32;
    var phi_1706_: u32;
    var phi_1284_: u32;
    var phi_1299_: u32;
    var phi_1309_: u32;
    var phi_1329_: u32;
    var phi_1349_: u32;
    var phi_1375_: u32;
    var phi_1390_: u32;
    var phi_1400_: u32;
    var phi_1420_: u32;
    var phi_1440_: u32;
    var phi_1466_: u32;
    var phi_1481_: u32;
    var phi_1491_: u32;
    var phi_1511_: u32;
    var phi_1531_: u32;
    var phi_1155_: u32;
    var phi_1198_: u32;
    var phi_1241_: u32;
    var phi_1712_: array<array<f32, 3>, 3>;
    var phi_2183_: vec3<f32>;
    var phi_2184_: vec3<f32>;
    var phi_2215_: bool;
    var phi_2224_: vec3<f32>;
    var phi_2264_: type_18;
    var phi_2266_: type_18;
    var phi_2267_: bool;
    var phi_2271_: type_18;
    var phi_2272_: type_18;
    var phi_2273_: type_18;
    var phi_2274_: bool;
    var phi_2278_: type_18;
    var phi_2279_: bool;
    var phi_2283_: type_18;
    var phi_2284_: bool;
    var phi_2288_: type_18;
    var phi_2313_: bool;
    var phi_2314_: bool;
    var phi_2321_: type_38;
    var phi_2322_: type_38;
    var phi_2323_: type_38;
    var phi_991_: type_38;
    var phi_3943_: bool;
    var phi_4108_: bool;
    var phi_3566_: type_38;
    var phi_3567_: type_49;
    var phi_3568_: bool;
    var phi_3569_: u32;
    var phi_4107_: bool;
    var phi_3570_: type_38;
    var phi_3571_: type_49;
    var phi_3572_: u32;
    var phi_3573_: bool;
    var phi_3574_: u32;
    var phi_4106_: bool;
    var phi_3575_: type_38;
    var phi_3576_: type_49;
    var phi_3577_: u32;
    var phi_3578_: bool;
    var phi_3579_: u32;
    var phi_4105_: bool;
    var phi_864_: type_38;
    var phi_867_: type_49;
    var phi_869_: u32;
    var phi_871_: bool;
    var phi_873_: u32;
    var phi_3580_: bool;
    var phi_4104_: bool;
    var local_10: type_38;
    var phi_3632_: type_18;
    var local_11: type_38;
    var local_12: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e89 = arrayLength((&global_6.member));
            let _e92 = arrayLength((&global_7.member));
            let _e100 = arrayLength((&global_5.member));
            let _e104 = global_2.member[0u][0u];
            let _e108 = global_2.member[0u][1u];
            let _e112 = global_2.member[0u][2u];
            let _e116 = global_2.member[0u][3u];
            let _e120 = global_2.member[1u][0u];
            let _e124 = global_2.member[1u][1u];
            let _e128 = global_2.member[1u][2u];
            let _e132 = (_e87.x + (_e87.y * 2097152u));
            let _e144 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e116) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e104), bitcast<i32>(_e108), bitcast<i32>(_e112));
            local = array<i32, 3>(bitcast<i32>(_e120), bitcast<i32>(_e124), bitcast<i32>(_e128));
            let _e147 = (_e132 < arrayLength((&global_3.member)));
            if _e147 {
                let _e148 = (_e132 < arrayLength((&global_1.member)));
                if _e148 {
                    let _e149 = (_e132 < arrayLength((&global_4.member)));
                    if _e149 {
                        if _e147 {
                        } else {
                            break;
                        }
                        let _e159 = global_3.member[_e132].member.member_2[0u];
                        let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                        let _e167 = global_3.member[_e132].member.member_2[1u];
                        let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                        let _e175 = global_3.member[_e132].member.member_2[2u];
                        let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                        let _e183 = global_3.member[_e132].member.member[0u];
                        let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                        let _e191 = global_3.member[_e132].member.member[1u];
                        let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                        let _e199 = global_3.member[_e132].member.member[2u];
                        let _e201 = (bitcast<u32>(_e199) & 2147483647u);
                        let _e203 = select(_e169, _e161, (_e169 < _e161));
                        let _e205 = select(_e177, _e203, (_e177 < _e203));
                        let _e207 = select(_e185, _e205, (_e185 < _e205));
                        let _e209 = select(_e193, _e207, (_e193 < _e207));
                        let _e211 = select(_e201, _e209, (_e201 < _e209));
                        let _e216 = global_3.member[_e132].member.member_1;
                        let _e218 = (bitcast<u32>(_e216) & 2147483647u);
                        let _e226 = global_3.member[_e132].member.member_3;
                        let _e232 = (((select(_e218, _e211, (_e218 < _e211)) < 2139095040u) && ((bitcast<u32>(_e226) & 2147483647u) <= 2139095040u)) && (_e205 > 0u));
                        if _e232 {
                            let _e235 = (bitcast<u32>(bitcast<f32>(_e205)) & 2147483647u);
                            if (_e235 >= 8388608u) {
                                phi_396_ = (bitcast<i32>((_e235 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_396_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e235)), 32u, (_e235 == 0u))));
                            }
                            let _e249 = phi_396_;
                            phi_397_ = _e249;
                        } else {
                            phi_397_ = 0i;
                        }
                        let _e251 = phi_397_;
                        let _e252 = (_e161 == _e205);
                        if _e252 {
                            phi_407_ = true;
                        } else {
                            phi_407_ = (_e169 == _e205);
                        }
                        let _e255 = phi_407_;
                        let _e256 = select(1u, 0u, _e252);
                        if _e255 {
                            let _e257 = (_e256 + 1u);
                            phi_417_ = _e257;
                            phi_418_ = _e257;
                            phi_420_ = select(true, false, (_e257 == 2u));
                        } else {
                            phi_417_ = u32();
                            phi_418_ = 0u;
                            phi_420_ = true;
                        }
                        let _e261 = phi_417_;
                        let _e263 = phi_418_;
                        let _e265 = phi_420_;
                        if _e265 {
                            phi_425_ = (_e263 + 1u);
                        } else {
                            phi_425_ = 0u;
                        }
                        let _e269 = phi_425_;
                        let _e270 = select(_e261, _e263, _e265);
                        let _e271 = select(_e256, select(2u, _e256, _e255), _e265);
                        let _e272 = -(_e251);
                        if (_e272 < -126i) {
                            phi_457_ = -126i;
                        } else {
                            phi_457_ = select(_e272, 127i, (_e272 > 127i));
                        }
                        let _e277 = phi_457_;
                        let _e282 = bitcast<f32>((bitcast<u32>((_e277 + 127i)) << bitcast<u32>(23i)));
                        let _e288 = bitcast<f32>((bitcast<u32>(((_e272 - _e277) + 127i)) << bitcast<u32>(23i)));
                        let _e293 = global_3.member[_e132].member.member;
                        let _e294 = (_e270 == 0u);
                        if _e294 {
                            phi_475_ = _e293[0];
                        } else {
                            phi_475_ = _e293[1];
                        }
                        let _e298 = phi_475_;
                        let _e299 = (_e270 == 2u);
                        if _e299 {
                            phi_481_ = _e293[2];
                        } else {
                            phi_481_ = _e298;
                        }
                        let _e302 = phi_481_;
                        let _e303 = global_3.member[_e132].member.member_2;
                        if _e294 {
                            phi_492_ = _e303[0];
                        } else {
                            phi_492_ = _e303[1];
                        }
                        let _e307 = phi_492_;
                        if _e299 {
                            phi_498_ = _e303[2];
                        } else {
                            phi_498_ = _e307;
                        }
                        let _e310 = phi_498_;
                        let _e312 = ((_e310 * _e282) * _e288);
                        let _e316 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e316 {
                            let _e320 = (bitcast<f32>((bitcast<u32>(_e302) & 2147483647u)) * 0.00000011920929f);
                            phi_521_ = select(0.00000000000011368684f, _e320, (_e320 > 0.00000000000011368684f));
                        } else {
                            phi_521_ = 0f;
                        }
                        let _e324 = phi_521_;
                        let _e325 = (_e302 + _e324);
                        let _e326 = (_e302 - _e324);
                        let _e327 = select(_e312, 0f, _e316);
                        if _e316 {
                            phi_532_ = 38685626000000000000000000f;
                        } else {
                            phi_532_ = (1f / _e312);
                        }
                        let _e330 = phi_532_;
                        let _e331 = (_e269 == 0u);
                        if _e331 {
                            phi_541_ = _e293[0];
                        } else {
                            phi_541_ = _e293[1];
                        }
                        let _e335 = phi_541_;
                        let _e336 = (_e269 == 2u);
                        if _e336 {
                            phi_547_ = _e293[2];
                        } else {
                            phi_547_ = _e335;
                        }
                        let _e339 = phi_547_;
                        if _e331 {
                            phi_558_ = _e303[0];
                        } else {
                            phi_558_ = _e303[1];
                        }
                        let _e343 = phi_558_;
                        if _e336 {
                            phi_564_ = _e303[2];
                        } else {
                            phi_564_ = _e343;
                        }
                        let _e346 = phi_564_;
                        let _e348 = ((_e346 * _e282) * _e288);
                        let _e352 = (bitcast<f32>((bitcast<u32>(_e348) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e352 {
                            let _e356 = (bitcast<f32>((bitcast<u32>(_e339) & 2147483647u)) * 0.00000011920929f);
                            phi_587_ = select(0.00000000000011368684f, _e356, (_e356 > 0.00000000000011368684f));
                        } else {
                            phi_587_ = 0f;
                        }
                        let _e360 = phi_587_;
                        let _e361 = (_e339 + _e360);
                        let _e362 = (_e339 - _e360);
                        let _e363 = select(_e348, 0f, _e352);
                        if _e352 {
                            phi_598_ = 38685626000000000000000000f;
                        } else {
                            phi_598_ = (1f / _e348);
                        }
                        let _e366 = phi_598_;
                        let _e367 = (_e271 == 0u);
                        if _e367 {
                            phi_607_ = _e293[0];
                        } else {
                            phi_607_ = _e293[1];
                        }
                        let _e371 = phi_607_;
                        let _e372 = (_e271 == 2u);
                        if _e372 {
                            phi_613_ = _e293[2];
                        } else {
                            phi_613_ = _e371;
                        }
                        let _e375 = phi_613_;
                        if _e367 {
                            phi_624_ = _e303[0];
                        } else {
                            phi_624_ = _e303[1];
                        }
                        let _e379 = phi_624_;
                        if _e372 {
                            phi_630_ = _e303[2];
                        } else {
                            phi_630_ = _e379;
                        }
                        let _e382 = phi_630_;
                        let _e384 = ((_e382 * _e282) * _e288);
                        let _e388 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e388 {
                            let _e392 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) * 0.00000011920929f);
                            phi_653_ = select(0.00000000000011368684f, _e392, (_e392 > 0.00000000000011368684f));
                        } else {
                            phi_653_ = 0f;
                        }
                        let _e396 = phi_653_;
                        let _e397 = (_e375 + _e396);
                        let _e398 = (_e375 - _e396);
                        let _e399 = select(_e384, 0f, _e388);
                        if _e388 {
                            phi_664_ = 38685626000000000000000000f;
                        } else {
                            phi_664_ = (1f / _e384);
                        }
                        let _e402 = phi_664_;
                        let _e405 = bitcast<f32>((bitcast<u32>(_e302) & 2147483647u));
                        let _e408 = bitcast<f32>((bitcast<u32>(_e339) & 2147483647u));
                        let _e410 = select(_e408, _e405, (_e405 > _e408));
                        let _e413 = bitcast<f32>((bitcast<u32>(_e375) & 2147483647u));
                        if (_e232 && (select(_e413, _e410, (_e410 > _e413)) <= 1099511600000f)) {
                            let _e418 = (_e251 / 3i);
                            let _e425 = bitcast<f32>((bitcast<u32>((_e418 + 127i)) << bitcast<u32>(23i)));
                            let _e432 = bitcast<f32>((bitcast<u32>(((_e251 - (2i * _e418)) + 127i)) << bitcast<u32>(23i)));
                            let _e433 = (((_e216 * _e425) * _e425) * _e432);
                            let _e435 = select(340282350000000000000000000000000000000f, _e433, (_e433 < 340282350000000000000000000000000000000f));
                            let _e440 = (((_e226 * _e425) * _e425) * _e432);
                            let _e442 = select(340282350000000000000000000000000000000f, _e440, (_e440 < 340282350000000000000000000000000000000f));
                            phi_764_ = select(-340282350000000000000000000000000000000f, _e442, (_e442 > -340282350000000000000000000000000000000f));
                            phi_765_ = select(-340282350000000000000000000000000000000f, _e435, (_e435 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_764_ = 0f;
                            phi_765_ = 1f;
                        }
                        let _e446 = phi_764_;
                        let _e448 = phi_765_;
                        if _e147 {
                        } else {
                            break;
                        }
                        let _e454 = global_3.member[_e132].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e457 = (_e270 % 3u);
                        let _e458 = (_e457 < 3u);
                        if _e458 {
                        } else {
                            break;
                        }
                        let _e460 = local_1[_e457];
                        let _e463 = (_e269 % 3u);
                        let _e464 = (_e463 < 3u);
                        if _e464 {
                        } else {
                            break;
                        }
                        let _e466 = local_1[_e463];
                        let _e469 = (_e271 % 3u);
                        let _e470 = (_e469 < 3u);
                        if _e470 {
                        } else {
                            break;
                        }
                        let _e472 = local_1[_e469];
                        if _e458 {
                        } else {
                            break;
                        }
                        let _e477 = local[_e457];
                        if _e464 {
                        } else {
                            break;
                        }
                        let _e481 = local[_e463];
                        if _e470 {
                        } else {
                            break;
                        }
                        let _e485 = local[_e469];
                        phi_3949_ = false;
                        phi_863_ = type_38(type_34(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e446), 0u, 0u);
                        phi_866_ = type_49(type_30(vec4<f32>((f32(_e460) * _e144), (f32(_e466) * _e144), (f32(_e472) * _e144), 0f), vec4<f32>((f32(_e477) * _e144), (f32(_e481) * _e144), (f32(_e485) * _e144), 0f)), select(0u, 2147483648u, (_e89 == 0u)));
                        phi_868_ = ((3u * _e89) + 1u);
                        phi_870_ = (_e448 <= _e446);
                        phi_872_ = 0u;
                        loop {
                            let _e495 = phi_3949_;
                            let _e497 = phi_863_;
                            let _e499 = phi_866_;
                            let _e501 = phi_868_;
                            let _e503 = phi_870_;
                            let _e505 = phi_872_;
                            local_10 = _e497;
                            local_11 = _e497;
                            if _e503 {
                                phi_883_ = true;
                            } else {
                                phi_883_ = (_e505 > 0u);
                            }
                            let _e508 = phi_883_;
                            if _e508 {
                                let _e509 = (_e501 > 0u);
                                if _e509 {
                                    if _e503 {
                                        phi_969_ = _e499;
                                        phi_970_ = _e503;
                                        phi_971_ = _e505;
                                    } else {
                                        let _e510 = (_e505 - 1u);
                                        let _e511 = (_e510 % 128u);
                                        let _e512 = (_e511 < 128u);
                                        if _e512 {
                                        } else {
                                            phi_4104_ = true;
                                            break;
                                        }
                                        let _e514 = local_7[_e511];
                                        if _e512 {
                                        } else {
                                            phi_4104_ = true;
                                            break;
                                        }
                                        let _e516 = local_6[_e511];
                                        if _e512 {
                                        } else {
                                            phi_4104_ = true;
                                            break;
                                        }
                                        let _e518 = local_5[_e511];
                                        if _e512 {
                                        } else {
                                            phi_4104_ = true;
                                            break;
                                        }
                                        let _e520 = local_4[_e511];
                                        if _e512 {
                                        } else {
                                            phi_4104_ = true;
                                            break;
                                        }
                                        let _e522 = local_3[_e511];
                                        if _e512 {
                                        } else {
                                            phi_4104_ = true;
                                            break;
                                        }
                                        let _e524 = local_2[_e511];
                                        if _e512 {
                                        } else {
                                            phi_4104_ = true;
                                            break;
                                        }
                                        let _e529 = local_8[_e511];
                                        if _e512 {
                                        } else {
                                            phi_4104_ = true;
                                            break;
                                        }
                                        let _e532 = local_9[_e511];
                                        phi_969_ = type_49(type_30(vec4<f32>(_e514, _e516, _e518, 0f), vec4<f32>(_e520, _e522, _e524, 0f)), _e529);
                                        phi_970_ = (_e532 <= _e497.member.member_1);
                                        phi_971_ = _e510;
                                    }
                                    let _e537 = phi_969_;
                                    let _e539 = phi_970_;
                                    let _e541 = phi_971_;
                                    if _e539 {
                                        let _e546 = (_e537.member_1 & 268435455u);
                                        if ((_e537.member_1 & 2147483648u) != 0u) {
                                            phi_990_ = _e497;
                                            phi_993_ = type_8(0u, ((_e537.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1031 = phi_990_;
                                                let _e1033 = phi_993_;
                                                local_12 = _e1031;
                                                if (_e1033.member < _e1033.member_1) {
                                                    phi_994_ = type_8((_e1033.member + 1u), _e1033.member_1);
                                                    phi_1016_ = type_8(1u, _e1033.member);
                                                } else {
                                                    phi_994_ = _e1033;
                                                    phi_1016_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1046 = phi_994_;
                                                let _e1048 = phi_1016_;
                                                let _e1052 = (bitcast<i32>(_e1048.member) != 0i);
                                                if _e1052 {
                                                    let _e1058 = type_38(_e1031.member, _e1031.member_1, (_e1031.member_2 + 1u));
                                                    let _e1063 = (_e537.member.member_1.x - _e537.member.member.x);
                                                    let _e1066 = (_e537.member.member_1.y - _e537.member.member.y);
                                                    let _e1069 = (_e537.member.member_1.z - _e537.member.member.z);
                                                    let _e1071 = select(_e1066, _e1063, (_e1063 > _e1066));
                                                    let _e1073 = select(_e1069, _e1071, (_e1071 > _e1069));
                                                    let _e1075 = (_e1073 < (1024f * _e144));
                                                    if _e1075 {
                                                        phi_1060_ = 0u;
                                                    } else {
                                                        phi_1060_ = select(2u, 1u, (_e1073 < (2097152f * _e144)));
                                                    }
                                                    let _e1080 = phi_1060_;
                                                    switch bitcast<i32>(_e1080) {
                                                        case 0: {
                                                            phi_1066_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1066_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1066_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1066_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1083 = phi_1066_;
                                                    switch bitcast<i32>(_e1080) {
                                                        case 0: {
                                                            phi_1076_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1076_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1076_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1076_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1090 = phi_1076_;
                                                    let _e1092 = ((_e546 + (_e1048.member_1 * ((3u * _e1083) + 1u))) + (3u * _e1090));
                                                    let _e1093 = (_e1092 < _e92);
                                                    if _e1093 {
                                                        if _e1093 {
                                                        } else {
                                                            phi_3943_ = true;
                                                            break;
                                                        }
                                                        let _e1095 = global_7.member[_e1092];
                                                        phi_1092_ = _e1095;
                                                    } else {
                                                        phi_1092_ = 4294967295u;
                                                    }
                                                    let _e1097 = phi_1092_;
                                                    if _e1075 {
                                                        phi_1125_ = 0u;
                                                    } else {
                                                        phi_1125_ = select(2u, 1u, (_e1073 < (2097152f * _e144)));
                                                    }
                                                    let _e1102 = phi_1125_;
                                                    switch bitcast<i32>(_e1102) {
                                                        case 0: {
                                                            phi_1131_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1131_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1131_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1131_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1105 = phi_1131_;
                                                    let _e1109 = (_e546 + (_e1048.member_1 * ((3u * _e1105) + 1u)));
                                                    switch bitcast<i32>(_e1102) {
                                                        case 0: {
                                                            let _e1375 = (_e1109 < _e92);
                                                            if _e1375 {
                                                                if _e1375 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1377 = global_7.member[_e1109];
                                                                phi_1155_ = _e1377;
                                                            } else {
                                                                phi_1155_ = 0u;
                                                            }
                                                            let _e1379 = phi_1155_;
                                                            let _e1381 = ((10u * _e270) & 31u);
                                                            let _e1390 = ((10u * _e269) & 31u);
                                                            let _e1399 = ((10u * _e271) & 31u);
                                                            let _e1408 = (_e1109 + 1u);
                                                            let _e1409 = (_e1408 < _e92);
                                                            if _e1409 {
                                                                if _e1409 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1411 = global_7.member[_e1408];
                                                                phi_1198_ = _e1411;
                                                            } else {
                                                                phi_1198_ = 0u;
                                                            }
                                                            let _e1413 = phi_1198_;
                                                            let _e1436 = (_e1109 + 2u);
                                                            let _e1437 = (_e1436 < _e92);
                                                            if _e1437 {
                                                                if _e1437 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1439 = global_7.member[_e1436];
                                                                phi_1241_ = _e1439;
                                                            } else {
                                                                phi_1241_ = 0u;
                                                            }
                                                            let _e1441 = phi_1241_;
                                                            phi_1712_ = array<array<f32, 3>, 3>(array<f32, 3>((_e537.member.member.x + (f32(bitcast<i32>(((_e1379 >> bitcast<u32>(_e1381)) & 1023u))) * _e144)), (_e537.member.member.y + (f32(bitcast<i32>(((_e1379 >> bitcast<u32>(_e1390)) & 1023u))) * _e144)), (_e537.member.member.z + (f32(bitcast<i32>(((_e1379 >> bitcast<u32>(_e1399)) & 1023u))) * _e144))), array<f32, 3>((_e537.member.member.x + (f32(bitcast<i32>(((_e1413 >> bitcast<u32>(_e1381)) & 1023u))) * _e144)), (_e537.member.member.y + (f32(bitcast<i32>(((_e1413 >> bitcast<u32>(_e1390)) & 1023u))) * _e144)), (_e537.member.member.z + (f32(bitcast<i32>(((_e1413 >> bitcast<u32>(_e1399)) & 1023u))) * _e144))), array<f32, 3>((_e537.member.member.x + (f32(bitcast<i32>(((_e1441 >> bitcast<u32>(_e1381)) & 1023u))) * _e144)), (_e537.member.member.y + (f32(bitcast<i32>(((_e1441 >> bitcast<u32>(_e1390)) & 1023u))) * _e144)), (_e537.member.member.z + (f32(bitcast<i32>(((_e1441 >> bitcast<u32>(_e1399)) & 1023u))) * _e144))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1198 = (_e1109 < _e92);
                                                            if _e1198 {
                                                                if _e1198 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1200 = global_7.member[_e1109];
                                                                phi_1284_ = _e1200;
                                                            } else {
                                                                phi_1284_ = 0u;
                                                            }
                                                            let _e1202 = phi_1284_;
                                                            let _e1203 = (_e1109 + 1u);
                                                            let _e1204 = (_e1203 < _e92);
                                                            if _e1204 {
                                                                if _e1204 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1206 = global_7.member[_e1203];
                                                                phi_1299_ = _e1206;
                                                            } else {
                                                                phi_1299_ = 0u;
                                                            }
                                                            let _e1208 = phi_1299_;
                                                            let _e1209 = (_e270 == 1u);
                                                            if _e1209 {
                                                                phi_1309_ = ((_e1202 >> bitcast<u32>(21i)) | (_e1208 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1309_ = (_e1208 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1218 = phi_1309_;
                                                            let _e1225 = (_e269 == 1u);
                                                            if _e1225 {
                                                                phi_1329_ = ((_e1202 >> bitcast<u32>(21i)) | (_e1208 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1329_ = (_e1208 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1234 = phi_1329_;
                                                            let _e1241 = (_e271 == 1u);
                                                            if _e1241 {
                                                                phi_1349_ = ((_e1202 >> bitcast<u32>(21i)) | (_e1208 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1349_ = (_e1208 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1250 = phi_1349_;
                                                            let _e1258 = (_e1109 + 2u);
                                                            let _e1259 = (_e1258 < _e92);
                                                            if _e1259 {
                                                                if _e1259 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1261 = global_7.member[_e1258];
                                                                phi_1375_ = _e1261;
                                                            } else {
                                                                phi_1375_ = 0u;
                                                            }
                                                            let _e1263 = phi_1375_;
                                                            let _e1264 = (_e1109 + 3u);
                                                            let _e1265 = (_e1264 < _e92);
                                                            if _e1265 {
                                                                if _e1265 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1267 = global_7.member[_e1264];
                                                                phi_1390_ = _e1267;
                                                            } else {
                                                                phi_1390_ = 0u;
                                                            }
                                                            let _e1269 = phi_1390_;
                                                            if _e1209 {
                                                                phi_1400_ = ((_e1263 >> bitcast<u32>(21i)) | (_e1269 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1400_ = (_e1269 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1278 = phi_1400_;
                                                            if _e1225 {
                                                                phi_1420_ = ((_e1263 >> bitcast<u32>(21i)) | (_e1269 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1420_ = (_e1269 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1293 = phi_1420_;
                                                            if _e1241 {
                                                                phi_1440_ = ((_e1263 >> bitcast<u32>(21i)) | (_e1269 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1440_ = (_e1269 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1308 = phi_1440_;
                                                            let _e1316 = (_e1109 + 4u);
                                                            let _e1317 = (_e1316 < _e92);
                                                            if _e1317 {
                                                                if _e1317 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1319 = global_7.member[_e1316];
                                                                phi_1466_ = _e1319;
                                                            } else {
                                                                phi_1466_ = 0u;
                                                            }
                                                            let _e1321 = phi_1466_;
                                                            let _e1322 = (_e1109 + 5u);
                                                            let _e1323 = (_e1322 < _e92);
                                                            if _e1323 {
                                                                if _e1323 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1325 = global_7.member[_e1322];
                                                                phi_1481_ = _e1325;
                                                            } else {
                                                                phi_1481_ = 0u;
                                                            }
                                                            let _e1327 = phi_1481_;
                                                            if _e1209 {
                                                                phi_1491_ = ((_e1321 >> bitcast<u32>(21i)) | (_e1327 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1491_ = (_e1327 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1336 = phi_1491_;
                                                            if _e1225 {
                                                                phi_1511_ = ((_e1321 >> bitcast<u32>(21i)) | (_e1327 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1511_ = (_e1327 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1351 = phi_1511_;
                                                            if _e1241 {
                                                                phi_1531_ = ((_e1321 >> bitcast<u32>(21i)) | (_e1327 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1531_ = (_e1327 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1366 = phi_1531_;
                                                            phi_1712_ = array<array<f32, 3>, 3>(array<f32, 3>((_e537.member.member.x + (f32(bitcast<i32>((select(_e1218, _e1202, _e294) & 2097151u))) * _e144)), (_e537.member.member.y + (f32(bitcast<i32>((select(_e1234, _e1202, _e331) & 2097151u))) * _e144)), (_e537.member.member.z + (f32(bitcast<i32>((select(_e1250, _e1202, _e367) & 2097151u))) * _e144))), array<f32, 3>((_e537.member.member.x + (f32(bitcast<i32>((select(_e1278, _e1263, _e294) & 2097151u))) * _e144)), (_e537.member.member.y + (f32(bitcast<i32>((select(_e1293, _e1263, _e331) & 2097151u))) * _e144)), (_e537.member.member.z + (f32(bitcast<i32>((select(_e1308, _e1263, _e367) & 2097151u))) * _e144))), array<f32, 3>((_e537.member.member.x + (f32(bitcast<i32>((select(_e1336, _e1321, _e294) & 2097151u))) * _e144)), (_e537.member.member.y + (f32(bitcast<i32>((select(_e1351, _e1321, _e331) & 2097151u))) * _e144)), (_e537.member.member.z + (f32(bitcast<i32>((select(_e1366, _e1321, _e367) & 2097151u))) * _e144))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1111 = (_e1109 + _e270);
                                                            let _e1112 = (_e1111 < _e92);
                                                            if _e1112 {
                                                                if _e1112 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1114 = global_7.member[_e1111];
                                                                phi_1558_ = _e1114;
                                                            } else {
                                                                phi_1558_ = 0u;
                                                            }
                                                            let _e1116 = phi_1558_;
                                                            let _e1120 = (_e1109 + _e269);
                                                            let _e1121 = (_e1120 < _e92);
                                                            if _e1121 {
                                                                if _e1121 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1123 = global_7.member[_e1120];
                                                                phi_1576_ = _e1123;
                                                            } else {
                                                                phi_1576_ = 0u;
                                                            }
                                                            let _e1125 = phi_1576_;
                                                            let _e1129 = (_e1109 + _e271);
                                                            let _e1130 = (_e1129 < _e92);
                                                            if _e1130 {
                                                                if _e1130 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1132 = global_7.member[_e1129];
                                                                phi_1594_ = _e1132;
                                                            } else {
                                                                phi_1594_ = 0u;
                                                            }
                                                            let _e1134 = phi_1594_;
                                                            let _e1139 = (_e1109 + 3u);
                                                            let _e1140 = (_e1139 + _e270);
                                                            let _e1141 = (_e1140 < _e92);
                                                            if _e1141 {
                                                                if _e1141 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1143 = global_7.member[_e1140];
                                                                phi_1614_ = _e1143;
                                                            } else {
                                                                phi_1614_ = 0u;
                                                            }
                                                            let _e1145 = phi_1614_;
                                                            let _e1149 = (_e1139 + _e269);
                                                            let _e1150 = (_e1149 < _e92);
                                                            if _e1150 {
                                                                if _e1150 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1152 = global_7.member[_e1149];
                                                                phi_1632_ = _e1152;
                                                            } else {
                                                                phi_1632_ = 0u;
                                                            }
                                                            let _e1154 = phi_1632_;
                                                            let _e1158 = (_e1139 + _e271);
                                                            let _e1159 = (_e1158 < _e92);
                                                            if _e1159 {
                                                                if _e1159 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1161 = global_7.member[_e1158];
                                                                phi_1650_ = _e1161;
                                                            } else {
                                                                phi_1650_ = 0u;
                                                            }
                                                            let _e1163 = phi_1650_;
                                                            let _e1168 = (_e1109 + 6u);
                                                            let _e1169 = (_e1168 + _e270);
                                                            let _e1170 = (_e1169 < _e92);
                                                            if _e1170 {
                                                                if _e1170 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1172 = global_7.member[_e1169];
                                                                phi_1670_ = _e1172;
                                                            } else {
                                                                phi_1670_ = 0u;
                                                            }
                                                            let _e1174 = phi_1670_;
                                                            let _e1178 = (_e1168 + _e269);
                                                            let _e1179 = (_e1178 < _e92);
                                                            if _e1179 {
                                                                if _e1179 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1181 = global_7.member[_e1178];
                                                                phi_1688_ = _e1181;
                                                            } else {
                                                                phi_1688_ = 0u;
                                                            }
                                                            let _e1183 = phi_1688_;
                                                            let _e1187 = (_e1168 + _e271);
                                                            let _e1188 = (_e1187 < _e92);
                                                            if _e1188 {
                                                                if _e1188 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1190 = global_7.member[_e1187];
                                                                phi_1706_ = _e1190;
                                                            } else {
                                                                phi_1706_ = 0u;
                                                            }
                                                            let _e1192 = phi_1706_;
                                                            phi_1712_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1116)) * _e144), (f32(bitcast<i32>(_e1125)) * _e144), (f32(bitcast<i32>(_e1134)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e1145)) * _e144), (f32(bitcast<i32>(_e1154)) * _e144), (f32(bitcast<i32>(_e1163)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e1174)) * _e144), (f32(bitcast<i32>(_e1183)) * _e144), (f32(bitcast<i32>(_e1192)) * _e144)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1712_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1466 = phi_1712_;
                                                    let _e1475 = (_e1466[0][2] - _e375);
                                                    let _e1478 = (((_e1466[0][0] - _e302) * _e399) - (_e1475 * _e327));
                                                    let _e1481 = (((_e1466[0][1] - _e339) * _e399) - (_e1475 * _e363));
                                                    let _e1488 = (_e1466[1][2] - _e375);
                                                    let _e1491 = (((_e1466[1][0] - _e302) * _e399) - (_e1488 * _e327));
                                                    let _e1494 = (((_e1466[1][1] - _e339) * _e399) - (_e1488 * _e363));
                                                    let _e1501 = (_e1466[2][2] - _e375);
                                                    let _e1504 = (((_e1466[2][0] - _e302) * _e399) - (_e1501 * _e327));
                                                    let _e1507 = (((_e1466[2][1] - _e339) * _e399) - (_e1501 * _e363));
                                                    let _e1508 = (_e1504 * _e1494);
                                                    let _e1509 = (_e1507 * _e1491);
                                                    let _e1510 = (_e1478 * _e1507);
                                                    let _e1511 = (_e1481 * _e1504);
                                                    let _e1512 = (_e1491 * _e1481);
                                                    let _e1513 = (_e1494 * _e1478);
                                                    let _e1518 = (((_e1508 >= _e1509) && (_e1510 >= _e1511)) && (_e1512 >= _e1513));
                                                    if (_e1518 || (((_e1508 <= _e1509) && (_e1510 <= _e1511)) && (_e1512 <= _e1513))) {
                                                        let _e1525 = select(-1f, 1f, _e1518);
                                                        let _e1527 = ((_e1508 - _e1509) * _e1525);
                                                        let _e1529 = select(0f, _e1527, (_e1527 > 0f));
                                                        let _e1531 = ((_e1510 - _e1511) * _e1525);
                                                        let _e1533 = select(0f, _e1531, (_e1531 > 0f));
                                                        let _e1535 = ((_e1512 - _e1513) * _e1525);
                                                        let _e1537 = select(0f, _e1535, (_e1535 > 0f));
                                                        let _e1539 = ((_e1529 + _e1533) + _e1537);
                                                        if (_e1539 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2278_ = type_18();
                                                            phi_2279_ = true;
                                                        } else {
                                                            let _e1542 = select(_e1466[1][0], _e1466[0][0], (_e1466[0][0] < _e1466[1][0]));
                                                            let _e1546 = select(_e1466[1][0], _e1466[0][0], (_e1466[0][0] > _e1466[1][0]));
                                                            let _e1550 = select(_e1466[1][1], _e1466[0][1], (_e1466[0][1] < _e1466[1][1]));
                                                            let _e1554 = select(_e1466[1][1], _e1466[0][1], (_e1466[0][1] > _e1466[1][1]));
                                                            let _e1558 = select(_e1466[1][2], _e1466[0][2], (_e1466[0][2] < _e1466[1][2]));
                                                            let _e1562 = select(_e1466[1][2], _e1466[0][2], (_e1466[0][2] > _e1466[1][2]));
                                                            let _e1567 = ((select(_e1466[2][0], _e1542, (_e1542 < _e1466[2][0])) - _e325) * _e330);
                                                            let _e1568 = ((select(_e1466[2][0], _e1546, (_e1546 > _e1466[2][0])) - _e326) * _e330);
                                                            let _e1571 = ((select(_e1466[2][1], _e1550, (_e1550 < _e1466[2][1])) - _e361) * _e366);
                                                            let _e1572 = ((select(_e1466[2][1], _e1554, (_e1554 > _e1466[2][1])) - _e362) * _e366);
                                                            let _e1575 = ((select(_e1466[2][2], _e1558, (_e1558 < _e1466[2][2])) - _e397) * _e402);
                                                            let _e1576 = ((select(_e1466[2][2], _e1562, (_e1562 > _e1466[2][2])) - _e398) * _e402);
                                                            let _e1578 = select(_e1576, _e1575, (_e1575 < _e1576));
                                                            let _e1580 = select(_e1576, _e1575, (_e1575 > _e1576));
                                                            let _e1582 = select(_e1568, _e1567, (_e1567 < _e1568));
                                                            let _e1584 = select(_e1572, _e1571, (_e1571 < _e1572));
                                                            let _e1586 = select(_e1584, _e1582, (_e1582 > _e1584));
                                                            let _e1588 = select(_e1578, _e1586, (_e1586 > _e1578));
                                                            let _e1590 = select(_e1568, _e1567, (_e1567 > _e1568));
                                                            let _e1592 = select(_e1572, _e1571, (_e1571 > _e1572));
                                                            let _e1594 = select(_e1592, _e1590, (_e1590 < _e1592));
                                                            let _e1596 = select(_e1580, _e1594, (_e1594 < _e1580));
                                                            let _e1597 = -(_e1578);
                                                            let _e1603 = select(_e448, _e1588, (_e1588 > _e448));
                                                            if (_e1603 > (_e1596 + (select(_e1597, _e1580, (_e1580 > _e1597)) * 0.0000019073523f))) {
                                                                phi_2273_ = type_18();
                                                                phi_2274_ = true;
                                                            } else {
                                                                let _e1605 = (_e1603 > _e1031.member.member_1);
                                                                if _e1605 {
                                                                    phi_2272_ = type_18();
                                                                } else {
                                                                    let _e1609 = (_e1466[1][0] - _e1466[0][0]);
                                                                    let _e1610 = (_e1466[1][1] - _e1466[0][1]);
                                                                    let _e1611 = (_e1466[1][2] - _e1466[0][2]);
                                                                    let _e1612 = vec3<f32>(_e1609, _e1610, _e1611);
                                                                    let _e1613 = (_e1466[2][0] - _e1466[1][0]);
                                                                    let _e1614 = (_e1466[2][1] - _e1466[1][1]);
                                                                    let _e1615 = (_e1466[2][2] - _e1466[1][2]);
                                                                    let _e1616 = vec3<f32>(_e1613, _e1614, _e1615);
                                                                    let _e1617 = (_e1466[0][0] - _e1466[2][0]);
                                                                    let _e1618 = (_e1466[0][1] - _e1466[2][1]);
                                                                    let _e1619 = (_e1466[0][2] - _e1466[2][2]);
                                                                    let _e1620 = vec3<f32>(_e1617, _e1618, _e1619);
                                                                    let _e1623 = bitcast<f32>((bitcast<u32>(_e1609) & 2147483647u));
                                                                    let _e1626 = bitcast<f32>((bitcast<u32>(_e1610) & 2147483647u));
                                                                    let _e1628 = select(_e1626, _e1623, (_e1623 > _e1626));
                                                                    let _e1631 = bitcast<f32>((bitcast<u32>(_e1611) & 2147483647u));
                                                                    let _e1633 = select(_e1631, _e1628, (_e1628 > _e1631));
                                                                    let _e1636 = bitcast<f32>((bitcast<u32>(_e1613) & 2147483647u));
                                                                    let _e1639 = bitcast<f32>((bitcast<u32>(_e1614) & 2147483647u));
                                                                    let _e1641 = select(_e1639, _e1636, (_e1636 > _e1639));
                                                                    let _e1644 = bitcast<f32>((bitcast<u32>(_e1615) & 2147483647u));
                                                                    let _e1646 = select(_e1644, _e1641, (_e1641 > _e1644));
                                                                    let _e1649 = bitcast<f32>((bitcast<u32>(_e1617) & 2147483647u));
                                                                    let _e1652 = bitcast<f32>((bitcast<u32>(_e1618) & 2147483647u));
                                                                    let _e1654 = select(_e1652, _e1649, (_e1649 > _e1652));
                                                                    let _e1657 = bitcast<f32>((bitcast<u32>(_e1619) & 2147483647u));
                                                                    let _e1659 = select(_e1657, _e1654, (_e1654 > _e1657));
                                                                    let _e1661 = select(_e1646, _e1633, (_e1633 > _e1646));
                                                                    let _e1663 = select(_e1659, _e1661, (_e1661 > _e1659));
                                                                    if (_e1633 == _e1663) {
                                                                        phi_2183_ = _e1616;
                                                                        phi_2184_ = _e1620;
                                                                    } else {
                                                                        let _e1666 = vec3((_e1646 == _e1663));
                                                                        phi_2183_ = select(_e1612, _e1620, _e1666);
                                                                        phi_2184_ = select(_e1616, _e1612, _e1666);
                                                                    }
                                                                    let _e1670 = phi_2183_;
                                                                    let _e1672 = phi_2184_;
                                                                    let _e1679 = ((_e1670.y * _e1672.z) - (_e1672.y * _e1670.z));
                                                                    let _e1684 = ((_e1670.z * _e1672.x) - (_e1672.z * _e1670.x));
                                                                    let _e1687 = ((_e1670.x * _e1672.y) - (_e1672.x * _e1670.y));
                                                                    if (_e1529 >= _e1533) {
                                                                        phi_2215_ = select(true, false, (_e1529 >= _e1537));
                                                                    } else {
                                                                        phi_2215_ = true;
                                                                    }
                                                                    let _e1692 = phi_2215_;
                                                                    if _e1692 {
                                                                        phi_2224_ = select(vec3<f32>(_e1466[2][0], _e1466[2][1], _e1466[2][2]), vec3<f32>(_e1466[1][0], _e1466[1][1], _e1466[1][2]), vec3((_e1533 >= _e1537)));
                                                                    } else {
                                                                        phi_2224_ = vec3<f32>(_e1466[0][0], _e1466[0][1], _e1466[0][2]);
                                                                    }
                                                                    let _e1697 = phi_2224_;
                                                                    let _e1714 = ((((_e1679 * (_e1697.x - _e302)) + (_e1684 * (_e1697.y - _e339))) + (_e1687 * (_e1697.z - _e375))) / (((_e1679 * _e327) + (_e1684 * _e363)) + (_e1687 * _e399)));
                                                                    let _e1716 = select(_e1596, _e1714, (_e1714 < _e1596));
                                                                    let _e1718 = select(_e1588, _e1716, (_e1716 > _e1588));
                                                                    if (_e1718 >= _e448) {
                                                                        let _e1720 = (_e1718 <= _e1031.member.member_1);
                                                                        if _e1720 {
                                                                            let _e1721 = (1f / _e1539);
                                                                            phi_2264_ = type_18(_e1718, (_e1533 * _e1721), (_e1537 * _e1721), _e1097);
                                                                        } else {
                                                                            phi_2264_ = type_18();
                                                                        }
                                                                        let _e1726 = phi_2264_;
                                                                        phi_2266_ = _e1726;
                                                                        phi_2267_ = select(true, false, _e1720);
                                                                    } else {
                                                                        phi_2266_ = type_18();
                                                                        phi_2267_ = true;
                                                                    }
                                                                    let _e1729 = phi_2266_;
                                                                    let _e1731 = phi_2267_;
                                                                    if _e1731 {
                                                                        phi_2271_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2271_ = _e1729;
                                                                    }
                                                                    let _e1733 = phi_2271_;
                                                                    phi_2272_ = _e1733;
                                                                }
                                                                let _e1735 = phi_2272_;
                                                                phi_2273_ = _e1735;
                                                                phi_2274_ = _e1605;
                                                            }
                                                            let _e1737 = phi_2273_;
                                                            let _e1739 = phi_2274_;
                                                            phi_2278_ = _e1737;
                                                            phi_2279_ = _e1739;
                                                        }
                                                        let _e1741 = phi_2278_;
                                                        let _e1743 = phi_2279_;
                                                        phi_2283_ = _e1741;
                                                        phi_2284_ = _e1743;
                                                    } else {
                                                        phi_2283_ = type_18();
                                                        phi_2284_ = true;
                                                    }
                                                    let _e1745 = phi_2283_;
                                                    let _e1747 = phi_2284_;
                                                    if _e1747 {
                                                        phi_2288_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2288_ = _e1745;
                                                    }
                                                    let _e1749 = phi_2288_;
                                                    if (_e1749.member_3 != 4294967295u) {
                                                        if (_e1097 != _e454) {
                                                            if (_e1749.member < _e1031.member.member.member) {
                                                                phi_2314_ = true;
                                                            } else {
                                                                if (_e1749.member == _e1031.member.member.member) {
                                                                    phi_2313_ = (_e1749.member_3 < _e1031.member.member.member_3);
                                                                } else {
                                                                    phi_2313_ = false;
                                                                }
                                                                let _e1764 = phi_2313_;
                                                                phi_2314_ = _e1764;
                                                            }
                                                            let _e1766 = phi_2314_;
                                                            if _e1766 {
                                                                phi_2321_ = type_38(type_34(_e1749, _e1749.member), _e1058.member_1, _e1058.member_2);
                                                            } else {
                                                                phi_2321_ = _e1058;
                                                            }
                                                            let _e1773 = phi_2321_;
                                                            phi_2322_ = _e1773;
                                                        } else {
                                                            phi_2322_ = _e1058;
                                                        }
                                                        let _e1775 = phi_2322_;
                                                        phi_2323_ = _e1775;
                                                    } else {
                                                        phi_2323_ = _e1058;
                                                    }
                                                    let _e1777 = phi_2323_;
                                                    phi_991_ = _e1777;
                                                } else {
                                                    phi_991_ = type_38();
                                                }
                                                let _e1779 = phi_991_;
                                                continue;
                                                continuing {
                                                    phi_990_ = _e1779;
                                                    phi_993_ = _e1046;
                                                    phi_3943_ = _e495;
                                                    break if !(_e1052);
                                                }
                                            }
                                            let _e1782 = phi_3943_;
                                            phi_4104_ = _e1782;
                                            if _e1782 {
                                                break;
                                            }
                                            phi_4108_ = _e1782;
                                            let _e2033 = local_12;
                                            phi_3566_ = _e2033;
                                            phi_3567_ = _e537;
                                            phi_3568_ = false;
                                            phi_3569_ = _e541;
                                        } else {
                                            if (_e537.member_1 >= _e89) {
                                                phi_3122_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e537.member_1 < _e89) {
                                                } else {
                                                    phi_4104_ = true;
                                                    break;
                                                }
                                                let _e559 = (_e270 * 2u);
                                                let _e561 = ((1u + _e559) % 7u);
                                                if (_e561 < 7u) {
                                                } else {
                                                    phi_4104_ = true;
                                                    break;
                                                }
                                                let _e566 = global_6.member[_e537.member_1][_e561];
                                                let _e568 = ((_e559 + 2u) % 7u);
                                                if (_e568 < 7u) {
                                                } else {
                                                    phi_4104_ = true;
                                                    break;
                                                }
                                                let _e573 = global_6.member[_e537.member_1][_e568];
                                                let _e574 = (_e269 * 2u);
                                                let _e576 = ((1u + _e574) % 7u);
                                                if (_e576 < 7u) {
                                                } else {
                                                    phi_4104_ = true;
                                                    break;
                                                }
                                                let _e581 = global_6.member[_e537.member_1][_e576];
                                                let _e583 = ((_e574 + 2u) % 7u);
                                                if (_e583 < 7u) {
                                                } else {
                                                    phi_4104_ = true;
                                                    break;
                                                }
                                                let _e588 = global_6.member[_e537.member_1][_e583];
                                                let _e589 = (_e271 * 2u);
                                                let _e591 = ((1u + _e589) % 7u);
                                                if (_e591 < 7u) {
                                                } else {
                                                    phi_4104_ = true;
                                                    break;
                                                }
                                                let _e596 = global_6.member[_e537.member_1][_e591];
                                                let _e598 = ((_e589 + 2u) % 7u);
                                                if (_e598 < 7u) {
                                                } else {
                                                    phi_4104_ = true;
                                                    break;
                                                }
                                                let _e603 = global_6.member[_e537.member_1][_e598];
                                                let _e626 = (bitcast<f32>((bitcast<u32>((_e537.member.member_1.x - _e537.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e627 = (bitcast<f32>((bitcast<u32>((_e537.member.member_1.y - _e537.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e628 = (bitcast<f32>((bitcast<u32>((_e537.member.member_1.z - _e537.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e630 = select(_e144, _e626, (_e626 > _e144));
                                                let _e632 = select(_e144, _e627, (_e627 > _e144));
                                                let _e634 = select(_e144, _e628, (_e628 > _e144));
                                                let _e659 = bitcast<u32>((f32(bitcast<i32>((_e566 & 2097151u))) * _e630));
                                                let _e664 = (bitcast<i32>((_e566 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e667 = bitcast<f32>((_e659 & bitcast<u32>(_e664)));
                                                let _e668 = bitcast<u32>((f32(bitcast<i32>((_e581 & 2097151u))) * _e632));
                                                let _e673 = (bitcast<i32>((_e581 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e676 = bitcast<f32>((_e668 & bitcast<u32>(_e673)));
                                                let _e677 = bitcast<u32>((f32(bitcast<i32>((_e596 & 2097151u))) * _e634));
                                                let _e682 = (bitcast<i32>((_e596 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e685 = bitcast<f32>((_e677 & bitcast<u32>(_e682)));
                                                let _e689 = bitcast<f32>((_e659 & bitcast<u32>(~(_e664))));
                                                let _e693 = bitcast<f32>((_e668 & bitcast<u32>(~(_e673))));
                                                let _e697 = bitcast<f32>((_e677 & bitcast<u32>(~(_e682))));
                                                let _e698 = bitcast<u32>((f32(bitcast<i32>((_e573 & 2097151u))) * _e630));
                                                let _e703 = (bitcast<i32>((_e573 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e706 = bitcast<f32>((_e698 & bitcast<u32>(_e703)));
                                                let _e707 = bitcast<u32>((f32(bitcast<i32>((_e588 & 2097151u))) * _e632));
                                                let _e712 = (bitcast<i32>((_e588 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e715 = bitcast<f32>((_e707 & bitcast<u32>(_e712)));
                                                let _e716 = bitcast<u32>((f32(bitcast<i32>((_e603 & 2097151u))) * _e634));
                                                let _e721 = (bitcast<i32>((_e603 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e724 = bitcast<f32>((_e716 & bitcast<u32>(_e721)));
                                                let _e728 = bitcast<f32>((_e698 & bitcast<u32>(~(_e703))));
                                                let _e732 = bitcast<f32>((_e707 & bitcast<u32>(~(_e712))));
                                                let _e736 = bitcast<f32>((_e716 & bitcast<u32>(~(_e721))));
                                                let _e737 = (_e537.member.member.x + _e667);
                                                let _e738 = (_e537.member.member.y + _e676);
                                                let _e739 = (_e537.member.member.z + _e685);
                                                let _e742 = (_e537.member.member_1.x - _e706);
                                                let _e743 = (_e537.member.member_1.y - _e715);
                                                let _e744 = (_e537.member.member_1.z - _e724);
                                                let _e763 = (_e742 - _e737);
                                                let _e764 = (_e743 - _e738);
                                                let _e765 = (_e744 - _e739);
                                                let _e767 = select(_e764, _e763, (_e763 > _e764));
                                                let _e769 = select(_e765, _e767, (_e767 > _e765));
                                                if (_e769 < (1024f * _e144)) {
                                                    phi_2823_ = 0u;
                                                } else {
                                                    phi_2823_ = select(2u, 1u, (_e769 < (2097152f * _e144)));
                                                }
                                                let _e776 = phi_2823_;
                                                switch bitcast<i32>(_e776) {
                                                    case 0: {
                                                        phi_2829_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2829_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2829_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2829_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e779 = phi_2829_;
                                                let _e785 = global_6.member[_e537.member_1][0u];
                                                let _e789 = global_6.member[_e537.member_1][2u];
                                                let _e793 = global_6.member[_e537.member_1][4u];
                                                let _e797 = global_6.member[_e537.member_1][6u];
                                                let _e809 = (((_e789 >> bitcast<u32>(22i)) | ((_e793 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e797 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e810 = (_e785 & 268435455u);
                                                let _e811 = (_e809 & 268435455u);
                                                let _e814 = ((_e785 >> bitcast<u32>(28u)) & 7u);
                                                let _e822 = ((_e785 >> bitcast<u32>(31i)) | (((_e809 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e823 = (_e814 != 0u);
                                                if (_e814 == 0u) {
                                                    phi_3084_ = _e810;
                                                } else {
                                                    if (_e814 == 7u) {
                                                        phi_3083_ = 2147483648u;
                                                    } else {
                                                        phi_3083_ = ((2147483648u | (_e814 << bitcast<u32>(28u))) | (_e811 & 268435455u));
                                                    }
                                                    let _e832 = phi_3083_;
                                                    phi_3084_ = _e832;
                                                }
                                                let _e834 = phi_3084_;
                                                if _e823 {
                                                    let _e835 = (_e814 != 7u);
                                                    if _e835 {
                                                        phi_3094_ = (_e811 + (_e814 * ((3u * _e779) + 1u)));
                                                    } else {
                                                        phi_3094_ = u32();
                                                    }
                                                    let _e839 = phi_3094_;
                                                    phi_3096_ = _e839;
                                                    phi_3097_ = select(true, false, _e835);
                                                } else {
                                                    phi_3096_ = u32();
                                                    phi_3097_ = true;
                                                }
                                                let _e842 = phi_3096_;
                                                let _e844 = phi_3097_;
                                                if (_e822 == 0u) {
                                                    phi_3118_ = (_e810 + select(0u, 1u, !(_e823)));
                                                } else {
                                                    if (_e822 == 7u) {
                                                        phi_3117_ = 2147483648u;
                                                    } else {
                                                        phi_3117_ = ((2147483648u | (_e822 << bitcast<u32>(28u))) | (select(_e842, _e811, _e844) & 268435455u));
                                                    }
                                                    let _e857 = phi_3117_;
                                                    phi_3118_ = _e857;
                                                }
                                                let _e859 = phi_3118_;
                                                phi_3122_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e737, (_e537.member.member.x + _e689), _e742, (_e537.member.member_1.x - _e728)), vec4<f32>(_e738, (_e537.member.member.y + _e693), _e743, (_e537.member.member_1.y - _e732)), vec4<f32>(_e739, (_e537.member.member.z + _e697), _e744, (_e537.member.member_1.z - _e736))), type_49(type_30((_e537.member.member + vec4<f32>(_e667, _e676, _e685, 0f)), (_e537.member.member_1 - vec4<f32>(_e706, _e715, _e724, 0f))), _e834), type_49(type_30((_e537.member.member + vec4<f32>(_e689, _e693, _e697, 0f)), (_e537.member.member_1 - vec4<f32>(_e728, _e732, _e736, 0f))), _e859));
                                            }
                                            let _e864 = phi_3122_;
                                            let _e877 = ((_e864.member[0].x - _e325) * _e330);
                                            let _e878 = ((_e864.member[0].y - _e325) * _e330);
                                            let _e879 = ((_e864.member[0].z - _e326) * _e330);
                                            let _e880 = ((_e864.member[0].w - _e326) * _e330);
                                            let _e890 = ((_e864.member[1].x - _e361) * _e366);
                                            let _e891 = ((_e864.member[1].y - _e361) * _e366);
                                            let _e892 = ((_e864.member[1].z - _e362) * _e366);
                                            let _e893 = ((_e864.member[1].w - _e362) * _e366);
                                            let _e903 = ((_e864.member[2].x - _e397) * _e402);
                                            let _e904 = ((_e864.member[2].y - _e397) * _e402);
                                            let _e905 = ((_e864.member[2].z - _e398) * _e402);
                                            let _e906 = ((_e864.member[2].w - _e398) * _e402);
                                            let _e908 = select(_e905, _e903, (_e903 < _e905));
                                            let _e910 = select(_e906, _e904, (_e904 < _e906));
                                            let _e912 = select(_e905, _e903, (_e903 > _e905));
                                            let _e914 = select(_e906, _e904, (_e904 > _e906));
                                            let _e916 = select(_e879, _e877, (_e877 < _e879));
                                            let _e918 = select(_e880, _e878, (_e878 < _e880));
                                            let _e920 = select(_e892, _e890, (_e890 < _e892));
                                            let _e922 = select(_e893, _e891, (_e891 < _e893));
                                            let _e924 = select(_e920, _e916, (_e916 > _e920));
                                            let _e926 = select(_e922, _e918, (_e918 > _e922));
                                            let _e928 = select(_e908, _e924, (_e924 > _e908));
                                            let _e930 = select(_e910, _e926, (_e926 > _e910));
                                            let _e932 = select(_e879, _e877, (_e877 > _e879));
                                            let _e934 = select(_e880, _e878, (_e878 > _e880));
                                            let _e936 = select(_e892, _e890, (_e890 > _e892));
                                            let _e938 = select(_e893, _e891, (_e891 > _e893));
                                            let _e940 = select(_e936, _e932, (_e932 < _e936));
                                            let _e942 = select(_e938, _e934, (_e934 < _e938));
                                            let _e947 = -(_e908);
                                            let _e948 = -(_e910);
                                            let _e955 = (select(_e912, _e940, (_e940 < _e912)) + (select(_e947, _e912, (_e912 > _e947)) * 0.0000019073523f));
                                            let _e956 = (select(_e914, _e942, (_e942 < _e914)) + (select(_e948, _e914, (_e914 > _e948)) * 0.0000019073523f));
                                            let _e958 = select(_e448, _e928, (_e928 > _e448));
                                            let _e960 = select(_e448, _e930, (_e930 > _e448));
                                            let _e965 = (_e958 <= select(_e497.member.member_1, _e955, (_e955 < _e497.member.member_1)));
                                            let _e966 = (_e960 <= select(_e497.member.member_1, _e956, (_e956 < _e497.member.member_1)));
                                            let _e967 = (_e958 <= _e960);
                                            if _e965 {
                                                if _e966 {
                                                    if _e967 {
                                                        phi_3466_ = _e864.member_2;
                                                    } else {
                                                        phi_3466_ = _e864.member_1;
                                                    }
                                                    let _e971 = phi_3466_;
                                                    let _e993 = (_e541 % 128u);
                                                    let _e994 = (_e993 < 128u);
                                                    if _e994 {
                                                    } else {
                                                        phi_4104_ = true;
                                                        break;
                                                    }
                                                    local_8[_e993] = _e971.member_1;
                                                    if _e994 {
                                                    } else {
                                                        phi_4104_ = true;
                                                        break;
                                                    }
                                                    local_7[_e993] = _e971.member.member.x;
                                                    if _e994 {
                                                    } else {
                                                        phi_4104_ = true;
                                                        break;
                                                    }
                                                    local_6[_e993] = _e971.member.member.y;
                                                    if _e994 {
                                                    } else {
                                                        phi_4104_ = true;
                                                        break;
                                                    }
                                                    local_5[_e993] = _e971.member.member.z;
                                                    if _e994 {
                                                    } else {
                                                        phi_4104_ = true;
                                                        break;
                                                    }
                                                    local_4[_e993] = _e971.member.member_1.x;
                                                    if _e994 {
                                                    } else {
                                                        phi_4104_ = true;
                                                        break;
                                                    }
                                                    local_3[_e993] = _e971.member.member_1.y;
                                                    if _e994 {
                                                    } else {
                                                        phi_4104_ = true;
                                                        break;
                                                    }
                                                    local_2[_e993] = _e971.member.member_1.z;
                                                    if _e994 {
                                                    } else {
                                                        phi_4104_ = true;
                                                        break;
                                                    }
                                                    local_9[_e993] = select(_e960, _e958, (_e958 > _e960));
                                                    if _e967 {
                                                        phi_3543_ = _e864.member_1;
                                                    } else {
                                                        phi_3543_ = _e864.member_2;
                                                    }
                                                    let _e1007 = phi_3543_;
                                                    phi_3544_ = _e1007;
                                                    phi_3545_ = (_e541 + 1u);
                                                } else {
                                                    phi_3544_ = type_49();
                                                    phi_3545_ = u32();
                                                }
                                                let _e1009 = phi_3544_;
                                                let _e1011 = phi_3545_;
                                                phi_3547_ = _e1009;
                                                phi_3548_ = _e1011;
                                                phi_3549_ = select(true, false, _e966);
                                            } else {
                                                phi_3547_ = type_49();
                                                phi_3548_ = u32();
                                                phi_3549_ = true;
                                            }
                                            let _e1014 = phi_3547_;
                                            let _e1016 = phi_3548_;
                                            let _e1018 = phi_3549_;
                                            if _e1018 {
                                                if _e965 {
                                                    phi_3558_ = _e864.member_1;
                                                } else {
                                                    phi_3558_ = _e864.member_2;
                                                }
                                                let _e1022 = phi_3558_;
                                                phi_3563_ = _e1022;
                                                phi_3564_ = select(_e966, true, _e965);
                                            } else {
                                                phi_3563_ = _e1014;
                                                phi_3564_ = _e539;
                                            }
                                            let _e1025 = phi_3563_;
                                            let _e1027 = phi_3564_;
                                            phi_4108_ = _e495;
                                            phi_3566_ = type_38(_e497.member, (_e497.member_1 + 1u), _e497.member_2);
                                            phi_3567_ = _e1025;
                                            phi_3568_ = _e1027;
                                            phi_3569_ = select(_e1016, _e541, _e1018);
                                        }
                                        let _e1784 = phi_4108_;
                                        let _e1786 = phi_3566_;
                                        let _e1788 = phi_3567_;
                                        let _e1790 = phi_3568_;
                                        let _e1792 = phi_3569_;
                                        phi_4107_ = _e1784;
                                        phi_3570_ = _e1786;
                                        phi_3571_ = _e1788;
                                        phi_3572_ = (_e501 - 1u);
                                        phi_3573_ = _e1790;
                                        phi_3574_ = _e1792;
                                    } else {
                                        phi_4107_ = _e495;
                                        phi_3570_ = _e497;
                                        phi_3571_ = _e537;
                                        phi_3572_ = _e501;
                                        phi_3573_ = _e539;
                                        phi_3574_ = _e541;
                                    }
                                    let _e1794 = phi_4107_;
                                    let _e1796 = phi_3570_;
                                    let _e1798 = phi_3571_;
                                    let _e1800 = phi_3572_;
                                    let _e1802 = phi_3573_;
                                    let _e1804 = phi_3574_;
                                    phi_4106_ = _e1794;
                                    phi_3575_ = _e1796;
                                    phi_3576_ = _e1798;
                                    phi_3577_ = _e1800;
                                    phi_3578_ = _e1802;
                                    phi_3579_ = _e1804;
                                } else {
                                    phi_4106_ = _e495;
                                    phi_3575_ = type_38();
                                    phi_3576_ = type_49();
                                    phi_3577_ = u32();
                                    phi_3578_ = bool();
                                    phi_3579_ = u32();
                                }
                                let _e1806 = phi_4106_;
                                let _e1808 = phi_3575_;
                                let _e1810 = phi_3576_;
                                let _e1812 = phi_3577_;
                                let _e1814 = phi_3578_;
                                let _e1816 = phi_3579_;
                                phi_4105_ = _e1806;
                                phi_864_ = _e1808;
                                phi_867_ = _e1810;
                                phi_869_ = _e1812;
                                phi_871_ = _e1814;
                                phi_873_ = _e1816;
                                phi_3580_ = _e509;
                            } else {
                                phi_4105_ = _e495;
                                phi_864_ = type_38();
                                phi_867_ = type_49();
                                phi_869_ = u32();
                                phi_871_ = bool();
                                phi_873_ = u32();
                                phi_3580_ = false;
                            }
                            let _e1818 = phi_4105_;
                            let _e1820 = phi_864_;
                            let _e1822 = phi_867_;
                            let _e1824 = phi_869_;
                            let _e1826 = phi_871_;
                            let _e1828 = phi_873_;
                            let _e1830 = phi_3580_;
                            continue;
                            continuing {
                                phi_3949_ = _e1818;
                                phi_863_ = _e1820;
                                phi_866_ = _e1822;
                                phi_868_ = _e1824;
                                phi_870_ = _e1826;
                                phi_872_ = _e1828;
                                phi_4104_ = _e1818;
                                break if !(_e1830);
                            }
                        }
                        let _e1833 = phi_4104_;
                        if _e1833 {
                            break;
                        }
                        let _e1835 = local_10;
                        if (_e1835.member.member.member_3 != 4294967295u) {
                            let _e1841 = (_e272 / 3i);
                            let _e1848 = bitcast<f32>((bitcast<u32>((_e1841 + 127i)) << bitcast<u32>(23i)));
                            let _e1856 = (((_e1835.member.member.member * _e1848) * _e1848) * bitcast<f32>((bitcast<u32>(((_e272 - (2i * _e1841)) + 127i)) << bitcast<u32>(23i))));
                            let _e1858 = select(340282350000000000000000000000000000000f, _e1856, (_e1856 < 340282350000000000000000000000000000000f));
                            phi_3632_ = type_18(select(-340282350000000000000000000000000000000f, _e1858, (_e1858 > -340282350000000000000000000000000000000f)), _e1835.member.member.member_1, _e1835.member.member.member_2, _e1835.member.member.member_3);
                        } else {
                            phi_3632_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1865 = phi_3632_;
                        if _e148 {
                        } else {
                            break;
                        }
                        global_1.member[_e132] = _e1865;
                        let _e1869 = local_11;
                        if _e149 {
                        } else {
                            break;
                        }
                        global_4.member[_e132] = _e1869.member_1;
                        if _e147 {
                        } else {
                            break;
                        }
                        let _e1874 = select(0u, 1u, (_e216 <= _e226));
                        if (_e1874 > 0u) {
                            let _e1876 = (1u < _e100);
                            if _e1876 {
                                if (0u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1880 = atomicAdd((&global_5.member[0u]), _e1874);
                                if ((_e1880 + _e1874) < _e1880) {
                                    if _e1876 {
                                    } else {
                                        break;
                                    }
                                    let _e1885 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1888 = select(0u, 1u, (_e1865.member_3 != 4294967295u));
                        if (_e1888 > 0u) {
                            let _e1890 = (3u < _e100);
                            if _e1890 {
                                if (2u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1894 = atomicAdd((&global_5.member[2u]), _e1888);
                                if ((_e1894 + _e1888) < _e1894) {
                                    if _e1890 {
                                    } else {
                                        break;
                                    }
                                    let _e1899 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1869.member_1 > 0u) {
                            let _e1901 = (5u < _e100);
                            if _e1901 {
                                if (4u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1905 = atomicAdd((&global_5.member[4u]), _e1869.member_1);
                                if ((_e1905 + _e1869.member_1) < _e1905) {
                                    if _e1901 {
                                    } else {
                                        break;
                                    }
                                    let _e1910 = atomicAdd((&global_5.member[5u]), 1u);
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
