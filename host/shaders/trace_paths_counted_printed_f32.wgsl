struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_23 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: type_27,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_38 {
    member: type_23,
    member_1: f32,
}

struct type_41 {
    member: type_38,
    member_1: u32,
    member_2: u32,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_47 {
    member: array<type_45>,
}

struct type_50 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_52 {
    member: type_50,
    member_1: u32,
}

struct type_57 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_25;
@group(0) @binding(0) 
var<uniform> global_3: type_43;
@group(0) @binding(3) 
var<storage> global_4: type_30;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_57;
@group(0) @binding(1) 
var<storage> global_7: type_47;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_342_: i32;
    var phi_343_: i32;
    var phi_353_: bool;
    var phi_363_: u32;
    var phi_364_: u32;
    var phi_366_: bool;
    var phi_371_: u32;
    var phi_403_: i32;
    var phi_421_: f32;
    var phi_427_: f32;
    var phi_438_: f32;
    var phi_444_: f32;
    var phi_467_: f32;
    var phi_478_: f32;
    var phi_487_: f32;
    var phi_493_: f32;
    var phi_504_: f32;
    var phi_510_: f32;
    var phi_533_: f32;
    var phi_544_: f32;
    var phi_553_: f32;
    var phi_559_: f32;
    var phi_570_: f32;
    var phi_576_: f32;
    var phi_599_: f32;
    var phi_610_: f32;
    var phi_710_: f32;
    var phi_711_: f32;
    var phi_3116_: bool;
    var phi_793_: type_41;
    var phi_796_: type_52;
    var phi_798_: u32;
    var phi_800_: bool;
    var phi_802_: u32;
    var phi_813_: bool;
    var phi_899_: type_52;
    var phi_900_: bool;
    var phi_901_: u32;
    var phi_1955_: type_45;
    var phi_2787_: type_52;
    var phi_2864_: type_52;
    var phi_2865_: type_52;
    var phi_2866_: u32;
    var phi_2868_: type_52;
    var phi_2869_: u32;
    var phi_2870_: bool;
    var phi_2877_: type_52;
    var phi_2882_: type_52;
    var phi_2883_: bool;
    var phi_919_: type_41;
    var phi_922_: type_7;
    var phi_923_: type_7;
    var phi_945_: type_7;
    var phi_969_: u32;
    var phi_1058_: array<array<f32, 3>, 3>;
    var phi_1175_: bool;
    var phi_1204_: bool;
    var phi_1605_: f32;
    var phi_1606_: f32;
    var phi_1607_: f32;
    var phi_1608_: f32;
    var phi_1609_: vec3<f32>;
    var phi_1610_: vec3<f32>;
    var phi_1611_: vec3<f32>;
    var phi_1612_: vec3<f32>;
    var phi_1643_: bool;
    var phi_1652_: vec3<f32>;
    var phi_1817_: f32;
    var phi_1819_: f32;
    var phi_1820_: bool;
    var phi_1840_: f32;
    var phi_1841_: f32;
    var phi_1864_: type_23;
    var phi_1866_: type_23;
    var phi_1867_: bool;
    var phi_1871_: type_23;
    var phi_1872_: type_23;
    var phi_1873_: type_23;
    var phi_1874_: bool;
    var phi_1878_: type_23;
    var phi_1879_: bool;
    var phi_1880_: type_23;
    var phi_1881_: bool;
    var phi_1882_: bool;
    var phi_1883_: type_23;
    var phi_1884_: bool;
    var phi_1885_: bool;
    var phi_1893_: type_23;
    var phi_1894_: bool;
    var phi_1898_: type_23;
    var phi_1923_: bool;
    var phi_1924_: bool;
    var phi_1931_: type_41;
    var phi_1932_: type_41;
    var phi_1933_: type_41;
    var phi_920_: type_41;
    var phi_3110_: bool;
    var phi_3256_: bool;
    var phi_2885_: type_41;
    var phi_2886_: type_52;
    var phi_2887_: bool;
    var phi_2888_: u32;
    var phi_3255_: bool;
    var phi_2889_: type_41;
    var phi_2890_: type_52;
    var phi_2891_: u32;
    var phi_2892_: bool;
    var phi_2893_: u32;
    var phi_3254_: bool;
    var phi_2894_: type_41;
    var phi_2895_: type_52;
    var phi_2896_: u32;
    var phi_2897_: bool;
    var phi_2898_: u32;
    var phi_3253_: bool;
    var phi_794_: type_41;
    var phi_797_: type_52;
    var phi_799_: u32;
    var phi_801_: bool;
    var phi_803_: u32;
    var phi_2899_: bool;
    var phi_3252_: bool;
    var local_10: type_41;
    var phi_2951_: type_23;
    var local_11: type_41;
    var local_12: type_41;

