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

struct type_24 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: array<type_25>,
}

struct type_40 {
    member: array<array<type_24, 8>>,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: type_28,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_46;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_40;

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
    var local_9: array<type_24, 8>;
    var local_10: array<f32, 128>;
    var phi_396_: i32;
    var phi_397_: i32;
    var phi_407_: bool;
    var phi_417_: u32;
    var phi_418_: u32;
    var phi_420_: bool;
    var phi_425_: u32;
    var phi_437_: i32;
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
    var phi_4198_: bool;
    var phi_4054_: f32;
    var phi_907_: type_51;
    var phi_910_: u32;
    var phi_912_: bool;
    var phi_914_: u32;
    var phi_925_: bool;
    var phi_1012_: type_51;
    var phi_1013_: bool;
    var phi_1014_: u32;
    var phi_2927_: u32;
    var phi_2933_: u32;
    var phi_3187_: u32;
    var phi_3188_: u32;
    var phi_3198_: u32;
    var phi_3200_: u32;
    var phi_3201_: bool;
    var phi_3221_: u32;
    var phi_3222_: u32;
    var phi_3226_: type_52;
    var phi_3571_: type_51;
    var phi_3648_: type_51;
    var phi_3649_: type_51;
    var phi_3650_: u32;
    var phi_3652_: type_51;
    var phi_3653_: u32;
    var phi_3654_: bool;
    var phi_3663_: type_51;
    var phi_3668_: type_51;
    var phi_3669_: bool;
    var phi_4195_: bool;
    var phi_4138_: f32;
    var phi_1033_: type_8;
    var phi_1034_: type_8;
    var phi_1057_: type_8;
    var phi_1098_: u32;
    var phi_1104_: u32;
    var phi_1114_: u32;
    var phi_1130_: u32;
    var phi_1163_: u32;
    var phi_1169_: u32;
    var phi_1596_: u32;
    var phi_1614_: u32;
    var phi_1632_: u32;
    var phi_1652_: u32;
    var phi_1670_: u32;
    var phi_1688_: u32;
    var phi_1708_: u32;
    var phi_1726_: u32;
    var phi_1744_: u32;
    var phi_1322_: u32;
    var phi_1337_: u32;
    var phi_1347_: u32;
    var phi_1367_: u32;
    var phi_1387_: u32;
    var phi_1413_: u32;
    var phi_1428_: u32;
    var phi_1438_: u32;
    var phi_1458_: u32;
    var phi_1478_: u32;
    var phi_1504_: u32;
    var phi_1519_: u32;
    var phi_1529_: u32;
    var phi_1549_: u32;
    var phi_1569_: u32;
    var phi_1193_: u32;
    var phi_1236_: u32;
    var phi_1279_: u32;
    var phi_1750_: array<array<f32, 3>, 3>;
    var phi_2222_: vec3<f32>;
    var phi_2223_: vec3<f32>;
    var phi_2254_: bool;
    var phi_2263_: vec3<f32>;
    var phi_2303_: type_24;
    var phi_2305_: type_24;
    var phi_2306_: bool;
    var phi_2310_: type_24;
    var phi_2311_: type_24;
    var phi_2312_: type_24;
    var phi_2313_: bool;
    var phi_2317_: type_24;
    var phi_2318_: bool;
    var phi_2322_: type_24;
    var phi_2323_: bool;
    var phi_2327_: type_24;
    var phi_2339_: type_8;
    var phi_2342_: type_24;
    var phi_2340_: type_8;
    var phi_2365_: type_8;
    var phi_2397_: bool;
    var phi_2398_: bool;
    var phi_2419_: type_24;
    var phi_2343_: type_24;
    var phi_4166_: bool;
    var phi_4537_: f32;
    var phi_4536_: f32;
    var phi_4330_: bool;
    var phi_4535_: f32;
    var phi_4329_: bool;
    var phi_4534_: f32;
    var phi_4328_: bool;
    var phi_4474_: f32;
    var phi_4327_: bool;
    var phi_4439_: f32;
    var phi_4336_: bool;
    var phi_3671_: type_51;
    var phi_3672_: bool;
    var phi_3673_: u32;
    var phi_4438_: f32;
    var phi_4335_: bool;
    var phi_3674_: type_51;
    var phi_3675_: u32;
    var phi_3676_: bool;
    var phi_3677_: u32;
    var phi_4437_: f32;
    var phi_4334_: bool;
    var phi_3678_: type_51;
    var phi_3679_: u32;
    var phi_3680_: bool;
    var phi_3681_: u32;
    var phi_4436_: f32;
    var phi_4333_: bool;
    var phi_908_: type_51;
    var phi_911_: u32;
    var phi_913_: bool;
    var phi_915_: u32;
    var phi_3682_: bool;
    var phi_4332_: bool;
    var phi_3689_: type_8;
    var phi_3690_: type_8;
    var phi_3713_: type_8;
    var phi_3779_: type_24;
    var phi_4429_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e92 = global;
            let _e94 = arrayLength((&global_3.member));
            let _e97 = arrayLength((&global_5.member));
            let _e105 = global_2.member[0u][0u];
            let _e109 = global_2.member[0u][1u];
            let _e113 = global_2.member[0u][2u];
            let _e117 = global_2.member[0u][3u];
            let _e121 = global_2.member[1u][0u];
            let _e125 = global_2.member[1u][1u];
            let _e129 = global_2.member[1u][2u];
            let _e132 = global_1.member[0u];
            let _e133 = bitcast<i32>(_e132);
            let _e145 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e117) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e105), bitcast<i32>(_e109), bitcast<i32>(_e113));
            local = array<i32, 3>(bitcast<i32>(_e121), bitcast<i32>(_e125), bitcast<i32>(_e129));
            let _e151 = (_e92.x + (_e92.y * 2097152u));
            let _e152 = (_e151 < arrayLength((&global_4.member)));
            if _e152 {
                let _e153 = (_e151 < arrayLength((&global_6.member)));
                if _e153 {
                    if _e152 {
                    } else {
                        break;
                    }
                    let _e161 = global_4.member[_e151].member_2[0u];
                    let _e163 = (bitcast<u32>(_e161) & 2147483647u);
                    let _e168 = global_4.member[_e151].member_2[1u];
                    let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                    let _e175 = global_4.member[_e151].member_2[2u];
                    let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                    let _e182 = global_4.member[_e151].member[0u];
                    let _e184 = (bitcast<u32>(_e182) & 2147483647u);
                    let _e189 = global_4.member[_e151].member[1u];
                    let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                    let _e196 = global_4.member[_e151].member[2u];
                    let _e198 = (bitcast<u32>(_e196) & 2147483647u);
                    let _e200 = select(_e170, _e163, (_e170 < _e163));
                    let _e202 = select(_e177, _e200, (_e177 < _e200));
                    let _e204 = select(_e184, _e202, (_e184 < _e202));
                    let _e206 = select(_e191, _e204, (_e191 < _e204));
                    let _e208 = select(_e198, _e206, (_e198 < _e206));
                    let _e212 = global_4.member[_e151].member_1;
                    let _e214 = (bitcast<u32>(_e212) & 2147483647u);
                    let _e221 = global_4.member[_e151].member_3;
                    let _e227 = (((select(_e214, _e208, (_e214 < _e208)) < 2139095040u) && ((bitcast<u32>(_e221) & 2147483647u) <= 2139095040u)) && (_e202 > 0u));
                    if _e227 {
                        let _e230 = (bitcast<u32>(bitcast<f32>(_e202)) & 2147483647u);
                        if (_e230 >= 8388608u) {
                            phi_396_ = (bitcast<i32>((_e230 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_396_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e230)), 32u, (_e230 == 0u))));
                        }
                        let _e244 = phi_396_;
                        phi_397_ = _e244;
                    } else {
                        phi_397_ = 0i;
                    }
                    let _e246 = phi_397_;
                    let _e247 = (_e163 == _e202);
                    if _e247 {
                        phi_407_ = true;
                    } else {
                        phi_407_ = (_e170 == _e202);
                    }
                    let _e250 = phi_407_;
                    let _e251 = select(1u, 0u, _e247);
                    if _e250 {
                        let _e252 = (_e251 + 1u);
                        phi_417_ = _e252;
                        phi_418_ = _e252;
                        phi_420_ = select(true, false, (_e252 == 2u));
                    } else {
                        phi_417_ = u32();
                        phi_418_ = 0u;
                        phi_420_ = true;
                    }
                    let _e256 = phi_417_;
                    let _e258 = phi_418_;
                    let _e260 = phi_420_;
                    if _e260 {
                        phi_425_ = (_e258 + 1u);
                    } else {
                        phi_425_ = 0u;
                    }
                    let _e264 = phi_425_;
                    let _e265 = select(_e256, _e258, _e260);
                    let _e266 = select(_e251, select(2u, _e251, _e250), _e260);
                    if (_e133 < -126i) {
                        phi_437_ = -126i;
                    } else {
                        phi_437_ = select(_e133, 127i, (_e133 > 127i));
                    }
                    let _e271 = phi_437_;
                    let _e276 = bitcast<f32>((bitcast<u32>((_e271 + 127i)) << bitcast<u32>(23i)));
                    let _e282 = bitcast<f32>((bitcast<u32>(((_e133 - _e271) + 127i)) << bitcast<u32>(23i)));
                    let _e283 = -(_e246);
                    if (_e283 < -126i) {
                        phi_457_ = -126i;
                    } else {
                        phi_457_ = select(_e283, 127i, (_e283 > 127i));
                    }
                    let _e288 = phi_457_;
                    let _e293 = bitcast<f32>((bitcast<u32>((_e288 + 127i)) << bitcast<u32>(23i)));
                    let _e299 = bitcast<f32>((bitcast<u32>(((_e283 - _e288) + 127i)) << bitcast<u32>(23i)));
                    let _e303 = global_4.member[_e151].member;
                    let _e304 = (_e265 == 0u);
                    if _e304 {
                        phi_475_ = _e303[0];
                    } else {
                        phi_475_ = _e303[1];
                    }
                    let _e308 = phi_475_;
                    let _e309 = (_e265 == 2u);
                    if _e309 {
                        phi_481_ = _e303[2];
                    } else {
                        phi_481_ = _e308;
                    }
                    let _e312 = phi_481_;
                    let _e314 = ((_e312 * _e276) * _e282);
                    let _e315 = global_4.member[_e151].member_2;
                    if _e304 {
                        phi_492_ = _e315[0];
                    } else {
                        phi_492_ = _e315[1];
                    }
                    let _e319 = phi_492_;
                    if _e309 {
                        phi_498_ = _e315[2];
                    } else {
                        phi_498_ = _e319;
                    }
                    let _e322 = phi_498_;
                    let _e324 = ((_e322 * _e293) * _e299);
                    let _e328 = (bitcast<f32>((bitcast<u32>(_e324) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e328 {
                        let _e332 = (bitcast<f32>((bitcast<u32>(_e314) & 2147483647u)) * 0.00000011920929f);
                        phi_521_ = select(0.00000000000011368684f, _e332, (_e332 > 0.00000000000011368684f));
                    } else {
                        phi_521_ = 0f;
                    }
                    let _e336 = phi_521_;
                    let _e337 = (_e314 + _e336);
                    let _e338 = (_e314 - _e336);
                    let _e339 = select(_e324, 0f, _e328);
                    if _e328 {
                        phi_532_ = 38685626000000000000000000f;
                    } else {
                        phi_532_ = (1f / _e324);
                    }
                    let _e342 = phi_532_;
                    let _e343 = (_e264 == 0u);
                    if _e343 {
                        phi_541_ = _e303[0];
                    } else {
                        phi_541_ = _e303[1];
                    }
                    let _e347 = phi_541_;
                    let _e348 = (_e264 == 2u);
                    if _e348 {
                        phi_547_ = _e303[2];
                    } else {
                        phi_547_ = _e347;
                    }
                    let _e351 = phi_547_;
                    let _e353 = ((_e351 * _e276) * _e282);
                    if _e343 {
                        phi_558_ = _e315[0];
                    } else {
                        phi_558_ = _e315[1];
                    }
                    let _e357 = phi_558_;
                    if _e348 {
                        phi_564_ = _e315[2];
                    } else {
                        phi_564_ = _e357;
                    }
                    let _e360 = phi_564_;
                    let _e362 = ((_e360 * _e293) * _e299);
                    let _e366 = (bitcast<f32>((bitcast<u32>(_e362) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e366 {
                        let _e370 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) * 0.00000011920929f);
                        phi_587_ = select(0.00000000000011368684f, _e370, (_e370 > 0.00000000000011368684f));
                    } else {
                        phi_587_ = 0f;
                    }
                    let _e374 = phi_587_;
                    let _e375 = (_e353 + _e374);
                    let _e376 = (_e353 - _e374);
                    let _e377 = select(_e362, 0f, _e366);
                    if _e366 {
                        phi_598_ = 38685626000000000000000000f;
                    } else {
                        phi_598_ = (1f / _e362);
                    }
                    let _e380 = phi_598_;
                    let _e381 = (_e266 == 0u);
                    if _e381 {
                        phi_607_ = _e303[0];
                    } else {
                        phi_607_ = _e303[1];
                    }
                    let _e385 = phi_607_;
                    let _e386 = (_e266 == 2u);
                    if _e386 {
                        phi_613_ = _e303[2];
                    } else {
                        phi_613_ = _e385;
                    }
                    let _e389 = phi_613_;
                    let _e391 = ((_e389 * _e276) * _e282);
                    if _e381 {
                        phi_624_ = _e315[0];
                    } else {
                        phi_624_ = _e315[1];
                    }
                    let _e395 = phi_624_;
                    if _e386 {
                        phi_630_ = _e315[2];
                    } else {
                        phi_630_ = _e395;
                    }
                    let _e398 = phi_630_;
                    let _e400 = ((_e398 * _e293) * _e299);
                    let _e404 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e404 {
                        let _e408 = (bitcast<f32>((bitcast<u32>(_e391) & 2147483647u)) * 0.00000011920929f);
                        phi_653_ = select(0.00000000000011368684f, _e408, (_e408 > 0.00000000000011368684f));
                    } else {
                        phi_653_ = 0f;
                    }
                    let _e412 = phi_653_;
                    let _e413 = (_e391 + _e412);
                    let _e414 = (_e391 - _e412);
                    let _e415 = select(_e400, 0f, _e404);
                    if _e404 {
                        phi_664_ = 38685626000000000000000000f;
                    } else {
                        phi_664_ = (1f / _e400);
                    }
                    let _e418 = phi_664_;
                    let _e421 = bitcast<f32>((bitcast<u32>(_e314) & 2147483647u));
                    let _e424 = bitcast<f32>((bitcast<u32>(_e353) & 2147483647u));
                    let _e426 = select(_e424, _e421, (_e421 > _e424));
                    let _e429 = bitcast<f32>((bitcast<u32>(_e391) & 2147483647u));
                    let _e432 = (_e133 + _e246);
                    if (_e227 && (select(_e429, _e426, (_e426 > _e429)) <= 1099511600000f)) {
                        let _e435 = (_e432 / 3i);
                        let _e442 = bitcast<f32>((bitcast<u32>((_e435 + 127i)) << bitcast<u32>(23i)));
                        let _e449 = bitcast<f32>((bitcast<u32>(((_e432 - (2i * _e435)) + 127i)) << bitcast<u32>(23i)));
                        let _e450 = (((_e212 * _e442) * _e442) * _e449);
                        let _e452 = select(340282350000000000000000000000000000000f, _e450, (_e450 < 340282350000000000000000000000000000000f));
                        let _e457 = (((_e221 * _e442) * _e442) * _e449);
                        let _e459 = select(340282350000000000000000000000000000000f, _e457, (_e457 < 340282350000000000000000000000000000000f));
                        phi_764_ = select(-340282350000000000000000000000000000000f, _e459, (_e459 > -340282350000000000000000000000000000000f));
                        phi_765_ = select(-340282350000000000000000000000000000000f, _e452, (_e452 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_764_ = 0f;
                        phi_765_ = 1f;
                    }
                    let _e463 = phi_764_;
                    let _e465 = phi_765_;
                    local_9 = array<type_24, 8>(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e468 = (_e265 % 3u);
                    let _e469 = (_e468 < 3u);
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e471 = local_1[_e468];
                    let _e474 = (_e264 % 3u);
                    let _e475 = (_e474 < 3u);
                    if _e475 {
                    } else {
                        break;
                    }
                    let _e477 = local_1[_e474];
                    let _e480 = (_e266 % 3u);
                    let _e481 = (_e480 < 3u);
                    if _e481 {
                    } else {
                        break;
                    }
                    let _e483 = local_1[_e480];
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e488 = local[_e468];
                    if _e475 {
                    } else {
                        break;
                    }
                    let _e492 = local[_e474];
                    if _e481 {
                    } else {
                        break;
                    }
                    let _e496 = local[_e480];
                    phi_4198_ = false;
                    phi_4054_ = _e463;
                    phi_907_ = type_51(type_28(vec4<f32>((f32(_e471) * _e145), (f32(_e477) * _e145), (f32(_e483) * _e145), 0f), vec4<f32>((f32(_e488) * _e145), (f32(_e492) * _e145), (f32(_e496) * _e145), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                    phi_910_ = ((3u * _e94) + 1u);
                    phi_912_ = (_e465 <= _e463);
                    phi_914_ = 0u;
                    loop {
                        let _e506 = phi_4198_;
                        let _e508 = phi_4054_;
                        let _e510 = phi_907_;
                        let _e512 = phi_910_;
                        let _e514 = phi_912_;
                        let _e516 = phi_914_;
                        if _e514 {
                            phi_925_ = true;
                        } else {
                            phi_925_ = (_e516 > 0u);
                        }
                        let _e519 = phi_925_;
                        if _e519 {
                            let _e520 = (_e512 > 0u);
                            if _e520 {
                                if _e514 {
                                    phi_1012_ = _e510;
                                    phi_1013_ = _e514;
                                    phi_1014_ = _e516;
                                } else {
                                    let _e521 = (_e516 - 1u);
                                    let _e522 = (_e521 % 128u);
                                    let _e523 = (_e522 < 128u);
                                    if _e523 {
                                    } else {
                                        phi_4332_ = true;
                                        break;
                                    }
                                    let _e525 = local_7[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4332_ = true;
                                        break;
                                    }
                                    let _e527 = local_6[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4332_ = true;
                                        break;
                                    }
                                    let _e529 = local_5[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4332_ = true;
                                        break;
                                    }
                                    let _e531 = local_4[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4332_ = true;
                                        break;
                                    }
                                    let _e533 = local_3[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4332_ = true;
                                        break;
                                    }
                                    let _e535 = local_2[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4332_ = true;
                                        break;
                                    }
                                    let _e540 = local_8[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4332_ = true;
                                        break;
                                    }
                                    let _e543 = local_10[_e522];
                                    phi_1012_ = type_51(type_28(vec4<f32>(_e525, _e527, _e529, 0f), vec4<f32>(_e531, _e533, _e535, 0f)), _e540);
                                    phi_1013_ = (_e543 <= _e508);
                                    phi_1014_ = _e521;
                                }
                                let _e546 = phi_1012_;
                                let _e548 = phi_1013_;
                                let _e550 = phi_1014_;
                                if _e548 {
                                    let _e555 = (_e546.member_1 & 268435455u);
                                    if ((_e546.member_1 & 2147483648u) != 0u) {
                                        phi_4195_ = _e506;
                                        phi_4138_ = _e508;
                                        phi_1033_ = type_8(0u, ((_e546.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1014 = phi_4195_;
                                            let _e1016 = phi_4138_;
                                            let _e1018 = phi_1033_;
                                            if (_e1018.member < _e1018.member_1) {
                                                phi_1034_ = type_8((_e1018.member + 1u), _e1018.member_1);
                                                phi_1057_ = type_8(1u, _e1018.member);
                                            } else {
                                                phi_1034_ = _e1018;
                                                phi_1057_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1031 = phi_1034_;
                                            let _e1033 = phi_1057_;
                                            let _e1037 = (bitcast<i32>(_e1033.member) != 0i);
                                            if _e1037 {
                                                let _e1042 = (_e546.member.member_1.x - _e546.member.member.x);
                                                let _e1045 = (_e546.member.member_1.y - _e546.member.member.y);
                                                let _e1048 = (_e546.member.member_1.z - _e546.member.member.z);
                                                let _e1050 = select(_e1045, _e1042, (_e1042 > _e1045));
                                                let _e1052 = select(_e1048, _e1050, (_e1050 > _e1048));
                                                let _e1054 = (_e1052 < (1024f * _e145));
                                                if _e1054 {
                                                    phi_1098_ = 0u;
                                                } else {
                                                    phi_1098_ = select(2u, 1u, (_e1052 < (2097152f * _e145)));
                                                }
                                                let _e1059 = phi_1098_;
                                                switch bitcast<i32>(_e1059) {
                                                    case 0: {
                                                        phi_1104_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1104_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1104_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1104_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1062 = phi_1104_;
                                                switch bitcast<i32>(_e1059) {
                                                    case 0: {
                                                        phi_1114_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1114_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1114_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1114_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1069 = phi_1114_;
                                                let _e1071 = ((_e555 + (_e1033.member_1 * ((3u * _e1062) + 1u))) + (3u * _e1069));
                                                let _e1072 = (_e1071 < _e97);
                                                if _e1072 {
                                                    if _e1072 {
                                                    } else {
                                                        phi_4474_ = _e1016;
                                                        phi_4327_ = true;
                                                        break;
                                                    }
                                                    let _e1074 = global_5.member[_e1071];
                                                    phi_1130_ = _e1074;
                                                } else {
                                                    phi_1130_ = 4294967295u;
                                                }
                                                let _e1076 = phi_1130_;
                                                if _e1054 {
                                                    phi_1163_ = 0u;
                                                } else {
                                                    phi_1163_ = select(2u, 1u, (_e1052 < (2097152f * _e145)));
                                                }
                                                let _e1081 = phi_1163_;
                                                switch bitcast<i32>(_e1081) {
                                                    case 0: {
                                                        phi_1169_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1169_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1169_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1169_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1084 = phi_1169_;
                                                let _e1088 = (_e555 + (_e1033.member_1 * ((3u * _e1084) + 1u)));
                                                switch bitcast<i32>(_e1081) {
                                                    case 0: {
                                                        let _e1354 = (_e1088 < _e97);
                                                        if _e1354 {
                                                            if _e1354 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1356 = global_5.member[_e1088];
                                                            phi_1193_ = _e1356;
                                                        } else {
                                                            phi_1193_ = 0u;
                                                        }
                                                        let _e1358 = phi_1193_;
                                                        let _e1360 = ((10u * _e265) & 31u);
                                                        let _e1369 = ((10u * _e264) & 31u);
                                                        let _e1378 = ((10u * _e266) & 31u);
                                                        let _e1387 = (_e1088 + 1u);
                                                        let _e1388 = (_e1387 < _e97);
                                                        if _e1388 {
                                                            if _e1388 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1390 = global_5.member[_e1387];
                                                            phi_1236_ = _e1390;
                                                        } else {
                                                            phi_1236_ = 0u;
                                                        }
                                                        let _e1392 = phi_1236_;
                                                        let _e1415 = (_e1088 + 2u);
                                                        let _e1416 = (_e1415 < _e97);
                                                        if _e1416 {
                                                            if _e1416 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1418 = global_5.member[_e1415];
                                                            phi_1279_ = _e1418;
                                                        } else {
                                                            phi_1279_ = 0u;
                                                        }
                                                        let _e1420 = phi_1279_;
                                                        phi_1750_ = array<array<f32, 3>, 3>(array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>(((_e1358 >> bitcast<u32>(_e1360)) & 1023u))) * _e145)), (_e546.member.member.y + (f32(bitcast<i32>(((_e1358 >> bitcast<u32>(_e1369)) & 1023u))) * _e145)), (_e546.member.member.z + (f32(bitcast<i32>(((_e1358 >> bitcast<u32>(_e1378)) & 1023u))) * _e145))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>(((_e1392 >> bitcast<u32>(_e1360)) & 1023u))) * _e145)), (_e546.member.member.y + (f32(bitcast<i32>(((_e1392 >> bitcast<u32>(_e1369)) & 1023u))) * _e145)), (_e546.member.member.z + (f32(bitcast<i32>(((_e1392 >> bitcast<u32>(_e1378)) & 1023u))) * _e145))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>(((_e1420 >> bitcast<u32>(_e1360)) & 1023u))) * _e145)), (_e546.member.member.y + (f32(bitcast<i32>(((_e1420 >> bitcast<u32>(_e1369)) & 1023u))) * _e145)), (_e546.member.member.z + (f32(bitcast<i32>(((_e1420 >> bitcast<u32>(_e1378)) & 1023u))) * _e145))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1177 = (_e1088 < _e97);
                                                        if _e1177 {
                                                            if _e1177 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1179 = global_5.member[_e1088];
                                                            phi_1322_ = _e1179;
                                                        } else {
                                                            phi_1322_ = 0u;
                                                        }
                                                        let _e1181 = phi_1322_;
                                                        let _e1182 = (_e1088 + 1u);
                                                        let _e1183 = (_e1182 < _e97);
                                                        if _e1183 {
                                                            if _e1183 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1185 = global_5.member[_e1182];
                                                            phi_1337_ = _e1185;
                                                        } else {
                                                            phi_1337_ = 0u;
                                                        }
                                                        let _e1187 = phi_1337_;
                                                        let _e1188 = (_e265 == 1u);
                                                        if _e1188 {
                                                            phi_1347_ = ((_e1181 >> bitcast<u32>(21i)) | (_e1187 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1347_ = (_e1187 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1197 = phi_1347_;
                                                        let _e1204 = (_e264 == 1u);
                                                        if _e1204 {
                                                            phi_1367_ = ((_e1181 >> bitcast<u32>(21i)) | (_e1187 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1367_ = (_e1187 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1213 = phi_1367_;
                                                        let _e1220 = (_e266 == 1u);
                                                        if _e1220 {
                                                            phi_1387_ = ((_e1181 >> bitcast<u32>(21i)) | (_e1187 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1387_ = (_e1187 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1229 = phi_1387_;
                                                        let _e1237 = (_e1088 + 2u);
                                                        let _e1238 = (_e1237 < _e97);
                                                        if _e1238 {
                                                            if _e1238 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1240 = global_5.member[_e1237];
                                                            phi_1413_ = _e1240;
                                                        } else {
                                                            phi_1413_ = 0u;
                                                        }
                                                        let _e1242 = phi_1413_;
                                                        let _e1243 = (_e1088 + 3u);
                                                        let _e1244 = (_e1243 < _e97);
                                                        if _e1244 {
                                                            if _e1244 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1246 = global_5.member[_e1243];
                                                            phi_1428_ = _e1246;
                                                        } else {
                                                            phi_1428_ = 0u;
                                                        }
                                                        let _e1248 = phi_1428_;
                                                        if _e1188 {
                                                            phi_1438_ = ((_e1242 >> bitcast<u32>(21i)) | (_e1248 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1438_ = (_e1248 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1257 = phi_1438_;
                                                        if _e1204 {
                                                            phi_1458_ = ((_e1242 >> bitcast<u32>(21i)) | (_e1248 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1458_ = (_e1248 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1272 = phi_1458_;
                                                        if _e1220 {
                                                            phi_1478_ = ((_e1242 >> bitcast<u32>(21i)) | (_e1248 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1478_ = (_e1248 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1287 = phi_1478_;
                                                        let _e1295 = (_e1088 + 4u);
                                                        let _e1296 = (_e1295 < _e97);
                                                        if _e1296 {
                                                            if _e1296 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1298 = global_5.member[_e1295];
                                                            phi_1504_ = _e1298;
                                                        } else {
                                                            phi_1504_ = 0u;
                                                        }
                                                        let _e1300 = phi_1504_;
                                                        let _e1301 = (_e1088 + 5u);
                                                        let _e1302 = (_e1301 < _e97);
                                                        if _e1302 {
                                                            if _e1302 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1304 = global_5.member[_e1301];
                                                            phi_1519_ = _e1304;
                                                        } else {
                                                            phi_1519_ = 0u;
                                                        }
                                                        let _e1306 = phi_1519_;
                                                        if _e1188 {
                                                            phi_1529_ = ((_e1300 >> bitcast<u32>(21i)) | (_e1306 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1529_ = (_e1306 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1315 = phi_1529_;
                                                        if _e1204 {
                                                            phi_1549_ = ((_e1300 >> bitcast<u32>(21i)) | (_e1306 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1549_ = (_e1306 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1330 = phi_1549_;
                                                        if _e1220 {
                                                            phi_1569_ = ((_e1300 >> bitcast<u32>(21i)) | (_e1306 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1569_ = (_e1306 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1345 = phi_1569_;
                                                        phi_1750_ = array<array<f32, 3>, 3>(array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>((select(_e1197, _e1181, _e304) & 2097151u))) * _e145)), (_e546.member.member.y + (f32(bitcast<i32>((select(_e1213, _e1181, _e343) & 2097151u))) * _e145)), (_e546.member.member.z + (f32(bitcast<i32>((select(_e1229, _e1181, _e381) & 2097151u))) * _e145))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>((select(_e1257, _e1242, _e304) & 2097151u))) * _e145)), (_e546.member.member.y + (f32(bitcast<i32>((select(_e1272, _e1242, _e343) & 2097151u))) * _e145)), (_e546.member.member.z + (f32(bitcast<i32>((select(_e1287, _e1242, _e381) & 2097151u))) * _e145))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>((select(_e1315, _e1300, _e304) & 2097151u))) * _e145)), (_e546.member.member.y + (f32(bitcast<i32>((select(_e1330, _e1300, _e343) & 2097151u))) * _e145)), (_e546.member.member.z + (f32(bitcast<i32>((select(_e1345, _e1300, _e381) & 2097151u))) * _e145))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1090 = (_e1088 + _e265);
                                                        let _e1091 = (_e1090 < _e97);
                                                        if _e1091 {
                                                            if _e1091 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1093 = global_5.member[_e1090];
                                                            phi_1596_ = _e1093;
                                                        } else {
                                                            phi_1596_ = 0u;
                                                        }
                                                        let _e1095 = phi_1596_;
                                                        let _e1099 = (_e1088 + _e264);
                                                        let _e1100 = (_e1099 < _e97);
                                                        if _e1100 {
                                                            if _e1100 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1102 = global_5.member[_e1099];
                                                            phi_1614_ = _e1102;
                                                        } else {
                                                            phi_1614_ = 0u;
                                                        }
                                                        let _e1104 = phi_1614_;
                                                        let _e1108 = (_e1088 + _e266);
                                                        let _e1109 = (_e1108 < _e97);
                                                        if _e1109 {
                                                            if _e1109 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1111 = global_5.member[_e1108];
                                                            phi_1632_ = _e1111;
                                                        } else {
                                                            phi_1632_ = 0u;
                                                        }
                                                        let _e1113 = phi_1632_;
                                                        let _e1118 = (_e1088 + 3u);
                                                        let _e1119 = (_e1118 + _e265);
                                                        let _e1120 = (_e1119 < _e97);
                                                        if _e1120 {
                                                            if _e1120 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1122 = global_5.member[_e1119];
                                                            phi_1652_ = _e1122;
                                                        } else {
                                                            phi_1652_ = 0u;
                                                        }
                                                        let _e1124 = phi_1652_;
                                                        let _e1128 = (_e1118 + _e264);
                                                        let _e1129 = (_e1128 < _e97);
                                                        if _e1129 {
                                                            if _e1129 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1131 = global_5.member[_e1128];
                                                            phi_1670_ = _e1131;
                                                        } else {
                                                            phi_1670_ = 0u;
                                                        }
                                                        let _e1133 = phi_1670_;
                                                        let _e1137 = (_e1118 + _e266);
                                                        let _e1138 = (_e1137 < _e97);
                                                        if _e1138 {
                                                            if _e1138 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1140 = global_5.member[_e1137];
                                                            phi_1688_ = _e1140;
                                                        } else {
                                                            phi_1688_ = 0u;
                                                        }
                                                        let _e1142 = phi_1688_;
                                                        let _e1147 = (_e1088 + 6u);
                                                        let _e1148 = (_e1147 + _e265);
                                                        let _e1149 = (_e1148 < _e97);
                                                        if _e1149 {
                                                            if _e1149 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1151 = global_5.member[_e1148];
                                                            phi_1708_ = _e1151;
                                                        } else {
                                                            phi_1708_ = 0u;
                                                        }
                                                        let _e1153 = phi_1708_;
                                                        let _e1157 = (_e1147 + _e264);
                                                        let _e1158 = (_e1157 < _e97);
                                                        if _e1158 {
                                                            if _e1158 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1160 = global_5.member[_e1157];
                                                            phi_1726_ = _e1160;
                                                        } else {
                                                            phi_1726_ = 0u;
                                                        }
                                                        let _e1162 = phi_1726_;
                                                        let _e1166 = (_e1147 + _e266);
                                                        let _e1167 = (_e1166 < _e97);
                                                        if _e1167 {
                                                            if _e1167 {
                                                            } else {
                                                                phi_4474_ = _e1016;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1169 = global_5.member[_e1166];
                                                            phi_1744_ = _e1169;
                                                        } else {
                                                            phi_1744_ = 0u;
                                                        }
                                                        let _e1171 = phi_1744_;
                                                        phi_1750_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1095)) * _e145), (f32(bitcast<i32>(_e1104)) * _e145), (f32(bitcast<i32>(_e1113)) * _e145)), array<f32, 3>((f32(bitcast<i32>(_e1124)) * _e145), (f32(bitcast<i32>(_e1133)) * _e145), (f32(bitcast<i32>(_e1142)) * _e145)), array<f32, 3>((f32(bitcast<i32>(_e1153)) * _e145), (f32(bitcast<i32>(_e1162)) * _e145), (f32(bitcast<i32>(_e1171)) * _e145)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1750_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1445 = phi_1750_;
                                                let _e1452 = (_e1445[0][2] - _e391);
                                                let _e1455 = (((_e1445[0][0] - _e314) * _e415) - (_e1452 * _e339));
                                                let _e1458 = (((_e1445[0][1] - _e353) * _e415) - (_e1452 * _e377));
                                                let _e1465 = (_e1445[1][2] - _e391);
                                                let _e1468 = (((_e1445[1][0] - _e314) * _e415) - (_e1465 * _e339));
                                                let _e1471 = (((_e1445[1][1] - _e353) * _e415) - (_e1465 * _e377));
                                                let _e1478 = (_e1445[2][2] - _e391);
                                                let _e1481 = (((_e1445[2][0] - _e314) * _e415) - (_e1478 * _e339));
                                                let _e1484 = (((_e1445[2][1] - _e353) * _e415) - (_e1478 * _e377));
                                                let _e1485 = (_e1481 * _e1471);
                                                let _e1486 = (_e1484 * _e1468);
                                                let _e1487 = (_e1455 * _e1484);
                                                let _e1488 = (_e1458 * _e1481);
                                                let _e1489 = (_e1468 * _e1458);
                                                let _e1490 = (_e1471 * _e1455);
                                                let _e1495 = (((_e1485 >= _e1486) && (_e1487 >= _e1488)) && (_e1489 >= _e1490));
                                                if (_e1495 || (((_e1485 <= _e1486) && (_e1487 <= _e1488)) && (_e1489 <= _e1490))) {
                                                    let _e1502 = select(-1f, 1f, _e1495);
                                                    let _e1504 = ((_e1485 - _e1486) * _e1502);
                                                    let _e1506 = select(0f, _e1504, (_e1504 > 0f));
                                                    let _e1508 = ((_e1487 - _e1488) * _e1502);
                                                    let _e1510 = select(0f, _e1508, (_e1508 > 0f));
                                                    let _e1512 = ((_e1489 - _e1490) * _e1502);
                                                    let _e1514 = select(0f, _e1512, (_e1512 > 0f));
                                                    let _e1516 = ((_e1506 + _e1510) + _e1514);
                                                    if (_e1516 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2317_ = type_24();
                                                        phi_2318_ = true;
                                                    } else {
                                                        let _e1519 = select(_e1445[1][0], _e1445[0][0], (_e1445[0][0] < _e1445[1][0]));
                                                        let _e1523 = select(_e1445[1][0], _e1445[0][0], (_e1445[0][0] > _e1445[1][0]));
                                                        let _e1527 = select(_e1445[1][1], _e1445[0][1], (_e1445[0][1] < _e1445[1][1]));
                                                        let _e1531 = select(_e1445[1][1], _e1445[0][1], (_e1445[0][1] > _e1445[1][1]));
                                                        let _e1535 = select(_e1445[1][2], _e1445[0][2], (_e1445[0][2] < _e1445[1][2]));
                                                        let _e1539 = select(_e1445[1][2], _e1445[0][2], (_e1445[0][2] > _e1445[1][2]));
                                                        let _e1544 = ((select(_e1445[2][0], _e1519, (_e1519 < _e1445[2][0])) - _e337) * _e342);
                                                        let _e1545 = ((select(_e1445[2][0], _e1523, (_e1523 > _e1445[2][0])) - _e338) * _e342);
                                                        let _e1548 = ((select(_e1445[2][1], _e1527, (_e1527 < _e1445[2][1])) - _e375) * _e380);
                                                        let _e1549 = ((select(_e1445[2][1], _e1531, (_e1531 > _e1445[2][1])) - _e376) * _e380);
                                                        let _e1552 = ((select(_e1445[2][2], _e1535, (_e1535 < _e1445[2][2])) - _e413) * _e418);
                                                        let _e1553 = ((select(_e1445[2][2], _e1539, (_e1539 > _e1445[2][2])) - _e414) * _e418);
                                                        let _e1555 = select(_e1553, _e1552, (_e1552 < _e1553));
                                                        let _e1557 = select(_e1553, _e1552, (_e1552 > _e1553));
                                                        let _e1559 = select(_e1545, _e1544, (_e1544 < _e1545));
                                                        let _e1561 = select(_e1549, _e1548, (_e1548 < _e1549));
                                                        let _e1563 = select(_e1561, _e1559, (_e1559 > _e1561));
                                                        let _e1565 = select(_e1555, _e1563, (_e1563 > _e1555));
                                                        let _e1567 = select(_e1545, _e1544, (_e1544 > _e1545));
                                                        let _e1569 = select(_e1549, _e1548, (_e1548 > _e1549));
                                                        let _e1571 = select(_e1569, _e1567, (_e1567 < _e1569));
                                                        let _e1573 = select(_e1557, _e1571, (_e1571 < _e1557));
                                                        let _e1574 = -(_e1555);
                                                        let _e1580 = select(_e465, _e1565, (_e1565 > _e465));
                                                        if (_e1580 > (_e1573 + (select(_e1574, _e1557, (_e1557 > _e1574)) * 0.0000019073523f))) {
                                                            phi_2312_ = type_24();
                                                            phi_2313_ = true;
                                                        } else {
                                                            let _e1582 = (_e1580 > _e1016);
                                                            if _e1582 {
                                                                phi_2311_ = type_24();
                                                            } else {
                                                                let _e1586 = (_e1445[1][0] - _e1445[0][0]);
                                                                let _e1587 = (_e1445[1][1] - _e1445[0][1]);
                                                                let _e1588 = (_e1445[1][2] - _e1445[0][2]);
                                                                let _e1589 = vec3<f32>(_e1586, _e1587, _e1588);
                                                                let _e1590 = (_e1445[2][0] - _e1445[1][0]);
                                                                let _e1591 = (_e1445[2][1] - _e1445[1][1]);
                                                                let _e1592 = (_e1445[2][2] - _e1445[1][2]);
                                                                let _e1593 = vec3<f32>(_e1590, _e1591, _e1592);
                                                                let _e1594 = (_e1445[0][0] - _e1445[2][0]);
                                                                let _e1595 = (_e1445[0][1] - _e1445[2][1]);
                                                                let _e1596 = (_e1445[0][2] - _e1445[2][2]);
                                                                let _e1597 = vec3<f32>(_e1594, _e1595, _e1596);
                                                                let _e1600 = bitcast<f32>((bitcast<u32>(_e1586) & 2147483647u));
                                                                let _e1603 = bitcast<f32>((bitcast<u32>(_e1587) & 2147483647u));
                                                                let _e1605 = select(_e1603, _e1600, (_e1600 > _e1603));
                                                                let _e1608 = bitcast<f32>((bitcast<u32>(_e1588) & 2147483647u));
                                                                let _e1610 = select(_e1608, _e1605, (_e1605 > _e1608));
                                                                let _e1613 = bitcast<f32>((bitcast<u32>(_e1590) & 2147483647u));
                                                                let _e1616 = bitcast<f32>((bitcast<u32>(_e1591) & 2147483647u));
                                                                let _e1618 = select(_e1616, _e1613, (_e1613 > _e1616));
                                                                let _e1621 = bitcast<f32>((bitcast<u32>(_e1592) & 2147483647u));
                                                                let _e1623 = select(_e1621, _e1618, (_e1618 > _e1621));
                                                                let _e1626 = bitcast<f32>((bitcast<u32>(_e1594) & 2147483647u));
                                                                let _e1629 = bitcast<f32>((bitcast<u32>(_e1595) & 2147483647u));
                                                                let _e1631 = select(_e1629, _e1626, (_e1626 > _e1629));
                                                                let _e1634 = bitcast<f32>((bitcast<u32>(_e1596) & 2147483647u));
                                                                let _e1636 = select(_e1634, _e1631, (_e1631 > _e1634));
                                                                let _e1638 = select(_e1623, _e1610, (_e1610 > _e1623));
                                                                let _e1640 = select(_e1636, _e1638, (_e1638 > _e1636));
                                                                if (_e1610 == _e1640) {
                                                                    phi_2222_ = _e1593;
                                                                    phi_2223_ = _e1597;
                                                                } else {
                                                                    let _e1643 = vec3((_e1623 == _e1640));
                                                                    phi_2222_ = select(_e1589, _e1597, _e1643);
                                                                    phi_2223_ = select(_e1593, _e1589, _e1643);
                                                                }
                                                                let _e1647 = phi_2222_;
                                                                let _e1649 = phi_2223_;
                                                                let _e1656 = ((_e1647.y * _e1649.z) - (_e1649.y * _e1647.z));
                                                                let _e1661 = ((_e1647.z * _e1649.x) - (_e1649.z * _e1647.x));
                                                                let _e1664 = ((_e1647.x * _e1649.y) - (_e1649.x * _e1647.y));
                                                                if (_e1506 >= _e1510) {
                                                                    phi_2254_ = select(true, false, (_e1506 >= _e1514));
                                                                } else {
                                                                    phi_2254_ = true;
                                                                }
                                                                let _e1669 = phi_2254_;
                                                                if _e1669 {
                                                                    phi_2263_ = select(vec3<f32>(_e1445[2][0], _e1445[2][1], _e1445[2][2]), vec3<f32>(_e1445[1][0], _e1445[1][1], _e1445[1][2]), vec3((_e1510 >= _e1514)));
                                                                } else {
                                                                    phi_2263_ = vec3<f32>(_e1445[0][0], _e1445[0][1], _e1445[0][2]);
                                                                }
                                                                let _e1674 = phi_2263_;
                                                                let _e1691 = ((((_e1656 * (_e1674.x - _e314)) + (_e1661 * (_e1674.y - _e353))) + (_e1664 * (_e1674.z - _e391))) / (((_e1656 * _e339) + (_e1661 * _e377)) + (_e1664 * _e415)));
                                                                let _e1693 = select(_e1573, _e1691, (_e1691 < _e1573));
                                                                let _e1695 = select(_e1565, _e1693, (_e1693 > _e1565));
                                                                if (_e1695 >= _e465) {
                                                                    let _e1697 = (_e1695 <= _e1016);
                                                                    if _e1697 {
                                                                        let _e1698 = (1f / _e1516);
                                                                        phi_2303_ = type_24(_e1695, (_e1510 * _e1698), (_e1514 * _e1698), _e1076);
                                                                    } else {
                                                                        phi_2303_ = type_24();
                                                                    }
                                                                    let _e1703 = phi_2303_;
                                                                    phi_2305_ = _e1703;
                                                                    phi_2306_ = select(true, false, _e1697);
                                                                } else {
                                                                    phi_2305_ = type_24();
                                                                    phi_2306_ = true;
                                                                }
                                                                let _e1706 = phi_2305_;
                                                                let _e1708 = phi_2306_;
                                                                if _e1708 {
                                                                    phi_2310_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2310_ = _e1706;
                                                                }
                                                                let _e1710 = phi_2310_;
                                                                phi_2311_ = _e1710;
                                                            }
                                                            let _e1712 = phi_2311_;
                                                            phi_2312_ = _e1712;
                                                            phi_2313_ = _e1582;
                                                        }
                                                        let _e1714 = phi_2312_;
                                                        let _e1716 = phi_2313_;
                                                        phi_2317_ = _e1714;
                                                        phi_2318_ = _e1716;
                                                    }
                                                    let _e1718 = phi_2317_;
                                                    let _e1720 = phi_2318_;
                                                    phi_2322_ = _e1718;
                                                    phi_2323_ = _e1720;
                                                } else {
                                                    phi_2322_ = type_24();
                                                    phi_2323_ = true;
                                                }
                                                let _e1722 = phi_2322_;
                                                let _e1724 = phi_2323_;
                                                if _e1724 {
                                                    phi_2327_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2327_ = _e1722;
                                                }
                                                let _e1726 = phi_2327_;
                                                if (_e1726.member_3 != 4294967295u) {
                                                    if (_e1076 != 4294967295u) {
                                                        phi_2339_ = type_8(0u, 8u);
                                                        phi_2342_ = _e1726;
                                                        loop {
                                                            let _e1731 = phi_2339_;
                                                            let _e1733 = phi_2342_;
                                                            if (_e1731.member < _e1731.member_1) {
                                                                phi_2340_ = type_8((_e1731.member + 1u), _e1731.member_1);
                                                                phi_2365_ = type_8(1u, _e1731.member);
                                                            } else {
                                                                phi_2340_ = _e1731;
                                                                phi_2365_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1746 = phi_2340_;
                                                            let _e1748 = phi_2365_;
                                                            let _e1752 = (bitcast<i32>(_e1748.member) != 0i);
                                                            if _e1752 {
                                                                let _e1753 = (_e1748.member_1 < 8u);
                                                                if _e1753 {
                                                                } else {
                                                                    phi_4166_ = true;
                                                                    break;
                                                                }
                                                                let _e1758 = local_9[_e1748.member_1].member;
                                                                if (_e1733.member < _e1758) {
                                                                    phi_2398_ = true;
                                                                } else {
                                                                    let _e1760 = local_9[_e1748.member_1].member;
                                                                    if (_e1733.member == _e1760) {
                                                                        let _e1765 = local_9[_e1748.member_1].member_3;
                                                                        phi_2397_ = (_e1733.member_3 < _e1765);
                                                                    } else {
                                                                        phi_2397_ = false;
                                                                    }
                                                                    let _e1768 = phi_2397_;
                                                                    phi_2398_ = _e1768;
                                                                }
                                                                let _e1770 = phi_2398_;
                                                                if _e1770 {
                                                                    if _e1753 {
                                                                    } else {
                                                                        phi_4166_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1771 = local_9[_e1748.member_1];
                                                                    local_9[_e1748.member_1] = type_24(_e1733.member, _e1733.member_1, _e1733.member_2, _e1733.member_3);
                                                                    phi_2419_ = type_24(_e1771.member, _e1771.member_1, _e1771.member_2, _e1771.member_3);
                                                                } else {
                                                                    phi_2419_ = _e1733;
                                                                }
                                                                let _e1782 = phi_2419_;
                                                                phi_2343_ = _e1782;
                                                            } else {
                                                                phi_2343_ = type_24();
                                                            }
                                                            let _e1784 = phi_2343_;
                                                            continue;
                                                            continuing {
                                                                phi_2339_ = _e1746;
                                                                phi_2342_ = _e1784;
                                                                phi_4166_ = _e1014;
                                                                break if !(_e1752);
                                                            }
                                                        }
                                                        let _e1787 = phi_4166_;
                                                        phi_4474_ = _e1016;
                                                        phi_4327_ = _e1787;
                                                        if _e1787 {
                                                            break;
                                                        }
                                                        let _e1790 = local_9[7u].member_3;
                                                        if (_e1790 != 4294967295u) {
                                                            let _e1794 = local_9[7u].member;
                                                            phi_4537_ = _e1794;
                                                        } else {
                                                            phi_4537_ = _e1016;
                                                        }
                                                        let _e1796 = phi_4537_;
                                                        phi_4536_ = _e1796;
                                                        phi_4330_ = _e1787;
                                                    } else {
                                                        phi_4536_ = _e1016;
                                                        phi_4330_ = _e1014;
                                                    }
                                                    let _e1798 = phi_4536_;
                                                    let _e1800 = phi_4330_;
                                                    phi_4535_ = _e1798;
                                                    phi_4329_ = _e1800;
                                                } else {
                                                    phi_4535_ = _e1016;
                                                    phi_4329_ = _e1014;
                                                }
                                                let _e1802 = phi_4535_;
                                                let _e1804 = phi_4329_;
                                                phi_4534_ = _e1802;
                                                phi_4328_ = _e1804;
                                            } else {
                                                phi_4534_ = _e1016;
                                                phi_4328_ = _e1014;
                                            }
                                            let _e1806 = phi_4534_;
                                            let _e1808 = phi_4328_;
                                            continue;
                                            continuing {
                                                phi_4195_ = _e1808;
                                                phi_4138_ = _e1806;
                                                phi_1033_ = _e1031;
                                                phi_4474_ = _e1806;
                                                phi_4327_ = _e1808;
                                                break if !(_e1037);
                                            }
                                        }
                                        let _e1811 = phi_4474_;
                                        let _e1813 = phi_4327_;
                                        phi_4332_ = _e1813;
                                        if _e1813 {
                                            break;
                                        }
                                        phi_4439_ = _e1811;
                                        phi_4336_ = _e1813;
                                        phi_3671_ = _e546;
                                        phi_3672_ = false;
                                        phi_3673_ = _e550;
                                    } else {
                                        if (_e546.member_1 >= _e94) {
                                            phi_3226_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e546.member_1 < _e94) {
                                            } else {
                                                phi_4332_ = true;
                                                break;
                                            }
                                            let _e563 = ((1u + _e265) % 4u);
                                            if (_e563 < 4u) {
                                            } else {
                                                phi_4332_ = true;
                                                break;
                                            }
                                            let _e568 = global_3.member[_e546.member_1][_e563];
                                            let _e570 = (_e568 >> bitcast<u32>(11u));
                                            let _e572 = ((1u + _e264) % 4u);
                                            if (_e572 < 4u) {
                                            } else {
                                                phi_4332_ = true;
                                                break;
                                            }
                                            let _e577 = global_3.member[_e546.member_1][_e572];
                                            let _e579 = (_e577 >> bitcast<u32>(11u));
                                            let _e581 = ((1u + _e266) % 4u);
                                            if (_e581 < 4u) {
                                            } else {
                                                phi_4332_ = true;
                                                break;
                                            }
                                            let _e586 = global_3.member[_e546.member_1][_e581];
                                            let _e588 = (_e586 >> bitcast<u32>(11u));
                                            let _e611 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.x - _e546.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e612 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.y - _e546.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e613 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.z - _e546.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e615 = select(_e145, _e611, (_e611 > _e145));
                                            let _e617 = select(_e145, _e612, (_e612 > _e145));
                                            let _e619 = select(_e145, _e613, (_e613 > _e145));
                                            let _e644 = bitcast<u32>((f32(bitcast<i32>((_e568 & 1023u))) * _e615));
                                            let _e649 = (bitcast<i32>((_e568 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e652 = bitcast<f32>((_e644 & bitcast<u32>(_e649)));
                                            let _e653 = bitcast<u32>((f32(bitcast<i32>((_e577 & 1023u))) * _e617));
                                            let _e658 = (bitcast<i32>((_e577 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e661 = bitcast<f32>((_e653 & bitcast<u32>(_e658)));
                                            let _e662 = bitcast<u32>((f32(bitcast<i32>((_e586 & 1023u))) * _e619));
                                            let _e667 = (bitcast<i32>((_e586 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e670 = bitcast<f32>((_e662 & bitcast<u32>(_e667)));
                                            let _e674 = bitcast<f32>((_e644 & bitcast<u32>(~(_e649))));
                                            let _e678 = bitcast<f32>((_e653 & bitcast<u32>(~(_e658))));
                                            let _e682 = bitcast<f32>((_e662 & bitcast<u32>(~(_e667))));
                                            let _e683 = bitcast<u32>((f32(bitcast<i32>((_e570 & 1023u))) * _e615));
                                            let _e688 = (bitcast<i32>((_e570 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e691 = bitcast<f32>((_e683 & bitcast<u32>(_e688)));
                                            let _e692 = bitcast<u32>((f32(bitcast<i32>((_e579 & 1023u))) * _e617));
                                            let _e697 = (bitcast<i32>((_e579 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e700 = bitcast<f32>((_e692 & bitcast<u32>(_e697)));
                                            let _e701 = bitcast<u32>((f32(bitcast<i32>((_e588 & 1023u))) * _e619));
                                            let _e706 = (bitcast<i32>((_e588 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e709 = bitcast<f32>((_e701 & bitcast<u32>(_e706)));
                                            let _e713 = bitcast<f32>((_e683 & bitcast<u32>(~(_e688))));
                                            let _e717 = bitcast<f32>((_e692 & bitcast<u32>(~(_e697))));
                                            let _e721 = bitcast<f32>((_e701 & bitcast<u32>(~(_e706))));
                                            let _e722 = (_e546.member.member.x + _e652);
                                            let _e723 = (_e546.member.member.y + _e661);
                                            let _e724 = (_e546.member.member.z + _e670);
                                            let _e727 = (_e546.member.member_1.x - _e691);
                                            let _e728 = (_e546.member.member_1.y - _e700);
                                            let _e729 = (_e546.member.member_1.z - _e709);
                                            let _e748 = (_e727 - _e722);
                                            let _e749 = (_e728 - _e723);
                                            let _e750 = (_e729 - _e724);
                                            let _e752 = select(_e749, _e748, (_e748 > _e749));
                                            let _e754 = select(_e750, _e752, (_e752 > _e750));
                                            if (_e754 < (1024f * _e145)) {
                                                phi_2927_ = 0u;
                                            } else {
                                                phi_2927_ = select(2u, 1u, (_e754 < (2097152f * _e145)));
                                            }
                                            let _e761 = phi_2927_;
                                            switch bitcast<i32>(_e761) {
                                                case 0: {
                                                    phi_2933_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2933_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2933_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2933_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e764 = phi_2933_;
                                            let _e770 = global_3.member[_e546.member_1][0u];
                                            let _e774 = global_3.member[_e546.member_1][1u];
                                            let _e778 = global_3.member[_e546.member_1][2u];
                                            let _e782 = global_3.member[_e546.member_1][3u];
                                            let _e794 = (((_e774 >> bitcast<u32>(22i)) | ((_e778 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e782 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e795 = (_e770 & 268435455u);
                                            let _e796 = (_e794 & 268435455u);
                                            let _e799 = ((_e770 >> bitcast<u32>(28u)) & 7u);
                                            let _e807 = ((_e770 >> bitcast<u32>(31i)) | (((_e794 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e808 = (_e799 != 0u);
                                            if (_e799 == 0u) {
                                                phi_3188_ = _e795;
                                            } else {
                                                if (_e799 == 7u) {
                                                    phi_3187_ = 2147483648u;
                                                } else {
                                                    phi_3187_ = ((2147483648u | (_e799 << bitcast<u32>(28u))) | (_e796 & 268435455u));
                                                }
                                                let _e817 = phi_3187_;
                                                phi_3188_ = _e817;
                                            }
                                            let _e819 = phi_3188_;
                                            if _e808 {
                                                let _e820 = (_e799 != 7u);
                                                if _e820 {
                                                    phi_3198_ = (_e796 + (_e799 * ((3u * _e764) + 1u)));
                                                } else {
                                                    phi_3198_ = u32();
                                                }
                                                let _e824 = phi_3198_;
                                                phi_3200_ = _e824;
                                                phi_3201_ = select(true, false, _e820);
                                            } else {
                                                phi_3200_ = u32();
                                                phi_3201_ = true;
                                            }
                                            let _e827 = phi_3200_;
                                            let _e829 = phi_3201_;
                                            if (_e807 == 0u) {
                                                phi_3222_ = (_e795 + select(0u, 1u, !(_e808)));
                                            } else {
                                                if (_e807 == 7u) {
                                                    phi_3221_ = 2147483648u;
                                                } else {
                                                    phi_3221_ = ((2147483648u | (_e807 << bitcast<u32>(28u))) | (select(_e827, _e796, _e829) & 268435455u));
                                                }
                                                let _e842 = phi_3221_;
                                                phi_3222_ = _e842;
                                            }
                                            let _e844 = phi_3222_;
                                            phi_3226_ = type_52(array<vec4<f32>, 3>(vec4<f32>(_e722, (_e546.member.member.x + _e674), _e727, (_e546.member.member_1.x - _e713)), vec4<f32>(_e723, (_e546.member.member.y + _e678), _e728, (_e546.member.member_1.y - _e717)), vec4<f32>(_e724, (_e546.member.member.z + _e682), _e729, (_e546.member.member_1.z - _e721))), type_51(type_28((_e546.member.member + vec4<f32>(_e652, _e661, _e670, 0f)), (_e546.member.member_1 - vec4<f32>(_e691, _e700, _e709, 0f))), _e819), type_51(type_28((_e546.member.member + vec4<f32>(_e674, _e678, _e682, 0f)), (_e546.member.member_1 - vec4<f32>(_e713, _e717, _e721, 0f))), _e844));
                                        }
                                        let _e849 = phi_3226_;
                                        let _e860 = ((_e849.member[0].x - _e337) * _e342);
                                        let _e861 = ((_e849.member[0].y - _e337) * _e342);
                                        let _e862 = ((_e849.member[0].z - _e338) * _e342);
                                        let _e863 = ((_e849.member[0].w - _e338) * _e342);
                                        let _e873 = ((_e849.member[1].x - _e375) * _e380);
                                        let _e874 = ((_e849.member[1].y - _e375) * _e380);
                                        let _e875 = ((_e849.member[1].z - _e376) * _e380);
                                        let _e876 = ((_e849.member[1].w - _e376) * _e380);
                                        let _e886 = ((_e849.member[2].x - _e413) * _e418);
                                        let _e887 = ((_e849.member[2].y - _e413) * _e418);
                                        let _e888 = ((_e849.member[2].z - _e414) * _e418);
                                        let _e889 = ((_e849.member[2].w - _e414) * _e418);
                                        let _e891 = select(_e888, _e886, (_e886 < _e888));
                                        let _e893 = select(_e889, _e887, (_e887 < _e889));
                                        let _e895 = select(_e888, _e886, (_e886 > _e888));
                                        let _e897 = select(_e889, _e887, (_e887 > _e889));
                                        let _e899 = select(_e862, _e860, (_e860 < _e862));
                                        let _e901 = select(_e863, _e861, (_e861 < _e863));
                                        let _e903 = select(_e875, _e873, (_e873 < _e875));
                                        let _e905 = select(_e876, _e874, (_e874 < _e876));
                                        let _e907 = select(_e903, _e899, (_e899 > _e903));
                                        let _e909 = select(_e905, _e901, (_e901 > _e905));
                                        let _e911 = select(_e891, _e907, (_e907 > _e891));
                                        let _e913 = select(_e893, _e909, (_e909 > _e893));
                                        let _e915 = select(_e862, _e860, (_e860 > _e862));
                                        let _e917 = select(_e863, _e861, (_e861 > _e863));
                                        let _e919 = select(_e875, _e873, (_e873 > _e875));
                                        let _e921 = select(_e876, _e874, (_e874 > _e876));
                                        let _e923 = select(_e919, _e915, (_e915 < _e919));
                                        let _e925 = select(_e921, _e917, (_e917 < _e921));
                                        let _e930 = -(_e891);
                                        let _e931 = -(_e893);
                                        let _e938 = (select(_e895, _e923, (_e923 < _e895)) + (select(_e930, _e895, (_e895 > _e930)) * 0.0000019073523f));
                                        let _e939 = (select(_e897, _e925, (_e925 < _e897)) + (select(_e931, _e897, (_e897 > _e931)) * 0.0000019073523f));
                                        let _e941 = select(_e465, _e911, (_e911 > _e465));
                                        let _e943 = select(_e465, _e913, (_e913 > _e465));
                                        let _e948 = (_e941 <= select(_e508, _e938, (_e938 < _e508)));
                                        let _e949 = (_e943 <= select(_e508, _e939, (_e939 < _e508)));
                                        let _e950 = (_e941 <= _e943);
                                        if _e948 {
                                            if _e949 {
                                                if _e950 {
                                                    phi_3571_ = _e849.member_2;
                                                } else {
                                                    phi_3571_ = _e849.member_1;
                                                }
                                                let _e954 = phi_3571_;
                                                let _e976 = (_e550 % 128u);
                                                let _e977 = (_e976 < 128u);
                                                if _e977 {
                                                } else {
                                                    phi_4332_ = true;
                                                    break;
                                                }
                                                local_8[_e976] = _e954.member_1;
                                                if _e977 {
                                                } else {
                                                    phi_4332_ = true;
                                                    break;
                                                }
                                                local_7[_e976] = _e954.member.member.x;
                                                if _e977 {
                                                } else {
                                                    phi_4332_ = true;
                                                    break;
                                                }
                                                local_6[_e976] = _e954.member.member.y;
                                                if _e977 {
                                                } else {
                                                    phi_4332_ = true;
                                                    break;
                                                }
                                                local_5[_e976] = _e954.member.member.z;
                                                if _e977 {
                                                } else {
                                                    phi_4332_ = true;
                                                    break;
                                                }
                                                local_4[_e976] = _e954.member.member_1.x;
                                                if _e977 {
                                                } else {
                                                    phi_4332_ = true;
                                                    break;
                                                }
                                                local_3[_e976] = _e954.member.member_1.y;
                                                if _e977 {
                                                } else {
                                                    phi_4332_ = true;
                                                    break;
                                                }
                                                local_2[_e976] = _e954.member.member_1.z;
                                                if _e977 {
                                                } else {
                                                    phi_4332_ = true;
                                                    break;
                                                }
                                                local_10[_e976] = select(_e943, _e941, (_e941 > _e943));
                                                if _e950 {
                                                    phi_3648_ = _e849.member_1;
                                                } else {
                                                    phi_3648_ = _e849.member_2;
                                                }
                                                let _e990 = phi_3648_;
                                                phi_3649_ = _e990;
                                                phi_3650_ = (_e550 + 1u);
                                            } else {
                                                phi_3649_ = type_51();
                                                phi_3650_ = u32();
                                            }
                                            let _e992 = phi_3649_;
                                            let _e994 = phi_3650_;
                                            phi_3652_ = _e992;
                                            phi_3653_ = _e994;
                                            phi_3654_ = select(true, false, _e949);
                                        } else {
                                            phi_3652_ = type_51();
                                            phi_3653_ = u32();
                                            phi_3654_ = true;
                                        }
                                        let _e997 = phi_3652_;
                                        let _e999 = phi_3653_;
                                        let _e1001 = phi_3654_;
                                        if _e1001 {
                                            if _e948 {
                                                phi_3663_ = _e849.member_1;
                                            } else {
                                                phi_3663_ = _e849.member_2;
                                            }
                                            let _e1005 = phi_3663_;
                                            phi_3668_ = _e1005;
                                            phi_3669_ = select(_e949, true, _e948);
                                        } else {
                                            phi_3668_ = _e997;
                                            phi_3669_ = _e548;
                                        }
                                        let _e1008 = phi_3668_;
                                        let _e1010 = phi_3669_;
                                        phi_4439_ = _e508;
                                        phi_4336_ = _e506;
                                        phi_3671_ = _e1008;
                                        phi_3672_ = _e1010;
                                        phi_3673_ = select(_e999, _e550, _e1001);
                                    }
                                    let _e1815 = phi_4439_;
                                    let _e1817 = phi_4336_;
                                    let _e1819 = phi_3671_;
                                    let _e1821 = phi_3672_;
                                    let _e1823 = phi_3673_;
                                    phi_4438_ = _e1815;
                                    phi_4335_ = _e1817;
                                    phi_3674_ = _e1819;
                                    phi_3675_ = (_e512 - 1u);
                                    phi_3676_ = _e1821;
                                    phi_3677_ = _e1823;
                                } else {
                                    phi_4438_ = _e508;
                                    phi_4335_ = _e506;
                                    phi_3674_ = _e546;
                                    phi_3675_ = _e512;
                                    phi_3676_ = _e548;
                                    phi_3677_ = _e550;
                                }
                                let _e1825 = phi_4438_;
                                let _e1827 = phi_4335_;
                                let _e1829 = phi_3674_;
                                let _e1831 = phi_3675_;
                                let _e1833 = phi_3676_;
                                let _e1835 = phi_3677_;
                                phi_4437_ = _e1825;
                                phi_4334_ = _e1827;
                                phi_3678_ = _e1829;
                                phi_3679_ = _e1831;
                                phi_3680_ = _e1833;
                                phi_3681_ = _e1835;
                            } else {
                                phi_4437_ = _e508;
                                phi_4334_ = _e506;
                                phi_3678_ = type_51();
                                phi_3679_ = u32();
                                phi_3680_ = bool();
                                phi_3681_ = u32();
                            }
                            let _e1837 = phi_4437_;
                            let _e1839 = phi_4334_;
                            let _e1841 = phi_3678_;
                            let _e1843 = phi_3679_;
                            let _e1845 = phi_3680_;
                            let _e1847 = phi_3681_;
                            phi_4436_ = _e1837;
                            phi_4333_ = _e1839;
                            phi_908_ = _e1841;
                            phi_911_ = _e1843;
                            phi_913_ = _e1845;
                            phi_915_ = _e1847;
                            phi_3682_ = _e520;
                        } else {
                            phi_4436_ = _e508;
                            phi_4333_ = _e506;
                            phi_908_ = type_51();
                            phi_911_ = u32();
                            phi_913_ = bool();
                            phi_915_ = u32();
                            phi_3682_ = false;
                        }
                        let _e1849 = phi_4436_;
                        let _e1851 = phi_4333_;
                        let _e1853 = phi_908_;
                        let _e1855 = phi_911_;
                        let _e1857 = phi_913_;
                        let _e1859 = phi_915_;
                        let _e1861 = phi_3682_;
                        continue;
                        continuing {
                            phi_4198_ = _e1851;
                            phi_4054_ = _e1849;
                            phi_907_ = _e1853;
                            phi_910_ = _e1855;
                            phi_912_ = _e1857;
                            phi_914_ = _e1859;
                            phi_4332_ = _e1851;
                            break if !(_e1861);
                        }
                    }
                    let _e1864 = phi_4332_;
                    if _e1864 {
                        break;
                    }
                    phi_3689_ = type_8(0u, 8u);
                    loop {
                        let _e1866 = phi_3689_;
                        if (_e1866.member < _e1866.member_1) {
                            phi_3690_ = type_8((_e1866.member + 1u), _e1866.member_1);
                            phi_3713_ = type_8(1u, _e1866.member);
                        } else {
                            phi_3690_ = _e1866;
                            phi_3713_ = type_8(0u, type_8().member_1);
                        }
                        let _e1879 = phi_3690_;
                        let _e1881 = phi_3713_;
                        let _e1885 = (bitcast<i32>(_e1881.member) != 0i);
                        if _e1885 {
                            let _e1886 = (_e1881.member_1 < 8u);
                            if _e1886 {
                            } else {
                                phi_4429_ = true;
                                break;
                            }
                            let _e1888 = local_9[_e1881.member_1];
                            if (_e1888.member_3 != 4294967295u) {
                                let _e1894 = -(_e432);
                                let _e1895 = (_e1894 / 3i);
                                let _e1902 = bitcast<f32>((bitcast<u32>((_e1895 + 127i)) << bitcast<u32>(23i)));
                                let _e1910 = (((_e1888.member * _e1902) * _e1902) * bitcast<f32>((bitcast<u32>(((_e1894 - (2i * _e1895)) + 127i)) << bitcast<u32>(23i))));
                                let _e1912 = select(340282350000000000000000000000000000000f, _e1910, (_e1910 < 340282350000000000000000000000000000000f));
                                phi_3779_ = type_24(select(-340282350000000000000000000000000000000f, _e1912, (_e1912 > -340282350000000000000000000000000000000f)), _e1888.member_1, _e1888.member_2, _e1888.member_3);
                            } else {
                                phi_3779_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1917 = phi_3779_;
                            if _e1886 {
                            } else {
                                phi_4429_ = true;
                                break;
                            }
                            local_9[_e1881.member_1] = type_24(_e1917.member, _e1917.member_1, _e1917.member_2, _e1917.member_3);
                        }
                        continue;
                        continuing {
                            phi_3689_ = _e1879;
                            phi_4429_ = _e1864;
                            break if !(_e1885);
                        }
                    }
                    let _e1925 = phi_4429_;
                    if _e1925 {
                        break;
                    }
                    let _e1926 = local_9;
                    if _e153 {
                    } else {
                        break;
                    }
                    global_6.member[_e151] = array<type_24, 8>(type_24(_e1926[0].member, _e1926[0].member_1, _e1926[0].member_2, _e1926[0].member_3), type_24(_e1926[1].member, _e1926[1].member_1, _e1926[1].member_2, _e1926[1].member_3), type_24(_e1926[2].member, _e1926[2].member_1, _e1926[2].member_2, _e1926[2].member_3), type_24(_e1926[3].member, _e1926[3].member_1, _e1926[3].member_2, _e1926[3].member_3), type_24(_e1926[4].member, _e1926[4].member_1, _e1926[4].member_2, _e1926[4].member_3), type_24(_e1926[5].member, _e1926[5].member_1, _e1926[5].member_2, _e1926[5].member_3), type_24(_e1926[6].member, _e1926[6].member_1, _e1926[6].member_2, _e1926[6].member_3), type_24(_e1926[7].member, _e1926[7].member_1, _e1926[7].member_2, _e1926[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
