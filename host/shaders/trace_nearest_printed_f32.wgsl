struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: array<type_23>,
}

struct type_36 {
    member: array<array<type_22, 8>>,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_46 {
    member: array<type_44>,
}

struct type_49 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_51 {
    member: type_49,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_42;
@group(0) @binding(4) 
var<storage> global_4: type_32;
@group(0) @binding(2) 
var<storage> global_5: type_46;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_36;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<type_22, 8>;
    var local_8: array<f32, 128>;
    var local_9: array<f32, 3>;
    var local_10: array<f32, 3>;
    var phi_338_: i32;
    var phi_339_: i32;
    var phi_349_: bool;
    var phi_359_: u32;
    var phi_360_: u32;
    var phi_362_: bool;
    var phi_367_: u32;
    var phi_379_: i32;
    var phi_399_: i32;
    var phi_417_: f32;
    var phi_423_: f32;
    var phi_434_: f32;
    var phi_440_: f32;
    var phi_463_: f32;
    var phi_474_: f32;
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
    var phi_706_: f32;
    var phi_707_: f32;
    var phi_3261_: bool;
    var phi_3217_: f32;
    var phi_833_: type_51;
    var phi_836_: u32;
    var phi_838_: bool;
    var phi_840_: u32;
    var phi_851_: bool;
    var phi_938_: type_51;
    var phi_939_: bool;
    var phi_940_: u32;
    var phi_2055_: type_44;
    var phi_2888_: type_51;
    var phi_2965_: type_51;
    var phi_2966_: type_51;
    var phi_2967_: u32;
    var phi_2969_: type_51;
    var phi_2970_: u32;
    var phi_2971_: bool;
    var phi_2978_: type_51;
    var phi_2983_: type_51;
    var phi_2984_: bool;
    var phi_3258_: bool;
    var phi_3248_: f32;
    var phi_958_: type_4;
    var phi_959_: type_4;
    var phi_982_: type_4;
    var phi_1003_: u32;
    var phi_1092_: array<array<f32, 3>, 3>;
    var phi_1210_: bool;
    var phi_1239_: bool;
    var phi_1640_: f32;
    var phi_1641_: f32;
    var phi_1642_: f32;
    var phi_1643_: f32;
    var phi_1644_: vec3<f32>;
    var phi_1645_: vec3<f32>;
    var phi_1646_: vec3<f32>;
    var phi_1647_: vec3<f32>;
    var phi_1678_: bool;
    var phi_1687_: vec3<f32>;
    var phi_1852_: f32;
    var phi_1854_: f32;
    var phi_1855_: bool;
    var phi_1875_: f32;
    var phi_1876_: f32;
    var phi_1899_: type_22;
    var phi_1901_: type_22;
    var phi_1902_: bool;
    var phi_1906_: type_22;
    var phi_1907_: type_22;
    var phi_1908_: type_22;
    var phi_1909_: bool;
    var phi_1913_: type_22;
    var phi_1914_: bool;
    var phi_1915_: type_22;
    var phi_1916_: bool;
    var phi_1917_: bool;
    var phi_1918_: type_22;
    var phi_1919_: bool;
    var phi_1920_: bool;
    var phi_1928_: type_22;
    var phi_1929_: bool;
    var phi_1933_: type_22;
    var phi_1945_: type_4;
    var phi_1948_: type_22;
    var phi_1946_: type_4;
    var phi_1971_: type_4;
    var phi_2003_: bool;
    var phi_2004_: bool;
    var phi_2025_: type_22;
    var phi_1949_: type_22;
    var phi_3249_: bool;
    var phi_3596_: f32;
    var phi_3595_: f32;
    var phi_3394_: bool;
    var phi_3594_: f32;
    var phi_3393_: bool;
    var phi_3593_: f32;
    var phi_3392_: bool;
    var phi_3505_: f32;
    var phi_3391_: bool;
    var phi_3470_: f32;
    var phi_3400_: bool;
    var phi_2986_: type_51;
    var phi_2987_: bool;
    var phi_2988_: u32;
    var phi_3469_: f32;
    var phi_3399_: bool;
    var phi_2989_: type_51;
    var phi_2990_: u32;
    var phi_2991_: bool;
    var phi_2992_: u32;
    var phi_3468_: f32;
    var phi_3398_: bool;
    var phi_2993_: type_51;
    var phi_2994_: u32;
    var phi_2995_: bool;
    var phi_2996_: u32;
    var phi_3467_: f32;
    var phi_3397_: bool;
    var phi_834_: type_51;
    var phi_837_: u32;
    var phi_839_: bool;
    var phi_841_: u32;
    var phi_2997_: bool;
    var phi_3396_: bool;
    var phi_3004_: type_4;
    var phi_3005_: type_4;
    var phi_3028_: type_4;
    var phi_3094_: type_22;
    var phi_3460_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e81 = global;
            let _e84 = arrayLength((&global_5.member));
            let _e86 = arrayLength((&global_2.member));
            let _e94 = global_3.member[0u][0u];
            let _e98 = global_3.member[0u][1u];
            let _e102 = global_3.member[0u][2u];
            let _e106 = global_3.member[1u][0u];
            let _e110 = global_3.member[1u][1u];
            let _e114 = global_3.member[1u][2u];
            let _e118 = global_3.member[1u][3u];
            let _e121 = global_1.member[0u];
            let _e122 = bitcast<i32>(_e121);
            let _e132 = (_e81.x + (_e81.y * 2097152u));
            let _e133 = (_e132 < arrayLength((&global_4.member)));
            if _e133 {
                let _e134 = (_e132 < arrayLength((&global_6.member)));
                if _e134 {
                    if _e133 {
                    } else {
                        break;
                    }
                    let _e142 = global_4.member[_e132].member_2[0u];
                    let _e144 = (bitcast<u32>(_e142) & 2147483647u);
                    let _e149 = global_4.member[_e132].member_2[1u];
                    let _e151 = (bitcast<u32>(_e149) & 2147483647u);
                    let _e156 = global_4.member[_e132].member_2[2u];
                    let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                    let _e163 = global_4.member[_e132].member[0u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_4.member[_e132].member[1u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_4.member[_e132].member[2u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e181 = select(_e151, _e144, (_e151 < _e144));
                    let _e183 = select(_e158, _e181, (_e158 < _e181));
                    let _e185 = select(_e165, _e183, (_e165 < _e183));
                    let _e187 = select(_e172, _e185, (_e172 < _e185));
                    let _e189 = select(_e179, _e187, (_e179 < _e187));
                    let _e193 = global_4.member[_e132].member_1;
                    let _e195 = (bitcast<u32>(_e193) & 2147483647u);
                    let _e202 = global_4.member[_e132].member_3;
                    let _e208 = (((select(_e195, _e189, (_e195 < _e189)) < 2139095040u) && ((bitcast<u32>(_e202) & 2147483647u) <= 2139095040u)) && (_e183 > 0u));
                    if _e208 {
                        let _e211 = (bitcast<u32>(bitcast<f32>(_e183)) & 2147483647u);
                        if (_e211 >= 8388608u) {
                            phi_338_ = (bitcast<i32>((_e211 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_338_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e211)), 32u, (_e211 == 0u))));
                        }
                        let _e225 = phi_338_;
                        phi_339_ = _e225;
                    } else {
                        phi_339_ = 0i;
                    }
                    let _e227 = phi_339_;
                    let _e228 = (_e144 == _e183);
                    if _e228 {
                        phi_349_ = true;
                    } else {
                        phi_349_ = (_e151 == _e183);
                    }
                    let _e231 = phi_349_;
                    let _e232 = select(1u, 0u, _e228);
                    if _e231 {
                        let _e233 = (_e232 + 1u);
                        phi_359_ = _e233;
                        phi_360_ = _e233;
                        phi_362_ = select(true, false, (_e233 == 2u));
                    } else {
                        phi_359_ = u32();
                        phi_360_ = 0u;
                        phi_362_ = true;
                    }
                    let _e237 = phi_359_;
                    let _e239 = phi_360_;
                    let _e241 = phi_362_;
                    if _e241 {
                        phi_367_ = (_e239 + 1u);
                    } else {
                        phi_367_ = 0u;
                    }
                    let _e245 = phi_367_;
                    let _e246 = select(_e237, _e239, _e241);
                    let _e247 = select(_e232, select(2u, _e232, _e231), _e241);
                    if (_e122 < -126i) {
                        phi_379_ = -126i;
                    } else {
                        phi_379_ = select(_e122, 127i, (_e122 > 127i));
                    }
                    let _e252 = phi_379_;
                    let _e257 = bitcast<f32>((bitcast<u32>((_e252 + 127i)) << bitcast<u32>(23i)));
                    let _e263 = bitcast<f32>((bitcast<u32>(((_e122 - _e252) + 127i)) << bitcast<u32>(23i)));
                    let _e264 = -(_e227);
                    if (_e264 < -126i) {
                        phi_399_ = -126i;
                    } else {
                        phi_399_ = select(_e264, 127i, (_e264 > 127i));
                    }
                    let _e269 = phi_399_;
                    let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                    let _e280 = bitcast<f32>((bitcast<u32>(((_e264 - _e269) + 127i)) << bitcast<u32>(23i)));
                    let _e284 = global_4.member[_e132].member;
                    let _e285 = (_e246 == 0u);
                    if _e285 {
                        phi_417_ = _e284[0];
                    } else {
                        phi_417_ = _e284[1];
                    }
                    let _e289 = phi_417_;
                    let _e290 = (_e246 == 2u);
                    if _e290 {
                        phi_423_ = _e284[2];
                    } else {
                        phi_423_ = _e289;
                    }
                    let _e293 = phi_423_;
                    let _e295 = ((_e293 * _e257) * _e263);
                    let _e296 = global_4.member[_e132].member_2;
                    if _e285 {
                        phi_434_ = _e296[0];
                    } else {
                        phi_434_ = _e296[1];
                    }
                    let _e300 = phi_434_;
                    if _e290 {
                        phi_440_ = _e296[2];
                    } else {
                        phi_440_ = _e300;
                    }
                    let _e303 = phi_440_;
                    let _e305 = ((_e303 * _e274) * _e280);
                    let _e309 = (bitcast<f32>((bitcast<u32>(_e305) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e309 {
                        let _e313 = (bitcast<f32>((bitcast<u32>(_e295) & 2147483647u)) * 0.00000011920929f);
                        phi_463_ = select(0.00000000000011368684f, _e313, (_e313 > 0.00000000000011368684f));
                    } else {
                        phi_463_ = 0f;
                    }
                    let _e317 = phi_463_;
                    let _e318 = (_e295 + _e317);
                    let _e319 = (_e295 - _e317);
                    let _e320 = select(_e305, 0f, _e309);
                    if _e309 {
                        phi_474_ = 38685626000000000000000000f;
                    } else {
                        phi_474_ = (1f / _e305);
                    }
                    let _e323 = phi_474_;
                    let _e324 = (_e245 == 0u);
                    if _e324 {
                        phi_483_ = _e284[0];
                    } else {
                        phi_483_ = _e284[1];
                    }
                    let _e328 = phi_483_;
                    let _e329 = (_e245 == 2u);
                    if _e329 {
                        phi_489_ = _e284[2];
                    } else {
                        phi_489_ = _e328;
                    }
                    let _e332 = phi_489_;
                    let _e334 = ((_e332 * _e257) * _e263);
                    if _e324 {
                        phi_500_ = _e296[0];
                    } else {
                        phi_500_ = _e296[1];
                    }
                    let _e338 = phi_500_;
                    if _e329 {
                        phi_506_ = _e296[2];
                    } else {
                        phi_506_ = _e338;
                    }
                    let _e341 = phi_506_;
                    let _e343 = ((_e341 * _e274) * _e280);
                    let _e347 = (bitcast<f32>((bitcast<u32>(_e343) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e347 {
                        let _e351 = (bitcast<f32>((bitcast<u32>(_e334) & 2147483647u)) * 0.00000011920929f);
                        phi_529_ = select(0.00000000000011368684f, _e351, (_e351 > 0.00000000000011368684f));
                    } else {
                        phi_529_ = 0f;
                    }
                    let _e355 = phi_529_;
                    let _e356 = (_e334 + _e355);
                    let _e357 = (_e334 - _e355);
                    let _e358 = select(_e343, 0f, _e347);
                    if _e347 {
                        phi_540_ = 38685626000000000000000000f;
                    } else {
                        phi_540_ = (1f / _e343);
                    }
                    let _e361 = phi_540_;
                    let _e362 = (_e247 == 0u);
                    if _e362 {
                        phi_549_ = _e284[0];
                    } else {
                        phi_549_ = _e284[1];
                    }
                    let _e366 = phi_549_;
                    let _e367 = (_e247 == 2u);
                    if _e367 {
                        phi_555_ = _e284[2];
                    } else {
                        phi_555_ = _e366;
                    }
                    let _e370 = phi_555_;
                    let _e372 = ((_e370 * _e257) * _e263);
                    if _e362 {
                        phi_566_ = _e296[0];
                    } else {
                        phi_566_ = _e296[1];
                    }
                    let _e376 = phi_566_;
                    if _e367 {
                        phi_572_ = _e296[2];
                    } else {
                        phi_572_ = _e376;
                    }
                    let _e379 = phi_572_;
                    let _e381 = ((_e379 * _e274) * _e280);
                    let _e385 = (bitcast<f32>((bitcast<u32>(_e381) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e385 {
                        let _e389 = (bitcast<f32>((bitcast<u32>(_e372) & 2147483647u)) * 0.00000011920929f);
                        phi_595_ = select(0.00000000000011368684f, _e389, (_e389 > 0.00000000000011368684f));
                    } else {
                        phi_595_ = 0f;
                    }
                    let _e393 = phi_595_;
                    let _e394 = (_e372 + _e393);
                    let _e395 = (_e372 - _e393);
                    let _e396 = select(_e381, 0f, _e385);
                    if _e385 {
                        phi_606_ = 38685626000000000000000000f;
                    } else {
                        phi_606_ = (1f / _e381);
                    }
                    let _e399 = phi_606_;
                    let _e402 = bitcast<f32>((bitcast<u32>(_e295) & 2147483647u));
                    let _e405 = bitcast<f32>((bitcast<u32>(_e334) & 2147483647u));
                    let _e407 = select(_e405, _e402, (_e402 > _e405));
                    let _e410 = bitcast<f32>((bitcast<u32>(_e372) & 2147483647u));
                    let _e413 = (_e122 + _e227);
                    if (_e208 && (select(_e410, _e407, (_e407 > _e410)) <= 1099511600000f)) {
                        let _e416 = (_e413 / 3i);
                        let _e423 = bitcast<f32>((bitcast<u32>((_e416 + 127i)) << bitcast<u32>(23i)));
                        let _e430 = bitcast<f32>((bitcast<u32>(((_e413 - (2i * _e416)) + 127i)) << bitcast<u32>(23i)));
                        let _e431 = (((_e193 * _e423) * _e423) * _e430);
                        let _e433 = select(340282350000000000000000000000000000000f, _e431, (_e431 < 340282350000000000000000000000000000000f));
                        let _e438 = (((_e202 * _e423) * _e423) * _e430);
                        let _e440 = select(340282350000000000000000000000000000000f, _e438, (_e438 < 340282350000000000000000000000000000000f));
                        phi_706_ = select(-340282350000000000000000000000000000000f, _e440, (_e440 > -340282350000000000000000000000000000000f));
                        phi_707_ = select(-340282350000000000000000000000000000000f, _e433, (_e433 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_706_ = 0f;
                        phi_707_ = 1f;
                    }
                    let _e444 = phi_706_;
                    let _e446 = phi_707_;
                    local_7 = array<type_22, 8>(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_8 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 3>(bitcast<f32>(_e94), bitcast<f32>(_e98), bitcast<f32>(_e102));
                    let _e450 = (_e246 % 3u);
                    let _e451 = (_e450 < 3u);
                    if _e451 {
                    } else {
                        break;
                    }
                    let _e453 = local_10[_e450];
                    let _e454 = (_e245 % 3u);
                    let _e455 = (_e454 < 3u);
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e457 = local_10[_e454];
                    let _e458 = (_e247 % 3u);
                    let _e459 = (_e458 < 3u);
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e461 = local_10[_e458];
                    local_9 = array<f32, 3>(bitcast<f32>(_e106), bitcast<f32>(_e110), bitcast<f32>(_e114));
                    if _e451 {
                    } else {
                        break;
                    }
                    let _e465 = local_9[_e450];
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e467 = local_9[_e454];
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e469 = local_9[_e458];
                    phi_3261_ = false;
                    phi_3217_ = _e444;
                    phi_833_ = type_51(type_49(array<f32, 3>(_e453, _e457, _e461), array<f32, 3>(_e465, _e467, _e469)), select(0u, 2147483648u, (_e84 == 0u)));
                    phi_836_ = ((3u * _e84) + 1u);
                    phi_838_ = (_e446 <= _e444);
                    phi_840_ = 0u;
                    loop {
                        let _e477 = phi_3261_;
                        let _e479 = phi_3217_;
                        let _e481 = phi_833_;
                        let _e483 = phi_836_;
                        let _e485 = phi_838_;
                        let _e487 = phi_840_;
                        if _e485 {
                            phi_851_ = true;
                        } else {
                            phi_851_ = (_e487 > 0u);
                        }
                        let _e490 = phi_851_;
                        if _e490 {
                            let _e491 = (_e483 > 0u);
                            if _e491 {
                                if _e485 {
                                    phi_938_ = _e481;
                                    phi_939_ = _e485;
                                    phi_940_ = _e487;
                                } else {
                                    let _e492 = (_e487 - 1u);
                                    let _e493 = (_e492 % 128u);
                                    let _e494 = (_e493 < 128u);
                                    if _e494 {
                                    } else {
                                        phi_3396_ = true;
                                        break;
                                    }
                                    let _e496 = local_6[_e493];
                                    if _e494 {
                                    } else {
                                        phi_3396_ = true;
                                        break;
                                    }
                                    let _e498 = local_5[_e493];
                                    if _e494 {
                                    } else {
                                        phi_3396_ = true;
                                        break;
                                    }
                                    let _e500 = local_4[_e493];
                                    if _e494 {
                                    } else {
                                        phi_3396_ = true;
                                        break;
                                    }
                                    let _e502 = local_3[_e493];
                                    if _e494 {
                                    } else {
                                        phi_3396_ = true;
                                        break;
                                    }
                                    let _e505 = local_2[_e493];
                                    if _e494 {
                                    } else {
                                        phi_3396_ = true;
                                        break;
                                    }
                                    let _e507 = local_1[_e493];
                                    if _e494 {
                                    } else {
                                        phi_3396_ = true;
                                        break;
                                    }
                                    let _e509 = local[_e493];
                                    if _e494 {
                                    } else {
                                        phi_3396_ = true;
                                        break;
                                    }
                                    let _e514 = local_8[_e493];
                                    phi_938_ = type_51(type_49(array<f32, 3>(_e498, _e500, _e502), array<f32, 3>(_e505, _e507, _e509)), _e496);
                                    phi_939_ = (_e514 <= _e479);
                                    phi_940_ = _e492;
                                }
                                let _e517 = phi_938_;
                                let _e519 = phi_939_;
                                let _e521 = phi_940_;
                                if _e519 {
                                    if ((_e517.member_1 & 2147483648u) != 0u) {
                                        phi_3258_ = _e477;
                                        phi_3248_ = _e479;
                                        phi_958_ = type_4(0u, ((_e517.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e872 = phi_3258_;
                                            let _e874 = phi_3248_;
                                            let _e876 = phi_958_;
                                            if (_e876.member < _e876.member_1) {
                                                phi_959_ = type_4((_e876.member + 1u), _e876.member_1);
                                                phi_982_ = type_4(1u, _e876.member);
                                            } else {
                                                phi_959_ = _e876;
                                                phi_982_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e889 = phi_959_;
                                            let _e891 = phi_982_;
                                            let _e895 = (bitcast<i32>(_e891.member) != 0i);
                                            if _e895 {
                                                let _e896 = ((_e517.member_1 & 268435455u) + _e891.member_1);
                                                let _e897 = (_e896 < _e86);
                                                if _e897 {
                                                    if _e897 {
                                                    } else {
                                                        phi_3505_ = _e874;
                                                        phi_3391_ = true;
                                                        break;
                                                    }
                                                    let _e901 = global_2.member[_e896].member_1;
                                                    phi_1003_ = _e901;
                                                } else {
                                                    phi_1003_ = 4294967295u;
                                                }
                                                let _e903 = phi_1003_;
                                                if (_e896 >= _e86) {
                                                    phi_1092_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e897 {
                                                    } else {
                                                        phi_3505_ = _e874;
                                                        phi_3391_ = true;
                                                        break;
                                                    }
                                                    if (_e450 < 9u) {
                                                    } else {
                                                        phi_3505_ = _e874;
                                                        phi_3391_ = true;
                                                        break;
                                                    }
                                                    let _e910 = global_2.member[_e896].member[_e450];
                                                    if (_e454 < 9u) {
                                                    } else {
                                                        phi_3505_ = _e874;
                                                        phi_3391_ = true;
                                                        break;
                                                    }
                                                    let _e916 = global_2.member[_e896].member[_e454];
                                                    if (_e458 < 9u) {
                                                    } else {
                                                        phi_3505_ = _e874;
                                                        phi_3391_ = true;
                                                        break;
                                                    }
                                                    let _e922 = global_2.member[_e896].member[_e458];
                                                    let _e924 = (3u + _e450);
                                                    if (_e924 < 9u) {
                                                    } else {
                                                        phi_3505_ = _e874;
                                                        phi_3391_ = true;
                                                        break;
                                                    }
                                                    let _e930 = global_2.member[_e896].member[_e924];
                                                    let _e931 = (3u + _e454);
                                                    if (_e931 < 9u) {
                                                    } else {
                                                        phi_3505_ = _e874;
                                                        phi_3391_ = true;
                                                        break;
                                                    }
                                                    let _e937 = global_2.member[_e896].member[_e931];
                                                    let _e938 = (3u + _e458);
                                                    if (_e938 < 9u) {
                                                    } else {
                                                        phi_3505_ = _e874;
                                                        phi_3391_ = true;
                                                        break;
                                                    }
                                                    let _e944 = global_2.member[_e896].member[_e938];
                                                    let _e946 = (6u + _e450);
                                                    if (_e946 < 9u) {
                                                    } else {
                                                        phi_3505_ = _e874;
                                                        phi_3391_ = true;
                                                        break;
                                                    }
                                                    let _e952 = global_2.member[_e896].member[_e946];
                                                    let _e953 = (6u + _e454);
                                                    if (_e953 < 9u) {
                                                    } else {
                                                        phi_3505_ = _e874;
                                                        phi_3391_ = true;
                                                        break;
                                                    }
                                                    let _e959 = global_2.member[_e896].member[_e953];
                                                    let _e960 = (6u + _e458);
                                                    if (_e960 < 9u) {
                                                    } else {
                                                        phi_3505_ = _e874;
                                                        phi_3391_ = true;
                                                        break;
                                                    }
                                                    let _e966 = global_2.member[_e896].member[_e960];
                                                    phi_1092_ = array<array<f32, 3>, 3>(array<f32, 3>(_e910, _e916, _e922), array<f32, 3>(_e930, _e937, _e944), array<f32, 3>(_e952, _e959, _e966));
                                                }
                                                let _e970 = phi_1092_;
                                                let _e977 = (_e970[0][2] - _e372);
                                                let _e980 = (((_e970[0][0] - _e295) * _e396) - (_e977 * _e320));
                                                let _e983 = (((_e970[0][1] - _e334) * _e396) - (_e977 * _e358));
                                                let _e990 = (_e970[1][2] - _e372);
                                                let _e993 = (((_e970[1][0] - _e295) * _e396) - (_e990 * _e320));
                                                let _e996 = (((_e970[1][1] - _e334) * _e396) - (_e990 * _e358));
                                                let _e1003 = (_e970[2][2] - _e372);
                                                let _e1006 = (((_e970[2][0] - _e295) * _e396) - (_e1003 * _e320));
                                                let _e1009 = (((_e970[2][1] - _e334) * _e396) - (_e1003 * _e358));
                                                let _e1010 = (_e1006 * _e996);
                                                let _e1011 = (_e1009 * _e993);
                                                let _e1012 = (_e980 * _e1009);
                                                let _e1013 = (_e983 * _e1006);
                                                let _e1014 = (_e993 * _e983);
                                                let _e1015 = (_e996 * _e980);
                                                let _e1020 = (((_e1010 >= _e1011) && (_e1012 >= _e1013)) && (_e1014 >= _e1015));
                                                if (_e1020 || (((_e1010 <= _e1011) && (_e1012 <= _e1013)) && (_e1014 <= _e1015))) {
                                                    let _e1027 = select(-1f, 1f, _e1020);
                                                    let _e1029 = ((_e1010 - _e1011) * _e1027);
                                                    let _e1031 = select(0f, _e1029, (_e1029 > 0f));
                                                    let _e1033 = ((_e1012 - _e1013) * _e1027);
                                                    let _e1035 = select(0f, _e1033, (_e1033 > 0f));
                                                    let _e1037 = ((_e1014 - _e1015) * _e1027);
                                                    let _e1039 = select(0f, _e1037, (_e1037 > 0f));
                                                    let _e1041 = ((_e1031 + _e1035) + _e1039);
                                                    if (_e1041 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1918_ = type_22();
                                                        phi_1919_ = true;
                                                        phi_1920_ = false;
                                                    } else {
                                                        let _e1044 = select(_e993, _e980, (_e980 < _e993));
                                                        if (select(_e1006, _e1044, (_e1044 < _e1006)) > 0f) {
                                                            phi_1210_ = true;
                                                        } else {
                                                            let _e1049 = select(_e993, _e980, (_e980 > _e993));
                                                            phi_1210_ = (select(_e1006, _e1049, (_e1049 > _e1006)) < 0f);
                                                        }
                                                        let _e1054 = phi_1210_;
                                                        if _e1054 {
                                                            phi_1915_ = type_22();
                                                            phi_1916_ = true;
                                                            phi_1917_ = false;
                                                        } else {
                                                            let _e1056 = select(_e996, _e983, (_e983 < _e996));
                                                            if (select(_e1009, _e1056, (_e1056 < _e1009)) > 0f) {
                                                                phi_1239_ = true;
                                                            } else {
                                                                let _e1061 = select(_e996, _e983, (_e983 > _e996));
                                                                phi_1239_ = (select(_e1009, _e1061, (_e1061 > _e1009)) < 0f);
                                                            }
                                                            let _e1066 = phi_1239_;
                                                            if _e1066 {
                                                                phi_1913_ = type_22();
                                                                phi_1914_ = false;
                                                            } else {
                                                                let _e1068 = select(_e970[1][0], _e970[0][0], (_e970[0][0] < _e970[1][0]));
                                                                let _e1072 = select(_e970[1][0], _e970[0][0], (_e970[0][0] > _e970[1][0]));
                                                                let _e1076 = select(_e970[1][1], _e970[0][1], (_e970[0][1] < _e970[1][1]));
                                                                let _e1080 = select(_e970[1][1], _e970[0][1], (_e970[0][1] > _e970[1][1]));
                                                                let _e1084 = select(_e970[1][2], _e970[0][2], (_e970[0][2] < _e970[1][2]));
                                                                let _e1088 = select(_e970[1][2], _e970[0][2], (_e970[0][2] > _e970[1][2]));
                                                                let _e1093 = ((select(_e970[2][0], _e1068, (_e1068 < _e970[2][0])) - _e318) * _e323);
                                                                let _e1094 = ((select(_e970[2][0], _e1072, (_e1072 > _e970[2][0])) - _e319) * _e323);
                                                                let _e1097 = ((select(_e970[2][1], _e1076, (_e1076 < _e970[2][1])) - _e356) * _e361);
                                                                let _e1098 = ((select(_e970[2][1], _e1080, (_e1080 > _e970[2][1])) - _e357) * _e361);
                                                                let _e1101 = ((select(_e970[2][2], _e1084, (_e1084 < _e970[2][2])) - _e394) * _e399);
                                                                let _e1102 = ((select(_e970[2][2], _e1088, (_e1088 > _e970[2][2])) - _e395) * _e399);
                                                                let _e1104 = select(_e1102, _e1101, (_e1101 < _e1102));
                                                                let _e1106 = select(_e1102, _e1101, (_e1101 > _e1102));
                                                                let _e1108 = select(_e1094, _e1093, (_e1093 < _e1094));
                                                                let _e1110 = select(_e1098, _e1097, (_e1097 < _e1098));
                                                                let _e1112 = select(_e1110, _e1108, (_e1108 > _e1110));
                                                                let _e1114 = select(_e1104, _e1112, (_e1112 > _e1104));
                                                                let _e1116 = select(_e1094, _e1093, (_e1093 > _e1094));
                                                                let _e1118 = select(_e1098, _e1097, (_e1097 > _e1098));
                                                                let _e1120 = select(_e1118, _e1116, (_e1116 < _e1118));
                                                                let _e1122 = select(_e1106, _e1120, (_e1120 < _e1106));
                                                                let _e1123 = -(_e1104);
                                                                let _e1129 = select(_e446, _e1114, (_e1114 > _e446));
                                                                if (_e1129 > (_e1122 + (select(_e1123, _e1106, (_e1106 > _e1123)) * 0.0000019073523f))) {
                                                                    phi_1908_ = type_22();
                                                                    phi_1909_ = true;
                                                                } else {
                                                                    let _e1131 = (_e1129 > _e874);
                                                                    if _e1131 {
                                                                        phi_1907_ = type_22();
                                                                    } else {
                                                                        let _e1132 = vec3<f32>(_e970[0][0], _e970[0][1], _e970[0][2]);
                                                                        let _e1133 = vec3<f32>(_e970[1][0], _e970[1][1], _e970[1][2]);
                                                                        let _e1134 = vec3<f32>(_e970[2][0], _e970[2][1], _e970[2][2]);
                                                                        let _e1135 = (_e970[1][0] - _e970[0][0]);
                                                                        let _e1136 = (_e970[1][1] - _e970[0][1]);
                                                                        let _e1137 = (_e970[1][2] - _e970[0][2]);
                                                                        let _e1138 = vec3<f32>(_e1135, _e1136, _e1137);
                                                                        let _e1139 = (_e970[2][0] - _e970[1][0]);
                                                                        let _e1140 = (_e970[2][1] - _e970[1][1]);
                                                                        let _e1141 = (_e970[2][2] - _e970[1][2]);
                                                                        let _e1142 = vec3<f32>(_e1139, _e1140, _e1141);
                                                                        let _e1143 = (_e970[0][0] - _e970[2][0]);
                                                                        let _e1144 = (_e970[0][1] - _e970[2][1]);
                                                                        let _e1145 = (_e970[0][2] - _e970[2][2]);
                                                                        let _e1146 = vec3<f32>(_e1143, _e1144, _e1145);
                                                                        let _e1149 = bitcast<f32>((bitcast<u32>(_e1135) & 2147483647u));
                                                                        let _e1152 = bitcast<f32>((bitcast<u32>(_e1136) & 2147483647u));
                                                                        let _e1154 = select(_e1152, _e1149, (_e1149 > _e1152));
                                                                        let _e1157 = bitcast<f32>((bitcast<u32>(_e1137) & 2147483647u));
                                                                        let _e1159 = select(_e1157, _e1154, (_e1154 > _e1157));
                                                                        let _e1162 = bitcast<f32>((bitcast<u32>(_e1139) & 2147483647u));
                                                                        let _e1165 = bitcast<f32>((bitcast<u32>(_e1140) & 2147483647u));
                                                                        let _e1167 = select(_e1165, _e1162, (_e1162 > _e1165));
                                                                        let _e1170 = bitcast<f32>((bitcast<u32>(_e1141) & 2147483647u));
                                                                        let _e1172 = select(_e1170, _e1167, (_e1167 > _e1170));
                                                                        let _e1175 = bitcast<f32>((bitcast<u32>(_e1143) & 2147483647u));
                                                                        let _e1178 = bitcast<f32>((bitcast<u32>(_e1144) & 2147483647u));
                                                                        let _e1180 = select(_e1178, _e1175, (_e1175 > _e1178));
                                                                        let _e1183 = bitcast<f32>((bitcast<u32>(_e1145) & 2147483647u));
                                                                        let _e1185 = select(_e1183, _e1180, (_e1180 > _e1183));
                                                                        let _e1187 = select(_e1172, _e1159, (_e1159 > _e1172));
                                                                        let _e1189 = select(_e1185, _e1187, (_e1187 > _e1185));
                                                                        if (_e1159 == _e1189) {
                                                                            phi_1640_ = _e996;
                                                                            phi_1641_ = _e993;
                                                                            phi_1642_ = _e983;
                                                                            phi_1643_ = _e980;
                                                                            phi_1644_ = _e1132;
                                                                            phi_1645_ = _e1146;
                                                                            phi_1646_ = _e1142;
                                                                            phi_1647_ = _e1138;
                                                                        } else {
                                                                            let _e1191 = (_e1172 == _e1189);
                                                                            let _e1196 = vec3(_e1191);
                                                                            phi_1640_ = select(_e983, _e1009, _e1191);
                                                                            phi_1641_ = select(_e980, _e1006, _e1191);
                                                                            phi_1642_ = select(_e1009, _e996, _e1191);
                                                                            phi_1643_ = select(_e1006, _e993, _e1191);
                                                                            phi_1644_ = select(_e1134, _e1133, _e1196);
                                                                            phi_1645_ = select(_e1142, _e1138, _e1196);
                                                                            phi_1646_ = select(_e1138, _e1146, _e1196);
                                                                            phi_1647_ = select(_e1146, _e1142, _e1196);
                                                                        }
                                                                        let _e1202 = phi_1640_;
                                                                        let _e1204 = phi_1641_;
                                                                        let _e1206 = phi_1642_;
                                                                        let _e1208 = phi_1643_;
                                                                        let _e1210 = phi_1644_;
                                                                        let _e1212 = phi_1645_;
                                                                        let _e1214 = phi_1646_;
                                                                        let _e1216 = phi_1647_;
                                                                        let _e1223 = ((_e1214.y * _e1212.z) - (_e1212.y * _e1214.z));
                                                                        let _e1228 = ((_e1214.z * _e1212.x) - (_e1212.z * _e1214.x));
                                                                        let _e1231 = ((_e1214.x * _e1212.y) - (_e1212.x * _e1214.y));
                                                                        if (_e1031 >= _e1035) {
                                                                            phi_1678_ = select(true, false, (_e1031 >= _e1039));
                                                                        } else {
                                                                            phi_1678_ = true;
                                                                        }
                                                                        let _e1236 = phi_1678_;
                                                                        if _e1236 {
                                                                            phi_1687_ = select(_e1134, _e1133, vec3((_e1035 >= _e1039)));
                                                                        } else {
                                                                            phi_1687_ = _e1132;
                                                                        }
                                                                        let _e1241 = phi_1687_;
                                                                        let _e1252 = (((_e1223 * (_e1241.x - _e295)) + (_e1228 * (_e1241.y - _e334))) + (_e1231 * (_e1241.z - _e372)));
                                                                        let _e1257 = (((_e1223 * _e320) + (_e1228 * _e358)) + (_e1231 * _e396));
                                                                        let _e1258 = (_e1204 - _e1208);
                                                                        let _e1259 = (_e1202 - _e1206);
                                                                        let _e1267 = (-(((_e1208 * _e1258) + (_e1206 * _e1259))) / ((_e1258 * _e1258) + (_e1259 * _e1259)));
                                                                        let _e1269 = select(1f, _e1267, (_e1267 < 1f));
                                                                        let _e1271 = select(0f, _e1269, (_e1269 > 0f));
                                                                        let _e1284 = ((_e1210.x + (_e1216.x * _e1271)) - _e295);
                                                                        let _e1285 = ((_e1210.y + (_e1216.y * _e1271)) - _e334);
                                                                        let _e1286 = ((_e1210.z + (_e1216.z * _e1271)) - _e372);
                                                                        let _e1287 = (_e1286 / _e396);
                                                                        let _e1299 = bitcast<f32>((bitcast<u32>(_e1284) & 2147483647u));
                                                                        let _e1302 = bitcast<f32>((bitcast<u32>(_e1285) & 2147483647u));
                                                                        let _e1304 = select(_e1302, _e1299, (_e1299 > _e1302));
                                                                        let _e1307 = bitcast<f32>((bitcast<u32>(_e1286) & 2147483647u));
                                                                        let _e1309 = select(_e1307, _e1304, (_e1304 > _e1307));
                                                                        let _e1315 = bitcast<f32>((bitcast<u32>(_e1223) & 2147483647u));
                                                                        let _e1318 = bitcast<f32>((bitcast<u32>(_e1228) & 2147483647u));
                                                                        let _e1320 = select(_e1318, _e1315, (_e1315 > _e1318));
                                                                        let _e1323 = bitcast<f32>((bitcast<u32>(_e1231) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1223 * _e1284) + (_e1228 * _e1285)) + (_e1231 * _e1286)) - _e1252)) & 2147483647u)) <= ((0.0000009536743f * select(_e1189, _e1309, (_e1309 > _e1189))) * select(_e1323, _e1320, (_e1320 > _e1323)))) {
                                                                            let _e1333 = bitcast<f32>((bitcast<u32>(_e1214.x) & 2147483647u));
                                                                            let _e1336 = bitcast<f32>((bitcast<u32>(_e1214.y) & 2147483647u));
                                                                            let _e1338 = select(_e1336, _e1333, (_e1333 > _e1336));
                                                                            let _e1341 = bitcast<f32>((bitcast<u32>(_e1214.z) & 2147483647u));
                                                                            let _e1347 = bitcast<f32>((bitcast<u32>(_e1212.x) & 2147483647u));
                                                                            let _e1350 = bitcast<f32>((bitcast<u32>(_e1212.y) & 2147483647u));
                                                                            let _e1352 = select(_e1350, _e1347, (_e1347 > _e1350));
                                                                            let _e1355 = bitcast<f32>((bitcast<u32>(_e1212.z) & 2147483647u));
                                                                            let _e1359 = (bitcast<f32>((bitcast<u32>(_e1257) & 2147483647u)) > ((0.0000038146973f * select(_e1341, _e1338, (_e1338 > _e1341))) * select(_e1355, _e1352, (_e1352 > _e1355))));
                                                                            if _e1359 {
                                                                                phi_1852_ = (_e1252 / _e1257);
                                                                            } else {
                                                                                phi_1852_ = f32();
                                                                            }
                                                                            let _e1362 = phi_1852_;
                                                                            phi_1854_ = _e1362;
                                                                            phi_1855_ = select(true, false, _e1359);
                                                                        } else {
                                                                            phi_1854_ = f32();
                                                                            phi_1855_ = true;
                                                                        }
                                                                        let _e1365 = phi_1854_;
                                                                        let _e1367 = phi_1855_;
                                                                        if _e1367 {
                                                                            let _e1375 = (((_e1223 * (_e1284 - (_e320 * _e1287))) + (_e1228 * (_e1285 - (_e358 * _e1287)))) / _e1257);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1375) & 2147483647u)) <= _e1189) {
                                                                                phi_1875_ = (_e1287 + _e1375);
                                                                            } else {
                                                                                phi_1875_ = _e1287;
                                                                            }
                                                                            let _e1382 = phi_1875_;
                                                                            phi_1876_ = _e1382;
                                                                        } else {
                                                                            phi_1876_ = _e1365;
                                                                        }
                                                                        let _e1384 = phi_1876_;
                                                                        let _e1386 = select(_e1122, _e1384, (_e1384 < _e1122));
                                                                        let _e1388 = select(_e1114, _e1386, (_e1386 > _e1114));
                                                                        if (_e1388 >= _e446) {
                                                                            let _e1390 = (_e1388 <= _e874);
                                                                            if _e1390 {
                                                                                let _e1391 = (1f / _e1041);
                                                                                phi_1899_ = type_22(_e1388, (_e1035 * _e1391), (_e1039 * _e1391), _e903);
                                                                            } else {
                                                                                phi_1899_ = type_22();
                                                                            }
                                                                            let _e1396 = phi_1899_;
                                                                            phi_1901_ = _e1396;
                                                                            phi_1902_ = select(true, false, _e1390);
                                                                        } else {
                                                                            phi_1901_ = type_22();
                                                                            phi_1902_ = true;
                                                                        }
                                                                        let _e1399 = phi_1901_;
                                                                        let _e1401 = phi_1902_;
                                                                        if _e1401 {
                                                                            phi_1906_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1906_ = _e1399;
                                                                        }
                                                                        let _e1403 = phi_1906_;
                                                                        phi_1907_ = _e1403;
                                                                    }
                                                                    let _e1405 = phi_1907_;
                                                                    phi_1908_ = _e1405;
                                                                    phi_1909_ = _e1131;
                                                                }
                                                                let _e1407 = phi_1908_;
                                                                let _e1409 = phi_1909_;
                                                                phi_1913_ = _e1407;
                                                                phi_1914_ = _e1409;
                                                            }
                                                            let _e1411 = phi_1913_;
                                                            let _e1413 = phi_1914_;
                                                            phi_1915_ = _e1411;
                                                            phi_1916_ = _e1066;
                                                            phi_1917_ = _e1413;
                                                        }
                                                        let _e1415 = phi_1915_;
                                                        let _e1417 = phi_1916_;
                                                        let _e1419 = phi_1917_;
                                                        phi_1918_ = _e1415;
                                                        phi_1919_ = _e1417;
                                                        phi_1920_ = _e1419;
                                                    }
                                                    let _e1421 = phi_1918_;
                                                    let _e1423 = phi_1919_;
                                                    let _e1425 = phi_1920_;
                                                    phi_1928_ = _e1421;
                                                    phi_1929_ = select(_e1425, true, _e1423);
                                                } else {
                                                    phi_1928_ = type_22();
                                                    phi_1929_ = true;
                                                }
                                                let _e1428 = phi_1928_;
                                                let _e1430 = phi_1929_;
                                                if _e1430 {
                                                    phi_1933_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1933_ = _e1428;
                                                }
                                                let _e1432 = phi_1933_;
                                                if (_e1432.member_3 != 4294967295u) {
                                                    if (_e903 != 4294967295u) {
                                                        phi_1945_ = type_4(0u, 8u);
                                                        phi_1948_ = _e1432;
                                                        loop {
                                                            let _e1437 = phi_1945_;
                                                            let _e1439 = phi_1948_;
                                                            if (_e1437.member < _e1437.member_1) {
                                                                phi_1946_ = type_4((_e1437.member + 1u), _e1437.member_1);
                                                                phi_1971_ = type_4(1u, _e1437.member);
                                                            } else {
                                                                phi_1946_ = _e1437;
                                                                phi_1971_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1452 = phi_1946_;
                                                            let _e1454 = phi_1971_;
                                                            let _e1458 = (bitcast<i32>(_e1454.member) != 0i);
                                                            if _e1458 {
                                                                let _e1459 = (_e1454.member_1 < 8u);
                                                                if _e1459 {
                                                                } else {
                                                                    phi_3249_ = true;
                                                                    break;
                                                                }
                                                                let _e1464 = local_7[_e1454.member_1].member;
                                                                if (_e1439.member < _e1464) {
                                                                    phi_2004_ = true;
                                                                } else {
                                                                    let _e1466 = local_7[_e1454.member_1].member;
                                                                    if (_e1439.member == _e1466) {
                                                                        let _e1471 = local_7[_e1454.member_1].member_3;
                                                                        phi_2003_ = (_e1439.member_3 < _e1471);
                                                                    } else {
                                                                        phi_2003_ = false;
                                                                    }
                                                                    let _e1474 = phi_2003_;
                                                                    phi_2004_ = _e1474;
                                                                }
                                                                let _e1476 = phi_2004_;
                                                                if _e1476 {
                                                                    if _e1459 {
                                                                    } else {
                                                                        phi_3249_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1477 = local_7[_e1454.member_1];
                                                                    local_7[_e1454.member_1] = type_22(_e1439.member, _e1439.member_1, _e1439.member_2, _e1439.member_3);
                                                                    phi_2025_ = type_22(_e1477.member, _e1477.member_1, _e1477.member_2, _e1477.member_3);
                                                                } else {
                                                                    phi_2025_ = _e1439;
                                                                }
                                                                let _e1488 = phi_2025_;
                                                                phi_1949_ = _e1488;
                                                            } else {
                                                                phi_1949_ = type_22();
                                                            }
                                                            let _e1490 = phi_1949_;
                                                            continue;
                                                            continuing {
                                                                phi_1945_ = _e1452;
                                                                phi_1948_ = _e1490;
                                                                phi_3249_ = _e872;
                                                                break if !(_e1458);
                                                            }
                                                        }
                                                        let _e1493 = phi_3249_;
                                                        phi_3505_ = _e874;
                                                        phi_3391_ = _e1493;
                                                        if _e1493 {
                                                            break;
                                                        }
                                                        let _e1496 = local_7[7u].member_3;
                                                        if (_e1496 != 4294967295u) {
                                                            let _e1500 = local_7[7u].member;
                                                            phi_3596_ = _e1500;
                                                        } else {
                                                            phi_3596_ = _e874;
                                                        }
                                                        let _e1502 = phi_3596_;
                                                        phi_3595_ = _e1502;
                                                        phi_3394_ = _e1493;
                                                    } else {
                                                        phi_3595_ = _e874;
                                                        phi_3394_ = _e872;
                                                    }
                                                    let _e1504 = phi_3595_;
                                                    let _e1506 = phi_3394_;
                                                    phi_3594_ = _e1504;
                                                    phi_3393_ = _e1506;
                                                } else {
                                                    phi_3594_ = _e874;
                                                    phi_3393_ = _e872;
                                                }
                                                let _e1508 = phi_3594_;
                                                let _e1510 = phi_3393_;
                                                phi_3593_ = _e1508;
                                                phi_3392_ = _e1510;
                                            } else {
                                                phi_3593_ = _e874;
                                                phi_3392_ = _e872;
                                            }
                                            let _e1512 = phi_3593_;
                                            let _e1514 = phi_3392_;
                                            continue;
                                            continuing {
                                                phi_3258_ = _e1514;
                                                phi_3248_ = _e1512;
                                                phi_958_ = _e889;
                                                phi_3505_ = _e1512;
                                                phi_3391_ = _e1514;
                                                break if !(_e895);
                                            }
                                        }
                                        let _e1517 = phi_3505_;
                                        let _e1519 = phi_3391_;
                                        phi_3396_ = _e1519;
                                        if _e1519 {
                                            break;
                                        }
                                        phi_3470_ = _e1517;
                                        phi_3400_ = _e1519;
                                        phi_2986_ = _e517;
                                        phi_2987_ = false;
                                        phi_2988_ = _e521;
                                    } else {
                                        let _e530 = (_e517.member_1 < _e84);
                                        if _e530 {
                                            if _e530 {
                                            } else {
                                                phi_3396_ = true;
                                                break;
                                            }
                                            let _e532 = global_5.member[_e517.member_1];
                                            phi_2055_ = _e532;
                                        } else {
                                            phi_2055_ = type_44(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e534 = phi_2055_;
                                        let _e549 = ((10u * _e246) & 31u);
                                        let _e552 = ((_e534.member[0] >> bitcast<u32>(_e549)) & 1023u);
                                        let _e557 = bitcast<f32>((bitcast<u32>(((_e517.member.member_1[0] - _e517.member.member[0]) * 0.0009775171f)) ^ _e118));
                                        let _e563 = (_e517.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e552) * _e557)) ^ _e118)));
                                        let _e567 = select(select(_e517.member.member_1[0], _e563, (_e563 < _e517.member.member_1[0])), _e517.member.member_1[0], (_e552 == 1023u));
                                        let _e569 = ((10u * _e245) & 31u);
                                        let _e572 = ((_e534.member[0] >> bitcast<u32>(_e569)) & 1023u);
                                        let _e577 = bitcast<f32>((bitcast<u32>(((_e517.member.member_1[1] - _e517.member.member[1]) * 0.0009775171f)) ^ _e118));
                                        let _e583 = (_e517.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e572) * _e577)) ^ _e118)));
                                        let _e587 = select(select(_e517.member.member_1[1], _e583, (_e583 < _e517.member.member_1[1])), _e517.member.member_1[1], (_e572 == 1023u));
                                        let _e589 = ((10u * _e247) & 31u);
                                        let _e592 = ((_e534.member[0] >> bitcast<u32>(_e589)) & 1023u);
                                        let _e597 = bitcast<f32>((bitcast<u32>(((_e517.member.member_1[2] - _e517.member.member[2]) * 0.0009775171f)) ^ _e118));
                                        let _e603 = (_e517.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e592) * _e597)) ^ _e118)));
                                        let _e607 = select(select(_e517.member.member_1[2], _e603, (_e603 < _e517.member.member_1[2])), _e517.member.member_1[2], (_e592 == 1023u));
                                        let _e610 = ((_e534.member[1] >> bitcast<u32>(_e549)) & 1023u);
                                        let _e616 = (_e517.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e610) * _e557)) ^ _e118)));
                                        let _e620 = select(select(_e517.member.member_1[0], _e616, (_e616 < _e517.member.member_1[0])), _e517.member.member_1[0], (_e610 == 1023u));
                                        let _e623 = ((_e534.member[1] >> bitcast<u32>(_e569)) & 1023u);
                                        let _e629 = (_e517.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e623) * _e577)) ^ _e118)));
                                        let _e633 = select(select(_e517.member.member_1[1], _e629, (_e629 < _e517.member.member_1[1])), _e517.member.member_1[1], (_e623 == 1023u));
                                        let _e636 = ((_e534.member[1] >> bitcast<u32>(_e589)) & 1023u);
                                        let _e642 = (_e517.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e636) * _e597)) ^ _e118)));
                                        let _e646 = select(select(_e517.member.member_1[2], _e642, (_e642 < _e517.member.member_1[2])), _e517.member.member_1[2], (_e636 == 1023u));
                                        let _e652 = ((_e534.member_1[0] >> bitcast<u32>(_e549)) & 1023u);
                                        let _e658 = (_e517.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e652) * _e557)) ^ _e118)));
                                        let _e662 = select(select(_e517.member.member_1[0], _e658, (_e658 < _e517.member.member_1[0])), _e517.member.member_1[0], (_e652 == 1023u));
                                        let _e665 = ((_e534.member_1[0] >> bitcast<u32>(_e569)) & 1023u);
                                        let _e671 = (_e517.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e665) * _e577)) ^ _e118)));
                                        let _e675 = select(select(_e517.member.member_1[1], _e671, (_e671 < _e517.member.member_1[1])), _e517.member.member_1[1], (_e665 == 1023u));
                                        let _e678 = ((_e534.member_1[0] >> bitcast<u32>(_e589)) & 1023u);
                                        let _e684 = (_e517.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e678) * _e597)) ^ _e118)));
                                        let _e688 = select(select(_e517.member.member_1[2], _e684, (_e684 < _e517.member.member_1[2])), _e517.member.member_1[2], (_e678 == 1023u));
                                        let _e691 = ((_e534.member_1[1] >> bitcast<u32>(_e549)) & 1023u);
                                        let _e697 = (_e517.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e691) * _e557)) ^ _e118)));
                                        let _e701 = select(select(_e517.member.member_1[0], _e697, (_e697 < _e517.member.member_1[0])), _e517.member.member_1[0], (_e691 == 1023u));
                                        let _e704 = ((_e534.member_1[1] >> bitcast<u32>(_e569)) & 1023u);
                                        let _e710 = (_e517.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e704) * _e577)) ^ _e118)));
                                        let _e714 = select(select(_e517.member.member_1[1], _e710, (_e710 < _e517.member.member_1[1])), _e517.member.member_1[1], (_e704 == 1023u));
                                        let _e717 = ((_e534.member_1[1] >> bitcast<u32>(_e589)) & 1023u);
                                        let _e723 = (_e517.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e717) * _e597)) ^ _e118)));
                                        let _e727 = select(select(_e517.member.member_1[2], _e723, (_e723 < _e517.member.member_1[2])), _e517.member.member_1[2], (_e717 == 1023u));
                                        let _e732 = type_51(type_49(array<f32, 3>(_e567, _e587, _e607), array<f32, 3>(_e620, _e633, _e646)), _e534.member_2);
                                        let _e737 = type_51(type_49(array<f32, 3>(_e662, _e675, _e688), array<f32, 3>(_e701, _e714, _e727)), _e534.member_3);
                                        let _e742 = ((_e567 - _e318) * _e323);
                                        let _e743 = ((_e662 - _e318) * _e323);
                                        let _e744 = ((_e620 - _e319) * _e323);
                                        let _e745 = ((_e701 - _e319) * _e323);
                                        let _e750 = ((_e587 - _e356) * _e361);
                                        let _e751 = ((_e675 - _e356) * _e361);
                                        let _e752 = ((_e633 - _e357) * _e361);
                                        let _e753 = ((_e714 - _e357) * _e361);
                                        let _e758 = ((_e607 - _e394) * _e399);
                                        let _e759 = ((_e688 - _e394) * _e399);
                                        let _e760 = ((_e646 - _e395) * _e399);
                                        let _e761 = ((_e727 - _e395) * _e399);
                                        let _e763 = select(_e760, _e758, (_e758 < _e760));
                                        let _e765 = select(_e761, _e759, (_e759 < _e761));
                                        let _e767 = select(_e760, _e758, (_e758 > _e760));
                                        let _e769 = select(_e761, _e759, (_e759 > _e761));
                                        let _e771 = select(_e744, _e742, (_e742 < _e744));
                                        let _e773 = select(_e745, _e743, (_e743 < _e745));
                                        let _e775 = select(_e752, _e750, (_e750 < _e752));
                                        let _e777 = select(_e753, _e751, (_e751 < _e753));
                                        let _e779 = select(_e775, _e771, (_e771 > _e775));
                                        let _e781 = select(_e777, _e773, (_e773 > _e777));
                                        let _e783 = select(_e763, _e779, (_e779 > _e763));
                                        let _e785 = select(_e765, _e781, (_e781 > _e765));
                                        let _e787 = select(_e744, _e742, (_e742 > _e744));
                                        let _e789 = select(_e745, _e743, (_e743 > _e745));
                                        let _e791 = select(_e752, _e750, (_e750 > _e752));
                                        let _e793 = select(_e753, _e751, (_e751 > _e753));
                                        let _e795 = select(_e791, _e787, (_e787 < _e791));
                                        let _e797 = select(_e793, _e789, (_e789 < _e793));
                                        let _e802 = -(_e763);
                                        let _e803 = -(_e765);
                                        let _e810 = (select(_e767, _e795, (_e795 < _e767)) + (select(_e802, _e767, (_e767 > _e802)) * 0.0000019073523f));
                                        let _e811 = (select(_e769, _e797, (_e797 < _e769)) + (select(_e803, _e769, (_e769 > _e803)) * 0.0000019073523f));
                                        let _e813 = select(_e446, _e783, (_e783 > _e446));
                                        let _e815 = select(_e446, _e785, (_e785 > _e446));
                                        let _e820 = (_e813 <= select(_e479, _e810, (_e810 < _e479)));
                                        let _e821 = (_e815 <= select(_e479, _e811, (_e811 < _e479)));
                                        let _e822 = (_e813 <= _e815);
                                        if _e820 {
                                            if _e821 {
                                                if _e822 {
                                                    phi_2888_ = _e737;
                                                } else {
                                                    phi_2888_ = _e732;
                                                }
                                                let _e824 = phi_2888_;
                                                let _e832 = (_e521 % 128u);
                                                let _e833 = (_e832 < 128u);
                                                if _e833 {
                                                } else {
                                                    phi_3396_ = true;
                                                    break;
                                                }
                                                local_6[_e832] = _e824.member_1;
                                                if _e833 {
                                                } else {
                                                    phi_3396_ = true;
                                                    break;
                                                }
                                                local_5[_e832] = _e824.member.member[0];
                                                if _e833 {
                                                } else {
                                                    phi_3396_ = true;
                                                    break;
                                                }
                                                local_4[_e832] = _e824.member.member[1];
                                                if _e833 {
                                                } else {
                                                    phi_3396_ = true;
                                                    break;
                                                }
                                                local_3[_e832] = _e824.member.member[2];
                                                if _e833 {
                                                } else {
                                                    phi_3396_ = true;
                                                    break;
                                                }
                                                local_2[_e832] = _e824.member.member_1[0];
                                                if _e833 {
                                                } else {
                                                    phi_3396_ = true;
                                                    break;
                                                }
                                                local_1[_e832] = _e824.member.member_1[1];
                                                if _e833 {
                                                } else {
                                                    phi_3396_ = true;
                                                    break;
                                                }
                                                local[_e832] = _e824.member.member_1[2];
                                                if _e833 {
                                                } else {
                                                    phi_3396_ = true;
                                                    break;
                                                }
                                                local_8[_e832] = select(_e815, _e813, (_e813 > _e815));
                                                if _e822 {
                                                    phi_2965_ = _e732;
                                                } else {
                                                    phi_2965_ = _e737;
                                                }
                                                let _e850 = phi_2965_;
                                                phi_2966_ = _e850;
                                                phi_2967_ = (_e521 + 1u);
                                            } else {
                                                phi_2966_ = type_51();
                                                phi_2967_ = u32();
                                            }
                                            let _e852 = phi_2966_;
                                            let _e854 = phi_2967_;
                                            phi_2969_ = _e852;
                                            phi_2970_ = _e854;
                                            phi_2971_ = select(true, false, _e821);
                                        } else {
                                            phi_2969_ = type_51();
                                            phi_2970_ = u32();
                                            phi_2971_ = true;
                                        }
                                        let _e857 = phi_2969_;
                                        let _e859 = phi_2970_;
                                        let _e861 = phi_2971_;
                                        if _e861 {
                                            if _e820 {
                                                phi_2978_ = _e732;
                                            } else {
                                                phi_2978_ = _e737;
                                            }
                                            let _e863 = phi_2978_;
                                            phi_2983_ = _e863;
                                            phi_2984_ = select(_e821, true, _e820);
                                        } else {
                                            phi_2983_ = _e857;
                                            phi_2984_ = _e519;
                                        }
                                        let _e866 = phi_2983_;
                                        let _e868 = phi_2984_;
                                        phi_3470_ = _e479;
                                        phi_3400_ = _e477;
                                        phi_2986_ = _e866;
                                        phi_2987_ = _e868;
                                        phi_2988_ = select(_e859, _e521, _e861);
                                    }
                                    let _e1521 = phi_3470_;
                                    let _e1523 = phi_3400_;
                                    let _e1525 = phi_2986_;
                                    let _e1527 = phi_2987_;
                                    let _e1529 = phi_2988_;
                                    phi_3469_ = _e1521;
                                    phi_3399_ = _e1523;
                                    phi_2989_ = _e1525;
                                    phi_2990_ = (_e483 - 1u);
                                    phi_2991_ = _e1527;
                                    phi_2992_ = _e1529;
                                } else {
                                    phi_3469_ = _e479;
                                    phi_3399_ = _e477;
                                    phi_2989_ = _e517;
                                    phi_2990_ = _e483;
                                    phi_2991_ = _e519;
                                    phi_2992_ = _e521;
                                }
                                let _e1531 = phi_3469_;
                                let _e1533 = phi_3399_;
                                let _e1535 = phi_2989_;
                                let _e1537 = phi_2990_;
                                let _e1539 = phi_2991_;
                                let _e1541 = phi_2992_;
                                phi_3468_ = _e1531;
                                phi_3398_ = _e1533;
                                phi_2993_ = _e1535;
                                phi_2994_ = _e1537;
                                phi_2995_ = _e1539;
                                phi_2996_ = _e1541;
                            } else {
                                phi_3468_ = _e479;
                                phi_3398_ = _e477;
                                phi_2993_ = type_51();
                                phi_2994_ = u32();
                                phi_2995_ = bool();
                                phi_2996_ = u32();
                            }
                            let _e1543 = phi_3468_;
                            let _e1545 = phi_3398_;
                            let _e1547 = phi_2993_;
                            let _e1549 = phi_2994_;
                            let _e1551 = phi_2995_;
                            let _e1553 = phi_2996_;
                            phi_3467_ = _e1543;
                            phi_3397_ = _e1545;
                            phi_834_ = _e1547;
                            phi_837_ = _e1549;
                            phi_839_ = _e1551;
                            phi_841_ = _e1553;
                            phi_2997_ = _e491;
                        } else {
                            phi_3467_ = _e479;
                            phi_3397_ = _e477;
                            phi_834_ = type_51();
                            phi_837_ = u32();
                            phi_839_ = bool();
                            phi_841_ = u32();
                            phi_2997_ = false;
                        }
                        let _e1555 = phi_3467_;
                        let _e1557 = phi_3397_;
                        let _e1559 = phi_834_;
                        let _e1561 = phi_837_;
                        let _e1563 = phi_839_;
                        let _e1565 = phi_841_;
                        let _e1567 = phi_2997_;
                        continue;
                        continuing {
                            phi_3261_ = _e1557;
                            phi_3217_ = _e1555;
                            phi_833_ = _e1559;
                            phi_836_ = _e1561;
                            phi_838_ = _e1563;
                            phi_840_ = _e1565;
                            phi_3396_ = _e1557;
                            break if !(_e1567);
                        }
                    }
                    let _e1570 = phi_3396_;
                    if _e1570 {
                        break;
                    }
                    phi_3004_ = type_4(0u, 8u);
                    loop {
                        let _e1572 = phi_3004_;
                        if (_e1572.member < _e1572.member_1) {
                            phi_3005_ = type_4((_e1572.member + 1u), _e1572.member_1);
                            phi_3028_ = type_4(1u, _e1572.member);
                        } else {
                            phi_3005_ = _e1572;
                            phi_3028_ = type_4(0u, type_4().member_1);
                        }
                        let _e1585 = phi_3005_;
                        let _e1587 = phi_3028_;
                        let _e1591 = (bitcast<i32>(_e1587.member) != 0i);
                        if _e1591 {
                            let _e1592 = (_e1587.member_1 < 8u);
                            if _e1592 {
                            } else {
                                phi_3460_ = true;
                                break;
                            }
                            let _e1594 = local_7[_e1587.member_1];
                            if (_e1594.member_3 != 4294967295u) {
                                let _e1600 = -(_e413);
                                let _e1601 = (_e1600 / 3i);
                                let _e1608 = bitcast<f32>((bitcast<u32>((_e1601 + 127i)) << bitcast<u32>(23i)));
                                let _e1616 = (((_e1594.member * _e1608) * _e1608) * bitcast<f32>((bitcast<u32>(((_e1600 - (2i * _e1601)) + 127i)) << bitcast<u32>(23i))));
                                let _e1618 = select(340282350000000000000000000000000000000f, _e1616, (_e1616 < 340282350000000000000000000000000000000f));
                                phi_3094_ = type_22(select(-340282350000000000000000000000000000000f, _e1618, (_e1618 > -340282350000000000000000000000000000000f)), _e1594.member_1, _e1594.member_2, _e1594.member_3);
                            } else {
                                phi_3094_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1623 = phi_3094_;
                            if _e1592 {
                            } else {
                                phi_3460_ = true;
                                break;
                            }
                            local_7[_e1587.member_1] = type_22(_e1623.member, _e1623.member_1, _e1623.member_2, _e1623.member_3);
                        }
                        continue;
                        continuing {
                            phi_3004_ = _e1585;
                            phi_3460_ = _e1570;
                            break if !(_e1591);
                        }
                    }
                    let _e1631 = phi_3460_;
                    if _e1631 {
                        break;
                    }
                    let _e1632 = local_7;
                    if _e134 {
                    } else {
                        break;
                    }
                    global_6.member[_e132] = array<type_22, 8>(type_22(_e1632[0].member, _e1632[0].member_1, _e1632[0].member_2, _e1632[0].member_3), type_22(_e1632[1].member, _e1632[1].member_1, _e1632[1].member_2, _e1632[1].member_3), type_22(_e1632[2].member, _e1632[2].member_1, _e1632[2].member_2, _e1632[2].member_3), type_22(_e1632[3].member, _e1632[3].member_1, _e1632[3].member_2, _e1632[3].member_3), type_22(_e1632[4].member, _e1632[4].member_1, _e1632[4].member_2, _e1632[4].member_3), type_22(_e1632[5].member, _e1632[5].member_1, _e1632[5].member_2, _e1632[5].member_3), type_22(_e1632[6].member, _e1632[6].member_1, _e1632[6].member_2, _e1632[6].member_3), type_22(_e1632[7].member, _e1632[7].member_1, _e1632[7].member_2, _e1632[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
