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

struct type_34 {
    member: f32,
    member_1: bool,
}

struct type_36 {
    member: array<vec4<u32>, 2>,
}

struct type_40 {
    member: array<array<u32, 7>>,
}

struct type_49 {
    member: type_24,
    member_1: u32,
}

struct type_50 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_36;
@group(0) @binding(4) 
var<storage> global_3: type_32;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(2) 
var<storage> global_5: type_40;
@group(0) @binding(3) 
var<storage> global_6: type_4;

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
    var local_10: array<u32, 3>;
    var local_11: array<array<f32, 3>, 3>;
    var local_12: array<f32, 4>;
    var phi_396_: i32;
    var phi_397_: i32;
    var phi_407_: bool;
    var phi_417_: u32;
    var phi_418_: u32;
    var phi_420_: bool;
    var phi_425_: u32;
    var phi_438_: i32;
    var phi_458_: i32;
    var phi_476_: f32;
    var phi_482_: f32;
    var phi_493_: f32;
    var phi_499_: f32;
    var phi_522_: f32;
    var phi_533_: f32;
    var phi_542_: f32;
    var phi_548_: f32;
    var phi_559_: f32;
    var phi_565_: f32;
    var phi_588_: f32;
    var phi_599_: f32;
    var phi_608_: f32;
    var phi_614_: f32;
    var phi_625_: f32;
    var phi_631_: f32;
    var phi_654_: f32;
    var phi_665_: f32;
    var phi_765_: f32;
    var phi_766_: f32;
    var phi_3414_: bool;
    var phi_855_: type_34;
    var phi_858_: type_49;
    var phi_860_: u32;
    var phi_862_: bool;
    var phi_864_: u32;
    var phi_875_: bool;
    var phi_961_: type_49;
    var phi_962_: bool;
    var phi_963_: u32;
    var phi_2424_: u32;
    var phi_2430_: u32;
    var phi_2684_: u32;
    var phi_2685_: u32;
    var phi_2695_: u32;
    var phi_2697_: u32;
    var phi_2698_: bool;
    var phi_2718_: u32;
    var phi_2719_: u32;
    var phi_2723_: type_50;
    var phi_3067_: type_49;
    var phi_3144_: type_49;
    var phi_3145_: type_49;
    var phi_3146_: u32;
    var phi_3148_: type_49;
    var phi_3149_: u32;
    var phi_3150_: bool;
    var phi_3159_: type_49;
    var phi_3164_: type_49;
    var phi_3165_: bool;
    var phi_3411_: bool;
    var phi_982_: type_34;
    var phi_985_: type_8;
    var phi_986_: type_8;
    var phi_1008_: type_8;
    var phi_1049_: u32;
    var phi_1055_: u32;
    var phi_1065_: u32;
    var phi_1081_: u32;
    var phi_1118_: u32;
    var phi_1124_: u32;
    var phi_1134_: u32;
    var phi_3396_: bool;
    var phi_1150_: type_8;
    var phi_1151_: type_8;
    var phi_1174_: type_8;
    var phi_1197_: u32;
    var phi_1212_: u32;
    var phi_1215_: type_8;
    var phi_1216_: type_8;
    var phi_1239_: type_8;
    var phi_1305_: u32;
    var phi_1285_: u32;
    var phi_1286_: u32;
    var phi_1309_: f32;
    var phi_3389_: bool;
    var phi_3468_: bool;
    var phi_3467_: bool;
    var phi_1809_: vec3<f32>;
    var phi_1810_: vec3<f32>;
    var phi_1841_: bool;
    var phi_1850_: vec3<f32>;
    var phi_1890_: type_20;
    var phi_1892_: type_20;
    var phi_1893_: bool;
    var phi_1897_: type_20;
    var phi_1898_: type_20;
    var phi_1899_: type_20;
    var phi_1900_: bool;
    var phi_1904_: type_20;
    var phi_1905_: bool;
    var phi_1909_: type_20;
    var phi_1910_: bool;
    var phi_1914_: type_20;
    var phi_1925_: type_34;
    var phi_1926_: type_34;
    var phi_3470_: bool;
    var phi_983_: type_34;
    var phi_3469_: bool;
    var local_13: type_34;
    var phi_3529_: bool;
    var phi_3167_: type_34;
    var phi_3168_: type_49;
    var phi_3169_: bool;
    var phi_3170_: u32;
    var phi_3528_: bool;
    var phi_3171_: type_34;
    var phi_3172_: type_49;
    var phi_3173_: u32;
    var phi_3174_: bool;
    var phi_3175_: u32;
    var phi_3527_: bool;
    var phi_3176_: type_34;
    var phi_3177_: type_49;
    var phi_3178_: u32;
    var phi_3179_: bool;
    var phi_3180_: u32;
    var phi_3526_: bool;
    var phi_856_: type_34;
    var phi_859_: type_49;
    var phi_861_: u32;
    var phi_863_: bool;
    var phi_865_: u32;
    var phi_3181_: bool;
    var phi_3525_: bool;
    var local_14: type_34;
    var local_15: type_34;

    switch bitcast<i32>(0u) {
        default: {
            let _e90 = global;
            let _e92 = arrayLength((&global_5.member));
            let _e95 = arrayLength((&global_6.member));
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
                let _e151 = (_e149 < arrayLength((&global_4.member)));
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
                        phi_438_ = -126i;
                    } else {
                        phi_438_ = select(_e131, 127i, (_e131 > 127i));
                    }
                    let _e269 = phi_438_;
                    let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                    let _e280 = bitcast<f32>((bitcast<u32>(((_e131 - _e269) + 127i)) << bitcast<u32>(23i)));
                    let _e281 = -(_e244);
                    if (_e281 < -126i) {
                        phi_458_ = -126i;
                    } else {
                        phi_458_ = select(_e281, 127i, (_e281 > 127i));
                    }
                    let _e286 = phi_458_;
                    let _e291 = bitcast<f32>((bitcast<u32>((_e286 + 127i)) << bitcast<u32>(23i)));
                    let _e297 = bitcast<f32>((bitcast<u32>(((_e281 - _e286) + 127i)) << bitcast<u32>(23i)));
                    let _e301 = global_3.member[_e149].member;
                    let _e302 = (_e263 == 0u);
                    if _e302 {
                        phi_476_ = _e301[0];
                    } else {
                        phi_476_ = _e301[1];
                    }
                    let _e306 = phi_476_;
                    let _e307 = (_e263 == 2u);
                    if _e307 {
                        phi_482_ = _e301[2];
                    } else {
                        phi_482_ = _e306;
                    }
                    let _e310 = phi_482_;
                    let _e312 = ((_e310 * _e274) * _e280);
                    let _e313 = global_3.member[_e149].member_2;
                    if _e302 {
                        phi_493_ = _e313[0];
                    } else {
                        phi_493_ = _e313[1];
                    }
                    let _e317 = phi_493_;
                    if _e307 {
                        phi_499_ = _e313[2];
                    } else {
                        phi_499_ = _e317;
                    }
                    let _e320 = phi_499_;
                    let _e322 = ((_e320 * _e291) * _e297);
                    let _e326 = (bitcast<f32>((bitcast<u32>(_e322) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e326 {
                        let _e330 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) * 0.00000011920929f);
                        phi_522_ = select(0.00000000000011368684f, _e330, (_e330 > 0.00000000000011368684f));
                    } else {
                        phi_522_ = 0f;
                    }
                    let _e334 = phi_522_;
                    let _e335 = (_e312 + _e334);
                    let _e336 = (_e312 - _e334);
                    let _e337 = select(_e322, 0f, _e326);
                    if _e326 {
                        phi_533_ = 38685626000000000000000000f;
                    } else {
                        phi_533_ = (1f / _e322);
                    }
                    let _e340 = phi_533_;
                    let _e341 = (_e262 == 0u);
                    if _e341 {
                        phi_542_ = _e301[0];
                    } else {
                        phi_542_ = _e301[1];
                    }
                    let _e345 = phi_542_;
                    let _e346 = (_e262 == 2u);
                    if _e346 {
                        phi_548_ = _e301[2];
                    } else {
                        phi_548_ = _e345;
                    }
                    let _e349 = phi_548_;
                    let _e351 = ((_e349 * _e274) * _e280);
                    if _e341 {
                        phi_559_ = _e313[0];
                    } else {
                        phi_559_ = _e313[1];
                    }
                    let _e355 = phi_559_;
                    if _e346 {
                        phi_565_ = _e313[2];
                    } else {
                        phi_565_ = _e355;
                    }
                    let _e358 = phi_565_;
                    let _e360 = ((_e358 * _e291) * _e297);
                    let _e364 = (bitcast<f32>((bitcast<u32>(_e360) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e364 {
                        let _e368 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) * 0.00000011920929f);
                        phi_588_ = select(0.00000000000011368684f, _e368, (_e368 > 0.00000000000011368684f));
                    } else {
                        phi_588_ = 0f;
                    }
                    let _e372 = phi_588_;
                    let _e373 = (_e351 + _e372);
                    let _e374 = (_e351 - _e372);
                    let _e375 = select(_e360, 0f, _e364);
                    if _e364 {
                        phi_599_ = 38685626000000000000000000f;
                    } else {
                        phi_599_ = (1f / _e360);
                    }
                    let _e378 = phi_599_;
                    let _e379 = (_e264 == 0u);
                    if _e379 {
                        phi_608_ = _e301[0];
                    } else {
                        phi_608_ = _e301[1];
                    }
                    let _e383 = phi_608_;
                    let _e384 = (_e264 == 2u);
                    if _e384 {
                        phi_614_ = _e301[2];
                    } else {
                        phi_614_ = _e383;
                    }
                    let _e387 = phi_614_;
                    let _e389 = ((_e387 * _e274) * _e280);
                    if _e379 {
                        phi_625_ = _e313[0];
                    } else {
                        phi_625_ = _e313[1];
                    }
                    let _e393 = phi_625_;
                    if _e384 {
                        phi_631_ = _e313[2];
                    } else {
                        phi_631_ = _e393;
                    }
                    let _e396 = phi_631_;
                    let _e398 = ((_e396 * _e291) * _e297);
                    let _e402 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e402 {
                        let _e406 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) * 0.00000011920929f);
                        phi_654_ = select(0.00000000000011368684f, _e406, (_e406 > 0.00000000000011368684f));
                    } else {
                        phi_654_ = 0f;
                    }
                    let _e410 = phi_654_;
                    let _e411 = (_e389 + _e410);
                    let _e412 = (_e389 - _e410);
                    let _e413 = select(_e398, 0f, _e402);
                    if _e402 {
                        phi_665_ = 38685626000000000000000000f;
                    } else {
                        phi_665_ = (1f / _e398);
                    }
                    let _e416 = phi_665_;
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
                        phi_765_ = select(-340282350000000000000000000000000000000f, _e457, (_e457 > -340282350000000000000000000000000000000f));
                        phi_766_ = select(-340282350000000000000000000000000000000f, _e450, (_e450 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_765_ = 0f;
                        phi_766_ = 1f;
                    }
                    let _e461 = phi_765_;
                    let _e463 = phi_766_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e467 = (_e263 % 3u);
                    let _e468 = (_e467 < 3u);
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e470 = local_1[_e467];
                    let _e473 = (_e262 % 3u);
                    let _e474 = (_e473 < 3u);
                    if _e474 {
                    } else {
                        break;
                    }
                    let _e476 = local_1[_e473];
                    let _e479 = (_e264 % 3u);
                    let _e480 = (_e479 < 3u);
                    if _e480 {
                    } else {
                        break;
                    }
                    let _e482 = local_1[_e479];
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e487 = local[_e467];
                    if _e474 {
                    } else {
                        break;
                    }
                    let _e491 = local[_e473];
                    if _e480 {
                    } else {
                        break;
                    }
                    let _e495 = local[_e479];
                    phi_3414_ = false;
                    phi_855_ = type_34(_e461, false);
                    phi_858_ = type_49(type_24(vec4<f32>((f32(_e470) * _e143), (f32(_e476) * _e143), (f32(_e482) * _e143), 0f), vec4<f32>((f32(_e487) * _e143), (f32(_e491) * _e143), (f32(_e495) * _e143), 0f)), select(0u, 2147483648u, (_e92 == 0u)));
                    phi_860_ = ((3u * _e92) + 1u);
                    phi_862_ = (_e463 <= _e461);
                    phi_864_ = 0u;
                    loop {
                        let _e505 = phi_3414_;
                        let _e507 = phi_855_;
                        let _e509 = phi_858_;
                        let _e511 = phi_860_;
                        let _e513 = phi_862_;
                        let _e515 = phi_864_;
                        local_14 = _e507;
                        if _e513 {
                            phi_875_ = true;
                        } else {
                            phi_875_ = (_e515 > 0u);
                        }
                        let _e518 = phi_875_;
                        if _e518 {
                            let _e519 = (_e511 > 0u);
                            if _e519 {
                                if _e513 {
                                    phi_961_ = _e509;
                                    phi_962_ = _e513;
                                    phi_963_ = _e515;
                                } else {
                                    let _e520 = (_e515 - 1u);
                                    let _e521 = (_e520 % 128u);
                                    let _e522 = (_e521 < 128u);
                                    if _e522 {
                                    } else {
                                        phi_3525_ = true;
                                        break;
                                    }
                                    let _e524 = local_7[_e521];
                                    if _e522 {
                                    } else {
                                        phi_3525_ = true;
                                        break;
                                    }
                                    let _e526 = local_6[_e521];
                                    if _e522 {
                                    } else {
                                        phi_3525_ = true;
                                        break;
                                    }
                                    let _e528 = local_5[_e521];
                                    if _e522 {
                                    } else {
                                        phi_3525_ = true;
                                        break;
                                    }
                                    let _e530 = local_4[_e521];
                                    if _e522 {
                                    } else {
                                        phi_3525_ = true;
                                        break;
                                    }
                                    let _e532 = local_3[_e521];
                                    if _e522 {
                                    } else {
                                        phi_3525_ = true;
                                        break;
                                    }
                                    let _e534 = local_2[_e521];
                                    if _e522 {
                                    } else {
                                        phi_3525_ = true;
                                        break;
                                    }
                                    let _e539 = local_8[_e521];
                                    if _e522 {
                                    } else {
                                        phi_3525_ = true;
                                        break;
                                    }
                                    let _e542 = local_9[_e521];
                                    phi_961_ = type_49(type_24(vec4<f32>(_e524, _e526, _e528, 0f), vec4<f32>(_e530, _e532, _e534, 0f)), _e539);
                                    phi_962_ = (_e542 <= _e507.member);
                                    phi_963_ = _e520;
                                }
                                let _e546 = phi_961_;
                                let _e548 = phi_962_;
                                let _e550 = phi_963_;
                                if _e548 {
                                    let _e555 = (_e546.member_1 & 268435455u);
                                    if ((_e546.member_1 & 2147483648u) != 0u) {
                                        phi_3411_ = _e505;
                                        phi_982_ = _e507;
                                        phi_985_ = type_8(0u, ((_e546.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1033 = phi_3411_;
                                            let _e1035 = phi_982_;
                                            let _e1037 = phi_985_;
                                            local_13 = _e1035;
                                            local_15 = _e1035;
                                            if (_e1037.member < _e1037.member_1) {
                                                phi_986_ = type_8((_e1037.member + 1u), _e1037.member_1);
                                                phi_1008_ = type_8(1u, _e1037.member);
                                            } else {
                                                phi_986_ = _e1037;
                                                phi_1008_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1050 = phi_986_;
                                            let _e1052 = phi_1008_;
                                            let _e1056 = (bitcast<i32>(_e1052.member) != 0i);
                                            if _e1056 {
                                                let _e1061 = (_e546.member.member_1.x - _e546.member.member.x);
                                                let _e1064 = (_e546.member.member_1.y - _e546.member.member.y);
                                                let _e1067 = (_e546.member.member_1.z - _e546.member.member.z);
                                                let _e1069 = select(_e1064, _e1061, (_e1061 > _e1064));
                                                let _e1071 = select(_e1067, _e1069, (_e1069 > _e1067));
                                                let _e1073 = (_e1071 < (1024f * _e143));
                                                if _e1073 {
                                                    phi_1049_ = 0u;
                                                } else {
                                                    phi_1049_ = select(2u, 1u, (_e1071 < (2097152f * _e143)));
                                                }
                                                let _e1078 = phi_1049_;
                                                switch bitcast<i32>(_e1078) {
                                                    case 0: {
                                                        phi_1055_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1055_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1055_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1055_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1081 = phi_1055_;
                                                switch bitcast<i32>(_e1078) {
                                                    case 0: {
                                                        phi_1065_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1065_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1065_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1065_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1088 = phi_1065_;
                                                let _e1090 = ((_e555 + (_e1052.member_1 * ((3u * _e1081) + 1u))) + (3u * _e1088));
                                                let _e1091 = (_e1090 < _e95);
                                                if _e1091 {
                                                    if _e1091 {
                                                    } else {
                                                        phi_3469_ = true;
                                                        break;
                                                    }
                                                    let _e1093 = global_6.member[_e1090];
                                                    phi_1081_ = _e1093;
                                                } else {
                                                    phi_1081_ = 4294967295u;
                                                }
                                                let _e1095 = phi_1081_;
                                                local_10 = array<u32, 3>(_e263, _e262, _e264);
                                                if _e1073 {
                                                    phi_1118_ = 0u;
                                                } else {
                                                    phi_1118_ = select(2u, 1u, (_e1071 < (2097152f * _e143)));
                                                }
                                                let _e1101 = phi_1118_;
                                                switch bitcast<i32>(_e1101) {
                                                    case 0: {
                                                        phi_1124_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1124_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1124_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1124_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1104 = phi_1124_;
                                                switch bitcast<i32>(_e1101) {
                                                    case 0: {
                                                        phi_1134_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1134_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1134_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1134_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1111 = phi_1134_;
                                                local_12 = array<f32, 4>(_e546.member.member.x, _e546.member.member.y, _e546.member.member.z, _e546.member.member.w);
                                                local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_3396_ = _e1033;
                                                phi_1150_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1125 = phi_3396_;
                                                    let _e1127 = phi_1150_;
                                                    if (_e1127.member < _e1127.member_1) {
                                                        phi_1151_ = type_8((_e1127.member + 1u), _e1127.member_1);
                                                        phi_1174_ = type_8(1u, _e1127.member);
                                                    } else {
                                                        phi_1151_ = _e1127;
                                                        phi_1174_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1140 = phi_1151_;
                                                    let _e1142 = phi_1174_;
                                                    let _e1146 = (bitcast<i32>(_e1142.member) != 0i);
                                                    if _e1146 {
                                                        let _e1148 = ((_e555 + (_e1052.member_1 * ((3u * _e1104) + 1u))) + (_e1142.member_1 * _e1111));
                                                        let _e1149 = (_e1148 < _e95);
                                                        if _e1149 {
                                                            if _e1149 {
                                                            } else {
                                                                phi_3467_ = true;
                                                                break;
                                                            }
                                                            let _e1151 = global_6.member[_e1148];
                                                            phi_1197_ = _e1151;
                                                        } else {
                                                            phi_1197_ = 0u;
                                                        }
                                                        let _e1153 = phi_1197_;
                                                        let _e1154 = (_e1148 + 1u);
                                                        let _e1155 = (_e1154 < _e95);
                                                        if _e1155 {
                                                            if _e1155 {
                                                            } else {
                                                                phi_3467_ = true;
                                                                break;
                                                            }
                                                            let _e1157 = global_6.member[_e1154];
                                                            phi_1212_ = _e1157;
                                                        } else {
                                                            phi_1212_ = 0u;
                                                        }
                                                        let _e1159 = phi_1212_;
                                                        phi_1215_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1161 = phi_1215_;
                                                            if (_e1161.member < _e1161.member_1) {
                                                                phi_1216_ = type_8((_e1161.member + 1u), _e1161.member_1);
                                                                phi_1239_ = type_8(1u, _e1161.member);
                                                            } else {
                                                                phi_1216_ = _e1161;
                                                                phi_1239_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1174 = phi_1216_;
                                                            let _e1176 = phi_1239_;
                                                            let _e1180 = (bitcast<i32>(_e1176.member) != 0i);
                                                            if _e1180 {
                                                                let _e1181 = (_e1176.member_1 < 3u);
                                                                if _e1181 {
                                                                } else {
                                                                    phi_3389_ = true;
                                                                    break;
                                                                }
                                                                let _e1183 = local_10[_e1176.member_1];
                                                                if (_e1176.member_1 < 4u) {
                                                                } else {
                                                                    phi_3389_ = true;
                                                                    break;
                                                                }
                                                                let _e1186 = local_12[_e1176.member_1];
                                                                switch bitcast<i32>(_e1101) {
                                                                    case 0: {
                                                                        phi_1309_ = (_e1186 + (f32(((_e1153 >> bitcast<u32>(((10u * _e1183) & 31u))) & 1023u)) * _e143));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1183 == 0u) {
                                                                            phi_1286_ = _e1153;
                                                                        } else {
                                                                            if (_e1183 == 1u) {
                                                                                phi_1285_ = ((_e1153 >> bitcast<u32>(21i)) | (_e1159 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_1285_ = (_e1159 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1207 = phi_1285_;
                                                                            phi_1286_ = _e1207;
                                                                        }
                                                                        let _e1209 = phi_1286_;
                                                                        phi_1309_ = (_e1186 + (f32((_e1209 & 2097151u)) * _e143));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1188 = (_e1148 + _e1183);
                                                                        let _e1189 = (_e1188 < _e95);
                                                                        if _e1189 {
                                                                            if _e1189 {
                                                                            } else {
                                                                                phi_3389_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1191 = global_6.member[_e1188];
                                                                            phi_1305_ = _e1191;
                                                                        } else {
                                                                            phi_1305_ = 0u;
                                                                        }
                                                                        let _e1193 = phi_1305_;
                                                                        phi_1309_ = (f32(bitcast<i32>(_e1193)) * _e143);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_1309_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1223 = phi_1309_;
                                                                if (_e1142.member_1 < 3u) {
                                                                } else {
                                                                    phi_3389_ = true;
                                                                    break;
                                                                }
                                                                if _e1181 {
                                                                } else {
                                                                    phi_3389_ = true;
                                                                    break;
                                                                }
                                                                local_11[_e1142.member_1][_e1176.member_1] = _e1223;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1215_ = _e1174;
                                                                phi_3389_ = _e1125;
                                                                break if !(_e1180);
                                                            }
                                                        }
                                                        let _e1229 = phi_3389_;
                                                        phi_3467_ = _e1229;
                                                        if _e1229 {
                                                            break;
                                                        }
                                                        phi_3468_ = _e1229;
                                                    } else {
                                                        phi_3468_ = _e1125;
                                                    }
                                                    let _e1231 = phi_3468_;
                                                    continue;
                                                    continuing {
                                                        phi_3396_ = _e1231;
                                                        phi_1150_ = _e1140;
                                                        phi_3467_ = _e1231;
                                                        break if !(_e1146);
                                                    }
                                                }
                                                let _e1234 = phi_3467_;
                                                phi_3469_ = _e1234;
                                                if _e1234 {
                                                    break;
                                                }
                                                let _e1235 = local_11;
                                                let _e1251 = (_e1235[0][2] - _e389);
                                                let _e1254 = (((_e1235[0][0] - _e312) * _e413) - (_e1251 * _e337));
                                                let _e1257 = (((_e1235[0][1] - _e351) * _e413) - (_e1251 * _e375));
                                                let _e1260 = (_e1235[1][2] - _e389);
                                                let _e1263 = (((_e1235[1][0] - _e312) * _e413) - (_e1260 * _e337));
                                                let _e1266 = (((_e1235[1][1] - _e351) * _e413) - (_e1260 * _e375));
                                                let _e1269 = (_e1235[2][2] - _e389);
                                                let _e1272 = (((_e1235[2][0] - _e312) * _e413) - (_e1269 * _e337));
                                                let _e1275 = (((_e1235[2][1] - _e351) * _e413) - (_e1269 * _e375));
                                                let _e1276 = (_e1272 * _e1266);
                                                let _e1277 = (_e1275 * _e1263);
                                                let _e1278 = (_e1254 * _e1275);
                                                let _e1279 = (_e1257 * _e1272);
                                                let _e1280 = (_e1263 * _e1257);
                                                let _e1281 = (_e1266 * _e1254);
                                                let _e1286 = (((_e1276 >= _e1277) && (_e1278 >= _e1279)) && (_e1280 >= _e1281));
                                                if (_e1286 || (((_e1276 <= _e1277) && (_e1278 <= _e1279)) && (_e1280 <= _e1281))) {
                                                    let _e1293 = select(-1f, 1f, _e1286);
                                                    let _e1295 = ((_e1276 - _e1277) * _e1293);
                                                    let _e1297 = select(0f, _e1295, (_e1295 > 0f));
                                                    let _e1299 = ((_e1278 - _e1279) * _e1293);
                                                    let _e1301 = select(0f, _e1299, (_e1299 > 0f));
                                                    let _e1303 = ((_e1280 - _e1281) * _e1293);
                                                    let _e1305 = select(0f, _e1303, (_e1303 > 0f));
                                                    let _e1307 = ((_e1297 + _e1301) + _e1305);
                                                    if (_e1307 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1904_ = type_20();
                                                        phi_1905_ = true;
                                                    } else {
                                                        let _e1310 = select(_e1235[1][0], _e1235[0][0], (_e1235[0][0] < _e1235[1][0]));
                                                        let _e1314 = select(_e1235[1][0], _e1235[0][0], (_e1235[0][0] > _e1235[1][0]));
                                                        let _e1318 = select(_e1235[1][1], _e1235[0][1], (_e1235[0][1] < _e1235[1][1]));
                                                        let _e1322 = select(_e1235[1][1], _e1235[0][1], (_e1235[0][1] > _e1235[1][1]));
                                                        let _e1326 = select(_e1235[1][2], _e1235[0][2], (_e1235[0][2] < _e1235[1][2]));
                                                        let _e1330 = select(_e1235[1][2], _e1235[0][2], (_e1235[0][2] > _e1235[1][2]));
                                                        let _e1335 = ((select(_e1235[2][0], _e1310, (_e1310 < _e1235[2][0])) - _e335) * _e340);
                                                        let _e1336 = ((select(_e1235[2][0], _e1314, (_e1314 > _e1235[2][0])) - _e336) * _e340);
                                                        let _e1339 = ((select(_e1235[2][1], _e1318, (_e1318 < _e1235[2][1])) - _e373) * _e378);
                                                        let _e1340 = ((select(_e1235[2][1], _e1322, (_e1322 > _e1235[2][1])) - _e374) * _e378);
                                                        let _e1343 = ((select(_e1235[2][2], _e1326, (_e1326 < _e1235[2][2])) - _e411) * _e416);
                                                        let _e1344 = ((select(_e1235[2][2], _e1330, (_e1330 > _e1235[2][2])) - _e412) * _e416);
                                                        let _e1346 = select(_e1344, _e1343, (_e1343 < _e1344));
                                                        let _e1348 = select(_e1344, _e1343, (_e1343 > _e1344));
                                                        let _e1350 = select(_e1336, _e1335, (_e1335 < _e1336));
                                                        let _e1352 = select(_e1340, _e1339, (_e1339 < _e1340));
                                                        let _e1354 = select(_e1352, _e1350, (_e1350 > _e1352));
                                                        let _e1356 = select(_e1346, _e1354, (_e1354 > _e1346));
                                                        let _e1358 = select(_e1336, _e1335, (_e1335 > _e1336));
                                                        let _e1360 = select(_e1340, _e1339, (_e1339 > _e1340));
                                                        let _e1362 = select(_e1360, _e1358, (_e1358 < _e1360));
                                                        let _e1364 = select(_e1348, _e1362, (_e1362 < _e1348));
                                                        let _e1365 = -(_e1346);
                                                        let _e1371 = select(_e463, _e1356, (_e1356 > _e463));
                                                        if (_e1371 > (_e1364 + (select(_e1365, _e1348, (_e1348 > _e1365)) * 0.0000019073523f))) {
                                                            phi_1899_ = type_20();
                                                            phi_1900_ = true;
                                                        } else {
                                                            let _e1373 = (_e1371 > _e1035.member);
                                                            if _e1373 {
                                                                phi_1898_ = type_20();
                                                            } else {
                                                                let _e1377 = (_e1235[1][0] - _e1235[0][0]);
                                                                let _e1378 = (_e1235[1][1] - _e1235[0][1]);
                                                                let _e1379 = (_e1235[1][2] - _e1235[0][2]);
                                                                let _e1380 = vec3<f32>(_e1377, _e1378, _e1379);
                                                                let _e1381 = (_e1235[2][0] - _e1235[1][0]);
                                                                let _e1382 = (_e1235[2][1] - _e1235[1][1]);
                                                                let _e1383 = (_e1235[2][2] - _e1235[1][2]);
                                                                let _e1384 = vec3<f32>(_e1381, _e1382, _e1383);
                                                                let _e1385 = (_e1235[0][0] - _e1235[2][0]);
                                                                let _e1386 = (_e1235[0][1] - _e1235[2][1]);
                                                                let _e1387 = (_e1235[0][2] - _e1235[2][2]);
                                                                let _e1388 = vec3<f32>(_e1385, _e1386, _e1387);
                                                                let _e1391 = bitcast<f32>((bitcast<u32>(_e1377) & 2147483647u));
                                                                let _e1394 = bitcast<f32>((bitcast<u32>(_e1378) & 2147483647u));
                                                                let _e1396 = select(_e1394, _e1391, (_e1391 > _e1394));
                                                                let _e1399 = bitcast<f32>((bitcast<u32>(_e1379) & 2147483647u));
                                                                let _e1401 = select(_e1399, _e1396, (_e1396 > _e1399));
                                                                let _e1404 = bitcast<f32>((bitcast<u32>(_e1381) & 2147483647u));
                                                                let _e1407 = bitcast<f32>((bitcast<u32>(_e1382) & 2147483647u));
                                                                let _e1409 = select(_e1407, _e1404, (_e1404 > _e1407));
                                                                let _e1412 = bitcast<f32>((bitcast<u32>(_e1383) & 2147483647u));
                                                                let _e1414 = select(_e1412, _e1409, (_e1409 > _e1412));
                                                                let _e1417 = bitcast<f32>((bitcast<u32>(_e1385) & 2147483647u));
                                                                let _e1420 = bitcast<f32>((bitcast<u32>(_e1386) & 2147483647u));
                                                                let _e1422 = select(_e1420, _e1417, (_e1417 > _e1420));
                                                                let _e1425 = bitcast<f32>((bitcast<u32>(_e1387) & 2147483647u));
                                                                let _e1427 = select(_e1425, _e1422, (_e1422 > _e1425));
                                                                let _e1429 = select(_e1414, _e1401, (_e1401 > _e1414));
                                                                let _e1431 = select(_e1427, _e1429, (_e1429 > _e1427));
                                                                if (_e1401 == _e1431) {
                                                                    phi_1809_ = _e1384;
                                                                    phi_1810_ = _e1388;
                                                                } else {
                                                                    let _e1434 = vec3((_e1414 == _e1431));
                                                                    phi_1809_ = select(_e1380, _e1388, _e1434);
                                                                    phi_1810_ = select(_e1384, _e1380, _e1434);
                                                                }
                                                                let _e1438 = phi_1809_;
                                                                let _e1440 = phi_1810_;
                                                                let _e1447 = ((_e1438.y * _e1440.z) - (_e1440.y * _e1438.z));
                                                                let _e1452 = ((_e1438.z * _e1440.x) - (_e1440.z * _e1438.x));
                                                                let _e1455 = ((_e1438.x * _e1440.y) - (_e1440.x * _e1438.y));
                                                                if (_e1297 >= _e1301) {
                                                                    phi_1841_ = select(true, false, (_e1297 >= _e1305));
                                                                } else {
                                                                    phi_1841_ = true;
                                                                }
                                                                let _e1460 = phi_1841_;
                                                                if _e1460 {
                                                                    phi_1850_ = select(vec3<f32>(_e1235[2][0], _e1235[2][1], _e1235[2][2]), vec3<f32>(_e1235[1][0], _e1235[1][1], _e1235[1][2]), vec3((_e1301 >= _e1305)));
                                                                } else {
                                                                    phi_1850_ = vec3<f32>(_e1235[0][0], _e1235[0][1], _e1235[0][2]);
                                                                }
                                                                let _e1465 = phi_1850_;
                                                                let _e1482 = ((((_e1447 * (_e1465.x - _e312)) + (_e1452 * (_e1465.y - _e351))) + (_e1455 * (_e1465.z - _e389))) / (((_e1447 * _e337) + (_e1452 * _e375)) + (_e1455 * _e413)));
                                                                let _e1484 = select(_e1364, _e1482, (_e1482 < _e1364));
                                                                let _e1486 = select(_e1356, _e1484, (_e1484 > _e1356));
                                                                if (_e1486 >= _e463) {
                                                                    let _e1488 = (_e1486 <= _e1035.member);
                                                                    if _e1488 {
                                                                        let _e1489 = (1f / _e1307);
                                                                        phi_1890_ = type_20(_e1486, (_e1301 * _e1489), (_e1305 * _e1489), _e1095);
                                                                    } else {
                                                                        phi_1890_ = type_20();
                                                                    }
                                                                    let _e1494 = phi_1890_;
                                                                    phi_1892_ = _e1494;
                                                                    phi_1893_ = select(true, false, _e1488);
                                                                } else {
                                                                    phi_1892_ = type_20();
                                                                    phi_1893_ = true;
                                                                }
                                                                let _e1497 = phi_1892_;
                                                                let _e1499 = phi_1893_;
                                                                if _e1499 {
                                                                    phi_1897_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1897_ = _e1497;
                                                                }
                                                                let _e1501 = phi_1897_;
                                                                phi_1898_ = _e1501;
                                                            }
                                                            let _e1503 = phi_1898_;
                                                            phi_1899_ = _e1503;
                                                            phi_1900_ = _e1373;
                                                        }
                                                        let _e1505 = phi_1899_;
                                                        let _e1507 = phi_1900_;
                                                        phi_1904_ = _e1505;
                                                        phi_1905_ = _e1507;
                                                    }
                                                    let _e1509 = phi_1904_;
                                                    let _e1511 = phi_1905_;
                                                    phi_1909_ = _e1509;
                                                    phi_1910_ = _e1511;
                                                } else {
                                                    phi_1909_ = type_20();
                                                    phi_1910_ = true;
                                                }
                                                let _e1513 = phi_1909_;
                                                let _e1515 = phi_1910_;
                                                if _e1515 {
                                                    phi_1914_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1914_ = _e1513;
                                                }
                                                let _e1517 = phi_1914_;
                                                if (_e1517.member_3 != 4294967295u) {
                                                    if (_e1095 != 4294967295u) {
                                                        phi_1925_ = type_34(_e1035.member, true);
                                                    } else {
                                                        phi_1925_ = _e1035;
                                                    }
                                                    let _e1525 = phi_1925_;
                                                    phi_1926_ = _e1525;
                                                } else {
                                                    phi_1926_ = _e1035;
                                                }
                                                let _e1527 = phi_1926_;
                                                phi_3470_ = _e1234;
                                                phi_983_ = _e1527;
                                            } else {
                                                phi_3470_ = _e1033;
                                                phi_983_ = type_34();
                                            }
                                            let _e1529 = phi_3470_;
                                            let _e1531 = phi_983_;
                                            continue;
                                            continuing {
                                                phi_3411_ = _e1529;
                                                phi_982_ = _e1531;
                                                phi_985_ = _e1050;
                                                phi_3469_ = _e1529;
                                                break if !(_e1056);
                                            }
                                        }
                                        let _e1534 = phi_3469_;
                                        phi_3525_ = _e1534;
                                        if _e1534 {
                                            break;
                                        }
                                        let _e1536 = local_13;
                                        phi_3529_ = _e1534;
                                        let _e1708 = local_15;
                                        phi_3167_ = _e1708;
                                        phi_3168_ = _e546;
                                        phi_3169_ = false;
                                        phi_3170_ = select(_e550, 0u, _e1536.member_1);
                                    } else {
                                        if (_e546.member_1 >= _e92) {
                                            phi_2723_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e546.member_1 < _e92) {
                                            } else {
                                                phi_3525_ = true;
                                                break;
                                            }
                                            let _e562 = (_e263 * 2u);
                                            let _e564 = ((1u + _e562) % 7u);
                                            if (_e564 < 7u) {
                                            } else {
                                                phi_3525_ = true;
                                                break;
                                            }
                                            let _e569 = global_5.member[_e546.member_1][_e564];
                                            let _e571 = ((_e562 + 2u) % 7u);
                                            if (_e571 < 7u) {
                                            } else {
                                                phi_3525_ = true;
                                                break;
                                            }
                                            let _e576 = global_5.member[_e546.member_1][_e571];
                                            let _e577 = (_e262 * 2u);
                                            let _e579 = ((1u + _e577) % 7u);
                                            if (_e579 < 7u) {
                                            } else {
                                                phi_3525_ = true;
                                                break;
                                            }
                                            let _e584 = global_5.member[_e546.member_1][_e579];
                                            let _e586 = ((_e577 + 2u) % 7u);
                                            if (_e586 < 7u) {
                                            } else {
                                                phi_3525_ = true;
                                                break;
                                            }
                                            let _e591 = global_5.member[_e546.member_1][_e586];
                                            let _e592 = (_e264 * 2u);
                                            let _e594 = ((1u + _e592) % 7u);
                                            if (_e594 < 7u) {
                                            } else {
                                                phi_3525_ = true;
                                                break;
                                            }
                                            let _e599 = global_5.member[_e546.member_1][_e594];
                                            let _e601 = ((_e592 + 2u) % 7u);
                                            if (_e601 < 7u) {
                                            } else {
                                                phi_3525_ = true;
                                                break;
                                            }
                                            let _e606 = global_5.member[_e546.member_1][_e601];
                                            let _e629 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.x - _e546.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e630 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.y - _e546.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e631 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.z - _e546.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e633 = select(_e143, _e629, (_e629 > _e143));
                                            let _e635 = select(_e143, _e630, (_e630 > _e143));
                                            let _e637 = select(_e143, _e631, (_e631 > _e143));
                                            let _e662 = bitcast<u32>((f32(bitcast<i32>((_e569 & 2097151u))) * _e633));
                                            let _e667 = (bitcast<i32>((_e569 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e670 = bitcast<f32>((_e662 & bitcast<u32>(_e667)));
                                            let _e671 = bitcast<u32>((f32(bitcast<i32>((_e584 & 2097151u))) * _e635));
                                            let _e676 = (bitcast<i32>((_e584 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e679 = bitcast<f32>((_e671 & bitcast<u32>(_e676)));
                                            let _e680 = bitcast<u32>((f32(bitcast<i32>((_e599 & 2097151u))) * _e637));
                                            let _e685 = (bitcast<i32>((_e599 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e688 = bitcast<f32>((_e680 & bitcast<u32>(_e685)));
                                            let _e692 = bitcast<f32>((_e662 & bitcast<u32>(~(_e667))));
                                            let _e696 = bitcast<f32>((_e671 & bitcast<u32>(~(_e676))));
                                            let _e700 = bitcast<f32>((_e680 & bitcast<u32>(~(_e685))));
                                            let _e701 = bitcast<u32>((f32(bitcast<i32>((_e576 & 2097151u))) * _e633));
                                            let _e706 = (bitcast<i32>((_e576 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e709 = bitcast<f32>((_e701 & bitcast<u32>(_e706)));
                                            let _e710 = bitcast<u32>((f32(bitcast<i32>((_e591 & 2097151u))) * _e635));
                                            let _e715 = (bitcast<i32>((_e591 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e718 = bitcast<f32>((_e710 & bitcast<u32>(_e715)));
                                            let _e719 = bitcast<u32>((f32(bitcast<i32>((_e606 & 2097151u))) * _e637));
                                            let _e724 = (bitcast<i32>((_e606 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e727 = bitcast<f32>((_e719 & bitcast<u32>(_e724)));
                                            let _e731 = bitcast<f32>((_e701 & bitcast<u32>(~(_e706))));
                                            let _e735 = bitcast<f32>((_e710 & bitcast<u32>(~(_e715))));
                                            let _e739 = bitcast<f32>((_e719 & bitcast<u32>(~(_e724))));
                                            let _e740 = (_e546.member.member.x + _e670);
                                            let _e741 = (_e546.member.member.y + _e679);
                                            let _e742 = (_e546.member.member.z + _e688);
                                            let _e745 = (_e546.member.member_1.x - _e709);
                                            let _e746 = (_e546.member.member_1.y - _e718);
                                            let _e747 = (_e546.member.member_1.z - _e727);
                                            let _e766 = (_e745 - _e740);
                                            let _e767 = (_e746 - _e741);
                                            let _e768 = (_e747 - _e742);
                                            let _e770 = select(_e767, _e766, (_e766 > _e767));
                                            let _e772 = select(_e768, _e770, (_e770 > _e768));
                                            if (_e772 < (1024f * _e143)) {
                                                phi_2424_ = 0u;
                                            } else {
                                                phi_2424_ = select(2u, 1u, (_e772 < (2097152f * _e143)));
                                            }
                                            let _e779 = phi_2424_;
                                            switch bitcast<i32>(_e779) {
                                                case 0: {
                                                    phi_2430_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2430_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2430_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2430_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e782 = phi_2430_;
                                            let _e788 = global_5.member[_e546.member_1][0u];
                                            let _e792 = global_5.member[_e546.member_1][2u];
                                            let _e796 = global_5.member[_e546.member_1][4u];
                                            let _e800 = global_5.member[_e546.member_1][6u];
                                            let _e812 = (((_e792 >> bitcast<u32>(22i)) | ((_e796 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e800 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e813 = (_e788 & 268435455u);
                                            let _e814 = (_e812 & 268435455u);
                                            let _e817 = ((_e788 >> bitcast<u32>(28u)) & 7u);
                                            let _e825 = ((_e788 >> bitcast<u32>(31i)) | (((_e812 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e826 = (_e817 != 0u);
                                            if (_e817 == 0u) {
                                                phi_2685_ = _e813;
                                            } else {
                                                if (_e817 == 7u) {
                                                    phi_2684_ = 2147483648u;
                                                } else {
                                                    phi_2684_ = ((2147483648u | (_e817 << bitcast<u32>(28u))) | (_e814 & 268435455u));
                                                }
                                                let _e835 = phi_2684_;
                                                phi_2685_ = _e835;
                                            }
                                            let _e837 = phi_2685_;
                                            if _e826 {
                                                let _e838 = (_e817 != 7u);
                                                if _e838 {
                                                    phi_2695_ = (_e814 + (_e817 * ((3u * _e782) + 1u)));
                                                } else {
                                                    phi_2695_ = u32();
                                                }
                                                let _e842 = phi_2695_;
                                                phi_2697_ = _e842;
                                                phi_2698_ = select(true, false, _e838);
                                            } else {
                                                phi_2697_ = u32();
                                                phi_2698_ = true;
                                            }
                                            let _e845 = phi_2697_;
                                            let _e847 = phi_2698_;
                                            if (_e825 == 0u) {
                                                phi_2719_ = (_e813 + select(0u, 1u, !(_e826)));
                                            } else {
                                                if (_e825 == 7u) {
                                                    phi_2718_ = 2147483648u;
                                                } else {
                                                    phi_2718_ = ((2147483648u | (_e825 << bitcast<u32>(28u))) | (select(_e845, _e814, _e847) & 268435455u));
                                                }
                                                let _e860 = phi_2718_;
                                                phi_2719_ = _e860;
                                            }
                                            let _e862 = phi_2719_;
                                            phi_2723_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e740, (_e546.member.member.x + _e692), _e745, (_e546.member.member_1.x - _e731)), vec4<f32>(_e741, (_e546.member.member.y + _e696), _e746, (_e546.member.member_1.y - _e735)), vec4<f32>(_e742, (_e546.member.member.z + _e700), _e747, (_e546.member.member_1.z - _e739))), type_49(type_24((_e546.member.member + vec4<f32>(_e670, _e679, _e688, 0f)), (_e546.member.member_1 - vec4<f32>(_e709, _e718, _e727, 0f))), _e837), type_49(type_24((_e546.member.member + vec4<f32>(_e692, _e696, _e700, 0f)), (_e546.member.member_1 - vec4<f32>(_e731, _e735, _e739, 0f))), _e862));
                                        }
                                        let _e867 = phi_2723_;
                                        let _e879 = ((_e867.member[0].x - _e335) * _e340);
                                        let _e880 = ((_e867.member[0].y - _e335) * _e340);
                                        let _e881 = ((_e867.member[0].z - _e336) * _e340);
                                        let _e882 = ((_e867.member[0].w - _e336) * _e340);
                                        let _e892 = ((_e867.member[1].x - _e373) * _e378);
                                        let _e893 = ((_e867.member[1].y - _e373) * _e378);
                                        let _e894 = ((_e867.member[1].z - _e374) * _e378);
                                        let _e895 = ((_e867.member[1].w - _e374) * _e378);
                                        let _e905 = ((_e867.member[2].x - _e411) * _e416);
                                        let _e906 = ((_e867.member[2].y - _e411) * _e416);
                                        let _e907 = ((_e867.member[2].z - _e412) * _e416);
                                        let _e908 = ((_e867.member[2].w - _e412) * _e416);
                                        let _e910 = select(_e907, _e905, (_e905 < _e907));
                                        let _e912 = select(_e908, _e906, (_e906 < _e908));
                                        let _e914 = select(_e907, _e905, (_e905 > _e907));
                                        let _e916 = select(_e908, _e906, (_e906 > _e908));
                                        let _e918 = select(_e881, _e879, (_e879 < _e881));
                                        let _e920 = select(_e882, _e880, (_e880 < _e882));
                                        let _e922 = select(_e894, _e892, (_e892 < _e894));
                                        let _e924 = select(_e895, _e893, (_e893 < _e895));
                                        let _e926 = select(_e922, _e918, (_e918 > _e922));
                                        let _e928 = select(_e924, _e920, (_e920 > _e924));
                                        let _e930 = select(_e910, _e926, (_e926 > _e910));
                                        let _e932 = select(_e912, _e928, (_e928 > _e912));
                                        let _e934 = select(_e881, _e879, (_e879 > _e881));
                                        let _e936 = select(_e882, _e880, (_e880 > _e882));
                                        let _e938 = select(_e894, _e892, (_e892 > _e894));
                                        let _e940 = select(_e895, _e893, (_e893 > _e895));
                                        let _e942 = select(_e938, _e934, (_e934 < _e938));
                                        let _e944 = select(_e940, _e936, (_e936 < _e940));
                                        let _e949 = -(_e910);
                                        let _e950 = -(_e912);
                                        let _e957 = (select(_e914, _e942, (_e942 < _e914)) + (select(_e949, _e914, (_e914 > _e949)) * 0.0000019073523f));
                                        let _e958 = (select(_e916, _e944, (_e944 < _e916)) + (select(_e950, _e916, (_e916 > _e950)) * 0.0000019073523f));
                                        let _e960 = select(_e463, _e930, (_e930 > _e463));
                                        let _e962 = select(_e463, _e932, (_e932 > _e463));
                                        let _e967 = (_e960 <= select(_e507.member, _e957, (_e957 < _e507.member)));
                                        let _e968 = (_e962 <= select(_e507.member, _e958, (_e958 < _e507.member)));
                                        let _e969 = (_e960 <= _e962);
                                        if _e967 {
                                            if _e968 {
                                                if _e969 {
                                                    phi_3067_ = _e867.member_2;
                                                } else {
                                                    phi_3067_ = _e867.member_1;
                                                }
                                                let _e973 = phi_3067_;
                                                let _e995 = (_e550 % 128u);
                                                let _e996 = (_e995 < 128u);
                                                if _e996 {
                                                } else {
                                                    phi_3525_ = true;
                                                    break;
                                                }
                                                local_8[_e995] = _e973.member_1;
                                                if _e996 {
                                                } else {
                                                    phi_3525_ = true;
                                                    break;
                                                }
                                                local_7[_e995] = _e973.member.member.x;
                                                if _e996 {
                                                } else {
                                                    phi_3525_ = true;
                                                    break;
                                                }
                                                local_6[_e995] = _e973.member.member.y;
                                                if _e996 {
                                                } else {
                                                    phi_3525_ = true;
                                                    break;
                                                }
                                                local_5[_e995] = _e973.member.member.z;
                                                if _e996 {
                                                } else {
                                                    phi_3525_ = true;
                                                    break;
                                                }
                                                local_4[_e995] = _e973.member.member_1.x;
                                                if _e996 {
                                                } else {
                                                    phi_3525_ = true;
                                                    break;
                                                }
                                                local_3[_e995] = _e973.member.member_1.y;
                                                if _e996 {
                                                } else {
                                                    phi_3525_ = true;
                                                    break;
                                                }
                                                local_2[_e995] = _e973.member.member_1.z;
                                                if _e996 {
                                                } else {
                                                    phi_3525_ = true;
                                                    break;
                                                }
                                                local_9[_e995] = select(_e962, _e960, (_e960 > _e962));
                                                if _e969 {
                                                    phi_3144_ = _e867.member_1;
                                                } else {
                                                    phi_3144_ = _e867.member_2;
                                                }
                                                let _e1009 = phi_3144_;
                                                phi_3145_ = _e1009;
                                                phi_3146_ = (_e550 + 1u);
                                            } else {
                                                phi_3145_ = type_49();
                                                phi_3146_ = u32();
                                            }
                                            let _e1011 = phi_3145_;
                                            let _e1013 = phi_3146_;
                                            phi_3148_ = _e1011;
                                            phi_3149_ = _e1013;
                                            phi_3150_ = select(true, false, _e968);
                                        } else {
                                            phi_3148_ = type_49();
                                            phi_3149_ = u32();
                                            phi_3150_ = true;
                                        }
                                        let _e1016 = phi_3148_;
                                        let _e1018 = phi_3149_;
                                        let _e1020 = phi_3150_;
                                        if _e1020 {
                                            if _e967 {
                                                phi_3159_ = _e867.member_1;
                                            } else {
                                                phi_3159_ = _e867.member_2;
                                            }
                                            let _e1024 = phi_3159_;
                                            phi_3164_ = _e1024;
                                            phi_3165_ = select(_e968, true, _e967);
                                        } else {
                                            phi_3164_ = _e1016;
                                            phi_3165_ = _e548;
                                        }
                                        let _e1027 = phi_3164_;
                                        let _e1029 = phi_3165_;
                                        phi_3529_ = _e505;
                                        phi_3167_ = _e507;
                                        phi_3168_ = _e1027;
                                        phi_3169_ = _e1029;
                                        phi_3170_ = select(_e1018, _e550, _e1020);
                                    }
                                    let _e1540 = phi_3529_;
                                    let _e1542 = phi_3167_;
                                    let _e1544 = phi_3168_;
                                    let _e1546 = phi_3169_;
                                    let _e1548 = phi_3170_;
                                    phi_3528_ = _e1540;
                                    phi_3171_ = _e1542;
                                    phi_3172_ = _e1544;
                                    phi_3173_ = (_e511 - 1u);
                                    phi_3174_ = _e1546;
                                    phi_3175_ = _e1548;
                                } else {
                                    phi_3528_ = _e505;
                                    phi_3171_ = _e507;
                                    phi_3172_ = _e546;
                                    phi_3173_ = _e511;
                                    phi_3174_ = _e548;
                                    phi_3175_ = _e550;
                                }
                                let _e1550 = phi_3528_;
                                let _e1552 = phi_3171_;
                                let _e1554 = phi_3172_;
                                let _e1556 = phi_3173_;
                                let _e1558 = phi_3174_;
                                let _e1560 = phi_3175_;
                                phi_3527_ = _e1550;
                                phi_3176_ = _e1552;
                                phi_3177_ = _e1554;
                                phi_3178_ = _e1556;
                                phi_3179_ = _e1558;
                                phi_3180_ = _e1560;
                            } else {
                                phi_3527_ = _e505;
                                phi_3176_ = type_34();
                                phi_3177_ = type_49();
                                phi_3178_ = u32();
                                phi_3179_ = bool();
                                phi_3180_ = u32();
                            }
                            let _e1562 = phi_3527_;
                            let _e1564 = phi_3176_;
                            let _e1566 = phi_3177_;
                            let _e1568 = phi_3178_;
                            let _e1570 = phi_3179_;
                            let _e1572 = phi_3180_;
                            phi_3526_ = _e1562;
                            phi_856_ = _e1564;
                            phi_859_ = _e1566;
                            phi_861_ = _e1568;
                            phi_863_ = _e1570;
                            phi_865_ = _e1572;
                            phi_3181_ = _e519;
                        } else {
                            phi_3526_ = _e505;
                            phi_856_ = type_34();
                            phi_859_ = type_49();
                            phi_861_ = u32();
                            phi_863_ = bool();
                            phi_865_ = u32();
                            phi_3181_ = false;
                        }
                        let _e1574 = phi_3526_;
                        let _e1576 = phi_856_;
                        let _e1578 = phi_859_;
                        let _e1580 = phi_861_;
                        let _e1582 = phi_863_;
                        let _e1584 = phi_865_;
                        let _e1586 = phi_3181_;
                        continue;
                        continuing {
                            phi_3414_ = _e1574;
                            phi_855_ = _e1576;
                            phi_858_ = _e1578;
                            phi_860_ = _e1580;
                            phi_862_ = _e1582;
                            phi_864_ = _e1584;
                            phi_3525_ = _e1574;
                            break if !(_e1586);
                        }
                    }
                    let _e1589 = phi_3525_;
                    if _e1589 {
                        break;
                    }
                    let _e1591 = local_14;
                    if _e151 {
                    } else {
                        break;
                    }
                    global_4.member[_e149] = select(0u, 1u, _e1591.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