    switch bitcast<i32>(0u) {
        default: {
            let _e80 = global;
            let _e83 = arrayLength((&global_7.member));
            let _e85 = arrayLength((&global_1.member));
            let _e93 = arrayLength((&global_6.member));
            let _e97 = global_3.member[0u][0u];
            let _e101 = global_3.member[0u][1u];
            let _e105 = global_3.member[0u][2u];
            let _e109 = global_3.member[1u][0u];
            let _e113 = global_3.member[1u][1u];
            let _e117 = global_3.member[1u][2u];
            let _e121 = global_3.member[1u][3u];
            let _e125 = (_e80.x + (_e80.y * 2097152u));
            let _e132 = (_e125 < arrayLength((&global_4.member)));
            if _e132 {
                let _e133 = (_e125 < arrayLength((&global_2.member)));
                if _e133 {
                    let _e134 = (_e125 < arrayLength((&global_5.member)));
                    if _e134 {
                        if _e132 {
                        } else {
                            break;
                        }
                        let _e144 = global_4.member[_e125].member.member_2[0u];
                        let _e146 = (bitcast<u32>(_e144) & 2147483647u);
                        let _e152 = global_4.member[_e125].member.member_2[1u];
                        let _e154 = (bitcast<u32>(_e152) & 2147483647u);
                        let _e160 = global_4.member[_e125].member.member_2[2u];
                        let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                        let _e168 = global_4.member[_e125].member.member[0u];
                        let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                        let _e176 = global_4.member[_e125].member.member[1u];
                        let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                        let _e184 = global_4.member[_e125].member.member[2u];
                        let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                        let _e188 = select(_e154, _e146, (_e154 < _e146));
                        let _e190 = select(_e162, _e188, (_e162 < _e188));
                        let _e192 = select(_e170, _e190, (_e170 < _e190));
                        let _e194 = select(_e178, _e192, (_e178 < _e192));
                        let _e196 = select(_e186, _e194, (_e186 < _e194));
                        let _e201 = global_4.member[_e125].member.member_1;
                        let _e203 = (bitcast<u32>(_e201) & 2147483647u);
                        let _e211 = global_4.member[_e125].member.member_3;
                        let _e217 = (((select(_e203, _e196, (_e203 < _e196)) < 2139095040u) && ((bitcast<u32>(_e211) & 2147483647u) <= 2139095040u)) && (_e190 > 0u));
                        if _e217 {
                            let _e220 = (bitcast<u32>(bitcast<f32>(_e190)) & 2147483647u);
                            if (_e220 >= 8388608u) {
                                phi_342_ = (bitcast<i32>((_e220 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_342_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e220)), 32u, (_e220 == 0u))));
                            }
                            let _e234 = phi_342_;
                            phi_343_ = _e234;
                        } else {
                            phi_343_ = 0i;
                        }
                        let _e236 = phi_343_;
                        let _e237 = (_e146 == _e190);
                        if _e237 {
                            phi_353_ = true;
                        } else {
                            phi_353_ = (_e154 == _e190);
                        }
                        let _e240 = phi_353_;
                        let _e241 = select(1u, 0u, _e237);
                        if _e240 {
                            let _e242 = (_e241 + 1u);
                            phi_363_ = _e242;
                            phi_364_ = _e242;
                            phi_366_ = select(true, false, (_e242 == 2u));
                        } else {
                            phi_363_ = u32();
                            phi_364_ = 0u;
                            phi_366_ = true;
                        }
                        let _e246 = phi_363_;
                        let _e248 = phi_364_;
                        let _e250 = phi_366_;
                        if _e250 {
                            phi_371_ = (_e248 + 1u);
                        } else {
                            phi_371_ = 0u;
                        }
                        let _e254 = phi_371_;
                        let _e255 = select(_e246, _e248, _e250);
                        let _e256 = select(_e241, select(2u, _e241, _e240), _e250);
                        let _e257 = -(_e236);
                        if (_e257 < -126i) {
                            phi_403_ = -126i;
                        } else {
                            phi_403_ = select(_e257, 127i, (_e257 > 127i));
                        }
                        let _e262 = phi_403_;
                        let _e267 = bitcast<f32>((bitcast<u32>((_e262 + 127i)) << bitcast<u32>(23i)));
                        let _e273 = bitcast<f32>((bitcast<u32>(((_e257 - _e262) + 127i)) << bitcast<u32>(23i)));
                        let _e278 = global_4.member[_e125].member.member;
                        let _e279 = (_e255 == 0u);
                        if _e279 {
                            phi_421_ = _e278[0];
                        } else {
                            phi_421_ = _e278[1];
                        }
                        let _e283 = phi_421_;
                        let _e284 = (_e255 == 2u);
                        if _e284 {
                            phi_427_ = _e278[2];
                        } else {
                            phi_427_ = _e283;
                        }
                        let _e287 = phi_427_;
                        let _e288 = global_4.member[_e125].member.member_2;
                        if _e279 {
                            phi_438_ = _e288[0];
                        } else {
                            phi_438_ = _e288[1];
                        }
                        let _e292 = phi_438_;
                        if _e284 {
                            phi_444_ = _e288[2];
                        } else {
                            phi_444_ = _e292;
                        }
                        let _e295 = phi_444_;
                        let _e297 = ((_e295 * _e267) * _e273);
                        let _e301 = (bitcast<f32>((bitcast<u32>(_e297) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e301 {
                            let _e305 = (bitcast<f32>((bitcast<u32>(_e287) & 2147483647u)) * 0.00000011920929f);
                            phi_467_ = select(0.00000000000011368684f, _e305, (_e305 > 0.00000000000011368684f));
                        } else {
                            phi_467_ = 0f;
                        }
                        let _e309 = phi_467_;
                        let _e310 = (_e287 + _e309);
                        let _e311 = (_e287 - _e309);
                        let _e312 = select(_e297, 0f, _e301);
                        if _e301 {
                            phi_478_ = 38685626000000000000000000f;
                        } else {
                            phi_478_ = (1f / _e297);
                        }
                        let _e315 = phi_478_;
                        let _e316 = (_e254 == 0u);
                        if _e316 {
                            phi_487_ = _e278[0];
                        } else {
                            phi_487_ = _e278[1];
                        }
                        let _e320 = phi_487_;
                        let _e321 = (_e254 == 2u);
                        if _e321 {
                            phi_493_ = _e278[2];
                        } else {
                            phi_493_ = _e320;
                        }
                        let _e324 = phi_493_;
                        if _e316 {
                            phi_504_ = _e288[0];
                        } else {
                            phi_504_ = _e288[1];
                        }
                        let _e328 = phi_504_;
                        if _e321 {
                            phi_510_ = _e288[2];
                        } else {
                            phi_510_ = _e328;
                        }
                        let _e331 = phi_510_;
                        let _e333 = ((_e331 * _e267) * _e273);
                        let _e337 = (bitcast<f32>((bitcast<u32>(_e333) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e337 {
                            let _e341 = (bitcast<f32>((bitcast<u32>(_e324) & 2147483647u)) * 0.00000011920929f);
                            phi_533_ = select(0.00000000000011368684f, _e341, (_e341 > 0.00000000000011368684f));
                        } else {
                            phi_533_ = 0f;
                        }
                        let _e345 = phi_533_;
                        let _e346 = (_e324 + _e345);
                        let _e347 = (_e324 - _e345);
                        let _e348 = select(_e333, 0f, _e337);
                        if _e337 {
                            phi_544_ = 38685626000000000000000000f;
                        } else {
                            phi_544_ = (1f / _e333);
                        }
                        let _e351 = phi_544_;
                        let _e352 = (_e256 == 0u);
                        if _e352 {
                            phi_553_ = _e278[0];
                        } else {
                            phi_553_ = _e278[1];
                        }
                        let _e356 = phi_553_;
                        let _e357 = (_e256 == 2u);
                        if _e357 {
                            phi_559_ = _e278[2];
                        } else {
                            phi_559_ = _e356;
                        }
                        let _e360 = phi_559_;
                        if _e352 {
                            phi_570_ = _e288[0];
                        } else {
                            phi_570_ = _e288[1];
                        }
                        let _e364 = phi_570_;
                        if _e357 {
                            phi_576_ = _e288[2];
                        } else {
                            phi_576_ = _e364;
                        }
                        let _e367 = phi_576_;
                        let _e369 = ((_e367 * _e267) * _e273);
                        let _e373 = (bitcast<f32>((bitcast<u32>(_e369) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e373 {
                            let _e377 = (bitcast<f32>((bitcast<u32>(_e360) & 2147483647u)) * 0.00000011920929f);
                            phi_599_ = select(0.00000000000011368684f, _e377, (_e377 > 0.00000000000011368684f));
                        } else {
                            phi_599_ = 0f;
                        }
                        let _e381 = phi_599_;
                        let _e382 = (_e360 + _e381);
                        let _e383 = (_e360 - _e381);
                        let _e384 = select(_e369, 0f, _e373);
                        if _e373 {
                            phi_610_ = 38685626000000000000000000f;
                        } else {
                            phi_610_ = (1f / _e369);
                        }
                        let _e387 = phi_610_;
                        let _e390 = bitcast<f32>((bitcast<u32>(_e287) & 2147483647u));
                        let _e393 = bitcast<f32>((bitcast<u32>(_e324) & 2147483647u));
                        let _e395 = select(_e393, _e390, (_e390 > _e393));
                        let _e398 = bitcast<f32>((bitcast<u32>(_e360) & 2147483647u));
                        if (_e217 && (select(_e398, _e395, (_e395 > _e398)) <= 1099511600000f)) {
                            let _e403 = (_e236 / 3i);
                            let _e410 = bitcast<f32>((bitcast<u32>((_e403 + 127i)) << bitcast<u32>(23i)));
                            let _e417 = bitcast<f32>((bitcast<u32>(((_e236 - (2i * _e403)) + 127i)) << bitcast<u32>(23i)));
                            let _e418 = (((_e201 * _e410) * _e410) * _e417);
                            let _e420 = select(340282350000000000000000000000000000000f, _e418, (_e418 < 340282350000000000000000000000000000000f));
                            let _e425 = (((_e211 * _e410) * _e410) * _e417);
                            let _e427 = select(340282350000000000000000000000000000000f, _e425, (_e425 < 340282350000000000000000000000000000000f));
                            phi_710_ = select(-340282350000000000000000000000000000000f, _e427, (_e427 > -340282350000000000000000000000000000000f));
                            phi_711_ = select(-340282350000000000000000000000000000000f, _e420, (_e420 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_710_ = 0f;
                            phi_711_ = 1f;
                        }
                        let _e431 = phi_710_;
                        let _e433 = phi_711_;
                        if _e132 {
                        } else {
                            break;
                        }
                        let _e439 = global_4.member[_e125].member_2;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e97), bitcast<f32>(_e101), bitcast<f32>(_e105));
                        let _e443 = (_e255 % 3u);
                        let _e444 = (_e443 < 3u);
                        if _e444 {
                        } else {
                            break;
                        }
                        let _e446 = local_9[_e443];
                        let _e447 = (_e254 % 3u);
                        let _e448 = (_e447 < 3u);
                        if _e448 {
                        } else {
                            break;
                        }
                        let _e450 = local_9[_e447];
                        let _e451 = (_e256 % 3u);
                        let _e452 = (_e451 < 3u);
                        if _e452 {
                        } else {
                            break;
                        }
                        let _e454 = local_9[_e451];
                        local_8 = array<f32, 3>(bitcast<f32>(_e109), bitcast<f32>(_e113), bitcast<f32>(_e117));
                        if _e444 {
                        } else {
                            break;
                        }
                        let _e458 = local_8[_e443];
                        if _e448 {
                        } else {
                            break;
                        }
                        let _e460 = local_8[_e447];
                        if _e452 {
                        } else {
                            break;
                        }
                        let _e462 = local_8[_e451];
                        phi_3116_ = false;
                        phi_793_ = type_41(type_38(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e431), 0u, 0u);
                        phi_796_ = type_52(type_50(array<f32, 3>(_e446, _e450, _e454), array<f32, 3>(_e458, _e460, _e462)), select(0u, 2147483648u, (_e83 == 0u)));
                        phi_798_ = ((3u * _e83) + 1u);
                        phi_800_ = (_e433 <= _e431);
                        phi_802_ = 0u;
                        loop {
                            let _e470 = phi_3116_;
                            let _e472 = phi_793_;
                            let _e474 = phi_796_;
                            let _e476 = phi_798_;
                            let _e478 = phi_800_;
                            let _e480 = phi_802_;
                            local_10 = _e472;
                            local_11 = _e472;
                            if _e478 {
                                phi_813_ = true;
                            } else {
                                phi_813_ = (_e480 > 0u);
                            }
                            let _e483 = phi_813_;
                            if _e483 {
                                let _e484 = (_e476 > 0u);
                                if _e484 {
                                    if _e478 {
                                        phi_899_ = _e474;
                                        phi_900_ = _e478;
                                        phi_901_ = _e480;
                                    } else {
                                        let _e485 = (_e480 - 1u);
                                        let _e486 = (_e485 % 128u);
                                        let _e487 = (_e486 < 128u);
                                        if _e487 {
                                        } else {
                                            phi_3252_ = true;
                                            break;
                                        }
                                        let _e489 = local_6[_e486];
                                        if _e487 {
                                        } else {
                                            phi_3252_ = true;
                                            break;
                                        }
                                        let _e491 = local_5[_e486];
                                        if _e487 {
                                        } else {
                                            phi_3252_ = true;
                                            break;
                                        }
                                        let _e493 = local_4[_e486];
                                        if _e487 {
                                        } else {
                                            phi_3252_ = true;
                                            break;
                                        }
                                        let _e495 = local_3[_e486];
                                        if _e487 {
                                        } else {
                                            phi_3252_ = true;
                                            break;
                                        }
                                        let _e498 = local_2[_e486];
                                        if _e487 {
                                        } else {
                                            phi_3252_ = true;
                                            break;
                                        }
                                        let _e500 = local_1[_e486];
                                        if _e487 {
                                        } else {
                                            phi_3252_ = true;
                                            break;
                                        }
                                        let _e502 = local[_e486];
                                        if _e487 {
                                        } else {
                                            phi_3252_ = true;
                                            break;
                                        }
                                        let _e507 = local_7[_e486];
                                        phi_899_ = type_52(type_50(array<f32, 3>(_e491, _e493, _e495), array<f32, 3>(_e498, _e500, _e502)), _e489);
                                        phi_900_ = (_e507 <= _e472.member.member_1);
                                        phi_901_ = _e485;
                                    }
                                    let _e512 = phi_899_;
                                    let _e514 = phi_900_;
                                    let _e516 = phi_901_;
                                    if _e514 {
                                        if ((_e512.member_1 & 2147483648u) != 0u) {
                                            phi_919_ = _e472;
                                            phi_922_ = type_7(0u, ((_e512.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e875 = phi_919_;
                                                let _e877 = phi_922_;
                                                local_12 = _e875;
                                                if (_e877.member < _e877.member_1) {
                                                    phi_923_ = type_7((_e877.member + 1u), _e877.member_1);
                                                    phi_945_ = type_7(1u, _e877.member);
                                                } else {
                                                    phi_923_ = _e877;
                                                    phi_945_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e890 = phi_923_;
                                                let _e892 = phi_945_;
                                                let _e896 = (bitcast<i32>(_e892.member) != 0i);
                                                if _e896 {
                                                    let _e902 = type_41(_e875.member, _e875.member_1, (_e875.member_2 + 1u));
                                                    let _e903 = ((_e512.member_1 & 268435455u) + _e892.member_1);
                                                    let _e904 = (_e903 < _e85);
                                                    if _e904 {
                                                        if _e904 {
                                                        } else {
                                                            phi_3110_ = true;
                                                            break;
                                                        }
                                                        let _e908 = global_1.member[_e903].member_1;
                                                        phi_969_ = _e908;
                                                    } else {
                                                        phi_969_ = 4294967295u;
                                                    }
                                                    let _e910 = phi_969_;
                                                    if (_e903 >= _e85) {
                                                        phi_1058_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e904 {
                                                        } else {
                                                            phi_3110_ = true;
                                                            break;
                                                        }
                                                        if (_e443 < 9u) {
                                                        } else {
                                                            phi_3110_ = true;
                                                            break;
                                                        }
                                                        let _e917 = global_1.member[_e903].member[_e443];
                                                        if (_e447 < 9u) {
                                                        } else {
                                                            phi_3110_ = true;
                                                            break;
                                                        }
                                                        let _e923 = global_1.member[_e903].member[_e447];
                                                        if (_e451 < 9u) {
                                                        } else {
                                                            phi_3110_ = true;
                                                            break;
                                                        }
                                                        let _e929 = global_1.member[_e903].member[_e451];
                                                        let _e931 = (3u + _e443);
                                                        if (_e931 < 9u) {
                                                        } else {
                                                            phi_3110_ = true;
                                                            break;
                                                        }
                                                        let _e937 = global_1.member[_e903].member[_e931];
                                                        let _e938 = (3u + _e447);
                                                        if (_e938 < 9u) {
                                                        } else {
                                                            phi_3110_ = true;
                                                            break;
                                                        }
                                                        let _e944 = global_1.member[_e903].member[_e938];
                                                        let _e945 = (3u + _e451);
                                                        if (_e945 < 9u) {
                                                        } else {
                                                            phi_3110_ = true;
                                                            break;
                                                        }
                                                        let _e951 = global_1.member[_e903].member[_e945];
                                                        let _e953 = (6u + _e443);
                                                        if (_e953 < 9u) {
                                                        } else {
                                                            phi_3110_ = true;
                                                            break;
                                                        }
                                                        let _e959 = global_1.member[_e903].member[_e953];
                                                        let _e960 = (6u + _e447);
                                                        if (_e960 < 9u) {
                                                        } else {
                                                            phi_3110_ = true;
                                                            break;
                                                        }
                                                        let _e966 = global_1.member[_e903].member[_e960];
                                                        let _e967 = (6u + _e451);
                                                        if (_e967 < 9u) {
                                                        } else {
                                                            phi_3110_ = true;
                                                            break;
                                                        }
                                                        let _e973 = global_1.member[_e903].member[_e967];
                                                        phi_1058_ = array<array<f32, 3>, 3>(array<f32, 3>(_e917, _e923, _e929), array<f32, 3>(_e937, _e944, _e951), array<f32, 3>(_e959, _e966, _e973));
                                                    }
                                                    let _e977 = phi_1058_;
                                                    let _e986 = (_e977[0][2] - _e360);
                                                    let _e989 = (((_e977[0][0] - _e287) * _e384) - (_e986 * _e312));
                                                    let _e992 = (((_e977[0][1] - _e324) * _e384) - (_e986 * _e348));
                                                    let _e999 = (_e977[1][2] - _e360);
                                                    let _e1002 = (((_e977[1][0] - _e287) * _e384) - (_e999 * _e312));
                                                    let _e1005 = (((_e977[1][1] - _e324) * _e384) - (_e999 * _e348));
                                                    let _e1012 = (_e977[2][2] - _e360);
                                                    let _e1015 = (((_e977[2][0] - _e287) * _e384) - (_e1012 * _e312));
                                                    let _e1018 = (((_e977[2][1] - _e324) * _e384) - (_e1012 * _e348));
                                                    let _e1019 = (_e1015 * _e1005);
                                                    let _e1020 = (_e1018 * _e1002);
                                                    let _e1021 = (_e989 * _e1018);
                                                    let _e1022 = (_e992 * _e1015);
                                                    let _e1023 = (_e1002 * _e992);
                                                    let _e1024 = (_e1005 * _e989);
                                                    let _e1029 = (((_e1019 >= _e1020) && (_e1021 >= _e1022)) && (_e1023 >= _e1024));
                                                    if (_e1029 || (((_e1019 <= _e1020) && (_e1021 <= _e1022)) && (_e1023 <= _e1024))) {
                                                        let _e1036 = select(-1f, 1f, _e1029);
                                                        let _e1038 = ((_e1019 - _e1020) * _e1036);
                                                        let _e1040 = select(0f, _e1038, (_e1038 > 0f));
                                                        let _e1042 = ((_e1021 - _e1022) * _e1036);
                                                        let _e1044 = select(0f, _e1042, (_e1042 > 0f));
                                                        let _e1046 = ((_e1023 - _e1024) * _e1036);
                                                        let _e1048 = select(0f, _e1046, (_e1046 > 0f));
                                                        let _e1050 = ((_e1040 + _e1044) + _e1048);
                                                        if (_e1050 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1883_ = type_23();
                                                            phi_1884_ = true;
                                                            phi_1885_ = false;
                                                        } else {
                                                            let _e1053 = select(_e1002, _e989, (_e989 < _e1002));
                                                            if (select(_e1015, _e1053, (_e1053 < _e1015)) > 0f) {
                                                                phi_1175_ = true;
                                                            } else {
                                                                let _e1058 = select(_e1002, _e989, (_e989 > _e1002));
                                                                phi_1175_ = (select(_e1015, _e1058, (_e1058 > _e1015)) < 0f);
                                                            }
                                                            let _e1063 = phi_1175_;
                                                            if _e1063 {
                                                                phi_1880_ = type_23();
                                                                phi_1881_ = true;
                                                                phi_1882_ = false;
                                                            } else {
                                                                let _e1065 = select(_e1005, _e992, (_e992 < _e1005));
                                                                if (select(_e1018, _e1065, (_e1065 < _e1018)) > 0f) {
                                                                    phi_1204_ = true;
                                                                } else {
                                                                    let _e1070 = select(_e1005, _e992, (_e992 > _e1005));
                                                                    phi_1204_ = (select(_e1018, _e1070, (_e1070 > _e1018)) < 0f);
                                                                }
                                                                let _e1075 = phi_1204_;
                                                                if _e1075 {
                                                                    phi_1878_ = type_23();
                                                                    phi_1879_ = false;
                                                                } else {
                                                                    let _e1077 = select(_e977[1][0], _e977[0][0], (_e977[0][0] < _e977[1][0]));
                                                                    let _e1081 = select(_e977[1][0], _e977[0][0], (_e977[0][0] > _e977[1][0]));
                                                                    let _e1085 = select(_e977[1][1], _e977[0][1], (_e977[0][1] < _e977[1][1]));
                                                                    let _e1089 = select(_e977[1][1], _e977[0][1], (_e977[0][1] > _e977[1][1]));
                                                                    let _e1093 = select(_e977[1][2], _e977[0][2], (_e977[0][2] < _e977[1][2]));
                                                                    let _e1097 = select(_e977[1][2], _e977[0][2], (_e977[0][2] > _e977[1][2]));
                                                                    let _e1102 = ((select(_e977[2][0], _e1077, (_e1077 < _e977[2][0])) - _e310) * _e315);
                                                                    let _e1103 = ((select(_e977[2][0], _e1081, (_e1081 > _e977[2][0])) - _e311) * _e315);
                                                                    let _e1106 = ((select(_e977[2][1], _e1085, (_e1085 < _e977[2][1])) - _e346) * _e351);
                                                                    let _e1107 = ((select(_e977[2][1], _e1089, (_e1089 > _e977[2][1])) - _e347) * _e351);
                                                                    let _e1110 = ((select(_e977[2][2], _e1093, (_e1093 < _e977[2][2])) - _e382) * _e387);
                                                                    let _e1111 = ((select(_e977[2][2], _e1097, (_e1097 > _e977[2][2])) - _e383) * _e387);
                                                                    let _e1113 = select(_e1111, _e1110, (_e1110 < _e1111));
                                                                    let _e1115 = select(_e1111, _e1110, (_e1110 > _e1111));
                                                                    let _e1117 = select(_e1103, _e1102, (_e1102 < _e1103));
                                                                    let _e1119 = select(_e1107, _e1106, (_e1106 < _e1107));
                                                                    let _e1121 = select(_e1119, _e1117, (_e1117 > _e1119));
                                                                    let _e1123 = select(_e1113, _e1121, (_e1121 > _e1113));
                                                                    let _e1125 = select(_e1103, _e1102, (_e1102 > _e1103));
                                                                    let _e1127 = select(_e1107, _e1106, (_e1106 > _e1107));
                                                                    let _e1129 = select(_e1127, _e1125, (_e1125 < _e1127));
                                                                    let _e1131 = select(_e1115, _e1129, (_e1129 < _e1115));
                                                                    let _e1132 = -(_e1113);
                                                                    let _e1138 = select(_e433, _e1123, (_e1123 > _e433));
                                                                    if (_e1138 > (_e1131 + (select(_e1132, _e1115, (_e1115 > _e1132)) * 0.0000019073523f))) {
                                                                        phi_1873_ = type_23();
                                                                        phi_1874_ = true;
                                                                    } else {
                                                                        let _e1140 = (_e1138 > _e875.member.member_1);
                                                                        if _e1140 {
                                                                            phi_1872_ = type_23();
                                                                        } else {
                                                                            let _e1141 = vec3<f32>(_e977[0][0], _e977[0][1], _e977[0][2]);
                                                                            let _e1142 = vec3<f32>(_e977[1][0], _e977[1][1], _e977[1][2]);
                                                                            let _e1143 = vec3<f32>(_e977[2][0], _e977[2][1], _e977[2][2]);
                                                                            let _e1144 = (_e977[1][0] - _e977[0][0]);
                                                                            let _e1145 = (_e977[1][1] - _e977[0][1]);
                                                                            let _e1146 = (_e977[1][2] - _e977[0][2]);
                                                                            let _e1147 = vec3<f32>(_e1144, _e1145, _e1146);
                                                                            let _e1148 = (_e977[2][0] - _e977[1][0]);
                                                                            let _e1149 = (_e977[2][1] - _e977[1][1]);
                                                                            let _e1150 = (_e977[2][2] - _e977[1][2]);
                                                                            let _e1151 = vec3<f32>(_e1148, _e1149, _e1150);
                                                                            let _e1152 = (_e977[0][0] - _e977[2][0]);
                                                                            let _e1153 = (_e977[0][1] - _e977[2][1]);
                                                                            let _e1154 = (_e977[0][2] - _e977[2][2]);
                                                                            let _e1155 = vec3<f32>(_e1152, _e1153, _e1154);
                                                                            let _e1158 = bitcast<f32>((bitcast<u32>(_e1144) & 2147483647u));
                                                                            let _e1161 = bitcast<f32>((bitcast<u32>(_e1145) & 2147483647u));
                                                                            let _e1163 = select(_e1161, _e1158, (_e1158 > _e1161));
                                                                            let _e1166 = bitcast<f32>((bitcast<u32>(_e1146) & 2147483647u));
                                                                            let _e1168 = select(_e1166, _e1163, (_e1163 > _e1166));
                                                                            let _e1171 = bitcast<f32>((bitcast<u32>(_e1148) & 2147483647u));
                                                                            let _e1174 = bitcast<f32>((bitcast<u32>(_e1149) & 2147483647u));
                                                                            let _e1176 = select(_e1174, _e1171, (_e1171 > _e1174));
                                                                            let _e1179 = bitcast<f32>((bitcast<u32>(_e1150) & 2147483647u));
                                                                            let _e1181 = select(_e1179, _e1176, (_e1176 > _e1179));
                                                                            let _e1184 = bitcast<f32>((bitcast<u32>(_e1152) & 2147483647u));
                                                                            let _e1187 = bitcast<f32>((bitcast<u32>(_e1153) & 2147483647u));
                                                                            let _e1189 = select(_e1187, _e1184, (_e1184 > _e1187));
                                                                            let _e1192 = bitcast<f32>((bitcast<u32>(_e1154) & 2147483647u));
                                                                            let _e1194 = select(_e1192, _e1189, (_e1189 > _e1192));
                                                                            let _e1196 = select(_e1181, _e1168, (_e1168 > _e1181));
                                                                            let _e1198 = select(_e1194, _e1196, (_e1196 > _e1194));
                                                                            if (_e1168 == _e1198) {
                                                                                phi_1605_ = _e1005;
                                                                                phi_1606_ = _e1002;
                                                                                phi_1607_ = _e992;
                                                                                phi_1608_ = _e989;
                                                                                phi_1609_ = _e1141;
                                                                                phi_1610_ = _e1155;
                                                                                phi_1611_ = _e1151;
                                                                                phi_1612_ = _e1147;
                                                                            } else {
                                                                                let _e1200 = (_e1181 == _e1198);
                                                                                let _e1205 = vec3(_e1200);
                                                                                phi_1605_ = select(_e992, _e1018, _e1200);
                                                                                phi_1606_ = select(_e989, _e1015, _e1200);
                                                                                phi_1607_ = select(_e1018, _e1005, _e1200);
                                                                                phi_1608_ = select(_e1015, _e1002, _e1200);
                                                                                phi_1609_ = select(_e1143, _e1142, _e1205);
                                                                                phi_1610_ = select(_e1151, _e1147, _e1205);
                                                                                phi_1611_ = select(_e1147, _e1155, _e1205);
                                                                                phi_1612_ = select(_e1155, _e1151, _e1205);
                                                                            }
                                                                            let _e1211 = phi_1605_;
                                                                            let _e1213 = phi_1606_;
                                                                            let _e1215 = phi_1607_;
                                                                            let _e1217 = phi_1608_;
                                                                            let _e1219 = phi_1609_;
                                                                            let _e1221 = phi_1610_;
                                                                            let _e1223 = phi_1611_;
                                                                            let _e1225 = phi_1612_;
                                                                            let _e1232 = ((_e1223.y * _e1221.z) - (_e1221.y * _e1223.z));
                                                                            let _e1237 = ((_e1223.z * _e1221.x) - (_e1221.z * _e1223.x));
                                                                            let _e1240 = ((_e1223.x * _e1221.y) - (_e1221.x * _e1223.y));
                                                                            if (_e1040 >= _e1044) {
                                                                                phi_1643_ = select(true, false, (_e1040 >= _e1048));
                                                                            } else {
                                                                                phi_1643_ = true;
                                                                            }
                                                                            let _e1245 = phi_1643_;
                                                                            if _e1245 {
                                                                                phi_1652_ = select(_e1143, _e1142, vec3((_e1044 >= _e1048)));
                                                                            } else {
                                                                                phi_1652_ = _e1141;
                                                                            }
                                                                            let _e1250 = phi_1652_;
                                                                            let _e1261 = (((_e1232 * (_e1250.x - _e287)) + (_e1237 * (_e1250.y - _e324))) + (_e1240 * (_e1250.z - _e360)));
                                                                            let _e1266 = (((_e1232 * _e312) + (_e1237 * _e348)) + (_e1240 * _e384));
                                                                            let _e1267 = (_e1213 - _e1217);
                                                                            let _e1268 = (_e1211 - _e1215);
                                                                            let _e1276 = (-(((_e1217 * _e1267) + (_e1215 * _e1268))) / ((_e1267 * _e1267) + (_e1268 * _e1268)));
                                                                            let _e1278 = select(1f, _e1276, (_e1276 < 1f));
                                                                            let _e1280 = select(0f, _e1278, (_e1278 > 0f));
                                                                            let _e1293 = ((_e1219.x + (_e1225.x * _e1280)) - _e287);
                                                                            let _e1294 = ((_e1219.y + (_e1225.y * _e1280)) - _e324);
                                                                            let _e1295 = ((_e1219.z + (_e1225.z * _e1280)) - _e360);
                                                                            let _e1296 = (_e1295 / _e384);
                                                                            let _e1308 = bitcast<f32>((bitcast<u32>(_e1293) & 2147483647u));
                                                                            let _e1311 = bitcast<f32>((bitcast<u32>(_e1294) & 2147483647u));
                                                                            let _e1313 = select(_e1311, _e1308, (_e1308 > _e1311));
                                                                            let _e1316 = bitcast<f32>((bitcast<u32>(_e1295) & 2147483647u));
                                                                            let _e1318 = select(_e1316, _e1313, (_e1313 > _e1316));
                                                                            let _e1324 = bitcast<f32>((bitcast<u32>(_e1232) & 2147483647u));
                                                                            let _e1327 = bitcast<f32>((bitcast<u32>(_e1237) & 2147483647u));
                                                                            let _e1329 = select(_e1327, _e1324, (_e1324 > _e1327));
                                                                            let _e1332 = bitcast<f32>((bitcast<u32>(_e1240) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1232 * _e1293) + (_e1237 * _e1294)) + (_e1240 * _e1295)) - _e1261)) & 2147483647u)) <= ((0.0000009536743f * select(_e1198, _e1318, (_e1318 > _e1198))) * select(_e1332, _e1329, (_e1329 > _e1332)))) {
                                                                                let _e1342 = bitcast<f32>((bitcast<u32>(_e1223.x) & 2147483647u));
                                                                                let _e1345 = bitcast<f32>((bitcast<u32>(_e1223.y) & 2147483647u));
                                                                                let _e1347 = select(_e1345, _e1342, (_e1342 > _e1345));
                                                                                let _e1350 = bitcast<f32>((bitcast<u32>(_e1223.z) & 2147483647u));
                                                                                let _e1356 = bitcast<f32>((bitcast<u32>(_e1221.x) & 2147483647u));
                                                                                let _e1359 = bitcast<f32>((bitcast<u32>(_e1221.y) & 2147483647u));
                                                                                let _e1361 = select(_e1359, _e1356, (_e1356 > _e1359));
                                                                                let _e1364 = bitcast<f32>((bitcast<u32>(_e1221.z) & 2147483647u));
                                                                                let _e1368 = (bitcast<f32>((bitcast<u32>(_e1266) & 2147483647u)) > ((0.0000038146973f * select(_e1350, _e1347, (_e1347 > _e1350))) * select(_e1364, _e1361, (_e1361 > _e1364))));
                                                                                if _e1368 {
                                                                                    phi_1817_ = (_e1261 / _e1266);
                                                                                } else {
                                                                                    phi_1817_ = f32();
                                                                                }
                                                                                let _e1371 = phi_1817_;
                                                                                phi_1819_ = _e1371;
                                                                                phi_1820_ = select(true, false, _e1368);
                                                                            } else {
                                                                                phi_1819_ = f32();
                                                                                phi_1820_ = true;
                                                                            }
                                                                            let _e1374 = phi_1819_;
                                                                            let _e1376 = phi_1820_;
                                                                            if _e1376 {
                                                                                let _e1384 = (((_e1232 * (_e1293 - (_e312 * _e1296))) + (_e1237 * (_e1294 - (_e348 * _e1296)))) / _e1266);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1384) & 2147483647u)) <= _e1198) {
                                                                                    phi_1840_ = (_e1296 + _e1384);
                                                                                } else {
                                                                                    phi_1840_ = _e1296;
                                                                                }
                                                                                let _e1391 = phi_1840_;
                                                                                phi_1841_ = _e1391;
                                                                            } else {
                                                                                phi_1841_ = _e1374;
                                                                            }
                                                                            let _e1393 = phi_1841_;
                                                                            let _e1395 = select(_e1131, _e1393, (_e1393 < _e1131));
                                                                            let _e1397 = select(_e1123, _e1395, (_e1395 > _e1123));
                                                                            if (_e1397 >= _e433) {
                                                                                let _e1399 = (_e1397 <= _e875.member.member_1);
                                                                                if _e1399 {
                                                                                    let _e1400 = (1f / _e1050);
                                                                                    phi_1864_ = type_23(_e1397, (_e1044 * _e1400), (_e1048 * _e1400), _e910);
                                                                                } else {
                                                                                    phi_1864_ = type_23();
                                                                                }
                                                                                let _e1405 = phi_1864_;
                                                                                phi_1866_ = _e1405;
                                                                                phi_1867_ = select(true, false, _e1399);
                                                                            } else {
                                                                                phi_1866_ = type_23();
                                                                                phi_1867_ = true;
                                                                            }
                                                                            let _e1408 = phi_1866_;
                                                                            let _e1410 = phi_1867_;
                                                                            if _e1410 {
                                                                                phi_1871_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_1871_ = _e1408;
                                                                            }
                                                                            let _e1412 = phi_1871_;
                                                                            phi_1872_ = _e1412;
                                                                        }
                                                                        let _e1414 = phi_1872_;
                                                                        phi_1873_ = _e1414;
                                                                        phi_1874_ = _e1140;
                                                                    }
                                                                    let _e1416 = phi_1873_;
                                                                    let _e1418 = phi_1874_;
                                                                    phi_1878_ = _e1416;
                                                                    phi_1879_ = _e1418;
                                                                }
                                                                let _e1420 = phi_1878_;
                                                                let _e1422 = phi_1879_;
                                                                phi_1880_ = _e1420;
                                                                phi_1881_ = _e1075;
                                                                phi_1882_ = _e1422;
                                                            }
                                                            let _e1424 = phi_1880_;
                                                            let _e1426 = phi_1881_;
                                                            let _e1428 = phi_1882_;
                                                            phi_1883_ = _e1424;
                                                            phi_1884_ = _e1426;
                                                            phi_1885_ = _e1428;
                                                        }
                                                        let _e1430 = phi_1883_;
                                                        let _e1432 = phi_1884_;
                                                        let _e1434 = phi_1885_;
                                                        phi_1893_ = _e1430;
                                                        phi_1894_ = select(_e1434, true, _e1432);
                                                    } else {
                                                        phi_1893_ = type_23();
                                                        phi_1894_ = true;
                                                    }
                                                    let _e1437 = phi_1893_;
                                                    let _e1439 = phi_1894_;
                                                    if _e1439 {
                                                        phi_1898_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1898_ = _e1437;
                                                    }
                                                    let _e1441 = phi_1898_;
                                                    if (_e1441.member_3 != 4294967295u) {
                                                        if (_e910 != _e439) {
                                                            if (_e1441.member < _e875.member.member.member) {
                                                                phi_1924_ = true;
                                                            } else {
                                                                if (_e1441.member == _e875.member.member.member) {
                                                                    phi_1923_ = (_e1441.member_3 < _e875.member.member.member_3);
                                                                } else {
                                                                    phi_1923_ = false;
                                                                }
                                                                let _e1456 = phi_1923_;
                                                                phi_1924_ = _e1456;
                                                            }
                                                            let _e1458 = phi_1924_;
                                                            if _e1458 {
                                                                phi_1931_ = type_41(type_38(_e1441, _e1441.member), _e902.member_1, _e902.member_2);
                                                            } else {
                                                                phi_1931_ = _e902;
                                                            }
                                                            let _e1465 = phi_1931_;
                                                            phi_1932_ = _e1465;
                                                        } else {
                                                            phi_1932_ = _e902;
                                                        }
                                                        let _e1467 = phi_1932_;
                                                        phi_1933_ = _e1467;
                                                    } else {
                                                        phi_1933_ = _e902;
                                                    }
                                                    let _e1469 = phi_1933_;
                                                    phi_920_ = _e1469;
                                                } else {
                                                    phi_920_ = type_41();
                                                }
                                                let _e1471 = phi_920_;
                                                continue;
                                                continuing {
                                                    phi_919_ = _e1471;
                                                    phi_922_ = _e890;
                                                    phi_3110_ = _e470;
                                                    break if !(_e896);
                                                }
                                            }
                                            let _e1474 = phi_3110_;
                                            phi_3252_ = _e1474;
                                            if _e1474 {
                                                break;
                                            }
                                            phi_3256_ = _e1474;
                                            let _e1703 = local_12;
                                            phi_2885_ = _e1703;
                                            phi_2886_ = _e512;
                                            phi_2887_ = false;
                                            phi_2888_ = _e516;
                                        } else {
                                            let _e531 = (_e512.member_1 < _e83);
                                            if _e531 {
                                                if _e531 {
                                                } else {
                                                    phi_3252_ = true;
                                                    break;
                                                }
                                                let _e533 = global_7.member[_e512.member_1];
                                                phi_1955_ = _e533;
                                            } else {
                                                phi_1955_ = type_45(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e535 = phi_1955_;
                                            let _e550 = ((10u * _e255) & 31u);
                                            let _e553 = ((_e535.member[0] >> bitcast<u32>(_e550)) & 1023u);
                                            let _e558 = bitcast<f32>((bitcast<u32>(((_e512.member.member_1[0] - _e512.member.member[0]) * 0.0009775171f)) ^ _e121));
                                            let _e564 = (_e512.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e553) * _e558)) ^ _e121)));
                                            let _e568 = select(select(_e512.member.member_1[0], _e564, (_e564 < _e512.member.member_1[0])), _e512.member.member_1[0], (_e553 == 1023u));
                                            let _e570 = ((10u * _e254) & 31u);
                                            let _e573 = ((_e535.member[0] >> bitcast<u32>(_e570)) & 1023u);
                                            let _e578 = bitcast<f32>((bitcast<u32>(((_e512.member.member_1[1] - _e512.member.member[1]) * 0.0009775171f)) ^ _e121));
                                            let _e584 = (_e512.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e573) * _e578)) ^ _e121)));
                                            let _e588 = select(select(_e512.member.member_1[1], _e584, (_e584 < _e512.member.member_1[1])), _e512.member.member_1[1], (_e573 == 1023u));
                                            let _e590 = ((10u * _e256) & 31u);
                                            let _e593 = ((_e535.member[0] >> bitcast<u32>(_e590)) & 1023u);
                                            let _e598 = bitcast<f32>((bitcast<u32>(((_e512.member.member_1[2] - _e512.member.member[2]) * 0.0009775171f)) ^ _e121));
                                            let _e604 = (_e512.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e593) * _e598)) ^ _e121)));
                                            let _e608 = select(select(_e512.member.member_1[2], _e604, (_e604 < _e512.member.member_1[2])), _e512.member.member_1[2], (_e593 == 1023u));
                                            let _e611 = ((_e535.member[1] >> bitcast<u32>(_e550)) & 1023u);
                                            let _e617 = (_e512.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e611) * _e558)) ^ _e121)));
                                            let _e621 = select(select(_e512.member.member_1[0], _e617, (_e617 < _e512.member.member_1[0])), _e512.member.member_1[0], (_e611 == 1023u));
                                            let _e624 = ((_e535.member[1] >> bitcast<u32>(_e570)) & 1023u);
                                            let _e630 = (_e512.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e624) * _e578)) ^ _e121)));
                                            let _e634 = select(select(_e512.member.member_1[1], _e630, (_e630 < _e512.member.member_1[1])), _e512.member.member_1[1], (_e624 == 1023u));
                                            let _e637 = ((_e535.member[1] >> bitcast<u32>(_e590)) & 1023u);
                                            let _e643 = (_e512.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e637) * _e598)) ^ _e121)));
                                            let _e647 = select(select(_e512.member.member_1[2], _e643, (_e643 < _e512.member.member_1[2])), _e512.member.member_1[2], (_e637 == 1023u));
                                            let _e653 = ((_e535.member_1[0] >> bitcast<u32>(_e550)) & 1023u);
                                            let _e659 = (_e512.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e653) * _e558)) ^ _e121)));
                                            let _e663 = select(select(_e512.member.member_1[0], _e659, (_e659 < _e512.member.member_1[0])), _e512.member.member_1[0], (_e653 == 1023u));
                                            let _e666 = ((_e535.member_1[0] >> bitcast<u32>(_e570)) & 1023u);
                                            let _e672 = (_e512.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e666) * _e578)) ^ _e121)));
                                            let _e676 = select(select(_e512.member.member_1[1], _e672, (_e672 < _e512.member.member_1[1])), _e512.member.member_1[1], (_e666 == 1023u));
                                            let _e679 = ((_e535.member_1[0] >> bitcast<u32>(_e590)) & 1023u);
                                            let _e685 = (_e512.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e679) * _e598)) ^ _e121)));
                                            let _e689 = select(select(_e512.member.member_1[2], _e685, (_e685 < _e512.member.member_1[2])), _e512.member.member_1[2], (_e679 == 1023u));
                                            let _e692 = ((_e535.member_1[1] >> bitcast<u32>(_e550)) & 1023u);
                                            let _e698 = (_e512.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e692) * _e558)) ^ _e121)));
                                            let _e702 = select(select(_e512.member.member_1[0], _e698, (_e698 < _e512.member.member_1[0])), _e512.member.member_1[0], (_e692 == 1023u));
                                            let _e705 = ((_e535.member_1[1] >> bitcast<u32>(_e570)) & 1023u);
                                            let _e711 = (_e512.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e705) * _e578)) ^ _e121)));
                                            let _e715 = select(select(_e512.member.member_1[1], _e711, (_e711 < _e512.member.member_1[1])), _e512.member.member_1[1], (_e705 == 1023u));
                                            let _e718 = ((_e535.member_1[1] >> bitcast<u32>(_e590)) & 1023u);
                                            let _e724 = (_e512.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e718) * _e598)) ^ _e121)));
                                            let _e728 = select(select(_e512.member.member_1[2], _e724, (_e724 < _e512.member.member_1[2])), _e512.member.member_1[2], (_e718 == 1023u));
                                            let _e733 = type_52(type_50(array<f32, 3>(_e568, _e588, _e608), array<f32, 3>(_e621, _e634, _e647)), _e535.member_2);
                                            let _e738 = type_52(type_50(array<f32, 3>(_e663, _e676, _e689), array<f32, 3>(_e702, _e715, _e728)), _e535.member_3);
                                            let _e745 = ((_e568 - _e310) * _e315);
                                            let _e746 = ((_e663 - _e310) * _e315);
                                            let _e747 = ((_e621 - _e311) * _e315);
                                            let _e748 = ((_e702 - _e311) * _e315);
                                            let _e753 = ((_e588 - _e346) * _e351);
                                            let _e754 = ((_e676 - _e346) * _e351);
                                            let _e755 = ((_e634 - _e347) * _e351);
                                            let _e756 = ((_e715 - _e347) * _e351);
                                            let _e761 = ((_e608 - _e382) * _e387);
                                            let _e762 = ((_e689 - _e382) * _e387);
                                            let _e763 = ((_e647 - _e383) * _e387);
                                            let _e764 = ((_e728 - _e383) * _e387);
                                            let _e766 = select(_e763, _e761, (_e761 < _e763));
                                            let _e768 = select(_e764, _e762, (_e762 < _e764));
                                            let _e770 = select(_e763, _e761, (_e761 > _e763));
                                            let _e772 = select(_e764, _e762, (_e762 > _e764));
                                            let _e774 = select(_e747, _e745, (_e745 < _e747));
                                            let _e776 = select(_e748, _e746, (_e746 < _e748));
                                            let _e778 = select(_e755, _e753, (_e753 < _e755));
                                            let _e780 = select(_e756, _e754, (_e754 < _e756));
                                            let _e782 = select(_e778, _e774, (_e774 > _e778));
                                            let _e784 = select(_e780, _e776, (_e776 > _e780));
                                            let _e786 = select(_e766, _e782, (_e782 > _e766));
                                            let _e788 = select(_e768, _e784, (_e784 > _e768));
                                            let _e790 = select(_e747, _e745, (_e745 > _e747));
                                            let _e792 = select(_e748, _e746, (_e746 > _e748));
                                            let _e794 = select(_e755, _e753, (_e753 > _e755));
                                            let _e796 = select(_e756, _e754, (_e754 > _e756));
                                            let _e798 = select(_e794, _e790, (_e790 < _e794));
                                            let _e800 = select(_e796, _e792, (_e792 < _e796));
                                            let _e805 = -(_e766);
                                            let _e806 = -(_e768);
                                            let _e813 = (select(_e770, _e798, (_e798 < _e770)) + (select(_e805, _e770, (_e770 > _e805)) * 0.0000019073523f));
                                            let _e814 = (select(_e772, _e800, (_e800 < _e772)) + (select(_e806, _e772, (_e772 > _e806)) * 0.0000019073523f));
                                            let _e816 = select(_e433, _e786, (_e786 > _e433));
                                            let _e818 = select(_e433, _e788, (_e788 > _e433));
                                            let _e823 = (_e816 <= select(_e472.member.member_1, _e813, (_e813 < _e472.member.member_1)));
                                            let _e824 = (_e818 <= select(_e472.member.member_1, _e814, (_e814 < _e472.member.member_1)));
                                            let _e825 = (_e816 <= _e818);
                                            if _e823 {
                                                if _e824 {
                                                    if _e825 {
                                                        phi_2787_ = _e738;
                                                    } else {
                                                        phi_2787_ = _e733;
                                                    }
                                                    let _e827 = phi_2787_;
                                                    let _e835 = (_e516 % 128u);
                                                    let _e836 = (_e835 < 128u);
                                                    if _e836 {
                                                    } else {
                                                        phi_3252_ = true;
                                                        break;
                                                    }
                                                    local_6[_e835] = _e827.member_1;
                                                    if _e836 {
                                                    } else {
                                                        phi_3252_ = true;
                                                        break;
                                                    }
                                                    local_5[_e835] = _e827.member.member[0];
                                                    if _e836 {
                                                    } else {
                                                        phi_3252_ = true;
                                                        break;
                                                    }
                                                    local_4[_e835] = _e827.member.member[1];
                                                    if _e836 {
                                                    } else {
                                                        phi_3252_ = true;
                                                        break;
                                                    }
                                                    local_3[_e835] = _e827.member.member[2];
                                                    if _e836 {
                                                    } else {
                                                        phi_3252_ = true;
                                                        break;
                                                    }
                                                    local_2[_e835] = _e827.member.member_1[0];
                                                    if _e836 {
                                                    } else {
                                                        phi_3252_ = true;
                                                        break;
                                                    }
                                                    local_1[_e835] = _e827.member.member_1[1];
                                                    if _e836 {
                                                    } else {
                                                        phi_3252_ = true;
                                                        break;
                                                    }
                                                    local[_e835] = _e827.member.member_1[2];
                                                    if _e836 {
                                                    } else {
                                                        phi_3252_ = true;
                                                        break;
                                                    }
                                                    local_7[_e835] = select(_e818, _e816, (_e816 > _e818));
                                                    if _e825 {
                                                        phi_2864_ = _e733;
                                                    } else {
                                                        phi_2864_ = _e738;
                                                    }
                                                    let _e853 = phi_2864_;
                                                    phi_2865_ = _e853;
                                                    phi_2866_ = (_e516 + 1u);
                                                } else {
                                                    phi_2865_ = type_52();
                                                    phi_2866_ = u32();
                                                }
                                                let _e855 = phi_2865_;
                                                let _e857 = phi_2866_;
                                                phi_2868_ = _e855;
                                                phi_2869_ = _e857;
                                                phi_2870_ = select(true, false, _e824);
                                            } else {
                                                phi_2868_ = type_52();
                                                phi_2869_ = u32();
                                                phi_2870_ = true;
                                            }
                                            let _e860 = phi_2868_;
                                            let _e862 = phi_2869_;
                                            let _e864 = phi_2870_;
                                            if _e864 {
                                                if _e823 {
                                                    phi_2877_ = _e733;
                                                } else {
                                                    phi_2877_ = _e738;
                                                }
                                                let _e866 = phi_2877_;
                                                phi_2882_ = _e866;
                                                phi_2883_ = select(_e824, true, _e823);
                                            } else {
                                                phi_2882_ = _e860;
                                                phi_2883_ = _e514;
                                            }
                                            let _e869 = phi_2882_;
                                            let _e871 = phi_2883_;
                                            phi_3256_ = _e470;
                                            phi_2885_ = type_41(_e472.member, (_e472.member_1 + 1u), _e472.member_2);
                                            phi_2886_ = _e869;
                                            phi_2887_ = _e871;
                                            phi_2888_ = select(_e862, _e516, _e864);
                                        }
                                        let _e1476 = phi_3256_;
                                        let _e1478 = phi_2885_;
                                        let _e1480 = phi_2886_;
                                        let _e1482 = phi_2887_;
                                        let _e1484 = phi_2888_;
                                        phi_3255_ = _e1476;
                                        phi_2889_ = _e1478;
                                        phi_2890_ = _e1480;
                                        phi_2891_ = (_e476 - 1u);
                                        phi_2892_ = _e1482;
                                        phi_2893_ = _e1484;
                                    } else {
                                        phi_3255_ = _e470;
                                        phi_2889_ = _e472;
                                        phi_2890_ = _e512;
                                        phi_2891_ = _e476;
                                        phi_2892_ = _e514;
                                        phi_2893_ = _e516;
                                    }
                                    let _e1486 = phi_3255_;
                                    let _e1488 = phi_2889_;
                                    let _e1490 = phi_2890_;
                                    let _e1492 = phi_2891_;
                                    let _e1494 = phi_2892_;
                                    let _e1496 = phi_2893_;
                                    phi_3254_ = _e1486;
                                    phi_2894_ = _e1488;
                                    phi_2895_ = _e1490;
                                    phi_2896_ = _e1492;
                                    phi_2897_ = _e1494;
                                    phi_2898_ = _e1496;
                                } else {
                                    phi_3254_ = _e470;
                                    phi_2894_ = type_41();
                                    phi_2895_ = type_52();
                                    phi_2896_ = u32();
                                    phi_2897_ = bool();
                                    phi_2898_ = u32();
                                }
                                let _e1498 = phi_3254_;
                                let _e1500 = phi_2894_;
                                let _e1502 = phi_2895_;
                                let _e1504 = phi_2896_;
                                let _e1506 = phi_2897_;
                                let _e1508 = phi_2898_;
                                phi_3253_ = _e1498;
                                phi_794_ = _e1500;
                                phi_797_ = _e1502;
                                phi_799_ = _e1504;
                                phi_801_ = _e1506;
                                phi_803_ = _e1508;
                                phi_2899_ = _e484;
                            } else {
                                phi_3253_ = _e470;
                                phi_794_ = type_41();
                                phi_797_ = type_52();
                                phi_799_ = u32();
                                phi_801_ = bool();
                                phi_803_ = u32();
                                phi_2899_ = false;
                            }
                            let _e1510 = phi_3253_;
                            let _e1512 = phi_794_;
                            let _e1514 = phi_797_;
                            let _e1516 = phi_799_;
                            let _e1518 = phi_801_;
                            let _e1520 = phi_803_;
                            let _e1522 = phi_2899_;
                            continue;
                            continuing {
                                phi_3116_ = _e1510;
                                phi_793_ = _e1512;
                                phi_796_ = _e1514;
                                phi_798_ = _e1516;
                                phi_800_ = _e1518;
                                phi_802_ = _e1520;
                                phi_3252_ = _e1510;
                                break if !(_e1522);
                            }
                        }
                        let _e1525 = phi_3252_;
                        if _e1525 {
                            break;
                        }
                        let _e1527 = local_10;
                        if (_e1527.member.member.member_3 != 4294967295u) {
                            let _e1533 = (_e257 / 3i);
                            let _e1540 = bitcast<f32>((bitcast<u32>((_e1533 + 127i)) << bitcast<u32>(23i)));
                            let _e1548 = (((_e1527.member.member.member * _e1540) * _e1540) * bitcast<f32>((bitcast<u32>(((_e257 - (2i * _e1533)) + 127i)) << bitcast<u32>(23i))));
                            let _e1550 = select(340282350000000000000000000000000000000f, _e1548, (_e1548 < 340282350000000000000000000000000000000f));
                            phi_2951_ = type_23(select(-340282350000000000000000000000000000000f, _e1550, (_e1550 > -340282350000000000000000000000000000000f)), _e1527.member.member.member_1, _e1527.member.member.member_2, _e1527.member.member.member_3);
                        } else {
                            phi_2951_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1557 = phi_2951_;
                        if _e133 {
                        } else {
                            break;
                        }
                        global_2.member[_e125] = _e1557;
                        let _e1561 = local_11;
                        if _e134 {
                        } else {
                            break;
                        }
                        global_5.member[_e125] = _e1561.member_1;
                        if _e132 {
                        } else {
                            break;
                        }
                        let _e1566 = select(0u, 1u, (_e201 <= _e211));
                        if (_e1566 > 0u) {
                            let _e1568 = (1u < _e93);
                            if _e1568 {
                                if (0u < _e93) {
                                } else {
                                    break;
                                }
                                let _e1572 = atomicAdd((&global_6.member[0u]), _e1566);
                                if ((_e1572 + _e1566) < _e1572) {
                                    if _e1568 {
                                    } else {
                                        break;
                                    }
                                    let _e1577 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1580 = select(0u, 1u, (_e1557.member_3 != 4294967295u));
                        if (_e1580 > 0u) {
                            let _e1582 = (3u < _e93);
                            if _e1582 {
                                if (2u < _e93) {
                                } else {
                                    break;
                                }
                                let _e1586 = atomicAdd((&global_6.member[2u]), _e1580);
                                if ((_e1586 + _e1580) < _e1586) {
                                    if _e1582 {
                                    } else {
                                        break;
                                    }
                                    let _e1591 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1561.member_1 > 0u) {
                            let _e1593 = (5u < _e93);
                            if _e1593 {
                                if (4u < _e93) {
                                } else {
                                    break;
                                }
                                let _e1597 = atomicAdd((&global_6.member[4u]), _e1561.member_1);
                                if ((_e1597 + _e1561.member_1) < _e1597) {
                                    if _e1593 {
                                    } else {
                                        break;
                                    }
                                    let _e1602 = atomicAdd((&global_6.member[5u]), 1u);
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
fn trace_paths_counted_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
