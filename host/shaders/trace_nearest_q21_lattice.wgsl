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

struct type_20 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_32 {
    member: array<type_21>,
}

struct type_36 {
    member: array<array<type_20, 8>>,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<array<u32, 7>>,
}

struct type_51 {
    member: type_24,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_42;
@group(0) @binding(4) 
var<storage> global_3: type_32;
@group(0) @binding(2) 
var<storage> global_4: type_46;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_36;

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
    var local_9: array<type_20, 8>;
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
    var phi_2303_: type_20;
    var phi_2305_: type_20;
    var phi_2306_: bool;
    var phi_2310_: type_20;
    var phi_2311_: type_20;
    var phi_2312_: type_20;
    var phi_2313_: bool;
    var phi_2317_: type_20;
    var phi_2318_: bool;
    var phi_2322_: type_20;
    var phi_2323_: bool;
    var phi_2327_: type_20;
    var phi_2339_: type_8;
    var phi_2342_: type_20;
    var phi_2340_: type_8;
    var phi_2365_: type_8;
    var phi_2397_: bool;
    var phi_2398_: bool;
    var phi_2419_: type_20;
    var phi_2343_: type_20;
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
    var phi_3779_: type_20;
    var phi_4429_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e90 = global;
            let _e92 = arrayLength((&global_4.member));
            let _e95 = arrayLength((&global_5.member));
            let _e103 = global_2.member[0u][0u];
            let _e107 = global_2.member[0u][1u];
            let _e111 = global_2.member[0u][2u];
            let _e115 = global_2.member[0u][3u];
            let _e119 = global_2.member[1u][0u];
            let _e123 = global_2.member[1u][1u];
            let _e127 = global_2.member[1u][2u];
            let _e130 = global_1.member[0u];
            let _e131 = bitcast<i32>(_e130);
            let _e143 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e115) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e103), bitcast<i32>(_e107), bitcast<i32>(_e111));
            local = array<i32, 3>(bitcast<i32>(_e119), bitcast<i32>(_e123), bitcast<i32>(_e127));
            let _e149 = (_e90.x + (_e90.y * 2097152u));
            let _e150 = (_e149 < arrayLength((&global_3.member)));
            if _e150 {
                let _e151 = (_e149 < arrayLength((&global_6.member)));
                if _e151 {
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e159 = global_3.member[_e149].member_2[0u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_3.member[_e149].member_2[1u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_3.member[_e149].member_2[2u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_3.member[_e149].member[0u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e187 = global_3.member[_e149].member[1u];
                    let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                    let _e194 = global_3.member[_e149].member[2u];
                    let _e196 = (bitcast<u32>(_e194) & 2147483647u);
                    let _e198 = select(_e168, _e161, (_e168 < _e161));
                    let _e200 = select(_e175, _e198, (_e175 < _e198));
                    let _e202 = select(_e182, _e200, (_e182 < _e200));
                    let _e204 = select(_e189, _e202, (_e189 < _e202));
                    let _e206 = select(_e196, _e204, (_e196 < _e204));
                    let _e210 = global_3.member[_e149].member_1;
                    let _e212 = (bitcast<u32>(_e210) & 2147483647u);
                    let _e219 = global_3.member[_e149].member_3;
                    let _e225 = (((select(_e212, _e206, (_e212 < _e206)) < 2139095040u) && ((bitcast<u32>(_e219) & 2147483647u) <= 2139095040u)) && (_e200 > 0u));
                    if _e225 {
                        let _e228 = (bitcast<u32>(bitcast<f32>(_e200)) & 2147483647u);
                        if (_e228 >= 8388608u) {
                            phi_396_ = (bitcast<i32>((_e228 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_396_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e228)), 32u, (_e228 == 0u))));
                        }
                        let _e242 = phi_396_;
                        phi_397_ = _e242;
                    } else {
                        phi_397_ = 0i;
                    }
                    let _e244 = phi_397_;
                    let _e245 = (_e161 == _e200);
                    if _e245 {
                        phi_407_ = true;
                    } else {
                        phi_407_ = (_e168 == _e200);
                    }
                    let _e248 = phi_407_;
                    let _e249 = select(1u, 0u, _e245);
                    if _e248 {
                        let _e250 = (_e249 + 1u);
                        phi_417_ = _e250;
                        phi_418_ = _e250;
                        phi_420_ = select(true, false, (_e250 == 2u));
                    } else {
                        phi_417_ = u32();
                        phi_418_ = 0u;
                        phi_420_ = true;
                    }
                    let _e254 = phi_417_;
                    let _e256 = phi_418_;
                    let _e258 = phi_420_;
                    if _e258 {
                        phi_425_ = (_e256 + 1u);
                    } else {
                        phi_425_ = 0u;
                    }
                    let _e262 = phi_425_;
                    let _e263 = select(_e254, _e256, _e258);
                    let _e264 = select(_e249, select(2u, _e249, _e248), _e258);
                    if (_e131 < -126i) {
                        phi_437_ = -126i;
                    } else {
                        phi_437_ = select(_e131, 127i, (_e131 > 127i));
                    }
                    let _e269 = phi_437_;
                    let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                    let _e280 = bitcast<f32>((bitcast<u32>(((_e131 - _e269) + 127i)) << bitcast<u32>(23i)));
                    let _e281 = -(_e244);
                    if (_e281 < -126i) {
                        phi_457_ = -126i;
                    } else {
                        phi_457_ = select(_e281, 127i, (_e281 > 127i));
                    }
                    let _e286 = phi_457_;
                    let _e291 = bitcast<f32>((bitcast<u32>((_e286 + 127i)) << bitcast<u32>(23i)));
                    let _e297 = bitcast<f32>((bitcast<u32>(((_e281 - _e286) + 127i)) << bitcast<u32>(23i)));
                    let _e301 = global_3.member[_e149].member;
                    let _e302 = (_e263 == 0u);
                    if _e302 {
                        phi_475_ = _e301[0];
                    } else {
                        phi_475_ = _e301[1];
                    }
                    let _e306 = phi_475_;
                    let _e307 = (_e263 == 2u);
                    if _e307 {
                        phi_481_ = _e301[2];
                    } else {
                        phi_481_ = _e306;
                    }
                    let _e310 = phi_481_;
                    let _e312 = ((_e310 * _e274) * _e280);
                    let _e313 = global_3.member[_e149].member_2;
                    if _e302 {
                        phi_492_ = _e313[0];
                    } else {
                        phi_492_ = _e313[1];
                    }
                    let _e317 = phi_492_;
                    if _e307 {
                        phi_498_ = _e313[2];
                    } else {
                        phi_498_ = _e317;
                    }
                    let _e320 = phi_498_;
                    let _e322 = ((_e320 * _e291) * _e297);
                    let _e326 = (bitcast<f32>((bitcast<u32>(_e322) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e326 {
                        let _e330 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) * 0.00000011920929f);
                        phi_521_ = select(0.00000000000011368684f, _e330, (_e330 > 0.00000000000011368684f));
                    } else {
                        phi_521_ = 0f;
                    }
                    let _e334 = phi_521_;
                    let _e335 = (_e312 + _e334);
                    let _e336 = (_e312 - _e334);
                    let _e337 = select(_e322, 0f, _e326);
                    if _e326 {
                        phi_532_ = 38685626000000000000000000f;
                    } else {
                        phi_532_ = (1f / _e322);
                    }
                    let _e340 = phi_532_;
                    let _e341 = (_e262 == 0u);
                    if _e341 {
                        phi_541_ = _e301[0];
                    } else {
                        phi_541_ = _e301[1];
                    }
                    let _e345 = phi_541_;
                    let _e346 = (_e262 == 2u);
                    if _e346 {
                        phi_547_ = _e301[2];
                    } else {
                        phi_547_ = _e345;
                    }
                    let _e349 = phi_547_;
                    let _e351 = ((_e349 * _e274) * _e280);
                    if _e341 {
                        phi_558_ = _e313[0];
                    } else {
                        phi_558_ = _e313[1];
                    }
                    let _e355 = phi_558_;
                    if _e346 {
                        phi_564_ = _e313[2];
                    } else {
                        phi_564_ = _e355;
                    }
                    let _e358 = phi_564_;
                    let _e360 = ((_e358 * _e291) * _e297);
                    let _e364 = (bitcast<f32>((bitcast<u32>(_e360) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e364 {
                        let _e368 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) * 0.00000011920929f);
                        phi_587_ = select(0.00000000000011368684f, _e368, (_e368 > 0.00000000000011368684f));
                    } else {
                        phi_587_ = 0f;
                    }
                    let _e372 = phi_587_;
                    let _e373 = (_e351 + _e372);
                    let _e374 = (_e351 - _e372);
                    let _e375 = select(_e360, 0f, _e364);
                    if _e364 {
                        phi_598_ = 38685626000000000000000000f;
                    } else {
                        phi_598_ = (1f / _e360);
                    }
                    let _e378 = phi_598_;
                    let _e379 = (_e264 == 0u);
                    if _e379 {
                        phi_607_ = _e301[0];
                    } else {
                        phi_607_ = _e301[1];
                    }
                    let _e383 = phi_607_;
                    let _e384 = (_e264 == 2u);
                    if _e384 {
                        phi_613_ = _e301[2];
                    } else {
                        phi_613_ = _e383;
                    }
                    let _e387 = phi_613_;
                    let _e389 = ((_e387 * _e274) * _e280);
                    if _e379 {
                        phi_624_ = _e313[0];
                    } else {
                        phi_624_ = _e313[1];
                    }
                    let _e393 = phi_624_;
                    if _e384 {
                        phi_630_ = _e313[2];
                    } else {
                        phi_630_ = _e393;
                    }
                    let _e396 = phi_630_;
                    let _e398 = ((_e396 * _e291) * _e297);
                    let _e402 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e402 {
                        let _e406 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) * 0.00000011920929f);
                        phi_653_ = select(0.00000000000011368684f, _e406, (_e406 > 0.00000000000011368684f));
                    } else {
                        phi_653_ = 0f;
                    }
                    let _e410 = phi_653_;
                    let _e411 = (_e389 + _e410);
                    let _e412 = (_e389 - _e410);
                    let _e413 = select(_e398, 0f, _e402);
                    if _e402 {
                        phi_664_ = 38685626000000000000000000f;
                    } else {
                        phi_664_ = (1f / _e398);
                    }
                    let _e416 = phi_664_;
                    let _e419 = bitcast<f32>((bitcast<u32>(_e312) & 2147483647u));
                    let _e422 = bitcast<f32>((bitcast<u32>(_e351) & 2147483647u));
                    let _e424 = select(_e422, _e419, (_e419 > _e422));
                    let _e427 = bitcast<f32>((bitcast<u32>(_e389) & 2147483647u));
                    let _e430 = (_e131 + _e244);
                    if (_e225 && (select(_e427, _e424, (_e424 > _e427)) <= 1099511600000f)) {
                        let _e433 = (_e430 / 3i);
                        let _e440 = bitcast<f32>((bitcast<u32>((_e433 + 127i)) << bitcast<u32>(23i)));
                        let _e447 = bitcast<f32>((bitcast<u32>(((_e430 - (2i * _e433)) + 127i)) << bitcast<u32>(23i)));
                        let _e448 = (((_e210 * _e440) * _e440) * _e447);
                        let _e450 = select(340282350000000000000000000000000000000f, _e448, (_e448 < 340282350000000000000000000000000000000f));
                        let _e455 = (((_e219 * _e440) * _e440) * _e447);
                        let _e457 = select(340282350000000000000000000000000000000f, _e455, (_e455 < 340282350000000000000000000000000000000f));
                        phi_764_ = select(-340282350000000000000000000000000000000f, _e457, (_e457 > -340282350000000000000000000000000000000f));
                        phi_765_ = select(-340282350000000000000000000000000000000f, _e450, (_e450 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_764_ = 0f;
                        phi_765_ = 1f;
                    }
                    let _e461 = phi_764_;
                    let _e463 = phi_765_;
                    local_9 = array<type_20, 8>(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e466 = (_e263 % 3u);
                    let _e467 = (_e466 < 3u);
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e469 = local_1[_e466];
                    let _e472 = (_e262 % 3u);
                    let _e473 = (_e472 < 3u);
                    if _e473 {
                    } else {
                        break;
                    }
                    let _e475 = local_1[_e472];
                    let _e478 = (_e264 % 3u);
                    let _e479 = (_e478 < 3u);
                    if _e479 {
                    } else {
                        break;
                    }
                    let _e481 = local_1[_e478];
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e486 = local[_e466];
                    if _e473 {
                    } else {
                        break;
                    }
                    let _e490 = local[_e472];
                    if _e479 {
                    } else {
                        break;
                    }
                    let _e494 = local[_e478];
                    phi_4198_ = false;
                    phi_4054_ = _e461;
                    phi_907_ = type_51(type_24(vec4<f32>((f32(_e469) * _e143), (f32(_e475) * _e143), (f32(_e481) * _e143), 0f), vec4<f32>((f32(_e486) * _e143), (f32(_e490) * _e143), (f32(_e494) * _e143), 0f)), select(0u, 2147483648u, (_e92 == 0u)));
                    phi_910_ = ((3u * _e92) + 1u);
                    phi_912_ = (_e463 <= _e461);
                    phi_914_ = 0u;
                    loop {
                        let _e504 = phi_4198_;
                        let _e506 = phi_4054_;
                        let _e508 = phi_907_;
                        let _e510 = phi_910_;
                        let _e512 = phi_912_;
                        let _e514 = phi_914_;
                        if _e512 {
                            phi_925_ = true;
                        } else {
                            phi_925_ = (_e514 > 0u);
                        }
                        let _e517 = phi_925_;
                        if _e517 {
                            let _e518 = (_e510 > 0u);
                            if _e518 {
                                if _e512 {
                                    phi_1012_ = _e508;
                                    phi_1013_ = _e512;
                                    phi_1014_ = _e514;
                                } else {
                                    let _e519 = (_e514 - 1u);
                                    let _e520 = (_e519 % 128u);
                                    let _e521 = (_e520 < 128u);
                                    if _e521 {
                                    } else {
                                        phi_4332_ = true;
                                        break;
                                    }
                                    let _e523 = local_7[_e520];
                                    if _e521 {
                                    } else {
                                        phi_4332_ = true;
                                        break;
                                    }
                                    let _e525 = local_6[_e520];
                                    if _e521 {
                                    } else {
                                        phi_4332_ = true;
                                        break;
                                    }
                                    let _e527 = local_5[_e520];
                                    if _e521 {
                                    } else {
                                        phi_4332_ = true;
                                        break;
                                    }
                                    let _e529 = local_4[_e520];
                                    if _e521 {
                                    } else {
                                        phi_4332_ = true;
                                        break;
                                    }
                                    let _e531 = local_3[_e520];
                                    if _e521 {
                                    } else {
                                        phi_4332_ = true;
                                        break;
                                    }
                                    let _e533 = local_2[_e520];
                                    if _e521 {
                                    } else {
                                        phi_4332_ = true;
                                        break;
                                    }
                                    let _e538 = local_8[_e520];
                                    if _e521 {
                                    } else {
                                        phi_4332_ = true;
                                        break;
                                    }
                                    let _e541 = local_10[_e520];
                                    phi_1012_ = type_51(type_24(vec4<f32>(_e523, _e525, _e527, 0f), vec4<f32>(_e529, _e531, _e533, 0f)), _e538);
                                    phi_1013_ = (_e541 <= _e506);
                                    phi_1014_ = _e519;
                                }
                                let _e544 = phi_1012_;
                                let _e546 = phi_1013_;
                                let _e548 = phi_1014_;
                                if _e546 {
                                    let _e553 = (_e544.member_1 & 268435455u);
                                    if ((_e544.member_1 & 2147483648u) != 0u) {
                                        phi_4195_ = _e504;
                                        phi_4138_ = _e506;
                                        phi_1033_ = type_8(0u, ((_e544.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1030 = phi_4195_;
                                            let _e1032 = phi_4138_;
                                            let _e1034 = phi_1033_;
                                            if (_e1034.member < _e1034.member_1) {
                                                phi_1034_ = type_8((_e1034.member + 1u), _e1034.member_1);
                                                phi_1057_ = type_8(1u, _e1034.member);
                                            } else {
                                                phi_1034_ = _e1034;
                                                phi_1057_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1047 = phi_1034_;
                                            let _e1049 = phi_1057_;
                                            let _e1053 = (bitcast<i32>(_e1049.member) != 0i);
                                            if _e1053 {
                                                let _e1058 = (_e544.member.member_1.x - _e544.member.member.x);
                                                let _e1061 = (_e544.member.member_1.y - _e544.member.member.y);
                                                let _e1064 = (_e544.member.member_1.z - _e544.member.member.z);
                                                let _e1066 = select(_e1061, _e1058, (_e1058 > _e1061));
                                                let _e1068 = select(_e1064, _e1066, (_e1066 > _e1064));
                                                let _e1070 = (_e1068 < (1024f * _e143));
                                                if _e1070 {
                                                    phi_1098_ = 0u;
                                                } else {
                                                    phi_1098_ = select(2u, 1u, (_e1068 < (2097152f * _e143)));
                                                }
                                                let _e1075 = phi_1098_;
                                                switch bitcast<i32>(_e1075) {
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
                                                let _e1078 = phi_1104_;
                                                switch bitcast<i32>(_e1075) {
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
                                                let _e1085 = phi_1114_;
                                                let _e1087 = ((_e553 + (_e1049.member_1 * ((3u * _e1078) + 1u))) + (3u * _e1085));
                                                let _e1088 = (_e1087 < _e95);
                                                if _e1088 {
                                                    if _e1088 {
                                                    } else {
                                                        phi_4474_ = _e1032;
                                                        phi_4327_ = true;
                                                        break;
                                                    }
                                                    let _e1090 = global_5.member[_e1087];
                                                    phi_1130_ = _e1090;
                                                } else {
                                                    phi_1130_ = 4294967295u;
                                                }
                                                let _e1092 = phi_1130_;
                                                if _e1070 {
                                                    phi_1163_ = 0u;
                                                } else {
                                                    phi_1163_ = select(2u, 1u, (_e1068 < (2097152f * _e143)));
                                                }
                                                let _e1097 = phi_1163_;
                                                switch bitcast<i32>(_e1097) {
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
                                                let _e1100 = phi_1169_;
                                                let _e1104 = (_e553 + (_e1049.member_1 * ((3u * _e1100) + 1u)));
                                                switch bitcast<i32>(_e1097) {
                                                    case 0: {
                                                        let _e1370 = (_e1104 < _e95);
                                                        if _e1370 {
                                                            if _e1370 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1372 = global_5.member[_e1104];
                                                            phi_1193_ = _e1372;
                                                        } else {
                                                            phi_1193_ = 0u;
                                                        }
                                                        let _e1374 = phi_1193_;
                                                        let _e1376 = ((10u * _e263) & 31u);
                                                        let _e1385 = ((10u * _e262) & 31u);
                                                        let _e1394 = ((10u * _e264) & 31u);
                                                        let _e1403 = (_e1104 + 1u);
                                                        let _e1404 = (_e1403 < _e95);
                                                        if _e1404 {
                                                            if _e1404 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1406 = global_5.member[_e1403];
                                                            phi_1236_ = _e1406;
                                                        } else {
                                                            phi_1236_ = 0u;
                                                        }
                                                        let _e1408 = phi_1236_;
                                                        let _e1431 = (_e1104 + 2u);
                                                        let _e1432 = (_e1431 < _e95);
                                                        if _e1432 {
                                                            if _e1432 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1434 = global_5.member[_e1431];
                                                            phi_1279_ = _e1434;
                                                        } else {
                                                            phi_1279_ = 0u;
                                                        }
                                                        let _e1436 = phi_1279_;
                                                        phi_1750_ = array<array<f32, 3>, 3>(array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>(((_e1374 >> bitcast<u32>(_e1376)) & 1023u))) * _e143)), (_e544.member.member.y + (f32(bitcast<i32>(((_e1374 >> bitcast<u32>(_e1385)) & 1023u))) * _e143)), (_e544.member.member.z + (f32(bitcast<i32>(((_e1374 >> bitcast<u32>(_e1394)) & 1023u))) * _e143))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>(((_e1408 >> bitcast<u32>(_e1376)) & 1023u))) * _e143)), (_e544.member.member.y + (f32(bitcast<i32>(((_e1408 >> bitcast<u32>(_e1385)) & 1023u))) * _e143)), (_e544.member.member.z + (f32(bitcast<i32>(((_e1408 >> bitcast<u32>(_e1394)) & 1023u))) * _e143))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>(((_e1436 >> bitcast<u32>(_e1376)) & 1023u))) * _e143)), (_e544.member.member.y + (f32(bitcast<i32>(((_e1436 >> bitcast<u32>(_e1385)) & 1023u))) * _e143)), (_e544.member.member.z + (f32(bitcast<i32>(((_e1436 >> bitcast<u32>(_e1394)) & 1023u))) * _e143))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1193 = (_e1104 < _e95);
                                                        if _e1193 {
                                                            if _e1193 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1195 = global_5.member[_e1104];
                                                            phi_1322_ = _e1195;
                                                        } else {
                                                            phi_1322_ = 0u;
                                                        }
                                                        let _e1197 = phi_1322_;
                                                        let _e1198 = (_e1104 + 1u);
                                                        let _e1199 = (_e1198 < _e95);
                                                        if _e1199 {
                                                            if _e1199 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1201 = global_5.member[_e1198];
                                                            phi_1337_ = _e1201;
                                                        } else {
                                                            phi_1337_ = 0u;
                                                        }
                                                        let _e1203 = phi_1337_;
                                                        let _e1204 = (_e263 == 1u);
                                                        if _e1204 {
                                                            phi_1347_ = ((_e1197 >> bitcast<u32>(21i)) | (_e1203 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1347_ = (_e1203 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1213 = phi_1347_;
                                                        let _e1220 = (_e262 == 1u);
                                                        if _e1220 {
                                                            phi_1367_ = ((_e1197 >> bitcast<u32>(21i)) | (_e1203 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1367_ = (_e1203 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1229 = phi_1367_;
                                                        let _e1236 = (_e264 == 1u);
                                                        if _e1236 {
                                                            phi_1387_ = ((_e1197 >> bitcast<u32>(21i)) | (_e1203 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1387_ = (_e1203 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1245 = phi_1387_;
                                                        let _e1253 = (_e1104 + 2u);
                                                        let _e1254 = (_e1253 < _e95);
                                                        if _e1254 {
                                                            if _e1254 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1256 = global_5.member[_e1253];
                                                            phi_1413_ = _e1256;
                                                        } else {
                                                            phi_1413_ = 0u;
                                                        }
                                                        let _e1258 = phi_1413_;
                                                        let _e1259 = (_e1104 + 3u);
                                                        let _e1260 = (_e1259 < _e95);
                                                        if _e1260 {
                                                            if _e1260 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1262 = global_5.member[_e1259];
                                                            phi_1428_ = _e1262;
                                                        } else {
                                                            phi_1428_ = 0u;
                                                        }
                                                        let _e1264 = phi_1428_;
                                                        if _e1204 {
                                                            phi_1438_ = ((_e1258 >> bitcast<u32>(21i)) | (_e1264 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1438_ = (_e1264 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1273 = phi_1438_;
                                                        if _e1220 {
                                                            phi_1458_ = ((_e1258 >> bitcast<u32>(21i)) | (_e1264 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1458_ = (_e1264 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1288 = phi_1458_;
                                                        if _e1236 {
                                                            phi_1478_ = ((_e1258 >> bitcast<u32>(21i)) | (_e1264 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1478_ = (_e1264 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1303 = phi_1478_;
                                                        let _e1311 = (_e1104 + 4u);
                                                        let _e1312 = (_e1311 < _e95);
                                                        if _e1312 {
                                                            if _e1312 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1314 = global_5.member[_e1311];
                                                            phi_1504_ = _e1314;
                                                        } else {
                                                            phi_1504_ = 0u;
                                                        }
                                                        let _e1316 = phi_1504_;
                                                        let _e1317 = (_e1104 + 5u);
                                                        let _e1318 = (_e1317 < _e95);
                                                        if _e1318 {
                                                            if _e1318 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1320 = global_5.member[_e1317];
                                                            phi_1519_ = _e1320;
                                                        } else {
                                                            phi_1519_ = 0u;
                                                        }
                                                        let _e1322 = phi_1519_;
                                                        if _e1204 {
                                                            phi_1529_ = ((_e1316 >> bitcast<u32>(21i)) | (_e1322 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1529_ = (_e1322 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1331 = phi_1529_;
                                                        if _e1220 {
                                                            phi_1549_ = ((_e1316 >> bitcast<u32>(21i)) | (_e1322 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1549_ = (_e1322 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1346 = phi_1549_;
                                                        if _e1236 {
                                                            phi_1569_ = ((_e1316 >> bitcast<u32>(21i)) | (_e1322 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1569_ = (_e1322 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1361 = phi_1569_;
                                                        phi_1750_ = array<array<f32, 3>, 3>(array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>((select(_e1213, _e1197, _e302) & 2097151u))) * _e143)), (_e544.member.member.y + (f32(bitcast<i32>((select(_e1229, _e1197, _e341) & 2097151u))) * _e143)), (_e544.member.member.z + (f32(bitcast<i32>((select(_e1245, _e1197, _e379) & 2097151u))) * _e143))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>((select(_e1273, _e1258, _e302) & 2097151u))) * _e143)), (_e544.member.member.y + (f32(bitcast<i32>((select(_e1288, _e1258, _e341) & 2097151u))) * _e143)), (_e544.member.member.z + (f32(bitcast<i32>((select(_e1303, _e1258, _e379) & 2097151u))) * _e143))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>((select(_e1331, _e1316, _e302) & 2097151u))) * _e143)), (_e544.member.member.y + (f32(bitcast<i32>((select(_e1346, _e1316, _e341) & 2097151u))) * _e143)), (_e544.member.member.z + (f32(bitcast<i32>((select(_e1361, _e1316, _e379) & 2097151u))) * _e143))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1106 = (_e1104 + _e263);
                                                        let _e1107 = (_e1106 < _e95);
                                                        if _e1107 {
                                                            if _e1107 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1109 = global_5.member[_e1106];
                                                            phi_1596_ = _e1109;
                                                        } else {
                                                            phi_1596_ = 0u;
                                                        }
                                                        let _e1111 = phi_1596_;
                                                        let _e1115 = (_e1104 + _e262);
                                                        let _e1116 = (_e1115 < _e95);
                                                        if _e1116 {
                                                            if _e1116 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1118 = global_5.member[_e1115];
                                                            phi_1614_ = _e1118;
                                                        } else {
                                                            phi_1614_ = 0u;
                                                        }
                                                        let _e1120 = phi_1614_;
                                                        let _e1124 = (_e1104 + _e264);
                                                        let _e1125 = (_e1124 < _e95);
                                                        if _e1125 {
                                                            if _e1125 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1127 = global_5.member[_e1124];
                                                            phi_1632_ = _e1127;
                                                        } else {
                                                            phi_1632_ = 0u;
                                                        }
                                                        let _e1129 = phi_1632_;
                                                        let _e1134 = (_e1104 + 3u);
                                                        let _e1135 = (_e1134 + _e263);
                                                        let _e1136 = (_e1135 < _e95);
                                                        if _e1136 {
                                                            if _e1136 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1138 = global_5.member[_e1135];
                                                            phi_1652_ = _e1138;
                                                        } else {
                                                            phi_1652_ = 0u;
                                                        }
                                                        let _e1140 = phi_1652_;
                                                        let _e1144 = (_e1134 + _e262);
                                                        let _e1145 = (_e1144 < _e95);
                                                        if _e1145 {
                                                            if _e1145 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1147 = global_5.member[_e1144];
                                                            phi_1670_ = _e1147;
                                                        } else {
                                                            phi_1670_ = 0u;
                                                        }
                                                        let _e1149 = phi_1670_;
                                                        let _e1153 = (_e1134 + _e264);
                                                        let _e1154 = (_e1153 < _e95);
                                                        if _e1154 {
                                                            if _e1154 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1156 = global_5.member[_e1153];
                                                            phi_1688_ = _e1156;
                                                        } else {
                                                            phi_1688_ = 0u;
                                                        }
                                                        let _e1158 = phi_1688_;
                                                        let _e1163 = (_e1104 + 6u);
                                                        let _e1164 = (_e1163 + _e263);
                                                        let _e1165 = (_e1164 < _e95);
                                                        if _e1165 {
                                                            if _e1165 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1167 = global_5.member[_e1164];
                                                            phi_1708_ = _e1167;
                                                        } else {
                                                            phi_1708_ = 0u;
                                                        }
                                                        let _e1169 = phi_1708_;
                                                        let _e1173 = (_e1163 + _e262);
                                                        let _e1174 = (_e1173 < _e95);
                                                        if _e1174 {
                                                            if _e1174 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1176 = global_5.member[_e1173];
                                                            phi_1726_ = _e1176;
                                                        } else {
                                                            phi_1726_ = 0u;
                                                        }
                                                        let _e1178 = phi_1726_;
                                                        let _e1182 = (_e1163 + _e264);
                                                        let _e1183 = (_e1182 < _e95);
                                                        if _e1183 {
                                                            if _e1183 {
                                                            } else {
                                                                phi_4474_ = _e1032;
                                                                phi_4327_ = true;
                                                                break;
                                                            }
                                                            let _e1185 = global_5.member[_e1182];
                                                            phi_1744_ = _e1185;
                                                        } else {
                                                            phi_1744_ = 0u;
                                                        }
                                                        let _e1187 = phi_1744_;
                                                        phi_1750_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1111)) * _e143), (f32(bitcast<i32>(_e1120)) * _e143), (f32(bitcast<i32>(_e1129)) * _e143)), array<f32, 3>((f32(bitcast<i32>(_e1140)) * _e143), (f32(bitcast<i32>(_e1149)) * _e143), (f32(bitcast<i32>(_e1158)) * _e143)), array<f32, 3>((f32(bitcast<i32>(_e1169)) * _e143), (f32(bitcast<i32>(_e1178)) * _e143), (f32(bitcast<i32>(_e1187)) * _e143)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1750_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1461 = phi_1750_;
                                                let _e1468 = (_e1461[0][2] - _e389);
                                                let _e1471 = (((_e1461[0][0] - _e312) * _e413) - (_e1468 * _e337));
                                                let _e1474 = (((_e1461[0][1] - _e351) * _e413) - (_e1468 * _e375));
                                                let _e1481 = (_e1461[1][2] - _e389);
                                                let _e1484 = (((_e1461[1][0] - _e312) * _e413) - (_e1481 * _e337));
                                                let _e1487 = (((_e1461[1][1] - _e351) * _e413) - (_e1481 * _e375));
                                                let _e1494 = (_e1461[2][2] - _e389);
                                                let _e1497 = (((_e1461[2][0] - _e312) * _e413) - (_e1494 * _e337));
                                                let _e1500 = (((_e1461[2][1] - _e351) * _e413) - (_e1494 * _e375));
                                                let _e1501 = (_e1497 * _e1487);
                                                let _e1502 = (_e1500 * _e1484);
                                                let _e1503 = (_e1471 * _e1500);
                                                let _e1504 = (_e1474 * _e1497);
                                                let _e1505 = (_e1484 * _e1474);
                                                let _e1506 = (_e1487 * _e1471);
                                                let _e1511 = (((_e1501 >= _e1502) && (_e1503 >= _e1504)) && (_e1505 >= _e1506));
                                                if (_e1511 || (((_e1501 <= _e1502) && (_e1503 <= _e1504)) && (_e1505 <= _e1506))) {
                                                    let _e1518 = select(-1f, 1f, _e1511);
                                                    let _e1520 = ((_e1501 - _e1502) * _e1518);
                                                    let _e1522 = select(0f, _e1520, (_e1520 > 0f));
                                                    let _e1524 = ((_e1503 - _e1504) * _e1518);
                                                    let _e1526 = select(0f, _e1524, (_e1524 > 0f));
                                                    let _e1528 = ((_e1505 - _e1506) * _e1518);
                                                    let _e1530 = select(0f, _e1528, (_e1528 > 0f));
                                                    let _e1532 = ((_e1522 + _e1526) + _e1530);
                                                    if (_e1532 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2317_ = type_20();
                                                        phi_2318_ = true;
                                                    } else {
                                                        let _e1535 = select(_e1461[1][0], _e1461[0][0], (_e1461[0][0] < _e1461[1][0]));
                                                        let _e1539 = select(_e1461[1][0], _e1461[0][0], (_e1461[0][0] > _e1461[1][0]));
                                                        let _e1543 = select(_e1461[1][1], _e1461[0][1], (_e1461[0][1] < _e1461[1][1]));
                                                        let _e1547 = select(_e1461[1][1], _e1461[0][1], (_e1461[0][1] > _e1461[1][1]));
                                                        let _e1551 = select(_e1461[1][2], _e1461[0][2], (_e1461[0][2] < _e1461[1][2]));
                                                        let _e1555 = select(_e1461[1][2], _e1461[0][2], (_e1461[0][2] > _e1461[1][2]));
                                                        let _e1560 = ((select(_e1461[2][0], _e1535, (_e1535 < _e1461[2][0])) - _e335) * _e340);
                                                        let _e1561 = ((select(_e1461[2][0], _e1539, (_e1539 > _e1461[2][0])) - _e336) * _e340);
                                                        let _e1564 = ((select(_e1461[2][1], _e1543, (_e1543 < _e1461[2][1])) - _e373) * _e378);
                                                        let _e1565 = ((select(_e1461[2][1], _e1547, (_e1547 > _e1461[2][1])) - _e374) * _e378);
                                                        let _e1568 = ((select(_e1461[2][2], _e1551, (_e1551 < _e1461[2][2])) - _e411) * _e416);
                                                        let _e1569 = ((select(_e1461[2][2], _e1555, (_e1555 > _e1461[2][2])) - _e412) * _e416);
                                                        let _e1571 = select(_e1569, _e1568, (_e1568 < _e1569));
                                                        let _e1573 = select(_e1569, _e1568, (_e1568 > _e1569));
                                                        let _e1575 = select(_e1561, _e1560, (_e1560 < _e1561));
                                                        let _e1577 = select(_e1565, _e1564, (_e1564 < _e1565));
                                                        let _e1579 = select(_e1577, _e1575, (_e1575 > _e1577));
                                                        let _e1581 = select(_e1571, _e1579, (_e1579 > _e1571));
                                                        let _e1583 = select(_e1561, _e1560, (_e1560 > _e1561));
                                                        let _e1585 = select(_e1565, _e1564, (_e1564 > _e1565));
                                                        let _e1587 = select(_e1585, _e1583, (_e1583 < _e1585));
                                                        let _e1589 = select(_e1573, _e1587, (_e1587 < _e1573));
                                                        let _e1590 = -(_e1571);
                                                        let _e1596 = select(_e463, _e1581, (_e1581 > _e463));
                                                        if (_e1596 > (_e1589 + (select(_e1590, _e1573, (_e1573 > _e1590)) * 0.0000019073523f))) {
                                                            phi_2312_ = type_20();
                                                            phi_2313_ = true;
                                                        } else {
                                                            let _e1598 = (_e1596 > _e1032);
                                                            if _e1598 {
                                                                phi_2311_ = type_20();
                                                            } else {
                                                                let _e1602 = (_e1461[1][0] - _e1461[0][0]);
                                                                let _e1603 = (_e1461[1][1] - _e1461[0][1]);
                                                                let _e1604 = (_e1461[1][2] - _e1461[0][2]);
                                                                let _e1605 = vec3<f32>(_e1602, _e1603, _e1604);
                                                                let _e1606 = (_e1461[2][0] - _e1461[1][0]);
                                                                let _e1607 = (_e1461[2][1] - _e1461[1][1]);
                                                                let _e1608 = (_e1461[2][2] - _e1461[1][2]);
                                                                let _e1609 = vec3<f32>(_e1606, _e1607, _e1608);
                                                                let _e1610 = (_e1461[0][0] - _e1461[2][0]);
                                                                let _e1611 = (_e1461[0][1] - _e1461[2][1]);
                                                                let _e1612 = (_e1461[0][2] - _e1461[2][2]);
                                                                let _e1613 = vec3<f32>(_e1610, _e1611, _e1612);
                                                                let _e1616 = bitcast<f32>((bitcast<u32>(_e1602) & 2147483647u));
                                                                let _e1619 = bitcast<f32>((bitcast<u32>(_e1603) & 2147483647u));
                                                                let _e1621 = select(_e1619, _e1616, (_e1616 > _e1619));
                                                                let _e1624 = bitcast<f32>((bitcast<u32>(_e1604) & 2147483647u));
                                                                let _e1626 = select(_e1624, _e1621, (_e1621 > _e1624));
                                                                let _e1629 = bitcast<f32>((bitcast<u32>(_e1606) & 2147483647u));
                                                                let _e1632 = bitcast<f32>((bitcast<u32>(_e1607) & 2147483647u));
                                                                let _e1634 = select(_e1632, _e1629, (_e1629 > _e1632));
                                                                let _e1637 = bitcast<f32>((bitcast<u32>(_e1608) & 2147483647u));
                                                                let _e1639 = select(_e1637, _e1634, (_e1634 > _e1637));
                                                                let _e1642 = bitcast<f32>((bitcast<u32>(_e1610) & 2147483647u));
                                                                let _e1645 = bitcast<f32>((bitcast<u32>(_e1611) & 2147483647u));
                                                                let _e1647 = select(_e1645, _e1642, (_e1642 > _e1645));
                                                                let _e1650 = bitcast<f32>((bitcast<u32>(_e1612) & 2147483647u));
                                                                let _e1652 = select(_e1650, _e1647, (_e1647 > _e1650));
                                                                let _e1654 = select(_e1639, _e1626, (_e1626 > _e1639));
                                                                let _e1656 = select(_e1652, _e1654, (_e1654 > _e1652));
                                                                if (_e1626 == _e1656) {
                                                                    phi_2222_ = _e1609;
                                                                    phi_2223_ = _e1613;
                                                                } else {
                                                                    let _e1659 = vec3((_e1639 == _e1656));
                                                                    phi_2222_ = select(_e1605, _e1613, _e1659);
                                                                    phi_2223_ = select(_e1609, _e1605, _e1659);
                                                                }
                                                                let _e1663 = phi_2222_;
                                                                let _e1665 = phi_2223_;
                                                                let _e1672 = ((_e1663.y * _e1665.z) - (_e1665.y * _e1663.z));
                                                                let _e1677 = ((_e1663.z * _e1665.x) - (_e1665.z * _e1663.x));
                                                                let _e1680 = ((_e1663.x * _e1665.y) - (_e1665.x * _e1663.y));
                                                                if (_e1522 >= _e1526) {
                                                                    phi_2254_ = select(true, false, (_e1522 >= _e1530));
                                                                } else {
                                                                    phi_2254_ = true;
                                                                }
                                                                let _e1685 = phi_2254_;
                                                                if _e1685 {
                                                                    phi_2263_ = select(vec3<f32>(_e1461[2][0], _e1461[2][1], _e1461[2][2]), vec3<f32>(_e1461[1][0], _e1461[1][1], _e1461[1][2]), vec3((_e1526 >= _e1530)));
                                                                } else {
                                                                    phi_2263_ = vec3<f32>(_e1461[0][0], _e1461[0][1], _e1461[0][2]);
                                                                }
                                                                let _e1690 = phi_2263_;
                                                                let _e1707 = ((((_e1672 * (_e1690.x - _e312)) + (_e1677 * (_e1690.y - _e351))) + (_e1680 * (_e1690.z - _e389))) / (((_e1672 * _e337) + (_e1677 * _e375)) + (_e1680 * _e413)));
                                                                let _e1709 = select(_e1589, _e1707, (_e1707 < _e1589));
                                                                let _e1711 = select(_e1581, _e1709, (_e1709 > _e1581));
                                                                if (_e1711 >= _e463) {
                                                                    let _e1713 = (_e1711 <= _e1032);
                                                                    if _e1713 {
                                                                        let _e1714 = (1f / _e1532);
                                                                        phi_2303_ = type_20(_e1711, (_e1526 * _e1714), (_e1530 * _e1714), _e1092);
                                                                    } else {
                                                                        phi_2303_ = type_20();
                                                                    }
                                                                    let _e1719 = phi_2303_;
                                                                    phi_2305_ = _e1719;
                                                                    phi_2306_ = select(true, false, _e1713);
                                                                } else {
                                                                    phi_2305_ = type_20();
                                                                    phi_2306_ = true;
                                                                }
                                                                let _e1722 = phi_2305_;
                                                                let _e1724 = phi_2306_;
                                                                if _e1724 {
                                                                    phi_2310_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2310_ = _e1722;
                                                                }
                                                                let _e1726 = phi_2310_;
                                                                phi_2311_ = _e1726;
                                                            }
                                                            let _e1728 = phi_2311_;
                                                            phi_2312_ = _e1728;
                                                            phi_2313_ = _e1598;
                                                        }
                                                        let _e1730 = phi_2312_;
                                                        let _e1732 = phi_2313_;
                                                        phi_2317_ = _e1730;
                                                        phi_2318_ = _e1732;
                                                    }
                                                    let _e1734 = phi_2317_;
                                                    let _e1736 = phi_2318_;
                                                    phi_2322_ = _e1734;
                                                    phi_2323_ = _e1736;
                                                } else {
                                                    phi_2322_ = type_20();
                                                    phi_2323_ = true;
                                                }
                                                let _e1738 = phi_2322_;
                                                let _e1740 = phi_2323_;
                                                if _e1740 {
                                                    phi_2327_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2327_ = _e1738;
                                                }
                                                let _e1742 = phi_2327_;
                                                if (_e1742.member_3 != 4294967295u) {
                                                    if (_e1092 != 4294967295u) {
                                                        phi_2339_ = type_8(0u, 8u);
                                                        phi_2342_ = _e1742;
                                                        loop {
                                                            let _e1747 = phi_2339_;
                                                            let _e1749 = phi_2342_;
                                                            if (_e1747.member < _e1747.member_1) {
                                                                phi_2340_ = type_8((_e1747.member + 1u), _e1747.member_1);
                                                                phi_2365_ = type_8(1u, _e1747.member);
                                                            } else {
                                                                phi_2340_ = _e1747;
                                                                phi_2365_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1762 = phi_2340_;
                                                            let _e1764 = phi_2365_;
                                                            let _e1768 = (bitcast<i32>(_e1764.member) != 0i);
                                                            if _e1768 {
                                                                let _e1769 = (_e1764.member_1 < 8u);
                                                                if _e1769 {
                                                                } else {
                                                                    phi_4166_ = true;
                                                                    break;
                                                                }
                                                                let _e1774 = local_9[_e1764.member_1].member;
                                                                if (_e1749.member < _e1774) {
                                                                    phi_2398_ = true;
                                                                } else {
                                                                    let _e1776 = local_9[_e1764.member_1].member;
                                                                    if (_e1749.member == _e1776) {
                                                                        let _e1781 = local_9[_e1764.member_1].member_3;
                                                                        phi_2397_ = (_e1749.member_3 < _e1781);
                                                                    } else {
                                                                        phi_2397_ = false;
                                                                    }
                                                                    let _e1784 = phi_2397_;
                                                                    phi_2398_ = _e1784;
                                                                }
                                                                let _e1786 = phi_2398_;
                                                                if _e1786 {
                                                                    if _e1769 {
                                                                    } else {
                                                                        phi_4166_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1787 = local_9[_e1764.member_1];
                                                                    local_9[_e1764.member_1] = type_20(_e1749.member, _e1749.member_1, _e1749.member_2, _e1749.member_3);
                                                                    phi_2419_ = type_20(_e1787.member, _e1787.member_1, _e1787.member_2, _e1787.member_3);
                                                                } else {
                                                                    phi_2419_ = _e1749;
                                                                }
                                                                let _e1798 = phi_2419_;
                                                                phi_2343_ = _e1798;
                                                            } else {
                                                                phi_2343_ = type_20();
                                                            }
                                                            let _e1800 = phi_2343_;
                                                            continue;
                                                            continuing {
                                                                phi_2339_ = _e1762;
                                                                phi_2342_ = _e1800;
                                                                phi_4166_ = _e1030;
                                                                break if !(_e1768);
                                                            }
                                                        }
                                                        let _e1803 = phi_4166_;
                                                        phi_4474_ = _e1032;
                                                        phi_4327_ = _e1803;
                                                        if _e1803 {
                                                            break;
                                                        }
                                                        let _e1806 = local_9[7u].member_3;
                                                        if (_e1806 != 4294967295u) {
                                                            let _e1810 = local_9[7u].member;
                                                            phi_4537_ = _e1810;
                                                        } else {
                                                            phi_4537_ = _e1032;
                                                        }
                                                        let _e1812 = phi_4537_;
                                                        phi_4536_ = _e1812;
                                                        phi_4330_ = _e1803;
                                                    } else {
                                                        phi_4536_ = _e1032;
                                                        phi_4330_ = _e1030;
                                                    }
                                                    let _e1814 = phi_4536_;
                                                    let _e1816 = phi_4330_;
                                                    phi_4535_ = _e1814;
                                                    phi_4329_ = _e1816;
                                                } else {
                                                    phi_4535_ = _e1032;
                                                    phi_4329_ = _e1030;
                                                }
                                                let _e1818 = phi_4535_;
                                                let _e1820 = phi_4329_;
                                                phi_4534_ = _e1818;
                                                phi_4328_ = _e1820;
                                            } else {
                                                phi_4534_ = _e1032;
                                                phi_4328_ = _e1030;
                                            }
                                            let _e1822 = phi_4534_;
                                            let _e1824 = phi_4328_;
                                            continue;
                                            continuing {
                                                phi_4195_ = _e1824;
                                                phi_4138_ = _e1822;
                                                phi_1033_ = _e1047;
                                                phi_4474_ = _e1822;
                                                phi_4327_ = _e1824;
                                                break if !(_e1053);
                                            }
                                        }
                                        let _e1827 = phi_4474_;
                                        let _e1829 = phi_4327_;
                                        phi_4332_ = _e1829;
                                        if _e1829 {
                                            break;
                                        }
                                        phi_4439_ = _e1827;
                                        phi_4336_ = _e1829;
                                        phi_3671_ = _e544;
                                        phi_3672_ = false;
                                        phi_3673_ = _e548;
                                    } else {
                                        if (_e544.member_1 >= _e92) {
                                            phi_3226_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e544.member_1 < _e92) {
                                            } else {
                                                phi_4332_ = true;
                                                break;
                                            }
                                            let _e560 = (_e263 * 2u);
                                            let _e562 = ((1u + _e560) % 7u);
                                            if (_e562 < 7u) {
                                            } else {
                                                phi_4332_ = true;
                                                break;
                                            }
                                            let _e567 = global_4.member[_e544.member_1][_e562];
                                            let _e569 = ((_e560 + 2u) % 7u);
                                            if (_e569 < 7u) {
                                            } else {
                                                phi_4332_ = true;
                                                break;
                                            }
                                            let _e574 = global_4.member[_e544.member_1][_e569];
                                            let _e575 = (_e262 * 2u);
                                            let _e577 = ((1u + _e575) % 7u);
                                            if (_e577 < 7u) {
                                            } else {
                                                phi_4332_ = true;
                                                break;
                                            }
                                            let _e582 = global_4.member[_e544.member_1][_e577];
                                            let _e584 = ((_e575 + 2u) % 7u);
                                            if (_e584 < 7u) {
                                            } else {
                                                phi_4332_ = true;
                                                break;
                                            }
                                            let _e589 = global_4.member[_e544.member_1][_e584];
                                            let _e590 = (_e264 * 2u);
                                            let _e592 = ((1u + _e590) % 7u);
                                            if (_e592 < 7u) {
                                            } else {
                                                phi_4332_ = true;
                                                break;
                                            }
                                            let _e597 = global_4.member[_e544.member_1][_e592];
                                            let _e599 = ((_e590 + 2u) % 7u);
                                            if (_e599 < 7u) {
                                            } else {
                                                phi_4332_ = true;
                                                break;
                                            }
                                            let _e604 = global_4.member[_e544.member_1][_e599];
                                            let _e627 = (bitcast<f32>((bitcast<u32>((_e544.member.member_1.x - _e544.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e628 = (bitcast<f32>((bitcast<u32>((_e544.member.member_1.y - _e544.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e629 = (bitcast<f32>((bitcast<u32>((_e544.member.member_1.z - _e544.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e631 = select(_e143, _e627, (_e627 > _e143));
                                            let _e633 = select(_e143, _e628, (_e628 > _e143));
                                            let _e635 = select(_e143, _e629, (_e629 > _e143));
                                            let _e660 = bitcast<u32>((f32(bitcast<i32>((_e567 & 2097151u))) * _e631));
                                            let _e665 = (bitcast<i32>((_e567 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e668 = bitcast<f32>((_e660 & bitcast<u32>(_e665)));
                                            let _e669 = bitcast<u32>((f32(bitcast<i32>((_e582 & 2097151u))) * _e633));
                                            let _e674 = (bitcast<i32>((_e582 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e677 = bitcast<f32>((_e669 & bitcast<u32>(_e674)));
                                            let _e678 = bitcast<u32>((f32(bitcast<i32>((_e597 & 2097151u))) * _e635));
                                            let _e683 = (bitcast<i32>((_e597 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e686 = bitcast<f32>((_e678 & bitcast<u32>(_e683)));
                                            let _e690 = bitcast<f32>((_e660 & bitcast<u32>(~(_e665))));
                                            let _e694 = bitcast<f32>((_e669 & bitcast<u32>(~(_e674))));
                                            let _e698 = bitcast<f32>((_e678 & bitcast<u32>(~(_e683))));
                                            let _e699 = bitcast<u32>((f32(bitcast<i32>((_e574 & 2097151u))) * _e631));
                                            let _e704 = (bitcast<i32>((_e574 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e707 = bitcast<f32>((_e699 & bitcast<u32>(_e704)));
                                            let _e708 = bitcast<u32>((f32(bitcast<i32>((_e589 & 2097151u))) * _e633));
                                            let _e713 = (bitcast<i32>((_e589 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e716 = bitcast<f32>((_e708 & bitcast<u32>(_e713)));
                                            let _e717 = bitcast<u32>((f32(bitcast<i32>((_e604 & 2097151u))) * _e635));
                                            let _e722 = (bitcast<i32>((_e604 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e725 = bitcast<f32>((_e717 & bitcast<u32>(_e722)));
                                            let _e729 = bitcast<f32>((_e699 & bitcast<u32>(~(_e704))));
                                            let _e733 = bitcast<f32>((_e708 & bitcast<u32>(~(_e713))));
                                            let _e737 = bitcast<f32>((_e717 & bitcast<u32>(~(_e722))));
                                            let _e738 = (_e544.member.member.x + _e668);
                                            let _e739 = (_e544.member.member.y + _e677);
                                            let _e740 = (_e544.member.member.z + _e686);
                                            let _e743 = (_e544.member.member_1.x - _e707);
                                            let _e744 = (_e544.member.member_1.y - _e716);
                                            let _e745 = (_e544.member.member_1.z - _e725);
                                            let _e764 = (_e743 - _e738);
                                            let _e765 = (_e744 - _e739);
                                            let _e766 = (_e745 - _e740);
                                            let _e768 = select(_e765, _e764, (_e764 > _e765));
                                            let _e770 = select(_e766, _e768, (_e768 > _e766));
                                            if (_e770 < (1024f * _e143)) {
                                                phi_2927_ = 0u;
                                            } else {
                                                phi_2927_ = select(2u, 1u, (_e770 < (2097152f * _e143)));
                                            }
                                            let _e777 = phi_2927_;
                                            switch bitcast<i32>(_e777) {
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
                                            let _e780 = phi_2933_;
                                            let _e786 = global_4.member[_e544.member_1][0u];
                                            let _e790 = global_4.member[_e544.member_1][2u];
                                            let _e794 = global_4.member[_e544.member_1][4u];
                                            let _e798 = global_4.member[_e544.member_1][6u];
                                            let _e810 = (((_e790 >> bitcast<u32>(22i)) | ((_e794 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e798 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e811 = (_e786 & 268435455u);
                                            let _e812 = (_e810 & 268435455u);
                                            let _e815 = ((_e786 >> bitcast<u32>(28u)) & 7u);
                                            let _e823 = ((_e786 >> bitcast<u32>(31i)) | (((_e810 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e824 = (_e815 != 0u);
                                            if (_e815 == 0u) {
                                                phi_3188_ = _e811;
                                            } else {
                                                if (_e815 == 7u) {
                                                    phi_3187_ = 2147483648u;
                                                } else {
                                                    phi_3187_ = ((2147483648u | (_e815 << bitcast<u32>(28u))) | (_e812 & 268435455u));
                                                }
                                                let _e833 = phi_3187_;
                                                phi_3188_ = _e833;
                                            }
                                            let _e835 = phi_3188_;
                                            if _e824 {
                                                let _e836 = (_e815 != 7u);
                                                if _e836 {
                                                    phi_3198_ = (_e812 + (_e815 * ((3u * _e780) + 1u)));
                                                } else {
                                                    phi_3198_ = u32();
                                                }
                                                let _e840 = phi_3198_;
                                                phi_3200_ = _e840;
                                                phi_3201_ = select(true, false, _e836);
                                            } else {
                                                phi_3200_ = u32();
                                                phi_3201_ = true;
                                            }
                                            let _e843 = phi_3200_;
                                            let _e845 = phi_3201_;
                                            if (_e823 == 0u) {
                                                phi_3222_ = (_e811 + select(0u, 1u, !(_e824)));
                                            } else {
                                                if (_e823 == 7u) {
                                                    phi_3221_ = 2147483648u;
                                                } else {
                                                    phi_3221_ = ((2147483648u | (_e823 << bitcast<u32>(28u))) | (select(_e843, _e812, _e845) & 268435455u));
                                                }
                                                let _e858 = phi_3221_;
                                                phi_3222_ = _e858;
                                            }
                                            let _e860 = phi_3222_;
                                            phi_3226_ = type_52(array<vec4<f32>, 3>(vec4<f32>(_e738, (_e544.member.member.x + _e690), _e743, (_e544.member.member_1.x - _e729)), vec4<f32>(_e739, (_e544.member.member.y + _e694), _e744, (_e544.member.member_1.y - _e733)), vec4<f32>(_e740, (_e544.member.member.z + _e698), _e745, (_e544.member.member_1.z - _e737))), type_51(type_24((_e544.member.member + vec4<f32>(_e668, _e677, _e686, 0f)), (_e544.member.member_1 - vec4<f32>(_e707, _e716, _e725, 0f))), _e835), type_51(type_24((_e544.member.member + vec4<f32>(_e690, _e694, _e698, 0f)), (_e544.member.member_1 - vec4<f32>(_e729, _e733, _e737, 0f))), _e860));
                                        }
                                        let _e865 = phi_3226_;
                                        let _e876 = ((_e865.member[0].x - _e335) * _e340);
                                        let _e877 = ((_e865.member[0].y - _e335) * _e340);
                                        let _e878 = ((_e865.member[0].z - _e336) * _e340);
                                        let _e879 = ((_e865.member[0].w - _e336) * _e340);
                                        let _e889 = ((_e865.member[1].x - _e373) * _e378);
                                        let _e890 = ((_e865.member[1].y - _e373) * _e378);
                                        let _e891 = ((_e865.member[1].z - _e374) * _e378);
                                        let _e892 = ((_e865.member[1].w - _e374) * _e378);
                                        let _e902 = ((_e865.member[2].x - _e411) * _e416);
                                        let _e903 = ((_e865.member[2].y - _e411) * _e416);
                                        let _e904 = ((_e865.member[2].z - _e412) * _e416);
                                        let _e905 = ((_e865.member[2].w - _e412) * _e416);
                                        let _e907 = select(_e904, _e902, (_e902 < _e904));
                                        let _e909 = select(_e905, _e903, (_e903 < _e905));
                                        let _e911 = select(_e904, _e902, (_e902 > _e904));
                                        let _e913 = select(_e905, _e903, (_e903 > _e905));
                                        let _e915 = select(_e878, _e876, (_e876 < _e878));
                                        let _e917 = select(_e879, _e877, (_e877 < _e879));
                                        let _e919 = select(_e891, _e889, (_e889 < _e891));
                                        let _e921 = select(_e892, _e890, (_e890 < _e892));
                                        let _e923 = select(_e919, _e915, (_e915 > _e919));
                                        let _e925 = select(_e921, _e917, (_e917 > _e921));
                                        let _e927 = select(_e907, _e923, (_e923 > _e907));
                                        let _e929 = select(_e909, _e925, (_e925 > _e909));
                                        let _e931 = select(_e878, _e876, (_e876 > _e878));
                                        let _e933 = select(_e879, _e877, (_e877 > _e879));
                                        let _e935 = select(_e891, _e889, (_e889 > _e891));
                                        let _e937 = select(_e892, _e890, (_e890 > _e892));
                                        let _e939 = select(_e935, _e931, (_e931 < _e935));
                                        let _e941 = select(_e937, _e933, (_e933 < _e937));
                                        let _e946 = -(_e907);
                                        let _e947 = -(_e909);
                                        let _e954 = (select(_e911, _e939, (_e939 < _e911)) + (select(_e946, _e911, (_e911 > _e946)) * 0.0000019073523f));
                                        let _e955 = (select(_e913, _e941, (_e941 < _e913)) + (select(_e947, _e913, (_e913 > _e947)) * 0.0000019073523f));
                                        let _e957 = select(_e463, _e927, (_e927 > _e463));
                                        let _e959 = select(_e463, _e929, (_e929 > _e463));
                                        let _e964 = (_e957 <= select(_e506, _e954, (_e954 < _e506)));
                                        let _e965 = (_e959 <= select(_e506, _e955, (_e955 < _e506)));
                                        let _e966 = (_e957 <= _e959);
                                        if _e964 {
                                            if _e965 {
                                                if _e966 {
                                                    phi_3571_ = _e865.member_2;
                                                } else {
                                                    phi_3571_ = _e865.member_1;
                                                }
                                                let _e970 = phi_3571_;
                                                let _e992 = (_e548 % 128u);
                                                let _e993 = (_e992 < 128u);
                                                if _e993 {
                                                } else {
                                                    phi_4332_ = true;
                                                    break;
                                                }
                                                local_8[_e992] = _e970.member_1;
                                                if _e993 {
                                                } else {
                                                    phi_4332_ = true;
                                                    break;
                                                }
                                                local_7[_e992] = _e970.member.member.x;
                                                if _e993 {
                                                } else {
                                                    phi_4332_ = true;
                                                    break;
                                                }
                                                local_6[_e992] = _e970.member.member.y;
                                                if _e993 {
                                                } else {
                                                    phi_4332_ = true;
                                                    break;
                                                }
                                                local_5[_e992] = _e970.member.member.z;
                                                if _e993 {
                                                } else {
                                                    phi_4332_ = true;
                                                    break;
                                                }
                                                local_4[_e992] = _e970.member.member_1.x;
                                                if _e993 {
                                                } else {
                                                    phi_4332_ = true;
                                                    break;
                                                }
                                                local_3[_e992] = _e970.member.member_1.y;
                                                if _e993 {
                                                } else {
                                                    phi_4332_ = true;
                                                    break;
                                                }
                                                local_2[_e992] = _e970.member.member_1.z;
                                                if _e993 {
                                                } else {
                                                    phi_4332_ = true;
                                                    break;
                                                }
                                                local_10[_e992] = select(_e959, _e957, (_e957 > _e959));
                                                if _e966 {
                                                    phi_3648_ = _e865.member_1;
                                                } else {
                                                    phi_3648_ = _e865.member_2;
                                                }
                                                let _e1006 = phi_3648_;
                                                phi_3649_ = _e1006;
                                                phi_3650_ = (_e548 + 1u);
                                            } else {
                                                phi_3649_ = type_51();
                                                phi_3650_ = u32();
                                            }
                                            let _e1008 = phi_3649_;
                                            let _e1010 = phi_3650_;
                                            phi_3652_ = _e1008;
                                            phi_3653_ = _e1010;
                                            phi_3654_ = select(true, false, _e965);
                                        } else {
                                            phi_3652_ = type_51();
                                            phi_3653_ = u32();
                                            phi_3654_ = true;
                                        }
                                        let _e1013 = phi_3652_;
                                        let _e1015 = phi_3653_;
                                        let _e1017 = phi_3654_;
                                        if _e1017 {
                                            if _e964 {
                                                phi_3663_ = _e865.member_1;
                                            } else {
                                                phi_3663_ = _e865.member_2;
                                            }
                                            let _e1021 = phi_3663_;
                                            phi_3668_ = _e1021;
                                            phi_3669_ = select(_e965, true, _e964);
                                        } else {
                                            phi_3668_ = _e1013;
                                            phi_3669_ = _e546;
                                        }
                                        let _e1024 = phi_3668_;
                                        let _e1026 = phi_3669_;
                                        phi_4439_ = _e506;
                                        phi_4336_ = _e504;
                                        phi_3671_ = _e1024;
                                        phi_3672_ = _e1026;
                                        phi_3673_ = select(_e1015, _e548, _e1017);
                                    }
                                    let _e1831 = phi_4439_;
                                    let _e1833 = phi_4336_;
                                    let _e1835 = phi_3671_;
                                    let _e1837 = phi_3672_;
                                    let _e1839 = phi_3673_;
                                    phi_4438_ = _e1831;
                                    phi_4335_ = _e1833;
                                    phi_3674_ = _e1835;
                                    phi_3675_ = (_e510 - 1u);
                                    phi_3676_ = _e1837;
                                    phi_3677_ = _e1839;
                                } else {
                                    phi_4438_ = _e506;
                                    phi_4335_ = _e504;
                                    phi_3674_ = _e544;
                                    phi_3675_ = _e510;
                                    phi_3676_ = _e546;
                                    phi_3677_ = _e548;
                                }
                                let _e1841 = phi_4438_;
                                let _e1843 = phi_4335_;
                                let _e1845 = phi_3674_;
                                let _e1847 = phi_3675_;
                                let _e1849 = phi_3676_;
                                let _e1851 = phi_3677_;
                                phi_4437_ = _e1841;
                                phi_4334_ = _e1843;
                                phi_3678_ = _e1845;
                                phi_3679_ = _e1847;
                                phi_3680_ = _e1849;
                                phi_3681_ = _e1851;
                            } else {
                                phi_4437_ = _e506;
                                phi_4334_ = _e504;
                                phi_3678_ = type_51();
                                phi_3679_ = u32();
                                phi_3680_ = bool();
                                phi_3681_ = u32();
                            }
                            let _e1853 = phi_4437_;
                            let _e1855 = phi_4334_;
                            let _e1857 = phi_3678_;
                            let _e1859 = phi_3679_;
                            let _e1861 = phi_3680_;
                            let _e1863 = phi_3681_;
                            phi_4436_ = _e1853;
                            phi_4333_ = _e1855;
                            phi_908_ = _e1857;
                            phi_911_ = _e1859;
                            phi_913_ = _e1861;
                            phi_915_ = _e1863;
                            phi_3682_ = _e518;
                        } else {
                            phi_4436_ = _e506;
                            phi_4333_ = _e504;
                            phi_908_ = type_51();
                            phi_911_ = u32();
                            phi_913_ = bool();
                            phi_915_ = u32();
                            phi_3682_ = false;
                        }
                        let _e1865 = phi_4436_;
                        let _e1867 = phi_4333_;
                        let _e1869 = phi_908_;
                        let _e1871 = phi_911_;
                        let _e1873 = phi_913_;
                        let _e1875 = phi_915_;
                        let _e1877 = phi_3682_;
                        continue;
                        continuing {
                            phi_4198_ = _e1867;
                            phi_4054_ = _e1865;
                            phi_907_ = _e1869;
                            phi_910_ = _e1871;
                            phi_912_ = _e1873;
                            phi_914_ = _e1875;
                            phi_4332_ = _e1867;
                            break if !(_e1877);
                        }
                    }
                    let _e1880 = phi_4332_;
                    if _e1880 {
                        break;
                    }
                    phi_3689_ = type_8(0u, 8u);
                    loop {
                        let _e1882 = phi_3689_;
                        if (_e1882.member < _e1882.member_1) {
                            phi_3690_ = type_8((_e1882.member + 1u), _e1882.member_1);
                            phi_3713_ = type_8(1u, _e1882.member);
                        } else {
                            phi_3690_ = _e1882;
                            phi_3713_ = type_8(0u, type_8().member_1);
                        }
                        let _e1895 = phi_3690_;
                        let _e1897 = phi_3713_;
                        let _e1901 = (bitcast<i32>(_e1897.member) != 0i);
                        if _e1901 {
                            let _e1902 = (_e1897.member_1 < 8u);
                            if _e1902 {
                            } else {
                                phi_4429_ = true;
                                break;
                            }
                            let _e1904 = local_9[_e1897.member_1];
                            if (_e1904.member_3 != 4294967295u) {
                                let _e1910 = -(_e430);
                                let _e1911 = (_e1910 / 3i);
                                let _e1918 = bitcast<f32>((bitcast<u32>((_e1911 + 127i)) << bitcast<u32>(23i)));
                                let _e1926 = (((_e1904.member * _e1918) * _e1918) * bitcast<f32>((bitcast<u32>(((_e1910 - (2i * _e1911)) + 127i)) << bitcast<u32>(23i))));
                                let _e1928 = select(340282350000000000000000000000000000000f, _e1926, (_e1926 < 340282350000000000000000000000000000000f));
                                phi_3779_ = type_20(select(-340282350000000000000000000000000000000f, _e1928, (_e1928 > -340282350000000000000000000000000000000f)), _e1904.member_1, _e1904.member_2, _e1904.member_3);
                            } else {
                                phi_3779_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1933 = phi_3779_;
                            if _e1902 {
                            } else {
                                phi_4429_ = true;
                                break;
                            }
                            local_9[_e1897.member_1] = type_20(_e1933.member, _e1933.member_1, _e1933.member_2, _e1933.member_3);
                        }
                        continue;
                        continuing {
                            phi_3689_ = _e1895;
                            phi_4429_ = _e1880;
                            break if !(_e1901);
                        }
                    }
                    let _e1941 = phi_4429_;
                    if _e1941 {
                        break;
                    }
                    let _e1942 = local_9;
                    if _e151 {
                    } else {
                        break;
                    }
                    global_6.member[_e149] = array<type_20, 8>(type_20(_e1942[0].member, _e1942[0].member_1, _e1942[0].member_2, _e1942[0].member_3), type_20(_e1942[1].member, _e1942[1].member_1, _e1942[1].member_2, _e1942[1].member_3), type_20(_e1942[2].member, _e1942[2].member_1, _e1942[2].member_2, _e1942[2].member_3), type_20(_e1942[3].member, _e1942[3].member_1, _e1942[3].member_2, _e1942[3].member_3), type_20(_e1942[4].member, _e1942[4].member_1, _e1942[4].member_2, _e1942[4].member_3), type_20(_e1942[5].member, _e1942[5].member_1, _e1942[5].member_2, _e1942[5].member_3), type_20(_e1942[6].member, _e1942[6].member_1, _e1942[6].member_2, _e1942[6].member_3), type_20(_e1942[7].member, _e1942[7].member_1, _e1942[7].member_2, _e1942[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
