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

struct type_34 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_38 {
    member: type_22,
    member_1: f32,
}

struct type_42 {
    member: type_38,
    member_1: u32,
    member_2: u32,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: type_34,
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
var<storage, read_write> global_1: type_24;
@group(0) @binding(0) 
var<uniform> global_2: type_44;
@group(0) @binding(1) 
var<storage> global_3: type_13;
@group(0) @binding(3) 
var<storage> global_4: type_29;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_55;
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
    var phi_863_: type_42;
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
    var phi_990_: type_42;
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
    var phi_2264_: type_22;
    var phi_2266_: type_22;
    var phi_2267_: bool;
    var phi_2271_: type_22;
    var phi_2272_: type_22;
    var phi_2273_: type_22;
    var phi_2274_: bool;
    var phi_2278_: type_22;
    var phi_2279_: bool;
    var phi_2283_: type_22;
    var phi_2284_: bool;
    var phi_2288_: type_22;
    var phi_2313_: bool;
    var phi_2314_: bool;
    var phi_2321_: type_42;
    var phi_2322_: type_42;
    var phi_2323_: type_42;
    var phi_991_: type_42;
    var phi_3943_: bool;
    var phi_4108_: bool;
    var phi_3566_: type_42;
    var phi_3567_: type_49;
    var phi_3568_: bool;
    var phi_3569_: u32;
    var phi_4107_: bool;
    var phi_3570_: type_42;
    var phi_3571_: type_49;
    var phi_3572_: u32;
    var phi_3573_: bool;
    var phi_3574_: u32;
    var phi_4106_: bool;
    var phi_3575_: type_42;
    var phi_3576_: type_49;
    var phi_3577_: u32;
    var phi_3578_: bool;
    var phi_3579_: u32;
    var phi_4105_: bool;
    var phi_864_: type_42;
    var phi_867_: type_49;
    var phi_869_: u32;
    var phi_871_: bool;
    var phi_873_: u32;
    var phi_3580_: bool;
    var phi_4104_: bool;
    var local_10: type_42;
    var phi_3632_: type_22;
    var local_11: type_42;
    var local_12: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e89 = global;
            let _e91 = arrayLength((&global_3.member));
            let _e94 = arrayLength((&global_7.member));
            let _e102 = arrayLength((&global_6.member));
            let _e106 = global_2.member[0u][0u];
            let _e110 = global_2.member[0u][1u];
            let _e114 = global_2.member[0u][2u];
            let _e118 = global_2.member[0u][3u];
            let _e122 = global_2.member[1u][0u];
            let _e126 = global_2.member[1u][1u];
            let _e130 = global_2.member[1u][2u];
            let _e134 = (_e89.x + (_e89.y * 2097152u));
            let _e146 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e118) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e106), bitcast<i32>(_e110), bitcast<i32>(_e114));
            local = array<i32, 3>(bitcast<i32>(_e122), bitcast<i32>(_e126), bitcast<i32>(_e130));
            let _e149 = (_e134 < arrayLength((&global_4.member)));
            if _e149 {
                let _e150 = (_e134 < arrayLength((&global_1.member)));
                if _e150 {
                    let _e151 = (_e134 < arrayLength((&global_5.member)));
                    if _e151 {
                        if _e149 {
                        } else {
                            break;
                        }
                        let _e161 = global_4.member[_e134].member.member_2[0u];
                        let _e163 = (bitcast<u32>(_e161) & 2147483647u);
                        let _e169 = global_4.member[_e134].member.member_2[1u];
                        let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                        let _e177 = global_4.member[_e134].member.member_2[2u];
                        let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                        let _e185 = global_4.member[_e134].member.member[0u];
                        let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                        let _e193 = global_4.member[_e134].member.member[1u];
                        let _e195 = (bitcast<u32>(_e193) & 2147483647u);
                        let _e201 = global_4.member[_e134].member.member[2u];
                        let _e203 = (bitcast<u32>(_e201) & 2147483647u);
                        let _e205 = select(_e171, _e163, (_e171 < _e163));
                        let _e207 = select(_e179, _e205, (_e179 < _e205));
                        let _e209 = select(_e187, _e207, (_e187 < _e207));
                        let _e211 = select(_e195, _e209, (_e195 < _e209));
                        let _e213 = select(_e203, _e211, (_e203 < _e211));
                        let _e218 = global_4.member[_e134].member.member_1;
                        let _e220 = (bitcast<u32>(_e218) & 2147483647u);
                        let _e228 = global_4.member[_e134].member.member_3;
                        let _e234 = (((select(_e220, _e213, (_e220 < _e213)) < 2139095040u) && ((bitcast<u32>(_e228) & 2147483647u) <= 2139095040u)) && (_e207 > 0u));
                        if _e234 {
                            let _e237 = (bitcast<u32>(bitcast<f32>(_e207)) & 2147483647u);
                            if (_e237 >= 8388608u) {
                                phi_396_ = (bitcast<i32>((_e237 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_396_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e237)), 32u, (_e237 == 0u))));
                            }
                            let _e251 = phi_396_;
                            phi_397_ = _e251;
                        } else {
                            phi_397_ = 0i;
                        }
                        let _e253 = phi_397_;
                        let _e254 = (_e163 == _e207);
                        if _e254 {
                            phi_407_ = true;
                        } else {
                            phi_407_ = (_e171 == _e207);
                        }
                        let _e257 = phi_407_;
                        let _e258 = select(1u, 0u, _e254);
                        if _e257 {
                            let _e259 = (_e258 + 1u);
                            phi_417_ = _e259;
                            phi_418_ = _e259;
                            phi_420_ = select(true, false, (_e259 == 2u));
                        } else {
                            phi_417_ = u32();
                            phi_418_ = 0u;
                            phi_420_ = true;
                        }
                        let _e263 = phi_417_;
                        let _e265 = phi_418_;
                        let _e267 = phi_420_;
                        if _e267 {
                            phi_425_ = (_e265 + 1u);
                        } else {
                            phi_425_ = 0u;
                        }
                        let _e271 = phi_425_;
                        let _e272 = select(_e263, _e265, _e267);
                        let _e273 = select(_e258, select(2u, _e258, _e257), _e267);
                        let _e274 = -(_e253);
                        if (_e274 < -126i) {
                            phi_457_ = -126i;
                        } else {
                            phi_457_ = select(_e274, 127i, (_e274 > 127i));
                        }
                        let _e279 = phi_457_;
                        let _e284 = bitcast<f32>((bitcast<u32>((_e279 + 127i)) << bitcast<u32>(23i)));
                        let _e290 = bitcast<f32>((bitcast<u32>(((_e274 - _e279) + 127i)) << bitcast<u32>(23i)));
                        let _e295 = global_4.member[_e134].member.member;
                        let _e296 = (_e272 == 0u);
                        if _e296 {
                            phi_475_ = _e295[0];
                        } else {
                            phi_475_ = _e295[1];
                        }
                        let _e300 = phi_475_;
                        let _e301 = (_e272 == 2u);
                        if _e301 {
                            phi_481_ = _e295[2];
                        } else {
                            phi_481_ = _e300;
                        }
                        let _e304 = phi_481_;
                        let _e305 = global_4.member[_e134].member.member_2;
                        if _e296 {
                            phi_492_ = _e305[0];
                        } else {
                            phi_492_ = _e305[1];
                        }
                        let _e309 = phi_492_;
                        if _e301 {
                            phi_498_ = _e305[2];
                        } else {
                            phi_498_ = _e309;
                        }
                        let _e312 = phi_498_;
                        let _e314 = ((_e312 * _e284) * _e290);
                        let _e318 = (bitcast<f32>((bitcast<u32>(_e314) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e318 {
                            let _e322 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) * 0.00000011920929f);
                            phi_521_ = select(0.00000000000011368684f, _e322, (_e322 > 0.00000000000011368684f));
                        } else {
                            phi_521_ = 0f;
                        }
                        let _e326 = phi_521_;
                        let _e327 = (_e304 + _e326);
                        let _e328 = (_e304 - _e326);
                        let _e329 = select(_e314, 0f, _e318);
                        if _e318 {
                            phi_532_ = 38685626000000000000000000f;
                        } else {
                            phi_532_ = (1f / _e314);
                        }
                        let _e332 = phi_532_;
                        let _e333 = (_e271 == 0u);
                        if _e333 {
                            phi_541_ = _e295[0];
                        } else {
                            phi_541_ = _e295[1];
                        }
                        let _e337 = phi_541_;
                        let _e338 = (_e271 == 2u);
                        if _e338 {
                            phi_547_ = _e295[2];
                        } else {
                            phi_547_ = _e337;
                        }
                        let _e341 = phi_547_;
                        if _e333 {
                            phi_558_ = _e305[0];
                        } else {
                            phi_558_ = _e305[1];
                        }
                        let _e345 = phi_558_;
                        if _e338 {
                            phi_564_ = _e305[2];
                        } else {
                            phi_564_ = _e345;
                        }
                        let _e348 = phi_564_;
                        let _e350 = ((_e348 * _e284) * _e290);
                        let _e354 = (bitcast<f32>((bitcast<u32>(_e350) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e354 {
                            let _e358 = (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) * 0.00000011920929f);
                            phi_587_ = select(0.00000000000011368684f, _e358, (_e358 > 0.00000000000011368684f));
                        } else {
                            phi_587_ = 0f;
                        }
                        let _e362 = phi_587_;
                        let _e363 = (_e341 + _e362);
                        let _e364 = (_e341 - _e362);
                        let _e365 = select(_e350, 0f, _e354);
                        if _e354 {
                            phi_598_ = 38685626000000000000000000f;
                        } else {
                            phi_598_ = (1f / _e350);
                        }
                        let _e368 = phi_598_;
                        let _e369 = (_e273 == 0u);
                        if _e369 {
                            phi_607_ = _e295[0];
                        } else {
                            phi_607_ = _e295[1];
                        }
                        let _e373 = phi_607_;
                        let _e374 = (_e273 == 2u);
                        if _e374 {
                            phi_613_ = _e295[2];
                        } else {
                            phi_613_ = _e373;
                        }
                        let _e377 = phi_613_;
                        if _e369 {
                            phi_624_ = _e305[0];
                        } else {
                            phi_624_ = _e305[1];
                        }
                        let _e381 = phi_624_;
                        if _e374 {
                            phi_630_ = _e305[2];
                        } else {
                            phi_630_ = _e381;
                        }
                        let _e384 = phi_630_;
                        let _e386 = ((_e384 * _e284) * _e290);
                        let _e390 = (bitcast<f32>((bitcast<u32>(_e386) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e390 {
                            let _e394 = (bitcast<f32>((bitcast<u32>(_e377) & 2147483647u)) * 0.00000011920929f);
                            phi_653_ = select(0.00000000000011368684f, _e394, (_e394 > 0.00000000000011368684f));
                        } else {
                            phi_653_ = 0f;
                        }
                        let _e398 = phi_653_;
                        let _e399 = (_e377 + _e398);
                        let _e400 = (_e377 - _e398);
                        let _e401 = select(_e386, 0f, _e390);
                        if _e390 {
                            phi_664_ = 38685626000000000000000000f;
                        } else {
                            phi_664_ = (1f / _e386);
                        }
                        let _e404 = phi_664_;
                        let _e407 = bitcast<f32>((bitcast<u32>(_e304) & 2147483647u));
                        let _e410 = bitcast<f32>((bitcast<u32>(_e341) & 2147483647u));
                        let _e412 = select(_e410, _e407, (_e407 > _e410));
                        let _e415 = bitcast<f32>((bitcast<u32>(_e377) & 2147483647u));
                        if (_e234 && (select(_e415, _e412, (_e412 > _e415)) <= 1099511600000f)) {
                            let _e420 = (_e253 / 3i);
                            let _e427 = bitcast<f32>((bitcast<u32>((_e420 + 127i)) << bitcast<u32>(23i)));
                            let _e434 = bitcast<f32>((bitcast<u32>(((_e253 - (2i * _e420)) + 127i)) << bitcast<u32>(23i)));
                            let _e435 = (((_e218 * _e427) * _e427) * _e434);
                            let _e437 = select(340282350000000000000000000000000000000f, _e435, (_e435 < 340282350000000000000000000000000000000f));
                            let _e442 = (((_e228 * _e427) * _e427) * _e434);
                            let _e444 = select(340282350000000000000000000000000000000f, _e442, (_e442 < 340282350000000000000000000000000000000f));
                            phi_764_ = select(-340282350000000000000000000000000000000f, _e444, (_e444 > -340282350000000000000000000000000000000f));
                            phi_765_ = select(-340282350000000000000000000000000000000f, _e437, (_e437 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_764_ = 0f;
                            phi_765_ = 1f;
                        }
                        let _e448 = phi_764_;
                        let _e450 = phi_765_;
                        if _e149 {
                        } else {
                            break;
                        }
                        let _e456 = global_4.member[_e134].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e459 = (_e272 % 3u);
                        let _e460 = (_e459 < 3u);
                        if _e460 {
                        } else {
                            break;
                        }
                        let _e462 = local_1[_e459];
                        let _e465 = (_e271 % 3u);
                        let _e466 = (_e465 < 3u);
                        if _e466 {
                        } else {
                            break;
                        }
                        let _e468 = local_1[_e465];
                        let _e471 = (_e273 % 3u);
                        let _e472 = (_e471 < 3u);
                        if _e472 {
                        } else {
                            break;
                        }
                        let _e474 = local_1[_e471];
                        if _e460 {
                        } else {
                            break;
                        }
                        let _e479 = local[_e459];
                        if _e466 {
                        } else {
                            break;
                        }
                        let _e483 = local[_e465];
                        if _e472 {
                        } else {
                            break;
                        }
                        let _e487 = local[_e471];
                        phi_3949_ = false;
                        phi_863_ = type_42(type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e448), 0u, 0u);
                        phi_866_ = type_49(type_34(vec4<f32>((f32(_e462) * _e146), (f32(_e468) * _e146), (f32(_e474) * _e146), 0f), vec4<f32>((f32(_e479) * _e146), (f32(_e483) * _e146), (f32(_e487) * _e146), 0f)), select(0u, 2147483648u, (_e91 == 0u)));
                        phi_868_ = ((3u * _e91) + 1u);
                        phi_870_ = (_e450 <= _e448);
                        phi_872_ = 0u;
                        loop {
                            let _e497 = phi_3949_;
                            let _e499 = phi_863_;
                            let _e501 = phi_866_;
                            let _e503 = phi_868_;
                            let _e505 = phi_870_;
                            let _e507 = phi_872_;
                            local_10 = _e499;
                            local_11 = _e499;
                            if _e505 {
                                phi_883_ = true;
                            } else {
                                phi_883_ = (_e507 > 0u);
                            }
                            let _e510 = phi_883_;
                            if _e510 {
                                let _e511 = (_e503 > 0u);
                                if _e511 {
                                    if _e505 {
                                        phi_969_ = _e501;
                                        phi_970_ = _e505;
                                        phi_971_ = _e507;
                                    } else {
                                        let _e512 = (_e507 - 1u);
                                        let _e513 = (_e512 % 128u);
                                        let _e514 = (_e513 < 128u);
                                        if _e514 {
                                        } else {
                                            phi_4104_ = true;
                                            break;
                                        }
                                        let _e516 = local_7[_e513];
                                        if _e514 {
                                        } else {
                                            phi_4104_ = true;
                                            break;
                                        }
                                        let _e518 = local_6[_e513];
                                        if _e514 {
                                        } else {
                                            phi_4104_ = true;
                                            break;
                                        }
                                        let _e520 = local_5[_e513];
                                        if _e514 {
                                        } else {
                                            phi_4104_ = true;
                                            break;
                                        }
                                        let _e522 = local_4[_e513];
                                        if _e514 {
                                        } else {
                                            phi_4104_ = true;
                                            break;
                                        }
                                        let _e524 = local_3[_e513];
                                        if _e514 {
                                        } else {
                                            phi_4104_ = true;
                                            break;
                                        }
                                        let _e526 = local_2[_e513];
                                        if _e514 {
                                        } else {
                                            phi_4104_ = true;
                                            break;
                                        }
                                        let _e531 = local_8[_e513];
                                        if _e514 {
                                        } else {
                                            phi_4104_ = true;
                                            break;
                                        }
                                        let _e534 = local_9[_e513];
                                        phi_969_ = type_49(type_34(vec4<f32>(_e516, _e518, _e520, 0f), vec4<f32>(_e522, _e524, _e526, 0f)), _e531);
                                        phi_970_ = (_e534 <= _e499.member.member_1);
                                        phi_971_ = _e512;
                                    }
                                    let _e539 = phi_969_;
                                    let _e541 = phi_970_;
                                    let _e543 = phi_971_;
                                    if _e541 {
                                        let _e548 = (_e539.member_1 & 268435455u);
                                        if ((_e539.member_1 & 2147483648u) != 0u) {
                                            phi_990_ = _e499;
                                            phi_993_ = type_8(0u, ((_e539.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1015 = phi_990_;
                                                let _e1017 = phi_993_;
                                                local_12 = _e1015;
                                                if (_e1017.member < _e1017.member_1) {
                                                    phi_994_ = type_8((_e1017.member + 1u), _e1017.member_1);
                                                    phi_1016_ = type_8(1u, _e1017.member);
                                                } else {
                                                    phi_994_ = _e1017;
                                                    phi_1016_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1030 = phi_994_;
                                                let _e1032 = phi_1016_;
                                                let _e1036 = (bitcast<i32>(_e1032.member) != 0i);
                                                if _e1036 {
                                                    let _e1042 = type_42(_e1015.member, _e1015.member_1, (_e1015.member_2 + 1u));
                                                    let _e1047 = (_e539.member.member_1.x - _e539.member.member.x);
                                                    let _e1050 = (_e539.member.member_1.y - _e539.member.member.y);
                                                    let _e1053 = (_e539.member.member_1.z - _e539.member.member.z);
                                                    let _e1055 = select(_e1050, _e1047, (_e1047 > _e1050));
                                                    let _e1057 = select(_e1053, _e1055, (_e1055 > _e1053));
                                                    let _e1059 = (_e1057 < (1024f * _e146));
                                                    if _e1059 {
                                                        phi_1060_ = 0u;
                                                    } else {
                                                        phi_1060_ = select(2u, 1u, (_e1057 < (2097152f * _e146)));
                                                    }
                                                    let _e1064 = phi_1060_;
                                                    switch bitcast<i32>(_e1064) {
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
                                                    let _e1067 = phi_1066_;
                                                    switch bitcast<i32>(_e1064) {
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
                                                    let _e1074 = phi_1076_;
                                                    let _e1076 = ((_e548 + (_e1032.member_1 * ((3u * _e1067) + 1u))) + (3u * _e1074));
                                                    let _e1077 = (_e1076 < _e94);
                                                    if _e1077 {
                                                        if _e1077 {
                                                        } else {
                                                            phi_3943_ = true;
                                                            break;
                                                        }
                                                        let _e1079 = global_7.member[_e1076];
                                                        phi_1092_ = _e1079;
                                                    } else {
                                                        phi_1092_ = 4294967295u;
                                                    }
                                                    let _e1081 = phi_1092_;
                                                    if _e1059 {
                                                        phi_1125_ = 0u;
                                                    } else {
                                                        phi_1125_ = select(2u, 1u, (_e1057 < (2097152f * _e146)));
                                                    }
                                                    let _e1086 = phi_1125_;
                                                    switch bitcast<i32>(_e1086) {
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
                                                    let _e1089 = phi_1131_;
                                                    let _e1093 = (_e548 + (_e1032.member_1 * ((3u * _e1089) + 1u)));
                                                    switch bitcast<i32>(_e1086) {
                                                        case 0: {
                                                            let _e1359 = (_e1093 < _e94);
                                                            if _e1359 {
                                                                if _e1359 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1361 = global_7.member[_e1093];
                                                                phi_1155_ = _e1361;
                                                            } else {
                                                                phi_1155_ = 0u;
                                                            }
                                                            let _e1363 = phi_1155_;
                                                            let _e1365 = ((10u * _e272) & 31u);
                                                            let _e1374 = ((10u * _e271) & 31u);
                                                            let _e1383 = ((10u * _e273) & 31u);
                                                            let _e1392 = (_e1093 + 1u);
                                                            let _e1393 = (_e1392 < _e94);
                                                            if _e1393 {
                                                                if _e1393 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1395 = global_7.member[_e1392];
                                                                phi_1198_ = _e1395;
                                                            } else {
                                                                phi_1198_ = 0u;
                                                            }
                                                            let _e1397 = phi_1198_;
                                                            let _e1420 = (_e1093 + 2u);
                                                            let _e1421 = (_e1420 < _e94);
                                                            if _e1421 {
                                                                if _e1421 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1423 = global_7.member[_e1420];
                                                                phi_1241_ = _e1423;
                                                            } else {
                                                                phi_1241_ = 0u;
                                                            }
                                                            let _e1425 = phi_1241_;
                                                            phi_1712_ = array<array<f32, 3>, 3>(array<f32, 3>((_e539.member.member.x + (f32(bitcast<i32>(((_e1363 >> bitcast<u32>(_e1365)) & 1023u))) * _e146)), (_e539.member.member.y + (f32(bitcast<i32>(((_e1363 >> bitcast<u32>(_e1374)) & 1023u))) * _e146)), (_e539.member.member.z + (f32(bitcast<i32>(((_e1363 >> bitcast<u32>(_e1383)) & 1023u))) * _e146))), array<f32, 3>((_e539.member.member.x + (f32(bitcast<i32>(((_e1397 >> bitcast<u32>(_e1365)) & 1023u))) * _e146)), (_e539.member.member.y + (f32(bitcast<i32>(((_e1397 >> bitcast<u32>(_e1374)) & 1023u))) * _e146)), (_e539.member.member.z + (f32(bitcast<i32>(((_e1397 >> bitcast<u32>(_e1383)) & 1023u))) * _e146))), array<f32, 3>((_e539.member.member.x + (f32(bitcast<i32>(((_e1425 >> bitcast<u32>(_e1365)) & 1023u))) * _e146)), (_e539.member.member.y + (f32(bitcast<i32>(((_e1425 >> bitcast<u32>(_e1374)) & 1023u))) * _e146)), (_e539.member.member.z + (f32(bitcast<i32>(((_e1425 >> bitcast<u32>(_e1383)) & 1023u))) * _e146))));
                                                            break;
                                                        }
                                                        case 1: {
                                                            let _e1182 = (_e1093 < _e94);
                                                            if _e1182 {
                                                                if _e1182 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1184 = global_7.member[_e1093];
                                                                phi_1284_ = _e1184;
                                                            } else {
                                                                phi_1284_ = 0u;
                                                            }
                                                            let _e1186 = phi_1284_;
                                                            let _e1187 = (_e1093 + 1u);
                                                            let _e1188 = (_e1187 < _e94);
                                                            if _e1188 {
                                                                if _e1188 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1190 = global_7.member[_e1187];
                                                                phi_1299_ = _e1190;
                                                            } else {
                                                                phi_1299_ = 0u;
                                                            }
                                                            let _e1192 = phi_1299_;
                                                            let _e1193 = (_e272 == 1u);
                                                            if _e1193 {
                                                                phi_1309_ = ((_e1186 >> bitcast<u32>(21i)) | (_e1192 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1309_ = (_e1192 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1202 = phi_1309_;
                                                            let _e1209 = (_e271 == 1u);
                                                            if _e1209 {
                                                                phi_1329_ = ((_e1186 >> bitcast<u32>(21i)) | (_e1192 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1329_ = (_e1192 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1218 = phi_1329_;
                                                            let _e1225 = (_e273 == 1u);
                                                            if _e1225 {
                                                                phi_1349_ = ((_e1186 >> bitcast<u32>(21i)) | (_e1192 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1349_ = (_e1192 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1234 = phi_1349_;
                                                            let _e1242 = (_e1093 + 2u);
                                                            let _e1243 = (_e1242 < _e94);
                                                            if _e1243 {
                                                                if _e1243 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1245 = global_7.member[_e1242];
                                                                phi_1375_ = _e1245;
                                                            } else {
                                                                phi_1375_ = 0u;
                                                            }
                                                            let _e1247 = phi_1375_;
                                                            let _e1248 = (_e1093 + 3u);
                                                            let _e1249 = (_e1248 < _e94);
                                                            if _e1249 {
                                                                if _e1249 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1251 = global_7.member[_e1248];
                                                                phi_1390_ = _e1251;
                                                            } else {
                                                                phi_1390_ = 0u;
                                                            }
                                                            let _e1253 = phi_1390_;
                                                            if _e1193 {
                                                                phi_1400_ = ((_e1247 >> bitcast<u32>(21i)) | (_e1253 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1400_ = (_e1253 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1262 = phi_1400_;
                                                            if _e1209 {
                                                                phi_1420_ = ((_e1247 >> bitcast<u32>(21i)) | (_e1253 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1420_ = (_e1253 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1277 = phi_1420_;
                                                            if _e1225 {
                                                                phi_1440_ = ((_e1247 >> bitcast<u32>(21i)) | (_e1253 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1440_ = (_e1253 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1292 = phi_1440_;
                                                            let _e1300 = (_e1093 + 4u);
                                                            let _e1301 = (_e1300 < _e94);
                                                            if _e1301 {
                                                                if _e1301 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1303 = global_7.member[_e1300];
                                                                phi_1466_ = _e1303;
                                                            } else {
                                                                phi_1466_ = 0u;
                                                            }
                                                            let _e1305 = phi_1466_;
                                                            let _e1306 = (_e1093 + 5u);
                                                            let _e1307 = (_e1306 < _e94);
                                                            if _e1307 {
                                                                if _e1307 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1309 = global_7.member[_e1306];
                                                                phi_1481_ = _e1309;
                                                            } else {
                                                                phi_1481_ = 0u;
                                                            }
                                                            let _e1311 = phi_1481_;
                                                            if _e1193 {
                                                                phi_1491_ = ((_e1305 >> bitcast<u32>(21i)) | (_e1311 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1491_ = (_e1311 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1320 = phi_1491_;
                                                            if _e1209 {
                                                                phi_1511_ = ((_e1305 >> bitcast<u32>(21i)) | (_e1311 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1511_ = (_e1311 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1335 = phi_1511_;
                                                            if _e1225 {
                                                                phi_1531_ = ((_e1305 >> bitcast<u32>(21i)) | (_e1311 << bitcast<u32>(11i)));
                                                            } else {
                                                                phi_1531_ = (_e1311 >> bitcast<u32>(10i));
                                                            }
                                                            let _e1350 = phi_1531_;
                                                            phi_1712_ = array<array<f32, 3>, 3>(array<f32, 3>((_e539.member.member.x + (f32(bitcast<i32>((select(_e1202, _e1186, _e296) & 2097151u))) * _e146)), (_e539.member.member.y + (f32(bitcast<i32>((select(_e1218, _e1186, _e333) & 2097151u))) * _e146)), (_e539.member.member.z + (f32(bitcast<i32>((select(_e1234, _e1186, _e369) & 2097151u))) * _e146))), array<f32, 3>((_e539.member.member.x + (f32(bitcast<i32>((select(_e1262, _e1247, _e296) & 2097151u))) * _e146)), (_e539.member.member.y + (f32(bitcast<i32>((select(_e1277, _e1247, _e333) & 2097151u))) * _e146)), (_e539.member.member.z + (f32(bitcast<i32>((select(_e1292, _e1247, _e369) & 2097151u))) * _e146))), array<f32, 3>((_e539.member.member.x + (f32(bitcast<i32>((select(_e1320, _e1305, _e296) & 2097151u))) * _e146)), (_e539.member.member.y + (f32(bitcast<i32>((select(_e1335, _e1305, _e333) & 2097151u))) * _e146)), (_e539.member.member.z + (f32(bitcast<i32>((select(_e1350, _e1305, _e369) & 2097151u))) * _e146))));
                                                            break;
                                                        }
                                                        case 2: {
                                                            let _e1095 = (_e1093 + _e272);
                                                            let _e1096 = (_e1095 < _e94);
                                                            if _e1096 {
                                                                if _e1096 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1098 = global_7.member[_e1095];
                                                                phi_1558_ = _e1098;
                                                            } else {
                                                                phi_1558_ = 0u;
                                                            }
                                                            let _e1100 = phi_1558_;
                                                            let _e1104 = (_e1093 + _e271);
                                                            let _e1105 = (_e1104 < _e94);
                                                            if _e1105 {
                                                                if _e1105 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1107 = global_7.member[_e1104];
                                                                phi_1576_ = _e1107;
                                                            } else {
                                                                phi_1576_ = 0u;
                                                            }
                                                            let _e1109 = phi_1576_;
                                                            let _e1113 = (_e1093 + _e273);
                                                            let _e1114 = (_e1113 < _e94);
                                                            if _e1114 {
                                                                if _e1114 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1116 = global_7.member[_e1113];
                                                                phi_1594_ = _e1116;
                                                            } else {
                                                                phi_1594_ = 0u;
                                                            }
                                                            let _e1118 = phi_1594_;
                                                            let _e1123 = (_e1093 + 3u);
                                                            let _e1124 = (_e1123 + _e272);
                                                            let _e1125 = (_e1124 < _e94);
                                                            if _e1125 {
                                                                if _e1125 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1127 = global_7.member[_e1124];
                                                                phi_1614_ = _e1127;
                                                            } else {
                                                                phi_1614_ = 0u;
                                                            }
                                                            let _e1129 = phi_1614_;
                                                            let _e1133 = (_e1123 + _e271);
                                                            let _e1134 = (_e1133 < _e94);
                                                            if _e1134 {
                                                                if _e1134 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1136 = global_7.member[_e1133];
                                                                phi_1632_ = _e1136;
                                                            } else {
                                                                phi_1632_ = 0u;
                                                            }
                                                            let _e1138 = phi_1632_;
                                                            let _e1142 = (_e1123 + _e273);
                                                            let _e1143 = (_e1142 < _e94);
                                                            if _e1143 {
                                                                if _e1143 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1145 = global_7.member[_e1142];
                                                                phi_1650_ = _e1145;
                                                            } else {
                                                                phi_1650_ = 0u;
                                                            }
                                                            let _e1147 = phi_1650_;
                                                            let _e1152 = (_e1093 + 6u);
                                                            let _e1153 = (_e1152 + _e272);
                                                            let _e1154 = (_e1153 < _e94);
                                                            if _e1154 {
                                                                if _e1154 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1156 = global_7.member[_e1153];
                                                                phi_1670_ = _e1156;
                                                            } else {
                                                                phi_1670_ = 0u;
                                                            }
                                                            let _e1158 = phi_1670_;
                                                            let _e1162 = (_e1152 + _e271);
                                                            let _e1163 = (_e1162 < _e94);
                                                            if _e1163 {
                                                                if _e1163 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1165 = global_7.member[_e1162];
                                                                phi_1688_ = _e1165;
                                                            } else {
                                                                phi_1688_ = 0u;
                                                            }
                                                            let _e1167 = phi_1688_;
                                                            let _e1171 = (_e1152 + _e273);
                                                            let _e1172 = (_e1171 < _e94);
                                                            if _e1172 {
                                                                if _e1172 {
                                                                } else {
                                                                    phi_3943_ = true;
                                                                    break;
                                                                }
                                                                let _e1174 = global_7.member[_e1171];
                                                                phi_1706_ = _e1174;
                                                            } else {
                                                                phi_1706_ = 0u;
                                                            }
                                                            let _e1176 = phi_1706_;
                                                            phi_1712_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1100)) * _e146), (f32(bitcast<i32>(_e1109)) * _e146), (f32(bitcast<i32>(_e1118)) * _e146)), array<f32, 3>((f32(bitcast<i32>(_e1129)) * _e146), (f32(bitcast<i32>(_e1138)) * _e146), (f32(bitcast<i32>(_e1147)) * _e146)), array<f32, 3>((f32(bitcast<i32>(_e1158)) * _e146), (f32(bitcast<i32>(_e1167)) * _e146), (f32(bitcast<i32>(_e1176)) * _e146)));
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1712_ = array<array<f32, 3>, 3>();
                                                            break;
                                                        }
                                                    }
                                                    let _e1450 = phi_1712_;
                                                    let _e1459 = (_e1450[0][2] - _e377);
                                                    let _e1462 = (((_e1450[0][0] - _e304) * _e401) - (_e1459 * _e329));
                                                    let _e1465 = (((_e1450[0][1] - _e341) * _e401) - (_e1459 * _e365));
                                                    let _e1472 = (_e1450[1][2] - _e377);
                                                    let _e1475 = (((_e1450[1][0] - _e304) * _e401) - (_e1472 * _e329));
                                                    let _e1478 = (((_e1450[1][1] - _e341) * _e401) - (_e1472 * _e365));
                                                    let _e1485 = (_e1450[2][2] - _e377);
                                                    let _e1488 = (((_e1450[2][0] - _e304) * _e401) - (_e1485 * _e329));
                                                    let _e1491 = (((_e1450[2][1] - _e341) * _e401) - (_e1485 * _e365));
                                                    let _e1492 = (_e1488 * _e1478);
                                                    let _e1493 = (_e1491 * _e1475);
                                                    let _e1494 = (_e1462 * _e1491);
                                                    let _e1495 = (_e1465 * _e1488);
                                                    let _e1496 = (_e1475 * _e1465);
                                                    let _e1497 = (_e1478 * _e1462);
                                                    let _e1502 = (((_e1492 >= _e1493) && (_e1494 >= _e1495)) && (_e1496 >= _e1497));
                                                    if (_e1502 || (((_e1492 <= _e1493) && (_e1494 <= _e1495)) && (_e1496 <= _e1497))) {
                                                        let _e1509 = select(-1f, 1f, _e1502);
                                                        let _e1511 = ((_e1492 - _e1493) * _e1509);
                                                        let _e1513 = select(0f, _e1511, (_e1511 > 0f));
                                                        let _e1515 = ((_e1494 - _e1495) * _e1509);
                                                        let _e1517 = select(0f, _e1515, (_e1515 > 0f));
                                                        let _e1519 = ((_e1496 - _e1497) * _e1509);
                                                        let _e1521 = select(0f, _e1519, (_e1519 > 0f));
                                                        let _e1523 = ((_e1513 + _e1517) + _e1521);
                                                        if (_e1523 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2278_ = type_22();
                                                            phi_2279_ = true;
                                                        } else {
                                                            let _e1526 = select(_e1450[1][0], _e1450[0][0], (_e1450[0][0] < _e1450[1][0]));
                                                            let _e1530 = select(_e1450[1][0], _e1450[0][0], (_e1450[0][0] > _e1450[1][0]));
                                                            let _e1534 = select(_e1450[1][1], _e1450[0][1], (_e1450[0][1] < _e1450[1][1]));
                                                            let _e1538 = select(_e1450[1][1], _e1450[0][1], (_e1450[0][1] > _e1450[1][1]));
                                                            let _e1542 = select(_e1450[1][2], _e1450[0][2], (_e1450[0][2] < _e1450[1][2]));
                                                            let _e1546 = select(_e1450[1][2], _e1450[0][2], (_e1450[0][2] > _e1450[1][2]));
                                                            let _e1551 = ((select(_e1450[2][0], _e1526, (_e1526 < _e1450[2][0])) - _e327) * _e332);
                                                            let _e1552 = ((select(_e1450[2][0], _e1530, (_e1530 > _e1450[2][0])) - _e328) * _e332);
                                                            let _e1555 = ((select(_e1450[2][1], _e1534, (_e1534 < _e1450[2][1])) - _e363) * _e368);
                                                            let _e1556 = ((select(_e1450[2][1], _e1538, (_e1538 > _e1450[2][1])) - _e364) * _e368);
                                                            let _e1559 = ((select(_e1450[2][2], _e1542, (_e1542 < _e1450[2][2])) - _e399) * _e404);
                                                            let _e1560 = ((select(_e1450[2][2], _e1546, (_e1546 > _e1450[2][2])) - _e400) * _e404);
                                                            let _e1562 = select(_e1560, _e1559, (_e1559 < _e1560));
                                                            let _e1564 = select(_e1560, _e1559, (_e1559 > _e1560));
                                                            let _e1566 = select(_e1552, _e1551, (_e1551 < _e1552));
                                                            let _e1568 = select(_e1556, _e1555, (_e1555 < _e1556));
                                                            let _e1570 = select(_e1568, _e1566, (_e1566 > _e1568));
                                                            let _e1572 = select(_e1562, _e1570, (_e1570 > _e1562));
                                                            let _e1574 = select(_e1552, _e1551, (_e1551 > _e1552));
                                                            let _e1576 = select(_e1556, _e1555, (_e1555 > _e1556));
                                                            let _e1578 = select(_e1576, _e1574, (_e1574 < _e1576));
                                                            let _e1580 = select(_e1564, _e1578, (_e1578 < _e1564));
                                                            let _e1581 = -(_e1562);
                                                            let _e1587 = select(_e450, _e1572, (_e1572 > _e450));
                                                            if (_e1587 > (_e1580 + (select(_e1581, _e1564, (_e1564 > _e1581)) * 0.0000019073523f))) {
                                                                phi_2273_ = type_22();
                                                                phi_2274_ = true;
                                                            } else {
                                                                let _e1589 = (_e1587 > _e1015.member.member_1);
                                                                if _e1589 {
                                                                    phi_2272_ = type_22();
                                                                } else {
                                                                    let _e1593 = (_e1450[1][0] - _e1450[0][0]);
                                                                    let _e1594 = (_e1450[1][1] - _e1450[0][1]);
                                                                    let _e1595 = (_e1450[1][2] - _e1450[0][2]);
                                                                    let _e1596 = vec3<f32>(_e1593, _e1594, _e1595);
                                                                    let _e1597 = (_e1450[2][0] - _e1450[1][0]);
                                                                    let _e1598 = (_e1450[2][1] - _e1450[1][1]);
                                                                    let _e1599 = (_e1450[2][2] - _e1450[1][2]);
                                                                    let _e1600 = vec3<f32>(_e1597, _e1598, _e1599);
                                                                    let _e1601 = (_e1450[0][0] - _e1450[2][0]);
                                                                    let _e1602 = (_e1450[0][1] - _e1450[2][1]);
                                                                    let _e1603 = (_e1450[0][2] - _e1450[2][2]);
                                                                    let _e1604 = vec3<f32>(_e1601, _e1602, _e1603);
                                                                    let _e1607 = bitcast<f32>((bitcast<u32>(_e1593) & 2147483647u));
                                                                    let _e1610 = bitcast<f32>((bitcast<u32>(_e1594) & 2147483647u));
                                                                    let _e1612 = select(_e1610, _e1607, (_e1607 > _e1610));
                                                                    let _e1615 = bitcast<f32>((bitcast<u32>(_e1595) & 2147483647u));
                                                                    let _e1617 = select(_e1615, _e1612, (_e1612 > _e1615));
                                                                    let _e1620 = bitcast<f32>((bitcast<u32>(_e1597) & 2147483647u));
                                                                    let _e1623 = bitcast<f32>((bitcast<u32>(_e1598) & 2147483647u));
                                                                    let _e1625 = select(_e1623, _e1620, (_e1620 > _e1623));
                                                                    let _e1628 = bitcast<f32>((bitcast<u32>(_e1599) & 2147483647u));
                                                                    let _e1630 = select(_e1628, _e1625, (_e1625 > _e1628));
                                                                    let _e1633 = bitcast<f32>((bitcast<u32>(_e1601) & 2147483647u));
                                                                    let _e1636 = bitcast<f32>((bitcast<u32>(_e1602) & 2147483647u));
                                                                    let _e1638 = select(_e1636, _e1633, (_e1633 > _e1636));
                                                                    let _e1641 = bitcast<f32>((bitcast<u32>(_e1603) & 2147483647u));
                                                                    let _e1643 = select(_e1641, _e1638, (_e1638 > _e1641));
                                                                    let _e1645 = select(_e1630, _e1617, (_e1617 > _e1630));
                                                                    let _e1647 = select(_e1643, _e1645, (_e1645 > _e1643));
                                                                    if (_e1617 == _e1647) {
                                                                        phi_2183_ = _e1600;
                                                                        phi_2184_ = _e1604;
                                                                    } else {
                                                                        let _e1650 = vec3((_e1630 == _e1647));
                                                                        phi_2183_ = select(_e1596, _e1604, _e1650);
                                                                        phi_2184_ = select(_e1600, _e1596, _e1650);
                                                                    }
                                                                    let _e1654 = phi_2183_;
                                                                    let _e1656 = phi_2184_;
                                                                    let _e1663 = ((_e1654.y * _e1656.z) - (_e1656.y * _e1654.z));
                                                                    let _e1668 = ((_e1654.z * _e1656.x) - (_e1656.z * _e1654.x));
                                                                    let _e1671 = ((_e1654.x * _e1656.y) - (_e1656.x * _e1654.y));
                                                                    if (_e1513 >= _e1517) {
                                                                        phi_2215_ = select(true, false, (_e1513 >= _e1521));
                                                                    } else {
                                                                        phi_2215_ = true;
                                                                    }
                                                                    let _e1676 = phi_2215_;
                                                                    if _e1676 {
                                                                        phi_2224_ = select(vec3<f32>(_e1450[2][0], _e1450[2][1], _e1450[2][2]), vec3<f32>(_e1450[1][0], _e1450[1][1], _e1450[1][2]), vec3((_e1517 >= _e1521)));
                                                                    } else {
                                                                        phi_2224_ = vec3<f32>(_e1450[0][0], _e1450[0][1], _e1450[0][2]);
                                                                    }
                                                                    let _e1681 = phi_2224_;
                                                                    let _e1698 = ((((_e1663 * (_e1681.x - _e304)) + (_e1668 * (_e1681.y - _e341))) + (_e1671 * (_e1681.z - _e377))) / (((_e1663 * _e329) + (_e1668 * _e365)) + (_e1671 * _e401)));
                                                                    let _e1700 = select(_e1580, _e1698, (_e1698 < _e1580));
                                                                    let _e1702 = select(_e1572, _e1700, (_e1700 > _e1572));
                                                                    if (_e1702 >= _e450) {
                                                                        let _e1704 = (_e1702 <= _e1015.member.member_1);
                                                                        if _e1704 {
                                                                            let _e1705 = (1f / _e1523);
                                                                            phi_2264_ = type_22(_e1702, (_e1517 * _e1705), (_e1521 * _e1705), _e1081);
                                                                        } else {
                                                                            phi_2264_ = type_22();
                                                                        }
                                                                        let _e1710 = phi_2264_;
                                                                        phi_2266_ = _e1710;
                                                                        phi_2267_ = select(true, false, _e1704);
                                                                    } else {
                                                                        phi_2266_ = type_22();
                                                                        phi_2267_ = true;
                                                                    }
                                                                    let _e1713 = phi_2266_;
                                                                    let _e1715 = phi_2267_;
                                                                    if _e1715 {
                                                                        phi_2271_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2271_ = _e1713;
                                                                    }
                                                                    let _e1717 = phi_2271_;
                                                                    phi_2272_ = _e1717;
                                                                }
                                                                let _e1719 = phi_2272_;
                                                                phi_2273_ = _e1719;
                                                                phi_2274_ = _e1589;
                                                            }
                                                            let _e1721 = phi_2273_;
                                                            let _e1723 = phi_2274_;
                                                            phi_2278_ = _e1721;
                                                            phi_2279_ = _e1723;
                                                        }
                                                        let _e1725 = phi_2278_;
                                                        let _e1727 = phi_2279_;
                                                        phi_2283_ = _e1725;
                                                        phi_2284_ = _e1727;
                                                    } else {
                                                        phi_2283_ = type_22();
                                                        phi_2284_ = true;
                                                    }
                                                    let _e1729 = phi_2283_;
                                                    let _e1731 = phi_2284_;
                                                    if _e1731 {
                                                        phi_2288_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2288_ = _e1729;
                                                    }
                                                    let _e1733 = phi_2288_;
                                                    if (_e1733.member_3 != 4294967295u) {
                                                        if (_e1081 != _e456) {
                                                            if (_e1733.member < _e1015.member.member.member) {
                                                                phi_2314_ = true;
                                                            } else {
                                                                if (_e1733.member == _e1015.member.member.member) {
                                                                    phi_2313_ = (_e1733.member_3 < _e1015.member.member.member_3);
                                                                } else {
                                                                    phi_2313_ = false;
                                                                }
                                                                let _e1748 = phi_2313_;
                                                                phi_2314_ = _e1748;
                                                            }
                                                            let _e1750 = phi_2314_;
                                                            if _e1750 {
                                                                phi_2321_ = type_42(type_38(_e1733, _e1733.member), _e1042.member_1, _e1042.member_2);
                                                            } else {
                                                                phi_2321_ = _e1042;
                                                            }
                                                            let _e1757 = phi_2321_;
                                                            phi_2322_ = _e1757;
                                                        } else {
                                                            phi_2322_ = _e1042;
                                                        }
                                                        let _e1759 = phi_2322_;
                                                        phi_2323_ = _e1759;
                                                    } else {
                                                        phi_2323_ = _e1042;
                                                    }
                                                    let _e1761 = phi_2323_;
                                                    phi_991_ = _e1761;
                                                } else {
                                                    phi_991_ = type_42();
                                                }
                                                let _e1763 = phi_991_;
                                                continue;
                                                continuing {
                                                    phi_990_ = _e1763;
                                                    phi_993_ = _e1030;
                                                    phi_3943_ = _e497;
                                                    break if !(_e1036);
                                                }
                                            }
                                            let _e1766 = phi_3943_;
                                            phi_4104_ = _e1766;
                                            if _e1766 {
                                                break;
                                            }
                                            phi_4108_ = _e1766;
                                            let _e2017 = local_12;
                                            phi_3566_ = _e2017;
                                            phi_3567_ = _e539;
                                            phi_3568_ = false;
                                            phi_3569_ = _e543;
                                        } else {
                                            if (_e539.member_1 >= _e91) {
                                                phi_3122_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e539.member_1 < _e91) {
                                                } else {
                                                    phi_4104_ = true;
                                                    break;
                                                }
                                                let _e562 = ((1u + _e272) % 4u);
                                                if (_e562 < 4u) {
                                                } else {
                                                    phi_4104_ = true;
                                                    break;
                                                }
                                                let _e567 = global_3.member[_e539.member_1][_e562];
                                                let _e569 = (_e567 >> bitcast<u32>(11u));
                                                let _e571 = ((1u + _e271) % 4u);
                                                if (_e571 < 4u) {
                                                } else {
                                                    phi_4104_ = true;
                                                    break;
                                                }
                                                let _e576 = global_3.member[_e539.member_1][_e571];
                                                let _e578 = (_e576 >> bitcast<u32>(11u));
                                                let _e580 = ((1u + _e273) % 4u);
                                                if (_e580 < 4u) {
                                                } else {
                                                    phi_4104_ = true;
                                                    break;
                                                }
                                                let _e585 = global_3.member[_e539.member_1][_e580];
                                                let _e587 = (_e585 >> bitcast<u32>(11u));
                                                let _e610 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.x - _e539.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e611 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.y - _e539.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e612 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.z - _e539.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e614 = select(_e146, _e610, (_e610 > _e146));
                                                let _e616 = select(_e146, _e611, (_e611 > _e146));
                                                let _e618 = select(_e146, _e612, (_e612 > _e146));
                                                let _e643 = bitcast<u32>((f32(bitcast<i32>((_e567 & 1023u))) * _e614));
                                                let _e648 = (bitcast<i32>((_e567 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e651 = bitcast<f32>((_e643 & bitcast<u32>(_e648)));
                                                let _e652 = bitcast<u32>((f32(bitcast<i32>((_e576 & 1023u))) * _e616));
                                                let _e657 = (bitcast<i32>((_e576 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e660 = bitcast<f32>((_e652 & bitcast<u32>(_e657)));
                                                let _e661 = bitcast<u32>((f32(bitcast<i32>((_e585 & 1023u))) * _e618));
                                                let _e666 = (bitcast<i32>((_e585 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e669 = bitcast<f32>((_e661 & bitcast<u32>(_e666)));
                                                let _e673 = bitcast<f32>((_e643 & bitcast<u32>(~(_e648))));
                                                let _e677 = bitcast<f32>((_e652 & bitcast<u32>(~(_e657))));
                                                let _e681 = bitcast<f32>((_e661 & bitcast<u32>(~(_e666))));
                                                let _e682 = bitcast<u32>((f32(bitcast<i32>((_e569 & 1023u))) * _e614));
                                                let _e687 = (bitcast<i32>((_e569 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e690 = bitcast<f32>((_e682 & bitcast<u32>(_e687)));
                                                let _e691 = bitcast<u32>((f32(bitcast<i32>((_e578 & 1023u))) * _e616));
                                                let _e696 = (bitcast<i32>((_e578 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e699 = bitcast<f32>((_e691 & bitcast<u32>(_e696)));
                                                let _e700 = bitcast<u32>((f32(bitcast<i32>((_e587 & 1023u))) * _e618));
                                                let _e705 = (bitcast<i32>((_e587 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e708 = bitcast<f32>((_e700 & bitcast<u32>(_e705)));
                                                let _e712 = bitcast<f32>((_e682 & bitcast<u32>(~(_e687))));
                                                let _e716 = bitcast<f32>((_e691 & bitcast<u32>(~(_e696))));
                                                let _e720 = bitcast<f32>((_e700 & bitcast<u32>(~(_e705))));
                                                let _e721 = (_e539.member.member.x + _e651);
                                                let _e722 = (_e539.member.member.y + _e660);
                                                let _e723 = (_e539.member.member.z + _e669);
                                                let _e726 = (_e539.member.member_1.x - _e690);
                                                let _e727 = (_e539.member.member_1.y - _e699);
                                                let _e728 = (_e539.member.member_1.z - _e708);
                                                let _e747 = (_e726 - _e721);
                                                let _e748 = (_e727 - _e722);
                                                let _e749 = (_e728 - _e723);
                                                let _e751 = select(_e748, _e747, (_e747 > _e748));
                                                let _e753 = select(_e749, _e751, (_e751 > _e749));
                                                if (_e753 < (1024f * _e146)) {
                                                    phi_2823_ = 0u;
                                                } else {
                                                    phi_2823_ = select(2u, 1u, (_e753 < (2097152f * _e146)));
                                                }
                                                let _e760 = phi_2823_;
                                                switch bitcast<i32>(_e760) {
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
                                                let _e763 = phi_2829_;
                                                let _e769 = global_3.member[_e539.member_1][0u];
                                                let _e773 = global_3.member[_e539.member_1][1u];
                                                let _e777 = global_3.member[_e539.member_1][2u];
                                                let _e781 = global_3.member[_e539.member_1][3u];
                                                let _e793 = (((_e773 >> bitcast<u32>(22i)) | ((_e777 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e781 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e794 = (_e769 & 268435455u);
                                                let _e795 = (_e793 & 268435455u);
                                                let _e798 = ((_e769 >> bitcast<u32>(28u)) & 7u);
                                                let _e806 = ((_e769 >> bitcast<u32>(31i)) | (((_e793 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e807 = (_e798 != 0u);
                                                if (_e798 == 0u) {
                                                    phi_3084_ = _e794;
                                                } else {
                                                    if (_e798 == 7u) {
                                                        phi_3083_ = 2147483648u;
                                                    } else {
                                                        phi_3083_ = ((2147483648u | (_e798 << bitcast<u32>(28u))) | (_e795 & 268435455u));
                                                    }
                                                    let _e816 = phi_3083_;
                                                    phi_3084_ = _e816;
                                                }
                                                let _e818 = phi_3084_;
                                                if _e807 {
                                                    let _e819 = (_e798 != 7u);
                                                    if _e819 {
                                                        phi_3094_ = (_e795 + (_e798 * ((3u * _e763) + 1u)));
                                                    } else {
                                                        phi_3094_ = u32();
                                                    }
                                                    let _e823 = phi_3094_;
                                                    phi_3096_ = _e823;
                                                    phi_3097_ = select(true, false, _e819);
                                                } else {
                                                    phi_3096_ = u32();
                                                    phi_3097_ = true;
                                                }
                                                let _e826 = phi_3096_;
                                                let _e828 = phi_3097_;
                                                if (_e806 == 0u) {
                                                    phi_3118_ = (_e794 + select(0u, 1u, !(_e807)));
                                                } else {
                                                    if (_e806 == 7u) {
                                                        phi_3117_ = 2147483648u;
                                                    } else {
                                                        phi_3117_ = ((2147483648u | (_e806 << bitcast<u32>(28u))) | (select(_e826, _e795, _e828) & 268435455u));
                                                    }
                                                    let _e841 = phi_3117_;
                                                    phi_3118_ = _e841;
                                                }
                                                let _e843 = phi_3118_;
                                                phi_3122_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e721, (_e539.member.member.x + _e673), _e726, (_e539.member.member_1.x - _e712)), vec4<f32>(_e722, (_e539.member.member.y + _e677), _e727, (_e539.member.member_1.y - _e716)), vec4<f32>(_e723, (_e539.member.member.z + _e681), _e728, (_e539.member.member_1.z - _e720))), type_49(type_34((_e539.member.member + vec4<f32>(_e651, _e660, _e669, 0f)), (_e539.member.member_1 - vec4<f32>(_e690, _e699, _e708, 0f))), _e818), type_49(type_34((_e539.member.member + vec4<f32>(_e673, _e677, _e681, 0f)), (_e539.member.member_1 - vec4<f32>(_e712, _e716, _e720, 0f))), _e843));
                                            }
                                            let _e848 = phi_3122_;
                                            let _e861 = ((_e848.member[0].x - _e327) * _e332);
                                            let _e862 = ((_e848.member[0].y - _e327) * _e332);
                                            let _e863 = ((_e848.member[0].z - _e328) * _e332);
                                            let _e864 = ((_e848.member[0].w - _e328) * _e332);
                                            let _e874 = ((_e848.member[1].x - _e363) * _e368);
                                            let _e875 = ((_e848.member[1].y - _e363) * _e368);
                                            let _e876 = ((_e848.member[1].z - _e364) * _e368);
                                            let _e877 = ((_e848.member[1].w - _e364) * _e368);
                                            let _e887 = ((_e848.member[2].x - _e399) * _e404);
                                            let _e888 = ((_e848.member[2].y - _e399) * _e404);
                                            let _e889 = ((_e848.member[2].z - _e400) * _e404);
                                            let _e890 = ((_e848.member[2].w - _e400) * _e404);
                                            let _e892 = select(_e889, _e887, (_e887 < _e889));
                                            let _e894 = select(_e890, _e888, (_e888 < _e890));
                                            let _e896 = select(_e889, _e887, (_e887 > _e889));
                                            let _e898 = select(_e890, _e888, (_e888 > _e890));
                                            let _e900 = select(_e863, _e861, (_e861 < _e863));
                                            let _e902 = select(_e864, _e862, (_e862 < _e864));
                                            let _e904 = select(_e876, _e874, (_e874 < _e876));
                                            let _e906 = select(_e877, _e875, (_e875 < _e877));
                                            let _e908 = select(_e904, _e900, (_e900 > _e904));
                                            let _e910 = select(_e906, _e902, (_e902 > _e906));
                                            let _e912 = select(_e892, _e908, (_e908 > _e892));
                                            let _e914 = select(_e894, _e910, (_e910 > _e894));
                                            let _e916 = select(_e863, _e861, (_e861 > _e863));
                                            let _e918 = select(_e864, _e862, (_e862 > _e864));
                                            let _e920 = select(_e876, _e874, (_e874 > _e876));
                                            let _e922 = select(_e877, _e875, (_e875 > _e877));
                                            let _e924 = select(_e920, _e916, (_e916 < _e920));
                                            let _e926 = select(_e922, _e918, (_e918 < _e922));
                                            let _e931 = -(_e892);
                                            let _e932 = -(_e894);
                                            let _e939 = (select(_e896, _e924, (_e924 < _e896)) + (select(_e931, _e896, (_e896 > _e931)) * 0.0000019073523f));
                                            let _e940 = (select(_e898, _e926, (_e926 < _e898)) + (select(_e932, _e898, (_e898 > _e932)) * 0.0000019073523f));
                                            let _e942 = select(_e450, _e912, (_e912 > _e450));
                                            let _e944 = select(_e450, _e914, (_e914 > _e450));
                                            let _e949 = (_e942 <= select(_e499.member.member_1, _e939, (_e939 < _e499.member.member_1)));
                                            let _e950 = (_e944 <= select(_e499.member.member_1, _e940, (_e940 < _e499.member.member_1)));
                                            let _e951 = (_e942 <= _e944);
                                            if _e949 {
                                                if _e950 {
                                                    if _e951 {
                                                        phi_3466_ = _e848.member_2;
                                                    } else {
                                                        phi_3466_ = _e848.member_1;
                                                    }
                                                    let _e955 = phi_3466_;
                                                    let _e977 = (_e543 % 128u);
                                                    let _e978 = (_e977 < 128u);
                                                    if _e978 {
                                                    } else {
                                                        phi_4104_ = true;
                                                        break;
                                                    }
                                                    local_8[_e977] = _e955.member_1;
                                                    if _e978 {
                                                    } else {
                                                        phi_4104_ = true;
                                                        break;
                                                    }
                                                    local_7[_e977] = _e955.member.member.x;
                                                    if _e978 {
                                                    } else {
                                                        phi_4104_ = true;
                                                        break;
                                                    }
                                                    local_6[_e977] = _e955.member.member.y;
                                                    if _e978 {
                                                    } else {
                                                        phi_4104_ = true;
                                                        break;
                                                    }
                                                    local_5[_e977] = _e955.member.member.z;
                                                    if _e978 {
                                                    } else {
                                                        phi_4104_ = true;
                                                        break;
                                                    }
                                                    local_4[_e977] = _e955.member.member_1.x;
                                                    if _e978 {
                                                    } else {
                                                        phi_4104_ = true;
                                                        break;
                                                    }
                                                    local_3[_e977] = _e955.member.member_1.y;
                                                    if _e978 {
                                                    } else {
                                                        phi_4104_ = true;
                                                        break;
                                                    }
                                                    local_2[_e977] = _e955.member.member_1.z;
                                                    if _e978 {
                                                    } else {
                                                        phi_4104_ = true;
                                                        break;
                                                    }
                                                    local_9[_e977] = select(_e944, _e942, (_e942 > _e944));
                                                    if _e951 {
                                                        phi_3543_ = _e848.member_1;
                                                    } else {
                                                        phi_3543_ = _e848.member_2;
                                                    }
                                                    let _e991 = phi_3543_;
                                                    phi_3544_ = _e991;
                                                    phi_3545_ = (_e543 + 1u);
                                                } else {
                                                    phi_3544_ = type_49();
                                                    phi_3545_ = u32();
                                                }
                                                let _e993 = phi_3544_;
                                                let _e995 = phi_3545_;
                                                phi_3547_ = _e993;
                                                phi_3548_ = _e995;
                                                phi_3549_ = select(true, false, _e950);
                                            } else {
                                                phi_3547_ = type_49();
                                                phi_3548_ = u32();
                                                phi_3549_ = true;
                                            }
                                            let _e998 = phi_3547_;
                                            let _e1000 = phi_3548_;
                                            let _e1002 = phi_3549_;
                                            if _e1002 {
                                                if _e949 {
                                                    phi_3558_ = _e848.member_1;
                                                } else {
                                                    phi_3558_ = _e848.member_2;
                                                }
                                                let _e1006 = phi_3558_;
                                                phi_3563_ = _e1006;
                                                phi_3564_ = select(_e950, true, _e949);
                                            } else {
                                                phi_3563_ = _e998;
                                                phi_3564_ = _e541;
                                            }
                                            let _e1009 = phi_3563_;
                                            let _e1011 = phi_3564_;
                                            phi_4108_ = _e497;
                                            phi_3566_ = type_42(_e499.member, (_e499.member_1 + 1u), _e499.member_2);
                                            phi_3567_ = _e1009;
                                            phi_3568_ = _e1011;
                                            phi_3569_ = select(_e1000, _e543, _e1002);
                                        }
                                        let _e1768 = phi_4108_;
                                        let _e1770 = phi_3566_;
                                        let _e1772 = phi_3567_;
                                        let _e1774 = phi_3568_;
                                        let _e1776 = phi_3569_;
                                        phi_4107_ = _e1768;
                                        phi_3570_ = _e1770;
                                        phi_3571_ = _e1772;
                                        phi_3572_ = (_e503 - 1u);
                                        phi_3573_ = _e1774;
                                        phi_3574_ = _e1776;
                                    } else {
                                        phi_4107_ = _e497;
                                        phi_3570_ = _e499;
                                        phi_3571_ = _e539;
                                        phi_3572_ = _e503;
                                        phi_3573_ = _e541;
                                        phi_3574_ = _e543;
                                    }
                                    let _e1778 = phi_4107_;
                                    let _e1780 = phi_3570_;
                                    let _e1782 = phi_3571_;
                                    let _e1784 = phi_3572_;
                                    let _e1786 = phi_3573_;
                                    let _e1788 = phi_3574_;
                                    phi_4106_ = _e1778;
                                    phi_3575_ = _e1780;
                                    phi_3576_ = _e1782;
                                    phi_3577_ = _e1784;
                                    phi_3578_ = _e1786;
                                    phi_3579_ = _e1788;
                                } else {
                                    phi_4106_ = _e497;
                                    phi_3575_ = type_42();
                                    phi_3576_ = type_49();
                                    phi_3577_ = u32();
                                    phi_3578_ = bool();
                                    phi_3579_ = u32();
                                }
                                let _e1790 = phi_4106_;
                                let _e1792 = phi_3575_;
                                let _e1794 = phi_3576_;
                                let _e1796 = phi_3577_;
                                let _e1798 = phi_3578_;
                                let _e1800 = phi_3579_;
                                phi_4105_ = _e1790;
                                phi_864_ = _e1792;
                                phi_867_ = _e1794;
                                phi_869_ = _e1796;
                                phi_871_ = _e1798;
                                phi_873_ = _e1800;
                                phi_3580_ = _e511;
                            } else {
                                phi_4105_ = _e497;
                                phi_864_ = type_42();
                                phi_867_ = type_49();
                                phi_869_ = u32();
                                phi_871_ = bool();
                                phi_873_ = u32();
                                phi_3580_ = false;
                            }
                            let _e1802 = phi_4105_;
                            let _e1804 = phi_864_;
                            let _e1806 = phi_867_;
                            let _e1808 = phi_869_;
                            let _e1810 = phi_871_;
                            let _e1812 = phi_873_;
                            let _e1814 = phi_3580_;
                            continue;
                            continuing {
                                phi_3949_ = _e1802;
                                phi_863_ = _e1804;
                                phi_866_ = _e1806;
                                phi_868_ = _e1808;
                                phi_870_ = _e1810;
                                phi_872_ = _e1812;
                                phi_4104_ = _e1802;
                                break if !(_e1814);
                            }
                        }
                        let _e1817 = phi_4104_;
                        if _e1817 {
                            break;
                        }
                        let _e1819 = local_10;
                        if (_e1819.member.member.member_3 != 4294967295u) {
                            let _e1825 = (_e274 / 3i);
                            let _e1832 = bitcast<f32>((bitcast<u32>((_e1825 + 127i)) << bitcast<u32>(23i)));
                            let _e1840 = (((_e1819.member.member.member * _e1832) * _e1832) * bitcast<f32>((bitcast<u32>(((_e274 - (2i * _e1825)) + 127i)) << bitcast<u32>(23i))));
                            let _e1842 = select(340282350000000000000000000000000000000f, _e1840, (_e1840 < 340282350000000000000000000000000000000f));
                            phi_3632_ = type_22(select(-340282350000000000000000000000000000000f, _e1842, (_e1842 > -340282350000000000000000000000000000000f)), _e1819.member.member.member_1, _e1819.member.member.member_2, _e1819.member.member.member_3);
                        } else {
                            phi_3632_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1849 = phi_3632_;
                        if _e150 {
                        } else {
                            break;
                        }
                        global_1.member[_e134] = _e1849;
                        let _e1853 = local_11;
                        if _e151 {
                        } else {
                            break;
                        }
                        global_5.member[_e134] = _e1853.member_1;
                        if _e149 {
                        } else {
                            break;
                        }
                        let _e1858 = select(0u, 1u, (_e218 <= _e228));
                        if (_e1858 > 0u) {
                            let _e1860 = (1u < _e102);
                            if _e1860 {
                                if (0u < _e102) {
                                } else {
                                    break;
                                }
                                let _e1864 = atomicAdd((&global_6.member[0u]), _e1858);
                                if ((_e1864 + _e1858) < _e1864) {
                                    if _e1860 {
                                    } else {
                                        break;
                                    }
                                    let _e1869 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1872 = select(0u, 1u, (_e1849.member_3 != 4294967295u));
                        if (_e1872 > 0u) {
                            let _e1874 = (3u < _e102);
                            if _e1874 {
                                if (2u < _e102) {
                                } else {
                                    break;
                                }
                                let _e1878 = atomicAdd((&global_6.member[2u]), _e1872);
                                if ((_e1878 + _e1872) < _e1878) {
                                    if _e1874 {
                                    } else {
                                        break;
                                    }
                                    let _e1883 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1853.member_1 > 0u) {
                            let _e1885 = (5u < _e102);
                            if _e1885 {
                                if (4u < _e102) {
                                } else {
                                    break;
                                }
                                let _e1889 = atomicAdd((&global_6.member[4u]), _e1853.member_1);
                                if ((_e1889 + _e1853.member_1) < _e1889) {
                                    if _e1885 {
                                    } else {
                                        break;
                                    }
                                    let _e1894 = atomicAdd((&global_6.member[5u]), 1u);
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
fn trace_paths_counted_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
