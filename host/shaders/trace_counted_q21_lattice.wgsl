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
    member: array<array<u32, 2>>,
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

struct type_33 {
    member: type_24,
    member_1: f32,
}

struct type_37 {
    member: array<type_25>,
}

struct type_39 {
    member: type_33,
    member_1: u32,
    member_2: u32,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_48 {
    member: array<array<u32, 7>>,
}

struct type_54 {
    member: type_28,
    member_1: u32,
}

struct type_55 {
    member: array<vec4<f32>, 3>,
    member_1: type_54,
    member_2: type_54,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_41;
@group(0) @binding(4) 
var<storage> global_3: type_37;
@group(0) @binding(2) 
var<storage> global_4: type_48;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_20;

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
    var phi_403_: i32;
    var phi_404_: i32;
    var phi_414_: bool;
    var phi_424_: u32;
    var phi_425_: u32;
    var phi_427_: bool;
    var phi_432_: u32;
    var phi_445_: i32;
    var phi_465_: i32;
    var phi_483_: f32;
    var phi_489_: f32;
    var phi_500_: f32;
    var phi_506_: f32;
    var phi_529_: f32;
    var phi_540_: f32;
    var phi_549_: f32;
    var phi_555_: f32;
    var phi_566_: f32;
    var phi_572_: f32;
    var phi_595_: f32;
    var phi_606_: f32;
    var phi_615_: f32;
    var phi_621_: f32;
    var phi_632_: f32;
    var phi_638_: f32;
    var phi_661_: f32;
    var phi_672_: f32;
    var phi_772_: f32;
    var phi_773_: f32;
    var phi_3594_: bool;
    var phi_863_: type_39;
    var phi_866_: type_54;
    var phi_868_: u32;
    var phi_870_: bool;
    var phi_872_: u32;
    var phi_883_: bool;
    var phi_969_: type_54;
    var phi_970_: bool;
    var phi_971_: u32;
    var phi_2602_: u32;
    var phi_2608_: u32;
    var phi_2862_: u32;
    var phi_2863_: u32;
    var phi_2873_: u32;
    var phi_2875_: u32;
    var phi_2876_: bool;
    var phi_2896_: u32;
    var phi_2897_: u32;
    var phi_2901_: type_55;
    var phi_3245_: type_54;
    var phi_3322_: type_54;
    var phi_3323_: type_54;
    var phi_3324_: u32;
    var phi_3326_: type_54;
    var phi_3327_: u32;
    var phi_3328_: bool;
    var phi_3337_: type_54;
    var phi_3342_: type_54;
    var phi_3343_: bool;
    var phi_3591_: bool;
    var phi_990_: type_39;
    var phi_993_: type_8;
    var phi_994_: type_8;
    var phi_1016_: type_8;
    var phi_1060_: u32;
    var phi_1066_: u32;
    var phi_1076_: u32;
    var phi_1092_: u32;
    var phi_1129_: u32;
    var phi_1135_: u32;
    var phi_1145_: u32;
    var phi_3576_: bool;
    var phi_1161_: type_8;
    var phi_1162_: type_8;
    var phi_1185_: type_8;
    var phi_1208_: u32;
    var phi_1223_: u32;
    var phi_1226_: type_8;
    var phi_1227_: type_8;
    var phi_1250_: type_8;
    var phi_1316_: u32;
    var phi_1296_: u32;
    var phi_1297_: u32;
    var phi_1320_: f32;
    var phi_3569_: bool;
    var phi_3648_: bool;
    var phi_3647_: bool;
    var phi_1820_: vec3<f32>;
    var phi_1821_: vec3<f32>;
    var phi_1852_: bool;
    var phi_1861_: vec3<f32>;
    var phi_1901_: type_24;
    var phi_1903_: type_24;
    var phi_1904_: bool;
    var phi_1908_: type_24;
    var phi_1909_: type_24;
    var phi_1910_: type_24;
    var phi_1911_: bool;
    var phi_1915_: type_24;
    var phi_1916_: bool;
    var phi_1920_: type_24;
    var phi_1921_: bool;
    var phi_1925_: type_24;
    var phi_1950_: bool;
    var phi_1951_: bool;
    var phi_1958_: type_39;
    var phi_1959_: type_39;
    var phi_1960_: type_39;
    var phi_3650_: bool;
    var phi_991_: type_39;
    var phi_3649_: bool;
    var phi_3712_: bool;
    var phi_3345_: type_39;
    var phi_3346_: type_54;
    var phi_3347_: bool;
    var phi_3348_: u32;
    var phi_3711_: bool;
    var phi_3349_: type_39;
    var phi_3350_: type_54;
    var phi_3351_: u32;
    var phi_3352_: bool;
    var phi_3353_: u32;
    var phi_3710_: bool;
    var phi_3354_: type_39;
    var phi_3355_: type_54;
    var phi_3356_: u32;
    var phi_3357_: bool;
    var phi_3358_: u32;
    var phi_3709_: bool;
    var phi_864_: type_39;
    var phi_867_: type_54;
    var phi_869_: u32;
    var phi_871_: bool;
    var phi_873_: u32;
    var phi_3359_: bool;
    var phi_3708_: bool;
    var local_13: type_39;
    var local_14: type_39;
    var local_15: type_39;

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
                            phi_403_ = (bitcast<i32>((_e228 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_403_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e228)), 32u, (_e228 == 0u))));
                        }
                        let _e242 = phi_403_;
                        phi_404_ = _e242;
                    } else {
                        phi_404_ = 0i;
                    }
                    let _e244 = phi_404_;
                    let _e245 = (_e161 == _e200);
                    if _e245 {
                        phi_414_ = true;
                    } else {
                        phi_414_ = (_e168 == _e200);
                    }
                    let _e248 = phi_414_;
                    let _e249 = select(1u, 0u, _e245);
                    if _e248 {
                        let _e250 = (_e249 + 1u);
                        phi_424_ = _e250;
                        phi_425_ = _e250;
                        phi_427_ = select(true, false, (_e250 == 2u));
                    } else {
                        phi_424_ = u32();
                        phi_425_ = 0u;
                        phi_427_ = true;
                    }
                    let _e254 = phi_424_;
                    let _e256 = phi_425_;
                    let _e258 = phi_427_;
                    if _e258 {
                        phi_432_ = (_e256 + 1u);
                    } else {
                        phi_432_ = 0u;
                    }
                    let _e262 = phi_432_;
                    let _e263 = select(_e254, _e256, _e258);
                    let _e264 = select(_e249, select(2u, _e249, _e248), _e258);
                    if (_e131 < -126i) {
                        phi_445_ = -126i;
                    } else {
                        phi_445_ = select(_e131, 127i, (_e131 > 127i));
                    }
                    let _e269 = phi_445_;
                    let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                    let _e280 = bitcast<f32>((bitcast<u32>(((_e131 - _e269) + 127i)) << bitcast<u32>(23i)));
                    let _e281 = -(_e244);
                    if (_e281 < -126i) {
                        phi_465_ = -126i;
                    } else {
                        phi_465_ = select(_e281, 127i, (_e281 > 127i));
                    }
                    let _e286 = phi_465_;
                    let _e291 = bitcast<f32>((bitcast<u32>((_e286 + 127i)) << bitcast<u32>(23i)));
                    let _e297 = bitcast<f32>((bitcast<u32>(((_e281 - _e286) + 127i)) << bitcast<u32>(23i)));
                    let _e301 = global_3.member[_e149].member;
                    let _e302 = (_e263 == 0u);
                    if _e302 {
                        phi_483_ = _e301[0];
                    } else {
                        phi_483_ = _e301[1];
                    }
                    let _e306 = phi_483_;
                    let _e307 = (_e263 == 2u);
                    if _e307 {
                        phi_489_ = _e301[2];
                    } else {
                        phi_489_ = _e306;
                    }
                    let _e310 = phi_489_;
                    let _e312 = ((_e310 * _e274) * _e280);
                    let _e313 = global_3.member[_e149].member_2;
                    if _e302 {
                        phi_500_ = _e313[0];
                    } else {
                        phi_500_ = _e313[1];
                    }
                    let _e317 = phi_500_;
                    if _e307 {
                        phi_506_ = _e313[2];
                    } else {
                        phi_506_ = _e317;
                    }
                    let _e320 = phi_506_;
                    let _e322 = ((_e320 * _e291) * _e297);
                    let _e326 = (bitcast<f32>((bitcast<u32>(_e322) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e326 {
                        let _e330 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) * 0.00000011920929f);
                        phi_529_ = select(0.00000000000011368684f, _e330, (_e330 > 0.00000000000011368684f));
                    } else {
                        phi_529_ = 0f;
                    }
                    let _e334 = phi_529_;
                    let _e335 = (_e312 + _e334);
                    let _e336 = (_e312 - _e334);
                    let _e337 = select(_e322, 0f, _e326);
                    if _e326 {
                        phi_540_ = 38685626000000000000000000f;
                    } else {
                        phi_540_ = (1f / _e322);
                    }
                    let _e340 = phi_540_;
                    let _e341 = (_e262 == 0u);
                    if _e341 {
                        phi_549_ = _e301[0];
                    } else {
                        phi_549_ = _e301[1];
                    }
                    let _e345 = phi_549_;
                    let _e346 = (_e262 == 2u);
                    if _e346 {
                        phi_555_ = _e301[2];
                    } else {
                        phi_555_ = _e345;
                    }
                    let _e349 = phi_555_;
                    let _e351 = ((_e349 * _e274) * _e280);
                    if _e341 {
                        phi_566_ = _e313[0];
                    } else {
                        phi_566_ = _e313[1];
                    }
                    let _e355 = phi_566_;
                    if _e346 {
                        phi_572_ = _e313[2];
                    } else {
                        phi_572_ = _e355;
                    }
                    let _e358 = phi_572_;
                    let _e360 = ((_e358 * _e291) * _e297);
                    let _e364 = (bitcast<f32>((bitcast<u32>(_e360) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e364 {
                        let _e368 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) * 0.00000011920929f);
                        phi_595_ = select(0.00000000000011368684f, _e368, (_e368 > 0.00000000000011368684f));
                    } else {
                        phi_595_ = 0f;
                    }
                    let _e372 = phi_595_;
                    let _e373 = (_e351 + _e372);
                    let _e374 = (_e351 - _e372);
                    let _e375 = select(_e360, 0f, _e364);
                    if _e364 {
                        phi_606_ = 38685626000000000000000000f;
                    } else {
                        phi_606_ = (1f / _e360);
                    }
                    let _e378 = phi_606_;
                    let _e379 = (_e264 == 0u);
                    if _e379 {
                        phi_615_ = _e301[0];
                    } else {
                        phi_615_ = _e301[1];
                    }
                    let _e383 = phi_615_;
                    let _e384 = (_e264 == 2u);
                    if _e384 {
                        phi_621_ = _e301[2];
                    } else {
                        phi_621_ = _e383;
                    }
                    let _e387 = phi_621_;
                    let _e389 = ((_e387 * _e274) * _e280);
                    if _e379 {
                        phi_632_ = _e313[0];
                    } else {
                        phi_632_ = _e313[1];
                    }
                    let _e393 = phi_632_;
                    if _e384 {
                        phi_638_ = _e313[2];
                    } else {
                        phi_638_ = _e393;
                    }
                    let _e396 = phi_638_;
                    let _e398 = ((_e396 * _e291) * _e297);
                    let _e402 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e402 {
                        let _e406 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) * 0.00000011920929f);
                        phi_661_ = select(0.00000000000011368684f, _e406, (_e406 > 0.00000000000011368684f));
                    } else {
                        phi_661_ = 0f;
                    }
                    let _e410 = phi_661_;
                    let _e411 = (_e389 + _e410);
                    let _e412 = (_e389 - _e410);
                    let _e413 = select(_e398, 0f, _e402);
                    if _e402 {
                        phi_672_ = 38685626000000000000000000f;
                    } else {
                        phi_672_ = (1f / _e398);
                    }
                    let _e416 = phi_672_;
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
                        phi_772_ = select(-340282350000000000000000000000000000000f, _e457, (_e457 > -340282350000000000000000000000000000000f));
                        phi_773_ = select(-340282350000000000000000000000000000000f, _e450, (_e450 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_772_ = 0f;
                        phi_773_ = 1f;
                    }
                    let _e461 = phi_772_;
                    let _e463 = phi_773_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e468 = (_e263 % 3u);
                    let _e469 = (_e468 < 3u);
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e471 = local_1[_e468];
                    let _e474 = (_e262 % 3u);
                    let _e475 = (_e474 < 3u);
                    if _e475 {
                    } else {
                        break;
                    }
                    let _e477 = local_1[_e474];
                    let _e480 = (_e264 % 3u);
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
                    phi_3594_ = false;
                    phi_863_ = type_39(type_33(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e461), 0u, 0u);
                    phi_866_ = type_54(type_28(vec4<f32>((f32(_e471) * _e143), (f32(_e477) * _e143), (f32(_e483) * _e143), 0f), vec4<f32>((f32(_e488) * _e143), (f32(_e492) * _e143), (f32(_e496) * _e143), 0f)), select(0u, 2147483648u, (_e92 == 0u)));
                    phi_868_ = ((3u * _e92) + 1u);
                    phi_870_ = (_e463 <= _e461);
                    phi_872_ = 0u;
                    loop {
                        let _e506 = phi_3594_;
                        let _e508 = phi_863_;
                        let _e510 = phi_866_;
                        let _e512 = phi_868_;
                        let _e514 = phi_870_;
                        let _e516 = phi_872_;
                        local_13 = _e508;
                        local_14 = _e508;
                        if _e514 {
                            phi_883_ = true;
                        } else {
                            phi_883_ = (_e516 > 0u);
                        }
                        let _e519 = phi_883_;
                        if _e519 {
                            let _e520 = (_e512 > 0u);
                            if _e520 {
                                if _e514 {
                                    phi_969_ = _e510;
                                    phi_970_ = _e514;
                                    phi_971_ = _e516;
                                } else {
                                    let _e521 = (_e516 - 1u);
                                    let _e522 = (_e521 % 128u);
                                    let _e523 = (_e522 < 128u);
                                    if _e523 {
                                    } else {
                                        phi_3708_ = true;
                                        break;
                                    }
                                    let _e525 = local_7[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3708_ = true;
                                        break;
                                    }
                                    let _e527 = local_6[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3708_ = true;
                                        break;
                                    }
                                    let _e529 = local_5[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3708_ = true;
                                        break;
                                    }
                                    let _e531 = local_4[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3708_ = true;
                                        break;
                                    }
                                    let _e533 = local_3[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3708_ = true;
                                        break;
                                    }
                                    let _e535 = local_2[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3708_ = true;
                                        break;
                                    }
                                    let _e540 = local_8[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3708_ = true;
                                        break;
                                    }
                                    let _e543 = local_9[_e522];
                                    phi_969_ = type_54(type_28(vec4<f32>(_e525, _e527, _e529, 0f), vec4<f32>(_e531, _e533, _e535, 0f)), _e540);
                                    phi_970_ = (_e543 <= _e508.member.member_1);
                                    phi_971_ = _e521;
                                }
                                let _e548 = phi_969_;
                                let _e550 = phi_970_;
                                let _e552 = phi_971_;
                                if _e550 {
                                    let _e557 = (_e548.member_1 & 268435455u);
                                    if ((_e548.member_1 & 2147483648u) != 0u) {
                                        phi_3591_ = _e506;
                                        phi_990_ = _e508;
                                        phi_993_ = type_8(0u, ((_e548.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1045 = phi_3591_;
                                            let _e1047 = phi_990_;
                                            let _e1049 = phi_993_;
                                            local_15 = _e1047;
                                            if (_e1049.member < _e1049.member_1) {
                                                phi_994_ = type_8((_e1049.member + 1u), _e1049.member_1);
                                                phi_1016_ = type_8(1u, _e1049.member);
                                            } else {
                                                phi_994_ = _e1049;
                                                phi_1016_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1062 = phi_994_;
                                            let _e1064 = phi_1016_;
                                            let _e1068 = (bitcast<i32>(_e1064.member) != 0i);
                                            if _e1068 {
                                                let _e1074 = type_39(_e1047.member, _e1047.member_1, (_e1047.member_2 + 1u));
                                                let _e1079 = (_e548.member.member_1.x - _e548.member.member.x);
                                                let _e1082 = (_e548.member.member_1.y - _e548.member.member.y);
                                                let _e1085 = (_e548.member.member_1.z - _e548.member.member.z);
                                                let _e1087 = select(_e1082, _e1079, (_e1079 > _e1082));
                                                let _e1089 = select(_e1085, _e1087, (_e1087 > _e1085));
                                                let _e1091 = (_e1089 < (1024f * _e143));
                                                if _e1091 {
                                                    phi_1060_ = 0u;
                                                } else {
                                                    phi_1060_ = select(2u, 1u, (_e1089 < (2097152f * _e143)));
                                                }
                                                let _e1096 = phi_1060_;
                                                switch bitcast<i32>(_e1096) {
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
                                                let _e1099 = phi_1066_;
                                                switch bitcast<i32>(_e1096) {
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
                                                let _e1106 = phi_1076_;
                                                let _e1108 = ((_e557 + (_e1064.member_1 * ((3u * _e1099) + 1u))) + (3u * _e1106));
                                                let _e1109 = (_e1108 < _e95);
                                                if _e1109 {
                                                    if _e1109 {
                                                    } else {
                                                        phi_3649_ = true;
                                                        break;
                                                    }
                                                    let _e1111 = global_5.member[_e1108];
                                                    phi_1092_ = _e1111;
                                                } else {
                                                    phi_1092_ = 4294967295u;
                                                }
                                                let _e1113 = phi_1092_;
                                                local_10 = array<u32, 3>(_e263, _e262, _e264);
                                                if _e1091 {
                                                    phi_1129_ = 0u;
                                                } else {
                                                    phi_1129_ = select(2u, 1u, (_e1089 < (2097152f * _e143)));
                                                }
                                                let _e1119 = phi_1129_;
                                                switch bitcast<i32>(_e1119) {
                                                    case 0: {
                                                        phi_1135_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1135_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1135_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1135_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1122 = phi_1135_;
                                                switch bitcast<i32>(_e1119) {
                                                    case 0: {
                                                        phi_1145_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1145_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1145_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1145_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1129 = phi_1145_;
                                                local_12 = array<f32, 4>(_e548.member.member.x, _e548.member.member.y, _e548.member.member.z, _e548.member.member.w);
                                                local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_3576_ = _e1045;
                                                phi_1161_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1143 = phi_3576_;
                                                    let _e1145 = phi_1161_;
                                                    if (_e1145.member < _e1145.member_1) {
                                                        phi_1162_ = type_8((_e1145.member + 1u), _e1145.member_1);
                                                        phi_1185_ = type_8(1u, _e1145.member);
                                                    } else {
                                                        phi_1162_ = _e1145;
                                                        phi_1185_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1158 = phi_1162_;
                                                    let _e1160 = phi_1185_;
                                                    let _e1164 = (bitcast<i32>(_e1160.member) != 0i);
                                                    if _e1164 {
                                                        let _e1166 = ((_e557 + (_e1064.member_1 * ((3u * _e1122) + 1u))) + (_e1160.member_1 * _e1129));
                                                        let _e1167 = (_e1166 < _e95);
                                                        if _e1167 {
                                                            if _e1167 {
                                                            } else {
                                                                phi_3647_ = true;
                                                                break;
                                                            }
                                                            let _e1169 = global_5.member[_e1166];
                                                            phi_1208_ = _e1169;
                                                        } else {
                                                            phi_1208_ = 0u;
                                                        }
                                                        let _e1171 = phi_1208_;
                                                        let _e1172 = (_e1166 + 1u);
                                                        let _e1173 = (_e1172 < _e95);
                                                        if _e1173 {
                                                            if _e1173 {
                                                            } else {
                                                                phi_3647_ = true;
                                                                break;
                                                            }
                                                            let _e1175 = global_5.member[_e1172];
                                                            phi_1223_ = _e1175;
                                                        } else {
                                                            phi_1223_ = 0u;
                                                        }
                                                        let _e1177 = phi_1223_;
                                                        phi_1226_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1179 = phi_1226_;
                                                            if (_e1179.member < _e1179.member_1) {
                                                                phi_1227_ = type_8((_e1179.member + 1u), _e1179.member_1);
                                                                phi_1250_ = type_8(1u, _e1179.member);
                                                            } else {
                                                                phi_1227_ = _e1179;
                                                                phi_1250_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1192 = phi_1227_;
                                                            let _e1194 = phi_1250_;
                                                            let _e1198 = (bitcast<i32>(_e1194.member) != 0i);
                                                            if _e1198 {
                                                                let _e1199 = (_e1194.member_1 < 3u);
                                                                if _e1199 {
                                                                } else {
                                                                    phi_3569_ = true;
                                                                    break;
                                                                }
                                                                let _e1201 = local_10[_e1194.member_1];
                                                                if (_e1194.member_1 < 4u) {
                                                                } else {
                                                                    phi_3569_ = true;
                                                                    break;
                                                                }
                                                                let _e1204 = local_12[_e1194.member_1];
                                                                switch bitcast<i32>(_e1119) {
                                                                    case 0: {
                                                                        phi_1320_ = (_e1204 + (f32(((_e1171 >> bitcast<u32>(((10u * _e1201) & 31u))) & 1023u)) * _e143));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1201 == 0u) {
                                                                            phi_1297_ = _e1171;
                                                                        } else {
                                                                            if (_e1201 == 1u) {
                                                                                phi_1296_ = ((_e1171 >> bitcast<u32>(21i)) | (_e1177 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_1296_ = (_e1177 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1225 = phi_1296_;
                                                                            phi_1297_ = _e1225;
                                                                        }
                                                                        let _e1227 = phi_1297_;
                                                                        phi_1320_ = (_e1204 + (f32((_e1227 & 2097151u)) * _e143));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1206 = (_e1166 + _e1201);
                                                                        let _e1207 = (_e1206 < _e95);
                                                                        if _e1207 {
                                                                            if _e1207 {
                                                                            } else {
                                                                                phi_3569_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1209 = global_5.member[_e1206];
                                                                            phi_1316_ = _e1209;
                                                                        } else {
                                                                            phi_1316_ = 0u;
                                                                        }
                                                                        let _e1211 = phi_1316_;
                                                                        phi_1320_ = (f32(bitcast<i32>(_e1211)) * _e143);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_1320_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1241 = phi_1320_;
                                                                if (_e1160.member_1 < 3u) {
                                                                } else {
                                                                    phi_3569_ = true;
                                                                    break;
                                                                }
                                                                if _e1199 {
                                                                } else {
                                                                    phi_3569_ = true;
                                                                    break;
                                                                }
                                                                local_11[_e1160.member_1][_e1194.member_1] = _e1241;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1226_ = _e1192;
                                                                phi_3569_ = _e1143;
                                                                break if !(_e1198);
                                                            }
                                                        }
                                                        let _e1247 = phi_3569_;
                                                        phi_3647_ = _e1247;
                                                        if _e1247 {
                                                            break;
                                                        }
                                                        phi_3648_ = _e1247;
                                                    } else {
                                                        phi_3648_ = _e1143;
                                                    }
                                                    let _e1249 = phi_3648_;
                                                    continue;
                                                    continuing {
                                                        phi_3576_ = _e1249;
                                                        phi_1161_ = _e1158;
                                                        phi_3647_ = _e1249;
                                                        break if !(_e1164);
                                                    }
                                                }
                                                let _e1252 = phi_3647_;
                                                phi_3649_ = _e1252;
                                                if _e1252 {
                                                    break;
                                                }
                                                let _e1253 = local_11;
                                                let _e1270 = (_e1253[0][2] - _e389);
                                                let _e1273 = (((_e1253[0][0] - _e312) * _e413) - (_e1270 * _e337));
                                                let _e1276 = (((_e1253[0][1] - _e351) * _e413) - (_e1270 * _e375));
                                                let _e1279 = (_e1253[1][2] - _e389);
                                                let _e1282 = (((_e1253[1][0] - _e312) * _e413) - (_e1279 * _e337));
                                                let _e1285 = (((_e1253[1][1] - _e351) * _e413) - (_e1279 * _e375));
                                                let _e1288 = (_e1253[2][2] - _e389);
                                                let _e1291 = (((_e1253[2][0] - _e312) * _e413) - (_e1288 * _e337));
                                                let _e1294 = (((_e1253[2][1] - _e351) * _e413) - (_e1288 * _e375));
                                                let _e1295 = (_e1291 * _e1285);
                                                let _e1296 = (_e1294 * _e1282);
                                                let _e1297 = (_e1273 * _e1294);
                                                let _e1298 = (_e1276 * _e1291);
                                                let _e1299 = (_e1282 * _e1276);
                                                let _e1300 = (_e1285 * _e1273);
                                                let _e1305 = (((_e1295 >= _e1296) && (_e1297 >= _e1298)) && (_e1299 >= _e1300));
                                                if (_e1305 || (((_e1295 <= _e1296) && (_e1297 <= _e1298)) && (_e1299 <= _e1300))) {
                                                    let _e1312 = select(-1f, 1f, _e1305);
                                                    let _e1314 = ((_e1295 - _e1296) * _e1312);
                                                    let _e1316 = select(0f, _e1314, (_e1314 > 0f));
                                                    let _e1318 = ((_e1297 - _e1298) * _e1312);
                                                    let _e1320 = select(0f, _e1318, (_e1318 > 0f));
                                                    let _e1322 = ((_e1299 - _e1300) * _e1312);
                                                    let _e1324 = select(0f, _e1322, (_e1322 > 0f));
                                                    let _e1326 = ((_e1316 + _e1320) + _e1324);
                                                    if (_e1326 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1915_ = type_24();
                                                        phi_1916_ = true;
                                                    } else {
                                                        let _e1329 = select(_e1253[1][0], _e1253[0][0], (_e1253[0][0] < _e1253[1][0]));
                                                        let _e1333 = select(_e1253[1][0], _e1253[0][0], (_e1253[0][0] > _e1253[1][0]));
                                                        let _e1337 = select(_e1253[1][1], _e1253[0][1], (_e1253[0][1] < _e1253[1][1]));
                                                        let _e1341 = select(_e1253[1][1], _e1253[0][1], (_e1253[0][1] > _e1253[1][1]));
                                                        let _e1345 = select(_e1253[1][2], _e1253[0][2], (_e1253[0][2] < _e1253[1][2]));
                                                        let _e1349 = select(_e1253[1][2], _e1253[0][2], (_e1253[0][2] > _e1253[1][2]));
                                                        let _e1354 = ((select(_e1253[2][0], _e1329, (_e1329 < _e1253[2][0])) - _e335) * _e340);
                                                        let _e1355 = ((select(_e1253[2][0], _e1333, (_e1333 > _e1253[2][0])) - _e336) * _e340);
                                                        let _e1358 = ((select(_e1253[2][1], _e1337, (_e1337 < _e1253[2][1])) - _e373) * _e378);
                                                        let _e1359 = ((select(_e1253[2][1], _e1341, (_e1341 > _e1253[2][1])) - _e374) * _e378);
                                                        let _e1362 = ((select(_e1253[2][2], _e1345, (_e1345 < _e1253[2][2])) - _e411) * _e416);
                                                        let _e1363 = ((select(_e1253[2][2], _e1349, (_e1349 > _e1253[2][2])) - _e412) * _e416);
                                                        let _e1365 = select(_e1363, _e1362, (_e1362 < _e1363));
                                                        let _e1367 = select(_e1363, _e1362, (_e1362 > _e1363));
                                                        let _e1369 = select(_e1355, _e1354, (_e1354 < _e1355));
                                                        let _e1371 = select(_e1359, _e1358, (_e1358 < _e1359));
                                                        let _e1373 = select(_e1371, _e1369, (_e1369 > _e1371));
                                                        let _e1375 = select(_e1365, _e1373, (_e1373 > _e1365));
                                                        let _e1377 = select(_e1355, _e1354, (_e1354 > _e1355));
                                                        let _e1379 = select(_e1359, _e1358, (_e1358 > _e1359));
                                                        let _e1381 = select(_e1379, _e1377, (_e1377 < _e1379));
                                                        let _e1383 = select(_e1367, _e1381, (_e1381 < _e1367));
                                                        let _e1384 = -(_e1365);
                                                        let _e1390 = select(_e463, _e1375, (_e1375 > _e463));
                                                        if (_e1390 > (_e1383 + (select(_e1384, _e1367, (_e1367 > _e1384)) * 0.0000019073523f))) {
                                                            phi_1910_ = type_24();
                                                            phi_1911_ = true;
                                                        } else {
                                                            let _e1392 = (_e1390 > _e1047.member.member_1);
                                                            if _e1392 {
                                                                phi_1909_ = type_24();
                                                            } else {
                                                                let _e1396 = (_e1253[1][0] - _e1253[0][0]);
                                                                let _e1397 = (_e1253[1][1] - _e1253[0][1]);
                                                                let _e1398 = (_e1253[1][2] - _e1253[0][2]);
                                                                let _e1399 = vec3<f32>(_e1396, _e1397, _e1398);
                                                                let _e1400 = (_e1253[2][0] - _e1253[1][0]);
                                                                let _e1401 = (_e1253[2][1] - _e1253[1][1]);
                                                                let _e1402 = (_e1253[2][2] - _e1253[1][2]);
                                                                let _e1403 = vec3<f32>(_e1400, _e1401, _e1402);
                                                                let _e1404 = (_e1253[0][0] - _e1253[2][0]);
                                                                let _e1405 = (_e1253[0][1] - _e1253[2][1]);
                                                                let _e1406 = (_e1253[0][2] - _e1253[2][2]);
                                                                let _e1407 = vec3<f32>(_e1404, _e1405, _e1406);
                                                                let _e1410 = bitcast<f32>((bitcast<u32>(_e1396) & 2147483647u));
                                                                let _e1413 = bitcast<f32>((bitcast<u32>(_e1397) & 2147483647u));
                                                                let _e1415 = select(_e1413, _e1410, (_e1410 > _e1413));
                                                                let _e1418 = bitcast<f32>((bitcast<u32>(_e1398) & 2147483647u));
                                                                let _e1420 = select(_e1418, _e1415, (_e1415 > _e1418));
                                                                let _e1423 = bitcast<f32>((bitcast<u32>(_e1400) & 2147483647u));
                                                                let _e1426 = bitcast<f32>((bitcast<u32>(_e1401) & 2147483647u));
                                                                let _e1428 = select(_e1426, _e1423, (_e1423 > _e1426));
                                                                let _e1431 = bitcast<f32>((bitcast<u32>(_e1402) & 2147483647u));
                                                                let _e1433 = select(_e1431, _e1428, (_e1428 > _e1431));
                                                                let _e1436 = bitcast<f32>((bitcast<u32>(_e1404) & 2147483647u));
                                                                let _e1439 = bitcast<f32>((bitcast<u32>(_e1405) & 2147483647u));
                                                                let _e1441 = select(_e1439, _e1436, (_e1436 > _e1439));
                                                                let _e1444 = bitcast<f32>((bitcast<u32>(_e1406) & 2147483647u));
                                                                let _e1446 = select(_e1444, _e1441, (_e1441 > _e1444));
                                                                let _e1448 = select(_e1433, _e1420, (_e1420 > _e1433));
                                                                let _e1450 = select(_e1446, _e1448, (_e1448 > _e1446));
                                                                if (_e1420 == _e1450) {
                                                                    phi_1820_ = _e1403;
                                                                    phi_1821_ = _e1407;
                                                                } else {
                                                                    let _e1453 = vec3((_e1433 == _e1450));
                                                                    phi_1820_ = select(_e1399, _e1407, _e1453);
                                                                    phi_1821_ = select(_e1403, _e1399, _e1453);
                                                                }
                                                                let _e1457 = phi_1820_;
                                                                let _e1459 = phi_1821_;
                                                                let _e1466 = ((_e1457.y * _e1459.z) - (_e1459.y * _e1457.z));
                                                                let _e1471 = ((_e1457.z * _e1459.x) - (_e1459.z * _e1457.x));
                                                                let _e1474 = ((_e1457.x * _e1459.y) - (_e1459.x * _e1457.y));
                                                                if (_e1316 >= _e1320) {
                                                                    phi_1852_ = select(true, false, (_e1316 >= _e1324));
                                                                } else {
                                                                    phi_1852_ = true;
                                                                }
                                                                let _e1479 = phi_1852_;
                                                                if _e1479 {
                                                                    phi_1861_ = select(vec3<f32>(_e1253[2][0], _e1253[2][1], _e1253[2][2]), vec3<f32>(_e1253[1][0], _e1253[1][1], _e1253[1][2]), vec3((_e1320 >= _e1324)));
                                                                } else {
                                                                    phi_1861_ = vec3<f32>(_e1253[0][0], _e1253[0][1], _e1253[0][2]);
                                                                }
                                                                let _e1484 = phi_1861_;
                                                                let _e1501 = ((((_e1466 * (_e1484.x - _e312)) + (_e1471 * (_e1484.y - _e351))) + (_e1474 * (_e1484.z - _e389))) / (((_e1466 * _e337) + (_e1471 * _e375)) + (_e1474 * _e413)));
                                                                let _e1503 = select(_e1383, _e1501, (_e1501 < _e1383));
                                                                let _e1505 = select(_e1375, _e1503, (_e1503 > _e1375));
                                                                if (_e1505 >= _e463) {
                                                                    let _e1507 = (_e1505 <= _e1047.member.member_1);
                                                                    if _e1507 {
                                                                        let _e1508 = (1f / _e1326);
                                                                        phi_1901_ = type_24(_e1505, (_e1320 * _e1508), (_e1324 * _e1508), _e1113);
                                                                    } else {
                                                                        phi_1901_ = type_24();
                                                                    }
                                                                    let _e1513 = phi_1901_;
                                                                    phi_1903_ = _e1513;
                                                                    phi_1904_ = select(true, false, _e1507);
                                                                } else {
                                                                    phi_1903_ = type_24();
                                                                    phi_1904_ = true;
                                                                }
                                                                let _e1516 = phi_1903_;
                                                                let _e1518 = phi_1904_;
                                                                if _e1518 {
                                                                    phi_1908_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1908_ = _e1516;
                                                                }
                                                                let _e1520 = phi_1908_;
                                                                phi_1909_ = _e1520;
                                                            }
                                                            let _e1522 = phi_1909_;
                                                            phi_1910_ = _e1522;
                                                            phi_1911_ = _e1392;
                                                        }
                                                        let _e1524 = phi_1910_;
                                                        let _e1526 = phi_1911_;
                                                        phi_1915_ = _e1524;
                                                        phi_1916_ = _e1526;
                                                    }
                                                    let _e1528 = phi_1915_;
                                                    let _e1530 = phi_1916_;
                                                    phi_1920_ = _e1528;
                                                    phi_1921_ = _e1530;
                                                } else {
                                                    phi_1920_ = type_24();
                                                    phi_1921_ = true;
                                                }
                                                let _e1532 = phi_1920_;
                                                let _e1534 = phi_1921_;
                                                if _e1534 {
                                                    phi_1925_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1925_ = _e1532;
                                                }
                                                let _e1536 = phi_1925_;
                                                if (_e1536.member_3 != 4294967295u) {
                                                    if (_e1113 != 4294967295u) {
                                                        if (_e1536.member < _e1047.member.member.member) {
                                                            phi_1951_ = true;
                                                        } else {
                                                            if (_e1536.member == _e1047.member.member.member) {
                                                                phi_1950_ = (_e1536.member_3 < _e1047.member.member.member_3);
                                                            } else {
                                                                phi_1950_ = false;
                                                            }
                                                            let _e1551 = phi_1950_;
                                                            phi_1951_ = _e1551;
                                                        }
                                                        let _e1553 = phi_1951_;
                                                        if _e1553 {
                                                            phi_1958_ = type_39(type_33(_e1536, _e1536.member), _e1074.member_1, _e1074.member_2);
                                                        } else {
                                                            phi_1958_ = _e1074;
                                                        }
                                                        let _e1560 = phi_1958_;
                                                        phi_1959_ = _e1560;
                                                    } else {
                                                        phi_1959_ = _e1074;
                                                    }
                                                    let _e1562 = phi_1959_;
                                                    phi_1960_ = _e1562;
                                                } else {
                                                    phi_1960_ = _e1074;
                                                }
                                                let _e1564 = phi_1960_;
                                                phi_3650_ = _e1252;
                                                phi_991_ = _e1564;
                                            } else {
                                                phi_3650_ = _e1045;
                                                phi_991_ = type_39();
                                            }
                                            let _e1566 = phi_3650_;
                                            let _e1568 = phi_991_;
                                            continue;
                                            continuing {
                                                phi_3591_ = _e1566;
                                                phi_990_ = _e1568;
                                                phi_993_ = _e1062;
                                                phi_3649_ = _e1566;
                                                break if !(_e1068);
                                            }
                                        }
                                        let _e1571 = phi_3649_;
                                        phi_3708_ = _e1571;
                                        if _e1571 {
                                            break;
                                        }
                                        phi_3712_ = _e1571;
                                        let _e1749 = local_15;
                                        phi_3345_ = _e1749;
                                        phi_3346_ = _e548;
                                        phi_3347_ = false;
                                        phi_3348_ = _e552;
                                    } else {
                                        if (_e548.member_1 >= _e92) {
                                            phi_2901_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e548.member_1 < _e92) {
                                            } else {
                                                phi_3708_ = true;
                                                break;
                                            }
                                            let _e572 = ((1u + (_e263 * 2u)) % 7u);
                                            if (_e572 < 7u) {
                                            } else {
                                                phi_3708_ = true;
                                                break;
                                            }
                                            let _e577 = global_4.member[_e548.member_1][_e572];
                                            let _e580 = ((1u + (_e262 * 2u)) % 7u);
                                            if (_e580 < 7u) {
                                            } else {
                                                phi_3708_ = true;
                                                break;
                                            }
                                            let _e585 = global_4.member[_e548.member_1][_e580];
                                            let _e588 = ((1u + (_e264 * 2u)) % 7u);
                                            if (_e588 < 7u) {
                                            } else {
                                                phi_3708_ = true;
                                                break;
                                            }
                                            let _e593 = global_4.member[_e548.member_1][_e588];
                                            let _e596 = (((_e263 + 1u) * 2u) % 7u);
                                            if (_e596 < 7u) {
                                            } else {
                                                phi_3708_ = true;
                                                break;
                                            }
                                            let _e601 = global_4.member[_e548.member_1][_e596];
                                            let _e604 = (((_e262 + 1u) * 2u) % 7u);
                                            if (_e604 < 7u) {
                                            } else {
                                                phi_3708_ = true;
                                                break;
                                            }
                                            let _e609 = global_4.member[_e548.member_1][_e604];
                                            let _e612 = (((_e264 + 1u) * 2u) % 7u);
                                            if (_e612 < 7u) {
                                            } else {
                                                phi_3708_ = true;
                                                break;
                                            }
                                            let _e617 = global_4.member[_e548.member_1][_e612];
                                            let _e640 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.x - _e548.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e641 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.y - _e548.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e642 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.z - _e548.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e644 = select(_e143, _e640, (_e640 > _e143));
                                            let _e646 = select(_e143, _e641, (_e641 > _e143));
                                            let _e648 = select(_e143, _e642, (_e642 > _e143));
                                            let _e673 = bitcast<u32>((f32(bitcast<i32>((_e577 & 2097151u))) * _e644));
                                            let _e678 = (bitcast<i32>((_e577 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e681 = bitcast<f32>((_e673 & bitcast<u32>(_e678)));
                                            let _e682 = bitcast<u32>((f32(bitcast<i32>((_e585 & 2097151u))) * _e646));
                                            let _e687 = (bitcast<i32>((_e585 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e690 = bitcast<f32>((_e682 & bitcast<u32>(_e687)));
                                            let _e691 = bitcast<u32>((f32(bitcast<i32>((_e593 & 2097151u))) * _e648));
                                            let _e696 = (bitcast<i32>((_e593 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e699 = bitcast<f32>((_e691 & bitcast<u32>(_e696)));
                                            let _e703 = bitcast<f32>((_e673 & bitcast<u32>(~(_e678))));
                                            let _e707 = bitcast<f32>((_e682 & bitcast<u32>(~(_e687))));
                                            let _e711 = bitcast<f32>((_e691 & bitcast<u32>(~(_e696))));
                                            let _e712 = bitcast<u32>((f32(bitcast<i32>((_e601 & 2097151u))) * _e644));
                                            let _e717 = (bitcast<i32>((_e601 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e720 = bitcast<f32>((_e712 & bitcast<u32>(_e717)));
                                            let _e721 = bitcast<u32>((f32(bitcast<i32>((_e609 & 2097151u))) * _e646));
                                            let _e726 = (bitcast<i32>((_e609 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e729 = bitcast<f32>((_e721 & bitcast<u32>(_e726)));
                                            let _e730 = bitcast<u32>((f32(bitcast<i32>((_e617 & 2097151u))) * _e648));
                                            let _e735 = (bitcast<i32>((_e617 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e738 = bitcast<f32>((_e730 & bitcast<u32>(_e735)));
                                            let _e742 = bitcast<f32>((_e712 & bitcast<u32>(~(_e717))));
                                            let _e746 = bitcast<f32>((_e721 & bitcast<u32>(~(_e726))));
                                            let _e750 = bitcast<f32>((_e730 & bitcast<u32>(~(_e735))));
                                            let _e751 = (_e548.member.member.x + _e681);
                                            let _e752 = (_e548.member.member.y + _e690);
                                            let _e753 = (_e548.member.member.z + _e699);
                                            let _e756 = (_e548.member.member_1.x - _e720);
                                            let _e757 = (_e548.member.member_1.y - _e729);
                                            let _e758 = (_e548.member.member_1.z - _e738);
                                            let _e777 = (_e756 - _e751);
                                            let _e778 = (_e757 - _e752);
                                            let _e779 = (_e758 - _e753);
                                            let _e781 = select(_e778, _e777, (_e777 > _e778));
                                            let _e783 = select(_e779, _e781, (_e781 > _e779));
                                            if (_e783 < (1024f * _e143)) {
                                                phi_2602_ = 0u;
                                            } else {
                                                phi_2602_ = select(2u, 1u, (_e783 < (2097152f * _e143)));
                                            }
                                            let _e790 = phi_2602_;
                                            switch bitcast<i32>(_e790) {
                                                case 0: {
                                                    phi_2608_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2608_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2608_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2608_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e793 = phi_2608_;
                                            let _e799 = global_4.member[_e548.member_1][0u];
                                            let _e803 = global_4.member[_e548.member_1][2u];
                                            let _e807 = global_4.member[_e548.member_1][4u];
                                            let _e811 = global_4.member[_e548.member_1][6u];
                                            let _e823 = (((_e803 >> bitcast<u32>(22i)) | ((_e807 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e811 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e824 = (_e799 & 268435455u);
                                            let _e825 = (_e823 & 268435455u);
                                            let _e828 = ((_e799 >> bitcast<u32>(28u)) & 7u);
                                            let _e836 = ((_e799 >> bitcast<u32>(31i)) | (((_e823 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e837 = (_e828 != 0u);
                                            if (_e828 == 0u) {
                                                phi_2863_ = _e824;
                                            } else {
                                                if (_e828 == 7u) {
                                                    phi_2862_ = 2147483648u;
                                                } else {
                                                    phi_2862_ = ((2147483648u | (_e828 << bitcast<u32>(28u))) | (_e825 & 268435455u));
                                                }
                                                let _e846 = phi_2862_;
                                                phi_2863_ = _e846;
                                            }
                                            let _e848 = phi_2863_;
                                            if _e837 {
                                                let _e849 = (_e828 != 7u);
                                                if _e849 {
                                                    phi_2873_ = (_e825 + (_e828 * ((3u * _e793) + 1u)));
                                                } else {
                                                    phi_2873_ = u32();
                                                }
                                                let _e853 = phi_2873_;
                                                phi_2875_ = _e853;
                                                phi_2876_ = select(true, false, _e849);
                                            } else {
                                                phi_2875_ = u32();
                                                phi_2876_ = true;
                                            }
                                            let _e856 = phi_2875_;
                                            let _e858 = phi_2876_;
                                            if (_e836 == 0u) {
                                                phi_2897_ = (_e824 + select(0u, 1u, !(_e837)));
                                            } else {
                                                if (_e836 == 7u) {
                                                    phi_2896_ = 2147483648u;
                                                } else {
                                                    phi_2896_ = ((2147483648u | (_e836 << bitcast<u32>(28u))) | (select(_e856, _e825, _e858) & 268435455u));
                                                }
                                                let _e871 = phi_2896_;
                                                phi_2897_ = _e871;
                                            }
                                            let _e873 = phi_2897_;
                                            phi_2901_ = type_55(array<vec4<f32>, 3>(vec4<f32>(_e751, (_e548.member.member.x + _e703), _e756, (_e548.member.member_1.x - _e742)), vec4<f32>(_e752, (_e548.member.member.y + _e707), _e757, (_e548.member.member_1.y - _e746)), vec4<f32>(_e753, (_e548.member.member.z + _e711), _e758, (_e548.member.member_1.z - _e750))), type_54(type_28((_e548.member.member + vec4<f32>(_e681, _e690, _e699, 0f)), (_e548.member.member_1 - vec4<f32>(_e720, _e729, _e738, 0f))), _e848), type_54(type_28((_e548.member.member + vec4<f32>(_e703, _e707, _e711, 0f)), (_e548.member.member_1 - vec4<f32>(_e742, _e746, _e750, 0f))), _e873));
                                        }
                                        let _e878 = phi_2901_;
                                        let _e891 = ((_e878.member[0].x - _e335) * _e340);
                                        let _e892 = ((_e878.member[0].y - _e335) * _e340);
                                        let _e893 = ((_e878.member[0].z - _e336) * _e340);
                                        let _e894 = ((_e878.member[0].w - _e336) * _e340);
                                        let _e904 = ((_e878.member[1].x - _e373) * _e378);
                                        let _e905 = ((_e878.member[1].y - _e373) * _e378);
                                        let _e906 = ((_e878.member[1].z - _e374) * _e378);
                                        let _e907 = ((_e878.member[1].w - _e374) * _e378);
                                        let _e917 = ((_e878.member[2].x - _e411) * _e416);
                                        let _e918 = ((_e878.member[2].y - _e411) * _e416);
                                        let _e919 = ((_e878.member[2].z - _e412) * _e416);
                                        let _e920 = ((_e878.member[2].w - _e412) * _e416);
                                        let _e922 = select(_e919, _e917, (_e917 < _e919));
                                        let _e924 = select(_e920, _e918, (_e918 < _e920));
                                        let _e926 = select(_e919, _e917, (_e917 > _e919));
                                        let _e928 = select(_e920, _e918, (_e918 > _e920));
                                        let _e930 = select(_e893, _e891, (_e891 < _e893));
                                        let _e932 = select(_e894, _e892, (_e892 < _e894));
                                        let _e934 = select(_e906, _e904, (_e904 < _e906));
                                        let _e936 = select(_e907, _e905, (_e905 < _e907));
                                        let _e938 = select(_e934, _e930, (_e930 > _e934));
                                        let _e940 = select(_e936, _e932, (_e932 > _e936));
                                        let _e942 = select(_e922, _e938, (_e938 > _e922));
                                        let _e944 = select(_e924, _e940, (_e940 > _e924));
                                        let _e946 = select(_e893, _e891, (_e891 > _e893));
                                        let _e948 = select(_e894, _e892, (_e892 > _e894));
                                        let _e950 = select(_e906, _e904, (_e904 > _e906));
                                        let _e952 = select(_e907, _e905, (_e905 > _e907));
                                        let _e954 = select(_e950, _e946, (_e946 < _e950));
                                        let _e956 = select(_e952, _e948, (_e948 < _e952));
                                        let _e961 = -(_e922);
                                        let _e962 = -(_e924);
                                        let _e969 = (select(_e926, _e954, (_e954 < _e926)) + (select(_e961, _e926, (_e926 > _e961)) * 0.0000019073523f));
                                        let _e970 = (select(_e928, _e956, (_e956 < _e928)) + (select(_e962, _e928, (_e928 > _e962)) * 0.0000019073523f));
                                        let _e972 = select(_e463, _e942, (_e942 > _e463));
                                        let _e974 = select(_e463, _e944, (_e944 > _e463));
                                        let _e979 = (_e972 <= select(_e508.member.member_1, _e969, (_e969 < _e508.member.member_1)));
                                        let _e980 = (_e974 <= select(_e508.member.member_1, _e970, (_e970 < _e508.member.member_1)));
                                        let _e981 = (_e972 <= _e974);
                                        if _e979 {
                                            if _e980 {
                                                if _e981 {
                                                    phi_3245_ = _e878.member_2;
                                                } else {
                                                    phi_3245_ = _e878.member_1;
                                                }
                                                let _e985 = phi_3245_;
                                                let _e1007 = (_e552 % 128u);
                                                let _e1008 = (_e1007 < 128u);
                                                if _e1008 {
                                                } else {
                                                    phi_3708_ = true;
                                                    break;
                                                }
                                                local_8[_e1007] = _e985.member_1;
                                                if _e1008 {
                                                } else {
                                                    phi_3708_ = true;
                                                    break;
                                                }
                                                local_7[_e1007] = _e985.member.member.x;
                                                if _e1008 {
                                                } else {
                                                    phi_3708_ = true;
                                                    break;
                                                }
                                                local_6[_e1007] = _e985.member.member.y;
                                                if _e1008 {
                                                } else {
                                                    phi_3708_ = true;
                                                    break;
                                                }
                                                local_5[_e1007] = _e985.member.member.z;
                                                if _e1008 {
                                                } else {
                                                    phi_3708_ = true;
                                                    break;
                                                }
                                                local_4[_e1007] = _e985.member.member_1.x;
                                                if _e1008 {
                                                } else {
                                                    phi_3708_ = true;
                                                    break;
                                                }
                                                local_3[_e1007] = _e985.member.member_1.y;
                                                if _e1008 {
                                                } else {
                                                    phi_3708_ = true;
                                                    break;
                                                }
                                                local_2[_e1007] = _e985.member.member_1.z;
                                                if _e1008 {
                                                } else {
                                                    phi_3708_ = true;
                                                    break;
                                                }
                                                local_9[_e1007] = select(_e974, _e972, (_e972 > _e974));
                                                if _e981 {
                                                    phi_3322_ = _e878.member_1;
                                                } else {
                                                    phi_3322_ = _e878.member_2;
                                                }
                                                let _e1021 = phi_3322_;
                                                phi_3323_ = _e1021;
                                                phi_3324_ = (_e552 + 1u);
                                            } else {
                                                phi_3323_ = type_54();
                                                phi_3324_ = u32();
                                            }
                                            let _e1023 = phi_3323_;
                                            let _e1025 = phi_3324_;
                                            phi_3326_ = _e1023;
                                            phi_3327_ = _e1025;
                                            phi_3328_ = select(true, false, _e980);
                                        } else {
                                            phi_3326_ = type_54();
                                            phi_3327_ = u32();
                                            phi_3328_ = true;
                                        }
                                        let _e1028 = phi_3326_;
                                        let _e1030 = phi_3327_;
                                        let _e1032 = phi_3328_;
                                        if _e1032 {
                                            if _e979 {
                                                phi_3337_ = _e878.member_1;
                                            } else {
                                                phi_3337_ = _e878.member_2;
                                            }
                                            let _e1036 = phi_3337_;
                                            phi_3342_ = _e1036;
                                            phi_3343_ = select(_e980, true, _e979);
                                        } else {
                                            phi_3342_ = _e1028;
                                            phi_3343_ = _e550;
                                        }
                                        let _e1039 = phi_3342_;
                                        let _e1041 = phi_3343_;
                                        phi_3712_ = _e506;
                                        phi_3345_ = type_39(_e508.member, (_e508.member_1 + 1u), _e508.member_2);
                                        phi_3346_ = _e1039;
                                        phi_3347_ = _e1041;
                                        phi_3348_ = select(_e1030, _e552, _e1032);
                                    }
                                    let _e1573 = phi_3712_;
                                    let _e1575 = phi_3345_;
                                    let _e1577 = phi_3346_;
                                    let _e1579 = phi_3347_;
                                    let _e1581 = phi_3348_;
                                    phi_3711_ = _e1573;
                                    phi_3349_ = _e1575;
                                    phi_3350_ = _e1577;
                                    phi_3351_ = (_e512 - 1u);
                                    phi_3352_ = _e1579;
                                    phi_3353_ = _e1581;
                                } else {
                                    phi_3711_ = _e506;
                                    phi_3349_ = _e508;
                                    phi_3350_ = _e548;
                                    phi_3351_ = _e512;
                                    phi_3352_ = _e550;
                                    phi_3353_ = _e552;
                                }
                                let _e1583 = phi_3711_;
                                let _e1585 = phi_3349_;
                                let _e1587 = phi_3350_;
                                let _e1589 = phi_3351_;
                                let _e1591 = phi_3352_;
                                let _e1593 = phi_3353_;
                                phi_3710_ = _e1583;
                                phi_3354_ = _e1585;
                                phi_3355_ = _e1587;
                                phi_3356_ = _e1589;
                                phi_3357_ = _e1591;
                                phi_3358_ = _e1593;
                            } else {
                                phi_3710_ = _e506;
                                phi_3354_ = type_39();
                                phi_3355_ = type_54();
                                phi_3356_ = u32();
                                phi_3357_ = bool();
                                phi_3358_ = u32();
                            }
                            let _e1595 = phi_3710_;
                            let _e1597 = phi_3354_;
                            let _e1599 = phi_3355_;
                            let _e1601 = phi_3356_;
                            let _e1603 = phi_3357_;
                            let _e1605 = phi_3358_;
                            phi_3709_ = _e1595;
                            phi_864_ = _e1597;
                            phi_867_ = _e1599;
                            phi_869_ = _e1601;
                            phi_871_ = _e1603;
                            phi_873_ = _e1605;
                            phi_3359_ = _e520;
                        } else {
                            phi_3709_ = _e506;
                            phi_864_ = type_39();
                            phi_867_ = type_54();
                            phi_869_ = u32();
                            phi_871_ = bool();
                            phi_873_ = u32();
                            phi_3359_ = false;
                        }
                        let _e1607 = phi_3709_;
                        let _e1609 = phi_864_;
                        let _e1611 = phi_867_;
                        let _e1613 = phi_869_;
                        let _e1615 = phi_871_;
                        let _e1617 = phi_873_;
                        let _e1619 = phi_3359_;
                        continue;
                        continuing {
                            phi_3594_ = _e1607;
                            phi_863_ = _e1609;
                            phi_866_ = _e1611;
                            phi_868_ = _e1613;
                            phi_870_ = _e1615;
                            phi_872_ = _e1617;
                            phi_3708_ = _e1607;
                            break if !(_e1619);
                        }
                    }
                    let _e1622 = phi_3708_;
                    if _e1622 {
                        break;
                    }
                    let _e1624 = local_13;
                    let _e1627 = local_14;
                    if _e151 {
                    } else {
                        break;
                    }
                    global_6.member[_e149][0u] = _e1624.member_1;
                    global_6.member[_e149][1u] = _e1627.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
